"""The bench as one chart: each work as a multiple of shapely's speed, and time against corners."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from matplotlib.figure import Figure

from ..pictures import Theme
from .bench import ENGINES, Row, checked, slope
from .harness.chart import TEXT, Chart, axes, headline, label_ends

SIZE = 900.0, 560.0  # points
PREPARED = "shapely, prepared"
MARKS = {"satviz numba": "o", "satviz numpy": "s", PREPARED: "D"}
SHADES = {"satviz numba": "gap", "satviz numpy": "A", PREPARED: "guide", "shapely": "guide"}
DASHES = {"apart": "-", "overlapping": "--", "touching": ":"}
BASE = "shapely"
UNDER = "shapely unprepared is 1; bars: quartiles; lines: times in ns a pair against corners"


@dataclass(frozen=True)
class Ratio:
    """How many times as fast as shapely, unprepared, a method is at a work; over 1 it is faster."""

    work: str
    size: int
    method: str
    times: float
    low: float
    high: float


def chart(rows: Sequence[Row], rough: str) -> Chart:
    """The chart of these rows; `rough` says why their times are not for keeps, if they are not."""
    ratios, corners = _ratios(rows), [row for row in rows if row.section == "corners"]
    reading = " ".join(_range(method, ratios) for method in _methods(ratios) if method in ENGINES)
    every = [Ratio(_at(row), row.size, row.method, *_times(row, base)) for row, base in _beside_shapely(rows)]
    slower = [ratio for ratio in every if ratio.method in ENGINES and ratio.times < 1]
    reading += f" {_slower(slower)}"
    if told := checked([row for row in rows if row.method in ENGINES]):
        reading += f" Wrong answers of satviz, both engines together: {told}."

    def draw(fig: Figure, theme: Theme) -> None:
        headline(fig, theme, "How many times as fast as shapely", UNDER)
        _draw_ratios(fig, theme, ratios)
        _draw_corners(fig, theme, corners)

    title = "Speed of satviz's batch beside shapely's"
    return Chart("bench", title, SIZE, draw, [row._asdict() for row in rows], reading, rough)


def _range(method: str, ratios: Sequence[Ratio]) -> str:
    """The least and the most of an engine, and where prepared shapely stands at the most."""
    mine = sorted((r for r in ratios if r.method == method), key=lambda r: r.times)
    least, most = mine[0], mine[-1]
    text = f"In the left chart {method} is from {_factor(least.times)} as fast as shapely unprepared ({least.work}) "
    text += f"to {_factor(most.times)} ({most.work}"
    prepared = next((r for r in ratios if (r.work, r.method) == (most.work, PREPARED)), None)
    return text + (f"; {_factor(most.times / prepared.times)} as fast as prepared)." if prepared else ").")


def _slower(slower: Sequence[Ratio]) -> str:
    """Every work and size at which an engine took longer than shapely."""
    if not slower:
        return "Nowhere in this run was satviz slower than shapely unprepared."
    parts = []
    for method in dict.fromkeys(r.method for r in slower):
        each = "; ".join(f"{r.work} ({r.times:.2f})" for r in slower if r.method == method)
        parts.append(f"{method} is slower than shapely unprepared here (times as fast in brackets): {each}.")
    return " ".join(parts)


def _ratios(rows: Sequence[Row]) -> list[Ratio]:
    """Those of the left chart: all but corners, and of works with sizes the smallest and the largest."""
    found = []
    for row, base in _beside_shapely(rows):
        sizes = [other.size for other in rows if (other.section, other.work) == (row.section, row.work)]
        if row.section != "corners" and row.size in (min(sizes), max(sizes)):
            found.append(Ratio(_at(row), row.size, row.method, *_times(row, base)))
    return sorted(found, key=lambda r: r.size)


def _beside_shapely(rows: Sequence[Row]) -> Iterator[tuple[Row, Row]]:
    """Each row of a method with a mark, and shapely's at the same work and size."""
    bases = {(row.section, row.work, row.size): row for row in rows if row.method == BASE}
    for row in rows:
        base = bases.get((row.section, row.work, row.size))
        if base and row.method in MARKS:
            yield row, base


def _times(row: Row, base: Row) -> tuple[float, float, float]:
    return base.time / row.time, base.time / row.high, base.time / row.low


def _at(row: Row) -> str:
    """A work with its size."""
    if row.section == "broad phase":
        return f"{row.size:,} boxes, {row.work}"
    return f"{row.work}, {row.size} corners" if row.section == "corners" else row.work


def _methods(ratios: Sequence[Ratio]) -> list[str]:
    return [method for method in MARKS if any(r.method == method for r in ratios)]


def _factor(times: float) -> str:
    return f"{times:.0f} times" if times >= 10 else f"{times:.1f} times"


def _draw_ratios(fig: Figure, theme: Theme, ratios: Sequence[Ratio]) -> None:
    ax = axes(fig, (0.275, 0.1, 0.26, 0.75), theme)
    works = list(dict.fromkeys(r.work for r in ratios))
    places = {work: -k for k, work in enumerate(works)}
    ax.axvline(1, color=theme.roles["guide"], lw=1)
    for ratio in ratios:
        y, shade = places[ratio.work], theme.roles[SHADES[ratio.method]]
        ax.plot([ratio.low, ratio.high], [y, y], color=shade, lw=1.5)
        ax.plot(ratio.times, y, MARKS[ratio.method], color=shade, ms=7)
    ax.set_xscale("log")
    ax.set(yticks=list(places.values()), yticklabels=works, ylim=(-len(works) + 0.4, 0.9))
    ax.tick_params(axis="y", length=0)
    ticks = [t for t in (0.5, 1, 2, 5, 10, 20, 50, 100) if ax.get_xlim()[0] <= t <= ax.get_xlim()[1]]
    ax.set_xticks(ticks, [f"{t:g}" for t in ticks])
    ax.set_xlabel("times as fast as shapely unprepared")
    ax.text(1, 0.95, "shapely", color=theme.roles["guide"], fontsize=TEXT, ha="center", va="bottom")
    for k, method in enumerate(_methods(ratios)):
        shade, x = theme.roles[SHADES[method]], -0.3 + 0.42 * k
        ax.plot(x, 1.05, MARKS[method], color=shade, ms=7, transform=ax.transAxes, clip_on=False)
        ax.text(x + 0.04, 1.05, method, color=shade, fontsize=TEXT, va="center", transform=ax.transAxes)


def _draw_corners(fig: Figure, theme: Theme, rows: Sequence[Row]) -> None:
    ax = axes(fig, (0.6, 0.1, 0.22, 0.75), theme)
    ends = []
    for work, method in dict.fromkeys((row.work, row.method) for row in rows):
        mine = [row for row in rows if (row.work, row.method) == (work, method)]
        shade = theme.roles[SHADES[method]]
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
