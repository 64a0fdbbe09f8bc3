"""Where things go: the limits of a scene, each axis clear of the shapes, each label clear of everything."""

from collections.abc import Iterable, Sequence
from functools import cache, lru_cache
from math import cos, hypot, pi, sin
from typing import NamedTuple

from .. import telling
from ..geometry import Vec
from ..sat import AxisTest, Projection
from ..shapes import Circle, Shape
from .marks import Limits
from .theme import text_size

# all in points
WIDTH, HEIGHT = 500.0, 400.0  # the largest canvas
LEAST_WIDTH, LEAST_HEIGHT = 300.0, 190.0
PAD = 36.0  # all round
LABEL_HEIGHT = 18.0  # room for a range's label on the far side of its axis
CLEAR = 34.0  # from the shapes to an axis
BEYOND = 20.0  # an axis runs on past the ranges
TRACK = 5.5  # A's bar on one side of the axis, B's on the other
RIM = 4.0


def moved(p: Vec, d: Vec, t: float) -> Vec:
    """p + t d."""
    return Vec(p.x + t * d.x, p.y + t * d.y)


class AxisPlace(NamedTuple):
    """Where an axis is drawn: its direction, the way out from the shapes, the spot of coordinate 0, its ends."""

    n: Vec
    out: Vec
    zero: Vec
    lo: float
    hi: float
    track: float  # scene units between the axis and a bar

    def at(self, t: float, role: str = "") -> Vec:
        """Coordinate t on the axis, or on A's track (towards the shapes) or B's (away from them)."""
        side = {"A": -self.track, "B": self.track}.get(role, 0.0)
        return moved(moved(self.zero, self.n, t), self.out, side)


class Layout(NamedTuple):
    """The limits in scene units, the canvas in points, and one place for each test."""

    limits: Limits
    size: tuple[float, float]
    places: tuple[AxisPlace, ...]

    @property
    def scale(self) -> float:
        return self.size[0] / (self.limits[2] - self.limits[0])

    def units(self, points: float) -> float:
        return points / self.scale


def box_of(shapes: Iterable[Shape]) -> Limits:
    """The smallest upright box around the shapes."""
    boxes = [s.bounds for s in shapes]
    return (min(b[0] for b in boxes), min(b[1] for b in boxes), max(b[2] for b in boxes), max(b[3] for b in boxes))


def arrange(
    shapes: Sequence[Shape],
    tests: Sequence[AxisTest],
    *,
    together: bool = False,
    largest: tuple[float, float] = (WIDTH, HEIGHT),
) -> Layout:
    """Fix the limits for the whole scene and put each axis clear of all shapes.

    `together`: the axes are shown at once, so they also keep off each other.  The
    room around the shapes is measured in points, which need the scale, which needs
    the room: a few rounds settle it.
    """
    x0, y0, x1, y1 = box_of(shapes)
    size = max(x1 - x0, y1 - y0)
    if not 1e-290 < size < 1e290 or max(map(abs, (x0, y0, x1, y1))) > 1e10 * size:
        raise ValueError(
            f"a scene {size:.3g} across at ({x0:.3g}, {y0:.3g}) cannot be drawn in float64: "
            "move or scale it first (its trace is exact all the same)"
        )
    scale = largest[0] / size / 2
    words = [text_box(f"B {telling.interval(r.interval)}")[0] for test in tests for r in (test.a, test.b)]
    label = min(max(words, default=0.0), 110.0)
    for _ in range(6):
        places = _places(shapes, tests, scale, together)
        ends = [place.at(t, role) for place in places for t in (place.lo, place.hi) for role in "AB"]
        for place in places:
            for part in (0.15, 0.85):
                spot = place.at(place.lo + part * (place.hi - place.lo), "B")
                ends.append(Vec(spot.x + place.out.x * label / scale, spot.y + place.out.y * LABEL_HEIGHT / scale))
        xs, ys = [x0, x1, *(p.x for p in ends)], [y0, y1, *(p.y for p in ends)]
        box = min(xs), min(ys), max(xs), max(ys)
        room = [(most - 2 * PAD) / (box[i + 2] - box[i]) for i, most in enumerate(largest)]
        scale = min(room)
    width = min(largest[0], max(LEAST_WIDTH, (box[2] - box[0]) * scale + 2 * PAD))
    height = min(largest[1], max(LEAST_HEIGHT, (box[3] - box[1]) * scale + 2 * PAD))
    width, height = round(width), round(height)
    cx, cy = (box[0] + box[2]) / 2, (box[1] + box[3]) / 2
    half_w, half_h = width / scale / 2, height / scale / 2
    return Layout((cx - half_w, cy - half_h, cx + half_w, cy + half_h), (width, height), tuple(places))


