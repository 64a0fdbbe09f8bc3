"""The regret of a recommendation: the time of the recommended model over that of the fastest right one, scene by scene.

    python tests/benchmarks/advice.py [--engine numpy|numba] [--only SCENE ...]

Only scenes of which the exact filter needs more than 5 ms count towards the median.
"""

import argparse
import math
import statistics

import numpy as np

import satviz as sv
from satviz import batch
from satviz.advice.candidates import EXACT_FILTER
from satviz.advice.costs import costs
from satviz.study.workloads import generators

PAIRS = 200_000
MIN_EXACT_TIME = 5e6  # nanoseconds of the exact filter for all pairs


def upright(rng, n):
    """Return n upright boxes."""
    at, size = rng.uniform(0, 3, (n, 1, 2)), rng.uniform(0.5, 2, (n, 1, 2))
    return batch.Polygons(at + size * np.array([[0, 0], [1, 0], [1, 1], [0, 1]]))


def turned_alike(rng, n):
    """Return n squares turned by the same angle, with whole coordinates."""
    at, size = rng.integers(0, 40, (n, 1, 2)), rng.integers(5, 20, (n, 1, 2))
    u = (at + size * np.array([[0, 0], [1, 0], [1, 1], [0, 1]])).astype(float)
    return batch.Polygons(np.stack([3 * u[..., 0] - 4 * u[..., 1], 4 * u[..., 0] + 3 * u[..., 1]], axis=2))


def on_a_grid(rng, n):
    """Return n hexagons with small whole coordinates."""
    tall = np.array([[0, 0], [2, 0], [3, 1], [3, 3], [1, 4], [0, 3]])
    return batch.Polygons((tall * rng.integers(1, 3, (n, 1, 1)) + rng.integers(0, 6, (n, 1, 2))).astype(float))


def discs(rng, n):
    """Return n circles."""
    return batch.Circles(*generators.circles(rng, n, 1.0))


def rings(make):
    """Return a maker of two batches of polygons from a maker of two arrays of outlines."""
    return lambda rng, n: tuple(batch.Polygons(side) for side in make(rng, n))


def two(make):
    """Return a maker of two batches from a maker of one."""
    return lambda rng, n: (make(rng, n), make(rng, n))


def far(rng, n):
    """Return two batches of n quadrilaterals, 2**20 from the origin."""
    a, b = (generators.ngons(rng, n, 4, 0.9) + 2.0**20 for _ in "ab")
    return batch.Polygons(a), batch.Polygons(b)


def needles(rng, n):
    """Return n triangles of length 2 and a width of 2**-3 to 2**-20, turned at random."""
    wide, way = np.ldexp(rng.uniform(1, 2, n), -rng.integers(4, 21, n)), rng.uniform(0, 2 * np.pi, n)
    ring = np.stack([np.broadcast_to([-1.0, 1, 1], (n, 3)), wide[:, None] * [0, -1, 1]], axis=2)
    turn = np.stack([np.cos(way), -np.sin(way), np.sin(way), np.cos(way)], axis=1).reshape(n, 2, 2)
    return batch.Polygons(ring @ turn.transpose(0, 2, 1) + rng.uniform(-0.55, 0.55, (n, 1, 2)))


def strewn(rng, n):
    """Return one batch of scattered polygons and some circles."""
    return (batch.concat([batch.Polygons(generators.scattered_polygons(rng, n // 12)), discs(rng, n // 120)]),)


def stars(rng, n):
    """Return two batches of n concave stars of four points."""

    def some():
        way = np.linspace(0, 2 * np.pi, 8, endpoint=False)
        ring = np.stack([np.cos(way), np.sin(way)], axis=1) * np.where(np.arange(8) % 2, 0.5, 1.0)[:, None]
        return batch.Polygons(ring + rng.uniform(-1, 1, (n, 1, 2)), concave="split")

    return some(), some()


SCENES = {
    "upright boxes": two(upright),
    "tiles": lambda rng, n: (batch.Polygons(generators.tiles(120)),),
    "boxes turned alike": two(turned_alike),
    "hexagons on a grid": two(on_a_grid),
    "circles": two(discs),
    "circles and triangles": lambda rng, n: (discs(rng, n), batch.Polygons(generators.ngons(rng, n, 3, 1.3))),
    "triangles": rings(generators.WORKLOADS["triangles"]),
    "turned boxes": rings(generators.WORKLOADS["boxes"]),
    "8-gons": rings(generators.WORKLOADS["8-gons"]),
    "16-gons": two(lambda rng, n: batch.Polygons(generators.ngons(rng, n // 4, 16, 1.5))),
    "mixed, 3 to 8 corners": lambda rng, n: tuple(
        batch.Polygons([r[: len(np.unique(r, axis=0))] for r in generators.mixed_polygons(rng, n // 3, 1.0)])
        for _ in "ab"
    ),
    "nearly touching": rings(generators.WORKLOADS["nearly touching"]),
    "needles": two(needles),
    "far from the origin": far,
    "far from each other": lambda rng, n: tuple(batch.Polygons(generators.ngons(rng, n, 5, 900.0)) for _ in "ab"),
    "strewn, with circles": strewn,
    "stars": lambda rng, n: stars(rng, n // 8),
}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--engine", choices=("numpy", "numba"))
    parser.add_argument("--only", nargs="+", choices=SCENES, default=SCENES)
    args = parser.parse_args()
    engine = args.engine
    regrets = []
    print(f"{'scene':24} {'pairs':>7}  {'advised':22} {'ns':>7}  {'fastest right':22} {'ns':>7}  regret")
    for name in args.only:
        recommendation = sv.advise(*SCENES[name](np.random.default_rng(1), PAIRS))
        right = [j.model for j in recommendation.results if j.proven]
        pairs = recommendation.given.batches()
        found = costs(right, pairs, engine=engine, most=PAIRS, tests=math.inf, seconds=math.inf)
        best = min(found, key=lambda key: found[key].warm)
        mine, pairs = found[recommendation.model.name].warm, min(recommendation.summary.pairs, PAIRS)
        regret = mine / found[best].warm
        counts = found[EXACT_FILTER].warm * pairs > MIN_EXACT_TIME
        regrets += [regret] * counts
        print(
            f"{name:24} {recommendation.summary.pairs:7}  {recommendation.model.name:22} {mine:7.1f}  "
            f"{best:22} {found[best].warm:7.1f}  {regret:.2f}{'' if counts else ' (too little work)'}"
        )
    print(f"median regret of {len(regrets)} scenes: {statistics.median(regrets):.2f}, the most {max(regrets):.2f}")


if __name__ == "__main__":
    main()
