"""The way out of an overlap: moves of B, built or checked exactly to end it."""

from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import lru_cache
from itertools import pairwise
from math import frexp, hypot, inf, isqrt, ldexp, nextafter
from typing import NamedTuple

from .axes import exact_normal
from .concave import parts
from .exact import aligned
from .geometry import Relation, Vec
from .sat import AxisTest
from .shapes import Circle, Polygon, Shape
from .verdict import relate_moved

NUDGES = (0.0, *(2.0**-e for e in range(52, 19, -2)))  # how far outwards a rounded move is helped, near size 1
ROUNDING = 2.0**-40
MOST_BORDERS = 400  # of the nearest border pieces that are crossed with each other


def ends_overlap(a: Shape, b: Shape, move: Vec) -> bool:
    """Exactly: once B has moved by `move`, do the shapes share no inner point any more?"""
    return all(relate_moved(p, q, move) != Relation.OVERLAPPING for p in parts(a) for q in parts(b))


def along_axis(a: Shape, b: Shape, test: AxisTest) -> Vec | None:
    """The shortest move of B along a test's axis that parts the ranges, each component rounded away from 0.

    Rounded so, the move is never too short.  None if it is beyond float64.
    """
    core_a, core_b, radii, k = aligned(a, b)
    nx, ny = exact_normal(test.axis, {"A": a, "B": b}, {"A": core_a, "B": core_b})
    dots_a, dots_b = ([nx * x + ny * y for x, y in core] for core in (core_a, core_b))
    up, down = max(dots_a) - min(dots_b), max(dots_b) - min(dots_a)
    square = nx * nx + ny * ny
    bits = 80
    rim = isqrt((radii * radii * square << 2 * bits) - 1) + 1 if radii else 0  # radii * |n|, rounded up
    depth = Fraction((min(up, down) << bits) + rim, square << (bits + k))
    way = 1 if up <= down else -1
    components = [_away_from_zero(way * n * depth) for n in (nx, ny)]
    return Vec(*components) if abs(components[0]) < inf and abs(components[1]) < inf else None


def _away_from_zero(value: Fraction) -> float:
    try:
        rounded = float(value)
    except OverflowError:
        return inf
    if abs(Fraction(rounded)) < abs(value):
        rounded = nextafter(rounded, inf if value > 0 else -inf)
    return rounded + 0.0


@lru_cache(maxsize=256)
def around_parts(a: Shape, b: Shape) -> Vec | None:
    """The shortest move of B found that ends the overlap of shapes with concave outlines; None if beyond float64.

    B clears A when it clears every part of A with every part of its own.  Each part
    pair forbids the moves inside one convex region (the Minkowski difference of the
    two, rounded by the radii), so the shortest free move lies on a border: at a foot
    of the perpendicular, or where two borders cross.  They are tried from the
    shortest, each checked exactly; only of outlines with very many parts are far
    crossings left out, and then the move may be longer than needed.  Pushing the
    deepest part out is not enough: that may run into its neighbour.
    """
    # at everyday size nothing overflows; a power of two changes no digit
    size = frexp(max(a._reach, b._reach))[1]
    near_one = [[_scaled(part, -size) for part in parts(shape)] for shape in (a, b)]
    regions = [_forbidden(p, q) for p in near_one[0] for q in near_one[1]]
    best = _nearest_free(regions, near_one)
    try:
        move = Vec(ldexp(best.x, size), ldexp(best.y, size))
    except OverflowError:
        return None
    return move if ends_overlap(a, b, move) else None


def _scaled(shape: Shape, e: int) -> Shape:
    if isinstance(shape, Circle):
        return Circle([ldexp(c, e) for c in shape.center], ldexp(shape.radius, e) or 5e-324)
    return Polygon([[ldexp(c, e) for c in v] for v in shape.corners])


class Region(NamedTuple):
    """Forbidden moves: a counter-clockwise ring (or fewer than three points) and everything within a radius of it."""

    ring: list[Vec]
    radius: float
    rounding: float  # how far a rounded border may lie from the true one


class Candidate(NamedTuple):
    """A move on the border, its length, and the way outwards there."""

    length: float
    move: Vec
    out: Vec


