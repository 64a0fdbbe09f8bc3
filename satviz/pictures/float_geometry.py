"""Geometry in plain float64, as accurate as a drawing needs; every verdict comes from the engine."""

from collections.abc import Iterable, Sequence
from math import cos, pi, sin

from ..engine.axes import GIVEN, Axis, Source
from ..engine.geometry import Interval, Vec
from ..engine.predicates import Point, orient
from ..engine.sat import AxisTest, project
from ..engine.shapes import Circle, Shape

Box = tuple[float, float, float, float]  # x min, y min, x max, y max
_GIVEN = Source(GIVEN)


def point_along(p: Vec, d: Vec, t: float) -> Vec:
    """Return p + t d."""
    return Vec(p.x + t * d.x, p.y + t * d.y)


def midpoint(p: Vec, q: Vec) -> Vec:
    """Return the point half way from p to q."""
    return Vec((p.x + q.x) / 2, (p.y + q.y) / 2)


def mean_point(points: Sequence[Vec]) -> Vec:
    """Return the arithmetic mean of the points."""
    return Vec(sum(p.x for p in points) / len(points), sum(p.y for p in points) / len(points))


def circle_points(center: Vec, radius: float, count: int) -> list[Vec]:
    """Return `count` evenly spaced points of a circle, counter-clockwise from its rightmost point."""
    angles = [k * pi / (count / 2) for k in range(count)]
    return [Vec(center.x + radius * cos(t), center.y + radius * sin(t)) for t in angles]


def bounding_box(shapes: Iterable[Shape]) -> Box:
    """Return the smallest upright box around the shapes."""
    return common_box([s.bounds for s in shapes])


def common_box(boxes: Sequence[Box]) -> Box:
    """Return the smallest upright box around other boxes."""
    return (min(b[0] for b in boxes), min(b[1] for b in boxes), max(b[2] for b in boxes), max(b[3] for b in boxes))


def moved_shape(shape: Shape, move: Vec) -> Shape:
    """Return the shape translated by `move`, rounded to float64: for drawing only."""
    if isinstance(shape, Circle):
        return Circle(point_along(shape.center, move, 1.0), shape.radius)
    return type(shape)([point_along(v, move, 1.0) for v in shape.vertices], shape.labels)


def range_along(shape: Shape, direction: Vec) -> Interval:
    """Return the range of a shape projected on a unit vector: signed distances from the origin."""
    return project(shape, Axis(direction, 1.0, _GIVEN)).interval


def gap_or_overlap(test: AxisTest) -> Interval:
    """Return the interval between a test's two ranges if there is a gap, else the one both cover.

    A shortcut may measure an overlap of ranges that are apart.  Then the interval is the space between them, or, if
    the measured overlap is longer than this, all from the start of one range to the end of the other.
    """
    a, b = test.a.interval, test.b.interval
    if test.gap < 0:
        lo, hi = max(a.lo, b.lo), min(a.hi, b.hi)
        return Interval(min(a.lo, b.lo), max(a.hi, b.hi)) if 0 < lo - hi < -test.gap else Interval(lo, hi)
    return Interval(a.hi, b.lo) if a.hi <= b.lo else Interval(b.hi, a.lo)


def on_opposite_sides(p: Point, q: Point, line: tuple[Point, Point]) -> bool:
    """Check whether p and q lie strictly on different sides of the line through two points."""
    return orient(*line, p) * orient(*line, q) < 0


def segments_cross(s: tuple[Point, Point], t: tuple[Point, Point]) -> bool:
    """Check whether two segments cross in a point inside both."""
    return on_opposite_sides(*t, s) and on_opposite_sides(*s, t)


def crossing_point(s: tuple[Vec, Vec], t: tuple[Vec, Vec]) -> Vec | None:
    """Return the point inside both segments where they cross; None if they do not."""
    if not segments_cross(s, t):
        return None
    (p, q), (u, v) = s, t
    along = Vec(q.x - p.x, q.y - p.y)
    area = along.x * (v.y - u.y) - along.y * (v.x - u.x)
    return point_along(p, along, ((u.x - p.x) * (v.y - u.y) - (u.y - p.y) * (v.x - u.x)) / area)


def boxes_overlap(p: Box, q: Box) -> bool:
    """Check whether two upright boxes share more than their rims."""
    return p[0] < q[2] and q[0] < p[2] and p[1] < q[3] and q[1] < p[3]


def clip_line(
    p: Point, d: Point, box: Box, start: float = -float("inf"), end: float = float("inf")
) -> tuple[float, float]:
    """Return the range of t, within start to end, in which p + t d lies inside an upright box (Liang and Barsky).

    The range is empty (its start above its end) where the line misses the box.  A coordinate
    that does not change along the line is not checked.
    """
    x0, y0, x1, y1 = box
    for step, near, far in ((d[0], x0 - p[0], x1 - p[0]), (d[1], y0 - p[1], y1 - p[1])):
        if step:
            first, last = (near / step, far / step) if step > 0 else (far / step, near / step)
            start, end = max(start, first), min(end, last)
    return start, end


def clip_segment(
    sx: float, sy: float, tx: float, ty: float, x0: float, y0: float, x1: float, y1: float
) -> tuple[float, float] | None:
    """Return the parameters (from, to), 0 at s and 1 at t, of the part of segment st inside a box; None if outside."""
    if max(sx, tx) < x0 or min(sx, tx) > x1 or max(sy, ty) < y0 or min(sy, ty) > y1:
        return None
    start, end = clip_line((sx, sy), (tx - sx, ty - sy), (x0, y0, x1, y1), 0.0, 1.0)
    return (start, end) if start <= end else None


def are_parallel(p: Axis, q: Axis) -> bool:
    """Check whether two axes have one direction, up to the rounding of their normals."""
    return p.normal.x * q.normal.y == p.normal.y * q.normal.x
