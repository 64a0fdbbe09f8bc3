"""Scenes of up to some twenty shapes: every way through the kernels for few shapes, and how much work it takes.

Kernels run as Python where a test replaces a limit of theirs or counts what they read.
"""

from functools import cache
from itertools import combinations, groupby, product

import numpy as np
import pytest
from batches import ENGINES, RNG, in_python, kernels_of, numba_modules
from oracle import relation
from test_batch_few import any_bounds, meeting
from test_batch_padded import padded

import satviz as sv
from satviz import batch
from satviz.batch import broad_rule


@pytest.fixture
def few(monkeypatch):
    """The kernels for few shapes, all kernels of numba as Python."""
    for m in numba_modules():
        for name, value in [*vars(m).items()]:
            monkeypatch.setattr(m, name, in_python(value))
    with np.errstate(all="ignore"):
        yield kernels_of("few")


# -- the broad phase


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
    rng, ways = RNG(seed), set()
    for k in range(60):
        n = int(rng.integers(2, 26)) if k else 0
        bounds, limits = (
            any_bounds(rng, n),
            [int(rng.choice(some)) for some in ((0, 4, 11), (0, 9, 18), *[range(6)] * 2)],
        )
        names = "MAX_ALL_PAIRS", "MAX_SWEEP_NUMBA", "MAX_SWEEP_COMPARISONS", "MAX_CANDIDATES_PER_BOX"
        for name, value in zip(names, limits, strict=True):
            monkeypatch.setattr(few, name, value)
        candidates = limits[3] * n + int(rng.integers(2))
        monkeypatch.setattr(few, "count_candidates", lambda *_: candidates)  # noqa: B023
        right = rule(bounds, limits, candidates)
        pairs, *way = few.candidate_pairs(bounds)
        assert tuple(way) == right[:2], (bounds.tolist(), limits)
        assert (pairs is not None) == right[2]
        assert pairs is None or sorted(pairs.tolist()) == meeting(bounds).tolist()
        assert right[0] != broad_rule.ALL_PAIRS or pairs.tolist() == meeting(bounds).tolist()
        ways.add((right[0], right[2]))
    assert len(ways) == 4


@pytest.mark.parametrize("limits", [(99, 99, 0), (0, 99, 0), (0, 0, 99), (0, 0, 0)])
def test_boxes_of_circles_that_reach_beyond_float64_meet_what_they_reach_in_every_broad_phase(limits, few, monkeypatch):
    """A box without end has none where the boxes that are compared end."""
    for name, value in zip(("MAX_ALL_PAIRS", "MAX_SWEEP_NUMBA", "MAX_SWEEP_COMPARISONS"), limits, strict=True):
        monkeypatch.setattr(few, name, value)
    far = np.finfo(float).max
    for n, place, center in product((2, 9, 17), (0, 1, -1), product((0.0, far, -far, far / 2), repeat=2)):
        centers, radii = np.stack([4.0 * np.arange(n), np.zeros(n)], axis=1), np.ones(n)
        centers[place], radii[place] = center, far
        bounds = batch.Circles(centers, radii).bounds
        pairs, _, comparisons = few.candidate_pairs(bounds)
        assert pairs is None or sorted(pairs.tolist()) == meeting(bounds).tolist()
        assert pairs is not None or comparisons > 0 == max(limits)


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
        few, "_merge_sorted", lambda values: merged.append(len(values.values)) or np.argsort(values.values)
    )
    even = [rng.permutation(n) * 1.0, rng.uniform(-3, 5, n), np.arange(n)[::-1] * 0.5, rng.permutation(n) % 10 * 1.0]
    for values in even:
        few._sorted(counted := Counted(values))
        assert not merged and counted.reads < 12 * n
    for values in np.append(even[1], 1e9), np.zeros(n), np.arange(n) * 5e-324, np.array([-1.7e308, 1.7e308] * 9):
        few._sorted(counted := Counted(values))
        assert merged.pop() == len(values) and counted.reads < 12 * n


# -- boxes along x and y, or nearly


def test_a_box_with_one_corner_slid_along_a_side_is_not_taken_for_a_box(few):
    """Each such outline of four corners breaks one of the four conditions; a shape stands where the box would be."""
    for turn, start, corner, d in product((1, -1), range(4), range(4), range(2)):
        box = np.array([(0.0, 0), (8, 0), (8, 8), (0, 8)])
        other = box / 8 + box[corner] * (7 / 8)
        box[corner, d] += 3 * (-1 if box[corner, d] else 1)
        box = np.roll(box[::turn], start, axis=0)
        for rings in ([box, other], [other, box]):
            apart = sv.relate(sv.Polygon(box), sv.Polygon(other)) == sv.Relation.APART
            made = [batch.Polygons(np.array(rings)), batch.concat([batch.Polygons([ring]) for ring in rings])]
            for shapes in made:
                assert len(few.colliding_pairs(shapes)) == (not apart)
                assert few.flatten(shapes).upright.sum() == 1


# -- scenes answered by rationals

KINDS = {
    1: lambda rng: (rng.integers(0, 12, 2) * 1.0, float(rng.choice([0.5, 1, 2, 2.5, 5]))),
    3: lambda rng: rng.choice([1, 2, 4]) * np.array(TRIANGLES[rng.integers(len(TRIANGLES))], float),
    4: lambda rng: rng.choice([1, 2, 4]) * np.array(FOURS[rng.integers(len(FOURS))], float),
    5: lambda rng: rng.choice([0.5, 1]) * np.array([(0.0, 0), (4, 0), (4, 2), (2, 4), (0, 4)]) @ turned(rng),
    8: lambda rng: np.array([(2.0, 0), (4, 0), (6, 2), (6, 4), (4, 6), (2, 6), (0, 4), (0, 2)]) @ turned(rng),
    9: lambda rng: np.array([(x, x * x) for x in range(-4, 5)]) * rng.choice([0.25, 0.5]) @ turned(rng),
    13: lambda rng: np.array([(x, x * x) for x in range(-6, 7)]) * 0.25 @ turned(rng),
}
TRIANGLES = [(0, 0), (4, 0), (1, 3)], [(0, 0), (3, 0), (0, 3)], [(0, 2), (1, 0), (3, 3)], [(0, 0), (9, 1), (4, 1)]
UNIT = [(0, 0), (1, 0), (1, 1), (0, 1)]
FOURS = UNIT, UNIT, [(0, 0), (3, 0), (3, 1), (0, 1)], [(1, 0), (2, 1), (1, 2), (0, 1)], [(0, 0), (3, 0), (2, 1), (0, 1)]
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


@pytest.mark.parametrize("e", [-500, -300, 0, 300, 500])
@pytest.mark.parametrize("engine", ENGINES)
def test_small_scenes_are_answered_as_in_rationals_at_every_scale(engine, e):
    for shapes, right in small_scenes(e + 500)[:: 3 if abs(e) == 500 else 1]:  # there integers decide
        index = np.stack(np.triu_indices(len(shapes), 1), axis=1)
        shapes = scaled(shapes, 2.0**e)
        made = joined(shapes)
        for form in made, batch.concat([made, made[:0]]), batch.from_padded(*padded(shapes, RNG(0))):
            assert batch.colliding_pairs(form, engine=engine).tolist() == index[np.array(right) > 0].tolist()
            assert batch.relate(form, form, index, engine=engine).tolist() == right
