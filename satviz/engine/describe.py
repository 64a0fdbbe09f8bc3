"""A trace in words: names of vertices and axes, and the sentences of shapes, stages, tests and results."""

import re
from collections.abc import Callable, Sequence

from . import hooks
from .axes import (
    ANY,
    CENTERS,
    CENTROIDS,
    EARLY_EXIT,
    EDGE,
    FROM_EDGES,
    HULL,
    NO_DIRECTION,
    PARALLEL,
    SLIP,
    VERTEX,
    WORLD,
    Axis,
)
from .convex_parts import named_parts
from .geometry import Interval, Relation, Vec
from .mtv import why_too_many_parts
from .number_format import MINUS, Digits, digits_for_shapes, digits_for_tests, vector
from .sat import AxisTest
from .shapes import Shape
from .trace import ShapeNames, Trace

# invisible characters: Persian, emoji and Hebrew need joiners and marks; a number and its unit keep on one line
_INVISIBLE = "\u200c\u200d\u200e\u200f\xa0\u202f"


def printable(text: str) -> str:
    """Return the text with a replacement character for each control character, which would break an SVG."""
    return "".join(c if c.isprintable() or c in _INVISIBLE else "\ufffd" for c in text)


def vertex_name(shape: Shape, name: str, i: int) -> str:
    """Return a vertex's label, or the shape's small letter with a number from 1: b1, b2 ...; b2.1 for a part B2."""
    label = shape.labels[i] if shape.labels else ""
    return printable(label) or f"{name.lower()}{'.' if name[-1].isdigit() else ''}{i + 1}"


_PLAIN = {
    CENTERS: "through both centers",
    CENTROIDS: "through both centroids",
    ANY: "any direction, since the centers coincide",
}


def axis_name(axis: Axis, shapes: tuple[Shape, Shape], names: ShapeNames) -> str:
    """Return the source of an axis in words: "normal of B's edge v1v3"."""
    kind, role, ids = axis.source
    if kind == WORLD:
        return f"the {'xy'[ids[0]]} axis"
    if kind in _PLAIN:
        return _PLAIN[kind]
    if kind in (*FROM_EDGES, VERTEX):
        at = int(role == "B")
        ends = [vertex_name(shapes[at], names[at], i) for i in ids]
        if kind != VERTEX:
            what = "(dx, -dy)" if kind == SLIP else "normal"
            return f"{what} of {names[at]}'s {'hull ' if kind == HULL else ''}edge {edge_name(ends)}"
        return f"through {names[at]}'s nearest vertex {ends[0]} and the center of {names[1 - at]}"
    return f"direction {vector(axis.normal)}"


def short_axis_name(axis: Axis, shapes: tuple[Shape, Shape], names: ShapeNames) -> str:
    """Return an axis's name for a list: "B's v2v3"."""
    return axis_name(axis, shapes, names).replace("normal of ", "").replace("edge ", "").replace("through ", "")


def edge_name(ends: list[str]) -> str:
    """Return an edge's name made of its ends' names: "v1v3" for a letter and number each, else "x to y"."""
    return "".join(ends) if all(re.fullmatch(r"[^\W\d]\d{1,2}", end) for end in ends) else " to ".join(ends)


_WHY = {
    PARALLEL: "parallel to axis {}",
    NO_DIRECTION: "the center is on that vertex: no direction",
    EARLY_EXIT: "early exit: axis {} separates",
}


def reason(why: str, number: int | None) -> str:
    """Return in words why an axis was not tested; `why`, `number`: the fields of its Skip."""
    return _WHY[why].format(number)


def digits(trace: Trace, *tests: AxisTest) -> Digits:
    """Return the number format that suits these tests of a trace; without tests, one for lengths and points."""
    return digits_for_tests((trace.a, trace.b), tests)


