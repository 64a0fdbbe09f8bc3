"""Cases in which too few axes are tested, or the wrong meaning is given to the first one that is.

A window is the upright box of B's moves (x0, y0, x1, y1) for which an error region is computed.
"""

from math import atan2, degrees, nan

from ...engine.axes import edge_normals_of_a, world
from ...engine.shapes import Polygon, Shape
from ...engine.shortcut import Shortcut
from ...engine.trace import Trace
from ..shape_tools import box, diamond
from .failure_case import FALSE_HIT, WRONG_NUMBER, FailureCase, Panels
from .move_space import RegionOrReason, Window, minkowski_difference, subtract, window_ring, wrong_number_region
from .true_value import separating_angles
from .wrong_steps import only_y


def spread_of_found_axes(trace: Trace) -> float:
    """Return 0, the angle in degrees that one separating axis spans, if the run found one; NaN if not."""
    found = [degrees(atan2(*reversed(test.axis.normal))) for test in trace.tests if test.separates][:1]
    return max(found) - min(found) if found else nan


def width_of_separating_angles(a: Shape, b: Shape) -> float:
    """Return the width in degrees of the range of separating directions; NaN if no direction separates."""
    lo, hi = separating_angles(a, b)
    return hi - lo or nan


def region_apart(a: Shape, b: Shape, window: Window) -> RegionOrReason:
    """Return the moves for which the shapes are apart, where more than one direction separates them."""
    if not (a.is_convex and b.is_convex):
        return "a shape has a dent, and no direction shows a gap inside a dent"
    return wrong_number_region(a, b, window, subtract(window_ring(window), list(minkowski_difference(a, b))))


SQUARE, BESIDE = box(0, 0, 2, 2), box(3, 0.5, 5, 2.5)

CASES = (
    FailureCase(
        Shortcut("aabb-not-upright", "nothing is rotated, so the bounding boxes decide", world),
        FALSE_HIT,
        (Polygon([(0, 0), (4, 0), (0, 4)]), box(3, 3, 4, 4)),
    ),
    FailureCase(
        Shortcut("aabb-turned", "the bounding boxes of turned shapes meet, so the shapes do", world),
        FALSE_HIT,
        (diamond(0, 0, 1), diamond(1.5, 1.5, 1)),
    ),
    FailureCase(
        Shortcut("one-overlap", "the ranges overlap on one axis, so the shapes collide", only_y),
        FALSE_HIT,
        (SQUARE, BESIDE),
    ),
    FailureCase(
        Shortcut("line-for-axis", "the line between them runs along y, so y is the axis", only_y),
        FALSE_HIT,
        (SQUARE, BESIDE),
        panels=Panels(claimed="line as axis"),
    ),
    FailureCase(
        Shortcut("only-one-axis", "of all directions exactly one separates them"),
        WRONG_NUMBER,
        (SQUARE, BESIDE),
        quantity="degrees that separate:",
        claimed_value=spread_of_found_axes,
        true_value=width_of_separating_angles,
        error_region=region_apart,
        panels=Panels(actual="separating directions"),
    ),
    FailureCase(
        Shortcut("one-shapes-normals", "the normals of one shape are enough", edge_normals_of_a),
        FALSE_HIT,
        (SQUARE, diamond(3, 3.2, 1.6)),
    ),
)
