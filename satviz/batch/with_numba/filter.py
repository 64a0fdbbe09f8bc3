"""The same filter compiled with numba: vectorised over pairs, the GIL released, cached on disk.

Arrays come whole, with the first column to evaluate: a slice of them has rows that the
compiler cannot know to be without gaps, and then it does not vectorise.

Loops over corners are unrolled by the compiler where their number is a constant
(3 and 4 corners), written out for 8, and taken four at a time otherwise.
"""

from collections.abc import Callable
from functools import cache

import numpy as np

from ...engine.predicates import MAX_SAFE_PRODUCT, MIN_SAFE_PRODUCT
from ...engine.relate import ERROR_FACTOR_F64, MAX_ERROR_BOUND, MIN_ERROR_BOUND
from ..arrays import Group
from ..codes import APART, OVERLAPPING, TOUCHING, UNDECIDED
from ..exact_signs import Array, Signs
from .jit_cache import compiled

BLOCK_PAIRS = 1 << 17  # pairs a call: long enough that Python's share vanishes
TILE_PAIRS = 128  # pairs whose columns stay in the first-level cache between edges


def polygons(a: Group, b: Group, first: int, out: Signs) -> None:
    """Fill `out` with the relations of columns from `first` on; UNDECIDED within the float64 error bound."""
    clearance_kernel(len(a.x), len(b.x))(a.x, a.y, b.x, b.y, first, error_bound_of(a, b), out)


def error_bound_of(a: Group, b: Group) -> float:
    """Return the float64 error bound of any clearance of these groups; infinite where no bound is known."""
    found = (a.max_edge_component + b.max_edge_component) * (a.max_coordinate + b.max_coordinate) * ERROR_FACTOR_F64
    return found if MIN_ERROR_BOUND < found < MAX_ERROR_BOUND else np.inf


def clearance_kernel(va: int, vb: int) -> Callable[..., None]:
    """Return the compiled filter for polygons of va corners with polygons of vb corners."""
    return _unrolled_kernel(va, vb) if va <= 4 and vb <= 4 else _kernel_8 if va == vb == 8 else _kernel_any


@cache
def _unrolled_kernel(va: int, vb: int) -> Callable[..., None]:
    """Return the filter compiled for exactly va and vb corners, which the compiler unrolls and vectorises."""

    @compiled
    def kernel(ax: Array, ay: Array, bx: Array, by: Array, first: int, error_bound: float, out: Signs) -> None:
        """Fill `out` with the relations of columns from `first` on, by the largest clearance of each pair."""
        for k in range(out.size):
            i = np.uintp(first + k)  # unsigned: numba need not ask whether it counts from the end
            best = -np.inf
            for e in range(va):
                f = (e + 1) % va
                px, py = ax[e, i], ay[e, i]
                nx, ny = ay[f, i] - py, px - ax[f, i]
                least = np.inf
                for v in range(vb):
                    least = min(least, nx * bx[v, i] + ny * by[v, i])
                best = max(best, least - (nx * px + ny * py))
            for e in range(vb):
                f = (e + 1) % vb
                px, py = bx[e, i], by[e, i]
                nx, ny = by[f, i] - py, px - bx[f, i]
                least = np.inf
                for v in range(va):
                    least = min(least, nx * ax[v, i] + ny * ay[v, i])
                best = max(best, least - (nx * px + ny * py))
            out[k] = APART if best > error_bound else OVERLAPPING if best < -error_bound else UNDECIDED

    return kernel


@compiled
def _kernel_8(ax: Array, ay: Array, bx: Array, by: Array, first: int, error_bound: float, out: Signs) -> None:
    """Fill `out` with the relations of columns from `first` on, for two groups of eight corners."""
    best = np.empty(TILE_PAIRS)
    for start in range(0, out.size, TILE_PAIRS):
        n = min(TILE_PAIRS, out.size - start)
        for i in range(n):
            best[i] = -np.inf
        raise_clearance_8(ax, ay, bx, by, first + start, n, best)
        raise_clearance_8(bx, by, ax, ay, first + start, n, best)
        for i in range(n):
            out[start + i] = APART if best[i] > error_bound else OVERLAPPING if best[i] < -error_bound else UNDECIDED


