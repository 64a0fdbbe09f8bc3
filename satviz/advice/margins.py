"""The relative margin of many pairs with NumPy (`relative_margin.py` defines it, and computes it for one pair).

Three stages: plain floats; floats with the error of each operation where the margin is small; fractions for the rest.
A *measure* below returns the gap of each pair of columns: for polygons the clearance that decides over its span.
"""

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import batch
from ..batch.arrays import CornerColumns
from ..batch.codes import TOUCHING
from ..batch.exact_signs import sum_with_error, two_sum
from ..engine.predicates import UNIT_ROUNDOFF
from .limits import refuse_too_many_fractions
from .pairs import Array, PartPairs, pair_columns
from .relative_margin import signed_relative_margin

# |error| < 17 u D M of an orientation (D the span, M max_coordinate), < 40 u M of a distance: 40 / 2**11 is one part
# in fifty.
MIN_ROUGH_MARGIN = 2.0**11
MIN_ERROR_BOUNDS = 100.0  # gap / error bound: the margin is then good to one part in a hundred
MIN_LENGTH = 2.0**-900  # in units of max_coordinate: products of shorter lengths lose bits

Measure = Callable[[CornerColumns, CornerColumns], Array]


def max_coordinates(group: CornerColumns) -> Array:
    """Return the largest absolute coordinate of each column, plus the radius of circles."""
    most: Array = np.maximum(np.abs(group.x).max(axis=0), np.abs(group.y).max(axis=0))
    return most if group.r is None else most + group.r


def signed_relative_margins(pairs: PartPairs, *, engine: str | None = None) -> Array:
    """Return the (n,) relative margins, negative for overlapping pairs and 0 only for touching ones.

    They are right to one part in fifty.  `engine` as in `batch.relate`.
    """
    a, b, pa, pb = pairs.a.parts, pairs.b.parts, pairs.pa, pairs.pb
    margins = np.empty(len(pa))
    for mine, p, q in pair_columns(a, pa, b, pb):
        margins[mine] = _margins_of_columns(p, q, _polygon_gap, _circle_gap)
    near = np.flatnonzero(~(np.abs(margins) >= MIN_ROUGH_MARGIN))
    relation = batch.relate(a, b, np.stack([pa[near], pb[near]], axis=1), engine=engine)
    margins[near] = np.where(relation == TOUCHING, 0.0, np.nan)
    near = near[relation != TOUCHING]
    for mine, p, q in pair_columns(a, pa[near], b, pb[near]):
        if (p.r is None) == (q.r is None):
            margins[near[mine]] = _margins_of_columns(p, q, _polygon_gap_by_errors, _circle_gap_by_errors)
    rest = np.flatnonzero(np.isnan(margins))
    refuse_too_many_fractions(len(rest), len(rest))
    for i in rest.tolist():
        margins[i] = signed_relative_margin(*pairs.part_shapes(i))
    found = np.full(len(pairs.ia), np.inf)
    np.minimum.at(found, pairs.of, margins)
    return found


def edge_clearances(own: CornerColumns, other: CornerColumns) -> Iterator[tuple[Array, Array]]:
    """Yield for each edge of `own` (least orientation determinant of the other's corners, larger edge component).

    Both are (n,) arrays, one value for each pair of columns.  The first is positive where all corners lie beyond.
    """
    for e in range(len(own.x)):
        x, y = own.x[e - 1], own.y[e - 1]
        nx, ny = own.y[e] - y, x - own.x[e]
        yield (nx * (other.x - x) + ny * (other.y - y)).min(axis=0), np.maximum(np.abs(nx), np.abs(ny))


def edge_distances(circle: CornerColumns, ring: CornerColumns) -> Iterator[tuple[NDArray[Any], ...]]:
    """Yield (dx, dy, orientation, squared distance from the center) for each edge, in the float format of `ring`.

    Each is an (n,) array.  (dx, dy) is the edge; the orientation determinant is positive where the center is on its
    inner side.
    """
    x, y = ring.x - circle.x, ring.y - circle.y
    for e in range(len(x)):
        dx, dy = ring.x[e] - ring.x[e - 1], ring.y[e] - ring.y[e - 1]
        orientation = x[e - 1] * dy - y[e - 1] * dx
        along, square = -(x[e - 1] * dx + y[e - 1] * dy), dx * dx + dy * dy
        ends = np.where(along <= 0, x[e - 1] ** 2 + y[e - 1] ** 2, x[e] ** 2 + y[e] ** 2)
        yield dx, dy, orientation, np.where((along > 0) & (along < square), orientation / square * orientation, ends)


def _margins_of_columns(a: CornerColumns, b: CornerColumns, polygon_gap: Measure, circle_gap: Measure) -> Array:
    """Return the (n,) signed relative margins of columns k of `a` with columns k of `b`.

    `polygon_gap`: the measure of two polygons; `circle_gap`: that of two circles.
    """
    with np.errstate(all="ignore"):
        # scale all numbers below 1/2: then no difference of coordinates and no center plus radius overflows
        power = -1 - np.frexp(np.maximum(*(max_coordinates(CornerColumns(g.block / 2)) for g in (a, b))))[1]
        a, b = (_scaled(g, power) for g in (a, b))
        unit = UNIT_ROUNDOFF * np.maximum(max_coordinates(a), max_coordinates(b))
        if a.r is not None and b.r is not None:
            gap = circle_gap(a, b)
        elif a.r is not None or b.r is not None:
            gap = _circle_polygon_gap(a, b) if a.r is not None else _circle_polygon_gap(b, a)
        else:
            gap = polygon_gap(a, b)
        return np.asarray(gap / unit)


