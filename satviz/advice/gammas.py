"""gamma for many pairs with NumPy: by floats where they can tell, else as the scalar engine does."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import batch
from ..batch.arrays import Group, Shapes
from ..engine.exact import UNIT
from .gamma import signed
from .pairs import Array, columns, indexed, one, part_pairs, reach

# By floats a turn is off by under 17 u * span * reach (three roundings of each product, one of their difference), a
# distance by under 40 u * reach; below this gamma is asked exactly, and above it is good to one part in fifty.
NEAR = 2.0**11
SHORT = 2.0**-900  # of the reach: where products of differences lose bits


def gammas(a: Shapes, b: Shapes, pairs: ArrayLike | None = None) -> Array:
    """(K,) gamma of many pairs, good to one part in fifty; those below 2**11 as `gamma` gives them.

    a, b: batch shapes side by side, or the (K, 2) indices `pairs` into them, as in `batch.relate`.
    """
    return np.abs(signed_gammas(a, b, pairs))


def signed_gammas(a: Shapes, b: Shapes, pairs: ArrayLike | None = None) -> Array:
    """(K,) gammas, negative where the pair overlaps."""
    ia, ib = indexed(a, b, pairs)
    pa, pb, of = part_pairs(a, ia, b, ib)
    a, b = a.parts, b.parts
    roughly = np.empty(len(pa))
    for mine, p, q in columns(a, pa, b, pb):
        roughly[mine] = _columns(p, q)
    near = np.flatnonzero(~(np.abs(roughly) >= NEAR))
    relation = batch.relate(a, b, np.stack([pa[near], pb[near]], axis=1))
    roughly[near[relation == 1]] = 0.0
    for i in near[relation != 1].tolist():
        roughly[i] = signed(one(a, pa[i]), one(b, pb[i]))
    found = np.full(len(ia), np.inf)
    np.minimum.at(found, of, roughly)
    return found


def _columns(a: Group, b: Group) -> Array:
    with np.errstate(all="ignore"):
        # to below a half, as large coordinates have a difference beyond float64, and a center and its radius a sum
        power = -1 - np.frexp(np.maximum(reach(_half(a)), reach(_half(b))))[1]
        a, b = (_scaled(g, power) for g in (a, b))
        unit = UNIT * np.maximum(reach(a), reach(b))
        if a.r is not None and b.r is not None:
            gap = np.hypot(a.x[0] - b.x[0], a.y[0] - b.y[0]) - (a.r + b.r)
        elif a.r is not None or b.r is not None:
            gap = _from_center(a, b) if a.r is not None else _from_center(b, a)
        else:
            gap = np.maximum(_clears(a, b), _clears(b, a))
        return np.asarray(gap / unit)


def _half(g: Group) -> Group:
    return g._replace(x=g.x / 2, y=g.y / 2, r=None if g.r is None else g.r / 2)


def _scaled(g: Group, power: NDArray[np.intp]) -> Group:
    r = None if g.r is None else np.ldexp(g.r, power)
    return g._replace(x=np.ldexp(g.x, power), y=np.ldexp(g.y, power), r=r)


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
