"""What single beliefs show instead of a test: pieces, a fan of directions, digits, many pairs, frames, a distance."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from itertools import combinations, pairwise
from math import cos, hypot, pi, sin

from ..engine import describe
from ..engine.geometry import Vec
from ..engine.number_format import MINUS, number
from ..engine.sat import AxisTest, axis_tests
from ..engine.shapes import Polygon, Shape, centroid
from ..engine.trace import Trace, record
from ..scenes.failing import swept, true_value
from ..scenes.failing.claimed_value import moved as put
from ..scenes.failing.plane import hull
from .curve import unit_vector
from .float_geometry import bounding_box, midpoint, point_along
from .layout import NARROW_PAD_PT, Group, Layout
from .layout import arrange as arranged
from .letters import text_size, wrap_text
from .sketch import Sketch

arrange = partial(arranged, pad=NARROW_PAD_PT)
Panel = Callable[[Trace, tuple[float, float]], Sketch]
FEW = 12  # dots that stand for many shapes
MOST_AXES = 3  # that have room side by side
ARROW = 74.0  # points


def pieces(trace: Trace, largest: tuple[float, float]) -> Sketch:
    """A in the pieces that are taken one by one, and where each would push B."""
    sketch = Sketch(trace, _room(trace, largest))
    draw_pieces(sketch)
    return sketch


def draw_pieces(sketch: Sketch) -> None:
    """The same on a sketch that is there."""
    trace = sketch.trace
    for pair in trace.pairs:
        sketch.shape("A", pair.names.a, pair.a)
    sketch.shape("B", trace.names.b, trace.b)
    for i, pair in enumerate(trace.pairs):
        if pair.mtv:
            start = centroid(trace.b)
            tip = point_along(start, pair.mtv, 1.0)
            sketch.add("mtv", "arrow", "move", start, tip, number=i, start=(start,))
            text = f"{pair.names.a}: push {describe.digits(trace).vector(pair.mtv)}"
            sketch.label("mtv-name", text, "move", tip, number=i, prefer=pair.mtv, first=3, far=True)
    if trace.push:
        sketch.note("push-name", f"in all: push {describe.digits(trace).vector(trace.push)}", "move", first=2)


def fan(trace: Trace, largest: tuple[float, float]) -> Sketch:
    """The first and the last direction that separates, and a few between, from the middle of the gap."""
    if trace.truth.pairs:
        return plain(trace, largest)
    test = max(trace.truth.tests, key=lambda test: test.gap)
    sketch = Sketch(trace, arrange([Group([trace.a, trace.b], [test])], largest=largest)[0])
    sketch.shapes()
    if test.gap <= 0:
        return sketch
    ends = true_value.fan(trace.a, trace.b)
    n = test.axis.direction
    nearest = (max(test.a.interval.lo, test.b.interval.lo) + min(test.a.interval.hi, test.b.interval.hi)) / 2
    p, q = centroid(trace.a), centroid(trace.b)
    across = ((p.x + q.x) * -n.y + (p.y + q.y) * n.x) / 2
    start = Vec(n.x * nearest - n.y * across, n.y * nearest + n.x * across)
    turns = [ends[0] + (ends[1] - ends[0]) * i / 4 for i in range(5)]
    ways = [Vec(n.x * c.x - n.y * c.y, n.x * c.y + n.y * c.x) for c in map(unit_vector, turns)]
    x0, y0, x1, y1 = sketch.layout.limits
    room = min(x1 - start.x, start.x - x0, y1 - start.y, start.y - y0)
    for i, (turn, u) in enumerate(zip(turns, ways, strict=True)):
        tip = point_along(start, u, min(sketch.layout.units(ARROW), room))
        sketch.add("fan", "arrow", "gap", start, tip, number=i, weight="strong" if i in (0, 4) else "plain")
        if i in (0, 4):
            sketch.label("fan-name", f"{number(round(turn, 2))}°", "gap", tip, number=i, prefer=u, first=1)
    return sketch


def digits(exact: bool) -> Panel:
    """Where B's vertices land on the normal of its first edge, to the last digit."""

    def panel(trace: Trace, largest: tuple[float, float]) -> Sketch:
        test = first_of_b(trace)
        sketch = Sketch(trace, arrange([Group([trace.a, trace.b], [test] if test else [])], largest=largest)[0])
        sketch.shapes()
        if test is None:
            return sketch
        if exact:
            test = next(axis_tests(trace.a, trace.b, [test.axis]))
        place = sketch.layout.places[0]
        sketch.trace = _only(trace, test)
        sketch.edge(test)
        sketch.axis(test, place)
        sketch.drops(test, place, "B", ends_only=False, named=False)
        top = [i for i, t in enumerate(test.b.landings) if abs(t - test.b.interval.hi) < 1e-9 * abs(t)]
        name, polygon = sketch.named_polygon("B")
        lines = {i: f"{describe.vertex_name(polygon, name, polygon.corner_ids[i])} {test.b.landings[i]!r}" for i in top}
        text = "\n".join(lines[i] for i in sorted(top))
        sketch.label("landing-name", text, "B", place.at(test.b.interval.hi), prefer=place.out, first=1)
        return sketch

    return panel


