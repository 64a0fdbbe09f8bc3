"""Speed against accuracy: the time for a pair, and the largest gap that a method tells wrongly in a scene of 1 km.

Question: what does an exact answer cost, and what does it gain?  Workload: 4-gons with sides of 1 m or more, at most
14 m across, with coordinates up to 1 km; wrong answers are also counted on 4-gons that touch exactly, and on 4-gons of
sizes at 2^400 and beyond.  Methods: all compiled ones, each at its fastest.  Accuracy is the worst that a search found
(`adversary`), and for SAT in float64 the proven bound beside it; time is the median over processes, of the answer alone
and from the raw arrays.  The claim is refuted by a gap above the proven bound that SAT tells wrongly, by one wrong
answer of satviz, or by a faster form of a rival.
"""

import math
from functools import partial
from math import log10
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from ...engine.shapes import Polygon
from ...pictures import Theme
from ...render.chart import TEXT_POINTS, WIDTH, Chart, JsonRow, add_axes, label_points
from .. import truth
from ..harness import timings
from ..harness.cells import Cell, Settings
from ..harness.chart import family_colour, format_time, set_time_ticks
from ..methods import (
    COMPILED,
    VECTORISED,
    Method,
    all_methods,
    answers_by_method,
    count_mistakes,
    true_relations,
)
from ..workloads.adversary import (
    LEAST_SIDE,
    METRES_WIDE,
    MOST_ACROSS,
    beside,
    kilometre_shapes,
    search_size,
    worst_kilometre_shapes,
    worst_kilometre_shapes_for_circles,
    worst_kilometre_shapes_in_float32,
    worst_pair,
)
from ..workloads.generators import Rings
from ..workloads.hard_pairs import EXTREME_KIND, hard_pairs, touching_quadrilaterals

SEARCHED = {  # the pairs with which a search begins, where they are not those of `worst_kilometre_shapes`
    "SAT, float32": worst_kilometre_shapes_in_float32,
    "bounding circles": worst_kilometre_shapes_for_circles,
}
GRID_METRES = 2.0**-43  # the step between neighbouring float64 numbers from 512 to 1024
# in roundings u * span * reach the rounded normal costs 4 (with unit length 8), the landing of the corner 4, and that
# of the edge 4.  So SAT on outward normals is right where the relative margin is above 12 (16).
PROVEN_MARGINS = {"SAT, raw normals": 12, "SAT, unit normals": 16}
SAT_MARGIN = max(PROVEN_MARGINS.values())
ATOM_METRES = 1e-10
LABELS = {
    "bounding circles": "circles", "AABB": "boxes (AABB)", "SAT, float32": "SAT, float32",
    "SAT, raw normals": "SAT, float64", "SAT, tolerance 1e-9": "SAT, tolerance 1e-9 m", "GJK": "GJK",
    "satviz": "satviz: exact, proven", "shapely": "shapely",
}  # fmt: skip
NONE = -18.5  # log10 of the height at which methods are drawn without a wrong answer, or with one below LEAST_CHARTED
LEAST_CHARTED = 1e-17  # metres
SIZES = f"4-gons with sides of {LEAST_SIDE:g} m or more, at most {MOST_ACROSS:g} m across"
TICKS = {"1 m": 0, "1 mm": -3, "1 µm": -6, "1 nm": -9, "1 pm": -12, "1 fm": -15}


def compiled_methods() -> list[Method]:
    """Return the methods that run compiled code and are installed."""
    return [method for method in all_methods() if method.language == COMPILED]


def proven_metres(name: str) -> float | None:
    """Return the gap in metres above which a method is proven right in a scene of 1 km, or None."""
    margin = 0 if name == "satviz" else PROVEN_MARGINS.get(name)
    return None if margin is None else margin * 2.0**-53 * METRES_WIDE


def cells(settings: Settings) -> list[Cell]:
    """Return a search for each method, the counts of wrong answers, and the times of each process."""
    names = [method.name for method in compiled_methods()]
    found = [
        Cell(f"worst-{name.replace(' ', '-').replace(',', '')}", search, (name, *search_size(name, settings), settings))
        for name in names
    ]
    pairs = 200 if settings.quick else 4000
    found += [Cell(f"count-{work}", count_errors, (work, pairs, settings)) for work in WORKS]
    rounds = 3 if settings.quick else 9
    return [
        *found,
        *timings.cells_by_process("speed", take_times, (pairs_in_a_call(settings), rounds, settings), settings),
    ]


def pairs_in_a_call(settings: Settings) -> int:
    """Return how many pairs are timed at once; with few of them the call itself takes most of the time."""
    return 20_000 if settings.quick else 100_000


