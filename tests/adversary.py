"""A search for worst cases: numbers whose rounding comes nearest to an error bound, and pairs with a wrong answer.

    python tests/adversary.py SECONDS [SEED]     (with the tests' folder and satviz on the path)

prints for each filter the worst share of its error bound that was found, computed with
rationals, and the numbers at which it was found.  1 or more would be a wrong bound.
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
    """An error bound of a filter, and how to search for its worst case.

    `share(*numbers)`: the error over the error bound; `start(rng)`: numbers to begin with; `derived`: the largest
    share by the bound's derivation.
    """

    share: Callable[..., float]
    start: Callable[[Random], Numbers]
    derived: float


class Worst(NamedTuple):
    """The largest share of an error bound that was found, and the numbers at which it was found."""

    share: float
    numbers: Numbers


# -- the climb -------------------------------------------------------------------------------------


def climb(bound: Bound, rng: Random, steps: int = 60) -> Worst:
    """Return the worst share that a random climb finds: each step changes a number by a few floats or flips a bit."""
    here = list(bound.start(rng))
    worst = bound.share(*here)
    for _ in range(steps):
        there = list(here)
        for _ in range(rng.choice((1, 1, 2))):
            i = rng.randrange(len(there))
            there[i] = (
                nudged(there[i], rng.choice((-3, -2, -1, 1, 2, 3))) if rng.random() < 0.8 else flip_bit(rng, there[i])
            )
        found = bound.share(*there)
        if found >= worst:
            here, worst = there, found
    return Worst(worst, here)


def flip_bit(rng: Random, value: float) -> float:
    """Return a number with one bit of its fraction, or its sign, flipped."""
    (whole,) = struct.unpack("<q", struct.pack("<d", value))
    return struct.unpack("<d", struct.pack("<q", whole ^ 1 << rng.randrange(52)))[0] if rng.random() < 0.9 else -value


def search(bound: Bound, seed: int, seconds: float = math.inf, tries: int = 0) -> Worst:
    """Return the worst share of so many climbs, or of so many seconds of climbing."""
    rng, worst, end = Random(seed), Worst(0.0, ()), time.monotonic() + seconds
    done = 0
    while done < tries or (not tries and time.monotonic() < end):
        worst = max(worst, climb(bound, rng), key=lambda w: w.share)
        done += 1
    return worst


# -- starts ----------------------------------------------------------------------------------------


def random_number(rng: Random) -> float:
    """Return a number, mostly just above a power of two, where roundings are largest relative to it."""
    size = rng.choice((1.0, 1.0, 0.5, 2.0)) * (1 + rng.choice((2.0**-30, 2.0**-12, 0.03, 1)) * rng.random())
    return rng.choice((-1, 1)) * size


def any_numbers(count: int) -> Callable[[Random], Numbers]:
    """Return a function that starts a climb with so many numbers."""
    return lambda rng: [random_number(rng) for _ in range(count)]


def near_edge_line(rng: Random) -> Numbers:
    """Return an edge and a vertex close to its line, where roundings decide."""
    px, py, qx, qy = (random_number(rng) for _ in range(4))
    along = rng.choice((0.0, 1.0, 0.5, rng.random(), rng.uniform(-1, 2)))
    return px, py, qx, qy, px + (qx - px) * along, py + (qy - py) * along


def two_triangles(rng: Random) -> Numbers:
    """Return two triangles, the second with a corner close to an edge of the first."""
    px, py, qx, qy, x, y = near_edge_line(rng)
    return [px, py, qx, qy, random_number(rng), random_number(rng), x, y, *(random_number(rng) for _ in range(4))]


def three_products(rng: Random) -> Numbers:
    """Return the factors of three products that nearly cancel."""
    a, b, c, d = (random_number(rng) for _ in range(4))
    e = random_number(rng)
    return a, b, c, d, e, -(a * b + c * d) / e


# -- errors over bounds ----------------------------------------------------------------------------


def fused(a: float, b: float, c: float) -> float:
    """Return a * b + c rounded once."""
    return float(Fraction(a) * Fraction(b) + Fraction(c))


def share_of(error: Fraction, error_bound: float) -> float:
    """Return an error as a share of an error bound; 0 for a bound that is not used."""
    return float(error / Fraction(error_bound)) if 0 < error_bound < math.inf else 0.0


def edge_value_share(px: float, py: float, qx: float, qy: float, x: float, y: float, fuse: bool = False) -> float:
    """Return the error of relate's value of a vertex at an edge over the smallest error bound of such shapes."""
    dx, dy = qx - px, qy - py
    if fuse:
        there, edge = fused(dy, x, -(dx * y)), fused(-dx, py, dy * px)
    else:
        there, edge = dy * x - dx * y, dy * px - dx * py
    error_bound = max(abs(dx), abs(dy)) * max(map(abs, (px, py, qx, qy, x, y))) * relate.ERROR_FACTOR_F64
    exact = -truth.orientation((px, py), (qx, qy), (x, y))
    return max(
        share_of(abs(Fraction(there) - Fraction(edge + r) - (exact - Fraction(r))), error_bound)
        for r in (error_bound, -error_bound)
    )


