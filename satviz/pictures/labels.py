"""The labels of a picture: in which order they choose their places, and which lines give way to them."""

from collections.abc import Sequence
from itertools import pairwise
from math import cos, hypot, pi, sin

from ..engine import describe
from ..engine.geometry import Vec
from ..engine.shapes import Circle, Shape, centroid
from .float_geometry import Box, boxes_overlap, clip_segment, midpoint, point_along
from .label_placer import KEPT_FREE_COST, LabelKey, LabelMemory, LabelPlacer, LabelRequest, Segment
from .layout import Layout
from .letters import text_size
from .marks import Mark

MAX_NAME_LETTERS = 16


def with_labels(
    marks: Sequence[Mark],
    requests: Sequence[LabelRequest],
    layout: Layout,
    *,
    steady: bool = False,
    keep_off: Sequence[Segment] = (),
    kept: Sequence[Mark] = (),
    memory: LabelMemory | None = None,
) -> list[Mark]:
    """Return the marks, then a label for each request that finds a place; earlier requests choose first.

    `steady`: the names of shapes and vertices avoid only what every step has: the outlines, and `keep_off`, where
    normals will stand.  So they stand at one spot in all steps.
    `kept`: labels of other steps; a label that is requested again stays where it is.
    `memory`: how the labels stood in the picture before, while a shape is dragged; they follow their targets, and
    move off what comes in their way by a little at a time.  It is updated.
    """
    placer = LabelPlacer(layout, kept, memory)
    insets = [mark for mark in marks if mark.part in ("inset", "inset-name")]
    for mark in insets:
        placer.add_mark(mark)
    requests = [placer.with_text_as_kept(r) for r in requests]
    stay = [r for r in requests if placer.kept_spot(r)]
    names = [r for r in requests if r.steady and r.part == "name" and r not in stay]
    vertex_names = [r for r in requests if r.steady and r.part != "name" and r not in stay]
    rest = [r for r in requests if not r.steady and r not in stay]
    outlines = [mark for mark in marks if mark.kind in ("outline", "disc") and mark not in insets]
    vertices = [mark for mark in marks if mark.part == "vertex"]
    others = [mark for mark in marks if mark not in outlines and mark not in vertices and mark not in insets]
    labels = placer.labels(stay)
    for mark in outlines if steady else (*outlines, *vertices, *others):
        placer.add_mark(mark)
    for p, q in keep_off if steady else ():
        placer.add_stroke(p, q, KEPT_FREE_COST)
    labels += placer.labels(names)
    for mark in vertices if steady else ():
        placer.add_mark(mark)
    labels += placer.labels(vertex_names)
    for mark in others if steady else ():
        placer.add_mark(mark)
    labels = placer.lengthen(labels + placer.labels(rest), requests)
    if memory is not None:
        there = {r.key for r in requests}
        memory.spots = {key: spot for key, spot in memory.spots.items() if key in there}
    labels = _without_covered(labels, requests, layout)
    boxes = [_label_box(mark, layout) for mark in labels if mark.kind == "label"]
    cut = (_cut_at_labels(m, boxes) if m.role == "guide" and m.kind == "segment" else m for m in marks)
    return [mark for mark in cut if mark.points] + labels


def _without_covered(labels: Sequence[Mark], requests: Sequence[LabelRequest], layout: Layout) -> list[Mark]:
    """Return the labels without the optional ones that a required label overlaps."""
    optional = {r.key for r in requests if r.optional}
    boxes: dict[LabelKey, Box] = {
        (mark.part, mark.owner, mark.axis, mark.number): _label_box(mark, layout)
        for mark in labels
        if mark.kind == "label"
    }
    required = [box for key, box in boxes.items() if key not in optional]
    covered = {k for k, p in boxes.items() if k in optional and any(boxes_overlap(p, q) for q in required)}
    return [m for m in labels if (m.part.removesuffix("-leader"), m.owner, m.axis, m.number) not in covered]


def _label_box(label: Mark, layout: Layout) -> Box:
    """Return the box of a label in scene units."""
    (x, y), size = label.points[0], text_size(label.text, label.weight)
    w, h = (layout.units(side / 2) for side in size)
    return x - w, y - h, x + w, y + h


def _cut_at_labels(mark: Mark, boxes: Sequence[Box]) -> Mark:
    """Return a guide line without its pieces inside `boxes`, the boxes of the labels."""
    pieces = list(zip(mark.points[::2], mark.points[1::2], strict=True))
    for box in boxes:
        pieces = [rest for p, q in pieces for rest in _outside_box(p, q, box)]
    return mark._replace(points=tuple(end for piece in pieces for end in piece))


def _outside_box(p: Vec, q: Vec, box: Box) -> list[Segment]:
    """Return the pieces of a segment outside a box: none, one or two."""
    inside = clip_segment(*p, *q, *box)
    if inside is None:
        return [(p, q)]
    start, end = (Vec(p.x + (q.x - p.x) * t, p.y + (q.y - p.y) * t) for t in inside)
    return [piece for piece, keep in (((p, start), inside[0] > 0), ((end, q), inside[1] < 1)) if keep]


def short_name(shape: Shape, name: str, i: int) -> str:
    """Return the name of vertex `i` of a shape called `name`, cut to 16 letters."""
    text = describe.vertex_name(shape, name, i)
    return text if len(text) <= MAX_NAME_LETTERS else f"{text[: MAX_NAME_LETTERS - 1]}\u2026"


def name_spots(shape: Shape) -> list[Vec]:
    """Return points inside a shape where its name may stand, the best first.

    For a polygon the centroid, then points half way and three quarters of the way out; for a circle points between
    its center and its rim, the first below the center.
    """
    if isinstance(shape, Circle):
        angles = [k * pi / 4 - pi / 2 for k in range(8)]
        return [point_along(shape.center, Vec(cos(t), sin(t)), shape.radius * f) for f in (0.5, 0.8) for t in angles]
    middle = centroid(shape)
    outer = [*shape.corners, *(midpoint(p, q) for p, q in pairwise(shape.corners))]
    spots = [Vec(middle.x + (v.x - middle.x) * f, middle.y + (v.y - middle.y) * f) for f in (0.5, 0.75) for v in outer]
    return [spot for spot in (middle, *spots) if contains_point(shape, spot)] or [middle]


def contains_point(shape: Shape, p: Vec) -> bool:
    """Check by crossing numbers in float64 whether a point lies inside a shape: accurate enough for a label."""
    if isinstance(shape, Circle):
        return hypot(p.x - shape.center.x, p.y - shape.center.y) < shape.radius
    inside = False
    for u, v in pairwise((*shape.corners, shape.corners[0])):
        if (u.y > p.y) != (v.y > p.y) and p.x < u.x + (p.y - u.y) / (v.y - u.y) * (v.x - u.x):
            inside = not inside
    return inside
