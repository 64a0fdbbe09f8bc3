"""Corners: time against the number of corners, for several ways to go through two outlines.

Question: which way suits outlines of many corners?  Workload: pairs of regular polygons, half of them apart, checked by
how they were made.  Methods: SAT with every corner and with a search for the support point, rotating calipers, GJK,
satviz and shapely.  The claim is refuted by a method whose time grows by another power of the number of corners.
"""

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from ... import batch
from ...pictures import Theme
from ..harness.cells import Cell, JsonRow, Settings
from ..harness.chart import WIDTH, Chart, add_axes, draw_headline, draw_time_curves, format_time, head_height
from ..harness.machine import is_installed
from ..harness.timings import cells_by_process, over_processes, time_jobs, timing_warning
from ..methods import libraries
from ..workloads.generators import Array, Rings, apart_pairs, overlapping_pairs

CORNER_COUNTS = (3, 4, 8, 16, 32, 64, 128, 256)
LINE_STYLES = {
    "SAT, every corner": ("float SAT", "-"),
    "SAT, support search": ("float SAT", "--"),
    "rotating calipers": ("float SAT", ":"),
    "GJK": ("GJK", "-"),
    "satviz": ("exact", "-"),
    "shapely": ("library", "-"),
}


def cells(settings: Settings) -> list[Cell]:
    """Return a cell for each process, which times the methods and checks every answer by how the pair was made."""
    return cells_by_process(
        "corners", take_times, ((10_000, 3) if settings.quick else (200_000, 5)) + (settings,), settings
    )


def ready_jobs(a: Rings, b: Rings) -> dict[str, Callable[[], Any]]:
    """Return a job for each method on these pairs, prepared beforehand; a job returns which pairs hit."""
    jobs: dict[str, Callable[[], Any]] = {}
    if is_installed("numba"):
        from ..methods import numba_rivals

        rows = [np.ascontiguousarray(rings[:, :, d].T) for rings in (a, b) for d in (0, 1)]
        # transposed views, so that the corners of one outline are side by side in memory, as for long outlines
        columns = [np.ascontiguousarray(row.T).T for row in rows]
        v, out = a.shape[1], np.empty(len(a), np.int8)

        def run(kernel: Callable[..., None], columns: list[Array]) -> Any:
            """Return which pairs hit, by a kernel on these columns."""
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


def take_times(corners: int, rounds: int, settings: Settings) -> list[JsonRow]:
    """Return for each method and corner count the ns per pair of regular v-gons, and the wrong answers.

    `corners`: corners in all, so that there are fewer pairs where each has more corners.
    """
    rows = []
    for v in CORNER_COUNTS:
        rng, n = settings.rng("corners", v), max(100, corners // v)
        sides = zip(apart_pairs(rng, n // 2, v), overlapping_pairs(rng, n - n // 2, v), strict=True)
        a, b = (np.concatenate(side) for side in sides)
        order = rng.permutation(n)
        a, b = a[order], b[order]
        right, jobs = (np.arange(n) >= n // 2)[order], ready_jobs(a, b)
        wrong = {name: int((job() != right).sum()) for name, job in jobs.items()}
        for name, ns in time_jobs(jobs, rounds, dict.fromkeys(jobs, n)).items():
            rows.append({"corners": v, "method": name, "pairs": n, "wrong": wrong[name], "ns": ns})
    return rows


def charts(found: dict[str, Any], settings: Settings) -> list[Chart]:
    """Return the chart of time against corners; both scales are logarithmic, so a slope is an exponent."""
    rows: list[JsonRow] = over_processes(found, "corners")
    ns = {(row["method"], row["corners"]): row["ns"] for row in rows}
    names = [name for name in LINE_STYLES if (name, CORNER_COUNTS[-1]) in ns]
    factors = {name: (ns[name, CORNER_COUNTS[-1]] / ns[name, 64]) ** 0.5 for name in names}  # two doublings after 64
    title = "Time against corners"
    if "GJK" in factors:
        title = f"With twice the corners, textbook SAT takes {factors['SAT, every corner']:.1f} times as long, "
        title += f"GJK {factors['GJK']:.1f} and calipers {factors['rotating calipers']:.1f}"

    few = "SAT with every corner is unrolled for few corners; for more it stops at the first gap."
    lines = (f"Time for a pair of regular polygons, half of them apart. {few} Bars: the spread of the processes.",)
    head = head_height(title, lines, WIDTH)
    size = WIDTH, head + 300

    def draw(fig: Figure, theme: Theme) -> None:
        """Draw for each method its time against the number of corners, on logarithmic scales."""
        draw_headline(fig, theme, title, *lines)
        ax = add_axes(fig, (52 / WIDTH, 44 / size[1], 280 / WIDTH, 246 / size[1]), theme)
        ax.set_xscale("log")
        draw_time_curves(ax, theme, CORNER_COUNTS, rows, LINE_STYLES)
        ax.set_xlabel("corners of each polygon")
        ax.set_xticks(CORNER_COUNTS[1:], [str(v) for v in CORNER_COUNTS[1:]])
        ax.xaxis.minorticks_off()

    text = ""
    for name in names:
        times = [f"{format_time(ns[name, v])} with {v} corners" for v in (CORNER_COUNTS[0], 32, CORNER_COUNTS[-1])]
        text += f"{name}: {', '.join(times)}; twice the corners take {factors[name]:.1f} times as long (64 to 256). "
    text += f"Wrong answers: {sum(row['wrong'] for row in rows)} of {sum(row['pairs'] for row in rows):,}."
    return [Chart("corners", title, size, draw, rows, text, timing_warning(rows, settings))]
