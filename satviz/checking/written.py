"""SAT as people write it, in plain floats: one record whose steps can be replaced, the wrong steps, and their names."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from math import atan2, cos, degrees, dist, floor, hypot, inf, sin
from operator import itemgetter
from typing import NamedTuple

from ..engine.geometry import APART, OVERLAPPING, TOUCHING, Interval, Relation, Vec
from ..engine.shapes import Shape
from ..scenes.failing.wrong_projections import whole_halves

Ring = Sequence[Vec]
Predict = Callable[[Shape, Shape], tuple[Relation, Vec | None]]  # the claimed relation, and the push of B
Variant = tuple[str, Predict, str]  # the name of the failing case, what it claims, in which way it is made
Middle = Callable[[Ring], Vec]
Radius = Callable[[Ring], float]


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
    normal_of: Callable[[float, float], Vec] = normal,
    sign: int = 1,
    cut_a: slice = slice(None),
    cut_b: slice = slice(None),
) -> list[Vec]:
    """Return `normal_of` each edge vector of A and of B, in the order in which the vertices are listed.

    `sign`: -1 for the opposites; `cut_a`, `cut_b`: the edges that are taken.
    """
    found = []
    for ring, cut in (a, cut_a), (b, cut_b):
        for p, q in list(zip(ring, (*ring[1:], *ring[:1])))[cut]:
            if p != q:  # a vertex that is listed twice is another mistake
                x, y = normal_of(q.x - p.x, q.y - p.y)
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

    `axes`: returns the axes of two rings, vectors of any length; `ends`: the range of a ring on an axis; `overlap`:
    that of two ranges.  `powers` = (p, q): overlaps are compared after division by |n|**p, and the push is n times the
    overlap divided by |n|**q.  `pick`: which axis gives the push, counted from the least overlap, or, with `in_order`,
    in the order of the axes; `way`: 1 for a push along the normal, else -1; `any_axis`: whether one overlap is enough
    for a hit.
    """

    axes: Callable[[Ring, Ring], Sequence[Vec]] = listed
    ends: Callable[[Ring, Vec], Interval] = ends
    overlap: Callable[[Interval, Interval], float] = nearer_end
    powers: tuple[int, int] = (1, 2)
    pick: int = 0
    in_order: bool = False
    way: Callable[[Ring, Ring, Overlap], int] = shorter_way
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
        size = self.way(p, q, picked) * picked.size / _length(picked.n) ** self.powers[1]
        return OVERLAPPING if least else TOUCHING, Vec(picked.n.x * size, picked.n.y * size)


def _length(n: Vec) -> float:
    """Return the length of a vector, 1 for (0, 0), to which a normal may be rounded."""
    return hypot(*n) or 1.0


# -- axes


def of_world(a: Ring, b: Ring) -> list[Vec]:
    """Return the world axes x and y, whatever the rings."""
    return [Vec(1.0, 0.0), Vec(0.0, 1.0)]


def between(middle: Middle, a: Ring, b: Ring) -> list[Vec]:
    """Return the line between the middles as the only axis; x where both are one point."""
    (ax, ay), (bx, by) = middle(a), middle(b)
    return [Vec(bx - ax, by - ay) if (ax, ay) != (bx, by) else Vec(1.0, 0.0)]


def by_direction(a: Ring, b: Ring) -> list[Vec]:
    """Return all normals in the order of their directions, by which Python's min() of tuples chooses among equals."""
    return sorted(listed(a, b), key=lambda n: (n.x / hypot(*n), n.y / hypot(*n)))


def of_each(cut: Callable[[int], slice], a: Ring, b: Ring) -> list[Vec]:
    """Return the normals of the edges that `cut` selects; it maps a ring's number of vertices to a slice."""
    return listed(a, b, cut_a=cut(len(a)), cut_b=cut(len(b)))


