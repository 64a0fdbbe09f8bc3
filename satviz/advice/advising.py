"""sv.advise: the least model that is right for a scene, with its proof and what each other one lacks or adds."""

import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import chain
from math import floor, inf, log2
from typing import TYPE_CHECKING, Any, NamedTuple

from ..engine.geometry import Relation
from ..engine.shapes import Shape, checked
from ..engine.shortcut import Shortcut
from ..engine.trace import Trace, record
from ..scenes.named import scene as named
from ..scenes.scenefile import Scene
from . import proofs
from .gamma import gamma
from .proofs import BOXES, CIRCLES, DIRECTIONS, EXACT, FLOAT64, FORMATS, Body, Model

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ..batch import Shapes
    from .chart import Chart
    from .prices import Price

Pair = tuple[int, int]
ANYWHERE, GRID, MOVED, HERE = "anywhere", "on a grid", "moved as a whole", "these coordinates"


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


class Facts(NamedTuple):
    """What there is: shapes by kind, their parts' fewest and most corners, the largest over the smallest, pairs
    by relation.

    `settled`: pairs whose boxes are apart, which no model was asked about; `gamma`: the least, and of which pair.
    """

    kinds: dict[str, int]
    corners: Pair
    sizes: float
    pairs: int
    relations: tuple[int, int, int]
    settled: int
    gamma: float
    at: Pair


class Scope(NamedTuple):
    """Where the advice holds: its kind, one of those above, what that means, and its bound in scene units if any."""

    kind: str
    text: str
    bound: float = 0.0


@dataclass(frozen=True)
class Case:
    """The pairs in hand: the two bodies of pair k, its indices, and the batches (made when they are first needed)."""

    body: Callable[[int], tuple[Body, Body]]
    index: Callable[[int], Pair]
    batches: Callable[[], Any]


@dataclass(frozen=True)
class Advice:
    """The least model that is right: `judged` has every candidate from the fewest axes on, `best` is the one advised.

    The question is the three-way relation.  print() says it in words, `to_json()` as data; `check()` proves it once
    more with integers, `failure()` is the trace of the pair on which the next smaller model fails, `prices()` and
    `chart()` measure what each model costs on this machine.
    """

    facts: Facts
    judged: tuple[Judged, ...]
    scope: Scope
    reason: str
    case: Case

    @property
    def best(self) -> Judged:
        """The candidate advised: the first that is proven."""
        return next(j for j in self.judged if j.proven)

    @property
    def model(self) -> Model:
        """Its model."""
        return self.best.model

    @property
    def smaller(self) -> Judged | None:
        """The next smaller candidate, which fails; None if there is none."""
        place = self.judged.index(self.best)
        return self.judged[place - 1] if place else None

    @property
    def anywhere(self) -> Model:
        """The least that is right wherever these shapes lie: y and x for upright boxes, else what is exact."""
        wide = BOXES if set(self.facts.kinds) == {"upright boxes"} else EXACT
        return next(j.model for j in self.judged if j.model.kind == wide)

    @property
    def for_hits(self) -> Judged:
        """The first candidate that is proven to tell hits from misses, which may confuse touching and overlapping."""
        return next(j for j in self.judged if j.hits)

    def check(self) -> bool:
        """Prove it again with integers, pair by pair (some 0.3 ms each); False if anything claimed does not hold.

        The relation of every pair, without a filter; that the model surely gives it; that each smaller one fails or is
        in doubt on the pair named; and the scope.
        """
        return all(map(self._holds, range(self.facts.pairs))) and all(map(self._fails, self.judged)) and self._scope()

    def _holds(self, k: int) -> bool:
        a, b = self.case.body(k)
        return self.model.sure(a, b) is proofs.exactly(a, b)

    def _fails(self, judged: Judged) -> bool:
        if judged.proven or judged.first is None:
            return judged.proven
        a, b = self.case.body(self._place(judged.first))
        said = judged.model.sure(a, b)
        return said is not proofs.exactly(a, b) and (said is not None or not judged.wrong)

    def _place(self, pair: Pair) -> int:
        return next(k for k in range(self.facts.pairs) if self.case.index(k) == pair)

    def _scope(self) -> bool:
        bodies = map(self.case.body, range(self.facts.pairs))
        if self.scope.kind == ANYWHERE and self.model.kind == BOXES:
            return all(s.is_upright_box for pair in bodies for s in pair)
        if self.scope.kind == GRID:
            form = FORMATS[self.model.kind]
            return proofs.whole(chain.from_iterable(_numbers(p, q) for a, b in bodies for p, q in _parts(a, b)), form)
        if self.scope.kind == MOVED:
            return all(reach_allowed(p, q) >= self.scope.bound for a, b in bodies for p, q in _parts(a, b))
        return True

    def failure(self) -> Trace | None:
        """The trace of the first pair on which the next smaller model fails, by that model; None if there is none.

        Drawn (`sv.draw`), what the model saw stands beside what is.  Where it is rounding that fails, all exact.
        """
        smaller = self.smaller
        if smaller is None or smaller.first is None:
            return None
        a, b = (
            s.outline() if isinstance(s, proofs.Compound) else s for s in self.case.body(self._place(smaller.first))
        )
        return record(a, b, axes=believed(smaller.model, a, b))

    @cached_property
    def _prices(self) -> "dict[str, Price]":
        from .prices import prices

        # for one pair numba would take longer to load than all else
        engine = "numpy" if self.facts.pairs == 1 else None
        return prices([j.model for j in self.judged], self.case.batches(), engine=engine)

    def prices(self) -> "dict[str, Price]":
        """By model's name what it costs here: nanoseconds a pair, cold (with its set-up) and warm; measured once."""
        return self._prices

    def chart(self) -> "Chart":
        """Time against wrong answers of every candidate on these pairs, the advised one marked."""
        from .chart import chart

        return chart(self)

    def to_json(self, indent: int | None = None) -> str:
        """All of it but prices as JSON; the same each time."""
        f = self.facts
        data = {
            "satviz": "advice 1",
            "model": _model(self.model),
            "reason": self.reason,
            "scope": self.scope._asdict(),
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
        from .telling import told

        return told(self)

    def __repr__(self) -> str:
        return f"Advice({self.model.name}, {self.scope.kind})"

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, str]:
        """In a notebook: the advice in words, and its chart."""
        found = {"text/plain": str(self)}
        return found | {"image/svg+xml": self.chart().svg()} if self.facts.pairs else found


