"""Each section of the study: its finding is what its rows say, its counts are seeded, nothing is drawn over."""

import copy
import json
import math
import os
import pickle
import re
import time
from collections import Counter
from concurrent.futures import BrokenExecutor
from fractions import Fraction
from functools import cache
from itertools import chain, combinations

import numba
import numpy as np
import pytest
from matplotlib.text import Text
from oracle import squared_distance
from refresh_charts import charts as guide_charts

from satviz import Circle, Polygon, advise, batch, relate
from satviz.advice.relative_margin import relative_margin
from satviz.advice.timing import time_in_turn
from satviz.engine.axes import needed
from satviz.engine.geometry import Relation
from satviz.pictures import THEMES
from satviz.render.chart import TEXT_POINTS, WIDTH, Chart
from satviz.study import bench, methods, run, truth
from satviz.study.harness import timings
from satviz.study.harness.cells import Settings
from satviz.study.harness.chart import median_interval, wilson_interval
from satviz.study.methods import (
    COMPILED,
    PYTHON,
    Method,
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
    decision_table,
    exactness_cost,
    margin_strips,
    mtv_by_method,
    pose_error,
    resting_stack,
    speed_against_accuracy,
)
from satviz.study.stored_run import stored_charts, stored_run
from satviz.study.workloads.adversary import (
    beside,
    kilometre_shapes,
    worst_kilometre_shapes,
    worst_pair,
    worst_shapes_within_two,
)
from satviz.study.workloads.generators import (
    WORKLOADS,
    apart_pairs,
    circles,
    ngons,
    overlapping_pairs,
    regular_polygons,
    unpadded_rings,
)
from satviz.study.workloads.hard_pairs import (
    EXTREME_KIND,
    HARD_KINDS,
    hard_circles,
    hard_pairs,
    margins_of,
    octave_of,
    touching_quadrilaterals,
)
from satviz.study.workloads.stack import SLOP, contact_points

pytestmark = pytest.mark.slow

QUICK = Settings(quick=True, seed=7)
EVERY = (*HARD_KINDS, EXTREME_KIND)
each_kind = pytest.mark.parametrize("kind", range(len(EVERY)), ids=[kind.name for kind in EVERY])
SMALL = {  # the arguments of every cell before the settings, where they are smaller than those of a quick run
    speed_against_accuracy.search: (300, 6),
    speed_against_accuracy.count_errors: (40,),
    speed_against_accuracy.take_times: (300, 2),
    exactness_cost.take_times: (200, 2),
    corner_count.take_times: (300, 2, corner_count.CORNER_COUNTS),
    corner_count.count_errors: (100, corner_count.CORNER_COUNTS),
    margin_strips.count_by_margin: (2,),
    margin_strips.count_circles: (4,),
    margin_strips.count_touching: (40,),
    margin_strips.search: (300, 6),
    margin_strips.search_circles: (300, 2),
    mtv_by_method.measure: (8,),
    pose_error.measure: (1,),
    axis_order.count_tested_axes: (3, 30),
    decision_table.recommend: (60,),
}


def small(cell):
    """Return the result of a cell on few pairs, in this process."""
    work, *arguments = cell.arguments[1:] if cell.work is timings.in_process else (cell.work, *cell.arguments)
    if work in SMALL:
        arguments = [*arguments[: len(arguments) - len(SMALL[work]) - 1], *SMALL[work], QUICK]
    return work(*arguments)


CELLS = {cell.name: cell for section in run.SECTIONS for cell in section.cells(QUICK)}


@cache
def result(name):
    """Return what a cell finds on few pairs, as if read from disk; each is done once, and only where it is needed."""
    return json.loads(json.dumps(small(CELLS[name]), allow_nan=False))


def results(*words):
    """Return the results of the cells whose names begin with one of these words."""
    return {name: result(name) for name in CELLS if name.startswith(words)}


CHARTS = stored_charts()
DRAWN = CHARTS | guide_charts()  # with those of the bench
each_theme = pytest.mark.parametrize("theme", THEMES.values(), ids=THEMES)


# -- the relative margin, and the pairs made by it


def test_the_relative_margin_has_no_unit():
    rng = np.random.default_rng(4)
    for kind in HARD_KINDS:
        a, b, found = hard_pairs(kind, rng, 1)
        scaled = [(batch.Polygons(a * 2.0**k), batch.Polygons(b * 2.0**k)) for k in (-90, 70)]
        small, large = (margins_of(*both) for both in scaled)
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


def test_hard_circles_have_margins_of_every_octave():
    a, b, margin = hard_circles(np.random.default_rng(3), 20)
    assert set(octave_of(margin)) >= set(range(30)) and 0.3 < (true_relations(a, b) > 0).mean() < 0.7


# -- the oracles


def test_two_oracles_agree_and_a_pair_on_which_they_differ_is_an_error(monkeypatch):
    for make in touching_quadrilaterals, lambda rng, n: (ngons(rng, n, 5, 1.0), ngons(rng, n, 7, 1.0)):
        a, b = make(np.random.default_rng(2), 60)
        by_clipping = [truth.relation(p, q) for p, q in zip(engine_shapes(a), engine_shapes(b), strict=True)]
        assert true_relations(a, b).tolist() == by_clipping
    monkeypatch.setattr(truth, "_relation_by_difference", lambda p, q: Relation.APART)
    with pytest.raises(AssertionError, match="oracles disagree"):
        true_relations(a, b)