def _scaled(g: CornerColumns, power: NDArray[np.intp]) -> CornerColumns:
    """Return the group with each shape multiplied by its 2**power."""
    return CornerColumns(np.ldexp(g.block, power))


def _polygon_gap(a: CornerColumns, b: CornerColumns) -> Array:
    """Return for each pair of polygons the largest clearance / span of any edge of either."""
    return np.maximum(_largest_relative_clearance(a, b), _largest_relative_clearance(b, a))


def _largest_relative_clearance(own: CornerColumns, other: CornerColumns) -> Array:
    """Return for each pair max(clearance / span) over the edges of `own`; `edge_clearances` yields both numbers.

    The span of an edge is its larger component.  NaN if a span is below MIN_LENGTH.
    """
    best = np.full(own.x.shape[1], -np.inf)
    for clearance, span in edge_clearances(own, other):
        span[span < MIN_LENGTH] = np.nan
        np.maximum(best, clearance / span, out=best)
    return best


def _circle_gap(a: CornerColumns, b: CornerColumns) -> Array:
    """Return for each pair of circles the distance of the centers less both radii, in plain floats."""
    assert a.r is not None and b.r is not None
    gap: Array = np.hypot(a.x[0] - b.x[0], a.y[0] - b.y[0]) - (a.r + b.r)
    return gap


def _polygon_gap_by_errors(a: CornerColumns, b: CornerColumns) -> Array:
    """Return what `_polygon_gap` does where right to one part in a hundred, else NaN; by floats with their errors."""
    best, error_bound = np.full(a.x.shape[1], -np.inf), np.zeros(a.x.shape[1])
    for own, other in (a, b), (b, a):
        shape = other.x.shape
        for e in range(len(own.x)):
            x, y = own.x[e - 1], own.y[e - 1]
            sides = two_sum(own.y[e], -y), two_sum(x, -own.x[e]), two_sum(other.x, -x), two_sum(other.y, -y)
            (nx, enx), (ny, eny), (dx, edx), (dy, edy) = ([np.broadcast_to(c, shape).ravel() for c in s] for s in sides)
            orientation, off, _ = sum_with_error([(nx, dx), (ny, dy)], (nx * edx + enx * dx) + (ny * edy + eny * dy))
            span = np.maximum(np.abs(nx), np.abs(ny))[: shape[1]]
            span[span < MIN_LENGTH] = np.nan
            np.maximum(best, orientation.reshape(shape).min(axis=0) / span, out=best)
            np.maximum(error_bound, off.reshape(shape).max(axis=0) / span, out=error_bound)
    return np.where(np.abs(best) > np.maximum(MIN_ERROR_BOUNDS * error_bound, MIN_LENGTH), best, np.nan)


def _circle_gap_by_errors(a: CornerColumns, b: CornerColumns) -> Array:
    """Return what `_circle_gap` does where right to one part in a hundred, else NaN; by a difference of squares."""
    assert a.r is not None and b.r is not None
    (dx, ex), (dy, ey), (r, er) = two_sum(a.x[0], -b.x[0]), two_sum(a.y[0], -b.y[0]), two_sum(a.r, b.r)
    square, off, _ = sum_with_error([(dx, dx), (dy, dy), (-r, r)], 2 * ((dx * ex + dy * ey) - r * er))
    gap = square / (np.hypot(dx, dy) + r)
    return np.where((np.abs(square) > MIN_ERROR_BOUNDS * off) & (np.abs(gap) > MIN_LENGTH), gap, np.nan)


def _circle_polygon_gap(circle: CornerColumns, ring: CornerColumns) -> Array:
    """Return the distance (inside: minus the depth) of each center from its polygon, less the radius.

    NaN where rounding may decide whether the center is inside.
    """
    assert circle.r is not None
    x, y = ring.x - circle.x, ring.y - circle.y
    inner, outer = np.full((2, x.shape[1]), np.inf)
    for e in range(len(x)):
        px, py, qx, qy = x[e - 1], y[e - 1], x[e], y[e]
        dx, dy = ring.x[e] - ring.x[e - 1], ring.y[e] - ring.y[e - 1]
        length = np.hypot(dx, dy)
        length[length < MIN_LENGTH] = np.nan
        side = (px * dy - py * dx) / length
        along = -(px * dx + py * dy) / length
        ends = np.where(along <= 0, np.hypot(px, py), np.hypot(qx, qy))
        foot = (along > 0) & (along < length)
        outer = np.minimum(outer, np.where(foot, np.abs(side), ends))
        inner = np.minimum(inner, side)
    gap: Array = np.where(inner > 0, -inner, outer) - circle.r
    gap[(inner > 0) & (inner < MIN_ROUGH_MARGIN * UNIT_ROUNDOFF)] = np.nan  # or outside, near the tip of a needle
    return gap
