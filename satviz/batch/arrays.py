"""Many shapes as arrays: their corners one after another, or by number all first corners together, and so on.

No outline is padded: a repeated vertex would be an edge without a direction.
"""

from collections.abc import Sequence
from functools import cached_property
from typing import Any, NamedTuple, SupportsIndex

import numpy as np
from numpy.typing import NDArray

from ..engine.polygon_validation import refuse_masked
from .ragged import RaggedRings

TILE_SHAPES = 128  # columns that share error bounds; their corners stay in the first-level cache

Selection = SupportsIndex | slice | Sequence[int] | NDArray[np.integer[Any] | np.bool_]  # one, a range, indices, a mask


class ComplexColumns(NamedTuple):
    """Hold few shapes side by side, one in each column; a corner is a complex number x + iy.

    closed: (V + 1, n) corners; the rows after an outline's last corner start it again.  Circles alone have one row.
    edges: (V, n), each from a corner to the next, none for circles alone; radius: (n,), 0 for polygons, or None where
    there are only polygons.
    """

    closed: NDArray[np.complex128]
    edges: NDArray[np.complex128]
    radius: NDArray[np.float64] | None


class CornerColumns:
    """Hold shapes with the same number V of corners: one row per corner, one column per shape.

    block: (2, V, n) x and y of the corners in scene units, counter-clockwise, no repeats, none straight on; of circles
    (3, 1, n) x and y of the centers, and the radii.  Contiguous, since NumPy else copies all of it for each selection.
    It is made of the block, or of ComplexColumns, from which the block is then computed when it is needed.
    maxima: the rows of `tile_maxima`, if they are known.
    """

    def __init__(
        self,
        block: NDArray[np.float64] | None = None,
        maxima: NDArray[np.float64] | None = None,
        as_complex: ComplexColumns | None = None,
    ) -> None:
        self._maxima, self.as_complex = maxima, as_complex
        if block is not None:
            self.block = block

    @cached_property
    def block(self) -> NDArray[np.float64]:
        """Return the corners as the class describes them, computed from the ComplexColumns."""
        assert self.as_complex is not None
        closed, _, radius = self.as_complex
        corners = closed[: self.corners]
        rows = [corners.real, corners.imag] if radius is None else [corners.real, corners.imag, radius[None]]
        return np.add(rows, 0.0)  # -0.0 becomes 0.0

    def __len__(self) -> int:
        """Return the number of shapes."""
        return int((self.block if self.as_complex is None else self.as_complex.closed).shape[-1])

    @property
    def corners(self) -> int:
        """Return the number of corners of each shape; 1 for circles."""
        return int(self.block.shape[1]) if self.as_complex is None else max(1, len(self.as_complex.edges))

    @property
    def x(self) -> NDArray[np.float64]:
        """Return the x of the corners, (V, n)."""
        x: NDArray[np.float64] = self.block[0]
        return x

    @property
    def y(self) -> NDArray[np.float64]:
        """Return the y of the corners, (V, n)."""
        y: NDArray[np.float64] = self.block[1]
        return y

    @property
    def r(self) -> NDArray[np.float64] | None:
        """Return the radii of circles, (n,); None for polygons."""
        return self.block[2, 0] if len(self.block) == 3 else None

    @cached_property
    def tile_maxima(self) -> "TileMaxima":
        """Return the largest absolute edge component and coordinate of each TILE_SHAPES polygons, for error bounds."""
        if self._maxima is not None:
            return TileMaxima(*self._maxima)
        starts = np.arange(0, len(self), TILE_SHAPES)
        if not len(starts):
            return TileMaxima(np.zeros(0), np.zeros(0))
        edge, coordinate = np.zeros((2, len(self)))
        part = np.empty_like(edge)
        with np.errstate(over="ignore"):
            for c in self.block:
                for v in range(len(c)):
                    np.maximum(edge, np.abs(np.subtract(c[v], c[v - 1], out=part), out=part), out=edge)
                    np.maximum(coordinate, np.abs(c[v], out=part), out=coordinate)
        return TileMaxima(*(np.maximum.reduceat(most, starts) for most in (edge, coordinate)))

    @cached_property
    def upright(self) -> bool:
        """Return whether all shapes are boxes with their sides along x and y."""
        return len(self.x) == 4 and bool(upright_box_mask(self.x, self.y).all())

    def columns(self, where: slice | NDArray[np.integer[Any] | np.bool_]) -> "CornerColumns":
        """Return the CornerColumns of the shapes chosen by a slice (a view), an index array or a mask (copies)."""
        if isinstance(where, slice):
            return CornerColumns(self.block[:, :, where])
        return CornerColumns(self.block.take(np.flatnonzero(where) if where.dtype == bool else where, axis=2))


