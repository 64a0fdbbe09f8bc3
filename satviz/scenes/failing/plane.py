"""Convex polygons in the plane of B's moves: counter-clockwise rings, cut and left out; () is none."""

from collections.abc import Iterable, Iterator, Sequence
from math import cos, hypot, pi, sin

from ...engine.convex_parts import parts
from ...engine.geometry import Vec
from ...engine.shapes import Shape

Ring = tuple[Vec, ...]
Window = tuple[float, float, float, float]
SAME = 1e-9  # what differs by so small a part of it all is one, rounded
ROUND = 64  # corners of a circle's rim


def difference(a: Shape, b: Shape) -> Iterator[Ring]:
    """A - B, a convex polygon for each pair of convex parts: the moves of B at which they meet."""
    for p in parts(a):
        for q in parts(b):
            r = p.radius + q.radius
            turns = (2 * pi * k / ROUND for k in range(ROUND)) if r else ()
            rim = [Vec(r * cos(t), r * sin(t)) for t in turns] or [Vec(0.0, 0.0)]
            yield hull(Vec(u.x - v.x + w.x, u.y - v.y + w.y) for u in p.core for v in q.core for w in rim)


def corners(window: Window) -> Ring:
    """A window as a ring, counter-clockwise."""
    x0, y0, x1, y1 = window
    return Vec(x0, y0), Vec(x1, y0), Vec(x1, y1), Vec(x0, y1)


def within(ring: Ring, window: Window) -> Ring:
    """The part of a convex ring inside a window."""
    x0, y0, x1, y1 = window
    for n, most in (Vec(1.0, 0.0), x1), (Vec(-1.0, 0.0), -x0), (Vec(0.0, 1.0), y1), (Vec(0.0, -1.0), -y0):
        ring = clipped(ring, n, most)
    return ring


def clipped(ring: Ring, n: Vec, most: float) -> Ring:
    """The part of a convex ring where p . n <= most; () if there is none."""
    sides = [p.x * n.x + p.y * n.y - most for p in ring]
    near = SAME * max(map(abs, sides), default=0.0)
    sides = [s if abs(s) > near else 0.0 for s in sides]  # a corner on the line is cut nowhere near itself
    found: list[Vec] = []
    for i, (p, s) in enumerate(zip(ring, sides, strict=True)):
        q, t = ring[i - 1], sides[i - 1]
        if s * t < 0:
            k = t / (t - s)
            found.append(Vec(q.x + (p.x - q.x) * k, q.y + (p.y - q.y) * k))
        if s <= 0:
            found.append(p)
    return tuple(found) if area(found) > 0 else ()


def without(ring: Ring, others: Sequence[Ring]) -> list[Ring]:
    """What is left of a convex ring outside others, in convex pieces."""
    left = [ring] if ring else []
    for other in filter(None, others):
        left = [piece for one in left for piece in _outside(one, other)]
    return left


def _outside(ring: Ring, other: Ring) -> Iterator[Ring]:
    rest = ring
    for p, q in zip(other, (*other[1:], other[0]), strict=True):
        n = Vec(q.y - p.y, p.x - q.x)
        size = hypot(*n)
        if not size or not rest:
            continue
        n = Vec(n.x / size, n.y / size)
        at = p.x * n.x + p.y * n.y
        if piece := clipped(rest, Vec(-n.x, -n.y), -at):
            yield piece
        rest = clipped(rest, n, at)


def area(ring: Sequence[Vec]) -> float:
    """Twice the area; what rounding leaves of a sliver counts as none."""
    if len(ring) < 3:
        return 0.0
    size = max(max(abs(c) for c in p) for p in ring)
    twice = sum(p.x * q.y - p.y * q.x for p, q in zip(ring, (*ring[1:], ring[0]), strict=True))
    return twice if twice > 1e-12 * size * size else 0.0


def hull(points: Iterable[Vec]) -> Ring:
    """The convex hull, counter-clockwise: Andrew's monotone chain."""
    order = sorted(set(points))

    def chain(of: Iterable[Vec]) -> list[Vec]:
        kept: list[Vec] = []
        for p in of:
            while len(kept) > 1 and _turn(kept[-2], kept[-1], p) <= 0:
                kept.pop()
            kept.append(p)
        return kept[:-1]

    return (*chain(order), *chain(reversed(order)))


def _turn(p: Vec, q: Vec, r: Vec) -> float:
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)
