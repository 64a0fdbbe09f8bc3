"""The records of a recommendation: the pairs, a summary of them, and the result of each candidate model.

The *given pairs* are those that a recommendation is made for.  A *model* is a way to find the relation of two shapes
(`candidates.py`); it is *proven* for the given pairs where it is certified right on every one.  For all pairs of one
batch the *broad phase* comes first: a test of the bounding boxes, which leaves fewer pairs to the models.
"""

from collections.abc import Callable, Collection, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from ..engine.geometry import Vec
from .candidates import AABB, EXACT_FILTER, AnyShape, Model, candidates

if TYPE_CHECKING:
    from ..batch.broad_phase import BroadPhase

IndexPair = tuple[int, int]
SINGULAR = {
    "upright boxes": "upright box",
    "circles": "circle",
    "convex polygons": "convex polygon",
    "concave polygons": "concave polygon",
}
UPRIGHT_BOXES, CIRCLES, CONVEX_POLYGONS, CONCAVE_POLYGONS = SINGULAR  # the kinds of shapes


class CommonUnit(NamedTuple):
    """Describe the largest power of two, 2**unit, that divides all coordinates and radii of some shapes.

    `most`: the largest absolute number, and `span`: the largest component of an edge, both in multiples of 2**unit.
    """

    unit: int
    most: int
    span: int


class BroadPhaseResult(NamedTuple):
    """Hold what a test of bounding boxes finds apart before any model runs, for all pairs of one batch.

    `pairs`: how many are apart by their boxes; `near`: how many of these a model without the boxes might not certify;
    `kinds_without_boxes`: the kinds of models that are candidates without the boxes too; `only_circles`: whether all
    shapes of the batch are circles.
    """

    pairs: int
    near: int
    kinds_without_boxes: frozenset[str]
    only_circles: bool


class GivenPairs(NamedTuple):
    """Hold the pairs that a recommendation is made for; large parts are computed only when called.

    `shapes_of(k)` and `indices(k)` return the two shapes and the two indices of pair k, `unique_shapes()` each
    shape once, `batches()` the pairs as batches to be timed.  Pairs from number `pairs` on are those counted in
    `broad_phase.near`.  `moved_bound()` returns the largest coordinate up to which the pairs may be moved as a whole
    with SAT in float64 still proven, 0 if they exceed it already; `common_unit()` the largest power of two that
    divides all numbers; `tests` counts the tests of an edge against a corner.
    """

    pairs: int
    shapes_of: Callable[[int], tuple[AnyShape, AnyShape]]
    indices: Callable[[int], IndexPair]
    unique_shapes: Callable[[], Sequence[AnyShape]]
    batches: Callable[[], Any]
    moved_bound: Callable[[], float]
    common_unit: Callable[[], CommonUnit | None]
    tests: int
    broad_phase: BroadPhaseResult | None = None

    @property
    def numbered(self) -> int:
        """Return how many pairs `shapes_of` and `indices` know: the given ones and those counted as near."""
        return self.pairs + (self.broad_phase.near if self.broad_phase else 0)


class InputSummary(NamedTuple):
    """Hold the summary of the given pairs.

    `kinds`: how many shapes of each kind; `corners`: the fewest and the most of a convex part; `size_ratio`: the width
    of the largest shape over that of the smallest; `relations`: pairs apart, touching and overlapping; `settled`:
    further pairs that are apart by their boxes; `relative_margin`: the smallest one, which the pair with the indices
    `at` has; `search`: the broad phase that suffices where all pairs of one batch are given, else None.
    """

    kinds: dict[str, int]
    corners: IndexPair
    size_ratio: float
    pairs: int
    relations: tuple[int, int, int]
    settled: int
    relative_margin: float
    at: IndexPair
    search: "BroadPhase | None" = None


class ModelResult(NamedTuple):
    """Hold how many given pairs a model gets wrong, and (at most) how many are uncertain by rounding.

    `first`: the first wrong pair, else the first uncertain one, else None; `proven_for_hits`: whether the model is
    certified to separate hits (touching or overlapping) from misses.
    """

    model: Model
    wrong: int
    uncertain: int
    first: IndexPair | None
    proven_for_hits: bool

    @property
    def proven(self) -> bool:
        """Return whether the model is right on every pair, in every order of its operations."""
        return not (self.wrong or self.uncertain)


def kind_of(shape: AnyShape) -> str:
    """Return the kind of a shape in words: CIRCLES, UPRIGHT_BOXES, CONVEX_POLYGONS or CONCAVE_POLYGONS."""
    if shape.core_is_point:
        return CIRCLES
    return UPRIGHT_BOXES if shape.is_upright_box else CONVEX_POLYGONS if shape.is_convex else CONCAVE_POLYGONS


def best(results: Sequence[ModelResult]) -> ModelResult:
    """Return the first result that is proven, the recommended model: at the latest the exact filter, the last."""
    return next(j for j in results if j.proven)


def for_hits(results: Sequence[ModelResult]) -> ModelResult:
    """Return the first result that is proven to separate hits from misses: at the latest the exact filter, the last."""
    return next(j for j in results if j.proven_for_hits)


def model_for_any_position(summary: InputSummary, results: Sequence[ModelResult]) -> Model:
    """Return the simplest model of these results that is right wherever the shapes are.

    That is AABB if all shapes are upright boxes, else the exact filter; both are always among the candidates.
    """
    kind = AABB if set(summary.kinds) == {UPRIGHT_BOXES} else EXACT_FILTER
    return next(j.model for j in results if j.model.kind == kind)


def candidates_of(
    axes: int, directions: tuple[Vec, ...], kinds: Collection[str], given: GivenPairs
) -> tuple[Model, ...]:
    """Return the candidate models for the given pairs.

    axes: how many SAT tests for the largest pair; directions: as in `candidates`; kinds: those of all given shapes.
    """
    if given.broad_phase is None:
        return candidates(axes, directions, set(kinds) == {CIRCLES})
    found = candidates(axes, directions, given.broad_phase.only_circles, given.broad_phase.kinds_without_boxes)
    if given.pairs:
        return found
    return tuple(m for m in found if not m.after_boxes or m.kind == EXACT_FILTER)  # nothing is left after the boxes
