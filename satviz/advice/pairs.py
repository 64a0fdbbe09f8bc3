"""Pairs of shapes of two batches, the pairs of their convex parts, and blocks of these pairs in columns.

Columns hold shapes with equally many corners: x and y are (corners, n) arrays, one column per shape (`Group`).
"""

from collections.abc import Iterator
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..batch.arrays import Group, Shapes
from ..batch.codes import UNDECIDED
from ..batch.narrow_phase import check_pairs
from ..engine.shapes import Circle, Polygon, Shape

Array = NDArray[np.float64]
Indices = NDArray[np.intp]
Relations = NDArray[np.int8]
MAX_CORNERS_AT_ONCE = 1 << 18  # corners times pairs


class Pairs(NamedTuple):
    """Pairs (ia, ib) of shapes of two batches; (pa, pb) are all pairs of their convex parts, `of` the pair of each."""

    a: Shapes
    b: Shapes
    ia: Indices
    ib: Indices
    pa: Indices
    pb: Indices
    of: Indices

    def whole(self, of_parts: Relations) -> Relations:
        """Return the relation of each pair from those of its convex parts: the largest one.

        UNDECIDED for a part makes the pair UNDECIDED, unless another part overlaps.
        """
        if self.a.owner is None and self.b.owner is None:
            return of_parts
        order = np.array([0, 1, 3, 2], np.int8)  # of the relations and, last, UNDECIDED
        most = np.zeros(len(self.ia), np.int8)
        np.maximum.at(most, self.of, order[of_parts])
        return np.array([0, 1, UNDECIDED, 2], np.int8)[most]


def paired(a: Shapes, ia: Indices, b: Shapes, ib: Indices) -> Pairs:
    """Return the pairs (ia, ib) of two batches together with their convex parts."""
    return Pairs(a, b, ia, ib, *part_pairs(a, ia, b, ib))


class HasColumns(Protocol):
    """Convex parts in columns by their number of corners: batch shapes, or a copy of them in another float format."""

    @property
    def count(self) -> NDArray[np.int64]:
        """(N,) The number of corners of each part."""

    @property
    def slot(self) -> Indices:
        """(N,) The column of each part in its group."""

    @property
    def groups(self) -> dict[int, Group]:
        """The columns by the number of corners."""


def indexed(a: Shapes, b: Shapes, pairs: ArrayLike | None) -> tuple[Indices, Indices]:
    """Return the pairs as indices into both batches, row by row for None.  ValueError, IndexError as in `relate`."""
    if pairs is not None:
        return check_pairs(pairs, len(a), len(b))
    if len(a) != len(b):
        raise ValueError(f"{len(a)} and {len(b)} shapes: give as many of each, or pairs=")
    every = np.arange(len(a))
    return every, every


def part_pairs(a: Shapes, ia: Indices, b: Shapes, ib: Indices) -> tuple[Indices, Indices, Indices]:
    """Return (pa, pb, of): all pairs of convex parts of these pairs of shapes, and the pair that each belongs to."""
    first_a, first_b = a.starts[ia], b.starts[ib]
    many_b = b.starts[ib + 1] - first_b
    each = (a.starts[ia + 1] - first_a) * many_b
    of = np.repeat(np.arange(len(ia)), each)
    rank = np.arange(len(of)) - np.repeat(np.cumsum(each) - each, each)
    return first_a[of] + rank // many_b[of], first_b[of] + rank % many_b[of], of


def tests_per_pair(a: Shapes, ia: Indices, b: Shapes, ib: Indices) -> Array:
    """Return the tests of an edge against a corner that each pair of shapes takes, in both directions."""
    corners = [np.diff(s.rings.start[s.starts])[i].astype(float) for s, i in ((a, ia), (b, ib))]
    tests: Array = 2 * corners[0] * corners[1]
    return tests


def part_shape(shapes: Shapes, part: int) -> Shape:
    """Return a convex part of a batch as a shape of the engine."""
    group, i = shapes.groups[int(shapes.count[part])], shapes.slot[part]
    if group.r is not None:
        return Circle((group.x[0, i], group.y[0, i]), group.r[i])
    return Polygon(np.stack([group.x[:, i], group.y[:, i]], axis=1))


def pair_columns(
    a: HasColumns, pa: Indices, b: HasColumns, pb: Indices, most: int = 1 << 62
) -> Iterator[tuple[Indices, Group, Group]]:
    """Yield (numbers of pairs, columns of a, columns of b) for blocks of pairs with the same numbers of corners.

    `most` is the largest number of pairs in a block.
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
    """Return a slice where the columns are adjacent, so that NumPy copies nothing; else the slots themselves."""
    first, last = int(slots[0]), int(slots[-1])
    adjacent = last - first == len(slots) - 1 and (np.diff(slots) == 1).all()
    return slice(first, last + 1) if adjacent else slots


def max_coordinates(group: Group) -> Array:
    """Return the largest absolute coordinate of each column, plus the radius of circles."""
    most: Array = np.maximum(np.abs(group.x).max(axis=0), np.abs(group.y).max(axis=0))
    return most if group.r is None else most + group.r
