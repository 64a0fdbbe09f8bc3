"""Scenes of up to some twenty shapes: every way through the kernels for few shapes, and how much work it takes.

Kernels run as Python where a test replaces a limit of theirs or counts what they read.
"""

from fractions import Fraction
from functools import cache
from itertools import combinations, groupby, pairwise, product

import numpy as np
import pytest
from batches import ENGINES, RNG, in_python, kernels_of, numba_modules, regular
from oracle import relation
from test_batch_few import any_bounds, meeting
from test_batch_padded import padded

import satviz as sv
from satviz import batch
from satviz.batch import arrays, broad_rule, constructors, engines
from satviz.batch.codes import APART, OVERLAPPING, TOUCHING, UNDECIDED


@pytest.fixture
def few(monkeypatch):
    """The kernels for few shapes, all kernels of numba as Python."""
    for m in numba_modules():
        for name, value in [*vars(m).items()]:
            monkeypatch.setattr(m, name, in_python(value))
    filters = kernels_of("filter")
    for name in "_unrolled_kernel", "_circle_unrolled":
        made = getattr(filters, name).__wrapped__
        monkeypatch.setattr(filters, name, lambda *corners, made=made: in_python(made(*corners)))
    with np.errstate(all="ignore"):
        yield kernels_of("few")


# -- the broad phase


def set_limits(monkeypatch, few, limits):
    """Replace the limits by which the broad phase is chosen, in the order of `rule`."""
    names = "MAX_ALL_PAIRS", "MAX_SWEEP_NUMBA", "MAX_SWEEP_COMPARISONS", "MAX_CANDIDATES_PER_BOX"
    for name, value in zip(names, limits, strict=True):
        monkeypatch.setattr(few, name, value)


def rule(bounds, limits, candidates):
    """Return (broad phase, its comparisons or -1, are the pairs found?) by the rule of broad_rule, counting naively."""
    n, (all_pairs, sweep, comparisons, per_box) = len(bounds), limits
    if n <= all_pairs:
        return broad_rule.ALL_PAIRS, n * (n - 1) // 2, True
    low, high = bounds[:, :2], bounds[:, 2:]
    i, j = np.triu_indices(n, 1)
    compared = ((low[i] <= high[j]) & (low[j] <= high[i])).sum(axis=0)
    farthest, spread, size = np.abs(bounds).max(), np.ptp(low, axis=0), (high - low).max(axis=0)
    if n > sweep and 2.0**-900 < farthest < 2.0**900 and candidates <= per_box * n:
        return broad_rule.GRID, -1, True
    axis = 0 if spread[0] * size[1] >= spread[1] * size[0] else 1
    if compared[axis] > comparisons * n and compared[1 - axis] < compared[axis]:
        axis = 1 - axis
    if n > sweep and compared[axis] > comparisons * n:
        return broad_rule.GRID, compared[axis], False
    return broad_rule.SWEEP, compared[axis], True


@pytest.mark.parametrize("seed", range(4))
def test_numba_chooses_the_broad_phase_by_its_rule_whatever_the_limits(seed, few, monkeypatch):
    rng, ways, build_table = RNG(seed), set(), few.build_table
    for k in range(60):
        n = int(rng.integers(2, 26)) if k else 0
        bounds, limits = (
            any_bounds(rng, n),
            [int(rng.choice(some)) for some in ((0, 4, 11), (0, 9, 18), *[range(6)] * 2)],
        )
        set_limits(monkeypatch, few, limits)
        candidates = limits[3] * n + int(rng.integers(2))
        monkeypatch.setattr(few, "count_candidates", lambda _, once, __: candidates if once else 1e9)  # noqa: B023
        right, cells = rule(bounds, limits, candidates), []
        monkeypatch.setattr(few, "build_table", lambda *given: cells.append(given[2:]) or build_table(*given))  # noqa: B023
        pairs, *way = few.candidate_pairs(bounds)
        assert tuple(way) == right[:2], (bounds.tolist(), limits)
        assert (pairs is not None) == right[2]
        assert pairs is None or sorted(pairs.tolist()) == meeting(bounds).tolist()
        assert right[0] != broad_rule.ALL_PAIRS or pairs.tolist() == meeting(bounds).tolist()
        ways.add((right[0], right[2]))
        if cells:  # as large as the largest box, but never so small that they run together
            size = np.maximum((bounds[:, 2:] - bounds[:, :2]).max(axis=0), np.abs(bounds).max() * 2.0**-48)
            assert cells == [(*size, 1 << (2 * n - 1).bit_length())]
    assert len(ways) == 4


@pytest.mark.parametrize("limits", [(99, 99, 99, 99), (0, 99, 99, 99), (0, 0, 99, 99), (0, 0, 99, 0)])
def test_boxes_that_all_meet_are_found_however_many_pairs_they_make(limits, few, monkeypatch):
    """There is space for 4 pairs a box at first."""
    set_limits(monkeypatch, few, limits)
    for n in 1, 2, 8, 9, 10, 33:
        bounds = np.add.outer(np.arange(n) / n, [0.0, 0, 1, 1])
        pairs, *_ = few.candidate_pairs(bounds)
        assert sorted(pairs.tolist()) == list(map(list, combinations(range(n), 2)))
        assert pairs.dtype == np.intp


def test_one_grid_has_no_cells_of_which_too_many_for_floats_make_a_unit(few, monkeypatch):
    set_limits(monkeypatch, few, (0, 0, 99, 99))
    for ex, ey in (-1030, -990), (-990, -1030), (-1030, -1030), (1000, 990), (990, 1000), (990, 990), (-990, -990):
        bounds = np.add.outer(np.arange(-3, 4), [0.0, 0, 1, 1]) * 2.0 ** np.array([ex, ey, ex, ey])
        pairs, way, _ = few.candidate_pairs(bounds)
        assert way == (broad_rule.GRID if abs(ex) == abs(ey) == 990 else broad_rule.SWEEP)
        assert sorted(pairs.tolist()) == meeting(bounds).tolist()


