"""Views: pictures that show no single step, such as all normals, several axes at once, or a circle by itself."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from math import cos, hypot, pi, sin

from ..engine import describe, number_format
from ..engine.axes import EDGE, HULL, VERTEX, WORLD, Choice
from ..engine.certificate import SeparatingLine
from ..engine.convex_parts import named_parts
from ..engine.geometry import Vec
from ..engine.sat import AxisTest
from ..engine.shapes import Circle, Polygon, Shape
from ..engine.trace import Trace, record
from .caption import with_words_below
from .draw_steps import draw_separating_line
from .float_geometry import gap_or_overlap, mean_point, midpoint, point_along
from .insets import BRACKET_PT, a_is_left
from .label_placer import LabelOptions
from .labels import short_name
from .layout import NARROW_SIZE_PT, Layout, PanelContents, arrange
from .marks import Picture
from .panels import panel_grid, with_headline
from .sketch import Sketch
from .stages import Stage, Step, step_sentence
from .step_picture import step_layouts

LOW_PANEL_PT = NARROW_SIZE_PT[0], 270.0  # size of one of several pictures below each other
QUARTER_TURN_PART = 0.45  # radius of the arc of a quarter turn, as a factor of the edge's length
STRIP_WIDTH_PT = NARROW_SIZE_PT[0] / 2  # width of one of several small multiples
MAX_FAILED_AXES = 3


def single_shape(shape: Shape) -> Picture:
    """Draw one shape by itself."""
    sketch = Sketch(record(shape, shape, axes=Choice(())), arrange([PanelContents([shape])], largest=NARROW_SIZE_PT)[0])
    sketch.shape("A", "A", shape, named=False)
    if isinstance(shape, Polygon) and shape.labels:
        sketch.vertices("A", range(len(shape.vertices)))
    return sketch.finish("", f"{describe.shape_in_words(shape, 'This')}.")


def all_normals(trace: Trace, *, title: str = "") -> Picture:
    """Draw both shapes with an outward normal on every edge."""
    sketch = Sketch(trace, step_layouts(trace, NARROW_SIZE_PT)[0])
    sketch.shapes()
    sketch.all_normals()
    count = sum(mark.kind == "arrow" for mark in sketch.marks)
    return sketch.finish(title, f"{describe.shapes_sentence(trace)} Each of the {count} edges has a normal.")


def world_axes(trace: Trace, *, title: str = "") -> Picture:
    """Draw both shapes beside the world axes, with ticks and numbers, and nothing projected yet."""
    layouts = step_layouts(trace, NARROW_SIZE_PT)
    sketch = Sketch(trace, layouts[0])
    sketch.shapes()
    for test, layout in zip(trace.tests, layouts[1:-1], strict=True):
        (place,) = layout.places
        sketch.axis(test, place)
        sketch.ticks(test, place)
    zeros = [pair for pair in sketch.requests if pair[1].part == "zero-name"]
    sketch.requests = [pair for pair in sketch.requests if pair not in zeros[1:]]  # both axes share their 0
    # tests start with y, as in the article; the sentence says x and y
    names = sorted(describe.axis_name(t.axis, (trace.a, trace.b), trace.names) for t in trace.tests)
    return sketch.finish(
        title, f"{describe.shapes_sentence(trace)} They will be projected on {describe.join_words(names)}."
    )


def quarter_turn(trace: Trace, number: int, *, title: str = "") -> Picture:
    """Draw the edge of test `number` (from 0) as a vector, and the normal as this vector after a quarter turn."""
    sketch, test = Sketch(trace, step_layouts(trace, NARROW_SIZE_PT)[0]), trace.tests[number]
    sketch.shapes()
    sketch.edge(test)
    (kind, role, ids) = test.source
    assert kind == EDGE and role
    _, polygon = sketch.named_polygon(role)
    p, q = (polygon.vertices[i] for i in ids)
    edge, n = Vec(p.x - q.x, p.y - q.y), sketch.arrow_direction(test.axis)
    length = hypot(*edge)
    tip = point_along(q, n, length)
    sketch.right_angle(q, n)
    sketch.add("normal", "arrow", "ink", q, tip, weight="strong", start=(p,))
    turn = [
        point_along(point_along(q, edge, cos(t) * QUARTER_TURN_PART), n, sin(t) * length * QUARTER_TURN_PART)
        for t in (k * pi / 24 for k in range(13))
    ]
    sketch.add("turn", "segment", "guide", *(end for piece in pairwise(turn) for end in piece))
    digits = describe.digits(trace)
    normal = Vec(n.x * length, n.y * length)
    pieces = (
        ("edge ", "guide"),
        (digits.vector(edge), role),
        (" \u2192 normal ", "guide"),
        (digits.vector(normal), "ink"),
    )
    text = "".join(piece for piece, _ in pieces)
    sketch.label("turn-name", text, "ink", tip, pieces=pieces, prefer=Vec(1.0, 1.0), first=1)
    return sketch.finish(title, step_sentence(trace, Step(Stage.NORMAL, number)))


def all_tests(trace: Trace, *, title: str = "") -> Picture:
    """Draw all tests in one picture, each axis with both ranges; a false hit has a second panel: the axis left out."""
    shapes = trace.a, trace.b
    missing = [max(record(*shapes).tests, key=lambda test: test.gap)] if trace.false_hit else []
    groups = [PanelContents(shapes, tests, brief=True) for tests in (trace.tests, missing) if tests]
    layout, *rest = arrange(groups, largest=NARROW_SIZE_PT)
    sketch = Sketch(trace, layout)
    if {test.source.kind for test in trace.tests} == {WORLD}:
        sketch.bounding_boxes()
    sketch.shapes()
    for test, place in zip(trace.tests, layout.places, strict=True):
        sketch.project(test, place, numbers=False)
    if missing:
        sketch.note("verdict", describe.claim_and_truth(trace), "wrong", first=1)
    tests = " ".join(describe.test_sentence(trace, i) for i in range(len(trace.tests)))
    drawn = sketch.finish(title, f"{tests} {trace.sentence}")
    panels = [drawn, *(_missing_axis(trace, test, layout) for test, layout in zip(missing, rest, strict=True))]
    sentence = " ".join(panel.sentence for panel in panels)
    return panel_grid(panels, 1, title=title, sentence=sentence) if missing else drawn


def _missing_axis(trace: Trace, test: AxisTest, layout: Layout) -> Picture:
    """Draw both shapes and `test`, on an axis that the trace's choice of axes left out."""
    sketch = Sketch(replace(trace, tests=(test,)), layout)
    sketch.shapes()
    sketch.edge(test)
    sketch.vertices(test.source.shape or "A", test.source.ids)
    sketch.normal(test)
    sketch.project(test, layout.places[0], named=False, numbers=False)
    name = describe.axis_name(test.axis, (trace.a, trace.b), trace.names)
    sketch.note("verdict", f"not tested: the {name}", "ink", first=1)
    numbers = describe.digits(trace, test)
    found = f"{describe.both_ranges(trace, test, numbers)}, {describe.outcome(test, numbers)}"
    return sketch.finish("", f"Not tested, in the lower panel: the {name}: {found}.")


