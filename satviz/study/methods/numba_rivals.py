"""Rival methods compiled with numba, each written to be fast.

They stay beside the models of `satviz/advice` because their own speed and accuracy are what the study measures: each
gives hit or no hit, with nothing recorded and nothing evaluated twice, where `advice.kernels` gives relations of any
pairs of a batch.

`sat_kernel` and `gjk_kernel` are compiled for the numbers of corners, so that the compiler unrolls their loops.  SAT
and the bounding volumes have no branch: the compiler computes several pairs at once, in float32 twice as many as in
float64.  GJK and the methods for many corners end early and go pair by pair.

All kernels take polygons with one number of corners, counter-clockwise, as columns:
    ax, ay, bx, by   (V, N) coordinates of A's and of B's corners: [v, i] is corner v of pair i
    x, y and p, q    the coordinates of the polygon that owns the edges, and of the other polygon
    e, f             an edge's first and last corner; nx, ny its outward normal
    out              (N,) int8, written by the kernel: 1 for a hit, 0 for apart
"""

from collections.abc import Callable
from functools import cache
from typing import Any, TypeVar, cast

import numpy as np
from numba import njit
from numpy.typing import NDArray

from ...batch.arrays import TILE_SHAPES
from ...batch.codes import APART
from ...batch.with_numba.filter import clearance_kernel
from ...batch.with_numba.jit_cache import compiled, inlined

Kernel = TypeVar("Kernel", bound=Callable[..., object])
Array = NDArray[Any]
Out = NDArray[np.int8]
MAX_GJK_STEPS = 64  # rounding can make GJK cycle
# corners whose loops the compiler unrolls completely; with more it computes pair by pair, not in lanes
MAX_FULLY_UNROLLED = 6
MAX_OWN_KERNEL = 8  # corners up to which each count has a kernel compiled for it
PLAIN, UNIT, WITH_TOLERANCE = 0, 1, 2  # forms of `sat_kernel`


def _merged(kernel: Kernel) -> Kernel:
    """Decorate a function that LLVM merges into its callers: the numbers they pass become constants and loops unroll.

    `inlined` merges before LLVM sees the code; then the loops are not vectorised.
    """
    return cast(Kernel, njit(forceinline=True, error_model="numpy")(kernel))


@compiled
def read_once(columns: NDArray[np.int64]) -> int:
    """Return the XOR of all numbers, each read once: no method can take less time than this reading.

    The numbers are read as integers, because the compiler may reorder those.
    """
    total = 0
    for k in range(columns.size):
        total ^= columns[k]
    return total


# -- the corners of raw arrays ----------------------------------------------------------------------------------


@cache
def corners_kernel(corners: int | None) -> Callable[..., None]:
    """Return the kernel(rings, first, x, y) for so many corners; None for any number.

    It writes the corners of (N, V, 2) rings, from ring `first` on, into (V, n) columns, for up to n shapes.
    """

    @compiled
    def kernel(rings: Array, first: int, x: Array, y: Array) -> None:
        """Write corner v of ring first + k into x[v, k] and y[v, k], in their float format."""
        count = rings.shape[1] if corners is None else corners
        for k in range(min(x.shape[1], len(rings) - first)):
            i, j = np.uintp(first + k), np.uintp(k)
            for v in range(count):
                x[v, j], y[v, j] = rings[i, v, 0], rings[i, v, 1]

    return kernel


# -- bounding volumes, prepared once for each shape --------------------------------------------------------------------


