"""All steps of a trace as plain data: what a player needs to show them, without a kernel."""

from itertools import accumulate
from typing import Any

from ..engine import describe, number_format
from ..engine.geometry import Relation
from ..engine.trace import Trace
from .caption import reading_time_ms
from .comparison import picture
from .layout import MAX_HEIGHT_PT, MAX_WIDTH_PT
from .marks import Mark, marks_data
from .stages import Stage, Step, steps

# the algorithm line by line, and the stages that each line is about
CODE = (
    ("for each axis to test:", (Stage.EDGE, Stage.NORMAL, Stage.AXIS)),
    ("    drop the points of both shapes onto it", (Stage.DROPS,)),
    ("    note the range of each", (Stage.RANGE, Stage.BOTH)),
    ("    if the ranges leave a gap:", (Stage.GAP,)),
    ("        stop: the shapes are apart", ()),
    ("no axis left: {end}", ()),
)
# and with concave outlines: one gap settles a pair of their parts, one hit the shapes
CODE_OF_PAIRS = (
    ("for each pair of convex parts:", (Stage.PARTS,)),
    *((f"    {line}", stages) for line, stages in CODE[:4]),
    ("            these two are apart: on to the next pair", ()),
    ("    no axis left: stop, {end}", ()),
    ("no pair left: the shapes are apart", ()),
)
PROVED, NOT_PROVED = "the shapes collide", "no gap found (no proof of a hit)"


MAX_STEPS = 600
NARROW_SIZE_PT = 340.0, 340.0  # points
NARROW_PANEL_SIZES_PT = (
    (340.0, 680.0),
    (350.0, 700.0),
)  # one above the other; the second where the first has no room for words
MOST_WIDTH, FEW_STEPS = 430.0, 150  # points, steps


def playbacks(trace: Trace) -> list[dict[str, Any]]:
    """The show of a trace and, if the early exit left something out, that of every axis."""
    return [playback(run) for run in _runs(trace)]


def _runs(trace: Trace) -> list[Trace]:
    whole = trace.without_early_exit()
    return [trace] if whole.tests == trace.tests and whole.pairs == trace.pairs else [trace, whole]


def narrow_playbacks(trace: Trace) -> list[dict[str, Any]]:
    """The same for a telephone's screen; none where it would be hardly narrower, or of very many steps."""
    sizes = NARROW_PANEL_SIZES_PT if trace.shortcut else (NARROW_SIZE_PT,)
    largest = next((size for size in sizes if picture(trace, largest=size).size[0] <= size[0]), sizes[-1])
    if picture(trace, largest=largest).size[0] > MOST_WIDTH or len(steps(trace.without_early_exit())) > FEW_STEPS:
        return []
    return [playback(run, largest) for run in _runs(trace)]


def playback(trace: Trace, largest: tuple[float, float] = (MAX_WIDTH_PT, MAX_HEIGHT_PT)) -> dict[str, Any]:
    """Marks, steps, table and pseudo-code as JSON values; equal marks are stored once.

    steps: the marks by number, the limits, the sentence and how long it takes to read, the row of the
    table (None: no test), the lines of the code; rows: those of `rows`.  ValueError for a scene that
    cannot be drawn, or that has too many tests.
    """
    every = playback_steps(trace)
    marks: dict[Mark, int] = {}
    found, begins = [], first_row_numbers(trace)
    for step in every:
        drawn = picture(trace, step, largest=largest)
        ids = [marks.setdefault(mark, len(marks)) for mark in drawn.marks]
        found.append(
            {
                "marks": ids,
                "limits": list(drawn.limits),
                "sentence": drawn.sentence,
                "ms": reading_time_ms(drawn.sentence),
                "row": None if step.test is None else begins[step.pair or 0] + step.test,
                "code": _lines(trace, step),
            }
        )
    proves = trace.choice.complete or any(pair.choice.complete for pair in trace.pairs)
    return {
        "satviz": "show 1",
        "sentence": trace.sentence,
        "relation": str(trace.relation),
        "size": list(drawn.size),
        **marks_data(marks),
        "steps": [step | {"stage": s.stage.value} for step, s in zip(found, every, strict=True)],
        "names": list(trace.names),
        "rows": table_rows(trace),
        "asks": not trace.shortcut,  # beside what a shortcut saw stands what is
        "code": [line.format(end=PROVED if proves else NOT_PROVED) for line, _ in _code(trace)],
    }


def playback_steps(trace: Trace) -> list[Step]:
    """The steps of a playback: of very many tests only the last stage of each; ValueError for too many tests."""
    every = steps(trace)
    if len(every) > MAX_STEPS:
        every = [step for step in every if step.test is None or step.stage is Stage.GAP]
    if len(every) > MAX_STEPS:
        raise ValueError(f"{len(every)} tests are too many to step through: at most {MAX_STEPS}")
    return every


def table_rows(trace: Trace) -> list[dict[str, Any]]:
    """The table's rows: each test, then the axes left out, of each pair of parts in turn."""
    found = []
    for pair in trace.pairs or (trace,):
        shapes = pair.a, pair.b
        of = f"{pair.names.a} and {pair.names.b}" if trace.pairs else ""
        for i, t in enumerate(pair.tests, 1):
            row = {"pair": of, "number": i, "axis": describe.axis_name(t.axis, shapes, pair.names), "gap": t.gap}
            told = describe.digits(pair, t)
            row |= {"direction": number_format.vector(t.axis.direction), "outcome": describe.outcome(t, told)}
            row |= dict(zip("ab", told.ranges(t), strict=True))
            found.append(row)
        found += [{"pair": of, "axis": name, "reason": why} for _, name, why in describe.untested(pair)]
    return found


def first_row_numbers(trace: Trace) -> list[int]:
    """The number of the first row of each pair of parts; of a plain pair, 0."""
    return [*accumulate((len(run.tests) + len(describe.untested(run)) for run in trace.pairs), initial=0)]


def _code(trace: Trace) -> tuple[tuple[str, tuple[Stage, ...]], ...]:
    return CODE_OF_PAIRS if trace.pairs else CODE


def _lines(trace: Trace, step: Step) -> list[int]:
    """The numbers of the code's lines that a step is about."""
    gap, apart, hit = (5, 7, 6) if trace.pairs else (4, 4, 5)
    if step.stage is Stage.VERDICT:
        return [apart] if trace.claim is Relation.APART else [hit]
    lines = [i for i, (_, stages) in enumerate(_code(trace)) if step.stage in stages]
    if step.stage is Stage.GAP and step.test is not None:
        run = trace if step.pair is None else trace.pairs[step.pair]
        lines += [gap] if run.tests[step.test].separates else []
    return lines
