"""Pairs of shapes of every kind that occurs in practice, from a seed or drawn (and shrunk) by hypothesis.

A kind is a function from a Random to a pair.  Most are made about one point: each shape
is drawn in whole numbers, moved until it touches the origin from its own side, and only
then scaled by a power of two of its own.  So a contact is exact whatever the sizes.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import partial
from itertools import pairwise
from random import Random

from hypothesis import reject
from hypothesis import strategies as st

from satviz.engine.geometry import InvalidShape
from satviz.engine.shapes import Circle, Polygon, Shape

Point = tuple[float, float]
Ring = list[Point]
Whole = list[tuple[int, int]]
Pair = tuple[Shape, Shape]

TRIPLES = (3, 4, 5), (5, 12, 13), (8, 15, 17), (20, 21, 29)
OFFSETS = 1.0, 1e2, 1e4, 1e6, 1e8
CONTACTS = (
    "far apart",
    "an ulp apart",
    "vertex on vertex",
    "vertex on edge",
    "edge on edge",
    "an ulp deep",
    "deep",
    "contained",
    "kissing from inside",
)
INNER = CONTACTS[-2:]
QUARTERS = (1, 0), (0, 1), (-1, 0), (0, -1)


class NotConvex(Exception):
    """Raised when rounding made a polygon concave; another one is drawn then."""


def pairs(seed: int, count: int, kinds: Sequence[str] = ()) -> Iterator[tuple[str, Shape, Shape]]:
    """Yield `count` times (kind, a, b), the kinds in turn; a pair that satviz refuses to build is replaced."""
    rng = Random(seed)
    names = kinds or list(KINDS)
    for i in range(count):
        yield (names[i % len(names)], *drawn(rng, names[i % len(names)]))


def drawn(rng: Random, kind: str) -> Pair:
    """Return one pair of a kind, either shape first."""
    while True:
        try:
            a, b = KINDS[kind](rng)
            return (a, b) if rng.random() < 0.5 else (b, a)
        except (InvalidShape, NotConvex, OverflowError):
            continue


@st.composite
def some_pairs(draw: st.DrawFn) -> Pair:
    """Return a pair from hypothesis: rings drawn corner by corner and brought together, or any kind."""
    rng = draw(st.randoms(use_true_random=False))
    kind = draw(st.sampled_from(["", "", *KINDS]))
    try:
        if kind:
            return KINDS[kind](rng)
        rings = [solid(draw(st.lists(st.tuples(*[st.integers(-99, 99)] * 2), min_size=3, max_size=8))) for _ in "ab"]
        powers = draw(st.tuples(st.integers(-60, 0), st.just(0)))
        _, _, nx, ny = edge_of(draw(st.sampled_from(rings)), rng)
        return in_contact(rng, rings, draw(st.sampled_from(CONTACTS)), powers, (nx, ny, 0))
    except (InvalidShape, NotConvex, OverflowError):
        reject()


def convex(points: Sequence[Sequence[float]]) -> Polygon:
    """Return a Polygon; NotConvex if it is concave after rounding."""
    return _still_convex(Polygon(points))


def _still_convex(shape: Shape) -> Shape:
    """Return the shape; NotConvex for a concave polygon."""
    if isinstance(shape, Polygon) and not shape.is_convex:
        raise NotConvex
    return shape


def nudged(value: float, steps: int) -> float:
    """Return the float that is `steps` floats above (below when negative)."""
    for _ in range(abs(steps)):
        value = math.nextafter(value, math.copysign(math.inf, steps))
    return value


SIZES = [2.0**e for e in (-1060, -900, -537, -514, -500, -300, -40, 0, 40, 300, 470, 510, 900, 1020)]


def nearly_straight(rng: Random, size: float) -> list[tuple[float, float]]:
    """Return three points close to one line, with full mantissas or on a small grid."""
    if rng.random() < 0.3:
        x, y, dx, dy, t = (rng.randint(-9, 9) for _ in range(5))
        return [(u * (size / 128), v * (size / 128)) for u, v in ((x, y), (x + dx, y + dy), (x + t * dx, y + t * dy))]
    px, py, qx, qy = (rng.uniform(-1, 1) * size for _ in range(4))
    t = rng.uniform(-1, 2)
    near = [nudged(c, rng.randint(-1, 1)) for c in (px + (qx - px) * t, py + (qy - py) * t)]
    points = [(px, py), (qx, qy), tuple(near)]
    rng.shuffle(points)
    return points


# -- whole rings -----------------------------------------------------------------------------------


def hull(points: Sequence[Point]) -> Ring:
    """Return the strict convex hull of grid points, counter-clockwise; their differences and products are exact."""
    ordered = sorted(set(points))

    def half(run: Sequence[Point]) -> Ring:
        """Return the hull on the right of the way through sorted points, without its last point."""
        chain: Ring = []
        for r in run:
            while len(chain) > 1 and _turn(chain[-2], chain[-1], r) <= 0:
                chain.pop()
            chain.append(r)
        return chain[:-1]

    return half(ordered) + half(ordered[::-1])


def solid(points: Sequence[tuple[int, int]]) -> Whole:
    """Return the hull of points; NotConvex if it has no area."""
    ring = hull(points)
    if len(ring) < 3:
        raise NotConvex
    return ring


def few_corners(rng: Random, size: int = 0) -> Whole:
    """Return the hull of 3 to 12 random points."""
    n, size = rng.randint(3, 12), size or rng.choice((3, 40, 40, 1000, 2**20))
    return solid([(rng.randint(-size, size), rng.randint(-size, size)) for _ in range(n)])


def many_corners(rng: Random, most: int = 200) -> Whole:
    """Return a ring of 3 to `most` corners: random steps that add up to 0, sorted by direction."""
    n = rng.choice([v for v in (3, 4, 5, 6, 8, 12, 16, 24, 48, 100, 200) if v <= most])
    size = 40 * n * n

    def steps() -> list[int]:
        """Return n integers that add up to 0: up one chain of sorted numbers, down another."""
        places = sorted(rng.randint(-size, size) for _ in range(n))
        up, down = [places[0]], [places[0]]
        for place in places[1:-1]:
            rng.choice((up, down)).append(place)
        up.append(places[-1])
        down.append(places[-1])
        return [q - p for p, q in pairwise(up)] + [p - q for p, q in pairwise(down)]

    dxs, dys = steps(), steps()
    rng.shuffle(dys)
    return _walked(list(zip(dxs, dys, strict=True)))


def zonotope(rng: Random) -> Whole:
    """Return a ring whose edges each have an exactly opposite one: a parallelogram, a hexagon, ..."""
    size = rng.choice((3, 30, 2**20))
    halves = [(rng.randint(-size, size), rng.randint(-size, size)) for _ in range(rng.choice((2, 2, 3, 4, 8)))]
    return _walked(halves + [(-x, -y) for x, y in halves])


def _walked(steps: Sequence[tuple[int, int]]) -> Whole:
    """Return the convex ring with these edges."""
    x = y = 0
    ring = []
    for dx, dy in sorted(steps, key=lambda step: math.atan2(step[1], step[0])):
        ring.append((x, y))
        x, y = x + dx, y + dy
    return solid(ring)


def needle(rng: Random) -> Whole:
    """Return a long, very narrow ring: a triangle or a rhomb of area about 1."""
    length = 2 ** rng.randint(3, 24)
    x, y = rng.randint(length // 2, length), rng.randint(-length, length)
    t = rng.randint(1, 7)
    off = rng.randint(-1, 1), rng.choice((-1, 1))
    middle = x * t // 8 + off[0], y * t // 8 + off[1]
    ring = [(0, 0), (x, y), middle]
    return solid([*ring, (x - middle[0], y - middle[1])] if rng.random() < 0.5 else ring)


def upright_box(rng: Random) -> Whole:
    """Return a box with sides along x and y."""
    w, h = (rng.choice((rng.randint(1, 9), 2 ** rng.randint(0, 30))) for _ in "wh")
    return [(0, 0), (w, 0), (w, h), (0, h)]


def tilted_box(rng: Random) -> Whole:
    """Return a rotated box."""
    p, q = (1, 1) if rng.random() < 0.2 else (rng.randint(1, 99), rng.randint(-99, 99))
    return solid(spun(upright_box(rng), p, q))


def wild(rng: Random) -> Whole:
    """Return a ring of integer corners of very different magnitudes."""
    ring = [(rng.randint(-99, 99), rng.randint(-99, 99)) for _ in range(rng.randint(3, 6))]
    return solid([(x << k, y << k) for (x, y), k in ((v, rng.choice((0, 0, 3, 17, 30, 45))) for v in ring)])


def notched(rng: Random) -> Whole:
    """Return a concave ring: a convex one with some edges pressed in towards a point inside."""
    ring = [(16 * x, 16 * y) for x, y in few_corners(rng)]
    (px, py), (qx, qy), (rx, ry) = rng.sample(ring, 3)
    middle = (2 * px + qx + rx) // 4, (2 * py + qy + ry) // 4
    found, pressed = [], rng.randrange(len(ring))
    for i, (p, q) in enumerate(zip(ring, [*ring[1:], ring[0]], strict=True)):
        found.append(p)
        if i == pressed or rng.random() < 0.4:
            depth = rng.randint(1, 3)  # quarters of the way
            found.append(tuple(((p[c] + q[c]) // 2 * (4 - depth) + middle[c] * depth) // 4 for c in (0, 1)))
    return found


FAMILIES: dict[str, Callable[[Random], Whole]] = {
    "few corners": few_corners,
    "many corners": many_corners,
    "opposite edges": zonotope,
    "needles": needle,
    "upright boxes": upright_box,
    "tilted boxes": tilted_box,
    "mixed magnitudes": wild,
}


def spun(ring: Sequence[Point], p: int, q: int) -> Ring:
    """Return a ring rotated by the angle of (p, q) and scaled by its length: exact on integers."""
    return [(p * x - q * y, q * x + p * y) for x, y in ring]


def _turn(p: Point, q: Point, r: Point) -> float:
    """Return the orientation determinant of three points."""
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def extreme(ring: Sequence[Point], dx: float, dy: float) -> int:
    """Return which corner lies furthest in a direction."""
    return max(range(len(ring)), key=lambda i: dx * ring[i][0] + dy * ring[i][1])


def edge_of(ring: Sequence[Point], rng: Random) -> tuple[int, int, float, float]:
    """Return the two indices of an edge in the ring, and its outward normal."""
    i = rng.randrange(len(ring))
    j = (i + 1) % len(ring)
    return i, j, ring[j][1] - ring[i][1], ring[i][0] - ring[j][0]


# -- contacts about the origin ---------------------------------------------------------------------


class Facing:
    """A shape that touches the origin and lies where (nx, ny) . (x, y) <= 0: a ring, or the center of a circle."""

    def __init__(self, ring: Sequence[tuple[int, int]], radius: int = 0) -> None:
        self.ring, self.radius = ring, radius

    def moved(self, dx: int, dy: int) -> "Facing":
        """Return the ring or shape moved by (dx, dy)."""
        return Facing([(x + dx, y + dy) for x, y in self.ring], self.radius)

    def scaled(self, power: int) -> tuple[Ring, float]:
        """Return the ring and the radius times 2**power, in floats; NotConvex if that is not exact."""
        ring = [(math.ldexp(x, power), math.ldexp(y, power)) for x, y in self.ring]
        if any(int(math.ldexp(c, -power)) != whole for v, w in zip(ring, self.ring) for c, whole in zip(v, w)):
            raise NotConvex
        return ring, math.ldexp(self.radius, power)


def vertex_facing(ring: Whole, nx: int, ny: int) -> Facing:
    """Return a ring moved so that its furthest corner in a direction is at the origin."""
    x, y = ring[extreme(ring, nx, ny)]
    return Facing([(px - x, py - y) for px, py in ring])


def edge_facing(rng: Random, ring: Whole, nx: int, ny: int) -> Facing:
    """Return a ring moved so that a quarter point of its edge across (nx, ny) is at the origin."""
    top = max(nx * x + ny * y for x, y in ring)
    on_top = [(x, y) for x, y in ring if nx * x + ny * y == top]
    if len(on_top) == 1:
        common = math.gcd(nx, ny)
        dx, dy = -ny // common, nx // common
        (x, y), size = on_top[0], max(max(map(abs, v)) for v in ring)
        long = max(1, size // max(abs(dx), abs(dy)))
        on_top.append((x + dx * long, y + dy * long))
        ring = solid([*ring, on_top[1]])
    (px, py), (qx, qy) = on_top
    quarter = rng.randint(0, 4)
    x, y = px * (4 - quarter) + qx * quarter, py * (4 - quarter) + qy * quarter
    return Facing([(4 * px - x, 4 * py - y) for px, py in ring])


def circle_facing(rng: Random, p: int, q: int, r: int) -> Facing:
    """Return a circle that touches the origin in the direction (p, q) of length r."""
    grow = rng.randint(1, 9)
    return Facing([(-p * grow, -q * grow)], r * grow)


def about_a_point(family: str, rng: Random, contact: str = "") -> Pair:
    """Return a shape of the family (or "circles", or "concave") and one of any, in any contact, at any two sizes."""
    contact = contact or rng.choice(CONTACTS)
    names = [family, family if rng.random() < 0.4 else rng.choice([*FAMILIES, "circles"])]
    rings = [_ring(rng, name) for name in names]
    if len(rings[0]) * len(rings[1]) > 600:
        rings[1] = few_corners(rng)
    inner = contact in INNER
    ratio = rng.choice((3, rng.randint(3, 60)) if inner else (0, rng.randint(0, 8), rng.randint(9, 60)))
    powers = (0, -ratio) if inner or rng.random() < 0.5 else (-ratio, 0)
    pair = in_contact(rng, rings, contact, powers, _direction(rng, rings))
    return pair if family == "concave" else tuple(map(_still_convex, pair))


def tiny_and_huge(rng: Random) -> Pair:
    """Return a huge shape with a corner at an edge of one smaller than its rounding, or the reverse."""
    halves = [(rng.randint(-9, 9), rng.randint(-9, 9)) for _ in range(rng.choice((2, 2, 3)))]
    rings = [_walked(halves + [(-x, -y) for x, y in halves]), few_corners(rng, 40)]
    ratio = rng.randint(16, 60)
    contact = rng.choice(("far apart", "an ulp apart", "an ulp deep", "vertex on vertex", *["vertex on edge"] * 4))
    _, _, nx, ny = edge_of(rings[0], rng)
    pair = in_contact(rng, rings, contact, (-ratio, 0) if rng.random() < 0.8 else (0, -ratio), (nx, ny, 0))
    return tuple(map(_still_convex, pair))


def in_contact(
    rng: Random, rings: Sequence[Whole], contact: str, powers: tuple[int, int], direction: tuple[int, int, int]
) -> Pair:
    """Return two shapes brought together from rings (an empty one is a circle), each scaled by a power of two.

    B lies beyond the origin in the direction (nx, ny, length), A on the near side (and B too, where it is inside).
    """
    nx, ny, length = direction
    on_edges = {"vertex on edge": 1, "edge on edge": 2}.get(contact, rng.choice((0, 1, 1, 2)))
    sides = []
    for i, ring in enumerate(rings):
        towards = (nx, ny) if contact in INNER or i == 0 else (-nx, -ny)
        if not ring:
            sides.append(circle_facing(rng, *towards, length))
        elif i < on_edges and len(ring) == len(hull(ring)):
            sides.append(edge_facing(rng, ring, *towards))
        else:
            sides.append(vertex_facing(ring, *towards))
    if contact in ("far apart", "deep", "contained"):
        moving = powers[0] > powers[1]  # the smaller one
        step, part = rng.choice((1, 1, 7, 100)), rng.choice((1, 4, 16, 64))
        step = step if (contact == "far apart") is moving else -step
        sides[moving] = sides[moving].moved(nx * step // part, ny * step // part)
    a, b = (side.scaled(power) for side, power in zip(sides, powers, strict=True))
    at = _place(rng, [*a[0], *b[0]])
    a, b = ((moved(ring, *at), radius) for ring, radius in (a, b))
    if contact.startswith("an ulp"):
        b = _stepped(rng, b, at, (nx, ny) if contact == "an ulp apart" else (-nx, -ny))
    grow = 2.0 ** rng.randint(-900, 900) if rng.random() < 0.1 else 1.0
    return _dressed(rng, *a, grow), _dressed(rng, *b, grow)


def _ring(rng: Random, name: str) -> Whole:
    """Return a ring of a family; an empty one for "circles"."""
    return [] if name == "circles" else notched(rng) if name == "concave" else FAMILIES[name](rng)


def _direction(rng: Random, rings: Sequence[Whole]) -> tuple[int, int, int]:
    """Return (nx, ny, length): across an edge, or with an integer length, as circles need it."""
    if all(rings) and rng.random() < 0.6:
        _, _, nx, ny = edge_of(rng.choice(rings), rng)
        return nx, ny, 0
    p, q, r = rng.choice((*TRIPLES, (0, 1, 1)))
    p, q = rng.sample((rng.choice((-1, 1)) * p, rng.choice((-1, 1)) * q), 2)
    return p, q, r


def _place(rng: Random, points: Ring) -> Point:
    """Return where to move a contact: mostly only as far as no coordinate of the points is rounded."""
    if rng.random() < 0.5:
        return 0.0, 0.0
    unit = 2.0 ** rng.choice((0, 0, -10, -20, 20, 30))
    at = rng.choice(
        (
            (rng.randint(-999, 999) * unit, rng.randint(-999, 999) * unit),
            (rng.randint(160_000, 840_000) + 0.001 * rng.randint(0, 999), rng.randint(0, 10_000_000) + 0.25),
        )
    )
    exact = all(_sum_is_exact(c, d) for v in points for c, d in zip(v, at, strict=True))
    return at if exact or rng.random() < 0.25 else (0.0, 0.0)


def _sum_is_exact(a: float, b: float) -> bool:
    """Return whether a sum of floats is exact."""
    total = a + b
    part = total - a
    return (a - (total - part)) + (b - part) == 0


def _stepped(rng: Random, side: tuple[Ring, float], at: Point, towards: Point) -> tuple[Ring, float]:
    """Return a shape that touches the point `at`, moved by one float (from 0 by a small number)."""
    ring, radius = side
    if radius:
        out = towards[0] * (ring[0][0] - at[0]) + towards[1] * (ring[0][1] - at[1]) > 0
        return ring, nudged(radius, -1 if out else 1)
    least = rng.choice((5e-324, 2.0**-1000, 2.0 ** -rng.randint(30, 140)))

    def step(c: float, way: float) -> float:
        """Return the next float in a direction."""
        return c if way == 0 else nudged(c, 1 if way > 0 else -1) if c else math.copysign(least, way)

    # an edge through the point does not have it as a corner: then all its corners go
    moving = [v for v in ring if v == at] or [
        v for v in ring if towards[0] * (v[0] - at[0]) + towards[1] * (v[1] - at[1]) == 0
    ]
    return [(step(x, towards[0]), step(y, towards[1])) if (x, y) in moving else (x, y) for x, y in ring], 0.0


def _dressed(rng: Random, ring: Ring, radius: float, grow: float = 1.0) -> Shape:
    """Return a ring's shape from any first vertex, in either winding, sometimes with vertices that change nothing."""
    ring = [(x * grow, y * grow) for x, y in ring]
    if radius:
        return Circle(ring[0], radius * grow)
    start = rng.randrange(len(ring))
    ring = ring[start:] + ring[:start]
    ring = dress(rng, ring) if rng.random() < 0.15 else ring[:: rng.choice((-1, 1))]
    return Polygon(ring)


