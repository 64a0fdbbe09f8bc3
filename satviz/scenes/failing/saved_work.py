"""Cases in which work is saved in the wrong place: fewer axes, a check in advance, fewer pairs, fewer vertices."""

from math import comb, sqrt

from ...engine.axes import (
    CENTERS,
    CENTROIDS,
    Axis,
    Choice,
    centers,
    edge_normals,
    edge_normals_of_a,
    needed,
)
from ...engine.geometry import Vec
from ...engine.sat import AxisTest, project
from ...engine.shapes import Circle, Polygon, Shape, centroid
from ...engine.shortcut import Shortcut
from ...engine.trace import Trace, record
from ..shape_tools import box, diamond
from . import threed
from .failure_case import FALSE_HIT, MISSED_HIT, WRONG_NUMBER, FailureCase, Panels
from .move_space import (
    RegionOrReason,
    Window,
    clip_to_half_plane,
    clip_to_window,
    minkowski_difference,
    window_ring,
    wrong_number_region,
)
from .region_of_axes import region_of_verdict
from .region_of_pushes import overlaps, why_no_cells
from .wrong_steps import is_closing_edge, measured_test, vertex_count

FAR_APART = 5.0  # from this distance of their centers on, the case far-centers calls two shapes apart
SHAPE_COUNT = 1000  # shapes in the case many-pairs
MIN_SUPPORT_POINTS = 3  # that GJK needs for a hit: a triangle round the origin


def first_half_of_normals(a: Shape, b: Shape) -> Choice:
    """Return the normals of the first half of the edges of each outline, as a Choice."""
    kept = (
        axis
        for axis in edge_normals(a, b).axes
        if not is_closing_edge(axis, a, b) and axis.source.ids[0] < vertex_count(axis, a, b) // 2
    )
    return Choice(tuple(kept))


def centers_first(a: Shape, b: Shape) -> Choice:
    """Return the axis through both centers followed by all needed axes, as a Choice."""
    return Choice((*centers(a, b).axes, *needed(a, b).axes))


def within_reach(a: Shape, b: Shape, axis: Axis) -> AxisTest:
    """Return the test of an axis; on that of the centers each shape is a circle of radius FAR_APART / 2."""
    if axis.source.kind not in (CENTERS, CENTROIDS):
        return measured_test(axis, project(a, axis), project(b, axis))
    return measured_test(axis, *(project(Circle(centroid(s), FAR_APART / 2), axis) for s in (a, b)))


def region_of_far_centers(a: Shape, b: Shape, window: Window) -> RegionOrReason:
    """Return the moves for which the shortcut far-centers gives a wrong verdict, or why none is shown."""
    near = minkowski_difference(*(Circle(centroid(shape), FAR_APART / 2) for shape in (a, b)))
    without_check = CENTERS_FAR_APART._replace(choose=needed)
    return region_of_verdict(a, b, without_check, window, start=clip_to_window(next(near), window))


def normals_of_upright_faces(a: Shape, b: Shape) -> Choice:
    """Return the normals of the upright faces of two boxes in space, seen from above."""
    of_b = (axis for axis in edge_normals(a, b).axes if axis.source[1:] in (("B", (0, 1)), ("B", (2, 3))))
    return Choice((*edge_normals_of_a(a, b).axes, *of_b))


def gap_in_space(a: Shape, b: Shape) -> float:
    """Return the largest gap on all fifteen axes of the two boxes threed.PAIR; a and b are not used."""
    return max(found.gap for found in (*threed.face_gaps(*threed.PAIR), *threed.edge_gaps(*threed.PAIR)))


def one_test_each(trace: Trace) -> float:
    """Return SHAPE_COUNT, the claimed number of tests: one for each shape."""
    return SHAPE_COUNT


def count_pairs(a: Shape, b: Shape) -> float:
    """Return the number of pairs among SHAPE_COUNT shapes; a and b are not used."""
    return comb(SHAPE_COUNT, 2)


