"""A shortcut's claim beside the truth: two panels in one picture, on one scale."""

import re
from collections.abc import Sequence
from functools import lru_cache
from itertools import combinations, pairwise
from math import hypot
from typing import NamedTuple

from ..engine.geometry import Vec
from ..engine.trace import Trace
from ..scenes.failing import FailureCase, case_of
from ..scenes.failing.failure_case import Panels
from ..scenes.resolve import EXPECT_RUN, SceneLike, resolve
from ..scenes.shape_tools import box
from . import step_picture
from .axis_place import AxisPlace
from .claims import answers, heading, verdict_words
from .comparison_panels import PANELS, PIECES
from .default_panels import Panel, PanelSketch, claimed_tests, drawable_test, is_measured_correctly
from .draw_steps import draw_other_parts, draw_test
from .float_geometry import bounding_box, crossing_point, mean_point
from .insets import add_insets
from .label_placer import LabelRequest
from .labels import with_labels
from .layout import Layout, PanelContents, arrange_readable, place_axis_within
from .letters import text_size, wrap_text
from .marks import Mark, Picture
from .panels import marks_moved_to
from .sketch import RING_PT, Sketch
from .stages import STAGES_BEFORE_AXIS, Stage, Step, resolve_step, step_caption, step_sentence
from .step_picture import LARGEST_PT

CLAIMED, ACTUAL = "what the shortcut saw", "what is true"
# a stage, and the later one whose labels leave space for what comes next, so that nothing jumps
FULLER = step_picture.FULLER | {Stage.NORMAL: Stage.AXIS}
# in points
MAX_PANEL = 340.0, 300.0
# space between the panels, for each panel's heading, and around the words above them
BETWEEN, HEAD, RIM = 20.0, 24.0, 16.0
BOTH_PANELS_WIDTH_PT = 2 * MAX_PANEL[0] + BETWEEN
MIN_PANEL = 170.0  # a smaller panel has no space for its words
AXES_RIM = 0.2  # space on all sides for the axes of the steps, as a factor of the shapes' size
TALL = 1.5  # a canvas that is this many times as tall as wide has the panels one above the other


def picture(
    what: SceneLike,
    step: int | Step = -1,
    *,
    title: str = "",
    largest: tuple[float, float] = LARGEST_PT,
    by_itself: bool = False,
) -> Picture:
    """Return the picture of one step: a Step, or its number in `steps(trace)` (negative: from the end).

    `what` is a trace, or a scene (or its name).  A shortcut's trace gives two panels: the step as the shortcut
    takes it, and the truth.  A failing scene whose outlines are refused has one picture, with the reason.
    `largest`: the canvas in points at most; on one much taller than wide the panels stand one above the other.
    All steps have one frame: no shape moves between them; `by_itself` cuts it to what this step shows (never of two
    panels).  IndexError for a step the trace does not have.
    """
    found = resolve(what, expected=EXPECT_RUN)
    if found.refused:
        width = BOTH_PANELS_WIDTH_PT if largest == LARGEST_PT else min(BOTH_PANELS_WIDTH_PT, largest[0])
        return refused_picture(found.refused, title=title, width=width)
    trace = found.trace
    if not trace.shortcut:
        return step_picture.picture(trace, step, title=title, largest=largest, by_itself=by_itself)
    step = resolve_step(trace, step)
    panel, stacked = _panel_size(largest)
    pair = _claimed_step(trace, step, panel), _actual_panel(trace, panel)
    drawn = _join(trace, *pair, _space_for_all_steps(trace, panel), title, stacked=stacked)
    return drawn._replace(caption=step_caption(trace if step.pair is None else trace.pairs[step.pair], step))


def _panel_size(largest: tuple[float, float]) -> tuple[tuple[float, float], bool]:
    """Return ((largest width, largest height) of a panel, whether the panels stand one above the other).

    On a canvas that is too small for both, the panels keep their least size, and the whole picture is shown smaller.
    """
    if largest == LARGEST_PT:
        return MAX_PANEL, False
    width, height = largest
    if stacked := height > TALL * width:
        height = (height - 5 * HEAD) / 2
    else:
        width, height = (width - BETWEEN) / 2, height - 4 * HEAD
    return (max(width, MIN_PANEL), max(height, MIN_PANEL)), stacked


class _Frame(NamedTuple):
    """The layouts of one frame: of each test by its number among all tests, and of both panels."""

    tests: tuple[Layout, ...]
    claimed: Layout
    actual: Layout


