"""Corners: time against the number of corners, for several ways to go through two outlines.

Question: which way suits outlines of many corners?  Workload: pairs of regular polygons, half of them apart; a sample
is checked by both oracles.  Methods: SAT with every corner and with a search for the support point, rotating calipers,
GJK, satviz and shapely.  The claim is refuted if, from 64 corners on, twice the corners take SAT on every corner less
than three times as long, or calipers or GJK more than that.
"""

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from ... import batch
from ...pictures import Theme
from ...render.chart import TEXT_POINTS, Chart, JsonRow, add_axes
from ..harness import timings
from ..harness.cells import Cell, Settings
from ..harness.chart import draw_time_curves, format_time
from ..harness.machine import is_installed
from ..methods import libraries, true_relations
from ..workloads.generators import Array, Rings, apart_pairs, overlapping_pairs

CORNER_COUNTS = (3, 4, 8, 16, 32, 64, 128, 256)
QUICK_COUNTS = (4, 16, 64, 256)  # fewer kernels to compile
LINE_STYLES = {  # by (method, column): (label, family, line style)
    (name, "ns"): (name, family, style)
    for name, family, style in (
        ("SAT, every corner", "float SAT", "-"),
        ("SAT, support search", "float SAT", "--"),
        ("rotating calipers", "float SAT", ":"),
        ("GJK", "GJK", "-"),
        ("satviz", "exact", "-"),
        ("shapely", "library", "-"),
    )
}


def cells(settings: Settings) -> list[Cell]:
    """Return a cell that counts wrong answers, and a cell for each process that times the methods."""
    counts = QUICK_COUNTS if settings.quick else CORNER_COUNTS
    arguments = ((10_000, 3) if settings.quick else (200_000, 5)) + (counts, settings)
    counted = Cell("corners-count", count_errors, (400 if settings.quick else 4000, counts, settings))
    return [counted, *timings.cells_by_process("corners", take_times, arguments, settings)]


