"""A recommendation in words: each line states one fact with its number.

`summary` is that of the given pairs, `results` the result of each candidate model, `scope` where the proof is valid
(`records.py`, `scope.py`).
"""

from math import inf, log2
from sys import float_info
from typing import TYPE_CHECKING

from .candidates import AABB, BOUNDING_CIRCLES, EXACT_FILTER, K_DOP, Model
from .limits import SECONDS_TIMED
from .records import (
    CONCAVE_POLYGONS,
    SINGULAR,
    UPRIGHT_BOXES,
    InputSummary,
    ModelResult,
    best,
    for_hits,
    model_for_any_position,
)
from .relative_margin import IN_FLOAT32
from .rounding import FLOAT32, FLOAT64, FORMATS
from .scope import ANYWHERE, MOVED, MULTIPLES, Scope

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from .costs import Cost


def text(summary: InputSummary, results: "Sequence[ModelResult]", scope: Scope) -> str:
    """Return the recommendation as lines: the model, why, its scope, the summary, and the other models."""
    least, hits = best(results), for_hits(results)
    lines = [
        f"{label(least.model)}: right for {_all(summary)}",
        *_lines_on_boxes(least.model, summary),
        f"why      {reason(least.model, summary, scope)}",
        f"holds    {validity_sentence(scope, summary)}",
        f"shapes   {describe_shapes(summary)}{' in these pairs' if summary.settled and summary.pairs else ''}",
        f"pairs    {_describe_pairs(summary)}",
        *_lines_on_broad_phase(summary),
    ]
    if summary.pairs:
        lines.append(f"nearest  {describe_nearest(summary)}")
    place = results.index(least)
    lines += [f"less     {_why_not_proven(j, summary)}" for j in results[:place]]
    rest = results[place + 1 :]
    lines += [f"{'more ' if j.proven else 'other'}    {_describe_other(j, summary, results)}" for j in rest]
    if scope.kind != ANYWHERE:
        lines.append(
            f"anywhere {label(model_for_any_position(summary, results))} is right in every position, if the shapes move"
        )
    if hits is not least:
        lines.append(f"hits     {label(hits.model)} is enough to tell hits from misses, where touching is a hit")
    return "\n".join(lines)


def reason(model: Model, summary: InputSummary, scope: Scope) -> str:
    """Return a sentence that says why the model is right."""
    if not summary.pairs and model.kind == AABB:
        return "no two boxes meet, so there is nothing left to test"
    if model.kind == AABB and scope.kind == ANYWHERE:
        return "upright boxes are their bounding boxes, and comparisons round nothing"
    if scope.kind == MULTIPLES:
        return f"all coordinates are {_multiples(scope.unit)}, and {model.kind} rounds nothing of that size"
    return {
        AABB: "the bounding boxes give the same answers as the shapes, and comparing numbers rounds nothing",
        BOUNDING_CIRCLES: "circles from the middle of each box to its farthest corner give the same answers as the "
        "shapes, and rounding errors are too small to change that",
        K_DOP: "the ranges on these directions give the same answers as the shapes, and rounding errors are too "
        "small to change that, or there are none",
        EXACT_FILTER: "where floats cannot decide a pair, it computes with integers",
        **{
            kind: f"the rounding errors of {kind} are too small to change the answer of any pair, or there are none"
            for kind in FORMATS
        },
    }[model.kind]


def validity_sentence(scope: Scope, summary: InputSummary) -> str:
    """Return a sentence that says for which coordinates the recommendation is valid."""
    if scope.kind == ANYWHERE:
        if set(summary.kinds) == {UPRIGHT_BOXES}:
            return "anywhere: upright boxes need y and x only, whatever their coordinates"
        return "anywhere: it is exact for all coordinates"
    if scope.kind == MULTIPLES:
        text = f"any convex polygons with {_multiples(scope.unit)}, up to {_size(scope.bound)}"
        return f"{text}, and edges up to {_size(scope.span)} wide and high" if scope.span else text
    if scope.kind == MOVED:
        return f"the scene moved as a whole, exactly, while no coordinate exceeds {log2_text(scope.bound, 0)}"
    if summary.settled:
        return "these shapes in these positions: it is proven for each pair"
    return (
        "this pair in this position" if summary.pairs == 1 else "these pairs in these positions: it is proven for each"
    )


def _multiples(unit: int | None) -> str:
    """Return what all coordinates are: "whole numbers", or "multiples of" 2**unit."""
    return "whole numbers" if unit == 0 else f"multiples of {_size(2.0 ** (unit or 0))}"


def _size(value: float) -> str:
    """Return a power of two in digits, or as "2^n" where the digits are many."""
    return f"{value:,.15g}" if 2.0**-10 <= value <= 2.0**20 else log2_text(value, 0)


def cost_line(model: Model, summary: InputSummary, found: "Mapping[str, Cost | None]") -> str:
    """Return the line on the cost of the recommended model beside the exact filter; "" where there are no pairs."""
    if not found:
        return ""
    mine = found[model.name]
    exact_name, exact = next((name, p) for name, p in found.items() if name.endswith(EXACT_FILTER))
    after = " whose boxes meet" if summary.settled else ""
    if mine is None:
        return f"cost     not timed: one pair of these shapes takes too long for the {SECONDS_TIMED:g} s of all models"
    text = f"cost     {duration(mine.warm)} a pair{after}, {duration(mine.cold)} with its set-up"
    if model.name == exact_name:
        return text
    return f"{text}; {exact_name} {f'{duration(exact.warm)} and {duration(exact.cold)}' if exact else 'not timed'}"


