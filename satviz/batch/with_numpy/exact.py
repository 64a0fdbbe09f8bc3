"""The exact relations of the pairs that the float filter leaves undecided."""

from typing import NamedTuple

import numpy as np

from ...engine.relate import ERROR_FACTOR_F64, MAX_ERROR_BOUND, MIN_ERROR_BOUND
from .. import exact_signs
from ..array_types import Array, Indices, Relations
from ..arrays import CornerColumns, upright_box_mask
from ..codes import APART, OVERLAPPING, TOUCHING
from ..exact_signs import take_columns
from . import circle_polygons
from .filter import boxes

BLOCK_CORNERS = 1 << 16  # corners of a shape at a time, over all pairs: what bounds the memory, and stays in the cache
MAX_VALUES_AT_ONCE = 1 << 16  # edges times corners, over all pairs, up to which all edges are evaluated at once
BLOCK_SIGNS = 1 << 15  # exact signs computed at a time: each takes some hundred bytes a term
RELATION_OF_SIGN = np.array([TOUCHING, APART, OVERLAPPING], np.int8)  # indexed by a sign: 0, 1, -1


def relations(a: CornerColumns, ia: Indices, b: CornerColumns, ib: Indices) -> Relations:
    """Return the exact relations of column ia[k] of group a with column ib[k] of group b."""
    found = np.empty(len(ia), np.int8)
    corners = max(len(a.x), len(b.x))
    settle, size = _relate_polygons, exact_signs.pairs_per_block(corners, BLOCK_CORNERS)
    if a.r is not None or b.r is not None:
        settle, size = _relate_circles, min(BLOCK_SIGNS, exact_signs.pairs_per_block(corners))
    with np.errstate(all="ignore"):
        for start in range(0, len(found), size):
            part = slice(start, start + size)
            found[part] = settle(a.columns(ia[part]), b.columns(ib[part]))
    return found


def _relate_circles(a: CornerColumns, b: CornerColumns) -> Relations:
    """Return the exact relation of each column of a with that of b, where a or b or both are circles."""
    if a.r is not None and b.r is not None:
        return RELATION_OF_SIGN[exact_signs.circle_gap_signs(a.x[0], a.y[0], a.r, b.x[0], b.y[0], b.r)]
    (circle, polygon), radii = ((a, b), a.r) if a.r is not None else ((b, a), b.r)
    assert radii is not None
    return RELATION_OF_SIGN[circle_polygons.gap_signs(circle.x[0], circle.y[0], radii, polygon.x, polygon.y)]


def _relate_polygons(a: CornerColumns, b: CornerColumns) -> Relations:
    """Return the exact relation of each column of a with that of b: upright boxes by sides, other polygons by edges."""
    upright = np.zeros(a.x.shape[1], bool)
    if len(a.x) == len(b.x) == 4:
        upright = upright_box_mask(a.x, a.y) & upright_box_mask(b.x, b.y)
    if not upright.any():
        return relate_edges(Edges(a.x, a.y, len(a.x)), Edges(b.x, b.y, len(b.x)))
    found = np.empty(len(upright), np.int8)
    for which, settle in ((upright, _relate_boxes), (~upright, _relate_polygons)):
        found[which] = settle(a.columns(which), b.columns(which))
    return found


def _relate_boxes(a: CornerColumns, b: CornerColumns) -> Relations:
    """Return the exact relation of each column of a with that of b, all of them upright boxes."""
    found = np.empty(a.x.shape[1], np.int8)
    boxes(a, b, 0, found)
    return found


class Edges(NamedTuple):
    """Hold outlines in columns and how many of their edges count; further rows repeat corners.

    An edge leads from one row to the next; the last edge leads back to the first row if all rows count.
    """

    x: Array
    y: Array
    edge_count: int


def relate_edges(a: Edges, b: Edges) -> Relations:
    """Return the exact relations of polygons by their edges, column by column.

    All edges at once for few pairs; for many, those edges first that are likeliest to clear the other polygon.
    """
    found = np.full(a.x.shape[1], OVERLAPPING, np.int8)
    factor = (_max_coordinates(a.x, a.y) + _max_coordinates(b.x, b.y)) * ERROR_FACTOR_F64
    most = max(a.edge_count, b.edge_count)
    left = np.arange(len(found))
    if len(found) * most * most <= MAX_VALUES_AT_ONCE:
        for own, other in ((a, b), (b, a)):
            edges, columns = np.tile(np.arange(own.edge_count), len(found)), np.repeat(left, own.edge_count)
            tells = _classify_edges(own, other, edges, columns, factor[columns])
            np.minimum(found, tells.reshape(len(found), own.edge_count).min(axis=1), out=found)
        return found
    nearest = _facing_corner(a, b), _facing_corner(b, a)
    for step in range(most):
        # outwards from the two edges at the corner furthest towards the other shape: -1, 0, -2, 1, -3, ...
        away = step // 2 if step % 2 else -1 - step // 2
        for (own, other), corner in zip(((a, b), (b, a)), nearest, strict=True):
            if step < own.edge_count and left.size:
                tells = _classify_edges(own, other, (corner[left] + away) % own.edge_count, left, factor[left])
                found[left] = tells
                left = left[tells == OVERLAPPING]
    return found