def region_of_count(a: Shape, b: Shape, window: Window) -> str:
    """Return the reason why this case has no error region: a count does not depend on B's place."""
    return "the count does not depend on where B is"


def least_evaluations_of_gjk(trace: Trace) -> float:
    """Return the least number of vertex evaluations in GJK: all vertices per support point.

    A hit takes MIN_SUPPORT_POINTS support points at least, a miss one.
    """
    return (MIN_SUPPORT_POINTS if trace.hit else 1) * (len(trace.a.core) + len(trace.b.core))


def evaluations_of_sat(a: Shape, b: Shape) -> float:
    """Return how many points SAT projects, counted once for each axis, until its verdict is certain."""
    trace = record(a, b)
    tests = (test for run in trace.pairs or (trace,) for test in run.tests)
    return sum(len(test.a.points) + len(test.b.points) for test in tests)


def region_of_few_evaluations(a: Shape, b: Shape, window: Window) -> RegionOrReason:
    """Return the moves where SAT evaluates no more vertices than GJK, or why none is shown."""
    if why := why_no_cells(a, b):
        return why
    axes, (ring,) = needed(a, b).axes, minkowski_difference(a, b)
    sides = [side for side, _ in overlaps(a, b, axes[0])]
    found = [clip_to_half_plane(window_ring(window), Vec(-side.down.x, -side.down.y), -side.rest) for side in sides]
    if len(axes) <= MIN_SUPPORT_POINTS:
        found.append(clip_to_window(ring, window))
    return wrong_number_region(a, b, window, found)


CENTERS_FAR_APART = Shortcut("far-centers", "the centers are far apart, so the shapes are", centers_first, within_reach)

CASES = (
    FailureCase(
        Shortcut("half-the-normals", "opposite edges are parallel, so half the normals will do", first_half_of_normals),
        FALSE_HIT,
        (Polygon([(0, 0), (6, 0), (4, 2), (2, 2)]), box(-0.9, 0.4, 0.1, 1.4)),
    ),
    FailureCase(
        Shortcut("same-shape", "two squares have the same normals, so one's will do", edge_normals_of_a),
        FALSE_HIT,
        (box(-1, -1, 1, 1), diamond(1.8, 1.8, sqrt(2))),
    ),
    FailureCase(
        CENTERS_FAR_APART,
        MISSED_HIT,
        (box(-10, -0.5, 10, 0.5), box(9, -0.5, 10, 0.5)),
        error_region=region_of_far_centers,
    ),
    FailureCase(
        Shortcut("many-pairs", "a thousand shapes, a thousand tests: threads will do it"),
        WRONG_NUMBER,
        (box(0, 0, 1, 1), box(2, 0, 3, 1)),
        quantity="tests:",
        claimed_value=one_test_each,
        true_value=count_pairs,
        error_region=region_of_count,
        panels=Panels("separate dots", "joined dots"),
        verdicts=("", ""),
    ),
    FailureCase(
        Shortcut("faces-in-3d", "for boxes in space the face normals are enough", normals_of_upright_faces),
        FALSE_HIT,
        (Polygon(threed.seen_from_above(threed.PAIR[0])), Polygon(threed.seen_from_above(threed.PAIR[1]))),
        true_value=gap_in_space,
        panels=Panels("solid boxes", "solid boxes apart"),
    ),
    FailureCase(
        Shortcut("gjk-looks-less", "GJK always has less to look at"),
        WRONG_NUMBER,
        (box(0, 0, 2, 2), box(1, 1, 4, 3)),
        quantity="vertices looked at:",
        claimed_value=least_evaluations_of_gjk,
        true_value=evaluations_of_sat,
        claims_less=True,
        error_region=region_of_few_evaluations,
        panels=Panels("support points", "axes of SAT"),
        verdicts=("", ""),
    ),
)
