"""The study's machinery: seeded, resumable, its files its own; what the README shows is what was counted."""

import csv
import json
import math
import os
import re
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from contextlib import nullcontext
from types import SimpleNamespace
from xml.etree import ElementTree

import matplotlib
import numpy as np
import pytest
import refresh_charts
from refresh_charts import BENCH_CHARTS, FIGURES, load
from refresh_charts import charts as guide_charts

from satviz import Polygon
from satviz.cli import main
from satviz.pictures import THEMES
from satviz.render.chart import Chart, add_axes, theme_suffix
from satviz.study import bench_chart, run, truth
from satviz.study.bench import CHECKED_BY, TimingRow
from satviz.study.bench_table import spread_of
from satviz.study.harness.cells import Cell, Failure, Settings, run_cells
from satviz.study.harness.chart import wilson_interval
from satviz.study.methods import ENGINES, all_methods, answers_by_method
from satviz.study.run import SECTIONS, study
from satviz.study.sections import axis_order, exactness_cost, speed_against_accuracy
from satviz.study.stored_run import STORED_RUN, stored_charts, stored_run

pytestmark = pytest.mark.slow

QUICK = Settings(quick=True, seed=7)


def small(count):
    """Return a section of `count` cells and one chart."""
    return SimpleNamespace(
        cells=lambda settings: [
            Cell(f"gap-{k}", axis_order.count_tested_axes, (2, 4 + k, settings)) for k in range(count)
        ],
        rows=lambda found: {"gaps": rows(found)},
        CHARTS={"gaps": lambda rows, settings: Chart("gaps", "Gaps", (), 180, blank, rows, "Only its numbers.")},
    )


def rows(found):
    return [row for some in found.values() for row in some]


def blank(fig, theme):
    add_axes(fig, (0.1, 0.1, 0.8, 0.8), theme)


def contents(folder):
    return {p.relative_to(folder).as_posix(): p.read_bytes() for p in sorted(folder.rglob("*")) if p.is_file()}


def test_the_price_of_exactness_has_no_rows_without_numba(monkeypatch):
    monkeypatch.setattr(exactness_cost, "all_methods", lambda: [m for m in all_methods() if m.name == "shapely"])
    timed = exactness_cost.take_times(50, 1, QUICK)
    assert {row["method"] for row in timed} == {"shapely"} and {row["whole"] for row in timed} == {0.0}
    assert exactness_cost.rows({"price-0": timed}) == {"price-of-exactness": []}


def test_an_interrupted_study_ends_with_the_same_files(tmp_path):
    def stop(done, total, name):
        if done == 2:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        study(QUICK, tmp_path / "broken", sections=[small(4)], progress=stop)
    assert 2 <= len(contents(tmp_path / "broken")) < 4
    seen = []
    study(QUICK, tmp_path / "broken", sections=[small(4)], progress=lambda done, total, name: seen.append(name))
    study(QUICK, tmp_path / "whole", sections=[small(4)])
    assert contents(tmp_path / "broken") == contents(tmp_path / "whole") and len(seen) == 4


def count(log, value):
    with open(log, "a") as file:
        file.write("x")
    return {"value": value}


def test_a_finished_cell_runs_again_only_if_its_file_was_changed_or_its_settings_differ(tmp_path):
    log = tmp_path / "log"
    cells = [Cell("one", count, (str(log), 1)), Cell("two", count, (str(log), 2), timed=True)]
    first = {cell.name: result for cell, result in run_cells(cells, tmp_path / "cells", None)}
    again = {cell.name: result for cell, result in run_cells(cells, tmp_path / "cells", None)}
    assert first == again == {"one": {"value": 1}, "two": {"value": 2}} and log.read_text() == "xx"
    (path,) = (tmp_path / "cells").glob("one-*.json")
    path.write_text(path.read_text().replace('"value": 1', '"value": 3'))  # the checksum tells
    assert {cell.name: result for cell, result in run_cells(cells, tmp_path / "cells", None)} == first
    assert log.read_text() == "xxx"
    other = [cells[0]._replace(arguments=(str(log), 9))]
    assert [result for _, result in run_cells(other, tmp_path / "cells", None)] == [{"value": 9}]


@pytest.mark.parametrize("pool", [ThreadPoolExecutor, ProcessPoolExecutor])
def test_executors_give_the_same_numbers(tmp_path, pool):
    with pool(2) as executor:
        study(QUICK, tmp_path / "many", sections=[small(3)], executor=executor)
    study(QUICK, tmp_path / "alone", sections=[small(3)])
    assert contents(tmp_path / "many") == contents(tmp_path / "alone")


