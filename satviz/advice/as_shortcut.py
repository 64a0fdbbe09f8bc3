"""The smaller models as shortcuts of the one loop, so that a pair on which one fails can be recorded and drawn."""

from ..engine.axes import Axis, Choice, directions, needed, world
from ..engine.sat import AxisTest, axis_tests
from ..engine.shapes import Circle, Shape
from ..engine.shortcut import Shortcut
from .candidates import AABB, K_DOP, Model
from .certified_bounds import bounding_circle, certify


def shortcut(model: Model, a: Shape, b: Shape) -> Shortcut:
    """What believers in the model do with this pair; where only rounding fails, the loop itself."""
    if certify(model, a, b) is None:
        return Shortcut("plain floats", "plain floats are exact enough", needed)
    if model.kind == AABB:
        return Shortcut("bounding boxes", "the bounding boxes lie as the shapes do", world)
    if model.kind == K_DOP:
        return Shortcut(
            "shared directions", "the directions that most edges share are enough", directions(*model.directions)
        )
    return Shortcut("bounding circles", "the circles around the shapes lie as the shapes do", _between, _by_circles)


def _between(a: Shape, b: Shape) -> Choice:
    (ax, ay, _), (bx, by, _) = bounding_circle(a), bounding_circle(b)
    return directions((bx - ax, by - ay) if (ax, ay) != (bx, by) else (1, 0))(a, b)


def _by_circles(a: Shape, b: Shape, axis: Axis) -> AxisTest:
    (ax, ay, ar), (bx, by, br) = bounding_circle(a), bounding_circle(b)
    return next(axis_tests(Circle((ax, ay), ar), Circle((bx, by), br), [axis]))
