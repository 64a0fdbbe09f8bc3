"""Few shapes, in NumPy: which boxes meet by comparing all or by sorting and sweeping, and all collisions of few."""

from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from ...engine.relate import ERROR_FACTOR_F64, MIN_ERROR_BOUND
from ..array_types import Array, Complexes, Indices, Mask, Pairs
from ..arrays import ComplexColumns, CornerColumns, Shapes
from ..broad_rule import ALL_PAIRS, GRID, MAX_ALL_PAIRS, MAX_SWEEP_COMPARISONS, MAX_SWEEP_NUMPY, SWEEP
from ..codes import APART, UNDECIDED
from .indexed import relations

MAX_WHOLE_CORNERS = 200  # corners up to which all pairs are tested without comparing boxes first
MAX_SHAPES, MAX_CORNERS = 1 << 12, 8  # above these, blocks of pairs in float32 are faster ...
MAX_CLOSED = 64  # ... but not for shapes with up to so many corners, if
MAX_SQUARES = 1 << 16  # the squares of their numbers of corners have at most this sum
MAX_PRODUCTS = 1 << 17  # products of a normal and a corner computed at a time: they stay in the second-level cache
MAX_KEPT = 64  # numbers of shapes whose pairs are kept
NO_PLACES = np.empty(0, np.intp)
MAX_DISTANCES = 1 << 13  # distances from corners to centers computed at a time, for the same reason
# column V: the corners of an outline with V corners, again and again
CLOSING = np.arange(MAX_CLOSED + 1)[:, None] % np.maximum(1, np.arange(MAX_CLOSED + 1))
OUTWARD = np.array([1.0, -1.0])[:, None, None]  # turns (dy, dx) of a counter-clockwise edge into its outward normal
# Distances from a center to an outline of which no corner is farther than m: |error| <= 30 u m (u = 2**-53), rounded up
# to 128 u.  Turns, of edge times distance: as in filter.
DISTANCE_ERROR, TURN_ERROR = 2.0**-46, 2.0**-48
NO_TURN = 1e-300  # edge times distance: what underflow takes is far less
MIN_DISTANCE_ERROR = 2.0**-440  # edges whose squares lose bits, below 2**-500, are far shorter
MAX_DISTANCE = 2.0**500  # squares of edges between corners that near do not overflow


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

    bounds: (N, 4).  The broad phase is chosen by the rule of `broad_rule`; the pairs are None where it is a grid, and
    comparisons are -1 where they were not counted.
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
    sweep = _sort_along(bounds, axis)
    if sweep.comparisons > MAX_SWEEP_COMPARISONS * n:
        sweep = min(sweep, _sort_along(bounds, 1 - axis), key=lambda one: one.comparisons)
    if sweep.comparisons > MAX_SWEEP_COMPARISONS * n:
        return None, GRID, sweep.comparisons
    return _swept_pairs(bounds, sweep), SWEEP, sweep.comparisons


