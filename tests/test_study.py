"""The benchmark: it runs, counts wrong answers against rationals, and says what it left out."""

import json

import numpy as np
import pytest

from satviz import Polygon, batch
from satviz.cli import main
from satviz.study import bench, truth
from satviz.study.bench import CHECKED_BY, TimingRow, plan_bench
from satviz.study.bench_table import busy_warning, growth_exponent
from satviz.study.harness import machine
from satviz.study.methods import numba_rivals
from satviz.study.workloads.generators import BOX_LAYOUTS, CORNER_WORKLOADS, WORKLOADS

pytestmark = pytest.mark.slow


def test_bench_times_every_method_and_satviz_is_never_wrong(capsys, tmp_path):
    chart = tmp_path / "charts"
    assert main(["bench", "--pairs", "300", "--rounds", "2", "--json", "--chart", str(chart)]) == 0
    found = json.loads(capsys.readouterr().out)
    rows = found["rows"]
    works = {section: {row["work"] for row in rows if row["section"] == section} for section in SECTIONS}
    assert all(works.values()) and set(rows[0]) == set(TimingRow._fields)
    assert (
        works["pairs"] == set(WORKLOADS)
        and works["corners"] == set(CORNER_WORKLOADS)
        and works["broad phase"] == set(BOX_LAYOUTS)
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
    assert inexact >= {"plain NumPy", "textbook SAT in numba", "GJK in numba"}  # hard enough to tell methods apart
    assert set(found["machine"]) >= {"python", "numpy", "satviz"}
    assert {path.name for path in chart.iterdir()} >= {"bench.svg", "bench-dark.png", "bench.json", "bench.csv"}


SECTIONS = "pairs", "corners", "scenes", "broad phase", "growth", "starts", "memory"


def test_bench_prints_a_table_and_names_what_is_missing(capsys, monkeypatch):
    real = machine.find_spec
    monkeypatch.setattr(machine, "find_spec", lambda name: None if name in ("pymunk", "shapely") else real(name))
    few = plan_bench(20, 1, 0)  # what is measured does not matter here
    monkeypatch.setattr(bench, "plan_bench", lambda pairs, rounds, seed: few)
    assert main(["bench", "--pairs", "200", "--rounds", "1"]) == 0
    out = capsys.readouterr().out
    assert "not installed, so left out: shapely, pymunk" in out and "satviz numpy" in out and "broad phase, ms" in out
    assert "growth" in out and "bytes a shape" in out


def test_a_bench_on_a_busy_machine_says_so():
    calm = [TimingRow("pairs", "triangles", 0, f"method {i}", "ns", 10.0, 9.0, 9.5, 10.5) for i in range(8)]
    torn = [row._replace(low=6.0, high=14.0) for row in calm]
    assert busy_warning(calm + torn[:1]) == "" and "the machine was busy" in busy_warning(calm[:4] + torn[:4])


def test_growth_is_the_exponent_of_the_last_sizes():
    assert growth_exponent({10: 1.0, 100: 900.0, 1000: 90_000.0, 10_000: 9e6}) == pytest.approx(2)


@pytest.mark.parametrize("work", CORNER_WORKLOADS)
@pytest.mark.parametrize("v", [3, 4, 7, 24])
def test_pairs_made_to_lie_so_do(work, v):
    make, relation = CORNER_WORKLOADS[work]
    for a, b in zip(*make(np.random.default_rng(4), 20, v)):
        assert truth.relation(Polygon(a), Polygon(b)) == relation


@pytest.mark.parametrize("work", ["triangles", "boxes", "8-gons"])
def test_peers_in_numba_are_right_where_nothing_is_near(work):
    a, b = WORKLOADS[work](np.random.default_rng(2), 500)
    columns = [np.ascontiguousarray(rings[:, :, d].T) for rings in (a, b) for d in (0, 1)]
    right = batch.hits(batch.Polygons(a), batch.Polygons(b), engine="numpy")
    for kernel, more in ((numba_rivals.textbook_sat, (True, 0.0)), (numba_rivals.gjk, ())):
        out = np.empty(len(a), np.int8)
        kernel(*columns, *more, out)
        assert np.array_equal(out > 0, right)


def test_bench_refuses_nonsense(capsys):
    with pytest.raises(SystemExit) as stop:
        main(["bench", "--pairs", "0"])
    assert stop.value.code == 2 and capsys.readouterr().err.count("\n") == 1


@pytest.mark.parametrize("name", WORKLOADS)
def test_workloads_are_seeded(name):
    one, two = (WORKLOADS[name](np.random.default_rng(3), 20) for _ in range(2))
    for mine, other in zip(one, two):
        assert all(np.array_equal(p, q) for p, q in zip(mine, other))


def test_nearly_touching_pairs_lie_on_both_sides():
    from satviz import batch

    a, b = WORKLOADS["nearly touching"](np.random.default_rng(3), 2000)
    counts = np.bincount(batch.relate(batch.Polygons(a), batch.Polygons(b)), minlength=3)
    assert counts[0] > 500 and counts[2] > 500
