"""The exact twin for the pairs that the filter leaves undecided."""

import numpy as np

from ..engine.verdict import LEAST_ROOM, LOOK, MOST_ROOM
from . import circle_polygons, signs
from .arrays import Group, upright_boxes
from .filter_numpy import APART, OVERLAPPING, TOUCHING, boxes
from .signs import Array, Signs

LOOKS = 1 << 18  # looks of one edge at a time, over pairs and corners: what bounds the memory
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
    """Edge by edge in float64, the exact sign asked of every corner within the room of zero."""
    best = np.full(a.x.shape[1], -1, np.int8)
    reach = (_largest(a.x, a.y) + _largest(b.x, b.y)) * LOOK
    for own, other in (a, b), (b, a):
        x, y = np.concatenate([own.x, own.x[:1]]), np.concatenate([own.y, own.y[:1]])
        nx, ny = np.diff(y, axis=0), -np.diff(x, axis=0)
        room = _largest(nx, ny) * reach
        room[~((room > LEAST_ROOM) & (room < MOST_ROOM))] = np.inf
        for i in range(len(nx)):
            looks = nx[i] * other.x
            looks += ny[i] * other.y
            looks -= nx[i] * x[i] + ny[i] * y[i]
            least = looks.min(axis=0)
            best[least > room] = 1
            doubtful = np.flatnonzero(~(np.abs(least) > room) & (best < 1))
            if doubtful.size:
                corner, which = np.nonzero(~(looks[:, doubtful] > room[doubtful]))
                side = np.ones(len(doubtful), np.int8)
                for start in range(0, len(which), DOUBTS):
                    w, c = which[start : start + DOUBTS], corner[start : start + DOUBTS]
                    k = doubtful[w]
                    # the turn from the edge's end over its start: what lies beyond is to the left
                    turns = signs.orient(x[i + 1, k], y[i + 1, k], x[i, k], y[i, k], other.x[c, k], other.y[c, k])
                    np.minimum.at(side, w, turns)
                best[doubtful] = np.maximum(best[doubtful], side)
    return RELATION_OF_SIGN[best]


def _largest(x: Array, y: Array) -> Array:
    """The largest magnitude in each column."""
    largest: Array = np.maximum(np.abs(x).max(axis=0), np.abs(y).max(axis=0))
    return largest
