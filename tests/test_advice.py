"""Tests of recommendations: every claim about the recommended model is proven, and none is wrong."""

import json
import math
import os
import subprocess
import sys
import zipfile
from collections import Counter
from contextlib import suppress
from dataclasses import replace
from itertools import combinations
from random import Random

import numpy as np
import oracle
import pytest
from benchmarks.advice import SCENES
from forms import batch_of
from hypothesis import HealthCheck, given, settings
from speeds import one_in
from strategies import CONVEX, KINDS, NotConvex, drawn, pairs, scaled, some_pairs

import satviz as sv
from satviz import batch
from satviz.advice.advising_batches import repeated_pair
from satviz.advice.candidates import AABB, BOUNDING_CIRCLES, EXACT_FILTER, K_DOP, Model, SplitPolygon
from satviz.advice.certified_bounds import SAT_ROUNDINGS, certify
from satviz.advice.classify import classify
from satviz.advice.margins import signed_relative_margins
from satviz.advice.models import evaluate, prepare
from satviz.advice.pairs import paired
from satviz.advice.relative_margin import relative_margin, signed_relative_margin
from satviz.advice.scope import ANYWHERE, HERE, MOVED, MULTIPLES, Scope, power_of_two_bound
from satviz.advice.shapesfile import load_shapes
from satviz.cli import main
from satviz.engine.axis_count import NUMBER_WORDS, axes_hint, count_axes
from satviz.engine.convex_parts import parts
from satviz.engine.geometry import Relation, Vec
from satviz.pictures import THEMES
from satviz.scenes.shape_tools import translated

ORDINARY = [kind for kind in CONVEX if kind not in ("largest scale", "smallest scale", "any scale")]


def sign_of(relation):
    return {Relation.APART: 1, Relation.TOUCHING: 0, Relation.OVERLAPPING: -1}[relation]


def test_relative_margin_of_two_squares_is_the_gap_in_roundings_of_edge_times_coordinate():
    a = sv.Polygon([(0, 0), (1, 0), (1, 1), (0, 1)])
    b = sv.Polygon([(3, 0), (4, 0), (4, 1), (3, 1)])
    assert relative_margin(a, b) == 2 / (2**-53 * 1 * 4)  # the turn 2 of a unit edge, the largest coordinate 4
    assert relative_margin(a, sv.Circle((3, 0.5), 1)) == 1 / (2**-53 * 4)
    assert relative_margin(sv.Circle((0, 0), 1), sv.Circle((3, 0), 1)) == 1 / (2**-53 * 4)
    assert signed_relative_margin(a, sv.Circle((0.5, 0.5), 1)) == -1.5 / (
        2**-53 * 1.5
    )  # half a unit to the nearest side, and the radius


def test_relative_margin_has_the_sign_of_the_relation_and_is_zero_only_at_a_touch():
    for kind, a, b in pairs(11, 120):
        assert np.sign(signed_relative_margin(a, b)) == sign_of(sv.relate(a, b)), kind


def test_relative_margin_does_not_depend_on_the_order():
    for kind, a, b in pairs(12, 60):
        assert relative_margin(a, b) == relative_margin(b, a), kind


def moved_in_scale(a, b, power):
    """Return the pair scaled by a power of two, or None where float64 cannot hold the result."""
    try:
        found = scaled(a, power), scaled(b, power)
        return found if (scaled(found[0], -power), scaled(found[1], -power)) == (a, b) else None
    except (OverflowError, NotConvex, sv.InvalidShape):
        return None


def test_relative_margin_is_unchanged_by_powers_of_two():
    compared = 0
    for kind, a, b in pairs(13, 120):
        for power in (-300, -1, 7, 300):
            if found := moved_in_scale(a, b, power):
                compared += 1
                assert relative_margin(*found) == relative_margin(a, b), kind
    assert compared > 300


def row_by_row(a, b):
    """Return the pairs of shape i of one batch with shape i of the other."""
    every = np.arange(len(a))
    return paired(a, every, b, every)


def test_relative_margins_of_batches_are_those_of_single_pairs():
    found = list(pairs(14, 90))
    many = signed_relative_margins(row_by_row(batch_of([a for _, a, _ in found]), batch_of([b for _, _, b in found])))
    for (kind, a, b), some in zip(found, many.tolist(), strict=True):
        assert math.isclose(some, signed_relative_margin(a, b), rel_tol=0.02), kind


@pytest.mark.parametrize("kind", ["smallest scale", "needles pointed at circles"])
def test_relative_margins_of_batches_are_those_of_single_pairs_within_rounding_of_a_touch(kind):
    found = list(pairs(16, 250, [kind]))
    found += [(kind, a, b) for a, b in few_units(Random(16), 50)] if kind == "smallest scale" else []
    many = signed_relative_margins(row_by_row(batch_of([a for _, a, _ in found]), batch_of([b for _, _, b in found])))
    for (_, a, b), some in zip(found, many.tolist(), strict=True):
        assert math.isclose(some, signed_relative_margin(a, b), rel_tol=0.02), (a, b)


def few_units(rng, count):
    """Return pairs of triangles whose coordinates are at most nine times the smallest float."""
    made = []
    while len(made) < 2 * count:
        try:
            made.append(sv.Polygon([(rng.randint(-9, 9) * 5e-324, rng.randint(-9, 9) * 5e-324) for _ in range(3)]))
        except sv.InvalidShape:
            continue
    return list(zip(made[::2], made[1::2], strict=True))


def test_relative_margin_of_a_tiny_gap_between_huge_shapes_is_tiny():
    assert 0 < relative_margin(sv.Circle((0, 0), 1e300), sv.Circle((1e300, 0), 5e-324)) < 1e-320


def test_relative_margins_by_index_are_those_side_by_side():
    found = list(pairs(15, 40, ORDINARY))
    a, b = batch_of([a for _, a, _ in found]), batch_of([b for _, _, b in found])
    i = np.arange(40)[::-1]
    assert (signed_relative_margins(paired(a, i, b, i)) == signed_relative_margins(row_by_row(a, b))[::-1]).all()


