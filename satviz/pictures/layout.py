"""The canvas of a picture: which part of a scene it shows, on what scale, and where the axes stand."""

from collections.abc import Sequence
from typing import NamedTuple

from ..engine import number_format
from ..engine.geometry import Vec
from ..engine.sat import AxisTest
from ..engine.shapes import Shape
from .axis_place import LABEL_HEIGHT_PT, OVERHANG_PT, AxisPlace, both_sides, place_axes, placement_penalty
from .float_geometry import Box, bounding_box, common_box, point_along
from .letters import text_size

MAX_OFFSET_SIZES = 2.0**41  # further from the origin than so many of its sizes, float64 rounds an outline away
MAX_LINE_LETTERS = 30  # letters of a range's label up to which it has one line
MAX_WIDTH_PT, MAX_HEIGHT_PT = 500.0, 400.0  # largest size of the canvas
MIN_WIDTH_PT, MIN_HEIGHT_PT = 420.0, 190.0
PAD_PT = 36.0  # space kept free on all sides
NARROW_PAD_PT = 12.0  # space kept free to the left and right on a narrow canvas
# how much smaller than half of the canvas the shapes may become before the canvas is made larger, which is then shown
# smaller; on a telephone small shapes are better than small letters
MAX_SHRINK, MAX_NARROW_SHRINK = 2.5, 10.0
MIN_NARROW_PT = 250.0  # the shorter side of a telephone's canvas, at least
# least share of a narrow canvas's width for the shapes: if it would be less, ranges get no space for numbers
LEAST_PART = 0.3
HEAD_PT = 16.0  # a line of words above the scene
NARROW_PT = 400.0  # a canvas narrower than this is for a telephone
NARROW_SIZE_PT = 340.0, 380.0  # a canvas that such a page shows without making its letters smaller
NAME_WIDTH_PT = 24.0  # width of a label that is only a name


class Inset(NamedTuple):
    """A detail of the scene, and the box beside the scene (scene units) where it is shown larger.

    `name`: the shape, or "" for a gap on the axis of `test`; `spot`: the middle of the detail;
    `times`: the magnification.
    """

    name: str
    spot: Vec
    times: float
    box: Box
    test: AxisTest | None = None

    @property
    def center(self) -> Vec:
        """Return the center of the inset's box."""
        return Vec((self.box[0] + self.box[2]) / 2, (self.box[1] + self.box[3]) / 2)

    def at(self, p: Vec) -> Vec:
        """Return the point in the inset's box that shows the scene's point p, magnified."""
        middle = self.center
        return Vec(middle.x + (p.x - self.spot.x) * self.times, middle.y + (p.y - self.spot.y) * self.times)


class Layout(NamedTuple):
    """The canvas of a picture: the limits it shows in scene units, its size in points, and the places on it.

    There is one place for each test, in the same order.  `brief`: that of the PanelContents it was made for.
    `strip`: the insets have space of their own beside or below the scene, instead of a free corner of it.
    """

    limits: Box
    size: tuple[float, float]
    places: tuple[AxisPlace, ...] = ()
    tests: tuple[AxisTest, ...] = ()
    insets: tuple[Inset, ...] = ()
    brief: bool = False
    strip: bool = True

    @property
    def scale(self) -> float:
        """Return the points in a scene unit."""
        return self.size[0] / (self.limits[2] - self.limits[0])

    @property
    def scene_limits(self) -> Box:
        """Return the limits without the strip of insets beside or below the scene."""
        if not (self.insets and self.strip):
            return self.limits
        x0, y0, x1, y1 = self.limits
        left, top = min(inset.box[0] for inset in self.insets), max(inset.box[3] for inset in self.insets)
        if left > (x0 + x1) / 2:
            return x0, y0, left - self.units(14), y1
        return x0, top, x1, y1

    def units(self, points: float) -> float:
        """Return the length in scene units of `points` points on the canvas."""
        return points / self.scale


class PanelContents(NamedTuple):
    """The contents of one panel or picture: shapes, and the tests whose axes are shown at once.

    `brief`: the ranges are labelled by the shapes' names alone, without numbers.
    """

    shapes: Sequence[Shape]
    tests: Sequence[AxisTest] = ()
    brief: bool = False


