"""What each model costs on this machine for the pairs in hand."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from .. import batch
from . import models, timing
from .models import Pairs
from .proofs import Model

ROUNDS = 5
MOST = 1 << 16  # pairs timed: the first of more


class Price(NamedTuple):
    """Nanoseconds a pair, `cold` with the set-up of all shapes and `warm` without; `wrong`: how many answers."""

    cold: float
    warm: float
    wrong: int


def prices(
    asked: Sequence[Model], pairs: Pairs, *, rounds: int = ROUNDS, engine: str | None = None
) -> dict[str, Price]:
    """Medians of some rounds in turn, by the models' names; no prices where there are no pairs.

    Cold starts from checked shapes and makes what the model keeps of those in the pairs.
    """
    if len(pairs.ia) > MOST:
        pairs = models.paired(pairs.a, pairs.ia[:MOST], pairs.b, pairs.ib[:MOST])
    if not len(pairs.ia):
        return {}
    used = [np.unique(i, return_inverse=True) for i in (pairs.ia, pairs.ib)]
    if pairs.a is pairs.b:
        every, where = np.unique(np.concatenate([pairs.ia, pairs.ib]), return_inverse=True)
        used = [(every, where[: len(pairs.ia)]), (every, where[len(pairs.ia) :])]
    a = pairs.a[used[0][0]]
    b = a if pairs.a is pairs.b else pairs.b[used[1][0]]
    pairs = models.paired(a, used[0][1], b, used[1][1])
    right = batch.relate(a, b, np.stack([pairs.ia, pairs.ib], axis=1), engine=engine)
    jobs, items, wrong = {}, {}, {}
    with np.errstate(all="ignore"):
        for model in asked:
            ready = _ready(model, a, b)
            wrong[model.name] = int((models.answers(model, pairs, *ready, engine=engine) != right).sum())

            def warm(model: Model = model, ready: tuple = ready) -> None:  # type: ignore[type-arg]
                models.answers(model, pairs, *ready, engine=engine)

            def cold(model: Model = model) -> None:
                models.answers(
                    model, pairs, *_ready(model, _fresh(a), _fresh(b) if b is not a else None), engine=engine
                )

            jobs[f"{model.name} warm"], jobs[f"{model.name} cold"] = warm, cold
        items = dict.fromkeys(jobs, len(pairs.ia))
        found = timing.in_turn(jobs, rounds, items)
    return {m.name: Price(found[f"{m.name} cold"].median, found[f"{m.name} warm"].median, wrong[m.name]) for m in asked}


def _ready(model: Model, a: batch.Shapes, b: batch.Shapes | None) -> tuple[object, object]:
    mine = models.kept(model, a)
    return mine, mine if b is None or b is a else models.kept(model, b)


def _fresh(shapes: batch.Shapes) -> batch.Shapes:
    """The same shapes with nothing worked out beforehand but how they were made."""
    made = vars(shapes)
    return batch.Shapes(shapes.count, shapes.owner, rings=made.get("rings"), groups=made.get("groups"))
