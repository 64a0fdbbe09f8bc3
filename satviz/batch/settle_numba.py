"""Any pair of convex polygons settled to the exact relation, compiled with numba.

An axis or a shared point found in a few steps, for outlines of many corners; then around both
outlines edge by edge, with the exact sign asked of every corner within the room of zero.
"""

import numpy as np

from ..engine.exact import HUGE, TINY
from ..engine.verdict import LEAST_ROOM, LOOK, MOST_ROOM
from .compiling import compiled
from .filter_numpy import APART, OVERLAPPING, TOUCHING, UNDECIDED
from .signs import MOST_PASSES, ROUND, SPLIT, UNKNOWN, Array

FEW = 8  # corners: all are looked at sooner than one goes round
MOST_STEPS = 20
TERMS = 12  # floats that a turn is the sum of

# A corner found by walking lies, along the normal, at most the outline's length times 2**-50 above the lowest: where
# an edge's direction is misjudged it is within three roundings of level.  An outline is at most eight reaches long.
WALKED = 8 * LOOK


@compiled
def settled(
    x: Array, y: Array, i0: int, i1: int, p: Array, q: Array, j0: int, j1: int, reach: float, terms: Array
) -> int:
    """The exact relation of corners i0 to i1 of one row with j0 to j1 of another; UNDECIDED out of range.

    `reach`: both largest coordinates together; `terms`: scratch.
    """
    if max(i1 - i0, j1 - j0) > FEW:
        found = _soon(x, y, i0, i1, p, q, j0, j1, reach)
        if found != UNDECIDED:
            return found
    side = _side(x, y, i0, i1, p, q, j0, j1, reach, terms)
    if side > 0:
        return APART
    other = UNKNOWN if side == UNKNOWN else _side(p, q, j0, j1, x, y, i0, i1, reach, terms)
    if other == UNKNOWN:
        return UNDECIDED
    side = max(side, other)
    return APART if side > 0 else OVERLAPPING if side < 0 else TOUCHING


@compiled
def _side(
    x: Array, y: Array, i0: int, i1: int, p: Array, q: Array, j0: int, j1: int, reach: float, terms: Array
) -> int:
    """1 if some edge of the first has the second strictly beyond it, 0 if at best on it, else -1; UNKNOWN out of range.

    The lowest corner along the normals, which turn left, is walked to from one to the next; the corners
    within the room of zero stand in a row about it.
    """
    best, k, walk, many = -1, j0, j1 - j0 > FEW, j1 - j0
    ex, ey = x[i1 - 1], y[i1 - 1]
    if walk:
        k = _lowest(p, q, j0, j1, y[i0] - ey, ex - x[i0])
    for i in range(i0, i1):
        nx, ny = y[i] - ey, ex - x[i]
        at = nx * ex + ny * ey
        room = (abs(nx) + abs(ny)) * reach * WALKED
        if not (room > LEAST_ROOM and room < MOST_ROOM):
            return UNKNOWN
        if walk:
            k = _on(p, q, j0, j1, k, nx, ny)
            least = nx * p[k] + ny * q[k] - at
        else:
            least = np.inf
            for j in range(j0, j1):
                least = min(least, nx * p[j] + ny * q[j])
            least -= at
        if least > room:
            return 1
        if least >= -room:
            side = 1
            j = k
            for _ in range(many):
                if nx * p[j] + ny * q[j] - at <= 3 * room:
                    side = min(side, turn(x[i], y[i], ex, ey, p[j], q[j], terms))
                elif walk:
                    break
                j = j + 1 if j + 1 < j1 else j0
            j = k
            for _ in range(many if walk else 0):
                j = j - 1 if j > j0 else j1 - 1
                if nx * p[j] + ny * q[j] - at > 3 * room:
                    break
                side = min(side, turn(x[i], y[i], ex, ey, p[j], q[j], terms))
            if side == UNKNOWN or side > 0:
                return side
            best = max(best, side)
        ex, ey = x[i], y[i]
    return best


@compiled
def _on(x: Array, y: Array, i0: int, i1: int, k: int, dx: float, dy: float) -> int:
    """From corner k on, as long as the outline falls along (dx, dy)."""
    for _ in range(i0, i1):
        i = k + 1 if k + 1 < i1 else i0
        if dx * (x[i] - x[k]) + dy * (y[i] - y[k]) >= 0:
            break
        k = i
    return k