@compiled
def raise_clearance_8(x: Array, y: Array, px: Array, py: Array, s: int, n: int, best: Array) -> None:
    """Raise `best` of n columns from s on to the clearance of 8 edges from 8 corners; row 9 may repeat the first."""
    t = s + n
    p0, p1, p2, p3, p4, p5, p6, p7 = (
        px[0, s:t],
        px[1, s:t],
        px[2, s:t],
        px[3, s:t],
        px[4, s:t],
        px[5, s:t],
        px[6, s:t],
        px[7, s:t],
    )
    q0, q1, q2, q3, q4, q5, q6, q7 = (
        py[0, s:t],
        py[1, s:t],
        py[2, s:t],
        py[3, s:t],
        py[4, s:t],
        py[5, s:t],
        py[6, s:t],
        py[7, s:t],
    )
    for e in range(8):
        f = (e + 1) % x.shape[0]
        x0, y0, x1, y1 = x[e, s:t], y[e, s:t], x[f, s:t], y[f, s:t]
        for i in range(n):
            a, b = y1[i] - y0[i], x0[i] - x1[i]
            low = min(
                min(a * p0[i] + b * q0[i], a * p1[i] + b * q1[i]), min(a * p2[i] + b * q2[i], a * p3[i] + b * q3[i])
            )
            top = min(
                min(a * p4[i] + b * q4[i], a * p5[i] + b * q5[i]), min(a * p6[i] + b * q6[i], a * p7[i] + b * q7[i])
            )
            best[i] = max(best[i], min(low, top) - (a * x0[i] + b * y0[i]))


@compiled
def _kernel_any(ax: Array, ay: Array, bx: Array, by: Array, first: int, error_bound: float, out: Signs) -> None:
    """Fill `out` with the relations of columns from `first` on, for any numbers of corners."""
    best, least, nx, ny = np.empty(TILE_PAIRS), np.empty(TILE_PAIRS), np.empty(TILE_PAIRS), np.empty(TILE_PAIRS)
    for start in range(0, out.size, TILE_PAIRS):
        n = min(TILE_PAIRS, out.size - start)
        for i in range(n):
            best[i] = -np.inf
        _raise_clearance(ax, ay, bx, by, first + start, n, best, least, nx, ny)
        _raise_clearance(bx, by, ax, ay, first + start, n, best, least, nx, ny)
        for i in range(n):
            out[start + i] = APART if best[i] > error_bound else OVERLAPPING if best[i] < -error_bound else UNDECIDED


@compiled
def _raise_clearance(
    x: Array, y: Array, px: Array, py: Array, s: int, n: int, best: Array, least: Array, nx: Array, ny: Array
) -> None:
    """Raise `best` of n columns from s on to the clearance of edges (x, y) from corners (px, py); rest: scratch."""
    t = s + n
    for e in range(x.shape[0]):
        f = (e + 1) % x.shape[0]
        x0, y0, x1, y1 = x[e, s:t], y[e, s:t], x[f, s:t], y[f, s:t]
        for i in range(n):
            nx[i], ny[i], least[i] = y1[i] - y0[i], x0[i] - x1[i], np.inf
        v = 0
        while v + 4 <= px.shape[0]:
            p0, p1, p2, p3 = px[v, s:t], px[v + 1, s:t], px[v + 2, s:t], px[v + 3, s:t]
            q0, q1, q2, q3 = py[v, s:t], py[v + 1, s:t], py[v + 2, s:t], py[v + 3, s:t]
            for i in range(n):
                a, b = nx[i], ny[i]
                low, top = (
                    min(a * p0[i] + b * q0[i], a * p1[i] + b * q1[i]),
                    min(a * p2[i] + b * q2[i], a * p3[i] + b * q3[i]),
                )
                least[i] = min(least[i], min(low, top))
            v += 4
        while v < px.shape[0]:
            p, q = px[v, s:t], py[v, s:t]
            for i in range(n):
                least[i] = min(least[i], nx[i] * p[i] + ny[i] * q[i])
            v += 1
        for i in range(n):
            best[i] = max(best[i], least[i] - (nx[i] * x0[i] + ny[i] * y0[i]))


def boxes(a: Group, b: Group, first: int, out: Signs) -> None:
    """Fill `out` with the exact relations of upright boxes, in columns from `first` on."""
    _boxes(a.x, a.y, b.x, b.y, first, out)