def first_of_b(trace: Trace) -> AxisTest | None:
    """The test on the normal of B's first edge."""
    return next((test for test in trace.tests if test.source[1:] == ("B", (0, 1))), None)


def crowd(every_pair: bool) -> Panel:
    """A few dots for the many shapes, each looked at once, or joined to every other."""

    def panel(trace: Trace, largest: tuple[float, float]) -> Sketch:
        x0, y0, x1, y1 = 0.0, 0.0, 300.0, 220.0
        sketch = Sketch(trace, Layout((x0, y0, x1, y1), (x1, y1), ()))
        turns = [2 * pi * (i + 0.5) / FEW for i in range(FEW)]
        dots = [Vec(150.0 + 80.0 * cos(t), 95.0 + 80.0 * sin(t)) for t in turns]
        if every_pair:
            joined = tuple(end for i, p in enumerate(dots) for q in dots[:i] for end in (p, q))
            sketch.add("pairs", "segment", "guide", *joined)
        for i, spot in enumerate(dots):
            sketch.add("shape", "dot", "A", spot, number=i)
        tests = FEW * (FEW - 1) // 2 if every_pair else FEW
        what = f"{FEW} shapes, {tests} {'pairs' if every_pair else 'tests'}"
        sketch.label("few", what, "guide", Vec(150.0, 95.0), prefer=Vec(0.0, -1.0), first=1, far=True)
        return sketch

    return panel


def support_points(trace: Trace, largest: tuple[float, float]) -> Sketch:
    """The difference of both shapes, and a triangle of support points round the origin, as GJK finds one at best."""
    corners = [Vec(q.x - p.x, q.y - p.y) for p in trace.a.vertices for q in trace.b.vertices]
    if len(corners) < 3:
        return plain(trace, largest)
    best = max(record(trace.a, trace.b, every_axis=True).tests, key=lambda test: test.gap, default=None)
    if best is None:
        return plain(trace, largest)  # with a dent B - A has none of its own
    supports = [_furthest(corners, unit_vector(45.0 * k + 10.0)) for k in range(8)]
    found = next(filter(_holds_origin, combinations(dict.fromkeys(supports), 3)), tuple(supports[::3]))
    if not trace.hit:  # one that lies nearest on the axis of a gap
        n = best.axis.direction
        way = 1.0 if best.b.interval.lo > best.a.interval.hi else -1.0
        found = (_furthest(corners, Vec(-n.x * way, -n.y * way)),)
    xs, ys = [0.0, *(v.x for v in corners)], [0.0, *(v.y for v in corners)]
    count = len(trace.a.vertices) + len(trace.b.vertices)
    rest = "and a triangle round the origin three corners" if trace.hit else "and for a miss one corner may be enough"
    wide, high = largest[0] * 0.8, largest[1] * 0.8
    lines = f"a corner of B {MINUS} A takes {count} looks,", rest
    text = "\n".join(wrap_text(line, wide - 2 * NARROW_PAD_PT) for line in lines)
    band = text_size(text)[1] + NARROW_PAD_PT  # below the picture, for words
    box = Polygon([(min(xs), min(ys)), (max(xs), min(ys)), (max(xs), max(ys)), (min(xs), max(ys))])
    layout = arrange([Group([box], [])], largest=(wide, high - band))[0]
    (x0, y0, x1, y1), (wide, high) = layout.limits, layout.size
    low = y0 - layout.units(band)
    sketch = Sketch(trace, layout._replace(limits=(x0, low, x1, y1), size=(wide, high + band)))
    rim = hull(corners)
    sketch.add("difference", "outline", "guide", *rim)
    middle = Vec(sum(v.x for v in rim) / len(rim), sum(v.y for v in rim) / len(rim))
    sketch.label("difference-name", f"B {MINUS} A", "guide", middle, prefer=Vec(1.0, -1.0), inside=True, weight="title")
    for i, v in enumerate(rim):
        sketch.add("corner", "dot", "guide", v, number=i)
    if len(found) == 3:
        sketch.add("triangle", "segment", "ink", found[0], found[1], found[1], found[2], found[2], found[0])
    for i, v in enumerate(found):
        sketch.add("support", "dot", "ink", v, number=i)
    sketch.add("origin", "dot", "wrong", Vec(0.0, 0.0))
    sketch.label("origin-name", "origin", "wrong", Vec(0.0, 0.0), first=1)
    sketch.label("looked-at", text, "guide", Vec((x0 + x1) / 2, low + layout.units(band / 2)), first=1, inside=True)
    return sketch


