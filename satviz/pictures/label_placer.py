"""The search for the place of one label: the nearest spot that is clear of lines, dots, other labels and the rim.

Every spot has a cost, without unit.  A label takes the cheapest spot.  Coordinates here are points from the lower
left corner of the canvas; requests and marks are in scene units.  A pose is one picture of a drag.
"""

from bisect import bisect_left
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from math import cos, dist, hypot, pi, sin
from typing import NamedTuple

from ..engine.geometry import Vec
from .float_geometry import Box, boxes_overlap, circle_points, clip_segment, on_opposite_sides
from .layout import Layout
from .letters import text_size, wrap_text
from .marks import Mark, SharedOptions
from .theme import DOT_PT

Segment = tuple[Vec, Vec]
LabelKey = tuple[str, str, str, int | None]  # part, owner, axis, number
Spot = tuple[float, float]

RIM_PT = 4.0  # space kept free between a label and the rim of the canvas
# distances that are tried, from an anchor to the label's box
DISTANCES_PT = (3.0, 7.0, 12.0, 18.0, 26.0, 36.0, 50.0, 70.0, 95.0, 125.0)
MAX_NEAR_DISTANCES = 2  # a label that must stay near its anchor takes one of the first so many of these
DIRECTIONS = tuple(Vec(cos(k * pi / 8), sin(k * pi / 8)) for k in range(16))
GRID_STEPS = 12  # steps across the canvas, and up it, of the spots for a label that may stand anywhere
MIN_LEADER_PT = 22.0  # a label further than this from its anchor gets a line to it
# costs; distances in points are added to them
COVER_COST = 1e4  # cost of covering a label or a dot
OUTSIDE_COST = 1e5  # cost of leaving the canvas
STROKE_COST, FAINT_COST, GUIDE_COST, KEPT_FREE_COST = 300, 60, 40, 100  # costs of covering a line of each kind
MAX_OPTIONAL_COST = 300  # an optional label whose best spot costs so much or more is left out
OTHER_SIDE_COST = 200  # cost of a place beyond the separating line
WALL_COST = 150  # cost of a place beyond the label's own wall
ANYWHERE_COST = 60  # cost of a spot on the grid, which is not beside an anchor
# while a shape is dragged
# how far a label may move from one pose to the next, unless its target moves more: 24 px where the picture is largest
MAX_MOVE_PT = 16.5
LEAP_PT = 24.0  # a label whose target moves more may stand elsewhere
GLIDES_PT = 4.0, 8.0, 12.0  # distances by which a label may move relative to its target in one pose
MOVE_COST = 6.0  # a label stays where it was unless another spot is cheaper by more
MISSING_POSES = 12  # poses for which a label without a clear spot nearby is left out, before it may stand elsewhere
TOUCH_COST, NEAR_PT = 10.0, 3.0  # TOUCH_COST for each point by which a label is nearer than NEAR_PT to its anchor


