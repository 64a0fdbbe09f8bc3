"""The relative margin: how near to touching a pair must be before a method can be wrong.

The relative margin is the distance from touching, counted in rounding errors (`satviz/advice/relative_margin.py`).
Question: up to which relative margin is each method wrong, and how often?  Workload: pairs made hard in seven ways (in
a quick run in six), about equally many in each factor of 2 of the margin, pairs that touch exactly, and circles.
Methods: upright boxes, SAT in float32 and in float64, GJK, shapely and satviz, and for circles the comparison of
squares.  A sample shows how often a method is wrong, a search (`adversary`) how far, and a proof where that ends.  The
claim is refuted by a wrong answer of SAT in float64 above its proven margin, while no product of coordinates leaves the
range of float64.
"""

from collections.abc import Sequence
from itertools import groupby
from math import ceil, log2
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from ... import batch
from ...engine.shapes import Circle, Polygon
from ...pictures import Theme
from ...render.chart import TEXT_POINTS, WIDTH, Chart, JsonRow, add_axes
from .. import truth
from ..harness.cells import Cell, Settings
from ..harness.chart import family_colour, wilson_interval
from ..methods import (
    COMPILED,
    Method,
    all_methods,
    answers_by_method,
    batch_shapes,
    true_relations,
    wrong_answers,
)
from ..workloads.adversary import search_size, worst_pair, worst_shapes_within_two
from ..workloads.generators import CircleArrays
from ..workloads.hard_pairs import (
    HARD_KINDS,
    MARGIN_OCTAVES,
    hard_circles,
    hard_pairs,
    margins_of,
    octave_of,
    touching_quadrilaterals,
)
from .speed_against_accuracy import PROVEN_MARGINS

SHAPES, CIRCLES, TOUCHING = "polygons", "circles", "touching"
# the squares of the distance and of the sum of radii carry 7 roundings, the distance 3.5, and it is below 3 reaches
CIRCLE_MARGIN = 11
NEAR = 8  # relative margin: pairs below it are counted in the title
ROWS = (  # (what is tested, method), from the top
    (SHAPES, "AABB"), (SHAPES, "SAT, float32"), (SHAPES, "SAT, unit normals"),
    (SHAPES, "SAT, raw normals"), (SHAPES, "GJK"), (SHAPES, "shapely"), (SHAPES, "satviz"),
    (CIRCLES, "squares, float64"), (CIRCLES, "shapely"), (CIRCLES, "satviz"),
)  # fmt: skip
SEARCHED = tuple(name for what, name in ROWS if what == SHAPES and name not in ("AABB", "satviz"))
FLOAT32_BEYOND = {"2^70 times as large": (2.0**70, 0.0, 0.5), "2^25 away from the origin": (1.0, 2.0**25, 2.0**21)}


def cells(settings: Settings) -> list[Cell]:
    """Return the cells: counts on each kind of hard pairs, on touches and on circles, and a search for each method."""
    per_octave = 3 if settings.quick else 60
    found = [
        Cell(f"margin-{kind.name.replace(' ', '-')}", count_by_margin, (k, per_octave, settings))
        for k, kind in enumerate(HARD_KINDS)
        if not (settings.quick and kind.name == "24 corners")  # kernels are compiled for them alone
    ]
    found += [Cell("margin-circles", count_circles, (per_octave * 3, settings))]
    found += [Cell("search-circles", search_circles, (*search_size(CIRCLES, settings), settings))]
    found += [Cell("margin-touching", count_touching, (200 if settings.quick else 4000, settings))]
    found += [Cell("margin-float32", float32_beyond, (settings,))]
    return found + [
        Cell(
            f"search-{name.replace(' ', '-').replace(',', '')}", search, (name, *search_size(name, settings), settings)
        )
        for name in SEARCHED
    ]


def _methods() -> list[Method]:
    """Return the compiled methods that have a strip for polygons in the chart."""
    return [m for m in all_methods() if m.language == COMPILED and (SHAPES, m.name) in ROWS]


def count_by_margin(kind: int, per_octave: int, settings: Settings) -> list[JsonRow]:
    """Return each method's wrong answers on pairs of HARD_KINDS[kind], by octave of the relative margin."""
    a, b, margin = hard_pairs(HARD_KINDS[kind], settings.rng("hard", HARD_KINDS[kind].name), per_octave)
    right = true_relations(a, b)
    return [_counted(SHAPES, m, wrong_answers(answers, right), margin)
            for m, answers in answers_by_method(_methods(), a, b)]  # fmt: skip


