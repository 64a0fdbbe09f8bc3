"""The price of exactness: satviz against plain SAT in float64, where more and more pairs touch, and beside an outlier.

Question: what does an exact answer cost more than a float answer?  Workload: pairs of 4-gons, a share of which touch
exactly, and the same with one 4-gon 2^k times as large.  Methods: plain SAT and satviz, for the answer alone and
from the arrays; shapely.  The claim is refuted by a workload of such pairs on which satviz takes longer than the
chart's largest price.
"""

from collections.abc import Sequence
from functools import partial
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from ...pictures import Theme
from ...render.chart import TEXT_POINTS, Chart, JsonRow, add_axes
from ..harness import timings
from ..harness.cells import Cell, Settings
from ..harness.chart import draw_time_curves, format_time
from ..methods import COMPILED, VECTORISED, all_methods
from ..workloads.generators import Rings, ngons
from ..workloads.hard_pairs import touching_quadrilaterals

TOUCHING_SHARES = (0.0, 0.001, 0.01, 0.1, 1.0)
OUTLIERS = (5, 10, 20)  # log2 of how much larger one 4-gon is
TICKS = {0.0: "0%", 0.001: "0.1%", 0.01: "1%", 0.1: "10%", 1.0: "100%", 5: "2⁵", 10: "2¹⁰", 20: "2²⁰"}
PLAIN, EXACT = "SAT, raw normals", "satviz"
LINES = {  # by (method, column): (label, family, line style)
    ("shapely", "ns"): ("shapely", "library", "-"),
    (EXACT, "whole"): ("satviz from arrays", "exact", "--"),
    (PLAIN, "whole"): ("SAT from arrays", "float SAT", "--"),
    (EXACT, "ns"): ("satviz, answer", "exact", "-"),
    (PLAIN, "ns"): ("SAT, answer", "float SAT", "-"),
}


def cells(settings: Settings) -> list[Cell]:
    """Return a cell for each process, which times the methods at each share of touching pairs and each outlier size."""
    return timings.cells_by_process(
        "price", take_times, ((20_000, 3) if settings.quick else (100_000, 7)) + (settings,), settings
    )


def workloads(n: int, rng: np.random.Generator) -> dict[tuple[str, float], tuple[Rings, Rings]]:
    """Return n pairs of 4-gons for each workload.

    Keys: ("touching", share of touching pairs), or ("outlier", k) for one 4-gon that is 2**k times as large.
    """
    random_a, random_b = ngons(rng, n, 4, 1.2), ngons(rng, n, 4, 1.2)
    touching_a, touching_b = touching_quadrilaterals(rng, n)
    order, found = rng.permutation(n), {}
    for share in TOUCHING_SHARES:
        a, b, chosen = random_a.copy(), random_b.copy(), order[: round(share * n)]
        a[chosen], b[chosen] = touching_a[chosen], touching_b[chosen]
        found["touching", share] = a, b
    for power in OUTLIERS:
        a = random_a.copy()
        a[n // 2] *= 2.0**power
        found["outlier", float(power)] = a, random_b
    return found


def take_times(n: int, rounds: int, settings: Settings) -> list[JsonRow]:
    """Return for each workload and method the ns for a pair: `ns` of the answer alone, `whole` from the arrays.

    `whole` is 0 for a method that has no time from arrays.
    """
    timed = []
    methods = {m.name: m for m in all_methods() if m.language == COMPILED and (m.name, "ns") in LINES}

    for (what, much), (a, b) in workloads(n, settings.rng("price")).items():
        jobs = {f"{name}/ns": partial(m.hits, m.prepare(a), m.prepare(b)) for name, m in methods.items()}
        whole = [name for name, key in LINES if key == "whole" and name in methods]
        jobs |= {f"{name}/whole": partial(methods[name].from_arrays, a, b) for name in whole}
        times = timings.time_jobs(jobs, rounds, dict.fromkeys(jobs, n))
        timed += [{"what": what, "much": much, "method": name, "pairs": n, "ns": times[f"{name}/ns"],
                  "whole": times.get(f"{name}/whole", 0.0)} for name in methods]  # fmt: skip
    return timed


def rows(found: dict[str, Any]) -> dict[str, list[JsonRow]]:
    """Return {stem of the chart: its rows}, no rows where plain SAT is not compiled; found: results by cell name."""
    merged = timings.over_processes(found, "price", ("ns", "whole"))
    return {"price-of-exactness": merged if any(row["method"] == PLAIN for row in merged) else []}


def chart(rows: Sequence[JsonRow], settings: Settings) -> Chart:
    """Return the chart of two panels: times against the share of touching pairs, and against the outlier's size."""
    by = {(row["what"], row["much"], row["method"]): row for row in rows}

    def ratio(what: str, much: float, column: str = "ns") -> str:
        """Return how many times as long as plain SAT satviz takes on workload (what, much), with its interval."""
        own, plain = (by[what, much, name][f"{column}_runs"] for name in (EXACT, PLAIN))
        return timings.format_ratio(timings.ratio_interval(own, plain))

    title = (
        f"For an answer satviz takes {ratio('touching', 0.0)} as long as plain SAT where no pair touches, and "
        f"{ratio('touching', 1.0)} where all do"
    )
    lines = (
        f"Time for a pair, with {rows[0]['pairs']:,} pairs of 4-gons in a call. Bars: the spread of the processes. "
        f"Beside one shape that is a million times as large it takes {ratio('outlier', float(OUTLIERS[-1]))} as long. "
        "Not charted: sizes whose products leave the range of float64, where an exact answer takes far longer.",
    )

    def draw(fig: Figure, theme: Theme) -> None:
        """Draw both panels on one scale of time."""
        shown = [row[column] for row in rows for name, column in LINES if row["method"] == name]
        limits = min(shown) / 1.5, max(shown) * 1.5
        panels = (
            ("touching", TOUCHING_SHARES, 284.0, "share of pairs that touch"),
            ("outlier", OUTLIERS, 58.0, "how many times as large one 4-gon is"),
        )
        for what, steps, bottom, words in panels:
            ax = add_axes(fig, (56, bottom, 196, 176), theme)
            ax.set(ylim=limits)
            own = [row for row in rows if row["what"] == what]
            draw_time_curves(ax, theme, range(len(steps)), own, LINES)
            names = [TICKS[step] for step in steps]
            ax.set_xticks(range(len(steps)), names)
            ax.set_xlabel(words, fontsize=TEXT_POINTS)

    text = f"{title}. satviz against plain SAT, with {timings.interval_in_words(len(rows[0]['ns_runs']))}: "
    ratios = []
    for what, steps in ("touching", TOUCHING_SHARES), ("outlier", OUTLIERS):
        for much in steps:
            for column, kind in ("ns", "the answer"), ("whole", "from the arrays"):
                words = f"{much:.1%} touching" if what == "touching" else f"one 4-gon 2^{much} times as large"
                plain, exact = (by[what, float(much), name][column] for name in (PLAIN, EXACT))
                ratios.append(f"{words}, {kind}: {ratio(what, float(much), column)}, {format_time(exact)} "
                            f"against {format_time(plain)}")  # fmt: skip
    text += f"{'; '.join(ratios)}. {VECTORISED}"
    return Chart("price-of-exactness", title, lines, 470, draw, rows, text, timings.timing_warning(rows, settings))


CHARTS = {"price-of-exactness": chart}
