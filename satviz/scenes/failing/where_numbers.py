"""Where a shortcut's number is wrong as B moves, for the rows that are about one: as polygons, or why there are none.

How far B would have to move out across an edge of A - B is linear in the move it has made, and the edge that is
nearest changes along straight lines.  So in every cell between those lines both numbers are one formula, and they are
the same formula or they differ (but for a line or a curve without an area).
"""

from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise, product
from math import hypot, isfinite
from typing import NamedTuple

from ...engine.axes import Axis, needed
from ...engine.convex_parts import parts
from ...engine.geometry import Vec
from ...engine.sat import project
from ...engine.shapes import Shape
from ..shortcuts import NAMED, middle
from . import swept
from .claimed_value import LEAST_OF_GJK
from .plane import SAME, Ring, Window, area, clipped, corners, difference, hull, within, without

Found = list[Ring] | str
MOST_CORNERS, MOST_OF_PIECES = 32, 12  # of both shapes: more cells than theirs take too long for a hand that drags

COUNT = "the count does not depend on where B is"
ROUNDING = "only rounding makes it wrong, at single places that no area can show"
CIRCLE = "of a circle the way out turns as B moves, so where the number is wrong has no straight edges"
DENT = "a shape has a dent, and where its way out changes is no straight line"
HUGE = "the squares of these lengths are too large for float64"
MANY = "both shapes together have more than {} corners, too many to work it out while you drag"


class Linear(NamedTuple):
    """A number that falls by `down` . d as B moves by d: `rest` - `down` . d."""

    rest: float
    down: Vec

    def at(self, d: Vec) -> float:
        """The number for a move."""
        return self.rest - self.down.x * d.x - self.down.y * d.y


NOTHING = Linear(0.0, Vec(0.0, 0.0))


class Cell(NamedTuple):
    """Moves of B, and by how much and which way (of length 1) B is pushed there."""

    ring: Ring
    length: Linear
    way: Vec


# -- pushes


def _plain(a: Shape, b: Shape) -> str:
    """Why there is no map of pushes; empty where there is one."""
    if a.core_is_point or b.core_is_point:
        return CIRCLE
    if not (a.is_convex and b.is_convex):
        return DENT
    return MANY.format(MOST_CORNERS) if len(a.vertices) + len(b.vertices) > MOST_CORNERS else ""


def _overlaps(a: Shape, b: Shape, axis: Axis) -> Iterator[tuple[Linear, Vec]]:
    """How far B must go to leave A on either side of an axis, and the way."""
    p, q, n = project(a, axis).interval, project(b, axis).interval, axis.direction
    yield Linear(p.hi - q.lo, n), n
    back = Vec(-n.x, -n.y)
    yield Linear(q.hi - p.lo, back), back


def _cells(a: Shape, b: Shape, window: Window) -> Iterator[Cell]:
    """A - B cut along its medial lines: a cell for each edge, of the moves that it is nearest to."""
    every = [side for axis in needed(a, b).axes for side in _overlaps(a, b, axis)]
    (ring,) = difference(a, b)
    inside = within(ring, window)
    for length, way in every:
        if cell := _least(inside, length, [other for other, _ in every]):
            yield Cell(cell, length, way)


def _least(ring: Ring, one: Linear, others: Sequence[Linear]) -> Ring:
    """The part of a convex ring where one number is the least of all."""
    for other in others:
        n, most = Vec(other.down.x - one.down.x, other.down.y - one.down.y), other.rest - one.rest
        if _same(one, other):
            continue
        if not ring:
            break
        if any(n):
            ring = clipped(ring, n, most)
        elif most < 0:
            return ()
    return ring


def _same(p: Linear, q: Linear) -> bool:
    size = max(abs(p.rest), abs(q.rest), hypot(*p.down), hypot(*q.down))
    return max(abs(p.rest - q.rest), *(abs(u - v) for u, v in zip(p.down, q.down, strict=True))) <= SAME * size


def _raw(a: Shape, b: Shape, axis: Axis) -> list[Linear]:
    """The overlap in units of the normal's length."""
    k = axis.length
    return [Linear(rest * k, Vec(n.x * k, n.y * k)) for (rest, n), _ in _overlaps(a, b, axis)]


