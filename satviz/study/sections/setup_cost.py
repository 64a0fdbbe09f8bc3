"""Set-up against reuse: what it costs to prepare shapes, and after how many questions that pays."""

import gc
from statistics import median, quantiles
from time import thread_time
from typing import Any

from matplotlib.figure import Figure

from ...pictures import Theme
from ..harness.cells import Cell, JsonRow, Settings
from ..harness.chart import (
    TEXT_POINTS,
    Chart,
    add_axes,
    draw_headline,
    family_colour,
    format_time,
    set_time_ticks,
)
from ..harness.timings import timing_warning
from ..methods import COMPILED, NUMPY, Method, all_methods
from ..workloads.generators import Side, ngons

QUESTION_COUNTS = (1, 10, 100)
TIME_PARTS = {"preparing": "ns_setup", "the first question": "ns_first", "another question": "ns_again"}
# methods whose set-up is that of a method which is shown
OMITTED_METHODS = (
    "orientation, floats", "SAT, 1e-9 counts as a miss", "SAT, 1e-9 counts as a hit", "SAT, unit normals",
)  # fmt: skip


def cells(settings: Settings) -> list[Cell]:
    """Return one cell, which times the preparation of shapes, the first question and another one."""
    n, rounds = (20_000, 3) if settings.quick else (100_000, 9)
    return [Cell("reuse-times", take_times, (n, rounds, settings), timed=True)]


def take_times(n: int, rounds: int, settings: Settings) -> list[JsonRow]:
    """Return for each method and number of questions its ns per pair and question, and the times of its parts.

    There is no warm-up, so what a method computes at the first question and keeps is counted there.  Only the first
    round is left out, because code is compiled and loaded in it.
    """
    rng = settings.rng("reuse")
    a, b = ngons(rng, n, 4, 1.2), ngons(rng, n, 4, 1.2)
    methods = [m for m in all_methods() if m.language in (COMPILED, NUMPY) and m.name not in OMITTED_METHODS]
    methods = [m for m in methods if m.language == COMPILED or m.family == "exact"]
    seconds: dict[int, list[tuple[float, float, float]]] = {i: [] for i in range(len(methods))}
    collecting = gc.isenabled()
    gc.disable()
    try:
        for _ in range(rounds + 1):
            for i, method in enumerate(methods):
                seconds[i].append(_time_parts(method, a, b))
            gc.collect()
    finally:
        if collecting:
            gc.enable()
    rows = []
    for i, method in enumerate(methods):
        setup, first, again = (median(times) / n * 1e9 for times in zip(*seconds[i][1:], strict=True))
        name = method.name if method.language == COMPILED else f"{method.name}, {method.language}"
        for count in QUESTION_COUNTS:
            means = [(s + f + (count - 1) * g) / count / n * 1e9 for s, f, g in seconds[i][1:]]
            low, mid, high = quantiles(means, n=4, method="inclusive")
            row = {"method": name, "family": method.family, "reuse": count, "ns": mid, "ns_low": low, "ns_high": high}
            rows.append({**row, "ns_setup": setup, "ns_first": first, "ns_again": again, "pairs": n})
    return rows


def _time_parts(method: Method, a: Side, b: Side) -> tuple[float, float, float]:
    """Return the seconds that a method takes to prepare both sides, for a first question and for a second one."""
    start = thread_time()
    prepared = method.prepare(a), method.prepare(b)
    after_setup = thread_time()
    method.hits(*prepared)
    after_first = thread_time()
    method.hits(*prepared)
    return after_setup - start, after_first - after_setup, thread_time() - after_first


def charts(found: dict[str, Any], settings: Settings) -> list[Chart]:
    """Return the chart of the mean time per question when shapes are prepared once for 1, 10 or 100 questions."""
    rows: list[JsonRow] = found["reuse-times"]
    by_count = {(row["method"], row["reuse"]): row for row in rows}
    names = sorted(dict.fromkeys(row["method"] for row in rows), key=lambda name: by_count[name, 1]["ns"])
    satviz = by_count.get(("satviz", 1), rows[0])
    setup, again = format_time(satviz["ns_setup"]), format_time(satviz["ns_again"])
    title = f"satviz needs {setup} to prepare a pair, then {again} for a question"
    tall = 21.0 * len(names)
    size = 760.0, 112 + tall

    def draw(fig: Figure, theme: Theme) -> None:
        """Draw for each method a row with its times per question, and a bar for preparing alone."""
        line = "Time for a question, with its share of preparing the shapes; "
        draw_headline(fig, theme, title, f"{line}{rows[0]['pairs']:,} pairs of 4-gons from one array for each side.")
        ax = add_axes(fig, (0.2, 42 / size[1], 0.78, tall / size[1]), theme)
        for y, name in enumerate(names):
            shade = family_colour(theme, by_count[name, 1]["family"])
            ns = [by_count[name, count]["ns"] for count in QUESTION_COUNTS]
            ax.plot([min(ns), max(ns)], [y, y], color=shade, lw=1, alpha=0.6)
            for time, marker, fill, points in zip(ns, "oso", (shade, theme.paper, theme.paper), (7, 6, 6), strict=True):
                ax.plot([time], [y], marker, mec=shade, mfc=fill, ms=points, mew=1.4)
            ax.plot([by_count[name, 1]["ns_setup"]], [y], "|", color=theme.roles["ink"], ms=12, mew=1.6)
        ax.set(xscale="log", ylim=(len(names) - 0.5, -1.3), xlabel="time for a question")
        ax.set_yticks(range(len(names)), names)
        set_time_ticks(ax.xaxis, ax.get_xlim())
        ax.yaxis.minorticks_off()
        ax.spines["left"].set_visible(False)
        ax.tick_params(axis="y", length=0)
        key = "● asked once   □ 10 times   ○ 100 times   | preparing alone"
        style: dict[str, Any] = {"fontsize": TEXT_POINTS, "ha": "right", "va": "center_baseline"}
        ax.text(0.99, -0.9, key, transform=ax.get_yaxis_transform(), color=theme.roles["guide"], **style)

    text = ""
    for name in names:
        row = by_count[name, 1]
        means = [f"{format_time(by_count[name, n]['ns'])} a question when asked {n} times" for n in QUESTION_COUNTS]
        parts = [f"{words} {format_time(row[key])}" for words, key in TIME_PARTS.items()]
        text += f"{name}: {', '.join(means)}; {', '.join(parts)}. "
    return [Chart("cold-and-warm", title, size, draw, rows, text.strip(), timing_warning(rows, settings))]
