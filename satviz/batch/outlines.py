"""Many outlines checked at once, by the rules of satviz.Polygon: repeats, winding, and which are convex, exactly.

Outlines lie one after another: (M,) x and y, and the (N + 1,) places where each starts and the last one ends.
"""

from itertools import pairwise
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from . import exact_signs
from .array_types import Array, Indices, Mask
from .ragged import RaggedRings, concat_rings

Value = TypeVar("Value", np.float64, np.bool_)

BLOCK_CORNERS = 1 << 15  # corners at a time: they and the scratch arrays stay in the second-level cache


def convex_rings(rings: RaggedRings) -> tuple[RaggedRings, Mask]:
    """Return (the convex outlines, counter-clockwise, without repeated or straight-on corners; the (N,) mask of them).

    The others are concave or no valid polygons: satviz.Polygon says which.  The arrays given may be overwritten.
    """
    found, masks = [], []
    full = np.searchsorted(rings.start, np.arange(BLOCK_CORNERS, rings.start[-1], BLOCK_CORNERS), side="right") - 1
    cuts = np.unique(np.concatenate([[0], full, [len(rings.start) - 1]]))
    for i, j in pairwise(cuts):
        start = rings.start[i : j + 1]
        part = slice(start[0], start[-1])
        some, mask = _convex_in_block(RaggedRings(rings.x[part], rings.y[part], start - start[0]))
        found.append(some)
        masks.append(mask)
    mask = np.concatenate([np.zeros(0, bool), *masks])
    if mask.all() and sum(len(some.x) for some in found) == len(rings.x):  # none left out; turned round in place
        return rings, mask
    return concat_rings(found), mask


def _convex_in_block(rings: RaggedRings) -> tuple[RaggedRings, Mask]:
    """Return (the convex outlines of one block, their mask), as `convex_rings` does for all blocks."""
    many = np.diff(rings.start) > 2
    ring = rings.select(many)
    fresh = (ring.x != _previous_in_ring(ring.x, ring.start)) | (ring.y != _previous_in_ring(ring.y, ring.start))
    if not fresh.all():
        ring = ring.keep_corners(fresh)
        enough = np.diff(ring.start) > 2
        many[many] = enough
        ring = ring.select(enough)
    x, y, start = ring
    if len(start) == 1:
        return ring, many
    px, py, nx, ny = (way(c, start) for way in (_previous_in_ring, _next_in_ring) for c in (x, y))
    turns = exact_signs.orient(px, py, x, y, nx, ny)
    first = start[:-1]
    least, most = np.minimum.reduceat(turns, first), np.maximum.reduceat(turns, first)
    # straight on is no corner; straight back comes with turns both ways, with going round twice, or with no turn at all
    plain = (least >= 0) != (most <= 0)
    if np.diff(start).max() > 4:  # with 3 or 4 corners the same way there is no going round twice
        rises = _leads_right(x, y, nx, ny)
        plain &= np.add.reduceat(rises != _previous_in_ring(rises, start), first) == 2
    back = most <= 0
    many[many] = plain
    if not turns.all():
        ring = ring.keep_corners(turns != 0)
    return _reverse_rings(ring.select(plain), back[plain]), many


def _previous_in_ring(c: NDArray[Value], start: Indices) -> NDArray[Value]:
    """Return the (M,) values c of the corner before each corner, in its outline."""
    found = np.empty_like(c)
    found[1:] = c[:-1]
    found[start[:-1]] = c[start[1:] - 1]
    return found


def _next_in_ring(c: NDArray[Value], start: Indices) -> NDArray[Value]:
    """Return the (M,) values c of the corner after each corner, in its outline."""
    found = np.empty_like(c)
    found[:-1] = c[1:]
    found[start[1:] - 1] = c[start[:-1]]
    return found


def _leads_right(px: Array, py: Array, qx: Array, qy: Array) -> Mask:
    """Return the mask of the steps from p to q that go to the right, or straight up."""
    rises: Mask = (qx > px) | ((qx == px) & (qy > py))
    return rises


def _reverse_rings(ring: RaggedRings, back: Mask) -> RaggedRings:
    """Reverse, in place, the corners of the outlines where `back`, (N,), is True; return all outlines."""
    if not back.any():
        return ring
    x, y, start = ring
    count = np.diff(start)
    places = np.flatnonzero(np.repeat(back, count))
    source = np.repeat((start[:-1] + start[1:] - 1)[back], count[back]) - places
    x[places], y[places] = x[source], y[source]
    return ring
