"""sv.sweep: an axis turns through 180 degrees, the ranges slide on it, and the gap curve draws itself.

One angle moves everything: the axis, the needle of the dial and the playhead of the curve.

```
        shapes, axis and ranges          dial: sectors with a gap
   ---------------------------------------------------------
        gap curve with the playhead, drawn up to the angle
```
"""

from collections.abc import Sequence
from math import hypot

from ..engine import describe, number_format
from ..engine.axes import GIVEN, Axis, Source
from ..engine.geometry import Vec
from ..engine.sat import AxisTest, project
from ..engine.shapes import Circle, Shape, centroid
from ..scenes.resolve import SceneLike, resolve
from .curve import curve_sentence, sampled_gaps, segments_on_side, unit_vector
from .dial import dial_marks, needle_marks
from .float_geometry import bounding_box, gap_or_overlap, point_along
from .insets import BRACKET_PT
from .letters import text_size
from .marks import Mark, Picture

STEP_DEGREES = 3
SIZE_PT = 500.0, 545.0
STAGE_CENTER_PT = 205.0, 350.0  # center of the circle in which the axis turns
DIAL_CENTER_PT, DIAL_PT = Vec(440.0, 440.0), 42.0  # the dial's center and radius
CURVE_LEFT_PT, CURVE_RIGHT_PT, CURVE_LOW_PT, CURVE_HIGH_PT = 24.0, 476.0, 40.0, 160.0
AXIS_PT, TRACK_PT = 110.0, 5.5  # half of the axis's length; from the axis to a bar
SHAPES_PT, CLEARANCE_PT = 92.0, 26.0  # the radius of the circle around the shapes; from it to the axis
HEAD_PT = 528.0  # height at which the words above the scene stand


def sweep(
    what: SceneLike | Shape, b: Shape | None = None, *, step: int = STEP_DEGREES, title: str = ""
) -> tuple[Picture, ...]:
    """Return the pictures of an axis that turns from 0 to 180 degrees, one for each `step` degrees.

    Each shows both ranges on the axis, the directions with a gap on a dial, and the curve of the gap up to the
    angle; no shape moves.  The curve has its kinks at directions that the edges give: few directions are enough.
    `what` is a scene (or its name), a trace, or the first of two shapes.  A concave outline has the same ranges as
    its convex hull.  ValueError for a step that does not divide 180.
    """
    if isinstance(step, bool) or not isinstance(step, int) or step < 1 or 180 % step:
        raise ValueError(f"step is {step!r}: pass a whole number of degrees that divides 180, such as 3")
    shapes = resolve(what, b).shapes
    points, candidates = sampled_gaps(*shapes)
    sentence = curve_sentence(*shapes, max(points, key=lambda p: p[1]), candidates)
    fixed = [*_shape_marks(shapes), *_dial_marks(points)]
    found = []
    for degree in range(0, 181, step):
        marks = [*fixed, *_axis_marks(shapes, degree), *_curve_marks(points, candidates, degree, shapes)]
        found.append(Picture(tuple(marks), (0.0, 0.0, *SIZE_PT), SIZE_PT, title, sentence))
    return tuple(found)


def _scale_and_center(shapes: tuple[Shape, Shape]) -> tuple[float, Vec]:
    """Return (points in a scene unit, middle of the shapes, around which the axis turns)."""
    x0, y0, x1, y1 = bounding_box(shapes)
    return SHAPES_PT / (hypot(x1 - x0, y1 - y0) / 2), Vec((x0 + x1) / 2, (y0 + y1) / 2)


def _shape_marks(shapes: tuple[Shape, Shape]) -> list[Mark]:
    """Return the outlines and names of both shapes."""
    scale, center = _scale_and_center(shapes)

    def at(p: Vec) -> Vec:
        """Return the point of the canvas at which a point of the scene is drawn."""
        return Vec(STAGE_CENTER_PT[0] + (p.x - center.x) * scale, STAGE_CENTER_PT[1] + (p.y - center.y) * scale)

    marks = []
    for name, shape in zip("AB", shapes, strict=True):
        if isinstance(shape, Circle):
            disc = Mark("outline", "disc", name, (at(shape.center),), owner=name, radius=shape.radius * scale)
            marks.append(disc)
        else:
            marks.append(Mark("outline", "outline", name, tuple(map(at, shape.vertices)), owner=name))
        middle = at(centroid(shape))
        marks.append(Mark("name", "label", name, (middle,), owner=name, text=name, weight="title"))
    return marks


