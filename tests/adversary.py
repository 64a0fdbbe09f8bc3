"""A search for the worst: numbers where rounding comes nearest to a filter's room, and pairs that forms disagree about.

    python tests/adversary.py SECONDS [SEED]     (with the tests' folder and satviz on the path)

prints for each filter the worst share of its room that was found, worked out in
rationals, and the numbers it was found at.  1 or more would be a wrong bound.
"""

import math
import struct
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from decimal import Decimal, localcontext
from fractions import Fraction
from random import Random
from typing import NamedTuple

import numpy as np
from forms import FORMS, Form
from oracle import relation
from strategies import KINDS, NotConvex, drawn, nudged

from satviz import batch, record
from satviz.batch import exact_signs
from satviz.batch.with_numpy import filter as filter_numpy
from satviz.engine import relate
from satviz.engine.geometry import InvalidShape, Relation
from satviz.engine.sat import CLOSE_GAP_FACTOR
from satviz.engine.shapes import Circle, Polygon, Shape
from satviz.study import truth

U = 2.0**-53
Numbers = Sequence[float]


class Bound(NamedTuple):
    """`share(*numbers)`: the error over the room granted; `start(rng)`: numbers to begin with; `derived`: its limit."""

    share: Callable[..., float]
    start: Callable[[Random], Numbers]
    derived: float


class Worst(NamedTuple):
    share: float
    numbers: Numbers


# -- the climb -------------------------------------------------------------------------------------


def climb(bound: Bound, rng: Random, steps: int = 60) -> Worst:
    """From one start uphill, by steps of a few floats or by other bits."""
    here = list(bound.start(rng))
    worst = bound.share(*here)
    for _ in range(steps):
        there = list(here)
        for _ in range(rng.choice((1, 1, 2))):
            i = rng.randrange(len(there))
            there[i] = (
                nudged(there[i], rng.choice((-3, -2, -1, 1, 2, 3))) if rng.random() < 0.8 else bits(rng, there[i])
            )
        found = bound.share(*there)
        if found >= worst:
            here, worst = there, found
    return Worst(worst, here)


def stepped(rng: Random, value: float) -> float:
    """Some floats further; for what float32 makes of it, or the rounding of a square, some 2**29 or 2**26."""
    far = 2.0 ** rng.choice((0, 0, 0, 13, 26, 29, 30, 40))
    return value + rng.choice((-3, -2, -1, 1, 2, 3)) * math.ulp(value) * far


def bits(rng: Random, value: float) -> float:
    """One bit of the fraction turned over, or the sign."""
    (whole,) = struct.unpack("<q", struct.pack("<d", value))
    return struct.unpack("<d", struct.pack("<q", whole ^ 1 << rng.randrange(52)))[0] if rng.random() < 0.9 else -value


def search(bound: Bound, seed: int, seconds: float = math.inf, tries: int = 0) -> Worst:
    """The worst of so many tries, or of so many seconds."""
    rng, worst, end = Random(seed), Worst(0.0, ()), time.monotonic() + seconds
    done = 0
    while done < tries or (not tries and time.monotonic() < end):
        worst = max(worst, climb(bound, rng), key=lambda w: w.share)
        done += 1
    return worst


# -- starts ----------------------------------------------------------------------------------------


def rough(rng: Random) -> float:
    """Numbers whose roundings weigh most lie just above a power of two."""
    size = rng.choice((1.0, 1.0, 0.5, 2.0)) * (1 + rng.choice((2.0**-30, 2.0**-12, 0.03, 1)) * rng.random())
    return rng.choice((-1, 1)) * size


def any_numbers(count: int) -> Callable[[Random], Numbers]:
    return lambda rng: [rough(rng) for _ in range(count)]


def near_look(rng: Random) -> Numbers:
    """An edge and a vertex about on its line, where roundings decide."""
    px, py, qx, qy = (rough(rng) for _ in range(4))
    along = rng.choice((0.0, 1.0, 0.5, rng.random(), rng.uniform(-1, 2)))
    return px, py, qx, qy, px + (qx - px) * along, py + (qy - py) * along