class LabelRequest(NamedTuple):
    """A request for a label near its anchor (scene units), best in the direction `prefer` from it.

    `along`: other anchors that serve nearly as well, such as points of a bar.
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
    inside: bool = False  # centered on an anchor if that spot is clear
    optional: bool = False  # left out rather than drawn over something
    near: bool = False  # near its anchor, or left out
    far: bool = False  # may stand anywhere on the canvas
    led: bool = False  # a `far` label has a line to its anchor if it is far from it
    steady: bool = False  # stands at one spot in all steps
    wall: Segment | None = None  # the label belongs on its anchor's side of this line
    pieces: tuple[tuple[str, str], ...] = ()  # the text, which may have lines, in pieces with their roles: (text, role)
    target: Vec | None = None  # the point that the label follows in a drag, if its anchor may change; None: the anchor
    longer: str = ""  # the text where there is still clear space once all labels stand; never in a drag

    @property
    def key(self) -> LabelKey:
        """Return (part, owner, axis, number), by which its label is known from picture to picture."""
        return self.part, self.owner, self.axis, self.number


class LabelOptions(SharedOptions, total=False):
    """The optional fields of a request for a label."""

    along: tuple[Vec, ...]
    prefer: Vec
    inside: bool
    optional: bool
    near: bool
    far: bool
    led: bool
    steady: bool
    wall: Segment | None
    pieces: tuple[tuple[str, str], ...]
    target: Vec | None
    longer: str


class LabelSpot(NamedTuple):
    """Where a label and its target stood in the last picture (points), in how many lines, and since when it is missing.

    `missing`: for how many poses it has been left out; 0 for a label that is shown.
    """

    at: Spot
    target: Spot
    lines: int = 1
    missing: int = 0


@dataclass
class LabelMemory:
    """How the labels stood in the last picture of a drag, so that none leaps; a placer updates it.

    `resting`: the drag has ended, so a label that covers something or is missing may go anywhere.
    """

    spots: dict[LabelKey, LabelSpot] = field(default_factory=dict)
    resting: bool = True

    def copy(self) -> "LabelMemory":
        """Return a memory that can be changed without changing this one."""
        return LabelMemory(dict(self.spots), self.resting)


class LabelPlacer:
    """Places labels one by one, each on the cheapest spot given the marks and labels noted so far."""

    def __init__(self, layout: Layout, kept: Sequence[Mark] = (), memory: LabelMemory | None = None) -> None:
        """Make a placer that has noted nothing yet.

        `kept`: labels of other steps, which keep their spots; `memory`: how the labels stood in the last picture of a
        drag.
        """
        self.layout = layout
        self.memory = memory
        self.kept = [mark for mark in kept if mark.kind == "label"]
        self.strokes: list[tuple[float, float, float, float, float]] = []  # x, y, x, y, cost of covering it
        self.walls: list[tuple[Spot, Spot]] = []  # steady labels stay on their anchors' side of these
        self.boxes: list[Box] = []
        self.taken: dict[LabelKey, Box] = {}  # those of the labels

    def add_mark(self, mark: Mark) -> None:
        """Record the space that a mark takes, so that labels avoid it."""
        points = mark.points
        if mark.part == "inset":
            self.boxes.append((*self._in_points(points[0]), *self._in_points(points[2])))
        elif mark.kind == "dot":
            self._add_box(points[0], DOT_PT / 2, DOT_PT / 2)
        elif mark.kind == "label":
            width, height = text_size(mark.text, mark.weight)
            self._add_box(points[0], width / 2, height / 2)
        elif mark.kind == "disc":
            rim = circle_points(points[0], mark.radius, 32)
            for p, q in pairwise((*rim, rim[0])):
                self.add_stroke(p, q, STROKE_COST)
        else:
            plain_cost = FAINT_COST if mark.weight == "faint" else STROKE_COST
            ring = (*points, points[0]) if mark.kind == "outline" else points
            for p, q in pairwise(ring):
                self.add_stroke(p, q, GUIDE_COST if mark.role == "guide" else plain_cost)
            if mark.part == "line":  # a name beyond the separating line would seem to belong there
                self.walls.append((self._in_points(points[0]), self._in_points(points[1])))

    def add_stroke(self, p: Vec, q: Vec, cost: float) -> None:
        """Record a line from p to q (scene units), and what it costs a label to cover it."""
        self.strokes.append((*self._in_points(p), *self._in_points(q), cost))

    def _add_box(self, p: Vec, w: float, h: float) -> None:
        """Record a box to avoid: w points to either side of p (scene units), h points above and below it."""
        x, y = self._in_points(p)
        self.boxes.append((x - w, y - h, x + w, y + h))

    def kept_spot(self, request: LabelRequest) -> Vec | None:
        """Return where the same label stands in another step (scene units); None if in no step, or not free now."""
        for label in self.kept:
            if (label.part, label.owner, label.axis, label.number, label.text) == (*request.key, request.text):
                (x, y), (w, h) = self._in_points(label.points[0]), text_size(label.text, label.weight)
                box = x - w / 2 + 0.01, y - h / 2 + 0.01, x + w / 2 - 0.01, y + h / 2 - 0.01
                if self._is_inside(box) and not any(boxes_overlap(box, other) for other in self.boxes):
                    return label.points[0]
        return None

    def _is_inside(self, box: Box) -> bool:
        """Check whether a box lies on the canvas and off its rim."""
        width, height = self.layout.size
        return box[0] >= RIM_PT and box[1] >= RIM_PT and box[2] <= width - RIM_PT and box[3] <= height - RIM_PT

    def _in_points(self, p: Vec) -> Spot:
        """Return a point of the scene in points from the lower left corner of the canvas."""
        x0, y0, _, _ = self.layout.limits
        scale = self.layout.scale
        return (p.x - x0) * scale, (p.y - y0) * scale

    def labels(self, requests: Sequence[LabelRequest]) -> list[Mark]:
        """Return the marks of a label for each request that finds a place, and of a line to an anchor far from it."""
        found = []
        for r in requests:
            at = self._keep(r)
            if at is None:
                r, at = self._place(r)
            if at is None:
                continue
            key = r.owner, r.axis, r.number
            end = None if (r.far and not r.led) or r.inside or r.along else self._leader_end(r, at)
            if end and self._crosses_label(r.anchor, end):
                end = self._nearest_on_label(r, at)
            if end and self._crosses_label(r.anchor, end):
                if r.optional:  # far from its anchor and without a line to it, nobody could tell what it names
                    self.boxes.pop()
                    continue
                end = None
            if end:
                self.add_stroke(r.anchor, end, STROKE_COST)
                found.append(Mark(f"{r.part}-leader", "segment", "guide", (r.anchor, end), *key, weight="faint"))
            if r.pieces:
                found += self._pieces(r, at)
            else:
                found.append(Mark(r.part, "label", r.role, (at,), *key, text=r.text, weight=r.weight))
        return found

    def with_text_as_kept(self, request: LabelRequest) -> LabelRequest:
        """Return the request with one text: the one that its label has in another step, or in a drag the shorter.

        If no other step has the label, the request keeps its `longer` text, for `lengthen`.
        """
        if not request.longer or self.memory is not None:
            return request._replace(longer="")
        long = request._replace(text=request.longer, longer="")
        if self.kept_spot(long):
            return long
        return request._replace(longer="") if self.kept_spot(request) else request

    def lengthen(self, labels: Sequence[Mark], requests: Sequence[LabelRequest]) -> list[Mark]:
        """Return the labels, each with its request's `longer` text if that covers nothing and needs no line.

        The labels of one axis are all lengthened, or none of them.
        """
        spots: dict[LabelKey, Vec] = {}
        longer = {r.key: r._replace(text=r.longer, optional=True) for r in requests if r.longer and r.key in self.taken}
        for axis in dict.fromkeys(r.axis for r in longer.values()):
            group = [r for r in longer.values() if r.axis == axis]
            before, taken = self.boxes, self.taken
            self.boxes = [box for box in before if box not in [taken[r.key] for r in group]]
            self.taken = dict(taken)
            found = {r.key: self._take(r, *best) for r in group if (best := self._best_spot(r))[1] < MIN_LEADER_PT}
            if len(found) == len(group):
                spots |= {key: at for key, at in found.items() if at}
            else:
                self.boxes, self.taken = before, taken
        marks = []
        for label in labels:
            key = label.part, label.owner, label.axis, label.number
            at = spots.get(key)
            marks.append(label._replace(text=longer[key].text, points=(at,)) if at else label)
        return marks

    def _pieces(self, request: LabelRequest, at: Vec) -> Iterator[Mark]:
        """Yield a label for each piece of a text; its lines begin at one x; all are centered at `at` (scene units)."""
        width, height = map(self.layout.units, text_size(request.text))
        high = height / (request.text.count("\n") + 1)
        left, x, y = at.x - width / 2, at.x - width / 2, at.y + (height - high) / 2
        number = 0
        for text, role in request.pieces:
            for k, line in enumerate(text.split("\n")):
                if k:
                    x, y = left, y - high
                bare = line.strip()
                start = x + self.layout.units(text_size(line[: len(line) - len(line.lstrip())])[0])
                x += self.layout.units(text_size(line)[0])
                if bare:
                    spot = Vec(start + self.layout.units(text_size(bare)[0]) / 2, y)
                    yield Mark(request.part, "label", role, (spot,), request.owner, request.axis, number, text=bare)
                    number += 1

    def _leader_end(self, request: LabelRequest, at: Vec) -> Vec | None:
        """Return where a line from the anchor meets the box of its label, centered at `at` (both in scene units).

        None if the label is near its anchor.
        """
        w, h = (self.layout.units(c / 2 + 1) for c in text_size(request.text, request.weight))
        a = request.anchor
        part = clip_segment(a.x, a.y, at.x, at.y, at.x - w, at.y - h, at.x + w, at.y + h)
        if part is None or part[0] * hypot(at.x - a.x, at.y - a.y) < self.layout.units(MIN_LEADER_PT):
            return None
        return Vec(a.x + (at.x - a.x) * part[0], a.y + (at.y - a.y) * part[0])

    def _nearest_on_label(self, request: LabelRequest, at: Vec) -> Vec:
        """Return the point nearest to the anchor in the box of its label, centered at `at` (both in scene units)."""
        w, h = (self.layout.units(c / 2 + 1) for c in text_size(request.text, request.weight))
        a = request.anchor
        return Vec(min(max(a.x, at.x - w), at.x + w), min(max(a.y, at.y - h), at.y + h))

    def _crosses_label(self, anchor: Vec, end: Vec) -> bool:
        """Check whether a line to the label placed last would cross another label, whose line it would seem to be."""
        line = *self._in_points(anchor), *self._in_points(end)
        # the last box is the label's own
        return any(clip_segment(*line, *box) and not _is_dot(box) for box in self.boxes[:-1])

    def _keep(self, request: LabelRequest) -> Vec | None:
        """Return where the same label stands in another step (scene units), and reserve it; None if it is not free."""
        at = self.kept_spot(request)
        if at is not None:
            w, h = text_size(request.text, request.weight)
            self._add_box(at, w / 2 + 2, h / 2 + 1)
        return at

    def _place(self, request: LabelRequest) -> tuple[LabelRequest, Vec | None]:
        """Return the request, perhaps broken into lines, and its label's center in scene units (None: left out)."""
        target = self._in_points(request.target or request.anchor)
        last = self.memory.spots.get(request.key) if self.memory else None
        if self.memory is None or last is None:
            return self._place_freely(request, target)
        moved = dist(target, last.target)
        if moved > LEAP_PT or last.missing >= MISSING_POSES:
            return self._place_freely(request, target)
        if last.lines > 1:
            width = text_size(request.text, request.weight)[0]
            request = request._replace(text=wrap_text(request.text, width / last.lines, request.weight))
        spot, cost = self._spot_nearby(request, last, target, MAX_MOVE_PT - moved)
        if self.memory.resting and (last.missing or cost >= STROKE_COST):
            return self._place_freely(request._replace(text=request.text.replace("\n", " ")), target)
        if cost >= (MAX_OPTIONAL_COST if request.optional and not request.far else COVER_COST):
            self.memory.spots[request.key] = LabelSpot(spot, target, last.lines, last.missing + 1)
            return request, None
        self.memory.spots[request.key] = LabelSpot(spot, target, last.lines)
        return request, self._take(request, spot, cost)

    def _place_freely(self, request: LabelRequest, target: Spot) -> tuple[LabelRequest, Vec | None]:
        """Return the request, perhaps broken into lines, and its label's center in scene units (None: left out).

        The label may stand anywhere, wherever it stood before; `target` is the point (in points) that it will follow.
        A label that must be shown is broken into 2 or 3 lines where it would cover something in one; a title also
        where a line would run through it.
        """
        spot, cost = self._best_spot(request)
        width, count = text_size(request.text, request.weight)[0], 1
        clear, even = COVER_COST, 1.0
        if request.far and request.weight == "title":
            clear, even = STROKE_COST, 1.2  # with the width of half the letters, most titles would need a third line
        for lines in (2, 3) if not (request.optional or request.pieces) else ():
            if cost < clear:
                break
            slim = request._replace(text=wrap_text(request.text, even * width / lines, request.weight))
            slim_spot, slim_cost = self._best_spot(slim)
            if slim_cost < cost:
                request, spot, cost, count = slim, slim_spot, slim_cost, lines
        at = self._take(request, spot, cost)
        if self.memory is not None:
            stands = spot if at is None else self._in_points(at)
            self.memory.spots[request.key] = LabelSpot(stands, target, count, int(at is None))
        return request, at

    def _spot_nearby(self, request: LabelRequest, last: LabelSpot, target: Spot, most: float) -> tuple[Spot, float]:
        """Return (cheapest spot, cost), at most `most` points from the old spot moved along with the label's target.

        Guide lines cost nothing: they end at labels.
        """
        w, h = (side / 2 for side in text_size(request.text, request.weight))
        x, y = last.at[0] + target[0] - last.target[0], last.at[1] + target[1] - last.target[1]
        spots = [(x, y)]
        for size in GLIDES_PT:
            spots += [(x + u.x * size, y + u.y * size) for u in DIRECTIONS if size <= most]
        width, height = self.layout.size
        best, found = float("inf"), (x, y)
        for i, (sx, sy) in enumerate(spots):
            inside = (
                min(max(sx, w + RIM_PT), max(width - w - RIM_PT, w + RIM_PT)),
                min(max(sy, h + RIM_PT), max(height - h - RIM_PT, h + RIM_PT)),
            )
            spot = inside if dist(inside, (x, y)) <= most else (sx, sy)
            cost = self._cost_of_distance(request, spot, w, h) + (MOVE_COST if i else 0.0)
            if cost < best:
                cost += self.cover_cost(spot, w + 2, h + 1, best - cost, guides=False)
            if cost < best:
                best, found = cost, spot
        return found, best

    def _cost_of_distance(self, request: LabelRequest, spot: Spot, w: float, h: float) -> float:
        """Return the cost of a spot for a label 2w by 2h: its distance from the anchors, without what it covers."""
        (x, y), cost = spot, float("inf")
        for rank, anchor in enumerate((request.anchor, *request.along)):
            ax, ay = self._in_points(anchor)
            if request.inside or request.far:
                away = dist(spot, (ax, ay)) + rank / 8
            else:
                off = hypot(max(abs(x - ax) - w, 0.0), max(abs(y - ay) - h, 0.0))
                away = off + max(NEAR_PT - off, 0.0) * TOUCH_COST + rank
            cost = min(cost, away)
        return cost + self._cost_of_side(request, spot)

    def _cost_of_side(self, request: LabelRequest, spot: Spot) -> float:
        """Return the cost of standing across a separating line, or across the label's own `wall`, from its anchor."""
        if not (request.steady or request.wall):  # most labels
            return 0.0
        anchor, cost = self._in_points(request.anchor), 0.0
        if request.steady and any(on_opposite_sides(anchor, spot, line) for line in self.walls):
            cost += OTHER_SIDE_COST
        if request.wall:
            wall = self._in_points(request.wall[0]), self._in_points(request.wall[1])
            cost += WALL_COST if on_opposite_sides(anchor, spot, wall) else 0.0
        return cost

    def _best_spot(self, request: LabelRequest) -> tuple[Spot, float]:
        """Return (cheapest spot, its cost) for a label."""
        w, h = text_size(request.text, request.weight)
        anchor = self._in_points(request.anchor)
        best, found = float("inf"), anchor
        for spot, cost in self._near_spots(request, w / 2, h / 2):
            if cost >= best:
                break
            cost += self._cost_of_side(request, spot)
            cost += self.cover_cost(spot, w / 2 + 2, h / 2 + 1, best - cost)
            if cost < best:
                best, found = cost, spot
            if best <= 0:
                break
        if best >= COVER_COST and not request.far and not request.optional:
            for spot, cost in self._spots_anywhere(w / 2, h / 2, anchor):
                cost += self.cover_cost(spot, w / 2 + 2, h / 2 + 1, best - cost)
                if cost < best:
                    best, found = cost, spot
        return found, best

    def _take(self, request: LabelRequest, spot: Spot, cost: float) -> Vec | None:
        """Reserve the spot for a label and return its center in scene units.

        None if the label is optional and the cost of the spot is too high.  A label too long for any spot is moved
        onto the canvas.
        """
        if request.optional and cost >= MAX_OPTIONAL_COST:
            return None
        w, h = text_size(request.text, request.weight)
        width, height = self.layout.size
        cx = min(max(spot[0], w / 2 + RIM_PT), width - w / 2 - RIM_PT)
        cy = min(max(spot[1], h / 2 + RIM_PT), height - h / 2 - RIM_PT)
        self.taken[request.key] = cx - w / 2 - 2, cy - h / 2 - 1, cx + w / 2 + 2, cy + h / 2 + 1
        self.boxes.append(self.taken[request.key])
        x0, y0, _, _ = self.layout.limits
        return Vec(x0 + cx / self.layout.scale, y0 + cy / self.layout.scale)

    def _near_spots(self, request: LabelRequest, w: float, h: float) -> Iterator[tuple[Spot, float]]:
        """Yield (center, cost) near the anchors, cheapest first; covered marks are not counted yet.

        `w` and `h`: half of the label's width and height.
        """
        x, y = self._in_points(request.anchor)
        if request.inside:
            yield (x, y), 0.0
            for rank, anchor in enumerate(request.along, 1):
                yield self._in_points(anchor), rank / 8
        size = hypot(*request.prefer) or 1.0
        toward = Vec(request.prefer.x / size, request.prefer.y / size)
        turn_cost = 1 if request.far else 9
        ways = [(u, (1 - (u.x * toward.x + u.y * toward.y)) * turn_cost) for u in (toward, *DIRECTIONS)]
        anchors = [(rank, *self._in_points(anchor)) for rank, anchor in enumerate((request.anchor, *request.along))]
        distances = DISTANCES_PT[: MAX_NEAR_DISTANCES if request.near else None]
        # (cost, order among equals, spot); no spot costs less than its distance, so most are never worked out
        spots: list[tuple[float, tuple[int, int, int], Spot]] = []
        if request.far:
            everywhere = enumerate(self._spots_anywhere(w, h, (x, y)))
            spots += [(cost, (len(anchors), 0, k), spot) for k, (spot, cost) in everywhere]
        for step, distance in enumerate(distances):
            for rank, px, py in anchors:
                for k, (u, turn) in enumerate(ways):
                    spot = px + u.x * (w + distance), py + u.y * (h + distance)
                    spots.append((distance + turn + rank, (rank, step, k), spot))
            spots.sort()
            next_cost = distances[step + 1] - 1e-6 if step + 1 < len(distances) else float("inf")
            count = bisect_left(spots, next_cost, key=lambda s: s[0])
            for cost, _, spot in spots[:count]:
                yield spot, cost
            del spots[:count]

    def _spots_anywhere(self, w: float, h: float, near: Spot) -> Iterator[tuple[Spot, float]]:
        """Yield (center, cost) of a label 2w by 2h all over the canvas; the cost grows with the distance to `near`."""
        width, height = self.layout.size
        for i in range(GRID_STEPS + 1):
            for j in range(GRID_STEPS + 1):
                x = RIM_PT + w + (width - 2 * (RIM_PT + w)) * i / GRID_STEPS
                y = RIM_PT + h + (height - 2 * (RIM_PT + h)) * j / GRID_STEPS
                yield (x, y), ANYWHERE_COST + hypot(x - near[0], y - near[1]) / 10

    def cover_cost(self, spot: Spot, w: float, h: float, limit: float, *, guides: bool = True) -> float:
        """Return the cost of what a label 2w by 2h centered at `spot` covers; stop once over `limit`.

        Without `guides` a guide line costs nothing.
        """
        cx, cy = spot
        x0, y0, x1, y1 = cx - w, cy - h, cx + w, cy + h
        cost = 0.0 if self._is_inside((x0, y0, x1, y1)) else OUTSIDE_COST
        for bx0, by0, bx1, by1 in self.boxes:  # boxes_overlap, without the call
            if x0 < bx1 and bx0 < x1 and y0 < by1 and by0 < y1:
                cost += COVER_COST
                if cost >= limit:
                    return cost
        for sx, sy, tx, ty, stroke_cost in self.strokes:
            if cost >= limit:
                break
            # most strokes are far away: this quick check rejects them without a call
            if (sx < x0 and tx < x0) or (sx > x1 and tx > x1) or (sy < y0 and ty < y0) or (sy > y1 and ty > y1):
                continue
            if (guides or stroke_cost != GUIDE_COST) and clip_segment(sx, sy, tx, ty, x0, y0, x1, y1):
                cost += stroke_cost
        return cost


def _is_dot(box: Box) -> bool:
    """Check whether a box is as narrow as a dot, which a line to a label may cross."""
    return box[2] - box[0] <= DOT_PT
