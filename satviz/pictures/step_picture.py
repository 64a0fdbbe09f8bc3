"""The picture of one step of a trace, on the canvas that all steps of the trace share."""

from collections.abc import Sequence
from functools import lru_cache

from ..engine.shapes import Shape
from ..engine.trace import Trace
from .draw_steps import draw_other_parts, draw_parts, draw_test, draw_verdict
from .float_geometry import moved_shape
from .insets import add_insets
from .layout import MAX_HEIGHT_PT, MAX_WIDTH_PT, NARROW_PT, Layout, PanelContents, arrange_readable
from .marks import Mark, Picture
from .sketch import Sketch
from .stages import STAGES_BEFORE_AXIS, TEST_STAGES, Stage, Step, resolve_step, step_caption, step_sentence

LARGEST_PT = MAX_WIDTH_PT, MAX_HEIGHT_PT
FULLER = {Stage.EDGE: Stage.NORMAL} | dict.fromkeys(TEST_STAGES[2:-1], Stage.GAP)  # a stage, and one with more labels


def picture(
    trace: Trace,
    step: int | Step = -1,
    *,
    title: str = "",
    largest: tuple[float, float] = LARGEST_PT,
    by_itself: bool = False,
) -> Picture:
    """Return the picture of one step: a Step, or its number in `steps(trace)` (negative: from the end).

    `largest`: the canvas in points at most.  All steps have one frame: no shape moves between them; `by_itself`
    cuts it to what this step shows.  IndexError for a step the trace does not have.
    """
    step = resolve_step(trace, step)
    layout = step_layouts(trace, largest, by_itself)[_layout_number(trace, step)]
    return _draw_step(trace, step, layout, _labels_to_keep(trace, step, largest, by_itself), title)


def _draw_step(trace: Trace, step: Step, layout: Layout, kept: Sequence[Mark], title: str) -> Picture:
    """Return the picture of a step on its layout; `kept`: labels of another step, whose spots it reuses."""
    run = trace if step.pair is None else trace.pairs[step.pair]
    sketch = Sketch(run, layout)
    if step.pair is not None:
        draw_other_parts(sketch, trace, run)
    if step.test is not None:
        draw_test(sketch, step.stage, step.test, layout.places[0] if layout.places else None)
    elif step.stage is Stage.PARTS:
        draw_parts(sketch)
    elif step.stage is Stage.VERDICT:
        draw_verdict(sketch, layout.places)
    else:
        sketch.shapes()
    drawn = sketch.finish(title, step_sentence(run, step), steady=step.stage is not Stage.VERDICT, kept=kept)
    return drawn._replace(caption=step_caption(run, step))


@lru_cache(maxsize=64)
def step_layouts(trace: Trace, largest: tuple[float, float] = LARGEST_PT, by_themselves: bool = False) -> list[Layout]:
    """Return a layout for the shapes, one for each test with its axis, and one for the verdict; all on one scale.

    They have one frame too, unless `by_themselves`.
    """
    shapes = trace.a, trace.b
    tests = [t for pair in trace.pairs for t in pair.tests] or trace.tests
    end = [trace.separating] if trace.separating else []
    groups = [
        PanelContents(shapes),
        *(PanelContents(shapes, [t]) for t in tests),
        PanelContents(_shapes_and_moved_b(trace), end),
    ]
    named = list(zip(trace.names, shapes, strict=True))
    found = arrange_readable(groups, shapes, largest, one_frame=not by_themselves, tight=largest[0] < NARROW_PT)
    return [add_insets([each], named)[0] for each in found] if by_themselves else add_insets(found, named)


def _layout_number(trace: Trace, step: Step) -> int:
    """Return the index of a step's layout in the list from `step_layouts`; -1 for the verdict, which is the last."""
    if step.stage in STAGES_BEFORE_AXIS:
        return 0
    if step.test is None:
        return -1
    return 1 + sum(len(pair.tests) for pair in trace.pairs[: step.pair or 0]) + step.test


@lru_cache(maxsize=64)
def _labels_to_keep(trace: Trace, step: Step, largest: tuple[float, float], by_itself: bool) -> tuple[Mark, ...]:
    """Return labels of a later stage or of the bare scene; this step puts its own labels at the same spots.

    `largest`: the canvas in points at most; `by_itself`: the frame is cut to what this step shows.
    """
    if step.stage is Stage.VERDICT or step.stage is Stage.SCENE:
        return ()
    stage = FULLER.get(step.stage)
    there = step._replace(stage=stage) if stage else Step(Stage.SCENE, None, step.pair)
    layout = step_layouts(trace, largest, by_itself)[_layout_number(trace, there)]
    return _draw_step(trace, there, layout, _labels_to_keep(trace, there, largest, by_itself), "").labels


def _shapes_and_moved_b(trace: Trace) -> list[Shape]:
    """Return both shapes and, if they overlap, B translated by the MTV, as the verdict shows it."""
    move = trace.known_mtv
    return [trace.a, trace.b] if move is None else [trace.a, trace.b, moved_shape(trace.b, move)]
