"""satviz bench: measure what work costs, satviz beside other libraries and rival methods, on the same work in one run.

All methods for one work are run once in each round, and the figure is the median over the rounds.  The name of a work
says where its time begins: with shapes that are made already, or with raw arrays.  Each row also says how its answers
were checked (`CHECKED_BY`).  Each `_bench_...` measures one section and yields its rows.
"""

import subprocess
import sys
import tracemalloc
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from math import isqrt
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .. import batch
from ..advice.timing import spread, time_in_turn
from .harness.machine import is_installed
from .methods import (
    COMPILED,
    ENGINES,
    NUMPY,
    PYTHON,
    all_methods,
    batch_shapes,
    count_mistakes,
    installed_engines,
    true_relations,
)
from .methods.libraries import tree_pairs
from .methods.scene_methods import FrameJob, FrameSample, scene_methods
from .workloads.generators import (
    BOX_LAYOUTS,
    CORNER_WORKLOADS,
    WORKLOADS,
    Side,
    scattered_polygons,
    tiles,
    turned_boxes,
    unpadded_rings,
)
from .workloads.moving import MOVING_SHAPES, moving_scene, uneven_boxes

# (language, name) of the methods that take part, and their names in the table
BENCHED_METHODS = {
    (NUMPY, "satviz"): "satviz numpy",
    (COMPILED, "satviz"): "satviz numba",
    (NUMPY, "SAT, unit normals"): "plain NumPy",
    (COMPILED, "shapely"): "shapely",
    (COMPILED, "shapely, prepared"): "shapely, prepared",
    (PYTHON, "satviz"): "satviz.relate",
    (PYTHON, "GJK"): "GJK in Python",
    (PYTHON, "shapely"): "shapely, one by one",
    (PYTHON, "pymunk"): "pymunk, one by one",
}
CORNER_COUNTS = (3, 4, 8, 16, 32, 64, 128, 256)
FRAME_SECTIONS = "frames", "arrays"
FRAME_SIZES = 10, 30, 100, 300, 1000, 3000, 10_000, 30_000, 100_000, 1_000_000
MAX_SAMPLE = 300  # shapes of a frame whose pairs are all checked
READ_ONCE = "reading the arrays once"
PLAIN_SAT = "plain SAT in numba"

# what the answers are compared with, and the words for that in a sentence; what others are compared with has no entry
CHECKED_BY = {
    "rationals": "checked by two exact oracles",
    "construction": "by how the pairs were made",
    "shapely": "against shapely's collisions",
    "count": "box pairs by their number alone, against shapely's",
}

Jobs = dict[str, Callable[[], Any]]  # by method: a function without arguments that does the work and returns answers


class TimingRow(NamedTuple):
    """One row of the benchmark: the time that one method took for one item of one work, and its wrong answers.

    An item is a pair or the whole work.  `time` (the median), `least`, `low` and `high` (the quartiles) are in `unit`.
    `size` is the number that the section varies, 0 if it varies none.  `wrong` of `checked` answers were wrong, checked
    by the key `by` of `CHECKED_BY`; 0 and empty where nothing was checked.
    """

    section: str
    work: str
    size: int
    method: str
    unit: str
    time: float
    least: float
    low: float
    high: float
    wrong: int = 0
    checked: int = 0
    by: str = ""


class BenchPlan(NamedTuple):
    """The amount of work of the benchmark: pairs of a workload, rounds, checked pairs, and sizes of other sections.

    `scene`: polygons in a scene; `side`: tiles along one side of a map; `corners`, `numbers` and `boxes`: the numbers
    of corners, of polygons and of boxes that are varied; `frames`: the numbers of moving shapes.
    """

    pairs: int
    rounds: int
    seed: int
    checked: int
    scene: int
    side: int
    corners: tuple[int, ...]
    numbers: tuple[int, ...]
    boxes: tuple[int, ...]
    frames: tuple[int, ...]