def broken(n):
    raise ValueError(f"no {n}")


def die(n):
    os._exit(n)


def nan():
    return float("nan")


@pytest.mark.parametrize("pool", [None, ThreadPoolExecutor, ProcessPoolExecutor])
def test_a_failing_cell_is_named_and_the_others_are_done(tmp_path, pool):
    cells = [Cell("bad", broken, (3,)), Cell("endless", nan, ()), Cell("good", count, (str(tmp_path / "log"), 1))]
    cells.append(Cell("late", broken, (4,), timed=True))
    with pool(2) if pool else nullcontext() as executor:
        found = {cell.name: result for cell, result in run_cells(cells, tmp_path / "cells", executor)}
    assert found.pop("good") == {"value": 1} and all(isinstance(failure, Failure) for failure in found.values())
    assert found["bad"].why == "ValueError: no 3" and found["late"].why == "ValueError: no 4"
    assert "not JSON compliant" in found["endless"].why
    assert [path.name[:5] for path in (tmp_path / "cells").iterdir()] == ["good-"]  # a failure is tried again


def test_an_invalid_executor_is_refused_before_anything_is_written(tmp_path):
    with pytest.raises(TypeError, match=r"^executor is 'threads': pass a concurrent\.futures\.Executor, or None"):
        study(QUICK, tmp_path / "new", executor="threads")
    assert not (tmp_path / "new").exists()


def test_a_dead_worker_fails_its_pending_cells_but_timed_cells_still_run(tmp_path):
    cells = [Cell(f"dead-{i}", die, (1,)) for i in range(20)]
    cells.append(Cell("good", count, (str(tmp_path / "log"), 1), timed=True))
    with ProcessPoolExecutor(2) as executor:
        found = {cell.name: result for cell, result in run_cells(cells, tmp_path / "cells", executor)}
    assert found.pop("good") == {"value": 1}
    assert len(found) == 20 and all("terminated abruptly" in failure.why for failure in found.values())


def test_the_command_does_the_other_sections_and_ends_with_1_if_a_cell_failed(tmp_path, capsys, monkeypatch):
    bad = SimpleNamespace(
        cells=lambda settings: [Cell("bad\x1b", broken, (3,))], rows=lambda found: found["bad"], CHARTS={}
    )
    monkeypatch.setattr(run, "SECTIONS", (bad, small(2)))
    assert main(["study", "--quick", "--out", str(tmp_path)]) == 1
    out, err = capsys.readouterr()
    failed = f"1 cell failed, so charts are missing in {tmp_path}: bad\\x1b (ValueError: no 3)"
    assert err == f"satviz: {failed}. Run the command again: finished cells are kept\n" and not out
    assert (tmp_path / "gaps.csv").exists() and "1 cell failed" in (tmp_path / "study.md").read_text()


def test_a_chart_is_saved_with_its_numbers_beside_it(tmp_path):
    chart = speed_against_accuracy.main_chart(SPEED, QUICK)
    section = SimpleNamespace(
        cells=lambda settings: [],
        rows=lambda found: {chart.stem: SPEED},
        CHARTS={chart.stem: lambda rows, settings: chart},
    )
    files = study(QUICK._replace(quick=False), tmp_path, sections=[section])
    assert {path.suffix for path in files} == {".svg", ".png", ".json", ".csv", ".md"}
    data = json.loads((tmp_path / f"{chart.stem}.json").read_text())
    assert (
        data["rows"] == list(chart.rows)
        and data["rough"] == chart.warning == "rough: a quick run"
        and data["settings"]["seed"] == 7
        and "python" in data["machine"]
    )
    lines = (tmp_path / f"{chart.stem}.csv").read_text().splitlines()
    assert [row["method"] for row in csv.DictReader(lines)] == [row["method"] for row in chart.rows]
    assert chart.reading in (tmp_path / "study.md").read_text()
    svg = (tmp_path / f"{chart.stem}-dark.svg").read_text()
    assert "<desc" in svg and "bounding circles" in svg and "rough: a quick run" in svg
    before = contents(tmp_path)
    study(QUICK._replace(quick=False), tmp_path, sections=[section])
    assert contents(tmp_path) == before