@cache
def bounding_circles(corners: int | None) -> Callable[..., Array]:
    """Return a kernel(x, y) that returns (3, N) center x, center y, radius of bounding circles.

    A center is the mean of the corners.  `corners`: their number, None for any; x, y: (V, N) columns.
    """

    @compiled
    def kernel(x: Array, y: Array) -> Array:
        """Return the (3, N) bounding circles of the polygons."""
        count, kept = x.shape[0] if corners is None else corners, np.empty((3, x.shape[1]))
        for k in range(x.shape[1]):
            i = np.uintp(k)
            cx, cy, far = 0.0, 0.0, 0.0
            for v in range(count):
                cx, cy = cx + x[v, i], cy + y[v, i]
            cx, cy = cx / count, cy / count
            for v in range(count):
                dx, dy = x[v, i] - cx, y[v, i] - cy
                far = max(far, dx * dx + dy * dy)
            kept[0, i], kept[1, i], kept[2, i] = cx, cy, np.sqrt(far)
        return kept

    return kernel


@compiled
def circles_hit(a: Array, b: Array, out: Out) -> None:
    """Write for each pair whether its (3, N) bounding circles hit: centers no further apart than the sum of radii."""
    for i in range(out.size):
        dx, dy, radius_sum = a[0, i] - b[0, i], a[1, i] - b[1, i], a[2, i] + b[2, i]
        out[i] = dx * dx + dy * dy <= radius_sum * radius_sum


@cache
def bounding_boxes(corners: int | None) -> Callable[..., Array]:
    """Return a kernel(x, y) that returns (4, N) low x, high x, low y, high y: each polygon's bounding box.

    `corners`: the number of corners, None for any; x, y: (V, N) columns.
    """

    @compiled
    def kernel(x: Array, y: Array) -> Array:
        """Return the bounding boxes of the polygons in this form."""
        count, kept = x.shape[0] if corners is None else corners, np.empty((4, x.shape[1]))
        for k in range(x.shape[1]):
            i = np.uintp(k)
            x0 = x1 = x[0, i]
            y0 = y1 = y[0, i]
            for v in range(1, count):
                x0, x1 = min(x0, x[v, i]), max(x1, x[v, i])
                y0, y1 = min(y0, y[v, i]), max(y1, y[v, i])
            kept[0, i], kept[1, i], kept[2, i], kept[3, i] = x0, x1, y0, y1
        return kept

    return kernel


@compiled
def boxes_hit(a: Array, b: Array, out: Out) -> None:
    """Write for each pair whether its (4, N) bounding boxes meet; a loop without branches vectorises."""
    for i in range(out.size):
        out[i] = (a[1, i] >= b[0, i]) & (b[1, i] >= a[0, i]) & (a[3, i] >= b[2, i]) & (b[3, i] >= a[2, i])


@cache
def oriented_boxes(corners: int | None) -> Callable[..., Array]:
    """Return a kernel(x, y) that returns oriented bounding boxes along each polygon's longest edge.

    They are (6, N): center x, center y, axis x, axis y (a unit vector), half length, half width.  `corners`: the number
    of corners, None for any; x, y: (V, N) columns.
    """

    @compiled
    def kernel(x: Array, y: Array) -> Array:
        """Return the bounding boxes of the polygons in this form."""
        count, kept = x.shape[0] if corners is None else corners, np.empty((6, x.shape[1]))
        for k in range(x.shape[1]):
            i = np.uintp(k)
            ux, uy, longest = 1.0, 0.0, 0.0
            for v in range(count):
                w = (v + 1) % count
                ex, ey = x[w, i] - x[v, i], y[w, i] - y[v, i]
                square = ex * ex + ey * ey
                longer = square > longest
                ux, uy, longest = ex if longer else ux, ey if longer else uy, square if longer else longest
            ux, uy = ux / np.sqrt(longest), uy / np.sqrt(longest)
            s0, s1, t0, t1 = np.inf, -np.inf, np.inf, -np.inf
            for v in range(count):
                s, t = x[v, i] * ux + y[v, i] * uy, y[v, i] * ux - x[v, i] * uy
                s0, s1, t0, t1 = min(s0, s), max(s1, s), min(t0, t), max(t1, t)
            s, t = (s0 + s1) / 2, (t0 + t1) / 2
            kept[0, i], kept[1, i], kept[2, i], kept[3, i] = s * ux - t * uy, s * uy + t * ux, ux, uy
            kept[4, i], kept[5, i] = (s1 - s0) / 2, (t1 - t0) / 2
        return kept

    return kernel


