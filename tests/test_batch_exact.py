"""Tests of exact evaluation: signs, circles and polygons that the float filters leave undecided."""

import warnings
from decimal import Decimal, localcontext
from fractions import Fraction
from itertools import pairwise, product
from random import Random

import numpy as np
import pytest
from batches import (
    ENGINES,
    RNG,
    TRIPLES,
    a_float_off,
    as_python,
    batches_from,
    batches_of,
    beside_mirror,
    circles,
    jolt,
    kernels_of,
    moved,
    ngons,
    one_by_one,
    regular,
    resting_exactly,
    resting_on_boxes,
    scalar,
    turned,
)
from hypothesis import given, settings
from hypothesis import strategies as st
from speeds import one_in
from strategies import CONVEX, SIZES, edge_facing, many_corners, nearly_straight, pairs, vertex_facing

import satviz as sv
from satviz import batch
from satviz.batch import exact_signs
from satviz.batch.codes import UNDECIDED
from satviz.batch.with_numpy import circle_polygons, gjk
from satviz.batch.with_numpy import exact as exact_numpy
from satviz.batch.with_numpy import filter as filter_numpy
from satviz.engine.relate import ERROR_FACTOR_F64
from satviz.study import truth as oracle


@pytest.mark.parametrize(("v", "w"), [(3, 3), (3, 4), (8, 8), (9, 9), (17, 3), (40, 16)])
def test_numba_classifies_touching_pairs_without_the_numpy_engine(v, w, monkeypatch):
    pytest.importorskip("numba", reason="needs numba: python -m pip install '.[fast]'")
    a, touching = beside_mirror(v, w)
    left = []
    real = exact_numpy.relations
    monkeypatch.setattr(exact_numpy, "relations", lambda *c: left.extend(c[1]) or real(*c))
    for move in (0, 1, -1, -(2.0**39)):
        p, q = batch.Polygons(a), batch.Polygons(touching + np.array([move, 0.0]))
        for picked in None, np.repeat(np.arange(60)[:, None], 2, axis=1):
            assert batch.relate(p, q, picked, engine="numba").tolist() == one_by_one(p, q), move
    assert not left


def corner_on_edge(rng):
    """Return two outlines and a point: a corner of the second outline on the most diagonal edge of the first.

    All products round, and an error bound computed in a wrong way is the smallest for such an edge.
    """
    rings, slant = [[], []], 1
    while slant > 0.03 or not all(8 < len(ring) < 20 for ring in rings):
        rings = [many_corners(rng, 16) for _ in rings]
        normals = [(q[1] - p[1], p[0] - q[0]) for p, q in pairwise([*rings[0], rings[0][0]])]
        slant, nx, ny = min((abs(abs(x) - abs(y)) / (abs(x) + abs(y)), x, y) for x, y in normals)
    first, second = edge_facing(rng, rings[0], nx, ny).ring, vertex_facing(rings[1], -nx, -ny).ring
    if rng.random() < 0.5:  # the edge that leads from the last corner to the first
        ends = [nx * x + ny * y == 0 for x, y in first]
        end = next(k for k in range(len(first)) if ends[k] and ends[k - 1])
        first = first[end:] + first[:end]
    large, at = 2**34 + rng.randrange(1, 2**20, 2), np.array([rng.randrange(2**50), rng.randrange(2**50)])
    size = 2.0 ** rng.choice((-90, 90))
    return *((np.array(ring) * large + at) * size for ring in (first, second)), at * size


def as_rows(first, second, point):
    """Return kernel arguments: (x, y, first, end) of each outline, the sum of both largest coordinates, the point."""
    x, y = np.concatenate([second[:3], first, second, first]).T.copy()  # between others, as in a batch
    n, end = 3 + len(first), 3 + len(first) + len(second)
    return (x, y, 3, n), (x, y, n, end), float(np.abs(first).max() + np.abs(second).max()), point


def flat_corners(rng, size):
    """Return two outlines and the corner they share, at which both turn by less than the error bound.

    So rounding can select another corner as the lowest one, and that corner may lie beyond the shared point.
    """
    along = np.array([rng.choice((-1, 1)), rng.choice((-1, 1)) * rng.uniform(0.999, 1.001)]) / 2**0.5
    beyond = np.array([-along[1], along[0]])
    shared = np.array([rng.choice((-1, 1)) * rng.randrange(2**52, 2**53 - 2**50) for _ in "xy"])
    rings = []
    for side in 1, -1:
        at = [(rng.random(), side * rng.random() / 2**40), (rng.uniform(-2, 2), side * rng.uniform(0.1, 2))]
        at.append((-rng.random(), side * rng.random() / 2**40))
        ring = [shared] + [shared + np.round(u * 2**40 * along) + np.round(v * 2**40 * beyond) for u, v in at[::side]]
        start = rng.randrange(4)
        rings.append(np.array(ring[start:] + ring[:start]))
    try:
        polygons = [sv.Polygon(ring) for ring in rings]
    except sv.InvalidShape:
        return flat_corners(rng, size)
    if not all(p.is_convex and len(p.core) == 4 for p in polygons) or sv.relate(*polygons) != 1:
        return flat_corners(rng, size)
    return *(np.array(p.core) * size for p in polygons), shared * size


@pytest.mark.parametrize("size", [1.0, 2.0**-90, 2.0**90, 2.0**-577])  # at 2**-577 products of an orientation underflow
def test_gjk_of_numba_leaves_shapes_that_share_a_nearly_straight_corner_undecided(size):
    gjk_numba = kernels_of("exact")._gjk
    rng = Random(3)
    for _ in range(60):
        one, other, max_coordinate, _ = as_rows(*flat_corners(rng, size))
        assert gjk_numba(*one, *other, max_coordinate)[0] == gjk_numba(*other, *one, max_coordinate)[0] == UNDECIDED


