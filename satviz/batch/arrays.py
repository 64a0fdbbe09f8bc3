"""Many shapes as structure-of-arrays, checked once: all first vertices' x together, and so on.

Shapes are kept by their number of vertices (a circle has one), so no outline is
padded: a repeated vertex would be an edge without a direction.
"""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..concave import parts
from ..geometry import InvalidShape
from ..shapes import Polygon
from . import signs


class Group(NamedTuple):
    """The shapes with one number of vertices.

    x, y: (V, n) counter-clockwise corners in scene units, no repeats, none straight on
    (V = 1: centres, r: (n,) radii).  span, reach: the largest edge component and
    coordinate of all.
    """

    x: NDArray[np.float64]
    y: NDArray[np.float64]
    r: NDArray[np.float64] | None
    span: float
    reach: float


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

    @property
    def uniform(self) -> Group | None:
        """The only group, if its columns are in order."""
        if len(self.groups) != 1 or self.owner is not None:
            return None
        (group,) = self.groups.values()
        return group if group.x.shape[1] == len(self.slot) and _in_order(self.slot) else None

    def __getitem__(self, where: Any) -> "Shapes":
        """Some of the shapes, by slice or index array (of parts, where concave polygons were split)."""
        group = self.uniform
        if group is not None and isinstance(where, slice) and (where.step or 1) == 1:
            start, stop, _ = where.indices(len(self))
            stop = max(start, stop)
            part = group._replace(x=group.x[:, start:stop], y=group.y[:, start:stop])
            part = part if group.r is None else part._replace(r=group.r[start:stop])
            return Shapes({len(group.x): part}, self.count[start:stop], np.arange(stop - start))
        count, slot = self.count[where], self.slot[where]
        groups, new_slot = {}, np.empty(len(slot), np.int64)
        for v in np.unique(count).tolist():
            mine, old = count == v, self.groups[v]
            columns = slot[mine]
            r = None if old.r is None else old.r[columns]
            groups[v] = Group(old.x[:, columns], old.y[:, columns], r, old.span, old.reach)
            new_slot[mine] = np.arange(len(columns))
        return Shapes(groups, count, new_slot, None if self.owner is None else self.owner[where])

    @property
    def bounds(self) -> NDArray[np.float64]:
        """(N, 4) boxes (x min, y min, x max, y max) in scene units, circles' rounded outwards; of parts if split."""
        found = np.empty((len(self.count), 4))
        for v, group in self.groups.items():
            x, y = group.x, group.y
            box = np.stack([x.min(axis=0), y.min(axis=0), x.max(axis=0), y.max(axis=0)], axis=1)
            if group.r is not None:
                box += np.stack([-group.r, -group.r, group.r, group.r], axis=1)
                box = np.nextafter(box, [-np.inf, -np.inf, np.inf, np.inf])
            mine = self.count == v
            found[mine] = box[self.slot[mine]]
        return found


def _in_order(slot: NDArray[np.int64]) -> bool:
    return not len(slot) or bool(slot[0] == 0 and slot[-1] == len(slot) - 1)


def _kind(v: int) -> str:
    return "circle" if v == 1 else f"{v}-gon"


def Circles(centers: Any, radii: Any) -> Shapes:
    """Circles from (N, 2) centres and (N,) radii, or one radius (scene units); InvalidShape names the first bad one."""
    centers = _floats(centers, "centers")
    if centers.ndim != 2 or centers.shape[1] != 2:
        raise InvalidShape(f"centers has the shape {centers.shape}: expected (N, 2)")
    r = np.ascontiguousarray(np.broadcast_to(_floats(radii, "radii"), centers.shape[:1]))
    if (bad := np.flatnonzero(~(r > 0))).size:
        raise InvalidShape(f"circle {bad[0]} has radius {r[bad[0]]}: a circle needs a positive radius")
    x, y = np.ascontiguousarray(centers[:, :1].T), np.ascontiguousarray(centers[:, 1:].T)
    with np.errstate(over="ignore"):
        reach = float((np.abs(centers).max(axis=1) + r).max(initial=0.0))
    group = Group(x, y, r, float(r.max(initial=0.0)), reach)
    return Shapes({1: group}, np.ones(len(r), np.int64), np.arange(len(r)))


