"""The broad phase: which boxes meet, by uniform grids, one for each pair of size classes."""

from collections.abc import Generator, Iterator

import numpy as np
from numpy.typing import NDArray

from . import door

Pairs = NDArray[np.intp]

BLOCK = 1 << 20  # candidates looked at in one go: what bounds the memory
CHEAP = 128  # looks a box that are not worth a split: a look is far cheaper than sorting again
ALIKE = 4.0


def candidate_pairs(bounds: door.Points) -> Pairs:
    """(K, 2) indices i < j, in order, of the boxes that meet (closed); bounds: (N, 4) x min, y min, x max, y max.

    InvalidShape for boxes that are not finite or turned inside out.
    """
    return in_order(list(candidate_blocks(door.boxes(bounds))))


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
    # places and widths beyond float64 are capped: that changes no order
    bounds = np.clip(bounds, -np.finfo(float).max, np.finfo(float).max)
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

    Boxes are stored by the cell of their lower left corner, row after row.  The numbers of
    cells never decrease along an axis, so a box whose lower left corner lies between two
    places is stored between their cells, however the division rounds.
    """
    queries, stored = one, one if other is None else other
    cell = np.maximum(size[both].max(axis=0), np.abs(bounds[both]).max() * 2.0**-1000)  # so that no number overflows
    (low_x, high_x, own_x), (low_y, high_y, own_y) = (_cells(bounds, size, queries, stored, d, cell[d]) for d in (0, 1))
    width = int(max(high_x.max(), own_x.max())) + 1
    key = own_y * width + own_x
    order = np.argsort(key)
    key, stored = key[order], stored[order]
    if other is None:  # each pair once: rows from a box's own on; in the order of the cells, neighbours lie near
        queries, low_x, high_x, low_y, high_y = (c[order] for c in (queries, low_x, high_x, own_y, high_y))
    ranges = []
    for row in range(int((high_y - low_y).max()) + 1):
        base = (low_y + row) * width
        last = np.searchsorted(key, base + high_x, side="right")
        if other is None and row == 0:
            first = np.arange(1, len(queries) + 1)  # in their own row: those further on
        else:
            first = np.searchsorted(key, base + low_x)
            last[low_y + row > high_y] = 0
        ranges.append((first, last))
    looks = sum(int(np.maximum(last - first, 0).sum()) for first, last in ranges)
    if looks > CHEAP * len(both) and (halves := _halves(size, one, other)):
        return halves
    for first, last in ranges:
        yield from _met(bounds, queries, stored, first, last)
    return []


def _cells(
    bounds: NDArray[np.float64],
    size: NDArray[np.float64],
    queries: Pairs,
    stored: Pairs,
    d: int,
    cell: float,
) -> tuple[Pairs, Pairs, Pairs]:
    """Along one axis: the first and last cell in which what meets each query can be stored, and each stored box's own.

    A box that meets a query begins before the query ends, and not more than its own width before the
    query begins.  Numbers that would not fit become their ranks, which keeps their order.
    """
    low, high = bounds[queries, d], bounds[queries, d + 2]
    with np.errstate(over="ignore"):
        first = np.nextafter(low - np.nextafter(size[stored, d].max(), np.inf), -np.inf)
        numbers = [np.floor(c / cell) for c in (first, high, bounds[stored, d])]
        own = numbers[2]
        lowest, highest = own.min(), own.max()
        many = highest - lowest
    if many < 1 << 30:
        first, last = (np.clip(c, lowest - 1, highest + 1) for c in numbers[:2])
        return tuple((c - (lowest - 1)).astype(np.int64) for c in (first, last, own))
    found, own = np.unique(own, return_inverse=True)
    return np.searchsorted(found, numbers[0]), np.searchsorted(found, numbers[1], side="right") - 1, own


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
    if other is not None and swap:
        one, other = other, one
    logs = np.log2(size[one, d])
    is_small = logs <= (logs.min() + logs.max()) / 2
    small, large = one[is_small], one[~is_small]
    if other is None:
        return [(small, None), (large, None), (small, large)]
    return [(small, other), (large, other)]


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
