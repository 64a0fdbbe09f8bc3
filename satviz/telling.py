"""A trace in words: the names of axes, the sentence of a test, the verdict, the plain-text table."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .axes import CENTERS, EDGE, HULL, VERTEX, WORLD, Axis
from .concave import named_parts
from .geometry import Interval, Relation, Vec
from .shapes import Circle, Shape

if TYPE_CHECKING:
    from .certificate import SeparatingLine
    from .trace import Names, Trace


def number(value: float) -> str:
    """Up to three decimals, all three where digits were cut; never 0 for what is not 0."""
    if 0.001 <= abs(value) < 1e6 or value == 0:
        text = f"{value + 0.0:.3f}"
        return text.rstrip("0").rstrip(".") if float(text) == value else text
    return f"{value:.3e}"


def signed(value: float) -> str:
    """A gap: with its sign, 0 only for exactly 0."""
    return f"+{number(value)}" if value > 0 else number(value)


def interval(value: Interval) -> str:
    return f"[{number(value.lo)}, {number(value.hi)}]"


def vector(value: Vec) -> str:
    return f"({number(value.x)}, {number(value.y)})"


def vertex_name(shape: Shape, name: str, i: int) -> str:
    """The owner's label, or the shape's letter in small with a number from 1: b1, b2 ..."""
    label = shape.labels[i] if shape.labels else ""
    label = "".join(c if c.isprintable() else "\ufffd" for c in label)  # a control character would break an SVG
    return label or f"{name.lower()}{'.' if name[-1].isdigit() else ''}{i + 1}"


def axis_name(axis: Axis, shapes: tuple[Shape, Shape], names: Names) -> str:
    """Where an axis comes from: "normal of B's edge v1v3"."""
    kind, role, ids = axis.source
    if kind == WORLD:
        return f"the {'xy'[ids[0]]} axis"
    if kind == CENTERS:
        return "through both centers"
    if kind in (EDGE, HULL, VERTEX):
        at = "AB".index(role)
        ends = [vertex_name(shapes[at], names[at], i) for i in ids]
        if kind != VERTEX:
            return f"normal of {names[at]}'s {'hull ' if kind == HULL else ''}edge {edge_name(ends)}"
        return f"from {names[at]}'s nearest vertex {ends[0]} to the center of {names[1 - at]}"
    return f"direction {vector(axis.normal)}"


def short_axis_name(axis: Axis, shapes: tuple[Shape, Shape], names: Names) -> str:
    """The same for a list: "B's v2v3"."""
    return axis_name(axis, shapes, names).replace("normal of ", "").replace("edge ", "").replace("from ", "")


def edge_name(ends: list[str]) -> str:
    """Two short labels run together (v1v3), longer ones keep apart."""
    return "".join(ends) if all(len(end) <= 3 for end in ends) else "-".join(ends)


def outcome(gap: float) -> str:
    """What one gap says of the two ranges, and of nothing else."""
    if gap > 0:
        return f"gap {signed(gap)}"
    return f"overlap {number(-gap)}" if gap < 0 else "touching, gap 0"


def test(trace: Trace, i: int) -> str:
    """One test: which axis, both ranges, the gap, and what follows."""
    t = trace.tests[i]
    head = f"Axis {i + 1} of {len(trace.choice.axes)}, {axis_name(t.axis, (trace.a, trace.b), trace.names)}"
    ranges = f"{trace.names.a} {interval(t.a.interval)}, {trace.names.b} {interval(t.b.interval)}"
    if t.separates:
        return f"{head}: {ranges}, {outcome(t.gap)}: separating, so the shapes are apart."
    return f"{head}: {ranges}, {outcome(t.gap)}: not a separating axis."


def verdict(trace: Trace) -> str:
    """The whole run in one sentence that says no more than was proved."""
    if trace.pairs:
        return _parts_verdict(trace)
    a, b = trace.names
    separating = trace.separating
    if separating:
        i = trace.tests.index(separating)
        name = axis_name(separating.axis, (trace.a, trace.b), trace.names)
        return f"{a} and {b} are apart: axis {i + 1} ({name}) leaves a gap of {number(separating.gap)}."
    if trace.false_hit:
        return f"No gap on the {_axes(len(trace.tests))} tested, yet {a} and {b} are apart: a false hit."
    n = len(trace.tests)
    count = f"no gap on any of {n} axes" if n > 1 else "no gap on the one axis" if n else "no axis tested"
    if not trace.choice.complete:
        count += " (not a proof; the exact test decides)"
    if trace.relation is Relation.TOUCHING:
        return f"{a} and {b} touch: {count}, and they share no inner point. Touching is a hit."
    return f"{a} and {b} overlap: {count}. Moving {b} by {vector(trace.mtv)} parts them."


def _axes(n: int) -> str:
    return "1 axis" if n == 1 else f"{n} axes"


def _parts_verdict(trace: Trace) -> str:
    a, b = trace.names
    pairs = "1 pair" if len(trace.pairs) == 1 else f"{len(trace.pairs)} pairs"
    if not trace.hit:
        return f"{a} and {b} are apart: each of {pairs} of convex parts has a separating axis."
    p, q = trace.colliding.names
    if trace.relation is Relation.TOUCHING:
        return f"{a} and {b} touch: their parts {p} and {q} do, and no parts overlap. Touching is a hit."
    return f"{a} and {b} overlap: their parts {p} and {q} do. Moving {b} by {vector(trace.mtv)} parts them."


def table(trace: Trace) -> str:
    """The trace as plain text: a row a test, then the axes not tested, then the verdict."""
    if trace.pairs:
        blocks = [f"{pair.names.a} against {pair.names.b}\n{_rows(pair)}\n{verdict(pair)}" for pair in trace.pairs]
        return "\n\n".join([*blocks, verdict(trace)])
    return f"{_rows(trace)}\n{verdict(trace)}"


def _rows(trace: Trace) -> str:
    shapes = trace.a, trace.b
    rows = [("axis", "direction", trace.names.a, trace.names.b, "gap", "")]
    for i, t in enumerate(trace.tests, 1):
        name = axis_name(t.axis, shapes, trace.names)
        what = "separates" if t.separates else "touches" if t.gap == 0 else "overlaps"
        cells = vector(t.axis.direction), interval(t.a.interval), interval(t.b.interval), signed(t.gap), what
        rows.append((f"{i} {name}", *cells))
    widths = [max(len(row[i]) for row in rows) for i in range(6)]
    lines = ["  ".join(_pad(cell, w, right=i in (4,)) for i, (cell, w) in enumerate(zip(row, widths))) for row in rows]
    lines += [f"- {axis_name(s.axis, shapes, trace.names)}: {s.reason}" for s in trace.skipped]
    return "\n".join(line.rstrip() for line in lines)


def _pad(text: str, width: int, *, right: bool) -> str:
    return text.rjust(width) if right else text.ljust(width)


def scene(trace: Trace) -> str:
    """What is given and what is asked."""
    return f"{both(trace)} Do they touch?"


def both(trace: Trace) -> str:
    """What the two shapes are."""
    return f"{shape_in_words(trace.a, trace.names.a)}, {shape_in_words(trace.b, trace.names.b)}."


def line(certificate: SeparatingLine) -> str:
    """A separating line by its equation: "x = 5 (parallel to y)", "4x - y = 12.5"."""
    nx, ny = (float(c) for c in certificate.normal)
    offset = float(certificate.offset)
    if ny == 0 or nx == 0:
        return f"{'y' if nx == 0 else 'x'} = {number(offset / (nx or ny))} (parallel to {'x' if nx == 0 else 'y'})"
    size = max(abs(nx), abs(ny))
    if size > 1000:
        nx, ny, offset = nx / size, ny / size, offset / size
    return f"{_term(nx)}x {'-' if ny < 0 else '+'} {_term(abs(ny))}y = {number(offset)}"


def _term(factor: float) -> str:
    return "" if factor == 1 else "-" if factor == -1 else number(factor)


def parts(trace: Trace) -> str:
    """How concave outlines are split."""
    names = [[name for _, name in named_parts(s, n)] for s, n in zip((trace.a, trace.b), trace.names)]
    split = [f"{n} is split into {listed(ps)}" for ps, n in zip(names, trace.names) if len(ps) > 1]
    return f"{' and '.join(split)}: the shapes collide only if two of their convex parts do."


def stage(trace: Trace, i: int, name: str, first: str) -> str:
    """One drawing stage of test `i`; `first` is the role whose points drop first."""
    t = trace.tests[i]
    shapes = trace.a, trace.b
    at = "AB".index(first)
    side, owner = (t.a, t.b)[at], trace.names[at]
    axis = f"axis {i + 1}"
    if name == "edge":
        return f"{_origin(trace, t.axis)}."
    if name == "normal":
        what = f"its normal {vector(t.axis.normal)}" if t.source.kind in (EDGE, HULL) else "its direction"
        return f"{_origin(trace, t.axis)}; {what} is the direction of axis {i + 1} of {len(trace.choice.axes)}."
    if name == "axis":
        what = axis_name(t.axis, shapes, trace.names)
        return f"Axis {i + 1}, {what}, moved clear of the shapes: direction {vector(t.axis.direction)}."
    if name == "drops":
        lo, hi = (number(end) for end in side.interval)
        return f"{owner}'s points dropped onto {axis}: the lowest lands at {lo}, the highest at {hi}."
    if name == "range":
        return f"{owner}'s range on {axis} is {interval(side.interval)}."
    if name == "both ranges":
        ranges = f"{trace.names.a} {interval(t.a.interval)}, {trace.names.b} {interval(t.b.interval)}"
        return f"Both ranges on {axis}: {ranges}."
    return test(trace, i)


def _origin(trace: Trace, axis: Axis) -> str:
    """The edge or line that an axis comes from, with its vector."""
    kind, role, ids = axis.source
    if kind == CENTERS:
        return f"The line through the centers of {trace.names.a} and {trace.names.b}"
    at = "AB".index(role)
    shape, name = (trace.a, trace.b)[at], trace.names[at]
    ends = [vertex_name(shape, name, i) for i in ids]
    if kind == VERTEX:
        return f"The line from {name}'s nearest vertex {ends[0]} to the center of {trace.names[1 - at]}"
    p, q = (shape.vertices[i] for i in ids)
    what = "Hull edge" if kind == HULL else "Edge"
    return f"{what} {edge_name(ends)} of {name}: {ends[0]} - {ends[1]} = {vector(Vec(p.x - q.x, p.y - q.y))}"


def listed(words: list[str]) -> str:
    """ "x", "x and y", "x, y and z"."""
    if len(words) == 1:
        return words[0]
    return ", ".join(words[:-1]) + " and " + words[-1]


def shape_in_words(shape: Shape, name: str) -> str:
    """What a shape is: "A is a triangle", "B is a circle of radius 1 around (2, 2)"."""
    if isinstance(shape, Circle):
        return f"{name} is a circle of radius {number(shape.radius)} around {vector(shape.center)}"
    n = len(shape.corners)
    kind = {3: "triangle", 4: "quadrilateral"}.get(n, f"polygon with {n} corners")
    if shape.is_upright_box:
        kind = "upright box"
    what = kind if shape.is_convex else f"concave {kind}"
    return f"{name} is {'an' if what[0] in 'u' else 'a'} {what}"
