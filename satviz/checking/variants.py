"""Other ways in which people write a known mistake: (the name of its failing case, what it claims, in which way)."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from math import atan2, cos, degrees, dist, floor, hypot, sin
from operator import itemgetter
from typing import NamedTuple

from ..engine.axes import Axis, Choice, centers, edge_normals
from ..engine.geometry import Interval, Relation, Vec
from ..engine.relate import relate
from ..engine.sat import AxisTest, Projection, project
from ..engine.shapes import Shape
from ..engine.shortcut import Shortcut
from ..engine.trace import record
from ..scenes.failing import NAMED
from ..scenes.failing.saved_work import corner_tests
from ..scenes.failing.wrong_projections import whole_halves
from ..scenes.failing.wrong_steps import measured_test
from ..scenes.shape_tools import vertex_mean

Predict = Callable[[Shape, Shape], tuple[Relation, Vec | None]]  # the claimed relation, and the push of B
Variant = tuple[str, Predict, str]
Ring = Sequence[Vec]
Middle = Callable[[Ring], Vec]
Radius = Callable[[Ring], float]
APART, TOUCHING, OVERLAPPING = Relation


def by_shortcut(shortcut: Shortcut, a: Shape, b: Shape) -> tuple[Relation, Vec | None]:
    """Return what a shortcut claims for a pair."""
    trace = record(a, b, axes=shortcut, every_axis=True)
    return trace.claim, trace.push


# -- SAT as people write it, in plain floats


class Overlap(NamedTuple):
    """The overlap of the ranges of A and B on an axis along `n`, in units of n's length; negative for a gap."""

    n: Vec
    a: Interval
    b: Interval
    size: float


def normal(dx: float, dy: float) -> Vec:
    """Return the normal of an edge (dx, dy) to the right, as long as the edge."""
    return Vec(dy, -dx)


def listed(
    a: Ring,
    b: Ring,
    turn: Callable[[float, float], Vec] = normal,
    sign: int = 1,
    cut_a: slice = slice(None),
    cut_b: slice = slice(None),
) -> list[Vec]:
    """Return what `turn` makes of each edge of A and of B, in the order in which the vertices are listed.

    `sign`: -1 for the opposites; `cut_a`, `cut_b`: the edges that are taken.
    """
    found = []
    for ring, cut in (a, cut_a), (b, cut_b):
        for p, q in list(zip(ring, (*ring[1:], *ring[:1])))[cut]:
            if p != q:  # a vertex that is listed twice is another mistake
                x, y = turn(q.x - p.x, q.y - p.y)
                found.append(Vec(sign * x, sign * y))
    return found


def ends(ring: Ring, n: Vec) -> Interval:
    """Return the range of a ring of vertices on an axis along n."""
    landings = [n.x * p.x + n.y * p.y for p in ring]
    return Interval(min(landings), max(landings))


def nearer_end(a: Interval, b: Interval) -> float:
    """Return the overlap of two ranges: how far one of them has to move at least."""
    return min(a.hi - b.lo, b.hi - a.lo)


def shorter_way(a: Ring, b: Ring, found: Overlap) -> int:
    """Return 1 where B leaves A sooner along n, else -1."""
    return 1 if found.a.hi - found.b.lo < found.b.hi - found.a.lo else -1


