"""Doing no more than needed: the axes that the engine chooses for each kind of pair, against all there are.

All axes of a pair: every edge normal of both shapes, repeats included, and with one
circle the axis from its center to every vertex; of two circles the line of centers;
of concave polygons those of every pair of convex parts.
"""

from collections.abc import Callable, Sequence
from math import cos, hypot, pi, sin
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from ..engine.axes import VERTEX, Axis, Choice, Source, centers, edge_normals
from ..engine.concave import parts
from ..engine.geometry import Relation, Vec
from ..engine.shapes import Circle, Polygon, Shape
from ..engine.trace import Trace, record
from ..engine.verdict import relate
from ..pictures import Theme
from ..scenes.article import box, turned_box
from . import truth
from .cells import Cell, Settings
from .chart import TEXT, Chart, axes, headline
from .workloads import ngons

Rng = np.random.Generator
Pair = tuple[Shape, Shape]
GRID = 2**20
# what is counted, its heading, role, mark and size, and is the mark hollow
COLUMNS = (
    ("all", "all axes", "guide", "o", 9.0, True),
    ("chosen", "chosen by\nthe engine", "float", "o", 6.5, False),
    ("tested", "until the\nearly exit", "exact", "D", 5.0, False),
)


def all_axes(a: Shape, b: Shape) -> Choice:
    """Every edge normal and, for a circle and a polygon, the axis to every vertex: nothing is left out."""
    if isinstance(a, Circle) and isinstance(b, Circle):
        return centers(a, b)
    found = list(edge_normals(a, b).axes)
    if isinstance(a, Circle) or isinstance(b, Circle):
        polygon, circle, role = (a, b, "A") if isinstance(a, Polygon) else (b, a, "B")
        for v, i in zip(polygon.corners, polygon.corner_ids, strict=True):
            arm = Vec(circle.center.x - v.x, circle.center.y - v.y)
            if any(arm):
                found.append(Axis(arm, hypot(*arm), Source(VERTEX, role, (i,))))
    return Choice(tuple(found), complete=True)


def _spot(rng: Rng, reach: int) -> tuple[int, int]:
    x, y = rng.integers(-reach, reach + 1, 2).tolist()
    return x, y


def _upright(rng: Rng) -> Pair:
    found = []
    for _ in "AB":
        (x, y), (w, h) = _spot(rng, 5), rng.integers(1, 7, 2).tolist()
        found.append(box(x, y, x + w, y + h))
    return found[0], found[1]


def _whole_box(rng: Rng, p: int, q: int) -> Polygon:
    """A turned box on whole coordinates, its sides along (p, q) and (-q, p): they are exactly parallel."""
    (x, y), (m, n) = _spot(rng, 14), rng.integers(1, 4, 2).tolist()
    return Polygon([(x, y), (x + m * p, y + m * q), (x + m * p - n * q, y + m * q + n * p), (x - n * q, y + n * p)])


def _alike(rng: Rng) -> Pair:
    return _whole_box(rng, 3, 1), _whole_box(rng, 3, 1)


def _unlike(rng: Rng) -> Pair:
    return _whole_box(rng, 3, 1), _whole_box(rng, 3, 2)


def _rounded(rng: Rng) -> Pair:
    """Boxes turned by one float angle: rounding the corners bends the sides."""
    degrees = rng.uniform(0, 90)
    a, b = (turned_box(rng.uniform(-2, 2, 2).tolist(), *rng.uniform(0.5, 3, 2).tolist(), degrees) for _ in "AB")
    return a, b


def _whole_circle(rng: Rng) -> Circle:
    return Circle(_spot(rng, 8), int(rng.integers(1, 6)))


def _random(rng: Rng, v: int, spread: float) -> Polygon:
    return Polygon(ngons(rng, 1, v, spread)[0])


def _regular(rng: Rng, v: int, turn: float) -> Polygon:
    """A regular polygon on a fine grid about a grid point, so that moving it keeps parallel sides parallel."""
    (x, y), turns = _spot(rng, 6), [turn + 2 * pi * i / v for i in range(v)]
    return Polygon([(x / 4 + round(GRID * cos(t)) / GRID, y / 4 + round(GRID * sin(t)) / GRID) for t in turns])


