"""Tests of how much work is done and where: executors, chunks, memory, kernels on disk, files in strips."""

import inspect
import os
import pickle
import shutil
import subprocess
import sys
import tracemalloc
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from functools import partial
from itertools import product
from pathlib import Path

import numpy as np
import pytest
from batches import (
    ELL,
    ENGINES,
    RNG,
    Elsewhere,
    as_python,
    circles,
    compiled_kernels,
    kernels_of,
    names_any,
    ngons,
    numba_modules,
    one_by_one,
    regular,
    scalar,
)
from speeds import one_in

import satviz as sv
from satviz import batch
from satviz.batch import chunks, collide, exact_signs, narrow_phase
from satviz.batch.chunks import ChunkFailed
from satviz.batch.with_numpy import exact as exact_numpy


@pytest.mark.slow
def test_kernels_on_disk_are_compiled_anew_when_a_file_that_they_call_changes(tmp_path):
    pytest.importorskip("numba", reason="needs numba: python -m pip install '.[fast]'")
    shutil.copytree(Path(sv.__file__).parent, tmp_path / "satviz", ignore=shutil.ignore_patterns("__pycache__"))
    code = (
        "from satviz import batch; s = batch.Circles([(0, 0), (1, 0)], 1);"  # the kernel that is compiled soonest
        "print(batch.relate(s, s, [[0, 1]], engine='numba')[0])"
    )
    env = {k: v for k, v in os.environ.items() if k != "NUMBA_CACHE_DIR"} | {"PYTHONPATH": str(tmp_path)}
    run = partial(subprocess.run, [sys.executable, "-c", code], env=env, cwd=tmp_path, capture_output=True, check=True)
    assert run().stdout.split() == [b"2"]
    codes = tmp_path / "satviz" / "batch" / "codes.py"
    codes.write_text(codes.read_text().replace("= 0, 1, 2", "= 0, 1, 7"))
    assert run().stdout.split() == [b"7"]


def test_processes_that_compile_a_kernel_at_once_never_run_each_others_code(tmp_path, monkeypatch):
    """Contiguous and strided arrays are compiled separately, so the processes compile different code."""
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


@pytest.mark.parametrize(
    ("module", "name"),
    [("indexed", "relate_few_corners"), ("indexed", "LANES"), ("exact", "_certified_cross"), ("grid", "_stored_range")],
)
def test_no_compiled_kernel_names_a_function_or_constant_that_a_test_replaces(module, name, monkeypatch):
    """A kernel compiled for the first time in such a test would fail, or keep the value that the test put there."""
    as_python(monkeypatch, kernels_of(module), name)
    python = [value for m in numba_modules() for value in vars(m).values() if inspect.isfunction(value)]
    python.append(getattr(kernels_of(module), name))
    assert not [kernel for kernel in compiled_kernels() if names_any(kernel, set(map(id, python)))]


def batches_of_every_constructor():
    """Yield (name, batch) for each way to make or select a batch of polygons or circles."""
    outlines, centers = ngons(RNG(1), 40, 5), RNG(2).random((40, 2))
    start = np.arange(0, 201, 5)
    yield "array", batch.Polygons(outlines)
    yield "clockwise", batch.Polygons(outlines[:, ::-1])
    yield "by coordinate", batch.Polygons(np.asfortranarray(outlines))
    yield "by offsets", batch.Polygons(outlines.reshape(-1, 2), offsets=start)
    yield "concave", batch.Polygons(np.tile(ELL, (40, 1, 1)), concave="split")
    yield "circles", batch.Circles(centers, np.ones(40))
    yield "circles in a list", batch.Circles(centers.tolist(), [1] * 40)
    both = batch.Polygons(outlines), batch.Circles(centers, np.ones(40))
    yield "concat", batch.concat(both)
    yield "concat of one kind", batch.concat([both[0], both[0]])
    yield "padded", batch.from_padded(outlines, np.full(40, 5), np.zeros(40))
    yield "padded circles", batch.from_padded(outlines, np.ones(40, int), np.ones(40))
    for name, some in (("one kind", both[0]), ("circles", both[1]), ("mixed", batch.concat(both))):
        yield f"slice of {name}", some[3:30]
        yield f"every second of {name}", some[::2]
        yield f"mask of {name}", some[np.arange(len(some)) % 3 == 0]


@pytest.mark.parametrize("name, shapes", [pytest.param(*both, id=both[0]) for both in batches_of_every_constructor()])
def test_groups_of_every_constructor_are_contiguous_by_rows(name, shapes):
    """Otherwise NumPy copies the whole group for each selection: touching 256-gons took six times as long."""
    assert shapes.groups and all(group.block.flags.c_contiguous for group in shapes.groups.values())


