"""Outlines of one number of corners validated while they are copied, in NumPy: a few expressions for all of them."""

import numpy as np

from ...engine.predicates import MAX_SAFE_PRODUCT, MIN_SAFE_PRODUCT
from ..array_types import Array, Mask
from ..arrays import Group
from ..exact_signs import ERRBOUND_A

BLOCK_CORNERS = 1 << 15  # corners at a time: they and the scratch arrays stay in the second-level cache


def certified_group(vertices: Array) -> Group | None:
    """Return (N, V, 2) outlines as a group, counter-clockwise; None if one is not certified convex.

    A turn counts only where a float64 error bound certifies its sign, which no NaN, infinity or underflow passes."""
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
    return Group(columns)


def certified_circles(centers: Array, radii: Array) -> Group | None:
    """Return circles from (N, 2) centers and (N,) radii as a group; None if a number is not finite or not positive."""
    block = np.empty((3, 1, len(centers)))
    np.add(centers.T, 0.0, out=block[:2, 0])  # -0.0 becomes 0.0
    block[2, 0] = radii
    return Group(block) if np.isfinite(block).all() and (radii > 0).all() else None


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
