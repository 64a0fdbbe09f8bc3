"""Pairs of two batches, and those of their convex parts, some at a time in columns."""

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
AT_ONCE = 1 << 18  # corners times pairs


class Pairs(NamedTuple):
    """Pairs (ia, ib) of two batches; (pa, pb) those of their convex parts, `of` which pair each is of."""

    a: Shapes
    b: Shapes
    ia: Indices
    ib: Indices
    pa: Indices
    pb: Indices
    of: Indices

    def whole(self, of_parts: Relations) -> Relations:
        """The most of what the parts do; UNDECIDED unless one overlaps where the answer for some part is."""
        if self.a.owner is None and self.b.owner is None:
            return of_parts
        order = np.array([0, 1, 3, 2], np.int8)  # of the relations and, last, UNDECIDED
        most = np.zeros(len(self.ia), np.int8)
        np.maximum.at(most, self.of, order[of_parts])
        return np.array([0, 1, UNDECIDED, 2], np.int8)[most]


def paired(a: Shapes, ia: Indices, b: Shapes, ib: Indices) -> Pairs:
    """Pairs of two batches."""
    return Pairs(a, b, ia, ib, *part_pairs(a, ia, b, ib))


class Columned(Protocol):
    """Convex parts in columns by their number of corners: batch shapes, or a copy of them in another format."""

    @property
    def count(self) -> NDArray[np.int64]:
        """(N,) corners."""

    @property
    def slot(self) -> Indices:
        """(N,) each part's column."""

    @property
    def groups(self) -> dict[int, Group]:
        """The columns by the number of corners."""


def indexed(a: Shapes, b: Shapes, pairs: ArrayLike | None) -> tuple[Indices, Indices]:
    """The pairs as indices into both, side by side or as given; ValueError and IndexError as `batch.relate`."""
    if pairs is not None:
        return check_pairs(pairs, len(a), len(b))
    if len(a) != len(b):
        raise ValueError(f"{len(a)} and {len(b)} shapes: give as many of each, or pairs=")
    every = np.arange(len(a))
    return every, every


def part_pairs(a: Shapes, ia: Indices, b: Shapes, ib: Indices) -> tuple[Indices, Indices, Indices]:
    """All pairs of convex parts of these pairs: the parts of either side, and which pair they are of."""
    first_a, first_b = a.starts[ia], b.starts[ib]
    many_b = b.starts[ib + 1] - first_b
    each = (a.starts[ia + 1] - first_a) * many_b
    of = np.repeat(np.arange(len(ia)), each)
    rank = np.arange(len(of)) - np.repeat(np.cumsum(each) - each, each)
    return first_a[of] + rank // many_b[of], first_b[of] + rank % many_b[of], of


def one(shapes: Shapes, part: int) -> Shape:
    """A convex part as a shape of the engine."""
    group, i = shapes.groups[int(shapes.count[part])], shapes.slot[part]
    if group.r is not None:
        return Circle((group.x[0, i], group.y[0, i]), group.r[i])
    return Polygon(np.stack([group.x[:, i], group.y[:, i]], axis=1))


def columns(
    a: Columned, pa: Indices, b: Columned, pb: Indices, most: int = 1 << 62
) -> Iterator[tuple[Indices, Group, Group]]:
    """Pairs of parts by their numbers of corners, some at a time (at most `most`): which, and both sides' columns."""
    key = a.count[pa] << 32 | b.count[pb]
    for kind in np.unique(key).tolist():
        one_side, other = kind >> 32, kind & 0xFFFFFFFF
        p, q = a.groups[one_side], b.groups[other]
        mine, size = np.flatnonzero(key == kind), min(most, max(16, AT_ONCE // (one_side + other)))
        for start in range(0, len(mine), size):
            some = mine[start : start + size]
            yield some, p.columns(in_a_row(a.slot[pa[some]])), q.columns(in_a_row(b.slot[pb[some]]))


def in_a_row(slots: Indices) -> Indices | slice:
    """A slice where the columns stand side by side, which then need no copying."""
    first, last = int(slots[0]), int(slots[-1])
    side_by_side = last - first == len(slots) - 1 and (np.diff(slots) == 1).all()
    return slice(first, last + 1) if side_by_side else slots


def reach(group: Group) -> Array:
    """(n,) the largest magnitude of a coordinate of each shape."""
    most: Array = np.maximum(np.abs(group.x).max(axis=0), np.abs(group.y).max(axis=0))
    return most if group.r is None else most + group.r
