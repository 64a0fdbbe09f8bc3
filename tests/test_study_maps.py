"""The failure maps: wrong where the shortcut is wrong, never where the engine answers, the same each time."""

import json
from functools import cache
from math import dist, isclose
from random import Random

import pytest

import satviz as sv
from satviz.engine.axes import needed
from satviz.scenes.error_region import error_region_in_view
from satviz.scenes.failing import FAILURE_CASES, FALSE_HIT, MISSED_HIT, NAMED, REFUSED, WRONG_NUMBER
from satviz.scenes.shape_tools import box, translated, vertex_mean
from satviz.study import truth
from satviz.study.harness.cells import Settings
from satviz.study.sections import maps, slides
from satviz.study.sections.maps import LOOKS
from satviz.study.sections.slides import APART, FALSE, FAR, HIT, LONG, METHODS, MISSED, SHORT, WRONG, Slide

pytestmark = pytest.mark.slow

SMALL = 13
each = pytest.mark.parametrize("name", METHODS)


@cache
def small(name):
    return Slide(**slides.slide(name, SMALL))


@cache
def charts():
    results = {f"map-{name}": small(name)._asdict() for name in METHODS}
    return maps.charts(json.loads(json.dumps(results)), Settings())


def code_at(slide, at):
    """The letter of the position nearest to a point, and how far it is."""
    x, y, code = min(slide.positions(), key=lambda p: (p[0] - at.x) ** 2 + (p[1] - at.y) ** 2)
    return code, max(abs(x - at.x), abs(y - at.y))


@each
def test_a_map_is_the_same_each_time_and_goes_through_json(name):
    again = slides.slide(name, SMALL)
    assert Slide(**json.loads(json.dumps(again))) == small(name)


@each
def test_the_scene_itself_is_on_the_map_and_wrong_there(name):
    if name == "touch-on-paper":  # wrong by a number, not by a verdict
        return
    code, off = code_at(small(name), vertex_mean(NAMED[name].b))
    assert off < (0.2 if small(name).path else 1e-9) and code in WRONG


@each
def test_the_shortcut_is_wrong_somewhere_in_the_way_its_row_says(name):
    found, row = set(small(name).counts), NAMED[name]
    assert found <= {APART, HIT, *WRONG}
    if name in slides.VERDICTS:
        assert found <= {APART, HIT, FALSE, MISSED}
        assert {FALSE_HIT: FALSE, MISSED_HIT: MISSED}.get(row.how, FALSE) in found or name == "touch-on-paper"
    else:
        assert found & ({SHORT, LONG} if name in slides.PUSHES else {FAR})


LEAVING_OUT = [row.name for row in FAILURE_CASES if row.shortcut.choose is not needed and row.shortcut.measure is None]


@pytest.mark.parametrize("name", [name for name in LEAVING_OUT if name in slides.VERDICTS])
def test_leaving_axes_out_never_misses_a_hit(name):
    assert MISSED not in small(name).counts


@pytest.mark.parametrize("name", [name for name in METHODS if name not in slides.DISTANCES])
def test_the_engine_is_right_everywhere_on_the_map(name, monkeypatch):
    engine = NAMED[name]._replace(shortcut=sv.Shortcut("none", "as it should be", split=sv.parts))
    monkeypatch.setitem(slides.NAMED, name, engine)
    assert Slide(**slides.slide(name, SMALL)).wrong == 0


def test_a_verdict_is_judged_by_rationals_and_not_by_any_method():
    row = NAMED["box-in-u"]
    inside = translated(row.b, sv.Vec(0.0, -0.5))
    assert slides.relation(row.a, inside) is sv.Relation.APART
    assert slides.relation(row.a, translated(row.b, sv.Vec(0.0, -1.0))) is sv.Relation.TOUCHING
    assert slides.relation(row.a, translated(row.b, sv.Vec(0.5, -1.5))) is sv.Relation.OVERLAPPING


def test_the_exact_depth_is_the_mtvs_length():
    assert slides.depth2(box(0, 0, 4, 1), box(3, 0.5, 5, 3.5)) == 0.25
    rng = Random(3)
    for _ in range(60):
        a, b = (
            sv.Polygon([(rng.uniform(-2, -1), 0), (rng.uniform(0.2, 1), -1), (1, rng.uniform(0.5, 2))])
            for _ in range(2)
        )
        if slides.relation(a, b) is sv.Relation.OVERLAPPING:
            x, y = sv.record(a, b).mtv
            assert isclose(slides.depth2(a, b), x * x + y * y, rel_tol=1e-9)