@compiled
def _ranges(a: float, c: float, p: float, r: float) -> tuple[float, float, float, float]:
    """Return the ends of two boxes' ranges on one axis (lower, upper, lower, upper), from opposite corners."""
    return min(a, c), max(a, c), min(p, r), max(p, r)


@compiled
def _boxes(ax: Array, ay: Array, bx: Array, by: Array, first: int, out: Signs) -> None:
    """Fill `out` with the exact relations of upright boxes, in columns from `first` on, by comparing sides."""
    for k in range(out.size):
        i = np.uintp(first + k)
        ax0, ax1, bx0, bx1 = _ranges(ax[0, i], ax[2, i], bx[0, i], bx[2, i])
        ay0, ay1, by0, by1 = _ranges(ay[0, i], ay[2, i], by[0, i], by[2, i])
        gap = max(max(ax0 - bx1, bx0 - ax1), max(ay0 - by1, by0 - ay1))
        out[k] = APART if gap > 0 else OVERLAPPING if gap < 0 else TOUCHING


@compiled
def circles(ax: Array, ay: Array, ar: Array, bx: Array, by: Array, br: Array, first: int, out: Signs) -> None:
    """Fill `out` with the relations of circles from `first` on, by squared distance and radii, or UNDECIDED."""
    for k in range(out.size):
        i = np.uintp(first + k)
        dx, dy, radius_sum = ax[i] - bx[i], ay[i] - by[i], ar[i] + br[i]
        distance, radius_squared = dx * dx + dy * dy, radius_sum * radius_sum
        size = distance + radius_squared
        error_bound = size * 2.0**-50 if size > MIN_SAFE_PRODUCT and size < MAX_SAFE_PRODUCT else np.inf
        gap = distance - radius_squared
        out[k] = APART if gap > error_bound else OVERLAPPING if gap < -error_bound else UNDECIDED


def circle_polygons(cx: Array, cy: Array, cr: Array, px: Array, py: Array, first: int, out: Signs) -> None:
    """Fill `out` with relations by the squared distance from center to boundary; UNDECIDED within its error bound."""
    (_circle_unrolled(len(px)) if len(px) <= 8 else _circle_general)(cx, cy, cr, px, py, first, out)


def _circle_kernel(corners: int | None) -> Callable[..., None]:
    """Return the filter of circles with polygons compiled for `corners` corners, or for any number (None)."""

    @compiled
    def kernel(cx: Array, cy: Array, cr: Array, px: Array, py: Array, first: int, out: Signs) -> None:
        """Fill `out` with the relations of circles (cx, cy, cr) and polygon columns (px, py) from `first` on."""
        count = px.shape[0] if corners is None else corners
        for k in range(out.size):
            i = np.uintp(first + k)  # unsigned: numba need not ask whether it counts from the end
            x0, y0, r = cx[i], cy[i], cr[i]
            far = r
            for v in range(count):
                far = max(far, max(abs(px[v, i] - x0), abs(py[v, i] - y0)))
            error_bound, side_error = far * far * 2.0**-46, far * 2.0**-48
            inside, safe, nearest = (
                True,
                error_bound > MIN_SAFE_PRODUCT and error_bound < MAX_SAFE_PRODUCT * 2.0**-46,
                np.inf,
            )
            for v in range(count):
                w = (v + 1) % count
                dx, dy = px[w, i] - px[v, i], py[w, i] - py[v, i]
                x, y, u, z = px[v, i] - x0, py[v, i] - y0, px[w, i] - x0, py[w, i] - y0
                turn = x * dy - y * dx
                tolerance = (abs(dx) + abs(dy)) * side_error
                along, square = -(x * dx + y * dy), dx * dx + dy * dy
                safe = safe & (square > MIN_SAFE_PRODUCT)
                foot = turn / square * turn
                distance = x * x + y * y if along <= 0 else u * u + z * z if along >= square else foot
                inside = inside & (turn > tolerance)
                nearest = min(nearest, distance)  # of edges that face away too: none lies nearer than the nearest
            radius_squared = r * r
            over = inside | (nearest < radius_squared - error_bound)
            # a center inside, taken for one on an edge's line, has the boundary within twice the tolerance
            apart = nearest > radius_squared + error_bound
            out[k] = UNDECIDED if not safe else OVERLAPPING if over else APART if apart else UNDECIDED

    return kernel


_circle_unrolled = cache(_circle_kernel)
_circle_general = _circle_kernel(None)
