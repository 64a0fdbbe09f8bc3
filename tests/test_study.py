"""Tests of the benchmark: it runs, counts wrong answers against rationals, and lists what it left out."""

import json
from contextlib import redirect_stdout
from io import StringIO
from itertools import chain

import numpy as np
import pytest

from satviz import Polygon, Relation, batch, relate
from satviz.cli import main
from satviz.study import bench, truth
from satviz.study.bench import CHECKED_BY, TimingRow, plan_bench
from satviz.study.bench_chart import bench_chart
from satviz.study.bench_table import busy_warning, faster_from, growth_exponent, spread_of
from satviz.study.frames_chart import crossings, fastest_by_size, frames_chart, headline_of
from satviz.study.harness import machine
from satviz.study.harness.timings import Spread, least_of
from satviz.study.methods import numba_rivals, scene_rivals
from satviz.study.methods.scene_methods import DIFFERENCES, FrameJob, FrameSample, scene_methods
from satviz.study.workloads.generators import BOX_LAYOUTS, CORNER_WORKLOADS, WORKLOADS, turned_boxes
from satviz.study.workloads.moving import FAR, MOVING_SHAPES, moving_scene, uneven_boxes

pytestmark = pytest.mark.slow


FEW = plan_bench(20, 1, 0)._replace(corners=(3,), numbers=(10,), boxes=(10,), frames=(10,))
MORE = plan_bench(300, 2, 0)._replace(corners=(3, 32), numbers=(10, 300), boxes=(10, 300), frames=(10, 300))


@pytest.fixture(scope="module")
def run_once(tmp_path_factory):
    """Return the JSON output of one run of the command, and the folder of its charts."""
    folder = tmp_path_factory.mktemp("bench") / "charts"
    with pytest.MonkeyPatch.context() as patch, redirect_stdout(StringIO()) as said:
        patch.setattr(bench, "plan_bench", lambda pairs, rounds, seed: MORE)
        assert main(["bench", "--json", "--chart", str(folder)]) == 0
    return json.loads(said.getvalue()), folder


def test_bench_times_every_method_and_satviz_is_never_wrong(run_once):
    found, chart = run_once
    rows = found["rows"]
    works = {section: {row["work"] for row in rows if row["section"] == section} for section in SECTIONS}
    assert all(works.values()) and set(rows[0]) == set(TimingRow._fields)
    assert (
        works["pairs"] == set(WORKLOADS)
        and works["corners"] == set(CORNER_WORKLOADS)
        and works["broad phase"] == set(BOX_LAYOUTS)
        and works["frames"] == set(MOVING_SHAPES)
    )
    for row in rows:
        assert 0 < row["least"] <= row["low"] <= row["time"] <= row["high"], row
        if row["method"].startswith("satviz"):
            assert row["wrong"] == 0, row
            assert row["checked"] > 0 or row["section"] in ("growth", "starts", "memory") or "making" in row["work"], (
                row
            )
        if row["checked"]:
            assert row["by"] in CHECKED_BY, row
        if row["method"] == "shapely" and row["section"] in ("scenes", "broad phase"):
            assert row["checked"] == 0, row  # the others are held against it
    inexact = {row["method"] for row in rows if row["work"] == "nearly touching" and row["wrong"]}
    assert inexact >= {"plain NumPy", "SAT in numba", "GJK in numba"}  # hard enough to tell methods apart
    assert set(found["machine"]) >= {"python", "numpy", "satviz"}
    assert {path.name for path in chart.iterdir()} >= {"bench.svg", "bench-dark.png", "bench.json", "frames.csv"}
    stored = [json.loads((chart / f"{stem}.json").read_text(encoding="utf-8"))["rows"] for stem in ("frames", "bench")]
    assert sorted(map(str, chain.from_iterable(stored))) == sorted(map(str, rows))  # each row is in one of the two


SECTIONS = "pairs", "corners", "scenes", "broad phase", "growth", "frames", "arrays", "starts", "memory"


MISSING = "shapely", "pymunk", "scipy", "pyb2d3"


def test_bench_prints_a_table_and_names_what_is_missing(capsys, monkeypatch, run_once):
    real = machine.find_spec
    monkeypatch.setattr(machine, "find_spec", lambda name: None if name in MISSING else real(name))
    monkeypatch.setattr(bench, "plan_bench", lambda pairs, rounds, seed: FEW)  # what is measured does not matter here
    starts = [TimingRow(**row) for row in run_once[0]["rows"] if row["section"] == "starts"]
    monkeypatch.setattr(bench, "_bench_starts", lambda plan: starts)  # new processes know nothing of what is missing
    assert main(["bench", "--pairs", "200", "--rounds", "1"]) == 0
    out = capsys.readouterr().out
    assert (
        f"not installed, so left out: {', '.join(MISSING)}" in out
        and "satviz numpy" in out
        and "broad phase, ms" in out
    )
    assert "growth" in out and "bytes a shape" in out


