"""The contact sheet: one picture of a whole run, a row for each axis, all ranges on one scale."""

from collections.abc import Sequence
from math import cos, hypot, pi, sin
from typing import NamedTuple

from ..engine import describe
from ..engine.geometry import Vec
from ..engine.sat import AxisTest
from ..engine.shapes import Circle, Shape
from ..engine.trace import Trace
from ..scenes.resolve import SceneLike, resolve
from .caption import wrapped
from .layout import box_of, text_box
from .marks import Mark, Picture

MOST_ROWS = 12
# all in points
WIDTH, ROW, HEAD, MARGIN = 500.0, 58.0, 30.0, 12.0
SMALL = 74.0, 48.0  # a row's small picture
BARS = 100.0, 376.0  # from where to where the ranges reach, less far where the words beside them are long
SPECK = 3.0  # a shorter range is a dot
TRACK = 5.0
FAR_ZERO = 4.0  # where 0 lies further off than so many times what the ranges take, each row has its own scale


class Row(NamedTuple):
    """A test of a run, its number there, and whether it was made or the early exit left it out."""

    run: Trace
    number: int
    test: AxisTest
    made: bool


def sheet(what: SceneLike | Shape, b: Shape | None = None, *, title: str = "") -> Picture:
    """A whole run in one picture: each axis with both ranges, the gap and what it says.

    Of a scene (or its name), two shapes, or a trace.  The row that ended the run is marked, those that
    the early exit left out are shown faintly.  Of more than 12 axes those that tell most: what separates,
    then the largest gaps.
    """
    trace = resolve(what, b).trace
    every = list(_rows(trace))
    told_first = sorted(every, key=lambda row: (-(row.made and row.test.separates), -row.made, -row.test.gap))
    shown = [row for row in every if row in told_first[:MOST_ROWS]]
    rest = told_first[MOST_ROWS:]
    lines = wrapped(trace.sentence, WIDTH - 2 * MARGIN).split("\n")
    height = HEAD + ROW * len(shown) + (22 if rest else 0) + 16 * len(lines) + 2 * MARGIN
    top = height - HEAD
    widest = max((text_box(line)[0] for row in shown for line, _ in _said(row)), default=0.0)
    end = min(BARS[1], WIDTH - MARGIN - widest - 8)
    marks = [_text("legend", text, role, left, top + 9, n) for n, (role, text, left) in enumerate(_legend(trace, end))]
    scale, zero = _scale([_ends(row.test) for row in shown], end)
    if zero is not None:
        marks.append(Mark("zero-name", "label", "guide", (Vec(zero, top + 9),), text="0"))
    for i, row in enumerate(shown):
        marks += _row(row, i + 1, top - ROW * i, scale, zero, end)
    y = top - ROW * len(shown)
    if rest:
        best = max(rest, key=lambda row: row.test.gap)
        gap = describe.digits(best.run, best.test).signed(best.test.gap)
        y -= 16
        marks.append(_text("rest", f"and {len(rest)} more, best gap {gap}", "guide", MARGIN, y))
    for n, line in enumerate(lines):
        marks.append(_text("sentence", line, "ink", MARGIN, y - MARGIN - 8 - 16 * n, number=n))
    count = f"{len(every)} {'axis' if len(every) == 1 else 'axes'}"
    said = f"A sheet of {count}, each with the ranges of {' and '.join(trace.names)}. {trace.sentence}"
    return Picture(tuple(marks), (0.0, 0.0, WIDTH, height), (WIDTH, height), title, said)


def _rows(trace: Trace) -> list[Row]:
    whole = trace.without_early_exit()
    found = []
    for n, run in enumerate(whole.pairs or (whole,)):
        tested = trace.pairs[n].tests if n < len(trace.pairs) else () if trace.pairs else trace.tests
        found += [Row(run, i, test, i <= len(tested)) for i, test in enumerate(run.tests, 1)]
    return found


def _legend(trace: Trace, end: float) -> list[tuple[str, str, float]]:
    """Whose bar is where: role, words, where they begin."""
    above, below = f"{trace.names.a} above,", f"{trace.names.b} below"
    return [("A", above, end + 8), ("B", below, end + 12 + text_box(above)[0])]


def _ends(test: AxisTest) -> tuple[float, float]:
    a, b = test.a.interval, test.b.interval
    return min(a.lo, b.lo), max(a.hi, b.hi)


def _scale(ends: Sequence[tuple[float, float]], end: float) -> tuple[float, float | None]:
    """Points a unit, the same in all rows, and where 0 lies; None where it lies too far off."""
    widest = max((hi - lo for lo, hi in ends), default=1.0) or 1.0
    lo, hi = min((lo for lo, _ in ends), default=0.0), max((hi for _, hi in ends), default=0.0)
    lo, hi = min(lo, 0.0), max(hi, 0.0)
    room = end - BARS[0]
    if hi - lo > FAR_ZERO * widest:
        return room / widest, None
    scale = room / ((hi - lo) or 1.0)
    return scale, BARS[0] - lo * scale


