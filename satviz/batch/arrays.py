"""Many shapes as arrays: their corners one after another, or by number all first corners together, and so on.

No outline is padded: a repeated vertex would be an edge without a direction.
"""

from collections.abc import Sequence
from functools import cached_property
from typing import Any, NamedTuple, SupportsIndex

import numpy as np
from numpy.typing import NDArray

from ..engine.polygon_validation import refuse_masked
from .ragged import Rings

Selection = SupportsIndex | slice | Sequence[int] | NDArray[np.integer[Any] | np.bool_]  # one, a range, indices, a mask


class Group(NamedTuple):
    """Hold all shapes of a batch that have the same number of corners: one row per corner, one column per shape.

    x, y: (V, n) counter-clockwise corners in scene units, no repeats, none straight on
    (V = 1: centers, r: (n,) radii).  max_edge_component, max_coordinate: the largest edge component and
    coordinate of all polygons; upright: are all of them boxes with their sides along x and y?
    """

    x: NDArray[np.float64]
    y: NDArray[np.float64]
    r: NDArray[np.float64] | None
    max_edge_component: float = 0.0
    max_coordinate: float = 0.0
    upright: bool = False

    def columns(self, where: slice | NDArray[np.integer[Any] | np.bool_]) -> "Group":
        """Return the group of the shapes chosen by a slice, an index array or a mask, in contiguous rows."""
        r = None if self.r is None else self.r[where]
        if isinstance(where, slice):
            return self._replace(x=self.x[:, where], y=self.y[:, where], r=r)
        places = np.flatnonzero(where) if where.dtype == bool else where
        return self._replace(x=self.x.take(places, axis=1), y=self.y.take(places, axis=1), r=r)


class Flat(NamedTuple):
    """Hold all shapes of a batch one after another: shape i has the corners start[i] to start[i + 1].

    x, y: (M,) scene units; bounds: (N, 4), circles' rounded outwards; upright: (N,) is it a box with its sides
    along x and y?
    """

    x: NDArray[np.float64]
    y: NDArray[np.float64]
    start: NDArray[np.intp]
    bounds: NDArray[np.float64]
    upright: NDArray[np.bool_]


