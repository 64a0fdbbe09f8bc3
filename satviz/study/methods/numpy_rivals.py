"""Many pairs at once, as it is usually written with NumPy: one loop over a choice of axes, in blocks."""

from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..workloads.generators import Side
from .python_rivals import even_directions

Array = NDArray[np.floating]
Hits = NDArray[np.bool_]
BLOCK_PAIRS = 1 << 14  # pairs: what fits in the cache


class Columns(NamedTuple):
    """Shapes as arrays: x, y (V, N) corners, the last repeated where one has fewer; r (N,) of circles, else None."""

    x: Array
    y: Array
    r: Array | None


class PairAxes(NamedTuple):
    """One axis a pair: the direction (nx, ny) and its length, arrays or numbers."""

    nx: Array | float
    ny: Array | float
    length: Array | float


AxisChoice = Callable[[Columns, Columns], Iterator[PairAxes]]


def to_columns(side: Side, dtype: type = np.float64) -> Columns:
    """The shapes of a workload's side."""
    at, r = side if isinstance(side, tuple) else (side, None)
    at = at[:, None] if at.ndim == 2 else at
    x, y = (np.ascontiguousarray(at[:, :, i].T, dtype=dtype) for i in (0, 1))  # type: ignore[var-annotated]
    return Columns(x, y, None if r is None else r.astype(dtype))


def sat_hits(a: Columns, b: Columns, axes: AxisChoice, tolerance: float = 0.0) -> Hits:
    """A hit unless some axis of the choice leaves a gap of more than `tolerance`."""
    found = np.ones(a.x.shape[1], bool)
    with np.errstate(all="ignore"):
        for start in range(0, len(found), BLOCK_PAIRS):
            p, q = (_block(side, start) for side in (a, b))
            for axis in axes(p, q):
                lo_a, hi_a = project(p, axis)
                lo_b, hi_b = project(q, axis)
                # a repeated corner's edge has no direction: its gap is 0 or NaN, which separates nothing
                found[start : start + BLOCK_PAIRS] &= ~(np.maximum(lo_a - hi_b, lo_b - hi_a) > tolerance)
    return found


def project(c: Columns, axis: PairAxes) -> tuple[Array, Array]:
    """The ranges of all shapes on their axes."""
    nx, ny, length = axis
    lo = hi = c.x[0] * nx + c.y[0] * ny
    for x, y in zip(c.x[1:], c.y[1:]):
        landing = x * nx + y * ny
        lo, hi = np.minimum(lo, landing), np.maximum(hi, landing)
    return (lo, hi) if c.r is None else (lo - c.r * length, hi + c.r * length)


def edge_normals(a: Columns, b: Columns) -> Iterator[PairAxes]:
    """Every edge normal, A's first, not normalised."""
    circles = a.r is not None or b.r is not None
    for c in (a, b):
        for i in range(len(c.x) if len(c.x) > 1 else 0):
            nx, ny = c.y[i] - c.y[i - 1], c.x[i - 1] - c.x[i]
            yield PairAxes(nx, ny, np.hypot(nx, ny) if circles else 1.0)


def sat_axes(a: Columns, b: Columns) -> Iterator[PairAxes]:
    """The edge normals, and for a circle and a polygon the axis from the center to the nearest vertex."""
    yield from edge_normals(a, b)
    if a.r is not None or b.r is not None:
        circle, ring = (a, b) if a.r is not None else (b, a)
        x, y = ring.x - circle.x, ring.y - circle.y
        nearest = (x * x + y * y).argmin(axis=0), np.arange(x.shape[1])
        yield PairAxes(x[nearest], y[nearest], np.hypot(x[nearest], y[nearest]))


def with_unit_length(choice: AxisChoice) -> AxisChoice:
    """The same axes, each brought to length 1."""

    def normalised(a: Columns, b: Columns) -> Iterator[PairAxes]:
        for nx, ny, _ in choice(a, b):
            length = np.sqrt(nx * nx + ny * ny)
            yield PairAxes(nx / length, ny / length, 1.0)

    return normalised


def fixed_directions(k: int) -> AxisChoice:
    """k directions evenly over a half turn."""
    return lambda a, b: (PairAxes(x, y, 1.0) for x, y in even_directions(k))


def _block(c: Columns, start: int) -> Columns:
    stop = start + BLOCK_PAIRS
    return Columns(c.x[:, start:stop], c.y[:, start:stop], None if c.r is None else c.r[start:stop])
