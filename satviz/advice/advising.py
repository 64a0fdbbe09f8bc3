"""sv.advise: the least model that is right for a scene, with its proof and what each other one lacks or adds."""

import json
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import inf, isclose
from sys import float_info
from typing import TYPE_CHECKING, Any

from ..engine.geometry import InvalidScene, Relation
from ..engine.shapes import Shape, checked
from ..engine.trace import Trace, record
from ..scenes.named import scene as named
from ..scenes.scenefile import Scene
from . import report
from .candidates import AABB, Model, SplitPolygon, convex_parts, count_axes, shared_directions
from .certified_bounds import certify, exact_relation
from .limits import MAX_TESTS_CHECKED, TESTS_BY_FRACTIONS, TESTS_TIMED
from .records import InputSummary, ModelResult, Pair, PairsInHand, anywhere, best, candidates_of, for_hits, kind_of
from .relative_margin import signed_relative_margin
from .scope import HERE, Scope, grid_of, moved_bound, scope_of

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ..batch import Shapes
    from .cost_chart import Chart
    from .costs import Cost


@dataclass(frozen=True)
class Recommendation:
    """The least model that is right: `results` has every candidate from the fewest axes on, `best` is the one advised.

    The question is the three-way relation.  print() says it in words, `to_json()` as data; `check()` proves it once
    more with integers, `failure()` is the trace of the pair on which the next smaller model fails, `prices()` and
    `chart()` measure what each model costs on this machine.
    """

    summary: InputSummary
    results: tuple[ModelResult, ...]
    scope: Scope
    case: PairsInHand

    @property
    def best(self) -> ModelResult:
        """The candidate advised: the first that is proven."""
        return best(self.results)

    @property
    def model(self) -> Model:
        """Its model."""
        return self.best.model

    @property
    def smaller(self) -> ModelResult | None:
        """The next smaller candidate, which fails; None if there is none."""
        place = self.results.index(self.best)
        return self.results[place - 1] if place else None

    @property
    def anywhere(self) -> Model:
        """The least that is right wherever these shapes lie: y and x for upright boxes, else what is exact."""
        return anywhere(self.summary, self.results)

    @property
    def for_hits(self) -> ModelResult:
        """The first candidate that is proven to tell hits from misses, which may confuse touching and overlapping."""
        return for_hits(self.results)

    @property
    def reason(self) -> str:
        """Why it is right, in words."""
        return report.reason(self.model, self.summary, self.scope)

    def check(self, most: int = MAX_TESTS_CHECKED) -> bool:
        """Prove it again with integers and fractions, pair by pair; False if anything claimed does not hold.

        It checks that the candidates are all there and none twice, that each is right, wrong or in doubt on the pairs
        as is said, what there is, and the scope; how many pairs the boxes settle is taken as it is.  InvalidScene where
        that takes more than `most` tests of an edge against a corner, at some 30 microseconds each.
        """
        if self.case.tests > most:
            raise InvalidScene(
                f"check() would make {self.case.tests:,} tests of an edge against a corner with fractions: the limit "
                f"is {most:,}; advise on some of the pairs, or ask for more by most="
            )
        models = _candidates(self.case)
        if tuple(j.model for j in self.results) != models:
            return False
        facts, results = _summarize(self.case, models)
        return (
            self._has(facts)
            and all(self._bears(claim, found) for claim, found in zip(self.results, results, strict=True))
            and self._scope()
        )

    def _has(self, found: InputSummary) -> bool:
        mine, place = self.summary, self._place(self.summary.at)
        if mine != found._replace(relative_margin=mine.relative_margin, at=mine.at):
            return False
        if place is None:
            return not mine.pairs
        # arrays have gamma good to one part in fifty
        return all(
            isclose(mine.relative_margin, known, rel_tol=0.025)
            for known in (found.relative_margin, _least_margin(self.case, place))
        )

    def _bears(self, claim: ModelResult, found: ModelResult) -> bool:
        """Arrays may doubt what integers prove, if another pair is in doubt anyway."""
        if (claim.proven, claim.proven_for_hits) != (found.proven, found.proven_for_hits):
            return False
        if not claim.wrong <= found.wrong <= found.wrong + found.uncertain <= claim.wrong + claim.uncertain:
            return False
        if claim.wrong and claim.wrong == found.wrong and claim.first != found.first:
            return False
        place = None if claim.first is None else self._place(claim.first)
        if place is None or claim.proven:
            return claim.first is None and claim.proven
        a, b = self.case.body(place)
        said = certify(claim.model, a, b)
        return said is not None and said is not exact_relation(a, b) if claim.wrong else said is None

    def _place(self, pair: Pair) -> int | None:
        return next((k for k in range(self.case.known) if self.case.indices(k) == pair), None)

    def _scope(self) -> bool:
        pairs = [self.case.body(k) for k in range(self.case.pairs)]
        again = self.case._replace(reach=lambda: moved_bound(pairs), grid=lambda: grid_of(pairs))
        found = scope_of(self.model, self.summary, again)
        return self.scope == Scope(HERE) or (
            self.scope._replace(bound=0) == found._replace(bound=0) and (0 <= self.scope.bound <= found.bound)
        )

    def failure(self) -> Trace | None:
        """The trace of the first pair on which the next smaller model fails, by that model; None if there is none.

        Drawn (`sv.draw`), what the model saw stands beside what is.  Where it is rounding that fails, all exact.
        """
        from .as_shortcut import shortcut

        smaller = self.smaller
        if smaller is None or smaller.first is None or (place := self._place(smaller.first)) is None:
            return None
        a, b = (s.outline() if isinstance(s, SplitPolygon) else s for s in self.case.body(place))
        return record(a, b, axes=shortcut(smaller.model, a, b))

    @cached_property
    def _prices(self) -> "dict[str, Cost | None]":
        from .costs import costs

        # for one pair numba would take longer to load than all else
        engine = "numpy" if self.summary.pairs == 1 else None
        return costs([j.model for j in self.results], self.case.batches(), engine=engine)

    def prices(self) -> "dict[str, Cost | None]":
        """By model's name what it costs here: nanoseconds a pair, cold (with its set-up) and warm.

        Measured once, for about a second; None for a model of which one call would take too long.
        """
        return self._prices

    def chart(self) -> "Chart":
        """Time against wrong answers of every candidate on these pairs, the advised one marked."""
        from .cost_chart import chart

        return chart(self.model, self.summary, self.results, self.prices())

    def to_json(self, indent: int | None = None) -> str:
        """All of it but prices as JSON; the same each time."""
        f = self.summary
        data = {
            "satviz": "advice 1",
            "model": _model(self.model),
            "reason": self.reason,
            "scope": {
                "kind": self.scope.kind,
                "text": report.holds(self.scope, self.summary),
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
        """In a notebook: the recommendation in words; `chart()` measures, so it is drawn only when it is asked for."""
        return {"text/plain": str(self)}


def _model(model: Model) -> dict[str, Any]:
    return {"name": model.name, "axes": model.axes, "directions": [list(n) for n in model.directions]}


def advise(
    a: "Shape | Shapes | Scene | str", b: "Shape | Shapes | None" = None, pairs: "ArrayLike | None" = None
) -> Recommendation:
    """The least model (fewest axes, then the plainest numbers) that is proven right for what is given.

    a, b: two shapes; or a Scene or its name; or batch shapes, side by side or by the (K, 2) indices `pairs`; or one
    batch, of which by default all pairs are meant whose boxes meet, as a broad phase finds them.  Two shapes need the
    standard library only.  TypeError and ValueError for anything else.
    """
    if isinstance(a, str):
        a = named(a)
    if isinstance(a, Scene):
        if b is not None or pairs is not None:
            raise TypeError("a scene has both its shapes: give nothing else")
        return advise(a.a, a.b)
    if isinstance(a, Shape) and (b is None or isinstance(b, Shape)):
        if pairs is not None:
            raise TypeError("pairs are of batch shapes: make them with batch.Polygons or batch.Circles")
        facts, results, case = _recommend_pair(a, checked(b, "b"))
    else:
        from .advising_batches import recommend_batch

        facts, results, case = recommend_batch(a, b, pairs)
    return Recommendation(facts, results, scope_of(best(results).model, facts, case), case)


def _recommend_pair(a: Shape, b: Shape) -> tuple[InputSummary, tuple[ModelResult, ...], PairsInHand]:
    """The same for two shapes: by fractions alone, or by arrays where that would take long."""
    case = _pair_in_hand(a, b)
    if case.tests <= TESTS_BY_FRACTIONS:
        return *_summarize(case, _candidates(case)), case
    from .advising_batches import recommend_batch, shape_as_batch

    # for one pair numba would take longer to load than all else
    return recommend_batch(shape_as_batch(a), shape_as_batch(b), None, engine="numpy")


def _pair_in_hand(a: Shape, b: Shape) -> PairsInHand:
    def batches() -> Any:
        from .advising_batches import repeated_pair

        return repeated_pair(a, b, copies=max(1, min(4096, TESTS_TIMED // tests)))

    both = [(a, b)]
    corners = [sum(len(p.core) for p in convex_parts(shape)) for shape in (a, b)]
    tests = 2 * corners[0] * corners[1]
    return PairsInHand(
        1,
        both.__getitem__,
        lambda k: (0, 0),
        lambda: (a, b),
        batches,
        lambda: moved_bound(both),
        lambda: grid_of(both),
        tests,
    )


def _candidates(case: PairsInHand) -> tuple[Model, ...]:
    """The candidate models, worked out from the bodies alone."""
    shapes = case.shapes()
    axes = max((count_axes(*case.body(k)) for k in range(case.pairs)), default=1)
    directions = shared_directions(shapes) if case.pairs else ()
    return candidates_of(axes, directions, {kind_of(s) for s in shapes}, case)


def _summarize(case: PairsInHand, models: Sequence[Model]) -> tuple[InputSummary, tuple[ModelResult, ...]]:
    """What there is and what each model is sure of, by integers, pair by pair."""
    relations, least, at = Counter[Relation](), inf, (0, 0)
    wrong, uncertain = Counter[Model](), Counter[Model]()
    first: dict[Model, Pair] = {}
    doubtful: dict[Model, Pair] = {}
    missing = set()
    for k in range(case.known):
        a, b = case.body(k)
        relation, pair = exact_relation(a, b), case.indices(k)
        if k < case.pairs:
            relations[relation] += 1
            if (found := _least_margin(case, k)) < least:
                least, at = found, pair
        for model in models:
            if k >= case.pairs and (model.after_boxes or model.kind == AABB):
                continue  # settled already
            said = certify(model, a, b)
            if said is None:
                uncertain[model] += 1
                doubtful.setdefault(model, pair)
            elif said is not relation:
                wrong[model] += 1
                first.setdefault(model, pair)
            if said is None or bool(said) is not bool(relation):
                missing.add(model)
    shapes = case.shapes()
    corners = [len(p.core) for s in shapes if not s.core_is_point for p in convex_parts(s)] or [0]
    widths = [min(max(s.bounds[2] - s.bounds[0], s.bounds[3] - s.bounds[1]), float_info.max) for s in shapes] or [1.0]
    facts = InputSummary(
        dict(Counter(map(kind_of, shapes))),
        (min(corners), max(corners)),
        min(max(widths) / min(widths), float_info.max),
        case.pairs,
        (relations[Relation.APART], relations[Relation.TOUCHING], relations[Relation.OVERLAPPING]),
        case.settled.pairs if case.settled else 0,
        least,
        at,
    )
    return facts, tuple(
        ModelResult(m, wrong[m], uncertain[m], first.get(m, doubtful.get(m)), m not in missing) for m in models
    )


def _least_margin(case: PairsInHand, k: int) -> float:
    a, b = case.body(k)
    return abs(min(signed_relative_margin(p, q) for p in convex_parts(a) for q in convex_parts(b)))
