"""The picture behind SAT: B - A, one polygon, against the origin, one point.

The shapes share a point exactly where the origin lies in B - A, all differences of a point of B and one of A.
A gap on an axis is how far the origin lies outside on it; the way out is the way to the rim.
"""

from collections.abc import Sequence

from ..engine import describe
from ..engine.geometry import Relation, Vec
from ..engine.number_format import MINUS
from ..engine.sat import AxisTest
from ..engine.shapes import Polygon, Shape
from ..engine.trace import Trace, record
from ..scenes.failing.move_space import minkowski_difference
from ..scenes.resolve import SceneLike, resolve
from .insets import SMALLEST
from .layout import Group, arrange, moved
from .marks import Picture
from .sketch import Sketch


def difference(
    what: SceneLike | Shape, b: Shape | None = None, *, title: str = "", largest: tuple[float, float] = (340.0, 300.0)
) -> Picture:
    """B - A and the origin, in scene units: the origin inside is an overlap, on the rim a touch, outside a miss.

    Of a scene (or its name), two shapes, or a trace.  It shows the separating axis as a normal of the polygon and
    the gap on it, or the way out as the shortest way from the origin to the rim.  Of concave outlines B - A is
    drawn part by part.  ValueError for what cannot be drawn.
    """
    run = resolve(what, b).trace.truth
    # A - B is where B's moves lead into A; seen from the origin, B - A is that turned half round
    found = [tuple(Vec(-p.x, -p.y) for p in ring) for ring in minkowski_difference(run.a, run.b)]
    best = max(run.tests, key=lambda test: test.gap, default=None)
    foot = _foot(best, found) if best and best.gap > 0 else Vec(0.0, 0.0)
    move = run.known_mtv or Vec(0.0, 0.0)
    spots = [Vec(0.0, 0.0), foot, Vec(-move.x, -move.y), *(p for ring in found for p in ring)]
    xs, ys = [p.x for p in spots], [p.y for p in spots]
    box = Polygon([(min(xs), min(ys)), (max(xs), min(ys)), (max(xs), max(ys)), (min(xs), max(ys))])
    sketch = Sketch(record(run.a, run.b), arrange([Group([box], [])], largest=largest)[0])
    for i, ring in enumerate(found):
        sketch.add("difference", "outline", "guide", *ring, number=i)
        if max(abs(p.x - q.x) + abs(p.y - q.y) for p in ring for q in ring[:1]) * sketch.layout.scale < SMALLEST:
            sketch.add("difference-speck", "dot", "guide", _middle(ring), number=i)
    inner = [_middle(ring) for ring in found]
    sketch.label(
        "difference-name", f"B {MINUS} A", "guide", inner[0], along=tuple(inner[1:]), inside=True, weight="title"
    )
    origin = Vec(0.0, 0.0)
    sketch.add("origin", "dot", "ink", origin)
    sketch.label("origin-name", "origin", "ink", origin, prefer=_away(inner[0]), first=1)
    words = _proof(sketch, run, best, foot)
    where = {Relation.APART: "outside", Relation.TOUCHING: "on the rim of", Relation.OVERLAPPING: "inside"}[
        run.relation
    ]
    sketch.note("verdict", str(run.relation), "ink", weight="title", first=1)
    sentence = f"The origin lies {where} B {MINUS} A, so A and B {describe.ARE[run.relation]}{words}."
    return sketch.finish(title, sentence, steady=False)


def _foot(best: AxisTest, found: Sequence[Sequence[Vec]]) -> Vec:
    """How far the origin lies outside on an axis, on that axis."""
    n = best.axis.direction
    far = min((p for ring in found for p in ring), key=lambda p: abs(p.x * n.x + p.y * n.y))
    return moved(Vec(0.0, 0.0), n, best.gap if far.x * n.x + far.y * n.y > 0 else -best.gap)


def _proof(sketch: Sketch, run: Trace, best: AxisTest | None, foot: Vec) -> str:
    """The gap from the origin to the polygon along the best axis, or the way out to its rim."""
    origin = Vec(0.0, 0.0)
    if run.relation is Relation.OVERLAPPING:
        move = run.known_mtv
        if not move:
            return ""
        rim, told = Vec(-move.x, -move.y), describe.digits(run)
        sketch.add("mtv", "arrow", "move", rim, origin, start=(rim,))
        text = f"MTV {told.vector(move)}"
        sketch.label("mtv-name", text, "move", sketch.middle(rim, origin), prefer=Vec(move.y, -move.x), first=2)
        return f": the rim is nearest at {told.vector(rim)}, and moving B by {told.vector(move)} brings it there"
    if best is None or best.gap < 0:
        return ""
    n, told = best.axis.direction, describe.digits(run, best)
    sketch.line_across("side", foot, n, "gap")
    across = Vec(-n.y, n.x)
    low, high = sketch.line_across("axis", origin, across, "guide")
    if best.gap:
        sketch.add("gap", "segment", "gap", origin, foot, weight="strong")
        sketch.label("axis-name", "separating axis", "guide", low, along=(high,), prefer=across, first=3, far=True)
    sketch.label(
        "gap-name",
        describe.outcome(best, told),
        "gap",
        sketch.middle(origin, foot),
        prefer=across,
        first=2,
    )
    name = describe.axis_name(best.axis, (run.a, run.b), run.names)
    return f": the axis ({name}) leaves a gap of {told.gap(best.gap)}" if best.gap else f" on the axis ({name})"


def _middle(ring: Sequence[Vec]) -> Vec:
    return Vec(sum(p.x for p in ring) / len(ring), sum(p.y for p in ring) / len(ring))


def _away(p: Vec) -> Vec:
    return Vec(-p.x, -p.y) if any(p) else Vec(0.0, -1.0)
