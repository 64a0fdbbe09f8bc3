"""Scenes where shortcuts fail: each the smallest that shows it, with the shortcut's number beside the right one."""

from .hits import HITS
from .numbers import NUMBERS
from .row import FALSE_HIT, MISSED_HIT, REFUSED, WRONG_NUMBER, Row

__all__ = ["FALSE_HIT", "MISSED_HIT", "NAMED", "REFUSED", "ROWS", "WRONG_NUMBER", "Row"]

ROWS = tuple(sorted((*HITS, *NUMBERS), key=lambda row: row.number))
NAMED = {row.name: row for row in ROWS}
