"""Other ways in which people write a known mistake: (the name of its failing case, what it claims, in which way)."""

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from math import dist, hypot, inf
from operator import itemgetter

from ..engine.axes import Axis, Choice, Chooser, directions, edge_normals, edge_normals_of_a, edge_normals_of_b, world
from ..engine.geometry import Relation, Vec
from ..engine.relate import relate
from ..engine.sat import AxisTest, Projection, axis_tests, project
from ..engine.shapes import Shape
from ..engine.shortcut import Shortcut, move_along_axis
from ..engine.trace import record
from ..scenes.failing import NAMED
from ..scenes.failing.wrong_steps import is_closing_edge, measured_test, only_x, raw_normals, vertex_count
from ..scenes.shape_tools import vertex_mean

Predict = Callable[[Shape, Shape], tuple[Relation, Vec | None]]  # the claimed relation, and the push of B
Reach = Callable[[Shape], float]
APART, TOUCHING, OVERLAPPING = Relation


def by_shortcut(shortcut: Shortcut, a: Shape, b: Shape) -> tuple[Relation, Vec | None]:
    """Return what a shortcut claims for a pair."""
    trace = record(a, b, axes=shortcut, every_axis=True)
    return trace.claim, trace.push


def any_overlap(a: Shape, b: Shape) -> tuple[Relation, Vec | None]:
    """Return OVERLAPPING if the ranges meet on any edge normal: `any` written for `all`."""
    return _by_largest([min((test.gap for test in axis_tests(a, b, edge_normals(a, b).axes)), default=1.0)]), None


def _by_largest(gaps: Sequence[float]) -> Relation:
    """Return the relation that the largest gap claims."""
    return APART if max(gaps) > 0 else TOUCHING if max(gaps) == 0 else OVERLAPPING


def raw_push(a: Shape, b: Shape, tests: Sequence[AxisTest]) -> Vec:
    """Return the push of a raw normal times a raw depth: neither was divided by the normal's length."""
    test = max(tests, key=lambda test: test.gap)
    return move_along_axis(test, -test.gap * test.axis.length)


def along_edges(a: Shape, b: Shape) -> Choice:
    """Return the directions of all edges as axes, without the quarter turn that makes a normal."""
    return directions(*(Vec(-axis.normal.y, axis.normal.x) for axis in edge_normals(a, b).axes))(a, b)


def without_minus(a: Shape, b: Shape) -> Choice:
    """Return for each edge (dx, dy) the axis along (dy, dx)."""
    return directions(*(Vec(axis.normal.x, -axis.normal.y) for axis in edge_normals(a, b).axes))(a, b)


def one_side_of_each_edge(sign: int, a: Shape, b: Shape) -> tuple[Relation, Vec | None]:
    """Return APART if A ends before B begins on an edge's normal, turned left (`sign` 1) or right (-1) of the edge."""
    gaps = []
    for ring in a.vertices, b.vertices:
        for p, q in zip(ring, (*ring[1:], *ring[:1])):
            n = Vec(sign * (p.y - q.y), sign * (q.x - p.x))
            on_a, on_b = ([n.x * v.x + n.y * v.y for v in shape.vertices] for shape in (a, b))
            gaps.append(min(on_b) - max(on_a))
    return _by_largest(gaps), None


def push_by_edges(sign: int, one_sided: bool, a: Shape, b: Shape) -> tuple[Relation, Vec | None]:
    """Return the right relation, and the push along an edge's normal as it comes, turned left or right of the edge.

    `one_sided`: the depth on a normal is how far A's end lies beyond B's start, also where B's end is nearer.
    """
    best, push = inf, None
    for ring in a.vertices, b.vertices:
        for p, q in zip(ring, (*ring[1:], *ring[:1])):
            length = hypot(q.x - p.x, q.y - p.y)
            if not length:
                continue  # a vertex that is listed twice is another mistake
            n = Vec(sign * (p.y - q.y) / length, sign * (q.x - p.x) / length)
            on_a, on_b = ([n.x * v.x + n.y * v.y for v in shape.vertices] for shape in (a, b))
            depth = max(on_a) - min(on_b) if one_sided else min(max(on_a) - min(on_b), max(on_b) - min(on_a))
            if depth < best:
                best, push = depth, Vec(n.x * depth, n.y * depth)
    relation = relate(a, b)
    return relation, push if relation is OVERLAPPING else None


def middle_inside(a: Shape, b: Shape) -> tuple[Relation, Vec | None]:
    """Return OVERLAPPING if the middle of one convex polygon lies in the other."""
    spots = (vertex_mean(a), b), (vertex_mean(b), a)
    inside = any(
        all(test <= 0 for test in (_beyond(axis, spot, shape) for axis in edge_normals(shape, shape).axes))
        for spot, shape in spots
    )
    return (OVERLAPPING if inside else APART), None


def _beyond(axis: Axis, spot: Vec, shape: Shape) -> float:
    """Return how far a point lies outside the range of a shape on an axis, in units of the normal; else 0 or less."""
    at, ends = (spot.x * axis.normal.x + spot.y * axis.normal.y) / axis.length, project(shape, axis).interval
    return max(at - ends.hi, ends.lo - at)


def first_half_rounded_up(a: Shape, b: Shape) -> Choice:
    """Return the normals of the first half of the edges; of an odd number of edges the one in the middle, too."""
    kept = (
        axis
        for axis in edge_normals(a, b).axes
        if not is_closing_edge(axis, a, b) and axis.source.ids[0] < (vertex_count(axis, a, b) + 1) // 2
    )
    return Choice(tuple(kept))


