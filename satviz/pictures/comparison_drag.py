"""A shortcut's run while a shape is dragged, with its error region: the moves of B for which it is wrong."""

from functools import lru_cache
from itertools import pairwise

from ..engine.geometry import Vec
from ..engine.trace import Trace
from ..scenes.error_region import error_region_in_view
from ..scenes.failing.move_space import RegionOrReason
from ..scenes.shape_tools import vertex_mean
from . import comparison_panels
from .axis_place import AxisPlace
from .claims import answers, digits_of_answers, verdict_words
from .comparison import draw_answer, strike_wrong_answers
from .default_panels import draw_push
from .drag import ShownTest, drag_digits, drag_sentence
from .label_placer import LabelMemory
from .layout import Layout, place_axis_within
from .marks import Mark, Picture
from .sketch import Sketch


def drag_view(
    trace: Trace,
    layout: Layout,
    shown: ShownTest | None,
    *,
    show_mtv: bool = False,
    show_region: bool = True,
    last_out: Vec | None = None,
    memory: LabelMemory | None = None,
) -> tuple[Picture, AxisPlace | None]:
    """Return the picture of a shortcut's run while dragging, and the place of its axis (None: no axis shown).

    The picture shows what the shortcut measured in the chosen test, its answer, its push if `show_mtv`, and its error
    region if `show_region`.  `last_out`: the direction from the shapes to the axis in the picture before; `memory`: how
    the labels stood there.
    """
    sketch, place = Sketch(trace, layout), None
    sketch.digits = drag_digits(layout)
    region = error_region_marks(trace, layout) if show_region else []
    sketch.marks += [mark for mark in region if mark.part == "reference"]  # words keep off it
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
        sketch.project(test, place, numbers=False)
    number = answers(trace, digits_of_answers(trace, sketch.digits)).claimed
    draw_answer(sketch, trace, "claim", verdict_words(trace)[0], number)
    if show_mtv and not trace.pairs:  # pieces show their pushes themselves
        draw_push(sketch)
    if region:
        text = f"dot {'on' if region[0].kind == 'segment' else 'in'} the red:\nthe shortcut is wrong"
        sketch.note("error-region-name", text, "ink", first=6)  # red words would be lost on the red
    drawn = strike_wrong_answers(
        sketch.finish("", drag_sentence(trace, layout, shown), steady=False, memory=memory), trace
    )
    return drawn._replace(marks=(*(mark for mark in region if mark.part != "reference"), *drawn.marks)), place


def error_region_marks(trace: Trace, layout: Layout) -> list[Mark]:
    """Return marks of where the shortcut is wrong, as positions of B's vertex mean, and a dot at the present one.

    The list is empty if there are none on the canvas.
    """
    mean, found = vertex_mean(trace.b), _error_region(trace, layout)
    if isinstance(found, str):
        return []
    marks = []
    for i, ring in enumerate((*found.false_hits, *found.missed_hits, *found.numbers)):
        spots = tuple(Vec(p.x + mean.x, p.y + mean.y) for p in ring)
        marks.append(Mark("error-region", "outline", "wrong", spots, number=i))
    for i, ring in enumerate(found.hits if found.touching else ()):
        spots = tuple(Vec(p.x + mean.x, p.y + mean.y) for p in (*ring, ring[0]))
        ends = tuple(end for pair in pairwise(spots) for end in pair)
        marks.append(Mark("error-region-along", "segment", "wrong", ends, number=i))
    return [*marks, Mark("reference", "dot", "ink", (mean,))] if marks else []


def describe_error_region(trace: Trace, layout: Layout) -> str:
    """Return a sentence that says what the red region shows, or why there is none."""
    found = _error_region(trace, layout)
    if isinstance(found, str):
        return f"No map of where it is wrong: {found}."
    if not error_region_marks(trace, layout):
        return "No red on the map: wherever B lies in this picture, the shortcut is right."
    where = "on the red line" if found.touching else "in the red"
    return f"The map: while the dot, the middle of B, lies {where}, the shortcut is wrong."


def _error_region(trace: Trace, layout: Layout) -> RegionOrReason:
    """Return the error region of a shortcut's run within the canvas, or the reason why there is none."""
    assert trace.shortcut
    return _cached_region(trace.a, trace.b, trace.shortcut, layout.limits)


_cached_region = lru_cache(maxsize=2)(error_region_in_view)  # needed twice a pose: for the marks and for the words
