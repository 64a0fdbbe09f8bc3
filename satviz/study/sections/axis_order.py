"""The order of axes: how many are tested before one separates, while a shape moves past another.

The order never changes the verdict; where the shapes overlap all axes are tested in any order.
"""

from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from ...engine.axes import Axis, Source, needed
from ...engine.shapes import Polygon, Shape, centroid
from ...engine.trace import record
from ...pictures import Theme
from .. import truth
from ..harness.cells import Cell, Settings
from ..harness.chart import TEXT_POINTS, Chart, add_axes, draw_headline
from ..workloads.generators import ngons

Rng = np.random.Generator
OrderedAxes = tuple[Axis, ...]
ReorderAxes = Callable[[Shape, Shape, OrderedAxes, Source | None, Rng], OrderedAxes]
Row = dict[str, Any]


def last_first(axes: OrderedAxes, last: Source | None) -> OrderedAxes:
    """The axis from that source first, if it is among them: the warm start from the frame before."""
    first = tuple(axis for axis in axes if axis.source == last)
    return first + tuple(axis for axis in axes if axis.source != last) if first else axes


def most_parallel_first(axes: OrderedAxes, dx: float, dy: float) -> OrderedAxes:
    """Those nearest to a direction first: one dot product an axis, before any is tested."""
    return tuple(sorted(axes, key=lambda axis: -abs(dx * axis.normal.x + dy * axis.normal.y) / axis.length))


def center_direction(a: Shape, b: Shape) -> tuple[float, float]:
    """From A's centroid to B's."""
    (ax, ay), (bx, by) = centroid(a), centroid(b)
    return bx - ax, by - ay


def shuffled(axes: OrderedAxes, rng: Rng) -> OrderedAxes:
    """In any order, by chance."""
    return tuple(axes[i] for i in rng.permutation(len(axes)))


SHUFFLED, LAST_FIRST, ALONG_CENTERS = "shuffled", "last separating first", "along the centers"
ORDERS: dict[str, ReorderAxes] = {
    SHUFFLED: lambda a, b, add_axes, last, rng: shuffled(add_axes, rng),
    "as given": lambda a, b, add_axes, last, rng: add_axes,
    ALONG_CENTERS: lambda a, b, add_axes, last, rng: most_parallel_first(add_axes, *center_direction(a, b)),
    LAST_FIRST: lambda a, b, add_axes, last, rng: last_first(add_axes, last),
}


def passing_frames(rng: Rng, frames: int) -> Iterator[tuple[Polygon, Polygon]]:
    """Two random 8-gons, B moving past A on a straight path that grazes or crosses it, frame by frame."""
    a, b = ngons(rng, 2, 8, 0.0)
    start, way = np.array([-3.0, rng.uniform(-2, 2)]), np.array([6.0, rng.uniform(-1, 1)])
    shape = Polygon(a)
    for t in np.linspace(0, 1, frames).tolist():
        yield shape, Polygon(b + start + t * way)


def count_tested_axes(paths: int, frames: int, settings: Settings) -> list[Row]:
    """Along seeded paths, by order: the axes tested a frame apart, path by path, and the verdicts that are right."""
    rng = settings.rng("order")
    tested: dict[str, list[float]] = {name: [] for name in ORDERS}
    right, apart = dict.fromkeys(ORDERS, 0), 0
    for _ in range(paths):
        last: dict[str, Source | None] = dict.fromkeys(ORDERS)
        sums, ends = dict.fromkeys(ORDERS, 0), 0
        for a, b in passing_frames(rng, frames):
            choice, verdict = needed(a, b), truth.relation(a, b)
            ends += not verdict
            for name, order in ORDERS.items():
                trace = record(a, b, axes=choice._replace(axes=order(a, b, choice.axes, last[name], rng)))
                right[name] += trace.claim is verdict
                if trace.separating:
                    last[name] = trace.separating.source
                    sums[name] += len(trace.tests)
        apart += ends
        for name in ORDERS:
            tested[name].append(sums[name] / ends)
    rows = []
    for name, means in tested.items():
        mean, off = float(np.mean(means)), 1.96 * float(np.std(means, ddof=1)) / len(means) ** 0.5
        row: Row = {"order": name, "tested": mean, "low": mean - off, "high": mean + off, "paths": paths}
        rows.append({**row, "apart": apart, "frames": paths * frames, "right": right[name]})
    return rows


def cells(settings: Settings) -> list[Cell]:
    """One: all orders meet the same frames."""
    return [Cell("order", count_tested_axes, ((10, 40) if settings.quick else (200, 120)) + (settings,))]


def charts(found: dict[str, Any], settings: Settings) -> list[Chart]:
    """The mean of every order beside that of chance."""
    rows: Sequence[Row] = found["order"]
    by = {row["order"]: row for row in rows}
    chance, warm = by[SHUFFLED], by[LAST_FIRST]
    middle = by[ALONG_CENTERS]
    title = (
        f"Shuffled, {chance['tested']:.1f} axes are tested until one separates; "
        f"the last one first, {warm['tested']:.1f}; along the centers, {middle['tested']:.1f}"
    )

    def draw(fig: Figure, theme: Theme) -> None:
        under = f"8-gons going by on {chance['paths']} paths, {chance['apart']:,} frames apart; 16 axes at most"
        draw_headline(fig, theme, title, under)
        ax = add_axes(fig, (0.235, 0.2, 0.72, 0.53), theme)
        for y, row in enumerate(rows):
            role = "exact" if row["order"] == LAST_FIRST else "guide" if row["order"] == SHUFFLED else "shortcut"
            ax.plot([row["low"], row["high"]], [y, y], color=theme.roles[role], lw=1.6)
            ax.plot([row["tested"]], [y], "o", color=theme.roles[role], ms=7)
            at: dict[str, Any] = {"textcoords": "offset points", "va": "center_baseline", "fontsize": TEXT_POINTS}
            ax.annotate(f"{row['tested']:.2f}", (row["high"], y), (9, 0), color=theme.roles["ink"], **at)
        ax.axvline(1, color=theme.roles["guide"], lw=1, ls=(0, (1, 2.2)))
        ax.set_yticks(range(len(rows)), [row["order"] for row in rows])
        ax.set(ylim=(len(rows) - 0.5, -0.5), xlim=(0, max(row["high"] for row in rows) * 1.15))
        ax.set_xlabel("axes tested, mean with its 95 % interval (dotted: one, the least there can be)")
        ax.spines["left"].set_visible(False)
        ax.tick_params(axis="y", length=0)

    each = ", ".join(f"{row['order']} {row['tested']:.2f} ({row['low']:.2f} to {row['high']:.2f})" for row in rows)
    right, of = sum(row["right"] for row in rows), sum(row["frames"] for row in rows)
    text = f"Axes tested in a frame apart, mean over {chance['paths']} paths with its 95 % interval: {each}. "
    text += f"The verdict is the exact one in {right:,} of {of:,} runs: the order does not change it."
    return [Chart("order-of-axes", title, (800.0, 230.0), draw, rows, text)]