def _facing_corner(own: Edges, other: Edges) -> Indices:
    """Return for each column the row of a corner of `own` furthest towards `other`, by floats; any would be correct."""
    dx, dy = (s[0] + s[len(s) // 2] - o[0] - o[len(o) // 2] for s, o in ((other.x, own.x), (other.y, own.y)))
    value = dx * own.x
    value += dy * own.y
    found: Indices = value.argmax(axis=0)
    return found


def _classify_edges(own: Edges, other: Edges, edges: Indices, columns: Indices, factor: Array) -> Relations:
    """Return the (k,) relations that one edge of `own` proves in each column: edges[i] in columns[i].

    APART where all corners of `other` lie beyond the edge.  Where some lie on its line and none before, the shapes can
    meet only on that line: TOUCHING if their ranges on the line meet, else APART.  OVERLAPPING where a corner lies
    before it, which is no proof while other edges remain.  `factor`: (k,) the sum of the largest absolute coordinates
    of both shapes, times ERROR_FACTOR_F64.
    """
    end = (edges + 1) % len(own.x)
    ex, ey, fx, fy = own.x[edges, columns], own.y[edges, columns], own.x[end, columns], own.y[end, columns]
    nx, ny = fy - ey, ex - fx
    error_bound = np.maximum(np.abs(nx), np.abs(ny)) * factor
    error_bound[~((error_bound > MIN_ERROR_BOUND) & (error_bound < MAX_ERROR_BOUND))] = np.inf
    px, py = take_columns(other.x, columns), take_columns(other.y, columns)
    values = nx * px
    values += ny * py
    values -= nx * ex + ny * ey
    least = values.min(axis=0)
    tells = np.where(least > error_bound, np.int8(APART), np.int8(OVERLAPPING))
    doubtful = ~(np.abs(least) > error_bound)
    if doubtful.any():
        corner, which = np.nonzero(~(values > error_bound) & doubtful)
        found = _classify_on_line(ex, ey, fx, fy, px[corner, which], py[corner, which], which)
        np.copyto(tells, found, where=doubtful)
    return tells


def _classify_on_line(ex: Array, ey: Array, fx: Array, fy: Array, px: Array, py: Array, which: Indices) -> Relations:
    """Return the (n,) relations that edges e-f prove, by the exact orientation of some corners of the other polygon.

    ex, ey, fx, fy: (n,) ends of the edges; px, py: (k,) all corners that are not certainly beyond the edge's line;
    which: (k,) the edge of each of these corners.
    """
    side = np.empty(len(which), np.int8)
    for start in range(0, len(which), BLOCK_SIGNS):
        part = slice(start, start + BLOCK_SIGNS)
        w = which[part]
        # the orientation from the edge's end over its start: what lies beyond is to the left
        side[part] = exact_signs.orient(fx[w], fy[w], ex[w], ey[w], px[part], py[part])
    least = np.ones(len(ex), np.int8)
    np.minimum.at(least, which, side)
    # along the line by x, or by y where it stands upright: no two corners are alike in both
    upright = ex == fx
    e, f = np.where(upright, ey, ex), np.where(upright, fy, fx)
    on = side == 0
    which, along = which[on], np.where(upright[which], py, px)[on]
    low, high = np.full(len(e), np.inf), np.full(len(e), -np.inf)
    np.minimum.at(low, which, along)
    np.maximum.at(high, which, along)
    meet = (low <= np.maximum(e, f)) & (high >= np.minimum(e, f))
    return np.where(least < 0, OVERLAPPING, np.where((least == 0) & meet, TOUCHING, APART)).astype(np.int8)


def _max_coordinates(x: Array, y: Array) -> Array:
    """Return the largest absolute coordinate of each column."""
    most, least = np.maximum(x.max(axis=0), y.max(axis=0)), np.minimum(x.min(axis=0), y.min(axis=0))
    largest: Array = np.maximum(most, -least)
    return largest