def Polygons(vertices: Any, *, concave: str = "refuse") -> Shapes:
    """Convex polygons from an (N, V, 2) array, or a sequence of (V, 2) arrays or satviz.Polygon, in scene units.

    Either winding, repeats and straight-on vertices are allowed.  `concave="split"`
    splits concave ones into parts and keeps their owner.  InvalidShape names the
    first polygon at fault and says what is wrong.
    """
    if concave not in ("refuse", "split"):
        raise ValueError(f'concave is {concave!r}: choose "refuse" or "split"')
    if isinstance(vertices, np.ndarray) and vertices.dtype != object:
        if vertices.ndim != 3 or vertices.shape[2] != 2 or vertices.shape[1] < 3:
            raise InvalidShape(f"vertices has the shape {vertices.shape}: expected (N, V, 2) with V at least 3")
        v = vertices.shape[1]
        return _assembled(
            [(np.arange(len(vertices)), _floats(vertices, "vertices"))] if v else [], len(vertices), concave
        )
    rings = [p.vertices if isinstance(p, Polygon) else p for p in vertices]
    by_count: dict[int, list[int]] = {}
    arrays = []
    for i, ring in enumerate(rings):
        array = _floats(ring, f"polygon {i}")
        if array.ndim != 2 or array.shape[1] != 2 or len(array) < 3:
            raise InvalidShape(f"polygon {i} has the shape {array.shape}: expected (V, 2) with V at least 3")
        arrays.append(array)
        by_count.setdefault(len(array), []).append(i)
    blocks = [(np.asarray(ids), np.stack([arrays[i] for i in ids])) for ids in by_count.values()]
    return _assembled(blocks, len(rings), concave)


def concat(many: Sequence[Shapes]) -> Shapes:
    """One batch of several, in order: how circles and polygons are mixed."""
    groups: dict[int, Group] = {}
    for v in sorted({v for shapes in many for v in shapes.groups}):
        mine = [shapes.groups[v] for shapes in many if v in shapes.groups]
        x, y = (np.concatenate([g[k] for g in mine], axis=1) for k in (0, 1))
        r = None if v > 1 else np.concatenate([g.r for g in mine])
        groups[v] = Group(x, y, r, max(g.span for g in mine), max(g.reach for g in mine))
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


def _floats(values: Any, name: str) -> NDArray[np.float64]:
    """float64 with the same values; complex, text, masked and lossy input is refused."""
    if isinstance(values, np.ma.MaskedArray) and np.ma.is_masked(values):
        raise InvalidShape(f"{name} has masked entries: fill or drop them first")
    array = np.asarray(values)
    if array.dtype.kind not in "iuf":
        raise InvalidShape(f"{name} is an array of {array.dtype}: coordinates must be real numbers")
    with np.errstate(all="ignore"):
        floats = array.astype(np.float64, copy=False)
    if array.dtype.kind in "iu" and array.dtype.itemsize == 8 and array.size:
        wide = np.abs(floats).max() >= 2.0**53
        if wide and any(int(f) != int(a) for f, a in zip(floats.ravel().tolist(), array.ravel().tolist(), strict=True)):
            raise InvalidShape(f"{name} holds integers that float64 cannot: round or scale them first")
    elif array.dtype.itemsize > 8 and np.any(floats != array):
        raise InvalidShape(f"{name} holds numbers that float64 cannot: round them first")
    if not np.isfinite(floats).all():
        at = tuple(int(i) for i in np.argwhere(~np.isfinite(floats))[0])
        raise InvalidShape(f"{name}[{', '.join(map(str, at))}] is {floats[at]}: coordinates must be finite")
    return floats