@pytest.mark.parametrize("end", ["svg", "json", "csv", "md"])
def test_a_study_overwrites_its_own_files_and_no_others(tmp_path, end):
    files = study(QUICK, tmp_path, sections=[small(1)])
    (path,) = [path for path in files if path.suffix == f".{end}" and "dark" not in path.name]
    study(QUICK, tmp_path, sections=[small(1)])  # its own files it may write again
    path.write_text("name,phone\nmade by satviz,12\n")
    with pytest.raises(FileExistsError, match=path.name):
        study(QUICK, tmp_path, sections=[small(1)])
    assert path.read_text() == "name,phone\nmade by satviz,12\n"
    study(QUICK, tmp_path, sections=[small(1)], force=True)
    assert "phone" not in path.read_text()


def test_a_study_leaves_somebody_elses_cell_alone(tmp_path):
    study(QUICK, tmp_path, sections=[small(1)])
    (cell,) = (tmp_path / "cells").iterdir()
    cell.write_text("{}")
    with pytest.raises(FileExistsError, match=cell.name):
        study(QUICK, tmp_path, sections=[small(1)])
    study(QUICK, tmp_path, sections=[small(1)], force=True)
    assert "made by satviz" in cell.read_text()


def test_a_wilson_interval_covers_the_rate_and_has_no_width_of_zero():
    assert wilson_interval(0, 1000)[0] == 0 and 0.003 < wilson_interval(0, 1000)[1] < 0.005
    low, high = wilson_interval(30, 100)
    assert low < 0.3 < high and abs(low - 0.2189) < 1e-3 and abs(high - 0.3958) < 1e-3  # as in textbooks


def test_the_study_command_refuses_invalid_options_in_one_line(tmp_path, capsys):
    for bad in (["--executor", "nowhere"], ["--out", __file__]):
        assert main(["study", "--quick", "--out", str(tmp_path), *bad]) == 2
        assert capsys.readouterr().err.count("\n") == 1
    with pytest.raises(SystemExit):
        main(["study", "--seed", "-1"])
    assert contents(tmp_path) == {}


