"""The least model that is right: what it claims is proven, and never wrong."""

import math

import numpy as np
import pytest
from forms import batch_of
from strategies import CONVEX, KINDS, NotConvex, pairs, scaled

import satviz as sv
from satviz.advice.gamma import gamma, gammas, signed
from satviz.engine.geometry import Relation

ORDINARY = [kind for kind in CONVEX if kind not in ("largest scale", "smallest scale", "any scale")]


def sign_of(relation):
    return {Relation.APART: 1, Relation.TOUCHING: 0, Relation.OVERLAPPING: -1}[relation]


def test_gamma_of_two_squares_is_the_gap_in_roundings_of_span_times_reach():
    a = sv.Polygon([(0, 0), (1, 0), (1, 1), (0, 1)])
    b = sv.Polygon([(3, 0), (4, 0), (4, 1), (3, 1)])
    assert gamma(a, b) == 2 / (2**-53 * 1 * 4)  # the turn 2 of a unit edge, the reach 4
    assert gamma(a, sv.Circle((3, 0.5), 1)) == 1 / (2**-53 * 4)
    assert gamma(sv.Circle((0, 0), 1), sv.Circle((3, 0), 1)) == 1 / (2**-53 * 4)
    assert signed(a, sv.Circle((0.5, 0.5), 1)) == -1.5 / (
        2**-53 * 1.5
    )  # half a unit to the nearest side, and the radius


def test_gamma_has_the_sign_of_the_relation_and_only_touching_has_none():
    for kind, a, b in pairs(11, 120):
        assert np.sign(signed(a, b)) == sign_of(sv.relate(a, b)), kind


def test_gamma_does_not_depend_on_the_order():
    for kind, a, b in pairs(12, 60):
        assert gamma(a, b) == gamma(b, a), kind


def moved_in_scale(a, b, power):
    """The pair times a power of two; None where float64 cannot hold that."""
    try:
        found = scaled(a, power), scaled(b, power)
        return found if (scaled(found[0], -power), scaled(found[1], -power)) == (a, b) else None
    except (OverflowError, NotConvex, sv.InvalidShape):
        return None


def test_gamma_is_unchanged_by_powers_of_two():
    compared = 0
    for kind, a, b in pairs(13, 120):
        for power in (-300, -1, 7, 300):
            if found := moved_in_scale(a, b, power):
                compared += 1
                assert gamma(*found) == gamma(a, b), kind
    assert compared > 300


def test_many_gammas_are_those_one_by_one():
    found = list(pairs(14, 240, list(KINDS)))
    many = gammas(batch_of([a for _, a, _ in found]), batch_of([b for _, _, b in found]))
    for (kind, a, b), some in zip(found, many.tolist(), strict=True):
        assert math.isclose(some, gamma(a, b), rel_tol=0.02), kind


def test_gammas_by_index_are_those_side_by_side():
    found = list(pairs(15, 40, ORDINARY))
    a, b = batch_of([a for _, a, _ in found]), batch_of([b for _, _, b in found])
    i = np.arange(40)[::-1]
    assert (gammas(a, b, np.stack([i, i], axis=1)) == gammas(a, b)[::-1]).all()


@pytest.mark.parametrize("wrong", [[[0, 1, 2]], [[0, 9]], [[0.5, 0]]])
def test_pairs_that_are_none_are_refused(wrong):
    coins = sv.batch.Circles([(0, 0), (1, 1)], 1)
    with pytest.raises((ValueError, IndexError), match="pairs"):
        gammas(coins, coins, wrong)
