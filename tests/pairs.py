"""Pairs of convex shapes meant to break a collision test: near and exact contacts at every scale, from a seed."""

import math
from collections.abc import Callable, Iterator, Sequence
from random import Random

from satviz.geometry import InvalidShape
from satviz.shapes import Circle, Polygon, Shape

Point = tuple[float, float]
Ring = list[Point]
Pair = tuple[Shape, Shape]

TRIPLES = (3, 4, 5), (5, 12, 13), (8, 15, 17), (20, 21, 29)
OFFSETS = 1.0, 1e2, 1e4, 1e6, 1e8


class NotConvex(Exception):
    """Rounding dented a polygon: another is drawn."""


def pairs(seed: int, count: int) -> Iterator[tuple[str, Shape, Shape]]:
    """`count` times (kind, a, b), the kinds in turn; pairs that satviz refuses to build are replaced."""
    rng = Random(seed)
    kinds = list(KINDS.items())
    for i in range(count):
        name, make = kinds[i % len(kinds)]
        while True:
            try:
                a, b = make(rng)
                break
            except (InvalidShape, NotConvex):
                continue
        yield (name, a, b) if rng.random() < 0.5 else (name, b, a)


def convex(points: Sequence[Sequence[float]]) -> Polygon:
    """A Polygon that came out convex after rounding."""
    polygon = Polygon(points)
    if not polygon.is_convex:
        raise NotConvex
    return polygon


def nudged(value: float, steps: int) -> float:
    """The float `steps` places above (below when negative)."""
    for _ in range(abs(steps)):
        value = math.nextafter(value, math.copysign(math.inf, steps))
    return value


# -- rings -----------------------------------------------------------------------------------------


def hull(points: Sequence[Point]) -> Ring:
    """The strict convex hull of grid points (their differences and products are exact), counter-clockwise."""
    ordered = sorted(set(points))

    def half(run: Sequence[Point]) -> Ring:
        chain: Ring = []
        for r in run:
            while len(chain) > 1 and _turn(chain[-2], chain[-1], r) <= 0:
                chain.pop()
            chain.append(r)
        return chain[:-1]

    return half(ordered) + half(ordered[::-1])


