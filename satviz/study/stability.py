"""Stability: how often each method is wrong as the pairs grow harder, one panel for each way of being hard."""

from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..pictures import Theme
from .cells import Cell, Settings
from .chart import TEXT, Chart, axes, colour, headline, label_points
from .hard import WAYS, Way
from .methods import judged, methods, times_wrong

# (form, name): a mark of its own, and what it is called here
SHOWN = {
    ("batch", "SAT, raw normals"): ("o", "SAT, raw normals"),
    ("batch", "SAT, unit normals"): ("s", "SAT, unit normals"),
    ("batch", "SAT, float32"): ("^", "SAT, float32"),
    ("batch", "SAT, eps 1e-9 to hit"): ("<", "eps 1e-9 to hit"),
    ("batch", "SAT, eps 1e-9 to miss"): (">", "eps 1e-9 to miss"),
    ("scalar", "GJK"): ("D", "GJK"),
    ("batch", "shapely"): ("P", "shapely"),
    ("scalar", "satviz.relate"): ("*", "satviz.relate"),
    ("batch", "satviz numpy"): ("X", "satviz numpy"),
    ("batch", "satviz numba"): ("d", "satviz numba"),
}
RAISED = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")
Rows = list[dict[str, Any]]


def cells(settings: Settings) -> list[Cell]:
    """A cell for each level of each way of being hard."""
    n = 200 if settings.quick else 2000
    return [
        Cell(f"stability-{way.name.replace(' ', '-')}-{level}", count_wrong, (i, level, n, settings))
        for i, way in enumerate(WAYS)
        for level in way.levels
    ]


def count_wrong(way: int, level: int, n: int, settings: Settings) -> list[dict]:
    """False hits and misses of each method on one level's pairs, against rationals."""
    kind = WAYS[way]
    a, b = kind.make(settings.rng("stability", kind.name, level), n, level)
    shown = [method for method in methods(circles=False) if (method.form, method.name) in SHOWN]
    hits, rows = judged(shown, a, b)
    return [{"way": kind.name, "level": level, **row, "checked": len(a), "hits": hits} for row in rows]


