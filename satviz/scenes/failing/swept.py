"""SAT for a moving shape: on each axis the interval of time in which the ranges overlap.

All numbers may be Fractions, and then all times are exact.  The shapes meet while the ranges overlap on every axis:
from the last time at which they enter to the first at which they leave (swept SAT, as in Ericson).
"""

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

ExactNumber = Fraction | float
ExactPoint = tuple[ExactNumber, ExactNumber]


class OverlapTime(NamedTuple):
    """The times, from 0 to 1, at which the ranges on one axis begin and end to overlap; `never` if they do not."""

    enter: ExactNumber
    leave: ExactNumber
    never: bool = False


def overlap_times(a: Sequence[ExactPoint], b: Sequence[ExactPoint], move: ExactPoint) -> list[OverlapTime]:
    """Return an OverlapTime for each axis, while convex a moves by `move` in time 0 to 1 and b rests.

    The axes are the edge normals of both, each direction once.
    """
    axes: list[ExactPoint] = []
    for ring in (a, b):
        for (px, py), (qx, qy) in zip(ring, (*ring[1:], ring[0])):
            n = qy - py, px - qx
            if not any(n[0] * m[1] == n[1] * m[0] for m in axes):
                axes.append(n)
    return [_overlap_time(a, b, move, n) for n in axes]


def _overlap_time(a: Sequence[ExactPoint], b: Sequence[ExactPoint], move: ExactPoint, n: ExactPoint) -> OverlapTime:
    """Return the OverlapTime on the axis n, with both times clipped to 0 and 1."""
    (a0, a1), (b0, b1) = _range_on(a, n), _range_on(b, n)
    speed = move[0] * n[0] + move[1] * n[1]
    if not speed:
        return OverlapTime(Fraction(0), Fraction(1), a1 < b0 or b1 < a0)
    enter, leave = sorted(((b0 - a1) / speed, (b1 - a0) / speed))
    return OverlapTime(max(enter, Fraction(0)), min(leave, Fraction(1)), leave < 0 or enter > 1)


def contact(found: Sequence[OverlapTime]) -> tuple[ExactNumber, ExactNumber] | None:
    """Return (first, last) time at which the shapes meet; None if never; `found`: the OverlapTime of each axis."""
    enter, leave = max(w.enter for w in found), min(w.leave for w in found)
    return None if any(w.never for w in found) or enter > leave else (enter, leave)


def _range_on(ring: Sequence[ExactPoint], n: ExactPoint) -> tuple[ExactNumber, ExactNumber]:
    """Return (lowest, highest) dot product of an outline's vertices with n."""
    landings = [x * n[0] + y * n[1] for x, y in ring]
    return min(landings), max(landings)
