"""Times as columns of rows, and a warning where they are not for keeps."""

import gc
from collections.abc import Callable, Mapping, Sequence
from time import thread_time
from typing import Any

from ...advice.timing import time_in_turn
from .cells import Settings

BUSY = 0.25  # quartiles so far apart, as a share of the median, tell of a busy machine
Row = dict[str, Any]


def timed(jobs: Mapping[str, Callable[[], Any]], rounds: int, items: Mapping[str, int]) -> dict[str, Row]:
    """By job: its nanoseconds an item (median and quartiles), of the processor's time of this thread."""
    gc.collect()
    gc.freeze()  # collecting after each round would go through all shapes each time
    try:
        found = time_in_turn(jobs, rounds, items, thread_time)
    finally:
        gc.unfreeze()
    return {name: {"ns": s.median, "ns_low": s.low, "ns_high": s.high} for name, s in found.items()}


def rough(rows: Sequence[Row], settings: Settings) -> str:
    """What a chart of such times has to be stamped with; nothing where they are for keeps."""
    if settings.quick:
        return "rough: a quick run"
    apart = sum(row["ns_high"] - row["ns_low"] > BUSY * row["ns"] for row in rows)
    return "rough: the machine was busy" if apart * 4 > len(rows) else ""
