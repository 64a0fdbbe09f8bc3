"""Every form in which satviz gives a verdict about pairs, as a function from pairs to answers.

A new form is one line: FORMS["its name"] = Form(lambda pairs: ...), an answer a pair in
order (None where it does not take such a pair).  Batch forms get all pairs at once.
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


def the_relation(answer: Any, truth: Relation) -> bool:
    return answer == truth


def a_hit(answer: Any, truth: Relation) -> bool:
    return bool(answer) == bool(truth)


def no_miss(answer: Any, truth: Relation) -> bool:
    """The broad phase may keep a pair that is apart."""
    return bool(answer) or not truth


class Form(NamedTuple):
    """`ask(pairs)` gives the answers, `fits(answer, truth)` judges one; a dear form takes one pair in `one_in`.

    One that `overflows` may have no answer about a pair, and one about the same pair made smaller.
    """

    ask: Callable[[Pairs], Sequence]
    fits: Callable[[Any, Relation], bool] = the_relation
    one_in: int = 1
    overflows: bool = False


FORMS: dict[str, Form] = {}
RARE: dict[str, Form] = {}  # slow to start: asked once, about pairs of all kinds


def each(ask: Callable[[Shape, Shape], Any]) -> Callable[[Pairs], list]:
    return lambda pairs: [ask(a, b) for a, b in pairs]


def is_convex(shape: Shape) -> bool:
    return isinstance(shape, Circle) or shape.is_convex


def by_shortcut(shortcut: Shortcut, a: Shape, b: Shape) -> Relation | None:
    """None where what the shortcut measures in plain floats overflows, or a box has no seam in float64."""
    try:
        return record(a, b, axes=shortcut).relation
    except InvalidScene as error:
        if shortcut.split:
            assert "cannot take A apart" in str(error) and a.is_upright_box
        else:
            assert "overflow" in str(error) and shortcut.measure and max(a.max_coordinate, b.max_coordinate) > 1e150
        return None


# -- one by one ------------------------------------------------------------------------------------

FORMS["relate"] = Form(each(relate))
FORMS["relate_moved by nothing"] = Form(
    each(lambda a, b: relate_moved(a, b, Vec(0.0, 0.0)) if is_convex(a) and is_convex(b) else None)
)
FORMS["record"] = Form(each(lambda a, b: record(a, b).relation), one_in=8)
FORMS["record: its claim"] = Form(each(lambda a, b: record(a, b).claim), one_in=8)
FORMS["record: a hit"] = Form(each(lambda a, b: record(a, b).hit), a_hit, one_in=16)
FORMS["record every axis"] = Form(each(lambda a, b: record(a, b, every_axis=True).relation), one_in=8)
FORMS["record every axis: its claim"] = Form(each(lambda a, b: record(a, b, every_axis=True).claim), one_in=8)
FORMS["record all edge normals: its claim"] = Form(
    each(lambda a, b: trace.claim if (trace := record(a, b, axes=axes.edge_normals)).choice.complete else None),
    one_in=16,
)
FORMS["record without early exit"] = Form(each(lambda a, b: record(a, b).without_early_exit().relation), one_in=16)
FORMS["record through JSON"] = Form(each(lambda a, b: Trace.from_json(record(a, b).to_json()).relation), one_in=40)
for name in ("world", "edge-normals-of-a", "edge-normals-of-b", "hull-normals", "centers", "nearest-vertex"):
    FORMS[f"record with {name}"] = Form(
        each(lambda a, b, choice=axes.NAMED[name]: record(a, b, axes=choice).relation), one_in=16
    )
for name in ("lengths", "raw-depth", "touch-as-apart", "tile-seam"):
    FORMS[f"record by the shortcut {name}"] = Form(
        each(partial(by_shortcut, SHORTCUTS[name])), one_in=16, overflows=True
    )
FORMS["record with slipped normals: a gap is a proof"] = Form(
    each(lambda a, b: record(a, b, axes=SHORTCUTS["slipped-normal"]).claim), no_miss, one_in=16
)
FORMS["record with one given direction"] = Form(
    each(lambda a, b: record(a, b, axes=axes.directions((2, 1))).relation), one_in=16
)


def proven(a: Shape, b: Shape) -> bool | str:
    """Is it a hit, by a certificate that holds?"""
    certificate = record(a, b).certificate
    return isinstance(certificate, SharedPoint) if certificate.check() else "nothing proven"


def proof_fits(answer: bool | str, truth: Relation) -> bool:
    return answer is bool(truth)


FORMS["certificate"] = Form(each(proven), proof_fits, one_in=16)

# -- batches ---------------------------------------------------------------------------------------


def batch_of(shapes: Sequence[Shape]) -> Shapes:
    """A batch in this order; concave polygons are split."""
    runs = [list(run) for _, run in groupby(shapes, type)]
    made = [
        batch.Circles([c.center for c in run], [c.radius for c in run])
        if isinstance(run[0], Circle)
        else batch.Polygons(run, concave="split")
        for run in runs
    ]
    return made[0] if len(made) == 1 else batch.concat(made)


def sides(pairs: Pairs) -> tuple[Shapes, Shapes]:
    return batch_of([a for a, _ in pairs]), batch_of([b for _, b in pairs])


def batched(ask: Callable[..., Sequence], **options: Any) -> Callable[[Pairs], Sequence]:
    """Answers for all pairs in one call."""
    return lambda pairs: ask(*sides(pairs), **options)


def grouped(ask: Callable[[Pairs], Sequence], key: Callable[[int, Shape, Shape], Hashable]) -> Callable[[Pairs], list]:
    """Answers for the pairs of each key in a call of their own; None where the key is None."""

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


def corners(i: int, a: Shape, b: Shape) -> tuple[int, int] | None:
    """Shapes with as many corners make batches of one group each, which need no gathering."""
    counts = tuple(1 if isinstance(s, Circle) else len(s.corners) for s in (a, b))
    return counts if is_convex(a) and is_convex(b) else None


def by(size: int) -> Callable[[int, Shape, Shape], int]:
    return lambda i, a, b: i // size


def one_against_many(pairs: Pairs, engine: str) -> list:
    """Each first shape against all second ones, and the other way round, which must say the same."""
    a, b = sides(pairs)
    found = []
    for i, (p, q) in enumerate(pairs):
        one, other = batch_of([p]), batch_of([q])
        answers = {int(batch.relate(one, b, engine=engine)[i]), int(batch.relate(a, other, engine=engine)[i])}
        found.append(answers.pop() if len(answers) == 1 else f"{answers}, by which is the one")
    return found


def by_index(pairs: Pairs, engine: str) -> Sequence:
    """The second shapes stored backwards, the pairs given as indices."""
    a, b = batch_of([a for a, _ in pairs]), batch_of([b for _, b in pairs][::-1])
    i = np.arange(len(pairs))
    return batch.relate(a, b, np.stack([i, i[::-1]], axis=1), engine=engine)


def one_after_another(rings: list) -> Shapes:
    return batch.Polygons(np.concatenate(rings), offsets=np.cumsum([0, *map(len, rings)]), concave="split")


def padded(rings: list) -> Shapes:
    most = max(map(len, rings))
    return batch.Polygons(np.array([[*ring, *[ring[-1]] * (most - len(ring))] for ring in rings]), concave="split")


def of_shapely(rings: list) -> Shapes:
    return batch.from_shapely([shapely.Polygon(ring) for ring in rings], concave="split")


def laid_out(make: Callable[[list], Shapes], engine: str) -> Callable[[Pairs], list]:
    """Raw vertices in one of the ways that data comes, side by side and picked from both."""

    def answers(pairs: Pairs) -> list:
        a, b = (make([pair[k].vertices for pair in pairs]) for k in (0, 1))
        i = np.arange(len(pairs))
        side_by_side = batch.relate(a, b, engine=engine).tolist()
        by_index = batch.relate(a, b, np.stack([i, i], axis=1), engine=engine).tolist()
        return [p if p == q else f"{p} or, by index, {q}" for p, q in zip(side_by_side, by_index, strict=True)]

    return grouped(answers, lambda i, a, b: 0 if isinstance(a, Polygon) and isinstance(b, Polygon) else None)


def picked(pick: Callable[[Shapes], Shapes], around: Callable[[list], list]) -> Callable[[Pairs], Sequence]:
    """`around` adds shapes to either side, `pick` takes them away again."""

    def answers(pairs: Pairs) -> Sequence:
        a, b = (batch_of(around([pair[k] for pair in pairs])) for k in (0, 1))
        return batch.relate(pick(a), pick(b))

    return answers


def doubled(shapes: list) -> list:
    return [s for s in shapes for _ in "ab"]


def every_second(shapes: Shapes) -> np.ndarray:
    return np.arange(len(shapes)) % 2 == 0


def shuffled(pairs: Pairs) -> list:
    a, b = sides(pairs)
    order = np.random.default_rng(len(pairs)).permutation(len(pairs))
    answers = batch.relate(a[order], b[order.tolist()])
    return answers[np.argsort(order)].tolist()


def from_the_end(pairs: Pairs) -> Sequence:
    a, b = sides(pairs)
    back = -1 - np.arange(len(pairs))
    return batch.relate(a[back], b[::-1])[::-1]


def one_by_one(pairs: Pairs) -> list:
    a, b = sides(pairs)
    return [int(batch.relate(a[i], b[i - len(pairs)])[0]) for i in range(len(pairs))]


def in_three(pairs: Pairs) -> Sequence:
    third = -(-len(pairs) // 3)
    pieces = [sides(pairs[i : i + third]) for i in range(0, len(pairs), third)]
    a, b = (batch.concat([piece[k] for piece in pieces]) for k in (0, 1))
    return batch.relate(a, b)


def threaded(pairs: Pairs) -> Sequence:
    with ThreadPoolExecutor(2) as pool:
        return batch.relate(*sides(pairs), executor=pool, chunk=-(-len(pairs) // 5))


def in_processes(pairs: Pairs) -> Sequence:
    with ProcessPoolExecutor(2) as pool:
        return batch.relate(*sides(pairs), engine="numpy", executor=pool, chunk=-(-len(pairs) // 5))


def colliding(pairs: Pairs, engine: str) -> list[bool]:
    """Is each pair among the colliding ones of all shapes together?"""
    return _found(batch.colliding_pairs(batch_of([s for pair in pairs for s in pair]), engine=engine), len(pairs))


def candidates(pairs: Pairs, engine: str) -> list[bool]:
    bounds = [s.bounds for pair in pairs for s in pair]
    return _found(batch.candidate_pairs(bounds, engine=engine), len(pairs))


def streamed(pairs: Pairs) -> list[bool]:
    """In strips of 3 shapes; the last vertex is repeated until all have as many."""
    rings = [list(s.vertices) for pair in pairs for s in pair]
    most = max(map(len, rings))
    array = np.array([ring + ring[-1:] * (most - len(ring)) for ring in rings])
    return _found(np.concatenate(list(batch.stream_colliding_pairs(array, strip=3))), len(pairs))


def _found(indices: np.ndarray, n: int) -> list[bool]:
    known = set(map(tuple, indices.tolist()))
    return [(2 * i, 2 * i + 1) in known for i in range(n)]


def some_polygons(i: int, a: Shape, b: Shape) -> int | None:
    return i // 8 if all(isinstance(s, Polygon) and s.is_convex for s in (a, b)) else None


def bounded(size: int) -> Callable[[int, Shape, Shape], int | None]:
    """A circle can reach beyond float64, and a box cannot."""
    return lambda i, a, b: i // size if all(isfinite(c) for s in (a, b) for c in s.bounds) else None


for engine in ENGINES:
    FORMS[f"batch, {engine}"] = Form(batched(batch.relate, engine=engine), one_in=2)
    FORMS[f"batch of one kind, {engine}"] = Form(grouped(batched(batch.relate, engine=engine), corners), one_in=6)
    FORMS[f"batch of one pair, {engine}"] = Form(grouped(batched(batch.relate, engine=engine), by(1)), one_in=40)
    FORMS[f"one against many, {engine}"] = Form(grouped(partial(one_against_many, engine=engine), by(5)), one_in=60)
    FORMS[f"pairs by index, {engine}"] = Form(partial(by_index, engine=engine), one_in=20)
    for make in (one_after_another, padded, of_shapely):
        FORMS[f"batch {make.__name__}, {engine}"] = Form(laid_out(make, engine), one_in=8)
    FORMS[f"hits, {engine}"] = Form(batched(batch.hits, engine=engine), a_hit, one_in=20)
    FORMS[f"colliding_pairs, {engine}"] = Form(grouped(partial(colliding, engine=engine), by(5)), a_hit, one_in=40)
    some = partial(candidates, engine=engine)
    FORMS[f"candidate_pairs, {engine}"] = Form(grouped(some, bounded(40)), no_miss, one_in=2)
    FORMS[f"candidate_pairs of two, {engine}"] = Form(grouped(some, bounded(1)), no_miss, one_in=8)
FORMS["colliding_pairs of two"] = Form(grouped(partial(colliding, engine="numpy"), by(1)), a_hit, one_in=40)
FORMS["stream_colliding_pairs"] = Form(grouped(streamed, some_polygons), a_hit, one_in=60)
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
