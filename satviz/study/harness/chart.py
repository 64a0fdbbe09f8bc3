"""A chart of the study: what draws it, the numbers beside it, and a reading made from the numbers."""

import csv
import io
import json
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any, NamedTuple, cast

from matplotlib.axes import Axes
from matplotlib.axis import XAxis, YAxis
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from ...pictures import LIGHT, THEMES, Theme
from ...render.files import bare, encode_figure
from ...render.formats import DPI
from ...safe_write import MADE_BY, write

TEXT, TITLE = 10.0, 13.0  # points, at final size
# who a method is, by colour; every mark is named beside it as well
FAMILIES = {
    "exact": "exact",
    "exact in range": "exact",
    "float SAT": "float",
    "tolerance": "tolerance",
    "bounds": "shortcut",
    "GJK": "ink",
    "library": "guide",
}

Cell = Callable[[int, int], tuple[str, str, float]]


class Chart(NamedTuple):
    """One chart: `draw` puts it on an empty Figure of `size` (points) in a theme.

    `rows`: the numbers drawn, flat and of plain values, written beside it as JSON and
    CSV; `reading`: what it shows in words, made from the rows, and its alt text.
    `rough`: why its times are not for keeps, stamped on it.
    """

    stem: str
    title: str
    size: tuple[float, float]
    draw: Callable[[Figure, Theme], None]
    rows: Sequence[dict[str, Any]]
    reading: str
    rough: str = ""

    def figure(self, theme: Theme) -> Figure:
        """The chart on a Figure of its own."""
        fig = Figure(figsize=(self.size[0] / 72, self.size[1] / 72), dpi=DPI)
        FigureCanvasAgg(fig)
        fig.set_facecolor(theme.paper)
        self.draw(fig, theme)
        if self.rough:
            at: dict[str, Any] = {"ha": "right", "va": "bottom", "fontsize": TEXT, "parse_math": False}
            fig.text(
                1 - 6 / self.size[0],
                3 / self.size[1],
                self.rough,
                color=theme.text.get("wrong", theme.roles["wrong"]),
                **at,
            )
        return fig

    def __repr__(self) -> str:
        return self.reading

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, str]:
        """In a notebook: the chart, and its reading."""
        return {"text/plain": self.reading, "image/svg+xml": bare(self.encode("svg", LIGHT))}

    def encode(self, form: str, theme: Theme) -> bytes:
        """The chart's file: form "svg" or "png"."""
        stem = f"{self.stem}{suffix(theme)}"
        return encode_figure(lambda: self.figure(theme), form, stem=stem, title=self.title, sentence=self.reading)


def suffix(theme: Theme) -> str:
    """What the files of a theme end in."""
    return "" if theme.name == "light" else f"-{theme.name}"


def save(
    chart: Chart, folder: Path, facts: dict[str, Any], forms: Sequence[str], *, force: bool = False
) -> Iterator[Path]:
    """Write the chart in those forms, light and dark, and its numbers as JSON (with `facts`) and CSV."""
    for theme in THEMES.values():
        for form in forms:
            path = folder / f"{chart.stem}{suffix(theme)}.{form}"
            write(path, chart.encode(form, theme), force=force)
            yield path
    data = {
        "made_by": MADE_BY,
        "title": chart.title,
        "reading": chart.reading,
        "rough": chart.rough,
        **facts,
        "rows": list(chart.rows),
    }
    write(folder / f"{chart.stem}.json", (json.dumps(data, indent=1, allow_nan=False) + "\n").encode(), force=force)
    yield folder / f"{chart.stem}.json"
    text = io.StringIO()
    rows = [{**row, "made_by": MADE_BY} for row in chart.rows]  # a table has no other place for its maker
    names = dict.fromkeys(name for row in chart.rows for name in row)
    table = csv.DictWriter(text, [*names, "made_by"], lineterminator="\n")
    table.writeheader()
    table.writerows(rows)
    write(folder / f"{chart.stem}.csv", text.getvalue().encode(), force=force)
    yield folder / f"{chart.stem}.csv"


