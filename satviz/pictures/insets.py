"""What is too small for the pen, shown larger in a box beside the picture."""

from collections.abc import Iterator, Sequence
from itertools import pairwise
from math import atan2, cos, floor, hypot, log10, pi, sin

from ..engine.geometry import Vec
from ..engine.sat import AxisTest
from ..engine.shapes import Circle, Polygon, Shape, centroid
from .layout import Inset, Layout, around, bounding_box, clip_segment

# all in points
MIN_SHAPE_PT = 8.0  # a shape smaller than this is shown larger, and so is a gap smaller than
LEAST_GAP = 3.0
THINNEST = 1.5  # and the end of a needle thinner than this
BOX = 96.0  # an inset's side
STRIP = 124.0  # what stands beside the picture for them
EACH = 128.0  # an inset's height with its caption
FILLED = 0.5  # how much of its box the small thing takes


def edges_in(inset: Inset, shape: Shape) -> Iterator[tuple[Vec, Vec]]:
    """What is seen of a shape's outline in the box."""
    for p, q in pairwise(map(inset.at, _outline(shape, inset.spot))):
        part = clip_segment(*p, *q, *inset.box)
        if part and part[0] < part[1]:
            yield tuple(Vec(p.x + (q.x - p.x) * t, p.y + (q.y - p.y) * t) for t in part)  # type: ignore[misc]


def _outline(shape: Shape, spot: Vec) -> list[Vec]:
    """A closed ring of points; a circle's are close together where it passes near the spot."""
    if isinstance(shape, Polygon):
        return [*shape.vertices, shape.vertices[0]]
    (x, y), r = shape.center, shape.radius
    toward = atan2(spot.y - y, spot.x - x)
    turns = sorted({sign * pi * 10.0 ** (-k / 4) for k in range(49) for sign in (-1, 1)} | {0.0})
    return [Vec(x + r * cos(toward + t), y + r * sin(toward + t)) for t in turns]


def small(shape: Shape, scale: float) -> bool:
    """Is it too small to be seen, at so many points a unit?"""
    x0, y0, x1, y1 = shape.bounds
    return max(x1 - x0, y1 - y0) * scale < MIN_SHAPE_PT


def with_insets(layout: Layout, shapes: Sequence[tuple[str, Shape]]) -> Layout:
    """The layout, and beside it a box for each shape, needle's end or gap that the pen is too coarse for."""
    scale = layout.scale
    wanted: list[Wanted] = [found for name, shape in shapes for found in _of_shape(name, shape, scale)]
    for place, test in zip(layout.places, layout.tests, strict=True):
        if test.gap and abs(test.gap) * scale < LEAST_GAP:
            wanted.append(("", place.at(test.a.interval.lo), abs(test.gap), test))
    if not wanted:
        return layout
    size = layout.size[0] + STRIP, max(layout.size[1], round(EACH * len(wanted) + 24))
    x0, y0, x1, y1 = layout.limits
    limits = around(((x0 + x1 + STRIP / scale) / 2, (y0 + y1) / 2), size, scale)
    found = []
    for i, (name, spot, length, tested) in enumerate(wanted):
        left, top = limits[2] - (BOX + 14) / scale, limits[3] - (14 + EACH * i) / scale
        box = left, top - BOX / scale, left + BOX / scale, top
        found.append(Inset(name, spot, _round(FILLED * BOX / (length * scale)), box, tested))
    return layout._replace(limits=limits, size=size, insets=tuple(found))


Wanted = tuple[str, Vec, float, AxisTest | None]  # of what, where, how long


def _of_shape(name: str, shape: Shape, scale: float) -> list[Wanted]:
    if small(shape, scale):
        x0, y0, x1, y1 = bounding_box([shape])
        return [(name, Vec((x0 + x1) / 2, (y0 + y1) / 2), max(x1 - x0, y1 - y0), None)]
    if isinstance(shape, Circle):
        return []
    ring = [*shape.corners, shape.corners[0]]
    p, q = min(pairwise(ring), key=lambda e: hypot(e[1].x - e[0].x, e[1].y - e[0].y))
    length, middle = hypot(q.x - p.x, q.y - p.y), centroid(shape)
    area = abs(sum(u.x * v.y - v.x * u.y for u, v in pairwise([Vec(c.x - p.x, c.y - p.y) for c in ring]))) / 2
    reach = max(hypot(v.x - middle.x, v.y - middle.y) for v in shape.corners)
    if area / reach * scale > THINNEST or length * scale > MIN_SHAPE_PT:
        return []
    return [(f"{name}'s end", Vec((p.x + q.x) / 2, (p.y + q.y) / 2), length, None)]


def _round(times: float) -> float:
    """The round number (1, 2 or 5 times a power of ten) below."""
    power = 10.0 ** floor(log10(times))
    return power * max(step for step in (1, 2, 5) if step * power <= times * 1.0001)


def in_words(times: float) -> str:
    """ "×10,000"."""
    return f"×{times:,.0f}" if times < 1e7 else f"×{times:.0e}".replace("e+0", "e").replace("e+", "e")