@dataclass(frozen=True, slots=True)
class Written:
    """SAT as people write it; a mistake replaces one step.

    `axes`: the axes of two rings, of any length; `ends`: the range of a ring on an axis; `overlap`: of two ranges;
    `powers`: of the normal's length, by which overlaps are divided where they are compared, and the normal times the
    overlap where it becomes the push; `pick`: the place of the axis of the push, where the least overlap comes first,
    or, with `in_order`, in the order of the axes; `way`: 1 for a push along the normal, else -1; `share`: of
    the push; `any_axis`: whether one overlap is enough for a hit.
    """

    axes: Callable[[Ring, Ring], Sequence[Vec]] = listed
    ends: Callable[[Ring, Vec], Interval] = ends
    overlap: Callable[[Interval, Interval], float] = nearer_end
    powers: tuple[int, int] = (1, 2)
    pick: int = 0
    in_order: bool = False
    way: Callable[[Ring, Ring, Overlap], int] = shorter_way
    share: float = 1.0
    any_axis: bool = False

    def __call__(self, a: Shape, b: Shape) -> tuple[Relation, Vec | None]:
        """Return the claimed relation and the push of B; ValueError for a circle, which has no edges."""
        p, q = a.vertices, b.vertices
        if not (p and q):
            raise ValueError("a circle has no edges")
        found = []
        for n in self.axes(p, q):
            on_a, on_b = self.ends(p, n), self.ends(q, n)
            found.append(Overlap(n, on_a, on_b, self.overlap(on_a, on_b)))
        sizes = [each.size for each in found]
        least = (max if self.any_axis else min)(sizes, default=0.0)
        if least < 0:
            return APART, None
        if self.any_axis:
            found = [each for each in found if each.size >= 0]
        if not self.in_order:
            found.sort(key=lambda each: each.size / _length(each.n) ** self.powers[0])
        if not found:
            return TOUCHING, None
        picked = found[self.pick]
        size = self.share * self.way(p, q, picked) * picked.size / _length(picked.n) ** self.powers[1]
        return OVERLAPPING if least else TOUCHING, Vec(picked.n.x * size, picked.n.y * size)


def _length(n: Vec) -> float:
    """Return the length of a vector, 1 for (0, 0), to which a normal may be rounded."""
    return hypot(*n) or 1.0


# -- axes


def of_world(a: Ring, b: Ring) -> list[Vec]:
    """Return x and y."""
    return [Vec(1.0, 0.0), Vec(0.0, 1.0)]


def between(middle: Middle, a: Ring, b: Ring) -> list[Vec]:
    """Return the line between the middles as the only axis; x where both are one point."""
    (ax, ay), (bx, by) = middle(a), middle(b)
    return [Vec(bx - ax, by - ay) if (ax, ay) != (bx, by) else Vec(1.0, 0.0)]


def one_edge(index: int, a: Ring, b: Ring) -> list[Vec]:
    """Return the normal of one of all edges."""
    return [listed(a, b)[index]]


def of_each(cut: Callable[[int], slice], a: Ring, b: Ring) -> list[Vec]:
    """Return the normals of some edges of each ring, by its number of vertices."""
    return listed(a, b, cut_a=cut(len(a)), cut_b=cut(len(b)))


def of_vertices(turn: Callable[[float, float], Vec], a: Ring, b: Ring) -> list[Vec]:
    """Return what `turn` makes of each vertex, as if it were the vector of an edge."""
    return [turn(*p) for ring in (a, b) for p in ring]


def one_for_equal_counts(a: Ring, b: Ring) -> list[Vec]:
    """Return the normals of A alone where both rings have as many vertices, else of both."""
    return listed(a, b if len(a) != len(b) else ())


def outward(sign: int, a: Ring, b: Ring) -> list[Vec]:
    """Return normals that lead from A to B if both rings are counter-clockwise; -1 for `sign` if clockwise."""
    return [*listed(a, (), sign=sign), *listed((), b, sign=-sign)]


def angle_in_degrees(dx: float, dy: float) -> Vec:
    """Return the direction of the angle in radians that an edge's normal has in degrees."""
    angle = degrees(atan2(dy, dx)) + 90
    return Vec(cos(angle), sin(angle))


def rounded_to(round_to: Callable[[float], float], dx: float, dy: float) -> Vec:
    """Return the normal of an edge, brought to length 1, with both of its numbers rounded."""
    length = hypot(dx, dy)
    return Vec(round_to(dy / length), round_to(-dx / length))