@pytest.mark.parametrize("wrong", [[[0, 1, 2]], [[0, 9]], [[0.5, 0]]])
def test_invalid_pairs_are_refused(wrong):
    coins = sv.batch.Circles([(0, 0), (1, 1)], 1)
    with pytest.raises((ValueError, IndexError), match="pairs"):
        sv.advise(coins, coins, wrong)


# -- models


WAYS = sv.Vec(0.5, 0.5), sv.Vec(0.75, -0.25), sv.Vec(0.0, 0.5), sv.Vec(0.1, 0.7)
MODELS = [
    *(Model(kind, 1) for kind in (BOUNDING_CIRCLES, AABB, "float32", "float64", EXACT_FILTER)),
    Model(K_DOP, 4, WAYS),
]


# the study's numba kernels compile for five seconds
each_engine = pytest.mark.parametrize("engine", ["numpy", pytest.param("numba", marks=pytest.mark.slow)])


@each_engine
def test_relations_certified_for_many_pairs_are_certified_by_fractions_and_found_by_the_model(engine):
    known = Counter()
    some = list(pairs(21, 4 * len(KINDS)))
    for model in MODELS:
        a, b = batch_of([a for _, a, _ in some]), batch_of([b for _, _, b in some])
        i = np.arange(len(some))
        certified = classify(model, many := paired(a, i, b, i), batch.relate(a, b)).tolist()
        with np.errstate(all="ignore"):
            said = evaluate(model, many, prepare(model, a), prepare(model, b), engine=engine).tolist()
        for (kind, p, q), one, answer in zip(some, certified, said, strict=True):
            if one != -1 and not (model.kind == K_DOP and (p.radius or q.radius)):
                known[model.name] += 1
                assert certify(model, p, q) == one == answer, (model.name, kind, p, q)
    assert min(known.values()) > 25 and len(known) == len(MODELS)


@each_engine
def test_a_circle_too_small_for_float32_remains_a_circle_in_float32(engine):
    dot, model = sv.Circle((0.5, 0.5), 1e-50), Model("float32", 5)
    kite = sv.Polygon([(0, 0), (1, 0), (1.25, 1), (0, 1.5)])
    for other, truth in (
        (kite, 2),
        (sv.Circle((0.5, 0.5), 1), 2),
        (sv.Polygon([(0.75, 0.5), (1, 0), (1, 1)]), 0),
        (sv.Circle((0.5, 0.75), 0.125), 0),
    ):
        for a, b in ((dot, other), (other, dot)):
            many = repeated_pair(a, b, 3)
            said = evaluate(model, many, prepare(model, many.a), prepare(model, many.b), engine=engine).tolist()
            assert certify(model, a, b) == truth and said == [truth] * 3, (a, b)


# -- never a wrong recommendation


def tiles(rng):
    """Return pairs of boxes on a grid that share edges and corners or overlap; coordinates are whole or rounded."""
    unit, far = rng.choice((1.0, 0.1, 2.0**-20, 1e6)), rng.choice((0, 0, 2**12, 2**40))
    at = [(far + rng.randint(0, 4), far + rng.randint(0, 4)) for _ in range(4)]
    size = [(rng.randint(1, 2), rng.randint(1, 2)) for _ in range(4)]
    made = [
        sv.Polygon([((x + u * w) * unit, (y + v * h) * unit) for u, v in ((0, 0), (1, 0), (1, 1), (0, 1))])
        for (x, y), (w, h) in zip(at, size, strict=True)
    ]
    return list(combinations(made, 2))


def turned_alike(rng):
    """Return pairs of boxes with common directions; coordinates are whole or rounded."""
    (p, q), unit = rng.choice(((3, 4), (1, 1), (5, 12), (0.6, 0.8), (0.31, 0.77))), rng.choice((1.0, 2.0**-30, 0.1))
    made = []
    for _ in range(3):
        x, y, w, h = rng.randint(0, 5), rng.randint(0, 5), rng.randint(1, 3), rng.randint(1, 3)
        corners = ((x, y), (x + w, y), (x + w, y + h), (x, y + h))
        made.append(sv.Polygon([((u * p - v * q) * unit, (u * q + v * p) * unit) for u, v in corners]))
    return list(combinations(made, 2))


def coins(rng):
    """Return pairs of circles, many of them tangent, and of polygons among them."""
    unit, far = rng.choice((1.0, 0.1, 2.0**-9)), rng.choice((0, 2**10, 2**30))
    made = [
        sv.Circle(((far + rng.randint(0, 8)) * unit, (far + rng.randint(0, 8)) * unit), rng.randint(1, 3) * unit)
        for _ in range(3)
    ]
    if rng.random() < 0.4:
        made.append(sv.Polygon([((far + x) * unit, (far + y) * unit) for x, y in ((0, 0), (6, 1), (3, 7))]))
    return list(combinations(made, 2))


def ordinary(rng):
    """Return pairs of several random kinds, whose sizes differ by a factor of up to 2**60."""
    kinds = rng.sample(("random polygons", "random circles", "concave", "few corners", "near touching, offset 1"), 3)
    found = [drawn(rng, kind) for kind in kinds]
    power = rng.choice((0, 0, 3, 20, 60))
    return [(scaled(a, power), b) if rng.random() < 0.5 else (a, b) for a, b in found]


def hard(rng):
    """Return one or two pairs of the kinds that the engine is tested with."""
    return [drawn(rng, rng.choice(list(KINDS))) for _ in range(rng.choice((1, 1, 2)))]


def scenes(seed, count):
    """Yield lists of pairs; invalid shapes are drawn again."""
    rng, made = Random(seed), 0
    while made < count:
        try:
            found = (hard, tiles, turned_alike, coins, ordinary)[made % 5](rng)
        except (NotConvex, OverflowError, sv.InvalidShape):
            continue
        made += 1
        yield found if made % 3 else found[:1]


