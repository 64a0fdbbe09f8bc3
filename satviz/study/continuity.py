"""Continuity: how far what a method reports jumps when one vertex moves by next to nothing.

A method is stable where its report moves about as far as the vertex did.  The exact
depth of a hit and the distance of a miss do: both are 1-Lipschitz.  A translation
vector cannot always: where two ways out are equally short, one step changes the way.
"""

from collections.abc import Callable, Iterator, Sequence
from math import cos, hypot, inf, nextafter, pi, sin
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from ..engine.axes import Choice, directions
from ..engine.escape import along_axis
from ..engine.geometry import InvalidShape, Vec
from ..engine.sat import AxisTest
from ..engine.shapes import Polygon, centroid
from ..engine.trace import Trace, record
from ..pictures import Theme
from .cells import Cell, Settings
from .chart import TEXT, Chart, axes, headline
from .workloads import ngons

Rng = np.random.Generator
Rings = tuple[NDArray[np.float64], NDArray[np.float64]]
Step = tuple[Polygon, Polygon, Polygon, float]
Quantity = Callable[[Trace], tuple[float, ...]]

MOVES = {"1e-9": 1e-9, "one ulp": 2.0**-51}  # the second only sets the scale of ties: nextafter makes the step
AWAY = 4.0  # from the origin, so that one ulp of any coordinate is about the rounding of a gap
TORN = 10.0  # a jump of more moves than this is no rounding and no steep slope of an everyday shape
LEAST, MOST = 0.1, 1e16  # what is drawn
SQUARE = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])


def _random(rng: Rng, size: float) -> Rings:
    v = int(rng.integers(3, 9))
    return ngons(rng, 1, v, 1.2)[0], ngons(rng, 1, v, 1.2)[0]


def _two_ways_out(rng: Rng, size: float) -> Rings:
    """Equal squares, one moved along the diagonal of the other: up and aside are equally far."""
    d = rng.uniform(0.2, 0.8)
    return SQUARE, np.add(SQUARE, (d, d + rng.uniform(-size, size)))


def _level_centers(rng: Rng, size: float) -> Rings:
    """Triangles with their centroids level along the axis of the way out, so that they do not tell its direction."""
    a, b = ngons(rng, 1, 3, 0.3)[0], ngons(rng, 1, 3, 0.3)[0]
    n = record(Polygon(a), Polygon(b), every_axis=True).tests
    n = np.array(max(n, key=lambda test: test.gap).axis.direction)
    return a, b + n * (n @ (a.mean(axis=0) - b.mean(axis=0)) + rng.uniform(-size, size))


def _about_to_separate(rng: Rng, size: float) -> Rings:
    """Squares apart aside, while upwards, which is tested first, their ranges just touch."""
    return SQUARE, np.add(SQUARE, (1 + rng.uniform(0.2, 1), 1 + rng.uniform(-size, size)))


def _needles(rng: Rng, size: float) -> Rings:
    """A triangle and a needle of length 1 and width 1e-2 to 1e-6."""
    turn, width = rng.uniform(0, 2 * pi), 10.0 ** rng.uniform(-6, -2)
    along, aside = np.array([cos(turn), sin(turn)]), np.array([-sin(turn), cos(turn)])
    tip = rng.uniform(-1, 1, 2)
    return ngons(rng, 1, 3, 0.2)[0], np.array([tip, tip + along, tip + along + aside * width])


TIED, LEVEL = "two ways out, equally short", "centers level"
# (scene, are they hits) -> what makes a pair, given the size of the step
SCENES: dict[tuple[str, bool], Callable[[Rng, float], Rings]] = {
    ("random polygons", True): _random,
    (TIED, True): _two_ways_out,
    (LEVEL, True): _level_centers,
    ("needles", True): _needles,
    ("random polygons", False): _random,
    ("first axis about to separate", False): _about_to_separate,
    ("needles", False): _needles,
}


def _shallowest(trace: Trace) -> AxisTest:
    return max(trace.tests, key=lambda test: test.gap)


