"""Pose error: how far the corners of a shape are off after it has turned step by step, against what SAT may lose.

Question: of the errors in a moving scene, which are made before any test begins?  Workload: a corner at a distance
from the origin, turned about it by a constant step, 10,000 times.  Methods: turning the corner again and again, and
turning the first corner once, by the number of steps times the step; both in float64 and in float32; and in float64 by
an angle to which every step was added.  The exact pose comes from integers.
The claim is refuted if the corners are nearer to the exact pose after all turns than the roundings that SAT may lose.
"""

from collections.abc import Sequence
from fractions import Fraction
from math import hypot
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from ...pictures import Theme
from ...render.chart import TEXT_POINTS, Chart, JsonRow, add_axes
from ..harness.cells import Cell, Settings
from ..harness.chart import label_ends, median_interval
from .speed_against_accuracy import SAT_MARGIN, in_metres

STEPS = (1, 10, 100, 1000, 10_000)
DISTANCES = (1.0, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6)  # metres
BITS = 160  # bits of the integers in which the exact pose is computed; 10,000 steps lose 15 of them
KILOMETRE = 1e3
STEP_ANGLES = 0.001, 0.1  # radians
FORMATS: dict[str, Any] = {"float32": np.float32, "float64": np.float64}
POSES = {
    ("float32", "steps"): ("float32, step by step", "tolerance", "-"),
    ("float32", "angle"): ("float32, steps counted", "tolerance", "--"),
    ("float64", "steps"): ("float64, step by step", "float", "-"),
    ("float64", "angle"): ("float64, steps counted", "float", "--"),
    ("float64", "sum"): ("float64, angle added up", "float", "-."),
}


def cells(settings: Settings) -> list[Cell]:
    """Return one cell, which rotates corners by random steps."""
    return [Cell("pose", measure, (8 if settings.quick else 60, settings))]


def measure(corners: int, settings: Settings) -> list[JsonRow]:
    """Return for each float format, way to rotate, distance and number of steps the error of a corner, in metres.

    The median, with its 95 % interval, and the worst are over random corners and steps.
    """
    errors: dict[tuple[str, str, float, int], list[float]] = {}
    rng = settings.rng("pose")
    for _ in range(corners):
        angle, start = float(rng.uniform(*STEP_ANGLES)), float(rng.uniform(0, 6))
        c, s = _exact_turn(angle)
        totals = {"angle": {step: step * angle for step in STEPS}, "sum": _added_up(angle)}
        for distance in DISTANCES:
            at = distance * np.cos(start), distance * np.sin(start)
            exact = _exact_path(at, c, s)
            for form, way in POSES:
                path = (
                    _by_steps(at, angle, FORMATS[form]) if way == "steps" else _by_angle(at, totals[way], FORMATS[form])
                )
                for step in STEPS:
                    off = hypot(*(float(Fraction(float(p)) - q) for p, q in zip(path[step], exact[step], strict=True)))
                    errors.setdefault((form, way, distance, step), []).append(off)
    measured: list[JsonRow] = []
    for (form, way, distance, step), found in errors.items():
        median, low, high = median_interval(found)
        measured.append({"format": form, "way": way, "distance": distance, "steps": step, "corners": corners,
                         "median": median, "low": low, "high": high, "worst": max(found)})  # fmt: skip
    return measured


def _exact_turn(angle: float) -> tuple[int, int]:
    """Return (cosine, sine) of an angle in radians as integers over 2**BITS, by their series."""
    x, _ = angle.as_integer_ratio()
    unit = 1 << BITS
    x = x * unit // angle.as_integer_ratio()[1]
    total, term, k = [unit, 0], unit, 0
    while term:
        k += 1
        term = term * x // unit // k
        total[k % 2] += term if k % 4 < 2 else -term
    return total[0], total[1]


