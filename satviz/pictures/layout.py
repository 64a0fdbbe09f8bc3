"""Where things go: the limits of a scene, each axis clear of the shapes, each label clear of everything."""

from collections.abc import Iterable, Sequence
from functools import lru_cache
from typing import NamedTuple

from ..engine import number_format
from ..engine.geometry import Vec
from ..engine.sat import AxisTest, Projection
from ..engine.shapes import Circle, Shape
from . import letters
from .marks import Limits
from .theme import style_of

FURTHEST = 2.0**41  # sizes from the origin at which float64 still holds a shape's outline
LONGEST = 30  # letters of a range in one line
# all in points
MAX_WIDTH_PT, MAX_HEIGHT_PT = 500.0, 400.0  # the largest canvas
LEAST_WIDTH, LEAST_HEIGHT = 420.0, 190.0
PAD = 36.0  # all round
NARROW_PAD_PT = 12.0  # to the left and right in a panel beside another
HEAD = 16.0  # and above it all, for a line of words
BRIEF = 24.0  # the width of a label that is a name alone
LABEL_HEIGHT = 18.0  # room for a range's label on the far side of its axis
CLEAR = 34.0  # from the shapes to an axis
BEYOND = 20.0  # an axis runs on past the ranges
ZERO = 45.0  # and to coordinate 0, where that is no further from them
TRACK = 5.5  # A's bar on one side of the axis, B's on the other


def point_along(p: Vec, d: Vec, t: float) -> Vec:
    """p + t d."""
    return Vec(p.x + t * d.x, p.y + t * d.y)


class AxisPlace(NamedTuple):
    """Where an axis is drawn: its direction, the way out from the shapes, the spot of coordinate 0, its ends.

    `unit`: scene units a unit of the axis; not 1, or 0 not where it belongs, where `slid`.
    """

    n: Vec
    out: Vec
    zero: Vec
    lo: float
    hi: float
    track: float  # scene units between the axis and a bar
    unit: float = 1.0
    slid: bool = False

    def at(self, t: float, role: str = "") -> Vec:
        """Coordinate t on the axis, or on A's track (towards the shapes) or B's (away from them)."""
        side = {"A": -self.track, "B": self.track}.get(role, 0.0)
        return point_along(point_along(self.zero, self.n, t * self.unit), self.out, side)


class Inset(NamedTuple):
    """A spot of the scene and how many times as large it is shown, in a box on the canvas (scene units).

    `of` is the shape's name, or "" for a gap on the axis of `test`.
    """

    of: str
    spot: Vec
    times: float
    box: Limits
    test: AxisTest | None = None

    @property
    def center(self) -> Vec:
        """The middle of its box."""
        return Vec((self.box[0] + self.box[2]) / 2, (self.box[1] + self.box[3]) / 2)

    def at(self, p: Vec) -> Vec:
        """Where a point of the scene is shown."""
        middle = self.center
        return Vec(middle.x + (p.x - self.spot.x) * self.times, middle.y + (p.y - self.spot.y) * self.times)


class Layout(NamedTuple):
    """The limits in scene units, the canvas in points, one place for each test, and what is shown larger."""

    limits: Limits
    size: tuple[float, float]
    places: tuple[AxisPlace, ...] = ()
    tests: tuple[AxisTest, ...] = ()
    insets: tuple[Inset, ...] = ()

    @property
    def scale(self) -> float:
        """Points a scene unit."""
        return self.size[0] / (self.limits[2] - self.limits[0])

    @property
    def field(self) -> Limits:
        """The limits without what stands beside the scene."""
        if not self.insets:
            return self.limits
        x0, y0, _, y1 = self.limits
        return x0, y0, min(inset.box[0] for inset in self.insets) - self.units(14), y1

    def units(self, points: float) -> float:
        """A length on the canvas in scene units."""
        return points / self.scale


def bounding_box(shapes: Iterable[Shape]) -> Limits:
    """The smallest upright box around the shapes."""
    boxes = [s.bounds for s in shapes]
    return (min(b[0] for b in boxes), min(b[1] for b in boxes), max(b[2] for b in boxes), max(b[3] for b in boxes))


