"""Many shapes as structure-of-arrays: all first vertices' x together, and so on.

Shapes are kept by their number of vertices (a circle has one), so no outline is
padded: a repeated vertex would be an edge without a direction.
"""

from collections.abc import Sequence
from functools import cached_property
from typing import Any, NamedTuple, SupportsIndex

import numpy as np
from numpy.typing import NDArray

Where = SupportsIndex | slice | Sequence[int] | NDArray[np.integer[Any] | np.bool_]  # one, a range, indices, a mask


class Group(NamedTuple):
    """The shapes with one number of vertices.

    x, y: (V, n) counter-clockwise corners in scene units, no repeats, none straight on
    (V = 1: centers, r: (n,) radii).  span, reach: the largest edge component and
    coordinate of all; upright: are all of them boxes with their sides along x and y?
    """

    x: NDArray[np.float64]
    y: NDArray[np.float64]
    r: NDArray[np.float64] | None
    span: float
    reach: float
    upright: bool = False

    def columns(self, where: slice | NDArray[np.integer[Any] | np.bool_]) -> "Group":
        """Some of the shapes, by slice or index array."""
        r = None if self.r is None else self.r[where]
        return self._replace(x=self.x[:, where], y=self.y[:, where], r=r)


class Flat(NamedTuple):
    """The same shapes one after another: shape i has the corners start[i] to start[i + 1].

    x, y: (M,) scene units; bounds: (N, 4), circles' rounded outwards; upright: (N,) is it a box with its sides along
    x and y?
    """

    x: NDArray[np.float64]
    y: NDArray[np.float64]
    start: NDArray[np.intp]
    bounds: NDArray[np.float64]
    upright: NDArray[np.bool_]


class Shapes:
    """Many convex polygons and circles; make one with Polygons, Circles and concat.

    `count`: (N,) vertices of each shape; `slot`: (N,) its column in its group;
    `owner`: (N,) which input each is a part of, where concave polygons were split.
    """

    def __init__(
        self,
        groups: dict[int, Group],
        count: NDArray[np.int64],
        slot: NDArray[np.int64],
        owner: NDArray[np.int64] | None = None,
    ) -> None:
        self.groups = groups
        self.count = count
        self.slot = slot
        self.owner = owner

    def __len__(self) -> int:
        """How many shapes; parts of one concave polygon count once."""
        return len(self.count) if self.owner is None else int(self.owner[-1]) + 1 if len(self.owner) else 0

    def __repr__(self) -> str:
        kinds = ", ".join(f"{group.x.shape[1]} x {_kind(v)}" for v, group in sorted(self.groups.items()))
        return f"Shapes({kinds})"

    @cached_property
    def uniform(self) -> Group | None:
        """The only group, if its columns are in order."""
        if len(self.groups) != 1 or self.owner is not None:
            return None
        (group,) = self.groups.values()
        return group if group.x.shape[1] == len(self.slot) and _in_order(self.slot) else None

    @cached_property
    def starts(self) -> NDArray[np.intp]:
        """(N + 1,) at which part each shape begins, and the last one ends."""
        places = np.arange(len(self) + 1)
        return places if self.owner is None else np.searchsorted(self.owner, places)

    @property
    def parts(self) -> "Shapes":
        """The convex parts as shapes of their own."""
        return self if self.owner is None else Shapes(self.groups, self.count, self.slot)

    def __getitem__(self, where: Where) -> "Shapes":
        """Some of the shapes by slice, index array or mask; one by its index is a batch of one.

        Shapes count, not parts.  IndexError for what is out of range.
        """
        if self.uniform is not None and isinstance(where, slice) and (where.step or 1) == 1:
            start, stop, _ = where.indices(len(self))
            stop = max(start, stop)
            group = self.uniform.columns(slice(start, stop))
            return Shapes({len(group.x): group}, self.count[start:stop], np.arange(stop - start))
        chosen = np.atleast_1d(np.arange(len(self))[where])
        if chosen.ndim != 1:
            raise IndexError(f"the indices have the shape {chosen.shape}: expected one row of them")
        owner = None
        if self.owner is not None:
            first = self.starts[chosen]
            many = self.starts[chosen + 1] - first
            owner = np.repeat(np.arange(len(chosen)), many)
            chosen = np.arange(len(owner)) + np.repeat(first - (np.cumsum(many) - many), many)
        count, slot = self.count[chosen], self.slot[chosen]
        groups, new_slot = {}, np.empty(len(slot), np.int64)
        for v in np.unique(count).tolist():
            mine = count == v
            groups[v] = self.groups[v].columns(slot[mine])
            new_slot[mine] = np.arange(groups[v].x.shape[1])
        return Shapes(groups, count, new_slot, owner)

    @cached_property
    def flat(self) -> Flat:
        """The parts one after another."""
        start = np.concatenate([[0], np.cumsum(self.count)])
        x, y = np.empty((2, start[-1]))
        upright = np.zeros(len(self.count), bool)
        for v, group in self.groups.items():
            mine = np.flatnonzero(self.count == v)
            slots = self.slot[mine]
            place = start[mine][:, None] + np.arange(v)
            x[place], y[place] = group.x[:, slots].T, group.y[:, slots].T
            if v == 4:
                upright[mine] = upright_boxes(group.x[:, slots], group.y[:, slots])
        return Flat(x, y, start, self.parts.bounds, upright)

    @property
    def bounds(self) -> NDArray[np.float64]:
        """(N, 4) boxes (x min, y min, x max, y max) in scene units, circles' rounded outwards."""
        found = np.empty((len(self.count), 4))
        for v, group in self.groups.items():
            x, y = group.x, group.y
            box = np.stack([x.min(axis=0), y.min(axis=0), x.max(axis=0), y.max(axis=0)], axis=1)
            if group.r is not None:
                with np.errstate(over="ignore"):
                    box += np.stack([-group.r, -group.r, group.r, group.r], axis=1)
                    box = np.nextafter(box, [-np.inf, -np.inf, np.inf, np.inf])
            mine = self.count == v
            found[mine] = box[self.slot[mine]]
        if self.owner is None or not len(self.owner):
            return found
        first = self.starts[:-1]
        return np.hstack([np.minimum.reduceat(found[:, :2], first), np.maximum.reduceat(found[:, 2:], first)])


