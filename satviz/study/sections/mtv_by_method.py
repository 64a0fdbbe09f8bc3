"""The push out of an overlap (MTV) by method: is it long enough, short enough, and in the right direction?

Question: how wrong are the pushes that fast methods give?  Workload: pairs that overlap, convex, one inside the other,
and with a concave outline.  Methods: satviz (`trace.mtv`), SAT with normals of length 1 in float64 and in float32, SAT
with raw normals, upright boxes, and for concave outlines the deepest pair of convex parts and the convex hull.  After
the push the shapes are tested exactly.  The least push comes from the exact difference of the shapes, and for concave
outlines from the union of the differences of their parts (shapely).  The claim is refuted by a push of satviz after
which the shapes still overlap, or that is longer than the least push by more than roundings.
"""

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from ...engine.convex_parts import parts
from ...engine.geometry import Relation
from ...engine.shapes import Polygon
from ...engine.trace import record
from ...pictures import Theme
from .. import truth
from ..harness.cells import Cell, JsonRow, Settings
from ..harness.chart import TEXT_POINTS, WIDTH, Chart, add_axes, draw_headline, head_height
from ..harness.machine import is_installed
from ..workloads.generators import Array, ngons, turn_rings, turned_boxes, unit_vectors

CONVEX, CONTAINED, CONCAVE = "convex, overlapping", "one inside the other", "with a dent"
ROUNDING, VISIBLE = 1e-9, 0.01  # shares of the least push: below, an error is rounding; above, it is seen
OUTCOMES = {  # by name: (colour role, hatch)
    "right": ("gap", ""),
    "overlap left by rounding": ("tolerance", "..."),
    "more than 1 % too long": ("B", "///"),
    "overlap left, seen": ("wrong", "xxx"),
}
Push = Callable[[Polygon, Polygon], tuple[float, float]]


def sat_push(dtype: Any, *, unit: bool) -> Push:
    """Return SAT's push of B: along the edge normal of least depth, as the depth is measured with these normals."""

    def push(a: Polygon, b: Polygon) -> tuple[float, float]:
        """Return the push of B for one pair."""
        rings = [np.array(shape.corners, dtype) for shape in (a, b)]
        found = []
        for ring, other, sign in (rings[0], rings[1], 1), (rings[1], rings[0], -1):
            edge = np.roll(ring, -1, axis=0) - ring
            normal = np.stack([edge[:, 1], -edge[:, 0]], axis=1)
            length = np.sqrt((normal * normal).sum(axis=1, keepdims=True))
            axes = normal / length if unit else normal
            depth = (axes * ring).sum(axis=1) - (axes @ other.T).min(axis=1)
            k = int(depth.argmin())
            found.append((depth[k], sign * depth[k] * axes[k] / (1 if unit else length[k] ** 2)))
        _, (x, y) = min(found, key=lambda pair: pair[0])
        return float(x), float(y)

    return push


def box_push(a: Polygon, b: Polygon) -> tuple[float, float]:
    """Return the push that separates the upright boxes of both shapes."""
    (ax0, ay0, ax1, ay1), (bx0, by0, bx1, by1) = a.bounds, b.bounds
    ways = [(ax1 - bx0, 0.0), (ax0 - bx1, 0.0), (0.0, ay1 - by0), (0.0, ay0 - by1)]
    return min(ways, key=lambda way: abs(way[0]) + abs(way[1]))


def deepest_parts_push(a: Polygon, b: Polygon) -> tuple[float, float]:
    """Return the longest push among the pairs of convex parts, as engines with compound shapes do."""
    pushes = [record(p, q).mtv for p in parts(a) for q in parts(b)]
    x, y = max((push for push in pushes if push), key=lambda push: push.x**2 + push.y**2)
    return x, y


def hull_push(a: Polygon, b: Polygon) -> tuple[float, float]:
    """Return the push for the convex hulls."""
    import shapely

    hulls = [Polygon(list(shapely.Polygon(s.vertices).convex_hull.exterior.coords)[:-1]) for s in (a, b)]
    return satviz_push(*hulls)


