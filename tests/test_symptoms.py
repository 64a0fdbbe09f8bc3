"""Tests of symptoms by simulation: each failing case decides, and B is moved accordingly."""

from collections import Counter
from math import hypot

import pytest

from satviz.checking.mistakes import SYMPTOMS
from satviz.checking.pairs import KINDS, KNOWN_SCENES, PAST_ONE_EDGE, kind_of_pair, whole_number_pairs
from satviz.engine.geometry import Relation
from satviz.engine.trace import record
from satviz.scenes.failing import FAILURE_CASES, FALSE_HIT, MISSED_HIT, NAMED
from satviz.scenes.shape_tools import translated

pytestmark = pytest.mark.slow

NOTHING, THROUGH, JITTERS, TOO_FAR, WRONG_WAY, STICKS = SYMPTOMS
OF_OVERLAPS = THROUGH, TOO_FAR, WRONG_WAY, STICKS
# without the scenes of mistakes, so that a new case does not change the shares of the others
PAIRS = [pair for pair in whole_number_pairs(tuple(KINDS), 1) if pair.group not in (KNOWN_SCENES, PAST_ONE_EDGE)][::3]
SEEN_OTHERWISE = {
    "tunnelling": {THROUGH},
    "touch-on-paper": {JITTERS},
    "faces-in-3d": {NOTHING},
}  # motion, floats, space


def gives_an_answer(case):
    """Return whether the user sees the mistake in a verdict or in a move."""
    return case.how in (FALSE_HIT, MISSED_HIT) or case.is_about_push


def seen(case, a, b):
    """Return the symptom of two shapes where the case's shortcut decides."""
    run, truth = record(a, b, axes=case.shortcut, every_axis=True), record(a, b)
    if truth.relation is not Relation.OVERLAPPING:
        wrong = (run.claim is Relation.APART) is not (truth.relation is Relation.APART)
        return {NOTHING if truth.relation is Relation.APART else JITTERS} if wrong else set()
    if run.claim is Relation.APART:
        return {THROUGH}
    if not gives_an_answer(case):
        return set()
    left, longer = record(a, translated(b, run.push)).mtv, hypot(*run.push) / hypot(*truth.mtv)
    is_out = left is None or hypot(*left) < 1e-7 * max(a.max_coordinate, b.max_coordinate)
    if is_out and longer < 1 + 1e-7:
        return set()
    along = run.push.x * truth.mtv.x + run.push.y * truth.mtv.y
    return {TOO_FAR if is_out else STICKS} | ({WRONG_WAY} if along < 1e-9 else set())


def seen_of(case):
    """Return (what the own scene or most pairs show, what the own scene or at least many pairs show)."""
    found, of = Counter(), Counter()
    kind = kind_of_pair(*case.shapes)
    for pair in PAIRS:
        if pair.kind not in (kind, "boxes", *(("convex",) if kind == "boxes" else ())):
            continue
        try:
            found.update(seen(case, pair.a, pair.b))
        except (ValueError, ArithmeticError):
            continue
        relation = record(pair.a, pair.b).relation
        of.update({Relation.APART: [NOTHING], Relation.TOUCHING: [JITTERS]}.get(relation, OF_OVERLAPS))
    own = seen(case, *case.shapes)
    return tuple(own | {symptom for symptom in found if found[symptom] > share * of[symptom]} for share in (0.6, 0.4))


LISTED = {name for names in SYMPTOMS.values() for name in names}
CASES = sorted(LISTED | {case.name for case in FAILURE_CASES if gives_an_answer(case)})


@pytest.mark.parametrize("name", CASES)
def test_a_mistake_stands_under_what_users_see_of_it_and_nowhere_else(name):
    listed = {symptom for symptom, names in SYMPTOMS.items() if name in names}
    most, many = [SEEN_OTHERWISE[name]] * 2 if name in SEEN_OTHERWISE else seen_of(NAMED[name])
    assert most <= listed <= many
