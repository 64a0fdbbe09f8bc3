"""Pictures that are no single step: all normals, several axes at once, lines that fail, a circle by itself."""

from collections.abc import Sequence
from math import hypot

from ..engine import digits, telling
from ..engine.axes import EDGE, GIVEN, WORLD, Choice
from ..engine.certificate import SeparatingLine
from ..engine.concave import named_parts
from ..engine.geometry import Vec
from ..engine.sat import AxisTest
from ..engine.shapes import Circle, Polygon, Shape
from ..engine.trace import Trace, record
from .layout import arrange
from .marks import Picture
from .sketch import Sketch
from .stages import FALSE_HIT, draw_parts, scene_layout, separating_line


def alone(shape: Shape) -> Picture:
    """One shape by itself."""
    sketch = Sketch(record(shape, shape, axes=Choice(())), arrange([shape], []))
    sketch.shape("A", "A", shape, named=False)
    if isinstance(shape, Polygon) and shape.labels:
        sketch.vertices("A", range(len(shape.vertices)))
    return sketch.finish("", f"{telling.shape_in_words(shape, 'This')}.")


def normals(trace: Trace, *, title: str = "") -> Picture:
    """Both shapes with an outward normal on every edge."""
    sketch = Sketch(trace, scene_layout(trace))
    sketch.shapes()
    sketch.all_normals()
    count = sum(mark.kind == "arrow" for mark in sketch.marks)
    return sketch.finish(title, f"{telling.both(trace)} Each of the {count} edges has a normal.")


def world(trace: Trace, *, title: str = "") -> Picture:
    """Both shapes beside the axes they will be projected on, with nothing projected yet."""
    layout = scene_layout(trace)
    sketch = Sketch(trace, layout)
    sketch.shapes()
    for test, place in zip(trace.tests, layout.places, strict=True):
        sketch.axis(test, place)
    # projecting starts with y, as in the article, but one says x and y
    names = sorted(telling.axis_name(t.axis, (trace.a, trace.b), trace.names) for t in trace.tests)
    return sketch.finish(title, f"{telling.both(trace)} They will be projected on {telling.listed(names)}.")


def at_once(trace: Trace, *, kinds: Sequence[str] = (EDGE, WORLD, GIVEN), title: str = "") -> Picture:
    """Several finished tests in one picture: every axis of the given kinds with both ranges."""
    chosen = [(i, t) for i, t in enumerate(trace.tests) if t.source.kind in kinds]
    layout = arrange([trace.a, trace.b], [t for _, t in chosen], together=True)
    sketch = Sketch(trace, layout)
    sketch.shapes()
    for (_, test), place in zip(chosen, layout.places, strict=True):
        sketch.project(test, place)
    if trace.false_hit:
        sketch.note("false-hit", FALSE_HIT, "overlap")
    rest = [
        telling.short_axis_name(t.axis, (trace.a, trace.b), trace.names)
        for t in trace.tests
        if t.source.kind not in kinds
    ]
    if rest:
        sketch.note("rest", f"not shown: {', '.join(rest)}", "guide")
    tests = " ".join(telling.test(trace, i) for i, _ in chosen)
    return sketch.finish(title, f"{tests} {trace.sentence}")


def separation(trace: Trace, *, title: str = "") -> Picture:
    """The separating axis and the separating line, each named: the line runs across the axis."""
    test, certificate = trace.separating, trace.certificate
    assert test and isinstance(certificate, SeparatingLine)  # it is for shapes that an axis separates
    layout = scene_layout(trace)
    sketch = Sketch(trace, layout)
    sketch.shapes()
    place = layout.places[trace.tests.index(test)]
    sketch.axis(test, place)
    name = telling.axis_name(test.axis, (trace.a, trace.b), trace.names)
    text = f"separating axis: {name.removeprefix('the ').removesuffix(' axis')}"
    along = tuple(place.at(place.lo + (place.hi - place.lo) * part) for part in (0.5, 0.2, 0.8))
    sketch.label("axis-caption", text, "ink", along[0], along=along[1:], prefer=place.out, first=1)
    for role in "AB":
        sketch.range(test, place, role)
    sketch.gap(test, place)
    line = telling.line(certificate)
    separating_line(sketch, certificate, f"separating line: {line}")
    return sketch.finish(
        title, f"The separating axis is {name}; the separating line {line} runs across it, through the gap."
    )