@lru_cache(maxsize=64)
def _frame(trace: Trace, largest: tuple[float, float]) -> _Frame:
    """Return the layouts of all steps and of both panels, on one frame: no shape moves between any of them.

    The last step, which is the one that is printed, decides how large the shapes are.  The axes of earlier steps are
    drawn where they fit on its frame; the frame grows only for an axis that fits nowhere.
    """
    shapes = trace.a, trace.b
    named = list(zip(trace.names, shapes, strict=True))
    tests = [drawable_test(trace, test) for run in trace.pairs or (trace,) for test in run.tests]
    x0, y0, x1, y1 = bounding_box(shapes)
    rim = max(x1 - x0, y1 - y0) * AXES_RIM if tests else 0.0
    groups = [panel.needs(trace) for panel in _panels(trace)]
    groups.append(PanelContents([box(x0 - rim, y0 - rim, x1 + rim, y1 + rim)]))
    for _ in range(2):
        found = arrange_readable(groups, shapes, largest)
        claimed, actual, *_ = add_insets(found, named)
        places = [place_axis_within(claimed, shapes, test) for test in tests]
        outside = [t for t, place in zip(tests, places, strict=True) if not _is_inside(place, claimed)]
        groups += [PanelContents(shapes, [test]) for test in outside]
    steps = zip(tests, places, strict=True)
    return _Frame(tuple(claimed._replace(tests=(t,), places=(place,)) for t, place in steps), claimed, actual)


def _is_inside(place: AxisPlace, layout: Layout) -> bool:
    """Check whether both ends of an axis lie on a layout's canvas."""
    x0, y0, x1, y1 = layout.limits
    return all(x0 <= p.x <= x1 and y0 <= p.y <= y1 for p in place.ends)


@lru_cache(maxsize=64)
def _space_for_all_steps(trace: Trace, largest: tuple[float, float]) -> tuple[float, float]:
    """Return the width and height in points of the larger panel, the same for all steps."""
    sizes = _frame(trace, largest).claimed.size, _claimed_panel(trace, largest).size, _actual_panel(trace, largest).size
    heads = (text_size(name)[0] + RIM for name in (CLAIMED, ACTUAL))
    return max(*heads, *(w for w, _ in sizes)), max(h for _, h in sizes)


# -- the two panels


@lru_cache(maxsize=64)
def _claimed_step(trace: Trace, step: Step, largest: tuple[float, float]) -> Picture:
    """Return the claimed panel at one step of the shortcut's run; at the last one it shows the answer."""
    if step.stage is Stage.VERDICT:
        return _claimed_panel(trace, largest)
    run = trace if step.pair is None else trace.pairs[step.pair]
    frame = _frame(trace, largest)
    number = sum(len(pair.tests) for pair in trace.pairs[: step.pair or 0]) + (step.test or 0)
    layout = frame.claimed if step.test is None else frame.tests[number]
    sketch = PanelSketch(run, layout)
    if step.pair is not None:
        draw_other_parts(sketch, trace, run)
    if step.test is not None:
        draw_test(sketch, step.stage, step.test, None if step.stage in STAGES_BEFORE_AXIS else layout.places[0])
    else:
        sketch.shapes()
    fuller = FULLER.get(step.stage)
    kept = _claimed_step(trace, step._replace(stage=fuller), largest).labels if fuller else ()
    return sketch.finish("", step_sentence(run, step), kept=kept)


def _panels(trace: Trace) -> tuple[Panel, Panel]:
    """Return the claimed and the actual panel of a trace: the failing case's own, or the default ones."""
    case = case_of(trace.shortcut)
    claimed, actual = case.panels if case else Panels()
    return PIECES if trace.pairs else PANELS[claimed], PANELS[actual]


@lru_cache(maxsize=64)
def _claimed_panel(trace: Trace, largest: tuple[float, float]) -> Picture:
    """Return the panel that shows where the shortcut's answer comes from, and the answer, struck out if wrong.

    `largest`: the largest (width, height) of the canvas in points.
    """
    sketch = _panels(trace)[0].draw(trace, _frame(trace, largest).claimed)
    draw_answer(sketch, trace, "claim", verdict_words(trace)[0], answers(trace).claimed)
    return strike_wrong_answers(sketch.finish("", trace.sentence, steady=False), trace)


@lru_cache(maxsize=64)
def _actual_panel(trace: Trace, largest: tuple[float, float]) -> Picture:
    """Return the panel that proves the truth, with the right answer."""
    sketch = _panels(trace)[1].draw(trace, _frame(trace, largest).actual)
    draw_answer(sketch, trace, "verdict", verdict_words(trace)[1], answers(trace).actual)
    return sketch.finish("", trace.truth.sentence, steady=False)


