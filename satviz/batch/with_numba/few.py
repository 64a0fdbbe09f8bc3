"""Up to some thousand shapes, compiled with numba: from their corners to all colliding pairs in one call.

For few shapes Python between the calls takes longer than the work.
Names in the kernels: x, y are corners, those of shape i from start[i] to start[i + 1]; radius is 0 for polygons;
bounds are boxes (x min, y min, x max, y max).
"""

from typing import SupportsIndex

import numpy as np

from ..array_types import Array, Indices, Mask, Pairs, Relations
from ..arrays import Flat, Shapes
from ..broad_rule import (
    ALL_PAIRS,
    GRID,
    MAX_ALL_PAIRS,
    MAX_CANDIDATES_PER_BOX,
    MAX_SWEEP_COMPARISONS,
    MAX_SWEEP_NUMBA,
    SWEEP,
)
from ..codes import APART, UNDECIDED
from .grid import build_table, count_candidates, fill_pairs
from .indexed import fill_relations
from .jit_cache import compiled

MAX_SHAPES = 1 << 14  # above it blocks of pairs bound the memory, and Python no longer matters
WORD_BYTES = 8  # marks that are read at once
MAX_BUCKET = 32  # values in one bucket up to which insertion sorts fast
MIN_CELL = 2.0**-48  # least cell size as a factor of the farthest coordinate: numbers of smaller cells run together


def colliding_pairs(shapes: Shapes) -> Pairs | None:
    """Return the pairs i < j, in order, of the shapes that share a point; None for too many, or if one is undecided."""
    runs = vars(shapes).get("runs")  # read once, since another thread may join them
    if runs is not None and len(runs) == 1:
        pairs, decided = _collide_block(runs[0].block)
    elif runs is not None and len(runs) <= MAX_RUNS:
        pairs, decided = _collide_blocks(*(run.block for run in runs), *[NO_BLOCK] * (MAX_RUNS - len(runs)))
    else:
        pairs, decided = _collide(*shapes.rings, shapes.radius)
    return pairs if decided else None


MAX_RUNS = 4  # groups of shapes that one call takes as they lie
NO_BLOCK = np.empty((2, 1, 0))


@compiled
def _collide_block(block: Array) -> tuple[Pairs, bool]:
    """Return what `_collide` returns, for the block of one CornerColumns: (2, V, n), or (3, 1, n) for circles."""
    _, corners, n = block.shape
    if n > MAX_SHAPES:
        return np.empty((0, 2), np.intp), False
    xy, start, radius = np.empty((2, corners * n)), np.empty(n + 1, np.intp), np.zeros(n)
    for v in range(corners):
        for i in range(n):
            xy[0, i * corners + v], xy[1, i * corners + v] = block[0, v, i], block[1, v, i]
    for i in range(n + 1):
        start[i] = i * corners
        if i < n and block.shape[0] == 3:
            radius[i] = block[2, 0, i]
    return _collide(xy[0], xy[1], start, radius)


@compiled
def _collide_blocks(a: Array, b: Array, c: Array, d: Array) -> tuple[Pairs, bool]:
    """Return what `_collide` returns, for the blocks of four CornerColumns, their shapes numbered from a's to d's."""
    n = a.shape[2] + b.shape[2] + c.shape[2] + d.shape[2]
    if n > MAX_SHAPES:
        return np.empty((0, 2), np.intp), False
    corners = a[0].size + b[0].size + c[0].size + d[0].size
    xy, start, radius = np.empty((2, corners)), np.zeros(n + 1, np.intp), np.zeros(n)
    i = to = 0
    for block in (a, b, c, d):
        for k in range(block.shape[2]):
            for v in range(block.shape[1]):
                xy[0, to], xy[1, to] = block[0, v, k], block[1, v, k]
                to += 1
            if block.shape[0] == 3:
                radius[i] = block[2, 0, k]
            i += 1
            start[i] = to
    return _collide(xy[0], xy[1], start, radius)


@compiled
def _collide(x: Array, y: Array, start: Indices, radius: Array) -> tuple[Pairs, bool]:
    """Return (pairs i < j of the shapes that share a point, in order; whether all pairs are decided).

    If not, the pairs mean nothing.
    """
    n = radius.size
    if n > MAX_SHAPES:
        return np.empty((0, 2), np.intp), False
    bounds, upright = np.empty((n, 4)), np.empty(n, np.bool_)
    fill_boxes(x, y, start, radius, bounds, upright)
    candidates, _, _, complete = _candidate_pairs(bounds)
    if not complete:
        return candidates, False
    both, found = candidates.T.copy(), np.empty(len(candidates), np.int8)
    first, second = both[0], both[1]
    fill_relations(x, y, start, radius, bounds, upright, x, y, start, radius, bounds, upright, first, second, found)
    return _hits_in_order(first, second, found, n)


