"""Number lines for paper: a line for each axis of a run, empty to draw the ranges on, or with the ranges."""

from math import ceil, floor, isclose

from ..engine import describe
from ..engine.geometry import Vec
from ..engine.trace import Trace
from .float_geometry import gap_or_overlap
from .letters import text_size
from .marks import Mark, Picture
from .number_line import round_steps
from .sheet import MAX_ROWS, Row, all_rows, covered_range, text_from, truncate

WIDTH_PT, ROW_PT, MARGIN_PT = 480.0, 68.0, 18.0
NAME_PT, NUMBER_PT, TICK_PT = 31.0, 16.0, 5.0  # a name above its line, the numbers below it, half a tick
TRACK_PT = 9.0  # distance from a line to A's bar above it, and from A's bar to B's bar
HATCH_PT, HATCH_STEP_PT = 3.5, 4.0  # half the height of an overlap's bar; between two strokes in it
MAX_TICKS = 16
TICK_GAP_PT = 6.0  # least space between the numbers of two ticks
MIN_FIGURES = 6  # digits of a tick's number, at least


def number_lines(trace: Trace, *, filled: bool) -> Picture:
    """Return one picture of a number line for each axis, also those not tested; `filled` draws ranges and gaps.

    It has at most 12 lines, all on one scale, which says nothing about which axes separate.
    """
    rows = all_rows(trace)[:MAX_ROWS]
    ends = [covered_range(row.test) for row in rows]
    length = max((hi for _, hi in ends), default=1.0) - min((lo for lo, _ in ends), default=0.0)
    step = next(round_steps((length or 1.0) / MAX_TICKS))
    first = floor(min((lo for lo, _ in ends), default=0.0) / step) - 1
    last = ceil(max((hi for _, hi in ends), default=1.0) / step) + 1
    scale = (WIDTH_PT - 2 * MARGIN_PT) / ((last - first) * step)
    height = ROW_PT * len(rows) + MARGIN_PT
    marks: list[Mark] = []
    for n, row in enumerate(rows, 1):
        y = height - ROW_PT * n + NUMBER_PT
        marks += _line(row, n, y, range(first, last + 1), step, scale)
        if filled:
            marks += _ranges(row, n, y, first * step, scale)
    kind = "with the ranges" if filled else "to draw the ranges on"
    said = f"{len(rows)} number {'line' if len(rows) == 1 else 'lines'} {kind} of {' and '.join(trace.names)}."
    return Picture(tuple(marks), (0.0, 0.0, WIDTH_PT, height), (WIDTH_PT, height), "", said)


def _line(row: Row, number: int, y: float, ticks: range, step: float, scale: float) -> list[Mark]:
    """Return a named line at height y, with a tick at each multiple of the step, and numbers where they have space.

    `number` is that of the row, `ticks` are multiples of `step`, and `scale` is in points per unit of the axis.
    """
    pair = "" if row.run.names == ("A", "B") else f"{row.run.names.a} and {row.run.names.b}: "
    name = f"{pair}axis {row.number}, {describe.axis_name(row.test.axis, (row.run.a, row.run.b), row.run.names)}"
    marks = [
        text_from("name", truncate(name, WIDTH_PT - 2 * MARGIN_PT), "ink", MARGIN_PT, y + NAME_PT, number),
        Mark("line", "arrow", "ink", (Vec(4, y), Vec(WIDTH_PT - 4, y)), number=number),
    ]
    figures = max(MIN_FIGURES, len(str(10 * max(map(abs, ticks)))))  # all of a tick's number, and none of its rounding
    texts = {k: f"{k * step:.{figures}g}" for k in ticks}
    widest = max(text_size(text)[0] for text in texts.values()) + TICK_GAP_PT
    # also the numbers that are named go up by 1, 2 or 5 times a power of ten
    ratios = (each / step for each in round_steps(max(step, widest / scale)))
    every = next(round(ratio) for ratio in ratios if isclose(ratio, round(ratio)))
    for k, text in texts.items():
        x = MARGIN_PT + (k - ticks[0]) * step * scale
        part = f"tick-{text}"
        marks.append(Mark(part, "segment", "ink", (Vec(x, y - TICK_PT), Vec(x, y + TICK_PT)), number=number))
        if k % every == 0:
            spot, text = Vec(x, y - NUMBER_PT), text.replace("-", "−")
            marks.append(Mark(f"{part}-name", "label", "guide", (spot,), number=number, text=text))
    return marks


def _ranges(row: Row, number: int, y: float, start: float, scale: float) -> list[Mark]:
    """Return the bars of both ranges above the line at height y, and on it that of the gap or a hatched overlap.

    Paper has no colours, so the hatch tells an overlap from a gap.  `start`: the coordinate at the left margin.
    """

    def bar(part: str, role: str, lo: float, hi: float, level: float, owner: str = "") -> Mark:
        """Return a bar from one coordinate on the axis to another, at the height `level`."""
        points = Vec(MARGIN_PT + (lo - start) * scale, level), Vec(MARGIN_PT + (hi - start) * scale, level)
        return Mark(part, "interval", role, points, owner=owner, number=number)

    a, b = row.test.a.interval, row.test.b.interval
    a_is_lower = a.lo + a.hi <= b.lo + b.hi
    marks = []
    sides = ("A", row.run.names.a, a, a_is_lower), ("B", row.run.names.b, b, not a_is_lower)
    for k, (role, name, interval, names_left) in enumerate(sides, 1):
        level = y + TRACK_PT * k - 2
        drawn = bar("range", role, *interval, level, name)
        beside = drawn.points[0].x - 5 - text_size(name)[0] if names_left else drawn.points[1].x + 5  # clear of the gap
        marks += [drawn, text_from("range-name", name, role, beside, level, number)._replace(owner=name)]
    if row.test.gap > 0:
        marks.append(bar("gap", "gap", *gap_or_overlap(row.test), y))
    elif row.test.gap:
        left, right = (p.x for p in bar("overlap", "overlap", *gap_or_overlap(row.test), y).points)
        low, high, count = y - HATCH_PT, y + HATCH_PT, ceil((right - left) / HATCH_STEP_PT)
        corners = Vec(left, low), Vec(right, low), Vec(right, high), Vec(left, high)
        ends = ((k + part, level) for k in range(count) for part, level in ((0, low), (1, high)))
        strokes = [Vec(left + n * (right - left) / count, level) for n, level in ends]
        marks.append(Mark("overlap", "outline", "overlap", corners, number=number, weight="faint"))
        marks.append(Mark("hatch", "segment", "overlap", tuple(strokes), number=number))
    return marks
