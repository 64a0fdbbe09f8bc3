"""`sv.advise`: recommend the simplest model that is proven right for a scene, and compare the other models with it.

A *model* is a way to find the relation of two shapes (`candidates.py`).  It is *certified* for a pair where no order of
its operations can give another relation (`certified_bounds.py`), and *proven* where it is certified right on every
pair.  The *scope* says for which coordinates the proof is valid.
"""

import json
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import inf, isclose
from sys import float_info
from typing import TYPE_CHECKING, Any

from ..engine.axes import Axis, Choice, directions, needed, world
from ..engine.geometry import InvalidScene, Relation
from ..engine.sat import AxisTest, axis_tests
from ..engine.shapes import Circle, Shape, require_shape
from ..engine.shortcut import Shortcut
from ..engine.trace import Trace, record
from ..scenes.named import scene as named
from ..scenes.scenefile import Scene
from . import report
from .candidates import AABB, K_DOP, Model, SplitPolygon, convex_parts, count_axes, shared_directions
from .certified_bounds import bounding_circle, certify, exact_relation
from .limits import MAX_TESTS_CHECKED, TESTS_BY_FRACTIONS, TESTS_TIMED
from .records import (
    GivenPairs,
    IndexPair,
    InputSummary,
    ModelResult,
    best,
    candidates_of,
    for_hits,
    kind_of,
    model_for_any_position,
)
from .relative_margin import signed_relative_margin
from .scope import HERE, Scope, common_unit_of, moved_bound, scope_of

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ..batch import Shapes
    from ..render.chart import Chart
    from .costs import Cost


