"""Timing of several methods in turn within each round, so that a slow moment of the machine affects all of them.

The order is new in each round, because a method finds in the cache what the previous one left there.  It is also new
in each process: with one order for all, this would favour the same methods every time, and no interval would show it.
"""

import gc
import statistics
from collections.abc import Callable, Mapping
from math import inf
from random import Random
from time import perf_counter
from typing import Any, NamedTuple


class Spread(NamedTuple):
    """Hold the median, the least and the quartiles of the times of one method, in the unit of the caller."""

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
    """Return the spread of the nanoseconds per item of each job, run once per round after an untimed warm-up.

    `items`: how many items one run of each job handles.  `clock` returns seconds: time.thread_time leaves out the time
    of other programs.  All runs take about `seconds` at most: a job that takes a quarter of this by itself is left out,
    and so are rounds for which no time is left.  The garbage collector is off meanwhile, as it would charge one method
    for the garbage of another.
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
    order, shuffle = [(name, jobs[name]) for name in times], Random().shuffle
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
    """Return the median, the least and the quartiles of these times."""
    low, middle, high = statistics.quantiles(times, n=4, method="inclusive") if len(times) > 1 else times * 3
    return Spread(middle, min(times), low, high)
