"""Methods compiled with numba: one language for all.

Not only the method differs between them.  The bounding circles and boxes here, and satviz's own kernel, are vectorised
by the compiler; the loops that end early (textbook SAT, turns, GJK, ranges on many axes) go pair by pair.

Polygons of one number of corners, counter-clockwise: (V, N) x and y of each side, column by column.
Every kernel ends in `out`: 1 for a hit, 0 for apart.
"""

import numpy as np
from numpy.typing import NDArray

from ...batch.exact_signs import UNKNOWN
from ...batch.with_numba.exact import MAX_TERMS, orient, sign_of_sum, two_product
from ...batch.with_numba.jit_cache import compiled

Array = NDArray[np.float64]
Out = NDArray[np.int8]
MOST_TURNS = 64
# what `turns` grants for rounding, as a share of the products' sizes
FLOAT = -1.0  # nothing: the float's sign stands
ADAPTIVE = (3 + 16 * 2.0**-53) * 2.0**-53  # Shewchuk (1997)
EXACT = np.inf  # never enough


@compiled
def reading(columns: NDArray[np.int64]) -> int:
    """Every number once, as integers, which the compiler may take in any order: what no method can undercut."""
    total = 0
    for k in range(columns.size):
        total ^= columns[k]
    return total


# -- bounds, kept with the shapes --------------------------------------------------------------------


@compiled
def around(x: Array, y: Array) -> Array:
    """(x, y, radius) rows of circles about the means of the corners that hold them all."""
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
def circles(a: Array, b: Array, out: Out) -> None:
    """Are the centers within the sum of the radii?"""
    for i in range(out.size):
        dx, dy, reach = a[0, i] - b[0, i], a[1, i] - b[1, i], a[2, i] + b[2, i]
        out[i] = dx * dx + dy * dy <= reach * reach


@compiled
def ranges(x: Array, y: Array, ways: Array) -> Array:
    """Rows of least and most along each of k directions (k, 2)."""
    kept = np.empty((2 * len(ways), x.shape[1]))
    for k in range(len(ways)):
        for i in range(x.shape[1]):
            low, high = np.inf, -np.inf
            for v in range(x.shape[0]):
                at = x[v, i] * ways[k, 0] + y[v, i] * ways[k, 1]
                low, high = min(low, at), max(high, at)
            kept[2 * k, i], kept[2 * k + 1, i] = low, high
    return kept


@compiled
def ranges_overlap(a: Array, b: Array, out: Out) -> None:
    """Do kept ranges overlap or touch on every direction?"""
    for i in range(out.size):
        out[i] = 1
        for k in range(0, a.shape[0], 2):
            if a[k + 1, i] < b[k, i] or b[k + 1, i] < a[k, i]:
                out[i] = 0
                break


@compiled
def boxes_overlap(a: Array, b: Array, out: Out) -> None:
    """The same on two directions, without a branch that the processor would have to guess."""
    for i in range(out.size):
        out[i] = (a[1, i] >= b[0, i]) & (b[1, i] >= a[0, i]) & (a[3, i] >= b[2, i]) & (b[3, i] >= a[2, i])


@compiled
def oriented(x: Array, y: Array) -> Array:
    """(center x, y, axis x, y, half length, half width) rows of boxes along the longest edge."""
    kept = np.empty((6, x.shape[1]))
    for i in range(x.shape[1]):
        ux, uy, most = 1.0, 0.0, 0.0
        for v in range(x.shape[0]):
            w = v + 1 if v + 1 < x.shape[0] else 0
            ex, ey = x[w, i] - x[v, i], y[w, i] - y[v, i]
            if ex * ex + ey * ey > most:
                ux, uy, most = ex, ey, ex * ex + ey * ey
        ux, uy = ux / np.sqrt(most), uy / np.sqrt(most)
        s0, s1, t0, t1 = np.inf, -np.inf, np.inf, -np.inf
        for v in range(x.shape[0]):
            s, t = x[v, i] * ux + y[v, i] * uy, y[v, i] * ux - x[v, i] * uy
            s0, s1, t0, t1 = min(s0, s), max(s1, s), min(t0, t), max(t1, t)
        s, t = (s0 + s1) / 2, (t0 + t1) / 2
        kept[0, i], kept[1, i], kept[2, i], kept[3, i] = s * ux - t * uy, s * uy + t * ux, ux, uy
        kept[4, i], kept[5, i] = (s1 - s0) / 2, (t1 - t0) / 2
    return kept


