"""The part of a sketch that needs no axis: shapes, vertices, lines across the canvas, words.

Every number comes from the trace.  Labels are only requested here; they get their places when all marks are known.
"""

from collections.abc import Collection, Sequence
from itertools import pairwise
from typing import Unpack

from ..engine import describe
from ..engine.geometry import Vec
from ..engine.sat import AxisTest
from ..engine.shapes import Circle, Polygon, Shape, centroid
from ..engine.trace import Trace
from .float_geometry import clip_line, clip_segment, point_along
from .insets import Role, inset_marks, is_too_small
from .label_placer import LabelMemory, LabelOptions, LabelRequest, Segment
from .labels import contains_point, name_spots, short_name, with_labels
from .layout import Layout
from .letters import wrap_text
from .marks import Mark, MarkOptions, Picture

CROWDED_SIZES = 6.0  # a shape smaller than so many of the smallest visible sizes has no marks at corners and edges
MAX_NAMED_CORNERS = 6  # an outline without labels has the names of its corners if it has at most so many
HATCH_PT = 6.0  # distance between the lines of a hatched area
NOTE_PT = 20.0  # distance from the top of the canvas to a note
RIM_PT = 14.0  # distance between the ends of a line across the canvas and the rim of the canvas
HEADING_PT = 34.0  # height of the verdict's space at the top of the canvas: no line across the canvas runs through it


