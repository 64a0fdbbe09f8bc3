"""Few shapes, in NumPy: which boxes meet by comparing all or by sorting and sweeping, and all collisions of few."""

from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from ...engine.relate import ERROR_FACTOR_F64, MAX_ERROR_BOUND, MIN_ERROR_BOUND
from ..array_types import Array, Indices, Pairs, Signs
from ..arrays import Group, Shapes
from ..broad_rule import ALL_PAIRS, GRID, MAX_ALL_PAIRS, MAX_SWEEP_COMPARISONS, MAX_SWEEP_NUMPY, SWEEP
from ..codes import APART, OVERLAPPING, UNDECIDED
from .filter import circle_polygon_gaps, circles, classify_clearances
from .indexed import relations

MAX_WHOLE_NUMBERS = 480  # coordinates up to which all pairs of polygons are tested without comparing boxes first
MAX_SHAPES, MAX_CORNERS = 1 << 12, 8  # above these, blocks of pairs in float32 are faster
MAX_PRODUCTS = 1 << 17  # of normals and corners at a time, so that they stay in the second-level cache
# row V: the corners of an outline with V corners, again and again
CLOSING = np.arange(MAX_CORNERS + 1) % np.maximum(1, np.arange(MAX_CORNERS + 1))[:, None]
OUTWARD = np.array([1.0, -1.0])[:, None, None]  # turns (dy, dx) of a counter-clockwise edge into its outward normal


class Sweep(NamedTuple):
    """Boxes sorted along an axis: `order` by their lower sides, `ends` for each the place after the last it reaches.

    axis: 0 for x, 1 for y; order and ends: (n,); comparisons: how many pairs of boxes the sweep compares.
    """

    axis: int
    order: Indices
    ends: Indices
    comparisons: int


def candidate_pairs(bounds: Array) -> tuple[Pairs | None, int, int]:
    """Return (pairs i < j of boxes that share a point, code of the broad phase, its comparisons or -1).

    The broad phase is chosen by the rule of `broad_rule`; None for the pairs where it is a grid.
    """
    n = len(bounds)
    if n <= MAX_ALL_PAIRS:
        return _meeting_of_all(bounds.T[:2], bounds.T[2:]), ALL_PAIRS, n * (n - 1) // 2
    if n > MAX_SWEEP_NUMPY:
        return None, GRID, -1
    low, high = bounds.T[:2], bounds.T[2:]
    with np.errstate(all="ignore"):
        (spread_x, spread_y), (width, height) = low.max(axis=1) - low.min(axis=1), (high - low).max(axis=1)
        axis = 0 if spread_x * height >= spread_y * width else 1
    sweep = _sorted(bounds, axis)
    if sweep.comparisons > MAX_SWEEP_COMPARISONS * n:
        sweep = min(sweep, _sorted(bounds, 1 - axis), key=lambda one: one.comparisons)
    if sweep.comparisons > MAX_SWEEP_COMPARISONS * n:
        return None, GRID, sweep.comparisons
    return _swept_pairs(bounds, sweep), SWEEP, sweep.comparisons


