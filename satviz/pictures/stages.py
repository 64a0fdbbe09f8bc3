"""The drawing stages: a trace as a row of steps, and the picture of any of them."""

from collections.abc import Sequence
from enum import StrEnum
from functools import lru_cache
from typing import Any, NamedTuple, SupportsIndex

from ..engine import telling
from ..engine.axes import ANY, CENTROIDS, GIVEN, WORLD
from ..engine.certificate import SeparatingLine, SharedPoint
from ..engine.concave import named_parts
from ..engine.geometry import Relation, Vec
from ..engine.shapes import Circle, Shape
from ..engine.trace import Trace
from .layout import HEIGHT, WIDTH, AxisPlace, Layout, arrange, moved
from .marks import Picture
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


OF_A_TEST = (Stage.EDGE, Stage.NORMAL, Stage.AXIS, Stage.DROPS, Stage.RANGE, Stage.BOTH, Stage.GAP)


class Step(NamedTuple):
    """One drawing stage of one test; `pair` counts the part pairs of concave outlines (None for plain pairs)."""

    stage: Stage
    test: int | None = None
    pair: int | None = None


def checked(trace: Any) -> Trace:
    """The trace itself; TypeError says how to make one of anything else."""
    if isinstance(trace, Trace):
        return trace
    raise TypeError(
        f"this is a {type(trace).__name__}: pass the trace of two shapes, sv.record(a, b), or scene.record()"
    )


def steps(trace: Trace) -> list[Step]:
    """Every step of a trace in drawing order, from the bare scene to the verdict; TypeError for what is no trace."""
    checked(trace)
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
    trace: Trace, step: int | Step = -1, *, title: str = "", largest: tuple[float, float] = (WIDTH, HEIGHT)
) -> Picture:
    """The picture of one step: its number in `steps(trace)` (negative counts from the end) or a Step.

    `largest`: the canvas in points at most.  IndexError for a step the trace does not have.
    """
    step = chosen(trace, step)
    layout = scene_layout(trace, largest)
    run = trace if step.pair is None else trace.pairs[step.pair]
    sketch = Sketch(run, layout)
    if step.pair is not None:
        others(sketch, trace, run)
    if step.test is not None:
        before = sum(len(pair.tests) for pair in trace.pairs[: step.pair or 0])
        draw_test(sketch, step.stage, step.test, layout.places[before + step.test])
    elif step.stage is Stage.PARTS:
        draw_parts(sketch)
    else:
        # seams and part names belong to what proves concave outlines apart
        draw_parts(sketch) if step.stage is Stage.VERDICT and trace.pairs else sketch.shapes()
        if step.stage is Stage.VERDICT:
            draw_verdict(sketch, layout.places)
    return sketch.finish(title, sentence(run, step), steady=step.stage is not Stage.VERDICT)


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
def scene_layout(trace: Trace, largest: tuple[float, float] = (WIDTH, HEIGHT)) -> Layout:
    """One layout for all steps, so that nothing jumps between them."""
    tests = [t for pair in trace.pairs for t in pair.tests] or trace.tests
    return arrange(_drawn(trace), tests, largest=largest)


def _drawn(trace: Trace) -> list[Shape]:
    """The shapes, and where the verdict moves B to, which must fit too."""
    shapes: list[Shape] = [trace.a, trace.b]
    move = trace.known_mtv
    return shapes if move is None else [*shapes, shifted(trace.b, move)]


def shifted(shape: Shape, move: Vec) -> Shape:
    """The shape moved, rounded: for drawing only."""
    if isinstance(shape, Circle):
        return Circle(moved(shape.center, move, 1.0), shape.radius)
    return type(shape)([moved(v, move, 1.0) for v in shape.vertices], shape.labels)


def first_role(trace: Trace, test: int) -> str:
    """Whose points drop first: the axis's owner's, as the article does with B; else A's."""
    return trace.tests[test].source.shape or "A"


