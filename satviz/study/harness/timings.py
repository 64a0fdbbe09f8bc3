"""Times as columns of rows, and a warning where the times are only rough."""

import gc
from collections.abc import Callable, Mapping, Sequence
from time import thread_time
from typing import Any

from ...advice.timing import time_in_turn
from .cells import JsonRow, Settings

BUSY_SPREAD = 0.25  # quartiles further apart than this share of the median: the machine was busy


def time_jobs(jobs: Mapping[str, Callable[[], Any]], rounds: int, items: Mapping[str, int]) -> dict[str, JsonRow]:
    """Return for each job the CPU time per item in ns, median and quartiles; `items`: how many items a job does."""
    gc.collect()
    gc.freeze()  # otherwise the collection after each round would visit all shapes again
    try:
        found = time_in_turn(jobs, rounds, items, thread_time)
    finally:
        gc.unfreeze()
    return {name: {"ns": times.median, "ns_low": times.low, "ns_high": times.high} for name, times in found.items()}


def timing_warning(rows: Sequence[JsonRow], settings: Settings) -> str:
    """Return the warning to stamp on a chart of these times; empty after a full run on a quiet machine."""
    if settings.quick:
        return "rough: a quick run"
    wide = sum(row["ns_high"] - row["ns_low"] > BUSY_SPREAD * row["ns"] for row in rows)
    return "rough: the machine was busy" if wide * 4 > len(rows) else ""