@compiled
def _hits_in_order(first: Indices, second: Indices, found: Relations, n: int) -> tuple[Pairs, bool]:
    """Return ((K, 2) pairs that are not apart, sorted by i, then by j; whether all pairs are decided).

    Pair k is (first[k], second[k]) with the relation found[k]; n is the number of shapes.  If one is UNDECIDED, no pair
    is returned.
    """
    start = np.zeros(n + 1, np.intp)
    for k in range(found.size):
        if found[k] == UNDECIDED:
            return np.empty((0, 2), np.intp), False
        start[first[k] + 1] += found[k] != APART
    for i in range(n):
        start[i + 1] += start[i]
    out, end = np.empty((start[n], 2), np.intp), start.copy()
    for k in range(found.size):
        if found[k] != APART:
            i, to = first[k], end[first[k]]
            end[i] += 1
            while to > start[i] and out[to - 1, 1] > second[k]:  # few pairs begin with one shape
                out[to, 1] = out[to - 1, 1]
                to -= 1
            out[end[i] - 1, 0], out[to, 1] = i, second[k]
    return out, True


def flatten(shapes: Shapes) -> Flat:
    """Return all convex parts of a batch as a Flat: one after another, with their bounding boxes."""
    x, y, start = shapes.rings
    bounds, upright = np.empty((len(start) - 1, 4)), np.empty(len(start) - 1, bool)
    fill_boxes(x, y, start, shapes.radius, bounds, upright)
    return Flat(x, y, start, shapes.radius, bounds, upright)


@compiled
def fill_boxes(x: Array, y: Array, start: Indices, radius: Array, bounds: Array, upright: Mask) -> None:
    """Fill `bounds` with rows x0, y0, x1, y1, circles' rounded outwards, and `upright` with whether a shape is its box.

    Shape i has the corners start[i] to start[i + 1] - 1 of x, y, and the radius radius[i]: 0 for polygons.
    """
    for i in range(radius.size):
        x0 = y0 = np.inf
        x1 = y1 = -np.inf
        for j in range(start[i], start[i + 1]):
            x0, y0, x1, y1 = min(x0, x[j]), min(y0, y[j]), max(x1, x[j]), max(y1, y[j])
        if radius[i] > 0:
            x0, y0 = np.nextafter(x0 - radius[i], -np.inf), np.nextafter(y0 - radius[i], -np.inf)
            x1, y1 = np.nextafter(x1 + radius[i], np.inf), np.nextafter(y1 + radius[i], np.inf)
        bounds[i, 0], bounds[i, 1], bounds[i, 2], bounds[i, 3] = x0, y0, x1, y1
        upright[i] = False
        if start[i + 1] - start[i] == 4:
            j = start[i]
            flat = x[j] == x[j + 1] and x[j + 2] == x[j + 3] and y[j + 1] == y[j + 2] and y[j + 3] == y[j]
            steep = y[j] == y[j + 1] and y[j + 2] == y[j + 3] and x[j + 1] == x[j + 2] and x[j + 3] == x[j]
            upright[i] = flat or steep


def candidate_pairs(bounds: Array) -> tuple[Pairs | None, int, int]:
    """Return (pairs i < j of boxes that share a point, unsorted, code of the broad phase, its comparisons or -1).

    bounds: (N, 4).  The pairs are None where grids for several sizes must find them; comparisons are -1 where they were
    not counted.
    """
    if len(bounds) > MAX_SHAPES:
        return None, GRID, -1
    pairs, way, comparisons, found = _candidate_pairs(np.ascontiguousarray(bounds))
    return pairs if found else None, way, comparisons


@compiled
def _candidate_pairs(bounds: Array) -> tuple[Pairs, int, int, bool]:
    """Return (pairs i < j of boxes that share a point, code of the broad phase, comparisons or -1, is it completed).

    The broad phase is chosen by the rule of `broad_rule`.  It is not completed, and there are no pairs, where
    one grid and a sweep would both compare too many boxes.
    """
    n = len(bounds)
    if n <= MAX_ALL_PAIRS:
        return _all_pairs(bounds), ALL_PAIRS, n * (n - 1) // 2, True
    axis, most = sweep_axis(bounds), MAX_SWEEP_COMPARISONS * n
    if n <= MAX_SWEEP_NUMBA:
        out, compared = _sweep(bounds, axis)
        if compared > most:
            other_out, other_compared = _sweep(bounds, 1 - axis)
            if other_compared < compared:
                return other_out, SWEEP, other_compared, True
        return out, SWEEP, compared, True
    out, counted = _pairs_of_one_grid(bounds)
    if counted:
        return out, GRID, -1, True
    compared = _count_comparisons(bounds, axis)
    if compared > most:
        other_compared = _count_comparisons(bounds, 1 - axis)
        if other_compared < compared:
            axis, compared = 1 - axis, other_compared
    if compared > most:
        return np.empty((0, 2), np.intp), GRID, compared, False
    return _sweep(bounds, axis)[0], SWEEP, compared, True


