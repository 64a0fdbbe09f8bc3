"""The two panels of most shortcuts: the tests that the answer comes from, and the proof of the truth.

A shortcut is a mistaken or cheaper collision test; its push is the move of B by which it would end an overlap.
"""

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import lru_cache
from math import hypot, isclose
from typing import NamedTuple

from ..engine import describe
from ..engine.axes import (
    CENTERS,
    CENTROIDS,
    EDGE,
    FROM_EDGES,
    GIVEN,
    SLIP,
    VERTEX,
    WORLD,
    Axis,
    Choice,
    edge_normals,
    hull_normals,
    world,
)
from ..engine.certificate import SeparatingLine, SharedPoint
from ..engine.geometry import Vec
from ..engine.number_format import MINUS
from ..engine.sat import AxisTest, axis_tests
from ..engine.shapes import Polygon, Shape, centroid
from ..engine.trace import Trace, record
from ..scenes.failing import case_of
from ..scenes.shape_tools import translated
from .claims import is_about_push, is_near
from .draw_steps import draw_mtv, draw_separating_line, draw_verdict
from .float_geometry import are_parallel, gap_or_overlap, midpoint, point_along
from .labels import short_name
from .layout import Layout, PanelContents
from .sketch import RIGHT_ANGLE_PT, RING_PT, Sketch

PROVES_NOTHING = "true, but\nproves nothing"
LEAST_WORDY_PT = 200.0  # width of a panel from which on it explains the MTV and remarks on a test


def mtv_name(layout: Layout) -> str:
    """Return the label of the MTV in a panel: with an explanation if the panel is wide enough."""
    return "shortest way out,\nMTV" if layout.size[0] >= LEAST_WORDY_PT else "MTV"


class PanelSketch(Sketch):
    """A sketch of a panel: both panels have axes of their own, so each is named by the edge that it comes from."""

    def axis_label(self, test: AxisTest) -> str:
        """Return "normal of a1a2", or what else the axis comes from."""
        (kind, role, ids), names = test.source, self.trace.names
        if kind == GIVEN:
            case = case_of(self.trace.shortcut)
            vector = describe.digits(self.trace).vector(test.axis.direction)
            return case.direction_name.format(vector) if case else vector
        if kind not in (*FROM_EDGES, VERTEX):
            return {CENTERS: "through the centers", CENTROIDS: "through the centroids"}.get(kind, "axis")
        name, polygon = self.named_polygon(role)
        ends = [short_name(polygon, name, i) for i in ids]
        other = names.b if role == "A" else names.a
        if kind == VERTEX:
            return f"through {ends[0]} and\n{other}'s center"
        return f"{'(dx, -dy)' if kind == SLIP else 'normal'} of {describe.edge_name(ends)}".replace("-", MINUS)

    def label_axis_vertices(self, test: AxisTest) -> None:
        """Label the vertices that define a test's axis: both ends of its edge, or the one vertex."""
        if test.source.kind in (*FROM_EDGES, VERTEX):
            self.vertices(test.source.shape or "", test.source.ids)


class Panel(NamedTuple):
    """A panel: what it needs space for, and the function that draws it on the layout with that space."""

    needs: Callable[[Trace], PanelContents]
    draw: Callable[[Trace, Layout], Sketch]


def contents_of_claimed_tests(trace: Trace) -> PanelContents:
    """Return both shapes, B where the shortcut pushes it, and the tests its answer comes from (`claimed_tests`)."""
    push = trace.push if is_about_push(trace) else None
    return PanelContents(
        _shapes_with_moved_b(trace, push), [drawable_test(trace, test) for test in claimed_tests(trace)]
    )


