"""Many pairs at once: the same answers as one by one, whatever the engine, the layout and the executor."""

import importlib
import os
import pickle
import shutil
import subprocess
import sys
import tracemalloc
import warnings
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from decimal import Decimal, localcontext
from fractions import Fraction
from functools import partial
from itertools import pairwise, product
from pathlib import Path
from random import Random

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from speeds import one_in
from strategies import CONVEX, SIZES, drawn, edge_facing, many_corners, nearly_straight, pairs, vertex_facing

import satviz as sv
from satviz import batch
from satviz.batch import arrays, chunks, collide, engines, exact_signs, narrow_phase
from satviz.batch.chunks import ChunkFailed
from satviz.batch.codes import UNDECIDED
from satviz.batch.with_numpy import circle_polygons, gjk, indexed
from satviz.batch.with_numpy import exact as exact_numpy
from satviz.batch.with_numpy import filter as filter_numpy
from satviz.batch.with_numpy import grid as grid_numpy
from satviz.engine.relate import ERROR_FACTOR_F64, MAX_ERROR_BOUND, MIN_ERROR_BOUND
from satviz.study import truth as oracle

broad_phase = importlib.import_module("satviz.batch.broad_phase")

ENGINES = ["numpy", "numba"]
ELL = np.array([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)])
RNG = np.random.default_rng


def ngons(rng, n, v, spread=1.5):
    center = rng.uniform(-spread, spread, (n, 1, 2))
    turns = np.sort(rng.uniform(0, 2 * np.pi, (n, v)), axis=1)
    return center + np.stack([np.cos(turns), np.sin(turns)], axis=2)


def regular(rng, n, v, spread=0.1):
    """Regular polygons of one size, turned any way."""
    turns = rng.uniform(0, 2 * np.pi, (n, 1)) + 2 * np.pi * np.arange(v) / v
    return rng.uniform(-spread, spread, (n, 1, 2)) + np.stack([np.cos(turns), np.sin(turns)], axis=2)


def kernels_of(name):
    """One of numba's modules, where numba is installed."""
    pytest.importorskip("numba", reason="needs numba: python -m pip install '.[fast]'")
    return importlib.import_module(f"satviz.batch.with_numba.{name}")


def in_python(kernel):
    """A kernel as Python, which asks what stands in its module."""
    return getattr(kernel, "py_func", kernel)


def as_python(monkeypatch, module, *names):
    for name in names:
        monkeypatch.setattr(module, name, in_python(getattr(module, name)))


def circles(rng, n, spread=2.0):
    return batch.Circles(rng.uniform(-spread, spread, (n, 2)), rng.uniform(0.1, 1, n))


def scalar(shapes):
    """The same shapes one by one."""
    found = []
    for v, slot in zip(shapes.count.tolist(), shapes.slot.tolist()):
        group = shapes.groups[v]
        x, y = group.x[:, slot], group.y[:, slot]
        found.append(sv.Circle((x[0], y[0]), group.r[slot]) if v == 1 else sv.Polygon(np.stack([x, y], axis=1)))
    return found


def one_by_one(a, b):
    return [sv.relate(p, q) for p, q in zip(scalar(a), scalar(b))]


def batches_of(known):
    """Scalar convex shapes as one mixed batch, in order."""
    return batch.concat(
        [batch.Circles([s.center], [s.radius]) if isinstance(s, sv.Circle) else batch.Polygons([s]) for s in known]
    )


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("kinds", ["33", "44", "88", "34", "38", "57", "11", "13", "81", "19"])
def test_batch_gives_the_scalar_answers(engine, kinds):
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
def test_pairs_beyond_a_block_are_told_as_those_in_it(engine, chunk):
    """More pairs than any engine takes at a time, and chunks that end amid a block."""
    a, b = (ngons(RNG(seed), 50, 3) for seed in (1, 2))
    known, times = one_by_one(batch.Polygons(a), batch.Polygons(b)), (1 << 17) // 50 + 2
    assert narrow_phase.engine_of(engine).block < 50 * times
    found = batch.relate(*(batch.Polygons(np.tile(c, (times, 1, 1))) for c in (a, b)), engine=engine, chunk=chunk)
    assert (found.reshape(times, 50) == known).all()


def beside_mirror(v, w):
    """60 shapes, each beside one of another kind on whose leftmost corner or edge its rightmost corner lies."""
    a, b = (np.round(ngons(RNG(v * w), 60, k) * 2.0**40) for k in (v, w))
    wall = a[:, :, 0].max(axis=1)
    low = b[:, :, 0].min(axis=1)
    corner = a[np.arange(60), a[:, :, 0].argmax(axis=1), 1] - b[np.arange(60), b[:, :, 0].argmin(axis=1), 1]
    return a, b + np.stack([wall - low, corner], axis=1)[:, None]


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize(("v", "w"), [(9, 9), (17, 3), (40, 16), (100, 100), (4, 200)])
def test_many_corners_apart_touching_and_overlapping_are_told_apart(engine, v, w):
    """Each shape beside one that it touches, and that moved by a float or by much."""
    a, touching = beside_mirror(v, w)
    for move, right in ((0, 1), (1, 0), (2.0**39, 0), (-1, 2), (-(2.0**39), 2)):
        p, q = batch.Polygons(a), batch.Polygons(touching + np.array([move, 0.0]))
        for one, other in (p, q), (q, p), (p[::-1][::-1], q):
            assert (batch.relate(one, other, engine=engine) == right).all(), move
    assert one_by_one(p, q) == [2] * 60


@pytest.mark.parametrize(("v", "w"), [(3, 3), (3, 4), (8, 8), (9, 9), (17, 3), (40, 16)])
def test_numba_leaves_nothing_ordinary_to_the_exact_twin(v, w, monkeypatch):
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
    """Outlines of some corners, one of the second's on the edge of the first that is the most diagonal, and that point.

    All products round, and the room of a look is nowhere less when it is worked out wrongly.
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
    """What kernels take: of each outline x, y, where it begins and ends; both largest coordinates together."""
    x, y = np.concatenate([second[:3], first, second, first]).T.copy()  # between others, as in a batch
    n, end = 3 + len(first), 3 + len(first) + len(second)
    return (x, y, 3, n), (x, y, n, end), float(np.abs(first).max() + np.abs(second).max()), point


def flat_corners(rng, size):
    """Outlines that share one corner, which in both is bent by less than a look along the corners can tell.

    So the corner that looks lowest need not be it, and may lie beyond the point that is shared.
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
        plain = [sv.Polygon(ring) for ring in rings]
    except sv.InvalidShape:
        return flat_corners(rng, size)
    if not all(p.is_convex and len(p.core) == 4 for p in plain) or sv.relate(*plain) != 1:
        return flat_corners(rng, size)
    return *(np.array(p.core) * size for p in plain), shared * size


@pytest.fixture
def search(monkeypatch):
    """Numba's kernels, the search among them run as Python."""
    settle = kernels_of("exact")
    as_python(
        monkeypatch, settle, "is_certainly_inside", "_is_certainly_left", "_gjk", "_lowest_corner", "_certified_cross"
    )
    return settle


@pytest.mark.parametrize("size", [1.0, 2.0**-90, 2.0**90, 2.0**-577])  # at the last products of a turn begin to vanish
def test_numbas_search_tells_nothing_of_corners_too_flat_to_be_told_apart(search, size):
    rng = Random(3)
    for _ in range(60):
        one, other, reach, _ = as_rows(*flat_corners(rng, size))
        assert search._gjk(*one, *other, reach)[0] == search._gjk(*other, *one, reach)[0] == UNDECIDED


def standing_on_edges():
    """Narrow shapes that stand on a long edge of flat ones: what lies left of the edge says nothing of its line."""
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


def test_numbas_search_finds_no_shared_point_on_the_edge_whose_ends_it_finds_first(search):
    for rings in standing_on_edges():
        one, other, reach, _ = as_rows(*rings, None)
        for these in (one, other), (other, one):
            assert search._gjk(*these[0], *these[1], reach)[0] == UNDECIDED


def test_a_few_steps_find_no_shared_point_on_the_edge_whose_ends_they_find_first():
    one, other = (np.array(rings).transpose(2, 1, 0).copy() for rings in zip(*standing_on_edges()))
    reach = np.full(100, (np.abs(one).max() + np.abs(other).max()) * ERROR_FACTOR_F64)
    for p, q in (one, other), (other, one):
        out = np.zeros(100, np.int8)
        indexed.gjk.gjk(*p, *q, reach, out)
        assert (out == UNDECIDED).all()


