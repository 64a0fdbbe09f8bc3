"""The article's scenes: those of the illustrated article on SAT whose figures satviz makes (`satviz figures`)."""

from ..engine.shapes import Circle, Polygon
from .scenefile import Scene
from .shape_tools import box, turned_box

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