def draw_claimed_tests(trace: Trace, layout: Layout) -> Sketch:
    """Draw the tests that the shortcut's answer comes from (`claimed_tests`), what it left out, and its push."""
    sketch = PanelSketch(trace, layout)
    tests = claimed_tests(trace)
    if {test.source for test in trace.tests} == {axis.source for axis in world(trace.a, trace.b).axes} and not (
        trace.a.is_upright_box and trace.b.is_upright_box
    ):
        sketch.bounding_boxes()
    sketch.shapes()
    remarks = [remark_on(trace, test) if layout.size[0] >= LEAST_WORDY_PT else "" for test in tests]
    if len(tests) > 1 and set(remarks) == {PROVES_NOTHING}:
        sketch.note("remark", "true overlaps, but they prove nothing", "overlap", first=3)
        remarks = [""] * len(tests)
    for test, place, remark in zip(tests, layout.places, remarks, strict=False):
        if any(test.axis.normal):
            if len(tests) == 1:
                sketch.edge(test)
                sketch.label_axis_vertices(test)
                sketch.normal(test)
                _draw_what_is_missing(sketch, test)
            on = ""
            if len(tests) > 1 and remark == PROVES_NOTHING and test.source.kind == WORLD:  # the mistake is on another
                on, remark = f"{'xy'[test.source.ids[0]]}, true", ""
            sketch.project(test, place, drops=len(tests) == 1, interval=False, remark=remark, on=on)
        else:
            sketch.no_axis(test)
    if len(tests) < len(trace.tests) and not trace.ended_by and any(any(test.axis.normal) for test in tests):
        sketch.note("tested", f"shown: the least overlap of {len(trace.tests)} axes", "guide", first=7)
    draw_push(sketch)
    return sketch


def remark_on(trace: Trace, test: AxisTest) -> str:
    """Return a remark on a test, or "": that it proves nothing, or how touching is compared."""
    if trace.shortcut and trace.shortcut.touching_separates and test.gap == 0:
        spot = meeting_point(trace, test)
        return f"{spot} \u2264 {spot}, so it counts as a gap"
    proves_nothing = trace.false_hit and test.gap < 0 and is_measured_correctly(trace, test)
    return PROVES_NOTHING if proves_nothing else ""


def meeting_point(trace: Trace, test: AxisTest) -> str:
    """Return the coordinate at which two ranges touch, as text."""
    a, b = test.a.interval, test.b.interval
    return describe.digits(trace, test).landing(a.hi if a.hi == b.lo else b.hi)


def is_measured_correctly(trace: Trace, test: AxisTest) -> bool:
    """Check whether a shortcut measured the gap or overlap on its axis correctly, up to rounding.

    Where one range lies inside the other, the length that both share counts as correct, too, although a move that
    ends the overlap is longer.
    """
    if not any(test.axis.normal):
        return False
    exact = next(axis_tests(trace.a, trace.b, [test.axis]))
    both = gap_or_overlap(exact)
    true = [exact.gap, *([both.lo - both.hi] if exact.gap < 0 and both.lo < both.hi else [])]
    return any(isclose(gap, test.gap, rel_tol=1e-9, abs_tol=1e-300) for gap in true)


def forgotten_normals(trace: Trace) -> list[Axis]:
    """Return the edge normals that are parallel to no axis of the trace; [] unless its axes are edge normals."""
    if not all(test.source.kind == EDGE for test in trace.tests):
        return []
    tested = [test.axis for test in trace.tests]
    every = edge_normals(trace.a, trace.b).axes
    return [axis for axis in every if not any(are_parallel(axis, other) for other in tested)]


