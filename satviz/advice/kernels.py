"""The models compiled with numba: plain loops over pairs, in the float format of the arrays given.

Arguments, for A and for B: `x_a`, `y_a`: the corners of all convex parts, those of part i from `start_a[i]` to
`start_a[i + 1]`; `r_a`: the radii of the parts; `box_a`: their bounding boxes; `ia`: the part of each pair; `first`,
`last`: where the corners of one part begin and end.  `out` takes the relation of each pair.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..batch.codes import APART, OVERLAPPING, TOUCHING
from ..batch.ragged import MAX_LANE_CORNERS
from ..batch.with_numba.filter import raise_clearance_4, raise_clearance_8
from ..batch.with_numba.indexed import LANE_STRIDE, LANES, copy_to_lane
from ..batch.with_numba.jit_cache import compiled

Array = NDArray[Any]
Indices = NDArray[np.intp]
Relations = NDArray[np.int8]
INFINITY = np.float32(np.inf)  # a float32, so that float32 arithmetic stays float32


@compiled
def compare_boxes(a: Array, ia: Indices, b: Array, ib: Indices, out: Relations) -> None:
    """Fill `out` with the relations of boxes a[ia[k]] and b[ib[k]]; boxes are rows x0, y0, x1, y1."""
    for k in range(out.size):
        i, j = ia[k], ib[k]
        if _boxes_apart(a, i, b, j):
            out[k] = APART
        elif a[i, 2] > b[j, 0] and b[j, 2] > a[i, 0] and a[i, 3] > b[j, 1] and b[j, 3] > a[i, 1]:
            out[k] = OVERLAPPING
        else:
            out[k] = TOUCHING


@compiled
def _boxes_apart(a: Array, i: int, b: Array, j: int) -> Any:
    """Return whether box i of A and box j of B leave a gap."""
    aside = max(a[i, 0], b[j, 0]) > min(a[i, 2], b[j, 2])
    return aside or max(a[i, 1], b[j, 1]) > min(a[i, 3], b[j, 3])


@compiled
def compare_circles(a: Array, ia: Indices, b: Array, ib: Indices, out: Relations) -> None:
    """Fill `out` with the relations of circles a[ia[k]] and b[ib[k]]; circles are rows x, y, radius."""
    for k in range(out.size):
        i, j = ia[k], ib[k]
        out[k] = relation_of_gap(_squared_gap(a[i, 0], a[i, 1], a[i, 2], b[j, 0], b[j, 1], b[j, 2]))


@compiled
def _squared_gap(ax: float, ay: float, ar: float, bx: float, by: float, br: float) -> float:
    """Return the squared distance of two centers less the squared sum of the radii."""
    dx, dy, radius_sum = ax - bx, ay - by, ar + br
    return dx * dx + dy * dy - radius_sum * radius_sum


@compiled
def compare_ranges(a: Array, ia: Indices, b: Array, ib: Indices, out: Relations) -> None:
    """Fill `out` with the relations of (N, k, 2) ranges a[ia[k]] and b[ib[k]]: APART if a direction has a gap."""
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
    x_a: Array, y_a: Array, r_a: Array, start_a: Indices, box_a: Array, ia: Indices,
    x_b: Array, y_b: Array, r_b: Array, start_b: Indices, box_b: Array, ib: Indices, out: Relations,
) -> None:  # fmt: skip
    """Fill `out` with the relations of convex parts ia[k] of A and ib[k] of B: by their boxes, then every edge of both.

    x, y: all corners; part i has those from start[i] to start[i + 1], the radius r[i] (0 for a polygon), and the box
    box[i], a row x0, y0, x1, y1.  Two circles, or a circle and a polygon, are compared by squared distances.

    Pairs of polygons with at most 4 corners, and those with at most 8, are collected and evaluated LANES at a time.
    """
    best = np.empty(LANES, x_a.dtype)
    corners, waiting = np.empty((4, 9, LANE_STRIDE), x_a.dtype), np.empty((2, LANES), np.intp)
    waiting_count = np.zeros(2, np.intp)
    for k in range(out.size):
        i, j = ia[k], ib[k]
        # a circle has one corner; its radius can be too small for float32
        is_circle_a, is_circle_b = start_a[i + 1] - start_a[i] == 1, start_b[j + 1] - start_b[j] == 1
        if _boxes_apart(box_a, i, box_b, j):
            out[k] = APART
        elif is_circle_a and is_circle_b:
            u, v = start_a[i], start_b[j]
            out[k] = relation_of_gap(_squared_gap(x_a[u], y_a[u], r_a[i], x_b[v], y_b[v], r_b[j]))
        elif is_circle_a:
            u = start_a[i]
            gap = circle_polygon_gap(x_a[u], y_a[u], r_a[i], x_b, y_b, start_b[j], start_b[j + 1])
            out[k] = relation_of_gap(gap)
        elif is_circle_b:
            v = start_b[j]
            gap = circle_polygon_gap(x_b[v], y_b[v], r_b[j], x_a, y_a, start_a[i], start_a[i + 1])
            out[k] = relation_of_gap(gap)
        elif max(start_a[i + 1] - start_a[i], start_b[j + 1] - start_b[j]) <= MAX_LANE_CORNERS:
            w = 0 if max(start_a[i + 1] - start_a[i], start_b[j + 1] - start_b[j]) <= 4 else 1
            waiting[w, waiting_count[w]] = k
            waiting_count[w] += 1
            if waiting_count[w] == LANES:
                _sat_in_lanes(x_a, y_a, start_a, ia, x_b, y_b, start_b, ib, waiting[w], 4 * (w + 1), corners, best, out)
                waiting_count[w] = 0
        else:
            clearance = polygon_clearance(x_a, y_a, start_a[i], start_a[i + 1], x_b, y_b, start_b[j], start_b[j + 1])
            if clearance <= 0:
                other = polygon_clearance(x_b, y_b, start_b[j], start_b[j + 1], x_a, y_a, start_a[i], start_a[i + 1])
                clearance = max(clearance, other)
            out[k] = relation_of_gap(clearance)
    for w in range(2):
        rest = waiting[w, : waiting_count[w]]
        _sat_in_lanes(x_a, y_a, start_a, ia, x_b, y_b, start_b, ib, rest, 4 * (w + 1), corners, best, out)


@compiled
def relation_of_gap(gap: float) -> int:
    """Return APART for a positive gap, OVERLAPPING for a negative one, TOUCHING for 0."""
    return APART if gap > 0 else OVERLAPPING if gap < 0 else TOUCHING


@compiled
def _sat_in_lanes(
    x_a: Array, y_a: Array, start_a: Indices, ia: Indices, x_b: Array, y_b: Array, start_b: Indices, ib: Indices,
    pairs: Indices, width: int, corners: Array, best: Array, out: Relations,
) -> None:  # fmt: skip
    """Fill `out` at the given pairs of polygons with up to `width` (4 or 8) corners, evaluated side by side.

    `corners` and `best` are scratch arrays; the arrays of A and B are those of `sat`.
    """
    count = pairs.size
    for k in range(count):
        i, j = ia[pairs[k]], ib[pairs[k]]
        copy_to_lane(x_a, y_a, start_a[i], start_a[i + 1], width, corners[0], corners[1], k)
        copy_to_lane(x_b, y_b, start_b[j], start_b[j + 1], width, corners[2], corners[3], k)
        best[k] = -np.inf
    if width == 4:
        raise_clearance_4(corners[0], corners[1], corners[2], corners[3], 0, count, best)
        raise_clearance_4(corners[2], corners[3], corners[0], corners[1], 0, count, best)
    else:
        raise_clearance_8(corners[0], corners[1], corners[2], corners[3], 0, count, best)
        raise_clearance_8(corners[2], corners[3], corners[0], corners[1], 0, count, best)
    for k in range(count):
        out[pairs[k]] = relation_of_gap(best[k])


@compiled
def polygon_clearance(
    x_a: Array, y_a: Array, first_a: int, last_a: int, x_b: Array, y_b: Array, first_b: int, last_b: int
) -> float:
    """Return the largest clearance of an edge of A, or the first positive one.

    The clearance is the least orientation of B's corners about the edge, positive where all lie beyond it.
    Corners: `first` to `last` - 1 of x and y.
    """
    best: float = x_a[first_a] * 0 - INFINITY
    px, py = x_a[last_a - 1], y_a[last_a - 1]
    for e in range(first_a, last_a):
        qx, qy = x_a[e], y_a[e]
        nx, ny = qy - py, px - qx
        edge = nx * px + ny * py
        clearance = nx * x_b[first_b] + ny * y_b[first_b] - edge
        for c in range(first_b + 1, last_b):
            if clearance < best:
                break  # this edge does not have the largest
            clearance = min(clearance, nx * x_b[c] + ny * y_b[c] - edge)
        best = max(best, clearance)
        if best > 0:
            break
        px, py = qx, qy
    return best


@compiled
def circle_polygon_gap(cx: float, cy: float, r: float, x: Array, y: Array, first: int, last: int) -> Any:
    """Return (squared distance of the circle's center from the boundary) - r * r; -1 if the center is inside.

    The convex polygon has the counter-clockwise corners `first` to `last` - 1 of x and y.
    """
    inside = True
    nearest = cx * 0 + INFINITY
    px, py = x[last - 1], y[last - 1]
    for e in range(first, last):
        qx, qy = x[e], y[e]
        dx, dy, ax, ay = qx - px, qy - py, px - cx, py - cy
        orientation = ax * dy - ay * dx
        inside = inside and orientation > 0
        along, square = -(ax * dx + ay * dy), dx * dx + dy * dy
        if along <= 0:
            distance = ax * ax + ay * ay
        elif along >= square:
            bx, by = qx - cx, qy - cy
            distance = bx * bx + by * by
        else:
            distance = orientation / square * orientation
        nearest = min(nearest, distance)
        px, py = qx, qy
    return -1.0 if inside else nearest - r * r