class TileMaxima(NamedTuple):
    """Hold the largest edge component and the largest absolute coordinate of each tile of TILE_SHAPES columns.

    One error bound for a whole batch would make all pairs pay for one giant or far shape.
    """

    edge: NDArray[np.float64]
    coordinate: NDArray[np.float64]


class Flat(NamedTuple):
    """Hold all shapes of a batch one after another: shape i has the corners start[i] to start[i + 1].

    x, y: (M,) scene units (a circle has its center); radius: (N,) 0 for polygons; bounds: (N, 4), circles' rounded
    outwards; upright: (N,) is it a box with its sides along x and y?
    """

    x: NDArray[np.float64]
    y: NDArray[np.float64]
    start: NDArray[np.intp]
    radius: NDArray[np.float64]
    bounds: NDArray[np.float64]
    upright: NDArray[np.bool_]


class Shapes:
    """Hold many convex polygons and circles; make a batch with Polygons, Circles, from_shapely or concat.

    N shapes have P convex parts, where concave polygons were split; else each shape is its own part.  `count`: (P,)
    corners of each part (a circle has one); `owner`: (P,) index of the shape it is a part of, None if none was split.
    Made of `rings` with (P,) radii (None: all are polygons), of `runs`: groups whose shapes follow each other, or of
    ComplexColumns and `count`.  Other attributes are computed when first needed, and kept; several runs are then
    joined to rings.  These arrays are the batch's own memory: read them, but do not write to them, since what is
    written there is not checked.
    """

    owner: NDArray[np.int64] | None = None
    runs: Sequence[CornerColumns]
    as_complex: ComplexColumns

    def __init__(
        self,
        *,
        rings: RaggedRings | None = None,
        radius: NDArray[np.float64] | None = None,
        owner: NDArray[np.int64] | None = None,
        runs: Sequence[CornerColumns] | None = None,
        as_complex: tuple[ComplexColumns, NDArray[np.int64]] | None = None,
    ) -> None:
        if runs is not None:
            self.runs = runs
        if as_complex is not None:
            self.as_complex, self.count = as_complex
        if rings is not None:
            self.rings = rings
            self.radius = np.zeros(len(rings.start) - 1) if radius is None else radius
        if owner is not None:
            self.owner = owner

    def __len__(self) -> int:
        """Return the number of shapes; the parts of one concave polygon count once."""
        if self.owner is not None:
            return int(self.owner[-1]) + 1 if len(self.owner) else 0
        return self.part_count

    @property
    def part_count(self) -> int:
        """Return the number of convex parts: more than `len` where concave polygons were split."""
        runs = vars(self).get("runs")  # read once, since another thread may join them
        if runs is not None:
            return sum(map(len, runs))
        return len(self.count) if "as_complex" in vars(self) else len(self.rings.start) - 1

    def _only_run(self) -> CornerColumns | None:
        """Return the group that the batch was made of; None if it was made of several or of rings."""
        runs = vars(self).get("runs", ())
        return runs[0] if len(runs) == 1 else None

    def __repr__(self) -> str:
        kinds = zip(*np.unique(self.count, return_counts=True), strict=True)
        held = [f"{n} x {_kind_name(v)}" for v, n in kinds]
        if self.owner is not None:
            held.append(f"parts of {len(self)}")
        return f"{type(self).__name__}({', '.join(held)})"

    @cached_property
    def count(self) -> NDArray[np.int64]:
        """Return the number of corners of each convex part, (P,) integers; a circle has one."""
        if (run := self._only_run()) is not None:
            return np.full(len(run), len(run.x), np.int64)
        return np.diff(self.rings.start).astype(np.int64, copy=False)

    @cached_property
    def rings(self) -> RaggedRings:
        """Return the corners of all parts, one outline after another."""
        if (columns := vars(self).get("as_complex")) is not None:
            start = np.concatenate([[0], np.cumsum(self.count)])
            corners = columns.closed.T[np.arange(len(columns.closed)) < self.count[:, None]] + 0.0  # -0.0 becomes 0.0
            return RaggedRings(corners.real.copy(), corners.imag.copy(), start)
        if (run := self._only_run()) is None:
            return self._joined()[0]
        return RaggedRings(run.x.ravel("F"), run.y.ravel("F"), np.arange(0, run.x.size + 1, len(run.x)))

    @cached_property
    def radius(self) -> NDArray[np.float64]:
        """Return the radius of each convex part, (P,) scene units: 0 for polygons."""
        if (columns := vars(self).get("as_complex")) is not None:
            return np.zeros(len(self.count)) if columns.radius is None else columns.radius
        if (run := self._only_run()) is None:
            return self._joined()[1]
        return np.zeros(len(run)) if run.r is None else run.r

    def _joined(self) -> tuple[RaggedRings, NDArray[np.float64]]:
        """Return (rings, radius) of all parts, one after another; where the batch has `runs`, replace them by these."""
        if (runs := vars(self).get("runs")) is not None:
            count = np.repeat([len(run.x) for run in runs], list(map(len, runs)))
            start = np.zeros(len(count) + 1, np.intp)
            np.cumsum(count, out=start[1:])
            x, y = (np.concatenate([run.block[k].ravel("F") for run in runs]) for k in (0, 1))
            radius = np.concatenate([np.zeros(len(run)) if run.r is None else run.r for run in runs])
            vars(self).update(rings=RaggedRings(x, y, start), radius=radius)
            vars(self).pop("runs", None)  # another thread may have been first
        return self.rings, self.radius

    @cached_property
    def groups(self) -> dict[int, CornerColumns]:
        """Return the parts with V corners as CornerColumns, {V: group} in ascending order."""
        if (run := self._only_run()) is not None:
            return {len(run.x): run}
        found = {}
        values = self.count[:1].tolist() if (self.count == self.count[:1]).all() else np.unique(self.count).tolist()
        for v in values:
            mine = self.count == v
            if len(values) == 1:
                rows = [c.reshape(-1, v).T for c in self.rings[:2]]
            else:
                places = self.rings.start[:-1][mine] + np.arange(v)[:, None]
                rows = [c[places] for c in self.rings[:2]]
            block = np.empty((3 if v == 1 else 2, v, rows[0].shape[1]))  # np.stack keeps the order of transposed rows
            block[0], block[1] = rows
            if v == 1:
                block[2] = self.radius[mine]
            found[v] = CornerColumns(block)
        return found

    @cached_property
    def slot(self) -> NDArray[np.intp]:
        """Return the column of each part in its group of `groups`, (P,) integers."""
        order = np.argsort(self.count, kind="stable")
        slot = np.empty_like(order)
        sizes = np.unique(self.count, return_counts=True)[1]
        slot[order] = np.arange(len(order)) - np.repeat(np.cumsum(sizes) - sizes, sizes)
        return slot

    @cached_property
    def uniform(self) -> CornerColumns | None:
        """Return the only group if none was split and all have the same number of corners; None if not, or if empty."""
        if (run := self._only_run()) is not None:
            return run if len(run) else None
        alike = self.owner is None and len(self.count) and (self.count == self.count[0]).all()
        return self.groups[int(self.count[0])] if alike else None

    @cached_property
    def flat(self) -> Flat:
        """Return all parts one after another, with their bounding boxes and radii, for pairs picked by indices."""
        upright = np.zeros(len(self.count), bool)
        if (fours := np.flatnonzero(self.count == 4)).size:
            places = self.rings.start[fours] + np.arange(4)[:, None]
            upright[fours] = upright_box_mask(self.rings.x[places], self.rings.y[places])
        return Flat(*self.rings, self.radius, self.parts.bounds, upright)

    @cached_property
    def are_upright_boxes(self) -> bool:
        """Return whether all shapes are boxes with sides along x and y."""
        if (run := self._only_run()) is not None:
            return run.upright
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
        """Return a batch in which each convex part is a shape of its own: this batch if nothing was split."""
        return self if self.owner is None else self._unowned_parts

    @cached_property
    def _unowned_parts(self) -> "Shapes":
        """Return `parts` of a batch in which polygons were split, made once."""
        return Shapes(rings=self.rings, radius=self.radius)

    def __getitem__(self, where: Selection) -> "Shapes":
        """Return some of the shapes, chosen by a slice, an index array or a mask; one index gives a batch of one.

        Shapes count, not parts.  IndexError for what is out of range, ValueError for masked indices.
        """
        refuse_masked(where, "indices")
        where = list(where) if isinstance(where, tuple) else where
        chosen = np.atleast_1d(np.arange(len(self))[where])
        if chosen.ndim != 1:
            raise IndexError(f"the indices have the shape {chosen.shape}: expected an array with one dimension")
        if (run := self._only_run()) is not None:
            return Shapes(runs=[run.columns(chosen)])
        owner = None
        if self.owner is not None:
            first = self.starts[chosen]
            many = self.starts[chosen + 1] - first
            owner = np.repeat(np.arange(len(chosen)), many)
            chosen = np.arange(len(owner)) + np.repeat(first - (np.cumsum(many) - many), many)
        return Shapes(rings=self.rings.take(chosen), radius=self.radius[chosen], owner=owner)

    @property
    def bounds(self) -> NDArray[np.float64]:
        """Return each shape's bounding box, (N, 4): x min, y min, x max, y max; rounded outwards for circles."""
        if (run := self._only_run()) is not None:
            return _bounding_boxes(run)
        found = np.empty((len(self.count), 4))
        x, y, first = self.rings.x, self.rings.y, self.rings.start[:-1]
        if len(first):
            for i, (extreme, c) in enumerate(((np.minimum, x), (np.minimum, y), (np.maximum, x), (np.maximum, y))):
                found[:, i] = extreme.reduceat(c, first)
        if (circles := np.flatnonzero(self.radius)).size:
            found[circles] = _widen(found[circles], self.radius[circles])
        if self.owner is None:
            return found
        first = self.starts[:-1]
        return np.hstack([np.minimum.reduceat(found[:, :2], first), np.maximum.reduceat(found[:, 2:], first)])


