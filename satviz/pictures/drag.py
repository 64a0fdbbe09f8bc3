"""The picture while a shape is dragged: fixed limits, and one test with its axis or one free axis."""

from collections.abc import Sequence
from typing import NamedTuple

from ..engine import describe, number_format
from ..engine.geometry import Relation, Vec
from ..engine.number_format import steady_digits
from ..engine.sat import AxisTest
from ..engine.trace import Trace
from .axis_place import AxisPlace
from .curve import unit_vector
from .draw_steps import draw_mtv_of_overlap, draw_other_parts, draw_parts
from .float_geometry import bounding_box
from .label_placer import LabelMemory
from .layout import Layout, PanelContents, arrange, limits_around, place_axis_within
from .marks import Picture
from .sketch import Sketch

LARGEST_PT = 540.0, 390.0
MIN_WIDTH_PT = 300.0
# shares of the canvas's width and height that the shapes fill at first; the rest is space for moves and axes
SHAPES_PART = 0.6, 0.48
KNOB_RADIUS_PT = 7.0
LEAST_SEEN_PT = 0.1  # a length that a reader cannot see
KNOB_RIM_PT = 16.0  # distance between the knob's center and the rim of the canvas


class ShownTest(NamedTuple):
    """The test that is shown: its run's index in `trace.pairs` (None: the trace itself), and its own index there."""

    pair: int | None
    test: int


def canvas_size(width: float | None) -> tuple[float, float]:
    """Return the canvas (width, height) in points for a place `width` points wide; letters keep their size.

    None means a place of unknown width, for which the canvas is the largest.
    """
    wide = LARGEST_PT[0] if width is None else min(max(width, MIN_WIDTH_PT), LARGEST_PT[0])
    return wide, min(LARGEST_PT[1], wide * 0.95)


def drag_layout(trace: Trace, largest: tuple[float, float] = LARGEST_PT) -> Layout:
    """Return a layout on a canvas of size `largest` (points), with space to drag the shapes in.

    ValueError for shapes that cannot be drawn.
    """
    arrange([PanelContents([trace.a, trace.b])])
    x0, y0, x1, y1 = bounding_box([trace.a, trace.b])
    ends = zip(largest, SHAPES_PART, (x0, y0), (x1, y1), strict=True)
    scale = min(size * part / (hi - lo) for size, part, lo, hi in ends)
    return Layout(limits_around(((x0 + x1) / 2, (y0 + y1) / 2), largest, scale), largest)


def drag_digits(layout: Layout) -> describe.NumberFormat:
    """Return the number format of a drag: as many decimals as a tenth of a point of the picture needs."""
    least = layout.units(LEAST_SEEN_PT)
    return lambda trace, *tests: steady_digits((trace.a, trace.b), tests, least)


def all_marks_fit(drawn: Picture) -> bool:
    """Check whether every mark of a picture lies inside the picture's limits."""
    x0, y0, x1, y1 = drawn.limits
    points = [(p, m.radius) for m in drawn.marks for p in m.points]
    return all(x0 <= p.x - r and p.x + r <= x1 and y0 <= p.y - r and p.y + r <= y1 for p, r in points)


def decisive_test(trace: Trace) -> ShownTest | None:
    """Return the test of the largest gap, or of the least overlap; None if there are no tests.

    For a shortcut's run it is the test that ended the run, if one did.
    For convex parts it is a test of the pair that collides, else of the pair that lies closest.
    """
    runs: Sequence[tuple[int | None, Trace]] = list(enumerate(trace.pairs)) or [(None, trace)]
    if trace.pairs and trace.colliding:
        runs = [run for run in runs if run[1] is trace.colliding]
    pair, run = min(runs, key=lambda r: max((t.gap for t in r[1].tests), default=0.0))
    if not run.tests:
        return None
    best = (run.ended_by if run.shortcut else None) or max(run.tests, key=lambda t: t.gap)
    return ShownTest(pair, run.tests.index(best))