@pytest.mark.parametrize("limits", [(99, 99, 0, 9), (0, 99, 0, 9), (0, 0, 99, 9), (0, 0, 0, 9)])
def test_boxes_of_circles_that_reach_beyond_float64_meet_what_they_reach_in_every_broad_phase(limits, few, monkeypatch):
    """A box without end has none where the boxes that are compared end."""
    set_limits(monkeypatch, few, limits)
    far = np.finfo(float).max
    for n, place, center in product((2, 10), (0, 1, -1), product((0.0, far, -far, far / 2), repeat=2)):
        centers, radii = np.stack([4.0 * np.arange(n), np.zeros(n)], axis=1), np.ones(n)
        centers[place], radii[place] = center, far
        bounds = batch.Circles(centers, radii).bounds
        pairs, _, comparisons = few.candidate_pairs(bounds)
        assert pairs is None or sorted(pairs.tolist()) == meeting(bounds).tolist()
        assert pairs is not None or comparisons > 0 == max(limits[:3])


def test_shapes_beyond_the_most_for_one_call_are_not_even_copied(few, monkeypatch):
    boxes, box = (batch.Polygons(np.array([UNIT] * n, float)) for n in (4, 1))
    kinds = batch.concat([box, batch.Circles(np.zeros((1, 2)), 1.0), box, box])
    taken = []
    monkeypatch.setattr(few, "_collide", lambda *given: taken.append(len(given[3])) or ("pairs", True))
    for most, found in (4, "pairs"), (3, None):
        monkeypatch.setattr(few, "MAX_SHAPES", most)
        assert few.colliding_pairs(boxes) == few.colliding_pairs(kinds) == found
        assert taken == [4, 4]
    kinds = batch.concat([box, batch.Circles(np.zeros((2, 2)), 1.0), boxes, boxes])
    monkeypatch.setattr(few, "MAX_SHAPES", 99)
    assert few.colliding_pairs(kinds) == "pairs" and taken[2:] == [11]


def test_boxes_beyond_the_most_for_one_call_are_left_to_the_grids(few, monkeypatch):
    boxes, rings = (
        batch.Polygons(np.array([UNIT] * 4, float)),
        batch.from_padded(*padded([np.array(UNIT, float)] * 4, RNG(0))),
    )
    assert vars(boxes).get("runs") and not vars(rings).get("runs")
    for most in 4, 3:
        monkeypatch.setattr(few, "MAX_SHAPES", most)
        pairs, *way = few.candidate_pairs(boxes.bounds)
        assert way == ([broad_rule.ALL_PAIRS, 6] if most == 4 else [broad_rule.GRID, -1]) and isinstance(way[1], int)
        assert [pairs is None, *(few.colliding_pairs(some) is None for some in (boxes, rings))] == [most == 3] * 3


def test_the_other_axis_is_swept_only_where_one_makes_more_comparisons_than_the_most(few, monkeypatch):
    """All nine boxes meet in one range, so that the sweep compares 36 pairs, 4 a box; one is tall, the others low."""
    low = np.stack([np.arange(9), [0, 50, 6, 12, 18, 24, 30, 36, 42]], axis=1)
    tall = np.hstack([low, np.add(low, [10, 1])]) * 1.0
    tall[0, 3] = 100
    real, swept = few._sweep, []
    monkeypatch.setattr(few, "_sweep", lambda *given: (swept.append(given[1]), real(*given))[1])
    for turn, sweep, most in product((0, 1), (99, 0), (4, 3)):
        bounds = np.roll(tall.reshape(9, 2, 2), turn, axis=2).reshape(9, 4)
        set_limits(monkeypatch, few, (0, sweep, most, 0))
        pairs, *way = few.candidate_pairs(bounds)
        assert way == [broad_rule.SWEEP, 36 if most == 4 else 8] and isinstance(way[1], int | np.integer)
        assert sorted(pairs.tolist()) == meeting(bounds).tolist()
        assert swept == ([turn] if most == 4 else [turn, 1 - turn][-2 if sweep else -1 :])
        swept.clear()


class Counted:
    """Values as the kernels read them, and how often one was read."""

    def __init__(self, values):
        self.values, self.size, self.reads = values, len(values), 0

    def __iter__(self):
        return iter(self.values)

    def __getitem__(self, i):
        self.reads += 1
        return self.values[i]


def test_values_are_sorted_without_merging_if_they_lie_evenly_and_never_in_quadratic_time(few, monkeypatch):
    rng, n, merged = RNG(4), 300, []
    monkeypatch.setattr(
        few, "_merge_argsort", lambda values: merged.append(len(values.values)) or np.argsort(values.values)
    )
    even = [rng.permutation(n) * 1.0, rng.uniform(-3, 5, n), np.arange(n)[::-1] * 0.5, rng.permutation(n) % 10 * 1.0]
    for values in even:
        few._argsort(counted := Counted(values))
        assert not merged and counted.reads < 12 * n
    for values in np.append(even[1], 1e9), np.zeros(n), np.arange(n) * 5e-324, np.array([-1.7e308, 1.7e308] * 9):
        few._argsort(counted := Counted(values))
        assert merged.pop() == len(values) and counted.reads < 12 * n


# -- boxes along x and y, or nearly


def test_a_box_with_one_corner_slid_along_a_side_is_not_taken_for_a_box(few):
    """Each such outline of four corners breaks one of the four conditions; a shape stands where the box would be."""
    for turn, start, corner, d in product((1, -1), range(4), range(4), range(2)):
        box = np.array([(0.0, 0), (8, 0), (8, 8), (0, 8)])
        other = box / 8 + box[corner] * (7 / 8)
        box[corner, d] += 3 * (-1 if box[corner, d] else 1)
        box, other = (np.roll(ring[::turn], start, axis=0) for ring in (box, other))
        for rings, upright in ([box, other], [False, True]), ([other, box], [True, False]):
            apart = sv.relate(sv.Polygon(box), sv.Polygon(other)) == sv.Relation.APART
            made = [batch.Polygons(np.array(rings)), batch.concat([batch.Polygons([ring]) for ring in rings])]
            for shapes in made:
                assert len(few.colliding_pairs(shapes)) == (not apart)
                flat = few.flatten(shapes)
                assert flat.upright.tolist() == upright and flat.upright.dtype == bool
                assert flat.bounds.tolist() == shapes.bounds.tolist()


