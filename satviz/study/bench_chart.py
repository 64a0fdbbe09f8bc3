"""The benchmark as one chart: each work as a multiple of shapely's speed, and time against corners."""

from collections.abc import Sequence
from dataclasses import dataclass

from matplotlib.figure import Figure

from ..pictures import Theme
from .bench import TimingRow
from .bench_table import faster_from, growth_exponent, wrong_counts
from .harness.chart import TEXT_POINTS, Chart, add_axes, draw_headline, label_ends
from .methods import ENGINES

CHART_SIZE = 900.0, 590.0  # points
PREPARED = "shapely, prepared"
MARKS = {"satviz numba": "o", "satviz numpy": "s", PREPARED: "D"}
SHADES = {"satviz numba": "gap", "satviz numpy": "A", PREPARED: "guide", "shapely": "guide"}
DASHES = {"apart": "-", "overlapping": "--", "touching": ":"}
SHAPELY = "shapely"
SUBTITLE = "The speed of shapely, unprepared, is 1. Bars show quartiles. Right: ns a pair against corners."


@dataclass(frozen=True)
class SpeedRatio:
    """How many times as fast as shapely, unprepared, a method is at one work: median and quartiles.

    Above 1 the method is faster than shapely.  `work` is the name of the work with its size.
    """

    section: str
    work: str
    size: int
    method: str
    times: float
    low: float
    high: float


def bench_chart(rows: Sequence[TimingRow], warning: str) -> Chart:
    """Return the chart of these rows; `warning`: why their times are only rough, or empty."""
    ratios, corners = _speed_ratios(rows), [row for row in rows if row.section == "corners"]
    charted = _charted_ratios(rows, ratios)
    reading = " ".join(_fastest_and_slowest(method, charted) for method in _methods_in(charted) if method in ENGINES)
    reading += f" {_slower_works([ratio for ratio in ratios if ratio.method in ENGINES and ratio.times < 1])}"
    if wrong := wrong_counts([row for row in rows if row.method in ENGINES]):
        reading += f" Wrong answers of satviz, both engines together: {wrong}."

    summary = [_summary(method, charted, corners) for method in _methods_in(charted) if method in ENGINES]

    def draw(fig: Figure, theme: Theme) -> None:
        """Draw the headline, the chart of speed ratios and the chart of times against corners."""
        draw_headline(fig, theme, "How many times as fast as shapely", SUBTITLE, *summary)
        _draw_ratios(fig, theme, charted)
        _draw_corners(fig, theme, corners)

    title = "Speed of satviz's batch beside shapely's"
    return Chart("bench", title, CHART_SIZE, draw, [row._asdict() for row in rows], reading, warning)


def _fastest_and_slowest(method: str, ratios: Sequence[SpeedRatio]) -> str:
    """Return a sentence with a method's smallest and largest ratio, the largest also to prepared shapely."""
    own = sorted((r for r in ratios if r.method == method), key=lambda r: r.times)
    least, most = own[0], own[-1]
    text = f"In the left chart {method} is from {_times_in_words(least.times)} as fast as shapely unprepared "
    text += f"({least.work}) to {_times_in_words(most.times)} ({most.work}"
    prepared = next((r for r in ratios if (r.work, r.method) == (most.work, PREPARED)), None)
    return text + (f"; {_times_in_words(most.times / prepared.times)} as fast as prepared)." if prepared else ").")


def _summary(method: str, charted: Sequence[SpeedRatio], corners: Sequence[TimingRow]) -> str:
    """Return in one line a method's largest ratio, to shapely unprepared and prepared, and where it is slower."""
    most = max((r for r in charted if r.method == method), key=lambda r: r.times)
    prepared = next((r for r in charted if (r.work, r.method) == (most.work, PREPARED)), None)
    text = f"{method}: up to {_times_in_words(most.times)} as fast"
    text += f", {_times_in_words(most.times / prepared.times)} as fast as prepared" if prepared else ""
    works = sum(r.method == method and r.times < 1 for r in charted)
    many = []
    for work in dict.fromkeys(row.work for row in corners):
        own, shapely = ({r.size: r.time for r in corners if (r.work, r.method) == (work, m)} for m in (method, SHAPELY))
        if (start := faster_from(shapely, own)) is not None:
            many.append(f"{work} from {start}")
    slower = [f"{works} works at the left"] * bool(works) + [f"{', '.join(many)} corners on"] * bool(many)
    return f"{text} ({most.work}). Slower: {'; '.join(slower) or 'nowhere'}."


