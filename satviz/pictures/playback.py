"""All steps of a trace as plain data, which a player shows without a Python kernel."""

from collections.abc import Sequence
from itertools import accumulate
from typing import Any

from ..engine import describe, number_format, text_table
from ..engine.geometry import Relation
from ..engine.trace import Trace
from .caption import reading_time_ms
from .comparison import picture
from .layout import NARROW_SIZE_PT
from .marks import Mark, Picture, marks_data
from .moves import TURN_FRAME_MS
from .stages import Stage, Step, steps_of
from .step_picture import LARGEST_PT

# the loop as pseudo-code: each line with the stages during which it is marked
PSEUDOCODE = (
    ("for each axis to test:", (Stage.EDGE, Stage.NORMAL, Stage.AXIS)),
    ("    drop the points of both shapes onto it", (Stage.DROPS,)),
    ("    note the range of each", (Stage.RANGE, Stage.BOTH)),
    ("    if the ranges leave a gap:", (Stage.GAP,)),
    ("        stop: the shapes are apart", ()),
    ("no axis left: {end}", ()),
)
# for concave outlines: one gap settles a pair of their convex parts, one colliding pair settles the shapes
PSEUDOCODE_OF_PAIRS = (
    ("for each pair of convex parts:", (Stage.PARTS,)),
    *((f"    {line}", stages) for line, stages in PSEUDOCODE[:4]),
    ("            these two are apart: on to the next pair", ()),
    ("    no axis left: stop, {end}", ()),
    ("no pair left: the shapes are apart", ()),
)
PROVED, NOT_PROVED = "the shapes collide", "no gap found (no proof of a hit)"

MAX_STEPS = 600
# two panels, one above the other; the second size is for panels whose words need more space
NARROW_PANEL_SIZES_PT = (338.0, 680.0), (350.0, 700.0)
MAX_NARROW_WIDTH_PT = 430.0  # a narrow playback that gets wider than this is left out
MAX_NARROW_STEPS = 150  # a narrow playback of more steps is left out


def playbacks(trace: Trace) -> list[dict[str, Any]]:
    """Return the playback of a trace and, if its early exit left out axes, that of the run without early exit."""
    return [playback(run) for run in _distinct_runs(trace)]


def _distinct_runs(trace: Trace) -> list[Trace]:
    """Return the trace and its run without early exit; the trace alone if they are the same."""
    whole = trace.without_early_exit()
    return [trace] if whole.tests == trace.tests and whole.pairs == trace.pairs else [trace, whole]


def narrow_playbacks(trace: Trace) -> list[dict[str, Any]]:
    """Return the playbacks for a telephone's screen.

    The list is empty where they would be hardly narrower, or have more than 150 steps.
    """
    sizes = NARROW_PANEL_SIZES_PT if trace.shortcut else (NARROW_SIZE_PT,)
    largest = next((size for size in sizes if picture(trace, largest=size).size[0] <= size[0]), sizes[-1])
    if (
        picture(trace, largest=largest).size[0] > MAX_NARROW_WIDTH_PT
        or len(steps_of(trace.without_early_exit())) > MAX_NARROW_STEPS
    ):
        return []
    return [playback(run, largest) for run in _distinct_runs(trace)]


def playback(trace: Trace, largest: tuple[float, float] = LARGEST_PT) -> dict[str, Any]:
    """Return marks, steps, table and pseudo-code of a trace as JSON values; equal marks are stored once.

    `largest`: the width and height in points that a picture may have.
    "steps" has for each step its marks by number, the limits of the view, the sentence, the milliseconds to read it,
    its row of the table (None without a test) and its lines of the code, from 0.  "rows": those of `table_rows`.
    ValueError for a scene that cannot be drawn, or a trace of more than 600 tests.
    """
    every, begins = playback_steps(trace), first_row_numbers(trace)
    pictures = [picture(trace, step, largest=largest) for step in every]
    facts = [
        {
            "ms": reading_time_ms(drawn.sentence),
            "row": None if step.test is None else begins[step.pair or 0] + step.test,
            "code": _pseudocode_lines(trace, step),
            "stage": step.stage.value,
        }
        for drawn, step in zip(pictures, every, strict=True)
    ]
    proves = trace.choice.complete or any(pair.choice.complete for pair in trace.pairs)
    return _playback_data(trace, trace.sentence, pictures, facts) | {
        "rows": table_rows(trace),
        "asks": not trace.shortcut,  # a shortcut's pictures show the answer beside its claim
        "code": [line.format(end=PROVED if proves else NOT_PROVED) for line, _ in _pseudocode(trace)],
    }


