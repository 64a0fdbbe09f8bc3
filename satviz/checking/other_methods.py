"""Other methods than SAT in floats, mostly wrong: by corners, edges, circles, distances; and shortcuts of cases.

Each method of two shapes returns (claimed relation, push of B or None); its first arguments choose how it is done.
"""

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from math import dist, hypot

from ..engine.axes import Axis, Choice, centers, edge_normals
from ..engine.geometry import APART, OVERLAPPING, Relation, Vec, relation_of_gap
from ..engine.relate import relate
from ..engine.sat import AxisTest, Projection, project
from ..engine.shapes import Shape
from ..engine.shortcut import Shortcut
from ..engine.trace import record
from ..scenes.failing import NAMED
from ..scenes.failing.saved_work import corner_tests
from ..scenes.failing.wrong_steps import measured_test
from ..scenes.shape_tools import vertex_mean
from .written import LARGE_RADII, SMALL_RADII, Middle, Radius, Ring, Variant, Written, ends, listed, mean


def by_shortcut(shortcut: Shortcut, a: Shape, b: Shape) -> tuple[Relation, Vec | None]:
    """Return (relation, push) as a shortcut claims them for two shapes."""
    trace = record(a, b, axes=shortcut, every_axis=True)
    return trace.claim, trace.push


def push_along_centers(a: Shape, b: Shape, tests: Sequence[AxisTest]) -> Vec:
    """Return a push of B by the depth along the line from A's vertex mean to B's; along x where both are one point."""
    depth, (px, py), (qx, qy) = -max(test.gap for test in tests), vertex_mean(a), vertex_mean(b)
    length = hypot(qx - px, qy - py)
    return Vec((qx - px) / length * depth, (qy - py) / length * depth) if length else Vec(depth, 0.0)


def spot_inside(spot_of: Callable[[Shape], Vec], a: Shape, b: Shape) -> tuple[Relation, None]:
    """Return (OVERLAPPING, None) if the point `spot_of` a convex polygon lies in the other one, else (APART, None)."""
    return (OVERLAPPING if min(_outside(spot_of(a), b), _outside(spot_of(b), a)) <= 0 else APART), None


def first_corner(shape: Shape) -> Vec:
    """Return the first vertex, or a circle's center."""
    return (shape.vertices or shape.core)[0]


def corners_in(owner: str, a: Shape, b: Shape) -> tuple[Relation, None]:
    """Return (OVERLAPPING, None) if a corner of one shape lies in `owner`, "A" or "B", else (APART, None)."""
    gaps = [test.gap for test in corner_tests(a, b) if test.axis.source.shape == owner]
    return (OVERLAPPING if min(gaps) <= 0 else APART), None


def with_circle(gap_of: Callable[[Shape, Vec, float], float], a: Shape, b: Shape) -> tuple[Relation, None]:
    """Return (relation by the sign of `gap_of`, None); ValueError unless one shape is a circle.

    `gap_of`: a function of (polygon, center, radius).
    """
    if a.core_is_point == b.core_is_point:
        raise ValueError("this method compares a circle with a convex polygon")
    shape, circle = (a, b) if b.core_is_point else (b, a)
    gap = gap_of(shape, circle.core[0], circle.radius)
    return relation_of_gap(gap), None


def gap_to_nearest_corner(shape: Shape, center: Vec, radius: float) -> float:
    """Return the distance of a circle from the nearest corner of a polygon; negative if the corner is inside."""
    return min(dist(vertex, center) for vertex in shape.vertices) - radius


def gap_to_corner_or_center(shape: Shape, center: Vec, radius: float) -> float:
    """Return the smaller of `gap_to_nearest_corner` and `_outside` of the center: either below 0 is a hit."""
    return min(gap_to_nearest_corner(shape, center, radius), _outside(center, shape))


def gap_to_box(shape: Shape, center: Vec, radius: float) -> float:
    """Return the gap between the polygon's bounding box and the circle, negative if they overlap."""
    x0, y0, x1, y1 = shape.bounds
    return hypot(max(x0 - center.x, 0.0, center.x - x1), max(y0 - center.y, 0.0, center.y - y1)) - radius


def gap_by_unscaled_radius(shape: Shape, center: Vec, radius: float) -> float:
    """Return the largest gap on edge normals that are not of length 1, from which the radius is subtracted unscaled."""
    ranges = [(ends(shape.vertices, n), ends([center], n).lo) for n in listed(shape.vertices, ())]
    return max(max(at - radius - on.hi, on.lo - at - radius) for on, at in ranges)


def rims_meet(a: Shape, b: Shape) -> tuple[Relation, None]:
    """Return (OVERLAPPING, None) if the rims of two circles meet, else (APART, None); ValueError for other shapes."""
    away = dist(*_centers(a, b))
    return (OVERLAPPING if abs(a.radius - b.radius) <= away <= a.radius + b.radius else APART), None


