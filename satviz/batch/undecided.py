"""The exact twin for the pairs that the filter leaves undecided."""

import numpy as np
from numpy.typing import NDArray

from ..engine.verdict import LEAST_ROOM, LOOK, MOST_ROOM
from . import circle_polygons, signs
from .arrays import Group, upright_boxes
from .codes import APART, OVERLAPPING, TOUCHING
from .filter_numpy import boxes
from .signs import Array, Signs

Indices = NDArray[np.intp]
Mask = NDArray[np.bool_]

LOOKS = 1 << 18  # looks of one edge at a time, over pairs and corners: what bounds the memory
AT_ONCE = 4  # corners, up to which every edge of all pairs is looked at: beyond, most are not needed
DOUBTS = 1 << 15  # exact signs asked in one go: each takes some hundred bytes a term
RELATION_OF_SIGN = np.array([TOUCHING, APART, OVERLAPPING], np.int8)  # of 0, 1 and -1


def relations(a: Group, b: Group) -> Signs:
    """Exact relations of two groups, column by column."""
    if a.r is not None and b.r is not None:
        return RELATION_OF_SIGN[signs.circles(a.x[0], a.y[0], a.r, b.x[0], b.y[0], b.r)]
    for circle, polygon in (a, b), (b, a):
        if circle.r is not None:
            return RELATION_OF_SIGN[circle_polygons.gaps(circle.x[0], circle.y[0], circle.r, polygon.x, polygon.y)]
    found = np.empty(a.x.shape[1], np.int8)
    upright = np.zeros(len(found), bool)
    if len(a.x) == len(b.x) == 4:
        upright = upright_boxes(a.x, a.y) & upright_boxes(b.x, b.y)
        settled = np.empty(upright.sum(), np.int8)
        boxes(a.columns(upright), b.columns(upright), 0, settled)
        found[upright] = settled
    rest = np.flatnonzero(~upright)
    size = max(1, LOOKS // max(len(a.x), len(b.x)))
    with np.errstate(all="ignore"):
        for start in range(0, len(rest), size):
            part = rest[start : start + size]
            found[part] = _polygons(a.columns(part), b.columns(part))
    return found


def _polygons(a: Group, b: Group) -> Signs:
    """Few corners: every edge of all pairs, with exact signs for those in doubt.  Many: the likely edges first."""
    found = np.full(a.x.shape[1], OVERLAPPING, np.int8)
    reach = (_largest(a.x, a.y) + _largest(b.x, b.y)) * LOOK
    few = max(len(a.x), len(b.x)) <= AT_ONCE
    left = np.arange(len(found))
    nearest = [] if few else [_nearest(a, b), _nearest(b, a)]
    for step in range(max(len(a.x), len(b.x))):
        # around from the edges at the corner that lies furthest towards the other shape: -1, 0, -2, 1, -3, ...
        away = step // 2 if step % 2 else -1 - step // 2
        for k, (own, other) in enumerate(((a, b), (b, a))):
            if step >= len(own.x):
                continue
            if few:
                which, tells = _same_edge(own, other, step, reach)
                found[which] = np.minimum(found[which], tells)
            elif left.size:
                tells = _edge(own, other, (nearest[k][left] + away) % len(own.x), left, reach[left])
                found[left] = tells
                left = left[tells == OVERLAPPING]
    return found


def _nearest(own: Group, other: Group) -> Indices:
    """The corner that lies furthest towards the other shape, by floats; any would do."""
    dx, dy = (s[0] + s[len(s) // 2] - o[0] - o[len(o) // 2] for s, o in ((other.x, own.x), (other.y, own.y)))
    look = dx * own.x
    look += dy * own.y
    found: Indices = look.argmax(axis=0)
    return found


def _same_edge(own: Group, other: Group, e: int, reach: Array) -> tuple[Indices, Signs]:
    """The pairs of which an edge does not plainly cut the other shape, and what it tells of them."""
    f = (e + 1) % len(own.x)
    ex, ey, fx, fy = own.x[e], own.y[e], own.x[f], own.y[f]
    nx, ny = fy - ey, ex - fx
    least, look, part = np.full(len(nx), np.inf), np.empty_like(nx), np.empty_like(nx)
    for x, y in zip(other.x, other.y, strict=True):
        np.multiply(nx, x, out=look)
        np.multiply(ny, y, out=part)
        look += part
        np.minimum(least, look, out=least)
    least -= nx * ex + ny * ey
    room = np.maximum(np.abs(nx), np.abs(ny)) * reach
    room[~((room > LEAST_ROOM) & (room < MOST_ROOM))] = np.inf
    which = np.flatnonzero(~(least < -room))
    return which, _edge(own, other, np.full(len(which), e), which, reach[which])


def _edge(own: Group, other: Group, start: Indices, left: Indices, reach: Array) -> Signs:
    """What one edge of each pair left tells, from the float looks and the exact sign of every corner within the room.

    APART where all corners lie beyond it.  Where some lie on its line and none before, the shapes can only
    meet there: TOUCHING, or APART, as their ranges on the line tell.  OVERLAPPING for now where one lies before.
    """
    end = (start + 1) % len(own.x)
    ex, ey, fx, fy = own.x[start, left], own.y[start, left], own.x[end, left], own.y[end, left]
    nx, ny = fy - ey, ex - fx
    room = np.maximum(np.abs(nx), np.abs(ny)) * reach
    room[~((room > LEAST_ROOM) & (room < MOST_ROOM))] = np.inf
    looks = nx * other.x[:, left]
    looks += ny * other.y[:, left]
    looks -= nx * ex + ny * ey
    least = looks.min(axis=0)
    tells = np.where(least > room, np.int8(APART), np.int8(OVERLAPPING))
    doubtful = np.flatnonzero(~(np.abs(least) > room))
    if doubtful.size:
        ends = ex[doubtful], ey[doubtful], fx[doubtful], fy[doubtful]
        close = ~(looks[:, doubtful] > room[doubtful])
        tells[doubtful] = _line(*ends, other.x[:, left[doubtful]], other.y[:, left[doubtful]], close)
    return tells


def _line(ex: Array, ey: Array, fx: Array, fy: Array, px: Array, py: Array, close: Mask) -> Signs:
    """The same where the exact signs of the close corners are needed; the others lie beyond."""
    side = np.ones(px.shape, np.int8)
    corner, which = np.nonzero(close)
    for start in range(0, len(which), DOUBTS):
        w, c = which[start : start + DOUBTS], corner[start : start + DOUBTS]
        # the turn from the edge's end over its start: what lies beyond is to the left
        side[c, w] = signs.orient(fx[w], fy[w], ex[w], ey[w], px[c, w], py[c, w])
    least: Signs = side.min(axis=0)
    # along the line by x, or by y where it stands upright: no two corners are alike in both
    upright = ex == fx
    e, f = np.where(upright, ey, ex), np.where(upright, fy, fx)
    on = np.where(upright, py, px)
    low = np.where(side == 0, on, np.inf).min(axis=0)
    high = np.where(side == 0, on, -np.inf).max(axis=0)
    meet = (low <= np.maximum(e, f)) & (high >= np.minimum(e, f))
    return np.where(least < 0, OVERLAPPING, np.where((least == 0) & meet, TOUCHING, APART)).astype(np.int8)


def _largest(x: Array, y: Array) -> Array:
    """The largest magnitude in each column."""
    largest: Array = np.maximum(np.abs(x).max(axis=0), np.abs(y).max(axis=0))
    return largest
