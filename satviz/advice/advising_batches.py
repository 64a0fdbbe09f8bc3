"""`sv.advise` for many pairs: summary, results and scope as in `advising.py`, computed with arrays.

`engine` stands for the engine of `batch.relate` throughout: "numpy", "numba", or None for the faster one installed.
"""

from collections.abc import Collection, Sequence
from math import inf
from sys import float_info
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import batch
from ..batch.arrays import Shapes, check_shapes
from ..batch.broad_phase import broad_phase_of, candidate_blocks, sort_pairs
from ..batch.codes import APART
from ..batch.engines import engine_of
from ..batch.narrow_phase import check_pairs
from ..batch.ragged import RaggedRings
from ..engine.geometry import InvalidScene
from ..engine.shapes import Circle, Shape
from .candidates import AABB, BOUNDING_CIRCLES, EXACT_FILTER, AnyShape, Model, SplitPolygon, convex_parts
from .certified_bounds import SAT_ROUNDINGS, certify
from .classify import PartUnits, classify
from .limits import refuse_too_many_boxes, refuse_too_many_fractions, refuse_too_many_tests
from .margins import max_coordinates, signed_relative_margins
from .models import bounding_circles, compare_boxes, is_circle, shared_directions
from .pairs import Array, Indices, PartPairs, paired, part_shape, tests_per_pair
from .records import (
    CIRCLES,
    CONCAVE_POLYGONS,
    CONVEX_POLYGONS,
    UPRIGHT_BOXES,
    BroadPhaseResult,
    CommonUnit,
    GivenPairs,
    IndexPair,
    InputSummary,
    ModelResult,
    candidates_of,
)
from .rounding import FLOAT64, FORMATS
from .scope import power_of_two_bound

NOTHING = np.empty(0, np.intp), np.empty(0, np.intp)  # the indices of no pairs


