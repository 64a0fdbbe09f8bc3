"""Honest times: the methods in turn within a round, so that a slow moment of the machine meets them all.

In a new order each round, as one finds in the cache what another left there.
"""

import gc
import statistics
from collections.abc import Callable, Mapping
from random import Random
from time import perf_counter
from typing import Any, NamedTuple


class Spread(NamedTuple):
    """Times of one method over the rounds, in the unit of whoever made it: the median, the least and the quartiles."""

    median: float
    least: float
    low: float
    high: float


def in_turn(
    jobs: Mapping[str, Callable[[], Any]],
    rounds: int,
    items: Mapping[str, int],
    clock: Callable[[], float] = perf_counter,
) -> dict[str, Spread]:
    """Nanoseconds an item of each job, taken in turn `rounds` times after one round of warm-up that is left out.

    `clock` gives seconds: time.thread_time leaves out what other programs took.
    The garbage collector waits meanwhile, as it would charge one method for another's rubbish.
    """
    times: dict[str, list[float]] = {name: [] for name in jobs}
    for job in jobs.values():
        job()
    order, shuffle = list(jobs.items()), Random(rounds).shuffle
    collecting = gc.isenabled()
    gc.disable()
    try:
        for _ in range(rounds):
            shuffle(order)
            for name, job in order:
                start = clock()
                job()
                times[name].append((clock() - start) / items[name] * 1e9)
            gc.collect()
    finally:
        if collecting:
            gc.enable()
    return {name: spread(found) for name, found in times.items()}


def spread(times: list[float]) -> Spread:
    """The median, the least and the quartiles of some times."""
    low, middle, high = statistics.quantiles(times, n=4, method="inclusive") if len(times) > 1 else times * 3
    return Spread(middle, min(times), low, high)
