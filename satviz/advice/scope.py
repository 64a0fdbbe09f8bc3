"""How far an advice holds: the pairs as they lie, and further only where that follows."""

from collections.abc import Iterable
from fractions import Fraction
from itertools import chain
from math import frexp, inf
from typing import NamedTuple

from ..engine.predicates import to_integers
from ..engine.shapes import Shape
from .candidates import AABB, EXACT_FILTER, AnyShape, Model, convex_parts, cyclic_pairs
from .certified_bounds import SAT_ROUNDINGS
from .records import CIRCLES, CONCAVE_POLYGONS, UPRIGHT_BOXES, Grid, InputSummary, PairsInHand
from .relative_margin import relative_margin
from .rounding import FLOAT64, FORMATS, Format

ANYWHERE, GRID, MOVED, HERE = "anywhere", "on a grid", "moved as a whole", "these coordinates"


class Scope(NamedTuple):
    """Where the recommendation holds: its kind, one of those above, and its numbers in scene units.

    `bound`: the largest magnitude of a coordinate (and radius); `unit`: on a grid, the exponent of the power of two
    that all numbers are multiples of; `span`: the widest and highest that an edge may be there, 0 for any.
    """

    kind: str
    bound: float = 0.0
    unit: int | None = None
    span: float = 0.0


def scope_of(model: Model, facts: InputSummary, case: PairsInHand) -> Scope:
    """Where the model is right, if it is so for the pairs in hand."""
    if not facts.pairs:
        return Scope(HERE)
    if model.kind == EXACT_FILTER or (model.kind == AABB and set(facts.kinds) == {UPRIGHT_BOXES}):
        return Scope(ANYWHERE)
    if model.kind not in FORMATS:
        return Scope(HERE)
    if (
        CONCAVE_POLYGONS in facts.kinds
    ):  # whose convex parts depend on where it lies, and their corners on no grid of its own
        return Scope(HERE)
    form = FORMATS[model.kind]
    if CIRCLES in facts.kinds:
        return Scope(HERE)
    if not facts.settled and (found := _on_grid(case.grid(), form)):
        return found
    bound = case.reach() if form is FLOAT64 else 0.0
    return Scope(MOVED, bound) if bound else Scope(HERE)


def allowed_coordinate(a: Shape, b: Shape) -> Fraction:
    """How far from the origin a pair of convex polygons may be moved as a whole, for SAT on float64 to stay proven.

    A move changes no turn and no span, so what decides stays gamma * u * span * reach: reach may grow until gamma is
    the roundings asked (and one, as gamma itself is rounded).
    """
    reach = max(abs(c) for s in (a, b) for c in s.bounds)
    return Fraction(relative_margin(a, b)) * Fraction(reach) / (SAT_ROUNDINGS + 1)


def moved_bound(pairs: Iterable[tuple[AnyShape, AnyShape]]) -> float:
    """The reach allowed for all of these polygons."""
    parts = _parts(pairs)
    allowed = min(allowed_coordinate(p, q) for p, q in parts)
    return power_of_two_bound(
        float(min(allowed, Fraction(FLOAT64.most))), max(s.max_coordinate for pair in parts for s in pair)
    )


def power_of_two_bound(allowed: float, reach: float) -> float:
    """The largest power of two within what is allowed; 0 if that is no further than the shapes reach."""
    bound = min(2.0 ** (frexp(allowed)[1] - 1), FLOAT64.most) if 0 < allowed < inf else 0.0
    return bound if bound > reach else 0.0


def _on_grid(grid: Grid | None, form: Format) -> Scope | None:
    """The grid on which nothing is rounded: any polygons of its multiples up to M, with edges up to S.

    In units of the grid a product of an edge's part and a coordinate is at most S M.  The terms of a comparison are
    four, and a sum of up to three of them is at most 3 S M: held if 4 S M <= 2**bits.  S = 2 M is every edge.
    """
    if grid is None:
        return None
    any_edge = form.bits - 3 >> 1
    size = max((grid.most - 1).bit_length() if grid.most else 0, any_edge)
    span = form.bits - 2 - size
    fits = size == any_edge or (span >= 0 and grid.span <= 1 << span)
    trusted = form.least < 2.0 ** max(grid.unit, -1000) and 2.0 ** min(size + grid.unit, 900) < form.most
    if not (fits and trusted):
        return None
    return Scope(GRID, 2.0 ** (grid.unit + size), grid.unit, 0.0 if size == any_edge else 2.0 ** (grid.unit + span))


def grid_of(pairs: Iterable[tuple[AnyShape, AnyShape]]) -> Grid | None:
    """The grid of these pairs; None where all numbers are 0."""
    shapes = list(chain.from_iterable(_parts(pairs)))
    k, found = to_integers(c for s in shapes for c in (*chain.from_iterable(s.core), s.radius))
    common = 0
    for n in found:
        common |= n
    if not common:
        return None
    low = (common & -common).bit_length() - 1
    spans = [abs(Fraction(c) - Fraction(d)) for s in shapes for p, q in cyclic_pairs(s.core) for c, d in zip(p, q)]
    return Grid(low - k, max(map(abs, found)) >> low, int(max(spans) / Fraction(2) ** (low - k)))


def _parts(pairs: Iterable[tuple[AnyShape, AnyShape]]) -> list[tuple[Shape, Shape]]:
    return [(p, q) for a, b in pairs for p in convex_parts(a) for q in convex_parts(b)]
