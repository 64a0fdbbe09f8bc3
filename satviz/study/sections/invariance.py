"""Changes that must change nothing: how often a method contradicts itself, which takes no oracle to see.

The pairs are hard ones on a grid where every change is exact: what a method answers differently it
answers wrongly once.
"""

from collections.abc import Callable
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from ...pictures import Theme
from ..harness.cells import Cell, Settings
from ..harness.chart import Chart, add_axes, draw_headline, draw_table, family_colour, wilson_interval
from ..methods import COMPILED, PYTHON, all_methods, answers_by_method
from ..workloads.generators import Rings
from ..workloads.hard_pairs import Pairs, pairs_on_a_grid

Row = dict[str, Any]
MAX_MARGIN = 8.0  # gamma
EXACT_MOVE = np.array([37.0, -50.0])


def _mirrored(rings: Rings) -> Rings:
    return np.asarray(rings * np.array([-1.0, 1.0]))[:, ::-1].copy()  # still counter-clockwise


def _turned_by_90_degrees(rings: Rings) -> Rings:
    return np.stack([-rings[..., 1], rings[..., 0]], axis=2)


CHANGES: dict[str, Callable[[Rings, Rings], Pairs]] = {
    "A and B swapped": lambda a, b: (b, a),
    "another first corner": lambda a, b: (np.roll(a, 1, axis=1), np.roll(b, 2, axis=1)),
    "mirrored": lambda a, b: (_mirrored(a), _mirrored(b)),
    "turned by 90 degrees": lambda a, b: (_turned_by_90_degrees(a), _turned_by_90_degrees(b)),
    "moved": lambda a, b: (a + EXACT_MOVE, b + EXACT_MOVE),
}
COMPARED_METHODS = (
    (COMPILED, "satviz"), (COMPILED, "turns, adaptive"), (COMPILED, "turns, expansions"), (COMPILED, "shapely"),
    (COMPILED, "turns, floats"), (COMPILED, "GJK"), (PYTHON, "pymunk"), (COMPILED, "satviz, no filter"),
    (COMPILED, "SAT, raw normals"), (COMPILED, "SAT, unit normals"), (COMPILED, "SAT, float32"),
)  # fmt: skip


def cells(settings: Settings) -> list[Cell]:
    """One that asks every method before and after."""
    return [Cell("changes", count_changed_answers, (400 if settings.quick else 20_000, settings))]


def count_changed_answers(n: int, settings: Settings) -> list[Row]:
    """How many answers of each method are others after each change."""
    a, b = pairs_on_a_grid(settings.rng("changes"), n, MAX_MARGIN)
    mine = [m for m in all_methods() if (m.language, m.name) in COMPARED_METHODS]
    before = {(m.language, m.name): said > 0 for m, said in answers_by_method(mine, a, b)}
    rows = []
    for name, change in CHANGES.items():
        for m, said in answers_by_method(mine, *change(a, b)):
            other = int(((said > 0) != before[m.language, m.name]).sum())
            rows.append({"change": name, "method": m.name, "family": m.family, "changed": other, "pairs": len(a)})
    return rows


def charts(found: dict[str, Any], settings: Settings) -> list[Chart]:
    """A row a method, a column a change."""
    rows: list[Row] = found["changes"]
    for row in rows:
        row["low"], row["high"] = wilson_interval(row["changed"], row["pairs"])
    of = {(row["method"], row["change"]): row for row in rows}
    names = [name for _, name in COMPARED_METHODS if (name, next(iter(CHANGES))) in of]
    never = [name for name in names if not any(of[name, change]["changed"] for change in CHANGES)]
    share = {change: max(of[name, change]["changed"] for name in names) / rows[0]["pairs"] for change in CHANGES}
    most = max(share, key=lambda change: share[change])
    rest = max(value for change, value in share.items() if change != most)
    upto = f"up to {share[most]:.0%} of a float method's answers, others {rest:.1%}"
    title = f"Of harmless changes “{most}” alters most: {upto}"
    size = 820.0, 104 + 27.0 * len(names)

    def draw(fig: Figure, theme: Theme) -> None:
        n = rows[0]["pairs"]
        under = f"answers that change though every change is exact; {n:,} pairs of gamma below {MAX_MARGIN:g}; darker is more"
        draw_headline(fig, theme, title, under)
        ax = add_axes(fig, (0.2, 12 / size[1], 0.785, 27.0 * len(names) / size[1]), theme)

        def cell(y: int, x: int) -> tuple[str, str, float]:
            row = of[names[y], list(CHANGES)[x]]
            share = row["changed"] / n
            text = f"{share:.1%}" if share >= 0.0005 else "under 0.1%"
            return text if share else "none", family_colour(theme, row["family"]), share

        draw_table(ax, theme, list(CHANGES), names, cell)

    text = f"Of {rows[0]['pairs']:,} pairs of gamma below {MAX_MARGIN:g}: no answer changed of {', '.join(never) or 'none'}. "
    for name in (name for name in names if name not in never):
        each = [f"{of[name, change]['changed']:,} ({change})" for change in CHANGES]
        text += f"{name}: {', '.join(each)}. "
    return [Chart("changes", title, size, draw, rows, text.strip())]
