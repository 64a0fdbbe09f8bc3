"""The panels of failing cases by name, and those that show something else than tests and proofs.

The claimed tests are those that a shortcut's answer comes from (`default_panels.claimed_tests`).  A push is the move
of B by which a shortcut would end an overlap.  A landing is a point's coordinate on an axis.

A new panel is a `Panel` in `PANELS` below: what it needs space for, and a function of a trace and of a layout with
that space, which returns the sketch it has drawn.
"""

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import pairwise
from math import comb, copysign, cos, dist, floor, hypot, isclose, isnan, pi, sin, ulp
from typing import NamedTuple

from ..engine import describe
from ..engine.axes import EDGE, edge_normals
from ..engine.certificate import SeparatingLine
from ..engine.geometry import Interval, Relation, Vec
from ..engine.number_format import number
from ..engine.sat import AxisTest, axis_tests
from ..engine.shapes import Shape, centroid
from ..engine.shortcut import move_along_axis
from ..engine.trace import Trace, record
from ..scenes.failing.saved_work import FAR_APART, MIN_SUPPORT_POINTS, SHAPE_COUNT, corner_tests
from ..scenes.failing.true_value import FLIGHT, contact_times, separating_angles
from ..scenes.failing.true_value import distance as true_distance
from ..scenes.failing.wrong_conclusions import rounded
from ..scenes.failing.wrong_projections import FIRST_EDGE_OF_B, whole_halves
from ..scenes.shape_tools import box, translated, vertex_mean
from .claims import is_near
from .curve import unit_vector
from .default_panels import (
    LEAST_WORDY_PT,
    Panel,
    PanelSketch,
    claimed_tests,
    contents_of_claimed_tests,
    draw_claimed_tests,
    draw_proof,
    draw_push,
    mtv_name,
    needs_proof,
    true_run,
    true_test,
)
from .draw_steps import draw_mtv, draw_separating_line
from .float_geometry import bounding_box, crossing_point, midpoint, point_along
from .insets import a_is_left
from .label_placer import LabelOptions
from .layout import Layout, PanelContents
from .sketch import NORMAL_PT, RING_PT, Sketch
from .solid_panels import solid_panel

MAX_NOTED_AXES = 60  # axes tested, up to which there is space for words above the shapes
DOT_COUNT = 12  # dots that stand for many shapes
MAX_AXES = 3  # axes that have space side by side
ARROW_LENGTH = 74.0  # points
# corner where the line of float64 numbers begins; distance of two numbers on it
FLOATS_CORNER_PT, FLOAT_STEP_PT = (16.0, 48.0), 26.0
MOVE = Vec(*map(float, FLIGHT))  # how far A flies in one frame


def draw_pieces_panel(trace: Trace, layout: Layout) -> Sketch:
    """Draw B, the pieces of A that the shortcut tests one by one, and an arrow for each piece's push of B."""
    sketch = Sketch(trace, layout)
    draw_pieces(sketch)
    return sketch


def draw_pieces(sketch: Sketch) -> None:
    """Draw on a sketch B, the pieces of A that the shortcut tests, and an arrow for each piece's push of B."""
    trace = sketch.trace
    for pair in trace.pairs:
        sketch.shape("A", pair.names.a, pair.a)
    sketch.shape("B", trace.names.b, trace.b)
    for i, pair in enumerate(trace.pairs):
        if pair.mtv:
            start = centroid(trace.b)
            tip = point_along(start, pair.mtv, 1.0)
            sketch.add("mtv", "arrow", "move", start, tip, number=i, start=(start,))
            # beside a slanting arrow, and in a small panel, short lines have more space
            between = " " if 0.0 in pair.mtv and sketch.layout.size[0] >= LEAST_WORDY_PT else "\n"
            text = f"{pair.names.a} pushes{between}{describe.digits(trace).vector(pair.mtv)}"
            size = hypot(*pair.mtv) or 1.0
            aside = copysign(0.7, centroid(pair.a).x - start.x)  # to the side of the piece that pushes
            prefer = Vec(pair.mtv.x / size + aside, pair.mtv.y / size)
            sketch.label("mtv-name", text, "move", tip, number=i, prefer=prefer, first=3)
    if trace.push:
        sketch.note("push-name", f"in all: push {describe.digits(trace).vector(trace.push)}", "move", first=2)


