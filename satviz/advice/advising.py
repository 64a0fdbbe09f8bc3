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
from . import certified_bounds, report
from .certified_bounds import Compound, Model, pieces
from .facts import Case, Facts, ModelResult, Pair, anywhere, best, candidates, for_hits, kind_of
from .limits import MAX_TESTS_CHECKED, TESTS_BY_FRACTIONS, TESTS_TIMED
from .relative_margin import signed
from .scope import HERE, Scope, grid_of, reach_of, scope_of

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ..batch import Shapes
    from .cost_chart import Chart
    from .costs import Cost


@dataclass(frozen=True)
class Recommendation:
    """The least model that is right: `judged` has every candidate from the fewest axes on, `best` is the one advised.

    The question is the three-way relation.  print() says it in words, `to_json()` as data; `check()` proves it once
    more with integers, `failure()` is the trace of the pair on which the next smaller model fails, `prices()` and
    `chart()` measure what each model costs on this machine.
    """

    facts: Facts
    judged: tuple[ModelResult, ...]
    scope: Scope
    case: Case

    @property
    def best(self) -> ModelResult:
        """The candidate advised: the first that is proven."""
        return best(self.judged)

    @property
    def model(self) -> Model:
        """Its model."""
        return self.best.model

    @property
    def smaller(self) -> ModelResult | None:
        """The next smaller candidate, which fails; None if there is none."""
        place = self.judged.index(self.best)
        return self.judged[place - 1] if place else None

    @property
    def anywhere(self) -> Model:
        """The least that is right wherever these shapes lie: y and x for upright boxes, else what is exact."""
        return anywhere(self.facts, self.judged)

    @property
    def for_hits(self) -> ModelResult:
        """The first candidate that is proven to tell hits from misses, which may confuse touching and overlapping."""
        return for_hits(self.judged)

    @property
    def reason(self) -> str:
        """Why it is right, in words."""
        return report.reason(self.model, self.facts, self.scope)

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
        if tuple(j.model for j in self.judged) != models:
            return False
        facts, judged = _counted(self.case, models)
        return (
            self._has(facts)
            and all(self._bears(claim, found) for claim, found in zip(self.judged, judged, strict=True))
            and self._scope()
        )

    def _has(self, found: Facts) -> bool:
        mine, place = self.facts, self._place(self.facts.at)
        if mine != found._replace(gamma=mine.gamma, at=mine.at):
            return False
        if place is None:
            return not mine.pairs
        # arrays have gamma good to one part in fifty
        return all(isclose(mine.gamma, known, rel_tol=0.025) for known in (found.gamma, _gamma(self.case, place)))

    def _bears(self, claim: ModelResult, found: ModelResult) -> bool:
        """Arrays may doubt what integers prove, if another pair is in doubt anyway."""
        if (claim.proven, claim.hits) != (found.proven, found.hits):
            return False
        if not claim.wrong <= found.wrong <= found.wrong + found.unsure <= claim.wrong + claim.unsure:
            return False
        if claim.wrong and claim.wrong == found.wrong and claim.first != found.first:
            return False
        place = None if claim.first is None else self._place(claim.first)
        if place is None or claim.proven:
            return claim.first is None and claim.proven
        a, b = self.case.body(place)
        said = claim.model.sure(a, b)
        return said is not None and said is not certified_bounds.exactly(a, b) if claim.wrong else said is None

    def _place(self, pair: Pair) -> int | None:
        return next((k for k in range(self.case.known) if self.case.indices(k) == pair), None)

    def _scope(self) -> bool:
        pairs = [self.case.body(k) for k in range(self.case.pairs)]
        again = self.case._replace(reach=lambda: reach_of(pairs), grid=lambda: grid_of(pairs))
        found = scope_of(self.model, self.facts, again)
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
        a, b = (s.outline() if isinstance(s, Compound) else s for s in self.case.body(place))
        return record(a, b, axes=shortcut(smaller.model, a, b))

    @cached_property
    def _prices(self) -> "dict[str, Cost | None]":
        from .costs import costs

        # for one pair numba would take longer to load than all else
        engine = "numpy" if self.facts.pairs == 1 else None
        return costs([j.model for j in self.judged], self.case.batches(), engine=engine)

    def prices(self) -> "dict[str, Cost | None]":
        """By model's name what it costs here: nanoseconds a pair, cold (with its set-up) and warm.

        Measured once, for about a second; None for a model of which one call would take too long.
        """
        return self._prices

    def chart(self) -> "Chart":
        """Time against wrong answers of every candidate on these pairs, the advised one marked."""
        from .cost_chart import chart

        return chart(self.model, self.facts, self.judged, self.prices())

    def to_json(self, indent: int | None = None) -> str:
        """All of it but prices as JSON; the same each time."""
        f = self.facts
        data = {
            "satviz": "advice 1",
            "model": _model(self.model),
            "reason": self.reason,
            "scope": {
                "kind": self.scope.kind,
                "text": report.holds(self.scope, self.facts),
                "bound": self.scope.bound,
            },
            "anywhere": self.anywhere.name,
            "for_hits": self.for_hits.model.name,
            "facts": {**f._asdict(), "gamma": f.gamma if f.pairs else None},
            "candidates": [
                {**_model(j.model), "wrong": j.wrong, "unsure": j.unsure, "first": j.first, "proven": j.proven}
                for j in self.judged
            ],
        }
        return json.dumps(data, indent=indent, allow_nan=False)

    def __str__(self) -> str:
        return report.told(self.facts, self.judged, self.scope)

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
        facts, judged, case = _of_two(a, checked(b, "b"))
    else:
        from .many import of_many

        facts, judged, case = of_many(a, b, pairs)
    return Recommendation(facts, judged, scope_of(best(judged).model, facts, case), case)


