"""Each section of the study: its finding is what its rows say, its counts are seeded, nothing is drawn over."""

import json
import pickle
import re
from collections import Counter
from itertools import combinations
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from matplotlib.text import Text

from satviz import Circle, Polygon, batch, relate
from satviz.advice.margins import relative_margins
from satviz.advice.relative_margin import relative_margin
from satviz.engine.axes import needed
from satviz.engine.geometry import Relation
from satviz.pictures import THEMES
from satviz.study import run, truth
from satviz.study.harness.cells import Settings
from satviz.study.harness.chart import TEXT_POINTS
from satviz.study.harness.timings import timing_warning
from satviz.study.methods import (
    COMPILED,
    PYTHON,
    all_methods,
    answers_by_method,
    count_mistakes,
    engine_shapes,
    numba_rivals,
    python_rivals,
    true_relations,
    wrong_answers,
)
from satviz.study.sections import (
    axis_order,
    corner_count,
    error_counts,
    error_maps,
    exactness_cost,
    invariance,
    resting_contact,
    setup_cost,
    speed_against_accuracy,
)
from satviz.study.workloads.generators import WORKLOADS, apart_pairs, overlapping_pairs, unpadded_rings
from satviz.study.workloads.hard_pairs import (
    EXTREME_KIND,
    HARD_KINDS,
    hard_pairs,
    octave_of,
    pairs_on_a_grid,
    touching_triangles,
)

pytestmark = pytest.mark.slow

QUICK = Settings(quick=True, seed=7)
EVERY = (*HARD_KINDS, EXTREME_KIND)
each_kind = pytest.mark.parametrize("kind", range(len(EVERY)), ids=[kind.name for kind in EVERY])
SIZES = {"compiled": 300, "NumPy": 100, "Python": 20}


@pytest.fixture(scope="module")
def found():
    """Every cell of every section but the maps, on few pairs."""
    made = {
        f"hard-{kind.name.replace(' ', '-')}": error_counts.count_errors_by_margin(i, 5, QUICK)
        for i, kind in enumerate(EVERY)
    }
    made |= {f"count-{work}": error_counts.count_errors(work, 120, QUICK) for work in ("touching", "ordinary")}
    made["resolution-times"] = error_counts.take_times(SIZES, 2, QUICK)
    made["price-times"] = exactness_cost.take_times(300, 2, QUICK)
    made["reuse-times"] = setup_cost.take_times(200, 2, QUICK)
    made["corners-times"] = corner_count.take_times(300, 2, QUICK)
    made["changes"] = invariance.count_changed_answers(150, QUICK)
    made["resting"] = resting_contact.measure_contacts(300, QUICK)
    made["order"] = axis_order.count_tested_axes(3, 30, QUICK)
    made |= {cell.name: error_maps.evaluate_grid(cell.arguments[0], 9) for cell in error_maps.cells(QUICK)}
    return json.loads(json.dumps(made, allow_nan=False))


@pytest.fixture(scope="module")
def charts(found):
    return {chart.stem: chart for chart in run.all_charts(found, run.SECTIONS, QUICK)}


def hard_rows(found):
    return [row for name, rows in found.items() if name.startswith("hard-") for row in rows]


# -- the relative margin, and the pairs made by it


def test_the_relative_margin_has_no_unit():
    rng = np.random.default_rng(4)
    for kind in HARD_KINDS:
        a, b, found = hard_pairs(kind, rng, 1)
        small, large = (relative_margins(batch.Polygons(a * 2.0**k), batch.Polygons(b * 2.0**k)) for k in (-90, 70))
        assert np.array_equal(small, found) and np.array_equal(large, found)


@each_kind
def test_hard_pairs_are_valid_and_as_hard_as_asked(kind):
    a, b, found = hard_pairs(EVERY[kind], np.random.default_rng(3), 9)
    assert len(a) > 100 and set(octave_of(found)) >= set(range(2, 34))
    relations = true_relations(a, b)
    assert 0.3 < (relations > 0).mean() < 0.7
    for p, q, g in list(zip(engine_shapes(a), engine_shapes(b), found, strict=True))[::20]:
        assert p.is_convex and q.is_convex and truth.relation(p, q) == relate(p, q)
        assert relative_margin(p, q) == pytest.approx(g, rel=0.03)


def test_touching_pairs_touch_and_take_more_than_whole_numbers():
    a, b = touching_triangles(np.random.default_rng(3), 60)
    assert set(true_relations(a, b)) == {1}
    assert any(
        wrong_answers(said, true_relations(a, b)).any()
        for m, said in answers_by_method(all_methods(), a, b)
        if m.name == "SAT, raw normals"
    )


