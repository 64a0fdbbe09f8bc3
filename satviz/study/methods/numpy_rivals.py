"""Textbook SAT on many pairs with NumPy, as it is usually written: one loop over the axes, in blocks.

It stays beside the models of `satviz/advice` as a rival: its own time is what the study measures.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..workloads.generators import Side

Array = NDArray[np.floating]
Hits = NDArray[np.bool_]
BLOCK_PAIRS = 1 << 14  # so many pairs fit in the cache


class Columns(NamedTuple):
    """N shapes as columns: x and y (V, N) coordinates of corners, and r (N,) radii of circles, or None for polygons.

    A polygon with fewer than V corners repeats its last one.
    """

    x: Array
    y: Array
    r: Array | None


def as_columns(side: Side) -> Columns:
    """Return the shapes of a workload's side as Columns that are views: nothing is copied."""
    at, r = side if isinstance(side, tuple) else (side, None)
    at = at[:, None] if at.ndim == 2 else at
    return Columns(at[:, :, 0].T, at[:, :, 1].T, r)


def to_columns(side: Side, dtype: type = np.float64) -> Columns:
    """Return the shapes of a workload's side as Columns of their own, with coordinates of type `dtype`."""
    x, y, r = as_columns(side)
    x, y = (np.ascontiguousarray(column, dtype=dtype) for column in (x, y))
    return Columns(x, y, None if r is None else r.astype(dtype))


def sat_hits(a: Columns, b: Columns) -> Hits:
    """Return for each pair whether it hits: no axis of length 1 leaves a gap."""
    found = np.ones(a.x.shape[1], bool)
    with np.errstate(all="ignore"):
        for start in range(0, len(found), BLOCK_PAIRS):
            p, q = (_block(side, start) for side in (a, b))
            for nx, ny in sat_axes(p, q):
                length = np.sqrt(nx * nx + ny * ny)
                nx, ny = nx / length, ny / length
                lo_a, hi_a = project(p, nx, ny)
                lo_b, hi_b = project(q, nx, ny)
                # a repeated corner's edge has no direction: its gap is NaN, which separates nothing
                found[start : start + BLOCK_PAIRS] &= ~(np.maximum(lo_a - hi_b, lo_b - hi_a) > 0)
    return found


def project(c: Columns, nx: Array, ny: Array) -> tuple[Array, Array]:
    """Return (low, high), (N,) each: the range of each shape on the axis (nx[k], ny[k]) of its pair, of length 1."""
    lo = hi = c.x[0] * nx + c.y[0] * ny
    for x, y in zip(c.x[1:], c.y[1:]):
        landing = x * nx + y * ny
        lo, hi = np.minimum(lo, landing), np.maximum(hi, landing)
    return (lo, hi) if c.r is None else (lo - c.r, hi + c.r)


def sat_axes(a: Columns, b: Columns) -> Iterator[tuple[Array, Array]]:
    """Yield the axes (nx, ny) of SAT, (N,) each and of any length: edge normals.

    For circles the last is the axis from the center to the nearest vertex or center.
    """
    for c in (a, b):
        for i in range(len(c.x) if len(c.x) > 1 else 0):
            yield c.y[i] - c.y[i - 1], c.x[i - 1] - c.x[i]
    if a.r is not None or b.r is not None:
        circle, ring = (a, b) if a.r is not None else (b, a)
        x, y = ring.x - circle.x, ring.y - circle.y
        nearest = (x * x + y * y).argmin(axis=0), np.arange(x.shape[1])
        yield x[nearest], y[nearest]


def _block(c: Columns, start: int) -> Columns:
    """Return the columns of BLOCK_PAIRS shapes, or of those that are left, from number `start` on."""
    stop = start + BLOCK_PAIRS
    return Columns(c.x[:, start:stop], c.y[:, start:stop], None if c.r is None else c.r[start:stop])
