"""The relations that a model certainly finds for many pairs, with NumPy: `certified_bounds.py` for arrays.

A relation is *certified* where no order of the model's operations can give another one; elsewhere it is UNDECIDED.  The
error bounds are those of `certified_bounds.py`, widened by a thousandth or more for the rounding of this computation.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from .. import batch
from ..batch.arrays import CornerColumns, Shapes
from ..batch.codes import APART, OVERLAPPING, UNDECIDED
from ..batch.exact_signs import two_sum
from ..engine.predicates import UNIT_ROUNDOFF
from . import rounding
from .candidates import AABB, BOUNDING_CIRCLES, EXACT_FILTER, K_DOP, Model
from .certified_bounds import DISTANCE_ROUNDINGS, RANGE_ROUNDINGS, TURN_ROUNDINGS, WIDENING, certify_convex_sat
from .limits import refuse_too_many_fractions
from .margins import edge_clearances, edge_distances, max_coordinates
from .models import (
    DTYPES,
    bounding_boxes,
    bounding_circles,
    compare_boxes,
    direction_ranges,
    is_circle,
    relations_of_gaps,
)
from .pairs import Array, Indices, PartPairs, Relations, pair_columns
from .rounding import FLOAT64, FORMATS, FloatFormat
from .rounding_numpy import Errors

SQUARE_ERROR = 1 + 2.0**-40  # widens a square computed in float64, with a relative error of a few u


def classify(model: Model, pairs: PartPairs, exact: Relations, *, engine: str | None = None) -> Relations:
    """Return for each pair the relation that the model certainly finds; UNDECIDED where rounding can decide.

    `exact`: the exact relations of the pairs, which a model finds where it rounds nothing.  Those of their convex parts
    come from `batch.relate` with this `engine`.
    """
    a, b, ia, ib = pairs.a, pairs.b, pairs.ia, pairs.ib
    with np.errstate(all="ignore"):
        if model.kind == EXACT_FILTER:
            return exact
        if model.kind == AABB:
            return _classify_boxes(a, ia, b, ib)
        if model.kind == BOUNDING_CIRCLES:
            wide, bare = (
                _classify_circles(bounding_circles(a, by)[ia], bounding_circles(b, by)[ib], FLOAT64)
                for by in (WIDENING, 1.0)
            )
            return np.where(wide == bare, wide, UNDECIDED).astype(np.int8)
        if model.kind == K_DOP:
            return _classify_ranges(model, pairs)
        form = FORMATS[model.kind]
        relations = exact
        if a.owner is not None or b.owner is not None:
            relations = batch.relate(a.parts, b.parts, np.stack([pairs.pa, pairs.pb], axis=1), engine=engine)
        found = np.empty(len(pairs.pa), np.int8)
        grids_a, grids_b = (PartUnits.of(s.parts) for s in (a, b))
        for mine, p, q in pair_columns(a.parts, pairs.pa, b.parts, pairs.pb):
            found[mine] = _classify_parts(p, q, form)
            on_grid = fits_unit(grids_a, pairs.pa[mine], grids_b, pairs.pb[mine], form)
            if p.r is None and q.r is None:
                found[mine] = np.where(on_grid, relations[mine], found[mine])
            undecided = np.flatnonzero(found[mine] == UNDECIDED)
            if undecided.size and p.r is None and q.r is None:  # circles: done in _classify_circles
                exact_pairs = mine[undecided[_rounds_nothing(p.columns(undecided), q.columns(undecided), form)]]
                found[exact_pairs] = relations[exact_pairs]
        return pairs.combine(_decide_by_fractions(pairs, found, form))


def _decide_by_fractions(pairs: PartPairs, found: Relations, form: FloatFormat) -> Relations:
    """Certify UNDECIDED entries of `found` by fractions, in place, up to the first that stays undecided; return it."""
    undecided = np.flatnonzero((found == UNDECIDED) & (pairs.combine(found)[pairs.of] == UNDECIDED))
    for many, k in enumerate(undecided.tolist()):
        refuse_too_many_fractions(many, len(undecided))
        relation = certify_convex_sat(*pairs.part_shapes(k), form)
        if relation is None:
            break
        found[k] = relation
    return found


def _classify_parts(p: CornerColumns, q: CornerColumns, form: FloatFormat) -> Relations:
    """Return the relations of pairs of convex parts (columns p, q) that SAT certainly finds, else UNDECIDED."""
    if p.r is not None and q.r is not None:
        return _classify_circles(_number_rows(p), _number_rows(q), form)
    if p.r is not None or q.r is not None:
        return _classify_circle_polygons(p, q, form) if p.r is not None else _classify_circle_polygons(q, p, form)
    return _classify_polygons(p, q, form)


def _rounds_nothing(p: CornerColumns, q: CornerColumns, form: FloatFormat) -> NDArray[np.bool_]:
    """Return a mask of the polygon pairs for which the format holds every number that SAT can compute."""
    errors = Errors(form, p.x.shape[1])
    for g in (p, q):
        errors.held(g.x), errors.held(g.y)
    for _ in rounding.polygons(errors, *(list(zip(g.x, g.y, strict=True)) for g in (p, q))):
        if not errors.exact.any():
            break
    return errors.exact


class PartUnits(NamedTuple):
    """Hold for each convex part the unit of its numbers, their largest one, and its longest edge component.

    `unit`: the exponent of the largest power of two that divides all numbers of the part, (P,); `most`: the largest
    absolute number; `span`: the largest component of an edge, 0 for a circle; both in scene units.
    """

    unit: Array
    most: Array
    span: Array

    @classmethod
    def of(cls, parts: Shapes) -> "PartUnits":
        """Return the PartUnits of a batch of convex parts, computed from its coordinates and radii."""
        found = cls(*np.empty((3, len(parts.count))))
        for v, g in parts.groups.items():
            mine = parts.count == v
            rows = _number_rows(g)
            mantissa, power = np.frexp(rows)
            n = (mantissa * 2.0**53).astype(np.int64)
            size = np.where(n == 0, 5000, np.frexp((n & -n).astype(float))[1] - 1 + power - 53)
            found.unit[mine], found.most[mine] = size.min(axis=1), np.abs(rows).max(axis=1)
            edges = (np.abs(c - np.roll(c, 1, axis=0)).max(axis=0) for c in (g.x, g.y))
            found.span[mine] = np.maximum(*edges)
        return found


def fits_unit(a: PartUnits, ia: Indices, b: PartUnits, ib: Indices, form: FloatFormat) -> NDArray[np.bool_]:
    """Return a mask of the polygon pairs whose common unit is so large that SAT in this format rounds nothing.

    The bound of `scope.py`: 4 S M <= 2**bits, with S the largest edge component and M the largest coordinate, both in
    multiples of the unit.  Pair k has part ia[k] of `a` and part ib[k] of `b`.
    """
    unit = np.minimum(a.unit[ia], b.unit[ib])
    most, span = (np.maximum(c[ia], d[ib]) for c, d in ((a.most, b.most), (a.span, b.span)))
    by = -np.clip(unit, -1000, 1000).astype(int)
    fits = 4 * np.ldexp(most, by) * np.ldexp(span, by) <= 2.0**form.bits
    found: NDArray[np.bool_] = fits & (unit >= np.frexp(form.least)[1]) & (most < form.most)
    return found


def _classify_boxes(a: Shapes, ia: Indices, b: Shapes, ib: Indices) -> Relations:
    """Return the relations that bounding boxes certainly give; UNDECIDED where rounded sides can decide."""
    outer, inner = (compare_boxes(_boxes(a, outwards)[ia], _boxes(b, outwards)[ib]) for outwards in (np.inf, -np.inf))
    return np.where(outer == inner, outer, UNDECIDED).astype(np.int8)


def _boxes(shapes: Shapes, outwards: float) -> Array:
    """Return (N, 4) boxes; rounded sides of a circle are moved one float outwards (inf) or inwards (-inf)."""
    disc, found = bounding_circles(shapes), bounding_boxes(shapes)
    circle = np.flatnonzero(is_circle(shapes))
    for side in range(4):
        out = -1.0 if side < 2 else 1.0
        at, error = two_sum(disc[circle, side % 2], out * disc[circle, 2])
        found[circle, side] = np.where(error == 0, at, np.nextafter(at, out * outwards))
    return found


def _classify_circles(a: Array, b: Array, form: FloatFormat) -> Relations:
    """Return the relations of circles in rows (x, y, radius) that squared distances and ranges both certainly find."""
    dx, dy, total = a[:, 0] - b[:, 0], a[:, 1] - b[:, 1], a[:, 2] + b[:, 2]
    distance, square = dx * dx + dy * dy, total * total
    size = np.maximum(np.maximum(np.abs(dx), np.abs(dy)), total)
    most = np.maximum(np.abs(a).max(axis=1), np.abs(b).max(axis=1))
    known = (a[:, 2] > 0) & (b[:, 2] > 0)
    moved = np.where(_rows_fit_format(form, a) & _rows_fit_format(form, b), 0.0, most * 2.0**-form.bits)
    error_bound = (12.001 * 2.0**-form.bits + 2.0**-49) * (distance + square)
    error_bound += 5.001 * moved * (np.abs(dx) + np.abs(dy)) + 9.001 * moved * moved
    error_bound[~(known & (size > form.least * 1.001) & (most < form.most))] = np.inf
    gap = distance - square
    found = np.where(gap > error_bound, APART, np.where(gap < -error_bound, OVERLAPPING, UNDECIDED))
    max_coordinate = np.maximum(*(np.abs(c[:, :2]).max(axis=1) for c in (a, b))) + np.maximum(a[:, 2], b[:, 2])
    range_error = RANGE_ROUNDINGS * (2.0**-form.bits + 2.0**-53) * 1.001 * max_coordinate
    near = np.abs(np.sqrt(distance) - total) <= range_error  # where ranges can be wrong
    undecided, exact = found == UNDECIDED, np.ones(len(a), bool)
    for formula, where in (rounding.circles, undecided & known), (rounding.circle_ranges, (undecided | near) & known):
        errors = Errors(form, int(np.count_nonzero(where)))
        formula(errors, *([errors.held(c) for c in disc[where].T] for disc in (a, b)))
        exact[where] &= errors.exact
    return np.where(exact & known, np.where(undecided, relations_of_gaps(gap), found), UNDECIDED).astype(np.int8)


def _number_rows(g: CornerColumns) -> Array:
    """Return (n, k): one row per shape, with its coordinates and, for a circle, its radius."""
    return np.concatenate([g.x, g.y] if g.r is None else [g.x, g.y, g.r[None]]).T


def _rows_fit_format(form: FloatFormat, rows: Array) -> NDArray[np.bool_]:
    """Return a mask of the rows that hold only numbers of the format."""
    found: NDArray[np.bool_] = (form is FLOAT64) | (rows.astype(DTYPES[form.name]) == rows).all(axis=1)
    return found


def _classify_ranges(model: Model, pairs: PartPairs) -> Relations:
    """Return the relations that ranges on the directions of a k-DOP certainly give, else UNDECIDED."""
    a, b, ia, ib = pairs.a, pairs.b, pairs.ia, pairs.ib
    p, q = direction_ranges(a, model.directions)[ia], direction_ranges(b, model.directions)[ib]
    gap = np.maximum(p[:, :, 0] - q[:, :, 1], q[:, :, 0] - p[:, :, 1])
    most = np.maximum(np.abs(a.bounds).max(axis=1)[ia], np.abs(b.bounds).max(axis=1)[ib])
    error_bound = most * (2.0**-53 * 32)
    error_bound[~((most > FLOAT64.least) & (most < FLOAT64.most))] = np.inf
    rounds_nothing = _projects_exactly(a, model)[ia] & _projects_exactly(b, model)[ib]
    known = rounds_nothing | (np.abs(gap) > error_bound[:, None])
    apart = (known & (gap > 0)).any(axis=1)
    return np.where(apart, APART, np.where(known.all(axis=1), relations_of_gaps(gap.max(axis=1)), UNDECIDED)).astype(
        np.int8
    )


def _projects_exactly(shapes: Shapes, model: Model) -> NDArray[np.bool_]:
    """Return an (N, k) mask, True where no rounding occurs when all corners of shape i are projected on direction k."""
    x, y, start = shapes.rings
    found = np.empty((len(shapes), len(model.directions)), bool)
    for k, (nx, ny) in enumerate(model.directions):
        errors = Errors(FLOAT64, len(x))
        rounding.landing(errors, (np.full_like(x, nx), np.full_like(y, ny)), (x, y))
        found[:, k] = np.logical_and.reduceat(errors.exact, start[shapes.starts[:-1]])
    return found


def _classify_polygons(p: CornerColumns, q: CornerColumns, form: FloatFormat) -> Relations:
    """Return the relations SAT certainly finds for polygons in this format, else UNDECIDED.

    The error bound is larger than that of `certified_bounds`, since the numbers here are computed in floats too.
    """
    most = np.maximum(max_coordinates(p), max_coordinates(q))
    wide = np.maximum(
        *(np.maximum(c.max(0), d.max(0)) - np.minimum(c.min(0), d.min(0)) for c, d in ((p.x, q.x), (p.y, q.y)))
    )
    moved = np.zeros_like(most)
    if form is not FLOAT64:
        held = np.logical_and(*(_rows_fit_format(form, _number_rows(g)) for g in (p, q)))
        moved = np.where(held, 0.0, most * 2.0**-form.bits)
    good = (most > form.least) & (most < form.most)
    apart, over = np.zeros(len(most), bool), good.copy()
    for own, other in (p, q), (q, p):
        for clearance, span in edge_clearances(own, other):
            error_bound = 32.001 * 2.0**-form.bits * (span + 2 * moved) * (most + moved) + 4.001 * moved * (
                span + wide + 2 * moved
            )
            error_bound += 32 * UNIT_ROUNDOFF * span * most
            known = span > form.least * 1.001
            apart |= known & (clearance > error_bound)
            over &= known & (clearance < -error_bound)
    return np.where(good & apart, APART, np.where(over, OVERLAPPING, UNDECIDED)).astype(np.int8)


def _classify_circle_polygons(circle: CornerColumns, ring: CornerColumns, form: FloatFormat) -> Relations:
    """Return the relations SAT certainly finds for circles and convex polygons in this format, else UNDECIDED."""
    assert circle.r is not None
    far = np.maximum(*(np.abs(c - d).max(axis=0) for c, d in ((ring.x, circle.x), (ring.y, circle.y))))
    rows = _number_rows(ring), _number_rows(circle)
    most = np.maximum(far, np.maximum(*(np.abs(numbers).max(axis=1) for numbers in rows)))
    moved = np.where(_rows_fit_format(form, rows[0]) & _rows_fit_format(form, rows[1]), 0.0, most * 2.0**-form.bits)
    good = most < form.most
    unit = (2.0**-form.bits + UNIT_ROUNDOFF) * 1.001  # roundings of the model, and of float64 here
    inside, outside = good.copy(), np.zeros(len(far), bool)
    nearest = np.full(len(far), np.inf)
    for dx, dy, orientation, distance in edge_distances(circle, ring):
        good &= np.maximum(np.abs(dx), np.abs(dy)) > (form.least + 2 * moved) * 1.001
        long = np.abs(dx) + np.abs(dy)
        size = TURN_ROUNDINGS * unit * (far + 2 * moved) * (long + 4 * moved)
        size += 1.001 * moved * (2 * long + 4 * far + 8 * moved)
        inside &= orientation > size
        outside |= orientation < -size
        np.minimum(nearest, distance, out=nearest)
    square = circle.r * circle.r
    error_bound = unit * (DISTANCE_ROUNDINGS * (far + 2 * moved) ** 2 + 8 * square) + 9.001 * moved * (far + moved)
    max_coordinate = np.maximum.reduce([np.abs(c).max(axis=0) for c in (ring.x, ring.y, circle.x, circle.y)])
    range_error = RANGE_ROUNDINGS * unit * (max_coordinate + circle.r)
    # the radius widened and narrowed by the error of ranges
    rim, depth = circle.r + range_error, np.maximum(circle.r - range_error, 0)
    deep = inside & ((depth > 0) | (nearest > (range_error - circle.r) ** 2 * SQUARE_ERROR + error_bound))
    over = good & (deep | ((depth > 0) & (nearest < np.minimum(square, depth * depth / SQUARE_ERROR) - error_bound)))
    apart = good & outside & (nearest > np.maximum(square, rim * rim * SQUARE_ERROR) + error_bound)
    return np.where(over, OVERLAPPING, np.where(apart, APART, UNDECIDED)).astype(np.int8)