def two_triangles(rng: Random) -> Numbers:
    """A corner of the second about on an edge of the first."""
    px, py, qx, qy, x, y = near_look(rng)
    return [px, py, qx, qy, rough(rng), rough(rng), x, y, *(rough(rng) for _ in range(4))]


def three_products(rng: Random) -> Numbers:
    """Factors of products that nearly cancel."""
    a, b, c, d = (rough(rng) for _ in range(4))
    e = rough(rng)
    return a, b, c, d, e, -(a * b + c * d) / e


# -- errors over rooms -----------------------------------------------------------------------------


def fused(a: float, b: float, c: float) -> float:
    """a * b + c rounded once."""
    return float(Fraction(a) * Fraction(b) + Fraction(c))


def over(error: Fraction, room: float) -> float:
    return float(error / Fraction(room)) if 0 < room < math.inf else 0.0


def look(px: float, py: float, qx: float, qy: float, x: float, y: float, fuse: bool = False) -> float:
    """relate's look at a vertex from an edge, with the least room that shapes with these can have."""
    dx, dy = qx - px, qy - py
    if fuse:
        there, edge = fused(dy, x, -(dx * y)), fused(-dx, py, dy * px)
    else:
        there, edge = dy * x - dx * y, dy * px - dx * py
    room = max(abs(dx), abs(dy)) * max(map(abs, (px, py, qx, qy, x, y))) * relate.ERROR_FACTOR_F64
    exact = -truth.turn((px, py), (qx, qy), (x, y))
    return max(over(abs(Fraction(there) - Fraction(edge + r) - (exact - Fraction(r))), room) for r in (room, -room))


def fused_look(*numbers: float) -> float:
    return look(*numbers, fuse=True)


def circles(ax: float, ay: float, ar: float, bx: float, by: float, br: float) -> float:
    dx, dy, reach = ax - bx, ay - by, abs(ar) + abs(br)
    distance, reach = dx * dx + dy * dy, reach * reach
    fx, fy, fr = Fraction(ax) - Fraction(bx), Fraction(ay) - Fraction(by), Fraction(abs(ar)) + Fraction(abs(br))
    exact = fx * fx + fy * fy - fr * fr
    return over(abs(Fraction(distance - reach) - exact), (distance + reach) * 2.0**-50)


def center_turn(cx: float, cy: float, vx: float, vy: float, wx: float, wy: float) -> float:
    """The side of an edge that a circle's center is on."""
    px, py, dx, dy = vx - cx, vy - cy, wx - vx, wy - vy
    far = max(map(abs, (px, py, wx - cx, wy - cy)))
    error = abs(Fraction(px * dy - py * dx) - truth.turn((vx, vy), (wx, wy), (cx, cy)))
    return over(error, (abs(dx) + abs(dy)) * far * 2.0**-48)


def center_distance(cx: float, cy: float, vx: float, vy: float, wx: float, wy: float) -> float:
    """The squared distance of a circle's center from an edge."""
    px, py, qx, qy, dx, dy = vx - cx, vy - cy, wx - cx, wy - cy, wx - vx, wy - vy
    far = max(map(abs, (px, py, qx, qy)))
    turn, along, square = px * dy - py * dx, -(px * dx + py * dy), dx * dx + dy * dy
    if square == 0:
        return 0.0
    if along <= 0:
        found = (px * px + py * py,)
    elif along >= square:
        found = (qx * qx + qy * qy,)
    else:
        found = turn * turn / square, turn / square * turn  # in whichever order
    c, p, q = ((Fraction(x), Fraction(y)) for x, y in ((cx, cy), (vx, vy), (wx, wy)))
    exact = truth._segment_distance2(c, p, q)
    return max(over(abs(Fraction(d) - exact), far * far * 2.0**-46) for d in found)


