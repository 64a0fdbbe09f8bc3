"""The numbers that several shortcuts read off their own run."""

from math import hypot, nan

from ...engine.trace import Trace


def largest_gap(trace: Trace) -> float:
    """Return the largest gap that the run measured; NaN if it has no axis."""
    return max((test.gap for test in trace.tests), default=nan)


def push_length(trace: Trace) -> float:
    """Return how far the run would push B; NaN if it makes no push."""
    return hypot(*(trace.push or (nan, nan)))