def gap_in_words(gap: float, numbers: Digits) -> str:
    """Return a gap in the one wording that every picture and table has: "gap +1.2", "touching, gap 0", "overlap 3"."""
    if not gap:
        return "touching, gap 0"
    return f"gap {numbers.signed(gap)}" if gap > 0 else f"overlap {numbers.gap(gap)}"


NumberFormat = Callable[..., Digits]  # called with a trace and some of its tests, as `digits`


def outcome(t: AxisTest, numbers: Digits) -> str:
    """Return the gap of a test in words: "gap 2" or "overlap 1".

    Where one range holds the other, the overlap is less than the penetration depth, so both stand there:
    "overlap 1, way out 3".
    """
    shared = _shared_interval(t)
    # the depth is then more than the length that they share
    if 0 < shared.hi - shared.lo < -t.gap / 1.001 and not numbers.fine:
        return f"{gap_in_words(shared.lo - shared.hi, numbers)}, way out {numbers.gap(t.gap)}"
    return gap_in_words(t.gap, numbers)


def picture_outcome(t: AxisTest, numbers: Digits) -> str:
    """Return what `outcome` says; on a second line the interval that overlapping ranges share, if it is printable."""
    shared = _shared_interval(t)
    if t.gap >= 0 or numbers.fine or numbers.origin or shared.lo >= shared.hi:
        return outcome(t, numbers)
    return f"{outcome(t, numbers)}\n{numbers.interval(*shared)}"


def _shared_interval(t: AxisTest) -> Interval:
    """Return the interval that both ranges of a test cover; its `lo` is above its `hi` where there is none."""
    a, b = t.a.interval, t.b.interval
    return Interval(max(a.lo, b.lo), min(a.hi, b.hi))


def conclusion(trace: Trace, i: int) -> str:
    """Return in one line what follows from test `i` for the shapes."""
    t, last = trace.tests[i], i == len(trace.tests) - 1
    who = "the shapes" if trace.names == ("A", "B") else " and ".join(trace.names)
    if t.separates:
        return f"A gap: {who} are apart."
    found = "The ranges only touch" if t.gap == 0 else "The ranges overlap"
    if not last:
        return f"{found} on this axis: no verdict yet."
    if trace.separating or not trace.choice.complete:
        return f"{found} on this axis: it does not separate."
    collide = "touch" if trace.relation is Relation.TOUCHING else "collide"
    return f"{found} on this axis too: no gap on any, so {who} {collide}."


def claim_and_truth(trace: Trace) -> str:
    """Return two short sentences for a wrong claim: what the tested axes say, and the truth."""
    who = "AABB says" if {t.source.kind for t in trace.tests} == {WORLD} else "These axes say"
    return f"{who}: {'hit' if trace.claim else 'apart'}. Truth: {'hit' if trace.hit else 'apart'}."


def both_ranges(trace: Trace, t: AxisTest, numbers: Digits) -> str:
    """Return both ranges of a test as text: "A [2, 4], B [3, 6]"."""
    return ", ".join(f"{name} {text}" for name, text in zip(trace.names, numbers.ranges(t)))


def test_sentence(trace: Trace, i: int) -> str:
    """Return the sentence of test `i`: the axis, both ranges, the gap, and what follows."""
    t = trace.tests[i]
    head = f"Axis {i + 1} of {len(trace.choice.axes)}, {axis_name(t.axis, (trace.a, trace.b), trace.names)}"
    numbers = digits(trace, t)
    found = f"{both_ranges(trace, t, numbers)}, {outcome(t, numbers)}"
    who = "the shapes" if trace.names == ("A", "B") else " and ".join(trace.names)
    if trace.shortcut:
        ends = trace.shortcut.separates(t)
        return f"{head}: {found}: {f'taken for a gap, so {who} for apart' if ends else 'no gap'}."
    if t.separates:
        return f"{head}: {found}: separating, so {who} are apart."
    return f"{head}: {found}: not a separating axis."


