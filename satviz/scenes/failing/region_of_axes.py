"""The error region of a verdict, worked out from the axes of the shortcut's run.

B moved by d meets A exactly where d lies in A - B, and leaves no gap on an axis n where d . n lies between
two ends.  So the true hits and the claimed hits are polygons in the plane of moves; the error region is what one
has and the other has not.  (A circle's round rim is a polygon of many corners.)
"""

from collections.abc import Sequence
from itertools import pairwise
from math import inf

from ...engine.axes import EDGE, GIVEN, HULL, SLIP, WORLD, Axis
from ...engine.geometry import Interval, Vec
from ...engine.sat import project
from ...engine.shapes import Shape
from ...engine.shortcut import Shortcut
from ..shape_tools import translated
from .move_space import (
    TOLERANCE,
    ConvexRing,
    ErrorRegion,
    RegionOrReason,
    Window,
    clip_to_half_plane,
    hits_in_window,
    subtract,
    window_ring,
)

ROUNDING = "only rounding makes it wrong, at single places that no area can show"
TURNING = "its axes turn as B moves, so the region where it is wrong has no straight edges"
OWN_PUSH = "it pushes B by a rule of its own, for which satviz knows no formula"
FIXED_AXES = EDGE, GIVEN, HULL, SLIP, WORLD  # kinds of axes that stay where they are while B moves


def region_of_verdict(
    a: Shape, b: Shape, shortcut: Shortcut, window: Window, *, start: ConvexRing | None = None
) -> RegionOrReason:
    """Return the moves for which a shortcut's verdict is wrong, or the reason why no area shows them.

    `start`: the moves that the shortcut takes for hits before it tests any axis; None for all in the window.
    """
    if shortcut.split or shortcut.push:
        return OWN_PUSH
    claimed: tuple[ConvexRing, ...] = (window_ring(window) if start is None else start,)
    for axis in shortcut.choose(a, b).axes:
        if not any(axis.normal):
            continue  # an axis (0, 0) never shows a gap
        if axis.source.kind not in FIXED_AXES:
            return TURNING
        claimed = _without_gap(claimed, axis.direction, _moves_without_gap(a, b, shortcut, axis))
    hits = hits_in_window(a, b, window)
    false = tuple(piece for ring in claimed for piece in subtract(ring, hits))
    missed = tuple(piece for i, hit in enumerate(hits) for piece in subtract(hit, (*claimed, *hits[:i])))
    return ErrorRegion(false, missed, tuple(filter(None, hits)), shortcut.touching_separates)


def _without_gap(rings: Sequence[ConvexRing], u: Vec, ranges: Sequence[Interval]) -> tuple[ConvexRing, ...]:
    """Return the parts of the rings where d . u, a move's component along u, lies in one of the ranges."""
    cut = (
        clip_to_half_plane(clip_to_half_plane(ring, u, hi), Vec(-u.x, -u.y), -lo) for ring in rings for lo, hi in ranges
    )
    return tuple(filter(None, cut))


def _moves_without_gap(a: Shape, b: Shape, shortcut: Shortcut, axis: Axis) -> list[Interval]:
    """Return the ranges of B's moves along the axis for which the shortcut finds no gap on it.

    A range can only end where a landing of A meets one of B, with its own sign or the opposite one.  Between two
    neighbouring ends, and beyond the outermost ones, one measurement decides.
    """
    u = axis.direction
    on_a, on_b = (project(shape, axis).landings for shape in (a, b))
    every = sorted({s * t - r for t in on_a for r in on_b for s in (1, -1)})
    ends = every[:1]
    for end in every:
        if end - ends[-1] > TOLERANCE * (every[-1] - every[0]):
            ends.append(end)
    found: list[Interval] = []
    far = every[-1] - every[0] or 1.0
    for lo, hi in pairwise([-inf, *ends, inf]):
        t = hi - far if lo == -inf else lo + far if hi == inf else (lo + hi) / 2
        (test,) = shortcut.tests(a, translated(b, Vec(u.x * t, u.y * t)), [axis])
        if shortcut.separates(test):
            continue
        if found and found[-1].hi == lo:
            found[-1] = Interval(found[-1].lo, hi)
        else:
            found.append(Interval(lo, hi))
    return found