def test_the_boxes_of_circles_are_rounded_outwards(few):
    for e in 0, -60:
        rng = RNG(e + 60)
        centers, radii = rng.uniform(-4, 4, (50, 2)), rng.uniform(0.1, 9, 50) * 2.0**e
        bounds = few.flatten(batch.Circles(centers, radii)).bounds
        for center, r, box in zip(centers.tolist(), radii.tolist(), bounds.tolist(), strict=True):
            for d in range(2):
                low, high = Fraction(center[d]) - Fraction(r), Fraction(center[d]) + Fraction(r)
                assert box[d] < low < high < box[d + 2]


# -- scenes answered by rationals

KINDS = {
    1: lambda rng: (rng.integers(0, 12, 2) * 1.0, float(rng.choice([0.5, 1, 2, 2.5, 5]))),
    3: lambda rng: rng.choice([1, 2, 4]) * np.array(TRIANGLES[rng.integers(len(TRIANGLES))], float),
    4: lambda rng: rng.choice([1, 2, 4]) * np.array(FOURS[rng.integers(len(FOURS))], float),
    5: lambda rng: rng.choice([0.5, 1]) * np.array([(0.0, 0), (4, 0), (4, 2), (2, 4), (0, 4)]) @ turned(rng),
    8: lambda rng: np.array(EIGHTS[rng.integers(2)]) * rng.choice([1.0, 2.0], 2) @ turned(rng),
    9: lambda rng: np.array([(x, x * x) for x in range(-4, 5)]) * rng.choice([0.25, 0.5]) @ turned(rng),
    13: lambda rng: np.array([(x, x * x) for x in range(-6, 7)]) * 0.25 @ turned(rng),
}
TRIANGLES = [(0, 0), (4, 0), (1, 3)], [(0, 0), (3, 0), (0, 3)], [(0, 2), (1, 0), (3, 3)], [(0, 0), (9, 1), (4, 1)]
UNIT = [(0, 0), (1, 0), (1, 1), (0, 1)]
FOURS = UNIT, UNIT, [(0, 0), (3, 0), (3, 1), (0, 1)], [(1, 0), (2, 1), (1, 2), (0, 1)], [(0, 0), (3, 0), (2, 1), (0, 1)]
EIGHTS = [(2, 0), (4, 0), (6, 2), (6, 4), (4, 6), (2, 6), (0, 4), (0, 2)], [(x, x * x / 2) for x in range(-4, 4)]
JOINS = [
    [4],
    [3],
    [1],
    [8],
    [3, 4],
    [1, 3],
    [1, 4, 5],
    [3, 4, 8],
    [1, 3, 4, 8],
    [1, 3, 4, 5, 8],
    [1, 9, 13],
    [3, 9],
    [1, 5, 9],
]


def turned(rng):
    """Return a matrix that turns by some quarters, and may mirror."""
    turn = np.array([[1, 0], [0, 1]] if rng.random() < 0.5 else [[0, 1], [-1, 0]])
    return turn * rng.choice([-1, 1], 2)


def some_shapes(rng, kinds, n):
    """Return n shapes, sorted by their numbers of corners; many touch, and some are a float off from that."""
    found = []
    for v in np.sort(rng.choice(kinds, n)).tolist():
        shape, at = KINDS[v](rng), rng.integers(0, 8, 2)
        if v > 1:
            shape = np.roll(shape, rng.integers(v), axis=0)[:: rng.choice([1, -1])] + at
        if v > 1 and rng.random() < 0.3:  # all corners of an extreme side, so that straight sides stay straight
            d = rng.integers(2)
            side = shape[:, d] == shape[:, d].max()
            shape[side, d] = np.nextafter(shape[side, d], rng.choice([-1, 99]))
        elif v == 1 and rng.random() < 0.3:
            shape = shape[0], np.nextafter(shape[1], rng.choice([0, 99]))
        found.append(shape)
    return found


def scaled(shapes, scale):
    """Return shapes made larger."""
    return [(s[0] * scale, s[1] * scale) if isinstance(s, tuple) else s * scale for s in shapes]


def joined(shapes):
    """Return a batch joined of one array for each number of corners."""
    made = []
    for v, same in groupby(shapes, lambda s: 1 if isinstance(s, tuple) else len(s)):
        same = list(same)
        if v == 1:
            made.append(batch.Circles(np.array([c for c, _ in same]), np.array([r for _, r in same])))
        else:
            made.append(batch.Polygons(np.array(same)))
    return batch.concat(made)


@cache
def small_scenes(seed):
    """Return (shapes, relation of each pair i < j in rationals) of some scenes."""
    rng, found = RNG(seed), []
    for kinds in JOINS:
        shapes = some_shapes(rng, kinds, int(rng.integers(2, 9)))
        known = [sv.Circle(*s) if isinstance(s, tuple) else sv.Polygon(s) for s in shapes]
        found.append((shapes, [int(relation(p, q)) for p, q in combinations(known, 2)]))
    return found


@pytest.mark.parametrize("limits", [(99, 99, 99, 99), (0, 99, 99, 99), (0, 0, 0, 99), (0, 0, 99, 0), (0, 0, 0, 0)])
def test_small_scenes_are_answered_by_every_broad_phase_as_in_rationals(limits, few, monkeypatch):
    set_limits(monkeypatch, few, limits)
    left = 0
    for shapes, right in small_scenes(1)[2::3]:
        index = np.stack(np.triu_indices(len(shapes), 1), axis=1)
        for form in joined(shapes), joined(shapes)[np.arange(len(shapes))]:  # indexing joins the groups of a batch
            assert batch.colliding_pairs(form, engine="numba").tolist() == index[np.array(right) > 0].tolist()
            assert few.colliding_pairs(form) is None or few.colliding_pairs(form).dtype == np.intp
            left += few.colliding_pairs(form) is None
    assert left or any(limits)  # then grids for several sizes find the pairs