def _furthest(points: Sequence[Vec], n: Vec) -> Vec:
    return max(points, key=lambda p: p.x * n.x + p.y * n.y)


def _holds_origin(ring: Sequence[Vec]) -> bool:
    turns = [p.x * q.y - p.y * q.x for p, q in zip(ring, (*ring[1:], ring[0]), strict=True)]
    return min(turns) > 0 or max(turns) < 0


def looks(trace: Trace, largest: tuple[float, float]) -> Sketch:
    """The axes that SAT looks at until it is sure; of many the one that tells most, and how many there are."""
    run = record(trace.a, trace.b)
    tests = run.tests if len(run.tests) <= MOST_AXES else (_least(run),)
    sketch = Sketch(run, arrange([Group([trace.a, trace.b], tests)], largest=largest)[0])
    sketch.shapes()
    for test, place in zip(tests, sketch.layout.places, strict=True):
        sketch.project(test, place, interval=False)
    if len(run.tests) > len(tests):
        sketch.note("tested", f"one of {len(run.tests)} axes that SAT looks at", "guide", first=7)
    return sketch


def frame(trace: Trace, largest: tuple[float, float]) -> Sketch:
    """A in this frame and in the next, and the gap that is left in both."""
    test = trace.ended_by or trace.tests[0]
    after = _after(trace.a)
    layout = arrange([Group([trace.a, after, trace.b], [test])], largest=largest)[0]
    sketch = Sketch(_only(trace, test), layout)
    sketch.shapes()
    sketch.shape("A", "A next", after, weight="faint", named=False)
    sketch.label("next-name", "next frame", "A", centroid(after), prefer=Vec(0.0, 1.0), first=2)
    sketch.project(test, layout.places[0], drops=False, interval=False)
    return sketch


def flight(trace: Trace, largest: tuple[float, float]) -> Sketch:
    """A on its way, where it first and last meets B."""
    test = trace.ended_by or trace.tests[0]
    sketch = Sketch(trace, arrange([Group([trace.a, _after(trace.a), trace.b], [test])], largest=largest)[0])
    sketch.shapes()
    start = centroid(trace.a)
    way = Vec(*map(float, swept.FLIGHT))
    sketch.add("flight", "arrow", "A", start, point_along(start, way, 1.0))
    times = true_value.contact(trace.a, trace.b)
    for i, t in enumerate(map(float, times) if isinstance(times, tuple) else ()):
        if t != t:
            continue
        there = put(trace.a, Vec(way.x * t, way.y * t))
        sketch.shape("A", f"A at {i}", there, weight="faint", named=False)
        wish = Vec(-1.0 + 2 * i, -1.0)
        sketch.label("time", f"{'last' if i else 'first'} contact: {t:g}", "A", centroid(there), number=i, prefer=wish)
    return sketch


