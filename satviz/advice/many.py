"""sv.advise for many pairs: the same facts and proofs, worked out with arrays."""

from collections.abc import Sequence
from math import inf
from sys import float_info
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import batch
from ..batch.arrays import Shapes, checked
from ..engine.shapes import Circle, Shape
from . import proofs
from .facts import CONCAVE, CONVEX, ROUND, UPRIGHT, Case, Facts, Judged, Pair
from .gammas import signed_gammas
from .models import shared_directions
from .pairs import Indices, Pairs, indexed, one, paired, reach
from .proofs import Body, Compound, Format, Model
from .scope import bound_of
from .sure import Grid, sure


def of_many(a: Any, b: Any, pairs: ArrayLike | None) -> tuple[Facts, tuple[Judged, ...], Case]:
    """What there is in batch shapes and the models judged on them; see `advise`."""
    a = checked(a, "a")
    settled_by_boxes = 0
    if b is None:
        b = a
        if pairs is None:
            farthest = float_info.max  # which a circle may pass
            pairs = batch.candidate_pairs(np.clip(a.bounds, -farthest, farthest))
            settled_by_boxes = len(a) * (len(a) - 1) // 2 - len(pairs)
    b = checked(b, "b")
    ia, ib = indexed(a, b, pairs)
    both = paired(a, ia, b, ib)
    exact = batch.relate(a, b, np.stack([ia, ib], axis=1))
    used = [(a, np.unique([ia, ib]))] if a is b else [(a, np.unique(ia)), (b, np.unique(ib))]
    kinds = _kinds(used)

    def body(k: int) -> tuple[Body, Body]:
        return _body(a, int(ia[k])), _body(b, int(ib[k]))

    def bound() -> float:
        most = np.maximum(_reach(a)[both.pa], _reach(b)[both.pb])
        gamma = np.abs(signed_gammas(a.parts, b.parts, np.stack([both.pa, both.pb], axis=1)))
        # gamma is good to one part in fifty
        return bound_of(float((gamma * 0.9 * most).min()) / (proofs.LOOKS + 1), float(most.max()))

    def unit(form: Format) -> int | None:
        found = [Grid.of_parts(s.parts) for s in (a, b)]
        units = min(float(g.unit[p].min(initial=5000)) for g, p in zip(found, (both.pa, both.pb)))
        most = max(float(g.most[p].max(initial=0)) for g, p in zip(found, (both.pa, both.pb)))
        return proofs.unit((2.0**units, most), form) if -1000 < units < 1000 else None

    case = Case(
        len(ia),
        body,
        lambda k: (int(ia[k]), int(ib[k])),
        lambda: [_body(shapes, i) for shapes, some in used for i in some.tolist()],
        lambda: both,
        bound,
        unit,
    )
    asked = models_for(both, set(kinds)) if case.pairs else proofs.NO_PAIRS
    judged = tuple(_judged(model, both, exact, case) for model in asked)
    signed = signed_gammas(a, b, np.stack([ia, ib], axis=1))
    worst = int(np.abs(signed).argmin()) if case.pairs else 0
    least, at = (float(abs(signed[worst])), case.indices(worst)) if case.pairs else (inf, (0, 0))
    apart, touching, over = np.bincount(exact, minlength=3).tolist()
    facts = Facts(kinds, _corners(both), _sizes(both), case.pairs, (apart, touching, over), settled_by_boxes, least, at)
    return facts, judged, case


def of_shapes(a: Shape, b: Shape, copies: int = 4096) -> Pairs:
    """One pair as many, to be timed: its answers in one call, over and over."""
    one_side, other = (
        batch.Circles([s.center], s.radius) if isinstance(s, Circle) else batch.Polygons([s], concave="split")
        for s in (a, b)
    )
    nothing = np.zeros(copies, np.intp)
    return paired(one_side, nothing, other, nothing)


def models_for(case: Pairs, kinds: set[str]) -> list[Model]:
    """The candidates for these pairs."""
    edges = [np.where(s.parts.count == 1, 0, s.parts.count) for s in (case.a, case.b)]
    each = edges[0][case.pa] + edges[1][case.pb]
    each += (edges[0][case.pa] == 0) | (edges[1][case.pb] == 0)
    asked = np.bincount(case.of, each, minlength=len(case.ia))
    used = case.a[np.unique(case.ia)], case.b[np.unique(case.ib)]
    directions = shared_directions(*used) if ROUND not in kinds else ()
    return proofs.candidates(int(asked.max(initial=1)), directions, kinds == {ROUND})


def _judged(model: Model, both: Pairs, exact: NDArray[np.int8], case: Case) -> Judged:
    told = sure(model, both, exact)
    for k in np.flatnonzero(told < 0).tolist():  # arrays need more room than fractions: up to the first real doubt
        said = model.sure(*case.body(k))
        if said is None:
            break
        told[k] = said
    unsure = told < 0
    wrong = ~unsure & (told != exact)
    bad = np.flatnonzero(wrong)
    bad = bad if bad.size else np.flatnonzero(unsure)
    first = case.indices(int(bad[0])) if bad.size else None
    hits = not unsure.any() and bool(((told > 0) == (exact > 0)).all())
    return Judged(model, int(wrong.sum()), int(unsure.sum()), first, hits)


def _kinds(sides: Sequence[tuple[Shapes, Indices]]) -> dict[str, int]:
    found: dict[str, int] = {}
    for shapes, used in sides:
        parts = np.diff(shapes.starts)[used]
        first = shapes.starts[used]
        upright = shapes.parts.flat.upright[first] & (parts == 1)
        circles = shapes.count[first] == 1
        for name, many in (
            (UPRIGHT, upright),
            (ROUND, circles),
            (CONVEX, (parts == 1) & ~upright & ~circles),
            (CONCAVE, parts > 1),
        ):
            if many.any():
                found[name] = found.get(name, 0) + int(many.sum())
    return found


def _corners(case: Pairs) -> Pair:
    counts = np.concatenate([case.a.count[case.pa], case.b.count[case.pb]])
    counts = counts[counts > 1]
    return (int(counts.min()), int(counts.max())) if counts.size else (0, 0)


def _sizes(case: Pairs) -> float:
    if not len(case.ia):
        return 1.0
    with np.errstate(all="ignore"):
        widths = [(s.bounds[:, 2:] - s.bounds[:, :2]).max(axis=1) for s in (case.a, case.b)]
        some = np.minimum(np.concatenate([widths[0][case.ia], widths[1][case.ib]]), float_info.max)
        return float(min(some.max() / some.min(), float_info.max))


def _reach(shapes: Shapes) -> NDArray[np.float64]:
    found = np.empty(len(shapes.count))
    for v, g in shapes.parts.groups.items():
        found[shapes.count == v] = reach(g)
    return found


def _body(shapes: Shapes, i: int) -> Body:
    pieces = [one(shapes.parts, k) for k in range(shapes.starts[i], shapes.starts[i + 1])]
    return pieces[0] if len(pieces) == 1 else Compound(pieces)
