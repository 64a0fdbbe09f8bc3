"""Belief beside truth: what a shortcut saw, and what is, side by side in one picture on one scale."""

from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache

from ..engine import describe
from ..engine.axes import Choice, hull_normals
from ..engine.certificate import SeparatingLine, SharedPoint
from ..engine.geometry import Vec
from ..engine.sat import AxisTest, axis_tests
from ..engine.shapes import Shape, centroid
from ..engine.trace import Trace, record
from ..scenes.failing import MISSED_HIT, FailureCase
from ..scenes.resolve import RUNS, SceneLike, refused_case, trace_of
from . import comparison_panels, step_picture
from .claims import about_push, heading, is_near, row_of, said, verdicts
from .comparison_panels import Panel, arrange
from .draw_steps import draw_mtv, draw_other_parts, draw_separating_line, draw_test, draw_verdict
from .float_geometry import moved_shape, point_along
from .label_placer import LabelRequest
from .labels import with_labels
from .layout import MAX_HEIGHT_PT, MAX_WIDTH_PT, Group, Layout, centered_layout
from .letters import text_size, wrap_text
from .marks import Mark, Picture
from .panels import marks_moved_to
from .sketch import Sketch
from .stages import STAGES_BEFORE_AXIS, TEST_STAGES, Stage, Step, resolve_step, step_sentence

SAW, IS = "what the shortcut saw", "what is"
PANEL = 340.0, 300.0  # the largest, in points
FULLER = {Stage.EDGE: Stage.NORMAL, Stage.NORMAL: Stage.AXIS} | dict.fromkeys(TEST_STAGES[2:-1], Stage.GAP)
BETWEEN, HEAD, RIM = 20.0, 24.0, 16.0  # points between the panels, for each one's heading, round the words above
BOTH = 2 * PANEL[0] + BETWEEN
SMALLEST = 170.0  # points: a smaller panel has no room for its words
TALL = 1.5  # times its width from which a canvas has the panels one above the other


def picture(
    what: SceneLike,
    step: int | Step = -1,
    *,
    title: str = "",
    largest: tuple[float, float] = (MAX_WIDTH_PT, MAX_HEIGHT_PT),
    by_itself: bool = False,
) -> Picture:
    """The picture of one step: its number in `steps(trace)` (negative counts from the end) or a Step.

    Of a trace, or of a scene (or its name).  A shortcut's trace gives two panels: the step as the shortcut
    takes it, and what is.  A failing scene whose outlines are refused has one picture, with the reason.
    `largest`: the canvas in points at most; on one much taller than wide the panels stand one above the other.
    All steps have one scale and one canvas; `by_itself` cuts it to what this step shows (never of two panels).
    IndexError for a step the trace does not have.
    """
    if row := refused_case(what):
        return refused(
            row, title=title, width=min(BOTH, largest[0]) if largest != (MAX_WIDTH_PT, MAX_HEIGHT_PT) else BOTH
        )
    trace = trace_of(what, takes=RUNS)
    if not trace.shortcut:
        return step_picture.picture(trace, step, title=title, largest=largest, by_itself=by_itself)
    step = resolve_step(trace, step)
    panel, stacked = _panel(largest)
    return _put(trace, _saw(trace, step, panel), _what_is(trace, panel), _room(trace, panel), title, stacked=stacked)


def _panel(largest: tuple[float, float]) -> tuple[tuple[float, float], bool]:
    """The largest panel on a canvas, and whether the other one stands below it.

    On a canvas that has no room for both it is larger, and the whole is shown smaller.
    """
    if largest == (MAX_WIDTH_PT, MAX_HEIGHT_PT):
        return PANEL, False
    width, height = largest
    if stacked := height > TALL * width:
        height = (height - 5 * HEAD) / 2
    else:
        width, height = (width - BETWEEN) / 2, height - 4 * HEAD
    return (max(width, SMALLEST), max(height, SMALLEST)), stacked


def _own(panels: dict[str, Panel], trace: Trace) -> Panel | None:
    return panels.get(trace.shortcut.name) if trace.shortcut and row_of(trace) else None


# -- the two panels