def one_for_equal_counts(a: Shape, b: Shape) -> Choice:
    """Return the edge normals of A alone where both shapes have as many vertices, else of both."""
    return (edge_normals_of_a if len(a.vertices) == len(b.vertices) else edge_normals)(a, b)


def outward_from_each_middle(a: Shape, b: Shape, axis: Axis) -> AxisTest:
    """Return the test of an edge normal that is turned for each shape by itself, away from its own vertex mean."""
    start, n = (a if axis.source.shape == "A" else b).vertices[axis.source.ids[0]], axis.direction

    def project_outward(shape: Shape) -> Projection:
        """Return the projection of a shape on the normal or its opposite."""
        middle, points = vertex_mean(shape), project(shape, axis).points
        sign = -1 if (middle.x - start.x) * n.x + (middle.y - start.y) * n.y > 0 else 1
        return Projection(points, tuple(sign * (p.x * n.x + p.y * n.y) for p in points))

    return measured_test(axis, project_outward(a), project_outward(b))


def one_extreme_each(step: int, a: Shape, b: Shape, axis: Axis) -> AxisTest:
    """Return the test of an axis that projects one vertex on each side of the bounding box.

    `step`: where several vertices lie on a side, 1 takes the first, -1 the last.
    """

    def project_extremes(shape: Shape) -> Projection:
        """Return the projection of these four vertices."""
        listed = shape.vertices[::step]
        if not listed:
            return project(shape, axis)
        few = [pick(listed, key=itemgetter(k)) for pick in (min, max) for k in (0, 1)]
        return Projection(tuple(few), tuple(p.x * axis.direction.x + p.y * axis.direction.y for p in few))

    return measured_test(axis, project_extremes(a), project_extremes(b))


def push_along_centers(a: Shape, b: Shape, tests: Sequence[AxisTest]) -> Vec:
    """Return a push of B by the depth along the line from A's vertex mean to B's; along x where both are one point."""
    depth, (px, py), (qx, qy) = -max(test.gap for test in tests), vertex_mean(a), vertex_mean(b)
    length = hypot(qx - px, qy - py)
    return Vec((qx - px) / length * depth, (qy - py) / length * depth) if length else Vec(depth, 0.0)


def beyond_reach(reach: Reach, a: Shape, b: Shape) -> tuple[Relation, Vec | None]:
    """Return APART where the vertex means are further apart than the sum of both reaches, else the right answer."""
    if dist(vertex_mean(a), vertex_mean(b)) > reach(a) + reach(b):
        return APART, None
    trace = record(a, b)
    return trace.relation, trace.mtv


def _distances(shape: Shape) -> list[float]:
    """Return how far each vertex is from the vertex mean; of a circle its radius."""
    middle = vertex_mean(shape)
    return [dist(middle, vertex) for vertex in shape.vertices] or [shape.radius]


def _half_sides(shape: Shape) -> list[float]:
    """Return half the width and half the height of the bounding box."""
    (x0, y0), (x1, y1) = (tuple(f(axis) for axis in zip(*shape.core)) for f in (min, max))
    return [(x1 - x0) / 2 + shape.radius, (y1 - y0) / 2 + shape.radius]


REACHES: tuple[Reach, ...] = (
    lambda shape: sum(_distances(shape)) / len(_distances(shape)),
    lambda shape: min(_distances(shape)),
    lambda shape: min(_half_sides(shape)),
    lambda shape: sum(_half_sides(shape)) / 2,
)


def _variants() -> Iterator[tuple[str, Predict, str]]:
    """Yield the name of each mistake with another way to write it, and what is different there, in words."""

    def chosen(name: str, choose: Chooser, words: str) -> tuple[str, Predict, str]:
        """Return the mistake with another choice of axes."""
        return name, partial(by_shortcut, NAMED[name].shortcut._replace(choose=choose)), words

    yield chosen("one-shapes-normals", edge_normals_of_b, "here those of B")
    yield chosen("one-overlap", only_x, "here on the x axis")
    yield "one-overlap", any_overlap, "here on any one of them"
    for sign in (1, -1):
        yield "one-sided-gap", partial(one_side_of_each_edge, sign), "here on the normal of each edge"
        yield "one-sided-gap", partial(push_by_edges, sign, True), "here for the depth"
        yield "push-along-normal", partial(push_by_edges, sign, False), ""
    yield chosen("one-sided-gap", world, "here on x and y")
    yield "corner-inside", middle_inside, "here the middle of one"
    yield chosen("line-for-axis", along_edges, "here an edge is taken as an axis, without the quarter turn")
    yield chosen("slipped-normal", without_minus, "here (dy, dx), without the minus")
    yield chosen("half-the-normals", first_half_rounded_up, "here half of them, rounded up")
    yield chosen("same-shape", one_for_equal_counts, "here for shapes with equally many corners")
    outward = NAMED["mixed-signs"].shortcut._replace(choose=edge_normals, measure=outward_from_each_middle)
    yield "mixed-signs", partial(by_shortcut, outward), "here away from the middle of each shape"
    for step in (1, -1):
        few = NAMED["extremes-once"].shortcut._replace(measure=partial(one_extreme_each, step))
        yield "extremes-once", partial(by_shortcut, few), ""
    raw = NAMED["raw-depth"].shortcut._replace(measure=raw_normals, push=raw_push)
    yield "raw-depth", partial(by_shortcut, raw), "here the normal of the move is as long as its edge, too"
    along_line = NAMED["push-from-center"].shortcut._replace(push=push_along_centers)
    yield "push-from-center", partial(by_shortcut, along_line), "here along the line between the middles"
    for reach in REACHES:
        yield "far-centers", partial(beyond_reach, reach), "here further than the reach of both shapes"


VARIANTS = tuple(_variants())
