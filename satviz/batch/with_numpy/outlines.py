"""Outlines of one number of corners validated while they are copied, in NumPy: a few expressions for all of them."""

import numpy as np

from ...engine.predicates import MAX_SAFE_PRODUCT, MIN_SAFE_PRODUCT
from ..array_types import Array, Indices, Mask
from ..arrays import CornerColumns
from ..exact_signs import ERRBOUND_A
from ..ragged import RaggedRings

BLOCK_CORNERS = 1 << 15  # corners at a time: they and the scratch arrays stay in the second-level cache
TURN_ERROR = 2.0**-51  # |error| <= 3.1 u |edge| |next edge| (u = 2**-53), rounded up to 4 u
MAX_PADDED_CORNERS = 1 << 15  # of padded arrays, which are checked all at once: few shapes


def certified_group(vertices: Array) -> CornerColumns | None:
    """Return (N, V, 2) outlines as a group, counter-clockwise; None if one is not certified convex.

    The orientation at a corner counts only if a float64 error bound certifies its sign, which no NaN, infinity or
    underflow passes.
    """
    n, corners = vertices.shape[:2]
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


def certified_circles(centers: Array, radii: Array) -> CornerColumns | None:
    """Return circles from (N, 2) centers and (N,) radii as a group; None if a number is not finite or not positive."""
    block = np.empty((3, 1, len(centers)))
    np.add(centers.T, 0.0, out=block[:2, 0])  # -0.0 becomes 0.0
    block[2, 0] = radii
    return CornerColumns(block) if np.isfinite(block).all() and (radii > 0).all() else None


def certified_padded(corners: Array, counts: Indices, radii: Array) -> RaggedRings | None:
    """Return few shapes in padded arrays, as `from_padded` takes them, as RaggedRings.

    None for many, or if one is not certified: a circle, or counter-clockwise, convex and without repeats.
    """
    n, most, _ = corners.shape
    if not (0 < n * most <= MAX_PADDED_CORNERS and np.minimum.reduce(counts) > 0 and np.maximum.reduce(counts) <= most):
        return None
    row = np.arange(most + 2)[:, None]
    own = row[:most] < counts
    # each outline goes on with its own first corners: what follows its last one is not read
    z = corners.reshape(-1).view(np.complex128).take(row % counts + np.arange(0, n * most, most))
    with np.errstate(all="ignore"):
        edges = z[1:] - z[:-1]
        turns = edges[:-1].conj() * edges[1:]
        size = np.abs(turns)
        left = (turns.imag > size * TURN_ERROR) & (size > MIN_SAFE_PRODUCT) & (size < MAX_SAFE_PRODUCT)
        rises = (edges.real > 0) | ((edges.real == 0) & (edges.imag > 0))
    once = np.add.reduce((rises[1:] != rises[:-1]) & own, axis=0) == 2
    are_polygons = np.logical_and.reduce(left, axis=0) & once & (radii == 0)
    are_circles = (counts == 1) & (radii > 0) & (radii < np.inf) & np.isfinite(z[0])
    if not (are_polygons | are_circles).all():
        return None
    start = np.zeros(n + 1, np.intp)
    np.cumsum(counts, out=start[1:])
    kept = z[:most].T[own.T] + 0.0  # -0.0 becomes 0.0
    return RaggedRings(kept.real.copy(), kept.imag.copy(), start)


def _turns_one_way(xy: Array) -> tuple[Mask, Mask] | None:
    """Return two masks of outlines (2, V, n): certified to turn left at each corner and go round once; or right.

    Return None if all turn left: for few outlines the masks would take as long as the rest.
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
    certified = None  # all
    if not (size.min(initial=1.0) > MIN_SAFE_PRODUCT and size.max(initial=1.0) < MAX_SAFE_PRODUCT):
        certified = ((size > MIN_SAFE_PRODUCT) & (size < MAX_SAFE_PRODUCT)).all(axis=0)
    if corners > 4:  # with 3 or 4 turns of one sign there is no going round twice
        rises = (dx > 0) | ((dx == 0) & (dy > 0))
        once = np.count_nonzero(rises[1:] != rises[:-1], axis=0) == 2
        certified = once if certified is None else certified & once
    size *= ERRBOUND_A
    if (certified is None or certified.all()) and (turn > size).all():
        return None
    left, right = ((way > size).all(axis=0) for way in (turn, -turn))
    return (left, right) if certified is None else (left & certified, right & certified)
