"""Tests of the narrow phase: relations of many pairs equal those of `sv.relate`, and filters are right or undecided."""

from itertools import product
from random import Random

import numpy as np
import pytest
from batches import (
    ELL,
    ENGINES,
    RNG,
    TRIPLES,
    Elsewhere,
    a_float_off,
    as_python,
    batches_from,
    batches_of,
    beside_mirror,
    circles,
    jolt,
    kernels_of,
    ngons,
    one_by_one,
    regular,
    resting_exactly,
    resting_on_boxes,
    scalar,
    tiles,
)
from speeds import one_in
from strategies import CONVEX, drawn, pairs

import satviz as sv
from satviz import batch
from satviz.batch import arrays, engines, exact_signs, narrow_phase
from satviz.batch.codes import UNDECIDED
from satviz.batch.with_numpy import circle_polygons, indexed
from satviz.batch.with_numpy import exact as exact_numpy
from satviz.batch.with_numpy import filter as filter_numpy
from satviz.engine.relate import ERROR_FACTOR_F64, MAX_ERROR_BOUND, MIN_ERROR_BOUND
from satviz.study import truth as oracle


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("kinds", ["33", "44", "88", "34", "38", "57", "11", "13", "81", "19"])
def test_batch_relations_are_the_scalar_relations(engine, kinds):
    rng = RNG(int(kinds))
    a, b = (circles(rng, 300) if k == "1" else batch.Polygons(ngons(rng, 300, int(k))) for k in kinds)
    found = batch.relate(a, b, engine=engine)
    assert found.dtype == np.int8 and found.tolist() == one_by_one(a, b)
    assert 0 < (found > 0).sum() < 300
    assert batch.hits(a, b, engine=engine).tolist() == (found > 0).tolist()
    index = np.arange(300)
    assert batch.relate(a, b, np.c_[index, index], engine=engine).tolist() == found.tolist()


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("chunk", [1 << 20, 100_007])
def test_relations_are_right_in_every_block(engine, chunk):
    """There are more pairs than any engine evaluates at a time, and chunks that end inside a block."""
    a, b = (ngons(RNG(seed), 50, 3) for seed in (1, 2))
    known, times = one_by_one(batch.Polygons(a), batch.Polygons(b)), (1 << 17) // 50 + 2
    assert narrow_phase.engine_of(engine).block < 50 * times
    found = batch.relate(*(batch.Polygons(np.tile(c, (times, 1, 1))) for c in (a, b)), engine=engine, chunk=chunk)
    assert (found.reshape(times, 50) == known).all()


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize(("v", "w"), [(9, 9), (17, 3), (40, 16), (100, 100), (4, 200)])
def test_many_corners_apart_touching_and_overlapping_are_classified(engine, v, w):
    """Each shape touches the other; then the other is moved by one float or by much."""
    a, touching = beside_mirror(v, w)
    for move, exact in ((0, 1), (1, 0), (2.0**39, 0), (-1, 2), (-(2.0**39), 2)):
        p, q = batch.Polygons(a), batch.Polygons(touching + np.array([move, 0.0]))
        for one, other in (p, q), (q, p), (p[::-1][::-1], q):
            assert (batch.relate(one, other, engine=engine) == exact).all(), move
    assert one_by_one(p, q) == [2] * 60


HARD = [
    *("few corners", "many corners", "opposite edges", "shortest edges", "level far sides", "bowls", "nearly parallel"),
    *("mixed magnitudes", "tiny and huge", "map coordinates", "rounded needles", "any scale"),
]


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("kind", one_in(2, HARD))
def test_hard_pairs_have_their_scalar_relation_side_by_side_and_by_index(engine, kind):
    """The pairs meet at all kinds of features, in both orders, beside different shapes in memory."""
    rng, pairs = Random(kind), []
    while len(pairs) < 40:
        pair = drawn(rng, kind)
        if not any(isinstance(s, sv.Circle) for s in pair) and max(len(s.vertices) for s in pair) < 60:
            pairs.append(pair)
    a, b = (batches_of(side) for side in zip(*pairs))
    exact = np.array([sv.relate(p, q) for p, q in pairs])
    assert len(set(exact.tolist())) == 3 or kind == "map coordinates"
    assert batch.relate(a, b, engine=engine).tolist() == exact.tolist()
    assert batch.relate(b, a, engine=engine).tolist() == exact.tolist()
    for v, w in {(len(p.core), len(q.core)) for p, q in pairs}:
        these = np.flatnonzero((a.count == v) & (b.count == w))
        assert batch.relate(a[these], b[these], engine=engine).tolist() == exact[these].tolist()


@pytest.mark.slow
def test_hard_pairs_are_right_where_each_is_a_batch_of_its_own():
    """No other pair of the batch can enlarge the error bound of float32."""
    for _, p, q in pairs(5, 60 * len(CONVEX), list(CONVEX)):
        if isinstance(p, sv.Polygon) and isinstance(q, sv.Polygon):
            found = batch.relate(batch.Polygons([p]), batch.Polygons([q]), engine="numpy")[0]
            assert found == oracle.relation(p, q), (p, q)


