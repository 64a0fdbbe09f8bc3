"""sv.difference_steps: how B - A comes about, the set whose position against the origin decides the relation.

```
   1  A and B        2  A turned round      3  slid along B's border     4  B - A, and its range
                        the origin: -A         all that it covers           on the axis
```
"""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from math import cos, radians, sin
from typing import NamedTuple

from ..engine import describe
from ..engine.convex_parts import parts
from ..engine.geometry import Relation, Vec
from ..engine.number_format import MINUS
from ..engine.sat import AxisTest, Projection
from ..engine.shapes import Circle, Polygon, Shape
from ..engine.trace import Trace, record
from ..scenes.failing.move_space import convex_hull, minkowski_difference
from ..scenes.resolve import SceneLike, resolve
from ..scenes.shape_tools import box, translated
from .float_geometry import bounding_box, circle_points, mean_point
from .layout import PanelContents, arrange
from .marks import Picture
from .sketch import Sketch

TURN_DEGREES = 60, 120, 180
MAX_STOPS = 12  # points of B's border at which the turned A is drawn
RIM_CORNERS = 48  # corners of the polygon that is drawn for a circle
MAX_FAR_SIZES = 2.0  # shapes further from the origin than so many of their sizes are moved next to it
ORIGIN = Vec(0.0, 0.0)
MAX_NAMED_CORNERS = 8  # a difference with at most so many corners gets names such as "b1 - a2"


class _Scene(NamedTuple):
    """The facts that all steps share: the run, the move of both shapes, the rings of B - A, the test.

    `border`: points all along B's border, the first one again at the end; `stops`: the numbers of those where the
    turned A is drawn.
    """

    run: Trace
    move: Vec
    rings: Sequence[Sequence[Vec]]
    test: AxisTest | None
    border: Sequence[Vec]
    stops: Sequence[int]


def difference_steps(what: SceneLike | Shape, b: Shape | None = None, *, title: str = "") -> tuple[Picture, ...]:
    """Return the pictures of how B - A comes about: A is turned round the origin and slid along B's border.

    What the turned A covers on its way, and inside B, is B - A: all differences of a point of B and a point of A.
    The last picture projects it on the axis that separates best: its range is B's range minus A's, and the origin
    lands on 0.  The shapes share a point exactly if the origin lies in B - A.
    `what` is a scene (or its name), a trace, or the first of two shapes.  All pictures have one frame.  A concave
    shape has no last picture, since its difference is a set of convex parts.  ValueError for shapes that cannot be
    drawn.
    """
    scene = _scene(resolve(what, b).trace.truth)
    found = [_start(scene), *(_turned(scene, degrees) for degrees in TURN_DEGREES)]
    found += [_slid(scene, i) for i in scene.stops]
    found.append(_whole(scene))
    if scene.test:
        found.append(_on_axis(scene, scene.test))
    return tuple(picture._replace(title=title) for picture in found)


