"""Where labels go: each at the nearest spot clear of strokes, dots, other labels and the rim."""

from bisect import bisect_left
from collections.abc import Iterator, Sequence
from itertools import chain, pairwise
from math import cos, hypot, pi, sin
from typing import NamedTuple

from ..engine import describe
from ..engine.geometry import Vec
from ..engine.shapes import Circle, Shape, centroid
from .caption import wrap_text
from .layout import Layout, clip_segment, point_along, text_size
from .marks import Limits, Mark, Which
from .theme import DOT_PT

Segment = tuple[Vec, Vec]

LONGEST_NAME = 16  # letters
RIM_PT = 4.0  # points that a label keeps from the canvas's rim
NEAR = 2  # how many of the distances are close by
GRID = 12  # steps across the canvas where a label may stand anywhere
COVERS = 1e4  # the cost of lying over a label or a dot
LOYAL = (
    50.0  # what another spot must be better by before a label leaves where it last_offsets: a guide line is no reason
)
LEADER = 22.0  # points beyond which a label is tied to its anchor by a line


class LabelRequest(NamedTuple):
    """A label that wants a place near its anchor (scene units), rather towards `prefer` than elsewhere.

    `along`: other anchors that serve nearly as well, such as the rest of a bar.
    """

    part: str
    text: str
    role: str
    anchor: Vec
    owner: str = ""
    axis: str = ""
    number: int | None = None
    weight: str = "plain"
    along: tuple[Vec, ...] = ()
    prefer: Vec = Vec(0.0, 1.0)
    inside: bool = False  # centered on an anchor if that is clear
    optional: bool = False  # leave it out rather than run it over something
    near: bool = False  # close by or not at all
    far: bool = False  # anywhere on the canvas will do
    steady: bool = False  # stays put from step to step, whatever else the step shows
    wall: Segment | None = None  # its side of this line is where it belongs

    @property
    def which(self) -> tuple[str, str, str, int | None]:
        """What its label will be of."""
        return self.part, self.owner, self.axis, self.number


class LabelOffset(NamedTuple):
    """Where a label last_offsets: points from its anchor, and what that spot cost by itself."""

    right: float
    up: float
    price: float


LabelOffsets = dict[tuple[str, str, str, int | None], LabelOffset]


class LabelOptions(Which, total=False):
    """What of a Request may be left out."""

    along: tuple[Vec, ...]
    prefer: Vec
    inside: bool
    optional: bool
    near: bool
    far: bool
    steady: bool
    wall: Segment | None


def with_labels(
    marks: Sequence[Mark],
    requests: Sequence[LabelRequest],
    layout: Layout,
    *,
    steady: bool = False,
    keep_off: Sequence[Segment] = (),
    kept: Sequence[Mark] = (),
    last_offsets: LabelOffsets | None = None,
) -> list[Mark]:
    """The marks and a label for each request that finds a place, the most important first.

    `steady`: the names of shapes and vertices see only what every step has (the
    outlines, and `keep_off`: where normals will stand), so that nothing jumps.
    `kept`: labels of other steps; one that is asked for again stays where it is.
    `last_offsets`: how the labels last_offsets by their anchors in the picture before, under the hand: where that is
    still clear they stand so again.  It is brought up to date.
    """
    board = LabelPlacer(layout, kept, last_offsets)
    beside = [mark for mark in marks if mark.part in ("inset", "inset-name")]
    for mark in beside:
        _put(board, mark)
    stay = [r for r in requests if board.kept_at(r)]
    names = [r for r in requests if r.steady and r.part == "name" and r not in stay]
    vertices = [r for r in requests if r.steady and r.part != "name" and r not in stay]
    rest = [r for r in requests if not r.steady and r not in stay]
    outlines = [mark for mark in marks if mark.kind in ("outline", "disc") and mark not in beside]
    corners = [mark for mark in marks if mark.part == "vertex"]
    others = [mark for mark in marks if mark not in outlines and mark not in corners and mark not in beside]
    labels = board.labels(stay)
    for mark in outlines if steady else (*outlines, *corners, *others):
        _put(board, mark)
    for p, q in keep_off if steady else ():
        board.stroke(p, q, 100)
    labels += board.labels(names)
    for mark in corners if steady else ():
        _put(board, mark)
    labels += board.labels(vertices)
    for mark in others if steady else ():
        _put(board, mark)
    labels += board.labels(rest)
    labels = _uncovered(labels, requests, layout)
    boxes = [(m.points[0], text_size(m.text, m.weight)) for m in labels if m.kind == "label"]
    return [_broken(m, boxes, layout) if m.role == "guide" and m.kind == "segment" else m for m in marks] + labels


