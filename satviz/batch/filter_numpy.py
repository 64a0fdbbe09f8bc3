"""The float filter for arrays of pairs, in NumPy: what it cannot tell stays UNDECIDED.

The bounds are those of the scalar engine (satviz.verdict), which hold for any order
of operations.  Every kernel takes one column a pair, from column `first` on, and fills `out` with
relations.
"""

import numpy as np

from ..exact import HUGE, TINY

APART, TOUCHING, OVERLAPPING, UNDECIDED = 0, 1, 2, -1
BLOCK = 8192  # pairs at a time: their columns and the scratch arrays stay in the second-level cache


def polygons(ax, ay, bx, by, first: int, room: float, out) -> None:
    """(Va, n) and (Vb, n) corners: APART where an edge has the other shape beyond it by more than room."""
    ax, ay, bx, by = (c[:, first : first + out.size] for c in (ax, ay, bx, by))
    best = np.full(out.size, -np.inf)
    scratch = [np.empty(out.size) for _ in range(5)]
    _edges(ax, ay, bx, by, best, *scratch)
    _edges(bx, by, ax, ay, best, *scratch)
    _decide(best, room, out)


def _edges(x, y, px, py, best, nx, ny, least, look, part) -> None:
    """Raise `best` to the clearance of each edge: how far beyond it the other shape's nearest corner lies."""
    for i in range(len(x)):
        j = (i + 1) % len(x)
        np.subtract(y[j], y[i], out=nx)
        np.subtract(x[i], x[j], out=ny)
        np.multiply(nx, px[0], out=least)
        np.multiply(ny, py[0], out=part)
        least += part
        for k in range(1, len(px)):
            np.multiply(nx, px[k], out=look)
            np.multiply(ny, py[k], out=part)
            look += part
            np.minimum(least, look, out=least)
        nx *= x[i]
        ny *= y[i]
        least -= nx
        least -= ny
        np.maximum(best, least, out=best)


def _decide(gap, room, out) -> None:
    out.fill(UNDECIDED)
    out[gap > room] = APART
    out[gap < -room] = OVERLAPPING


def circles(ax, ay, ar, bx, by, br, first: int, out) -> None:
    """Distance against the sum of radii, squared."""
    ax, ay, ar, bx, by, br = (c[first : first + out.size] for c in (ax, ay, ar, bx, by, br))
    dx, dy, reach = ax - bx, ay - by, ar + br
    distance = dx * dx + dy * dy
    reach *= reach
    room = distance + reach
    sure = (room > TINY) & (room < HUGE)
    room *= 2.0**-50
    room[~sure] = np.inf
    _decide(distance - reach, room, out)


def circle_polygons(cx, cy, cr, px, py, first: int, out) -> None:
    """The squared distance from each centre to the nearest edge or corner, against the squared radius."""
    cx, cy, cr, px, py = (c[..., first : first + out.size] for c in (cx, cy, cr, px, py))
    x, y = px - cx, py - cy
    far = np.maximum(np.maximum(np.abs(x).max(axis=0), np.abs(y).max(axis=0)), cr)
    room = far * far * 2.0**-46
    safe = (room > TINY) & (room < HUGE * 2.0**-46)
    inside, outside = np.ones(out.size, bool), np.zeros(out.size, bool)
    nearest = np.full(out.size, np.inf)
    for i in range(len(px)):
        j = (i + 1) % len(px)
        dx, dy = px[j] - px[i], py[j] - py[i]
        turn = x[i] * dy - y[i] * dx
        tolerance = (np.abs(dx) + np.abs(dy)) * (far * 2.0**-48)
        facing = turn <= tolerance
        inside &= ~facing
        outside |= turn < -tolerance
        along, square = -(x[i] * dx + y[i] * dy), dx * dx + dy * dy
        safe &= square > TINY
        distance = np.where(
            along <= 0,
            x[i] * x[i] + y[i] * y[i],
            np.where(along >= square, x[j] * x[j] + y[j] * y[j], turn / square * turn),
        )
        np.minimum(nearest, distance, out=nearest, where=facing)
    reach = cr * cr
    out.fill(UNDECIDED)
    out[safe & (inside | (nearest < reach - room))] = OVERLAPPING
    out[safe & outside & ~inside & (nearest > reach + room)] = APART