def _said(row: Row) -> list[tuple[str, str]]:
    """What a row's test says, line by line, each with its role."""
    run, _, test, made = row
    found = describe.outcome(test, describe.digits(run, test)).replace(", way out", "\nway out").split("\n")
    colour = "guide" if not made else "ink" if not test.gap else "gap" if test.gap > 0 else "overlap"
    lines = [(found[0], colour), *((line, "ink" if made else "guide") for line in found[1:])]
    if not made:
        lines.append(("not tested", "guide"))
    elif test.separates:
        lines.append(("separates: stop", "ink"))
    return lines


def _row(row: Row, number: int, top: float, scale: float, zero: float | None, end: float) -> list[Mark]:
    run, _, test, made = row
    weight, ink = ("plain", "ink") if made else ("faint", "guide")
    y = top - ROW / 2 - 6
    a, b = test.a.interval, test.b.interval
    lo, hi = _ends(test)
    middle = (BARS[0] + end) / 2

    def at(t: float) -> float:
        return zero + t * scale if zero is not None else middle + (t - (lo + hi) / 2) * scale

    marks = _small(row, number, top, weight)
    marks.append(Mark("line", "segment", "guide", (Vec(BARS[0], y), Vec(end, y)), number=number))
    if zero is not None:
        tick = Vec(zero, y + 2 * TRACK), Vec(zero, y - 2 * TRACK)
        marks.append(Mark("zero", "segment", "ink", tick, number=number, weight=weight))

    def bar(part: str, role: str, start: float, stop: float, level: float, owner: str = "") -> None:
        points = Vec(at(start), level), Vec(at(stop), level)
        marks.append(Mark(part, "interval", role, points, owner=owner, number=number, weight=weight))
        if owner and points[1].x - points[0].x < SPECK:
            marks.append(Mark("range-speck", "dot", role, points[:1], owner=owner, number=number, weight=weight))

    bar("range", "A", *a, y + TRACK, run.names.a)
    bar("range", "B", *b, y - TRACK, run.names.b)
    if test.gap > 0:
        bar("gap", "gap", *((a.hi, b.lo) if a.hi <= b.lo else (b.hi, a.lo)), y)
    elif test.gap < 0:
        bar("gap", "overlap", max(a.lo, b.lo), min(a.hi, b.hi), y)
    name = describe.axis_name(test.axis, (run.a, run.b), run.names)
    pair = "" if run.names == ("A", "B") else f"{run.names.a} | {run.names.b}: "
    marks.append(_text("name", _cut(f"{pair}{row.number} {name}", end - BARS[0]), ink, BARS[0], top - 10, number))
    lines = _said(row)
    for n, (line, role) in enumerate(lines):
        up = y + 7 * (len(lines) - 1) - 14 * n
        marks.append(_text(f"outcome-{n + 1}", line, role, end + 8, up, number))
    if made and test.separates:
        box = Vec(4, top - ROW + 1), Vec(WIDTH - 4, top - ROW + 1), Vec(WIDTH - 4, top - 1), Vec(4, top - 1)
        marks.append(Mark("stop", "outline", "gap", box, number=number, weight="faint"))
    return marks


def _small(row: Row, number: int, top: float, weight: str) -> list[Mark]:
    """Both shapes and the axis's direction."""
    run, _, test, _ = row
    x0, y0, x1, y1 = box_of([run.a, run.b])
    center, corner = Vec((x0 + x1) / 2, (y0 + y1) / 2), Vec(MARGIN + SMALL[0] / 2, top - ROW / 2)
    scale = 0.86 * min(SMALL[0] / ((x1 - x0) or 1.0), SMALL[1] / ((y1 - y0) or 1.0))

    def at(p: Vec) -> Vec:
        return Vec(corner.x + (p.x - center.x) * scale, corner.y + (p.y - center.y) * scale)

    marks = []
    for role, name, shape in ("A", run.names.a, run.a), ("B", run.names.b, run.b):
        if isinstance(shape, Circle):
            turns = [k * pi / 24 for k in range(48)]
            ring = [Vec(shape.center.x + shape.radius * cos(t), shape.center.y + shape.radius * sin(t)) for t in turns]
        else:
            ring = list(shape.vertices)
        points = tuple(at(p) for p in ring)
        marks.append(Mark("small", "outline", role, points, owner=name, number=number, weight="faint"))
        if max(abs(p.x - points[0].x) + abs(p.y - points[0].y) for p in points) < SPECK:
            marks.append(Mark("small-speck", "dot", role, points[:1], owner=name, number=number, weight=weight))
    n = test.axis.direction
    half = min(SMALL[0] / 2 / max(abs(n.x), 1e-9), SMALL[1] / 2 / max(abs(n.y), 1e-9), hypot(*SMALL))
    ends = tuple(Vec(corner.x + n.x * half * way, corner.y + n.y * half * way) for way in (-1, 1))
    marks.append(Mark("axis", "arrow", "ink" if weight == "plain" else "guide", ends, number=number))
    return marks


def _text(part: str, text: str, role: str, left: float, y: float, number: int | None = None) -> Mark:
    """A line that begins at `left`."""
    return Mark(part, "label", role, (Vec(left + text_box(text)[0] / 2, y),), number=number, text=text)


def _cut(text: str, room: float) -> str:
    while text_box(text)[0] > room:
        text = text[:-2] + "\u2026"
    return text