def _sort_along(bounds: Array, axis: int) -> Sweep:
    """Return the Sweep of the (N, 4) boxes along an axis (0: x, 1: y)."""
    n = len(bounds)
    order = np.argsort(bounds[:, axis])
    ends = np.searchsorted(bounds[order, axis], bounds[order, axis + 2], side="right")
    return Sweep(axis, order, ends, int(ends.sum()) - n * (n + 1) // 2)


def _swept_pairs(bounds: Array, sweep: Sweep) -> Pairs:
    """Return the pairs i < j of (N, 4) boxes that share a point, by their Sweep."""
    first = np.arange(1, len(bounds) + 1)
    many = sweep.ends - first
    later = np.arange(many.sum()) + np.repeat(first - (np.cumsum(many) - many), many)
    low, high = bounds[sweep.order, 1 - sweep.axis], bounds[sweep.order, 3 - sweep.axis]  # on the other axis
    meet = np.flatnonzero((np.repeat(low, many) <= high[later]) & (low[later] <= np.repeat(high, many)))
    i, j = sweep.order[np.repeat(first - 1, many)[meet]], sweep.order[later[meet]]
    return np.stack([np.minimum(i, j), np.maximum(i, j)], axis=1)


class AllPairs(NamedTuple):
    """The pairs i < j of some shapes, in order, as rows and as two arrays; and the place of each in an (n, n) array."""

    pairs: Pairs
    i: Indices
    j: Indices
    places: Indices


@lru_cache(maxsize=MAX_KEPT)
def _all_pairs(n: int) -> AllPairs:
    """Return the AllPairs of n shapes; those of MAX_KEPT numbers are kept."""
    i, j = np.triu_indices(n, 1)
    return AllPairs(np.stack([i, j], axis=1), i, j, i * n + j)


def _meeting_of_all(low: Array, high: Array) -> Pairs:
    """Return the pairs i < j of boxes that share a point, in order, by comparing all; low, high: (2, n) sides."""
    before = low[:, :, None] <= high[:, None]  # does box i begin on this axis before box j ends?
    meet = before[0] & before[1]
    meet &= meet.T
    every = _all_pairs(low.shape[1])
    return every.pairs.take(np.flatnonzero(meet.take(every.places)), axis=0)


def colliding_pairs(shapes: Shapes) -> Pairs | None:
    """Return the pairs i < j, in order, of few shapes that share a point.

    None for many shapes or boxes to compare, or where circles nearly touch: floats do not decide these.  All pairs are
    evaluated in float64 by a few expressions, since calls take longer than the work: a corner is a complex number
    x + iy.
    """
    with np.errstate(all="ignore"):
        columns = _columns_of(shapes)
        if columns is None:
            return None
        closed, _, radius = columns
        n = closed.shape[1]
        is_upright = radius is None and _are_upright(closed)
        if n <= MAX_ALL_PAIRS and closed.size <= MAX_WHOLE_CORNERS and not is_upright:
            every = _all_pairs(n)
            pairs = every.pairs
            clear, bound = _clearances_of_all(columns, every)
            hit, rest = _decided(clear, bound)
            if rest.size and len(closed) > 1:  # one bound for all says little where one shape is far larger or farther
                clear = _clearances(columns, *pairs.take(rest, axis=0).T)
                hit[rest], doubtful = _decided(clear, 1.0)
                rest = rest[doubtful]
        else:
            low, high = _boxes(closed, radius)
            meeting, *_ = candidate_pairs(np.concatenate([low, high]).T)
            if meeting is None:
                return None
            pairs = meeting
            clear = np.full(len(pairs), -np.inf) if is_upright else _clearances(columns, *meeting.T)
            hit, rest = _decided(clear, 1.0)
    if rest.size:
        settled = np.empty(len(rest), np.int8)
        relations(shapes.flat, pairs[rest, 0], shapes.flat, pairs[rest, 1], settled)
        if settled.min() == UNDECIDED:  # circles that nearly touch
            return None
        hit[rest] = settled != APART
    pairs = pairs.take(hit.nonzero()[0], axis=0)
    return pairs if n <= MAX_ALL_PAIRS else np.asarray(pairs[np.lexsort((pairs[:, 1], pairs[:, 0]))])


def _decided(clear: Array, bound: float) -> tuple[Mask, Indices]:
    """Return (mask of the pairs that certainly overlap, indices of the pairs that are undecided).

    clear: (K,) gaps of the pairs.  A pair is certainly apart above `bound`, and certainly overlaps below -`bound`; all
    others, and NaN, are undecided.
    """
    hit, apart = clear < -bound, clear > bound
    if np.count_nonzero(hit) + np.count_nonzero(apart) == len(clear):
        return hit, NO_PLACES
    return hit, (~(hit | apart)).nonzero()[0]


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
    """Return (lower sides, upper sides) of the bounding boxes, (2, n) each: x, y; those of circles are rounded.

    closed, radius: as in ComplexColumns.

    Boxes that meet still meet when rounded: of two numbers the smaller one is never rounded to a larger float.
    """
    planes = _planes(closed)
    low, high = np.minimum.reduce(planes, axis=1), np.maximum.reduce(planes, axis=1)
    return (low, high) if radius is None else (low - radius, high + radius)


def _planes(z: Complexes) -> Array:
    """Return complex numbers as x and y, (2, ...)."""
    planes = np.empty((2, *z.shape))
    planes[0], planes[1] = z.real, z.imag
    return planes


def _clearances_of_all(columns: ComplexColumns, every: AllPairs) -> tuple[Array, float]:
    """Return (the gaps of the pairs `every`, one error bound for all): each normal with each corner in one product."""
    closed, edges, radius = columns
    v, n = edges.shape
    if radius is not None and len(closed) == 1:
        away = closed[0].take(every.i) - closed[0].take(every.j)
        return _coin_clearances(np.abs(away), radius.take(every.i) + radius.take(every.j)), 1.0
    # corner by corner of each shape, edge by edge of each
    values = closed[:-1].reshape(-1, 1).view(np.float64).dot((edges * -1j).reshape(-1, 1).view(np.float64).T)
    least, at = np.minimum.reduce(values.reshape(v, n, v, n)), values.reshape(-1)[:: v * n + 1].reshape(v, 1, n)
    # by edge, by shape with these corners, by shape with this edge: a reduction of the first axis is the quickest
    over = np.maximum.reduce(np.subtract(least.transpose(1, 0, 2), at, order="C"))
    gap, reach = np.maximum(over, over.T), _largest(closed)
    # what underflow takes is far less than MIN_ERROR_BOUND; where a product overflows, so does the bound
    bound = max(4 * _largest(edges) * reach * ERROR_FACTOR_F64, MIN_ERROR_BOUND)
    if radius is not None:
        circles = radius.nonzero()[0]
        centers, radii = closed[0].take(circles), radius.take(circles)
        outside = over.take(circles, axis=0)
        outside[:, circles] = np.inf
        near = _distances(centers[:, None] - closed[:-1, None], edges[:, None]) - (radii[:, None] + radius)
        farthest = 2 * (reach + float(radii[radii.argmax()]))
        # edges and ways from centers to corners are at most 2 * reach long: if a product overflows, so does the bound
        near *= bound / (farthest * DISTANCE_ERROR + MIN_DISTANCE_ERROR)
        gap[circles] = near = np.minimum(near, outside)  # as in _round_clearances
        gap[:, circles] = near.T
    return gap.take(every.places), bound


def _largest(values: Array | Complexes) -> float:
    """Return the largest absolute value; of few, argmax finds it in half the time of max."""
    size = np.abs(values).reshape(-1)
    return float(size[size.argmax()])


def _distances(away: Complexes, edges: Complexes) -> Array:
    """Return the distances of centers from the boundaries of outlines, also where a center lies inside.

    away: (V, ...) from each corner to the center; edges: (V, ...) from each corner to the next one.
    """
    back = edges.conj()
    along = (back * away).real / (back * edges).real
    along = np.fmin(np.fmax(along, 0.0), 1.0)  # 0 for an edge without a length
    return np.asarray(np.minimum.reduce(np.abs(away - along * edges), axis=0))


def _coin_clearances(distance: Array, radius_sum: Array) -> Array:
    """Return the gaps between circles in units of their error bounds; distance: (k,), between the centers."""
    return np.asarray((distance - radius_sum) / ((distance + radius_sum) * DISTANCE_ERROR + MIN_DISTANCE_ERROR))


def _clearances(columns: ComplexColumns, i: Indices, j: Indices) -> Array:
    """Return the (K,) gaps between shapes i[k] and j[k] in units of their error bounds: certain above 1, below -1."""
    closed, _, radius = columns
    if radius is None:
        return _polygon_clearances(columns, i, j)
    radius_sum = radius.take(i) + radius.take(j)
    if len(closed) == 1:
        return _coin_clearances(np.abs(closed[0].take(i) - closed[0].take(j)), radius_sum)
    clear = np.empty(len(i))
    is_round = radius_sum > 0
    where = np.flatnonzero(~is_round)
    if where.size:
        clear[where] = _polygon_clearances(columns, i[where], j[where])
    where = np.flatnonzero(is_round)
    size = MAX_DISTANCES // len(closed)
    for start in range(0, len(where), size):
        part = where[start : start + size]
        a, b = i[part], j[part]
        a, b = np.where(radius[a] > 0, (a, b), (b, a))
        clear[part] = _round_clearances(columns, a, b, radius_sum[part], radius[b] > 0)
    return clear


def _round_clearances(columns: ComplexColumns, a: Indices, b: Indices, radius_sum: Array, is_coin: Mask) -> Array:
    """Return what `_clearances` does for circles a[k] and shapes b[k]; is_coin: mask of the circles b[k].

    If the center is certainly outside, the gap is the distance from the center to the outline minus the sum of radii.
    If the center is certainly inside, the gap is certainly negative.  If neither is certain,
    only an overlap that follows from the distance is certain.
    """
    closed, edges, _ = columns
    away, own = closed[0].take(a) - closed[:-1].take(b, axis=1), edges.take(b, axis=1)
    farthest = np.maximum.reduce(np.abs(away), axis=0)
    distance = _distances(away, own)
    error = (farthest + radius_sum) * DISTANCE_ERROR + MIN_DISTANCE_ERROR
    error[farthest > MAX_DISTANCE] = np.inf
    turns = own.conj() * away
    inside = np.minimum.reduce(turns.imag / (np.abs(turns) * TURN_ERROR + NO_TURN), axis=0)
    inside[is_coin] = -np.inf  # there are no edges
    return np.asarray(np.minimum((distance - radius_sum) / error, -inside))


def _polygon_clearances(columns: ComplexColumns, i: Indices, j: Indices) -> Array:
    """Return what `_clearances` does, where all are polygons."""
    corners, edges = _planes(columns.closed[:-1]), _planes(columns.edges)
    edge, reach = (np.abs(c).max(axis=(0, 1)) for c in (edges, corners))
    size = (edge[i] + edge[j]) * (reach[i] + reach[j])
    # what underflow takes is far less than MIN_ERROR_BOUND; where a product overflows, so does the size
    return np.asarray(_gaps(corners, edges, i, j) / np.maximum(size * ERROR_FACTOR_F64, MIN_ERROR_BOUND))


def _gaps(corners: Array, edges: Array, i: Indices, j: Indices) -> Array:
    """Return for polygons i[k] and j[k] the largest clearance of an edge of one over the corners of the other.

    The clearance is the distance times the edge's length.  corners, edges: (2, V, n) x and y.
    """
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


def _columns_of(shapes: Shapes) -> ComplexColumns | None:
    """Return the shapes as ComplexColumns; None for many shapes or corners, or a single shape."""
    runs = vars(shapes).get("runs")  # read once, since another thread may join them
    if runs is not None:
        return _columns_of_runs(runs)
    if not 1 < shapes.part_count <= MAX_SHAPES:
        return None
    if (columns := vars(shapes).get("as_complex")) is not None:
        return None if _are_many_corners(*columns.edges.shape) else columns
    x, y, start = shapes.rings
    count = start[1:] - start[:-1]
    most = int(count[count.argmax()])
    if _are_many_corners(most, len(count)):
        return None
    places = CLOSING.take(count, axis=1)[: _rows(most)] + start[:-1]
    closed = np.empty(places.shape, np.complex128)
    closed.real, closed.imag = x.take(places), y.take(places)
    return ComplexColumns(closed, closed[1:] - closed[:-1], shapes.radius if shapes.radius.any() else None)


def _columns_of_runs(runs: Sequence[CornerColumns]) -> ComplexColumns | None:
    """Return what `_columns_of` does for the shapes of some groups, group after group."""
    if len(runs) == 1 and (columns := runs[0].as_complex) is not None:
        return columns  # one circle, too: it has no pairs
    most, n = max([run.corners for run in runs]), sum([len(run) for run in runs])  # lists are quicker for few
    if not 1 < n <= MAX_SHAPES or _are_many_corners(most, n):
        return None
    rows, start = _rows(most), 0
    closed, radius = np.empty((rows, n), np.complex128), None
    for run in runs:
        corners, end = run.corners, start + len(run)
        part = closed[:, start:end]
        if run.as_complex is not None:
            part[:corners] = run.as_complex.closed[:corners]
        else:
            part.real[:corners], part.imag[:corners] = run.block[0], run.block[1]
        if corners < rows:
            part[corners:] = part.take(CLOSING[corners:rows, corners], axis=0)
        if corners == 1:
            radius = np.zeros(n) if radius is None else radius
            radius[start:end] = run.block[2, 0] if run.as_complex is None else run.as_complex.radius
        start = end
    return ComplexColumns(closed, closed[1:] - closed[:-1], radius)


def _are_many_corners(most: int, n: int) -> bool:
    """Return whether n shapes with up to `most` corners are evaluated faster in blocks of pairs."""
    return most > MAX_CORNERS and (most > MAX_CLOSED or most * most * n > MAX_SQUARES)


def _rows(most: int) -> int:
    """Return how many rows `ComplexColumns.closed` has for shapes with at most `most` corners."""
    return most + 1 if most > 1 else 1