def _axis_marks(shapes: tuple[Shape, Shape], degree: float) -> list[Mark]:
    """Return the axis at an angle, both ranges on it, the drops of their ends, and the gap or overlap."""
    scale, center = _scale_and_center(shapes)
    n = unit_vector(degree)
    out = Vec(n.y, -n.x)
    foot = point_along(Vec(*STAGE_CENTER_PT), out, SHAPES_PT + CLEARANCE_PT)
    middle = center.x * n.x + center.y * n.y
    axis = Axis(n, 1.0, Source(GIVEN))
    sides = project(shapes[0], axis), project(shapes[1], axis)
    test = AxisTest(axis, sides[0], sides[1], sides[0].interval.gap(sides[1].interval))

    def at(t: float, level: float = 0.0) -> Vec:
        """Return the point of coordinate t on the axis, `level` points off it."""
        return point_along(point_along(foot, n, (t - middle) * scale), out, level)

    marks = [Mark("axis", "arrow", "ink", (point_along(foot, n, -AXIS_PT), point_along(foot, n, AXIS_PT)))]
    for name, side, level in zip("AB", sides, (-TRACK_PT, TRACK_PT), strict=True):
        for number, end in enumerate(side.interval):
            point = side.points[side.landings.index(end)]
            across = (point.x - center.x) * out.x + (point.y - center.y) * out.y
            start = at(end, across * scale - SHAPES_PT - CLEARANCE_PT)
            marks.append(Mark("drop", "segment", "guide", (start, at(end)), owner=name, number=number))
        bar = at(side.interval.lo, level), at(side.interval.hi, level)
        marks.append(Mark("range", "interval", name, bar, owner=name))
    lo, hi = gap_or_overlap(test)
    if test.gap > 0:
        near, far = BRACKET_PT
        marks.append(Mark("gap", "bracket", "gap", (at(lo, near), at(lo, far), at(hi, far), at(hi, near))))
    elif test.gap < 0:
        marks.append(Mark("overlap", "interval", "overlap", (at(lo), at(hi))))
    role = "gap" if test.gap > 0 else "overlap" if test.gap < 0 else "ink"
    text = f"{degree}\u00b0: {describe.gap_in_words(test.gap, number_format.digits_for_shapes(*shapes))}"
    left = Vec(20.0 + text_size(text)[0] / 2, HEAD_PT)
    return [*marks, Mark("says", "label", role, (left,), text=text)]


def _dial_marks(gap_curve: Sequence[tuple[float, float]]) -> list[Mark]:
    """Return the dial of the directions that have a gap, with its caption below; `gap_curve`: (degree, gap) pairs."""
    marks = dial_marks(gap_curve, DIAL_CENTER_PT, DIAL_PT)
    has_gap = len(marks) > 1
    text = "green: a gap" if has_gap else "no direction has a gap"
    half_width = text_size(text)[0] / 2
    spot = Vec(min(DIAL_CENTER_PT.x, SIZE_PT[0] - half_width - 6.0), DIAL_CENTER_PT.y - DIAL_PT - 12.0)
    return [*marks, Mark("dial-name", "label", "gap" if has_gap else "ink", (spot,), text=text)]


def _curve_marks(
    points: Sequence[tuple[float, float]],
    candidates: Sequence[tuple[float, float, Axis]],
    degree: float,
    shapes: tuple[Shape, Shape],
) -> list[Mark]:
    """Return the dial's needle, the curve up to an angle with the axes of SAT on it, and the playhead."""
    low, high = min(0.0, *(g for _, g in points)), max(0.0, *(g for _, g in points))
    span = (high - low) or 1.0

    def at(d: float, gap: float) -> Vec:
        """Return the point of the curve for an angle and a gap."""
        x = CURVE_LEFT_PT + (CURVE_RIGHT_PT - CURVE_LEFT_PT) * d / 180
        return Vec(x, CURVE_LOW_PT + (CURVE_HIGH_PT - CURVE_LOW_PT) * (gap - low) / span)

    marks = needle_marks(degree, DIAL_CENTER_PT, DIAL_PT)
    marks.append(Mark("zero", "segment", "guide", (at(0, 0), at(180, 0))))
    done = [p for p in points if p[0] <= degree]
    for role, side in (("overlap", -1), ("gap", 1)):
        if ends := segments_on_side(done, side):
            marks.append(Mark(f"{role}-curve", "segment", role, tuple(at(*p) for p in ends)))
    for number, (d, gap, axis) in enumerate(candidates):
        if d <= degree:
            marks.append(Mark("candidate", "dot", axis.source.shape or "ink", (at(d, gap),), number=number))
    here = max(done, key=lambda p: p[0])
    marks.append(Mark("playhead", "segment", "ink", (at(degree, low), at(degree, high))))
    marks.append(Mark("here", "dot", "ink", (at(*here),)))
    ticks = [(d, f"{d}\u00b0") for d in range(0, 181, 45)]
    marks += [Mark("angle", "label", "guide", (Vec(at(d, 0).x, 16.0),), number=d, text=text) for d, text in ticks]
    words = "gap on every axis; dots: the axes that SAT tests"
    return [*marks, Mark("curve-name", "label", "guide", (Vec(SIZE_PT[0] / 2, CURVE_HIGH_PT + 18.0),), text=words)]
