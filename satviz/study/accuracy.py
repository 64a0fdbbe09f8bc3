"""Speed against accuracy: time a pair against wrong answers, method by method, workload by workload."""

import statistics
from collections.abc import Sequence
from functools import partial
from time import perf_counter
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..advice.timing import in_turn
from ..pictures import Theme
from .cells import Cell, Settings
from .chart import TEXT, Chart, axes, colour, headline, label_points, wilson
from .methods import Method, judged, methods, shapes, times_wrong
from .workloads import STUDIED, Side

FORMS = {"batch": "many pairs at once", "scalar": "one pair at a time"}
MAIN = ("mixed polygons", "nearly touching")  # the first chart: ordinary pairs beside the hardest
LEGEND = (
    "● false hits   ✕ false misses   ◆ none wrong   broad line: nothing is both faster and less often wrong in all",
    "thin lines: 95 % interval of the rate (upright), quartiles of the time (level)",
    "plain Python or NumPy, but numba, shapely, pymunk: compiled; set-up left out, as of ranges that are kept",
)
WIDE, HEAD, HIGH = 640.0, 77.0, 380.0  # points: the chart, its title, a scatter with its own title and scale
ROW = 15.0  # points

Rows = list[dict[str, Any]]


def cells(settings: Settings) -> list[Cell]:
    """For each workload one cell that counts wrong answers, and one that takes the time."""
    checked, many, few, rounds = (1000, 4000, 200, 3) if settings.quick else (10_000, 20_000, 1000, 9)
    found = []
    for name in STUDIED:
        stem = name.replace(" ", "-")
        found.append(Cell(f"accuracy-{stem}", count_wrong, (name, checked, settings)))
        found.append(Cell(f"speed-{stem}", take_times, (name, many, few, rounds, settings), timed=True))
    return found


def _pairs(workload: str, n: int, settings: Settings) -> tuple[list[Method], Side, Side]:
    a, b = STUDIED[workload](settings.rng("accuracy", workload), n)
    return methods(circles=isinstance(a, tuple)), a, b


def count_wrong(workload: str, n: int, settings: Settings) -> dict:
    """False hits and false misses of each method on the same n pairs, against rationals."""
    hits, wrong = judged(*_pairs(workload, n, settings))
    return {"checked": n, "hits": hits, "methods": wrong}


def take_times(workload: str, many: int, few: int, rounds: int, settings: Settings) -> list[dict]:
    """Nanoseconds a pair of each method, in turn within each round; set-up (both shapes of a pair) apart."""
    times = []
    for form, n in ("batch", many), ("scalar", few):
        found, a, b = _pairs(workload, n, settings)
        mine = {m.name: m for m in found if m.form == form}
        ready = {name: (m.prepare(a), m.prepare(b)) for name, m in mine.items()}
        jobs = {name: partial(m.hits, *ready[name]) for name, m in mine.items()}
        for name, spread in in_turn(jobs, rounds, dict.fromkeys(jobs, n)).items():
            times.append({"form": form, "method": name, **spread._asdict(), "setup": _setup(mine[name], a, b, n)})
    return times


def _setup(method: Method, a: Side, b: Side, n: int) -> float:
    """What making both shapes of a pair ready costs; for the plain methods without satviz's own checks of them."""
    if method.one and method.family != "exact":
        known = shapes(a), shapes(b)
        jobs = [partial(method.ready, side, shape) for side, shape in zip((a, b), known, strict=True)]
    else:
        jobs = [partial(method.prepare, side) for side in (a, b)]
    taken = []
    for _ in range(3):
        start = perf_counter()
        for job in jobs:
            job()
        taken.append((perf_counter() - start) / n * 1e9)
    return statistics.median(taken)


def charts(results: dict[str, Any]) -> list[Chart]:
    """Ordinary pairs beside the hardest, in batch form; then each workload there is, both forms side by side."""
    there = [name for name in STUDIED if f"speed-{name.replace(' ', '-')}" in results]
    rows = [row for name in there for row in _rows(name, results)]
    found = [main_chart([row for row in rows if row["workload"] in MAIN and row["form"] == "batch"])]
    for name in there:
        mine = [row for row in rows if row["workload"] == name]
        found.append(
            _chart(f"speed-against-accuracy-{name.replace(' ', '-')}", f"Speed against accuracy: {name}", mine, "form")
        )
    return found


def main_chart(rows: Rows) -> Chart:
    """The first chart from its rows alone."""
    title = "Speed against accuracy: 2D collision tests, many pairs at once"
    return _chart("speed-against-accuracy", title, rows, "workload")


