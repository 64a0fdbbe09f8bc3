"""Each optimisation as work to do twice, without it and with it, on a scene where it helps and where it does not."""

from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from importlib.util import find_spec
from itertools import combinations, pairwise
from typing import Any, NamedTuple

import numpy as np

from .. import batch
from ..engine.axes import Axis, Choice, Chooser, edge_normals, needed
from ..engine.geometry import Relation
from ..engine.sat import AxisTest, axis_tests
from ..engine.shapes import Polygon
from ..engine.verdict import relate
from .doing_less import KINDS
from .moving import along, between_centers, last_first
from .workloads import boxes, ngons

Rng = np.random.Generator
Pair = tuple[Polygon, Polygon]
Make = Callable[[Rng], Pair]
Job = Callable[[], Any]
APART, _, OVERLAPPING = Relation
THREADS = 2
SAME, OTHER = "regular 8-gons, same turn", "regular 8-gons, other turn"
SETUPS = 3  # times that the set-up is measured, each on shapes just made


class Work(NamedTuple):
    """The same pairs (`items` of them) without the optimisation and with it; each gives its dot products, if any.

    `setup`: what is worked out once for shapes that have just been made.
    `pool`: the threads of the optimised job, for whoever had the work built to close.
    """

    without: Job
    optimised: Job
    items: int
    setup: Job
    pool: ThreadPoolExecutor | None = None


class Case(NamedTuple):
    """An optimisation on a scene, `helps` being what is expected there; `build(rng, size)` makes the work.

    `counted`: does it save dot products?  Threads only share them out.
    """

    optimisation: str
    scene: str
    helps: bool
    build: Callable[[Rng, int], Work]
    sizes: tuple[int, int] = (60, 300)  # quick, full
    counted: bool = True


def search(a: Polygon, b: Polygon, axes: Sequence[Axis], *, to_the_end: bool = False) -> tuple[int, AxisTest | None]:
    """The dot products of the loop over these axes, and the test that separates, where it ends."""
    tests, separating = 0, None
    for test in axis_tests(a, b, axes):
        tests += 1
        if test.gap > 0:
            separating = test
            if not to_the_end:
                break
    return tests * (len(a.corners) + len(b.corners)), separating


def own_normals(choice: Choice) -> tuple[Axis, ...]:
    """The axes of a choice and those spared because the other shape has parallel ones: each shape's own, once."""
    spared: dict[int, Axis] = {}
    for axis, _, number in choice.skipped:
        if number and axis.source.shape != choice.axes[number - 1].source.shape:
            spared.setdefault(number, axis)
    return choice.axes + tuple(spared.values())


def _random(v: int, spread: float, rng: Rng) -> Pair:
    return Polygon(ngons(rng, 1, v, spread)[0]), Polygon(ngons(rng, 1, v, spread)[0])


def _just_apart(rng: Rng) -> Pair:
    """32-gons a few hundredths of their size apart: few of their axes show it."""
    turn = rng.uniform(0, 2 * np.pi)
    away = rng.uniform(1.95, 2.05) * np.array([np.cos(turn), np.sin(turn)])
    return Polygon(ngons(rng, 1, 32, 0.0)[0]), Polygon(ngons(rng, 1, 32, 0.0)[0] + away)


def _pairs(rng: Rng, n: int, make: Make, relation: Relation) -> list[Pair]:
    found: list[Pair] = []
    while len(found) < n:
        a, b = make(rng)
        if relate(a, b) is relation:
            found.append((a, b))
    return found


def _first_use(pairs: Iterable[Pair]) -> Job:
    """Choosing axes for shapes just made: their exact directions are worked out, and kept."""
    rings = [(a.vertices, b.vertices) for a, b in pairs]
    fresh = iter([[(Polygon(p), Polygon(q)) for p, q in rings] for _ in range(SETUPS)])
    return lambda: [needed(a, b) for a, b in next(fresh)]


def _chosen(pairs: Iterable[Pair]) -> list[tuple[Polygon, Polygon, tuple[Axis, ...]]]:
    return [(a, b, needed(a, b).axes) for a, b in pairs]


def _loop(scenes: Sequence[tuple[Polygon, Polygon, tuple[Axis, ...]]], **options: bool) -> Job:
    """The axes of each pair are at hand."""
    return lambda: sum(search(a, b, axes, **options)[0] for a, b, axes in scenes)


def _choosing(pairs: Sequence[Pair], choose: Chooser) -> Job:
    """The axes are chosen anew for each pair, as `record` does."""
    return lambda: sum(search(a, b, choose(a, b).axes)[0] for a, b in pairs)


def _parallel(make: Make, rng: Rng, n: int) -> Work:
    pairs = _pairs(rng, n, make, OVERLAPPING)
    return Work(_choosing(pairs, edge_normals), _choosing(pairs, needed), n, _first_use(pairs))


def _same_orientation(kind: str, rng: Rng, n: int) -> Work:
    """Against each shape's own normals, which can be kept with it: what two shapes share takes a look at both."""
    pairs = _pairs(rng, n, KINDS[kind], OVERLAPPING)
    own = [(a, b, own_normals(needed(a, b))) for a, b in pairs]
    return Work(_loop(own), _choosing(pairs, needed), n, _first_use(pairs))


def _early_exit(relation: Relation, rng: Rng, n: int) -> Work:
    pairs = _pairs(rng, n, partial(_random, 8, 1.5), relation)
    known = _chosen(pairs)
    return Work(_loop(known, to_the_end=True), _loop(known), n, _first_use(pairs))