def _sorted(bounds: Array, axis: int) -> Sweep:
    """Return the boxes sorted along an axis."""
    n = len(bounds)
    order = np.argsort(bounds[:, axis])
    ends = np.searchsorted(bounds[order, axis], bounds[order, axis + 2], side="right")
    return Sweep(axis, order, ends, int(ends.sum()) - n * (n + 1) // 2)


def _swept_pairs(bounds: Array, sweep: Sweep) -> Pairs:
    """Return the pairs i < j of sorted boxes that share a point."""
    first = np.arange(1, len(bounds) + 1)
    many = sweep.ends - first
    later = np.arange(many.sum()) + np.repeat(first - (np.cumsum(many) - many), many)
    low, high = bounds[sweep.order, 1 - sweep.axis], bounds[sweep.order, 3 - sweep.axis]  # on the other axis
    meet = np.flatnonzero((np.repeat(low, many) <= high[later]) & (low[later] <= np.repeat(high, many)))
    i, j = sweep.order[np.repeat(first - 1, many)[meet]], sweep.order[later[meet]]
    return np.stack([np.minimum(i, j), np.maximum(i, j)], axis=1)


@lru_cache(maxsize=MAX_ALL_PAIRS + 1)
def _all_pairs(n: int) -> tuple[Pairs, Indices]:
    """Return the pairs i < j of n boxes in order, and the place of each in an (n, n) array."""
    i, j = np.triu_indices(n, 1)
    return np.stack([i, j], axis=1), i * n + j


def _meeting_of_all(low: Array, high: Array) -> Pairs:
    """Return the pairs i < j of boxes that share a point, in order, by comparing all; low, high: (2, n) sides."""
    before = low[:, :, None] <= high[:, None]  # does box i begin on this axis before box j ends?
    meet = before[0] & before[1]
    meet &= meet.T
    pairs, places = _all_pairs(low.shape[1])
    return pairs.take(np.flatnonzero(meet.take(places)), axis=0)


def colliding_pairs(shapes: Shapes) -> Pairs | None:
    """Return the pairs i < j, in order, of few shapes that share a point; None where others must decide.

    All pairs of a kind are evaluated in float64 by a few expressions, since calls take longer than the work.
    """
    closed, radius = _closed_columns(shapes)
    if closed is None:
        return None
    found: Signs | None
    n = closed.shape[2]
    with np.errstate(all="ignore"):
        is_upright = radius is None and _are_upright(closed)
        if radius is None and not is_upright and n <= MAX_ALL_PAIRS and closed.size <= MAX_WHOLE_NUMBERS:
            pairs, found = _all_pairs(n)[0], _relate_polygons(closed, None)
        else:
            low, high = np.minimum.reduce(closed, axis=1), np.maximum.reduce(closed, axis=1)
            if radius is not None:
                low, high = np.nextafter(low - radius, -np.inf), np.nextafter(high + radius, np.inf)
            meeting, *_ = candidate_pairs(np.concatenate([low, high]).T)
            if meeting is None:
                return None
            pairs, found = meeting, None if is_upright else _relations(closed, radius, *meeting.T)
    if found is not None:
        rest = np.flatnonzero(found == UNDECIDED)
        if rest.size:
            settled = np.empty(len(rest), np.int8)
            relations(shapes.flat, pairs[rest, 0], shapes.flat, pairs[rest, 1], settled)
            if settled.min() == UNDECIDED:  # circles that nearly touch
                return None
            found[rest] = settled
        pairs = pairs.take(np.flatnonzero(found != APART), axis=0)
    return pairs if n <= MAX_ALL_PAIRS else np.asarray(pairs[np.lexsort((pairs[:, 1], pairs[:, 0]))])


def _are_upright(closed: Array) -> bool:
    """Return whether all outlines are boxes with sides along x and y: four corners, and each step along an axis."""
    if closed.shape[1] != 5 or (closed[0, 0, 0] != closed[0, 1, 0] and closed[1, 0, 0] != closed[1, 1, 0]):
        return False  # mostly the first outline tells
    level = closed[:, 1:] == closed[:, :-1]
    return bool((level[0] != level[1]).all())


def _relations(closed: Array, radius: Array | None, i: Indices, j: Indices) -> Signs:
    """Return the relations of shapes i[k] and j[k], UNDECIDED within the error bound."""
    if radius is None:
        return _relate_polygons(closed, (i, j))
    found = np.empty(len(i), np.int8)
    x, y, is_circle = closed[0, 0], closed[1, 0], radius > 0
    circle_count = is_circle[i].view(np.int8) + is_circle[j].view(np.int8)
    for kind in (0, 1, 2):
        where = np.flatnonzero(circle_count == kind)
        if not where.size:
            continue
        a, b = i[where], j[where]
        if kind == 0:
            found[where] = _relate_polygons(closed, (a, b))
            continue
        out = np.empty(len(where), np.int8)
        if kind == 2:
            circles(x[a], y[a], radius[a], x[b], y[b], radius[b], 0, out)
        else:
            a, b = np.where(is_circle[a], (a, b), (b, a))
            classify_clearances(*circle_polygon_gaps(x[a], y[a], radius[a], closed.take(b, axis=2)), out)
        found[where] = out
    return found


def _relate_polygons(closed: Array, pairs: tuple[Indices, Indices] | None) -> Signs:
    """Return the relations of polygons i[k] and j[k], UNDECIDED within the error bound; None: of all pairs i < j."""
    edges = closed[:, 1:] - closed[:, :-1]
    if pairs is None:
        (i, j), places = _all_pairs(closed.shape[2])[0].T, _all_pairs(closed.shape[2])[1]
        gap = _gaps_of_all(closed[:, :-1], edges).take(places)
    else:
        i, j = pairs
        gap = _gaps(closed[:, :-1], edges, i, j)
    largest = [np.abs(c) for c in (edges, closed)]
    error_bound: Array = 4 * largest[0].max() * largest[1].max() * ERROR_FACTOR_F64  # of all, then pair by pair
    if MIN_ERROR_BOUND < error_bound < MAX_ERROR_BOUND and (np.abs(gap) > error_bound).all():
        return np.multiply(gap < 0, OVERLAPPING, dtype=np.int8)
    out = np.empty(len(i), np.int8)
    edge, coordinate = (c.max(axis=(0, 1)) for c in largest)
    error_bound = (edge[i] + edge[j]) * (coordinate[i] + coordinate[j]) * ERROR_FACTOR_F64
    error_bound[~((error_bound > MIN_ERROR_BOUND) & (error_bound < MAX_ERROR_BOUND))] = np.inf
    classify_clearances(gap, error_bound, out)
    return out


def _gaps(corners: Array, edges: Array, i: Indices, j: Indices) -> Array:
    """Return for polygons i[k] and j[k] the largest clearance of an edge of one over the corners of the other."""
    normals = edges[::-1] * OUTWARD
    own, other = np.concatenate([i, j]), np.concatenate([j, i])
    at = normals * corners
    at = at[0] + at[1]
    gap = np.empty(len(own))
    size = MAX_PRODUCTS // len(at) ** 2
    for start in range(0, len(own), size):
        part = slice(start, start + size)
        products = normals.take(own[part], axis=2)[:, :, None] * corners.take(other[part], axis=2)[:, None]
        values = np.add(products[0], products[1], out=products[0])
        least = np.minimum.reduce(values, axis=1)
        least -= at.take(own[part], axis=1)
        np.maximum.reduce(least, axis=0, out=gap[part])
    return np.asarray(np.maximum(gap[: len(i)], gap[len(i) :]))


def _gaps_of_all(corners: Array, edges: Array) -> Array:
    """Return what `_gaps` returns for all pairs of n polygons, (n, n): each normal with each corner in one product."""
    _, many, n = corners.shape
    normals = edges[::-1] * OUTWARD
    at = normals * corners
    values = corners.reshape(2, -1).T @ normals.reshape(2, -1)  # corner by corner of each shape, edge by edge of each
    least = np.minimum.reduce(values.reshape(many, n, many, n), axis=0)
    least -= at[0] + at[1]
    gap = np.maximum.reduce(least, axis=1)
    return np.asarray(np.maximum(gap, gap.T))


def _closed_columns(shapes: Shapes) -> tuple[Array | None, Array | None]:
    """Return ((2, V + 1, n) corners, one column a shape, or None for many shapes or corners; radii if there are any).

    The row after an outline's last corner starts it again.
    """
    if not 1 < shapes.part_count <= MAX_SHAPES:
        return None, None
    if (runs := vars(shapes).get("runs")) is not None:  # read once, since another thread may join them
        return _closed_runs(runs)
    if shapes.max_corners > MAX_CORNERS:
        return None, None
    x, y, start = shapes.rings
    places = start[:-1] + np.arange(shapes.max_corners + 1)[:, None] % shapes.count
    return np.stack([x[places], y[places]]), shapes.radius if shapes.radius.any() else None


def _closed_runs(runs: Sequence[Group]) -> tuple[Array | None, Array | None]:
    """Return (corners, radii) in the form of `_closed_columns`, for the shapes of several groups, group after group."""
    most = max(run.block.shape[1] for run in runs)
    if most > MAX_CORNERS:
        return None, None
    closed = [run.block[:2].take(CLOSING[run.block.shape[1], : most + 1], axis=1) for run in runs]
    if len(runs) == 1:
        return closed[0], runs[0].r
    if all(run.r is None for run in runs):
        return np.concatenate(closed, axis=2), None
    radius = [np.zeros(len(run)) if run.r is None else run.r for run in runs]
    return np.concatenate(closed, axis=2), np.concatenate(radius)