@pytest.mark.parametrize("e", [-500, -300, 0, 300, 500])
@pytest.mark.parametrize("engine", ENGINES)
def test_small_scenes_are_answered_as_in_rationals_at_every_scale(engine, e):
    for shapes, right in small_scenes(e + 500)[:: 6 if abs(e) == 500 else 1]:  # there integers decide
        index = np.stack(np.triu_indices(len(shapes), 1), axis=1)
        shapes = scaled(shapes, 2.0**e)
        with_none = batch.concat([joined(shapes), joined(shapes)[:0]])
        for form in joined(shapes), with_none, batch.from_padded(*padded(shapes, RNG(0))):
            assert batch.colliding_pairs(form, engine=engine).tolist() == index[np.array(right) > 0].tolist()
            assert batch.relate(form, form, index, engine=engine).tolist() == right


# -- the float filter, column by column


def clearance(p, q):
    """Return the largest exact clearance of an edge of two outlines of whole numbers, above 0 if they are apart."""
    best = []
    for ring, other in (p, q), (q, p):
        for (x, y), (u, z) in pairwise([*ring, ring[0]]):
            best.append(min((z - y) * (s - x) + (x - u) * (t - y) for s, t in other))
    return max(best)


def columns_of(rng, v, n, odd):
    """Return n outlines of v corners in whole numbers, one of them `odd` times as large."""
    rings = np.array([np.roll(KINDS[v](rng) * 4, rng.integers(v), axis=0) + rng.integers(-9, 9, 2) for _ in range(n)])
    rings[rng.integers(n)] *= odd
    return batch.Polygons(rings)


