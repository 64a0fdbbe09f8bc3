"""The price of exactness: the same pairs with ever more of them touching, and what each method takes then."""

from functools import partial
from typing import Any

from matplotlib.figure import Figure

from ...pictures import Theme
from ..harness.cells import Cell, Settings
from ..harness.chart import Chart, add_axes, draw_headline, family_colour, format_time, label_ends, set_time_ticks
from ..harness.timings import time_jobs, timing_warning
from ..methods import COMPILED, VECTORISED, all_methods
from ..workloads.generators import ngons
from ..workloads.hard_pairs import touching_triangles

Row = dict[str, Any]
TOUCHING_SHARES = (0.0, 0.001, 0.01, 0.1, 0.3, 1.0)
LINE_STYLES = {
    "satviz": "-", "satviz, no filter": "-", "turns, adaptive": "--", "turns, floats": "--", "turns, expansions": ":",
    "SAT, unit normals": "-", "shapely": "-",
}  # fmt: skip


def cells(settings: Settings) -> list[Cell]:
    """One that takes the time at every share."""
    n, rounds = (40_000, 4) if settings.quick else (100_000, 21)
    return [Cell("price-times", take_times, (n, rounds, settings), timed=True)]


def take_times(n: int, rounds: int, settings: Settings) -> list[Row]:
    """Nanoseconds a pair of triangles, of which a share at random places touch exactly."""
    rng = settings.rng("price")
    rows = []
    plain, hard = (ngons(rng, n, 3, 0.9), ngons(rng, n, 3, 0.9)), touching_triangles(rng, n)
    order = rng.permutation(n)
    for share in TOUCHING_SHARES:
        some = order[: round(share * n)]
        a, b = plain[0].copy(), plain[1].copy()
        a[some], b[some] = hard[0][some], hard[1][some]
        mine = {m.name: m for m in all_methods() if m.language == COMPILED and m.name in LINE_STYLES}
        jobs = {name: partial(m.hits, m.prepare(a), m.prepare(b)) for name, m in mine.items()}
        families = {name: m.family for name, m in mine.items()}
        for name, times in time_jobs(jobs, rounds, dict.fromkeys(jobs, n)).items():
            rows.append({"share": share, "method": name, "family": families[name], "pairs": n, **times})
    return rows


def charts(found: dict[str, Any], settings: Settings) -> list[Chart]:
    """Time against the share of hard pairs, a line a method; the share is an order, so lines may join it."""
    rows: list[Row] = found["price-times"]
    ns = {(row["method"], row["share"]): row["ns"] for row in rows}
    cost = {s: ns["satviz", s] - ns["satviz, no filter", s] for s in TOUCHING_SHARES if ("satviz", s) in ns}
    title, text = "The price of exactness", ""
    if cost:
        few, every = format_time(max(cost[0.001], 0.0)), format_time(cost[1.0])
        title = f"The exact answer takes {few} more a pair where one in a thousand touches, {every} where all do"
        each = ", ".join(f"{format_time(ns)} with {share:.1%} touching" for share, ns in cost.items())
        text = f"What satviz's answer takes beyond the same kernel without a filter: {each}. Making and checking "
        text += f"the shapes is not in these times. {VECTORISED} "
    names = [name for name in LINE_STYLES if (name, 0.0) in ns]
    text += " ".join(
        f"{n}: {format_time(ns[n, 0.0])} where none touch, {format_time(ns[n, 1.0])} where all do." for n in names
    )

    def draw(fig: Figure, theme: Theme) -> None:
        under = (
            f"time of the answer alone, shapes made and checked beforehand; {rows[0]['pairs']:,} pairs of triangles; "
            "bars: quartiles"
        )
        draw_headline(fig, theme, title, under)
        ax = add_axes(fig, (0.085, 0.14, 0.66, 0.69), theme)
        ends = []
        for name, style in LINE_STYLES.items():
            mine = [row for row in rows if row["method"] == name]
            if not mine:
                continue
            shade, xs = family_colour(theme, mine[0]["family"]), range(len(mine))
            ax.plot(xs, [row["ns"] for row in mine], color=shade, ls=style, lw=1.8, marker="o", ms=4)
            for x, row in zip(xs, mine, strict=True):
                ax.plot([x, x], [row["ns_low"], row["ns_high"]], color=shade, lw=1)
            ink = family_colour(theme, mine[0]["family"], text=True)
            ends.append((len(mine) - 1, mine[-1]["ns"], f"{name}: {format_time(mine[-1]['ns'])}", ink))
        ax.set(yscale="log", xlabel="share of pairs that touch exactly")
        ax.set_xticks(
            range(len(TOUCHING_SHARES)),
            [f"{share:.1%}" if 0 < share < 0.01 else f"{share:.0%}" for share in TOUCHING_SHARES],
        )
        set_time_ticks(ax.yaxis, ax.get_ylim())
        label_ends(ax, ends, gap=15)

    return [Chart("price-of-exactness", title, (760.0, 400.0), draw, rows, text, timing_warning(rows, settings))]
