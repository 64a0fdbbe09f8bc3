"""Tests of the values that every layer uses: relations and ranges."""

import pytest

import satviz as sv
from satviz.engine.geometry import relation_of_gap


def test_a_relation_is_an_integer_true_for_a_hit_and_printed_in_small_letters():
    assert [int(relation) for relation in sv.Relation] == [0, 1, 2]
    assert [bool(relation) for relation in sv.Relation] == [False, True, True]
    assert [str(relation) for relation in sv.Relation] == ["apart", "touching", "overlapping"]


@pytest.mark.parametrize(
    ("one", "other", "gap"),
    [((0, 1), (3, 9), 2), ((0, 1), (1, 2), 0), ((0, 5), (3, 9), -2), ((0, 9), (3, 4), -4), ((0, 9), (5, 6), -4)],
)
def test_the_gap_of_two_ranges_is_their_distance_or_minus_their_overlap(one, other, gap):
    assert sv.Interval(*one).gap(sv.Interval(*other)) == sv.Interval(*other).gap(sv.Interval(*one)) == gap


@pytest.mark.parametrize("size", [5e-324, 0.5, 1, 3, 10**400])
def test_the_relation_follows_from_the_sign_of_the_gap_however_small_it_is(size):
    relations = [relation_of_gap(gap) for gap in (size, 0 * size, -size)]
    assert relations == [sv.Relation.APART, sv.Relation.TOUCHING, sv.Relation.OVERLAPPING]
