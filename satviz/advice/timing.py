"""Honest times: the methods in turn within a round, so that a slow moment of the machine meets them all.

In a new order each round, as one finds in the cache what another left there.
"""

import gc
import statistics
from collections.abc import Callable, Mapping
from math import inf
from random import Random
from time import perf_counter
from typing import Any, NamedTuple


class Spread(NamedTuple):
    """Times of one method over the rounds, in the unit of whoever made it: the median, the least and the quartiles."""

    median: float
    least: float
    low: float
    high: float


def time_in_turn(
    jobs: Mapping[str, Callable[[], Any]],
    rounds: int,
    items: Mapping[str, int],
    clock: Callable[[], float] = perf_counter,
    seconds: float = inf,
) -> dict[str, Spread]:
    """Nanoseconds an item of each job, taken in turn `rounds` times after one round of warm-up that is left out.

    `clock` gives seconds: time.thread_time leaves out what other programs took.  The whole takes about `seconds` at
    most: a job that takes a quarter of that by itself is left out, and so are rounds for which there is no time left.
    The garbage collector waits meanwhile, as it would charge one method for another's rubbish.
    """
    times: dict[str, list[float]] = {}
    begin = perf_counter()
    for name, job in jobs.items():
        start = perf_counter()
        if start - begin < seconds / 2:
            job()
            if perf_counter() - start < seconds / 4:
                times[name] = []
    a_round = perf_counter() - begin
    order, shuffle = [(name, jobs[name]) for name in times], Random(rounds).shuffle
    collecting = gc.isenabled()
    gc.disable()
    try:
        for done in range(rounds):
            if done and perf_counter() - begin + a_round > seconds:
                break
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