def test_along_the_contact_the_shapes_touch_everywhere():
    row = NAMED[slides.ALONG_CONTACT[0]]
    moves = list(slides.contacts(row.a, row.b, 5))
    assert len(moves) == 6 * 8
    assert {truth.relation(row.a, translated(row.b, move)) for move in moves} == {sv.Relation.TOUCHING}


def test_what_is_wrong_has_one_colour_and_each_way_a_hatch_of_its_own():
    looks = [LOOKS[name] for name in ("false_hits", "missed_hits", "numbers")]
    assert {role for role, _, _ in looks} == {"wrong"} != {LOOKS["hits"][0]}
    assert len({hatch for _, _, hatch in looks} | {""}) == 4


AREA_OF = {FALSE: "false_hits", MISSED: "missed_hits", SHORT: "numbers", LONG: "numbers", FAR: "numbers"}
BY_AREA = [name for name in METHODS if name not in (*slides.ALONG_CONTACT, slides.ON_PAPER)]


@pytest.mark.parametrize("name", BY_AREA)
def test_every_position_lies_in_the_area_that_its_run_belongs_to(name):
    """Two roads to one map: the areas come from edges of A - B, the letters from a run of the shortcut each."""
    slide, row = small(name), NAMED[name]
    view = maps.limits(slide, row)
    (x0, y0, x1, y1), at = view, vertex_mean(row.b)
    found, near = error_region_in_view(*slides.both(row), row.shortcut, view), 1e-6 * max(x1 - x0, y1 - y0)

    def depth(ring, d):
        """How far inside a convex counter-clockwise ring; negative outside."""
        sides = zip(ring, (*ring[1:], ring[0]), strict=True)
        return min(((q.x - p.x) * (d.y - p.y) - (q.y - p.y) * (d.x - p.x)) / dist(p, q) for p, q in sides if p != q)

    for x, y, code in slide.positions():
        d = sv.Vec(x - at.x, y - at.y)
        for name in set(AREA_OF.values()):
            most = max((depth(ring, d) for ring in getattr(found, name)), default=-1.0)
            if AREA_OF.get(code) == name:
                assert most > -near, f"{code} at {d} lies outside of {name}"
            else:
                assert most < near, f"{code} at {d} lies inside of {name}"


def test_wrong_at_single_places_is_drawn_as_spots_and_along_the_contact_as_a_line():
    for name in METHODS:
        row = NAMED[name]
        found = error_region_in_view(*slides.both(row), row.shortcut, maps.limits(small(name), row))
        assert isinstance(found, str) == (name in ("unit-normals", "touch-on-paper"))
        assert isinstance(found, str) or found.touching == (name == "touch-as-apart")


def test_quick_maps_are_smaller_and_every_cell_is_done_by_name():
    quick, full = maps.cells(Settings(quick=True)), maps.cells(Settings())
    assert [cell.name for cell in quick] == [cell.name for cell in full] == [f"map-{name}" for name in METHODS]
    assert sum(cell.arguments[1] for cell in quick) < sum(cell.arguments[1] for cell in full)


def test_every_case_that_is_a_method_has_a_map_and_the_rest_are_named():
    """A number that is no push and no distance comes from no method for two shapes."""
    numbers = {case.name for case in FAILURE_CASES if case.how == WRONG_NUMBER and case.quantity != "gap"}
    about_no_method = numbers - {*slides.PUSHES, *slides.DISTANCES}
    rest = {case.name for case in FAILURE_CASES} - set(METHODS)
    assert rest == {case.name for case in FAILURE_CASES if case.how == REFUSED} | set(slides.OTHERS) | about_no_method


# -- the chart


def test_the_chart_of_all_maps_tells_every_count():
    (chart,) = charts()
    of = {line["name"]: line for line in chart.rows}
    assert list(of) == list(METHODS)
    for name in METHODS:
        assert small(name).told in chart.reading and of[name]["positions"] == small(name).counts.total()
    assert of["no-nearest-vertex"]["false hit"] == small("no-nearest-vertex").wrong > 0


def test_the_title_of_the_maps_counts_who_errs_to_a_hit():
    (chart,) = charts()
    mostly = sum(small(name).counts[FALSE] > small(name).counts[MISSED] for name in METHODS)
    assert chart.title.startswith(f"{mostly} of ")
