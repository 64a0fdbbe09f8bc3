"""The cost of each optimisation: dot products and time with it and without, where it helps and where it does not.

A dot product is one corner dropped on one axis, or one axis held against the line of
centers.  Their number is seeded and exact, and what is counted is what is timed.
"""

from collections.abc import Iterator
from contextlib import contextmanager, nullcontext
from statistics import median
from time import perf_counter, thread_time
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..advice.timing import in_turn
from ..pictures import Theme
from .cells import Cell, Settings
from .chart import TEXT, Chart, axes, headline
from .optimisations import SETUPS, Case, Work, cases

Rows = list[dict[str, Any]]
ROW, HEAD, FOOT = 24.0, 84.0, 30.0  # points
UNDER = (
    "share of what the same pairs cost without it (log scale); "
    "processor time, for threads the wall clock's; lines: quartiles"
)


@contextmanager
def _built(slug: str, quick: bool, seed: int) -> Iterator[tuple[Case, Work]]:
    """The case and its work, whose threads end with it."""
    case = next(case for case in cases() if _slug(case) == slug)
    work = case.build(Settings(seed=seed).rng("cost", slug), case.sizes[not quick])
    with work.pool or nullcontext():
        yield case, work


def count(slug: str, quick: bool, seed: int) -> dict[str, Any]:
    """Dot products a pair, without and with."""
    with _built(slug, quick, seed) as (_, work):
        return {"pairs": work.items, "without": work.without() / work.items, "optimised": work.optimised() / work.items}


def take_times(slug: str, quick: bool, seed: int, rounds: int) -> dict[str, Any]:
    """Nanoseconds a pair, without and with, in turn within each round; the set-up apart.

    Of the processor's time, which is what work costs; of the wall clock for threads, which take no less work.
    """
    with _built(slug, quick, seed) as (case, work):
        clock, taken = thread_time if case.counted else perf_counter, []
        for _ in range(SETUPS):
            start = clock()
            work.setup()
            taken.append((clock() - start) / work.items * 1e9)
        jobs = {"without": work.without, "optimised": work.optimised}
        found = in_turn(jobs, rounds, dict.fromkeys(jobs, work.items), clock)
    return {"pairs": work.items, "setup": median(taken), **{name: spread._asdict() for name, spread in found.items()}}


def cells(settings: Settings) -> list[Cell]:
    """For each case one that counts, where there is something to count, and one that takes the time."""
    found = []
    for case in cases():
        asked = _slug(case), settings.quick, settings.seed
        if case.counted:
            found.append(Cell(f"cost-count-{_slug(case)}", count, asked))
        found.append(Cell(f"cost-time-{_slug(case)}", take_times, (*asked, 5 if settings.quick else 25), timed=True))
    return found


def _slug(case: Case) -> str:
    return f"{case.optimisation}-{case.scene}".replace(",", "").replace(" ", "-")


def charts(results: dict[str, Any]) -> list[Chart]:
    """Two rows or more for each optimisation: its dot products and its time, as shares of what they are without it."""
    rows = [_row(case, results) for case in cases()]
    title = "The cost of each optimisation: what is left of dot products and time"
    size = 1080.0, HEAD + FOOT + ROW * len(rows)

    def draw(fig: Figure, theme: Theme) -> None:
        _draw(fig, theme, title, rows)

    return [Chart("cost-of-optimisations", title, size, draw, rows, _told(rows))]


def _row(case: Case, results: dict[str, Any]) -> dict[str, Any]:
    slug = _slug(case)
    timed, counted = results[f"cost-time-{slug}"], results.get(f"cost-count-{slug}")
    row = {"optimisation": case.optimisation, "scene": case.scene, "meant_to_help": case.helps}
    row |= {"pairs": timed["pairs"], "clock": "processor" if case.counted else "wall"}
    if counted:
        row |= {"dots_without": counted["without"], "dots_with": counted["optimised"]}
        row["dots_ratio"] = counted["optimised"] / counted["without"]
    before, after = timed["without"], timed["optimised"]
    for name, times in ("without", before), ("with", after):
        row |= {f"ns_{name}": round(times["median"], 1), f"ns_{name}_least": round(times["least"], 1)}
    row["time_ratio"] = after["median"] / before["median"]
    row["time_low"], row["time_high"] = after["low"] / before["high"], after["high"] / before["low"]
    return row | {"ns_setup": round(timed["setup"], 1)}