def verdict_sentence(trace: Trace, move: Vec | None, digits: NumberFormat = digits) -> str:
    """Return a sentence on the result of the whole run and what proves it; `move`: the MTV of an overlap.

    `digits`: a function that returns the number format for a trace and some of its tests.
    """
    if trace.shortcut:
        return shortcut_verdict(trace, digits)
    if trace.pairs:
        return _parts_verdict(trace, move, digits)
    a, b = trace.names
    separating = trace.separating
    if separating:
        i = trace.tests.index(separating)
        name = axis_name(separating.axis, (trace.a, trace.b), trace.names)
        gap = digits(trace, separating).gap(separating.gap)
        return f"{a} and {b} are apart: axis {i + 1} ({name}) leaves a gap of {gap}."
    if trace.false_hit:
        tested = "1 axis" if len(trace.tests) == 1 else f"{len(trace.tests)} axes"
        return f"No gap on the {tested} tested, yet {a} and {b} are apart: a false hit."
    if not trace.tests:
        return f"This choice of axes has none for the pair: nothing is tested. {a} and {b} are {trace.relation}."
    count = f"no gap on {_any_of_axes(len(trace.tests))}"
    if not trace.choice.complete:
        count += " (not a proof; the exact test decides)"
    if trace.relation is Relation.TOUCHING:
        return f"{a} and {b} touch: {count}, and they share no interior point. Touching is a hit."
    return f"{a} and {b} overlap: {count}. {_mtv_sentence(trace, move, digits)}"


def verdict_in_brief(trace: Trace) -> str:
    """Return the verdict of a run in a few words: "axis 2 leaves a gap: apart"."""
    if trace.separating:
        return f"Axis {trace.tests.index(trace.separating) + 1} leaves a gap: {trace.relation}"
    return f"No axis leaves a gap: {trace.relation}"


def _is_of_one_corner(trace: Trace, t: AxisTest) -> bool:
    """Return whether a shortcut projected a single corner of a polygon, so that its test compares no ranges."""
    return any(len(side.points) == 1 < len(shape.core) for side, shape in ((t.a, trace.a), (t.b, trace.b)))


RELATION_PHRASES = {Relation.APART: "are apart", Relation.TOUCHING: "touch", Relation.OVERLAPPING: "overlap"}


def shortcut_verdict(trace: Trace, digits: NumberFormat = digits, *, name_axis: bool = True) -> str:
    """Return sentences on what a shortcut claims and what is true.

    Where its relation is right, they say whether its numbers or its push are wrong.
    `digits`: a function that returns number formats; `name_axis`: whether to name the axis behind the claim.
    """
    assert trace.shortcut
    a, b = trace.names
    says = f"By the shortcut “{trace.shortcut.claim}” {a} and {b} {RELATION_PHRASES[trace.claim]}"
    if name_axis and trace.ended_by and not _is_of_one_corner(trace, trace.ended_by):
        i = trace.tests.index(trace.ended_by)
        name = axis_name(trace.ended_by.axis, (trace.a, trace.b), trace.names)
        says += f": {outcome(trace.ended_by, digits(trace, trace.ended_by))} on axis {i + 1} ({name})"
    elif name_axis and trace.tests and not trace.ended_by:
        says += f": no gap on {_any_of_axes(len(trace.tests))}"
    is_so = RELATION_PHRASES[trace.relation]
    if trace.missed_hit or trace.false_hit:
        return f"{says}. In truth they {is_so}: a {'missed' if trace.missed_hit else 'false'} hit."
    if trace.claim is not trace.relation:
        return f"{says}. In truth they {is_so}."
    wrong: str | None = hooks.call("shortcut_error", trace, digits)
    if wrong is None:  # nobody can tell
        return f"{says}."
    return f"{says}. {wrong}" if wrong else f"{says}, and so it is."


