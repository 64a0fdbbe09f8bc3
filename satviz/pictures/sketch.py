"""The layers a picture is made of: shapes, an edge, its normal, an axis, drops, ranges, gaps, lines, words.

Every number comes from the trace.  Labels are only asked for here; they are placed
when all strokes are known.
"""

from collections.abc import Collection, Iterator, Sequence
from math import hypot
from typing import Unpack

from ..engine import describe
from ..engine.axes import CENTERS, EARLY_EXIT, EDGE, FROM_EDGES, HULL, SLIP, VERTEX, WORLD
from ..engine.geometry import Interval, Vec
from ..engine.sat import AxisTest, Projection
from ..engine.shapes import Circle, Polygon, Shape, centroid
from ..engine.trace import Trace
from .insets import edges_in, in_words, small
from .labels import LabelOffsets, LabelOptions, LabelRequest, Segment, holds, name_spots, short_name, with_labels
from .layout import LONGEST, TRACK, AxisPlace, Inset, Layout, point_along, range_label
from .marks import Details, Mark, Picture

NORMAL = 34.0  # the length of a normal's arrow, in points
CROWDED = 6.0  # times the size at which a shape can just be seen
RIGHT_ANGLE = 7.0  # the side of the mark at its foot
ZERO_TICK = 4.5  # half of the tick at coordinate 0
BRACKET = 4.0, 11.0  # a gap's bracket stands this far out from the axis
LIST_WIDTH = 34  # letters a line in a list of axes


