"""Tests of the broad phase: candidate pairs and colliding pairs of boxes of every size at every place."""

import importlib
import pickle
import sys
import tracemalloc

import numpy as np
import pytest
from batches import ELL, ENGINES, RNG, Elsewhere, as_python, circles, kernels_of, ngons, scalar

import satviz as sv
from satviz import batch
from satviz.batch import collide, engines
from satviz.batch.with_numpy import grid as grid_numpy

broad_phase = importlib.import_module("satviz.batch.broad_phase")


def all_candidates(bounds):
    """Return the pairs of boxes that overlap or touch, found by comparing all."""
    i, j = np.triu_indices(len(bounds), 1)
    p, q = bounds[i], bounds[j]
    return np.stack([i, j], axis=1)[((p[:, :2] <= q[:, 2:]) & (q[:, :2] <= p[:, 2:])).all(axis=1)]


def layouts(n, rng):
    """Yield layouts of n boxes as (name, lower corners, sizes)."""
    at, size = rng.uniform(0, np.sqrt(n) * 1.5, (n, 2)), rng.uniform(0.3, 1, (n, 2))
    yield "even", at, size
    yield "whole numbers", np.floor(at), np.ceil(size)
    yield "thousandfold sizes", at * 6, 10 ** rng.uniform(-1.5, 1.5, (n, 1)) * size
    large = size.copy()
    large[0] = 1000
    yield "one large", at, large
    yield "one cell", np.r_[[[0.0, 0.0]], rng.uniform(0, 1e-3, (n - 1, 2))], np.r_[[[1.0, 1.0]], size[1:] * 1e-6]
    yield "all meet", at * 1e-9, size
    stack = np.c_[np.zeros(n), np.arange(n) * 0.01]
    yield "needles", stack, np.tile([1000.0, 0.005], (n, 1))
    yield (
        "crossed needles",
        np.r_[stack[::2], stack[1::2, ::-1] - [0, 5]],
        np.r_[np.tile([1000.0, 0.005], (len(stack[::2]), 1)), np.tile([0.005, 1000.0], (len(stack[1::2]), 1))],
    )
    yield "range of 1e300", rng.uniform(-1, 1, (n, 2)) * 1e300, size * 1e300 / np.sqrt(n)
    yield "one at 1e300", np.r_[[[1e300, -1e300]], at[1:]], np.r_[[[1e285, 1e285]], size[1:]]
    yield "every scale", (wide := 10 ** rng.uniform(-300, 300, (n, 2))), wide * rng.uniform(0.01, 0.1, (n, 2))
    yield "points", np.floor(at), np.zeros((n, 2))
    crowd = rng.random((n, 1)) < 0.6
    yield "a crowd in a wide field", np.where(crowd, np.floor(at) * 2, at * 1e9), np.ones((n, 2))
    far = 2.0 ** rng.choice((32, 50, 52, 53, 60))
    rows = rng.integers(-1, 2, (n, 1)) * np.spacing(far)
    yield "flat and far away", np.c_[at[:, :1], far + rows], np.c_[size[:, :1], np.zeros(n)]


@pytest.mark.parametrize("n", [2, 300])
def test_candidate_pairs_are_the_boxes_that_meet_in_every_layout(n):
    for name, at, size in layouts(n, RNG(n)):
        bounds = np.c_[at, at + size]
        for engine in ENGINES:
            assert np.array_equal(batch.candidate_pairs(bounds, engine=engine), all_candidates(bounds)), (name, engine)


@pytest.mark.parametrize("engine", ENGINES)
def test_candidates_are_found_in_every_block(engine):
    """The boxes form more pairs than the grid evaluates at a time."""
    at = RNG(1).uniform(0, 1, (1800, 2))
    bounds = np.c_[at, at + 0.9]
    pairs = all_candidates(bounds)
    assert len(pairs) > 1 << 20
    assert np.array_equal(batch.candidate_pairs(bounds, engine=engine), pairs)


