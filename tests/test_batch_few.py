"""Few shapes and many: all colliding pairs whichever broad phase finds them, and outlines validated while copied.

What is expected comes from `sv.relate`, pair by pair, and from `sv.Polygon`, outline by outline.
"""

import importlib
import pickle
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from itertools import combinations, pairwise
from random import Random

import numpy as np
import pytest
from batches import ENGINES, RNG, as_python, kernels_of
from speeds import one_in
from strategies import nearly_straight

import satviz as sv
from satviz import batch
from satviz.batch import broad_phase, broad_rule, constructors, engines
from satviz.batch.arrays import TILE_SHAPES
from satviz.batch.codes import UNDECIDED
from satviz.batch.ragged import concat_rings
from satviz.batch.with_numpy import few as few_numpy

SCALES = [-500, -40, 0, 480]  # powers of two; products of coordinates vanish at the first
BOX = np.array([(0, 0), (1, 0), (1, 1), (0, 1)])
DIAMOND = np.array([(1, 0), (2, 1), (1, 2), (0, 1)])


# -- scenes: outlines, or center and radius of circles, all in whole numbers and halves


def hulls(rng, corners, size):
    """Yield convex outlines of whole numbers with some of these numbers of corners."""
    while True:
        v = int(rng.choice(corners))
        turns = np.sort(rng.uniform(0, 2 * np.pi, v))
        ring = np.round(size * np.stack([np.cos(turns), np.sin(turns)], axis=1)) + size
        try:
            polygon = sv.Polygon(ring)
        except sv.InvalidShape:
            continue
        if polygon.is_convex and len(polygon.core) == v:
            yield np.array(polygon.core)