def satviz_push(a: Polygon, b: Polygon) -> tuple[float, float]:
    """Return `trace.mtv`."""
    move = record(a, b).mtv
    assert move is not None
    return move.x, move.y


UNIT_SAT = sat_push(np.float64, unit=True)
METHODS: dict[str, dict[str, Push]] = {
    CONVEX: {"upright boxes": box_push, "SAT, raw normals": sat_push(np.float64, unit=False),
             "SAT, float32": sat_push(np.float32, unit=True), "SAT, float64": UNIT_SAT, "satviz": satviz_push},
    CONCAVE: {"convex hull": hull_push, "deepest parts": deepest_parts_push, "satviz": satviz_push},
}  # fmt: skip
METHODS[CONTAINED] = METHODS[CONVEX]
DENTED = np.array([(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)], float) - 1.6  # an L


def cells(settings: Settings) -> list[Cell]:
    """Return a cell for each kind of pairs; concave outlines need shapely for the least push."""
    n = 20 if settings.quick else 300
    kinds = [CONVEX, CONTAINED, *([CONCAVE] if is_installed("shapely") else [])]
    return [Cell(f"mtv-{kind.split()[-1]}", measure, (kind, n, settings)) for kind in kinds]


def overlapping_pairs(kind: str, rng: np.random.Generator, n: int) -> list[tuple[Polygon, Polygon]]:
    """Return n pairs that overlap."""
    found: list[tuple[Polygon, Polygon]] = []
    while len(found) < n:
        if kind == CONCAVE:
            a: Array = turn_rings(DENTED[None], unit_vectors(rng, 1))[0]
            b = turned_boxes(rng, 1, 2.2)[0]
        elif kind == CONTAINED:
            a, b = turned_boxes(rng, 1, 0.0)[0] * 5, ngons(rng, 1, 5, 0.4)[0] * 0.5
        else:
            a, b = turned_boxes(rng, 1, 1.2)[0], ngons(rng, 1, 5, 1.2)[0]
        pair = Polygon(a), Polygon(b)
        if _relation(*pair, (0.0, 0.0)) is Relation.OVERLAPPING:
            found.append(pair)
    return found


def _relation(a: Polygon, b: Polygon, move: tuple[float, float]) -> Relation:
    """Return the exact relation after B has moved by exactly `move`."""
    return max(truth.relation_moved(p, q, move) for p in _parts(a) for q in _parts(b))


def _parts(shape: Polygon) -> list[Polygon]:
    """Return the convex parts of a polygon."""
    return [part for part in parts(shape) if isinstance(part, Polygon)]


def least_push(kind: str, a: Polygon, b: Polygon) -> float:
    """Return the length of the least push, exact but for its last rounding (concave: for some roundings)."""
    if kind != CONCAVE:
        return math.sqrt(truth.squared_gap(a, b))
    import shapely

    differences = ([(px - qx, py - qy) for px, py in one.vertices for qx, qy in other.vertices]
                   for one in _parts(a) for other in _parts(b))  # fmt: skip
    regions = [shapely.MultiPoint(points).convex_hull for points in differences]
    return float(shapely.union_all(regions).boundary.distance(shapely.Point(0, 0)))


def measure(kind: str, n: int, settings: Settings) -> list[JsonRow]:
    """Return for each method how many pushes have which outcome, and the largest errors of length and direction."""
    pairs = overlapping_pairs(kind, settings.rng("mtv", kind), n)
    right = [least_push(kind, a, b) for a, b in pairs]
    rows = []
    for name, push in METHODS[kind].items():
        counts, longest, turned = dict.fromkeys(OUTCOMES, 0), 0.0, 0
        for (a, b), least in zip(pairs, right, strict=True):
            x, y = push(a, b)
            excess = float(np.hypot(x, y)) / least - 1
            longest = max(longest, abs(excess))
            if _relation(a, b, (x, y)) is Relation.OVERLAPPING:
                more = 1 + ROUNDING if excess > -1e-6 else 1.001
                rounded = _relation(a, b, (x * more, y * more)) is not Relation.OVERLAPPING
                counts["overlap left by rounding" if rounded or abs(excess) < 1e-6 else "overlap left, seen"] += 1
            else:
                counts["more than 1 % too long" if excess > VISIBLE else "right"] += 1
            turned += excess > VISIBLE
        rows.append({"kind": kind, "method": name, "pairs": n, **counts, "largest_error": longest, "not_least": turned})
    return rows