@compiled
def oriented_boxes_hit(a: Array, b: Array, out: Out) -> None:
    """Write for each pair whether its (6, N) oriented bounding boxes meet on their four axes.

    Source: Gottschalk, Lin and Manocha (1996).
    """
    for i in range(out.size):
        dx, dy = b[0, i] - a[0, i], b[1, i] - a[1, i]
        ux, uy, vx, vy = a[2, i], a[3, i], b[2, i], b[3, i]
        c, s = abs(ux * vx + uy * vy), abs(ux * vy - uy * vx)
        p, q, r, t = a[4, i], a[5, i], b[4, i], b[5, i]
        on_a = (abs(dx * ux + dy * uy) <= p + r * c + t * s) & (abs(dy * ux - dx * uy) <= q + r * s + t * c)
        on_b = (abs(dx * vx + dy * vy) <= r + p * c + q * s) & (abs(dy * vx - dx * vy) <= t + p * s + q * c)
        out[i] = on_a & on_b


# -- complete methods --------------------------------------------------------------------------------


def unrolled(corners: int) -> int | None:
    """Return the number of corners that a kernel is compiled for, or None for the kernel that takes any number."""
    return corners if corners <= MAX_OWN_KERNEL else None


@_merged
def _largest_clearance(
    x: Array, y: Array, p: Array, q: Array, i: Any, corners: int, others: int, form: int, tolerance: float
) -> float:
    """Return the largest clearance of the other polygon over the edges of polygon i; positive if an edge separates.

    x, y: the edges' owner, p, q: the other polygon, with `corners` and `others` corners.  `form`: UNIT clearances are
    in scene units; PLAIN and WITH_TOLERANCE ones are multiplied by the edge's length, the latter after `tolerance`
    scene units are taken off.
    """
    best = x.dtype.type(0)  # all numbers have the format of the columns
    for e in range(corners):
        f = (e + 1) % corners
        ex, ey = x[e, i], y[e, i]
        nx, ny = y[f, i] - ey, ex - x[f, i]
        if form == UNIT:
            inverse = x.dtype.type(1) / np.sqrt(nx * nx + ny * ny)  # a product is quicker than another division
            nx, ny = nx * inverse, ny * inverse
        least = nx * p[0, i] + ny * q[0, i]
        for v in range(1, others):
            least = min(least, nx * p[v, i] + ny * q[v, i])
        gap = least - (nx * ex + ny * ey)
        if form == WITH_TOLERANCE:
            gap = gap - tolerance * np.sqrt(nx * nx + ny * ny)
        best = gap if e == 0 else max(best, gap)
    return best  # type: ignore[no-any-return]


@cache
def sat_kernel(va: int | None, vb: int | None, form: int) -> Callable[..., None]:
    """Return SAT on edge normals for va and vb corners: kernel(ax, ay, bx, by, tolerance, out).

    The columns are of float64 or of float32, and `tolerance` is a number of the same format.
    `form`: PLAIN normals, UNIT normals, or WITH_TOLERANCE: a gap up to `tolerance` scene units counts as a hit.
    """

    @compiled
    def kernel(ax: Array, ay: Array, bx: Array, by: Array, tolerance: float, out: Out) -> None:
        """Write for each pair whether no edge has all corners of the other polygon beyond it."""
        count_a, count_b = ax.shape[0] if va is None else va, bx.shape[0] if vb is None else vb
        for k in range(out.size):
            i = np.uintp(k)  # unsigned: numba need not ask whether it counts from the end
            gap_a = _largest_clearance(ax, ay, bx, by, i, count_a, count_b, form, tolerance)
            gap_b = _largest_clearance(bx, by, ax, ay, i, count_b, count_a, form, tolerance)
            out[i] = max(gap_a, gap_b) <= 0

    return kernel


