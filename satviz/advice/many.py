"""sv.advise for many pairs: the same facts and proofs, worked out with arrays."""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import batch
from ..batch.arrays import Shapes, checked
from ..engine.shapes import Circle, Shape
from . import models, proofs
from .advising import Advice, Case, Facts, Judged, Pair, bound_of, settled
from .models import Pairs, paired
from .proofs import Body, Compound, Format, Model
from .turns import listed, one, reach, signed_gammas


def of_many(a: Any, b: Any, pairs: ArrayLike | None) -> Advice:
    """The advice on batch shapes; see `advise`."""
    a = checked(a, "a")
    settled_by_boxes = 0
    if b is None:
        b = a
        if pairs is None:
            pairs = batch.candidate_pairs(a.bounds)
            settled_by_boxes = len(a) * (len(a) - 1) // 2 - len(pairs)
    b = checked(b, "b")
    ia, ib = listed(a, b, pairs)
    case = paired(a, ia, b, ib)
    exact = batch.relate(a, b, np.stack([ia, ib], axis=1))
    kinds = _kinds(a, np.unique([ia, ib])) if a is b else _kinds(a, np.unique(ia), b, np.unique(ib))
    used = set(kinds)
    asked = models_for(case, used) if len(ia) else [Model(proofs.BOXES, 2), Model(proofs.EXACT, 0)]
    signed = signed_gammas(a, b, np.stack([ia, ib], axis=1))
    worst = int(np.abs(signed).argmin()) if len(signed) else 0
    least = float(abs(signed[worst])) if len(signed) else float("inf")
    counts = np.bincount(exact, minlength=3).tolist()
    facts = Facts(
        kinds,
        _corners(case),
        _sizes(case),
        len(ia),
        (counts[0], counts[1], counts[2]),
        settled_by_boxes,
        least,
        (int(ia[worst]), int(ib[worst])) if len(ia) else (0, 0),
    )

    def body(k: int) -> tuple[Body, Body]:
        return _body(a, int(ia[k])), _body(b, int(ib[k]))

    def index(k: int) -> Pair:
        return int(ia[k]), int(ib[k])

    judged = [_judged(model, case, exact, body) for model in asked]

    def bound() -> float:
        if not len(ia):
            return 0.0
        most = np.maximum(_reach(a)[case.pa], _reach(b)[case.pb])
        gamma = np.abs(signed_gammas(a.parts, b.parts, np.stack([case.pa, case.pb], axis=1)))
        # gamma is good to one part in fifty
        return bound_of(float((gamma * 0.9 * most).min()) / (proofs.LOOKS + 1), float(most.max()))

    def grid(form: Format) -> int | None:
        found = [models.Grid.of_parts(s.parts) for s in (a, b)]
        units = min(float(g.unit[p].min(initial=5000)) for g, p in zip(found, (case.pa, case.pb)))
        most = max(float(g.most[p].max(initial=0)) for g, p in zip(found, (case.pa, case.pb)))
        return proofs.unit((2.0**units, most), form) if -1000 < units < 1000 else None

    return settled(facts, judged, Case(body, index, lambda: case), bound, grid)


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
    directions = models.shared_directions(*used) if "circles" not in kinds else ()
    return proofs.candidates(int(asked.max(initial=1)), directions, kinds == {"circles"})


def _judged(model: Model, case: Pairs, exact: NDArray[np.int8], body: Callable[[int], tuple[Body, Body]]) -> Judged:
    told = models.sure(model, case, exact)
    for k in np.flatnonzero(told < 0).tolist():  # arrays need more room than fractions: up to the first real doubt
        said = model.sure(*body(k))
        if said is None:
            break
        told[k] = said
    unsure = told < 0
    wrong = ~unsure & (told != exact)
    bad = np.flatnonzero(wrong)
    bad = bad if bad.size else np.flatnonzero(unsure)
    first = (int(case.ia[bad[0]]), int(case.ib[bad[0]])) if bad.size else None
    hits = not unsure.any() and bool(((told > 0) == (exact > 0)).all())
    return Judged(model, int(wrong.sum()), int(unsure.sum()), first, hits)


def _kinds(*sides: Any) -> dict[str, int]:
    found: dict[str, int] = {}
    for shapes, used in zip(sides[::2], sides[1::2]):
        parts = np.diff(shapes.starts)[used]
        first = shapes.starts[used]
        upright = shapes.parts.flat.upright[first] & (parts == 1)
        circles = shapes.count[first] == 1
        for name, many in (
            ("upright boxes", upright),
            ("circles", circles),
            ("convex polygons", (parts == 1) & ~upright & ~circles),
            ("concave polygons", parts > 1),
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
        some = np.concatenate([widths[0][case.ia], widths[1][case.ib]])
        return float(some.max() / some.min())


def _reach(shapes: Shapes) -> NDArray[np.float64]:
    found = np.empty(len(shapes.count))
    for v, g in shapes.parts.groups.items():
        found[shapes.count == v] = reach(g)
    return found


def _body(shapes: Shapes, i: int) -> Body:
    pieces = [one(shapes.parts, k) for k in range(shapes.starts[i], shapes.starts[i + 1])]
    return pieces[0] if len(pieces) == 1 else Compound(pieces)