CIRCLE_PAIRS = {  # by what is exact about them: 3, 4, 5 and 5, 12, 13
    "circles side by side": (Circle((0, 0), 2), Circle((3, 4), 3)),
    "a corner": (Circle((0, 0), 13), Polygon([(5, 12), (40, 12), (5, 40)])),
    "an edge that is not upright": (Circle((7, -1), 5), Polygon([(0, 0), (8, 6), (0, 6)])),
    "an upright edge": (Circle((3, -2), 2), Polygon([(0, 0), (8, 0), (8, 6), (0, 6)])),
}


@pytest.mark.parametrize("words", CIRCLE_PAIRS)
def test_both_oracles_of_circles_see_the_next_float(words):
    circle, other = CIRCLE_PAIRS[words]
    for radius, right in (
        (circle.radius, Relation.TOUCHING),
        (math.nextafter(circle.radius, 0), Relation.APART),
        (math.nextafter(circle.radius, 99), Relation.OVERLAPPING),
    ):
        one = Circle(circle.center, radius)
        for a, b in (one, other), (other, one):
            assert truth.relation(a, b) is truth.relation_by_axes(a, b) is truth.agreed(a, b) is right


def test_both_oracles_of_circles_agree_on_hard_pairs_and_with_the_engine(monkeypatch):
    rng = np.random.default_rng(5)
    rings = ngons(rng, 300, 5, 1.3)
    pairs = [(circle, Polygon(ring)) for circle, ring in zip(engine_shapes(circles(rng, 300, 1.3)), rings, strict=True)]
    pairs += list(zip(*map(engine_shapes, hard_circles(rng, 3)[:2]), strict=True))
    seen = Counter()
    for a, b in pairs:
        seen[truth.agreed(a, b)] += 1
        assert truth.agreed(a, b) is relate(a, b)
    assert min(seen[Relation.APART], seen[Relation.OVERLAPPING]) > 50
    same = Circle((1, 2), 1.0)
    assert truth.agreed(same, Circle((1, 2), 0.5)) is Relation.OVERLAPPING
    assert truth.agreed(same, Polygon([(1, 2), (9, 2), (9, 9)])) is Relation.OVERLAPPING  # the center is a corner
    monkeypatch.setattr(truth, "relation_by_axes", lambda p, q: Relation.TOUCHING)
    with pytest.raises(AssertionError, match="oracles disagree"):
        truth.agreed(*pairs[0])


def test_the_least_pushes_of_a_square_in_a_square_are_all_named():
    a = Polygon([(0, 0), (8, 0), (8, 8), (0, 8)])
    square = Polygon([(3, 3), (5, 3), (5, 5), (3, 5)])
    assert len(truth.mtv_directions(a, square)) == 4 and truth.squared_gap(a, square) == 25
    right = Polygon([(4, 3), (6, 3), (6, 5), (4, 5)])
    ((x, y),) = truth.mtv_directions(a, right)
    assert x > 0 == y and truth.squared_gap(a, right) == 16


def test_a_move_is_evaluated_without_rounding():
    a, b = Polygon([(0, 0), (1, 0), (1, 1), (0, 1)]), Polygon([(0.5, 0), (1.5, 0), (1.5, 1), (0.5, 1)])
    for x, relation in (0.5, Relation.TOUCHING), (0.5 - 2.0**-54, Relation.OVERLAPPING), (0.6, Relation.APART):
        assert truth.relation_moved(a, b, (x, 0.0)) is relation
    assert truth.squared_gap(a, b) == 0.25


def test_a_gap_is_measured_on_the_edge_normal_where_it_is_largest():
    a, beside = Polygon([(0, 0), (1, 0), (1, 1), (0, 1)]), Polygon([(2, 0), (3, 0), (3, 1)])
    corner = Polygon([(1.5, 1.25), (2.5, 1.25), (2.5, 2.25), (1.5, 2.25)])
    assert truth.squared_gap(a, beside) == 1 == squared_distance(a, beside)
    assert truth.squared_gap(a, corner) == 0.25 < squared_distance(a, corner)


# -- the rivals are as fast and as right as they can be


def columns_of(a, b, dtype=np.float64):
    return [np.ascontiguousarray(rings[:, :, d].T.astype(dtype)) for rings in (a, b) for d in (0, 1)]


def by_numpy(a, b, form, tolerance, dtype):
    """Return SAT's answers by another program: one array operation at a time, in the same order of roundings."""
    best = np.full(len(a), -np.inf, dtype)
    for ring, other in (a.astype(dtype), b.astype(dtype)), (b.astype(dtype), a.astype(dtype)):
        for e in range(ring.shape[1]):
            p, q = ring[:, e], ring[:, (e + 1) % ring.shape[1]]
            nx, ny = q[:, 1] - p[:, 1], p[:, 0] - q[:, 0]
            length = np.sqrt(nx * nx + ny * ny)
            if form == numba_rivals.UNIT:
                nx, ny = nx * (1 / length), ny * (1 / length)
            least = (nx[:, None] * other[..., 0] + ny[:, None] * other[..., 1]).min(axis=1)
            gap = least - (nx * p[:, 0] + ny * p[:, 1])
            best = np.maximum(best, gap - dtype(tolerance) * length if form == numba_rivals.WITH_TOLERANCE else gap)
    return best <= 0