# -- ranges


def from_zero(ring: Ring, n: Vec) -> Interval:
    """Return a range whose larger end was searched for from 0 upward."""
    lo, hi = ends(ring, n)
    return Interval(lo, max(0.0, hi))


def both_from_zero(ring: Ring, n: Vec) -> Interval:
    """Return a range both of whose ends were searched for from 0."""
    lo, hi = ends(ring, n)
    return Interval(min(0.0, lo), max(0.0, hi))


def without_signs(ring: Ring, n: Vec) -> Interval:
    """Return the absolute values of both ends of a range."""
    lo, hi = ends(ring, n)
    return Interval(abs(lo), abs(hi))


def about_the_mean(ring: Ring, n: Vec) -> Interval:
    """Return a range that reaches equally far to both sides of the vertex mean."""
    (at, _), (lo, hi) = ends([mean(ring)], n), ends(ring, n)
    reach = max(hi - at, at - lo)
    return Interval(at - reach, at + reach)


def circle_about(middle: Middle, radius: Radius, ring: Ring, n: Vec) -> Interval:
    """Return the range of the circle of this middle and radius."""
    (at, _), reach = ends([middle(ring)], n), radius(ring) * hypot(*n)
    return Interval(at - reach, at + reach)


def one_extreme_each(step: int, ring: Ring, n: Vec) -> Interval:
    """Return the range of one vertex on each side of the bounding box; -1 for `step` takes the last of several."""
    return ends([pick(ring[::step], key=itemgetter(k)) for pick in (min, max) for k in (0, 1)], n)


def some_vertices(cut: slice, ring: Ring, n: Vec) -> Interval:
    """Return the range of some vertices."""
    return ends(ring[cut], n)


def rounded_landings(round_to: Callable[[float], float], ring: Ring, n: Vec) -> Interval:
    """Return a range on the normal of length 1 with both ends rounded, in units of n's length."""
    length = hypot(*n)
    lo, hi = (length * round_to(end / length) for end in ends(ring, n))
    return Interval(lo, hi)


def half_is_whole(whole_middle: bool, ring: Ring, n: Vec) -> Interval:
    """Return a range that is kept as its middle and half of its length, rounded down to a whole number."""
    return whole_halves(ends(ring, n), whole_middle)


def twice_as_wide(ring: Ring, n: Vec) -> Interval:
    """Return a range that reaches as far as it is long to both sides of its middle."""
    lo, hi = ends(ring, n)
    return Interval((lo + hi) / 2 - (hi - lo), (lo + hi) / 2 + (hi - lo))


# -- overlaps


def a_before_b(a: Interval, b: Interval) -> float:
    """Return how far A's end lies beyond B's start, also where B's end is nearer."""
    return a.hi - b.lo


def by_an_end_of_a(a: Interval, b: Interval) -> float:
    """Return how deep an end of A's range lies within B's range, at most."""
    return max(min(b.hi - end, end - b.lo) for end in a)


def by_an_end_of_b(a: Interval, b: Interval) -> float:
    """Return how deep an end of B's range lies within A's range, at most."""
    return by_an_end_of_a(b, a)


# -- pushes


def along_normal(sign: int, a: Ring, b: Ring, found: Overlap) -> int:
    """Return the sign: the normal as it comes, or its opposite."""
    return sign


def from_middle(middle: Middle, a: Ring, b: Ring, found: Overlap) -> int:
    """Return 1 where the way from the middle of A to that of B leads along n, else -1."""
    (ax, ay), (bx, by) = middle(a), middle(b)
    return 1 if (bx - ax) * found.n.x + (by - ay) * found.n.y >= 0 else -1


