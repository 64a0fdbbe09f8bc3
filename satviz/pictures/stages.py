"""The drawing stages: a trace as a row of steps, and the picture of any of them."""

from collections.abc import Collection, Sequence
from enum import StrEnum
from functools import lru_cache
from typing import NamedTuple, SupportsIndex

from ..engine import describe
from ..engine.axes import ANY, CENTROIDS, GIVEN, WORLD
from ..engine.certificate import PartLines, SeparatingLine, SharedPoint
from ..engine.convex_parts import named_parts
from ..engine.geometry import Relation, Vec
from ..engine.shapes import Shape
from ..engine.trace import Trace, record
from ..scenes.resolve import EXPECT_RUN, SceneLike, resolve
from ..scenes.shape_tools import translated
from .insets import with_insets
from .layout import HEIGHT, WIDTH, AxisPlace, Group, Layout, arrange, moved, padded
from .marks import Mark, Picture
from .sketch import Sketch


class Stage(StrEnum):
    """How far a test has been drawn."""

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


MOST_LINES = 4  # between parts, in one picture
FEW_PARTS = 3  # more have their names in small
OF_A_TEST = (Stage.EDGE, Stage.NORMAL, Stage.AXIS, Stage.DROPS, Stage.RANGE, Stage.BOTH, Stage.GAP)


class Step(NamedTuple):
    """One drawing stage of one test; `pair` counts the part pairs of concave outlines (None for plain pairs)."""

    stage: Stage
    test: int | None = None
    pair: int | None = None


def steps(what: SceneLike) -> list[Step]:
    """Every step of a trace in drawing order, from the bare scene to the verdict; of a scene, of its trace."""
    trace = resolve(what, expected=EXPECT_RUN).trace
    found = [Step(Stage.SCENE)]
    if trace.pairs:
        found.append(Step(Stage.PARTS))
        for p, pair in enumerate(trace.pairs):
            found += [Step(stage, t, p) for t in range(len(pair.tests)) for stage in _stages(pair, t)]
    else:
        found += [Step(stage, t) for t in range(len(trace.tests)) for stage in _stages(trace, t)]
    return [*found, Step(Stage.VERDICT)]


def _stages(trace: Trace, test: int) -> Sequence[Stage]:
    """World axes and the like come from no edge."""
    return OF_A_TEST[2:] if trace.tests[test].source.kind in (WORLD, GIVEN, ANY, CENTROIDS) else OF_A_TEST


def picture(
    trace: Trace,
    step: int | Step = -1,
    *,
    title: str = "",
    largest: tuple[float, float] = (WIDTH, HEIGHT),
    by_itself: bool = False,
) -> Picture:
    """The picture of one step: its number in `steps(trace)` (negative counts from the end) or a Step.

    `largest`: the canvas in points at most.  All steps have one scale and one canvas; `by_itself` cuts it to
    what this step shows.  IndexError for a step the trace does not have.
    """
    step = chosen(trace, step)
    layout = frames(trace, largest, by_itself)[_frame(trace, step)]
    return _drawn(trace, step, layout, _kept(trace, step, largest, by_itself), title)


def _drawn(trace: Trace, step: Step, layout: Layout, kept: Sequence[Mark], title: str) -> Picture:
    """A step on its own canvas."""
    run = trace if step.pair is None else trace.pairs[step.pair]
    sketch = Sketch(run, layout)
    if step.pair is not None:
        others(sketch, trace, run)
    if step.test is not None:
        draw_test(sketch, step.stage, step.test, layout.places[0] if layout.places else None)
    elif step.stage is Stage.PARTS:
        draw_parts(sketch)
    else:
        draw_verdict(sketch, layout.places) if step.stage is Stage.VERDICT else sketch.shapes()
    return sketch.finish(title, sentence(run, step), steady=step.stage is not Stage.VERDICT, kept=kept)


BEFORE_THE_AXIS = Stage.SCENE, Stage.PARTS, Stage.EDGE, Stage.NORMAL


def chosen(trace: Trace, step: int | Step) -> Step:
    """A step by its number in `steps(trace)`, or itself; IndexError for one the trace does not have."""
    every = steps(trace)
    if not isinstance(step, Step):
        if not isinstance(step, SupportsIndex):
            raise TypeError(f"step is {step!r}: pass a number or a Step")
        if not -len(every) <= step < len(every):
            raise IndexError(f"step {step}: this trace has the steps 0 to {len(every) - 1}")
        step = every[step]
    elif step not in every:
        raise IndexError(f"{step}: this trace has no such step")
    return step


