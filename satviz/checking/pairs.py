"""The pairs that a function is asked about, the smallest first.

The functions that make one shape give it whole coordinates from 0 to `size`.
"""

from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache
from itertools import product
from math import atan2
from random import Random
from typing import NamedTuple

from ..engine.geometry import InvalidShape, Relation, Vec
from ..engine.relate import relate
from ..engine.shapes import Circle, Polygon, Shape
from ..scenes.failing import FAILURE_CASES, REFUSED
from ..scenes.failing.move_space import convex_hull
from ..scenes.shape_tools import box, translated

KINDS = {
    "boxes": "two upright boxes",
    "convex": "two convex polygons",
    "concave": "outlines with dents",
    "circles": "two circles",
    "circle and polygon": "a circle and a convex polygon",
    "repeated": "a vertex that is listed twice",
}
BOXES, CONVEX, CONCAVE, CIRCLES, CIRCLE_AND_POLYGON, REPEATED_VERTEX = KINDS
KNOWN_SCENES, PAST_ONE_EDGE = "scenes of known mistakes", "just past one edge"
DEFAULT_KINDS = BOXES, CONVEX
SIZES = (3, 4, 6, 8, 12, 20, 60, 400)  # sizes of the grids of whole numbers on which the pairs lie, smallest first
PAIRS_PER_SIZE = 24  # pairs of the kinds with many relative positions; the other kinds have a third as many
MAX_CORNERS = 8
ONE_EDGE_SIZE = 60  # size of shapes that lie just past one edge: hardly any other edge shows the gap

Maker = Callable[[Random, int], Shape]


class CheckPair(NamedTuple):
    """A pair that a function is asked about: two shapes, their kind, and the group of pairs that they belong to."""

    a: Shape
    b: Shape
    kind: str
    group: str


def kind_of_pair(a: Shape, b: Shape) -> str:
    """Return the kind of a pair of shapes, a key of KINDS.

    A concave outline decides before a circle, and a vertex that is listed twice before upright boxes.
    """
    circles = [isinstance(shape, Circle) for shape in (a, b)]
    if all(circles):
        return CIRCLES
    if not (a.is_convex and b.is_convex):
        return CONCAVE
    if any(circles):
        return CIRCLE_AND_POLYGON
    if any(
        len(shape.vertices) > len(shape.core) and len(set(shape.vertices)) < len(shape.vertices) for shape in (a, b)
    ):
        return REPEATED_VERTEX
    return BOXES if a.is_upright_box and b.is_upright_box else CONVEX


@lru_cache(maxsize=16)
def whole_number_pairs(kinds: tuple[str, ...], seed: int) -> tuple[CheckPair, ...]:
    """Return the pairs that judge a function, in order: small boxes, small shapes, failing cases, seeded pairs.

    The last ones lie just past one edge.  `kinds`: keys of KINDS; `seed`: of the random numbers.
    """
    random = Random(seed)
    found = [*_small_boxes()] if BOXES in kinds else []
    small = [pair for size in SIZES[:3] for pair in _seeded(kinds, random, size, "small shapes")]
    found += sorted(small, key=_weight)
    for case in FAILURE_CASES:
        if case.how == REFUSED:
            continue
        a, b = case.shapes
        if not _is_whole(a, b):
            a, b = _in_tenths(a), _in_tenths(b)
        if kind_of_pair(a, b) in kinds and _is_whole(a, b):
            found.append(CheckPair(a, b, kind_of_pair(a, b), KNOWN_SCENES))
    for size in SIZES[3:]:
        found += _seeded(kinds, random, size, f"coordinates up to {size}")
    return (*found, *_past_one_edge(random)) if CONVEX in kinds else tuple(found)


def _weight(pair: CheckPair) -> tuple[int, float]:
    """Return (number of corners, largest coordinate) of a pair, by which small pairs come first."""
    return sum(len(s.vertices) or 1 for s in pair[:2]), max(s.max_coordinate for s in pair[:2])


def _in_tenths(shape: Shape) -> Shape:
    """Return the shape ten times as large; a multiple of 0.1, up to rounding, becomes a whole number."""

    def ten(value: float) -> float:
        """Return ten times the value, whole where it is nearly so."""
        return float(round(10 * value)) if abs(10 * value - round(10 * value)) < 1e-9 else 10 * value

    if isinstance(shape, Circle):
        return Circle(tuple(map(ten, shape.center)), ten(shape.radius))
    return Polygon([tuple(map(ten, point)) for point in shape.vertices])


def _is_whole(*shapes: Shape) -> bool:
    """Return whether all numbers of the shapes are whole."""
    return all(
        x == int(x) for shape in shapes for point in (*shape.vertices, *shape.core) for x in (*point, shape.radius)
    )


