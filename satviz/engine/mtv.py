"""The minimum translation vector (MTV) of an overlap: the shortest move of B that ends it.

For convex shapes it lies along a tested axis (`mtv_along_axis`); with a concave outline it is
searched for among the borders of all moves that would keep two parts overlapping (`mtv_of_parts`).
Each move is built or checked exactly to end the overlap.
"""

from collections.abc import Callable, Iterable, Iterator
from fractions import Fraction
from functools import lru_cache, partial
from itertools import combinations
from math import frexp, inf, isfinite, ldexp, nextafter
from typing import NamedTuple

from .axes import exact_dots
from .convex_parts import parts
from .geometry import InvalidScene, Relation, Vec, cyclic_pairs, nearest_fraction
from .predicates import MAX_FLOAT, ceil_sqrt
from .relate import relate_moved
from .sat import AxisTest
from .shapes import Shape

NUDGES = (0.0, *(2.0**-e for e in range(52, 1, -2)))  # lengths by which a rounded move is made longer, near size 1
ROUNDING = 2.0**-40  # error of a region's border near size 1: some roundings of 2**-53, with much to spare
NARROW = 2.0**-10  # length of the sum of two unit normals, nearly opposite, that border a slot
# the slope by which a direction along a slot is tilted: a circle's border bends away by t**2 / 2 over a length t, which
# is one rounding, 2**-53, at t = 2**-26
TILT = 2.0**-26
BORDER_TOLERANCE = 1e-9  # near size 1, by how much a crossing may miss the ends of a border
MAX_CORNERS = 4000  # corners over all pairs of convex parts: seconds at worst, most often far less


def ends_overlap(a: Shape, b: Shape, move: Vec) -> bool:
    """Return whether the shapes share no interior point once B has moved by exactly `move`."""
    return all(relate_moved(p, q, move) != Relation.OVERLAPPING for p in parts(a) for q in parts(b))


def mtv_along_axis(a: Shape, b: Shape, test: AxisTest) -> Vec | None:
    """Return the shortest move of B along a test's axis that ends the overlap of the ranges; None if beyond float64.

    Each component is rounded away from 0, so the move is never too short.
    """
    (nx, ny), dots_a, dots_b, radii, k = exact_dots(a, b, test.axis)
    up, down = max(dots_a) - min(dots_b), max(dots_b) - min(dots_a)
    square = nx * nx + ny * ny
    bits = 80
    radii_on_axis = ceil_sqrt(radii * radii * square << 2 * bits)  # radii * |n| in units of 2**-bits
    depth = Fraction((min(up, down) << bits) + radii_on_axis, square << (bits + k))
    direction = 1 if up <= down else -1
    components = [_round_away_from_zero(direction * n * depth) for n in (nx, ny)]
    return Vec(*components) if all(map(isfinite, components)) else None


def _round_away_from_zero(value: Fraction) -> float:
    """Return a fraction rounded to float64, away from 0; inf if it is beyond float64."""
    try:
        rounded = float(value)
    except OverflowError:
        return inf
    if abs(Fraction(rounded)) < abs(value):
        rounded = nextafter(rounded, inf if value > 0 else -inf)
    return rounded


def why_too_many_parts(a: Shape, b: Shape) -> str:
    """Return why `mtv_of_parts` refuses two shapes, naming the numbers and the limit; "" if it does not."""
    sizes = [[len(part.core) for part in parts(s)] for s in (a, b)]
    pairs, corners = len(sizes[0]) * len(sizes[1]), sum(sizes[0]) * len(sizes[1]) + sum(sizes[1]) * len(sizes[0])
    if corners <= MAX_CORNERS:
        return ""
    return (
        f"{pairs:,} pairs of convex parts with {corners:,} corners: the limit for the MTV is "
        f"{MAX_CORNERS:,} corners; simplify the outlines, or take the MTV of two parts (trace.colliding.mtv)"
    )


@lru_cache(maxsize=256)
def mtv_of_parts(a: Shape, b: Shape) -> Vec | None:
    """Return the shortest move of B that ends the overlap of shapes, one of them concave; None if beyond float64.

    The overlap has ended when no part of A overlaps any part of B.  Each pair of parts
    forbids the moves inside one convex region (the Minkowski difference of the
    two, widened by the radius of a circle), so the shortest free move lies on a border:
    at a foot of the perpendicular from the origin, or where two borders cross.  These are
    tried from the shortest on, each checked exactly.  Moving the deepest part out is not enough: it
    may run into its neighbour.  InvalidScene if there are too many pairs of parts.
    """
    if reason := why_too_many_parts(a, b):
        raise InvalidScene(reason)
    # scaled to size 1 nothing overflows, and a power of two changes no digit; moves are at most as long as the shapes
    # are wide, however far from the origin these are
    widths = (hi - lo for shape in (a, b) for lo, hi in zip(shape.bounds, shape.bounds[2:]))
    size = frexp(min(max(widths), MAX_FLOAT))[1]
    radius = ldexp(a.radius + b.radius, -size)
    search = _ShortestFreeMove(size, radius, [_make_region(p, q, size, radius) for p in parts(a) for q in parts(b)])
    borders = [border for region in search.regions for border in _borders(region.ring, radius)]
    search.try_all(c for border in borders for c in _nearest_candidates(border, radius))
    # a border wholly inside another region does not bound the union of all regions
    outer = [border for border in borders if border.nearest < search.length and not search.is_buried(border)]
    search.try_all(c for one, other in combinations(outer, 2) for c in _crossing_candidates(one, other, radius))
    return search.move


