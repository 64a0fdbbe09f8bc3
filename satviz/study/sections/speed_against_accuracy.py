"""Speed against accuracy: how wrong each method was in a sample of hard pairs, and its time for a pair.

Methods are ranked by the largest relative margin at which they were wrong.  The relative margin says how hard a pair is
for floats: how far the deciding number is from 0, in rounding errors.  A rate of wrong answers would depend on how the
pairs were made.  The largest margin of a sample is no bound: a search for the worst pairs finds larger ones.
"""

from collections.abc import Sequence
from math import log2
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ...pictures import Theme
from ..harness.cells import Cell, JsonRow, Settings
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
    cell_name,
    count_errors,
    count_errors_by_margin,
    method_summaries,
    take_times,
)

# the gap in metres of a relative margin of 1, where coordinates go up to a kilometre: u * 1000 m with u = 2**-53
GAP_PER_MARGIN = 2.0**-53 * 1e3
ATOM_METRES = 1e-10
TICK_METRES = {"1 mm": 1e-3, "1 µm": 1e-6, "1 nm": 1e-9, "1 pm": 1e-12}
WIDTH_POINTS, ROW_POINTS, SCALE_POINTS = 640.0, 17.0, 190.0
LANE_LABELS = {
    WRONG_AT_ANY_DISTANCE: "wrong at\nany gap",
    FIXED_TOLERANCE: "a fixed\ntolerance",
    NONE_WRONG: "none wrong in\nthis sample",
    EXACT_BY_CONSTRUCTION: "exact by\nconstruction",
}
LANE_ORDER = (WRONG_AT_ANY_DISTANCE, FIXED_TOLERANCE, "", NONE_WRONG, EXACT_BY_CONSTRUCTION)  # "": the ranked methods


def cells(settings: Settings) -> list[Cell]:
    """Return the cells that count errors on hard, touching and ordinary pairs, and the cell that measures times."""
    per_octave, n = (12, 400) if settings.quick else (120, 10_000)
    made = [
        Cell(cell_name(kind), count_errors_by_margin, (i, per_octave, settings)) for i, kind in enumerate(ALL_KINDS)
    ]
    made += [Cell(f"count-{work}", count_errors, (work, n, settings)) for work in ("touching", "ordinary")]
    full, quick = (100_000, 20_000, 1000), (30_000, 4000, 200)
    pairs = dict(zip((COMPILED, NUMPY, PYTHON), quick if settings.quick else full, strict=True))
    rounds = 5 if settings.quick else 21
    return [*made, Cell("resolution-times", take_times, (pairs, rounds, settings), timed=True)]


def charts(found: dict[str, Any], settings: Settings) -> list[Chart]:
    """Return the chart of compiled methods, two charts of details about them, and the chart of interpreted methods."""
    summaries = method_summaries(found)
    interpreted = _interpreted_chart(summaries, settings)
    if not is_installed("numba"):
        return [interpreted]
    details = [errors_by_margin.error_rate_chart(found), errors_by_margin.hardness_chart(found)]
    return [main_chart(summaries, settings), *details, interpreted]


def main_chart(rows: Sequence[JsonRow], settings: Settings) -> Chart:
    """Return the chart of the compiled methods, from the rows of `method_summaries`."""
    compiled = [row for row in rows if row["language"] == COMPILED]
    margin = _largest_float64_margin(compiled)
    is_small = 0 < margin * GAP_PER_MARGIN < ATOM_METRES
    gaps = "gaps smaller than an atom" if is_small else f"gaps below {_gap_in_a_kilometre(margin)}"
    title = f"In this sample, at 1 km, float64 SAT was wrong only at {gaps}"
    return _lane_chart("speed-against-accuracy", title, compiled, settings, VECTORISED)


def _interpreted_chart(rows: Sequence[JsonRow], settings: Settings) -> Chart:
    """Return the chart of the methods in NumPy and in Python; its title compares textbook SAT in all languages."""
    interpreted = [
        {**row, "method": f"{row['method']}, {row['language']}"} for row in rows if row["language"] != COMPILED
    ]
    sat = {row["language"]: row for row in rows if row["method"] == "SAT, raw normals"}
    times = [f"{format_time(sat[name]['ns'])} {name}" for name in (COMPILED, NUMPY, PYTHON) if name in sat]
    errors = {(row["relative_margin"], row["wrong"], row["touching_wrong"]) for row in sat.values()}
    alike = "same errors in this sample" if len(errors) == 1 else "not the same errors in this sample"
    return _lane_chart("interpreted", f"SAT: {', '.join(times)}; {alike}", interpreted, settings)


