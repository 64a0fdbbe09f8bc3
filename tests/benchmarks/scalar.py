"""Microseconds a pair: relate and record against shapely and against the same loop unrecorded.

Run: python tests/benchmarks/scalar.py.  The methods are taken in turn within a round
and the medians over the rounds are shown; the pairs are random with about 40 % hits.
"""

import random
import statistics
from math import cos, pi, sin
from time import perf_counter

import shapely

import satviz as sv
from satviz.engine.sat import CLOSE_GAP_FACTOR

PAIRS, ROUNDS = 1000, 15


def ngon(rng, n, spread):
    x, y = rng.uniform(-spread, spread), rng.uniform(-spread, spread)
    while True:
        turns = sorted(rng.uniform(0, 2 * pi) for _ in range(n))
        points = [(x + cos(t), y + sin(t)) for t in turns]
        try:
            if len(sv.Polygon(points).corners) == n:
                return points
        except sv.InvalidShape:
            continue


def box(rng, spread):
    x, y, t = rng.uniform(-spread, spread), rng.uniform(-spread, spread), rng.uniform(0, 2 * pi)
    w, h = rng.uniform(0.3, 1), rng.uniform(0.3, 1)
    corners = ((-w, -h), (w, -h), (w, h), (-w, h))
    return [(x + cos(t) * p - sin(t) * q, y + sin(t) * p + cos(t) * q) for p, q in corners]


def circle(rng, spread):
    return (rng.uniform(-spread, spread), rng.uniform(-spread, spread)), rng.uniform(0.3, 1)


WORKLOADS = {
    "triangles": lambda r: (ngon(r, 3, 0.9), ngon(r, 3, 0.9)),
    "boxes": lambda r: (box(r, 1.7), box(r, 1.7)),
    "8-gons": lambda r: (ngon(r, 8, 1.9), ngon(r, 8, 1.9)),
    "circle and triangle": lambda r: (ngon(r, 3, 1.3), circle(r, 1.3)),
}


def ours(shape):
    return sv.Circle(*shape) if isinstance(shape, tuple) else sv.Polygon(shape)


def theirs(shape):
    """Shapely has no circle: its closest question is the distance to the center."""
    return shapely.Point(shape[0]) if isinstance(shape, tuple) else shapely.Polygon(shape)


def unrecorded(a, b):
    """The recording loop with nothing kept: the same axes, landings, gap and early exit."""
    reach = max(a.max_coordinate, b.max_coordinate)
    close = reach * CLOSE_GAP_FACTOR
    gap = -1.0
    for (nx, ny), length, _ in sv.axes.needed(a, b).axes:
        spans = []
        for shape in (a, b):
            if type(shape) is sv.Circle:
                x, y = shape.center
                at = (x * nx + y * ny) / length
                spans.append((at - shape.radius, at + shape.radius))
            else:
                dots = [(x * nx + y * ny) / length for x, y in shape.corners]
                spans.append((min(dots), max(dots)))
        gap = max(spans[0][0] - spans[1][1], spans[1][0] - spans[0][1])
        if gap > close:
            break
    return gap


def main():
    print(
        f"{'us a pair':22}{'hits':>6}{'relate':>9}{'shapely':>9}{'ratio':>7}{'record':>9}{'unrecorded':>12}{'ratio':>7}"
    )
    for name, make in WORKLOADS.items():
        rng = random.Random(7)
        raw = [make(rng) for _ in range(PAIRS)]
        mine = [(ours(a), ours(b)) for a, b in raw]
        other = [(theirs(a), theirs(b), b[1] if isinstance(b, tuple) else None) for a, b in raw]

        def peer(other=other):
            for a, b, radius in other:
                a.intersects(b) if radius is None else a.dwithin(b, radius)

        def each(function, mine=mine):
            def all_pairs():
                for a, b in mine:
                    function(a, b)

            return all_pairs

        runs = {"relate": each(sv.relate), "shapely": peer, "record": each(sv.record), "unrecorded": each(unrecorded)}
        times = {key: [] for key in runs}
        for _ in range(ROUNDS):
            for key, loop in runs.items():
                start = perf_counter()
                loop()
                times[key].append((perf_counter() - start) / PAIRS * 1e6)
        t = {key: statistics.median(values) for key, values in times.items()}
        hits = sum(sv.relate(a, b) > 0 for a, b in mine) / PAIRS
        print(
            f"{name:22}{hits:6.0%}{t['relate']:9.2f}{t['shapely']:9.2f}{t['relate'] / t['shapely']:7.2f}"
            f"{t['record']:9.2f}{t['unrecorded']:12.2f}{t['record'] / t['unrecorded']:7.2f}"
        )


if __name__ == "__main__":
    main()