def _star(rng: Rng, v: int, spread: int) -> Polygon:
    """A star-shaped polygon on whole coordinates: v turns about a point, at two distances by turns."""
    x, y = _spot(rng, spread)
    radii = [int(rng.integers(6, 9)) if i % 2 else int(rng.integers(2, 4)) for i in range(v)]
    return Polygon(
        [(x + round(r * cos(2 * pi * i / v)), y + round(r * sin(2 * pi * i / v))) for i, r in enumerate(radii)]
    )


def _letter(rng: Rng) -> Pair:
    x, y = _spot(rng, 4)
    l_shape = [(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)]
    return _upright(rng)[0], Polygon([(x + px, y + py) for px, py in l_shape])


KINDS: dict[str, Callable[[Rng], Pair]] = {
    "upright boxes": _upright,
    "boxes, same orientation": _alike,
    "boxes, other orientation": _unlike,
    "boxes, one rounded angle": _rounded,
    "circles": lambda rng: (_whole_circle(rng), _whole_circle(rng)),
    "circle and box": lambda rng: (_whole_circle(rng), _whole_box(rng, 3, 1)),
    "circle and triangle": lambda rng: (Circle(rng.uniform(-1, 1, 2), 0.5), _random(rng, 3, 1.0)),
    "triangles": lambda rng: (_random(rng, 3, 0.9), _random(rng, 3, 0.9)),
    "random 8-gons": lambda rng: (_random(rng, 8, 1.5), _random(rng, 8, 1.5)),
    "regular 5-gons, same turn": lambda rng: (_regular(rng, 5, 0.1), _regular(rng, 5, 0.1)),
    "regular 8-gons, same turn": lambda rng: (_regular(rng, 8, 0.1), _regular(rng, 8, 0.1)),
    "regular 8-gons, other turn": lambda rng: (_regular(rng, 8, 0.1), _regular(rng, 8, 0.3)),
    "box and concave L": _letter,
    "two concave stars": lambda rng: (_star(rng, 8, 6), _star(rng, 8, 6)),
}


def counted(kind: str, pairs: int, seed: int) -> dict[str, Any]:
    """Axes a pair (means): all, chosen by the engine, tested until the early exit; and how many answers agree."""
    rng = Settings(seed=seed).rng("doing less", kind)
    total = {"all": 0, "chosen": 0, "tested": 0, "equal": 0, "touching": 0, "hits": 0}
    for _ in range(pairs):
        a, b = KINDS[kind](rng)
        every = [record(p, q, axes=all_axes, every_axis=True) for p in parts(a) for q in parts(b)]
        chosen, quick = record(a, b, every_axis=True), record(a, b)
        answer = relate(a, b)
        by_all = max(trace.claim for trace in every)
        by_truth = max(truth.relation(p, q) for p in parts(a) for q in parts(b))
        total["all"] += sum(len(trace.tests) for trace in every)
        total["chosen"] += tested(chosen)
        total["tested"] += tested(quick)
        total["equal"] += by_all == _claim(chosen) == _claim(quick) == answer == by_truth
        total["touching"] += answer is Relation.TOUCHING
        total["hits"] += answer is not Relation.APART
    means = {key: total.pop(key) / pairs for key in ("all", "chosen", "tested")}
    return {"kind": kind, "pairs": pairs, **means, **total}


def tested(trace: Trace) -> int:
    """The axes tested, for concave outlines over all pairs of parts looked at."""
    return sum(len(pair.tests) for pair in trace.pairs) if trace.pairs else len(trace.tests)


def _claim(trace: Trace) -> Relation:
    return max(pair.claim for pair in trace.pairs) if trace.pairs else trace.claim


def cells(settings: Settings) -> list[Cell]:
    """One for each kind of pair."""
    pairs = 60 if settings.quick else 1500
    return [Cell(f"doing-no-more-{_slug(kind)}", counted, (kind, pairs, settings.seed)) for kind in KINDS]