def push_along_centers(a: Shape, b: Shape, tests: Sequence[AxisTest]) -> Vec:
    """Return a push of B by the depth along the line from A's vertex mean to B's; along x where both are one point."""
    depth, (px, py), (qx, qy) = -max(test.gap for test in tests), vertex_mean(a), vertex_mean(b)
    length = hypot(qx - px, qy - py)
    return Vec((qx - px) / length * depth, (qy - py) / length * depth) if length else Vec(depth, 0.0)


# -- no axes


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
    """Return what a gap between a convex polygon and a circle claims; ValueError for other pairs."""
    if a.core_is_point == b.core_is_point:
        raise ValueError("no circle and polygon")
    shape, circle = (a, b) if b.core_is_point else (b, a)
    gap = gap_of(shape, circle.core[0], circle.radius)
    return (APART if gap > 0 else TOUCHING if gap == 0 else OVERLAPPING), None


def nearest_corner(shape: Shape, center: Vec, radius: float) -> float:
    """Return how far the nearest corner of a polygon is from a circle, less than 0 inside."""
    return min(dist(vertex, center) for vertex in shape.vertices) - radius


def center_outside(shape: Shape, center: Vec, radius: float) -> float:
    """Return how far the center lies outside the polygon, else 0 or less."""
    return _outside(center, shape)


def corner_or_center(shape: Shape, center: Vec, radius: float) -> float:
    """Return the smaller of both, since a corner in the circle or the center in the polygon is a hit."""
    return min(nearest_corner(shape, center, radius), _outside(center, shape))


def box_and_circle(shape: Shape, center: Vec, radius: float) -> float:
    """Return the gap between the polygon's bounding box and the circle."""
    x0, y0, x1, y1 = shape.bounds
    return hypot(max(x0 - center.x, 0.0, center.x - x1), max(y0 - center.y, 0.0, center.y - y1)) - radius


def raw_radius(shape: Shape, center: Vec, radius: float) -> float:
    """Return the largest gap on the edge normals as they come, with a radius that is not as long as they are."""
    ranges = [(ends(shape.vertices, n), ends([center], n).lo) for n in listed(shape.vertices, ())]
    return max(max(at - radius - on.hi, on.lo - at - radius) for on, at in ranges)


def rims_meet(a: Shape, b: Shape) -> tuple[Relation, None]:
    """Return OVERLAPPING if the rims of two circles meet; ValueError for other shapes."""
    away = dist(*_centers(a, b))
    return (OVERLAPPING if abs(a.radius - b.radius) <= away <= a.radius + b.radius else APART), None


def edges_turn(strict: bool, a: Shape, b: Shape) -> tuple[Relation, None]:
    """Return OVERLAPPING if two edges cross by the signs of their turns, one of which may be 0 if not `strict`.

    A turn of 0 counts as clockwise then.
    """

    def turn(p: Vec, q: Vec, r: Vec) -> int:
        """Return 1 where p, q, r turn counter-clockwise, -1 where they turn clockwise, and else 0 or -1."""
        size = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)
        return (size > 0) - (size < 0 if strict else size <= 0)

    if not (a.vertices and b.vertices):
        raise ValueError("a circle has no edges")
    edges_of_a, edges_of_b = (tuple(zip(ring, (*ring[1:], *ring[:1]))) for ring in (a.vertices, b.vertices))
    crossed = any(
        turn(p, r, s) * turn(q, r, s) < 0 and turn(p, q, r) * turn(p, q, s) < 0
        for p, q in edges_of_a
        for r, s in edges_of_b
    )
    return (OVERLAPPING if crossed else APART), None


def squared_distance(a: Shape, b: Shape) -> tuple[Relation, None]:
    """Return what follows for two circles if the squared distance is compared with the sum of the radii."""
    (ax, ay), (bx, by) = _centers(a, b)
    gap = (bx - ax) ** 2 + (by - ay) ** 2 - a.radius - b.radius
    return APART if gap > 0 else TOUCHING if gap == 0 else OVERLAPPING, None


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
    """Return the test of an edge normal that is turned for each shape by itself, away from its own vertex mean."""
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
    """Return what follows if nothing but the distance of the middles counts."""
    p, q = a.vertices or a.core, b.vertices or b.core
    return (OVERLAPPING if dist(middle(p), middle(q)) <= reach(p, q) else APART), None


