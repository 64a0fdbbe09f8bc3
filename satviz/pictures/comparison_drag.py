"""A shortcut's run under the hand, and the map of where it is wrong as B moves."""

from functools import lru_cache
from itertools import pairwise

from ..engine.geometry import Vec
from ..engine.trace import Trace
from ..scenes.failing.where import ErrorRegion, error_region_in_view
from ..scenes.shortcuts import middle
from . import comparison_panels
from .axis_place import AxisPlace
from .claims import said, verdicts
from .comparison import answer, draw_push, struck
from .drag import ShownTest
from .label_placer import LabelOffsets
from .layout import Layout, place_axis_within
from .marks import Mark, Picture
from .sketch import Sketch


def drag_view(
    trace: Trace,
    layout: Layout,
    shown: ShownTest | None,
    *,
    show_mtv: bool = False,
    last_out: Vec | None = None,
    last_offsets: LabelOffsets | None = None,
) -> tuple[Picture, AxisPlace | None]:
    """A shortcut's run under the hand: what it saw by the chosen test, its answer, and a map of where it lies."""
    sketch, place = Sketch(trace, layout), None
    where = map_of_lies(trace, layout)
    sketch.marks += [mark for mark in where if mark.part == "reference"]  # words keep off it
    test = trace.tests[shown.test] if shown and trace.tests else None
    if trace.pairs:
        comparison_panels.draw_pieces(sketch)
    else:
        sketch.shapes()
        sketch.corners({test.source.shape for test in trace.tests})
    if test is not None and not any(test.axis.normal):
        sketch.no_axis(test)
    elif test is not None:
        place = place_axis_within(layout, (trace.a, trace.b), test, last_out)
        sketch.edge(test)
        sketch.normal(test)
        sketch.project(test, place, interval=False)
    answer(sketch, trace, "claim", verdicts(trace)[0], said(trace).wrong)
    if show_mtv and not trace.pairs:  # pieces show their pushes themselves
        draw_push(sketch)
    if where:
        text = f"dot {'on' if where[0].kind == 'segment' else 'in'} the red:\nthe shortcut is wrong"
        sketch.note("lies-name", text, "ink", first=6)  # red words would be lost on the red
    drawn = struck(sketch.finish("", trace.sentence, steady=False, last_offsets=last_offsets), trace)
    return drawn._replace(marks=(*(mark for mark in where if mark.part != "reference"), *drawn.marks)), place


def map_of_lies(trace: Trace, layout: Layout) -> list[Mark]:
    """Where B's middle would have to be for the shortcut to say the wrong thing, and a dot where it is."""
    at, found = middle(trace.b), _lies(trace, layout)
    if isinstance(found, str):
        return []
    marks = []
    for i, ring in enumerate((*found.false_hits, *found.missed_hits, *found.numbers)):
        spots = tuple(Vec(p.x + at.x, p.y + at.y) for p in ring)
        marks.append(Mark("lies", "outline", "wrong", spots, number=i))
    for i, ring in enumerate(found.hits if found.touching else ()):
        spots = tuple(Vec(p.x + at.x, p.y + at.y) for p in (*ring, ring[0]))
        ends = tuple(end for pair in pairwise(spots) for end in pair)
        marks.append(Mark("lies-along", "segment", "wrong", ends, number=i))
    return [*marks, Mark("reference", "dot", "ink", (at,))] if marks else []


def about_map(trace: Trace, layout: Layout) -> str:
    """What the map of lies shows, or why there is none."""
    found = _lies(trace, layout)
    if isinstance(found, str):
        return f"No map of where it is wrong: {found}."
    if not map_of_lies(trace, layout):
        return "No red on the map: wherever B lies in this picture, the shortcut is right."
    where = "on the red line" if found.touching else "in the red"
    return f"The map: while the dot, the middle of B, lies {where}, the shortcut is wrong."


def _lies(trace: Trace, layout: Layout) -> ErrorRegion | str:
    """Those of a shortcut's run on the canvas."""
    assert trace.shortcut
    return _lies_of(trace.a, trace.b, trace.shortcut, layout.limits)


_lies_of = lru_cache(maxsize=2)(error_region_in_view)  # asked of one pose twice: for the map and for the words about it