@dataclass(frozen=True)
class Recommendation:
    """Hold a recommendation: `best` is the simplest model proven to find the relation of every given pair.

    `results` has every candidate, from the fewest axes to the most.  print() shows the recommendation in words,
    `to_json()` returns it as data, `check()` proves it again with integers, `failure()` records the pair on which the
    next smaller model fails, `costs()` and `chart()` measure the time of each model on this machine.
    """

    summary: InputSummary
    results: tuple[ModelResult, ...]
    scope: Scope
    given: GivenPairs

    @property
    def best(self) -> ModelResult:
        """Return the result of the recommended model: the first that is proven."""
        return best(self.results)

    @property
    def model(self) -> Model:
        """Return the recommended model."""
        return self.best.model

    @property
    def smaller(self) -> ModelResult | None:
        """Return the result of the next smaller candidate, which fails; None if the recommended one is the smallest."""
        place = self.results.index(self.best)
        return self.results[place - 1] if place else None

    @property
    def anywhere(self) -> Model:
        """Return the simplest model that is right at any position: AABB for upright boxes, else the exact filter."""
        return model_for_any_position(self.summary, self.results)

    @property
    def for_hits(self) -> ModelResult:
        """Return the first candidate proven to separate hits from misses; it may confuse touching and overlapping."""
        return for_hits(self.results)

    @property
    def reason(self) -> str:
        """Return a sentence that says why the recommended model is right."""
        return report.reason(self.model, self.summary, self.scope)

    def check(self, most: int = MAX_TESTS_CHECKED) -> bool:
        """Prove the recommendation again with integers and fractions, pair by pair; return whether all of it holds.

        It compares the list of candidates, the result of each candidate on the pairs, the summary and the scope.  The
        number of pairs that the bounding boxes settle is not checked.  InvalidScene where the proof needs more than
        `most` tests of an edge against a corner, at some 30 microseconds each.
        """
        if self.given.tests > most:
            raise InvalidScene(
                f"check() would make {self.given.tests:,} exact tests of an edge against a corner: the limit "
                f"is {most:,}; call advise with fewer pairs (pairs=), or raise the limit: check(most=...)"
            )
        models = _candidates(self.given)
        if tuple(j.model for j in self.results) != models:
            return False
        summary, results = _summarize(self.given, models)
        return (
            self._summary_holds(summary)
            and all(self._result_holds(claim, found) for claim, found in zip(self.results, results, strict=True))
            and self._scope_holds()
        )

    def _summary_holds(self, found: InputSummary) -> bool:
        """Return whether this summary agrees with `found`, computed by integers, up to the rounding of arrays."""
        mine, place = self.summary, self._number_of(self.summary.at)
        if mine != found._replace(relative_margin=mine.relative_margin, at=mine.at, search=mine.search):
            return False
        if place is None:
            return not mine.pairs
        # arrays compute the relative margin to one part in fifty
        return all(
            isclose(mine.relative_margin, known, rel_tol=0.025)
            for known in (found.relative_margin, _least_margin(self.given, place))
        )

    def _result_holds(self, claim: ModelResult, found: ModelResult) -> bool:
        """Return whether the claimed result of a model agrees with `found`, computed by integers.

        The claim was computed with arrays, which may leave more pairs uncertain than integers do.  So its counts must
        enclose those of `found`.  Its first pair must be wrong for the integers too, or uncertain for them too.
        """
        if (claim.proven, claim.proven_for_hits) != (found.proven, found.proven_for_hits):
            return False
        if not claim.wrong <= found.wrong <= found.wrong + found.uncertain <= claim.wrong + claim.uncertain:
            return False
        if claim.wrong and claim.wrong == found.wrong and claim.first != found.first:
            return False
        place = None if claim.first is None else self._number_of(claim.first)
        if place is None or claim.proven:
            return claim.first is None and claim.proven
        a, b = self.given.shapes_of(place)
        certified = certify(claim.model, a, b)
        return certified not in (None, exact_relation(a, b)) if claim.wrong else certified is None

    def _number_of(self, pair: IndexPair) -> int | None:
        """Return the number k of the given pair with these two indices; None if it is not among them."""
        return next((k for k in range(self.given.numbered) if self.given.indices(k) == pair), None)

    def _scope_holds(self) -> bool:
        """Return whether the scope, computed again with integers, is at least the claimed one."""
        pairs = [self.given.shapes_of(k) for k in range(self.given.pairs)]
        again = self.given._replace(moved_bound=lambda: moved_bound(pairs), common_unit=lambda: common_unit_of(pairs))
        found = scope_of(self.model, self.summary, again)
        return self.scope == Scope(HERE) or (
            self.scope._replace(bound=0) == found._replace(bound=0) and (0 <= self.scope.bound <= found.bound)
        )

    def failure(self) -> Trace | None:
        """Return a trace of the first pair on which the next smaller model fails; None if there is none.

        `sv.draw` shows the claimed relation beside the actual one.  Where only rounding can make that model fail, it
        is the trace of exact SAT.
        """
        smaller = self.smaller
        if smaller is None or smaller.first is None or (place := self._number_of(smaller.first)) is None:
            return None
        a, b = (s.outline() if isinstance(s, SplitPolygon) else s for s in self.given.shapes_of(place))
        return record(a, b, axes=_as_shortcut(smaller.model, a, b))

    @cached_property
    def _costs(self) -> "dict[str, Cost | None]":
        """Return the result of `costs`, measured once."""
        from .costs import costs

        # for one pair numba would take longer to load than all else
        engine = "numpy" if self.summary.pairs == 1 else None
        return costs([j.model for j in self.results], self.given.batches(), engine=engine)

    def costs(self) -> "dict[str, Cost | None]":
        """Return the cost of each model on this machine, by its name: nanoseconds a pair, cold (with set-up) and warm.

        They are measured once, for about a second; None stands for a model of which one call would take too long.
        """
        return self._costs

    def chart(self) -> "Chart":
        """Return a chart of time against wrong answers of all candidates on these pairs, the recommended one marked."""
        from .cost_chart import chart

        return chart(self.model, self.summary, self.results, self.costs())

    def to_json(self, indent: int | None = None) -> str:
        """Return the recommendation without costs as JSON; two calls return the same text."""
        f = self.summary
        data = {
            "satviz": "advice 1",
            "model": _model(self.model),
            "reason": self.reason,
            "scope": {
                "kind": self.scope.kind,
                "text": report.validity_sentence(self.scope, self.summary),
                "bound": self.scope.bound,
            },
            "anywhere": self.anywhere.name,
            "for_hits": self.for_hits.model.name,
            "facts": {**f._asdict(), "relative_margin": f.relative_margin if f.pairs else None},
            "candidates": [
                {**_model(j.model), "wrong": j.wrong, "uncertain": j.uncertain, "first": j.first, "proven": j.proven}
                for j in self.results
            ],
        }
        return json.dumps(data, indent=indent, allow_nan=False)

    def __str__(self) -> str:
        return report.text(self.summary, self.results, self.scope)

    def __repr__(self) -> str:
        return f"Recommendation({self.model.name}, {self.scope.kind})"

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, str]:
        """Return what a notebook shows: the words only, since `chart()` would take time to measure."""
        return {"text/plain": str(self)}