class Border(NamedTuple):
    """A piece of a region's border: a segment with its outward normal, or a whole circle (ends: its centre)."""

    nearest: float  # distance from the origin
    ends: tuple[Vec, Vec]
    normal: Vec
    radius: float  # 0 for a segment


def _forbidden(p: Shape, q: Shape) -> Region:
    """Moves of q into p: the hull of all differences, and the radius around it."""
    core_p, core_q = ((s.center,) if isinstance(s, Circle) else s.corners for s in (p, q))
    ring = _hull([Vec(u.x - v.x, u.y - v.y) for u in core_p for v in core_q])
    radius = sum(s.radius for s in (p, q) if isinstance(s, Circle))
    reach = max(abs(c) for v in ring for c in v)
    return Region(ring, radius, ROUNDING * (reach + radius))


def _hull(points: list[Vec]) -> list[Vec]:
    """Andrew's monotone chain; rounded, since whatever comes of it is checked exactly."""
    points = sorted(set(points))
    if len(points) < 3:
        return points

    def chain(ordered: Iterable[Vec]) -> list[Vec]:
        kept: list[Vec] = []
        for p in ordered:
            while len(kept) > 1 and _cross(kept[-2], kept[-1], p) <= 0:
                kept.pop()
            kept.append(p)
        return kept[:-1]

    return chain(points) + chain(reversed(points))


def _cross(o: Vec, p: Vec, q: Vec) -> float:
    return (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x)


def _nearest_free(regions: list[Region], near_one: list[list[Shape]]) -> Vec:
    """Try the border moves from the shortest: first the feet, which bound the rest, then the crossings."""
    borders = sorted(piece for region in regions for piece in _borders(region))
    best = Candidate(inf, Vec(inf, inf), Vec(0.0, 0.0))
    best = _first_free(sorted(c for piece in borders for c in _feet(piece)), regions, near_one, best)
    # what runs wholly inside one region is no border of the union
    outer = [piece for piece in borders if piece.nearest < best.length and not _buried(piece, regions)]
    crossings: list[Candidate] = []
    outer = outer[:MOST_BORDERS]
    for i, one in enumerate(outer):
        for other in outer[:i]:
            crossings += [c for c in _crossings(one, other) if c.length < best.length]
    return _first_free(sorted(crossings), regions, near_one, best).move


def _first_free(
    candidates: Sequence[Candidate], regions: list[Region], near_one: list[list[Shape]], best: Candidate
) -> Candidate:
    """The shortest candidate that ends the overlap exactly, helped outwards by a rounding or two; else `best`."""
    for length, move, out in candidates:
        if length >= best.length:
            break
        if _somewhere_inside(move, regions):
            continue
        for nudge in NUDGES:
            helped = Vec(move.x + out.x * nudge, move.y + out.y * nudge)
            if all(relate_moved(p, q, helped) != Relation.OVERLAPPING for p in near_one[0] for q in near_one[1]):
                return Candidate(length, helped, out)
    return best


def _borders(region: Region) -> Iterable[Border]:
    ring, radius, _ = region
    if radius:
        yield from (Border(abs(hypot(*v) - radius), (v, v), Vec(0.0, 0.0), radius) for v in ring)
    for p, q in _sides(ring):
        length = hypot(q.x - p.x, q.y - p.y)
        if length:
            n = Vec((q.y - p.y) / length, (p.x - q.x) / length)
            ends = tuple(Vec(v.x + n.x * radius, v.y + n.y * radius) for v in (p, q))
            yield Border(hypot(*_foot(*ends)), ends, n, 0.0)


def _foot(p: Vec, q: Vec) -> Vec:
    dx, dy = q.x - p.x, q.y - p.y
    square = dx * dx + dy * dy
    if not square:
        return p
    t = min(1.0, max(0.0, -(p.x * dx + p.y * dy) / square))
    return Vec(p.x + t * dx, p.y + t * dy)


def _candidate(move: Vec, *outs: Vec) -> Candidate:
    return Candidate(hypot(*move), move, Vec(sum(o.x for o in outs), sum(o.y for o in outs)))


def _feet(piece: Border) -> Iterable[Candidate]:
    (p, q), n, radius = piece.ends, piece.normal, piece.radius
    if not radius:
        yield from (_candidate(move, n) for move in {p, q, _foot(p, q)})
        return
    distance = hypot(*p)
    u = Vec(p.x / distance, p.y / distance) if distance else Vec(1.0, 0.0)
    for way in (-1, 1):
        yield _candidate(Vec(p.x + way * u.x * radius, p.y + way * u.y * radius), Vec(way * u.x, way * u.y))