def _exact_path(at: tuple[float, float], c: int, s: int) -> dict[int, tuple[Fraction, Fraction]]:
    """Return {number of STEPS: the exact point after them} from `at`; c, s: a step's cosine and sine over 2**BITS."""
    x, y = (int(v.as_integer_ratio()[0] * (1 << BITS) // v.as_integer_ratio()[1]) for v in map(float, at))
    path = {}
    for step in range(1, STEPS[-1] + 1):
        x, y = (x * c - y * s) >> BITS, (x * s + y * c) >> BITS
        if step in STEPS:
            path[step] = Fraction(x, 1 << BITS), Fraction(y, 1 << BITS)
    return path


def _by_steps(at: tuple[float, float], angle: float, dtype: Any) -> dict[int, tuple[Any, Any]]:
    """Return {number of STEPS: the point after them} from `at`; each step rotates the last point by `angle`."""
    x, y, c, s = dtype(at[0]), dtype(at[1]), dtype(np.cos(angle)), dtype(np.sin(angle))
    path = {}
    for step in range(1, STEPS[-1] + 1):
        x, y = x * c - y * s, x * s + y * c
        if step in STEPS:
            path[step] = x, y
    return path


def _added_up(angle: float) -> dict[int, float]:
    """Return {number of STEPS: the sum of so many angles}, one added after the other in float64."""
    sums = np.cumsum(np.full(STEPS[-1], angle))  # cumsum adds from left to right
    return {step: float(sums[step - 1]) for step in STEPS}


def _by_angle(at: tuple[float, float], totals: dict[int, float], dtype: Any) -> dict[int, tuple[Any, Any]]:
    """Return {number of STEPS: the point after them}: the first point `at` turned once by the angle of all steps.

    totals: {number of STEPS: this angle} in float64; its cosine and sine are rounded to `dtype`, as the points are.
    """
    x, y = dtype(at[0]), dtype(at[1])
    turns: dict[int, NDArray[Any]] = {
        step: np.array([np.cos(total), np.sin(total)], dtype) for step, total in totals.items()
    }
    return {step: (x * c - y * s, x * s + y * c) for step, (c, s) in turns.items()}


def rows(found: dict[str, Any]) -> dict[str, list[JsonRow]]:
    """Return {stem of the chart: its rows}; found: the results of all cells by their names."""
    return {"pose-error": found["pose"]}


def chart(rows: Sequence[JsonRow], settings: Settings) -> Chart:
    """Return the chart of two panels: the error against the distance, and at 1 km against the number of steps."""
    last = STEPS[-1]
    by = {(row["format"], row["way"], row["distance"], row["steps"]): row for row in rows}
    fine, coarse, counted, added = (
        "{} ({} to {})".format(*(in_metres(by[form, way, KILOMETRE, last][key]) for key in ("median", "low", "high")))
        for form, way in (("float64", "steps"), ("float32", "steps"), ("float64", "angle"), ("float64", "sum"))
    )
    sat = SAT_MARGIN * 2.0**-53
    title = (
        f"{last:,} turns step by step put a corner at 1\u00a0km off by {fine} in float64 and {coarse} in float32; "
        f"SAT loses at most {in_metres(sat * KILOMETRE)}"
    )
    lines = (
        f"Where a corner is against where it should be: the median of {rows[0]['corners']} corners, with bars for its "
        f"95 % interval, in steps of {STEP_ANGLES[0]} to {STEP_ANGLES[1]} radians. Turned once, by the number of steps "
        f"times the step, it is off by {counted} in float64; by an angle that is added up, by {added}. So count "
        "such steps.",
    )

    def draw(fig: Figure, theme: Theme) -> None:
        """Draw both panels, and the bound of SAT as a dotted line."""
        for k, (bottom, words) in enumerate(
            ((294.0, "distance from the origin, 10,000 turns"), (48.0, "turns at 1 km"))
        ):
            ax = add_axes(fig, (52, bottom, 178, 190), theme)
            xs = STEPS if k else DISTANCES
            ends = []
            for (form, way), (label, role, style) in POSES.items():
                own = [by[form, way, KILOMETRE, x] if k else by[form, way, x, last] for x in xs]
                ys = [row["median"] for row in own]
                ax.plot(xs, ys, color=theme.roles[role], ls=style, lw=1.8, marker="o", ms=3.5)
                ax.vlines(xs, [row["low"] for row in own], [row["high"] for row in own], theme.roles[role], lw=1)
                ends.append((xs[-1], ys[-1], label, theme.text.get(role, theme.roles[role])))
            bound = [sat * (KILOMETRE if k else x) for x in xs]
            ax.plot(xs, bound, color=theme.roles["ink"], ls=":", lw=1.4)
            ends.append((xs[-1], bound[-1], "lost by SAT (proven)", theme.roles["ink"]))
            ax.set(xscale="log", yscale="log", ylim=(1e-17, 1e4))
            ax.set_xlabel(words, fontsize=TEXT_POINTS)
            ticks = [1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 1.0, 1e3]
            names = ["1 fm", "1 pm", "1 nm", "1 µm", "1 mm", "1 m", "1 km"]
            ax.set_yticks(ticks, names)
            marks = {1: "1", 100: "100", 10_000: "10,000"} if k else {1.0: "1 m", 1e3: "1 km", 1e6: "1,000 km"}
            ax.set_xticks(list(marks), list(marks.values()))
            ax.minorticks_off()
            label_ends(ax, ends)

    text = f"{title}. The median of {rows[0]['corners']} corners, in steps of {STEP_ANGLES[0]} to {STEP_ANGLES[1]} "
    text += "radians. "
    for (form, way), (label, _, _) in POSES.items():
        row = by[form, way, KILOMETRE, last]
        roundings = row["median"] / (KILOMETRE * (2.0**-53 if form == "float64" else 2.0**-24))
        text += f"{label}: off by {in_metres(row['median'])} at 1 km after {last:,} turns, {roundings:,.1f} roundings "
        text += f"of a kilometre, and {in_metres(row['worst'])} at worst. "
    text += "The error grows about in proportion to the distance. "
    text += "Exact predicates answer exactly about poses that are not."
    return Chart("pose-error", title, lines, 490, draw, rows, text)


CHARTS = {"pose-error": chart}
