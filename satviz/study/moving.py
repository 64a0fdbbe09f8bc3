"""The order of axes: which axis ends the search, and how much the last separating one saves along a moving scene.

The order never changes the verdict, only how many axes are tested before the early
exit; where the shapes overlap all are tested in any order.
"""

from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..engine.axes import Axis, Source, needed
from ..engine.shapes import Polygon, Shape, centroid
from ..engine.trace import record
from ..engine.verdict import relate
from ..pictures import Theme
from .cells import Cell, Settings
from .chart import TEXT, Chart, axes, headline, label_ends
from .workloads import ngons

Rng = np.random.Generator
InOrder = tuple[Axis, ...]
Order = Callable[[Shape, Shape, InOrder, Source | None, Rng], InOrder]


def last_first(axes: InOrder, last: Source | None) -> InOrder:
    """The axis from that source first, if it is among them: the warm start from the frame before."""
    first = tuple(axis for axis in axes if axis.source == last)
    return first + tuple(axis for axis in axes if axis.source != last) if first else axes


def along(axes: InOrder, dx: float, dy: float) -> InOrder:
    """Those nearest to a direction first: one dot product an axis, before any is tested."""
    return tuple(sorted(axes, key=lambda axis: -abs(dx * axis.normal.x + dy * axis.normal.y) / axis.length))


def between_centers(a: Shape, b: Shape) -> tuple[float, float]:
    """From A's centroid to B's."""
    (ax, ay), (bx, by) = centroid(a), centroid(b)
    return bx - ax, by - ay


def _shuffled(axes: InOrder, rng: Rng) -> InOrder:
    return tuple(axes[i] for i in rng.permutation(len(axes)))


GIVEN, WARM = "as given", "last separating first"
ORDERS: dict[str, Order] = {
    GIVEN: lambda a, b, axes, last, rng: axes,
    "reversed": lambda a, b, axes, last, rng: axes[::-1],
    "shuffled": lambda a, b, axes, last, rng: _shuffled(axes, rng),
    "along the centers": lambda a, b, axes, last, rng: along(axes, *between_centers(a, b)),
    WARM: lambda a, b, axes, last, rng: last_first(axes, last),
}


def passing(rng: Rng, frames: int) -> Iterator[tuple[Polygon, Polygon]]:
    """Two random 8-gons, B moving past A on a straight path that grazes or crosses it, frame by frame."""
    a, b = ngons(rng, 2, 8, 0.0)
    start, way = np.array([-3.0, rng.uniform(-2, 2)]), np.array([6.0, rng.uniform(-1, 1)])
    shape = Polygon(a)
    for t in np.linspace(0, 1, frames).tolist():
        yield shape, Polygon(b + start + t * way)


def followed(paths: int, frames: int, seed: int) -> dict[str, Any]:
    """Along seeded paths: the axes tested in each order, frame by frame on the first path, and in all.

    `equal`: the verdicts that are the exact one; `other_end`: the frames apart that
    end on another axis than in the given order.
    """
    rng = Settings(seed=seed).rng("moving scene")
    totals = {name: {"apart": 0, "tested_apart": 0, "tested": 0, "equal": 0, "other_end": 0} for name in ORDERS}
    first: list[dict[str, Any]] = []
    for path in range(paths):
        last: dict[str, Source | None] = dict.fromkeys(ORDERS)
        for frame, (a, b) in enumerate(passing(rng, frames)):
            choice, right, ends, row = needed(a, b), relate(a, b), {}, {}
            for name, order in ORDERS.items():
                trace = record(a, b, axes=choice._replace(axes=order(a, b, choice.axes, last[name], rng)))
                end, total, tested = trace.separating, totals[name], len(trace.tests)
                ends[name] = last[name] = end.source if end else last[name]
                total["equal"] += trace.claim is right
                total["tested"] += tested
                row[name] = tested
                if end:
                    total["apart"] += 1
                    total["tested_apart"] += tested
                    total["other_end"] += ends[name] != ends[GIVEN]
            if path == 0:
                first.append({"frame": frame, "apart": not right, **row})
    return {"paths": paths, "frames": paths * frames, "first": first, "orders": totals}


def cells(settings: Settings) -> list[Cell]:
    """One: all orders meet the same frames."""
    paths, frames = (5, 120) if settings.quick else (100, 240)
    return [Cell("moving-scene", followed, (paths, frames, settings.seed))]


