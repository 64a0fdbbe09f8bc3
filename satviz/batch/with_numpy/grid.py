"""Boxes in the cells of a grid, in NumPy: sorted by their cells, a row of cells side by side."""

from collections.abc import Iterator

import numpy as np

from ..array_types import Array, CellSize, Indices, Pairs

# (indices of queries, first stored box of each, number of stored boxes of each)
Ranges = list[tuple[Indices, Indices, Indices]]

BLOCK_PAIRS = 1 << 20  # pairs of boxes compared at a time: what bounds the memory
MAX_TABLE_CELLS_PER_BOX = 8  # up to so many a table of where each cell begins is worth its memory


def meeting_pairs(
    bounds: Array, one: Indices, other: Indices | None, cell: CellSize, most: float
) -> Iterator[Pairs] | None:
    """Return (K, 2) blocks of the pairs (i < j) of boxes that share a point, one box of each set or both of one.

    bounds: (N, 4) boxes; one, other: indices of boxes, None for the pairs within `one`; cell: width and height of a
    cell.  Return None where there are more than `most` candidates, which are the pairs of boxes to compare.
    Boxes are stored by the cell of their lower left corner, row after row.  The numbers of cells never
    decrease along an axis, so a box whose lower left corner lies between two coordinates is stored between
    the cells of these, however the division rounds.
    """
    queries, stored = one, one if other is None else other
    (low_x, high_x, own_x), (low_y, high_y, own_y) = (_cell_ranges(bounds, queries, stored, d, cell[d]) for d in (0, 1))
    width, height = (int(max(high.max(), own.max())) + 1 for high, own in ((high_x, own_x), (high_y, own_y)))
    key = own_y.astype(np.int64, copy=False) * width + own_x
    order = np.argsort(key)
    key, stored = key[order], stored[order]
    if other is None:  # each pair once: search from a box's own row on; in this order, neighbours are near in memory
        queries = stored
        low_x, high_x, low_y, high_y = (c[order] for c in (low_x, high_x, own_y, high_y))
    begin = None
    if width * height <= MAX_TABLE_CELLS_PER_BOX * len(key):
        begin = np.concatenate([[0], np.cumsum(np.bincount(key, minlength=width * height))])
    ranges: Ranges = []
    for row in range(int((high_y - low_y).max()) + 1):
        which = np.flatnonzero(high_y - low_y >= row)
        base = (low_y[which].astype(np.int64, copy=False) + row) * width
        ends = base + low_x[which], base + high_x[which] + 1
        first, last = (np.searchsorted(key, c) if begin is None else begin[c] for c in ends)
        if other is None and row == 0:
            first = np.arange(1, len(queries) + 1)  # in its own row only the boxes further on
        ranges.append((which, first, last - first))
    if sum(int(many.sum()) for _, _, many in ranges) > most:
        return None
    return _pair_blocks(bounds, queries, stored, ranges)


def _cell_ranges(
    bounds: Array, queries: Indices, stored: Indices, d: int, cell: float
) -> tuple[Indices, Indices, Indices]:
    """Return (first cell that each query must search, last one, cell of each stored box) along axis d, 0: x, 1: y.

    queries, stored: indices of boxes; cell: its length.  A box that meets a query begins before the query ends, and not
    more than its own width before the query begins.  Numbers that would not fit, or lie so far out that those next to
    one another are many cells apart, become their ranks, which keeps their order.
    """
    low, high = bounds[queries, d], bounds[queries, d + 2]
    with np.errstate(all="ignore"):
        longest = (bounds[stored, d + 2] - bounds[stored, d]).max()
        first = np.nextafter(low - np.nextafter(longest, np.inf), -np.inf)
        numbers = [np.floor(c / cell) for c in (first, high, bounds[stored, d])]
        own = numbers[2]
        lowest, highest = own.min(), own.max()
        many = highest - lowest
    if many < 1 << 30 and max(-lowest, highest) < 2.0**52:
        first, last = (np.clip(c, lowest - 1, highest + 1) for c in numbers[:2])
        return tuple((c - (lowest - 1)).astype(np.int64) for c in (first, last, own))
    found, own = np.unique(own, return_inverse=True)
    first, last = np.searchsorted(found, numbers[0]), np.searchsorted(found, numbers[1], side="right") - 1
    return first, last, own


def _pair_blocks(bounds: Array, queries: Indices, stored: Indices, ranges: Ranges) -> Iterator[Pairs]:
    """Yield arrays of the pairs (i < j) of queries and stored boxes that share a point, among those in `ranges`.

    queries, stored: indices of boxes.  ranges: for each row of cells, arrays (places of some queries, place of the
    first stored box to compare with each, how many).
    """
    # in the order of the cells: the comparisons then run through memory nearly straight on
    theirs = bounds[stored].T.copy()
    own = theirs if queries is stored else bounds[queries].T.copy()
    for which, first, many in ranges:
        end = np.cumsum(many)
        start = 0
        while start < len(which):
            # at least one query, and as many as fit the block
            done = end[start - 1] if start else 0
            stop = max(start + 1, int(np.searchsorted(end, done + BLOCK_PAIRS, side="right")))
            each = many[start:stop]
            of = np.repeat(which[start:stop], each)
            with_ = np.arange(len(of)) + np.repeat(first[start:stop] - (end[start:stop] - each - done), each)
            for d in (0, 1):  # y only for those that meet along x
                meet = (own[d][of] <= theirs[d + 2][with_]) & (theirs[d][with_] <= own[d + 2][of])
                of, with_ = of[meet], with_[meet]
            i, j = queries[of], stored[with_]
            if len(i):
                yield np.stack([np.minimum(i, j), np.maximum(i, j)], axis=1)
            start = stop