def draw_separating_directions(trace: Trace, layout: Layout) -> Sketch:
    """Draw both shapes, and 5 arrows from the middle of a gap: the outermost separating directions, 3 between."""
    sketch = draw_shapes(trace, layout)
    test = max(trace.truth.tests, key=lambda test: test.gap, default=None)
    if trace.truth.pairs or test is None or test.gap <= 0:
        return sketch
    ends = separating_angles(trace.a, trace.b)
    n = test.axis.direction
    nearest = (max(test.a.interval.lo, test.b.interval.lo) + min(test.a.interval.hi, test.b.interval.hi)) / 2
    p, q = centroid(trace.a), centroid(trace.b)
    across = ((p.x + q.x) * -n.y + (p.y + q.y) * n.x) / 2
    start = Vec(n.x * nearest - n.y * across, n.y * nearest + n.x * across)
    turns = [ends[0] + (ends[1] - ends[0]) * i / 4 for i in range(5)]
    ways = [Vec(n.x * c.x - n.y * c.y, n.x * c.y + n.y * c.x) for c in map(unit_vector, turns)]
    x0, y0, x1, y1 = sketch.layout.limits
    space = min(x1 - start.x, start.x - x0, y1 - start.y, start.y - y0)
    for i, (turn, u) in enumerate(zip(turns, ways, strict=True)):
        tip = point_along(start, u, min(sketch.layout.units(ARROW_LENGTH), space))
        sketch.add("fan", "arrow", "gap", start, tip, number=i, weight="strong" if i in (0, 4) else "plain")
        if i in (0, 4):
            sketch.label("fan-name", f"{number(round(turn, 2))}°", "gap", tip, number=i, prefer=u, first=1)
    return sketch


def first_edge_test(trace: Trace) -> list[AxisTest]:
    """Return the trace's test on the normal of B's first edge; an empty list if it has none."""
    return [test for test in trace.tests if test.source == FIRST_EDGE_OF_B][:1]


def digits_panel(exact: bool) -> Panel:
    """Return a panel of B's corners projected on the normal of B's first edge, with all digits of the coordinates.

    They are those that the shortcut rounded, or with `exact` the exact ones as float64.
    """

    def panel(trace: Trace, layout: Layout) -> Sketch:
        """Draw the normal as an axis, the drops of B, and the highest landings with all their digits."""
        sketch, found = draw_shapes(trace, layout), first_edge_test(trace)
        if not found:
            return sketch
        (test,) = found
        if exact:
            test = next(axis_tests(trace.a, trace.b, [test.axis]))
        place = sketch.layout.places[0]
        sketch.trace = replace(trace, tests=(test,))
        sketch.edge(test)
        sketch.axis(test, place)
        sketch.drops(test, place, "B", ends_only=False, named=False)
        top = [i for i, t in enumerate(test.b.landings) if abs(t - test.b.interval.hi) < 1e-9 * abs(t)]
        name, polygon = sketch.named_polygon("B")
        lines = {i: f"{describe.vertex_name(polygon, name, polygon.corner_ids[i])} {test.b.landings[i]!r}" for i in top}
        text = "\n".join(lines[i] for i in sorted(top))
        sketch.label("landing-name", text, "B", place.at(test.b.interval.hi), prefer=place.out, first=1)
        names = {i: describe.vertex_name(polygon, name, polygon.corner_ids[i]) for i in top}
        _draw_neighbouring_floats(sketch, [(names[i], test.b.landings[i]) for i in sorted(top)])
        return sketch

    return Panel(lambda trace: _shapes_and(trace, first_edge_test(trace)), panel)


def _draw_neighbouring_floats(sketch: Sketch, landings: Sequence[tuple[str, float]]) -> None:
    """Draw a line with ticks for 5 float64 numbers around the least of `landings`, which are pairs (name, coordinate).

    A landing is a named dot on that line.
    """
    units, (x0, y0, _, _) = sketch.layout.units, sketch.layout.limits
    least = min(t for _, t in landings)
    step, start = ulp(least), Vec(x0 + units(FLOATS_CORNER_PT[0]), y0 + units(FLOATS_CORNER_PT[1]))

    def at(steps: float, up: float = 0.0) -> Vec:
        """Return the point of the number `steps` steps above the least landing, `up` points above the line."""
        return Vec(start.x + units(FLOAT_STEP_PT) * (steps + 1.5), start.y + units(up))

    ticks = [at(k, up) for k in range(-1, 4) for up in (-5.0, 5.0)]
    sketch.add("floats", "segment", "ink", at(-1.5), at(3.5))
    sketch.add("float", "segment", "ink", *ticks)
    below = Vec(at(1).x, start.y - units(18.0))
    text = "ticks: float64 numbers,\none after the other"
    sketch.label("floats-name", text, "ink", below, inside=True, optional=True, first=0)
    for i, t in enumerate(dict.fromkeys(t for _, t in landings)):
        names = ", ".join(name for name, other in landings if other == t)
        spot = at((t - least) / step)
        sketch.add("on-float", "dot", "B", spot, number=i)
        sketch.label("on-float-name", names, "B", spot, number=i, prefer=Vec(0.0, 1.0), first=0)


