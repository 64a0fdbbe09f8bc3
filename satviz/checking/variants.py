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
from ..scenes.failing.saved_work import corner_tests
from ..scenes.failing.wrong_steps import is_closing_edge, measured_test, only_x, raw_normals, vertex_count
from ..scenes.shape_tools import vertex_mean

Predict = Callable[[Shape, Shape], tuple[Relation, Vec | None]]  # the claimed relation, and the push of B
Reach = Callable[[Shape], float]
Landings = Sequence[float]
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


def edge_landings(sign: int, a: Shape, b: Shape) -> Iterator[tuple[Vec, Landings, Landings]]:
    """Yield each edge's normal, as long as the edge, turned left (`sign` 1) or right (-1), and the landings of A and B.

    The edges go by the vertices as they are listed, so the normals of a clockwise outline are turned, too.
    """
    if not (a.vertices and b.vertices):
        raise ValueError("a circle has no edges")
    for ring in a.vertices, b.vertices:
        for p, q in zip(ring, (*ring[1:], *ring[:1])):
            n = Vec(sign * (p.y - q.y), sign * (q.x - p.x))
            on_a, on_b = ([n.x * v.x + n.y * v.y for v in shape.vertices] for shape in (a, b))
            yield n, on_a, on_b


def by_gaps(gap_of: Callable[[Landings, Landings], float], sign: int, a: Shape, b: Shape) -> tuple[Relation, None]:
    """Return what the largest gap on the normals of all edges claims, with `gap_of` in place of the true gap."""
    return _by_largest([gap_of(on_a, on_b) for _, on_a, on_b in edge_landings(sign, a, b)]), None


def on_one_side(on_a: Landings, on_b: Landings) -> float:
    """Return the gap from A's end to B's start alone."""
    return min(on_b) - max(on_a)


def from_zero(on_a: Landings, on_b: Landings) -> float:
    """Return the gap of ranges whose larger ends were searched for from 0 upward."""
    return max(min(on_a) - max(0.0, *on_b), min(on_b) - max(0.0, *on_a))


def about_the_middle(on_a: Landings, on_b: Landings) -> float:
    """Return the gap of ranges that reach equally far to both sides of the vertex mean."""
    p, q = (sum(on) / len(on) for on in (on_a, on_b))
    return abs(p - q) - max(abs(t - p) for t in on_a) - max(abs(t - q) for t in on_b)


def by_an_end_of_a(on_a: Landings, on_b: Landings) -> float:
    """Return how far the nearer end of A's range lies outside B's range; else 0 or less."""
    return min(max(min(on_b) - t, t - max(on_b)) for t in (min(on_a), max(on_a)))


def by_an_end_of_b(on_a: Landings, on_b: Landings) -> float:
    """Return how far the nearer end of B's range lies outside A's range; else 0 or less."""
    return by_an_end_of_a(on_b, on_a)


def push_by_edges(sign: int, one_sided: bool, a: Shape, b: Shape) -> tuple[Relation, Vec | None]:
    """Return the right relation, and the push along an edge's normal as it comes, turned left or right of the edge.

    `one_sided`: the depth on a normal is how far A's end lies beyond B's start, also where B's end is nearer.
    """
    best, push = inf, None
    for n, on_a, on_b in edge_landings(sign, a, b):
        length = hypot(*n)
        if not length:
            continue  # a vertex that is listed twice is another mistake
        depth = max(on_a) - min(on_b)
        depth = (depth if one_sided else min(depth, max(on_b) - min(on_a))) / length
        if depth < best:
            best, push = depth, Vec(n.x / length * depth, n.y / length * depth)
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


def corners_in(owner: str, a: Shape, b: Shape) -> tuple[Relation, None]:
    """Return OVERLAPPING if a corner of the other shape lies in A or B, as `owner` says."""
    gaps = [test.gap for test in corner_tests(a, b) if test.axis.source.shape == owner]
    return (OVERLAPPING if min(gaps) <= 0 else APART), None