def polygons_of(corners, size):
    def made(rng, n, wide):
        return [ring + rng.integers(0, wide * size // 3, 2) for ring, _ in zip(hulls(rng, corners, size), range(n))]

    return made


def upright_boxes(rng, n, wide):
    return [BOX * rng.integers(1, 4, 2) + rng.integers(0, wide, 2) for _ in range(n)]


def touching(rng, n, wide):
    """Return unit boxes and diamonds on a grid, where nearly every pair of neighbours touches."""
    return [(BOX, DIAMOND)[k] + rng.integers(0, wide, 2) for k in rng.integers(0, 2, n)]


def circles(rng, n, wide):
    """Return circles with radii and distances of Pythagorean triples, so that many touch."""
    return [(rng.integers(0, wide, 2) * (3, 4)[k], (1, 4, 2.5)[k + 1]) for k in rng.integers(0, 2, n)]


def circles_and_polygons(rng, n, wide):
    some = [*circles(rng, n, wide), *polygons_of([3, 4, 9], 3)(rng, n, wide)]
    return [some[k] for k in rng.permutation(2 * n)[:n]]


SCENES = {
    "triangles": polygons_of([3], 3),
    "boxes, turned": lambda rng, n, wide: [DIAMOND @ [[2, 1], [-1, 2]] + rng.integers(0, wide, 2) for _ in range(n)],
    "upright boxes": upright_boxes,
    "five corners": polygons_of([5], 8),
    "eight corners": polygons_of([8], 20),
    "nine corners": polygons_of([9], 24),
    "mixed, up to eight corners": polygons_of([3, 4, 5, 8], 18),
    "mixed": polygons_of([3, 4, 7, 9, 12], 30),
    "many corners": polygons_of([3, 20, 28], 150),
    "touching": touching,
    "circles": circles,
    "circles and polygons": circles_and_polygons,
}


def single(shape, scale=1.0):
    """Return one shape by itself."""
    if isinstance(shape, tuple):
        return sv.Circle(np.asarray(shape[0]) * scale, shape[1] * scale)
    return sv.Polygon(np.asarray(shape) * scale)


def batch_of(shapes, scale=1.0):
    """Return a batch: in columns where all have one number of corners, else one after another."""
    round_ = [k for k, shape in enumerate(shapes) if isinstance(shape, tuple)]
    plain = [k for k, shape in enumerate(shapes) if not isinstance(shape, tuple)]
    made = []
    if round_ or not plain:
        centers = np.array([shapes[k][0] for k in round_], float).reshape(-1, 2)
        made.append(batch.Circles(centers * scale, np.array([shapes[k][1] for k in round_], float) * scale))
    if plain:
        rings = [np.asarray(shapes[k]) * scale for k in plain]
        alike = len(set(map(len, rings))) == 1
        made.append(batch.Polygons(np.array(rings) if alike else rings))
    if len(made) == 1:
        return made[0]
    return batch.concat(made)[np.argsort(round_ + plain)]


def brute(shapes):
    """Return the pairs i < j that share a point, by `relate` of each pair."""
    known = list(map(single, shapes))
    return [[i, j] for i, j in combinations(range(len(known)), 2) if sv.relate(known[i], known[j])]


@cache
def scene(kind, n):
    """Return n shapes and their colliding pairs."""
    shapes = SCENES[kind](RNG(n), n, max(3, int(2 * n**0.5)))
    return shapes, brute(shapes)


def kinds_of(rng, n):
    """Return batches of circles, triangles, boxes, and so on, each made of one array, of n shapes each."""
    made = [batch.Circles(rng.integers(0, 9, (n, 2)).astype(float), rng.integers(1, 3, n) / 2)]
    for v in (3, 4, 5, 8):
        rings = [ring for ring, _ in zip(hulls(rng, [v], 3 * v), range(n))]
        made.append(batch.Polygons(np.array(rings).reshape(n, v, 2) / v + rng.integers(0, 9, (n, 1, 2))))
    return made


READ = {
    "colliding_pairs": lambda shapes: [batch.colliding_pairs(shapes, engine=engine).tolist() for engine in ENGINES],
    "broad_phase_of": batch.broad_phase_of,
    "bounds": lambda shapes: shapes.bounds.tolist(),
    "len": len,
    "repr": repr,
    "some": lambda shapes: batch.colliding_pairs(shapes[::2]).tolist(),
    "range": lambda shapes: shapes[1:].bounds.tolist(),
    "relate": lambda shapes: batch.relate(shapes, shapes[::-1]).tolist(),
    "pickle": lambda shapes: pickle.loads(pickle.dumps(shapes)).bounds.tolist(),
    "concat": lambda shapes: batch.colliding_pairs(batch.concat([shapes, shapes[:1]])).tolist(),
    "move": lambda shapes: batch.move(shapes, np.stack(shapes.rings[:2], axis=1)).bounds.tolist(),
    "threads": lambda shapes: [b.tolist() for b in ThreadPoolExecutor(4).map(lambda _: shapes.bounds, range(8))],
}


@pytest.mark.parametrize("read", READ)
def test_a_batch_joined_of_several_kinds_is_the_same_whichever_attribute_is_read_first(read):
    for kinds, n in ((1, 3), (3, 4), (4, 2), (5, 2), (5, 0), (4, 20)):
        made = kinds_of(RNG(n), n)[-kinds:] + kinds_of(RNG(n + 1), 1)[:1]
        shapes = [
            (tuple(xy.tolist()), float(r)) if r else None
            for own in made for xy, r in zip(np.stack(own.rings[:2], axis=1)[own.rings.start[:-1]], own.radius)
        ]  # fmt: skip
        rings = [ring for own in made for ring in np.split(np.stack(own.rings[:2], axis=1), own.rings.start[1:-1])]
        single = [
            batch.Circles([circle[0]], circle[1]) if circle else batch.Polygons([ring.tolist()])
            for circle, ring in zip(shapes, filter(len, rings), strict=True)
        ]
        for own in single:  # joined as outlines
            own.rings  # noqa: B018
        expected = batch.Shapes(
            rings=concat_rings([own.rings for own in single]),
            radius=np.concatenate([own.radius for own in single]),
        )
        assert READ[read](batch.concat(made)) == READ[read](expected)


AROUND = [12, 24, 48, broad_rule.MAX_ALL_PAIRS]
SIZES = sorted({0, 1, 2, 3, 5, *(n + more for n in AROUND for more in (-1, 0, 1))})
# At the first and the last scale the sign of every product is an exact one, which takes long for many corners.
QUICK_TO_DECIDE = "triangles", "upright boxes", "touching", "circles"


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("kind", one_in(3, SCENES))
def test_all_colliding_pairs_of_few_shapes_are_found_in_order(kind, engine):
    """The outlines are given in columns and one after another, at every scale."""
    for n in SIZES:
        shapes, right = scene(kind, n)
        assert n < 24 or 0 < len(right) < n * (n - 1) / 2
        every = n < 6 or n == AROUND[0] + 1 or (n == SIZES[-1] and kind in QUICK_TO_DECIDE)
        for e in SCALES if every else SCALES[1:2]:
            made = batch_of(shapes, 2.0**e)
            for form in made, batch.concat([made, made[:0]]), made[np.arange(n)]:
                found = batch.colliding_pairs(form, engine=engine)
                assert found.dtype == np.int64 and found.shape == (len(right), 2)
                assert found.tolist() == right, (n, e)


def copies(kind, n):
    """Return n shapes, copies of a few, far enough from each other in rows of 70, and their colliding pairs."""
    few, known = scene(kind, 12)
    k = np.arange(n) // 12
    at = np.stack([k % 70, k // 70], axis=1) * 128.0
    if all(isinstance(shape, tuple) for shape in few):
        centers, radii = (np.array([shape[d] for shape in few], float)[np.arange(n) % 12] for d in (0, 1))
        made = batch.Circles(centers + at, radii)
    else:
        counts = [len(ring) for ring in few]
        points = np.concatenate([few[i % 12] + at[i] for i in range(n)])
        made = batch.Polygons(points, offsets=np.concatenate([[0], np.cumsum(np.resize(counts, n))]))
    pairs = (12 * np.arange(-(-n // 12))[:, None, None] + np.array(known)).reshape(-1, 2)
    pairs = pairs[pairs.max(axis=1) < n]
    return made, pairs[np.lexsort(pairs.T[::-1])].tolist()


MANY = [broad_rule.MAX_SWEEP_NUMBA, broad_rule.MAX_SWEEP_NUMPY, 1 << 14]


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("kind", ["triangles", "upright boxes", "mixed", "touching", "circles"])
@pytest.mark.parametrize("n", one_in(3, [n + more for n in MANY for more in (0, 1)]))
def test_all_colliding_pairs_of_many_shapes_are_found_in_order(n, kind, engine):
    shapes, right = copies(kind, n)
    assert batch.colliding_pairs(shapes, engine=engine).tolist() == right


def oddly_placed(rng):
    """Yield (name, shapes) of layouts in which a broad phase may go wrong."""
    for n in 20, 60, 150:
        some = touching(rng, n - 1, 12)
        yield "all in one place", [BOX] * n
        yield "all about one point", [ring - BOX[k % 4] for k, ring in enumerate([BOX] * n)]
        yield "a giant among them", [*some, DIAMOND * 2**30]
        yield "a giant around them", [*some, BOX * 2**31 - 2**30]
        yield "a needle among them", [*some, np.array([(-(2**40), 3), (2**40, 3), (0, 4)])]
        yield "a far one", [*some, BOX + 2.0**50]
        yield "a far one on each side", [BOX - 2.0**50, *some[1:], BOX * 2.0**40 + 2.0**50]
        yield "a giant circle", [*some, ((-(2**20), 0), 2**20)]
        yield "columns", [np.add(BOX, [0, k // 2]) for k in rng.permutation(n)]
        yield "rows", [np.add(BOX, [k // 2, 0]) for k in rng.permutation(n)]
        yield "columns of two widths", [BOX * [1 + k % 2 * 7, 1] + [0, k] for k in rng.permutation(n)]
        yield "a diagonal", [BOX + k for k in rng.permutation(n)]
        yield "sizes of every scale", [BOX * 2.0 ** (k - 40) for k in rng.permutation(n)]
        yield "ever farther", [BOX + 2.0 ** (k % 50) for k in range(n)]


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.slow
def test_pairs_are_found_wherever_the_shapes_are(engine):
    for name, shapes in oddly_placed(RNG(1)):
        right = brute(shapes)
        for e in (-500, 0, 480):
            found = batch.colliding_pairs(batch_of(shapes, 2.0**e), engine=engine).tolist()
            assert found == right, (name, len(shapes), e)


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("n", [100, 1 << 13, (1 << 14) + 1])
def test_a_giant_and_a_far_shape_hide_no_pair_of_many(n, engine):
    rings = BOX + 1.0 * np.stack([np.arange(n) % 90, np.arange(n) // 90], axis=1)[:, None] * 2
    rings[1::2] -= [1, 0]  # each touches the one before
    rings[7], rings[n // 2] = np.array([(-1e9, -1), (1e9, -1), (1e9, -0.5), (-1e9, -0.5)]), BOX + 1e12
    rings[n - 1] = np.array([(-1e9, -1e9), (1e9, -1e9), (1e9, 1e9), (-1e9, 1e9)])
    low, high = rings.min(axis=1), rings.max(axis=1)
    i = np.arange(n - 1)
    right = np.argwhere(((low[:-1] <= high[1:]) & (low[1:] <= high[:-1])).all(axis=1))[:, 0]
    right = {(k, k + 1) for k in right.tolist()} | {(k, n - 1) for k in i.tolist() if k != n // 2}
    found = batch.colliding_pairs(batch.Polygons(rings), engine=engine)
    assert sorted(right) == list(map(tuple, found.tolist()))


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
def test_numbers_that_are_not_finite_never_reach_a_broad_phase(bad):
    for n in 1, 49, 5000:
        for place in np.ndindex(4, 2):
            rings = np.tile(BOX * 1.0, (n, 1, 1))
            rings[(n - 1, *place)] = bad
            with pytest.raises(sv.InvalidShape, match=f"polygon {n - 1}: vertex {place[0]}.{'xy'[place[1]]} is"):
                batch.Polygons(rings)
        with pytest.raises(sv.InvalidShape, match=f"circle {n - 1}: radius is"):
            batch.Circles(np.zeros((n, 2)), [1.0] * (n - 1) + [bad])


# -- which broad phase


def boxes_of(bounds):
    """Return upright boxes with these bounds as shapes."""
    return batch.Polygons(np.asarray(bounds, float)[:, [[0, 1], [2, 1], [2, 3], [0, 3]]])


def swept(n, comparisons):
    """Return n bounds that a sweep along x compares that often."""
    end = np.minimum(np.arange(n) + broad_rule.MAX_SWEEP_COMPARISONS, n - 1)
    missing = comparisons - int((end - np.arange(n)).sum())
    for k in range(n):
        more = min(missing, n - 1 - int(end[k]))
        end[k] += more
        missing -= more
    assert not missing
    x, y = np.arange(n), np.arange(n) * 7 % 10
    bounds = np.stack([x, y, end + 0.5, y + 6], axis=1).astype(float)
    bounds[0, 3] = 10.0 * n  # so high that the boxes are spread more widely along x, and one grid compares nearly all
    return bounds[RNG(n).permutation(n)]


def meeting(bounds):
    """Return the pairs i < j of boxes that share a point, by comparing all."""
    i, j = np.triu_indices(len(bounds), 1)
    p, q = bounds[i], bounds[j]
    return np.stack([i, j], axis=1)[((p[:, :2] <= q[:, 2:]) & (q[:, :2] <= p[:, 2:])).all(axis=1)]


SWEEP, GRID = "sort and sweep", "grid"


@pytest.mark.parametrize(
    ("n", "more", "names"),
    [
        pytest.param(400, 0, {"numpy": SWEEP, "numba": SWEEP}, marks=pytest.mark.slow),
        pytest.param(400, 1, {"numpy": GRID, "numba": SWEEP}, marks=pytest.mark.slow),
        (512, 1, {"numpy": GRID, "numba": SWEEP}),
        pytest.param(513, 0, {"numpy": SWEEP, "numba": SWEEP}, marks=pytest.mark.slow),
        (513, 1, {"numpy": GRID, "numba": GRID}),
        pytest.param(1000, 0, {"numpy": SWEEP, "numba": SWEEP}, marks=pytest.mark.slow),
    ],
)
def test_boxes_are_swept_up_to_a_limit_of_comparisons_per_box(n, more, names):
    kernels_of("few")
    comparisons = broad_rule.MAX_SWEEP_COMPARISONS * n + more
    bounds = swept(n, comparisons)
    right = meeting(bounds)
    for engine in ENGINES:
        for b in bounds, bounds[:, [1, 0, 3, 2]]:
            assert batch.broad_phase_of(boxes_of(b), engine=engine) == (names[engine], comparisons)
            assert np.array_equal(batch.candidate_pairs(b, engine=engine), right)
            assert np.array_equal(batch.colliding_pairs(boxes_of(b), engine=engine), right)


@pytest.mark.parametrize("engine", ENGINES)
def test_boxes_that_are_far_along_one_axis_only_are_swept_along_the_other(engine):
    if engine == "numba":
        kernels_of("few")
    n = 400
    bounds = np.arange(n)[:, None] * [0, 2.0, 0, 2.0] + [0, 0, 1, 1]  # in a column, but for one far to the side
    bounds[n // 2] += [1e9, 0, 1e9, 0]
    bounds[n // 2, 2:] += 1  # larger than the others
    assert batch.broad_phase_of(boxes_of(bounds), engine=engine) == (SWEEP, 1)
    assert batch.colliding_pairs(boxes_of(bounds), engine=engine).tolist() == []


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("order", [[0, 1, 2, 3], [1, 0, 3, 2]])
def test_boxes_too_unlike_for_one_grid_are_swept_along_the_axis_that_compares_fewer(order, engine):
    if engine == "numba":
        kernels_of("few")
    n = 520
    column = np.arange(n)[:, None] * [0, 2.0, 0, 2.0] + [0, 0, 1, 1]
    bounds = np.vstack([column, [1e9, 0, 1e9 + 1, 1e6]])[:, order]  # one is taller than the column, and far beside it
    assert batch.broad_phase_of(boxes_of(bounds), engine=engine) == (SWEEP, n)
    assert batch.colliding_pairs(boxes_of(bounds), engine=engine).tolist() == []


def spread_sizes(rng, n):
    """Return upright boxes with sizes from 1 to 2**20."""
    size = 2.0 ** rng.uniform(0, 20, (n, 1))
    low = rng.uniform(0, 1.5 * np.sqrt((size**2).sum()), (n, 2))
    return np.hstack([low, low + size])


def one_giant(rng, n):
    """Return upright boxes of one size, and a giant below them that touches the lowest."""
    low = rng.integers(0, int(4 * n**0.5), (n, 2))
    bounds = np.hstack([low, low + 1]).astype(float)
    bounds[n // 3] = [-1000, -2000, 1000, 0]
    return bounds


@pytest.mark.parametrize("sizes", [spread_sizes, one_giant])
@pytest.mark.parametrize("n", [400, 600, pytest.param(3000, marks=pytest.mark.slow)])
def test_sizes_that_differ_much_are_swept(n, sizes):
    kernels_of("few")
    bounds = sizes(RNG(n), n)
    right = meeting(bounds)
    for engine in ENGINES:
        way = batch.broad_phase_of(boxes_of(bounds), engine=engine)
        assert way.name == SWEEP or (engine == "numba" and n > 512)
        assert way.comparisons is None or way.comparisons < 60 * n
        assert np.array_equal(batch.colliding_pairs(boxes_of(bounds), engine=engine), right)


@pytest.mark.parametrize("engine, few, most", [("numpy", 128, 4096), ("numba", 128, 512)])
def test_the_broad_phase_that_is_chosen_is_named(engine, few, most):
    if engine == "numba":
        kernels_of("few")
    row = np.arange(5000)[:, None] * [1.0, 0, 1, 0] + [0, 0, 0.5, 1]
    for n, right in (
        (0, ("all pairs", 0)),
        (1, ("all pairs", 0)),
        (few, ("all pairs", few * (few - 1) // 2)),
        (few + 1, ("sort and sweep", 0)),
        (most, ("sort and sweep", 0)),
        (most + 1, ("grid", None)),
    ):
        way = batch.broad_phase_of(boxes_of(row[:n]), engine=engine)
        assert way == right and type(way.comparisons) in (int, type(None))
        assert batch.broad_phase_of(boxes_of(row[:n, [1, 0, 3, 2]]), engine=engine) == right
        assert batch.broad_phase_of(batch.Circles(row[:n, :2], 0.25), engine=engine) == right
    ells = [np.add([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)], [3 * k, 0]) for k in range(70)]
    parts = batch.Polygons(ells, concave="split")
    way = batch.broad_phase_of(parts, engine=engine)
    assert way == batch.broad_phase_of(parts.parts, engine=engine) == ("sort and sweep", 70)
    with pytest.raises(TypeError, match="make it with"):
        batch.broad_phase_of(ells)


@pytest.mark.parametrize("n, numpy", [(300, "sort and sweep"), (512, "grid")])
def test_crowds_of_up_to_512_are_swept_with_numba_but_with_numpy_only_if_few_comparisons_are_enough(n, numpy):
    kernels_of("few")
    crowd = boxes_of(np.tile([0.0, 0, 1, 1], (n, 1)))
    ways = [batch.broad_phase_of(crowd, engine=engine).name for engine in ("numpy", "numba")]
    assert ways == [numpy, "sort and sweep"]


@pytest.mark.parametrize("n, giants", [(5000, 0), (5000, 3), (5000, 40)])
def test_the_cells_of_a_grid_are_at_least_as_large_as_the_largest_box_in_it(n, giants):
    """A few giants are in no grid; of more, grids of their own are made."""
    rng, cells = RNG(n + giants), []
    low = rng.uniform(0, 3 * n**0.5, (n, 2))
    bounds = np.hstack([low, low + rng.uniform(0.5, 1, (n, 2))])
    bounds[:giants, 2:] += 1000
    engine = engines.engine_of("numpy")

    def watched(bounds, one, other, cell, most):
        both = one if other is None else np.concatenate([one, other])
        cells.append((cell, (bounds[both, 2:] - bounds[both, :2]).max(axis=0), len(both)))
        return engine.grid(bounds, one, other, cell, most)

    watching = engine._replace(grid=watched)
    pairs = broad_phase.sort_pairs(list(broad_phase.candidate_blocks(bounds, watching)))
    assert np.array_equal(pairs, meeting(bounds))
    assert cells and all(np.greater_equal(cell, largest).all() for cell, largest, _ in cells)
    assert cells[0][2] == (n if giants > broad_phase.MAX_OUTLIERS else n - giants)


@pytest.mark.parametrize("engine", ENGINES)
def test_no_comparisons_are_counted_for_very_many_boxes(engine):
    if engine == "numba":
        kernels_of("few")
    many = batch.Circles(np.zeros((2**14 + 1, 2)), 1.0)
    assert batch.broad_phase_of(many, engine=engine) == ("grid", None)


def any_bounds(rng, n):
    """Return bounds of which the axis, the comparisons and the order may be in doubt."""
    low = rng.choice([rng.integers(0, 9, (n, 2)), rng.integers(0, 300, (n, 2)), rng.uniform(-9, 9, (n, 2))]) * 1.0
    size = rng.choice([rng.integers(0, 3, (n, 2)), rng.integers(1, 30, (n, 2)), np.zeros((n, 2))]) * 1.0
    stretch = rng.choice([[1, 1], [0, 1], [1, 0], [5, 1], [1e-9, 1]])
    scale = 2.0 ** rng.choice([-1070, -500, 0, 480, 1012])
    with np.errstate(over="ignore"):
        return np.clip(np.hstack([low, low + size]) * np.tile(stretch, 2) * scale, -1.7e308, 1.7e308)


@pytest.mark.parametrize("seed", range(10))
@pytest.mark.parametrize("n", [2, 128, 129, 150, 200])
def test_both_engines_choose_the_same_broad_phase(n, seed):
    if "numba" in ENGINES:
        kernels_of("few")
    rng = RNG([n, seed])
    for _ in range(3):
        bounds = any_bounds(rng, n)
        right = meeting(bounds).tolist()
        one, *others = (engines.engine_of(engine).candidate_pairs(bounds) for engine in ("numpy", *ENGINES))
        assert one[1] == (broad_rule.ALL_PAIRS if n <= 128 else broad_rule.SWEEP)
        assert all(other[1:] == one[1:] and sorted(other[0].tolist()) == right for other in others), bounds.tolist()


TURNS = {
    "permuted": None,
    "mirrored in x": [[-1, 0], [0, 1]],
    "mirrored in y": [[1, 0], [0, -1]],
    "turned by 90 degrees": [[0, 1], [-1, 0]],
    "x and y exchanged": [[0, 1], [1, 0]],
}


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("change", TURNS)
@pytest.mark.parametrize("kind", SCENES)
def test_no_pair_depends_on_the_order_or_on_the_axes(kind, change, engine):
    for n in (12, 40, 100):
        shapes, right = scene(kind, n)
        order = RNG(n).permutation(n) if TURNS[change] is None else np.arange(n)
        turn = np.eye(2) if TURNS[change] is None else np.array(TURNS[change])
        turned = [(np.asarray(s[0]) @ turn, s[1]) if isinstance(s, tuple) else s @ turn for s in shapes]
        found = order[batch.colliding_pairs(batch_of([turned[k] for k in order]), engine=engine)]
        assert sorted(np.sort(found, axis=1).tolist()) == right


# -- how many pairs need exact signs


def strewn(rng, n, v, spread=20.0):
    """Return outlines of v corners in general position, most of them apart."""
    turns = np.sort(rng.uniform(0, 2 * np.pi, (n, v)), axis=1)
    ring = np.stack([np.cos(turns), np.sin(turns)], axis=2)
    return ring * rng.uniform(0.5, 2, (n, 1, 1)) + rng.uniform(-spread, spread, (n, 1, 2))


def plain_one(v):
    """Return an outline of v corners in multiples of 2**-20."""
    return np.round(strewn(RNG(v), 1, v)[0] * 2.0**20) * 2.0**-20


ODD_ONES = {
    "a giant": lambda v: plain_one(v) * 2.0**46,
    "a far one": lambda v: np.round(plain_one(v) * 2.0**16) * 2.0**-8 + 2.0**44,
    "a giant needle": lambda v: plain_one(v) * [2.0**46, 2.0**-10],
    "a tiny one": lambda v: plain_one(v) * 2.0**-60,
}


@pytest.fixture
def decided(monkeypatch):
    """Return a function of an engine: the list of pairs that it decides exactly, by index or as few shapes.

    Pairs are the indices of shapes where numba or few shapes in NumPy decide them, else None.
    """

    def watched(engine):
        found = []
        if engine == "numpy":
            indexed = importlib.import_module("satviz.batch.with_numpy.indexed")
            real, by_edges = few_numpy.relations, indexed.relate_edges
            monkeypatch.setattr(
                few_numpy, "relations", lambda a, i, b, j, out: found.extend(zip(i, j)) or real(a, i, b, j, out)
            )
            monkeypatch.setattr(
                indexed, "relate_edges", lambda a, b: found.extend([None] * a.x.shape[1]) or by_edges(a, b)
            )
            return found
        indexed = kernels_of("indexed")
        few_corners = indexed.relate_few_corners
        as_python(monkeypatch, indexed, "relate_few_corners")

        def counted(ax, ay, i0, i1, bx, by, j0, j1, *more):
            found.append((i0 // (i1 - i0), j0 // (j1 - j0)))
            return few_corners(ax, ay, i0, i1, bx, by, j0, j1, *more)

        monkeypatch.setattr(indexed, "relate_few_corners", counted)
        return found

    return watched


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("odd", ODD_ONES)
@pytest.mark.parametrize("v", [3, 4, 5, 8])
def test_one_odd_shape_among_few_leaves_all_other_pairs_to_the_filter(v, odd, engine, decided):
    """The odd shape comes first, in the middle or last."""
    exactly = decided(engine)
    for n, places in (10, (0, 5, 9)), (40, (20,)), (150, (75,)):  # all with all, and a sweep
        plain = strewn(RNG(n), n, v, 2 * n**0.5)
        for k in places:
            rings = plain.copy()
            rings[k] = ODD_ONES[odd](v)
            exactly.clear()
            pairs = batch.colliding_pairs(batch.Polygons(rings), engine=engine).tolist()
            known = [sv.Polygon(ring) for ring in rings]
            for i in {*range(0, n, 7)} - {k}:
                assert ([min(i, k), max(i, k)] in pairs) == (sv.relate(known[i], known[k]) > 0)
            assert all(pair is None or k in pair for pair in exactly), (n, k)
            assert exactly.count(None) <= sum(pair is not None for pair in exactly)


@pytest.mark.parametrize("odd", ODD_ONES)
@pytest.mark.parametrize("v", one_in(2, [3, 4, 5, 8, 20]))
@pytest.mark.parametrize("engine", ENGINES)
def test_one_odd_shape_side_by_side_leaves_other_tiles_to_the_filter(engine, odd, v):
    """The columns of a tile share an error bound."""
    n, k = 600, 300
    plain, b = strewn(RNG(v), n, v, 1.0), strewn(RNG(v + 1), n, v, 1.0)
    a = plain.copy()
    a[k] = ODD_ONES[odd](v)
    undecided = []
    for rings in plain, a:
        out = np.empty(n, np.int8)
        with np.errstate(all="ignore"):
            engines.engine_of(engine).polygons(batch.Polygons(rings).uniform, batch.Polygons(b).uniform, 0, out)
        undecided.append(out == UNDECIDED)
        right = [sv.relate(sv.Polygon(p), sv.Polygon(q)) for p, q in zip(rings[::5], b[::5])]
        assert all(found in (UNDECIDED, told) for found, told in zip(out[::5], right))
    before, now = undecided
    assert before.sum() < n / 20
    others = np.arange(n) // TILE_SHAPES != k // TILE_SHAPES
    assert np.array_equal(before[others], now[others])


@pytest.mark.parametrize("odd", ODD_ONES)
@pytest.mark.parametrize("v", [3, 4, 5, 8])
@pytest.mark.parametrize("engine", ENGINES)
def test_one_odd_shape_by_index_leaves_all_other_pairs_to_the_filter(engine, odd, v, decided):
    exactly, n, k = decided(engine), 300, 150
    plain, b = strewn(RNG(v), n, v, 1.0), strewn(RNG(v + 1), n, v, 1.0)
    a = plain.copy()
    a[k] = ODD_ONES[odd](v)
    index, many = np.repeat(np.arange(n)[:, None], 2, axis=1), []
    for rings in plain, a:
        exactly.clear()
        found = batch.relate(batch.Polygons(rings), batch.Polygons(b), index, engine=engine)
        assert found[::5].tolist() == [sv.relate(sv.Polygon(p), sv.Polygon(q)) for p, q in zip(rings[::5], b[::5])]
        many.append(len(exactly))
    assert many[1] <= many[0] + 1 and many[0] < n / 20


# -- arrays of other forms


MOVED = [(1.0, 1.0), (3.0, 1.0), (3.0, 3.0), (1.0, 3.0)]


def test_a_batch_moves_with_the_kind_of_array_that_it_was_made_of():
    square, triangle = np.array(MOVED), np.array([MOVED[0], *MOVED[1:3], MOVED[2]])
    padded = np.array([square, triangle])
    shapes = batch.move(batch.Polygons(padded), padded + 1)
    assert shapes.bounds.tolist() == [[2, 2, 4, 4]] * 2 and shapes.count.tolist() == [4, 3]
    for corners in [square.tolist()], (square,), iter([MOVED]), square[None], MOVED:
        assert batch.move(batch.Polygons([BOX]), corners).bounds.tolist() == [[1, 1, 3, 3]]
    with pytest.raises(sv.InvalidShape, match="polygon 1 has 4 corners with these coordinates, but had 3"):
        batch.move(batch.Polygons(padded), np.array([square, square]))
    empty = batch.Polygons(np.zeros((0, 4, 2)))
    assert len(batch.move(batch.move(empty, np.zeros((0, 4, 2))), np.zeros((0, 2)))) == 0
    assert len(batch.concat(map(batch.Polygons, [square[None]] * 3))) == 3


def test_offsets_in_a_plain_array_are_checked_like_any_others():
    points = np.array([*MOVED, *MOVED[:3]])
    for start in np.array([0, 4, 7]), np.array([0, 4, 7], np.int32), [0, 4, 7]:
        assert batch.Polygons(points, offsets=start).count.tolist() == [4, 3]
    for wrong in [1, 4, 7], [0, 5, 4, 7], [0, 4, 6], [0, 4, 8], [], [[0, 7]]:
        for start in wrong, np.array(wrong, np.intp):
            with pytest.raises(sv.InvalidShape, match="offsets"):
                batch.Polygons(points, offsets=start)
    with pytest.raises(sv.InvalidShape, match="polygon 1: "):
        batch.Polygons(points, offsets=np.array([0, 5, 7]))


def test_a_place_beyond_float64_or_too_far_for_the_corners_is_refused_in_one_line():
    shapes = batch.Polygons(np.array([BOX], float) * 8e307)
    with pytest.raises(sv.InvalidShape, match=r"vertex .* rounded to floats"):
        batch.place(shapes, [(1.7e308, 0)])
    with pytest.raises(sv.InvalidShape, match=r"distinct vertices.*rounded to floats"):
        batch.place(batch.Polygons([BOX]), [(1e17, 0)])
    assert shapes.bounds[0].tolist() == [0, 0, 8e307, 8e307]


# -- outlines


def test_numpy_makes_batches_and_answers_without_loading_numba():
    code = (
        "import sys; from satviz import batch; square = [(0, 0), (1, 0), (1, 1), (0, 1)]\n"
        "import numpy as np; a = batch.Polygons(np.array([square] * 9, float))\n"
        "b = batch.move(batch.concat([a, batch.Circles(np.zeros((1, 2)), 1.0)]), np.zeros((1, 2)).repeat(37, 0)"
        " + [*square * 9, (0, 0)])\n"
        "assert len(batch.colliding_pairs(b, engine='numpy')) == 45 and batch.hits(a, a, engine='numpy').all()\n"
        "assert 'numba' not in sys.modules"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


@pytest.fixture(params=ENGINES)
def made_by(request, monkeypatch):
    """Let one engine make all batches."""
    engine = engines.engine_of(request.param)
    monkeypatch.setattr(constructors, "engine_for_checks", lambda _: engine)
    return request.param


def around(corners):
    """Return the corners from the lowest on."""
    corners = [tuple(map(float, corner)) for corner in corners]
    first = corners.index(min(corners))
    return corners[first:] + corners[:first]


def expected(ring):
    """Return (the corners of a convex outline from the lowest on, None), or (None, what is wrong with it)."""
    try:
        polygon = sv.Polygon(ring)
    except sv.InvalidShape as error:
        return None, f"polygon {{}}: {error}"
    if polygon.is_convex:
        return around(polygon.core), None
    return None, "polygon {} is not convex: split it with satviz.parts first, or pass "


def star(v, step, size):
    """Return a star polygon in whole numbers, which turns one way at all its corners and goes round `step` times."""
    turns = 2 * np.pi * step * np.arange(v) / v
    return np.round(np.stack([np.cos(turns), np.sin(turns)], axis=1) * size)


def bent(rng, away):
    """Return an outline with a corner nearly straight on: `away` units in the last place outside, or inside."""
    p, q = np.array([0.0, 0.0]), rng.integers(1, 2**20, 2) * 2.0
    middle = q / 2
    normal = np.array([q[1], -q[0]])
    middle = np.where(normal > 0, np.nextafter(middle, away * np.inf), np.nextafter(middle, -away * np.inf))
    return np.array([p, middle if away else q / 2, q, q - normal, p - normal])


OUTLINES = {
    "convex": lambda rng: next(hulls(rng, [3, 4, 5, 6, 8, 9, 12], 20)),
    "a star gone round twice or more": lambda rng: star(*((5, 2), (7, 2), (7, 3), (8, 3), (9, 2))[rng.integers(5)], 50),
    "gone round twice": lambda rng: np.tile(next(hulls(rng, [3, 4, 5], 20)), (2, 1)),
    "a straight-on corner": lambda rng: bent(rng, 0),
    "a corner an ulp outside": lambda rng: bent(rng, 1),
    "a corner an ulp inside": lambda rng: bent(rng, -1),
    "nearly straight": lambda rng: np.array(nearly_straight(Random(int(rng.integers(1e9))), 1.0)),
    "flat": lambda rng: np.array([(0.0, 0), (1, 1), (3, 3), (2, 2)]) * rng.integers(1, 9),
    "concave": lambda rng: np.array([(0.0, 0), (4, 0), (4, 4), (3, 1)]) + rng.integers(0, 9, 2),
    "crossed": lambda rng: np.array([(0.0, 0), (4, 4), (4, 0), (0, 3)]) + rng.integers(0, 9, 2),
    "a spike": lambda rng: np.array([(0.0, 0), (4, 0), (2, 0), (2, 3)]) + rng.integers(0, 9, 2),
    "one point": lambda rng: np.ones((4, 2)) * rng.integers(0, 9),
}


def dressed(rng, ring):
    """Return the outline from another corner on, either way round, some corners repeated, with minus zeros, scaled."""
    ring = np.roll(ring, rng.integers(len(ring)), axis=0)[:: rng.choice([1, -1])]
    match rng.integers(8):
        case 0:
            ring = np.concatenate([ring[:1], ring])
        case 1:
            ring = np.concatenate([ring, ring[:1]])
        case 2:
            ring = np.concatenate([ring, ring[-1:], ring[-1:]])
        case 3:
            k = rng.integers(len(ring))
            ring = np.insert(ring, k, ring[k], axis=0)
    if rng.random() < 0.5:
        ring = ring - ring[rng.integers(len(ring))]
        ring = np.where((ring == 0) & (rng.random(ring.shape) < 0.7), -0.0, ring)
    return ring * 2.0 ** rng.choice([0, 0, 0, 0, 0, -40, -530, -560, -1065, 500, 1000])


def forms_of(array, folder):
    """Yield (name, the same outlines in another array): another order in memory, another type, a mapped file."""
    yield "an array", array.copy()
    yield "Fortran", np.asfortranarray(array)
    yield "by coordinate", np.ascontiguousarray(array.transpose(2, 0, 1)).transpose(1, 2, 0)
    yield "every second", np.repeat(array, 2, axis=0)[::2]
    yield "backwards", array[::-1].copy()[::-1]
    yield "byte-swapped", array.astype(">f8")
    frozen = array.copy()
    frozen.flags.writeable = False
    yield "read-only", frozen
    yield "a class of its own", array.view(type("Mine", (np.ndarray,), {}))
    np.save(folder / "rings.npy", array)
    yield "a mapped file", np.load(folder / "rings.npy", mmap_mode="r")
    with np.errstate(over="ignore"):
        single_, whole = (
            array.astype(np.float32),
            array.astype(np.int64, casting="unsafe") if big_enough(array) else None,
        )
    if (single_ == array).all():
        yield "float32", single_
    if whole is not None and (whole == array).all():
        yield "integers", whole
        yield "small integers", whole.astype(np.int32)


def big_enough(array):
    """Return whether all numbers fit into 32 bits."""
    return bool((np.abs(array) < 2**31).all())


def expected_of(rings):
    """Return (the corners of each, what the first fault is called, a batch of them); without fault or without batch."""
    known = [expected(ring) for ring in rings]
    faults = [fault.format(i) for i, (_, fault) in enumerate(known) if fault]
    alone = None if faults else batch.Polygons([sv.Polygon(ring) for ring in rings])
    return [core for core, _ in known], next(iter(faults), None), alone


def check(make, cores, fault, alone):
    """Assert that what is made of the outlines is what `sv.Polygon` says of each."""
    if fault:
        with pytest.raises(sv.InvalidShape) as error:
            make()
        assert str(error.value).startswith(fault)
        return
    made = make()
    x, y, start = made.rings
    assert [around(zip(x[i:j].tolist(), y[i:j].tolist())) for i, j in pairwise(start.tolist())] == cores
    assert not np.signbit(np.concatenate([x, y])[np.concatenate([x, y]) == 0]).any()
    assert made.owner is None and made.count.tolist() == [len(core) for core in cores]
    assert np.array_equal(made.bounds, alone.bounds) and repr(made) == repr(alone)
    for group, again in zip(made.groups.values(), alone.groups.values()):
        assert np.array_equal(group.tile_maxima, again.tile_maxima)


@pytest.mark.parametrize("kind", one_in(2, OUTLINES))
def test_a_batch_validates_outlines_like_single_polygons_in_every_input_form(kind, made_by, tmp_path):
    rng = RNG([len(kind), ENGINES.index(made_by)])
    for n in range(12):
        ring = dressed(rng, OUTLINES[kind](rng))
        alike = [len(ring)] if n % 2 and 3 <= len(ring) <= 8 else [3, 4, 5]  # as an array needs no repeats then
        others = [next(hulls(rng, alike, 20)) for _ in range(n % 3)]
        rings = [*others, ring, *others[:1]]
        most = max(map(len, rings))
        padded = np.array([np.concatenate([r, np.repeat(r[-1:], most - len(r), axis=0)]) for r in rings])
        right = expected_of(padded)
        for name, given in forms_of(padded, tmp_path):
            before = np.array(given)
            check(lambda: batch.Polygons(given), *right)  # noqa: B023
            assert np.array_equal(given, before), name
        right = expected_of(rings)
        check(lambda: batch.Polygons(rings), *right)  # noqa: B023
        start = np.cumsum([0, *map(len, rings)])
        for joined in np.concatenate(rings), np.asfortranarray(np.concatenate(rings)):
            check(lambda: batch.Polygons(joined, offsets=start), *right)  # noqa: B023


def test_stars_that_turn_one_way_at_all_corners_are_refused(made_by):
    for v, step in (5, 2), (7, 2), (7, 3), (8, 3):
        for stars in np.array([star(v, step, 50)] * 3), np.array([star(v, 1, 50), star(v, step, 50)]):
            for given in stars, stars[:, ::-1].copy():
                with pytest.raises(sv.InvalidShape, match="cross"):
                    batch.Polygons(given)


def test_a_number_that_is_not_finite_is_named_at_every_place(made_by):
    good = np.array([(0.0, 0), (2, 0), (3, 2), (1, 4), (-1, 2)])
    for v in 3, 4, 5:
        for bad in np.nan, np.inf, -np.inf:
            for place in np.ndindex(3, v, 2):
                rings = np.tile(good[:v], (3, 1, 1))
                rings[place] = bad
                for given in (rings, np.asfortranarray(rings), list(rings), rings.astype(np.float32)):
                    with pytest.raises(sv.InvalidShape) as error:
                        batch.Polygons(given)
                    i, j, k = place
                    assert str(error.value) == f"polygon {i}: vertex {j}.{'xy'[k]} is {bad}: numbers must be finite"


def test_the_first_of_two_invalid_outlines_is_named(made_by):
    """A number that is none counts before every outline that is no polygon, as all numbers are checked first."""
    good, crossed = np.array([(0.0, 0), (2, 0), (2, 2), (0, 2)]), np.array([(0.0, 0), (2, 2), (2, 0), (0, 1)])
    dart, none = np.array([(0.0, 0), (4, 0), (1, 1), (0, 4)]), good.copy()
    none[2, 1] = np.nan
    said = {"crossed": "edges 0 and 2 cross", "dart": "is not convex", "none": "vertex 2.y is nan"}
    faults = {"crossed": crossed, "dart": dart, "none": none}
    for (one, first), (other, second) in [(p, q) for p in faults.items() for q in faults.items()]:
        rings = np.array([good, first, good, second])
        at, name = (3, other) if other == "none" and one != "none" else (1, one)
        for given in rings, list(rings):
            with pytest.raises(sv.InvalidShape, match=f"polygon {at}:? .*{said[name]}|polygon {at} {said[name]}"):
                batch.Polygons(given)


def test_later_changes_of_the_callers_arrays_change_no_batch(made_by):
    rng = RNG(2)
    for v in 3, 4, 5, 8, 9:
        rings = np.array([next(hulls(rng, [v], 30)) for _ in range(5)])
        for given in rings.copy(), rings[:, ::-1].copy(), np.asfortranarray(rings):
            for made in (
                batch.Polygons(given),
                batch.Polygons(list(given)),
                batch.Polygons(flat := given.reshape(-1, 2), offsets=np.arange(0, 5 * v + 1, v)),
            ):
                before = made.bounds.tolist()
                saved = given.copy()
                given += 1000
                flat += 1000
                assert made.bounds.tolist() == before and made.rings.x.max() < 100
                assert not np.shares_memory(made.rings.x, given)
                given[:] = saved


@pytest.mark.parametrize(
    ("function", "use"),
    [
        ("part_count", lambda shapes: shapes.part_count),
        ("_columns_of", lambda shapes: batch.colliding_pairs(shapes, engine="numpy").tolist()),
    ],
)
def test_a_batch_is_read_correctly_while_another_thread_joins_its_blocks(function, use):
    boxes = batch.Polygons(np.array([[(0.0, 0), (2, 0), (2, 1), (0, 1)], [(1, 0), (3, 0), (3, 1), (1, 1)]]))
    circles = batch.Circles(np.array([[2.0, 2], [9, 9]]), 1.0)
    want, lines = use(batch.concat([boxes, circles])), 0

    def joined_before(line):
        """Return what `use` returns if the blocks are joined just before that line of the function."""
        shapes, count = batch.concat([boxes, circles]), 0

        def trace(frame, event, _):
            nonlocal count, lines
            if frame.f_code.co_name != function:
                return None
            if event == "line":
                count += 1
                lines = max(lines, count)
                if count == line:
                    shapes._joined()
            return trace

        before = sys.gettrace()
        sys.settrace(trace)
        try:
            return use(shapes)
        finally:
            sys.settrace(before)

    assert all(joined_before(line) == want for line in range(1, 10)) and lines >= 2


# -- the sweep's own sort


def test_values_of_any_order_are_sorted():
    few, rng = kernels_of("few"), RNG(5)
    for n in 2, 3, 60, 300:
        for values in (
            rng.uniform(-1, 1, n),
            rng.integers(0, 4, n) * 1.0,
            np.zeros(n),
            np.arange(n)[::-1] * 5e-324,
            np.append(rng.uniform(0, 1, n - 1), 1e300),  # all others share a bucket
            np.append(rng.uniform(0, 1, n - 1), -1e15),
            rng.permutation(2.0 ** np.linspace(-1000, 1000, n)),
            rng.choice([-1.7e308, 1.7e308], n),
            rng.choice([-0.0, 0.0, 5e-324], n),
        ):
            order = few._argsort(values)
            assert sorted(order.tolist()) == list(range(n)) and np.array_equal(values[order], np.sort(values))