def dots_panel(every_pair: bool) -> Panel:
    """Return a panel of 12 dots that stand for shapes; `every_pair` joins each dot to every other one."""

    def panel(trace: Trace, layout: Layout) -> Sketch:
        """Draw shapes as dots in a circle, lines between all pairs if `every_pair`, and the number of lines or dots."""
        x0, y0, x1, y1 = 0.0, 0.0, 300.0, 246.0
        sketch = Sketch(trace, Layout((x0, y0, x1, y1), (x1, y1), ()))
        turns = [2 * pi * (i + 0.5) / DOT_COUNT for i in range(DOT_COUNT)]
        dots = [Vec(150.0 + 80.0 * cos(t), 95.0 + 80.0 * sin(t)) for t in turns]
        if every_pair:
            joined = tuple(end for i, p in enumerate(dots) for q in dots[:i] for end in (p, q))
            sketch.add("pairs", "segment", "guide", *joined)
        for i, spot in enumerate(dots):
            sketch.add("shape", "dot", "A", spot, number=i)
        what = f"{DOT_COUNT} shapes: {DOT_COUNT} tests,\none for each"
        if every_pair:
            sums = (f"{n:,} shapes: {n:,} \u00d7 {n - 1:,} / 2 = {comb(n, 2):,}" for n in (DOT_COUNT, SHAPE_COUNT))
            what = " pairs\n".join(sums)
        sketch.label("few", what, "guide", Vec(150.0, 196.0 if every_pair else 95.0), inside=True, first=1)
        return sketch

    return Panel(_shapes_and, panel)


def draw_searches(trace: Trace, layout: Layout) -> Sketch:
    """Draw both shapes, and at each corner how often GJK evaluates it.

    It does so once in each search for the furthest corner: in 3 searches for a hit, in 1 for a miss.
    """
    sketch = draw_shapes(trace, layout)
    count = len(trace.a.core) + len(trace.b.core)
    searches = MIN_SUPPORT_POINTS if trace.hit else 1
    draw_evaluation_counts(sketch, searches)
    fewest = f"GJK searches {searches} times at least" if searches > 1 else "GJK searches once at least"
    sketch.note(
        "gjk", f"{fewest};\neach time it looks at {_sum_of_evaluations(trace, searches, count)}", "guide", first=3
    )
    return sketch


def _sum_of_evaluations(trace: Trace, times: int, count: int) -> str:
    """Return words such as "all 8 corners: 3 \u00d7 8 = 24", with "points" where a shape is a circle."""
    what = "corners" if trace.a.vertices and trace.b.vertices else "points"
    return f"all {count} {what}: {times} \u00d7 {count} = {times * count}"


def draw_evaluation_counts(sketch: Sketch, times: int) -> None:
    """Write at each corner that it is evaluated `times` times, as "3\u00d7"."""
    for role, name, shape in sketch.roles():
        middle = centroid(shape)
        for i, v in enumerate(shape.vertices):  # a circle has none
            away = Vec(v.x - middle.x, v.y - middle.y)
            sketch.add("evaluated", "dot", role, v, owner=name, number=i)
            options: LabelOptions = {"owner": name, "number": i, "prefer": away, "optional": True, "near": True}
            sketch.label("evaluations", f"{times}\u00d7", role, v, first=3, **options)


def drawn_tests_of_sat(run: Trace) -> Sequence[AxisTest]:
    """Return the tests of a run of SAT that are drawn: all of up to 3, else only that of the largest gap."""
    tests = run.tests
    return tests if len(tests) <= MAX_AXES else [max(tests, key=lambda test: test.gap)]


def draw_axes_of_sat(trace: Trace, layout: Layout) -> Sketch:
    """Draw both shapes, the tests of SAT (of more than 3 only that of the largest gap), and how often they evaluate."""
    run = record(trace.a, trace.b)
    tests = drawn_tests_of_sat(run)
    sketch = draw_shapes(run, layout)
    for test, place in zip(tests, sketch.layout.places, strict=True):
        sketch.project(test, place, numbers=False)
    if tests and len(run.tests) == len(tests):
        count = len(tests[0].a.points) + len(tests[0].b.points)  # a circle has two on each axis
        draw_evaluation_counts(sketch, len(tests))
        axes = "1 axis" if len(tests) == 1 else f"{len(tests)} axes"
        text = f"SAT measures on {axes};\non each {_sum_of_evaluations(trace, len(tests), count)}"
        sketch.note("tested", text, "guide", first=3)
    elif len(run.tests) > len(tests):
        sketch.note("tested", f"one of {len(run.tests)} axes that SAT looks at", "guide", first=7)
    return sketch


def draw_corners(trace: Trace, layout: Layout) -> Sketch:
    """Draw a ring round each corner, coloured by whether it lies in the other polygon, and say how many lie in it."""
    sketch, tests = draw_shapes(trace, layout), corner_tests(trace.a, trace.b)
    for i, test in enumerate(tests):
        (corner,) = min(test.a.points, test.b.points, key=len)
        radius = layout.units(RING_PT)
        sketch.add("corner", "disc", "gap" if test.gap > 0 else "overlap", corner, number=i, radius=radius)
    inside = sum(test.gap <= 0 for test in tests)
    if tests:
        sketch.note("corners", f"{len(tests)} corners: {inside or 'none'} in the other shape", "gap", first=3)
    return sketch


