"""Convex polygons in the plane of B's moves, and the error region that is made of them.

A point d of this plane stands for the pair of shapes with B moved by d.  Polygons are counter-clockwise rings of
vertices; the empty ring () has no area.  A window is the upright box of moves for which an error region is computed.
"""

from collections.abc import Iterable, Iterator, Sequence
from math import cos, hypot, pi, sin
from typing import NamedTuple

from ...engine.convex_parts import parts
from ...engine.geometry import Vec
from ...engine.predicates import orient_det
from ...engine.shapes import Shape

ConvexRing = tuple[Vec, ...]
Window = tuple[float, float, float, float]  # x0, y0, x1, y1 of an upright box of moves
TOLERANCE = 1e-9  # numbers that differ by this part of the largest one are taken as equal: floats, rounded often
CIRCLE_CORNERS = 64  # corners of the polygon that stands for a circle's rim


class ErrorRegion(NamedTuple):
    """The moves of B for which a shortcut's answer is wrong, and all true hits, as convex polygons.

    `false_hits`: moves for which the shortcut claims a hit that is none; `missed_hits`: moves whose hit it misses;
    `hits`: the moves for which the shapes meet.
    `touching`: the shortcut also misses the moves at which the shapes only touch, which are the rims of `hits`.
    `numbers`: for a shortcut about a number, the moves for which this number is wrong.
    """

    false_hits: tuple[ConvexRing, ...]
    missed_hits: tuple[ConvexRing, ...]
    hits: tuple[ConvexRing, ...]
    touching: bool = False
    numbers: tuple[ConvexRing, ...] = ()


RegionOrReason = ErrorRegion | str  # a text says why no area shows where the answer is wrong; it follows a colon


def minkowski_difference(a: Shape, b: Shape) -> Iterator[ConvexRing]:
    """Yield, for each pair of convex parts, the moves of B for which they meet: A - B, as a ring.

    A circle counts as a polygon of CIRCLE_CORNERS corners inside it.
    """
    for p in parts(a):
        for q in parts(b):
            r = p.radius + q.radius
            turns = (2 * pi * k / CIRCLE_CORNERS for k in range(CIRCLE_CORNERS)) if r else ()
            rim = [Vec(r * cos(t), r * sin(t)) for t in turns] or [Vec(0.0, 0.0)]
            yield convex_hull(Vec(u.x - v.x + w.x, u.y - v.y + w.y) for u in p.core for v in q.core for w in rim)


def hits_in_window(a: Shape, b: Shape, window: Window) -> tuple[ConvexRing, ...]:
    """Return the moves in the window for which the shapes meet: one ring, perhaps (), per pair of parts."""
    return tuple(clip_to_window(ring, window) for ring in minkowski_difference(a, b))


def wrong_number_region(a: Shape, b: Shape, window: Window, rings: Iterable[ConvexRing]) -> ErrorRegion:
    """Return the ErrorRegion of a shortcut that gives a number (a depth, a distance, a push), not a relation.

    rings: the moves of B for which this number is wrong.
    """
    hits = tuple(filter(None, hits_in_window(a, b, window)))
    return ErrorRegion((), (), hits, numbers=tuple(filter(None, rings)))


def window_ring(window: Window) -> ConvexRing:
    """Return a window as a counter-clockwise ring."""
    x0, y0, x1, y1 = window
    return Vec(x0, y0), Vec(x1, y0), Vec(x1, y1), Vec(x0, y1)


def clip_to_window(ring: ConvexRing, window: Window) -> ConvexRing:
    """Return the part of a convex ring inside a window."""
    x0, y0, x1, y1 = window
    for n, limit in (Vec(1.0, 0.0), x1), (Vec(-1.0, 0.0), -x0), (Vec(0.0, 1.0), y1), (Vec(0.0, -1.0), -y0):
        ring = clip_to_half_plane(ring, n, limit)
    return ring


def clip_to_half_plane(ring: ConvexRing, n: Vec, limit: float) -> ConvexRing:
    """Return the part of a convex ring where p . n <= limit (Sutherland, Hodgman); () if without area."""
    sides = [p.x * n.x + p.y * n.y - limit for p in ring]
    tolerance = TOLERANCE * max(map(abs, sides), default=0.0)
    sides = [s if abs(s) > tolerance else 0.0 for s in sides]  # an edge that ends on the line is not cut near its end
    found: list[Vec] = []
    for i, (p, s) in enumerate(zip(ring, sides, strict=True)):
        q, t = ring[i - 1], sides[i - 1]
        if s * t < 0:
            k = t / (t - s)
            found.append(Vec(q.x + (p.x - q.x) * k, q.y + (p.y - q.y) * k))
        if s <= 0:
            found.append(p)
    return tuple(found) if twice_area(found) > 0 else ()


def subtract(ring: ConvexRing, others: Sequence[ConvexRing]) -> list[ConvexRing]:
    """Return convex pieces that make up the part of a convex ring outside all the others."""
    left = [ring] if ring else []
    for other in filter(None, others):
        left = [piece for one in left for piece in _subtract_one(one, other)]
    return left


def _subtract_one(ring: ConvexRing, other: ConvexRing) -> Iterator[ConvexRing]:
    """Yield convex pieces that make up the part of a ring outside another: one beyond each edge of the other."""
    rest = ring
    for p, q in zip(other, (*other[1:], other[0]), strict=True):
        n = Vec(q.y - p.y, p.x - q.x)
        length = hypot(*n)
        if not length or not rest:
            continue
        n = Vec(n.x / length, n.y / length)
        limit = p.x * n.x + p.y * n.y
        if piece := clip_to_half_plane(rest, Vec(-n.x, -n.y), -limit):
            yield piece
        rest = clip_to_half_plane(rest, n, limit)


def twice_area(ring: Sequence[Vec]) -> float:
    """Return twice the area of a counter-clockwise ring; 0 for a sliver that may be rounding alone."""
    if len(ring) < 3:
        return 0.0
    size = max(max(abs(c) for c in p) for p in ring)
    twice = sum(p.x * q.y - p.y * q.x for p, q in zip(ring, (*ring[1:], ring[0]), strict=True))
    return twice if twice > 1e-12 * size * size else 0.0


def convex_hull(points: Iterable[Vec]) -> ConvexRing:
    """Return the convex hull, counter-clockwise: Andrew's monotone chain."""
    order = sorted(set(points))

    def chain(in_order: Iterable[Vec]) -> list[Vec]:
        """Return one half of the hull, of points in sorted order, without its last point."""
        kept: list[Vec] = []
        for p in in_order:
            while len(kept) > 1 and orient_det(kept[-2], kept[-1], p) <= 0:
                kept.pop()
            kept.append(p)
        return kept[:-1]

    return (*chain(order), *chain(reversed(order)))