def search(name: str, n: int, generations: int, settings: Settings) -> JsonRow:
    """Return a row with a method's worst pair in a scene of 1 km; its `metres`: the gap, or the depth of the overlap.

    n, generations: as in `worst_pair`.
    """
    (method,) = (method for method in compiled_methods() if method.name == name)
    found = worst_pair(
        method, SEARCHED.get(name, worst_kilometre_shapes), settings.rng("worst", name), n, generations, metres=True
    )
    row: JsonRow = {"method": name, "family": method.family, "metres": 0.0, "mistake": "", "tried": found.tried}
    if found.margin:
        a, b = Polygon(found.a[0]), Polygon(found.b[0])
        hit = truth.agreed(a, b) > 0
        row["metres"] = math.sqrt(truth.squared_gap(a, b))
        row |= {"mistake": "missed hit" if hit else "false hit", "a": found.a[0].tolist(), "b": found.b[0].tolist()}
    return row


def _near_pairs(rng: np.random.Generator, n: int) -> tuple[Rings, Rings]:
    """Return pairs in a scene of 1 km with gaps and overlaps of every size from 1e-16 m on."""
    a, b = kilometre_shapes(rng, n)
    return a, beside(rng, a, b, np.ldexp(rng.uniform(1, 2, n), rng.integers(-53, 0, n)) * rng.choice([-1.0, 1.0], n))


