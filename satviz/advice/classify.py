"""Where a model is surely right about many pairs: the bounds of `proofs.py`, with room for the rounding of asking."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from .. import batch
from ..batch.arrays import Group, Shapes
from ..batch.codes import APART, OVERLAPPING, UNDECIDED
from ..batch.exact_signs import two_sum
from ..engine.predicates import UNIT
from . import certified_bounds, rounding
from .candidates import AABB, BOUNDING_CIRCLES, EXACT_FILTER, K_DOP, Model
from .certified_bounds import WIDENING, certify_convex_sat
from .limits import refuse_too_many_fractions
from .models import (
    DTYPES,
    bounding_boxes,
    bounding_circles,
    compare_boxes,
    direction_ranges,
    is_circle,
    relations_of_gaps,
)
from .pairs import Array, Indices, Pairs, Relations, max_coordinates, pair_columns, part_shape
from .rounding import FLOAT64, FORMATS, Format
from .rounding_numpy import Errors

ROUNDED = 1 + 2.0**-40  # more than a few roundings of float64


def classify(model: Model, pairs: Pairs, exact: Relations, *, engine: str | None = None) -> Relations:
    """The relation each pair surely gets in any order of operations; UNDECIDED where rounding can decide.

    `exact`: the relations themselves, which are also what comes out where nothing is rounded.  `engine`: as in
    `batch.relate`, which gives those of convex parts.
    """
    a, b, ia, ib = pairs.a, pairs.b, pairs.ia, pairs.ib
    with np.errstate(all="ignore"):
        if model.kind == EXACT_FILTER:
            return exact
        if model.kind == AABB:
            return _sure_boxes(a, ia, b, ib)
        if model.kind == BOUNDING_CIRCLES:
            held, bare = (
                _sure_circles(bounding_circles(a, by)[ia], bounding_circles(b, by)[ib], FLOAT64)
                for by in (WIDENING, 1.0)
            )
            return np.where(held == bare, held, UNDECIDED).astype(np.int8)
        if model.kind == K_DOP:
            return _sure_ranges(model, pairs)
        form = FORMATS[model.kind]
        relations = exact
        if a.owner is not None or b.owner is not None:
            relations = batch.relate(a.parts, b.parts, np.stack([pairs.pa, pairs.pb], axis=1), engine=engine)
        found = np.empty(len(pairs.pa), np.int8)
        fine_a, fine_b = (PartGrids.of(s.parts) for s in (a, b))
        for mine, p, q in pair_columns(a.parts, pairs.pa, b.parts, pairs.pb):
            found[mine] = _by_bounds(p, q, form)
            coarse = fits_grid(fine_a, pairs.pa[mine], fine_b, pairs.pb[mine], form)
            if p.r is None and q.r is None:
                found[mine] = np.where(coarse, relations[mine], found[mine])
            doubt = np.flatnonzero(found[mine] == UNDECIDED)
            if doubt.size and p.r is None and q.r is None:  # of two circles it has been asked
                plain = mine[doubt[_rounds_nothing(p.columns(doubt), q.columns(doubt), form)]]
                found[plain] = relations[plain]
        return pairs.whole(_asked_of_fractions(pairs, found, form))


def _asked_of_fractions(pairs: Pairs, found: Relations, form: Format) -> Relations:
    """Ask fractions about convex parts that arrays doubt, as their bounds are a little wider: up to a real doubt."""
    doubt = np.flatnonzero((found == UNDECIDED) & (pairs.whole(found)[pairs.of] == UNDECIDED))
    for many, k in enumerate(doubt.tolist()):
        refuse_too_many_fractions(many, len(doubt))
        said = certify_convex_sat(part_shape(pairs.a.parts, pairs.pa[k]), part_shape(pairs.b.parts, pairs.pb[k]), form)
        if said is None:
            break
        found[k] = said
    return found


def _by_bounds(p: Group, q: Group, form: Format) -> Relations:
    if p.r is not None and q.r is not None:
        return _sure_circles(_rows(p), _rows(q), form)
    if p.r is not None or q.r is not None:
        return _sure_center(p, q, form) if p.r is not None else _sure_center(q, p, form)
    return _sure_polygons(p, q, form)


def _rounds_nothing(p: Group, q: Group, form: Format) -> NDArray[np.bool_]:
    """Where the format holds every number that SAT can compute of two polygons on the way."""
    errors = Errors(form, p.x.shape[1])
    for g in (p, q):
        errors.held(g.x), errors.held(g.y)
    for _ in rounding.polygons(errors, *(list(zip(g.x, g.y, strict=True)) for g in (p, q))):
        if not errors.exact.any():
            break
    return errors.exact


class PartGrids(NamedTuple):
    """Of each part the exponent of the finest power of two that its numbers are multiples of, and their magnitudes.

    `most`: the largest number; `span`: the largest part of an edge, 0 of a circle.
    """

    unit: Array
    most: Array
    span: Array

    @classmethod
    def of(cls, parts: Shapes) -> "PartGrids":
        """Of convex parts."""
        found = cls(*np.empty((3, len(parts.count))))
        for v, g in parts.groups.items():
            mine = parts.count == v
            rows = _rows(g)
            mantissa, power = np.frexp(rows)
            n = (mantissa * 2.0**53).astype(np.int64)
            size = np.where(n == 0, 5000, np.frexp((n & -n).astype(float))[1] - 1 + power - 53)
            found.unit[mine], found.most[mine] = size.min(axis=1), np.abs(rows).max(axis=1)
            edges = (np.abs(c - np.roll(c, 1, axis=0)).max(axis=0) for c in (g.x, g.y))
            found.span[mine] = np.maximum(*edges)
        return found


def fits_grid(a: PartGrids, ia: Indices, b: PartGrids, ib: Indices, form: Format) -> NDArray[np.bool_]:
    """Which pairs of polygons are whole multiples of one unit, so few of it that nothing is rounded.

    The bound of `scope`: an edge's part times a coordinate, times four, is at most 2**bits of that unit squared.
    """
    unit = np.minimum(a.unit[ia], b.unit[ib])
    most, span = (np.maximum(c[ia], d[ib]) for c, d in ((a.most, b.most), (a.span, b.span)))
    by = -np.clip(unit, -1000, 1000).astype(int)
    few = 4 * np.ldexp(most, by) * np.ldexp(span, by) <= 2.0**form.bits
    found: NDArray[np.bool_] = few & (unit >= np.frexp(form.least)[1]) & (most < form.most)
    return found


def _sure_boxes(a: Shapes, ia: Indices, b: Shapes, ib: Indices) -> Relations:
    outer, inner = (compare_boxes(_boxes(a, way)[ia], _boxes(b, way)[ib]) for way in (np.inf, -np.inf))
    return np.where(outer == inner, outer, UNDECIDED).astype(np.int8)


def _boxes(shapes: Shapes, way: float) -> Array:
    """(N, 4) boxes; a circle's sides that are rounded are moved one float outwards (inf) or inwards (-inf)."""
    disc, found = bounding_circles(shapes), bounding_boxes(shapes)
    circle = np.flatnonzero(is_circle(shapes))
    for side in range(4):
        out = -1.0 if side < 2 else 1.0
        at, error = two_sum(disc[circle, side % 2], out * disc[circle, 2])
        found[circle, side] = np.where(error == 0, at, np.nextafter(at, out * way))
    return found


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
    reach = np.maximum(np.abs(a[:, :2]).max(axis=1), np.abs(b[:, :2]).max(axis=1)) + np.maximum(a[:, 2], b[:, 2])
    far_off = certified_bounds.RANGE_ROUNDINGS * (2.0**-form.bits + 2.0**-53) * 1.001 * reach
    near = np.abs(np.sqrt(distance) - total) <= far_off  # where ranges can err
    doubt, exact = found == UNDECIDED, np.ones(len(a), bool)
    for formula, where in (rounding.circles, doubt & known), (rounding.circle_ranges, (doubt | near) & known):
        errors = Errors(form, int(np.count_nonzero(where)))
        formula(errors, *([errors.held(c) for c in disc[where].T] for disc in (a, b)))
        exact[where] &= errors.exact
    return np.where(exact & known, np.where(doubt, relations_of_gaps(distance - square), found), UNDECIDED).astype(
        np.int8
    )


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
    p, q = direction_ranges(a, model.directions)[ia], direction_ranges(b, model.directions)[ib]
    gap = np.maximum(p[:, :, 0] - q[:, :, 1], q[:, :, 0] - p[:, :, 1])
    most = np.maximum(_most(a)[ia], _most(b)[ib])
    room = most * (2.0**-53 * 32)
    room[~((most > FLOAT64.least) & (most < FLOAT64.most))] = np.inf
    plain = _lands_exactly(a, model)[ia] & _lands_exactly(b, model)[ib]
    known = plain | (np.abs(gap) > room[:, None])
    apart = (known & (gap > 0)).any(axis=1)
    return np.where(apart, APART, np.where(known.all(axis=1), relations_of_gaps(gap.max(axis=1)), UNDECIDED)).astype(
        np.int8
    )


