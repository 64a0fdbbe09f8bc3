"""Behind the resolution: the share of wrong answers by octave of gamma, and each kind of hardness apart."""

from math import log2
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from ...pictures import Theme
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
from .error_counts import ALL_KINDS, Row, cell_name, method_key

# the curves: how each is called, and where its name stands (octave, share)
CURVE_LABELS = {
    "AABB": ("AABB", 31, 0.66),
    "SAT, float32": ("SAT, float32", 29.2, 0.25),
    "SAT, 1e-9 counts as a hit": ("gaps of 1e-9 count as hits", 8.2, 0.68),
    "SAT, 1e-9 counts as a miss": ("overlaps of 1e-9 count as misses", 8.2, 0.3),
    "SAT, unit normals": ("SAT, unit normals", 1.4, 0.24),
    "SAT, raw normals": ("SAT, raw normals", 1.4, 0.15),
    "turns, floats": ("turns, floats", 1.4, 0.08),
    "satviz": ("satviz: none wrong", 8.2, 0.03),
}
DASHED_CURVES = "SAT, 1e-9 counts as a miss", "SAT, raw normals"
TABLE_METHODS = (
    "satviz", "turns, adaptive", "turns, floats", "GJK", "shapely", "satviz, no filter", "SAT, raw normals",
    "SAT, unit normals", "SAT, 1e-9 counts as a hit", "SAT, float32",
)  # fmt: skip


def error_rate_chart(found: dict[str, Any]) -> Chart:
    """The share of wrong answers by octave of gamma, exact touching in a lane of its own."""
    touches = {method_key(row): row for row in found["count-touching"]}
    made: list[Row] = []
    for name in CURVE_LABELS:
        key = (COMPILED, name)
        mine = [row for kind in HARD_KINDS for row in found[cell_name(kind)] if method_key(row) == key]
        if not mine:
            continue
        pairs, bad = (np.sum([row[k] for row in mine], axis=0).tolist() for k in ("pairs_by_octave", "wrong_by_octave"))
        facts = {"method": name, "family": mine[0]["family"]}
        made.append({**facts, "octave": "touching", "pairs": touches[key]["pairs"], "wrong": touches[key]["wrong"]})
        made += [
            {**facts, "octave": k, "pairs": p, "wrong": w} for k, p, w in zip(MARGIN_OCTAVES, pairs, bad, strict=True)
        ]
    for row in made:
        row["share"] = row["wrong"] / max(row["pairs"], 1)
        row["low"], row["high"] = wilson_interval(row["wrong"], row["pairs"])
    least = min(row["pairs"] for row in made[:-1])
    top = {row["method"] for row in made if row["octave"] == MARGIN_OCTAVES[-1] and row["wrong"]}
    title = "In this sample wrong answers end at some gamma"
    title += f", except for {', '.join(name for name in CURVE_LABELS if name in top)}" if top else ""

    def draw(fig: Figure, theme: Theme) -> None:
        under = f"share of wrong answers by hardness, {least:,} pairs or more an octave; bands: 95 % intervals"
        draw_headline(fig, theme, title, under)
        touch = add_axes(fig, (0.07, 0.15, 0.06, 0.68), theme)
        ax = add_axes(fig, (0.4, 0.15, 0.585, 0.68), theme)
        ends = []
        for name, (words, x, y) in CURVE_LABELS.items():
            mine = [row for row in made if row["method"] == name]
            if not mine:
                continue
            shade, ink = family_colour(theme, mine[0]["family"]), family_colour(theme, mine[0]["family"], text=True)
            style = "--" if name in DASHED_CURVES else "-"
            last = max((k for k, row in enumerate(mine) if k and row["wrong"]), default=0)
            curve = mine[1:] if name == "satviz" else mine[1 : last + 2]
            xs = [row["octave"] + 0.5 for row in curve]
            if name != "satviz":
                lows, highs = ([row[key] for row in curve] for key in ("low", "high"))
                ax.fill_between(xs, lows, highs, color=shade, alpha=0.15, lw=0)
            ax.plot(xs, [row["share"] for row in curve], color=shade, ls=style, lw=1.8)
            ax.text(x, y, words, color=ink, fontsize=TEXT_POINTS, parse_math=False)
            touch.plot([0, 0], [mine[0]["low"], mine[0]["high"]], color=shade, lw=1)
            touch.plot([0], [mine[0]["share"]], "o", color=shade, ms=6, clip_on=False)
            ends.append((0, mine[0]["share"], words.split(":")[0], ink))
        for each in (touch, ax):
            each.set(ylim=(-0.03, 1.03))
            each.set_yticks([0, 0.25, 0.5, 0.75, 1], ["0", "25 %", "50 %", "75 %", "100 %"])
        ax.set_yticklabels([])
        touch.set(xlim=(-1, 1), xticks=[])
        touch.set_xlabel("touching exactly", labelpad=12)
        none = [text for _, share, text, _ in ends if not share]
        zeros = [f"0 {', '.join(none[i : i + 2])}" for i in range(0, len(none), 2)]
        ends = [(x, y, f"{y:.0%} {text}", ink) for x, y, text, ink in ends if y]
        label_ends(touch, [*ends, *((0, 0.0, words, theme.roles["guide"]) for words in zeros)], gap=15)
        ax.set(xlim=(-2.5, max(MARGIN_OCTAVES) + 1), xlabel="gamma: the turn that decides, in roundings")
        ax.set_xticks(range(0, 36, 5), [f"$2^{{{k}}}$" for k in range(0, 36, 5)])

    text = ""
    for name in CURVE_LABELS:
        mine = [row for row in made if row["method"] == name]
        if mine:
            last = [row["octave"] for row in mine[1:] if row["wrong"]]
            upto = f"wrong up to gamma 2^{max(last) + 1}" if last else "none wrong"
            text += f"{name}: {upto}, {mine[1]['share']:.0%} in the hardest octave, "
            text += f"and at {mine[0]['wrong']:,} of {mine[0]['pairs']:,} touches. "
    text = f"In this sample, which is no bound for other pairs: {text}"
    return Chart("wrong-by-gamma", title, (860.0, 400.0), draw, made, text.strip())