def _draw_what_is_missing(sketch: Sketch, test: AxisTest) -> None:
    """Draw normals that a shortcut never tested, corners it never projected, and circles it takes the shapes for."""
    trace = sketch.trace
    left_out = forgotten_normals(trace) if trace.false_hit and trace.ended_by is None else []
    if left_out and not _draw_missing_edges(sketch, left_out):
        sketch.crossed_normals(left_out)
        sketch.note("left-out-name", "crossed: never tested", "wrong", first=7)
    if test.source.kind == CENTROIDS:
        radii = [describe.digits(trace).gap((s.interval.hi - s.interval.lo) / 2) for s in (test.a, test.b)]
        text = f"counted as circles,\nradius {' and '.join(dict.fromkeys(radii))}"
        low = Vec(midpoint(test.a.points[0], test.b.points[0]).x, sketch.layout.limits[1])
        sketch.label("believed-name", text, "wrong", low, far=True, optional=True, first=3)
    for (role, name, shape), side in zip(sketch.roles(), (test.a, test.b), strict=True):
        if test.source.kind == CENTROIDS:
            p, q = side.points[0], side.points[-1]
            radius = hypot(q.x - p.x, q.y - p.y) / 2
            sketch.add("believed", "disc", role, midpoint(p, q), owner=name, radius=radius, weight="faint")
        elif isinstance(shape, Polygon) and set(side.points) < set(shape.corners):
            missed = [v for v in shape.corners if v not in side.points]
            for i, v in enumerate(missed):
                radius = sketch.layout.units(RING_PT)
                sketch.add("missed", "disc", "wrong", v, owner=name, number=i, radius=radius)
            text = "never looked at"
            sketch.label("missed-name", text, "wrong", missed[0], owner=name, along=tuple(missed[1:]), first=3)


def _draw_missing_edges(sketch: Sketch, left_out: Sequence[Axis]) -> bool:
    """Draw both outlines open and their closing edges dotted, if only these were left out; return whether they were."""
    closing = [(role, (0, len(shape.vertices) - 1)) for role, _, shape in sketch.roles()]
    if sorted((axis.source.shape or "", axis.source.ids) for axis in left_out) != closing:
        return False
    sketch.marks = [m._replace(weight="fill") if m.part == "outline" else m for m in sketch.marks]
    for role, name, shape in sketch.roles():
        sketch.add("open-outline", "bracket", role, *shape.vertices, owner=name)
        p, q = shape.vertices[0], shape.vertices[-1]
        sketch.add("missing-edge", "segment", role, p, q, owner=name, weight="faint")
    sketch.note("missing-name", "dotted side of each shape: left out", "wrong", first=7)
    return True


def claimed_tests(trace: Trace) -> list[AxisTest]:
    """Return the tests behind a shortcut's answer: the one that ended the run, else both of two tests.

    Of more tests it is the one of the least overlap.  If the answer is a push, the test parallel to the true axis is
    added where the shortcut measured it wrong.
    """
    if trace.ended_by:
        return [trace.ended_by]
    if len(trace.tests) == 2 or not trace.shallowest:
        return list(trace.tests) if len(trace.tests) == 2 else []
    best = max(trace.truth.tests, key=lambda test: test.gap, default=None)
    if best and is_about_push(trace):
        rivals = (test for test in trace.tests if are_parallel(test.axis, best.axis))
        rival = max(rivals, key=lambda test: test.gap, default=None)
        if rival and not (is_measured_correctly(trace, rival) or are_parallel(rival.axis, trace.shallowest.axis)):
            return [trace.shallowest, rival]
    return [trace.shallowest]


def draw_push(sketch: Sketch) -> None:
    """Draw the shortcut's push as a named arrow with B at its end, if the shortcut's answer depends on this push.

    Of a push too long for the picture, draw the name alone.
    """
    trace = sketch.trace
    if not is_about_push(trace) or not trace.push:
        return
    start = tip = centroid(trace.b)
    text = f"push {describe.digits(trace).vector(trace.push)}"
    if not is_near(trace, trace.push):
        text += ",\nout of the picture"
    elif any(trace.push):
        tip = point_along(start, trace.push, 1.0)
        sketch.shape("B", f"{trace.names.b} pushed", translated(trace.b, trace.push), weight="faint", named=False)
        sketch.add("push", "arrow", "move", start, tip, start=(start,))
    prefer = trace.push if any(trace.push) else Vec(0.0, 1.0)
    sketch.label("push-name", text, "move", tip, prefer=prefer, far=tip is start, first=3)


