"""The way out of an overlap: moves of B, built or checked exactly to end it."""

from collections.abc import Callable, Iterable, Iterator
from fractions import Fraction
from functools import lru_cache, partial
from itertools import combinations
from math import frexp, inf, isfinite, isqrt, ldexp, nextafter
from typing import NamedTuple, TypeVar

from .axes import exact_dots
from .convex_parts import parts
from .geometry import InvalidScene, Relation, Vec
from .relate import relate_moved
from .sat import LARGEST, AxisTest
from .shapes import Shape

T = TypeVar("T")

NUDGES = (0.0, *(2.0**-e for e in range(52, 19, -2)))  # how far outwards a rounded move is helped, near size 1
ROUNDING = 2.0**-40
MAX_CORNERS = 4000  # of all pairs of parts: seconds at worst, most often far less


def ends_overlap(a: Shape, b: Shape, move: Vec) -> bool:
    """Exactly: once B has moved by `move`, do the shapes share no inner point any more?"""
    return all(relate_moved(p, q, move) != Relation.OVERLAPPING for p in parts(a) for q in parts(b))


def mtv_along_axis(a: Shape, b: Shape, test: AxisTest) -> Vec | None:
    """The shortest move of B along a test's axis that parts the ranges, each component rounded away from 0.

    Rounded so, the move is never too short.  None if it is beyond float64.
    """
    (nx, ny), dots_a, dots_b, radii, k = exact_dots(a, b, test.axis)
    up, down = max(dots_a) - min(dots_b), max(dots_b) - min(dots_a)
    square = nx * nx + ny * ny
    bits = 80
    rim = isqrt((radii * radii * square << 2 * bits) - 1) + 1 if radii else 0  # radii * |n|, rounded up
    depth = Fraction((min(up, down) << bits) + rim, square << (bits + k))
    way = 1 if up <= down else -1
    components = [_away_from_zero(way * n * depth) for n in (nx, ny)]
    return Vec(*components) if all(map(isfinite, components)) else None


def _away_from_zero(value: Fraction) -> float:
    try:
        rounded = float(value)
    except OverflowError:
        return inf
    if abs(Fraction(rounded)) < abs(value):
        rounded = nextafter(rounded, inf if value > 0 else -inf)
    return rounded


def why_too_many_parts(a: Shape, b: Shape) -> str:
    """Why `around_parts` will not look for a way out: it would take more than a moment; "" if it will."""
    sizes = [[len(part.core) for part in parts(s)] for s in (a, b)]
    pairs, corners = len(sizes[0]) * len(sizes[1]), sum(sizes[0]) * len(sizes[1]) + sum(sizes[1]) * len(sizes[0])
    if corners <= MAX_CORNERS:
        return ""
    return (
        f"{pairs:,} pairs of convex parts with {corners:,} corners: the shortest way out is looked for among "
        f"{MAX_CORNERS:,} at most; simplify the outlines, or part two of the parts (trace.colliding.mtv)"
    )


@lru_cache(maxsize=256)
def mtv_of_parts(a: Shape, b: Shape) -> Vec | None:
    """The shortest move of B that ends the overlap of shapes, one of them concave; None if beyond float64.

    B clears A when it clears every part of A with every part of its own.  Each part
    pair forbids the moves inside one convex region (the Minkowski difference of the
    two, rounded by the radius of a circle), so the shortest free move lies on a border:
    at a foot of the perpendicular, or where two borders cross.  They are tried from the
    shortest, each checked exactly.  Pushing the deepest part out is not enough: that
    may run into its neighbour.  InvalidScene if there are too many pairs of parts.
    """
    if reason := why_too_many_parts(a, b):
        raise InvalidScene(reason)
    # near size 1 nothing overflows; a power of two changes no digit, and moves are as long as the shapes are wide,
    # however far out they lie
    widths = (hi - lo for shape in (a, b) for lo, hi in zip(shape.bounds, shape.bounds[2:]))
    size = frexp(min(max(widths), LARGEST))[1]
    radius = ldexp(a.radius + b.radius, -size)
    free = _ShortestFreeMove(size, radius, [_make_region(p, q, size, radius) for p in parts(a) for q in parts(b)])
    borders = [border for region in free.regions for border in _borders(region.ring, radius)]
    free.try_all(c for border in borders for c in _nearest_candidates(border, radius))
    # what runs wholly inside one region is no border of the union
    outer = [border for border in borders if border.nearest < free.length and not free.buries(border)]
    free.try_all(c for one, other in combinations(outer, 2) for c in _crossing_candidates(one, other, radius))
    return free.move