def separation(trace: Trace, *, title: str = "") -> Picture:
    """Draw the separating axis and, across it, the separating line, each with its name; the shapes must be apart."""
    test, certificate = trace.separating, trace.certificate
    assert test and isinstance(certificate, SeparatingLine)
    layout = step_layouts(trace, NARROW_SIZE_PT)[-1]
    sketch = Sketch(trace, layout)
    sketch.shapes()
    (place,) = layout.places
    sketch.axis(test, place)
    name = describe.axis_name(test.axis, (trace.a, trace.b), trace.names)
    text = f"separating axis: {name.removeprefix('the ').removesuffix(' axis')}"
    along = tuple(place.at(place.lo + (place.hi - place.lo) * part) for part in (0.5, 0.2, 0.8))
    sketch.label("axis-caption", text, "ink", along[0], along=along[1:], prefer=place.out, first=3)
    for role in "AB":
        sketch.range(test, place, role)
    sketch.gap(test, place, named=False)
    gap, ends = describe.outcome(test, describe.digits(trace, test)), gap_or_overlap(test)
    near_a = place.at(ends.lo if a_is_left(test) else ends.hi)  # B's name stands on the other side of the line
    below = point_along(near_a, place.out, layout.units(BRACKET_PT[1]))
    sketch.label("gap-name", gap, "gap", below, axis=sketch.axis_id(test), prefer=place.out, first=2)
    line = certificate.equation
    draw_separating_line(sketch, certificate, f"separating line:\n{line}")
    return sketch.finish(
        title, f"The separating axis is {name}; the separating line {line} runs across it, through the {gap}."
    )


