"""An advice in words: each line a fact with a number."""

from math import inf, log2
from sys import float_info
from typing import TYPE_CHECKING

from .certified_bounds import BOXES, CIRCLES, DIRECTIONS, EXACT, Model
from .facts import CONCAVE, CONVEX, ROUND, UPRIGHT, Facts, ModelResult, anywhere, best, for_hits
from .limits import SECONDS
from .relative_margin import IN_FLOAT32
from .rounding import FLOAT32, FLOAT64, FORMATS
from .scope import ANYWHERE, GRID, MOVED, Scope

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from .costs import Cost

ONE = {UPRIGHT: "upright box", ROUND: "circle", CONVEX: "convex polygon", CONCAVE: "concave polygon"}


def told(facts: Facts, judged: "Sequence[ModelResult]", scope: Scope) -> str:
    """The whole advice, a line each: what is advised, why, how far, what there is, what less and more would give."""
    least, hits = best(judged), for_hits(judged)
    lines = [
        f"{named(least.model)}: right for {_all(facts)}",
        *_first(least.model, facts),
        f"why      {reason(least.model, facts, scope)}",
        f"holds    {holds(scope, facts)}",
        f"shapes   {shapes(facts)}{' in these pairs' if facts.settled and facts.pairs else ''}",
        f"pairs    {_pairs(facts)}",
    ]
    if facts.pairs:
        lines.append(f"nearest  {nearest(facts)}")
    place = judged.index(least)
    lines += [f"less     {_fails(j, facts)}" for j in judged[:place]]
    rest = judged[place + 1 :]
    lines += [f"{'more ' if j.proven else 'other'}    {_adds(j, facts, judged)}" for j in rest]
    if scope.kind != ANYWHERE:
        lines.append(f"anywhere {named(anywhere(facts, judged))} is right in every position, if the shapes move")
    if hits is not least:
        lines.append(f"hits     {named(hits.model)} is enough to tell hits from misses, where touching is a hit")
    return "\n".join(lines)


def reason(model: Model, facts: Facts, scope: Scope) -> str:
    """Why the model is right."""
    if not facts.pairs and model.kind == BOXES:
        return "no two boxes meet, so there is nothing left to ask"
    if model.kind == BOXES and scope.kind == ANYWHERE:
        return "upright boxes are their bounding boxes, and comparisons round nothing"
    if scope.kind == GRID:
        return f"all coordinates are {_multiples(scope.unit)}, and {model.kind} rounds nothing of that size"
    return {
        BOXES: "the bounding boxes give the same answers as the shapes, and comparing numbers rounds nothing",
        CIRCLES: "circles from the middle of each box to its farthest corner give the same answers as the shapes, and "
        "rounding errors are too small to change that",
        DIRECTIONS: "the ranges on these directions give the same answers as the shapes, and rounding errors are too "
        "small to change that, or there are none",
        EXACT: "where floats cannot decide a pair, it computes with integers",
        **{
            kind: f"the rounding errors of {kind} are too small to change the answer of any pair, or there are none"
            for kind in FORMATS
        },
    }[model.kind]


def holds(scope: Scope, facts: Facts) -> str:
    """Where it holds."""
    if scope.kind == ANYWHERE:
        if set(facts.kinds) == {UPRIGHT}:
            return "anywhere: upright boxes need y and x only, whatever their coordinates"
        return "anywhere: it is exact for all coordinates"
    if scope.kind == GRID:
        text = f"any convex polygons with {_multiples(scope.unit)}, up to {_size(scope.bound)}"
        return f"{text}, and edges up to {_size(scope.span)} wide and high" if scope.span else text
    if scope.kind == MOVED:
        return f"the scene moved as a whole, exactly, while no coordinate exceeds {power(scope.bound, 0)}"
    if facts.settled:
        return "these shapes in these positions: it is proven for each pair"
    return "this pair in this position" if facts.pairs == 1 else "these pairs in these positions: it is proven for each"


def _multiples(unit: int | None) -> str:
    return "whole numbers" if unit == 0 else f"multiples of {_size(2.0 ** (unit or 0))}"


def _size(value: float) -> str:
    """A power of two as a number, where that can be read."""
    return f"{value:,.15g}" if 2.0**-10 <= value <= 2.0**20 else power(value, 0)


