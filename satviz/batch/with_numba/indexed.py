"""Pairs of convex polygons and circles given by indices, compiled with numba.

Names in the kernels: sa and sb say where the corners of each shape of A and B start, ra and rb hold their radii (0 for
polygons), box_a and box_b their bounding boxes; pair k is shape i = ia[k] of A and shape j = ib[k] of B.  A lane is a
column of the scratch arrays x, y (corners of A) and p, q (corners of B).
"""

import numpy as np

from ...engine.relate import ERROR_FACTOR_F64, MAX_ERROR_BOUND, MIN_ERROR_BOUND
from ..array_types import Array, Indices, Mask, Signs
from ..arrays import TILE_SHAPES, Flat, Group
from ..codes import OVERLAPPING, UNDECIDED
from ..ragged import MAX_LANE_CORNERS
from .exact import MAX_TERMS, is_certainly_inside, relate_few_corners, relate_many_corners
from .filter import (
    classify,
    raise_clearance_4,
    raise_clearance_8,
    range_gap,
    relate_circle_polygon,
    relate_circles,
    relation_of_gap,
)
from .jit_cache import compiled

LANES = 128  # pairs whose corners stay in the first-level cache
LANE_STRIDE = LANES + 8  # a power of two would put all corners of a pair into the same few places of the cache


def relations(a: Flat, ia: Indices, b: Flat, ib: Indices, out: Signs) -> None:
    """Fill `out` with the relations of a[ia[k]] and b[ib[k]].

    Polygons are decided exactly, but UNDECIDED where floats go out of range; pairs with a circle are UNDECIDED within
    the error bound.
    """
    fill_relations(
        *(a.x, a.y, a.start, a.radius, a.bounds, a.upright),
        *(b.x, b.y, b.start, b.radius, b.bounds, b.upright),
        *(np.ascontiguousarray(ia), np.ascontiguousarray(ib), out),
    )


def columns(a: Group, b: Group, first: int, out: Signs) -> None:
    """Replace UNDECIDED in `out` by exact relations, in columns from `first` on; some stay UNDECIDED."""
    _columns(a.x, a.y, b.x, b.y, first, a.tile_maxima.coordinate + b.tile_maxima.coordinate, out)


@compiled
def _columns(ax: Array, ay: Array, bx: Array, by: Array, first: int, max_coordinates: Array, out: Signs) -> None:
    """Replace UNDECIDED in `out` by the exact relations, `max_coordinates`: the sum of both of a tile."""
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
    ia: Indices, ib: Indices, out: Signs,
) -> None:  # fmt: skip
    """Fill `out` with the relations of pairs (ia, ib): by boxes, then the float filter in lanes, then exactly."""
    terms, error_bounds, best = np.empty(MAX_TERMS), np.empty(LANES), np.empty(LANES)
    x, y = np.empty((MAX_LANE_CORNERS + 1, LANE_STRIDE)), np.empty((MAX_LANE_CORNERS + 1, LANE_STRIDE))
    p, q = np.empty((MAX_LANE_CORNERS + 1, LANE_STRIDE)), np.empty((MAX_LANE_CORNERS + 1, LANE_STRIDE))
    waiting, many = np.empty((2, LANES), np.intp), np.zeros(2, np.intp)  # pairs of up to four corners, of up to eight
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
        if most <= MAX_LANE_CORNERS:
            w = 0 if most <= 4 else 1
            waiting[w, many[w]] = k
            many[w] += 1
            if many[w] == LANES:
                full, width = waiting[w], 4 * (w + 1)
                _evaluate_lanes(
                    ax, ay, sa, box_a, bx, by, sb, box_b, ia, ib, full, width, x, y, p, q, error_bounds, best, out
                )
                many[w] = 0
    for w in range(2):
        left, width = waiting[w, : many[w]], 4 * (w + 1)
        _evaluate_lanes(ax, ay, sa, box_a, bx, by, sb, box_b, ia, ib, left, width, x, y, p, q, error_bounds, best, out)
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
def _max_coordinate(box: Array, i: int) -> float:
    """Return the largest absolute coordinate of a box."""
    max_coordinate: float = max(max(-box[i, 0], box[i, 2]), max(-box[i, 1], box[i, 3]))
    return max_coordinate


@compiled
def _max_width(box: Array, i: int) -> float:
    """Return an upper bound of the x and y components of a shape's edges, from its box."""
    width: float = max(box[i, 2] - box[i, 0], box[i, 3] - box[i, 1])
    return width


@compiled
def _evaluate_lanes(
    ax: Array, ay: Array, sa: Indices, box_a: Array, bx: Array, by: Array, sb: Indices, box_b: Array,
    ia: Indices, ib: Indices, which: Indices, width: int,
    x: Array, y: Array, p: Array, q: Array, error_bounds: Array, best: Array, out: Signs,
) -> None:  # fmt: skip
    """Fill `out` at the pairs `which` by the float filter, side by side, each outline extended to `width` edges."""
    n = which.size
    for k in range(n):
        i, j = ia[which[k]], ib[which[k]]
        copy_to_lane(ax, ay, sa[i], sa[i + 1], width, x, y, k)
        copy_to_lane(bx, by, sb[j], sb[j + 1], width, p, q, k)
        error_bound = (
            (_max_width(box_a, i) + _max_width(box_b, j))
            * (_max_coordinate(box_a, i) + _max_coordinate(box_b, j))
            * ERROR_FACTOR_F64
        )
        error_bounds[k] = error_bound if error_bound > MIN_ERROR_BOUND and error_bound < MAX_ERROR_BOUND else np.inf
        best[k] = -np.inf
    if width == 4:
        raise_clearance_4(x, y, p, q, 0, n, best)
        raise_clearance_4(p, q, x, y, 0, n, best)
    else:
        raise_clearance_8(x, y, p, q, 0, n, best)
        raise_clearance_8(p, q, x, y, 0, n, best)
    for k in range(n):
        out[which[k]] = classify(best[k], error_bounds[k])


@compiled
def copy_to_lane(x: Array, y: Array, start: int, stop: int, width: int, to_x: Array, to_y: Array, k: int) -> None:
    """Copy an outline into lane k, repeated from its first corner until it has `width` edges."""
    i = start
    for v in range(width + 1):
        to_x[v, k], to_y[v, k] = x[np.uintp(i)], y[np.uintp(i)]
        i = i + 1 if i + 1 < stop else start