def radii(trace: Trace, *, title: str = "") -> Picture:
    """Draw two circles with radius, gap (or overlap) and radius along the line of centers, and the test on the axis."""
    a, b, test = trace.a, trace.b, trace.tests[0]
    assert isinstance(a, Circle) and isinstance(b, Circle)
    layout = step_layouts(trace, NARROW_SIZE_PT)[1]
    sketch = Sketch(trace, layout)
    digits = describe.digits(trace, test)
    (place,) = layout.places
    p, q = a.center, b.center
    way = Vec(q.x - p.x, q.y - p.y)
    size = hypot(*way) or 1.0
    n = Vec(way.x / size, way.y / size)
    rims = point_along(p, n, a.radius), point_along(q, n, -b.radius)
    sketch.shapes()
    above = Vec(-n.y, n.x) if n.x > 0 else Vec(n.y, -n.x)
    for role, circle, rim in ("A", a, rims[0]), ("B", b, rims[1]):
        sketch.add("radius", "segment", role, circle.center, rim, owner=role, weight="strong")
        sketch.add("center", "dot", role, circle.center, owner=role)
        text = f"r{'12'[role == 'B']} = {digits.number(circle.radius)}"
        sketch.label("radius-name", text, role, midpoint(circle.center, rim), owner=role, prefer=above, first=1)
    role = "gap" if test.gap >= 0 else "overlap"
    sketch.add("between", "segment", role, *rims, weight="strong")
    text = describe.outcome(test, digits)
    sketch.label("between-name", text, role, midpoint(*rims), prefer=above, first=1)
    sketch.project(test, place)
    # on this axis the gap is the distance of the centers less both radii
    radius_sum = a.radius + b.radius
    distance = digits.number(test.gap + radius_sum)
    compare = ">" if test.gap > 0 else "<" if test.gap < 0 else "="
    follows = "apart" if test.gap > 0 else "a hit"
    words = f"distance of the centers {distance} {compare} r1 + r2 = {digits.number(radius_sum)}: {follows}"
    sketch.note("verdict", words, "ink", first=2)
    return sketch.finish(
        title,
        f"The centers lie {distance} apart, the radii make r1 + r2 = {digits.number(radius_sum)}. {trace.sentence}",
        steady=False,
    )


def panels_of_tests(trace: Trace, *, title: str = "") -> Picture:
    """Draw every test in a picture of its own: the axis, both ranges, and whether it separates."""
    shapes = trace.a, trace.b
    groups = [PanelContents(shapes, [t], brief=True) for t in trace.tests]
    layouts = arrange(groups, largest=LOW_PANEL_PT, least=LOW_PANEL_PT, one_frame=True)
    panels = []
    for i, (test, layout) in enumerate(zip(trace.tests, layouts, strict=True)):
        sketch = Sketch(trace, layout)
        sketch.shapes()
        sketch.edge(test)
        sketch.normal(test)
        sketch.project(test, layout.places[0], numbers=False)
        says = "a gap" if test.separates else "no gap"
        sketch.vertices(test.source.shape or "A", test.source.ids)
        kind = describe.axis_name(test.axis, shapes, trace.names)
        if test.source.kind == VERTEX:
            name, polygon = sketch.named_polygon(test.source.shape)
            kind = f"to the nearest vertex {short_name(polygon, name, test.source.ids[0])}"
        sketch.note("verdict", f"axis {i + 1}, {kind}: {says}", "ink", first=1)
        panels.append(sketch.finish("", ""))
    tests = " ".join(describe.test_sentence(trace, i) for i in range(len(trace.tests)))
    drawn = panel_grid(panels, 1, title=title, sentence=f"{tests} {trace.sentence}")
    return with_headline(drawn, describe.verdict_in_brief(trace))


