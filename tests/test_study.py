"""The benchmark: it runs, counts wrong answers against rationals, and says what it left out."""

import json

import numpy as np
import pytest

from satviz.cli import main
from satviz.study import machine
from satviz.study.workloads import LAYOUTS, WORKLOADS

pytestmark = pytest.mark.slow


def test_bench_times_every_method_and_satviz_is_never_wrong(capsys):
    assert main(["bench", "--pairs", "300", "--rounds", "1", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert {row["workload"] for row in found["narrow"]} == set(WORKLOADS)
    assert {row["layout"] for row in found["broad"]} == set(LAYOUTS)
    for row in found["narrow"]:
        assert row["ns"] > 0 and row["checked"] == 300
        if row["method"].startswith("satviz"):
            assert row["wrong"] == 0, row
    textbook = [r for r in found["narrow"] if r["method"] == "plain NumPy" and r["workload"] == "nearly touching"]
    assert textbook[0]["wrong"] > 0  # the pairs are hard enough to tell methods apart
    assert set(found["machine"]) >= {"python", "numpy", "satviz"}


def test_bench_prints_a_table_and_names_what_is_missing(capsys, monkeypatch):
    real = machine.find_spec
    monkeypatch.setattr(machine, "find_spec", lambda name: None if name in ("pymunk", "shapely") else real(name))
    assert main(["bench", "--pairs", "200", "--rounds", "1"]) == 0
    out = capsys.readouterr().out
    assert "not installed, so left out: shapely, pymunk" in out and "satviz numpy" in out and "broad phase, ms" in out


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
