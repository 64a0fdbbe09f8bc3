"""The float filter for arrays of pairs, compiled with numba: vectorised over pairs, the GIL released, cached on disk.

Every kernel takes one column per pair and fills out[k] with the relation of column first + k, or UNDECIDED.  The
clearance of an edge is its distance from the other shape times its length: positive if it clears it.  A tile is
TILE_SHAPES columns.  Arrays come whole: the compiler cannot know that the rows of a slice
have no gaps, and then it does not vectorise.
Names in the kernels: ax, ay and bx, by are the coordinates of the corners of A and B, a row per corner and a
column per pair; x, y are those of the shape whose edges are evaluated and p, q those of the other shape's corners.
Loops over corners are unrolled by the compiler where their number is a constant.
"""

from collections.abc import Callable
from functools import cache

import numpy as np

from ...engine.predicates import MAX_SAFE_PRODUCT, MIN_SAFE_PRODUCT
from ...engine.relate import ERROR_FACTOR_F64, MAX_ERROR_BOUND, MIN_ERROR_BOUND
from ..array_types import Array, Relations
from ..arrays import TILE_SHAPES, CornerColumns
from ..codes import APART, OVERLAPPING, TOUCHING, UNDECIDED
from .jit_cache import compiled, inlined

MAX_DIRECT_SHAPES = 1 << 17  # shapes up to which the rows of 8 corners stay near enough to be read where they lie
BLOCK_PAIRS = 1 << 17  # pairs a call: enough that the time spent in Python does not matter


def polygons(a: CornerColumns, b: CornerColumns, first: int, out: Relations) -> None:
    """Fill out[k] with the relation of column first + k of A and B; UNDECIDED within the float64 error bound."""
    clearance_kernel(len(a.x), len(b.x))(a.x, a.y, b.x, b.y, first, error_bounds(a, b), out)


def error_bounds(a: CornerColumns, b: CornerColumns) -> Array:
    """Return the float64 error bound of the clearances in each tile of columns, infinite out of its range."""
    with np.errstate(over="ignore"):
        found: Array = (a.tile_maxima.edge + b.tile_maxima.edge) * ERROR_FACTOR_F64
        found *= a.tile_maxima.coordinate + b.tile_maxima.coordinate
    found[~((found > MIN_ERROR_BOUND) & (found < MAX_ERROR_BOUND))] = np.inf
    return found


def clearance_kernel(va: int, vb: int) -> Callable[..., None]:
    """Return the compiled filter (ax, ay, bx, by, first, error_bounds, out) for polygons of va and of vb corners."""
    return _unrolled_kernel(va, vb) if va <= 4 and vb <= 4 else _tile_kernel


@compiled
def classify(gap: float, error_bound: float) -> int:
    """Return the relation that a rounded gap proves: APART, OVERLAPPING, or UNDECIDED within its error bound."""
    return APART if gap > error_bound else OVERLAPPING if gap < -error_bound else UNDECIDED


