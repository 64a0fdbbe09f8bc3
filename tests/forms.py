"""Every form in which satviz computes the relation of two shapes, as a function from pairs to answers.

A new form is one line: FORMS["its name"] = Form(lambda pairs: ...).  It returns one answer a pair, in their
order (None where it does not accept such a pair).  Batch forms get all pairs at once.
"""

from collections.abc import Callable, Hashable, Sequence
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from functools import partial
from itertools import groupby
from math import isfinite
from typing import Any, NamedTuple

import numpy as np
import shapely

from satviz import Trace, batch, record, relate
from satviz.batch.arrays import Shapes
from satviz.engine import axes
from satviz.engine.certificate import SharedPoint
from satviz.engine.geometry import InvalidScene, Relation, Vec
from satviz.engine.relate import relate_moved
from satviz.engine.shapes import Circle, Polygon, Shape
from satviz.engine.shortcut import Shortcut
from satviz.scenes.failing import SHORTCUTS

Pairs = Sequence[tuple[Shape, Shape]]
ENGINES = "numpy", "numba"


def is_the_relation(answer: Any, truth: Relation) -> bool:
    """Return whether an answer is the exact relation."""
    return answer == truth


def is_the_hit(answer: Any, truth: Relation) -> bool:
    """Return whether an answer is right about a hit."""
    return bool(answer) == bool(truth)


def misses_nothing(answer: Any, truth: Relation) -> bool:
    """Return whether an answer misses no hit; the broad phase may keep a pair that is apart."""
    return bool(answer) or not truth


class Form(NamedTuple):
    """One way to compute answers: `ask(pairs)` returns them, `fits(answer, truth)` checks one of them.

    `one_in`: a slow form is run for one pair in so many.  `overflows`: the form may have no answer about a
    pair although it has one about the same pair scaled down.
    """

    ask: Callable[[Pairs], Sequence]
    fits: Callable[[Any, Relation], bool] = is_the_relation
    one_in: int = 1
    overflows: bool = False


FORMS: dict[str, Form] = {}
RARE: dict[str, Form] = {}  # slow to start: run once, for pairs of all kinds


def one_by_one_with(ask: Callable[[Shape, Shape], Any]) -> Callable[[Pairs], list]:
    """Return a function that computes the answer of each pair by itself."""
    return lambda pairs: [ask(a, b) for a, b in pairs]


def is_convex(shape: Shape) -> bool:
    """Return whether a shape is a circle or a convex polygon."""
    return isinstance(shape, Circle) or shape.is_convex


def by_shortcut(shortcut: Shortcut, a: Shape, b: Shape) -> Relation | None:
    """Return the relation in a shortcut's trace; None where its floats overflow or a box has no seam in float64."""
    try:
        return record(a, b, axes=shortcut).relation
    except InvalidScene as error:
        if shortcut.split:
            assert "cannot cut A into pieces" in str(error) and a.is_upright_box
        else:
            assert "overflow" in str(error) and shortcut.measure and max(a.max_coordinate, b.max_coordinate) > 1e150
        return None


# -- one by one ------------------------------------------------------------------------------------

FORMS["relate"] = Form(one_by_one_with(relate))
FORMS["relate_moved by nothing"] = Form(
    one_by_one_with(lambda a, b: relate_moved(a, b, Vec(0.0, 0.0)) if is_convex(a) and is_convex(b) else None)
)
FORMS["record"] = Form(one_by_one_with(lambda a, b: record(a, b).relation), one_in=8)
FORMS["record: its claim"] = Form(one_by_one_with(lambda a, b: record(a, b).claim), one_in=8)
FORMS["record: a hit"] = Form(one_by_one_with(lambda a, b: record(a, b).hit), is_the_hit, one_in=16)
FORMS["record every axis"] = Form(one_by_one_with(lambda a, b: record(a, b, every_axis=True).relation), one_in=8)
FORMS["record every axis: its claim"] = Form(
    one_by_one_with(lambda a, b: record(a, b, every_axis=True).claim), one_in=8
)
FORMS["record all edge normals: its claim"] = Form(
    one_by_one_with(
        lambda a, b: trace.claim if (trace := record(a, b, axes=axes.edge_normals)).choice.complete else None
    ),
    one_in=16,
)
FORMS["record without early exit"] = Form(
    one_by_one_with(lambda a, b: record(a, b).without_early_exit().relation), one_in=16
)
FORMS["record through JSON"] = Form(
    one_by_one_with(lambda a, b: Trace.from_json(record(a, b).to_json()).relation), one_in=40
)
for name in ("world", "edge-normals-of-a", "edge-normals-of-b", "hull-normals", "centers", "nearest-vertex"):
    FORMS[f"record with {name}"] = Form(
        one_by_one_with(lambda a, b, choice=axes.NAMED[name]: record(a, b, axes=choice).relation), one_in=16
    )
