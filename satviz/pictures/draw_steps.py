"""The drawing of one step on a sketch: a test as far as its stage goes, convex parts, the proof of the verdict."""

from collections.abc import Collection, Sequence

from ..engine import describe
from ..engine.certificate import PartLines, SeparatingLine, SharedPoint
from ..engine.convex_parts import named_parts
from ..engine.geometry import Relation, Vec
from ..engine.trace import Trace, record
from .axis_place import AxisPlace
from .float_geometry import midpoint, moved_shape, point_along
from .sketch import Sketch
from .stages import Stage, first_dropped_role

MAX_PART_LINES = 4  # separating lines between convex parts, in one picture
MAX_TITLED_PARTS = 3  # if a shape has more convex parts, their names are drawn in small letters


def draw_test(sketch: Sketch, stage: Stage, i: int, place: AxisPlace | None) -> None:
    """Draw test `i` (from 0) of the sketch's trace up to a stage; `place` is None at stages before the axis."""
    trace = sketch.trace
    test = trace.tests[i]
    sketch.shapes()
    if not any(test.axis.normal):
        return sketch.no_axis(test)
    sketch.edge(test, named=stage in (Stage.EDGE, Stage.NORMAL))
    if stage is not Stage.EDGE:
        sketch.normal(test, named=stage in (Stage.NORMAL, Stage.AXIS))
    if place is None:
        return
    sketch.axis(test, place)
    if stage is Stage.AXIS:
        sketch.slide(test, place)
    one = first_dropped_role(trace, i)
    other = "B" if one == "A" else "A"
    if stage is Stage.DROPS:
        sketch.drops(test, place, one, ends_only=False, named=True)
    if stage in (Stage.RANGE, Stage.BOTH, Stage.GAP):
        for role in one if stage is Stage.RANGE else (one, other):
            sketch.drops(test, place, role, ends_only=True, named=False)
            sketch.range(test, place, role)
    if stage is Stage.GAP:
        sketch.gap(test, place, interval=not trace.shortcut)
        if trace.shortcut:
            return
        if test.separates:
            sketch.untested_axes()
        sketch.note("conclusion", describe.conclusion(trace, i), "ink", first=3)


def draw_other_parts(sketch: Sketch, whole: Trace, run: Trace) -> None:
    """Draw faintly the convex parts of both shapes of `whole`, except the two that `run` tests."""
    for role, name, shape in zip("AB", whole.names, (whole.a, whole.b), strict=True):
        for part, part_name in named_parts(shape, name):
            if part_name not in run.names:
                sketch.shape(role, part_name, part, weight="faint", named=False)


def draw_parts(sketch: Sketch, named: Collection[str] | None = None) -> None:
    """Draw both shapes as their convex parts; `named`: the parts that get their names, by default all."""
    for role, name, shape in sketch.roles():
        parts = named_parts(shape, name)
        for part, part_name in parts:
            is_named = named is None or part_name in named
            sketch.shape(role, part_name, part, named=is_named, quiet=len(parts) > MAX_TITLED_PARTS)


def draw_verdict(sketch: Sketch, places: Sequence[AxisPlace], *, named: bool = True) -> None:
    """Draw the proof of the verdict: a separating line and its axis, or a point in both shapes and the MTV.

    `places`: that of the separating axis, if there is one.
    `named` adds the relation in words, and the coordinates of the point.
    """
    trace = sketch.trace
    certificate = trace.certificate
    if isinstance(certificate, PartLines):
        draw_part_lines(sketch)
    else:
        sketch.shapes()
    if named and trace.false_hit:
        sketch.note("verdict", describe.claim_and_truth(trace), "wrong", weight="title", first=1)
    elif named:
        sketch.note("verdict", str(trace.relation), "ink", weight="title", first=1)
    if isinstance(certificate, SeparatingLine):
        draw_separating_line(sketch, certificate)
        if trace.separating:
            sketch.project(trace.separating, places[0], drops=False)
    elif isinstance(certificate, SharedPoint):
        if trace.colliding:
            for role, name, shape in Sketch(trace.colliding, sketch.layout).roles():
                if name not in trace.names:
                    sketch.shape(role, name, shape, quiet=True)
        spot = certificate.point
        sketch.add("shared", "dot", "ink", spot)
        text = f"a point in both: {describe.digits(trace).vector(spot)}" if named else "in both"
        sketch.label("shared-name", text, "ink", spot, first=4)
        draw_mtv_of_overlap(sketch)


def draw_part_lines(sketch: Sketch) -> None:
    """Draw the convex parts, and a separating line for each of the 4 nearest pairs, named by the pair."""
    whole = record(sketch.trace.a, sketch.trace.b)
    apart = [(pair.separating.gap, n, pair) for n, pair in enumerate(whole.pairs, 1) if pair.separating]
    nearest = sorted(apart)[:MAX_PART_LINES]
    draw_parts(sketch, {name for *_, pair in nearest for name in pair.names})
    sketch.insets()
    for _, n, pair in nearest:
        line = pair.certificate
        assert isinstance(line, SeparatingLine)  # an axis separates the pair
        ends = sketch.line_across("part-line", line.point, _unit_normal(line), "gap", n)
        text, middle = f"between\n{pair.names.a} and {pair.names.b}", midpoint(*ends)
        along = *ends, *(midpoint(middle, end) for end in ends)
        sketch.label("part-line-name", text, "gap", middle, number=n, along=along, first=4, near=True)
    if more := len(apart) - len(nearest):
        sketch.note("more-lines", f"and {more} more lines, one for each pair of parts", "guide")


def draw_mtv_of_overlap(sketch: Sketch) -> None:
    """Draw the MTV of an overlap from a point in both shapes; draw nothing for other relations."""
    trace = sketch.trace
    move = trace.known_mtv
    if trace.relation is not Relation.OVERLAPPING or move is None:
        return
    certificate = trace.certificate
    assert isinstance(certificate, SharedPoint)  # as of all that overlap
    draw_mtv(sketch, certificate.point, move)


def draw_mtv(sketch: Sketch, start: Vec, move: Vec, what: str = "MTV") -> None:
    """Draw the MTV `move` as an arrow from `start`, called `what`, and faintly B translated by it."""
    ghost = moved_shape(sketch.trace.b, move)
    sketch.shape("B", f"{sketch.trace.names.b} moved", ghost, weight="faint", named=False)
    tip = point_along(start, move, 1.0)
    sketch.add("mtv", "arrow", "move", start, tip, start=(start,))
    text = f"{what} {describe.digits(sketch.trace).vector(move)}"
    sketch.label("mtv-name", text, "move", tip, prefer=move, first=3)


def draw_separating_line(sketch: Sketch, certificate: SeparatingLine, text: str = "separating line") -> None:
    """Draw the certificate's line across the canvas, with `text` at its upper end."""
    ends = sketch.line_across("line", certificate.point, _unit_normal(certificate), "gap")
    low, high = sorted(ends, key=lambda p: p.y)
    sketch.label(
        "line-name", text, "gap", high, prefer=Vec(low.x - high.x, low.y - high.y), first=1, far=True, led=True
    )


def _unit_normal(certificate: SeparatingLine) -> Vec:
    """Return the line's normal as a unit vector, scaled from its fractions without overflow."""
    nx, ny = certificate.normal
    size = max(abs(nx), abs(ny))
    x, y = float(nx / size), float(ny / size)
    length = (x * x + y * y) ** 0.5
    return Vec(x / length, y / length)
