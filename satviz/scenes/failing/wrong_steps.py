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
    """Return a Choice of the x axis alone."""
    return Choice((X,))


def only_y(a: Shape, b: Shape) -> Choice:
    """Return a Choice of the y axis alone."""
    return Choice((Y,))


def unit_normals(a: Shape, b: Shape, axis: Axis) -> AxisTest:
    """Return the test of an axis in plain floats, with the normal first scaled to length 1 and so rounded."""
    return measured_test(axis, *(_project_in_floats(shape, axis.direction) for shape in (a, b)))


def raw_normals(a: Shape, b: Shape, axis: Axis) -> AxisTest:
    """Return the test of an axis in plain floats, with the normal not scaled to length 1."""
    return measured_test(axis, *(_project_in_floats(shape, axis.normal) for shape in (a, b)))


def measured_test(axis: Axis, a: Projection, b: Projection) -> AxisTest:
    """Return the AxisTest for two projections on an axis; its gap is that of the rounded ranges."""
    return AxisTest(axis, a, b, a.interval.gap(b.interval))


def is_closing_edge(axis: Axis, a: Shape, b: Shape) -> bool:
    """Return whether the axis is the normal of the edge from a shape's last vertex to its first."""
    return axis.source.ids == (0, vertex_count(axis, a, b) - 1)


def vertex_count(axis: Axis, a: Shape, b: Shape) -> int:
    """Return the number of vertices of the shape that an axis comes from."""
    return len((a if axis.source.shape == "A" else b).vertices)


def _project_in_floats(shape: Shape, n: Vec) -> Projection:
    """Return the projection of a shape on n in plain floats, as dot products with n of any length."""
    if shape.core_is_point:
        ((x, y),), length = shape.core, hypot(*n)
        ends = project(shape, Axis(n, length or 1.0, Source(""))).points  # on (0, 0) both are the center
        at, r = x * n.x + y * n.y, shape.radius * length
        return Projection(ends, (at - r, at + r))
    return Projection(shape.core, tuple(x * n.x + y * n.y for x, y in shape.core))