@pytest.mark.parametrize("v, w", [(3, 3), (4, 4), (8, 5)])
@pytest.mark.parametrize("far", [0.0, 10.0, 1e4])
def test_float32_clearances_are_within_their_error_bound(v, w, far):
    """The reference is float64, whose error is 2**-29 of that of float32. The largest error found is printed."""
    rng = RNG(7)
    a, b = ngons(rng, 20_000, v), ngons(rng, 20_000, w) + rng.uniform(-far, far, (20_000, 1, 2))
    b[::2] = a[::2, :1] + (b[::2] - b[::2, :1])  # half share a corner
    columns = [np.ascontiguousarray(shape[:, :, k].T) for shape in (a, b) for k in (0, 1)]
    width = 4.0
    found, error_bound = filter_numpy.evaluate_f32(*columns, width)
    size = np.sqrt(error_bound / filter_numpy.ERROR_FACTOR_F32)
    assert (size >= np.abs(b - a[:, :1]).max(axis=(1, 2)) * (1 - 1e-6)).all()
    near = [c - origin for c, origin in zip(columns, (columns[0][0], columns[1][0]) * 2)]
    error = np.abs(found - filter_numpy.clearance(*near, 0)) / (2.0**-24 * size.astype(float) ** 2)
    print(f"{v} against {w} corners, up to {far:g} apart: worst {error.max():.1f} of 64")
    assert 0 < error.max() < 64


def test_numbas_error_bound_is_what_rounding_needs_and_little_more():
    """The proof needs 15 roundings of the largest edge component times the largest coordinate; the bound has 32.

    See relate.ERROR_FACTOR_F64.  Each tile has a bound of its own.
    """
    kernels, sizes = kernels_of("filter"), ([2.0**-30, 1, 2.0**20], [2.0**-20, 1, 2.0**30])
    for edges, coordinates in product(*(product(each, repeat=2) for each in sizes)):
        a, b = (tiles([1.0, edge, 1.0], [1.0, coordinate, 1.0]) for edge, coordinate in zip(edges, coordinates))
        bounds = kernels.error_bounds(a, b)
        assert bounds.shape == (3,) and bounds[0] == bounds[2] == 4 * ERROR_FACTOR_F64
        needed = ERROR_FACTOR_F64 * max(edges) * max(coordinates)
        assert 15 / 32 * needed <= bounds[1] <= 4 * needed, (edges, coordinates)


@pytest.mark.parametrize("e", [-560, -480, -430, 0, 430, 500, 560])
def test_numbas_error_bound_is_infinite_where_products_lose_bits_or_overflow(e):
    kernels = kernels_of("filter")
    group = tiles([1.0, 2.0**e], [1.0, 2.0**e])
    assert (kernels.error_bounds(group, group) < np.inf).tolist() == [True, abs(e) <= 430]


@pytest.mark.parametrize("v", range(3, 17))
def test_the_width_bound_of_the_float32_filter_is_at_least_the_width(v):
    """The columns begin and end anywhere in a tile."""
    rng = RNG(v)
    group = batch.Polygons(ngons(rng, 300, v) * rng.uniform(0.01, 1, (300, 1, 1))).uniform
    wide = np.ptp([group.x, group.y], axis=1).max(axis=0)
    for first, n in (0, 300), (0, 1), (127, 2), (128, 128), (100, 200), (299, 1):
        widths = filter_numpy._max_widths(group, first, n)
        assert widths.shape == (n,) and (wide[first : first + n] <= widths).all()


@pytest.mark.parametrize("half", range(2, 9))
def test_the_width_bound_is_the_width_where_all_edges_have_the_same_horizontal_length(half):
    forth = np.stack([np.ones(half), (2 * np.arange(half) + 1 - half) / half], axis=1)
    group = batch.Polygons(np.cumsum([*forth, *-forth], axis=0)[None]).uniform
    assert np.ptp(group.x) == half and filter_numpy._max_widths(group, 0, 1).tolist() == [half]


@pytest.mark.full
@pytest.mark.parametrize("engine", ENGINES)
def test_a_million_random_pairs_agree_with_relate(engine):
    rng = RNG(1)
    for v, w in ((3, 3), (4, 4), (8, 8), (1, 3), (1, 1)):
        a, b = (circles(rng, 200_000) if k == 1 else batch.Polygons(ngons(rng, 200_000, k)) for k in (v, w))
        assert batch.relate(a, b, engine=engine).tolist() == one_by_one(a, b)


