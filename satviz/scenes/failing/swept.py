"""SAT for a shape on its way: on each axis the stretch of time in which the ranges overlap.

All numbers may be Fractions, and then all times are exact.  The shapes meet while
the ranges overlap on every axis: from the last entry to the first exit.
"""

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

Number = Fraction | float
Point = tuple[Number, Number]
FLIGHT = Fraction(4), Fraction(0)  # how far the bullet of the scene flies in one frame


class Window(NamedTuple):
    """One axis: when the ranges begin to overlap and when they end, in parts of the way; `never` if they do not."""

    axis: Point
    enter: Number
    leave: Number
    never: bool = False


def windows(a: Sequence[Point], b: Sequence[Point], move: Point) -> list[Window]:
    """The windows of convex a, moving by `move` in time 0 to 1, and of resting b, on the edge normals of both."""
    axes: list[Point] = []
    for ring in (a, b):
        for (px, py), (qx, qy) in zip(ring, (*ring[1:], ring[0])):
            n = qy - py, px - qx
            if not any(n[0] * m[1] == n[1] * m[0] for m in axes):
                axes.append(n)
    return [window(a, b, move, n) for n in axes]


def window(a: Sequence[Point], b: Sequence[Point], move: Point, n: Point) -> Window:
    """The stretch of time on one axis, within the way from 0 to 1."""
    (a0, a1), (b0, b1) = span(a, n), span(b, n)
    speed = move[0] * n[0] + move[1] * n[1]
    if not speed:
        return Window(n, Fraction(0), Fraction(1), a1 < b0 or b1 < a0)
    enter, leave = sorted(((b0 - a1) / speed, (b1 - a0) / speed))
    return Window(n, max(enter, Fraction(0)), min(leave, Fraction(1)), leave < 0 or enter > 1)


def contact(found: Sequence[Window]) -> tuple[Number, Number] | None:
    """When the shapes meet, both ends included; None if they never do."""
    enter, leave = max(w.enter for w in found), min(w.leave for w in found)
    return None if any(w.never for w in found) or enter > leave else (enter, leave)


def span(ring: Sequence[Point], n: Point) -> tuple[Number, Number]:
    """The range of an outline on an axis."""
    landings = [x * n[0] + y * n[1] for x, y in ring]
    return min(landings), max(landings)