def wrong_recommendations(seed, count, engines=("numpy",)):
    """Return the scenes whose recommended model is not certified right or errs, and how often each kind was chosen."""
    wrong, advised = [], Counter()
    for scene in scenes(seed, count):
        truth = [oracle.relation(a, b) for a, b in scene]
        if len(scene) == 1:
            recommendation = sv.advise(*scene[0])
            many = repeated_pair(*scene[0], copies=1)
        else:
            recommendation = sv.advise(batch_of([a for a, _ in scene]), batch_of([b for _, b in scene]))
            many = recommendation.given.batches()
        model = recommendation.model
        advised[model.kind] += 1
        proven = [certify(model, a, b) for a, b in scene]
        with np.errstate(all="ignore"):
            ready = prepare(model, many.a), prepare(model, many.b)
            said = [evaluate(model, many, *ready, engine=engine).tolist() for engine in engines]
        if any(found != truth for found in (proven, *said)):
            wrong.append((recommendation, scene))
    return wrong, advised


@pytest.mark.slow
def test_no_recommendation_is_wrong_in_300_scenes():
    wrong, advised = wrong_recommendations(31, 300)
    assert not wrong
    assert set(advised) == {BOUNDING_CIRCLES, AABB, K_DOP, "float32", "float64", EXACT_FILTER}


@pytest.mark.slow
def test_no_recommendation_is_wrong_in_500_scenes():
    assert not wrong_recommendations(32, 500, ("numpy", "numba"))[0]


@pytest.mark.full
def test_no_recommendation_is_wrong_in_10000_scenes():
    assert not wrong_recommendations(33, 10_000, ("numpy", "numba"))[0]


def test_every_recommendation_holds_when_it_is_proven_again():
    for scene in scenes(34, 60):
        assert sv.advise(*scene[0]).check()
        assert sv.advise(batch_of([a for a, _ in scene]), batch_of([b for _, b in scene])).check()


# -- the pair in hand


def test_one_axis_is_enough_where_a_gap_is_found_and_all_are_needed_for_a_hit():
    a, b = sv.scene("triangles").a, sv.scene("triangles").b
    many, said = count_axes(a, b)
    assert many == 1 and "gap of 1.213" in said and "five are enough" in said
    assert count_axes(a, a)[0] == 3
    assert count_axes(sv.record(a, b)) == (many, said)


def test_the_sentence_counts_the_axes_that_touch():
    corner = sv.Polygon([(0, 0), (1, 0), (0, 1)])
    opposite = sv.Polygon([(0, 0), (-1, 0), (0, -1)])
    assert count_axes(corner, opposite) == (
        3,
        "Three axes are needed here: the ranges leave no gap on any, and only all of them prove a hit.",
    )
    assert (
        "touch on one axis and overlap on the others" in count_axes(corner, sv.Polygon([(1, -1), (2, 0.5), (1, 2)]))[1]
    )
    assert (
        "touch on three axes and overlap on the others"
        in count_axes(corner, sv.Polygon([(0, 0), (-1, 0), (-1, -1)]))[1]
    )


def test_enough_axes_for_all_moves_hold_where_the_nearest_vertex_gives_no_axis_of_its_own():
    square = sv.Polygon([(0, 0), (1, 0), (1, 1), (0, 1)])
    for y in (5.0, 5.5):
        many, said = count_axes(square, sv.Circle((1, y), 1))
        assert many == 1 and said.endswith("Wherever they are moved, three are enough.")
    assert count_axes(square, sv.Circle((1.5, 1.7), 1))[0] == 3
    for kind, a, b in pairs(42, 2 * len(CONVEX), list(CONVEX)):
        if words := count_axes(a, b)[1].partition("Wherever they are moved, ")[2]:
            to = [p - q for p, q in zip(a.bounds[:2], b.bounds[:2])]
            with suppress(sv.InvalidShape):
                assert len(sv.axes.needed(a, translated(b, Vec(*to))).axes) <= leading_number(words), kind


def leading_number(words):
    """Return the number that the first word stands for."""
    many = words.split()[0]
    return NUMBER_WORDS.index(many.capitalize()) if many.isalpha() else int(many.replace(",", ""))


def test_a_scope_with_concave_outlines_is_these_coordinates_only():
    """The parts depend on the coordinates, and corners of parts need not be on the grid of the outlines."""
    ring = [(0, 0), (8000, -8000), (8209, -7709), (8300, -6500), (8280, -5880), (8209, -5208), (16, 2984), (-1, 8192)]
    far = [
        sv.Polygon([(64 * x + 2**34, 64 * y + 2**34) for x, y in r])
        for r in (ring, [(0, -100), (-16, -5984), (-15, -5985)])
    ]
    notch = sv.Polygon([(0, 100), (257, 101), (257, 0), (500, 0), (498, 510), (400, 800), (0, 800)])
    found = [far, [notch, sv.Polygon([(499, 255), (600, 200), (600, 300)])]]
    found += [[a, b] for kind, a, b in pairs(43, 60, ["concave", "in the notch"])]
    kinds = {sv.advise(*pair).scope.kind for pair in found}
    kinds |= {sv.advise(batch_of([a]), batch_of([b])).scope.kind for a, b in found[:20]}
    assert kinds <= {ANYWHERE, HERE}
    said = str(sv.advise(sv.Polygon([(0, 0), (8, 2), (2, 10)]), sv.Polygon([(5, 6), (20, 7), (9, 15)])))
    assert "any convex polygons with whole numbers, up to 1,024" in said


def test_circles_that_reach_beyond_float64_are_advised_on():
    coins = batch.Circles([(1e308, 0), (0, 0)], [1.7e308, 1.0])
    assert sv.advise(coins).check() and sv.advise(coins, pairs=[[0, 1]]).check()


def test_two_axes_are_enough_for_upright_boxes_wherever_they_lie():
    box = sv.Polygon([(0, 0), (2, 0), (2, 1), (0, 1)])
    assert count_axes(box, box) == (2, "Two axes are enough, wherever two upright boxes lie: y and x.")


def test_one_axis_is_enough_for_circles():
    coin = sv.Circle((0, 0), 1)
    assert count_axes(coin, coin) == (
        1,
        "One axis is enough, wherever two circles lie: the line through their centers.",
    )
    gap = "One axis is enough here: the line through both centers leaves a gap of 3."
    assert count_axes(coin, sv.Circle((5, 0), 1)) == (1, gap)