def _triangles(numbers: Numbers) -> tuple[list, list]:
    points = list(zip(numbers[::2], numbers[1::2], strict=True))
    return points[:3], points[3:]


def _group(ring: Sequence) -> batch.arrays.Group:
    x, y = (np.array([[v[k]] for v in ring]) for k in (0, 1))
    span = max(abs(p[k] - q[k]) for p, q in zip(ring, [*ring[1:], ring[0]], strict=True) for k in (0, 1))
    return batch.arrays.Group(x, y, None, span, max(abs(c) for v in ring for c in v))


def _exact_clearance(p: Sequence, q: Sequence) -> Fraction:
    def own(ring: Sequence, points: Sequence) -> Fraction:
        edges = zip(ring, [*ring[1:], ring[0]], strict=True)
        return max(min(-truth.turn(*edge, v) for v in points) for edge in edges)

    return max(own(p, q), own(q, p))


def float32_look(*numbers: float) -> float:
    p, q = _triangles(numbers)
    a, b = _group(p), _group(q)
    width = filter_numpy._max_width(a) + filter_numpy._max_width(b)
    found, room = filter_numpy.evaluate_f32(a.x, a.y, b.x, b.y, width)
    return over(abs(Fraction(float(found[0])) - _exact_clearance(p, q)), float(room[0]))


def float64_look(*numbers: float) -> float:
    """What numba's kernels look at, and the room that they are granted."""
    from satviz.batch.with_numba.filter import error_bound_of

    p, q = _triangles(numbers)
    a, b = _group(p), _group(q)
    found = filter_numpy.clearance(a.x, a.y, b.x, b.y, 0)
    return over(abs(Fraction(float(found[0])) - _exact_clearance(p, q)), error_bound_of(a, b))


def turn(px: float, py: float, qx: float, qy: float, rx: float, ry: float) -> float:
    """The first look of exact_signs.orient."""
    left, right = (qx - px) * (ry - py), (qy - py) * (rx - px)
    exact = truth.turn((px, py), (qx, qy), (rx, ry))
    return over(abs(Fraction(left - right) - exact), exact_signs.ERRBOUND_A * (abs(left) + abs(right)))


def two_floats(*numbers: float) -> float:
    """Sums of three products in two floats, beyond the last rounding of the sum itself."""
    factors = [(np.array([a]), np.array([b])) for a, b in zip(numbers[::2], numbers[1::2], strict=True)]
    total, off, _ = exact_signs.sum_with_error(factors, np.zeros(1))
    exact = sum(Fraction(a) * Fraction(b) for a, b in zip(numbers[::2], numbers[1::2], strict=True))
    return over(abs(Fraction(float(total[0])) - exact) - abs(exact) * Fraction(U), float(off[0]))


def recorded_gap(*numbers: float) -> float:
    """The float gaps that a trace takes without a second look."""
    try:
        a, b = (Polygon(ring) for ring in _triangles(numbers))
    except InvalidShape:
        return 0.0
    close = max(a.max_coordinate, b.max_coordinate) * CLOSE_GAP_FACTOR
    worst = 0.0
    with localcontext(prec=60):
        for test in record(a, b, every_axis=True).tests:
            (nx, ny), shape = test.axis.normal, a if test.axis.source.shape == "A" else b
            i, j = (shape.vertices[k] for k in test.axis.source.ids)
            nx, ny = Decimal(j[1]) - Decimal(i[1]), Decimal(i[0]) - Decimal(j[0])
            on = [[nx * Decimal(x) + ny * Decimal(y) for x, y in s.corners] for s in (a, b)]
            exact = max(min(on[0]) - max(on[1]), min(on[1]) - max(on[0])) / (nx * nx + ny * ny).sqrt()
            worst = max(worst, float(abs(Decimal(test.gap) - exact)) / close)
    return worst