@pytest.mark.parametrize("dtype", [np.float64, np.float32])
@pytest.mark.parametrize("form", [numba_rivals.PLAIN, numba_rivals.UNIT, numba_rivals.WITH_TOLERANCE])
@pytest.mark.parametrize("corners", [3, 4, 8, 24])
def test_the_kernel_of_sat_answers_as_another_program_does(dtype, form, corners):
    rng = np.random.default_rng(corners)
    a, b = (regular_polygons(rng, 3000, corners) + rng.uniform(-1, 1, (3000, 1, 2)) for _ in "AB")
    few, out = numba_rivals.unrolled(corners), np.empty(len(a), np.int8)
    numba_rivals.sat_kernel(few, few, form)(*columns_of(a, b, dtype), dtype(1e-3), out)
    assert np.array_equal(out > 0, by_numpy(a, b, form, 1e-3, dtype)) and 0 < out.sum() < len(a)


def test_an_unrolled_gjk_answers_as_the_loop():
    a, b = kilometre_shapes(np.random.default_rng(1), 3000)
    b = beside(np.random.default_rng(2), a, b, np.random.default_rng(3).normal(0, 1e-12, len(a)))
    one, other = np.empty(len(a), np.int8), np.empty(len(a), np.int8)
    numba_rivals.gjk_kernel(None, None)(*columns_of(a, b), one)
    numba_rivals.gjk_kernel(4, 4)(*columns_of(a, b), other)
    assert np.array_equal(one, other) and 0 < one.sum() < len(a)


WRITTEN_OUT = {  # by method: what follows each normal, and what follows each gap
    "SAT, raw normals": ("", ""),
    "SAT, float32": ("", ""),
    "SAT, unit normals": ("inv = 1 / np.sqrt(nx * nx + ny * ny); nx = nx * inv; ny = ny * inv", ""),
    "SAT, tolerance 1e-9": ("", "gap = gap - 1e-9 * np.sqrt(nx * nx + ny * ny)"),
}


def written_out(name):
    """Return SAT on 4-gons with every product written out, which leaves the compiler nothing to find."""
    lines, (normal, gap) = ["i = np.uintp(k)"], WRITTEN_OUT[name]
    for own, other in ("a", "b"), ("b", "a"):
        for e in range(4):
            f = (e + 1) % 4
            lines += [f"nx, ny = {own}y[{f}, i] - {own}y[{e}, i], {own}x[{e}, i] - {own}x[{f}, i]", normal]
            dots = [f"nx * {other}x[{v}, i] + ny * {other}y[{v}, i]" for v in range(4)]
            lines.append(f"least = min(min({dots[0]}, {dots[1]}), min({dots[2]}, {dots[3]}))")
            lines += [f"gap = least - (nx * {own}x[{e}, i] + ny * {own}y[{e}, i])", gap]
            lines.append("best = gap" if own == "a" and e == 0 else "best = max(best, gap)")
    body = "\n        ".join([*lines, "out[i] = best <= 0"])
    space = {"np": np}
    exec(f"def kernel(ax, ay, bx, by, out):\n    for k in range(out.size):\n        {body}\n", space)
    return numba.njit(nogil=True, error_model="numpy")(space["kernel"])


@pytest.mark.skipif("CI" in os.environ, reason="times are compared only where nothing runs beside")
@pytest.mark.parametrize("name", WRITTEN_OUT)
def test_no_rival_is_slower_than_the_same_written_out_by_more_than_a_tenth(name):
    """Both are called three times in a row: only the first call has to fetch the corners from far away."""
    (method,) = (m for m in all_methods() if (m.language, m.name) == (COMPILED, name))
    a, b = kilometre_shapes(np.random.default_rng(1), speed_against_accuracy.pairs_in_a_call(Settings()))
    p, q, kernel = method.prepare(a), method.prepare(b), written_out(name)

    def reference():
        out = np.empty(len(a), np.int8)
        kernel(p.x, p.y, q.x, q.y, out)
        return out

    # both keep their answers, since fresh memory takes time too
    jobs = {"rival": lambda: [method.hits(p, q) for _ in range(3)], "written out": lambda: [reference() for _ in "123"]}
    least = dict.fromkeys(jobs, math.inf)
    for _ in range(5):  # a busy moment of the machine may fall on one of them
        times = time_in_turn(jobs, 30, dict.fromkeys(jobs, len(a) * 3), time.thread_time)
        least = {job: min(least[job], times[job].least) for job in jobs}
        if least["rival"] < 1.1 * least["written out"]:
            break
    assert least["rival"] < 1.1 * least["written out"], least


def test_the_kernels_of_sat_are_vectorised():
    cached = numba_rivals.sat_kernel(4, 4, numba_rivals.PLAIN)
    if not hasattr(cached, "py_func"):
        pytest.skip("numba compiles nothing here")
    for dtype, width in (np.float64, "x double>"), (np.float32, "x float>"):
        a, b = kilometre_shapes(np.random.default_rng(1), 100)
        # numba shows no code of what it loads from the disk
        kernel = numba.njit(nogil=True, error_model="numpy")(cached.py_func)
        kernel(*columns_of(a, b, dtype), dtype(0), np.empty(100, np.int8))
        assert [code for code in kernel.inspect_llvm().values() if width in code]


# -- who is wrong, and up to where


