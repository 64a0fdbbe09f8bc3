"""sv.advise for many pairs: the same facts and proofs, worked out with arrays."""

from collections.abc import Collection, Sequence
from math import inf
from sys import float_info
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import batch
from ..batch.arrays import Shapes, check_shapes
from ..batch.broad_phase import candidate_blocks, sort_pairs
from ..batch.codes import APART
from ..batch.narrow_phase import engine_of
from ..batch.ragged import Rings
from ..engine.geometry import InvalidScene
from ..engine.shapes import Circle, Shape
from . import certified_bounds
from .certified_bounds import BOXES, CIRCLES, EXACT, Body, Compound, Model
from .classify import Grids, sure
from .facts import CONCAVE, CONVEX, ROUND, UPRIGHT, Case, Facts, Grid, ModelResult, Pair, Settled, candidates
from .limits import refuse_more, refuse_more_boxes, refuse_more_by_fractions
from .margins import signed_gammas
from .models import by_boxes, discs, is_circle, shared_directions
from .pairs import Array, Indices, Pairs, indexed, one, paired, reach
from .rounding import FLOAT64, FORMATS
from .scope import bound_of


def of_many(
    a: Any, b: Any, pairs: ArrayLike | None, *, engine: str | None = None
) -> tuple[Facts, tuple[ModelResult, ...], Case]:
    """What there is in batch shapes and the models judged on them; see `advise`.  `engine`: as in `batch.relate`."""
    a = check_shapes(a, "a")
    all_pairs = b is None and pairs is None
    b = a if b is None else check_shapes(b, "b")
    ia, ib = _whose_boxes_meet(a.bounds, engine) if all_pairs else indexed(a, b, pairs)
    if not len(ia) and not (all_pairs and len(a) > 1):
        what = "there are no pairs" if pairs is None else "pairs is empty"
        raise ValueError(f"{what}, so there is nothing to advise on: give at least one pair")
    refuse_more(*(work := _work(a, ia, b, ib)))
    both = paired(a, ia, b, ib)
    extreme = _out_of_range(both)
    refuse_more_by_fractions(extreme, extreme)
    exact = batch.relate(a, b, np.stack([ia, ib], axis=1), engine=engine)
    settled, near = None, paired(a, ia[:0], a, ia[:0])
    if all_pairs and len(ia) < (every := len(a) * (len(a) - 1) // 2):
        settled, near = _settled(a, every - len(ia), engine)
    used = [(a, np.unique([ia, ib]))] if a is b else [(a, np.unique(ia)), (b, np.unique(ib))]
    kinds = _kinds(used)
    numbers = np.concatenate([ia, near.ia]), np.concatenate([ib, near.ib])
    case = Case(
        len(ia),
        lambda k: (_body(a, int(numbers[0][k])), _body(b, int(numbers[1][k]))),
        lambda k: (int(numbers[0][k]), int(numbers[1][k])),
        lambda: [_body(shapes, i) for shapes, some in used for i in some.tolist()],
        lambda: both,
        lambda: _bound(both, engine),
        lambda: _grid(both),
        work[1] + _work(a, near.ia, a, near.ib)[1],
        settled,
    )
    judged = tuple(_judged(model, both, exact, near, case, engine) for model in _models(both, kinds, case))
    signed = signed_gammas(a, b, np.stack([ia, ib], axis=1), engine=engine)
    worst = int(np.abs(signed).argmin()) if case.pairs else 0
    least, at = (float(abs(signed[worst])), case.indices(worst)) if case.pairs else (inf, (0, 0))
    apart, touching, over = np.bincount(exact, minlength=3).tolist()
    by_boxes = settled.pairs if settled else 0
    facts = Facts(kinds, _corners(both), _sizes(both), case.pairs, (apart, touching, over), by_boxes, least, at)
    return facts, judged, case


def _whose_boxes_meet(bounds: Array, engine: str | None) -> tuple[Indices, Indices]:
    """All pairs of which the boxes meet, in order; counted while they are found, so that they never fill the memory."""
    farthest = float_info.max  # which a circle may pass
    blocks, many = [], 0
    for block in candidate_blocks(np.clip(bounds, -farthest, farthest), engine_of(engine).grid):
        many += len(block)
        refuse_more_boxes(many, len(bounds))
        blocks.append(block)
    found = sort_pairs(blocks)
    return found[:, 0], found[:, 1]


def _work(a: Shapes, ia: Indices, b: Shapes, ib: Indices) -> tuple[int, int]:
    """How many pairs of convex parts, and how many tests of an edge against a corner, both ways."""
    parts = [np.diff(s.starts)[i] for s, i in ((a, ia), (b, ib))]
    corners = [np.diff(s.rings.start[s.starts])[i] for s, i in ((a, ia), (b, ib))]
    tests = 2.0 * (corners[0].astype(float) * corners[1]).sum()
    return int((parts[0].astype(float) * parts[1]).sum()), int(tests)


def _out_of_range(both: Pairs) -> int:
    """How many pairs of convex parts have products beyond the range of floats, so that integers must tell them."""
    with np.errstate(over="ignore"):
        most = np.maximum(_reach(both.a)[both.pa], _reach(both.b)[both.pb])
    return int(np.count_nonzero(~((most > 2.0**-450) & (most < 2.0**450))))


def _settled(a: Shapes, many: int, engine: str | None) -> tuple[Settled, Pairs]:
    """What the boxes settle; and which of these pairs a model that stands alone, by one circle a shape, may doubt.

    With M the larger reach of two circles, u the rounding, d their distance and R the sum of the radii, they
    are surely told apart where d - R is 72 u M or more: the bound of `certified_bounds.circles` for ranges,
    and more than its bound for squares, 12 u (d + R) + 5 sqrt(2) u M with d + R at most 4.9 M.  So boxes of
    the circles that are 100 u M wider on each side (u of float32 where that is a candidate) meet for every
    pair that can be doubted.
    """
    only_circles = bool(is_circle(a).all())
    forms = FORMATS if only_circles else {CIRCLES: FLOAT64}
    disc = discs(a)
    with np.errstate(all="ignore"):
        reach = np.abs(disc[:, :2]).max(axis=1) + disc[:, 2]
        trusted = {k: f for k, f in forms.items() if (reach < f.most).all() and (disc[:, 2] > f.least).all()}
        nothing = paired(a, np.empty(0, np.intp), a, np.empty(0, np.intp))
        exact = {EXACT} if only_circles else set()
        if not trusted:
            return Settled(many, 0, frozenset(exact), only_circles), nothing
        wide = (disc[:, 2] + 100 * 2.0 ** -min(f.bits for f in trusted.values()) * reach)[:, None]
        boxes = np.concatenate([disc[:, :2] - wide, disc[:, :2] + wide], axis=1)
    try:
        i, j = _whose_boxes_meet(boxes, engine)
    except InvalidScene:  # too many to look at: no model is judged alone
        return Settled(many, 0, frozenset(exact), only_circles), nothing
    apart = by_boxes(a.bounds[i], a.bounds[j]) == APART
    near = paired(a, i[apart], a, j[apart])
    return Settled(many, len(near.ia), frozenset(exact | trusted.keys()), only_circles), near


def _bound(both: Pairs, engine: str | None) -> float:
    most = np.maximum(_reach(both.a)[both.pa], _reach(both.b)[both.pb])
    signed = signed_gammas(both.a.parts, both.b.parts, np.stack([both.pa, both.pb], axis=1), engine=engine)
    # gamma is good to one part in fifty
    return bound_of(float((np.abs(signed) * 0.9 * most).min()) / (certified_bounds.LOOKS + 1), float(most.max()))


def _grid(both: Pairs) -> Grid | None:
    """The grid of all parts in the pairs; None also where its unit is at the ends of float64's range."""
    found = [Grids(*(c[p] for c in Grids.of(s.parts))) for s, p in ((both.a, both.pa), (both.b, both.pb))]
    unit = min(float(g.unit.min()) for g in found)
    most, span = (max(float(c.max()) for c in both) for both in zip(*(g[1:] for g in found), strict=True))
    if not (-1000 < unit < 1000 and most * 2.0**-unit < 2.0**53):
        return None
    return Grid(int(unit), int(most * 2.0**-unit), int(span * 2.0**-unit))


def as_batch(shape: Shape) -> Shapes:
    """A batch of the one shape, with the convex parts that it already knows."""
    if isinstance(shape, Circle):
        return batch.Circles([shape.center], shape.radius)
    cores = [np.asarray(part.core) for part in certified_bounds.pieces(shape)]
    start = np.cumsum([0, *map(len, cores)])
    x, y = np.concatenate(cores).T.copy()
    owner = np.zeros(len(cores), np.int64) if len(cores) > 1 else None
    return Shapes(np.diff(start), owner, rings=Rings(x, y, start))


def of_shapes(a: Shape, b: Shape, copies: int = 4096) -> Pairs:
    """One pair as many, to be timed: its answers in one call, over and over."""
    nothing = np.zeros(copies, np.intp)
    return paired(as_batch(a), nothing, as_batch(b), nothing)


def _models(pairs: Pairs, kinds: Collection[str], case: Case) -> tuple[Model, ...]:
    """The candidates for these pairs."""
    edges = [np.where(s.parts.count == 1, 0, s.parts.count) for s in (pairs.a, pairs.b)]
    each = edges[0][pairs.pa] + edges[1][pairs.pb]
    each += (edges[0][pairs.pa] == 0) | (edges[1][pairs.pb] == 0)
    asked = np.bincount(pairs.of, each, minlength=len(pairs.ia))
    used = pairs.a[np.unique(pairs.ia)], pairs.b[np.unique(pairs.ib)]
    directions = shared_directions(*used) if case.pairs and ROUND not in kinds else ()
    return candidates(int(asked.max(initial=1)), directions, kinds, case)


def _judged(
    model: Model, both: Pairs, exact: NDArray[np.int8], near: Pairs, case: Case, engine: str | None
) -> ModelResult:
    told = _told(model, both, exact, case, 0, engine)
    if not (model.after_boxes or model.kind == BOXES):
        apart = np.zeros(len(near.ia), np.int8)
        told = np.concatenate([told, _told(model, near, apart, case, case.pairs, engine)])
        exact = np.concatenate([exact, apart])
    unsure = told < 0
    wrong = ~unsure & (told != exact)
    bad = np.flatnonzero(wrong)
    bad = bad if bad.size else np.flatnonzero(unsure)
    first = case.indices(int(bad[0])) if bad.size else None
    hits = not unsure.any() and bool(((told > 0) == (exact > 0)).all())
    return ModelResult(model, int(wrong.sum()), int(unsure.sum()), first, hits)


def _told(
    model: Model, pairs: Pairs, exact: NDArray[np.int8], case: Case, first: int, engine: str | None
) -> NDArray[np.int8]:
    """What the model is sure of on these pairs, which have numbers from `first` on in the case."""
    told = sure(model, pairs, exact, engine=engine)
    if model.kind not in FORMATS:  # which has asked fractions itself, part by part
        doubt = np.flatnonzero(told < 0)
        for many, k in enumerate(doubt.tolist()):  # arrays need more room than fractions: up to the first real doubt
            refuse_more_by_fractions(many, len(doubt))
            said = model.sure(*case.body(first + k))
            if said is None:
                break
            told[k] = said
    return told


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
