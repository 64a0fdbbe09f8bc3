"""Where a model is surely right about many pairs: the bounds of `proofs.py`, with room for the rounding of asking."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from .. import batch
from ..batch.arrays import Group, Shapes
from ..batch.codes import APART, OVERLAPPING, UNDECIDED
from ..engine.exact import UNIT
from . import proofs
from .models import DTYPES, by_boxes, discs, is_circle, ranges, told
from .pairs import Array, Indices, Pairs, Relations, columns, reach
from .proofs import BOXES, CIRCLES, DIRECTIONS, EXACT, FLOAT64, FORMATS, Format, Model


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
        size = np.where(n == 0, 5000, np.frexp((n & -n).astype(float))[1] - 1 + power - 53)
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
    found: NDArray[np.bool_] = fits & (unit >= np.frexp(form.least)[1]) & (most < form.most)
    return found


def _sure_boxes(
    box_a: Array, round_a: NDArray[np.bool_], ia: Indices, box_b: Array, round_b: NDArray[np.bool_], ib: Indices
) -> Relations:
    found = by_boxes(box_a[ia], box_b[ib])
    circles = np.flatnonzero((round_a[ia] | round_b[ib]) & (found != APART))
    inner = by_boxes(_inner(box_a, round_a)[ia[circles]], _inner(box_b, round_b)[ib[circles]])
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
    return np.where(plain, told(distance - square), found)


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
        found = np.where(plain, told(gap.max(axis=1)), found)
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