@pytest.mark.parametrize("name", speed_against_accuracy.PROVEN_MARGINS)
@pytest.mark.parametrize("seed", range(3))
def test_every_found_pair_is_wrong_and_below_the_proven_bound(name, seed):
    (method,) = (m for m in all_methods() if (m.language, m.name) == (COMPILED, name))
    found = worst_pair(method, worst_shapes_within_two, np.random.default_rng(seed), 1000, 14, metres=False)
    right = true_relations(found.a, found.b)
    ((_, answers),) = answers_by_method([method], found.a, found.b)
    assert wrong_answers(answers, right).tolist() == [True]
    assert 7 < found.margin < speed_against_accuracy.PROVEN_MARGINS[name]
    assert margins_of(batch.Polygons(found.a), batch.Polygons(found.b))[0] == found.margin


def test_a_search_finds_gjk_wrong_where_edges_are_parallel():
    """Its differences of corners are exact, but rounding picks the wrong end of a facing edge."""
    (method,) = (m for m in all_methods() if (m.language, m.name) == (COMPILED, "GJK"))
    found = worst_pair(method, worst_kilometre_shapes, np.random.default_rng(1), 1000, 16, metres=True)
    assert truth.squared_gap(Polygon(found.a[0]), Polygon(found.b[0])) > 2e-13**2
    ((_, answers),) = answers_by_method([method], found.a, found.b)
    assert wrong_answers(answers, true_relations(found.a, found.b)).tolist() == [True]


def test_every_found_circle_pair_is_below_the_proven_bound():
    found = {row["method"]: row["margin"] for row in margin_strips.search_circles(2000, 2, Settings())}
    assert found["satviz"] == 0 and 2.4 < found["squares, float64"] < margin_strips.CIRCLE_MARGIN


# what searches by another program found in 1 km, in metres: that of the study must not be weaker
FOUND_IN_1_KM = {"SAT, raw normals": 6.06e-13, "SAT, unit normals": 4.4e-13, "SAT, float32": 1.08e-3, "AABB": 10.0}


@pytest.mark.parametrize("name", FOUND_IN_1_KM)
def test_the_stored_search_is_as_strong_as_others(name):
    (row,) = (r for r in stored_run()["rows"]["all-methods"] if r["method"] == name)
    assert row["metres"] > FOUND_IN_1_KM[name]


def test_a_search_finds_satviz_never_wrong_and_shapely_only_beside_the_origin():
    for method in all_methods():
        if method.language == COMPILED and method.family in ("exact", "library"):
            found = worst_pair(method, worst_kilometre_shapes, np.random.default_rng(1), 300, 8, metres=True)
            wrong = method.family == "library"
            assert len(found.a) == wrong and found.tried > 1000
            if wrong:
                assert truth.squared_gap(Polygon(found.a[0]), Polygon(found.b[0])) < 1e-30**2
                assert min(np.abs(found.a).max(axis=2).min(), np.abs(found.b).max(axis=2).min()) < 1e-11


# what other searches found; both are apart, and textbook SAT with both ranges calls them a hit
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


def textbook_sat(a, b, unit):
    for (px, py), (qx, qy) in chain.from_iterable(zip([ring[-1], *ring], ring) for ring in (a, b)):
        nx, ny = qy - py, px - qx
        length = math.sqrt(nx * nx + ny * ny) if unit else 1.0
        nx, ny = nx / length, ny / length
        p, q = ([x * nx + y * ny for x, y in ring] for ring in (a, b))
        if max(min(p) - max(q), min(q) - max(p)) > 0:
            return False
    return True


@pytest.mark.parametrize("normals", FOUND)
def test_a_pair_that_textbook_sat_is_wrong_about_is_below_the_bound_of_both_ranges(normals):
    a, b, known = FOUND[normals]
    p, q = Polygon(a), Polygon(b)
    assert truth.agreed(p, q) == Relation.APART and round(relative_margin(p, q), 2) == known
    assert textbook_sat(a, b, unit=normals == "unit normals")  # a hit, which is wrong
    assert known < speed_against_accuracy.PROVEN_MARGINS[f"SAT, {normals}"]


def test_where_float32_cannot_hold_the_shapes_or_their_products_no_margin_is_enough():
    rows = result("margin-float32")
    assert len(rows) == 2 and all(row["wrong"] and row["margin"] > 2.0**48 for row in rows)


def test_where_float32_rounds_the_corners_it_is_wrong_above_its_number_of_roundings_and_advise_does_not_trust_it():
    (row,) = (r for r in stored_run()["rows"]["all-methods"] if r["method"] == "SAT, float32")
    a, b = Polygon(row["a"]), Polygon(row["b"])
    assert relative_margin(a, b) > speed_against_accuracy.PROVEN_MARGINS["SAT, raw normals"] * 2.0**29
    assert "SAT, float32 (8 axes): not proven" in str(advise(a, b))


def said_by_float32(a, b):
    """Return whether SAT in float32 calls this pair of 4-gons a hit."""
    (method,) = (m for m in speed_against_accuracy.compiled_methods() if m.name == "SAT, float32")
    ((_, answers),) = answers_by_method([method], np.array([a]), np.array([b]))
    return bool(answers[0])


