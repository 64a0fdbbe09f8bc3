"""What a shortcut's run claims of its shapes in words, what is right, and whether the claim is wrong."""

from functools import lru_cache
from math import hypot, isclose, isnan
from typing import NamedTuple

from ..engine import describe
from ..engine.geometry import Vec
from ..engine.trace import Trace, record
from ..scenes.failing import FALSE_HIT, MISSED_HIT, NAMED, FailureCase
from ..scenes.failing.claimed_value import OF_PUSHES
from ..scenes.failing.true_value import Answer
from . import comparison_panels
from .float_geometry import bounding_box, moved_shape

ROUNDING = 1e-12  # of the size of it all: what numbers differ by that are the same


def row_of(trace: Trace) -> FailureCase | None:
    """The row of satviz's own shortcuts; None for one's own."""
    row = NAMED.get(trace.shortcut.name) if trace.shortcut else None
    return row if row and row.shortcut == trace.shortcut else None


def about_push(trace: Trace) -> bool:
    """Is the shortcut about where B would be pushed?"""
    row, shortcut = row_of(trace), trace.shortcut
    return row.read in OF_PUSHES if row else bool(shortcut and (shortcut.push or shortcut.split))


class Said(NamedTuple):
    """Both answers in words, and whether the shortcut's is wrong."""

    wrong: str
    right: str
    is_wrong: bool


@lru_cache(maxsize=64)
def said(trace: Trace) -> Said:
    """What a shortcut's run says of its shapes, and what satviz says."""
    assert trace.shortcut
    row = row_of(trace)
    if row is None and trace.push and trace.hit and about_push(trace):
        told, way = describe.digits(trace), trace.truth.known_mtv or Vec(0.0, 0.0)
        words = f"push {told.vector(trace.push)}", f"{trace.relation}, way out {told.vector(way)}"
        return Said(*words, not _leads_out(trace, trace.push, way))
    if row is None:
        return Said(str(trace.claim), str(trace.relation), bool(trace.claim) is not trace.hit)
    if not trace.hit and about_push(trace):
        return Said(str(trace.claim), str(trace.relation), False)  # there is nothing to push
    number, truth = row.read(trace), row.right(trace.a, trace.b)
    if row.how in (FALSE_HIT, MISSED_HIT) and not isinstance(truth, tuple):
        words = f"{trace.claim}, {row.told(number)}", f"{trace.relation}, {row.told(truth)}"
        return Said(*words, bool(trace.claim) is not trace.hit)
    return Said(row.told(number), row.told(truth), _contradicts(row, trace, number, truth))


def _contradicts(row: FailureCase, trace: Trace, number: float, truth: Answer) -> bool:
    """Is a row's number wrong?  A push that rounding alone keeps from the right one is right, a gap has a sign."""
    if isinstance(truth, str):
        return True
    if isinstance(truth, tuple):
        return number > 0 and not isnan(truth[0])  # clear in both frames, and yet there is a contact
    if isnan(number) or isnan(truth):
        return isnan(number) != isnan(truth)  # none is found, and there is none
    if row.less:
        return truth <= number
    if row.what == "gap" and (number > 0) - (number < 0) != (truth > 0) - (truth < 0):
        return True
    return not isclose(number, truth, rel_tol=ROUNDING, abs_tol=ROUNDING * _size(trace))


def _size(trace: Trace) -> float:
    """The largest length or coordinate there is, to hold roundings against."""
    x0, y0, x1, y1 = bounding_box([trace.a, trace.b])
    return max(x1 - x0, y1 - y0, *map(abs, (x0, y0, x1, y1)))


def _leads_out(trace: Trace, push: Vec, way: Vec) -> bool:
    """Does a push end the overlap, and is none shorter, but for rounding?"""
    if not is_near(trace, push):
        return False
    a, pushed = trace.a, moved_shape(trace.b, push)
    left = record(a, pushed).known_mtv or Vec(0.0, 0.0)
    room = ROUNDING * _size(trace)
    return hypot(*left) <= room and hypot(*push) <= hypot(*way) + room


def verdicts(trace: Trace) -> tuple[str, str]:
    """The claim and the relation in a word each."""
    row = row_of(trace)
    own = comparison_panels.VERDICTS.get(row.name) if row else None
    return own or (str(trace.claim), str(trace.relation))


def heading(trace: Trace) -> tuple[str, str]:
    """The claim, and what is wrong with it."""
    assert trace.shortcut
    found = said(trace)
    claim = f"Claim: {trace.shortcut.claim}."
    if found.is_wrong:
        return claim, f"Wrong: {found.wrong}. Right: {found.right}."
    return claim, f"Here it happens to be right: {found.right}."


def is_near(trace: Trace, move: Vec) -> bool:
    """Is B, moved so, still near enough for both shapes to be seen in one picture?"""
    x0, y0, x1, y1 = bounding_box([trace.a, trace.b])
    return max(map(abs, move)) < 3 * max(x1 - x0, y1 - y0)