def _scene(truth: Trace) -> _Scene:
    """Return the facts that all steps of an exact run share; shapes far from the origin are moved next to it."""
    x0, y0, x1, y1 = bounding_box([truth.a, truth.b])
    far = MAX_FAR_SIZES * max(x1 - x0, y1 - y0)
    # along an axis on which they lie near it, a move could round: then the moved shapes might have another relation
    move = Vec(*(-(lo + hi) / 2 if max(-lo, hi) > far else 0.0 for lo, hi in ((x0, x1), (y0, y1))))
    a, b = (translated(shape, move) if any(move) else shape for shape in (truth.a, truth.b))
    # `minkowski_difference` gives A - B, and B - A is A - B turned by 180 degrees
    rings = [tuple(Vec(-p.x, -p.y) for p in ring) for ring in minkowski_difference(truth.a, truth.b)]
    tests = truth.without_early_exit().tests
    best = max(tests, key=lambda test: test.gap, default=None)
    test = _against_origin(best, rings[0]) if best else None
    run = replace(record(a, b), tests=(test,) if test else (), names=truth.names)
    border = circle_points(b.center, b.radius, RIM_CORNERS) if isinstance(b, Circle) else list(b.corners)
    stops = *range(0, len(border), -(-len(border) // MAX_STOPS)), len(border)
    return _Scene(run, move, rings, test, [*border, border[0]], stops)


def _against_origin(test: AxisTest, ring: Sequence[Vec]) -> AxisTest:
    """Return a test of A against B as one of the origin against B - A (`ring`) on the same axis, with the same gap."""
    n, (a, b) = test.axis.direction, (test.a.interval, test.b.interval)
    along = [p.x * n.x + p.y * n.y for p in ring]
    ends = ring[along.index(min(along))], ring[along.index(max(along))]
    return test._replace(a=Projection((ORIGIN,), (0.0,)), b=Projection(ends, (b.lo - a.hi, b.hi - a.lo)))


# -- the steps


def _sketch(scene: _Scene, *, a_weight: str = "plain") -> Sketch:
    """Return a sketch on the frame of all steps, with both shapes and the origin; `a_weight`: the weight of A."""
    run = scene.run
    turned = [p for degrees in TURN_DEGREES for p in _rim(run.a, degrees)]
    spots = [ORIGIN, *turned, *(p for ring in scene.rings for p in ring)]
    spots += [p for stop in scene.border for p in _rim(run.a, 180, stop)]
    xs, ys = [p.x for p in spots], [p.y for p in spots]
    around = box(min(xs), min(ys), max(xs), max(ys))
    tests = [scene.test] if scene.test else []
    (layout,) = arrange([PanelContents([run.a, run.b, around], tests)])
    sketch = Sketch(run, layout)
    sketch.shape("B", "B", run.b)
    sketch.shape("A", "A", run.a, weight=a_weight, quiet=a_weight == "faint")
    sketch.add("origin", "dot", "ink", ORIGIN)
    sketch.label("origin-name", "origin", "ink", ORIGIN, first=1)
    return sketch


def _rim(shape: Shape, degrees: float, start: Vec = ORIGIN) -> list[Vec]:
    """Return a shape's outline turned counter-clockwise about the origin by an angle, then moved by `start`."""
    rim = circle_points(shape.center, shape.radius, RIM_CORNERS) if isinstance(shape, Circle) else shape.vertices
    c, s = round(cos(radians(degrees)), 15), round(sin(radians(degrees)), 15)
    return [Vec(start.x + p.x * c - p.y * s, start.y + p.x * s + p.y * c) for p in rim]


def _turning(sketch: Sketch, scene: _Scene, name: str, degrees: float, start: Vec = ORIGIN) -> None:
    """Draw A, labelled `name`, turned counter-clockwise about the origin and then moved by `start`."""
    ring = _rim(scene.run.a, degrees, start)
    sketch.add("turned", "outline", "A", *ring, owner="A", start=tuple(_rim(scene.run.a, 0)))
    sketch.label("turned-name", name, "A", mean_point(ring), owner="A", inside=True, weight="title", first=1)


def _start(scene: _Scene) -> Picture:
    """Draw the shapes and the origin."""
    text = f"B {MINUS} A holds, for each point of B and each point of A, the point of B minus the point of A."
    if any(scene.move):
        by = describe.digits(scene.run).vector(scene.move)
        text += f" Both shapes are moved by {by}, next to the origin: that changes no difference."
    return _sketch(scene).finish("", text)


def _turned(scene: _Scene, degrees: float) -> Picture:
    """Draw A turned about the origin by an angle in degrees; after 180 degrees each point p has become -p."""
    sketch, done = _sketch(scene, a_weight="faint"), degrees == 180
    _turning(sketch, scene, f"{MINUS}A" if done else "A turned", degrees)
    text = f"A is turned about the origin by {degrees} degrees"
    return sketch.finish("", f"{text}: each point p has become {MINUS}p." if done else f"{text}.")


def _slid(scene: _Scene, i: int) -> Picture:
    """Draw the turned A at point `i` (from 0) of B's border, and all that it has covered on its way there."""
    sketch = _sketch(scene, a_weight="faint")
    if i:
        sketch.add("covered", "outline", "guide", *_covered(scene, i), weight="fill")
    _turning(sketch, scene, f"{MINUS}A", 180, scene.border[i])
    sketch.add("stop", "dot", "ink", scene.border[i])
    if i:
        text = f"{MINUS}A slides along B's border: it covers each point that it passes, minus each point of A."
    else:
        text = (
            f"{MINUS}A is moved: the origin comes to a point of B's border. It covers that point minus each point of A."
        )
    return sketch.finish("", text)


def _covered(scene: _Scene, i: int) -> list[Vec]:
    """Return the outline of all that the turned A covers on its way to point `i` of B's border.

    The outline joins one convex ring for each part and piece of the way, and returns from ring to ring on the same
    line.  So a pen that fills it by the nonzero rule fills the union of the rings.
    """
    pieces = parts(scene.run.a)
    way = pairwise(scene.border[: i + 1])
    rings = [convex_hull((*_rim(part, 180, p), *_rim(part, 180, q))) for p, q in way for part in pieces]
    return [p for ring in rings for p in (*ring, ring[0])] + [ring[0] for ring in reversed(rings[:-1])]


def _difference(sketch: Sketch, scene: _Scene) -> None:
    """Draw B - A with its name, and the names of its corners as differences if they are few."""
    run = scene.run
    for n, ring in enumerate(scene.rings):
        sketch.add("difference", "outline", "guide", *ring, number=n)
    middles = [mean_point(ring) for ring in scene.rings]
    options = {"along": tuple(middles[1:]), "inside": True, "weight": "title", "first": 0}
    sketch.label("difference-name", f"B {MINUS} A", "guide", middles[0], **options)  # type: ignore[arg-type]
    if len(scene.rings) > 1 or len(scene.rings[0]) > MAX_NAMED_CORNERS:
        return
    for n, corner in enumerate(scene.rings[0]):
        sketch.add("corner", "dot", "guide", corner, number=n)
        if name := _corner_name(run, corner, scene.move):
            away = Vec(corner.x - middles[0].x, corner.y - middles[0].y)
            sketch.label("corner-name", name, "guide", corner, number=n, prefer=away, optional=True, near=True, first=6)


def _corner_name(run: Trace, corner: Vec, move: Vec) -> str:
    """Return the name of a corner of B - A: that of a corner of B minus that of a corner of A; "" for circles.

    `move`: how far both shapes were moved; the corner may be off by the rounding of this move.
    """
    a, b = run.a, run.b
    if not (isinstance(a, Polygon) and isinstance(b, Polygon)):
        return ""
    close = 1e-9 * max(map(abs, (*corner, *move, 1.0)))
    for j, q in enumerate(b.vertices):
        for i, p in enumerate(a.vertices):
            if abs(q.x - p.x - corner.x) <= close and abs(q.y - p.y - corner.y) <= close:
                return f"{describe.vertex_name(b, 'B', j)} {MINUS} {describe.vertex_name(a, 'A', i)}"
    return ""


def _whole(scene: _Scene) -> Picture:
    """Draw B - A, and say where the origin lies."""
    run = scene.run
    sketch = _sketch(scene, a_weight="faint")
    _difference(sketch, scene)
    sketch.note("verdict", str(run.relation), "ink", weight="title", first=1)
    return sketch.finish("", f"With all points inside B too, this is B {MINUS} A. {_where(run)}")


def _where(run: Trace) -> str:
    """Return a sentence that says where the origin lies, and which relation follows."""
    where = {Relation.APART: "outside", Relation.TOUCHING: "on its rim", Relation.OVERLAPPING: "inside"}[run.relation]
    return f"The origin lies {where}, so A and B {describe.RELATION_PHRASES[run.relation]}."


def _on_axis(scene: _Scene, test: AxisTest) -> Picture:
    """Draw the range of B - A on the axis, and the origin at 0."""
    run = scene.run
    sketch = _sketch(scene, a_weight="faint")
    _difference(sketch, scene)
    (place,) = sketch.layout.places
    sketch.axis(test, place, named=False)
    for number, (point, landing) in enumerate(zip(test.b.points, test.b.landings, strict=True)):
        sketch.add("drop", "segment", "guide", point, place.at(landing), number=number, start=(point,))
    sketch.add("origin-drop", "segment", "ink", ORIGIN, place.at(0.0), weight="faint", start=(ORIGIN,))
    sketch.add("origin-landing", "dot", "ink", place.at(0.0), start=(ORIGIN,))
    ends = [place.at(t, "B") for t in test.b.landings]
    sketch.add("range", "interval", "guide", *ends, start=(ends[0],))
    digits = describe.digits(run, test)
    span = digits.interval(*test.b.interval)
    middle = Vec((ends[0].x + ends[1].x) / 2, (ends[0].y + ends[1].y) / 2)
    sketch.label("range-name", f"B {MINUS} A {span}", "guide", middle, prefer=place.out, first=1)
    sketch.gap(test, place)
    name = describe.axis_name(test.axis, (run.a, run.b), run.names)
    says = {
        Relation.APART: f"and lies outside it, {digits.gap(test.gap)} away: that is the gap",
        Relation.TOUCHING: "and is an end of it: the gap is 0",
        Relation.OVERLAPPING: f"and lies inside it, {digits.gap(test.gap)} from the nearer end: that is the overlap",
    }[run.relation]
    text = f"On the axis ({name}) B {MINUS} A has the range {span}: B's range minus A's."
    return sketch.finish("", f"{text} The origin lands on 0, {says}.")