def _small_boxes() -> Iterator[CheckPair]:
    """Yield upright boxes: beside each other, touching, overlapping, one inside the other, equal."""
    for (w, h), (v, g) in (((2, 2), (1, 1)), ((1, 1), (2, 1)), ((4, 1), (1, 3))):
        for x, y in product(range(-2, w + 2), range(-2, h + 2)):
            yield CheckPair(box(0, 0, w, h), box(x, y, x + v, y + g), BOXES, "small boxes")
    inside = box(1, 1, 4, 4)
    for other in box(2, 2, 3, 3), inside, box(0, 0, 5, 5), box(1, 2, 4, 3):
        yield CheckPair(inside, other, BOXES, "small boxes")


def _seeded(kinds: Sequence[str], random: Random, size: int, group: str) -> Iterator[CheckPair]:
    """Yield random pairs in whole numbers up to `size`, with B placed in each of the ways of `_placed`."""
    for kind in kinds:
        makers = MAKERS[kind]
        if random.random() >= 0.7 and kind == CONCAVE:
            makers = _concave, _concave
        if kind == REPEATED_VERTEX and size < 6:
            makers = _repeated, _box
        for i in range(PAIRS_PER_SIZE if kind in (CONVEX, CIRCLE_AND_POLYGON, CONCAVE) else PAIRS_PER_SIZE // 3):
            a, b = (make(random, size) for make in makers)
            if i % 2 and kind in (CIRCLES, CIRCLE_AND_POLYGON):
                a, b = b, a
            b = _placed(a, b, random, size, i % 4)
            yield CheckPair(a, b, kind_of_pair(a, b), group)


def _past_one_edge(random: Random) -> Iterator[CheckPair]:
    """Yield convex pairs just apart, where hardly any normal but that of A's or B's first or last edge has a gap."""
    for of_a, index in tuple(product((True, False), (0, -1))) * 4:
        a, b = (_convex(random, ONE_EDGE_SIZE) for _ in "ab")
        ring = (a if of_a else b).vertices
        p, q = ring[index], ring[(index + 1) % len(ring)]
        n = Vec(q.y - p.y, p.x - q.x)
        inward = sum(n.x * (v.x - p.x) + n.y * (v.y - p.y) for v in ring) > 0
        n = Vec(-n.x, -n.y) if inward is of_a else n
        step = max((Vec(2, 0), Vec(-2, 0), Vec(0, 2), Vec(0, -2)), key=lambda way: way.x * n.x + way.y * n.y)
        middle = Vec(round((p.x + q.x) / 2), round((p.y + q.y) / 2))  # rounded by less than the step along n
        s = middle if of_a else _support(a, n, random)
        t = _support(b, Vec(-n.x, -n.y), random) if of_a else middle
        beside = translated(b, Vec(s.x - t.x + step.x, s.y - t.y + step.y))
        yield CheckPair(a, beside, kind_of_pair(a, beside), PAST_ONE_EDGE)


def _placed(a: Shape, b: Shape, random: Random, size: int, how: int) -> Shape:
    """Return B moved; `how`: 0 anywhere near A, 1 touching A, 2 one unit beside touching, 3 with its middle in A."""
    if how == 0:
        x, y = (random.randint(-size, size) for _ in range(2))
        return translated(b, Vec(x, y))
    if how == 3:
        (ax, ay), (bx, by) = _middle(a), _middle(b)
        return translated(b, Vec(ax - bx, ay - by))
    beside = _touching(a, b, random)
    if how == 1 and relate(a, beside) is Relation.TOUCHING:
        return beside
    if how == 2 and a.radius + b.radius and random.random() < 0.7:
        return _off_a_corner(a, b, random)
    step = Vec(*random.choice(((1, 0), (-1, 0), (0, 1), (0, -1))))
    return translated(beside, step)


def _touching(a: Shape, b: Shape, random: Random) -> Shape:
    """Return B moved so that a support point of B lies on the opposite support point of A; both have whole numbers.

    The direction is an edge normal of A or any other, so a vertex meets a vertex or an edge lies along an edge.
    A circle's support points are those to the right, up, left and down, and in the directions of a 3-4-5 triangle.
    """
    edges = [
        Vec(q.y - p.y, p.x - q.x)
        for ring in (a.core, b.core)
        for p, q in zip(ring, (*ring[1:], ring[0]))
        if len(ring) > 1 and random.random() < 0.5
    ]
    n = random.choice([*edges, Vec(1.0, 0.0), Vec(0.0, -1.0), Vec(-2.0, 1.0), Vec(1.0, 3.0)])
    if a.radius or b.radius:
        fives = a.radius % 5 == b.radius % 5 == 0
        n = random.choice([Vec(1.0, 0.0), Vec(0.0, 1.0), Vec(-1.0, 0.0), *([Vec(0.6, 0.8), Vec(-0.8, 0.6)] * fives)])
    p, q = _support(a, n, random), _support(b, Vec(-n.x, -n.y), random)
    return translated(b, Vec(p.x - q.x, p.y - q.y))


def _off_a_corner(a: Shape, b: Shape, random: Random) -> Shape:
    """Return B moved so that its core lies diagonally off a point of A's core, about as far as the radii reach."""
    p, q = random.choice(a.core), random.choice(b.core)
    x, y = (random.choice((-1, 1)) * round((a.radius + b.radius) * random.uniform(0.6, 0.85)) for _ in range(2))
    return translated(b, Vec(p.x + x - q.x, p.y + y - q.y))


def _support(shape: Shape, n: Vec, random: Random) -> Vec:
    """Return one of the furthest points of a shape along n (a unit vector for a circle), rounded for a circle."""
    furthest = max(p.x * n.x + p.y * n.y for p in shape.core)
    point = random.choice([p for p in shape.core if p.x * n.x + p.y * n.y == furthest])
    return Vec(point.x + round(shape.radius * n.x), point.y + round(shape.radius * n.y))


def _middle(shape: Shape) -> Vec:
    """Return a point of whole numbers near the middle of a shape's core."""
    return Vec(*(float(round(sum(axis) / len(shape.core))) for axis in zip(*shape.core)))


def _box(random: Random, size: int) -> Polygon:
    """Return an upright box from (0, 0), with whole sides up to `size`."""
    w, h = (random.randint(1, size) for _ in range(2))
    return box(0, 0, w, h)


def _convex(random: Random, size: int) -> Polygon:
    """Return a convex polygon of 3 to MAX_CORNERS corners that begins anywhere, in either order."""
    most = random.choice((3, 3, 4, 4, 5, 6, MAX_CORNERS))
    while True:
        points = [Vec(float(random.randint(0, size)), float(random.randint(0, size))) for _ in range(most + 1)]
        hull = list(convex_hull(points))
        if len(hull) > most:
            hull.pop(random.randrange(len(hull)))
        if len(hull) >= 3:
            return _in_any_order(hull, random)


def _in_any_order(ring: list[Vec], random: Random) -> Polygon:
    """Return the polygon of a ring that begins at any of its corners, in either order."""
    start = random.randrange(len(ring))
    ring = ring[start:] + ring[:start]
    return Polygon(ring[::-1] if random.random() < 0.4 else ring)


def _concave(random: Random, size: int) -> Polygon:
    """Return a concave polygon of 4 to MAX_CORNERS corners: points in the order of their angles about the middle."""
    while True:
        points = {
            Vec(float(random.randint(0, size)), float(random.randint(0, size))) for _ in range(random.randint(4, 8))
        }
        middle = Vec(size / 2 + 0.25, size / 2 + 0.125)
        ring = sorted(points, key=lambda p: atan2(p.y - middle.y, p.x - middle.x))
        try:
            shape = _in_any_order(ring, random)
        except InvalidShape:
            continue
        if not shape.is_convex:
            return shape


def _circle(random: Random, size: int) -> Circle:
    """Return a circle about a point of whole numbers, often with a radius that 5 divides, for 3-4-5 triangles."""
    radius = random.randint(1, max(1, size // 2))
    if size >= 6 and random.random() < 0.5:
        radius = 5 * max(1, radius // 5)
    return Circle((random.randint(0, size), random.randint(0, size)), radius)


def _repeated(random: Random, size: int) -> Polygon:
    """Return a convex polygon with one vertex listed twice."""
    ring = list(_convex(random, size).vertices)
    i = random.randrange(len(ring))
    return Polygon([*ring[: i + 1], *ring[i:]])


MAKERS: dict[str, tuple[Maker, Maker]] = {
    BOXES: (_box, _box),
    CONVEX: (_convex, _convex),
    CONCAVE: (_concave, _convex),
    CIRCLES: (_circle, _circle),
    CIRCLE_AND_POLYGON: (_circle, _convex),
    REPEATED_VERTEX: (_repeated, _convex),
}


def near_pairs(kinds: Sequence[str], seed: int, count: int) -> Iterator[CheckPair]:
    """Yield pairs that floats can hardly tell: touching in whole numbers, then scaled and moved by rounded numbers.

    They measure where a function's floats fail; no answer for them counts as wrong.
    """
    random = Random(seed + 1)
    kind = CONVEX if CONVEX in kinds else kinds[0]
    for i in range(count):
        a, b = (make(random, 8) for make in MAKERS[kind])
        beside = _touching(a, b, random)
        scale, away = random.uniform(0.1, 3.0), Vec(random.uniform(-50, 50), random.uniform(-50, 50))
        nudge = 2.0 ** -random.randint(20, 53) * random.choice((-1, 1)) * (i % 3 > 0)
        shapes = _moved(a, scale, away), _moved(beside, scale, Vec(away.x + nudge, away.y))
        yield CheckPair(*shapes, kind, "nearly touching, in rounded numbers")


def _moved(shape: Shape, scale: float, move: Vec) -> Shape:
    """Return the shape scaled about the origin and then moved, in rounded numbers."""
    if isinstance(shape, Circle):
        x, y = shape.center
        return Circle((x * scale + move.x, y * scale + move.y), shape.radius * scale)
    return Polygon([(x * scale + move.x, y * scale + move.y) for x, y in shape.vertices])