def draw_answer(sketch: Sketch, trace: Trace, part: str, word: str, number: str) -> None:
    """Write the verdict `word`, if it is not "", as the label `part`.

    Write `number` too if the failing case is about a quantity other than a gap, which its bar shows.
    """
    if word:
        sketch.note(part, word, "ink", weight="title", first=0)
    case = case_of(trace.shortcut)
    if case and case.quantity != "gap":
        sketch.note("number", number, "ink", first=2)


def strike_wrong_answers(drawn: Picture, trace: Trace) -> Picture:
    """Return `drawn`, a picture of the shortcut's run, with a line through each label that states a wrong answer."""
    if not answers(trace).is_wrong:
        return drawn
    claim, verdict = verdict_words(trace)
    case = case_of(trace.shortcut)
    # a gap or overlap that is as measured is true: only what was concluded from it is wrong
    axes = {str(trace.tests.index(test) + 1) for test in claimed_tests(trace) if not is_measured_correctly(trace, test)}
    wrong = {"push-name", "gap-name"} | ({"claim"} if claim != verdict else set())
    if not (case and case.claims_less):  # there both numbers are true, and only the comparison is wrong
        wrong.add("number")
    labels = (mark for mark in drawn.labels if mark.part in wrong)
    lines = [_strike(mark, drawn.scale) for mark in labels if mark.part != "gap-name" or mark.axis in axes]
    return drawn._replace(marks=(*drawn.marks, *lines))


def _strike(label: Mark, scale: float) -> Mark:
    """Return the mark that strikes out a label: a segment through each line of its text; of a gap's, only the first.

    `scale`: points in a scene unit.
    """
    (x, y), lines = label.points[0], label.text.split("\n")
    high = text_size(label.text, label.weight)[1] / len(lines) / scale
    ends: list[Vec] = []
    for i, line in enumerate(lines[:1] if label.part.endswith("gap-name") else lines):
        half, level = text_size(line, label.weight)[0] / 2 / scale, y + ((len(lines) - 1) / 2 - i) * high
        ends += [Vec(x - half, level), Vec(x + half, level)]
    return Mark(f"{label.part}-strike", "segment", "ink", tuple(ends), label.owner, label.axis, label.number)


# -- outlines that the engine refuses


def refused_picture(case: FailureCase, *, title: str = "", width: float = BOTH_PANELS_WIDTH_PT) -> Picture:
    """Return the picture of a failing case's outlines that the engine refuses, with the reason; `width` in points."""
    rings = [[Vec(*map(float, point)) for point in ring] for ring in case.raw_outlines]
    xs, ys = [p.x for ring in rings for p in ring], [p.y for ring in rings for p in ring]
    wide, high = max(xs) - min(xs), max(ys) - min(ys)
    k = min(min(480.0, width - (80.0 if high else 168.0)) / wide, 190.0 / (high or wide / 4))
    low = high * k + (80.0 if high else 100.0)
    off = Vec((width - (max(xs) - min(xs)) * k) / 2 - min(xs) * k, 40.0 - min(ys) * k)
    marks, requests = [], []
    for name, ring in zip("AB", rings, strict=True):
        spots = [Vec(off.x + p.x * k, off.y + p.y * k) for p in ring]
        marks.append(Mark("outline", "outline", name, tuple(spots), owner=name))
        inner = mean_point(spots)
        requests.append(LabelRequest("name", name, name, inner, owner=name, weight="title", inside=True))
        for i, spot in enumerate(spots):
            marks.append(Mark("vertex", "dot", name, (spot,), owner=name, number=i))
            away = Vec(spot.x - inner.x, spot.y - inner.y + 1e-3)
            label = f"{name.lower()}{i + 1}"
            requests.append(LabelRequest("vertex-name", label, name, spot, owner=name, number=i, prefer=away))
        for n, (spot, _, _) in enumerate(_crossings(spots)):
            marks.append(Mark("crossing", "disc", "wrong", (spot,), owner=name, number=n, radius=RING_PT))
        for i, spot in enumerate(spots):
            if any(_lies_on(spot, edge) for edge in pairwise([*spots, spots[0]])):
                marks.append(Mark("fold", "disc", "wrong", (spot,), owner=name, number=i, radius=RING_PT))
    if not high:  # rods on one line have one normal: beside them, with the place where all points land
        end, foot = Vec(off.x + min(xs) * k, spots[0].y), Vec(off.x + min(xs) * k - 44.0, spots[0].y)
        tip = Vec(foot.x, foot.y + 34.0)
        marks.append(Mark("drop", "segment", "guide", (end, foot)))
        marks.append(Mark("axis", "arrow", "ink", (Vec(foot.x, foot.y - 30.0), tip)))
        marks.append(Mark("landing", "dot", "wrong", (foot,)))
        requests.append(LabelRequest("axis-name", "the only normal", "ink", tip))
        requests.append(LabelRequest("landing-name", "A, B", "wrong", foot, prefer=Vec(-1.0, 0.0)))
    layout = Layout((0.0, 0.0, width, low), (width, low), ())
    drawn = with_labels(marks, requests, layout, steady=False, keep_off=())
    unchecked = case.unchecked_words.format(case.in_words(case.claimed))
    refused = f"Refused: {_with_corner_names(str(case.actual), rings)}."
    words = f"Claim: {case.claim}.", f"{refused}\nUnchecked: {unchecked}."
    return _under_heading(words, width, low, drawn, title or case.claim)