def charts(results: dict[str, Any]) -> list[Chart]:
    """The first path frame by frame, and the mean of every order over all paths."""
    found = results["moving-scene"]
    rows = [{"order": name, "frames": found["frames"], **found["orders"][name]} for name in ORDERS]
    for row in rows:
        row["mean_apart"] = row["tested_apart"] / row["apart"]
        row["mean"] = row["tested"] / row["frames"]
    title = "Order of axes: tested before the early exit while B moves past A"

    def draw(fig: Figure, theme: Theme) -> None:
        _draw(fig, theme, title, rows, found["first"])

    return [Chart("moving-scene", title, (1080, 380), draw, [*rows, *found["first"]], _told(rows))]


def _told(rows: Sequence[dict[str, Any]]) -> str:
    by = {row["order"]: row for row in rows}
    given, warm, centers = by[GIVEN], by[WARM], by["along the centers"]
    others = {name: row["other_end"] / row["apart"] for name, row in by.items() if name != GIVEN}
    least, most = min(others, key=others.__getitem__), max(others, key=others.__getitem__)
    apart, every = ([f"{row[key]:.2f}" for row in (given, centers, warm)] for key in ("mean_apart", "mean"))
    return (
        f"While the shapes are apart, {apart[0]} axes are tested in the order given, {apart[1]} with those along the "
        f"line of centers first, and {apart[2]} starting from the axis that separated in the frame before. "
        f"Over all frames, where hits need every axis, it is {every[0]}, {every[1]} and {every[2]}. "
        f"The axis that ends the search is another one than in the given order in {others[least]:.0%} ({least}) to "
        f"{others[most]:.0%} ({most}) of the frames apart. "
        f"The verdict is the exact one in {sum(row['equal'] for row in rows):,} of "
        f"{sum(row['frames'] for row in rows):,} runs: the order does not change it."
    )


def _draw(
    fig: Figure, theme: Theme, title: str, rows: Sequence[dict[str, Any]], first: Sequence[dict[str, Any]]
) -> None:
    headline(fig, theme, title, "two random 8-gons; the search ends at the first axis that separates")
    _frames(axes(fig, (0.05, 0.13, 0.44, 0.68), theme, "one path, frame by frame"), theme, first)
    ax = axes(fig, (0.75, 0.13, 0.21, 0.68), theme, "mean while apart, all paths")
    for y, row in enumerate(rows):
        role = ROLES.get(row["order"], "guide")
        ax.plot([0, row["mean_apart"]], [y, y], color=theme.roles[role], lw=1.6)
        ax.plot([row["mean_apart"]], [y], "D" if role == "exact" else "o", color=theme.roles[role], ms=7)
        at = {"textcoords": "offset points", "va": "center_baseline", "fontsize": TEXT, "annotation_clip": False}
        ink = theme.text.get(role, theme.roles[role])
        ax.annotate(f"{row['mean_apart']:.2f}", (row["mean_apart"], y), (9, 0), color=ink, **at)
    ax.set_yticks(range(len(rows)), [row["order"] for row in rows])
    ax.set(ylim=(len(rows) - 0.5, -0.5), xlim=(0, max(row["mean_apart"] for row in rows) * 1.15), xlabel="axes tested")
    ax.spines["left"].set_visible(False)
    ax.tick_params(axis="y", length=0)


ROLES = {GIVEN: "shortcut", WARM: "exact"}


def _frames(ax: Axes, theme: Theme, first: Sequence[dict[str, Any]]) -> None:
    """The given order and the warm start as steps; the frames that overlap are shaded and named."""
    frames, most = [row["frame"] for row in first], max(row[GIVEN] for row in first)
    for name, style in (GIVEN, "--"), (WARM, "-"):
        shade = theme.roles[ROLES[name]]
        ax.step(frames, [row[name] for row in first], where="mid", color=shade, lw=2, ls=style)
    hits = [row["frame"] for row in first if not row["apart"]]
    if hits:
        ax.axvspan(hits[0] - 0.5, hits[-1] + 0.5, color=theme.roles["overlap"], alpha=0.15, lw=0)
        middle, ink = (hits[0] + hits[-1]) / 2, theme.text.get("overlap", theme.roles["overlap"])
        ax.text(middle, most + 0.4, "a hit: every axis", color=ink, fontsize=TEXT, ha="center", va="bottom")
    ax.set(xlim=(-1, len(first)), ylim=(0, most + 2), xlabel="frame", ylabel="axes tested")
    ink = {name: theme.text.get(role, theme.roles[role]) for name, role in ROLES.items()}
    label_ends(ax, [(len(first) - 1, first[-1][name], name, ink[name]) for name in (GIVEN, WARM)])
