"""satviz bench: what work costs, satviz beside its peers on the same work in one run.

The methods are taken in turn within a round; the figure is the median over rounds.  What is
timed starts where the line says: from shapes built beforehand, or from raw arrays.  Each row says
what its answers were checked by (`BY`): the first pairs by rationals, pairs that were made to lie so
by how they were made, collisions by shapely's.  Of the broad phase only the number of pairs is compared.
"""

import subprocess
import sys
import tracemalloc
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from math import isqrt
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .. import batch
from ..advice.timing import in_turn
from . import truth
from .harness.machine import installed
from .methods import COMPILED, NUMPY, PYTHON, batched, methods, mistakes, shapes
from .workloads.workloads import CORNERS, LAYOUTS, WORKLOADS, outlines, scattered, tiles

# (language, name) of the methods that take part, and what the table calls them
BENCHED = {
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
ENGINES = {"satviz numpy": "numpy", "satviz numba": "numba"}
SIZES = (3, 4, 8, 16, 32, 64, 128, 256)  # corners
BUSY = 0.25  # quartiles so far apart, as a share of the median, tell of a busy machine

# what answers are checked by, and how a sentence says so; the method that others are held against is not checked
BY = {
    "rationals": "checked by rationals",
    "construction": "by how the pairs were made",
    "shapely": "against shapely's collisions",
    "count": "box pairs by their number alone, against shapely's",
}

Jobs = Mapping[str, Callable[[], Any]]


class Row(NamedTuple):
    """One method on one work: the time of an item (a pair, or the whole) in the section's unit, and what was wrong.

    `size`: what the section varies, 0 if nothing; `low` and `high`: quartiles; `checked`: how many answers were, and
    `by` which key of `BY`.
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


class Plan(NamedTuple):
    """How much work: pairs a workload, rounds, checked pairs, a scene's shapes, tiles a side, and the sizes varied."""

    pairs: int
    rounds: int
    seed: int
    checked: int
    scene: int
    side: int
    corners: tuple[int, ...]
    numbers: tuple[int, ...]
    boxes: tuple[int, ...]


def planned(pairs: int, rounds: int, seed: int) -> Plan:
    """What so many pairs a workload go with: a hundred thousand with scenes of thirty thousand, and up to a million."""
    tens = [10**k for k in range(1, 7) if 10**k <= 10 * pairs][-4:]
    corners = SIZES if pairs >= 10_000 else SIZES[::2]
    side, scene = min(120, isqrt(pairs) + 1), min(30_000, -(-3 * pairs // 10))
    return Plan(pairs, rounds, seed, min(2000, pairs), scene, side, corners, tuple(tens), tuple(tens[-4:-1] or tens))


def bench(plan: Plan) -> Iterator[Row]:
    """All rows, section by section."""
    for section in (_uniform, _corners, _from_arrays, _boxes, _growth, _starts, _memory):
        yield from section(plan)


def _timed(
    section: str, work: str, size: int, jobs: Jobs, items: int | Mapping[str, int], unit: str, rounds: int
) -> Iterator[Row]:
    each = dict.fromkeys(jobs, items) if isinstance(items, int) else items
    scale = {"ns": 1.0, "us": 1e3, "ms": 1e6}[unit]
    for method, times in in_turn(jobs, rounds, each).items():
        median, least, low, high = (t / scale for t in times)
        yield Row(section, work, size, method, unit, median, least, low, high)


def _judged(row: Row, said: Any, right: NDArray[np.int8], by: str) -> Row:
    said = np.asarray(said)[: len(right)]
    return row._replace(wrong=sum(mistakes(said, right).values()), checked=len(right), by=by)


# -- pairs, from shapes built beforehand -------------------------------------------------------------


def _uniform(plan: Plan) -> Iterator[Row]:
    """The workloads of pairs, each against rationals, and beside them what the machine can do at all."""
    with ThreadPoolExecutor(2) as pool:
        for work, make in WORKLOADS.items():
            a, b = make(np.random.default_rng(plan.seed), plan.pairs)
            few = [
                (s[0][: plan.checked], s[1][: plan.checked]) if isinstance(s, tuple) else s[: plan.checked]
                for s in (a, b)
            ]
            right = np.array([truth.relation(p, q) for p, q in zip(*map(shapes, few))], np.int8)
            jobs: dict[str, Callable[[], Any]] = {}
            items: dict[str, int] = {}
            for method in methods(circles=isinstance(a, tuple)):
                label = BENCHED.get((method.language, method.name))
                if label is None:
                    continue
                scalar = method.language == PYTHON
                mine = [method.prepare(side) for side in (few if scalar else (a, b))]
                jobs[label] = partial(method.hits, *mine)
                items[label] = len(right) if scalar else plan.pairs
                if label == "satviz numba":
                    shapes_of_numba = mine
                if label in ENGINES:
                    halves: dict[str, Any] = {"engine": ENGINES[label], "executor": pool, "chunk": -(-plan.pairs // 2)}
                    jobs[f"{label}, 2 threads"] = partial(batch.relate, *mine, **halves)
                    items[f"{label}, 2 threads"] = plan.pairs
            peers: dict[str, Callable[[], Any]] = {}
            if installed("numba") and not isinstance(a, tuple) and not isinstance(b, tuple) and "mixed" not in work:
                peers = _compiled(*shapes_of_numba)
            jobs |= peers
            items |= dict.fromkeys(peers, plan.pairs)
            answers = {label: job() for label, job in jobs.items()}
            for row in _timed("pairs", work, 0, jobs, items, "ns", plan.rounds):
                yield row if row.method == READING else _judged(row, answers[row.method], right, "rationals")


READING = "reading the arrays once"


def _compiled(a: batch.Shapes, b: batch.Shapes) -> dict[str, Callable[[], Any]]:
    """Textbook SAT and GJK in numba, satviz's kernel without its room for rounding, and reading alone.

    All go through the very arrays that satviz does: another's copies could lie nearer to the processor.
    """
    from ..batch.with_numba.filter import clearance_kernel
    from .methods import kernels

    columns = [c for shapes in (a, b) if (g := shapes.uniform) for c in (g.x, g.y)]
    out = np.empty(len(a), np.int8)

    def run(kernel: Callable[..., None], *more: Any) -> NDArray[np.bool_]:
        kernel(*columns, *more, out)
        return out > 0

    return {
        READING: lambda: [kernels.reading(c.ravel().view(np.int64)) for c in columns],
        "textbook SAT in numba": partial(run, kernels.textbook, True, 0.0),
        "GJK in numba": partial(run, kernels.gjk),
        "numba, no room for rounding": partial(run, clearance_kernel(a.max_corners, b.max_corners), 0, 0.0),
    }


def _corners(plan: Plan) -> Iterator[Row]:
    """Pairs of V-gons, told apart by how they lie; their relation is known from how they were made."""
    for work, (make, relation) in CORNERS.items():
        for v in plan.corners:
            n = max(plan.checked, min(plan.pairs, plan.pairs * 8 // v**2 + plan.checked))
            a, b = make(np.random.default_rng(plan.seed), n, v)
            jobs = _batches(batched(a), batched(b))
            if installed("shapely"):
                import shapely

                jobs["shapely"] = partial(shapely.intersects, *map(shapely.polygons, (a, b)))
            right = np.full(n, relation, np.int8)
            answers = {label: job() for label, job in jobs.items()}
            for row in _timed("corners", work, v, jobs, n, "ns", plan.rounds):
                yield _judged(row, answers[row.method], right, "construction")


def _batches(a: batch.Shapes, b: batch.Shapes) -> dict[str, Callable[[], Any]]:
    return {label: partial(batch.relate, a, b, engine=engine) for label, engine in ENGINES.items() if _has(engine)}


def _has(engine: str) -> bool:
    return engine == "numpy" or installed(engine)


# -- scenes, from raw arrays -------------------------------------------------------------------------


def _from_arrays(plan: Plan) -> Iterator[Row]:
    """Making shapes, and making them and finding all that collide; answers against shapely's."""
    rings = scattered(np.random.default_rng(plan.seed), plan.scene)
    each = outlines(rings)
    coords = np.concatenate(each)
    offsets = np.concatenate([[0], np.cumsum([len(ring) for ring in each])])
    ways = {
        "from offsets": partial(batch.Polygons, coords, offsets=offsets),
        "from a padded array": partial(batch.Polygons, rings),
    }
    made = {f"satviz, {way}": make for way, make in ways.items()}
    n = f"{plan.scene:,} mixed polygons"
    if installed("shapely"):
        made["shapely"] = partial(_geometries, coords, offsets)
    yield from _timed("scenes", f"making {n}", 0, made, 1, "ms", plan.rounds)
    yield from _collisions(f"making {n}, all collisions", made, plan)
    boxes = tiles(plan.side)
    made = {"satviz, from a padded array": partial(batch.Polygons, boxes)}
    if installed("shapely"):
        made["shapely"] = partial(_geometries, boxes.reshape(-1, 2), np.arange(len(boxes) + 1) * 4)
    yield from _collisions(
        f"{len(boxes):,} touching tiles, all collisions", {k: partial(_again, f()) for k, f in made.items()}, plan
    )


def _again(made: Any) -> Any:
    return made


def _made(ask: Callable[[Any], Any], make: Callable[[], Any]) -> Any:
    return ask(make())


def _collisions(work: str, made: Jobs, plan: Plan) -> Iterator[Row]:
    jobs: dict[str, Callable[[], Any]] = {}
    for label, make in made.items():
        if label == "shapely":
            jobs[label] = partial(_made, _meeting, make)
        elif "padded" in label:
            for engine in filter(_has, ENGINES.values()):
                jobs[f"satviz {engine}"] = partial(_made, partial(batch.colliding_pairs, engine=engine), make)
    answers = {label: job() for label, job in jobs.items()}
    right = answers.get("shapely")
    for row in _timed("scenes", work, 0, jobs, 1, "ms", plan.rounds):
        if right is None or row.method == "shapely":
            yield row
            continue
        wrong = len(set(map(tuple, right.tolist())) ^ set(map(tuple, answers[row.method].tolist())))
        yield row._replace(wrong=wrong, checked=len(right), by="shapely")


def _geometries(coords: NDArray[np.float64], offsets: NDArray[np.int64]) -> Any:
    import shapely

    return shapely.polygons(
        shapely.linearrings(coords, indices=np.repeat(np.arange(len(offsets) - 1), np.diff(offsets)))
    )


def _meeting(geometries: Any, predicate: str | None = "intersects") -> NDArray[np.intp]:
    """The pairs by STRtree, built and asked; without a predicate those whose boxes meet."""
    import shapely

    i, j = shapely.STRtree(geometries).query(geometries, predicate=predicate)
    once = i < j
    return np.stack([i[once], j[once]], axis=1)


def _boxes(plan: Plan) -> Iterator[Row]:
    """The broad phase, layout by layout: candidate pairs by satviz's grids and by STRtree, built and asked."""
    for work, make in LAYOUTS.items():
        for n in plan.boxes:
            bounds = make(np.random.default_rng(plan.seed), n)
            jobs: dict[str, Callable[[], Any]] = {
                label: partial(batch.candidate_pairs, bounds, engine=engine)
                for label, engine in ENGINES.items()
                if _has(engine)
            }
            if installed("shapely"):
                import shapely

                jobs["shapely"] = partial(_meeting, shapely.box(*bounds.T), None)
            found = {label: len(job()) for label, job in jobs.items()}
            right = found.get("shapely")
            for row in _timed("broad phase", work, n, jobs, 1, "ms", plan.rounds):
                if right is None or row.method == "shapely":
                    yield row
                else:
                    yield row._replace(wrong=abs(found[row.method] - right), checked=right, by="count")


# -- growth, starts, memory --------------------------------------------------------------------------


def _growth(plan: Plan) -> Iterator[Row]:
    """All collisions of more and more mixed polygons, made beforehand: what a scene costs as it grows."""
    for n in plan.numbers:
        made = batch.Polygons(scattered(np.random.default_rng(plan.seed), n))
        jobs = {
            label: partial(batch.colliding_pairs, made, engine=engine)
            for label, engine in ENGINES.items()
            if _has(engine)
        }
        rounds = plan.rounds if n < 300_000 else 3
        yield from _timed("growth", "all collisions of N mixed polygons", n, jobs, 1, "ms", rounds)


START = """
from time import perf_counter
start = perf_counter()
import numpy as np
from satviz import batch
shapes = batch.Polygons(np.array([[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]]))
batch.relate(shapes, shapes, engine="{engine}")
print((perf_counter() - start) * 1e3)
"""
PLAIN = """
from time import perf_counter
start = perf_counter()
import numpy
print((perf_counter() - start) * 1e3)
"""


def _starts(plan: Plan) -> Iterator[Row]:
    """A new process: what it takes to import satviz.batch and have the first answer, kernels already on disk."""
    sources = {"import numpy": PLAIN} | {label: START.format(engine=e) for label, e in ENGINES.items() if _has(e)}
    for label, source in sources.items():
        runs = [
            subprocess.run([sys.executable, "-c", source], capture_output=True, check=True)
            for _ in range(plan.rounds + 1)
        ]
        times = sorted(float(run.stdout) for run in runs[1:])
        quarter = len(times) // 4
        yield Row(
            "starts",
            "the first answer of a new process",
            0,
            label,
            "ms",
            times[len(times) // 2],
            times[0],
            times[quarter],
            times[-1 - quarter],
        )


def _memory(plan: Plan) -> Iterator[Row]:
    """Bytes a shape that stay, and bytes a shape at the peak of each work beyond them."""
    rings = scattered(np.random.default_rng(plan.seed), plan.scene)
    for label, engine in ENGINES.items():
        if not _has(engine):
            continue
        batch.colliding_pairs(batch.Polygons(rings), engine=engine)  # what is loaded once is not this work's
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
            each = total / plan.scene
            yield Row("memory", work, 0, label, "bytes a shape", each, each, each, each)


# -- what is printed ---------------------------------------------------------------------------------


def table(rows: list[Row]) -> str:
    """The rows as text, section by section: each time beside its ratio to shapely's on the same work."""
    lines = []
    for section in dict.fromkeys(row.section for row in rows):
        mine = [row for row in rows if row.section == section]
        lines += _by_size(mine) if any(row.size for row in mine) else _by_method(mine)
        lines.append("")
    return "\n".join(lines)


def _by_method(rows: list[Row]) -> list[str]:
    lines = []
    for work in dict.fromkeys(row.work for row in rows):
        block = sorted((row for row in rows if row.work == work), key=lambda row: row.time)
        base = next((row.time for row in block if row.method == "shapely"), None)
        most = max(row.checked for row in block)
        unit = block[0].unit if block[0].section != "pairs" else "ns a pair"
        lines.append(
            f"{work:40}{unit:>14}{'quartiles':>20}{'x shapely':>11}" + (f"   wrong of {most:,}" if most else "")
        )
        for row in block:
            ratio = f"{base / row.time:.1f}" if base else ""
            wrong = f"{row.wrong:8}" if row.checked else ""
            lines.append(f"  {row.method:38}{row.time:14.1f}{row.low:10.1f}{row.high:10.1f}{ratio:>11}{wrong}")
        lines.append("")
    return lines[:-1]


def _by_size(rows: list[Row]) -> list[str]:
    """A line a work and method, a column a size, and how it grows over the last three sizes."""
    sizes = list(dict.fromkeys(row.size for row in rows))
    section, unit = rows[0].section, rows[0].unit
    lines = [f"{section + ', ' + unit:52}" + "".join(f"{n:>10,}" for n in sizes) + f"{'growth':>8}"]
    for work, method in dict.fromkeys((row.work, row.method) for row in rows):
        times = {row.size: row.time for row in rows if (row.work, row.method) == (work, method)}
        line = "".join(f"{times[n]:10.1f}" for n in sizes)
        lines.append(f"  {work + ', ' + method:50}{line}{slope(times):8.2f}")
    return [*lines, f"  wrong: {wrong}"] if (wrong := checked(rows)) else lines


def checked(rows: Sequence[Row]) -> str:
    """How many answers were wrong of how many, told apart by what they were checked by."""
    parts = []
    for by, words in BY.items():
        mine = [row for row in rows if row.by == by]
        if mine:
            wrong, of = sum(row.wrong for row in mine), sum(row.checked for row in mine)
            parts.append(f"{wrong:,} of {of:,} {words}")
    return ", ".join(parts)


def slope(times: Mapping[int, float]) -> float:
    """The exponent with which times grow over the last three sizes (least squares of the logarithms)."""
    last = sorted(times)[-3:]
    x, y = np.log(last), np.log([times[n] for n in last])
    return (
        float(((x - x.mean()) * (y - y.mean())).sum() / ((x - x.mean()) ** 2).sum()) if len(last) > 1 else float("nan")
    )


def busy(rows: list[Row]) -> str:
    """A warning where the times of one round and the next differ much: the machine did other things too."""
    timed = [row for row in rows if row.section not in ("memory", "starts")]
    apart = [row for row in timed if row.high - row.low > BUSY * row.time]
    if len(apart) * 4 <= len(timed):
        return ""
    return (
        f"rough figures: {len(apart)} of {len(timed)} have quartiles more than {BUSY:.0%} apart; the machine was busy"
    )


def when_numba_pays(rows: list[Row]) -> str:
    """What numba's start costs a new process, against what it saves a pair."""
    ns = {row.method: row.time for row in rows if (row.section, row.work) == ("pairs", "triangles")}
    ms = {row.method: row.time for row in rows if row.section == "starts"}
    saved, cost = ns["satviz numpy"] - ns["satviz numba"], ms["satviz numba"] - ms["satviz numpy"]
    if saved <= 0:
        return f"numba starts {cost:.0f} ms later and saved nothing on triangles here"
    pays = f"it pays from {cost / saved:.1f} million pairs on"
    return f"numba starts {cost:.0f} ms later and saves {saved:.0f} ns a pair of triangles: {pays}"