def _crossings(one: Border, other: Border) -> Iterable[Candidate]:
    if one.radius and other.radius:
        points = _circle_circle(one.ends[0], one.radius, other.ends[0], other.radius)
    elif one.radius or other.radius:
        segment, circle = (other, one) if one.radius else (one, other)
        points = _line_circle(segment.ends, circle.ends[0], circle.radius)
    else:
        points = _segment_segment(one.ends, other.ends)
    for point in points:
        outs = (_outward(piece, point) for piece in (one, other))
        yield _candidate(point, *outs)


def _outward(piece: Border, point: Vec) -> Vec:
    if not piece.radius:
        return piece.normal
    c = piece.ends[0]
    return Vec((point.x - c.x) / piece.radius, (point.y - c.y) / piece.radius)


def _segment_segment(s: tuple[Vec, Vec], t: tuple[Vec, Vec]) -> Iterable[Vec]:
    (p, q), (u, v) = s, t
    dx, dy, ex, ey = q.x - p.x, q.y - p.y, v.x - u.x, v.y - u.y
    det = dx * ey - dy * ex
    if det:
        f = ((u.x - p.x) * ey - (u.y - p.y) * ex) / det
        g = ((u.x - p.x) * dy - (u.y - p.y) * dx) / det
        if -1e-9 <= f <= 1 + 1e-9 and -1e-9 <= g <= 1 + 1e-9:
            yield Vec(p.x + f * dx, p.y + f * dy)


def _line_circle(segment: tuple[Vec, Vec], center: Vec, radius: float) -> Iterable[Vec]:
    p, q = segment
    length = hypot(q.x - p.x, q.y - p.y)
    dx, dy = (q.x - p.x) / length, (q.y - p.y) / length
    along = (center.x - p.x) * dx + (center.y - p.y) * dy
    aside = (center.x - p.x) * dy - (center.y - p.y) * dx
    if abs(aside) <= radius:
        half = (radius * radius - aside * aside) ** 0.5
        for t in (along - half, along + half):
            if 0 <= t <= length:
                yield Vec(p.x + t * dx, p.y + t * dy)


def _circle_circle(c: Vec, r: float, d: Vec, s: float) -> Iterable[Vec]:
    dx, dy = d.x - c.x, d.y - c.y
    distance = hypot(dx, dy)
    if abs(r - s) < distance <= r + s:
        along = (distance * distance + r * r - s * s) / (2 * distance)
        half = max(0.0, r * r - along * along) ** 0.5
        for h in (-half, half):
            yield Vec(c.x + (along * dx - h * dy) / distance, c.y + (along * dy + h * dx) / distance)


def _buried(piece: Border, regions: list[Region]) -> bool:
    """Does the whole piece lie well inside one region?  (A convex region that holds both ends holds all between.)"""
    if piece.radius:
        return False
    return any(all(_inside(end, region) for end in piece.ends) for region in regions)


def _somewhere_inside(move: Vec, regions: list[Region]) -> bool:
    """Surely forbidden: a cheap look before the exact one; the region that forbids moves to the front."""
    for i, region in enumerate(regions):
        if _inside(move, region):
            regions.insert(0, regions.pop(i))
            return True
    return False


def _inside(move: Vec, region: Region) -> bool:
    """Well inside: deeper than any rounding."""
    ring, radius, rounding = region
    if len(ring) > 2:
        depth = inf
        for p, q in _sides(ring):
            depth = min(depth, _cross(p, q, move) / hypot(q.x - p.x, q.y - p.y))
            if depth < -radius:
                return False
        if depth >= 0:
            return depth + radius > rounding
    if not radius:
        return False
    near = (_foot(Vec(p.x - move.x, p.y - move.y), Vec(q.x - move.x, q.y - move.y)) for p, q in _sides(ring))
    return min(hypot(*foot) for foot in near) < radius - rounding


def _sides(ring: list[Vec]) -> Iterable[tuple[Vec, Vec]]:
    """From each corner to the next, round to the first."""
    return pairwise((*ring, ring[0]))