def _crossings(ring: Sequence[Vec]) -> list[tuple[Vec, int, int]]:
    """Return (point, i, j) for each crossing of two edges of a ring; edge i, from 0, begins at vertex i."""
    edges = enumerate(pairwise([*ring, ring[0]]))
    return [(spot, i, j) for (i, s), (j, t) in combinations(edges, 2) if (spot := crossing_point(s, t))]


def _lies_on(p: Vec, edge: tuple[Vec, Vec]) -> bool:
    """Check whether p lies on an edge between its ends, up to rounding."""
    q, r = edge
    to_q, to_r, length = hypot(p.x - q.x, p.y - q.y), hypot(p.x - r.x, p.y - r.y), hypot(q.x - r.x, q.y - r.y)
    return min(to_q, to_r) > 0 and to_q + to_r <= length * (1 + 1e-12)


def _with_corner_names(words: str, outlines: Sequence[Sequence[Vec]]) -> str:
    """Return the error line `words` with crossing edges named by corners ("a1a2") and "(rings)" for their point."""
    for name, ring in zip("ab", outlines, strict=False):
        for _, i, j in _crossings(ring):
            one, other = (f"{name}{k + 1}{name}{(k + 1) % len(ring) + 1}" for k in (i, j))
            words = re.sub(rf"edges {i} and {j} cross near \([^)]*\)", f"edges {one} and {other} cross (rings)", words)
    return words


# -- the parts put together


def _join(
    trace: Trace, claimed: Picture, actual: Picture, space: tuple[float, float], title: str, *, stacked: bool
) -> Picture:
    """Return one picture of both panels under the claim; `space`: each panel's (width, height), the same in all steps.

    `stacked`: the claimed panel stands above the actual one, not to its left.
    """
    wide, high = space
    cell = high + HEAD
    width, height = (wide, 2 * cell + BETWEEN) if stacked else (2 * wide + BETWEEN, cell)
    corners = Vec(0.0, height - cell), Vec(0.0, 0.0) if stacked else Vec(wide + BETWEEN, 0.0)
    marks = []
    for prefix, name, panel, at in zip(
        ("claimed", "actual"), (CLAIMED, ACTUAL), (claimed, actual), corners, strict=True
    ):
        spot = Vec(at.x + wide / 2, at.y + high + HEAD / 2)
        marks.append(Mark(f"{prefix}-heading", "label", "guide", (spot,), text=name))
        corner = Vec(at.x + (wide - panel.size[0]) / 2, at.y + high - panel.size[1])
        marks += [mark._replace(part=f"{prefix}-{mark.part}") for mark in marks_moved_to(panel, corner, "")]
    across = cell + BETWEEN / 2
    line = (
        (Vec(8.0, across), Vec(width - 8.0, across)) if stacked else (Vec(width / 2, 8.0), Vec(width / 2, cell - 4.0))
    )
    marks.append(Mark("between", "segment", "guide", line))
    return _under_heading(heading(trace), width, height, marks, title)._replace(sentence=claimed.sentence)


def _under_heading(words: tuple[str, str], width: float, low: float, below: Sequence[Mark], title: str) -> Picture:
    """Return a picture of the marks `below` (in points, `low` high) under the two lines `words`."""
    claim, wrong = words
    space = width - 2 * RIM
    if text_size(wrong)[0] > space:
        wrong = wrong.replace(" Right: ", "\nRight: ")
    lines = "\n".join(wrap_text(line, space) for line in wrong.split("\n"))
    texts = [(wrap_text(claim, space, "title"), "title"), (lines, "plain")]
    height = round(low + sum(text_size(*text)[1] + 4.0 for text in texts) + RIM)
    marks, top = [], height - RIM
    for part, (text, weight) in zip(("heading", "wrong"), texts, strict=True):
        tall = text_size(text, weight)[1]
        marks.append(Mark(part, "label", "ink", (Vec(width / 2, top - tall / 2),), text=text, weight=weight))
        top -= tall + 4.0
    limits = 0.0, 0.0, float(width), float(height)
    return Picture((*marks, *below), limits, (float(width), float(height)), title, " ".join(f"{claim} {wrong}".split()))