def draw_test(sketch: Sketch, stage: Stage, i: int, place: AxisPlace) -> None:
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
    if Stage.AXIS in OF_A_TEST[: done + 1]:
        sketch.axis(test, place)
    one = first_role(trace, i)
    other = "B" if one == "A" else "A"
    if stage is Stage.DROPS:
        sketch.drops(test, place, one, ends_only=False, told=True)
    if stage in (Stage.RANGE, Stage.BOTH, Stage.GAP):
        for role in one if stage is Stage.RANGE else (one, other):
            sketch.drops(test, place, role, ends_only=True, told=False)
            sketch.range(test, place, role)
    if stage is Stage.GAP:
        sketch.gap(test, place)
        if test.separates:
            sketch.left_out()


def others(sketch: Sketch, whole: Trace, run: Trace) -> None:
    """The parts that this pair leaves aside, faintly."""
    for role, name, shape in zip("AB", whole.names, (whole.a, whole.b), strict=True):
        for part, part_name in named_parts(shape, name):
            if part_name not in run.names:
                sketch.shape(role, part_name, part, weight="faint", named=False)


def draw_parts(sketch: Sketch) -> None:
    """Both shapes as their convex parts."""
    for role, name, shape in sketch.pair():
        for part, part_name in named_parts(shape, name):
            sketch.shape(role, part_name, part)


FALSE_HIT = "a false hit: the axes tested show no gap"


def draw_verdict(sketch: Sketch, places: Sequence[AxisPlace], *, told: bool = True) -> None:
    """What proves the verdict: a separating line, a shared point, the move that parts them."""
    trace = sketch.trace
    if told:
        sketch.note("verdict", str(trace.relation), "ink", weight="title", first=1)
    if trace.false_hit:
        sketch.note("false-hit", FALSE_HIT, "overlap", first=2)
    certificate = trace.certificate
    if isinstance(certificate, SeparatingLine):
        separating_line(sketch, certificate)
        if trace.separating:
            i = trace.tests.index(trace.separating)
            sketch.project(trace.separating, places[i], drops=False)
    elif isinstance(certificate, SharedPoint):
        spot = certificate.point
        sketch.add("shared", "dot", "ink", spot)
        sketch.label("shared-name", f"a point in both: {telling.vector(spot)}", "ink", spot, first=4)
        draw_move(sketch)
    else:
        (_, a, whole_a), (_, b, whole_b) = sketch.pair()
        names = [f"{p} | {q}" for _, p in named_parts(whole_a, a) for _, q in named_parts(whole_b, b)]
        for n, (text, line) in enumerate(zip(names, certificate.lines, strict=True), 1):
            ends = sketch.line_across("part-line", line.point, _unit(line), "gap", n)
            sketch.label("part-line-name", text, "gap", sketch.middle(*ends), number=n, along=ends, first=4, far=True)


def draw_move(sketch: Sketch) -> None:
    """B where the MTV takes it, and the arrow of the move."""
    trace = sketch.trace
    move = trace.known_mtv
    if trace.relation is not Relation.OVERLAPPING or move is None:
        return
    certificate = trace.certificate
    assert isinstance(certificate, SharedPoint)  # as of all that overlap
    draw_mtv(sketch, certificate.point, move)


def draw_mtv(sketch: Sketch, start: Vec, move: Vec) -> None:
    """The move from a point in both, and B there."""
    ghost = shifted(sketch.trace.b, move)
    sketch.shape("B", f"{sketch.trace.names.b} moved", ghost, weight="faint", named=False)
    tip = moved(start, move, 1.0)
    sketch.add("mtv", "arrow", "overlap", start, tip, weight="strong", start=(start,))
    sketch.label("mtv-name", f"MTV {telling.vector(move)}", "overlap", tip, prefer=move, first=3)


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
        return telling.stage(trace, step.test, stage.value, first_role(trace, step.test))
    if stage is Stage.PARTS:
        return telling.parts(trace)
    return telling.scene(trace) if stage is Stage.SCENE else trace.sentence