@pytest.mark.parametrize("v", [3, 4, 5, 8])
def test_the_filter_decides_columns_by_the_error_bound_of_their_tile_and_no_others(v, few, monkeypatch):
    """Tiles have four columns here.  The bound is 32 * 2**-53 * width * reach; near it both answers are right."""
    tile, kernels, found, classified = 4, kernels_of("filter"), set(), []
    classify = kernels.classify
    monkeypatch.setattr(kernels, "classify", lambda *given: classified.append(given) or classify(*given))
    exactly, relate = [], kernels_of("indexed").relate_few_corners
    monkeypatch.setattr(kernels_of("indexed"), "relate_few_corners", lambda *given: exactly.append(1) or relate(*given))
    for module in kernels_of("filter"), kernels_of("outlines"), kernels_of("indexed"), arrays:
        monkeypatch.setattr(module, "TILE_SHAPES", tile)
    for w, odd, first in product((3, 4, 5, 8), (1.0, 2.0**20, 2.0**38), (0, 3, 5)):
        monkeypatch.setattr(kernels, "MAX_DIRECT_SHAPES", 99 * (odd > 1))  # which way 8-gons take
        rng, n = RNG([v, w, first]), {0: 9, 3: 12, 5: 11}[first]  # the last tile has one column, or all, or all but one
        a, b = columns_of(rng, v, n, odd).uniform, columns_of(rng, w, n, 1.0).uniform
        out = np.full(n - first, 9, np.int8)
        kernels.polygons(a, b, first, out)
        assert len(classified) == len(out)  # each once
        classified.clear()
        settled = out.copy()
        kernels_of("indexed").exact_columns(a, b, first, settled)
        assert len(exactly) == (out == UNDECIDED).sum()
        exactly.clear()
        rings = [np.stack([g.x, g.y], axis=2).transpose(1, 0, 2).astype(np.int64).tolist() for g in (a, b)]
        for k, got in enumerate(out.tolist(), first):
            own = [np.array(ring[k // tile * tile : (k // tile + 1) * tile]) for ring in rings]
            width = sum(np.abs(ring - np.roll(ring, 1, axis=1)).max() for ring in own)
            bound = 2.0**-48 * float(width) * float(sum(np.abs(ring).max() for ring in own))
            gap = clearance(rings[0][k], rings[1][k])
            assert settled[k - first] == (APART if gap > 0 else TOUCHING if gap == 0 else OVERLAPPING)
            if not bound / 2 < abs(gap) < 2 * bound:
                assert got == (UNDECIDED if abs(gap) <= bound else APART if gap > 0 else OVERLAPPING), (w, odd, k)
            found.add((got, gap == 0))
    assert found == {(UNDECIDED, True), (UNDECIDED, False), (APART, False), (OVERLAPPING, False)}


def edge_facing_corner(v, w, k, gap):
    """Return a v-gon and a w-gon to the right of it, a gap between an edge and a corner, which k selects."""
    turns = 2 * np.pi * (np.arange(v) - k - 0.5) / v, 2 * np.pi * (np.arange(w) - k) / w + np.pi + 0.1
    left, right = (np.stack([np.cos(some), np.sin(some)], axis=1) for some in turns)
    return left, right - right[k % w] + (np.cos(np.pi / v) + gap, 0)


@pytest.mark.parametrize("most", [0, 99])
def test_the_filter_decides_8_gons_and_others_by_each_edge_and_each_corner_of_both(most, few, monkeypatch):
    monkeypatch.setattr(kernels_of("filter"), "MAX_DIRECT_SHAPES", most)
    for v, w in product((7, 8, 9), repeat=2):
        pairs = [(*edge_facing_corner(v, w, k, gap), gap) for k in range(9) for gap in (0.01, -0.01)]
        pairs += [(q, p, gap) for k in range(9) for gap in (0.01, -0.01) for p, q in [edge_facing_corner(w, v, k, gap)]]
        for some in pairs, pairs[::5]:  # many, and as many as an 8-gon has corners
            left, right, gaps = zip(*some, strict=True)
            a, b = batch.Polygons(np.array(left)).uniform, batch.Polygons(np.array(right)).uniform
            out = np.full(len(some), 9, np.int8)
            kernels_of("filter").polygons(a, b, 0, out)
            assert out.tolist() == [APART if gap > 0 else OVERLAPPING for gap in gaps]


@pytest.mark.parametrize("corners", [4, 8])
def test_columns_of_fewer_corners_are_evaluated_as_if_they_had_more(corners, few):
    """Their rows are repeated from the first on; the row after the last repeats the first, too."""
    raise_clearance, rng = getattr(kernels_of("filter"), f"raise_clearance_{corners}"), RNG(corners)
    for v, w in product((3, 4, 5, 8), repeat=2):
        if max(v, w) <= corners:
            lanes, rings = np.empty((4, corners + 1, 20)), [columns_of(rng, some, 20, 1.0).uniform for some in (v, w)]
            for to, some in zip((lanes[:2], lanes[2:]), rings, strict=True):
                to[:] = np.stack([some.x, some.y])[:, np.arange(corners + 1) % len(some.x)]
            best = np.full(20, -np.inf)
            for x, y, p, q in lanes, lanes[[2, 3, 0, 1]]:
                raise_clearance(x, y, p, q, 0, 20, best)
            outlines = [np.stack([some.x.T, some.y.T], axis=2).astype(np.int64).tolist() for some in rings]
            right = [clearance(p, q) for p, q in zip(*outlines, strict=True)]
            assert best.tolist() == right and min(right) < 0 < max(right)


@pytest.mark.parametrize("v", [3, 4, 5, 8])
def test_columns_whose_products_leave_the_range_of_floats_are_left_undecided(v, few):
    for e, decided in (-525, False), (-420, True), (420, True), (505, False), (520, False):
        a, b = (batch.Polygons(np.array([KINDS[v](RNG(1)) + 99 * k]) * 2.0**e).uniform for k in (0, 1))
        out = np.full(1, 9, np.int8)
        kernels_of("filter").polygons(a, b, 0, out)
        assert out.tolist() == [APART if decided else UNDECIDED]


def test_columns_of_upright_boxes_are_decided_by_their_sides(few):
    rng, found = RNG(1), set()
    for first in 0, 1, 30:
        low, size = rng.integers(0, 9, (2, 40, 2)), rng.integers(1, 5, (2, 40, 2))
        rings = low[:, :, None] + np.array(UNIT) * size[:, :, None]
        for ring in rings.reshape(-1, 4, 2):
            ring[:] = np.roll(ring[:: rng.choice([1, -1])], rng.integers(4), axis=0)
        a, b = (batch.Polygons(np.array(some, float)).uniform for some in rings)
        out = np.full(40 - first, 9, np.int8)
        kernels_of("filter").boxes(a, b, first, out)
        gap = np.maximum(low[0] - low[1] - size[1], low[1] - low[0] - size[0]).max(axis=1)[first:]
        assert out.tolist() == np.where(gap > 0, APART, np.where(gap < 0, OVERLAPPING, TOUCHING)).tolist()
        found |= set(out.tolist())
    assert len(found) == 3


@pytest.mark.parametrize("v", [3, 4, 8, 9, 13])
def test_the_filter_decides_circles_and_polygons_beyond_its_error_bound(v, few):
    """The bound is 2**-46 times the square of the farthest corner or the radius; near it both answers are right."""
    kernels, n, found = kernels_of("filter"), 24, set()
    for e, first in (-470, 0), (-430, 7), (0, 0), (0, 7), (470, 0), (490, 7):
        rng = RNG([v, e + 500, first])
        rings = [np.roll(KINDS[v](rng), rng.integers(v), axis=0) for _ in range(n)]
        polygons = batch.Polygons(np.array(rings)[:, :: rng.choice([1, -1])] * 2.0**e)
        centers, radii = rng.integers(-8, 16, (n, 2)) / 2, rng.choice([0.5, 1, 1.5, 2, 2.5, 5], n)
        for k in range(0, n, 2):  # touching the rightmost corner, or a side
            centers[k] = max(rings[k].tolist()) + np.array([radii[k], 0])
        radii += rng.choice([0, 0, 2.0**-49, -(2.0**-49), 2.0**-38, -(2.0**-38)], n)
        for k in range(1, n, 4):  # a tiny one on a side, but for rounding
            centers[k], radii[k] = rings[k][0] + (rings[k][1] - rings[k][0]) * rng.random(), 2.0**-90
        for k in range(3, n, 4):  # and one deep inside
            centers[k], radii[k] = rings[k].mean(axis=0), 2.0**-90
        group, out = polygons.uniform, np.full(n - first, 9, np.int8)
        kernels.circle_polygons(*centers.T * 2.0**e, radii * 2.0**e, group.x, group.y, first, out)
        x, y = group.x.T.ravel(), group.y.T.ravel()
        alone = [
            kernels.relate_circle_polygon(*centers[k] * 2.0**e, radii[k] * 2.0**e, x, y, k * v, (k + 1) * v)
            for k in range(n)
        ]
        for k, got in [*enumerate(out.tolist(), first), *enumerate(alone)]:
            corners = [(Fraction(x), Fraction(y)) for x, y in rings[k].tolist()]
            x, y, r = map(Fraction, (*centers[k].tolist(), radii[k].item()))
            reach = max(r, *(max(abs(u - x), abs(z - y)) for u, z in corners))
            right = relation(sv.Circle((x, y), radii[k]), sv.Polygon(rings[k]))
            gap = squared_distance_from(corners, x, y) - r * r
            turns = [
                ((u - p) * (y - q) - (z - q) * (x - p)) / (abs(u - p) + abs(z - q)) / reach
                for (p, q), (u, z) in pairwise([*corners, corners[0]])
            ]
            depth = max(min(turns), -max(turns))  # above 0 inside; certain beyond 2**-48
            if e in (-470, 490):  # where products leave the range
                assert got == UNDECIDED
            elif depth > 2.0**-47 or abs(gap) > 2 * reach**2 / 2**46:
                assert got == right
            elif depth > 0:
                assert got in (UNDECIDED, right)
            elif abs(gap) < reach**2 / 2**47:
                assert got == UNDECIDED
            found.add((got, right))
    assert {(APART, 0), (OVERLAPPING, 2), (UNDECIDED, 1)} <= found
    assert (UNDECIDED, 0) in found or (UNDECIDED, 2) in found


def test_the_filter_decides_two_circles_beyond_its_error_bound_where_squares_stay_in_range(few):
    """The bound is 2**-50 times the sum of the squares; near it both answers are right."""
    kernels, rng, n, found = kernels_of("filter"), RNG(3), 60, set()
    for e, first in product((-530, -120, 0, 120, 490, 530), (0, 7)):
        a, b = rng.integers(0, 9, (2, n, 2)) * 1.0
        r = rng.choice([0.5, 1, 1.5, 2, 2.5, 4], n)
        s = np.maximum(np.hypot(*(a - b).T) - r, 0.5) + rng.choice(
            [0, 0, 2.0**-49, -(2.0**-49), 2.0**-40, -(2.0**-40), 1], n
        )
        out = np.full(n - first, 9, np.int8)
        kernels.circles(*a.T * 2.0**e, r * 2.0**e, *b.T * 2.0**e, s * 2.0**e, first, out)
        for k, got in enumerate(out.tolist(), first):
            assert got == kernels.relate_circles(*a[k] * 2.0**e, r[k] * 2.0**e, *b[k] * 2.0**e, s[k] * 2.0**e)
            distance = sum((Fraction(p) - Fraction(q)) ** 2 for p, q in zip(a[k].tolist(), b[k].tolist(), strict=True))
            reach = (Fraction(r[k]) + Fraction(s[k])) ** 2
            gap, bound = distance - reach, (distance + reach) / 2**50
            if abs(e) > 200 or abs(gap) < bound / 2:
                assert got == UNDECIDED
            elif abs(gap) > 2 * bound:
                assert got == (APART if gap > 0 else OVERLAPPING)
            found.add((got, gap == 0))
    assert found == {(UNDECIDED, True), (UNDECIDED, False), (APART, False), (OVERLAPPING, False)}


def test_the_filter_decides_no_circle_by_an_edge_whose_squared_length_loses_bits(few):
    tiny, d = 4.376 * 2.0**-537, 2.0**-330  # the square of the edge, 76.6 smallest floats, is rounded to 77
    x, y = np.array([-tiny, tiny, 0.0]), np.array([0.0, 0.0, -tiny])
    for off, right in (-(2.0**-10), APART), (2.0**-10, OVERLAPPING):
        for turn in range(3):
            px, py, out = np.roll(x, turn), np.roll(y, turn), np.full(1, 9, np.int8)
            given = np.zeros(1), np.array([d]), np.array([d * (1 + off)])
            kernels_of("filter").circle_polygons(*given, px[:, None], py[:, None], 0, out)
            alone = kernels_of("filter").relate_circle_polygon(*(c[0] for c in given), px, py, 0, 3)
            assert {int(out[0]), alone} <= {UNDECIDED, right}


def test_the_filter_never_takes_a_center_beside_an_edge_for_one_on_the_other_side(few):
    """Whether the center of a tiny circle on an edge lies inside is a matter of its last bit."""
    rng, found, wrong = RNG(5), set(), 0
    for ring in regular(rng, 150, 3, 2.0) * rng.choice([1, 2.0**-40], (150, 1, 1)):
        center, r, out = ring[0] + (ring[1] - ring[0]) * rng.random(), 2.0**-140, np.full(1, 9, np.int8)
        got = kernels_of("filter").relate_circle_polygon(*center, r, *ring.T.copy(), 0, 3)
        kernels_of("filter").circle_polygons(*center[:, None], np.array([r]), *ring.T[:, :, None], 0, out)
        right = sv.relate(sv.Circle(center, r), sv.Polygon(ring))
        assert {got, int(out[0])} <= {UNDECIDED, right}
        (x, y), (u, z) = ring[0] - center, ring[1] - ring[0]
        wrong += (x * z - y * u > 0) != (right == OVERLAPPING)  # as floats tell it
        found.add(int(right))
    assert found == {APART, OVERLAPPING} and wrong > 5


def test_the_error_bound_of_circles_and_polygons_covers_the_farthest_corner_in_each_direction(few):
    """A needle touches a small circle with its tip: the bound is 2**-46 times its squared length."""
    kernels = kernels_of("filter")
    parts = (-0.25, UNDECIDED), (0.25, UNDECIDED), (-4, APART), (4, OVERLAPPING)
    for shift, (part, right) in product((0, 999, -999), parts):
        needle, center = np.array([(0.0, 0), (64, -1), (64, 1)]), np.array([-1.0, 0])
        r = np.array([1 + part * 2.0**-47 * 64**2])  # its square is larger than 1 by twice as much
        for _ in range(4):
            needle, center, out = needle @ [[0, 1], [-1, 0]], center @ [[0, 1], [-1, 0]], np.full(1, 9, np.int8)
            x, y = (needle + shift).T.copy()
            kernels.circle_polygons(*(center + shift)[:, None], r, x[:, None], y[:, None], 0, out)
            assert kernels.relate_circle_polygon(*center + shift, r[0], x, y, 0, 3) == out[0] == right


def squared_distance_from(corners, x, y):
    """Return the exact squared distance of a point from an outline."""
    found = []
    for (px, py), (qx, qy) in pairwise([*corners, corners[0]]):
        dx, dy = qx - px, qy - py
        t = min(1, max(0, ((x - px) * dx + (y - py) * dy) / (dx * dx + dy * dy)))
        found.append((px + t * dx - x) ** 2 + (py + t * dy - y) ** 2)
    return min(found)


# -- outlines that are checked while they are copied


def bent(v, turn):
    """Return an outline, counter-clockwise, of which one edge is upright and others are (1, 1), (1, 1 + turn), ..."""
    x = np.arange(v - 1.0)
    return np.concatenate([np.stack([x, x + x * (x - 1) / 2 * turn], axis=1), [(0, 60)]])


@pytest.fixture
def doubted(few, monkeypatch):
    """How many outlines were judged exactly, call by call, and 0 where padded arrays are taken apart first."""
    found, real, unpadded = [], constructors.convex_rings, constructors._unpadded
    monkeypatch.setattr(constructors, "_unpadded", lambda *given: found.append(0) or unpadded(*given))
    monkeypatch.setattr(constructors, "convex_rings", lambda rings: found.append(len(rings.start) - 1) or real(rings))
    monkeypatch.setattr(constructors, "engine_for_checks", lambda _: engines.engine_of("numba"))
    return found


@pytest.mark.parametrize("e", [-420, 420])
@pytest.mark.parametrize("bend", [1.0, 2.0**-47, 2.0**-50])
def test_only_outlines_that_are_nearly_straight_at_a_corner_are_judged_exactly(bend, e, doubted, monkeypatch):
    """The sign of a turn is certain beyond 2**-50 of the products that it is the difference of.  A tile is two."""
    for module in kernels_of("outlines"), arrays:
        monkeypatch.setattr(module, "TILE_SHAPES", 2)
    monkeypatch.setattr(
        kernels_of("outlines"), "MAX_FEW_CORNERS", 0 if e > 0 else 99
    )  # to what length arrays stay as long
    for v, turn in product((3, 4, 5, 9), (1, -1)):
        for start in range(v)[:: max(1, v // 3)]:
            mirrored = 2.0**e * (1 - start % 2 * 2)
            rings = np.array([np.roll(bent(v, some)[::turn], start, axis=0) * mirrored for some in (1, bend, 1)])
            rings[2] *= 2
            every = np.append(rings.reshape(-1, 2), [(9.0, 9)], axis=0)
            counts, radii = np.array([v, v, v, 1]), np.array([0.0, -0.0, 0, 1])
            padded_ = np.zeros((4, v, 2))
            padded_[:3], padded_[3, 0] = rings, every[-1]
            made = [
                batch.Polygons(rings.copy()),
                batch.Polygons(list(np.concatenate([rings, rings[:, :1]], axis=1))),  # the first corner again
                batch.Polygons(list(np.repeat(rings, 2, axis=1))),
                batch.Polygons(every[:-1].copy(), offsets=np.arange(4) * v),
                batch.from_padded(padded_, counts, radii),
            ]
            made.append(batch.move(batch.concat(made[:1]), rings.copy()))
            if v > 3:
                made.append(batch.move(batch.from_padded(padded_, counts, radii), every))
            assert all(shapes.count.tolist()[:3] == [v] * 3 for shapes in made)
            straight = v > 3 and bend == 2.0**-50
            assert ("runs" in vars(made[0])) == (v <= 8 and not straight)  # in columns, without a second pass
            if "runs" in vars(made[0]):
                (group,) = made[0].runs
                assert group._maxima.tolist() == np.stack(arrays.CornerColumns(group.block).tile_maxima).tolist()
            assert sorted(doubted) == straight * [0, 0, *[1] * (len(made) + 1)], (v, turn, start)
            doubted.clear()
            for shapes in made:  # one after another, counter-clockwise from the first corner or the last, without -0.0
                x, y, first = shapes.rings
                corners = np.stack([x, y], axis=1)
                assert len(corners) == first[-1] and not np.signbit(shapes.radius).any()
                assert straight or corners[: 3 * v].tolist() == rings[:, ::turn].reshape(-1, 2).tolist()
                assert not np.signbit(corners[corners == 0]).any()


@pytest.mark.parametrize("v", [3, 4, 5, 8])
def test_the_error_bounds_of_tiles_hold_for_the_longest_edge_and_the_farthest_corner_in_each_direction(v, doubted):
    x = np.arange(v)
    bow = np.stack([x + 40, x * (x - (v - 1)) / 16], axis=1)  # the long edge leads to the left, the corners lie right
    for _ in range(4):
        for ring in bow, bow[::-1]:
            (group,) = batch.Polygons(ring[None].copy()).runs
            assert group._maxima.tolist() == [[v - 1], [v + 39]]
        bow = np.stack([-bow[:, 1], bow[:, 0]], axis=1)
    assert not doubted


@pytest.mark.parametrize(("v", "step"), [(5, 2), (7, 2), (7, 3), (8, 3), (9, 2), (9, 4)])
def test_stars_that_turn_one_way_but_go_round_more_than_once_are_no_polygons(v, step, doubted):
    star = regular(RNG(v), 1, v)[0][np.arange(v) * step % v]
    for ring in star, star[::-1].copy():
        given = np.stack([ring, ring + 4])
        for make in (
            batch.Polygons,
            lambda rings: batch.Polygons(list(rings)),
            lambda rings: batch.from_padded(rings, np.array([v, v]), np.zeros(2)),
            lambda rings: batch.move(batch.Polygons(regular(RNG(0), 2, v)), rings),
        ):
            with pytest.raises(sv.InvalidShape):
                make(given)
    assert doubted


@pytest.mark.parametrize("e", [-520, -470, 515])
def test_outlines_whose_products_leave_the_range_of_floats_are_judged_exactly(e, doubted):
    for v, turn in product((3, 4, 5, 9), (1, -1)):
        ring = regular(RNG(v), 1, v)[0][::turn] * 2.0**e
        for given in ring[None], [ring], ring[None].repeat(3, axis=0):
            assert batch.Polygons(given).count.tolist() == [v] * len(given)
            assert doubted.pop() == len(given)


@pytest.mark.parametrize("engine", ENGINES)
def test_arrays_of_circles_hold_finite_centers_and_positive_radii(engine, monkeypatch):
    """Valid ones are checked in one pass, and not number by number."""
    monkeypatch.setattr(constructors, "engine_for_checks", lambda _: engines.engine_of(engine))
    slowly, points = [], constructors.validation.points
    monkeypatch.setattr(constructors.validation, "points", lambda *given: slowly.append(1) or points(*given))
    for n, k in (1, 0), (4, 0), (4, 2), (4, 3):
        centers, radii = np.full((n, 2), -0.0), np.full(n, 5e-324)
        made = batch.Circles(centers, radii)
        assert not slowly
        assert made.uniform.r.tolist() == radii.tolist()
        assert not made.uniform.x.any() and not np.signbit(made.uniform.block).any()
        for bad in np.nan, np.inf, -np.inf, 0.0, -0.0, -5e-324, -1.0:
            with pytest.raises(sv.InvalidShape, match=rf"^circle {k}: radius"):
                batch.Circles(centers, np.where(np.arange(n) == k, bad, radii))
            for d in range(2):
                place = centers.copy()
                place[k, d] = bad
                if not np.isfinite(bad):
                    with pytest.raises(sv.InvalidShape, match=rf"^circle {k}: center.{'xy'[d]} is {bad}"):
                        batch.Circles(place, radii)
        slowly.clear()


# -- pairs given by indices


def corners_of(flat, i):
    """Return the corners of shape i in whole numbers."""
    part = slice(flat.start[i], flat.start[i + 1])
    return np.stack([flat.x[part], flat.y[part]], axis=1).astype(np.int64).tolist()


def middle_is_inside(p, q):
    """Return whether the middle of what the boxes of two outlines share is inside both."""
    low, high = np.maximum(np.min(p, axis=0), np.min(q, axis=0)), np.minimum(np.max(p, axis=0), np.max(q, axis=0))
    x, y = (low + high).tolist()  # twice the middle
    return all(
        (u - s) * (y - 2 * t) - (z - t) * (x - 2 * s) > 0
        for ring in (p, q) for (s, t), (u, z) in pairwise([*ring, ring[0]])
    )  # fmt: skip


@pytest.mark.parametrize("odd", [1.0, 2.0**26, 2.0**38])
def test_pairs_by_index_are_decided_exactly_within_their_own_error_bound_and_nowhere_else(odd, few, monkeypatch):
    """The bound is 32 * 2**-53 * width * reach of the two boxes; near it both ways are right.  Three lanes."""
    indexed, exactly, lanes, many = kernels_of("indexed"), [], [], 0
    monkeypatch.setattr(indexed, "LANES", 3)
    evaluate = indexed._evaluate_lanes
    monkeypatch.setattr(indexed, "_evaluate_lanes", lambda *given: lanes.append(given[10].size) or evaluate(*given))
    for name in "relate_few_corners", "relate_many_corners":
        real = getattr(indexed, name)
        monkeypatch.setattr(
            indexed, name, lambda *given, real=real: exactly.append((*given[2:4], *given[6:8])) or real(*given)
        )
    far, farther = 2.0**26, 2.0**46
    shifts = (0, 0), (0, 0), (far, 0), (0, -far), (-farther, 7), (9, farther), (3, -farther), (farther, 1)
    for seed, shift in enumerate(shifts):
        rng = RNG(seed)
        exactly.clear()
        lanes.clear()
        rings = [[KINDS[v](rng) * 4 + rng.integers(-9, 9, 2) for v in (3, 4, 4, 5, 8, 9, 13)] for _ in "ab"]
        for some in rings:
            some.append(some[rng.integers(7)] * odd)
        a, b = (few.flatten(batch.Polygons([ring + shift for ring in some])) for some in rings)
        ia, ib = np.argwhere(np.ones((8, 8))).T
        out, must, may, in_lanes = np.full(64, 9, np.int8), set(), set(), 0
        indexed.relations(a, ia, b, ib, out)
        for i, j, got in zip(ia, ib, out.tolist(), strict=True):
            p, q = corners_of(a, i), corners_of(b, j)
            gap = clearance(p, q)
            assert got == (APART if gap > 0 else TOUCHING if gap == 0 else OVERLAPPING)
            low, high = np.maximum(a.bounds[i, :2], b.bounds[j, :2]), np.minimum(a.bounds[i, 2:], b.bounds[j, 2:])
            if (low > high).any() or (a.upright[i] and b.upright[j]):
                continue
            width = sum((box[2:] - box[:2]).max() for box in (a.bounds[i], b.bounds[j]))
            bound = 2.0**-48 * width * (np.abs(a.bounds[i]).max() + np.abs(b.bounds[j]).max())
            most = max(len(p), len(q))
            in_lanes += 4 < most <= 8
            own = (a.start[i], a.start[i + 1], b.start[j], b.start[j + 1])
            if not middle_is_inside(p, q) if most > 8 else abs(gap) <= bound / 2:
                must.add(own)
            if any(shift) if most > 8 else abs(gap) <= bound * 2:
                may.add(own)
        assert must <= set(exactly) <= must | may and len(set(exactly)) == len(exactly)
        assert lanes == [min(3, in_lanes - k) for k in range(0, in_lanes, 3)]
        many += len(must)
    assert many


def test_circles_by_index_are_decided_by_the_filter_where_nothing_is_near_contact(few):
    rng, n = RNG(8), 14
    kinds = rng.permutation([1, 3, 4, 8, 9] * n)[: 2 * n].tolist()
    some = [KINDS[v](rng) for v in kinds]
    shapes = [
        (s[0] + rng.uniform(-3, 3, 2), s[1] * rng.uniform(0.3, 1)) if isinstance(s, tuple)
        else s @ [[0.8, 0.6], [-0.6, 0.8]] * rng.uniform(0.3, 1) + rng.uniform(-3, 12, 2)
        for s in some
    ]  # fmt: skip
    flat = few.flatten(batch.from_padded(*padded(shapes, RNG(0))))
    known = [sv.Circle(*s) if isinstance(s, tuple) else sv.Polygon(s) for s in shapes]
    ia, ib = np.argwhere(~np.eye(2 * n, dtype=bool)).T
    out = np.full(len(ia), 9, np.int8)
    kernels_of("indexed").relations(flat, ia, flat, ib, out)
    right = [int(sv.relate(known[i], known[j])) for i, j in zip(ia, ib, strict=True)]
    assert out.tolist() == right and 0 in right and 2 in right