def draw_edges(trace: Trace, layout: Layout) -> Sketch:
    """Draw both shapes, and a ring round each point in which their edges cross or meet; say how many there are."""
    sketch = draw_shapes(trace, layout)
    borders = [list(pairwise(_closed_ring(shape))) for shape in (trace.a, trace.b) if not shape.core_is_point]
    if len(borders) < 2:
        return sketch
    found = {p for s in borders[0] for t in borders[1] for p in _meeting_points(s, t)}
    for i, p in enumerate(sorted(found)):
        sketch.add("crossing", "disc", "overlap", p, number=i, radius=layout.units(RING_PT))
    count = f"{len(borders[0])} edges and {len(borders[1])} edges"
    crossings = "1 crossing" if len(found) == 1 else f"{len(found) or 'no'} crossings"
    sketch.note("crossings", f"{count}: {crossings}", "gap", first=3)
    return sketch


def _meeting_points(s: tuple[Vec, Vec], t: tuple[Vec, Vec]) -> list[Vec]:
    """Return in float64 the point where two segments cross; without one, the ends of each that lie on the other."""
    crossing, ends = crossing_point(s, t), [*((c, s) for c in t), *((c, t) for c in s)]
    return [crossing] if crossing else [c for c, edge in ends if _nearest_on_edge(c, edge) == c]


def draw_two_frames(trace: Trace, layout: Layout) -> Sketch:
    """Draw A in this frame and, faintly, in the next one, and the gap on an axis in this frame."""
    test = trace.ended_by or trace.tests[0]
    after = translated(trace.a, MOVE)
    sketch = draw_shapes(replace(trace, tests=(test,)), layout)
    sketch.shape("A", "A next", after, weight="faint", named=False)
    sketch.label("next-name", "next frame", "A", centroid(after), prefer=Vec(0.0, 1.0), first=2)
    sketch.project(test, sketch.layout.places[0], drops=False, interval=False)
    return sketch


def draw_flight(trace: Trace, layout: Layout) -> Sketch:
    """Draw A's path in one frame as an arrow, and A where it first and last touches B, with the times."""
    sketch = draw_shapes(trace, layout)
    start = centroid(trace.a)
    sketch.add("flight", "arrow", "A", start, point_along(start, MOVE, 1.0))
    for i, t in enumerate(map(float, contact_times(trace.a, trace.b))):
        if isnan(t):
            continue
        there = translated(trace.a, Vec(MOVE.x * t, MOVE.y * t))
        sketch.shape("A", f"A at {i}", there, weight="faint", named=False)
        wish = Vec(-1.0 + 2 * i, -1.0)
        sketch.label("time", f"{'last' if i else 'first'} contact: {t:g}", "A", centroid(there), number=i, prefer=wish)
    return sketch


def draw_distance(trace: Trace, layout: Layout) -> Sketch:
    """Draw both shapes and, if they are apart, the shortest segment between them with its length."""
    p, q = _nearest_points(trace.a, trace.b)
    sketch = draw_shapes(trace, layout)
    if not trace.truth.hit:
        sketch.add("distance", "segment", "gap", p, q, weight="strong")
        text = f"distance {number(true_distance(trace.a, trace.b))}"
        sketch.label("distance-name", text, "gap", midpoint(p, q), prefer=Vec(q.y - p.y, p.x - q.x), first=1)
    return sketch


def _nearest_points(a: Shape, b: Shape) -> tuple[Vec, Vec]:
    """Return the nearest points of two shapes that are apart, A's first, in float64."""
    pairs = [(p, _nearest_on_edge(p, edge)) for p in _closed_ring(a) for edge in pairwise(_closed_ring(b))]
    pairs += [(_nearest_on_edge(q, edge), q) for q in _closed_ring(b) for edge in pairwise(_closed_ring(a))]
    p, q = min(pairs, key=lambda pair: hypot(pair[1].x - pair[0].x, pair[1].y - pair[0].y))
    length = hypot(q.x - p.x, q.y - p.y) or 1.0
    way = Vec((q.x - p.x) / length, (q.y - p.y) / length)
    return point_along(p, way, a.radius), point_along(q, way, -b.radius)


def _closed_ring(shape: Shape) -> Sequence[Vec]:
    """Return a polygon's corners with the first one again at the end, or a circle's center twice."""
    return (*shape.core, shape.core[0])


def _nearest_on_edge(p: Vec, edge: tuple[Vec, Vec]) -> Vec:
    """Return the point of an edge that lies nearest to p."""
    q, r = edge
    x, y = r.x - q.x, r.y - q.y
    t = ((p.x - q.x) * x + (p.y - q.y) * y) / ((x * x + y * y) or 1.0)
    return point_along(q, Vec(x, y), min(1.0, max(0.0, t)))