def _order(make: Make, relation: Relation, rng: Rng, n: int) -> Work:
    """Sorted along the line of centers, which is at hand; the sort's own dot products count."""
    pairs = _pairs(rng, n, make, relation)
    known = _chosen(pairs)
    ways = [between_centers(a, b) for a, b in pairs]

    def ordered() -> int:
        scenes = zip(known, ways, strict=True)
        return sum(len(axes) + search(a, b, along(axes, *way))[0] for (a, b, axes), way in scenes)

    return Work(_loop(known), ordered, n, _first_use(pairs))


def _last_axis(aside: float, rng: Rng, n: int) -> Work:
    """n frames of one scene: two 8-gons, B going by at a distance of `aside`."""
    a, b = ngons(rng, 2, 8, 0.0)
    pairs = [(Polygon(a), Polygon(np.add(b, (x, aside)))) for x in np.linspace(-0.7, 0.7, n).tolist()]
    frames = _chosen(pairs)

    def warm() -> int:
        last, total = None, 0
        for a, b, axes in frames:
            dots, test = search(a, b, last_first(axes, last))
            last = test.source if test else last
            total += dots
        return total

    return Work(_loop(frames), warm, n, _first_use(pairs))


def _broad(spread: float, rng: Rng, n: int) -> Work:
    """All pairs of n boxes, against those whose bounds meet on the grid; to compare bounds takes no dot product."""
    shapes = [Polygon(ring) for ring in boxes(rng, n, spread * n**0.5)]
    known = {(i, j): (shapes[i], shapes[j], needed(shapes[i], shapes[j]).axes) for i, j in combinations(range(n), 2)}

    def gridded() -> int:
        found = batch.candidate_pairs([shape.bounds for shape in shapes]).tolist()
        return sum(search(*known[i, j])[0] for i, j in found)

    return Work(_loop(list(known.values())), gridded, len(known), _first_use(pairwise(shapes)))


def _threads(rng: Rng, n: int) -> Work:
    """Plain Python: `relate` on triangles, all in one thread or halves in two."""
    rings = list(zip(*(ngons(rng, n, 3, 0.9).tolist() for _ in "AB"), strict=True))
    pairs = [(Polygon(p), Polygon(q)) for p, q in rings]
    half, pool = -(-n // THREADS), ThreadPoolExecutor(THREADS)

    def some(mine: Sequence[Pair]) -> list[Relation]:
        return [relate(a, b) for a, b in mine]

    return Work(
        lambda: some(pairs),
        lambda: list(pool.map(some, (pairs[:half], pairs[half:]))),
        n,
        lambda: [(Polygon(p), Polygon(q)) for p, q in rings],
        pool,
    )


def _batch_threads(engine: str, v: int, rng: Rng, n: int) -> Work:
    """The batch on v-gons, in one thread or halves in two."""
    rings = [ngons(rng, n, v, 0.3 * v - 0.2) for _ in "AB"]
    a, b = (batch.Polygons(ring) for ring in rings)
    half, pool = -(-n // THREADS), ThreadPoolExecutor(THREADS)
    return Work(
        lambda: batch.hits(a, b, engine=engine),
        lambda: batch.hits(a, b, engine=engine, executor=pool, chunk=half),
        n,
        lambda: [batch.Polygons(ring) for ring in rings],
        pool,
    )


def cases() -> list[Case]:
    """Every optimisation, first where it is meant to help; numba only where it is installed."""
    triangles, octagons = partial(_random, 3, 0.6), partial(_random, 8, 1.5)
    few, many = (30, 200), (40_000, 500_000)
    threads = f"{THREADS} threads"
    # compiled triangles wait for the memory, which both threads share
    numba = [
        Case(threads, "numba, 8-gons", True, partial(_batch_threads, "numba", 8), (100_000, 1_000_000), False),
        Case(threads, "numba, triangles", False, partial(_batch_threads, "numba", 3), (200_000, 2_000_000), False),
    ]
    return [
        Case("skip parallel edges", "boxes that overlap", True, partial(_parallel, KINDS["boxes, other orientation"])),
        Case("skip parallel edges", "triangles that overlap", False, partial(_parallel, triangles)),
        Case("same shape and orientation", "8-gons in one orientation", True, partial(_same_orientation, SAME)),
        Case("same shape and orientation", "8-gons in two orientations", False, partial(_same_orientation, OTHER)),
        Case("early exit", "8-gons apart", True, partial(_early_exit, APART)),
        Case("early exit", "8-gons that overlap", False, partial(_early_exit, OVERLAPPING)),
        Case("order along the centers", "32-gons just apart", True, partial(_order, _just_apart, APART), few),
        Case("order along the centers", "triangles apart", False, partial(_order, partial(_random, 3, 1.5), APART)),
        Case("order along the centers", "8-gons that overlap", False, partial(_order, octagons, OVERLAPPING)),
        Case("last axis first", "8-gon passing another", True, partial(_last_axis, 2.0)),
        Case("last axis first", "8-gon passing through", False, partial(_last_axis, 0.2)),
        Case("broad phase", "boxes spread out", True, partial(_broad, 1.5), (60, 250)),
        Case("broad phase", "boxes in one heap", False, partial(_broad, 0.0), (40, 100)),
        *(numba if find_spec("numba") else []),
        Case(threads, "NumPy, triangles", True, partial(_batch_threads, "numpy", 3), many, False),
        Case(threads, "NumPy, 500 triangles", False, partial(_batch_threads, "numpy", 3), (500, 500), False),
        Case(threads, "relate, plain Python", False, _threads, (500, 5000), False),
    ]
