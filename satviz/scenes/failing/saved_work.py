"""Cases in which work is saved in the wrong place: fewer axes, a check in advance, fewer pairs, fewer vertices.

A function that returns a Choice chooses a shortcut's axes, and one of (a, b, axis) measures one of them.  A window is
the upright box of B's moves (x0, y0, x1, y1) for which an error region is computed.
"""

from collections.abc import Callable
from math import comb, dist, sqrt
from operator import itemgetter

from ...engine.axes import CENTERS, CENTROIDS, Axis, Choice, centers, edge_normals, edge_normals_of_a, needed
from ...engine.geometry import Vec
from ...engine.sat import AxisTest, Projection, project
from ...engine.shapes import Circle, Polygon, Shape, centroid
from ...engine.shortcut import Shortcut
from ...engine.trace import Trace, record
from ..shape_tools import box, diamond
from . import threed
from .failure_case import FALSE_HIT, MISSED_HIT, WRONG_NUMBER, FailureCase, Panels
from .move_space import (
    ErrorRegion,
    RegionOrReason,
    Window,
    clip_to_half_plane,
    clip_to_window,
    convex_hull,
    hits_in_window,
    minkowski_difference,
    subtract,
    window_ring,
    wrong_number_region,
)
from .region_of_axes import region_of_verdict
from .region_of_pushes import overlaps, why_no_cells
from .wrong_steps import is_closing_edge, measured_test, vertex_count

FAR_APART = 5.0  # the case far-centers calls two shapes apart if their centers are at least so far apart
SHAPE_COUNT = 1000  # shapes in the case many-pairs
MIN_SUPPORT_POINTS = 3  # GJK needs so many for a hit: a triangle around the origin


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
    """Return the normals of those edges that are upright faces of two boxes in space, seen from above, as a Choice."""
    of_b = (axis for axis in edge_normals(a, b).axes if axis.source[1:] in (("B", (0, 1)), ("B", (2, 3))))
    return Choice((*edge_normals_of_a(a, b).axes, *of_b))


def gap_in_space(a: Shape, b: Shape) -> float:
    """Return the largest gap on all fifteen axes of the two boxes threed.PAIR; a and b are not used."""
    return max(found.gap for found in (*threed.face_gaps(*threed.PAIR), *threed.edge_gaps(*threed.PAIR)))


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
    axes = needed(a, b).axes
    sides = [side for side, _ in overlaps(a, b, axes[0])]
    found = [clip_to_half_plane(window_ring(window), Vec(-f.slope.x, -f.slope.y), -f.constant) for f in sides]
    if len(axes) <= MIN_SUPPORT_POINTS:
        found += hits_in_window(a, b, window)
    return wrong_number_region(a, b, window, found)


def corner_tests(a: Shape, b: Shape) -> list[AxisTest]:
    """Return a test for each corner of two polygons: on the edge normal of the other with the largest gap.

    One side of the test is the corner alone.  A corner lies in the other polygon, if that is convex, where the gap is
    not positive.  The list is empty if a shape is a circle.
    """
    if a.core_is_point or b.core_is_point:
        return []
    found = []
    for edges_of in "AB":
        normals = [axis for axis in edge_normals(a, b).axes if axis.source.shape == edges_of]
        both = [(axis, project(a, axis), project(b, axis)) for axis in normals]
        for i in range(len((b if edges_of == "A" else a).core)):
            alone = [
                (x, p, _projection_of_corner(q, i)) if edges_of == "A" else (x, _projection_of_corner(p, i), q)
                for x, p, q in both
            ]
            found.append(max((measured_test(*test) for test in alone), key=lambda test: test.gap))
    return found


def _projection_of_corner(side: Projection, i: int) -> Projection:
    """Return the part of a projection that belongs to corner i alone, counted from 0."""
    return Projection(side.points[i : i + 1], side.landings[i : i + 1])


def innermost_corner(a: Shape, b: Shape) -> AxisTest | None:
    """Return the test of the corner that lies deepest in the other polygon; None if a shape is a circle."""
    return min(corner_tests(a, b), key=lambda test: test.gap, default=None)


def least_clearance(a: Shape, b: Shape) -> AxisTest | None:
    """Return the test of the edge nearest to the polygon that lies strictly inside the other; None if neither does.

    The gap of this test is the distance from that edge.
    """
    for edges_of in "AB" if a.is_convex and b.is_convex else "":
        found = []
        for axis in edge_normals(a, b).axes:
            if axis.source.shape == edges_of:
                p, q = project(a, axis), project(b, axis)
                (lo, hi), (low, high) = (p.interval, q.interval) if edges_of == "A" else (q.interval, p.interval)
                end, gap = min((lo, low - lo), (hi, hi - high), key=itemgetter(1))
                near = [
                    _projection_of_corner(side, side.landings.index(end)) if end in side.landings else side
                    for side in (p, q)
                ]
                found.append(AxisTest(axis, near[0], near[1], gap))
        least = min(found, key=lambda test: test.gap, default=None)
        if least and least.gap > 0:
            return least
    return None


