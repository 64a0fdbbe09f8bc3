"""satviz bench: nanoseconds a pair and wrong answers, satviz beside its peers on the same pairs in one run.

The methods are taken in turn within a round; the figure is the median over rounds.
Shapes are built beforehand.  Wrong answers are counted against rationals, on the
first pairs of each workload; methods one pair at a time are timed on those too.
"""

import platform
import statistics
import subprocess
import sys
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from importlib.metadata import PackageNotFoundError, version
from importlib.util import find_spec
from time import perf_counter
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .. import batch
from ..shapes import Circle, Polygon
from ..verdict import relate
from . import truth
from .workloads import LAYOUTS, WORKLOADS, Side

PEERS = ("numba", "shapely", "pymunk")
Answers = NDArray[np.bool_]


class Row(NamedTuple):
    """One method on one workload: nanoseconds a pair (median, least), wrong answers among `checked` pairs."""

    workload: str
    method: str
    ns: float
    least: float
    wrong: int
    checked: int


class Method(NamedTuple):
    """Something that answers all pairs, or only the first few (`pairs` of them)."""

    name: str
    run: Callable[[], Any]
    pairs: int


def missing() -> list[str]:
    """The peers that are not installed."""
    return [name for name in PEERS if find_spec(name) is None]


def machine() -> dict[str, str]:
    """What was measured on."""
    found = {"python": platform.python_version(), "machine": platform.machine(), "system": platform.system()}
    for name in ("satviz", "numpy", *PEERS):
        try:
            found[name] = version(name)
        except PackageNotFoundError:
            continue
    return found


def bench(pairs: int, rounds: int, seed: int, checked: int = 2000) -> Iterator[Row]:
    """The rows of the table, workload by workload."""
    checked = min(checked, pairs)
    with ThreadPoolExecutor(2) as pool:
        for name, make in WORKLOADS.items():
            a, b = make(np.random.default_rng(seed), pairs)
            right = np.array([truth.relation(p, q) > 0 for p, q in zip(*(_objects(s, checked) for s in (a, b)))])
            methods = list(_methods(a, b, pairs, checked, pool))
            times: dict[str, list[float]] = {m.name: [] for m in methods}
            answers = {m.name: np.asarray(m.run())[:checked].astype(bool) for m in methods}  # the warm-up
            for _ in range(rounds):
                for method in methods:
                    start = perf_counter()
                    method.run()
                    times[method.name].append((perf_counter() - start) / method.pairs * 1e9)
            for method in methods:
                t = times[method.name]
                wrong = int((answers[method.name] != right).sum())
                yield Row(name, method.name, statistics.median(t), min(t), wrong, checked)


def _objects(side: Side, n: int) -> list:
    if isinstance(side, tuple):
        return [Circle(c, r) for c, r in zip(side[0][:n], side[1][:n])]
    return [Polygon(ring) for ring in side[:n]]