BOUNDS: dict[str, Bound] = {
    "relate: a look at a vertex": Bound(look, near_look, 15 / 32),
    "relate: the same, fused": Bound(fused_look, near_look, 15 / 32),
    "relate: a look anywhere": Bound(look, any_numbers(6), 15 / 32),
    "circles": Bound(circles, any_numbers(6), 5 / 8),
    "circle and polygon: the center's side": Bound(center_turn, near_look, 12 / 32),
    "circle and polygon: the distance": Bound(center_distance, any_numbers(6), 45 / 128),
    "batch: the float32 look": Bound(float32_look, two_triangles, 1),
    "batch: the float64 look": Bound(float64_look, two_triangles, 15 / 32),
    "signs.orient": Bound(turn, near_look, 4 / 8),
    "signs.nearly": Bound(two_floats, three_products, 33 / 256),
    "record: a gap": Bound(recorded_gap, two_triangles, 27 * U / CLOSE_GAP_FACTOR),
}


# -- disagreement ----------------------------------------------------------------------------------


def mutated(rng: Random, a: Shape, b: Shape) -> tuple[Shape, Shape]:
    """One number of either changed: by a few floats, by a bit, or to a number that the other has."""
    which = rng.random() < 0.5
    shape, other = (a, b) if which else (b, a)
    numbers, others = _numbers(shape), _numbers(other)
    i = rng.randrange(len(numbers))
    way = rng.random()
    numbers[i] = (
        nudged(numbers[i], rng.choice((-2, -1, 1, 2)))
        if way < 0.5
        else bits(rng, numbers[i])
        if way < 0.75
        else rng.choice(others)
    )
    made = _made(shape, numbers)
    return (made, b) if which else (a, made)


def _numbers(shape: Shape) -> list[float]:
    return [*shape.center, shape.radius] if isinstance(shape, Circle) else [c for v in shape.vertices for c in v]


def _made(like: Shape, numbers: list[float]) -> Shape:
    if isinstance(like, Circle):
        return Circle(numbers[:2], numbers[2])
    return Polygon(list(zip(numbers[::2], numbers[1::2], strict=True)))


def wrong_answers(seed: int, seconds: float) -> Iterator[tuple[str, Shape, Shape, Relation, object]]:
    """Each (form, a, b, truth, answer) that does not fit, of pairs bred towards contact."""
    rng, end = Random(seed), time.monotonic() + seconds
    forms: dict[str, Form] = {name: form for name, form in FORMS.items() if form.one_in <= 8}
    alive: list[tuple[Shape, Shape, Relation]] = []
    while time.monotonic() < end:
        parents = [pair[:2] for pair in alive] + [drawn(rng, kind) for kind in KINDS]
        brood = []
        for a, b in parents:
            for _ in range(3):
                try:
                    p, q = mutated(rng, a, b)
                    brood.append((p, q, relation(p, q)))
                except (InvalidShape, NotConvex, OverflowError):
                    continue
        for name, form in forms.items():
            try:
                answers = form.ask([(a, b) for a, b, _ in brood])
            except Exception as error:  # a form that fails outright is told of, and the search goes on
                answers = [error] * len(brood)
            for (a, b, right), said in zip(brood, answers):
                if said is not None and not form.fits(said, right):
                    yield name, a, b, right, said
        # those that touch live on, and so do the rarer ones beside them
        touching = [p for p in brood if p[2] is Relation.TOUCHING]
        alive = rng.sample(touching, min(60, len(touching))) + rng.sample(brood, 20)


def table(seed: int, seconds: float) -> None:
    """The worst of each bound, in so many seconds each, printed as it is found."""
    for name, bound in BOUNDS.items():
        share, numbers = search(bound, seed, seconds)
        print(f"{name:38s} {share:9.3g} of the room ({bound.derived:.3g} derived), at {list(numbers)}", flush=True)


if __name__ == "__main__":
    each, start = float(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 1
    table(start, each)
    seen: set = set()
    for name, a, b, right, said in wrong_answers(start, 4 * each):
        if name not in seen:
            seen.add(name)
            print(f"{name} says {said}, is {right}:\na = {a!r}\nb = {b!r}", flush=True)
