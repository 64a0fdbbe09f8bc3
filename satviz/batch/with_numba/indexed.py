"""Pairs of convex polygons and circles given by indices, compiled with numba.

Names in the kernels: sa and sb say where the corners of each shape of A and B start, ra and rb hold their radii (0 for
polygons), box_a and box_b their bounding boxes; pair k is shape i = ia[k] of A and shape j = ib[k] of B.  A lane is a
column of the scratch arrays x, y (corners of A) and p, q (corners of B).
"""

import numpy as np

from ...engine.relate import ERROR_FACTOR_F64, MAX_ERROR_BOUND, MIN_ERROR_BOUND
from ..array_types import Array, Indices, Mask, Relations
from ..arrays import TILE_SHAPES, CornerColumns, Flat
from ..codes import OVERLAPPING, UNDECIDED
from ..ragged import MAX_LANE_CORNERS
from .exact import MAX_TERMS, is_certainly_inside, relate_few_corners, relate_many_corners
from .filter import (
    classify,
    raise_clearance_8,
    range_gap,
    relate_circle_polygon,
    relate_circles,
    relation_of_gap,
)
from .jit_cache import compiled, inlined

LANES = 128  # pairs whose corners stay in the first-level cache
LANE_STRIDE = LANES + 8  # a power of two would put all corners of a pair into the same few places of the cache


def relations(a: Flat, ia: Indices, b: Flat, ib: Indices, out: Relations) -> None:
    """Fill out[k] with the relation of a[ia[k]] and b[ib[k]].

    Polygons are decided exactly, but UNDECIDED where floats go out of range; pairs with a circle are UNDECIDED within
    the error bound.
    """
    fill_relations(
        *(a.x, a.y, a.start, a.radius, a.bounds, a.upright),
        *(b.x, b.y, b.start, b.radius, b.bounds, b.upright),
        *(np.ascontiguousarray(ia), np.ascontiguousarray(ib), out),
    )


def exact_columns(a: CornerColumns, b: CornerColumns, first: int, out: Relations) -> None:
    """Replace each UNDECIDED out[k] by the exact relation of column first + k, unless floats go out of range."""
    _exact_columns(a.x, a.y, b.x, b.y, first, a.tile_maxima.coordinate + b.tile_maxima.coordinate, out)