@lru_cache(maxsize=64)
def _layouts(trace: Trace, largest: tuple[float, float]) -> tuple[Layout, Layout]:
    """Both panels' at last, on one scale: with a place for each test that the shortcut goes by; for the true one."""
    truth = true_test(trace)
    tests = [_with_room(trace, test) for test in believed_tests(trace)], [truth] if truth else []
    drawn = _drawn(trace, trace.push if about_push(trace) else None), _drawn(trace, trace.truth.known_mtv)
    found = [arrange([Group(shapes, of)], largest=largest)[0] for shapes, of in zip(drawn, tests, strict=True)]
    small, large = sorted((0, 1), key=lambda k: found[k].scale)
    found[large] = _on_scale(found[small].scale, drawn[large], tests[large], largest) or found[large]
    size = max(layout.size[0] for layout in found), max(layout.size[1] for layout in found)
    return centered_layout(found[0], size), centered_layout(found[1], size)


def _on_scale(
    scale: float, shapes: Sequence[Shape], tests: Sequence[AxisTest], largest: tuple[float, float]
) -> Layout | None:
    """The largest layout that is on no larger scale: looked for by halving, as the room for labels is in points."""
    least, most, found = 0.3, 1.0, None
    for _ in range(8):
        part = (least + most) / 2
        layout = arrange([Group(shapes, tests)], largest=(largest[0] * part, largest[1] * part))[0]
        if layout.scale > scale:
            most = part
        else:
            least, found = part, layout
    return found


@lru_cache(maxsize=256)
def _test_layout(trace: Trace, test: AxisTest, largest: tuple[float, float]) -> Layout:
    """That of the steps of one test, between which nothing jumps."""
    return arrange([Group([trace.a, trace.b], [_with_room(trace, test)])], largest=largest)[0]


def _with_room(trace: Trace, test: AxisTest) -> AxisTest:
    """The test, or for one without a direction another, in whose place words will stand."""
    return test if any(test.axis.normal) else next(t for t in trace.tests if any(t.axis.normal))


@lru_cache(maxsize=64)
def _room(trace: Trace, largest: tuple[float, float]) -> tuple[float, float]:
    """What the largest panel of all steps takes."""
    tests = [test for run in trace.pairs or (trace,) for test in run.tests]
    sizes = [_believed(trace, largest).size, _what_is(trace, largest).size]
    sizes += [_test_layout(trace, test, largest).size for test in tests]
    heads = [text_size(name)[0] + RIM for name in (SAW, IS)]
    return max(*heads, *(w for w, _ in sizes)), max(h for _, h in sizes)


def _drawn(trace: Trace, move: Vec | None) -> list[Shape]:
    """The shapes, and where B is moved to, which must fit too."""
    return [trace.a, trace.b, *([moved_shape(trace.b, move)] if move and is_near(trace, move) else [])]


@lru_cache(maxsize=64)
def _saw(trace: Trace, step: Step, largest: tuple[float, float]) -> Picture:
    """A step of the shortcut's run; at last its number, struck out where it is wrong."""
    if step.stage is Stage.VERDICT:
        return _believed(trace, largest)
    run = trace if step.pair is None else trace.pairs[step.pair]
    test = None if step.test is None else run.tests[step.test]
    layout = _test_layout(trace, test, largest) if test else _layouts(trace, largest)[0]
    sketch = Sketch(run, layout)
    if step.pair is not None:
        draw_other_parts(sketch, trace, run)
    if step.test is not None:
        draw_test(sketch, step.stage, step.test, None if step.stage in STAGES_BEFORE_AXIS else layout.places[0])
    else:
        sketch.shapes()
    fuller = FULLER.get(step.stage)  # whose labels leave room for what comes next, so that nothing jumps
    kept = _saw(trace, step._replace(stage=fuller), largest).labels if fuller else ()
    return sketch.finish("", step_sentence(run, step), kept=kept)


@lru_cache(maxsize=64)
def _believed(trace: Trace, largest: tuple[float, float]) -> Picture:
    """The tests that the shortcut goes by, what it says, and where it would push B."""
    own = comparison_panels.pieces if trace.pairs else _own(comparison_panels.SAW, trace)
    sketch = own(trace, largest) if own else _tests_believed(trace, largest)
    answer(sketch, trace, "claim", verdicts(trace)[0], said(trace).wrong)
    return struck(sketch.finish("", trace.sentence, steady=False), trace)


def answer(sketch: Sketch, trace: Trace, part: str, word: str, number: str) -> None:
    """A panel's verdict, and its number where that is more than the gap, which stands at its bar."""
    if word:
        sketch.note(part, word, "ink", weight="title", first=1)
    row = row_of(trace)
    if row and row.what != "gap":
        sketch.note("number", number, "ink", first=2)


