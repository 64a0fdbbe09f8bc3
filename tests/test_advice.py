"""The least model that is right: what it claims is proven, and never wrong."""

import math
import subprocess
import sys
from collections import Counter
from itertools import combinations
from random import Random

import numpy as np
import oracle
import pytest
from forms import batch_of
from strategies import CONVEX, KINDS, NotConvex, drawn, pairs, scaled

import satviz as sv
from satviz import batch
from satviz.advice.gamma import gamma, gammas, signed
from satviz.advice.many import of_shapes
from satviz.advice.models import answers, kept, paired, sure
from satviz.advice.pair import enough
from satviz.advice.proofs import BOXES, CIRCLES, DIRECTIONS, EXACT, Model
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
    found = list(pairs(14, 90))
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


# -- models


WAYS = sv.Vec(0.5, 0.5), sv.Vec(0.75, -0.25), sv.Vec(0.0, 0.5), sv.Vec(0.1, 0.7)
MODELS = [*(Model(kind, 1) for kind in (CIRCLES, BOXES, "float32", "float64", EXACT)), Model(DIRECTIONS, 4, WAYS)]


@pytest.mark.parametrize("engine", ["numpy", "numba"])
def test_what_is_sure_for_many_is_sure_by_fractions_and_is_what_the_model_answers(engine):
    known = Counter()
    some = list(pairs(21, 8 * len(KINDS)))
    for model in MODELS:
        a, b = batch_of([a for _, a, _ in some]), batch_of([b for _, _, b in some])
        i = np.arange(len(some))
        told = sure(model, many := paired(a, i, b, i), batch.relate(a, b)).tolist()
        with np.errstate(all="ignore"):
            said = answers(model, many, kept(model, a), kept(model, b), engine=engine).tolist()
        for (kind, p, q), one, answer in zip(some, told, said, strict=True):
            if one != -1 and not (model.kind == DIRECTIONS and (p.radius or q.radius)):
                known[model.name] += 1
                assert model.sure(p, q) == one == answer, (model.name, kind, p, q)
    assert min(known.values()) > 25 and len(known) == len(MODELS)


# -- never a wrong advice


def tiles(rng):
    """Boxes on a grid that share edges and corners, or cut each other, whole or not."""
    unit, far = rng.choice((1.0, 0.1, 2.0**-20, 1e6)), rng.choice((0, 0, 2**12, 2**40))
    at = [(far + rng.randint(0, 4), far + rng.randint(0, 4)) for _ in range(4)]
    size = [(rng.randint(1, 2), rng.randint(1, 2)) for _ in range(4)]
    made = [
        sv.Polygon([((x + u * w) * unit, (y + v * h) * unit) for u, v in ((0, 0), (1, 0), (1, 1), (0, 1))])
        for (x, y), (w, h) in zip(at, size, strict=True)
    ]
    return list(combinations(made, 2))


def turned_alike(rng):
    """Boxes with common directions, whole or rounded, side by side or not."""
    (p, q), unit = rng.choice(((3, 4), (1, 1), (5, 12), (0.6, 0.8), (0.31, 0.77))), rng.choice((1.0, 2.0**-30, 0.1))
    made = []
    for _ in range(3):
        x, y, w, h = rng.randint(0, 5), rng.randint(0, 5), rng.randint(1, 3), rng.randint(1, 3)
        corners = ((x, y), (x + w, y), (x + w, y + h), (x, y + h))
        made.append(sv.Polygon([((u * p - v * q) * unit, (u * q + v * p) * unit) for u, v in corners]))
    return list(combinations(made, 2))


def coins(rng):
    """Circles, many of them tangent; and polygons among them."""
    unit, far = rng.choice((1.0, 0.1, 2.0**-9)), rng.choice((0, 2**10, 2**30))
    made = [
        sv.Circle(((far + rng.randint(0, 8)) * unit, (far + rng.randint(0, 8)) * unit), rng.randint(1, 3) * unit)
        for _ in range(3)
    ]
    if rng.random() < 0.4:
        made.append(sv.Polygon([((far + x) * unit, (far + y) * unit) for x, y in ((0, 0), (6, 1), (3, 7))]))
    return list(combinations(made, 2))


def ordinary(rng):
    """Shapes strewn about, of sizes up to 2**60 apart, in pairs of all kinds."""
    kinds = rng.sample(("random polygons", "random circles", "concave", "few corners", "near touching, offset 1"), 3)
    found = [drawn(rng, kind) for kind in kinds]
    power = rng.choice((0, 0, 3, 20, 60))
    return [(scaled(a, power), b) if rng.random() < 0.5 else (a, b) for a, b in found]