def edges_cross(strict: bool, a: Shape, b: Shape) -> tuple[Relation, None]:
    """Return (OVERLAPPING, None) if the orientations of their ends say that two edges cross, else (APART, None).

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
    """Return (relation, None) of two circles by comparing the squared distance with the sum of the radii."""
    (ax, ay), (bx, by) = _centers(a, b)
    gap = (bx - ax) ** 2 + (by - ay) ** 2 - a.radius - b.radius
    return relation_of_gap(gap), None


def normals_and_centers(a: Shape, b: Shape) -> Choice:
    """Return the choice of all edge normals and the line between the centers."""
    return Choice((*edge_normals(a, b).axes, *centers(a, b).axes))


def _centers(a: Shape, b: Shape) -> tuple[Vec, Vec]:
    """Return the centers of two circles; ValueError for other shapes."""
    if not (a.core_is_point and b.core_is_point):
        raise ValueError("this method compares two circles")
    return a.core[0], b.core[0]


def _outside(spot: Vec, shape: Shape) -> float:
    """Return the largest gap from a polygon's range on an edge's normal to a point, times the edge's length.

    It is 0 or less for a point inside.
    """
    landings = [(ends(shape.vertices, n), ends([spot], n).lo) for n in listed(shape.vertices, ())]
    return max(max(at - on.hi, on.lo - at) for on, at in landings)


def outward_from_each_middle(a: Shape, b: Shape, axis: Axis) -> AxisTest:
    """Return the test of an edge normal that points, for each shape separately, away from its own vertex mean."""
    start, n = (a if axis.source.shape == "A" else b).vertices[axis.source.ids[0]], axis.direction

    def project_outward(shape: Shape) -> Projection:
        """Return the projection of a shape on the normal or its opposite, which leads away from its mean."""
        middle, points = vertex_mean(shape), project(shape, axis).points
        sign = -1 if (middle.x - start.x) * n.x + (middle.y - start.y) * n.y > 0 else 1
        return Projection(points, tuple(sign * (p.x * n.x + p.y * n.y) for p in points))

    return measured_test(axis, project_outward(a), project_outward(b))


def reversed_verdict(a: Shape, b: Shape) -> tuple[Relation, None]:
    """Return (APART, None) for shapes that meet, and (OVERLAPPING, None) for those that are apart."""
    return (OVERLAPPING if relate(a, b) is APART else APART), None


def within_reach(reach: float, a: Shape, b: Shape) -> tuple[Relation, None]:
    """Return (OVERLAPPING, None) if the distance of both vertex means is at most `reach`, else (APART, None)."""
    p, q = a.vertices or a.core, b.vertices or b.core
    return (OVERLAPPING if dist(mean(p), mean(q)) <= reach else APART), None


def beyond_reach(
    middle: Middle, radius: Radius, join: Callable[[tuple[float, float]], float], a: Shape, b: Shape
) -> tuple[Relation, Vec | None]:
    """Return (APART, None) if the middles are further apart than `join` of both radii, else the right answer and push.

    `middle`, `radius`: functions of a ring of vertices (of a circle, its center); `join`: such as sum or max.
    """
    p, q = a.vertices or a.core, b.vertices or b.core
    if dist(middle(p), middle(q)) > join((radius(p), radius(q))):
        return APART, None
    if a.is_convex and b.is_convex and a.vertices and b.vertices:
        return Written()(a, b)
    trace = record(a, b)
    return trace.relation, trace.mtv


def _other_ways() -> Iterator[Variant]:
    """Yield (name of a failing case, method, how it differs) for the mistakes of other methods than SAT."""
    yield "corner-inside", partial(spot_inside, vertex_mean), "here the middle of one"
    yield "corner-inside", partial(corners_in, "B"), "here a corner of A in B alone"
    yield "corner-inside", partial(corners_in, "A"), "here a corner of B in A alone"
    yield "corner-inside", partial(spot_inside, first_corner), "here the first corner of one"
    for gap_of, words in (
        (gap_to_nearest_corner, "here a corner in the circle"),
        (lambda shape, center, radius: _outside(center, shape), "here the center of the circle in the polygon"),
        (gap_to_corner_or_center, "here the center of the circle, too"),
    ):
        yield "corner-inside", partial(with_circle, gap_of), words
    yield "aabb-not-upright", partial(with_circle, gap_to_box), "here beside a circle"
    yield (
        "no-nearest-vertex",
        partial(with_circle, gap_by_unscaled_radius),
        "here with a radius that is not scaled like the normals",
    )
    to_center = NAMED["no-nearest-vertex"].shortcut._replace(choose=normals_and_centers)
    yield "no-nearest-vertex", partial(by_shortcut, to_center), "here the line of the centers, too"
    yield "edges-cross", rims_meet, "here the rims of circles"
    for strict, words in ((False, "here by the signs of their turns"), (True, "here at a point inside both edges")):
        yield "edges-cross", partial(edges_cross, strict), words
    yield "circles-turned-round", squared_distance, "here the squared distance is compared"
    yield "circles-turned-round", reversed_verdict, "here the whole verdict, for shapes of any kind"
    from_each_middle = NAMED["mixed-signs"].shortcut._replace(choose=edge_normals, measure=outward_from_each_middle)
    yield "mixed-signs", partial(by_shortcut, from_each_middle), "here away from the middle of each shape"
    along_line = NAMED["push-from-center"].shortcut._replace(push=push_along_centers)
    yield "push-from-center", partial(by_shortcut, along_line), "here along the line between the middles"
    for middle, radius in SMALL_RADII:
        yield "far-centers", partial(beyond_reach, middle, radius, sum), "here further than the reach of both shapes"
    for middle, radius in LARGE_RADII:
        yield "far-centers", partial(beyond_reach, middle, radius, max), "here further than the larger reach"
    for reach in 2.0, 3.0, 5.0, 8.0, 12.0, 20.0:
        yield "far-centers", partial(beyond_reach, mean, partial(_fixed, reach), max), f"here further than {reach:g}"
        yield "bounding-circles", partial(within_reach, reach), "here of one size for all shapes"


def _fixed(reach: float, ring: Ring) -> float:
    """Return the given reach, whatever the ring of vertices."""
    return reach


VARIANTS = tuple(_other_ways())
