"""How far an advice holds: the pairs as they lie, and further only where that follows."""

from collections.abc import Iterable
from fractions import Fraction
from itertools import chain
from math import frexp, inf
from typing import NamedTuple

from ..engine.shapes import Shape
from . import proofs
from .facts import CONCAVE, ROUND, UPRIGHT, Case, Facts
from .gamma import gamma
from .proofs import BOXES, EXACT, FLOAT64, FORMATS, Body, Format, Model

ANYWHERE, GRID, MOVED, HERE = "anywhere", "on a grid", "moved as a whole", "these coordinates"


class Scope(NamedTuple):
    """Where the advice holds: its kind, one of those above, its bound in scene units and the grid's 2**unit if any."""

    kind: str
    bound: float = 0.0
    unit: int | None = None


def scope_of(model: Model, facts: Facts, case: Case) -> Scope:
    """Where the model is right, if it is so for the pairs in hand."""
    if not facts.pairs:
        return Scope(HERE)
    if model.kind == EXACT or (model.kind == BOXES and set(facts.kinds) == {UPRIGHT}):
        return Scope(ANYWHERE)
    if model.kind not in FORMATS:
        return Scope(HERE)
    if CONCAVE in facts.kinds:  # whose convex parts depend on where it lies, and their corners on no grid of its own
        return Scope(HERE)
    form = FORMATS[model.kind]
    if (ROUND not in facts.kinds or len(facts.kinds) == 1) and (unit := case.unit(form)) is not None:
        return Scope(GRID, 2.0 ** (unit + form.whole), unit)
    bound = case.reach() if form is FLOAT64 and ROUND not in facts.kinds else 0.0
    return Scope(MOVED, bound) if bound else Scope(HERE)


def reach_allowed(a: Shape, b: Shape) -> Fraction:
    """How far from the origin a pair of convex polygons may be moved as a whole, for SAT on float64 to stay proven.

    A move changes no turn and no span, so what decides stays gamma * u * span * reach: reach may grow until gamma is
    the roundings asked (and one, as gamma itself is rounded).
    """
    reach = max(abs(c) for s in (a, b) for c in s.bounds)
    return Fraction(gamma(a, b)) * Fraction(reach) / (proofs.LOOKS + 1)


def reach_of(pairs: Iterable[tuple[Body, Body]]) -> float:
    """The reach allowed for all of these polygons."""
    parts = _parts(pairs)
    allowed = min(reach_allowed(p, q) for p, q in parts)
    return bound_of(float(min(allowed, Fraction(FLOAT64.most))), max(s.reach for pair in parts for s in pair))


def bound_of(allowed: float, reach: float) -> float:
    """The largest power of two within what is allowed; 0 if that is no further than the shapes reach."""
    bound = min(2.0 ** (frexp(allowed)[1] - 1), FLOAT64.most) if 0 < allowed < inf else 0.0
    return bound if bound > reach else 0.0


def unit_of(pairs: Iterable[tuple[Body, Body]], form: Format) -> int | None:
    """The exponent of the power of two that all their numbers are few multiples of, if there is one."""
    shapes = chain.from_iterable(_parts(pairs))
    return proofs.unit(chain.from_iterable((*chain.from_iterable(s.core), s.radius) for s in shapes), form)


def _parts(pairs: Iterable[tuple[Body, Body]]) -> list[tuple[Shape, Shape]]:
    return [(p, q) for a, b in pairs for p in proofs.pieces(a) for q in proofs.pieces(b)]