def charts(results: dict[str, Any]) -> list[Chart]:
    """A panel for each way of being hard there are results of, in one chart."""
    names = {(way, level): f"stability-{way.name.replace(' ', '-')}-{level}" for way in WAYS for level in way.levels}
    rows: Rows = [row for name in names.values() if name in results for row in results[name]]
    ways = [way for way in WAYS if any(row["way"] == way.name for row in rows)]
    title = "Stability: wrong answers as the scenes grow harder"
    columns, wide, high, top = 1 if len(ways) < 4 else 2, 600.0, 275.0, 44.0  # a few: as wide as a page's text
    lines = -(-(len(ways) + 1) // columns)  # the last place is for the totals
    size = columns * wide, top + lines * high

    def draw(fig: Figure, theme: Theme) -> None:
        headline(fig, theme, title, "each level: pairs of polygons made alike, checked against rationals")
        for i, way in enumerate(ways):
            x, y = (i % columns) * wide + 62, size[1] - top - (i // columns + 1) * high + 58
            box = x / size[0], y / size[1], (wide - 80) / size[0], (high - 92) / size[1]
            _panel(axes(fig, box, theme), way, [row for row in rows if row["way"] == way.name], theme)
        x, y = len(ways) % columns * wide + 62, high - 20
        _totals(fig, rows, x / size[0], y / size[1], theme)

    return [Chart("stability", title, size, draw, rows, _reading(rows, ways))]


def _panel(ax: Axes, way: Way, rows: Rows, theme: Theme) -> None:
    of = max(row["checked"] for row in rows)
    none = 0.4 / of
    places = {level: i for i, level in enumerate(way.levels)}
    labels, taken, never = [], [], []
    for key, (mark, name) in SHOWN.items():
        mine = [row for row in rows if (row["form"], row["method"]) == key]
        if not mine:
            continue
        rates = [times_wrong(row) / row["checked"] for row in mine]
        if not any(rates):
            never.append(name)
            continue
        shade = colour(theme, mine[0]["family"])
        xs, ys = [places[row["level"]] for row in mine], [max(rate, none) for rate in rates]
        ax.plot(xs, ys, color=shade, lw=1.4, marker=mark, ms=5)
        taken += zip(xs, ys, strict=True)
        worst = ys.index(max(ys))
        labels.append((xs[worst], ys[worst], name, colour(theme, mine[0]["family"], text=True)))
    ax.set(yscale="log", ylim=(none / 1.5, 6.0), xlim=(-0.5, len(places) - 0.3))
    ticks = [rate for rate in (1e-3, 1e-2, 1e-1, 1.0) if rate >= 0.9 / of]
    ax.set_yticks([none, *ticks], ["0", *(f"{rate * 100:g} %" for rate in ticks)])
    ax.set_xticks(list(places.values()), [_power(e) for e in places])
    ax.set_xlabel(way.axis)
    words = f"never wrong: {', '.join(_together(never))}" if never else "every method was wrong somewhere"
    ax.annotate(
        words,
        (0, 1),
        (0, 5),
        xycoords="axes fraction",
        textcoords="offset points",
        fontsize=TEXT,
        color=theme.roles["ink"],
    )
    label_points(ax, labels, theme, taken)


def _together(names: list[str]) -> list[str]:
    """satviz's three forms as one, where all are there."""
    mine = [name for name in names if name.startswith("satviz")]
    forms = [name for _, name in SHOWN.values() if name.startswith("satviz")]
    return ["satviz", *(name for name in names if name not in mine)] if set(mine) == set(forms) else names


def _totals(fig: Figure, rows: Rows, x: float, y: float, theme: Theme) -> None:
    """Where no panel is: the wrong answers of each method over all panels."""
    look = {"fontsize": TEXT, "va": "top", "parse_math": False}
    line = 16 / (fig.get_size_inches()[1] * 72)
    fig.text(x, y, "wrong answers in all panels", color=theme.roles["ink"], fontweight="bold", **look)
    for i, (name, (wrong, of, family)) in enumerate(sorted(_sums(rows).items(), key=lambda item: -item[1][0])):
        shade = colour(theme, family, text=True)
        fig.text(x, y - (i + 1.3) * line, f"{name}: {wrong:,} of {of:,}", color=shade, **look)


def _sums(rows: Rows) -> dict[str, tuple[int, int, str]]:
    """Of each method, by the name it has here: wrong answers, pairs, family."""
    found: dict[str, tuple[int, int, str]] = {}
    for row in rows:
        name = SHOWN[row["form"], row["method"]][1]
        wrong, of, family = found.get(name, (0, 0, row["family"]))
        found[name] = wrong + times_wrong(row), of + row["checked"], family
    return found


def _power(level: int) -> str:
    return "2" + str(level).translate(RAISED)


def _reading(rows: Rows, ways: list[Way]) -> str:
    """Who was never wrong, and where the others break, in words."""
    sums = _sums(rows)
    never = _together([name for name, (wrong, _, _) in sums.items() if not wrong])
    pairs, levels = next(iter(sums.values()))[1], len({(row["way"], row["level"]) for row in rows})
    text = f"On {pairs:,} pairs at {levels} levels of {len(ways)} kinds of hardness, "
    text += f"never wrong: {', '.join(never) or 'none'}. "
    for way in ways:
        worst = max((row for row in rows if row["way"] == way.name), key=lambda row: times_wrong(row) / row["checked"])
        if times_wrong(worst):
            name, level = SHOWN[worst["form"], worst["method"]][1], _power(worst["level"])
            share = times_wrong(worst) / worst["checked"]
            text += f"By {way.axis}, the worst is {name}: {share:.0%} wrong at {level}. "
    return text.strip()
