"""The article's scenes."""

from math import cos, radians, sin

from ..engine.shapes import Circle, Polygon
from .scenefile import Scene


def box(x0: float, y0: float, x1: float, y1: float) -> Polygon:
    """An upright box from its lower left to its upper right corner."""
    return Polygon([(x0, y0), (x1, y0), (x1, y1), (x0, y1)])


def turned_box(center: tuple[float, float], width: float, height: float, degrees: float) -> Polygon:
    """A box turned counter-clockwise about its center."""
    c, s = cos(radians(degrees)), sin(radians(degrees))
    corners = ((-width / 2, -height / 2), (width / 2, -height / 2), (width / 2, height / 2), (-width / 2, height / 2))
    return Polygon([(center[0] + x * c - y * s, center[1] + x * s + y * c) for x, y in corners])


TRIANGLE_A = Polygon([(0, 1), (3, 2), (1, 5)])
TRIANGLE_B = Polygon([(5, 5), (8, 3), (4, 1)], labels=["v1", "v2", "v3"])
L_SHAPE = Polygon([(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)])

SCENES = (
    Scene("aabb", box(1, 2, 4, 4), box(6, 3, 9, 6), "world", title="Two upright boxes"),
    Scene(
        "aabb-rotated",
        turned_box((0, 0), 3, 2, -25),
        turned_box((2.8, 2.2), 3, 3, -40),
        "world",
        title="Two turned boxes that the world axes cannot tell apart",
    ),
    Scene("triangles", TRIANGLE_A, TRIANGLE_B, "edge-normals", title="The article's two triangles"),
    Scene("circles", Circle((2, 2), 2), Circle((7, 4), 1.5), title="Two circles"),
    Scene(
        "circle-polygon",
        Polygon([(0, 0), (4, 1), (1, 4)]),
        Circle((5, 4), 1.5),
        every_axis=True,
        title="A triangle and a circle",
    ),
    Scene("concave", box(2.5, 2.5, 3.5, 3.5), L_SHAPE, title="A box in the notch of an L"),
    Scene(
        "concave-outline",
        box(2.5, 2.5, 3.5, 3.5),
        L_SHAPE,
        "hull-normals",
        title="The same, as if the L were convex",
    ),
)