@pytest.mark.parametrize("engine", ENGINES)
def test_touching_boxes_and_circles_touch(engine):
    boxes = batch.Polygons(np.array([[[0, 0], [1, 0], [1, 1], [0, 1]], [[1, 0], [2, 0], [2, 1], [1, 1]]] * 2))
    assert batch.relate(boxes[:2], boxes[1:3], engine=engine).tolist() == [1, 1]
    coins = batch.Circles([(0, 0), (3, 4)], [1, 4])
    assert batch.relate(coins[:1], coins[1:], engine=engine).tolist() == [1]
    assert batch.relate(boxes[:1], batch.Circles([(4, 5)], [5]), engine=engine).tolist() == [1]  # 3-4-5 off a corner


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize(("x", "y", "apart"), [(3, 4, 5), (5, 12, 13), (8, 15, 17), (20, 21, 29)])
def test_circles_that_touch_where_squares_are_rounded_touch(engine, x, y, apart):
    rng = RNG(apart)
    size = rng.integers(2**40, 2**47, 100)
    centers = np.stack([x * size, y * size], axis=1) * rng.choice((-1, 1), (100, 2))
    radius = rng.integers(1, apart * size)
    for more, exact in (0, 1), (1, 2), (-1, 0):
        a, b = batch.Circles(np.zeros((100, 2)), radius), batch.Circles(centers, apart * size - radius + more)
        assert (batch.relate(a, b, engine=engine) == exact).all()


@pytest.mark.parametrize("engine", ENGINES)
def test_one_shape_against_many_and_pairs_by_index_have_the_relations_of_single_pairs(engine):
    rng = RNG(3)
    many = batch.concat([batch.Polygons(ngons(rng, 40, 3)), circles(rng, 30), batch.Polygons(ngons(rng, 30, 6))])
    one = many[:1]
    shapes = scalar(many)
    expected = [sv.relate(shapes[0], s) for s in shapes]
    assert batch.relate(one, many, engine=engine).tolist() == expected
    assert batch.relate(many, one, engine=engine).tolist() == expected
    index = rng.integers(0, 100, (500, 2))
    found = batch.relate(many, many, index, engine=engine)
    assert found.tolist() == [sv.relate(shapes[i], shapes[j]) for i, j in index]


def test_lengths_and_indices_that_do_not_fit_are_refused():
    three, two = batch.Circles(np.zeros((3, 2)), 1), batch.Circles(np.zeros((2, 2)), 1)
    with pytest.raises(ValueError, match="a has 3 shapes and b has 2"):
        batch.relate(three, two)
    with pytest.raises(IndexError, match="with 0 <= i < 3"):
        batch.relate(three, three, [(0, 3)])
    with pytest.raises(ValueError, match="expected \\(K, 2\\)"):
        batch.relate(three, three, [0, 1])
    with pytest.raises(ValueError, match="engine is 'cuda'"):
        batch.relate(three, three, engine="cuda")
    assert batch.relate(three[:0], three[:0]).tolist() == [] == batch.relate(three[:1], three[:0]).tolist()


@pytest.mark.parametrize("function", [batch.relate, batch.hits])
@pytest.mark.parametrize(
    ("index", "words"),
    [
        ([0, 1], "shape \\(2,\\)"),
        ([[0, 1, 2]], "shape \\(1, 3\\) and holds int"),
        ([[0], [1]], "shape \\(2, 1\\)"),
        ([[0.0, 1.0]], "holds float64"),
        ([[True, False]], "holds bool"),
        ([[0, 0], [0, -1]], "0 <= i < 3 and 0 <= j < 5"),
        ([[-1, 0], [2, 4]], "0 <= i < 3 and 0 <= j < 5"),
        ([[0, 0], [3, 0]], "0 <= i < 3 and 0 <= j < 5"),
        ([[5, 0], [0, 0]], "0 <= i < 3 and 0 <= j < 5"),
        ([[0, 0], [0, 5]], "0 <= i < 3 and 0 <= j < 5"),
        ([[0, 0], [2, 6]], "0 <= i < 3 and 0 <= j < 5"),
        (np.array([[0, 2**64 - 1]], np.uint64), "0 <= i < 3 and 0 <= j < 5"),
    ],
)
def test_invalid_pairs_of_indices_are_refused_also_among_valid_ones(function, index, words):
    a, b = (batch.Circles(np.zeros((n, 2)), 1) for n in (3, 5))
    with pytest.raises((ValueError, IndexError), match=words):
        function(a, b, index, engine="numpy")
    assert function(a, b, [[0, 0], [2, 4], [2, 0], [0, 4]], engine="numpy").all()


@pytest.mark.parametrize("kind", [np.int8, np.uint8, np.int16, np.uint64])
def test_indices_of_every_integer_type_select_the_same_shapes(kind):
    at = np.arange(300)[:, None, None] * np.array([1.5, 0])  # each overlaps the next
    shapes = batch.Polygons(ELL + at, concave="split")
    most = min(np.iinfo(kind).max, 299)
    for i, j, exact in ((most - 1, most, 2), (most, most - 1, 2), (most, most, 2), (most, 0, 0)):
        assert batch.relate(shapes, shapes, np.array([[i, j]], kind), engine="numpy").tolist() == [exact]


@pytest.mark.parametrize("kind", [float, int])
def test_no_pairs_have_no_relations(kind):
    shapes = batch.Circles([(0, 0)], 1)
    assert batch.relate(shapes, shapes, np.empty((0, 2), kind), engine="numpy").shape == (0,)


def test_the_largest_coordinate_of_a_column_has_either_sign_and_axis():
    x, y = RNG(11).uniform(-1, 1, (2, 3, 100))
    assert np.array_equal(exact_numpy._max_coordinates(x, y), np.abs(np.concatenate([x, y])).max(axis=0))


