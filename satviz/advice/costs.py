"""The time that each model takes on this machine for the given pairs."""

from collections.abc import Sequence
from functools import partial
from time import perf_counter, thread_time
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from .. import batch
from . import models, timing
from .candidates import Model
from .limits import SECONDS_TIMED, TESTS_TIMED
from .pairs import PartPairs, paired, tests_per_pair

ROUNDS = 5
MAX_PAIRS_TIMED = 1 << 16  # only the first pairs are timed
PAIRS_OF_THE_ESTIMATE = 16  # pairs timed first, to estimate the time of all


class Cost(NamedTuple):
    """Hold the cost of a model in nanoseconds a pair: `cold` with the set-up of all shapes and `warm` without.

    `wrong`: the number of wrong relations; `timed`: the number of pairs, or copies of one pair, in a call.
    """

    cold: float
    warm: float
    wrong: int
    timed: int


def costs(
    candidates: Sequence[Model],
    pairs: PartPairs,
    *,
    rounds: int = ROUNDS,
    engine: str | None = None,
    most: int = MAX_PAIRS_TIMED,
    tests: float = TESTS_TIMED,
    seconds: float = SECONDS_TIMED,
) -> dict[str, Cost | None]:
    """Return the median cost over some rounds of each model, by its name; {} where there are no pairs.

    Cold starts from validated shapes and includes the set-up of the model.  Only the first pairs are timed: at most
    `most` of them, with at most `tests` tests of an edge against a corner, in about `seconds` after the engine is
    loaded.  None stands for a model that is not timed, as one call takes too long.
    """
    fits = np.searchsorted(np.cumsum(tests_per_pair(pairs.a, pairs.ia, pairs.b, pairs.ib)), tests, side="right")
    if not fits:
        return dict.fromkeys([m.name for m in candidates] if len(pairs.ia) else [])
    count = min(int(fits), most, _pairs_in_time(pairs, seconds, engine))
    if not count:
        return dict.fromkeys(m.name for m in candidates)
    if count < len(pairs.ia):
        pairs = paired(pairs.a, pairs.ia[:count], pairs.b, pairs.ib[:count])
    pairs = _without_unused_shapes(pairs)
    right = _relations(pairs, engine)
    different = len(pairs.ia) if len(pairs.a) + len(pairs.b) > 2 else 1  # else copies of one
    jobs, wrong = {}, {}
    for model in candidates:
        ready = _prepare_both(model, pairs.a, pairs.b)
        wrong[model.name] = int((_evaluate(model, pairs, ready, engine) != right)[:different].sum())
        jobs[f"{model.name} warm"] = partial(_evaluate, model, pairs, ready, engine)
        jobs[f"{model.name} cold"] = partial(_evaluate_cold, model, pairs, engine)
    # the clock of this thread leaves out other programs
    found = timing.time_in_turn(jobs, rounds, dict.fromkeys(jobs, len(pairs.ia)), thread_time, seconds)
    measured: dict[str, Cost | None] = {}
    for m in candidates:
        cold, warm = (found.get(f"{m.name} {how}") for how in ("cold", "warm"))
        measured[m.name] = Cost(cold.median, warm.median, wrong[m.name], len(pairs.ia)) if cold and warm else None
    return measured


def _relations(pairs: PartPairs, engine: str | None) -> NDArray[np.int8]:
    """Return the exact relations of the pairs."""
    return batch.relate(pairs.a, pairs.b, np.stack([pairs.ia, pairs.ib], axis=1), engine=engine)


def _pairs_in_time(pairs: PartPairs, seconds: float, engine: str | None) -> int:
    """Return how many pairs the exact filter, the slowest model, can decide in an eighth of `seconds`."""
    first = paired(pairs.a, pairs.ia[:PAIRS_OF_THE_ESTIMATE], pairs.b, pairs.ib[:PAIRS_OF_THE_ESTIMATE])
    _relations(first, engine)  # loads the engine and fills the caches of the shapes
    start = perf_counter()
    _relations(first, engine)
    each = (perf_counter() - start) / len(first.ia)
    return int(min(len(pairs.ia), seconds / 8 / max(each, 1e-9)))


def _without_unused_shapes(pairs: PartPairs) -> PartPairs:
    """Return the same pairs on smaller batches, which hold only the shapes used in them."""
    if pairs.a is pairs.b:
        every, where = np.unique(np.concatenate([pairs.ia, pairs.ib]), return_inverse=True)
        used = pairs.a[every]
        return paired(used, where[: len(pairs.ia)], used, where[len(pairs.ia) :])
    (one, ia), (other, ib) = (np.unique(i, return_inverse=True) for i in (pairs.ia, pairs.ib))
    return paired(pairs.a[one], ia, pairs.b[other], ib)


def _evaluate(model: Model, pairs: PartPairs, ready: tuple[object, object], engine: str | None) -> NDArray[np.int8]:
    """Return the (n,) relations that the model finds; `ready`: what `prepare` returned for side a and side b."""
    with np.errstate(all="ignore"):
        return models.evaluate(model, pairs, *ready, engine=engine)


def _evaluate_cold(model: Model, pairs: PartPairs, engine: str | None) -> NDArray[np.int8]:
    """Return the relations that the model finds, including its set-up."""
    a = _uncached(pairs.a)
    return _evaluate(model, pairs, _prepare_both(model, a, a if pairs.b is pairs.a else _uncached(pairs.b)), engine)


def _prepare_both(model: Model, a: batch.Shapes, b: batch.Shapes) -> tuple[object, object]:
    """Return the data that the model prepares for both sides; computed once where both are the same batch."""
    mine = models.prepare(model, a)
    return mine, mine if b is a else models.prepare(model, b)


def _uncached(shapes: batch.Shapes) -> batch.Shapes:
    """Return a copy of the shapes without cached results."""
    made = vars(shapes)
    return batch.Shapes(**{name: made.get(name) for name in ("rings", "radius", "owner", "runs")})
