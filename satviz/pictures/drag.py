"""The picture under the hand: limits that stay while a shape is dragged, and one axis of the pair's."""

from collections.abc import Sequence
from typing import NamedTuple

from ..engine import describe, number_format
from ..engine.geometry import Vec
from ..engine.trace import Trace
from .curve import unit_vector
from .labels import LabelOffsets
from .layout import AxisPlace, Group, Layout, arrange, bounding_box, place_axis_within
from .marks import Picture
from .sketch import Sketch
from .stages import draw_move, draw_other_parts, draw_parts

LARGEST = 540.0, 390.0  # points
NARROWEST = 300.0
PART = 0.6, 0.48  # of the width and height that the shapes take at first: the rest is room to move and for axes
KNOB_RADIUS_PT = 7.0  # points


class ShownTest(NamedTuple):
    """Which test is shown: of which run (None: the whole trace, else a pair's number) and its number."""

    pair: int | None
    test: int


def canvas_size(width: float | None) -> tuple[float, float]:
    """The canvas, in points, for a place that many points wide, so that letters are not shown smaller than they are."""
    wide = LARGEST[0] if width is None else min(max(width, NARROWEST), LARGEST[0])
    return wide, min(LARGEST[1], wide * 0.95)


def drag_layout(trace: Trace, largest: tuple[float, float] = LARGEST) -> Layout:
    """Limits with room to move in; ValueError for what cannot be drawn."""
    arrange([Group([trace.a, trace.b])])
    x0, y0, x1, y1 = bounding_box([trace.a, trace.b])
    scale = min(size * part / (hi - lo) for size, part, lo, hi in zip(largest, PART, (x0, y0), (x1, y1), strict=True))
    w, h = largest[0] / scale / 2, largest[1] / scale / 2
    cx, cy = (x0 + x1) / 2, (y0 + y1) / 2
    return Layout((cx - w, cy - h, cx + w, cy + h), largest, ())


def all_marks_fit(drawn: Picture) -> bool:
    """Does every mark lie inside the limits?"""
    x0, y0, x1, y1 = drawn.limits
    reach = [(p, m.radius) for m in drawn.marks for p in m.points]
    return all(x0 <= p.x - r and p.x + r <= x1 and y0 <= p.y - r and p.y + r <= y1 for p, r in reach)


def decisive_test(trace: Trace) -> ShownTest | None:
    """The test that says most: the first that separates, else the one of least overlap; None without tests."""
    runs: Sequence[tuple[int | None, Trace]] = list(enumerate(trace.pairs)) or [(None, trace)]
    if trace.pairs and trace.colliding:
        runs = [run for run in runs if run[1] is trace.colliding]
    # of pairs that are all apart the closest one
    pair, run = min(runs, key=lambda r: max((t.gap for t in r[1].tests), default=0.0))
    if not run.tests:
        return None
    best = run.ended_by or max(run.tests, key=lambda t: t.gap)
    return ShownTest(pair, run.tests.index(best))


def drag_picture(
    trace: Trace,
    layout: Layout,
    shown: ShownTest | None,
    *,
    show_mtv: bool = False,
    last_out: Vec | None = None,
    last_offsets: LabelOffsets | None = None,
) -> tuple[Picture, AxisPlace | None]:
    """The picture of one finished test on fixed limits, and where its axis was placed.

    `show_mtv` adds the MTV; `near` is the way the axis lay before, so that it stays on its side, and `last_offsets`
    how the labels last_offsets, so that they do not jump.
    """
    run = trace if shown is None or shown.pair is None else trace.pairs[shown.pair]
    place = None
    sketch = Sketch(run, layout)
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
        sketch.project(test, place)
    sketch.note("verdict", str(trace.relation), "ink", weight="title", first=1)
    if show_mtv and run is trace:
        draw_move(sketch)
    return sketch.finish("", trace.sentence, steady=False, last_offsets=last_offsets), place


def free_axis_picture(
    trace: Trace,
    layout: Layout,
    degree: float,
    *,
    last_out: Vec | None = None,
    last_offsets: LabelOffsets | None = None,
) -> tuple[Picture, AxisPlace]:
    """The same for a free axis at an angle in degrees; `trace` has that one direction as its choice."""
    sketch = Sketch(trace, layout)
    sketch.shapes()
    sketch.corners()
    test = trace.tests[0]
    place = place_axis_within(layout, (trace.a, trace.b), test, last_out)
    sketch.project(test, place)
    sketch.add(
        "knob", "disc", "ink", knob_position(layout, place, degree), radius=layout.units(KNOB_RADIUS_PT)
    )  # no label lies on it
    says = "this axis separates them" if test.separates else "this axis shows no gap"
    sketch.note("verdict", f"{trace.relation}: {says}", "ink", weight="title", first=1)
    verdict = f"{' and '.join(trace.names)} {describe.ARE[trace.relation]}."
    found = describe.outcome(test, describe.digits(trace, test))
    sentence = f"{verdict} The axis at {number_format.number(round(degree, 1))} degrees: {found}; {says}."
    return sketch.finish("", sentence, steady=False, last_offsets=last_offsets), place


def knob_position(layout: Layout, place: AxisPlace, degree: float) -> Vec:
    """Where the handle that turns a free axis sits: at its end that points along `degree`, inside the canvas."""
    x0, y0, x1, y1 = layout.limits
    rim = layout.units(16.0)
    n = unit_vector(degree)
    along = place.n.x * n.x + place.n.y * n.y
    tip = place.at(place.hi if along > 0 else place.lo)
    return Vec(min(max(tip.x, x0 + rim), x1 - rim), min(max(tip.y, y0 + rim), y1 - rim))