def _rows(workload: str, results: dict[str, Any]) -> Rows:
    stem = workload.replace(" ", "-")
    counted, timed = results[f"accuracy-{stem}"], results[f"speed-{stem}"]
    times = {(t["form"], t["method"]): t for t in timed}
    known = {(m.form, m.name): m for circles in (False, True) for m in methods(circles=circles)}
    rows = []
    for count in counted["methods"]:
        key = count["form"], count["method"]
        t, method, of = times[key], known[key], counted["checked"]
        low, high = wilson(times_wrong(count), of)
        facts = {"workload": workload, **count, "series": method.series, "checked": of}
        rate = {"rate": times_wrong(count) / of, "rate_low": low, "rate_high": high}
        ns = {f"ns_{k}": round(t[k], 2) for k in ("median", "least", "low", "high")}
        rows.append(facts | rate | ns | {"ns_setup": round(t["setup"], 2)})
    for form in FORMS:
        mine = [row for row in rows if row["form"] == form]
        for row in mine:
            row["on_front"] = not any(
                other["ns_median"] <= row["ns_median"]
                and other["rate"] <= row["rate"]
                and (other["ns_median"], other["rate"]) != (row["ns_median"], row["rate"])
                for other in mine
            )
    return rows


def _chart(stem: str, title: str, rows: Rows, panels: str) -> Chart:
    """Two scatters, one under the other, one a value of the column `panels`; as wide as a page's text."""
    parts = _panels(rows, panels)
    # points under a scatter: a line for each method that was never wrong
    feet = [10.0 + ROW * max(sum(not row["rate"] for row in mine), 2) for _, mine in parts]
    size = WIDE, HEAD + sum(HIGH + foot for foot in feet)

    def draw(fig: Figure, theme: Theme) -> None:
        headline(fig, theme, title, *LEGEND)
        floor = size[1] - HEAD
        for (name, mine), foot in zip(parts, feet, strict=True):
            floor -= HIGH + foot
            left, width = 72 / WIDE, (WIDE - 88) / WIDE
            top = axes(fig, (left, (floor + foot + 42) / size[1], width, (HIGH - 72) / size[1]), theme, name)
            under = axes(fig, (left, (floor + 38) / size[1], width, foot / size[1]), theme)
            _scatter(top, under, mine, _limits(rows if panels == "workload" else mine), theme)
            under.set_xlabel("time a pair (median)")
            top.set_ylabel("wrong answers")

    return Chart(stem, title, size, draw, rows, " ".join(_reading(mine, name) for name, mine in parts))


def _panels(rows: Rows, column: str) -> list[tuple[str, Rows]]:
    names = dict.fromkeys(row[column] for row in rows)
    return [(FORMS.get(name, name), [row for row in rows if row[column] == name]) for name in names]


def _limits(rows: Rows) -> tuple[float, float]:
    """From the fastest to the slowest, with room for names."""
    ns = [row["ns_median"] for row in rows]
    return min(ns) / 2, max(ns) * 4


def _scatter(top: Axes, under: Axes, rows: Rows, limits: tuple[float, float], theme: Theme) -> None:
    """Those that were wrong by how often, above; those that were not, a line each, below; one scale of time."""
    of, guide = rows[0]["checked"], theme.roles["guide"]
    top.set(xscale="log", yscale="log", xlim=limits, ylim=(0.5 / of, 2.5))
    under.set(xscale="log", xlim=limits, ylim=(0.0, 1.0))
    _ticks(top, under, of)
    _front(top, under, rows, theme)
    for series in dict.fromkeys(row["series"] for row in rows if row["series"]):
        line = [(row["ns_median"], row["rate"]) for row in rows if row["series"] == series and row["rate"]]
        if line:
            top.plot(*zip(*line, strict=True), color=colour(theme, "fewer axes"), lw=0.8, ls=(0, (1, 2)), zorder=1)
    labels, taken = [], []
    for row in (row for row in rows if row["rate"]):
        x, shade = row["ns_median"], colour(theme, row["family"])
        marks = [(row[kind], mark) for kind, mark in (("false_hits", "o"), ("false_misses", "x")) if row[kind]]
        for count, mark in marks:
            top.plot([x, x], wilson(count, of), color=shade, lw=1, alpha=0.5, zorder=2)
            top.plot([x], [count / of], mark, color=shade, ms=6.5, mew=2 if mark == "x" else 0, zorder=3)
            taken.append((x, count / of))
        most = max(count for count, _ in marks) / of
        top.plot([row["ns_low"], row["ns_high"]], [most, most], color=shade, lw=1, zorder=2)
        labels.append((x, most, _label(row, rows), colour(theme, row["family"], text=True)))
    label_points(top, labels, theme, taken)
    clean = _clean(rows)
    words = f"none wrong in {of:,}\n(so at most {wilson(0, of)[1]:.2%}, 95 % sure)"
    under.text(limits[0] * 1.08, 0.02, words, color=guide, fontsize=TEXT, va="bottom", parse_math=False)
    for row, y in zip(clean, _heights(under, len(clean)), strict=True):
        shade, right = colour(theme, row["family"]), row["ns_median"] < (limits[0] * limits[1]) ** 0.5
        under.plot([row["ns_low"], row["ns_high"]], [y, y], color=shade, lw=1)
        under.plot([row["ns_median"]], [y], "D", color=shade, ms=6)
        end = max(row["ns_high"], row["ns_median"] * 1.05) if right else min(row["ns_low"], row["ns_median"] / 1.05)
        note = {"ha": "left" if right else "right", "va": "center_baseline", "parse_math": False, "fontsize": TEXT}
        under.annotate(
            row["method"],
            (end, y),
            (6 if right else -6, 0),
            textcoords="offset points",
            color=colour(theme, row["family"], text=True),
            **note,
        )


