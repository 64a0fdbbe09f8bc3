"""The broad phase: which bounding boxes meet, by comparing all pairs, by sort and sweep, or by uniform grids.

Which of the three is chosen depends on the number of boxes and on a count of comparisons, never on a time, so the
same boxes always take the same way.  All three find the same pairs.
"""

import sys
from collections.abc import Iterator
from math import sqrt
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import validation
from .array_types import Indices, Mask, Pairs
from .arrays import Shapes, check_shapes
from .broad_rule import MAX_CANDIDATES_PER_BOX, NAMES
from .engines import Engine, engine_of

MAX_UNSPLIT_RATIO = 4.0
# least cell sizes as factors of the farthest coordinate: cell numbers cannot overflow, nor run together
WIDE, FINE = 2.0**-1000, 2.0**-48
SAMPLE_BOXES = 1024  # boxes from which the sizes and the density of all are estimated
OUTLIER_SIZE = 64.0  # a box larger than so many median sizes is taken out
OUTLIER_SPREAD = 64.0  # a box further out than so many times the middle half of all boxes is taken out
MAX_OUTLIERS = 8  # boxes taken out at most; more get grids of their own


class BroadPhase(NamedTuple):
    """The broad phase that is chosen for some shapes: "all pairs", "sort and sweep" or "grid".

    comparisons: how many pairs of boxes it compares.  For a grid it is why a sweep was not chosen: how many the sweep
    would have compared, or None where they were not counted.
    """

    name: str
    comparisons: int | None


def broad_phase_of(shapes: Shapes, *, engine: str | None = None) -> BroadPhase:
    """Return the broad phase that `colliding_pairs` chooses for these shapes (for the convex parts of concave ones).

    Up to 128 boxes are compared all with all.  With numba up to 512, and with NumPy up to 4,096 if that makes at most
    160 comparisons a box, are sorted along one axis and swept: the axis on which they are spread more widely, in units
    of the largest box, or the other one if more than 160 become fewer.  More are put into a grid, whose cells are at
    least as large as the largest box in it.  Where sizes differ so much that one grid would compare more than 48 boxes
    with each, up to 16,384 are swept with numba if that makes at most 160 comparisons a box.  Else a few boxes that are
    far larger than the others or far from them are compared with all, and the others are split by size, into a grid
    for each size.
    `engine`: as in `relate`.
    """
    kernels = engine_of(engine)
    _, way, comparisons = kernels.candidate_pairs(check_shapes(shapes, "shapes").parts.bounds)
    return BroadPhase(NAMES[way], comparisons if comparisons >= 0 else None)


def candidate_pairs(bounds: validation.Points, *, engine: str | None = None) -> Pairs:
    """Return the (K, 2) indices i < j, in order, of the boxes that share a point; `bounds` is (N, 4).

    `engine`: as in `relate`.  InvalidShape for boxes that are not finite or whose minimum is above their maximum.
    """
    kernels = engine_of(engine)
    return sort_pairs(list(candidate_blocks(validation.boxes(bounds), kernels)))


def candidate_blocks(bounds: NDArray[np.float64], kernels: Engine) -> Iterator[Pairs]:
    """Yield the pairs (i < j) of (N, 4) boxes that share a point, in (K, 2) blocks, each pair once, unsorted."""
    few, *_ = kernels.candidate_pairs(bounds)
    if few is not None:
        yield few
    else:
        yield from _grid_blocks(bounds, kernels)


def sort_pairs(blocks: list[Pairs]) -> Pairs:
    """Return all pairs of some (K, 2) blocks as one int64 array, sorted by first index, then by second."""
    pairs = np.concatenate(blocks).astype(np.int64, copy=False) if blocks else np.empty((0, 2), np.int64)
    base = int(pairs.max(initial=0)) + 1
    return np.stack(np.divmod(np.sort(pairs[:, 0] * base + pairs[:, 1]), base), axis=1)


def _grid_blocks(bounds: NDArray[np.float64], kernels: Engine) -> Iterator[Pairs]:
    """Yield the pairs (i < j) of (N, 4) boxes that share a point, by grids, one for each pair of size classes.

    The cell is at least the largest width by the largest height of the boxes compared: then a
    box reaches at most into the next cell, and three rows of three cells hold all it
    can meet.  Where that gives too many candidates (one large box among small ones
    would put everything into one cell, and a square cell a stack of needles), the
    boxes are split by width or height and the halves compared with cells of their
    own.  Boxes alike within a factor of four are not split further: few of them fit a
    cell of their own size without nearly meeting.
    """
    most = np.finfo(float).max
    farthest = float(max(-bounds.min(initial=0), bounds.max(initial=0)))
    with np.errstate(all="ignore"):
        if farthest > most / 2:  # places and widths beyond float64 are capped: that changes no order
            bounds = np.clip(bounds, -most, most)
            farthest = min(farthest, most)
    ordinary, outliers = _take_out_outliers(bounds)
    yield from _pairs_of_outliers(bounds, outliers)
    todo: list[tuple[Pairs, Pairs | None]] = [(ordinary, None)]  # None: among themselves
    while todo:
        one, other = todo.pop()
        both = one if other is None else np.concatenate([one, other])
        if len(both) < 2:
            continue
        largest = [float(_sizes(bounds, both, d).max()) for d in (0, 1)]
        even = [max(largest[d], _cell_size_if_even(bounds[:, d], both), farthest * WIDE) for d in (0, 1)]
        blocks = kernels.grid(bounds, one, other, even, MAX_CANDIDATES_PER_BOX * len(both))
        if blocks is None:
            halves = _split_by_size(bounds, one, other)
            todo += halves
            # alike, and too many of them in the cells that would be right if they lay evenly
            cell = [max(c, farthest * FINE) for c in largest]
            blocks = None if halves else kernels.grid(bounds, one, other, cell, np.inf)
        yield from blocks or ()