class Group(NamedTuple):
    """What one picture must have room for: shapes, and the axes that are shown at once.

    `brief`: the ranges are shown without their numbers.
    """

    shapes: Sequence[Shape]
    tests: Sequence[AxisTest] = ()
    brief: bool = False


def arrange(
    groups: Sequence[Group],
    *,
    largest: tuple[float, float] = (MAX_WIDTH_PT, MAX_HEIGHT_PT),
    least: tuple[float, float] = (LEAST_WIDTH, LEAST_HEIGHT),
    pad: float = PAD,
) -> list[Layout]:
    """A layout for each group, all at one scale: limits around the shapes, each axis clear of them and of the others.

    `pad`: points that are kept free to the left and right.

    The room around the shapes is measured in points, which need the scale, which needs
    the room: a few rounds settle it.
    """
    x0, y0, x1, y1 = bounding_box([shape for group in groups for shape in group.shapes])
    size = max(x1 - x0, y1 - y0)
    if not 1e-290 < size < 1e290 or max(map(abs, (x0, y0, x1, y1))) > FURTHEST * size:
        raise ValueError(
            f"a scene {size:.3g} across at ({x0:.3g}, {y0:.3g}) cannot be drawn in float64: "
            "move or scale it first (its trace is exact all the same)"
        )
    words = [[_label_room(group, test) for test in group.tests] for group in groups]
    while True:
        layouts = _arranged(groups, words, largest, least, size, pad)
        if layouts is not None:
            return layouts
        # the room for labels is measured in points: too small a canvas is laid out larger and shown smaller
        largest = largest[0] * 1.25, largest[1] * 1.25


def range_label(name: str, text: str) -> str:
    """A range as it stands at its bar; a long one in two lines."""
    label = f"{name} {text}"
    return label.replace(" + [", " +\n[") if len(label) > LONGEST else label


def _label_room(group: Group, test: AxisTest) -> float:
    """How wide a label of the test's ranges is, in points."""
    if group.brief:
        return BRIEF
    told = number_format.of_tests(group.shapes, [test])
    return min(max(text_size(range_label("B2", text))[0] for text in told.ranges(test)), MAX_WIDTH_PT / 3)


def _arranged(
    groups: Sequence[Group],
    words: Sequence[Sequence[float]],
    largest: tuple[float, float],
    least: tuple[float, float],
    size: float,
    pad: float,
) -> list[Layout] | None:
    """The layouts on canvases of that size at most; None if the shapes would be lost on them."""
    scale = start = min(largest) / size / 2
    for _ in range(8):
        places = [_places(group, wide, scale) for group, wide in zip(groups, words, strict=True)]
        boxes = [_room(*each, scale, PAD - pad) for each in zip(groups, places, words, strict=True)]
        room = largest[0] - 2 * pad, largest[1] - 2 * PAD - HEAD
        before, scale = scale, min(most / (box[i + 2] - box[i]) for box in boxes for i, most in enumerate(room))
        if not scale > start / 2.5:
            return None
        if abs(scale - before) < 1e-3 * scale:
            break
    found = []
    for group, (x0, y0, x1, y1), there in zip(groups, boxes, places, strict=True):
        width = round(min(largest[0], max(least[0], (x1 - x0) * scale + 2 * pad)))
        head = HEAD if there else 0.0
        height = round(min(largest[1], max(least[1], (y1 - y0) * scale + 2 * PAD + head)))
        limits = around(((x0 + x1) / 2, (y0 + y1 + head / scale) / 2), (width, height), scale)
        found.append(Layout(limits, (width, height), tuple(there), tuple(group.tests)))
    return found


def around(center: tuple[float, float], size: tuple[float, float], scale: float) -> Limits:
    """The limits of a canvas of that size (points) around a spot of the scene."""
    (x, y), (w, h) = center, (side / scale / 2 for side in size)
    return x - w, y - h, x + w, y + h


