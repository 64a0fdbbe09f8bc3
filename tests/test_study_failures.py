"""The failure maps: wrong where the shortcut is wrong, never where the engine answers, the same each time."""

import json
from functools import cache
from math import isclose
from random import Random

import pytest
from matplotlib.text import Text
from mpl_toolkits.mplot3d.art3d import Text3D

import satviz as sv
from satviz.engine.axes import needed
from satviz.pictures import LIGHT
from satviz.scenes.article import box
from satviz.scenes.failing import FALSE_HIT, MISSED_HIT, NAMED, REFUSED, ROWS
from satviz.scenes.failing.reading import moved
from satviz.scenes.shortcuts import middle
from satviz.study import failures, swept, threed, truth
from satviz.study.cells import Settings
from satviz.study.failure_map import LOOKS
from satviz.study.failures import APART, FALSE, FAR, HIT, LONG, METHODS, MISSED, SHORT, WRONG, Slide

pytestmark = pytest.mark.slow

SMALL = 13
each = pytest.mark.parametrize("name", METHODS)


@cache
def small(name):
    return Slide(**failures.slide(name, SMALL))


@cache
def charts():
    results = {f"failures-{name}": small(name)._asdict() for name in METHODS}
    more = {cell.name: cell.work() for cell in (*threed.cells(Settings()), *swept.cells(Settings()))}
    return failures.charts(json.loads(json.dumps(results | more)))


def code_at(slide, at):
    """The letter of the position nearest to a point, and how far it is."""
    x, y, code = min(slide.positions(), key=lambda p: (p[0] - at.x) ** 2 + (p[1] - at.y) ** 2)
    return code, max(abs(x - at.x), abs(y - at.y))


@each
def test_a_map_is_the_same_each_time_and_goes_through_json(name):
    again = failures.slide(name, SMALL)
    assert Slide(**json.loads(json.dumps(again))) == small(name)


@each
def test_the_scene_itself_is_on_the_map_and_wrong_there(name):
    if name == "touch-on-paper":  # wrong by a number, not by a verdict
        return
    code, off = code_at(small(name), middle(NAMED[name].b))
    assert off < (0.2 if small(name).path else 1e-9) and code in WRONG


@each
def test_the_shortcut_is_wrong_somewhere_in_the_way_its_row_says(name):
    found, row = set(small(name).counts), NAMED[name]
    assert found <= {APART, HIT, *WRONG}
    if name in failures.VERDICTS:
        assert found <= {APART, HIT, FALSE, MISSED}
        assert {FALSE_HIT: FALSE, MISSED_HIT: MISSED}.get(row.how, FALSE) in found or name == "touch-on-paper"
    else:
        assert found & ({SHORT, LONG} if name in failures.PUSHES else {FAR})


LEAVING_OUT = [row.name for row in ROWS if row.shortcut.choose is not needed and row.shortcut.measure is None]


@pytest.mark.parametrize("name", [name for name in LEAVING_OUT if name in failures.VERDICTS])
def test_leaving_axes_out_never_misses_a_hit(name):
    assert MISSED not in small(name).counts


@pytest.mark.parametrize("name", [name for name in METHODS if name not in failures.DISTANCES])
def test_the_engine_is_right_everywhere_on_the_map(name, monkeypatch):
    engine = NAMED[name]._replace(shortcut=sv.Shortcut("none", "as it should be", split=sv.parts))
    monkeypatch.setitem(failures.NAMED, name, engine)
    assert Slide(**failures.slide(name, SMALL)).wrong == 0


def test_a_verdict_is_judged_by_rationals_and_not_by_any_method():
    row = NAMED["box-in-u"]
    inside = moved(row.b, sv.Vec(0.0, -0.5))
    assert failures.relation(row.a, inside) is sv.Relation.APART
    assert failures.relation(row.a, moved(row.b, sv.Vec(0.0, -1.0))) is sv.Relation.TOUCHING
    assert failures.relation(row.a, moved(row.b, sv.Vec(0.5, -1.5))) is sv.Relation.OVERLAPPING


def test_the_exact_depth_is_the_mtvs_length():
    assert failures.depth2(box(0, 0, 4, 1), box(3, 0.5, 5, 3.5)) == 0.25
    rng = Random(3)
    for _ in range(60):
        a, b = (
            sv.Polygon([(rng.uniform(-2, -1), 0), (rng.uniform(0.2, 1), -1), (1, rng.uniform(0.5, 2))])
            for _ in range(2)
        )
        if failures.relation(a, b) is sv.Relation.OVERLAPPING:
            x, y = sv.record(a, b).mtv
            assert isclose(failures.depth2(a, b), x * x + y * y, rel_tol=1e-9)


def test_along_the_contact_the_shapes_touch_everywhere():
    row = NAMED[failures.ALONG_CONTACT[0]]
    moves = list(failures.contacts(row.a, row.b, 5))
    assert len(moves) == 6 * 8
    assert {truth.relation(row.a, moved(row.b, move)) for move in moves} == {sv.Relation.TOUCHING}


def letter_at(slide, x, y):
    """The letter of the area that holds a point; apart and right where none does."""
    for letter, ring in slide.areas:
        turns = [(q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]) for p, q in zip(ring, [*ring[1:], ring[0]])]
        if min(turns) >= 0 or max(turns) <= 0:
            return letter
    return APART


