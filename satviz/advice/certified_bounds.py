"""Models by what they must look at, and which relation each surely gives for a pair, whatever the order of its sums.

All is exact: integers, and bounds of rounding that are derived here. Where rounding can decide, a model is not sure,
even if it happens to be right. With u the rounding (2**-53, 2**-24 in float32), D an edge's span and M the reach:

SAT on plain floats asks each edge how far all the other's corners lie beyond it: nx*x + ny*y less the edge's own.
The normal carries one rounding (u D) and each product one more: 2u DM each, 4u DM both; their sum rounds by 2u DM,
which makes 6u DM for the corner, as much for the edge's own, and their difference rounds by 4u DM: under 17u DM in
all, with fused operations and in any order (the derivation of satviz.engine.relate).  Asked: 32.
float32 first rounds each coordinate, by d = u M at most (0 if it holds them all).  That moves each part of the normal
and of a difference E of corners by 2d, so the turn by 4d(D + E) + 8dd.

Circles: each side of the squares' comparison carries under 5 roundings, and two more where the radii are rounded
first; asked: 12.  Rounded coordinates move a difference by 2d, so the squared distance by 4d(|dx| + |dy|) + 8dd.
A circle and a polygon: a turn from the center carries under 12 roundings of its size, asked: 32; a squared distance
under 45 of the largest difference F squared, asked: 128 (the derivation of verdict._circle_polygon; the nearest of all
edges, so none is left out).  Rounded coordinates move a turn about an edge of parts dx, dy by
2d(|dx| + |dy|) + 4dF + 8dd, and the distance, which changes by no more than the points do, by 3d: its square by
9dF + 9dd.
Ranges on the normals, and on the line to the nearest vertex or through two centers, err more, as they project far
from the origin.  With R the reach and the radius together, an axis of span D: the landings of the center and of a
corner carry 6u DR each, the radius times the axis's length 6u DR, their sum 2u DR: 20u R in distance.  A vertex that
only seems the nearest is so by 10u of its distance squared at most, which turns the axis by so little that 14u R is
lost.  Rounded coordinates move the gap by 4u R.  That is 38u R; asked: 72.

Where a bound cannot tell, the pair may still be one on which the model rounds nothing, in whatever order it computes
(`rounding.py`): there plain floats tell touching too.
"""

from collections.abc import Collection, Iterable, Sequence
from fractions import Fraction
from itertools import chain, pairwise
from math import copysign, frexp, inf, isfinite, ldexp, nextafter, sqrt
from typing import NamedTuple, TypeVar

from ..engine.convex_parts import parts
from ..engine.geometry import Relation, Vec
from ..engine.predicates import HUGE, TINY, IntPoint, aligned, sign, to_int_points, to_integers
from ..engine.relate import relate, relate_integers
from ..engine.shapes import Polygon, Shape
from . import rounding
from .rounding import FLOAT64, FORMATS, Exact, Format, holds

T = TypeVar("T")
APART, TOUCHING, OVERLAPPING = Relation
SAT_ROUNDINGS, TURN_ROUNDINGS, DISTANCE_ROUNDINGS, LANDING_ROUNDINGS, RANGE_ROUNDINGS = (
    32,
    32,
    128,
    16,
    72,
)  # roundings asked of each
WIDENING = 1 + 2.0**-40  # what makes a bounding circle's rounded radius hold every corner
CIRCLES, BOXES, DIRECTIONS, EXACT = "bounding circles", "AABB", "shared directions", "filtered exact"