def _uncovered(labels: Sequence[Mark], requests: Sequence[LabelRequest], layout: Layout) -> list[Mark]:
    """The labels without those that may be left out and on which others had to be placed for want of room."""
    optional = {r.which for r in requests if r.optional}
    boxes: dict[tuple[str, str, str, int | None], Limits] = {}
    for mark in labels:
        if mark.kind == "label":
            (x, y), size = mark.points[0], text_size(mark.text, mark.weight)
            w, h = (layout.units(side / 2) for side in size)
            boxes[mark.part, mark.owner, mark.axis, mark.number] = x - w, y - h, x + w, y + h
    must = [box for which, box in boxes.items() if which not in optional]
    gone = {w for w, p in boxes.items() if w in optional and any(_meet(p, q) for q in must)}
    return [m for m in labels if (m.part.removesuffix("-leader"), m.owner, m.axis, m.number) not in gone]


def _meet(p: Limits, q: Limits) -> bool:
    return p[0] < q[2] and q[0] < p[2] and p[1] < q[3] and q[1] < p[3]


def _broken(mark: Mark, boxes: Sequence[tuple[Vec, tuple[float, float]]], layout: Layout) -> Mark:
    """A guide line left out where it would run through words."""
    pieces = list(zip(mark.points[::2], mark.points[1::2], strict=True))
    for center, (width, height) in boxes:
        w, h = layout.units(width / 2), layout.units(height / 2)
        box = center.x - w, center.y - h, center.x + w, center.y + h
        pieces = [rest for p, q in pieces for rest in _around(p, q, box)]
    return mark._replace(points=tuple(end for piece in pieces for end in piece))


def short_name(shape: Shape, name: str, i: int) -> str:
    """A vertex's name cut to what a picture has room for."""
    text = describe.vertex_name(shape, name, i)
    return text if len(text) <= LONGEST_NAME else f"{text[: LONGEST_NAME - 1]}\u2026"


def name_spots(shape: Shape) -> list[Vec]:
    """Where a shape's name may stand, best first: the middle, or half way out; below a circle's center."""
    if isinstance(shape, Circle):
        turns = [k * pi / 4 - pi / 2 for k in range(8)]
        return [point_along(shape.center, Vec(cos(t), sin(t)), shape.radius * f) for f in (0.5, 0.8) for t in turns]
    middle = centroid(shape)
    outer = [*shape.corners, *(Vec((p.x + q.x) / 2, (p.y + q.y) / 2) for p, q in pairwise(shape.corners))]
    spots = [Vec(middle.x + (v.x - middle.x) * f, middle.y + (v.y - middle.y) * f) for f in (0.5, 0.75) for v in outer]
    return [spot for spot in (middle, *spots) if holds(shape, spot)] or [middle]


def holds(shape: Shape, p: Vec) -> bool:
    """Is the point inside, roughly?  (Crossing number; a label needs no more.)"""
    if isinstance(shape, Circle):
        return hypot(p.x - shape.center.x, p.y - shape.center.y) < shape.radius
    inside = False
    for u, v in pairwise((*shape.corners, shape.corners[0])):
        if (u.y > p.y) != (v.y > p.y) and p.x < u.x + (p.y - u.y) / (v.y - u.y) * (v.x - u.x):
            inside = not inside
    return inside


Box = tuple[float, float, float, float]
DISTANCES = (3.0, 7.0, 12.0, 18.0, 26.0, 36.0, 50.0, 70.0, 95.0, 125.0)
DIRECTIONS = tuple(Vec(cos(k * pi / 8), sin(k * pi / 8)) for k in range(16))


