"""The study: seeded, resumable, checked against rationals, charted from its own numbers."""

import csv
import json
import os
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from contextlib import nullcontext
from pathlib import Path
from types import SimpleNamespace
from xml.etree import ElementTree

import matplotlib
import numpy as np
import pytest

from satviz import Circle, Polygon, relate
from satviz.cli import main
from satviz.pictures import THEMES
from satviz.study import accuracy, plain, run, stability, truth
from satviz.study.cells import Cell, Failure, Settings, results
from satviz.study.chart import Chart, axes, suffix, wilson
from satviz.study.hard import WAYS
from satviz.study.methods import judged, methods, mistakes, outlines, shapes, times_wrong
from satviz.study.run import charts, study
from satviz.study.workloads import STUDIED, nearly_touching

pytestmark = pytest.mark.slow

QUICK = Settings(quick=True, seed=7)
EXACT = ("satviz.relate", "satviz.record", "satviz numpy", "satviz numba")


@pytest.fixture(scope="module")
def accurate():
    """A small run of the first section: 150 pairs a workload, 60 timed."""
    found = {}
    for name in STUDIED:
        stem = name.replace(" ", "-")
        found[f"accuracy-{stem}"] = accuracy.count_wrong(name, 150, QUICK)
        found[f"speed-{stem}"] = accuracy.take_times(name, 60, 20, 2, QUICK)
    return found


@pytest.fixture(scope="module")
def stable():
    found = {}
    for i, way in enumerate(WAYS):
        for level in way.levels:
            found[f"stability-{way.name.replace(' ', '-')}-{level}"] = stability.count_wrong(i, level, 30, QUICK)
    return found


def test_a_touch_taken_for_an_overlap_is_a_mistake_of_who_tells_them_apart():
    right = np.array([0, 1, 2, 1])
    assert mistakes(np.array([0, 2, 1, 1]), right) == {"false_hits": 0, "false_misses": 0, "confused": 2}
    assert mistakes(np.array([1, 2, 1, 0]), right) == {"false_hits": 1, "false_misses": 1, "confused": 2}
    assert mistakes(right > 0, right) == {"false_hits": 0, "false_misses": 0, "confused": 0}
    exact = [m for m in methods(circles=False) if m.family == "exact"]
    rows = judged(exact, *nearly_touching(np.random.default_rng(1), 40))[1]
    assert len(rows) == len(exact) and not any(map(times_wrong, rows))


@pytest.mark.parametrize("name", STUDIED)
def test_the_exact_methods_are_never_wrong_and_the_cheap_ones_are(accurate, name):
    wrong = {
        (m["form"], m["method"]): (m["false_hits"], m["false_misses"])
        for m in accurate[f"accuracy-{name.replace(' ', '-')}"]["methods"]
    }
    exact = [key for key in wrong if key[1] in EXACT]
    assert len(exact) == 4 and all(wrong[key] == (0, 0) for key in exact)
    for form in ("batch", "scalar"):
        hits, misses = wrong[form, "bounding circles"]
        assert hits > 0 and misses == 0  # a bound may only err by a false hit


def test_more_fixed_axes_are_never_less_accurate(accurate):
    for name in STUDIED:
        wrong = {
            (m["form"], m["method"]): m["false_hits"] for m in accurate[f"accuracy-{name.replace(' ', '-')}"]["methods"]
        }
        for form in ("batch", "scalar"):
            series = [wrong[form, "AABB, kept"], *(wrong[form, f"{k} axes, kept"] for k in (4, 8, 16, 32))]
            assert series == sorted(series, reverse=True)
            assert series == [wrong[form, "AABB"], *(wrong[form, f"{k} axes"] for k in (4, 8, 16, 32))]


@pytest.mark.parametrize("name", STUDIED)
def test_a_method_errs_alike_one_by_one_and_all_at_once(accurate, name):
    counted = accurate[f"accuracy-{name.replace(' ', '-')}"]["methods"]
    batch, scalar = (
        {m["method"]: (m["false_hits"], m["false_misses"]) for m in counted if m["form"] == form}
        for form in ("batch", "scalar")
    )
    both = [method for method in batch if method in scalar]
    assert len(both) >= 15 and {m: batch[m] for m in both} == {m: scalar[m] for m in both}


