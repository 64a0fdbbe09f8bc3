"""Wrong steps of the loop that more than one case takes.

A wrong measurement uses plain floats, as the people who make the mistake would write it: positive apart, negative by
the depth.
"""

from math import hypot

from ...engine.axes import WORLD_AXES, Axis, Choice, Source
from ...engine.geometry import Vec
from ...engine.sat import AxisTest, Projection, project
from ...engine.shapes import Shape

Y, X = WORLD_AXES


def only_x(a: Shape, b: Shape) -> Choice:
    """Choose x alone."""
    return Choice((X,))


def only_y(a: Shape, b: Shape) -> Choice:
    """Choose y alone."""
    return Choice((Y,))


def unit_normals(a: Shape, b: Shape, axis: Axis) -> AxisTest:
    """Measure with the normal brought to length 1 first, which rounds it."""
    return measured_test(axis, *(_project_in_floats(shape, axis.direction) for shape in (a, b)))


def raw_normals(a: Shape, b: Shape, axis: Axis) -> AxisTest:
    """Measure with the normal as it comes, so that landings are in units of its length."""
    return measured_test(axis, *(_project_in_floats(shape, axis.normal) for shape in (a, b)))


def measured_test(axis: Axis, a: Projection, b: Projection) -> AxisTest:
    """Return the test of an axis with the gap that follows from two projections."""
    return AxisTest(axis, a, b, a.interval.gap(b.interval))


def is_closing_edge(axis: Axis, a: Shape, b: Shape) -> bool:
    """Is the axis the normal of the edge from an outline's last vertex back to its first?"""
    return axis.source.ids == (0, vertex_count(axis, a, b) - 1)


def vertex_count(axis: Axis, a: Shape, b: Shape) -> int:
    """Return the number of vertices of the shape that an axis comes from."""
    return len((a if axis.source.shape == "A" else b).vertices)


def _project_in_floats(shape: Shape, n: Vec) -> Projection:
    """Return where the points land, in units of n's length, by plain float products."""
    if shape.core_is_point:
        ((x, y),), length = shape.core, hypot(*n)
        ends = project(shape, Axis(n, length or 1.0, Source(""))).points  # on (0, 0) both are the center
        at, r = x * n.x + y * n.y, shape.radius * length
        return Projection(ends, (at - r, at + r))
    return Projection(shape.core, tuple(x * n.x + y * n.y for x, y in shape.core))