def duration(nanoseconds: float) -> str:
    """Return a time as text with its unit, to two digits or a whole number."""
    for size, unit in ((1e9, "s"), (1e6, "ms"), (1e3, "µs")):
        if nanoseconds >= size * 0.9995:
            shown = nanoseconds / size
            return f"{shown:.2g} {unit}" if shown < 99.5 else f"{shown:.0f} {unit}"
    return f"{nanoseconds:.2g} ns" if nanoseconds < 99.5 else f"{nanoseconds:.0f} ns"


def label(model: Model) -> str:
    """Return the name of a model, with its number of axes in brackets where the name does not tell it."""
    return model.name if model.kind == K_DOP and not model.after_boxes else f"{model.name} ({axes_text(model.axes)})"


def axes_text(many: int) -> str:
    """Return a number of axes in words: "1 axis", "2 axes"."""
    return f"{many:,} {'axis' if many == 1 else 'axes'}"


def log2_text(value: float, digits: int = 1) -> str:
    """Return a number as text "2^x", x with `digits` decimals; "0" for 0 and "no end" for infinity."""
    return "0" if not value else f"2^{log2(value):.{digits}f}" if value < inf else "no end"


def describe_shapes(summary: InputSummary) -> str:
    """Return a description of the shapes: kinds, corners and sizes."""
    kinds = ", ".join(f"{n:,} {SINGULAR[kind] if n == 1 else kind}" for kind, n in summary.kinds.items())
    low, high = summary.corners
    corners = f", {low} corners" if low == high else f", {low} to {high} corners"
    corners += " in a convex part" if CONCAVE_POLYGONS in summary.kinds else ""
    more = "more than " if summary.size_ratio == float_info.max else ""
    sizes = f", the largest {more}{summary.size_ratio:,.3g} times the smallest" if summary.size_ratio > 1.005 else ""
    return f"{kinds or 'none'}{corners if high else ''}{sizes}"


def _all(summary: InputSummary) -> str:
    """Return "this pair" or "all N pairs"."""
    every = summary.pairs + summary.settled
    return "this pair" if every == 1 else f"all {every:,} pairs"


def _lines_on_broad_phase(summary: InputSummary) -> list[str]:
    """Return a list with the line on the broad phase that suffices; [] unless all pairs of one batch are given."""
    if summary.search is None or summary.pairs + summary.settled == 1:
        return []
    name, compared = summary.search
    every = f"{summary.pairs + summary.settled:,}"
    if name == "grid":
        sweep = "" if compared is None else f", a sweep {compared:,}"
        return [f"search   a grid finds the boxes that meet; comparing all pairs would make {every} comparisons{sweep}"]
    found = f"search   {name} suffices to find the boxes that meet: {compared:,} comparisons"
    return [found if name == "all pairs" else f"{found} instead of {every}"]


def _lines_on_boxes(model: Model, summary: InputSummary) -> list[str]:
    """Return a list with the line on the test of bounding boxes before the model; [] if there is no such test."""
    if not model.after_boxes:
        return []
    sentence = (
        f"{AABB} (2 axes) finds {summary.settled:,} pairs apart; {model.test} decides the other {summary.pairs:,}"
    )
    return [f"first    {sentence}"]


def _describe_pairs(summary: InputSummary) -> str:
    """Return a description of the pairs: how many are apart, touching and overlapping."""
    apart, touching, overlapping = summary.relations
    text = f"{summary.pairs:,}: {apart:,} apart, {touching:,} touching, {overlapping:,} overlapping"
    return text + (f"; {summary.settled:,} more are apart by their boxes" if summary.settled else "")


def describe_nearest(summary: InputSummary) -> str:
    """Return a description of the pair with the smallest relative margin, with that margin in roundings."""
    where = "" if summary.pairs + summary.settled == 1 else f"pair {summary.at} "
    if not summary.relative_margin:
        return f"{where}touches: its relative margin is 0"
    return (
        f"{where}{'has ' if where else ''}a relative margin of {log2_text(summary.relative_margin)} rounding errors of "
        f"float64, {log2_text(summary.relative_margin * IN_FLOAT32)} of float32"
    )


def _why_not_proven(result: ModelResult, summary: InputSummary) -> str:
    """Return a text on why a model is not proven: its wrong and its uncertain pairs."""
    if summary.pairs + summary.settled == 1:
        verdict = "wrong here" if result.wrong else "not proven, as a rounding error could change the answer"
        return f"{label(result.model)}: {verdict}"
    found = []
    if result.wrong:
        found.append(f"wrong on {result.wrong:,}")
    if result.uncertain:
        found.append(f"not proven for {result.uncertain:,}, where a rounding error could change the answer")
    return f"{label(result.model)}: {' and '.join(found)}; the first is pair {result.first}"


def _describe_other(result: ModelResult, summary: InputSummary, results: "Sequence[ModelResult]") -> str:
    """Return a text on a model larger than the recommended one: that it is right too, or why it fails."""
    if not result.proven:
        return _why_not_proven(result, summary)
    adds = "also right, but not needed here"
    if result.model.kind == EXACT_FILTER:
        adds = "right for all coordinates"
    elif result.model.kind == FLOAT64.name and any(j.model.kind == FLOAT32.name and j.proven for j in results):
        adds = "also right, but nothing here needs rounding errors 2^29 times as small"
    return f"{label(result.model)}: {adds}"
