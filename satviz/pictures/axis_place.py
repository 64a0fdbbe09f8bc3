"""Where an axis is drawn: beside the shapes, clear of them, parallel to its direction.

```
        +----------+
        |  shapes  |
        +----------+
      clearance              space for A's label
   ======== A's bar ========  track
   ----+---- axis ---------+------>  n        out: from the shapes to the axis
   ======== B's bar ========  track
```
"""

from collections.abc import Sequence
from typing import NamedTuple

from ..engine.axes import WORLD
from ..engine.geometry import Vec
from ..engine.sat import AxisTest, Projection
from ..engine.shapes import Shape
from .float_geometry import Box, bounding_box, common_box, point_along, range_along, segments_cross

CLEARANCE_PT = 34.0  # least distance from the shapes to an axis
LABEL_HEIGHT_PT = 18.0  # space for the label of a range
OVERHANG_PT = 20.0  # length by which an axis extends beyond the ranges
MAX_ZERO_DISTANCE_PT = 45.0  # an axis is prolonged to coordinate 0 where that lies no further from the ranges
WORLD_DISTANCES_PT = 20.0, 130.0  # the x axis and the y axis are drawn in their true places so far from the shapes
TRACK_PT = 5.5  # distance from the axis to the bars: A's on the side of the shapes, B's on the other side


class AxisPlace(NamedTuple):
    """The place where an axis is drawn.

    `n`: its unit direction; `out`: the unit vector across it, from the shapes to the axis; `zero`: the point of
    coordinate 0; `lo` and `hi`: the coordinates of its ends; `track`: scene units from the axis to a bar;
    `unit`: scene units in a unit of the axis.  `slid`: the ranges lie so far from the shapes that the axis is
    not to scale: `unit` is not 1, or coordinate 0 is not where it belongs.
    """

    n: Vec
    out: Vec
    zero: Vec
    lo: float
    hi: float
    track: float
    unit: float = 1.0
    slid: bool = False

    def at(self, t: float, role: str = "") -> Vec:
        """Return the point of coordinate t on the axis, or on the track of role "A" or "B"."""
        side = {"A": -self.track, "B": self.track}.get(role, 0.0)
        return point_along(point_along(self.zero, self.n, t * self.unit), self.out, side)

    @property
    def ends(self) -> tuple[Vec, Vec]:
        """Return tail and tip of the axis."""
        return self.at(self.lo), self.at(self.hi)


def place_axes(
    shapes: Sequence[Shape],
    tests: Sequence[AxisTest],
    label_widths: Sequence[float],
    scale: float,
    boxes: Sequence[Box] = (),
) -> list[AxisPlace]:
    """Return one place per test's axis, each on the side where it fits best with the places chosen before it.

    `label_widths`: for each test the width in points of the labels of its ranges; `scale`: points in a scene unit;
    `boxes`: boxes around everything else that is drawn on the same frame.
    """
    around = common_box([bounding_box(shapes), *boxes])
    places: list[AxisPlace] = []
    for test, width in zip(tests, label_widths, strict=True):
        sides = both_sides(shapes, test, scale, width)
        places.append(
            min(sides, key=lambda p: (_count_crossings(p, places), placement_penalty(shapes, test, p, around)))
        )
    return places