def test_the_shortcuts_for_circles_err_as_they_should(accurate):
    of = {m["method"]: m for m in accurate["accuracy-circles-at-corners"]["methods"]}
    assert of["SAT, no vertex axis"]["false_hits"] > 0 == of["SAT, no vertex axis"]["false_misses"]
    # an inscribed polygon is inside its circle
    assert of["circle as 8-gon"]["false_misses"] > 0 == of["circle as 8-gon"]["false_hits"]


def test_accuracy_is_seeded():
    one, two = (accuracy.count_wrong("nearly touching", 60, QUICK) for _ in range(2))
    assert one == two
    assert one != accuracy.count_wrong("nearly touching", 60, QUICK._replace(seed=8))


def test_satviz_is_exact_in_every_panel_and_every_panel_is_hard_for_somebody(stable):
    for row in rows(stable):
        if row["method"] in EXACT:
            assert row["false_hits"] == row["false_misses"] == 0, row
        assert 0 < row["hits"] < row["checked"] or row["level"] in (0, 52), row  # both answers occur
    for way in WAYS:
        assert any(row["false_hits"] + row["false_misses"] for row in rows(stable) if row["way"] == way.name), way.name


def test_charts_have_their_numbers_in_their_rows_and_words(accurate, stable):
    made = charts({**accurate, **stable}, (accuracy, stability))
    assert made[0].stem == "speed-against-accuracy" and made[-1].stem == "stability"
    for chart in made:
        assert chart.rows and "{" not in chart.reading and chart.reading.endswith(".")
    bounds = [r for r in made[0].rows if r["method"] == "bounding circles" and r["workload"] == "mixed polygons"]
    assert f"{bounds[0]['false_hits']} false hits" in made[0].reading


def test_the_pareto_front_holds_whatever_nothing_beats(accurate):
    for chart in accuracy.charts(accurate):
        for panel in {(row["workload"], row["form"]) for row in chart.rows}:
            rows = [row for row in chart.rows if (row["workload"], row["form"]) == panel]
            for row in rows:
                beaten = any(o["ns_median"] < row["ns_median"] and o["rate"] <= row["rate"] for o in rows)
                assert not (row["on_front"] and beaten)
            assert any(row["on_front"] for row in rows)


@pytest.mark.parametrize("theme", THEMES.values(), ids=list(THEMES))
def test_no_label_of_a_chart_leaves_the_canvas(accurate, stable, theme):
    for chart in charts({**accurate, **stable}, (accuracy, stability)):
        fig = chart.figure(theme)
        fig.canvas.draw()
        width, height = fig.canvas.get_width_height()
        for text in fig.findobj(lambda artist: hasattr(artist, "get_text") and artist.get_text().strip()):
            if text.get_visible():
                box = text.get_window_extent()
                inside = box.x0 >= -1 and box.y0 >= -1 and box.x1 <= width + 1 and box.y1 <= height + 1
                assert inside, (chart.stem, text.get_text())


def small(count):
    """A section of `count` cells and one chart."""
    return SimpleNamespace(
        cells=lambda settings: [Cell(f"gap-{k}", stability.count_wrong, (0, k, 20, settings)) for k in range(count)],
        charts=lambda found: [Chart("gaps", "Gaps", (300, 200), blank, rows(found), "Only its numbers.")],
    )


def rows(found):
    return [row for some in found.values() for row in some]


def blank(fig, theme):
    axes(fig, (0.1, 0.1, 0.8, 0.8), theme)


def contents(folder):
    return {p.relative_to(folder).as_posix(): p.read_bytes() for p in sorted(folder.rglob("*")) if p.is_file()}


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