def arrange(
    panels: Sequence[PanelContents],
    *,
    largest: tuple[float, float] = (MAX_WIDTH_PT, MAX_HEIGHT_PT),
    least: tuple[float, float] = (MIN_WIDTH_PT, MIN_HEIGHT_PT),
    one_frame: bool = False,
    tight: bool = False,
) -> list[Layout]:
    """Return a layout for each panel, all on one scale, with each axis clear of the shapes and of the other axes.

    `largest` and `least`: bounds of the canvas in points.
    `one_frame`: all layouts have the same limits, around the contents of all panels, so that no shape moves from one
    picture to the next.  `tight`: an axis lies near the shapes, so that the label of the range between them has to
    stand where it fits.
    ValueError for a scene whose outlines float64 cannot draw.
    """
    x0, y0, x1, y1 = bounding_box([shape for panel in panels for shape in panel.shapes])
    size = max(x1 - x0, y1 - y0)
    if not 1e-290 < size < 1e290 or max(map(abs, (x0, y0, x1, y1))) > MAX_OFFSET_SIZES * size:
        raise ValueError(
            f"a scene {size:.3g} across at ({x0:.3g}, {y0:.3g}) cannot be drawn in float64: "
            "move or scale it first (its trace is exact all the same)"
        )
    label_widths = [[_range_label_width(panel, test) for test in panel.tests] for panel in panels]
    while True:
        layouts = _layouts_on(largest, least, panels, label_widths, size, one_frame, tight)
        if layouts is not None:
            return layouts
        # labels have a fixed size in points: a scene too small for them gets a larger canvas, which is shown smaller
        largest = largest[0] * 1.25, largest[1] * 1.25


def arrange_readable(
    panels: Sequence[PanelContents],
    shapes: Sequence[Shape],
    largest: tuple[float, float],
    *,
    one_frame: bool = True,
    tight: bool = False,
) -> list[Layout]:
    """Return a layout for each panel, as `arrange` does; brief ones if `shapes` would be small on a narrow canvas.

    Brief layouts keep no space for the numbers of the ranges.  `largest`: the canvas in points at most; `one_frame`:
    all have the same limits; `tight`: an axis lies near the shapes.
    """
    found = arrange(panels, largest=largest, one_frame=one_frame, tight=tight)
    x0, y0, x1, y1 = bounding_box(shapes)
    part = max(x1 - x0, y1 - y0) * found[0].scale / max(largest[0], found[0].size[0])
    if largest[0] >= NARROW_PT or part >= LEAST_PART:
        return found
    brief = [panel._replace(brief=True) for panel in panels]
    return arrange(brief, largest=largest, one_frame=one_frame, tight=tight)


def range_label(name: str, text: str) -> str:
    """Return the label of a shape's range: its name and `text`, the range's numbers, in two lines if it is long."""
    label = f"{name} {text}"
    return label.replace(" + [", " +\n[") if len(label) > MAX_LINE_LETTERS else label


def _range_label_width(panel: PanelContents, test: AxisTest) -> float:
    """Return the width in points of the wider label of a test's two ranges."""
    if panel.brief:
        return NAME_WIDTH_PT
    digits = number_format.digits_for_tests(panel.shapes, [test])
    return min(max(text_size(range_label("B2", text))[0] for text in digits.ranges(test)), MAX_WIDTH_PT / 3)


def _layouts_on(
    largest: tuple[float, float],
    least: tuple[float, float],
    panels: Sequence[PanelContents],
    label_widths: Sequence[Sequence[float]],
    size: float,
    one_frame: bool,
    tight: bool,
) -> list[Layout] | None:
    """Return the layouts on canvases of at most the largest size; None if the shapes would be too small there.

    `size`: of the shapes, in scene units.  The space around the shapes is given in points, so it depends on the
    scale, and the scale depends on the space: a few rounds settle both.
    """
    pad = PAD_PT if largest[0] >= NARROW_PT else NARROW_PAD_PT
    shrink = MAX_NARROW_SHRINK if min(largest) >= MIN_NARROW_PT and largest[0] < NARROW_PT else MAX_SHRINK
    scale = start = min(largest) / size / 2
    for _ in range(8):
        places: list[list[AxisPlace]] = []
        boxes: list[Box] = []
        for panel, widths in zip(panels, label_widths, strict=True):
            near = [NAME_WIDTH_PT] * len(widths) if tight else widths
            places.append(place_axes(panel.shapes, panel.tests, near, scale, boxes if one_frame else ()))
            boxes.append(_needed_box(panel, places[-1], widths, scale, PAD_PT - pad, tight))
        if one_frame:
            boxes = [common_box(boxes)] * len(boxes)
        space = largest[0] - 2 * pad, largest[1] - 2 * PAD_PT - HEAD_PT
        before, scale = scale, min(most / (box[i + 2] - box[i]) for box in boxes for i, most in enumerate(space))
        if not scale > start / shrink:
            return None
        if abs(scale - before) < 1e-3 * scale:
            break
    found = []
    for panel, (x0, y0, x1, y1), there in zip(panels, boxes, places, strict=True):
        width = round(min(largest[0], max(least[0], (x1 - x0) * scale + 2 * pad)))
        head = HEAD_PT if there or one_frame else 0.0
        height = round(min(largest[1], max(least[1], (y1 - y0) * scale + 2 * PAD_PT + head)))
        limits = limits_around(((x0 + x1) / 2, (y0 + y1 + head / scale) / 2), (width, height), scale)
        found.append(Layout(limits, (width, height), tuple(there), tuple(panel.tests), brief=panel.brief))
    return found


