"""The gap against the direction of the axis: why the edge normals are enough becomes visible."""

from collections.abc import Sequence
from itertools import pairwise
from math import atan2, cos, degrees, isfinite, pi, radians, sin
from numbers import Real

from ..engine import describe, number_format
from ..engine.axes import WORLD, Axis
from ..engine.geometry import Vec
from ..engine.sat import axis_tests
from ..engine.shapes import Circle, Shape
from ..engine.trace import PLAIN
from ..scenes.resolve import SceneLike, resolve
from .labels import Request, with_labels
from .layout import Layout
from .marks import Mark, Picture

WIDTH, HEIGHT = 500.0, 204.0  # points; the picture's own units
RIM, BOTTOM, TOP = 16.0, 30.0, 172.0
HERE = 6.0
MOST_NAMES = 12


def gap_curve(
    what: SceneLike | Shape, b: Shape | None = None, degree: float | None = None, *, width: float = WIDTH
) -> Picture:
    """The signed gap on every axis from 0 to 180 degrees, with the axes that SAT would test marked on it.

    Of a scene (or its name), two shapes, or a trace.  The gap is in scene units, the angle
    counter-clockwise from x.  `degree` marks one more direction, `width` is the picture's in
    points.  Concave outlines count as their convex hulls, whose ranges are the same.
    TypeError for anything else, ValueError for an angle that is no finite number.
    """
    if degree is not None and not (isinstance(degree, Real) and isfinite(degree)):
        raise ValueError(f"degree is {degree!r}: pass a finite number")
    a, b = resolve(what, b).shapes
    candidates = [(_degree(t.axis), t.gap, t.axis) for t in axis_tests(a, b)]
    grid = {float(d) for d in range(181)} | {d for d, _, _ in candidates}
    points = [(d, gap_at(a, b, d)) for d in sorted(grid)]
    lo, hi = min(g for _, g in points), max(g for _, g in points)
    low, high = min(lo, 0.0), max(hi, 0.0)
    span = (high - low) or 1.0

    def at(d: float, gap: float) -> Vec:
        return Vec(RIM + (width - 2 * RIM) * d / 180, BOTTOM + (TOP - BOTTOM) * ((gap - low) / span))

    marks = [Mark("zero", "segment", "guide", (at(0, 0), at(180, 0)))]
    requests = [Request("zero-name", "gap 0", "guide", at(180, 0), prefer=Vec(-1.0, 0.3), optional=True)]
    for role, side in ("overlap", -1), ("gap", 1):
        pieces = _pieces(points, side)
        if pieces:
            marks.append(Mark(f"{role}-curve", "segment", role, tuple(at(*p) for p in pieces), weight="plain"))
    best = max(points, key=lambda p: p[1])
    requests.append(
        Request("best", f"largest {number_format.of_shapes(a, b).signed(best[1])}", _role(best[1]), at(*best))
    )
    if degree is not None:
        d, gap = degree % 180, gap_at(a, b, degree)
        marks += [
            Mark("here-line", "segment", "ink", (at(d, low), at(d, high))),
            Mark("here", "disc", "ink", (at(d, gap),), radius=HERE),  # a ring: a candidate's dot shows inside it
        ]
        text = f"{number_format.number(round(d, 1))}°: {number_format.of_shapes(a, b).signed(gap)}"
        requests.insert(0, Request("here-name", text, "ink", at(d, gap)))
    for i, (d, gap, axis) in enumerate(candidates):
        role = axis.source.shape or "ink"
        marks.append(Mark("candidate", "dot", role, (at(d, gap),), number=i))
        if len(candidates) <= MOST_NAMES:
            name = _short(axis, a, b)
            requests.append(Request("candidate-name", name, role, at(d, gap), number=i, optional=True))
    spots = [(d, Vec(at(d, 0).x, 12.0)) for d in (0, 45, 90, 135, 180)]
    marks += [
        # the outermost clear of the rim
        Mark("tick", "label", "guide", (Vec(min(max(x, 20.0), width - 22.0), y),), number=d, text=f"{d}°")
        for d, (x, y) in spots
    ]
    layout = Layout((0.0, 0.0, width, HEIGHT), (width, HEIGHT), ())
    marks = with_labels(marks, requests, layout, steady=False, keep_off=())
    return Picture(tuple(marks), layout.limits, layout.size, "", _sentence(a, b, best, candidates))


def gap_at(a: Shape, b: Shape, degree: float) -> float:
    """The signed gap on the axis at that angle, in float64."""
    n = direction(degree)
    (alo, ahi), (blo, bhi) = (_range(shape, n) for shape in (a, b))
    return max(blo - ahi, alo - bhi)


def direction(degree: float) -> Vec:
    """The unit vector at an angle counter-clockwise from x, exact on the quarter turns."""
    turns, rest = divmod(degree, 90.0)
    if rest == 0.0:
        return (Vec(1.0, 0.0), Vec(0.0, 1.0), Vec(-1.0, 0.0), Vec(0.0, -1.0))[int(turns) % 4]
    return Vec(cos(radians(degree)), sin(radians(degree)))


def _range(shape: Shape, n: Vec) -> tuple[float, float]:
    if isinstance(shape, Circle):
        at = shape.center.x * n.x + shape.center.y * n.y
        return at - shape.radius, at + shape.radius
    dots = [v.x * n.x + v.y * n.y for v in shape.corners]
    return min(dots), max(dots)


def _degree(axis: Axis) -> float:
    return degrees(atan2(axis.normal.y, axis.normal.x) % pi)


def _role(gap: float) -> str:
    return "gap" if gap >= 0 else "overlap"


def _pieces(points: Sequence[tuple[float, float]], side: int) -> list[tuple[float, float]]:
    """The parts of the curve above (1) or below (-1) zero, two points a piece."""
    found = []
    for (d, g), (e, h) in pairwise(points):
        if g * side > 0 or h * side > 0:
            if g * h < 0:
                zero = (d + (e - d) * g / (g - h), 0.0)
                (d, g), (e, h) = ((d, g), zero) if g * side > 0 else (zero, (e, h))
            found += [(d, g), (e, h)]
    return found


def _short(axis: Axis, a: Shape, b: Shape) -> str:
    """What fits beside a dot: the edge or the vertex that the axis comes from, or x and y."""
    kind, role, ids = axis.source
    if role:
        shape = a if role == "A" else b
        return describe.edge_name([describe.vertex_name(shape, role, i) for i in ids])
    return "xy"[ids[0]] if kind == WORLD else "centers"


def _sentence(a: Shape, b: Shape, best: tuple[float, float], candidates: Sequence[tuple[float, float, Axis]]) -> str:
    (at, gap), told = best, number_format.of_shapes(a, b)
    top = max(candidates, key=lambda c: c[1])
    name = describe.axis_name(top[2], (a, b), PLAIN)
    if gap >= 0:
        first = f"The gap of A and B on every axis from 0 to 180 degrees: the largest is {told.signed(gap)}"
    else:
        first = f"A and B overlap on every axis from 0 to 180 degrees, least by {told.gap(gap)}"
    return (
        f"{first}, at {number_format.number(round(at, 1))} degrees. "
        f"Of the {len(candidates)} axes that SAT tests, the best is {name}: {told.signed(top[1])}."
    )