@pytest.mark.parametrize("scale", [2.0**-30, 1.0, 2.0**30])
@pytest.mark.parametrize(("v", "w"), [(3, 3), (8, 5), (4, 40), (40, 4), (40, 40)])
def test_ordinary_pairs_are_classified_by_the_filter(v, w, scale):
    rng = RNG(v * w)
    a, b = (batch.Polygons(ngons(rng, 100, k) * scale) for k in (v, w))
    out = np.empty(100, np.int8)
    with np.errstate(all="ignore"):
        filter_numpy.polygons(a.uniform, b.uniform, 0, out)
    assert (out == UNDECIDED).sum() <= 5
    assert all(found in (UNDECIDED, exact) for found, exact in zip(out, one_by_one(a, b)))


@pytest.mark.parametrize("scale", [2.0**-30, 1.0, 2.0**30])
@pytest.mark.parametrize(("v", "w"), [(3, 3), (8, 5), (16, 3)])
def test_the_error_bound_of_float32_holds_for_every_corner(v, w, scale, monkeypatch):
    """The pairs are given side by side and by index; shapes are wide or high, above or below the origin."""
    rng = RNG(v)
    seen = []
    real = filter_numpy.evaluate_f32
    for module in (filter_numpy, indexed):
        monkeypatch.setattr(module, "evaluate_f32", lambda *c: seen.append((*c[:4], real(*c)[1])) or real(*c))
    for wide, high, up in ((1, 8, 9), (8, 1, 9), (1, 8, -9), (8, 1, -9)):
        a, b = (
            batch.Polygons((ngons(rng, 500, k, 0.1) + np.array([0, up])) * [wide * scale, high * scale]) for k in (v, w)
        )
        index = np.arange(500)
        batch.relate(a, b, engine="numpy")
        batch.relate(a, b, np.c_[index, index], engine="numpy")
    assert len(seen) >= 4
    for ax, ay, bx, by, error_bound in seen:
        size = np.sqrt(error_bound.astype(float) / filter_numpy.ERROR_FACTOR_F32)
        for x, y in ((ax, ay), (bx, by)):
            assert (size * (1 + 1e-6) >= np.maximum(np.abs(x - ax[0]), np.abs(y - ay[0])).max(axis=0)).all()


@pytest.mark.parametrize("engine", ENGINES)
def test_upright_boxes_are_classified_by_their_sides_from_any_first_corner_of_each(engine, monkeypatch):
    rng = RNG(12)
    low, size = rng.integers(0, 8, (2, 2000, 2)), rng.integers(1, 6, (2, 2000, 2))
    high = low + size
    made = []
    for (x, y), (right, top) in zip(low.transpose(0, 2, 1), high.transpose(0, 2, 1)):
        around = (np.arange(4) + rng.integers(0, 4, (2000, 1))) % 4
        corners = np.stack([np.stack(c, axis=1) for c in ((x, y), (right, y), (right, top), (x, top))], axis=1)
        made.append(batch.Polygons(corners[np.arange(2000)[:, None], around]))
    gap = np.maximum(low[0] - high[1], low[1] - high[0]).max(axis=1)
    with monkeypatch.context() as patch:
        patch.setattr(narrow_phase.exact, "relations", lambda a, i, *_: np.empty(len(i)) if not len(i) else None)
        found = batch.relate(*made, engine=engine)
    assert found.tolist() == (1 - np.sign(gap)).tolist()
    assert set(found.tolist()) == {0, 1, 2}
    index = np.arange(2000)
    assert np.array_equal(batch.relate(*made, np.c_[index, index], engine=engine), found)