def _model(model: Model) -> dict[str, Any]:
    """Return a model as a dict for JSON: name, number of axes, directions."""
    return {"name": model.name, "axes": model.axes, "directions": [list(n) for n in model.directions]}


def advise(
    a: "Shape | Shapes | Scene | str", b: "Shape | Shapes | None" = None, pairs: "ArrayLike | None" = None
) -> Recommendation:
    """Recommend the simplest model (fewest axes, then lowest precision) that is proven right for these shapes.

    a, b: two shapes; or a Scene or its name; or batch shapes, paired row by row or by the (K, 2) indices `pairs`; or
    one batch, of which all pairs are tested (those whose boxes meet, as a broad phase finds them).  Two shapes need
    the standard library only.  TypeError and ValueError for anything else.
    """
    if isinstance(a, str):
        a = named(a)
    if isinstance(a, Scene):
        if b is not None or pairs is not None:
            raise TypeError("a scene holds both shapes already: leave out b and pairs")
        return advise(a.a, a.b)
    if isinstance(a, Shape) and (b is None or isinstance(b, Shape)):
        if pairs is not None:
            raise TypeError("pairs= needs batch shapes: make them with batch.Polygons or batch.Circles")
        summary, results, given = _recommend_pair(a, require_shape(b, "b"))
    else:
        from .advising_batches import recommend_batch

        summary, results, given = recommend_batch(a, b, pairs)
    return Recommendation(summary, results, scope_of(best(results).model, summary, given), given)


def _recommend_pair(a: Shape, b: Shape) -> tuple[InputSummary, tuple[ModelResult, ...], GivenPairs]:
    """Return (summary, results, given pairs) for two shapes: by integers, or by arrays if these are faster."""
    given = _give_pair(a, b)
    if given.tests <= TESTS_BY_FRACTIONS:
        return *_summarize(given, _candidates(given)), given
    from .advising_batches import recommend_batch, shape_as_batch

    # for one pair numba would take longer to load than all else
    return recommend_batch(shape_as_batch(a), shape_as_batch(b), None, engine="numpy")


