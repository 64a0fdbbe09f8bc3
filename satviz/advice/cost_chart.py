"""The chart of a recommendation: the time of each model on these pairs against its number of wrong answers."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, NullFormatter
from matplotlib.transforms import Bbox

from ..pictures import LIGHT, THEMES, Theme
from ..render.files import encode_figure, svg_without_header
from ..render.formats import DPI
from .candidates import AABB, BOUNDING_CIRCLES, EXACT_FILTER, K_DOP, Model
from .costs import Cost
from .records import InputSummary, ModelResult
from .report import duration

SIZE = 620.0, 400.0  # points
BOX = 0.11, 0.14, 0.85, 0.67  # left, bottom, width, height, as fractions of the figure
TEXT, TITLE, SMALL = 10.0, 13.0, 9.0
ROLES = {EXACT_FILTER: "exact", BOUNDING_CIRCLES: "shortcut", AABB: "shortcut", K_DOP: "shortcut"}  # the others: float


class CostChart(NamedTuple):
    """Hold a chart of time per pair against wrong answers: `rows` are the numbers drawn, `sentence` their summary.

    `under`: the line below the title; `advised`: the name of the recommended model; `pairs`: the number of pairs.
    """

    title: str
    under: str
    rows: tuple[tuple[str, str, Cost], ...]  # name, role of the color, cost
    advised: str
    pairs: int
    sentence: str

    def figure(self, theme: Theme = LIGHT) -> Figure:
        """Return the chart on a new Figure."""
        fig = Figure(figsize=(SIZE[0] / 72, SIZE[1] / 72), dpi=DPI)
        FigureCanvasAgg(fig)
        fig.set_facecolor(theme.paper)
        _draw(fig, self, theme)
        return fig

    def encode(self, form: str, theme: Theme | str = LIGHT) -> bytes:
        """Return the bytes of an image file: form "svg", "png" or "pdf"; theme "light" or "dark"."""
        theme = THEMES[theme] if isinstance(theme, str) else theme
        return encode_figure(
            lambda: self.figure(theme), form, stem=f"advice-{theme.name}", title=self.title, sentence=self.sentence
        )

    def svg(self) -> str:
        """Return the chart as text of one SVG element, for a page or a notebook."""
        return svg_without_header(self.encode("svg"))

    def __repr__(self) -> str:
        return self.sentence

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, str]:
        """Return what a notebook shows: the chart and its sentence."""
        return {"text/plain": self.sentence, "image/svg+xml": self.svg()}


def chart(
    model: Model, summary: InputSummary, results: Sequence[ModelResult], found: Mapping[str, Cost | None]
) -> CostChart:
    """Return the chart of all timed candidates; `model` is recommended, `found` has each cost (None: not timed).

    ValueError where there is nothing to draw: no pairs, or a recommended model that is not timed.
    """
    if not found:
        raise ValueError(
            "no two bounding boxes meet, so there is no pair to time: give shapes that lie nearer together"
        )
    mine = found[model.name]
    if mine is None:
        raise ValueError(f"{model.name} was not timed, since one pair takes too long: give shapes with fewer corners")
    timed = [(j.model, cost) for j in results if (cost := found[j.model.name]) is not None]
    rows = tuple((m.name, ROLES.get(m.kind, "float"), cost) for m, cost in timed)
    exact = next((cost for m, cost in timed if m.kind == EXACT_FILTER), None)
    one = summary.pairs + summary.settled == 1
    what = "this pair" if one else f"{summary.pairs:,} pairs{' whose boxes meet' if summary.settled else ''}"
    sentence = (
        f"{model.name} is right for {what}: {duration(mine.warm)} a pair, {duration(mine.cold)} with set-up. "
        f"The exact filter {f'takes {duration(exact.warm)}' if exact else 'is not timed'}."
    )
    of = (
        f"{mine.timed:,} copies of it" if one else "all" if mine.timed == summary.pairs else f"the first {mine.timed:,}"
    )
    under = f"filled: warm, hollow: with set-up; {what}, times of {of} at once"
    return CostChart(f"Right and enough here: {model.name}", under, rows, model.name, summary.pairs, sentence)


def _draw(fig: Figure, chart: CostChart, theme: Theme) -> None:
    """Draw the axes, the time and wrong answers of each model, and the names on a figure."""
    ink, guide = theme.roles["ink"], theme.roles["guide"]
    at: dict[str, Any] = {"ha": "left", "va": "top", "parse_math": False}
    fig.text(0.015, 1 - 9 / SIZE[1], chart.title, color=ink, fontsize=TITLE, fontweight="bold", **at)
    fig.text(0.015, 1 - 30 / SIZE[1], chart.under, color=guide, fontsize=SMALL, **at)
    ax = fig.add_axes(BOX)
    ax.set_facecolor(theme.paper)
    ax.spines[["top", "right"]].set_visible(False)
    ax.spines[["left", "bottom"]].set_color(guide)
    ax.tick_params(which="both", color=guide, labelcolor=ink, labelsize=TEXT, length=3)
    ax.tick_params(which="minor", length=0)
    times = [t for _, _, cost in chart.rows for t in (cost.cold, cost.warm)]
    wrong = [cost.wrong for _, _, cost in chart.rows]
    ax.set_xscale("log")
    ax.set_xlim(min(times) / 1.6, max(times) * 1.6)
    ax.set_yscale("symlog", linthresh=1, linscale=0.6)
    ax.set_ylim(-0.55, max(max(wrong), 1) * 3)
    ax.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:,.0f}"))
    ax.yaxis.set_minor_formatter(NullFormatter())
    ax.xaxis.set_major_formatter(FuncFormatter(lambda value, _: duration(value)))
    ax.xaxis.set_minor_formatter(FuncFormatter(_minor(min(times) / 1.6, max(times) * 1.6)))
    ax.tick_params(axis="x", which="minor", labelsize=TEXT, length=3)
    ax.set_xlabel("time a pair", color=ink, fontsize=TEXT)
    fig.text(0.015, BOX[1] + BOX[3] + 0.025, "wrong answers", color=ink, fontsize=TEXT, ha="left", va="bottom")
    _front(ax, chart, theme)
    for name, role, cost in chart.rows:
        shade, advised = theme.roles[role], name == chart.advised
        ax.plot([cost.warm, cost.cold], [cost.wrong] * 2, color=shade, lw=1, alpha=0.6, zorder=2)
        ax.plot(cost.cold, cost.wrong, "o", ms=6, mfc=theme.paper, mec=shade, mew=1.3, zorder=3)
        ax.plot(cost.warm, cost.wrong, "o", ms=7, mfc=shade, mec=theme.paper, mew=0.8, zorder=4)
        if advised:
            ax.plot(cost.warm, cost.wrong, "o", ms=15, mfc="none", mec=ink, mew=1.6, zorder=5)
    _label(fig, ax, chart, theme)


def _front(ax: Axes, chart: CostChart, theme: Theme) -> None:
    """Draw the Pareto front of the warm times: the models than which no other is both faster and more often right."""
    points = sorted((cost.warm, cost.wrong) for _, _, cost in chart.rows)
    front: list[tuple[float, int]] = []
    for point in points:
        if not front or point[1] < front[-1][1]:
            front.append(point)
    xs, ys = zip(*front, strict=True)
    ax.step(xs, ys, where="post", color=theme.roles["guide"], lw=1, ls=(0, (1, 2.2)), zorder=1)


def _minor(low: float, high: float) -> Callable[[float, object], str]:
    """Return a formatter of tick labels between powers of ten, for a time axis from `low` to `high`."""
    few = high / low < 200

    def label(value: float, _: object) -> str:
        """Return the label of a tick at 2 or 5 times a power of ten if the axis is short, else "" (no label)."""
        return duration(value) if few and f"{value:e}"[0] in "25" else ""

    return label


def _label(fig: Figure, ax: Axes, chart: CostChart, theme: Theme) -> None:
    """Write each name above or below its points, in the nearest place where it covers no point and no other name."""
    renderer = fig.canvas.get_renderer()  # type: ignore[attr-defined]
    frame = ax.get_window_extent(renderer)
    dot = 6 * DPI / 72
    taken = []
    for _, _, cost in chart.rows:
        ends = [ax.transData.transform((x, cost.wrong)) for x in sorted((cost.cold, cost.warm))]
        taken += [Bbox.from_extents(px - dot, py - dot, px + dot, py + dot) for px, py in ends]
        taken.append(Bbox.from_extents(ends[0][0], ends[0][1] - 3, ends[1][0], ends[1][1] + 3))
    for name, role, cost in sorted(chart.rows, key=lambda row: row[2].warm):
        words = f"{name}, advised" if name == chart.advised else name
        shade = theme.text.get(role, theme.roles[role])
        px, py = ax.transData.transform((cost.warm, cost.wrong))
        text = ax.annotate(
            words,
            xy=(cost.warm, cost.wrong),
            xytext=(0, 0),
            textcoords="offset points",
            color=shade,
            fontsize=TEXT,
            fontweight="bold" if name == chart.advised else "normal",
            ha="left",
            va="bottom",
            parse_math=False,
            annotation_clip=False,
            zorder=7,
            bbox={"facecolor": theme.paper, "edgecolor": "none", "alpha": 0.85, "pad": 0.6},
        )
        size = text.get_window_extent(renderer)
        wide, high = size.width, size.height
        best = min(_places(wide, high, dot), key=lambda d: _cost(px + d[0], py + d[1], wide, high, taken, frame, d))
        x, y = px + best[0], py + best[1]
        text.set_position((best[0] * 72 / DPI, best[1] * 72 / DPI))
        end = min(max(px, x), x + wide), y if best[1] > 0 else y + high
        tie = ax.transData.inverted().transform([(px, py), end])
        ax.plot(*tie.T, color=shade, lw=0.6, alpha=0.7, zorder=1.5, clip_on=False)
        taken.append(Bbox.from_bounds(x - 8, y - 2, wide + 16, high + 4))


def _places(wide: float, high: float, dot: float) -> Sequence[tuple[float, float]]:
    """Return the offsets (dx, dy) to try for a name of this size, from its point; `dot` is the radius of points."""
    ups = [dot * 1.6 + k * high * 1.25 for k in range(12)]
    return [
        (dx, dy)
        for up in ups
        for dy in (up, -up - high)
        for dx in (-dot, -wide / 2, -wide + dot, 3 * dot, -wide - 3 * dot)
    ]


def _cost(
    x: float, y: float, wide: float, high: float, taken: Sequence[Bbox], frame: Bbox, away: tuple[float, float]
) -> float:
    """Return how bad a place of a name is: overlaps with `taken`, parts outside the frame, distance `away`."""
    mine = Bbox.from_bounds(x, y, wide, high)
    out: float = max(0, frame.x0 - mine.x0) + max(0, mine.x1 - frame.x1 - 20) + max(0, frame.y0 - mine.y0)
    out += max(0, mine.y1 - frame.y1)
    over: float = sum(
        max(0, min(mine.x1, b.x1) - max(mine.x0, b.x0)) * max(0, min(mine.y1, b.y1) - max(mine.y0, b.y0)) for b in taken
    )
    cost: float = over * 10 + out * 100 + abs(away[1] + high / 2) + abs(away[0] + wide / 2) / 4
    return cost