def _places(shapes: Sequence[Shape], tests: Sequence[AxisTest], scale: float, together: bool) -> list[AxisPlace]:
    places: list[AxisPlace] = []
    for test in tests:
        sides = [_place(shapes, test, scale, side) for side in (-1, 1)]
        others = places if together else []
        places.append(min(sides, key=lambda p: (_crossings(p, others), _awkward(shapes, test, p))))
    return places


def _place(shapes: Sequence[Shape], test: AxisTest, scale: float, side: int) -> AxisPlace:
    n = test.axis.direction
    out = Vec(-n.y * side, n.x * side)
    far = max(_reach(shape, out) for shape in shapes)
    ranges = test.a.interval, test.b.interval
    away = far + CLEAR / scale
    return AxisPlace(
        n,
        out,
        Vec(out.x * away, out.y * away),
        min(r.lo for r in ranges) - BEYOND / scale,
        max(r.hi for r in ranges) + BEYOND / scale,
        TRACK / scale,
    )


def _reach(shape: Shape, out: Vec) -> float:
    if isinstance(shape, Circle):
        return shape.center.x * out.x + shape.center.y * out.y + shape.radius
    return max(v.x * out.x + v.y * out.y for v in shape.corners)


def _awkward(shapes: Sequence[Shape], test: AxisTest, place: AxisPlace) -> float:
    """How little one likes an axis there: it should not widen the scene much, lie near the shape
    whose edge it comes from (so that those points drop past nothing), and rather below or left.
    """
    x0, y0, x1, y1 = box_of(shapes)
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


@cache
def _font():
    """matplotlib's own copy of the font, asked for widths only."""
    import matplotlib
    from matplotlib.ft2font import FT2Font

    font = FT2Font(matplotlib.get_data_path() + "/fonts/ttf/DejaVuSans.ttf")
    font.set_size(10, 72)
    return font


@lru_cache(maxsize=4096)
def _advance(char: str) -> float:
    """A letter's width as a part of the text size; one the font lacks is taken for a full square."""
    from matplotlib.ft2font import LoadFlags

    if not _font().get_char_index(ord(char)):
        return 1.0
    return _font().load_char(ord(char), LoadFlags.NO_HINTING).linearHoriAdvance / 655360


def text_box(text: str, weight: str = "plain") -> tuple[float, float]:
    """Width and height of a label in points."""
    size = text_size(weight)
    lines = text.split("\n")
    return max(sum(map(_advance, line)) for line in lines) * size, len(lines) * size * 1.2


class Request(NamedTuple):
    """A label that wants a place near its anchor (scene units), rather towards `prefer` than elsewhere.

    `along`: other anchors that serve nearly as well, such as the rest of a bar.
    """

    id: str
    text: str
    role: str
    anchor: Vec
    along: tuple[Vec, ...] = ()
    prefer: Vec = Vec(0.0, 1.0)
    weight: str = "plain"
    inside: bool = False  # centred on an anchor if that is clear
    optional: bool = False  # leave it out rather than run it over something
    far: bool = False  # anywhere on the canvas will do


