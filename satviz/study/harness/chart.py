"""What the study's charts have in common: colours of methods, axes of times, labels of curves, intervals."""

from collections.abc import Iterable, Mapping, Sequence
from statistics import median

from matplotlib.axes import Axes
from matplotlib.axis import XAxis, YAxis

from ...pictures import Theme
from ...render.chart import TEXT_POINTS, JsonRow

LABEL_GAP, LABEL_SPACE = 15.0, 8.0  # points between labels, and between the axes and the labels beside them
# the colour role of each family of methods; every mark has its name beside it as well
FAMILY_ROLES = {
    "exact": "exact",
    "float SAT": "float",
    "tolerance": "tolerance",
    "bounds": "shortcut",
    "GJK": "ink",
    "library": "guide",
}


def set_time_ticks(axis: XAxis | YAxis, limits: Sequence[float], *, step: int = 1) -> None:
    """Set ticks in ns, µs, ms or s at the powers of ten within the limits, in ns; every `step`-th has a text."""
    decades = [10.0**e for e in range(-1, 11) if limits[0] <= 10.0**e <= limits[1]]
    axis.set_ticks(
        decades, labels=["" if k % step else format_time(d).replace(".0", "") for k, d in enumerate(decades)]
    )
    axis.minorticks_off()


def format_time(ns: float) -> str:
    """Return a time in ns, µs, ms or s with two or three digits."""
    size, unit = next(((s, u) for s, u in ((1e9, "s"), (1e6, "ms"), (1e3, "µs")) if ns >= s), (1.0, "ns"))
    return f"{ns / size:.{0 if ns >= 10 * size else 1}f} {unit}"


def family_colour(theme: Theme, family: str, *, text: bool = False) -> str:
    """Return the colour of a family of methods; with `text` the darker shade that letters need."""
    role = FAMILY_ROLES[family]
    return theme.text.get(role, theme.roles[role]) if text else theme.roles[role]


def draw_time_curves(
    ax: Axes,
    theme: Theme,
    xs: Sequence[float],
    rows: Sequence[JsonRow],
    styles: Mapping[tuple[str, str], tuple[str, str, str]],
) -> None:
    """Draw curves of times over xs, with bars for the spread of the processes, and write the label of each at its end.

    A curve has one row for each x.  `styles`: (label, family, line style) by (method, column of the rows); methods
    without rows are left out.
    """
    ends = []
    ax.set_yscale("log")
    for (name, column), (label, family, style) in styles.items():
        own = [row for row in rows if row["method"] == name]
        if not own:
            continue
        shade = family_colour(theme, family)
        ax.plot(xs, [row[column] for row in own], color=shade, ls=style, lw=1.8, marker="o", ms=4)
        low, high = ([row[f"{column}_{end}"] for row in own] for end in ("low", "high"))
        ax.vlines(xs, low, high, shade, lw=1)
        ends.append((xs[-1], own[-1][column], label, family_colour(theme, family, text=True)))
    set_time_ticks(ax.yaxis, ax.get_ylim())
    label_ends(ax, ends)


def label_ends(ax: Axes, ends: Sequence[tuple[float, float, str, str]]) -> None:
    """Write the text of each (x, y, text, colour) right of the axes, clear of the others, with a line to its point."""
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
            short = LABEL_GAP - (heights[i] - heights[i + 1])
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
            xytext=(box.x1 * scale + LABEL_SPACE, height),
            textcoords="figure points",
            color=shade,
            fontsize=TEXT_POINTS,
            va="center",
            parse_math=False,
            annotation_clip=False,
            arrowprops={
                "arrowstyle": "-",
                "color": shade,
                "lw": 0.6,
                "alpha": 0.6,
                "relpos": (0.0, 0.5),
                "shrinkA": 1,
                "shrinkB": 2,
            },
        )


def median_interval(values: Iterable[float]) -> tuple[float, float, float]:
    """Return (median, low, high) of a sample of 8 or more; low and high: 95 % interval of the population's median.

    Of n values about n / 2 are below the median, give or take 0.98 n ** 0.5 (the binomial distribution).
    """
    found = sorted(values)
    first = int(len(found) / 2 - 0.98 * len(found) ** 0.5) - 1
    return median(found), found[first], found[-1 - first]


def wilson_interval(wrong: int, total: int) -> tuple[float, float]:
    """Return the 95 % confidence interval (low, high) of an error rate (Wilson 1927), also for 0 wrong."""
    if not total:
        return 0.0, 1.0
    z = 1.959964
    p, zz = wrong / total, z * z / total
    center, half = p + zz / 2, z * (p * (1 - p) / total + zz / (4 * total)) ** 0.5
    low, high = (center - half) / (1 + zz), (center + half) / (1 + zz)
    return low if wrong else 0.0, high if wrong < total else 1.0
