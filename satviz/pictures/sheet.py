"""The contact sheet: one picture of a whole run, with a row for each axis and all ranges on one scale."""

from collections.abc import Sequence
from math import hypot
from typing import NamedTuple

from ..engine import describe
from ..engine.geometry import Vec
from ..engine.sat import AxisTest
from ..engine.shapes import Circle, Shape
from ..engine.trace import Trace
from ..scenes.resolve import SceneLike, resolve
from .float_geometry import bounding_box, circle_points, gap_or_overlap
from .insets import MIN_GAP_PT, a_is_left, magnification_text, round_down
from .letters import text_size, wrap_text
from .marks import Mark, Picture

MAX_ROWS = 12
WIDTH_PT, MARGIN_PT = 340.0, 8.0  # a telephone shows a sheet of this width without making its letters smaller
HEAD_PT, ROW_PT, LINE_PT = 44.0, 54.0, 14.0  # heights: of the head, of a row without its outcome, of a line of that
NAME_PT = 18.0  # height of the line with an axis's name, above the row's small picture and its bars
THUMBNAIL_PT = 62.0, 44.0  # a row's small picture
BARS_LEFT_PT, BARS_RIGHT_PT = 84.0, WIDTH_PT - 2 * MARGIN_PT  # x coordinates where the ranges begin and end
WORDS_GAP_PT = 8.0  # space between two pieces of an outcome
MIN_BAR_PT = 3.0  # a shorter range or shape gets a dot
TRACK_PT = 5.0  # distance from the line of a row to A's bar above it and to B's bar below it
# a gap's inset: its size, its rim, the distance from its middle to a bar
INSET_PT, INSET_RIM_PT, INSET_TRACK_PT = (60.0, 18.0), 4.0, 5.0
MAX_ZERO_RANGES = 4.0  # further from 0 than so many times the widest range, each row has an origin of its own


class Row(NamedTuple):
    """A row of the sheet: a run, a test's number in it (from 1), the test, and whether the trace made this test."""

    run: Trace
    number: int
    test: AxisTest
    made: bool


def sheet(what: SceneLike | Shape, b: Shape | None = None, *, title: str = "") -> Picture:
    """Return a whole run in one picture: each axis with both ranges, the gap and what follows from it.

    `what` is a scene (or its name), a trace, or the first of two shapes.  The row that ended the run is framed; rows
    of axes that the early exit left out are faint.  Of more than 12 axes the sheet shows first those that separate,
    then those of the largest gaps.
    """
    trace = resolve(what, b).trace
    every = all_rows(trace)
    ranked = sorted(every, key=lambda row: (-(row.made and row.test.separates), -row.made, -row.test.gap))
    shown = [row for row in every if row in ranked[:MAX_ROWS]]
    rest = ranked[MAX_ROWS:]
    lines = wrap_text(trace.sentence, WIDTH_PT - 2 * MARGIN_PT).split("\n")
    scale, zero = _scale_and_zero([covered_range(row.test) for row in shown])
    words = [_outcome_lines(row, _inset_times(row, scale)) for row in shown]
    heights = [ROW_PT + LINE_PT * len(found) for found in words]
    height = HEAD_PT + sum(heights) + (22 if rest else 0) + 16 * len(lines) + 2 * MARGIN_PT
    top = height - HEAD_PT
    marks = [text_from("legend", text, role, left, top + 27, n) for n, (role, text, left) in enumerate(_legend(trace))]
    if zero is not None:
        marks.append(Mark("zero-name", "label", "guide", (Vec(zero, top + 9),), text="0"))
    y = top
    for i, row in enumerate(shown):
        marks += _row_marks(row, i + 1, y, heights[i], words[i], scale, zero)
        y -= heights[i]
    if rest:
        best = max(rest, key=lambda row: row.test.gap)
        gap = describe.gap_in_words(best.test.gap, describe.digits(best.run, best.test))
        y -= 16
        marks.append(text_from("rest", f"and {len(rest)} more, at best {gap}", "guide", MARGIN_PT, y))
    for n, line in enumerate(lines):
        marks.append(text_from("sentence", line, "ink", MARGIN_PT, y - MARGIN_PT - 8 - 16 * n, number=n))
    count = f"{len(every)} {'axis' if len(every) == 1 else 'axes'}"
    said = f"A sheet of {count}, each with the ranges of {' and '.join(trace.names)}. {trace.sentence}"
    return Picture(tuple(marks), (0.0, 0.0, WIDTH_PT, height), (WIDTH_PT, height), title, said)


