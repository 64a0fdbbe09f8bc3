"""Speed against resolution: up to which gamma each method was wrong in a sample, and what it takes a pair.

gamma is how hard a pair is for floats that can hold the shapes and the products of their coordinates.  It ranks
methods where a rate of wrong answers would only say how the workload was made.  The largest gamma of a sample is
no bound: a search for the worst pairs finds larger ones.
"""

from collections.abc import Sequence
from math import log2
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ...pictures import Theme
from ..harness.cells import Cell, Settings
from ..harness.chart import (
    TEXT_POINTS,
    Chart,
    add_axes,
    draw_headline,
    family_colour,
    format_time,
    label_points,
    set_time_ticks,
)
from ..harness.machine import is_installed
from ..harness.timings import timing_warning
from ..methods import COMPILED, NUMPY, PYTHON, VECTORISED
from ..workloads.hard_pairs import HARD_KINDS, MARGIN_OCTAVES
from . import errors_by_margin
from .error_counts import (
    ALL_KINDS,
    EXACT_BY_CONSTRUCTION,
    FIXED_TOLERANCE,
    NONE_WRONG,
    WRONG_AT_ANY_DISTANCE,
    Row,
    cell_name,
    count_errors,
    count_errors_by_margin,
    method_summaries,
    take_times,
)

GAP_PER_MARGIN = 2.0**-53 * 1e3  # what gamma 1 is, as a gap in metres, where coordinates reach a kilometre
ATOM_METRES = 1e-10  # metres
TICK_METRES = {"1 mm": 1e-3, "1 µm": 1e-6, "1 nm": 1e-9, "1 pm": 1e-12}
WIDE, ROW, SCALE = 640.0, 17.0, 190.0  # points


def cells(settings: Settings) -> list[Cell]:
    """For each kind of hardness, and for exact touching and ordinary pairs, what is counted; and the times."""
    each, many = (12, 400) if settings.quick else (120, 10_000)
    found = [Cell(cell_name(kind), count_errors_by_margin, (i, each, settings)) for i, kind in enumerate(ALL_KINDS)]
    found += [Cell(f"count-{work}", count_errors, (work, many, settings)) for work in ("touching", "ordinary")]
    sizes = (
        {COMPILED: 30_000, NUMPY: 4000, PYTHON: 200}
        if settings.quick
        else {COMPILED: 100_000, NUMPY: 20_000, PYTHON: 1000}
    )
    rounds = 5 if settings.quick else 21
    return [*found, Cell("resolution-times", take_times, (sizes, rounds, settings), timed=True)]


def charts(found: dict[str, Any], settings: Settings) -> list[Chart]:
    """The main one; the rates behind it; the kinds of hardness apart; and the interpreted methods."""
    interpreted = _interpreted_chart(method_summaries(found), settings)
    if not is_installed("numba"):
        return [interpreted]
    return [
        main_chart(method_summaries(found), settings),
        errors_by_margin.error_rate_chart(found),
        errors_by_margin.hardness_chart(found),
        interpreted,
    ]


def main_chart(rows: Sequence[Row], settings: Settings) -> Chart:
    """The compiled ones, from their rows alone."""
    mine = [row for row in rows if row["language"] == COMPILED]
    gap = _largest_float64_margin(mine) * GAP_PER_MARGIN
    small = (
        "gaps smaller than an atom"
        if 0 < gap < ATOM_METRES
        else f"gaps below {_gap_in_a_kilometre(_largest_float64_margin(mine))}"
    )
    title = f"In this sample, at 1 km, float64 SAT was wrong only at {small}"
    return _lane_chart("speed-against-accuracy", title, mine, settings, more=VECTORISED)


def _interpreted_chart(rows: Sequence[Row], settings: Settings) -> Chart:
    mine = [{**row, "method": f"{row['method']}, {row['language']}"} for row in rows if row["language"] != COMPILED]
    least = {
        language: format_time(
            min(
                (row["ns"] for row in rows if row["language"] == language and row["method"] == "SAT, raw normals"),
                default=0.0,
            )
        )
        for language in (COMPILED, NUMPY, PYTHON)
    }
    errors = {(r["gamma"], r["wrong"], r["touching_wrong"]) for r in rows if r["method"] == "SAT, raw normals"}
    alike = "same errors in this sample" if len(errors) == 1 else "not the same errors in this sample"
    title = f"SAT: {', '.join(f'{time} {language}' for language, time in least.items())}; {alike}"
    return _lane_chart("interpreted", title, mine, settings)


