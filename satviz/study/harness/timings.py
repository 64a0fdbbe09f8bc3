"""Times as columns of rows, repeated in whole processes, with the spread between these.

Two processes can differ more than the rounds of one: memory lies elsewhere, the machine is busier.  So each section has
a cell for each of several processes, and intervals come from the spread between processes.
"""

import gc
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import BrokenExecutor, ProcessPoolExecutor
from functools import cache
from multiprocessing import get_context
from statistics import median
from time import thread_time
from typing import Any, NamedTuple

from ...advice.timing import time_in_turn
from ...render.chart import JsonRow
from .cells import Cell, Settings

BUSY_SPREAD = 0.25  # processes further apart than this share of their median make a time rough


@cache
def _process(number: int) -> ProcessPoolExecutor:
    """Return the executor of process `number`, for all sections: a new one has to load numba and all kernels again."""
    return ProcessPoolExecutor(1, get_context("spawn"))


def in_process(number: int, work: Callable[..., Any], *arguments: Any) -> Any:
    """Return `work(*arguments)`, done in the process of this number; if that died, the next call has a new one."""
    try:
        return _process(number).submit(work, *arguments).result()
    except BrokenExecutor:
        _process.cache_clear()
        raise


def cells_by_process(name: str, work: Callable[..., Any], arguments: tuple[Any, ...], settings: Settings) -> list[Cell]:
    """Return timed cells name-0-times, name-1-times ..., each of which does work(*arguments) in its own process."""
    processes = range(2 if settings.quick else 6)
    return [Cell(f"{name}-{k}-times", in_process, (k, work, *arguments), timed=True) for k in processes]


def time_jobs(jobs: Mapping[str, Callable[[], Any]], rounds: int, items: Mapping[str, int]) -> dict[str, float]:
    """Return for each job its median CPU time per item in ns; `items`: how many items a job does."""
    gc.collect()
    gc.freeze()  # otherwise each later collection would visit all shapes and modules again
    return {name: t.median for name, t in time_in_turn(jobs, rounds, items, thread_time).items()}


def over_processes(found: Mapping[str, Any], name: str, columns: Sequence[str] = ("ns",)) -> list[JsonRow]:
    """Merge the rows of all processes into one set of rows with the median time and the spread.

    A column `ns` gets the median over processes, `ns_low` and `ns_high` the least and the largest, `ns_runs` all.
    found: the rows of all cells by the cell's name; name: the cells are called name-0-times, name-1-times ...;
    columns: the names of the columns that hold times.
    """
    runs = [rows for cell, rows in found.items() if cell.startswith(f"{name}-") and cell.endswith("-times")]
    merged = []
    for same in zip(*runs, strict=True):
        row = dict(same[0])
        for column in columns:
            times = [round(one[column], 3) for one in same]
            row |= {column: median(times), f"{column}_low": min(times), f"{column}_high": max(times)}
            row[f"{column}_runs"] = times
        merged.append(row)
    return merged


def ratio_interval(own: Sequence[float], other: Sequence[float]) -> tuple[float, float, float]:
    """Return (median, least, largest) of the ratios own[k] / other[k]: the times of two methods in process k.

    The median of all possible processes lies between the least and the largest unless all n processes fell on one side
    of it, so with a probability of 1 - 2 / 2**n.  A bootstrap of so few processes covers less than it says.
    """
    ratios = [x / y for x, y in zip(own, other, strict=True)]
    return median(ratios), min(ratios), max(ratios)


def interval_in_words(processes: int) -> str:
    """Return the confidence of `ratio_interval` in words: "the 97 % interval over 6 processes"."""
    return f"the {1 - 2 / 2**processes:.0%} interval over {processes} processes".replace("%", " %")


def format_ratio(ratio: tuple[float, float, float]) -> str:
    """Return a ratio and its interval in words: "1.7 times (1.5 to 1.8)"; without decimals from 10 on."""
    middle, low, high = (f"{value:.{0 if value >= 10 else 1}f}" for value in ratio)
    return f"{middle} times ({low} to {high})"


class Spread(NamedTuple):
    """A time, or a ratio of times, with the ends of its interval.

    Every sentence that calls one of two faster goes by `is_below`: where the intervals share a value, the measurement
    cannot tell them apart.
    """

    middle: float
    low: float
    high: float

    def is_below(self, other: "Spread") -> bool:
        """Return whether the whole interval lies below that of the other."""
        return self.high < other.low


def least_of(spreads: Mapping[str, Spread]) -> list[str]:
    """Return the name with the least middle, and after it, in their order, those that cannot be told apart from it."""
    least = min(spreads, key=lambda name: spreads[name].middle)
    return [least, *(name for name, spread in spreads.items() if name != least and not spreads[least].is_below(spread))]


def timing_warning(rows: Sequence[JsonRow], settings: Settings) -> str:
    """Return the warning to stamp on a chart of these times; empty after a full run on a quiet machine."""
    if settings.quick:
        return "rough: a quick run"
    times = {(row["ns_low"], row["ns"], row["ns_high"]) for row in rows}  # rows may share one
    wide = sum(high - low > BUSY_SPREAD * middle for low, middle, high in times)
    return f"rough: some times differ by {BUSY_SPREAD:.0%} or more from run to run" if wide * 4 > len(times) else ""
