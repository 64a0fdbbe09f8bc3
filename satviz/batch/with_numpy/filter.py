"""The float filter for arrays of pairs, in NumPy: what it cannot decide stays UNDECIDED.

Polygons are evaluated in float32 first, which moves half the bytes.  The error bounds of float64
are those of the scalar engine (satviz.engine.relate); all hold for any order of operations.
Every kernel takes one column per pair and fills out[k] with the relation of column first + k.
The clearance of an edge is its distance from the other shape times its length: positive if it clears it.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ...engine.predicates import MAX_SAFE_PRODUCT, MIN_SAFE_PRODUCT
from ..array_types import Array, Relations
from ..arrays import TILE_SHAPES, CornerColumns
from ..codes import OVERLAPPING, TOUCHING, UNDECIDED
from . import gjk

Array32 = NDArray[np.float32]

BLOCK_PAIRS = 16384  # pairs at a time: their columns and the scratch arrays stay in the second-level cache

# The float32 filter.  Coordinates from the first corner of A, at most m, are each off by
# u m, u = 2^-24; an edge's parts by 3 u m, its products with a corner by 20 u m^2 in
# all, and with the edge's own start as much: with the last subtractions below 64 u m^2.
ERROR_FACTOR_F32 = np.float32(2.0**-18)
MIN_SIZE_F32, MAX_SIZE_F32 = np.float32(2.0**-40), np.float32(2.0**50)  # m where float32 products keep their bits

MAX_AT_ONCE = 1 << 13  # corners of circles' partners up to which all edges are evaluated at once

MAX_F32_CORNERS = 16  # corners; above it float32 decides few pairs, and evaluating every vertex is slow


def polygons(a: CornerColumns, b: CornerColumns, first: int, out: Relations) -> None:
    """Fill out[k] with the relation of column first + k or UNDECIDED: by float32, or by GJK for many corners."""
    if max(len(a.x), len(b.x)) > MAX_F32_CORNERS:
        gjk.polygons(a, b, first, out)
        return
    ax, ay, bx, by = (c[:, first : first + out.size] for c in (a.x, a.y, b.x, b.y))
    width = _max_widths(a, first, out.size)
    width += _max_widths(b, first, out.size)
    classify_clearances(*evaluate_f32(ax, ay, bx, by, width), out)


def _max_widths(group: CornerColumns, first: int, n: int) -> Array:
    """Return (n,) upper bounds of the widths and heights of the shapes in columns from `first` on.

    A bound is the largest edge component in the column's tile, times half of the number of edges.
    """
    tiles = slice(first // TILE_SHAPES, (first + n - 1) // TILE_SHAPES + 1)
    widths: Array = np.repeat(group.tile_maxima.edge[tiles] * (len(group.x) // 2), TILE_SHAPES)
    return widths[first % TILE_SHAPES :][:n]


def evaluate_f32(
    ax: Array, ay: Array, bx: Array, by: Array, width: float | Array, again: int = 0
) -> tuple[Array32, Array32]:
    """Return (largest float32 clearance, its error bound) of each pair, with A's first corner as the origin.

    width: (n,) upper bound of the sum of both shapes' widths, and of their heights.  `again`: how many rows at the end
    repeat corners, so that no edge leads from the last row to the first.
    """
    x, y, px, py = (_to_f32(c, origin) for c, origin in zip((ax, ay, bx, by), (ax[0], ay[0]) * 2, strict=True))
    size = np.maximum(np.abs(px[0]), np.abs(py[0]))
    size += np.asarray(width, np.float32)
    error_bound = size * size
    error_bound *= ERROR_FACTOR_F32
    error_bound[~((size > MIN_SIZE_F32) & (size < MAX_SIZE_F32))] = np.inf
    return clearance(x, y, px, py, 1, again), error_bound


def _to_f32(c: Array, origin: Array) -> Array32:
    """Return the (V, n) coordinates relative to each column's origin, (n,), in float32."""
    return np.subtract(c, origin).astype(np.float32)


def clearance(ax: Array32, ay: Array32, bx: Array32, by: Array32, known: int, again: int = 0) -> Array32:
    """Return the (n,) largest clearances of an edge of each pair: its distance from the other shape, times its length.

    `known`: 1 where A's first corner is the origin, which saves its products.  `again`: as in `evaluate_f32`.
    """
    best = np.full(ax.shape[1], -np.inf, ax.dtype)
    scratch = np.empty((5, ax.shape[1]), ax.dtype)
    own, other = len(ax) - again, len(bx) - again
    _raise_clearance(ax, ay, bx[:other], by[:other], own, known, 0, best, *scratch)
    _raise_clearance(bx, by, ax[:own], ay[:own], other, 0, known, best, *scratch)
    return best


def _raise_clearance(
    x: Array32, y: Array32, p: Array32, q: Array32, edges: int, own_zeros: int, other_zeros: int, best: Array32,
    nx: Array32, ny: Array32, least: Array32, value: Array32, part: Array32,
) -> None:  # fmt: skip
    """Raise `best` in place, column by column, to the largest clearance of the first `edges` edges of x, y.

    The clearance of an edge is the least value of n . (v - its start) over the corners v of p, q; n is its outward
    normal, not normalised.  nx, ny, least, value and part are scratch.

    `own_zeros`, `other_zeros`: how many corners at the beginning of x, y and of p, q are the origin.
    """
    for e in range(edges):
        f = (e + 1) % len(x)
        np.subtract(y[f], y[e], out=nx)
        np.subtract(x[e], x[f], out=ny)
        least.fill(0.0 if other_zeros else np.inf)
        for v in range(other_zeros, len(p)):
            np.multiply(nx, p[v], out=value)
            np.multiply(ny, q[v], out=part)
            value += part
            np.minimum(least, value, out=least)
        if e >= own_zeros and f >= own_zeros:
            nx *= x[e]
            ny *= y[e]
            least -= nx
            least -= ny
        np.maximum(best, least, out=best)