def recommend_batch(
    a: Any, b: Any, pairs: ArrayLike | None, *, engine: str | None = None
) -> tuple[InputSummary, tuple[ModelResult, ...], GivenPairs]:
    """Return (summary, results, given pairs) for batch shapes; `a`, `b`, `pairs`: as in `advise`."""
    a = check_shapes(a, "a")
    all_pairs = b is None and pairs is None
    b = a if b is None else check_shapes(b, "b")
    ia, ib = _pairs_with_meeting_boxes(a.bounds, engine) if all_pairs else _indexed(a, b, pairs)
    if not len(ia) and not (all_pairs and len(a) > 1):
        what = "there are no pairs" if pairs is None else "pairs is empty"
        raise ValueError(f"{what}, so there is nothing to advise on: give at least one pair")
    refuse_too_many_tests(*(work := _count_work(a, ia, b, ib)))
    both = paired(a, ia, b, ib)
    extreme = _out_of_range(both)
    refuse_too_many_fractions(extreme, extreme)
    exact = batch.relate(a, b, np.stack([ia, ib], axis=1), engine=engine)
    broad_phase, (i, j) = None, NOTHING
    if all_pairs and len(ia) < (every := len(a) * (len(a) - 1) // 2):
        broad_phase, (i, j) = _count_apart_by_boxes(a, every - len(ia), engine)
    near = paired(a, i, a, j)
    used = [(a, np.unique([ia, ib]))] if a is b else [(a, np.unique(ia)), (b, np.unique(ib))]
    kinds = _kinds(used)
    numbers = np.concatenate([ia, near.ia]), np.concatenate([ib, near.ib])
    signed = signed_relative_margins(both, engine=engine)
    given = GivenPairs(
        len(ia),
        lambda k: (_shape_of(a, int(numbers[0][k])), _shape_of(b, int(numbers[1][k]))),
        lambda k: (int(numbers[0][k]), int(numbers[1][k])),
        lambda: [_shape_of(shapes, i) for shapes, some in used for i in some.tolist()],
        lambda: both,
        lambda: _moved_bound(both, signed),
        lambda: _common_unit(both),
        work[1] + _count_work(a, near.ia, a, near.ib)[1],
        broad_phase,
    )
    results = tuple(_evaluate_model(model, both, exact, near, given, engine) for model in _models(both, kinds, given))
    worst = int(np.abs(signed).argmin()) if given.pairs else 0
    least, at = (float(abs(signed[worst])), given.indices(worst)) if given.pairs else (inf, (0, 0))
    apart, touching, over = np.bincount(exact, minlength=3).tolist()
    by_boxes = broad_phase.pairs if broad_phase else 0
    search = broad_phase_of(a, engine="numpy") if all_pairs else None  # without numba, so that all get the same result
    summary = InputSummary(
        kinds, _corners(both), _size_ratio(both), given.pairs, (apart, touching, over), by_boxes, least, at, search
    )
    return summary, results, given


def _indexed(a: Shapes, b: Shapes, pairs: ArrayLike | None) -> tuple[Indices, Indices]:
    """Return (ia, ib), the indices of the pairs; if `pairs` is None, shape i of a with shape i of b.

    Errors as in `batch.relate`.
    """
    if pairs is not None:
        return check_pairs(pairs, len(a), len(b))
    if len(a) != len(b):
        raise ValueError(
            f"a has {len(a)} shapes and b has {len(b)}: give two batches of the same length, or name the pairs (pairs=)"
        )
    every = np.arange(len(a))
    return every, every


def _pairs_with_meeting_boxes(bounds: Array, engine: str | None) -> tuple[Indices, Indices]:
    """Return (i, j), sorted, of all pairs of the (N, 4) boxes that meet; InvalidScene as soon as there are too many."""
    farthest = float_info.max  # the box of a circle may exceed it
    blocks, many = [], 0
    for block in candidate_blocks(np.clip(bounds, -farthest, farthest), engine_of(engine)):
        many += len(block)
        refuse_too_many_boxes(many, len(bounds))
        blocks.append(block)
    found = sort_pairs(blocks)
    return found[:, 0], found[:, 1]


def _count_work(a: Shapes, ia: Indices, b: Shapes, ib: Indices) -> tuple[int, int]:
    """Return (number of pairs of convex parts, number of tests of an edge against a corner)."""
    parts = [np.diff(s.starts)[i] for s, i in ((a, ia), (b, ib))]
    return int((parts[0].astype(float) * parts[1]).sum()), int(tests_per_pair(a, ia, b, ib).sum())


def _out_of_range(both: PartPairs) -> int:
    """Return how many pairs of convex parts have coordinates so large or small that only integers are safe."""
    with np.errstate(over="ignore"):
        most = np.maximum(_part_max_coordinates(both.a)[both.pa], _part_max_coordinates(both.b)[both.pb])
    return int(np.count_nonzero(~((most > 2.0**-450) & (most < 2.0**450))))


def _count_apart_by_boxes(a: Shapes, many: int, engine: str | None) -> tuple[BroadPhaseResult, tuple[Indices, Indices]]:
    """Return (BroadPhaseResult, (i, j) of the pairs apart by boxes that circles alone might not certify as apart).

    With M the larger max_coordinate (radius included) of two circles, u the unit roundoff, d their distance and R the
    sum of the radii, the circles are certified apart where d - R is 72 u M or more: the bound of `certify_circles` for
    ranges, and more than its bound for squares, 12 u (d + R) + 5 sqrt(2) u M with d + R at most 4.9 M.  So boxes of the
    circles that are 100 u M wider on each side (u of float32 where that is a candidate) meet for every pair that is
    not certified.  `many` is the number of pairs that are apart by their boxes.
    """
    only_circles = bool(is_circle(a).all())
    forms = FORMATS if only_circles else {BOUNDING_CIRCLES: FLOAT64}
    disc = bounding_circles(a)
    with np.errstate(all="ignore"):
        max_coordinate = np.abs(disc[:, :2]).max(axis=1) + disc[:, 2]
        trusted = {k: f for k, f in forms.items() if (max_coordinate < f.most).all() and (disc[:, 2] > f.least).all()}
        exact = {EXACT_FILTER} if only_circles else set()
        if not trusted:
            return BroadPhaseResult(many, 0, frozenset(exact), only_circles), NOTHING
        wide = (disc[:, 2] + 100 * 2.0 ** -min(f.bits for f in trusted.values()) * max_coordinate)[:, None]
        boxes = np.concatenate([disc[:, :2] - wide, disc[:, :2] + wide], axis=1)
    try:
        i, j = _pairs_with_meeting_boxes(boxes, engine)
    except InvalidScene:  # too many: every model follows the boxes
        return BroadPhaseResult(many, 0, frozenset(exact), only_circles), NOTHING
    apart = compare_boxes(a.bounds[i], a.bounds[j]) == APART
    near = i[apart], j[apart]
    return BroadPhaseResult(many, len(near[0]), frozenset(exact | trusted.keys()), only_circles), near


def _moved_bound(both: PartPairs, signed: Array) -> float:
    """Return the power of two up to which these convex polygons may be moved as a whole; 0 if they exceed it already.

    `signed`: the signed relative margin of each pair of parts.
    """
    most = np.maximum(_part_max_coordinates(both.a)[both.pa], _part_max_coordinates(both.b)[both.pb])
    # arrays compute the relative margin to one part in fifty
    return power_of_two_bound(float((np.abs(signed) * 0.9 * most).min()) / (SAT_ROUNDINGS + 1), float(most.max()))


def _common_unit(both: PartPairs) -> CommonUnit | None:
    """Return the CommonUnit of all numbers in the pairs; None if the unit is too large or too small for float64."""
    found = [PartUnits(*(c[p] for c in PartUnits.of(s.parts))) for s, p in ((both.a, both.pa), (both.b, both.pb))]
    unit = min(float(g.unit.min()) for g in found)
    most, span = (max(float(c.max()) for c in both) for both in zip(*(g[1:] for g in found), strict=True))
    if not (-1000 < unit < 1000 and most * 2.0**-unit < 2.0**53):
        return None
    return CommonUnit(int(unit), int(most * 2.0**-unit), int(span * 2.0**-unit))


def shape_as_batch(shape: Shape) -> Shapes:
    """Return a batch that holds this shape alone, with the convex parts already computed."""
    if isinstance(shape, Circle):
        return batch.Circles([shape.center], shape.radius)
    cores = [np.asarray(part.core) for part in convex_parts(shape)]
    start = np.cumsum([0, *map(len, cores)])
    x, y = np.concatenate(cores).T.copy()
    owner = np.zeros(len(cores), np.int64) if len(cores) > 1 else None
    return Shapes(rings=RaggedRings(x, y, start), owner=owner)


def repeated_pair(a: Shape, b: Shape, copies: int = 4096) -> PartPairs:
    """Return many copies of one pair, so that one call can be timed."""
    nothing = np.zeros(copies, np.intp)
    return paired(shape_as_batch(a), nothing, shape_as_batch(b), nothing)


def _models(pairs: PartPairs, kinds: Collection[str], given: GivenPairs) -> tuple[Model, ...]:
    """Return the candidate models for these pairs; `kinds`: the kinds of their shapes, in words as `kind_of` has them.

    The number of axes and the directions of a k-DOP are computed from the shapes.
    """
    edges = [np.where(s.parts.count == 1, 0, s.parts.count) for s in (pairs.a, pairs.b)]
    each = edges[0][pairs.pa] + edges[1][pairs.pb]
    each += (edges[0][pairs.pa] == 0) | (edges[1][pairs.pb] == 0)
    axes = np.bincount(pairs.of, each, minlength=len(pairs.ia))
    used = pairs.a[np.unique(pairs.ia)], pairs.b[np.unique(pairs.ib)]
    directions = shared_directions(*used) if given.pairs and CIRCLES not in kinds else ()
    return candidates_of(int(axes.max(initial=1)), directions, kinds, given)


def _evaluate_model(
    model: Model, both: PartPairs, exact: NDArray[np.int8], near: PartPairs, given: GivenPairs, engine: str | None
) -> ModelResult:
    """Return the ModelResult of a model on the pairs `both`, and on `near` unless it tests the boxes first or alone.

    exact: (n,) the exact relations of `both`; near: pairs that are apart by their boxes.
    """
    found = _classify(model, both, exact, given, 0, engine)
    if not (model.after_boxes or model.kind == AABB):
        apart = np.zeros(len(near.ia), np.int8)
        found = np.concatenate([found, _classify(model, near, apart, given, given.pairs, engine)])
        exact = np.concatenate([exact, apart])
    uncertain = found < 0
    wrong = ~uncertain & (found != exact)
    bad = np.flatnonzero(wrong)
    bad = bad if bad.size else np.flatnonzero(uncertain)
    first = given.indices(int(bad[0])) if bad.size else None
    hits = not uncertain.any() and bool(((found > 0) == (exact > 0)).all())
    return ModelResult(model, int(wrong.sum()), int(uncertain.sum()), first, hits)


def _classify(
    model: Model, pairs: PartPairs, exact: NDArray[np.int8], given: GivenPairs, first: int, engine: str | None
) -> NDArray[np.int8]:
    """Return the relation that the model certainly finds for each pair, -1 where it is uncertain or not decided.

    After the first pair that stays uncertain, pairs that arrays cannot decide are not decided by fractions any more.

    Pair k of `pairs` is number `first` + k of `given`; exact: (n,) their exact relations.
    """
    found = classify(model, pairs, exact, engine=engine)
    if model.kind not in FORMATS:  # SAT has used fractions already, part by part
        uncertain = np.flatnonzero(found < 0)
        for many, k in enumerate(uncertain.tolist()):  # the bounds of arrays are wider than those of fractions
            refuse_too_many_fractions(many, len(uncertain))
            relation = certify(model, *given.shapes_of(first + k))
            if relation is None:
                break  # one uncertain pair is enough to reject the model
            found[k] = relation
    return found


def _kinds(sides: Sequence[tuple[Shapes, Indices]]) -> dict[str, int]:
    """Return how many of the used shapes are of each kind; `sides` lists (batch, indices of used shapes)."""
    found: dict[str, int] = {}
    for shapes, used in sides:
        parts = np.diff(shapes.starts)[used]
        first = shapes.starts[used]
        upright = shapes.parts.flat.upright[first] & (parts == 1)
        circles = shapes.count[first] == 1
        for name, many in (
            (UPRIGHT_BOXES, upright),
            (CIRCLES, circles),
            (CONVEX_POLYGONS, (parts == 1) & ~upright & ~circles),
            (CONCAVE_POLYGONS, parts > 1),
        ):
            if many.any():
                found[name] = found.get(name, 0) + int(many.sum())
    return found


def _corners(given: PartPairs) -> IndexPair:
    """Return (fewest, most) corners of the polygonal convex parts in the pairs; (0, 0) if all are circles."""
    counts = np.concatenate([given.a.count[given.pa], given.b.count[given.pb]])
    counts = counts[counts > 1]
    return (int(counts.min()), int(counts.max())) if counts.size else (0, 0)


def _size_ratio(given: PartPairs) -> float:
    """Return the largest shape's size divided by the smallest one's, at most the largest float; 1 without pairs.

    The size is the longer side of the bounding box.
    """
    if not len(given.ia):
        return 1.0
    with np.errstate(all="ignore"):
        widths = [(s.bounds[:, 2:] - s.bounds[:, :2]).max(axis=1) for s in (given.a, given.b)]
        some = np.minimum(np.concatenate([widths[0][given.ia], widths[1][given.ib]]), float_info.max)
        return float(min(some.max() / some.min(), float_info.max))


def _part_max_coordinates(shapes: Shapes) -> NDArray[np.float64]:
    """Return the largest absolute coordinate of each convex part, plus the radius of circles."""
    found = np.empty(len(shapes.count))
    for v, g in shapes.parts.groups.items():
        found[shapes.count == v] = max_coordinates(g)
    return found


def _shape_of(shapes: Shapes, i: int) -> AnyShape:
    """Return shape i of a batch as a single Shape, or as a SplitPolygon if it has several convex parts."""
    parts = [part_shape(shapes.parts, k) for k in range(shapes.starts[i], shapes.starts[i + 1])]
    return parts[0] if len(parts) == 1 else SplitPolygon(parts)