def _largest_float64_margin(rows: Sequence[Row]) -> float:
    """The largest gamma at which SAT in float64 was wrong."""
    return max(
        (row["gamma"] for row in rows if row["family"] == "float SAT" and "float32" not in row["method"]), default=0.0
    )


def _gap_in_a_kilometre(gamma: float) -> str:
    """The gap in a scene a kilometre across."""
    metres = gamma * GAP_PER_MARGIN
    for size, unit in (1.0, "m"), (1e-3, "mm"), (1e-6, "µm"), (1e-9, "nm"), (1e-12, "pm"):
        if metres >= size:
            return f"{float(f'{metres / size:.2g}'):g} {unit}"
    return f"{metres / 1e-12:.1g} pm"


def _lane_chart(stem: str, title: str, rows: Sequence[Row], settings: Settings, more: str = "") -> Chart:
    """Lanes for what gamma cannot rank, and between them what was wrong up to some gamma, to scale.

    `more`: a last sentence of the reading.
    """
    lanes = {
        name: sorted((r for r in rows if r["lane"] == name), key=lambda r: r["ns"])
        for name in (WRONG_AT_ANY_DISTANCE, FIXED_TOLERANCE, "", NONE_WRONG, EXACT_BY_CONSTRUCTION)
    }
    tall = {name: SCALE if not name else 24 + ROW * len(mine) for name, mine in lanes.items() if mine}
    head, foot = 66.0, 42.0
    size = WIDE, head + foot + sum(tall.values()) + 10 * (len(tall) - 1)
    limits = min(r["ns"] for r in rows) / 1.6, max(r["ns"] for r in rows) * 14
    n = rows[0]

    def draw(fig: Figure, theme: Theme) -> None:
        under = (
            "further left: faster; further down: finer; bars: quartiles of the time",
            f"{n['pairs']:,} pairs made hard in {len(HARD_KINDS)} ways, at least {n['least_an_octave']:,} an octave of gap, "
            f"and {n['touching']:,} that touch; extreme sizes apart",
        )
        draw_headline(fig, theme, title, *under)
        top = size[1] - head
        for name, mine in lanes.items():
            if not mine:
                continue
            top -= tall[name]
            ax = add_axes(fig, (86 / WIDE, top / size[1], (WIDE - 100) / WIDE, tall[name] / size[1]), theme)
            ax.set(xscale="log", xlim=limits)
            last = name == [key for key in lanes if lanes[key]][-1]
            set_time_ticks(ax.xaxis, limits, labels=last)
            if last:
                ax.set_xlabel("time a pair of ordinary 4-gons, shapes made ready beforehand")
            if name:
                _draw_lane(ax, theme, name, mine)
            else:
                _draw_margins(ax, theme, mine)
            top -= 10

    return Chart(
        stem, title, size, draw, list(rows), f"{_reading(rows)} {more}".strip(), timing_warning(rows, settings)
    )


def _draw_lane(ax: Axes, theme: Theme, name: str, rows: Sequence[Row]) -> None:
    """A line each, no order of quality."""
    ax.set(yticks=[], ylim=(24 + ROW * len(rows), 0))
    ax.spines["left"].set_visible(False)
    words = {
        WRONG_AT_ANY_DISTANCE: "wrong at\nany gap",
        FIXED_TOLERANCE: "a fixed\ntolerance",
        NONE_WRONG: "none wrong in\nthis sample",
        EXACT_BY_CONSTRUCTION: "exact by\nconstruction",
    }[name]
    ax.annotate(
        words,
        (0, 0.5),
        (-8, 0),
        xycoords="axes fraction",
        textcoords="offset points",
        ha="right",
        va="center",
        color=theme.roles["ink"],
        fontsize=TEXT_POINTS,
        annotation_clip=False,
    )
    for i, row in enumerate(rows):
        y, shade = 12 + ROW * (i + 0.5), family_colour(theme, row["family"])
        ax.plot([row["ns_low"], row["ns_high"]], [y, y], color=shade, lw=1)
        ax.plot([row["ns"]], [y], "D" if name == EXACT_BY_CONSTRUCTION else "o", color=shade, ms=6)
        # a label that has no place to the right of its point stands to the left of it
        right = log2(row["ns"]) < sum(map(log2, ax.get_xlim())) / 2
        ax.annotate(
            _method_with_share(row),
            (row["ns_high" if right else "ns_low"], y),
            (6 if right else -6, 0),
            textcoords="offset points",
            ha="left" if right else "right",
            va="center_baseline",
            fontsize=TEXT_POINTS,
            color=family_colour(theme, row["family"], text=True),
            parse_math=False,
            annotation_clip=False,
        )