@lru_cache(maxsize=64)
def frames(trace: Trace, largest: tuple[float, float] = (WIDTH, HEIGHT), by_themselves: bool = False) -> list[Layout]:
    """A frame for the shapes, one for each test with its axis, one for the verdict; all at one scale.

    And all on one canvas, unless each is to be shown by itself.
    """
    shapes = trace.a, trace.b
    tests = [t for pair in trace.pairs for t in pair.tests] or trace.tests
    end = [trace.separating] if trace.separating else []
    groups = [Group(shapes), *(Group(shapes, [t]) for t in tests), Group(_moved_too(trace), end)]
    named = list(zip(trace.names, shapes, strict=True))
    found = [with_insets(layout, named) for layout in arrange(groups, largest=largest)]
    if by_themselves:
        return found
    size = max(layout.size[0] for layout in found), max(layout.size[1] for layout in found)
    return [padded(layout, size) for layout in found]


def _frame(trace: Trace, step: Step) -> int:
    """Which of the frames a step has."""
    if step.stage in BEFORE_THE_AXIS:
        return 0
    if step.test is None:
        return -1
    return 1 + sum(len(pair.tests) for pair in trace.pairs[: step.pair or 0]) + step.test


@lru_cache(maxsize=64)
def _kept(trace: Trace, step: Step, largest: tuple[float, float], by_itself: bool) -> tuple[Mark, ...]:
    """The labels of the step that a step leads up to: it has most to show, so that nothing jumps on the way to it."""
    fuller = {Stage.EDGE: Stage.NORMAL} | dict.fromkeys(OF_A_TEST[2:-1], Stage.GAP)
    if step.stage is Stage.VERDICT or step.stage is Stage.SCENE:
        return ()
    next_one = fuller.get(step.stage)
    there = step._replace(stage=next_one) if next_one else Step(Stage.SCENE, None, step.pair)
    layout = frames(trace, largest, by_itself)[_frame(trace, there)]
    return _drawn(trace, there, layout, _kept(trace, there, largest, by_itself), "").labels


def _moved_too(trace: Trace) -> list[Shape]:
    """The shapes, and where the verdict moves B to, which must fit too."""
    shapes: list[Shape] = [trace.a, trace.b]
    move = trace.known_mtv
    return shapes if move is None else [*shapes, translated(trace.b, move)]


def first_role(trace: Trace, test: int) -> str:
    """Whose points drop first: the axis's owner's, as the article does with B; else A's."""
    return trace.tests[test].source.shape or "A"


def draw_test(sketch: Sketch, stage: Stage, i: int, place: AxisPlace | None) -> None:
    """One test as far as the stage goes."""
    trace = sketch.trace
    test = trace.tests[i]
    done = OF_A_TEST.index(stage)
    sketch.shapes()
    if not any(test.axis.normal):
        return sketch.no_axis(test)
    sketch.edge(test, told=stage in (Stage.EDGE, Stage.NORMAL))
    if Stage.NORMAL in OF_A_TEST[: done + 1]:
        sketch.normal(test, told=stage in (Stage.NORMAL, Stage.AXIS))
    if place is None:
        return
    sketch.axis(test, place)
    one = first_role(trace, i)
    other = "B" if one == "A" else "A"
    if stage is Stage.DROPS:
        sketch.drops(test, place, one, ends_only=False, named=True)
    if stage in (Stage.RANGE, Stage.BOTH, Stage.GAP):
        for role in one if stage is Stage.RANGE else (one, other):
            sketch.drops(test, place, role, ends_only=True, named=False)
            sketch.range(test, place, role)
    if stage is Stage.GAP:
        sketch.gap(test, place, interval=not trace.shortcut)
        if trace.shortcut:
            return
        if test.separates:
            sketch.left_out()
        sketch.note("conclusion", describe.conclusion(trace, i), "ink", first=3)


def others(sketch: Sketch, whole: Trace, run: Trace) -> None:
    """The parts that this pair leaves aside, faintly."""
    for role, name, shape in zip("AB", whole.names, (whole.a, whole.b), strict=True):
        for part, part_name in named_parts(shape, name):
            if part_name not in run.names:
                sketch.shape(role, part_name, part, weight="faint", named=False)


def draw_parts(sketch: Sketch, named: Collection[str] | None = None) -> None:
    """Both shapes as their convex parts; `named`: those that get their names, by default all."""
    for role, name, shape in sketch.pair():
        parts = named_parts(shape, name)
        for part, part_name in parts:
            told = named is None or part_name in named
            sketch.shape(role, part_name, part, named=told, quiet=len(parts) > FEW_PARTS)