def _assembled(blocks: Sequence[tuple[NDArray, NDArray]], n: int, concave: str) -> Shapes:
    """Sort the rings into groups; those not plainly convex go through the scalar door one by one."""
    found: dict[int, list[tuple[NDArray, NDArray, NDArray]]] = {}
    odd: list[tuple[int, NDArray]] = []
    for ids, rings in blocks:
        x, y = (np.ascontiguousarray(rings[:, :, i].T) for i in (0, 1))
        good = _orient(x, y)
        if good.all():
            found.setdefault(len(x), []).append((ids, x, y))
            continue
        if good.any():
            found.setdefault(len(x), []).append((ids[good], x[:, good], y[:, good]))
        odd += [(int(i), ring) for i, ring in zip(ids[~good], rings[~good], strict=True)]
    split = False
    for i, ring in sorted(odd, key=lambda item: item[0]):
        try:
            polygon = Polygon(ring)
        except InvalidShape as error:
            raise InvalidShape(f"polygon {i}: {error}") from None
        pieces = parts(polygon)
        if len(pieces) > 1 and concave == "refuse":
            raise InvalidShape(
                f"polygon {i} is not convex: split it with satviz.parts first, "
                'or pass concave="split", which keeps the owner of each part'
            )
        split = split or len(pieces) > 1
        for piece in pieces:
            corners = np.asarray(piece.corners)
            column = np.asarray([i]), corners[:, :1].copy(), corners[:, 1:].copy()
            found.setdefault(len(corners), []).append(column)
    groups, ids, counts, slots = {}, [], [], []
    for v, columns in sorted(found.items()):
        mine = np.concatenate([c[0] for c in columns])
        order = np.argsort(mine, kind="stable")
        x, y = (np.concatenate([c[k] for c in columns], axis=1) if len(columns) > 1 else columns[0][k] for k in (1, 2))
        if len(columns) > 1:
            mine, x, y = mine[order], np.ascontiguousarray(x[:, order]), np.ascontiguousarray(y[:, order])
        groups[v] = Group(x, y, None, _span(x, y), float(max(np.abs(x).max(initial=0.0), np.abs(y).max(initial=0.0))))
        ids.append(mine)
        counts.append(np.full(len(mine), v))
        slots.append(np.arange(len(mine)))
    owner, count, slot = (np.concatenate(c) if c else np.empty(0, np.int64) for c in (ids, counts, slots))
    order = np.argsort(owner, kind="stable") if len(groups) > 1 else slice(None)
    return Shapes(groups, count[order], slot[order], owner[order] if split else None)


def _span(x: NDArray, y: NDArray) -> float:
    with np.errstate(over="ignore"):
        edges = max((float(np.abs(c - np.roll(c, 1, axis=0)).max(initial=0.0)) for c in (x, y)), default=0.0)
    return min(edges, 1e308)


def _orient(x: NDArray, y: NDArray) -> NDArray[np.bool_]:
    """Turn clockwise columns round in place; True for the columns that are plainly convex (exactly).

    Plainly: every corner turns the same way, once round, with no repeat and none straight on.
    """
    v, n = x.shape
    nx, ny = np.roll(x, -1, axis=0), np.roll(y, -1, axis=0)
    turns = np.empty((v, n), np.int8)
    for i in range(v):
        j, k = (i + 1) % v, (i + 2) % v
        turns[i] = signs.orient(x[i], y[i], x[j], y[j], x[k], y[k])
    left, right = (turns > 0).all(axis=0), (turns < 0).all(axis=0)
    if v > 4:  # with 3 or 4 corners the same way there is no going round twice
        rising = (nx > x) | ((nx == x) & (ny > y))
        once = (rising != np.roll(rising, 1, axis=0)).sum(axis=0) == 2
        left &= once
        right &= once
    if right.any():
        for c in (x, y):
            c[:, right] = c[::-1, right]
    return left | right