def axes(fig: Figure, box: tuple[float, float, float, float], theme: Theme, title: str = "") -> Axes:
    """Quiet axes in the project's look, at (left, bottom, width, height) in parts of the figure."""
    ax = fig.add_axes(box)
    ink, guide = theme.roles["ink"], theme.roles["guide"]
    ax.set_facecolor(theme.paper)
    ax.spines[["top", "right"]].set_visible(False)
    ax.spines[["left", "bottom"]].set_color(guide)
    ax.tick_params(which="both", color=guide, labelcolor=ink, labelsize=TEXT, length=3)
    ax.tick_params(which="minor", length=0)
    for axis in (ax.xaxis, ax.yaxis):
        axis.label.set(color=ink, fontsize=TEXT)
    if title:
        ax.set_title(title, loc="left", color=ink, fontsize=TEXT + 1, fontweight="bold", parse_math=False)
    return ax


def headline(fig: Figure, theme: Theme, text: str, *under: str) -> None:
    """The chart's title at its upper left, and quiet lines under it."""
    height = fig.get_size_inches()[1] * 72
    at: dict[str, Any] = {"ha": "left", "va": "top", "parse_math": False}
    fig.text(0.012, 1 - 8 / height, text, color=theme.roles["ink"], fontsize=TITLE, fontweight="bold", **at)
    for i, line in enumerate(under):
        fig.text(0.012, 1 - (27 + 15 * i) / height, line, color=theme.roles["guide"], fontsize=TEXT, **at)


def time_ticks(axis: XAxis | YAxis, limits: Sequence[float], *, words: bool = True) -> None:
    """Powers of ten of nanoseconds within the limits, told in their units."""
    decades = [10.0**e for e in range(-1, 9) if limits[0] <= 10.0**e <= limits[1]]
    axis.set_ticks(decades, labels=[told(d).replace(".0", "") if words else "" for d in decades])
    axis.minorticks_off()


def told(ns: float) -> str:
    """A time to two digits or three."""
    size, unit = next(((s, u) for s, u in ((1e6, "ms"), (1e3, "µs")) if ns >= s), (1.0, "ns"))
    return f"{ns / size:.{0 if ns >= 10 * size else 1}f} {unit}"


def table(
    ax: Axes,
    theme: Theme,
    columns: Sequence[str],
    rows: Sequence[str],
    cell: Callable[[int, int], tuple[str, str, float]],
) -> None:
    """Words in places with a colour and how much of it: `cell(row, column)`, where 0 says that nothing is there."""
    ax.set(xlim=(-0.5, len(columns) - 0.5), ylim=(len(rows) - 0.5, -0.5))
    ax.spines[["left", "bottom"]].set_visible(False)
    ax.tick_params(length=0)
    ax.xaxis.tick_top()
    ax.set_xticks(range(len(columns)), columns)
    ax.set_yticks(range(len(rows)), rows)
    for y in range(len(rows)):
        for x in range(len(columns)):
            words, shade, much = cell(y, x)
            if much:
                ax.add_patch(Rectangle((x - 0.48, y - 0.45), 0.96, 0.9, color=shade, alpha=0.1 + 0.5 * much, lw=0))
            ink = theme.roles["ink" if much else "guide"]
            ax.text(x, y, words, ha="center", va="center_baseline", fontsize=TEXT, color=ink)


def colour(theme: Theme, family: str, *, text: bool = False) -> str:
    """A family's colour; for letters the darker one."""
    role = FAMILIES[family]
    return theme.text.get(role, theme.roles[role]) if text else theme.roles[role]


def label_ends(
    ax: Axes, ends: Sequence[tuple[float, float, str, str]], *, gap: float = 13.0, room: float = 12.0
) -> None:
    """Write (x, y, text, colour) to the right of the axes, pushed apart to `gap` points, each tied to its point.

    `room`: points between the axes' right side and the letters.
    """
    if not ends:
        return
    scale = 72 / ax.figure.dpi
    box = ax.get_window_extent()
    spots = sorted(((ax.transData.transform((x, y))[1] * scale, x, y, t, c) for x, y, t, c in ends), reverse=True)
    heights = [spot[0] for spot in spots]
    low, high = box.y0 * scale, box.y1 * scale
    for _ in range(200):  # push neighbours apart until none is too close
        moved = False
        for i in range(len(heights) - 1):
            short = gap - (heights[i] - heights[i + 1])
            if short > 0.01:
                heights[i] += short / 2
                heights[i + 1] -= short / 2
                moved = True
        heights[0] = min(heights[0], high)
        heights[-1] = max(heights[-1], low - 4)
        if not moved:
            break
    for height, (_, x, y, text, shade) in zip(heights, spots, strict=True):
        ax.annotate(
            text,
            xy=(x, y),
            xytext=(box.x1 * scale + room, height),
            textcoords="figure points",
            color=shade,
            fontsize=TEXT,
            va="center",
            parse_math=False,
            annotation_clip=False,
            arrowprops={"arrowstyle": "-", "color": shade, "lw": 0.6, "alpha": 0.6, "shrinkA": 1, "shrinkB": 2},
        )


