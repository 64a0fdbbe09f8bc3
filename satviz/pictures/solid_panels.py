"""The panels of two boxes in space, drawn as solids seen from a corner, with a small plan seen from above."""

from collections.abc import Callable, Sequence
from math import sqrt

from ..engine.describe import gap_in_words
from ..engine.geometry import Vec
from ..engine.number_format import Digits
from ..engine.shapes import Polygon
from ..engine.trace import Trace
from ..scenes.failing.move_space import convex_hull
from ..scenes.failing.threed import PAIR, AxisGap, SolidBox, Vec3, cross, dot, edge_gaps, face_gaps, seen_from_above
from .default_panels import (
    PROVES_NOTHING,
    Panel,
    contents_of_claimed_tests,
    draw_claimed_tests,
    draw_proof,
    needs_proof,
)
from .layout import Layout, PanelContents
from .sketch import Sketch

PLAN_PT = 74.0  # the side of the plan
RIM_PT = 44.0  # above and below the solids, for words
EYE: Vec3 = (1.0, -2.0, 1.4)  # towards the reader


def solid_panel(*, actual: bool) -> Panel:
    """Return a panel of the boxes of `threed.PAIR` with their best face normal, or, if `actual`, a separating axis.

    The trace tests the boxes' plans, seen from above.  A trace of other shapes is drawn as flat shapes.
    """
    flat = Panel(needs_proof, draw_proof) if actual else Panel(contents_of_claimed_tests, draw_claimed_tests)

    def draw(trace: Trace, layout: Layout) -> Sketch:
        """Draw both boxes in space, one axis with its gap, and the plan."""
        if not _are_plans(trace):
            return flat.draw(trace, layout)
        wide, high = layout.size
        sketch = Sketch(trace, Layout((0.0, 0.0, wide, high), layout.size))
        a, b = PAIR
        spots = [_seen(corner) for box in PAIR for corner in corners(box)]
        (x0, x1), (y0, y1) = ((min(c), max(c)) for c in zip(*spots, strict=True))
        scale = min((wide - PLAN_PT - 50) / (x1 - x0), (high - 2 * RIM_PT) / (y1 - y0))
        middle = (wide - PLAN_PT) / 2, high / 2 - 8

        def at(p: Vec3) -> Vec:
            """Return the point of the panel, in points, at which a point in space is drawn."""
            x, y = _seen(p)
            return Vec(middle[0] + (x - (x0 + x1) / 2) * scale, middle[1] + (y - (y0 + y1) / 2) * scale)

        for role, box in (("A", a), ("B", b)):
            points = [at(corner) for corner in corners(box)]
            sketch.add("solid", "outline", role, *convex_hull(points), owner=role)
            edges = [end for p, q in edges_towards_reader(box) for end in (at(p), at(q))]
            sketch.add("solid-edge", "segment", role, *edges, owner=role)
            hull_middle = at(box.center)
            sketch.label("name", role, role, hull_middle, owner=role, weight="title", inside=True)
        best = max(edge_gaps(a, b) if actual else face_gaps(a, b), key=lambda found: found.gap)
        if actual:
            _draw_crossing_edges(sketch, best, at)
        else:
            n = next(
                box.axes[int(best.name[1]) - 1] for role, box in zip("AB", PAIR, strict=True) if best.name[0] == role
            )
            box = a if best.name[0] == "A" else b
            start = tuple(c + h for c, h in zip(box.center, n, strict=True))
            _draw_axis(
                sketch,
                at,
                start,
                n,
                f"face normal {best.name}: {gap_in_words(best.gap, Digits())}\n{PROVES_NOTHING}",
                best.name[0],
            )
        _draw_plan(sketch, wide, high)
        return sketch

    return Panel(lambda trace: PanelContents([trace.a, trace.b]) if _are_plans(trace) else flat.needs(trace), draw)


def _are_plans(trace: Trace) -> bool:
    """Check whether the shapes are the plans of the two boxes in space."""
    return (trace.a, trace.b) == tuple(Polygon(seen_from_above(box)) for box in PAIR)