def needs_proof(trace: Trace) -> PanelContents:
    """Return what the panel of the proof needs: both shapes, B moved by the MTV, and the exact test that is shown."""
    test = true_test(trace)
    return PanelContents(_shapes_with_moved_b(trace, trace.truth.known_mtv), [test] if test else [])


def draw_proof(trace: Trace, layout: Layout) -> Sketch:
    """Draw the proof of the truth: the separating axis and line, or a shared point, the true ranges and the MTV."""
    run, test = true_run(trace), true_test(trace)
    if test is None:
        sketch = Sketch(run, layout)
        draw_verdict(sketch, layout.places, named=False)
        return sketch
    run = replace(run, choice=Choice((test.axis,), complete=run.choice.complete), tests=(test,))
    place = layout.places[-1]
    sketch = PanelSketch(run, layout)
    sketch.shapes()
    if test.source.kind in (CENTERS, VERTEX):
        sketch.edge(test)
    sketch.label_axis_vertices(test)
    certificate = trace.truth.certificate if trace.hit else run.certificate
    if isinstance(certificate, SeparatingLine):
        draw_separating_line(sketch, certificate)
        if test.gap * place.unit * layout.scale > 4 * RIGHT_ANGLE_PT:  # in a small gap its bracket fills the space
            sketch.right_angle_of_line(certificate.point, place)
    elif isinstance(certificate, SharedPoint):
        sketch.add("shared", "dot", "ink", certificate.point)
        sketch.label("shared-name", "in both", "ink", certificate.point, first=4)
        move = trace.truth.known_mtv
        if move and hypot(*move) * layout.scale > 1.0:  # else neither the arrow nor the moved B would be seen
            draw_mtv(sketch, certificate.point, move, mtv_name(layout))
    spot = meeting_point(trace, test) if trace.shortcut and trace.shortcut.touching_separates else ""
    remark = f"{spot} < {spot} is false: no gap" if spot and test.gap == 0 else ""
    best = max(true_run(trace).tests, key=lambda other: other.gap)
    if test.gap < best.gap and not isclose(test.gap, best.gap, rel_tol=1e-9):
        remark = f"least on another axis: {describe.digits(true_run(trace), best).gap(best.gap)}"
    sketch.project(test, place, drops=False, interval=False, remark=remark)
    return sketch


def true_test(trace: Trace) -> AxisTest | None:
    """Return the exact test to show: that of the largest gap, or for a hit that on the axis that ended the run.

    The run is the shortcut's.  None for concave outlines that no line separates.
    """
    run = true_run(trace)
    if run.pairs:
        return None
    best = max(run.tests, key=lambda test: test.gap)
    ended = trace.ended_by
    if best.gap > 0 or ended is None or not any(ended.axis.normal):
        return best
    return next(axis_tests(trace.a, trace.b, [ended.axis]))


@lru_cache(maxsize=64)
def true_run(trace: Trace) -> Trace:
    """Return the exact run; for concave outlines the run over their hulls if a line separates the hulls."""
    truth = trace.truth
    if not truth.pairs:
        return truth
    hulls = record(trace.a, trace.b, axes=hull_normals, every_axis=True)
    return hulls if hulls.separating else truth


def drawable_test(trace: Trace, test: AxisTest) -> AxisTest:
    """Return `test`, or another test if its axis is (0, 0), which has no direction to lay out."""
    return test if any(test.axis.normal) else next(t for t in trace.tests if any(t.axis.normal))


def _shapes_with_moved_b(trace: Trace, move: Vec | None) -> list[Shape]:
    """Return both shapes, and B translated by `move` if that is near enough to be drawn."""
    return [trace.a, trace.b, *([translated(trace.b, move)] if move and is_near(trace, move) else [])]
