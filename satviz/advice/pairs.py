"""Pairs of shapes of two batches, the pairs of their convex parts, and blocks of these pairs in columns.

Columns hold shapes with equally many corners: x and y are (corners, n) arrays, one column per shape (`CornerColumns`).
"""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..batch.arrays import CornerColumns, Shapes
from ..batch.codes import UNDECIDED
from ..engine.shapes import Circle, Polygon, Shape

Array = NDArray[np.float64]
Indices = NDArray[np.intp]
Relations = NDArray[np.int8]
MAX_CORNERS_AT_ONCE = 1 << 18  # corners times pairs


class PartPairs(NamedTuple):
    """Hold pairs of shapes of two batches, and all pairs of their convex parts.

    ia, ib: (n,) pair k is a[ia[k]] with b[ib[k]]; pa, pb: (m,) indices of the convex parts of each pair of parts;
    of: (m,) the number k of the pair of shapes to which each pair of parts belongs.
    """

    a: Shapes
    b: Shapes
    ia: Indices
    ib: Indices
    pa: Indices
    pb: Indices
    of: Indices

    def combine(self, of_parts: Relations) -> Relations:
        """Return the (n,) relations of the pairs of shapes: the largest one of their pairs of convex parts.

        of_parts: (m,) relations of the pairs of parts.  UNDECIDED for a part makes the pair UNDECIDED, unless another
        part overlaps.
        """
        if self.a.owner is None and self.b.owner is None:
            return of_parts
        order = np.array([0, 1, 3, 2], np.int8)  # ranks of APART, TOUCHING, OVERLAPPING (highest) and UNDECIDED
        most = np.zeros(len(self.ia), np.int8)
        np.maximum.at(most, self.of, order[of_parts])
        return np.array([0, 1, UNDECIDED, 2], np.int8)[most]

    def part_shapes(self, k: int) -> tuple[Shape, Shape]:
        """Return the convex parts of pair k of parts as two single shapes."""
        return part_shape(self.a.parts, self.pa[k]), part_shape(self.b.parts, self.pb[k])


def paired(a: Shapes, ia: Indices, b: Shapes, ib: Indices) -> PartPairs:
    """Return the PartPairs record of a[ia[k]] with b[ib[k]], which includes all pairs of their convex parts."""
    first_a, first_b = a.starts[ia], b.starts[ib]
    many_b = b.starts[ib + 1] - first_b
    each = (a.starts[ia + 1] - first_a) * many_b
    of = np.repeat(np.arange(len(ia)), each)
    rank = np.arange(len(of)) - np.repeat(np.cumsum(each) - each, each)
    return PartPairs(a, b, ia, ib, first_a[of] + rank // many_b[of], first_b[of] + rank % many_b[of], of)


@dataclass(frozen=True)
class ConvertedParts:
    """Hold all convex parts of a batch in one float format, both one after another and in columns."""

    x: NDArray[Any]
    y: NDArray[Any]
    r: NDArray[Any]
    start: Indices
    bounds: NDArray[Any]
    count: NDArray[np.int64]
    slot: Indices
    groups: dict[int, CornerColumns]


def tests_per_pair(a: Shapes, ia: Indices, b: Shapes, ib: Indices) -> Array:
    """Return for each pair how often an edge of one outline is tested against a corner of the other, both ways."""
    corners = [np.diff(s.rings.start[s.starts])[i].astype(float) for s, i in ((a, ia), (b, ib))]
    tests: Array = 2 * corners[0] * corners[1]
    return tests


def part_shape(shapes: Shapes, part: int) -> Shape:
    """Return one convex part of a batch as a single Polygon or Circle."""
    group, i = shapes.groups[int(shapes.count[part])], shapes.slot[part]
    if group.r is not None:
        return Circle((group.x[0, i], group.y[0, i]), group.r[i])
    return Polygon(np.stack([group.x[:, i], group.y[:, i]], axis=1))


def pair_columns(
    a: Shapes | ConvertedParts, pa: Indices, b: Shapes | ConvertedParts, pb: Indices, most: int = 1 << 62
) -> Iterator[tuple[Indices, CornerColumns, CornerColumns]]:
    """Yield (indices of pairs, columns of a, columns of b) for blocks of pairs with equal numbers of corners.

    Pair k has part pa[k] of `a` and part pb[k] of `b`.  `most` is the largest number of pairs in a block.
    """
    key = a.count[pa] << 32 | b.count[pb]
    for kind in np.unique(key).tolist():
        one_side, other = kind >> 32, kind & 0xFFFFFFFF
        p, q = a.groups[one_side], b.groups[other]
        mine, size = np.flatnonzero(key == kind), min(most, max(16, MAX_CORNERS_AT_ONCE // (one_side + other)))
        for start in range(0, len(mine), size):
            some = mine[start : start + size]
            yield some, p.columns(slice_if_adjacent(a.slot[pa[some]])), q.columns(slice_if_adjacent(b.slot[pb[some]]))


def slice_if_adjacent(slots: Indices) -> Indices | slice:
    """Return the column numbers as a slice if they are consecutive (then nothing is copied), else unchanged."""
    first, last = int(slots[0]), int(slots[-1])
    adjacent = last - first == len(slots) - 1 and (np.diff(slots) == 1).all()
    return slice(first, last + 1) if adjacent else slots