def _lands_exactly(shapes: Shapes, model: Model) -> NDArray[np.bool_]:
    """(N, k) where projecting all corners of a shape on each direction rounds nothing."""
    x, y, start = shapes.rings
    found = np.empty((len(shapes), len(model.directions)), bool)
    for k, (nx, ny) in enumerate(model.directions):
        errors = Errors(FLOAT64, len(x))
        rounding.landing(errors, (np.full_like(x, nx), np.full_like(y, ny)), (x, y))
        found[:, k] = np.logical_and.reduceat(errors.exact, start[shapes.starts[:-1]])
    return found


def _most(shapes: Shapes) -> Array:
    """(N,) the largest magnitude of a coordinate of each shape."""
    most: Array = np.abs(shapes.bounds).max(axis=1)
    return most


def _sure_polygons(p: Group, q: Group, form: Format) -> Relations:
    """By the exact bounds of `proofs`, with room for what is rounded in asking: 17 u DM, and a thousandth."""
    most = np.maximum(max_coordinates(p), max_coordinates(q))
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
        size = certified_bounds.TURN_ROUNDINGS * unit * (far + 2 * moved) * (long + 4 * moved)
        size += 1.001 * moved * (2 * long + 4 * far + 8 * moved)
        inside &= turn > size
        outside |= turn < -size
        along, square = -(x[e - 1] * dx + y[e - 1] * dy), dx * dx + dy * dy
        ends = np.where(along <= 0, x[e - 1] ** 2 + y[e - 1] ** 2, x[e] ** 2 + y[e] ** 2)
        np.minimum(nearest, np.where((along > 0) & (along < square), turn / square * turn, ends), out=nearest)
    square = circle.r * circle.r
    room = unit * (certified_bounds.DISTANCE_ROUNDINGS * (far + 2 * moved) ** 2 + 8 * square) + 9.001 * moved * (
        far + moved
    )
    reach = np.maximum.reduce([np.abs(c).max(axis=0) for c in (ring.x, ring.y, circle.x, circle.y)])
    far_off = certified_bounds.RANGE_ROUNDINGS * unit * (reach + circle.r)
    rim, depth = circle.r + far_off, np.maximum(circle.r - far_off, 0)  # by more than ranges can be off
    deep = inside & ((depth > 0) | (nearest > (far_off - circle.r) ** 2 * ROUNDED + room))
    over = good & (deep | ((depth > 0) & (nearest < np.minimum(square, depth * depth / ROUNDED) - room)))
    apart = good & outside & (nearest > np.maximum(square, rim * rim * ROUNDED) + room)
    return np.where(over, OVERLAPPING, np.where(apart, APART, UNDECIDED)).astype(np.int8)
