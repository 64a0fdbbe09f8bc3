"""The curve of the gap against the direction of the axis, which shows why the edge normals are enough."""

from collections.abc import Sequence
from itertools import pairwise
from math import atan2, cos, degrees, isfinite, pi, radians, sin
from numbers import Real

from ..engine import describe, number_format
from ..engine.axes import WORLD, Axis
from ..engine.geometry import Vec
from ..engine.sat import axis_tests
from ..engine.shapes import Shape
from ..engine.trace import DEFAULT_NAMES
from ..scenes.resolve import SceneLike, resolve
from .float_geometry import range_along
from .label_placer import LabelRequest
from .labels import with_labels
from .layout import Layout
from .marks import Mark, Picture

CURVE_WIDTH_PT, CURVE_HEIGHT_PT = 500.0, 204.0  # a scene unit of this picture is a point
RIM_PT = 16.0  # space to the left and right of the curve
BOTTOM_PT, TOP_PT = 30.0, 172.0  # heights of the curve's lower and upper limit above the lower rim
TICK_HEIGHT_PT = 12.0  # height of the angles' numbers, which stand below the curve
RING_RADIUS_PT = 6.0  # round the chosen angle's gap: an axis's dot shows inside it
MAX_NAMED_AXES = 12


def gap_curve(
    what: SceneLike | Shape, b: Shape | None = None, degree: float | None = None, *, width: float = CURVE_WIDTH_PT
) -> Picture:
    """Return the curve of the signed gap on every axis from 0 to 180 degrees, with the axes that SAT tests as dots.

    `what` is a scene (or its name), a trace, or the first of two shapes.  The gap is in scene units, the angle
    counter-clockwise from x.  `degree` marks one more direction; `width` is the picture's width in points.
    A concave outline has the same ranges as its convex hull, so it gives the same curve.
    TypeError for anything but two shapes, ValueError for an angle that is not a finite number.
    """
    if degree is not None and not (isinstance(degree, Real) and isfinite(degree)):
        raise ValueError(f"degree is {degree!r}: pass a finite number")
    a, b = resolve(what, b).shapes
    points, candidates = sampled_gaps(a, b)
    low, high = min(0.0, *(g for _, g in points)), max(0.0, *(g for _, g in points))
    span = (high - low) or 1.0
    digits = number_format.digits_for_shapes(a, b)

    def at(d: float, gap: float) -> Vec:
        """Return the point of the picture for an angle in degrees and a gap."""
        return Vec(RIM_PT + (width - 2 * RIM_PT) * d / 180, BOTTOM_PT + (TOP_PT - BOTTOM_PT) * ((gap - low) / span))

    marks = [Mark("zero", "segment", "guide", (at(0, 0), at(180, 0)))]
    requests = [LabelRequest("zero-name", "gap 0", "guide", at(180, 0), prefer=Vec(-1.0, 0.3), optional=True)]
    for role, side in ("overlap", -1), ("gap", 1):
        ends = segments_on_side(points, side)
        if ends:
            marks.append(Mark(f"{role}-curve", "segment", role, tuple(at(*p) for p in ends), weight="plain"))
    best = max(points, key=lambda p: p[1])
    role = "gap" if best[1] >= 0 else "overlap"
    requests.append(LabelRequest("best", f"largest {digits.signed(best[1])}", role, at(*best)))
    if degree is not None:
        d, gap = degree % 180, gap_at(a, b, degree)
        marks += [
            Mark("here-line", "segment", "ink", (at(d, low), at(d, high))),
            Mark("here", "disc", "ink", (at(d, gap),), radius=RING_RADIUS_PT),
        ]
        text = f"{number_format.number(round(d, 1))}°: {digits.signed(gap)}"
        requests.insert(0, LabelRequest("here-name", text, "ink", at(d, gap)))
    for i, (d, gap, axis) in enumerate(candidates):
        role = axis.source.shape or "ink"
        marks.append(Mark("candidate", "dot", role, (at(d, gap),), number=i))
        if len(candidates) <= MAX_NAMED_AXES:
            name = _short_axis_label(axis, a, b)
            requests.append(LabelRequest("candidate-name", name, role, at(d, gap), number=i, optional=True))
    spots = [(d, Vec(at(d, 0).x, TICK_HEIGHT_PT)) for d in (0, 45, 90, 135, 180)]
    marks += [
        # the outermost angles keep off the rim
        Mark("tick", "label", "guide", (Vec(min(max(x, 20.0), width - 22.0), y),), number=d, text=f"{d}°")
        for d, (x, y) in spots
    ]
    layout = Layout((0.0, 0.0, width, CURVE_HEIGHT_PT), (width, CURVE_HEIGHT_PT), ())
    marks = with_labels(marks, requests, layout, steady=False, keep_off=())
    return Picture(tuple(marks), layout.limits, layout.size, "", curve_sentence(a, b, best, candidates))


