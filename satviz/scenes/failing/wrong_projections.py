"""Cases in which the projection is wrong: its sign, its unit, or its rounding.

A function of (a, b, axis) measures an axis as a shortcut does.  A landing is a point's coordinate on the axis.
"""

from fractions import Fraction
from functools import partial
from math import floor, nan

from ...engine.axes import EDGE, Axis, Source, edge_normals, needed, world
from ...engine.geometry import Interval, Vec
from ...engine.sat import AxisTest, Projection, axis_tests, project
from ...engine.shapes import Polygon, Shape
from ...engine.shortcut import Shortcut
from ...engine.trace import Trace
from ..shape_tools import box, decimal_vertices
from .failure_case import DEPTH, FALSE_HIT, MISSED_HIT, WRONG_NUMBER, FailureCase, Panels
from .region_of_axes import ROUNDING
from .region_of_pushes import overlaps_in_raw_units, region_of_depth
from .wrong_steps import measured_test, raw_normals, unit_normals


def mixed_signs(a: Shape, b: Shape, axis: Axis) -> AxisTest:
    """Return the test of an axis with A projected on the normal and B on the opposite of the normal."""
    p, q = project(a, axis), project(b, axis)
    return measured_test(axis, p, q._replace(landings=tuple(-t + 0.0 for t in q.landings)))


def a_before_b(a: Shape, b: Shape, axis: Axis) -> AxisTest:
    """Return the test of an axis that finds a gap only where A's range ends before B's begins."""
    p, q = project(a, axis), project(b, axis)
    return AxisTest(axis, p, q, q.interval.lo - p.interval.hi)


def without_signs(a: Shape, b: Shape, axis: Axis) -> AxisTest:
    """Return the test of an axis that uses the absolute value of every landing."""
    p, q = (side._replace(landings=tuple(map(abs, side.landings))) for side in (project(a, axis), project(b, axis)))
    return measured_test(axis, p, q)


def largest_from_zero(a: Shape, b: Shape, axis: Axis) -> AxisTest:
    """Return the test of an axis that searches each largest landing from 0, so no range ends below 0."""
    origin = Vec(0.0, 0.0)
    p, q = (
        Projection((*side.points, origin), (*side.landings, 0.0)) if side.interval.hi < 0 else side
        for side in (project(a, axis), project(b, axis))
    )
    return measured_test(axis, p, q)


def as_written(a: Shape, b: Shape, axis: Axis) -> AxisTest:
    """Return the test of an axis for the vertices as the decimals that people write: 0.1 + 0.2 is exactly 0.3."""
    p, q = project(a, axis), project(b, axis)
    if a.core_is_point or b.core_is_point:
        return measured_test(axis, p, q)
    (x, y), length = map(Fraction, axis.normal), axis.length
    dots = [[u * x + v * y for u, v in decimal_vertices(shape)] for shape in (a, b)]
    gap = max(min(dots[0]) - max(dots[1]), min(dots[1]) - max(dots[0]))
    p, q = (Projection(s.vertices, tuple(float(t) / length for t in d)) for s, d in zip((a, b), dots, strict=True))
    return AxisTest(axis, p, q, float(gap) / length)


def whole_halves(ends: Interval, whole_middle: bool = True) -> Interval:
    """Return the range that is left when its middle and half of its length are rounded down to whole numbers.

    Without `whole_middle` only half of the length is rounded.
    """
    middle, half = (ends.lo + ends.hi) / 2, (ends.hi - ends.lo) // 2
    middle = floor(middle) if whole_middle else middle
    return Interval(middle - half, middle + half)


def by_whole_halves(a: Shape, b: Shape, axis: Axis) -> AxisTest:
    """Return the test of an axis for ranges that are kept as their middle and half of their length, in integers."""

    def halved(side: Projection) -> Projection:
        """Return the projection whose outermost points land at the ends of the new range, and no other outside it."""
        low, high = map(float, whole_halves(side.interval))
        ends = {side.interval.lo: low, side.interval.hi: high}
        return Projection(side.points, tuple(ends.get(at, min(max(at, low), high)) for at in side.landings))

    return measured_test(axis, halved(project(a, axis)), halved(project(b, axis)))