@compiled
def oriented_overlap(a: Array, b: Array, out: Out) -> None:
    """Oriented boxes by their four axes (Gottschalk, Lin and Manocha 1996)."""
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
def textbook(ax: Array, ay: Array, bx: Array, by: Array, unit: bool, tolerance: float, out: Out) -> None:
    """SAT as articles write it: both ranges on each normal, out at the first gap beyond the tolerance."""
    for i in range(out.size):
        out[i] = not (_separated(ax, ay, bx, by, i, unit, tolerance) or _separated(bx, by, ax, ay, i, unit, tolerance))


@compiled
def _separated(x: Array, y: Array, p: Array, q: Array, i: int, unit: bool, tolerance: float) -> bool:
    for e in range(x.shape[0]):
        f = e + 1 if e + 1 < x.shape[0] else 0
        nx, ny = y[f, i] - y[e, i], x[e, i] - x[f, i]
        if unit:
            length = np.sqrt(nx * nx + ny * ny)
            nx, ny = nx / length, ny / length
        low, high, least, most = nx * x[0, i] + ny * y[0, i], nx * x[0, i] + ny * y[0, i], np.inf, -np.inf
        for v in range(1, x.shape[0]):
            at = nx * x[v, i] + ny * y[v, i]
            low, high = min(low, at), max(high, at)
        for v in range(p.shape[0]):
            at = nx * p[v, i] + ny * q[v, i]
            least, most = min(least, at), max(most, at)
        if max(least - high, low - most) > tolerance:
            return True
    return False


@compiled
def turns(ax: Array, ay: Array, bx: Array, by: Array, granted: float, out: Out) -> None:
    """SAT by orientation predicates: apart where all corners lie to the right of some edge of the other."""
    terms = np.empty(MAX_TERMS)
    for i in range(out.size):
        out[i] = not (_cleared(ax, ay, bx, by, i, granted, terms) or _cleared(bx, by, ax, ay, i, granted, terms))


@compiled
def _cleared(x: Array, y: Array, p: Array, q: Array, i: int, granted: float, terms: Array) -> bool:
    for e in range(x.shape[0]):
        f = e + 1 if e + 1 < x.shape[0] else 0
        beyond = True
        for v in range(p.shape[0]):
            left = (x[f, i] - x[e, i]) * (q[v, i] - y[e, i])
            right = (y[f, i] - y[e, i]) * (p[v, i] - x[e, i])
            side = left - right
            if not abs(side) > granted * (abs(left) + abs(right)):
                if granted == EXACT:
                    sign = _exact_turn(x[e, i], y[e, i], x[f, i], y[f, i], p[v, i], q[v, i], terms)
                else:
                    sign = orient(x[e, i], y[e, i], x[f, i], y[f, i], p[v, i], q[v, i], terms)
                # beyond the range of their products these predicates promise nothing
                side = side if sign == UNKNOWN else float(sign)
            if side >= 0:
                beyond = False
                break
        if beyond:
            return True
    return False


@compiled
def _exact_turn(px: float, py: float, qx: float, qy: float, rx: float, ry: float, terms: Array) -> int:
    """The sign of the sum of six products, each held as two floats; no look at the float first."""
    for k, (a, b) in enumerate(((px, qy), (-py, qx), (qx, ry), (-qy, rx), (rx, py), (-ry, px))):
        terms[k], terms[6 + k] = two_product(a, b)
    return sign_of_sum(terms, MAX_TERMS)