class LabelPlacer:
    """Places labels one by one, each at the nearest spot clear of strokes, dots, labels and the rim."""

    def __init__(self, layout: Layout, kept: Sequence[Mark] = (), last_offsets: LabelOffsets | None = None) -> None:
        self.layout = layout
        self.last_offsets: LabelOffsets = {} if last_offsets is None else last_offsets
        self.kept = [mark for mark in kept if mark.kind == "label"]
        self.strokes: list[tuple[float, float, float, float, float]] = []  # x, y, x, y, cost of crossing it
        self.walls: list[tuple[float, float, float, float]] = []  # x, y, x, y that no name strays across
        self.boxes: list[Box] = []

    def stroke(self, p: Vec, q: Vec, cost: float) -> None:
        """Something drawn from p to q, and what it costs to lie over it."""
        self.strokes.append((*self._points(p), *self._points(q), cost))

    def box(self, p: Vec, w: float, h: float) -> None:
        """Something w and h points to either side of p, not to be lain over."""
        x, y = self._points(p)
        self.boxes.append((x - w, y - h, x + w, y + h))

    def kept_at(self, request: LabelRequest) -> Vec | None:
        """Where the same label stands in another step, if that is on this canvas and free."""
        for label in self.kept:
            if (label.part, label.owner, label.axis, label.number, label.text) == (*request.which, request.text):
                (x, y), (w, h) = self._points(label.points[0]), text_size(label.text, label.weight)
                x0, y0, x1, y1 = x - w / 2 + 0.01, y - h / 2 + 0.01, x + w / 2 - 0.01, y + h / 2 - 0.01
                lies_on = any(x0 < box[2] and box[0] < x1 and y0 < box[3] and box[1] < y1 for box in self.boxes)
                if self._inside(x0, y0, x1, y1) and not lies_on:
                    return label.points[0]
        return None

    def _inside(self, x0: float, y0: float, x1: float, y1: float) -> bool:
        width, height = self.layout.size
        return x0 >= RIM_PT and y0 >= RIM_PT and x1 <= width - RIM_PT and y1 <= height - RIM_PT

    def wall(self, p: Vec, q: Vec) -> None:
        """A line that no name strays across."""
        self.walls.append((*self._points(p), *self._points(q)))

    def _points(self, p: Vec) -> tuple[float, float]:
        x0, y0, _, _ = self.layout.limits
        scale = self.layout.scale
        return (p.x - x0) * scale, (p.y - y0) * scale

    def labels(self, requests: Sequence[LabelRequest]) -> list[Mark]:
        """The label of each request that finds a place, in order; one far from its anchor gets a line to it."""
        found = []
        for r in requests:
            at = self._stay(r)
            if at is None:
                r, at = self._place(r)
            if at is None:
                continue
            which = r.owner, r.axis, r.number
            if not (r.far or r.inside or r.along) and (end := self._leader(r, at)):
                self.stroke(r.anchor, end, 300)
                found.append(Mark(f"{r.part}-leader", "segment", "guide", (r.anchor, end), *which))
            found.append(Mark(r.part, "label", r.role, (at,), *which, text=r.text, weight=r.weight))
        return found

    def _leader(self, request: LabelRequest, at: Vec) -> Vec | None:
        """Where a line from the anchor meets the label's box; None if they are near enough without."""
        w, h = (self.layout.units(c / 2 + 1) for c in text_size(request.text, request.weight))
        a = request.anchor
        inside = clip_segment(a.x, a.y, at.x, at.y, at.x - w, at.y - h, at.x + w, at.y + h)
        if inside is None or inside[0] * hypot(at.x - a.x, at.y - a.y) < self.layout.units(LEADER):
            return None
        end = Vec(a.x + (at.x - a.x) * inside[0], a.y + (at.y - a.y) * inside[0])
        line = *self._points(a), *self._points(end)
        # the last box is the label's own; a line through another label would tie the wrong one
        return None if any(clip_segment(*line, *box) and not _is_dot(box) for box in self.boxes[:-1]) else end

    def _stay(self, request: LabelRequest) -> Vec | None:
        at = self.kept_at(request)
        if at is not None:
            w, h = text_size(request.text, request.weight)
            self.box(at, w / 2 + 2, h / 2 + 1)
        return at

    def _place(self, request: LabelRequest) -> tuple[LabelRequest, Vec | None]:
        """The label and where it stands; in more lines where it has no room as it is, not at all if it is optional."""
        found, cost, price = self._best(request)
        width = text_size(request.text, request.weight)[0]
        for lines in (2, 3) if not request.optional else ():
            if cost < COVERS:
                break
            slim = request._replace(text=wrap_text(request.text, width / lines, request.weight))
            there, less, slim_price = self._best(slim)
            if less < cost:
                request, found, cost, price = slim, there, less, slim_price
        x, y = self._points(request.anchor)
        self.last_offsets[request.which] = LabelOffset(found[0] - x, found[1] - y, price)
        return request, self._take(request, found, cost)

    def _best(self, request: LabelRequest) -> tuple[tuple[float, float], float, float]:
        """The spot in points that costs a label least, what it costs, and what of that by itself."""
        w, h = text_size(request.text, request.weight)
        anchor = self._points(request.anchor)
        wall = request.wall and (*self._points(request.wall[0]), *self._points(request.wall[1]))
        best, found, price, loyal = float("inf"), anchor, 0.0, 0.0
        spots: Iterator[tuple[tuple[float, float], float, float]]
        spots = ((spot, penalty, 0.0) for spot, penalty in self._spots(request, w / 2, h / 2))
        if before := self.last_offsets.get(request.which):
            again = anchor[0] + before.right, anchor[1] + before.up
            spots = chain([(again, before.price - LOYAL, LOYAL)], spots)
        for spot, penalty, stays in spots:
            if penalty >= best:
                break
            by_itself = penalty + stays
            if request.steady and any(_cross(*anchor, *spot, *wall) for wall in self.walls):
                penalty += 200
            if wall and _cross(*anchor, *spot, *wall):
                penalty += 150
            cost = penalty + self._cost(spot, w / 2 + 2, h / 2 + 1, best - penalty)
            if cost < best:
                best, found, price, loyal = cost, spot, by_itself, stays
            if best <= 0:
                break
        best += loyal  # what it really costs
        if best >= COVERS and not request.far and not request.optional:  # no room near: anywhere, with a line to it
            for spot, penalty in self._anywhere(w / 2, h / 2, anchor):
                cost = penalty + self._cost(spot, w / 2 + 2, h / 2 + 1, best - penalty)
                if cost < best:
                    best, found, price = cost, spot, penalty
        return found, best, price

    def _take(self, request: LabelRequest, found: tuple[float, float], cost: float) -> Vec | None:
        """The label's center in scene units, its room taken; None for an optional one that found no clear spot."""
        if request.optional and cost >= 300:
            return None
        w, h = text_size(request.text, request.weight)
        # what is too long for any spot stays on the canvas all the same
        width, height = self.layout.size
        cx, cy = (
            min(max(found[0], w / 2 + RIM_PT), width - w / 2 - RIM_PT),
            min(max(found[1], h / 2 + RIM_PT), height - h / 2 - RIM_PT),
        )
        self.boxes.append((cx - w / 2 - 2, cy - h / 2 - 1, cx + w / 2 + 2, cy + h / 2 + 1))
        x0, y0, _, _ = self.layout.limits
        return Vec(x0 + cx / self.layout.scale, y0 + cy / self.layout.scale)

    def _spots(self, request: LabelRequest, w: float, h: float) -> Iterator[tuple[tuple[float, float], float]]:
        """Candidate centers in points with what each costs by itself, cheapest first."""
        x, y = self._points(request.anchor)
        if request.inside:
            yield (x, y), 0.0
            for rank, anchor in enumerate(request.along, 1):
                yield self._points(anchor), rank / 8
        size = hypot(*request.prefer) or 1.0
        toward = Vec(request.prefer.x / size, request.prefer.y / size)
        ways = [(u, (1 - (u.x * toward.x + u.y * toward.y)) * (1 if request.far else 9)) for u in (toward, *DIRECTIONS)]
        anchors = [(rank, *self._points(anchor)) for rank, anchor in enumerate((request.anchor, *request.along))]
        distances = DISTANCES[: NEAR if request.near else None]
        # (cost, place in the whole list, spot); no spot costs less than its distance, so most are never worked out
        spots: list[tuple[float, tuple[int, int, int], tuple[float, float]]] = []
        if request.far:
            all_over = enumerate(self._anywhere(w, h, (x, y)))
            spots += [(penalty, (len(anchors), 0, k), spot) for k, (spot, penalty) in all_over]
        for step, distance in enumerate(distances):
            for rank, px, py in anchors:
                for k, (u, turn) in enumerate(ways):
                    spot = px + u.x * (w + distance), py + u.y * (h + distance)
                    spots.append((distance + turn + rank, (rank, step, k), spot))
            spots.sort()
            more = distances[step + 1] - 1e-6 if step + 1 < len(distances) else float("inf")
            sure = bisect_left(spots, more, key=lambda s: s[0])
            for penalty, _, spot in spots[:sure]:
                yield spot, penalty
            del spots[:sure]

    def _anywhere(self, w: float, h: float, near: tuple[float, float]) -> Iterator[tuple[tuple[float, float], float]]:
        """Candidate centers all over the canvas with what each costs by itself."""
        width, height = self.layout.size
        for i in range(GRID + 1):
            for j in range(GRID + 1):
                x = RIM_PT + w + (width - 2 * (RIM_PT + w)) * i / GRID
                y = RIM_PT + h + (height - 2 * (RIM_PT + h)) * j / GRID
                yield (x, y), 60 + hypot(x - near[0], y - near[1]) / 10

    def _cost(self, spot: tuple[float, float], w: float, h: float, enough: float) -> float:
        """What a label there would cover; it stops counting at `enough`."""
        cx, cy = spot
        x0, y0, x1, y1 = cx - w, cy - h, cx + w, cy + h
        cost = 0.0 if self._inside(x0, y0, x1, y1) else 1e5
        for bx0, by0, bx1, by1 in self.boxes:
            if x0 < bx1 and bx0 < x1 and y0 < by1 and by0 < y1:
                cost += COVERS
                if cost >= enough:
                    return cost
        for sx, sy, tx, ty, price in self.strokes:
            if cost >= enough:
                break
            # most strokes are far off: that is seen before the exact look
            if (sx < x0 and tx < x0) or (sx > x1 and tx > x1) or (sy < y0 and ty < y0) or (sy > y1 and ty > y1):
                continue
            if clip_segment(sx, sy, tx, ty, x0, y0, x1, y1):
                cost += price
        return cost