def distance(trace: Trace, largest: tuple[float, float]) -> Sketch:
    """The nearest points, and the segment between them."""
    truth = trace.truth
    p, q = _nearest(trace.a, trace.b)
    sketch = Sketch(trace, arrange([Group([trace.a, trace.b], [_least(trace)])], largest=largest)[0])
    sketch.shapes()
    if not truth.hit:
        sketch.add("distance", "segment", "gap", p, q, weight="strong")
        text = f"distance {number(true_value.distance(trace.a, trace.b))}"
        sketch.label("distance-name", text, "gap", midpoint(p, q), prefer=Vec(q.y - p.y, p.x - q.x), first=1)
    return sketch


def _nearest(a: Shape, b: Shape) -> tuple[Vec, Vec]:
    """A point of each, as near to each other as they come if the shapes are apart; rounded."""
    pairs = [(p, _foot(p, edge)) for p in _ring(a) for edge in pairwise(_ring(b))]
    pairs += [(_foot(q, edge), q) for q in _ring(b) for edge in pairwise(_ring(a))]
    p, q = min(pairs, key=lambda pair: hypot(pair[1].x - pair[0].x, pair[1].y - pair[0].y))
    length = hypot(q.x - p.x, q.y - p.y) or 1.0
    way = Vec((q.x - p.x) / length, (q.y - p.y) / length)
    return point_along(p, way, a.radius), point_along(q, way, -b.radius)


def _ring(shape: Shape) -> Sequence[Vec]:
    """The corners, the first one again at last; a circle's center twice."""
    return (*shape.core, shape.core[0])


def _foot(p: Vec, edge: tuple[Vec, Vec]) -> Vec:
    """The point of an edge that lies nearest."""
    q, r = edge
    x, y = r.x - q.x, r.y - q.y
    t = ((p.x - q.x) * x + (p.y - q.y) * y) / ((x * x + y * y) or 1.0)
    return point_along(q, Vec(x, y), min(1.0, max(0.0, t)))


def plain(trace: Trace, largest: tuple[float, float]) -> Sketch:
    """Both shapes alone."""
    sketch = Sketch(trace, arrange([Group([trace.a, trace.b], [])], largest=largest)[0])
    sketch.shapes()
    return sketch


def _room(trace: Trace, largest: tuple[float, float]) -> Layout:
    shapes = [trace.a, trace.b, *(put(trace.b, pair.mtv) for pair in trace.pairs if pair.mtv)]
    x0, y0, x1, y1 = bounding_box(shapes)
    words = Polygon([(x0, y1), (x1, y1), (x1, y1 + (y1 - y0) / 5), (x0, y1 + (y1 - y0) / 5)])  # what is said above
    return arrange([Group([*shapes, words], [])], largest=largest)[0]


def _least(trace: Trace) -> AxisTest:
    return max(trace.tests, key=lambda test: test.gap)


def _only(trace: Trace, test: AxisTest) -> Trace:
    """The trace with that test alone."""
    return replace(trace, tests=(test,))


def _after(shape: Shape) -> Shape:
    return put(shape, Vec(*map(float, swept.FLIGHT)))


VERDICTS = {
    "tunnelling": ("apart", "they meet on the way"),
    "many-pairs": ("", ""),
    "gjk-looks-less": ("", ""),
}
"""What is said in a word where the relation of two shapes is not what it is about."""

SAW: dict[str, Panel] = {
    "one-maximum": digits(exact=False),
    "many-pairs": crowd(every_pair=False),
    "gjk-looks-less": support_points,
    "tunnelling": frame,
}
IS: dict[str, Panel] = {
    "only-one-axis": fan,
    "one-maximum": digits(exact=True),
    "many-pairs": crowd(every_pair=True),
    "gjk-looks-less": looks,
    "tunnelling": flight,
    "gap-as-distance": distance,
}