def test_no_sentence_calls_overlapping_ranges_touching():
    corner = sv.Polygon([(0, 0), (4, 0), (0, 4)])
    said = "Four axes are needed here: the ranges leave no gap on any, and only all of them prove a hit."
    assert count_axes(corner, sv.Polygon([(1, 1), (5, 1), (1, 6)])) == (4, said)


def test_enough_axes_for_a_hit_of_parts_are_those_of_the_parts_that_meet():
    roof = sv.Polygon([(0, 0), (4, 0), (4, 2), (2, 2), (0, 5)])  # a box below, a triangle on its left half
    for x, y, many in (3.0, 0.5, "Two"), (0.2, 2.5, "Three"):
        small = sv.Polygon([(x, y), (x + 0.2, y), (x + 0.2, y + 0.2), (x, y + 0.2)])
        said = f"{many} axes are needed here: all those of two convex parts that meet."
        assert count_axes(roof, small) == (NUMBER_WORDS.index(many), said)


def test_the_axis_count_of_concave_outlines_holds_for_these_coordinates_only_and_names_the_shapes_of_a_trace():
    notch = sv.Polygon([(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)])
    far = sv.Polygon([(9, 9), (10, 9), (10, 10), (9, 10)])
    said = "One axis is enough here: the normal of B's hull edge b3b5 leaves a gap of 8.485."
    assert count_axes(far, notch) == (1, said)
    said = "One axis is enough here: the normal of A's hull edge a3a5 leaves a gap of 8.485."
    assert count_axes(notch, far) == (1, said)
    roof = sv.Polygon([(0, 0), (4, 0), (4, 2), (2, 2), (0, 5)])
    pairs = sv.record(sv.Polygon([(2, 3.5), (3, 3.5), (3, 4.5)]), roof).pairs
    assert [count_axes(pair)[1].partition(" leaves")[0] for pair in pairs] == [
        "One axis is enough here: the normal of B1's edge b1.1 to b1.2",
        "One axis is enough here: the normal of B2's edge b2.1 to b2.2",
    ]
    with pytest.raises(TypeError, match=r"^argument b is a str: "):
        count_axes(far, "B")


def test_a_normal_of_the_hull_may_be_enough_where_no_edge_normal_is():
    dart = sv.Polygon([(-3, -3), (4, 0), (1, 1), (0, 4)])
    square = sv.Polygon([(2.2, 2.2), (3.2, 2.2), (3.2, 3.2), (2.2, 3.2)])
    assert count_axes(dart, square)[0] == 1
    notch = sv.Polygon([(0, 0), (4, 0), (4, 3), (3, 3), (3, 1), (1, 1), (1, 3), (0, 3)])
    assert count_axes(notch, sv.Circle((2, 2), 0.5)) == (
        3,
        "No one normal of an edge is enough here, but one for each of the 3 pairs of convex parts is.",
    )


NOTCH = sv.Polygon([(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)])
COIN = sv.Circle((0, 0), 1)
CORNER, FACING = sv.Polygon([(0, 0), (4, 0), (0, 4)]), sv.Polygon([(4, 4), (4, 0.5), (0.5, 4)])
ONLY_Y = sv.Shortcut("only y", "y is enough", sv.axes.directions((0, 1)))
ONE_WITH_A_GAP = "One axis with a gap is enough here."
NOT_ALL = "The axes of this scene are not all that are needed: without a gap on them, nothing is proven."


@pytest.mark.parametrize(
    ("trace", "hint"),
    [
        (sv.record(CORNER, FACING), f"{ONE_WITH_A_GAP} Wherever they are moved, three are enough."),
        (sv.record(COIN, sv.Circle((3, 0), 1)), ONE_WITH_A_GAP),
        (sv.record(NOTCH, sv.Circle((9, 9), 1)), ONE_WITH_A_GAP),
        (sv.record(CORNER, FACING, axes=ONLY_Y), ""),
        (sv.record(CORNER, FACING, axes=sv.axes.world), f"{ONE_WITH_A_GAP} Wherever they are moved, three are enough."),
        (sv.record(CORNER, CORNER, axes=sv.axes.world), NOT_ALL),
        (sv.record(NOTCH, sv.Circle((3, 3), 0.5), axes=sv.axes.world), NOT_ALL),
        *((sv.record(a, b), None) for a in (NOTCH, COIN, CORNER) for b in (a, sv.Circle((2, 0), 1))),
        (sv.record(NOTCH, sv.Circle((3, 3), 0.5)), None),
    ],
)
def test_a_hint_says_how_many_axes_are_enough_and_no_gap(trace, hint):
    """The hint is empty beside a trace of a shortcut; where one gap proves nothing, it is that of the shapes."""
    assert axes_hint(trace) == (count_axes(trace)[1] if hint is None else hint)


def test_enough_axes_are_counted_for_pairs_of_every_kind():
    for kind, a, b in pairs(41, 3 * len(KINDS)):
        many, said = count_axes(a, b)
        assert many >= 1 and said.endswith("."), kind
        assert (
            sv.relate(a, b) is Relation.APART
            or many == 1
            or "here: the ranges" in said
            or "wherever" in said
            or ("two convex parts" in said)
        ), kind