def _slower_works(slower: Sequence[SpeedRatio]) -> str:
    """Return sentences that name the works of these ratios, all below 1, by method; or say that there are none."""
    if not slower:
        return "At no work of this run was satviz slower than shapely unprepared."
    parts = []
    for method in dict.fromkeys(r.method for r in slower):
        works = "; ".join(f"{r.work} ({r.times:.2f})" for r in slower if r.method == method)
        parts.append(f"{method} is slower than shapely unprepared here (times as fast in brackets): {works}.")
    return " ".join(parts)


def _speed_ratios(rows: Sequence[TimingRow]) -> list[SpeedRatio]:
    """Return the ratio of each row of a charted method to shapely's row of the same work and size."""
    shapely_rows = {(row.section, row.work, row.size): row for row in rows if row.method == SHAPELY}
    ratios = []
    for row in rows:
        base = shapely_rows.get((row.section, row.work, row.size))
        if base and row.method in MARKS:
            times, low, high = base.time / row.time, base.time / row.high, base.time / row.low
            ratios.append(SpeedRatio(row.section, _work_with_size(row), row.size, row.method, times, low, high))
    return ratios


def _charted_ratios(rows: Sequence[TimingRow], ratios: Sequence[SpeedRatio]) -> list[SpeedRatio]:
    """Return the ratios of the left chart: every work except corners, at its smallest and largest size."""
    ends = {}
    for row in rows:
        sizes = [other.size for other in rows if (other.section, other.work) == (row.section, row.work)]
        ends[row.section, _work_with_size(row)] = row.size in (min(sizes), max(sizes))
    return sorted((r for r in ratios if r.section != "corners" and ends[r.section, r.work]), key=lambda r: r.size)


def _work_with_size(row: TimingRow) -> str:
    """Return the name of a row's work, with its number of boxes or corners where that is varied."""
    if row.section == "broad phase":
        return f"{row.size:,} boxes, {row.work}"
    return f"{row.work}, {row.size} corners" if row.section == "corners" else row.work


def _methods_in(ratios: Sequence[SpeedRatio]) -> list[str]:
    """Return the methods of the left chart that occur in these ratios, in the order of `MARKS`."""
    return [method for method in MARKS if any(r.method == method for r in ratios)]


def _times_in_words(times: float) -> str:
    """Return a speed ratio in words: "12 times", or "3.4 times" with one decimal below 10."""
    return f"{times:.0f} times" if times >= 10 else f"{times:.1f} times"


def _draw_ratios(fig: Figure, theme: Theme, ratios: Sequence[SpeedRatio]) -> None:
    """Draw the left chart: a row for each work, a mark for each method, bars for quartiles."""
    ax = add_axes(fig, (0.275, 0.095, 0.26, 0.72), theme)
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
    ax.text(1, 0.95, "shapely", color=theme.roles["guide"], fontsize=TEXT_POINTS, ha="center", va="bottom")
    for k, method in enumerate(_methods_in(ratios)):
        shade, x = theme.roles[SHADES[method]], -0.3 + 0.42 * k
        ax.plot(x, 1.05, MARKS[method], color=shade, ms=7, transform=ax.transAxes, clip_on=False)
        ax.text(x + 0.04, 1.05, method, color=shade, fontsize=TEXT_POINTS, va="center", transform=ax.transAxes)


def _draw_corners(fig: Figure, theme: Theme, rows: Sequence[TimingRow]) -> None:
    """Draw the right chart: time against the number of corners, with the exponent of the growth at each line's end."""
    ax = add_axes(fig, (0.6, 0.095, 0.22, 0.72), theme)
    ends = []
    for work, method in dict.fromkeys((row.work, row.method) for row in rows):
        own = [row for row in rows if (row.work, row.method) == (work, method)]
        shade = theme.roles[SHADES[method]]
        ax.plot([r.size for r in own], [r.time for r in own], DASHES[work], color=shade, lw=1.8)
        growth = growth_exponent({r.size: r.time for r in own})
        ends.append((own[-1].size, own[-1].time, f"{method.removeprefix('satviz ')}, {work}: V^{growth:.1f}", shade))
    ax.set_xscale("log", base=2)
    ax.set_yscale("log")
    sizes = sorted({row.size for row in rows})
    ax.set_xticks(sizes, [f"{v}" for v in sizes])
    ax.set_xlabel("corners of each polygon")
    ax.set_title("ns a pair", loc="left", color=theme.roles["ink"], fontsize=TEXT_POINTS + 1, fontweight="bold")
    label_ends(ax, ends)
