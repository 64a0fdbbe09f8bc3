"""The right answers that several cases or pictures use, by the engine."""

from collections.abc import Sequence
from fractions import Fraction
from math import cos, hypot, nan, radians, sin

from ...engine.axes import directions, needed
from ...engine.convex_parts import parts
from ...engine.geometry import Vec
from ...engine.sat import axis_tests
from ...engine.shapes import Shape
from ...engine.trace import record
from ..shape_tools import decimal_vertices
from . import swept

Answer = float | tuple[swept.ExactNumber, swept.ExactNumber] | str
FLIGHT = Fraction(4), Fraction(0)  # how far A flies in one frame, in the cases about motion


def gap(a: Shape, b: Shape) -> float:
    """Return the largest gap on all needed axes; for concave outlines, the smallest such gap of all pairs of parts."""
    trace = record(a, b, every_axis=True)
    return min(max(test.gap for test in run.tests) for run in trace.pairs or (trace,))


def mtv(a: Shape, b: Shape) -> Vec:
    """Return the minimum translation vector of B; (0, 0) if the shapes do not overlap."""
    return record(a, b).mtv or Vec(0.0, 0.0)


def depth(a: Shape, b: Shape) -> float:
    """Return the penetration depth, which is the length of the MTV."""
    return hypot(*mtv(a, b))


def distance(a: Shape, b: Shape) -> float:
    """Return the distance of two shapes between their nearest points; 0 where they meet.

    For convex shapes this is the largest gap, once the direction between the nearest vertices is tested too.
    """
    return max(0.0, min(_convex_distance(p, q) for p in parts(a) for q in parts(b)))


def _convex_distance(a: Shape, b: Shape) -> float:
    """Return the largest gap of two convex shapes over all directions; negative where they overlap."""
    between = [Vec(q.x - p.x, q.y - p.y) for p in a.vertices for q in b.vertices]
    nearest = min(between, key=lambda way: hypot(*way), default=Vec(0.0, 0.0))
    axes = (*needed(a, b).axes, *(directions(nearest)(a, b).axes if any(nearest) else ()))
    return max(test.gap for test in axis_tests(a, b, axes))


def separating_angles(a: Shape, b: Shape) -> tuple[float, float]:
    """Return the range (lo, hi) of directions that separate two shapes, in degrees from the axis of the largest gap.

    The angles count counter-clockwise, so lo is not above 0.  Each end is found by bisection, to a rounding; both are
    0 where that axis does not separate.
    """
    best = max(axis_tests(a, b), key=lambda test: test.gap).axis.direction

    def separates(degrees: float) -> bool:
        """Return whether the best axis, turned counter-clockwise by these degrees, separates the shapes."""
        c, s = cos(radians(degrees)), sin(radians(degrees))
        (test,) = axis_tests(a, b, directions((best.x * c - best.y * s, best.x * s + best.y * c))(a, b).axes)
        return test.separates

    ends = []
    for inside, outside in (0.0, -90.0), (0.0, 90.0):
        for _ in range(50):
            middle = (inside + outside) / 2
            inside, outside = (middle, outside) if separates(middle) else (inside, middle)
        ends.append(inside)
    return ends[0], ends[1]


def contact_times(a: Shape, b: Shape) -> tuple[swept.ExactNumber, swept.ExactNumber]:
    """Return the (first, last) time at which A, moving by FLIGHT = (4, 0) in time 0 to 1, meets B.

    The times are exact for the decimals in which the scene is written.  Both are NaN if the shapes never meet, or if
    one is a circle.
    """
    if a.core_is_point or b.core_is_point:
        return nan, nan
    outlines: Sequence[tuple[Shape, Shape]] = [(p, q) for p in parts(a) for q in parts(b)]
    runs = (swept.overlap_times(decimal_vertices(p), decimal_vertices(q), FLIGHT) for p, q in outlines)
    times = [time for run in runs if (time := swept.contact(run))]
    return (min(first for first, _ in times), max(last for _, last in times)) if times else (nan, nan)