class ShapeSketch:
    """Collects the marks of one picture of a trace, and the requests for its labels."""

    def __init__(self, trace: Trace, layout: Layout) -> None:
        self.trace = trace
        self.layout = layout
        self.digits: describe.NumberFormat = describe.digits
        self.marks: list[Mark] = []
        self.requests: list[tuple[int, LabelRequest]] = []

    def add(self, part: str, kind: str, role: str, *points: Vec, **more: Unpack[MarkOptions]) -> None:
        """Add a mark: what it shows, its kind, its colour, its points (scene units), and more fields of `Mark`."""
        self.marks.append(Mark(part, kind, role, points, **more))

    def label(
        self, part: str, text: str, role: str, anchor: Vec, *, first: int = 5, **more: Unpack[LabelOptions]
    ) -> None:
        """Request a label near `anchor`; labels with a lower number `first` choose their places earlier."""
        self.requests.append((first, LabelRequest(part, text, role, anchor, **more)))

    def shape(
        self, role: str, name: str, shape: Shape, *, weight: str = "plain", named: bool = True, quiet: bool = False
    ) -> None:
        """Draw a shape's outline, its name if `named` (small if `quiet`), and a dot if it is very small.

        `weight`: that of the outline, such as "plain", "faint" or "fill".
        """
        if isinstance(shape, Circle):
            self.add("outline", "disc", role, shape.center, owner=name, radius=shape.radius, weight=weight)
        else:
            self.add("outline", "outline", role, *shape.vertices, owner=name, weight=weight)
        if weight != "faint" and is_too_small(shape, self.layout.scale):
            x0, y0, x1, y1 = shape.bounds
            self.add("speck", "dot", role, Vec((x0 + x1) / 2, (y0 + y1) / 2), owner=name)
        if named:
            other = self.trace.b if role == "A" else self.trace.a
            spot, *along = sorted(name_spots(shape), key=lambda p: contains_point(other, p))
            options: LabelOptions = {"owner": name, "along": tuple(along), "inside": True, "steady": True}
            options |= {
                "target": centroid(shape),
                "weight": "plain" if quiet else "title",
                "optional": quiet,
                "near": quiet,
            }
            self.label("name", name, role, spot, **options)

    def bounding_boxes(self) -> None:
        """Draw the upright box around each shape, and hatch the area that both boxes share."""
        boxes = [shape.bounds for _, _, shape in self.roles()]
        for (role, name, _), (x0, y0, x1, y1) in zip(self.roles(), boxes, strict=True):
            ring = Vec(x0, y0), Vec(x1, y0), Vec(x1, y1), Vec(x0, y1), Vec(x0, y0)
            self.add(
                "box", "segment", role, *(end for side in pairwise(ring) for end in side), owner=name, weight="faint"
            )
        p, q = boxes
        shared = max(p[0], q[0]), max(p[1], q[1]), min(p[2], q[2]), min(p[3], q[3])
        x0, y0, x1, y1 = shared
        step, high = self.layout.units(HATCH_PT), y1 - y0
        if x1 <= x0 or y1 <= y0:
            return
        lines = [(Vec(x, y0), Vec(x + high, y1)) for k in range(200) if (x := x0 - high + step * (k + 0.5)) < x1]
        parts = [(s, t, part) for s, t in lines if (part := clip_segment(*s, *t, *shared)) and part[0] < part[1]]
        ends = (Vec(s.x + (t.x - s.x) * u, s.y + (t.y - s.y) * u) for s, t, part in parts for u in part)
        self.add("shared-box", "segment", "overlap", *ends, weight="faint")

    def is_crowded(self, shape: Shape) -> bool:
        """Check whether a shape is too small for marks at its corners and edges."""
        return is_too_small(shape, self.layout.scale / CROWDED_SIZES)

    def shapes(self) -> None:
        """Draw both shapes with the names of labelled vertices, and insets of what is too small to see."""
        self.insets()
        for role, name, shape in self.roles():
            self.shape(role, name, shape)
            if isinstance(shape, Polygon) and shape.labels:
                self.vertices(role, range(len(shape.vertices)))

    def insets(self, test: AxisTest | None = None) -> None:
        """Draw the insets of the shapes, or the inset of the gap of `test` if it is given."""
        self.marks += inset_marks(self.layout, self.roles(), test)

    def roles(self) -> list[Role]:
        """Return (role, name, shape) of A and of B."""
        return [("A", self.trace.names.a, self.trace.a), ("B", self.trace.names.b, self.trace.b)]

    def named_shape(self, role: str | None) -> tuple[str, Shape]:
        """Return the name and the shape of role "A" or "B"."""
        _, name, shape = self.roles()[role != "A"]
        return name, shape

    def named_polygon(self, role: str | None) -> tuple[str, Polygon]:
        """Return the name and the shape of role "A" or "B"; the caller knows that the shape is a polygon."""
        name, shape = self.named_shape(role)
        assert isinstance(shape, Polygon)
        return name, shape

    def vertices(self, role: str, ids: Sequence[int], *, as_role: str = "") -> None:
        """Draw named dots at the polygon's vertices `ids`; `as_role` gives the names another colour."""
        name, polygon = self.named_polygon(role)
        middle = centroid(polygon)
        for i in ids:
            if any((m.part, m.owner, m.number) == ("vertex", name, i) for m in self.marks):
                continue
            v = polygon.vertices[i]
            self.add("vertex", "dot", role, v, owner=name, number=i)
            away = Vec(v.x - middle.x, v.y - middle.y)
            options: LabelOptions = {"owner": name, "number": i, "prefer": away, "optional": True, "steady": True}
            self.label("vertex-name", short_name(polygon, name, i), as_role or role, v, first=4, **options)

    def corners(self, roles: Collection[str | None] = "AB", *, as_role: str = "") -> None:
        """Draw named dots at the corners of the shapes of `roles` that have few corners and no labels of their own.

        Sentences about edges use these names.  `as_role` gives the names another colour.
        """
        for role, _, shape in self.roles():
            if role not in roles or not isinstance(shape, Polygon) or shape.labels:
                continue
            if len(shape.corners) <= MAX_NAMED_CORNERS and not self.is_crowded(shape):
                self.vertices(role, shape.corner_ids, as_role=as_role)

    def line_across(self, part: str, through: Vec, normal: Vec, role: str, number: int | None = None) -> Segment:
        """Draw the line through a point at right angles to a unit normal, across the canvas below the heading.

        Return its ends.
        """
        x0, y0, x1, y1 = self.layout.scene_limits
        rim = self.layout.units(RIM_PT)
        d = Vec(-normal.y, normal.x)
        # a component that should be 0 but is a rounding error: dividing by it would give nonsense
        across = Vec(*(u if abs(u) > 1e-12 else 0.0 for u in d))
        start, end = clip_line(through, across, (x0 + rim, y0 + rim, x1 - rim, y1 - self.layout.units(HEADING_PT)))
        ends = point_along(through, d, start), point_along(through, d, end)
        self.add(part, "segment", role, *ends, number=number)
        return ends

    def note(self, part: str, text: str, role: str, *, weight: str = "plain", first: int = 8) -> None:
        """Request a label that belongs to no mark; it stands near the top, or where there is space."""
        x0, _, x1, y1 = self.layout.scene_limits
        space = (x1 - x0) * self.layout.scale - 2 * RIM_PT
        text = "\n".join(wrap_text(line, space, weight) for line in text.split("\n"))
        anchor = Vec((x0 + x1) / 2, y1 - self.layout.units(NOTE_PT))
        self.label(
            part, text, role, anchor, weight=weight, first=first, inside=True, far=True, optional=weight != "title"
        )

    def upcoming_normals(self) -> list[Segment]:
        """Return segments that steady labels avoid, since normals stand there in other steps; here none."""
        return []

    def finish(
        self,
        title: str,
        sentence: str,
        *,
        steady: bool = True,
        kept: Sequence[Mark] = (),
        memory: LabelMemory | None = None,
    ) -> Picture:
        """Place the labels and return the picture.

        `steady`: the names of shapes and vertices stand at one spot in all steps; `kept`: labels of other steps, whose
        spots are kept; `memory`: how the labels stood in the last picture of a drag.
        """
        requests = [request for _, request in sorted(self.requests, key=lambda r: r[0])]
        marks = with_labels(
            self.marks,
            requests,
            self.layout,
            steady=steady,
            keep_off=self.upcoming_normals(),
            kept=kept,
            memory=memory,
        )
        return Picture(tuple(marks), self.layout.limits, self.layout.size, title, sentence)