@compiled
def _pairs_of_one_grid(bounds: Array) -> tuple[Pairs, bool]:
    """Return (pairs i < j of boxes that share a point, True); (no pairs, False) if one grid would compare too many."""
    n = len(bounds)
    width = height = farthest = 0.0
    for i in range(n):
        width, height = max(width, bounds[i, 2] - bounds[i, 0]), max(height, bounds[i, 3] - bounds[i, 1])
        farthest = max(farthest, max(max(-bounds[i, 0], bounds[i, 2]), max(-bounds[i, 1], bounds[i, 3])))
    width, height = max(width, farthest * MIN_CELL), max(height, farthest * MIN_CELL)
    if not (width > 1e-300 and height > 1e-300 and farthest < 1e300):  # cells whose numbers could overflow
        return np.empty((0, 2), np.intp), False
    size = 1
    while size < 2 * n:
        size *= 2
    table = build_table(bounds, np.arange(n).astype(np.int32), width, height, size)
    if count_candidates(table[2], True, table) > MAX_CANDIDATES_PER_BOX * n:
        return np.empty((0, 2), np.intp), False
    # A literal 0 would make numba compile the calls below twice: for the literal and for int64.
    out, begin, found = np.empty((4 * n, 2), np.intp), int(np.intp(0)), np.intp(0)
    while begin < n:
        begin, added = fill_pairs(table[1], table[2], begin, True, table, out[found:])
        found += added
        if begin < n:
            out = _longer(out, found)
    return out[:found], True