def all_rows(trace: Trace) -> list[Row]:
    """Return a row for each axis that the run without early exit tests, of all pairs of convex parts."""
    whole = trace.without_early_exit()
    found = []
    for n, run in enumerate(whole.pairs or (whole,)):
        tested = trace.pairs[n].tests if n < len(trace.pairs) else () if trace.pairs else trace.tests
        found += [Row(run, i, test, i <= len(tested)) for i, test in enumerate(run.tests, 1)]
    return found


def _legend(trace: Trace) -> list[tuple[str, str, float]]:
    """Return each shape's legend as (role, text, x at which it begins), such as "A above," and "B below"."""
    above, below = f"{trace.names.a} above,", f"{trace.names.b} below"
    return [("A", above, BARS_LEFT_PT), ("B", below, BARS_LEFT_PT + 4 + text_size(above)[0])]


def covered_range(test: AxisTest) -> tuple[float, float]:
    """Return (least, largest) coordinate of the test's two ranges."""
    a, b = test.a.interval, test.b.interval
    return min(a.lo, b.lo), max(a.hi, b.hi)


def _scale_and_zero(ends: Sequence[tuple[float, float]]) -> tuple[float, float | None]:
    """Return the bars' scale (points per unit) and the x of coordinate 0, None if it is too far away."""
    widest = max((hi - lo for lo, hi in ends), default=1.0) or 1.0
    lo, hi = min((lo for lo, _ in ends), default=0.0), max((hi for _, hi in ends), default=0.0)
    lo, hi = min(lo, 0.0), max(hi, 0.0)
    width = BARS_RIGHT_PT - BARS_LEFT_PT
    if hi - lo > MAX_ZERO_RANGES * widest:
        return width / widest, None
    scale = width / ((hi - lo) or 1.0)
    return scale, BARS_LEFT_PT - lo * scale


def _outcome_lines(row: Row, inset_times: float) -> list[list[tuple[str, str]]]:
    """Return the lines of text about a row's outcome, each as the (text, colour role) pairs that fit into it.

    The first line leaves space for an inset if `inset_times`, its magnification, is not 0.
    """
    run, _, test, made = row
    first, *others = describe.outcome(test, describe.digits(run, test)).replace(", way out", "\nway out").split("\n")
    colour = "guide" if not made else "ink" if not test.gap else "gap" if test.gap > 0 else "overlap"
    pieces = [(first, colour), *((text, "ink" if made else "guide") for text in others)]
    if not made:
        pieces.append(("not tested", "guide"))
    elif test.separates:
        pieces.append(("separates: stop", "ink"))
    lines, space = [pieces[:1]], BARS_RIGHT_PT - BARS_LEFT_PT - text_size(first)[0]
    if inset_times:
        space -= INSET_PT[0] + 2 * INSET_RIM_PT + text_size(magnification_text(inset_times))[0]
    for piece in pieces[1:]:
        width = text_size(piece[0])[0]
        if width + WORDS_GAP_PT > space:
            lines.append([])
            space = BARS_RIGHT_PT - BARS_LEFT_PT + WORDS_GAP_PT
        lines[-1].append(piece)
        space -= width + WORDS_GAP_PT
    return lines


