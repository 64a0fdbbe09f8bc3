"""Outlines of one number of corners validated while they are copied, in NumPy: a few expressions for all of them."""

from functools import lru_cache

import numpy as np

from ...engine.predicates import MIN_SAFE_PRODUCT
from ..array_types import Array, Complexes, Indices, Mask
from ..arrays import ComplexColumns, CornerColumns, Shapes
from ..exact_signs import ERRBOUND_A
from ..ragged import MAX_LANE_CORNERS

BLOCK_CORNERS = 1 << 15  # corners at a time: they and the scratch arrays stay in the second-level cache
TURN_ERROR = 2.0**-51  # |error| <= 3.1 u |edge| |next edge| (u = 2**-53), rounded up to 4 u
MAX_FEW = 64  # outlines that are checked in a few expressions, in the form in which few are evaluated
MAX_PADDED_CORNERS = 1 << 15  # padded arrays with up to so many corners are checked all at once


def certified_group(vertices: Array) -> CornerColumns | None:
    """Return (N, V, 2) outlines as a group, counter-clockwise; None if one is not certified convex.

    The orientation at a corner counts only if a float64 error bound certifies its sign, which no NaN, infinity or
    underflow passes.
    """
    n, corners = vertices.shape[:2]
    if 1 < n <= MAX_FEW and (few := _certified_columns(vertices) or _certified_columns(vertices[:, ::-1].copy())):
        return CornerColumns(as_complex=few)
    columns = np.empty((2, corners, n))
    size = max(1, BLOCK_CORNERS // corners)
    with np.errstate(all="ignore"):
        for start in range(0, n, size):
            part = columns[:, :, start : start + size]
            np.add(vertices[start : start + size].transpose(2, 1, 0), 0.0, out=part)  # -0.0 becomes 0.0
            if (ways := _turns_one_way(part)) is None:
                continue
            left, right = ways
            if right.any():
                part[:, :, right] = part[:, ::-1, right]
            if not (left | right).all():
                return None
    return CornerColumns(columns)


def _certified_columns(vertices: Array) -> ComplexColumns | None:
    """Return (N, V, 2) outlines as columns; None if one is not certified to be convex and counter-clockwise."""
    n, corners = vertices.shape[:2]
    closed = vertices.view(np.complex128).take(_closing_places(n, corners))
    edges, left = _certified_left(closed)
    if np.count_nonzero(left) < n * corners:
        return None
    # with 3 or 4 corners of one orientation there is no going round twice
    if corners > 4 and np.count_nonzero(_changes_along_x(edges)) > 2 * n:
        return None
    return ComplexColumns(closed[:-1], edges[:-1], None)


def _certified_left(closed: Complexes) -> tuple[Complexes, Mask]:
    """Return ((V + 1, n) edges, (V, n) mask of the edges after which the outline certainly turns left).

    closed: (V + 2, n) corners, the first two again at the end.
    """
    with np.errstate(all="ignore"):
        edges = closed[1:] - closed[:-1]
        turns = edges[:-1].conj() * edges[1:]
        # where a product overflows, so does the size
        return edges, turns.imag > np.abs(turns) * TURN_ERROR + MIN_SAFE_PRODUCT


def _changes_along_x(edges: Complexes) -> Mask:
    """Return a mask: does exactly one of this edge and the next one lead to smaller x?

    edges: (V + 1, n), the first one again at the end.  An outline that is counter-clockwise at all corners goes round
    once for every two of these.
    """
    rises = edges.real >= 0
    return np.asarray(rises[1:] != rises[:-1])


@lru_cache(maxsize=MAX_FEW * MAX_LANE_CORNERS)
def _closing_places(n: int, corners: int) -> Indices:
    """Return (V + 2, n) indices that put n outlines of V corners into columns, with their first two corners again."""
    return np.asarray(np.arange(corners + 2)[:, None] % corners + np.arange(0, n * corners, corners))


def certified_circles(centers: Array, radii: Array) -> CornerColumns | None:
    """Return circles from (N, 2) centers and (N,) radii as a group; None if a number is not finite or not positive."""
    n = len(radii)
    if not (n and np.count_nonzero(np.isfinite(centers)) == 2 * n and radii[radii.argmin()] > 0):
        return None
    if not radii[radii.argmax()] < np.inf:
        return None
    if n <= MAX_FEW:
        closed = centers.view(np.complex128).T.copy()
        return CornerColumns(as_complex=ComplexColumns(closed, closed[:0], radii.copy()))
    block = np.empty((3, 1, n))
    np.add(centers.T, 0.0, out=block[:2, 0])  # -0.0 becomes 0.0
    block[2, 0] = radii
    return CornerColumns(block)


def certified_padded(corners: Array, counts: Indices, radii: Array) -> Shapes | None:
    """Return few shapes in padded arrays, as `from_padded` takes them.

    None for many, or if one is not certified: a circle, or counter-clockwise, convex and without repeats.
    """
    n, most, _ = corners.shape
    if not (0 < n * most <= MAX_PADDED_CORNERS and counts[counts.argmin()] > 0 and counts[counts.argmax()] <= most):
        return None
    are_circles, row = radii > 0, np.arange(most + 2)[:, None]
    circles, polygons = np.count_nonzero(are_circles), np.count_nonzero(radii == 0)
    if circles + polygons < n or np.count_nonzero(are_circles != (counts == 1)) or not radii[radii.argmax()] < np.inf:
        return None
    for order in row, -1 - row:
        # each outline goes on with its own first corners: what follows its last one is not read
        closed = corners.reshape(-1).view(np.complex128).take(order % counts + np.arange(0, n * most, most))
        edges, left = _certified_left(closed)
        if (
            np.count_nonzero(left) == most * polygons  # a circle has none
            and np.count_nonzero(_changes_along_x(edges) & (row[:most] < counts)) == 2 * polygons
            and np.count_nonzero(np.isfinite(closed[0])) == n
        ):
            edges = edges[: most if polygons else 0]
            columns = ComplexColumns(closed[: len(edges) + 1], edges, radii + 0.0 if circles else None)
            return Shapes(as_complex=(columns, counts.astype(np.int64)))
    return None


def _turns_one_way(xy: Array) -> tuple[Mask, Mask] | None:
    """Return two (n,) masks of the outlines that certainly turn left at each corner and go round once; or right.

    xy: (2, V, n) corners.  Return None if all turn left: for few outlines the masks would take as long as the rest.
    """
    _, corners, n = xy.shape
    edges = np.empty((2, corners + 1, n))  # the last is the first one again
    np.subtract(xy[:, 1:], xy[:, :-1], out=edges[:, :-2])
    np.subtract(xy[:, 0], xy[:, -1], out=edges[:, -2])
    edges[:, -1] = edges[:, 0]
    dx, dy = edges
    ahead, behind = dx[:-1] * dy[1:], dy[:-1] * dx[1:]
    turn = ahead - behind
    size = np.abs(ahead, out=ahead)
    size += np.abs(behind, out=behind)
    certified = None  # all; where a product overflows, so does the size, and no turn is larger
    if not size.min(initial=1.0) > MIN_SAFE_PRODUCT:
        certified = (size > MIN_SAFE_PRODUCT).all(axis=0)
    if corners > 4:  # with 3 or 4 turns of one sign there is no going round twice
        rises = dx > 0  # each turn is less than 180 degrees, so each time round some edge rises and some edge does not
        once = np.count_nonzero(rises[1:] != rises[:-1], axis=0) == 2
        certified = once if certified is None else certified & once
    size *= ERRBOUND_A
    if (certified is None or certified.all()) and (turn > size).all():
        return None
    left, right = ((way > size).all(axis=0) for way in (turn, -turn))
    return (left, right) if certified is None else (left & certified, right & certified)