def count_touching(n: int, settings: Settings) -> list[JsonRow]:
    """Return each method's wrong answers on pairs of 4-gons that touch exactly."""
    a, b = touching_quadrilaterals(settings.rng("margin-touching"), n)
    right = true_relations(a, b)
    return [{"what": SHAPES, "method": m.name, "pairs": n, "wrong": int(wrong_answers(answers, right).sum())}
            for m, answers in answers_by_method(_methods(), a, b)]  # fmt: skip


def _squares(a: CircleArrays, b: CircleArrays) -> Any:
    """Return a mask of the circles that hit, by the squares of distance and sum of the radii, in float64."""
    (dx, dy), reach = (a[0] - b[0]).T, a[1] + b[1]
    return dx * dx + dy * dy <= reach * reach


def count_circles(per_octave: int, settings: Settings) -> list[JsonRow]:
    """Return each method's wrong answers on pairs of circles, by octave of the relative margin."""
    a, b, margin = hard_circles(settings.rng("circles"), per_octave)
    right = true_relations(a, b)
    return [_counted(CIRCLES, m, wrong_answers(answers, right), margin)
            for m, answers in answers_by_method(_circle_methods(), a, b)]  # fmt: skip


def _circle_methods() -> list[Method]:
    """Return the compiled methods that have a strip for circles in the chart, and `_squares` as one."""
    methods = [m for m in all_methods(circles=True) if m.language == COMPILED]
    return [*methods, Method("squares, float64", COMPILED, "float SAT", lambda side: side, _squares, circles=True)]


def search_circles(n: int, generations: int, settings: Settings) -> list[JsonRow]:
    """Return for each method the largest relative margin at which it is wrong about circles, confirmed by both oracles.

    The centers of a pair lie in opposite corners of a square, just above a power of two apart along both axes, and most
    circles are equally large: there the roundings of a distance are largest beside the largest coordinate.
    """
    rng = settings.rng("search", CIRCLES)
    worst = {m.name: {"method": m.name, "margin": 0.0, "tried": n * generations} for m in _circle_methods()}
    for _ in range(generations):
        size = rng.choice([0.5, 0.5**0.5], (n, 1)) * rng.uniform(1, 1.01, (n, 1))
        at, to = -size * rng.uniform(0.998, 1.002, (n, 2)), size * rng.uniform(0.998, 1.002, (n, 2))
        away = np.sqrt(((to - at) ** 2).sum(axis=1))
        radius = away * np.where(rng.random(n) < 0.8, rng.uniform(0.495, 0.505, n), rng.uniform(0, 0.5, n))
        rest = away - radius + rng.uniform(-CIRCLE_MARGIN, CIRCLE_MARGIN, n) * 2.0**-53 * size[:, 0]
        a, b = (at, radius), (to, rest)
        right, margin = batch.relate(batch_shapes(a), batch_shapes(b), engine="numpy"), None
        for method, answers in answers_by_method(_circle_methods(), a, b):
            wrong = np.flatnonzero((answers > 0) != (right > 0))
            if len(wrong):
                margin = margins_of(batch_shapes(a), batch_shapes(b)) if margin is None else margin
                k = wrong[margin[wrong].argmax()]
                own = [Circle(side[0][k].tolist(), float(side[1][k])) for side in (a, b)]
                if margin[k] > worst[method.name]["margin"]:
                    worst[method.name] |= {"margin": float(margin[k]), "relation": truth.agreed(*own).name}
    return list(worst.values())


def _counted(what: str, method: Method, wrong: Any, margin: Any) -> JsonRow:
    """Return the row of one method: pairs and wrong answers by octave, and the largest margin of a wrong answer.

    what: the kind of pairs; wrong: (n,) mask of the wrong answers; margin: (n,) relative margins.
    """
    bins = np.clip(octave_of(margin) - MARGIN_OCTAVES.start, 0, len(MARGIN_OCTAVES) - 1)
    row: JsonRow = {"what": what, "method": method.name, "family": method.family}
    row |= {"pairs": len(wrong), "wrong": int(wrong.sum()), "largest": float(max(margin[wrong], default=0.0))}
    row["pairs_by_octave"] = np.bincount(bins, minlength=len(MARGIN_OCTAVES)).tolist()
    row["wrong_by_octave"] = np.bincount(bins[wrong], minlength=len(MARGIN_OCTAVES)).tolist()
    return row


