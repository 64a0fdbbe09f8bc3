"""Cases in which the gaps are right and the conclusion is not: a push, a distance, a moving shape, a wrong sign.

A push is the move of B by which a shortcut would end an overlap; `tests` are those of its run.  A window is the upright
box of B's moves (x0, y0, x1, y1) for which an error region is computed.
"""

from collections.abc import Sequence
from functools import partial
from math import atan2, copysign, cos, dist, nan, sin
from typing import Any

from ...engine.axes import SLIP, Axis, Choice, directions, edge_normals, needed
from ...engine.convex_parts import parts
from ...engine.geometry import Vec
from ...engine.sat import AxisTest, project
from ...engine.shapes import Polygon, Shape
from ...engine.shortcut import Shortcut, move_along_axis
from ...engine.trace import Trace, record
from ..shape_tools import box, translated, vertex_mean
from . import true_value
from .failure_case import DEPTH, FALSE_HIT, MISSED_HIT, WRONG_NUMBER, FailureCase, Panels
from .move_space import (
    TOLERANCE,
    ErrorRegion,
    RegionOrReason,
    Window,
    clip_to_half_plane,
    clip_to_window,
    convex_hull,
    minkowski_difference,
    subtract,
    window_ring,
    wrong_number_region,
)
from .region_of_pushes import (
    region_of_depth,
    region_of_every_overlap,
    region_of_pieces,
    region_of_push_along_axis,
    region_of_push_to_mean,
    shared_lengths,
)
from .wrong_steps import only_x

# -- pushes


def push_from_center(a: Shape, b: Shape, tests: Sequence[AxisTest]) -> Vec:
    """Return a push of B as long as the least overlap, along its axis, but directed from A's vertex mean to B's."""
    if not tests:
        return Vec(0.0, 0.0)
    test = max(tests, key=lambda test: test.gap)
    (px, py), (qx, qy), n = vertex_mean(a), vertex_mean(b), test.axis.direction
    length = copysign(test.gap, n.x * (qx / 2 - px / 2) + n.y * (qy / 2 - py / 2))  # as halves: none overflows
    return Vec(n.x * length, n.y * length)


def push_along_axis(a: Shape, b: Shape, tests: Sequence[AxisTest]) -> Vec:
    """Return a push of B as long as the least overlap, in the direction in which the axis of this overlap points."""
    if not tests:
        return Vec(0.0, 0.0)
    test = max(tests, key=lambda test: test.gap)
    n = test.axis.direction
    return Vec(-test.gap * n.x, -test.gap * n.y)


def push_along_largest(a: Shape, b: Shape, tests: Sequence[AxisTest]) -> Vec:
    """Return a push of B that ends the largest of the overlaps instead of the least one."""
    test = min(tests, key=lambda test: test.gap, default=None)
    return move_along_axis(test, -test.gap) if test else Vec(0.0, 0.0)


def push_half_the_way(a: Shape, b: Shape, tests: Sequence[AxisTest]) -> Vec:
    """Return half of the MTV of B, which would be enough if A moved by the other half."""
    test = max(tests, key=lambda test: test.gap, default=None)
    return move_along_axis(test, -test.gap / 2) if test else Vec(0.0, 0.0)


def overlap_after_push(trace: Trace) -> float:
    """Return the penetration depth that remains after the run's push of B."""
    pushed = translated(trace.b, trace.push or Vec(0.0, 0.0))
    return max(0.0, -max((test.gap for test in record(trace.a, pushed, every_axis=True).tests), default=nan))


def overlap_after_mtv(a: Shape, b: Shape) -> float:
    """Return the penetration depth that remains after B is moved by the MTV: 0 but for rounding."""
    return max(0.0, -true_value.gap(a, translated(b, true_value.mtv(a, b))))


def flat_overlap(a: Shape, b: Shape, axis: Axis) -> AxisTest:
    """Return the test of an axis whose depth is the length that both ranges share.

    This is too short where one range lies inside the other.
    """
    p, q = project(a, axis), project(b, axis)
    return AxisTest(axis, p, q, max(p.interval.lo, q.interval.lo) - min(p.interval.hi, q.interval.hi))


def tiles(shape: Shape) -> Sequence[Shape]:
    """Return the left and the right half of an upright box, and the convex parts of any other shape."""
    if not shape.is_upright_box:
        return parts(shape)
    x0, y0, x1, y1 = shape.bounds
    seam = (x0 + x1) / 2
    return [Polygon([(p, y0), (q, y0), (q, y1), (p, y1)]) for p, q in ((x0, seam), (seam, x1))]