def beyond_reach(
    middle: Middle, reach: Callable[[Ring, Ring], float], a: Shape, b: Shape
) -> tuple[Relation, Vec | None]:
    """Return APART where the middles are further apart than a reach, else the right answer."""
    p, q = a.vertices or a.core, b.vertices or b.core
    if dist(middle(p), middle(q)) > reach(p, q):
        return APART, None
    if a.is_convex and b.is_convex and a.vertices and b.vertices:
        return Written()(a, b)
    trace = record(a, b)
    return trace.relation, trace.mtv


# -- middles and radii


def mean(ring: Ring) -> Vec:
    """Return the mean of the vertices."""
    return Vec(sum(p.x for p in ring) / len(ring), sum(p.y for p in ring) / len(ring))


def sides(ring: Ring) -> tuple[float, float]:
    """Return the width and the height of the bounding box."""
    width, height = (max(axis) - min(axis) for axis in zip(*ring))
    return width, height


def middle_of_box(ring: Ring) -> Vec:
    """Return the middle of the bounding box."""
    return Vec(*((max(axis) + min(axis)) / 2 for axis in zip(*ring)))


def distances(ring: Ring) -> list[float]:
    """Return how far each vertex is from the vertex mean."""
    return [dist(mean(ring), vertex) for vertex in ring]


LARGE_RADII: tuple[tuple[Middle, Radius], ...] = (  # of circles that hold the whole shape
    (mean, lambda ring: max(distances(ring))),
    (middle_of_box, lambda ring: hypot(*sides(ring)) / 2),
)
SMALL_RADII: tuple[tuple[Middle, Radius], ...] = (
    (mean, lambda ring: min(distances(ring))),
    (mean, lambda ring: sum(distances(ring)) / len(ring)),
    (middle_of_box, lambda ring: sides(ring)[0] / 2),
    (middle_of_box, lambda ring: max(sides(ring)) / 2),
    (middle_of_box, lambda ring: min(sides(ring)) / 2),
    (middle_of_box, lambda ring: sum(sides(ring)) / 4),
)
FIXED_REACHES = 1, 2, 3, 5, 8, 12, 20, 50