def in_cells(rng):
    """Return boxes of similar sizes, indices of one half and of the other, and the size of a grid's cells.

    The boxes cover a few cells, near 0 or far from it. Some sides lie one float beside the borders of cells, so
    that rounding moves lengths and places across them.
    """
    n, (wide, high) = int(rng.integers(4, 40)), 2.0 ** rng.integers(-2, 7, 2)
    low = rng.integers(-100, 100, (n, 2)) + rng.choice([0, 0, 1000, -1000], 2)
    sides = np.hstack([low, low + rng.integers(0, rng.choice([3, 40, 400]), (n, 2))]) * rng.choice(
        [1, 1, 0.1, 1e-300, 2.0**40]
    )
    step = max(np.abs(sides).max() / rng.choice([100, 128]), 5e-324)
    if rng.random() < 0.5:
        sides = np.nextafter(sides, rng.choice([-np.inf, np.inf], (n, 1)))
        step = 2.0 ** np.floor(np.log2(step))
    order = rng.permutation(n)
    return sides, order[::2], order[1::2], (wide * step, high * step)


@pytest.mark.parametrize("seed", range(12))
@pytest.mark.parametrize("engine", ENGINES)
def test_cells_of_any_size_find_each_candidate_pair_once(engine, seed, monkeypatch):
    grid, rng = importlib.import_module(f"satviz.batch.with_{engine}.grid"), RNG(seed)
    for n in range(16):
        monkeypatch.setattr(grid, "BLOCK_PAIRS", int(rng.choice([1, 7, 1 << 20])))
        bounds, one, other, cell = in_cells(rng)
        everything, all_pairs = np.arange(len(bounds)), all_candidates(bounds)
        for these, those in (everything, None), (one, other), (everything[1:], everything[:1]):
            expected = all_pairs if those is None else all_pairs[np.isin(all_pairs, those).sum(axis=1) == 1]
            found = np.concatenate([np.empty((0, 2), int), *grid.meeting_pairs(bounds, these, those, cell, np.inf)])
            assert np.array_equal(found[np.lexsort(found.T[::-1])], expected), n


def engine_with_grid(grid):
    """Return an engine that finds all candidates by this grid, also those of few boxes."""
    return engines.engine_of("numpy")._replace(grid=grid, candidate_pairs=lambda _: (None, None, None))


@pytest.mark.parametrize("seed", range(6))
def test_boxes_with_too_many_candidates_are_split_until_similar_and_compared_once_each(seed):
    rng, sets = RNG(seed), []
    low = rng.uniform(-100, 100, (60, 2))
    bounds = np.hstack([low, low + 2.0 ** rng.uniform(0, [3, 20] if seed % 2 else [20, 3], (60, 2))])
    if seed >= 3:  # half of them of one size, which no split can part
        bounds[::2, 2:] = bounds[::2, :2] + [[2.0**-20, 1, 2.0**30][seed - 3]]
    size, farthest = bounds[:, 2:] - bounds[:, :2], np.abs(bounds).max()

    def too_many(given, one, other, cell, most):
        """Refuse every set of boxes that can still be split."""
        assert given is bounds or np.array_equal(given, bounds)
        both = one if other is None else np.concatenate([one, other])
        assert most in (broad_phase.MAX_CANDIDATES_PER_BOX * len(both), np.inf)
        if most == np.inf:
            assert np.array_equal(cell, size[both].max(axis=0)) and min(cell) > farthest * broad_phase.FINE
            sets.append((one, other))
            return iter(())
        even = [broad_phase._cell_size_if_even(bounds[:, d], both) for d in (0, 1)]
        assert np.array_equal(cell, np.maximum(size[both].max(axis=0), even))
        return None

    assert list(broad_phase.candidate_blocks(bounds, engine_with_grid(too_many))) == []
    times = np.zeros((60, 60), int)
    for one, other in sets:
        assert len(one) and (other is None or len(other))
        if other is None:
            times[np.ix_(one, one)] += 1
        else:
            times[np.ix_(one, other)] += 1
            times[np.ix_(other, one)] += 1
        for d in (0, 1):
            larger = max((one, one if other is None else other), key=lambda ids: size[ids, d].max())
            assert size[larger, d].max() <= broad_phase.MAX_UNSPLIT_RATIO * size[larger, d].min()
    assert (times[~np.eye(60, dtype=bool)] == 1).all()
    assert 3 < len(sets) < 400


