"""Outlines of many corners, in NumPy: an axis or a shared point found in a few steps, else left UNDECIDED."""

import numpy as np

from ...engine.predicates import MIN_SAFE_PRODUCT
from ...engine.relate import ERROR_FACTOR_F64, MAX_ERROR_BOUND, MIN_ERROR_BOUND
from ..array_types import Array, Relations
from ..arrays import TILE_SHAPES, CornerColumns
from ..codes import APART, OVERLAPPING, UNDECIDED
from ..exact_signs import ERRBOUND_A, take_columns

MAX_STEPS = 12  # steps of GJK before it gives up
BLOCK_CORNERS = 1 << 16  # corners: they and the scratch arrays stay in the second-level cache


def polygons(a: CornerColumns, b: CornerColumns, first: int, out: Relations) -> None:
    """Fill out[k] for column first + k: APART or OVERLAPPING where a few steps of GJK prove it, else UNDECIDED.

    The differences of B's corners and A's span a polygon about the origin if the shapes overlap: its lowest
    corner along an axis above zero proves a gap, a triangle of its corners about the origin a shared
    point (Gilbert, Johnson and Keerthi 1988).
    """
    size = max(1, BLOCK_CORNERS // (len(a.x) + len(b.x)))
    for start in range(0, out.size, size):
        part = slice(first + start, first + min(start + size, out.size))
        factor = (a.tile_maxima.coordinate + b.tile_maxima.coordinate)[np.arange(part.start, part.stop) // TILE_SHAPES]
        factor *= ERROR_FACTOR_F64
        gjk(a.x[:, part], a.y[:, part], b.x[:, part], b.y[:, part], factor, out[start : start + size])


def gjk(x: Array, y: Array, p: Array, q: Array, factor: Array, out: Relations) -> None:
    """Run GJK on the difference B - A of each column; fill `out` with certified relations, else UNDECIDED.

    (x, y): (V, N) corners of A; (p, q): (W, N) corners of B; out: (N,) APART or OVERLAPPING where certified; factor:
    (N,) the sum of both shapes' largest absolute coordinates, times ERROR_FACTOR_F64.
    """
    out.fill(UNDECIDED)
    left = np.arange(out.size)
    d = _mid_point(p, q) - _mid_point(x, y)
    u = v = np.zeros_like(d)
    for step in range(MAX_STEPS):
        w = _lowest_corner(p, q, d) - _lowest_corner(x, y, -d)
        at = d[0] * w[0] + d[1] * w[1]
        error_bound = np.abs(d).sum(axis=0) * factor
        error_bound[~((error_bound > MIN_ERROR_BOUND) & (error_bound < MAX_ERROR_BOUND))] = np.inf
        out[left[at > error_bound]] = APART
        go = at < -error_bound
        if step == 0:
            u, d = w, w
        else:
            if step == 1:
                v = w
            else:
                one, other = _certified_cross(v, w), _certified_cross(w, u)
                out[left[go & (one > 0) & (other > 0)]] = OVERLAPPING
                go &= (one < 0) | (other < 0)
                u, v = np.where(one < 0, w, u), np.where((one >= 0) & (other < 0), w, v)
            side = _certified_cross(u, v)
            go &= side != 0
            u, v = np.where(side < 0, v, u), np.where(side < 0, u, v)
            # the origin lies left of the line from u to v: search next for the lowest corner along its left normal
            d = np.stack([v[1] - u[1], u[0] - v[0]])
        which = np.flatnonzero(go)
        if not which.size:
            return
        left, factor = left[which], factor[which]
        d, u, v, x, y, p, q = (take_columns(c, which) for c in (d, u, v, x, y, p, q))


def _mid_point(x: Array, y: Array) -> Array:
    """Return the (2, n) midpoints of the first corner and the one at half the number of each outline."""
    return np.stack([c[0] / 2 + c[len(c) // 2] / 2 for c in (x, y)])


def _lowest_corner(x: Array, y: Array, d: Array) -> Array:
    """Return (2, n) coordinates of each column's corner with the least d[0]*x + d[1]*y, by floats."""
    value = d[0] * x
    value += d[1] * y
    corner, column = value.argmin(axis=0), np.arange(x.shape[1])
    return np.stack([x[corner, column], y[corner, column]])


def _certified_cross(u: Array, v: Array) -> Array:
    """Return the (n,) cross products of (2, n) vectors u and v, or 0 where rounding may hide the sign."""
    left, right = u[0] * v[1], u[1] * v[0]
    size = np.abs(left) + np.abs(right)
    cross: Array = left - right
    cross[~((np.abs(cross) > ERRBOUND_A * size) & (size > MIN_SAFE_PRODUCT))] = 0.0
    return cross
