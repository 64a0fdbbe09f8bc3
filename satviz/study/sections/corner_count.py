"""Corners: time against their number, for the ways to go through two outlines."""

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from ... import batch
from ...pictures import Theme
from ..harness.cells import Cell, Settings
from ..harness.chart import Chart, add_axes, draw_headline, family_colour, format_time, label_ends, set_time_ticks
from ..harness.machine import is_installed
from ..harness.timings import time_jobs, timing_warning
from ..methods import libraries
from ..workloads.generators import Rings, apart_pairs, overlapping_pairs

Row = dict[str, Any]
CORNER_COUNTS = (3, 4, 6, 8, 12, 16, 32, 64, 128, 256)
LINE_STYLES = {
    "SAT, every corner": ("float SAT", "-"),
    "SAT, support search": ("float SAT", "--"),
    "rotating calipers": ("float SAT", ":"),
    "GJK": ("GJK", "-"),
    "satviz": ("exact", "-"),
    "shapely": ("library", "-"),
}


def cells(settings: Settings) -> list[Cell]:
    """One that takes the times, and holds every answer against how the pair was made."""
    corners, rounds = (20_000, 3) if settings.quick else (400_000, 11)
    return [Cell("corners-times", take_times, (corners, rounds, settings), timed=True)]


def ready_jobs(a: Rings, b: Rings) -> dict[str, Callable[[], Any]]:
    """Each way on these pairs, ready; compiled but for what calls them."""
    jobs: dict[str, Callable[[], Any]] = {}
    if is_installed("numba"):
        from ..methods import numba_rivals

        # one outline after another in memory, as long ones are kept
        x, y, p, q = (np.ascontiguousarray(rings[:, :, d]).T for rings in (a, b) for d in (0, 1))

        def run(kernel: Callable[..., None], *more: Any) -> Any:
            out = np.empty(len(a), np.int8)
            kernel(x, y, p, q, *more, out)
            return out > 0

        jobs["SAT, every corner"] = partial(run, numba_rivals.textbook_sat, False, 0.0)
        jobs["SAT, support search"] = partial(run, numba_rivals.support_search_sat)
        jobs["rotating calipers"] = partial(run, numba_rivals.calipers)
        jobs["GJK"] = partial(run, numba_rivals.gjk)
        shapes = batch.Polygons(a.copy()), batch.Polygons(b.copy())
        jobs["satviz"] = lambda: batch.relate(*shapes, engine="numba") > 0
    if is_installed("shapely"):
        jobs["shapely"] = partial(
            libraries.shapely_hits, libraries.shapely_geometries(a), libraries.shapely_geometries(b)
        )
    return jobs


def take_times(corners: int, rounds: int, settings: Settings) -> list[Row]:
    """Nanoseconds a pair of regular V-gons, half of them made apart, and how many answers were wrong."""
    rows = []
    for v in CORNER_COUNTS:
        rng, n = settings.rng("corners", v), max(100, corners // v)
        sides = zip(apart_pairs(rng, n // 2, v), overlapping_pairs(rng, n - n // 2, v), strict=True)
        a, b = (np.concatenate(side) for side in sides)
        order = rng.permutation(n)
        a, b = a[order], b[order]
        right, jobs = (np.arange(n) >= n // 2)[order], ready_jobs(a, b)
        bad = {name: int((job() != right).sum()) for name, job in jobs.items()}
        for name, times in time_jobs(jobs, rounds, dict.fromkeys(jobs, n)).items():
            rows.append({"corners": v, "method": name, "pairs": n, "wrong": bad[name], **times})
    return rows


def charts(found: dict[str, Any], settings: Settings) -> list[Chart]:
    """Lines over the number of corners, both scales logarithmic: a slope is an exponent."""
    rows: list[Row] = found["corners-times"]
    ns = {(row["method"], row["corners"]): row["ns"] for row in rows}
    names = [name for name in LINE_STYLES if (name, CORNER_COUNTS[-1]) in ns]
    slopes = {name: np.log2(ns[name, CORNER_COUNTS[-1]] / ns[name, 64]) / 2 for name in names}
    title = "Time against corners"
    if "GJK" in slopes:
        more = {name: f"{2**slope:.1f}" for name, slope in slopes.items()}
        title = f"Twice the corners take textbook SAT {more['SAT, every corner']} times as long, GJK {more['GJK']}, "
        title += f"calipers {more['rotating calipers']}"

    def draw(fig: Figure, theme: Theme) -> None:
        under = "time a pair of regular polygons, half of them apart; bars: quartiles"
        draw_headline(fig, theme, title, under)
        ax = add_axes(fig, (0.085, 0.14, 0.62, 0.69), theme)
        ends = []
        for name in names:
            family, style = LINE_STYLES[name]
            shade, mine = family_colour(theme, family), [row for row in rows if row["method"] == name]
            ax.plot(
                [row["corners"] for row in mine],
                [row["ns"] for row in mine],
                color=shade,
                ls=style,
                lw=1.8,
                marker="o",
                ms=4,
            )
            for row in mine:
                ax.plot([row["corners"]] * 2, [row["ns_low"], row["ns_high"]], color=shade, lw=1)
            ends.append(
                (
                    CORNER_COUNTS[-1],
                    mine[-1]["ns"],
                    f"{name}: {format_time(mine[-1]['ns'])}",
                    family_colour(theme, family, text=True),
                )
            )
        ax.set(xscale="log", yscale="log", xlabel="corners of each polygon")
        ax.set_xticks(CORNER_COUNTS, [str(v) for v in CORNER_COUNTS])
        ax.xaxis.minorticks_off()
        set_time_ticks(ax.yaxis, ax.get_ylim())
        label_ends(ax, ends, gap=15)

    text = ""
    for name in names:
        each = [f"{format_time(ns[name, v])} with {v} corners" for v in (CORNER_COUNTS[0], 32, CORNER_COUNTS[-1])]
        text += f"{name}: {', '.join(each)}; twice the corners, {2 ** slopes[name]:.1f} times (64 to 256). "
    text += f"Wrong answers: {sum(row['wrong'] for row in rows)} of {sum(row['pairs'] for row in rows):,}."
    return [Chart("corners", title, (760.0, 400.0), draw, rows, text, timing_warning(rows, settings))]