def _cross(ax: float, ay: float, bx: float, by: float, sx: float, sy: float, tx: float, ty: float) -> bool:
    """Do the ends a and b lie on two sides of the line through s and t?"""
    return ((tx - sx) * (ay - sy) - (ty - sy) * (ax - sx)) * ((tx - sx) * (by - sy) - (ty - sy) * (bx - sx)) < 0


def _is_dot(box: Box) -> bool:
    return box[2] - box[0] <= DOT_PT


def _around(p: Vec, q: Vec, box: Limits) -> list[tuple[Vec, Vec]]:
    """What is left of a segment outside a box."""
    inside = clip_segment(*p, *q, *box)
    if inside is None:
        return [(p, q)]
    start, end = (Vec(p.x + (q.x - p.x) * t, p.y + (q.y - p.y) * t) for t in inside)
    return [piece for piece, keep in (((p, start), inside[0] > 0), ((end, q), inside[1] < 1)) if keep]


def _put(board: LabelPlacer, mark: Mark) -> None:
    """Tell the board what a mark covers."""
    points = mark.points
    if mark.part == "inset":
        (x0, y0), (x1, y1) = points[0], points[2]
        middle = Vec((x0 + x1) / 2, (y0 + y1) / 2)
        board.box(middle, (x1 - x0) / 2 * board.layout.scale, (y1 - y0) / 2 * board.layout.scale)
    elif mark.kind == "dot":
        board.box(points[0], DOT_PT / 2, DOT_PT / 2)
    elif mark.kind == "label":
        width, height = text_size(mark.text, mark.weight)
        board.box(points[0], width / 2, height / 2)
    elif mark.kind == "disc":
        rim = [point_along(points[0], Vec(cos(k * pi / 16), sin(k * pi / 16)), mark.radius) for k in range(33)]
        for p, q in pairwise(rim):
            board.stroke(p, q, 300)
    else:
        price = 40 if mark.role == "guide" else 300 if mark.weight != "faint" else 60
        ring = (*points, points[0]) if mark.kind == "outline" else points
        for p, q in pairwise(ring):
            board.stroke(p, q, price)
        if mark.part == "line":  # what stands beyond the separating line seems to belong there
            board.wall(points[0], points[1])
