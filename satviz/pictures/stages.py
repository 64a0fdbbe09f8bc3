"""The steps of a drawn trace: how far a test is drawn in each, and the sentence of each.

A trace is drawn as a row of steps: the bare scene, then each test in up to seven stages, at last the verdict.
"""

from collections.abc import Sequence
from enum import StrEnum
from typing import NamedTuple, SupportsIndex

from ..engine import describe
from ..engine.axes import ANY, CENTROIDS, FROM_EDGES, GIVEN, WORLD
from ..engine.geometry import InvalidScene
from ..engine.trace import Trace
from ..scenes.resolve import EXPECT_RUN, SceneLike, resolve


class Stage(StrEnum):
    """How far a test has been drawn, or what a step without a test shows."""

    SCENE = "scene"
    PARTS = "parts"
    EDGE = "edge"
    NORMAL = "normal"
    AXIS = "axis"
    DROPS = "drops"
    RANGE = "range"
    BOTH = "both ranges"
    GAP = "gap"
    VERDICT = "verdict"


TEST_STAGES = (Stage.EDGE, Stage.NORMAL, Stage.AXIS, Stage.DROPS, Stage.RANGE, Stage.BOTH, Stage.GAP)
STAGES_BEFORE_AXIS = Stage.SCENE, Stage.PARTS, Stage.EDGE, Stage.NORMAL


class Step(NamedTuple):
    """One stage of one test: the test's index in its run, and the run's index in `trace.pairs`, both from 0.

    `test` is None for a step without a test, and `pair` where the shapes are tested without convex parts.
    """

    stage: Stage
    test: int | None = None
    pair: int | None = None


def steps(what: SceneLike) -> list[Step]:
    """Return every step of a trace (or of a scene's trace) in drawing order, from the bare scene to the verdict."""
    return steps_of(resolve(what, expected=EXPECT_RUN).trace)


def steps_of(trace: Trace) -> list[Step]:
    """Return every step of a trace in drawing order."""
    found = [Step(Stage.SCENE)]
    if trace.pairs:
        found.append(Step(Stage.PARTS))
        for p, pair in enumerate(trace.pairs):
            found += [Step(stage, t, p) for t in range(len(pair.tests)) for stage in _stages_of_test(pair, t)]
    else:
        found += [Step(stage, t) for t in range(len(trace.tests)) for stage in _stages_of_test(trace, t)]
    return [*found, Step(Stage.VERDICT)]


def step_range(trace: Trace, given: tuple[int, int] | None) -> tuple[int, int]:
    """Return `given`, the numbers of a first and a last step, with negative ones counted from the end.

    Both are inclusive and count from 0; None means all steps.  InvalidScene if the run has no such last step.
    """
    count = len(steps_of(trace))
    first, last = (step % count if step < 0 else step for step in given or (0, -1))
    if last >= count:
        raise InvalidScene(f"the run has no step {last}: its steps are 0 to {count - 1}")
    return first, last


def _stages_of_test(trace: Trace, test: int) -> Sequence[Stage]:
    """Return the stages of a test; one whose axis comes from no edge begins with the axis."""
    return TEST_STAGES[2:] if trace.tests[test].source.kind in (WORLD, GIVEN, ANY, CENTROIDS) else TEST_STAGES


def resolve_step(trace: Trace, step: int | Step) -> Step:
    """Return a step of the trace, given as a Step or as its number in `steps(trace)` (negative: from the end).

    IndexError for a step that the trace does not have.
    """
    every = steps_of(trace)
    if not isinstance(step, Step):
        if not isinstance(step, SupportsIndex):
            raise TypeError(f"step is {step!r}: pass a number or a Step")
        if not -len(every) <= step < len(every):
            raise IndexError(f"step is {step}, but this trace has the steps 0 to {len(every) - 1}: pass one of these")
        step = every[step]
    elif step not in every:
        raise IndexError(f"step is {step}, which this trace does not have: take one of sv.steps(trace)")
    return step


def first_dropped_role(trace: Trace, test: int) -> str:
    """Return the role ("A" or "B") whose points are projected first: the owner of the axis's edge, else "A"."""
    return trace.tests[test].source.shape or "A"


def step_sentence(run: Trace, step: Step) -> str:
    """Return the sentence of a step; `run`: the trace, or the pair of parts that the step belongs to."""
    stage = step.stage
    if step.test is not None:
        return describe.stage_sentence(run, step.test, stage.value, first_dropped_role(run, step.test))
    if stage is Stage.PARTS:
        return describe.parts_sentence(run)
    return describe.scene_sentence(run) if stage is Stage.SCENE else run.sentence


def step_caption(run: Trace, step: Step) -> str:
    """Return a caption of a few words for a step, as `step_sentence` says it in full."""
    stage, a_and_b = step.stage, " and ".join(run.names)
    if step.test is None:
        words = {Stage.SCENE: f"Do {a_and_b} collide?", Stage.PARTS: "Cut into convex parts"}
        found = f"Claimed: {run.claim}" if run.shortcut else f"{a_and_b} {describe.RELATION_PHRASES[run.relation]}"
        return words.get(stage, found)
    test, shapes = run.tests[step.test], (run.a, run.b)
    first = first_dropped_role(run, step.test)
    owner, other = run.names if first == "A" else run.names[::-1]
    kind, name = test.source.kind, describe.axis_name(test.axis, shapes, run.names)
    gap = describe.gap_in_words(test.gap, describe.digits(run, test))
    words = {
        Stage.EDGE: name.removeprefix("normal of ") if kind in FROM_EDGES else "The line between two points",
        Stage.NORMAL: "Its normal" if kind in FROM_EDGES else "Its direction",
        Stage.AXIS: f"Axis {step.test + 1}: {name}" if kind == WORLD else f"Axis {step.test + 1}, moved clear",
        Stage.DROPS: f"Dropping {owner} onto it",
        Stage.RANGE: f"The range of {owner}",
        Stage.BOTH: f"The range of {other}",
        Stage.GAP: f"{gap}: next axis" if step.test + 1 < len(run.tests) else gap,
    }
    return words[stage]
