"""A trace as a table of plain text: what `print(trace)` shows."""

import re
from collections.abc import Sequence

from .describe import axis_name, digits, reason, vertex_name
from .landing_sum import landing_sum
from .number_format import ascii_minus, vector
from .sat import AxisTest
from .trace import Trace

MAX_TABLE_PAIRS = 20  # pairs of convex parts in one table


def table(trace: Trace, width: int | None = None, sums: bool = False) -> str:
    """Return the trace as plain text: one row per test, then the axes that were not tested, then the sentence.

    `width`: the largest number of characters in a line; where the columns need more, a test takes several lines.
    `sums`: below each test stand the sums behind the ends of both ranges, where all their numbers are printed in full.
    """
    if not trace.pairs:
        blocks = [f"{_rows(trace, width, sums)}\n{_wrap([trace.sentence], width, '')}"]
    else:
        hit = trace.colliding
        shown = [pair for i, pair in enumerate(trace.pairs) if i < MAX_TABLE_PAIRS or pair is hit]
        blocks = [f"{pair.names.a} against {pair.names.b}\n{table(pair, width, sums=sums)}" for pair in shown]
        if left := len(trace.pairs) - len(shown):
            blocks.append(f"(and {left:,} more pairs of parts)")
        blocks.append(_wrap([trace.sentence], width, ""))
    return ascii_minus("\n\n".join(blocks))  # a terminal may be limited to ASCII


def _rows(trace: Trace, width: int | None, sums: bool) -> str:
    """Return the lines for all tests and untested axes as text, at most `width` characters wide where possible.

    `width`: None for no limit; `sums`: with the sum behind each end of a range below its test.
    """
    shapes = trace.a, trace.b
    rows = [("axis", "direction", trace.names.a, trace.names.b, "gap", "")]
    for i, t in enumerate(trace.tests, 1):
        name = axis_name(t.axis, shapes, trace.names)
        ends = trace.shortcut.separates(t) if trace.shortcut else t.separates
        what = "separates" if ends else "touches" if t.gap == 0 else "overlaps"
        numbers = digits(trace, t)
        cells = vector(t.axis.direction), *numbers.ranges(t), numbers.signed(t.gap), what
        rows.append((f"{i} {name}", *cells))
    widths = [max(len(row[i]) for row in rows) for i in range(6)]
    sides = "<<<<><"  # the gaps are aligned to the right
    lines = ["  ".join(f"{cell:{side}{w}}" for cell, side, w in zip(row, sides, widths)).rstrip() for row in rows]
    if width is not None and max(map(len, lines)) > width:
        heads = "", *rows[0][1:-1]
        blocks = [[*(f"{head} {cell}".lstrip() for head, cell in zip(heads, row)), row[-1]] for row in rows[1:]]
        lines = [_wrap(block, width, "  ") for block in blocks]
    if sums:
        first = len(lines) - len(trace.tests)
        for i, t in enumerate(trace.tests):
            below = [_wrap([f"    {line}"], width, "      ") for line in _sums_of_ends(trace, t)]
            lines[first + i] = "\n".join([lines[first + i], *below])
    for place, name, why in untested_rows(trace):
        lines.append(_wrap([f"- {place}{' ' if place else ''}{name}: {why}"], width, "  "))
    return "\n".join(lines)


def _sums_of_ends(trace: Trace, test: AxisTest) -> list[str]:
    """Return the sums behind both ends of both ranges, those of A first: "v1: 2*8 + 3*3 = 25; 25 / sqrt(13) = 6.934".

    A sum whose numbers are not printed in full is left out.
    """
    found, numbers = [], digits(trace, test)
    for role, side, shape, name in zip("AB", (test.a, test.b), (trace.a, trace.b), trace.names):
        for i in dict.fromkeys(side.landings.index(end) for end in side.interval):
            text = "".join(piece for piece, _ in landing_sum(numbers, test, role, i))
            who = name
            if side.points[i] in shape.vertices:
                who = vertex_name(shape, name, shape.vertices.index(side.points[i]))
            if text:
                found.append(f"{who}: {_in_ascii(text)}")
    return found


def _in_ascii(text: str) -> str:
    """Return a sum with "*" and "sqrt(13)", which every terminal can print."""
    return re.sub(r"\u221a(\S+)", r"sqrt(\1)", text.replace("\u00b7", "*")).replace(";  ", "; ")


def untested_rows(trace: Trace) -> list[tuple[str, str, str]]:
    """Return (number or "", name, reason) for untested axes; those with equal number and reason share a row.

    The number is the place in the choice of axes, which an axis skipped by the choice does not have.
    """
    places = {axis: f"{i}" for i, axis in reversed([*enumerate(trace.choice.axes, 1)])}
    found: dict[tuple[str, str], list[str]] = {}
    for s in sorted(trace.skipped, key=lambda s: s.axis not in places):  # axes with a number come first
        row = places.get(s.axis, ""), reason(s.why, s.number)
        found.setdefault(row, []).append(axis_name(s.axis, (trace.a, trace.b), trace.names))
    return [(p, f"{name} and {len(more)} more" if more else name, why) for (p, why), (name, *more) in found.items()]


def _wrap(pieces: Sequence[str], width: int | None, indent: str) -> str:
    """Join the pieces into lines of at most `width` characters, the later ones indented; None: one line.

    A line is broken between two pieces, or within a piece at a space.  Lines after the first begin with `indent`.
    """
    line, lines = "", []
    for piece in pieces:
        joined = f"{line}  {piece}" if line.strip() else f"{line}{piece}"
        if width is not None and len(joined) > width and line.strip():
            lines.append(line)
            joined = f"{indent}{piece}"
        while width is not None and len(joined) > width and " " in joined[len(indent) : width + 1].rstrip():
            at = joined.rindex(" ", len(indent), width + 1)
            lines.append(joined[:at])
            joined = f"{indent}{joined[at + 1 :]}"
        line = joined
    return "\n".join([*lines, line])