def _model(model: Model) -> dict[str, Any]:
    return {"name": model.name, "axes": model.axes, "directions": [list(n) for n in model.directions]}


def advise(
    a: "Shape | Shapes | Scene | str", b: "Shape | Shapes | None" = None, pairs: "ArrayLike | None" = None
) -> Advice:
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
        return _of_two(a.a, a.b)
    if isinstance(a, Shape) and (b is None or isinstance(b, Shape)):
        if pairs is not None:
            raise TypeError("pairs are of batch shapes: make them with batch.Polygons or batch.Circles")
        return _of_two(a, checked(b, "b"))
    from .many import of_many

    return of_many(a, b, pairs)


def _of_two(a: Shape, b: Shape) -> Advice:
    from ..engine.concave import parts

    relation = proofs.exactly(a, b)
    directions = proofs.shared_directions((a, b))
    models = proofs.candidates(proofs.axes_asked(a, b), directions, bool(a.radius and b.radius))
    judged = [judge_one(model, a, b, relation) for model in models]
    kinds: dict[str, int] = {}
    for shape in (a, b):
        kinds[kind_of(shape)] = kinds.get(kind_of(shape), 0) + 1
    corners = [len(p.core) for s in (a, b) if not s.radius for p in parts(s)] or [0]
    sizes = [max(s.bounds[2] - s.bounds[0], s.bounds[3] - s.bounds[1]) for s in (a, b)]
    counts = tuple(int(relation is r) for r in Relation)
    ratio = max(sizes) / min(sizes) if min(sizes) else float("inf")
    facts = Facts(kinds, (min(corners), max(corners)), ratio, 1, counts, 0, gamma(a, b), (0, 0))  # type: ignore[arg-type]

    def batches() -> Any:
        from .many import of_shapes

        return of_shapes(a, b)

    def reach() -> float:
        allowed = min(reach_allowed(p, q) for p in parts(a) for q in parts(b))
        return bound_of(float(min(allowed, Fraction(FLOAT64.most))), max(a.reach, b.reach))

    def grid(form: proofs.Format) -> int | None:
        return proofs.unit(chain.from_iterable(_numbers(p, q) for p in parts(a) for q in parts(b)), form)

    return settled(facts, judged, Case(lambda k: (a, b), lambda k: (0, 0), batches), reach, grid)


