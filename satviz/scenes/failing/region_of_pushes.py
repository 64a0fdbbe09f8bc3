"""The error region of a push or a depth, as polygons in the plane of B's moves.

The distance from B's move to an edge of A - B is a linear function of that move, and the nearest edge changes along
straight lines.  So in every cell between these lines the claimed number and the true number are one formula each.
The two formulas are equal, or they differ everywhere but on a line or a curve, which has no area.  A window is the
upright box of moves for which the region is computed.
"""

from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise, product
from math import hypot, isfinite
from typing import NamedTuple

from ...engine.axes import Axis, Chooser, needed
from ...engine.geometry import Vec
from ...engine.sat import project
from ...engine.shapes import Shape
from ..shape_tools import vertex_mean
from .move_space import (
    TOLERANCE,
    ConvexRing,
    RegionOrReason,
    Window,
    clip_to_half_plane,
    clip_to_window,
    hits_in_window,
    minkowski_difference,
    subtract,
    twice_area,
    window_ring,
    wrong_number_region,
)

MAX_CORNERS, MAX_CORNERS_IN_PIECES = 32, 12  # corners of both shapes: more make too many cells to compute during a drag

ROUND = "the shortest way out of a circle turns as B moves, so the region of wrong numbers has no straight edges"
DENT = "a shape has a dent, so its shortest way out does not change along straight lines"
OVERFLOW = "the squares of these lengths are too large for float64"
MANY_CORNERS = "both shapes together have more than {} corners, too many to work it out while you drag"


class Linear(NamedTuple):
    """The linear function `constant` - `slope` . d of the move d of B."""

    constant: float
    slope: Vec

    def at(self, d: Vec) -> float:
        """Return the value of this linear function when B is moved by d."""
        return self.constant - self.slope.x * d.x - self.slope.y * d.y


ZERO = Linear(0.0, Vec(0.0, 0.0))


class PushRegion(NamedTuple):
    """A convex region of positions of B where the push has `length`, a linear function, along the unit `direction`."""

    ring: ConvexRing
    length: Linear
    direction: Vec


def why_no_cells(a: Shape, b: Shape) -> str:
    """Return why the moves cannot be cut into cells with one push direction each; "" where they can."""
    if a.core_is_point or b.core_is_point:
        return ROUND
    if not (a.is_convex and b.is_convex):
        return DENT
    return MANY_CORNERS.format(MAX_CORNERS) if len(a.vertices) + len(b.vertices) > MAX_CORNERS else ""


def overlaps(a: Shape, b: Shape, axis: Axis) -> Iterator[tuple[Linear, Vec]]:
    """Yield (distance, direction) of the two pushes of B along an axis that end the overlap, one to each side.

    The distance is a linear function of the move that B made before the push.
    """
    p, q, n = project(a, axis).interval, project(b, axis).interval, axis.direction
    yield Linear(p.hi - q.lo, n), n
    back = Vec(-n.x, -n.y)
    yield Linear(q.hi - p.lo, back), back


def overlaps_in_raw_units(a: Shape, b: Shape, axis: Axis) -> list[Linear]:
    """Return both overlaps on an axis times its normal's length, as functions of B's move."""
    k = axis.length
    return [Linear(constant * k, Vec(n.x * k, n.y * k)) for (constant, n), _ in overlaps(a, b, axis)]


def shared_lengths(a: Shape, b: Shape, axis: Axis) -> list[Linear]:
    """Return functions of B's move whose minimum is the length that both ranges on the axis share."""
    ranges = project(a, axis).interval, project(b, axis).interval
    return [*(one for one, _ in overlaps(a, b, axis)), *(Linear(r.hi - r.lo, Vec(0.0, 0.0)) for r in ranges)]


def region_of_depth(
    a: Shape, b: Shape, window: Window, choose: Chooser, measure: Callable[[Shape, Shape, Axis], list[Linear]]
) -> RegionOrReason:
    """Return the moves for which a shortcut's depth is wrong, or why none is shown.

    Its depth is the least value of all functions from `measure` on all axes from `choose`.
    """
    if why := why_no_cells(a, b):
        return why
    claimed = [one for axis in choose(a, b).axes for one in measure(a, b, axis)]
    true = [side for axis in needed(a, b).axes for side, _ in overlaps(a, b, axis)]
    (inside,) = hits_in_window(a, b, window)
    right = [one for one in claimed if any(_is_same(one, other) for other in true)]
    wrong = subtract(inside, [_where_least(inside, one, [*claimed, *true]) for one in right])
    return wrong_number_region(a, b, window, wrong)


def region_of_every_overlap(a: Shape, b: Shape, window: Window) -> RegionOrReason:
    """Return the moves for which two polygons overlap, where a wrong push is right on a line at most; or why none."""
    if why := why_no_cells(a, b):
        return why
    return wrong_number_region(a, b, window, hits_in_window(a, b, window))


def region_of_push_to_mean(a: Shape, b: Shape, window: Window) -> RegionOrReason:
    """Return the moves where the MTV points towards A's vertex mean, so a push away from it is wrong; or why none."""
    if why := why_no_cells(a, b):
        return why
    p, q = vertex_mean(a), vertex_mean(b)
    cells = _push_cells(a, b, window)
    wrong = (clip_to_half_plane(ring, n, n.x * (p.x - q.x) + n.y * (p.y - q.y)) for ring, _, n in cells)
    return wrong_number_region(a, b, window, wrong)