def _take_out_outliers(bounds: NDArray[np.float64]) -> tuple[Indices, Indices]:
    """Return (indices of the ordinary boxes, of the outliers: boxes far larger than the others or far from them).

    A giant or far box would spoil the cells of all others; against it, comparing all boxes is cheaper.  More than
    MAX_OUTLIERS are not taken out.
    """
    is_outlier: Mask = np.zeros(len(bounds), bool)
    some = bounds[:: -(-len(bounds) // SAMPLE_BOXES)]
    with np.errstate(all="ignore"):
        for d in (0, 1):
            size = np.sort(some[:, d + 2] - some[:, d])[len(some) // 2]
            low = np.sort(some[:, d])
            first, last = low[len(low) // 4], low[-1 - len(low) // 4]
            away = OUTLIER_SPREAD * (last - first + size)
            is_outlier |= (bounds[:, d] < first - away) | (bounds[:, d + 2] > last + away)
            is_outlier |= bounds[:, d + 2] - bounds[:, d] > OUTLIER_SIZE * size
    outliers = np.flatnonzero(is_outlier)
    if len(outliers) > MAX_OUTLIERS:
        outliers = outliers[:0]
    return np.delete(np.arange(len(bounds), dtype=np.int32), outliers), outliers  # half the memory of intp


def _pairs_of_outliers(bounds: NDArray[np.float64], outliers: Indices) -> Iterator[Pairs]:
    """Yield the pairs (i < j) of boxes that share a point of which one or both are outliers."""
    for k, i in enumerate(outliers.tolist()):
        meet = np.asarray((bounds[:, :2] <= bounds[i, 2:]).all(axis=1) & (bounds[:, 2:] >= bounds[i, :2]).all(axis=1))
        meet[outliers[: k + 1]] = False
        j = np.flatnonzero(meet)
        yield np.stack([np.minimum(i, j), np.maximum(i, j)], axis=1)


def _cell_size_if_even(low: NDArray[np.float64], which: Indices) -> float:
    """Return the length along one axis of cells that would hold about one box each if the boxes lay evenly.

    low: (N,) lower sides of all boxes on the axis; which: indices of the boxes to put into cells.  Their spread is
    estimated from their middle half.
    """
    some = np.sort(low[which[:: -(-len(which) // SAMPLE_BOXES)]])
    first, last = float(some[len(some) // 4]) / 2, float(some[-1 - len(some) // 4]) / 2
    return min(last - first, sys.float_info.max / 8) * (4 / sqrt(len(which)))


def _sizes(bounds: NDArray[np.float64], which: Indices, d: int) -> NDArray[np.float64]:
    """Return the widths (d = 0) or heights (d = 1) of the boxes `which`, clipped to the range of normal floats."""
    with np.errstate(over="ignore"):
        size = bounds[which, d + 2] - bounds[which, d]
    return np.asarray(np.clip(size, np.finfo(float).tiny, np.finfo(float).max))


def _split_by_size(
    bounds: NDArray[np.float64], one: Indices, other: Indices | None
) -> list[tuple[Indices, Indices | None]]:
    """Split the set of boxes with the more different sizes in two; return the pairs of sets left to compare.

    one, other: the indices of two sets of boxes to compare with each other; None for `other` stands for the pairs
    within `one`, also in the result.  The split is at the geometric mean of the smallest and the largest size.  The
    list is empty where all sizes are alike.
    """
    spreads = []
    for d in (0, 1):
        swap = other is not None and _sizes(bounds, other, d).max() > _sizes(bounds, one, d).max()
        sizes = _sizes(bounds, other if swap and other is not None else one, d)
        with np.errstate(all="ignore"):
            spreads.append((sizes.max() / sizes.min(), d, swap))
    spread, d, swap = max(spreads)
    if spread <= MAX_UNSPLIT_RATIO:
        return []
    if other is not None and swap:
        one, other = other, one
    logs = np.log2(_sizes(bounds, one, d))
    is_small = logs <= (logs.min() + logs.max()) / 2
    small, large = one[is_small], one[~is_small]
    if other is None:
        return [(small, None), (large, None), (small, large)]
    return [(small, other), (large, other)]