def of_vertices(normal_of: Callable[[float, float], Vec], a: Ring, b: Ring) -> list[Vec]:
    """Return `normal_of` each vertex, as if the vertex were the vector of an edge."""
    return [normal_of(*p) for ring in (a, b) for p in ring]


def normals_of_a_if_equal_counts(a: Ring, b: Ring) -> list[Vec]:
    """Return the normals of A alone where both rings have as many vertices, else of both."""
    return listed(a, b if len(a) != len(b) else ())


def outward(sign: int, a: Ring, b: Ring) -> list[Vec]:
    """Return the normals of A, and the opposites of B's, which all lead from A to B if both are counter-clockwise.

    `sign`: -1 for rings in clockwise order.
    """
    return [*listed(a, (), sign=sign), *listed((), b, sign=-sign)]


def angle_in_degrees(dx: float, dy: float) -> Vec:
    """Return the unit vector that an edge's normal becomes when its angle in degrees is passed to cos and sin."""
    angle = degrees(atan2(dy, dx)) + 90
    return Vec(cos(angle), sin(angle))


def rounded_to(round_to: Callable[[float], float], dx: float, dy: float) -> Vec:
    """Return the unit normal of an edge (dx, dy), to the right of it, with both numbers rounded by `round_to`."""
    length = hypot(dx, dy)
    return Vec(round_to(dy / length), round_to(-dx / length))


# -- ranges


def from_zero(ring: Ring, n: Vec) -> Interval:
    """Return the range of a ring whose maximum starts at 0 in the search, so it is never below 0."""
    lo, hi = ends(ring, n)
    return Interval(lo, max(0.0, hi))


def both_from_zero(ring: Ring, n: Vec) -> Interval:
    """Return the range of a ring whose minimum and maximum start at 0 in the search, so it always contains 0."""
    lo, hi = ends(ring, n)
    return Interval(min(0.0, lo), max(0.0, hi))


def about_the_mean(ring: Ring, n: Vec) -> Interval:
    """Return a range that reaches equally far to both sides of the vertex mean."""
    (at, _), (lo, hi) = ends([mean(ring)], n), ends(ring, n)
    reach = max(hi - at, at - lo)
    return Interval(at - reach, at + reach)


def circle_about(middle: Middle, radius: Radius, ring: Ring, n: Vec) -> Interval:
    """Return the range of a circle in place of the ring; `middle`, `radius`: functions of the ring."""
    (at, _), reach = ends([middle(ring)], n), radius(ring) * hypot(*n)
    return Interval(at - reach, at + reach)


def one_extreme_each(step: int, ring: Ring, n: Vec) -> Interval:
    """Return the range of four vertices alone: those of least and largest x and y; `step` -1: the last of equals."""
    return ends([pick(ring[::step], key=itemgetter(k)) for pick in (min, max) for k in (0, 1)], n)


def range_by_elif(sign: int, ring: Ring, n: Vec) -> Interval:
    """Return the range that the faulty loop `if t < lo ... elif t > hi ...` finds.

    A coordinate that becomes the minimum is never compared with the maximum.  `sign` -1 exchanges the two ends.
    """
    lo, hi = inf, -inf
    for p in ring:
        at = sign * (n.x * p.x + n.y * p.y)
        if at < lo:
            lo = at
        elif at > hi:
            hi = at
    return Interval(lo, hi) if sign == 1 else Interval(-hi, -lo)


def rounded_landings(round_to: Callable[[float], float], ring: Ring, n: Vec) -> Interval:
    """Return the range on n scaled to length 1, with both ends rounded, then multiplied by n's length."""
    length = hypot(*n)
    lo, hi = (length * round_to(end / length) for end in ends(ring, n))
    return Interval(lo, hi)


def shortened(slop: float, ring: Ring, n: Vec) -> Interval:
    """Return the range of a ring, shorter by slop / 2 at each end, so that small overlaps do not count."""
    (lo, hi), less = ends(ring, n), slop / 2 * hypot(*n)
    return Interval(lo + less, hi - less)