def mixed_pairs(n: int, v: int, settings: Settings) -> tuple[Rings, Rings]:
    """Return n pairs of regular v-gons in random order, half of them apart and half overlapping."""
    rng = settings.rng("corners", v)
    sides = zip(apart_pairs(rng, n // 2, v), overlapping_pairs(rng, n - n // 2, v), strict=True)
    a, b = (np.concatenate(side) for side in sides)
    order = rng.permutation(n)
    return a[order], b[order]


def count_errors(corners: int, counts: Sequence[int], settings: Settings) -> list[JsonRow]:
    """Return for each method and corner count its wrong answers on some pairs, which both oracles check.

    `corners`: corners in all, so that there are fewer pairs where each has more corners.
    """
    found = []
    for v in counts:
        a, b = mixed_pairs(max(4, corners // v), v, settings)
        right = true_relations(a, b)
        found += [{"corners": v, "method": name, "pairs": len(a), "wrong": int((job() != (right > 0)).sum())}
                  for name, job in ready_jobs(a, b).items()]  # fmt: skip
    return found


def ready_jobs(a: Rings, b: Rings) -> dict[str, Callable[[], Any]]:
    """Return by method a function without arguments that returns which of these pairs hit, from shapes made before."""
    jobs: dict[str, Callable[[], Any]] = {}
    if is_installed("numba"):
        from ..methods import numba_rivals

        rows = [np.ascontiguousarray(rings[:, :, d].T) for rings in (a, b) for d in (0, 1)]
        # transposed views, so that the corners of one outline are side by side in memory, as for long outlines
        columns = [np.ascontiguousarray(row.T).T for row in rows]
        v, out = a.shape[1], np.empty(len(a), np.int8)

        def run(kernel: Callable[..., None], columns: list[Array]) -> Any:
            """Return the (n,) answers of a kernel on these columns: True for each pair that hits."""
            kernel(*columns, out)
            return out > 0

        jobs["SAT, every corner"] = partial(run, numba_rivals.plain_sat(v, v), rows)
        jobs["SAT, support search"] = partial(run, numba_rivals.support_search_sat, columns)
        jobs["rotating calipers"] = partial(run, numba_rivals.calipers, columns)
        few = numba_rivals.unrolled(v)
        jobs["GJK"] = partial(run, numba_rivals.gjk_kernel(few, few), columns if few is None else rows)
        shapes = batch.Polygons(a.copy()), batch.Polygons(b.copy())
        jobs["satviz"] = lambda: batch.relate(*shapes, engine="numba") > 0
    if is_installed("shapely"):
        jobs["shapely"] = partial(libraries.shapely_hits, *map(libraries.shapely_geometries, (a, b)))
    return jobs


def take_times(corners: int, rounds: int, counts: Sequence[int], settings: Settings) -> list[JsonRow]:
    """Return for each method and corner count v the ns per pair of regular v-gons; `corners`: as in `count_errors`."""
    found = []
    for v in counts:
        n = max(100, corners // v)
        jobs = ready_jobs(*mixed_pairs(n, v, settings))
        times = timings.time_jobs(jobs, rounds, dict.fromkeys(jobs, n))
        found += [{"corners": v, "method": name, "ns": ns} for name, ns in times.items()]
    return found


def rows(found: dict[str, Any]) -> dict[str, list[JsonRow]]:
    """Return {stem of the chart: its rows}: the times over all processes, and the counts of wrong answers.

    found: the results of all cells by their names.
    """
    counted = {(row["corners"], row["method"]): row for row in found["corners-count"]}
    return {
        "corners": [
            {**counted[row["corners"], row["method"]], **row} for row in timings.over_processes(found, "corners")
        ]
    }


def chart(rows: Sequence[JsonRow], settings: Settings) -> Chart:
    """Return the chart of time against corners; both scales are logarithmic, so a slope is an exponent."""
    by = {(row["method"], row["corners"]): row for row in rows}
    names = [name for name, _ in LINE_STYLES if any(row["method"] == name for row in rows)]
    counts = sorted({row["corners"] for row in rows})
    factors = dict[str, str]()
    for name in names:  # two doublings after 64
        last, first = (by[name, v]["ns_runs"] for v in (256, 64))
        middle, low, high = (ratio**0.5 for ratio in timings.ratio_interval(last, first))
        factors[name] = timings.format_ratio((middle, low, high))
    title = "Time against corners"
    if "GJK" in factors:
        title = f"With twice the corners, SAT on every corner takes {factors['SAT, every corner']} as long, GJK "
        title += factors["GJK"]

    lines = (
        "Time for a pair of regular polygons, half of them apart. Bars: the spread of the processes. The title has the "
        "average from 64 to 256 corners.",
    )

    def draw(fig: Figure, theme: Theme) -> None:
        """Draw for each method its time against the number of corners, on logarithmic scales."""
        ax = add_axes(fig, (56, 54, 188, 246), theme)
        ax.set_xscale("log")
        draw_time_curves(ax, theme, counts, rows, LINE_STYLES)
        ax.set_xlabel("corners of each polygon")
        ticks = [v for v in counts if v > 3]
        ax.set_xticks(ticks, [str(v) for v in ticks], fontsize=TEXT_POINTS)
        ax.xaxis.minorticks_off()

    text = f"In brackets: {timings.interval_in_words(len(rows[0]['ns_runs']))}. "
    for name in names:
        times = [f"{format_time(by[name, v]['ns'])} with {v} corners" for v in (4, 64, 256)]
        text += f"{name}: {', '.join(times)}; on average twice the corners take {factors[name]} as long (64 to 256). "
    text += f"Wrong answers: {sum(row['wrong'] for row in rows)} of {sum(row['pairs'] for row in rows):,}, "
    text += "checked by two exact oracles."
    return Chart("corners", title, lines, 310, draw, rows, text, timings.timing_warning(rows, settings))


CHARTS = {"corners": chart}
