"""Rival methods compiled with numba, written as a reader of the literature would write them.

They stay beside the models of `satviz/advice` because their own speed and accuracy are what the study measures: each
gives hit or no hit, with nothing recorded and nothing evaluated twice, where `advice.kernels` gives relations of any
pairs of a batch.  The method is not the only difference between two times.  The compiler vectorises the enclosing
circles, both kinds of boxes and satviz's own kernel; the loops that can end early (textbook SAT, orientation SAT, GJK,
ranges on many directions) go pair by pair.

All kernels take polygons with one number of corners, counter-clockwise, as columns:
    ax, ay, bx, by   (V, N) coordinates of A's and of B's corners: [v, i] is corner v of pair i
    x, y and p, q    the coordinates of the polygon that owns the edges, and of the other polygon
    e, f             an edge's first and last corner; nx, ny its outward normal
    out              (N,) int8, written by the kernel: 1 for a hit, 0 for apart
"""

import numpy as np
from numpy.typing import NDArray

from ...batch.exact_signs import UNKNOWN
from ...batch.with_numba.exact import MAX_TERMS, orient, sign_of_sum, two_product
from ...batch.with_numba.jit_cache import compiled

Array = NDArray[np.float64]
Out = NDArray[np.int8]
MAX_GJK_STEPS = 64  # rounding can make GJK cycle
# error bounds of `orientation_sat`, as a factor of |left| + |right|, the sizes of the two products
NO_ERROR_BOUND = -1.0  # the sign of the float is taken as it is
ERRBOUND_A = (3 + 16 * 2.0**-53) * 2.0**-53  # (3 + 16 u) u with u = 2**-53: Shewchuk (1997), first stage
ALWAYS_EXACT = np.inf  # no float is certain, so every sign is computed exactly


@compiled
def read_once(columns: NDArray[np.int64]) -> int:
    """Return the XOR of all numbers, each read once: no method can take less time than this reading.

    The numbers are read as integers, because the compiler may reorder those.
    """
    total = 0
    for k in range(columns.size):
        total ^= columns[k]
    return total


# -- bounding volumes, prepared once for each shape --------------------------------------------------------------------


@compiled
def enclosing_circles(x: Array, y: Array) -> Array:
    """Return rows (center x, center y, radius): for each polygon a circle about its corners' mean."""
    kept = np.empty((3, x.shape[1]))
    for i in range(x.shape[1]):
        cx, cy, far = 0.0, 0.0, 0.0
        for v in range(x.shape[0]):
            cx, cy = cx + x[v, i], cy + y[v, i]
        cx, cy = cx / x.shape[0], cy / x.shape[0]
        for v in range(x.shape[0]):
            far = max(far, np.hypot(x[v, i] - cx, y[v, i] - cy))
        kept[0, i], kept[1, i], kept[2, i] = cx, cy, far
    return kept


@compiled
def circles_hit(a: Array, b: Array, out: Out) -> None:
    """Write for each pair whether its circles hit: centers no further apart than the sum of the radii."""
    for i in range(out.size):
        dx, dy, radius_sum = a[0, i] - b[0, i], a[1, i] - b[1, i], a[2, i] + b[2, i]
        out[i] = dx * dx + dy * dy <= radius_sum * radius_sum


@compiled
def ranges_on_directions(x: Array, y: Array, directions: Array) -> Array:
    """Return each polygon's range on each of the (k, 2) directions, as two rows (low, high) for each."""
    kept = np.empty((2 * len(directions), x.shape[1]))
    for k in range(len(directions)):
        for i in range(x.shape[1]):
            low, high = np.inf, -np.inf
            for v in range(x.shape[0]):
                landing = x[v, i] * directions[k, 0] + y[v, i] * directions[k, 1]
                low, high = min(low, landing), max(high, landing)
            kept[2 * k, i], kept[2 * k + 1, i] = low, high
    return kept


@compiled
def ranges_hit(a: Array, b: Array, out: Out) -> None:
    """Write for each pair whether its ranges, prepared by `ranges_on_directions`, meet on every direction."""
    for i in range(out.size):
        out[i] = 1
        for k in range(0, a.shape[0], 2):
            if a[k + 1, i] < b[k, i] or b[k + 1, i] < a[k, i]:
                out[i] = 0
                break


@compiled
def boxes_hit(a: Array, b: Array, out: Out) -> None:
    """Write for each pair whether its prepared ranges on x and y meet; a loop without branches vectorises."""
    for i in range(out.size):
        out[i] = (a[1, i] >= b[0, i]) & (b[1, i] >= a[0, i]) & (a[3, i] >= b[2, i]) & (b[3, i] >= a[2, i])


