"""The layers a picture is made of: shapes, an edge, its normal, an axis, drops, ranges, gaps, lines, words.

Every number comes from the trace.  Labels are only asked for here; they are placed
when all strokes are known.
"""

from collections.abc import Iterator, Sequence
from math import hypot
from typing import Unpack

from ..engine import telling
from ..engine.axes import CENTERS, EARLY_EXIT, FROM_EDGES, SLIP, VERTEX, WORLD
from ..engine.geometry import Interval, Vec
from ..engine.sat import AxisTest, Projection
from ..engine.shapes import Circle, Polygon, Shape, centroid
from ..engine.trace import Trace
from .labels import Request, Segment, Wishes, holds, name_spots, short_name, with_labels
from .layout import AxisPlace, Layout, moved
from .marks import Details, Mark, Picture

NORMAL = 34.0  # the length of a normal's arrow, in points
BRACKET = 4.0, 11.0  # a gap's bracket stands this far out from the axis
LIST_WIDTH = 34  # letters a line in a list of axes


class Sketch:
    """Collects marks for one picture of a trace; `prefix` tells its axes from another trace's beside them."""

    def __init__(self, trace: Trace, layout: Layout, prefix: str = "") -> None:
        self.trace = trace
        self.layout = layout
        self.prefix = prefix
        self.marks: list[Mark] = []
        self.requests: list[tuple[int, Request]] = []

    def add(self, part: str, kind: str, role: str, *points: Vec, **more: Unpack[Details]) -> None:
        """One more mark."""
        self.marks.append(Mark(part, kind, role, points, **more))

    def label(self, part: str, text: str, role: str, anchor: Vec, *, first: int = 5, **more: Unpack[Wishes]) -> None:
        """Ask for a label; those with a lower `first` choose their place earlier."""
        self.requests.append((first, Request(part, text, role, anchor, **more)))

    # -- shapes

    def shape(self, role: str, name: str, shape: Shape, *, weight: str = "plain", named: bool = True) -> None:
        """The outline and its name; vertices the owner labelled get a dot and their label."""
        if isinstance(shape, Circle):
            self.add("outline", "disc", role, shape.center, owner=name, radius=shape.radius, weight=weight)
        else:
            self.add("outline", "outline", role, *shape.vertices, owner=name, weight=weight)
        if named:
            other = self.trace.b if role == "A" else self.trace.a
            spot, *along = sorted(name_spots(shape), key=lambda p: holds(other, p))
            wish: Wishes = {"owner": name, "along": tuple(along), "inside": True, "weight": "title", "steady": True}
            self.label("name", name, role, spot, **wish)

    def shapes(self, *, weight: str = "plain") -> None:
        """Both shapes, with the labels that their owner gave."""
        for role, name, shape in self.pair():
            self.shape(role, name, shape, weight=weight)
            if isinstance(shape, Polygon) and shape.labels and weight != "faint":
                self.vertices(role, range(len(shape.vertices)))

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
            wish: Wishes = {"owner": name, "number": i, "prefer": away, "optional": True, "steady": True}
            self.label("vertex-name", short_name(polygon, name, i), as_role or role, v, first=4, **wish)

    # -- where the axis comes from

    def edge(self, test: AxisTest, *, told: bool = False) -> None:
        """The edge (or the line between centers or to the nearest vertex) the axis comes from."""
        (kind, _, ids), role = test.source, test.source.shape or "ink"
        if kind in FROM_EDGES:
            name, polygon = self.polygon(role)
            p, q = (polygon.vertices[i] for i in ids)
            self.add("edge", "segment", role, p, q, weight="strong")
            if told:
                self.vertices(role, ids)
                ends = [short_name(polygon, name, i) for i in ids]
                middle = self.middle(p, q)
                out = self.outward(polygon, p, q)
                text = f"edge = {ends[0]} - {ends[1]} = {telling.vector(Vec(p.x - q.x, p.y - q.y))}"
                self.label("edge-name", text, role, middle, prefer=out, first=1)
        elif kind in (CENTERS, VERTEX):
            p, q = self.joined(test)
            self.add("edge", "segment", "ink", p, q)
            for i, end in enumerate((p, q)):
                self.add("edge-end", "dot", "AB"[i], end, number=i)
            if told:
                self.label("edge-name", telling.vector(Vec(q.x - p.x, q.y - p.y)), "ink", self.middle(p, q), first=1)

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
        return start, moved(start, test.axis.direction, self.layout.units(NORMAL))

    def normal(self, test: AxisTest, *, told: bool = False) -> None:
        """The axis's direction as an arrow where it comes from."""
        arrow = self.normal_arrow(test)
        if arrow is None:
            return
        role = test.source.shape or "ink"
        self.add("normal", "arrow", role, *arrow, weight="strong", start=arrow[:1])
        if told:
            what = "(dx, -dy) =" if test.source.kind == SLIP else "normal"
            text = f"{what} {telling.vector(test.axis.normal)}" if test.source.kind in FROM_EDGES else "direction"
            self.label("normal-name", text, role, arrow[1], prefer=test.axis.direction, first=1)

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
                    tip = moved(self.middle(p, q), self.outward(shape, p, q), self.layout.units(NORMAL * 0.8))
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
        self.add("axis", "arrow", "ink", place.at(place.lo), place.at(place.hi), axis=self.on(test), start=start)
        if told:
            kind, _, ids = test.source
            text = "xy"[ids[0]] if kind == WORLD else f"axis {self.number(test)}"
            self.label("axis-name", text, "ink", place.at(place.hi), axis=self.on(test), prefer=place.n, first=3)

    def drops(self, test: AxisTest, place: AxisPlace, role: str, *, ends_only: bool, told: bool) -> None:
        """Dotted lines from the points to where they land."""
        side = test.a if role == "A" else test.b
        name, shape = self.of(role)
        axis = self.on(test)
        shown = self.nearest_ends(side, place) if ends_only else range(len(side.points))
        for i in shown:
            point, spot = side.points[i], place.at(side.landings[i])
            self.add("drop", "segment", "guide", point, spot, owner=name, axis=axis, number=i, start=(point,))
            self.add("dropped", "dot", role, point, owner=name, axis=axis, number=i)
            self.add("landing", "dot", role, spot, owner=name, axis=axis, number=i, start=(point,))
        if told:
            for end, way in zip(side.interval, (-1, 1), strict=True):
                who = self.landed_names(name, shape, side, end)
                prefer = Vec(place.out.x * (1 if role == "B" else -1), place.out.y * (1 if role == "B" else -1))
                prefer = Vec(prefer.x + place.n.x * way * 0.5, prefer.y + place.n.y * way * 0.5)
                part = "lowest" if way < 0 else "highest"
                text = f"{who}: {telling.number(end)}" if who else telling.number(end)
                self.label(part, text, role, place.at(end), owner=name, axis=axis, prefer=prefer)

    def landed_names(self, name: str, shape: Shape, side: Projection, end: float) -> str:
        """Who landed at an end of the range, if the owner named the vertices: "v1, v2"."""
        if isinstance(shape, Circle) or not shape.labels:
            return ""
        shown = telling.number(end)
        ids = [shape.corner_ids[i] for i, t in enumerate(side.landings) if telling.number(t) == shown]
        return ", ".join(short_name(shape, name, i) for i in sorted(ids))

    def nearest_ends(self, side: Projection, place: AxisPlace) -> list[int]:
        """A lowest and a highest point; of several that land together the one nearest to the axis."""

        def height(i: int) -> float:
            return side.points[i].x * place.out.x + side.points[i].y * place.out.y

        close = self.layout.units(0.5)
        found = []
        for end in side.interval:
            ties = [i for i, t in enumerate(side.landings) if abs(t - end) <= close]
            found.append(max(ties, key=height))
        return sorted(set(found))

    def range(self, test: AxisTest, place: AxisPlace, role: str) -> None:
        """One shape's range as a bar beside the axis, with its interval."""
        side = test.a if role == "A" else test.b
        name, _ = self.of(role)
        ends = tuple(place.at(t, role) for t in side.interval)
        self.add("range", "interval", role, *ends, owner=name, axis=self.on(test), start=ends[:1])
        out = place.out if role == "B" else Vec(-place.out.x, -place.out.y)
        text = f"{name} {telling.interval(side.interval)}"
        p, q = ends
        spot, *along = (Vec(p.x + (q.x - p.x) * f, p.y + (q.y - p.y) * f) for f in (0.5, 0.3, 0.7, 0.1, 0.9))
        wish: Wishes = {"owner": name, "axis": self.on(test), "along": tuple(along), "prefer": out}
        self.label("range-name", text, role, spot, first=1, **wish)

    def gap(self, test: AxisTest, place: AxisPlace) -> None:
        """The gap as an open bracket, the overlap as a filled bar, with the trace's number."""
        a, b = test.a.interval, test.b.interval
        if test.gap >= 0:
            span = Interval(*((a.hi, b.lo) if a.hi <= b.lo else (b.hi, a.lo)))
            near, far = (self.layout.units(c) for c in BRACKET)
            ends = tuple(place.at(t) for t in span)
            points = tuple(moved(ends[i], place.out, c) for i, c in ((0, near), (0, far), (1, far), (1, near)))
            role, kind = "gap", "bracket"
        else:
            ends = points = tuple(place.at(t) for t in Interval(max(a.lo, b.lo), min(a.hi, b.hi)))
            role, kind = "overlap", "interval"
        self.add("gap", kind, role, *points, axis=self.on(test), start=points[:1])
        anchor = self.middle(*points[1:3]) if kind == "bracket" else self.middle(*ends)
        text = telling.outcome(test)
        self.label("gap-name", text, role, anchor, axis=self.on(test), prefer=place.out, first=2)

    def project(self, test: AxisTest, place: AxisPlace, *, drops: bool = True) -> None:
        """A finished test: the axis, the extreme points' drops, both ranges, the gap or overlap."""
        self.axis(test, place)
        for role in "AB":
            if drops:
                self.drops(test, place, role, ends_only=True, told=False)
            self.range(test, place, role)
        self.gap(test, place)

    # -- lines, moves, words

    def line_across(self, part: str, through: Vec, normal: Vec, role: str, number: int | None = None) -> Segment:
        """The part of a line (through a point, across a normal) that lies well inside the canvas."""
        x0, y0, x1, y1 = self.layout.limits
        rim = self.layout.units(14)
        d = Vec(-normal.y, normal.x)
        start, end = -float("inf"), float("inf")
        for u, p, lo, hi in (d.x, through.x, x0 + rim, x1 - rim), (d.y, through.y, y0 + rim, y1 - rim):
            if abs(u) > 1e-12:
                near, far = sorted(((lo - p) / u, (hi - p) / u))
                start, end = max(start, near), min(end, far)
        ends = moved(through, d, start), moved(through, d, end)
        self.add(part, "segment", role, *ends, number=number)
        return ends

    def note(self, part: str, text: str, role: str, *, weight: str = "plain", first: int = 8) -> None:
        """Words that belong to no mark: near the top, wherever there is room."""
        x0, _, x1, y1 = self.layout.limits
        anchor = Vec((x0 + x1) / 2, y1 - self.layout.units(20))
        self.label(part, text, role, anchor, weight=weight, first=first, inside=True, far=True, optional=True)

    def left_out(self) -> None:
        """The axes the early exit made unnecessary, listed in grey."""
        left = [s.axis for s in self.trace.skipped if s.why == EARLY_EXIT]
        if not left:
            return
        for role, _, shape in self.pair():
            if isinstance(shape, Polygon) and not shape.labels and len(shape.corners) <= 6:
                self.vertices(role, shape.corner_ids, as_role="guide")
        names = [telling.short_axis_name(axis, (self.trace.a, self.trace.b), self.trace.names) for axis in left]
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

    def finish(self, title: str, sentence: str, *, steady: bool = True) -> Picture:
        """Place the labels and close the picture; `steady` names stay put from step to step."""
        requests = [request for _, request in sorted(self.requests, key=lambda r: r[0])]
        keep_off = [arrow for arrow in map(self.normal_arrow, self.trace.tests) if arrow]
        marks = with_labels(self.marks, requests, self.layout, steady=steady, keep_off=keep_off)
        return Picture(tuple(marks), self.layout.limits, self.layout.size, title, sentence)