def search(name: str, n: int, generations: int, settings: Settings) -> JsonRow:
    """Return a row: the largest relative margin at which a search finds a method wrong, and that pair.

    Both oracles confirm it.  n, generations: as in `worst_pair`.
    """
    (method,) = (m for m in all_methods() if (m.language, m.name) == (COMPILED, name))
    found = worst_pair(method, worst_shapes_within_two, settings.rng("search", name), n, generations, metres=False)
    row: JsonRow = {"method": name, "margin": found.margin, "tried": found.tried}
    if found.margin:
        a, b = Polygon(found.a[0]), Polygon(found.b[0])
        row |= {"relation": truth.agreed(a, b).name, "a": found.a[0].tolist(), "b": found.b[0].tolist()}
    return row


def float32_beyond(settings: Settings) -> list[JsonRow]:
    """Return the relative margins of two pairs of boxes apart, and whether float32 calls each a hit.

    float32 holds neither the products of the first nor the coordinates of the second.
    """
    box, answered = np.array([[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]]), []
    (method,) = (m for m in all_methods() if m.name == "SAT, float32")
    for words, (scale, away, gap) in FLOAT32_BEYOND.items():
        a, b = (box + away) * scale, (box + np.array([1 + gap, 0]) + away) * scale
        ((_, answers),) = answers_by_method([method], a, b)
        answered.append({"where": words, "margin": float(margins_of(batch_shapes(a), batch_shapes(b))[0]),
                     "wrong": bool(wrong_answers(answers, true_relations(a, b))[0])})  # fmt: skip
    return answered


def rows(found: dict[str, Any]) -> dict[str, list[JsonRow]]:
    """Return {stem of the chart: its rows}: one for each strip, with counts by octave and the largest margins.

    Then follow the rows of `float32_beyond`.  found: the results of all cells by their names.
    """
    counted = [row for name, own in found.items() if name.startswith("margin-") and name != "margin-float32"
               for row in own if "family" in row]  # fmt: skip
    strips = []
    for what, name in ROWS:
        own = [row for row in counted if (row["what"], row["method"]) == (what, name)]
        if not own:
            continue
        pairs, wrong = (np.sum([row[f"{key}_by_octave"] for row in own], axis=0).tolist() for key in ("pairs", "wrong"))
        row: JsonRow = {"what": what, "method": name, "family": own[0]["family"]}
        row |= {"pairs": pairs, "wrong": wrong, "largest_in_sample": max(row["largest"] for row in own)}
        if what == SHAPES:
            (touch,) = (r for r in found["margin-touching"] if r["method"] == name)
            row |= {"touches": touch["pairs"], "touches_wrong": touch["wrong"]}
            row["proven"] = 0 if name == "satviz" else PROVEN_MARGINS.get(name)
        else:
            row["proven"] = CIRCLE_MARGIN if "squares" in name else 0 if name == "satviz" else None
        searches = [r for key, r in found.items() if key.startswith("search-") and key != "search-circles"]
        searched = [r for r in (searches if what == SHAPES else found["search-circles"]) if r["method"] == name]
        row["tried"] = sum(r["tried"] for r in searched)
        row["worst"] = max([row["largest_in_sample"], *(r["margin"] for r in searched)])
        strips.append(row)
    compiled = any((row["what"], row["method"]) == (SHAPES, "SAT, raw normals") for row in strips)
    return {"relative-margin": [*strips, *found["margin-float32"]] if compiled else []}