def _row_marks(
    row: Row,
    number: int,
    top: float,
    height: float,
    words: Sequence[Sequence[tuple[str, str]]],
    scale: float,
    zero: float | None,
) -> list[Mark]:
    """Return the marks of row `number` (from 1); `top`: the y of its upper end; `scale`: points per unit of the axis.

    `words`: the lines about its outcome, as (text, role) pairs; `zero`: the x of coordinate 0, None if too far away.
    """
    run, _, test, made = row
    weight, ink = ("plain", "ink") if made else ("faint", "guide")
    y = top - 34
    lo, hi = covered_range(test)
    middle = (BARS_LEFT_PT + BARS_RIGHT_PT) / 2

    def x_at(t: float) -> float:
        """Return the x of a coordinate on the axis."""
        return zero + t * scale if zero is not None else middle + (t - (lo + hi) / 2) * scale

    marks = _thumbnail_marks(row, number, top - (NAME_PT + height) / 2, weight)
    marks.append(Mark("line", "segment", "guide", (Vec(BARS_LEFT_PT, y), Vec(BARS_RIGHT_PT, y)), number=number))
    if zero is not None:
        tick = Vec(zero, y + 2 * TRACK_PT), Vec(zero, y - 2 * TRACK_PT)
        marks.append(Mark("zero", "segment", "ink", tick, number=number, weight=weight))

    def bar(part: str, role: str, start: float, stop: float, level: float, owner: str = "") -> None:
        """Add a bar at height `level` from one coordinate to another; with an owner, a very short one gets a dot."""
        points = Vec(x_at(start), level), Vec(x_at(stop), level)
        marks.append(Mark(part, "interval", role, points, owner=owner, number=number, weight=weight))
        if owner and points[1].x - points[0].x < MIN_BAR_PT:
            marks.append(Mark("range-speck", "dot", role, points[:1], owner=owner, number=number, weight=weight))

    bar("range", "A", *test.a.interval, y + TRACK_PT, run.names.a)
    bar("range", "B", *test.b.interval, y - TRACK_PT, run.names.b)
    if test.gap:
        role = "gap" if test.gap > 0 else "overlap"
        bar("gap", role, *gap_or_overlap(test), y)
    marks += _inset_marks(row, number, top - ROW_PT, scale)
    pair = "" if run.names == ("A", "B") else f"{run.names.a}, {run.names.b}: "
    name, short = (
        f"{pair}{row.number} {words_of(test.axis, (run.a, run.b), run.names)}"
        for words_of in (describe.axis_name, describe.short_axis_name)
    )
    space = WIDTH_PT - 2 * MARGIN_PT
    name = truncate(name if text_size(name)[0] <= space else short, space)
    marks.append(text_from("name", name, ink, MARGIN_PT, top - 10, number))
    count = 0
    for n, line in enumerate(words):
        left = BARS_LEFT_PT
        for text, role in line:
            count += 1
            marks.append(text_from(f"outcome-{count}", text, role, left, top - ROW_PT - LINE_PT * n, number))
            left += text_size(text)[0] + WORDS_GAP_PT
    if made and test.separates:
        low, high, right = top - height + 1, top - 1, WIDTH_PT - 4
        box = Vec(4, low), Vec(right, low), Vec(right, high), Vec(4, high)
        marks.append(Mark("stop", "outline", "gap", box, number=number, weight="faint"))
    return marks


def _inset_times(row: Row, scale: float) -> float:
    """Return how many times an inset magnifies a gap or overlap that the row's bars are too small to show; else 0."""
    size = abs(row.test.gap) * scale
    return round_down(INSET_PT[0] / 3 / size) if 1e-300 < size < MIN_GAP_PT else 0.0