ROUNDED = [  # found by search: triangles that touch, whose corners are so far apart that differences are rounded
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
def test_numbas_search_finds_no_shared_point_by_turns_that_rounding_may_hide(search, rings):
    one, other, reach, _ = as_rows(*(np.array(ring, float) for ring in rings), None)
    assert sv.relate(*(sv.Polygon(ring) for ring in rings)) == 1
    assert search._gjk(*one, *other, reach)[0] == search._gjk(*other, *one, reach)[0] == UNDECIDED


@pytest.mark.parametrize(
    ("ring", "point"),
    [  # found by search
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
def test_no_point_of_an_edge_is_inside_for_numba_where_differences_are_rounded(search, ring, point):
    triangle, at = sv.Polygon(ring), np.array(point, float)
    assert 0 in [oracle.orientation(p, q, point) for p, q in pairwise([*triangle.core, triangle.core[0]])]
    row, _, reach, _ = as_rows(np.array(triangle.core), np.array(triangle.core), None)
    assert not search.is_certainly_inside(*row, *at, reach)
    assert search.is_certainly_inside(*row, *np.array(triangle.core).mean(axis=0), reach)


@pytest.mark.parametrize(("e", "sure"), [(-480, False), (-460, True), (480, True), (484, False), (510, False)])
def test_numba_is_sure_of_no_point_where_products_leave_the_range_of_floats(search, e, sure):
    row, _, reach, _ = as_rows(*[np.array([(-1.0, -1), (1, -1), (0, 1)]) * 2.0**e] * 2, None)
    assert bool(search.is_certainly_inside(*row, 0.0, 0.0, reach)) is sure


def test_numbas_turn_is_the_exact_one_wherever_it_is_told():
    """As told of one point after another; where products leave the range of floats it may tell nothing."""
    settle = kernels_of("exact")
    rng, terms = Random(6), np.empty(settle.MAX_TERMS)
    seen = {(told, size): 0 for told in (-2, -1, 0, 1) for size in SIZES}
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
                told = settle.orient(*x, *y, *z, terms)
                seen[told, size] += 1
                exact = oracle.orientation(x, y, z)
                assert told in (-2, (exact > 0) - (exact < 0)), (x, y, z)
    for size in SIZES:
        assert min(seen[told, size] for told in (-1, 0, 1)) > 5 or seen[-2, size] > 100
        assert not seen[-2, size] or not 2.0**-400 < size < 2.0**450


@pytest.mark.parametrize("scale", [1e-130, 1.0, 1e140])
def test_numbas_turn_looks_no_further_than_it_must(scale, monkeypatch):
    """Of plain points at no more than two products, of points nearly in a row at no long sum."""
    settle = kernels_of("exact")
    turn, terms = in_python(settle.orient), np.empty(settle.MAX_TERMS)
    monkeypatch.setattr(settle, "sign_of_sum", lambda *_: pytest.fail("sums are asked"))
    for points in np.transpose([c * scale for c in in_a_row(RNG(2), 1000, 1000)]).tolist():
        if abs(exact := oracle.orientation(points[:2], points[2:4], points[4:])) > 1e-24 * scale**2:
            assert turn(*points, terms) == (1 if exact > 0 else -1)
    monkeypatch.setattr(settle, "_two_diff_tail", lambda *_: pytest.fail("what differences lost is asked"))
    for points in RNG(1).uniform(-scale, scale, (1000, 6)).tolist():
        exact = oracle.orientation(points[:2], points[2:4], points[4:])
        assert turn(*points, terms) == (1 if exact > 0 else -1)
        assert turn(*points[:4], *points[:2], terms) == turn(*points[:4], *points[2:4], terms) == 0


@pytest.mark.parametrize("scale", [2.0**-400, 1.0, 2.0**460])
def test_numbas_turn_of_points_in_a_row_whose_differences_are_floats_is_a_sum_of_four(scale, monkeypatch):
    settle = kernels_of("exact")
    turn, sums = in_python(settle.orient), []
    real = in_python(settle.sign_of_sum)
    monkeypatch.setattr(settle, "sign_of_sum", lambda terms, count: sums.append(count) or real(terms, count))
    for px, py, dx, dy in RNG(3).integers(-(2**20), 2**20, (50, 4)):
        points = np.array([px, py, px + dx, py + dy, px - 3 * dx, py - 3 * dy]) * scale
        assert turn(*points, np.empty(settle.MAX_TERMS)) == 0
    assert sums == [4] * 50


@pytest.mark.parametrize("steps", [1, 2, 3])
def test_numbas_search_ends_after_so_many_steps(search, monkeypatch, steps):
    """With nothing told, or what is right."""
    monkeypatch.setattr(search, "MAX_STEPS", steps)
    rng, seen = RNG(4), []
    for _ in range(40):
        a, b = ngons(rng, 2, 16, 0.3) * 2.0**50 + [[[0]], [[rng.uniform(0, 2) * 2**50]]]
        one, other, reach, _ = as_rows(a, b, None)
        seen.append(search._gjk(*one, *other, reach)[0])
        assert seen[-1] in (UNDECIDED, sv.relate(sv.Polygon(a), sv.Polygon(b)))
    assert UNDECIDED in seen


@pytest.mark.parametrize("size", [1.0, 2.0**-130])
def test_numbas_search_tells_whatever_is_plain(search, size):
    """Also where it takes many steps, as beside a thin one."""
    rng = RNG(4)
    for n in range(200):
        (a, b), way = ngons(rng, 2, 16, 0.3), rng.uniform(0, 2 * np.pi)
        b = b * (1, 0.02 if n % 2 else 1) + np.array([np.cos(way), np.sin(way)]) * rng.uniform(0, 2.2)
        a, b = (np.round(ring * 2.0**50) * size for ring in (a, b))
        one, other, reach, _ = as_rows(a, b, None)
        assert search._gjk(*one, *other, reach)[0] == sv.relate(sv.Polygon(a), sv.Polygon(b)), n


def test_a_corner_on_an_edge_touches_for_numba_and_no_point_of_an_edge_is_inside(search):
    rng = Random(2)
    for _ in range(40):
        first, second, point = corner_on_edge(rng)
        both = batch.Polygons([first, second])
        assert batch.relate(both, both, [(0, 1), (1, 0)], engine="numba").tolist() == [1, 1]
        one, other, reach, _ = as_rows(first, second, point)
        for row in one, other:
            assert not search.is_certainly_inside(*row, *point, reach)
            assert search.is_certainly_inside(*row, *(c[row[2] : row[3]].mean() for c in row[:2]), reach)


def test_wherever_the_search_of_numba_ends_every_edge_is_asked(monkeypatch):
    settle = kernels_of("exact")
    of_many = in_python(settle.relate_many_corners)  # run as Python, which asks what stands here
    rng = Random(1)
    for _ in range(100):
        one, other, reach, _ = as_rows(*corner_on_edge(rng))
        for i, j in product(*(rng.sample(range(*row[2:]), 2) for row in (one, other))):
            for these, ends in (((one, other), (i, j)), ((other, one), (j, i))):
                monkeypatch.setattr(settle, "_gjk", lambda *_, ends=ends: (UNDECIDED, *ends))
                assert of_many(*these[0], *these[1], reach, np.empty(settle.MAX_TERMS)) == 1, ends


class Counted(list):
    """Numbers that tell how often any of them was looked at."""

    looks = 0

    def __getitem__(self, i):
        Counted.looks += 1
        return super().__getitem__(i)


@pytest.mark.parametrize(("v", "w"), [(9, 9), (64, 64), (200, 30), (30, 200)])
def test_of_edges_that_tell_nothing_numba_looks_at_few_corners(v, w, monkeypatch):
    """About twenty for each edge, however many there are: from each to the next the walk goes on where it was."""
    settle = kernels_of("exact")
    as_python(monkeypatch, settle, "relate_many_corners", "_classify_edge", "_walk_down_onward", "_walk_down")
    monkeypatch.setattr(settle, "_classify_edges", lambda *_: pytest.fail("all corners are looked at"))
    rng = RNG(4)
    for n in range(3):
        rings = ngons(rng, 1, v, 0.3)[0], ngons(rng, 1, w, 0.3)[0] + 0.4
        one, other, reach, _ = as_rows(*rings, None)
        ends = [row[2] + (1 + n) * (row[3] - row[2]) // 4 for row in (one, other)]
        monkeypatch.setattr(settle, "_gjk", lambda *_, ends=ends: (UNDECIDED, *ends))
        Counted.looks, rows = 0, [[Counted(row[0]), Counted(row[1]), *row[2:]] for row in (one, other)]
        assert settle.relate_many_corners(*rows[0], *rows[1], reach, np.empty(settle.MAX_TERMS)) == 2
        assert Counted.looks < 24 * (v + w)


HARD = [
    *("few corners", "many corners", "opposite edges", "shortest edges", "level far sides", "bowls", "nearly parallel"),
    *("mixed magnitudes", "tiny and huge", "map coordinates", "rounded needles", "any scale"),
]


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("kind", HARD)
def test_hard_pairs_are_told_as_one_by_one_side_by_side_and_picked(engine, kind):
    """Whichever edge or corner meets which, whichever comes first, beside any others in memory."""
    rng, pairs = Random(kind), []
    while len(pairs) < 40:
        pair = drawn(rng, kind)
        if not any(isinstance(s, sv.Circle) for s in pair) and max(len(s.vertices) for s in pair) < 60:
            pairs.append(pair)
    a, b = (batches_of(side) for side in zip(*pairs))
    right = np.array([sv.relate(p, q) for p, q in pairs])
    assert len(set(right.tolist())) == 3 or kind == "map coordinates"
    assert batch.relate(a, b, engine=engine).tolist() == right.tolist()
    assert batch.relate(b, a, engine=engine).tolist() == right.tolist()
    for v, w in {(len(p.core), len(q.core)) for p, q in pairs}:
        these = np.flatnonzero((a.count == v) & (b.count == w))
        assert batch.relate(a[these], b[these], engine=engine).tolist() == right[these].tolist()


@pytest.mark.slow
def test_kernels_on_disk_are_compiled_anew_when_a_file_that_they_call_changes(tmp_path):
    pytest.importorskip("numba", reason="needs numba: python -m pip install '.[fast]'")
    shutil.copytree(Path(sv.__file__).parent, tmp_path / "satviz", ignore=shutil.ignore_patterns("__pycache__"))
    code = (
        "from satviz import batch; s = batch.Circles([(0, 0), (1, 0)], 1);"  # the kernel that is compiled soonest
        "print(batch.relate(s, s, [[0, 1]], engine='numba')[0])"
    )
    env = {k: v for k, v in os.environ.items() if k != "NUMBA_CACHE_DIR"} | {"PYTHONPATH": str(tmp_path)}
    ask = partial(subprocess.run, [sys.executable, "-c", code], env=env, cwd=tmp_path, capture_output=True, check=True)
    assert ask().stdout.split() == [b"2"]
    codes = tmp_path / "satviz" / "batch" / "codes.py"
    codes.write_text(codes.read_text().replace("= 0, 1, 2", "= 0, 1, 7"))
    assert ask().stdout.split() == [b"7"]


def test_processes_that_compile_a_kernel_at_once_never_run_each_others_code(tmp_path, monkeypatch):
    """Arrays whose numbers lie side by side, and those that skip some, take code of their own."""
    numba = pytest.importorskip("numba", reason="needs numba: python -m pip install '.[fast]'")
    monkeypatch.setattr(numba.config, "CACHE_DIR", str(tmp_path))
    from satviz.batch.with_numba.jit_cache import compiled

    def second(numbers):
        return numbers[1]

    whole, skipping = np.arange(4.0), np.arange(4.0)[::2]
    one, other = compiled(second), compiled(second)  # as two processes would have it
    mine, theirs = (kernel._cache._cache_file for kernel in (one, other))
    save = mine._save_data

    def interrupted(name, data):  # between its index and its code; the other one had read the index before
        assert other(skipping) == 2
        save(name, data)

    monkeypatch.setattr(theirs, "_load_index", dict)
    monkeypatch.setattr(mine, "_save_data", interrupted)
    assert one(whole) == 1
    for _ in range(2):
        later = compiled(second)
        assert (later(whole), later(skipping)) == (1, 2)


@pytest.mark.slow
def test_hard_pairs_are_right_where_each_is_a_batch_of_its_own():
    """No other pair widens the error bound of float32; near and far from the origin."""
    for _, p, q in pairs(5, 60 * len(CONVEX), list(CONVEX)):
        if isinstance(p, sv.Polygon) and isinstance(q, sv.Polygon):
            found = batch.relate(batch.Polygons([p]), batch.Polygons([q]), engine="numpy")[0]
            assert found == oracle.relation(p, q), (p, q)


@pytest.mark.parametrize("v, w", [(3, 3), (4, 4), (8, 5)])
@pytest.mark.parametrize("far", [0.0, 10.0, 1e4])
def test_the_float32_look_errs_less_than_its_room(v, w, far):
    """Against float64, whose own error is 2**-29 of that; the room is 64 units, the worst found is told."""
    rng = RNG(7)
    a, b = ngons(rng, 20_000, v), ngons(rng, 20_000, w) + rng.uniform(-far, far, (20_000, 1, 2))
    b[::2] = a[::2, :1] + (b[::2] - b[::2, :1])  # half share a corner
    columns = [np.ascontiguousarray(shape[:, :, k].T) for shape in (a, b) for k in (0, 1)]
    width = 4.0
    found, room = filter_numpy.evaluate_f32(*columns, width)
    size = np.sqrt(room / filter_numpy.ERROR_FACTOR_F32)
    assert (size >= np.abs(b - a[:, :1]).max(axis=(1, 2)) * (1 - 1e-6)).all()
    near = [c - origin for c, origin in zip(columns, (columns[0][0], columns[1][0]) * 2)]
    error = np.abs(found - filter_numpy.clearance(*near, 0)) / (2.0**-24 * size.astype(float) ** 2)
    print(f"{v} against {w} corners, up to {far:g} apart: worst {error.max():.1f} of 64")
    assert 0 < error.max() < 64


def tiles(edge, coordinate):
    """A group of which only the largest numbers of its tiles are known."""
    x = np.zeros((3, 1))
    return arrays.Group(x, x, maxima=np.array([edge, coordinate]))


@pytest.mark.parametrize("spans", [*product([2.0**-30, 1, 2.0**20], repeat=2)])
@pytest.mark.parametrize("reaches", [*product([2.0**-20, 1, 2.0**30], repeat=2)])
def test_numbas_error_bound_is_what_rounding_needs_and_little_more(spans, reaches):
    """15 roundings of the longest edge's part times the farthest coordinate are needed, 32 of both are granted.

    See relate.ERROR_FACTOR_F64.  Each tile has a bound of its own.
    """
    kernels = kernels_of("filter")
    a, b = (tiles([1.0, span, 1.0], [1.0, reach, 1.0]) for span, reach in zip(spans, reaches))
    bounds = kernels.error_bounds(a, b)
    assert bounds.shape == (3,) and bounds[0] == bounds[2] == 4 * ERROR_FACTOR_F64
    assert 15 / 32 * ERROR_FACTOR_F64 <= bounds[1] / (max(spans) * max(reaches)) <= 4 * ERROR_FACTOR_F64


@pytest.mark.parametrize("e", [-560, -480, -430, 0, 430, 500, 560])
def test_numbas_error_bound_is_infinite_where_products_lose_bits_or_overflow(e):
    kernels = kernels_of("filter")
    group = tiles([1.0, 2.0**e], [1.0, 2.0**e])
    assert (kernels.error_bounds(group, group) < np.inf).tolist() == [True, abs(e) <= 430]


@pytest.mark.parametrize("v", range(3, 17))
def test_the_float32_filter_takes_no_shape_for_narrower_than_it_is(v):
    """Of whichever columns, in whichever tiles."""
    rng = RNG(v)
    group = batch.Polygons(ngons(rng, 300, v) * rng.uniform(0.01, 1, (300, 1, 1))).uniform
    wide = np.ptp([group.x, group.y], axis=1).max(axis=0)
    for first, n in (0, 300), (0, 1), (127, 2), (128, 128), (100, 200), (299, 1):
        widths = filter_numpy._max_widths(group, first, n)
        assert widths.shape == (n,) and (wide[first : first + n] <= widths).all()


@pytest.mark.parametrize("half", range(2, 9))
def test_no_shape_is_wider_than_one_whose_edges_lead_there_and_back_by_as_much(half):
    there = np.stack([np.ones(half), (2 * np.arange(half) + 1 - half) / half], axis=1)
    group = batch.Polygons(np.cumsum([*there, *-there], axis=0)[None]).uniform
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
    for more, right in (0, 1), (1, 2), (-1, 0):
        a, b = batch.Circles(np.zeros((100, 2)), radius), batch.Circles(centers, apart * size - radius + more)
        assert (batch.relate(a, b, engine=engine) == right).all()


@pytest.mark.parametrize("engine", ENGINES)
def test_one_against_many_and_pairs_by_index(engine):
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
    with pytest.raises(ValueError, match="3 shapes against 2"):
        batch.relate(three, two)
    with pytest.raises(IndexError, match="outside 0 to 2"):
        batch.relate(three, three, [(0, 3)])
    with pytest.raises(ValueError, match="expected \\(K, 2\\)"):
        batch.relate(three, three, [0, 1])
    with pytest.raises(ValueError, match="engine is 'cuda'"):
        batch.relate(three, three, engine="cuda")
    assert batch.relate(three[:0], three[:0]).tolist() == [] == batch.relate(three[:1], three[:0]).tolist()


@pytest.mark.parametrize("ask", [batch.relate, batch.hits])
@pytest.mark.parametrize(
    ("index", "words"),
    [
        ([0, 1], "shape \\(2,\\)"),
        ([[0, 1, 2]], "shape \\(1, 3\\) of int"),
        ([[0], [1]], "shape \\(2, 1\\)"),
        ([[0.0, 1.0]], "of float64"),
        ([[True, False]], "of bool"),
        ([[0, 0], [0, -1]], "outside 0 to 2 and 0 to 4"),
        ([[-1, 0], [2, 4]], "outside"),
        ([[0, 0], [3, 0]], "outside"),
        ([[5, 0], [0, 0]], "outside"),
        ([[0, 0], [0, 5]], "outside"),
        ([[0, 0], [2, 6]], "outside"),
        (np.array([[0, 2**64 - 1]], np.uint64), "outside"),
    ],
)
def test_pairs_that_name_no_two_shapes_are_refused_whatever_stands_beside_them(ask, index, words):
    a, b = (batch.Circles(np.zeros((n, 2)), 1) for n in (3, 5))
    with pytest.raises((ValueError, IndexError), match=words):
        ask(a, b, index, engine="numpy")
    assert ask(a, b, [[0, 0], [2, 4], [2, 0], [0, 4]], engine="numpy").all()


@pytest.mark.parametrize("kind", [np.int8, np.uint8, np.int16, np.uint64])
def test_pairs_of_whatever_integers_name_the_same_shapes(kind):
    at = np.arange(300)[:, None, None] * np.array([1.5, 0])  # each overlaps the next
    shapes = batch.Polygons(ELL + at, concave="split")
    most = min(np.iinfo(kind).max, 299)
    for i, j, right in ((most - 1, most, 2), (most, most - 1, 2), (most, most, 2), (most, 0, 0)):
        assert batch.relate(shapes, shapes, np.array([[i, j]], kind), engine="numpy").tolist() == [right]


@pytest.mark.parametrize("kind", [float, int])
def test_no_pairs_have_no_relations(kind):
    shapes = batch.Circles([(0, 0)], 1)
    assert batch.relate(shapes, shapes, np.empty((0, 2), kind), engine="numpy").shape == (0,)


def test_either_winding_repeats_and_straight_on_vertices_are_taken():
    square = [(0, 0), (2, 0), (2, 2), (0, 2)]
    rings = [square[::-1], [*square, square[0]], [(0, 0), (1, 0), (2, 0), (2, 2), (0, 2)], [(0, 0), *square]]
    shapes = batch.Polygons(rings)
    assert shapes.count.tolist() == [4] * 4
    assert batch.relate(shapes, batch.Circles([(3, 1)], [1])).tolist() == [1] * 4


def test_a_concave_polygon_is_refused_or_split_with_its_owner():
    ell = [(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)]
    box = [(2.5, 2.5), (3.5, 2.5), (3.5, 3.5), (2.5, 3.5)]
    with pytest.raises(sv.InvalidShape, match="polygon 1 is not convex"):
        batch.Polygons([box, ell])
    shapes = batch.Polygons([box, ell, box], concave="split")
    assert len(shapes) == 3 and shapes.owner.tolist() == [0, 1, 1, 2]
    coins = batch.Circles([(3, 3), (3, 3), (9, 9)], [0.1, 0.9, 1])
    assert batch.relate(shapes, coins).tolist() == [2, 0, 0]
    assert batch.colliding_pairs(shapes).tolist() == [[0, 2]]


@pytest.mark.parametrize(
    ("vertices", "words"),
    [
        (np.zeros((2, 3)), "expected \\(N, V, 2\\)"),
        (np.array([[[0, 0], [1, 0], [np.nan, 1]]]), "polygon 0: vertex 2.x is nan: coordinates must be finite"),
        (
            np.array([[[0, 0], [1, 0], [2**53 + 1, 1]]]),
            "polygon 0: vertex 2.x is 9007199254740993, which float64",
        ),
        (np.array([[[0, 0], [1, 1j], [1, 1]]]), "complex128"),
        (np.ma.masked_less(np.array([[[0, 0], [1, 0], [0, 1]]]), 1), "masked"),
        ([[(0, 0), (1, 0), (0, 1)], [(0, 0), (2, 2), (2, 0), (0, 2)]], "polygon 1: edges 0 and 2 cross"),
        ([[(0, 0), (1, 1), (2, 2)]], "polygon 0: all vertices lie on one line"),
        ([[(0, 0), (1, 1)]], "polygon 0: 2 distinct vertices: a polygon needs at least 3"),
    ],
)
def test_bad_polygons_are_refused_by_number(vertices, words):
    with pytest.raises(sv.InvalidShape, match=words):
        batch.Polygons(vertices)


def test_bad_circles_are_refused_by_number():
    for centers, radii, words in (
        ([(0, 0), (1, 1)], [1, 0], "circle 1: radius is 0.0: a circle needs a positive radius"),
        ([(0, 0), (1, np.inf)], 1, "circle 1: center.y is inf: coordinates must be finite"),
        ([0, 1], 1, "circle 0: center is 0: expected a pair"),
        (np.array([0, 1]), 1, "expected \\(N, 2\\)"),
        ([(0, 0), (1, 1)], [1, 1, 1], "expected \\(2,\\)"),
    ):
        with pytest.raises(sv.InvalidShape, match=words):
            batch.Circles(centers, radii)


def test_a_pentagram_is_not_convex_though_it_turns_left_everywhere():
    turns = 4 * np.pi * np.arange(5) / 5
    with pytest.raises(sv.InvalidShape, match="cross"):
        batch.Polygons([np.stack([np.cos(turns), np.sin(turns)], axis=1)])


@given(st.lists(st.tuples(*[st.integers(-3, 3)] * 6), min_size=1, max_size=20), st.integers(-60, 60))
@settings(max_examples=80, deadline=None)
def test_turns_are_exact(points, e):
    cols = np.array(points, dtype=float).T * 2.0**e
    nudged = np.nextafter(cols, np.inf)
    for c in (cols, nudged, np.where(cols == 0, 1e-300, cols)):
        found = exact_signs.orient(*c)
        for i, value in enumerate(found):
            px, py, qx, qy, rx, ry = map(Fraction, c[:, i])
            det = (qx - px) * (ry - py) - (qy - py) * (rx - px)
            assert value == (det > 0) - (det < 0)


def in_a_row(rng, n, far):
    """Three points nearly on a line, each."""
    p, q = rng.uniform(-1, 1, (2, n, 2)) * [[[1]], [[far]]]
    return *p.T, *q.T, *(p + rng.uniform(-1, 2, (n, 1)) * (q - p)).T


@pytest.mark.parametrize("scale", [1e-130, 1.0, 1e140])
def test_plain_turns_are_told_by_floats_alone(scale, monkeypatch):
    asked = []
    real = exact_signs._orient_adaptive
    monkeypatch.setattr(exact_signs, "_orient_adaptive", lambda *c: asked.extend(c[0]) or real(*c))
    exact_signs.orient(*RNG(1).uniform(-scale, scale, (6, 1000)))
    assert not asked


@pytest.mark.parametrize("scale", [1e-130, 1.0, 1e140])
def test_turns_of_points_nearly_in_a_row_are_told_without_long_sums(scale, monkeypatch):
    asked = []
    real = exact_signs.sign_of_products
    monkeypatch.setattr(exact_signs, "sign_of_products", lambda pairs: asked.extend(pairs[0][0]) or real(pairs))
    exact_signs.orient(*(c * scale for c in in_a_row(RNG(2), 1000, 1000)))
    assert len(asked) <= 5


def test_turns_with_what_was_lost_are_off_by_less_than_granted(monkeypatch):
    """Granted are 32 roundings of roundings, 12 can be shown; the worst found is told."""
    seen = []
    real = exact_signs.certified_sign
    monkeypatch.setattr(exact_signs, "certified_sign", lambda *c: seen.append(c) or real(*c))
    worst = 0
    for far in (3, 1e3, 1e9):
        points = in_a_row(RNG(3), 500, far)
        seen.clear()
        exact_signs._orient_adaptive(*points)
        turns, rooms = seen[0]
        for turn, room, *at in zip(*(map(Fraction, c.tolist()) for c in (turns, rooms, *points))):
            px, py, qx, qy, rx, ry = at
            right = (qx - px) * (ry - py) - (qy - py) * (rx - px)
            worst = max(worst, (abs(turn - right) - abs(right) / 2**53) / room * 32)
    print(f"worst {float(worst):.1f} of 32")
    assert 0 < worst < 12


def test_two_floats_are_the_product_exactly():
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


def test_turns_beyond_float64_are_exact_and_warn_of_nothing():
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
def test_a_turn_of_which_one_difference_alone_is_rounded_is_exact(swap, engine):
    """A straight way and one a float off: a product of two odd numbers is the difference of two floats of one end."""
    rng = RNG(6)
    if engine == "numba":
        settle = kernels_of("exact")
    for f, g in rng.integers(2**33, 2**36, (60, 2)).tolist():
        far = float(f * g)
        near = float(int(far) - f * g)
        if float(g + near) - near == g:
            for off in (0, 1, -1):
                columns = np.array([near, 0, far, f, g + near + off, 1], float)[swap]
                px, py, qx, qy, rx, ry = map(Fraction, columns)
                det = (qx - px) * (ry - py) - (qy - py) * (rx - px)
                if engine == "numba":
                    told = settle.orient(*columns, np.empty(settle.MAX_TERMS))
                else:
                    (told,) = exact_signs.orient(*columns[:, None])
                assert told == (det > 0) - (det < 0) and (det == 0) == (off == 0)


def test_signs_of_products_are_exact_at_every_scale():
    some = [0, 1, -1, 3e-200, -1e-170, 5e-324, -5e-324, 1e-154, 2e150, -1e200, 1.7e308, 1 + 2.0**-52]
    factors = RNG(7).choice(some, (2, 2, 600))
    a, b = factors[0]
    for sums in (factors, [(a, b), (-a, b)], [(a, b), (a, -b), (b, b)], [(a, b), (b, -np.nextafter(a, 9))]):
        right = [sum(Fraction(p[i]) * Fraction(q[i]) for p, q in sums) for i in range(600)]
        assert exact_signs.sign_of_products(sums).tolist() == [(s > 0) - (s < 0) for s in right]


@pytest.mark.parametrize("engine", ENGINES)
def test_a_sum_is_told_from_what_its_other_terms_can_add_up_to_at_most(engine):
    """Though that sum is itself rounded: 1 and five times what is rounded off it."""
    terms = np.array([-1, *[-(2.0**-53)] * 5, 1 + 2.0**-52])
    for way in (1, -1):
        if engine == "numba":
            settle = kernels_of("exact")
            assert settle.sign_of_sum(way * terms, len(terms)) == -way
        else:
            assert exact_signs.sign_of_sum(way * terms[:, None]) == -way


@pytest.mark.parametrize("engine", ENGINES)
def test_sums_that_nearly_vanish_are_told_exactly(engine):
    """What is left once each number has met its opposite, split in two on the way: nothing, or one that is far less."""
    rng, seen = RNG(12), []
    for n in range(300):
        large = rng.normal(0, 1, 3) * 2.0 ** rng.integers(-40, 40, 3)
        parts = large * rng.uniform(-2, 3, 3)
        rest = large - parts  # rounded: what was lost is the last of each
        lost = [float(Fraction(u) - Fraction(v) - Fraction(w)) for u, v, w in zip(large, parts, rest)]
        terms = np.array([*-large, *parts, *rest, *lost[:2], lost[2] * (n % 3)])
        rng.shuffle(terms)
        exact = sum(map(Fraction, terms))
        if engine == "numba":
            settle = kernels_of("exact")
            told = settle.sign_of_sum(terms.copy(), len(terms))
        else:
            (told,) = exact_signs.sign_of_sum(terms[:, None].copy())
        assert told == (exact > 0) - (exact < 0), terms
        seen.append(told)
    assert min(map(seen.count, (-1, 0, 1))) > 20


def test_sums_of_ordinary_products_need_no_integers(monkeypatch):
    asked = []
    monkeypatch.setattr(exact_signs, "to_integers", lambda values: asked.append(values))
    a, b, c = RNG(8).uniform(-1, 1, (3, 500)) * 10.0 ** RNG(9).integers(-60, 60, (3, 500))
    zero = np.zeros(500)
    for more in ([], [(zero, c)], [(c, zero)]):
        assert not exact_signs.sign_of_products([(a, b), (-b, a), *more]).any()
        assert np.array_equal(exact_signs.sign_of_products([(a, b), (-b, a), (c, a), *more]), np.sign(c) * np.sign(a))
    assert not asked


# -- circles and polygons that floats leave undecided

TRIPLES = np.array([(3, 4, 5), (5, 12, 13), (8, 15, 17), (20, 21, 29), (-9, 40, 41)], float)


def turned(vectors):
    return np.stack([vectors[..., 1], -vectors[..., 0]], axis=-1)


def resting(rng, n, v=3):
    """Circles that rest on an edge or a corner of a polygon as nearly as floats allow."""
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


def resting_exactly(rng, n, bits=10):
    """The same on a grid: edges along whole-number triples, the corner of a right angle or the middle of its edge."""
    x, y, z = TRIPLES[rng.integers(0, len(TRIPLES), n)].T
    along = np.stack([x, y], axis=1)
    p = rng.integers(-(2**bits), 2**bits, (n, 2)).astype(float)
    k, m = rng.integers(1, 2**bits, (2, n, 1)).astype(float)
    q = p + 2 * k * along
    o = p + k * along - turned(along) * rng.integers(1, 5, (n, 1)) * k + along * rng.integers(-1, 2, (n, 1)) * k
    centers = np.where(rng.random((n, 1)) < 0.5, p + k * along + m * turned(along), q + m * along)
    return centers, z * m[:, 0], np.stack([p, q, o], axis=1)


def resting_on_boxes(rng, n):
    """Below boxes, then mirrored and turned to each of the four sides."""
    low = rng.uniform(-2, 2, (n, 2))
    high = low + rng.uniform(0.1, 3, (n, 2))
    corners = [low, np.c_[high[:, 0], low[:, 1]], high, np.c_[low[:, 0], high[:, 1]]]
    centers = np.c_[low[:, 0] + rng.uniform(0, 1, n) * (high - low)[:, 0], low[:, 1] - rng.uniform(0.1, 1, n)]
    mirror, swap = rng.choice([-1.0, 1.0], (n, 1, 2)), rng.random((n, 1, 1)) < 0.5
    points = np.stack([centers, *corners], axis=1) * mirror
    points = np.where(swap, points[..., ::-1], points)
    return points[:, 0], low[:, 1] - centers[:, 1], points[:, 1:]


def tiny_on_edges(rng, n):
    """Radii near or far below the last places of coordinates; centers on edges, on corners and a float or two off."""
    _, _, rings = resting_exactly(rng, n) if rng.random() < 0.5 else resting(rng, n, 5)
    w = rng.choice([0, 0.25, 0.5, 1], (n, 1))
    centers = jolt(rng, rings[:, 0] + w * (rings[:, 1] - rings[:, 0]), 2)
    return centers, 2.0 ** -rng.choice([1, 30, 52, 53, 54, 60, 105, 120], n) * rng.uniform(1, 2, n), rings


def beside_corners(rng, n):
    """Turned squares with a circle under a corner: foot and corner are as far, until a float moves."""
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
    """Triangles no higher than rounding, and circles no larger."""
    p, q = rng.uniform(-1, 1, (2, n, 2))
    rings = np.stack([p, q, p + rng.uniform(0.1, 0.9, (n, 1)) * (q - p)], axis=1)
    rings[:, 2, 1] = np.nextafter(np.nextafter(rings[:, 2, 1], 9), 9)
    keep = exact_signs.orient(*rings.reshape(n, 6).T) != 0
    centers = jolt(rng, p + rng.uniform(0, 1, (n, 1)) * (q - p), 3)
    return centers[keep], (2.0 ** -rng.choice([50, 53, 54, 56, 70], n))[keep], rings[keep]


def at_the_end_of_a_long_edge(rng, n):
    """The foot lies within what rounds off the edge's length, before or behind the end; the radius between both."""
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


def jolt(rng, values, most):
    """Each up to `most` floats up or down."""
    steps = rng.integers(-most, most + 1, values.shape)
    for k in range(1, most + 1):
        values = np.where(np.abs(steps) >= k, np.nextafter(values, np.where(steps > 0, np.inf, -np.inf)), values)
    return values


def a_float_off(make):
    def made(rng, n):
        centers, radii, rings = make(rng, n)
        return jolt(rng, centers, 1), jolt(rng, radii, 1), rings

    return made


def moved(make):
    """Scaled by 2**-300 to 2**300, or shifted by up to 2**40: what is then rounded is the question."""

    def made(rng, n):
        made = make(rng, n)
        scale, shift = 2.0 ** rng.integers(-300, 301, n), 2.0 ** rng.integers(0, 41, n)
        scale, shift = np.where(rng.random(n) < 0.5, (scale, 0 * shift), (np.ones(n), shift))
        return tuple((c.T * scale + (0 if c.ndim == 1 else shift)).T for c in made)

    return made


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


def batches_from(made):
    centers, radii, rings = made
    return batch.Circles(centers, radii), batch.Polygons(rings.copy())


@pytest.mark.parametrize("kind", COMMON | RARE)
def test_circles_that_rest_on_polygons_are_exact(kind):
    for seed in range(4):
        circles, polygons = batches_from((COMMON | RARE)[kind](RNG(seed), 200))
        right = [oracle.relation(p, q) for p, q in zip(scalar(circles), scalar(polygons))]
        found = {engine: batch.relate(circles, polygons, engine=engine).tolist() for engine in ENGINES}
        c, p = circles.uniform, polygons.uniform
        found["all undecided"] = (1 - circle_polygons.gap_signs(c.x[0], c.y[0], c.r, p.x, p.y)).tolist()
        found["swapped"] = batch.relate(polygons, circles).tolist()
        assert found == dict.fromkeys(found, right)


@pytest.mark.parametrize("e", [-470, -450, 0, 470])
def test_numbas_filter_tells_of_circles_what_the_plain_one_tells(e):
    """Of those that rest on polygons or on each other, by about as much as rounding may hide, and of plain ones."""
    kernels = kernels_of("filter")
    rng, told = RNG(e + 500), []

    def both(name, *columns):
        outs = [np.full(len(columns[0]) - 3, 9, np.int8) for _ in "ab"]
        with np.errstate(all="ignore"):
            getattr(kernels, name)(*columns, 3, outs[0])
            getattr(filter_numpy, name)(*columns, 3, outs[1])
        assert outs[0].tolist() == outs[1].tolist()
        told.extend(outs[0].tolist())

    plain = [
        lambda _, n, v=v: (rng.uniform(-2, 2, (n, 2)), rng.uniform(0.1, 1, n), ngons(rng, n, v)) for v in (3, 5, 9)
    ]
    for make in [*(COMMON | RARE).values(), *plain]:
        centers, radii, rings = make(rng, 40)
        radii = radii * (1 + rng.integers(-9, 10, len(radii)) * 2.0 ** rng.choice([-52, -45, -44, -40], len(radii)))
        c, p = (s.uniform for s in batches_from((centers * 2.0**e, radii * 2.0**e, rings * 2.0**e)))
        both("circle_polygons", c.x[0], c.y[0], c.r, p.x, p.y)
    for near in (1, 0.5, 1e-9):
        x, y, z = TRIPLES[rng.integers(0, len(TRIPLES), 40)].T * 2.0**e * near
        radii = z * (1 + rng.integers(-9, 10, 40) * 2.0 ** rng.choice([-52, -50, -49, -40], 40)) / 2
        both("circles", x, -y, z / 2, np.zeros(40), np.zeros(40), radii)
    assert all(told.count(k) > 20 for k in ((UNDECIDED,) if e == -470 else (0, 2, UNDECIDED)))


@pytest.mark.parametrize(
    ("e", "told"), [(-500, False), (-446, False), (-430, True), (476, True), (486, False), (511, False)]
)
@pytest.mark.parametrize("engine", ENGINES)
def test_the_filter_tells_of_circles_what_products_in_the_range_of_floats_tell(engine, e, told):
    kernels = filter_numpy if engine == "numpy" else kernels_of("filter")
    rng, size = RNG(e + 500), 2.0**e
    c, p = circles(rng, 50).uniform, batch.Polygons(regular(rng, 50, 5)).uniform
    out = np.empty(50, np.int8)
    with np.errstate(all="ignore"):
        kernels.circle_polygons(c.x[0] * size, c.y[0] * size, c.r * size, p.x * size, p.y * size, 0, out)
    assert {0, 2} <= set(out) if told else set(out) == {UNDECIDED}


@pytest.mark.parametrize(
    ("center", "radius", "ring", "right"),
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
        *(  # straight off an end of an edge but for a little: beyond it, and before it
            (at, 5, [(0, 0), (3, 4), (-10, 5)], right)
            for e, right in ((2.0**-50, 0), (-(2.0**-50), 1))
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
def test_circles_are_exact_where_all_hangs_on_what_was_rounded_off_or_lost(center, radius, ring, right):
    assert oracle.relation(sv.Circle(center, radius), sv.Polygon(ring)) == right
    circles, polygons = batch.Circles([center] * 50, radius), batch.Polygons([ring] * 50)
    assert batch.relate(circles, polygons, engine="numpy").tolist() == [right] * 50


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("e", [-460, -500, -532, -536, -538, -545])
def test_circles_are_exact_over_an_edge_so_short_that_its_square_loses_bits(e, engine):
    rng = RNG(-e)
    x, half = rng.uniform(-1, 1, 100), rng.uniform(0.8, 1.5, 100)
    points = np.zeros((100, 5, 2))  # center, the ends of the edge below, two more corners
    points[:, :3, 0] = np.stack([x, half, -half], axis=1) * 2.0**e
    points[:, 0, 1], points[:, 3:] = 1, [(-1, -1), (1, -1)]
    radii = rng.choice([0.8, 1 - 2.0**-10, 1, 1, 1, 1, 1 + 2.0**-10, 1.2], 100)
    for turns in range(4):
        circles, polygons = batch.Circles(points[:, 0], radii), batch.Polygons(points[:, 1:])
        right = [oracle.relation(p, q) for p, q in zip(scalar(circles), scalar(polygons))]
        assert set(right) == {0, 1, 2}
        assert batch.relate(circles, polygons, engine=engine).tolist() == right, turns
        points = turned(points)


def test_circles_are_exact_with_ragged_and_repeated_vertices():
    rng = RNG(2)
    made = [make(rng, 60) for make in (resting, COMMON["near 8-gons"], resting_on_boxes, resting_exactly)]
    rings = [ring for _, _, rings in made for ring in rings.tolist()]
    rings = [ring[:1] + ring[::-1] if i % 3 else ring[::-1] + ring[-1:] for i, ring in enumerate(rings)]
    circles = batch.Circles(*(np.concatenate([m[k] for m in made]) for k in (0, 1)))
    order = rng.permutation(len(rings))
    circles, polygons = circles[order], batch.Polygons([rings[i] for i in order])
    right = [oracle.relation(p, q) for p, q in zip(scalar(circles), scalar(polygons))]
    for engine in ENGINES:
        assert batch.relate(circles, polygons, engine=engine).tolist() == right


@pytest.mark.slow
def test_what_floats_settle_of_the_hard_pairs_is_right():
    """Those of every scale too, up to overflow and down to the smallest floats."""
    known = [(a, b) for _, a, b in pairs(3, 250 * len(CONVEX), list(CONVEX))]
    known = [(a, b) if isinstance(a, sv.Circle) else (b, a) for a, b in known if type(a) is not type(b)]
    known = [(c, p) for c, p in known if len(sv.parts(p)) == 1]
    circles, polygons = batches_of([c for c, _ in known]).groups[1], batch.Polygons([p for _, p in known])
    settled = 0
    for v, group in polygons.groups.items():
        mine = np.flatnonzero(polygons.count == v)
        columns = circles.x[0, mine], circles.y[0, mine], circles.r[mine], group.x, group.y
        with np.errstate(all="ignore"):
            found = circle_polygons._float_signs(*columns)
        for i, value in zip(mine, found):
            assert value in (exact_signs.UNKNOWN, 1 - oracle.relation(*known[i])), known[i]
        settled += (found != exact_signs.UNKNOWN).sum()
    assert settled > len(known) / 2


@pytest.mark.parametrize("kind", COMMON)
def test_hardly_a_circle_on_a_polygon_needs_integers(kind, monkeypatch):
    counted = []
    real = circle_polygons._integer_sign
    monkeypatch.setattr(circle_polygons, "_integer_sign", lambda *columns: counted.append(1) or real(*columns))
    circles, polygons = (shapes.uniform for shapes in batches_from(COMMON[kind](RNG(5), 5000)))
    circle_polygons.gap_signs(circles.x[0], circles.y[0], circles.r, polygons.x, polygons.y)
    assert len(counted) <= 5


@pytest.mark.parametrize("kind", COMMON)
def test_of_a_circle_on_a_polygon_only_what_may_lie_within_its_radius_is_settled(kind):
    """A corner or a foot of it, or a corner and the foot beside it."""
    circles, polygons = (shapes.uniform for shapes in batches_from(COMMON[kind](RNG(5), 300)))
    *asked, inside, room = within_reach(circles, polygons)
    assert np.bincount(np.concatenate(asked) % 300).max() <= 2
    assert not inside.size and (room < np.inf).all()


def within_reach(circles, polygons):
    x, y = (circle_polygons._close_rings(c) for c in (polygons.x, polygons.y))
    with np.errstate(all="ignore"):
        return circle_polygons._features_within_radius(circles.x[0], circles.y[0], circles.r, x, y)


@pytest.mark.parametrize(("e", "told"), [(-470, False), (-430, True), (460, True), (486, False), (505, False)])
def test_floats_settle_circles_on_polygons_only_where_products_stay_in_their_range(e, told):
    made = [values * 2.0 ** (e - 10) for values in resting_exactly(RNG(3), 50)]
    circles, polygons = (shapes.uniform for shapes in batches_from(made))
    *places, room = within_reach(circles, polygons)
    assert (room == np.inf).tolist() == [not told] * 50
    if not told:
        assert not any(place.size for place in places)
    columns = circles.x[0], circles.y[0], circles.r, polygons.x, polygons.y
    with np.errstate(all="ignore"):
        found = circle_polygons._float_signs(*columns)
    assert found.tolist() == ([0] * 50 if told else [exact_signs.UNKNOWN] * 50)
    assert circle_polygons.gap_signs(*columns).tolist() == [0] * 50


def test_an_edge_whose_square_may_lose_bits_leaves_circles_to_integers():
    shapes = batch.Circles([(0, -1)], 1), batch.Polygons([[(-1, 0), (2.0**-470, 0), (0, 2.0**-470)]])
    *places, room = within_reach(*(shape.uniform for shape in shapes))
    assert room == np.inf and not any(place.size for place in places)


@pytest.mark.parametrize("engine", ENGINES)
def test_circles_on_polygons_beyond_a_block_are_told_as_those_in_it(engine):
    """Each third circle touches its polygon exactly, the others have the next larger or smaller radius."""
    n = 2 * circle_polygons.BLOCK_PAIRS + 5
    centers, radii, rings = resting_exactly(RNG(3), n)
    kind = np.arange(n) % 3
    radii = np.where(kind == 1, radii, np.nextafter(radii, np.where(kind, np.inf, 0)))
    circles, polygons = batches_from((centers, radii, rings))
    assert (batch.relate(circles, polygons, engine=engine) == kind).all()


def on_long_edges(rng, n):
    """Circles that touch an edge from without or within, near its one end; the other is 2**10 to 2**40 radii away."""
    x, y, z = TRIPLES[rng.integers(0, len(TRIPLES), n)].T
    along, outside = np.stack([x, y], axis=1), rng.choice([-1, 1], (n, 1))
    near, far = -rng.integers(0, 3, (n, 1)) * along, 2.0 ** rng.integers(10, 41, (n, 1)) * along
    m = rng.integers(1, 4, (n, 1))
    rings = np.stack([near, far, far - turned(along) * 2.0**42 - along], axis=1)
    centers, mirrored = m * turned(along) * outside + along, rng.random((n, 1)) < 0.5
    flip = np.where(mirrored, [-1, 1], [1, 1])
    return centers * flip, m[:, 0] * z, rings * flip[:, None], outside[:, 0]


@pytest.mark.parametrize("seed", range(5))
def test_circles_that_touch_long_edges_from_without_and_within_are_exact(seed):
    centers, radii, rings, outside = on_long_edges(RNG(seed), 200)
    for more in 0, 1, -1:
        made = batches_from((centers, radii * (1 + more * 2.0**-50), rings))
        c, p = (shapes.uniform for shapes in made)
        found = circle_polygons.gap_signs(c.x[0], c.y[0], c.r, p.x, p.y)
        assert found.tolist() == np.where(outside < 0, -1, -more).tolist()
        for engine in ENGINES:
            assert batch.relate(*made, engine=engine).tolist() == (1 - found).tolist()


@pytest.mark.parametrize("kind", ["near triangles", "near, moved", "slivers"])
def test_turns_in_two_floats_are_off_by_less_than_granted(kind, monkeypatch):
    """Granted are 256 roundings of roundings, 88 can be shown, besides the sum's own; the worst found is told."""
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
            right = turn * int(side[i]) - r * ((qx - px) ** 2 + (qy - py) ** 2).sqrt()
            error = abs(Decimal(total[i]) - right) - abs(right) / 2**53
            worst = max(worst, float(error / Decimal(off[i])) * 256)
    print(f"{kind}: worst {worst:.1f} of 256")
    assert 0 < worst < 88


# -- polygons that floats leave undecided


def test_upright_boxes_among_other_shapes_of_four_corners_are_settled_by_their_sides(monkeypatch):
    """Side by side, where all of one batch are looked at together; exact signs are asked of the others only."""
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
    asked = []
    real = exact_signs.orient
    monkeypatch.setattr(exact_signs, "orient", lambda *c: asked.extend(c[0]) or real(*c))
    a, b = batch.Polygons(rings), batch.Polygons(others)
    assert batch.relate(a, b, engine="numpy").tolist() == batch.relate(b, a, engine="numpy").tolist() == known
    asked.clear()
    only = [*range(50), 151]
    assert batch.relate(a[only], b[only], engine="numpy").tolist() == [known[i] for i in only]
    assert not asked


def leaning(rng, n, v, w):
    """Polygons and others turned about a point of an edge, or a corner, of theirs: they touch but for rounding."""
    rings = ngons(rng, 4 * n, v)
    rings = rings[(rings * turned(np.roll(rings, -1, axis=1))).sum(axis=(1, 2)) > 0.2][:n]
    spot = rings[:, 0] + rng.choice([0, 0.25, rng.random()], (len(rings), 1)) * (rings[:, 1] - rings[:, 0])
    return rings, spot[:, None] - rng.uniform(0.5, 2, (len(rings), 1, 1)) * (rings[:, :w] - spot[:, None])


@pytest.mark.parametrize("scale", [2.0**-525, 2.0**-70, 2.0**-30, 1.0, 2.0**200, 2.0**511])
@pytest.mark.parametrize("far", one_in(2, [(0, 0), (1000, -1000)]))
@pytest.mark.parametrize(("v", "w"), [(3, 3), (4, 4), (8, 5), (20, 20)])
def test_polygons_that_lean_on_each_other_are_exact(v, w, far, scale):
    rng = RNG(v)
    p, q = (jolt(rng, (rings + far) * scale, most) for rings, most in zip(leaning(rng, 160 // v, v, w), (0, 1)))
    good = [i for i in range(len(p)) if all(batch_takes(rings[i], k) for rings, k in ((p, v), (q, w)))]
    p, q = batch.Polygons(p[good]), batch.Polygons(q[good])
    right = [oracle.relation(one, other) for one, other in zip(scalar(p), scalar(q))]
    index = np.arange(len(p))
    found = {engine: batch.relate(p, q, engine=engine).tolist() for engine in ENGINES}
    found |= {
        f"{engine} by index": batch.relate(p, q, np.c_[index, index], engine=engine).tolist() for engine in ENGINES
    }
    found["all undecided"] = exact_numpy.relations(p.uniform, index, q.uniform, index).tolist()
    found["all undecided, swapped"] = exact_numpy.relations(q.uniform, index, p.uniform, index).tolist()
    assert found == dict.fromkeys(found, right)


def batch_takes(ring, v):
    """Is it convex with all its corners, whatever was rounded?"""
    try:
        polygon = sv.Polygon(ring)
    except sv.InvalidShape:
        return False
    return polygon.is_convex and len(polygon.corners) == v


@pytest.mark.parametrize(("v", "w"), [(5, 5), (8, 5), (9, 20)])
def test_every_edge_is_asked_whichever_corner_the_search_begins_at(v, w, monkeypatch):
    rng = RNG(v * w)
    monkeypatch.setattr(
        exact_numpy, "_facing_corner", lambda own, other: rng.integers(0, own.edge_count, own.x.shape[1])
    )
    p, q = (batch.Polygons(ngons(rng, 300, k)) for k in (v, w))
    index = np.arange(300)
    right = one_by_one(p, q)
    assert 0 < right.count(0) < 300
    assert exact_numpy.relations(p.uniform, index, q.uniform, index).tolist() == right
    assert exact_numpy.relations(q.uniform, index, p.uniform, index).tolist() == right


@pytest.mark.parametrize("v", [40, 100])
def test_of_many_corners_only_those_near_the_other_shape_are_asked(v, monkeypatch):
    """Shapes and those turned about a corner of theirs, wherever they lie."""
    rng = RNG(v)
    asked = []
    real = exact_numpy._classify_edges
    monkeypatch.setattr(exact_numpy, "_classify_edges", lambda *c: asked.extend(c[3]) or real(*c))
    exactly, orient = [], exact_signs.orient
    monkeypatch.setattr(exact_signs, "orient", lambda *c: exactly.extend(c[0]) or orient(*c))
    for far in ((0, 0), (30, -20), (-1000, 1000)):
        a = np.round(ngons(rng, 200, v) * 2.0**30) * 2.0**-30 + far
        spot = a[np.arange(200), rng.integers(0, v, 200)][:, None]
        p, q, index = batch.Polygons(a).uniform, batch.Polygons(2 * spot - a).uniform, np.arange(200)
        for one, other in ((p, q), (q, p)):
            asked.clear(), exactly.clear()
            assert (exact_numpy.relations(one, index, other, index) == 1).all()
            assert len(asked) <= 7 * 200


@pytest.mark.parametrize("turn", [[[1, 0], [0, 1]], [[0, 1], [-1, 0]], [[-1, 0], [0, -1]], [[3, 4], [-4, 3]]], ids=str)
def test_edges_on_one_line_meet_where_their_ranges_on_it_do(turn, monkeypatch):
    rng = RNG(10)
    monkeypatch.setattr(
        exact_numpy, "_facing_corner", lambda own, other: rng.integers(0, own.edge_count, own.x.shape[1])
    )
    house = np.array([(0, 0), (4, 0), (6, 2), (6, 4), (4, 6), (0, 6), (-2, 4), (-2, 2)])
    moves = np.repeat([-20, -1, 0, 1, 4, 8, 9, 20], 10)
    below = np.stack([[t, 0] - house for t in moves]) @ turn
    a, b = batch.Polygons(np.array([house] * len(moves)) @ turn), batch.Polygons(below)
    right = [int(0 <= t <= 8) for t in moves]
    index = np.arange(len(moves))
    for one, other in ((a, b), (b, a)):
        assert exact_numpy.relations(one.uniform, index, other.uniform, index).tolist() == right
        assert batch.relate(one, other).tolist() == right


@pytest.mark.parametrize("scale", [1e-120, 1.0, 1e130])
@pytest.mark.parametrize("v", [3, 4, 5, 20])
def test_plain_pairs_are_asked_for_no_exact_sign_whatever_the_scale(v, scale, monkeypatch):
    rng = RNG(v)
    asked, in_doubt, edge = [], [], exact_numpy._classify_edges
    monkeypatch.setattr(exact_numpy, "_classify_edges", lambda *c: asked.extend(c[3]) or edge(*c))
    monkeypatch.setattr(exact_numpy, "_classify_on_line", lambda *c: in_doubt.append(c))
    rings = ngons(rng, 200, v)
    rings = rings[(rings * turned(np.roll(rings, -1, axis=1))).sum(axis=(1, 2)) > 0.5]
    a, b = (batch.Polygons((rings + far) * scale).uniform for far in (0, [1e-3, 2e-3]))
    index = np.arange(len(rings))
    assert (exact_numpy.relations(a, index, b, index) == 2).all()
    assert not asked or v > exact_numpy.MAX_ALL_EDGES_CORNERS
    a, b = (batch.Polygons(ngons(rng, 200, v) * scale).uniform for _ in "ab")
    exact_numpy.relations(a, np.arange(200), b, np.arange(200))
    assert not in_doubt


def test_the_largest_magnitude_of_a_column_is_of_either_sign_and_axis():
    x, y = RNG(11).uniform(-1, 1, (2, 3, 100))
    assert np.array_equal(exact_numpy._max_coordinates(x, y), np.abs(np.concatenate([x, y])).max(axis=0))


@pytest.mark.parametrize("scale", [2.0**-30, 1.0, 2.0**30])
@pytest.mark.parametrize(("v", "w"), [(3, 3), (8, 5), (4, 40), (40, 4), (40, 40)])
def test_plain_pairs_are_told_by_the_filter(v, w, scale):
    rng = RNG(v * w)
    a, b = (batch.Polygons(ngons(rng, 100, k) * scale) for k in (v, w))
    out = np.empty(100, np.int8)
    with np.errstate(all="ignore"):
        filter_numpy.polygons(a.uniform, b.uniform, 0, out)
    assert (out == UNDECIDED).sum() <= 5
    assert all(found in (UNDECIDED, right) for found, right in zip(out, one_by_one(a, b)))


@pytest.mark.parametrize("scale", [2.0**-30, 1.0, 2.0**30])
@pytest.mark.parametrize(("v", "w"), [(3, 3), (8, 5), (16, 3)])
def test_the_float32_look_is_granted_room_for_every_corner(v, w, scale, monkeypatch):
    """Side by side and by index, for wide shapes and for high ones, above and below the origin."""
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
    for ax, ay, bx, by, room in seen:
        size = np.sqrt(room.astype(float) / filter_numpy.ERROR_FACTOR_F32)
        for x, y in ((ax, ay), (bx, by)):
            assert (size * (1 + 1e-6) >= np.maximum(np.abs(x - ax[0]), np.abs(y - ay[0])).max(axis=0)).all()


@pytest.mark.parametrize("engine", ENGINES)
def test_upright_boxes_are_told_by_their_sides_from_any_first_corner_of_each(engine, monkeypatch):
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
def test_circles_that_rest_on_each_other_are_exact(scale):
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
    right = [oracle.relation(p, q) for p, q in zip(scalar(a), scalar(b))]
    assert set(right) == {0, 1, 2}
    for one, other in ((a, b), (b, a)):
        for engine in ENGINES:
            assert batch.relate(one, other, engine=engine).tolist() == right
        p, q = one.uniform, other.uniform
        assert (1 - exact_signs.circle_gap_signs(p.x[0], p.y[0], p.r, q.x[0], q.y[0], q.r)).tolist() == right


@pytest.mark.parametrize("scale", [1e-120, 1.0, 1e120])
def test_plain_circles_are_told_by_the_filter(scale):
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
        right = [sv.relate(p, q) for p, q in zip(scalar(circles), scalar(polygons))]
        c, p = circles.uniform, polygons.uniform
        assert (1 - circle_polygons.gap_signs(c.x[0], c.y[0], c.r, p.x, p.y)).tolist() == right
        for engine in ENGINES:
            assert batch.relate(circles, polygons, engine=engine).tolist() == right


@pytest.mark.parametrize(("v", "w"), [(3, 5), (20, 20), (4, 4)])
def test_a_kernel_told_to_begin_further_on_answers_for_those_columns(v, w):
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


@pytest.mark.parametrize("large", [0, 1])
def test_the_few_steps_of_many_corners_are_granted_room_for_the_largest_coordinates(large, monkeypatch):
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
def test_what_a_few_steps_tell_is_right_wherever_the_other_shape_lies(other):
    """At all whole places: touching at corners, along edges and by parts of these among them."""
    one = np.array([(0, 0), (2, -1), (4, 0), (5, 3), (4, 5), (0, 5), (-1, 2)])
    places = np.stack(np.meshgrid(np.arange(-9, 10), np.arange(-9, 10)), axis=-1).reshape(-1, 1, 2)
    a, b = batch.Polygons(one + 0 * places), batch.Polygons(np.array(other) + places)
    right = one_by_one(a, b)
    for p, q in ((a.uniform, b.uniform), (b.uniform, a.uniform)):
        out = np.empty(len(right), np.int8)
        gjk.gjk(p.x, p.y, q.x, q.y, np.full(len(right), 30 * ERROR_FACTOR_F64), out)
        assert all(found in (UNDECIDED, told) for found, told in zip(out.tolist(), right))
        assert (out == UNDECIDED).sum() <= right.count(1) + 20


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("v", one_in(2, [3, 5, 9, 17, 24]))
def test_many_polygons_that_lean_on_each_other_are_right(v, engine):
    rng = RNG(v)
    rings, others = leaning(rng, 400, v, v)
    good = [i for i in range(len(rings)) if batch_takes(rings[i], v) and batch_takes(others[i], v)]
    a, b = batch.Polygons(rings[good]), batch.Polygons(others[good])
    assert batch.relate(a, b, engine=engine).tolist() == one_by_one(a, b)


def test_whether_the_foot_lies_between_the_ends_is_told_rightly_next_to_an_end():
    """Centers straight off an end of their edge but for rounding; differences lose bits too."""
    rng = RNG(18)
    n, known = 1000, 0
    p, q = rng.uniform(-1, 1, (2, n, 2)) * 10.0 ** rng.integers(-2, 3, (2, n, 1))
    c = p + turned(q - p) * rng.uniform(-3, 3, (n, 1))
    for ends in ((p, q), (q, p)):
        columns = *c.T, np.ones(n), *ends[0].T, *ends[1].T
        with np.errstate(all="ignore"):
            found = circle_polygons._keep_inner_feet(np.full(n, -1, np.int8), *columns)
        for told, cx, cy, _, px, py, qx, qy in zip(
            found.tolist(), *(map(Fraction, column.tolist()) for column in columns)
        ):
            along = (cx - px) * (qx - px) + (cy - py) * (qy - py)
            between = 0 < along < (qx - px) ** 2 + (qy - py) ** 2
            assert told in (exact_signs.UNKNOWN, -1 if between else 1)
            known += told != exact_signs.UNKNOWN
    assert known > 1.9 * n


@pytest.mark.parametrize("lost", [1.0, -1.0])
@pytest.mark.parametrize("y_first", [False, True])
def test_what_was_lost_of_a_difference_is_not_forgotten_where_all_else_adds_up_to_nothing(lost, y_first):
    """The center lies straight off an end of the edge, but for a 1 that is lost beside 2**100."""
    end, way = np.array([4, -3]) * 2.0**110, np.array([3, 4]) * 2.0**100
    known = [((lost, 0), end, end + s * way) for s in (1, -1)]  # lost between the center and the end
    known += [(np.array([3 * s - lost, -4 * s]), (-lost, 0), way[::-1]) for s in (1, -1)]  # and along the edge
    for c, p, q in known:
        for ends in ((p, q), (q, p)):
            cx, cy, px, py, qx, qy = (float(v) for point in (c, *ends) for v in point[:: -1 if y_first else 1])
            columns = [np.array([v]) for v in (cx, cy, 1.0, px, py, qx, qy)]
            (told,) = circle_polygons._keep_inner_feet(np.full(1, -1, np.int8), *columns)
            cx, cy, px, py, qx, qy = map(Fraction, (cx, cy, px, py, qx, qy))
            along = (cx - px) * (qx - px) + (cy - py) * (qy - py)
            assert along and told in (exact_signs.UNKNOWN, -1 if 0 < along < (qx - px) ** 2 + (qy - py) ** 2 else 1)


@pytest.mark.parametrize("e", [-76, -75, -74, -73])
def test_nothing_wrong_is_told_where_float32_loses_the_bits_of_products(e):
    rng = RNG(1)
    a, b = (batch.Polygons(ngons(rng, 300, 3) * 2.0**e) for _ in "ab")
    assert batch.relate(a, b, engine="numpy").tolist() == one_by_one(a, b)


@pytest.mark.parametrize("v", [3, 4, 5, 8, 9])
@pytest.mark.parametrize("n", [1, 2, 128, 129, 300])
def test_the_maxima_of_a_tile_are_its_largest_edge_component_and_coordinate(n, v):
    """However the batch was made: validated by either engine, of rings, joined or chosen."""
    rng = RNG(n + v)
    rings = ngons(rng, n, v) * 2.0 ** rng.integers(-9, 9, (n, 1, 1))
    rings[::2] = rings[::2, ::-1]  # clockwise
    edges = np.abs(rings - np.roll(rings, 1, axis=1)).max(axis=(1, 2))
    starts = np.arange(0, n, 128)
    right = [np.maximum.reduceat(most, starts).tolist() for most in (edges, np.abs(rings).max(axis=(1, 2)))]
    groups = [batch.Polygons(rings).uniform, batch.Polygons(list(rings)).uniform]
    groups += [batch.Polygons(rings)[::-1][::-1].uniform, batch.concat([batch.Polygons(rings)]).uniform]
    if v <= 8:  # more corners are not validated in columns
        groups += [engines.engine_of(engine).certified_group(rings) for engine in ENGINES]
    for group in groups:
        assert [most.tolist() for most in group.tile_maxima] == right


def test_what_has_only_some_sides_of_an_upright_box_is_none():
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


# -- broad phase


def brute(bounds):
    i, j = np.triu_indices(len(bounds), 1)
    p, q = bounds[i], bounds[j]
    return np.stack([i, j], axis=1)[((p[:, :2] <= q[:, 2:]) & (q[:, :2] <= p[:, 2:])).all(axis=1)]


def layouts(n, rng):
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
            assert np.array_equal(batch.candidate_pairs(bounds, engine=engine), brute(bounds)), (name, engine)


@pytest.mark.parametrize("engine", ENGINES)
def test_candidates_beyond_a_block_are_found_as_those_in_it(engine):
    """A crowd of more pairs than the grid takes at a time."""
    at = RNG(1).uniform(0, 1, (1800, 2))
    bounds = np.c_[at, at + 0.9]
    pairs = brute(bounds)
    assert len(pairs) > 1 << 20
    assert np.array_equal(batch.candidate_pairs(bounds, engine=engine), pairs)


def in_cells(rng):
    """Boxes of like sizes in a few cells of any width and height, far from 0 or not; one half of them and the other.

    Some sides lie a float beside the borders of cells, so that lengths and places are rounded over them.
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
def test_cells_of_any_size_find_what_meets_and_each_pair_once(engine, seed, monkeypatch):
    grid, rng = importlib.import_module(f"satviz.batch.with_{engine}.grid"), RNG(seed)
    for n in range(16):
        monkeypatch.setattr(grid, "BLOCK_PAIRS", int(rng.choice([1, 7, 1 << 20])))
        bounds, one, other, cell = in_cells(rng)
        everything, all_pairs = np.arange(len(bounds)), brute(bounds)
        for these, those in (everything, None), (one, other), (everything[1:], everything[:1]):
            right = all_pairs if those is None else all_pairs[np.isin(all_pairs, those).sum(axis=1) == 1]
            found = np.concatenate([np.empty((0, 2), int), *grid.meeting_pairs(bounds, these, those, cell, np.inf)])
            assert np.array_equal(found[np.lexsort(found.T[::-1])], right), n


def grid_alone(grid):
    """An engine that finds all candidates by this grid, however few the boxes."""
    return engines.engine_of("numpy")._replace(grid=grid, candidate_pairs=lambda _: (None, None, None))


@pytest.mark.parametrize("seed", range(6))
def test_candidates_that_take_too_many_looks_are_split_until_alike_and_compared_once_each(seed):
    rng, sets = RNG(seed), []
    low = rng.uniform(-100, 100, (60, 2))
    bounds = np.hstack([low, low + 2.0 ** rng.uniform(0, [3, 20] if seed % 2 else [20, 3], (60, 2))])
    if seed >= 3:  # half of them of one size, which no split can part
        bounds[::2, 2:] = bounds[::2, :2] + [[2.0**-20, 1, 2.0**30][seed - 3]]
    size, farthest = bounds[:, 2:] - bounds[:, :2], np.abs(bounds).max()

    def too_many(given, one, other, cell, most):
        """Before nothing is left to split, whatever is asked is too much."""
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

    assert list(broad_phase.candidate_blocks(bounds, grid_alone(too_many))) == []
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
def test_cells_of_boxes_on_one_spot_are_as_fine_as_numbers_of_cells_can_be_told_apart(x, y):
    cells = []
    bounds = np.tile([x, y, x, y], (20, 1)).astype(float)
    assert list(broad_phase.candidate_blocks(bounds, grid_alone(lambda *given: cells.append(given[3:])))) == []
    far = max(abs(x), abs(y))
    assert cells == [([far * 2.0**-1000] * 2, broad_phase.MAX_CANDIDATES_PER_BOX * 20), ([far * 2.0**-48] * 2, np.inf)]


@pytest.mark.parametrize("n", [100, 3000])
def test_even_cells_are_as_many_as_the_boxes_would_be_spread_like_their_middle_half(n):
    """Whatever lies far outside; and where the middle half is wider than a float, the number is finite."""
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
def test_a_length_that_is_rounded_hides_no_box_that_begins_a_float_before_its_cells_border(engine, swap):
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
    """The last cell of a row that has 2**32, in row 2**31: the next number would be 2**63; from 0 on or about it."""
    grid = importlib.import_module(f"satviz.batch.with_{engine}.grid")
    low = np.array([(0, 0), (2**32 - 3, 2**31 - 2), (2**32 - 3, 2**31 - 2)]) - np.array([2**31, 2**30]) * about
    (found,) = grid.meeting_pairs(np.hstack([low, low + 1.0]), np.arange(3), None, (1.0, 1.0), np.inf)
    assert found.tolist() == [[1, 2]]


def test_the_grid_of_numpy_keeps_no_table_of_cells_in_which_hardly_anything_lies():
    x = np.arange(2000.0)
    bounds = np.c_[x, x, x + 1, x + 1] * 2
    tracemalloc.start()
    assert list(grid_numpy.meeting_pairs(bounds, np.arange(2000), None, (1.0, 1.0), np.inf)) != []
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 2e6


@pytest.mark.parametrize("seed", range(4))
def test_the_grid_of_numba_looks_as_often_as_it_says(seed, monkeypatch):
    grid, rng = kernels_of("grid"), RNG(seed)
    as_python(
        monkeypatch, grid, "build_table", "count_candidates", "fill_pairs", "_first_cell", "_cell_number", "_entry"
    )
    places, asked = in_python(grid._stored_range), []
    monkeypatch.setattr(grid, "_stored_range", lambda *given: asked.append(places(*given)) or asked[-1])
    for _ in range(15):
        bounds, one, other, cell = in_cells(rng)
        size = 1 << int(3 * len(other) // 2).bit_length()
        table = grid.build_table(bounds, other, *cell, size)
        told = grid.count_candidates(bounds[one], False, table)
        asked.clear()
        pairs = sum(map(len, grid._pair_blocks(one, bounds[one], False, table, 100)))
        assert told == sum(last - first for first, last in asked) >= pairs
        assert grid.meeting_pairs(bounds, one, other, cell, told) is not None
        assert told == 0 or grid.meeting_pairs(bounds, one, other, cell, told - 1) is None
        # among themselves in rows from a box's own on, so some more than are needed
        table = grid.build_table(bounds, one, *cell, size)
        told = grid.count_candidates(bounds[one], True, table)
        asked.clear()
        pairs = sum(map(len, grid._pair_blocks(table[1], table[2], True, table, 100)))
        looked = sum(last - first for first, last in asked)
        assert 2 * looked + 9 * len(one) >= told >= looked >= pairs


def test_of_many_boxes_the_grid_of_numba_asks_some_how_often_all_will_be_looked_at(monkeypatch):
    grid = kernels_of("grid")
    x, y = (c.ravel()[:1000] for c in np.meshgrid(np.arange(33.0), np.arange(33.0)))
    bounds = np.c_[x, y, x + 1, y + 1]
    table = grid.build_table(bounds, np.arange(1000), 1.0, 1.0, 2048)
    queried = []
    monkeypatch.setattr(grid, "_first_cell", lambda *given: queried.append(given) or 0)
    looks = in_python(grid.count_candidates)
    for n, each in ((999, 1), (1000, grid.SAMPLE_STEP)):
        queried.clear()
        looks(bounds[:n], False, table)
        assert len(queried) == 2 * -(-n // each)
    monkeypatch.undo()
    exact, told = grid.count_candidates(bounds[:999], True, table), grid.count_candidates(bounds, True, table)
    assert 0.9 < told / exact < 1.1


def test_the_grid_of_numpy_looks_at_those_in_the_cells_that_a_box_can_meet():
    rng = RNG(5)
    for _ in range(60):
        bounds, one, other, cell = in_cells(rng)
        longest = (bounds[other, 2:] - bounds[other, :2]).max(axis=0)
        first, last = np.floor((bounds[one, :2] - longest) / cell), np.floor(bounds[one, 2:] / cell)
        own = np.floor(bounds[other, :2] / cell)[:, None]
        looks = int(((first <= own) & (own <= last)).all(axis=2).sum())
        wider = int(((first - 1 <= own) & (own <= last)).all(axis=2).sum())  # where what is subtracted is rounded up
        assert grid_numpy.meeting_pairs(bounds, one, other, cell, wider) is not None
        assert looks == 0 or grid_numpy.meeting_pairs(bounds, one, other, cell, looks - 1) is None


TURNED = -6.123233995736766e-17  # what a quarter turn leaves of 0


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
def test_boxes_that_touch_by_a_rounding_are_candidates(places, step):
    rng = RNG(8)
    for _ in range(60):
        n = int(rng.integers(2, 40))
        low = places(rng, n, step)
        bounds = np.hstack([low, low + rng.choice([0, step, 2 * step, 1000 * step, 1e-17, 1], (n, 2))])
        for engine in ENGINES:
            assert np.array_equal(batch.candidate_pairs(bounds, engine=engine), brute(bounds))


def test_a_width_that_rounds_down_to_the_cell_hides_no_touch():
    assert batch.candidate_pairs([[-1e-17, 0, 1, 1], [1, 0, 2, 1]]).tolist() == [[0, 1]]
    x, y = (c.ravel() for c in np.meshgrid(np.arange(40), np.arange(40)))
    corners = np.stack([x, y, x + 1, y + 1], axis=1) - 20
    for turned in (corners * 1.0, corners * 0.1, corners + TURNED, np.where(corners == 0, TURNED, corners)):
        bounds = turned.astype(float)
        right = brute(bounds)
        for engine in ENGINES:
            assert np.array_equal(batch.candidate_pairs(bounds, engine=engine), right)


MOST = sys.float_info.max


def any_boxes(rng):
    """Sizes and places over the whole of float64, sums of tenths, points, needles both ways, clusters far away."""
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
def test_candidate_pairs_are_the_boxes_that_meet_of_whatever_size_and_place(engine):
    rng = RNG(9)
    for _ in range(300):
        bounds = any_boxes(rng)
        assert np.array_equal(batch.candidate_pairs(bounds, engine=engine), brute(bounds)), bounds.tolist()


def test_circles_that_reach_beyond_float64_collide_with_what_they_reach():
    coins = batch.Circles([(1.7e308, 1e300), (1.6e308, 0), (0, 0), (-1.7e308, 1)], [1e307, 1e308, 1, 2e306])
    known = scalar(coins)
    expected = [[i, j] for i in range(4) for j in range(i + 1, 4) if sv.relate(known[i], known[j])]
    assert expected and batch.colliding_pairs(coins).tolist() == expected


@pytest.mark.parametrize("engine", ENGINES)
def test_candidate_pairs_are_found_whatever_numpy_is_told_to_do_with_what_vanishes(engine):
    low = [[0, 0, 1, 1], [1, 0, 2, 1e-320], [5e-324, 0, 1e-300, 1e300]]
    with np.errstate(all="raise"):
        assert batch.candidate_pairs(low, engine=engine).tolist() == [[0, 1], [0, 2]]
        for bounds in [[0, 0, 0, 0], [1e-9, 0, 1e-9, 0], [5e-324, 0, 1e-300, 0]], [[-MOST, -MOST, MOST, MOST]] * 2:
            found = batch.candidate_pairs(bounds, engine=engine)
            assert len(found) == (len(bounds) == 2)


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize("finer", [0, 6, 12])
def test_the_grid_asks_few_rows_of_flat_boxes_so_far_out_that_floats_are_many_cells_apart(finer, side, monkeypatch):
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
    assert np.array_equal(found, brute(bounds))
    assert max(rows) <= 4


def test_pairs_keep_their_order_where_an_index_has_32_bits():
    found = broad_phase.sort_pairs([np.array([[50_000, 60_000], [1, 2]], np.int32)])
    assert found.tolist() == [[1, 2], [50_000, 60_000]]


def test_of_few_boxes_a_grid_of_numba_finds_all_pairs_whatever_its_samples_say():
    """A row of cells with 16 boxes in each second one, so that every 17th, which is sampled, meets no other box."""
    grid, n = kernels_of("grid"), 17 * 300
    place = np.arange(n) // 17 * 6 + np.where(np.arange(n) % 17, 3.1, 0.1)
    bounds = np.stack([place, 0 * place, place + 0.8, 0 * place + 1], axis=1)
    pairs = np.stack(np.triu_indices(16, 1), axis=1) + np.arange(1, n, 17)[:, None, None]
    table = grid.build_table(bounds, np.arange(n), 0.8, 1.0, 1 << 14)
    assert grid.count_candidates(table[2], True, table) == n  # it is said that each meets itself
    for engine in ENGINES:
        assert np.array_equal(batch.candidate_pairs(bounds, engine=engine), pairs.reshape(-1, 2))


def test_a_grid_of_numba_takes_few_blocks_whatever_its_samples_say(monkeypatch):
    grid = kernels_of("grid")
    monkeypatch.setattr(grid, "count_candidates", lambda *_: 0.0)
    x, y = (c.ravel() for c in np.meshgrid(np.arange(130.0), np.arange(130.0)))  # more than are told in one call
    bounds, blocks, real = np.c_[x, y, x + 1, y + 1], [], grid.fill_pairs
    monkeypatch.setattr(grid, "fill_pairs", lambda *given: blocks.append(1) or real(*given))
    i = np.arange(130 * 130)
    beside = [(i[inside], i[inside] + step) for step, inside in (
        (1, x < 129), (129, (x > 0) & (y < 129)), (130, y < 129), (131, (x < 129) & (y < 129)),
    )]  # fmt: skip
    pairs = np.concatenate([np.stack(both, axis=1) for both in beside])
    assert np.array_equal(batch.candidate_pairs(bounds, engine="numba"), pairs[np.lexsort(pairs.T[::-1])])
    assert 0 < len(blocks) < 10


def test_candidate_pairs_of_little_or_bad_input():
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
def test_the_looks_of_the_grid_grow_like_shapes_and_pairs(monkeypatch, engine):
    grid = importlib.import_module(f"satviz.batch.with_{engine}.grid")
    looked, blocks = [], grid._pair_blocks

    def counted(queries, boxes, *more):
        if engine == "numpy":
            looked.append(sum(int(many.sum()) for _, _, many in more[-1]))
        else:
            looked.append(grid.count_candidates(boxes, *more[:2]))
        return blocks(queries, boxes, *more)

    monkeypatch.setattr(grid, "_pair_blocks", counted)
    for name, at, size in layouts(1500, RNG(5)):
        if name == "every scale":  # 600 decades of sizes: as many size classes as shapes
            continue
        looked.clear()
        kernels = engines.engine_of(engine)._replace(candidate_pairs=lambda _: (None, None, None))  # also of few boxes
        found = sum(map(len, broad_phase.candidate_blocks(np.c_[at, at + size], kernels)))
        assert 0 < sum(looked) <= 5 * broad_phase.MAX_CANDIDATES_PER_BOX * (1500 + found), (name, sum(looked), found)


def test_colliding_pairs_are_those_of_every_pair():
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
    asked, real = [], collide.hits
    monkeypatch.setattr(collide, "hits", lambda *args, **how: asked.append(args) or real(*args, **how))
    rings = [kinds[i % len(kinds)] + at for i, at in enumerate(RNG(3).uniform(0, 8, (30, 2)))]
    known = [sv.Polygon(ring) for ring in rings]
    right = [[i, j] for i in range(30) for j in range(i + 1, 30) if sv.relate(known[i], known[j])]
    if come == "one by one":
        shapes = batch.concat([batch.Polygons([ring]) for ring in rings])
    elif come == "as one list":
        shapes = batch.Polygons(rings)
    else:
        shapes = batch.Polygons([WEDGE, *rings])[1:]
    assert batch.colliding_pairs(shapes, engine=engine, chunk=1000).tolist() == right  # as many shapes take it
    assert bool(asked) == (len(kinds) > 1 or kinds[0] is not BOX)
    assert batch.colliding_pairs(shapes, engine=engine).tolist() == right


@pytest.mark.parametrize("v", [1, 4])
def test_the_columns_of_chosen_shapes_lie_row_by_row_without_gaps(v):
    """Kernels are compiled for that."""
    shapes = circles(RNG(1), 20) if v == 1 else batch.Polygons(ngons(RNG(1), 20, v))
    for where in slice(3, 9), slice(2, 15, 2), slice(None, None, -1), np.array([7, 3, 3]), np.arange(20) % 3 == 0:
        for group in shapes[where].uniform, shapes.uniform.columns(np.arange(20)[where]):
            assert group.x.strides[1] == group.y.strides[1] == 8
            assert np.array_equal(group.x, shapes.uniform.x[:, where])
            assert v > 1 or (group.r.strides == (8,) and np.array_equal(group.r, shapes.uniform.r[where]))


@pytest.mark.parametrize(("v", "n"), [(3, 20_000), (300, 5_000)])
def test_circles_picked_with_polygons_are_looked_at_once_in_blocks_that_bound_the_memory(v, n, monkeypatch):
    rng, looked, real = RNG(v), [], narrow_phase._evaluate_block
    monkeypatch.setattr(narrow_phase, "_evaluate_block", lambda *args: looked.append(args[-1].size) or real(*args))
    some, polygons = circles(rng, 50), batch.Polygons(regular(rng, 50, v))
    pairs = rng.integers(0, 50, (n, 2))
    for a, b, index in (some, polygons, pairs), (polygons, some, pairs[:, ::-1]):
        assert batch.relate(a, b, index, engine="numpy").any()
        at_once = min(narrow_phase.BLOCK_PAIRS, max(exact_signs.MIN_BLOCK_PAIRS, exact_signs.MAX_BLOCK_CORNERS // v))
        assert set(looked[:-1]) == {at_once} and sum(looked) == n
        looked.clear()


@pytest.mark.parametrize("kinds", [(3, 3), (3, 300), (300, 3), (300, 300), (1, 3), (300, 1), (1, 1)])
def test_the_exact_twin_takes_each_pair_once_in_blocks_that_bound_the_memory(kinds, monkeypatch):
    looked = []
    for name in "_relate_circles", "_relate_polygons":
        monkeypatch.setattr(exact_numpy, name, lambda a, _: looked.append(len(a.x[0])) or np.zeros(looked[-1], np.int8))
    a, b = (circles(RNG(k), 2) if k == 1 else batch.Polygons(regular(RNG(k), 2, k)) for k in kinds)
    n = 100_000 if max(kinds) < 9 else 10_000
    exact_numpy.relations(a.uniform, np.zeros(n, np.intp), b.uniform, np.ones(n, np.intp))
    at_once = max(exact_signs.MIN_BLOCK_PAIRS, exact_numpy.BLOCK_CORNERS // max(kinds))
    if 1 in kinds:
        at_once = min(
            exact_numpy.BLOCK_SIGNS, max(exact_signs.MIN_BLOCK_PAIRS, exact_signs.MAX_BLOCK_CORNERS // max(kinds))
        )
    assert set(looked[:-1]) == {at_once} and sum(looked) == n


# -- executors


def run_with(executor, **more):
    rng = RNG(4)
    a, b = batch.Polygons(ngons(rng, 5000, 3)), batch.Polygons(ngons(rng, 5000, 4))
    index = rng.integers(0, 5000, (7000, 2))
    done = []
    found = batch.relate(a, b, executor=executor, chunk=900, progress=lambda *at: done.append(at), **more)
    assert found.tolist() == batch.relate(a, b).tolist()
    assert done == [(min(k, 5000), 5000) for k in range(900, 5401, 900)]
    assert batch.relate(a, b, index, executor=executor, chunk=900).tolist() == batch.relate(a, b, index).tolist()
    assert (
        batch.colliding_pairs(a[:500], executor=executor, chunk=5000).tolist()
        == batch.colliding_pairs(a[:500]).tolist()
    )


def run_split_with(executor, **more):
    """Concave shapes: chunks count shapes, whatever their parts."""
    rng = RNG(5)
    ell = np.array([(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)])
    rings = [ell + rng.uniform(0, 30, 2) if i % 3 else ngons(rng, 1, 5, 15)[0] for i in range(90)]
    shapes = batch.Polygons(rings, concave="split")
    done = []
    found = batch.relate(
        shapes, shapes[::-1], executor=executor, chunk=25, progress=lambda *at: done.append(at), **more
    )
    known = [sv.Polygon(ring) for ring in rings]
    assert found.tolist() == [sv.relate(p, q) for p, q in zip(known, known[::-1])]
    assert done == [(25, 90), (50, 90), (75, 90), (90, 90)]
    index = rng.integers(0, 90, (200, 2))
    found = batch.relate(shapes, shapes, index, chunk=30, **more)
    assert found.tolist() == [sv.relate(known[i], known[j]) for i, j in index]
    assert batch.colliding_pairs(shapes, chunk=50, **more).tolist() == [
        [i, j] for i in range(90) for j in range(i + 1, 90) if sv.relate(known[i], known[j])
    ]


class Elsewhere(Executor):
    """Does what it is handed at once and on a copy, as another process would; keeps what was sent."""

    def __init__(self):
        self.sent = []

    def submit(self, function, *args):
        self.sent.append(pickle.dumps((function, args)))
        function, args = pickle.loads(self.sent[-1])
        future = Future()
        future.set_result(function(*args))
        return future


@pytest.mark.parametrize("chunk", [2, 7, 12, 100])
def test_each_chunk_is_answered_for_its_own_pairs_wherever_the_work_is_done(chunk):
    rng = RNG(chunk)
    plain = [sv.Polygon(ring) for ring in ngons(rng, 12, 3)]
    mixed = [sv.Polygon(ring) for ring in (*ngons(rng, 5, 4), *(ELL + rng.uniform(-2, 2, (4, 1, 2))))]
    parted = batch.Polygons([p.vertices for p in mixed], concave="split")
    round_ = circles(rng, 3)
    known = [(batch.Polygons([p.vertices for p in plain]), plain)]
    known.append((batch.concat([parted, round_]), mixed + scalar(round_)))
    known += [(s[k : k + n], alone[k : k + n]) for s, alone in known[:2] for k, n in ((4, 1), (8, 1), (8, 2))]
    known.append((parted[:0], []))
    for (a, p), (b, q) in product(known, known):
        if len(a) != len(b) and 1 not in (len(a), len(b)):
            continue
        n = 0 if 0 in (len(a), len(b)) else max(len(a), len(b))
        side_by_side = [(i % len(a), i % len(b)) for i in range(n)]
        anyhow = rng.permutation(side_by_side)[: n // 2 + 1] if n else np.empty((0, 2), int)
        for index, asked in ((None, side_by_side), (anyhow, anyhow)):
            right = [int(sv.relate(p[i], q[j])) for i, j in asked]
            for executor in (None, Elsewhere()):
                done = []
                how = {"engine": "numpy", "executor": executor, "chunk": chunk}
                found = batch.relate(a, b, index, progress=lambda *at: done.append(at), **how)  # noqa: B023
                assert found.dtype == np.int8 and found.tolist() == right
                ends = [*range(chunk, len(right), chunk), len(right)] if right else []
                assert done == [(end, len(right)) for end in ends]
                assert executor is None or len(executor.sent) == len(ends)


@pytest.mark.parametrize("block", [1, 30, 100, 1000])
def test_of_plain_pairs_in_any_order_none_needs_an_exact_sign(block, monkeypatch):
    rng = RNG(block)
    shapes = batch.concat([circles(rng, 50), batch.Polygons(ngons(rng, 50, 3)), batch.Polygons(ngons(rng, 50, 4))])
    index = rng.integers(0, 150, (600, 2))
    right = [int(sv.relate(p, q)) for known in [scalar(shapes)] for p, q in ((known[i], known[j]) for i, j in index)]
    asked = []
    monkeypatch.setattr(narrow_phase, "BLOCK_PAIRS", block)
    real = narrow_phase.exact.relations
    monkeypatch.setattr(narrow_phase.exact, "relations", lambda *c: asked.extend(c[1]) or real(*c))
    assert batch.relate(shapes, shapes, index, engine="numpy").tolist() == right
    assert not asked


def outlines_of_all_numbers(rng, across):
    """Upright boxes, turned squares, and outlines of 3 to 12 corners, on whole numbers."""
    rings = [[(0, 0), (u, 0), (u, v), (0, v)] for u, v in rng.integers(1, 4, (4, 2))]
    rings += [[(0, 0), (2, 1), (1, 3), (-1, 2)], [(0, 0), (4, 0), (1, 3)], [(0, 0), (-1, 4), (-3, 1)]]
    rings += [3 * regular(rng, 1, v)[0] for v in (5, 6, 7, 8, 9, 12)]
    return [batch.Polygons([np.array(ring) + rng.integers(-across, across, 2)]) for ring in rings]


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("lanes", one_in(2, [3, 1, 128]))
def test_picked_outlines_of_all_numbers_of_corners_are_told_as_one_by_one(lanes, engine, monkeypatch):
    if engine == "numba":
        picked = kernels_of("indexed")
        as_python(monkeypatch, picked, "fill_relations")
        monkeypatch.setattr(picked, "LANES", lanes)
    monkeypatch.setattr(indexed, "pairs_per_block", lambda *_: lanes)
    rng = RNG(lanes)
    shapes = batch.concat(outlines_of_all_numbers(rng, 5) + outlines_of_all_numbers(rng, 8))
    known, every = scalar(shapes), np.argwhere(np.ones((len(shapes), len(shapes))))
    every = every[:: 3 if engine == "numba" else 1]  # which is slow as Python
    found = batch.relate(shapes, shapes, every, engine=engine)
    assert found.tolist() == [int(sv.relate(known[i], known[j])) for i, j in every]
    most = shapes.count[every].max(axis=1)
    for these in most <= 4, (most > 4) & (most <= 8), most > 8:
        assert set(found[these].tolist()) >= {0, 2}


@pytest.mark.parametrize("lanes", [7, 128])
def test_numba_asks_picked_pairs_that_are_plain_for_no_exact_sign(lanes, monkeypatch):
    """Nor upright boxes, nor, where the middle of what their boxes share is inside both, many corners for an axis."""
    picked = kernels_of("indexed")
    as_python(monkeypatch, picked, "fill_relations")
    monkeypatch.setattr(picked, "LANES", lanes)
    for name in "relate_few_corners", "relate_many_corners":
        monkeypatch.setattr(picked, name, lambda *_: pytest.fail("looked at longer"))
    monkeypatch.setattr(exact_numpy, "relations", lambda *_: pytest.fail("left to the exact twin"))
    look, sizes = picked._evaluate_lanes, []
    monkeypatch.setattr(picked, "_evaluate_lanes", lambda *given: sizes.append(given[10].size) or look(*given))
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
def test_columns_of_every_number_of_corners_are_told_by_numba_from_their_clearances(v, w):
    """Far beyond a room, or far within it, as if rounding could hide so much: the clearance itself is looked at."""
    kernels = kernels_of("filter")
    rng, first, n = RNG(v * w), 5, 300
    room = np.array([0.1, 0.2, 0.05])[np.arange(first, first + n) // arrays.TILE_SHAPES]  # each tile has its own
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
    assert out.tolist() == np.select([best > room, best < -room], [0, 2], UNDECIDED).tolist()
    assert min((out == told).sum() for told in (0, 2, UNDECIDED)) > 10


@pytest.mark.parametrize(("v", "w"), [(16, 3), (3, 16), (17, 3), (3, 17), (16, 16), (17, 17)])
def test_picked_outlines_of_many_corners_are_looked_at_in_a_few_steps_and_edges_asked_where_that_tells_nothing(
    v, w, monkeypatch
):
    looks, asked, widths = [], [], []
    for module, name in (indexed, "evaluate_f32"), (indexed.gjk, "gjk"):
        real = getattr(module, name)
        monkeypatch.setattr(
            module, name, lambda *c, name=name, real=real: looks.append(name) or widths.append(c[4]) or real(*c)
        )
    real = indexed.relate_edges
    monkeypatch.setattr(indexed, "relate_edges", lambda a, b: asked.append(a.x.shape[1]) or real(a, b))
    rng = RNG(v)
    a, b, far = (batch.Polygons(regular(rng, 20, n) + move) for n, move in ((v, 0), (w, 0), (w, 9)))
    p, q = (batch.Polygons(rings[:20]) for rings in beside_mirror(v, w))
    for one, other, right, left in (a, b, 2, 0), (a, far, 0, 0), (p, q, 1, 20):
        asked.clear()
        out = np.full(20, 9, np.int8)
        indexed.relations(one.flat, np.arange(20), other.flat, np.arange(20), out)
        assert out.tolist() == [right] * 20 and sum(asked) == left
    if max(v, w) <= 16:
        wide = [(s.bounds[:, 2:] - s.bounds[:, :2]).max(axis=1) for s in (a, b)]
        assert np.array_equal(widths[0], wide[0] + wide[1])
    assert set(looks) == {"evaluate_f32" if max(v, w) <= 16 else "gjk"}


def test_columns_of_three_and_four_corners_have_kernels_of_their_own():
    kernels = kernels_of("filter")
    own = {(v, w): kernels.clearance_kernel(v, w) for v in (3, 4) for w in (3, 4)}
    assert len({kernels._tile_kernel, *own.values()}) == 5
    assert all(kernels.clearance_kernel(*key) is own[key] for key in own)
    for key in (4, 5), (5, 4), (5, 5), (3, 8), (8, 3), (8, 8), (8, 7), (7, 8), (7, 7), (9, 9):
        assert kernels.clearance_kernel(*key) is kernels._tile_kernel


def test_circles_beside_up_to_eight_corners_have_kernels_of_their_own(monkeypatch):
    kernels = kernels_of("filter")
    served = []
    monkeypatch.setattr(kernels, "_circle_unrolled", lambda n: served.append(n) or (lambda *_: None))
    monkeypatch.setattr(kernels, "_circle_general", lambda *_: served.append("any"))
    for corners in (3, 8, 9):
        kernels.circle_polygons(*[np.zeros(1)] * 3, *[np.zeros((corners, 1))] * 2, 0, np.zeros(1, np.int8))
    assert served == [3, 8, "any"]


@pytest.mark.parametrize("scale", [1.0, 2.0**-90])
@pytest.mark.parametrize(("v", "w"), [(3, 3), (4, 4), (3, 8), (8, 8), (8, 5), (9, 5), (12, 12)])
def test_columns_that_floats_leave_undecided_are_settled_by_numba_and_the_others_left_as_they_are(v, w, scale):
    picked = kernels_of("indexed")
    a, touching = beside_mirror(v, w)
    for move in (0, 1, -1):
        p = batch.Polygons(a[:8] * scale)
        q = batch.Polygons((touching[:8] + np.array([move, 0.0])) * scale)
        right = one_by_one(p, q)
        out = np.array([UNDECIDED, 7, UNDECIDED, UNDECIDED, 5], np.int8)
        picked.columns(p.uniform, q.uniform, 3, out)
        assert out.tolist() == [right[3], 7, *right[5:7], 5]


@pytest.mark.parametrize("scale", [1.0, 2.0**-90])
@pytest.mark.parametrize(("v", "w"), [(3, 3), (4, 4), (3, 8), (8, 8), (8, 5), (9, 5), (12, 12)])
@pytest.mark.parametrize("engine", ENGINES)
def test_picked_pairs_that_touch_touch(v, w, scale, engine):
    a, touching = beside_mirror(v, w)
    p, q = batch.Polygons(a[:8] * scale), batch.Polygons(touching[:8] * scale)
    for one, other in (p, q), (q, p):
        found = batch.relate(one, other, np.repeat(np.arange(8)[:, None], 2, axis=1), engine=engine)
        assert found.tolist() == one_by_one(one, other) == [1] * 8


@pytest.mark.parametrize("w", [4, 7])  # one by one and in lanes
@pytest.mark.parametrize("e", [-600, -100, 0, 100, 400, 600])
def test_numbas_picked_pairs_are_granted_an_error_bound_for_the_widest_and_the_farthest(e, w, monkeypatch):
    picked = kernels_of("indexed")
    bound, granted = in_python(picked._error_bound), {}

    def seen(box_a, i, box_b, j):
        granted[i, j] = bound(box_a, i, box_b, j)
        return granted[i, j]

    as_python(monkeypatch, picked, "fill_relations", "_evaluate_lanes")
    monkeypatch.setattr(picked, "_error_bound", seen)
    rng = RNG(7)
    a, b = (batch.Polygons((ngons(rng, 40, v, 2) * rng.uniform(0.2, 5, (40, 1, 2))) * 2.0**e) for v in (3, w))
    index = rng.integers(0, 40, (200, 2))
    batch.relate(a, b, index, engine="numba")
    boxes = a.bounds[index[:, 0]], b.bounds[index[:, 1]]
    wide = sum((c[:, 2:] - c[:, :2]).max(axis=1) for c in boxes)
    with np.errstate(all="ignore"):
        room = wide * sum(np.abs(c).max(axis=1) for c in boxes) * ERROR_FACTOR_F64
    right = np.where((room > MIN_ERROR_BOUND) & (room < MAX_ERROR_BOUND), room, np.inf)
    right = dict(zip(map(tuple, index.tolist()), right.tolist()))
    assert len(granted) > 20 and all(granted[pair] == right[pair] for pair in granted)
    assert np.isinf(list(right.values())).all() == (abs(e) == 600)


@pytest.mark.parametrize("engine", ENGINES)
def test_parts_beyond_a_block_are_told_as_those_in_it(engine):
    """Six pairs of parts in each pair of shapes, so that a block ends amid a pair."""
    rng, cross = (
        RNG(1),
        [(1, 0), (2, 0), (2, 1), (3, 1), (3, 2), (2, 2), (2, 3), (1, 3), (1, 2), (0, 2), (0, 1), (1, 1)],
    )
    rings = [[ring + at for at in rng.uniform(0, 6, (20, 1, 2))] for ring in (ELL, np.array(cross))]
    a, b = (batch.Polygons(these, concave="split") for these in rings)
    assert (len(a.parts), len(b.parts)) == (40, 60)
    known = np.array([[sv.relate(sv.Polygon(p), sv.Polygon(q)) for q in rings[1]] for p in rings[0]])
    index = rng.integers(0, 20, (narrow_phase.BLOCK_PART_PAIRS // 6 + 1000, 2))
    first, rank = divmod(narrow_phase.BLOCK_PART_PAIRS, 6)  # the block ends before this pair of parts of this pair
    hits = (
        batch.hits(a.parts, b.parts, np.indices((40, 60)).reshape(2, -1).T)
        .reshape(20, 2, 20, 3)
        .transpose(0, 2, 1, 3)
        .reshape(20, 20, 6)
    )
    index[first] = np.argwhere(hits[..., rank] & (hits.sum(axis=2) == 1))[0]  # all hangs on these parts
    assert (batch.relate(a, b, index, engine=engine) == known[tuple(index.T)]).all()


@pytest.mark.parametrize("chunk", [0, -1])
@pytest.mark.parametrize("executor", [None, Elsewhere()])
def test_chunks_of_nothing_are_refused(chunk, executor):
    a = batch.Circles([(0, 0), (1, 0)], 1)
    with pytest.raises(ValueError, match=f"chunk is {chunk}: it must be at least 1"):
        batch.relate(a, a, engine="numpy", executor=executor, chunk=chunk)
    for shapes in a, a[:0], batch.Polygons([[(0, 0), (1, 0), (1, 1), (0, 1)]] * 2):
        with pytest.raises(ValueError, match=f"chunk is {chunk}: it must be at least 1"):
            batch.colliding_pairs(shapes, engine="numpy", executor=executor, chunk=chunk)


def test_only_a_few_chunks_are_under_way_at_once():
    a, pool, under_way = batch.Circles(np.zeros((50, 2)), 1), Elsewhere(), []
    progress = lambda done, total: under_way.append(len(pool.sent) - done + 1)  # noqa: E731
    batch.relate(a, a, engine="numpy", executor=pool, chunk=1, progress=progress)
    assert len(under_way) == 50 and max(under_way) == chunks.MAX_WAITING_CHUNKS


def test_to_elsewhere_each_chunk_takes_only_the_shapes_it_needs():
    rng = RNG(3)
    many, one = batch.Polygons(ngons(rng, 2000, 3)), batch.Polygons(ngons(rng, 1, 3))
    few = rng.integers(0, 5, (2000, 2))
    for a, b, index in ((many, many, None), (one, many, None), (many, one, None), (many, many, few)):
        pool = Elsewhere()
        batch.relate(a, b, index, engine="numpy", executor=pool, chunk=100)
        assert len(pool.sent) == 20
        assert max(map(len, pool.sent)) < len(pickle.dumps(many)) / 4


def test_threads_share_the_shapes_and_take_no_copies():
    handed = []

    class Watched(ThreadPoolExecutor):
        def submit(self, function, *args):
            handed.append(args)
            return super().submit(function, *args)

    a, b = (batch.Polygons(ngons(RNG(v), 30, v)) for v in (3, 4))
    index = np.arange(30)
    with Watched(1) as pool:
        for pairs in (None, np.c_[index, index]):
            handed.clear()
            batch.relate(a, b, pairs, engine="numpy", executor=pool, chunk=10)
            assert [sum(arg is a or arg is b for arg in args) for args in handed] == [2, 2, 2]


def test_colliding_pairs_are_told_as_they_were_asked_for():
    rings = ngons(RNG(2), 60, 3, 6)
    expected = batch.colliding_pairs(batch.Polygons(rings), engine="numpy").tolist()
    for strip in (0, 20, 60):
        pool, told = Elsewhere(), []
        how = {"engine": "numpy", "executor": pool, "progress": lambda *at: told.append(at)}  # noqa: B023
        if strip:
            blocks = list(batch.stream_colliding_pairs(rings, strip=strip, **how))
            found = np.concatenate(blocks)[np.lexsort(np.concatenate(blocks).T[::-1])]
            assert told == [(k + 1, 60 // strip) for k in range(60 // strip)]
        else:
            found = batch.colliding_pairs(batch.Polygons(rings), chunk=10, **how)
            assert len(told) == len(pool.sent) > 1 and told[0][0] == 10
        assert found.tolist() == expected
        assert pool.sent and {pickle.loads(sent)[1][-1] for sent in pool.sent} == {"numpy"}


def test_upright_boxes_alone_need_no_look_beyond_the_grid():
    boxes = RNG(2).uniform(0, 5, (30, 1, 2)) + np.array([(0, 0), (1, 0), (1, 1), (0, 1)])
    pool = Elsewhere()
    found = batch.colliding_pairs(batch.Polygons(boxes), executor=pool, engine="numpy")
    assert len(found) and not pool.sent


def test_hits_takes_the_arguments_of_relate():
    a = batch.Circles([(0, 0), (3, 0), (5, 0)], 1)
    with pytest.raises(ValueError, match="engine is 'none'"):
        batch.hits(a, a, engine="none")
    told = []
    how = {"engine": "numpy", "executor": Elsewhere(), "chunk": 1, "progress": lambda *at: told.append(at)}
    found = batch.hits(a, a, [[0, 1], [1, 2]], **how)
    assert found.tolist() == [False, True] and told == [(1, 2), (2, 2)]


@pytest.mark.parametrize("engine", ENGINES)
def test_threads_give_the_same_in_order(engine):
    with ThreadPoolExecutor(2) as pool:
        run_with(pool, engine=engine)
        run_split_with(pool, engine=engine)
    run_split_with(None, engine=engine)


def test_processes_give_the_same_in_order():
    with ProcessPoolExecutor(2) as pool:
        run_with(pool, engine="numpy")
        run_split_with(pool, engine="numpy")


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("v", one_in(2, [100, 200]))
def test_touching_shapes_of_many_corners_take_little_memory(engine, v):
    turns = 2 * np.pi * np.arange(v) / v
    ring = np.stack([np.cos(turns), np.sin(turns)], axis=1)
    corner = ring[np.arange(2048) % v][:, None]
    a, b = batch.Polygons(np.broadcast_to(ring, (2048, v, 2))), batch.Polygons(2 * corner - ring)  # a point reflection
    batch.relate(a[:1], b[:1], engine=engine)  # compiled
    tracemalloc.start()
    found = batch.relate(a, b, engine=engine)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert found.tolist() == [1] * 2048
    assert peak < 100e6


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("other", one_in(4, ["few corners", "touching circles", "as many corners", "circles"]))
def test_one_shape_of_many_corners_against_many_takes_little_memory(engine, other):
    """However it is copied beside each of them."""
    v, n = 2_000, 900
    k = np.arange(float(v))
    bowl = np.stack([k, k * k], axis=1)
    one, x = batch.Polygons([bowl]), np.floor(np.arange(n) * (v / n))
    if other == "circles":
        many = batch.Circles(np.stack([x, x * x - 3], axis=1), 0.5)
    elif other == "touching circles":
        many = batch.Circles(np.stack([x, x * x - 3], axis=1)[:1], 3)[[0] * n]
    elif other == "few corners":
        corner = np.stack([x, x * x], axis=1)[:40, None]
        many = batch.Polygons(corner + np.array([(0, 0), (-1, -9), (1, -9)]))
    else:
        many = batch.Polygons(np.stack([bowl, bowl - np.array([0, 1]), -bowl]))
    few = many[:3]
    assert batch.relate(one, few, engine=engine).tolist() == one_by_one(one[[0, 0, 0]], few)  # and compiled
    tracemalloc.start()
    batch.relate(one, many, engine=engine)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 50e6


def test_many_touching_circles_take_little_memory():
    n = 1 << 18
    a, b = batch.Circles(np.zeros((n, 2)), 1.0), batch.Circles(np.tile([3.0, 4.0], (n, 1)), 4.0)
    tracemalloc.start()
    found = batch.relate(a, b, engine="numpy")
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert (found == 1).all() and peak < 60e6


@pytest.mark.parametrize("engine", ENGINES)
def test_upright_boxes_are_never_asked_for_an_exact_sign(engine, monkeypatch):
    x, y = (c.ravel() * 0.1 for c in np.meshgrid(np.arange(20), np.arange(20)))
    tiles = np.stack([np.stack(c, axis=1) for c in ((x, y), (x + 0.1, y), (x + 0.1, y + 0.1), (x, y + 0.1))], axis=1)
    known = [sv.Polygon(tile) for tile in tiles]
    diamond = [(9, 8), (10, 9), (9, 10), (8, 9)]
    alone, beside = batch.Polygons(tiles), batch.Polygons([*tiles, diamond])
    everywhere = beside[::-1][1:][::-1]
    asked = []
    for module in (exact_signs, sv.engine.relate):
        monkeypatch.setattr(module, "orient", lambda *c: asked.append(c))
    for shapes in (alone, everywhere):
        pairs = batch.candidate_pairs(shapes.bounds)
        found = batch.relate(shapes, shapes, pairs, engine=engine)
        assert found.tolist() == [sv.relate(known[i], known[j]) for i, j in pairs]
        assert batch.colliding_pairs(shapes, engine=engine).tolist() == pairs.tolist()
    assert not asked


@pytest.mark.slow
def test_a_dask_cluster_of_two_workers_gives_the_same_in_order(tmp_path):
    distributed = pytest.importorskip("distributed", reason="the extra `cluster` is not installed")
    import dask

    dask.config.set({"temporary_directory": str(tmp_path)})
    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,
        distributed.Client(cluster) as client,
    ):
        run_with(client.get_executor(), engine="numpy")
        run_split_with(client.get_executor(), engine="numpy")


class Failing(ThreadPoolExecutor):
    """Fails the third piece of work."""

    count = 0

    def submit(self, function, *args):
        self.count += 1
        return super().submit(int, "no") if self.count == 3 else super().submit(function, *args)


def test_a_failed_chunk_names_its_range():
    a = batch.Polygons(ngons(RNG(1), 1000, 3))
    with Failing(1) as pool, pytest.raises(ChunkFailed, match="items 200 to 299 failed: ValueError") as failed:
        batch.relate(a, a, executor=pool, chunk=100)
    assert (failed.value.start, failed.value.stop) == (200, 300)
    again = pickle.loads(pickle.dumps(failed.value))  # as a pool of the caller's sends it
    assert (again.start, again.stop, str(again)) == (200, 300, str(failed.value))


def test_a_chunk_that_fails_without_any_pool_names_its_range_too(monkeypatch):
    real = narrow_phase._relate_range

    def failing(a, b, start, stop, engine):
        return real(a, b, start, stop, engine) if start != 200 else 1 / 0

    monkeypatch.setattr(narrow_phase, "_relate_range", failing)
    a, told = batch.Circles(np.zeros((1000, 2)), 1), []
    with pytest.raises(ChunkFailed, match="items 200 to 299 failed: ZeroDivisionError") as failed:
        batch.relate(a, a, engine="numpy", chunk=100, progress=lambda *at: told.append(at))
    assert (failed.value.start, failed.value.stop) == (200, 300) and told == [(100, 1000), (200, 1000)]


def test_a_pool_that_takes_no_work_names_the_range():
    a = batch.Polygons(ngons(RNG(1), 300, 3))
    pool = ThreadPoolExecutor(1)
    pool.shutdown()
    with pytest.raises(ChunkFailed, match="items 0 to 99 failed: RuntimeError"):
        batch.relate(a, a, executor=pool, chunk=100)


def test_an_interrupt_stops_the_work():
    a = batch.Polygons(ngons(RNG(1), 1000, 3))

    def stop(done, total):
        raise KeyboardInterrupt

    with ThreadPoolExecutor(1) as pool, pytest.raises(KeyboardInterrupt):
        batch.relate(a, a, executor=pool, chunk=10, progress=stop)


class Waiting(Executor):
    """Ends the first piece of work, with an error if there is one, and begins no other."""

    def __init__(self, error):
        self.error, self.futures = error, []

    def submit(self, function, *args):
        self.futures.append(future := Future())
        if len(self.futures) == 1:
            future.set_exception(self.error) if self.error else future.set_result(function(*args))
        return future


@pytest.mark.parametrize(("error", "told"), [(None, KeyboardInterrupt), (ValueError("no"), ChunkFailed)])
def test_an_interrupt_and_a_failed_chunk_cancel_those_that_wait(error, told):
    def stop(done, total):
        raise KeyboardInterrupt

    a, pool = batch.Circles(np.zeros((100, 2)), 1), Waiting(error)
    with pytest.raises(told):
        batch.relate(a, a, engine="numpy", executor=pool, chunk=10, progress=stop)
    assert len(pool.futures) == chunks.MAX_WAITING_CHUNKS and all(future.cancelled() for future in pool.futures[1:])


# -- streams


def test_a_file_in_strips_gives_each_pair_once(tmp_path):
    rings = ngons(RNG(6), 4000, 3, spread=60)
    np.save(tmp_path / "rings.npy", rings)
    mapped = np.load(tmp_path / "rings.npy", mmap_mode="r")
    told = []
    found = np.concatenate(list(batch.stream_colliding_pairs(mapped, strip=700, progress=lambda *at: told.append(at))))
    expected = batch.colliding_pairs(batch.Polygons(rings))
    assert sorted(map(tuple, found.tolist())) == [tuple(p) for p in expected.tolist()]
    assert told[-1] == (6, 6)
    assert list(batch.stream_colliding_pairs(rings[:0])) == []


@pytest.mark.parametrize("strip", [1, 5, 6, 7, 12, 40])
def test_a_stream_loses_no_pair_that_touches_where_a_strip_begins_and_reads_only_what_reaches_into_it(
    strip, monkeypatch
):
    x, y = RNG(3).permutation([(i, j) for i in range(9) for j in range(6)]).T
    diamonds = np.stack([np.c_[x, y - 0.5], np.c_[x + 0.5, y], np.c_[x, y + 0.5], np.c_[x - 0.5, y]], axis=1)
    read = []
    real = collide.number_polygons
    monkeypatch.setattr(collide, "number_polygons", lambda rings, *more: read.append(len(rings)) or real(rings, *more))
    found = np.concatenate(list(batch.stream_colliding_pairs(diamonds, strip=strip, engine="numpy")))
    expected = [[i, j] for i in range(54) for j in range(i + 1, 54) if abs(x[i] - x[j]) + abs(y[i] - y[j]) == 1]
    assert sorted(found.tolist()) == expected
    assert max(read) <= 12 + 2 * strip and len(read) <= 9


@pytest.mark.parametrize(
    ("thing", "words"),
    [([[(0, 0), (1, 0), (0, 1)]], "is a list"), (np.zeros((3, 2)), "an array of the shape \\(3, 2\\)")],
)
def test_what_no_stream_can_be_read_from_is_named(thing, words):
    with pytest.raises(sv.InvalidShape, match=words):
        next(batch.stream_colliding_pairs(thing))


def test_memory_mapped_arrays_are_taken_and_left_alone(tmp_path):
    rings = ngons(RNG(2), 50, 4)[:, ::-1]
    np.save(tmp_path / "rings.npy", rings)
    shapes = batch.Polygons(np.load(tmp_path / "rings.npy", mmap_mode="r"))
    assert one_by_one(shapes, shapes) == [2] * 50
    assert np.array_equal(np.load(tmp_path / "rings.npy"), rings)
