"""Changes that must not change an answer: how often a method contradicts itself, which is seen without an oracle.

The pairs are hard ones with coordinates on a grid, where every change is exact.  Where two answers of a method differ,
one of them is wrong.
"""

from collections.abc import Callable
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from ...pictures import Theme
from ..harness.cells import Cell, JsonRow, Settings
from ..harness.chart import Chart, add_axes, draw_headline, draw_table, family_colour, wilson_interval
from ..methods import COMPILED, PYTHON, all_methods, answers_by_method
from ..workloads.generators import Rings, quarter_turn
from ..workloads.hard_pairs import Pairs, pairs_on_a_grid

MAX_MARGIN = 8.0  # relative margin of the hardest pairs
EXACT_MOVE = np.array([37.0, -50.0])  # whole numbers below 64, by which pairs on the grid move without rounding


def _mirrored(rings: Rings) -> Rings:
    """Return the shapes mirrored at the y axis, their corners in reverse order to stay counter-clockwise."""
    return np.asarray(rings * np.array([-1.0, 1.0]))[:, ::-1].copy()


CHANGES: dict[str, Callable[[Rings, Rings], Pairs]] = {
    "A and B swapped": lambda a, b: (b, a),
    "another first corner": lambda a, b: (np.roll(a, 1, axis=1), np.roll(b, 2, axis=1)),
    "mirrored": lambda a, b: (_mirrored(a), _mirrored(b)),
    "turned by 90 degrees": lambda a, b: (quarter_turn(a), quarter_turn(b)),
    "moved": lambda a, b: (a + EXACT_MOVE, b + EXACT_MOVE),
}
COMPARED_METHODS = (
    (COMPILED, "satviz"), (COMPILED, "orientation, adaptive"), (COMPILED, "orientation, expansions"),
    (COMPILED, "shapely"), (COMPILED, "orientation, floats"), (COMPILED, "GJK"), (PYTHON, "pymunk"),
    (COMPILED, "satviz, no filter"), (COMPILED, "SAT, raw normals"), (COMPILED, "SAT, unit normals"),
    (COMPILED, "SAT, float32"),
)  # fmt: skip


def cells(settings: Settings) -> list[Cell]:
    """Return one cell, which compares the answers of every method before and after each change."""
    return [Cell("changes", count_changed_answers, (400 if settings.quick else 20_000, settings))]


def count_changed_answers(n: int, settings: Settings) -> list[JsonRow]:
    """Return by transformation and method how many of the method's answers change, on about n hard pairs."""
    a, b = pairs_on_a_grid(settings.rng("changes"), n, MAX_MARGIN)
    methods = [m for m in all_methods() if (m.language, m.name) in COMPARED_METHODS]
    before = {(m.language, m.name): answers > 0 for m, answers in answers_by_method(methods, a, b)}
    rows = []
    for name, change in CHANGES.items():
        for m, answers in answers_by_method(methods, *change(a, b)):
            changed = int(((answers > 0) != before[m.language, m.name]).sum())
            rows.append({"change": name, "method": m.name, "family": m.family, "changed": changed, "pairs": len(a)})
    return rows


def charts(found: dict[str, Any], settings: Settings) -> list[Chart]:
    """Return one chart, a table: methods as rows, transformations as columns, the share of changed answers."""
    rows: list[JsonRow] = found["changes"]
    for row in rows:
        row["low"], row["high"] = wilson_interval(row["changed"], row["pairs"])
    changed = {(row["method"], row["change"]): row["changed"] for row in rows}
    families, pairs = {row["method"]: row["family"] for row in rows}, rows[0]["pairs"]
    names = [name for _, name in COMPARED_METHODS if name in families]
    unchanged = [name for name in names if not any(changed[name, change] for change in CHANGES)]
    share = {change: max(changed[name, change] for name in names) / pairs for change in CHANGES}
    worst = max(share, key=lambda change: share[change])
    others = max(value for change, value in share.items() if change != worst)
    title = f"The change “{worst}” alters up to {share[worst]:.0%} of a float method's answers, the others {others:.1%}"
    tall = 27.0 * len(names)
    size = 820.0, 104 + tall

    def draw(fig: Figure, theme: Theme) -> None:
        """Draw the headline and the table, a row for each method and a column for each transformation."""
        line = f"Answers that change, though every change is exact: {pairs:,} pairs with a relative margin below "
        draw_headline(fig, theme, title, f"{line}{MAX_MARGIN:g}. Darker is more.")
        ax = add_axes(fig, (0.2, 12 / size[1], 0.785, tall / size[1]), theme)

        def entry(y: int, x: int) -> tuple[str, str, float]:
            """Return the text, the colour and its strength (0 to 1) for the table's field in row y and column x."""
            share = changed[names[y], list(CHANGES)[x]] / pairs
            text = f"{share:.1%}" if share >= 0.0005 else "under 0.1%"
            return text if share else "none", family_colour(theme, families[names[y]]), share

        draw_table(ax, theme, list(CHANGES), names, entry)

    text = f"{pairs:,} pairs with a relative margin below {MAX_MARGIN:g}. "
    text += f"Methods without a changed answer: {', '.join(unchanged) or 'none'}. "
    for name in (name for name in names if name not in unchanged):
        text += f"{name}: {', '.join(f'{changed[name, change]:,} ({change})' for change in CHANGES)}. "
    return [Chart("changes", title, size, draw, rows, text.strip())]