@cache
def _unrolled_kernel(va: int, vb: int) -> Callable[..., None]:
    """Return the filter compiled for exactly va and vb corners, whose loops the compiler unrolls and vectorises."""

    @compiled
    def kernel(ax: Array, ay: Array, bx: Array, by: Array, first: int, error_bounds: Array, out: Relations) -> None:
        """Fill out[k] with the relation of column first + k, by its largest clearance; error_bounds: one for a tile."""
        for tile in range(first // TILE_SHAPES, (first + out.size - 1) // TILE_SHAPES + 1):
            error_bound = error_bounds[tile]
            for k in range(max(0, tile * TILE_SHAPES - first), min(out.size, (tile + 1) * TILE_SHAPES - first)):
                i = np.uintp(first + k)  # unsigned: numba need not ask whether it counts from the end
                best = -np.inf
                for e in range(va):
                    f = (e + 1) % va
                    ex, ey = ax[e, i], ay[e, i]
                    nx, ny = ay[f, i] - ey, ex - ax[f, i]
                    least = np.inf
                    for v in range(vb):
                        least = min(least, nx * bx[v, i] + ny * by[v, i])
                    best = max(best, least - (nx * ex + ny * ey))
                for e in range(vb):
                    f = (e + 1) % vb
                    ex, ey = bx[e, i], by[e, i]
                    nx, ny = by[f, i] - ey, ex - bx[f, i]
                    least = np.inf
                    for v in range(va):
                        least = min(least, nx * ax[v, i] + ny * ay[v, i])
                    best = max(best, least - (nx * ex + ny * ey))
                out[np.uintp(k)] = classify(best, error_bound)

    return kernel


@compiled
def _tile_kernel(ax: Array, ay: Array, bx: Array, by: Array, first: int, error_bounds: Array, out: Relations) -> None:
    """Fill `out` as the kernel of `_unrolled_kernel` does, for any numbers of corners, a tile of pairs at a time."""
    best, least, nx, ny = np.empty(TILE_SHAPES), np.empty(TILE_SHAPES), np.empty(TILE_SHAPES), np.empty(TILE_SHAPES)
    lanes = np.empty(
        (4, 8, TILE_SHAPES + 8)
    )  # a power of two would put all corners into the same few places of the cache
    for tile in range(first // TILE_SHAPES, (first + out.size - 1) // TILE_SHAPES + 1):
        start = max(0, tile * TILE_SHAPES - first)
        n = min(out.size, (tile + 1) * TILE_SHAPES - first) - start
        for i in range(n):
            best[i] = -np.inf
        if ax.shape[0] == 8 and bx.shape[0] == 8 and ax.shape[1] > MAX_DIRECT_SHAPES:
            for v in range(8):
                for i in range(n):
                    k = np.uintp(first + start + i)
                    lanes[0, v, i], lanes[1, v, i] = ax[v, k], ay[v, k]
                    lanes[2, v, i], lanes[3, v, i] = bx[v, k], by[v, k]
            raise_clearance_8(lanes[0], lanes[1], lanes[2], lanes[3], 0, n, best)
            raise_clearance_8(lanes[2], lanes[3], lanes[0], lanes[1], 0, n, best)
        elif ax.shape[0] == 8 and bx.shape[0] == 8:
            raise_clearance_8(ax, ay, bx, by, first + start, n, best)
            raise_clearance_8(bx, by, ax, ay, first + start, n, best)
        else:
            _raise_clearance(ax, ay, bx, by, first + start, n, best, least, nx, ny)
            _raise_clearance(bx, by, ax, ay, first + start, n, best, least, nx, ny)
        for i in range(n):
            out[start + i] = classify(best[i], error_bounds[tile])


def _raise_clearance_kernel(corners: int) -> Callable[..., None]:
    """Return a kernel that does what `_raise_clearance` does, for shapes that both have this number of corners."""

    @compiled
    def raise_clearance(x: Array, y: Array, p: Array, q: Array, start: int, n: int, best: Array) -> None:
        """Do what `_raise_clearance` does; x, y may have one row more, which repeats the first corner."""
        for e in range(corners):
            f = (e + 1) % x.shape[0]
            for k in range(n):
                i = np.uintp(start + k)
                ex, ey = x[e, i], y[e, i]
                nx, ny = y[f, i] - ey, ex - x[f, i]
                least = np.inf
                for v in range(corners):
                    least = min(least, nx * p[v, i] + ny * q[v, i])
                best[k] = max(best[k], least - (nx * ex + ny * ey))

    return raise_clearance


raise_clearance_4 = _raise_clearance_kernel(4)
raise_clearance_8 = _raise_clearance_kernel(8)


@compiled
def _raise_clearance(
    x: Array, y: Array, p: Array, q: Array, start: int, n: int, best: Array, least: Array, nx: Array, ny: Array
) -> None:
    """Raise best[k] to the largest clearance of an edge of x, y over the corners p, q, in column start + k, for k < n.

    x, y: (V, N); p, q: (W, N); least, nx and ny are scratch.  Four corners of p, q are evaluated at a time.
    """
    stop = start + n
    for e in range(x.shape[0]):
        f = (e + 1) % x.shape[0]
        x0, y0, x1, y1 = x[e, start:stop], y[e, start:stop], x[f, start:stop], y[f, start:stop]
        for i in range(n):
            nx[i], ny[i], least[i] = y1[i] - y0[i], x0[i] - x1[i], np.inf
        v = 0
        while v + 4 <= p.shape[0]:
            p0, p1, p2, p3 = p[v, start:stop], p[v + 1, start:stop], p[v + 2, start:stop], p[v + 3, start:stop]
            q0, q1, q2, q3 = q[v, start:stop], q[v + 1, start:stop], q[v + 2, start:stop], q[v + 3, start:stop]
            for i in range(n):
                a, b = nx[i], ny[i]
                low = min(a * p0[i] + b * q0[i], a * p1[i] + b * q1[i])
                least[i] = min(least[i], min(low, min(a * p2[i] + b * q2[i], a * p3[i] + b * q3[i])))
            v += 4
        while v < p.shape[0]:
            pv, qv = p[v, start:stop], q[v, start:stop]
            for i in range(n):
                least[i] = min(least[i], nx[i] * pv[i] + ny[i] * qv[i])
            v += 1
        for i in range(n):
            best[i] = max(best[i], least[i] - (nx[i] * x0[i] + ny[i] * y0[i]))


def boxes(a: CornerColumns, b: CornerColumns, first: int, out: Relations) -> None:
    """Fill out[k] with the exact relation of the upright boxes in column first + k of A and B."""
    _boxes(a.x, a.y, b.x, b.y, first, out)


@compiled
def _boxes(ax: Array, ay: Array, bx: Array, by: Array, first: int, out: Relations) -> None:
    """Fill out[k] with the exact relation of the upright boxes in column first + k, by comparing sides."""
    for k in range(out.size):
        i = np.uintp(first + k)
        gap_x = range_gap(
            min(ax[0, i], ax[2, i]), max(ax[0, i], ax[2, i]), min(bx[0, i], bx[2, i]), max(bx[0, i], bx[2, i])
        )
        gap_y = range_gap(
            min(ay[0, i], ay[2, i]), max(ay[0, i], ay[2, i]), min(by[0, i], by[2, i]), max(by[0, i], by[2, i])
        )
        out[k] = relation_of_gap(max(gap_x, gap_y))


@compiled
def range_gap(a_low: float, a_high: float, b_low: float, b_high: float) -> float:
    """Return the gap between two ranges on one axis: 0 where they touch, negative where they overlap."""
    return max(a_low - b_high, b_low - a_high)


@compiled
def relation_of_gap(gap: float) -> int:
    """Return the relation that an exact gap means: APART above 0, TOUCHING at 0, else OVERLAPPING."""
    return APART if gap > 0 else OVERLAPPING if gap < 0 else TOUCHING


@compiled
def circles(ax: Array, ay: Array, ar: Array, bx: Array, by: Array, br: Array, first: int, out: Relations) -> None:
    """Fill out[k] with the relation of the circles first + k of A and B as `relate_circles` returns it."""
    for k in range(out.size):
        i = np.uintp(first + k)
        out[k] = relate_circles(ax[i], ay[i], ar[i], bx[i], by[i], br[i])


@compiled
def relate_circles(ax: float, ay: float, ar: float, bx: float, by: float, br: float) -> int:
    """Return the relation of two circles by squared distance and radii; UNDECIDED within the error bound."""
    dx, dy, radius_sum = ax - bx, ay - by, ar + br
    distance, radius_squared = dx * dx + dy * dy, radius_sum * radius_sum
    size = distance + radius_squared
    error_bound = size * 2.0**-50 if size > MIN_SAFE_PRODUCT and size < MAX_SAFE_PRODUCT else np.inf
    return classify(distance - radius_squared, error_bound)


def circle_polygons(cx: Array, cy: Array, cr: Array, px: Array, py: Array, first: int, out: Relations) -> None:
    """Fill out[k] with the relation of circle first + k and polygon column first + k, by squared distance to boundary.

    UNDECIDED within its error bound.
    """
    (_circle_unrolled(len(px)) if len(px) <= 8 else _circle_general)(cx, cy, cr, px, py, first, out)


@inlined
def _distance_from_edge(
    x: float, y: float, u: float, z: float, dx: float, dy: float, orientation_error: float
) -> tuple[float, bool, float]:
    """Return (squared distance of the origin from an edge, is it certainly left of it, the edge's squared length).

    The edge leads from (x, y) to (u, z), and (dx, dy) is its vector, computed before the center was moved to the
    origin.  `orientation_error`: the error bound of the orientation determinant, divided by |dx| + |dy|.
    """
    orientation = x * dy - y * dx
    along, square = -(x * dx + y * dy), dx * dx + dy * dy
    foot = orientation / square * orientation
    distance = x * x + y * y if along <= 0 else u * u + z * z if along >= square else foot
    return distance, orientation > (abs(dx) + abs(dy)) * orientation_error, square


def _circle_kernel(corners: int | None) -> Callable[..., None]:
    """Return the kernel of `circle_polygons` compiled for `corners` corners, or for any number (None)."""

    @compiled
    def kernel(cx: Array, cy: Array, cr: Array, px: Array, py: Array, first: int, out: Relations) -> None:
        """Fill `out` as `circle_polygons` says."""
        count = px.shape[0] if corners is None else corners
        for k in range(out.size):
            i = np.uintp(first + k)  # unsigned: numba need not ask whether it counts from the end
            x0, y0, r = cx[i], cy[i], cr[i]
            far = r
            for v in range(count):
                far = max(far, max(abs(px[v, i] - x0), abs(py[v, i] - y0)))
            # error bounds as relate._relate_circle_polygon derives
            error_bound, orientation_error = far * far * 2.0**-46, far * 2.0**-48
            safe = error_bound > MIN_SAFE_PRODUCT and error_bound < MAX_SAFE_PRODUCT * 2.0**-46
            inside, nearest = True, np.inf
            for v in range(count):
                w = (v + 1) % count
                dx, dy = px[w, i] - px[v, i], py[w, i] - py[v, i]
                x, y, u, z = px[v, i] - x0, py[v, i] - y0, px[w, i] - x0, py[w, i] - y0
                distance, left, square = _distance_from_edge(x, y, u, z, dx, dy, orientation_error)
                safe = safe & (square > MIN_SAFE_PRODUCT)
                inside = inside & left
                # edges that face away are included: none of them is nearer than the nearest
                nearest = min(nearest, distance)
            radius_squared = r * r
            # a center inside, taken for one on an edge's line, has the boundary within twice the tolerance
            gap = -np.inf if inside else nearest - radius_squared
            out[k] = classify(gap, error_bound) if safe else UNDECIDED

    return kernel


@compiled
def relate_circle_polygon(x0: float, y0: float, r: float, px: Array, py: Array, start: int, stop: int) -> int:
    """Return the relation of a circle and the polygon of corners start to stop - 1, or UNDECIDED within error bounds.

    x0, y0, r: center and radius.  Decides as `circle_polygons` does.
    """
    far = r
    for v in range(start, stop):
        far = max(far, max(abs(px[v] - x0), abs(py[v] - y0)))
    error_bound, orientation_error = far * far * 2.0**-46, far * 2.0**-48
    safe = error_bound > MIN_SAFE_PRODUCT and error_bound < MAX_SAFE_PRODUCT * 2.0**-46
    inside, nearest = True, np.inf
    x, y = px[stop - 1] - x0, py[stop - 1] - y0
    for v in range(start, stop):
        dx, dy = px[v] - px[v - 1 if v > start else stop - 1], py[v] - py[v - 1 if v > start else stop - 1]
        u, z = px[v] - x0, py[v] - y0
        distance, left, square = _distance_from_edge(x, y, u, z, dx, dy, orientation_error)
        safe = safe & (square > MIN_SAFE_PRODUCT)
        inside = inside & left
        nearest = min(nearest, distance)
        x, y = u, z
    return classify(-np.inf if inside else nearest - r * r, error_bound) if safe else UNDECIDED


_circle_unrolled = cache(_circle_kernel)
_circle_general = _circle_kernel(None)
