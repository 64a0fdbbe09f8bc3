"""Scenes where shortcuts fail: each the smallest that shows it, with the shortcut's number beside the right one."""

from .failure_case import FALSE_HIT, MISSED_HIT, REFUSED, WRONG_NUMBER, Row
from .hits import HITS
from .numbers import NUMBERS

__all__ = ["FALSE_HIT", "MISSED_HIT", "NAMED", "REFUSED", "ROWS", "WRONG_NUMBER", "Row"]

ROWS = tuple(sorted((*HITS, *NUMBERS), key=lambda row: row.number))
NAMED = {row.name: row for row in ROWS}
