"""The bench as one chart: each work as a multiple of shapely's speed, and time against corners."""

from collections.abc import Sequence
from dataclasses import dataclass

from matplotlib.figure import Figure

from ..pictures import Theme
from .bench import ENGINES, Row, slope
from .lab.chart import TEXT, Chart, axes, headline, label_ends

SIZE = 900.0, 560.0  # points
MARKS = {"satviz numba": "o", "satviz numpy": "s"}
DASHES = {"apart": "-", "overlapping": "--", "touching": ":"}
BASE = "shapely"


@dataclass(frozen=True)
class Ratio:
    """How many times as fast as shapely an engine is at a work; over 1 it is faster."""

    work: str
    method: str
    times: float
    low: float
    high: float


def chart(rows: Sequence[Row], rough: str) -> Chart:
    """The chart of these rows; `rough` says why their times are not for keeps, if they are not."""
    ratios, corners = _ratios(rows), [row for row in rows if row.section == "corners"]
    best = {
        method: max((r for r in ratios if r.method == method), key=lambda r: r.times) for method in _methods(ratios)
    }
    least = {method: min((r for r in ratios if r.method == method), key=lambda r: r.times) for method in best}
    reading = " ".join(
        f"{method}: from {_factor(least[method].times)} as fast as shapely ({least[method].work}) "
        f"to {_factor(best[method].times)} ({best[method].work})."
        for method in best
    )
    wrong, checked = (
        sum(r.wrong for r in rows if r.method in ENGINES),
        sum(r.checked for r in rows if r.method in ENGINES),
    )
    reading += f" Wrong answers of satviz: {wrong:,} of {checked:,} checked."

    def draw(fig: Figure, theme: Theme) -> None:
        title = "How many times as fast as shapely, and every answer exact"
        headline(fig, theme, title if not wrong else "How many times as fast as shapely")
        _draw_ratios(fig, theme, ratios)
        _draw_corners(fig, theme, corners)

    title = "Speed of satviz's batch beside shapely's"
    return Chart("bench", title, SIZE, draw, [row._asdict() for row in rows], reading, rough)


def _ratios(rows: Sequence[Row]) -> list[Ratio]:
    """One for each work and engine that shapely did too; of works with sizes the largest."""
    found = []
    for section, work in dict.fromkeys((row.section, row.work) for row in rows if row.section != "corners"):
        mine = [row for row in rows if (row.section, row.work) == (section, work)]
        most = max(row.size for row in mine)
        base = next((row for row in mine if row.method == BASE and row.size == most), None)
        for row in mine:
            if base and row.size == most and row.method.startswith("satviz") and row.method.split(",")[0] in ENGINES:
                if "threads" in row.method:
                    continue
                name = f"{most:,} boxes, {work}" if section == "broad phase" else work
                found.append(Ratio(name, row.method, base.time / row.time, base.time / row.high, base.time / row.low))
    return found


def _methods(ratios: Sequence[Ratio]) -> list[str]:
    return [method for method in MARKS if any(r.method == method for r in ratios)]


def _factor(times: float) -> str:
    return f"{times:.0f} times" if times >= 10 else f"{times:.1f} times"


def _draw_ratios(fig: Figure, theme: Theme, ratios: Sequence[Ratio]) -> None:
    ax = axes(fig, (0.275, 0.1, 0.26, 0.75), theme)
    works = list(dict.fromkeys(r.work for r in ratios))
    places = {work: -k for k, work in enumerate(works)}
    ax.axvline(1, color=theme.roles["guide"], lw=1)
    shades = {"satviz numba": "gap", "satviz numpy": "A"}
    for ratio in ratios:
        y, shade = places[ratio.work], theme.roles[shades[ratio.method]]
        ax.plot([ratio.low, ratio.high], [y, y], color=shade, lw=1.5)
        ax.plot(ratio.times, y, MARKS[ratio.method], color=shade, ms=7)
    ax.set_xscale("log")
    ax.set(yticks=list(places.values()), yticklabels=works, ylim=(-len(works) + 0.4, 0.9))
    ax.tick_params(axis="y", length=0)
    ticks = [t for t in (0.5, 1, 2, 5, 10, 20, 50, 100, 200) if ax.get_xlim()[0] <= t <= ax.get_xlim()[1]]
    ax.set_xticks(ticks, [f"{t:g}" for t in ticks])
    ax.set_xlabel("times as fast as shapely")
    ax.text(1, 0.95, "shapely", color=theme.roles["guide"], fontsize=TEXT, ha="center", va="bottom")
    for k, method in enumerate(_methods(ratios)):
        shade = theme.roles[shades[method]]
        ax.plot(0.04 + 0.5 * k, 1.05, MARKS[method], color=shade, ms=7, transform=ax.transAxes, clip_on=False)
        ax.text(0.08 + 0.5 * k, 1.05, method, color=shade, fontsize=TEXT, va="center", transform=ax.transAxes)


def _draw_corners(fig: Figure, theme: Theme, rows: Sequence[Row]) -> None:
    ax = axes(fig, (0.6, 0.1, 0.22, 0.75), theme)
    shades = {"satviz numba": "gap", "satviz numpy": "A", BASE: "guide"}
    ends = []
    for work, method in dict.fromkeys((row.work, row.method) for row in rows):
        mine = [row for row in rows if (row.work, row.method) == (work, method)]
        shade = theme.roles[shades[method]]
        ax.plot([r.size for r in mine], [r.time for r in mine], DASHES[work], color=shade, lw=1.8)
        growth = slope({r.size: r.time for r in mine})
        ends.append((mine[-1].size, mine[-1].time, f"{method.removeprefix('satviz ')}, {work}: V^{growth:.1f}", shade))
    ax.set_xscale("log", base=2)
    ax.set_yscale("log")
    sizes = sorted({row.size for row in rows})
    ax.set_xticks(sizes, [f"{v}" for v in sizes])
    ax.set_xlabel("corners of each polygon")
    ax.set_title("ns a pair", loc="left", color=theme.roles["ink"], fontsize=TEXT + 1, fontweight="bold")
    label_ends(ax, ends)