def corners_or_center(a: Shape, b: Shape) -> tuple[Relation, None]:
    """Return OVERLAPPING if a corner of a polygon lies in a circle, or the circle's center in the polygon."""
    shape, circle = (a, b) if b.core_is_point else (b, a)
    gaps = [dist(vertex, circle.core[0]) - circle.radius for vertex in shape.vertices]
    gaps.append(max(_beyond(axis, circle.core[0], shape) for axis in edge_normals(shape, shape).axes))
    return (OVERLAPPING if min(gaps) <= 0 else APART), None


def edges_turn(a: Shape, b: Shape) -> tuple[Relation, None]:
    """Return OVERLAPPING if two edges cross by the test of turns, which counts a turn of 0 as clockwise."""

    def turns(p: Vec, q: Vec, r: Vec) -> bool:
        """Return whether p, q, r turn counter-clockwise."""
        return (q.x - p.x) * (r.y - p.y) > (q.y - p.y) * (r.x - p.x)

    edges_of_a, edges_of_b = (tuple(zip(ring, (*ring[1:], *ring[:1]))) for ring in (a.vertices, b.vertices))
    crossed = any(
        turns(p, r, s) != turns(q, r, s) and turns(p, q, r) != turns(p, q, s)
        for p, q in edges_of_a
        for r, s in edges_of_b
    )
    return (OVERLAPPING if crossed else APART), None


def squared_distance(a: Shape, b: Shape) -> tuple[Relation, None]:
    """Return what follows for two circles if the squared distance is compared with the sum of the radii."""
    if not (a.core_is_point and b.core_is_point):
        raise ValueError("no two circles")
    (ax, ay), (bx, by) = a.core[0], b.core[0]
    return _by_largest([(bx - ax) ** 2 + (by - ay) ** 2 - a.radius - b.radius]), None


def line_of_middles(a: Shape, b: Shape) -> Choice:
    """Return the line between the vertex means as the only axis; x where both are one point."""
    (ax, ay), (bx, by) = vertex_mean(a), vertex_mean(b)
    along = Vec(bx - ax, by - ay)
    return directions(along if any(along) else Vec(1.0, 0.0))(a, b)


def one_edge(index: int, a: Shape, b: Shape) -> Choice:
    """Return the normal of one edge of both shapes' edges in order as the only axis."""
    return Choice(edge_normals(a, b).axes[index:][:1])


def without_first_edges(a: Shape, b: Shape) -> Choice:
    """Return all edge normals but that of the first edge of each shape."""
    return Choice(tuple(axis for axis in edge_normals(a, b).axes if axis.source.ids != (0, 1)))


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
    yield chosen("one-overlap", partial(one_edge, 0), "here on the normal of the first edge")
    yield chosen("one-overlap", partial(one_edge, -1), "here on the normal of the last edge")
    yield chosen("one-overlap", line_of_middles, "here on the line between the middles")
    yield chosen("open-outline", without_first_edges, "here without the first edge")
    yield "bounding-circles", partial(by_gaps, about_the_middle, 1), "here on each axis, about the middle of each range"
    yield "corner-inside", partial(by_gaps, by_an_end_of_a, 1), "here an end of A's range in B's, on each axis"
    yield "corner-inside", partial(by_gaps, by_an_end_of_b, 1), "here an end of B's range in A's, on each axis"
    for sign in (1, -1):
        yield "start-at-zero", partial(by_gaps, from_zero, sign), "here on the normal of each edge"
        yield "one-sided-gap", partial(by_gaps, on_one_side, sign), "here on the normal of each edge"
        yield "one-sided-gap", partial(push_by_edges, sign, True), "here for the depth"
        yield "push-along-normal", partial(push_by_edges, sign, False), ""
    yield chosen("one-sided-gap", world, "here on x and y")
    yield "corner-inside", middle_inside, "here the middle of one"
    yield "corner-inside", partial(corners_in, "B"), "here a corner of A in B alone"
    yield "corner-inside", partial(corners_in, "A"), "here a corner of B in A alone"
    yield "corner-inside", corners_or_center, "here the center of the circle, too"
    yield "edges-cross", edges_turn, "here by the signs of their turns"
    yield "circles-turned-round", squared_distance, "here the squared distance is compared"
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