@pytest.mark.parametrize("side, deep", [(1.0, 1e-3), (0.1, 1e-2), (0.01, 0.1)])
def test_the_shorter_a_side_the_deeper_the_overlap_that_float32_misses(side, deep):
    """The ends of a side are rounded in opposite directions; B lies at the far end of the edge that goes on from it."""
    along, aside = np.array([-1, 1]) / 2**0.5, 0.499 * float(np.spacing(np.float32(985)))
    start, bent = 985 - np.full(2, aside), (985 + side * along).astype(np.float32).astype(float) + aside
    edge = (bent - start) / math.hypot(*(bent - start))
    out = np.array([edge[1], -edge[0]])
    a = np.array([bent, bent + (13.5 - side) * (edge - 3e-6 * out), start + 1.5 * edge - 1.2 * out, start])
    tip = a[1] - 0.1 * edge - deep * out
    b = np.array([tip, tip - edge + 2 * out, tip + 4 * out, tip + edge + 2 * out])
    p, q = Polygon(a), Polygon(b)
    assert truth.agreed(p, q) == Relation.OVERLAPPING and truth.squared_gap(p, q) > (deep * 0.999) ** 2
    assert not said_by_float32(a, b)
    sides = [math.dist(ring[k - 1], ring[k]) for ring in (a, b) for k in range(4)]
    assert min(sides) >= side * 0.99 and max(math.dist(p, q) for p, q in combinations(a, 2)) < 14


@pytest.mark.parametrize("size", [2.0**70, 2.0**-80])
def test_float32_is_wrong_where_it_holds_the_corners_but_not_their_products(size):
    box = np.array([(0, 0), (1, 0), (1, 1), (0, 1)]) * size
    apart = np.add(box, [1.5 * size, 0])
    assert np.array_equal(apart, apart.astype(np.float32)) and relate(Polygon(box), Polygon(apart)) == Relation.APART
    assert said_by_float32(box, apart)


def test_satviz_is_never_wrong_and_bounds_err_only_to_a_hit():
    for work in speed_against_accuracy.WORKS:
        for row in result(f"count-{work}"):
            assert row["method"] != "satviz" or row["wrong"] == 0
            if work == "near" and row["method"] in ("AABB", "bounding circles"):
                assert row["false_hits"] > 0 == row["missed_hits"], row
    for name, rows in results("margin-").items():
        if name != "margin-float32":
            assert all(row["wrong"] == 0 for row in rows if row["method"] == "satviz"), name


def test_a_tolerance_is_wrong_up_to_its_own_size_and_no_further():
    row = result("worst-SAT-tolerance-1e-9")
    assert 0.5e-9 < row["metres"] < 1e-9 + speed_against_accuracy.proven_metres("SAT, raw normals")


def test_a_touch_called_an_overlap_counts_as_wrong_only_for_methods_that_distinguish_them():
    right = np.array([0, 1, 2, 1])
    assert count_mistakes(np.array([0, 2, 1, 1]), right) == {"false_hits": 0, "missed_hits": 0, "confused": 2}
    assert count_mistakes(np.array([1, 2, 1, 0]), right) == {"false_hits": 1, "missed_hits": 1, "confused": 2}
    assert count_mistakes(right > 0, right) == {"false_hits": 0, "missed_hits": 0, "confused": 0}


@pytest.mark.parametrize("work", ["triangles", "boxes", "8-gons"])
def test_every_complete_method_is_right_where_nothing_is_near(work):
    a, b = WORKLOADS[work](np.random.default_rng(2), 200)
    right = true_relations(a, b)
    for method, said in answers_by_method(all_methods(), a, b):
        if method.family not in ("bounds",):
            assert np.array_equal(said > 0, right > 0), method


@pytest.mark.parametrize("work", WORKLOADS)
def test_a_method_answers_from_arrays_as_from_prepared_shapes_and_leaves_the_arrays_alone(work, monkeypatch):
    monkeypatch.setattr(methods, "TILE_PAIRS", 64)  # the last tile is not full
    a, b = WORKLOADS[work](np.random.default_rng(2), 200)
    kept = copy.deepcopy((a, b))
    for method in all_methods(circles=isinstance(a, tuple)):
        prepared = method.hits(method.prepare(a), method.prepare(b))
        assert np.array_equal(method.from_arrays(a, b), prepared), method
    assert all(map(np.array_equal, (*a, *b), (*kept[0], *kept[1])))


def test_the_study_and_the_bench_time_from_arrays_with_the_same_function(monkeypatch):
    seen, real = set(), Method.from_arrays
    monkeypatch.setattr(Method, "from_arrays", lambda self, a, b: seen.add(self.name) or real(self, a, b))
    for work in (
        lambda: list(bench._bench_hits(bench.plan_bench(20, 1, 0))),
        lambda: exactness_cost.take_times(50, 1, QUICK),
        lambda: speed_against_accuracy.take_times(50, 1, QUICK),
    ):
        seen.clear()
        work()
        assert seen >= {"satviz", "SAT, raw normals"}


def test_gjk_counts_touching_and_concentric_shapes_as_hits():
    points = python_rivals.points_and_radius
    square = Polygon([(0, 0), (1, 0), (1, 1), (0, 1)])
    beside, corner = Polygon([(1, 0), (2, 0), (2, 1), (1, 1)]), Polygon([(1, 1), (2, 1), (2, 2), (1, 2)])
    for other in (square, beside, corner, Circle((0.5, 0.5), 0.1), Circle((2, 0.5), 1)):
        assert python_rivals.gjk(points(square), points(other))
    assert not python_rivals.gjk(points(square), points(Circle((2.5, 0.5), 1)))


@pytest.mark.parametrize("v", [3, 4, 7, 24, 100])
def test_every_method_for_many_corners_gives_the_right_answer(v):
    rng = np.random.default_rng(v)
    for make, hit in (apart_pairs, False), (overlapping_pairs, True):
        for name, job in corner_count.ready_jobs(*make(rng, 40, v)).items():
            assert set(job()) == {hit}, name