def test_the_command_does_every_section_and_says_where_to_begin(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(run, "SECTIONS", (small(2),))
    assert main(["study", "--quick", "--out", str(tmp_path), "--executor", "threads", "--seed", "7"]) == 0
    assert "begin with" in capsys.readouterr().out and (tmp_path / "gaps.csv").exists()


GUIDES = "".join(path.read_text(encoding="utf-8") for path in refresh_charts.GUIDES.glob("*.md"))
IN_GUIDES, STORED = guide_charts(), stored_run()
SPEED, BENCH = STORED["rows"]["speed-against-accuracy"], load(FIGURES / "bench.json")
FRAMES = load(FIGURES / "frames.json")


@pytest.mark.parametrize("stem", IN_GUIDES)
@pytest.mark.parametrize("theme", THEMES.values(), ids=list(THEMES))
def test_a_chart_in_the_guides_is_what_its_numbers_draw(stem, theme):
    chart = IN_GUIDES[stem]
    if stem in BENCH_CHARTS:
        numbers = load(FIGURES / f"{stem}.json")
        assert (chart.reading, chart.title, chart.warning) == (numbers["reading"], numbers["title"], numbers["rough"])
    committed = (FIGURES / f"{stem}{theme_suffix(theme)}.svg").read_text(encoding="utf-8")
    drawn = chart.encode("svg", theme).decode()
    if f"with matplotlib {matplotlib.__version__}<" in committed:
        assert drawn == committed

    def texts(svg):
        return [text.text for text in ElementTree.fromstring(svg).iter("{http://www.w3.org/2000/svg}text")]

    assert texts(drawn) == texts(committed)


@pytest.mark.parametrize("stem", IN_GUIDES)
def test_the_alternative_text_of_a_chart_in_the_guides_begins_with_its_title(stem):
    (alt,) = re.findall(rf'<img src="../../figures/{stem}\.svg"[^>]* alt="([^"]*)"', GUIDES)
    assert alt == refresh_charts.alternative_text(IN_GUIDES[stem]) and alt.startswith(IN_GUIDES[stem].title)
    assert len(alt) < 450  # it is read aloud


@pytest.mark.parametrize("sentence", refresh_charts.measured_sentences())
def test_the_sentences_on_measurements_in_the_guides_are_those_of_the_rows(sentence):
    assert re.sub("[{}]", "", sentence) in GUIDES


def test_the_numbers_of_another_run_come_into_the_guides_by_the_script(monkeypatch):
    others = [re.sub(r"\{.*?\}", "{7}", sentence) for sentence in refresh_charts.measured_sentences()]
    kept = refresh_charts.with_numbers(GUIDES, IN_GUIDES)
    monkeypatch.setattr(refresh_charts, "measured_sentences", lambda: others)
    changed = refresh_charts.with_numbers(GUIDES, IN_GUIDES)
    assert kept == GUIDES and all(re.sub("[{}]", "", sentence) in changed for sentence in others)


def test_the_guide_is_right_about_who_is_the_fastest():
    times = {(r["section"], r["work"], r["size"], r["method"]): r["time"] for r in BENCH["rows"] + FRAMES["rows"]}
    numpy, numba = ENGINES
    for (section, work, size, method), time in times.items():
        if method == "shapely":  # with numba nowhere slower; with NumPy for many corners, and for few boxes
            assert times.get((section, work, size, numba), 0) <= time
            assert times.get((section, work, size, numpy), 0) <= time or section == "corners" or size == 1000
        if section == "frames" and method.endswith("STRtree"):
            assert times[section, work, size, numba] <= time
    frames = {
        (r.work, r.size, r.method): spread_of(r) for r in refresh_charts.bench_rows("frames") if r.section == "frames"
    }
    shared = [refresh_charts.fastest(frames, key[:2]) for key in frames if 30 < key[1] < 10_000]
    assert any(len(methods) > 1 for methods in shared) and "the fastest methods cannot be told apart" in GUIDES


def test_the_stored_bench_was_measured_on_a_quiet_machine_and_satviz_was_never_wrong():
    assert not BENCH["rough"]
    assert all(row["wrong"] == 0 for row in BENCH["rows"] if row["method"].startswith("satviz"))


def of_bench(method, time=1.0, work="tiles", section="scenes", size=0, **more):
    return TimingRow(section, work, size, method, "ns", time, time, time, time, **more)


def test_the_counts_of_different_checks_are_never_added_up():
    rows = [
        of_bench(engine, wrong=1, checked=10 ** (k + 1), by=by) for k, by in enumerate(CHECKED_BY) for engine in ENGINES
    ]
    rows += [of_bench("shapely", 2.0), of_bench("GJK in numba", wrong=5, checked=7, by="rationals")]
    prose = bench_chart.bench_chart(rows, "").reading
    for k, words in enumerate(CHECKED_BY.values()):
        assert f"2 of {2 * 10 ** (k + 1):,} {words}" in prose
    assert len(re.findall(r"\d of \d", prose)) == len(CHECKED_BY)


def test_every_workload_where_satviz_is_slower_than_shapely_is_named():
    rows = [of_bench("shapely"), of_bench("satviz numpy", 0.5)]
    assert "At no work of this run was satviz slower" in bench_chart.bench_chart(rows, "").reading
    for n in 1000, 100_000, 10_000_000:
        rows += [
            of_bench("shapely", 1.0, "even", "broad phase", n),
            of_bench("satviz numpy", 1000 / n, "even", "broad phase", n),
        ]
    for v in 3, 64:
        rows += [
            of_bench("shapely", 1.0, "touching", "corners", v),
            of_bench("satviz numpy", v / 32, "touching", "corners", v),
        ]
    rows += [
        of_bench("shapely", 1.0, "even", "broad phase", 10),
        of_bench("satviz numpy", 4.0, "even", "broad phase", 10),
    ]
    prose = bench_chart.bench_chart(rows, "").reading
    assert "touching, 64 corners (0.50)" in prose and "10 boxes, even (0.25)" in prose and "3 corners" not in prose
    assert "from 0.2 times as fast as shapely unprepared (10 boxes, even)" in prose and "100,000 boxes" not in prose


def test_a_speed_compared_with_shapely_says_whether_shapely_was_prepared():
    rows = [of_bench("shapely", 8.0), of_bench("shapely, prepared", 4.0), of_bench("satviz numba", 1.0)]
    prose = bench_chart.bench_chart(rows, "").reading
    assert "8.0 times (tiles; 4.0 times as fast as prepared)" in prose
    assert "shapely" not in prose.replace("shapely unprepared", "")


def test_every_chart_of_the_study_is_drawn_from_the_stored_rows():
    assert list(stored_charts()) == [stem for section in SECTIONS for stem in section.CHARTS] == list(STORED["rows"])


def test_the_chart_in_the_guide_comes_from_a_full_run_and_satviz_was_never_wrong_in_it():
    assert STORED["settings"] == Settings()._asdict() and {"processor", "SIMD", "numba"} <= STORED["machine"].keys()
    assert STORED_RUN.stat().st_size < 400_000
    of = {row["method"]: row for row in SPEED}
    assert (
        not any(of["satviz"][f"{work}_wrong"] for work in speed_against_accuracy.WORKS) and not of["satviz"]["metres"]
    )
    for name in speed_against_accuracy.PROVEN_MARGINS:
        assert 0 < of[name]["metres"] < of[name]["proven"]
    assert all(len(row["ns_runs"]) == 6 for row in SPEED)


def test_the_stored_run_has_the_sizes_that_a_full_run_has_now():
    for cell in speed_against_accuracy.cells(Settings()):
        if cell.name.startswith("worst-"):
            name, n, generations, _ = cell.arguments
            (row,) = (row for row in SPEED if row["method"] == name)
            assert 0.25 < row["tried"] / (2 * n * generations) <= 1, name
    ((paths, frames, _),) = (cell.arguments for cell in axis_order.cells(Settings()))
    assert {(row["paths"], row["frames"]) for row in STORED["rows"]["order-of-axes"]} == {(paths, paths * frames)}


@pytest.mark.parametrize("row", [row for row in SPEED if row["metres"]], ids=lambda row: row["method"])
def test_the_worst_pair_of_the_guide_is_what_it_says(row):
    a, b = Polygon(row["a"]), Polygon(row["b"])
    hit = truth.agreed(a, b) > 0
    gap = math.sqrt(truth.squared_gap(a, b))
    assert gap == row["metres"] and row["mistake"] == ("missed hit" if hit else "false hit")
    (method,) = (m for m in speed_against_accuracy.compiled_methods() if m.name == row["method"])
    ((_, answers),) = answers_by_method([method], np.array([row["a"]]), np.array([row["b"]]))
    assert answers.tolist() == [not hit]


GUIDE = (refresh_charts.GUIDES / "speed-and-accuracy.md").read_text(encoding="utf-8")


def test_every_measured_number_of_the_guide_comes_from_the_stored_charts():
    """The guide contains no numbers but those of the readings and those that it explains."""
    known = " ".join([*(chart.reading for chart in stored_charts().values()), *STORED["machine"].values()])
    text = re.sub(
        r"```.*?```|<picture>.*?</picture>|\]\([^)]*\)|float(32|64)|`[^`]*`|[Cc]hapter 7", "", GUIDE, flags=re.S
    )
    known = known.replace("\u00a0", " ")
    for number in re.findall(r"\d[\d,.]*\d|\d", text.replace("\u00a0", " ")):
        assert re.search(rf"(?<![\d.,]){re.escape(number)}(?!\d)", known) or number in EXPLAINED, number


def test_making_shapes_costs_more_than_the_answers_unless_many_pairs_touch():
    rows = [row for row in STORED["rows"]["price-of-exactness"] if row["method"] == "satviz"]
    assert all(row["whole"] > 2 * row["ns"] for row in rows if row["what"] == "outlier" or row["much"] <= 0.01)


EXPLAINED = "1", "8"  # a unit, the number of labels


@pytest.mark.full
def test_the_counts_in_the_guide_are_counted_again():
    found = {
        cell.name: cell.work(*cell.arguments) for cell in speed_against_accuracy.cells(Settings()) if not cell.timed
    }
    for row in SPEED:
        (worst,) = (again for name, again in found.items()
                    if name.startswith("worst-") and again["method"] == row["method"])  # fmt: skip
        assert {key: row[key] for key in worst} == worst
        for work in speed_against_accuracy.WORKS:
            (count,) = (again for again in found[f"count-{work}"] if again["method"] == row["method"])
            assert (row[f"{work}_pairs"], row[f"{work}_wrong"]) == (count["pairs"], count["wrong"])


def test_a_dask_cluster_and_one_process_give_the_same_results(tmp_path):
    distributed = pytest.importorskip("distributed", reason="a cluster needs python -m pip install '.[cluster]'")
    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,
        run.open_executor(cluster.scheduler_address) as pool,
    ):
        study(QUICK, tmp_path / "many", sections=[small(3)], executor=pool)
    study(QUICK, tmp_path / "alone", sections=[small(3)])
    assert contents(tmp_path / "many") == contents(tmp_path / "alone")