def _clean(rows: Rows) -> Rows:
    return sorted((row for row in rows if not row["rate"]), key=lambda row: row["ns_median"])


def _heights(under: Axes, n: int) -> list[float]:
    """A line of text each, from the top."""
    points = under.get_window_extent().height * 72 / under.figure.dpi
    return [1 - (i + 0.6) * ROW / points for i in range(n)]


def _front(top: Axes, under: Axes, rows: Rows, theme: Theme) -> None:
    """The Pareto front as one broad line: along it nothing is both faster and more accurate."""
    look = {"color": theme.roles["guide"], "lw": 5, "alpha": 0.25, "zorder": 1, "solid_joinstyle": "round"}
    front = sorted((row for row in rows if row["on_front"]), key=lambda row: row["ns_median"])
    steps = [(row["ns_median"], row["rate"]) for row in front if row["rate"]]
    last = next((row for row in front if not row["rate"]), None)
    if last and steps:
        steps.append((last["ns_median"], top.get_ylim()[0]))
    if steps:
        top.step(*zip(*steps, strict=True), where="post", **look)
    if last:
        clean = _clean(rows)
        under.plot([last["ns_median"]] * 2, [1, _heights(under, len(clean))[clean.index(last)]], **look)


def _label(row: dict, rows: Rows) -> str:
    """The method's name; inside a series only the number that changes."""
    series = [other["method"] for other in rows if other["series"] == row["series"]]
    inside = row["series"] and row["method"] not in (series[0], series[-1])
    return "".join(c for c in row["method"] if c.isdigit()) if inside else row["method"]


def _ticks(top: Axes, under: Axes, of: int) -> None:
    rates = [rate for rate in (1e-4, 1e-3, 1e-2, 1e-1, 1.0) if rate >= 0.9 / of]
    top.set_yticks(rates, [f"{rate * 100:g} %" for rate in rates])
    under.set_yticks([])
    low, high = under.get_xlim()
    decades = [10.0**e for e in range(8) if low <= 10.0**e <= high]
    units = [f"{d:g} ns" if d < 1e3 else f"{d / 1e3:g} µs" if d < 1e6 else f"{d / 1e6:g} ms" for d in decades]
    top.set_xticks(decades, [])
    under.set_xticks(decades, units)


def _reading(rows: Rows, name: str) -> str:
    """What one panel shows, in words."""
    exact = min((row for row in rows if row["family"] == "exact"), key=lambda row: row["ns_median"])
    wrong = [row for row in rows if times_wrong(row)]
    worst = max(wrong, key=lambda row: row["rate"]) if wrong else None
    front = [row["method"] for row in sorted(rows, key=lambda row: row["ns_median"]) if row["on_front"]]
    of = rows[0]["checked"]
    never = len(rows) - len(wrong)
    text = f"{name[0].upper()}{name[1:]}: of {len(rows)} methods, {never} gave no wrong answer in {of:,}. "
    if worst:
        text += f"Wrong most often: {worst['method']}, {worst['rate']:.1%} ({_kinds(worst)}). "
    floats = [row for row in wrong if row["family"] == "float SAT"]
    if floats:
        best = min(floats, key=lambda row: row["rate"])
        text += f"The best of the float SATs that were wrong, {best['method']}: {best['rate']:.2%} ({_kinds(best)}). "
    text += f"The fastest exact one, {exact['method']}, took {_time(exact['ns_median'])} a pair "
    text += f"(and {_time(exact['ns_setup'])} to make the pair's shapes ready). "
    return text + f"None is both faster and more accurate than these: {_listed(front)}."


def _kinds(row: dict) -> str:
    confused = f", {row['confused']:,} touches confused with overlaps" if row.get("confused") else ""
    return f"{row['false_hits']:,} false hits, {row['false_misses']:,} false misses{confused}"


def _time(ns: float) -> str:
    return f"{ns:.0f} ns" if ns < 1000 else f"{ns / 1000:.1f} µs"


def _listed(names: Sequence[str]) -> str:
    return names[0] if len(names) == 1 else f"{'; '.join(names[:-1])}; and {names[-1]}"