def single_circle(trace: Trace, number: int, role: str, *, extremes: bool, title: str = "") -> Picture:
    """Draw circle `role` ("A" or "B") on the axis of test `number` (from 0): center and radius, or both extremes."""
    test = trace.tests[number]
    side, circle = (test.a, trace.a) if role == "A" else (test.b, trace.b)
    assert isinstance(circle, Circle)
    name = trace.names["AB".index(role)]
    (layout,) = arrange([PanelContents([circle], [test._replace(a=side, b=side)])], largest=NARROW_SIZE_PT)
    place = layout.places[0]
    sketch = Sketch(trace, layout)
    sketch.shape(role, name, circle, named=False)
    sketch.axis(test, place, named=False)
    sketch.label("axis-caption", "axis, direction n", "ink", place.at(place.hi), prefer=test.axis.direction, first=1)
    sketch.add("center", "dot", role, circle.center)
    digits = describe.digits(trace, test)
    p2, p1 = side.points
    n = test.axis.direction
    sketch.add("direction", "arrow", "ink", circle.center, point_along(circle.center, n, 1.0), weight="strong")
    tip = point_along(circle.center, n, 1.0)
    sketch.label("direction-name", "n, length 1", "ink", tip, prefer=Vec(n.y, -n.x), first=1)
    if not extremes:
        rim = Vec(circle.center.x - n.y * circle.radius, circle.center.y + n.x * circle.radius)
        sketch.add("radius", "segment", role, circle.center, rim)
        text = f"radius\nr = {digits.number(circle.radius)}"
        sketch.label("radius-name", text, role, midpoint(circle.center, rim), prefer=Vec(-n.x, -n.y), first=1)
        sketch.label("center-name", "center C", role, circle.center, prefer=Vec(1.0, -0.5), first=2)
        words = f"A circle has no edges: its center C {digits.vector(circle.center)} and radius"
        return sketch.finish(title, f"{words} {digits.number(circle.radius)} are all that a projection needs.")
    sketch.add("diameter", "segment", role, p2, p1)
    sketch.label("center-name", "C", role, circle.center, prefer=Vec(-n.y, n.x), first=2)
    for i, point, landing, sign in (1, p1, side.landings[1], "+"), (2, p2, side.landings[0], "−"):
        spot = place.at(landing)
        sketch.add("drop", "segment", "guide", point, spot, number=i)
        sketch.add("dropped", "dot", role, point, number=i)
        sketch.add("landing", "dot", role, spot, number=i)
        if i == 1:
            sketch.right_angle_at_axis(test, place, point, spot)
        away = Vec(point.x - circle.center.x, point.y - circle.center.y)
        sketch.label("dropped-name", f"P{i} = C {sign} r n", role, point, number=i, prefer=away, first=1)
        sketch.label("landing-name", digits.landing(landing), role, spot, number=i, prefer=place.out, first=1)
    return sketch.finish(
        title,
        f"The extremes along an axis of direction n = {number_format.vector(n)} are P1 = C + r n {digits.vector(p1)} "
        f"and P2 = C − r n {digits.vector(p2)}; they land at {digits.landing(side.landings[1])} "
        f"and {digits.landing(side.landings[0])}.",
    )


def failed_axes(trace: Trace, *, title: str = "") -> Picture:
    """Draw the 3 axes of different directions that come nearest to separating, and the gap of each pair of parts."""
    best: list[AxisTest] = []
    for test in sorted(trace.tests, key=lambda t: -t.gap):
        if all(test.axis.direction != other.axis.direction for other in best):
            best.append(test)
    shown = best[:MAX_FAILED_AXES]
    (layout,) = arrange([PanelContents([trace.a, trace.b], shown, brief=True)], largest=NARROW_SIZE_PT)
    sketch = Sketch(trace, layout)
    sketch.shapes()
    digits = describe.digits(trace, *shown)
    for test, place in zip(shown, layout.places, strict=True):
        sketch.axis(test, place, named=False)
        kind = "across the dent" if test.source.kind == HULL and not _is_edge(trace, test) else "edge normal"
        text = f"{kind}:\n{describe.gap_in_words(test.gap, digits)}"
        options: LabelOptions = {"axis": sketch.axis_id(test), "along": (place.at(place.lo),), "prefer": place.n}
        sketch.label("axis-caption", text, "ink", place.at(place.hi), first=1, **options)
        for role in "AB":
            sketch.range(test, place, role, numbers=False)
        sketch.gap(test, place, named=False)
        _draw_line_that_cuts(sketch, test)
    for n, pair in enumerate(record(trace.a, trace.b).pairs, 1):
        if pair.separating:
            _draw_distance(sketch, pair, pair.separating, n)
    worst = digits.gap(best[0].gap)
    drawn = sketch.finish(
        title,
        f"The {len(shown)} axes shown, of {len(trace.tests)} tested, come nearest to a gap between {trace.names.a} and "
        f"{trace.names.b}: their least overlap is {worst}. {trace.sentence}",
        steady=False,
    )
    words = f"Each dotted line cuts {trace.names.b}: no axis shows a gap.\nYet they are apart."
    words += f" Shown: {len(shown)} of {len(trace.tests)} axes." if len(shown) < len(trace.tests) else ""
    return with_words_below(drawn, words)


