"""The share of wrong answers by relative margin, and the kinds of hardness apart: details of `error_counts`."""

from math import log2
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from ...pictures import Theme
from ..harness.cells import JsonRow
from ..harness.chart import (
    TEXT_POINTS,
    Chart,
    add_axes,
    draw_headline,
    draw_table,
    family_colour,
    label_ends,
    wilson_interval,
)
from ..methods import COMPILED
from ..workloads.hard_pairs import EXTREME_KIND, HARD_KINDS, MARGIN_OCTAVES
from .error_counts import ALL_KINDS, cell_name, method_key

# by method: the name of its curve, and where the name is written (octave, share)
CURVE_LABELS = {
    "AABB": ("AABB", 31, 0.66),
    "SAT, float32": ("SAT, float32", 29.2, 0.25),
    "SAT, 1e-9 counts as a hit": ("gaps of 1e-9 count as hits", 8.2, 0.68),
    "SAT, 1e-9 counts as a miss": ("overlaps of 1e-9 count as misses", 8.2, 0.3),
    "SAT, unit normals": ("SAT, unit normals", 1.4, 0.24),
    "SAT, raw normals": ("SAT, raw normals", 1.4, 0.15),
    "orientation, floats": ("orientation, floats", 1.4, 0.08),
    "satviz": ("satviz: none wrong", 8.2, 0.03),
}
DASHED_CURVES = "SAT, 1e-9 counts as a miss", "SAT, raw normals"
TABLE_METHODS = (
    "satviz", "orientation, adaptive", "orientation, floats", "GJK", "shapely", "satviz, no filter", "SAT, raw normals",
    "SAT, unit normals", "SAT, 1e-9 counts as a hit", "SAT, float32",
)  # fmt: skip


def error_rate_chart(found: dict[str, Any]) -> Chart:
    """Return the chart of the share of wrong answers by relative margin, with exactly touching pairs beside it."""
    rows = _error_rates(found)
    fewest = min(row["pairs"] for row in rows[:-1])
    at_the_end = {row["method"] for row in rows if row["octave"] == MARGIN_OCTAVES[-1] and row["wrong"]}
    title = "In this sample wrong answers end at some relative margin"
    title += f", except for {', '.join(name for name in CURVE_LABELS if name in at_the_end)}" if at_the_end else ""
    rows_of = {name: own for name in CURVE_LABELS if (own := [row for row in rows if row["method"] == name])}

    def draw(fig: Figure, theme: Theme) -> None:
        """Draw the error rates at exact touches, and beside them those by relative margin."""
        line = f"Share of wrong answers; at least {fewest:,} pairs for each factor of 2. Bands show 95 % intervals."
        draw_headline(fig, theme, title, line)
        touch_ax = add_axes(fig, (0.07, 0.15, 0.06, 0.68), theme)
        ax = add_axes(fig, (0.4, 0.15, 0.585, 0.68), theme)
        ends = []
        for name, own in rows_of.items():
            label, x, y = CURVE_LABELS[name]
            touching, curve = own[0], own[1:]
            shade = family_colour(theme, touching["family"])
            ink = family_colour(theme, touching["family"], text=True)
            if name != "satviz":
                last = max((k for k, row in enumerate(curve) if row["wrong"]), default=-1)
                curve = curve[: last + 2]
            xs = [row["octave"] + 0.5 for row in curve]
            if name != "satviz":
                lows, highs = ([row[key] for row in curve] for key in ("low", "high"))
                ax.fill_between(xs, lows, highs, color=shade, alpha=0.15, lw=0)
            style = "--" if name in DASHED_CURVES else "-"
            ax.plot(xs, [row["share"] for row in curve], color=shade, ls=style, lw=1.8)
            ax.text(x, y, label, color=ink, fontsize=TEXT_POINTS, parse_math=False)
            touch_ax.plot([0, 0], [touching["low"], touching["high"]], color=shade, lw=1)
            touch_ax.plot([0], [touching["share"]], "o", color=shade, ms=6, clip_on=False)
            ends.append((0, touching["share"], label.split(":")[0], ink))
        for one in (touch_ax, ax):
            one.set(ylim=(-0.03, 1.03))
            one.set_yticks([0, 0.25, 0.5, 0.75, 1], ["0", "25 %", "50 %", "75 %", "100 %"])
        ax.set_yticklabels([])
        touch_ax.set(xlim=(-1, 1), xticks=[])
        touch_ax.set_xlabel("touching exactly", labelpad=12)
        none = [text for _, share, text, _ in ends if not share]
        zeros = [f"0 {', '.join(none[i : i + 2])}" for i in range(0, len(none), 2)]
        ends = [(x, y, f"{y:.0%} {text}", ink) for x, y, text, ink in ends if y]
        label_ends(touch_ax, [*ends, *((0, 0.0, words, theme.roles["guide"]) for words in zeros)], gap=15)
        ax.set(
            xlim=(-2.5, max(MARGIN_OCTAVES) + 1),
            xlabel="relative margin (how far the deciding number is from 0, in rounding errors)",
        )
        ax.set_xticks(range(0, 36, 5), [f"$2^{{{k}}}$" for k in range(0, 36, 5)])

    text = "The wrong answers of this sample, which is no bound for other pairs. "
    for name, (touching, *curve) in rows_of.items():
        wrong = [row["octave"] for row in curve if row["wrong"]]
        upto = f"wrong up to a relative margin of 2^{max(wrong) + 1}" if wrong else "none wrong"
        text += f"{name}: {upto}, {curve[0]['share']:.0%} in the hardest octave, "
        text += f"and wrong at {touching['wrong']:,} of {touching['pairs']:,} touches. "
    return Chart("wrong-by-margin", title, (860.0, 400.0), draw, rows, text.strip())