@each
def test_the_areas_say_of_each_position_what_was_judged_there(name):
    found = small(name)
    if found.path or name == failures.ON_PAPER:
        assert not found.areas
        return
    off = [(x, y) for x, y, code in found.positions() if letter_at(found, x + 1e-9, y + 1e-9) != code]
    # a position can lie on a boundary, where two areas meet
    nearby = [
        {letter_at(found, x + s * 0.1 * found.dx, y + t * 0.1 * found.dy) for s in (-1, 1) for t in (-1, 1)}
        for x, y in off
    ]
    assert sum(len(letters) == 1 for letters in nearby) <= 0.03 * SMALL**2, off  # what is narrower than a step


def test_a_traced_area_has_the_boundaries_it_was_asked_about():
    rings = failures.traced(lambda x, y: FALSE if abs(x) + abs(y) < 1 else APART, (-2.0, -2.0, 2.0, 2.0), 16)
    area = sum(abs(sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(ring, [*ring[1:], ring[0]]))) / 2 for _, ring in rings)
    assert area == pytest.approx(2, abs=0.03) and {letter for letter, _ in rings} == {FALSE}
    assert max(abs(x) + abs(y) for _, ring in rings for x, y in ring) < 1.02


def test_a_maps_boundaries_are_those_of_the_difference_and_not_of_its_grid():
    rings = [ring for letter, ring in small("aabb-turned").areas if letter == FALSE]
    spots = {(round(x, 9), round(y, 9)) for ring in rings for x, y in ring}
    assert {(2, 2), (2, -2), (-2, 2), (-2, -2), (2, 0), (0, 2)} <= spots


def test_what_is_wrong_has_one_colour_and_each_way_a_hatch_of_its_own():
    looks = {code: LOOKS[code] for code in WRONG}
    assert {role for role, _, _ in looks.values()} == {"wrong"} != {LOOKS[HIT][0]}
    assert len({hatch for _, _, hatch in looks.values()}) == len(WRONG)


def test_quick_maps_are_smaller_and_every_cell_is_done_by_name():
    quick, full = failures.cells(Settings(quick=True)), failures.cells(Settings())
    assert [cell.name for cell in quick] == [cell.name for cell in full]
    assert len({cell.name for cell in full}) == len(full) == len(METHODS) + 2
    assert sum(cell.arguments[1] for cell in quick if cell.arguments) < sum(
        cell.arguments[1] for cell in full if cell.arguments
    )


def test_every_row_that_is_a_method_has_a_map_and_the_rest_are_named():
    rest = {row.name for row in ROWS} - set(METHODS)
    about_no_method = {"only-one-axis", "one-maximum", "many-pairs", "gjk-looks-less"}
    assert rest == {row.name for row in ROWS if row.how == REFUSED} | set(failures.OTHERS) | about_no_method


# -- charts


def test_there_is_a_chart_for_all_maps_one_each_and_those_of_space_and_time():
    stems = [chart.stem for chart in charts()]
    assert len(set(stems)) == len(stems) == 1 + len(METHODS) + 2
    assert stems[0] == "failing-maps"


def test_a_reading_says_the_counts_and_both_answers():
    by_stem = {chart.stem: chart for chart in charts()}
    slide, row = small("no-nearest-vertex"), NAMED["no-nearest-vertex"]
    text = by_stem["failing-19-no-nearest-vertex"].reading
    assert f"{slide.counts[FALSE]} false hits" in text and f"{SMALL * SMALL} positions" in text
    assert row.told(row.wrong) in text and row.told(row.truth) in text
    (of_it,) = (line for line in by_stem["failing-maps"].rows if line["name"] == row.name)
    assert of_it["false hit"] == slide.wrong and of_it["positions"] == SMALL * SMALL


def test_the_rows_beside_a_map_hold_every_answer():
    for chart in charts()[1 : len(METHODS) + 1]:
        name = chart.stem.split("-", 2)[2]
        answers = "".join(row.get("answers") or row["answer"] for row in chart.rows)
        assert answers == "".join(small(name).codes)


def test_every_letter_of_every_chart_is_on_it_and_large_enough():
    for chart in charts():
        fig = chart.figure(LIGHT)
        if chart.stem == "failing-32-tunnelling":
            fig.draw_without_rendering()  # an axis's own words are placed in drawing
        renderer, frame = fig.canvas.get_renderer(), fig.bbox
        texts = [t for t in fig.findobj(Text) if t.get_visible() and t.get_text() and not isinstance(t, Text3D)]
        assert texts
        for text in texts:
            size = text.get_window_extent(renderer)
            inside = frame.x0 <= size.x0 and size.x1 <= frame.x1 and frame.y0 <= size.y0 and size.y1 <= frame.y1
            assert inside, f"{chart.stem}: {text.get_text()!r} is cut off"
            assert text.get_fontsize() >= 10, f"{chart.stem}: {text.get_text()!r} is small"


def test_the_windows_of_the_moving_pair_are_exact():
    x, y = swept.windows()
    assert (x["enter"], x["leave"], x["never"]) == ("37/80", "43/80", False)
    assert (y["enter"], y["leave"], y["never"]) == ("0", "1", False)
    chart = charts()[-1]
    assert "from t = 0.4625 to 0.5375" in chart.reading and "1.85 away" in chart.reading


def test_the_chart_of_space_names_the_only_axis_that_separates():
    rows = threed.gaps()
    assert [row["kind"] for row in rows].count("face normal") == 6 and len(rows) == 15
    assert [row["axis"] for row in rows if row["gap"] > 0] == ["A3 × B1"]
    assert "by 0.374" in charts()[-2].reading and "gap of 0.472" in charts()[-2].reading
