"""Cases about circles and about concave outlines, which need more than the edge normals.

A window is the upright box of B's moves (x0, y0, x1, y1) for which an error region is computed.
"""

from collections.abc import Sequence
from functools import partial

from ...engine.axes import HULL, Axis, edge_normals, hull_normals, needed
from ...engine.convex_parts import parts
from ...engine.geometry import Vec
from ...engine.sat import AxisTest, project
from ...engine.shapes import Circle, Polygon, Shape
from ...engine.shortcut import Shortcut
from ...engine.trace import record
from ..shape_tools import box
from .failure_case import DEPTH, FALSE_HIT, WRONG_NUMBER, FailureCase, Panels
from .move_space import ErrorRegion, RegionOrReason, Window, hits_in_window, subtract, window_ring
from .region_of_axes import TURNING
from .region_of_pushes import region_of_pieces
from .true_value import gap
from .wrong_steps import measured_test


def reversed_gap(a: Shape, b: Shape, axis: Axis) -> AxisTest:
    """Return the test of an axis with the sign of its gap reversed, like a comparison with < in place of >."""
    test = measured_test(axis, project(a, axis), project(b, axis))
    return test._replace(gap=-test.gap)


def region_everywhere(a: Shape, b: Shape, window: Window) -> RegionOrReason:
    """Return the error region of `reversed_gap` for two circles: every move but touching; or why none is shown."""
    if not (a.core_is_point and b.core_is_point):
        return TURNING
    hits = hits_in_window(a, b, window)
    return ErrorRegion(tuple(subtract(window_ring(window), hits)), hits, hits)


def gap_on_hull(a: Shape, b: Shape) -> float:
    """Return the largest gap on those hull edges that bridge a dent; if there is no such edge, the engine's gap."""
    tests = record(a, b, axes=hull_normals, every_axis=True).tests
    return max((test.gap for test in tests if test.source.kind == HULL), default=gap(a, b))


def halves(shape: Shape) -> Sequence[Shape]:
    """Return the two pieces of a convex polygon cut along a diagonal, and the convex parts of any other shape."""
    if isinstance(shape, Circle) or not shape.is_convex:
        return parts(shape)
    points, k = shape.corners, len(shape.corners) // 2
    rings = points[: k + 1], (*points[k:], points[0])
    return [Polygon(ring) for ring in rings if len(ring) > 2]


def excess_length(push: Vec, mtv: Vec) -> float:
    """Return the squared length of a push minus that of the MTV."""
    return push.x * push.x + push.y * push.y - mtv.x * mtv.x - mtv.y * mtv.y


CASES = (
    FailureCase(
        Shortcut(
            "circles-turned-round", "circles collide if the radii's sum is below the distance", needed, reversed_gap
        ),
        FALSE_HIT,
        (Circle((0, 0), 1), Circle((3, 0), 1)),
        error_region=region_everywhere,
        panels=Panels("radii"),
    ),
    FailureCase(
        Shortcut("no-nearest-vertex", "for a circle, too, the polygon's normals are enough", edge_normals),
        FALSE_HIT,
        (box(0, 0, 1, 1), Circle((1.8, 1.8), 1)),
    ),
    FailureCase(
        Shortcut("dart", "a concave shape's edge normals find every gap there is", edge_normals),
        FALSE_HIT,
        (Polygon([(-3, -3), (4, 0), (1, 1), (0, 4)]), box(2.2, 2.2, 3.2, 3.2)),
        true_value=gap_on_hull,
    ),
    FailureCase(
        Shortcut("box-in-u", "no direction shows a gap, so these two collide", hull_normals),
        FALSE_HIT,
        (Polygon([(0, 0), (6, 0), (6, 4), (5, 4), (5, 1), (1, 1), (1, 4), (0, 4)]), box(2, 2, 4, 4)),
    ),
    FailureCase(
        Shortcut("sum-of-parts", "the ways out of all the parts, added up, lead out of the whole", split=halves),
        WRONG_NUMBER,
        (box(0, 0, 4, 4), box(1.5, 1.5, 2.5, 2.5)),
        **DEPTH,
        error_region=partial(region_of_pieces, split=halves, error=excess_length),
        panels=Panels(actual="MTV"),
    ),
)