class Shapes:
    """Hold many convex polygons and circles; make a batch with Polygons, Circles, from_shapely or concat.

    `count`: (N,) corners of each part (a circle has one); `owner`: (N,) which shape each is a
    part of, where concave polygons were split.  Made of `rings` or of `groups`; the other is
    worked out when it is first needed, and kept.
    """

    def __init__(
        self,
        count: NDArray[np.int64],
        owner: NDArray[np.int64] | None = None,
        *,
        rings: Rings | None = None,
        groups: dict[int, Group] | None = None,
    ) -> None:
        self.count = count.astype(np.int64, copy=False)
        self.owner = owner
        if rings is not None:
            self.rings = rings
        if groups is not None:
            self.groups = groups

    def __len__(self) -> int:
        """Return the number of shapes; the parts of one concave polygon count once."""
        return len(self.count) if self.owner is None else int(self.owner[-1]) + 1 if len(self.owner) else 0

    def __repr__(self) -> str:
        kinds = zip(*np.unique(self.count, return_counts=True), strict=True)
        held = [f"{n} x {_kind_name(v)}" for v, n in kinds]
        if self.owner is not None:
            held.append(f"parts of {len(self)}")
        return f"{type(self).__name__}({', '.join(held)})"

    @cached_property
    def rings(self) -> Rings:
        """Return the corners of all parts, one outline after another."""
        start = np.concatenate([[0], np.cumsum(self.count)])
        x, y = np.empty((2, start[-1]))
        for v, group in self.groups.items():
            place = start[:-1][self.count == v][:, None] + np.arange(v)
            x[place], y[place] = group.x.T, group.y.T
        return Rings(x, y, start)

    @cached_property
    def groups(self) -> dict[int, Group]:
        """Return the parts grouped by their number of corners, in ascending order."""
        found = {}
        for v in np.unique(self.count).tolist():
            places = self.rings.start[:-1][self.count == v] + np.arange(v)[:, None]
            found[v] = make_group(self.rings.x[places], self.rings.y[places])
        return found

    @cached_property
    def slot(self) -> NDArray[np.intp]:
        """Return the column of each part in its group, (N,) integers."""
        order = np.argsort(self.count, kind="stable")
        slot = np.empty_like(order)
        sizes = np.unique(self.count, return_counts=True)[1]
        slot[order] = np.arange(len(order)) - np.repeat(np.cumsum(sizes) - sizes, sizes)
        return slot

    @cached_property
    def uniform(self) -> Group | None:
        """Return the only group if all shapes are convex and have the same number of corners, else None."""
        alike = self.owner is None and len(self.count) and (self.count == self.count[0]).all()
        return self.groups[int(self.count[0])] if alike else None

    @cached_property
    def flat(self) -> Flat:
        """Return all parts one after another with their boxes and kinds, for pairs picked by indices."""
        upright = np.zeros(len(self.count), bool)
        if (fours := np.flatnonzero(self.count == 4)).size:
            places = self.rings.start[fours] + np.arange(4)[:, None]
            upright[fours] = upright_box_mask(self.rings.x[places], self.rings.y[places])
        return Flat(*self.rings, self.parts.bounds, upright)

    @cached_property
    def are_upright_boxes(self) -> bool:
        """Return whether all shapes are boxes with sides along x and y."""
        if "groups" in vars(self):
            return all(group.upright for group in self.groups.values())
        return bool((self.count == 4).all() and self.flat.upright.all())

    @cached_property
    def max_corners(self) -> int:
        """Return the largest number of corners; 0 for an empty batch."""
        return int(self.count.max(initial=0))

    @cached_property
    def min_corners(self) -> int:
        """Return the smallest number of corners (a circle counts as 1); 0 for an empty batch."""
        return int(self.count.min()) if len(self.count) else 0

    @cached_property
    def starts(self) -> NDArray[np.intp]:
        """Return the index of the first part of each shape, then the number of all parts: (N + 1,) integers."""
        places = np.arange(len(self) + 1)
        return places if self.owner is None else np.searchsorted(self.owner, places)

    @property
    def parts(self) -> "Shapes":
        """Return the convex parts as a batch of shapes of their own."""
        return self if self.owner is None else self._unowned_parts

    @cached_property
    def _unowned_parts(self) -> "Shapes":
        """Return the parts as a batch in which each part is a shape of its own."""
        made = vars(self)
        return Shapes(self.count, rings=made.get("rings"), groups=made.get("groups"))

    def __getitem__(self, where: Selection) -> "Shapes":
        """Some of the shapes by slice, index array or mask; one by its index is a batch of one.

        Shapes count, not parts.  IndexError for what is out of range, ValueError for masked indices.
        """
        refuse_masked(where, "indices")
        where = list(where) if isinstance(where, tuple) else where
        if isinstance(where, slice) and (where.step or 1) == 1 and "groups" in vars(self) and self.uniform is not None:
            group = self.uniform.columns(where)
            return Shapes(self.count[where], groups={len(group.x): group})
        chosen = np.atleast_1d(np.arange(len(self))[where])
        if chosen.ndim != 1:
            raise IndexError(f"the indices have the shape {chosen.shape}: expected one row of them")
        owner = None
        if self.owner is not None:
            first = self.starts[chosen]
            many = self.starts[chosen + 1] - first
            owner = np.repeat(np.arange(len(chosen)), many)
            chosen = np.arange(len(owner)) + np.repeat(first - (np.cumsum(many) - many), many)
        count = self.count[chosen]
        if "rings" in vars(self) and not (count == 1).any():
            return Shapes(count, owner, rings=self.rings.take(chosen))
        slot = self.slot[chosen]
        groups = {v: self.groups[v].columns(slot[count == v]) for v in np.unique(count).tolist()}
        return Shapes(count, owner, groups=groups)

    @property
    def bounds(self) -> NDArray[np.float64]:
        """Return the boxes, (N, 4) as x min, y min, x max, y max in scene units, rounded outwards for circles."""
        found = np.empty((len(self.count), 4))
        if "rings" in vars(self) and not (self.count == 1).any():
            x, y, first = self.rings.x, self.rings.y, self.rings.start[:-1]
            for i, (extreme, c) in enumerate(((np.minimum, x), (np.minimum, y), (np.maximum, x), (np.maximum, y))):
                found[:, i] = extreme.reduceat(c, first)
        else:
            for v, group in self.groups.items():
                found[self.count == v] = _bounding_boxes(group)
        if self.owner is None:
            return found
        first = self.starts[:-1]
        return np.hstack([np.minimum.reduceat(found[:, :2], first), np.maximum.reduceat(found[:, 2:], first)])