def sampled_gaps(a: Shape, b: Shape) -> tuple[list[tuple[float, float]], list[tuple[float, float, Axis]]]:
    """Return (degree, gap) from 0 to 180 degrees, sorted, and (degree, gap, axis) of the axes of SAT.

    The first list has each whole degree and each of these axes.
    """
    candidates = [(_axis_degree(t.axis), t.gap, t.axis) for t in axis_tests(a, b)]
    grid = {float(d) for d in range(181)} | {d for d, _, _ in candidates}
    return [(d, gap_at(a, b, d)) for d in sorted(grid)], candidates


def gap_at(a: Shape, b: Shape, degree: float) -> float:
    """Return the signed gap on the axis at an angle in degrees, in float64."""
    n = unit_vector(degree)
    return range_along(a, n).gap(range_along(b, n))


def unit_vector(degree: float) -> Vec:
    """Return the unit vector at an angle in degrees counter-clockwise from x, exact for multiples of 90."""
    turns, rest = divmod(degree, 90.0)
    if rest == 0.0:
        return (Vec(1.0, 0.0), Vec(0.0, 1.0), Vec(-1.0, 0.0), Vec(0.0, -1.0))[int(turns) % 4]
    return Vec(cos(radians(degree)), sin(radians(degree)))


def _axis_degree(axis: Axis) -> float:
    """Return the angle of an axis in degrees, from 0 to 180."""
    return degrees(atan2(axis.normal.y, axis.normal.x) % pi)


def segments_on_side(points: Sequence[tuple[float, float]], side: int) -> list[tuple[float, float]]:
    """Return the parts of the curve `points`, (degree, gap), above (side 1) or below (-1) zero, as a list of ends.

    Two ends, one after the other, are a segment.
    """
    found = []
    for (d, g), (e, h) in pairwise(points):
        if g * side > 0 or h * side > 0:
            if g * h < 0:
                zero = (d + (e - d) * g / (g - h), 0.0)
                (d, g), (e, h) = ((d, g), zero) if g * side > 0 else (zero, (e, h))
            found += [(d, g), (e, h)]
    return found


def _short_axis_label(axis: Axis, a: Shape, b: Shape) -> str:
    """Return a label short enough for a dot: the names of the axis's vertices, "x", "y" or "centers"."""
    kind, role, ids = axis.source
    if role:
        shape = a if role == "A" else b
        return describe.edge_name([describe.vertex_name(shape, role, i) for i in ids])
    return "xy"[ids[0]] if kind == WORLD else "centers"


def curve_sentence(
    a: Shape, b: Shape, best: tuple[float, float], candidates: Sequence[tuple[float, float, Axis]]
) -> str:
    """Return a sentence about the curve; `best`: its highest point, `candidates`: (degree, gap, axis)."""
    (at, gap), digits = best, number_format.digits_for_shapes(a, b)
    top = max(candidates, key=lambda c: c[1])
    name = describe.axis_name(top[2], (a, b), DEFAULT_NAMES)
    if gap >= 0:
        first = f"The gap of A and B on every axis from 0 to 180 degrees: the largest is {digits.signed(gap)}"
    else:
        first = f"A and B overlap on every axis from 0 to 180 degrees, least by {digits.gap(gap)}"
    return (
        f"{first}, at {number_format.number(round(at, 1))} degrees. "
        f"Of the {len(candidates)} axes that SAT tests, the best is {name}: {digits.signed(top[1])}."
    )