@compiled
def _lowest(x: Array, y: Array, i0: int, i1: int, dx: float, dy: float) -> int:
    """A corner as low along (dx, dy) as any, up to what walking may miss: the best of some, then on or back from it."""
    k, least = i0, np.inf
    for i in range(i0, i1, int(np.sqrt(i1 - i0))):
        look = dx * x[i] + dy * y[i]
        if look < least:
            k, least = i, look
    end = _on(x, y, i0, i1, k, dx, dy)
    if end == k:
        for _ in range(i0, i1):
            i = k - 1 if k > i0 else i1 - 1
            if dx * (x[i] - x[k]) + dy * (y[i] - y[k]) >= 0:
                break
            k = i
        end = k
    return end


@compiled
def _soon(x: Array, y: Array, i0: int, i1: int, p: Array, q: Array, j0: int, j1: int, reach: float) -> int:
    """APART or OVERLAPPING where an axis or a shared point is found in a few steps, else UNDECIDED.

    The differences of B's corners and A's span a polygon about the origin if the shapes overlap: its lowest
    corner along an axis above zero proves a gap, a triangle of its corners about the origin a shared
    point (Gilbert, Johnson and Keerthi 1988).
    """
    i, j = (i0 + i1) // 2, (j0 + j1) // 2
    dx, dy = (p[j0] - x[i0]) + (p[j] - x[i]), (q[j0] - y[i0]) + (q[j] - y[i])
    ux = uy = vx = vy = 0.0
    for step in range(MOST_STEPS):
        i, j = _lowest(x, y, i0, i1, -dx, -dy), _lowest(p, q, j0, j1, dx, dy)
        wx, wy = p[j] - x[i], q[j] - y[i]
        room = (abs(dx) + abs(dy)) * reach * WALKED
        at = dx * wx + dy * wy
        if not (room > LEAST_ROOM and room < MOST_ROOM) or abs(at) <= room:
            return UNDECIDED
        if at > room:
            return APART
        if step == 0:
            ux, uy, dx, dy = wx, wy, wx, wy
            continue
        if step == 1:
            vx, vy = wx, wy
        else:
            one, other = _cross(vx, vy, wx, wy), _cross(wx, wy, ux, uy)
            if one > 0 and other > 0:
                return OVERLAPPING
            if one < 0:
                ux, uy = wx, wy
            elif other < 0:
                vx, vy = wx, wy
            else:
                return UNDECIDED
        side = _cross(ux, uy, vx, vy)
        if side < 0:
            ux, uy, vx, vy = vx, vy, ux, uy
        elif not side > 0:
            return UNDECIDED
        # the origin lies left of the way from u to v: what is looked for next lies beyond, down to the left
        dx, dy = vy - uy, ux - vx
    return UNDECIDED


@compiled
def _cross(ux: float, uy: float, vx: float, vy: float) -> float:
    """The turn from u to v; 0 where rounding may hide its sign."""
    left, right = ux * vy, uy * vx
    size = abs(left) + abs(right)
    return left - right if abs(left - right) > ROUND * size and size > TINY else 0.0


@compiled
def turn(px: float, py: float, qx: float, qy: float, rx: float, ry: float, terms: Array) -> int:
    """signs.orient for one: the exact turn from p over q to r; UNKNOWN out of range."""
    left, right = (qx - px) * (ry - py), (qy - py) * (rx - px)
    size = abs(left) + abs(right)
    if abs(left - right) > ROUND * size and size > TINY and size < HUGE:
        return 1 if left > right else -1
    size = 0.0
    for i, (a, b) in enumerate(((px, qy), (-py, qx), (qx, ry), (-qy, rx), (rx, py), (-ry, px))):
        product = a * b
        if abs(product) < TINY and a != 0 and b != 0:
            return UNKNOWN
        (a1, a0), (b1, b0) = _split(a), _split(b)
        terms[i], terms[6 + i] = ((a1 * b1 - product) + a0 * b1 + a1 * b0) + a0 * b0, product
        size += abs(product)
    return _sign_of_sum(terms) if size < HUGE else UNKNOWN


@compiled
def _split(a: float) -> tuple[float, float]:
    """a as two floats of half the bits."""
    high = a * SPLIT
    high -= high - a
    return high, a - high


@compiled
def _sign_of_sum(terms: Array) -> int:
    """The exact sign of the sum; UNKNOWN where it takes too many passes.  The terms are used up."""
    last = TERMS - 1
    for _ in range(MOST_PASSES):
        rest = 0.0
        for i in range(last):
            rest += abs(terms[i])
        rest *= 1 + 2.0**-40
        if abs(terms[last]) > rest:
            return 1 if terms[last] > 0 else -1
        if rest == 0:
            return 0
        for i in range(1, TERMS):  # two_sum: the rounded sum into the one, what was rounded off into the other
            total = terms[i] + terms[i - 1]
            part = total - terms[i]
            terms[i - 1] = (terms[i] - (total - part)) + (terms[i - 1] - part)
            terms[i] = total
    return UNKNOWN