# -- poses, pushes, the stack and the table


def test_the_exact_rotation_matches_cos_and_sin_of_the_angle():
    for angle in 0.001, 0.0537, 0.1:
        c, s = pose_error._exact_turn(angle)
        assert c / 2**pose_error.BITS == pytest.approx(math.cos(angle), abs=1e-15)
        assert s / 2**pose_error.BITS == pytest.approx(math.sin(angle), abs=1e-15)
        assert abs(c * c + s * s - (1 << 2 * pose_error.BITS)) < 1 << pose_error.BITS + 8


def test_the_error_of_one_turn_is_not_lost_in_rounding():
    rows = pose_error.measure(20, QUICK)
    (one,) = (r for r in rows if (r["format"], r["way"], r["distance"], r["steps"]) == ("float64", "steps", 1e3, 1))
    assert 0 < one["low"] < one["median"] < one["worst"] < 2.0**-42  # two steps of float64 at 1 km


def test_turning_in_steps_has_more_error_than_a_counted_angle_and_a_summed_angle_most():
    at = {(r["format"], r["way"], r["distance"], r["steps"]): r["worst"] for r in result("pose")}
    sat = speed_against_accuracy.proven_metres("SAT, raw normals")
    for form in "float64", "float32":
        assert at[form, "steps", 1e3, 10_000] > 5 * at[form, "angle", 1e3, 10_000]
        assert at[form, "steps", 1e6, 10_000] > 100 * at[form, "steps", 1e3, 10_000]
    assert at["float64", "sum", 1e3, 10_000] > 5 * at["float64", "steps", 1e3, 10_000] > 50 * sat


@pytest.mark.parametrize("angles, better, worse", [((1e-6, 1e-5), "sum", "steps"), ((50.0, 60.0), "steps", "angle")])
def test_which_rotation_method_has_the_least_error_depends_on_the_step_angle(monkeypatch, angles, better, worse):
    monkeypatch.setattr(pose_error, "STEP_ANGLES", angles)
    monkeypatch.setattr(pose_error, "DISTANCES", (1e3,))
    median = {(r["way"], r["steps"]): r["median"] for r in pose_error.measure(9, QUICK) if r["format"] == "float64"}
    assert 3 * median[better, 10_000] < median[worse, 10_000]


def test_a_push_of_satviz_is_long_enough_and_least():
    rows = [row for own in results("mtv-").values() for row in own]
    for row in rows:
        assert sum(row[outcome] for outcome in mtv_by_method.OUTCOMES) == row["pairs"]
        if row["method"] == "satviz":
            assert row["right"] == row["pairs"] and row["length_largest"] < 1e-9 and row["angle_largest"] < 1e-9
    assert any(row["turned"] for row in rows if row["method"] == "SAT, raw normals")
    assert any(row["overlap left by rounding"] for row in rows if row["method"] == "SAT, float64")
    assert any(row["overlap left, seen"] for row in rows if row["method"] == "deepest parts")


def test_an_angle_is_measured_to_the_nearest_of_the_least_pushes_and_not_rounded_away():
    ways = [(Fraction(1), Fraction(0)), (Fraction(0), Fraction(3))]
    assert mtv_by_method.angle_between((0.0, 7.0), ways) == 0
    assert mtv_by_method.angle_between((1.0, 1.0), ways) == pytest.approx(45)
    assert mtv_by_method.angle_between((-1.0, 0.0), ways) == pytest.approx(90)
    assert mtv_by_method.angle_between((1.0, 1e-30), ways) == pytest.approx(math.degrees(1e-30))


def test_a_stack_rests_with_exact_tests_and_not_with_upright_boxes():
    of = {(row["test"], row["away"]): row for row in results("stack-").values()}
    assert abs(of["exact", 0.0]["sunk_at_end"]) < 0.03 and of["exact", 0.0]["jitter"] < 1e-3
    assert of["boxes", 0.0]["sunk_at_end"] > 0.5
    stored = {(row["test"], row["away"]): row for row in CHARTS["resting-stack"].rows}
    for away in resting_stack.PLACES:
        assert all(stored[test, away]["sunk_at_end"] < resting_stack.BOXES * SLOP for test in ("exact", "float64"))
        assert stored["float64", away]["jitter"] < 10 * stored["exact", away]["jitter"] < 1e-7
    assert stored["float32", resting_stack.FAR]["jitter"] > 0.1
    for row in of.values():
        assert len(row["sunk"]) == len(row["energy"]) == row["seconds"] * 10 and min(row["energy"]) >= 0


def test_two_boxes_share_the_ends_of_their_common_side():
    low, high = ((0, 0), (4, 0), (4, 1), (0, 1)), ((3, 1), (6, 1), (6, 2), (3, 2))
    assert sorted(contact_points(low, high, (0.0, 1.0))) == [(3.0, 1.0), (4.0, 1.0)]


def test_the_table_names_the_simplest_model_that_each_scene_needs():
    kinds = [row["kind"] for row in result("decision")]
    assert kinds == ["AABB", "AABB", "circles", "float32", "float64", "exact", "exact"]


def test_the_order_of_axes_never_changes_a_verdict():
    rows = result("order")
    assert all(row["right"] == row["frames"] for row in rows)
    tested = {row["order"]: row["tested"] for row in rows}
    assert tested[axis_order.LAST_FIRST] < tested[axis_order.SHUFFLED]