def _give_pair(a: Shape, b: Shape) -> GivenPairs:
    """Return the GivenPairs record of one pair of shapes."""

    def batches() -> Any:
        """Return many copies of the pair as batches, to be timed."""
        from .advising_batches import repeated_pair

        return repeated_pair(a, b, copies=max(1, min(4096, TESTS_TIMED // tests)))

    both = [(a, b)]
    corners = [sum(len(p.core) for p in convex_parts(shape)) for shape in (a, b)]
    tests = 2 * corners[0] * corners[1]
    return GivenPairs(
        1,
        both.__getitem__,
        lambda k: (0, 0),
        lambda: (a, b),
        batches,
        lambda: moved_bound(both),
        lambda: common_unit_of(both),
        tests,
    )


def _candidates(given: GivenPairs) -> tuple[Model, ...]:
    """Return the candidate models for the given pairs, from their shapes alone."""
    shapes = given.unique_shapes()
    axes = max((count_axes(*given.shapes_of(k)) for k in range(given.pairs)), default=1)
    shared = shared_directions(shapes) if given.pairs else ()
    return candidates_of(axes, shared, {kind_of(s) for s in shapes}, given)


def _summarize(given: GivenPairs, models: Sequence[Model]) -> tuple[InputSummary, tuple[ModelResult, ...]]:
    """Return the summary of the given pairs and the result of each model, by integers, pair by pair."""
    relations, least, at = Counter[Relation](), inf, (0, 0)
    wrong, uncertain = Counter[Model](), Counter[Model]()
    first: dict[Model, IndexPair] = {}
    first_uncertain: dict[Model, IndexPair] = {}
    missing = set()
    for k in range(given.numbered):
        a, b = given.shapes_of(k)
        relation, pair = exact_relation(a, b), given.indices(k)
        if k < given.pairs:
            relations[relation] += 1
            if (found := _least_margin(given, k)) < least:
                least, at = found, pair
        for model in models:
            if k >= given.pairs and (model.after_boxes or model.kind == AABB):
                continue  # the boxes are apart, so this model does not run
            certified = certify(model, a, b)
            if certified is None:
                uncertain[model] += 1
                first_uncertain.setdefault(model, pair)
            elif certified is not relation:
                wrong[model] += 1
                first.setdefault(model, pair)
            if certified is None or bool(certified) is not bool(relation):
                missing.add(model)
    shapes = given.unique_shapes()
    corners = [len(p.core) for s in shapes if not s.core_is_point for p in convex_parts(s)] or [0]
    widths = [min(max(s.bounds[2] - s.bounds[0], s.bounds[3] - s.bounds[1]), float_info.max) for s in shapes] or [1.0]
    summary = InputSummary(
        dict(Counter(map(kind_of, shapes))),
        (min(corners), max(corners)),
        min(max(widths) / min(widths), float_info.max),
        given.pairs,
        (relations[Relation.APART], relations[Relation.TOUCHING], relations[Relation.OVERLAPPING]),
        given.broad_phase.pairs if given.broad_phase else 0,
        least,
        at,
    )
    return summary, tuple(
        ModelResult(m, wrong[m], uncertain[m], first.get(m, first_uncertain.get(m)), m not in missing) for m in models
    )


def _least_margin(given: GivenPairs, k: int) -> float:
    """Return the relative margin of given pair k, by its convex parts."""
    a, b = given.shapes_of(k)
    return abs(min(signed_relative_margin(p, q) for p in convex_parts(a) for q in convex_parts(b)))


# -- the smaller models as shortcuts of SAT, so that a pair on which a model fails can be recorded and drawn


def _as_shortcut(model: Model, a: Shape, b: Shape) -> Shortcut:
    """Return the SAT shortcut that tests the pair as the model does; SAT itself where only rounding can fail."""
    if certify(model, a, b) is None:
        return Shortcut("plain floats", "plain floats are exact enough", needed)
    if model.kind == AABB:
        return Shortcut("bounding boxes", "the bounding boxes give the same answer as the shapes", world)
    if model.kind == K_DOP:
        return Shortcut(
            "shared directions", "the directions that most edges share are enough", directions(*model.directions)
        )
    return Shortcut(
        "bounding circles", "the circles around the shapes give the same answer as the shapes", _between, _by_circles
    )


def _between(a: Shape, b: Shape) -> Choice:
    """Return the choice of one axis, through the centers of the bounding circles (x if these coincide)."""
    (ax, ay, _), (bx, by, _) = bounding_circle(a), bounding_circle(b)
    return directions((bx - ax, by - ay) if (ax, ay) != (bx, by) else (1, 0))(a, b)


def _by_circles(a: Shape, b: Shape, axis: Axis) -> AxisTest:
    """Return the result of testing the bounding circles, in place of the shapes, on an axis."""
    (ax, ay, ar), (bx, by, br) = bounding_circle(a), bounding_circle(b)
    return next(axis_tests(Circle((ax, ay), ar), Circle((bx, by), br), [axis]))