def _gap(trace: Trace) -> tuple[float, ...]:
    return (_shallowest(trace).gap,)


def _early_gap(trace: Trace) -> tuple[float, ...]:
    return ((trace.separating or _shallowest(trace)).gap,)


def _distance(trace: Trace) -> tuple[float, ...]:
    """The best gap once the axis through the two nearest vertices is tested too: then it is the distance."""
    arms = (Vec(q.x - p.x, q.y - p.y) for p in trace.a.corners for q in trace.b.corners)
    arm = min((arm for arm in arms if any(arm)), key=lambda arm: hypot(*arm))
    more = directions(arm)(trace.a, trace.b).axes
    return _gap(record(trace.a, trace.b, axes=Choice((*trace.choice.axes, *more)), every_axis=True))


def _mtv(trace: Trace) -> tuple[float, ...]:
    return trace.mtv or (0.0, 0.0)


def _raw_mtv(trace: Trace) -> tuple[float, ...]:
    """The way out along the axis that looks shallowest when the normals keep their edges' lengths."""
    test = max(trace.tests, key=lambda test: test.gap * test.axis.length)
    return (trace.hit and along_axis(trace.a, trace.b, test)) or (0.0, 0.0)


def _centers_mtv(trace: Trace) -> tuple[float, ...]:
    """The right axis and depth, pointing from A's centroid to B's."""
    test, (ax, ay), (bx, by) = _shallowest(trace), centroid(trace.a), centroid(trace.b)
    nx, ny = test.axis.direction
    way = 1 if (bx - ax) * nx + (by - ay) * ny >= 0 else -1
    return way * -test.gap * nx, way * -test.gap * ny


def _shared_range(trace: Trace) -> tuple[float, ...]:
    """min(max) - max(min): how much of the ranges is shared, which is not the depth where one holds the other."""
    ranges = [(test.a.interval, test.b.interval) for test in trace.tests]
    return (min(min(p.hi, q.hi) - max(p.lo, q.lo) for p, q in ranges),)


# by verdict: what is reported, how, and its colour's role
REPORTS: dict[bool, dict[str, tuple[Quantity, str]]] = {
    True: {
        "depth": (_gap, "exact"),
        "shared range": (_shared_range, "float"),
        "MTV": (_mtv, "exact"),
        "MTV, sign from centers": (_centers_mtv, "shortcut"),
        "MTV, raw normals": (_raw_mtv, "shortcut"),
    },
    False: {
        "distance": (_distance, "exact"),
        "best gap": (_gap, "exact"),
        "gap at early exit": (_early_gap, "shortcut"),
    },
}


def jumps(scene: str, hits: bool, move: str, pairs: int, seed: int) -> list[dict[str, Any]]:
    """For each quantity, the jump in moves of the vertex: quantiles over `pairs` pairs, and how many are torn."""
    rng = Settings(seed=seed).rng("continuity", scene, str(hits), move)
    found: dict[str, list[float]] = {name: [] for name in REPORTS[hits]}
    beyond = 0.0
    for a, b, moved, step in _steps(rng, scene, hits, move, pairs):
        before, after = record(a, b, every_axis=True), record(a, moved, every_axis=True)
        for name, (quantity, _) in REPORTS[hits].items():
            jump = hypot(*(p - q for p, q in zip(quantity(before), quantity(after), strict=True)))
            found[name].append(jump / step)
            if name in ("depth", "distance"):
                beyond = max(beyond, jump - step)
    facts = {"scene": scene, "hits": hits, "move": move, "pairs": pairs}
    rows = []
    for name, ratios in found.items():
        middle, most, worst = np.quantile(ratios, (0.5, 0.99, 1)).tolist()
        torn = sum(ratio > TORN for ratio in ratios)
        row = {**facts, "quantity": name, "median": middle, "p99": most, "worst": worst, "torn": torn}
        # of the two that are 1-Lipschitz: how far the jump went beyond the move, in scene units
        rows.append(row | ({"beyond": beyond} if name in ("depth", "distance") else {}))
    return rows