def _chosen_edges() -> Iterator[Variant]:
    """Yield the mistakes that leave out axes, or take others."""
    half, one, opened = "half-the-normals", "one-overlap", "open-outline"
    cuts: tuple[tuple[str, Callable[[int], slice], str], ...] = (
        (half, lambda count: slice((count + 1) // 2), "here half of them, rounded up"),
        (half, lambda count: slice(None, None, 2), "here every second one"),
        (half, lambda count: slice(2), "here the first two of each shape"),
        (half, lambda count: slice(1), "here the first of each shape"),
        (opened, lambda count: slice(1, count), "here without the first edge"),
    )
    for name, cut, words in cuts:
        yield name, Written(partial(of_each, cut)), words
    yield opened, Written(partial(listed, cut_a=slice(-1))), "here for A alone"
    yield opened, Written(partial(listed, cut_b=slice(-1))), "here for B alone"
    yield "one-shapes-normals", Written(partial(listed, cut_a=slice(0))), "here those of B"
    yield "same-shape", Written(one_for_equal_counts), "here for shapes with equally many corners"
    yield one, Written(lambda a, b: of_world(a, b)[:1]), "here on the x axis"
    yield one, Written(partial(one_edge, 0)), "here on the normal of the first edge"
    yield one, Written(partial(one_edge, -1)), "here on the normal of the last edge"
    for in_order in False, True:
        yield one, Written(any_axis=True, in_order=in_order), "here on any one of them"
    for middle in mean, middle_of_box:
        yield one, Written(partial(between, middle)), "here on the line between the middles"
    along = "here an edge is taken as an axis, without the quarter turn"
    yield "line-for-axis", Written(partial(listed, turn=Vec)), along
    yield "line-for-axis", Written(partial(of_vertices, Vec)), "here the way to each vertex"
    yield "slipped-normal", Written(partial(of_vertices, normal)), "here of each vertex instead of each edge"
    yield "slipped-normal", Written(partial(listed, turn=lambda x, y: Vec(y, x))), "here (dy, dx), without the minus"
    yield "degrees-for-radians", Written(partial(listed, turn=angle_in_degrees)), "here the whole angle in degrees"
    roundings: tuple[tuple[Callable[[float], float], str], ...] = (
        (round, ""),
        (partial(round, ndigits=1), "here to 1 digit"),
        (partial(round, ndigits=2), "here to 2 digits"),
        (int, "here the digits are cut off"),
        (floor, "here down"),
    )
    for rounding, words in roundings:
        for power in 0, 1:
            rounded = Written(partial(listed, turn=partial(rounded_to, rounding)), powers=(0, power))
            yield "rounded-normals", rounded, words


def _measured() -> Iterator[Variant]:
    """Yield the mistakes in a range on an axis, or in the overlap of two ranges."""
    for axes, words in (
        (partial(listed, sign=1), "here on the normal of each edge"),
        (partial(listed, sign=-1), "here on the normal of each edge"),
        (of_world, "here on x and y"),
    ):
        yield "start-at-zero", Written(axes, from_zero), words
        yield "one-sided-gap", Written(axes, overlap=a_before_b), words
    yield "start-at-zero", Written(ends=both_from_zero), "here the search for the smallest, too"
    yield "lengths", Written(ends=without_signs), "here of each end of a range"
    yield "bounding-circles", Written(ends=about_the_mean), "here on each axis, about the middle of each range"
    yield "corner-inside", Written(overlap=by_an_end_of_a), "here an end of A's range in B's, on each axis"
    yield "corner-inside", Written(overlap=by_an_end_of_b), "here an end of B's range in A's, on each axis"
    for middle, radius in (*LARGE_RADII, *SMALL_RADII):
        yield "bounding-circles", Written(partial(between, middle), partial(circle_about, middle, radius)), ""
    for step in (1, -1):
        yield "extremes-once", Written(ends=partial(one_extreme_each, step)), ""
    yield "extremes-once", Written(ends=partial(some_vertices, slice(-1))), "here without the last vertex"
    yield "extremes-once", Written(ends=partial(some_vertices, slice(1, None))), "here without the first vertex"
    for round_to in round, int, floor:
        yield "rounded-normals", Written(ends=partial(rounded_landings, round_to)), "here the landing places"
    yield "integer-halves", Written(of_world, partial(half_is_whole, False)), "here beside an exact middle"
    for whole_middle in True, False:
        yield "integer-halves", Written(ends=partial(half_is_whole, whole_middle)), "here on each axis"
    yield "aabb-not-upright", Written(of_world, twice_as_wide), "here with the whole widths for half of them"


def _pushed() -> Iterator[Variant]:
    """Yield the mistakes in the choice of the push."""
    late = "here divided only after the axis was chosen"
    yield "raw-depth", Written(powers=(0, 2)), late
    yield "raw-depth", Written(powers=(0, 0)), "here the normal of the move is as long as its edge, too"
    yield "raw-depth", Written(powers=(1, 1)), "here the normal of the move is as long as its edge"
    for power in 3, 4:
        yield "raw-depth", Written(powers=(2, power)), "here divided by the square of the length"
    yield "largest-overlap", Written(pick=-1), ""
    for axes in listed, lambda a, b: listed(b, a):
        yield "largest-overlap", Written(axes, pick=-1, in_order=True), "here along the last axis"
        yield "largest-overlap", Written(axes, pick=0, in_order=True), "here along the first axis"
    for sign in 1, -1:
        yield "push-along-normal", Written(way=partial(along_normal, sign)), ""
        as_listed = Written(partial(outward, sign), way=partial(along_normal, 1))
        yield "push-along-normal", as_listed, "here away from the shape with the edge, in one order of the vertices"
        as_listed = Written(partial(outward, sign), overlap=a_before_b, way=partial(along_normal, 1))
        yield "one-sided-gap", as_listed, "here away from the shape with the edge, in one order of the vertices"
    for middle, words in (
        (middle_of_box, "here from the middle of the bounding box"),
        (itemgetter(0), "here from the first vertex"),
    ):
        yield "push-from-center", Written(way=partial(from_middle, middle)), words


def _other_ways() -> Iterator[Variant]:
    """Yield the mistakes of other methods than SAT."""
    yield "corner-inside", middle_inside, "here the middle of one"
    yield "corner-inside", partial(corners_in, "B"), "here a corner of A in B alone"
    yield "corner-inside", partial(corners_in, "A"), "here a corner of B in A alone"
    yield "corner-inside", first_corner_in, "here the first corner of one"
    for gap_of, words in (
        (nearest_corner, "here a corner in the circle"),
        (center_outside, "here the center in the polygon"),
        (corner_or_center, "here the center of the circle, too"),
    ):
        yield "corner-inside", partial(with_circle, gap_of), words
    yield "aabb-not-upright", partial(with_circle, box_and_circle), "here beside a circle"
    yield (
        "no-nearest-vertex",
        partial(with_circle, raw_radius),
        "here with a radius that is not scaled like the normals",
    )
    to_center = NAMED["no-nearest-vertex"].shortcut._replace(choose=normals_and_centers)
    yield "no-nearest-vertex", partial(by_shortcut, to_center), "here the line of the centers, too"
    yield "edges-cross", rims_meet, "here the rims of circles"
    for strict, words in ((False, "here by the signs of their turns"), (True, "here at a point inside both edges")):
        yield "edges-cross", partial(edges_turn, strict), words
    yield "circles-turned-round", squared_distance, "here the squared distance is compared"
    yield "circles-turned-round", reversed_verdict, "here the whole verdict, for shapes of any kind"
    outward = NAMED["mixed-signs"].shortcut._replace(choose=edge_normals, measure=outward_from_each_middle)
    yield "mixed-signs", partial(by_shortcut, outward), "here away from the middle of each shape"
    along_line = NAMED["push-from-center"].shortcut._replace(push=push_along_centers)
    yield "push-from-center", partial(by_shortcut, along_line), "here along the line between the middles"
    for middle, radius in SMALL_RADII:
        sum_of = partial(_sum_of, radius)
        yield "far-centers", partial(beyond_reach, middle, sum_of), "here further than the reach of both shapes"
    for middle, radius in LARGE_RADII:
        largest = partial(_largest, radius)
        yield "far-centers", partial(beyond_reach, middle, largest), "here further than the larger reach"
    for reach in FIXED_REACHES:
        fixed = partial(_fixed, float(reach))
        yield "far-centers", partial(beyond_reach, mean, fixed), f"here further than {reach}"
        yield "bounding-circles", partial(within_reach, mean, fixed), "here of one size for all shapes"


def _sum_of(radius: Radius, a: Ring, b: Ring) -> float:
    """Return the sum of both radii."""
    return radius(a) + radius(b)


def _largest(radius: Radius, a: Ring, b: Ring) -> float:
    """Return the larger radius."""
    return max(radius(a), radius(b))


def _fixed(reach: float, a: Ring, b: Ring) -> float:
    """Return the reach, whatever the shapes."""
    return reach


VARIANTS: tuple[Variant, ...] = (*_chosen_edges(), *_measured(), *_pushed(), *_other_ways())