class Region(NamedTuple):
    """The moves that make part q overlap part p: all within the radius of a counter-clockwise ring.

    Here moves are complex numbers, in units of 2**size.  `sides`: outward unit normal (nx, ny) and offset of each.
    """

    p: Shape
    q: Shape
    ring: list[complex]
    sides: list[tuple[float, float, float]]
    rounding: float  # error bound of the border


class Candidate(NamedTuple):
    """A move to a region's border, its length, and a vector `out` of any length that points out of the region."""

    length: float
    move: complex
    out: complex
    error: float = 0.0  # how far the move may lie off, if more than by some roundings


class Border(NamedTuple):
    """A piece of a region's border from p to q, with the region on its left: a segment, or an arc around a corner."""

    nearest: float  # at most the distance of the piece from the origin
    p: complex
    q: complex
    normal: complex  # a segment's outward unit normal; 0 for an arc
    center: complex  # an arc's center; for a segment, a point inside the region from which p and q are seen
    hull: tuple[complex, ...]  # corners of a convex polygon that contains the piece

    def contains(self, point: complex, tolerance: float) -> bool:
        """Return whether a point of the segment's line, or of the arc's circle, lies between p and q, nearly."""
        seen = point - self.center
        after_p, before_q = _cross(self.p - self.center, seen), _cross(seen, self.q - self.center)
        return after_p >= -tolerance and before_q >= -tolerance


class _ShortestFreeMove:
    """The search for the shortest free move: one that no region forbids.  `size`, `radius`: as in `_make_region`."""

    def __init__(self, size: int, radius: float, regions: list[Region]) -> None:
        self.size, self.radius, self.regions = size, radius, regions
        self.length = inf
        self.move: Vec | None = None

    def try_all(self, candidates: Iterable[Candidate]) -> None:
        """Store in `move` the shortest candidate that ends the overlap, made longer along its `out` if needed."""
        for _, move, out, error in sorted((c for c in candidates if c.length < self.length), key=lambda c: c.length):
            for nudge in NUDGES:
                nudged = move + out * nudge
                if abs(nudged) >= self.length:
                    break
                if self._any_region(partial(self._certainly_forbids, move=nudged)):
                    if nudge >= error:
                        break
                    continue
                vector = self._to_scene_units(nudged)
                if vector and not self._any_region(partial(_parts_overlap, move=vector)):
                    self.length, self.move = abs(nudged), vector

    def is_buried(self, border: Border) -> bool:
        """Return whether a piece of border lies certainly inside one region, so it cannot matter."""
        return self._any_region(lambda region: all(self._certainly_forbids(region, c) for c in border.hull))

    def _any_region(self, forbids: Callable[[Region], bool]) -> bool:
        """Return whether `forbids` holds for any region; move that region to the front."""
        for i, region in enumerate(self.regions):
            if forbids(region):
                self.regions.insert(0, self.regions.pop(i))
                return True
        return False

    def _certainly_forbids(self, region: Region, move: complex) -> bool:
        """Return whether a move lies inside a region by more than its error bound."""
        x, y, radius = move.real, move.imag, self.radius
        beyond = -inf if region.sides else inf
        for nx, ny, offset in region.sides:
            outside = nx * x + ny * y - offset
            if outside > beyond:
                if outside > radius:
                    return False
                beyond = outside
        if beyond <= 0 or not radius:
            return beyond < radius - region.rounding
        return (
            min(abs(_nearest_to_origin(p - move, q - move)) for p, q in cyclic_pairs(region.ring))
            < radius - region.rounding
        )

    def _to_scene_units(self, move: complex) -> Vec | None:
        """Return a move in the scene's units; None if it is beyond float64."""
        try:
            return Vec(ldexp(move.real, self.size), ldexp(move.imag, self.size))
        except OverflowError:
            return None


def _parts_overlap(region: Region, move: Vec) -> bool:
    """Return whether the region's two parts overlap after exactly this move."""
    return relate_moved(region.p, region.q, move) is Relation.OVERLAPPING


def _make_region(p: Shape, q: Shape, size: int, radius: float) -> Region:
    """Return the moves of q for which convex p and q overlap, as a Region in units of 2**size.

    `radius`: the sum of both radii, in these units.
    """
    core_p, core_q = ([complex(ldexp(x, -size), ldexp(y, -size)) for x, y in s.core] for s in (p, q))
    ring = _minkowski_sum(core_p, [-v for v in core_q])
    # a ring that float64 collapsed to fewer than 3 points at this size has no inside
    normals = [(u, -1j * (v - u) / abs(v - u)) for u, v in cyclic_pairs(ring)] if len(ring) > 2 else []
    sides = [(n.real, n.imag, n.real * u.real + n.imag * u.imag) for u, n in normals]
    return Region(p, q, ring, sides, ROUNDING * (max(map(abs, ring)) + radius))