def grid_ring(rng: Random, size: int = 40, step: float = 1.0) -> Ring:
    """A convex ring of 3 to 10 corners on the integers, times a power of two."""
    n = rng.randint(3, 10)
    while True:
        ring = hull([(rng.randint(-size, size), rng.randint(-size, size)) for _ in range(n + n // 2)])[:10]
        if len(ring) > 2:
            start = rng.randrange(len(ring))
            return [(float(x) * step, float(y) * step) for x, y in ring[start:] + ring[:start]]


def round_ring(rng: Random, x: float, y: float, size: float) -> Ring:
    """A convex ring with 3 to 10 corners on an ellipse, turned anyhow."""
    n = rng.randint(3, 10)
    angles = sorted(rng.uniform(0, math.tau) for _ in range(n))
    stretch, tilt = rng.uniform(0.2, 1), rng.uniform(0, math.tau)
    c, s = math.cos(tilt), math.sin(tilt)
    flat = [(size * math.cos(t), size * stretch * math.sin(t)) for t in angles]
    return [(x + c * u - s * v, y + s * u + c * v) for u, v in flat]


def moved(ring: Sequence[Point], dx: float, dy: float) -> Ring:
    return [(x + dx, y + dy) for x, y in ring]


def spun(ring: Sequence[Point], p: int, q: int) -> Ring:
    """Turned by the angle of (p, q) and grown by its length: exact on integers, right angles stay right."""
    return [(p * x - q * y, q * x + p * y) for x, y in ring]


def _turn(p: Point, q: Point, r: Point) -> float:
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def extreme(ring: Sequence[Point], dx: float, dy: float) -> int:
    """Which corner lies furthest in a direction."""
    return max(range(len(ring)), key=lambda i: dx * ring[i][0] + dy * ring[i][1])


def edge_of(ring: Sequence[Point], rng: Random) -> tuple[int, int, float, float]:
    """An edge as two places in the ring, and its outward normal."""
    i = rng.randrange(len(ring))
    j = (i + 1) % len(ring)
    return i, j, ring[j][1] - ring[i][1], ring[i][0] - ring[j][0]


def jolted(rng: Random, ring: Ring, at: int, most: int = 4) -> Ring:
    """One coordinate of one corner moved by up to `most` floats."""
    x, y = ring[at]
    steps = rng.randint(-most, most)
    moved_point = (nudged(x, steps), y) if rng.random() < 0.5 else (x, nudged(y, steps))
    return [*ring[:at], moved_point, *ring[at + 1 :]]


def scaled(shape: Shape, power: int) -> Shape:
    """The shape times 2**power: exact unless it goes below the normal floats."""
    if isinstance(shape, Circle):
        x, y, r = (math.ldexp(c, power) for c in (*shape.center, shape.radius))
        return Circle((x, y), r)
    return convex([(math.ldexp(x, power), math.ldexp(y, power)) for x, y in shape.vertices])


# -- ordinary pairs --------------------------------------------------------------------------------


def random_polygons(rng: Random) -> Pair:
    return (
        convex(round_ring(rng, rng.uniform(-3, 3), rng.uniform(-3, 3), rng.uniform(0.5, 3))),
        convex(round_ring(rng, rng.uniform(-3, 3), rng.uniform(-3, 3), rng.uniform(0.5, 3))),
    )


def random_circles(rng: Random) -> Pair:
    circle = Circle((rng.uniform(-3, 3), rng.uniform(-3, 3)), rng.uniform(0.1, 2.5))
    if rng.random() < 0.5:
        return circle, Circle((rng.uniform(-3, 3), rng.uniform(-3, 3)), rng.uniform(0.1, 2.5))
    return circle, convex(round_ring(rng, rng.uniform(-3, 3), rng.uniform(-3, 3), rng.uniform(0.5, 3)))


# -- near contacts ---------------------------------------------------------------------------------


def near_touching(offset: float) -> Callable[[Random], Pair]:
    """A corner slid to a place on an edge, as near as floats allow, then moved by -4 to 4 floats."""

    def make(rng: Random) -> Pair:
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
    """Two long edges, almost parallel, a few floats apart at one end."""
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
    """A triangle a few floats thin against another, or against a polygon, near its tip or its flank."""
    far = rng.choice((1.0, 1e3, 1e6)) * rng.uniform(0.5, 1)
    dx, dy = rng.uniform(1, 9), rng.uniform(-9, 9)
    tip, end = (far, far), (far + dx, far + dy)
    middle = (far + dx * rng.random(), far + dy * rng.random() * 1.0001)
    if rng.random() < 0.7:
        t = rng.random()
        middle = (far + dx * t, nudged(far + dy * t, rng.choice((-9, -3, -2, -1, 1, 2, 3, 9))))
    needle = [tip, end, middle]
    if rng.random() < 0.4:  # a twin that shares a corner or lies a few floats beside
        twin = [(x, nudged(y, rng.randint(-6, 6))) for x, y in needle]
        return convex(needle), convex(twin)
    other = round_ring(rng, 0.0, 0.0, rng.uniform(0.5, 5))
    px, py = rng.choice((tip, end, middle, ((tip[0] + end[0]) / 2, (tip[1] + end[1]) / 2)))
    if rng.random() < 0.5:
        towards = (tip[0] - end[0], tip[1] - end[1]) if (px, py) == tip else (end[0] - tip[0], end[1] - tip[1])
    else:
        towards = rng.choice((-1, 1)) * -dy, rng.choice((-1, 1)) * dx
    v = extreme(other, -towards[0], -towards[1])
    other = jolted(rng, moved(other, px - other[v][0], py - other[v][1]), v)
    return convex(needle), convex(other)


# -- exact contacts --------------------------------------------------------------------------------


def _touching_rings(rng: Random, contact: str) -> tuple[Ring, Ring, int]:
    """Two integer rings in exact contact, and the corner of the second that touches."""
    a = [(4 * x, 4 * y) for x, y in grid_ring(rng)]
    if contact == "vertex-vertex":
        nx, ny = rng.randint(-9, 9) or 1, rng.randint(-9, 9) or 1
        at = a[extreme(a, nx, ny)]
        b = [(4 * x, 4 * y) for x, y in grid_ring(rng)]
    else:
        i, j, nx, ny = edge_of(a, rng)
        quarter = rng.randint(0, 4)
        at = tuple((p * (4 - quarter) + q * quarter) / 4 for p, q in zip(a[i], a[j], strict=True))
        b = [(4 * x, 4 * y) for x, y in grid_ring(rng)]
        if contact == "edge-edge":  # the same ring turned half round has an edge just opposite
            grow = rng.randint(1, 3)
            b = [(-grow * x, -grow * y) for x, y in a]
    v = extreme(b, -nx, -ny)
    b = moved(b, at[0] - b[v][0], at[1] - b[v][1])
    if rng.random() < 0.5:
        p, q, _ = rng.choice(TRIPLES)
        a, b = spun(a, p, q), spun(b, p, q)
    return a, b, v


def exact_touch(contact: str) -> Callable[[Random], Pair]:
    """Grid polygons that meet in just a corner or an edge; a third of them moved by one float."""

    def make(rng: Random) -> Pair:
        a, b, v = _touching_rings(rng, contact)
        step = 2.0 ** rng.randint(-8, 8)
        shift = rng.choice((0.0, 0.0, 2.0**20, 2.0**30)) * step
        a, b = (moved([(x * step, y * step) for x, y in ring], shift, -shift) for ring in (a, b))
        if rng.random() < 0.35:
            b = jolted(rng, b, v, 1)
        return convex(a), convex(b)

    return make


def upright_boxes(rng: Random) -> Pair:
    """Boxes along x and y, on a small grid (so that many touch) or not, or a box beside a polygon."""

    def box() -> Ring:
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


def containment(rng: Random) -> Pair:
    """One shape inside the other, free of its edge or touching it from within."""
    if rng.random() < 0.3:
        p, q, r = rng.choice(TRIPLES)
        inner = float(rng.randint(1, 5))
        outer = Circle((0.0, 0.0), inner + r)
        return outer, Circle((p, q), inner) if rng.random() < 0.5 else convex([(0, 0), (p, q), (-q, p)])
    ring = grid_ring(rng)
    cx, cy = (math.fsum(c) / len(ring) for c in zip(*ring, strict=True))
    if rng.random() < 0.4:
        return convex(ring), Circle((cx, cy), rng.uniform(0.01, 60))
    shrink = rng.choice((0.5, 0.25, 0.125, 1.0))
    fixed = rng.choice((ring[0], (round(cx), round(cy))))
    return convex(ring), convex([tuple(f + (c - f) * shrink for f, c in zip(fixed, v, strict=True)) for v in ring])


# -- circles ---------------------------------------------------------------------------------------


def _jolted_circle(rng: Random, circle: Circle, most: int = 2) -> Circle:
    (x, y), r = circle.center, circle.radius
    steps = rng.randint(-most, most)
    which = rng.randrange(3)
    if which == 0:
        return Circle((x, y), nudged(r, steps))
    return Circle((nudged(x, steps), y) if which == 1 else (x, nudged(y, steps)), r)


def circle_circle_345(rng: Random) -> Pair:
    """Tangent from outside with all numbers exact; half of them moved by a float or two."""
    p, q, r = rng.choice(TRIPLES)
    grow = rng.randint(1, 50) * 2
    r1 = rng.randint(1, r * grow - 1)
    step, x, y = 2.0 ** rng.randint(-20, 20), rng.randint(-1000, 1000), rng.randint(-1000, 1000)
    p, q = (rng.choice((-1, 1)) * c * grow for c in rng.sample((p, q), 2))
    a = Circle((x * step, y * step), r1 * step)
    b = Circle(((x + p) * step, (y + q) * step), (r * grow - r1) * step)
    return a, _jolted_circle(rng, b) if rng.random() < 0.5 else b


def circle_edge_345(rng: Random) -> Pair:
    """A circle resting on an edge, then all turned by a Pythagorean angle, exactly."""
    ring = grid_ring(rng)
    top = max(y for _, y in ring)
    flat = [v for v in ring if v[1] == top]
    if len(flat) < 2:
        (x, _), size = flat[0], rng.randint(1, 20)
        ring = hull([*ring, (x - size, top), (x + size, top)])
        flat = [v for v in ring if v[1] == top]
    left, right = min(flat)[0], max(flat)[0]
    foot, r = left + (right - left) * rng.choice((0, 0.25, 0.5, 0.75, 1)), float(rng.randint(1, 60))
    p, q, length = rng.choice(TRIPLES)
    ((x, y),) = spun([(foot, top + r)], p, q)
    step = 2.0 ** rng.randint(-20, 20)
    circle = Circle((x * step, y * step), r * length * step)
    polygon = convex([(x * step, y * step) for x, y in spun(ring, p, q)])
    return polygon, _jolted_circle(rng, circle) if rng.random() < 0.5 else circle


def circle_vertex_345(rng: Random) -> Pair:
    """A circle that touches a corner only, to the last bit or a float or two off."""
    ring = grid_ring(rng)
    p, q, r = rng.choice(TRIPLES)
    p, q = (rng.choice((-1, 1)) * c for c in rng.sample((p, q), 2))
    x, y = ring[extreme(ring, p, q)]
    grow, step = rng.randint(1, 9), 2.0 ** rng.randint(-20, 20)
    circle = Circle(((x + p * grow) * step, (y + q * grow) * step), r * grow * step)
    return convex([(x * step, y * step) for x, y in ring]), _jolted_circle(
        rng, circle
    ) if rng.random() < 0.5 else circle


def circles_near_tangent(rng: Random) -> Pair:
    """Any two circles, the second's radius the distance as near as floats allow, then moved by two floats or less."""
    offset = rng.choice(OFFSETS)
    ax, ay, bx, by = (offset * rng.uniform(-1, 1) for _ in range(4))
    distance = math.hypot(ax - bx, ay - by)
    r = distance * rng.uniform(0.001, 0.999)
    return Circle((ax, ay), r), _jolted_circle(rng, Circle((bx, by), distance - r))


def circle_polygon_near_tangent(rng: Random) -> Pair:
    """Any polygon and a circle outside whose radius is its distance, then moved by two floats or less."""
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
    """A box with a corner cut off by a much shorter edge, and a circle that rests on that edge or one of its ends."""
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


# -- scales ----------------------------------------------------------------------------------------

BASIC = (
    random_polygons,
    random_circles,
    near_touching(1.0),
    near_parallel,
    exact_touch("vertex-edge"),
    exact_touch("edge-edge"),
    circle_edge_345,
    circle_vertex_345,
    circle_circle_345,
    circle_polygon_near_tangent,
    circles_near_tangent,
)


def any_scale(rng: Random) -> Pair:
    """One of the pairs above times any power of two: the relation must stay."""
    a, b = rng.choice(BASIC)(rng)
    power = rng.randint(-1000, 990)
    return scaled(a, power), scaled(b, power)


def smallest_scale(rng: Random) -> Pair:
    """Down among the subnormals, where coordinates round to a few units of 2**-1074."""
    a, b = rng.choice((exact_touch("vertex-edge"), circle_edge_345, random_polygons, random_circles, upright_boxes))(
        rng
    )
    power = -rng.randint(1000, 1080)
    return scaled(a, power), scaled(b, power)


def largest_scale(rng: Random) -> Pair:
    """Up at the end of float64: differences and products overflow."""
    a, b = rng.choice(BASIC)(rng)
    most = max(abs(c) for shape in (a, b) for c in _numbers(shape))
    power = rng.choice((1023, 1024, 1024)) - math.frexp(most)[1]
    return scaled(a, power), scaled(b, power)


def _numbers(shape: Shape) -> list[float]:
    if isinstance(shape, Circle):
        return [*shape.center, shape.radius]
    return [c for v in shape.vertices for c in v]


def tiny_and_huge(rng: Random) -> Pair:
    """A very small shape at the corner, on the edge or inside a very large one."""
    k = rng.choice((rng.randint(5, 60), rng.randint(60, 900)))
    huge = [(x * 2.0**k, y * 2.0**k) for x, y in grid_ring(rng)]
    i, j, nx, ny = edge_of(huge, rng)
    tiny = grid_ring(rng)
    along = rng.choice((0.0, 0.0, 0.5))
    ax, ay = (p + (q - p) * along for p, q in zip(huge[i], huge[j], strict=True))
    if rng.random() < 0.5:  # the origin is where small numbers live: bring the contact there
        huge, ax, ay = moved(huge, -ax, -ay), 0.0, 0.0
    if rng.random() < 0.4:
        p, q, r = rng.choice(TRIPLES)
        unit = 2.0 ** -rng.randint(0, 60)
        px, py = math.copysign(p, nx) * unit, math.copysign(q, ny) * unit
        circle = Circle((ax + px, ay + py), r * unit)
        return convex(huge), _jolted_circle(rng, circle) if rng.random() < 0.5 else circle
    v = extreme(tiny, -nx, -ny)
    tiny = moved([(x * 2.0**-20, y * 2.0**-20) for x, y in tiny], 0.0, 0.0)
    tiny = moved(tiny, ax - tiny[v][0], ay - tiny[v][1])
    if rng.random() < 0.5:
        tiny = jolted(rng, tiny, v)
    return convex(huge), convex(tiny)


def mixed_magnitudes(rng: Random) -> Pair:
    """Triangles (and circles) whose own coordinates differ by hundreds of powers of two."""

    def wild() -> float:
        return (
            rng.choice((-1, 1))
            * rng.uniform(1, 2)
            * 2.0
            ** rng.choice((rng.randint(-3, 3), rng.randint(-60, 60), rng.randint(-500, 500), rng.randint(-1000, 1000)))
        )

    def triangle() -> Ring:
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


# -- dressed outlines ------------------------------------------------------------------------------


def dressed(rng: Random) -> Pair:
    """Grid contacts with the outlines given as people give them: clockwise, with repeats, midpoints, closed."""
    a, b, _ = _touching_rings(rng, rng.choice(("vertex-vertex", "vertex-edge", "edge-edge")))
    b = moved(b, *rng.choice(((0.0, 0.0), (0.0, 0.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 1.0))))
    a, b = dress(rng, a), dress(rng, b)
    if rng.random() < 0.2:
        p, q, r = rng.choice(TRIPLES)
        x, y = b[rng.randrange(len(b))]
        return convex(a), Circle((x + p, y + q), r)
    return convex(a), convex(b)


def dress(rng: Random, ring: Sequence[Point]) -> Ring:
    """The same outline with midpoints (exact on even grids), repeats, a closing vertex, the other way round."""
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


KINDS: dict[str, Callable[[Random], Pair]] = {
    "random polygons": random_polygons,
    "random circles": random_circles,
    **{f"near touching, offset {offset:g}": near_touching(offset) for offset in OFFSETS},
    "nearly parallel": near_parallel,
    "needles": needles,
    **{f"exact {contact}": exact_touch(contact) for contact in ("vertex-vertex", "vertex-edge", "edge-edge")},
    "upright boxes": upright_boxes,
    "containment": containment,
    "circle and circle 3-4-5": circle_circle_345,
    "circle and edge 3-4-5": circle_edge_345,
    "circle and vertex 3-4-5": circle_vertex_345,
    "circles near tangent": circles_near_tangent,
    "circle and polygon near tangent": circle_polygon_near_tangent,
    "circle and clipped corner": circle_clipped_corner,
    "any scale": any_scale,
    "smallest scale": smallest_scale,
    "largest scale": largest_scale,
    "tiny and huge": tiny_and_huge,
    "mixed magnitudes": mixed_magnitudes,
    "dressed outlines": dressed,
}