WORKS: dict[str, Any] = {
    "near": _near_pairs,
    "touching": touching_quadrilaterals,
    "extreme": lambda rng, n: hard_pairs(EXTREME_KIND, rng, max(2, n // 40))[:2],
}


def count_errors(work: str, n: int, settings: Settings) -> list[JsonRow]:
    """Return for each method its wrong answers on about n pairs of `WORKS`, which both oracles check."""
    a, b = WORKS[work](settings.rng(work), n)
    right, rows = true_relations(a, b), []
    for method, answers in answers_by_method(compiled_methods(), a, b):
        mistakes = count_mistakes(answers, right)
        rows.append({"method": method.name, "pairs": len(a), "wrong": sum(mistakes.values()), **mistakes})
    return rows


def take_times(n: int, rounds: int, settings: Settings) -> list[JsonRow]:
    """Return each method's ns for a pair: of the answer alone, and from the arrays to the answer."""
    a, b = kilometre_shapes(settings.rng("times"), n)
    b = b + settings.rng("moves").uniform(-8, 8, (n, 1, 2))
    found = {method.name: method for method in compiled_methods()}

    jobs = {(name, "ns"): partial(m.hits, m.prepare(a), m.prepare(b)) for name, m in found.items()}
    jobs |= {(name, "whole"): partial(m.from_arrays, a, b) for name, m in found.items()}
    named = {"/".join(key): job for key, job in jobs.items()}
    times = timings.time_jobs(named, rounds, dict.fromkeys(named, n))
    return [{"method": name, "ns": times[f"{name}/ns"], "whole": times[f"{name}/whole"]} for name in found]


def summaries(found: dict[str, Any]) -> list[JsonRow]:
    """Return a row for each method: worst gap, wrong answers by workload, and times; found: results by cell name."""
    rows = []
    for times in timings.over_processes(found, "speed", ("ns", "whole")):
        (worst,) = (
            row for name, row in found.items() if name.startswith("worst-") and row["method"] == times["method"]
        )
        row = {**worst, "proven": proven_metres(times["method"])}
        for work in WORKS:
            (count,) = (row for row in found[f"count-{work}"] if row["method"] == times["method"])
            row |= {f"{work}_{what}": count[what] for what in ("pairs", "wrong", "false_hits", "missed_hits")}
        rows.append({**row, **times})
    return rows


def rows(found: dict[str, Any]) -> dict[str, list[JsonRow]]:
    """Return {stem: rows} of both charts, whose rows are the same; empty where nothing is compiled.

    found: the results of all cells by their names.
    """
    found_rows = summaries(found)
    return dict.fromkeys(CHARTS, found_rows) if len(found_rows) > 2 else {}


def in_metres(gap: float) -> str:
    """Return a length in metres as text, in a fitting unit and with up to two digits."""
    for size, unit in (1.0, "m"), (1e-3, "mm"), (1e-6, "µm"), (1e-9, "nm"), (1e-12, "pm"), (1e-15, "fm"):
        if gap >= size:
            return f"{float(f'{gap / size:.2g}'):g}\u00a0{unit}"  # not parted at the end of a line
    if gap < LEAST_CHARTED:
        return f"{gap:.0e}\u00a0m" if gap else "none"
    return f"{float(f'{gap / 1e-15:.1g}'):g}\u00a0fm"


def main_chart(rows: list[JsonRow], settings: Settings) -> Chart:
    """Return the chart of time against the largest gap with a wrong answer, with at most eight labels."""
    by_name = {row["method"]: row for row in rows}
    sat, exact = by_name["SAT, raw normals"], by_name["satviz"]
    ratios = timings.ratio_interval(exact["ns_runs"], sat["ns_runs"])
    ratio = timings.format_ratio(ratios)
    title = (
        f"SAT in float64 can be wrong only about gaps below {in_metres(SAT_MARGIN * 2.0**-53 * METRES_WIDE)} in 1 km "
        f"(proven); satviz, exact, takes {ratio} as long"
    )
    lines = (
        f"{SIZES}; {pairs_in_a_call(settings):,} pairs in a call. Dot: the worst that a search found. Dash: the proven "
        "bound. SAT in float64: left with raw normals, right with normals of length 1.",
    )
    shown = [*LABELS, "SAT, unit normals"]
    limits = min(by_name[name]["ns"] for name in shown) / 3, max(by_name[name]["ns"] for name in shown) * 2

    def draw(fig: Figure, theme: Theme) -> None:
        """Draw a dot for each method, in metres and in steps of float64."""
        guide = theme.roles["guide"]
        ax = add_axes(fig, (70, 56, WIDTH - 130, 324), theme)
        ax.set(xscale="log", xlim=limits, ylim=(NONE - 1.8, 2))
        set_time_ticks(ax.xaxis, limits)
        ax.set_xlabel("time for a pair: answer only, one core")
        ax.set_yticks([*TICKS.values(), NONE], [*TICKS, f"below\n{in_metres(LEAST_CHARTED)}"])
        ax.set_ylabel("largest gap with a wrong answer in 1 km", labelpad=3)
        ax.axhline(log10(ATOM_METRES), color=guide, lw=0.8, ls=(0, (1, 2.2)))
        style: dict[str, Any] = {"fontsize": TEXT_POINTS, "color": guide, "parse_math": False}
        ax.text(0.99, log10(ATOM_METRES) + 0.1, "an atom", transform=ax.get_yaxis_transform(), ha="right", **style)
        ax.axhline(log10(LEAST_CHARTED), color=guide, lw=0.8)
        steps = ax.secondary_yaxis("right")
        decades = [log10(GRID_METRES) + k for k in (0, 3, 6, 9, 12)]
        steps.set_yticks(decades, ["1", "10³", "10⁶", "10⁹", "10¹²"])
        steps.tick_params(color=guide, labelcolor=guide, labelsize=TEXT_POINTS, length=3)
        steps.spines["right"].set_color(guide)
        steps.set_ylabel("in steps of float64 at 1 km", color=guide, fontsize=TEXT_POINTS)
        labels, taken = [], list[tuple[float, float]]()
        for name in shown:
            row, shade = by_name[name], family_colour(theme, by_name[name]["family"])
            y = log10(row["metres"]) if row["metres"] >= LEAST_CHARTED else NONE
            ax.plot([row["ns"]], [y], "D" if name == "satviz" else "o", color=shade, ms=8, clip_on=False, zorder=5)
            if row["proven"]:
                ax.plot([row["ns"]] * 2, [y, log10(row["proven"])], color=shade, lw=1.2)
                ax.plot([row["ns"]], [log10(row["proven"])], "_", color=shade, ms=12, mew=2)
                taken += [(row["ns"], y + (log10(row["proven"]) - y) * k / 4) for k in range(1, 5)]
            if name in LABELS:
                below = f": {in_metres(row['metres'])}" if name == "shapely" and y == NONE else ""
                labels.append((row["ns"], y, LABELS[name] + below, family_colour(theme, row["family"], text=True)))
            else:
                taken.append((row["ns"], y))
        unit = by_name["SAT, unit normals"]
        ax.plot([sat["ns"], unit["ns"]], [log10(row["metres"] or 1e-18) for row in (sat, unit)],
                color=family_colour(theme, "float SAT"), lw=1, ls=":")  # fmt: skip
        at = log10(sat["metres"] or 1e-18)
        ax.annotate("", (exact["ns"], NONE), (sat["ns"], at), zorder=4, arrowprops={
            "arrowstyle": "->", "color": theme.roles["ink"], "shrinkA": 4, "shrinkB": 5,
            "connectionstyle": "angle,angleA=-90,angleB=180"})  # fmt: skip
        taken += [(sat["ns"], NONE + (at - NONE) * k / 8) for k in range(8)]
        ax.text(sat["ns"] * 0.9, (at + NONE) / 2, f"{ratios[0]:.1f} times", color=theme.roles["ink"], ha="right",
                va="center", fontsize=TEXT_POINTS)  # fmt: skip
        label_points(ax, labels, theme, taken)

    text = f"{title}. In brackets: {timings.interval_in_words(len(sat['ns_runs']))}. "
    text += f"satviz is compared with raw normals. {SIZES}; {pairs_in_a_call(settings):,} pairs are tested in a call. "
    text += "A gap is measured on the edge normal where it is largest; of an overlap it is the depth. "
    for name in shown:
        row = by_name[name]
        worst = f"wrong at {in_metres(row['metres'])}" if row["metres"] else "none wrong"
        text += f"{name}: {worst} ({row['tried']:,} pairs tried), {format_time(row['ns'])}. "
    checked = sum(exact[f"{work}_pairs"] for work in WORKS)
    wrong = sum(exact[f"{work}_wrong"] for work in WORKS)
    text += f"satviz was wrong on {wrong} of {checked:,} hard pairs that two exact oracles checked. {VECTORISED}"
    return Chart("speed-against-accuracy", title, lines, 390, draw, rows, text, timings.timing_warning(rows, settings))


def all_methods_chart(rows: list[JsonRow], settings: Settings) -> Chart:
    """Return the chart for experts: every method's time with and without preparing, and its wrong answers."""
    rows = sorted(rows, key=lambda row: row["ns"])
    by_name = {row["method"]: row for row in rows}
    exact, sat = by_name["satviz"], by_name["SAT, raw normals"]
    ratio = timings.format_ratio(timings.ratio_interval(exact["whole_runs"], sat["whole_runs"]))
    right = [row["method"] for row in rows
             if not any(row[key] for key in ("metres", *(f"{work}_wrong" for work in WORKS)))]  # fmt: skip
    title = f"Never found wrong: {', '.join(right) or 'none'}. From arrays to answers satviz takes {ratio} as long as "
    title += "SAT with raw normals"
    lines = (
        f"{pairs_in_a_call(settings):,} pairs in a call. Full dot: the answer alone. Open dot: from the arrays to the "
        "answer, once. Bars: the spread of the processes. Worst gap: in 1 km. Wrong: of "
        f"{exact['touching_pairs']:,} exact touches, and of {exact['extreme_pairs']:,} pairs of sizes at 2^400 and "
        "beyond.",
    )
    tall = 22.0 * len(rows)

    def draw(fig: Figure, theme: Theme) -> None:
        """Draw a row for each method: both times, and on the right its wrong answers."""
        ax = add_axes(fig, (132, 56, 92, tall), theme)
        style: dict[str, Any] = {"fontsize": TEXT_POINTS, "va": "center_baseline", "parse_math": False}
        heads = ("worst\ngap", "touches\nwrong", "extreme\nwrong")
        places = 1.31, 1.84, 2.44
        for x, words in zip(places, heads, strict=True):
            ax.text(x, -1.3, words, transform=ax.get_yaxis_transform(), color=theme.roles["guide"], ha="center",
                    fontsize=TEXT_POINTS, va="center", linespacing=1.1)  # fmt: skip
        for y, row in enumerate(rows):
            shade, ink = family_colour(theme, row["family"]), theme.roles["ink"]
            ax.plot([row["ns"], row["whole"]], [y, y], color=shade, lw=1.4, alpha=0.6)
            for key, fill in ("ns", shade), ("whole", theme.paper):
                ax.plot([row[f"{key}_low"], row[f"{key}_high"]], [y, y], color=ink, lw=1, zorder=4)
                ax.plot([row[key]], [y], "o", mec=shade, mfc=fill, ms=7, mew=1.5, zorder=3)
            cells_of = (in_metres(row["metres"]), f"{row['touching_wrong']:,}", f"{row['extreme_wrong']:,}")
            for x, words in zip(places, cells_of, strict=True):
                ax.text(x, y, words, transform=ax.get_yaxis_transform(), color=ink, ha="center", **style)
        ax.set(xscale="log", ylim=(len(rows) - 0.5, -0.5), xlabel="time for a pair")
        ax.set_yticks(range(len(rows)), [row["method"] for row in rows])
        limits = ax.get_xlim()
        ax.set_xlim(limits)
        set_time_ticks(ax.xaxis, limits, step=2)
        ax.tick_params(axis="y", length=0)
        ax.spines["left"].set_visible(False)

    text = f"{title}. In brackets: {timings.interval_in_words(len(sat['ns_runs']))}. "
    text += "SAT checks no shapes, satviz does. "
    for row in rows:
        text += (
            f"{row['method']}: {format_time(row['ns'])} for the answer, {format_time(row['whole'])} from the arrays; "
        )
        text += f"wrong at {row['touching_wrong']:,} touches and {row['extreme_wrong']:,} extreme pairs. "
    return Chart(
        "all-methods", title, lines, tall + 98, draw, rows, text + VECTORISED, timings.timing_warning(rows, settings)
    )


CHARTS = {"speed-against-accuracy": main_chart, "all-methods": all_methods_chart}
