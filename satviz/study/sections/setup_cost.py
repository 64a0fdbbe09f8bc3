"""Cold and warm: what shapes cost to make ready, and how often they must be asked for it to pay."""

import gc
from statistics import median, quantiles
from time import thread_time
from typing import Any

from matplotlib.figure import Figure

from ...pictures import Theme
from ..harness.cells import Cell, Settings
from ..harness.chart import TEXT_POINTS, Chart, add_axes, draw_headline, family_colour, format_time, set_time_ticks
from ..harness.timings import timing_warning
from ..methods import COMPILED, NUMPY, Method, all_methods
from ..workloads.generators import Side, ngons

Row = dict[str, Any]
QUESTION_COUNTS = (1, 10, 100)
TIME_PARTS = {"making ready": "ns_setup", "the first question": "ns_first", "another": "ns_again"}
OMITTED_METHODS = (
    "orientation, floats",
    "SAT, 1e-9 counts as a miss",
    "SAT, 1e-9 counts as a hit",
    "SAT, unit normals",
)  # as their likes


def cells(settings: Settings) -> list[Cell]:
    """One that takes the times."""
    n, rounds = (20_000, 3) if settings.quick else (100_000, 9)
    return [Cell("reuse-times", take_times, (n, rounds, settings), timed=True)]


def take_times(n: int, rounds: int, settings: Settings) -> list[Row]:
    """Nanoseconds a pair from an (N, 4, 2) array: making both ready, the first question, and one more.

    What a method works out at the first question and keeps is counted there, not hidden by a warm-up; only
    the first round, in which code is compiled and loaded, is left out.
    """
    rng = settings.rng("reuse")
    a, b = ngons(rng, n, 4, 1.2), ngons(rng, n, 4, 1.2)
    mine = [m for m in all_methods() if m.language in (COMPILED, NUMPY) and m.name not in OMITTED_METHODS]
    mine = [m for m in mine if m.language == COMPILED or m.family == "exact"]
    taken: dict[int, list[tuple[float, float, float]]] = {i: [] for i in range(len(mine))}
    collecting = gc.isenabled()
    gc.disable()
    try:
        for _ in range(rounds + 1):
            for i, method in enumerate(mine):
                taken[i].append(_time_parts(method, a, b))
            gc.collect()
    finally:
        if collecting:
            gc.enable()
    rows = []
    for i, method in enumerate(mine):
        setup, first, again = (median(times) / n * 1e9 for times in zip(*taken[i][1:], strict=True))
        name = method.name if method.language == COMPILED else f"{method.name}, {method.language}"
        for reuse in QUESTION_COUNTS:
            each = [(s + f + (reuse - 1) * g) / reuse / n * 1e9 for s, f, g in taken[i][1:]]
            low, mid, high = quantiles(each, n=4, method="inclusive")
            row = {"method": name, "family": method.family, "reuse": reuse, "ns": mid, "ns_low": low, "ns_high": high}
            rows.append({**row, "ns_setup": setup, "ns_first": first, "ns_again": again, "pairs": n})
    return rows


def _time_parts(method: Method, a: Side, b: Side) -> tuple[float, float, float]:
    start = thread_time()
    ready = method.prepare(a), method.prepare(b)
    made = thread_time()
    method.hits(*ready)
    asked = thread_time()
    method.hits(*ready)
    return made - start, asked - made, thread_time() - asked


def charts(found: dict[str, Any], settings: Settings) -> list[Chart]:
    """A line a method: its time a question when shapes are asked once, ten times, a hundred times."""
    rows: list[Row] = found["reuse-times"]
    of = {(row["method"], row["reuse"]): row for row in rows}
    names = sorted(dict.fromkeys(row["method"] for row in rows), key=lambda name: of[name, 1]["ns"])
    mine = of["satviz", 1] if ("satviz", 1) in of else rows[0]
    title = f"satviz pays beforehand: {format_time(mine['ns_setup'])} to make a pair ready, {format_time(mine['ns_again'])} a question"
    tall = 21.0
    size = 760.0, 112 + tall * len(names)

    def draw(fig: Figure, theme: Theme) -> None:
        pairs = rows[0]["pairs"]
        under = (
            f"time a question, with its share of making the shapes ready; {pairs:,} pairs of 4-gons from one array each"
        )
        draw_headline(fig, theme, title, under)
        ax = add_axes(fig, (0.2, 42 / size[1], 0.78, tall * len(names) / size[1]), theme)
        for y, name in enumerate(names):
            shade = family_colour(theme, of[name, 1]["family"])
            ns = [of[name, reuse]["ns"] for reuse in QUESTION_COUNTS]
            ax.plot([min(ns), max(ns)], [y, y], color=shade, lw=1, alpha=0.6)
            for reuse, mark, fill in (1, "o", shade), (10, "s", theme.paper), (100, "o", theme.paper):
                ax.plot([of[name, reuse]["ns"]], [y], mark, mec=shade, mfc=fill, ms=7 if reuse == 1 else 6, mew=1.4)
            ax.plot([of[name, 1]["ns_setup"]], [y], "|", color=theme.roles["ink"], ms=12, mew=1.6)
        ax.set(xscale="log", ylim=(len(names) - 0.5, -1.3), xlabel="time a question")
        ax.set_yticks(range(len(names)), names)
        set_time_ticks(ax.xaxis, ax.get_xlim())
        ax.yaxis.minorticks_off()
        ax.spines["left"].set_visible(False)
        ax.tick_params(axis="y", length=0)
        ink: dict[str, Any] = {
            "fontsize": TEXT_POINTS,
            "color": theme.roles["guide"],
            "ha": "right",
            "va": "center_baseline",
        }
        ax.text(
            0.99,
            -0.9,
            "● asked once   □ 10 times   ○ 100 times   | making ready alone",
            transform=ax.get_yaxis_transform(),
            **ink,
        )

    text = ""
    for name in names:
        row = of[name, 1]
        each = [
            f"{format_time(of[name, reuse]['ns'])} a question when asked {reuse} times" for reuse in QUESTION_COUNTS
        ]
        parts = [f"{what} {format_time(row[key])}" for what, key in TIME_PARTS.items()]
        text += f"{name}: {', '.join(each)}; {', '.join(parts)}. "
    return [Chart("cold-and-warm", title, size, draw, rows, text.strip(), timing_warning(rows, settings))]
