"""Shapes that scenes are made of: boxes, diamonds, and shapes moved to another place."""

from fractions import Fraction
from math import cos, radians, sin

from ..engine.geometry import Vec
from ..engine.shapes import Circle, Polygon, Shape


def box(x0: float, y0: float, x1: float, y1: float) -> Polygon:
    """Return an upright box from its lower left corner (x0, y0) to its upper right corner (x1, y1)."""
    return Polygon([(x0, y0), (x1, y0), (x1, y1), (x0, y1)])


def turned_box(center: tuple[float, float], width: float, height: float, degrees: float) -> Polygon:
    """Return a box of this width and height, turned counter-clockwise by `degrees` about its center."""
    c, s = cos(radians(degrees)), sin(radians(degrees))
    corners = ((-width / 2, -height / 2), (width / 2, -height / 2), (width / 2, height / 2), (-width / 2, height / 2))
    return Polygon([(center[0] + x * c - y * s, center[1] + x * s + y * c) for x, y in corners])


def diamond(x: float, y: float, half_diagonal: float) -> Polygon:
    """Return a square that stands on a corner; (x, y): its center; half_diagonal: from there to a corner."""
    r = half_diagonal
    return Polygon([(x + r, y), (x, y + r), (x - r, y), (x, y - r)])


def translated(shape: Shape, move: Vec) -> Shape:
    """Return the shape moved; its coordinates are rounded to float64."""
    if isinstance(shape, Circle):
        return Circle((shape.center.x + move.x, shape.center.y + move.y), shape.radius)
    return Polygon([(x + move.x, y + move.y) for x, y in shape.vertices], shape.labels)


def vertex_mean(shape: Shape) -> Vec:
    """Return the mean of the vertices, or a circle's center: what pages call the middle of a shape."""
    points = shape.vertices or shape.core
    return Vec(sum(x / len(points) for x, _ in points), sum(y / len(points) for _, y in points))


def decimal_vertices(shape: Shape) -> list[tuple[Fraction, Fraction]]:
    """Return the vertices rounded to 12 digits as exact decimals: 0.1 + 0.2 is 3/10; none for a circle."""
    return [(Fraction(f"{x:.12g}"), Fraction(f"{y:.12g}")) for x, y in shape.vertices]
