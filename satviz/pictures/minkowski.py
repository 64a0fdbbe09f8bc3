"""The Minkowski difference B - A, all differences of a point of B and a point of A, drawn against the origin.

The shapes share a point exactly if the origin lies in B - A.  A gap on an axis is the distance by which the origin
lies outside B - A along it; the MTV of an overlap leads from the nearest point of the rim to the origin.
"""

from collections.abc import Sequence

from ..engine import describe
from ..engine.geometry import Relation, Vec
from ..engine.number_format import MINUS
from ..engine.sat import AxisTest
from ..engine.shapes import Shape
from ..engine.trace import Trace, record
from ..scenes.failing.move_space import minkowski_difference
from ..scenes.resolve import SceneLike, resolve
from ..scenes.shape_tools import box
from .float_geometry import mean_point, midpoint, point_along
from .insets import MIN_SHAPE_PT
from .layout import PanelContents, arrange
from .marks import Picture
from .sketch import Sketch


def difference(
    what: SceneLike | Shape, b: Shape | None = None, *, title: str = "", largest: tuple[float, float] = (340.0, 300.0)
) -> Picture:
    """Return the picture of B - A and the origin: inside it for an overlap, on its rim for a touch, outside if apart.

    `what` is a scene (or its name), a trace, or the first of two shapes.  The picture shows the separating axis as a
    normal of B - A with the gap on it, or the MTV as the shortest way from the rim to the origin.  For concave
    outlines B - A is drawn part by part.  ValueError for shapes that cannot be drawn.
    """
    run = resolve(what, b).trace.truth
    # `rings` gives A - B, and B - A is A - B turned by 180 degrees
    found = [tuple(Vec(-p.x, -p.y) for p in ring) for ring in minkowski_difference(run.a, run.b)]
    best = max(run.tests, key=lambda test: test.gap, default=None)
    foot = _foot_on_axis(best, found) if best and best.gap > 0 else Vec(0.0, 0.0)
    move = run.known_mtv or Vec(0.0, 0.0)
    spots = [Vec(0.0, 0.0), foot, Vec(-move.x, -move.y), *(p for ring in found for p in ring)]
    xs, ys = [p.x for p in spots], [p.y for p in spots]
    around = box(min(xs), min(ys), max(xs), max(ys))
    sketch = Sketch(record(run.a, run.b), arrange([PanelContents([around])], largest=largest)[0])
    for i, ring in enumerate(found):
        sketch.add("difference", "outline", "guide", *ring, number=i)
        if max(abs(p.x - q.x) + abs(p.y - q.y) for p in ring for q in ring[:1]) * sketch.layout.scale < MIN_SHAPE_PT:
            sketch.add("difference-speck", "dot", "guide", mean_point(ring), number=i)
    inner = [mean_point(ring) for ring in found]
    sketch.label(
        "difference-name", f"B {MINUS} A", "guide", inner[0], along=tuple(inner[1:]), inside=True, weight="title"
    )
    origin = Vec(0.0, 0.0)
    sketch.add("origin", "dot", "ink", origin)
    sketch.label("origin-name", "origin", "ink", origin, prefer=_vector_to_origin(inner[0]), first=1)
    words = _draw_proof(sketch, run, best, foot)
    where = {Relation.APART: "outside", Relation.TOUCHING: "on the rim of", Relation.OVERLAPPING: "inside"}[
        run.relation
    ]
    sketch.note("verdict", str(run.relation), "ink", weight="title", first=1)
    sentence = f"The origin lies {where} B {MINUS} A, so A and B {describe.RELATION_PHRASES[run.relation]}{words}."
    return sketch.finish(title, sentence, steady=False)


def _foot_on_axis(best: AxisTest, found: Sequence[Sequence[Vec]]) -> Vec:
    """Return the point where the range of B - A (its rings `found`) on the best axis begins, `best.gap` from 0."""
    n = best.axis.direction
    far = min((p for ring in found for p in ring), key=lambda p: abs(p.x * n.x + p.y * n.y))
    return point_along(Vec(0.0, 0.0), n, best.gap if far.x * n.x + far.y * n.y > 0 else -best.gap)


def _draw_proof(sketch: Sketch, run: Trace, best: AxisTest | None, foot: Vec) -> str:
    """Draw the gap from the origin to `foot` on the axis of `best`, or the MTV; return a phrase about it, else ""."""
    origin = Vec(0.0, 0.0)
    if run.relation is Relation.OVERLAPPING:
        move = run.known_mtv
        if not move:
            return ""
        rim, digits = Vec(-move.x, -move.y), describe.digits(run)
        sketch.add("mtv", "arrow", "move", rim, origin, start=(rim,))
        text = f"MTV {digits.vector(move)}"
        sketch.label("mtv-name", text, "move", midpoint(rim, origin), prefer=Vec(move.y, -move.x), first=2)
        return f": the rim is nearest at {digits.vector(rim)}, and moving B by {digits.vector(move)} brings it there"
    if best is None or best.gap < 0:
        return ""
    n, digits = best.axis.direction, describe.digits(run, best)
    sketch.line_across("side", foot, n, "gap")
    across = Vec(-n.y, n.x)
    low, high = sketch.line_across("axis", origin, across, "guide")
    if best.gap:
        sketch.add("gap", "segment", "gap", origin, foot, weight="strong")
        sketch.label("axis-name", "separating axis", "guide", low, along=(high,), prefer=across, first=3, far=True)
    sketch.label(
        "gap-name",
        describe.outcome(best, digits),
        "gap",
        midpoint(origin, foot),
        prefer=across,
        first=2,
    )
    name = describe.axis_name(best.axis, (run.a, run.b), run.names)
    return f": the axis ({name}) leaves a gap of {digits.gap(best.gap)}" if best.gap else f" on the axis ({name})"


def _vector_to_origin(p: Vec) -> Vec:
    """Return the vector from p to the origin; a unit vector downwards if p is the origin."""
    return Vec(-p.x, -p.y) if any(p) else Vec(0.0, -1.0)
