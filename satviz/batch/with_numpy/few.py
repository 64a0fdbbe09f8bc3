"""Few shapes, in NumPy: which boxes meet by comparing all or by sorting and sweeping, and all collisions of few."""

from functools import lru_cache

import numpy as np

from ...engine.relate import ERROR_FACTOR_F64, MAX_ERROR_BOUND, MIN_ERROR_BOUND
from ..array_types import Array, Indices, Mask, Pairs
from ..arrays import Shapes
from ..broad_rule import ALL_PAIRS, GRID, MAX_ALL_PAIRS, MAX_SWEEP, MAX_SWEEP_COMPARISONS, SWEEP

MAX_WHOLE_SHAPES = 24  # shapes up to which all pairs are tested by their edges without comparing boxes first


def choose(bounds: Array) -> tuple[int, int, Indices | None, Indices | None]:
    """Return (code of the broad phase, comparisons, order, ends), by the rule of `broad_rule`.

    For a sweep, `order` is the boxes by their lower sides along an axis, and `ends` for each the place after the last
    one that begins within it.
    """
    n = len(bounds)
    if n <= MAX_ALL_PAIRS:
        return ALL_PAIRS, n * (n - 1) // 2, None, None
    if n > MAX_SWEEP:
        return GRID, -1, None, None
    low, high = bounds.T[:2], bounds.T[2:]
    with np.errstate(all="ignore"):
        (spread_x, spread_y), (width, height) = low.max(axis=1) - low.min(axis=1), (high - low).max(axis=1)
        axis = 0 if spread_x * height >= spread_y * width else 1
    order = np.argsort(low[axis])
    ends = np.searchsorted(low[axis][order], high[axis][order], side="right")
    comparisons = int(ends.sum()) - n * (n + 1) // 2
    return (SWEEP if comparisons <= MAX_SWEEP_COMPARISONS * n else GRID), comparisons, order, ends


def candidate_pairs(bounds: Array) -> Pairs | None:
    """Return the pairs i < j of boxes that share a point; None where a grid is chosen."""
    way, _, order, ends = choose(bounds)
    if way == ALL_PAIRS:
        i, j = _all_pairs(len(bounds))
        return np.stack([i, j], axis=1)[_meet(bounds[i], bounds[j])]
    if way == GRID or order is None or ends is None:
        return None
    first = np.arange(1, len(order) + 1)
    many = ends - first
    i = np.repeat(order, many)
    j = order[np.arange(len(i)) + np.repeat(first - (np.cumsum(many) - many), many)]
    meet = np.flatnonzero(_meet(bounds[i], bounds[j]))
    i, j = i[meet], j[meet]
    return np.stack([np.minimum(i, j), np.maximum(i, j)], axis=1)


@lru_cache(maxsize=MAX_ALL_PAIRS + 1)
def _all_pairs(n: int) -> tuple[Indices, Indices]:
    """Return the first and the second indices of all pairs i < j of n boxes, in order."""
    return np.triu_indices(n, 1)


def _meet(a: Array, b: Array) -> Mask:
    """Return a mask: do the boxes of each row share a point?"""
    found: Mask = ((a[:, :2] <= b[:, 2:]) & (b[:, :2] <= a[:, 2:])).all(axis=1)
    return found


def colliding_pairs(shapes: Shapes) -> Pairs | None:
    """Return the pairs i < j, in order, of few polygons with one number of corners; None where others decide them."""
    n = len(shapes.count)
    if not 1 < n <= MAX_WHOLE_SHAPES or "groups" not in vars(shapes) or len(shapes.groups) > 1 or 1 in shapes.groups:
        return None
    (group,) = shapes.groups.values()
    i, j = _all_pairs(n)
    x, y = np.concatenate([group.x, group.x[:1]]), np.concatenate([group.y, group.y[:1]])
    with np.errstate(all="ignore"):
        nx, ny = y[1:] - y[:-1], x[:-1] - x[1:]
        gap = np.maximum(_clearance(nx, ny, group.x, group.y, i, j), _clearance(nx, ny, group.x, group.y, j, i))
        edge = max(nx.max(), ny.max(), -nx.min(), -ny.min())
        coordinate = max(group.x.max(), group.y.max(), -group.x.min(), -group.y.min())
        error_bound = 4 * edge * coordinate * ERROR_FACTOR_F64
        if not MIN_ERROR_BOUND < error_bound < MAX_ERROR_BOUND or np.abs(gap).min() <= error_bound:
            return None
    hits = np.flatnonzero(gap < 0)
    return np.stack([i[hits], j[hits]], axis=1)


def _clearance(nx: Array, ny: Array, x: Array, y: Array, own: Indices, other: Indices) -> Array:
    """Return for each pair the largest clearance of any edge of shape `own` from shape `other`.

    nx, ny: (V, n) outward normals, each at the corner x, y.
    """
    nx, ny = nx[:, own], ny[:, own]
    values = nx[:, None] * x[:, other]
    values += ny[:, None] * y[:, other]
    least = values.min(axis=1)
    least -= nx * x[:, own] + ny * y[:, own]
    found: Array = least.max(axis=0)
    return found