def _tests_believed(trace: Trace, largest: tuple[float, float]) -> Sketch:
    layout, _ = _layouts(trace, largest)
    sketch = Sketch(trace, layout)
    sketch.shapes()
    told = believed_tests(trace)
    for test, place in zip(told, layout.places, strict=False):
        if any(test.axis.normal):
            if len(told) == 1:
                sketch.edge(test)
                sketch.normal(test)
            sketch.project(test, place, drops=len(told) == 1, interval=False)
        else:
            sketch.no_axis(test)
    if len(told) < len(trace.tests) and not trace.ended_by:
        sketch.note("tested", f"the least overlap of {len(trace.tests)} axes", "guide", first=7)
    draw_push(sketch)
    return sketch


def believed_tests(trace: Trace) -> list[AxisTest]:
    """The tests that the answer comes from: the one that ended the run; else all if they are two, or the least."""
    if trace.ended_by:
        return [trace.ended_by]
    return list(trace.tests) if len(trace.tests) == 2 else [trace.shallowest] if trace.shallowest else []


def draw_push(sketch: Sketch) -> None:
    """B where the shortcut would push it, if that is what it is about."""
    trace = sketch.trace
    if not about_push(trace) or not trace.push:
        return
    start = tip = centroid(trace.b)
    text = f"push {describe.digits(trace).vector(trace.push)}"
    if not is_near(trace, trace.push):
        text += ",\nout of the picture"
    elif any(trace.push):
        tip = point_along(start, trace.push, 1.0)
        sketch.shape("B", f"{trace.names.b} pushed", moved_shape(trace.b, trace.push), weight="faint", named=False)
        sketch.add("push", "arrow", "move", start, tip, start=(start,))
    prefer = trace.push if any(trace.push) else Vec(0.0, 1.0)
    sketch.label("push-name", text, "move", tip, prefer=prefer, far=not is_near(trace, trace.push), first=3)


GAPS = "gap", "depth"  # numbers that are read off the ranges


def struck(drawn: Picture, trace: Trace) -> Picture:
    """The picture with a line through every answer that is wrong."""
    found = said(trace)
    if not found.is_wrong:
        return drawn
    claim, verdict = verdicts(trace)
    told, row = believed_tests(trace), row_of(trace)
    best = max((test.gap for test in told), default=0.0)
    read = {str(trace.tests.index(test) + 1) for test in told if test.gap == best}
    wrong = {"push-name", "number"} | ({"claim"} if claim != verdict else set())
    missed = trace.missed_hit or (row is not None and row.how == MISSED_HIT)
    if not (missed and trace.proves):  # there the gap is right, and only what follows from it is wrong
        wrong |= {"gap-name"} if claim != verdict or (row and row.what in GAPS) else set()
    labels = (mark for mark in drawn.marks if mark.kind == "label" and mark.part in wrong)
    struck = [_strike(mark, drawn.scale) for mark in labels if mark.part != "gap-name" or mark.axis in read]
    return drawn._replace(marks=(*drawn.marks, *struck))


def _strike(label: Mark, scale: float) -> Mark:
    """A line through each line of a label."""
    (x, y), lines = label.points[0], label.text.split("\n")
    high = text_size(label.text, label.weight)[1] / len(lines) / scale
    ends: list[Vec] = []
    for i, line in enumerate(lines):
        half, level = text_size(line, label.weight)[0] / 2 / scale, y + ((len(lines) - 1) / 2 - i) * high
        ends += [Vec(x - half, level), Vec(x + half, level)]
    return Mark(f"{label.part}-strike", "segment", "ink", tuple(ends), label.owner, label.axis, label.number)


def true_test(trace: Trace) -> AxisTest | None:
    """What to show of the truth: the axis that separates best, or the shortcut's own axis with its true ranges."""
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
    """The exact run; of concave outlines that over their hulls where a line separates them."""
    truth = trace.truth
    if not truth.pairs:
        return truth
    hull = record(trace.a, trace.b, axes=hull_normals, every_axis=True)
    return hull if hull.separating else truth


@lru_cache(maxsize=64)
def _what_is(trace: Trace, largest: tuple[float, float]) -> Picture:
    """What proves the truth: the separating axis and line, or the contact, the true ranges and the way out."""
    own = _own(comparison_panels.IS, trace)
    sketch = own(trace, largest) if own else _proof(trace, largest)
    answer(sketch, trace, "verdict", verdicts(trace)[1], said(trace).right)
    return sketch.finish("", trace.truth.sentence, steady=False)


