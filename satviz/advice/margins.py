"""gamma for many pairs with NumPy: by floats, by floats with their errors where pairs are near, and by integers."""

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import batch
from ..batch.arrays import Group, Shapes
from ..batch.codes import TOUCHING
from ..batch.exact_signs import sum_with_error, two_sum
from ..engine.predicates import UNIT
from .limits import refuse_more_by_fractions
from .pairs import Array, columns, indexed, one, part_pairs, reach
from .relative_margin import signed

# By floats a turn is off by under 17 u * span * reach (three roundings of each product, one of their difference), a
# distance by under 40 u * reach; below this gamma is worked out more finely, and above it is good to one part in fifty.
NEAR = 2.0**11
FINELY = 100.0  # times the error bound: good to one part in a hundred
SHORT = 2.0**-900  # of the reach: where products of differences lose bits

Measure = Callable[[Group, Group], Array]


def gammas(a: Shapes, b: Shapes, pairs: ArrayLike | None = None) -> Array:
    """(K,) gamma of many pairs, good to one part in fifty; 0 for touching pairs only.

    a, b: batch shapes side by side, or the (K, 2) indices `pairs` into them, as in `batch.relate`.
    """
    return np.abs(signed_gammas(a, b, pairs))


def signed_gammas(a: Shapes, b: Shapes, pairs: ArrayLike | None = None, *, engine: str | None = None) -> Array:
    """(K,) gammas, negative where the pair overlaps; `engine`: as in `batch.relate`."""
    ia, ib = indexed(a, b, pairs)
    pa, pb, of = part_pairs(a, ia, b, ib)
    a, b = a.parts, b.parts
    roughly = np.empty(len(pa))
    for mine, p, q in columns(a, pa, b, pb):
        roughly[mine] = _columns(p, q, _beyond, _between)
    near = np.flatnonzero(~(np.abs(roughly) >= NEAR))
    relation = batch.relate(a, b, np.stack([pa[near], pb[near]], axis=1), engine=engine)
    roughly[near] = np.where(relation == TOUCHING, 0.0, np.nan)
    near = near[relation != TOUCHING]
    for mine, p, q in columns(a, pa[near], b, pb[near]):
        if (p.r is None) == (q.r is None):
            roughly[near[mine]] = _columns(p, q, _beyond_finely, _between_finely)
    rest = np.flatnonzero(np.isnan(roughly))
    refuse_more_by_fractions(len(rest), len(rest))
    for i in rest.tolist():
        roughly[i] = signed(one(a, pa[i]), one(b, pb[i]))
    found = np.full(len(ia), np.inf)
    np.minimum.at(found, of, roughly)
    return found


def _columns(a: Group, b: Group, beyond: Measure, between: Measure) -> Array:
    with np.errstate(all="ignore"):
        # to below a half, as large coordinates have a difference beyond float64, and a center and its radius a sum
        power = -1 - np.frexp(np.maximum(reach(_half(a)), reach(_half(b))))[1]
        a, b = (_scaled(g, power) for g in (a, b))
        unit = UNIT * np.maximum(reach(a), reach(b))
        if a.r is not None and b.r is not None:
            gap = between(a, b)
        elif a.r is not None or b.r is not None:
            gap = _from_center(a, b) if a.r is not None else _from_center(b, a)
        else:
            gap = beyond(a, b)
        return np.asarray(gap / unit)


def _half(g: Group) -> Group:
    return g._replace(x=g.x / 2, y=g.y / 2, r=None if g.r is None else g.r / 2)


def _scaled(g: Group, power: NDArray[np.intp]) -> Group:
    r = None if g.r is None else np.ldexp(g.r, power)
    return g._replace(x=np.ldexp(g.x, power), y=np.ldexp(g.y, power), r=r)


def _beyond(a: Group, b: Group) -> Array:
    """The most that an edge of either polygon clears the other by, over its span."""
    return np.maximum(_clears(a, b), _clears(b, a))