# -- who is wrong, and up to where


def test_exact_methods_are_never_wrong_and_those_exact_in_range_not_where_products_stay_in_it(found):
    for row in hard_rows(found):
        if row["family"] == "exact" or (row["family"] == "exact in range" and row["kind"] != EXTREME_KIND.name):
            assert row["wrong"] == 0, row
    beyond = [
        row["wrong"]
        for row in hard_rows(found)
        if row["family"] == "exact in range" and row["kind"] == EXTREME_KIND.name
    ]
    assert beyond and all(beyond)
    assert not any(
        row["wrong"] for row in found["count-touching"] if "satviz" in row["method"] and "no" not in row["method"]
    )


def test_in_this_sample_float_sat_is_wrong_only_at_a_few_roundings_whatever_made_it_hard(found):
    for row in hard_rows(found):
        if (
            row["family"] in ("float SAT", "GJK")
            and "float32" not in row["method"]
            and row["kind"] != EXTREME_KIND.name
        ):
            assert row["relative_margin"] < 4, row


def test_float32_is_two_to_the_29_coarser_and_a_tolerance_as_coarse_as_its_size(found):
    worst = {}
    for row in hard_rows(found):
        if row["kind"] != EXTREME_KIND.name and row["language"] == COMPILED:
            worst[row["method"]] = max(worst.get(row["method"], 0.0), row["relative_margin"])
    assert 2**27 < worst["SAT, float32"] < 2**31
    assert 2**20 < worst["SAT, 1e-9 counts as a hit"] < 2**24
    assert worst["AABB"] > error_counts.EVERY_MARGIN < worst["16 axes"]


# what a search for the worst pairs found, far beyond every sample of the study; both are apart
FOUND = {
    "raw normals": (
        [(-8.001074151261296, 7.880396145257136), (-7.984874497029669, 7.897307032068066),
         (-8.017958891015923, 7.976990530624934)],
        [(-7.986791040633234, 7.895306344183942), (-7.876409638210391, 7.82880885774752),
         (-7.779344572182012, 8.03449281493594)],
        6.98,
    ),
    "unit normals": (
        [(5.7791773937839235, 5.77766349664553), (5.846772436010837, 5.712791951984112),
         (5.930761502939617, 5.774188802758776)],
        [(5.858347057316997, 5.687273713708209), (5.837148779992901, 5.722027857615735),
         (5.799689733002134, 5.722288940859094)],
        7.0,
    ),
}  # fmt: skip


@pytest.mark.parametrize("normals", FOUND)
def test_the_largest_margin_of_a_sample_is_no_bound(normals):
    a, b, known = FOUND[normals]
    p, q = Polygon(a), Polygon(b)
    assert truth.relation(p, q) == Relation.APART and round(relative_margin(p, q), 2) == known
    assert python_rivals.sat(
        python_rivals.points_and_radius(p), python_rivals.points_and_radius(q), unit=normals == "unit normals"
    )  # a hit, which is wrong
    for name in "satviz/guides/speed-and-accuracy.md", "notebooks/7-speed-against-accuracy.ipynb":
        text = (Path(__file__).parent.parent / name).read_text(encoding="utf-8")
        assert re.search(rf"{normals} (wrong )?at {known:.2f}", text), name


@pytest.mark.parametrize(
    ("scale", "away", "gap", "least"), [(2.0**70, 0.0, 0.5, 2.0**50), (1.0, 2.0**25, 2.0**21, 2.0**48)]
)
def test_where_float32_cannot_hold_the_shapes_or_their_products_the_margin_does_not_rank_it(scale, away, gap, least):
    box = np.array([[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]])
    a, b = (box + away) * scale, (box + np.array([1 + gap, 0]) + away) * scale
    (float32,) = [method for method in all_methods() if method.name == "SAT, float32"]
    assert true_relations(a, b) == [0] and relative_margins(batch.Polygons(a), batch.Polygons(b)) > least
    assert [wrong_answers(said, true_relations(a, b)).tolist() for _, said in answers_by_method([float32], a, b)] == [
        [True]
    ]


def test_a_bound_errs_only_to_a_hit(found):
    for row in found["count-ordinary"]:
        if row["method"] in ("AABB", "16 axes", "bounding circles", "oriented boxes"):
            assert row["false_hits"] > 0 == row["false_misses"], row