def upright_boxes(x: NDArray[np.float64], y: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Which columns of four corners are boxes with their sides along x and y."""
    level: list[NDArray[np.bool_]] = [
        (c[i] == c[(i + 1) % 4]) & (c[i + 2] == c[(i + 3) % 4]) for c, i in ((x, 0), (y, 1), (y, 0), (x, 1))
    ]
    return (level[0] & level[1]) | (level[2] & level[3])


def _in_order(slot: NDArray[np.int64]) -> bool:
    return not len(slot) or bool(slot[0] == 0 and slot[-1] == len(slot) - 1)


def _kind(v: int) -> str:
    return "circle" if v == 1 else f"{v}-gon"


def checked(shapes: object, name: str) -> Shapes:
    """The batch itself; TypeError says how to make one of anything else."""
    if isinstance(shapes, Shapes):
        return shapes
    raise TypeError(f"{name} is a {type(shapes).__name__}: make it with batch.Polygons or batch.Circles first")


def concat(many: Sequence[Shapes]) -> Shapes:
    """One batch of several, in order: how circles and polygons are mixed."""
    many = [checked(shapes, f"batch {i}") for i, shapes in enumerate(many)]
    if not many:
        return Shapes({}, np.empty(0, np.int64), np.empty(0, np.int64))
    groups: dict[int, Group] = {}
    for v in sorted({v for shapes in many for v in shapes.groups}):
        mine = [shapes.groups[v] for shapes in many if v in shapes.groups]
        x, y = (np.concatenate([g[k] for g in mine], axis=1) for k in (0, 1))
        r = None if v > 1 else np.concatenate([g.r for g in mine])
        span, reach = max(g.span for g in mine), max(g.reach for g in mine)
        groups[v] = Group(x, y, r, span, reach, all(g.upright for g in mine))
    before = dict.fromkeys(groups, 0)
    slots, owners, first = [], [], 0
    for shapes in many:
        offset = np.zeros(max(groups, default=0) + 1, np.int64)
        for v, group in shapes.groups.items():
            offset[v] = before[v]
            before[v] += group.x.shape[1]
        slots.append(shapes.slot + offset[shapes.count])
        owners.append((np.arange(len(shapes.count)) if shapes.owner is None else shapes.owner) + first)
        first += len(shapes)
    split = any(shapes.owner is not None for shapes in many)
    count, slot, owner = (np.concatenate(c) for c in ([s.count for s in many], slots, owners))
    return Shapes(groups, count, slot, owner if split else None)