def draw_line_as_axis(trace: Trace, layout: Layout) -> Sketch:
    """Draw the claimed tests, and the separating line whose direction was taken for that of the axis."""
    sketch = draw_claimed_tests(trace, layout)
    certificate = true_run(trace).certificate
    if isinstance(certificate, SeparatingLine) and layout.places:
        place, point, normal = layout.places[0], certificate.point, certificate.normal
        if float(normal[0]) * place.n.x + float(normal[1]) * place.n.y:
            return sketch  # the line does not run along the axis, so nobody took one for the other
        draw_separating_line(sketch, certificate, "the line")
        start = Vec(point.x, layout.limits[1] + layout.units(40.0))
        tip = Vec(place.at(0.0).x, start.y)
        sketch.add("taken", "arrow", "wrong", start, tip)
        sketch.label("taken-name", "taken as the axis", "wrong", midpoint(start, tip), first=1)
    return sketch


def draw_rounded_normal(trace: Trace, layout: Layout) -> Sketch:
    """Draw the claimed tests and, for a false hit, the separating axis's edge, its true normal and the rounded one."""
    sketch, test = draw_claimed_tests(trace, layout), true_test(trace)
    if trace.false_hit and test and test.source.kind == EDGE:
        sketch.edge(test)
        sketch.vertices(test.source.shape or "A", test.source.ids)
        sketch.normal(test)
        n, tip = sketch.arrow_direction(test.axis), sketch.marks[-1].points[1]
        words = "true normal {},\nrounded to {}" if layout.size[0] >= LEAST_WORDY_PT else "{}\n\u2192 {}"
        text = words.format(*map(describe.digits(trace).vector, (n, rounded(n))))
        sketch.label("normal-name", text, test.source.shape or "ink", tip, prefer=n, optional=True, first=2)
    return sketch


def with_note(panel: Panel, words: Callable[[Trace], str], role: str = "wrong") -> Panel:
    """Return the panel with the text `words(trace)` above its shapes, in the colour of `role`; "" adds no text."""

    def has_space(trace: Trace) -> bool:
        """Check whether there is space for words: not among the labels of very many axes."""
        return len(trace.tests) <= MAX_NOTED_AXES

    def needs(trace: Trace) -> PanelContents:
        """Return what the panel needs, and space for two lines above the shapes."""
        x0, y0, x1, y1 = bounding_box([trace.a, trace.b])
        contents = panel.needs(trace)
        space = [box(x0, y1, x1, y1 + (y1 - y0) / 2)] if has_space(trace) else []
        return contents._replace(shapes=[*contents.shapes, *space])

    def draw(trace: Trace, layout: Layout) -> Sketch:
        """Draw the panel and the words."""
        sketch = panel.draw(trace, layout)
        if has_space(trace) and (text := words(trace)):
            sketch.note("said", text, role, first=2)
        return sketch

    return Panel(needs, draw)


def questions_asked(trace: Trace) -> str:
    """Return which question about the order of two ranges a shortcut asked, and which one it did not ask, as text.

    "" if one question was enough.
    """
    for test in axis_tests(trace.a, trace.b, [test.axis for test in claimed_tests(trace)]):
        a, b = test.a.interval, test.b.interval
        if b.hi < a.lo:
            name, digits = trace.names, describe.digits(trace, test).landing
            asked = f"asked: does {name.a} end ({digits(a.hi)}) before {name.b} begins ({digits(b.lo)})?  no"
            other = f"not asked: does {name.b} end ({digits(b.hi)}) before {name.a} begins ({digits(a.lo)})?  yes"
            return f"{asked}\n{other}"
    return ""


def facing_ends(trace: Trace, how: str) -> str:
    """Return as text, after `how`, the facing ends of the two ranges with the largest gap, with all digits.

    `how` says how they were stored, such as "in float64".  "" without a test.
    """
    test = max(trace.tests, key=lambda test: test.gap, default=None)
    if test is None:
        return ""
    sides = list(zip(trace.names, (test.a.interval, test.b.interval), strict=True))
    (left, first), (right, second) = sides if a_is_left(test) else sides[::-1]
    return f"{how}: {left} ends at {first.hi!r},\n{right} begins at {second.lo!r}"


def length_rounded(trace: Trace) -> str:
    """Return as text the rounded length that the first normal was divided by, and where its ranges then end.

    "" if that length is a whole number or the claim is right.
    """
    for test in claimed_tests(trace)[:1]:
        (x, y), length = test.axis.normal, test.axis.length
        if not length.is_integer() and trace.claim is not trace.relation:
            return facing_ends(trace, f"normal divided by \u221a{number(x * x + y * y)}, rounded").replace(
                ": ", ":\n", 1
            )
    return ""