for name in ("lengths", "raw-depth", "touch-as-apart", "tile-seam"):
    FORMS[f"record by the shortcut {name}"] = Form(
        one_by_one_with(partial(by_shortcut, SHORTCUTS[name])), one_in=16, overflows=True
    )
FORMS["record with slipped normals: a gap is a proof"] = Form(
    one_by_one_with(lambda a, b: record(a, b, axes=SHORTCUTS["slipped-normal"]).claim), misses_nothing, one_in=16
)
FORMS["record with one given direction"] = Form(
    one_by_one_with(lambda a, b: record(a, b, axes=axes.directions((2, 1))).relation), one_in=16
)


def certified_hit(a: Shape, b: Shape) -> bool | str:
    """Return whether the certificate proves a hit, or a text if it does not hold."""
    certificate = record(a, b).certificate
    return isinstance(certificate, SharedPoint) if certificate.check() else "nothing proven"


def proof_fits(answer: bool | str, truth: Relation) -> bool:
    """Return whether a certificate proves the truth."""
    return answer is bool(truth)


FORMS["certificate"] = Form(one_by_one_with(certified_hit), proof_fits, one_in=16)

# -- batches ---------------------------------------------------------------------------------------


def batch_of(shapes: Sequence[Shape]) -> Shapes:
    """Return a batch of shapes in this order; concave polygons are split."""
    runs = [list(run) for _, run in groupby(shapes, type)]
    made = [
        batch.Circles([c.center for c in run], [c.radius for c in run])
        if isinstance(run[0], Circle)
        else batch.Polygons(run, concave="split")
        for run in runs
    ]
    return made[0] if len(made) == 1 else batch.concat(made)


def both_batches(pairs: Pairs) -> tuple[Shapes, Shapes]:
    """Return the batches of the first and of the second shapes of pairs."""
    return batch_of([a for a, _ in pairs]), batch_of([b for _, b in pairs])


def batched(ask: Callable[..., Sequence], **options: Any) -> Callable[[Pairs], Sequence]:
    """Return a function that computes the answers of all pairs in one call."""
    return lambda pairs: ask(*both_batches(pairs), **options)


def grouped(ask: Callable[[Pairs], Sequence], key: Callable[[int, Shape, Shape], Hashable]) -> Callable[[Pairs], list]:
    """Return a function that computes the pairs of each key in one call; the answer is None where the key is None."""

    def answers(pairs: Pairs) -> list:
        groups: dict[Hashable, list[int]] = {}
        for i, (a, b) in enumerate(pairs):
            groups.setdefault(key(i, a, b), []).append(i)
        found: list = [None] * len(pairs)
        for k, mine in groups.items():
            if k is not None:
                for i, answer in zip(mine, ask([pairs[i] for i in mine]), strict=True):
                    found[i] = answer
        return found

    return answers


def corner_counts(i: int, a: Shape, b: Shape) -> tuple[int, int] | None:
    """Return the key of shapes with as many corners, whose batches are one group each and need no gathering."""
    counts = tuple(1 if isinstance(s, Circle) else len(s.corners) for s in (a, b))
    return counts if is_convex(a) and is_convex(b) else None