def test_a_touch_taken_for_an_overlap_is_a_mistake_of_who_tells_them_apart():
    right = np.array([0, 1, 2, 1])
    assert count_mistakes(np.array([0, 2, 1, 1]), right) == {"false_hits": 0, "false_misses": 0, "confused": 2}
    assert count_mistakes(np.array([1, 2, 1, 0]), right) == {"false_hits": 1, "false_misses": 1, "confused": 2}
    assert count_mistakes(right > 0, right) == {"false_hits": 0, "false_misses": 0, "confused": 0}


@pytest.mark.parametrize("work", ["triangles", "boxes", "8-gons"])
def test_every_complete_method_is_right_where_nothing_is_near(work):
    a, b = WORKLOADS[work](np.random.default_rng(2), 200)
    right = true_relations(a, b)
    for method, said in answers_by_method(all_methods(), a, b):
        if method.family not in ("bounds",):
            assert np.array_equal(said > 0, right > 0), method


def test_gjk_counts_touching_and_concentric_shapes_as_hits():
    square = Polygon([(0, 0), (1, 0), (1, 1), (0, 1)])
    beside, corner = Polygon([(1, 0), (2, 0), (2, 1), (1, 1)]), Polygon([(1, 1), (2, 1), (2, 2), (1, 2)])
    for other in (square, beside, corner, Circle((0.5, 0.5), 0.1), Circle((2, 0.5), 1)):
        assert python_rivals.gjk(python_rivals.points_and_radius(square), python_rivals.points_and_radius(other))
    assert not python_rivals.gjk(
        python_rivals.points_and_radius(square), python_rivals.points_and_radius(Circle((2.5, 0.5), 1))
    )


@pytest.mark.parametrize("v", [3, 4, 7, 24, 100])
def test_every_way_through_many_corners_gives_one_answer(v):
    rng = np.random.default_rng(v)
    for make, hit in (apart_pairs, False), (overlapping_pairs, True):
        for name, job in corner_count.ready_jobs(*make(rng, 40, v)).items():
            assert set(job()) == {hit}, name


def test_orientation_methods_differ_only_in_their_error_bound():
    a, b, _ = hard_pairs(HARD_KINDS[3], np.random.default_rng(5), 6)
    columns = [np.ascontiguousarray(rings[:, :, d].T) for rings in (a, b) for d in (0, 1)]
    found = {}
    for granted in (numba_rivals.NO_ERROR_BOUND, numba_rivals.ERRBOUND_A, numba_rivals.ALWAYS_EXACT):
        out = np.empty(len(a), np.int8)
        numba_rivals.orientation_sat(*columns, granted, out)
        found[granted] = out > 0
    right = true_relations(a, b) > 0
    assert np.array_equal(found[numba_rivals.ERRBOUND_A], right) and np.array_equal(
        found[numba_rivals.ALWAYS_EXACT], right
    )


# -- the other sections


def test_changes_change_no_pair_and_no_exact_method(found):
    a, b = pairs_on_a_grid(np.random.default_rng(1), 30, invariance.MAX_MARGIN)
    for change in invariance.CHANGES.values():
        assert np.array_equal(true_relations(*change(a, b)), true_relations(a, b))
    moved = {(row["method"], row["change"]): row["changed"] for row in found["changes"]}
    assert all(not count for (method, _), count in moved.items() if method in ("satviz", "orientation, adaptive"))
    assert moved["SAT, raw normals", "moved"] > 0


def test_a_resting_box_is_classified_as_it_is(found):
    of = {(row["scene"], row["method"], row["kept"]): row for row in found["resting"]}
    for (scene, method, _), row in of.items():
        assert row["wrong"] == 0 or method != "satviz"
        assert scene == resting_contact.ON or row["apart"] == 0
    assert (
        of[resting_contact.ON, "satviz", False]["apart"]
        == of[resting_contact.ON, "satviz", False]["apart_in_truth"]
        > 0
    )
    assert of[resting_contact.AT, "satviz", False]["flips"] > 0 == of[resting_contact.AT, "satviz", True]["flips"]


def test_the_order_of_axes_never_changes_a_verdict(found):
    assert all(row["right"] == row["frames"] for row in found["order"])
    tested = {row["order"]: row["tested"] for row in found["order"]}
    assert tested[axis_order.LAST_FIRST] < tested[axis_order.SHUFFLED]


def test_the_last_axis_comes_first_and_none_is_lost():
    a, b = next(axis_order.passing_frames(QUICK.rng("order"), 2))
    axes = needed(a, b).axes
    for axis in axes:
        ordered = axis_order.last_first(axes, axis.source)
        assert ordered[0] == axis and sorted(ordered) == sorted(axes)
    assert axis_order.last_first(axes, None) == axes