class SplitPolygon:
    """Convex pieces that are one shape, where only the pieces are known: as much of a shape as the models ask for."""

    radius = 0.0
    core_is_point = False

    def __init__(self, pieces: Sequence[Shape]) -> None:
        self.pieces = pieces
        self.core = tuple(chain.from_iterable(p.core for p in pieces))
        boxes = [p.bounds for p in pieces]
        self.bounds = (*(min(b[i] for b in boxes) for i in (0, 1)), *(max(b[i] for b in boxes) for i in (2, 3)))
        self.max_coordinate = max(p.max_coordinate for p in pieces)
        self.is_upright_box = self.is_convex = False

    def outline(self) -> Shape:
        """The one polygon again: the pieces' edges, cut where a corner lies on them, without those that two share."""
        places = list(dict.fromkeys(self.core))
        _, at = to_int_points(places)
        edges: set[tuple[int, int]] = set()
        for p, q in (edge for piece in self.pieces for edge in edges_of([places.index(v) for v in piece.core])):
            (px, py), (qx, qy) = at[p], at[q]
            dx, dy = qx - px, qy - py
            along = {i: dx * (x - px) + dy * (y - py) for i, (x, y) in enumerate(at) if dx * (y - py) == dy * (x - px)}
            stops = sorted((i for i in along if along[p] <= along[i] <= along[q]), key=along.__getitem__)
            edges.update(pairwise(stops))
        after = dict(edge for edge in edges if edge[::-1] not in edges)
        ring = [min(after)]
        while after[ring[-1]] != ring[0]:
            ring.append(after[ring[-1]])
        return Polygon([places[i] for i in ring])

    @property
    def integers(self) -> tuple[int, list[IntPoint], int]:
        """(k, core, 0) as integers in units of 2**-k."""
        return (*to_int_points(self.core), 0)


AnyShape = Shape | SplitPolygon


def convex_parts(body: AnyShape) -> Sequence[Shape]:
    """The convex parts."""
    return body.pieces if isinstance(body, SplitPolygon) else parts(body)


def exact_relation(a: AnyShape, b: AnyShape) -> Relation:
    """The relation by integers alone, without a filter."""
    return max(relate_integers(*aligned(p, q)[:3]) for p in convex_parts(a) for q in convex_parts(b))


class Model(NamedTuple):
    """A way to tell pairs, and how many axes it looks at for the largest of them.

    `kind`: one of those above, or a format's name; `directions`: the fixed ones of DIRECTIONS, as any (x, y);
    `after_boxes`: whether it follows a test of the bounding boxes, whose two axes then count among its own.
    """

    kind: str
    axes: int
    directions: tuple[Vec, ...] = ()
    after_boxes: bool = False

    @property
    def test(self) -> str:
        """What its own test is called in words, without what runs first."""
        if self.kind == DIRECTIONS:
            return f"ranges on {len(self.directions)} directions"
        return f"SAT, {self.kind}" if self.kind in FORMATS else self.kind

    @property
    def name(self) -> str:
        """What it is called in words."""
        return f"{BOXES}, then {self.test}" if self.after_boxes else self.test

    def sure(self, a: AnyShape, b: AnyShape) -> Relation | None:
        """The relation it gives in every order of its operations; None where rounding can decide."""
        if self.kind == EXACT:
            return max(relate(p, q) for p in convex_parts(a) for q in convex_parts(b))
        if self.kind == BOXES:
            return certify_boxes(a, b)
        if self.kind == CIRCLES:
            return certify_bounding_circles(a, b)
        if self.kind == DIRECTIONS:
            return certify_directions(a, b, self.directions)
        return certify_sat(a, b, FORMATS[self.kind])


MAX_DIRECTIONS = 8
PARALLEL_ANGLE = 2.0**-20  # radians: what is taken for one direction, to be proven or refused afterwards


def shared_directions(bodies: Iterable[AnyShape]) -> tuple[Vec, ...]:
    """The few directions of all normals, the larger part of each from a half to one; none where there are too many.

    Each time the least that is left, so that they do not depend on the order of shapes and corners.
    """
    left = set()
    for ring in (piece.core for body in bodies for piece in convex_parts(body)):
        for (px, py), (qx, qy) in edges_of(ring):
            nx, ny = qy - py, px - qx
            size = max(abs(nx), abs(ny))
            if not 0 < size < inf:  # one corner only, of a circle, has no edge either
                return ()
            scale = copysign(1.0, nx or ny)
            left.add(Vec(*(ldexp(scale * c, -frexp(size)[1]) + 0.0 for c in (nx, ny))))
    found: list[Vec] = []
    while left:
        if len(found) == MAX_DIRECTIONS:
            return ()
        found.append(n := min(left))
        left = {m for m in left if abs(n.x * m.y - n.y * m.x) > PARALLEL_ANGLE}
    return tuple(found)