class Region(NamedTuple):
    """Moves that bring part q into part p: all within the radius of a counter-clockwise ring.

    Here moves are complex numbers, in units of 2**size.  `sides`: outward (nx, ny) and offset of each side.
    """

    p: Shape
    q: Shape
    ring: list[complex]
    sides: list[tuple[float, float, float]]
    rounding: float  # how far a rounded border may lie from the true one


class Candidate(NamedTuple):
    """A move on the border, its length, and the way outwards there."""

    length: float
    move: complex
    out: complex


class Border(NamedTuple):
    """A piece of a region's border from p to q, the region to its left: a segment, or an arc round a corner."""

    nearest: float  # not farther than this from the origin
    p: complex
    q: complex
    normal: complex  # of a segment, outwards; 0 for an arc
    center: complex  # of an arc; of a segment, a point behind p
    hull: tuple[complex, ...]  # corners of what holds the piece

    def has(self, point: complex) -> bool:
        """Is a point of the segment's line or the arc's circle on the piece?"""
        room = -1e-9
        seen = point - self.center
        return _cross(self.p - self.center, seen) >= room and _cross(seen, self.q - self.center) >= room


class _ShortestFreeMove:
    """The shortest free move found so far, among all that the regions do not forbid."""

    def __init__(self, size: int, radius: float, regions: list[Region]) -> None:
        self.size, self.radius, self.regions = size, radius, regions
        self.length = inf
        self.move: Vec | None = None

    def try_all(self, candidates: Iterable[Candidate]) -> None:
        """Take the shortest that ends the overlap exactly, helped outwards by a rounding or two."""
        for length, move, out in sorted((c for c in candidates if c.length < self.length), key=lambda c: c.length):
            if self._forbidden(partial(self._holds, move=move)):
                continue
            for nudge in NUDGES:
                helped = self._scaled_back(move + out * nudge)
                if helped and not self._forbidden(partial(_parts_overlap, move=helped)):
                    self.length, self.move = length, helped
                    return

    def buries(self, border: Border) -> bool:
        """Does the piece lie well inside one region?  (A convex region that holds its hull's corners holds it.)"""
        return self._forbidden(lambda region: all(self._holds(region, corner) for corner in border.hull))

    def _forbidden(self, by: Callable[[Region], bool]) -> bool:
        """Is there a region that forbids?  It moves to the front, as the likeliest to forbid the next move too."""
        for i, region in enumerate(self.regions):
            if by(region):
                self.regions.insert(0, self.regions.pop(i))
                return True
        return False

    def _holds(self, region: Region, move: complex) -> bool:
        """Well inside: deeper than any rounding."""
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
            min(abs(_nearest_to_origin(p - move, q - move)) for p, q in _around(region.ring)) < radius - region.rounding
        )

    def _scaled_back(self, move: complex) -> Vec | None:
        try:
            return Vec(ldexp(move.real, self.size), ldexp(move.imag, self.size))
        except OverflowError:
            return None


def _parts_overlap(region: Region, move: Vec) -> bool:
    """Exactly: do the region's parts still overlap after the move?"""
    return relate_moved(region.p, region.q, move) is Relation.OVERLAPPING