def _flat(a: Shape, b: Shape, axis: Axis) -> list[Linear]:
    """What the ranges share: no more than either is long."""
    ranges = project(a, axis).interval, project(b, axis).interval
    return [*(one for one, _ in _overlaps(a, b, axis)), *(Linear(r.hi - r.lo, Vec(0.0, 0.0)) for r in ranges)]


def _depth(measured: Callable[[Shape, Shape, Axis], list[Linear]], name: str) -> "Map":
    """Where the least of what a shortcut measures is not the depth."""

    def found(a: Shape, b: Shape, window: Window) -> Found:
        if why := _plain(a, b):
            return why
        claimed = [one for axis in NAMED[name].choose(a, b).axes for one in measured(a, b, axis)]
        true = [side for axis in needed(a, b).axes for side, _ in _overlaps(a, b, axis)]
        (ring,) = difference(a, b)
        inside = within(ring, window)
        right = [one for one in claimed if any(_same(one, other) for other in true)]
        return without(inside, [_least(inside, one, [*claimed, *true]) for one in right])

    return found


def _wrong_way(a: Shape, b: Shape, window: Window) -> Found:
    """Where the shortest way out leads towards the middle of A."""
    if why := _plain(a, b):
        return why
    p, q = middle(a), middle(b)
    cut = (clipped(c.ring, c.way, c.way.x * (p.x - q.x) + c.way.y * (p.y - q.y)) for c in _cells(a, b, window))
    return [*filter(None, cut)]


def _pieces(name: str, differ: Callable[[Vec, Vec], float]) -> "Map":
    """Where the pushes of A's pieces, added up, are another than the whole's: where `differ` of them is not 0."""

    def found(a: Shape, b: Shape, window: Window) -> Found:
        split = NAMED[name].split
        assert split
        if why := _plain(a, b):
            return why
        if len(a.vertices) + len(b.vertices) > MOST_OF_PIECES:
            return MANY.format(MOST_OF_PIECES)
        (ring,) = difference(a, b)
        runs = [[*_cells(a, b, window)]]
        for piece in split(a):
            (own,) = difference(piece, b)
            beyond = (Cell(rest, NOTHING, NOTHING.down) for rest in without(within(ring, window), [own]))
            runs.append([*_cells(piece, b, window), *beyond])
        far = max(abs(u) for p in (*ring, *corners(window)) for u in p)
        if not isfinite(far * far):
            return HUGE
        near = SAME * far * far
        return [ring for ring, cells in _overlaid(runs) if not _agree(ring, cells, differ, near)]

    return found


def _overlaid(runs: Sequence[Sequence[Cell]]) -> list[tuple[Ring, list[Cell]]]:
    """Where a cell of each run meet."""
    found = [(cell.ring, [cell]) for cell in runs[0]]
    for run in runs[1:]:
        met = ((_shared(ring, cell.ring), [*cells, cell]) for (ring, cells), cell in product(found, run))
        found = [(ring, cells) for ring, cells in met if ring]
    return found


def _shared(ring: Ring, other: Ring) -> Ring:
    for k in 0, 1:  # most lie apart, which their boxes say at once
        if max(p[k] for p in ring) <= min(p[k] for p in other) or max(p[k] for p in other) <= min(p[k] for p in ring):
            return ()
    for p, q in zip(other, (*other[1:], other[0]), strict=True):
        n = Vec(q.y - p.y, p.x - q.x)
        ring = clipped(ring, n, p.x * n.x + p.y * n.y) if ring else ()
    return ring


def _agree(ring: Ring, cells: Sequence[Cell], differ: Callable[[Vec, Vec], float], near: float) -> bool:
    """Is the difference 0 all over the ring?  What is quadratic is, if it is at a triangle's corners and middles."""
    p, q, r = max(((ring[0], *two) for two in pairwise(ring[1:])), key=area)
    spots = p, q, r, *(Vec((u.x + v.x) / 2, (u.y + v.y) / 2) for u, v in ((p, q), (q, r), (r, p)))
    for spot in spots:
        true, *pushes = (Vec(c.way.x * c.length.at(spot), c.way.y * c.length.at(spot)) for c in cells)
        push = Vec(sum(one.x for one in pushes), sum(one.y for one in pushes))
        if abs(differ(push, true)) > near:
            return False
    return True


