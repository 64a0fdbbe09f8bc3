"""The decision table: what you have, and the least model that does.

Question: which model is enough for a scene?  Workload: small scenes of the kinds that people have.  Methods: the
candidates of `satviz.advice`, from bounding circles to the exact filter.  The model of a scene is the smallest one that
`satviz.advise` proves right for every pair, and its time is the median of `speed_against_accuracy`.  The claim is
refuted by a pair of a scene that its model answers wrongly, or by a smaller model that is proven.
"""

from textwrap import wrap
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from ... import batch
from ...advice.advising import advise
from ...pictures import Theme
from ..harness.cells import Cell, JsonRow, Settings
from ..harness.chart import TEXT_LETTER, TEXT_POINTS, WIDTH, Chart, draw_headline, format_time, head_height
from ..harness.timings import timing_warning
from ..workloads.adversary import beside, kilometre_shapes
from ..workloads.generators import circles, tiles, turn_rings, turned_boxes
from .speed_against_accuracy import in_metres, summaries

TURN = np.array([[0.955336489125606, 0.2955202066613396]])  # a unit vector, 0.3 radians from the x axis
MEASURED = {"AABB": "AABB", "float32": "SAT, float32", "float64": "SAT, raw normals", "exact": "satviz"}
COLUMNS = (
    ("what you have", 8.0, 168.0),
    ("least model that is enough", 186.0, 168.0),
    ("a pair", 352.0, 50.0),
    ("what it tells wrongly", 404.0, 114.0),
)  # title, left and width in points


def cells(settings: Settings) -> list[Cell]:
    """Return one cell, which asks for the least model of every scene."""
    return [Cell("decision", recommend, (60 if settings.quick else 400, settings))]


def recommend(n: int, settings: Settings) -> list[JsonRow]:
    """Return for each scene of about n shapes the model that is proven right, and why a smaller one is not."""
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
    rows: list[JsonRow] = []
    for words, shapes in scenes.items():
        found = advise(shapes)
        model, search = found.model, found.summary.search
        row: JsonRow = {"have": words, "shapes": len(shapes), "kind": _kind(model.kind, shapes), "model": model.name}
        row |= {"search": search.name if search else "", "relative_margin": found.summary.relative_margin}
        rows.append({**row, "proven": True, "anywhere": found.anywhere.name})
    moving = rows[3]["anywhere"]
    unknown = {"have": "anything that moves: positions not known before", "shapes": 0, "kind": "exact", "search": ""}
    rows.append({**unknown, "model": moving, "relative_margin": 0.0, "proven": True, "anywhere": moving})
    return rows


def _kind(kind: str, shapes: batch.Shapes) -> str:
    """Return the short name of a kind of model, under which its time is found; circles are not timed."""
    return "circles" if shapes.max_corners < 3 else "exact" if "exact" in kind else kind


def charts(found: dict[str, Any], settings: Settings) -> list[Chart]:
    """Return the table as a chart; times and worst gaps come from `speed_against_accuracy`, where that has run."""
    measured = {row["method"]: row for row in summaries(found)} if any(n.startswith("speed-") for n in found) else {}
    rows = []
    for row in found["decision"]:
        time = measured.get(MEASURED.get(row["kind"], ""))
        rows.append({**row, "ns": time["ns"] if time else None, "wrong_metres": 0.0})
    sparks = measured.get("bounding circles")
    if sparks:
        rows.append({"have": "sparks and crowds, where a wrong hit costs nothing", "shapes": 0, "kind": "circles",
                     "model": "bounding circles", "search": "", "relative_margin": 0.0, "proven": False,
                     "anywhere": "", "ns": sparks["ns"], "wrong_metres": sparks["metres"]})  # fmt: skip
    return [table_chart(rows, timing_warning(list(measured.values()), settings))]


def table_chart(rows: list[JsonRow], warning: str) -> Chart:
    """Return the chart of the table's rows; `warning`: why their times are only rough, or empty."""
    least = sum(row["kind"] != "exact" for row in rows)
    title = f"{least} of {len(rows)} kinds of scenes need no exact test: model no more than a scene needs"
    lines = (
        "The least model that `satviz advise` proves right for every pair of such a scene. Time: the answer alone.",
    )
    told = [_told(row) for row in rows]
    heights = [14.0 * max(len(wrap(words, int(width / TEXT_LETTER)))
                          for words, (_, _, width) in zip(own, COLUMNS, strict=True)) + 8 for own in told]  # fmt: skip
    head = head_height(title, lines, WIDTH)
    size = WIDTH, head + sum(heights) + 44

    def draw(fig: Figure, theme: Theme) -> None:
        """Draw the table, a line between rows."""
        draw_headline(fig, theme, title, *lines)
        style: dict[str, Any] = {"fontsize": TEXT_POINTS, "va": "top", "parse_math": False, "linespacing": 1.15}
        down = head + 8
        for words, left, _ in COLUMNS:
            fig.text(left / WIDTH, 1 - down / size[1], words, color=theme.roles["guide"], **style)
        down += 18
        for own, row, height in zip(told, rows, heights, strict=True):
            fig.add_artist(_rule(theme, down - 4, size))
            for k, (words, (_, left, width)) in enumerate(zip(own, COLUMNS, strict=True)):
                role = (
                    "exact"
                    if k == 1 and row["kind"] == "exact"
                    else "wrong"
                    if k == 3 and row["wrong_metres"]
                    else "ink"
                )
                lines_of = "\n".join(wrap(words, int(width / TEXT_LETTER)))
                fig.text(left / WIDTH, 1 - down / size[1], lines_of, color=theme.text.get(role, theme.roles[role]),
                         fontweight="bold" if k == 1 else "normal", **style)  # fmt: skip
            down += height

    text = f"{title}. " + " ".join(f"{own[0][0].upper()}{own[0][1:]}: {own[1]}." for own in told)
    return Chart("decision-table", title, size, draw, rows, text, warning)


def _told(row: JsonRow) -> tuple[str, str, str, str]:
    """Return the four fields of a row in words."""
    time = format_time(row["ns"]) if row["ns"] else "–"
    wrong = f"gaps up to {in_metres(row['wrong_metres'])} in 1 km" if row["wrong_metres"] else "nothing: proven"
    return row["have"], row["model"], time, wrong


def _rule(theme: Theme, down: float, size: tuple[float, float]) -> Any:
    """Return a thin line across the chart at a distance from its top."""
    from matplotlib.lines import Line2D

    y = 1 - down / size[1]
    return Line2D([8 / WIDTH, 1 - 8 / WIDTH], [y, y], color=theme.roles["guide"], lw=0.6)
