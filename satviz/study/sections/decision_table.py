"""The decision table: what you have, and the least model that does.

Question: which model is enough for a scene?  Workload: small scenes of the kinds that people have.  Methods: the
candidates of `satviz.advice`, from bounding circles to the exact filter.  The model of a scene is the smallest one that
`satviz.advise` proves right for every pair, and its time is the median of `speed_against_accuracy`.  The claim is
refuted by a pair of a scene that its model answers wrongly, or by a smaller model that is proven.
"""

from collections.abc import Sequence
from textwrap import wrap
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from ... import batch
from ...advice.advising_batches import recommend_batch
from ...advice.records import best, model_for_any_position
from ...pictures import Theme
from ...render.chart import TEXT_LETTER, TEXT_LINE, TEXT_POINTS, WIDTH, Chart, JsonRow, add_text, share_of
from ..harness.cells import Cell, Settings
from ..harness.chart import format_time
from ..harness.timings import timing_warning
from ..workloads.adversary import beside, kilometre_shapes
from ..workloads.generators import circles, tiles, turn_rings, turned_boxes
from .speed_against_accuracy import in_metres, summaries

TURN = np.array([[0.955336489125606, 0.2955202066613396]])  # a unit vector, 0.3 radians from the x axis
# the method whose time is that of a kind of model; circles are compared as bounding circles are
MEASURED = {"circles": "bounding circles", "AABB": "AABB", "float32": "SAT, float32", "float64": "SAT, raw normals",
            "exact": "satviz"}  # fmt: skip
COLUMNS = (
    ("what you have", 6.0, 136.0),
    ("least model", 146.0, 106.0),
    ("a pair", 258.0, 50.0),
    ("wrong for gaps", 310.0, 78.0),
)  # title, left and width in points


def cells(settings: Settings) -> list[Cell]:
    """Return one cell, which asks for the least model of every scene."""
    return [Cell("decision", recommend, (shapes_in_a_scene(settings), settings))]


def shapes_in_a_scene(settings: Settings) -> int:
    """Return about how many shapes each scene has."""
    return 60 if settings.quick else 400


def recommend(n: int, settings: Settings) -> list[JsonRow]:
    """Return a row for each scene of about n shapes, and one for moving shapes, with the least model proven right."""
    rng = settings.rng("decision")
    upright = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    wide = 6 * n**0.5
    km_a, km_b = kilometre_shapes(rng, n)
    touch = np.concatenate([km_a, beside(rng, km_a, km_b, np.full(n, 1e-6))])
    grid = tiles(int(n**0.5))
    scenes: dict[str, batch.Shapes] = {
        "upright boxes, tiles of a map: touching or not": batch.Polygons(grid),
        "upright boxes of any size": batch.Polygons(
            upright * rng.uniform(1, 10, (n, 1, 2)) + rng.uniform(0, wide, (n, 1, 2))
        ),
        "coins that lie as chance wants": batch.Circles(rng.uniform(0, wide, (n, 2)), circles(rng, n, 0.0)[1]),
        "turned boxes that lie as chance wants": batch.Polygons(
            turned_boxes(rng, n, 0.0) + rng.uniform(0, wide, (n, 1, 2))
        ),
        "4-gons in 1 km with gaps of 1 µm": batch.Polygons(touch),
        "turned tiles: they touch, but for rounding": batch.Polygons(
            turn_rings(grid, np.repeat(TURN, len(grid), axis=0))
        ),
    }
    table: list[JsonRow] = []
    for words, shapes in scenes.items():
        # with NumPy: for so few pairs it is done before numba has compiled its kernels
        summary, results, _ = recommend_batch(shapes, None, None, engine="numpy")
        model = best(results).model
        table.append({"have": words, "kind": _kind(model.kind, shapes), "model": model.name})
        moving = model_for_any_position(summary, results).name  # the last scene has turned boxes, so it needs most
    return [*table, {"have": "turned shapes that move: positions not known", "kind": "exact", "model": moving}]


