"""Few shapes in NumPy: each scene by every way that few shapes can take, and which pairs need exact arithmetic.

What is expected comes from rationals: `oracle.relation`, pair by pair.
"""

import tracemalloc
from fractions import Fraction
from functools import cache
from itertools import combinations, groupby
from math import isqrt

import numpy as np
import pytest
from batches import RNG, resting_exactly
from oracle import relation
from test_batch_few import any_bounds, hulls, meeting
from test_batch_padded import colliding, padded, shapes_of
from test_batch_small import rule

import satviz as sv
from satviz import batch
from satviz.batch import broad_rule
from satviz.batch.with_numpy import few

BOX = np.array([(0.0, 0), (8, 0), (8, 8), (0, 8)])
UNIT = 2.0**16  # so that what is moved by 1 is still certain in floats


# -- scenes in whole numbers: outlines, or center and radius


def outline(rng, v):
    """Return an outline of v corners in multiples of UNIT."""
    return next(hulls(rng, [v], 2 * v)) * UNIT


def across(ring, k):
    """Return the outline turned by 180 degrees about the middle of its edge k: both touch all along that edge."""
    return ring[k] + ring[k - 1] - ring


def off(ring, other, by):
    """Return the other outline moved away from this one by one step, or into it, or not at all (by: 1, -1 or 0)."""
    return other + by * np.sign(other.mean(axis=0) - ring.mean(axis=0))