def classify_clearances(gap: Array32 | Array, error_bound: Array32 | Array, out: Relations) -> None:
    """Fill `out`: APART above the error bound, OVERLAPPING below its negative, else UNDECIDED."""
    np.multiply((gap < -error_bound).view(np.int8), OVERLAPPING - UNDECIDED, out=out)
    out += (gap > error_bound).view(np.int8)  # by APART - UNDECIDED, which is 1
    out += UNDECIDED


def boxes(a: CornerColumns, b: CornerColumns, first: int, out: Relations) -> None:
    """Fill out[k] with the exact relation of the upright boxes in column first + k of A and B, by comparing sides."""
    corners = ([c[k, first : first + out.size] for k in (0, 2) for c in (s.x, s.y)] for s in (a, b))
    gap = box_gap(*([*map(np.minimum, c[:2], c[2:]), *map(np.maximum, c[:2], c[2:])] for c in corners))
    np.subtract((gap < 0).view(np.int8), (gap > 0).view(np.int8), out=out)
    out += TOUCHING


def box_gap(a: Array | Sequence[Array], b: Array | Sequence[Array]) -> Array:
    """Return for each pair of boxes the larger of the gaps along x and y; a, b: rows x min, y min, x max, y max."""
    gap: Array = a[0] - b[2]
    for low, high in ((b[0], a[2]), (a[1], b[3]), (b[1], a[3])):
        np.maximum(gap, low - high, out=gap)
    return gap


def circles(ax: Array, ay: Array, ar: Array, bx: Array, by: Array, br: Array, first: int, out: Relations) -> None:
    """Fill out[k] with the relation of circles first + k of A and B, by squared distance and radii, or UNDECIDED."""
    ax, ay, ar, bx, by, br = (c[first : first + out.size] for c in (ax, ay, ar, bx, by, br))
    dx, dy, radius_sum = ax - bx, ay - by, ar + br
    distance = dx * dx + dy * dy
    radius_sum *= radius_sum
    error_bound = distance + radius_sum
    certified = (error_bound > MIN_SAFE_PRODUCT) & (error_bound < MAX_SAFE_PRODUCT)
    error_bound *= 2.0**-50
    error_bound[~certified] = np.inf
    classify_clearances(distance - radius_sum, error_bound, out)


def circle_polygons(cx: Array, cy: Array, cr: Array, px: Array, py: Array, first: int, out: Relations) -> None:
    """Fill out[k] with the relation of circle first + k and polygon column first + k, by squared distance to boundary.

    UNDECIDED within its error bound.
    """
    cx, cy, cr, px, py = (c[..., first : first + out.size] for c in (cx, cy, cr, px, py))
    closed = np.empty((2, len(px) + 1, out.size))
    closed[0, :-1], closed[1, :-1], closed[:, -1] = px, py, (px[0], py[0])
    classify_clearances(*circle_polygon_gaps(cx, cy, cr, closed), out)


def circle_polygon_gaps(cx: Array, cy: Array, cr: Array, closed: Array) -> tuple[Array, Array]:
    """Return (squared distance from center to boundary minus squared radius, its error bound) for each column.

    The gap is -inf for a center certainly inside.  closed: (2, V + 1, n) corners of polygons, the first one again at
    the end.  Few columns are evaluated for all edges at once, since calls take longer than the work.
    """
    x, y = closed[0] - cx, closed[1] - cy
    far = np.maximum(np.maximum(np.abs(x).max(axis=0), np.abs(y).max(axis=0)), cr)
    error_bound = far * far * 2.0**-46
    safe = (error_bound > MIN_SAFE_PRODUCT) & (error_bound < MAX_SAFE_PRODUCT * 2.0**-46)
    inside, nearest = np.ones(len(cx), bool), np.full(len(cx), np.inf)
    edges = len(x) - 1
    rows = edges if x.size <= MAX_AT_ONCE else 1
    for start in range(0, edges, rows):
        one, other = slice(start, start + rows), slice(start + 1, start + rows + 1)
        dx, dy = closed[0, other] - closed[0, one], closed[1, other] - closed[1, one]
        orientation = x[one] * dy - y[one] * dx
        tolerance = (np.abs(dx) + np.abs(dy)) * (far * 2.0**-48)
        inside &= (orientation > tolerance).all(axis=0)
        along, square = -(x[one] * dx + y[one] * dy), dx * dx + dy * dy
        safe &= (square > MIN_SAFE_PRODUCT).all(axis=0)
        distance = np.where(
            along <= 0,
            x[one] * x[one] + y[one] * y[one],
            np.where(along >= square, x[other] * x[other] + y[other] * y[other], orientation / square * orientation),
        )
        np.minimum(nearest, distance.min(axis=0), out=nearest)  # edges that face away are included: none is nearer
    nearest -= cr * cr
    # a center inside, taken for one on an edge's line, has the boundary within twice the tolerance
    nearest[inside] = -np.inf
    error_bound[~safe] = np.inf
    return nearest, error_bound
