"""Where a shortcut lies as B moves: the moves of B for which its answer is wrong, with exact boundaries.

B moved by d meets A exactly where d lies in A - B, and leaves no gap on an axis n where d . n lies between
two ends.  So both the truth and a shortcut are polygons in the plane of moves, and a lie is what one has and
the other has not.  (A circle's round rim is a polygon of many corners.)
"""

from itertools import pairwise
from typing import NamedTuple

from ...engine.axes import EDGE, GIVEN, HULL, SLIP, WORLD, Axis
from ...engine.geometry import Interval, InvalidShape, Vec
from ...engine.sat import project
from ...engine.shapes import Circle, Shape, centroid
from ...engine.shortcut import Shortcut
from ..shortcuts import FAR, NAMED, middle, turned_round, unit_normals, within_reach
from .claimed_value import moved
from .plane import SAME, Ring, Window, clipped, corners, difference, within, without
from .where_numbers import MAPS, ROUNDING

TURNING = "its axes turn as B moves, so where it is wrong has no straight edges"
SPECK = "the shapes are so small beside their moves that float64 cannot tell their corners apart"
CROWDED = "the parts of these shapes have too many corners to work it out while you drag"
MOST_OF_PARTS = 300  # of the corners of all pairs of parts: what is left of one without the others is cut up by each
FIXED = EDGE, GIVEN, HULL, SLIP, WORLD  # axes that stay where they are while B moves


class ErrorRegion(NamedTuple):
    """Moves of B, as convex polygons: where a hit is claimed that is none, where one is missed, and all true hits.

    `touching`: are those moves missed, too, at which the shapes only touch, the rims of `hits`?
    `numbers`: where the number is wrong that the shortcut is about, if it is about one.
    """

    false_hits: tuple[Ring, ...]
    missed_hits: tuple[Ring, ...]
    hits: tuple[Ring, ...]
    touching: bool = False
    numbers: tuple[Ring, ...] = ()


def error_region(a: Shape, b: Shape, shortcut: Shortcut, window: Window) -> ErrorRegion | str:
    """Where the shortcut's answer is wrong, of the moves within the window (x0, y0, x1, y1); or why that is no area."""
    try:
        return _lies(a, b, shortcut, window)
    except InvalidShape:
        return SPECK


def _lies(a: Shape, b: Shape, shortcut: Shortcut, window: Window) -> ErrorRegion | str:
    hits = tuple(within(hit, window) for hit in difference(a, b))
    if len(hits) > 1 and sum(map(len, hits)) > MOST_OF_PARTS:
        return CROWDED
    if NAMED.get(shortcut.name) == shortcut and shortcut.name in MAPS:
        wrong = MAPS[shortcut.name](a, b, window)
        return wrong if isinstance(wrong, str) else ErrorRegion((), (), tuple(filter(None, hits)), numbers=tuple(wrong))
    if shortcut.measure is turned_round and a.core_is_point and b.core_is_point:
        return ErrorRegion(tuple(without(corners(window), hits)), hits, hits)
    claimed = _claimed(a, b, shortcut, window)
    if isinstance(claimed, str):
        return claimed
    false = tuple(piece for ring in claimed for piece in without(ring, hits))
    missed = tuple(piece for i, hit in enumerate(hits) for piece in without(hit, (*claimed, *hits[:i])))
    return ErrorRegion(false, missed, tuple(filter(None, hits)), shortcut.touching_separates)


def error_region_in_view(a: Shape, b: Shape, shortcut: Shortcut, view: Window) -> ErrorRegion | str:
    """The same of the moves that bring B's middle into view."""
    at, (x0, y0, x1, y1) = middle(b), view
    return error_region(a, b, shortcut, (x0 - at.x, y0 - at.y, x1 - at.x, y1 - at.y))


def _claimed(a: Shape, b: Shape, shortcut: Shortcut, window: Window) -> tuple[Ring, ...] | str:
    """The moves that the shortcut takes for hits."""
    whole: tuple[Ring, ...] = (corners(window),)
    if shortcut.split or shortcut.push:
        return "it is about a push of its own, which may be anything"
    if shortcut.measure is unit_normals:
        return ROUNDING
    if shortcut.measure is turned_round:
        return TURNING
    axes = shortcut.choose(a, b).axes
    found = whole
    if shortcut.measure is within_reach:
        (px, py), (qx, qy) = centroid(a), centroid(b)
        near = next(difference(Circle((px, py), FAR / 2), Circle((qx, qy), FAR / 2)))
        found, axes = (within(near, window),), axes[1:]
    for axis in axes:
        if not any(axis.normal):
            continue  # on a zero axis there never is a gap
        if axis.source.kind not in FIXED:
            return TURNING
        ends = _no_gap(a, b, shortcut, axis)
        u = axis.direction
        cut = (clipped(clipped(ring, u, hi), Vec(-u.x, -u.y), -lo) for ring in found for lo, hi in ends)
        found = tuple(ring for ring in cut if ring)
    return found


def _no_gap(a: Shape, b: Shape, shortcut: Shortcut, axis: Axis) -> list[Interval]:
    """How far B may move along an axis without a gap, as the shortcut measures it between all ends there can be.

    An end is where a landing of A meets one of B, with its own sign or the other.
    """
    u = axis.direction
    on_a, on_b = (project(shape, axis).landings for shape in (a, b))
    every = sorted({s * t - r for t in on_a for r in on_b for s in (1, -1)})
    ends = every[:1]
    for end in every:
        if end - ends[-1] > SAME * (every[-1] - every[0]):
            ends.append(end)
    found: list[Interval] = []
    for lo, hi in pairwise(ends):
        t = (lo + hi) / 2
        (there,) = shortcut.tests(a, moved(b, Vec(u.x * t, u.y * t)), [axis])
        if shortcut.separates(there):
            continue
        if found and found[-1].hi == lo:
            found[-1] = Interval(found[-1].lo, hi)
        else:
            found.append(Interval(lo, hi))
    return found
