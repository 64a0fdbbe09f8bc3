"""The answer of a shortcut in words, the right answer, and whether the first is wrong.

A shortcut is a mistaken or cheaper collision test.  A failing case has a shortcut, and shapes for which it is wrong.
"""

import re
from functools import lru_cache
from math import hypot, isclose, isnan, nan
from typing import NamedTuple

from ..engine import describe
from ..engine.geometry import InvalidScene, InvalidShape, Vec
from ..engine.number_format import MINUS, Digits
from ..engine.trace import Trace, record
from ..scenes.failing import FALSE_HIT, MISSED_HIT, FailureCase, case_of
from ..scenes.failing.true_value import Answer
from ..scenes.shape_tools import translated
from .float_geometry import bounding_box

ROUNDING = 1e-12  # numbers that differ by this part of the scene's size, or of themselves, count as equal


def is_about_push(trace: Trace) -> bool:
    """Return whether the shortcut's answer depends on where it pushes B."""
    case, shortcut = case_of(trace.shortcut), trace.shortcut
    return case.is_about_push if case else bool(shortcut and (shortcut.push or shortcut.split))


class Answers(NamedTuple):
    """The claimed and the actual answer in words, and whether the claimed one is wrong."""

    claimed: str
    actual: str
    is_wrong: bool


@lru_cache(maxsize=64)
def answers(trace: Trace, digits: Digits | None = None) -> Answers:
    """Return the shortcut's answer for its shapes and the right one, in words, and whether the shortcut's is wrong.

    Lengths are printed with `digits` (None: those of `digits_of_answers`).  If the case is about a verdict, the words
    are numbers only where both answers have the same number; otherwise they are the verdicts, with the gap that the
    shortcut missed.
    """
    assert trace.shortcut
    case, digits = case_of(trace.shortcut), digits or digits_of_answers(trace)
    if case is None and trace.push and trace.hit and is_about_push(trace):
        digits, mtv = describe.digits(trace), trace.truth.known_mtv or Vec(0.0, 0.0)
        words = f"push {digits.vector(trace.push)}", f"{trace.relation}, way out {digits.vector(mtv)}"
        return Answers(*words, not _is_minimal_push(trace, trace.push, mtv))
    if case is None:
        return Answers(str(trace.claim), str(trace.relation), bool(trace.claim) is not trace.hit)
    if not trace.hit and is_about_push(trace):
        return Answers(str(trace.claim), str(trace.relation), False)  # there is nothing to push
    claimed, actual = case.claimed_value(trace), case.true_value(trace.a, trace.b)
    if case.how in (FALSE_HIT, MISSED_HIT) and not isinstance(actual, tuple):
        right = case.verdict_in_words(trace.relation, actual, digits)
        if bool(trace.claim) is not trace.hit:
            gap = f", {right}" if right.startswith("gap ") else ""
            return Answers(str(trace.claim), f"{trace.relation}{gap}", True)
        both_say = case.verdict_in_words(trace.claim, claimed, digits) == right
        return Answers(str(trace.claim), right if both_say else str(trace.relation), False)
    is_wrong = _contradicts(case, trace, claimed, actual)
    # a gap in two frames is true: only that no contact follows from it is wrong
    said = (nan, nan) if is_wrong and isinstance(actual, tuple) else claimed
    return Answers(case.in_words(said, digits), case.in_words(actual, digits), is_wrong)


def _contradicts(case: FailureCase, trace: Trace, claimed: float, actual: Answer) -> bool:
    """Return whether the claimed number is wrong, by more than rounding or in the sign of a gap."""
    if isinstance(actual, str):
        return True
    if isinstance(actual, tuple):
        return claimed > 0 and not isnan(actual[0])  # clear in both frames, and yet there is a contact
    if isnan(claimed) or isnan(actual):
        return isnan(claimed) != isnan(actual)  # both are NaN where there is none to find
    if case.claims_less:
        return actual <= claimed
    if case.quantity == "gap" and (claimed > 0) - (claimed < 0) != (actual > 0) - (actual < 0):
        return True
    return not isclose(claimed, actual, rel_tol=ROUNDING, abs_tol=ROUNDING * _size(trace))


def _size(trace: Trace) -> float:
    """Return the scene's largest length or absolute coordinate, the scale for tolerances of rounding."""
    x0, y0, x1, y1 = bounding_box([trace.a, trace.b])
    return max(x1 - x0, y1 - y0, *map(abs, (x0, y0, x1, y1)))


def _is_minimal_push(trace: Trace, push: Vec, mtv: Vec) -> bool:
    """Return whether `push` ends the overlap and is no longer than the MTV, up to rounding."""
    if not is_near(trace, push):
        return False
    left = record(trace.a, translated(trace.b, push)).known_mtv or Vec(0.0, 0.0)
    tolerance = ROUNDING * _size(trace)
    return hypot(*left) <= tolerance and hypot(*push) <= hypot(*mtv) + tolerance


def verdict_words(trace: Trace) -> tuple[str, str]:
    """Return the verdicts in the left and the right panel: claim and relation, or those of the failing case."""
    case = case_of(trace.shortcut)
    own = case.verdicts if case else None
    return (str(trace.claim), str(trace.relation)) if own is None else own


def digits_of_answers(trace: Trace, digits: describe.NumberFormat = describe.digits) -> Digits:
    """Return the number format of a shortcut's answers: what `digits` returns for the test which they come from."""
    test = trace.ended_by or trace.shallowest
    return digits(trace, *([test] if test else []))


def error_in_words(trace: Trace, digits: describe.NumberFormat = describe.digits) -> str | None:
    """Return what is wrong with a shortcut's answer and what is right, or "" where the answer is right.

    None where the right answer needs shapes that float64 cannot hold, or that have too many convex parts.  `digits`:
    the function that gives the number format for a test.
    """
    try:
        found, case = answers(trace, digits_of_answers(trace, digits)), case_of(trace.shortcut)
    except (InvalidScene, InvalidShape):
        return None
    if not found.is_wrong:
        return ""
    if case and case.claims_less:
        return f"Wrong: {found.claimed}, not less than {found.actual.rsplit(' ', 1)[-1]}."
    return f"Wrong: {found.claimed}. Right: {found.actual}."


def heading(trace: Trace, digits: describe.NumberFormat = describe.digits) -> tuple[str, str]:
    """Return two lines: the claim, and what is wrong with it or that it happens to be right.

    `digits`: the function that gives the number format for a test.
    """
    assert trace.shortcut
    right = answers(trace, digits_of_answers(trace, digits)).actual
    wrong = error_in_words(trace, digits) or f"Here it happens to be right: {right}."
    return f"Claim: {_as_printed(trace.shortcut.claim)}.", wrong


def _as_printed(claim: str) -> str:
    """Return a claim with true minus signs, and with no line break inside a vector such as (dx, -dy)."""
    return re.sub(r"\(\w+, -?\w+\)", lambda vector: vector[0].replace(" ", "\xa0").replace("-", MINUS), claim)


def is_near(trace: Trace, move: Vec) -> bool:
    """Return whether B, translated by `move`, is near enough to A for both to be seen in one picture."""
    x0, y0, x1, y1 = bounding_box([trace.a, trace.b])
    return max(map(abs, move)) < 3 * max(x1 - x0, y1 - y0)
