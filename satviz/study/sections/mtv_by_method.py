"""The push out of an overlap (MTV) by method: is it long enough, short enough, and in the right direction?

Question: how wrong are the pushes that fast methods give, in length and in direction?  Workload: pairs that overlap,
convex, one inside the other, and with a concave outline.  Methods: satviz (`trace.mtv`), SAT with normals of length 1
in float64 and in float32, SAT with raw normals, upright boxes, and for concave outlines the deepest pair of convex
parts and the convex hull.  After the push the shapes are tested exactly, by both oracles.  The least push comes from
the exact difference of the shapes, and for concave outlines from the union of the differences of their parts (shapely,
in floats).  The claim is refuted by a push of satviz after which the shapes still overlap, or that is longer than the
least push by more than roundings.
"""

import math
from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ...engine.convex_parts import parts
from ...engine.geometry import Relation
from ...engine.shapes import Polygon
from ...engine.trace import record
from ...pictures import Theme
from ...render.chart import TEXT_POINTS, Chart, JsonRow, add_axes, add_text, share_of
from .. import truth
from ..harness.cells import Cell, Settings
from ..harness.chart import wilson_interval
from ..harness.machine import is_installed
from ..workloads.generators import Array, ngons, turn_rings, turned_boxes, unit_vectors

CONVEX, CONTAINED, CONCAVE = "convex, overlapping", "one in the other", "with a dent"
ROUNDING, VISIBLE = 1e-9, 0.01  # shares of the least push: below, an error is rounding; above, it is seen
TURNED = 1.0  # degrees, from which on a push goes in another direction
LEAST_ERROR = 1e-17  # the value at which errors of 0 are drawn
OUTCOMES = {  # name: (colour role, hatch)
    "right": ("gap", ""),
    "overlap left by rounding": ("tolerance", "|||"),
    "more than 1 % too long": ("B", "///"),
    "overlap left, seen": ("wrong", "xxx"),
}
Push = Callable[[Polygon, Polygon], tuple[float, float]]
Vector = tuple[Fraction, Fraction]


def sat_push(dtype: Any, *, unit: bool) -> Push:
    """Return SAT as a function of (a, b) that returns the push of B along the edge normal of least depth.

    dtype: the float format; without `unit`, normals keep their lengths, so that longer edges seem deeper.
    """

    def push(a: Polygon, b: Polygon) -> tuple[float, float]:
        """Return the push (dx, dy) of B out of the overlap of a and b."""
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
    """Return the shortest push (dx, dy) of B that separates the bounding boxes."""
    (ax0, ay0, ax1, ay1), (bx0, by0, bx1, by1) = a.bounds, b.bounds
    ways = [(ax1 - bx0, 0.0), (ax0 - bx1, 0.0), (0.0, ay1 - by0), (0.0, ay0 - by1)]
    return min(ways, key=lambda way: abs(way[0]) + abs(way[1]))


def deepest_parts_push(a: Polygon, b: Polygon) -> tuple[float, float]:
    """Return the longest of the MTVs (dx, dy) of all pairs of convex parts, as engines with compound shapes do."""
    pushes = [record(p, q).mtv for p in parts(a) for q in parts(b)]
    x, y = max((push for push in pushes if push), key=lambda push: push.x**2 + push.y**2)
    return x, y


def hull_push(a: Polygon, b: Polygon) -> tuple[float, float]:
    """Return the shortest push (dx, dy) of B that separates the convex hulls."""
    import shapely

    hulls = [Polygon(list(shapely.Polygon(s.vertices).convex_hull.exterior.coords)[:-1]) for s in (a, b)]
    return satviz_push(*hulls)


def satviz_push(a: Polygon, b: Polygon) -> tuple[float, float]:
    """Return the MTV (dx, dy) of B that satviz finds, `trace.mtv`."""
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
    """Return n overlapping pairs of a kind: CONVEX, CONTAINED (a small B inside A), or CONCAVE (A has a dent)."""
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
    """Return the exact relation of two polygons, also concave ones, after B has moved by exactly `move`."""
    return max(truth.relation_moved(p, q, move) for p in _parts(a) for q in _parts(b))


def _parts(shape: Polygon) -> list[Polygon]:
    """Return the convex parts of a polygon."""
    return [part for part in parts(shape) if isinstance(part, Polygon)]