def region_of_push_along_axis(a: Shape, b: Shape, window: Window) -> RegionOrReason:
    """Return the moves where the MTV points left or straight down, or why none is shown.

    There a push in the direction of its axis, which points right or straight up, is wrong.
    """
    if why := why_no_cells(a, b):
        return why
    return wrong_number_region(a, b, window, (ring for ring, _, n in _push_cells(a, b, window) if n < (0, 0)))


def region_of_pieces(
    a: Shape,
    b: Shape,
    window: Window,
    split: Callable[[Shape], Sequence[Shape]],
    error: Callable[[Vec, Vec], float],
) -> RegionOrReason:
    """Return the moves where the summed pushes of A's pieces differ from the MTV, or why none is shown.

    `error(sum of pushes, MTV)` is a quadratic function of both, and 0 where the sum counts as right.
    """
    if why := why_no_cells(a, b):
        return why
    if len(a.vertices) + len(b.vertices) > MAX_CORNERS_IN_PIECES:
        return MANY_CORNERS.format(MAX_CORNERS_IN_PIECES)
    (ring,) = minkowski_difference(a, b)
    layers = [[*_push_cells(a, b, window)]]
    for piece in split(a):
        (own,) = minkowski_difference(piece, b)
        beyond = (PushRegion(outside, ZERO, ZERO.slope) for outside in subtract(clip_to_window(ring, window), [own]))
        layers.append([*_push_cells(piece, b, window), *beyond])
    far = max(abs(u) for p in (*ring, *window_ring(window)) for u in p)
    if not isfinite(far * far):
        return OVERFLOW
    tolerance = TOLERANCE * far * far
    wrong = [ring for ring, cells in _overlay(layers) if not _pushes_agree(ring, cells, error, tolerance)]
    return wrong_number_region(a, b, window, wrong)


def _push_cells(a: Shape, b: Shape, window: Window) -> Iterator[PushRegion]:
    """Yield the moves for which the shapes meet, cut into cells: one for each edge of A - B that is nearest there."""
    every = [side for axis in needed(a, b).axes for side in overlaps(a, b, axis)]
    (inside,) = hits_in_window(a, b, window)
    for length, direction in every:
        if cell := _where_least(inside, length, [other for other, _ in every]):
            yield PushRegion(cell, length, direction)


def _where_least(ring: ConvexRing, one: Linear, others: Sequence[Linear]) -> ConvexRing:
    """Return the part of a convex ring of moves where the linear function `one` is the smallest of all."""
    for other in others:
        n = Vec(other.slope.x - one.slope.x, other.slope.y - one.slope.y)
        limit = other.constant - one.constant
        if _is_same(one, other):
            continue
        if not ring:
            break
        if any(n):
            ring = clip_to_half_plane(ring, n, limit)
        elif limit < 0:
            return ()
    return ring


def _is_same(p: Linear, q: Linear) -> bool:
    """Return whether two linear functions of B's move are equal up to rounding."""
    size = max(abs(p.constant), abs(q.constant), hypot(*p.slope), hypot(*q.slope))
    difference = abs(p.constant - q.constant), *(abs(u - v) for u, v in zip(p.slope, q.slope, strict=True))
    return max(difference) <= TOLERANCE * size


def _overlay(layers: Sequence[Sequence[PushRegion]]) -> list[tuple[ConvexRing, list[PushRegion]]]:
    """Return (ring, cells) for each non-empty intersection of one cell from every layer."""
    found = [(cell.ring, [cell]) for cell in layers[0]]
    for layer in layers[1:]:
        met = ((_intersection(ring, cell.ring), [*cells, cell]) for (ring, cells), cell in product(found, layer))
        found = [(ring, cells) for ring, cells in met if ring]
    return found


def _intersection(ring: ConvexRing, other: ConvexRing) -> ConvexRing:
    """Return the intersection of two convex rings; () if it has no area."""
    for k in 0, 1:
        if max(p[k] for p in ring) <= min(p[k] for p in other) or max(p[k] for p in other) <= min(p[k] for p in ring):
            return ()
    for p, q in zip(other, (*other[1:], other[0]), strict=True):
        n = Vec(q.y - p.y, p.x - q.x)
        ring = clip_to_half_plane(ring, n, p.x * n.x + p.y * n.y) if ring else ()
    return ring


def _pushes_agree(
    ring: ConvexRing, cells: Sequence[PushRegion], error: Callable[[Vec, Vec], float], tolerance: float
) -> bool:
    """Return whether `error` of the summed pushes and the MTV is 0, within the tolerance, in the whole ring.

    A quadratic is 0 all over if it is 0 at a triangle's corners and edge midpoints.
    The first cell holds the whole shape's MTV, the others hold its pieces' pushes.
    """
    p, q, r = max(((ring[0], *two) for two in pairwise(ring[1:])), key=twice_area)
    spots = p, q, r, *(Vec((u.x + v.x) / 2, (u.y + v.y) / 2) for u, v in ((p, q), (q, r), (r, p)))
    for spot in spots:
        mtv, *pushes = (Vec(c.direction.x * c.length.at(spot), c.direction.y * c.length.at(spot)) for c in cells)
        total = Vec(sum(one.x for one in pushes), sum(one.y for one in pushes))
        if abs(error(total, mtv)) > tolerance:
            return False
    return True