def moved(ring: Sequence[Point], dx: float, dy: float) -> Ring:
    """Return the ring or shape moved by (dx, dy)."""
    return [(x + dx, y + dy) for x, y in ring]


# -- other contacts of rounded shapes --------------------------------------------------------------


def tenths(rng: Random) -> Pair:
    """Return tiles with sides that are sums of 0.1: what should meet misses by roundings, also beside 0, or meets."""

    def side(k: int) -> float:
        """Return k tenths in one of the ways in which programs compute them."""
        way = rng.randrange(4)
        if way == 0:
            return k * 0.1
        if way == 1:
            return math.copysign(sum([0.1] * abs(k)), k)
        start = rng.randint(-9, 9)
        return k / 10 if way == 2 else start * 0.1 + math.copysign(sum([0.1] * abs(k - start)), k - start)

    unit = rng.choice((1.0, 1.0, 1.0, 3.0, 1e6))
    low, mid = rng.randint(-3, 0), rng.randint(0, 3)
    high = mid + rng.randint(1, 4)
    boxes = []
    for x0, x1 in ((min(low, mid - 1), mid), (mid, high)):
        y0 = rng.randint(-4, 2)
        y1 = y0 + rng.randint(1, 6)
        box = [(side(x0), side(y0)), (side(x1), side(y0)), (side(x1), side(y1)), (side(x0), side(y1))]
        if rng.random() < 0.7:  # upright: each side worked out once
            (left, bottom), (right, top) = box[0], box[2]
            box = [(left, bottom), (right, bottom), (right, top), (left, top)]
        box = [(unit * x, unit * y) for x, y in box]
        boxes.append(box[:3] if rng.random() < 0.2 else box)
    if rng.random() < 0.5:
        boxes = [[(y, x) for x, y in box] for box in boxes]
    return convex(boxes[0]), convex(boxes[1])


