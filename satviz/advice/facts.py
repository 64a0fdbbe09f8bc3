"""What an advice is made of: the pairs in hand, what there is, and each model judged on them."""

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from .proofs import BOXES, EXACT, Body, Format, Model

Pair = tuple[int, int]
UPRIGHT, ROUND, CONVEX, CONCAVE = "upright boxes", "circles", "convex polygons", "concave polygons"


class Case(NamedTuple):
    """The pairs in hand, by number: their two bodies and their indices; each shape in them once; the batches.

    `reach`: how far they may be moved as a whole with plain floats still proven, 0 if no further than they reach;
    `unit`: the exponent of the power of two that all numbers are few multiples of, by format.
    """

    pairs: int
    body: Callable[[int], tuple[Body, Body]]
    indices: Callable[[int], Pair]
    shapes: Callable[[], Sequence[Body]]
    batches: Callable[[], Any]
    reach: Callable[[], float]
    unit: Callable[[Format], int | None]


class Facts(NamedTuple):
    """What there is: shapes by kind, their parts' fewest and most corners, the largest over the smallest.

    `relations`: pairs by relation; `settled`: pairs whose boxes are apart, which no model was asked about; `gamma`: the
    least, and of which pair.
    """

    kinds: dict[str, int]
    corners: Pair
    sizes: float
    pairs: int
    relations: tuple[int, int, int]
    settled: int
    gamma: float
    at: Pair


class Judged(NamedTuple):
    """A model on the pairs: how many it gets wrong, and of how many, at most, rounding decides what it says.

    `first`: the first pair that is wrong, or else in doubt; `hits`: does it tell hits from misses, at least?
    """

    model: Model
    wrong: int
    unsure: int
    first: Pair | None
    hits: bool

    @property
    def proven(self) -> bool:
        """Is it right on every pair, whatever the order of its operations?"""
        return not (self.wrong or self.unsure)


def kind_of(shape: Body) -> str:
    """What kind of shape it is, in words."""
    if shape.radius:
        return ROUND
    return UPRIGHT if shape.is_upright_box else CONVEX if shape.is_convex else CONCAVE


def best(judged: Sequence[Judged]) -> Judged:
    """The first that is proven."""
    return next(j for j in judged if j.proven)


def for_hits(judged: Sequence[Judged]) -> Judged:
    """The first that is proven to tell hits from misses."""
    return next(j for j in judged if j.hits)


def anywhere(facts: Facts, judged: Sequence[Judged]) -> Model:
    """The least that is right wherever these shapes lie: y and x for upright boxes, else what is exact."""
    wide = BOXES if set(facts.kinds) == {UPRIGHT} else EXACT
    return next(j.model for j in judged if j.model.kind == wide)