def halves_rounded(trace: Trace) -> str:
    """Return as text how the first range whose middle or half length is no whole number was rounded, else ""."""
    for test in axis_tests(trace.a, trace.b, [test.axis for test in claimed_tests(trace)]):
        digits = describe.digits(trace, test)
        for name, (lo, hi) in zip(trace.names, (test.a.interval, test.b.interval), strict=True):
            kept = whole_halves(Interval(lo, hi))
            if kept != (lo, hi):
                middle, half = (lo + hi) / 2, (hi - lo) / 2
                start = f"{name} {digits.interval(lo, hi)}: middle {digits.landing(middle)} kept as {floor(middle)},"
                return f"{start}\nhalf {digits.number(half)} kept as {floor(half)}: {digits.interval(*kept)}"
    return ""


def radii_compared(trace: Trace) -> str:
    """Return text such as "r1 + r2 = 2 < distance = 3: taken for a hit"; "" unless two circles apart are so taken."""
    lengths = trace.a.radius + trace.b.radius, dist(centroid(trace.a), centroid(trace.b))
    radii, apart = map(describe.digits(trace).number, lengths)
    both_circles = trace.a.core_is_point and trace.b.core_is_point
    return f"r1 + r2 = {radii} < distance = {apart}: taken for a hit" if trace.false_hit and both_circles else ""


def centers_compared(trace: Trace) -> str:
    """Return as text how far apart the centers lie, and from what distance on that counts as far."""
    centers = [centroid(shape) for shape in (trace.a, trace.b)]
    return f"centers {number(round(dist(*centers), 9))} apart; more than {FAR_APART:g} counts as far apart"


def needs_push(trace: Trace) -> PanelContents:
    """Return what a panel needs: both shapes, and B where the shortcut pushes it and where the MTV moves it."""
    moves = [move for move in (trace.push, trace.truth.known_mtv) if move and is_near(trace, move)]
    return PanelContents([trace.a, trace.b, *(translated(trace.b, move) for move in moves)])


def draw_push_alone(trace: Trace, layout: Layout) -> Sketch:
    """Draw both shapes, the shortcut's push as an arrow, and B at its end."""
    sketch = draw_shapes(trace, layout)
    draw_push(sketch)
    return sketch


def draw_push_from_center(trace: Trace, layout: Layout) -> Sketch:
    """Draw both shapes, the push, B at its end, and the segment between both vertex means, which gave its direction."""
    sketch = draw_push_alone(trace, layout)
    means = vertex_mean(trace.a), vertex_mean(trace.b)
    sketch.add("joined", "segment", "wrong", *means)
    for (role, name, _), mean in zip(sketch.roles(), means, strict=True):
        sketch.add("mean", "dot", role, mean, owner=name)
        aside = Vec(0.8, 0.6) if role == "A" else Vec(0.8, -0.6)
        sketch.label("mean-name", f"{name}'s center", role, mean, owner=name, prefer=aside, first=2)
    return sketch


def with_normal_of_push(panel: Panel, move_of: Callable[[Trace], Vec | None]) -> Panel:
    """Return the panel with that edge of A whose outward normal the MTV follows, and an arrow along a push.

    `move_of(trace)`: the push, or None.  The arrow stands on the edge; its label says if it points out of A or into A.
    """

    def draw(trace: Trace, layout: Layout) -> Sketch:
        """Draw the panel; the edge and the arrow only where there is a push and the MTV is along a normal of A."""
        sketch, move, out = panel.draw(trace, layout), move_of(trace), trace.truth.known_mtv
        if not (move and out and any(move)):
            return sketch
        for axis in edge_normals(trace.a, trace.b).axes:
            n = sketch.arrow_direction(axis)
            if axis.source.shape != "A" or not isclose(n.x * out.x + n.y * out.y, hypot(*out)):
                continue
            (test,) = axis_tests(trace.a, trace.b, [axis])
            sketch.edge(test)
            sketch.vertices(test.source.shape or "A", test.source.ids)
            p, q = (trace.a.vertices[i] for i in axis.source.ids)
            way = Vec(move.x / hypot(*move), move.y / hypot(*move))
            foot, is_out = point_along(p, Vec(q.x - p.x, q.y - p.y), 0.2), way.x * n.x + way.y * n.y > 0
            sketch.right_angle(foot, way)
            tip = point_along(foot, way, layout.units(NORMAL_PT))
            role = "A" if is_out else "wrong"
            sketch.add("normal", "arrow", role, foot, tip, start=(foot,))
            text = (
                f"normal {describe.digits(trace).vector(way)},\npoints {'out of' if is_out else 'into'} {trace.names.a}"
            )
            sketch.label("normal-name", text, role, tip, prefer=Vec(way.x, -1.0), first=2)
        return sketch

    return panel._replace(draw=draw)


def draw_moved_by_mtv(trace: Trace, layout: Layout) -> Sketch:
    """Draw both shapes and, for an overlap, the MTV and B moved by it."""
    sketch = draw_shapes(trace, layout)
    move = trace.truth.known_mtv
    if trace.relation is Relation.OVERLAPPING and move:
        draw_mtv(sketch, centroid(trace.b), move, mtv_name(layout))
    return sketch