@compiled
def oriented_boxes(x: Array, y: Array) -> Array:
    """Return rows (center x, center y, axis x, axis y, half length, half width): boxes along the longest edge."""
    kept = np.empty((6, x.shape[1]))
    for i in range(x.shape[1]):
        ux, uy, longest = 1.0, 0.0, 0.0
        for v in range(x.shape[0]):
            w = v + 1 if v + 1 < x.shape[0] else 0
            ex, ey = x[w, i] - x[v, i], y[w, i] - y[v, i]
            if ex * ex + ey * ey > longest:
                ux, uy, longest = ex, ey, ex * ex + ey * ey
        ux, uy = ux / np.sqrt(longest), uy / np.sqrt(longest)
        s0, s1, t0, t1 = np.inf, -np.inf, np.inf, -np.inf
        for v in range(x.shape[0]):
            s, t = x[v, i] * ux + y[v, i] * uy, y[v, i] * ux - x[v, i] * uy
            s0, s1, t0, t1 = min(s0, s), max(s1, s), min(t0, t), max(t1, t)
        s, t = (s0 + s1) / 2, (t0 + t1) / 2
        kept[0, i], kept[1, i], kept[2, i], kept[3, i] = s * ux - t * uy, s * uy + t * ux, ux, uy
        kept[4, i], kept[5, i] = (s1 - s0) / 2, (t1 - t0) / 2
    return kept


@compiled
def oriented_boxes_hit(a: Array, b: Array, out: Out) -> None:
    """Write for each pair whether its boxes meet on their four axes (Gottschalk, Lin and Manocha 1996)."""
    for i in range(out.size):
        dx, dy = b[0, i] - a[0, i], b[1, i] - a[1, i]
        ux, uy, vx, vy = a[2, i], a[3, i], b[2, i], b[3, i]
        c, s = abs(ux * vx + uy * vy), abs(ux * vy - uy * vx)
        p, q, r, t = a[4, i], a[5, i], b[4, i], b[5, i]
        out[i] = not (
            abs(dx * ux + dy * uy) > p + r * c + t * s
            or abs(dy * ux - dx * uy) > q + r * s + t * c
            or abs(dx * vx + dy * vy) > r + p * c + q * s
            or abs(dy * vx - dx * vy) > t + p * s + q * c
        )


# -- complete methods --------------------------------------------------------------------------------


@compiled
def textbook_sat(ax: Array, ay: Array, bx: Array, by: Array, unit: bool, tolerance: float, out: Out) -> None:
    """Write hits by SAT as articles write it: no hit if a normal has a gap larger than `tolerance`.

    `unit`: divide each normal by its length first.
    """
    for i in range(out.size):
        out[i] = not (
            _has_separating_normal(ax, ay, bx, by, i, unit, tolerance)
            or _has_separating_normal(bx, by, ax, ay, i, unit, tolerance)
        )


@compiled
def _has_separating_normal(x: Array, y: Array, p: Array, q: Array, i: int, unit: bool, tolerance: float) -> bool:
    """Return whether an edge normal of (x, y) leaves a gap to (p, q) above `tolerance`, in pair i."""
    for e in range(x.shape[0]):
        f = e + 1 if e + 1 < x.shape[0] else 0
        nx, ny = y[f, i] - y[e, i], x[e, i] - x[f, i]
        if unit:
            length = np.sqrt(nx * nx + ny * ny)
            nx, ny = nx / length, ny / length
        own_low, own_high = nx * x[0, i] + ny * y[0, i], nx * x[0, i] + ny * y[0, i]
        other_low, other_high = np.inf, -np.inf
        for v in range(1, x.shape[0]):
            landing = nx * x[v, i] + ny * y[v, i]
            own_low, own_high = min(own_low, landing), max(own_high, landing)
        for v in range(p.shape[0]):
            landing = nx * p[v, i] + ny * q[v, i]
            other_low, other_high = min(other_low, landing), max(other_high, landing)
        if max(other_low - own_high, own_low - other_high) > tolerance:
            return True
    return False


@compiled
def orientation_sat(ax: Array, ay: Array, bx: Array, by: Array, error_factor: float, out: Out) -> None:
    """Write hits by orientation tests: a miss if all of one polygon is strictly beyond an edge of the other.

    `error_factor`: NO_ERROR_BOUND, ERRBOUND_A or ALWAYS_EXACT.
    """
    terms = np.empty(MAX_TERMS)
    for i in range(out.size):
        out[i] = not (
            _edge_clears(ax, ay, bx, by, i, error_factor, terms) or _edge_clears(bx, by, ax, ay, i, error_factor, terms)
        )


