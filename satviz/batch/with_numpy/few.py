"""Few shapes, in NumPy: which boxes meet by comparing all or by sorting and sweeping, and all collisions of few."""

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from ...engine.relate import ERROR_FACTOR_F64, MAX_ERROR_BOUND, MIN_ERROR_BOUND
from ..array_types import Array, Indices, Mask, Pairs, Signs
from ..arrays import Shapes
from ..broad_rule import ALL_PAIRS, GRID, MAX_ALL_PAIRS, MAX_SWEEP_COMPARISONS, MAX_SWEEP_NUMPY, SWEEP
from ..codes import APART, OVERLAPPING, UNDECIDED
from .filter import circle_polygon_gaps, circles, classify_clearances
from .indexed import relations

MAX_WHOLE_SHAPES = 12  # shapes up to which all pairs are tested by their edges without comparing boxes first
MAX_SHAPES, MAX_CORNERS = 1 << 12, 8  # above these, blocks of pairs in float32 are faster
MAX_PRODUCTS = 1 << 17  # of normals and corners at a time, so that they stay in the second-level cache
OUTWARD = np.array([1.0, -1.0])[:, None, None]  # turns (dy, dx) of a counter-clockwise edge into its outward normal


class Sweep(NamedTuple):
    """Boxes sorted along an axis: `order` by their lower sides, `ends` for each the place after the last it reaches.

    axis: 0 for x, 1 for y; order and ends: (n,).
    """

    axis: int
    order: Indices
    ends: Indices


def choose(bounds: Array, max_sweep: int = MAX_SWEEP_NUMPY) -> tuple[int, int, Sweep | None]:
    """Return (code of the broad phase, comparisons, the sorted boxes if a sweep was tried), as `broad_rule` says.

    For a grid the comparisons are those that a sweep would have made; -1 where they were not counted.
    """
    n = len(bounds)
    if n <= MAX_ALL_PAIRS:
        return ALL_PAIRS, n * (n - 1) // 2, None
    if n > max_sweep:
        return GRID, -1, None
    low, high = bounds.T[:2], bounds.T[2:]
    with np.errstate(all="ignore"):
        (spread_x, spread_y), (width, height) = low.max(axis=1) - low.min(axis=1), (high - low).max(axis=1)
        axis = 0 if spread_x * height >= spread_y * width else 1
    order = np.argsort(low[axis])
    ends = np.searchsorted(low[axis][order], high[axis][order], side="right")
    comparisons = int(ends.sum()) - n * (n + 1) // 2
    return (SWEEP if comparisons <= MAX_SWEEP_COMPARISONS * n else GRID), comparisons, Sweep(axis, order, ends)


def candidate_pairs(bounds: Array) -> Pairs | None:
    """Return the pairs i < j of boxes that share a point; None where a grid is chosen."""
    way, _, sweep = choose(bounds)
    if way == ALL_PAIRS:
        i, j = _all_pairs(len(bounds))
        return np.stack([i, j], axis=1)[_meet(bounds[i], bounds[j])]
    if way == GRID or sweep is None:
        return None
    first = np.arange(1, len(bounds) + 1)
    many = sweep.ends - first
    later = np.arange(many.sum()) + np.repeat(first - (np.cumsum(many) - many), many)
    low, high = bounds[sweep.order, 1 - sweep.axis], bounds[sweep.order, 3 - sweep.axis]  # on the other axis
    meet = np.flatnonzero((np.repeat(low, many) <= high[later]) & (low[later] <= np.repeat(high, many)))
    i, j = sweep.order[np.repeat(first - 1, many)[meet]], sweep.order[later[meet]]
    return np.stack([np.minimum(i, j), np.maximum(i, j)], axis=1)


@lru_cache(maxsize=MAX_ALL_PAIRS + 1)
def _all_pairs(n: int) -> tuple[Indices, Indices]:
    """Return the first and the second indices of all pairs i < j of n boxes, in order."""
    return np.triu_indices(n, 1)


def _meet(a: Array, b: Array) -> Mask:
    """Return a mask: do the boxes of each row share a point?"""
    return np.asarray(((a[:, :2] <= b[:, 2:]) & (b[:, :2] <= a[:, 2:])).all(axis=1))