def _make_region(p: Shape, q: Shape, size: int, radius: float) -> Region:
    core_p, core_q = ([complex(ldexp(x, -size), ldexp(y, -size)) for x, y in s.core] for s in (p, q))
    ring = _minkowski_sum(core_p, [-v for v in core_q])
    # what float64 let collapse at this size has no inside
    normals = [(u, -1j * (v - u) / abs(v - u)) for u, v in _around(ring)] if len(ring) > 2 else []
    sides = [(n.real, n.imag, n.real * u.real + n.imag * u.imag) for u, n in normals]
    return Region(p, q, ring, sides, ROUNDING * (max(map(abs, ring)) + radius))


def _minkowski_sum(p: list[complex], q: list[complex]) -> list[complex]:
    """The Minkowski sum of convex rings: their sides in the order of their directions.

    Rounded, since whatever comes of it is checked exactly.
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
    return u.real * v.imag - u.imag * v.real


def _around(ring: list[T]) -> Iterator[tuple[T, T]]:
    """Each with the next, round to the first."""
    return zip(ring, [*ring[1:], *ring[:1]], strict=True)


def _borders(ring: list[complex], radius: float) -> Iterator[Border]:
    """Each side pushed out by the radius, and round each corner an arc from one to the next."""
    sides = [(p, q, -1j * (q - p) / abs(q - p)) for p, q in _around(ring) if p != q]
    for (p, q, normal), (_, _, after) in _around(sides):
        start, end = p + normal * radius, q + normal * radius
        yield Border(abs(_nearest_to_origin(start, end)), start, end, normal, start - normal, (start, end))
        if radius:
            # no arc is longer than half round, so as far as the radius along the tangents at its ends is far enough
            last, ahead, back = q + after * radius, 1j * normal * radius, -1j * after * radius
            yield Border(abs(q) - radius, end, last, 0j, q, (end, end + ahead, last + back, last))


def _nearest_to_origin(p: complex, q: complex) -> complex:
    """The segment's point nearest to the origin."""
    way = q - p
    square = way.real * way.real + way.imag * way.imag
    t = -(p.real * way.real + p.imag * way.imag) / square if square else 0.0
    return p + min(1.0, max(0.0, t)) * way


def _nearest_candidates(border: Border, radius: float) -> Iterator[Candidate]:
    if border.normal:
        foot = _nearest_to_origin(border.p, border.q)
        yield Candidate(abs(foot), foot, border.normal)
    elif border.center:
        out = -border.center / abs(border.center)
        move = border.center + out * radius  # what is not on the arc is inside the region
        yield Candidate(abs(move), move, out)


def _crossing_candidates(one: Border, other: Border, radius: float) -> Iterator[Candidate]:
    if not one.normal:
        one, other = other, one
    for move in _line_points(one, other, radius) if one.normal else _circle_points(one.center, other.center, radius):
        if one.has(move) and other.has(move):
            out = sum(border.normal or (move - border.center) / radius for border in (one, other))
            yield Candidate(abs(move), move, out)


def _line_points(one: Border, other: Border, radius: float) -> Iterator[complex]:
    """Where a segment's line meets that of another, or the circle of an arc."""
    along = 1j * one.normal
    # seen along the first segment
    if other.normal:
        p, q = ((end - one.p) * along.conjugate() for end in (other.p, other.q))
        if p.imag != q.imag:
            yield one.p + along * (p.real + (q.real - p.real) * p.imag / (p.imag - q.imag))
    else:
        c = (other.center - one.p) * along.conjugate()
        if abs(c.imag) <= radius:
            half = (radius * radius - c.imag * c.imag) ** 0.5
            yield from (one.p + along * t for t in (c.real - half, c.real + half))


def _circle_points(c: complex, d: complex, radius: float) -> Iterator[complex]:
    """Where two circles of the one radius meet."""
    half = (d - c) / 2
    if 0 < abs(half) <= radius:
        aside = 1j * half / abs(half) * (radius * radius - abs(half) ** 2) ** 0.5
        yield from (c + half - aside, c + half + aside)