def _kind(kind: str, shapes: batch.Shapes) -> str:
    """Return the key in MEASURED of a model of this kind: "circles" for batches of circles, "exact", or the kind."""
    return "circles" if shapes.max_corners < 3 else "exact" if "exact" in kind else kind


def rows(found: dict[str, Any]) -> dict[str, list[JsonRow]]:
    """Return {stem of the table: its rows}; empty where `speed_against_accuracy` lacks the times or gaps of a model.

    found: the results of all cells, also of that section, by their names.
    """
    measured = {row["method"]: row for row in summaries(found)}
    if not measured.keys() >= set(MEASURED.values()):
        return {}
    sparks = {"have": "sparks and crowds, where a wrong hit costs nothing", "kind": "circles",
              "model": "bounding circles", "wrong_metres": measured["bounding circles"]["metres"]}  # fmt: skip
    table = []
    for row in (*({**row, "wrong_metres": 0.0} for row in found["decision"]), sparks):
        timed = measured[MEASURED[row["kind"]]]
        table.append(row | {key: timed[key] for key in ("ns", "ns_low", "ns_high", "ns_runs")})
    return {"decision-table": table}


def chart(rows: Sequence[JsonRow], settings: Settings) -> Chart:
    """Return the table as a chart."""
    least = sum(row["kind"] != "exact" for row in rows)
    title = f"{least} of {len(rows)} such scenes need less than filtered exact SAT: model no more than a scene needs"
    lines = (
        "The least model that satviz advise proves right for every pair of one such scene, of about "
        f"{shapes_in_a_scene(settings)} shapes. Another of the kind can need more. In the last row wrong hits are "
        "allowed. Time: the last test of the model alone, for 4-gons, or for circles in float64.",
    )
    table = [_in_words(row) for row in rows]
    heights = [TEXT_LINE * max(len(wrap(words, int(width / TEXT_LETTER)))
                          for words, (_, _, width) in zip(own, COLUMNS, strict=True)) + 8 for own in table]  # fmt: skip
    tall = sum(heights) + 62

    def draw(fig: Figure, theme: Theme) -> None:
        """Draw the table, a line between rows."""

        def cell(words: str, column: int, up: float, role: str, weight: str = "normal") -> None:
            """Write one field of the table; `up`: its first line's height in points."""
            _, left, width = COLUMNS[column]
            shade = theme.text.get(role, theme.roles[role])
            for n, line in enumerate(wrap(words, int(width / TEXT_LETTER))):
                add_text(fig, left, up - n * TEXT_LINE, line, color=shade, fontweight=weight, va="baseline")

        up = tall - 8 - TEXT_POINTS
        for k, (words, _, _) in enumerate(COLUMNS):
            cell(words, k, up, "guide")
        up -= 34
        for (have, model, time, wrong), row, height in zip(table, rows, heights, strict=True):
            ends = [share_of(fig, x, up + 4 + TEXT_POINTS) for x in (8, WIDTH - 8)]
            fig.add_artist(Line2D(*zip(*ends, strict=True), color=theme.roles["guide"], lw=0.6))
            cell(have, 0, up, "ink")
            cell(model, 1, up, "exact" if row["kind"] == "exact" else "ink", "bold")
            cell(time, 2, up, "ink")
            cell(wrong, 3, up, "wrong" if row["wrong_metres"] else "ink")
            up -= height

    text = f"{title}. " + " ".join(f"{own[0][0].upper()}{own[0][1:]}: {own[1]}, {own[2]}." for own in table)
    return Chart("decision-table", title, lines, tall, draw, rows, text, timing_warning(rows, settings))


def _in_words(row: JsonRow) -> tuple[str, str, str, str]:
    """Return (input, model, time a pair, largest wrong gap) as the texts of one row of the table."""
    wrong = f"found: {in_metres(row['wrong_metres'])} in 1 km" if row["wrong_metres"] else "none: proven"
    return row["have"], row["model"], format_time(row["ns"]), wrong


CHARTS = {"decision-table": chart}