def _mtv_sentence(trace: Trace, move: Vec | None, digits: NumberFormat) -> str:
    """Return a sentence that names the MTV `move`, or says why it is None."""
    if move is None and why_too_many_parts(trace.a, trace.b):
        return "They have too many convex parts to search for the MTV."
    if move is None:
        return "No move that float64 can hold parts them."
    return f"Moving {trace.names.b} by {digits(trace).vector(move)} leaves them just touching."


def _any_of_axes(n: int) -> str:
    """Return "the one axis", "either axis" or "any of the n axes"."""
    return "the one axis" if n == 1 else "either axis" if n == 2 else f"any of the {n} axes"


def _parts_verdict(trace: Trace, move: Vec | None, digits: NumberFormat) -> str:
    """Return a sentence on the result of a run over pairs of convex parts; `move`: the MTV of an overlap."""
    a, b = trace.names
    settling = trace.colliding
    if not settling:
        return f"{a} and {b} are apart: each of the {len(trace.pairs)} pairs of convex parts has a separating axis."
    p, q = settling.names
    if trace.relation is Relation.TOUCHING:
        return f"{a} and {b} touch: their parts {p} and {q} do, and no parts overlap. Touching is a hit."
    return f"{a} and {b} overlap: their parts {p} and {q} do. {_mtv_sentence(trace, move, digits)}"


def scene_sentence(trace: Trace) -> str:
    """Return the sentence that says what is given and asks whether the shapes collide."""
    return f"{shapes_sentence(trace)} Do they collide?"


def shapes_sentence(trace: Trace) -> str:
    """Return the sentence that names the kind of each shape: "A is a triangle, B is a circle ..."."""
    kinds = [shape_in_words(shape, "").split("is ", 1)[1] for shape in (trace.a, trace.b)]
    if kinds[0] == kinds[1] and not trace.a.core_is_point:
        return f"{trace.names.a} and {trace.names.b} are {plural(kinds[0])}."
    numbers = digits(trace)
    return f"{shape_in_words(trace.a, trace.names.a, numbers)}, {shape_in_words(trace.b, trace.names.b, numbers)}."


def plural(kind: str) -> str:
    """Return the plural of a kind of shape: "a triangle" becomes "triangles"."""
    noun = kind.split(" ", 1)[1]
    head, _, tail = noun.partition(" with")
    return f"{head}{'es' if head.endswith('x') else 's'}{' with' if tail else ''}{tail}"


def parts_sentence(trace: Trace) -> str:
    """Return a sentence that names the convex parts into which each concave shape of the trace is split."""
    names = [[name for _, name in named_parts(s, n)] for s, n in zip((trace.a, trace.b), trace.names)]
    split = [f"{n} is split into {join_words(ps)}" for ps, n in zip(names, trace.names) if len(ps) > 1]
    return f"{' and '.join(split)}: the shapes collide only if two of their convex parts do."


def stage_sentence(trace: Trace, i: int, name: str, first: str) -> str:
    """Return the sentence for the drawing stage `name` of test `i`; `first`: "A" or "B", whose points drop first.

    `name`: "edge", "normal", "axis", "drops", "range" or "both ranges"; any other gives `test_sentence`.
    """
    t = trace.tests[i]
    shapes = trace.a, trace.b
    at = "AB".index(first)
    side, owner, numbers = (t.a, t.b)[at], trace.names[at], digits(trace, t)
    axis = f"axis {i + 1}"
    if name == "edge":
        return f"{_origin(trace, t.axis)}."
    if name == "normal":
        of = f"{axis} of {len(trace.choice.axes)}"
        if t.source.kind not in FROM_EDGES:
            return f"{_origin(trace, t.axis)} gives {of} its direction."
        turned = "One sign changed makes it" if t.source.kind == SLIP else "A quarter turn makes it the normal"
        normal, direction = outward_normal(trace, t.axis), digits(trace).vector(t.axis.normal)
        made = f"{_origin(trace, t.axis)}. {turned} {normal}"
        return f"{made}, the direction of {of}." if normal == direction else f"{made}; {of} takes it as {direction}."
    if name == "axis":
        what = axis_name(t.axis, shapes, trace.names)
        return f"Axis {i + 1}, {what}, moved clear of the shapes: direction {vector(t.axis.direction)}."
    if name == "drops":
        lo, hi = (numbers.landing(end) for end in side.interval)
        return f"{owner}'s points dropped onto {axis}: the lowest lands at {lo}, the highest at {hi}."
    if name == "range":
        return f"{owner}'s range on {axis} is {numbers.ranges(t)[at]}."
    if name == "both ranges":
        return f"Both ranges on {axis}: {both_ranges(trace, t, numbers)}."
    return test_sentence(trace, i)