def radii(trace: Trace, *, title: str = "") -> Picture:
    """Two circles: centers, radii, and the distance between the centers against the sum of the radii."""
    a, b, test = trace.a, trace.b, trace.tests[0]
    assert isinstance(a, Circle) and isinstance(b, Circle)
    layout = scene_layout(trace)
    sketch = Sketch(trace, layout)
    p, q = a.center, b.center
    sketch.shapes()
    sketch.add("distance", "segment", "ink", p, q)
    for role, circle in ("A", a), ("B", b):
        sketch.add("center", "dot", role, circle.center, owner=role)
        across = Vec(-test.axis.direction.y, test.axis.direction.x)
        rim = Vec(circle.center.x + across.x * circle.radius, circle.center.y + across.y * circle.radius)
        sketch.add("radius", "segment", role, circle.center, rim, owner=role)
        half = sketch.middle(circle.center, rim)
        text = f"r{'12'[role == 'B']} = {digits.number(circle.radius)}"
        sketch.label("radius-name", text, role, half, owner=role, prefer=Vec(-1.0, 0.3), first=1)
    # on this axis the gap is the distance less both radii, so the trace has the distance
    reach = a.radius + b.radius
    distance = digits.number(test.gap + reach)
    compare = ">" if test.gap > 0 else "<" if test.gap < 0 else "="
    sketch.label("distance-name", f"distance {distance}", "ink", sketch.middle(p, q), prefer=Vec(0.3, -1.0), first=1)
    for role in "AB":
        sketch.range(test, layout.places[0], role)
    sketch.axis(test, layout.places[0])
    sketch.gap(test, layout.places[0])
    words = f"distance {distance} {compare} r1 + r2 = {digits.number(reach)}"
    sketch.note("verdict", words, "ink", first=2)
    return sketch.finish(
        title, f"The centers lie {words.replace('distance ', '', 1)} apart. {trace.sentence}", steady=False
    )


def circle_alone(trace: Trace, number: int, role: str, *, extremes: bool, title: str = "") -> Picture:
    """The circle of a circle and polygon pair with one axis: its parts, or the two points that land furthest."""
    test = trace.tests[number]
    side, circle = (test.a, trace.a) if role == "A" else (test.b, trace.b)
    assert isinstance(circle, Circle)
    name = trace.names["AB".index(role)]
    layout = arrange([circle], [test._replace(a=side, b=side)])
    place = layout.places[0]
    sketch = Sketch(trace, layout)
    sketch.shape(role, name, circle, named=False)
    sketch.axis(test, place, told=False)
    sketch.label("axis-caption", "axis, direction n", "ink", place.at(place.hi), prefer=test.axis.direction, first=1)
    sketch.add("center", "dot", role, circle.center)
    p2, p1 = side.points
    n = test.axis.direction
    if not extremes:
        rim = Vec(circle.center.x - n.y * circle.radius, circle.center.y + n.x * circle.radius)
        sketch.add("radius", "segment", role, circle.center, rim)
        text = f"radius r = {digits.number(circle.radius)}"
        sketch.label("radius-name", text, role, sketch.middle(circle.center, rim), prefer=n, first=1)
        sketch.label("center-name", "center C", role, circle.center, prefer=Vec(0.0, -1.0), first=2)
        words = f"A circle has no edges: its center C {digits.vector(circle.center)} and radius"
        return sketch.finish(title, f"{words} {digits.number(circle.radius)} are all that a projection needs.")
    sketch.add("diameter", "segment", role, p2, p1)
    sketch.label("center-name", "C", role, circle.center, prefer=Vec(-n.y, n.x), first=2)
    for i, point, landing, sign in (1, p1, side.landings[1], "+"), (2, p2, side.landings[0], "-"):
        spot = place.at(landing)
        sketch.add("drop", "segment", "guide", point, spot, number=i)
        sketch.add("dropped", "dot", role, point, number=i)
        sketch.add("landing", "dot", role, spot, number=i)
        away = Vec(point.x - circle.center.x, point.y - circle.center.y)
        sketch.label("dropped-name", f"P{i} = C {sign} r n", role, point, number=i, prefer=away, first=1)
        sketch.label("landing-name", digits.number(landing), role, spot, number=i, prefer=place.out, first=1)
    return sketch.finish(
        title,
        f"The extremes along an axis of direction n = {digits.vector(n)} are P1 = C + r n {digits.vector(p1)} "
        f"and P2 = C - r n {digits.vector(p2)}; they land at {digits.number(side.landings[1])} "
        f"and {digits.number(side.landings[0])}.",
    )