def hard(rng):
    """Pairs of one of the kinds that the engine is held against."""
    return [drawn(rng, rng.choice(list(KINDS))) for _ in range(rng.choice((1, 1, 2)))]


def scenes(seed, count):
    """Lists of pairs; what satviz refuses to build is drawn again."""
    rng, made = Random(seed), 0
    while made < count:
        try:
            found = (hard, tiles, turned_alike, coins, ordinary)[made % 5](rng)
        except (NotConvex, OverflowError, sv.InvalidShape):
            continue
        made += 1
        yield found if made % 3 else found[:1]


def wrong_advices(seed, count, engines=("numpy",)):
    """The scenes whose advised model is not sure of the truth or does not answer it, and what was advised how often."""
    wrong, advised = [], Counter()
    for scene in scenes(seed, count):
        truth = [oracle.relation(a, b) for a, b in scene]
        if len(scene) == 1:
            advice = sv.advise(*scene[0])
            many = of_shapes(*scene[0], copies=1)
        else:
            advice = sv.advise(batch_of([a for a, _ in scene]), batch_of([b for _, b in scene]))
            many = advice.case.batches()
        model = advice.model
        advised[model.kind] += 1
        surely = [model.sure(a, b) for a, b in scene]
        with np.errstate(all="ignore"):
            ready = kept(model, many.a), kept(model, many.b)
            said = [answers(model, many, *ready, engine=engine).tolist() for engine in engines]
        if any(found != truth for found in (surely, *said)):
            wrong.append((advice, scene))
    return wrong, advised


def test_no_advice_is_wrong_in_300_scenes():
    wrong, advised = wrong_advices(31, 300)
    assert not wrong
    assert set(advised) == {CIRCLES, BOXES, DIRECTIONS, "float32", "float64", EXACT}


@pytest.mark.slow
def test_no_advice_is_wrong_in_2000_scenes():
    assert not wrong_advices(32, 2000, ("numpy", "numba"))[0]


@pytest.mark.full
def test_no_advice_is_wrong_in_10000_scenes():
    assert not wrong_advices(33, 10_000, ("numpy", "numba"))[0]


def test_every_advice_holds_when_it_is_proven_again():
    for scene in scenes(34, 60):
        assert sv.advise(*scene[0]).check()
        assert sv.advise(batch_of([a for a, _ in scene]), batch_of([b for _, b in scene])).check()


# -- the pair in hand


def test_one_axis_is_enough_where_a_gap_is_found_and_all_are_needed_for_a_hit():
    a, b = sv.scene("triangles").a, sv.scene("triangles").b
    many, said = enough(a, b)
    assert many == 1 and "gap of 1.213" in said and "five are enough" in said
    assert enough(a, a)[0] == 3
    assert enough(sv.record(a, b)) == (many, said)


def test_two_axes_are_enough_for_upright_boxes_wherever_they_lie():
    box = sv.Polygon([(0, 0), (2, 0), (2, 1), (0, 1)])
    assert enough(box, box) == (2, "Two axes are enough, wherever two upright boxes lie: y and x.")


def test_one_axis_is_enough_for_circles():
    coin = sv.Circle((0, 0), 1)
    assert enough(coin, coin)[0] == enough(coin, sv.Circle((5, 0), 1))[0] == 1


def test_a_hulls_normal_may_be_enough_where_no_edges_is():
    dart = sv.Polygon([(-3, -3), (4, 0), (1, 1), (0, 4)])
    square = sv.Polygon([(2.2, 2.2), (3.2, 2.2), (3.2, 3.2), (2.2, 3.2)])
    assert enough(dart, square)[0] == 1
    notch = sv.Polygon([(0, 0), (4, 0), (4, 3), (3, 3), (3, 1), (1, 1), (1, 3), (0, 3)])
    assert enough(notch, sv.Circle((2, 2), 0.5)) == (
        3,
        "No one normal of an edge is enough here: each of the 3 pairs of convex parts needs its own.",
    )


def test_enough_axes_are_counted_for_pairs_of_every_kind():
    for kind, a, b in pairs(41, 3 * len(KINDS)):
        many, said = enough(a, b)
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
        "from satviz.advice.pair import enough\n"
        "scene = sv.scene('triangles')\n"
        "enough(scene.a, scene.b), str(sv.advise(scene)), sv.advise(scene).to_json(), sv.advise(scene).check()\n"
        "assert not {'numpy', 'matplotlib'} & set(sys.modules)"
    )
    subprocess.run([sys.executable, "-c", code], check=True)