def centered_layout(layout: Layout, size: tuple[float, float]) -> Layout:
    """The same in the middle of a canvas of that size."""
    x0, y0, x1, y1 = layout.limits
    return layout._replace(limits=around(((x0 + x1) / 2, (y0 + y1) / 2), size, layout.scale), size=size)


def _room(group: Group, places: Sequence[AxisPlace], words: Sequence[float], scale: float, beside: float) -> Limits:
    """The box of the shapes, the axes, and the labels on their far sides; a normal needs points beside its shape."""
    x0, y0, x1, y1 = bounding_box(group.shapes)
    if any(test.source.shape for test in group.tests):
        x0, x1 = x0 - beside / scale, x1 + beside / scale
    ends = [place.at(t, role) for place in places for t in (place.lo, place.hi) for role in "AB"]
    for place, wide in zip(places, words, strict=True):
        for part in (0.15, 0.85):
            spot = place.at(place.lo + part * (place.hi - place.lo), "B")
            ends.append(Vec(spot.x + place.out.x * wide / scale, spot.y + place.out.y * LABEL_HEIGHT / scale))
    xs, ys = [x0, x1, *(p.x for p in ends)], [y0, y1, *(p.y for p in ends)]
    return min(xs), min(ys), max(xs), max(ys)


def _places(group: Group, words: Sequence[float], scale: float) -> list[AxisPlace]:
    places: list[AxisPlace] = []
    for test, wide in zip(group.tests, words, strict=True):
        sides = [_place(group.shapes, test, scale, side, wide) for side in (-1, 1)]
        places.append(min(sides, key=lambda p: (_crossings(p, places), _awkward(group.shapes, test, p))))
    return places


def _place(shapes: Sequence[Shape], test: AxisTest, scale: float, side: int, wide: float = 0.0) -> AxisPlace:
    """The axis on one side of the shapes, with room for A's label (so many points wide) between."""
    n = test.axis.direction
    out = Vec(-n.y * side, n.x * side)
    far = max(_reach(shape, out) for shape in shapes)
    ranges = test.a.interval, test.b.interval
    lo, hi = min(r.lo for r in ranges), max(r.hi for r in ranges)
    unit, slid = _unit_and_slide(shapes, n, lo, hi)
    points = scale * unit
    if 0 < lo < ZERO / points:  # 0 is shown where it is near
        lo = 0.0
    if -ZERO / points < hi < 0:
        hi = 0.0
    label = abs(out.x) * wide + abs(out.y) * LABEL_HEIGHT + TRACK + 7.0
    away = far + max(CLEAR, label if wide else 0.0) / scale
    zero = point_along(Vec(out.x * away, out.y * away), n, slid)
    return AxisPlace(n, out, zero, lo - BEYOND / points, hi + BEYOND / points, TRACK / scale, unit, bool(slid))


def _unit_and_slide(shapes: Sequence[Shape], n: Vec, lo: float, hi: float) -> tuple[float, float]:
    """Scene units a unit of the axis, and how far its 0 is slid: 1 and 0 where the ranges lie about the shapes.

    What a shortcut measures may lie far from them, or take much more room; on their scale they would be lost.
    """
    x0, y0, x1, y1 = bounding_box(shapes)
    size = max(x1 - x0, y1 - y0)
    far, near = (max(_reach(shape, d) for shape in shapes) for d in (n, Vec(-n.x, -n.y)))
    if max(-near - lo, hi - far) <= size:
        return 1.0, 0.0
    unit = min(1.0, 2 * size / (hi - lo))
    return unit, (far - near) / 2 - (lo + (hi - lo) / 2) * unit