def label_points(
    ax: Axes, points: Sequence[tuple[float, float, str, str]], theme: Theme, taken: Sequence[tuple[float, float]] = ()
) -> None:
    """Write each (x, y, text, colour) beside its point, where it covers no other label, point or the axes' rim.

    `taken`: more (x, y) points to keep clear of.
    """
    scale = 72 / ax.figure.dpi
    box = ax.get_window_extent()
    rim = box.x0 * scale, box.y0 * scale, box.x1 * scale, box.y1 * scale
    spots = [tuple(ax.transData.transform((p[0], p[1])) * scale) for p in (*points, *taken)]
    placed: list[tuple[float, float, float, float]] = [(x - 4, y - 4, x + 4, y + 4) for x, y in spots]
    renderer = cast(Any, ax.figure.canvas).get_renderer()
    for (x, y), (px, py, text, shade) in sorted(zip(spots, points), key=lambda item: (-item[0][1], item[0][0])):
        note = ax.annotate(
            text,
            xy=(px, py),
            xytext=(0, 0),
            textcoords="offset points",
            color=shade,
            fontsize=TEXT,
            ha="left",
            va="bottom",
            parse_math=False,
            annotation_clip=False,
            bbox={"facecolor": theme.paper, "edgecolor": "none", "alpha": 0.8, "pad": 0.6},
            arrowprops={"arrowstyle": "-", "color": shade, "lw": 0.6, "alpha": 0.6, "shrinkA": 0, "shrinkB": 3},
        )
        size = note.get_window_extent(renderer)
        w, h = size.width * scale, size.height * scale

        def cost(offset: tuple[float, float], at: tuple[float, float] = (x, y), w: float = w, h: float = h) -> float:
            mine = at[0] + offset[0], at[1] + offset[1], at[0] + offset[0] + w, at[1] + offset[1] + h
            over = sum(_common(mine, other) for other in placed)
            out = (
                max(0, rim[0] - mine[0])
                + max(0, mine[2] - rim[2])
                + max(0, rim[1] - mine[1])
                + max(0, mine[3] - rim[3])
            )
            away = abs(offset[0] + w / 2) / 2 + abs(offset[1] + h / 2)
            return float(over * 10 + out * 50 + away)

        best = min(_offsets(w, h), key=cost)
        note.set_position(best)
        placed.append((x + best[0] - 4, y + best[1], x + best[0] + w + 4, y + best[1] + h))


def _offsets(w: float, h: float) -> Iterator[tuple[float, float]]:
    """Places for a label's lower left corner, seen from its point: beside it, then further up and down."""
    for step in range(12):
        for side in (1, -1):
            up = side * (4 + step * h * 0.75)
            y = up if side > 0 else up - h
            yield from ((x, y) for x in (5, -w / 2, -w - 5, 24, -w - 24, 60, -w - 60))
    yield from ((5, -h / 2), (-w - 5, -h / 2))


def _common(one: Sequence[float], other: Sequence[float]) -> float:
    """How much area two boxes (x0, y0, x1, y1) share, in square points."""
    wide, high = (min(one[k + 2], other[k + 2]) - max(one[k], other[k]) for k in (0, 1))
    return max(0.0, wide) * max(0.0, high)


def wilson(wrong: int, of: int) -> tuple[float, float]:
    """The 95 % interval of a rate (Wilson 1927), which has a meaning for 0 of n too."""
    if not of:
        return 0.0, 1.0
    z = 1.959964
    p, zz = wrong / of, z * z / of
    center, half = p + zz / 2, z * (p * (1 - p) / of + zz / (4 * of)) ** 0.5
    low, high = (center - half) / (1 + zz), (center + half) / (1 + zz)
    return low if wrong else 0.0, high if wrong < of else 1.0
