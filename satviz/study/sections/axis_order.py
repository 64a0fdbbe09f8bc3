"""The order of axes: how many are tested before one separates, while a shape moves past another.

Question: which order finds a separating axis soonest?  Workload: 8-gons with corners on a circle, which pass each other
frame by frame.  Methods: four orders of the same axes.  The order never changes the verdict, and where the shapes
overlap every order tests all axes.  The claim is refuted by paths of such 8-gons on which the intervals of two orders
change places.  Flat shapes do have another order.
"""

from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from ...engine.axes import Axis, Source, needed
from ...engine.shapes import Polygon, Shape, centroid
from ...engine.trace import record
from ...pictures import Theme
from ...render.chart import TEXT_POINTS, WIDTH, Chart, JsonRow, add_axes
from .. import truth
from ..harness.cells import Cell, Settings
from ..workloads.generators import ngons

Rng = np.random.Generator
OrderedAxes = tuple[Axis, ...]
ReorderAxes = Callable[[Shape, Shape, OrderedAxes, Source | None, Rng], OrderedAxes]


def last_first(axes: OrderedAxes, last: Source | None) -> OrderedAxes:
    """Return the axes with the one from the source `last` moved to the front: a warm start from the last frame."""
    return tuple(sorted(axes, key=lambda axis: axis.source != last))


def most_parallel_first(axes: OrderedAxes, dx: float, dy: float) -> OrderedAxes:
    """Return the axes sorted by their angle to the direction (dx, dy), the smallest angle first."""
    return tuple(sorted(axes, key=lambda axis: -abs(dx * axis.normal.x + dy * axis.normal.y) / axis.length))


def center_direction(a: Shape, b: Shape) -> tuple[float, float]:
    """Return the vector (dx, dy) from A's centroid to B's."""
    (ax, ay), (bx, by) = centroid(a), centroid(b)
    return bx - ax, by - ay


def shuffled(axes: OrderedAxes, rng: Rng) -> OrderedAxes:
    """Return the axes in random order."""
    return tuple(axes[i] for i in rng.permutation(len(axes)))


SHUFFLED, LAST_FIRST, ALONG_CENTERS = "shuffled", "last separating first", "along the centers"
ORDERS: dict[str, ReorderAxes] = {
    SHUFFLED: lambda a, b, axes, last, rng: shuffled(axes, rng),
    "as given": lambda a, b, axes, last, rng: axes,
    ALONG_CENTERS: lambda a, b, axes, last, rng: most_parallel_first(axes, *center_direction(a, b)),
    LAST_FIRST: lambda a, b, axes, last, rng: last_first(axes, last),
}


def passing_frames(rng: Rng, frames: int) -> Iterator[tuple[Polygon, Polygon]]:
    """Yield random 8-gons A and B on each frame; A stays, B moves on a straight path past A or through it."""
    a, b = ngons(rng, 2, 8, 0.0)
    start, move = np.array([-3.0, rng.uniform(-2, 2)]), np.array([6.0, rng.uniform(-1, 1)])
    shape = Polygon(a)
    for t in np.linspace(0, 1, frames).tolist():
        yield shape, Polygon(b + start + t * move)


def count_tested_axes(paths: int, frames: int, settings: Settings) -> list[JsonRow]:
    """Return for each order the mean number of axes that it tests while the shapes are apart, and its right verdicts.

    The interval of the mean is from the means of the single paths.
    """
    rng = settings.rng("order")
    tested: dict[str, list[float]] = {name: [] for name in ORDERS}
    right, apart = dict.fromkeys(ORDERS, 0), 0
    for _ in range(paths):
        last: dict[str, Source | None] = dict.fromkeys(ORDERS)
        sums, frames_apart = dict.fromkeys(ORDERS, 0), 0
        for a, b in passing_frames(rng, frames):
            choice, verdict = needed(a, b), truth.agreed(a, b)
            frames_apart += not verdict
            for name, order in ORDERS.items():
                trace = record(a, b, axes=choice._replace(axes=order(a, b, choice.axes, last[name], rng)))
                right[name] += trace.claim is verdict
                if trace.separating:
                    last[name] = trace.separating.source
                    sums[name] += len(trace.tests)
        apart += frames_apart
        for name in ORDERS:
            tested[name].append(sums[name] / frames_apart)
    found = []
    for name, means in tested.items():
        mean, half = float(np.mean(means)), 1.96 * float(np.std(means, ddof=1)) / len(means) ** 0.5
        row: JsonRow = {"order": name, "tested": mean, "low": mean - half, "high": mean + half, "paths": paths}
        found.append({**row, "apart": apart, "frames": paths * frames, "right": right[name]})
    return found