def distance_from_mtv(trace: Trace) -> float:
    """Return the distance between the run's push and the MTV, as vectors; NaN if it makes no push."""
    return dist(trace.push, record(trace.a, trace.b).mtv or (0.0, 0.0)) if trace.push else nan


def squared_distance(push: Vec, mtv: Vec) -> float:
    """Return the squared length of the difference of a push and the MTV."""
    x, y = push.x - mtv.x, push.y - mtv.y
    return x * x + y * y


# -- a distance


def gap_as_distance(trace: Trace) -> float:
    """Return the largest gap that the run measured, or 0 if it measured none."""
    return max(0.0, *(test.gap for test in trace.tests))


def region_not_beside(a: Shape, b: Shape, window: Window) -> ErrorRegion:
    """Return the moves where the shapes are apart and their distance is not the gap on the x axis."""
    rings = [convex_hull(Vec(u.x - v.x, u.y - v.y) for u in p.core for v in q.core) for p in parts(a) for q in parts(b)]
    tolerance = TOLERANCE * max((abs(u) for ring in rings for p in ring for u in p), default=0.0)
    beside = []
    for side in 1, -1:
        far = max((p.x * side for ring in rings for p in ring), default=0.0)
        for ring in rings:
            ys = [p.y for p in ring if far - p.x * side <= tolerance]
            low, high = min(ys, default=0.0), max(ys, default=0.0)
            if low >= high:
                continue
            level = clip_to_half_plane(window_ring(window), Vec(0.0, 1.0), high)
            level = clip_to_half_plane(level, Vec(0.0, -1.0), -low)
            beside.append(clip_to_half_plane(level, Vec(-side, 0.0), -far))
    wrong = subtract(window_ring(window), [*minkowski_difference(a, b), *beside])
    return wrong_number_region(a, b, window, wrong)


# -- motion


def gap_in_both_frames(trace: Trace) -> float:
    """Return the largest gap before A is moved by FLIGHT = (4, 0) or the largest gap after, whichever is smaller."""
    after = translated(trace.a, Vec(*map(float, true_value.FLIGHT)))
    run = record(after, trace.b, axes=trace.shortcut or needed)
    return min(max(test.gap for test in one.tests) for one in (trace, run))


def region_on_the_way(a: Shape, b: Shape, window: Window) -> RegionOrReason:
    """Return the moves for which A hits B only between two frames, or why none is shown."""
    if a.core_is_point or b.core_is_point:
        return "satviz does not compute the flight of a circle"
    if not (a.is_convex and b.is_convex):
        return "a shape has a dent, and both frames are tested without its convex parts"
    x, y = map(float, true_value.FLIGHT)
    (first,) = minkowski_difference(a, b)
    after = tuple(Vec(p.x + x, p.y + y) for p in first)
    way = clip_to_window(convex_hull((*first, *after)), window)
    return wrong_number_region(a, b, window, subtract(way, (first, after)))


# -- one wrong sign, or a normal that is rounded or turned wrongly


def slipped_normals(a: Shape, b: Shape) -> Choice:
    """Return for each edge (dx, dy) the axis along (dx, -dy) instead of the normal (dy, -dx), as a Choice."""
    found = []
    for axis in edge_normals(a, b).axes:
        x, y = axis.normal.y, axis.normal.x  # the normal is (dy, -dx) or its opposite
        turned = Vec(x, y) if (x, y) > (0, 0) else Vec(-x + 0.0, -y + 0.0)
        found.append(Axis(turned, axis.length, axis.source._replace(kind=SLIP)))
    return Choice(tuple(found))


def rounded_normals(a: Shape, b: Shape) -> Choice:
    """Return for each edge the axis along its unit normal with both numbers rounded to whole ones, as a Choice."""
    normals = (axis.direction for axis in edge_normals(a, b).axes)
    return directions(*map(rounded, normals))(a, b)


def rounded(n: Vec) -> Vec:
    """Return a vector with both numbers rounded to whole ones."""
    return Vec(float(round(n.x)), float(round(n.y)))


def turned_by_90_radians(a: Shape, b: Shape) -> Choice:
    """Return for each edge the axis at the edge's angle in radians plus 90 (not plus pi / 2), as a Choice."""
    angles = [atan2(-axis.normal.x, axis.normal.y) + 90 for axis in edge_normals(a, b).axes]
    return directions(*(Vec(cos(angle), sin(angle)) for angle in angles))(a, b)


def slanted_bar(y: float) -> Polygon:
    """Return a bar with upright ends, 6 wide, that rises by 2 to the right; its left end goes from (0, y) 1 up."""
    return Polygon([(0, y), (6, y + 2), (6, y + 3), (0, y + 1)])


