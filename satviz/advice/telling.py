"""An advice in words: each line a fact with a number."""

from math import inf, log2
from typing import TYPE_CHECKING

from .gamma import IN_FLOAT32
from .proofs import DIRECTIONS, EXACT, FLOAT64

if TYPE_CHECKING:
    from .advising import Advice, Facts, Judged
    from .proofs import Model

ONE = {
    "upright boxes": "upright box",
    "circles": "circle",
    "convex polygons": "convex polygon",
    "concave polygons": "concave polygon",
}


def told(advice: "Advice") -> str:
    """The whole advice, a line each: what is advised, why, how far, what there is, what less and more would give."""
    facts, best = advice.facts, advice.best
    lines = [
        f"{title(best)}: right for {_all(facts)}",
        f"why      {advice.reason}",
        f"holds    {advice.scope.text}",
        f"shapes   {shapes(facts)}",
        f"pairs    {_pairs(facts)}",
    ]
    if facts.pairs:
        lines.append(f"nearest  {nearest(facts)}")
    place = advice.judged.index(best)
    lines += [f"less     {_fails(j, facts)}" for j in advice.judged[:place]]
    lines += [f"more     {_adds(j, facts)}" for j in advice.judged[place + 1 :]]
    if advice.scope.kind != "anywhere":
        lines.append(f"anywhere {named(advice.anywhere)} is right, wherever they lie")
    hits = advice.for_hits
    if hits is not best:
        lines.append(f"hits     if touching need not be told from overlapping, {title(hits)} will do")
    return "\n".join(lines)


def price(advice: "Advice") -> str:
    """What the model advised costs here, beside the exact filter; empty where there are no pairs."""
    found = advice.prices()
    if not found:
        return ""
    mine, exact = found[advice.model.name], found[EXACT]
    text = f"price    {duration(mine.warm)} a pair, {duration(mine.cold)} with its set-up"
    return text if mine is exact else f"{text}; {EXACT} {duration(exact.warm)} and {duration(exact.cold)}"


def duration(nanoseconds: float) -> str:
    """A time with its unit, two digits."""
    for size, unit in ((1e9, "s"), (1e6, "ms"), (1e3, "µs")):
        if nanoseconds >= size * 0.9995:
            shown = nanoseconds / size
            return f"{shown:.2g} {unit}" if shown < 99.5 else f"{shown:.0f} {unit}"
    return f"{nanoseconds:.2g} ns" if nanoseconds < 99.5 else f"{nanoseconds:.0f} ns"


def title(judged: "Judged") -> str:
    """A model's name and how many axes it has."""
    return named(judged.model)


def named(model: "Model") -> str:
    """The same of a model."""
    return model.name if model.kind == DIRECTIONS else f"{model.name} ({axes(model.axes)})"


def axes(many: int) -> str:
    """How many axes."""
    return f"{many:,} {'axis' if many == 1 else 'axes'}"


def power(value: float) -> str:
    """A number as a power of two."""
    return "0" if not value else f"2^{log2(value):.1f}" if value < inf else "no end"


def shapes(facts: "Facts") -> str:
    """What there is."""
    kinds = ", ".join(f"{n:,} {ONE[kind] if n == 1 else kind}" for kind, n in facts.kinds.items())
    low, high = facts.corners
    corners = f", {low} corners" if low == high else f", {low} to {high} corners"
    corners += " in a convex part" if "concave polygons" in facts.kinds else ""
    sizes = f", the largest {facts.sizes:,.3g} times the smallest" if facts.sizes > 1.005 else ""
    return f"{kinds or 'none'}{corners if high else ''}{sizes}"


def _all(facts: "Facts") -> str:
    if not facts.pairs:
        return f"all {facts.settled:,} pairs"
    return "this pair" if facts.pairs == 1 else f"all {facts.pairs:,} pairs"


def _pairs(facts: "Facts") -> str:
    apart, touching, overlapping = facts.relations
    text = f"{facts.pairs:,}: {apart:,} apart, {touching:,} touching, {overlapping:,} overlapping"
    return text + (f"; {facts.settled:,} more are apart by their boxes" if facts.settled else "")


def nearest(facts: "Facts") -> str:
    """The pair that is hardest to tell, in roundings."""
    where = "" if facts.pairs == 1 else f"pair {facts.at} "
    if not facts.gamma:
        return f"{where}touches: gamma is 0"
    return (
        f"{where}{'' if facts.pairs == 1 else 'is '}decided by {power(facts.gamma)} roundings of float64 (its gamma), "
        f"{power(facts.gamma * IN_FLOAT32)} of float32"
    )


def _fails(judged: "Judged", facts: "Facts") -> str:
    if facts.pairs == 1:
        return f"{title(judged)}: {'wrong here' if judged.wrong else 'in doubt, as rounding decides'}"
    said = []
    if judged.wrong:
        said.append(f"wrong on {judged.wrong:,}")
    if judged.unsure:
        said.append(f"in doubt on {judged.unsure:,}, where rounding decides")
    return f"{title(judged)}: {' and '.join(said)}; the first is pair {judged.first}"


def _adds(judged: "Judged", facts: "Facts") -> str:
    if not judged.proven:
        return _fails(judged, facts)
    adds = "right as well, and adds nothing here"
    if judged.model.kind == EXACT:
        adds = "right for all coordinates"
    elif judged.model.kind == FLOAT64.name:
        adds = "right as well, 2^29 times as fine as float32, which nothing here needs"
    return f"{title(judged)}: {adds}"
