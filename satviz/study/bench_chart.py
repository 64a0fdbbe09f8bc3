"""The benchmark as one chart: each work as a multiple of shapely's speed, and time against corners."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from matplotlib.figure import Figure

from ..pictures import Theme
from ..render.chart import TEXT_POINTS, WIDTH, Chart, add_axes, add_text, share_of
from .bench import TimingRow
from .bench_table import faster_from, growth_exponent, spread_of, wrong_counts
from .harness.chart import label_ends, set_time_ticks
from .methods import ENGINES

ROW, CORNERS = 34.0, 250.0  # points: the height of a work, and of the chart against corners
PREPARED = "shapely, prepared"
MARKS = {"satviz numba": "o", "satviz numpy": "s", PREPARED: "D"}
SHADES = {"satviz numba": "gap", "satviz numpy": "A", PREPARED: "guide", "shapely": "guide"}
DASHES = {"apart": "-", "overlapping": "--", "touching": ":"}
SHAPELY = "shapely"
SUBTITLE = "Bars show quartiles. Lower chart: at its end a time grows as the shown power of V, the number of corners."


@dataclass(frozen=True)
class SpeedRatio:
    """The ratio of a method's speed to that of unprepared shapely at one work: median and quartiles.

    Above 1 the method is faster than shapely.  `work` is the name of the work with its size.
    """

    section: str
    work: str
    size: int
    method: str
    times: float
    low: float
    high: float

    def is_slower(self) -> bool:
        """Return whether the method is slower than shapely: the whole interval is below 1."""
        return self.high < 1


def bench_chart(rows: Sequence[TimingRow], warning: str) -> Chart:
    """Return the chart of these rows; `warning`: why their times are only rough, or empty."""
    ratios, corners = _speed_ratios(rows), [row for row in rows if row.section == "corners"]
    charted = _charted_ratios(rows, ratios)
    reading = " ".join(_fastest_and_slowest(method, charted) for method in _methods_in(charted) if method in ENGINES)
    reading += f" {_slower_works([ratio for ratio in ratios if ratio.method in ENGINES and ratio.is_slower()])}"
    if wrong := wrong_counts([row for row in rows if row.method in ENGINES]):
        reading += f" Wrong answers of satviz, both engines together: {wrong}."

    engines = [method for method in _methods_in(charted) if method in ENGINES]
    title = ", ".join(
        f"{method} is {_range_in_words([ratio.times for ratio in charted if ratio.method == method])}"
        for method in engines
    )
    title += " as fast as shapely unprepared (upper chart)"
    slower = "; ".join(f"{method} {_where_slower(method, charted, corners)}" for method in engines)
    works = list(dict.fromkeys(ratio.work for ratio in charted))
    lines = [SUBTITLE, f"Slower than shapely: {slower}."]
    height = ROW * len(works) + CORNERS + 190

    def draw(fig: Figure, theme: Theme) -> None:
        """Draw the chart of speed ratios and the chart of times against corners."""
        _draw_ratios(fig, theme, charted, height)
        _draw_corners(fig, theme, corners)

    return Chart("bench", title, lines, height, draw, [row._asdict() for row in rows], reading, warning)


def _fastest_and_slowest(method: str, ratios: Sequence[SpeedRatio]) -> str:
    """Return a sentence with a method's smallest and largest ratio of speed to shapely unprepared, both medians.

    On the workload of the largest ratio, the sentence has the ratio to prepared shapely too.
    """
    own = [r for r in ratios if r.method == method]
    least, most = (pick(own, key=lambda r: r.times) for pick in (min, max))
    text = f"In the upper chart {method} is from {_times_in_words(least.times)} as fast as shapely unprepared "
    text += f"({least.work}) to {_times_in_words(most.times)} ({most.work}"
    prepared = next((r for r in ratios if (r.work, r.method) == (most.work, PREPARED)), None)
    return text + (f"; {_times_in_words(most.times / prepared.times)} as fast as prepared)." if prepared else ").")


def _where_slower(method: str, charted: Sequence[SpeedRatio], corners: Sequence[TimingRow]) -> str:
    """Return in words where a method is slower than unprepared shapely: in which works, and from how many corners."""
    works = sum(r.method == method and r.is_slower() for r in charted)
    many = []
    for work in dict.fromkeys(row.work for row in corners):
        own, shapely = ({r.size: spread_of(r) for r in corners if (r.work, r.method) == (work, m)}
                        for m in (method, SHAPELY))  # fmt: skip
        if (start := faster_from(shapely, own)) is not None:
            many.append(f"{work} from {start}")
    slower = [f"in {works} work{'s' * (works > 1)} of the upper chart"] * bool(works) + [
        f"{', '.join(many)} corners on"
    ] * bool(many)
    return ", ".join(slower) or "nowhere"


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
            times, low, high = base.time / row.time, base.low / row.high, base.high / row.low
            ratios.append(SpeedRatio(row.section, _work_with_size(row), row.size, row.method, times, low, high))
    return ratios


def _charted_ratios(rows: Sequence[TimingRow], ratios: Sequence[SpeedRatio]) -> list[SpeedRatio]:
    """Return the ratios of the first chart: every work except corners, at its smallest and largest size."""
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
    """Return the methods of the first chart that occur in these ratios, in the order of `MARKS`."""
    return [method for method in MARKS if any(r.method == method for r in ratios)]


def _times_in_words(times: float) -> str:
    """Return a speed ratio in words: "12 times", or "3.4 times" with one decimal below 10."""
    return f"{times:.0f} times" if times >= 10 else f"{times:.1f} times"


def _range_in_words(times: Sequence[float]) -> str:
    """Return the smallest and the largest of these speed ratios in words: "0.5 to 46 times"."""
    return " to ".join(dict.fromkeys((_times_in_words(min(times)).removesuffix(" times"), _times_in_words(max(times)))))


def _draw_ratios(fig: Figure, theme: Theme, ratios: Sequence[SpeedRatio], height: float) -> None:
    """Draw the first chart below the headline: a row for each work, a mark for each method, bars for quartiles.

    height: of the whole figure, in points.
    """
    works = list(dict.fromkeys(r.work for r in ratios))
    tall = ROW * len(works)
    ax = add_axes(fig, (12, height - 60 - tall, WIDTH - 24, tall), theme)
    ax.set(xscale="log", ylim=(tall, 0), yticks=[])
    ax.spines["left"].set_visible(False)
    ax.axvline(1, color=theme.roles["guide"], lw=1)
    for ratio in ratios:
        y, shade = ROW * (works.index(ratio.work) + 0.72), theme.roles[SHADES[ratio.method]]
        ax.plot([ratio.low, ratio.high], [y, y], color=shade, lw=1.5)
        ax.plot(ratio.times, y, MARKS[ratio.method], color=shade, ms=7)
    style: dict[str, Any] = {"fontsize": TEXT_POINTS, "va": "center", "parse_math": False}
    for k, work in enumerate(works):
        ax.axhline(ROW * k, color=theme.roles["guide"], lw=0.4)
        ax.text(1, ROW * (k + 0.25), work, transform=ax.get_yaxis_transform(), ha="right", color=theme.roles["ink"],
                bbox={"facecolor": theme.paper, "edgecolor": "none", "pad": 1}, **style)  # fmt: skip
    ticks = [t for t in (0.5, 1, 2, 5, 10, 20, 50, 100, 200) if ax.get_xlim()[0] <= t <= ax.get_xlim()[1]]
    ax.set_xticks(ticks, [f"{t:g}" for t in ticks])
    ax.minorticks_off()
    ax.set_xlabel("times as fast as shapely unprepared")
    for method, left in zip(_methods_in(ratios), (12.0, 124.0, 236.0), strict=False):
        shade, (x, y) = theme.roles[SHADES[method]], share_of(fig, left, height - 26)
        ax.plot(x, y, MARKS[method], color=shade, ms=7, transform=fig.transFigure, clip_on=False)
        add_text(fig, left + 10, height - 26, method, color=theme.roles["ink"], va="center")


def _draw_corners(fig: Figure, theme: Theme, rows: Sequence[TimingRow]) -> None:
    """Draw the second chart: time against the number of corners, with the exponent of growth at each line's end."""
    ax = add_axes(fig, (56, 50, 160, CORNERS), theme, "Time for a pair")
    ends = []
    for work, method in dict.fromkeys((row.work, row.method) for row in rows):
        own = [row for row in rows if (row.work, row.method) == (work, method)]
        shade = theme.roles[SHADES[method]]
        ax.plot([r.size for r in own], [r.time for r in own], DASHES[work], color=shade, lw=1.8)
        growth = growth_exponent({r.size: r.time for r in own})
        label = f"{method.removeprefix('satviz ')}, {work}: V^{growth:.1f}"
        ends.append((own[-1].size, own[-1].time, label, theme.text.get(SHADES[method], shade)))
    ax.set(xscale="log", yscale="log")
    sizes = sorted({row.size for row in rows})[1::2]
    ax.set_xticks(sizes, [f"{v}" for v in sizes])
    ax.minorticks_off()
    ax.set_xlabel("corners of each polygon")
    set_time_ticks(ax.yaxis, ax.get_ylim())
    label_ends(ax, ends)
