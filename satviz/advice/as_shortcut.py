"""The smaller models as shortcuts of SAT, so that a pair on which a model fails can be recorded and drawn."""

from ..engine.axes import Axis, Choice, directions, needed, world
from ..engine.sat import AxisTest, axis_tests
from ..engine.shapes import Circle, Shape
from ..engine.shortcut import Shortcut
from .candidates import AABB, K_DOP, Model
from .certified_bounds import bounding_circle, certify


def shortcut(model: Model, a: Shape, b: Shape) -> Shortcut:
    """Return the SAT shortcut that tests the pair as the model does; SAT itself where only rounding can fail."""
    if certify(model, a, b) is None:
        return Shortcut("plain floats", "plain floats are exact enough", needed)
    if model.kind == AABB:
        return Shortcut("bounding boxes", "the bounding boxes give the same answer as the shapes", world)
    if model.kind == K_DOP:
        return Shortcut(
            "shared directions", "the directions that most edges share are enough", directions(*model.directions)
        )
    return Shortcut(
        "bounding circles", "the circles around the shapes give the same answer as the shapes", _between, _by_circles
    )


def _between(a: Shape, b: Shape) -> Choice:
    """Return the choice of one axis, through the centers of the bounding circles (x if these coincide)."""
    (ax, ay, _), (bx, by, _) = bounding_circle(a), bounding_circle(b)
    return directions((bx - ax, by - ay) if (ax, ay) != (bx, by) else (1, 0))(a, b)


def _by_circles(a: Shape, b: Shape, axis: Axis) -> AxisTest:
    """Return the result of testing the bounding circles, in place of the shapes, on an axis."""
    (ax, ay, ar), (bx, by, br) = bounding_circle(a), bounding_circle(b)
    return next(axis_tests(Circle((ax, ay), ar), Circle((bx, by), br), [axis]))