def _steps(rng: Rng, scene: str, hits: bool, move: str, pairs: int) -> Iterator[Step]:
    """A, B, B with one vertex moved, and how far it moved, for as many pairs of the asked verdict."""
    make, done = SCENES[scene, hits], 0
    while done < pairs:
        ring_a, ring_b = (ring + AWAY for ring in make(rng, MOVES[move]))
        at, moved = int(rng.integers(len(ring_b))), ring_b.copy()
        if move == "one ulp":
            d = int(rng.integers(2))
            moved[at, d] = nextafter(moved[at, d], rng.choice((-inf, inf)))
        else:
            turn = rng.uniform(0, 2 * pi)
            moved[at] += MOVES[move] * np.array([cos(turn), sin(turn)])
        try:
            a, b, c = Polygon(ring_a), Polygon(ring_b), Polygon(moved)
        except InvalidShape:
            continue
        if b.is_convex and c.is_convex and record(a, b).hit is hits:
            done += 1
            yield a, b, c, hypot(*(moved[at] - ring_b[at]))


def cells(settings: Settings) -> list[Cell]:
    """One for each scene and size of the step."""
    pairs = 150 if settings.quick else 2500
    return [
        Cell(_name(scene, hits, move), jumps, (scene, hits, move, pairs, settings.seed))
        for scene, hits in SCENES
        for move in MOVES
    ]


def _name(scene: str, hits: bool, move: str) -> str:
    words = f"continuity {'hits' if hits else 'misses'} {scene} {move}"
    return words.replace(",", "").replace(" ", "-")


def charts(results: dict[str, Any]) -> list[Chart]:
    """A panel for each scene, hits above, misses below."""
    rows = [row for scene, hits in SCENES for move in MOVES for row in results[_name(scene, hits, move)]]
    title = "Continuity: how far a report jumps when one vertex moves by next to nothing"
    size = 1080.0, 520.0
    return [Chart("continuity", title, size, lambda fig, theme: _draw(fig, theme, title, rows), rows, _told(rows))]


def _told(rows: Sequence[dict[str, Any]]) -> str:
    def some(*names: str, **facts: Any) -> list[dict[str, Any]]:
        return [r for r in rows if r["quantity"] in names and all(r[k] == v for k, v in facts.items())]

    def torn(*names: str, **facts: Any) -> str:
        mine = some(*names, **facts)
        return f"{sum(r['torn'] for r in mine):,} of {sum(r['pairs'] for r in mine):,}"

    def worst(*names: str, **facts: Any) -> str:
        return times(max(r["worst"] for r in some(*names, **facts)))

    far = max(r["beyond"] for r in some("depth", "distance"))
    sound = worst("depth", "distance", move="1e-9")
    tied, by_engine = torn("MTV", scene=TIED), torn("MTV", scene=LEVEL)
    by_centers = torn("MTV, sign from centers", scene=LEVEL)
    best, early = worst("best gap", scene="needles"), worst("gap at early exit")
    raw, unit = (worst(name, scene="needles") for name in ("MTV, raw normals", "MTV"))
    return (
        "The exact depth of a hit and the distance of a miss never moved further than the vertex by more than "
        f"{far:.1e}, a rounding; where it moved by 1e-9, they moved at most {sound} as far. "
        f"The best gap on edge normals is only a bound of the distance: beside needles it moves up to {best} as far as "
        f"the vertex, and the gap at the early exit up to {early}, where another axis ends the search. "
        f"Where two ways out are equally short the engine's MTV changes the way in {tied} steps, as any MTV must; "
        f"its sign taken from the centers tears it in {by_centers} where they are level, against {by_engine}. "
        f"Raw normals choose an MTV that moves up to {raw} as far as the needle's vertex, against {unit}."
    )


def times(ratio: float) -> str:
    """How many times as far as the vertex."""
    return f"{ratio:.1f} times" if ratio < 1000 else f"{ratio:.0e} times".replace("e+0", "e").replace("e+", "e")


