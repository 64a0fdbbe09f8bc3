"""Scope of a recommendation: these exact coordinates, or a larger set of scenes where that is provable.

A recommended model is proven for the given coordinates.  It may be proven for more: anywhere, for all polygons whose
coordinates are multiples of one power of two (the *unit*), or for the scene *moved as a whole* by exact translations.
"""

from collections.abc import Iterable
from fractions import Fraction
from itertools import chain
from math import frexp, inf
from typing import NamedTuple

from ..engine.geometry import cyclic_pairs
from ..engine.predicates import to_integers
from ..engine.shapes import Shape
from .candidates import AABB, EXACT_FILTER, AnyShape, Model, convex_parts
from .certified_bounds import SAT_ROUNDINGS
from .records import CIRCLES, CONCAVE_POLYGONS, UPRIGHT_BOXES, CommonUnit, GivenPairs, InputSummary
from .relative_margin import relative_margin
from .rounding import FLOAT64, FORMATS, FloatFormat

ANYWHERE, MULTIPLES, MOVED, HERE = "anywhere", "multiples of a unit", "moved as a whole", "these coordinates"


class Scope(NamedTuple):
    """Describe where a recommendation is valid: `kind` is one of the four constants above; lengths in scene units.

    `bound`: the largest absolute coordinate allowed; `unit`: the exponent of the power of two that all
    coordinates must be multiples of, None for any coordinates; `span`: with a unit, the largest component of an edge
    allowed, 0 for any.
    """

    kind: str
    bound: float = 0.0
    unit: int | None = None
    span: float = 0.0


def scope_of(model: Model, summary: InputSummary, given: GivenPairs) -> Scope:
    """Return the scope of a model that is proven for the given pairs; HERE if it is proven for nothing more."""
    if not summary.pairs:
        return Scope(HERE)
    if model.kind == EXACT_FILTER or (model.kind == AABB and set(summary.kinds) == {UPRIGHT_BOXES}):
        return Scope(ANYWHERE)
    if model.kind not in FORMATS:
        return Scope(HERE)
    form = FORMATS[model.kind]
    # the convex parts of a concave polygon change when it moves
    if CIRCLES in summary.kinds or CONCAVE_POLYGONS in summary.kinds:
        return Scope(HERE)
    if not summary.settled and (found := _scope_of_unit(given.common_unit(), form)):
        return found
    bound = given.moved_bound() if form is FLOAT64 else 0.0
    return Scope(MOVED, bound) if bound else Scope(HERE)


def allowed_coordinate(a: Shape, b: Shape) -> Fraction:
    """Return the largest coordinate up to which two convex polygons may be moved with SAT in float64 still proven.

    A move of the whole pair changes no orientation determinant and no span, so relative_margin * max_coordinate is
    constant.  The coordinate may grow until the margin has fallen to SAT_ROUNDINGS + 1 (the 1 for the rounding of the
    margin itself).
    """
    max_coordinate = max(abs(c) for s in (a, b) for c in s.bounds)
    return Fraction(relative_margin(a, b)) * Fraction(max_coordinate) / (SAT_ROUNDINGS + 1)


def moved_bound(pairs: Iterable[tuple[AnyShape, AnyShape]]) -> float:
    """Return the power of two up to which the coordinates of these pairs of polygons may grow in a move.

    SAT in float64 is still proven then.  0 if they exceed it already.
    """
    parts = _parts(pairs)
    allowed = min(allowed_coordinate(p, q) for p, q in parts)
    return power_of_two_bound(
        float(min(allowed, Fraction(FLOAT64.most))), max(s.max_coordinate for pair in parts for s in pair)
    )


def power_of_two_bound(allowed: float, max_coordinate: float) -> float:
    """Return the largest power of two that is at most `allowed`; 0 unless it is above `max_coordinate`."""
    bound = min(2.0 ** (frexp(allowed)[1] - 1), FLOAT64.most) if 0 < allowed < inf else 0.0
    return bound if bound > max_coordinate else 0.0


def _scope_of_unit(common: CommonUnit | None, form: FloatFormat) -> Scope | None:
    """Return the largest scope with this unit in which SAT rounds nothing; None where the pairs exceed it.

    Coordinates are at most M and edge components at most S, in multiples of the unit.  A product of the two is at most
    S M.  A comparison adds four products; partial sums have up to three, so at most 3 S M, and are exact if
    4 S M <= 2**bits.  S = 2 M admits every edge.
    """
    if common is None:
        return None
    any_edge = form.bits - 3 >> 1
    size = max((common.most - 1).bit_length() if common.most else 0, any_edge)
    span = form.bits - 2 - size
    fits = size == any_edge or (span >= 0 and common.span <= 1 << span)
    trusted = form.least < 2.0 ** max(common.unit, -1000) and 2.0 ** min(size + common.unit, 900) < form.most
    if not (fits and trusted):
        return None
    return Scope(
        MULTIPLES, 2.0 ** (common.unit + size), common.unit, 0.0 if size == any_edge else 2.0 ** (common.unit + span)
    )


def common_unit_of(pairs: Iterable[tuple[AnyShape, AnyShape]]) -> CommonUnit | None:
    """Return the CommonUnit of all shapes in these pairs; None where all their numbers are 0."""
    shapes = list(chain.from_iterable(_parts(pairs)))
    k, found = to_integers(c for s in shapes for c in (*chain.from_iterable(s.core), s.radius))
    common = 0
    for n in found:
        common |= n
    if not common:
        return None
    low = (common & -common).bit_length() - 1
    spans = [abs(Fraction(c) - Fraction(d)) for s in shapes for p, q in cyclic_pairs(s.core) for c, d in zip(p, q)]
    return CommonUnit(low - k, max(map(abs, found)) >> low, int(max(spans) / Fraction(2) ** (low - k)))


def _parts(pairs: Iterable[tuple[AnyShape, AnyShape]]) -> list[tuple[Shape, Shape]]:
    """Return all pairs of convex parts of these pairs of shapes."""
    return [(p, q) for a, b in pairs for p in convex_parts(a) for q in convex_parts(b)]
