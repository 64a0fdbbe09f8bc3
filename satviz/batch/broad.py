"""The broad phase: which boxes meet, by uniform grids, one for each pair of size classes."""

from collections.abc import Generator, Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

Pairs = NDArray[np.intp]

BLOCK = 1 << 20  # candidates looked at in one go: what bounds the memory
CHEAP = 128  # looks a box that are not worth a split: a look is far cheaper than sorting again
ALIKE = 4.0


def candidate_pairs(bounds: Any) -> Pairs:
    """(K, 2) indices i < j, in order, of the boxes that meet (closed); bounds: (N, 4) x min, y min, x max, y max.

    ValueError for boxes that are not finite or turned inside out.
    """
    bounds = np.ascontiguousarray(bounds, dtype=np.float64)
    if bounds.ndim != 2 or bounds.shape[1] != 4:
        raise ValueError(f"bounds has the shape {bounds.shape}: expected (N, 4)")
    if (bad := np.flatnonzero(~((bounds[:, :2] <= bounds[:, 2:]).all(axis=1) & np.isfinite(bounds).all(axis=1)))).size:
        raise ValueError(f"bounds[{bad[0]}] is {bounds[bad[0]].tolist()}: expected finite x min, y min <= x max, y max")
    return in_order(list(candidate_blocks(bounds)))


def in_order(blocks: list[Pairs]) -> Pairs:
    """All pairs sorted by their first index, then their second."""
    pairs = np.concatenate(blocks) if blocks else np.empty((0, 2), np.intp)
    return pairs[np.lexsort((pairs[:, 1], pairs[:, 0]))]


def candidate_blocks(bounds: NDArray[np.float64]) -> Iterator[Pairs]:
    """The same pairs (i < j) a block at a time, each pair once, in no order.

    The cell is the largest width by the largest height of the boxes compared: then a
    box reaches at most into the next cell, and three rows of three cells hold all it
    can meet.  Where that gives too many to look at (one large box among small ones
    would put everything into one cell, and a square cell a stack of needles), the
    boxes are split by width or height and the halves compared with cells of their
    own.  Boxes alike within a factor of four are not split further: few of them fit a
    cell without nearly meeting.
    """
    # widths beyond float64 are capped: that changes no order
    with np.errstate(over="ignore"):
        size = np.clip(bounds[:, 2:] - bounds[:, :2], np.finfo(float).tiny, np.finfo(float).max)
    everything = np.arange(len(bounds))
    todo: list[tuple[Pairs, Pairs | None]] = [(everything, None)]  # None: among themselves
    while todo:
        one, other = todo.pop()
        both = one if other is None else np.concatenate([one, other])
        if len(one) and len(both) > 1 and (other is None or len(other)):
            halves = yield from _meeting(bounds, size, one, other, both)
            todo += halves


def _meeting(
    bounds: NDArray[np.float64], size: NDArray[np.float64], one: Pairs, other: Pairs | None, both: Pairs
) -> Generator[Pairs, None, list[tuple[Pairs, Pairs | None]]]:
    """The meeting pairs of two sets or within one; or, if that is dear, the smaller tasks to do instead.

    Boxes are stored by the cell of their lower left corner, row after row.
    """
    cell = size[both].max(axis=0)
    x, y = (_cells(bounds[both, d], cell[d]) for d in (0, 1))
    width = int(x.max()) + 3
    key = y * width + x
    if other is None:
        order = np.argsort(key)
        key, stored = key[order], both[order]
        queries, at = stored, key
        rows = ((0, 0, 1), (1, -1, 1))  # each pair of cells once
    else:
        order = np.argsort(key[len(one) :])
        at, key = key[: len(one)], key[len(one) :][order]
        queries, stored = one, other[order]
        rows = ((-1, -1, 1), (0, -1, 1), (1, -1, 1))
    ranges = []
    for row, left, right in rows:
        base = at + row * width
        last = np.searchsorted(key, base + right, side="right")
        # among themselves, in their own row: those further on in this cell, and the next cell
        own = other is None and row == 0
        first = np.arange(1, len(queries) + 1) if own else np.searchsorted(key, base + left)
        ranges.append((first, last))
    looks = sum(int(np.maximum(last - first, 0).sum()) for first, last in ranges)
    if looks > CHEAP * len(both) and (halves := _halves(size, one, other)):
        return halves
    for first, last in ranges:
        yield from _met(bounds, queries, stored, first, last)
    return []


def _halves(size: NDArray[np.float64], one: Pairs, other: Pairs | None) -> list[tuple[Pairs, Pairs | None]]:
    """The same comparison with the boxes that set the cell's width or height split; nothing if they are alike.

    They are split half way (by ratio) between the smallest and the largest.
    """
    spreads = []
    for d in (0, 1):
        swap = other is not None and size[other, d].max() > size[one, d].max()
        sizes = size[other if swap else one, d]
        with np.errstate(over="ignore"):
            spreads.append((sizes.max() / sizes.min(), d, swap))
    spread, d, swap = max(spreads)
    if spread <= ALIKE:
        return []
    one, other = (other, one) if swap else (one, other)
    logs = np.log2(size[one, d])
    is_small = logs <= (logs.min() + logs.max()) / 2
    small, large = one[is_small], one[~is_small]
    if other is None:
        return [(small, None), (large, None), (small, large)]
    return [(small, other), (large, other)]


def _cells(low: NDArray[np.float64], cell: float) -> Pairs:
    """Cell numbers from 1; where they would not fit, empty stretches are shortened, which keeps neighbours."""
    with np.errstate(over="ignore"):
        numbers = np.floor(low / cell)
    if not np.isfinite(numbers).all():  # cells far too small to count: what lies nearer than one shares it
        found, where = np.unique(low, return_inverse=True)
        return np.concatenate([[1], 1 + np.cumsum(np.where(np.diff(found) > cell, 3, 0))])[where]
    lowest = numbers.min()
    if numbers.max() - lowest < 1 << 30:
        return (numbers - lowest).astype(np.int64) + 1
    found, where = np.unique(numbers, return_inverse=True)
    return np.concatenate([[1], np.cumsum(np.minimum(np.diff(found), 3)).astype(np.int64) + 1])[where]


def _met(bounds: NDArray[np.float64], queries: Pairs, stored: Pairs, first: Pairs, last: Pairs) -> Iterator[Pairs]:
    """Of each query with stored[first:last], those whose boxes meet."""
    count = np.maximum(last - first, 0)
    end = np.cumsum(count)
    # in the order of the cells: the looks then run through memory nearly straight on
    (px0, py0, px1, py1), (qx0, qy0, qx1, qy1) = bounds[queries].T.copy(), bounds[stored].T.copy()
    start = 0
    while start < len(queries):
        # at least one query, and as many as fit the block
        done = end[start - 1] if start else 0
        stop = max(start + 1, int(np.searchsorted(end, done + BLOCK, side="right")))
        each = count[start:stop]
        if each.any():
            of = np.repeat(np.arange(start, stop), each)
            with_ = np.arange(len(of)) + np.repeat(first[start:stop] - (end[start:stop] - each - done), each)
            meet = (px0[of] <= qx1[with_]) & (qx0[with_] <= px1[of])
            of, with_ = of[meet], with_[meet]
            meet = (py0[of] <= qy1[with_]) & (qy0[with_] <= py1[of])
            i, j = queries[of[meet]], stored[with_[meet]]
            yield np.stack([np.minimum(i, j), np.maximum(i, j)], axis=1)
        start = stop
