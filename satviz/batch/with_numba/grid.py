"""Boxes in the cells of a grid, compiled with numba: a hash table in which a row of cells is one run."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from ..array_types import Array, CellSize, Indices, Pairs
from .filter import range_gap
from .jit_cache import compiled, inlined

Ids = NDArray[np.int32] | Indices  # indices of boxes
Starts = NDArray[np.int32]  # where the boxes of each entry of the table begin, and the last one ends
# start, indices and boxes in the order of the table; largest width and height of a box; cells per unit along
# x and y; cells in a row; the first column and row in use
Table = tuple[Starts, Ids, Array, float, float, float, float, int, int, int]

BLOCK_PAIRS = 1 << 20  # pairs in one block at most, besides those of its last query: what bounds the memory
MAX_CELL_NUMBER = 2.0**50  # cells from the origin: what lies farther shares the last one
SAMPLE_STEP = 17  # the candidates of every 17th query are counted
ROUNDING_MARGIN = 2.0**-50  # relative: above the 3 * 2**-53 by which `_first_cell` may round a start up


def meeting_pairs(
    bounds: Array, one: Indices, other: Indices | None, cell: CellSize, most: float
) -> Iterator[Pairs] | None:
    """Return (K, 2) blocks of the pairs (i < j) of boxes that share a point, one box of each set or both of one.

    bounds: (N, 4) boxes; one, other: indices of boxes, None for the pairs within `one`; cell: width and height of a
    cell.  Return None where there are more than about `most` candidates, which are the pairs of boxes to compare.
    """
    stored = one if other is None else other
    size = 1 << int(3 * len(stored) // 2).bit_length()
    table = build_table(bounds, stored, cell[0], cell[1], size)
    queries, boxes = (table[1], table[2]) if other is None else (one, bounds[one])
    candidates = count_candidates(boxes, other is None, table)
    if candidates > most:
        return None
    return _pair_blocks(queries, boxes, other is None, table, min(BLOCK_PAIRS, max(int(candidates), len(queries))))


def _pair_blocks(queries: Ids, boxes: Array, same_set: bool, table: Table, block: int) -> Iterator[Pairs]:
    """Yield arrays of the pairs (i < j) of queries and stored boxes that share a point, of about `block` pairs each.

    queries: (n,) indices of boxes; boxes: (n, 4) their bounds; `same_set`: the queries are the stored boxes.
    """
    first = 0
    while first < len(queries):
        out = np.empty((block + len(table[1]), 2), np.intp)  # no query finds more than all
        first, found = fill_pairs(queries, boxes, first, same_set, table, out)
        yield out[:found]


@compiled
def _cell_number(c: float, cells_per_unit: float) -> int:
    """Return the number of a coordinate's cell; it never decreases with the coordinate, however the product rounds."""
    return int(max(-MAX_CELL_NUMBER, min(MAX_CELL_NUMBER, np.floor(c * cells_per_unit))))


@compiled
def build_table(bounds: Array, stored: Indices, cell_width: float, cell_height: float, size: int) -> Table:
    """Return a hash table with `size` entries of the boxes `stored`, ordered by the cell of their lower left corner.

    bounds: (N, 4) boxes; stored: indices of some.  A Table is (where each entry begins, indices of the boxes, their
    bounds, largest width, largest height, cells per unit along x, along y, cells in a row, first column, first row).

    Cells are computed where they are needed: keeping them would take more time and memory.
    """
    n, per_x, per_y = stored.size, 1 / cell_width, 1 / cell_height
    max_width = max_height = 0.0
    left, right, bottom = 2**62, -(2**62), 2**62
    for k in range(n):
        i = stored[k]
        column = _cell_number(bounds[i, 0], per_x)
        left, right, bottom = min(left, column), max(right, column), min(bottom, _cell_number(bounds[i, 1], per_y))
        max_width = max(max_width, bounds[i, 2] - bounds[i, 0])
        max_height = max(max_height, bounds[i, 3] - bounds[i, 1])
    stride = int(right - left) + 1
    # entry e is counted at e + 2 and filled from start[e + 1] on, which then is where entry e + 1 begins
    start: Starts = np.zeros(size + 2, np.int32)
    for k in range(n):
        i = stored[k]
        start[_entry(bounds[i, 0], bounds[i, 1], per_x, per_y, stride, size) + 2] += 1
    for entry in range(size):
        start[entry + 2] += start[entry + 1]
    ids: Ids = np.empty(n, np.int32)
    boxes: Array = np.empty((n, 4))
    for k in range(n):
        i = stored[k]
        entry = _entry(bounds[i, 0], bounds[i, 1], per_x, per_y, stride, size)
        to = start[entry + 1]
        start[entry + 1] += 1
        ids[to] = i
        for d in range(4):
            boxes[to, d] = bounds[i, d]
    return start[: size + 1], ids, boxes, max_width, max_height, per_x, per_y, stride, int(left), int(bottom)


