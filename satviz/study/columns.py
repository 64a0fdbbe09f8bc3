"""Many pairs at once, as it is usually written with NumPy: one loop over a choice of axes, in blocks."""

from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from .plain import spread
from .workloads import Side

Array = NDArray[np.floating]
Answers = NDArray[np.bool_]
BLOCK = 1 << 14  # pairs: what fits in the cache


class Columns(NamedTuple):
    """Shapes as arrays: x, y (V, N) corners, the last repeated where one has fewer; r (N,) of circles, else None."""

    x: Array
    y: Array
    r: Array | None


class Axes(NamedTuple):
    """One axis a pair: the direction (nx, ny) and its length, arrays or numbers."""

    nx: Array | float
    ny: Array | float
    length: Array | float


Choice = Callable[[Columns, Columns], Iterator[Axes]]


def columns(side: Side, dtype: type = np.float64) -> Columns:
    """The shapes of a workload's side."""
    at, r = side if isinstance(side, tuple) else (side, None)
    at = at[:, None] if at.ndim == 2 else at
    x, y = (np.ascontiguousarray(at[:, :, i].T, dtype=dtype) for i in (0, 1))
    return Columns(x, y, None if r is None else r.astype(dtype))


def as_ngons(side: Side, n: int) -> Columns:
    """Circles as the regular n-gons inscribed in them; polygons as they are."""
    c = columns(side)
    if c.r is None:
        return c
    turn = 2 * np.pi * np.arange(n)[:, None] / n
    return Columns(c.x + c.r * np.cos(turn), c.y + c.r * np.sin(turn), None)


def hits(a: Columns, b: Columns, axes: Choice, tolerance: float = 0.0) -> Answers:
    """A hit unless some axis of the choice leaves a gap of more than `tolerance`."""
    found = np.ones(a.x.shape[1], bool)
    with np.errstate(all="ignore"):
        for start in range(0, len(found), BLOCK):
            p, q = (_part(side, start) for side in (a, b))
            for axis in axes(p, q):
                lo_a, hi_a = span(p, axis)
                lo_b, hi_b = span(q, axis)
                # a repeated corner's edge has no direction: its gap is 0 or NaN, which separates nothing
                found[start : start + BLOCK] &= ~(np.maximum(lo_a - hi_b, lo_b - hi_a) > tolerance)
    return found


def span(c: Columns, axis: Axes) -> tuple[Array, Array]:
    """The ranges of all shapes on their axes."""
    nx, ny, length = axis
    lo = hi = c.x[0] * nx + c.y[0] * ny
    for x, y in zip(c.x[1:], c.y[1:]):
        landing = x * nx + y * ny
        lo, hi = np.minimum(lo, landing), np.maximum(hi, landing)
    return (lo, hi) if c.r is None else (lo - c.r * length, hi + c.r * length)


def edge_normals(a: Columns, b: Columns) -> Iterator[Axes]:
    """Every edge normal, A's first, not normalised."""
    circles = a.r is not None or b.r is not None
    for c in (a, b):
        for i in range(len(c.x) if len(c.x) > 1 else 0):
            nx, ny = c.y[i] - c.y[i - 1], c.x[i - 1] - c.x[i]
            yield Axes(nx, ny, np.hypot(nx, ny) if circles else 1.0)


def complete(a: Columns, b: Columns) -> Iterator[Axes]:
    """The edge normals, and for a circle and a polygon the axis from the center to the nearest vertex."""
    yield from edge_normals(a, b)
    if a.r is not None or b.r is not None:
        circle, ring = (a, b) if a.r is not None else (b, a)
        x, y = ring.x - circle.x, ring.y - circle.y
        nearest = (x * x + y * y).argmin(axis=0), np.arange(x.shape[1])
        yield Axes(x[nearest], y[nearest], np.hypot(x[nearest], y[nearest]))


def unit(choice: Choice) -> Choice:
    """The same axes, each brought to length 1."""

    def normalised(a: Columns, b: Columns) -> Iterator[Axes]:
        for nx, ny, _ in choice(a, b):
            length = np.sqrt(nx * nx + ny * ny)
            yield Axes(nx / length, ny / length, 1.0)

    return normalised


def middles(c: Columns) -> tuple[Array, Array]:
    """The means of the corners, repeated ones counted once."""
    once = np.ones(c.x.shape, bool)
    once[1:] = (c.x[1:] != c.x[:-1]) | (c.y[1:] != c.y[:-1])
    count = once.sum(axis=0)
    return (c.x * once).sum(axis=0) / count, (c.y * once).sum(axis=0) / count


def centroids(a: Columns, b: Columns) -> Iterator[Axes]:
    """The one axis through the means of the corners."""
    (ax, ay), (bx, by) = middles(a), middles(b)
    nx, ny = bx - ax, by - ay
    yield Axes(nx, ny, np.hypot(nx, ny))


def fixed(k: int) -> Choice:
    """k directions evenly over a half turn."""
    return lambda a, b: (Axes(x, y, 1.0) for x, y in spread(k))


def ranges(side: Side, k: int) -> list[tuple[Array, Array]]:
    """The ranges on k fixed directions, to be kept with the shapes."""
    c = columns(side)
    return [span(c, axis) for axis in fixed(k)(c, c)]


def ranges_overlap(a: list[tuple[Array, Array]], b: list[tuple[Array, Array]]) -> Answers:
    """Do kept ranges overlap or touch on every direction?"""
    found = np.ones(len(a[0][0]), bool)
    for (lo_a, hi_a), (lo_b, hi_b) in zip(a, b):
        found &= (lo_a <= hi_b) & (lo_b <= hi_a)
    return found


def around(side: Side) -> Columns:
    """Circles round the means of the corners that hold them all."""
    c = columns(side)
    x, y = middles(c)
    far = np.hypot(c.x - x, c.y - y).max(axis=0)
    return Columns(x[None], y[None], far if c.r is None else far + c.r)


def circles_overlap(a: Columns, b: Columns) -> Answers:
    """Are the centers within the sum of the radii?"""
    return (a.x[0] - b.x[0]) ** 2 + (a.y[0] - b.y[0]) ** 2 <= (a.r + b.r) ** 2


def _part(c: Columns, start: int) -> Columns:
    stop = start + BLOCK
    return Columns(c.x[:, start:stop], c.y[:, start:stop], None if c.r is None else c.r[start:stop])