class Sketch:
    """Collects marks for one picture of a trace; `prefix` tells its axes from another trace's beside them."""

    def __init__(self, trace: Trace, layout: Layout, prefix: str = "") -> None:
        self.trace = trace
        self.layout = layout
        self.prefix = prefix
        self.marks: list[Mark] = []
        self.requests: list[tuple[int, LabelRequest]] = []

    def add(self, part: str, kind: str, role: str, *points: Vec, **more: Unpack[Details]) -> None:
        """One more mark."""
        self.marks.append(Mark(part, kind, role, points, **more))

    def label(
        self, part: str, text: str, role: str, anchor: Vec, *, first: int = 5, **more: Unpack[LabelOptions]
    ) -> None:
        """Ask for a label; those with a lower `first` choose their place earlier."""
        self.requests.append((first, LabelRequest(part, text, role, anchor, **more)))

    # -- shapes

    def shape(
        self, role: str, name: str, shape: Shape, *, weight: str = "plain", named: bool = True, quiet: bool = False
    ) -> None:
        """The outline and its name (in small, if `quiet`); vertices the owner labelled get a dot and their label."""
        if isinstance(shape, Circle):
            self.add("outline", "disc", role, shape.center, owner=name, radius=shape.radius, weight=weight)
        else:
            self.add("outline", "outline", role, *shape.vertices, owner=name, weight=weight)
        if self.tiny(shape) and weight != "faint":  # seen at any scale
            x0, y0, x1, y1 = shape.bounds
            self.add("speck", "dot", role, Vec((x0 + x1) / 2, (y0 + y1) / 2), owner=name)
        if named:
            other = self.trace.b if role == "A" else self.trace.a
            spot, *along = sorted(name_spots(shape), key=lambda p: holds(other, p))
            wish: LabelOptions = {"owner": name, "along": tuple(along), "inside": True, "steady": True}
            wish |= {"weight": "plain" if quiet else "title", "optional": quiet, "near": quiet}
            self.label("name", name, role, spot, **wish)

    def tiny(self, shape: Shape) -> bool:
        """Is it too small to be seen?"""
        return small(shape, self.layout.scale)

    def crowded(self, shape: Shape) -> bool:
        """Is there no room for marks at its corners and edges?"""
        return small(shape, self.layout.scale / CROWDED)

    def shapes(self, *, weight: str = "plain") -> None:
        """Both shapes, with the labels that their owner gave, and larger what is too small to be seen."""
        self.insets()
        for role, name, shape in self.pair():
            self.shape(role, name, shape, weight=weight)
            if isinstance(shape, Polygon) and shape.labels and weight != "faint":
                self.vertices(role, range(len(shape.vertices)))

    def insets(self, test: AxisTest | None = None) -> None:
        """What is too small for the pen, larger: the shapes, or the gap of a test."""
        for number, inset in enumerate(self.layout.insets, 1):
            outlines = [(role, name, [*edges_in(inset, shape)]) for role, name, shape in self.pair()]
            if inset.test != test or not (inset.test or any(edges for *_, edges in outlines)):
                continue  # of another test, or of a part that this step leaves aside
            x0, y0, x1, y1 = inset.box
            corners = Vec(x0, y0), Vec(x1, y0), Vec(x1, y1), Vec(x0, y1)
            self.add("inset", "outline", "guide", *corners, weight="faint", number=number)
            what = inset.of or ("gap" if inset.test and inset.test.gap > 0 else "overlap")
            below = Vec(inset.center.x, y0 - self.layout.units(9))
            text = f"{what}, {in_words(inset.times)}"
            self.marks.append(Mark("inset-name", "label", "ink", (below,), number=number, text=text))
            if inset.test is None:
                for role, name, edges in outlines:
                    if edges:
                        ends = [end for edge in edges for end in edge]
                        self.add("inset-edge", "segment", role, *ends, owner=name, number=number)
            else:
                self.larger_gap(inset, number)

    def larger_gap(self, inset: Inset, number: int) -> None:
        """The ends of both ranges that face each other, along a level line."""
        assert inset.test
        a, b = inset.test.a.interval, inset.test.b.interval
        x0, _, x1, _ = inset.box
        units, (cx, cy) = self.layout.units, inset.center
        half = inset.test.gap * inset.times / 2
        left, right = ("A", "B") if b.lo - a.hi >= a.lo - b.hi else ("B", "A")
        self.add("inset-axis", "segment", "ink", Vec(x0, cy), Vec(x1, cy), number=number)
        for role, ends in (left, (x0, cx - half)), (right, (cx + half, x1)):
            level = cy + units(TRACK if role == "A" else -TRACK)
            name, _ = self.of(role)
            self.add("inset-range", "interval", role, *(Vec(x, level) for x in ends), owner=name, number=number)
        if half > 0:
            near, far = (cy - units(c) for c in BRACKET)
            points = [Vec(cx - half, near), Vec(cx - half, far), Vec(cx + half, far), Vec(cx + half, near)]
            self.add("inset-gap", "bracket", "gap", *points, number=number)
        else:
            self.add("inset-gap", "interval", "overlap", Vec(cx + half, cy), Vec(cx - half, cy), number=number)

    def pair(self) -> Iterator[tuple[str, str, Shape]]:
        """(role, name, shape) of both."""
        return zip("AB", self.trace.names, (self.trace.a, self.trace.b), strict=True)

    def of(self, role: str | None) -> tuple[str, Shape]:
        """The name and the shape of a role."""
        return (self.trace.names.a, self.trace.a) if role == "A" else (self.trace.names.b, self.trace.b)

    def polygon(self, role: str | None) -> tuple[str, Polygon]:
        """The same of what has edges and vertices, which an axis's source or a label names."""
        name, shape = self.of(role)
        assert isinstance(shape, Polygon)
        return name, shape

    def vertices(self, role: str, ids: Sequence[int], *, as_role: str = "") -> None:
        """Dots with names on some of a polygon's vertices."""
        name, polygon = self.polygon(role)
        middle = centroid(polygon)
        for i in ids:
            if any((m.part, m.owner, m.number) == ("vertex", name, i) for m in self.marks):
                continue
            v = polygon.vertices[i]
            self.add("vertex", "dot", role, v, owner=name, number=i)
            away = Vec(v.x - middle.x, v.y - middle.y)
            wish: LabelOptions = {"owner": name, "number": i, "prefer": away, "optional": True, "steady": True}
            self.label("vertex-name", short_name(polygon, name, i), as_role or role, v, first=4, **wish)

    def corners(self, of: Collection[str | None] = "AB", *, as_role: str = "") -> None:
        """Names for corners that have none of their owner's, as words about edges use them; where they are few."""
        for role, _, shape in self.pair():
            if role not in of:
                continue
            if isinstance(shape, Polygon) and not shape.labels and len(shape.corners) <= 6 and not self.crowded(shape):
                self.vertices(role, shape.corner_ids, as_role=as_role)

    # -- where the axis comes from

    def edge(self, test: AxisTest, *, told: bool = False) -> None:
        """The edge (or the line between centers or to the nearest vertex) the axis comes from."""
        (kind, _, ids), role = test.source, test.source.shape or "ink"
        if kind in FROM_EDGES:
            name, polygon = self.polygon(role)
            p, q = (polygon.vertices[i] for i in ids)
            self.add("edge", "arrow", role, q, p, weight="strong")  # the edge as the difference of its ends
            if told:
                self.vertices(role, ids)
                ends = [short_name(polygon, name, i) for i in ids]
                out = self.outward(polygon, p, q)
                text = f"edge = {describe.edge_vector(self.trace, ends, p, q)}".replace(" = (", "\n= (")
                clear = self.middle(self.middle(p, q), q)  # of the normal, which stands in the middle
                self.label("edge-name", text, role, clear, prefer=out, first=1)
        elif kind in (CENTERS, VERTEX):
            p, q = self.joined(test)
            self.add("edge", "segment", "ink", p, q)
            for i, end in enumerate((p, q)):
                self.add("edge-end", "dot", "AB"[i], end, number=i)
            if told:
                along = max(Vec(q.x - p.x, q.y - p.y), Vec(p.x - q.x, p.y - q.y))  # as the axis points
                self.label("edge-name", describe.digits(self.trace).vector(along), "ink", self.middle(p, q), first=1)

    def joined(self, test: AxisTest) -> Segment:
        """The two points whose difference is the axis: A's, then B's."""
        both = self.trace.a, self.trace.b
        p, q = (s.center if isinstance(s, Circle) else s.vertices[test.source.ids[0]] for s in both)
        return p, q

    def normal_arrow(self, test: AxisTest) -> Segment | None:
        """Tail and tip of the axis's direction where it comes from; None for an axis from nowhere."""
        kind, role, ids = test.source
        if kind in FROM_EDGES:
            _, polygon = self.polygon(role)
            start = self.middle(*(polygon.vertices[i] for i in ids))
        elif kind in (CENTERS, VERTEX):
            start = self.middle(*self.joined(test))
        else:
            return None
        return start, point_along(start, self.way_of(test), self.layout.units(NORMAL))

    def way_of(self, test: AxisTest) -> Vec:
        """The axis's direction as it is drawn where it comes from: a normal points out of its shape."""
        n = test.axis.direction
        return n if describe.points_outward(self.trace, test.axis) else Vec(-n.x, -n.y)

    def normal(self, test: AxisTest, *, told: bool = False) -> None:
        """The axis's direction as an arrow where it comes from; a normal points out of its shape."""
        arrow = self.normal_arrow(test)
        if arrow is None:
            return
        kind, owner, _ = test.source
        role, way = owner or "ink", self.way_of(test)
        if kind in (EDGE, HULL):
            self.right_angle(arrow[0], way)
        self.add("normal", "arrow", role, *arrow, start=arrow[:1])
        if told:
            text = "direction"
            if kind in FROM_EDGES:
                what = "one sign changed:" if kind == SLIP else "normal"
                text = f"{what} {describe.outward_normal(self.trace, test.axis)}"
                text += "\n(either direction will do)" if way != test.axis.direction else ""
            self.label("normal-name", text, role, arrow[1], prefer=way, first=1)

    def right_angle(self, foot: Vec, way: Vec) -> None:
        """The mark in the corner between an edge and its normal."""
        size = self.layout.units(RIGHT_ANGLE)
        along = Vec(-way.y, way.x)
        up, side = point_along(foot, way, size), point_along(foot, along, size)
        corner = point_along(up, along, size)
        self.add("right-angle", "segment", "ink", up, corner, corner, side)

    def no_axis(self, test: AxisTest) -> None:
        """The edge between two vertices in one place, which gives no axis."""
        role = test.source.shape or "A"
        self.vertices(role, test.source.ids[:1])
        ends = " and ".join(short_name(self.of(role)[1], self.of(role)[0], i) for i in test.source.ids)
        text = f"{ends} lie in one place: no normal but (0, 0),\non which every point lands at 0"
        low = Vec((self.layout.limits[0] + self.layout.limits[2]) / 2, self.layout.limits[1])
        self.label("no-axis", text, "ink", low, first=1, far=True)

    def all_normals(self) -> None:
        """A small outward arrow on every edge."""
        for role, name, shape in self.pair():
            if isinstance(shape, Polygon):
                ring = shape.corners
                for i, (p, q) in enumerate(zip(ring, [*ring[1:], ring[0]], strict=True)):
                    tip = point_along(self.middle(p, q), self.outward(shape, p, q), self.layout.units(NORMAL * 0.8))
                    self.add("normal", "arrow", role, self.middle(p, q), tip, owner=name, number=i)

    def middle(self, p: Vec, q: Vec) -> Vec:
        """Half way from p to q."""
        return Vec((p.x + q.x) / 2, (p.y + q.y) / 2)

    def outward(self, polygon: Polygon, p: Vec, q: Vec) -> Vec:
        """The unit vector across an edge, away from the polygon's inside."""
        i, j = polygon.corners.index(p), polygon.corners.index(q)
        if (i + 1) % len(polygon.corners) != j:
            p, q = q, p
        length = hypot(q.x - p.x, q.y - p.y)
        return Vec((q.y - p.y) / length, (p.x - q.x) / length)

    # -- the axis and what lands on it

    def number(self, test: AxisTest) -> int:
        """The how-manyth test of the trace it is."""
        return next(i for i, other in enumerate(self.trace.tests, 1) if other is test)

    def on(self, test: AxisTest) -> str:
        """What the test's axis is called in the picture."""
        return f"{self.prefix}{self.number(test)}"

    def axis(self, test: AxisTest, place: AxisPlace, *, told: bool = True) -> None:
        """The axis as a long arrow clear of the shapes: its normal, pulled away from the edge."""
        start = self.normal_arrow(test) or ()
        if start and self.way_of(test) != test.axis.direction:
            start = start[::-1]  # so that it grows out of the normal without turning over
        self.add("axis", "arrow", "ink", place.at(place.lo), place.at(place.hi), axis=self.on(test), start=start)
        if told:
            kind, _, ids = test.source
            text = "xy"[ids[0]] if kind == WORLD else f"axis {self.number(test)}"
            text += "\n(not to scale)" if place.slid else ""
            self.label("axis-name", text, "ink", place.at(place.hi), axis=self.on(test), prefer=place.n, first=3)
        if place.lo < 0 < place.hi:
            half = self.layout.units(ZERO_TICK)
            ends = (point_along(place.at(0.0), place.out, side * half) for side in (-1, 1))
            self.add("zero", "segment", "ink", *ends, axis=self.on(test))
            wish: LabelOptions = {"axis": self.on(test), "prefer": place.out, "optional": True}
            self.label("zero-name", "0", "ink", place.at(0.0), first=7, **wish)

    def drops(self, test: AxisTest, place: AxisPlace, role: str, *, ends_only: bool, named: bool) -> None:
        """Dotted lines from the points to where they land."""
        side = test.a if role == "A" else test.b
        name, shape = self.of(role)
        axis = self.on(test)
        shown = self.nearest_ends(side, place) if ends_only else range(len(side.points))
        for i in shown:
            point, spot = side.points[i], place.at(side.landings[i])
            x0, y0, x1, y1 = self.layout.limits
            from_here = x0 <= point.x <= x1 and y0 <= point.y <= y1  # a shortcut may take points of its own
            if from_here:
                self.add("drop", "segment", "guide", point, spot, owner=name, axis=axis, number=i, start=(point,))
                self.add("dropped", "dot", role, point, owner=name, axis=axis, number=i)
            start = (point,) if from_here else ()
            self.add("landing", "dot", role, spot, owner=name, axis=axis, number=i, start=start)
        if named:
            told = describe.digits(self.trace, test)
            for end, way in zip(side.interval, (-1, 1), strict=True):
                text = told.landing(end)
                landed = [p for p, t in zip(side.points, side.landings, strict=True) if told.landing(t) == text]
                who = self.vertex_names(name, shape, landed)
                prefer = Vec(place.out.x * (1 if role == "B" else -1), place.out.y * (1 if role == "B" else -1))
                prefer = Vec(prefer.x + place.n.x * way * 0.5, prefer.y + place.n.y * way * 0.5)
                part = "lowest" if way < 0 else "highest"
                between = " " if len(who + text) < LONGEST else "\n"
                text = f"{who}:{between}{text}" if who else text
                self.label(part, text, role, place.at(end), owner=name, axis=axis, prefer=prefer)

    def vertex_names(self, name: str, shape: Shape, points: Sequence[Vec]) -> str:
        """Some of a shape's corners, if the owner named its vertices: "v1, v2"."""
        if isinstance(shape, Circle) or not shape.labels:
            return ""
        names = [short_name(shape, name, i) for i in sorted(shape.corner_ids) if shape.vertices[i] in points]
        return ", ".join(names if len(names) < 4 else [*names[:2], f"{len(names) - 2} more"])

    def nearest_ends(self, side: Projection, place: AxisPlace) -> list[int]:
        """A lowest and a highest point; of several that land together the one nearest to the axis."""

        def height(i: int) -> float:
            return side.points[i].x * place.out.x + side.points[i].y * place.out.y

        close = self.layout.units(0.5) / place.unit
        found = []
        for end in side.interval:
            ties = [i for i, t in enumerate(side.landings) if abs(t - end) <= close]
            found.append(max(ties, key=height))
        return sorted(set(found))

    def range(self, test: AxisTest, place: AxisPlace, role: str, *, named: bool = True, numbers: bool = True) -> None:
        """One shape's range as a bar beside the axis, with its interval."""
        side = test.a if role == "A" else test.b
        name, _ = self.of(role)
        ends = tuple(place.at(t, role) for t in side.interval)
        self.add("range", "interval", role, *ends, owner=name, axis=self.on(test), start=ends[:1])
        out = place.out if role == "B" else Vec(-place.out.x, -place.out.y)
        if not named:
            return
        text = range_label(name, describe.digits(self.trace, test).ranges(test)["AB".index(role)])
        p, q = ends
        spot, *along = (Vec(p.x + (q.x - p.x) * f, p.y + (q.y - p.y) * f) for f in (0.5, 0.3, 0.7, 0.1, 0.9))
        text = text if numbers else name
        wall = place.at(place.lo), place.at(place.hi)  # on its own side of the axis
        wish: LabelOptions = {"owner": name, "axis": self.on(test), "along": tuple(along), "prefer": out, "wall": wall}
        self.label("range-name", text, role, spot, first=1, **wish)

    def gap(self, test: AxisTest, place: AxisPlace, *, named: bool = True, interval: bool = True) -> None:
        """The gap as an open bracket, the overlap as a filled bar, with the trace's number."""
        a, b = test.a.interval, test.b.interval
        if test.gap >= 0:
            span = Interval(*((a.hi, b.lo) if a.hi <= b.lo else (b.hi, a.lo)))
            near, far = (self.layout.units(c) for c in BRACKET)
            ends = tuple(place.at(t) for t in span)
            points = tuple(point_along(ends[i], place.out, c) for i, c in ((0, near), (0, far), (1, far), (1, near)))
            role, kind = "gap", "bracket"
        else:
            ends = points = tuple(place.at(t) for t in Interval(max(a.lo, b.lo), min(a.hi, b.hi)))
            role, kind = "overlap", "interval"
        self.add("gap", kind, role, *points, axis=self.on(test), start=points[:1])
        if not named:
            return
        self.insets(test)
        anchor = self.middle(*points[1:3]) if kind == "bracket" else self.middle(*ends)
        text = (describe.shared if interval else describe.outcome)(test, describe.digits(self.trace, test))
        self.label("gap-name", text, role, anchor, axis=self.on(test), prefer=place.out, first=2)

    def project(
        self, test: AxisTest, place: AxisPlace, *, drops: bool = True, numbers: bool = True, interval: bool = True
    ) -> None:
        """A finished test: the axis, the extreme points' drops, both ranges, the gap or overlap."""
        self.axis(test, place)
        for role in "AB":
            if drops:
                self.drops(test, place, role, ends_only=True, named=False)
            self.range(test, place, role, numbers=numbers)
        self.gap(test, place, interval=numbers and interval)

    # -- lines, moves, words

    def line_across(self, part: str, through: Vec, normal: Vec, role: str, number: int | None = None) -> Segment:
        """The part of a line (through a point, across a normal) that lies well inside the canvas."""
        x0, y0, x1, y1 = self.layout.field
        rim = self.layout.units(14)
        d = Vec(-normal.y, normal.x)
        start, end = -float("inf"), float("inf")
        for u, p, lo, hi in (d.x, through.x, x0 + rim, x1 - rim), (d.y, through.y, y0 + rim, y1 - rim):
            if abs(u) > 1e-12:
                near, far = sorted(((lo - p) / u, (hi - p) / u))
                start, end = max(start, near), min(end, far)
        ends = point_along(through, d, start), point_along(through, d, end)
        self.add(part, "segment", role, *ends, number=number)
        return ends

    def note(self, part: str, text: str, role: str, *, weight: str = "plain", first: int = 8) -> None:
        """Words that belong to no mark: near the top, wherever there is room."""
        x0, _, x1, y1 = self.layout.field
        anchor = Vec((x0 + x1) / 2, y1 - self.layout.units(20))
        self.label(part, text, role, anchor, weight=weight, first=first, inside=True, far=True, optional=True)

    def left_out(self) -> None:
        """The axes the early exit made unnecessary, listed in grey."""
        left = [s.axis for s in self.trace.skipped if s.why == EARLY_EXIT]
        if not left:
            return
        self.corners(as_role="guide")
        for n, axis in enumerate(left, 1):
            kind, owner, ids = axis.source
            if kind in (EDGE, HULL) and not self.crowded(self.of(owner)[1]):
                _, polygon = self.polygon(owner)
                p, q = (polygon.vertices[j] for j in ids)
                tip = point_along(self.middle(p, q), self.outward(polygon, p, q), self.layout.units(NORMAL * 0.6))
                self.add("untested", "arrow", "guide", self.middle(p, q), tip, number=n)
        names = [describe.short_axis_name(axis, (self.trace.a, self.trace.b), self.trace.names) for axis in left]
        if len(names) > 8:
            names = [*names[:7], f"{len(names) - 7} more"]
        lines = ["not tested:"]
        for i, name in enumerate(names):
            piece = name + ("," if i < len(names) - 1 else "")
            if len(lines) > 1 and len(lines[-1]) + len(piece) < LIST_WIDTH:
                lines[-1] += f" {piece}"
            else:
                lines.append(piece)
        self.note("left-out", "\n".join(lines), "guide")

    def finish(
        self,
        title: str,
        sentence: str,
        *,
        steady: bool = True,
        kept: Sequence[Mark] = (),
        last_offsets: LabelOffsets | None = None,
    ) -> Picture:
        """Place the labels and close the picture; what may change where they stand: see `with_labels`."""
        requests = [request for _, request in sorted(self.requests, key=lambda r: r[0])]
        keep_off = [arrow for arrow in map(self.normal_arrow, self.trace.tests) if arrow]
        marks = with_labels(
            self.marks, requests, self.layout, steady=steady, keep_off=keep_off, kept=kept, last_offsets=last_offsets
        )
        return Picture(tuple(marks), self.layout.limits, self.layout.size, title, sentence)