def draw_verdict(sketch: Sketch, places: Sequence[AxisPlace], *, told: bool = True) -> None:
    """What proves the verdict: a separating line, a shared point, the move that parts them."""
    trace = sketch.trace
    certificate = trace.certificate
    if isinstance(certificate, PartLines):
        part_lines(sketch)
    else:
        sketch.shapes()
    if told and trace.false_hit:
        sketch.note("verdict", describe.claimed(trace), "wrong", weight="title", first=1)
    elif told:
        sketch.note("verdict", str(trace.relation), "ink", weight="title", first=1)
    if isinstance(certificate, SeparatingLine):
        separating_line(sketch, certificate)
        if trace.separating:
            sketch.project(trace.separating, places[0], drops=False)
    elif isinstance(certificate, SharedPoint):
        if trace.colliding:
            for role, name, shape in Sketch(trace.colliding, sketch.layout).pair():
                if name not in trace.names:
                    sketch.shape(role, name, shape, quiet=True)
        spot = certificate.point
        sketch.add("shared", "dot", "ink", spot)
        text = f"a point in both: {describe.digits(trace).vector(spot)}" if told else "in both"
        sketch.label("shared-name", text, "ink", spot, first=4)
        draw_move(sketch)


def part_lines(sketch: Sketch) -> None:
    """The parts, and a separating line between those that lie nearest, each with the names of its pair."""
    whole = record(sketch.trace.a, sketch.trace.b)
    apart = [(pair.separating.gap, n, pair) for n, pair in enumerate(whole.pairs, 1) if pair.separating]
    nearest = sorted(apart)[:MOST_LINES]
    draw_parts(sketch, {name for *_, pair in nearest for name in pair.names})
    sketch.insets()
    for _, n, pair in nearest:
        line = pair.certificate
        assert isinstance(line, SeparatingLine)  # an axis separates the pair
        ends = sketch.line_across("part-line", line.point, _unit(line), "gap", n)
        text = " | ".join(pair.names)
        sketch.label("part-line-name", text, "gap", sketch.middle(*ends), number=n, along=ends, first=4, far=True)
    if more := len(apart) - len(nearest):
        sketch.note("more-lines", f"and {more} more lines, one for each pair of parts", "guide")


def draw_move(sketch: Sketch) -> None:
    """B where the MTV takes it, and the arrow of the move."""
    trace = sketch.trace
    move = trace.known_mtv
    if trace.relation is not Relation.OVERLAPPING or move is None:
        return
    certificate = trace.certificate
    assert isinstance(certificate, SharedPoint)  # as of all that overlap
    start = certificate.point
    draw_mtv(sketch, start, move)


def draw_mtv(sketch: Sketch, start: Vec, move: Vec) -> None:
    """The move from a point in both, and B there."""
    ghost = translated(sketch.trace.b, move)
    sketch.shape("B", f"{sketch.trace.names.b} moved", ghost, weight="faint", named=False)
    tip = moved(start, move, 1.0)
    sketch.add("mtv", "arrow", "move", start, tip, start=(start,))
    sketch.label("mtv-name", f"MTV {describe.digits(sketch.trace).vector(move)}", "move", tip, prefer=move, first=3)


def separating_line(sketch: Sketch, certificate: SeparatingLine, text: str = "separating line") -> None:
    """The certificate's line across the canvas."""
    ends = sketch.line_across("line", certificate.point, _unit(certificate), "gap")
    low, high = sorted(ends, key=lambda p: p.y)
    sketch.label("line-name", text, "gap", high, prefer=Vec(low.x - high.x, low.y - high.y), first=2, far=True)


def _unit(certificate: SeparatingLine) -> Vec:
    """The line's normal, scaled from its fractions without overflow."""
    nx, ny = certificate.normal
    size = max(abs(nx), abs(ny))
    x, y = float(nx / size), float(ny / size)
    length = (x * x + y * y) ** 0.5
    return Vec(x / length, y / length)


def sentence(trace: Trace, step: Step) -> str:
    """What a step shows, in words made from the trace."""
    stage = step.stage
    if step.test is not None:
        return describe.stage(trace, step.test, stage.value, first_role(trace, step.test))
    if stage is Stage.PARTS:
        return describe.parts(trace)
    return describe.scene(trace) if stage is Stage.SCENE else trace.sentence