def fused_edge_value_share(*numbers: float) -> float:
    """Return `edge_value_share` with fused multiply-add."""
    return edge_value_share(*numbers, fuse=True)


def circles_share(ax: float, ay: float, ar: float, bx: float, by: float, br: float) -> float:
    """Return the error of the gap of two circles over its error bound."""
    dx, dy, radii = ax - bx, ay - by, abs(ar) + abs(br)
    distance_squared, radii_squared = dx * dx + dy * dy, radii * radii
    fx, fy, fr = Fraction(ax) - Fraction(bx), Fraction(ay) - Fraction(by), Fraction(abs(ar)) + Fraction(abs(br))
    exact = fx * fx + fy * fy - fr * fr
    return share_of(
        abs(Fraction(distance_squared - radii_squared) - exact), (distance_squared + radii_squared) * 2.0**-50
    )


def center_side_share(cx: float, cy: float, vx: float, vy: float, wx: float, wy: float) -> float:
    """Return the error of the determinant of an edge and a circle's center over its error bound."""
    px, py, dx, dy = vx - cx, vy - cy, wx - vx, wy - vy
    far = max(map(abs, (px, py, wx - cx, wy - cy)))
    error = abs(Fraction(px * dy - py * dx) - truth.orientation((vx, vy), (wx, wy), (cx, cy)))
    return share_of(error, (abs(dx) + abs(dy)) * far * 2.0**-48)


def center_distance_share(cx: float, cy: float, vx: float, vy: float, wx: float, wy: float) -> float:
    """Return the error of the squared distance of an edge from a circle's center over its error bound."""
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
    return max(share_of(abs(Fraction(d) - exact), far * far * 2.0**-46) for d in found)


def _triangles(numbers: Numbers) -> tuple[list, list]:
    """Return twelve numbers as the corners of two triangles."""
    points = list(zip(numbers[::2], numbers[1::2], strict=True))
    return points[:3], points[3:]


def _group(ring: Sequence) -> batch.arrays.CornerColumns:
    """Return a ring as a group of one, as the filters take it."""
    span = max(abs(p[k] - q[k]) for p, q in zip(ring, [*ring[1:], ring[0]], strict=True) for k in (0, 1))
    coordinate = max(abs(c) for v in ring for c in v)
    return batch.arrays.CornerColumns(
        np.array([[[v[k]] for v in ring] for k in (0, 1)]), np.array([[span], [coordinate]])
    )


def _exact_clearance(p: Sequence, q: Sequence) -> Fraction:
    """Return the exact largest clearance of any edge, unnormalised."""

    def own(ring: Sequence, points: Sequence) -> Fraction:
        edges = zip(ring, [*ring[1:], ring[0]], strict=True)
        return max(min(-truth.orientation(*edge, v) for v in points) for edge in edges)

    return max(own(p, q), own(q, p))


def float32_share(*numbers: float) -> float:
    """Return the error of a clearance in float32 over its error bound."""
    p, q = _triangles(numbers)
    a, b = _group(p), _group(q)
    width = filter_numpy._max_widths(a, 0, 1) + filter_numpy._max_widths(b, 0, 1)
    found, error_bound = filter_numpy.evaluate_f32(a.x, a.y, b.x, b.y, width)
    return share_of(abs(Fraction(float(found[0])) - _exact_clearance(p, q)), float(error_bound[0]))


def float64_share(*numbers: float) -> float:
    """Return the error of a clearance in float64 over the error bound of numba's kernels."""
    from satviz.batch.with_numba.filter import error_bounds

    p, q = _triangles(numbers)
    a, b = _group(p), _group(q)
    found = filter_numpy.clearance(a.x, a.y, b.x, b.y, 0)
    return share_of(abs(Fraction(float(found[0])) - _exact_clearance(p, q)), float(error_bounds(a, b)[0]))


def orient_share(px: float, py: float, qx: float, qy: float, rx: float, ry: float) -> float:
    """Return the error of the first stage of exact_signs.orient over its error bound."""
    left, right = (qx - px) * (ry - py), (qy - py) * (rx - px)
    exact = truth.orientation((px, py), (qx, qy), (rx, ry))
    return share_of(abs(Fraction(left - right) - exact), exact_signs.ERRBOUND_A * (abs(left) + abs(right)))