def make_group(x: NDArray[np.float64], y: NDArray[np.float64]) -> Group:
    """Return a group of polygons with one number of corners, from (corners, shapes) arrays of x and y."""
    max_coordinate = float(max(np.abs(x).max(initial=0.0), np.abs(y).max(initial=0.0)))
    with np.errstate(over="ignore"):
        max_edge_component = float(max(np.abs(c - np.roll(c, 1, axis=0)).max(initial=0.0) for c in (x, y)))
    return Group(x, y, None, max_edge_component, max_coordinate, len(x) == 4 and bool(upright_box_mask(x, y).all()))


def upright_box_mask(x: NDArray[np.float64], y: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Return a mask of the columns (four corners each) that are boxes with sides along x and y."""
    level: list[NDArray[np.bool_]] = [
        (c[i] == c[i + 1]) & (c[i - 2] == c[i - 1]) for c, i in ((x, 0), (y, 1), (y, 0), (x, 1))
    ]
    return (level[0] & level[1]) | (level[2] & level[3])


def _bounding_boxes(group: Group) -> NDArray[np.float64]:
    """Return the bounding boxes of a group's shapes, (N, 4)."""
    x, y = group.x, group.y
    box = np.stack([x.min(axis=0), y.min(axis=0), x.max(axis=0), y.max(axis=0)], axis=1)
    if group.r is not None:
        with np.errstate(over="ignore"):
            box += np.stack([-group.r, -group.r, group.r, group.r], axis=1)
            box = np.nextafter(box, [-np.inf, -np.inf, np.inf, np.inf])
    return box


def _kind_name(v: int) -> str:
    """Return the name of shapes with `v` corners: "circle" for 1, else "4-gon" and so on."""
    return "circle" if v == 1 else f"{v}-gon"


def check_shapes(shapes: object, name: str) -> Shapes:
    """Return `shapes` if it is a batch; else raise TypeError that tells how to make one."""
    if isinstance(shapes, Shapes):
        return shapes
    raise TypeError(f"{name} is a {type(shapes).__name__}: make it with batch.Polygons or batch.Circles first")


def concat(many: Sequence[Shapes]) -> Shapes:
    """Return one batch with the shapes of several, in order; this is how circles and polygons are mixed."""
    many = [check_shapes(shapes, f"batch {i}") for i, shapes in enumerate(many)]
    groups: dict[int, Group] = {}
    for v in sorted({v for shapes in many for v in shapes.groups}):
        mine = [shapes.groups[v] for shapes in many if v in shapes.groups]
        x, y = (np.concatenate([g[k] for g in mine], axis=1) for k in (0, 1))
        r = None if v > 1 else np.concatenate([g.r for g in mine])
        max_edge_component, max_coordinate = (
            max(g.max_edge_component for g in mine),
            max(g.max_coordinate for g in mine),
        )
        groups[v] = Group(x, y, r, max_edge_component, max_coordinate, all(g.upright for g in mine))
    owners, first = [np.empty(0, np.int64)], 0
    for shapes in many:
        owners.append((np.arange(len(shapes.count)) if shapes.owner is None else shapes.owner) + first)
        first += len(shapes)
    split = any(shapes.owner is not None for shapes in many)
    count = np.concatenate([np.empty(0, np.int64), *(s.count for s in many)])
    return Shapes(count, np.concatenate(owners) if split else None, groups=groups)