@pytest.mark.parametrize("v", [1, 4])
def test_the_rows_of_selected_columns_are_contiguous(v):
    """Kernels are compiled for contiguous rows."""
    shapes = circles(RNG(1), 20) if v == 1 else batch.Polygons(ngons(RNG(1), 20, v))
    for where in slice(3, 9), slice(2, 15, 2), slice(None, None, -1), np.array([7, 3, 3]), np.arange(20) % 3 == 0:
        for group in shapes[where].uniform, shapes.uniform.columns(np.arange(20)[where]):
            assert group.x.strides[1] == group.y.strides[1] == 8
            assert np.array_equal(group.x, shapes.uniform.x[:, where])
            assert v > 1 or (group.r.strides == (8,) and np.array_equal(group.r, shapes.uniform.r[where]))


@pytest.mark.parametrize(("v", "n"), [(3, 20_000), (300, 5_000)])
def test_circles_indexed_with_polygons_are_evaluated_once_in_blocks_that_bound_the_memory(v, n, monkeypatch):
    rng, evaluated, real = RNG(v), [], narrow_phase._evaluate_block
    monkeypatch.setattr(narrow_phase, "_evaluate_block", lambda *args: evaluated.append(args[-1].size) or real(*args))
    some, polygons = circles(rng, 50), batch.Polygons(regular(rng, 50, v))
    pairs = rng.integers(0, 50, (n, 2))
    for a, b, index in (some, polygons, pairs), (polygons, some, pairs[:, ::-1]):
        assert batch.relate(a, b, index, engine="numpy").any()
        at_once = min(narrow_phase.BLOCK_PAIRS, max(exact_signs.MIN_BLOCK_PAIRS, exact_signs.MAX_BLOCK_CORNERS // v))
        assert set(evaluated[:-1]) == {at_once} and sum(evaluated) == n
        evaluated.clear()


@pytest.mark.parametrize("kinds", [(3, 3), (3, 300), (300, 3), (300, 300), (1, 3), (300, 1), (1, 1)])
def test_exact_evaluation_takes_each_pair_once_in_blocks_that_bound_the_memory(kinds, monkeypatch):
    sizes = []
    for name in "_relate_circles", "_relate_polygons":
        monkeypatch.setattr(exact_numpy, name, lambda a, _: sizes.append(len(a.x[0])) or np.zeros(sizes[-1], np.int8))
    a, b = (circles(RNG(k), 2) if k == 1 else batch.Polygons(regular(RNG(k), 2, k)) for k in kinds)
    n = 100_000 if max(kinds) < 9 else 10_000
    exact_numpy.relations(a.uniform, np.zeros(n, np.intp), b.uniform, np.ones(n, np.intp))
    at_once = max(exact_signs.MIN_BLOCK_PAIRS, exact_numpy.BLOCK_CORNERS // max(kinds))
    if 1 in kinds:
        at_once = min(
            exact_numpy.BLOCK_SIGNS, max(exact_signs.MIN_BLOCK_PAIRS, exact_signs.MAX_BLOCK_CORNERS // max(kinds))
        )
    assert set(sizes[:-1]) == {at_once} and sum(sizes) == n


def run_with(executor, **more):
    """Check that batches give the same relations and colliding pairs with this executor as without it."""
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
    """Check the same for concave shapes, where chunks count shapes and not parts."""
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


@pytest.mark.parametrize("chunk", [2, 7, 12, 100])
def test_each_chunk_has_the_relations_of_its_own_pairs_with_and_without_an_executor(chunk):
    rng = RNG(chunk)
    triangles = [sv.Polygon(ring) for ring in ngons(rng, 12, 3)]
    mixed = [sv.Polygon(ring) for ring in (*ngons(rng, 5, 4), *(ELL + rng.uniform(-2, 2, (4, 1, 2))))]
    parted = batch.Polygons([p.vertices for p in mixed], concave="split")
    round_ = circles(rng, 3)
    known = [(batch.Polygons([p.vertices for p in triangles]), triangles)]
    known.append((batch.concat([parted, round_]), mixed + scalar(round_)))
    known += [(s[k : k + n], alone[k : k + n]) for s, alone in known[:2] for k, n in ((4, 1), (8, 1), (8, 2))]
    known.append((parted[:0], []))
    for (a, p), (b, q) in product(known, known):
        if len(a) != len(b) and 1 not in (len(a), len(b)):
            continue
        n = 0 if 0 in (len(a), len(b)) else max(len(a), len(b))
        side_by_side = [(i % len(a), i % len(b)) for i in range(n)]
        shuffled = rng.permutation(side_by_side)[: n // 2 + 1] if n else np.empty((0, 2), int)
        for index, pairs in ((None, side_by_side), (shuffled, shuffled)):
            exact = [int(sv.relate(p[i], q[j])) for i, j in pairs]
            for executor in (None, Elsewhere()):
                done = []
                options = {"engine": "numpy", "executor": executor, "chunk": chunk}
                found = batch.relate(a, b, index, progress=lambda *at: done.append(at), **options)  # noqa: B023
                assert found.dtype == np.int8 and found.tolist() == exact
                ends = [*range(chunk, len(exact), chunk), len(exact)] if exact else []
                assert done == [(end, len(exact)) for end in ends]
                assert executor is None or len(executor.sent) == len(ends)


@pytest.mark.parametrize("engine", ENGINES)
def test_relations_of_concave_shapes_are_right_in_every_block(engine):
    """Each pair of shapes has six pairs of parts, so that a block ends inside a pair of shapes."""
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
    index[first] = np.argwhere(hits[..., rank] & (hits.sum(axis=2) == 1))[0]  # only these parts hit
    assert (batch.relate(a, b, index, engine=engine) == known[tuple(index.T)]).all()


@pytest.mark.parametrize("chunk", [0, -1])
@pytest.mark.parametrize("executor", [None, Elsewhere()])
def test_a_chunk_size_below_1_is_refused(chunk, executor):
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


def test_each_chunk_sends_only_the_shapes_it_needs():
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


@pytest.mark.parametrize("engine", ENGINES)
def test_threads_give_the_same_relations_in_the_same_order(engine):
    with ThreadPoolExecutor(2) as pool:
        run_with(pool, engine=engine)
        run_split_with(pool, engine=engine)
    run_split_with(None, engine=engine)


def test_processes_give_the_same_relations_in_the_same_order():
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
    """The one shape is repeated beside each of the others."""
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


@pytest.mark.slow
def test_a_dask_cluster_of_two_workers_gives_the_same_relations_in_the_same_order(tmp_path):
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
    """A thread pool whose third task fails."""

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
    a, reported = batch.Circles(np.zeros((1000, 2)), 1), []
    with pytest.raises(ChunkFailed, match="items 200 to 299 failed: ZeroDivisionError") as failed:
        batch.relate(a, a, engine="numpy", chunk=100, progress=lambda *at: reported.append(at))
    assert (failed.value.start, failed.value.stop) == (200, 300) and reported == [(100, 1000), (200, 1000)]


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
    """An executor that ends its first task, with an error if one is given, and begins no other task."""

    def __init__(self, error):
        self.error, self.futures = error, []

    def submit(self, function, *args):
        self.futures.append(future := Future())
        if len(self.futures) == 1:
            future.set_exception(self.error) if self.error else future.set_result(function(*args))
        return future


@pytest.mark.parametrize(("error", "raised"), [(None, KeyboardInterrupt), (ValueError("no"), ChunkFailed)])
def test_an_interrupt_and_a_failed_chunk_cancel_the_waiting_chunks(error, raised):
    def stop(done, total):
        raise KeyboardInterrupt

    a, pool = batch.Circles(np.zeros((100, 2)), 1), Waiting(error)
    with pytest.raises(raised):
        batch.relate(a, a, engine="numpy", executor=pool, chunk=10, progress=stop)
    assert len(pool.futures) == chunks.MAX_WAITING_CHUNKS and all(future.cancelled() for future in pool.futures[1:])


def test_a_file_in_strips_gives_each_pair_once(tmp_path):
    rings = ngons(RNG(6), 4000, 3, spread=60)
    np.save(tmp_path / "rings.npy", rings)
    mapped = np.load(tmp_path / "rings.npy", mmap_mode="r")
    done = []
    found = np.concatenate(list(batch.stream_colliding_pairs(mapped, strip=700, progress=lambda *at: done.append(at))))
    expected = batch.colliding_pairs(batch.Polygons(rings))
    assert sorted(map(tuple, found.tolist())) == [tuple(p) for p in expected.tolist()]
    assert done[-1] == (6, 6)
    assert list(batch.stream_colliding_pairs(rings[:0])) == []


@pytest.mark.parametrize("strip", [1, 5, 6, 7, 12, 40])
def test_a_stream_finds_pairs_that_touch_at_the_border_of_a_strip_and_reads_only_shapes_near_it(strip, monkeypatch):
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
def test_a_stream_refuses_lists_and_arrays_of_other_shapes(thing, words):
    with pytest.raises(sv.InvalidShape, match=words):
        next(batch.stream_colliding_pairs(thing))


def test_memory_mapped_arrays_are_accepted_and_not_changed(tmp_path):
    rings = ngons(RNG(2), 50, 4)[:, ::-1]
    np.save(tmp_path / "rings.npy", rings)
    shapes = batch.Polygons(np.load(tmp_path / "rings.npy", mmap_mode="r"))
    assert one_by_one(shapes, shapes) == [2] * 50
    assert np.array_equal(np.load(tmp_path / "rings.npy"), rings)
