"""The cost of exactness: the same pairs with more and more of them touching, and each method's time for a pair."""

from functools import partial
from typing import Any

from matplotlib.figure import Figure

from ...pictures import Theme
from ..harness.cells import Cell, JsonRow, Settings
from ..harness.chart import Chart, add_axes, draw_headline, draw_time_curves, format_time
from ..harness.timings import time_jobs, timing_warning
from ..methods import COMPILED, VECTORISED, all_methods
from ..workloads.generators import ngons
from ..workloads.hard_pairs import touching_triangles

TOUCHING_SHARES = (0.0, 0.001, 0.01, 0.1, 0.3, 1.0)
LINE_STYLES = {
    "satviz": "-", "satviz, no filter": "-", "orientation, adaptive": "--", "orientation, floats": "--",
    "orientation, expansions": ":", "SAT, unit normals": "-", "shapely": "-",
}  # fmt: skip


def cells(settings: Settings) -> list[Cell]:
    """Return one cell, which times the methods at every share of touching pairs."""
    n, rounds = (40_000, 4) if settings.quick else (100_000, 21)
    return [Cell("price-times", take_times, (n, rounds, settings), timed=True)]


def take_times(n: int, rounds: int, settings: Settings) -> list[JsonRow]:
    """Return each method's ns per pair of triangles at each share of pairs that touch exactly."""
    rng = settings.rng("price")
    rows = []
    random_a, random_b = ngons(rng, n, 3, 0.9), ngons(rng, n, 3, 0.9)
    touching_a, touching_b = touching_triangles(rng, n)
    order = rng.permutation(n)
    for share in TOUCHING_SHARES:
        chosen = order[: round(share * n)]
        a, b = random_a.copy(), random_b.copy()
        a[chosen], b[chosen] = touching_a[chosen], touching_b[chosen]
        methods = {m.name: m for m in all_methods() if m.language == COMPILED and m.name in LINE_STYLES}
        jobs = {name: partial(m.hits, m.prepare(a), m.prepare(b)) for name, m in methods.items()}
        for name, times in time_jobs(jobs, rounds, dict.fromkeys(jobs, n)).items():
            rows.append({"share": share, "method": name, "family": methods[name].family, "pairs": n, **times})
    return rows


def charts(found: dict[str, Any], settings: Settings) -> list[Chart]:
    """Return the chart of time against the share of touching pairs, one line for each method."""
    rows: list[JsonRow] = found["price-times"]
    ns = {(row["method"], row["share"]): row["ns"] for row in rows}
    cost = {s: ns["satviz", s] - ns["satviz, no filter", s] for s in TOUCHING_SHARES if ("satviz", s) in ns}
    title, text = "The cost of exact answers", ""
    if cost:
        few, all_pairs = format_time(max(cost[0.001], 0.0)), format_time(cost[1.0])
        title = f"An exact answer costs {few} more for a pair where 1 in 1,000 touches, {all_pairs} where all do"
        costs = ", ".join(f"{format_time(ns)} with {share:.1%} touching" for share, ns in cost.items())
        text = f"satviz takes longer than the same kernel without a filter by: {costs}. Making and checking the shapes "
        text += f"is not in these times. {VECTORISED} "
    names = [name for name in LINE_STYLES if (name, 0.0) in ns]
    each = [f"{n}: {format_time(ns[n, 0.0])} where none touch, {format_time(ns[n, 1.0])} where all do." for n in names]
    families = {row["method"]: row["family"] for row in rows}

    def draw(fig: Figure, theme: Theme) -> None:
        """Draw for each method its time against the share of touching pairs."""
        line = (
            f"Time of the answer alone; {rows[0]['pairs']:,} pairs of triangles, made beforehand. Bars show quartiles."
        )
        draw_headline(fig, theme, title, line)
        ax = add_axes(fig, (0.085, 0.14, 0.66, 0.69), theme)
        styles = {name: (families[name], LINE_STYLES[name]) for name in names}
        draw_time_curves(ax, theme, range(len(TOUCHING_SHARES)), rows, styles)
        ax.set_xlabel("share of pairs that touch exactly")
        labels = [f"{share:.1%}" if 0 < share < 0.01 else f"{share:.0%}" for share in TOUCHING_SHARES]
        ax.set_xticks(range(len(labels)), labels)

    warning = timing_warning(rows, settings)
    return [Chart("price-of-exactness", title, (760.0, 400.0), draw, rows, text + " ".join(each), warning)]