def drag_picture(
    trace: Trace,
    layout: Layout,
    shown: ShownTest | None,
    *,
    show_mtv: bool = False,
    last_out: Vec | None = None,
    memory: LabelMemory | None = None,
) -> tuple[Picture, AxisPlace | None]:
    """Return the picture of one finished test on fixed limits, and the place of its axis (None without a test).

    `show_mtv` adds the MTV.  `last_out`: the direction from the shapes to the axis in the picture before; the axis
    stays on that side.  `memory`: how the labels stood in the picture before, so that no label jumps.
    """
    run = trace if shown is None or shown.pair is None else trace.pairs[shown.pair]
    place = None
    sketch = Sketch(run, layout)
    sketch.digits = drag_digits(layout)
    if trace.pairs and run is trace:
        draw_parts(sketch)
    else:
        sketch.shapes()
        sketch.corners({test.source.shape for test in trace.tests})
    if run is not trace:
        draw_other_parts(sketch, trace, run)
    if shown is not None:
        test = run.tests[shown.test]
        place = place_axis_within(layout, (trace.a, trace.b), test, last_out)
        sketch.edge(test)
        sketch.normal(test)
        sketch.project(test, place, numbers=False)  # they stand on the number line
    sketch.note("verdict", str(trace.relation), "ink", weight="title", first=1)
    if show_mtv and run is trace:
        draw_mtv_of_overlap(sketch)
    return sketch.finish("", drag_sentence(trace, layout, shown), steady=False, memory=memory), place


def drag_sentence(trace: Trace, layout: Layout, shown: ShownTest | None) -> str:
    """Return the sentence beside a drag: the relation and, if the shapes are apart, the gap on the shown axis.

    Its numbers are those of the picture, the number line and the table.
    """
    digits = drag_digits(layout)
    verdict = describe.verdict_sentence(trace, trace.known_mtv, digits)
    if shown is None or (trace.claim if trace.shortcut else trace.relation) is not Relation.APART:
        return verdict
    run = trace if shown.pair is None else trace.pairs[shown.pair]
    test, who = run.tests[shown.test], " and ".join(run.names)
    axis = f"axis {shown.test + 1} ({describe.axis_name(test.axis, (run.a, run.b), run.names)})"
    if trace.shortcut:
        if trace.pairs or test == trace.ended_by:
            return verdict
        found = describe.outcome(test, digits(run, test))
        return f"{describe.shortcut_verdict(trace, digits, name_axis=False)} A{axis[1:]}: {found}."
    if test.separates:
        leaves = f"{axis} leaves a gap of {digits(run, test).gap(test.gap)}"
        return f"{verdict} Between {who} {leaves}." if trace.pairs else f"{who} are apart: {leaves}."
    found = describe.outcome(test, digits(run, test))
    if trace.pairs:
        return f"{verdict} Between {who} {axis} shows none: {found}."
    return f"{who} are apart. A{axis[1:]} does not show it: {found}."


class FreeSketch(Sketch):
    """A sketch of one axis that the reader turns: it is called by its angle, and has no number."""

    degree = 0.0

    def axis_label(self, test: AxisTest) -> str:
        """Return the angle of the axis."""
        return degree_text(self.degree)


def degree_text(degree: float) -> str:
    """Return an angle in degrees as text."""
    return f"{number_format.number(round(degree, 1))}\u00b0"


def free_axis_picture(
    trace: Trace,
    layout: Layout,
    degree: float,
    *,
    last_out: Vec | None = None,
    memory: LabelMemory | None = None,
) -> tuple[Picture, AxisPlace]:
    """Return the picture of a free axis at an angle in degrees, and the place of the axis.

    `trace` has that one direction as its choice of axes.  `last_out`: the direction from the shapes to the axis in the
    picture before; `memory`: how the labels stood there.
    """
    sketch = FreeSketch(trace, layout)
    sketch.digits = drag_digits(layout)
    sketch.degree = degree
    sketch.shapes()
    sketch.corners()
    test = trace.tests[0]
    place = place_axis_within(layout, (trace.a, trace.b), test, last_out)
    sketch.project(test, place, numbers=False)
    handle = knob_position(layout, place, degree)
    sketch.add("knob", "disc", "ink", handle, radius=layout.units(KNOB_RADIUS_PT))  # so that no label covers it
    says = "this axis separates them" if test.separates else "this axis shows no gap"
    sketch.note("verdict", f"{trace.relation}: {says}", "ink", weight="title", first=1)
    verdict = f"{' and '.join(trace.names)} {describe.RELATION_PHRASES[trace.relation]}."
    found = describe.outcome(test, sketch.digits(trace, test))
    sentence = f"{verdict} The axis at {number_format.number(round(degree, 1))} degrees: {found}; {says}."
    return sketch.finish("", sentence, steady=False, memory=memory), place


def knob_position(layout: Layout, place: AxisPlace, degree: float) -> Vec:
    """Return the point (scene units) of a free axis's handle: the end that points along `degree`, inside the canvas."""
    x0, y0, x1, y1 = layout.limits
    rim = layout.units(KNOB_RIM_PT)
    n = unit_vector(degree)
    along = place.n.x * n.x + place.n.y * n.y
    tip = place.at(place.hi if along > 0 else place.lo)
    return Vec(min(max(tip.x, x0 + rim), x1 - rim), min(max(tip.y, y0 + rim), y1 - rim))
