"""Charts: a drawing with its numbers, and a reading in words that is made from the numbers."""

import csv
import io
import json
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path
from textwrap import wrap
from typing import Any, NamedTuple, cast

from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from ..pictures import LIGHT, THEMES, Theme
from ..pictures.float_geometry import clip_segment
from ..safe_write import MADE_BY, write
from .files import encode_figure, svg_without_header
from .formats import DPI

JsonRow = dict[str, Any]  # one row of numbers: plain JSON values by the name of their column
WIDTH = 390.0  # width of a chart in points, that of a phone in CSS pixels: there a point is shown as one pixel
TEXT_POINTS, TITLE_POINTS = 11.0, 13.5
TITLE_LETTER, TEXT_LETTER = 8.6, 6.0  # points that a letter takes, by which lines are wrapped
TITLE_LINE, TEXT_LINE = 17.0, 14.5  # points from line to line
RIM_GAP = 3.0  # points between a label and the lines of the axes


class Chart(NamedTuple):
    """One chart: a title, smaller `lines` below it, and the drawing that `draw` makes below these on a Figure.

    `stem`: the name of its files without the ending.  `height`: the height of that drawing in points.  `rows`: the
    numbers that are drawn, written beside the chart as JSON and CSV.  `reading`: the content in words, made from the
    rows; it is also the alternative text.  `warning`: why its times are only rough, printed on the chart; "" if they
    are not.
    """

    stem: str
    title: str
    lines: Sequence[str]
    height: float
    draw: Callable[[Figure, Theme], None]
    rows: Sequence[JsonRow]
    reading: str
    warning: str = ""

    @property
    def headline(self) -> list[tuple[str, bool]]:
        """Return the lines of the title (True) and of the text below it (False), wrapped to the chart's width."""
        found = [(text, True) for text in wrap(self.title, int(WIDTH / TITLE_LETTER))]
        return found + [(text, False) for line in self.lines for text in wrap(line, int(WIDTH / TEXT_LETTER))]

    @property
    def size(self) -> tuple[float, float]:
        """Return the width and the height of the whole chart in points."""
        return WIDTH, 12.0 + sum(TITLE_LINE if is_title else TEXT_LINE for _, is_title in self.headline) + self.height

    def figure(self, theme: Theme) -> Figure:
        """Return the chart on a new Figure."""
        width, height = self.size
        fig = Figure(figsize=(width / 72, height / 72), dpi=DPI)
        FigureCanvasAgg(fig)
        fig.set_facecolor(theme.paper)
        up = height - 8.0
        for text, is_title in self.headline:
            style: dict[str, Any] = {"color": theme.roles["guide"]}
            if is_title:
                style = {"color": theme.roles["ink"], "fontsize": TITLE_POINTS, "fontweight": "bold"}
            add_text(fig, 6, up, text, va="top", **style)
            up -= TITLE_LINE if is_title else TEXT_LINE
        self.draw(fig, theme)
        if self.warning:
            shade = theme.text.get("wrong", theme.roles["wrong"])
            add_text(fig, width - 6, 3, self.warning, color=shade, ha="right", va="bottom")
        return fig

    def __repr__(self) -> str:
        return self.reading

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, str]:
        """Return the chart and its reading, for a notebook."""
        return {"text/plain": self.reading, "image/svg+xml": svg_without_header(self.encode("svg"))}

    def encode(self, form: str, theme: Theme = LIGHT) -> bytes:
        """Return the bytes of the chart's file in a theme; `form`: "svg" or "png"."""
        stem = f"{self.stem}{theme_suffix(theme)}"
        return encode_figure(lambda: self.figure(theme), form, stem=stem, title=self.title, sentence=self.reading)


def theme_suffix(theme: Theme) -> str:
    """Return the ending of a theme's file names before the dot: "" for the light theme, or "-dark"."""
    return "" if theme.name == "light" else f"-{theme.name}"


