"""The models for many pairs: what each keeps of the shapes, what it answers, and where it is surely right about that.

What is sure here is sure in `proofs.py` too, whose bounds are asked with room for the rounding of asking.
"""

from dataclasses import dataclass
from functools import cache
from importlib.util import find_spec
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .. import batch
from ..batch.arrays import Group, Shapes
from ..batch.codes import APART, OVERLAPPING, TOUCHING, UNDECIDED
from ..batch.filter_numpy import clearance
from ..engine.exact import HUGE, TINY, UNIT
from ..engine.geometry import Vec
from . import proofs
from .proofs import (
    BOXES,
    CIRCLES,
    DIRECTIONS,
    EXACT,
    FILLED,
    FLOAT64,
    FORMATS,
    MOST_DIRECTIONS,
    PARALLEL,
    Format,
    Model,
)
from .turns import Array, Indices, columns, in_a_row, part_pairs, reach

Relations = NDArray[np.int8]
BLOCK = 16384  # pairs at a time, whose columns stay in the cache
DTYPES: dict[str, Any] = {"float32": np.float32, "float64": np.float64}


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


# -- what is kept


@dataclass(frozen=True)
class Flat:
    """All convex parts in one float format: corners one after another with radii, and in columns."""

    x: NDArray[Any]
    y: NDArray[Any]
    r: NDArray[Any]
    start: Indices
    bounds: NDArray[Any]
    count: NDArray[np.int64]
    slot: Indices
    groups: dict[int, Group]


def kept(model: Model, shapes: Shapes) -> Any:
    """What a model keeps of shapes: the set-up that its times cold have in them."""
    if model.kind == EXACT:
        _ = shapes.groups, shapes.rings, shapes.slot
        return shapes
    if model.kind == BOXES:
        return np.ascontiguousarray(shapes.bounds)
    if model.kind == CIRCLES:
        return discs(shapes)
    if model.kind == DIRECTIONS:
        return ranges(shapes, model.directions)
    dtype = DTYPES[model.kind]
    with np.errstate(over="ignore"):
        groups = {
            v: g._replace(x=g.x.astype(dtype), y=g.y.astype(dtype), r=None if g.r is None else g.r.astype(dtype))
            for v, g in shapes.groups.items()
        }
        x, y, r = (c.astype(dtype) for c in (*shapes.rings[:2], radii(shapes)))
        bounds = shapes.parts.bounds.astype(dtype)  # rounding keeps their order, so a gap that is left was there
        return Flat(x, y, r, shapes.rings.start, bounds, shapes.count, shapes.slot, groups)


def radii(shapes: Shapes) -> Array:
    """(N,) of each part: 0 of polygons."""
    found = np.zeros(len(shapes.count))
    if (group := shapes.groups.get(1)) is not None:
        found[shapes.count == 1] = group.r
    return found


def is_circle(shapes: Shapes) -> NDArray[np.bool_]:
    """(N,) which shapes are circles."""
    found: NDArray[np.bool_] = shapes.count[shapes.starts[:-1]] == 1
    return found


def discs(shapes: Shapes) -> Array:
    """(N, 3) x, y, radius of a circle around each shape, as `proofs.around` has them."""
    found = np.empty((len(shapes), 3))
    x, y, start = shapes.rings
    box = shapes.bounds
    first = shapes.rings.start[shapes.starts[:-1]]
    with np.errstate(all="ignore"):
        found[:, :2] = box[:, :2] / 2 + box[:, 2:] / 2
        many = np.diff(np.concatenate([first, start[-1:]]))
        dx, dy = (c - np.repeat(found[:, i], many) for i, c in enumerate((x, y)))
        square = np.maximum.reduceat(dx * dx + dy * dy, first) if len(first) else np.empty(0)
        found[:, 2] = np.where((square > TINY) & (square < HUGE), np.sqrt(square) * FILLED, 0.0)
    circle = np.flatnonzero(is_circle(shapes))
    part = shapes.starts[circle]
    found[circle] = np.stack([x[start[part]], y[start[part]], radii(shapes)[part]], axis=1)
    return found