def _of_two(a: Shape, b: Shape) -> tuple[Facts, tuple[ModelResult, ...], Case]:
    """The same for two shapes: by fractions alone, or by arrays where that would take long."""
    case = _two(a, b)
    if case.tests <= TESTS_BY_FRACTIONS:
        return *_counted(case, _candidates(case)), case
    from .many import as_batch, of_many

    # for one pair numba would take longer to load than all else
    return of_many(as_batch(a), as_batch(b), None, engine="numpy")


def _two(a: Shape, b: Shape) -> Case:
    def batches() -> Any:
        from .many import of_shapes

        return of_shapes(a, b, copies=max(1, min(4096, TESTS_TIMED // tests)))

    both = [(a, b)]
    corners = [sum(len(p.core) for p in pieces(shape)) for shape in (a, b)]
    tests = 2 * corners[0] * corners[1]
    return Case(
        1,
        both.__getitem__,
        lambda k: (0, 0),
        lambda: (a, b),
        batches,
        lambda: reach_of(both),
        lambda: grid_of(both),
        tests,
    )


def _candidates(case: Case) -> tuple[Model, ...]:
    """The candidate models, worked out from the bodies alone."""
    shapes = case.shapes()
    axes = max((certified_bounds.axes_asked(*case.body(k)) for k in range(case.pairs)), default=1)
    directions = certified_bounds.shared_directions(shapes) if case.pairs else ()
    return candidates(axes, directions, {kind_of(s) for s in shapes}, case)


def _counted(case: Case, models: Sequence[Model]) -> tuple[Facts, tuple[ModelResult, ...]]:
    """What there is and what each model is sure of, by integers, pair by pair."""
    relations, least, at = Counter[Relation](), inf, (0, 0)
    wrong, unsure = Counter[Model](), Counter[Model]()
    first: dict[Model, Pair] = {}
    doubtful: dict[Model, Pair] = {}
    missing = set()
    for k in range(case.known):
        a, b = case.body(k)
        relation, pair = certified_bounds.exactly(a, b), case.indices(k)
        if k < case.pairs:
            relations[relation] += 1
            if (found := _gamma(case, k)) < least:
                least, at = found, pair
        for model in models:
            if k >= case.pairs and (model.after_boxes or model.kind == certified_bounds.BOXES):
                continue  # settled already
            said = model.sure(a, b)
            if said is None:
                unsure[model] += 1
                doubtful.setdefault(model, pair)
            elif said is not relation:
                wrong[model] += 1
                first.setdefault(model, pair)
            if said is None or bool(said) is not bool(relation):
                missing.add(model)
    shapes = case.shapes()
    corners = [len(p.core) for s in shapes if not s.core_is_point for p in pieces(s)] or [0]
    widths = [min(max(s.bounds[2] - s.bounds[0], s.bounds[3] - s.bounds[1]), float_info.max) for s in shapes] or [1.0]
    facts = Facts(
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
        ModelResult(m, wrong[m], unsure[m], first.get(m, doubtful.get(m)), m not in missing) for m in models
    )


def _gamma(case: Case, k: int) -> float:
    a, b = case.body(k)
    return abs(min(signed(p, q) for p in pieces(a) for q in pieces(b)))