def in_blocks_of(size: int) -> Callable[[int, Shape, Shape], int]:
    """Return the key of blocks of so many pairs."""
    return lambda i, a, b: i // size


def one_against_many(pairs: Pairs, engine: str) -> list:
    """Return the relations of each first shape against all second ones and vice versa, which must agree."""
    a, b = both_batches(pairs)
    found = []
    for i, (p, q) in enumerate(pairs):
        one, other = batch_of([p]), batch_of([q])
        answers = {int(batch.relate(one, b, engine=engine)[i]), int(batch.relate(a, other, engine=engine)[i])}
        found.append(answers.pop() if len(answers) == 1 else f"{answers}, by which is the one")
    return found


def by_index(pairs: Pairs, engine: str) -> Sequence:
    """Return the relations of pairs given by their indices, with the second shapes stored backwards."""
    a, b = batch_of([a for a, _ in pairs]), batch_of([b for _, b in pairs][::-1])
    i = np.arange(len(pairs))
    return batch.relate(a, b, np.stack([i, i[::-1]], axis=1), engine=engine)


def one_after_another(rings: list) -> Shapes:
    """Return a batch from the concatenated vertices of all rings and their offsets."""
    return batch.Polygons(np.concatenate(rings), offsets=np.cumsum([0, *map(len, rings)]), concave="split")


def padded(rings: list) -> Shapes:
    """Return a batch from one array, in which the last vertex is repeated until all rings have as many."""
    most = max(map(len, rings))
    return batch.Polygons(np.array([[*ring, *[ring[-1]] * (most - len(ring))] for ring in rings]), concave="split")


def of_shapely(rings: list) -> Shapes:
    """Return a batch from shapely polygons."""
    return batch.from_shapely([shapely.Polygon(ring) for ring in rings], concave="split")


def laid_out(make: Callable[[list], Shapes], engine: str) -> Callable[[Pairs], list]:
    """Return a function that relates raw vertices in one memory layout, side by side and by index."""

    def answers(pairs: Pairs) -> list:
        a, b = (make([pair[k].vertices for pair in pairs]) for k in (0, 1))
        i = np.arange(len(pairs))
        side_by_side = batch.relate(a, b, engine=engine).tolist()
        by_index = batch.relate(a, b, np.stack([i, i], axis=1), engine=engine).tolist()
        return [p if p == q else f"{p} or, by index, {q}" for p, q in zip(side_by_side, by_index, strict=True)]

    return grouped(answers, lambda i, a, b: 0 if isinstance(a, Polygon) and isinstance(b, Polygon) else None)


def picked(pick: Callable[[Shapes], Shapes], around: Callable[[list], list]) -> Callable[[Pairs], Sequence]:
    """Return a function that relates batches with more shapes (`around`), of which `pick` selects the pairs."""

    def answers(pairs: Pairs) -> Sequence:
        a, b = (batch_of(around([pair[k] for pair in pairs])) for k in (0, 1))
        return batch.relate(pick(a), pick(b))

    return answers


def doubled(shapes: list) -> list:
    """Return each shape twice."""
    return [s for s in shapes for _ in "ab"]


def every_second(shapes: Shapes) -> np.ndarray:
    """Return a mask that selects every second shape."""
    return np.arange(len(shapes)) % 2 == 0


def shuffled(pairs: Pairs) -> list:
    """Return the relations of the pairs, computed in a random order."""
    a, b = both_batches(pairs)
    order = np.random.default_rng(len(pairs)).permutation(len(pairs))
    answers = batch.relate(a[order], b[order.tolist()])
    return answers[np.argsort(order)].tolist()


def from_the_end(pairs: Pairs) -> Sequence:
    """Return the relations of the pairs, computed from the last to the first."""
    a, b = both_batches(pairs)
    back = -1 - np.arange(len(pairs))
    return batch.relate(a[back], b[::-1])[::-1]


