"""Circles and Polygons: many shapes checked at the door and sorted into groups."""

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from ..engine import outline
from ..engine.concave import parts
from ..engine.geometry import InvalidShape
from ..engine.shapes import Polygon
from . import door, signs
from .arrays import Group, Shapes, upright_boxes
from .signs import Array

Indices = NDArray[np.intp]
Mask = NDArray[np.bool_]


def Circles(centers: door.Points, radii: door.Numbers) -> Shapes:
    """Circles from (N, 2) centers and (N,) radii, or one radius (scene units); InvalidShape names the first bad one."""
    centers = door.points(centers, "centers", lambda i: f"circle {i}: center")
    n = len(centers)
    r = door.numbers(radii, "radii", "radius", lambda i: f"circle {i}: radius")
    if r.shape not in ((), (1,), (n,)):
        raise InvalidShape(f"radii has the shape {r.shape}: expected ({n},), or one radius for all")
    r = np.array(np.broadcast_to(r, (n,)))
    if (bad := np.flatnonzero(~(r > 0))).size:
        raise InvalidShape(f"circle {bad[0]}: radius is {r[bad[0]]}: a circle needs a positive radius")
    x, y = (np.array(centers[:, i][None]) for i in (0, 1))
    with np.errstate(over="ignore"):
        reach = float((np.abs(centers).max(axis=1, initial=0.0) + r).max(initial=0.0))
    group = Group(x, y, r, float(r.max(initial=0.0)), reach)
    return Shapes({1: group}, np.ones(n, np.int64), np.arange(n))


def Polygons(vertices: door.Rings, *, concave: str = "refuse") -> Shapes:
    """Convex polygons from an (N, V, 2) array, or a sequence of what satviz.Polygon takes, in scene units.

    Either winding, repeats and straight-on vertices are allowed.  `concave="split"`
    splits concave ones into parts and keeps their owner.  InvalidShape names the
    first polygon at fault and says what is wrong, as satviz.Polygon does.  What is
    given is copied, never written to.
    """
    return polygons_numbered(vertices, None, concave)


def polygons_numbered(vertices: door.Rings, numbers: Indices | None, concave: str) -> Shapes:
    """The same for some of more: `numbers` are what errors call them."""
    if concave not in ("refuse", "split"):
        raise ValueError(f'concave is {concave!r}: choose "refuse" or "split"')

    def name(i: int) -> str:
        return f"polygon {i if numbers is None else numbers[i]}"

    if isinstance(vertices, np.ndarray) and vertices.dtype != object:
        array = door.rings(vertices, name)
        return _assembled([(np.arange(len(array)), array)] if array.size else [], name, concave)
    arrays: list[Array] = []
    by_count: dict[int, list[int]] = {}
    for i, ring in enumerate(outline.listed(vertices, "vertices", "a sequence")):
        array = door.ring(ring, name(i))
        by_count.setdefault(len(array), []).append(i)
        arrays.append(array)
    blocks = [(np.asarray(ids), np.stack([arrays[i] for i in ids])) for ids in by_count.values()]
    return _assembled(blocks, name, concave)


def _assembled(blocks: Sequence[tuple[Indices, Array]], name: Callable[[int], str], concave: str) -> Shapes:
    """Sort the rings into groups; those not plainly convex go through the scalar door one by one."""
    found: dict[int, list[tuple[Indices, Array, Array]]] = {}
    odd: list[tuple[int, Array]] = []
    for ids, rings in blocks:
        x, y = (np.array(rings[:, :, i].T, order="C") for i in (0, 1))  # copied: it is turned round in place
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
            raise InvalidShape(f"{name(i)}: {error}") from None
        pieces = parts(polygon)
        if len(pieces) > 1 and concave == "refuse":
            raise InvalidShape(
                f"{name(i)} is not convex: split it with satviz.parts first, "
                'or pass concave="split", which keeps the owner of each part'
            )
        split = split or len(pieces) > 1
        for piece in pieces:
            assert isinstance(piece, Polygon)  # as are all parts of one
            corners = np.asarray(piece.corners)
            column = np.asarray([i]), corners[:, :1].copy(), corners[:, 1:].copy()
            found.setdefault(len(corners), []).append(column)
    groups: dict[int, Group] = {}
    owners, counts, slots = [], [], []
    for v, columns in sorted(found.items()):
        mine, x, y = columns[0]
        if len(columns) > 1:
            mine, x, y = (np.concatenate(c, axis=-1) for c in zip(*columns, strict=True))
            order = np.argsort(mine, kind="stable")
            mine, x, y = mine[order], np.ascontiguousarray(x[:, order]), np.ascontiguousarray(y[:, order])
        reach = float(max(np.abs(x).max(initial=0.0), np.abs(y).max(initial=0.0)))
        groups[v] = Group(x, y, None, _span(x, y), reach, v == 4 and bool(upright_boxes(x, y).all()))
        owners.append(mine)
        counts.append(np.full(len(mine), v))
        slots.append(np.arange(len(mine)))
    owner, count, slot = (np.concatenate(c) if c else np.empty(0, np.int64) for c in (owners, counts, slots))
    if len(groups) > 1:
        order = np.argsort(owner, kind="stable")
        owner, count, slot = owner[order], count[order], slot[order]
    return Shapes(groups, count, slot, owner if split else None)


def _span(x: Array, y: Array) -> float:
    with np.errstate(over="ignore"):
        edges = max((float(np.abs(c - np.roll(c, 1, axis=0)).max(initial=0.0)) for c in (x, y)), default=0.0)
    return min(edges, 1e308)


def _orient(x: Array, y: Array) -> Mask:
    """Turn clockwise columns round in place; True for the columns that are plainly convex (exactly).

    Plainly: every corner turns the same way, once round, with no repeat and none straight on.
    """
    v, n = x.shape
    nx, ny = np.roll(x, -1, axis=0), np.roll(y, -1, axis=0)
    turns = np.empty((v, n), np.int8)
    for i in range(v):
        j, k = (i + 1) % v, (i + 2) % v
        turns[i] = signs.orient(x[i], y[i], x[j], y[j], x[k], y[k])
    left: Mask = np.logical_and.reduce(turns > 0)
    right: Mask = np.logical_and.reduce(turns < 0)
    if v > 4:  # with 3 or 4 corners the same way there is no going round twice
        rising = (nx > x) | ((nx == x) & (ny > y))
        once = (rising != np.roll(rising, 1, axis=0)).sum(axis=0) == 2
        left &= once
        right &= once
    if right.any():
        for c in (x, y):
            c[:, right] = c[::-1, right]
    return left | right