def half_is_whole(whole_middle: bool, ring: Ring, n: Vec) -> Interval:
    """Return the range left when half of its length, and its middle if `whole_middle`, are rounded down to integers."""
    return whole_halves(ends(ring, n), whole_middle)


def twice_as_wide(ring: Ring, n: Vec) -> Interval:
    """Return a range with the right middle and twice the right length."""
    lo, hi = ends(ring, n)
    return Interval((lo + hi) / 2 - (hi - lo), (lo + hi) / 2 + (hi - lo))


# -- overlaps


def a_before_b(a: Interval, b: Interval) -> float:
    """Return A's maximum minus B's minimum, a wrong depth if A lies above B."""
    return a.hi - b.lo


def by_an_end_of_a(a: Interval, b: Interval) -> float:
    """Return how deep an end of A's range lies inside B's range, at the deeper end; negative if both lie outside."""
    return max(min(b.hi - end, end - b.lo) for end in a)


# -- pushes


def along_normal(sign: int, a: Ring, b: Ring, found: Overlap) -> int:
    """Return `sign`, whatever the shapes: the push goes along the normal (1) or against it (-1)."""
    return sign


def from_middle(middle: Middle, a: Ring, b: Ring, found: Overlap) -> int:
    """Return 1 if the vector from the middle of A to that of B points along n, else -1."""
    (ax, ay), (bx, by) = middle(a), middle(b)
    return 1 if (bx - ax) * found.n.x + (by - ay) * found.n.y >= 0 else -1


# -- middles and radii


def mean(ring: Ring) -> Vec:
    """Return the mean of the vertices."""
    return Vec(sum(p.x for p in ring) / len(ring), sum(p.y for p in ring) / len(ring))


def sides(ring: Ring) -> tuple[float, float]:
    """Return (width, height) of the bounding box."""
    width, height = (max(axis) - min(axis) for axis in zip(*ring))
    return width, height


def middle_of_box(ring: Ring) -> Vec:
    """Return the middle of the bounding box."""
    return Vec(*((max(axis) + min(axis)) / 2 for axis in zip(*ring)))


def distances(ring: Ring) -> list[float]:
    """Return the distance of each vertex from the vertex mean."""
    return [dist(mean(ring), vertex) for vertex in ring]


