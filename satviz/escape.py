"""The way out of an overlap: moves of B, checked exactly to end it."""

from collections.abc import Iterable, Sequence
from functools import lru_cache
from itertools import combinations
from math import hypot

from .concave import parts
from .geometry import Relation, Vec
from .shapes import Circle, Shape
from .verdict import relate_moved

# A rounded vector can fall short by a rounding: lengthen it by ever more until the exact check is content.
STRETCHES = (1.0, *(1 + 2.0**-e for e in range(52, 22, -3)))


def ends_overlap(a: Shape, b: Shape, move: Vec) -> bool:
    """Exactly: once B has moved by `move`, do the shapes share no inner point any more?"""
    return all(relate_moved(p, q, move) != Relation.OVERLAPPING for p in parts(a) for q in parts(b))


def lengthened(a: Shape, b: Shape, move: Vec) -> Vec | None:
    """The move itself, or the least lengthening tried that exactly ends the overlap; None if none does."""
    for stretch in STRETCHES:
        longer = Vec(move.x * stretch, move.y * stretch)
        if ends_overlap(a, b, longer):
            return longer
    return None


@lru_cache(maxsize=256)
def around_parts(a: Shape, b: Shape) -> Vec:
    """The shortest move of B that ends the overlap of shapes with concave outlines.

    B clears A when it clears every part of A with every part of its own.  Each part
    pair forbids the moves inside one convex region (the Minkowski difference of the
    two, rounded by the radii), so the shortest free move lies on a border: at a foot
    of the perpendicular, a nearest point of an arc, or where two borders cross.  They
    are tried from the shortest, each checked exactly.  Pushing the deepest part out
    is not enough: that may run into its neighbour.
    """
    regions = [_forbidden(p, q) for p in parts(a) for q in parts(b)]
    moves = sorted(set(_border_moves(regions)), key=lambda m: (hypot(*m), m))
    for move in moves:
        if not any(_well_inside(move, ring, radius) for ring, radius in regions):
            free = lengthened(a, b, move)
            if free is not None:
                return free
    raise AssertionError("no border move is free: the moves beyond all regions must be")


Region = tuple[list[Vec], float]


def _forbidden(p: Shape, q: Shape) -> Region:
    """Moves of q into p: the counter-clockwise hull of all differences, and the radius around it."""
    core_p, core_q = _core(p), _core(q)
    ring = _hull([Vec(u.x - v.x, u.y - v.y) for u in core_p for v in core_q])
    return ring, sum(s.radius for s in (p, q) if isinstance(s, Circle))


def _core(shape: Shape) -> Sequence[Vec]:
    return (shape.center,) if isinstance(shape, Circle) else shape.corners


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


def _border_moves(regions: list[Region]) -> Iterable[Vec]:
    """Every move that can be the nearest border point of the union of the regions."""
    segments: list[tuple[Vec, Vec]] = []
    arcs: list[tuple[Vec, float]] = []
    for ring, radius in regions:
        arcs += [(v, radius) for v in ring if radius]
        for p, q in zip(ring, [*ring[1:], ring[0]]):
            length = hypot(q.x - p.x, q.y - p.y)
            if length:
                nx, ny = (q.y - p.y) / length * radius, (p.x - q.x) / length * radius
                segments.append((Vec(p.x + nx, p.y + ny), Vec(q.x + nx, q.y + ny)))
    for p, q in segments:
        yield from (p, q, _foot(p, q))
    for center, radius in arcs:
        yield from _toward_origin(center, radius)
    for s, t in combinations(segments, 2):
        yield from _crossing(s, t)
    for center, radius in arcs:
        for segment in segments:
            yield from _line_circle(segment, center, radius)
    for one, other in combinations(arcs, 2):
        yield from _circle_circle(one, other)


def _foot(p: Vec, q: Vec) -> Vec:
    dx, dy = q.x - p.x, q.y - p.y
    t = min(1.0, max(0.0, -(p.x * dx + p.y * dy) / (dx * dx + dy * dy)))
    return Vec(p.x + t * dx, p.y + t * dy)


def _toward_origin(center: Vec, radius: float) -> Iterable[Vec]:
    distance = hypot(*center)
    ux, uy = (center.x / distance, center.y / distance) if distance else (1.0, 0.0)
    for r in (distance - radius, distance + radius):
        yield Vec(ux * r, uy * r)


def _crossing(s: tuple[Vec, Vec], t: tuple[Vec, Vec]) -> Iterable[Vec]:
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


def _circle_circle(one: tuple[Vec, float], other: tuple[Vec, float]) -> Iterable[Vec]:
    (c, r), (d, s) = one, other
    dx, dy = d.x - c.x, d.y - c.y
    distance = hypot(dx, dy)
    if abs(r - s) < distance <= r + s:
        along = (distance * distance + r * r - s * s) / (2 * distance)
        half = max(0.0, r * r - along * along) ** 0.5
        for h in (-half, half):
            yield Vec(c.x + (along * dx - h * dy) / distance, c.y + (along * dy + h * dx) / distance)


def _well_inside(move: Vec, ring: list[Vec], radius: float) -> bool:
    """Surely forbidden: a cheap look before the exact one."""
    depth = min(_depths(move, ring), default=-1.0) if len(ring) > 2 else -1.0
    if depth >= 0 and (depth > 0 or radius):
        return depth + radius > 1e-9 * (abs(move.x) + abs(move.y) + radius)
    near = min(hypot(*_offset(move, p, q)) for p, q in zip(ring, [*ring[1:], ring[0]]))
    return near < radius * (1 - 1e-9)


def _depths(move: Vec, ring: list[Vec]) -> Iterable[float]:
    for p, q in zip(ring, [*ring[1:], ring[0]]):
        yield _cross(p, q, move) / (hypot(q.x - p.x, q.y - p.y) or 1.0)


def _offset(move: Vec, p: Vec, q: Vec) -> Vec:
    here = Vec(p.x - move.x, p.y - move.y), Vec(q.x - move.x, q.y - move.y)
    return here[0] if p == q else _foot(*here)