def test_flat_shapes_reverse_the_ranking_of_two_orders_of_axes(monkeypatch):
    ngons = axis_order.ngons
    flat = np.array([[0.7, 0.7], [-0.035, 0.035]])  # a twentieth as high, turned by 45 degrees
    monkeypatch.setattr(axis_order, "ngons", lambda *arguments: ngons(*arguments) @ flat)
    tested = {row["order"]: row["tested"] for row in axis_order.count_tested_axes(20, 40, QUICK)}
    assert tested[axis_order.LAST_FIRST] < tested[axis_order.ALONG_CENTERS]
    stored = {row["order"]: row["tested"] for row in CHARTS["order-of-axes"].rows}
    assert stored[axis_order.LAST_FIRST] > stored[axis_order.ALONG_CENTERS]


def test_the_axis_of_the_last_frame_is_tested_first_and_no_axis_is_lost():
    a, b = next(axis_order.passing_frames(QUICK.rng("order"), 2))
    axes = needed(a, b).axes
    for axis in axes:
        ordered = axis_order.last_first(axes, axis.source)
        assert ordered[0] == axis and sorted(ordered) == sorted(axes)
    assert axis_order.last_first(axes, None) == axes


# -- the method of the study


@pytest.mark.parametrize("section", run.SECTIONS, ids=lambda section: section.__name__.rpartition(".")[2])
def test_a_section_says_before_its_numbers_what_it_asks_and_what_would_refute_it(section):
    text = " ".join(section.__doc__.split())
    for words in "Question: ", "Workload: ", "Methods: ", "claim is refuted ":
        assert words in text, words


def test_counts_are_the_same_on_a_rerun_with_the_same_seed():
    for name in "count-near", "worst-GJK", "margin-needles", "search-SAT-raw-normals", "order", "mtv-overlapping":
        assert json.loads(json.dumps(small(CELLS[name]))) == result(name), name


def twice(x):
    return [{"ns": 2.0 * x, "pid": os.getpid()}]


def test_a_timed_cell_runs_in_the_process_of_its_number():
    (one,), (other,), (again,) = (timings.in_process(k, twice, 4) for k in (0, 1, 0))
    assert one["ns"] == 8 and one["pid"] == again["pid"] and len({one["pid"], other["pid"], os.getpid()}) == 3


def test_after_a_process_died_the_next_cell_has_a_new_one():
    with pytest.raises(BrokenExecutor):
        timings.in_process(0, os._exit, 1)
    assert timings.in_process(0, abs, -1) == 1


def test_times_are_the_median_over_processes_with_the_spread_between_them():
    found = {f"speed-{k}-times": [{"method": "one", "ns": float(ns)}] for k, ns in enumerate((5, 9, 6))}
    (row,) = timings.over_processes(found, "speed")
    assert (row["ns"], row["ns_low"], row["ns_high"], row["ns_runs"]) == (6.0, 5.0, 9.0, [5.0, 9.0, 6.0])


def test_the_interval_of_a_ratio_compares_the_times_of_one_process():
    assert timings.ratio_interval([10.0, 20.0, 40.0], [5.0, 10.0, 20.0]) == (2.0, 2.0, 2.0)  # slow for both
    assert timings.ratio_interval([10.0, 11.0, 14.0, 10.0, 12.0], [5.0] * 5) == (2.2, 2.0, 2.8)
    assert timings.interval_in_words(6) == "the 97 % interval over 6 processes"
    assert timings.format_ratio((1.66, 1.5, 1.749)) == "1.7 times (1.5 to 1.7)"
    assert timings.format_ratio((44.8, 9.6, 45.3)) == "45 times (9.6 to 45)"


def covered(interval, true, samples):
    """Return the share of the samples whose interval holds the true value."""
    return np.mean([low <= true <= high for low, high in map(interval, samples)])


def test_intervals_hold_the_true_value_as_often_as_they_say():
    rng = np.random.default_rng(1)
    times = rng.lognormal(0, 0.3, (2000, 6))
    assert 0.96 < covered(lambda own: timings.ratio_interval(own, [0.5] * 6)[1:], 2.0, times) < 0.98
    for n in 8, 9, 20, 60:
        assert covered(lambda own: median_interval(own)[1:], 1.0, rng.lognormal(0, 1, (2000, n))) > 0.94, n
    for rate in 0.5, 0.88, 0.01:
        assert covered(lambda wrong: wilson_interval(int(wrong), 600), rate, rng.binomial(600, rate, 2000)) > 0.93, rate


def test_a_quick_run_or_one_whose_times_differ_much_is_marked_as_rough():
    calm, torn = {"ns": 10.0, "ns_low": 9.5, "ns_high": 10.5}, {"ns": 10.0, "ns_low": 6.0, "ns_high": 14.0}
    assert timings.timing_warning([calm] * 4, QUICK) == "rough: a quick run"
    others = [{key: value * k for key, value in calm.items()} for k in (2, 3)]
    assert timings.timing_warning([calm, *others, torn, torn], Settings()) == ""  # the rows share one time
    assert "differ by 25%" in timings.timing_warning([calm, torn], Settings())


# -- charts


def test_a_small_run_draws_ten_charts_from_their_rows_alone():
    rows = json.loads(json.dumps(run.all_rows(results(""), run.SECTIONS)))  # what is not in the file cannot be drawn
    charts = {chart.stem: chart for chart in run.charts_of(rows, QUICK)}
    assert list(charts) == list(CHARTS) and len(charts) == 10 and next(iter(charts)) == "speed-against-accuracy"
    for chart in charts.values():
        assert chart.rows and "{" not in chart.reading and chart.reading.endswith(".")
        chart.figure(THEMES["light"])