def quarter_turns(rng: Random) -> Pair:
    """Return shapes side by side, rotated by cosines and sines of quarters and eighths (cos(pi / 2) is 6e-17)."""

    def turned(ring: Ring) -> Ring:
        """Return the ring rotated by quarters or eighths."""
        angle = rng.randint(-4, 8) * math.pi / rng.choice((2, 2, 2, 4))
        c, s = math.cos(angle), math.sin(angle)
        return [(c * x - s * y, s * x + c * y) for x, y in ring]

    def ring() -> Ring:
        """Return a regular polygon or a square."""
        if rng.random() < 0.3:  # a regular polygon about the origin
            n = rng.choice((3, 4, 6, 8, 12))
            return [(size * math.cos(2 * math.pi * i / n), size * math.sin(2 * math.pi * i / n)) for i in range(n)]
        corner = rng.choice(((0.0, 0.0), (size, 0.0), (-size, 0.0), (-size / 2, -size / 2)))
        return moved([(0.0, 0.0), (size, 0.0), (size, size), (0.0, size)], *corner)

    size = rng.choice((1.0, 2.0, 0.1, 1e5))
    a, b = turned(ring()), turned(ring())
    return convex(a), convex(moved(b, *(rng.choice((0.0, 0.0, size, -size, 2 * size)) for _ in "xy")))