def _largest_float64_margin(rows: Sequence[JsonRow]) -> float:
    """Return the largest relative margin at which SAT in float64 was wrong."""
    float64 = [row for row in rows if row["family"] == "float SAT" and "float32" not in row["method"]]
    return max((row["relative_margin"] for row in float64), default=0.0)


def _gap_in_a_kilometre(margin: float) -> str:
    """Return in words, with its unit, the gap that a relative margin means in a scene of 1 km."""
    metres = margin * GAP_PER_MARGIN
    for size, unit in (1.0, "m"), (1e-3, "mm"), (1e-6, "µm"), (1e-9, "nm"), (1e-12, "pm"):
        if metres >= size:
            return f"{float(f'{metres / size:.2g}'):g} {unit}"
    return f"{metres / 1e-12:.1g} pm"


def _lane_chart(stem: str, title: str, rows: Sequence[JsonRow], settings: Settings, last_sentence: str = "") -> Chart:
    """Return a chart with a lane for each group of unranked methods, and a scale with the ranked ones.

    `last_sentence`: added to the reading.
    """
    lanes = {
        lane: own
        for lane in LANE_ORDER
        if (own := sorted((row for row in rows if row["lane"] == lane), key=lambda row: row["ns"]))
    }
    heights = {lane: 24 + ROW_POINTS * len(own) if lane else SCALE_POINTS for lane, own in lanes.items()}
    head, foot = 66.0, 42.0
    size = WIDTH_POINTS, head + foot + sum(heights.values()) + 10 * (len(heights) - 1)
    limits = min(row["ns"] for row in rows) / 1.6, max(row["ns"] for row in rows) * 14
    counts = rows[0]

    def draw(fig: Figure, theme: Theme) -> None:
        """Draw the headline, and below each other the lanes and the scale of the ranked methods."""
        hard = f"{counts['pairs']:,} pairs, hard in {len(HARD_KINDS)} ways"
        per_factor = f"(at least {counts['least_an_octave']:,} for each factor of 2 of the gap)"
        lines = (
            "Further left is faster. Further down is more accurate. Bars show quartiles of the time.",
            f"{hard} {per_factor}, and {counts['touching']:,} that touch.",
        )
        draw_headline(fig, theme, title, *lines)
        top = size[1] - head
        for lane, own in lanes.items():
            top -= heights[lane]
            share = (WIDTH_POINTS - 100) / WIDTH_POINTS, heights[lane] / size[1]
            ax = add_axes(fig, (86 / WIDTH_POINTS, top / size[1], *share), theme)
            ax.set(xscale="log", xlim=limits)
            is_last = lane == list(lanes)[-1]
            set_time_ticks(ax.xaxis, limits, labels=is_last)
            if is_last:
                ax.set_xlabel("time for a pair of ordinary 4-gons (without preparing the shapes)")
            if lane:
                _draw_lane(ax, theme, lane, own)
            else:
                _draw_margins(ax, theme, own)
            top -= 10

    reading = f"{_reading(rows)} {last_sentence}".strip()
    return Chart(stem, title, size, draw, list(rows), reading, timing_warning(rows, settings))


def _draw_lane(ax: Axes, theme: Theme, lane: str, rows: Sequence[JsonRow]) -> None:
    """Draw the methods of a lane below each other; their order is that of their times and says nothing of accuracy."""
    ax.set(yticks=[], ylim=(24 + ROW_POINTS * len(rows), 0))
    ax.spines["left"].set_visible(False)
    style: dict[str, Any] = {"textcoords": "offset points", "fontsize": TEXT_POINTS, "annotation_clip": False}
    beside: dict[str, Any] = {"xycoords": "axes fraction", "ha": "right", "va": "center"}
    ax.annotate(LANE_LABELS[lane], (0, 0.5), (-8, 0), color=theme.roles["ink"], **style, **beside)
    for i, row in enumerate(rows):
        y, shade = 12 + ROW_POINTS * (i + 0.5), family_colour(theme, row["family"])
        ax.plot([row["ns_low"], row["ns_high"]], [y, y], color=shade, lw=1)
        ax.plot([row["ns"]], [y], "D" if lane == EXACT_BY_CONSTRUCTION else "o", color=shade, ms=6)
        # a label without space to the right of its point is written to the left of it
        if log2(row["ns"]) < sum(map(log2, ax.get_xlim())) / 2:
            x, offset, side = row["ns_high"], 6, "left"
        else:
            x, offset, side = row["ns_low"], -6, "right"
        letters: dict[str, Any] = {"ha": side, "va": "center_baseline", "parse_math": False}
        letters["color"] = family_colour(theme, row["family"], text=True)
        ax.annotate(_method_with_share(row), (x, y), (offset, 0), **letters, **style)


