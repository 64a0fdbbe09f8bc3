"""Outlines stored one after another (ragged arrays), for shapes with different numbers of corners."""

from typing import NamedTuple

import numpy as np

from .array_types import Array, Indices, Mask

MAX_LANE_CORNERS = 8  # corners up to which pairs are evaluated side by side, in columns or lanes


class Rings(NamedTuple):
    """Hold N outlines: outline i has the corners start[i] to start[i + 1] of x and y, in scene units."""

    x: Array
    y: Array
    start: Indices

    def select(self, mask: Mask) -> "Rings":
        """Return the outlines where `mask`, one value per outline, is True."""
        return self if mask.all() else self.keep_corners(np.repeat(mask, np.diff(self.start)), mask)

    def keep_corners(self, kept: Mask, mask: Mask | None = None) -> "Rings":
        """Return the outlines where `mask` is True, with only the corners where `kept` (one per corner) is True.

        `kept` must be False at all corners of the outlines that `mask` drops.
        """
        ends = np.concatenate([[0], np.cumsum(kept)])[self.start]
        start = ends if mask is None else np.concatenate([[0], np.cumsum(np.diff(ends)[mask])])
        return Rings(self.x[kept], self.y[kept], start)

    def take(self, where: Indices) -> "Rings":
        """Return the outlines with the indices `where`, in this order."""
        many = np.diff(self.start)[where]
        start = np.concatenate([[0], np.cumsum(many)])
        corners = np.arange(start[-1]) + np.repeat(self.start[where] - start[:-1], many)
        return Rings(self.x[corners], self.y[corners], start)


def concat_rings(many: list[Rings]) -> Rings:
    """Return the outlines of several Rings, in order."""
    counts = [np.diff(rings.start) for rings in many]
    x, y = (np.concatenate([np.empty(0), *(rings[i] for rings in many)]) for i in (0, 1))
    return Rings(x, y, np.cumsum(np.concatenate([[0], *counts])))