FIRST_EDGE_OF_B = Source(EDGE, "B", (0, 1))


def claimed_furthest_vertices(trace: Trace) -> float:
    """Return how many vertices of B land furthest on its first edge's normal in this run; NaN without that test."""
    found = [test.b.landings for test in trace.tests if test.source == FIRST_EDGE_OF_B]
    return found[0].count(max(found[0])) if found else nan


def true_furthest_vertices(a: Shape, b: Shape) -> float:
    """Return how many vertices of B land furthest on its first edge's normal; NaN for a circle."""
    first = (axis for axis in edge_normals(a, b).axes if axis.source == FIRST_EDGE_OF_B)
    found = [test.b for test in axis_tests(a, b, first)]
    return found[0].landings.count(found[0].interval.hi) if found else nan


CASES = (
    FailureCase(
        Shortcut("mixed-signs", "a normal or its opposite, for each shape as it comes", edge_normals, mixed_signs),
        MISSED_HIT,
        (Polygon([(0, 0), (4, 0), (1, 3)]), box(1, 1, 2, 2)),
    ),
    FailureCase(
        Shortcut("one-sided-gap", "they overlap on an axis unless A ends before B begins", needed, a_before_b),
        FALSE_HIT,
        (box(3, 0, 5, 2), box(0, 0.5, 2, 2.5)),
        panels=Panels("one side"),
    ),
    FailureCase(
        Shortcut("unit-normals", "a normal must first be brought to length 1", edge_normals, unit_normals),
        MISSED_HIT,
        (Polygon([(-7, 5), (2, -2), (-1, 4)]), Polygon([(1, -3), (-9, 7), (-2, -1)])),
        error_region=lambda a, b, window: ROUNDING,
        panels=Panels("unit normal"),
    ),
    FailureCase(
        Shortcut("raw-depth", "the depth can be read off with normals of any length", edge_normals, raw_normals),
        WRONG_NUMBER,
        (box(0, 0, 2, 1), box(1, 0.25, 3, 2.25)),
        **DEPTH,
        error_region=partial(region_of_depth, choose=edge_normals, measure=overlaps_in_raw_units),
        panels=Panels("raw pushes", "true pushes"),
    ),
    FailureCase(
        Shortcut("lengths", "a landing place is a length, so it has no sign", needed, without_signs),
        FALSE_HIT,
        (box(-3, 0, -2, 1), box(2, 0, 3, 1)),
        panels=Panels(claimed="fold"),
    ),
    FailureCase(
        Shortcut("start-at-zero", "the search for the largest may start at 0", needed, largest_from_zero),
        FALSE_HIT,
        (box(-5, 0, -4, 1), box(-2, 0, -1, 1)),
    ),
    FailureCase(
        Shortcut("one-maximum", "on any axis one vertex is the furthest", edge_normals, unit_normals),
        WRONG_NUMBER,
        (Polygon([(0, 1), (3, 2), (1, 5)]), Polygon([(5, 5), (8, 3), (4, 1)], labels=["v1", "v2", "v3"])),
        quantity="furthest vertices:",
        claimed_value=claimed_furthest_vertices,
        true_value=true_furthest_vertices,
        error_region=lambda a, b, window: ROUNDING,
        panels=Panels("rounded digits", "exact digits"),
    ),
    FailureCase(
        Shortcut("touch-on-paper", "what touches on paper touches in the computer", needed, as_written),
        WRONG_NUMBER,
        (box(0, 0, 0.1 + 0.2, 0.3), box(0.3, 0, 0.6, 0.3)),
        error_region=lambda a, b, window: ROUNDING,
        panels=Panels("as written", "as stored"),
    ),
    FailureCase(
        Shortcut("integer-halves", "half of a whole number is a whole number", world, by_whole_halves),
        MISSED_HIT,
        (box(0, 0, 3, 2), box(3, 0, 5, 2)),
        error_region=lambda a, b, window: "halves are rounded to whole numbers, so the ranges jump as B moves",
        panels=Panels("halves"),
    ),
)