class PushOnAxis(NamedTuple):
    """A move of B along the axis of `test` by the `overlap` there, as it is or as a shortcut measured it."""

    test: AxisTest
    overlap: float
    move: Vec


def pushes_on_axes(trace: Trace, *, raw: bool = False) -> list[PushOnAxis]:
    """Return B's push on each axis of the claimed tests: by the exact overlap, or if `raw` by the measured one."""
    tests = [test for test in claimed_tests(trace) if any(test.axis.normal)]
    exact = axis_tests(trace.a, trace.b, [test.axis for test in tests])
    gaps = [test.gap for test in (tests if raw else exact)]
    return [PushOnAxis(test, -gap, move_along_axis(test, -gap)) for test, gap in zip(tests, gaps, strict=True)]


def pushes_panel(of_overlap: Panel, without: Panel) -> Panel:
    """Return a panel drawn as `of_overlap` for a hit with a push, to compare with the MTV, and else as `without`."""

    def has_any(trace: Trace) -> bool:
        """Check whether there is a push to compare with the MTV."""
        return trace.hit and trace.push is not None

    return Panel(
        lambda trace: (of_overlap if has_any(trace) else without).needs(trace),
        lambda trace, layout: (of_overlap if has_any(trace) else without).draw(trace, layout),
    )


def needs_pushes(trace: Trace) -> PanelContents:
    """Return what a panel needs: both shapes, and B at the end of each push."""
    moves = [trace.push, *(one.move for one in (*pushes_on_axes(trace, raw=True), *pushes_on_axes(trace)))]
    return PanelContents(
        [trace.a, trace.b, *(translated(trace.b, move) for move in moves if move and is_near(trace, move))]
    )


def draw_raw_pushes(trace: Trace, layout: Layout) -> Sketch:
    """Draw the push on each axis as long as the shortcut measured it, and the length of the normal, which is why."""
    sketch = draw_shapes(trace, layout)
    draw_push(sketch)
    digits = describe.digits(trace).gap
    for true, raw in zip(pushes_on_axes(trace), pushes_on_axes(trace, raw=True), strict=True):
        long, wrong = f"normal {number(raw.test.axis.length)} long: ", f"read as {digits(raw.overlap)}"
        pieces = (f"overlap {digits(true.overlap)},\n", "overlap"), (long, "guide"), (wrong, "wrong")
        _draw_push_on_axis(sketch, raw, "wrong", pieces, drawn=raw.test is trace.shallowest)
    return sketch


def draw_true_pushes(trace: Trace, layout: Layout) -> Sketch:
    """Draw the push on each axis with its true length, the shortest as the MTV."""
    sketch = draw_moved_by_mtv(trace, layout)
    mtv = trace.truth.known_mtv or Vec(0.0, 0.0)
    for push in pushes_on_axes(trace):
        if hypot(*push.move) > hypot(*mtv) * (1 + 1e-9):
            text = f"overlap {describe.digits(trace).gap(push.overlap)}"
            _draw_push_on_axis(sketch, push, "guide", ((text, "overlap"),))
    return sketch


def _draw_push_on_axis(
    sketch: Sketch, push: PushOnAxis, role: str, pieces: tuple[tuple[str, str], ...], *, drawn: bool = False
) -> None:
    """Draw a push as an arrow of colour `role` from the centroid of B, unless it is `drawn` already.

    `pieces`: the words at its tip, as pairs (text, role).
    """
    start, near = centroid(sketch.trace.b), is_near(sketch.trace, push.move)
    tip, axis = point_along(start, push.move, 1.0) if near else start, sketch.axis_id(push.test)
    if near and not drawn:
        sketch.add("axis-push", "arrow", role, start, tip, axis=axis)
    text = "".join(piece for piece, _ in pieces)
    prefer = Vec(0.0, -1.0) if drawn else push.move  # its push is named at its tip
    sketch.label(
        "axis-push-name", text, pieces[0][1], tip, axis=axis, prefer=prefer, pieces=pieces, far=not near, first=3
    )


def needs_fold(trace: Trace) -> PanelContents:
    """Return what the panel of folded ranges needs: both shapes, and the exact test of the last axis."""
    return PanelContents(
        [trace.a, trace.b], list(axis_tests(trace.a, trace.b, [test.axis for test in trace.tests[-1:]]))
    )


