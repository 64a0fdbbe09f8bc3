"""Where a shortcut lies as B moves: the moves of B for which its verdict is wrong, with exact boundaries.

B moved by d meets A exactly where d lies in A - B, and leaves no gap on an axis n where d . n lies between
two ends.  So both the truth and a shortcut are polygons in the plane of moves, and a lie is what one has and
the other has not.  (A circle's round rim is a polygon of many corners.)
"""

from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from math import cos, hypot, pi, sin
from typing import NamedTuple

from ...engine.axes import EDGE, GIVEN, HULL, SLIP, WORLD, Axis
from ...engine.concave import parts
from ...engine.geometry import Interval, Vec
from ...engine.sat import project
from ...engine.shapes import Circle, Shape, centroid
from ...engine.shortcut import Shortcut
from ..shortcuts import FAR, turned_round, unit_normals, within_reach
from .reading import moved

Ring = tuple[Vec, ...]
Window = tuple[float, float, float, float]
SAME = 1e-9  # ends that near to each other are one, rounded
ROUND = 64  # corners of a circle's rim
FIXED = EDGE, GIVEN, HULL, SLIP, WORLD  # axes that stay where they are while B moves


class Lies(NamedTuple):
    """Moves of B, as convex polygons: where a hit is claimed that is none, where one is missed, and all true hits.

    `touching`: are those moves missed, too, at which the shapes only touch, the rims of `hits`?
    """

    false_hits: tuple[Ring, ...]
    missed_hits: tuple[Ring, ...]
    hits: tuple[Ring, ...]
    touching: bool = False


def lies(a: Shape, b: Shape, shortcut: Shortcut, window: Window) -> Lies | None:
    """Where the shortcut's verdict is wrong, of the moves within the window (x0, y0, x1, y1).

    None where its axes turn as B moves, or where only rounding makes it wrong.
    """
    hits = tuple(within(hit, window) for hit in difference(a, b))
    if shortcut.measure is turned_round and a.radius and b.radius:
        return Lies(tuple(without(corners(window), hits)), hits, hits)
    claimed = _claimed(a, b, shortcut, window)
    if claimed is None:
        return None
    false = tuple(piece for ring in claimed for piece in without(ring, hits))
    missed = tuple(piece for i, hit in enumerate(hits) for piece in without(hit, (*claimed, *hits[:i])))
    return Lies(false, missed, tuple(filter(None, hits)), shortcut.touching_separates)


def difference(a: Shape, b: Shape) -> Iterator[Ring]:
    """A - B, a convex polygon for each pair of convex parts: the moves of B at which they meet."""
    for p in parts(a):
        for q in parts(b):
            r = p.radius + q.radius
            turns = (2 * pi * k / ROUND for k in range(ROUND)) if r else ()
            rim = [Vec(r * cos(t), r * sin(t)) for t in turns] or [Vec(0.0, 0.0)]
            yield _hull(Vec(u.x - v.x + w.x, u.y - v.y + w.y) for u in p.core for v in q.core for w in rim)


def _claimed(a: Shape, b: Shape, shortcut: Shortcut, window: Window) -> tuple[Ring, ...] | None:
    """The moves that the shortcut takes for hits."""
    whole: tuple[Ring, ...] = (corners(window),)
    if shortcut.split or shortcut.measure in (unit_normals, turned_round):
        return None
    axes = shortcut.choose(a, b).axes
    found = whole
    if shortcut.measure is within_reach:
        (px, py), (qx, qy) = centroid(a), centroid(b)
        near = next(difference(Circle((px, py), FAR / 2), Circle((qx, qy), FAR / 2)))
        found, axes = (within(near, window),), axes[1:]
    for axis in axes:
        if not any(axis.normal):
            continue  # on a zero axis there never is a gap
        if axis.source.kind not in FIXED:
            return None
        ends = _no_gap(a, b, shortcut, axis)
        u = axis.direction
        cut = (clipped(clipped(ring, u, hi), Vec(-u.x, -u.y), -lo) for ring in found for lo, hi in ends)
        found = tuple(ring for ring in cut if ring)
    return found


def _no_gap(a: Shape, b: Shape, shortcut: Shortcut, axis: Axis) -> list[Interval]:
    """How far B may move along an axis without a gap, as the shortcut measures it between all ends there can be.

    An end is where a landing of A meets one of B, with its own sign or the other.
    """
    u = axis.direction
    on_a, on_b = (project(shape, axis).landings for shape in (a, b))
    every = sorted({s * t - r for t in on_a for r in on_b for s in (1, -1)})
    ends = every[:1]
    for end in every:
        if end - ends[-1] > SAME * (every[-1] - every[0]):
            ends.append(end)
    found: list[Interval] = []
    for lo, hi in pairwise(ends):
        t = (lo + hi) / 2
        (there,) = shortcut.tests(a, moved(b, Vec(u.x * t, u.y * t)), [axis])
        if shortcut.separates(there):
            continue
        if found and found[-1].hi == lo:
            found[-1] = Interval(found[-1].lo, hi)
        else:
            found.append(Interval(lo, hi))
    return found


# -- convex polygons


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
    return tuple(found) if _area(found) > 0 else ()


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


def _area(ring: Sequence[Vec]) -> float:
    """Twice the area; what rounding leaves of a sliver counts as none."""
    if len(ring) < 3:
        return 0.0
    size = max(max(abs(c) for c in p) for p in ring)
    area = sum(p.x * q.y - p.y * q.x for p, q in zip(ring, (*ring[1:], ring[0]), strict=True))
    return area if area > 1e-12 * size * size else 0.0


def _hull(points: Iterable[Vec]) -> Ring:
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