def colliding_pairs(shapes: Shapes) -> Pairs | None:
    """Return the pairs i < j, in order, of few shapes that share a point; None where others must decide.

    All pairs of a kind are evaluated in float64 by a few expressions, since calls take longer than the work.
    """
    closed, radius = _closed_columns(shapes)
    if closed is None:
        return None
    n = closed.shape[2]
    with np.errstate(all="ignore"):
        if n <= MAX_WHOLE_SHAPES:
            i, j = _all_pairs(n)
        else:
            box = np.concatenate([closed.min(axis=1), closed.max(axis=1)])
            if radius is not None:
                box[:2], box[2:] = np.nextafter(box[:2] - radius, -np.inf), np.nextafter(box[2:] + radius, np.inf)
            if (pairs := candidate_pairs(box.T)) is None:
                return None
            i, j = pairs.T
        found = _relations(closed, radius, i, j)
    rest = np.flatnonzero(found == UNDECIDED)
    if rest.size:
        settled = np.empty(len(rest), np.int8)
        relations(shapes.flat, i[rest], shapes.flat, j[rest], settled)
        if settled.min() == UNDECIDED:  # circles that nearly touch
            return None
        found[rest] = settled
    hits = np.flatnonzero(found != APART)
    i, j = i[hits], j[hits]
    if n > MAX_ALL_PAIRS:
        order = np.lexsort((j, i))
        i, j = i[order], j[order]
    out = np.empty((len(i), 2), np.intp)
    out[:, 0], out[:, 1] = i, j
    return out


def _relations(closed: Array, radius: Array | None, i: Indices, j: Indices) -> Signs:
    """Return the relations of shapes i[k] and j[k], UNDECIDED within the error bound."""
    found = np.empty(len(i), np.int8)
    if radius is None:
        _relate_polygons(closed, i, j, found)
        return found
    x, y, is_circle = closed[0, 0], closed[1, 0], radius > 0
    first, second = is_circle[i], is_circle[j]
    for mask, kind in ((~(first | second), 0), (first & second, 1), (first & ~second, 2), (second & ~first, 3)):
        where = np.flatnonzero(mask)
        if not where.size:
            continue
        a, b = (j[where], i[where]) if kind == 3 else (i[where], j[where])
        out = np.empty(len(where), np.int8)
        if kind == 0:
            _relate_polygons(closed, a, b, out)
        elif kind == 1:
            circles(x[a], y[a], radius[a], x[b], y[b], radius[b], 0, out)
        else:
            classify_clearances(*circle_polygon_gaps(x[a], y[a], radius[a], closed.take(b, axis=2)), out)
        found[where] = out
    return found


def _relate_polygons(closed: Array, i: Indices, j: Indices, out: Signs) -> None:
    """Fill `out` with the relations of polygons i[k] and j[k], UNDECIDED within the error bound."""
    corners, edges = closed[:, :-1], closed[:, 1:] - closed[:, :-1]
    own, other = np.concatenate([i, j]), np.concatenate([j, i])
    normals = edges[::-1] * OUTWARD
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
    gap = np.maximum(gap[: len(i)], gap[len(i) :])
    largest = [np.abs(c) for c in (edges, closed)]
    error_bound: Array = 4 * largest[0].max() * largest[1].max() * ERROR_FACTOR_F64  # of all, then pair by pair
    if MIN_ERROR_BOUND < error_bound < MAX_ERROR_BOUND and (np.abs(gap) > error_bound).all():
        np.multiply(gap < 0, OVERLAPPING, out=out)
        return
    edge, coordinate = (c.max(axis=(0, 1)) for c in largest)
    error_bound = (edge[i] + edge[j]) * (coordinate[i] + coordinate[j]) * ERROR_FACTOR_F64
    error_bound[~((error_bound > MIN_ERROR_BOUND) & (error_bound < MAX_ERROR_BOUND))] = np.inf
    classify_clearances(gap, error_bound, out)


def _closed_columns(shapes: Shapes) -> tuple[Array | None, Array | None]:
    """Return ((2, V + 1, n) corners, one column a shape, or None for many shapes or corners; radii if there are any).

    The row after an outline's last corner starts it again.
    """
    if "groups" in vars(shapes) and len(shapes.groups) == 1:
        (group,) = shapes.groups.values()
        corners, n = group.x.shape
        if corners > MAX_CORNERS or not 1 < n <= MAX_SHAPES:
            return None, None
        closed = np.empty((2, corners + 1, n))
        closed[0, :-1], closed[1, :-1], closed[:, -1] = group.x, group.y, (group.x[0], group.y[0])
        return closed, group.r
    if not 1 < len(shapes.count) <= MAX_SHAPES or shapes.max_corners > MAX_CORNERS:
        return None, None
    x, y, start = shapes.rings
    places = start[:-1] + np.arange(shapes.max_corners + 1)[:, None] % shapes.count
    return np.stack([x[places], y[places]]), shapes.radius if shapes.radius.any() else None