def hardness_chart(found: dict[str, Any]) -> Chart:
    """A row a kind and a column a method: the largest gamma at which it was wrong."""
    every = {
        (row["kind"], row["method"]): row
        for kind in ALL_KINDS
        for row in found[cell_name(kind)]
        if row["language"] == COMPILED
    }
    names = [name for name in TABLE_METHODS if (EXTREME_KIND.name, name) in every]
    made = [
        {
            "kind": kind.name,
            "method": name,
            **{k: every[kind.name, name][k] for k in ("family", "gamma", "wrong", "pairs")},
        }
        for kind in ALL_KINDS
        for name in names
    ]
    plain = [
        row["gamma"]
        for row in made
        if row["family"] == "float SAT" and row["kind"] != EXTREME_KIND.name and "float32" not in row["method"]
    ]
    most = 2.0 ** int(np.ceil(log2(max(plain, default=1.0))))
    title = f"In this sample float64 SAT was wrong only below gamma {most:g}; extreme sizes apart"
    wide = 78.0
    size = 170 + wide * len(names), 132 + 30.0 * len(ALL_KINDS)

    def draw(fig: Figure, theme: Theme) -> None:
        draw_headline(
            fig,
            theme,
            title,
            "the largest gamma of this sample at which a method was wrong, by kind of hardness; darker is worse",
        )
        ax = add_axes(
            fig, (160 / size[0], 16 / size[1], wide * len(names) / size[0], 30.0 * len(ALL_KINDS) / size[1]), theme
        )

        def cell(y: int, x: int) -> tuple[str, str, float]:
            row = every[ALL_KINDS[y].name, names[x]]
            much = (log2(row["gamma"]) + 6) / 42 if row["gamma"] else 0.0
            return (
                _power_of_two_label(row["gamma"]) if row["gamma"] else "none",
                family_colour(theme, row["family"]),
                max(0.0, min(1.0, much)),
            )

        labels = [name.replace(", ", ",\n").replace("counts as a", "\ncounts as a") for name in names]
        draw_table(ax, theme, labels, [kind.name for kind in ALL_KINDS], cell)

    worst: list[str] = []
    for name in names:
        collapse = [row["gamma"] for row in made if row["method"] == name and row["kind"] != EXTREME_KIND.name]
        worst.append(f"{name} {max(collapse):.2g}" if max(collapse) else f"{name} none")
    extreme = [row["method"] for row in made if row["kind"] == EXTREME_KIND.name and not row["wrong"]]
    text = (
        f"The largest gamma found wrong in this sample of {len(HARD_KINDS)} kinds of hardness (no bound for other pairs): "
        f"{', '.join(worst)}. Extreme sizes (2^400 and more, either way) do not follow gamma: products of "
        "coordinates leave the range of floats there, so what is lost is everything and not some roundings; none wrong "
        f"there: {', '.join(extreme) or 'no method'}. A fixed tolerance is no number of roundings either: far from the "
        "origin the same 1e-9 is a smaller gamma. float32 leaves its range much sooner, and all shapes of this sample "
        "are ones that it can hold: where its grid is coarser than a shape, no gamma can tell."
    )
    return Chart("kinds-of-hardness", title, size, draw, made, text)


def _power_of_two_label(gamma: float) -> str:
    """A power of two that is no smaller."""
    return f"$2^{{{int(np.ceil(log2(gamma)))}}}$"