def picture_playback(trace: Trace, pictures: Sequence[Picture], *, turns: bool) -> dict[str, Any]:
    """Return pictures of a trace's shapes as a playback, which has no table and no code.

    They show an axis that turns (`turns`), each for the same time, or else how B - A comes about, each for the time
    that its sentence takes to read.
    """
    stage = "sweep" if turns else "difference"
    times = (TURN_FRAME_MS if turns else reading_time_ms(drawn.sentence) for drawn in pictures)
    facts: list[dict[str, Any]] = [{"ms": ms, "row": None, "code": [], "stage": stage} for ms in times]
    found = _playback_data(trace, pictures[-1].sentence, pictures, facts)
    return found | {"rows": [], "asks": False, "code": []}


def _playback_data(
    trace: Trace, sentence: str, pictures: Sequence[Picture], facts: Sequence[dict[str, Any]]
) -> dict[str, Any]:
    """Return what every playback has: its pictures, each with its own `facts`, and their marks, each stored once."""
    marks: dict[Mark, int] = {}
    found = []
    for drawn, own in zip(pictures, facts, strict=True):
        ids = [marks.setdefault(mark, len(marks)) for mark in drawn.marks]
        found.append({"marks": ids, "limits": list(drawn.limits), "sentence": drawn.sentence, **own})
    return {
        "satviz": "show 1",
        "sentence": sentence,
        "relation": str(trace.relation),
        "size": list(pictures[-1].size),
        **marks_data(marks),
        "steps": found,
        "names": list(trace.names),
    }


def playback_steps(trace: Trace) -> list[Step]:
    """Return the steps of a playback: all, or of a long trace only the last stage of each test.

    ValueError where even those are more than 600.
    """
    every = steps_of(trace)
    if len(every) > MAX_STEPS:
        every = [step for step in every if step.test is None or step.stage is Stage.GAP]
    if len(every) > MAX_STEPS:
        raise ValueError(
            f"{len(every)} tests are too many to step through: the limit is {MAX_STEPS}: draw a sheet (sv.sheet)"
        )
    return every


def table_rows(trace: Trace, number_format_of: describe.NumberFormat = describe.digits) -> list[dict[str, Any]]:
    """Return the rows of the table: each test, then the axes left out; one pair of convex parts after the other."""
    found = []
    for pair in trace.pairs or (trace,):
        shapes = pair.a, pair.b
        of = f"{pair.names.a} and {pair.names.b}" if trace.pairs else ""
        for i, t in enumerate(pair.tests, 1):
            row = {"pair": of, "number": i, "axis": describe.axis_name(t.axis, shapes, pair.names), "gap": t.gap}
            digits = number_format_of(pair, t)
            row |= {"direction": number_format.vector(t.axis.direction), "outcome": describe.outcome(t, digits)}
            row |= dict(zip("ab", digits.ranges(t), strict=True))
            found.append(row)
        found += [{"pair": of, "axis": name, "reason": why} for _, name, why in text_table.untested_rows(pair)]
    return found


def first_row_numbers(trace: Trace) -> list[int]:
    """Return the index of each pair's first row in the table, then the count of all rows; [0] if there are no pairs."""
    return [*accumulate((len(run.tests) + len(text_table.untested_rows(run)) for run in trace.pairs), initial=0)]


def _pseudocode(trace: Trace) -> tuple[tuple[str, tuple[Stage, ...]], ...]:
    """Return the lines of pseudo-code for the trace, each with the stages during which it is marked."""
    return PSEUDOCODE_OF_PAIRS if trace.pairs else PSEUDOCODE


def _pseudocode_lines(trace: Trace, step: Step) -> list[int]:
    """Return the numbers of the pseudo-code's lines that are marked during a step."""
    gap, apart, hit = (5, 7, 6) if trace.pairs else (4, 4, 5)
    if step.stage is Stage.VERDICT:
        return [apart] if trace.claim is Relation.APART else [hit]
    lines = [i for i, (_, stages) in enumerate(_pseudocode(trace)) if step.stage in stages]
    if step.stage is Stage.GAP and step.test is not None:
        run = trace if step.pair is None else trace.pairs[step.pair]
        lines += [gap] if run.tests[step.test].separates else []
    return lines
