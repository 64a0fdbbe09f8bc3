"""Boxes in the cells of a grid, compiled with numba: the cells are hashed into a table, a row of cells side by side."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from ..exact_signs import Array
from ..with_numpy.grid import BLOCK_CANDIDATES, Cell, Pairs
from .jit_cache import compiled

Places = NDArray[np.int64]
Starts = NDArray[np.int32]
Table = tuple[Starts, Pairs, Places, Array, float, float, float, float, int, int, int]

MAX_CELL_NUMBER = 2.0**50  # cells from the origin: what lies farther shares the last one
SAMPLE_STEP = 17  # queries; the candidates of one in so many are counted, to estimate those of all
START_MARGIN = 2.0**-50  # more than the three that may hide what still meets


def meeting_pairs(bounds: Array, one: Pairs, other: Pairs | None, cell: Cell, most: float) -> Iterator[Pairs] | None:
    """Return an iterator over blocks of pairs (i < j) of meeting boxes; `other` None: within `one`.

    None where that takes more than about `most` candidates.
    """
    stored = one if other is None else other
    size = 1 << int(2 * len(stored) - 1).bit_length()
    table = _build_table(bounds, stored, cell[0], cell[1], size)
    queries, boxes = (table[1], table[3]) if other is None else (one, bounds[one])
    candidates = _count_candidates(boxes, other is None, table)
    if candidates > most:
        return None
    return _pair_blocks(queries, boxes, other is None, table, min(BLOCK_CANDIDATES, max(int(candidates), len(queries))))


def _pair_blocks(queries: Pairs, boxes: Array, among: bool, table: Table, block: int) -> Iterator[Pairs]:
    """Yield blocks of pairs of a query box and a stored box that meet; `among`: the queries are the stored boxes."""
    first = 0
    while first < len(queries):
        out = np.empty((block + len(table[1]), 2), np.intp)  # no query finds more than all
        first, found = _fill_pairs(queries, boxes, first, among, table, out)
        yield out[:found]


@compiled
def _cell_number(c: float, cells: float) -> int:
    """Return the number of the cell of coordinate c (`cells` per unit); it never decreases as c grows."""
    return int(max(-MAX_CELL_NUMBER, min(MAX_CELL_NUMBER, np.floor(c * cells))))


@compiled
def _build_table(bounds: Array, stored: Pairs, wide: float, high: float, size: int) -> Table:
    """Return the hash table of the stored boxes by the cell of their lower left corner; cells are wide x high."""
    n, wide, high = stored.size, 1 / wide, 1 / high
    column, row = np.empty(n, np.int64), np.empty(n, np.int64)
    reach_x = reach_y = 0.0
    left, right, bottom = 2**62, -(2**62), 2**62
    for k in range(n):
        i = stored[k]
        column[k], row[k] = _cell_number(bounds[i, 0], wide), _cell_number(bounds[i, 1], high)
        reach_x, reach_y = max(reach_x, bounds[i, 2] - bounds[i, 0]), max(reach_y, bounds[i, 3] - bounds[i, 1])
        left, right, bottom = min(left, column[k]), max(right, column[k]), min(bottom, row[k])
    stride = int(right - left) + 1
    start: Starts = np.zeros(size + 1, np.int32)
    for k in range(n):
        start[((column[k] + row[k] * stride) & (size - 1)) + 1] += 1
    for place in range(size):
        start[place + 1] += start[place]
    free = start.copy()
    ids: Pairs = np.empty(n, np.intp)
    cells: Places = np.empty((n, 2), np.int64)
    boxes: Array = np.empty((n, 4))
    for k in range(n):
        place = (column[k] + row[k] * stride) & (size - 1)
        to = free[place]
        free[place] += 1
        ids[to], cells[to, 0], cells[to, 1] = stored[k], column[k], row[k]
        for d in range(4):
            boxes[to, d] = bounds[stored[k], d]
    return start, ids, cells, boxes, reach_x, reach_y, wide, high, stride, int(left), int(bottom)


@compiled
def _first_cell(low: float, max_length: float, cells: float, least: int) -> int:
    """Return the first cell where a box of at most `max_length` can begin and still reach `low`; at least `least`."""
    return max(least, _cell_number(low - max_length - (abs(low) + max_length) * START_MARGIN, cells))


@compiled
def _stored_range(start: Starts, c0: int, c1: int, row: int, stride: int, part: int) -> tuple[int, int]:
    """Return (first, end) of the stored boxes in cells c0 to c1 of a row; part 1: those past the table's end."""
    size = start.size - 1
    first, many = (c0 + row * stride) & (size - 1), max(0, min(c1 - c0 + 1, size))
    if part == 0:
        return start[first], start[min(first + many, size)]
    return 0, start[max(first + many - size, 0)]


@compiled
def _count_candidates(boxes: Array, among: bool, table: Table) -> float:
    """Return an estimate, from a sample of the queries, of how many candidates all queries have."""
    start, _, _, _, reach_x, reach_y, wide, high, stride, left, bottom = table
    step = 1 if len(boxes) < 1000 else SAMPLE_STEP
    candidates = 0.0
    for k in range(0, len(boxes), step):
        c0, c1 = _first_cell(boxes[k, 0], reach_x, wide, left), _cell_number(boxes[k, 2], wide)
        r0 = _cell_number(boxes[k, 1], high) if among else _first_cell(boxes[k, 1], reach_y, high, bottom)
        for row in range(r0, _cell_number(boxes[k, 3], high) + 1):
            for part in range(2):
                first, last = _stored_range(start, c0, c1, row, stride, part)
                candidates += last - first
    return candidates * step


@compiled
def _fill_pairs(
    queries: Pairs, query_boxes: Array, begin: int, among: bool, table: Table, out: Pairs
) -> tuple[int, int]:
    """Fill `out` with meeting pairs of the queries from `begin` until it is full; return (next query, count)."""
    start, ids, cells, boxes, reach_x, reach_y, wide, high, stride, left, bottom = table
    found = 0
    for k in range(begin, queries.size):
        if found + ids.size > out.shape[0]:
            return k, found
        i = queries[k]
        x0, y0, x1, y1 = query_boxes[k, 0], query_boxes[k, 1], query_boxes[k, 2], query_boxes[k, 3]
        c1, r1 = _cell_number(x1, wide), _cell_number(y1, high)
        low_x, low_y = _first_cell(x0, reach_x, wide, left), _first_cell(y0, reach_y, high, bottom)
        c0, r0 = (cells[k, 0], cells[k, 1]) if among else (low_x, low_y)
        for row in range(r0, r1 + 1):
            if among and row == r0 + 1:  # in their own row only those further on, in the others all
                c0 = low_x
            after = k if among and row == r0 else -1
            for part in range(2):
                first, last = _stored_range(start, c0, c1, row, stride, part)
                for s in range(first, last):
                    meet = (boxes[s, 0] <= x1) & (x0 <= boxes[s, 2]) & (boxes[s, 1] <= y1) & (y0 <= boxes[s, 3])
                    # and not of another cell with the same place
                    if meet and cells[s, 1] == row and c0 <= cells[s, 0] <= c1 and (s > after or cells[s, 0] > c0):
                        j = ids[s]
                        out[found, 0], out[found, 1] = min(i, j), max(i, j)
                        found += 1
    return queries.size, found