def candidates(
    axes: int, directions: tuple[Vec, ...], only_circles: bool, alone: Collection[str] | None = None
) -> tuple[Model, ...]:
    """The candidate models, from the fewest axes to the most, and the plainest numbers first.

    `alone`: None for given pairs.  For all pairs of a batch, whose bounding boxes are compared first: the kinds that
    are looked at without the boxes too, as they have fewer axes; every other model follows the boxes.
    """
    found = [] if only_circles else [Model(CIRCLES, 1)]
    found.append(Model(BOXES, 2))
    upright = all(0.0 in n for n in directions)
    if not upright and 2 <= len(directions) < axes:
        found.append(Model(DIRECTIONS, len(directions), directions))
    found += [Model(kind, axes) for kind in (*FORMATS, EXACT)]
    if alone is not None:
        behind = [m._replace(axes=m.axes + 2, after_boxes=True) for m in found if m.kind != BOXES]
        found = [m for m in found if m.kind == BOXES or m.kind in alone] + behind
    return tuple(sorted(found, key=lambda model: model.axes))


def count_axes(a: AnyShape, b: AnyShape) -> int:
    """How many axes SAT looks at: every edge of both, a circle's to the nearest corner, for every pair of parts."""
    return sum(_count_convex_axes(p, q) for p in convex_parts(a) for q in convex_parts(b))


def _count_convex_axes(a: Shape, b: Shape) -> int:
    edges = sum(0 if s.core_is_point else len(s.core) for s in (a, b))
    return edges + (a.core_is_point or b.core_is_point)


def certify_boxes(a: AnyShape, b: AnyShape) -> Relation | None:
    """By the bounding boxes: comparisons alone, which round nothing; the sides of a circle's box may be rounded."""
    outer, inner = (_compare_boxes(*(_bounding_box(s, way) for s in (a, b))) for way in (inf, -inf))
    return relation_of_sign(outer) if outer == inner else None


def _compare_boxes(a: tuple[float, ...], b: tuple[float, ...]) -> int:
    """1 if the boxes are apart, 0 if they touch, -1 if they overlap: no difference, which could vanish."""
    (ax0, ay0, ax1, ay1), (bx0, by0, bx1, by1) = a, b
    if ax1 < bx0 or bx1 < ax0 or ay1 < by0 or by1 < ay0:
        return 1
    return 0 if ax1 == bx0 or bx1 == ax0 or ay1 == by0 or by1 == ay0 else -1


def _bounding_box(shape: AnyShape, way: float) -> tuple[float, ...]:
    """The bounding box; a circle's sides that are rounded are moved one float outwards (inf) or inwards (-inf)."""
    if not shape.core_is_point:
        return shape.bounds
    sides = []
    for out in (-1.0, 1.0):
        for c in shape.core[0]:
            side = c + out * shape.radius
            exact = isfinite(side) and Fraction(side) == Fraction(c) + Fraction(out * shape.radius)
            sides.append(side if exact else nextafter(side, out * way))
    return tuple(sides)


Disc = tuple[float, float, float]


def bounding_circle(shape: AnyShape) -> Disc:
    """x, y and radius of a circle around the shape; the radius is infinite or 0 where floats cannot tell it.

    Its center is that of the bounding box, and it reaches the farthest corner.
    """
    return _disc(shape, WIDENING)


def _disc(shape: AnyShape, wider: float) -> Disc:
    if shape.core_is_point:
        return (*shape.core[0], shape.radius)
    x0, y0, x1, y1 = shape.bounds
    x, y = x0 / 2 + x1 / 2, y0 / 2 + y1 / 2
    square = max((px - x) * (px - x) + (py - y) * (py - y) for px, py in shape.core)
    # under TINY bits are lost, and beyond HUGE they overflow
    return x, y, sqrt(square) * wider if TINY < square < HUGE else 0.0


def certify_bounding_circles(a: AnyShape, b: AnyShape) -> Relation | None:
    """By circles around the shapes, whether their radii are made to hold every corner or only rounded."""
    held, bare = (certify_circles(_disc(a, wider), _disc(b, wider), FLOAT64) for wider in (WIDENING, 1.0))
    return held if held is bare else None