def place_axis_within(
    layout: Layout, shapes: Sequence[Shape], test: AxisTest, last_out: Vec | None = None
) -> AxisPlace:
    """An axis clear of the shapes on limits that are given: on the side where it fits, rather where it was before."""
    x0, y0, x1, y1 = layout.limits
    rim = layout.units(BEYOND)

    def outside(p: Vec) -> float:
        return max(x0 + rim - p.x, p.x - x1 + rim, y0 + rim - p.y, p.y - y1 + rim, 0.0)

    def lacking(place: AxisPlace) -> float:
        ends = (r.lo for r in (test.a.interval, test.b.interval)), (r.hi for r in (test.a.interval, test.b.interval))
        return sum(outside(place.at(t)) for t in (min(ends[0]), max(ends[1])))

    places = [_place(shapes, test, layout.scale, side) for side in (-1, 1)]
    if last_out is not None:
        places.sort(key=lambda p: -(p.out.x * last_out.x + p.out.y * last_out.y))
    else:
        places.sort(key=lambda p: _awkward(shapes, test, p))
    best = min(places, key=lacking)
    step = layout.units(8.0)
    for _ in range(60):  # no room on either side: nearer, over the shapes if it must be
        nearer = best._replace(zero=point_along(best.zero, best.out, -step))
        if lacking(nearer) >= lacking(best):
            break
        best = nearer
    return best


def _reach(shape: Shape, out: Vec) -> float:
    if isinstance(shape, Circle):
        return shape.center.x * out.x + shape.center.y * out.y + shape.radius
    return max(v.x * out.x + v.y * out.y for v in shape.corners)


def _awkward(shapes: Sequence[Shape], test: AxisTest, place: AxisPlace) -> float:
    """How little one likes an axis there: it should not widen the scene much, lie near the shape
    whose edge it comes from (so that those points drop past nothing), and rather below or left.
    """
    x0, y0, x1, y1 = bounding_box(shapes)
    ends = place.at(place.lo), place.at(place.hi)
    xs, ys = [x0, x1, *(p.x for p in ends)], [y0, y1, *(p.y for p in ends)]
    size = max(x1 - x0, y1 - y0)
    area = (max(xs) - min(xs)) / size * ((max(ys) - min(ys)) / size)
    away = 0.0
    if test.source.shape:
        own, other = (test.a, test.b) if test.source.shape == "A" else (test.b, test.a)
        away = (_height(other, place.out) - _height(own, place.out)) / size
    above = place.out.y > 1e-9 or (abs(place.out.y) <= 1e-9 and place.out.x > 0)
    return area + away + 0.6 * above


def _height(side: Projection, out: Vec) -> float:
    return sum(p.x * out.x + p.y * out.y for p in side.points) / len(side.points)


def _crossings(place: AxisPlace, others: Sequence[AxisPlace]) -> int:
    mine = place.at(place.lo, "B"), place.at(place.hi, "B")
    return sum(_segments_meet(mine, (o.at(o.lo, "B"), o.at(o.hi, "B"))) for o in others)


def _segments_meet(s: tuple[Vec, Vec], t: tuple[Vec, Vec]) -> bool:
    def side(p: Vec, q: Vec, r: Vec) -> float:
        return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)

    return side(*s, t[0]) * side(*s, t[1]) < 0 and side(*t, s[0]) * side(*t, s[1]) < 0


@lru_cache(maxsize=4096)
def text_size(text: str, weight: str = "plain") -> tuple[float, float]:
    """Width and height of a label in points."""
    letter = style_of("label", "", weight)
    lines = text.split("\n")
    widest = max(letters.text_width(line, bold=letter.bold) for line in lines)
    return widest * letter.size, len(lines) * letter.size * 1.2


def clip_segment(
    sx: float, sy: float, tx: float, ty: float, x0: float, y0: float, x1: float, y1: float
) -> tuple[float, float] | None:
    """The part (from, to) of a segment inside an upright box, 0 to 1, or None.  (Liang and Barsky's clipping.)"""
    if max(sx, tx) < x0 or min(sx, tx) > x1 or max(sy, ty) < y0 or min(sy, ty) > y1:
        return None
    start, end = 0.0, 1.0
    for d, near, far in ((tx - sx, x0 - sx, x1 - sx), (ty - sy, y0 - sy, y1 - sy)):
        if d == 0:
            continue
        first, last = (near / d, far / d) if d > 0 else (far / d, near / d)
        start, end = max(start, first), min(end, last)
        if start > end:
            return None
    return start, end
