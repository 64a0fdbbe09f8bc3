"""What an advice is made of: the pairs in hand, what there is, and each model results on them."""

from collections.abc import Callable, Collection, Sequence
from typing import Any, NamedTuple

from ..engine.geometry import Vec
from .candidates import AABB, EXACT_FILTER, AnyShape, Model, candidates

Pair = tuple[int, int]
UPRIGHT_BOXES, CIRCLES, CONVEX_POLYGONS, CONCAVE_POLYGONS = (
    "upright boxes",
    "circles",
    "convex polygons",
    "concave polygons",
)


class Grid(NamedTuple):
    """The coarsest grid of some numbers: all are multiples of 2**unit, and the largest is `most` times that.

    `span`: the largest part of an edge, in the same unit.
    """

    unit: int
    most: int
    span: int


class BroadPhaseResult(NamedTuple):
    """What the bounding boxes settle before a model is asked, where all pairs of one batch are meant.

    `pairs`: how many; `near`: how many of them a model that stands alone could still doubt; `alone`: the kinds of
    models that are results without the boxes too; `only_circles`: whether the batch has nothing else.
    """

    pairs: int
    near: int
    alone: frozenset[str]
    only_circles: bool


class PairsInHand(NamedTuple):
    """The pairs in hand, by number: their two bodies and their indices; each shape in them once; the batches.

    The numbers from `pairs` on are those of `settled.near`.  `reach`: how far the pairs may be moved as a whole with
    plain floats still proven, 0 if no further than they reach; `grid`: the grid of all their numbers; `tests`: how
    many tests of an edge against a corner all pairs take.
    """

    pairs: int
    body: Callable[[int], tuple[AnyShape, AnyShape]]
    indices: Callable[[int], Pair]
    shapes: Callable[[], Sequence[AnyShape]]
    batches: Callable[[], Any]
    reach: Callable[[], float]
    grid: Callable[[], Grid | None]
    tests: int
    settled: BroadPhaseResult | None = None

    @property
    def known(self) -> int:
        """How many pairs have a number."""
        return self.pairs + (self.settled.near if self.settled else 0)


class InputSummary(NamedTuple):
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
    relative_margin: float
    at: Pair


class ModelResult(NamedTuple):
    """A model on the pairs: how many it gets wrong, and of how many, at most, rounding decides what it says.

    `first`: the first pair that is wrong, or else in doubt; `hits`: does it tell hits from misses, at least?
    """

    model: Model
    wrong: int
    uncertain: int
    first: Pair | None
    proven_for_hits: bool

    @property
    def proven(self) -> bool:
        """Is it right on every pair, whatever the order of its operations?"""
        return not (self.wrong or self.uncertain)


def kind_of(shape: AnyShape) -> str:
    """What kind of shape it is, in words."""
    if shape.core_is_point:
        return CIRCLES
    return UPRIGHT_BOXES if shape.is_upright_box else CONVEX_POLYGONS if shape.is_convex else CONCAVE_POLYGONS


def best(results: Sequence[ModelResult]) -> ModelResult:
    """The first that is proven."""
    return next(j for j in results if j.proven)


def for_hits(results: Sequence[ModelResult]) -> ModelResult:
    """The first that is proven to tell hits from misses."""
    return next(j for j in results if j.proven_for_hits)


def anywhere(facts: InputSummary, results: Sequence[ModelResult]) -> Model:
    """The least that is right wherever these shapes lie: y and x for upright boxes, else what is exact."""
    wide = AABB if set(facts.kinds) == {UPRIGHT_BOXES} else EXACT_FILTER
    return next(j.model for j in results if j.model.kind == wide)


def candidates_of(
    axes: int, directions: tuple[Vec, ...], kinds: Collection[str], case: PairsInHand
) -> tuple[Model, ...]:
    """The candidate models of a case, for shapes of these kinds and the most axes that a pair of them has."""
    if case.settled is None:
        return candidates(axes, directions, set(kinds) == {CIRCLES})
    found = candidates(axes, directions, case.settled.only_circles, case.settled.alone)
    if case.pairs:
        return found
    return tuple(m for m in found if not m.after_boxes or m.kind == EXACT_FILTER)  # nothing is left after the boxes