def certify_circles(a: Disc, b: Disc, form: Format) -> Relation | None:
    """By the squares of the distance and of the sum of radii, and by ranges on the line through the centers."""
    if not (a[2] and b[2] and all(map(isfinite, (*a, *b)))):
        return None
    _, (ax, ay, ar, bx, by, br) = to_integers((*a, *b))
    moved = _coordinate_error((ax, ay, bx, by), (*a, *b), form)
    distance, reach = (ax - bx) ** 2 + (ay - by) ** 2, (ar + br) ** 2
    gap = sign(distance - reach)
    size = max(abs(a[0] - b[0]), abs(a[1] - b[1]), a[2] + b[2])
    room = Fraction(12 * (distance + reach), 1 << form.bits) + 5 * moved * (abs(ax - bx) + abs(ay - by)) + 9 * moved**2
    sure = form.least < size and max(map(abs, (*a, *b))) < form.most and abs(distance - reach) > room
    far_off = Fraction(RANGE_ROUNDINGS * (max(map(abs, (ax, ay, bx, by))) + max(ar, br)), 1 << form.bits)
    radii = ar + br
    if sure and (distance > (radii + far_off) ** 2 or (radii > far_off and distance < (radii - far_off) ** 2)):
        return relation_of_sign(gap)
    for formula in (rounding.circle_ranges,) if sure else (rounding.circle_ranges, rounding.circles):
        arithmetic = Exact(form)
        formula(arithmetic, *([arithmetic.held(Fraction(c)) for c in disc] for disc in (a, b)))
        if not arithmetic.exact:
            return None
    return relation_of_sign(gap)


def relation_of_sign(gap: int) -> Relation:
    return APART if gap > 0 else OVERLAPPING if gap < 0 else TOUCHING


def certify_directions(a: AnyShape, b: AnyShape, directions: Sequence[Vec]) -> Relation | None:
    """By ranges of x*nx + y*ny on given directions, each a sum of two products.

    A landing is off by 4 roundings of m M (m the larger part of the direction), a gap of two by 8; asked: 16.
    """
    if a.core_is_point or b.core_is_point:
        return None
    p, q, *_ = aligned(a, b)
    trusted = FLOAT64.least < max(a.max_coordinate, b.max_coordinate) < FLOAT64.most
    found = []
    for n in directions:
        _, (mx, my) = to_integers(n)
        on_p, on_q = ([mx * x + my * y for x, y in ring] for ring in (p, q))
        gap = max(min(on_p) - max(on_q), min(on_q) - max(on_p))
        room = LANDING_ROUNDINGS * max(abs(mx), abs(my)) * max(abs(c) for ring in (p, q) for v in ring for c in v)
        sure = (trusted and abs(gap) << 53 > room) or _projects_exactly((*a.core, *b.core), n)
        if sure and gap > 0:
            return APART
        found.append(sign(gap) if sure else None)
    return None if None in found else relation_of_sign(max(gap for gap in found if gap is not None))


def _projects_exactly(corners: Iterable[Vec], direction: Vec) -> bool:
    arithmetic = Exact(FLOAT64)
    normal = Fraction(direction[0]), Fraction(direction[1])
    for x, y in corners:
        rounding.landing(arithmetic, normal, (Fraction(x), Fraction(y)))
    return arithmetic.exact


def certify_sat(a: AnyShape, b: AnyShape, form: Format) -> Relation | None:
    """By every axis of every pair of convex parts, in a float format without a filter."""
    found = [certify_convex_sat(p, q, form) for p in convex_parts(a) for q in convex_parts(b)]
    if OVERLAPPING in found:
        return OVERLAPPING
    return None if None in found else max(r for r in found if r is not None)


def certify_convex_sat(a: Shape, b: Shape, form: Format) -> Relation | None:
    """The same for two convex shapes."""
    if a.core_is_point and b.core_is_point:
        return certify_circles((*a.core[0], a.radius), (*b.core[0], b.radius), form)
    if a.core_is_point or b.core_is_point:
        return _certify_circle_polygon(a, b, form) if a.core_is_point else _certify_circle_polygon(b, a, form)
    bounded = _certify_polygons(a, b, form)
    if bounded is None and _rounds_nothing(a, b, form):
        return relate(a, b)  # what SAT gives where nothing is rounded
    return bounded


def _rounds_nothing(a: Shape, b: Shape, form: Format) -> bool:
    arithmetic = Exact(form)
    p, q = ([(arithmetic.held(Fraction(x)), arithmetic.held(Fraction(y))) for x, y in s.core] for s in (a, b))
    return all(arithmetic.exact for _ in rounding.polygons(arithmetic, p, q))


