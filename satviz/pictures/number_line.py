"""The number line below a picture that is dragged: both ranges of a test on a line with ticks, with fixed numbers.

```
   axis 2                          gap +1.213
   A [-0.243, 2.425]        B [3.638, 7.034]
      ====A====   |---|   ====B====
   ---+-------+-------+-------+-------+------
      0       2       4       6       8
```

The line has the scale of the picture, and the middle of the canvas is the middle of the line.  So nothing on it moves
while a shape is dragged, except the ranges themselves.
"""

from collections.abc import Iterator
from math import ceil, floor, log10

from ..engine import describe
from ..engine.geometry import Vec
from ..engine.number_format import Digits
from ..engine.sat import AxisTest
from ..engine.trace import Trace
from .float_geometry import gap_or_overlap
from .layout import NARROW_PT, Layout
from .letters import text_size
from .marks import Mark, Picture

RIM_PT = 12.0  # space to the left and right of words and numbers
LINE_PT, TICK_NAMES_PT, TICK_PT = 44.0, 22.0, 4.0  # heights of the line and of the numbers below; half of a tick
TRACK_PT = 5.5  # distance from the line to a bar
BRACKET_PT = 10.0, 15.0  # distances from the line to the ends and to the back of the gap's bracket
ROW_PT = 16.0  # height of a row of words
MIN_TICK_DISTANCE_PT = 34.0
TICK_GAP_PT = 12.0  # least space between the numbers of two ticks
MAX_DOUBLINGS = 4  # how often the shown length may be doubled; after that the line is centered on the ranges


def number_line(run: Trace, test: AxisTest, layout: Layout, digits: Digits, name: str) -> Picture:
    """Return the picture of the two ranges of a test, as wide as the layout's canvas; a scene unit of it is a point.

    `name`: what the axis is called, such as "axis 2".  `digits`: the format of all numbers.
    """
    width = layout.size[0]
    stacked = width < NARROW_PT
    height = LINE_PT + BRACKET_PT[1] + (3.5 if stacked else 2.5) * ROW_PT
    start, scale = _window(test, layout)

    def at(t: float, level: float = 0.0) -> Vec:
        """Return the point of coordinate t, `level` points above the line."""
        return Vec((t - start) * scale, LINE_PT + level)

    says = describe.outcome(test, digits)
    role = "gap" if test.gap >= 0 else "overlap"
    ranges = [f"{owner} {text}" for owner, text in zip(run.names, digits.ranges(test), strict=True)]
    top = height - ROW_PT * 0.75
    marks = [Mark("axis", "arrow", "ink", (Vec(2.0, LINE_PT), Vec(width - 2.0, LINE_PT)))]
    marks += _ticks(start, scale, width, digits)
    for owner, shape, side, level in zip(run.names, "AB", (test.a, test.b), (TRACK_PT, -TRACK_PT), strict=True):
        bar = tuple(at(end, level) for end in side.interval)
        marks.append(Mark("range", "interval", shape, bar, owner=owner))
    lo, hi = gap_or_overlap(test)
    if test.gap >= 0:
        near, far = BRACKET_PT
        marks.append(Mark("gap", "bracket", "gap", (at(lo, near), at(lo, far), at(hi, far), at(hi, near))))
    else:
        marks.append(Mark("gap", "interval", "overlap", (at(lo), at(hi))))
    marks.append(_label("axis-name", name, "ink", RIM_PT, top))
    marks.append(_label("outcome", says, role, width - RIM_PT, top, right=True))
    for row, (owner, shape, text) in enumerate(zip(run.names, "AB", ranges, strict=True)):
        below = top - ROW_PT * (1 + row * stacked)
        right = not stacked and row == 1
        marks.append(_label("range-name", text, shape, width - RIM_PT if right else RIM_PT, below, owner, right=right))
    sentence = f"{name}: {', '.join(ranges)}, {says}."
    return Picture(tuple(marks), (0.0, 0.0, width, height), (width, height), "", sentence)


def _window(test: AxisTest, layout: Layout) -> tuple[float, float]:
    """Return (coordinate at the left end of the line, points in a unit of the axis)."""
    (x0, y0, x1, y1), n, width = layout.limits, test.axis.direction, layout.size[0]
    ends = [end for side in (test.a, test.b) for end in side.interval]
    lo, hi = min(ends), max(ends)
    middle, scale = (x0 + x1) / 2 * n.x + (y0 + y1) / 2 * n.y, layout.scale
    for _ in range(MAX_DOUBLINGS):
        half = (width / 2 - RIM_PT) / scale
        if middle - half <= lo and hi <= middle + half:
            return middle - width / 2 / scale, scale
        scale /= 2
    # a shortcut measures far from the shapes, or in another unit
    span = (hi - lo) or abs(hi) or 1.0
    length = 10.0 ** ceil(_log10(span * 1.2))
    length = next(part for part in (length / 5, length / 2, length) if part >= span * 1.2)
    step = length / 10
    return floor((lo - (length - span) / 2) / step) * step, width / (length + 2 * step)


def _log10(value: float) -> float:
    """Return the decimal logarithm of a number, or -300 for a number below 1e-300."""
    return log10(max(value, 1e-300))


def _ticks(start: float, scale: float, width: float, digits: Digits) -> Iterator[Mark]:
    """Yield ticks at round numbers, with these numbers below them where they have space.

    `start`: the coordinate at the left end; `scale`: points in a unit of the axis; `width`: of the canvas, in points.
    """
    plain = digits._replace(padded=False)
    for step in round_steps(MIN_TICK_DISTANCE_PT / scale):
        first, last = ceil((start + RIM_PT / scale) / step), floor((start + (width - RIM_PT) / scale) / step)
        names = [plain.landing(k * step) for k in range(first, last + 1)]
        if all(text_size(name)[0] + TICK_GAP_PT <= step * scale for name in names):
            break
    for k, name in enumerate(names, first):
        x = (k * step - start) * scale
        ends = Vec(x, LINE_PT - TICK_PT), Vec(x, LINE_PT + TICK_PT)
        yield Mark("tick", "segment", "ink", ends, number=k)
        half = text_size(name)[0] / 2
        if half + 2.0 <= x <= width - half - 2.0:
            yield Mark("tick-name", "label", "guide", (Vec(x, TICK_NAMES_PT),), number=k, text=name)


def round_steps(least: float) -> Iterator[float]:
    """Yield the round numbers (1, 2 or 5 times a power of ten) from `least` up, about 12 powers of ten."""
    power = floor(_log10(least))
    for k in range(power, power + 12):
        yield from (step for factor in (1, 2, 5) if (step := factor * 10.0**k) >= least)


def _label(part: str, text: str, role: str, x: float, y: float, owner: str = "", *, right: bool = False) -> Mark:
    """Return a label at the height y that begins at x, or with `right` ends there."""
    half = text_size(text)[0] / 2
    return Mark(part, "label", role, (Vec(x - half if right else x + half, y),), owner=owner, text=text)
