"""The exact twin for the pairs that the filter leaves undecided."""

import numpy as np
from numpy.typing import NDArray

from . import circle_polygons, signs
from .arrays import Group
from .filter_numpy import APART, OVERLAPPING, TOUCHING, UNDECIDED, look_64

BLOCK = 2048  # pairs at a time: every corner of one against every edge of the other takes room
RELATION_OF_SIGN = np.array([TOUCHING, APART, OVERLAPPING], np.int8)  # of 0, 1 and -1


def relations(a: Group, b: Group) -> NDArray[np.int8]:
    """Exact relations of two groups, column by column."""
    if a.r is not None and b.r is not None:
        return RELATION_OF_SIGN[signs.circles(a.x[0], a.y[0], a.r, b.x[0], b.y[0], b.r)]
    if a.r is not None or b.r is not None:
        circle, polygon = (a, b) if a.r is not None else (b, a)
        return RELATION_OF_SIGN[circle_polygons.gaps(circle.x[0], circle.y[0], circle.r, polygon.x, polygon.y)]
    return _polygons(a, b)


def _polygons(a: Group, b: Group) -> NDArray[np.int8]:
    """First in float64 (the filter may have looked in float32), then the signs of all turns, exactly."""
    found = np.empty(a.x.shape[1], np.int8)
    for start in range(0, len(found), BLOCK):
        part = found[start : start + BLOCK]
        with np.errstate(all="ignore"):
            look_64(a, b, start, part)
        rest = np.flatnonzero(part == UNDECIDED)
        ax, ay, bx, by = (signs.columns(c, start + rest) for c in (a.x, a.y, b.x, b.y))
        part[rest] = RELATION_OF_SIGN[np.maximum(_clearance(ax, ay, bx, by), _clearance(bx, by, ax, ay))]
    return found


def _clearance(x, y, px, py) -> NDArray[np.int8]:
    """1 where some edge has all of the other's corners strictly beyond it, 0 where at best one on it, else -1."""
    shape = (len(x), len(px), x.shape[1])  # edge, corner, pair
    ends = [np.broadcast_to(c[:, None, :], shape).ravel() for c in (x, y, np.roll(x, -1, 0), np.roll(y, -1, 0))]
    corners = [np.broadcast_to(c[None, :, :], shape).ravel() for c in (px, py)]
    return (-signs.orient(*ends, *corners)).reshape(shape).min(axis=1).max(axis=0)
