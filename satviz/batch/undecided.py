"""The exact twin for the pairs that the filter leaves undecided."""

import numpy as np
from numpy.typing import NDArray

from ..exact import to_integers
from ..verdict import relate_integers
from . import signs
from .filter_numpy import APART, OVERLAPPING, TOUCHING

BLOCK = 2048  # pairs at a time: every corner of one against every edge of the other takes room
RELATION_OF_SIGN = np.array([TOUCHING, APART, OVERLAPPING], np.int8)  # of 0, 1 and -1


def polygons(ax, ay, bx, by) -> NDArray[np.int8]:
    """Exact relations of (Va, n) and (Vb, n) corners."""
    found = np.empty(ax.shape[1], np.int8)
    for start in range(0, len(found), BLOCK):
        part = slice(start, start + BLOCK)
        a, b = (ax[:, part], ay[:, part]), (bx[:, part], by[:, part])
        found[part] = RELATION_OF_SIGN[np.maximum(_clearance(*a, *b), _clearance(*b, *a))]
    return found


def _clearance(x, y, px, py) -> NDArray[np.int8]:
    """1 where some edge has all of the other's corners strictly beyond it, 0 where at best one on it, else -1."""
    shape = (len(x), len(px), x.shape[1])  # edge, corner, pair
    ends = [np.broadcast_to(c[:, None, :], shape).ravel() for c in (x, y, np.roll(x, -1, 0), np.roll(y, -1, 0))]
    corners = [np.broadcast_to(c[None, :, :], shape).ravel() for c in (px, py)]
    return (-signs.orient(*ends, *corners)).reshape(shape).min(axis=1).max(axis=0)


def circles(ax, ay, ar, bx, by, br) -> NDArray[np.int8]:
    """Exact relations of pairs of circles."""
    return RELATION_OF_SIGN[signs.circles(ax, ay, ar, bx, by, br)]


def circle_polygons(cx, cy, cr, px, py) -> NDArray[np.int8]:
    """Exact relations of circles with polygons, one by one with integers: a foot on an edge has degree four."""
    found = np.empty(len(cx), np.int8)
    for i in range(len(cx)):
        _, flat = to_integers([float(cx[i]), float(cy[i]), float(cr[i]), *px[:, i].tolist(), *py[:, i].tolist()])
        ring = list(zip(flat[3 : 3 + len(px)], flat[3 + len(px) :], strict=True))
        found[i] = relate_integers([(flat[0], flat[1])], ring, flat[2])
    return found
