"""Few shapes, in NumPy: which boxes meet by comparing all or by sorting and sweeping, and all collisions of few."""

from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...engine.predicates import MAX_SAFE_PRODUCT, MIN_SAFE_PRODUCT
from ...engine.relate import ERROR_FACTOR_F64, MIN_ERROR_BOUND
from ..array_types import Array, Indices, Pairs
from ..arrays import CornerColumns, Shapes
from ..broad_rule import ALL_PAIRS, GRID, MAX_ALL_PAIRS, MAX_SWEEP_COMPARISONS, MAX_SWEEP_NUMPY, SWEEP
from ..codes import APART, UNDECIDED
from .indexed import relations

Complexes = NDArray[np.complex128]

MAX_WHOLE_CORNERS = 200  # corners up to which all pairs are tested without comparing boxes first
MAX_SHAPES, MAX_CORNERS = 1 << 12, 8  # above these, blocks of pairs in float32 are faster
MAX_PRODUCTS = 1 << 17  # of normals and corners at a time, so that they stay in the second-level cache
MAX_DISTANCES = 1 << 13  # from corners to centers at a time, for the same reason
# column V: the corners of an outline with V corners, again and again
CLOSING = np.arange(MAX_CORNERS + 1)[:, None] % np.maximum(1, np.arange(MAX_CORNERS + 1))
OUTWARD = np.array([1.0, -1.0])[:, None, None]  # turns (dy, dx) of a counter-clockwise edge into its outward normal
# the bound for squared distances, of the larger square, and that for turns, of edge times distance: as in filter
DISTANCE_ERROR, TURN_ERROR = 2.0**-46, 2.0**-48
NO_LENGTH = 1e-300  # edge times distance: its root, times a distance, is far below every bound


class Sweep(NamedTuple):
    """Boxes sorted along an axis: `order` by their lower sides, `ends` for each the place after the last it reaches.

    axis: 0 for x, 1 for y; order and ends: (n,); comparisons: how many pairs of boxes the sweep compares.
    """

    axis: int
    order: Indices
    ends: Indices
    comparisons: int


def candidate_pairs(bounds: Array) -> tuple[Pairs | None, int, int]:
    """Return (pairs i < j of boxes that share a point, code of the broad phase, its comparisons or -1).

    The broad phase is chosen by the rule of `broad_rule`; None for the pairs where it is a grid.
    """
    n = len(bounds)
    if n <= MAX_ALL_PAIRS:
        return _meeting_of_all(bounds.T[:2], bounds.T[2:]), ALL_PAIRS, n * (n - 1) // 2
    if n > MAX_SWEEP_NUMPY:
        return None, GRID, -1
    low, high = bounds.T[:2], bounds.T[2:]
    with np.errstate(all="ignore"):
        (spread_x, spread_y), (width, height) = low.max(axis=1) - low.min(axis=1), (high - low).max(axis=1)
        axis = 0 if spread_x * height >= spread_y * width else 1
    sweep = _sorted(bounds, axis)
    if sweep.comparisons > MAX_SWEEP_COMPARISONS * n:
        sweep = min(sweep, _sorted(bounds, 1 - axis), key=lambda one: one.comparisons)
    if sweep.comparisons > MAX_SWEEP_COMPARISONS * n:
        return None, GRID, sweep.comparisons
    return _swept_pairs(bounds, sweep), SWEEP, sweep.comparisons