def standing_on_edges():
    """Yield pairs of outlines: a narrow triangle that stands on a long edge of a flat one.

    GJK finds the ends of that edge first; a corner on its left proves nothing about the line through it.
    """
    rng = Random(5)
    for _ in range(100):
        long, lean = rng.randrange(50, 5000), rng.choice((-1, 1))
        flat = [
            (-rng.randrange(1, long), 0),
            (rng.randrange(-long, long), -rng.randrange(1, 9)),
            (rng.randrange(1, long), 0),
        ]
        tall = [(lean * rng.randrange(max(2, long // 20)), rng.randrange(1, 3 * long)) for _ in range(2)]
        turned = complex(rng.randrange(1, 2000), rng.randrange(-2000, 2000))
        at = complex(rng.randrange(-100_000, 100_000), rng.randrange(-100_000, 100_000))
        rings = [[complex(*point) * turned + at for point in ring] for ring in (flat, [(0, 0), *tall])]
        yield [np.array([(z.real, z.imag) for z in ring[k:] + ring[:k]]) for ring in rings for k in [rng.randrange(3)]]


def test_gjk_of_numba_leaves_touching_shapes_undecided_where_it_finds_both_ends_of_the_edge_first():
    gjk_numba = kernels_of("exact")._gjk
    for rings in standing_on_edges():
        one, other, max_coordinate, _ = as_rows(*rings, None)
        for these in (one, other), (other, one):
            assert gjk_numba(*these[0], *these[1], max_coordinate)[0] == UNDECIDED


def test_gjk_of_numpy_leaves_touching_shapes_undecided_where_it_finds_both_ends_of_the_edge_first():
    one, other = (np.array(rings).transpose(2, 1, 0).copy() for rings in zip(*standing_on_edges()))
    factor = np.full(100, (np.abs(one).max() + np.abs(other).max()) * ERROR_FACTOR_F64)
    for p, q in (one, other), (other, one):
        out = np.zeros(100, np.int8)
        gjk.gjk(*p, *q, factor, out)
        assert (out == UNDECIDED).all()


ROUNDED = [  # found by random search: touching triangles whose corners are so far apart that differences are rounded
    (
        [
            (-459940604306739, 4433704032951140),
            (-4114470215126679, -8168429283312487),
            (940296430833664, 4027645187304480),
        ],
        [
            (-8497241818748311, -2343482795304638),
            (-1272058295600059, 1633229962670334),
            (-5248771053575031, 8858413485818586),
        ],
    ),
    (
        [
            (7010272725071316, -11765230323355440),
            (1704180389594424, 1319257849863516),
            (1734304167173303, -5016960944890531),
        ],
        [
            (3030703473463647, -1951864193441223),
            (6713876100479248, 4620503670747134),
            (2352380042739596, 2851806225588170),
        ],
    ),
    (
        [
            (-5155920299005934, 4466112899482660),
            (7539758868357489, -5731370133296107),
            (4323018607169719, 4447503945442647),
        ],
        [
            (-2847614995848948, 2612025075341066),
            (-4928811559498238, 2384916335833370),
            (-7482834556202933, -3158738182551399),
        ],
    ),
]


@pytest.mark.parametrize("rings", ROUNDED)
def test_gjk_of_numba_leaves_touching_triangles_undecided_where_rounding_can_hide_an_orientation(rings):
    gjk_numba = kernels_of("exact")._gjk
    one, other, max_coordinate, _ = as_rows(*(np.array(ring, float) for ring in rings), None)
    assert sv.relate(*(sv.Polygon(ring) for ring in rings)) == 1
    assert gjk_numba(*one, *other, max_coordinate)[0] == gjk_numba(*other, *one, max_coordinate)[0] == UNDECIDED


@pytest.mark.parametrize(
    ("ring", "point"),
    [  # found by random search
        (
            [
                (8660339316690704, 2837116945160626),
                (-666423947225527, 750505952779784),
                (6834032253248210, 700250253321093),
            ],
            (4271274251318360, 1855182360510818),
        ),
        (
            [
                (6260228183444929, 1145635108668575),
                (-3305976233469562, -1518501441802149),
                (1509194851016166, -1390225937688219),
            ],
            (1758484928426345, -108076209200001),
        ),
    ],
)
def test_numba_certifies_no_point_of_an_edge_as_inside_where_differences_are_rounded(ring, point):
    is_certainly_inside = kernels_of("exact").is_certainly_inside
    triangle, at = sv.Polygon(ring), np.array(point, float)
    assert 0 in [oracle.orientation(p, q, point) for p, q in pairwise([*triangle.core, triangle.core[0]])]
    row, _, max_coordinate, _ = as_rows(np.array(triangle.core), np.array(triangle.core), None)
    assert not is_certainly_inside(*row, *at, max_coordinate)
    assert is_certainly_inside(*row, *np.array(triangle.core).mean(axis=0), max_coordinate)


@pytest.mark.parametrize(("e", "certified"), [(-480, False), (-460, True), (480, True), (484, False), (510, False)])
def test_numba_certifies_no_inside_point_where_products_leave_the_range_of_floats(e, certified):
    row, _, max_coordinate, _ = as_rows(*[np.array([(-1.0, -1), (1, -1), (0, 1)]) * 2.0**e] * 2, None)
    assert bool(kernels_of("exact").is_certainly_inside(*row, 0.0, 0.0, max_coordinate)) is certified


def test_orientations_of_numba_are_exact_or_unknown():
    """Each triple is also evaluated in other orders; where products leave the float range, it may be unknown."""
    exact_numba = kernels_of("exact")
    rng, terms = Random(6), np.empty(exact_numba.MAX_TERMS)
    seen = {(sign, size): 0 for sign in (-2, -1, 0, 1) for size in SIZES}
    for _ in range(60):
        for size in SIZES:
            p, q, r = nearly_straight(rng, size)
            for x, y, z in (
                (p, q, r),
                (q, r, p),
                (p, r, q),
                (p, q, p),
                (p, q, q),
                (p, q, (p[0], r[1])),
                (p, q, (r[0], q[1])),
            ):
                sign = exact_numba.orient(*x, *y, *z, terms)
                seen[sign, size] += 1
                exact = oracle.orientation(x, y, z)
                assert sign in (-2, (exact > 0) - (exact < 0)), (x, y, z)
    for size in SIZES:
        assert min(seen[sign, size] for sign in (-1, 0, 1)) > 5 or seen[-2, size] > 100
        assert not seen[-2, size] or not 2.0**-400 < size < 2.0**450


@pytest.mark.parametrize("scale", [1e-130, 1.0, 1e140])
def test_orientations_of_numba_evaluate_no_later_stage_than_necessary(scale, monkeypatch):
    """Random points need two products only, and nearly collinear points need no exact sum."""
    exact_numba = kernels_of("exact")
    as_python(monkeypatch, exact_numba, "sign_of_sum", "_two_diff_tail")
    orient, terms = exact_numba.orient, np.empty(exact_numba.MAX_TERMS)
    monkeypatch.setattr(exact_numba, "sign_of_sum", lambda *_: pytest.fail("an exact sum is evaluated"))
    for points in np.transpose([c * scale for c in nearly_collinear(RNG(2), 1000, 1000)]).tolist():
        if abs(exact := oracle.orientation(points[:2], points[2:4], points[4:])) > 1e-24 * scale**2:
            assert orient(*points, terms) == (1 if exact > 0 else -1)
    monkeypatch.setattr(exact_numba, "_two_diff_tail", lambda *_: pytest.fail("rounding errors are evaluated"))
    for points in RNG(1).uniform(-scale, scale, (1000, 6)).tolist():
        exact = oracle.orientation(points[:2], points[2:4], points[4:])
        assert orient(*points, terms) == (1 if exact > 0 else -1)
        assert orient(*points[:4], *points[:2], terms) == orient(*points[:4], *points[2:4], terms) == 0


@pytest.mark.parametrize("scale", [2.0**-400, 1.0, 2.0**460])
def test_orientations_of_numba_sum_four_terms_where_collinear_points_have_exact_differences(scale, monkeypatch):
    exact_numba = kernels_of("exact")
    as_python(monkeypatch, exact_numba, "sign_of_sum")
    orient, real, sums = exact_numba.orient, exact_numba.sign_of_sum, []
    monkeypatch.setattr(exact_numba, "sign_of_sum", lambda terms, count: sums.append(count) or real(terms, count))
    for px, py, dx, dy in RNG(3).integers(-(2**20), 2**20, (50, 4)):
        points = np.array([px, py, px + dx, py + dy, px - 3 * dx, py - 3 * dy]) * scale
        assert orient(*points, np.empty(exact_numba.MAX_TERMS)) == 0
    assert sums == [4] * 50


@pytest.mark.parametrize("steps", [1, 2, 3])
def test_gjk_of_numba_is_right_or_undecided_when_it_runs_out_of_steps(monkeypatch, steps):
    exact_numba = kernels_of("exact")
    as_python(monkeypatch, exact_numba, "MAX_STEPS")
    monkeypatch.setattr(exact_numba, "MAX_STEPS", steps)
    rng, seen = RNG(4), []
    for _ in range(40):
        a, b = ngons(rng, 2, 16, 0.3) * 2.0**50 + [[[0]], [[rng.uniform(0, 2) * 2**50]]]
        one, other, max_coordinate, _ = as_rows(a, b, None)
        seen.append(exact_numba._gjk(*one, *other, max_coordinate)[0])
        assert seen[-1] in (UNDECIDED, sv.relate(sv.Polygon(a), sv.Polygon(b)))
    assert UNDECIDED in seen


@pytest.mark.parametrize("size", [1.0, 2.0**-130])
def test_gjk_of_numba_classifies_ordinary_pairs(size):
    """Pairs with a thin shape, which take many steps, are among them."""
    gjk_numba = kernels_of("exact")._gjk
    rng = RNG(4)
    for n in range(200):
        (a, b), angle = ngons(rng, 2, 16, 0.3), rng.uniform(0, 2 * np.pi)
        b = b * (1, 0.02 if n % 2 else 1) + np.array([np.cos(angle), np.sin(angle)]) * rng.uniform(0, 2.2)
        a, b = (np.round(ring * 2.0**50) * size for ring in (a, b))
        one, other, max_coordinate, _ = as_rows(a, b, None)
        assert gjk_numba(*one, *other, max_coordinate)[0] == sv.relate(sv.Polygon(a), sv.Polygon(b)), n


def test_numba_classifies_a_corner_on_an_edge_as_touching_and_as_not_inside():
    is_certainly_inside = kernels_of("exact").is_certainly_inside
    rng = Random(2)
    for _ in range(40):
        first, second, point = corner_on_edge(rng)
        both = batch.Polygons([first, second])
        assert batch.relate(both, both, [(0, 1), (1, 0)], engine="numba").tolist() == [1, 1]
        one, other, max_coordinate, _ = as_rows(first, second, point)
        for row in one, other:
            assert not is_certainly_inside(*row, *point, max_coordinate)
            assert is_certainly_inside(*row, *(c[row[2] : row[3]].mean() for c in row[:2]), max_coordinate)


def test_numba_evaluates_every_edge_from_whichever_corners_gjk_ends_at(monkeypatch):
    exact_numba = kernels_of("exact")
    as_python(monkeypatch, exact_numba, "_gjk")
    rng, terms = Random(1), np.empty(exact_numba.MAX_TERMS)
    for _ in range(100):
        one, other, max_coordinate, _ = as_rows(*corner_on_edge(rng))
        for i, j in product(*(rng.sample(range(*row[2:]), 2) for row in (one, other))):
            for these, ends in (((one, other), (i, j)), ((other, one), (j, i))):
                monkeypatch.setattr(exact_numba, "_gjk", lambda *_, ends=ends: (UNDECIDED, *ends))
                assert exact_numba.relate_many_corners(*these[0], *these[1], max_coordinate, terms) == 1, ends


class Counted(list):
    """A list that counts how often an element of any such list is read."""

    reads = 0

    def __getitem__(self, i):
        Counted.reads += 1
        return super().__getitem__(i)


@pytest.mark.parametrize(("v", "w"), [(9, 9), (64, 64), (200, 30), (30, 200)])
def test_numba_evaluates_few_corners_for_each_edge_of_overlapping_shapes(v, w, monkeypatch):
    """It reads about twenty coordinates for each edge of any outline: each walk begins where the one before ended."""
    exact_numba = kernels_of("exact")
    as_python(monkeypatch, exact_numba, "_gjk", "_classify_edges", "_walk_down_onward")
    monkeypatch.setattr(exact_numba, "_classify_edges", lambda *_: pytest.fail("all corners are evaluated"))
    rng, terms = RNG(4), np.empty(exact_numba.MAX_TERMS)
    for n in range(3):
        rings = ngons(rng, 1, v, 0.3)[0], ngons(rng, 1, w, 0.3)[0] + 0.4
        one, other, max_coordinate, _ = as_rows(*rings, None)
        ends = [row[2] + (1 + n) * (row[3] - row[2]) // 4 for row in (one, other)]
        monkeypatch.setattr(exact_numba, "_gjk", lambda *_, ends=ends: (UNDECIDED, *ends))
        Counted.reads, rows = 0, [[Counted(row[0]), Counted(row[1]), *row[2:]] for row in (one, other)]
        assert exact_numba.relate_many_corners(*rows[0], *rows[1], max_coordinate, terms) == 2
        assert Counted.reads < 24 * (v + w)


@given(st.lists(st.tuples(*[st.integers(-3, 3)] * 6), min_size=1, max_size=20), st.integers(-60, 60))
@settings(max_examples=80, deadline=None)
def test_orientations_are_exact(points, e):
    cols = np.array(points, dtype=float).T * 2.0**e
    nudged = np.nextafter(cols, np.inf)
    for c in (cols, nudged, np.where(cols == 0, 1e-300, cols)):
        found = exact_signs.orient(*c)
        for i, value in enumerate(found):
            px, py, qx, qy, rx, ry = map(Fraction, c[:, i])
            det = (qx - px) * (ry - py) - (qy - py) * (rx - px)
            assert value == (det > 0) - (det < 0)


def nearly_collinear(rng, n, far):
    """Return the coordinates of n triples of nearly collinear points; the second ones reach as far as `far`."""
    p, q = rng.uniform(-1, 1, (2, n, 2)) * [[[1]], [[far]]]
    return *p.T, *q.T, *(p + rng.uniform(-1, 2, (n, 1)) * (q - p)).T


@pytest.mark.parametrize("scale", [1e-130, 1.0, 1e140])
def test_orientations_of_random_points_are_certified_by_the_float_filter(scale, monkeypatch):
    left = []
    real = exact_signs._orient_adaptive
    monkeypatch.setattr(exact_signs, "_orient_adaptive", lambda *c: left.extend(c[0]) or real(*c))
    exact_signs.orient(*RNG(1).uniform(-scale, scale, (6, 1000)))
    assert not left


@pytest.mark.parametrize("scale", [1e-130, 1.0, 1e140])
def test_orientations_of_nearly_collinear_points_hardly_need_exact_sums(scale, monkeypatch):
    left = []
    real = exact_signs.sign_of_products
    monkeypatch.setattr(exact_signs, "sign_of_products", lambda pairs: left.extend(pairs[0][0]) or real(pairs))
    exact_signs.orient(*(c * scale for c in nearly_collinear(RNG(2), 1000, 1000)))
    assert len(left) <= 5


def test_orientations_with_rounding_errors_added_are_within_their_error_bound(monkeypatch):
    """ERRBOUND_C is 32 * 2**-106; the proof needs 12 of these. The test prints the largest error found."""
    seen = []
    real = exact_signs.certified_sign
    monkeypatch.setattr(exact_signs, "certified_sign", lambda *c: seen.append(c) or real(*c))
    worst = 0
    for far in (3, 1e3, 1e9):
        points = nearly_collinear(RNG(3), 500, far)
        seen.clear()
        exact_signs._orient_adaptive(*points)
        dets, error_bounds = seen[0]
        for det, error_bound, *at in zip(*(map(Fraction, c.tolist()) for c in (dets, error_bounds, *points))):
            px, py, qx, qy, rx, ry = at
            exact = (qx - px) * (ry - py) - (qy - py) * (rx - px)
            worst = max(worst, (abs(det - exact) - abs(exact) / 2**53) / error_bound * 32)
    print(f"worst {float(worst):.1f} of 32")
    assert 0 < worst < 12


def test_a_product_and_its_rounding_error_sum_to_the_exact_product():
    rng = RNG(4)
    a, b = rng.integers(2**52, 2**53, (2, 5000)) * 2.0 ** rng.integers(-200, 200, (2, 5000))
    a[:100] = -b[:100]
    b[200:300] = np.nextafter(2.0 ** rng.integers(-9, 9, 100), 0)
    a[250:350] = np.nextafter(2.0 ** rng.integers(-9, 9, 100), 9e9)
    error, product = np.empty((2, 5000))
    exact_signs.two_product(a, b, error, product)
    assert np.array_equal(product, a * b)
    for x, y, *terms in zip(*(c.tolist() for c in (a, b, error, product))):
        assert Fraction(x) * Fraction(y) == sum(map(Fraction, terms))


def test_orientations_beyond_float64_are_exact_and_warn_of_nothing():
    columns = RNG(5).choice([-1.7e308, 1.7e308, 1e-320, 0, 1], (6, 300))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found = exact_signs.orient(*columns)
    for value, *at in zip(found, *columns):
        px, py, qx, qy, rx, ry = map(Fraction, at)
        det = (qx - px) * (ry - py) - (qy - py) * (rx - px)
        assert value == (det > 0) - (det < 0)


@pytest.mark.parametrize("swap", [[0, 1, 2, 3, 4, 5], [1, 0, 3, 2, 5, 4], [0, 1, 4, 5, 2, 3], [1, 0, 5, 4, 3, 2]])
@pytest.mark.parametrize("engine", ENGINES)
def test_an_orientation_is_exact_where_only_one_difference_is_rounded(swap, engine):
    """Three collinear points, and the last one a float off: far - near is the product of two odd numbers."""
    rng = RNG(6)
    if engine == "numba":
        exact_numba = kernels_of("exact")
    for f, g in rng.integers(2**33, 2**36, (60, 2)).tolist():
        far = float(f * g)
        near = float(int(far) - f * g)
        if float(g + near) - near == g:
            for off in (0, 1, -1):
                columns = np.array([near, 0, far, f, g + near + off, 1], float)[swap]
                px, py, qx, qy, rx, ry = map(Fraction, columns)
                det = (qx - px) * (ry - py) - (qy - py) * (rx - px)
                if engine == "numba":
                    sign = exact_numba.orient(*columns, np.empty(exact_numba.MAX_TERMS))
                else:
                    (sign,) = exact_signs.orient(*columns[:, None])
                assert sign == (det > 0) - (det < 0) and (det == 0) == (off == 0)


def test_signs_of_products_are_exact_at_every_scale():
    some = [0, 1, -1, 3e-200, -1e-170, 5e-324, -5e-324, 1e-154, 2e150, -1e200, 1.7e308, 1 + 2.0**-52]
    factors = RNG(7).choice(some, (2, 2, 600))
    a, b = factors[0]
    for sums in (factors, [(a, b), (-a, b)], [(a, b), (a, -b), (b, b)], [(a, b), (b, -np.nextafter(a, 9))]):
        exact = [sum(Fraction(p[i]) * Fraction(q[i]) for p, q in sums) for i in range(600)]
        assert exact_signs.sign_of_products(sums).tolist() == [(s > 0) - (s < 0) for s in exact]


@pytest.mark.parametrize("engine", ENGINES)
def test_the_sign_of_a_sum_allows_for_rounding_in_the_bound_of_its_other_terms(engine):
    """The float sum of the other terms loses 2**-53 five times, so the bound would be too small without a factor."""
    terms = np.array([-1, *[-(2.0**-53)] * 5, 1 + 2.0**-52])
    for sign in (1, -1):
        if engine == "numba":
            assert kernels_of("exact").sign_of_sum(sign * terms, len(terms)) == -sign
        else:
            assert exact_signs.sign_of_sum(sign * terms[:, None]) == -sign


@pytest.mark.parametrize("engine", ENGINES)
def test_sums_that_nearly_vanish_have_their_exact_sign(engine):
    """Each large number is cancelled by its two parts and their rounding error, which is left out in some sums."""
    rng, seen = RNG(12), []
    for n in range(300):
        large = rng.normal(0, 1, 3) * 2.0 ** rng.integers(-40, 40, 3)
        parts = large * rng.uniform(-2, 3, 3)
        rest = large - parts  # rounded
        errors = [float(Fraction(u) - Fraction(v) - Fraction(w)) for u, v, w in zip(large, parts, rest)]
        terms = np.array([*-large, *parts, *rest, *errors[:2], errors[2] * (n % 3)])
        rng.shuffle(terms)
        exact = sum(map(Fraction, terms))
        if engine == "numba":
            sign = kernels_of("exact").sign_of_sum(terms.copy(), len(terms))
        else:
            (sign,) = exact_signs.sign_of_sum(terms[:, None].copy())
        assert sign == (exact > 0) - (exact < 0), terms
        seen.append(sign)
    assert min(map(seen.count, (-1, 0, 1))) > 20


def test_sums_of_ordinary_products_need_no_integers(monkeypatch):
    in_integers = []
    monkeypatch.setattr(exact_signs, "to_integers", lambda values: in_integers.append(values))
    a, b, c = RNG(8).uniform(-1, 1, (3, 500)) * 10.0 ** RNG(9).integers(-60, 60, (3, 500))
    zero = np.zeros(500)
    for more in ([], [(zero, c)], [(c, zero)]):
        assert not exact_signs.sign_of_products([(a, b), (-b, a), *more]).any()
        assert np.array_equal(exact_signs.sign_of_products([(a, b), (-b, a), (c, a), *more]), np.sign(c) * np.sign(a))
    assert not in_integers


def resting(rng, n, v=3):
    """Return circles that touch an edge or a corner of a polygon as nearly as floats allow."""
    rings = ngons(rng, 4 * n, v)
    fat = (rings * turned(np.roll(rings, -1, axis=1))).sum(axis=(1, 2)) > 0.2
    rings = rings[fat][:n]
    i = rng.integers(0, v, n)
    p, q, o = (rings[np.arange(n), (i + step) % v] for step in (0, 1, -1))
    on_corner, w = rng.random((n, 1)) < 0.5, rng.uniform(0.1, 0.9, (n, 1))
    out, other = (turned(e) / np.linalg.norm(e, axis=1, keepdims=True) for e in (q - p, p - o))
    out = np.where(on_corner, w * out + (1 - w) * other, out) * rng.uniform(0.3, 1, (n, 1))
    spot = np.where(on_corner, p, p + w * (q - p))
    centers = spot + out
    return centers, np.hypot(*(centers - spot).T), rings


def tiny_on_edges(rng, n):
    """Return circles with radii near or far below the coordinates' unit in the last place.

    Their centers lie on edges, on corners, or up to two floats off.
    """
    _, _, rings = resting_exactly(rng, n) if rng.random() < 0.5 else resting(rng, n, 5)
    w = rng.choice([0, 0.25, 0.5, 1], (n, 1))
    centers = jolt(rng, rings[:, 0] + w * (rings[:, 1] - rings[:, 0]), 2)
    return centers, 2.0 ** -rng.choice([1, 30, 52, 53, 54, 60, 105, 120], n) * rng.uniform(1, 2, n), rings


def beside_corners(rng, n):
    """Return turned boxes with a circle below a corner: foot and corner are equally far, up to one float."""
    z = TRIPLES[rng.integers(0, len(TRIPLES), n)]
    along, side = np.where(rng.random((n, 1)) < 0.5, z[:, :2], [1, 0]), rng.integers(1, 2**16, (n, 1)).astype(float)
    p = rng.integers(1, 2**20, (n, 2)).astype(float)
    right, up = side * along, -side * turned(along)
    down = rng.integers(1, 2**16, n)
    rings = np.stack([p, p + right, p + right + up, p + up], axis=1)
    centers = p + right * rng.integers(0, 2, (n, 1)) + turned(along) * down[:, None]
    far = np.where(along[:, 1] == 0, 1, z[:, 2]) * down
    return jolt(rng, centers, 1), far, np.where(rng.random((n, 1, 1)) < 0.5, jolt(rng, rings, 1), rings)


def slivers(rng, n):
    """Return triangles whose height is a rounding error, and circles of that size."""
    p, q = rng.uniform(-1, 1, (2, n, 2))
    rings = np.stack([p, q, p + rng.uniform(0.1, 0.9, (n, 1)) * (q - p)], axis=1)
    rings[:, 2, 1] = np.nextafter(np.nextafter(rings[:, 2, 1], 9), 9)
    keep = exact_signs.orient(*rings.reshape(n, 6).T) != 0
    centers = jolt(rng, p + rng.uniform(0, 1, (n, 1)) * (q - p), 3)
    return centers[keep], (2.0 ** -rng.choice([50, 53, 54, 56, 70], n))[keep], rings[keep]


def at_the_end_of_a_long_edge(rng, n):
    """Return circles whose foot on an edge lies before or beyond its end by about a rounding error of its length.

    The radius lies between the distances to the line and to the end.
    """
    end = np.c_[rng.uniform(0, 0.5, n), rng.uniform(-1, 1, n)]
    long = np.c_[rng.uniform(-1, 1, n), 2.0 ** rng.uniform(31, 34, n)]
    other = end + np.c_[rng.uniform(0.5, 2, n), rng.uniform(-0.1, 0.3, n)]
    way = long / np.hypot(*long.T)[:, None]
    behind = long[:, 1:] * 2.0**-52 * rng.uniform(-0.6, 0.6, (n, 1))
    off = rng.uniform(0.3, 1, n)
    radii = np.hypot(off, behind[:, 0] * rng.uniform(0, 1, n))
    points = np.stack([end - turned(way) * off[:, None] - way * behind, end + long, end, other], axis=1)
    points = points * rng.choice([-1.0, 1.0], (n, 1, 2))
    points = np.where(rng.random((n, 1, 1)) < 0.5, points[..., ::-1], points)
    return points[:, 0], radii, points[:, 1:]


COMMON = {
    "near triangles": resting,
    "near 8-gons": lambda rng, n: resting(rng, n, 8),
    "on a grid": resting_exactly,
    "on a fine grid": lambda rng, n: resting_exactly(rng, n, 22),
    "on boxes": resting_on_boxes,
    "a float off a grid": a_float_off(resting_exactly),
    "a float off a fine grid": a_float_off(lambda rng, n: resting_exactly(rng, n, 22)),
    "a float off a box": a_float_off(resting_on_boxes),
    "near, moved": moved(resting),
    "on a grid, moved": moved(resting_exactly),
    "a float off, moved": moved(a_float_off(resting_exactly)),
}
RARE = {
    "tiny on edges": tiny_on_edges,
    "tiny on edges, moved": moved(tiny_on_edges),
    "beside corners": beside_corners,
    "slivers": slivers,
    "small slivers": lambda rng, n: tuple(c * 2.0**-40 for c in slivers(rng, n)),
    "at the end of a long edge": at_the_end_of_a_long_edge,
}


@pytest.mark.parametrize("kind", COMMON | RARE)
def test_circles_that_touch_polygons_are_exact(kind):
    for seed in range(4):
        circles, polygons = batches_from((COMMON | RARE)[kind](RNG(seed), 200))
        exact = [oracle.relation(p, q) for p, q in zip(scalar(circles), scalar(polygons))]
        found = {engine: batch.relate(circles, polygons, engine=engine).tolist() for engine in ENGINES}
        c, p = circles.uniform, polygons.uniform
        found["all undecided"] = (1 - circle_polygons.gap_signs(c.x[0], c.y[0], c.r, p.x, p.y)).tolist()
        found["swapped"] = batch.relate(polygons, circles).tolist()
        assert found == dict.fromkeys(found, exact)


@pytest.mark.parametrize("e", [-470, -450, 0, 470])
def test_filters_of_numba_and_numpy_classify_circles_alike(e):
    """Some circles are ordinary, others touch a polygon or each other up to about the error bound."""
    kernels = kernels_of("filter")
    rng, seen = RNG(e + 500), []

    def both(name, *columns):
        outs = [np.full(len(columns[0]) - 3, 9, np.int8) for _ in "ab"]
        with np.errstate(all="ignore"):
            getattr(kernels, name)(*columns, 3, outs[0])
            getattr(filter_numpy, name)(*columns, 3, outs[1])
        assert outs[0].tolist() == outs[1].tolist()
        seen.extend(outs[0].tolist())

    ordinary = [
        lambda _, n, v=v: (rng.uniform(-2, 2, (n, 2)), rng.uniform(0.1, 1, n), ngons(rng, n, v)) for v in (3, 5, 9)
    ]
    for make in [*(COMMON | RARE).values(), *ordinary]:
        centers, radii, rings = make(rng, 40)
        radii = radii * (1 + rng.integers(-9, 10, len(radii)) * 2.0 ** rng.choice([-52, -45, -44, -40], len(radii)))
        c, p = (s.uniform for s in batches_from((centers * 2.0**e, radii * 2.0**e, rings * 2.0**e)))
        both("circle_polygons", c.x[0], c.y[0], c.r, p.x, p.y)
    for near in (1, 0.5, 1e-9):
        x, y, z = TRIPLES[rng.integers(0, len(TRIPLES), 40)].T * 2.0**e * near
        radii = z * (1 + rng.integers(-9, 10, 40) * 2.0 ** rng.choice([-52, -50, -49, -40], 40)) / 2
        both("circles", x, -y, z / 2, np.zeros(40), np.zeros(40), radii)
    assert all(seen.count(k) > 20 for k in ((UNDECIDED,) if e == -470 else (0, 2, UNDECIDED)))


@pytest.mark.parametrize(
    ("e", "certified"), [(-500, False), (-446, False), (-430, True), (476, True), (486, False), (511, False)]
)
@pytest.mark.parametrize("engine", ENGINES)
def test_the_filter_certifies_circles_only_where_products_stay_in_the_range_of_floats(engine, e, certified):
    kernels = filter_numpy if engine == "numpy" else kernels_of("filter")
    rng, size = RNG(e + 500), 2.0**e
    c, p = circles(rng, 50).uniform, batch.Polygons(regular(rng, 50, 5)).uniform
    out = np.empty(50, np.int8)
    with np.errstate(all="ignore"):
        kernels.circle_polygons(c.x[0] * size, c.y[0] * size, c.r * size, p.x * size, p.y * size, 0, out)
    assert {0, 2} <= set(out) if certified else set(out) == {UNDECIDED}


@pytest.mark.parametrize(
    ("center", "radius", "ring", "exact"),
    [
        ((4, -3), 5, [(-3 * 2.0**60, -4 * 2.0**60), (3 * 2.0**60, 4 * 2.0**60), (-4 * 2.0**60, 3 * 2.0**60)], 1),
        ((4, -3), 5, [(-3, -4), (3 * 2.0**60, 4 * 2.0**60), (-4 * 2.0**60, 3 * 2.0**60)], 1),
        ((1e-200, -1), 1, [(0, 0), (-1, 1), (-1, 0.5)], 0),
        ((2.0**-100, 0), 5, [(3, 4), (10, 5), (5, 12)], 2),
        ((-(2.0**-100), 0), 5, [(3, 4), (10, 5), (5, 12)], 0),
        ((0, 2.0**-100), 5, [(3, 4), (10, 5), (5, 12)], 2),
        ((0, -(2.0**-100)), 5, [(3, 4), (10, 5), (5, 12)], 0),
        ((2.0**-100, 0), 5, [(7, 1), (1, -7), (12, -9)], 2),
        ((-(2.0**-100), 0), 5, [(7, 1), (1, -7), (12, -9)], 0),
        ((0, 2.0**-100), 5, [(7, 1), (1, -7), (12, -9)], 0),
        ((0, -(2.0**-100)), 5, [(7, 1), (1, -7), (12, -9)], 2),
        *(  # nearly perpendicular to an edge at its end: beyond the end, and before it
            (at, 5, [(0, 0), (3, 4), (-10, 5)], exact)
            for e, exact in ((2.0**-50, 0), (-(2.0**-50), 1))
            for at in ((4 - 3 * e, -3 - 4 * e), (7 + 3 * e, 1 + 4 * e))
        ),
        ((-2.5, 5), 5, [(3, 4), (2.0**-60, 0), (5, -3)], 0),  # an edge that rounds to one of length 5
        ((-2.5, 5), 5, [(3, 4), (-(2.0**-60), 0), (5, -3)], 2),
        ((5, -2.5), 5, [(-3, 5), (0, 2.0**-60), (4, 3)], 0),
        ((5, -2.5), 5, [(-3, 5), (0, -(2.0**-60)), (4, 3)], 2),
        ((2.5 * 2.0**-560, 0.5), 2 * 2.0**-560, [(0, 0), (2.0**-560, 1), (-1, 0.5)], 2),  # an edge hardly above 1
        ((1e-150, -1), 1, [(0, 0), (1, 1e-200), (0.5, 1)], 0),
        ((0.5, -1), 1, [(0, 0), (1, 1e-200), (0.5, 1)], 0),
        ((0.5, -1), 1, [(0, 0), (1, -5e-324), (0.5, 1)], 2),
        ((1.5e-162, -1), 0.98, [(0, 0), (3e-162, 0), (0, 1)], 0),
    ],
)
def test_circles_are_exact_where_the_relation_depends_on_a_rounding_error_or_an_underflow(center, radius, ring, exact):
    assert oracle.relation(sv.Circle(center, radius), sv.Polygon(ring)) == exact
    circles, polygons = batch.Circles([center] * 50, radius), batch.Polygons([ring] * 50)
    assert batch.relate(circles, polygons, engine="numpy").tolist() == [exact] * 50


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("e", [-460, -500, -532, -536, -538, -545])
def test_circles_are_exact_over_an_edge_whose_squared_length_loses_bits(e, engine):
    rng = RNG(-e)
    x, half = rng.uniform(-1, 1, 100), rng.uniform(0.8, 1.5, 100)
    points = np.zeros((100, 5, 2))  # center, the ends of the edge below, two more corners
    points[:, :3, 0] = np.stack([x, half, -half], axis=1) * 2.0**e
    points[:, 0, 1], points[:, 3:] = 1, [(-1, -1), (1, -1)]
    radii = rng.choice([0.8, 1 - 2.0**-10, 1, 1, 1, 1, 1 + 2.0**-10, 1.2], 100)
    for turns in range(4):
        circles, polygons = batch.Circles(points[:, 0], radii), batch.Polygons(points[:, 1:])
        exact = [oracle.relation(p, q) for p, q in zip(scalar(circles), scalar(polygons))]
        assert set(exact) == {0, 1, 2}
        assert batch.relate(circles, polygons, engine=engine).tolist() == exact, turns
        points = turned(points)


def test_circles_are_exact_with_ragged_and_repeated_vertices():
    rng = RNG(2)
    made = [make(rng, 60) for make in (resting, COMMON["near 8-gons"], resting_on_boxes, resting_exactly)]
    rings = [ring for _, _, rings in made for ring in rings.tolist()]
    rings = [ring[:1] + ring[::-1] if i % 3 else ring[::-1] + ring[-1:] for i, ring in enumerate(rings)]
    circles = batch.Circles(*(np.concatenate([m[k] for m in made]) for k in (0, 1)))
    order = rng.permutation(len(rings))
    circles, polygons = circles[order], batch.Polygons([rings[i] for i in order])
    exact = [oracle.relation(p, q) for p, q in zip(scalar(circles), scalar(polygons))]
    for engine in ENGINES:
        assert batch.relate(circles, polygons, engine=engine).tolist() == exact


@pytest.mark.slow
def test_signs_certified_by_floats_are_right_for_hard_pairs():
    """The pairs have every scale, up to overflow and down to the smallest floats."""
    known = [(a, b) for _, a, b in pairs(3, 250 * len(CONVEX), list(CONVEX))]
    known = [(a, b) if isinstance(a, sv.Circle) else (b, a) for a, b in known if type(a) is not type(b)]
    known = [(c, p) for c, p in known if len(sv.parts(p)) == 1]
    circles, polygons = batches_of([c for c, _ in known]).groups[1], batch.Polygons([p for _, p in known])
    certified = 0
    for v, group in polygons.groups.items():
        mine = np.flatnonzero(polygons.count == v)
        columns = circles.x[0, mine], circles.y[0, mine], circles.r[mine], group.x, group.y
        with np.errstate(all="ignore"):
            found = circle_polygons._float_signs(*columns)
        for i, value in zip(mine, found):
            assert value in (exact_signs.UNKNOWN, 1 - oracle.relation(*known[i])), known[i]
        certified += (found != exact_signs.UNKNOWN).sum()
    assert certified > len(known) / 2


@pytest.mark.parametrize("kind", COMMON)
def test_hardly_any_circle_that_touches_a_polygon_needs_integers(kind, monkeypatch):
    counted = []
    real = circle_polygons._integer_sign
    monkeypatch.setattr(circle_polygons, "_integer_sign", lambda *columns: counted.append(1) or real(*columns))
    circles, polygons = (shapes.uniform for shapes in batches_from(COMMON[kind](RNG(5), 5000)))
    circle_polygons.gap_signs(circles.x[0], circles.y[0], circles.r, polygons.x, polygons.y)
    assert len(counted) <= 5


@pytest.mark.parametrize("kind", COMMON)
def test_of_a_circle_that_touches_a_polygon_only_features_near_its_radius_are_evaluated_exactly(kind):
    """These are a corner or a foot, or a corner and the foot beside it."""
    circles, polygons = (shapes.uniform for shapes in batches_from(COMMON[kind](RNG(5), 300)))
    *evaluated, inside, error_bound = features_within_radius(circles, polygons)
    assert np.bincount(np.concatenate(evaluated) % 300).max() <= 2
    assert not inside.size and (error_bound < np.inf).all()


def features_within_radius(circles, polygons):
    """Return `circle_polygons._features_within_radius` of the pairs."""
    x, y = (circle_polygons._close_rings(c) for c in (polygons.x, polygons.y))
    with np.errstate(all="ignore"):
        return circle_polygons._features_within_radius(circles.x[0], circles.y[0], circles.r, x, y)


@pytest.mark.parametrize(("e", "certified"), [(-470, False), (-430, True), (460, True), (486, False), (505, False)])
def test_floats_certify_circles_that_touch_polygons_only_where_products_stay_in_range(e, certified):
    made = [values * 2.0 ** (e - 10) for values in resting_exactly(RNG(3), 50)]
    circles, polygons = (shapes.uniform for shapes in batches_from(made))
    *features, error_bound = features_within_radius(circles, polygons)
    assert (error_bound == np.inf).tolist() == [not certified] * 50
    if not certified:
        assert not any(places.size for places in features)
    columns = circles.x[0], circles.y[0], circles.r, polygons.x, polygons.y
    with np.errstate(all="ignore"):
        found = circle_polygons._float_signs(*columns)
    assert found.tolist() == ([0] * 50 if certified else [exact_signs.UNKNOWN] * 50)
    assert circle_polygons.gap_signs(*columns).tolist() == [0] * 50


def test_circles_over_an_edge_whose_squared_length_may_lose_bits_are_evaluated_in_integers():
    shapes = batch.Circles([(0, -1)], 1), batch.Polygons([[(-1, 0), (2.0**-470, 0), (0, 2.0**-470)]])
    *features, error_bound = features_within_radius(*(shape.uniform for shape in shapes))
    assert error_bound == np.inf and not any(places.size for places in features)


@pytest.mark.parametrize("engine", ENGINES)
def test_circles_on_polygons_are_exact_in_the_second_and_third_block_too(engine):
    """Each third circle touches its polygon exactly; the others have the next larger or smaller radius."""
    n = 2 * circle_polygons.BLOCK_PAIRS + 5
    centers, radii, rings = resting_exactly(RNG(3), n)
    kind = np.arange(n) % 3
    radii = np.where(kind == 1, radii, np.nextafter(radii, np.where(kind, np.inf, 0)))
    circles, polygons = batches_from((centers, radii, rings))
    assert (batch.relate(circles, polygons, engine=engine) == kind).all()


def on_long_edges(rng, n):
    """Return circles that touch an edge from outside or inside near one end; the other is 2**10 to 2**40 radii away."""
    x, y, z = TRIPLES[rng.integers(0, len(TRIPLES), n)].T
    along, outside = np.stack([x, y], axis=1), rng.choice([-1, 1], (n, 1))
    near, far = -rng.integers(0, 3, (n, 1)) * along, 2.0 ** rng.integers(10, 41, (n, 1)) * along
    m = rng.integers(1, 4, (n, 1))
    rings = np.stack([near, far, far - turned(along) * 2.0**42 - along], axis=1)
    centers, mirrored = m * turned(along) * outside + along, rng.random((n, 1)) < 0.5
    flip = np.where(mirrored, [-1, 1], [1, 1])
    return centers * flip, m[:, 0] * z, rings * flip[:, None], outside[:, 0]


@pytest.mark.parametrize("seed", range(5))
def test_circles_that_touch_long_edges_from_outside_and_inside_are_exact(seed):
    centers, radii, rings, outside = on_long_edges(RNG(seed), 200)
    for more in 0, 1, -1:
        made = batches_from((centers, radii * (1 + more * 2.0**-50), rings))
        c, p = (shapes.uniform for shapes in made)
        found = circle_polygons.gap_signs(c.x[0], c.y[0], c.r, p.x, p.y)
        assert found.tolist() == np.where(outside < 0, -1, -more).tolist()
        for engine in ENGINES:
            assert batch.relate(*made, engine=engine).tolist() == (1 - found).tolist()


@pytest.mark.parametrize("kind", ["near triangles", "near, moved", "slivers"])
def test_sums_for_foot_signs_in_two_floats_stay_within_their_error_bound(kind, monkeypatch):
    """ERRBOUND_B is 256 * 2**-106; the proof needs 88, besides the sum's rounding. The largest error is printed."""
    seen = []
    real = exact_signs.sum_with_error
    monkeypatch.setattr(exact_signs, "sum_with_error", lambda *terms: seen.append(real(*terms)) or seen[-1])
    centers, radii, rings = (COMMON | RARE)[kind](RNG(1), 500)
    columns = *centers.T, radii, *rings[:, 0].T, *rings[:, 1].T
    side = -exact_signs.orient(*rings[:, 0].T, *rings[:, 1].T, *centers.T)
    circle_polygons._foot_signs(*columns, error_bound=np.full(len(radii), np.inf))
    (_, _, _), (total, off, _) = seen
    worst = 0.0
    with localcontext(prec=150):
        for i, (cx, cy, r, px, py, qx, qy) in enumerate(zip(*(map(Decimal, c.tolist()) for c in columns))):
            turn = (py - cy) * (qx - px) - (px - cx) * (qy - py)
            exact = turn * int(side[i]) - r * ((qx - px) ** 2 + (qy - py) ** 2).sqrt()
            error = abs(Decimal(total[i]) - exact) - abs(exact) / 2**53
            worst = max(worst, float(error / Decimal(off[i])) * 256)
    print(f"{kind}: worst {worst:.1f} of 256")
    assert 0 < worst < 88


def test_upright_boxes_among_other_shapes_of_four_corners_are_classified_by_their_sides(monkeypatch):
    """The boxes of two batches are compared together; exact signs are evaluated only for other shapes."""
    box = np.array([(0, 0), (1, 0), (1, 1), (0, 1)])
    diamond = np.array([(0, -0.5), (0.5, 0), (0, 0.5), (-0.5, 0)])
    at = 0.1 * np.arange(50)[:, None, None]
    tiles, beside = at + 0.1 * box, at + np.array([0.1, 0]) + 0.1 * box
    rings = [*tiles, *(at + np.add(box, [1, 0.3])), *(at + box), box + 7, diamond - 7]
    others = [
        *beside,
        *(at + np.add(diamond, [2.5, 0.8])),
        *(at + np.add(diamond, [-0.5, 0.5])),
        diamond + 6.6,
        diamond - 7,
    ]
    known = [sv.relate(sv.Polygon(p), sv.Polygon(q)) for p, q in zip(rings, others)]
    evaluated = []
    real = exact_signs.orient
    monkeypatch.setattr(exact_signs, "orient", lambda *c: evaluated.extend(c[0]) or real(*c))
    a, b = batch.Polygons(rings), batch.Polygons(others)
    assert batch.relate(a, b, engine="numpy").tolist() == batch.relate(b, a, engine="numpy").tolist() == known
    evaluated.clear()
    only = [*range(50), 151]
    assert batch.relate(a[only], b[only], engine="numpy").tolist() == [known[i] for i in only]
    assert not evaluated


def nearly_touching(rng, n, v, w):
    """Return polygons and their images, rotated about a point of an edge or a corner: they touch up to rounding."""
    rings = ngons(rng, 4 * n, v)
    rings = rings[(rings * turned(np.roll(rings, -1, axis=1))).sum(axis=(1, 2)) > 0.2][:n]
    spot = rings[:, 0] + rng.choice([0, 0.25, rng.random()], (len(rings), 1)) * (rings[:, 1] - rings[:, 0])
    return rings, spot[:, None] - rng.uniform(0.5, 2, (len(rings), 1, 1)) * (rings[:, :w] - spot[:, None])


@pytest.mark.parametrize("scale", [2.0**-525, 2.0**-70, 2.0**-30, 1.0, 2.0**200, 2.0**511])
@pytest.mark.parametrize("far", one_in(2, [(0, 0), (1000, -1000)]))
@pytest.mark.parametrize(("v", "w"), [(3, 3), (4, 4), (8, 5), (20, 20)])
def test_nearly_touching_polygons_are_exact(v, w, far, scale):
    rng = RNG(v)
    p, q = (jolt(rng, (rings + far) * scale, most) for rings, most in zip(nearly_touching(rng, 160 // v, v, w), (0, 1)))
    valid = [i for i in range(len(p)) if all(is_convex_ring(rings[i], k) for rings, k in ((p, v), (q, w)))]
    p, q = batch.Polygons(p[valid]), batch.Polygons(q[valid])
    exact = [oracle.relation(one, other) for one, other in zip(scalar(p), scalar(q))]
    index = np.arange(len(p))
    found = {engine: batch.relate(p, q, engine=engine).tolist() for engine in ENGINES}
    found |= {
        f"{engine} by index": batch.relate(p, q, np.c_[index, index], engine=engine).tolist() for engine in ENGINES
    }
    found["all undecided"] = exact_numpy.relations(p.uniform, index, q.uniform, index).tolist()
    found["all undecided, swapped"] = exact_numpy.relations(q.uniform, index, p.uniform, index).tolist()
    assert found == dict.fromkeys(found, exact)


def is_convex_ring(ring, v):
    """Return whether a ring is still convex with v corners after its coordinates were rounded."""
    try:
        polygon = sv.Polygon(ring)
    except sv.InvalidShape:
        return False
    return polygon.is_convex and len(polygon.corners) == v


@pytest.mark.parametrize(("v", "w"), [(5, 5), (8, 5), (9, 20)])
def test_every_edge_is_evaluated_from_whichever_corner_the_search_begins_at(v, w, monkeypatch):
    rng = RNG(v * w)
    monkeypatch.setattr(
        exact_numpy, "_facing_corner", lambda own, other: rng.integers(0, own.edge_count, own.x.shape[1])
    )
    p, q = (batch.Polygons(ngons(rng, 300, k)) for k in (v, w))
    index = np.arange(300)
    exact = one_by_one(p, q)
    assert 0 < exact.count(0) < 300
    for limit in 0, 300 * 20 * 20:  # one edge after another, and all at once
        monkeypatch.setattr(exact_numpy, "MAX_VALUES_AT_ONCE", limit)
        assert exact_numpy.relations(p.uniform, index, q.uniform, index).tolist() == exact
        assert exact_numpy.relations(q.uniform, index, p.uniform, index).tolist() == exact


@pytest.mark.parametrize("v", [40, 100])
def test_of_many_corners_only_edges_near_the_other_shape_are_evaluated(v, monkeypatch):
    """Each pair is a shape and its image, rotated about one of its corners, at several places."""
    rng = RNG(v)
    evaluated = []
    real = exact_numpy._classify_edges
    monkeypatch.setattr(exact_numpy, "_classify_edges", lambda *c: evaluated.extend(c[3]) or real(*c))
    for far in ((0, 0), (30, -20), (-1000, 1000)):
        a = np.round(ngons(rng, 200, v) * 2.0**30) * 2.0**-30 + far
        spot = a[np.arange(200), rng.integers(0, v, 200)][:, None]
        p, q, index = batch.Polygons(a).uniform, batch.Polygons(2 * spot - a).uniform, np.arange(200)
        for one, other in ((p, q), (q, p)):
            evaluated.clear()
            assert (exact_numpy.relations(one, index, other, index) == 1).all()
            assert len(evaluated) <= 7 * 200


@pytest.mark.parametrize("turn", [[[1, 0], [0, 1]], [[0, 1], [-1, 0]], [[-1, 0], [0, -1]], [[3, 4], [-4, 3]]], ids=str)
def test_edges_on_one_line_touch_where_their_ranges_overlap(turn):
    octagon = np.array([(0, 0), (4, 0), (6, 2), (6, 4), (4, 6), (0, 6), (-2, 4), (-2, 2)])
    moves = np.repeat([-20, -1, 0, 1, 4, 8, 9, 20], 10)
    below = np.stack([[t, 0] - octagon for t in moves]) @ turn
    a, b = batch.Polygons(np.array([octagon] * len(moves)) @ turn), batch.Polygons(below)
    exact = [int(0 <= t <= 8) for t in moves]
    index = np.arange(len(moves))
    for one, other in ((a, b), (b, a)):
        assert exact_numpy.relations(one.uniform, index, other.uniform, index).tolist() == exact
        assert batch.relate(one, other).tolist() == exact


@pytest.mark.parametrize("scale", [1e-120, 1.0, 1e130])
@pytest.mark.parametrize("v", [3, 4, 5, 20])
def test_ordinary_pairs_need_no_exact_sign_at_any_scale(v, scale, monkeypatch):
    rng = RNG(v)
    undecided = []
    monkeypatch.setattr(exact_numpy, "_classify_on_line", lambda *c: undecided.append(c))
    rings = ngons(rng, 200, v)
    rings = rings[(rings * turned(np.roll(rings, -1, axis=1))).sum(axis=(1, 2)) > 0.5]
    a, b = (batch.Polygons((rings + far) * scale).uniform for far in (0, [1e-3, 2e-3]))
    index = np.arange(len(rings))
    assert (exact_numpy.relations(a, index, b, index) == 2).all()
    a, b = (batch.Polygons(ngons(rng, 200, v) * scale).uniform for _ in "ab")
    exact_numpy.relations(a, np.arange(200), b, np.arange(200))
    assert not undecided


@pytest.mark.parametrize("large", [0, 1])
def test_the_error_bound_of_gjk_for_many_corners_is_that_of_the_largest_coordinates(large, monkeypatch):
    rng = RNG(17)
    seen = []
    real = gjk.gjk
    monkeypatch.setattr(gjk, "gjk", lambda *c: seen.append(c[4]) or real(*c))
    rings = [ngons(rng, 30, 20, 0.1) * (1000 if k == large else 1) for k in (0, 1)]
    a, b = map(batch.Polygons, rings)
    index = np.arange(30)
    batch.relate(a, b, engine="numpy")
    batch.relate(a, b, np.c_[index, index], engine="numpy")
    tile, pair = seen
    assert tile.tolist() == [sum(np.abs(r).max() for r in rings) * ERROR_FACTOR_F64] * 30
    assert np.array_equal(pair, sum(np.abs(r).max(axis=(1, 2)) for r in rings) * ERROR_FACTOR_F64)


@pytest.mark.parametrize(
    "other", [[(0, 0), (3, 0), (0, 3)], [(0, 0), (4, 0), (6, 2), (6, 4), (4, 6), (0, 6), (-2, 4), (-2, 2)]]
)
def test_gjk_of_many_corners_is_right_at_every_place_of_the_other_shape(other):
    """The other shape is put at all integer points of a square, so some pairs touch at corners or along edges."""
    one = np.array([(0, 0), (2, -1), (4, 0), (5, 3), (4, 5), (0, 5), (-1, 2)])
    places = np.stack(np.meshgrid(np.arange(-9, 10), np.arange(-9, 10)), axis=-1).reshape(-1, 1, 2)
    a, b = batch.Polygons(one + 0 * places), batch.Polygons(np.array(other) + places)
    exact = one_by_one(a, b)
    for p, q in ((a.uniform, b.uniform), (b.uniform, a.uniform)):
        out = np.empty(len(exact), np.int8)
        gjk.gjk(p.x, p.y, q.x, q.y, np.full(len(exact), 30 * ERROR_FACTOR_F64), out)
        assert all(found in (UNDECIDED, relation) for found, relation in zip(out.tolist(), exact))
        assert (out == UNDECIDED).sum() <= exact.count(1) + 20


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("v", one_in(2, [3, 5, 9, 17, 24]))
def test_many_nearly_touching_polygons_are_right(v, engine):
    rng = RNG(v)
    rings, others = nearly_touching(rng, 400, v, v)
    valid = [i for i in range(len(rings)) if is_convex_ring(rings[i], v) and is_convex_ring(others[i], v)]
    a, b = batch.Polygons(rings[valid]), batch.Polygons(others[valid])
    assert batch.relate(a, b, engine=engine).tolist() == one_by_one(a, b)


def test_the_side_of_the_foot_is_right_or_unknown_next_to_an_end_of_the_edge():
    """The foot of each center is an end of its edge up to rounding; differences lose bits too."""
    rng = RNG(18)
    n, known = 1000, 0
    p, q = rng.uniform(-1, 1, (2, n, 2)) * 10.0 ** rng.integers(-2, 3, (2, n, 1))
    c = p + turned(q - p) * rng.uniform(-3, 3, (n, 1))
    for ends in ((p, q), (q, p)):
        columns = *c.T, np.ones(n), *ends[0].T, *ends[1].T
        with np.errstate(all="ignore"):
            found = circle_polygons._keep_inner_feet(np.full(n, -1, np.int8), *columns)
        for sign, cx, cy, _, px, py, qx, qy in zip(
            found.tolist(), *(map(Fraction, column.tolist()) for column in columns)
        ):
            along = (cx - px) * (qx - px) + (cy - py) * (qy - py)
            between = 0 < along < (qx - px) ** 2 + (qy - py) ** 2
            assert sign in (exact_signs.UNKNOWN, -1 if between else 1)
            known += sign != exact_signs.UNKNOWN
    assert known > 1.9 * n


@pytest.mark.parametrize("lost", [1.0, -1.0])
@pytest.mark.parametrize("y_first", [False, True])
def test_the_rounding_error_of_a_difference_decides_where_the_foot_is_where_all_other_terms_cancel(lost, y_first):
    """The foot of the center is an end of the edge, but for a 1 that is rounded off beside 2**100."""
    end, along = np.array([4, -3]) * 2.0**110, np.array([3, 4]) * 2.0**100
    known = [((lost, 0), end, end + s * along) for s in (1, -1)]  # lost between the center and the end
    known += [(np.array([3 * s - lost, -4 * s]), (-lost, 0), along[::-1]) for s in (1, -1)]  # and along the edge
    for c, p, q in known:
        for ends in ((p, q), (q, p)):
            cx, cy, px, py, qx, qy = (float(v) for point in (c, *ends) for v in point[:: -1 if y_first else 1])
            columns = [np.array([v]) for v in (cx, cy, 1.0, px, py, qx, qy)]
            (sign,) = circle_polygons._keep_inner_feet(np.full(1, -1, np.int8), *columns)
            cx, cy, px, py, qx, qy = map(Fraction, (cx, cy, px, py, qx, qy))
            along = (cx - px) * (qx - px) + (cy - py) * (qy - py)
            assert along and sign in (exact_signs.UNKNOWN, -1 if 0 < along < (qx - px) ** 2 + (qy - py) ** 2 else 1)