def charts(found: dict[str, Any], settings: Settings) -> list[Chart]:
    """Return the chart of outcomes: a bar for each kind of pairs and method."""
    rows: list[JsonRow] = [row for name, own in found.items() if name.startswith("mtv-") for row in own]
    own = [row for row in rows if row["method"] == "satviz"]
    left = sum(row["pairs"] - row["right"] for row in own)
    raw = next(row for row in rows if (row["kind"], row["method"]) == (CONVEX, "SAT, raw normals"))
    plain = next(row for row in rows if (row["kind"], row["method"]) == (CONVEX, "SAT, float64"))
    title = (
        f"After a push by SAT in float64 {plain['overlap left by rounding'] / plain['pairs']:.0%} of the pairs still "
        f"overlap by a rounding; raw normals push {raw['more than 1 % too long'] / raw['pairs']:.0%} too far; of "
        f"satviz's pushes {left if left else 'none'} {'is' if left < 2 else 'are'} wrong"
    )
    lines = ("Pairs that overlap, pushed apart by each method and then tested exactly.",)
    head, step = head_height(title, lines, WIDTH), 20.0
    kinds = list(dict.fromkeys(row["kind"] for row in rows))
    size = WIDTH, head + step * (len(rows) + 1.4 * len(kinds)) + 66

    def draw(fig: Figure, theme: Theme) -> None:
        """Draw a bar for each method, in parts by outcome, under the name of each kind of pairs."""
        draw_headline(fig, theme, title, *lines)
        ax = add_axes(fig, (122 / WIDTH, 56 / size[1], (WIDTH - 140) / WIDTH, (size[1] - head - 60) / size[1]), theme)
        y, ticks = 0.0, []
        for kind in kinds:
            ax.text(-0.005, y, kind, ha="right", va="center_baseline", fontsize=TEXT_POINTS, fontweight="bold",
                    color=theme.roles["ink"], transform=ax.get_yaxis_transform())  # fmt: skip
            y += 1
            for row in (row for row in rows if row["kind"] == kind):
                start = 0.0
                for outcome, (role, hatch) in OUTCOMES.items():
                    share = row[outcome] / row["pairs"]
                    ax.barh(y, share, 0.74, start, color=theme.roles[role], hatch=hatch, edgecolor=theme.paper, lw=0)
                    start += share
                ticks.append((y, row["method"]))
                y += 1
            y += 0.4
        ax.set(xlim=(0, 1), ylim=(y - 0.8, -0.6))
        ax.set_yticks([at for at, _ in ticks], [name for _, name in ticks])
        ax.set_xticks([0, 0.5, 1], ["0", "half of the pairs", "all"])
        ax.tick_params(axis="y", length=0)
        ax.spines[["left", "bottom"]].set_visible(False)
        spots = zip((0.012, 0.115, 0.45, 0.745), OUTCOMES.items(), strict=True)
        for x, (outcome, (role, hatch)) in spots:
            key = fig.add_axes((x, 12 / size[1], 12 / WIDTH, 10 / size[1]))
            key.set_facecolor(theme.paper)
            key.barh(0, 1, 1, color=theme.roles[role], hatch=hatch, edgecolor=theme.paper, lw=0)
            key.set(xlim=(0, 1), ylim=(-0.5, 0.5))
            key.axis("off")
            fig.text(x + 16 / WIDTH, 17 / size[1], outcome, fontsize=TEXT_POINTS, va="center", color=theme.roles["ink"])

    text = f"{title}. "
    for row in rows:
        told = ", ".join(f"{row[outcome]:,} {outcome}" for outcome in OUTCOMES if row[outcome])
        text += f"{row['kind']}, {row['method']}: {told} of {row['pairs']:,}. "
    text += "A push that is longer than the least by more than 1 % goes in another direction."
    return [Chart("mtv", title, size, draw, rows, text)]