def sum_share(*numbers: float) -> float:
    """Return the error of sum_with_error on three products over its error bound, beyond the last rounding."""
    factors = [(np.array([a]), np.array([b])) for a, b in zip(numbers[::2], numbers[1::2], strict=True)]
    total, off, _ = exact_signs.sum_with_error(factors, np.zeros(1))
    exact = sum(Fraction(a) * Fraction(b) for a, b in zip(numbers[::2], numbers[1::2], strict=True))
    return share_of(abs(Fraction(float(total[0])) - exact) - abs(exact) * Fraction(U), float(off[0]))


def gap_share(*numbers: float) -> float:
    """Return the largest error of a float gap in a trace over the limit below which gaps are computed exactly."""
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
    "relate: a vertex at an edge": Bound(edge_value_share, near_edge_line, 15 / 32),
    "relate: a vertex at an edge, fused": Bound(fused_edge_value_share, near_edge_line, 15 / 32),
    "relate: a vertex anywhere": Bound(edge_value_share, any_numbers(6), 15 / 32),
    "circles": Bound(circles_share, any_numbers(6), 5 / 8),
    "circle and polygon: the center's side": Bound(center_side_share, near_edge_line, 12 / 32),
    "circle and polygon: the distance": Bound(center_distance_share, any_numbers(6), 45 / 128),
    "batch: float32": Bound(float32_share, two_triangles, 1),
    "batch: float64": Bound(float64_share, two_triangles, 15 / 32),
    "exact_signs.orient": Bound(orient_share, near_edge_line, 4 / 8),
    "exact_signs.sum_with_error": Bound(sum_share, three_products, 33 / 256),
    "record: a gap": Bound(gap_share, two_triangles, 27 * U / CLOSE_GAP_FACTOR),
}


# -- disagreement ----------------------------------------------------------------------------------


def mutate_pair(rng: Random, a: Shape, b: Shape) -> tuple[Shape, Shape]:
    """Return a pair with one number changed: by a few floats, by a bit, or to a number of the other shape."""
    which = rng.random() < 0.5
    shape, other = (a, b) if which else (b, a)
    numbers, others = _numbers(shape), _numbers(other)
    i = rng.randrange(len(numbers))
    way = rng.random()
    numbers[i] = (
        nudged(numbers[i], rng.choice((-2, -1, 1, 2)))
        if way < 0.5
        else flip_bit(rng, numbers[i])
        if way < 0.75
        else rng.choice(others)
    )
    made = _make_shape(shape, numbers)
    return (made, b) if which else (a, made)


def _numbers(shape: Shape) -> list[float]:
    """Return all coordinates and the radius of a shape."""
    return [*shape.center, shape.radius] if isinstance(shape, Circle) else [c for v in shape.vertices for c in v]


def _make_shape(like: Shape, numbers: list[float]) -> Shape:
    """Return a shape of the same kind from numbers."""
    if isinstance(like, Circle):
        return Circle(numbers[:2], numbers[2])
    return Polygon(list(zip(numbers[::2], numbers[1::2], strict=True)))


def wrong_answers(seed: int, seconds: float) -> Iterator[tuple[str, Shape, Shape, Relation, object]]:
    """Yield (form, a, b, truth, answer) for each answer that is wrong, about pairs bred towards contact."""
    rng, end = Random(seed), time.monotonic() + seconds
    forms: dict[str, Form] = {name: form for name, form in FORMS.items() if form.one_in <= 8}
    alive: list[tuple[Shape, Shape, Relation]] = []
    while time.monotonic() < end:
        parents = [pair[:2] for pair in alive] + [drawn(rng, kind) for kind in KINDS]
        brood = []
        for a, b in parents:
            for _ in range(3):
                try:
                    p, q = mutate_pair(rng, a, b)
                    brood.append((p, q, relation(p, q)))
                except (InvalidShape, NotConvex, OverflowError):
                    continue
        for name, form in forms.items():
            try:
                answers = form.ask([(a, b) for a, b, _ in brood])
            except Exception as error:  # a form that raises is reported, and the search goes on
                answers = [error] * len(brood)
            for (a, b, right), said in zip(brood, answers):
                if said is not None and not form.fits(said, right):
                    yield name, a, b, right, said
        # those that touch live on, and so do the rarer ones beside them
        touching = [p for p in brood if p[2] is Relation.TOUCHING]
        alive = rng.sample(touching, min(60, len(touching))) + rng.sample(brood, 20)


def print_worst(seed: int, seconds: float) -> None:
    """Print the worst share of each bound as it is found, in so many seconds each."""
    for name, bound in BOUNDS.items():
        share, numbers = search(bound, seed, seconds)
        print(
            f"{name:38s} {share:9.3g} of the error bound ({bound.derived:.3g} derived), at {list(numbers)}", flush=True
        )


if __name__ == "__main__":
    each, start = float(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 1
    print_worst(start, each)
    seen: set = set()
    for name, a, b, right, said in wrong_answers(start, 4 * each):
        if name not in seen:
            seen.add(name)
            print(f"{name} says {said}, is {right}:\na = {a!r}\nb = {b!r}", flush=True)
