"""A sketch of a test: the edge or line its axis comes from, the normal, the axis, drops, ranges, the gap.

Every number comes from the trace.  A landing is a point's coordinate on an axis, and a drop is the dotted line from the
point to its landing.  A role is "A" or "B", the shape that a mark belongs to, or another colour of the theme.
"""

from collections.abc import Sequence
from math import ceil, floor, hypot
from typing import Unpack

from ..engine import describe, number_format
from ..engine.axes import CENTERS, EARLY_EXIT, EDGE, FROM_EDGES, HULL, PARALLEL, SLIP, VERTEX, WORLD, Axis, edge_normals
from ..engine.geometry import Vec
from ..engine.landing_sum import AXIS, PLAIN, POINT, landing_sum
from ..engine.sat import AxisTest, Projection
from ..engine.shapes import Circle, Shape
from ..engine.trace import Trace
from .axis_place import AxisPlace
from .float_geometry import are_parallel, gap_or_overlap, midpoint, point_along
from .insets import BRACKET_PT
from .label_placer import LabelOptions, Segment
from .labels import short_name
from .layout import MAX_LINE_LETTERS, NARROW_PAD_PT, NARROW_PT, Layout, range_label
from .letters import text_size, wrap_text
from .marks import MarkOptions
from .shape_sketch import ShapeSketch
from .theme import BAR_PT

NORMAL_PT = 34.0  # the length of a normal's arrow
RING_PT = 8.0  # the radius of a ring round a corner
CROSS_PT = 4.5  # half of the side of a cross
MIN_ARROW_PT, MIN_STRONG_PT = 14.0, 28.0  # a shorter edge is drawn without an arrow head, or with a thin arrow
MIN_DOTTED_PT = 16.0  # a shorter overlap has no dots at its ends; half of it: a thin bracket
CLEAR_OF_DOT_PT = 8.0  # distance from the tip of an arrow along a line to the dot at the line's end
RIGHT_ANGLE_PT = 7.0  # the side of the mark between an edge and its normal
MIN_TICK_PT = 24.0  # least distance between two ticks
ZERO_TICK_PT = 4.5  # half of the tick at coordinate 0
MAX_LIST_LETTERS = 34  # letters in a line of the list of axes that were not tested
MAX_LISTED_AXES, MAX_NARROW_LISTED_AXES = 8, 5  # on a wide canvas and on a telephone's
GREY_NORMAL = 0.6  # how long the normal of an axis not tested is, in normals of a test
MAX_GREY_NORMALS = 16  # more of them would fill the gap