def upright_box_mask(x: NDArray[np.float64], y: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Return the (n,) mask of the columns of (4, n) corners that are boxes with sides along x and y."""
    level: list[NDArray[np.bool_]] = [
        (c[i] == c[i + 1]) & (c[i - 2] == c[i - 1]) for c, i in ((x, 0), (y, 1), (y, 0), (x, 1))
    ]
    return (level[0] & level[1]) | (level[2] & level[3])


def _bounding_boxes(group: CornerColumns) -> NDArray[np.float64]:
    """Return the (n, 4) bounding boxes of the shapes in these columns: x min, y min, x max, y max."""
    x, y = group.x, group.y
    box = np.stack([x.min(axis=0), y.min(axis=0), x.max(axis=0), y.max(axis=0)], axis=1)
    return box if group.r is None else _widen(box, group.r)


def _widen(box: NDArray[np.float64], radius: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return (N, 4) boxes, each widened by its radius, (N,), on all sides and rounded outwards."""
    with np.errstate(over="ignore"):
        box = box + np.stack([-radius, -radius, radius, radius], axis=1)
        return np.nextafter(box, [-np.inf, -np.inf, np.inf, np.inf])


def _kind_name(v: int) -> str:
    """Return the name of shapes with `v` corners: "circle" for 1, else "4-gon" and so on."""
    return "circle" if v == 1 else f"{v}-gon"


def check_shapes(shapes: object, name: str) -> Shapes:
    """Return `shapes` if it is a batch; else raise TypeError that tells how to make one."""
    if isinstance(shapes, Shapes):
        return shapes
    raise TypeError(f"{name} is a {type(shapes).__name__}: make it with batch.Polygons or batch.Circles first")