@compiled
def _all_pairs(bounds: Array) -> Pairs:
    """Return the pairs i < j of boxes that share a point, in order, by comparing all.

    For each box those that meet it are marked first, without a branch, which the compiler vectorises.
    """
    n = len(bounds)
    sides = bounds.T.copy()
    x0, y0, x1, y1 = sides[0], sides[1], sides[2], sides[3]
    mask = np.empty((n // WORD_BYTES + 1) * WORD_BYTES, np.uint8)
    words = mask.view(np.uint64)
    out, found = np.empty((4 * n, 2), np.intp), np.intp(0)  # as Python, 0 would grow in the type of the mask
    for i in range(n - 1):
        first, width = i + 1, n - i - 1
        left, bottom, right, top = x0[i], y0[i], x1[i], y1[i]
        for m in range(width):
            j = first + m
            mask[m] = (x0[j] <= right) & (x1[j] >= left) & (y0[j] <= top) & (y1[j] >= bottom)
        used = (width + WORD_BYTES - 1) // WORD_BYTES
        mask[width : used * WORD_BYTES] = 0
        if found + n > len(out):
            out = _longer(out, found)
        for w in range(used):
            if words[w]:
                for m in range(w * WORD_BYTES, (w + 1) * WORD_BYTES):
                    out[found, 0], out[found, 1] = i, first + m
                    found += mask[m]
    return out[:found]


@compiled
def _longer(pairs: Pairs, found: SupportsIndex) -> Pairs:
    """Return an array of twice the length of `pairs` that begins with the first `found` of them."""
    more = np.empty((2 * len(pairs), 2), np.intp)
    for k in range(found):  # numba takes seconds to compile an assignment of a slice
        more[k, 0], more[k, 1] = pairs[k, 0], pairs[k, 1]
    return more


@compiled
def _sweep(bounds: Array, axis: int) -> tuple[Pairs, int]:
    """Return (pairs i < j of boxes that share a point, how many were compared), by sort and sweep along x (0) or y (1).

    The boxes that follow a box are marked first, some at a time, without a branch, which the compiler vectorises.
    """
    n = len(bounds)
    order = _argsort(bounds[:, axis].copy())
    low, high = np.full(n + WORD_BYTES, np.nan), np.empty(n)  # nan beyond the last box: even one without end ends there
    side_low, side_high = np.empty(n + WORD_BYTES), np.empty(n + WORD_BYTES)
    for k in range(n):
        i = order[k]
        low[k], high[k] = bounds[i, axis], bounds[i, axis + 2]
        side_low[k], side_high[k] = bounds[i, 1 - axis], bounds[i, 3 - axis]
    mask = np.empty(WORD_BYTES, np.uint8)
    word = mask.view(np.uint64)
    out, found, compared = np.empty((4 * n, 2), np.intp), np.intp(0), 0
    for k in range(n):
        i, end, least, most = order[k], high[k], side_low[k], side_high[k]
        if found + n > len(out):
            out = _longer(out, found)
        m = k + 1
        while low[m] <= end:
            reached = 0
            for v in range(WORD_BYTES):
                reached += low[m + v] <= end
                mask[v] = (low[m + v] <= end) & (side_low[m + v] <= most) & (side_high[m + v] >= least)
            if word[0]:
                for v in range(WORD_BYTES):
                    if mask[v]:
                        j = order[m + v]
                        out[found, 0], out[found, 1] = min(i, j), max(i, j)
                        found += 1
            compared += reached
            m += WORD_BYTES
    return out[:found], compared


@compiled
def _argsort(values: Array) -> Indices:
    """Return the indices that sort some finite values: spread over as many buckets, then sorted by insertion.

    Values that lie evenly are sorted in one pass; where nearly all share few buckets, as after one giant value,
    comparing takes over.
    """
    n = values.size
    least, most = np.inf, -np.inf
    for value in values:
        least, most = min(least, value), max(most, value)
    per_unit = (n - 1) / (most - least)
    if not 0 < per_unit < np.inf:
        return _merge_argsort(values)
    start, bucket = np.zeros(n + 2, np.int32), np.empty(n, np.int32)
    for i in range(n):
        bucket[i] = int((values[i] - least) * per_unit)  # at most n - 1: rounding adds less than 1 to it
        start[bucket[i] + 2] += 1
        if start[bucket[i] + 2] > MAX_BUCKET:
            return _merge_argsort(values)
    for b in range(n):
        start[b + 2] += start[b + 1]
    order = np.empty(n, np.intp)
    for i in range(n):
        order[start[bucket[i] + 1]] = i
        start[bucket[i] + 1] += 1
    for k in range(1, n):
        i, to = order[k], k
        while to > 0 and values[order[to - 1]] > values[i]:
            order[to] = order[to - 1]
            to -= 1
        order[to] = i
    return order


@compiled
def _merge_argsort(values: Array) -> Indices:
    """Return the indices that sort some values, by merge sort; numba takes seconds to compile NumPy's `argsort`."""
    n, width = values.size, 1
    order, merged = np.arange(n), np.empty(n, np.intp)
    by_rank, merged_values = values.copy(), np.empty(n)
    while width < n:
        for start in range(0, n, 2 * width):
            i, middle, stop = start, min(start + width, n), min(start + 2 * width, n)
            j = middle
            for to in range(start, stop):
                left = j == stop or (i < middle and by_rank[i] <= by_rank[j])
                k = i if left else j
                merged[to], merged_values[to] = order[k], by_rank[k]
                i, j = i + left, j + (not left)
        order, merged = merged, order
        by_rank, merged_values = merged_values, by_rank
        width *= 2
    return order


@compiled
def _count_comparisons(bounds: Array, axis: int) -> int:
    """Return how many pairs of (N, 4) boxes a sweep along an axis (0: x, 1: y) compares."""
    n = len(bounds)
    order, low, count = _argsort(bounds[:, axis].copy()), np.empty(n), 0
    for k in range(n):
        low[k] = bounds[order[k], axis]
    for k in range(n):
        first, stop = k, n  # how many begin before this one ends
        end = bounds[order[k], axis + 2]
        while first < stop:
            middle = (first + stop) // 2
            if low[middle] <= end:
                first = middle + 1
            else:
                stop = middle
        count += first
    return count - n * (n + 1) // 2


@compiled
def sweep_axis(bounds: Array) -> int:
    """Return the axis (0: x, 1: y) with the larger ratio of extent to longest side, for boxes (x0, y0, x1, y1).

    The extent is the distance of the first from the last lower end of a box.
    """
    least_x = least_y = np.inf
    most_x = most_y = -np.inf
    width = height = 0.0
    for i in range(len(bounds)):
        least_x, most_x = min(least_x, bounds[i, 0]), max(most_x, bounds[i, 0])
        least_y, most_y = min(least_y, bounds[i, 1]), max(most_y, bounds[i, 1])
        width, height = max(width, bounds[i, 2] - bounds[i, 0]), max(height, bounds[i, 3] - bounds[i, 1])
    return 0 if (most_x - least_x) * height >= (most_y - least_y) * width else 1