def test_a_bench_on_a_busy_machine_says_so():
    calm = [TimingRow("pairs", "triangles", 0, f"method {i}", "ns", 10.0, 9.0, 9.5, 10.5) for i in range(8)]
    torn = [row._replace(low=6.0, high=14.0) for row in calm]
    assert busy_warning(calm + torn[:1]) == "" and "the machine was busy" in busy_warning(calm[:4] + torn[:4])


def test_the_growth_exponent_is_estimated_from_the_largest_sizes():
    assert growth_exponent({10: 1.0, 100: 900.0, 1000: 90_000.0, 10_000: 9e6}) == pytest.approx(2)


@pytest.mark.parametrize("work", CORNER_WORKLOADS)
@pytest.mark.parametrize("v", [3, 4, 7, 24])
def test_pairs_made_for_a_relation_have_that_relation(work, v):
    make, relation = CORNER_WORKLOADS[work]
    for a, b in zip(*make(np.random.default_rng(4), 20, v)):
        assert truth.relation(Polygon(a), Polygon(b)) == relation


@pytest.mark.parametrize("work", ["triangles", "boxes", "8-gons"])
def test_peers_in_numba_are_right_where_nothing_is_near(work):
    a, b = WORKLOADS[work](np.random.default_rng(2), 500)
    columns = [np.ascontiguousarray(rings[:, :, d].T) for rings in (a, b) for d in (0, 1)]
    right = batch.hits(batch.Polygons(a), batch.Polygons(b), engine="numpy")
    v = a.shape[1]
    for kernel in numba_rivals.plain_sat(v, v), numba_rivals.gjk_kernel(v, v), numba_rivals.gjk_kernel(None, None):
        out = np.empty(len(a), np.int8)
        kernel(*columns, out)
        assert np.array_equal(out > 0, right)