def _proof(trace: Trace, largest: tuple[float, float]) -> Sketch:
    _, layout = _layouts(trace, largest)
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


# -- refused at the door


def refused(row: FailureCase, *, title: str = "", width: float = BOTH) -> Picture:
    """The outlines of a row that the engine refuses, and the reason; `width` in points."""
    rings = [[Vec(*map(float, point)) for point in ring] for ring in (row.a, row.b) if not isinstance(ring, Shape)]
    xs, ys = [p.x for ring in rings for p in ring], [p.y for ring in rings for p in ring]
    k = min(260.0, width - 80.0) / max(max(xs) - min(xs), max(ys) - min(ys))
    low = (max(ys) - min(ys)) * k + 80.0
    off = Vec((width - (max(xs) - min(xs)) * k) / 2 - min(xs) * k, 40.0 - min(ys) * k)
    marks, requests = [], []
    for name, ring in zip("AB", rings, strict=True):
        spots = [Vec(off.x + p.x * k, off.y + p.y * k) for p in ring]
        marks.append(Mark("outline", "outline", name, tuple(spots), owner=name))
        inner = Vec(sum(p.x for p in spots) / len(spots), sum(p.y for p in spots) / len(spots))
        requests.append(LabelRequest("name", name, name, inner, owner=name, weight="title", inside=True))
        for i, spot in enumerate(spots):
            marks.append(Mark("vertex", "dot", name, (spot,), owner=name, number=i))
            away = Vec(spot.x - inner.x, spot.y - inner.y + 1e-3)
            label = f"{name.lower()}{i + 1}"
            requests.append(LabelRequest("vertex-name", label, name, spot, owner=name, number=i, prefer=away))
    layout = Layout((0.0, 0.0, width, low), (width, low), ())
    drawn = with_labels(marks, requests, layout, steady=False, keep_off=())
    return _under(f"Claim: {row.claim}.", f"Refused: {row.truth}.", width, low, drawn, title or row.claim)


# -- put together


def _put(
    trace: Trace, saw: Picture, truth: Picture, room: tuple[float, float], title: str, *, stacked: bool
) -> Picture:
    """Both panels under the claim, in points, each with that room: all steps are as large.

    `stacked`: the shortcut's above the true one.
    """
    wide, high = room
    cell = high + HEAD
    width, height = (wide, 2 * cell + BETWEEN) if stacked else (2 * wide + BETWEEN, cell)
    there = Vec(0.0, 0.0) if stacked else Vec(wide + BETWEEN, 0.0)
    marks = []
    for prefix, name, panel, at in ("saw", SAW, saw, Vec(0.0, height - cell)), ("is", IS, truth, there):
        spot = Vec(at.x + wide / 2, at.y + high + HEAD / 2)
        marks.append(Mark(f"{prefix}-heading", "label", "guide", (spot,), text=name))
        corner = Vec(at.x + (wide - panel.size[0]) / 2, at.y + high - panel.size[1])
        marks += [mark._replace(part=f"{prefix}-{mark.part}") for mark in marks_moved_to(panel, corner, "")]
    across = cell + BETWEEN / 2
    line = (
        (Vec(8.0, across), Vec(width - 8.0, across)) if stacked else (Vec(width / 2, 8.0), Vec(width / 2, cell - 4.0))
    )
    marks.append(Mark("between", "segment", "guide", line))
    return _under(*heading(trace), width, height, marks, title)._replace(sentence=saw.sentence)


def _under(claim: str, wrong: str, width: float, low: float, below: Sequence[Mark], title: str) -> Picture:
    """Marks, in points, under the claim and what is wrong with it."""
    room = width - 2 * RIM
    if text_size(wrong)[0] > room:
        wrong = wrong.replace(" Right: ", "\nRight: ")
    lines = "\n".join(wrap_text(line, room) for line in wrong.split("\n"))
    texts = [(wrap_text(claim, room, "title"), "title"), (lines, "plain")]
    height = round(low + sum(text_size(*text)[1] + 4.0 for text in texts) + RIM)
    marks, top = [], height - RIM
    for part, (text, weight) in zip(("heading", "wrong"), texts, strict=True):
        tall = text_size(text, weight)[1]
        marks.append(Mark(part, "label", "ink", (Vec(width / 2, top - tall / 2),), text=text, weight=weight))
        top -= tall + 4.0
    limits = 0.0, 0.0, float(width), float(height)
    return Picture((*marks, *below), limits, (float(width), float(height)), title, " ".join(f"{claim} {wrong}".split()))
