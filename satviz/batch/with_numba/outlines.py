"""Outlines validated while they are copied, compiled with numba: finite, convex, counter-clockwise, without repeats.

The orientation at a corner counts only if a float64 error bound certifies its sign, which no NaN, infinity or
underflow passes.
What is not certified is left to `outlines.convex_rings`, which decides exactly.
"""

from collections.abc import Callable

import numpy as np

from ...engine.predicates import MIN_SAFE_PRODUCT
from ..array_types import Array, Indices
from ..arrays import TILE_SHAPES, CornerColumns, Shapes
from ..exact_signs import ERRBOUND_A
from ..ragged import RaggedRings
from .jit_cache import compiled, inlined

MAX_FEW_CORNERS = 1 << 12  # arrays up to this length are not cut off, which takes longer than the memory is worth


def certified_group(vertices: Array) -> CornerColumns | None:
    """Return (N, V, 2) outlines as a group, counter-clockwise; None if one is not certified convex."""
    n, corners, _ = vertices.shape
    columns, maxima = np.empty((2, corners, n)), np.empty((2, -(-n // TILE_SHAPES)))
    kernel = (_fill_columns_3, _fill_columns_4)[corners - 3] if corners <= 4 else _fill_columns
    if not kernel(vertices, columns, maxima):
        return None
    return CornerColumns(columns, maxima)


def certified_circles(centers: Array, radii: Array) -> CornerColumns | None:
    """Return circles from (N, 2) centers and (N,) radii as a group; None if a number is not finite or not positive."""
    block = np.empty((3, 1, len(centers)))
    return CornerColumns(block) if _fill_circles(centers, radii, block) else None


@compiled
def _fill_circles(centers: Array, radii: Array, block: Array) -> bool:
    """Fill the (3, 1, n) block with x, y and radii of circles; return whether all are finite and radii positive."""
    for i in range(radii.size):
        x, y, r = centers[i, 0], centers[i, 1], radii[i]
        if not (abs(x) < np.inf and abs(y) < np.inf and 0 < r < np.inf):
            return False
        block[0, 0, i], block[1, 0, i], block[2, 0, i] = x + 0.0, y + 0.0, r  # no -0.0
    return True


def _columns_kernel(fixed: int | None) -> Callable[[Array, Array, Array], bool]:
    """Return the kernel of `certified_group` compiled for `fixed` corners, or for any number (None)."""

    @compiled
    def fill_columns(vertices: Array, columns: Array, maxima: Array) -> bool:
        """Fill (2, V, n) columns and (2, tiles) maxima for CornerColumns; return whether all are certified convex."""
        corners = vertices.shape[1] if fixed is None else fixed
        for tile in range(maxima.shape[1]):
            max_edge = max_coordinate = 0.0
            for i in range(tile * TILE_SHAPES, min((tile + 1) * TILE_SHAPES, vertices.shape[0])):
                left = right = changes = 0
                for v in range(corners):
                    w = v + 1 if v + 1 < corners else 0
                    u = w + 1 if w + 1 < corners else 0
                    vx, vy, wx, wy = vertices[i, v, 0], vertices[i, v, 1], vertices[i, w, 0], vertices[i, w, 1]
                    dx, dy, ex, ey = wx - vx, wy - vy, vertices[i, u, 0] - wx, vertices[i, u, 1] - wy
                    turn = _certified_orientation(dx, dy, ex, ey)
                    left += turn > 0
                    right += turn < 0
                    changes += (dx > 0) != (ex > 0)
                    max_edge = max(max_edge, max(abs(dx), abs(dy)))
                    max_coordinate = max(max_coordinate, max(abs(vx), abs(vy)))
                # turns of one sign, each below half a round, go round once if they are at most 4, or if the way along x
                # changes twice: no such turn skips all ways to the right, or all others
                if (left != corners and right != corners) or (corners > 4 and changes != 2):
                    return False
                for v in range(corners):
                    w = v if left else corners - 1 - v
                    columns[0, v, i], columns[1, v, i] = vertices[i, w, 0] + 0.0, vertices[i, w, 1] + 0.0  # no -0.0
            maxima[0, tile], maxima[1, tile] = max_edge, max_coordinate
        return True

    return fill_columns


_fill_columns_3, _fill_columns_4, _fill_columns = map(_columns_kernel, (3, 4, None))


def certified_rings(points: Array, start: Indices, accept_centers: bool = False) -> tuple[RaggedRings, Indices]:
    """Return (all outlines, without repeats and counter-clockwise; the indices of those not certified convex).

    points: (M, 2) corners, those of outline i from start[i] to start[i + 1].  `accept_centers`: a single finite
    corner is the center of a circle and certified too.  What is not certified may be clockwise or no polygon.
    """
    x, y, kept = np.empty(len(points)), np.empty(len(points)), np.empty(len(start), np.intp)
    doubtful = np.empty(len(start) - 1, np.intp)
    found = _fill_rings(points, start[:-1], start[1:], accept_centers, x, y, kept, doubtful)
    return _rings_of(x, y, kept), doubtful[:found]


def _rings_of(x: Array, y: Array, kept: Indices) -> RaggedRings:
    """Return RaggedRings of x and y, cut off after the last corner; long arrays are shrunk in place.

    kept: (N + 1,) the place where each outline starts, and the end of the last one.
    """
    end = int(kept[-1])
    if len(x) <= MAX_FEW_CORNERS:
        return RaggedRings(x[:end], y[:end], kept)
    for c in (x, y):
        c.resize(end, refcheck=False)  # a copy would double the memory
    return RaggedRings(x, y, kept)


def certified_padded(corners: Array, counts: Indices, radii: Array) -> Shapes | None:
    """Return shapes in padded arrays, as `from_padded` takes them; None if one is not certified."""
    n, most, _ = corners.shape
    x, y, kept = np.empty(n * most), np.empty(n * most), np.empty(n + 1, np.intp)
    if not _fill_padded(corners, counts, radii, x, y, kept):
        return None
    return Shapes(rings=_rings_of(x, y, kept), radius=radii + 0.0)


@compiled
def _fill_padded(corners: Array, counts: Indices, radii: Array, x: Array, y: Array, kept: Indices) -> bool:
    """Fill x, y and `kept` as `_fill_rings` does, with padded shapes; return whether all are certified."""
    n, most, _ = corners.shape
    first, end = np.empty(n, np.intp), np.empty(n, np.intp)
    for i in range(n):
        # a circle has one corner and a radius, a polygon has corners and none
        if not (1 <= counts[i] <= most and 0 <= radii[i] < np.inf and (counts[i] == 1) == (radii[i] > 0)):
            return False
        first[i], end[i] = i * most, i * most + counts[i]
    return _fill_rings(corners.reshape(-1, 2), first, end, True, x, y, kept, np.empty(n, np.intp)) == 0


@compiled
def _fill_rings(
    points: Array, start: Indices, end: Indices, accept_centers: bool,
    x: Array, y: Array, kept: Indices, doubtful: Indices,
) -> int:  # fmt: skip
    """Copy the outlines into x and y without repeated corners, counter-clockwise; return how many are doubtful.

    start, end: outline i has the points start[i] to end[i] - 1.  kept: filled with where each outline starts in x and
    y, and the end.  doubtful: filled with the indices of the outlines that are not certified convex.  accept_centers:
    a single finite corner is a circle's center, and certified.
    """
    kept[0] = found = to = 0
    for i in range(start.size):
        first = to
        for j in range(start[i], end[i]):
            px, py = points[j, 0] + 0.0, points[j, 1] + 0.0  # -0.0 becomes 0.0
            if to == first or px != x[to - 1] or py != y[to - 1]:
                x[to], y[to] = px, py
                to += 1
        while to - first > 1 and x[to - 1] == x[first] and y[to - 1] == y[first]:
            to -= 1
        left = right = changes = 0
        corners = to - first
        for v in range(first, to):
            w = v + 1 if v + 1 < to else first
            u = w + 1 if w + 1 < to else first
            dx, dy, ex, ey = x[w] - x[v], y[w] - y[v], x[u] - x[w], y[u] - y[w]
            turn = _certified_orientation(dx, dy, ex, ey)
            left += turn > 0
            right += turn < 0
            changes += (dx > 0) != (ex > 0)
        if accept_centers and end[i] - start[i] == 1 and np.isfinite(x[first]) and np.isfinite(y[first]):
            pass
        elif corners < 3 or (left != corners and right != corners) or changes != 2:
            doubtful[found] = i
            found += 1
        elif right:
            for v in range(corners // 2):
                j, k = first + v, to - 1 - v
                x[j], x[k] = x[k], x[j]
                y[j], y[k] = y[k], y[j]
        kept[i + 1] = to
    return found


@inlined
def _certified_orientation(dx: float, dy: float, ex: float, ey: float) -> int:
    """Return 1 for a certain left turn from edge vector d to e, -1 for a right turn, 0 where rounding may hide it."""
    ahead, behind = dx * ey, dy * ex
    size = abs(ahead) + abs(behind)
    certified = (abs(ahead - behind) > ERRBOUND_A * size) & (size > MIN_SAFE_PRODUCT)  # nothing exceeds inf or nan
    return (1 if ahead > behind else -1) if certified else 0