class Sketch(ShapeSketch):
    """A sketch of a trace with its tests; `prefix` tells its axes from those of another trace in the same picture."""

    def __init__(self, trace: Trace, layout: Layout, prefix: str = "") -> None:
        """Make an empty sketch; `prefix` begins the ids of its axes."""
        super().__init__(trace, layout)
        self.prefix = prefix

    # -- where the axis comes from

    def edge(self, test: AxisTest, *, named: bool = False) -> None:
        """Draw the edge, or the line between two points, that the axis comes from; `named` labels it as a vector."""
        (kind, _, ids), role = test.source, test.source.shape or "ink"
        if kind in FROM_EDGES:
            name, polygon = self.named_polygon(role)
            p, q = (polygon.vertices[i] for i in ids)
            # the edge as the difference of its ends; an arrow head must not hide a short one
            length = hypot(p.x - q.x, p.y - q.y) * self.layout.scale
            kind, weight = (
                "arrow" if length > MIN_ARROW_PT else "segment",
                "strong" if length > MIN_STRONG_PT else "plain",
            )
            self.add("edge", kind, role, q, p, weight=weight)
            if named:
                self.vertices(role, ids)
                ends = [short_name(polygon, name, i) for i in ids]
                text = f"edge = {describe.edge_vector(self.trace, ends, p, q)}".replace(" = (", "\n= (")
                # a quarter along the edge, clear of the normal, which stands in the middle
                clear = midpoint(midpoint(p, q), q)
                self.label("edge-name", text, role, clear, prefer=self.arrow_direction(test.axis), first=1)
        elif kind in (CENTERS, VERTEX):
            p, q = self.joined_points(test)
            self.add("edge", "segment", "ink", p, q)
            for i, end in enumerate((p, q)):
                self.add("edge-end", "dot", "AB"[i], end, number=i)
            if named:
                along = max(Vec(q.x - p.x, q.y - p.y), Vec(p.x - q.x, p.y - q.y))  # as the axis points
                self.label("edge-name", describe.digits(self.trace).vector(along), "ink", midpoint(p, q), first=1)

    def joined_points(self, test: AxisTest) -> Segment:
        """Return the two points whose difference is the axis, A's first: centers, or a center and a vertex."""
        both = self.trace.a, self.trace.b
        p, q = (s.center if isinstance(s, Circle) else s.vertices[test.source.ids[0]] for s in both)
        return p, q

    def normal_arrow(self, test: AxisTest) -> Segment | None:
        """Return (tail, tip) of an arrow along the axis, on its edge or line; None if the axis comes from neither."""
        kind, role, ids = test.source
        length = self.layout.units(NORMAL_PT)
        if kind in FROM_EDGES:
            _, polygon = self.named_polygon(role)
            start = midpoint(*(polygon.vertices[i] for i in ids))
        elif kind in (CENTERS, VERTEX):
            p, q = self.joined_points(test)
            start, clear = midpoint(p, q), hypot(q.x - p.x, q.y - p.y) / 2 - self.layout.units(CLEAR_OF_DOT_PT)
            length = min(length, clear) if clear > self.layout.units(MIN_ARROW_PT) else length
        else:
            return None
        return start, point_along(start, self.arrow_direction(test.axis), length)

    def upcoming_normals(self) -> list[Segment]:
        """Return the arrow (tail, tip) of each test's normal and of each of `grey_normals`, drawn already or not."""
        arrows = [arrow for arrow in map(self.normal_arrow, self.trace.tests) if arrow]
        return [*arrows, *(self.small_normal_arrow(axis, GREY_NORMAL) for axis in self.grey_normals())]

    def arrow_direction(self, axis: Axis) -> Vec:
        """Return the axis's direction, or its opposite where the axis is a normal that points into its shape."""
        n = axis.direction
        return n if describe.points_outward(self.trace, axis) else Vec(-n.x, -n.y)

    def normal(self, test: AxisTest, *, named: bool = False) -> None:
        """Draw an arrow along the axis on its edge or line, if it has one; `named` labels it as a vector."""
        arrow = self.normal_arrow(test)
        if arrow is None:
            return
        kind, owner, _ = test.source
        role, direction = (owner if kind in FROM_EDGES else "") or "ink", self.arrow_direction(test.axis)
        if kind in (EDGE, HULL):
            self.right_angle(arrow[0], direction)
        self.add("normal", "arrow", role, *arrow, start=arrow[:1])
        if named:
            text = "direction"
            if kind in FROM_EDGES:
                what = "one sign changed:" if kind == SLIP else "normal"
                between = " " if direction == test.axis.direction or kind == SLIP else "\n"
                text = f"{what}{between}{describe.outward_normal(self.trace, test.axis)}"
            middle = midpoint(*arrow)
            self.label("normal-name", text, role, arrow[1], prefer=direction, along=(middle,), first=1)

    def right_angle(self, foot: Vec, normal: Vec, **more: Unpack[MarkOptions]) -> None:
        """Draw the right-angle sign at `foot`, between an edge (or an axis) and the unit vector `normal`."""
        size = self.layout.units(RIGHT_ANGLE_PT)
        along = Vec(-normal.y, normal.x)
        up, side = point_along(foot, normal, size), point_along(foot, along, size)
        corner = point_along(up, along, size)
        self.add("right-angle", "segment", "ink", up, corner, corner, side, **more)

    def right_angle_at_axis(self, test: AxisTest, place: AxisPlace, point: Vec, foot: Vec) -> None:
        """Draw the right-angle sign where the line from `point` meets the axis in `foot`, if there is space for it."""
        away = Vec(point.x - foot.x, point.y - foot.y)
        length, along = hypot(*away), away.x * place.n.x + away.y * place.n.y
        if length > 3 * self.layout.units(RIGHT_ANGLE_PT) and abs(along) < length / 1e3:
            self.right_angle(foot, Vec(away.x / length, away.y / length), axis=self.axis_id(test))

    def no_axis(self, test: AxisTest) -> None:
        """Draw a ring round the single point of an edge of length 0, and say that it gives no axis."""
        role = test.source.shape or "A"
        self.vertices(role, test.source.ids[:1])
        name, polygon = self.named_polygon(role)
        ends = " and ".join(short_name(polygon, name, i) for i in test.source.ids)
        v = polygon.vertices[test.source.ids[0]]
        self.add("one-place", "disc", "wrong", v, owner=name, radius=self.layout.units(RING_PT))
        lines = f"{ends} lie in one place: no normal but (0, 0),", "on which every point lands at 0.  0 < 0: no gap"
        space = self.layout.size[0] - 2 * NARROW_PAD_PT
        text = "\n".join(line if text_size(line)[0] <= space else wrap_text(line, space) for line in lines)
        low = Vec((self.layout.limits[0] + self.layout.limits[2]) / 2, self.layout.limits[1])
        self.label("no-axis", text, "ink", low, first=1, far=True)

    def crossed_normals(self, axes: Sequence[Axis]) -> None:
        """Draw in grey the normals of edges that were left out, each with a cross over it."""
        size = self.layout.units(CROSS_PT)
        for n, axis in enumerate(axes):
            self.small_normal("left-out", axis, 0.8, "guide", number=n)
            middle = midpoint(*self.marks[-1].points)
            ends = [Vec(middle.x + x * size, middle.y + y * size) for x, y in ((-1, -1), (1, 1), (-1, 1), (1, -1))]
            self.add("left-out-cross", "segment", "wrong", *ends, number=n)

    def all_normals(self) -> None:
        """Draw a small outward arrow on every edge of both shapes."""
        axes = edge_normals(self.trace.a, self.trace.b).axes
        for role, name, _ in self.roles():
            for i, axis in enumerate(axis for axis in axes if axis.source.shape == role):
                self.small_normal("normal", axis, 0.8, role, owner=name, number=i)

    def small_normal(self, part: str, edge_normal: Axis, size: float, role: str, **more: Unpack[MarkOptions]) -> None:
        """Draw an edge's outward normal as an arrow, the mark `part`, `size` times as long as the normal of a test."""
        self.add(part, "arrow", role, *self.small_normal_arrow(edge_normal, size), **more)

    def small_normal_arrow(self, edge_normal: Axis, size: float) -> Segment:
        """Return tail and tip of an edge's outward normal, `size` times as long as the normal of a test."""
        _, polygon = self.named_polygon(edge_normal.source.shape)
        foot = midpoint(*(polygon.vertices[i] for i in edge_normal.source.ids))
        return foot, point_along(foot, self.arrow_direction(edge_normal), self.layout.units(NORMAL_PT * size))

    # -- the axis and what lands on it

    def test_number(self, test: AxisTest) -> int:
        """Return the number of a test in the trace, from 1."""
        return next(i for i, other in enumerate(self.trace.tests, 1) if other is test)

    def axis_id(self, test: AxisTest) -> str:
        """Return the id of the test's axis in the picture."""
        return f"{self.prefix}{self.test_number(test)}"

    def axis_label(self, test: AxisTest) -> str:
        """Return the words at the tip of a test's axis."""
        return f"axis {self.test_number(test)}"

    def axis(self, test: AxisTest, place: AxisPlace, *, named: bool = True) -> None:
        """Draw the axis as a long arrow with a tick at coordinate 0 if that lies on it; `named` adds its name."""
        start = self.normal_arrow(test) or ()
        if start and self.arrow_direction(test.axis) != test.axis.direction:
            start = start[::-1]  # so that the axis grows out of the normal without turning over
        axis = self.axis_id(test)
        self.add("axis", "arrow", "ink", *place.ends, axis=axis, start=start)
        if named:
            kind, _, ids = test.source
            text = "xy"[ids[0]] if kind == WORLD else self.axis_label(test)
            text += "\n(not to scale)" if place.slid else ""
            self.label("axis-name", text, "ink", place.at(place.hi), axis=axis, prefer=place.n, first=3)
        if place.lo < 0 < place.hi:
            half = self.layout.units(ZERO_TICK_PT)
            tick = (point_along(place.at(0.0), place.out, side * half) for side in (-1, 1))
            self.add("zero", "segment", "ink", *tick, axis=axis)
            options: LabelOptions = {"axis": axis, "prefer": place.out, "optional": True}
            self.label("zero-name", "0", "ink", place.at(0.0), first=0, **options)

    def right_angle_of_line(self, point: Vec, place: AxisPlace) -> None:
        """Draw the right-angle sign where the line through `point`, across an axis, meets the axis."""
        off = Vec(point.x - place.zero.x, point.y - place.zero.y)
        foot = point_along(place.zero, place.n, off.x * place.n.x + off.y * place.n.y)
        self.right_angle(foot, Vec(-place.out.x, -place.out.y), owner="line")

    def ticks(self, test: AxisTest, place: AxisPlace) -> None:
        """Draw ticks on an axis at multiples of a round step, with their numbers; none at 0."""
        longest = self.layout.units(MIN_TICK_PT)
        step = next(s * 10.0**k for k in range(-300, 300) for s in (1, 2, 5) if s * 10.0**k >= longest)
        half = self.layout.units(ZERO_TICK_PT) * 0.7
        for k in range(ceil(place.lo / step), floor((place.hi - longest) / step) + 1):
            spot = place.at(k * step)
            if k:
                ends = (point_along(spot, place.out, side * half) for side in (-1, 1))
                self.add("tick", "segment", "ink", *ends, axis=self.axis_id(test), number=k)
                options: LabelOptions = {"axis": self.axis_id(test), "number": k, "near": True, "prefer": place.out}
                self.label("tick-name", number_format.number(k * step), "ink", spot, first=7, **options)

    def slide(self, test: AxisTest, place: AxisPlace) -> None:
        """Draw a line from the normal's tail to the axis; if the axis points the other way, say that either will do."""
        arrow = self.normal_arrow(test)
        if arrow is None:
            return
        (x, y), n = arrow[0], place.n
        off = Vec(x - place.zero.x, y - place.zero.y)
        foot = point_along(place.zero, n, off.x * n.x + off.y * n.y)
        self.add("slide", "segment", "guide", arrow[0], foot, axis=self.axis_id(test), start=arrow[:1])
        self.right_angle_at_axis(test, place, arrow[0], foot)
        if self.arrow_direction(test.axis) != test.axis.direction:
            text = "turned round: either direction will do"
            options: LabelOptions = {"axis": self.axis_id(test), "prefer": place.out, "optional": True}
            self.label("either-way", text, "ink", place.at((place.lo + 3 * place.hi) / 4), first=6, **options)

    def drops(self, test: AxisTest, place: AxisPlace, role: str, *, ends_only: bool, named: bool) -> None:
        """Draw dotted lines from a shape's points, or with `ends_only` from its extreme points, to where they land.

        `named` adds a right angle, the dot product, and labels of the lowest and the highest landing.
        """
        side = test.a if role == "A" else test.b
        name, shape = self.named_shape(role)
        axis = self.axis_id(test)
        for i in self.extreme_point_indices(side, place) if ends_only else range(len(side.points)):
            point, spot = side.points[i], place.at(side.landings[i])
            x0, y0, x1, y1 = self.layout.limits
            on_canvas = x0 <= point.x <= x1 and y0 <= point.y <= y1  # a shortcut may project points far from the shape
            if on_canvas:
                self.add("drop", "segment", "guide", point, spot, owner=name, axis=axis, number=i, start=(point,))
                self.add("dropped", "dot", role, point, owner=name, axis=axis, number=i)
            start = (point,) if on_canvas else ()
            self.add("landing", "dot", role, spot, owner=name, axis=axis, number=i, start=start)
        if not named:
            return
        i = self.extreme_point_indices(side, place)[0]
        self.right_angle_at_axis(test, place, side.points[i], place.at(side.landings[i]))
        if test.source.kind != WORLD:
            self.sum_behind_landing(test, place, role)
        digits, turn = describe.digits(self.trace, test), 1 if role == "B" else -1
        for end, way, part in zip(side.interval, (-1, 1), ("lowest", "highest"), strict=True):
            text = digits.landing(end)
            landed = [p for p, t in zip(side.points, side.landings, strict=True) if digits.landing(t) == text]
            names = self.vertex_names(name, shape, landed)
            prefer = Vec(place.out.x * turn + place.n.x * way * 0.5, place.out.y * turn + place.n.y * way * 0.5)
            between = " " if len(names + text) < MAX_LINE_LETTERS else "\n"
            text = f"{names}:{between}{text}" if names else text
            self.label(part, text, role, place.at(end), owner=name, axis=axis, prefer=prefer)

    def sum_behind_landing(self, test: AxisTest, place: AxisPlace, role: str) -> None:
        """Write the dot product of a shape's highest landing, with numbers in the colours of point and axis."""
        side = test.a if role == "A" else test.b
        i = max(range(len(side.landings)), key=lambda k: side.landings[k])
        colours = {AXIS: "ink", POINT: role, PLAIN: "guide"}
        digits = describe.digits(self.trace, test)
        found = landing_sum(digits, test, role, i)
        pieces = tuple((text.replace(";  ", ";\n"), colours[whose]) for text, whose in found)
        name, shape = self.named_shape(role)
        if pieces:
            if who := self.vertex_names(name, shape, side.points[i : i + 1]):
                pieces = ((f"{who}: ", role), *pieces)
            text = "".join(piece for piece, _ in pieces)
            options: LabelOptions = {
                "axis": self.axis_id(test),
                "pieces": pieces,
                "optional": True,
                "far": True,  # it says itself which landing it is of
            }
            self.label("landing-sum", text, "guide", place.at(side.landings[i]), first=6, **options)

    def vertex_names(self, name: str, shape: Shape, points: Sequence[Vec]) -> str:
        """Return the names of a shape's corners at some points, as "v1, v2"; "" if its vertices have no labels."""
        if isinstance(shape, Circle) or not shape.labels:
            return ""
        names = [short_name(shape, name, i) for i in sorted(shape.corner_ids) if shape.vertices[i] in points]
        return ", ".join(names if len(names) < 4 else [*names[:2], f"{len(names) - 2} more"])

    def extreme_point_indices(self, side: Projection, place: AxisPlace) -> list[int]:
        """Return the rising indices of a lowest and a highest projected point; of ties those nearest the axis."""

        def coordinate_out(i: int) -> float:
            """Return the coordinate of point i in the direction from the shapes to the axis."""
            return side.points[i].x * place.out.x + side.points[i].y * place.out.y

        close = self.layout.units(0.5) / place.unit
        found = set()
        for end in side.interval:
            ties = [i for i, t in enumerate(side.landings) if abs(t - end) <= close]
            found.add(max(ties, key=coordinate_out))
        return sorted(found)

    def range(self, test: AxisTest, place: AxisPlace, role: str, *, named: bool = True, numbers: bool = True) -> None:
        """Draw one shape's range as a bar beside the axis; `named` adds its name and, with `numbers`, its ends."""
        side = test.a if role == "A" else test.b
        name, _ = self.named_shape(role)
        ends = tuple(place.at(t, role) for t in side.interval)
        self.add("range", "interval", role, *ends, owner=name, axis=self.axis_id(test), start=ends[:1])
        if not named:
            return
        out = place.out if role == "B" else Vec(-place.out.x, -place.out.y)
        whole = range_label(name, self.digits(self.trace, test).ranges(test)["AB".index(role)])
        text = whole if numbers and not self.layout.brief else name
        p, q = (point_along(end, out, self.layout.units(BAR_PT)) for end in ends)  # a gutter between bar and label
        spot, *along = (Vec(p.x + (q.x - p.x) * f, p.y + (q.y - p.y) * f) for f in (0.5, 0.3, 0.7, 0.1, 0.9))
        options: LabelOptions = {"owner": name, "axis": self.axis_id(test), "along": tuple(along), "prefer": out}
        options["target"] = midpoint(*ends)
        options["longer"] = whole if numbers else ""
        options["wall"] = place.ends  # the label stays on its own side of the axis
        self.label("range-name", text, role, spot, first=1, **options)

    def gap(
        self,
        test: AxisTest,
        place: AxisPlace,
        *,
        named: bool = True,
        interval: bool = True,
        remark: str = "",
        on: str = "",
    ) -> None:
        """Draw a gap as an open bracket or an overlap as a bar; `named` adds the insets and a label.

        The label has the size, the ends of gap or overlap if `interval`, and, unless "", the axis's name `on` and a
        remark.
        """
        ends = points = tuple(place.at(t) for t in gap_or_overlap(test))
        role, kind, weight = "overlap", "interval", "plain"
        across = hypot(ends[0].x - ends[1].x, ends[0].y - ends[1].y) / self.layout.units(1.0)
        if test.gap < 0 and across < MIN_DOTTED_PT:
            self.marks = [m for m in self.marks if m.part != "landing" or m.points[0] not in ends]  # they would hide it
        if test.gap >= 0:
            near, far = (self.layout.units(c) for c in BRACKET_PT)
            points = tuple(point_along(ends[i], place.out, c) for i, c in ((0, near), (0, far), (1, far), (1, near)))
            role, kind, weight = "gap", "bracket", "faint" if across < MIN_DOTTED_PT / 2 else "plain"
        self.add("gap", kind, role, *points, axis=self.axis_id(test), start=points[:1], weight=weight)
        if not named:
            return
        self.insets(test)
        anchor = midpoint(*points[1:3]) if kind == "bracket" else midpoint(*ends)
        text = (describe.picture_outcome if interval else describe.outcome)(test, self.digits(self.trace, test))
        text += f" on {on}" if on else ""
        self.label(
            "gap-name",
            f"{text}\n{remark}" if remark else text,
            role,
            anchor,
            axis=self.axis_id(test),
            prefer=place.out,
            first=2,
        )

    def project(
        self,
        test: AxisTest,
        place: AxisPlace,
        *,
        named: bool = True,
        drops: bool = True,
        numbers: bool = True,
        interval: bool = True,
        remark: str = "",
        on: str = "",
    ) -> None:
        """Draw a finished test: the axis (`named`), `drops` of the extreme points, both ranges, the gap or overlap.

        `numbers`: the labels of the ranges give their ends, and that of the gap too if `interval`; it also has the
        axis's name `on` and a `remark`, unless these are "".
        """
        self.axis(test, place, named=named)
        for role in "AB":
            if drops:
                self.drops(test, place, role, ends_only=True, named=False)
            self.range(test, place, role, numbers=numbers)
        self.gap(test, place, interval=interval and numbers and not self.layout.brief, remark=remark, on=on)

    def axes_left_out(self) -> list[Axis]:
        """Return the axes that the early exit made unnecessary."""
        return [s.axis for s in self.trace.skipped if s.why == EARLY_EXIT]

    def grey_normals(self) -> list[Axis]:
        """Return those axes of `axes_left_out` that are drawn as grey normals of their edges; none of too many."""
        left = self.axes_left_out()
        edges = (axis for axis in left if axis.source.kind in (EDGE, HULL))
        drawn = [axis for axis in edges if not self.is_crowded(self.named_shape(axis.source.shape)[1])]
        return drawn if len(left) <= MAX_GREY_NORMALS else []

    def untested_axes(self) -> None:
        """List the axes that the early exit made unnecessary, in grey, with a small normal on each edge."""
        left = self.axes_left_out()
        if not left:
            return
        self.corners(as_role="guide")
        for n, axis in enumerate(self.grey_normals(), 1):
            self.small_normal("untested", axis, GREY_NORMAL, "guide", number=n)
        names = [self._name_of_untested(axis) for axis in left]
        most = MAX_LISTED_AXES if self.layout.size[0] >= NARROW_PT else MAX_NARROW_LISTED_AXES
        if len(names) > most:
            names = [*names[: most - 1], f"{len(names) - most + 1} more"]
        lines = ["not tested:"]
        for i, name in enumerate(names):
            piece = name + ("," if i < len(names) - 1 else "")
            if len(lines) > 1 and len(lines[-1]) + len(piece) < MAX_LIST_LETTERS:
                lines[-1] += f" {piece}"
            else:
                lines.append(piece)
        self.note("left-out", "\n".join(lines), "guide")

    def _name_of_untested(self, axis: Axis) -> str:
        """Return the short name of an axis that was not tested, with the tested axis that is parallel to it, if any."""
        name = describe.short_axis_name(axis, (self.trace.a, self.trace.b), self.trace.names)
        twins = (
            f" ({describe.reason(PARALLEL, i)})"
            for i, t in enumerate(self.trace.tests, 1)
            if are_parallel(t.axis, axis)
        )
        return name + next(twins, "")