def save_chart(
    chart: Chart, folder: Path, facts: dict[str, Any], forms: Sequence[str], *, force: bool = False
) -> Iterator[Path]:
    """Write the chart in each form and theme, and its numbers as JSON (with `facts`) and CSV; yield the paths."""
    for theme in THEMES.values():
        for form in forms:
            path = folder / f"{chart.stem}{theme_suffix(theme)}.{form}"
            write(path, chart.encode(form, theme), force=force)
            yield path
    data = {
        "made_by": MADE_BY,
        "title": chart.title,
        "reading": chart.reading,
        "rough": chart.warning,
        **facts,
        "rows": list(chart.rows),
    }
    write(folder / f"{chart.stem}.json", (json.dumps(data, indent=1, allow_nan=False) + "\n").encode(), force=force)
    yield folder / f"{chart.stem}.json"
    text = io.StringIO()
    rows = [{**row, "made_by": MADE_BY} for row in chart.rows]  # a CSV file has no other place for its maker
    names = dict.fromkeys(name for row in chart.rows for name in row)
    table = csv.DictWriter(text, [*names, "made_by"], lineterminator="\n")
    table.writeheader()
    table.writerows(rows)
    write(folder / f"{chart.stem}.csv", text.getvalue().encode(), force=force)
    yield folder / f"{chart.stem}.csv"


def share_of(fig: Figure, x: float, y: float) -> tuple[float, float]:
    """Return (x, y), a place in points from the lower left corner, as fractions of the figure's width and height."""
    width, height = fig.get_size_inches() * 72
    return x / width, y / height


def add_text(fig: Figure, x: float, y: float, words: str, **style: Any) -> None:
    """Write words at (x, y), in points from the figure's lower left corner; `style`: options of `Figure.text`."""
    fig.text(*share_of(fig, x, y), words, **{"fontsize": TEXT_POINTS, "parse_math": False, **style})


def add_axes(fig: Figure, box: tuple[float, float, float, float], theme: Theme, title: str = "") -> Axes:
    """Add axes in the project's style at `box`: (left, bottom, width, height) in points."""
    ax = fig.add_axes((*share_of(fig, *box[:2]), *share_of(fig, *box[2:])))
    ink, guide = theme.roles["ink"], theme.roles["guide"]
    ax.set_facecolor(theme.paper)
    ax.spines[["top", "right"]].set_visible(False)
    ax.spines[["left", "bottom"]].set_color(guide)
    ax.tick_params(which="both", color=guide, labelcolor=ink, labelsize=TEXT_POINTS, length=3)
    ax.tick_params(which="minor", length=0)
    for axis in (ax.xaxis, ax.yaxis):
        axis.label.set(color=ink, fontsize=TEXT_POINTS)
    if title:
        ax.set_title(title, loc="left", color=ink, fontsize=TEXT_POINTS + 1, fontweight="bold", parse_math=False)
    return ax


PointsBox = tuple[float, float, float, float]  # x0, y0, x1, y1 in points