def _draw(fig: Figure, theme: Theme, title: str, rows: Sequence[dict[str, Any]]) -> None:
    headline(fig, theme, title, "how far the report moved, divided by how far the vertex did (log scale)")
    for hits, bottom, height in (True, 0.42, 0.4), (False, 0.075, 0.22):
        names = list(REPORTS[hits])
        for column, scene in enumerate(scene for scene, verdict in SCENES if verdict is hits):
            ax = axes(fig, (0.165 + 0.21 * column, bottom, 0.19, height), theme, scene)
            mine = [row for row in rows if row["scene"] == scene and row["hits"] is hits]
            _panel(ax, theme, mine, hits)
            ax.set_yticks(range(len(names)), names if column == 0 else [""] * len(names))
        at = {"color": theme.roles["guide"], "fontsize": TEXT + 1, "va": "bottom"}
        fig.text(0.012, bottom + height, "hits" if hits else "misses", **at)
    _key(fig.add_axes((0.165 + 0.21 * 3, 0.075, 0.19, 0.22)), theme)


def _panel(ax: Axes, theme: Theme, rows: Sequence[dict[str, Any]], hits: bool) -> None:
    ax.axvline(1, color=theme.roles["guide"], lw=1, ls=(0, (1, 2.2)))
    for y, (name, (_, role)) in enumerate(REPORTS[hits].items()):
        shade, mine = theme.roles[role], [row for row in rows if row["quantity"] == name]
        for row in mine:
            _bar(ax, y + (0.1 if row["move"] == "1e-9" else 0.36), row, shade, theme.paper)
        torn = sum(row["torn"] for row in mine) / sum(row["pairs"] for row in mine)
        if torn:
            words, ink = f"{torn:.1%} torn", theme.text.get(role, shade)
            ax.text(MOST, y - 0.16, words, color=ink, fontsize=TEXT, ha="right", va="center_baseline", parse_math=False)
    ax.set(xscale="log", xlim=(LEAST, MOST), ylim=(len(REPORTS[hits]) - 0.4, -0.45))
    ax.set_xticks([1, 1e5, 1e10, 1e15], ["1", "1e5", "1e10", "1e15"])
    ax.minorticks_off()
    ax.spines["left"].set_visible(False)
    ax.tick_params(axis="y", length=0)


def _bar(ax: Axes, y: float, row: dict[str, Any], shade: str, paper: str) -> None:
    """From the median to the worst, a tick at 99 %; what did not move is put at the rim."""
    low, tick, high = (max(LEAST, row[key]) for key in ("median", "p99", "worst"))
    small = row["move"] == "one ulp"
    ax.plot([low, high], [y, y], color=shade, lw=1.6)
    ax.plot([tick], [y], "|", color=shade, ms=7, mew=1.6)
    ax.plot([high], [y], "s" if small else "o", mec=shade, mfc=paper if small else shade, ms=5.5, mew=1.4)


def _key(ax: Axes, theme: Theme) -> None:
    """How to read a bar, in the place that is left."""
    ax.set_axis_off()
    ax.set(xscale="log", xlim=(LEAST, MOST), ylim=(2.6, -0.45))
    ink = {"color": theme.roles["guide"], "fontsize": TEXT, "va": "center_baseline", "parse_math": False}
    for y, move in (0.3, "1e-9"), (0.75, "one ulp"):
        _bar(ax, y, {"move": move, "median": 1, "p99": 1e4, "worst": 1e7}, theme.roles["guide"], theme.paper)
        ax.text(4e7, y, f"moved by {move}", **ink)
    for x, words in (1, "median"), (1e4, "99 %"), (1e7, "worst"):
        ax.text(x, -0.15, words, ha="center", **ink)
    ax.text(LEAST, 1.35, "dotted line: as far as the vertex", **ink)
    ax.text(LEAST, 1.85, f"torn: more than {TORN:.0f} times as far", **ink)
