"""The models compiled with numba: plain loops over pairs, in the float format of the arrays.

Pairs are (ia[k], ib[k]); kernels write relation k to out[k].  In SAT the corners of shape i are x, y from start[i] to
start[i + 1], and r its radius, 0 for polygons; p, q, s and `begin` are the same of the second side.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..batch.codes import APART, OVERLAPPING, TOUCHING
from ..batch.ragged import MAX_LANE_CORNERS
from ..batch.with_numba.filter import raise_clearance_8
from ..batch.with_numba.indexed import LANE_STRIDE, LANES, copy_to_lane, raise_clearance_4
from ..batch.with_numba.jit_cache import compiled

Array = NDArray[Any]
Indices = NDArray[np.intp]
Relations = NDArray[np.int8]
FAR = np.float32(np.inf)  # float32, so that float32 arithmetic stays float32


@compiled
def compare_boxes(a: Array, ia: Indices, b: Array, ib: Indices, out: Relations) -> None:
    """Compare bounding boxes given as rows (x0, y0, x1, y1)."""
    for k in range(out.size):
        i, j = ia[k], ib[k]
        if a[i, 2] < b[j, 0] or b[j, 2] < a[i, 0] or a[i, 3] < b[j, 1] or b[j, 3] < a[i, 1]:
            out[k] = APART
        elif a[i, 2] > b[j, 0] and b[j, 2] > a[i, 0] and a[i, 3] > b[j, 1] and b[j, 3] > a[i, 1]:
            out[k] = OVERLAPPING
        else:
            out[k] = TOUCHING


@compiled
def compare_circles(a: Array, ia: Indices, b: Array, ib: Indices, out: Relations) -> None:
    """Compare circles given as rows (x, y, radius), by squared distances."""
    for k in range(out.size):
        i, j = ia[k], ib[k]
        out[k] = relation_of_gap(_squared_gap(a[i, 0], a[i, 1], a[i, 2], b[j, 0], b[j, 1], b[j, 2]))


@compiled
def compare_ranges(a: Array, ia: Indices, b: Array, ib: Indices, out: Relations) -> None:
    """Compare shapes by their (N, k, 2) ranges on k directions."""
    for k in range(out.size):
        i, j = ia[k], ib[k]
        relation = OVERLAPPING
        for d in range(a.shape[1]):
            if a[i, d, 0] > b[j, d, 1] or b[j, d, 0] > a[i, d, 1]:
                relation = APART
                break
            if a[i, d, 0] == b[j, d, 1] or b[j, d, 0] == a[i, d, 1]:
                relation = TOUCHING
        out[k] = relation


@compiled
def sat(
    x: Array, y: Array, r: Array, start: Indices, box_a: Array, ia: Indices,
    p: Array, q: Array, s: Array, begin: Indices, box_b: Array, ib: Indices, out: Relations,
) -> None:  # fmt: skip
    """Run SAT on pairs of convex parts: bounding boxes first, then every edge, and squared distances for circles.

    Polygons of few corners are collected until LANES pairs of them can be evaluated side by side.
    """
    best = np.empty(LANES, x.dtype)
    at, of = (np.empty((4, 9, LANE_STRIDE), x.dtype), np.empty((2, LANES), np.intp))
    many = np.zeros(2, np.intp)
    for k in range(out.size):
        i, j = ia[k], ib[k]
        # a circle has one corner; its radius may round to 0 in float32
        round_a, round_b = start[i + 1] - start[i] == 1, begin[j + 1] - begin[j] == 1
        apart_in_x = max(box_a[i, 0], box_b[j, 0]) > min(box_a[i, 2], box_b[j, 2])
        if apart_in_x or max(box_a[i, 1], box_b[j, 1]) > min(box_a[i, 3], box_b[j, 3]):
            out[k] = APART
        elif round_a and round_b:
            u, v = start[i], begin[j]
            out[k] = relation_of_gap(_squared_gap(x[u], y[u], r[i], p[v], q[v], s[j]))
        elif round_a:
            u = start[i]
            out[k] = relation_of_gap(circle_polygon_gap(x[u], y[u], r[i], p, q, begin[j], begin[j + 1]))
        elif round_b:
            v = begin[j]
            out[k] = relation_of_gap(circle_polygon_gap(p[v], q[v], s[j], x, y, start[i], start[i + 1]))
        elif max(start[i + 1] - start[i], begin[j + 1] - begin[j]) <= MAX_LANE_CORNERS:
            w = 0 if max(start[i + 1] - start[i], begin[j + 1] - begin[j]) <= 4 else 1
            of[w, many[w]] = k
            many[w] += 1
            if many[w] == LANES:
                _evaluate_lanes(x, y, start, ia, p, q, begin, ib, of[w], 4 * (w + 1), at, best, out)
                many[w] = 0
        else:
            gap = polygon_clearance(x, y, start[i], start[i + 1], p, q, begin[j], begin[j + 1])
            if gap <= 0:
                gap = max(gap, polygon_clearance(p, q, begin[j], begin[j + 1], x, y, start[i], start[i + 1]))
            out[k] = relation_of_gap(gap)
    for w in range(2):
        _evaluate_lanes(x, y, start, ia, p, q, begin, ib, of[w, : many[w]], 4 * (w + 1), at, best, out)


@compiled
def _squared_gap(ax: float, ay: float, ar: float, bx: float, by: float, br: float) -> float:
    """Return the squared distance of two circles less the squared sum of their radii."""
    dx, dy, radii = ax - bx, ay - by, ar + br
    return dx * dx + dy * dy - radii * radii


@compiled
def relation_of_gap(gap: float) -> int:
    """Return APART for a positive gap, OVERLAPPING for a negative one, else TOUCHING."""
    return APART if gap > 0 else OVERLAPPING if gap < 0 else TOUCHING


@compiled
def _evaluate_lanes(
    x: Array, y: Array, start: Indices, ia: Indices, p: Array, q: Array, begin: Indices, ib: Indices,
    of: Indices, width: int, at: Array, best: Array, out: Relations,
) -> None:  # fmt: skip
    """Run SAT on the pairs of numbers `of`, side by side; `width`: 4 or 8 corners; `at` and `best`: scratch arrays."""
    n = of.size
    for k in range(n):
        i, j = ia[of[k]], ib[of[k]]
        copy_to_lane(x, y, start[i], start[i + 1], width, at[0], at[1], k)
        copy_to_lane(p, q, begin[j], begin[j + 1], width, at[2], at[3], k)
        best[k] = -np.inf
    if width == 4:
        raise_clearance_4(at[0], at[1], at[2], at[3], n, best)
        raise_clearance_4(at[2], at[3], at[0], at[1], n, best)
    else:
        raise_clearance_8(at[0], at[1], at[2], at[3], 0, n, best)
        raise_clearance_8(at[2], at[3], at[0], at[1], 0, n, best)
    for k in range(n):
        out[of[k]] = relation_of_gap(best[k])


@compiled
def polygon_clearance(x: Array, y: Array, first: int, last: int, p: Array, q: Array, begin: int, end: int) -> float:
    """Return the clearance of the first edge that separates the polygons, else the largest clearance of an edge."""
    best: float = x[first] * 0 - FAR
    ux, uy = x[last - 1], y[last - 1]
    for e in range(first, last):
        vx, vy = x[e], y[e]
        nx, ny = vy - uy, ux - vx
        at = nx * ux + ny * uy
        least = nx * p[begin] + ny * q[begin] - at
        for c in range(begin + 1, end):
            if least < best:
                break  # this edge cannot raise the largest clearance
            least = min(least, nx * p[c] + ny * q[c] - at)
        best = max(best, least)
        if best > 0:
            break
        ux, uy = vx, vy
    return best


@compiled
def circle_polygon_gap(cx: float, cy: float, r: float, p: Array, q: Array, begin: int, end: int) -> Any:
    """Return the squared distance from center to polygon less the squared radius; -1 with the center inside."""
    inside = True
    nearest = cx * 0 + FAR
    wx, wy = p[end - 1], q[end - 1]
    for e in range(begin, end):
        vx, vy = p[e], q[e]
        dx, dy, ax, ay = vx - wx, vy - wy, wx - cx, wy - cy
        turn = ax * dy - ay * dx
        inside = inside and turn > 0
        along, square = -(ax * dx + ay * dy), dx * dx + dy * dy
        if along <= 0:
            away = ax * ax + ay * ay
        elif along >= square:
            bx, by = vx - cx, vy - cy
            away = bx * bx + by * by
        else:
            away = turn / square * turn
        nearest = min(nearest, away)
        wx, wy = vx, vy
    return -1.0 if inside else nearest - r * r