Box = tuple[float, float, float, float]
DISTANCES = (3.0, 7.0, 12.0, 18.0, 26.0, 36.0, 50.0, 70.0, 95.0, 125.0)
DIRECTIONS = tuple(Vec(cos(k * pi / 8), sin(k * pi / 8)) for k in range(16))


class Board:
    """Places labels one by one, each at the nearest spot clear of strokes, dots, labels and the rim."""

    def __init__(self, layout: Layout) -> None:
        self.layout = layout
        self.strokes: list[tuple[float, float, float, float, float]] = []  # x, y, x, y, cost of crossing it
        self.boxes: list[Box] = []

    def stroke(self, p: Vec, q: Vec, cost: float) -> None:
        self.strokes.append((*self._points(p), *self._points(q), cost))

    def dot(self, p: Vec, radius: float) -> None:
        x, y = self._points(p)
        self.boxes.append((x - radius, y - radius, x + radius, y + radius))

    def _points(self, p: Vec) -> tuple[float, float]:
        x0, y0, _, _ = self.layout.limits
        scale = self.layout.scale
        return (p.x - x0) * scale, (p.y - y0) * scale

    def place(self, request: Request) -> Vec | None:
        """The label's centre in scene units, or None for an optional one that finds no clear spot."""
        w, h = text_box(request.text, request.weight)
        best, found = float("inf"), self._points(request.anchor)
        for spot, penalty in self._spots(request, w / 2, h / 2):
            if penalty >= best:
                break
            cost = penalty + self._cost(spot, w / 2 + 2, h / 2 + 1)
            if cost < best:
                best, found = cost, spot
        if request.optional and best >= 300:
            return None
        cx, cy = found
        self.boxes.append((cx - w / 2 - 2, cy - h / 2 - 1, cx + w / 2 + 2, cy + h / 2 + 1))
        x0, y0, _, _ = self.layout.limits
        return Vec(x0 + cx / self.layout.scale, y0 + cy / self.layout.scale)

    def _spots(self, request: Request, w: float, h: float):
        """Candidate centres in points with what each costs by itself, cheapest first."""
        x, y = self._points(request.anchor)
        if request.inside:
            yield (x, y), 0.0
            for rank, anchor in enumerate(request.along, 1):
                yield self._points(anchor), rank / 8
        size = hypot(*request.prefer) or 1.0
        toward = Vec(request.prefer.x / size, request.prefer.y / size)
        spots = []
        for rank, anchor in enumerate((request.anchor, *request.along)):
            px, py = self._points(anchor)
            for distance in DISTANCES:
                for u in (toward, *DIRECTIONS):
                    turn = 1 - (u.x * toward.x + u.y * toward.y)
                    penalty = distance + turn * (1 if request.far else 9) + rank
                    spots.append((penalty, (px + u.x * (w + distance), py + u.y * (h + distance))))
        if request.far:
            width, height = self.layout.size
            for i in range(13):
                for j in range(13):
                    spot = RIM + w + (width - 2 * (RIM + w)) * i / 12, RIM + h + (height - 2 * (RIM + h)) * j / 12
                    spots.append((60 + hypot(spot[0] - x, spot[1] - y) / 10, spot))
        spots.sort(key=lambda s: s[0])
        for penalty, spot in spots:
            yield spot, penalty

    def _cost(self, spot: tuple[float, float], w: float, h: float) -> float:
        cx, cy = spot
        x0, y0, x1, y1 = cx - w, cy - h, cx + w, cy + h
        width, height = self.layout.size
        cost = 0.0 if x0 >= RIM and y0 >= RIM and x1 <= width - RIM and y1 <= height - RIM else 1e5
        for bx0, by0, bx1, by1 in self.boxes:
            if x0 < bx1 and bx0 < x1 and y0 < by1 and by0 < y1:
                cost += 1e4
        for sx, sy, tx, ty, price in self.strokes:
            if clipped(sx, sy, tx, ty, x0, y0, x1, y1):
                cost += price
        return cost


def clipped(
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