def _certify_polygons(a: Shape, b: Shape, form: Format) -> Relation | None:
    numbers = [c for v in (*a.core, *b.core) for c in v]
    p, q, *_ = aligned(a, b)
    flat = [c for ring in (p, q) for v in ring for c in v]
    reach = max(map(abs, flat))
    if not form.least < max(a.max_coordinate, b.max_coordinate) < form.most:
        return None
    apart = [max(r[d] for r in (*p, *q)) - min(r[d] for r in (*p, *q)) for d in (0, 1)]
    moved = _coordinate_error(flat, numbers, form)
    surely_over = True
    for ring, other, own in (p, q, a), (q, p, b):
        for ((px, py), (qx, qy)), ((fx, fy), (gx, gy)) in zip(edges_of(ring), edges_of(own.core), strict=True):
            nx, ny = qy - py, px - qx
            clears = min(nx * x + ny * y for x, y in other) - nx * px - ny * py
            span = max(abs(nx), abs(ny))
            room = SAT_ROUNDINGS * (span + 2 * moved) * (reach + moved) / (1 << form.bits)
            room += 4 * moved * (span + max(apart)) + 8 * moved * moved
            sure = abs(clears) > room and max(abs(fx - gx), abs(fy - gy)) > form.least
            if sure and clears > 0:
                return APART
            surely_over = surely_over and sure
    return OVERLAPPING if surely_over else None


def _certify_circle_polygon(circle: Shape, polygon: Shape, form: Format) -> Relation | None:
    numbers = (*circle.core[0], circle.radius, *chain.from_iterable(polygon.core))
    (center,), ring, r, _ = aligned(circle, polygon)
    cx, cy = circle.core[0]
    far = max(max(abs(x - cx), abs(y - cy)) for x, y in polygon.core)
    least = min(max(abs(x - u), abs(y - v)) for (x, y), (u, v) in edges_of(polygon.core))
    moved = _coordinate_error((*center, *chain.from_iterable(ring)), numbers, form)
    most = max(far, *map(abs, numbers))
    if not (form.least + 2 * most * bool(moved) * 2.0**-form.bits < least and most < form.most):
        return None
    at = [(x - center[0], y - center[1]) for x, y in ring]
    widest = max(abs(c) for v in at for c in v)
    inside, outside, nearest = True, False, None
    for (px, py), (qx, qy) in edges_of(at):
        dx, dy = qx - px, qy - py
        turn, along, square = px * dy - py * dx, -(px * dx + py * dy), dx * dx + dy * dy
        long = abs(dx) + abs(dy)
        size = TURN_ROUNDINGS * (widest + 2 * moved) * (long + 4 * moved) / (1 << form.bits)
        size += 2 * moved * long + 4 * moved * widest + 8 * moved**2
        inside = inside and turn > size
        outside = outside or -turn > size
        if along <= 0 or along >= square:
            x, y = (px, py) if along <= 0 else (qx, qy)
            away = Fraction(x * x + y * y)
        else:
            away = Fraction(turn * turn, square)
        nearest = away if nearest is None else min(nearest, away)
    assert nearest is not None
    room = (DISTANCE_ROUNDINGS * (widest + 2 * moved) ** 2 + 8 * r * r) / (1 << form.bits) + 9 * moved * (
        widest + moved
    )
    far_off = Fraction(RANGE_ROUNDINGS * (max(abs(c) for v in (center, *ring) for c in v) + r), 1 << form.bits)
    deep = r > far_off and nearest < (r - far_off) ** 2
    if (inside and (r > far_off or nearest > (far_off - r) ** 2)) or (deep and nearest < r * r - room):
        return OVERLAPPING
    return APART if outside and nearest > max(r * r + room, (r + far_off) ** 2) else None


def _coordinate_error(coordinates: Iterable[int], numbers: Iterable[float], form: Format) -> Fraction:
    """By how much the format moves a coordinate at most, in the integers' unit; 0 where it holds all numbers."""
    return Fraction(0) if holds_all(numbers, form) else Fraction(max(map(abs, coordinates)), 1 << form.bits)


def edges_of(ring: Sequence[T]) -> Iterable[tuple[T, T]]:
    """The pairs of neighbouring corners of an outline, the last and the first among them."""
    return zip(ring, [*ring[1:], ring[0]], strict=True)


def holds_all(numbers: Iterable[float], form: Format) -> bool:
    """Does the format hold them all as they are?"""
    return form is FLOAT64 or all(holds(Fraction(c), form) for c in numbers)