def _slug(kind: str) -> str:
    return kind.replace(",", "").replace(" ", "-")


def charts(results: dict[str, Any]) -> list[Chart]:
    """One row for each kind of pair, most spared first."""
    rows = [results[f"doing-no-more-{_slug(kind)}"] for kind in KINDS]
    rows = sorted(rows, key=lambda row: (row["chosen"] / row["all"], -row["all"]))
    title = "Doing no more than needed: axes tested for a pair"
    return [
        Chart("doing-no-more", title, (720, 470), lambda fig, theme: _draw(fig, theme, title, rows), rows, _told(rows))
    ]


def _told(rows: Sequence[dict[str, Any]]) -> str:
    most, pairs = rows[0], sum(row["pairs"] for row in rows)
    same = [row["kind"] for row in rows if row["chosen"] == row["all"]]
    equal, touching = (sum(row[key] for row in rows) for key in ("equal", "touching"))
    rounded = next(row for row in rows if row["kind"] == "boxes, one rounded angle")
    spared = f"{_mean(most['chosen'])} of {_mean(most['all'])} axes for {most['kind']}"
    kept = f"{_mean(rounded['chosen'])} of {_mean(rounded['all'])}"
    return (
        f"The engine chooses {spared}, the most it spares; for {_listed(same)} it spares none. "
        f"Boxes turned by one float angle keep {kept}: once their corners are rounded few sides are exactly parallel, "
        "and skipping one that is nearly so could miss a gap. "
        f"All axes, the engine's and those up to the early exit gave the relation that rationals give in {equal:,} of "
        f"{pairs:,} pairs, {touching:,} of them touching."
    )


def _listed(words: Sequence[str]) -> str:
    return " and ".join([", ".join(words[:-1]), words[-1]] if len(words) > 1 else words) or "no kind"


def _mean(value: float) -> str:
    return f"{value:.0f}" if value == round(value) else f"{value:.1f}"


def _draw(fig: Figure, theme: Theme, title: str, rows: Sequence[dict[str, Any]]) -> None:
    headline(fig, theme, title, "means over seeded pairs of each kind; the number of axes on a log scale")
    ax = axes(fig, (0.27, 0.06, 0.44, 0.77), theme)
    for y, row in enumerate(rows):
        ax.plot([row["tested"], row["all"]], [y, y], color=theme.roles["guide"], lw=1, ls=(0, (1, 2.2)), zorder=1)
    at = {"xycoords": ax.get_yaxis_transform(), "fontsize": TEXT, "ha": "center", "parse_math": False}
    for x, (key, heading, role, mark, size, hollow) in zip((1.1, 1.32, 1.54), COLUMNS, strict=True):
        shade, ink = theme.roles[role], theme.text.get(role, theme.roles[role])
        look = {"marker": mark, "ms": size, "mec": shade, "mfc": theme.paper if hollow else shade, "ls": "none"}
        ax.plot([row[key] for row in rows], range(len(rows)), zorder=2 if hollow else 3, **look)
        # each column of numbers is headed by its mark: the two are read together
        ax.plot([x], [-0.95], transform=ax.get_yaxis_transform(), clip_on=False, **look)
        ax.annotate(heading, (x, -1.3), color=ink, va="bottom", annotation_clip=False, **at)
        for y, row in enumerate(rows):
            ax.annotate(_mean(row[key]), (x, y), color=ink, va="center_baseline", annotation_clip=False, **at)
    ax.set_yticks(range(len(rows)), [row["kind"] for row in rows])
    ax.set_ylim(len(rows) - 0.5, -0.5)
    most = max(row["all"] for row in rows)
    ticks = [2**i for i in range(10) if 2**i < most * 1.3]
    ax.set_xscale("log")
    ax.set_xlim(0.8, most * 1.3)
    ax.set_xticks(ticks, [str(tick) for tick in ticks])
    ax.minorticks_off()
    ax.spines["left"].set_visible(False)
    ax.tick_params(axis="y", length=0)