def failed_lines(trace: Trace, *, most: int = 3, title: str = "") -> Picture:
    """The lines that come nearest to separating, one a direction, each with the overlap it leaves."""
    best: list[AxisTest] = []
    for test in sorted(trace.tests, key=lambda t: -t.gap):
        if all(test.axis.direction != other.axis.direction for other in best):
            best.append(test)
    layout = arrange([trace.a, trace.b], [])
    sketch = Sketch(trace, layout)
    sketch.shapes()
    for i, test in enumerate(best[:most], 1):
        a, b, n = test.a.interval, test.b.interval, test.axis.direction
        middle = (max(a.lo, b.lo) + min(a.hi, b.hi)) / 2
        ends = sketch.line_across("failed-line", Vec(n.x * middle, n.y * middle), n, "overlap", i)
        x0, y0, x1, y1 = layout.limits
        end = max(ends, key=lambda p: hypot(p.x - x0, p.y - y0) + (p.y - y0) * 0.1)
        inwards = Vec((x0 + x1) / 2 - end.x, (y0 + y1) / 2 - end.y)
        text = f"fails: gap {telling.digits(trace, test).signed(test.gap)}"
        sketch.label("failed-line-name", text, "overlap", end, number=i, prefer=inwards, first=1)
    worst = telling.digits(trace, best[0]).signed(best[0].gap)
    return sketch.finish(
        title,
        f"No line separates {trace.names.a} and {trace.names.b}: the best gap is {worst}. {trace.sentence}",
        steady=False,
    )


def split(trace: Trace, *, title: str = "") -> Picture:
    """Concave outlines as their parts, each part pair with the axis that separates it."""
    tests = [pair.separating for pair in trace.pairs]
    layout = arrange([trace.a, trace.b], [t for t in tests if t], together=True)
    sketch = Sketch(trace, layout)
    draw_parts(sketch)
    places = iter(layout.places)
    for pair, test in zip(trace.pairs, tests, strict=True):
        if test:
            inner = Sketch(pair, layout, f"{pair.names.a}.{pair.names.b}.")
            inner.project(test, next(places))
            sketch.marks += inner.marks
            sketch.requests += inner.requests
    parts = [f"{n} is {telling.listed([p for _, p in found])}" for n, found in _split_shapes(trace)]
    return sketch.finish(title, f"{'; '.join(parts)}. {' '.join(p.sentence for p in trace.pairs)} {trace.sentence}")


def _split_shapes(trace: Trace) -> list[tuple[str, list[tuple[Shape, str]]]]:
    found = [(n, named_parts(s, n)) for n, s in zip(trace.names, (trace.a, trace.b), strict=True)]
    return [(n, parts) for n, parts in found if len(parts) > 1]