def _draw_crossing_edges(sketch: Sketch, best: AxisGap, at: Callable[[Vec3], Vec]) -> None:
    """Draw the axis `best`, the cross product of an edge of each box, both edges, and the gap in words.

    `at` gives the point of the panel for a point in space.
    """
    a, b = PAIR
    i, j = int(best.name[1]) - 1, int(best.name[-1]) - 1
    n = cross(a.axes[i], b.axes[j])
    if dot(n, b.center) < dot(n, a.center):
        n = -n[0], -n[1], -n[2]
    for role, box, k, sign in (("A", a, i, 1), ("B", b, j, -1)):
        furthest = max(sign * dot(p, n) for p in corners(box))
        ends = [p for p in corners(box) if abs(sign * dot(p, n) - furthest) < 1e-9]
        along = box.axes[k]
        ends.sort(key=lambda e, along=along: dot(e, along))  # type: ignore[misc]
        p, q = ends[0], ends[-1]
        sketch.add("facing-edge", "segment", role, at(p), at(q), owner=role, weight="strong")
        away, lower = Vec(-sign, -0.6), min(at(p), at(q), key=lambda end: end.y)
        sketch.label("edge-name", f"{role}{k + 1}", role, lower, owner=role, prefer=away, first=3)
    start = tuple((p + q) / 2 for p, q in zip(a.center, b.center, strict=True))
    _draw_axis(sketch, at, start, n, f"across both edges, {best.name}:\n{gap_in_words(best.gap, Digits())}", "gap")


def _draw_axis(
    sketch: Sketch, at: Callable[[Vec3], Vec], start: Sequence[float], n: Vec3, text: str, role: str
) -> None:
    """Draw the direction n in space as an arrow from `start`, with `text` at its tip.

    `at` gives the point of the panel for a point in space.
    """
    length = 1.6 / sqrt(dot(n, n))
    tip = tuple(s + c * length for s, c in zip(start, n, strict=True))
    p, q = at(tuple(start)), at(tip)  # type: ignore[arg-type]
    sketch.add("axis", "arrow", role, p, q, weight="strong")
    sketch.label("axis-name", text, role, q, prefer=Vec(q.x - p.x, q.y - p.y), first=2)


def _draw_plan(sketch: Sketch, wide: float, high: float) -> None:
    """Draw both boxes, small and seen from above, in the right lower corner of a panel `wide` by `high` points."""
    rings = [seen_from_above(box) for box in PAIR]
    spots = [p for ring in rings for p in ring]
    x0, x1, y0, y1 = (f(p[i] for p in spots) for i in (0, 1) for f in (min, max))
    scale = PLAN_PT / max(x1 - x0, y1 - y0)
    corner = Vec(wide - PLAN_PT - 16, 30.0)
    for role, ring in zip("AB", rings, strict=True):
        points = (Vec(corner.x + (p.x - x0) * scale, corner.y + (p.y - y0) * scale) for p in ring)
        sketch.add("outline", "outline", role, *points, owner=role, weight="faint")
    below = Vec(corner.x + PLAN_PT / 2, corner.y - 14)
    sketch.label("plan-name", "seen from above", "guide", below, inside=True, first=1)


def corners(box: SolidBox) -> list[Vec3]:
    """Return the eight corners of a box."""
    found = []
    for signs in ((s, t, u) for s in (-1, 1) for t in (-1, 1) for u in (-1, 1)):
        steps = [tuple(c * s * h for c in axis) for axis, s, h in zip(box.axes, signs, box.half, strict=True)]
        x, y, z = (box.center[k] + sum(step[k] for step in steps) for k in range(3))
        found.append((x, y, z))
    return found


def edges_towards_reader(box: SolidBox) -> list[tuple[Vec3, Vec3]]:
    """Return the three edges that meet in the corner nearest to the reader; the others lie on the outline or behind."""
    near = max(corners(box), key=lambda p: dot(p, EYE))
    found = []
    for axis, half in zip(box.axes, box.half, strict=True):
        way = -1.0 if dot(near, axis) > dot(box.center, axis) else 1.0
        x, y, z = (p + c * way * 2 * half for p, c in zip(near, axis, strict=True))
        found.append((near, (x, y, z)))
    return found


def _seen(p: Vec3) -> tuple[float, float]:
    """Return the parallel projection of a point in space on the plane across EYE, up being z."""
    ex, ey, _ = EYE
    right = (-ey, ex, 0.0)
    up = cross(EYE, right)
    return dot(p, right) / sqrt(dot(right, right)), dot(p, up) / sqrt(dot(up, up))
