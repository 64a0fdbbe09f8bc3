"""What each model costs on this machine for the pairs in hand."""

from collections.abc import Sequence
from functools import partial
from time import thread_time
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from .. import batch
from . import models, timing
from .pairs import Pairs, paired
from .proofs import Model

ROUNDS = 5
MOST = 1 << 16  # pairs timed: the first of more


class Price(NamedTuple):
    """Nanoseconds a pair, `cold` with the set-up of all shapes and `warm` without; `wrong`: how many answers."""

    cold: float
    warm: float
    wrong: int


def prices(
    asked: Sequence[Model], pairs: Pairs, *, rounds: int = ROUNDS, engine: str | None = None, most: int = MOST
) -> dict[str, Price]:
    """Medians of some rounds in turn, by the models' names; no prices where there are no pairs.

    Cold starts from checked shapes and makes what the model keeps of those in the pairs.
    """
    if len(pairs.ia) > most:
        pairs = paired(pairs.a, pairs.ia[:most], pairs.b, pairs.ib[:most])
    if not len(pairs.ia):
        return {}
    pairs = _of_those_used(pairs)
    right = batch.relate(pairs.a, pairs.b, np.stack([pairs.ia, pairs.ib], axis=1), engine=engine)
    different = len(pairs.ia) if len(pairs.a) + len(pairs.b) > 2 else 1  # else copies of one
    jobs, wrong = {}, {}
    for model in asked:
        ready = _ready(model, pairs.a, pairs.b)
        wrong[model.name] = int((_asked(model, pairs, ready, engine) != right)[:different].sum())
        jobs[f"{model.name} warm"] = partial(_asked, model, pairs, ready, engine)
        jobs[f"{model.name} cold"] = partial(_from_scratch, model, pairs, engine)
    # this thread's time, in which other programs have no part
    found = timing.in_turn(jobs, rounds, dict.fromkeys(jobs, len(pairs.ia)), thread_time)
    return {m.name: Price(found[f"{m.name} cold"].median, found[f"{m.name} warm"].median, wrong[m.name]) for m in asked}


def _of_those_used(pairs: Pairs) -> Pairs:
    """The same pairs of only the shapes that are in them."""
    if pairs.a is pairs.b:
        every, where = np.unique(np.concatenate([pairs.ia, pairs.ib]), return_inverse=True)
        used = pairs.a[every]
        return paired(used, where[: len(pairs.ia)], used, where[len(pairs.ia) :])
    (one, ia), (other, ib) = (np.unique(i, return_inverse=True) for i in (pairs.ia, pairs.ib))
    return paired(pairs.a[one], ia, pairs.b[other], ib)


def _asked(model: Model, pairs: Pairs, ready: tuple[object, object], engine: str | None) -> NDArray[np.int8]:
    with np.errstate(all="ignore"):
        return models.answers(model, pairs, *ready, engine=engine)


def _from_scratch(model: Model, pairs: Pairs, engine: str | None) -> NDArray[np.int8]:
    a = _fresh(pairs.a)
    return _asked(model, pairs, _ready(model, a, a if pairs.b is pairs.a else _fresh(pairs.b)), engine)


def _ready(model: Model, a: batch.Shapes, b: batch.Shapes) -> tuple[object, object]:
    mine = models.kept(model, a)
    return mine, mine if b is a else models.kept(model, b)


def _fresh(shapes: batch.Shapes) -> batch.Shapes:
    """The same shapes with nothing worked out beforehand but how they were made."""
    made = vars(shapes)
    return batch.Shapes(shapes.count, shapes.owner, rings=made.get("rings"), groups=made.get("groups"))
