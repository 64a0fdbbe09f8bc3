"""The failing cases: for each common mistake the smallest scene that shows it, with the claimed and the true answer."""

from ...engine.shortcut import Shortcut
from . import bad_outlines, circles_and_dents, saved_work, too_few_axes, wrong_conclusions, wrong_projections
from .failure_case import FALSE_HIT, MISSED_HIT, REFUSED, WRONG_NUMBER, FailureCase

__all__ = [
    "FAILURE_CASES",
    "FALSE_HIT",
    "MISSED_HIT",
    "NAMED",
    "REFUSED",
    "SHORTCUTS",
    "WRONG_NUMBER",
    "FailureCase",
    "case_of",
]

_CASES = (
    *too_few_axes.CASES,
    *bad_outlines.CASES,
    *wrong_projections.CASES,
    *circles_and_dents.CASES,
    *saved_work.CASES,
    *wrong_conclusions.CASES,
)

FAILURE_CASES = tuple(case._replace(number=number) for number, case in enumerate(_CASES, 1))
NAMED = {case.name: case for case in FAILURE_CASES}
SHORTCUTS = {case.name: case.shortcut for case in FAILURE_CASES}


def case_of(shortcut: Shortcut | None) -> FailureCase | None:
    """Return the failing case that has this shortcut; None for a shortcut that satviz does not define."""
    case = NAMED.get(shortcut.name) if shortcut else None
    return case if case and case.shortcut == shortcut else None