def ranges(shapes: Shapes, directions: tuple[Vec, ...]) -> Array:
    """(N, k, 2) least and most of x*nx + y*ny."""
    x, y, start = shapes.rings
    first = start[shapes.starts[:-1]]
    found = np.empty((len(shapes), len(directions), 2))
    if len(first):
        for k, (nx, ny) in enumerate(directions):
            at = x * nx + y * ny
            found[:, k, 0], found[:, k, 1] = np.minimum.reduceat(at, first), np.maximum.reduceat(at, first)
    return found


def shared_directions(*many: Shapes) -> tuple[Vec, ...]:
    """The same as `proofs.shared_directions` for many."""
    edges = []
    for shapes in many:
        if (shapes.count == 1).any():
            return ()
        x, y, start = shapes.rings
        after = np.arange(1, len(x) + 1)
        after[start[1:] - 1] = start[:-1]
        with np.errstate(all="ignore"):
            edges.append(np.stack([y[after] - y, x - x[after]]))
    left = np.concatenate(edges, axis=1)
    size = np.abs(left).max(axis=0)
    if not size.size or not (np.isfinite(size).all() and (size > 0).all()):
        return ()
    left = np.ldexp(left * np.copysign(1.0, np.where(left[0], left[0], left[1])), -np.frexp(size)[1]) + 0.0
    found: list[Vec] = []
    while left.size:
        if len(found) == MOST_DIRECTIONS:
            return ()
        nx = left[0].min()
        ny = left[1, left[0] == nx].min()
        found.append(Vec(float(nx), float(ny)))
        left = left[:, np.abs(nx * left[1] - ny * left[0]) > PARALLEL]
    return tuple(found)


# -- what is answered


@cache
def compiled() -> Any:
    """The compiled kernels, or None where numba does not work."""
    if not find_spec("numba"):
        return None
    try:
        from . import kernels
    except Exception:  # as narrow.engine_of, which warns
        return None
    return kernels


def answers(model: Model, pairs: Pairs, a: Any, b: Any, *, engine: str | None = None) -> Relations:
    """The relations that the model gives, from what it has kept of both sides."""
    ia, ib = pairs.ia, pairs.ib
    if model.kind == EXACT:
        return batch.relate(a, b, np.stack([ia, ib], axis=1), engine=engine)
    kernels = None if engine == "numpy" else compiled()
    out = np.empty(len(ia), np.int8)
    if model.kind in FORMATS:
        return _sat(pairs, a, b, kernels)
    if kernels is not None:
        kernel = {BOXES: kernels.boxes, CIRCLES: kernels.circles, DIRECTIONS: kernels.ranges}[model.kind]
        kernel(a, ia, b, ib, out)
        return out
    look = {BOXES: _by_boxes, CIRCLES: _by_circles, DIRECTIONS: _by_ranges}[model.kind]
    for start in range(0, len(ia), BLOCK):
        part = slice(start, start + BLOCK)
        with np.errstate(all="ignore"):
            out[part] = look(a[in_a_row(ia[part])], b[in_a_row(ib[part])])
    return out


def _told(gap: NDArray[Any]) -> Relations:
    return _counted(gap > 0, gap < 0)


def _by_boxes(a: Array, b: Array) -> Relations:
    apart = (a[:, 0] > b[:, 2]) | (b[:, 0] > a[:, 2]) | (a[:, 1] > b[:, 3]) | (b[:, 1] > a[:, 3])
    over = (a[:, 0] < b[:, 2]) & (b[:, 0] < a[:, 2]) & (a[:, 1] < b[:, 3]) & (b[:, 1] < a[:, 3])
    return _counted(apart, over)


def _counted(apart: Any, over: Any) -> Relations:
    found: Relations = over.view(np.int8) - apart.view(np.int8)
    found += TOUCHING
    return found


def _by_circles(a: Array, b: Array) -> Relations:
    dx, dy, total = a[:, 0] - b[:, 0], a[:, 1] - b[:, 1], a[:, 2] + b[:, 2]
    return _told(dx * dx + dy * dy - total * total)


def _by_ranges(a: Array, b: Array) -> Relations:
    apart, over = np.zeros(len(a), bool), np.ones(len(a), bool)
    for k in range(a.shape[1]):
        apart |= (a[:, k, 0] > b[:, k, 1]) | (b[:, k, 0] > a[:, k, 1])
        over &= (a[:, k, 0] < b[:, k, 1]) & (b[:, k, 0] < a[:, k, 1])
    return _counted(apart, over)


