"""Insets: what is too small for a pen, shown larger in a box beside the scene."""

from collections.abc import Iterator, Sequence
from itertools import pairwise
from math import atan2, ceil, cos, floor, hypot, log10, pi, sin, ulp
from typing import NamedTuple

from ..engine.geometry import Vec
from ..engine.sat import AxisTest
from ..engine.shapes import Circle, Polygon, Shape, centroid
from .axis_place import TRACK_PT
from .float_geometry import bounding_box, boxes_overlap, clip_segment, midpoint
from .layout import NARROW_PT, Inset, Layout, limits_around
from .marks import Mark

MIN_SHAPE_PT = 8.0  # a shape whose larger side is shorter than this has an inset
MIN_GAP_PT = 3.0  # a gap or an overlap smaller than this has an inset
MIN_NEEDLE_PT = 1.5  # and the short edge of an outline thinner than this
BOX_PT, GAP_BOX_PT = 96.0, 48.0  # an inset's side; how high that of a gap is
STRIP_PT = 124.0  # the width of the strip of insets beside the scene
ROW_PT = 128.0  # the height of an inset with its caption
HEAD_PT = 40.0  # height of the space above a scene, for a verdict
EVEN_POINTS = 32  # points on half of a circle
DETAIL_PART = 0.5  # largest size of the detail, as a share of the box's side
MIN_FLOAT_STEP_PT, FLOAT_TICK_PT = 8.0, 8.0  # least distance of two floats that are drawn; half of a tick
BRACKET_PT = 4.0, 11.0  # distances from the axis to the ends of a gap's bracket, and to its back

Role = tuple[str, str, Shape]  # "A" or "B", the shape's name, the shape


class _Detail(NamedTuple):
    """A detail too small to see: its name ("" for a gap), its middle, its length, and the test of a gap."""

    name: str
    spot: Vec
    length: float
    test: AxisTest | None = None


def is_too_small(shape: Shape, scale: float) -> bool:
    """Check whether a shape is too small to be seen at `scale` points per scene unit."""
    x0, y0, x1, y1 = shape.bounds
    return max(x1 - x0, y1 - y0) * scale < MIN_SHAPE_PT


def add_insets(layouts: Sequence[Layout], shapes: Sequence[tuple[str, Shape]]) -> list[Layout]:
    """Return layouts of one size with insets in a strip or in a free corner; they still have one size.

    `shapes`: (name, shape) of A and of B.  Each shape, short edge of a thin shape (a needle), or gap that is too small
    to be seen has an inset.
    """
    found = [_details(layout, shapes) for layout in layouts]
    rows = max(map(len, found))
    if not rows:
        return list(layouts)
    both = list(zip(layouts, found, strict=True))
    if rows == 1 and layouts[0].size[0] < NARROW_PT:
        corner = _free_corner([layout for layout, details in both if details], [shape for _, shape in shapes])
        if corner:
            return [each._replace(insets=_insets(each, details, [corner]), strip=False) for each, details in both]
    return [_with_insets(*each, rows) for each in both]


def _free_corner(layouts: Sequence[Layout], shapes: Sequence[Shape]) -> tuple[float, float] | None:
    """Return the upper left corner (scene units) of a box for an inset, in a corner clear of shapes and axes.

    The lower corners come first; None if no corner is free.
    """
    layout = layouts[0]
    (x0, y0, x1, y1), units = layout.limits, layout.units
    wide, high, rim = units(BOX_PT + 14), units(ROW_PT + 6), units(TRACK_PT + 6)
    axes = [place.ends for each in layouts for place in each.places]
    for left, low in (
        (x0, y0),
        (x1 - wide, y0),
        (x1 - wide, y1 - high - units(HEAD_PT)),
        (x0, y1 - high - units(HEAD_PT)),
    ):
        corner = left - rim, low - rim, left + wide + rim, low + high + rim
        clear = not any(boxes_overlap(corner, shape.bounds) for shape in shapes)
        if clear and not any(clip_segment(*p, *q, *corner) for p, q in axes):
            return left + units(7), low + high - units(2)
    return None


def _details(layout: Layout, shapes: Sequence[tuple[str, Shape]]) -> list[_Detail]:
    """Return the details of a layout that are too small to be seen: of the shapes first, then the gaps."""
    details = [detail for name, shape in shapes for detail in _small_details(name, shape, layout.scale)]
    for place, test in zip(layout.places, layout.tests, strict=True):
        if test.gap and abs(test.gap) * layout.scale < MIN_GAP_PT:
            details.append(_Detail("", place.at(test.a.interval.lo), abs(test.gap), test))
    return details