def _clears(own: Group, other: Group) -> Array:
    """The most that an edge clears the other's corners by, over its span; NaN where an edge is too short to tell."""
    best = np.full(own.x.shape[1], -np.inf)
    for e in range(len(own.x)):
        x, y = own.x[e - 1], own.y[e - 1]
        nx, ny = own.y[e] - y, x - own.x[e]
        span = np.maximum(np.abs(nx), np.abs(ny))
        span[span < SHORT] = np.nan
        np.maximum(best, (nx * (other.x - x) + ny * (other.y - y)).min(axis=0) / span, out=best)
    return best


def _between(a: Group, b: Group) -> Array:
    """The gap of two circles."""
    assert a.r is not None and b.r is not None
    gap: Array = np.hypot(a.x[0] - b.x[0], a.y[0] - b.y[0]) - (a.r + b.r)
    return gap


def _beyond_finely(a: Group, b: Group) -> Array:
    """As `_beyond`, with the error of each operation; NaN where even so one part in a hundred cannot be told."""
    best, room = np.full(a.x.shape[1], -np.inf), np.zeros(a.x.shape[1])
    for own, other in (a, b), (b, a):
        shape = other.x.shape
        for e in range(len(own.x)):
            x, y = own.x[e - 1], own.y[e - 1]
            sides = two_sum(own.y[e], -y), two_sum(x, -own.x[e]), two_sum(other.x, -x), two_sum(other.y, -y)
            (nx, enx), (ny, eny), (dx, edx), (dy, edy) = ([np.broadcast_to(c, shape).ravel() for c in s] for s in sides)
            turn, off, _ = sum_with_error([(nx, dx), (ny, dy)], (nx * edx + enx * dx) + (ny * edy + eny * dy))
            span = np.maximum(np.abs(nx), np.abs(ny))[: shape[1]]
            span[span < SHORT] = np.nan
            np.maximum(best, turn.reshape(shape).min(axis=0) / span, out=best)
            np.maximum(room, off.reshape(shape).max(axis=0) / span, out=room)
    return np.where(np.abs(best) > np.maximum(FINELY * room, SHORT), best, np.nan)


def _between_finely(a: Group, b: Group) -> Array:
    """As `_between`, by the difference of the squares with the error of each operation; NaN as above."""
    assert a.r is not None and b.r is not None
    (dx, ex), (dy, ey), (r, er) = two_sum(a.x[0], -b.x[0]), two_sum(a.y[0], -b.y[0]), two_sum(a.r, b.r)
    square, off, _ = sum_with_error([(dx, dx), (dy, dy), (-r, r)], 2 * ((dx * ex + dy * ey) - r * er))
    gap = square / (np.hypot(dx, dy) + r)
    return np.where((np.abs(square) > FINELY * off) & (np.abs(gap) > SHORT), gap, np.nan)


def _from_center(circle: Group, ring: Group) -> Array:
    """The gap of circles and polygons: outside from the nearest point of a side, inside from the nearest side.

    NaN where rounding can have put a center inside.
    """
    assert circle.r is not None
    x, y = ring.x - circle.x, ring.y - circle.y
    inner, outer = np.full((2, x.shape[1]), np.inf)
    for e in range(len(x)):
        px, py, qx, qy = x[e - 1], y[e - 1], x[e], y[e]
        dx, dy = ring.x[e] - ring.x[e - 1], ring.y[e] - ring.y[e - 1]
        length = np.hypot(dx, dy)
        length[length < SHORT] = np.nan
        side = (px * dy - py * dx) / length
        along = -(px * dx + py * dy) / length
        ends = np.where(along <= 0, np.hypot(px, py), np.hypot(qx, qy))
        foot = (along > 0) & (along < length)
        outer = np.minimum(outer, np.where(foot, np.abs(side), ends))
        inner = np.minimum(inner, side)
    gap: Array = np.where(inner > 0, -inner, outer) - circle.r
    gap[(inner > 0) & (inner < NEAR * UNIT)] = np.nan  # or outside, before the tip of a needle
    return gap