def beside_each_other(*corners):
    """Return outlines that touch another one along an edge, are a step away, or overlap it by a step."""

    def made(rng):
        found = []
        for k, v in enumerate(corners):
            ring = outline(rng, v)
            ring += [0, 6 * UNIT * v * k]
            found += [ring, *(off(ring, across(ring, edge), by) for edge, by in ((0, 0), (v // 2, 1), (1, -1)))]
        return found

    return made


def one_in_another(rng):
    """Return outlines inside a larger one, which has fewer or more corners, and one that has all of them inside."""
    ring = outline(rng, 5)
    inner = [(outline(rng, v) / 64).round() + ring.mean(axis=0).round() for v in (3, 8, 12)]
    return [ring, *inner, ring * 4 - 3 * ring.mean(axis=0).round(), across(ring, 2)]


def upright_boxes(rng):
    places = [(0, 0), (1, 0), (1, 1), (2, 1), (2.5, 1.5), (0, 3), (1, 4), (9, 9)]  # side to side, corner to corner
    return [BOX * UNIT + np.array(at) * 8 * UNIT for at in places]


def boxes_but(odd):
    """Return upright boxes and one outline beside them whose bounding box meets theirs."""

    def made(rng):
        ring = np.array(odd, float) * UNIT
        beside = [BOX * UNIT + np.array(at) * UNIT for at in ((-8, 7), (7, 7), (7, -7), (-7, -7), (8, 0))]
        return [*beside, ring] if rng.random() < 0.5 else [ring, *beside]

    return made


def coins(rng):
    """Return circles of which some touch, are a step away or overlap by a step: radii of Pythagorean triples."""
    some = [(0, 0, 2, 0), (3, 4, 3, 0), (6, 0, 2, 1), (-5, 12, 11, -1), (0, -9, 7, 0), (40, 40, 1, 0)]
    return [((x * UNIT, y * UNIT), r * UNIT + by) for x, y, r, by in some]


def coins_and_corners(rng):
    """Return circles that touch triangles, are a step away, or overlap them by a step, and some inside."""
    centers, radii, rings = resting_exactly(rng, 3, 5)
    found = []
    for k, by in enumerate((0, 1, -1)):
        at = np.array([2.0**14 * k, 0])
        found += [(tuple((centers[k] + at) * UNIT), radii[k] * UNIT + by), (rings[k] + at) * UNIT]
    inside = found[1].mean(axis=0).round()
    beside = [((x, x), 5 * UNIT) for x in (-200 * UNIT, -209 * UNIT)]  # apart, although their bounding boxes meet
    return [*found, (tuple(inside), UNIT), (tuple(inside + 2 * UNIT), UNIT * 2.0**9), across(found[1], 0), *beside]


def coins_among_outlines(rng):
    """Return circles and outlines of many kinds, of which nearly all overlap."""
    rings = [outline(rng, v) + rng.integers(0, 9, 2) * UNIT for v in (3, 5, 8, 9, 4)]
    some = [(tuple(rng.integers(0, 24, 2) * UNIT), float(r) * UNIT) for r in (1, 2, 5)]
    return [rings[0], some[0], *rings[1:4], *some[1:], rings[4]]


SCENES = {
    "triangles": beside_each_other(3, 3, 3),
    "four corners": beside_each_other(4, 4),
    "five corners": beside_each_other(5, 5),
    "eight corners": beside_each_other(8),
    "nine corners": beside_each_other(9),
    "mixed": beside_each_other(3, 8, 4),
    "many corners": beside_each_other(3, 16),
    "one in another": one_in_another,
    "upright boxes": upright_boxes,
    "upright boxes, and one on its corner": boxes_but([(4, 0), (8, 4), (4, 8), (0, 4)]),
    "upright boxes, and one with a slanted side": boxes_but([(0, 0), (8, 0), (4, 8), (0, 8)]),
    "upright boxes, and one with two": boxes_but([(0, 0), (4, 0), (8, 8), (4, 8)]),
    "upright boxes, and one with a corner cut": boxes_but([(0, 0), (8, 0), (8, 4), (4, 8), (0, 8)]),
    "circles": coins,
    "circles and triangles": coins_and_corners,
    "circles among outlines": coins_among_outlines,
}


def single(shape):
    return sv.Circle(*shape) if isinstance(shape, tuple) else sv.Polygon(shape)


@cache
def scene(kind):
    """Return (shapes, pairs that share a point, pairs that only touch)."""
    name, _, rest = kind.partition(", of which")
    shapes = SCENES[name](RNG([len(name), 5]))
    if rest:  # where circles touch, all pairs of the scene are left to others
        shapes = [(s[0], s[1] + (-2) ** (k + 1)) if isinstance(s, tuple) else s for k, s in enumerate(shapes)]
    return shapes, *pairs_of(shapes)


def pairs_of(shapes):
    known = list(map(single, shapes))
    relations = {(i, j): relation(known[i], known[j]) for i, j in combinations(range(len(known)), 2)}
    hits = [list(pair) for pair, found in relations.items() if found]
    return hits, {pair for pair, found in relations.items() if found is sv.Relation.TOUCHING}


def scaled(shapes, e):
    factor = 2.0**e
    return [(np.array(s[0]) * factor, s[1] * factor) if isinstance(s, tuple) else s * factor for s in shapes]


def corners_of(shape):
    return 1 if isinstance(shape, tuple) else len(shape)


def in_arrays(shapes):
    """Return a batch joined of arrays: those that follow each other and have as many corners are one of them."""
    made = []
    for v, alike in groupby(shapes, corners_of):
        some = list(alike)
        if v == 1:
            made.append(batch.Circles(np.array([s[0] for s in some]), np.array([s[1] for s in some])))
        else:
            made.append(batch.Polygons(np.array(some)))
    return batch.concat(made)


def in_rings(shapes):
    """Return a batch of outlines one after another, with their radii."""
    return in_arrays(shapes)[np.arange(len(shapes))]


FORMS = {
    "padded": lambda shapes: batch.from_padded(*padded(shapes, RNG(1))),
    "in arrays": in_arrays,
    "in rings": in_rings,
}
WAYS = {
    "as they are": {},
    "all boxes": {"MAX_WHOLE_CORNERS": 0},
    "swept": {"MAX_WHOLE_CORNERS": 0, "MAX_ALL_PAIRS": 1},
    "in small blocks": {"MAX_WHOLE_CORNERS": 0, "MAX_PRODUCTS": 3 * 16**2, "MAX_DISTANCES": 3 * 17},
}


@pytest.fixture
def exactly(monkeypatch):
    """Return the pairs that are decided exactly, in a list that grows."""
    found, real = [], few.relations
    monkeypatch.setattr(few, "relations", lambda a, i, b, j, out: found.extend(zip(i, j)) or real(a, i, b, j, out))
    return found


@pytest.fixture
def one_by_one(monkeypatch):
    """Return the pairs that have error bounds of their own, in a list that grows."""
    found, real = [], few._clearances
    monkeypatch.setattr(few, "_clearances", lambda columns, i, j: found.extend(zip(i, j)) or real(columns, i, j))
    return found


@pytest.mark.parametrize("kind", [*SCENES, *(f"{kind}, of which none touches" for kind in SCENES if "circles" in kind)])
def test_every_code_path_of_few_shapes_finds_the_pairs_and_leaves_only_touching_ones_undecided(
    kind, exactly, one_by_one, monkeypatch
):
    shapes, hits, touching = scene(kind)
    assert hits and (touching or "none touches" in kind)
    if kind == "upright boxes":
        touching = set()  # their sides tell
    only_circles = sum(map(corners_of, shapes)) == len(shapes)
    slow = len(shapes) * sum(map(corners_of, shapes)) > 300  # at the ends of float64 all signs are exact ones
    for e in (-1070, -500, -430, 0, 400, 486, 980):
        whole = e in (-430, 0, 400)  # no product loses bits or overflows
        for way, constants in WAYS.items() if whole or (e == -500 and not slow) else [*WAYS.items()][:1]:
            with monkeypatch.context() as patch:
                for name, value in constants.items():
                    patch.setattr(few, name, value)
                for form in FORMS if only_circles or (e == 0 and way == "as they are") else ["padded"]:
                    made = FORMS[form](scaled(shapes, e))
                    exactly.clear()
                    one_by_one.clear()
                    found = few.colliding_pairs(made)
                    if whole:
                        assert sorted(exactly) == sorted(touching), (way, form)
                        assert way != "as they are" or set(one_by_one) <= (set() if only_circles else touching), form
                        assert (found is None) == any(isinstance(shapes[k], tuple) for pair in touching for k in pair)
                    found = batch.colliding_pairs(made, engine="numpy") if found is None else found
                    assert found.tolist() == hits, (e, way, form)


# -- as near to contact as floats can be


def root(square):
    """Return the square root of a fraction, as a fraction off by less than 2**-120."""
    return Fraction(isqrt(int(square * 2**240)), 2**120)


def distance(p, q):
    """Return the distance of two points in the same way."""
    return root(sum((Fraction(c) - Fraction(d)) ** 2 for c, d in zip(p, q)))


def a_corner_on_an_edge(rng):
    a, b = (next(hulls(rng, [3, 4, 5], 8)) * rng.uniform(0.1, 1) for _ in "ab")
    a += rng.uniform(0, 2.0 ** rng.integers(1, 20), 2)
    at = rng.uniform(0.1, 0.9)
    foot = a[0] * at + a[1] * (1 - at)
    left = np.argmax((b - b[0]) @ [a[0, 1] - a[1, 1], a[1, 0] - a[0, 0]])  # its corner farthest to the edge's inside
    return [a, b - b[left] + foot]


def a_circle_on_an_edge(rng):
    ring = next(hulls(rng, [3, 4, 5], 8)) * rng.uniform(0.1, 1) + rng.uniform(-9, 9, 2)
    (x, y), (p, q) = ring[0], ring[1]
    out = np.array([q - y, x - p])
    center = ring[0] + (ring[1] - ring[0]) * rng.uniform(0.1, 0.9) + out * 2.0 ** rng.uniform(-16, 1)
    cx, cy, x, y, p, q = map(Fraction, (*center, x, y, p, q))
    square = ((p - x) * (cy - y) - (q - y) * (cx - x)) ** 2 / ((p - x) ** 2 + (q - y) ** 2)
    return [ring, (center, float(root(square)))]


def a_speck_on_an_edge(rng):
    ring = next(hulls(rng, [3, 4, 5], 8)) * rng.uniform(0.1, 1)
    ring += rng.uniform(-0.1, 0.1, 2) - ring[0]  # near 0, so that differences from the first corner are rounded
    return [ring, (ring[0] + (ring[1] - ring[0]) * rng.uniform(0.1, 0.9), 2.0**-90)]


def a_circle_on_a_corner(rng):
    ring = next(hulls(rng, [3, 4, 5], 8)) * rng.uniform(0.1, 1) + rng.uniform(-9, 9, 2)
    k = ring[:, 0].argmax()
    center = ring[k] + [rng.uniform(0.01, 9), rng.uniform(-0.1, 0.1)]
    return [ring, (center, float(distance(center, ring[k])))]


def a_large_circle_on_a_corner(rng):
    ring = next(hulls(rng, [3, 4, 5], 8)) * rng.uniform(0.1, 1)
    k = ring[:, 0].argmax()
    center = ring[k] + [rng.uniform(1, 2) * 2.0**24, rng.uniform(-0.1, 0.1)]
    return [ring, (center, float(distance(center, ring[k])))]


def two_coins(rng):
    one, other = rng.uniform(-9, 9, (2, 2))
    apart = distance(one, other)
    r = float(apart) * rng.uniform(0.1, 0.9)
    return [(one, r), (other, float(apart - Fraction(r)))]


NEAR = (
    a_corner_on_an_edge,
    a_circle_on_an_edge,
    a_speck_on_an_edge,
    a_circle_on_a_corner,
    a_large_circle_on_a_corner,
    two_coins,
)


@pytest.mark.parametrize("make", NEAR)
def test_every_code_path_of_few_shapes_is_right_within_the_last_bits_of_a_contact(make, monkeypatch):
    rng, found_any = RNG(len(make.__name__)), []
    for k in range(60):
        shapes = make(rng)
        if isinstance(shapes[1], tuple):
            shapes[1] = (shapes[1][0], float(np.nextafter(shapes[1][1], rng.choice([0, shapes[1][1], 99]))))
        if rng.random() < 0.5:
            shapes = shapes[::-1]
        made = FORMS[["padded", "in arrays"][k % 2]](shapes)
        hits = colliding(shapes_of(made))
        found_any.append(len(hits))
        for limit in 200, 0:
            monkeypatch.setattr(few, "MAX_WHOLE_CORNERS", limit)
            assert batch.colliding_pairs(made, engine="numpy").tolist() == hits
    assert 0 < sum(found_any) < 60


# -- which way, and how much at a time


def spread(v, n, apart=3.0):
    """Return n circles (v: 1) or regular outlines in a row that goes up, each as wide as 2 at most."""
    at = np.arange(n)[:, None] * [apart, 1.0]
    if v == 1:
        return batch.Circles(at, 1.0)
    turns = 0.1 + 2 * np.pi * np.arange(v) / v
    return batch.Polygons(np.stack([np.cos(turns), np.sin(turns)], axis=1) + at[:, None])


def in_columns(made):
    """Return the same shapes from padded arrays, as `few` evaluates them."""
    count = made.count.max()
    corners = np.stack(made.rings[:2], axis=1).reshape(len(made), count, 2)
    return batch.from_padded(corners, np.full(len(made), count, np.intp), made.radius.copy())


# (corners, shapes) up to which blocks of pairs take longer
TAKEN = [(1, 4096), (3, 4096), (8, 4096), (9, 65536 // 81), (16, 256), (64, 16)]
LEFT = [(1, 4097), (8, 4097), (9, 65536 // 81 + 1), (16, 257), (64, 17), (65, 2), (100, 2)]


@pytest.mark.parametrize(("v", "n"), TAKEN + LEFT)
def test_shapes_are_few_up_to_a_number_that_follows_from_their_corners(v, n):
    made = spread(v, n)
    forms = [made, made[np.arange(n)], batch.concat([made, made[:0]])]
    if n * v <= 2**12:
        forms.append(in_columns(made))
    for form in forms:
        found = few.colliding_pairs(form)
        assert (found is None) == ((v, n) in LEFT) and (found is None or not len(found))


def test_one_shape_or_none_has_no_pairs():
    for v in 1, 3, 4, 9:
        for n in 0, 1:
            made = spread(v, 3)[:n]
            for form in made, made[:n], batch.concat([made]), batch.concat([spread(v, 1)[:n], made[:0]]):
                found = batch.colliding_pairs(form, engine="numpy")
                assert found.shape == (0, 2) and found.dtype == np.int64


@pytest.mark.parametrize(
    ("v", "n", "way"),
    [
        (1, 2, "_clearances_of_all"),
        (1, 128, "_clearances_of_all"),
        (1, 129, "_clearances"),
        (3, 50, "_clearances_of_all"),
        (3, 51, "_clearances"),
        (9, 20, "_clearances_of_all"),
        (9, 21, "_clearances"),
        (4, 3, None),
        (4, 200, None),
    ],
)
def test_all_pairs_are_evaluated_where_that_is_quicker_than_comparing_boxes_and_none_of_upright_boxes(
    v, n, way, monkeypatch
):
    taken = []
    for name in "_clearances_of_all", "_clearances", "relations":
        real = getattr(few, name)
        monkeypatch.setattr(few, name, lambda *args, name=name, real=real: taken.append(name) or real(*args))
    made = boxes(n) if way is None else spread(v, n, 0.5)
    found = batch.colliding_pairs(made, engine="numpy")
    assert taken == [way][: way is not None] and len(found)


def boxes(n):
    """Return unit boxes, each of which touches the next one."""
    return batch.Polygons(np.roll(BOX, 1, axis=0) / 8 + np.arange(1, n + 1)[:, None, None] * [1.0, 0.5])


@pytest.mark.parametrize("name, per_pair", [("MAX_PRODUCTS", 64), ("MAX_DISTANCES", 9)])
def test_pairs_are_evaluated_in_blocks_that_bound_the_memory(name, per_pair, monkeypatch):
    """Pairs of 8-gons use products of normals and corners; 8-gons and circles use distances."""
    outlines, found, peaks = spread(8, 100, 0.01), [], []
    made = outlines if name == "MAX_PRODUCTS" else batch.concat([outlines, spread(1, 100, 0.01)])
    columns, (i, j) = few._columns_of(made), np.divmod(np.arange(10_000), 100)
    for at_once in 500, 10_000:
        monkeypatch.setattr(few, name, at_once * per_pair)
        tracemalloc.start()
        found.append(few._clearances(columns, i, j + len(made) - 100).tolist())
        peaks.append(tracemalloc.get_traced_memory()[1])
        tracemalloc.stop()
    assert found[0] == found[1] and peaks[0] < peaks[1] / 8


def test_boxes_are_swept_along_the_axis_that_the_rule_says(monkeypatch):
    rng = RNG(1)
    for k in range(60):
        limits = 1, 40, int(rng.integers(0, 5)), 0
        for name, value in zip(("MAX_ALL_PAIRS", "MAX_SWEEP_NUMPY", "MAX_SWEEP_COMPARISONS"), limits):
            monkeypatch.setattr(few, name, value)
        bounds = any_bounds(rng, 2 + k % 40)
        if k % 4 == 0:  # one box is larger than the others, along one axis
            bounds = np.hstack([bounds[:, :2], bounds[:, :2] + 2.0 ** rng.integers(-3, 3, 2)])
            bounds[0, 2 + k // 4 % 2] += 20
        pairs, *found = few.candidate_pairs(bounds)
        with np.errstate(over="ignore"):
            _, comparisons, _ = rule(bounds, limits, np.inf)
        if len(bounds) > 40:
            assert found == [broad_rule.GRID, -1]
        else:
            assert found == [
                broad_rule.GRID if comparisons > limits[2] * len(bounds) else broad_rule.SWEEP,
                comparisons,
            ]
        assert (pairs is None) == (found[0] == broad_rule.GRID)
        assert pairs is None or sorted(map(tuple, pairs.tolist())) == list(map(tuple, meeting(bounds).tolist()))


@pytest.mark.parametrize("axis", [0, 1])
def test_one_long_box_decides_along_which_axis_boxes_are_swept(axis):
    low = np.arange(150.0)[:, None] * [8, 8]
    low[:, 1 - axis] *= 1.25  # of boxes that are alike the sweep would be along the other axis
    bounds = np.hstack([low, low + 1])
    bounds[0, 3 - axis] = bounds.max()
    pairs, *found = few.candidate_pairs(bounds)
    assert len(pairs) == 0 and found == [broad_rule.SWEEP, 0]


@pytest.mark.parametrize("v", [8, 9, 64])
def test_the_last_corners_count_as_the_first_ones_do(v):
    turns = 0.1 + 2 * np.pi * np.arange(v) / v
    ring = np.rint(np.stack([np.cos(turns), np.sin(turns)], axis=1) * 2.0**12) * UNIT
    for k in 0, 1, v - 2, v - 1:
        for by in 0, -1, 1:
            # the second meets the first at a corner, and the third along an edge
            shapes = [ring, off(ring, 2 * ring[k] - ring, by), off(ring, across(ring, k), by), outline(RNG(k), 3)]
            hits, _ = pairs_of(shapes)
            assert ([0, 1] in hits) == ([0, 2] in hits) == (by <= 0)
            for form in FORMS.values():
                assert batch.colliding_pairs(form(shapes), engine="numpy").tolist() == hits


@pytest.mark.parametrize(("last", "comparisons"), [(0.5, 3), (1.125, 0)])
def test_boxes_are_swept_along_the_other_axis_if_there_are_too_many_comparisons_and_not_if_just_as_many(
    last, comparisons, monkeypatch
):
    """One comparison a box is allowed; three boxes make three, four boxes make five; along y none meet."""
    monkeypatch.setattr(few, "MAX_ALL_PAIRS", 1)
    monkeypatch.setattr(few, "MAX_SWEEP_COMPARISONS", 1)
    x = [0, 0.25, last] if last < 1 else [0, 0.25, 0.5, last]
    bounds = np.array([(left, 2 * k, left + 1, 2 * k + 1) for k, left in enumerate(x)])
    bounds[-1, 3] = 100  # so that the sweep is along x at first
    pairs, *found = few.candidate_pairs(bounds)
    assert len(pairs) == 0 and found == [broad_rule.SWEEP, comparisons]


@pytest.mark.parametrize("e", [*range(-544, -528, 4), *range(-520, -440, 8)])
def test_a_circle_beside_an_edge_is_told_from_one_on_it_where_products_lose_bits_or_vanish(e, monkeypatch):
    monkeypatch.setattr(few, "MAX_WHOLE_CORNERS", 0)
    long = 2.0**20
    for ring in outline(RNG(-e), 3) / UNIT, np.array([(0, 0), (1, 1), (1, 2 * long + 1), (-2 * long, 0)]):
        ring *= 2.0**e
        for k in range(len(ring)):
            (x, y), (p, q) = ring[k - 1], ring[k]
            for by in -(2.0**-20), 2.0**-20, 2.0**-10, 0.125:
                center = ring[k - 1] * 0.7 + ring[k] * 0.3 + by * np.array([q - y, x - p])
                apart = np.hypot(x - p, y - q) * by
                for radius in (2.0 ** (e - 200), apart * (1 + 2.0**-20), apart * (1 - 2.0**-20)):
                    if radius >= 5e-324:
                        made = FORMS["in arrays"]([ring, (center, radius)])
                        assert batch.colliding_pairs(made, engine="numpy").tolist() == colliding(shapes_of(made))


def test_a_center_is_not_taken_for_one_inside_where_products_are_a_few_units_of_the_smallest_float(monkeypatch):
    monkeypatch.setattr(few, "MAX_WHOLE_CORNERS", 0)
    rng, found = RNG(4), []
    for _ in range(100):
        ring = next(hulls(rng, [3], 4)) * rng.uniform(0.2, 1) * 2.0**-538
        made = FORMS["in arrays"]([ring, (ring.mean(axis=0) + rng.uniform(-1, 1, 2) * 2.0**-537, 2.0**-700)])
        found.append(colliding(shapes_of(made)))
        assert batch.colliding_pairs(made, engine="numpy").tolist() == found[-1]
    assert [] in found and [[0, 1]] in found


@pytest.mark.parametrize(
    "corner, end, center",
    [
        ("0x1.aep-586 -0x1.95p-585", "0x1.0fc10c8623142p-537 0x1.4507b895aafabp-537",
         "0x1.9342d36c3fb13p-539 0x1.e251825170260p-539"),
        ("0x1.22p-585 0x1.9ap-585", "0x1.a09b0138f6083p-537 0x1.e7f64650b0750p-537",
         "0x1.0c9c6f6319ecap-539 0x1.3a9e767e8b092p-539"),
    ],
)  # fmt: skip
def test_a_center_is_not_taken_for_one_inside_where_products_round_to_the_other_side(corner, end, center):
    corner, end, center = ([*map(float.fromhex, words.split())] for words in (corner, end, center))
    triangle = [corner, end, (-(2.0**-526), 2.0**-526)]
    for radius, pairs in (2.0**-1000, 0), (2.0**-600, 0), (2.0**-580, 1):
        assert (sv.relate(sv.Polygon(triangle), sv.Circle(center, radius)) is not sv.Relation.APART) is bool(pairs)
        both = batch.concat([batch.Polygons([triangle]), batch.Circles([center], [radius])])
        assert len(batch.colliding_pairs(both)) == pairs
        found = few.colliding_pairs(both)
        assert found is None or len(found) == pairs