def _method_with_share(row: JsonRow) -> str:
    """Return a method's name, with its share of wrong answers on the pairs that matter in its lane."""
    wrong, total, pairs = {
        WRONG_AT_ANY_DISTANCE: (row["ordinary_wrong"], row["ordinary"], "ordinary pairs"),
        FIXED_TOLERANCE: (row["wrong"], row["pairs"], "hard pairs"),
    }.get(row["lane"], (row["extreme_wrong"], row["extreme"], "extreme sizes"))
    if not wrong:
        return str(row["method"])
    share = f"{wrong / total:.0%}" if wrong >= 0.01 * total else "under 1%"
    return f"{row['method']}: {share} of {pairs} wrong"


def _draw_margins(ax: Axes, theme: Theme, rows: Sequence[JsonRow]) -> None:
    """Draw time against the largest margin that was answered wrongly, in metres for a scene of 1 km."""
    ax.set(ylim=(-9, max(MARGIN_OCTAVES) + 1))
    ax.set_yticks([log2(metres / GAP_PER_MARGIN) for metres in TICK_METRES.values()], list(TICK_METRES))
    ax.set_ylabel("wrong up to this gap\nin a scene of 1 km", fontsize=TEXT_POINTS)
    atom, guide = log2(ATOM_METRES / GAP_PER_MARGIN), theme.roles["guide"]
    ax.axhline(atom, color=guide, lw=0.8, ls=(0, (1, 2.2)))
    style: dict[str, Any] = {"ha": "right", "va": "bottom", "color": guide, "fontsize": TEXT_POINTS}
    place: dict[str, Any] = {"xycoords": ax.get_yaxis_transform(), "textcoords": "offset points"}
    ax.annotate("size of an atom", (1, atom), (0, 2), **place, **style)
    labels = []
    for row in rows:
        margin, shade = row["relative_margin"], family_colour(theme, row["family"])
        y = log2(margin) if margin else -4.0
        ax.plot([row["ns_low"], row["ns_high"]], [y, y], color=shade, lw=1)
        ax.plot([row["ns"]], [y], "o", color=shade, ms=6.5)
        labels.append((row["ns"], y, row["method"], family_colour(theme, row["family"], text=True)))
    label_points(ax, labels, theme)


def _reading(rows: Sequence[JsonRow]) -> str:
    """Return the chart in words: every method with its errors and its time, lane by lane."""
    counts = rows[0]
    by_lane = {lane: [row for row in rows if row["lane"] == lane] for lane in LANE_ORDER}
    text = f"{len(rows)} methods on {counts['pairs']:,} pairs made hard in {len(HARD_KINDS)} ways (at least "
    text += (
        f"{counts['least_an_octave']:,} for each factor of 2 of the relative margin) and {counts['touching']:,} that "
    )
    text += "touch exactly. The relative margin is how far the deciding number is from 0, in rounding errors. "
    text += "The margins that follow are the largest of this sample, and other pairs can be wrong at larger ones. "
    for row in sorted(by_lane[""], key=lambda row: -row["relative_margin"]):
        gap = f"{_gap_in_a_kilometre(row['relative_margin'])} in a kilometre"
        touches = f", and at {row['touching_wrong']:,} of the touches" if row["touching_wrong"] else ""
        text += f"{row['method']}: wrong up to a relative margin of {row['relative_margin']:.2g} ({gap}){touches}; "
        text += f"{format_time(row['ns'])}. "
    if by_lane[FIXED_TOLERANCE]:
        text += "A fixed tolerance is a length, so its relative margin changes with the scene. "
    for row in by_lane[FIXED_TOLERANCE]:
        touches = f" and at {row['touching_wrong']:,} of the touches" if row["touching_wrong"] else ""
        text += f"{row['method']}: wrong on {row['wrong']:,} of the hard pairs{touches}; {format_time(row['ns'])}. "
    for lane in (WRONG_AT_ANY_DISTANCE, NONE_WRONG, EXACT_BY_CONSTRUCTION):
        names = [f"{row['method']} ({format_time(row['ns'])})" for row in by_lane[lane]]
        text += f"{lane[0].upper()}{lane[1:]}: {', '.join(names)}. " if names else ""
    text += f"The chart leaves out {counts['extreme']:,} pairs of extreme sizes (2^400 and more, either way), "
    text += "where products leave the range of float64. Wrong on those: "
    unranked = [row for row in rows if row["lane"] in (NONE_WRONG, EXACT_BY_CONSTRUCTION)]
    return text + "; ".join(f"{row['method']}: {row['extreme_wrong']:,}" for row in unranked) + "."
