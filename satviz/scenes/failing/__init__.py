"""Scenes where shortcuts fail: each the smallest that shows it, with the shortcut's number beside the right one."""

from .failure_case import FALSE_HIT, MISSED_HIT, REFUSED, WRONG_NUMBER, FailureCase
from .hits import HITS
from .numbers import NUMBERS

__all__ = ["FAILURE_CASES", "FALSE_HIT", "MISSED_HIT", "NAMED", "REFUSED", "WRONG_NUMBER", "FailureCase"]

FAILURE_CASES = tuple(sorted((*HITS, *NUMBERS), key=lambda row: row.number))
NAMED = {row.name: row for row in FAILURE_CASES}