LARGE_RADII: tuple[tuple[Middle, Radius], ...] = (  # (center, radius) of circles that hold the whole shape
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


# -- the ways in which people write a known mistake


def _chosen_edges() -> Iterator[Variant]:
    """Yield (name of a failing case, method, how it differs) for mistakes that leave out axes, or take others."""
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
    yield "same-shape", Written(normals_of_a_if_equal_counts), "here for shapes with equally many corners"
    yield one, Written(lambda a, b: of_world(a, b)[:1]), "here on the x axis"
    yield one, Written(lambda a, b: listed(a, b)[:1]), "here on the normal of the first edge"
    yield one, Written(lambda a, b: listed(a, b)[-1:]), "here on the normal of the last edge"
    yield one, Written(lambda a, b: listed(a, ())[-1:]), "here on the normal of the edge to A's first vertex"
    yield one, Written(lambda a, b: listed((), b)[-2:-1]), "here on the normal of the edge to B's last vertex"
    for in_order in False, True:
        yield one, Written(any_axis=True, in_order=in_order), "here on any one of them"
    for middle in mean, middle_of_box:
        yield one, Written(partial(between, middle)), "here on the line between the middles"
    along = "here an edge is taken as an axis, without the quarter turn"
    yield "line-for-axis", Written(partial(listed, normal_of=Vec)), along
    yield "line-for-axis", Written(partial(of_vertices, Vec)), "here the way to each vertex"
    yield "slipped-normal", Written(partial(of_vertices, normal)), "here of each vertex instead of each edge"
    yield (
        "slipped-normal",
        Written(partial(listed, normal_of=lambda x, y: Vec(y, x))),
        "here (dy, dx), without the minus",
    )
    yield "degrees-for-radians", Written(partial(listed, normal_of=angle_in_degrees)), "here the whole angle in degrees"
    roundings: tuple[tuple[Callable[[float], float], str], ...] = (
        (round, ""),
        (partial(round, ndigits=1), "here to 1 digit"),
        (partial(round, ndigits=2), "here to 2 digits"),
        (int, "here the digits are cut off"),
        (floor, "here down"),
    )
    for rounding, words in roundings:
        for power in 0, 1:
            rounded = Written(partial(listed, normal_of=partial(rounded_to, rounding)), powers=(0, power))
            yield "rounded-normals", rounded, words


def _measured() -> Iterator[Variant]:
    """Yield (name of a failing case, method, how it differs) for mistakes in a range, or in the overlap of two."""
    for axes, words in (
        (partial(listed, sign=1), "here on the normal of each edge"),
        (partial(listed, sign=-1), "here on the normal of each edge"),
        (of_world, "here on x and y"),
    ):
        yield "start-at-zero", Written(axes, from_zero), words
        yield "one-sided-gap", Written(axes, overlap=a_before_b), words
    yield "start-at-zero", Written(ends=both_from_zero), "here the search for the smallest, too"
    yield "bounding-circles", Written(ends=about_the_mean), "here on each axis, about the middle of each range"
    yield "corner-inside", Written(overlap=by_an_end_of_a), "here an end of A's range in B's, on each axis"
    by_an_end_of_b = Written(overlap=lambda a, b: by_an_end_of_a(b, a))
    yield "corner-inside", by_an_end_of_b, "here an end of B's range in A's, on each axis"
    for middle, radius in (*LARGE_RADII, *SMALL_RADII):
        yield "bounding-circles", Written(partial(between, middle), partial(circle_about, middle, radius)), ""
    for step in (1, -1):
        yield "extremes-once", Written(ends=partial(one_extreme_each, step)), ""
        yield (
            "extremes-once",
            Written(ends=partial(range_by_elif, step)),
            "here with an else between the two comparisons",
        )
    yield "extremes-once", Written(ends=lambda ring, n: ends(ring[:-1], n)), "here without the last vertex"
    yield "extremes-once", Written(ends=lambda ring, n: ends(ring[1:], n)), "here without the first vertex"
    for round_to in round, int, floor:
        yield "rounded-normals", Written(ends=partial(rounded_landings, round_to)), "here the landing places"
    for slop in 0.1, 0.25, 0.5, 1.0:
        yield "touch-as-apart", Written(ends=partial(shortened, slop)), f"here with a tolerance of about {slop:g}"
    yield "integer-halves", Written(of_world, partial(half_is_whole, False)), "here beside an exact middle"
    for whole_middle in True, False:
        yield "integer-halves", Written(ends=partial(half_is_whole, whole_middle)), "here on each axis"
    yield "aabb-not-upright", Written(of_world, twice_as_wide), "here with the whole widths for half of them"


def _pushed() -> Iterator[Variant]:
    """Yield (name of a failing case, method, how it differs) for mistakes in the choice of the push."""
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
        for axes in listed, by_direction:
            yield "push-along-normal", Written(axes, way=partial(along_normal, sign)), ""
        as_listed = Written(partial(outward, sign), way=partial(along_normal, 1))
        yield "push-along-normal", as_listed, "here away from the shape with the edge, in one order of the vertices"
        as_listed = Written(partial(outward, sign), overlap=a_before_b, way=partial(along_normal, 1))
        yield "one-sided-gap", as_listed, "here away from the shape with the edge, in one order of the vertices"
    for middle, words in (
        (middle_of_box, "here from the middle of the bounding box"),
        (itemgetter(0), "here from the first vertex"),
    ):
        yield "push-from-center", Written(way=partial(from_middle, middle)), words


VARIANTS: tuple[Variant, ...] = (*_chosen_edges(), *_measured(), *_pushed())