def one_by_one(pairs: Pairs) -> list:
    """Return the relations of the pairs, each computed with one shape of either batch."""
    a, b = both_batches(pairs)
    return [int(batch.relate(a[i], b[i - len(pairs)])[0]) for i in range(len(pairs))]


def in_three(pairs: Pairs) -> Sequence:
    """Return the relations of batches that are concatenated from three."""
    third = -(-len(pairs) // 3)
    pieces = [both_batches(pairs[i : i + third]) for i in range(0, len(pairs), third)]
    a, b = (batch.concat([piece[k] for piece in pieces]) for k in (0, 1))
    return batch.relate(a, b)


def threaded(pairs: Pairs) -> Sequence:
    """Return the relations of the pairs, computed in two threads."""
    with ThreadPoolExecutor(2) as pool:
        return batch.relate(*both_batches(pairs), executor=pool, chunk=-(-len(pairs) // 5))


def in_processes(pairs: Pairs) -> Sequence:
    """Return the relations of the pairs, computed in two processes."""
    with ProcessPoolExecutor(2) as pool:
        return batch.relate(*both_batches(pairs), engine="numpy", executor=pool, chunk=-(-len(pairs) // 5))


def colliding(pairs: Pairs, engine: str) -> list[bool]:
    """Return for each pair whether it is among the colliding pairs of all shapes together."""
    return _found(batch.colliding_pairs(batch_of([s for pair in pairs for s in pair]), engine=engine), len(pairs))


def colliding_kinds(pairs: Pairs, engine: str) -> list[bool]:
    """Return for each pair whether it collides in a batch joined of one array for each number of corners."""
    shapes = [s for pair in pairs for s in pair]
    counts = np.array([corner_counts(0, s, s)[0] for s in shapes])
    made = []
    for v in np.unique(counts).tolist():
        own = [s for s, count in zip(shapes, counts, strict=True) if count == v]
        if v == 1:
            made.append(batch.Circles(np.array([s.center for s in own]), np.array([s.radius for s in own])))
        else:
            made.append(batch.Polygons(np.array([s.core for s in own])))
    order = np.argsort(counts, kind="stable")
    return _found(np.sort(order[batch.colliding_pairs(batch.concat(made), engine=engine)], axis=1), len(pairs))


def colliding_padded(pairs: Pairs, engine: str) -> list[bool]:
    """Return for each pair whether it collides in a batch of padded arrays, with nothing after the last corner."""
    shapes = [s for pair in pairs for s in pair]
    counts = np.array([1 if isinstance(s, Circle) else len(s.vertices) for s in shapes])
    corners = np.full((len(shapes), counts.max(), 2), np.nan)
    for i, s in enumerate(shapes):
        corners[i, : counts[i]] = s.center if isinstance(s, Circle) else s.vertices
    radii = np.array([s.radius if isinstance(s, Circle) else 0.0 for s in shapes])
    return _found(batch.colliding_pairs(batch.from_padded(corners, counts, radii), engine=engine), len(pairs))


def convex_blocks(i: int, a: Shape, b: Shape) -> int | None:
    """Return the key of blocks of 8 pairs of convex shapes, None for other pairs."""
    return i // 8 if is_convex(a) and is_convex(b) else None


def candidates(pairs: Pairs, engine: str) -> list[bool]:
    """Return for each pair whether it is among the candidate pairs of all bounding boxes."""
    bounds = [s.bounds for pair in pairs for s in pair]
    return _found(batch.candidate_pairs(bounds, engine=engine), len(pairs))


def streamed(pairs: Pairs) -> list[bool]:
    """Return for each pair whether it collides, in a stream of strips of 3 shapes with as many vertices each."""
    rings = [list(s.vertices) for pair in pairs for s in pair]
    most = max(map(len, rings))
    array = np.array([ring + ring[-1:] * (most - len(ring)) for ring in rings])
    return _found(np.concatenate(list(batch.stream_colliding_pairs(array, strip=3))), len(pairs))


def _found(indices: np.ndarray, n: int) -> list[bool]:
    """Return for shapes 2 i and 2 i + 1 whether their pair of indices is listed."""
    known = set(map(tuple, indices.tolist()))
    return [(2 * i, 2 * i + 1) in known for i in range(n)]


def blocks_of_convex_polygons(i: int, a: Shape, b: Shape) -> int | None:
    """Return the key of blocks of 8 pairs of convex polygons, None for other pairs."""
    return i // 8 if all(isinstance(s, Polygon) and s.is_convex for s in (a, b)) else None


def blocks_of_bounded(size: int) -> Callable[[int, Shape, Shape], int | None]:
    """Return the key of blocks of pairs whose boxes are finite: a circle can reach beyond float64, a box cannot."""
    return lambda i, a, b: i // size if all(isfinite(c) for s in (a, b) for c in s.bounds) else None


for engine in ENGINES:
    FORMS[f"batch, {engine}"] = Form(batched(batch.relate, engine=engine), one_in=2)
    FORMS[f"batch of one kind, {engine}"] = Form(grouped(batched(batch.relate, engine=engine), corner_counts), one_in=6)
    FORMS[f"batch of one pair, {engine}"] = Form(
        grouped(batched(batch.relate, engine=engine), in_blocks_of(1)), one_in=40
    )
    FORMS[f"one against many, {engine}"] = Form(
        grouped(partial(one_against_many, engine=engine), in_blocks_of(5)), one_in=60
    )
    FORMS[f"pairs by index, {engine}"] = Form(partial(by_index, engine=engine), one_in=20)
    for make in (one_after_another, padded, of_shapely):
        FORMS[f"batch {make.__name__}, {engine}"] = Form(laid_out(make, engine), one_in=8)
    FORMS[f"hits, {engine}"] = Form(batched(batch.hits, engine=engine), is_the_hit, one_in=20)
    FORMS[f"colliding_pairs, {engine}"] = Form(
        grouped(partial(colliding, engine=engine), in_blocks_of(5)), is_the_hit, one_in=40
    )
    FORMS[f"colliding_pairs of kinds, {engine}"] = Form(
        grouped(partial(colliding_kinds, engine=engine), convex_blocks), is_the_hit, one_in=20
    )
    FORMS[f"colliding_pairs from padded, {engine}"] = Form(
        grouped(partial(colliding_padded, engine=engine), convex_blocks), is_the_hit, one_in=20
    )
    some = partial(candidates, engine=engine)
    FORMS[f"candidate_pairs, {engine}"] = Form(grouped(some, blocks_of_bounded(40)), misses_nothing, one_in=2)
    FORMS[f"candidate_pairs of two, {engine}"] = Form(grouped(some, blocks_of_bounded(1)), misses_nothing, one_in=8)
FORMS["colliding_pairs of two"] = Form(
    grouped(partial(colliding, engine="numpy"), in_blocks_of(1)), is_the_hit, one_in=40
)
FORMS["stream_colliding_pairs"] = Form(grouped(streamed, blocks_of_convex_polygons), is_the_hit, one_in=60)
FORMS["batch[1:]"] = Form(picked(lambda s: s[1:], lambda shapes: shapes[:1] + shapes), one_in=20)
FORMS["batch[:-2]"] = Form(picked(lambda s: s[:-2], lambda shapes: shapes + shapes[:1] * 2), one_in=20)
FORMS["batch[::2]"] = Form(picked(lambda s: s[::2], doubled), one_in=20)
FORMS["batch[mask]"] = Form(picked(lambda s: s[every_second(s)], doubled), one_in=20)
FORMS["batch[order]"] = Form(shuffled, one_in=20)
FORMS["batch from the end"] = Form(from_the_end, one_in=20)
FORMS["batch[i]"] = Form(one_by_one, one_in=40)
FORMS["batch of three"] = Form(in_three, one_in=20)
FORMS["batch, tiny chunks"] = Form(batched(batch.relate, chunk=3), one_in=40)
FORMS["batch, threads"] = Form(threaded, one_in=20)
RARE["batch, processes"] = Form(in_processes)