def _told(rows: Rows) -> str:
    counted, threads = ([row for row in rows if ("dots_ratio" in row) is has] for has in (True, False))
    best = min(counted, key=lambda row: row["dots_ratio"])
    more = [row for row in counted if row["dots_ratio"] > 1]
    same = sum(row["dots_ratio"] == 1 for row in counted)
    faster, slower = [row for row in rows if row["time_high"] < 1], [row for row in rows if row["time_low"] > 1]
    return (
        f"Most dot products are spared by the {best['optimisation']} ({best['scene']}): {_part(best['dots_ratio'])} "
        f"are left, and {_part(best['time_ratio'])} of the time; {same} of {len(counted)} rows spare none"
        + (f", and there are more in {_list(more, 'dots_ratio')}. " if more else ". ")
        + f"Beyond the quartiles of the times {len(faster)} of {len(rows)} rows are faster and {len(slower)} slower"
        + (f": {_list(slower, 'time_ratio')}. " if slower else ". ")
        + f"Threads share out the work and spare none; of the time they leave {_list(threads, 'time_ratio')}. "
        f"Apart from all this, the first choice of axes for new shapes takes {rows[0]['ns_setup'] / 1e3:.0f} µs a pair "
        "of boxes."
    )


def _list(rows: Rows, key: str) -> str:
    """Optimisation by optimisation, its scenes with their numbers."""
    by: dict[str, list[str]] = {}
    for row in rows:
        by.setdefault(row["optimisation"], []).append(f"{row['scene']} {_part(row[key])}")
    return ", ".join(f"{name} ({'; '.join(scenes)})" for name, scenes in by.items())


def _part(ratio: float) -> str:
    return f"{ratio:.0%}" if ratio >= 0.095 else f"{ratio:.1%}"


def _draw(fig: Figure, theme: Theme, title: str, rows: Rows) -> None:
    headline(fig, theme, title, UNDER)
    height = HEAD + FOOT + ROW * len(rows)
    bottom, tall = FOOT / height, ROW * len(rows) / height
    dots = axes(fig, (0.37, bottom, 0.23, tall), theme, "dot products left")
    time = axes(fig, (0.685, bottom, 0.25, tall), theme, "time left")
    at = {"fontsize": TEXT, "va": "center_baseline", "parse_math": False}
    guide = theme.roles["guide"]
    for y, row in enumerate(rows):
        if y == 0 or rows[y - 1]["optimisation"] != row["optimisation"]:
            words, up = row["optimisation"], bottom + tall * (1 - (y + 0.5) / len(rows))
            fig.text(0.012, up, words, color=theme.roles["ink"], fontweight="bold", **at)
            for ax in (dots, time) if y else ():
                ax.axhline(y - 0.5, color=guide, lw=0.5, alpha=0.5)
        if "dots_ratio" in row:
            _mark(dots, theme, y, row["dots_ratio"], row["dots_ratio"], row["dots_ratio"])
        else:
            dots.text(0.9, y, "shared out", color=guide, ha="right", **at)
        _mark(time, theme, y, row["time_ratio"], row["time_low"], row["time_high"])
    for ax, low, high in (dots, "dots_ratio", "dots_ratio"), (time, "time_low", "time_high"):
        least, most = min(row.get(low, 1) for row in rows), max(row.get(high, 1) for row in rows)
        ax.set(xscale="log", xlim=(least / 1.3, most * 1.3), ylim=(len(rows) - 0.5, -0.5))
        ticks = [tick for tick in (0.001, 0.01, 0.1, 1, 10) if least / 1.3 < tick < most * 1.3]
        ax.set_xticks(ticks, [_part(tick) for tick in ticks])
        ax.minorticks_off()
        ax.axvline(1, color=guide, lw=1, ls=(0, (1, 2.2)), zorder=0)
        ax.spines["left"].set_visible(False)
        ax.tick_params(axis="y", length=0)
    dots.set_yticks(range(len(rows)), [row["scene"] for row in rows])
    time.set_yticks([])


def _mark(ax: Axes, theme: Theme, y: int, ratio: float, low: float, high: float) -> None:
    """A dot where less is left, a square where more is, a ring where that is not sure; its number at the side."""
    role, mark, filled = "guide", "o", False
    if high < 1 or low > 1:
        role, mark, filled = ("exact", "o", True) if high < 1 else ("shortcut", "s", True)
    shade = theme.roles[role]
    ax.plot([low, high], [y, y], color=shade, lw=1.2)
    ax.plot([ratio], [y], mark, mec=shade, mfc=shade if filled else theme.paper, ms=7, mew=1.4)
    at = {"xycoords": ax.get_yaxis_transform(), "fontsize": TEXT, "va": "center_baseline", "annotation_clip": False}
    ax.annotate(_part(ratio), (1.15, y), color=theme.text.get(role, shade), ha="right", **at)