def test_counts_are_the_same_on_a_rerun_with_the_same_seed(found):
    def again(value):
        return json.loads(json.dumps(value))

    other = QUICK._replace(seed=8)
    assert again(error_counts.count_errors_by_margin(0, 5, QUICK)) == found["hard-ordinary-shapes"]
    assert again(error_counts.count_errors_by_margin(0, 5, other)) != found["hard-ordinary-shapes"]
    assert again(error_counts.count_errors("touching", 120, QUICK)) == found["count-touching"]
    assert again(invariance.count_changed_answers(150, QUICK)) == found["changes"]
    assert again(resting_contact.measure_contacts(300, QUICK)) == found["resting"]
    assert again(axis_order.count_tested_axes(3, 30, QUICK)) == found["order"]


def test_set_up_and_the_first_question_are_counted(monkeypatch):
    """By a clock of its own: real times of so few pairs say nothing."""
    rounds: Counter[object] = Counter()

    def once(method, a, b):
        rounds[method] += 1
        return (6.0, 4.0, 1.0) if rounds[method] > 1 else (600.0, 400.0, 100.0)  # the first round is left out

    monkeypatch.setattr(setup_cost, "_time_parts", once)
    rows = setup_cost.take_times(200, 2, QUICK)
    assert {row["reuse"]: row["ns"] * 200 / 1e9 for row in rows} == pytest.approx({1: 10, 10: 1.9, 100: 1.09})
    for row in rows:
        parts = [row[part] * row["pairs"] / 1e9 for part in setup_cost.TIME_PARTS.values()]
        assert parts == pytest.approx([6, 4, 1]) and row["ns_low"] == row["ns"] == row["ns_high"]
    assert len(rows) == 3 * len(rounds) and set(rounds.values()) == {3}


def test_set_up_and_questions_are_timed_apart(monkeypatch):
    """Made ready once, asked twice, the clock read between all of them."""
    done = []
    clock = iter([0.0, 1.0, 11.0, 111.0])
    monkeypatch.setattr(setup_cost, "thread_time", lambda: done.append("clock") or next(clock))
    method = SimpleNamespace(prepare=lambda side: done.append("ready") or side, hits=lambda a, b: done.append("asked"))
    assert setup_cost._time_parts(method, None, None) == (1.0, 10.0, 100.0)
    assert done == ["clock", "ready", "ready", "clock", "asked", "clock", "asked", "clock"]


# -- charts


def test_charts_are_few_and_their_numbers_are_in_their_rows(charts):
    assert len(charts) <= 12 and next(iter(charts)) == "speed-against-accuracy"
    for chart in charts.values():
        assert chart.rows and "{" not in chart.reading and chart.reading.endswith(".")


def test_readings_hold_the_numbers_of_the_rows(charts):
    main = charts["speed-against-accuracy"]
    of = {row["method"]: row for row in main.rows}
    assert f"SAT, float32: wrong up to a relative margin of {of['SAT, float32']['relative_margin']:.2g}" in main.reading
    assert f"{of['satviz']['pairs']:,} pairs" in main.reading
    cost = {(row["method"], row["share"]): row["ns"] for row in charts["price-of-exactness"].rows}
    every = speed_against_accuracy.format_time(cost["satviz", 1.0] - cost["satviz, no filter", 1.0])
    assert every in charts["price-of-exactness"].title


def test_exact_by_construction_is_said_of_nothing_that_was_ever_wrong(charts):
    rows = [*charts["speed-against-accuracy"].rows, *charts["interpreted"].rows]
    proved = [row for row in rows if row["lane"] == error_counts.EXACT_BY_CONSTRUCTION]
    assert {row["method"].split(",")[0] for row in proved} == {"satviz"}
    for row in proved:
        assert (
            row["wrong"] == row["touching_wrong"] == row["ordinary_wrong"] == row["extreme_wrong"] == 0 < row["extreme"]
        )
    lane = {row["method"]: row["lane"] for row in rows}
    assert lane["orientation, adaptive"] == lane["orientation, expansions"] == error_counts.NONE_WRONG
    assert lane["AABB"] == lane["bounding circles"] == error_counts.WRONG_AT_ANY_DISTANCE
    assert lane["SAT, raw normals"] == "" and lane.get("shapely", error_counts.NONE_WRONG) == error_counts.NONE_WRONG


def test_what_none_wrong_in_this_sample_leaves_out_is_said_with_its_counts(charts):
    for chart in charts["speed-against-accuracy"], charts["interpreted"]:
        told = chart.reading.split("Wrong on those: ")[1]
        for row in chart.rows:
            assert (f"{row['method']}: {row['extreme_wrong']:,}" in told) == (
                row["lane"] in (error_counts.NONE_WRONG, error_counts.EXACT_BY_CONSTRUCTION)
            )