@inlined
def _entry(x: float, y: float, per_x: float, per_y: float, stride: int, size: int) -> int:
    """Return the table entry of the cell of a point.

    per_x, per_y: cells per unit; stride: cells in a row; size: entries of the table, a power of two.
    """
    return (_cell_number(x, per_x) + _cell_number(y, per_y) * stride) & (size - 1)


@compiled
def _first_cell(low: float, max_length: float, cells_per_unit: float, least: int) -> int:
    """Return the first cell in which a box at most `max_length` long can begin that ends at `low` or later.

    `least`: the first cell in which any stored box begins.
    """
    return max(least, _cell_number(low - max_length - (abs(low) + max_length) * ROUNDING_MARGIN, cells_per_unit))


@compiled
def _stored_range(start: Starts, c0: int, c1: int, row: int, stride: int, part: int) -> tuple[int, int]:
    """Return (first, last): the boxes of cells c0 to c1, both included, of a row are table boxes first to last - 1.

    Cells wrap around at the table's end: part 0 stops there, and part 1 continues at the table's start.
    """
    size = start.size - 1
    first, many = (c0 + row * stride) & (size - 1), max(0, min(c1 - c0 + 1, size))
    if part == 0:
        return start[first], start[min(first + many, size)]
    return 0, start[max(first + many - size, 0)]


@compiled
def count_candidates(boxes: Array, same_set: bool, table: Table) -> float:
    """Return about how many candidates (boxes to compare with) all queries have, estimated from a sample.

    boxes: (n, 4) bounds of the queries.  same_set: the queries are the stored boxes, so only rows from the query's own
    row on are counted.
    """
    start, _, _, max_width, max_height, per_x, per_y, stride, left, bottom = table
    step = 1 if len(boxes) < 1000 else SAMPLE_STEP
    candidates = 0.0
    for k in range(0, len(boxes), step):
        c0, c1 = _first_cell(boxes[k, 0], max_width, per_x, left), _cell_number(boxes[k, 2], per_x)
        r0 = _cell_number(boxes[k, 1], per_y) if same_set else _first_cell(boxes[k, 1], max_height, per_y, bottom)
        for row in range(r0, _cell_number(boxes[k, 3], per_y) + 1):
            for part in range(2):
                first, last = _stored_range(start, c0, c1, row, stride, part)
                candidates += last - first
    return candidates * step


@compiled
def fill_pairs(
    queries: Ids, query_boxes: Array, begin: int, same_set: bool, table: Table, out: Pairs
) -> tuple[int, int]:
    """Fill `out` with pairs of queries from query `begin` on, while it has space; return (next query, number of pairs).

    A pair (i < j) is a query and a stored box that share a point.  Arguments as in `_pair_blocks`.
    """
    start, ids, boxes, max_width, max_height, per_x, per_y, stride, left, bottom = table
    found = 0
    for k in range(begin, queries.size):
        if found + ids.size > out.shape[0]:
            return k, found
        i = queries[k]
        x0, y0, x1, y1 = query_boxes[k, 0], query_boxes[k, 1], query_boxes[k, 2], query_boxes[k, 3]
        c1, r1 = _cell_number(x1, per_x), _cell_number(y1, per_y)
        low_x, low_y = _first_cell(x0, max_width, per_x, left), _first_cell(y0, max_height, per_y, bottom)
        c0, r0 = (_cell_number(x0, per_x), _cell_number(y0, per_y)) if same_set else (low_x, low_y)
        for row in range(r0, r1 + 1):
            if (
                same_set and row == r0 + 1
            ):  # its own row holds each pair once, further on; the other rows are searched whole
                c0 = low_x
            after = k if same_set and row == r0 else -1
            for part in range(2):
                first, last = _stored_range(start, c0, c1, row, stride, part)
                for s in range(first, last):
                    gap = max(range_gap(x0, x1, boxes[s, 0], boxes[s, 2]), range_gap(y0, y1, boxes[s, 1], boxes[s, 3]))
                    if gap > 0:
                        continue
                    column = _cell_number(boxes[s, 0], per_x)
                    if column < c0 or column > c1 or _cell_number(boxes[s, 1], per_y) != row:
                        continue  # cells of other numbers share entries of the table
                    if s > after or column > c0:
                        j = ids[s]
                        out[found, 0], out[found, 1] = min(i, j), max(i, j)
                        found += 1
    return queries.size, found