def chart(rows: Sequence[JsonRow], settings: Settings) -> Chart:
    """Return the chart of strips, one for each method, along the relative margin."""
    strips = [row for row in rows if "family" in row]
    beyond = [row for row in rows if "where" in row]
    by = {(row["what"], row["method"]): row for row in strips}
    raw = by[SHAPES, "SAT, raw normals"]
    near = sum(2 ** (k + 1) <= NEAR for k in MARGIN_OCTAVES)
    pairs, wrong = (sum(raw[key][:near]) for key in ("pairs", "wrong"))
    low, high = wilson_interval(wrong, pairs)
    title = (
        f"SAT with raw normals in float64 was found wrong up to {raw['worst']:.1f} roundings from touching; above "
        f"{raw['proven']} it is proven right"
    )
    lines = (
        "Strong: half of the answers are wrong, no better than a coin. Faint: none of this sample is wrong. "
        "▲ the worst that a sample or a search found; at the right edge the sample ends. | proven right beyond, while "
        "no product leaves the range of float64.",
    )
    tall = 22.0 * (len(strips) + 1)

    def draw(fig: Figure, theme: Theme) -> None:
        """Draw a strip of octaves for each method, and before it a field for exact touches."""
        ax = add_axes(fig, (162, 50, WIDTH - 174, tall + 14), theme)
        places = [k + (k >= sum(row["what"] == SHAPES for row in strips)) for k in range(len(strips))]
        for y, row in zip(places, strips, strict=True):
            shade = family_colour(theme, row["family"])
            shares = [(float(k), w / p if p else 0.0) for k, w, p in zip(MARGIN_OCTAVES, row["wrong"], row["pairs"])]
            if row["what"] == SHAPES:
                shares.append((TOUCH_AT, row["touches_wrong"] / row["touches"]))
            for (percent, _), same in groupby(shares, lambda pair: (ceil(100 * pair[1]), pair[0] == TOUCH_AT)):
                xs = [x for x, _ in same]
                alpha = 0.2 + 0.8 * min(1.0, percent / 50) if percent else 0.07
                ax.add_patch(Rectangle((xs[0], y - 0.36), xs[-1] + 1 - xs[0], 0.72, fc=shade, alpha=alpha, lw=0))
            if row["worst"] > 2.0**MARGIN_OCTAVES.start:
                worst = min(log2(row["worst"]), MARGIN_OCTAVES.stop - 0.3)
                ax.plot([worst], [y], "^", color=theme.roles["ink"], mec=theme.paper, ms=8, clip_on=False)
            if row["proven"]:
                ax.plot([log2(row["proven"])], [y], "|", color=theme.roles["ink"], ms=15, mew=2)
                ax.text(log2(row["proven"]) + 1, y, f"found {row['worst']:.1f}, proven {row['proven']}", va="center",
                        color=theme.roles["ink"], fontsize=TEXT_POINTS)  # fmt: skip
        ax.set(xlim=(TOUCH_AT - 0.4, MARGIN_OCTAVES.stop), ylim=(places[-1] + 0.6, -0.6))
        ax.set_xticks([TOUCH_AT - 0.2, 0, 10, 20, 30], ["touch", "1", "2¹⁰", "2²⁰", "2³⁰"])
        ax.set_yticks(
            places, [row["method"] if row["what"] == SHAPES else f"circles: {row['method']}" for row in strips]
        )
        ax.tick_params(axis="y", length=0)
        ax.spines["left"].set_visible(False)
        ax.set_xlabel("relative margin, in roundings of float64", fontsize=TEXT_POINTS)

    text = f"{title}. Of these pairs within {NEAR} roundings it is wrong about {wrong / pairs:.0%} ({low:.0%} to "
    text += f"{high:.0%}). In brackets: the 95 % interval. "
    for row in strips:
        pairs, wrong = sum(row["pairs"]), sum(row["wrong"])
        low, high = wilson_interval(wrong, pairs)
        text += f"{row['method']} ({row['what']}): {wrong:,} of {pairs:,} wrong ({low:.2%} to {high:.2%})"
        text += f", up to a margin of {row['worst']:.3g}" if row["worst"] else ""
        text += f", {row['touches_wrong']:,} of {row['touches']:,} touches wrong. " if "touches" in row else ". "
    for row in beyond:
        text += f"float32 is {'wrong' if row['wrong'] else 'right'} about boxes {row['where']}, at a margin of 2^"
        text += f"{log2(row['margin']):.0f}: "
        text += "no relative margin is enough there. "
    return Chart("relative-margin", title, lines, tall + 72, draw, rows, text.strip())


CHARTS = {"relative-margin": chart}


TOUCH_AT = MARGIN_OCTAVES.start - 2.5  # position of the field for exact touches, in octaves