def least_push(kind: str, a: Polygon, b: Polygon) -> tuple[float, list[Vector]]:
    """Return (length of the least push of B, its directions): several directions can need the same length.

    For convex polygons all directions are returned, exactly, and the length is rounded.  For concave ones shapely
    computes in floats, and one direction is returned.
    """
    if kind != CONCAVE:
        return math.sqrt(truth.squared_gap(a, b)), [(Fraction(x), Fraction(y)) for x, y in truth.mtv_directions(a, b)]
    import shapely

    differences = ([(px - qx, py - qy) for px, py in one.vertices for qx, qy in other.vertices]
                   for one in _parts(a) for other in _parts(b))  # fmt: skip
    regions = [shapely.MultiPoint(points).convex_hull for points in differences]
    way = shapely.shortest_line(shapely.Point(0, 0), shapely.union_all(regions).boundary)
    return float(way.length), [truth.exact(way.coords[1])]


def angle_between(push: tuple[float, float], directions: Iterable[Vector]) -> float:
    """Return the angle in degrees from a push to the nearest of the directions; a tiny angle is not rounded to 0."""
    x, y = truth.exact(push)
    return min(math.degrees(math.atan2(abs(x * ny - y * nx), x * nx + y * ny)) for nx, ny in directions)


def measure(kind: str, n: int, settings: Settings) -> list[JsonRow]:
    """Return for each method how many pushes have which outcome, and its errors of length and direction.

    An error of length is a share of the least push, an error of direction an angle in degrees.
    """
    pairs = overlapping_pairs(kind, settings.rng("mtv", kind), n)
    right = [least_push(kind, a, b) for a, b in pairs]
    found = []
    for name, push in METHODS[kind].items():
        counts, lengths, angles = dict.fromkeys(OUTCOMES, 0), list[float](), list[float]()
        for (a, b), (least, directions) in zip(pairs, right, strict=True):
            x, y = push(a, b)
            excess = math.hypot(x, y) / least - 1
            lengths.append(abs(excess))
            angles.append(angle_between((x, y), directions))
            if _relation(a, b, (x, y)) is Relation.OVERLAPPING:
                more = 1 + ROUNDING if excess > -1e-6 else 1.001
                rounded = _relation(a, b, (x * more, y * more)) is not Relation.OVERLAPPING
                counts["overlap left by rounding" if rounded or abs(excess) < 1e-6 else "overlap left, seen"] += 1
            else:
                counts["more than 1 % too long" if excess > VISIBLE else "right"] += 1
        row: JsonRow = {"kind": kind, "method": name, "pairs": n, **counts}
        row["turned"] = sum(angle > TURNED for angle in angles)
        for column, errors in ("length", lengths), ("angle", angles):
            row |= {f"{column}_median": float(np.median(errors)), f"{column}_largest": max(errors)}
        found.append(row)
    return found


def rows(found: dict[str, Any]) -> dict[str, list[JsonRow]]:
    """Return {stem of the chart: its rows}, one for each kind of pairs and method; found: results by cell name."""
    return {"mtv": [row for name, own in found.items() if name.startswith("mtv-") for row in own]}


def _share(rows: Sequence[JsonRow], method: str, outcome: str) -> str:
    """Return the share of an outcome among all pushes of a method, with its 95 % interval: "53% (49% to 57%)"."""
    own = [row for row in rows if row["method"] == method]
    found, pairs = (sum(row[key] for row in own) for key in (outcome, "pairs"))
    low, high = wilson_interval(found, pairs)
    return f"{found / pairs:.0%} ({low:.0%} to {high:.0%})"