@pytest.mark.parametrize(("x", "y"), [(1e9, 3), (-1e9, 3), (2, 1e9), (2, -1e9), (-1e9, -5), (0.25, 0.5), (-0.25, 0)])
def test_grid_cells_for_equal_boxes_are_the_smallest_with_distinct_cell_numbers(x, y):
    cells = []
    bounds = np.tile([x, y, x, y], (20, 1)).astype(float)
    assert list(broad_phase.candidate_blocks(bounds, engine_with_grid(lambda *given: cells.append(given[3:])))) == []
    far = max(abs(x), abs(y))
    assert cells == [([far * 2.0**-1000] * 2, broad_phase.MAX_CANDIDATES_PER_BOX * 20), ([far * 2.0**-48] * 2, np.inf)]


@pytest.mark.parametrize("n", [100, 3000])
def test_the_cell_size_follows_from_the_middle_half_of_the_boxes(n):
    """Outliers do not change it, and it stays finite where the middle half is wider than the float range."""
    low = np.sort(RNG(n).permutation(n) + 0.5) * (7 / n) - 3
    which = RNG(1).permutation(n)
    assert broad_phase._cell_size_if_even(low, which) == pytest.approx(7 / np.sqrt(n), rel=0.1)
    low[: n // 5], low[-n // 5 :] = -1e300, 1e300
    assert broad_phase._cell_size_if_even(low, which) == pytest.approx(7 / np.sqrt(n), rel=0.1)
    assert broad_phase._cell_size_if_even(low, which[: n // 2]) == pytest.approx(7 / np.sqrt(n / 2), rel=0.4)
    low[: n // 2], low[n // 2 :] = -MOST, MOST
    assert 0 < broad_phase._cell_size_if_even(low, which) < np.inf
    assert 0 < broad_phase._cell_size_if_even(np.array([-MOST, -MOST, 0, MOST, MOST]), np.arange(5)) < np.inf
    assert broad_phase._cell_size_if_even(np.zeros(n), which) == 0


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("swap", [[0, 1, 2, 3], [1, 0, 3, 2]])
def test_a_rounded_length_hides_no_box_that_begins_a_float_before_the_border_of_its_cells(engine, swap):
    grid, rng = importlib.import_module(f"satviz.batch.with_{engine}.grid"), RNG(6)
    for border in np.arange(-20, 20) / 4:
        begins = np.nextafter(border, -np.inf)
        for end in (border + 1, *(rng.choice([0, border + 1, border + 0.5]) + rng.integers(0, 40, 3) * 2.0**-55)):
            bounds = np.array([[begins, 0, max(end, border), 1], [max(end, border), 0, border + 5, 1]])[:, swap]
            for one, other in (([0, 1], None), ([0], [1]), ([1], [0])):
                sets = (np.array(ids) if ids else None for ids in (one, other))
                (found,) = grid.meeting_pairs(bounds, *sets, (0.25, 0.25), np.inf)
                assert found.tolist() == [[0, 1]], (border, end)


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("about", [0, 1])
def test_boxes_so_far_apart_that_numbers_of_cells_multiplied_overflow_are_found(engine, about):
    """Two boxes are in the last cell of a row of 2**32 cells, in row 2**31: the next cell number would be 2**63."""
    grid = importlib.import_module(f"satviz.batch.with_{engine}.grid")
    low = np.array([(0, 0), (2**32 - 3, 2**31 - 2), (2**32 - 3, 2**31 - 2)]) - np.array([2**31, 2**30]) * about
    (found,) = grid.meeting_pairs(np.hstack([low, low + 1.0]), np.arange(3), None, (1.0, 1.0), np.inf)
    assert found.tolist() == [[1, 2]]


def test_the_grid_of_numpy_keeps_no_table_of_cells_that_are_nearly_all_empty():
    x = np.arange(2000.0)
    bounds = np.c_[x, x, x + 1, x + 1] * 2
    tracemalloc.start()
    assert list(grid_numpy.meeting_pairs(bounds, np.arange(2000), None, (1.0, 1.0), np.inf)) != []
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 2e6


@pytest.mark.parametrize("seed", range(4))
def test_the_grid_of_numba_counts_the_candidates_in_cells_that_it_compares(seed, monkeypatch):
    grid, rng = kernels_of("grid"), RNG(seed)
    as_python(monkeypatch, grid, "_stored_range", "_cell_number")
    real, ranges = grid._stored_range, []
    monkeypatch.setattr(grid, "_stored_range", lambda *given: ranges.append(real(*given)) or ranges[-1])
    for _ in range(15):
        bounds, one, other, cell = in_cells(rng)
        size = 1 << int(3 * len(other) // 2).bit_length()
        table = grid.build_table(bounds, other, *cell, size)
        count = grid.count_candidates(bounds[one], False, table)
        ranges.clear()
        pairs = sum(map(len, grid._pair_blocks(one, bounds[one], False, table, 100)))
        assert count == sum(last - first for first, last in ranges) >= pairs
        assert grid.meeting_pairs(bounds, one, other, cell, count) is not None
        assert count == 0 or grid.meeting_pairs(bounds, one, other, cell, count - 1) is None
        # a set with itself is compared in the rows from a box's own on, so the count is larger than needed
        table = grid.build_table(bounds, one, *cell, size)
        count = grid.count_candidates(bounds[one], True, table)
        ranges.clear()
        pairs = sum(map(len, grid._pair_blocks(table[1], table[2], True, table, 100)))
        compared = sum(last - first for first, last in ranges)
        assert 2 * compared + 9 * len(one) >= count >= compared >= pairs


def test_the_grid_of_numba_estimates_the_candidates_of_many_boxes_from_a_sample(monkeypatch):
    grid = kernels_of("grid")
    x, y = (c.ravel()[:1000] for c in np.meshgrid(np.arange(33.0), np.arange(33.0)))
    bounds = np.c_[x, y, x + 1, y + 1]
    table = grid.build_table(bounds, np.arange(1000), 1.0, 1.0, 2048)
    queried = []
    as_python(monkeypatch, grid, "_first_cell")
    monkeypatch.setattr(grid, "_first_cell", lambda *given: queried.append(given) or 0)
    for n, each in ((999, 1), (1000, grid.SAMPLE_STEP)):
        queried.clear()
        grid.count_candidates(bounds[:n], False, table)
        assert len(queried) == 2 * -(-n // each)
    monkeypatch.undo()
    exact, estimate = grid.count_candidates(bounds[:999], True, table), grid.count_candidates(bounds, True, table)
    assert 0.9 < estimate / exact < 1.1


def test_the_grid_of_numpy_compares_a_box_only_with_those_in_cells_that_it_can_meet():
    rng = RNG(5)
    for _ in range(60):
        bounds, one, other, cell = in_cells(rng)
        longest = (bounds[other, 2:] - bounds[other, :2]).max(axis=0)
        first, last = np.floor((bounds[one, :2] - longest) / cell), np.floor(bounds[one, 2:] / cell)
        own = np.floor(bounds[other, :2] / cell)[:, None]
        count = int(((first <= own) & (own <= last)).all(axis=2).sum())
        wider = int(((first - 1 <= own) & (own <= last)).all(axis=2).sum())  # if the subtracted length is rounded up
        assert grid_numpy.meeting_pairs(bounds, one, other, cell, wider) is not None
        assert count == 0 or grid_numpy.meeting_pairs(bounds, one, other, cell, count - 1) is None


TURNED = -6.123233995736766e-17  # a quarter turn computes this coordinate instead of 0


@pytest.mark.parametrize(
    "places",
    [
        lambda rng, n, step: rng.integers(-5, 5, (n, 2)) * step,
        lambda rng, n, step: np.cumsum(np.full((n, 2), step), axis=0) - step * rng.integers(0, 9),  # tiles by sums
        lambda rng, n, step: rng.choice([0, TURNED, -TURNED, -1e-17, 1, -1], (n, 2)) * rng.choice([1, step], (n, 1)),
        lambda rng, n, step: rng.integers(-5, 5, (n, 2)) * step + rng.choice([1e5, 1e9, 1e15]),
        lambda rng, n, step: rng.normal(0, 1, (n, 2)) * 10.0 ** rng.integers(-200, 200, (n, 1)),
    ],
    ids=["a grid", "sums", "quarter turns", "far away", "every size"],
)
@pytest.mark.parametrize("step", [1.0, 0.1, 1 / 3, 1e-9, 7e200, 1e-300])
def test_boxes_that_touch_only_by_rounding_are_candidates(places, step):
    rng = RNG(8)
    for _ in range(60):
        n = int(rng.integers(2, 40))
        low = places(rng, n, step)
        bounds = np.hstack([low, low + rng.choice([0, step, 2 * step, 1000 * step, 1e-17, 1], (n, 2))])
        for engine in ENGINES:
            assert np.array_equal(batch.candidate_pairs(bounds, engine=engine), all_candidates(bounds))


def test_a_width_that_rounds_down_to_the_cell_hides_no_touch():
    assert batch.candidate_pairs([[-1e-17, 0, 1, 1], [1, 0, 2, 1]]).tolist() == [[0, 1]]
    x, y = (c.ravel() for c in np.meshgrid(np.arange(40), np.arange(40)))
    corners = np.stack([x, y, x + 1, y + 1], axis=1) - 20
    for turned in (corners * 1.0, corners * 0.1, corners + TURNED, np.where(corners == 0, TURNED, corners)):
        bounds = turned.astype(float)
        expected = all_candidates(bounds)
        for engine in ENGINES:
            assert np.array_equal(batch.candidate_pairs(bounds, engine=engine), expected)


MOST = sys.float_info.max


def any_boxes(rng):
    """Return boxes of one of six kinds.

    They have sizes and places over the whole range of float64, or are points, sums of tenths, needles or far away.
    """
    n = int(rng.integers(1, 120))
    decades = lambda low, high, *shape: 10.0 ** rng.uniform(low, high, shape)  # noqa: E731
    low, wide = rng.uniform(0, 30, (n, 2)), rng.uniform(0, 1, (n, 2))
    match rng.integers(0, 6):
        case 0:
            low, wide = rng.choice([-1, 1], (n, 2)) * decades(-320, 308, n, 2), decades(-320, 308.2, n, 2)
        case 1:
            low, wide = low * decades(-300, 300, n, 1), wide * rng.choice([1e-320, 1e-9, 1, MOST], (n, 1))
        case 2:
            low, wide = low + rng.choice([0, 1e9, -1e16]), wide * decades(-3, 3, n, 1)
        case 3:
            low, wide = np.floor(low / 5), np.zeros((n, 2))
        case 4:
            wide = np.where(rng.random((n, 1)) < 0.5, [[100, 1e-6]], [[1e-6, 100]])
        case 5:
            low, wide = np.cumsum(rng.choice([0, 0.1, 0.3], (n, 2)), axis=0) - 3, rng.choice([0.1, 0.3, 0.2], (n, 2))
    with np.errstate(over="ignore"):
        return np.clip(np.hstack([low, low + wide]), -MOST, MOST)


@pytest.mark.parametrize("engine", ENGINES)
def test_candidate_pairs_are_the_boxes_that_meet_of_every_size_at_every_place(engine):
    rng = RNG(9)
    for _ in range(300):
        bounds = any_boxes(rng)
        assert np.array_equal(batch.candidate_pairs(bounds, engine=engine), all_candidates(bounds)), bounds.tolist()


def test_circles_that_reach_beyond_float64_collide_with_what_they_reach():
    coins = batch.Circles([(1.7e308, 1e300), (1.6e308, 0), (0, 0), (-1.7e308, 1)], [1e307, 1e308, 1, 2e306])
    known = scalar(coins)
    expected = [[i, j] for i in range(4) for j in range(i + 1, 4) if sv.relate(known[i], known[j])]
    assert expected and batch.colliding_pairs(coins).tolist() == expected


@pytest.mark.parametrize("engine", ENGINES)
def test_candidate_pairs_are_found_also_where_numpy_raises_on_underflow(engine):
    low = [[0, 0, 1, 1], [1, 0, 2, 1e-320], [5e-324, 0, 1e-300, 1e300]]
    with np.errstate(all="raise"):
        assert batch.candidate_pairs(low, engine=engine).tolist() == [[0, 1], [0, 2]]
        for bounds in [[0, 0, 0, 0], [1e-9, 0, 1e-9, 0], [5e-324, 0, 1e-300, 0]], [[-MOST, -MOST, MOST, MOST]] * 2:
            found = batch.candidate_pairs(bounds, engine=engine)
            assert len(found) == (len(bounds) == 2)


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize("finer", [0, 6, 12])
def test_the_grid_compares_few_rows_of_flat_boxes_where_neighboring_floats_are_many_cells_apart(
    finer, side, monkeypatch
):
    far, step, rows, real = side * 2.0**32, 2.0**-20, [], grid_numpy._pair_blocks
    assert abs(np.spacing(far)) == step
    x, s = np.arange(400.0) * 1e-3, 2e6 + np.arange(1600.0) * 20
    long = np.c_[x, np.full(400, far), x + 1e6, np.full(400, far)]
    short = np.c_[s, np.zeros(1600), s, np.full(1600, step * 2.0**-finer)]
    long[0, 1::2] += step
    short[0, 1::2] = far + step
    monkeypatch.setattr(grid_numpy, "_pair_blocks", lambda *given: rows.append(len(given[-1])) or real(*given))
    bounds = np.r_[long, short]
    kernels = engines.engine_of("numpy")._replace(candidate_pairs=lambda _: (None, None, None))  # also of few boxes
    found = broad_phase.sort_pairs(list(broad_phase.candidate_blocks(bounds, kernels)))
    assert np.array_equal(found, all_candidates(bounds))
    assert max(rows) <= 4


def test_pairs_keep_their_order_where_an_index_has_32_bits():
    found = broad_phase.sort_pairs([np.array([[50_000, 60_000], [1, 2]], np.int32)])
    assert found.tolist() == [[1, 2], [50_000, 60_000]]


def test_the_grid_of_numba_finds_all_pairs_of_few_boxes_also_where_its_sample_misleads():
    """Each second cell of a row has 16 boxes, so that every 17th box, which is sampled, meets no other box."""
    grid, n = kernels_of("grid"), 17 * 300
    place = np.arange(n) // 17 * 6 + np.where(np.arange(n) % 17, 3.1, 0.1)
    bounds = np.stack([place, 0 * place, place + 0.8, 0 * place + 1], axis=1)
    pairs = np.stack(np.triu_indices(16, 1), axis=1) + np.arange(1, n, 17)[:, None, None]
    table = grid.build_table(bounds, np.arange(n), 0.8, 1.0, 1 << 14)
    assert grid.count_candidates(table[2], True, table) == n  # the estimate: each meets itself only
    for engine in ENGINES:
        assert np.array_equal(batch.candidate_pairs(bounds, engine=engine), pairs.reshape(-1, 2))


def test_the_grid_of_numba_takes_few_blocks_also_where_its_estimate_is_zero():
    """Each box stands in a cell of its own and each query touches it there, but the sampled ones find empty cells."""
    grid, k = kernels_of("grid"), np.arange(17 * 300)
    places, sizes = np.r_[k + 0.25, k + 0.5], np.full(2 * len(k), 0.25)
    bounds = np.stack([places, 0 * places, places + sizes, sizes], axis=1)
    stored = k[k % grid.SAMPLE_STEP > 0]
    blocks = [*grid.meeting_pairs(bounds, (k + len(k)).astype(np.int32), stored.astype(np.int32), (1.0, 1.0), 0)]
    assert np.array_equal(np.concatenate(blocks), np.stack([stored, stored + len(k)], axis=1))
    assert len(blocks) < 10


def test_candidate_pairs_accept_few_boxes_and_refuse_invalid_ones():
    assert batch.candidate_pairs(np.empty((0, 4))).shape == (0, 2)
    assert batch.candidate_pairs([[0, 0, 1, 1]]).shape == (0, 2)
    for bad, words in (
        (np.zeros((2, 3)), "expected \\(N, 4\\)"),
        ([[0, 0, -1, 1]], "bounds\\[0\\]"),
        ([[0, 0, 1, np.nan]], "0"),
    ):
        with pytest.raises(ValueError, match=words):
            batch.candidate_pairs(bad)


@pytest.mark.parametrize("engine", ENGINES)
def test_the_comparisons_of_the_grid_grow_linearly_with_shapes_and_pairs(monkeypatch, engine):
    grid = importlib.import_module(f"satviz.batch.with_{engine}.grid")
    counts, real = [], grid._pair_blocks

    def counted(queries, boxes, *more):
        if engine == "numpy":
            counts.append(sum(int(many.sum()) for _, _, many in more[-1]))
        else:
            counts.append(grid.count_candidates(boxes, *more[:2]))
        return real(queries, boxes, *more)

    monkeypatch.setattr(grid, "_pair_blocks", counted)
    for name, at, size in layouts(1500, RNG(5)):
        if name == "every scale":  # 600 decades of sizes: as many size classes as shapes
            continue
        counts.clear()
        kernels = engines.engine_of(engine)._replace(candidate_pairs=lambda _: (None, None, None))  # also of few boxes
        found = sum(map(len, broad_phase.candidate_blocks(np.c_[at, at + size], kernels)))
        assert 0 < sum(counts) <= 5 * broad_phase.MAX_CANDIDATES_PER_BOX * (1500 + found), (name, sum(counts), found)


def test_colliding_pairs_are_those_found_by_testing_every_pair():
    rng = RNG(8)
    shapes = batch.concat(
        [batch.Polygons(ngons(rng, 60, 3, 8)), circles(rng, 40, 8), batch.Polygons(ngons(rng, 30, 7, 8))]
    )
    known = scalar(shapes)
    expected = [(i, j) for i in range(130) for j in range(i + 1, 130) if sv.relate(known[i], known[j])]
    assert batch.colliding_pairs(shapes).tolist() == [list(p) for p in expected]


BOX, KITE, WEDGE = map(np.array, ([(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 0), (1, -1), (2, 0), (1, 1)], ELL[:3]))


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("come", ["as one list", "out of a larger one", "one by one"])
@pytest.mark.parametrize("kinds", [[BOX], [KITE], [BOX, KITE], [KITE, BOX], [BOX, WEDGE], [WEDGE, BOX], [KITE, WEDGE]])
def test_the_grid_alone_decides_only_where_all_are_upright_boxes(engine, come, kinds, monkeypatch):
    calls, real = [], collide.hits
    monkeypatch.setattr(collide, "hits", lambda *args, **options: calls.append(args) or real(*args, **options))
    rings = [kinds[i % len(kinds)] + at for i, at in enumerate(RNG(3).uniform(0, 8, (30, 2)))]
    known = [sv.Polygon(ring) for ring in rings]
    expected = [[i, j] for i in range(30) for j in range(i + 1, 30) if sv.relate(known[i], known[j])]
    if come == "one by one":
        shapes = batch.concat([batch.Polygons([ring]) for ring in rings])
    elif come == "as one list":
        shapes = batch.Polygons(rings)
    else:
        shapes = batch.Polygons([WEDGE, *rings])[1:]
    # with a chunk size, few shapes go through the grid as many do
    assert batch.colliding_pairs(shapes, engine=engine, chunk=1000).tolist() == expected
    assert bool(calls) == (len(kinds) > 1 or kinds[0] is not BOX)
    assert batch.colliding_pairs(shapes, engine=engine).tolist() == expected


def test_colliding_pairs_use_the_given_engine_executor_and_progress():
    rings = ngons(RNG(2), 60, 3, 6)
    expected = batch.colliding_pairs(batch.Polygons(rings), engine="numpy").tolist()
    for strip in (0, 20, 60):
        pool, reported = Elsewhere(), []
        options = {"engine": "numpy", "executor": pool, "progress": lambda *at: reported.append(at)}  # noqa: B023
        if strip:
            blocks = list(batch.stream_colliding_pairs(rings, strip=strip, **options))
            found = np.concatenate(blocks)[np.lexsort(np.concatenate(blocks).T[::-1])]
            assert reported == [(k + 1, 60 // strip) for k in range(60 // strip)]
        else:
            found = batch.colliding_pairs(batch.Polygons(rings), chunk=10, **options)
            assert len(reported) == len(pool.sent) > 1 and reported[0][0] == 10
        assert found.tolist() == expected
        assert pool.sent and {pickle.loads(sent)[1][-1] for sent in pool.sent} == {"numpy"}


def test_upright_boxes_alone_need_no_evaluation_beyond_the_grid():
    boxes = RNG(2).uniform(0, 5, (30, 1, 2)) + np.array([(0, 0), (1, 0), (1, 1), (0, 1)])
    pool = Elsewhere()
    found = batch.colliding_pairs(batch.Polygons(boxes), executor=pool, engine="numpy")
    assert len(found) and not pool.sent