def _sorted(bounds: Array, axis: int) -> Sweep:
    """Return the boxes sorted along an axis."""
    n = len(bounds)
    order = np.argsort(bounds[:, axis])
    ends = np.searchsorted(bounds[order, axis], bounds[order, axis + 2], side="right")
    return Sweep(axis, order, ends, int(ends.sum()) - n * (n + 1) // 2)


def _swept_pairs(bounds: Array, sweep: Sweep) -> Pairs:
    """Return the pairs i < j of sorted boxes that share a point."""
    first = np.arange(1, len(bounds) + 1)
    many = sweep.ends - first
    later = np.arange(many.sum()) + np.repeat(first - (np.cumsum(many) - many), many)
    low, high = bounds[sweep.order, 1 - sweep.axis], bounds[sweep.order, 3 - sweep.axis]  # on the other axis
    meet = np.flatnonzero((np.repeat(low, many) <= high[later]) & (low[later] <= np.repeat(high, many)))
    i, j = sweep.order[np.repeat(first - 1, many)[meet]], sweep.order[later[meet]]
    return np.stack([np.minimum(i, j), np.maximum(i, j)], axis=1)


@lru_cache(maxsize=MAX_ALL_PAIRS + 1)
def _all_pairs(n: int) -> tuple[Pairs, Indices]:
    """Return the pairs i < j of n boxes in order, and the place of each in an (n, n) array."""
    i, j = np.triu_indices(n, 1)
    return np.stack([i, j], axis=1), i * n + j


def _meeting_of_all(low: Array, high: Array) -> Pairs:
    """Return the pairs i < j of boxes that share a point, in order, by comparing all; low, high: (2, n) sides."""
    before = low[:, :, None] <= high[:, None]  # does box i begin on this axis before box j ends?
    meet = before[0] & before[1]
    meet &= meet.T
    pairs, places = _all_pairs(low.shape[1])
    return pairs.take(np.flatnonzero(meet.take(places)), axis=0)


def colliding_pairs(shapes: Shapes) -> Pairs | None:
    """Return the pairs i < j, in order, of few shapes that share a point; None where others must decide.

    All pairs are evaluated in float64 by a few expressions, since calls take longer than the work: a corner is a
    complex number x + iy.
    """
    closed, radius = _closed_columns(shapes)
    if closed is None:
        return None
    n = closed.shape[1]
    with np.errstate(all="ignore"):
        is_upright = radius is None and _are_upright(closed)
        if n <= MAX_ALL_PAIRS and closed.size <= MAX_WHOLE_CORNERS and not is_upright:
            pairs, places = _all_pairs(n)
            clear = _clearances_of_all(closed, radius).take(places)
        else:
            low, high = _boxes(closed, radius)
            meeting, *_ = candidate_pairs(np.concatenate([low, high]).T)
            if meeting is None:
                return None
            pairs = meeting
            clear = np.full(len(pairs), -np.inf) if is_upright else _clearances(closed, radius, *meeting.T)
    hit, apart = clear < -1, clear > 1
    if np.count_nonzero(hit) + np.count_nonzero(apart) < len(pairs):
        rest = np.flatnonzero(~(hit | apart))
        settled = np.empty(len(rest), np.int8)
        relations(shapes.flat, pairs[rest, 0], shapes.flat, pairs[rest, 1], settled)
        if settled.min() == UNDECIDED:  # circles that nearly touch
            return None
        hit[rest] = settled != APART
    pairs = pairs.take(hit.nonzero()[0], axis=0)
    return pairs if n <= MAX_ALL_PAIRS else np.asarray(pairs[np.lexsort((pairs[:, 1], pairs[:, 0]))])


def _are_upright(closed: Complexes) -> bool:
    """Return whether all outlines are boxes with sides along x and y: four corners, and each step along an axis."""
    if len(closed) != 5:
        return False
    first = closed[1, 0] - closed[0, 0]  # mostly the first outline tells
    if first.real and first.imag:
        return False
    one, other = closed[1:], closed[:-1]
    return bool(((one.real == other.real) != (one.imag == other.imag)).all())


def _boxes(closed: Complexes, radius: Array | None) -> tuple[Array, Array]:
    """Return the lower and the upper sides of the bounding boxes, (2, n) each, those of circles rounded outwards."""
    planes = _planes(closed)
    low, high = np.minimum.reduce(planes, axis=1), np.maximum.reduce(planes, axis=1)
    if radius is not None:
        low, high = np.nextafter(low - radius, -np.inf), np.nextafter(high + radius, np.inf)
    return low, high


def _planes(z: Complexes) -> Array:
    """Return complex numbers as x and y, (2, ...)."""
    planes = np.empty((2, *z.shape))
    planes[0], planes[1] = z.real, z.imag
    return planes


def _clearances_of_all(closed: Complexes, radius: Array | None) -> Array:
    """Return what `_clearances` does for all n by n shapes: each normal with each corner in one product."""
    n = closed.shape[1]
    if len(closed) == 1 and radius is not None:
        return _round_clearances(closed[:, :, None], closed[0], radius[:, None] + radius)
    corners, edges = closed[:-1], closed[1:] - closed[:-1]
    normals = edges * -1j
    # corner by corner of each shape, edge by edge of each
    values = corners.reshape(-1, 1).view(np.float64) @ normals.reshape(-1, 1).view(np.float64).T
    least = np.minimum.reduce(values.reshape(len(corners), n, len(corners), n), axis=0)
    least -= (normals.conj() * corners).real
    gap = np.maximum.reduce(least, axis=1)
    edge, reach = np.maximum.reduce(np.abs(edges), axis=0), np.maximum.reduce(np.abs(corners), axis=0)
    clear = _in_error_bounds(np.maximum(gap, gap.T), (edge[:, None] + edge) * (reach[:, None] + reach))
    if radius is not None:
        circles = np.flatnonzero(radius)
        radius_sum = radius[:, None] + radius.take(circles)
        clear[:, circles] = others = _round_clearances(closed[:, :, None], closed[0].take(circles), radius_sum)
        clear[circles] = others.T
    return clear


def _in_error_bounds(gap: Array, size: Array) -> Array:
    """Return gaps of polygons in units of their error bounds; size: largest edge times largest coordinate.

    What underflow takes is far less than MIN_ERROR_BOUND; where a product overflows, so does the size.
    """
    return np.asarray(gap / np.maximum(size * ERROR_FACTOR_F64, MIN_ERROR_BOUND))


def _clearances(closed: Complexes, radius: Array | None, i: Indices, j: Indices) -> Array:
    """Return the gap between shapes i[k] and j[k] in units of its error bound: certain above 1 and below -1."""
    if radius is None:
        return _polygon_clearances(closed, i, j)
    clear = np.empty(len(i))
    radius_sum = radius[i] + radius[j]
    is_round = radius_sum > 0
    where = np.flatnonzero(~is_round)
    if where.size:
        clear[where] = _polygon_clearances(closed, i[where], j[where])
    where = np.flatnonzero(is_round)
    size = MAX_DISTANCES // len(closed)
    for start in range(0, len(where), size):
        part = where[start : start + size]
        a, b = i[part], j[part]
        a, b = np.where(radius[a] > 0, (a, b), (b, a))
        clear[part] = _round_clearances(closed.take(b, axis=1), closed[0].take(a), radius_sum[part])
    return clear


def _round_clearances(closed: Complexes, centers: Complexes, radius: Array) -> Array:
    """Return what `_clearances` does for circles with these centers and outlines, which may be those of circles too.

    The gap is the squared distance from the center to the outline minus the squared sum of radii; -inf for a center
    certainly inside.  A center that rounding hides from the inside is so near to the boundary that its distance from
    there decides as well.
    closed: (V + 1, ...) corners, the first one again at the end, or (1, ...) centers of other circles.
    """
    away = centers - closed
    distance = (away * away.conj()).real
    square = radius * radius
    if len(closed) == 1:
        error_bound = np.maximum(distance[0], square) * DISTANCE_ERROR
        return np.asarray((distance[0] - square) / np.maximum(error_bound, MIN_SAFE_PRODUCT))
    error_bound = np.maximum(np.maximum.reduce(distance, axis=0), square)
    error_bound *= DISTANCE_ERROR
    error_bound[error_bound > MAX_SAFE_PRODUCT * DISTANCE_ERROR] = np.inf  # squares of edges may overflow
    np.maximum(error_bound, MIN_SAFE_PRODUCT, out=error_bound)  # underflow takes far less
    edges = closed[1:] - closed[:-1]
    turns = edges.conj() * away[:-1]
    along, turn, length = turns.real, turns.imag, (edges * edges.conj()).real
    inside = np.logical_and.reduce(turn > np.abs(turns) * TURN_ERROR + NO_LENGTH, axis=0)
    # a foot this near to the first corner is that corner, which also settles edges so short that products are lost
    ends = np.where(along >= length, distance[1:], turn / length * turn)
    gap = np.minimum.reduce(np.where(along <= NO_LENGTH, distance[:-1], ends), axis=0)
    gap -= square
    gap[inside] = -np.inf
    return np.asarray(gap / error_bound)


def _polygon_clearances(closed: Complexes, i: Indices, j: Indices) -> Array:
    """Return what `_clearances` does for polygons."""
    corners, edges = _planes(closed[:-1]), _planes(closed[1:] - closed[:-1])
    edge, reach = (np.abs(c).max(axis=(0, 1)) for c in (edges, corners))
    return _in_error_bounds(_gaps(corners, edges, i, j), (edge[i] + edge[j]) * (reach[i] + reach[j]))


def _gaps(corners: Array, edges: Array, i: Indices, j: Indices) -> Array:
    """Return for polygons i[k] and j[k] the largest clearance of an edge of one over the corners of the other."""
    normals = edges[::-1] * OUTWARD
    own, other = np.concatenate([i, j]), np.concatenate([j, i])
    at = normals * corners
    at = at[0] + at[1]
    gap = np.empty(len(own))
    size = MAX_PRODUCTS // len(at) ** 2
    for start in range(0, len(own), size):
        part = slice(start, start + size)
        products = normals.take(own[part], axis=2)[:, :, None] * corners.take(other[part], axis=2)[:, None]
        values = np.add(products[0], products[1], out=products[0])
        least = np.minimum.reduce(values, axis=1)
        least -= at.take(own[part], axis=1)
        np.maximum.reduce(least, axis=0, out=gap[part])
    return np.asarray(np.maximum(gap[: len(i)], gap[len(i) :]))


def _closed_columns(shapes: Shapes) -> tuple[Complexes | None, Array | None]:
    """Return ((V + 1, n) corners, one column a shape, or None for many shapes or corners; radii if there are any).

    The row after an outline's last corner starts it again; circles alone have one row.
    """
    if not 1 < shapes.part_count <= MAX_SHAPES:
        return None, None
    if (runs := vars(shapes).get("runs")) is not None:  # read once, since another thread may join them
        return _closed_runs(runs)
    x, y, start = shapes.rings
    count = start[1:] - start[:-1]
    most = int(np.maximum.reduce(count))
    if most > MAX_CORNERS:
        return None, None
    places = CLOSING.take(count, axis=1)[: _rows(most)] + start[:-1]
    closed = np.empty(places.shape, np.complex128)
    closed.real, closed.imag = x.take(places), y.take(places)
    return closed, shapes.radius if shapes.radius.any() else None


def _closed_runs(runs: Sequence[CornerColumns]) -> tuple[Complexes | None, Array | None]:
    """Return (corners, radii) in the form of `_closed_columns`, for the shapes of several groups, group after group."""
    most = max(run.block.shape[1] for run in runs)
    if most > MAX_CORNERS:
        return None, None
    rows, start = _rows(most), 0
    closed = np.empty((rows, sum(run.block.shape[2] for run in runs)), np.complex128)
    for run in runs:
        _, corners, n = run.block.shape
        part, again = closed[:, start : start + n], CLOSING[:rows, corners]
        part.real, part.imag = run.block[0].take(again, axis=0), run.block[1].take(again, axis=0)
        start += n
    if len(runs) == 1:
        return closed, runs[0].r
    if all(run.r is None for run in runs):
        return closed, None
    return closed, np.concatenate([np.zeros(len(run)) if run.r is None else run.r for run in runs])


def _rows(most: int) -> int:
    """Return the rows of closed columns of shapes with up to so many corners."""
    return most + 1 if most > 1 else 1