def judge_one(model: Model, a: Body, b: Body, relation: Relation) -> Judged:
    """A model on one pair."""
    said = model.sure(a, b)
    wrong, unsure = said not in (None, relation), said is None
    return Judged(
        model,
        int(wrong),
        int(unsure),
        (0, 0) if wrong or unsure else None,
        said is not None and bool(said) is bool(relation),
    )


def kind_of(shape: Shape) -> str:
    """What kind of shape it is, in words."""
    if shape.radius:
        return "circles"
    return "upright boxes" if shape.is_upright_box else "convex polygons" if shape.is_convex else "concave polygons"


def settled(
    facts: Facts,
    judged: Sequence[Judged],
    case: Case,
    reach: Callable[[], float],
    grid: Callable[[proofs.Format], int | None],
) -> Advice:
    """The advice, with why it holds and how far: `reach` and `grid` tell that of plain floats."""
    best = next(j for j in judged if j.proven)
    kind, only_boxes = best.model.kind, set(facts.kinds) == {"upright boxes"}
    polygons = "circles" not in facts.kinds
    here = "this pair as it lies" if facts.pairs == 1 else "these pairs as they lie: it is proven on each of them"
    scope = Scope(HERE, here)
    if not facts.pairs:
        reason = "no two boxes meet, so there is nothing left to ask"
    elif kind == BOXES and only_boxes:
        reason = "upright boxes are their bounding boxes, and comparisons round nothing"
        scope = Scope(ANYWHERE, "anywhere: upright boxes need y and x only, whatever their coordinates")
    elif kind == BOXES:
        reason = "the bounding boxes lie to each other as the shapes do, and comparisons round nothing"
    elif kind == CIRCLES:
        reason = "the circles around the shapes lie to each other as the shapes do, by more than rounding can hide"
    elif kind == DIRECTIONS:
        reason = "on these directions the ranges lie to each other as the shapes do, by more than rounding can hide"
    elif kind == EXACT:
        reason = "where the floats of a pair cannot tell, it asks integers"
        scope = Scope(ANYWHERE, "anywhere: it is exact for all coordinates")
    elif len({k == "circles" for k in facts.kinds}) == 1 and (unit := grid(FORMATS[kind])) is not None:
        form = FORMATS[kind]
        reason = f"all numbers are whole multiples of 2^{unit}, so few of it that {form.name} rounds nothing"
        what, bound = "circles" if "circles" in facts.kinds else "polygons", 2.0 ** (unit + form.whole)
        scope = Scope(GRID, f"any {what} whose numbers are multiples of 2^{unit}, up to 2^{unit + form.whole}", bound)
    else:
        reason = f"every pair is decided by more than the roundings of {kind} can hide"
        if kind == FLOAT64.name and polygons and (bound := reach()) > 0:
            text = f"the scene moved as a whole, exactly, while no coordinate exceeds 2^{log2(bound):.0f}"
            scope = Scope(MOVED, text, bound)
    return Advice(facts, tuple(judged), scope, reason, case)


def reach_allowed(a: Shape, b: Shape) -> Fraction:
    """How far from the origin a pair of convex polygons may be moved as a whole, for SAT on float64 to stay proven.

    A move changes no turn and no span, so what decides stays gamma * u * span * reach: reach may grow until gamma is
    the roundings asked (and one, as gamma itself is rounded).
    """
    reach = max(abs(c) for s in (a, b) for c in s.bounds)
    return Fraction(gamma(a, b)) * Fraction(reach) / (proofs.LOOKS + 1)


def bound_of(allowed: float, reach: float) -> float:
    """A power of two below what is allowed; 0 if that is no further than the shapes reach."""
    bound = min(2.0 ** floor(log2(allowed)), FLOAT64.most) if 0 < allowed < inf else 0.0
    return bound if bound > reach else 0.0


def believed(model: Model, a: Shape, b: Shape) -> Shortcut:
    """A model as the loop with other axes, to record and draw a pair on which it fails."""
    from .believing import shortcut

    return shortcut(model, a, b)


def _parts(a: Body, b: Body) -> list[tuple[Shape, Shape]]:
    return [(p, q) for p in proofs.pieces(a) for q in proofs.pieces(b)]


def _numbers(a: Shape, b: Shape) -> list[float]:
    return [*chain.from_iterable((*a.core, *b.core)), *(s.radius for s in (a, b) if s.radius)]