def test_the_chart_of_all_methods_names_those_that_were_never_found_wrong():
    rows = CHARTS["all-methods"].rows
    assert CHARTS["all-methods"].title.startswith("Never found wrong: satviz.")
    wrong = [{**row, "touching_wrong": 1} if row["method"] == "satviz" else row for row in rows]
    assert speed_against_accuracy.all_methods_chart(wrong, QUICK).title.startswith("Never found wrong: none.")


def test_the_headline_has_at_most_eight_labels():
    assert len(speed_against_accuracy.LABELS) <= 8


def test_a_title_is_computed_from_its_rows():
    main = CHARTS["speed-against-accuracy"]
    slower = [{**row, "ns_runs": [3 * t for t in row["ns_runs"]]} if row["method"] == "satviz" else row
              for row in main.rows]  # fmt: skip
    before, after = (
        float(re.search(r"takes ([\d.]+) times", chart.title)[1])
        for chart in (main, speed_against_accuracy.main_chart(slower, QUICK))
    )
    assert after == pytest.approx(3 * before, abs=0.2)


def test_the_headline_draws_the_ratio_that_its_title_states():
    chart = CHARTS["speed-against-accuracy"]
    ratio = re.search(r"takes ([\d.]+ times)", chart.title)[1]
    assert [text.get_text() for ax in chart.figure(THEMES["light"]).axes for text in ax.texts].count(ratio) == 1


def test_the_title_of_the_margins_has_what_its_strip_says():
    chart = CHARTS["relative-margin"]
    found, proven = re.search(r"up to ([\d.]+) roundings .* above (\d+) it is proven", chart.title).groups()
    texts = [text.get_text() for ax in chart.figure(THEMES["light"]).axes for text in ax.texts]
    assert f"found {found}, proven {proven}" in texts


@pytest.mark.parametrize(
    "stem", [stem for stem in CHARTS if stem not in ("decision-table", "relative-margin")]
)  # the first counts all of its scenes; the second has the worst found and a bound, no rate
def test_a_title_has_the_interval_of_its_finding(stem):
    assert re.search(r"\d\S*(\u00a0\S+)? to \d", CHARTS[stem].title)


def test_the_headline_names_who_checked_the_answers():
    reading = CHARTS["speed-against-accuracy"].reading
    assert re.search(r"satviz was wrong on 0 of [\d,]+ hard pairs that two exact oracles checked", reading)


def test_charts_that_compare_programs_name_the_vectorised_ones():
    for stem in "speed-against-accuracy", "all-methods", "price-of-exactness":
        assert "several pairs at a time" in CHARTS[stem].reading


def drawn_texts(fig):
    """Yield every drawn label of a figure; ticks beyond the view are not drawn."""
    yield from fig.texts
    for ax in fig.axes:
        yield from (child for child in ax.get_children() if isinstance(child, Text))
        for axis in (ax.xaxis, ax.yaxis) if ax.axison else ():
            low, high = sorted(axis.get_view_interval())
            ticks = zip(axis.get_ticklocs(), axis.get_ticklabels(), strict=True)
            yield from (axis.label, *(label for at, label in ticks if low <= at <= high))


@each_theme
def test_no_label_of_a_chart_covers_another_or_leaves_it(theme):
    for chart in DRAWN.values():
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


def test_a_longer_title_makes_a_higher_chart():
    short, long = (Chart("stem", title, (), 0.0, print, [], "").size[1] for title in ("one two", "one two " * 20))
    assert long > short


def test_letters_have_eleven_pixels_on_a_phone():
    assert all(chart.size[0] == WIDTH for chart in DRAWN.values()) and TEXT_POINTS * 390 / WIDTH >= 11


def test_cells_can_be_pickled_and_have_unique_names():
    for settings in Settings(), QUICK:
        cells = [cell for section in run.SECTIONS for cell in section.cells(settings)]
        assert pickle.loads(pickle.dumps(cells)) == cells
        assert len({cell.name for cell in cells}) == len({cell.key for cell in cells}) == len(cells)
        assert {cell.name.endswith("-times") for cell in cells if cell.timed} == {True}


def test_padding_is_removed_from_polygons_of_mixed_corner_counts():
    rings, _ = WORKLOADS["mixed, 3 to 8 corners"](np.random.default_rng(2), 50)
    counts = [len(ring) for ring in unpadded_rings(rings)]
    assert set(counts) <= set(range(3, 9)) and len(set(counts)) > 3


def test_every_method_says_what_it_is():
    for circles_too in (False, True):
        found = all_methods(circles=circles_too)
        assert len({(m.language, m.name) for m in found}) == len(found) > 5 - 2 * circles_too
    assert {m.language for m in all_methods()} >= {COMPILED, PYTHON}


def test_the_title_of_the_stack_says_whether_float64_rests_as_still_as_exact_tests():
    stored = CHARTS["resting-stack"]
    assert "rests as still with float64" in stored.title
    moved = [row | {"jitters": [0.2, 0.3]} if row["test"] == "float64" else row for row in stored.rows]
    title = resting_stack.chart(moved, Settings(quick=False, seed=1)).title.replace("\xa0", " ")
    assert "rests less still with float64 (jitter 200 mm to 300 mm) than with exact tests" in title
