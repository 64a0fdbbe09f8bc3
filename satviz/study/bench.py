"""satviz bench: nanoseconds a pair and wrong answers, satviz beside its peers on the same pairs in one run.

The methods are taken in turn within a round; the figure is the median over rounds.
Shapes are built beforehand.  Wrong answers are counted against rationals, on the
first pairs of each workload; methods one pair at a time are timed on those too.
"""

import statistics
import subprocess
import sys
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .. import batch
from . import truth
from .machine import installed
from .methods import methods, mistakes, shapes
from .timing import in_turn
from .workloads import LAYOUTS, WORKLOADS

# (form, name) of the methods that take part, and what the table calls them
BENCHED = {
    ("batch", "satviz numpy"): "satviz numpy",
    ("batch", "satviz numba"): "satviz numba",
    ("batch", "SAT, unit normals"): "plain NumPy",
    ("batch", "shapely"): "shapely",
    ("batch", "shapely, prepared"): "shapely, prepared",
    ("scalar", "satviz.relate"): "satviz.relate",
    ("scalar", "shapely"): "shapely, one by one",
    ("scalar", "pymunk"): "pymunk, one by one",
}
THREADED = {"satviz numpy": "numpy", "satviz numba": "numba"}


class Row(NamedTuple):
    """One method on one workload: nanoseconds a pair (median, least), wrong answers among `checked` pairs."""

    workload: str
    method: str
    ns: float
    least: float
    wrong: int
    checked: int


def bench(pairs: int, rounds: int, seed: int, checked: int = 2000) -> Iterator[Row]:
    """The rows of the table, workload by workload."""
    checked = min(checked, pairs)
    with ThreadPoolExecutor(2) as pool:
        for name, make in WORKLOADS.items():
            a, b = make(np.random.default_rng(seed), pairs)
            few = [(s[0][:checked], s[1][:checked]) if isinstance(s, tuple) else s[:checked] for s in (a, b)]
            right = np.array([truth.relation(p, q) for p, q in zip(*map(shapes, few))])
            jobs: dict[str, Callable[[], Any]] = {}
            items: dict[str, int] = {}
            for method in methods(circles=isinstance(a, tuple)):
                label = BENCHED.get((method.form, method.name))
                if label is None:
                    continue
                scalar = method.form == "scalar"
                mine = [method.prepare(side) for side in (few if scalar else (a, b))]
                jobs[label] = partial(method.hits, *mine)
                items[label] = checked if scalar else pairs
                if label in THREADED:
                    halves = {"engine": THREADED[label], "executor": pool, "chunk": -(-pairs // 2)}
                    jobs[f"{label}, 2 threads"] = partial(batch.relate, *mine, **halves)
                    items[f"{label}, 2 threads"] = pairs
            answers = {label: np.asarray(job())[:checked] for label, job in jobs.items()}
            for label, times in in_turn(jobs, rounds, items).items():
                wrong = sum(mistakes(answers[label], right).values())
                yield Row(name, label, times.median, times.least, wrong, checked)


def table(rows: list[Row]) -> str:
    """The rows as text, a block a workload, each time beside its ratio to vectorised shapely."""
    lines = []
    for name in dict.fromkeys(row.workload for row in rows):
        block = [row for row in rows if row.workload == name]
        base = next((r.ns for r in block if r.method == "shapely"), None)
        lines.append(f"{name:26}{'ns a pair':>11}{'least':>10}{'x shapely':>11}   wrong of {block[0].checked}")
        for row in sorted(block, key=lambda r: r.ns):
            ratio = f"{base / row.ns:.1f}" if base else ""
            lines.append(f"  {row.method:24}{row.ns:11.1f}{row.least:10.1f}{ratio:>11}{row.wrong:8}")
        lines.append("")
    return "\n".join(lines)


START_UP = """
from time import perf_counter
import numpy as np
from satviz import batch
shapes = batch.Polygons(np.array([[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]]))
start = perf_counter()
batch.relate(shapes, shapes, engine="numba")
print(perf_counter() - start)
"""


def when_numba_pays(rows: list[Row]) -> str:
    """What numba's start-up costs in a new process (kernels already on disk), against what it saves a pair."""
    ns = {row.method: row.ns for row in rows if row.workload == "triangles"}
    saved = ns["satviz numpy"] - ns["satviz numba"]
    runs = [subprocess.run([sys.executable, "-c", START_UP], capture_output=True, check=True) for _ in range(3)]
    seconds = statistics.median(float(run.stdout) for run in runs)
    if saved <= 0:
        return f"numba starts in {seconds:.2f} s and saved nothing on triangles here"
    return (
        f"numba starts in {seconds:.2f} s and saves {saved:.0f} ns a pair of triangles: "
        f"it pays from {seconds / saved * 1e3:.1f} million pairs on"
    )


class BroadRow(NamedTuple):
    """The broad phase on one layout: milliseconds by number of boxes, and the growth exponent of the last two."""

    layout: str
    method: str
    ms: dict[int, float]
    pairs: dict[int, int]
    growth: float


def bench_broad(sizes: tuple[int, ...], rounds: int, seed: int) -> Iterator[BroadRow]:
    """Candidate pairs by satviz's grid and by shapely's STRtree (built and asked), layout by layout."""
    for layout, make in LAYOUTS.items():
        ways: dict[str, Callable[[NDArray], Any]] = {"satviz grid": batch.candidate_pairs}
        if installed("shapely"):
            ways["shapely STRtree"] = _tree
        ms: dict[str, dict[int, float]] = {way: {} for way in ways}
        pairs = {}
        for n in sizes:
            bounds = make(np.random.default_rng(seed), n)
            pairs[n] = len(batch.candidate_pairs(bounds))
            times = in_turn({way: partial(run, bounds) for way, run in ways.items()}, rounds, dict.fromkeys(ways, 1))
            for way, found in times.items():
                ms[way][n] = found.median / 1e6
        for way, found in ms.items():
            growth = float(np.log(found[sizes[-1]] / found[sizes[-2]]) / np.log(sizes[-1] / sizes[-2]))
            yield BroadRow(layout, way, found, pairs, growth)


def _tree(bounds: NDArray) -> NDArray:
    import shapely

    boxes = shapely.box(*bounds.T)
    i, j = shapely.STRtree(boxes).query(boxes)
    once = i < j
    return np.stack([i[once], j[once]], axis=1)


def broad_table(rows: list[BroadRow]) -> str:
    """Milliseconds for each number of boxes, and n**growth at the end."""
    sizes = list(rows[0].ms)
    lines = [f"{'broad phase, ms':40}" + "".join(f"{n:>10}" for n in sizes) + f"{'growth':>8}{'pairs':>9}"]
    for row in rows:
        ms = "".join(f"{row.ms[n]:10.2f}" for n in sizes)
        lines.append(f"  {row.layout:20}{row.method:18}{ms}{row.growth:8.2f}{row.pairs[sizes[-1]]:9}")
    return "\n".join(lines)
