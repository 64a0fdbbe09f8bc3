"""Peers compiled with numba: the same language as satviz's kernels, so that what differs is the method.

Polygons of one number of corners: (V, N) x and y of each side, column by column.
"""

from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray

Array = NDArray[np.float64]
MOST_TURNS = 64


def _compiled(kernel: Any) -> Any:
    return njit(nogil=True, cache=True, error_model="numpy")(kernel)


@_compiled
def reading(columns: NDArray[np.int64]) -> int:
    """Every number once, as integers, which the compiler may take in any order: what no method can undercut."""
    total = 0
    for k in range(columns.size):
        total ^= columns[k]
    return total


@_compiled
def textbook(ax: Array, ay: Array, bx: Array, by: Array, out: NDArray[np.int8]) -> None:
    """SAT as articles write it: unit normals, both ranges on each, out at the first gap; 1 for a hit."""
    for i in range(out.size):
        out[i] = not (_separated(ax, ay, bx, by, i) or _separated(bx, by, ax, ay, i))


@_compiled
def _separated(x: Array, y: Array, p: Array, q: Array, i: int) -> bool:
    for e in range(x.shape[0]):
        f = e + 1 if e + 1 < x.shape[0] else 0
        nx, ny = y[f, i] - y[e, i], x[e, i] - x[f, i]
        length = np.sqrt(nx * nx + ny * ny)
        nx, ny = nx / length, ny / length
        a0, a1, b0, b1 = np.inf, -np.inf, np.inf, -np.inf
        for v in range(x.shape[0]):
            at = nx * x[v, i] + ny * y[v, i]
            a0, a1 = min(a0, at), max(a1, at)
        for v in range(p.shape[0]):
            at = nx * p[v, i] + ny * q[v, i]
            b0, b1 = min(b0, at), max(b1, at)
        if a1 < b0 or b1 < a0:
            return True
    return False


@_compiled
def gjk(ax: Array, ay: Array, bx: Array, by: Array, out: NDArray[np.int8]) -> None:
    """Gilbert, Johnson and Keerthi (1988) on floats: does the difference hold the origin?  1 for a hit."""
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


@_compiled
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