def map_coordinates(rng: Random) -> Pair:
    """Return a parcel of a kilometre and a shape of millimetres or metres at its corner or edge, or inside it."""
    x, y = rng.randint(160_000, 840_000) + rng.randint(0, 999) / 1000, rng.randint(0, 9_999_999) + rng.random()
    parcel = moved(round_ring(rng, 0.0, 0.0, rng.choice((30.0, 1000.0, 1e5))), x, y)
    size = rng.choice((0.002, 0.002, 0.5, 20.0))
    i, j, nx, ny = edge_of(parcel, rng)
    along, length = rng.choice((0.0, 0.5, rng.random())), math.hypot(nx, ny) or 1.0
    px, py = (p + (q - p) * along for p, q in zip(parcel[i], parcel[j], strict=True))
    off = size * rng.choice((0.0, 0.5, 1.0, 1.0, 1.0, 1.5, -3.0)) / length
    px, py = px + nx * off, py + ny * off
    if rng.random() < 0.2:
        return convex(parcel), Circle((px, py), size)
    small = (
        [(size, 0.0), (0.0, size), (-size, 0.0), (0.0, -size)] if rng.random() < 0.5 else round_ring(rng, 0, 0, size)
    )
    return convex(parcel), convex(moved(small, px, py))


def concave_notch(rng: Random) -> Pair:
    """Return a concave polygon and a shape with a corner on one of its vertices or edges, from either side."""
    ring = [(4 * x, 4 * y) for x, y in notched(rng)]
    other = notched(rng) if rng.random() < 0.3 else few_corners(rng)
    i, j, nx, ny = edge_of(ring, rng)
    quarter = rng.randint(0, 4)
    at = tuple((p * (4 - quarter) + q * quarter) // 4 for p, q in zip(ring[i], ring[j], strict=True))
    side = vertex_facing([(4 * x, 4 * y) for x, y in other], -nx, -ny)
    a, _ = Facing([(x - at[0], y - at[1]) for x, y in ring]).scaled(0)
    b, _ = side.scaled(-rng.choice((0, 4, 8, 30)))
    if rng.random() < 0.3:
        b = _stepped(rng, (b, 0.0), (0.0, 0.0), rng.choice(((nx, ny), (-nx, -ny))))[0]
    return _dressed(rng, a, 0.0), _dressed(rng, b, 0.0)


def star(points: int, x: float = 0.0, y: float = 0.0, inner: float = 0.4) -> Polygon:
    """Return a star with points of length 1; its convex parts are one in the middle and one for each point."""
    arms = [((1, inner)[i % 2], i * math.pi / points) for i in range(2 * points)]
    return Polygon([(x + r * math.cos(angle), y + r * math.sin(angle)) for r, angle in arms])


def grid_ring(rng: Random, size: int = 40, step: float = 1.0) -> Ring:
    """Return a convex ring of 3 to 10 corners on the integers, times a power of two."""
    n = rng.randint(3, 10)
    while True:
        ring = hull([(rng.randint(-size, size), rng.randint(-size, size)) for _ in range(n + n // 2)])[:10]
        if len(ring) > 2:
            start = rng.randrange(len(ring))
            return [(float(x) * step, float(y) * step) for x, y in ring[start:] + ring[:start]]


def round_ring(rng: Random, x: float, y: float, size: float) -> Ring:
    """Return a convex ring of 3 to 10 corners on a rotated ellipse."""
    n = rng.randint(3, 10)
    angles = sorted(rng.uniform(0, math.tau) for _ in range(n))
    stretch, tilt = rng.uniform(0.2, 1), rng.uniform(0, math.tau)
    c, s = math.cos(tilt), math.sin(tilt)
    flat = [(size * math.cos(t), size * stretch * math.sin(t)) for t in angles]
    return [(x + c * u - s * v, y + s * u + c * v) for u, v in flat]


def jolted(rng: Random, ring: Ring, at: int, most: int = 4) -> Ring:
    """Return a ring with one coordinate of one corner moved by up to `most` floats."""
    x, y = ring[at]
    steps = rng.randint(-most, most)
    moved_point = (nudged(x, steps), y) if rng.random() < 0.5 else (x, nudged(y, steps))
    return [*ring[:at], moved_point, *ring[at + 1 :]]


def scaled(shape: Shape, power: int) -> Shape:
    """Return the shape times 2**power: exact except among the subnormals."""
    if isinstance(shape, Circle):
        x, y, r = (math.ldexp(c, power) for c in (*shape.center, shape.radius))
        return Circle((x, y), r)
    return convex([(math.ldexp(x, power), math.ldexp(y, power)) for x, y in shape.vertices])


# -- ordinary pairs --------------------------------------------------------------------------------


def random_polygons(rng: Random) -> Pair:
    """Return two polygons of sizes 0.5 to 3 in a field of 6 by 6."""
    return (
        convex(round_ring(rng, rng.uniform(-3, 3), rng.uniform(-3, 3), rng.uniform(0.5, 3))),
        convex(round_ring(rng, rng.uniform(-3, 3), rng.uniform(-3, 3), rng.uniform(0.5, 3))),
    )


def random_circles(rng: Random) -> Pair:
    """Return a circle and a circle or a polygon in a field of 6 by 6."""
    circle = Circle((rng.uniform(-3, 3), rng.uniform(-3, 3)), rng.uniform(0.1, 2.5))
    if rng.random() < 0.5:
        return circle, Circle((rng.uniform(-3, 3), rng.uniform(-3, 3)), rng.uniform(0.1, 2.5))
    return circle, convex(round_ring(rng, rng.uniform(-3, 3), rng.uniform(-3, 3), rng.uniform(0.5, 3)))


# -- near contacts ---------------------------------------------------------------------------------


def near_touching(offset: float) -> Callable[[Random], Pair]:
    """Return a kind: a corner moved to an edge as near as floats allow, then by -4 to 4 floats more."""

    def make(rng: Random) -> Pair:
        """Return a pair of this kind."""
        exact = rng.random() < 0.6  # on a grid the contact itself is exact
        if exact:
            step = 2.0 ** rng.randint(-4, 0)
            p, q = grid_ring(rng, 16, step), grid_ring(rng, 16, step)
            shift = [step * round(offset * rng.uniform(-1, 1) / step) for _ in "xy"]
        else:
            p, q = (round_ring(rng, 0.0, 0.0, rng.uniform(0.5, 4)) for _ in "pq")
            shift = [offset * rng.uniform(-1, 1) for _ in "xy"]
        p = moved(p, *shift)
        i, j, nx, ny = edge_of(p, rng)
        v = extreme(q, -nx, -ny)
        along = rng.choice((0.0, 0.25, 0.5, 0.75, 1.0)) if exact else rng.random()
        q = moved(q, *(p[i][c] + (p[j][c] - p[i][c]) * along - q[v][c] for c in (0, 1)))
        if rng.random() < 0.5:
            q = jolted(rng, q, v)
        else:
            p = jolted(rng, p, rng.choice((i, j)))
        return convex(p), convex(q)

    return make


def near_parallel(rng: Random) -> Pair:
    """Return two triangles with long, almost parallel edges a few floats apart at one end."""
    offset = rng.choice(OFFSETS) * rng.uniform(-1, 1)
    if rng.random() < 0.6:  # integers: the edges can lie exactly on each other
        offset, dx, dy = float(round(offset)), float(rng.randint(4, 4000)), float(rng.randint(-4000, 4000))
    else:
        dx, dy = rng.uniform(1, 100), rng.uniform(-100, 100)
    start, end = (offset, offset), (offset + dx, offset + dy)
    side = rng.uniform(0.1, 1)
    below = (offset + dx * rng.uniform(-1, 2) + dy * side, offset + dy * rng.uniform(0, 1) - dx * side)
    a = [start, end, below]
    first = (offset + dx * 0.25, offset + dy * 0.25) if rng.random() < 0.5 else start
    last = (offset + dx * 0.75, offset + dy * 0.75) if rng.random() < 0.5 else end
    above = (offset + dx * rng.uniform(0, 1) - dy * side, offset + dy * rng.uniform(0, 1) + dx * side)
    b = [last, first, above]
    if rng.random() < 0.3:  # both ends up by a few floats
        b = [(nudged(x, -rng.randint(0, 3) if dy > 0 else rng.randint(0, 3)), nudged(y, 1)) for x, y in b[:2]] + b[2:]
    for _ in range(rng.randint(0, 2)):
        b = jolted(rng, b, rng.choice((0, 1)))
    return convex(a), convex(b)


def needles(rng: Random) -> Pair:
    """Return a triangle a few floats thin and another, or a polygon, near its tip or its side."""
    far = rng.choice((1.0, 1e3, 1e6)) * rng.uniform(0.5, 1)
    dx, dy = rng.uniform(1, 9), rng.uniform(-9, 9)
    tip, end = (far, far), (far + dx, far + dy)
    middle = (far + dx * rng.random(), far + dy * rng.random() * 1.0001)
    if rng.random() < 0.7:
        t = rng.random()
        middle = (far + dx * t, nudged(far + dy * t, rng.choice((-9, -3, -2, -1, 1, 2, 3, 9))))
    needle = [tip, end, middle]
    if rng.random() < 0.4:  # a copy that shares a corner or lies a few floats beside
        copy = [(x, nudged(y, rng.randint(-6, 6))) for x, y in needle]
        return convex(needle), convex(copy)
    other = round_ring(rng, 0.0, 0.0, rng.uniform(0.5, 5))
    px, py = rng.choice((tip, end, middle, ((tip[0] + end[0]) / 2, (tip[1] + end[1]) / 2)))
    if rng.random() < 0.5:
        towards = (tip[0] - end[0], tip[1] - end[1]) if (px, py) == tip else (end[0] - tip[0], end[1] - tip[1])
    else:
        towards = rng.choice((-1, 1)) * -dy, rng.choice((-1, 1)) * dx
    v = extreme(other, -towards[0], -towards[1])
    other = jolted(rng, moved(other, px - other[v][0], py - other[v][1]), v)
    return convex(needle), convex(other)


def upright_boxes(rng: Random) -> Pair:
    """Return boxes along x and y, mostly on a small grid, so that many touch, or a box beside a polygon."""

    def box() -> Ring:
        """Return a random box."""
        if grid:
            x, y = rng.randint(-6, 6) * unit, rng.randint(-6, 6) * unit
            w, h = rng.randint(1, 6) * unit, rng.randint(1, 6) * unit
        else:
            x, y, w, h = rng.uniform(-6, 6), rng.uniform(-6, 6), rng.uniform(0.5, 8), rng.uniform(0.5, 8)
        return [(x, y), (x + w, y), (x + w, y + h), (x, y + h)]

    unit = rng.choice((1.0, 0.1, 2.0**-30, 1e6))
    grid = rng.random() < 0.75
    a, b = box(), box()
    if grid and rng.random() < 0.3:  # side by side, to the last bit or one off
        (x0, y0), _, (x1, y1), _ = a
        w, h = x1 - x0, rng.randint(1, 6) * unit
        left = nudged(x1, rng.randint(-1, 1))
        low = y0 + rng.choice((0.0, h, -h, y1 - y0))
        b = [(left, low), (left + w, low), (left + w, low + h), (left, low + h)]
    if rng.random() < 0.2:
        return convex(a), convex(moved(grid_ring(rng, 6, unit), rng.randint(-6, 6) * unit, rng.randint(-6, 6) * unit))
    return convex(a), convex(b)


# -- outlines that are walked down -----------------------------------------------------------------


def shortest_edge(rng: Random) -> Pair:
    """Return a polygon with two corners so close that their products vanish, and a shape at a corner beside them."""
    ring = many_corners(rng, 48)
    x, y = ring[0]
    ring = [(px - x, py - y) for px, py in ring]
    before, after = ring[-1], ring[1]
    along = after[0] - before[0], after[1] - before[1]
    (qx, qy), (rx, ry) = rng.choice(((before, ring[0]), (after, ring[2])))
    nx, ny = ry - qy, qx - rx
    other = few_corners(rng)
    px, py = other[extreme(other, -nx, -ny)]
    step, part = rng.choice((-1, 0, 0, 1)), rng.choice((1, 16, 64))
    other = moved(other, qx - px + nx * step // part, qy - py + ny * step // part)
    power = -rng.randint(40, 400)
    a, b = ([(math.ldexp(x, power), math.ldexp(y, power)) for x, y in whole] for whole in (ring, other))
    a.insert(1, (math.ldexp(along[0], -1074), math.ldexp(along[1], -1074)))
    start = rng.randrange(len(a))
    return convex((a[start:] + a[:start])[:: rng.choice((-1, 1))]), convex(b)


def level_far_side(rng: Random) -> Pair:
    """Return a polygon whose far side falls by less than a rounding both ways, and one near two of its corners.

    B is such that the first direction from A to it is (-ux, -uy), to the last bit.
    """
    n, (ux, uy) = rng.randint(3, 9), (rng.uniform(-1, 1), rng.uniform(1, 2))

    def falling(way: int) -> Ring:
        """Return a chain from the origin, ever steeper in rationals, but level with it in floats."""
        found = []
        while len(found) < n:
            x = way * rng.uniform(1, 2)
            y = -ux * x / uy
            fall = -Fraction(ux) * Fraction(x) - Fraction(uy) * Fraction(y)
            if fall > 0 and ux * x + uy * y == 0:
                found.append((fall / abs(Fraction(x)), x, y))
        # a thousand times as far each: then the way from one to the next is as steep as from the origin
        return [(math.ldexp(x, 10 * (i - n)), math.ldexp(y, 10 * (i - n))) for i, (_, x, y) in enumerate(sorted(found))]

    depth = rng.choice((0.5, 4.0))
    (lx, ly), right = ((side * uy - depth * ux, -side * ux - depth * uy) for side in (-1, 1))
    a = [(0.0, 0.0), *falling(-1), (lx, ly), right, *falling(1)[::-1]]
    times = rng.choice((1, 1, 1, 2))  # 1: at the middle one of A's corners
    return convex(a), convex([(-ux, -uy), (times * lx, times * ly), (-2 * ux, -2 * uy)])


def bowls(rng: Random) -> Pair:
    """Return corners of all sizes on a parabola, and others upside down below it: both at the origin, or nearly."""

    def bowl() -> Ring:
        """Return corners on the parabola y = x * x."""
        reach = rng.choice((4, 60, 500))
        xs = {way * rng.choice((1, 3, 5)) * 2.0 ** rng.randint(-reach, reach) for way in (-1, 1) for _ in range(9)}
        return [(x, x * x) for x in sorted(xs | {0.0} if rng.random() < 0.7 else xs)]

    a, b = bowl(), bowl()
    if rng.random() < 0.5:
        b = list(a)
    if rng.random() < 0.7:  # a corner a float or two beside where it was, mostly the lowest
        lowest = min(range(len(b)), key=lambda i: b[i][1])
        b = jolted(rng, b, rng.choice((lowest, lowest, rng.randrange(len(b)))), 2)
    return convex(a), convex([(x, -y) for x, y in b])


# -- circles ---------------------------------------------------------------------------------------


def _jolted_circle(rng: Random, circle: Circle, most: int = 2) -> Circle:
    """Return a circle with its radius or a coordinate of its center moved by up to `most` floats."""
    (x, y), r = circle.center, circle.radius
    steps = rng.randint(-most, most)
    which = rng.randrange(3)
    if which == 0:
        return Circle((x, y), nudged(r, steps))
    return Circle((nudged(x, steps), y) if which == 1 else (x, nudged(y, steps)), r)


def circles_near_tangent(rng: Random) -> Pair:
    """Return two circles that touch as nearly as floats allow, one then moved by up to two floats."""
    offset = rng.choice(OFFSETS)
    ax, ay, bx, by = (offset * rng.uniform(-1, 1) for _ in range(4))
    distance = math.hypot(ax - bx, ay - by)
    r = distance * rng.uniform(0.001, 0.999)
    return Circle((ax, ay), r), _jolted_circle(rng, Circle((bx, by), distance - r))


def circle_polygon_near_tangent(rng: Random) -> Pair:
    """Return a polygon and a circle that touch as nearly as floats allow, the circle then moved by up to two floats."""
    offset = rng.choice(OFFSETS) * rng.choice((0.0, 1.0, 1.0))
    ring = moved(
        round_ring(rng, 0.0, 0.0, rng.uniform(0.5, 5)), offset * rng.uniform(-1, 1), offset * rng.uniform(-1, 1)
    )
    i, j, nx, ny = edge_of(ring, rng)
    r = rng.uniform(0.01, 3) * rng.choice((1.0, 1.0, 1e-6, 1e6))
    length = math.hypot(nx, ny)
    if length == 0:
        raise NotConvex
    along = rng.random()
    at = tuple(p + (q - p) * along for p, q in zip(ring[i], ring[j], strict=True))
    if rng.random() < 0.4:  # off a corner instead of an edge
        angle = rng.uniform(0, math.tau)
        nx, ny, length = math.cos(angle), math.sin(angle), 1.0
        at = ring[extreme(ring, nx, ny)]
    cx, cy = at[0] + nx / length * r, at[1] + ny / length * r
    return convex(ring), _jolted_circle(rng, Circle((cx, cy), math.hypot(cx - at[0], cy - at[1])))


def circle_clipped_corner(rng: Random) -> Pair:
    """Return a box with a corner cut off by a much shorter edge, and a circle resting on that edge or an end of it."""
    cut, unit, size = (2.0 ** rng.randint(-80, 0) for _ in range(3))
    size = max(size, 2 * cut)
    ring = [(-cut, 0.0), (-size, 0.0), (-size, -size), (0.0, -size), (0.0, -cut)]
    p, q, r = rng.choice(TRIPLES)
    if rng.random() < 0.6:
        center = (p * unit - cut, q * unit) if rng.random() < 0.7 else (q * unit, p * unit - cut)
    else:
        center = (unit - cut * 0.5, unit - cut * 0.5)
        r = math.sqrt(2)
    center, *ring = spun([center, *ring], *rng.choice(((1, 0), (0, -1), (3, 4), (-12, 5))))
    length = math.hypot(*ring[0]) / cut
    power = rng.choice((0, 0, -rng.randint(0, 900), rng.randint(0, 900)))
    circle = _jolted_circle(rng, Circle(center, r * unit * length), rng.choice((0, 1, 2)))
    return scaled(convex(ring), power), scaled(circle, power)


def pointed_at_circle(rng: Random) -> Pair:
    """Return a needle that points at a circle's center to less than a rounding of its edges, and that circle.

    In rationals the center lies outside; the rounded edges, each by itself, can all have it on their inner side.
    """
    while True:
        x, y = sorted(4 * rng.randrange(2**50, int(2**50.4)) + 2 for _ in "xy")
        # half a float from x and y, which is rounded away: three edges lean to one side of (x, y), the last leans more
        at = [(-3 * x, -3 * y + 2), (1 - x, 1 - y), (x + 2, y + 1), (3 * x + 2, 3 * y)]
        # the products x*q and p*y straddle a half: of what is rounded to, where products vanish
        half = 2**105
        p, q = half // y + 1, half // x
        if half % x / x + 1 - half % y / y < 0.6:
            break
    vanishing = rng.random() < 0.7
    size, near = (-729, -452) if vanishing else (0, rng.randint(3, 40))
    center = -math.ldexp(p, near), -math.ldexp(q, near)
    most = max(map(abs, center))
    radius = most * rng.choice((1.2, rng.uniform(1.0, math.hypot(*center) / most), rng.uniform(0.1, 2.0)))
    center, *ring = spun([center, *((math.ldexp(u, size), math.ldexp(v, size)) for u, v in at)], *rng.choice(QUARTERS))
    return convex(ring), Circle(center, radius)


# -- scales ----------------------------------------------------------------------------------------

BASIC = (
    random_polygons,
    random_circles,
    near_touching(1.0),
    near_parallel,
    partial(about_a_point, "few corners"),
    partial(about_a_point, "circles"),
    circle_polygon_near_tangent,
    circles_near_tangent,
)


def any_scale(rng: Random) -> Pair:
    """Return an ordinary pair times any power of two, which must keep the relation."""
    a, b = rng.choice(BASIC)(rng)
    power = rng.randint(-1000, 990)
    return scaled(a, power), scaled(b, power)


def smallest_scale(rng: Random) -> Pair:
    """Return a pair among the subnormals, where coordinates round to a few units of 2**-1074."""
    a, b = rng.choice((*BASIC, upright_boxes))(rng)
    power = -rng.randint(1000, 1080)
    return scaled(a, power), scaled(b, power)


def largest_scale(rng: Random) -> Pair:
    """Return a pair at the end of float64, where differences and products overflow."""
    a, b = rng.choice(BASIC)(rng)
    most = max(abs(c) for shape in (a, b) for c in _numbers(shape))
    power = rng.choice((1023, 1024, 1024)) - math.frexp(most)[1]
    return scaled(a, power), scaled(b, power)


def _numbers(shape: Shape) -> list[float]:
    """Return all coordinates and the radius of a shape."""
    if isinstance(shape, Circle):
        return [*shape.center, shape.radius]
    return [c for v in shape.vertices for c in v]


def mixed_magnitudes(rng: Random) -> Pair:
    """Return triangles (and circles) whose own coordinates differ by hundreds of powers of two."""

    def wild() -> float:
        """Return a number of any magnitude."""
        return (
            rng.choice((-1, 1))
            * rng.uniform(1, 2)
            * 2.0
            ** rng.choice((rng.randint(-3, 3), rng.randint(-60, 60), rng.randint(-500, 500), rng.randint(-1000, 1000)))
        )

    def triangle() -> Ring:
        """Return three such points."""
        return [(wild(), wild()) for _ in range(3)]

    a = triangle()
    if rng.random() < 0.25:
        return convex(a), Circle((wild(), wild()), abs(wild()))
    b = triangle()
    pick = rng.random()
    if pick < 0.3:  # one corner shared, or a float or two beside
        b = jolted(rng, [a[0], *b[1:]], 0, 2)
    elif pick < 0.55:  # a common edge, the third corners on different sides or not
        b = [a[0], a[1], b[2]]
    elif pick < 0.7:
        b = [((a[0][0] + a[1][0]) / 2, (a[0][1] + a[1][1]) / 2), *b[1:]]
    return convex(a), convex(b)


def one_out_of_range(rng: Random) -> Pair:
    """Return a polygon and, on a corner or an edge of it, one whose products overflow or vanish."""
    ring = few_corners(rng)
    i = rng.randrange(len(ring))
    p, q = ring[i], ring[(i + 1) % len(ring)]
    at = p if rng.random() < 0.6 else (p[0] + q[0], p[1] + q[1])
    even = 1 if at is p else 2
    power = rng.choice((0, 0, -8, 8, 30))
    a = [(math.ldexp(even * x - at[0], power), math.ldexp(even * y - at[1], power)) for x, y in ring]
    size = rng.choice((rng.randint(400, 1000), rng.randint(-1050, -400)))

    def wild() -> float:
        """Return a number near the end of float64, or near the subnormals."""
        return rng.choice((-1, 1, 1)) * math.ldexp(rng.uniform(1, 2), size + rng.choice((0, 0, 0, -1, -20, 20)))

    touched = (rng.choice((0.0, 0.0, 5e-324, -5e-324, 1e-300)), 0.0)
    b = [touched[:: rng.choice((-1, 1))], *((wild(), wild()) for _ in range(rng.choice((2, 2, 3))))]
    turns = rng.randrange(4)
    for _ in range(turns):
        b = [(-y, x) for x, y in b]
    return convex(a), convex(b)


def circle_by_a_bent_side(rng: Random) -> Pair:
    """Return a small circle beside a slightly bent side, at about the distance that rounding can hide.

    Floats can place the center on the line through one part of the side, and beside the line through the other.
    """
    turn = rng.uniform(0, math.tau)
    along, inward = (math.cos(turn), math.sin(turn)), (-math.sin(turn), math.cos(turn))
    start = rng.uniform(-1, 1), rng.uniform(-1, 1)

    def at(s: float, h: float) -> Point:
        """Return the point at s along the side and h inwards of it."""
        return tuple(c + s * u + h * v for c, u, v in zip(start, along, inward, strict=True))

    end, bend = rng.uniform(1, 1.5), rng.uniform(0.3, 0.6)
    ring = [at(0, 0), at(bend, -rng.randrange(3) * 2.0**-52), at(end, 0), at(0.5, rng.uniform(0.2, 1))]
    s = rng.uniform(0.05, 1) * end
    far = max(abs(c - d) for p in ring for c, d in zip(p, at(s, 0), strict=True))
    off = far * (abs(along[0]) + abs(along[1])) * 2.0 ** -rng.choice((48, 48, 48, 48, 46, 47, 49, 50, 51))
    off *= rng.choice((1, 1, 1, -1)) * rng.gauss(1, rng.choice((0.02, 0.02, 0.3)))
    circle = Circle(at(s, off), 2.0 ** -rng.choice((5, 30, 45, 60)))
    power = rng.choice((0, 0, 0, -300, 300))
    pair = scaled(convex(ring), power), scaled(circle, power)
    return pair if rng.random() < 0.5 else pair[::-1]


def dress(rng: Random, ring: Sequence[Point]) -> Ring:
    """Return the same outline with midpoints (exact on even grids), repeats, a closing vertex, in either winding."""
    full: Ring = []
    for p, q in zip(ring, [*ring[1:], ring[0]], strict=True):
        full += [p] * rng.choice((1, 1, 1, 2, 3))
        if rng.random() < 0.3:
            full += [((p[0] + q[0]) / 2, (p[1] + q[1]) / 2)] * rng.choice((1, 2))
    start = rng.randrange(len(full))
    full = full[start:] + full[:start]
    if rng.random() < 0.5:
        full.append(full[0])
    return full[::-1] if rng.random() < 0.5 else full


# kinds of convex shapes; those about a point first
CONVEX: dict[str, Callable[[Random], Pair]] = {
    **{name: partial(about_a_point, name) for name in (*FAMILIES, "circles")},
    "tiny and huge": tiny_and_huge,
    "sums of a tenth": tenths,
    "quarter turns": quarter_turns,
    "map coordinates": map_coordinates,
    "random polygons": random_polygons,
    "random circles": random_circles,
    **{f"near touching, offset {offset:g}": near_touching(offset) for offset in OFFSETS},
    "nearly parallel": near_parallel,
    "rounded needles": needles,
    "boxes on a grid": upright_boxes,
    "shortest edges": shortest_edge,
    "level far sides": level_far_side,
    "bowls": bowls,
    "circles near tangent": circles_near_tangent,
    "circle and polygon near tangent": circle_polygon_near_tangent,
    "circle and clipped corner": circle_clipped_corner,
    "circle by a bent side": circle_by_a_bent_side,
    "needles pointed at circles": pointed_at_circle,
    "any scale": any_scale,
    "smallest scale": smallest_scale,
    "largest scale": largest_scale,
    "wild triangles": mixed_magnitudes,
    "one out of range": one_out_of_range,
}
KINDS = CONVEX | {"concave": partial(about_a_point, "concave"), "in the notch": concave_notch}