def plain_sat(va: int, vb: int) -> Callable[..., None]:
    """Return plain SAT in float64 at its fastest for va and vb corners: kernel(ax, ay, bx, by, out).

    For few corners it is `sat_kernel`; for more it is the float filter of satviz itself, without its error bounds.
    """
    if max(va, vb) <= MAX_FULLY_UNROLLED:
        kernel = sat_kernel(va, vb, PLAIN)
        return lambda ax, ay, bx, by, out: kernel(ax, ay, bx, by, 0.0, out)
    gaps = clearance_kernel(va, vb)

    def hits(ax: Array, ay: Array, bx: Array, by: Array, out: Out) -> None:
        """Write for each pair whether no clearance is above 0; a touching pair is a hit, as in `sat_kernel`."""
        gaps(ax, ay, bx, by, 0, np.zeros(-(-out.size // TILE_SHAPES)), out)
        out[:] = out != APART

    return hits


@inlined
def _support(x: Array, y: Array, i: Any, corners: int, dx: float, dy: float) -> tuple[float, float]:
    """Return the corner of polygon i that is furthest along (dx, dy)."""
    furthest, sx, sy = x[0, i] * dx + y[0, i] * dy, x[0, i], y[0, i]
    for v in range(1, corners):
        landing = x[v, i] * dx + y[v, i] * dy
        further = landing > furthest
        furthest = landing if further else furthest
        sx, sy = x[v, i] if further else sx, y[v, i] if further else sy
    return sx, sy


@cache
def gjk_kernel(va: int | None, vb: int | None) -> Callable[..., None]:
    """Return GJK on floats for va and vb corners (None: any number): kernel(ax, ay, bx, by, out).

    Source: Gilbert, Johnson and Keerthi (1988).
    """

    @compiled
    def kernel(ax: Array, ay: Array, bx: Array, by: Array, out: Out) -> None:
        """Write for each pair whether B - A contains the origin."""
        count_a, count_b = ax.shape[0] if va is None else va, bx.shape[0] if vb is None else vb
        for k in range(out.size):
            i = np.uintp(k)
            dx = (ax[0, i] + ax[count_a // 2, i]) - (bx[0, i] + bx[count_b // 2, i])  # from B's middle to A's
            dy = (ay[0, i] + ay[count_a // 2, i]) - (by[0, i] + by[count_b // 2, i])
            ux, uy, vx, vy, wx, wy, corners = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0
            hit = 1
            for _ in range(MAX_GJK_STEPS):
                if corners > 0 and dx == 0 and dy == 0:
                    break
                px, py = _support(bx, by, i, count_b, dx, dy)
                qx, qy = _support(ax, ay, i, count_a, -dx, -dy)
                px, py = px - qx, py - qy  # the support point of B - A
                if px * dx + py * dy < 0:
                    hit = 0
                    break
                if corners == 0:
                    ux, uy, corners = px, py, 1
                    dx, dy = -ux, -uy
                    continue
                if corners == 1:
                    vx, vy, corners = px, py, 2
                else:
                    wx, wy = px, py
                    # beyond which of the two edges at the new corner does the origin lie?
                    side = 1.0 if (vx - ux) * (wy - uy) - (vy - uy) * (wx - ux) > 0 else -1.0
                    if side * (vx * wy - vy * wx) < 0:
                        ux, uy = wx, wy
                    elif side * (wx * uy - wy * ux) < 0:
                        vx, vy = wx, wy
                    else:
                        break
                ex, ey = vx - ux, vy - uy
                dx, dy = -ey, ex
                if dx * ux + dy * uy > 0:
                    dx, dy = -dx, -dy
            out[i] = hit

    return kernel


# -- methods for many corners --------------------------------------------------------------------------------


@compiled
def support_search_sat(ax: Array, ay: Array, bx: Array, by: Array, out: Out) -> None:
    """Write for each pair whether it hits, by SAT that finds support points by binary search: V log V steps."""
    for i in range(out.size):
        out[i] = not (_edge_clears_lowest(ax, ay, bx, by, i) or _edge_clears_lowest(bx, by, ax, ay, i))


@compiled
def _edge_clears_lowest(x: Array, y: Array, p: Array, q: Array, i: int) -> bool:
    """Return whether an edge of (x, y) clears (p, q) in pair i: the lowest corner along its normal lies beyond it."""
    for e in range(x.shape[0]):
        f = e + 1 if e + 1 < x.shape[0] else 0
        nx, ny = y[f, i] - y[e, i], x[e, i] - x[f, i]
        k = _lowest_corner(p, q, i, nx, ny)
        if nx * (p[k, i] - x[e, i]) + ny * (q[k, i] - y[e, i]) > 0:
            return True
    return False


@compiled
def _edge_rise(p: Array, q: Array, i: int, v: int, nx: float, ny: float) -> float:
    """Return the component along (nx, ny) of the edge from corner v of (p, q) to the next, in pair i."""
    w = v + 1 if v + 1 < p.shape[0] else 0
    return float(nx * (p[w, i] - p[v, i]) + ny * (q[w, i] - q[v, i]))


@compiled
def _lowest_corner(p: Array, q: Array, i: int, nx: float, ny: float) -> int:
    """Return the index of the corner lowest along (nx, ny) in pair i, by binary search (O'Rourke 1998).

    Along a convex outline the heights fall, then rise, once.
    """
    low, high = 0, p.shape[0]
    falls = _edge_rise(p, q, i, 0, nx, ny) < 0
    if not falls and _edge_rise(p, q, i, p.shape[0] - 1, nx, ny) <= 0:
        return 0
    while high - low > 1:
        mid: int = (low + high) // 2
        mid_falls = _edge_rise(p, q, i, mid, nx, ny) < 0
        if not mid_falls and _edge_rise(p, q, i, mid - 1, nx, ny) <= 0:
            return mid
        lower = nx * (p[mid, i] - p[low, i]) + ny * (q[mid, i] - q[low, i]) < 0
        if (falls and (not mid_falls or not lower)) or (not falls and not mid_falls and lower):
            high = mid
        else:
            low, falls = mid, mid_falls
    return low if _edge_rise(p, q, i, low, nx, ny) >= 0 else (low + 1) % p.shape[0]


@compiled
def calipers(ax: Array, ay: Array, bx: Array, by: Array, out: Out) -> None:
    """Write for each pair whether it hits, by rotating calipers: once around both outlines in order of edge angles.

    This visits the edges of the difference A - B in order; the shapes hit where the origin lies inside all of them.
    """
    va, vb = ax.shape[0], bx.shape[0]
    for i in range(out.size):
        k, m = 0, 0
        for v in range(va):
            if ay[v, i] < ay[k, i] or (ay[v, i] == ay[k, i] and ax[v, i] < ax[k, i]):
                k = v
        for v in range(vb):
            if by[v, i] > by[m, i] or (by[v, i] == by[m, i] and bx[v, i] > bx[m, i]):
                m = v
        done_a, done_b = 0, 0
        out[i] = 1
        while done_a < va or done_b < vb:
            px, py = ax[k, i] - bx[m, i], ay[k, i] - by[m, i]
            k2, m2 = (k + 1) % va, (m + 1) % vb
            ex, ey = ax[k2, i] - ax[k, i], ay[k2, i] - ay[k, i]
            fx, fy = bx[m, i] - bx[m2, i], by[m, i] - by[m2, i]
            if done_b == vb or (done_a < va and ex * fy - ey * fx >= 0):
                k, done_a = k2, done_a + 1
            else:
                ex, ey, m, done_b = fx, fy, m2, done_b + 1
            if ey * px - ex * py < 0:
                out[i] = 0
                break