def _with_insets(layout: Layout, details: Sequence[_Detail], rows: int) -> Layout:
    """Return the layout with an inset of each detail, and space for `rows` insets.

    They stand in a strip beside the scene, or below the scene if the canvas is as narrow as a telephone.
    """
    scale = layout.scale
    (x0, y0, x1, y1), (wide, high) = layout.limits, layout.size
    if wide < NARROW_PT:
        in_row = max(1, int(wide // STRIP_PT))
        size = wide, high + ROW_PT * ceil(rows / in_row)
        limits = limits_around(((x0 + x1) / 2, (y0 + y1 - (size[1] - high) / scale) / 2), size, scale)
        corners = [
            (limits[0] + (14 + STRIP_PT * (i % in_row)) / scale, y0 - ROW_PT * (i // in_row) / scale)
            for i in range(rows)
        ]
    else:
        size = wide + STRIP_PT, max(high, round(ROW_PT * rows + 24))
        limits = limits_around(((x0 + x1 + STRIP_PT / scale) / 2, (y0 + y1) / 2), size, scale)
        corners = [(limits[2] - (BOX_PT + 14) / scale, limits[3] - (14 + ROW_PT * i) / scale) for i in range(rows)]
    return layout._replace(limits=limits, size=size, insets=_insets(layout, details, corners))


def _insets(layout: Layout, details: Sequence[_Detail], corners: Sequence[tuple[float, float]]) -> tuple[Inset, ...]:
    """Return an inset of each detail; `corners`: the upper left corners of their boxes, in scene units."""
    found, scale = [], layout.scale
    for (left, top), (name, spot, length, test_of_gap) in zip(corners, details, strict=False):
        box = left, top - (GAP_BOX_PT if test_of_gap else BOX_PT) / scale, left + BOX_PT / scale, top
        found.append(Inset(name, spot, round_down(DETAIL_PART * BOX_PT / (length * scale)), box, test_of_gap))
    return tuple(found)


def _small_details(name: str, shape: Shape, scale: float) -> list[_Detail]:
    """Return a list of the shape's detail that needs an inset: the whole shape, or a needle's short edge; or none."""
    if is_too_small(shape, scale):
        x0, y0, x1, y1 = bounding_box([shape])
        return [_Detail(name, Vec((x0 + x1) / 2, (y0 + y1) / 2), max(x1 - x0, y1 - y0))]
    if isinstance(shape, Circle):
        return []
    ring = [*shape.corners, shape.corners[0]]
    p, q = min(pairwise(ring), key=lambda e: hypot(e[1].x - e[0].x, e[1].y - e[0].y))
    length, middle = hypot(q.x - p.x, q.y - p.y), centroid(shape)
    area = abs(sum(u.x * v.y - v.x * u.y for u, v in pairwise([Vec(c.x - p.x, c.y - p.y) for c in ring]))) / 2
    radius = max(hypot(v.x - middle.x, v.y - middle.y) for v in shape.corners)
    if area / radius * scale > MIN_NEEDLE_PT or length * scale > MIN_SHAPE_PT:
        return []
    return [_Detail(f"{name}'s end", midpoint(p, q), length)]


def round_down(times: float) -> float:
    """Return the largest number of the form 1, 2 or 5 times a power of ten that is not above `times`."""
    power = 10.0 ** floor(log10(times))
    return power * max(step for step in (1, 2, 5) if step * power <= times * 1.0001)


def magnification_text(times: float) -> str:
    """Return a magnification as printed below an inset: "×10,000"."""
    return f"×{times:,.0f}" if times < 1e7 else f"×{times:.0e}".replace("e+0", "e").replace("e+", "e")


def inset_marks(layout: Layout, shapes: Sequence[Role], test: AxisTest | None) -> list[Mark]:
    """Return the marks of the insets that show these shapes, or the gap of `test` if it is given."""
    marks: list[Mark] = []
    for number, inset in enumerate(layout.insets, 1):
        outlines = [(role, name, [*visible_edges(inset, shape)]) for role, name, shape in shapes]
        if inset.test != test or not (inset.test or any(edges for *_, edges in outlines)):
            continue  # this inset shows another test, or a part that this step leaves aside
        x0, y0, x1, y1 = inset.box
        corners = Vec(x0, y0), Vec(x1, y0), Vec(x1, y1), Vec(x0, y1)
        marks.append(Mark("inset", "outline", "guide", corners, number=number, weight="faint"))
        what = inset.name or ("gap" if inset.test and inset.test.gap > 0 else "overlap")
        below = Vec(inset.center.x, y0 - layout.units(9))
        text = f"{what}, {magnification_text(inset.times)}"
        if inset.test and _float_ticks(layout, inset, inset.test):
            text += "\nticks: float64"
            below = Vec(below.x, below.y - layout.units(7))
        marks.append(Mark("inset-name", "label", "ink", (below,), number=number, text=text))
        if inset.test is not None:
            marks += _gap_marks(layout, inset, inset.test, shapes, number)
            continue
        for role, name, edges in outlines:
            if edges:
                ends = tuple(end for edge in edges for end in edge)
                marks.append(Mark("inset-edge", "segment", role, ends, owner=name, number=number))
    return marks


def visible_edges(inset: Inset, shape: Shape) -> Iterator[tuple[Vec, Vec]]:
    """Yield the pieces of a shape's outline seen in an inset's box, magnified, as pairs of ends."""
    for p, q in pairwise(map(inset.at, _outline_points(shape, inset.spot))):
        part = clip_segment(*p, *q, *inset.box)
        if part and part[0] < part[1]:
            yield tuple(Vec(p.x + (q.x - p.x) * t, p.y + (q.y - p.y) * t) for t in part)  # type: ignore[misc]


def _outline_points(shape: Shape, spot: Vec) -> list[Vec]:
    """Return a shape's outline as a closed ring of points; on a circle they are dense near `spot`."""
    if isinstance(shape, Polygon):
        return [*shape.vertices, shape.vertices[0]]
    (x, y), r = shape.center, shape.radius
    toward = atan2(spot.y - y, spot.x - x)
    near = {sign * pi * 10.0 ** (-k / 4) for k in range(49) for sign in (-1, 1)}
    angles = sorted(near | {pi * k / EVEN_POINTS for k in range(-EVEN_POINTS, EVEN_POINTS + 1)})
    return [Vec(x + r * cos(toward + t), y + r * sin(toward + t)) for t in angles]


def a_is_left(test: AxisTest) -> bool:
    """Check whether A's range lies on the lower side of the gap, and B's on the upper side."""
    a, b = test.a.interval, test.b.interval
    return b.lo - a.hi >= a.lo - b.hi


def _float_ticks(layout: Layout, inset: Inset, test: AxisTest) -> tuple[Vec, ...]:
    """Return the lower and the upper end of a tick at each number of float64 on the axis of a gap's inset.

    Points are in scene units; () where the ticks are too dense to be seen.
    """
    end = min(test.a.interval.hi, test.b.interval.hi)  # the end of the left range, where the gap or overlap begins
    step = ulp(end) * inset.times
    if step < layout.units(MIN_FLOAT_STEP_PT):
        return ()
    x0, _, x1, _ = inset.box
    (cx, cy), half = inset.center, test.gap * inset.times / 2
    up, first = layout.units(FLOAT_TICK_PT), cx - half
    spots = [first + k * step for k in range(-100, 101) if x0 < first + k * step < x1]
    return tuple(Vec(x, cy + side * up) for x in spots for side in (-1, 1))


def _gap_marks(layout: Layout, inset: Inset, test: AxisTest, shapes: Sequence[Role], number: int) -> list[Mark]:
    """Return the marks of a gap's inset: the facing ends of both ranges on a level axis, and the gap."""
    x0, _, x1, _ = inset.box
    units, (cx, cy) = layout.units, inset.center
    half = test.gap * inset.times / 2
    marks = [Mark("inset-axis", "segment", "ink", (Vec(x0, cy), Vec(x1, cy)), number=number)]
    if ticks := _float_ticks(layout, inset, test):
        marks.append(Mark("inset-floats", "segment", "ink", ticks, number=number))
    sides = [(x0, cx - half), (cx + half, x1)]
    for (role, name, _), ends in zip(shapes if a_is_left(test) else shapes[::-1], sides, strict=True):
        level = cy + units(TRACK_PT if role == "A" else -TRACK_PT)
        points = tuple(Vec(x, level) for x in ends)
        marks.append(Mark("inset-range", "interval", role, points, owner=name, number=number))
    if half > 0:
        near, far = (cy - units(c) for c in BRACKET_PT)
        bracket = Vec(cx - half, near), Vec(cx - half, far), Vec(cx + half, far), Vec(cx + half, near)
        marks.append(Mark("inset-gap", "bracket", "gap", bracket, number=number))
    else:
        bar = Vec(cx + half, cy), Vec(cx - half, cy)
        marks.append(Mark("inset-gap", "interval", "overlap", bar, number=number))
    return marks