def _error_rates(found: dict[str, Any]) -> list[JsonRow]:
    """Return for each charted method a row for touching pairs, then a row for each octave of the margin."""
    touching = {method_key(row): row for row in found["count-touching"]}
    rows: list[JsonRow] = []
    for name in CURVE_LABELS:
        key = (COMPILED, name)
        own = [row for kind in HARD_KINDS for row in found[cell_name(kind)] if method_key(row) == key]
        if not own:
            continue
        pairs, wrong = (
            np.sum([row[column] for row in own], axis=0).tolist() for column in ("pairs_by_octave", "wrong_by_octave")
        )
        octaves = [("touching", touching[key]["pairs"], touching[key]["wrong"])]
        for octave, n, bad in [*octaves, *zip(MARGIN_OCTAVES, pairs, wrong, strict=True)]:
            low, high = wilson_interval(bad, n)
            row = {"method": name, "family": own[0]["family"], "octave": octave, "pairs": n, "wrong": bad}
            rows.append({**row, "share": bad / max(n, 1), "low": low, "high": high})
    return rows


def hardness_chart(found: dict[str, Any]) -> Chart:
    """Return a chart with a table: by kind of hardness and method the largest margin that was wrong."""
    counts = {
        (row["kind"], row["method"]): row
        for kind in ALL_KINDS
        for row in found[cell_name(kind)]
        if row["language"] == COMPILED
    }
    names = [name for name in TABLE_METHODS if (EXTREME_KIND.name, name) in counts]
    columns = "family", "relative_margin", "wrong", "pairs"
    rows: list[JsonRow] = [
        {"kind": kind.name, "method": name, **{column: counts[kind.name, name][column] for column in columns}}
        for kind in ALL_KINDS
        for name in names
    ]
    usual = [row for row in rows if row["kind"] != EXTREME_KIND.name]
    float64 = [row for row in usual if row["family"] == "float SAT" and "float32" not in row["method"]]
    largest = max((row["relative_margin"] for row in float64), default=1.0)
    below = 2.0 ** int(np.ceil(log2(largest)))
    title = f"In this sample float64 SAT was wrong only below a relative margin of {below:g}, except at extreme sizes"
    wide, tall = 78.0 * len(names), 30.0 * len(ALL_KINDS)
    size = 170 + wide, 132 + tall

    def draw(fig: Figure, theme: Theme) -> None:
        """Draw the headline and the table, a row for each kind and a column for each method."""
        line = "The largest relative margin at which a method was wrong, by kind of hardness. Darker is worse."
        draw_headline(fig, theme, title, line)
        ax = add_axes(fig, (160 / size[0], 16 / size[1], wide / size[0], tall / size[1]), theme)

        def entry(y: int, x: int) -> tuple[str, str, float]:
            """Return the text, the colour and its strength (0 to 1) for the table's field in row y and column x."""
            row = counts[ALL_KINDS[y].name, names[x]]
            shade, margin = family_colour(theme, row["family"]), row["relative_margin"]
            if not margin:
                return "none", shade, 0.0
            octave = log2(margin)  # from -6, pale, to 36, dark
            return f"$2^{{{int(np.ceil(octave))}}}$", shade, max(0.0, min(1.0, (octave + 6) / 42))

        labels = [name.replace(", ", ",\n").replace("counts as a", "\ncounts as a") for name in names]
        draw_table(ax, theme, labels, [kind.name for kind in ALL_KINDS], entry)

    worst = {name: max(row["relative_margin"] for row in usual if row["method"] == name) for name in names}
    each = ", ".join(f"{name} {margin:.2g}" if margin else f"{name} none" for name, margin in worst.items())
    extreme = [row["method"] for row in rows if row["kind"] == EXTREME_KIND.name and not row["wrong"]]
    text = (
        f"The largest relative margin found wrong in this sample of {len(HARD_KINDS)} kinds of hardness, which is no "
        f"bound for other pairs: {each}. Extreme sizes (2^400 and more, either way) do not follow the relative margin: "
        "products of their coordinates leave the range of floats, and more is lost than some roundings. "
        f"Methods with none wrong there: {', '.join(extreme) or 'none'}. A fixed tolerance does not follow it either: "
        "far from the origin the same 1e-9 is a smaller relative margin. float32 leaves its range much sooner. All "
        "shapes of this sample fit float32; where its grid is coarser than a shape, no relative margin can tell."
    )
    return Chart("kinds-of-hardness", title, size, draw, rows, text)