def _inset_marks(row: Row, number: int, cy: float, scale: float) -> list[Mark]:
    """Return a small inset of a gap or overlap that the row's bars are too small to show, with its magnification first.

    It shows the facing ends of both ranges, and stands at the right end of the first line of the outcome, at y = `cy`.
    """
    run, _, test, made = row
    times, end = _inset_times(row, scale), BARS_RIGHT_PT
    if not times:
        return []
    x0, cx = end - INSET_PT[0], end - INSET_PT[0] / 2
    half, high, weight = test.gap * scale * times / 2, INSET_PT[1] / 2, "plain" if made else "faint"
    corners = Vec(x0, cy - high), Vec(end, cy - high), Vec(end, cy + high), Vec(x0, cy + high)
    text = magnification_text(times)
    spot = Vec(x0 - INSET_RIM_PT - text_size(text)[0] / 2, cy)
    marks = [
        Mark("inset", "outline", "guide", corners, number=number, weight="faint"),
        Mark("inset-name", "label", "guide", (spot,), number=number, text=text),
    ]
    facing = [("A", run.names.a), ("B", run.names.b)]
    sides = (x0, cx - half), (cx + half, end)
    for (role, name), (left, right) in zip(facing if a_is_left(test) else facing[::-1], sides, strict=True):
        level = cy + (INSET_TRACK_PT if role == "A" else -INSET_TRACK_PT)
        points = Vec(left, level), Vec(right, level)
        marks.append(Mark("inset-range", "interval", role, points, owner=name, number=number, weight=weight))
    points = Vec(cx - abs(half), cy), Vec(cx + abs(half), cy)
    role = "gap" if test.gap > 0 else "overlap"
    return [*marks, Mark("inset-gap", "interval", role, points, number=number, weight=weight)]


def _thumbnail_marks(row: Row, number: int, middle: float, weight: str) -> list[Mark]:
    """Return the marks of a row's small picture, at the height `middle`: both shapes and the axis's direction."""
    run, _, test, _ = row
    x0, y0, x1, y1 = bounding_box([run.a, run.b])
    center, corner = Vec((x0 + x1) / 2, (y0 + y1) / 2), Vec(MARGIN_PT + THUMBNAIL_PT[0] / 2, middle)
    scale = 0.86 * min(THUMBNAIL_PT[0] / ((x1 - x0) or 1.0), THUMBNAIL_PT[1] / ((y1 - y0) or 1.0))

    def at(p: Vec) -> Vec:
        """Return the point in the thumbnail, in points of the sheet, that shows the scene's point p."""
        return Vec(corner.x + (p.x - center.x) * scale, corner.y + (p.y - center.y) * scale)

    marks = []
    for role, name, shape in ("A", run.names.a, run.a), ("B", run.names.b, run.b):
        ring = circle_points(shape.center, shape.radius, 48) if isinstance(shape, Circle) else shape.vertices
        points = tuple(map(at, ring))
        marks.append(Mark("small", "outline", role, points, owner=name, number=number, weight="faint"))
        if max(abs(p.x - points[0].x) + abs(p.y - points[0].y) for p in points) < MIN_BAR_PT:
            marks.append(Mark("small-speck", "dot", role, points[:1], owner=name, number=number, weight=weight))
    n = test.axis.direction
    half = min(
        THUMBNAIL_PT[0] / 2 / max(abs(n.x), 1e-9), THUMBNAIL_PT[1] / 2 / max(abs(n.y), 1e-9), hypot(*THUMBNAIL_PT)
    )
    ends = tuple(Vec(corner.x + n.x * half * way, corner.y + n.y * half * way) for way in (-1, 1))
    marks.append(Mark("axis", "arrow", "ink" if weight == "plain" else "guide", ends, number=number))
    return marks


def text_from(part: str, text: str, role: str, left: float, y: float, number: int | None = None) -> Mark:
    """Return a one-line label that begins at x = `left`, its middle at height `y`."""
    return Mark(part, "label", role, (Vec(left + text_size(text)[0] / 2, y),), number=number, text=text)


def truncate(text: str, width: float) -> str:
    """Return the text, cut with an ellipsis to at most `width` points."""
    while text_size(text)[0] > width:
        text = text[:-2] + "\u2026"
    return text
