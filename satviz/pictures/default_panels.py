"""The two panels of most shortcuts: the tests that its answer comes from, and what proves the truth."""

from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache
from typing import NamedTuple

from ..engine import describe
from ..engine.axes import Choice, hull_normals
from ..engine.certificate import SeparatingLine, SharedPoint
from ..engine.geometry import Vec
from ..engine.sat import AxisTest, axis_tests
from ..engine.shapes import Shape, centroid
from ..engine.trace import Trace, record
from ..scenes.shape_tools import translated
from .claims import is_about_push, is_near
from .draw_steps import draw_mtv, draw_separating_line, draw_verdict
from .float_geometry import point_along
from .layout import Group, Layout
from .sketch import Sketch


class Panel(NamedTuple):
    """A panel: what it needs space for, and the function that draws it on the layout with that space."""

    needs: Callable[[Trace], Group]
    draw: Callable[[Trace, Layout], Sketch]


def needs_claimed_tests(trace: Trace) -> Group:
    """Return both shapes, B where the shortcut pushes it, and the tests that its answer comes from."""
    push = trace.push if is_about_push(trace) else None
    return Group(_shapes_with_moved_b(trace, push), [drawable_test(trace, test) for test in claimed_tests(trace)])


def draw_claimed_tests(trace: Trace, layout: Layout) -> Sketch:
    """Draw the tests that the shortcut's answer comes from, and its push."""
    sketch = Sketch(trace, layout)
    sketch.shapes()
    tests = claimed_tests(trace)
    for test, place in zip(tests, layout.places, strict=False):
        if any(test.axis.normal):
            if len(tests) == 1:
                sketch.edge(test)
                sketch.normal(test)
            sketch.project(test, place, drops=len(tests) == 1, interval=False)
        else:
            sketch.no_axis(test)
    if len(tests) < len(trace.tests) and not trace.ended_by:
        sketch.note("tested", f"the least overlap of {len(trace.tests)} axes", "guide", first=7)
    draw_push(sketch)
    return sketch


def claimed_tests(trace: Trace) -> list[AxisTest]:
    """Return the tests behind a shortcut's answer: the deciding one; else both of two, or the shallowest."""
    if trace.ended_by:
        return [trace.ended_by]
    return list(trace.tests) if len(trace.tests) == 2 else [trace.shallowest] if trace.shallowest else []


def draw_push(sketch: Sketch) -> None:
    """Draw B where the shortcut pushes it, if its answer depends on that."""
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
    sketch.label("push-name", text, "move", tip, prefer=prefer, far=not is_near(trace, trace.push), first=3)


def needs_proof(trace: Trace) -> Group:
    """Return both shapes, B moved by the MTV, and the exact test that is shown."""
    test = true_test(trace)
    return Group(_shapes_with_moved_b(trace, trace.truth.known_mtv), [test] if test else [])


def draw_proof(trace: Trace, layout: Layout) -> Sketch:
    """Draw what proves the truth: the separating axis and line, or a shared point, the true ranges and the MTV."""
    run, test = true_run(trace), true_test(trace)
    if test is None:
        sketch = Sketch(run, layout)
        draw_verdict(sketch, layout.places, named=False)
        return sketch
    run = replace(run, choice=Choice((test.axis,), complete=run.choice.complete), tests=(test,))
    place = layout.places[-1]
    sketch = Sketch(run, layout)
    sketch.shapes()
    certificate = trace.truth.certificate if trace.hit else run.certificate
    if isinstance(certificate, SeparatingLine):
        draw_separating_line(sketch, certificate)
    elif isinstance(certificate, SharedPoint):
        sketch.add("shared", "dot", "ink", certificate.point)
        sketch.label("shared-name", "in both", "ink", certificate.point, first=4)
        move = trace.truth.known_mtv
        if move and any(move):
            draw_mtv(sketch, certificate.point, move)
    sketch.project(test, place, drops=False, interval=False)
    return sketch


def true_test(trace: Trace) -> AxisTest | None:
    """Return the exact test to show: that of the largest gap, or on a hit the shortcut's; None for parts."""
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
    """Return the exact run; for concave outlines the run over their hulls where a line separates these."""
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