def cells(settings: Settings) -> list[Cell]:
    """Return one cell, which counts the axes that each order tests, all orders on the same frames."""
    return [Cell("order", count_tested_axes, ((10, 40) if settings.quick else (150, 120)) + (settings,))]


def rows(found: dict[str, Any]) -> dict[str, list[JsonRow]]:
    """Return {stem of the chart: its rows}; found: the results of all cells by their names."""
    return {"order-of-axes": found["order"]}


def chart(rows: Sequence[JsonRow], settings: Settings) -> Chart:
    """Return the chart of the mean number of axes tested, by order."""
    by_order = {row["order"]: row for row in rows}
    tested = {name: f"{row['tested']:.2f} ({row['low']:.2f} to {row['high']:.2f})" for name, row in by_order.items()}
    paths, apart = rows[0]["paths"], rows[0]["apart"]
    title = (
        f"Axes tested until one separates round 8-gons: {tested[SHUFFLED]} shuffled, {tested[LAST_FIRST]} with "
        f"the last separating one first, {tested[ALONG_CENTERS]} along the centers"
    )
    lines = (
        f"8-gons with corners on a circle pass each other on {paths} paths of {rows[0]['frames'] // paths} frames "
        f"and are apart in {apart:,} frames. They have 16 axes. Dot: the mean, with its 95 % interval. Flat shapes "
        "can have another order.",
    )

    def draw(fig: Figure, theme: Theme) -> None:
        """Draw for each order a dot at its mean number of axes, and a bar for the 95 % interval."""
        ax = add_axes(fig, (142, 46, WIDTH - 158, 120), theme)
        for y, row in enumerate(rows):
            role = "exact" if row["order"] == LAST_FIRST else "guide" if row["order"] == SHUFFLED else "shortcut"
            ax.plot([row["low"], row["high"]], [y, y], color=theme.roles[role], lw=1.6)
            ax.plot([row["tested"]], [y], "o", color=theme.roles[role], ms=7)
            style: dict[str, Any] = {"textcoords": "offset points", "va": "center_baseline", "fontsize": TEXT_POINTS}
            ax.annotate(f"{row['tested']:.2f}", (row["high"], y), (9, 0), color=theme.roles["ink"], **style)
        ax.axvline(1, color=theme.roles["guide"], lw=1, ls=(0, (1, 2.2)))
        ax.set_yticks(range(len(rows)), [row["order"] for row in rows])
        ax.set(ylim=(len(rows) - 0.5, -0.5), xlim=(0, max(row["high"] for row in rows) * 1.15))
        ax.set_xlabel("axes tested (dotted: 1, the minimum)")
        ax.spines["left"].set_visible(False)
        ax.tick_params(axis="y", length=0)

    each = ", ".join(f"{row['order']} {row['tested']:.2f} ({row['low']:.2f} to {row['high']:.2f})" for row in rows)
    right, total = sum(row["right"] for row in rows), sum(row["frames"] for row in rows)
    text = f"Axes tested in a frame with the shapes apart, mean over {paths} paths with its 95 % interval: {each}. "
    text += f"The verdict is exact in {right:,} of {total:,} runs: the order does not change it."
    return Chart("order-of-axes", title, lines, 176, draw, rows, text)


CHARTS = {"order-of-axes": chart}