@pytest.mark.parametrize("scale", [2.0**-539, 2.0**-520, 2.0**-30, 1.0, 2.0**200, 2.0**510])
def test_circles_that_touch_each_other_are_exact(scale):
    rng = RNG(13)
    n = 100
    x, y, z = TRIPLES[rng.integers(0, len(TRIPLES), n)].T
    centers, own = rng.integers(-40, 40, (n, 2)), rng.integers(1, 40, n) / 8
    theirs = rng.integers(6, 9, n) * z - own  # a whole number of hypotenuses together
    others = centers + np.c_[x, y] * ((own + theirs) / z)[:, None]
    radii = np.stack([own, theirs])
    radii[:, : n // 3] *= 1 / 3
    others[: n // 3] = centers[: n // 3] + (others - centers)[: n // 3] / 3
    others[n // 3 : -n // 3] = jolt(rng, others[n // 3 : -n // 3], 1)
    a, b = batch.Circles(centers * scale, radii[0] * scale), batch.Circles(others * scale, radii[1] * scale)
    exact = [oracle.relation(p, q) for p, q in zip(scalar(a), scalar(b))]
    assert set(exact) == {0, 1, 2}
    for one, other in ((a, b), (b, a)):
        for engine in ENGINES:
            assert batch.relate(one, other, engine=engine).tolist() == exact
        p, q = one.uniform, other.uniform
        assert (1 - exact_signs.circle_gap_signs(p.x[0], p.y[0], p.r, q.x[0], q.y[0], q.r)).tolist() == exact


@pytest.mark.parametrize("scale", [1e-120, 1.0, 1e120])
def test_ordinary_circles_are_classified_by_the_filter(scale):
    rng = RNG(14)
    a, b = (batch.Circles(rng.uniform(-2, 2, (200, 2)) * scale, rng.uniform(0.1, 1, 200) * scale) for _ in "ab")
    c = batch.Polygons(ngons(rng, 200, 5) * scale)
    for other, kernel in ((b, "circles"), (c, "circle_polygons")):
        out = np.empty(200, np.int8)
        p, q = a.uniform, other.uniform
        columns = (q.x[0], q.y[0], q.r) if other is b else (q.x, q.y)
        with np.errstate(all="ignore"):
            getattr(filter_numpy, kernel)(p.x[0], p.y[0], p.r, *columns, 0, out)
        assert out.tolist() == one_by_one(a, other)


@pytest.mark.parametrize("e", [-535, -520, -450, 480, 500, 511, 514])
def test_circles_on_polygons_are_exact_at_the_ends_of_float64(e):
    rng = RNG(15)
    made = [make(rng, 30) for make in (resting_exactly, a_float_off(resting_exactly), a_float_off(resting_on_boxes))]
    for centers, radii, rings in made:
        circles, polygons = batches_from((centers * 2.0**e, radii * 2.0**e, rings * 2.0**e))
        exact = [sv.relate(p, q) for p, q in zip(scalar(circles), scalar(polygons))]
        c, p = circles.uniform, polygons.uniform
        assert (1 - circle_polygons.gap_signs(c.x[0], c.y[0], c.r, p.x, p.y)).tolist() == exact
        for engine in ENGINES:
            assert batch.relate(circles, polygons, engine=engine).tolist() == exact


@pytest.mark.parametrize(("v", "w"), [(3, 5), (20, 20), (4, 4)])
def test_a_kernel_that_begins_later_fills_in_the_relations_of_the_columns_from_there(v, w):
    rng = RNG(16)
    a, b = (batch.Polygons(ngons(rng, 100, k)).uniform for k in (v, w))
    p, q = (circles(rng, 100).uniform for _ in "ab")
    low = rng.uniform(0, 5, (2, 100, 1, 2))
    one, other = (batch.Polygons(at + np.array([(0, 0), (1, 0), (1, 1), (0, 1)])).uniform for at in low)
    round_ = p.x[0], p.y[0], p.r
    for kernel, shapes in (
        (filter_numpy.polygons, (a, b)),
        (filter_numpy.boxes, (one, other)),
        (filter_numpy.circles, (*round_, q.x[0], q.y[0], q.r)),
        (filter_numpy.circle_polygons, (*round_, b.x, b.y)),
    ):
        whole, part = np.empty(100, np.int8), np.empty(50, np.int8)
        with np.errstate(all="ignore"):
            kernel(*shapes, 0, whole)
            kernel(*shapes, 30, part)
        assert part.tolist() == whole[30:80].tolist()
        assert len(set(part.tolist())) > 1


@pytest.mark.parametrize("e", [-76, -75, -74, -73])
def test_relations_are_right_where_float32_loses_the_bits_of_products(e):
    rng = RNG(1)
    a, b = (batch.Polygons(ngons(rng, 300, 3) * 2.0**e) for _ in "ab")
    assert batch.relate(a, b, engine="numpy").tolist() == one_by_one(a, b)


@pytest.mark.parametrize("v", [3, 4, 5, 8, 9])
@pytest.mark.parametrize("n", [1, 2, 128, 129, 300])
def test_the_maxima_of_a_tile_are_its_largest_edge_component_and_coordinate(n, v):
    """This holds for batches validated by either engine, made of rings, concatenated or selected."""
    rng = RNG(n + v)
    rings = ngons(rng, n, v) * 2.0 ** rng.integers(-9, 9, (n, 1, 1))
    rings[::2] = rings[::2, ::-1]  # clockwise
    edges = np.abs(rings - np.roll(rings, 1, axis=1)).max(axis=(1, 2))
    starts = np.arange(0, n, 128)
    expected = [np.maximum.reduceat(most, starts).tolist() for most in (edges, np.abs(rings).max(axis=(1, 2)))]
    groups = [batch.Polygons(rings).uniform, batch.Polygons(list(rings)).uniform]
    groups += [batch.Polygons(rings)[::-1][::-1].uniform, batch.concat([batch.Polygons(rings)]).uniform]
    if v <= 8:  # more corners are not validated in columns
        groups += [engines.engine_of(engine).certified_group(rings) for engine in ENGINES]
    for group in groups:
        assert [most.tolist() for most in group.tile_maxima] == expected


def test_a_quadrilateral_with_only_some_upright_sides_is_no_upright_box():
    box = [(0, 0), (2, 0), (2, 1), (0, 1)]
    rings = [
        [(x + k * (i == moved), y + j * (i == moved)) for i, (x, y) in enumerate(box)]
        for moved in range(4)
        for k, j in ((0, 0), (0.5, 0), (0, 0.5))
    ]
    rings += [[(x + k * y, y + j * x) for x, y in box] for k, j in ((0.5, 0), (0, 0.5))]
    for ring in rings:
        for first in range(4):
            x, y = np.array(ring[first:] + ring[:first], float).T[:, :, None]
            assert arrays.upright_box_mask(x, y).tolist() == [ring == box]


@pytest.mark.parametrize("block", [1, 30, 100, 1000])
def test_no_ordinary_pair_needs_an_exact_sign_in_any_order(block, monkeypatch):
    rng = RNG(block)
    shapes = batch.concat([circles(rng, 50), batch.Polygons(ngons(rng, 50, 3)), batch.Polygons(ngons(rng, 50, 4))])
    index = rng.integers(0, 150, (600, 2))
    exact = [int(sv.relate(p, q)) for known in [scalar(shapes)] for p, q in ((known[i], known[j]) for i, j in index)]
    left = []
    monkeypatch.setattr(narrow_phase, "BLOCK_PAIRS", block)
    real = narrow_phase.exact.relations
    monkeypatch.setattr(narrow_phase.exact, "relations", lambda *c: left.extend(c[1]) or real(*c))
    assert batch.relate(shapes, shapes, index, engine="numpy").tolist() == exact
    assert not left


def outlines_of_many_corner_counts(rng, across):
    """Return batches of one outline each: upright boxes, a turned square, and regular outlines of up to 12 corners."""
    rings = [[(0, 0), (u, 0), (u, v), (0, v)] for u, v in rng.integers(1, 4, (4, 2))]
    rings += [[(0, 0), (2, 1), (1, 3), (-1, 2)], [(0, 0), (4, 0), (1, 3)], [(0, 0), (-1, 4), (-3, 1)]]
    rings += [3 * regular(rng, 1, v)[0] for v in (5, 6, 7, 8, 9, 12)]
    return [batch.Polygons([np.array(ring) + rng.integers(-across, across, 2)]) for ring in rings]


@pytest.mark.parametrize("engine", ENGINES)
def test_outlines_of_many_corner_counts_have_their_scalar_relation_by_index(engine):
    """There are more pairs of few, of up to eight and of more corners than an engine evaluates at a time."""
    rng = RNG(3)
    shapes = batch.concat(outlines_of_many_corner_counts(rng, 5) + outlines_of_many_corner_counts(rng, 8))
    known, every = scalar(shapes), np.argwhere(np.ones((len(shapes), len(shapes))))
    exact = np.array([int(sv.relate(known[i], known[j])) for i, j in every])
    low, high = np.split(shapes.bounds[every], 2, axis=2)
    boxes_meet = ((low[:, 0] <= high[:, 1]) & (low[:, 1] <= high[:, 0])).all(axis=1)
    most = shapes.count[every].max(axis=1)
    for these in most <= 4, (most > 4) & (most <= 8), most > 8:
        chosen = rng.choice(np.flatnonzero(these & boxes_meet), 300 if engine == "numba" else 60_000)
        assert set(exact[chosen].tolist()) >= {0, 2}
        assert np.array_equal(batch.relate(shapes, shapes, every[chosen], engine=engine), exact[chosen])
    for k in range(0, len(every), 5):
        assert batch.relate(shapes, shapes, every[k : k + 1], engine=engine) == exact[k], every[k]


@pytest.mark.parametrize("lanes", [7, 128])
def test_numba_needs_no_exact_sign_for_ordinary_pairs_by_index(lanes, monkeypatch):
    """The same holds for upright boxes, and for many corners if the middle of the common box is inside both shapes."""
    indexed_numba = kernels_of("indexed")
    real, sizes, exact = indexed_numba._evaluate_lanes, [], ("relate_few_corners", "relate_many_corners")
    as_python(monkeypatch, indexed_numba, "LANES", "_evaluate_lanes", *exact)
    monkeypatch.setattr(indexed_numba, "LANES", lanes)
    for name in exact:
        monkeypatch.setattr(indexed_numba, name, lambda *_: pytest.fail("evaluated exactly"))
    monkeypatch.setattr(exact_numpy, "relations", lambda *_: pytest.fail("left to the NumPy engine"))
    monkeypatch.setattr(indexed_numba, "_evaluate_lanes", lambda *given: sizes.append(given[10].size) or real(*given))
    box = batch.Polygons([[(5, 0), (6, 0), (6, 1), (5, 1)], [(6, 1), (7, 1), (7, 2), (6, 2)]])
    rng = RNG(2)
    index = np.r_[[(0, 1), (1, 1), (2, 0)], 2 + rng.integers(0, 30, (150, 2))]
    for v, w in product((3, 4, 6, 8, 40), repeat=2):
        a, b = (batch.concat([box, batch.Polygons(regular(rng, 30, n))]) for n in (v, w))
        assert batch.relate(a, b, index, engine="numba").tolist() == [1, 2, 0] + [2] * 150
        far = batch.concat([box, batch.Polygons(regular(rng, 30, w) + 1.8)])
        if max(v, w) <= 8:
            sizes.clear()
            assert batch.relate(a, far, index, engine="numba").tolist() == [1, 2, 0] + [0] * 150
            assert sum(sizes) == 0 if max(v, w) <= 4 else 7 < sum(sizes) < 151 and max(sizes) <= lanes
    for x, y, size in product((-0.6, 0.0, 0.6), (-0.3, 0.2), (0.1, 0.2)):
        large, small = (
            batch.Polygons(regular(rng, 1, 40) * u + [[[30 + v, 50 + w]]]) for u, v, w in ((1, 0, 0), (size, x, y))
        )
        for these in (large, small), (small, large):
            assert batch.relate(*these, [(0, 0)], engine="numba").tolist() == [2]


@pytest.mark.parametrize(("v", "w"), [(3, 3), (4, 4), (3, 4), (8, 8), (5, 3), (7, 8), (8, 5)])
def test_numba_classifies_columns_of_every_corner_count_by_their_clearances(v, w):
    """The error bounds are made so large that many clearances lie within them and the others far beyond them."""
    kernels = kernels_of("filter")
    rng, first, n = RNG(v * w), 5, 300
    error_bound = np.array([0.1, 0.2, 0.05])[np.arange(first, first + n) // arrays.TILE_SHAPES]  # one for each tile
    a, b = (rng.uniform(-1.5, 1.5, (n + first, 1, 2)) + ngons(rng, n + first, k, 0.0) for k in (v, w))
    best = np.full(n, -np.inf)
    for p, q in (a, b), (b, a):
        edges = np.roll(p, -1, axis=1) - p
        normals = np.stack([edges[..., 1], -edges[..., 0]], axis=2)[first:]
        beyond = (q[first:, None] * normals[:, :, None]).sum(axis=3).min(axis=2) - (p[first:] * normals).sum(axis=2)
        best = np.maximum(best, beyond.max(axis=1))
    out = np.full(n, 9, np.int8)
    kernels.clearance_kernel(v, w)(
        *(np.ascontiguousarray(c) for s in (a, b) for c in s.transpose(2, 1, 0)),
        first,
        np.array([0.1, 0.2, 0.05]),
        out,
    )
    assert out.tolist() == np.select([best > error_bound, best < -error_bound], [0, 2], UNDECIDED).tolist()
    assert min((out == relation).sum() for relation in (0, 2, UNDECIDED)) > 10


@pytest.mark.parametrize(("v", "w"), [(16, 3), (3, 16), (17, 3), (3, 17), (16, 16), (17, 17)])
def test_edges_of_outlines_by_index_are_evaluated_only_where_float32_or_gjk_leaves_them_undecided(v, w, monkeypatch):
    filters, left, widths = [], [], []
    for module, name in (indexed, "evaluate_f32"), (indexed.gjk, "gjk"):
        real = getattr(module, name)
        monkeypatch.setattr(
            module, name, lambda *c, name=name, real=real: filters.append(name) or widths.append(c[4]) or real(*c)
        )
    real = indexed.relate_edges
    monkeypatch.setattr(indexed, "relate_edges", lambda a, b: left.append(a.x.shape[1]) or real(a, b))
    rng = RNG(v)
    a, b, far = (batch.Polygons(regular(rng, 20, n) + move) for n, move in ((v, 0), (w, 0), (w, 9)))
    p, q = (batch.Polygons(rings[:20]) for rings in beside_mirror(v, w))
    for one, other, exact, undecided in (a, b, 2, 0), (a, far, 0, 0), (p, q, 1, 20):
        left.clear()
        out = np.full(20, 9, np.int8)
        indexed.relations(one.flat, np.arange(20), other.flat, np.arange(20), out)
        assert out.tolist() == [exact] * 20 and sum(left) == undecided
    if max(v, w) <= 16:
        wide = [(s.bounds[:, 2:] - s.bounds[:, :2]).max(axis=1) for s in (a, b)]
        assert np.array_equal(widths[0], wide[0] + wide[1])
    assert set(filters) == {"evaluate_f32" if max(v, w) <= 16 else "gjk"}


def test_columns_of_three_and_four_corners_have_kernels_of_their_own():
    kernels = kernels_of("filter")
    own = {(v, w): kernels.clearance_kernel(v, w) for v in (3, 4) for w in (3, 4)}
    assert len({kernels._tile_kernel, *own.values()}) == 5
    assert all(kernels.clearance_kernel(*key) is own[key] for key in own)
    for key in (4, 5), (5, 4), (5, 5), (3, 8), (8, 3), (8, 8), (8, 7), (7, 8), (7, 7), (9, 9):
        assert kernels.clearance_kernel(*key) is kernels._tile_kernel


def test_circle_polygon_kernels_are_specialised_up_to_eight_corners(monkeypatch):
    kernels = kernels_of("filter")
    used = []
    monkeypatch.setattr(kernels, "_circle_unrolled", lambda n: used.append(n) or (lambda *_: None))
    monkeypatch.setattr(kernels, "_circle_general", lambda *_: used.append("any"))
    for corners in (3, 8, 9):
        kernels.circle_polygons(*[np.zeros(1)] * 3, *[np.zeros((corners, 1))] * 2, 0, np.zeros(1, np.int8))
    assert used == [3, 8, "any"]


@pytest.mark.parametrize("scale", [1.0, 2.0**-90])
@pytest.mark.parametrize(("v", "w"), [(3, 3), (4, 4), (3, 8), (8, 8), (8, 5), (9, 5), (12, 12)])
def test_numba_evaluates_undecided_columns_exactly_and_leaves_the_others_unchanged(v, w, scale):
    indexed_numba = kernels_of("indexed")
    a, touching = beside_mirror(v, w)
    for move in (0, 1, -1):
        p = batch.Polygons(a[:8] * scale)
        q = batch.Polygons((touching[:8] + np.array([move, 0.0])) * scale)
        exact = one_by_one(p, q)
        out = np.array([UNDECIDED, 7, UNDECIDED, UNDECIDED, 5], np.int8)
        indexed_numba.exact_columns(p.uniform, q.uniform, 3, out)
        assert out.tolist() == [exact[3], 7, *exact[5:7], 5]


@pytest.mark.parametrize("scale", [1.0, 2.0**-90])
@pytest.mark.parametrize(("v", "w"), [(3, 3), (4, 4), (3, 8), (8, 8), (8, 5), (9, 5), (12, 12)])
@pytest.mark.parametrize("engine", ENGINES)
def test_touching_pairs_by_index_are_classified_as_touching(v, w, scale, engine):
    a, touching = beside_mirror(v, w)
    p, q = batch.Polygons(a[:8] * scale), batch.Polygons(touching[:8] * scale)
    for one, other in (p, q), (q, p):
        found = batch.relate(one, other, np.repeat(np.arange(8)[:, None], 2, axis=1), engine=engine)
        assert found.tolist() == one_by_one(one, other) == [1] * 8


@pytest.mark.parametrize("w", [4, 7])  # one by one and in lanes
@pytest.mark.parametrize("e", [-600, -100, 0, 100, 400, 600])
def test_error_bounds_of_pairs_by_index_in_numba_follow_from_their_widths_and_largest_coordinates(e, w, monkeypatch):
    indexed_numba = kernels_of("indexed")
    as_python(monkeypatch, indexed_numba, "_error_bound")
    real, found = indexed_numba._error_bound, {}

    def seen(box_a, i, box_b, j):
        found[i, j] = real(box_a, i, box_b, j)
        return found[i, j]

    monkeypatch.setattr(indexed_numba, "_error_bound", seen)
    rng = RNG(7)
    a, b = (batch.Polygons((ngons(rng, 40, v, 2) * rng.uniform(0.2, 5, (40, 1, 2))) * 2.0**e) for v in (3, w))
    index = rng.integers(0, 40, (200, 2))
    batch.relate(a, b, index, engine="numba")
    boxes = a.bounds[index[:, 0]], b.bounds[index[:, 1]]
    wide = sum((c[:, 2:] - c[:, :2]).max(axis=1) for c in boxes)
    with np.errstate(all="ignore"):
        error_bound = wide * sum(np.abs(c).max(axis=1) for c in boxes) * ERROR_FACTOR_F64
    in_range = (error_bound > MIN_ERROR_BOUND) & (error_bound < MAX_ERROR_BOUND)
    expected = dict(zip(map(tuple, index.tolist()), np.where(in_range, error_bound, np.inf).tolist()))
    assert len(found) > 20 and all(found[pair] == expected[pair] for pair in found)
    assert np.isinf(list(expected.values())).all() == (abs(e) == 600)


def test_hits_takes_the_arguments_of_relate():
    a = batch.Circles([(0, 0), (3, 0), (5, 0)], 1)
    with pytest.raises(ValueError, match="engine is 'none'"):
        batch.hits(a, a, engine="none")
    reported = []
    options = {"engine": "numpy", "executor": Elsewhere(), "chunk": 1, "progress": lambda *at: reported.append(at)}
    found = batch.hits(a, a, [[0, 1], [1, 2]], **options)
    assert found.tolist() == [False, True] and reported == [(1, 2), (2, 2)]


@pytest.mark.parametrize("engine", ENGINES)
def test_upright_boxes_need_no_exact_sign(engine, monkeypatch):
    x, y = (c.ravel() * 0.1 for c in np.meshgrid(np.arange(20), np.arange(20)))
    tiles = np.stack([np.stack(c, axis=1) for c in ((x, y), (x + 0.1, y), (x + 0.1, y + 0.1), (x, y + 0.1))], axis=1)
    known = [sv.Polygon(tile) for tile in tiles]
    diamond = [(9, 8), (10, 9), (9, 10), (8, 9)]
    alone, beside = batch.Polygons(tiles), batch.Polygons([*tiles, diamond])
    selected = beside[::-1][1:][::-1]
    evaluated = []
    for module in (exact_signs, sv.engine.relate):
        monkeypatch.setattr(module, "orient", lambda *c: evaluated.append(c))
    for shapes in (alone, selected):
        pairs = batch.candidate_pairs(shapes.bounds)
        found = batch.relate(shapes, shapes, pairs, engine=engine)
        assert found.tolist() == [sv.relate(known[i], known[j]) for i, j in pairs]
        assert batch.colliding_pairs(shapes, engine=engine).tolist() == pairs.tolist()
    assert not evaluated