def _longer(push: Vec, true: Vec) -> float:
    return push.x * push.x + push.y * push.y - true.x * true.x - true.y * true.y


def _elsewhere(push: Vec, true: Vec) -> float:
    x, y = push.x - true.x, push.y - true.y
    return x * x + y * y


# -- other numbers


def _all_that_separate(a: Shape, b: Shape, window: Window) -> Found:
    """Wherever one direction separates, more do."""
    if not (a.is_convex and b.is_convex):
        return "a shape has a dent, into which no direction looks"
    return without(corners(window), list(difference(a, b)))


def _first_gap(a: Shape, b: Shape, window: Window) -> Found:
    """Where SAT looks at no more than GJK must: one axis that separates, or three that do not."""
    if why := _plain(a, b):
        return why
    axes, (ring,) = needed(a, b).axes, difference(a, b)
    found = [ring] if len(axes) <= LEAST_OF_GJK else []
    sides = [side for side, _ in _overlaps(a, b, axes[0])]
    beyond = (clipped(corners(window), Vec(-side.down.x, -side.down.y), -side.rest) for side in sides)
    return [*filter(None, beyond), *(within(ring, window) for ring in found)]


def _not_beside(a: Shape, b: Shape, window: Window) -> Found:
    """Where the shapes are apart and B does not lie straight beside an edge across x, which x looks at."""
    rings = [hull(Vec(u.x - v.x, u.y - v.y) for u in p.core for v in q.core) for p in parts(a) for q in parts(b)]
    near = SAME * max((abs(u) for ring in rings for p in ring for u in p), default=0.0)
    beside = []
    for side in 1, -1:
        far = max((p.x * side for ring in rings for p in ring), default=0.0)
        for ring in rings:
            ys = [p.y for p in ring if far - p.x * side <= near]
            low, high = min(ys, default=0.0), max(ys, default=0.0)
            level = clipped(clipped(corners(window), Vec(0.0, 1.0), high), Vec(0.0, -1.0), -low) if low < high else ()
            beside.append(clipped(level, Vec(-side, 0.0), -far) if level else ())
    return without(corners(window), [*difference(a, b), *beside])


def _on_the_way(a: Shape, b: Shape, window: Window) -> Found:
    """Where A meets B between two frames, and in neither."""
    if a.core_is_point or b.core_is_point:
        return "a circle's flight is not followed"
    if not (a.is_convex and b.is_convex):
        return "a shape has a dent, and both frames are looked at without its parts"
    x, y = map(float, swept.FLIGHT)
    first = list(difference(a, b))
    after = [tuple(Vec(p.x + x, p.y + y) for p in ring) for ring in first]
    ways = [within(hull((*ring, *then)), window) for ring, then in zip(first, after, strict=True)]
    return [piece for i, way in enumerate(ways) for piece in without(way, (*first, *after, *ways[:i]))]


def _none(why: str) -> "Map":
    return lambda a, b, window: why


Map = Callable[[Shape, Shape, Window], Found]
MAPS: dict[str, Map] = {
    "only-one-axis": _all_that_separate,
    "repeated-vertex": _depth(_raw, "repeated-vertex"),
    "raw-depth": _depth(_raw, "raw-depth"),
    "one-maximum": _none(ROUNDING),
    "touch-on-paper": _none(ROUNDING),
    "sum-of-parts": _pieces("sum-of-parts", _longer),
    "many-pairs": _none(COUNT),
    "gjk-looks-less": _first_gap,
    "push-from-center": _wrong_way,
    "range-inside": _depth(_flat, "range-inside"),
    "gap-as-distance": _not_beside,
    "tunnelling": _on_the_way,
    "tile-seam": _pieces("tile-seam", _elsewhere),
}
