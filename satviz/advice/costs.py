"""What each model costs on this machine for the pairs in hand."""

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
from .pairs import Pairs, paired

ROUNDS = 5
MAX_PAIRS_TIMED = 1 << 16  # pairs timed: the first of more
PAIRS_OF_THE_ESTIMATE = 16  # pairs that tell what all cost


class Cost(NamedTuple):
    """Nanoseconds a pair, `cold` with the set-up of all shapes and `warm` without.

    `wrong`: how many answers are; `timed`: how many pairs, or copies of the one pair, were answered at once.
    """

    cold: float
    warm: float
    wrong: int
    timed: int


def costs(
    asked: Sequence[Model],
    pairs: Pairs,
    *,
    rounds: int = ROUNDS,
    engine: str | None = None,
    most: int = MAX_PAIRS_TIMED,
    tests: float = TESTS_TIMED,
    seconds: float = SECONDS_TIMED,
) -> dict[str, Cost | None]:
    """Medians of some rounds in turn, by the models' names; no prices where there are no pairs.

    Cold starts from checked shapes and makes what the model keeps of those in the pairs.  It times the first pairs, at
    most `most` and of at most `tests` tests of an edge against a corner, in about `seconds` besides loading the engine.
    None stands for a model that is not timed, as one call takes too long.
    """
    fits = np.searchsorted(np.cumsum(_tests(pairs)), tests, side="right")
    if not fits:
        return dict.fromkeys([m.name for m in asked] if len(pairs.ia) else [])
    few = min(int(fits), most, _pairs_in_time(pairs, seconds, engine))
    if not few:
        return dict.fromkeys(m.name for m in asked)
    if few < len(pairs.ia):
        pairs = paired(pairs.a, pairs.ia[:few], pairs.b, pairs.ib[:few])
    pairs = _without_unused_shapes(pairs)
    right = _relations(pairs, engine)
    different = len(pairs.ia) if len(pairs.a) + len(pairs.b) > 2 else 1  # else copies of one
    jobs, wrong = {}, {}
    for model in asked:
        ready = _prepare_both(model, pairs.a, pairs.b)
        wrong[model.name] = int((_evaluate(model, pairs, ready, engine) != right)[:different].sum())
        jobs[f"{model.name} warm"] = partial(_evaluate, model, pairs, ready, engine)
        jobs[f"{model.name} cold"] = partial(_evaluate_cold, model, pairs, engine)
    # this thread's time, in which other programs have no part
    found = timing.time_in_turn(jobs, rounds, dict.fromkeys(jobs, len(pairs.ia)), thread_time, seconds)
    priced: dict[str, Cost | None] = {}
    for m in asked:
        cold, warm = (found.get(f"{m.name} {how}") for how in ("cold", "warm"))
        priced[m.name] = Cost(cold.median, warm.median, wrong[m.name], len(pairs.ia)) if cold and warm else None
    return priced


def _relations(pairs: Pairs, engine: str | None) -> NDArray[np.int8]:
    return batch.relate(pairs.a, pairs.b, np.stack([pairs.ia, pairs.ib], axis=1), engine=engine)


def _pairs_in_time(pairs: Pairs, seconds: float, engine: str | None) -> int:
    """How many pairs the exact model answers in an eighth of the time, by the first of them: it is the dearest."""
    first = paired(pairs.a, pairs.ia[:PAIRS_OF_THE_ESTIMATE], pairs.b, pairs.ib[:PAIRS_OF_THE_ESTIMATE])
    _relations(first, engine)  # loads the engine and makes what is kept of the shapes
    start = perf_counter()
    _relations(first, engine)
    each = (perf_counter() - start) / len(first.ia)
    return int(min(len(pairs.ia), seconds / 8 / max(each, 1e-9)))


def _tests(pairs: Pairs) -> NDArray[np.float64]:
    """(K,) tests of an edge against a corner, of each pair."""
    corners = [np.diff(s.rings.start[s.starts])[i].astype(float) for s, i in ((pairs.a, pairs.ia), (pairs.b, pairs.ib))]
    found: NDArray[np.float64] = 2 * corners[0] * corners[1]
    return found


def _without_unused_shapes(pairs: Pairs) -> Pairs:
    """The same pairs of only the shapes that are in them."""
    if pairs.a is pairs.b:
        every, where = np.unique(np.concatenate([pairs.ia, pairs.ib]), return_inverse=True)
        used = pairs.a[every]
        return paired(used, where[: len(pairs.ia)], used, where[len(pairs.ia) :])
    (one, ia), (other, ib) = (np.unique(i, return_inverse=True) for i in (pairs.ia, pairs.ib))
    return paired(pairs.a[one], ia, pairs.b[other], ib)


def _evaluate(model: Model, pairs: Pairs, ready: tuple[object, object], engine: str | None) -> NDArray[np.int8]:
    with np.errstate(all="ignore"):
        return models.evaluate(model, pairs, *ready, engine=engine)


def _evaluate_cold(model: Model, pairs: Pairs, engine: str | None) -> NDArray[np.int8]:
    a = _uncached(pairs.a)
    return _evaluate(model, pairs, _prepare_both(model, a, a if pairs.b is pairs.a else _uncached(pairs.b)), engine)


def _prepare_both(model: Model, a: batch.Shapes, b: batch.Shapes) -> tuple[object, object]:
    mine = models.prepare(model, a)
    return mine, mine if b is a else models.prepare(model, b)


def _uncached(shapes: batch.Shapes) -> batch.Shapes:
    """The same shapes with nothing worked out beforehand but how they were made."""
    made = vars(shapes)
    return batch.Shapes(shapes.count, shapes.owner, rings=made.get("rings"), groups=made.get("groups"))