def plan_bench(pairs: int, rounds: int, seed: int) -> BenchPlan:
    """Return the BenchPlan for a number of pairs; the sizes of all other sections follow from that number."""
    powers = tuple(10**k for k in range(1, 7) if 10**k <= 10 * pairs)[-4:]
    corners = CORNER_COUNTS if pairs >= 10_000 else CORNER_COUNTS[::2]
    side, scene = min(120, isqrt(pairs) + 1), min(30_000, -(-3 * pairs // 10))
    boxes, frames = powers[-4:-1] or powers, tuple(n for n in FRAME_SIZES if n <= max(10, 10 * pairs))
    return BenchPlan(pairs, rounds, seed, min(2000, pairs), scene, side, corners, powers, boxes, frames)


def bench(plan: BenchPlan) -> Iterator[TimingRow]:
    """Measure every section of the plan in turn and yield its rows."""
    yield from _bench_pairs(plan)
    yield from _bench_corners(plan)
    yield from _bench_scenes(plan)
    yield from _bench_broad_phase(plan)
    yield from _bench_growth(plan)
    yield from _bench_frames(plan)
    yield from _bench_hits(plan)
    yield from _bench_uneven(plan)
    yield from _bench_starts(plan)
    yield from _bench_memory(plan)


def _time_jobs(
    section: str, work: str, size: int, jobs: Jobs, items: int | Mapping[str, int], unit: str, rounds: int
) -> Iterator[TimingRow]:
    """Time the jobs in turn and yield a row for each, in `unit`: ns, us or ms an item.

    `items`: how many items each job does, one number for all or by the job's name.
    """
    items_of = dict.fromkeys(jobs, items) if isinstance(items, int) else items
    nanoseconds = {"ns": 1.0, "us": 1e3, "ms": 1e6}[unit]
    for method, times in time_in_turn(jobs, rounds, items_of).items():
        median, least, low, high = (t / nanoseconds for t in times)
        yield TimingRow(section, work, size, method, unit, median, least, low, high)


def _with_wrong_count(row: TimingRow, answers: Any, right: NDArray[np.int8], by: str) -> TimingRow:
    """Return the row with its wrong answers counted; `right`: true relations of the first ones; by: see CHECKED_BY."""
    answers = np.asarray(answers)[: len(right)]
    return row._replace(wrong=sum(count_mistakes(answers, right).values()), checked=len(right), by=by)


# -- pairs, from shapes made beforehand --------------------------------------------------------------


def _bench_pairs(plan: BenchPlan) -> Iterator[TimingRow]:
    """Time every method on each workload of pairs, and time one pass over the arrays, which is a lower bound.

    The first `plan.checked` answers of each method are compared with the exact relations.
    """
    with ThreadPoolExecutor(2) as pool:
        for work, make in WORKLOADS.items():
            a, b = make(np.random.default_rng(plan.seed), plan.pairs)
            first = [_first_shapes(side, plan.checked) for side in (a, b)]
            right = true_relations(*first)
            jobs: Jobs = {}
            items: dict[str, int] = {}
            for method in all_methods(circles=isinstance(a, tuple)):
                label = BENCHED_METHODS.get((method.language, method.name))
                if label is None:
                    continue
                one_by_one = method.language == PYTHON
                prepared = [method.prepare(side) for side in (first if one_by_one else (a, b))]
                jobs[label] = partial(method.hits, *prepared)
                items[label] = len(right) if one_by_one else plan.pairs
                if label == "satviz numba":
                    numba_shapes = prepared
                if label in ENGINES:
                    halves: dict[str, Any] = {"engine": ENGINES[label], "executor": pool, "chunk": -(-plan.pairs // 2)}
                    jobs[f"{label}, 2 threads"] = partial(batch.relate, *prepared, **halves)
                    items[f"{label}, 2 threads"] = plan.pairs
            peers: Jobs = {}
            if is_installed("numba") and not isinstance(a, tuple) and not isinstance(b, tuple) and "mixed" not in work:
                peers = _numba_peers(*numba_shapes)
            jobs |= peers
            items |= dict.fromkeys(peers, plan.pairs)
            answers = {label: job() for label, job in jobs.items()}
            for row in _time_jobs("pairs", work, 0, jobs, items, "ns", plan.rounds):
                if row.method != READ_ONCE:
                    row = _with_wrong_count(row, answers[row.method], right, "rationals")
                yield row


def _first_shapes(side: Side, n: int) -> Side:
    """Return the first n shapes of a workload's side: (N, V, 2) rings, or (centers, radii)."""
    return (side[0][:n], side[1][:n]) if isinstance(side, tuple) else side[:n]


def _numba_peers(a: batch.Shapes, b: batch.Shapes) -> Jobs:
    """Return jobs in numba for pairs of these shapes: plain SAT, GJK and reading alone, as fast as we could write them.

    All of them read the very arrays that satviz reads: another copy could be nearer to the processor.
    """
    from .methods import numba_rivals

    columns = [c for shapes in (a, b) if (g := shapes.uniform) for c in (g.x, g.y)]
    va, vb = a.max_corners, b.max_corners
    out = np.empty(len(a), np.int8)

    def run(kernel: Callable[..., None]) -> NDArray[np.bool_]:
        """Return the (n,) answers of a kernel: True for each pair that hits."""
        kernel(*columns, out)
        return out > 0

    return {
        READ_ONCE: lambda: [numba_rivals.read_once(c.ravel().view(np.int64)) for c in columns],
        "SAT in numba": partial(run, numba_rivals.plain_sat(va, vb)),
        "GJK in numba": partial(run, numba_rivals.gjk_kernel(*map(numba_rivals.unrolled, (va, vb)))),
    }


def _bench_corners(plan: BenchPlan) -> Iterator[TimingRow]:
    """Time pairs of V-gons that were made apart, overlapping or touching, checked by how they were made."""
    for work, (make, relation) in CORNER_WORKLOADS.items():
        for v in plan.corners:
            n = max(plan.checked, min(plan.pairs, plan.pairs * 8 // v**2 + plan.checked))
            a, b = make(np.random.default_rng(plan.seed), n, v)
            jobs = _engine_jobs(batch.relate, batch_shapes(a), batch_shapes(b))
            if is_installed("shapely"):
                import shapely

                jobs["shapely"] = partial(shapely.intersects, *map(shapely.polygons, (a, b)))
            right = np.full(n, relation, np.int8)
            answers = {label: job() for label, job in jobs.items()}
            for row in _time_jobs("corners", work, v, jobs, n, "ns", plan.rounds):
                yield _with_wrong_count(row, answers[row.method], right, "construction")


def _engine_jobs(function: Callable[..., Any], *arguments: Any) -> Jobs:
    """Return for each installed engine, by its name in the table, a job that calls function(*arguments, engine=...)."""
    return {label: partial(function, *arguments, engine=engine) for label, engine in installed_engines()}


# -- scenes, from raw arrays -------------------------------------------------------------------------


def _bench_scenes(plan: BenchPlan) -> Iterator[TimingRow]:
    """Time making shapes, making them and finding all collisions, and the collisions of touching tiles."""
    rings = scattered_polygons(np.random.default_rng(plan.seed), plan.scene)
    unpadded = unpadded_rings(rings)
    coords = np.concatenate(unpadded)
    offsets = np.concatenate([[0], np.cumsum([len(ring) for ring in unpadded])])
    makers: Jobs = {
        "satviz, from offsets": partial(batch.Polygons, coords, offsets=offsets),
        "satviz, from a padded array": partial(batch.Polygons, rings),
    }
    if is_installed("shapely"):
        makers["shapely"] = partial(_shapely_polygons, coords, offsets)
    making = f"making {plan.scene:,} mixed polygons"
    yield from _time_jobs("scenes", making, 0, makers, 1, "ms", plan.rounds)
    padded, shapely_maker = makers["satviz, from a padded array"], makers.get("shapely")
    yield from _time_collisions(f"{making}, all collisions", padded, shapely_maker, plan)
    boxes = tiles(plan.side)
    made = batch.Polygons(boxes)
    if shapely_maker:
        geometries = _shapely_polygons(boxes.reshape(-1, 2), np.arange(len(boxes) + 1) * 4)
    work = f"{len(boxes):,} touching tiles, all collisions"
    yield from _time_collisions(work, lambda: made, (lambda: geometries) if shapely_maker else None, plan)


def _time_collisions(
    work: str, make: Callable[[], batch.Shapes], shapely_make: Callable[[], Any] | None, plan: BenchPlan
) -> Iterator[TimingRow]:
    """Time finding all collisions of the shapes that `make` returns, checked by shapely's where it is installed."""

    def make_and_collide(*, engine: str) -> NDArray[np.intp]:
        """Return the colliding pairs of the shapes that `make` returns, found by this engine."""
        return batch.colliding_pairs(make(), engine=engine)

    jobs = _engine_jobs(make_and_collide)
    if shapely_make:
        jobs["shapely"] = lambda: tree_pairs(shapely_make(), predicate="intersects")
    answers = {label: job() for label, job in jobs.items()}
    right = answers.get("shapely")
    for row in _time_jobs("scenes", work, 0, jobs, 1, "ms", plan.rounds):
        yield row if row.method == "shapely" else _with_wrong_pairs(row, answers[row.method], right)


def _with_wrong_pairs(row: TimingRow, pairs: NDArray[np.intp], right: NDArray[np.intp] | None) -> TimingRow:
    """Return the row with its wrong pairs counted: those in only one of `pairs` and shapely's `right`, if any."""
    if right is None:
        return row
    wrong = len(set(map(tuple, right.tolist())) ^ set(map(tuple, pairs.tolist())))
    return row._replace(wrong=wrong, checked=len(right), by="shapely")


def _shapely_polygons(coords: NDArray[np.float64], offsets: NDArray[np.int64]) -> Any:
    """Return shapely polygons from the (M, 2) corners of all outlines and their (N + 1,) offsets."""
    import shapely

    return shapely.polygons(
        shapely.linearrings(coords, indices=np.repeat(np.arange(len(offsets) - 1), np.diff(offsets)))
    )


def _bench_broad_phase(plan: BenchPlan) -> Iterator[TimingRow]:
    """Time finding the pairs of boxes that meet, by satviz's grids and by STRtree, checked by their number alone."""
    for work, make in BOX_LAYOUTS.items():
        for n in plan.boxes:
            boxes = make(np.random.default_rng(plan.seed), n)
            jobs = _engine_jobs(batch.candidate_pairs, boxes)
            if is_installed("shapely"):
                import shapely

                jobs["shapely"] = partial(tree_pairs, shapely.box(*boxes.T))
            found = {label: len(job()) for label, job in jobs.items()}
            right = found.get("shapely")
            for row in _time_jobs("broad phase", work, n, jobs, 1, "ms", plan.rounds):
                if right is not None and row.method != "shapely":
                    row = row._replace(wrong=abs(found[row.method] - right), checked=right, by="count")
                yield row


# -- frames: moving shapes, from raw arrays ----------------------------------------------------------


def _bench_frames(plan: BenchPlan) -> Iterator[TimingRow]:
    """Time the work from the raw arrays of a frame to all colliding pairs, for growing numbers of moving shapes."""
    for work, make in MOVING_SHAPES.items():
        for n in plan.frames:
            rng = np.random.default_rng(plan.seed)
            scene = moving_scene(rng, make(rng, n))
            repeats = min(30, max(1, 1000 // n))  # so that a call takes long enough to be timed
            jobs = {name: FrameJob(find, scene, repeats) for name, find in scene_methods(scene).items()}
            rounds = plan.rounds if n < 30_000 else min(plan.rounds, 3)
            samples: dict[int, FrameSample] = {}
            for row in _time_jobs("frames", work, n, dict(jobs), repeats, "us", rounds):
                job = jobs[row.method]
                sample = samples.get(job.frame) or FrameSample(scene.frames[job.frame], min(plan.checked, MAX_SAMPLE))
                samples[job.frame] = sample
                yield row._replace(wrong=sample.wrong(job.answer), checked=sample.checked, by="rationals")


def _bench_hits(plan: BenchPlan) -> Iterator[TimingRow]:
    """Time the work from two raw arrays of boxes to the answers, and plain SAT, which validates nothing.

    Answers are checked by two exact oracles.
    """
    rng = np.random.default_rng(plan.seed)
    a, b = turned_boxes(rng, plan.pairs, 1.7), turned_boxes(rng, plan.pairs, 1.7)
    labels = BENCHED_METHODS | {(COMPILED, "SAT, raw normals"): PLAIN_SAT}
    jobs: Jobs = {label: partial(m.from_arrays, a, b) for m in all_methods()
                  if (label := labels.get((m.language, m.name))) in (*ENGINES, PLAIN_SAT)}  # fmt: skip
    right = true_relations(a[: plan.checked], b[: plan.checked])
    answers = {label: job() for label, job in jobs.items()}
    for row in _time_jobs("arrays", f"hits of {plan.pairs:,} pairs of boxes", 0, jobs, plan.pairs, "ns", plan.rounds):
        yield _with_wrong_count(row, answers[row.method], right, "rationals")


def _bench_uneven(plan: BenchPlan) -> Iterator[TimingRow]:
    """Time all collisions of boxes from a raw array; and where one is much larger, or far away.

    The three works are timed in turn with each other, since their ratio is what counts.
    """
    works = uneven_boxes(np.random.default_rng(plan.seed), plan.pairs)

    def collide(boxes: NDArray[np.float64], *, engine: str) -> NDArray[np.intp]:
        """Return the colliding pairs of these boxes."""
        return batch.colliding_pairs(batch.Polygons(boxes), engine=engine)

    jobs = {
        f"{label}, {work}": job for work, boxes in works.items() for label, job in _engine_jobs(collide, boxes).items()
    }
    answers, right = {name: job() for name, job in jobs.items()}, dict[str, NDArray[np.intp]]()
    if is_installed("shapely"):
        import shapely

        right = {work: tree_pairs(shapely.polygons(boxes), predicate="intersects") for work, boxes in works.items()}
    for row in _time_jobs("arrays", f"{plan.pairs:,} boxes, all collisions", 0, jobs, 1, "ms", min(plan.rounds, 5)):
        yield _with_wrong_pairs(row, answers[row.method], right.get(row.method.partition(", ")[2]))


# -- growth, starts, memory --------------------------------------------------------------------------


def _bench_growth(plan: BenchPlan) -> Iterator[TimingRow]:
    """Time finding all collisions of N mixed polygons that are made beforehand, for growing N."""
    for n in plan.numbers:
        made = batch.Polygons(scattered_polygons(np.random.default_rng(plan.seed), n))
        jobs = _engine_jobs(batch.colliding_pairs, made)
        rounds = plan.rounds if n < 300_000 else 3
        yield from _time_jobs("growth", "all collisions of N mixed polygons", n, jobs, 1, "ms", rounds)


BATCH_START_SOURCE = """
from time import perf_counter
start = perf_counter()
import numpy as np
from satviz import batch
shapes = batch.Polygons(np.array([[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]]))
batch.relate(shapes, shapes, engine="{engine}")
print((perf_counter() - start) * 1e3)
"""
NUMPY_START_SOURCE = """
from time import perf_counter
start = perf_counter()
import numpy
print((perf_counter() - start) * 1e3)
"""


def _bench_starts(plan: BenchPlan) -> Iterator[TimingRow]:
    """Time a new process from its first import to the first answer of each engine, and importing NumPy alone."""
    sources = {"import numpy": NUMPY_START_SOURCE}
    sources |= {label: BATCH_START_SOURCE.format(engine=engine) for label, engine in installed_engines()}
    for label, source in sources.items():
        runs = [
            subprocess.run([sys.executable, "-c", source], capture_output=True, check=True)
            for _ in range(plan.rounds + 1)
        ]
        times = sorted(float(run.stdout) for run in runs[1:])
        yield TimingRow("starts", "the first answer of a new process", 0, label, "ms", *spread(times))


def _bench_memory(plan: BenchPlan) -> Iterator[TimingRow]:
    """Measure the bytes for each shape that are kept after each work, and those at the peak of the work."""
    rings = scattered_polygons(np.random.default_rng(plan.seed), plan.scene)
    for label, engine in installed_engines():
        batch.colliding_pairs(batch.Polygons(rings), engine=engine)  # so that what is loaded only once is not counted
        tracemalloc.start()
        try:
            made = batch.Polygons(rings)
            kept, peak = tracemalloc.get_traced_memory()
            figures = {"mixed polygons, kept": kept, "making them, at the peak": peak}
            tracemalloc.reset_peak()
            batch.colliding_pairs(made, engine=engine)
            kept, peak = tracemalloc.get_traced_memory()
            figures |= {"kept after all collisions": kept, "all collisions, at the peak": peak}
        finally:
            tracemalloc.stop()
        for work, total in figures.items():
            a_shape = total / plan.scene
            yield TimingRow("memory", work, 0, label, "bytes a shape", a_shape, a_shape, a_shape, a_shape)
