"""Other methods than SAT in floats: corners, edges, circles, distances; and shortcuts of failing cases."""

from collections.abc import Callable, Sequence
from math import dist, hypot

from ..engine.axes import Axis, Choice, centers, edge_normals
from ..engine.geometry import APART, OVERLAPPING, Relation, Vec, relation_of_gap
from ..engine.relate import relate
from ..engine.sat import AxisTest, Projection, project
from ..engine.shapes import Shape
from ..engine.shortcut import Shortcut
from ..engine.trace import record
from ..scenes.failing.saved_work import corner_tests
from ..scenes.failing.wrong_steps import measured_test
from ..scenes.shape_tools import vertex_mean
from .written import Middle, Ring, Written, ends, listed


def by_shortcut(shortcut: Shortcut, a: Shape, b: Shape) -> tuple[Relation, Vec | None]:
    """Return what a shortcut claims for a pair."""
    trace = record(a, b, axes=shortcut, every_axis=True)
    return trace.claim, trace.push


def push_along_centers(a: Shape, b: Shape, tests: Sequence[AxisTest]) -> Vec:
    """Return a push of B by the depth along the line from A's vertex mean to B's; along x where both are one point."""
    depth, (px, py), (qx, qy) = -max(test.gap for test in tests), vertex_mean(a), vertex_mean(b)
    length = hypot(qx - px, qy - py)
    return Vec((qx - px) / length * depth, (qy - py) / length * depth) if length else Vec(depth, 0.0)


def middle_inside(a: Shape, b: Shape) -> tuple[Relation, Vec | None]:
    """Return OVERLAPPING if the middle of one convex polygon lies in the other."""
    spots = (vertex_mean(a), b), (vertex_mean(b), a)
    return (OVERLAPPING if min(_outside(*each) for each in spots) <= 0 else APART), None


def corners_in(owner: str, a: Shape, b: Shape) -> tuple[Relation, None]:
    """Return OVERLAPPING if a corner of the other shape lies in A or B, as `owner` says."""
    gaps = [test.gap for test in corner_tests(a, b) if test.axis.source.shape == owner]
    return (OVERLAPPING if min(gaps) <= 0 else APART), None


def first_corner_in(a: Shape, b: Shape) -> tuple[Relation, None]:
    """Return OVERLAPPING if the first corner of one convex polygon lies in the other."""
    spots = ((a.vertices or a.core)[0], b), ((b.vertices or b.core)[0], a)
    return (OVERLAPPING if min(_outside(*each) for each in spots) <= 0 else APART), None


def with_circle(gap_of: Callable[[Shape, Vec, float], float], a: Shape, b: Shape) -> tuple[Relation, None]:
    """Return the relation that `gap_of` (polygon, center, radius) claims by its sign; ValueError for other pairs."""
    if a.core_is_point == b.core_is_point:
        raise ValueError("this method compares a circle with a convex polygon")
    shape, circle = (a, b) if b.core_is_point else (b, a)
    gap = gap_of(shape, circle.core[0], circle.radius)
    return relation_of_gap(gap), None


def nearest_corner(shape: Shape, center: Vec, radius: float) -> float:
    """Return how far the nearest corner of a polygon is from a circle, less than 0 inside."""
    return min(dist(vertex, center) for vertex in shape.vertices) - radius


def center_outside(shape: Shape, center: Vec, radius: float) -> float:
    """Return how far the center lies outside the polygon, else 0 or less."""
    return _outside(center, shape)


def corner_or_center(shape: Shape, center: Vec, radius: float) -> float:
    """Return the smaller of `nearest_corner` and `center_outside`: either below 0 is a hit."""
    return min(nearest_corner(shape, center, radius), _outside(center, shape))


def box_and_circle(shape: Shape, center: Vec, radius: float) -> float:
    """Return the gap between the polygon's bounding box and the circle."""
    x0, y0, x1, y1 = shape.bounds
    return hypot(max(x0 - center.x, 0.0, center.x - x1), max(y0 - center.y, 0.0, center.y - y1)) - radius


def raw_radius(shape: Shape, center: Vec, radius: float) -> float:
    """Return the largest gap on edge normals that are not of length 1, from which the radius is subtracted unscaled."""
    ranges = [(ends(shape.vertices, n), ends([center], n).lo) for n in listed(shape.vertices, ())]
    return max(max(at - radius - on.hi, on.lo - at - radius) for on, at in ranges)