def draw_fold(trace: Trace, layout: Layout) -> Sketch:
    """Draw the true range of each shape on the last axis, and how a range below 0 folds over to positive ones."""
    sketch = draw_shapes(trace, layout)
    for measured, exact, place in zip(trace.tests[-1:], layout.tests, layout.places, strict=False):
        sketch.axis(measured, place)
        for role, name, _ in sketch.roles():
            seen, true = ((t.a if role == "A" else t.b).interval for t in (measured, exact))
            if true.hi < 0:
                ends = place.at(true.lo, role), place.at(true.hi, role)
                sketch.add("true-range", "segment", "guide", *ends, owner=name, weight="strong")
                middle = (true.lo + true.hi) / 2
                arc = [place.at(middle * cos(t)) for t in (k * pi / 24 for k in range(25))]
                arc = [point_along(p, place.out, -middle * sin(k * pi / 24) * 0.5) for k, p in enumerate(arc)]
                sketch.add("fold", "segment", "wrong", *(end for piece in pairwise(arc[:-1]) for end in piece))
                sketch.add("fold-tip", "arrow", "wrong", arc[-3], arc[-1])
                digits = describe.digits(trace, exact)
                text = f"folded over: {digits.interval(*true)} is taken for {digits.interval(*seen)}"
                sketch.label("fold-name", text, "wrong", arc[12], prefer=place.out, first=2)
            sketch.range(measured, place, role)
        sketch.gap(measured, place, interval=False)
    return sketch


def draw_shapes(trace: Trace, layout: Layout) -> Sketch:
    """Draw both shapes alone."""
    sketch = PanelSketch(trace, layout)
    sketch.shapes()
    return sketch


def _shapes_and(trace: Trace, tests: Sequence[AxisTest] = ()) -> PanelContents:
    """Return what a panel needs: both shapes, and tests whose axes are drawn."""
    return PanelContents([trace.a, trace.b], tests)


def needs_flight(trace: Trace) -> PanelContents:
    """Return what a panel needs: both shapes, A in the next frame, and the test that is shown."""
    return PanelContents([trace.a, translated(trace.a, MOVE), trace.b], [trace.ended_by or trace.tests[0]])


def needs_pieces(trace: Trace) -> PanelContents:
    """Return what a panel needs: both shapes, B where each piece pushes it, and space for words above them."""
    shapes = [trace.a, trace.b, *(translated(trace.b, pair.mtv) for pair in trace.pairs if pair.mtv)]
    x0, y0, x1, y1 = bounding_box(shapes)
    return PanelContents([*shapes, box(x0, y1, x1, y1 + (y1 - y0) / 4.5)])


TESTS, PROOF = Panel(contents_of_claimed_tests, draw_claimed_tests), Panel(needs_proof, draw_proof)
PUSH, MTV = Panel(needs_push, draw_push_alone), Panel(needs_push, draw_moved_by_mtv)
PIECES = Panel(needs_pieces, draw_pieces_panel)
PANELS: dict[str, Panel] = {
    "tests": TESTS,
    "proof": PROOF,
    "separating directions": Panel(_shapes_and, draw_separating_directions),
    "rounded digits": digits_panel(exact=False),
    "exact digits": digits_panel(exact=True),
    "separate dots": dots_panel(every_pair=False),
    "joined dots": dots_panel(every_pair=True),
    "searches": Panel(_shapes_and, draw_searches),
    "axes of SAT": Panel(lambda run: _shapes_and(run, drawn_tests_of_sat(record(run.a, run.b))), draw_axes_of_sat),
    "two frames": Panel(needs_flight, draw_two_frames),
    "flight": Panel(needs_flight, draw_flight),
    "distance": Panel(_shapes_and, draw_distance),
    "one side": with_note(TESTS, questions_asked),
    "as written": with_note(TESTS, lambda trace: facing_ends(trace, "as written")),
    "as stored": with_note(PROOF, lambda trace: facing_ends(true_run(trace), "in float64")),
    "rounded normal": Panel(contents_of_claimed_tests, draw_rounded_normal),
    "unit normal": with_note(TESTS, length_rounded),
    "right normal": with_note(PROOF, lambda trace: "the normal of (dx, dy) is (dy, \u2212dx)", "ink"),
    "radii": with_note(TESTS, radii_compared),
    "halves": with_note(TESTS, halves_rounded),
    "far centers": with_note(TESTS, centers_compared),
    "line as axis": Panel(contents_of_claimed_tests, draw_line_as_axis),
    "push from center": Panel(needs_push, draw_push_from_center),
    "push while A stays": with_note(PUSH, lambda trace: f"{trace.names.a} does not move", "A"),
    "push along normal": with_normal_of_push(PUSH, lambda trace: trace.push),
    "MTV": MTV,
    "MTV along normal": with_normal_of_push(MTV, lambda trace: trace.truth.known_mtv),
    "raw pushes": pushes_panel(Panel(needs_pushes, draw_raw_pushes), TESTS),
    "true pushes": pushes_panel(Panel(needs_pushes, draw_true_pushes), PROOF),
    "corners": Panel(_shapes_and, draw_corners),
    "edges": Panel(_shapes_and, draw_edges),
    "fold": Panel(needs_fold, draw_fold),
    "solid boxes": solid_panel(actual=False),
    "solid boxes apart": solid_panel(actual=True),
}
"""The panels by the names that failing cases give (`Panels` in satviz/scenes/failing/failure_case.py)."""