def test_a_finished_cell_is_not_done_again_unless_it_was_tampered_with_or_asked_otherwise(tmp_path):
    log = tmp_path / "log"
    cells = [Cell("one", count, (str(log), 1)), Cell("two", count, (str(log), 2), timed=True)]
    first = {cell.name: result for cell, result in results(cells, tmp_path / "cells", None)}
    again = {cell.name: result for cell, result in results(cells, tmp_path / "cells", None)}
    assert first == again == {"one": {"value": 1}, "two": {"value": 2}} and log.read_text() == "xx"
    (path,) = (tmp_path / "cells").glob("one-*.json")
    path.write_text(path.read_text().replace('"value": 1', '"value": 3'))  # the checksum tells
    assert {cell.name: result for cell, result in results(cells, tmp_path / "cells", None)} == first
    assert log.read_text() == "xxx"
    other = [cells[0]._replace(arguments=(str(log), 9))]
    assert [result for _, result in results(other, tmp_path / "cells", None)] == [{"value": 9}]


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
        found = {cell.name: result for cell, result in results(cells, tmp_path / "cells", executor)}
    assert found.pop("good") == {"value": 1} and all(isinstance(failure, Failure) for failure in found.values())
    assert found["bad"].why == "ValueError: no 3" and found["late"].why == "ValueError: no 4"
    assert "not JSON compliant" in found["endless"].why
    assert [path.name[:5] for path in (tmp_path / "cells").iterdir()] == ["good-"]  # a failure is tried again


def test_when_a_worker_dies_the_cells_left_to_it_have_failed_and_what_is_timed_is_done(tmp_path):
    cells = [Cell(f"dead-{i}", die, (1,)) for i in range(20)]
    cells.append(Cell("good", count, (str(tmp_path / "log"), 1), timed=True))
    with ProcessPoolExecutor(2) as executor:
        found = {cell.name: result for cell, result in results(cells, tmp_path / "cells", executor)}
    assert found.pop("good") == {"value": 1}
    assert len(found) == 20 and all("terminated abruptly" in failure.why for failure in found.values())


def test_the_command_does_the_other_sections_and_ends_with_1_if_a_cell_failed(tmp_path, capsys, monkeypatch):
    bad = SimpleNamespace(cells=lambda settings: [Cell("bad\x1b", broken, (3,))], charts=lambda found: found["bad"])
    monkeypatch.setattr(run, "SECTIONS", (bad, small(2)))
    assert main(["study", "--quick", "--out", str(tmp_path)]) == 1
    out, err = capsys.readouterr()
    assert (
        err == f"satviz: 1 cell failed, so charts are missing in {tmp_path}: bad\\x1b (ValueError: no 3)\n" and not out
    )
    assert (tmp_path / "gaps.csv").exists() and "1 cell failed" in (tmp_path / "study.md").read_text()


def test_a_chart_is_saved_with_its_numbers_beside_it(tmp_path, accurate):
    chart = accuracy.charts(accurate)[0]
    section = SimpleNamespace(cells=lambda settings: [], charts=lambda found: [chart])
    files = study(QUICK._replace(quick=False), tmp_path, sections=[section])
    assert {path.suffix for path in files} == {".svg", ".png", ".json", ".csv", ".md"}
    data = json.loads((tmp_path / f"{chart.stem}.json").read_text())
    assert data["rows"] == list(chart.rows) and data["settings"]["seed"] == 7 and "python" in data["machine"]
    lines = (tmp_path / f"{chart.stem}.csv").read_text().splitlines()
    assert [row["method"] for row in csv.DictReader(lines)] == [row["method"] for row in chart.rows]
    assert chart.reading in (tmp_path / "study.md").read_text()
    svg = (tmp_path / f"{chart.stem}-dark.svg").read_text()
    assert "<desc" in svg and "bounding circles" in svg
    before = contents(tmp_path)
    study(QUICK._replace(quick=False), tmp_path, sections=[section])
    assert contents(tmp_path) == before


@pytest.mark.parametrize("end", ["svg", "json", "csv", "md"])
def test_a_study_leaves_the_files_of_others_alone_and_knows_its_own(tmp_path, end):
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


def test_gjk_agrees_with_the_engine_where_nothing_is_close():
    rng = np.random.default_rng(5)
    for make in (STUDIED["mixed polygons"], STUDIED["circles at corners"]):
        a, b = make(rng, 300)
        for p, q in zip(shapes(a), shapes(b), strict=True):
            assert plain.gjk(plain.plain(p), plain.plain(q)) == bool(relate(p, q))
            assert plain.gjk(plain.plain(q), plain.plain(p)) == bool(relate(p, q))