def price(model: Model, facts: Facts, found: "Mapping[str, Cost | None]") -> str:
    """What the recommended model costs here, beside the exact filter; empty where there are no pairs."""
    if not found:
        return ""
    mine = found[model.name]
    exact_name, exact = next((name, p) for name, p in found.items() if name.endswith(EXACT))
    after = " whose boxes meet" if facts.settled else ""
    if mine is None:
        return f"price    not timed: one pair of these shapes takes too long for the {SECONDS:g} s of all models"
    text = f"price    {duration(mine.warm)} a pair{after}, {duration(mine.cold)} with its set-up"
    if model.name == exact_name:
        return text
    return f"{text}; {exact_name} {f'{duration(exact.warm)} and {duration(exact.cold)}' if exact else 'not timed'}"


def duration(nanoseconds: float) -> str:
    """A time with its unit, two digits."""
    for size, unit in ((1e9, "s"), (1e6, "ms"), (1e3, "µs")):
        if nanoseconds >= size * 0.9995:
            shown = nanoseconds / size
            return f"{shown:.2g} {unit}" if shown < 99.5 else f"{shown:.0f} {unit}"
    return f"{nanoseconds:.2g} ns" if nanoseconds < 99.5 else f"{nanoseconds:.0f} ns"


def named(model: Model) -> str:
    """A model's name and how many axes it has."""
    return model.name if model.kind == DIRECTIONS and not model.after_boxes else f"{model.name} ({axes(model.axes)})"


def axes(many: int) -> str:
    """How many axes."""
    return f"{many:,} {'axis' if many == 1 else 'axes'}"


def power(value: float, digits: int = 1) -> str:
    """A number as a power of two."""
    return "0" if not value else f"2^{log2(value):.{digits}f}" if value < inf else "no end"


def shapes(facts: Facts) -> str:
    """What there is."""
    kinds = ", ".join(f"{n:,} {ONE[kind] if n == 1 else kind}" for kind, n in facts.kinds.items())
    low, high = facts.corners
    corners = f", {low} corners" if low == high else f", {low} to {high} corners"
    corners += " in a convex part" if "concave polygons" in facts.kinds else ""
    more = "more than " if facts.sizes == float_info.max else ""
    sizes = f", the largest {more}{facts.sizes:,.3g} times the smallest" if facts.sizes > 1.005 else ""
    return f"{kinds or 'none'}{corners if high else ''}{sizes}"


def _all(facts: Facts) -> str:
    every = facts.pairs + facts.settled
    return "this pair" if every == 1 else f"all {every:,} pairs"


def _first(model: Model, facts: Facts) -> list[str]:
    """What runs before the model's own test, and how many pairs it leaves."""
    if not model.after_boxes:
        return []
    said = f"{BOXES} (2 axes) finds {facts.settled:,} pairs apart; {model.test} decides the other {facts.pairs:,}"
    return [f"first    {said}"]


def _pairs(facts: Facts) -> str:
    apart, touching, overlapping = facts.relations
    text = f"{facts.pairs:,}: {apart:,} apart, {touching:,} touching, {overlapping:,} overlapping"
    return text + (f"; {facts.settled:,} more are apart by their boxes" if facts.settled else "")


def nearest(facts: Facts) -> str:
    """The pair that is hardest to tell, in roundings."""
    where = "" if facts.pairs + facts.settled == 1 else f"pair {facts.at} "
    if not facts.gamma:
        return f"{where}touches: its margin (gamma) is 0"
    return (
        f"{where}{'has ' if where else ''}a margin of {power(facts.gamma)} rounding errors of float64 (its gamma), "
        f"{power(facts.gamma * IN_FLOAT32)} of float32"
    )


def _fails(judged: ModelResult, facts: Facts) -> str:
    if facts.pairs + facts.settled == 1:
        said = "wrong here" if judged.wrong else "not proven, as a rounding error could change the answer"
        return f"{named(judged.model)}: {said}"
    found = []
    if judged.wrong:
        found.append(f"wrong on {judged.wrong:,}")
    if judged.unsure:
        found.append(f"not proven for {judged.unsure:,}, where a rounding error could change the answer")
    return f"{named(judged.model)}: {' and '.join(found)}; the first is pair {judged.first}"


def _adds(judged: ModelResult, facts: Facts, every: "Sequence[ModelResult]") -> str:
    if not judged.proven:
        return _fails(judged, facts)
    adds = "also right, but not needed here"
    if judged.model.kind == EXACT:
        adds = "right for all coordinates"
    elif judged.model.kind == FLOAT64.name and any(j.model.kind == FLOAT32.name and j.proven for j in every):
        adds = "also right, but nothing here needs rounding errors 2^29 times as small"
    return f"{named(judged.model)}: {adds}"