def _sat(pairs: Pairs, a: Flat, b: Flat, kernels: Any) -> Relations:
    found = np.empty(len(pairs.pa), np.int8)
    if kernels is not None:
        kernels.sat(a.x, a.y, a.r, a.start, a.bounds, pairs.pa, b.x, b.y, b.r, b.start, b.bounds, pairs.pb, found)
    else:
        for mine, p, q in columns(a, pairs.pa, b, pairs.pb, BLOCK):
            with np.errstate(all="ignore"):
                found[mine] = _told(_gaps(p, q))
    return pairs.whole(found)


def _gaps(p: Group, q: Group) -> NDArray[Any]:
    if p.r is not None and q.r is not None:
        dx, dy, total = p.x[0] - q.x[0], p.y[0] - q.y[0], p.r + q.r
        gap: NDArray[Any] = dx * dx + dy * dy - total * total
        return gap
    if p.r is not None or q.r is not None:
        return _from_center(p, q) if p.r is not None else _from_center(q, p)
    look: Any = clearance  # whose types say float32, where it is used
    found: NDArray[Any] = look(p.x, p.y, q.x, q.y, 0)
    return found


def _from_center(circle: Group, ring: Group) -> NDArray[Any]:
    assert circle.r is not None
    x, y = ring.x - circle.x, ring.y - circle.y
    inside = np.ones(x.shape[1], bool)
    nearest = np.full(x.shape[1], np.inf, x.dtype)
    for e in range(len(x)):
        dx, dy = ring.x[e] - ring.x[e - 1], ring.y[e] - ring.y[e - 1]
        turn = x[e - 1] * dy - y[e - 1] * dx
        inside &= turn > 0
        along, square = -(x[e - 1] * dx + y[e - 1] * dy), dx * dx + dy * dy
        ends = np.where(along <= 0, x[e - 1] ** 2 + y[e - 1] ** 2, x[e] ** 2 + y[e] ** 2)
        away = np.where((along > 0) & (along < square), turn / square * turn, ends)
        np.minimum(nearest, away, out=nearest)
    return np.where(inside, -1, nearest - circle.r * circle.r)


# -- where it is sure


def sure(model: Model, pairs: Pairs, exact: Relations) -> Relations:
    """The relation each pair surely gets in any order of operations; UNDECIDED where rounding can decide.

    `exact`: the relations themselves, which are also what comes out where nothing is rounded.
    """
    a, b, ia, ib = pairs.a, pairs.b, pairs.ia, pairs.ib
    with np.errstate(all="ignore"):
        if model.kind == EXACT:
            return exact
        if model.kind == BOXES:
            return _sure_boxes(a.bounds, is_circle(a), ia, b.bounds, is_circle(b), ib)
        if model.kind == CIRCLES:
            return _sure_circles(discs(a)[ia], discs(b)[ib], FLOAT64)
        if model.kind == DIRECTIONS:
            return _sure_ranges(model, pairs)
        form = FORMATS[model.kind]
        parts = exact
        if a.owner is not None or b.owner is not None:
            parts = batch.relate(a.parts, b.parts, np.stack([pairs.pa, pairs.pb], axis=1))
        found = np.empty(len(pairs.pa), np.int8)
        fine_a, fine_b = (Grid.of_parts(s) for s in (a.parts, b.parts))
        for mine, p, q in columns(a.parts, pairs.pa, b.parts, pairs.pb):
            pa, pb = pairs.pa[mine], pairs.pb[mine]
            if p.r is not None and q.r is not None:
                found[mine] = _sure_circles(_rows(p), _rows(q), form)
            elif p.r is not None or q.r is not None:
                found[mine] = _sure_center(p, q, form) if p.r is not None else _sure_center(q, p, form)
            else:
                found[mine] = _sure_polygons(p, q, form)
                plain = whole(fine_a, pa, fine_b, pb, form)
                found[mine] = np.where(plain, parts[mine], found[mine])
        return pairs.whole(found)