def label_points(
    ax: Axes, points: Sequence[tuple[float, float, str, str]], theme: Theme, taken: Sequence[tuple[float, float]] = ()
) -> None:
    """Write a label for each (x, y, text, colour) near its point (in data units), clear of other labels and points.

    `taken`: more points (x, y), in data units, that no label should cover.
    """
    scale = 72 / ax.figure.dpi
    left, bottom, right, top = (float(edge) * scale for edge in ax.get_window_extent().extents)
    rim = left + RIM_GAP, bottom + RIM_GAP, right, top
    pixels = [ax.transData.transform((p[0], p[1])) for p in (*points, *taken)]
    spots = [(float(x) * scale, float(y) * scale) for x, y in pixels]
    dots: list[PointsBox] = [(x - 9, y - 4, x + 9, y + 4) for x, y in spots]
    renderer = cast(Any, ax.figure.canvas).get_renderer()
    notes = []
    for x, y, text, shade in points:
        note = ax.annotate(
            text,
            xy=(x, y),
            xytext=(0, 0),
            textcoords="offset points",
            color=shade,
            fontsize=TEXT_POINTS,
            ha="left",
            va="bottom",
            parse_math=False,
            annotation_clip=False,
            bbox={"facecolor": theme.paper, "edgecolor": "none", "alpha": 0.8, "pad": 0.6},
            arrowprops={"arrowstyle": "-", "color": shade, "lw": 0.6, "alpha": 0.6, "shrinkA": 0, "shrinkB": 3},
        )
        size = note.get_window_extent(renderer)
        notes.append((note, size.width * scale, size.height * scale))
    sizes = [(w, h) for _, w, h in notes]

    def place(order: Iterable[int]) -> tuple[float, dict[int, PointsBox]]:
        """Place the labels with these indices in this order, each at its best offset; return (sum of costs, boxes)."""
        total, placed = 0.0, dict[int, PointsBox]()
        for k in order:
            x, y = spots[k]
            lines = [(*_middle_of(box), *spots[i]) for i, box in placed.items()]
            others = [*placed.values(), *dots[:k], *dots[k + 1 :]]
            boxes = [
                (x + dx, y + dy, x + dx + sizes[k][0], y + dy + sizes[k][1]) for dx, dy in _label_offsets(*sizes[k])
            ]
            costs = [_label_cost(box, spots[k], others, lines, dots[k], rim) for box in boxes]
            total += min(costs)
            x0, y0, x1, y1 = boxes[costs.index(min(costs))]
            placed[k] = x0 - 4, y0, x1 + 4, y1
        return total, placed

    by_height = sorted(range(len(points)), key=lambda k: (-spots[k][1], spots[k][0]))
    by_place = sorted(range(len(points)), key=lambda k: spots[k])
    orders = by_height, by_height[::-1], by_place, by_place[::-1]  # one that comes first may stand in another's way
    _, placed = min(map(place, orders), key=lambda found: found[0])
    for k, (x0, y0, _, _) in placed.items():
        notes[k][0].set_position((x0 + 4 - spots[k][0], y0 - spots[k][1]))


def _label_cost(
    box: PointsBox,
    spot: tuple[float, float],
    others: Sequence[PointsBox],
    lines: Sequence[PointsBox],
    dot: PointsBox,
    rim: PointsBox,
) -> float:
    """Return the cost of a place for a label, without unit: for covered area, crossings, overhang and distance.

    `box`: the label's; `spot`: its point, with the box `dot` around it; `others`: the boxes of other labels and dots;
    `lines`: (x0, y0, x1, y1) from other labels to their dots; `rim`: the box of the axes.  All are in points.
    """
    middle = _middle_of(box)
    covered = sum(_shared_area(box, other) for other in (*others, dot))
    crossed = sum(clip_segment(*middle, *spot, *other) is not None for other in others)
    crossed += sum(clip_segment(*line, *box) is not None for line in lines)
    out = sum(max(0.0, rim[i] - box[i]) + max(0.0, box[i + 2] - rim[i + 2]) for i in (0, 1))
    return covered * 10 + crossed * 100 + out * 50 + abs(middle[0] - spot[0]) / 2 + abs(middle[1] - spot[1])


def _middle_of(box: PointsBox) -> tuple[float, float]:
    """Return the middle of a box."""
    return (box[0] + box[2]) / 2, (box[1] + box[3]) / 2


def _label_offsets(w: float, h: float) -> Iterator[tuple[float, float]]:
    """Yield offsets from a point to the lower left corner of its label (w x h points), near ones first."""
    for step in range(12):
        for side in (1, -1):
            up = side * (4 + step * h * 0.75)
            y = up if side > 0 else up - h
            yield from ((x, y) for x in (5, -w / 2, -w - 5, 24, -w - 24, 42, -w - 42, 60, -w - 60))
    yield from ((5, -h / 2), (-w - 5, -h / 2))


def _shared_area(one: Sequence[float], other: Sequence[float]) -> float:
    """Return the area that two boxes (x0, y0, x1, y1) share, in square points."""
    wide, high = (min(one[k + 2], other[k + 2]) - max(one[k], other[k]) for k in (0, 1))
    return max(0.0, wide) * max(0.0, high)