@compiled
def _exact_columns(
    ax: Array, ay: Array, bx: Array, by: Array, first: int, max_coordinates: Array, out: Relations
) -> None:
    """Replace each UNDECIDED out[k] by the exact relation of column first + k, unless floats go out of range.

    `max_coordinates`: for each tile of columns, the sum of the largest absolute coordinates of A and of B.
    """
    va, vb = ax.shape[0], bx.shape[0]
    x, y, p, q, terms = np.empty(va), np.empty(va), np.empty(vb), np.empty(vb), np.empty(MAX_TERMS)
    for k in range(out.size):
        if out[k] == UNDECIDED:
            for v in range(va):
                x[v], y[v] = ax[v, first + k], ay[v, first + k]
            for v in range(vb):
                p[v], q[v] = bx[v, first + k], by[v, first + k]
            max_coordinate = max_coordinates[(first + k) // TILE_SHAPES]
            out[k] = relate_few_corners(x, y, 0, va, p, q, 0, vb, max_coordinate, terms)


@compiled
def fill_relations(
    ax: Array, ay: Array, sa: Indices, ra: Array, box_a: Array, upright_a: Mask,
    bx: Array, by: Array, sb: Indices, rb: Array, box_b: Array, upright_b: Mask,
    ia: Indices, ib: Indices, out: Relations,
) -> None:  # fmt: skip
    """Fill out[k] with the relation of shape ia[k] of A and ib[k] of B: by boxes, then the float filter, then exactly.

    For A (and B): ax, ay: (M,) corners of all shapes, one shape after another; sa: (N + 1,) the first corner of each
    shape; ra: (N,) radii, 0 for polygons; box_a: (N, 4) bounding boxes; upright_a: (N,) mask of upright boxes.  Pairs
    stay UNDECIDED as `relations` says.
    """
    terms = np.empty(MAX_TERMS)
    waiting, many = np.empty(LANES, np.intp), 0  # pairs of up to eight corners
    for k in range(out.size):
        i, j = ia[k], ib[k]
        gap = max(
            range_gap(box_a[i, 0], box_a[i, 2], box_b[j, 0], box_b[j, 2]),
            range_gap(box_a[i, 1], box_a[i, 3], box_b[j, 1], box_b[j, 3]),
        )
        if gap > 0 or (upright_a[i] and upright_b[j]):
            out[k] = relation_of_gap(gap)
            continue
        if ra[i] > 0 or rb[j] > 0:
            if ra[i] > 0 and rb[j] > 0:
                out[k] = relate_circles(ax[sa[i]], ay[sa[i]], ra[i], bx[sb[j]], by[sb[j]], rb[j])
            elif ra[i] > 0:
                out[k] = relate_circle_polygon(ax[sa[i]], ay[sa[i]], ra[i], bx, by, sb[j], sb[j + 1])
            else:
                out[k] = relate_circle_polygon(bx[sb[j]], by[sb[j]], rb[j], ax, ay, sa[i], sa[i + 1])
            continue
        out[k] = UNDECIDED
        most = max(sa[i + 1] - sa[i], sb[j + 1] - sb[j])
        if most <= 4:
            one = _clearance_of_few(ax, ay, sa[i], sa[i + 1], bx, by, sb[j], sb[j + 1])
            other = _clearance_of_few(bx, by, sb[j], sb[j + 1], ax, ay, sa[i], sa[i + 1])
            out[k] = classify(max(one, other), _error_bound(box_a, i, box_b, j))
        elif most <= MAX_LANE_CORNERS:
            waiting[many] = k
            many += 1
            if many == LANES:
                _evaluate_lanes(ax, ay, sa, box_a, bx, by, sb, box_b, ia, ib, waiting, out)
                many = 0
    if many:
        _evaluate_lanes(ax, ay, sa, box_a, bx, by, sb, box_b, ia, ib, waiting[:many], out)
    for k in range(out.size):
        if out[k] == UNDECIDED and ra[ia[k]] == 0 and rb[ib[k]] == 0:
            i, j = ia[k], ib[k]
            i0, i1, j0, j1 = sa[i], sa[i + 1], sb[j], sb[j + 1]
            max_coordinate = _max_coordinate(box_a, i) + _max_coordinate(box_b, j)
            if max(i1 - i0, j1 - j0) <= MAX_LANE_CORNERS:
                out[k] = relate_few_corners(ax, ay, i0, i1, bx, by, j0, j1, max_coordinate, terms)
                continue
            # the middle of what both boxes share
            px = max(box_a[i, 0], box_b[j, 0]) / 2 + min(box_a[i, 2], box_b[j, 2]) / 2
            py = max(box_a[i, 1], box_b[j, 1]) / 2 + min(box_a[i, 3], box_b[j, 3]) / 2
            inside = is_certainly_inside(ax, ay, i0, i1, px, py, max_coordinate)
            if inside and is_certainly_inside(bx, by, j0, j1, px, py, max_coordinate):
                out[k] = OVERLAPPING
            else:
                out[k] = relate_many_corners(ax, ay, i0, i1, bx, by, j0, j1, max_coordinate, terms)


@compiled
def _max_coordinate(boxes: Array, i: int) -> float:
    """Return the largest absolute coordinate of box i."""
    max_coordinate: float = max(max(-boxes[i, 0], boxes[i, 2]), max(-boxes[i, 1], boxes[i, 3]))
    return max_coordinate


@compiled
def _max_width(box: Array, i: int) -> float:
    """Return an upper bound of the x and y components of the edges of the shape in box i: the box's longer side."""
    width: float = max(box[i, 2] - box[i, 0], box[i, 3] - box[i, 1])
    return width


@inlined
def _error_bound(box_a: Array, i: int, box_b: Array, j: int) -> float:
    """Return the float64 error bound of the clearances of two shapes, from boxes i and j; infinity out of its range."""
    width = _max_width(box_a, i) + _max_width(box_b, j)
    error_bound = width * (_max_coordinate(box_a, i) + _max_coordinate(box_b, j)) * ERROR_FACTOR_F64
    return error_bound if error_bound > MIN_ERROR_BOUND and error_bound < MAX_ERROR_BOUND else np.inf


@inlined
def _clearance_of_few(x: Array, y: Array, i0: int, i1: int, p: Array, q: Array, j0: int, j1: int) -> float:
    """Return the largest clearance of any edge of x, y (corners i0 to i1 - 1) over p, q (j0 to j1 - 1), 3 or 4 corners.

    A triangle starts again: its first edge and its first corner are evaluated twice.
    """
    i, j, k = np.uintp(i0), np.uintp(j0), np.uintp(j1 - 1)
    j2 = j + np.uintp(2)
    best = -np.inf
    for e in range(4):
        s = i + np.uintp(e if i0 + e < i1 else 0)
        t = i + np.uintp(e + 1 if i0 + e + 1 < i1 else i0 + e + 1 - i1)
        ex, ey = x[s], y[s]
        nx, ny = y[t] - ey, ex - x[t]
        low = min(nx * p[j] + ny * q[j], nx * p[j + np.uintp(1)] + ny * q[j + np.uintp(1)])
        low = min(low, min(nx * p[j2] + ny * q[j2], nx * p[k] + ny * q[k]))
        best = max(best, low - (nx * ex + ny * ey))
    return best


@compiled
def _evaluate_lanes(
    ax: Array, ay: Array, sa: Indices, box_a: Array, bx: Array, by: Array, sb: Indices, box_b: Array,
    ia: Indices, ib: Indices, which: Indices, out: Relations,
) -> None:  # fmt: skip
    """Fill out[k] by the float filter for each k in `which` (up to LANES), one pair in each lane.

    Other arguments as in `fill_relations`.  An outline with fewer than MAX_LANE_CORNERS corners is repeated from its
    first corner.
    """
    n, error_bounds, best = which.size, np.empty(LANES), np.empty(LANES)
    lanes = np.empty((4, MAX_LANE_CORNERS + 1, LANE_STRIDE))
    x, y, p, q = lanes[0], lanes[1], lanes[2], lanes[3]
    for k in range(n):
        i, j = ia[which[k]], ib[which[k]]
        copy_to_lane(ax, ay, sa[i], sa[i + 1], MAX_LANE_CORNERS, x, y, k)
        copy_to_lane(bx, by, sb[j], sb[j + 1], MAX_LANE_CORNERS, p, q, k)
        error_bounds[k], best[k] = _error_bound(box_a, i, box_b, j), -np.inf
    raise_clearance_8(x, y, p, q, 0, n, best)
    raise_clearance_8(p, q, x, y, 0, n, best)
    for k in range(n):
        out[which[k]] = classify(best[k], error_bounds[k])


@compiled
def copy_to_lane(x: Array, y: Array, start: int, stop: int, width: int, to_x: Array, to_y: Array, k: int) -> None:
    """Copy corners start to stop - 1 of x, y into column k of to_x, to_y, repeated until these hold `width` edges."""
    i = start
    for v in range(width + 1):
        to_x[v, k], to_y[v, k] = x[np.uintp(i)], y[np.uintp(i)]
        i = i + 1 if i + 1 < stop else start