class Grid(NamedTuple):
    """Of each shape the finest power of two that its numbers are multiples of, and the largest of them."""

    unit: Array
    most: Array

    @classmethod
    def of(cls, numbers: Array) -> "Grid":
        """By the (N, k) numbers of each shape."""
        mantissa, power = np.frexp(numbers)
        n = (mantissa * 2.0**53).astype(np.int64)
        size = np.where(n == 0, 5000, np.log2(np.maximum(n & -n, 1).astype(float)) + power - 53)
        return cls(size.min(axis=1, initial=5000), np.abs(numbers).max(axis=1, initial=0.0))

    @classmethod
    def of_parts(cls, shapes: Shapes) -> "Grid":
        """Of convex parts."""
        unit, most = np.empty((2, len(shapes.count)))
        for v, g in shapes.groups.items():
            unit[shapes.count == v], most[shapes.count == v] = cls.of(_rows(g))
        return cls(unit, most)


def whole(a: Grid, ia: Indices, b: Grid, ib: Indices, form: Format, bits: int = 0) -> NDArray[np.bool_]:
    """Which pairs are whole multiples of one unit, so few of it that nothing is rounded."""
    unit, most = np.minimum(a.unit[ia], b.unit[ib]), np.maximum(a.most[ia], b.most[ib])
    fits = np.ldexp(most, -np.clip(unit, -1000, 1000).astype(int)) <= 2.0 ** (bits or form.whole)
    found: NDArray[np.bool_] = fits & (unit > np.log2(form.least)) & (most < form.most)
    return found


def _sure_boxes(
    box_a: Array, round_a: NDArray[np.bool_], ia: Indices, box_b: Array, round_b: NDArray[np.bool_], ib: Indices
) -> Relations:
    found = _by_boxes(box_a[ia], box_b[ib])
    circles = np.flatnonzero((round_a[ia] | round_b[ib]) & (found != APART))
    inner = _by_boxes(_inner(box_a, round_a)[ia[circles]], _inner(box_b, round_b)[ib[circles]])
    found[circles] = np.where(inner == OVERLAPPING, inner, UNDECIDED)
    return found


def _inner(box: Array, circle: NDArray[np.bool_]) -> Array:
    inwards = np.array([np.inf, np.inf, -np.inf, -np.inf])
    return np.where(circle[:, None], np.nextafter(np.nextafter(box, inwards), inwards), box)


def _sure_circles(a: Array, b: Array, form: Format) -> Relations:
    dx, dy, total = a[:, 0] - b[:, 0], a[:, 1] - b[:, 1], a[:, 2] + b[:, 2]
    distance, square = dx * dx + dy * dy, total * total
    size = np.maximum(np.maximum(np.abs(dx), np.abs(dy)), total)
    most = np.maximum(np.abs(a).max(axis=1), np.abs(b).max(axis=1))
    known = (a[:, 2] > 0) & (b[:, 2] > 0)
    moved = np.where(_held(form, a) & _held(form, b), 0.0, most * 2.0**-form.bits)
    room = (12.001 * 2.0**-form.bits + 2.0**-49) * (distance + square)
    room += 5.001 * moved * (np.abs(dx) + np.abs(dy)) + 9.001 * moved * moved
    room[~(known & (size > form.least * 1.001) & (most < form.most))] = np.inf
    found = _beyond(distance - square, room)
    i = np.arange(len(a))
    plain = known & whole(Grid.of(a), i, Grid.of(b), i, form)
    return np.where(plain, _told(distance - square), found)


def _rows(g: Group) -> Array:
    """(n, k) all numbers of each shape."""
    return np.concatenate([g.x, g.y] if g.r is None else [g.x, g.y, g.r[None]]).T


def _held(form: Format, rows: Array) -> NDArray[np.bool_]:
    """Which rows the format holds as they are."""
    found: NDArray[np.bool_] = (form is FLOAT64) | (rows.astype(DTYPES[form.name]) == rows).all(axis=1)
    return found


def _beyond(gap: Array, room: Array) -> Relations:
    return np.where(gap > room, APART, np.where(gap < -room, OVERLAPPING, UNDECIDED)).astype(np.int8)


def _sure_ranges(model: Model, pairs: Pairs) -> Relations:
    a, b, ia, ib = pairs.a, pairs.b, pairs.ia, pairs.ib
    p, q = ranges(a, model.directions)[ia], ranges(b, model.directions)[ib]
    gap = np.maximum(p[:, :, 0] - q[:, :, 1], q[:, :, 0] - p[:, :, 1])
    grids = [_of_shapes(s) for s in (a, b)]
    most = np.maximum(grids[0].most[ia], grids[1].most[ib])
    room = most * (2.0**-53 * 32)
    room[~((most > FLOAT64.least) & (most < FLOAT64.most))] = np.inf
    found = _beyond(gap.max(axis=1), room)
    if all(proofs.whole(n, FLOAT64, 24) for n in model.directions):
        plain = whole(grids[0], ia, grids[1], ib, FLOAT64, 27)
        found = np.where(plain, _told(gap.max(axis=1)), found)
    return found