@pytest.mark.parametrize("corners", [4, 12])
def test_plain_sat_counts_touching_as_a_hit_for_any_number_of_corners(corners):
    """Two polygons in whole numbers touch along an edge; their y coordinates are those of a parabola, mirrored."""
    half = [(k, k * k) for k in range(corners // 2)]
    top = half[-1][1] * 2 + 1
    ring = np.array(half + [(x, top - y) for x, y in reversed(half)], float)[::-1, ::-1]  # counter-clockwise
    assert relate(Polygon(ring), Polygon(ring + np.array([0, half[-1][0]]))) is Relation.TOUCHING
    x, y = ring.T[:, :, None]
    out = np.empty(1, np.int8)
    numba_rivals.plain_sat(corners, corners)(x, y, x.copy(), y + (y.max() - y.min()), out)
    assert out[0] > 0


def scene_of(work, n, seed):
    rng = np.random.default_rng(seed)
    return moving_scene(rng, MOVING_SHAPES[work](rng, n))


def as_set(pairs):
    """Return the pairs of any method as a set of tuples; they come as an array or as such a set."""
    return {tuple(sorted(map(int, pair))) for pair in pairs}


@pytest.mark.parametrize("seed", [1, 2, 3])
@pytest.mark.parametrize("n", [1, 10, 150, 1000])
@pytest.mark.parametrize("work", MOVING_SHAPES)
def test_other_methods_in_float64_agree_with_satviz_on_ordinary_scenes(work, n, seed):
    scene = scene_of(work, n, seed)
    methods = scene_methods(scene)
    assert {"satviz numpy", "satviz numba", "brute force", "sort and sweep", "short sweep", "STRtree"} < set(methods)
    for frame in scene.frames:
        right = as_set(methods["satviz numpy"](frame))
        assert n < 150 or len(right) > n / 10
        for name, find in methods.items():
            found = as_set(find(frame))
            if name == "Box2D" or (work == "mixed" and "STRtree" in name):  # their shapes are a little different
                assert name.split()[-1] in DIFFERENCES and len(found ^ right) <= 2 + 0.08 * len(right), name
            else:
                assert found == right, name


def test_a_rival_finds_more_pairs_than_it_has_space_for_at_first():
    for corners in turned_boxes(np.random.default_rng(1), 60, 0.1), np.zeros((60, 1, 2)):
        v = corners.shape[1]
        padded = corners, np.full(60, v), np.zeros(60)
        for kind in v, scene_rivals.MIXED:
            by_sweep = [scene_rivals.colliding_pairs(*padded, kind=kind, sweep=sweep) for sweep in (False, True)]
            for found in *by_sweep, scene_rivals.short_sweep(kind)(*padded):
                assert len(as_set(found)) == len(found) == 60 * 59 // 2 > scene_rivals.PAIRS_A_SHAPE * 60


@pytest.mark.parametrize("work", MOVING_SHAPES)
def test_a_sample_of_a_frame_counts_pairs_that_lack_and_pairs_too_many(work):
    frame = scene_of(work, 400, 5).frames[0]
    sample = FrameSample(frame, 100)
    pairs = scene_methods(scene_of(work, 400, 5))["satviz numba"](frame)
    assert sample.wrong(pairs) == 0 < len(sample.right) < sample.checked < 4950
    assert sample.wrong(pairs[:0]) == len(sample.right)
    every = [(i, j) for i in range(400) for j in range(i)]
    assert sample.wrong(set(every)) == 4950 - len(sample.right)


def test_a_frame_job_goes_from_frame_to_frame():
    scene = scene_of("boxes", 20, 1)
    seen = []
    job = FrameJob(lambda frame: seen.append(frame) or len(seen), scene, 3)
    job()
    assert [frame is scene.frames[k] for frame, k in zip(seen, (1, 0, 1))] == [True] * 3 and (
        job.frame,
        job.answer,
    ) == (1, 3)
    assert not np.array_equal(*(frame.padded.corners for frame in scene.frames))


def test_uneven_boxes_differ_from_the_plain_ones_in_one_box():
    plain, giant, far = uneven_boxes(np.random.default_rng(1), 500).values()
    assert np.array_equal(plain[1:], giant[1:]) and np.array_equal(plain[1:], far[1:]) and far[0].min() > FAR / 2
    touched = batch.hits(batch.Polygons(giant[:1]), batch.Polygons(giant[1:])).sum()
    assert np.ptp(giant[0, :, 0]) > 500 * np.ptp(plain[1:, :, 0], axis=1).max() and 1 <= touched < 25


def in_frames(method, times, work="boxes", **more):
    return [TimingRow("frames", work, n, method, "us", t, t, t, t, **more) for n, t in times.items()]


CROSSING = [
    *in_frames("satviz numba", {10: 9.0, 100: 10.0, 1000: 11.0, 10_000: 50.0}, wrong=0, checked=5, by="rationals"),
    *in_frames("brute force", {10: 1.0, 100: 9.0, 1000: 90.0}),
    *in_frames("STRtree", {10: 20.0, 100: 30.0, 1000: 40.0, 10_000: 400.0}),
    *in_frames("sort and sweep", {10: 2.0, 100: 5.0, 1000: 10.0, 10_000: 40.0}, wrong=2, checked=7, by="rationals"),
    *in_frames("cKDTree", {10: 12.0, 100: 12.0, 1000: 12.0, 10_000: 12.0}),
]


def times_by_method(rows):
    found = {}
    for row in rows:
        found.setdefault(row.method, {})[row.size] = spread_of(row)
    return found


def sharp(time):
    """Return a time with no distance between its quartiles."""
    return Spread(time, time, time)


def test_where_lines_cross_is_computed_from_the_rows():
    times = times_by_method(CROSSING)
    assert fastest_by_size(times) == "Fastest: brute force at 10; sort and sweep 100 to 1,000; cKDTree at 10,000."
    assert crossings(times, "satviz numba") == (
        "satviz numba: faster than brute force at 1,000, STRtree at all sizes; "
        "slower than sort and sweep at all sizes, cKDTree at 10,000."
    )
    capped = times_by_method([r for r in CROSSING if r.method != "brute force" or r.size < 1000])
    assert "slower than brute force up to 100, sort and sweep" in crossings(capped, "satviz numba")
    one, two, far = (Spread(t, t - 0.5, t + 0.5) for t in (1.0, 2.0, 9.0))
    assert faster_from({1: one, 2: far, 3: one, 4: one}, {1: two, 2: two, 3: far, 5: one}) == 3
    assert faster_from({1: one, 2: far}, {1: two, 2: two}) is None is faster_from({1: one}, {2: far})


def test_overlapping_intervals_are_called_neither_faster_nor_slower():
    near, next_to, apart = Spread(1.0, 0.8, 1.2), Spread(1.3, 1.1, 1.5), Spread(2.0, 1.6, 2.4)
    assert near.is_below(apart) and not near.is_below(next_to) and not near.is_below(near)
    assert least_of({"c": apart, "b": next_to, "a": near}) == ["a", "b"]
    times = {"satviz numba": {10: near}, "STRtree": {10: next_to}, "cKDTree": {10: apart}}
    assert fastest_by_size(times) == "At no size is one method clearly the fastest."
    later = times | {"STRtree": {10: next_to, 100: near, 1000: near}}
    assert fastest_by_size(later) == "Fastest: STRtree 100 to 1,000; at other sizes it is not clear."
    parted = later | {"satviz numba": {10: apart}, "STRtree": {1: near, 10: apart, 100: near}}
    assert fastest_by_size(parted) == "Fastest: STRtree at 1 and at 100; at other sizes it is not clear."
    assert crossings(times, "satviz numba") == (
        "satviz numba: faster than cKDTree at all sizes; not told apart from STRtree at all sizes."
    )
    assert headline_of({"boxes": times})[0] == "satviz numba beside the fastest methods"
    rows = [TimingRow("pairs", "tiles", 0, m, "ns", t.middle, t.middle, t.low, t.high)
            for m, t in (("shapely", near), ("satviz numpy", next_to), ("satviz numba", apart))]  # fmt: skip
    said = bench_chart(rows, "").reading
    assert "satviz numba is slower than shapely unprepared here" in said and "satviz numpy is slower" not in said


def test_the_headline_of_the_frames_states_where_all_libraries_are_passed_and_what_short_programs_take():
    times = times_by_method(CROSSING)
    title, subtitle = headline_of({"boxes": times})
    assert title == "satviz numba beside the fastest methods"  # cKDTree is never passed
    assert subtitle.endswith(
        "; the fastest short program in floats (orange) takes 0.1 to 0.9 times as long as satviz numba."
    )
    without = {method: own for method, own in times.items() if method != "cKDTree"}
    passed = "satviz numba is faster than each library here, {} shapes"
    assert headline_of({"boxes": without})[0] == passed.format("10 to 10,000")
    late = without | {"STRtree": {10: sharp(1.0), 100: sharp(30.0)}}
    assert headline_of({"boxes": without, "mixed": late}) == (passed.format("at 100"), subtitle)
    moved = without | {"satviz numba, moved": {10: sharp(0.1)}, "satviz numpy": {10: sharp(0.1)}}
    assert headline_of({"boxes": moved})[0] == passed.format("10 to 10,000")
    assert headline_of({"boxes": {"satviz numpy": {10: sharp(1.0)}}})[1].endswith("satviz is exact.")


def test_the_chart_of_frames_says_where_lines_cross_what_differs_and_what_was_wrong():
    uneven = [TimingRow("arrays", "9 boxes, all collisions", 0, f"satviz numba, {what}", "ms", t, t, t, t)
              for what, t in (("plain", 2.0), ("one 1e12 away", 3.0))]  # fmt: skip
    pairs = [TimingRow("arrays", "hits of 9 pairs", 0, m, "ns", t, t, t, t)
             for m, t in (("satviz numba", 30.0), (bench.PLAIN_SAT, 12.0))]  # fmt: skip
    said = frames_chart(CROSSING + uneven + pairs, "").reading
    assert said.startswith("Boxes. Fastest: brute force at 10; sort and sweep 100 to 1,000; cKDTree at 10,000. satviz")
    assert "satviz numba 30 (2.5 times)" in said and "satviz numba, one 1e12 away 1.50" in said
    assert DIFFERENCES["cKDTree"] in said and DIFFERENCES["Box2D"] not in said
    assert "both engines together: 0 of 20 checked" in said and "all together: 8 of 28 checked" in said


def test_bench_refuses_invalid_options(capsys):
    with pytest.raises(SystemExit) as stop:
        main(["bench", "--pairs", "0"])
    assert stop.value.code == 2 and capsys.readouterr().err.count("\n") == 1


@pytest.mark.parametrize("name", WORKLOADS)
def test_the_same_seed_gives_the_same_workload(name):
    one, two = (WORKLOADS[name](np.random.default_rng(3), 20) for _ in range(2))
    for mine, other in zip(one, two):
        assert all(np.array_equal(p, q) for p, q in zip(mine, other))


def test_nearly_touching_pairs_lie_on_both_sides():
    from satviz import batch

    a, b = WORKLOADS["nearly touching"](np.random.default_rng(3), 2000)
    counts = np.bincount(batch.relate(batch.Polygons(a), batch.Polygons(b)), minlength=3)
    assert counts[0] > 500 and counts[2] > 500
