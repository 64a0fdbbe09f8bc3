"""The price of exactness: the same pairs with ever more of them touching, and what each method takes then."""

from functools import partial
from typing import Any

from matplotlib.figure import Figure

from ...pictures import Theme
from ..harness.cells import Cell, Settings
from ..harness.chart import Chart, axes, colour, headline, label_ends, time_ticks, told
from ..harness.times import rough, timed
from ..methods import COMPILED, VECTORISED, methods
from ..workloads.hard import touching
from ..workloads.workloads import ngons

Row = dict[str, Any]
SHARES = (0.0, 0.001, 0.01, 0.1, 0.3, 1.0)
SHOWN = {
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
    plain, hard = (ngons(rng, n, 3, 0.9), ngons(rng, n, 3, 0.9)), touching(rng, n)
    order = rng.permutation(n)
    for share in SHARES:
        some = order[: round(share * n)]
        a, b = plain[0].copy(), plain[1].copy()
        a[some], b[some] = hard[0][some], hard[1][some]
        mine = {m.name: m for m in methods() if m.language == COMPILED and m.name in SHOWN}
        jobs = {name: partial(m.hits, m.prepare(a), m.prepare(b)) for name, m in mine.items()}
        families = {name: m.family for name, m in mine.items()}
        for name, times in timed(jobs, rounds, dict.fromkeys(jobs, n)).items():
            rows.append({"share": share, "method": name, "family": families[name], "pairs": n, **times})
    return rows


def charts(found: dict[str, Any], settings: Settings) -> list[Chart]:
    """Time against the share of hard pairs, a line a method; the share is an order, so lines may join it."""
    rows: list[Row] = found["price-times"]
    ns = {(row["method"], row["share"]): row["ns"] for row in rows}
    cost = {s: ns["satviz", s] - ns["satviz, no filter", s] for s in SHARES if ("satviz", s) in ns}
    title, text = "The price of exactness", ""
    if cost:
        few, every = told(max(cost[0.001], 0.0)), told(cost[1.0])
        title = f"The exact answer takes {few} more a pair where one in a thousand touches, {every} where all do"
        each = ", ".join(f"{told(ns)} with {share:.1%} touching" for share, ns in cost.items())
        text = f"What satviz's answer takes beyond the same kernel without a filter: {each}. Making and checking "
        text += f"the shapes is not in these times. {VECTORISED} "
    names = [name for name in SHOWN if (name, 0.0) in ns]
    text += " ".join(f"{n}: {told(ns[n, 0.0])} where none touch, {told(ns[n, 1.0])} where all do." for n in names)

    def draw(fig: Figure, theme: Theme) -> None:
        under = (
            f"time of the answer alone, shapes made and checked beforehand; {rows[0]['pairs']:,} pairs of triangles; "
            "bars: quartiles"
        )
        headline(fig, theme, title, under)
        ax = axes(fig, (0.085, 0.14, 0.66, 0.69), theme)
        ends = []
        for name, style in SHOWN.items():
            mine = [row for row in rows if row["method"] == name]
            if not mine:
                continue
            shade, xs = colour(theme, mine[0]["family"]), range(len(mine))
            ax.plot(xs, [row["ns"] for row in mine], color=shade, ls=style, lw=1.8, marker="o", ms=4)
            for x, row in zip(xs, mine, strict=True):
                ax.plot([x, x], [row["ns_low"], row["ns_high"]], color=shade, lw=1)
            ink = colour(theme, mine[0]["family"], text=True)
            ends.append((len(mine) - 1, mine[-1]["ns"], f"{name}: {told(mine[-1]['ns'])}", ink))
        ax.set(yscale="log", xlabel="share of pairs that touch exactly")
        ax.set_xticks(range(len(SHARES)), [f"{share:.1%}" if 0 < share < 0.01 else f"{share:.0%}" for share in SHARES])
        time_ticks(ax.yaxis, ax.get_ylim())
        label_ends(ax, ends, gap=15)

    return [Chart("price-of-exactness", title, (760.0, 400.0), draw, rows, text, rough(rows, settings))]