def test_gjk_counts_touching_and_concentric_shapes_as_hits():
    square = Polygon([(0, 0), (1, 0), (1, 1), (0, 1)])
    beside, corner = Polygon([(1, 0), (2, 0), (2, 1), (1, 1)]), Polygon([(1, 1), (2, 1), (2, 2), (1, 2)])
    for other in (square, beside, corner, Circle((0.5, 0.5), 0.1), Circle((2, 0.5), 1)):
        assert plain.gjk(plain.plain(square), plain.plain(other))
    assert not plain.gjk(plain.plain(square), plain.plain(Circle((2.5, 0.5), 1)))


def test_padding_is_taken_off_again():
    rings, _ = STUDIED["mixed polygons"](np.random.default_rng(2), 50)
    counts = [len(ring) for ring in outlines(rings)]
    assert set(counts) <= set(range(3, 9)) and len(set(counts)) > 3
    for ring, padded in zip(outlines(rings), rings, strict=True):
        assert np.array_equal(np.unique(ring, axis=0), np.unique(padded, axis=0))


def test_every_method_says_what_it_is():
    for circles in (False, True):
        found = methods(circles=circles)
        assert len({(m.form, m.name) for m in found}) == len(found)


def test_wilson_covers_the_rate_and_never_says_none_is_certain():
    assert wilson(0, 1000)[0] == 0 and 0.003 < wilson(0, 1000)[1] < 0.005
    low, high = wilson(30, 100)
    assert low < 0.3 < high and abs(low - 0.2189) < 1e-3 and abs(high - 0.3958) < 1e-3  # as in textbooks


@pytest.mark.parametrize("way", WAYS, ids=[way.name for way in WAYS])
def test_hard_pairs_are_valid_convex_shapes(way):
    for level in way.levels:
        a, b = way.make(np.random.default_rng(3), 20, level)
        assert len(a) == len(b) > 0
        for p, q in zip(shapes(a), shapes(b), strict=True):
            assert p.is_convex and q.is_convex and truth.relation(p, q) == relate(p, q)


def test_the_command_refuses_what_it_cannot_do_in_one_line(tmp_path, capsys):
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


COMMITTED = Path(__file__).parent.parent / "figures"
KEPT = json.loads((COMMITTED / "speed-against-accuracy.json").read_text(encoding="utf-8"))


@pytest.mark.parametrize("theme", THEMES.values(), ids=list(THEMES))
def test_the_chart_in_the_readme_is_what_its_numbers_draw(theme):
    chart = accuracy.main_chart(KEPT["rows"])
    assert chart.reading == KEPT["reading"]
    committed = (COMMITTED / f"{chart.stem}{suffix(theme)}.svg").read_text(encoding="utf-8")
    drawn = chart.encode("svg", theme).decode()
    if f"with matplotlib {matplotlib.__version__}<" in committed:
        assert drawn == committed

    def texts(svg):
        return [text.text for text in ElementTree.fromstring(svg).iter("{http://www.w3.org/2000/svg}text")]

    assert texts(drawn) == texts(committed)


def test_the_chart_in_the_readme_comes_from_a_full_run_and_its_exact_methods_were_never_wrong():
    assert KEPT["settings"] == Settings()._asdict() and {row["checked"] for row in KEPT["rows"]} == {10_000}
    assert [row["rate"] for row in KEPT["rows"] if row["family"] == "exact"] == [0.0] * 4


@pytest.mark.full
@pytest.mark.parametrize("name", accuracy.MAIN)
def test_the_counts_in_the_readme_are_counted_again(name):
    (cell,) = [cell for cell in accuracy.cells(Settings()) if cell.name == f"accuracy-{name.replace(' ', '-')}"]
    counted = {m["method"]: m for m in cell.work(*cell.arguments)["methods"] if m["form"] == "batch"}
    for row in KEPT["rows"]:
        if row["workload"] == name:
            found = counted[row["method"]]
            assert (row["false_hits"], row["false_misses"]) == (found["false_hits"], found["false_misses"]), row


def test_a_cluster_gives_the_same_numbers(tmp_path):
    distributed = pytest.importorskip("distributed", reason="a cluster needs python -m pip install '.[cluster]'")
    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,
        run.executor(cluster.scheduler_address) as pool,
    ):
        study(QUICK, tmp_path / "many", sections=[small(3)], executor=pool)
    study(QUICK, tmp_path / "alone", sections=[small(3)])
    assert contents(tmp_path / "many") == contents(tmp_path / "alone")