def by_one_test(name: str, claim: str, find: Callable[[Shape, Shape], AxisTest | None]) -> Shortcut:
    """Return a shortcut that makes only the test which `find` returns; where that is None, it tests all needed axes."""

    def axes(a: Shape, b: Shape) -> Choice:
        """Return the axis of the found test, else all needed axes, as a Choice."""
        test = find(a, b)
        return Choice((test.axis,)) if test else needed(a, b)

    def measure(a: Shape, b: Shape, axis: Axis) -> AxisTest:
        """Return the found test, else the test of an axis with both whole shapes."""
        return find(a, b) or measured_test(axis, project(a, axis), project(b, axis))

    return Shortcut(name, claim, axes, measure)


def region_inside(a: Shape, b: Shape, window: Window) -> RegionOrReason:
    """Return the moves for which one polygon lies inside the other, or why none is shown."""
    if a.core_is_point or b.core_is_point:
        return "a circle has no edges"
    if not (a.is_convex and b.is_convex):
        return "a shape has a dent, so the other can lie between its edges and yet outside"
    missed = []
    for edges_of in "AB":
        ring = window_ring(window)
        for axis in edge_normals(a, b).axes:
            if axis.source.shape == edges_of:
                n, (p_lo, p_hi), (q_lo, q_hi) = axis.direction, project(a, axis).interval, project(b, axis).interval
                lo, hi = sorted((p_lo - q_lo, p_hi - q_hi))
                ring = () if (p_hi - p_lo < q_hi - q_lo) is (edges_of == "A") else ring
                ring = clip_to_half_plane(clip_to_half_plane(ring, n, hi), Vec(-n.x, -n.y), -lo)
        missed += [ring] if ring else []
    return ErrorRegion((), tuple(missed), hits_in_window(a, b, window))


def circle_around(shape: Shape) -> Circle:
    """Return the circle about a shape's centroid through the vertex that is furthest from it."""
    middle = centroid(shape)
    return Circle(middle, max((dist(middle, vertex) for vertex in shape.vertices), default=shape.radius))


def circles_around(a: Shape, b: Shape, axis: Axis) -> AxisTest:
    """Return the test of an axis with the circles round both shapes."""
    return measured_test(axis, *(project(circle_around(shape), axis) for shape in (a, b)))


def region_of_circles_around(a: Shape, b: Shape, window: Window) -> RegionOrReason:
    """Return the moves for which the circles round both shapes meet, and the shapes do not."""
    hits = hits_in_window(a, b, window)
    (ring,) = hits_in_window(circle_around(a), circle_around(b), window)
    return ErrorRegion(tuple(subtract(ring, hits)), (), hits)


def region_of_corners(a: Shape, b: Shape, window: Window) -> RegionOrReason:
    """Return the moves for which the shapes meet without a corner of one in the other, or why none is shown."""
    if a.core_is_point or b.core_is_point:
        return "a circle has no corners"
    if not (a.is_convex and b.is_convex):
        return "a shape has a dent, where a corner may lie on the inner side of each edge and still outside"
    at_a = [convex_hull(Vec(p.x - q.x, p.y - q.y) for q in b.core) for p in a.core]
    at_b = [convex_hull(Vec(p.x - q.x, p.y - q.y) for p in a.core) for q in b.core]
    hits = hits_in_window(a, b, window)
    return ErrorRegion((), tuple(piece for hit in hits for piece in subtract(hit, [*at_a, *at_b])), hits)


CENTERS_FAR_APART = Shortcut("far-centers", "the centers are far apart, so the shapes are", centers_first, within_reach)

CASES = (
    FailureCase(
        Shortcut("half-the-normals", "opposite edges are parallel, so half the normals will do", first_half_of_normals),
        FALSE_HIT,
        (box(0, 2.5, 1.8, 4.3), Polygon([(0, 0), (7, 0), (4, 3), (3, 3)])),
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
        panels=Panels("far centers"),
    ),
    FailureCase(
        by_one_test("corner-inside", "where two shapes meet, a corner of one lies in the other", innermost_corner),
        MISSED_HIT,
        (box(0, 1, 3, 2), box(1, 0, 2, 3)),
        error_region=region_of_corners,
        panels=Panels(claimed="corners"),
    ),
    FailureCase(
        by_one_test("edges-cross", "where two shapes meet, their edges cross", least_clearance),
        MISSED_HIT,
        (box(0, 0, 5, 4), box(2, 1, 3, 2)),
        error_region=region_inside,
        panels=Panels(claimed="edges"),
    ),
    FailureCase(
        Shortcut("bounding-circles", "the circles round the shapes meet, so the shapes do", centers, circles_around),
        FALSE_HIT,
        (box(0, 0, 4, 1), box(0, 2, 4, 3)),
        error_region=region_of_circles_around,
    ),
    FailureCase(
        Shortcut("many-pairs", "a thousand shapes, a thousand tests: threads will do it"),
        WRONG_NUMBER,
        (box(0, 0, 1, 1), box(2, 0, 3, 1)),
        quantity="tests:",
        claimed_value=lambda trace: SHAPE_COUNT,
        true_value=lambda a, b: comb(SHAPE_COUNT, 2),
        error_region=lambda a, b, window: "the count does not depend on where B is",
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
        panels=Panels("searches", "axes of SAT"),
        verdicts=("", ""),
    ),
)