def _method_with_share(row: Row) -> str:
    """A method of a lane, and the share it has wrong of the pairs that tell most about it."""
    wrong, of, pairs = {
        WRONG_AT_ANY_DISTANCE: (row["ordinary_wrong"], row["ordinary"], "ordinary pairs"),
        FIXED_TOLERANCE: (row["wrong"], row["pairs"], "hard pairs"),
    }.get(row["lane"], (row["extreme_wrong"], row["extreme"], "extreme sizes"))
    if not wrong:
        return str(row["method"])
    share = f"{wrong / of:.0%}" if wrong >= 0.01 * of else "under 1%"
    return f"{row['method']}: {share} of {pairs} wrong"


def _draw_margins(ax: Axes, theme: Theme, rows: Sequence[Row]) -> None:
    """What was wrong up to some gamma."""
    ax.set(ylim=(-5, max(MARGIN_OCTAVES) + 1))
    ax.set_yticks([log2(metres / GAP_PER_MARGIN) for metres in TICK_METRES.values()], list(TICK_METRES))
    ax.set_ylabel("wrong up to this gap\nin a scene of 1 km", fontsize=TEXT_POINTS)
    atom, guide = log2(ATOM_METRES / GAP_PER_MARGIN), theme.roles["guide"]
    ax.axhline(atom, color=guide, lw=0.8, ls=(0, (1, 2.2)))
    ax.annotate(
        "an atom",
        (1, atom),
        (0, 2),
        xycoords=ax.get_yaxis_transform(),
        textcoords="offset points",
        ha="right",
        va="bottom",
        color=guide,
        fontsize=TEXT_POINTS,
    )
    labels = []
    for row in rows:
        y, shade = log2(row["gamma"]) if row["gamma"] else -4.0, family_colour(theme, row["family"])
        ax.plot([row["ns_low"], row["ns_high"]], [y, y], color=shade, lw=1)
        ax.plot([row["ns"]], [y], "o", color=shade, ms=6.5)
        labels.append((row["ns"], y, row["method"], family_colour(theme, row["family"], text=True)))
    label_points(ax, labels, theme)


def _reading(rows: Sequence[Row]) -> str:
    n = rows[0]
    text = f"{len(rows)} methods on {n['pairs']:,} pairs made hard in {len(HARD_KINDS)} ways (at least "
    text += f"{n['least_an_octave']:,} an octave of gamma) and {n['touching']:,} that touch exactly. "
    text += "The gammas that follow are the largest of this sample, and other pairs can be wrong at larger ones. "
    for row in sorted((r for r in rows if r["lane"] == ""), key=lambda r: -r["gamma"]):
        upto = f"wrong up to gamma {row['gamma']:.2g} ({_gap_in_a_kilometre(row['gamma'])} in a kilometre)"
        touch = f", and at {row['touching_wrong']:,} of the touches" if row["touching_wrong"] else ""
        text += f"{row['method']}: {upto}{touch}; {format_time(row['ns'])}. "
    fixed = [r for r in rows if r["lane"] == FIXED_TOLERANCE]
    text += "A fixed tolerance is a length, so its gamma changes with the scene. " if fixed else ""
    for row in fixed:
        touch = f" and at {row['touching_wrong']:,} of the touches" if row["touching_wrong"] else ""
        text += f"{row['method']}: wrong on {row['wrong']:,} of the hard pairs{touch}; {format_time(row['ns'])}. "
    for name in (WRONG_AT_ANY_DISTANCE, NONE_WRONG, EXACT_BY_CONSTRUCTION):
        mine = [f"{r['method']} ({format_time(r['ns'])})" for r in rows if r["lane"] == name]
        text += f"{name[0].upper()}{name[1:]}: {', '.join(mine)}. " if mine else ""
    text += f"The chart leaves out {n['extreme']:,} pairs of extreme sizes (2^400 and more, either way), "
    text += "where products leave float64's range. Wrong on those: "
    text += "; ".join(
        f"{r['method']}: {r['extreme_wrong']:,}" for r in rows if r["lane"] in (NONE_WRONG, EXACT_BY_CONSTRUCTION)
    )
    return f"{text}."
