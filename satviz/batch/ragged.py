"""Outlines stored one after another (ragged arrays), for shapes with different numbers of corners."""

from typing import NamedTuple

import numpy as np

from .array_types import Array, Indices, Mask

MAX_LANE_CORNERS = 8  # corners up to which pairs are evaluated side by side, in columns or lanes


class RaggedRings(NamedTuple):
    """Hold N outlines with different numbers of corners: outline i has those from start[i] to start[i + 1].

    x, y: (M,) corners of all outlines, in scene units; start: (N + 1,).
    """

    x: Array
    y: Array
    start: Indices

    def select(self, mask: Mask) -> "RaggedRings":
        """Return the outlines where `mask`, one value per outline, is True."""
        return self if mask.all() else self.keep_corners(np.repeat(mask, np.diff(self.start)), mask)

    def keep_corners(self, kept: Mask, mask: Mask | None = None) -> "RaggedRings":
        """Return the outlines where `mask` (None: all) is True, with only the corners where `kept`, (M,), is True.

        `kept` must be False at all corners of the outlines that `mask` drops.
        """
        ends = np.concatenate([[0], np.cumsum(kept)])[self.start]
        start = ends if mask is None else np.concatenate([[0], np.cumsum(np.diff(ends)[mask])])
        return RaggedRings(self.x[kept], self.y[kept], start)

    def take(self, where: Indices) -> "RaggedRings":
        """Return the outlines with the indices `where`, in this order."""
        many = np.diff(self.start)[where]
        start = np.concatenate([[0], np.cumsum(many)])
        corners = np.arange(start[-1]) + np.repeat(self.start[where] - start[:-1], many)
        return RaggedRings(self.x[corners], self.y[corners], start)


def concat_rings(many: list[RaggedRings]) -> RaggedRings:
    """Return the outlines of several RaggedRings, in order."""
    counts = [np.diff(rings.start) for rings in many]
    x, y = (np.concatenate([np.empty(0), *(rings[i] for rings in many)]) for i in (0, 1))
    return RaggedRings(x, y, np.cumsum(np.concatenate([[0], *counts])))