# the fields of a case whose push leaves an overlap
REMAINING_OVERLAP: dict[str, Any] = {
    "quantity": "overlap after the push:", "claimed_value": overlap_after_push, "true_value": overlap_after_mtv,
    "is_about_push": True, "panels": Panels("push along normal", "MTV along normal"),
}  # fmt: skip

CASES = (
    FailureCase(
        Shortcut("push-from-center", "the way out is away from the other's center", push=push_from_center),
        WRONG_NUMBER,
        (Polygon([(6, 0), (12, 4), (0, 4)]), Polygon([(5, 1), (7, 1), (6, 4)])),
        **REMAINING_OVERLAP | {"panels": Panels("push from center", "MTV")},
        error_region=region_of_push_to_mean,
    ),
    FailureCase(
        Shortcut("push-along-normal", "the normal of the least overlap points the way out", push=push_along_axis),
        WRONG_NUMBER,
        (box(0, 0, 5, 3), box(-1, 1, 1, 2)),
        **REMAINING_OVERLAP,
        error_region=region_of_push_along_axis,
    ),
    FailureCase(
        Shortcut(
            "range-inside", "the overlap runs from the larger minimum to the smaller maximum", needed, flat_overlap
        ),
        WRONG_NUMBER,
        (box(0, 0, 10, 10), box(4, 4, 5, 5)),
        **DEPTH,
        error_region=partial(region_of_depth, choose=needed, measure=shared_lengths),
    ),
    FailureCase(
        Shortcut("gap-as-distance", "the gap on an axis is the distance", only_x),
        WRONG_NUMBER,
        (box(0, 0, 1, 1), box(4, 5, 5, 6)),
        quantity="distance",
        claimed_value=gap_as_distance,
        true_value=true_value.distance,
        error_region=region_not_beside,
        panels=Panels(actual="distance"),
    ),
    FailureCase(
        Shortcut("tunnelling", "clear in this frame and the next, so clear in between"),
        MISSED_HIT,
        (box(-2.1, -0.1, -1.9, 0.1), box(-0.05, -1, 0.05, 1)),
        claimed_value=gap_in_both_frames,
        true_value=true_value.contact_times,
        error_region=region_on_the_way,
        panels=Panels("two frames", "flight"),
        verdicts=("apart", "they meet on the way"),
    ),
    FailureCase(
        Shortcut("slipped-normal", "the normal of an edge (dx, dy) is (dx, -dy)", slipped_normals),
        FALSE_HIT,
        (slanted_bar(0), slanted_bar(2)),
        panels=Panels(actual="right normal"),
    ),
    FailureCase(
        Shortcut("touch-as-apart", "with < or with <=, the test says the same", touching_separates=True),
        MISSED_HIT,
        (box(0, 0, 2, 1), box(2, 0, 3, 2)),
    ),
    FailureCase(
        Shortcut("tile-seam", "each tile of a floor pushes out what sinks into it", split=tiles),
        WRONG_NUMBER,
        (box(0, 0, 8, 2), box(2.9, 1.5, 4.4, 3)),
        quantity="off the MTV by",
        claimed_value=distance_from_mtv,
        true_value=lambda a, b: 0.0,
        is_about_push=True,
        error_region=partial(region_of_pieces, split=tiles, error=squared_distance),
        panels=Panels(actual="MTV"),
    ),
    FailureCase(
        Shortcut("rounded-normals", "a rounded normal still points the right way", rounded_normals),
        FALSE_HIT,
        (Polygon([(0, 0), (4, 0), (0, 2)]), box(3, 1, 4, 2)),
        direction_name="{}, rounded",
        panels=Panels("rounded normal"),
    ),
    FailureCase(
        Shortcut("degrees-for-radians", "a normal has the edge's angle plus 90, in radians too", turned_by_90_radians),
        FALSE_HIT,
        (box(0, 0, 2, 2), box(3, -1, 5, 1)),
        direction_name="edge's angle\n+ 90 rad",
    ),
    FailureCase(
        Shortcut("largest-overlap", "the way out is along the axis of the largest overlap", push=push_along_largest),
        WRONG_NUMBER,
        (box(0, 0, 4, 4), box(3, 1, 6, 3)),
        **DEPTH,
        error_region=region_of_every_overlap,
    ),
    FailureCase(
        Shortcut("half-the-way", "half of the way is enough, for the other shape moves too", push=push_half_the_way),
        WRONG_NUMBER,
        (box(0, 0, 4, 4), box(3, 1, 6, 3)),
        **REMAINING_OVERLAP | {"panels": Panels("push while A stays", "MTV")},
        error_region=region_of_every_overlap,
    ),
)