def test_two_shapes_are_advised_on_and_counted_without_numpy():
    code = (
        "import sys, satviz as sv\n"
        "from satviz.engine.axis_count import count_axes\n"
        "scene = sv.scene('triangles')\n"
        "count_axes(scene.a, scene.b), str(sv.advise(scene)), sv.advise(scene).to_json(), sv.advise(scene).check()\n"
        "assert not {'numpy', 'matplotlib'} & set(sys.modules)"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


@given(some_pairs())
@settings(max_examples=40, deadline=None, suppress_health_check=list(HealthCheck))
def test_no_recommendation_on_two_shapes_is_wrong(pair):
    assert certify(sv.advise(*pair).model, *pair) is oracle.relation(*pair)


# -- what a recommendation says


def boxes_at(corners, w=1.0, h=1.0):
    return batch.Polygons(np.array(corners)[:, None] + np.array([[0, 0], [w, 0], [w, h], [0, h]]))


def test_upright_boxes_need_two_axes_wherever_they_lie():
    recommendation = sv.advise(boxes_at([(0, 0), (0.9, 0.1), (1, 1), (2.5, 0.1)]))
    assert (recommendation.model.kind, recommendation.model.axes, recommendation.scope.kind) == (AABB, 2, "anywhere")
    assert recommendation.summary.relations == (0, 1, 2)
    assert recommendation.summary.settled == 3
    assert recommendation.summary.relative_margin == 0
    assert recommendation.check() and recommendation.anywhere == recommendation.model
    assert "3 more are apart by their boxes" in str(recommendation)


def test_the_first_pair_on_which_the_smaller_model_fails_is_named_and_can_be_drawn():
    kite = np.array([(0, -1), (1, 0), (0, 1), (-1, 0)])
    a = batch.Polygons(kite + np.array([(0, 0), (0, 0), (9, 9)])[:, None])
    b = batch.Polygons(kite + np.array([(5, 5), (1.4, 1.4), (0, 0)])[:, None])
    recommendation = sv.advise(a, b)
    smaller = next(j for j in recommendation.results if j.model.kind == AABB)
    assert (smaller.wrong, smaller.first) == (1, (1, 1))
    assert recommendation.model == Model(K_DOP, 2, recommendation.model.directions) and recommendation.check()
    trace = recommendation.failure()
    assert trace.claim is not trace.relation and trace.relation is Relation.APART
    assert sv.picture(trace).marks
    assert "wrong on 1; the first is pair (1, 1)" in str(recommendation)


def test_a_failure_of_the_circles_around_shapes_can_be_drawn():
    recommendation = sv.advise("triangles")
    assert recommendation.smaller.model.kind == BOUNDING_CIRCLES
    trace = recommendation.failure()
    assert trace.claim is Relation.OVERLAPPING and trace.relation is Relation.APART
    assert sv.picture(trace).marks


CORNER_ON_EDGE = [(0, 0), (6, 2), (2, 6)], [(4, 4), (9, 3), (8, 9)]


def test_touching_shapes_on_a_grid_are_right_in_float32_since_nothing_is_rounded():
    recommendation = sv.advise(batch.Polygons(np.array(CORNER_ON_EDGE, float)))
    assert recommendation.model.kind == "float32"
    assert recommendation.scope.kind == "multiples of a unit"
    assert recommendation.check()
    assert recommendation.summary.relative_margin == 0 and recommendation.scope.bound == 2.0**10


def test_a_recommendation_on_a_grid_holds_all_over_the_grid():
    rng = np.random.default_rng(5)
    rings = np.array(CORNER_ON_EDGE, float)
    model = sv.advise(batch.Polygons(rings)).model
    for shift in rng.integers(-1000, 1000, (30, 2)):
        moved = batch.Polygons(rings + shift)
        many = paired(moved, np.array([0]), moved, np.array([1]))
        assert evaluate(model, many, prepare(model, moved), prepare(model, moved), engine="numpy").tolist() == [1]


def test_a_recommendation_on_a_scene_moved_as_a_whole_holds_up_to_its_bound():
    rng = np.random.default_rng(6)
    rings = rng.integers(1, 2**20, (40, 3, 2)) * 2.0**-20 + 2.0**13 + rng.integers(0, 3, (40, 1, 2)) / 2
    shapes = batch.Polygons(rings)
    recommendation = sv.advise(shapes)
    assert (recommendation.model.kind, recommendation.scope.kind) == ("float64", "moved as a whole")
    right = batch.relate(shapes, shapes, (pairs := batch.candidate_pairs(shapes.bounds)))
    assert recommendation.check()
    shift = min(recommendation.scope.bound, 2.0**31) - 2.0**14  # so that float64 holds the moved coordinates
    moved = batch.Polygons(rings + shift)
    assert (batch.relate(moved, moved, pairs) == right).all() and np.abs(
        rings + shift
    ).max() <= recommendation.scope.bound
    many = paired(moved, pairs[:, 0], moved, pairs[:, 1])
    assert (classify(recommendation.model, many, right) == right).all()


def test_a_recommendation_far_from_the_origin_passes_its_check():
    rng = np.random.default_rng(7)
    turns = np.linspace(0, 2 * np.pi, 5, endpoint=False)
    ring = np.stack([np.cos(turns), np.sin(turns)], axis=1)
    for far in (2.0**5, 2.0**12, 5e6, 2.0**30):
        a, b = (batch.Polygons(ring + far + rng.uniform(-2, 2, (60, 1, 2))) for _ in "ab")
        assert sv.advise(a, b).check()


def wrong_claims(recommendation):
    """Yield (recommendation with one wrong claim, the claim)."""
    facts, scope = recommendation.summary, recommendation.scope
    a, b, c = facts.relations
    for claim in (
        {"kinds": {"upright boxes": 1}} if set(facts.kinds) != {"upright boxes"} else {"kinds": {"circles": 1}},
        {"kinds": {kind: n + 1 for kind, n in facts.kinds.items()}},
        {"corners": (facts.corners[0], facts.corners[1] + 1)},
        {"size_ratio": facts.size_ratio * 2},
        {"pairs": facts.pairs + 1, "relations": (a + 1, b, c)},
        {"relations": (a - 1, b + 1, c) if a else (a, b + 1, c - 1)},
        {"relative_margin": facts.relative_margin * 2 + 1},
        {"at": (90, 91)},
    ):
        yield replace(recommendation, summary=facts._replace(**claim)), claim
    for k, one in enumerate(recommendation.results):
        before, after = recommendation.results[:k], recommendation.results[k + 1 :]
        for claim in (
            {"wrong": one.wrong + 1, "first": one.first or facts.at},
            {"wrong": 0, "uncertain": 0, "first": None} if not one.proven else {"uncertain": 1, "first": facts.at},
            {"proven_for_hits": not one.proven_for_hits},
            {"first": (90, 91)},
            {"model": one.model._replace(axes=one.model.axes + 1)},
            {"model": one.model._replace(directions=((1.0, 0.0), (0.0, 1.0)))},
        ):
            yield (
                replace(
                    recommendation,
                    results=(*before, one._replace(**claim), *after),
                ),
                claim,
            )
        yield (
            replace(recommendation, results=(*before, *after)),
            f"no {one.model.name}",
        )
    for kind in {ANYWHERE, MULTIPLES, MOVED} - {scope.kind}:
        yield replace(recommendation, scope=Scope(kind, 2.0**60, 0)), kind
    if scope.bound:
        yield replace(recommendation, scope=scope._replace(bound=scope.bound * 4)), "bound"
    if scope.unit is not None:
        yield replace(recommendation, scope=scope._replace(unit=scope.unit - 1)), "unit"


def test_a_recommendation_with_any_wrong_claim_does_not_pass_its_check():
    rng, seen = np.random.default_rng(8), set()
    rings = rng.integers(1, 2**20, (40, 3, 2)) * 2.0**-20 + 2.0**13 + rng.integers(0, 3, (40, 1, 2)) / 2
    far = batch.Polygons(rings)
    candidates = batch.candidate_pairs(far.bounds)
    nearest = np.argsort(abs(signed_relative_margins(paired(far, candidates[:, 0], far, candidates[:, 1]))))[:5]
    some = [sv.advise(far, pairs=candidates[nearest]), sv.advise(batch.Polygons(np.array(CORNER_ON_EDGE, float)))]
    some += [sv.advise(boxes_at([(0, 0), (0.9, 0.1), (1, 1)])), sv.advise("triangles"), sv.advise("concave")]
    some += [sv.advise(sv.Circle((0.1, 0.2), 1), sv.Circle((0.1, 2.2), 1)), sv.advise("circle-polygon")]
    for recommendation in some:
        assert recommendation.check()
        seen.add(recommendation.scope.kind)
        for doctored, claim in wrong_claims(recommendation):
            assert not doctored.check(), (recommendation, claim)
    assert seen == {ANYWHERE, MULTIPLES, MOVED, HERE}


def test_a_bound_is_the_largest_power_of_two_within_what_is_allowed():
    for e in (-249, -60, -1, 0, 1, 53, 249):
        below, above = math.nextafter(2.0**e, 0), math.nextafter(2.0**e, math.inf)
        assert [power_of_two_bound(allowed, 0.0) for allowed in (below, 2.0**e, above)] == [
            2.0 ** (e - 1),
            2.0**e,
            2.0**e,
        ]
        assert power_of_two_bound(above, 2.0**e) == 0.0
    assert power_of_two_bound(0.0, 0.0) == power_of_two_bound(math.inf, 1.0) == 0.0
    assert power_of_two_bound(1e300, 1.0) == 2.0**250


def test_a_recommendation_for_the_largest_floats_is_valid_json():
    for least in (1.0, 1.5e308, 5e-324):
        wide = sv.Polygon([(-1.6e308, 0), (1.6e308, 0), (0, 1.6e308)])
        tiny = sv.Polygon([(0, 0), (least, 0), (0, least)])
        for recommendation in (sv.advise(wide, tiny), sv.advise(batch_of([wide]), batch_of([tiny]))):
            assert json.loads(recommendation.to_json())["facts"]["size_ratio"] > 1
            assert recommendation.check()
            assert str(recommendation)


def test_pairs_whose_boxes_are_apart_need_no_further_test():
    recommendation = sv.advise(boxes_at([(0, 0), (1.2, 0), (9, 0)]))  # the circles around the first two meet
    assert recommendation.model.kind == AABB
    assert recommendation.summary.pairs == 0
    assert recommendation.check()
    assert recommendation.costs() == {}
    assert "all 3 pairs" in str(recommendation) and "no two boxes meet" in str(recommendation)
    with pytest.raises(ValueError, match="no pair to time"):
        recommendation.chart()
    assert sv.advise(boxes_at([(0, 0), (5, 5), (9, 0)])).model.kind == BOUNDING_CIRCLES


@pytest.mark.parametrize(
    ("shapes", "pairs"),
    [
        ([(0, 0), (1, 0)], np.empty((0, 2), int)),
        ([(0, 0), (1, 0)], []),
        ([(0, 0)], None),
        (np.empty((0, 2)), None),
    ],
)
def test_nothing_is_recommended_for_an_empty_list_of_pairs(shapes, pairs):
    with pytest.raises(ValueError, match=r"nothing to advise on"):
        sv.advise(batch.Circles(shapes, 1.0), pairs=pairs)


def test_a_model_for_hits_only_may_be_smaller_than_one_for_relations():
    box = sv.Polygon([(0, 0), (1, 0), (1, 1), (0, 1)])
    recommendation = sv.advise(box, sv.Polygon([(1, 0.5), (2, 0), (2, 1)]))  # touching; their circles overlap
    assert recommendation.for_hits.model.kind == BOUNDING_CIRCLES and recommendation.model.kind != BOUNDING_CIRCLES
    assert "bounding circles (1 axis) is enough to tell hits from misses, where touching is a hit" in str(
        recommendation
    )


def test_a_recommendation_is_json_and_the_same_each_time():
    for name in ("triangles", "circles", "concave", "aabb"):
        text = sv.advise(name).to_json()
        data = json.loads(text)
        assert data["model"]["name"] == sv.advise(name).model.name and sv.advise(name).to_json() == text
        assert [c["proven"] for c in data["candidates"]].count(True) >= 1


def test_concave_shapes_get_one_recommendation_for_all_their_parts():
    some = list(pairs(51, 24, ["concave", "in the notch"]))
    recommendation = sv.advise(batch_of([a for _, a, _ in some]), batch_of([b for _, _, b in some]))
    assert recommendation.summary.kinds["concave polygons"] >= 20 and recommendation.check()


@pytest.mark.parametrize(
    "wrong",
    [
        (3,),
        (sv.Circle((0, 0), 1),),
        ("triangles", sv.Circle((0, 0), 1)),
        (sv.Circle((0, 0), 1), sv.Circle((0, 0), 1), [[0, 1]]),
    ],
)
def test_advise_refuses_an_invalid_scene(wrong):
    with pytest.raises((TypeError, ValueError), match=r"satviz|batch|scene"):
        sv.advise(*wrong)


# -- costs and the chart


@pytest.mark.slow
def test_costs_are_those_of_all_candidates_and_count_their_wrong_answers():
    recommendation = sv.advise("triangles")
    found = recommendation.costs()
    assert found.keys() == {j.model.name for j in recommendation.results}
    assert all(cost.cold > 0 and cost.warm > 0 for cost in found.values())
    assert (found[BOUNDING_CIRCLES].wrong, found[recommendation.model.name].wrong) == (1, 0)


@pytest.mark.parametrize("theme", THEMES.values(), ids=lambda theme: theme.name)
@pytest.mark.parametrize("seed", one_in(3, range(6)))
def test_the_labels_of_the_chart_cover_nothing_and_stay_on_it(seed, theme):
    from matplotlib.text import Text

    from satviz.advice.cost_chart import cost_chart

    rng = Random(seed)
    names = BOUNDING_CIRCLES, AABB, "ranges on 8 directions", "SAT, float32", "SAT, float64", EXACT_FILTER
    rows = []
    for i, name in enumerate(names):
        warm = 10 ** rng.uniform(0.5, 3) if seed else 50.0
        cold, wrong = warm * rng.uniform(1, 5), 0 if i > 2 else rng.choice((1, 40, 12_345))
        rows.append({"model": name, "role": "float", "cold": cold, "warm": warm, "wrong": wrong})
    fig = cost_chart(("title", "under"), rows, "SAT, float32", "words").figure(theme)
    renderer = fig.canvas.get_renderer()
    texts = [t for ax in fig.axes for t in ax.texts]
    boxes = [Text.get_window_extent(t, renderer) for t in texts]  # without the lines to the points
    assert len(boxes) == 6
    for one, other in combinations(boxes, 2):
        assert not (min(one.x1, other.x1) > max(one.x0, other.x0) and min(one.y1, other.y1) > max(one.y0, other.y0))
    for box in boxes:
        assert box.x0 >= 0 and box.y0 >= 0 and box.x1 <= fig.bbox.x1 and box.y1 <= fig.bbox.y1


@pytest.mark.slow
def test_the_chart_is_a_file_that_says_what_it_shows():
    chart = sv.advise("triangles").chart()
    assert b"made by satviz" in chart.encode("svg", THEMES["dark"]) and chart.encode("png").startswith(b"\x89PNG")
    assert "AABB is right for this pair" in repr(chart)
    assert chart._repr_mimebundle_()["image/svg+xml"].startswith("<svg")


# -- on the command line


def shapes_file(tmp_path, **arrays):
    path = tmp_path / "shapes.npz"
    np.savez(path, **arrays)
    return str(path)


def test_the_command_advises_on_scenes(capsys):
    assert main(["advise", "triangles"]) == 0
    said = capsys.readouterr().out
    assert said.startswith(f"{sv.advise('triangles')}\n") and "\ncost     " in said
    assert main(["advise", "far-centers", "--json"]) == 0
    assert json.loads(capsys.readouterr().out) == json.loads(sv.advise("far-centers").to_json())


@pytest.mark.slow
def test_the_command_advises_on_a_file_of_many_shapes_and_draws_the_costs_of_the_models(tmp_path, capsys):
    rings = np.array([(0, 0), (1, 0), (1, 1), (0, 1), (0, 0), (1, 0.0), (0, 1)])
    path = shapes_file(tmp_path, coords=rings, offsets=[0, 4, 7], centers=[(2, 0.5), (0, 0)], radii=[1, 0.5])
    assert main(["advise", path, "--chart", str(tmp_path / "new"), "--json"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert data["facts"]["kinds"] == {"upright boxes": 1, "circles": 2, "convex polygons": 1}
    assert data["costs"].keys() == {c["name"] for c in data["candidates"]}
    assert {p.name for p in (tmp_path / "new").iterdir()} == {
        f"advice{dark}.{form}" for dark in ("", "-dark") for form in ("svg", "png")
    }
    path = shapes_file(tmp_path, centers=[(2, 0.5), (0, 0), (9, 9)], radii=[1, 0.5, 1], pairs=[[0, 2]])
    assert main(["advise", path]) == 0
    assert "1: 1 apart" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arrays", "says"),
    [
        ({"centers": [(0, 0)]}, "lacks 'radii'"),
        ({"centres": [(0, 0)]}, "unknown array 'centres'"),
        ({}, "has no shapes"),
        ({"centers": [(0, 0)], "radii": [-1.0]}, "circle 0: radius is -1.0"),
        ({"coords": [(0, 0), (1, 1), (2, 2)], "offsets": [0, 3]}, "polygon 0"),
        ({"centers": [(0, 0)], "radii": [1.0], "pairs": [[0, 1]]}, "expected (i, j) with"),
        ({"centers": [(0, 0)], "radii": [1.0], "pairs": [0.5]}, "pairs is float64 of the shape (1,)"),
        ({"coords": np.array([{}]), "offsets": [0]}, "coords is object of the shape (1,)"),
    ],
)
def test_a_file_that_holds_no_shapes_gives_one_clear_line(arrays, says, tmp_path, capsys):
    assert main(["advise", shapes_file(tmp_path, **arrays)]) == 2
    line = capsys.readouterr().err
    assert says in line and line.count("\n") == 1


def test_an_invalid_file_of_shapes_gives_one_clear_line(tmp_path, capsys):
    bad = tmp_path / "bad.npz"
    bad.write_text("no arrays")
    for name in (str(bad), str(tmp_path / "none.npz"), "nonsense", "pentagram"):
        assert main(["advise", name]) == 2
        assert capsys.readouterr().err.count("\n") == 1


# -- whatever the order, whatever the size


def by_the_squared_turn(circle, polygon, dtype):
    """Return the relation of a circle and a polygon as many write it: the squared cross product by the squared edge."""
    x, y, r = (dtype(c) for c in (*circle.center, circle.radius))
    ring = [(dtype(p) - x, dtype(q) - y) for p, q in polygon.core]
    inside, nearest = True, dtype(math.inf)
    for (px, py), (qx, qy) in zip(ring, [*ring[1:], ring[0]]):
        dx, dy = qx - px, qy - py
        turn, along, square = px * dy - py * dx, -(px * dx + py * dy), dx * dx + dy * dy
        inside = inside and turn > 0
        x, y = (px, py) if along <= 0 else (qx, qy)
        nearest = min(nearest, turn * turn / square if 0 < along < square else x * x + y * y)
    gap = nearest - r * r
    return Relation.OVERLAPPING if inside or gap < 0 else Relation.TOUCHING if gap == 0 else Relation.APART


@pytest.mark.parametrize(("kind", "dtype", "far"), [("float32", np.float32, 60), ("float64", np.float64, 500)])
def test_floats_are_certified_only_where_products_underflow_and_overflow_in_no_order(kind, dtype, far):
    rng = Random(61)
    certified = 0
    for _ in range(600):
        unit = 2.0 ** rng.randint(-far, far)
        ring = [(rng.uniform(-9, 9) * unit, rng.uniform(-9, 9) * unit) for _ in range(3)]
        circle = sv.Circle((rng.uniform(-9, 9) * unit, rng.uniform(-9, 9) * unit), rng.uniform(0.1, 4) * unit)
        polygon = sv.Polygon(ring)
        said = certify(Model(kind, 4), circle, polygon)
        if said is not None:
            certified += 1
            with np.errstate(all="ignore"):
                assert by_the_squared_turn(circle, polygon, dtype) is said, (circle, polygon)
    assert certified > 200


def hardly_apart(seed, count):
    """Yield pairs of triangles with corners some roundings apart, whose scale differs between the axes."""
    rng = np.random.default_rng(seed)
    for _ in range(count):
        ring, other = rng.uniform(1, 2, (2, 3, 2))
        other += ring[0] - other[0] + rng.integers(-90, 90, 2) * 2.0**-52
        by = 2.0 ** rng.integers(-20, 20, 2)
        try:
            yield sv.Polygon(ring * by), sv.Polygon(other * by)
        except sv.InvalidShape:
            continue


@pytest.mark.slow
def test_polygons_of_full_precision_are_certified_in_float64_where_the_relative_margin_is_beyond_32():
    model, certified_pairs = Model("float64", 6), Counter()
    for a, b in hardly_apart(64, 300):
        beyond = relative_margin(a, b) > SAT_ROUNDINGS
        certified_pairs[beyond] += 1
        many = repeated_pair(a, b, 1)
        assert (certify(model, a, b) is not None) is beyond, (a, b)
        assert (classify(model, many, batch.relate(many.a, many.b))[0] >= 0) == beyond, (a, b)
    assert min(certified_pairs.values()) > 50


@pytest.mark.slow
def test_a_recommendation_on_a_pair_is_the_same_for_many_as_for_two():
    kinds = pairs(62, len(KINDS))
    for a, b in [*hardly_apart(62, 40), *((a, b) for _, a, b in kinds)]:
        two, many = sv.advise(a, b), sv.advise(batch_of([a]), batch_of([b]))
        assert two.summary.relative_margin == pytest.approx(many.summary.relative_margin, rel=0.02)
        assert two.results == many.results
        assert two.summary._replace(relative_margin=0) == many.summary._replace(relative_margin=0)
        assert two.check() and many.check()


@pytest.mark.slow
def test_every_failure_can_be_drawn_with_the_true_relation():
    seen = Counter()
    for kind, a, b in pairs(63, 2 * len(KINDS)):
        for recommendation in (sv.advise(a, b), sv.advise(batch_of([a]), batch_of([b]))):
            trace, smaller = recommendation.failure(), recommendation.smaller
            assert (trace is None) == (smaller is None), kind
            if smaller is not None:
                assert trace.relation is oracle.relation(a, b), kind
                seen[smaller.model.kind, bool(smaller.wrong)] += 1
                if smaller.wrong:
                    assert trace.claim is not trace.relation, kind
    assert seen[BOUNDING_CIRCLES, False] and seen[BOUNDING_CIRCLES, True] and seen[AABB, True], seen


def test_the_convex_parts_of_a_polygon_join_to_its_outline():
    seen = 0
    for kind, a, _ in pairs(64, 40, ["concave", "in the notch"]):
        if len(pieces := parts(a)) > 1:
            again = SplitPolygon(pieces).outline().core
            start = again.index(a.core[0])
            assert (*again[start:], *again[:start]) == a.core, kind
            seen += 1
    assert seen > 20


def test_no_file_of_random_bytes_makes_satviz_fail(tmp_path):
    whole, rng = tmp_path / "whole.npz", Random(65)
    np.savez_compressed(whole, centers=[(2, 0.5), (0, 0)], radii=[1, 0.5], pairs=[[0, 1]])
    bad, seen = tmp_path / "bad.npz", Counter()
    files = []
    for _ in range(150):
        raw = bytearray(whole.read_bytes())
        for _ in range(rng.randint(1, 3)):
            raw[rng.randrange(len(raw))] = rng.randrange(256)
        files.append(bytes(raw))
    for header in (
        '{"descr": ((((',
        "{'descr': '<f8', 'fortran_order': False, 'shape': (1000000000000, 2), }",
        "3",
        "",
    ):
        with zipfile.ZipFile(bad, "w") as made:
            made.writestr("centers.npy", b"\x93NUMPY\x01\x00" + len(header).to_bytes(2, "little") + header.encode())
        files.append(bad.read_bytes())
    for raw in files:
        bad.write_bytes(raw)
        try:
            seen[len(load_shapes(bad)[0])] += 1
        except sv.InvalidScene as error:
            seen["refused"] += 1
            assert str(bad) in str(error) and "\n" not in str(error), raw
    assert seen["refused"] > 50


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no named pipes there")
def test_a_pipe_is_refused_as_a_file_of_shapes_without_waiting(tmp_path, capsys):
    pipe = tmp_path / "pipe.npz"
    os.mkfifo(pipe)
    assert main(["advise", str(pipe)]) == 2
    assert "not a regular file" in capsys.readouterr().err


@pytest.mark.parametrize("name", SCENES)
def test_every_scene_of_the_regrets_benchmark_is_advised_on(name):
    recommendation = sv.advise(*SCENES[name](np.random.default_rng(1), 240))
    assert recommendation.summary.pairs and recommendation.best.proven