def limits_around(center: tuple[float, float], size: tuple[float, float], scale: float) -> Box:
    """Return the limits of a canvas of that size (points) with the point `center` of the scene in its middle.

    `scale`: points in a scene unit.
    """
    (x, y), (w, h) = center, (side / scale / 2 for side in size)
    return x - w, y - h, x + w, y + h


def _needed_box(
    panel: PanelContents,
    places: Sequence[AxisPlace],
    label_widths: Sequence[float],
    scale: float,
    normal_pt: float,
    tight: bool,
) -> Box:
    """Return the box around the shapes, the axes, and the labels on the far sides of the axes.

    Where an edge gives an axis, the shapes have `normal_pt` points to both sides for an arrow.  `tight`: a label has
    space at one part of its bar, where it makes the box grow least, instead of along the whole axis.
    """
    x0, y0, x1, y1 = bounding_box(panel.shapes)
    if any(test.source.shape for test in panel.tests):
        x0, x1 = x0 - normal_pt / scale, x1 + normal_pt / scale
    ends = [place.at(t, role) for place in places for t in (place.lo, place.hi) for role in "AB"]
    xs, ys = [x0, x1, *(p.x for p in ends)], [y0, y1, *(p.y for p in ends)]
    found = min(xs), min(ys), max(xs), max(ys)
    for test, place, width in zip(panel.tests, places, label_widths, strict=True):
        lo, hi = test.b.interval if tight else (place.lo, place.hi)
        parts = (0.3, 0.5, 0.7) if tight else (0.15, 0.85)
        spots = (place.at(lo + part * (hi - lo), "B") for part in parts)
        labels = [Vec(p.x + place.out.x * width / scale, p.y + place.out.y * LABEL_HEIGHT_PT / scale) for p in spots]
        boxes = [common_box([found, (*p, *p)]) for p in labels]
        found = min(boxes, key=lambda box: box[2] - box[0] + box[3] - box[1]) if tight else common_box(boxes)
    return found


def place_axis_within(
    layout: Layout, shapes: Sequence[Shape], test: AxisTest, last_out: Vec | None = None
) -> AxisPlace:
    """Return a place for an axis inside a layout's limits: clear of the shapes if that fits.

    `last_out`: the direction from the shapes to the axis in the picture before; the axis stays on that side if
    it fits there.
    """
    x0, y0, x1, y1 = layout.limits
    rim = layout.units(OVERHANG_PT)

    def distance_outside(p: Vec) -> float:
        """Return the distance of p from the canvas without its rim, in scene units; 0 inside."""
        return max(x0 + rim - p.x, p.x - x1 + rim, y0 + rim - p.y, p.y - y1 + rim, 0.0)

    def total_outside(place: AxisPlace) -> float:
        """Return how far the two outer ends of the ranges, summed, lie outside the canvas."""
        ends = (r.lo for r in (test.a.interval, test.b.interval)), (r.hi for r in (test.a.interval, test.b.interval))
        return sum(distance_outside(place.at(t)) for t in (min(ends[0]), max(ends[1])))

    places = [*both_sides(shapes, test, layout.scale)]
    if last_out is not None:
        places.sort(key=lambda p: -(p.out.x * last_out.x + p.out.y * last_out.y))
    else:
        places.sort(key=lambda p: placement_penalty(shapes, test, p))
    best = min(places, key=total_outside)
    step = layout.units(8.0)
    for _ in range(60):  # where it fits on neither side, it moves towards the shapes, and over them if it must
        nearer = best._replace(zero=point_along(best.zero, best.out, -step))
        if total_outside(nearer) >= total_outside(best):
            break
        best = nearer
    return best