def both_sides(
    shapes: Sequence[Shape], test: AxisTest, scale: float, label_width: float = 0.0
) -> tuple[AxisPlace, AxisPlace]:
    """Return the two possible places of a test's axis, one on either side of the shapes.

    Between the shapes and the axis there is space for a label `label_width` points wide; 0 means no label.  `scale`:
    points in a scene unit.
    """
    n = test.axis.direction
    ranges = test.a.interval, test.b.interval
    lo, hi = min(r.lo for r in ranges), max(r.hi for r in ranges)
    unit, slide = _unit_and_slide(shapes, n, lo, hi)
    points = scale * unit
    if 0 < lo < MAX_ZERO_DISTANCE_PT / points:
        lo = 0.0
    if -MAX_ZERO_DISTANCE_PT / points < hi < 0:
        hi = 0.0

    def on_side(out: Vec) -> AxisPlace:
        """Return the place on the side of the shapes to which `out` points.

        A world axis that lies near the shapes and clear of them stays where it is.
        """
        beyond = -_furthest(shapes, out)
        least, most = (points / scale for points in WORLD_DISTANCES_PT)
        if test.source.kind == WORLD and least <= beyond <= most and not slide:
            first, last = min(lo, 0.0) - OVERHANG_PT / points, max(hi, 0.0) + OVERHANG_PT / points
            return AxisPlace(n, out, Vec(0.0, 0.0), first, last, TRACK_PT / scale)
        label = abs(out.x) * label_width + abs(out.y) * LABEL_HEIGHT_PT + TRACK_PT + 7.0
        away = _furthest(shapes, out) + max(CLEARANCE_PT, label if label_width else 0.0) / scale
        zero = point_along(Vec(out.x * away, out.y * away), n, slide)
        ends = lo - OVERHANG_PT / points, hi + OVERHANG_PT / points
        return AxisPlace(n, out, zero, *ends, TRACK_PT / scale, unit, bool(slide))

    return on_side(Vec(n.y, -n.x)), on_side(Vec(-n.y, n.x))


def _unit_and_slide(shapes: Sequence[Shape], n: Vec, lo: float, hi: float) -> tuple[float, float]:
    """Return (scene units in a unit of the axis, scene units by which coordinate 0 is moved along the axis).

    They are (1, 0) where the ranges, from lo to hi, lie near the shapes.  The ranges that a shortcut measures may lie
    far away or be much larger, and would not fit on the shapes' own scale.
    """
    x0, y0, x1, y1 = bounding_box(shapes)
    size = max(x1 - x0, y1 - y0)
    far, near = _furthest(shapes, n), _furthest(shapes, Vec(-n.x, -n.y))
    if max(-near - lo, hi - far) <= size:
        return 1.0, 0.0
    unit = min(1.0, 2 * size / (hi - lo))
    return unit, (far - near) / 2 - (lo + (hi - lo) / 2) * unit


def _furthest(shapes: Sequence[Shape], direction: Vec) -> float:
    """Return the largest coordinate of the shapes along a unit direction from the origin, in scene units."""
    return max(range_along(shape, direction).hi for shape in shapes)


def placement_penalty(shapes: Sequence[Shape], test: AxisTest, place: AxisPlace, around: Box | None = None) -> float:
    """Return the penalty, without unit, of drawing a test's axis at `place`; the lower place is better.

    An axis should not widen the scene (or the box `around`) much.  It should lie near the shape whose edge it comes
    from, so that the drop lines of that shape pass no other shape, and below the shapes or to their left.
    """
    x0, y0, x1, y1 = around or bounding_box(shapes)
    xs, ys = [x0, x1, *(p.x for p in place.ends)], [y0, y1, *(p.y for p in place.ends)]
    size = max(x1 - x0, y1 - y0)
    area = (max(xs) - min(xs)) / size * ((max(ys) - min(ys)) / size)
    away = 0.0
    if test.source.shape:
        own, other = (test.a, test.b) if test.source.shape == "A" else (test.b, test.a)
        away = (_mean_coordinate(other, place.out) - _mean_coordinate(own, place.out)) / size
    above = place.out.y > 1e-9 or (abs(place.out.y) <= 1e-9 and place.out.x > 0)
    return area + away + 0.6 * above


def _mean_coordinate(side: Projection, direction: Vec) -> float:
    """Return the mean coordinate of a projection's points along a direction."""
    return sum(p.x * direction.x + p.y * direction.y for p in side.points) / len(side.points)


def _count_crossings(place: AxisPlace, others: Sequence[AxisPlace]) -> int:
    """Return how many of the other axes cross this one; the tracks of B's bars are compared."""
    mine = place.at(place.lo, "B"), place.at(place.hi, "B")
    return sum(segments_cross(mine, (o.at(o.lo, "B"), o.at(o.hi, "B"))) for o in others)