@compiled
def _edge_clears(x: Array, y: Array, p: Array, q: Array, i: int, error_factor: float, terms: Array) -> bool:
    """Return whether all corners of (p, q) lie strictly beyond some edge of (x, y); `terms`: work space."""
    for e in range(x.shape[0]):
        f = e + 1 if e + 1 < x.shape[0] else 0
        beyond = True
        for v in range(p.shape[0]):
            left = (x[f, i] - x[e, i]) * (q[v, i] - y[e, i])
            right = (y[f, i] - y[e, i]) * (p[v, i] - x[e, i])
            side = left - right
            if not abs(side) > error_factor * (abs(left) + abs(right)):
                if error_factor == ALWAYS_EXACT:
                    sign = _exact_orientation(x[e, i], y[e, i], x[f, i], y[f, i], p[v, i], q[v, i], terms)
                else:
                    sign = orient(x[e, i], y[e, i], x[f, i], y[f, i], p[v, i], q[v, i], terms)
                # where a product leaves the range of float64 the exact sign is unknown: keep the float
                side = side if sign == UNKNOWN else float(sign)
            if side >= 0:
                beyond = False
                break
        if beyond:
            return True
    return False


@compiled
def _exact_orientation(px: float, py: float, qx: float, qy: float, rx: float, ry: float, terms: Array) -> int:
    """Return the exact sign of the orientation of points p, q, r from six products; `terms`: work space."""
    for k, (a, b) in enumerate(((px, qy), (-py, qx), (qx, ry), (-qy, rx), (rx, py), (-ry, px))):
        terms[k], terms[6 + k] = two_product(a, b)
    return sign_of_sum(terms, MAX_TERMS)


@compiled
def gjk(ax: Array, ay: Array, bx: Array, by: Array, out: Out) -> None:
    """Write hits by GJK on floats (Gilbert, Johnson and Keerthi 1988): whether B - A contains the origin."""
    for i in range(out.size):
        dx, dy = bx[0, i] - ax[0, i], by[0, i] - ay[0, i]
        ux, uy = _support_of_difference(ax, ay, bx, by, i, -dx, -dy)
        vx, vy, wx, wy, corners = 0.0, 0.0, 0.0, 0.0, 1
        dx, dy = -ux, -uy
        out[i] = 1
        for _ in range(MAX_GJK_STEPS):
            if dx == 0 and dy == 0:
                break
            px, py = _support_of_difference(ax, ay, bx, by, i, dx, dy)
            if px * dx + py * dy < 0:
                out[i] = 0
                break
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


@compiled
def _support_of_difference(
    ax: Array, ay: Array, bx: Array, by: Array, i: int, dx: float, dy: float
) -> tuple[float, float]:
    """Return the support point of B - A in pair i: its corner furthest along (dx, dy)."""
    furthest, k = -np.inf, 0
    for v in range(ax.shape[0]):
        landing = -dx * ax[v, i] - dy * ay[v, i]
        if landing > furthest:
            furthest, k = landing, v
    furthest, m = -np.inf, 0
    for v in range(bx.shape[0]):
        landing = dx * bx[v, i] + dy * by[v, i]
        if landing > furthest:
            furthest, m = landing, v
    return bx[m, i] - ax[k, i], by[m, i] - ay[k, i]


# -- methods for many corners --------------------------------------------------------------------------------


@compiled
def support_search_sat(ax: Array, ay: Array, bx: Array, by: Array, out: Out) -> None:
    """Write hits by SAT that finds the lowest corner along each normal by binary search: V log V steps."""
    for i in range(out.size):
        out[i] = not (_edge_clears_lowest(ax, ay, bx, by, i) or _edge_clears_lowest(bx, by, ax, ay, i))


@compiled
def _edge_clears_lowest(x: Array, y: Array, p: Array, q: Array, i: int) -> bool:
    """Return whether the lowest corner of (p, q), and so each, lies strictly beyond some edge of (x, y)."""
    for e in range(x.shape[0]):
        f = e + 1 if e + 1 < x.shape[0] else 0
        nx, ny = y[f, i] - y[e, i], x[e, i] - x[f, i]
        k = _lowest_corner(p, q, i, nx, ny)
        if nx * (p[k, i] - x[e, i]) + ny * (q[k, i] - y[e, i]) > 0:
            return True
    return False


@compiled
def _edge_rise(p: Array, q: Array, i: int, v: int, nx: float, ny: float) -> float:
    """Return how far the edge from corner v to the next rises along (nx, ny); negative where it falls."""
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
    """Write hits by rotating calipers: go around both outlines once, in the order of the edges' angles.

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