def _methods(a: Side, b: Side, pairs: int, few: int, pool: ThreadPoolExecutor) -> Iterator[Method]:
    mine = [batch.Circles(*s) if isinstance(s, tuple) else batch.Polygons(s.copy()) for s in (a, b)]
    half = -(-pairs // 2)
    for engine in ("numpy", "numba"):
        if engine == "numba" and "numba" in missing():
            continue
        yield Method(f"satviz {engine}", lambda e=engine: batch.hits(*mine, engine=e), pairs)
        two = {"executor": pool, "chunk": half}
        yield Method(f"satviz {engine}, 2 threads", lambda e=engine, o=two: batch.hits(*mine, engine=e, **o), pairs)
    if not (isinstance(a, tuple) or isinstance(b, tuple)):
        yield Method("plain NumPy", lambda: _textbook(a, b), pairs)
    scalar = list(zip(*(_objects(s, few) for s in (a, b)), strict=True))
    yield Method("satviz.relate", lambda: [relate(p, q) for p, q in scalar], few)
    if find_spec("shapely"):
        yield from _shapely(a, b, pairs, few)
    if find_spec("pymunk"):
        yield _pymunk(a, b, few)


def _textbook(a: NDArray, b: NDArray) -> Answers:
    """SAT as it is usually written with NumPy: unit normals, projections, ranges."""
    hit = np.ones(len(a), bool)
    for rings in (a, b):
        edges = np.roll(rings, -1, axis=1) - rings
        normals = np.stack([edges[..., 1], -edges[..., 0]], axis=2)
        normals /= np.linalg.norm(normals, axis=2, keepdims=True)
        on_a, on_b = (np.einsum("nvd,nad->nav", r, normals) for r in (a, b))
        apart = (on_a.max(axis=2) < on_b.min(axis=2)) | (on_b.max(axis=2) < on_a.min(axis=2))
        hit &= ~apart.any(axis=1)
    return hit


def _shapely(a: Side, b: Side, pairs: int, few: int) -> Iterator[Method]:
    import shapely

    if isinstance(a, tuple):
        points, radii, rings = shapely.points(a[0]), a[1], shapely.polygons(b)
        yield Method("shapely.dwithin", lambda: shapely.dwithin(points, rings, radii), pairs)
        scalar = list(zip(points[:few], rings[:few], radii[:few].tolist(), strict=True))
        yield Method("shapely p.dwithin(q, r)", lambda: [p.dwithin(q, r) for p, q, r in scalar], few)
        return
    mine, prepared, other = shapely.polygons(a), shapely.polygons(a), shapely.polygons(b)
    shapely.prepare(prepared)
    yield Method("shapely.intersects", lambda: shapely.intersects(mine, other), pairs)
    yield Method("shapely prepared", lambda: shapely.intersects(prepared, other), pairs)
    scalar = list(zip(mine[:few], other[:few], strict=True))
    yield Method("shapely p.intersects(q)", lambda: [p.intersects(q) for p, q in scalar], few)


def _pymunk(a: Side, b: Side, few: int) -> Method:
    import pymunk

    def shapes(side: Side) -> list:
        body = pymunk.Body(body_type=pymunk.Body.STATIC)
        if isinstance(side, tuple):
            found = [pymunk.Circle(body, float(r), tuple(c)) for c, r in zip(side[0][:few].tolist(), side[1][:few])]
        else:
            found = [pymunk.Poly(body, [tuple(v) for v in ring]) for ring in side[:few].tolist()]
        for shape in found:
            shape.cache_bb()
        return found

    scalar = list(zip(shapes(a), shapes(b), strict=True))

    def collide(p: Any, q: Any) -> bool:
        try:
            return bool(p.shapes_collide(q).points)
        except AssertionError:  # what pymunk 7 raises for two shapes without a contact
            return False

    return Method("pymunk", lambda: [collide(p, q) for p, q in scalar], few)


def table(rows: list[Row]) -> str:
    """The rows as text, a block a workload, each time beside its ratio to vectorised shapely."""
    lines = []
    for name in dict.fromkeys(row.workload for row in rows):
        block = [row for row in rows if row.workload == name]
        base = next((r.ns for r in block if r.method in ("shapely.intersects", "shapely.dwithin")), None)
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
        if find_spec("shapely"):
            ways["shapely STRtree"] = _tree
        times: dict[str, dict[int, list[float]]] = {way: {n: [] for n in sizes} for way in ways}
        pairs = {}
        for n in sizes:
            bounds = make(np.random.default_rng(seed), n)
            pairs[n] = len(batch.candidate_pairs(bounds))
            for _ in range(rounds):
                for way, run in ways.items():
                    start = perf_counter()
                    run(bounds)
                    times[way][n].append((perf_counter() - start) * 1e3)
        for way, found in times.items():
            ms = {n: statistics.median(t) for n, t in found.items()}
            growth = float(np.log(ms[sizes[-1]] / ms[sizes[-2]]) / np.log(sizes[-1] / sizes[-2]))
            yield BroadRow(layout, way, ms, pairs, growth)


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