def rims_meet(a: Shape, b: Shape) -> tuple[Relation, None]:
    """Return OVERLAPPING if the rims of two circles meet; ValueError for other shapes."""
    away = dist(*_centers(a, b))
    return (OVERLAPPING if abs(a.radius - b.radius) <= away <= a.radius + b.radius else APART), None


def edges_cross(strict: bool, a: Shape, b: Shape) -> tuple[Relation, None]:
    """Return OVERLAPPING if two edges cross by the orientations of their ends.

    `strict`: three collinear points decide nothing; otherwise they count as clockwise.
    """

    def side(p: Vec, q: Vec, r: Vec) -> int:
        """Return 1 if p, q, r are counter-clockwise, -1 if clockwise; if collinear, 0 if `strict`, else -1."""
        size = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)
        return (size > 0) - (size < 0 if strict else size <= 0)

    if not (a.vertices and b.vertices):
        raise ValueError("a circle has no edges")
    edges_of_a, edges_of_b = (tuple(zip(ring, (*ring[1:], *ring[:1]))) for ring in (a.vertices, b.vertices))
    crossed = any(
        side(p, r, s) * side(q, r, s) < 0 and side(p, q, r) * side(p, q, s) < 0
        for p, q in edges_of_a
        for r, s in edges_of_b
    )
    return (OVERLAPPING if crossed else APART), None


def squared_distance(a: Shape, b: Shape) -> tuple[Relation, None]:
    """Return the relation of two circles as claimed if the squared distance is compared with the sum of the radii."""
    (ax, ay), (bx, by) = _centers(a, b)
    gap = (bx - ax) ** 2 + (by - ay) ** 2 - a.radius - b.radius
    return relation_of_gap(gap), None


def normals_and_centers(a: Shape, b: Shape) -> Choice:
    """Return the edge normals and the line between the centers."""
    return Choice((*edge_normals(a, b).axes, *centers(a, b).axes))


def _centers(a: Shape, b: Shape) -> tuple[Vec, Vec]:
    """Return the centers of two circles; ValueError for other shapes."""
    if not (a.core_is_point and b.core_is_point):
        raise ValueError("no two circles")
    return a.core[0], b.core[0]


def _outside(spot: Vec, shape: Shape) -> float:
    """Return how far a point lies outside a convex polygon, in units of the edges' lengths; 0 or less inside."""
    landings = [(ends(shape.vertices, n), ends([spot], n).lo) for n in listed(shape.vertices, ())]
    return max(max(at - on.hi, on.lo - at) for on, at in landings)


def outward_from_each_middle(a: Shape, b: Shape, axis: Axis) -> AxisTest:
    """Return the test of an edge normal that points, for each shape separately, away from its own vertex mean."""
    start, n = (a if axis.source.shape == "A" else b).vertices[axis.source.ids[0]], axis.direction

    def project_outward(shape: Shape) -> Projection:
        """Return the projection of a shape on the normal or its opposite."""
        middle, points = vertex_mean(shape), project(shape, axis).points
        sign = -1 if (middle.x - start.x) * n.x + (middle.y - start.y) * n.y > 0 else 1
        return Projection(points, tuple(sign * (p.x * n.x + p.y * n.y) for p in points))

    return measured_test(axis, project_outward(a), project_outward(b))


def reversed_verdict(a: Shape, b: Shape) -> tuple[Relation, None]:
    """Return APART for shapes that meet, and OVERLAPPING for those that are apart."""
    return (OVERLAPPING if relate(a, b) is APART else APART), None


def within_reach(middle: Middle, reach: Callable[[Ring, Ring], float], a: Shape, b: Shape) -> tuple[Relation, None]:
    """Return OVERLAPPING if the distance of both middles is at most `reach` of both rings, else APART.

    `middle`, `reach`: functions of the rings of vertices (of a circle, its center).
    """
    p, q = a.vertices or a.core, b.vertices or b.core
    return (OVERLAPPING if dist(middle(p), middle(q)) <= reach(p, q) else APART), None


def beyond_reach(
    middle: Middle, reach: Callable[[Ring, Ring], float], a: Shape, b: Shape
) -> tuple[Relation, Vec | None]:
    """Return APART where the middles are further apart than `reach` of both rings, else the right answer and push."""
    p, q = a.vertices or a.core, b.vertices or b.core
    if dist(middle(p), middle(q)) > reach(p, q):
        return APART, None
    if a.is_convex and b.is_convex and a.vertices and b.vertices:
        return Written()(a, b)
    trace = record(a, b)
    return trace.relation, trace.mtv
