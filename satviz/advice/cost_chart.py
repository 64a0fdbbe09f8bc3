"""The chart of a recommendation: the time of each model on these pairs against its number of wrong answers."""

from collections.abc import Callable, Mapping, Sequence
from functools import partial

from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, NullFormatter

from ..pictures import Theme
from ..render.chart import TEXT_POINTS, WIDTH, Chart, JsonRow, add_axes, label_points
from .candidates import AABB, BOUNDING_CIRCLES, EXACT_FILTER, K_DOP, Model
from .costs import Cost
from .records import InputSummary, ModelResult
from .report import duration

HEIGHT = 320.0  # points of the axes and what is written around them
ROLES = {EXACT_FILTER: "exact", BOUNDING_CIRCLES: "shortcut", AABB: "shortcut", K_DOP: "shortcut"}  # the others: float


def chart(
    model: Model, summary: InputSummary, results: Sequence[ModelResult], found: Mapping[str, Cost | None]
) -> Chart:
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
    rows = [{"model": m.name, "role": ROLES.get(m.kind, "float"), **cost._asdict()} for m, cost in timed]
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
    words = f"Right and enough here: {model.name}", f"filled: warm, hollow: with set-up; {what}, times of {of} at once"
    return cost_chart(words, rows, model.name, sentence)


def cost_chart(words: tuple[str, str], rows: Sequence[JsonRow], advised: str, sentence: str) -> Chart:
    """Return the chart of these rows, one a model, with its `sentence`.

    `words`: the title and the line below it; `advised`: the name of the model to mark.
    """
    return Chart("advice", words[0], words[1:], HEIGHT, partial(_draw, rows=rows, advised=advised), rows, sentence)


def _draw(fig: Figure, theme: Theme, rows: Sequence[JsonRow], advised: str) -> None:
    """Draw the axes, the time and wrong answers of each model, and the names on a figure."""
    ax = add_axes(fig, (55, 48, WIDTH - 86, HEIGHT - 75), theme, "wrong answers")
    times = [t for row in rows for t in (row["cold"], row["warm"])]
    low, high = min(times) / 1.6, max(times) * 1.6
    ax.set(xscale="log", xlim=(low, high), xlabel="time a pair")
    ax.set_yscale("symlog", linthresh=1, linscale=0.6)
    ax.set_ylim(-0.55, max(row["wrong"] for row in rows) * 3 or 3)
    ax.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:,.0f}"))
    ax.yaxis.set_minor_formatter(NullFormatter())
    ax.xaxis.set_major_formatter(FuncFormatter(lambda value, _: duration(value)))
    ax.xaxis.set_minor_formatter(FuncFormatter(_minor(low, high)))
    ax.tick_params(axis="x", which="minor", labelsize=TEXT_POINTS, length=3)
    # the Pareto front of the warm times: no other model is both faster and more often right
    front: list[tuple[float, int]] = []
    for point in sorted((row["warm"], row["wrong"]) for row in rows):
        if not front or point[1] < front[-1][1]:
            front.append(point)
    ax.step(*zip(*front, strict=True), where="post", color=theme.roles["guide"], lw=1, ls=(0, (1, 2.2)), zorder=1)
    for row in rows:
        shade, wrong = theme.roles[row["role"]], row["wrong"]
        ax.plot([row["warm"], row["cold"]], [wrong] * 2, color=shade, lw=1, alpha=0.6, zorder=2)
        ax.plot(row["cold"], wrong, "o", ms=6, mfc=theme.paper, mec=shade, mew=1.3, zorder=3)
        ax.plot(row["warm"], wrong, "o", ms=7, mfc=shade, mec=theme.paper, mew=0.8, zorder=4)
        if row["model"] == advised:
            ax.plot(row["warm"], wrong, "o", ms=10, mfc="none", mec=theme.roles["ink"], mew=1.4, zorder=5)
    names = [f"{row['model']}{', advised' * (row['model'] == advised)}" for row in rows]
    shades = [theme.text.get(row["role"], theme.roles[row["role"]]) for row in rows]
    points = [(row["warm"], row["wrong"], name, shade) for row, name, shade in zip(rows, names, shades, strict=True)]
    label_points(ax, points, theme, [(row["cold"], row["wrong"]) for row in rows])


def _minor(low: float, high: float) -> Callable[[float, object], str]:
    """Return a formatter of tick labels between powers of ten, for a time axis from `low` to `high`."""
    few = high / low < 200

    def label(value: float, _: object) -> str:
        """Return the label of a tick at 2 or 5 times a power of ten if the axis is short, else "" (no label)."""
        return duration(value) if few and f"{value:e}"[0] in "25" else ""

    return label