def _draw_line_that_cuts(sketch: Sketch, test: AxisTest) -> None:
    """Draw faintly the line across an axis that leaves A on one side; it cuts B, since the ranges overlap."""
    middle = (test.b.interval.lo + test.b.interval.hi) / 2
    ends = test.a.interval
    edge = ends.lo if abs(ends.lo - middle) < abs(ends.hi - middle) else ends.hi
    n = test.axis.direction
    sketch.line_across("cuts", Vec(n.x * edge, n.y * edge), n, "guide", sketch.test_number(test))


def _is_edge(trace: Trace, test: AxisTest) -> bool:
    """Check whether the hull edge that a test's axis comes from is also an edge of the outline."""
    shape = trace.a if test.source.shape == "A" else trace.b
    i, j = test.source.ids
    return (j - i) % len(shape.core) in (1, len(shape.core) - 1)


def _draw_distance(sketch: Sketch, pair: Trace, test: AxisTest, number: int) -> None:
    """Draw the gap of two convex parts on a test's axis, as a segment from A's part to B's part."""
    sign = 1 if test.b.interval.lo >= test.a.interval.hi else -1
    end = test.a.interval.hi if sign > 0 else test.a.interval.lo
    facing = [p for p, t in zip(test.a.points, test.a.landings, strict=True) if t == end]
    start = mean_point(facing)
    stop = point_along(start, test.axis.direction, sign * test.gap)
    sketch.add("distance", "segment", "gap", start, stop, weight="strong", number=number)
    text = describe.digits(pair, test).gap(test.gap)
    sketch.label("distance-name", text, "gap", midpoint(start, stop), number=number, first=0)


def convex_parts(trace: Trace, *, title: str = "") -> Picture:
    """Draw each pair of convex parts in a panel of its own, with the axis that separates it; tints tell parts apart."""
    tests = [pair.separating for pair in trace.pairs]
    groups = [PanelContents([trace.a, trace.b], [test] if test else []) for test in tests]
    layouts = arrange(groups, largest=LOW_PANEL_PT, least=LOW_PANEL_PT, one_frame=True)
    panels = []
    for pair, test, layout in zip(trace.pairs, tests, layouts, strict=True):
        sketch = Sketch(pair, layout)
        for role, name, shape in zip("AB", trace.names, (trace.a, trace.b), strict=True):
            for i, (part, part_name) in enumerate(named_parts(shape, name)):
                sketch.shape(role, part_name, part, weight="tint" if i % 2 else "plain")
        if test:
            sketch.project(test, layout.places[0])
        sketch.note("verdict", f"{' and '.join(pair.names)}: {pair.relation}", "ink", first=1)
        panels.append(sketch.finish("", "", steady=False))
    parts = [f"{n} is {describe.join_words([p for _, p in found])}" for n, found in _split_shapes(trace)]
    sentence = f"{'; '.join(parts)}. {' '.join(p.sentence for p in trace.pairs)} {trace.sentence}"
    return panel_grid(panels, 1, title=title, sentence=sentence)


def strip(pictures: Sequence[tuple[str, Picture]], *, title: str = "") -> Picture:
    """Return one picture of small multiples, given as (words, picture): two in a row, each with its words below it.

    Each keeps its marks and the names of the shapes; other labels would be too small to read.
    """
    panels, sentences = [], []
    for words, picture in pictures:
        marks = tuple(m for m in picture.marks if m.kind != "label" or m.part == "name")
        marks = tuple(m for m in marks if not m.part.endswith("-leader"))
        size = STRIP_WIDTH_PT, STRIP_WIDTH_PT * picture.size[1] / picture.size[0]
        panels.append(with_words_below(picture._replace(marks=marks, size=size), words))
        sentences.append(picture.sentence)
    return panel_grid(panels, 2, title=title, sentence=" ".join(dict.fromkeys(sentences)))


def _split_shapes(trace: Trace) -> list[tuple[str, list[tuple[Shape, str]]]]:
    """Return (name, its parts with their names) for each shape that has several convex parts."""
    found = [(n, named_parts(s, n)) for n, s in zip(trace.names, (trace.a, trace.b), strict=True)]
    return [(n, parts) for n, parts in found if len(parts) > 1]