SAMPLED = "speed-against-accuracy", "wrong-by-margin", "kinds-of-hardness", "interpreted"


@pytest.mark.parametrize("stem", SAMPLED)
def test_a_sentence_about_a_sample_says_that_it_is_one(charts, stem):
    chart = charts[stem]
    assert "in this sample" in chart.title.lower() and "this sample" in chart.reading
    assert not re.search(r"\b(always|never|errs|whatever|coin)\b", f"{chart.title} {chart.reading}")


def test_a_fixed_tolerance_is_given_no_gap_in_a_scene_of_a_kilometre(charts):
    chart = charts["speed-against-accuracy"]
    fixed = [row["method"] for row in chart.rows if row["family"] == "tolerance"]
    assert len(fixed) == 2 and {row["lane"] for row in chart.rows if row["method"] in fixed} == {
        error_counts.FIXED_TOLERANCE
    }
    for sentence in re.split(r"\. (?=[A-Z])", chart.reading):
        assert "in a kilometre" not in sentence or not any(name in sentence for name in fixed)


def test_who_is_vectorised_is_said_where_programs_are_compared(charts):
    for stem in "speed-against-accuracy", "price-of-exactness":
        assert "vectorised" in charts[stem].reading


def test_the_price_of_an_exact_answer_says_what_is_not_in_it(charts):
    assert "Making and checking the shapes is not in these times." in charts["price-of-exactness"].reading


def test_a_quick_or_torn_run_is_stamped():
    calm, torn = {"ns": 10.0, "ns_low": 9.5, "ns_high": 10.5}, {"ns": 10.0, "ns_low": 6.0, "ns_high": 14.0}
    assert timing_warning([calm] * 4, QUICK) == "rough: a quick run"
    assert timing_warning([calm] * 3 + [torn], Settings()) == "" and "busy" in timing_warning([calm, torn], Settings())


def drawn_texts(fig):
    """Every label of a figure; ticks beyond the view are not drawn."""
    yield from fig.texts
    for ax in fig.axes:
        yield from (child for child in ax.get_children() if isinstance(child, Text))
        for axis in (ax.xaxis, ax.yaxis) if ax.axison else ():
            low, high = sorted(axis.get_view_interval())
            ticks = zip(axis.get_ticklocs(), axis.get_ticklabels(), strict=True)
            yield from (axis.label, *(label for at, label in ticks if low <= at <= high))


@pytest.mark.parametrize("theme", THEMES.values(), ids=THEMES)
def test_no_label_of_a_chart_covers_another_or_leaves_it(charts, theme):
    for chart in charts.values():
        fig = chart.figure(theme)
        fig.draw_without_rendering()
        renderer = fig.canvas.get_renderer()
        texts = [text for text in drawn_texts(fig) if text.get_text().strip()]
        assert all(text.get_fontsize() >= TEXT_POINTS for text in texts)
        boxes = [Text.get_window_extent(text, renderer) for text in texts]  # without the lines that tie them
        for text, box in zip(texts, boxes, strict=True):
            inside = fig.bbox.x0 <= box.x0 and box.x1 <= fig.bbox.x1 and fig.bbox.y0 <= box.y0 and box.y1 <= fig.bbox.y1
            assert inside, (chart.stem, text.get_text())
        for (one, p), (other, q) in combinations(zip(texts, boxes, strict=True), 2):
            over = min(min(p.x1, q.x1) - max(p.x0, q.x0), min(p.y1, q.y1) - max(p.y0, q.y0))
            assert over <= 1, (chart.stem, one.get_text(), other.get_text())


def test_cells_can_be_sent_away_and_have_names_of_their_own():
    for settings in Settings(), QUICK:
        cells = [cell for section in run.SECTIONS for cell in section.cells(settings)]
        assert pickle.loads(pickle.dumps(cells)) == cells
        assert len({cell.name for cell in cells}) == len(cells)
        assert {cell.name.endswith("-times") for cell in cells if cell.timed} == {True}


def test_padding_is_taken_off_again():
    rings, _ = WORKLOADS["mixed, 3 to 8 corners"](np.random.default_rng(2), 50)
    counts = [len(ring) for ring in unpadded_rings(rings)]
    assert set(counts) <= set(range(3, 9)) and len(set(counts)) > 3


def test_every_method_says_what_it_is():
    for circles in (False, True):
        found = all_methods(circles=circles)
        assert len({(m.language, m.name) for m in found}) == len(found) > 5
    assert {m.language for m in all_methods()} >= {COMPILED, PYTHON}