def _minkowski_sum(p: list[complex], q: list[complex]) -> list[complex]:
    """Return the Minkowski sum of two convex rings: the sides of both in the order of their directions.

    It is rounded; every move that comes of it is checked exactly.
    """
    p, q = (ring[i:] + ring[:i] for ring in (p, q) for i in [ring.index(min(ring, key=lambda v: (v.imag, v.real)))])
    found, i, j = [], 0, 0
    n, m = len(p), len(q)
    while i < n or j < m:
        found.append(p[i % len(p)] + q[j % len(q)])
        turn = _cross(p[(i + 1) % n] - p[i], q[(j + 1) % m] - q[j]) if i < n and j < m else n - i or j - m
        i, j = i + (turn >= 0), j + (turn <= 0)
    return list(dict.fromkeys(found))


def _cross(u: complex, v: complex) -> float:
    """Return the cross product of two vectors."""
    return u.real * v.imag - u.imag * v.real


def _borders(ring: list[complex], radius: float) -> Iterator[Border]:
    """Yield the border of a ring widened by the radius: each side moved outwards, an arc round each corner."""
    sides = [(p, q, -1j * (q - p) / abs(q - p)) for p, q in cyclic_pairs(ring) if p != q]
    for (p, q, normal), (_, _, after) in cyclic_pairs(sides):
        start, end = p + normal * radius, q + normal * radius
        yield Border(abs(_nearest_to_origin(start, end)), start, end, normal, start - normal, (start, end))
        if radius:
            # an arc is at most half a circle, so it is inside the hull of its ends and the points one radius along the
            # tangents there
            last, ahead, back = q + after * radius, 1j * normal * radius, -1j * after * radius
            yield Border(abs(q) - radius, end, last, 0j, q, (end, end + ahead, last + back, last))


def _nearest_to_origin(p: complex, q: complex) -> complex:
    """Return the segment's point nearest to the origin."""
    d = q - p
    t: float = nearest_fraction(p.real, p.imag, d.real, d.imag)
    return p + t * d


def _nearest_candidates(border: Border, radius: float) -> Iterator[Candidate]:
    """Yield the shortest move that reaches a piece of border; none for an arc round the origin."""
    if border.normal:
        foot = _nearest_to_origin(border.p, border.q)
        yield Candidate(abs(foot), foot, border.normal)
    elif border.center:
        out = -border.center / abs(border.center)
        move = border.center + out * radius  # where this is not on the arc, it is inside the region
        yield Candidate(abs(move), move, out)


def _crossing_candidates(one: Border, other: Border, radius: float) -> Iterator[Candidate]:
    """Yield the moves to the points where two pieces of border cross, as candidates."""
    if not one.normal:
        one, other = other, one
    for move in _line_points(one, other, radius) if one.normal else _circle_points(one.center, other.center, radius):
        m, n = (border.normal or (move - border.center) / radius for border in (one, other))
        outs, error, opening = [m + n], 0.0, abs(m + n)
        if opening < NARROW:
            # in a narrow slot the crossing is rounded far along it; the digits of m + n are wrong, but it is at right
            # angles to m - n; a way along the slot leaves an arc, which bends away, but a segment beyond which the
            # crossing was rounded only if it leads back across
            error = ROUNDING / max(opening, ROUNDING)
            outs = [way + back for way in (1j * (m - n), 1j * (n - m)) for back in (0, m * TILT)]
        if all(border.contains(move, max(error, BORDER_TOLERANCE)) for border in (one, other)):
            yield from (Candidate(abs(move), move, out, error) for out in outs)


def _line_points(one: Border, other: Border, radius: float) -> Iterator[complex]:
    """Yield the points where the line of segment `one` meets the line, or the circle, of `other`."""
    along = 1j * one.normal  # below, real parts run along the first segment
    if other.normal:
        p, q = ((end - one.p) * along.conjugate() for end in (other.p, other.q))
        if p.imag != q.imag:
            yield one.p + along * (p.real + (q.real - p.real) * p.imag / (p.imag - q.imag))
    else:
        c = (other.center - one.p) * along.conjugate()
        if abs(c.imag) <= radius + ROUNDING:
            half = max(0.0, radius * radius - c.imag * c.imag) ** 0.5
            yield from (one.p + along * t for t in (c.real - half, c.real + half))


def _circle_points(c: complex, d: complex, radius: float) -> Iterator[complex]:
    """Yield the two points where the circles of this radius round the centers c and d cross, or none.

    Where the circles touch, or miss each other by at most ROUNDING, the two points are equal.
    """
    half = (d - c) / 2
    if 0 < abs(half) <= radius + ROUNDING:
        aside = 1j * half / abs(half) * max(0.0, radius * radius - abs(half) ** 2) ** 0.5
        yield from (c + half - aside, c + half + aside)