def _origin(trace: Trace, axis: Axis) -> str:
    """Return in words the edge, with its vector, or the line that an axis was made from."""
    kind, role, ids = axis.source
    if kind == CENTERS:
        return f"The line through the centers of {trace.names.a} and {trace.names.b}"
    at = int(role == "B")
    shape, name = (trace.a, trace.b)[at], trace.names[at]
    ends = [vertex_name(shape, name, i) for i in ids]
    if kind == VERTEX:
        return f"The line through {name}'s nearest vertex {ends[0]} and the center of {trace.names[1 - at]}"
    p, q = (shape.vertices[i] for i in ids)
    what = "Hull edge" if kind == HULL else "Edge"
    return f"{what} {edge_name(ends)} of {name}: {edge_vector(trace, ends, p, q)}"


def points_outward(trace: Trace, axis: Axis) -> bool:
    """Return whether the axis of an edge's normal points out of its shape; True for axes of other kinds.

    Outward is right of an edge that is walked counter-clockwise.
    """
    kind, role, ids = axis.source
    if kind not in (EDGE, HULL):
        return True
    polygon = trace.b if role == "B" else trace.a
    p, q = (polygon.vertices[i] for i in ids)
    if kind == HULL:
        start, n = p, axis.normal
        return all(n.x * (v.x - start.x) + n.y * (v.y - start.y) <= 0 for v in polygon.core)
    i, j = polygon.core.index(p), polygon.core.index(q)
    if (i + 1) % len(polygon.core) != j:
        p, q = q, p
    return (q.y - p.y) * axis.normal.x + (p.x - q.x) * axis.normal.y >= 0


def outward_normal(trace: Trace, axis: Axis) -> str:
    """Return as text the outward normal that an axis comes from; the axis may have the opposite direction."""
    n = axis.normal
    return digits(trace).vector(n if points_outward(trace, axis) else Vec(0.0 - n.x, 0.0 - n.y))


def edge_vector(trace: Trace, ends: Sequence[str], p: Vec, q: Vec) -> str:
    """Return an edge as its ends' difference in text, from p and q with their names: "v1 - v2 = (-3, 2)"."""
    return f"{ends[0]} {MINUS} {ends[1]} = {digits(trace).vector(Vec(p.x - q.x, p.y - q.y))}"


def join_words(words: list[str]) -> str:
    """Return words as a list in a sentence: "x, y and z"."""
    if len(words) == 1:
        return words[0]
    return ", ".join(words[:-1]) + " and " + words[-1]


def shape_in_words(shape: Shape, name: str, numbers: Digits | None = None) -> str:
    """Return a sentence about a shape: "A is a triangle", "B is a circle of radius 1 around (2, 2)".

    `numbers`: the number format of a circle, by default one that fits its size.
    """
    if shape.core_is_point:
        numbers = numbers or digits_for_shapes(shape)
        return f"{name} is a circle of radius {numbers.number(shape.radius)} around {numbers.vector(shape.core[0])}"
    n = len(shape.core)
    kind = {3: "triangle", 4: "quadrilateral"}.get(n, f"polygon with {n} corners")
    if shape.is_upright_box:
        kind = "upright box"
    what = kind if shape.is_convex else f"concave {kind}"
    return f"{name} is {'an' if what[0] in 'u' else 'a'} {what}"