def _of_shapes(shapes: Shapes) -> Grid:
    parts, first = Grid.of_parts(shapes.parts), shapes.starts[:-1]
    if not len(first):
        return parts
    return Grid(np.minimum.reduceat(parts.unit, first), np.maximum.reduceat(parts.most, first))


def _sure_polygons(p: Group, q: Group, form: Format) -> Relations:
    """By the exact bounds of `proofs`, with room for what is rounded in asking: 17 u DM, and a thousandth."""
    most = np.maximum(reach(p), reach(q))
    wide = np.maximum(
        *(np.maximum(c.max(0), d.max(0)) - np.minimum(c.min(0), d.min(0)) for c, d in ((p.x, q.x), (p.y, q.y)))
    )
    moved = np.zeros_like(most)
    if form is not FLOAT64:
        held = np.logical_and(*(_held(form, _rows(g)) for g in (p, q)))
        moved = np.where(held, 0.0, most * 2.0**-form.bits)
    good = (most > form.least) & (most < form.most)
    apart, over = np.zeros(len(most), bool), good.copy()
    for own, other in (p, q), (q, p):
        for e in range(len(own.x)):
            x, y = own.x[e - 1], own.y[e - 1]
            nx, ny = own.y[e] - y, x - own.x[e]
            span = np.maximum(np.abs(nx), np.abs(ny))
            least = (nx * (other.x - x) + ny * (other.y - y)).min(axis=0)
            room = 32.001 * 2.0**-form.bits * (span + 2 * moved) * (most + moved) + 4.001 * moved * (
                span + wide + 2 * moved
            )
            room += 32 * UNIT * span * most
            known = span > form.least * 1.001
            apart |= known & (least > room)
            over &= known & (least < -room)
    return np.where(good & apart, APART, np.where(over, OVERLAPPING, UNDECIDED)).astype(np.int8)


def _sure_center(circle: Group, ring: Group, form: Format) -> Relations:
    """By the same bounds; asking rounds by as much as float64 does, with what is asked of it."""
    assert circle.r is not None
    x, y = ring.x - circle.x, ring.y - circle.y
    far = np.maximum(np.abs(x).max(axis=0), np.abs(y).max(axis=0))
    rows = _rows(ring), _rows(circle)
    most = np.maximum(far, np.maximum(*(np.abs(numbers).max(axis=1) for numbers in rows)))
    moved = np.where(_held(form, rows[0]) & _held(form, rows[1]), 0.0, most * 2.0**-form.bits)
    good = most < form.most
    unit = (2.0**-form.bits + UNIT) * 1.001
    inside, outside = good.copy(), np.zeros(len(far), bool)
    nearest = np.full(len(far), np.inf)
    for e in range(len(x)):
        dx, dy = ring.x[e] - ring.x[e - 1], ring.y[e] - ring.y[e - 1]
        good &= np.maximum(np.abs(dx), np.abs(dy)) > (form.least + 2 * moved) * 1.001
        turn = x[e - 1] * dy - y[e - 1] * dx
        long = np.abs(dx) + np.abs(dy)
        size = proofs.TURNS * unit * (far + 2 * moved) * (long + 4 * moved)
        size += 1.001 * moved * (2 * long + 4 * far + 8 * moved)
        inside &= turn > size
        outside |= turn < -size
        along, square = -(x[e - 1] * dx + y[e - 1] * dy), dx * dx + dy * dy
        ends = np.where(along <= 0, x[e - 1] ** 2 + y[e - 1] ** 2, x[e] ** 2 + y[e] ** 2)
        np.minimum(nearest, np.where((along > 0) & (along < square), turn / square * turn, ends), out=nearest)
    square = circle.r * circle.r
    room = unit * (proofs.SQUARES * (far + 2 * moved) ** 2 + 8 * square) + 9.001 * moved * (far + moved)
    over = good & (inside | (nearest < square - room))
    apart = good & outside & (nearest > square + room)
    return np.where(over, OVERLAPPING, np.where(apart, APART, UNDECIDED)).astype(np.int8)