def chart(rows: Sequence[JsonRow], settings: Settings) -> Chart:
    """Return the chart of outcomes and errors: a line for each kind of pairs and method."""
    own = [row for row in rows if row["method"] == "satviz"]
    every = sum(row["pairs"] for row in own)
    left = every - sum(row["right"] for row in own)
    title = (
        f"SAT in float64 leaves {_share(rows, 'SAT, float64', 'overlap left by rounding')} of pairs overlapping by a "
        f"rounding; {left} of satviz's {every} pushes are wrong (at most {wilson_interval(left, every)[1]:.1%})"
    )
    lines = (
        "Pairs that overlap, pushed apart by each method and then tested exactly. Right: how far the push is off in "
        "direction and in length; from the median (ring) to the worst (dot). In "
        "brackets: the 95 % interval.",
    )
    step = 20.0
    kinds = list(dict.fromkeys(row["kind"] for row in rows))
    places, y = list[float](), 0.0
    for kind in kinds:
        places += [y + 1 + k for k in range(sum(row["kind"] == kind for row in rows))]
        y = places[-1] + 1.4

    def draw(fig: Figure, theme: Theme) -> None:
        """Draw for each method a bar of outcomes and its errors, under the name of each kind of pairs."""
        ink = theme.roles["ink"]

        def panel(left: float, wide: float, heading: str) -> Axes:
            """Add the axes of one column with a heading and return them; left, wide: in points."""
            ax = add_axes(fig, (left, 76, wide, step * y), theme)
            ax.set(ylim=(y - 0.8, -0.6), yticks=[])
            ax.spines["left"].set_visible(False)
            ax.text(0.5, -1.2, heading, ha="center", va="center", fontsize=TEXT_POINTS, color=theme.roles["guide"],
                    transform=ax.get_yaxis_transform())  # fmt: skip
            return ax

        ax = panel(132, 88, "outcome")
        for kind in kinds:
            at = min(place for place, row in zip(places, rows, strict=True) if row["kind"] == kind)
            ax.text(0, at - 1, kind, ha="right", va="center_baseline", fontsize=TEXT_POINTS, fontweight="bold",
                    color=ink, transform=ax.get_yaxis_transform())  # fmt: skip
        for at, row in zip(places, rows, strict=True):
            start = 0.0
            for outcome, (role, hatch) in OUTCOMES.items():
                share = row[outcome] / row["pairs"]
                if not share:
                    continue
                ax.barh(at, share, 0.74, start, color=theme.roles[role], hatch=hatch, edgecolor=theme.paper, lw=0)
                start += share
        ax.set_yticks(places, [row["method"] for row in rows])
        ax.tick_params(axis="y", length=0)
        ax.set(xlim=(0, 1))
        ax.set_xticks([0, 1], ["0", "all"])
        errors = ("angle", 236.0, "direction", [1e-12, 1], ["10⁻¹²°", "1°"], 180.0)
        for column, left, heading, ticks, names, most in (
            errors, ("length", 314.0, "length", [1e-12, 1e-2], ["10⁻¹²", "1 %"], 250.0)
        ):  # fmt: skip
            ax = panel(left, 66, heading)
            for at, row in zip(places, rows, strict=True):
                mid, worst = (max(LEAST_ERROR, row[f"{column}_{which}"]) for which in ("median", "largest"))
                ax.plot([mid, worst], [at, at], color=ink, lw=1, solid_capstyle="butt")
                ax.plot([mid], [at], "o", mec=ink, mfc=theme.paper, ms=5, clip_on=False)
                ax.plot([worst], [at], "o", color=ink, ms=5, clip_on=False)
            ax.set(xscale="log", xlim=(LEAST_ERROR / 4, most * 4))
            ax.set_xticks(ticks, names)
            ax.minorticks_off()
        for k, (outcome, (role, hatch)) in enumerate(OUTCOMES.items()):
            x, up = 8 + 190 * (k % 2), 30 - 18 * (k // 2)
            key = fig.add_axes((*share_of(fig, x, up), *share_of(fig, 12, 10)))
            key.set_facecolor(theme.paper)
            key.barh(0, 1, 1, color=theme.roles[role], hatch=hatch, edgecolor=theme.paper, lw=0)
            key.set(xlim=(0, 1), ylim=(-0.5, 0.5))
            key.axis("off")
            add_text(fig, x + 16, up + 5, outcome, va="center", color=ink)

    text = f"{title}. "
    for row in rows:
        outcomes = ", ".join(f"{row[outcome]:,} {outcome}" for outcome in OUTCOMES if row[outcome])
        text += f"{row['kind']}, {row['method']}: {outcomes} of {row['pairs']:,}; direction off by "
        text += f"{row['angle_median']:.2g}° in the median and {row['angle_largest']:.2g}° at worst, length by "
        text += f"{row['length_median']:.2g} and {row['length_largest']:.2g} of the least push; {row['turned']:,} "
        text += f"pushes are more than {TURNED:g}° off. "
    text += "For concave outlines the least push is computed in floats, so smaller errors than 10⁻¹² are not seen "
    text += "there."
    return Chart("mtv", title, lines, step * y + 108, draw, rows, text)


CHARTS = {"mtv": chart}