@compiled
def gjk(ax: Array, ay: Array, bx: Array, by: Array, out: Out) -> None:
    """Gilbert, Johnson and Keerthi (1988) on floats: does the difference hold the origin?"""
    for i in range(out.size):
        dx, dy = bx[0, i] - ax[0, i], by[0, i] - ay[0, i]
        ux, uy = _furthest(ax, ay, bx, by, i, -dx, -dy)
        vx, vy, wx, wy, corners = 0.0, 0.0, 0.0, 0.0, 1
        dx, dy = -ux, -uy
        out[i] = 1
        for _ in range(MOST_TURNS):
            if dx == 0 and dy == 0:
                break
            px, py = _furthest(ax, ay, bx, by, i, dx, dy)
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
def _furthest(ax: Array, ay: Array, bx: Array, by: Array, i: int, dx: float, dy: float) -> tuple[float, float]:
    """The corner of B - A furthest along (dx, dy)."""
    best, k = -np.inf, 0
    for v in range(ax.shape[0]):
        at = -dx * ax[v, i] - dy * ay[v, i]
        if at > best:
            best, k = at, v
    best, m = -np.inf, 0
    for v in range(bx.shape[0]):
        at = dx * bx[v, i] + dy * by[v, i]
        if at > best:
            best, m = at, v
    return bx[m, i] - ax[k, i], by[m, i] - ay[k, i]


# -- for many corners --------------------------------------------------------------------------------


@compiled
def searched(ax: Array, ay: Array, bx: Array, by: Array, out: Out) -> None:
    """SAT where each normal's lowest corner is found by halving: V log V steps."""
    for i in range(out.size):
        out[i] = not (_beyond(ax, ay, bx, by, i) or _beyond(bx, by, ax, ay, i))


@compiled
def _beyond(x: Array, y: Array, p: Array, q: Array, i: int) -> bool:
    for e in range(x.shape[0]):
        f = e + 1 if e + 1 < x.shape[0] else 0
        nx, ny = y[f, i] - y[e, i], x[e, i] - x[f, i]
        k = _lowest(p, q, i, nx, ny)
        if nx * (p[k, i] - x[e, i]) + ny * (q[k, i] - y[e, i]) > 0:
            return True
    return False


@compiled
def _step(p: Array, q: Array, i: int, v: int, nx: float, ny: float) -> float:
    """How far the edge after corner v rises along the normal."""
    w = v + 1 if v + 1 < p.shape[0] else 0
    return float(nx * (p[w, i] - p[v, i]) + ny * (q[w, i] - q[v, i]))


@compiled
def _lowest(p: Array, q: Array, i: int, nx: float, ny: float) -> int:
    """The lowest corner along a normal: along a convex outline heights fall, then rise, once (O'Rourke 1998)."""
    low, high = 0, p.shape[0]
    falls = _step(p, q, i, 0, nx, ny) < 0
    if not falls and _step(p, q, i, p.shape[0] - 1, nx, ny) <= 0:
        return 0
    while high - low > 1:
        mid: int = (low + high) // 2
        mid_falls = _step(p, q, i, mid, nx, ny) < 0
        if not mid_falls and _step(p, q, i, mid - 1, nx, ny) <= 0:
            return mid
        lower = nx * (p[mid, i] - p[low, i]) + ny * (q[mid, i] - q[low, i]) < 0
        if (falls and (not mid_falls or not lower)) or (not falls and not mid_falls and lower):
            high = mid
        else:
            low, falls = mid, mid_falls
    return low if _step(p, q, i, low, nx, ny) >= 0 else (low + 1) % p.shape[0]


@compiled
def calipers(ax: Array, ay: Array, bx: Array, by: Array, out: Out) -> None:
    """Once around both outlines at the same angle: the edges of A - B in order, and is the origin inside all?"""
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
