"""Shapes out of any text: the reader, the answer, the diagnosis, and what is sent on."""

import dataclasses
import json
import random
import re
import time
from decimal import Decimal, InvalidOperation
from fractions import Fraction
from math import cos, pi, sin

import oracle
import pytest
from pastes import PASTES
from reports import REPORTS

import satviz as sv
from satviz.cli import main
from satviz.scenes.minimal_test import LANGUAGES, minimal_test, scenes_json, wkt
from satviz.scenes.paste import others
from satviz.scenes.paste.exact import crossing
from satviz.scenes.paste.findings import KINDS
from satviz.scenes.paste.tokens import MAX_CHARS, number
from satviz.widgets.explorer_model import ExplorerModel

SQUARE = "POLYGON((0 0, 4 0, 4 4, 0 4))"


def kinds_of(pasted):
    return " ".join("circle" if r.read.is_circle else "polygon" if r.shape else "refused" for r in pasted.readings)


def found(pasted):
    return [finding.kind for finding in pasted.findings]


def points(text, as_=""):
    """Return the corners that were read, shape by shape."""
    return [[tuple(v) for v in each.vertices] for each in sv.paste(text, as_).readings]


# -- reports from public trackers


def test_there_are_forty_reports_in_ten_notations():
    assert len(REPORTS) >= 40 and len({r.notation for r in REPORTS}) >= 10
    assert len({r.thread for r in REPORTS}) == len(REPORTS)


@pytest.mark.parametrize("report", REPORTS, ids=lambda report: re.sub(r"\W+", "-", report.thread))
def test_a_report_is_read_answered_and_explained(report):
    pasted = sv.paste(report.text, report.as_)
    assert kinds_of(pasted) == report.kinds
    assert not pasted.open
    assert pasted.findings[0].kind == report.finding, pasted
    if report.relation is None:
        assert not pasted.traces
    else:
        (trace,) = pasted.traces
        assert str(trace.relation) == report.relation == str(oracle.relation(*pasted.shapes))
    if report.meant:
        assert str(pasted.pairs[0].trace.relation) == report.meant
        assert str(oracle.relation(pasted.pairs[0].trace.a, pasted.pairs[0].trace.b)) == report.meant
    if report.asks:
        assert report.asks in [question.what for question in pasted.questions]
    assert str(pasted)


# -- numbers


@pytest.mark.parametrize(
    "text, value",
    [
        ("1", 1),
        ("-0.1", Fraction(-1, 10)),
        ("\u22125", -5),
        (".5", Fraction(1, 2)),
        ("1.", 1),
        ("1_000.5", Fraction(2001, 2)),
        ("1'000", 1000),
        ("1e-3", Fraction(1, 1000)),
        ("2.5E+2", 250),
        ("0x1.8p+1", 3),
        ("0x1p-1074", Fraction(1, 2**1074)),
        ("0.1000000000000000055511151231257827", Fraction("0.1000000000000000055511151231257827")),
    ],
)
def test_a_number_keeps_every_digit(text, value):
    assert number(text) == (value, "")


@pytest.mark.parametrize("text", ["0xC1078533", "1e400", "1e999999999", "1" * 500, "1e-500"])
def test_a_number_that_float64_cannot_hold_has_a_reason(text):
    value, why = number(text)
    assert value is None and why


@pytest.mark.parametrize(
    "bad, why",
    [
        ("w/2", "not evaluated"),
        ("1 + 2", "not evaluated"),
        ("2 * 3", "not evaluated"),
        ("Math.sqrt(2)", "not evaluated"),
        ("width", "is a name, not a number"),
        ("NaN", "not a finite number"),
        ("float('inf')", "not a pair of numbers"),
        ("Infinity", "not a finite number"),
        ("1.2.3", "not a number"),
        ("5abc", "not a number"),
        ("0xFF", "hexadecimal"),
        ("1e400", "for float64"),
        ("0.5.sin()", "not evaluated"),
        ("0.04-", "not evaluated"),
        ("', 3'000", "not a number"),
    ],
)
def test_a_text_that_is_not_a_number_is_never_read_as_one(bad, why):
    with pytest.raises(sv.InvalidScene, match=why):
        sv.paste(f"[(0, 0), ({bad}, 1), (2, 2)]")


def test_no_code_in_a_pasted_text_is_run(tmp_path):
    mark = tmp_path / "mark"
    with pytest.raises(sv.InvalidScene):
        sv.paste(f"[(0, 0), (__import__('pathlib').Path({str(mark)!r}).touch(), 1), (2, 2)]")
    assert not mark.exists()


def test_a_duplicate_key_and_a_second_value_are_refused():
    for text in (
        '[{"x":1,"y":2,"y":3},{"x":4,"y":2},{"x":0,"y":9}]',
        '[{"x":1:5,"y":2},{"x":4,"y":2},{"x":0,"y":9}]',
        ('[{"x":9=2,"y":2},{"x":4,"y":2},{"x":0,"y":9}]'),
    ):
        with pytest.raises(sv.InvalidScene):
            sv.paste(text)


def test_a_number_beside_a_key_or_a_list_is_refused_or_asked_about():
    with pytest.raises(sv.InvalidScene):
        sv.paste('[{"x":1,5"y":2},{"x":4,"y":2},{"x":0,"y":9}]')
    assert sv.paste("Polygon([0,0, 1,0, 0,1], 5) circle((9, 9), 1)").open
    assert not sv.paste("Polygon([0,0, 1,0, 0,1], 0) circle((9, 9), 1)").open


def test_a_corner_without_numbers_is_refused_but_a_position_may_be_empty():
    with pytest.raises(sv.InvalidScene, match="item 1"):
        sv.paste("[new Vector(0, 0), new Vector(), new Vector(0, 3)]")
    assert sv.paste("new Circle(new Vector(), 5)").shapes == (sv.Circle((0, 0), 5),)


@pytest.mark.parametrize("text", ["LINESTRING (0 0, 4 0, 0 3)", "Point(0, 0).buffer(1)"])
def test_an_outline_that_is_not_a_polygon_is_refused(text):
    with pytest.raises(sv.InvalidScene, match=r"not a polygon|not evaluated"):
        sv.paste(text)


def test_a_name_that_occurs_in_its_own_value_is_refused_without_an_endless_loop():
    for text in ("a = [a, a, a]", "p.v[0] = (1, p); p.v[1] = (p, 2); p.v[2] = p", "a = b\nb = a\nPolygon(a)"):
        with pytest.raises(sv.InvalidScene):
            sv.paste(text)


def test_an_odd_list_and_a_list_of_threes_are_refused():
    with pytest.raises(sv.InvalidScene, match="7 numbers"):
        sv.paste("[0, 0, 1, 0, 1, 1, 5]")
    with pytest.raises(sv.InvalidScene, match="two dimensions"):
        sv.paste("[[0, 0, 1], [1, 0, 1], [1, 1, 1]]")


def test_a_polygon_with_holes_is_refused():
    with pytest.raises(sv.InvalidScene, match="holes"):
        sv.paste("POLYGON((0 0, 9 0, 9 9, 0 9), (1 1, 2 1, 2 2))")


# -- notations

TRIANGLE = [(0.0, 0.0), (4.0, 0.0), (0.0, 3.0)]


@pytest.mark.parametrize(
    "text",
    [
        "POLYGON((0 0, 4 0, 0 3))",
        "POLYGON Z ((0 0 9, 4 0 9, 0 3 9))".replace(" 9", ""),
        "[[0, 0], [4, 0], [0, 3]]",
        "[0, 0, 4, 0, 0, 3]",
        "((0, 0), (4, 0), (0, 3))",
        '[{"x": 0, "y": 0}, {"x": 4, "y": 0}, {"x": 0, "y": 3}]',
        "[{x: 0, y: 0}, {x: 4, y: 0}, {x: 0, y: 3}]",
        '{"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [0, 3]]]}',
        "new float[]{0f, 0f, 4f, 0f, 0f, 3f}",
        "double[][] a = { {0, 0}, {4, 0}, {0, 3} };",
        "Vec2 a[] = { {.x = 0, .y = 0}, {.x = 4, .y = 0}, {.x = 0, .y = 3} };",
        "v[0] = c2V(0, 0); v[1] = c2V(4, 0); v[2] = c2V(0, 3);",
        "v[0].x = 0; v[0].y = 0; v[1].x = 4; v[1].y = 0; v[2].x = 0; v[2].y = 3;",
        "b2Vec2 v[3]; v[0].Set(0, 0); v[1].Set(4, 0); v[2].Set(0, 3);",
        "new SAT.Polygon(new SAT.Vector(), [new SAT.Vector(0, 0), new SAT.Vector(4, 0), new SAT.Vector(0, 3)])",
        "new Vector2[] { new Vector2(0, 0), new Vector2(4f, 0f), new Vector2(0, 3) }",
        "vec![Point::new(0.0, 0.0), Point::new(4.0_f64, 0.0), Point::new(0.0, 3.0)]",
        "vec![(0.0, 0.0), (4.0, 0.0), (0.0, 3.0)]",
        "List(Point(0, 0), Point(4, 0), Point(0, 3))",
        "PackedVector2Array([Vector2(0, 0), Vector2(4, 0), Vector2(0, 3)])",
        "np.array([[0, 0], [4, 0], [0, 3]])",
        "[[0. 0.]\n [4. 0.]\n [0. 3.]]",
        "np.array([0, 0, 4, 0, 0, 3]).reshape(-1, 2)",
        "0 0\n4 0\n0 3\n",
        "0, 0\n4, 0\n0, 3\n",
        "(0, 0)(4, 0)(0, 3)",
        '<polygon points="0,0 4,0 0,3"/>',
        ">>> a = [(0, 0), (4, 0), (0, 3)]",
        "In [1]: Polygon([(0, 0),\n   ...: (4, 0), (0, 3)])",
        "a = [(0, 0), # first\n (4, 0), (0, 3)]",
        "Polygon(points=[(0, 0), (4, 0), (0, 3)])",
        "sv.Polygon([(0, 0), (4, 0), (0, 3)])",
        '[{"x": "0", "y": "0"}, {"x": "4", "y": "0"}, {"x": "0", "y": "3"}]',
        "[[[0, 0]], [[4, 0]], [[0, 3]]]",
        "SRID=4326;POLYGON((0 0, 4 0, 0 3))",
        "SELECT ST_Intersects(ST_GeomFromText('POLYGON((0 0, 4 0, 0 3))'), g)",
        "GEOMETRYCOLLECTION(POINT(9 9), POLYGON((0 0, 4 0, 0 3)))",
        "Polygon::new(LineString::from(vec![(0.0, 0.0), (4.0, 0.0), (0.0, 3.0)]), vec![])",
        "[Point(x=0, y=0), Point(x=4, y=0), Point(x=0, y=3)]",
        "val a = listOf(Point(0.0, 0.0), Point(4.0, 0.0), Point(0.0, 3.0))",
        "{(0|0), (4|0), (0|3)}".replace("|", ", "),
    ],
)
def test_one_triangle_is_read_alike_in_many_notations(text):
    assert points(text) == [TRIANGLE]


@pytest.mark.parametrize(
    "text, center, radius",
    [
        ("new SAT.Circle(new SAT.Vector(1, -70), 5)", (1, -70), 5),
        ("circle((1, 2), 3)", (1, 2), 3),
        ("Circle(1, 2, 3)", (1, 2), 3),
        ('{"x": 1, "y": 2, "radius": 3}', (1, 2), 3),
        ('{"circle": [1, 2], "radius": 3}', (1, 2), 3),
        ("c.p = c2V(1, 2);\nc.r = 3.0f;", (1, 2), 3),
        ("Circle(center=(1, 2), radius=3)", (1, 2), 3),
        ("b.position = 1, 2\ns = pymunk.Circle(b, 3)", (1, 2), 3),
        ("contact(&Isometry::translation(1.0, 2.0), &Ball::new(3.0))", (1, 2), 3),
        ("((1, 2), 3)", (1, 2), 3),
        ("CURVEPOLYGON (CIRCULARSTRING (-2 2, 4 2, -2 2))", (1, 2), 3),
    ],
)
def test_circles_are_read(text, center, radius):
    (shape,) = sv.paste(text).shapes
    assert shape == sv.Circle(center, radius)


@pytest.mark.parametrize(
    "text, as_, box",
    [
        ("Rectangle(1, 2, 3, 4)", "", (1, 2, 4, 6)),
        ("[1, 2, 3, 4]", "corner-size", (1, 2, 4, 6)),
        ("[1, 2, 3, 4]", "corner-corner", (1, 2, 3, 4)),
        ("[1, 2, 3, 4]", "center-size", (-0.5, 0, 2.5, 4)),
        ("[1, 2, 3, 4]", "center-half", (-2, -2, 4, 6)),
        ("[1, 2, 3, 4]", "corner-size height-first", (1, 2, 5, 5)),
        ("{min: {x: 1, y: 2}, max: {x: 3, y: 4}}", "", (1, 2, 3, 4)),
        ("{left: 1, top: 2, right: 3, bottom: 4}", "", (1, 2, 3, 4)),
        ("{x: 1, y: 2, width: 3, height: 4}", "corner-size", (1, 2, 4, 6)),
        ("{x: 1, y: 2, width: 3, height: 4}", "center-size", (-0.5, 0, 2.5, 4)),
        ("{center: [1, 2], size: [3, 4]}", "", (-0.5, 0, 2.5, 4)),
        ("{center: [1, 2], half_extents: [3, 4]}", "", (-2, -2, 4, 6)),
        ("Bodies.rectangle(1, 2, 3, 4)", "", (-0.5, 0, 2.5, 4)),
        ("shapely.box(1, 2, 3, 4)", "", (1, 2, 3, 4)),
        ("pygame.Rect((1, 2), (3, 4))", "", (1, 2, 4, 6)),
        ("((1, 2), (4, 4), 90)", "degrees", (-1, 0, 3, 4)),
    ],
)
def test_boxes_are_read_in_each_form(text, as_, box):
    (shape,) = sv.paste(text, as_).shapes
    assert shape.bounds == box and shape.is_upright_box


def test_a_box_is_turned_in_degrees_or_radians_and_the_other_way_with_y_down():
    text = "((0, 0), (4, 2), 30)"
    (up,) = sv.paste(text, "degrees y-up").shapes
    (down,) = sv.paste(text, "degrees, y-down").shapes
    assert up.vertices[0] == pytest.approx((-2 * cos(pi / 6) + sin(pi / 6), -2 * sin(pi / 6) - cos(pi / 6)))
    assert sorted((x, -y) for x, y in up.vertices) == [pytest.approx(v) for v in sorted(down.vertices)]
    (turned,) = sv.paste("((0, 0), (4, 2), 0.5)", "radians").shapes
    assert turned.vertices[0] == pytest.approx((-2 * cos(0.5) + sin(0.5), -2 * sin(0.5) - cos(0.5)))


def test_a_polygon_is_moved_and_turned_by_its_position_and_angle():
    text = '{"position": [10, 0], "angle": 90, "vertices": [[0, 0], [2, 0], [0, 1]]}'
    (shape,) = sv.paste(text, "degrees relative").shapes
    assert shape.vertices == ((10, 0), (10, 2), (9, 0))
    asked = [question.what for question in sv.paste(text.replace("90", "1.5")).questions]
    assert asked == ["corners", "angle"]


def test_a_variable_is_read_once_and_by_the_value_it_had():
    text = "pts = [(0,0),(1,0),(0,1)]\np = Polygon(pts)\npts = [(5,5),(6,5),(5,6)]\nq = Polygon(pts)"
    assert points(text) == [[(0, 0), (1, 0), (0, 1)], [(5, 5), (6, 5), (5, 6)]]
    assert len(points("a = Polygon([(0,0),(1,0),(0,1)])\na = Polygon(a)")) == 1
    assert len(points("a = Polygon(b)\nb = Polygon(a)\nc = circle((0, 0), 1)")) == 1


def test_a_chained_change_of_a_shape_is_applied_or_refused():
    assert points("Polygon([(0,0),(1,0),(0,1)]).translate(2, 3)") == [[(2, 3), (3, 3), (2, 4)]]
    with pytest.raises(sv.InvalidScene, match="scale"):
        sv.paste("Polygon([(0,0),(1,0),(0,1)]).scale(2, 3)")


def test_each_shape_says_how_and_from_what_it_was_read():
    pasted = sv.paste("a = circle((0, 0), 1)\nb = [(2, 0), (3, 0), (2, 1)]")
    a, b = pasted.readings
    assert (a.title, a.said, a.excerpt) == ("A (a)", "a circle by its center and radius", "circle((0, 0), 1)")
    assert (b.title, b.said, b.excerpt) == ("B (b)", "a polygon of 3 corners", "[(2, 0), (3, 0), (2, 1)]")
    assert pasted.text[b.read.start : b.read.end] == b.excerpt


def test_python_objects_are_read():
    shapely, numpy = pytest.importorskip("shapely"), pytest.importorskip("numpy")
    array = numpy.array([[0, 0], [4, 0], [0, 3]])
    assert points([array, shapely.box(5, 5, 6, 6)])[0] == TRIANGLE
    assert points([[0, 0], [4, 0], [0, 3]]) == [TRIANGLE]
    assert sv.paste([sv.Circle((0.1, 0.2), 0.3), sv.Polygon(TRIANGLE)]).shapes == (
        sv.Circle((0.1, 0.2), 0.3),
        sv.Polygon(TRIANGLE),
    )
    pymunk = pytest.importorskip("pymunk")
    body = pymunk.Body(1, 1)
    body.position = 3, 4
    assert sv.paste([pymunk.Circle(body, 2, (1, 0)), pymunk.Poly(body, TRIANGLE)]).shapes == (
        sv.Circle((4, 4), 2),
        sv.Polygon([(3, 4), (7, 4), (3, 7)]),
    ) or sv.paste([pymunk.Poly(body, TRIANGLE)]).shapes[0].bounds == (3, 4, 7, 7)
    with pytest.raises(sv.InvalidScene):
        sv.paste([object()])


# -- questions


def test_two_readings_with_different_answers_give_a_question_and_none_is_chosen():
    text = "new Box({ x: 115, y: 152 }, 100, 100); new Circle({ x: 100, y: 100 }, 50)"
    pasted = sv.paste(text)
    (question,) = pasted.questions
    assert question.matters and pasted.open and pasted.shapes == () and pasted.traces == ()
    assert [(a.choice, a.gives) for a in question.answers] == [("corner-size", "apart"), ("center-size", "overlapping")]
    for answer in question.answers:
        chosen = sv.paste(text, answer.choice)
        assert not chosen.questions and str(chosen.traces[0].relation) == answer.gives
    assert "--as center-size" in str(pasted)


def test_two_readings_with_one_answer_are_both_named():
    pasted = sv.paste("[0, 0, 10, 10]\n[1, 1, 11, 11]")
    (question,) = pasted.questions
    assert not question.matters and len(pasted.shapes) == 2 and "corner-size was taken" in str(pasted)


def test_the_unit_of_an_unclear_angle_gives_a_question():
    pasted = sv.paste("((0, 0), (10, 1), 1.5)\ncircle((0, 5), 1)")
    assert [q.what for q in pasted.questions if q.matters] == ["angle"]


def test_the_form_of_a_box_that_may_be_no_shape_is_asked_once_it_is_one():
    text = "poly A: (0,0) (4,0) (0,4)\nEdit: with (0, 0, 5, 5)\npoly B: (1,1) (5,1) (1,5)"
    asked = sv.paste(text)
    assert [q.what for q in asked.questions] == ["rest"] and "Choose which it is" in asked.sentence
    assert [q.what for q in sv.paste(text, "take-in").questions] == ["box"]
    assert not sv.paste(text, "leave-out").questions


def test_an_angle_of_more_than_a_turn_is_in_degrees_and_the_reading_says_so():
    pasted = sv.paste("((0, 0), (10, 1), -177.8)\ncircle((0, 5), 1)")
    assert not pasted.questions and pasted.readings[0].said.endswith("turned by -177.8 degrees")
    assert sv.paste("((0, 0), (10, 1), -177.8)", "radians").readings[0].said.endswith("radians")


def test_a_reading_that_makes_no_shapes_is_named_but_decides_nothing():
    pasted = sv.paste("Rect((0.1, 0), (10, 10))\nRect((10, 0), (10, 10))")
    (question,) = pasted.questions
    assert "refused" in question.answers[1].gives and not question.matters and not pasted.open


def test_an_unknown_reading_is_refused():
    with pytest.raises(sv.InvalidScene, match="center-size"):
        sv.paste(SQUARE, "center-sise")


# -- the diagnosis, each kind with a pair that has it and one that has not


@pytest.mark.parametrize(
    "kind, has, has_not",
    [
        ("touching", f"{SQUARE} POLYGON((4 0, 8 0, 8 4))", f"{SQUARE} POLYGON((3.999 0, 8 0, 8 4))"),
        ("no-position", f"Ball::new(2) {SQUARE}", f"circle((0, 0), 2) {SQUARE}"),
        ("no-position", f"Cuboid::new(2, 1) {SQUARE}", f"Rectangle(0, 0, 2, 1) {SQUARE}"),
        ("clockwise", f"{SQUARE} POLYGON((5 0, 5 1, 6 0))", f"{SQUARE} POLYGON((5 0, 6 0, 5 1))"),
        ("crossing-outline", "[0,0, 4,4, 4,0, 0,4]", "[0,0, 4,0, 4,4, 0,4]"),
        ("concave", "[0,0, 9,0, 9,9, 8,9, 8,1, 0,1]\n[3,3, 4,3, 4,4]", "[0,0, 9,0, 9,9]\n[3,6, 4,6, 4,7]"),
        ("repeated-corner", "[0,0, 4,0, 4,0, 4,4]\n[5,5, 6,5, 6,6]", "[0,0, 4,0, 4,1, 4,4]\n[5,5, 6,5, 6,6]"),
        ("collinear-corner", "[0,0, 4,0, 4,1, 4,4]\n[5,5, 6,5, 6,6]", "[0,0, 4,0, 4,4]\n[5,5, 6,5, 6,6]"),
        ("zero-area", "[0,0, 1,1, 2,2]\n[5,5, 6,5, 6,6]", "[0,0, 1,1, 2,3]\n[5,5, 6,5, 6,6]"),
        ("containment", f"{SQUARE} circle((2, 2), 2)", f"{SQUARE} circle((2, 2), 2.0001)"),
        (
            "negative-size",
            "Rectangle(5, 5, -2, 2) Rectangle(0, 0, 1, 1)",
            "Rectangle(5, 5, 2, 2) Rectangle(0, 0, 1, 1)",
        ),
        ("negative-size", "circle((0, 0), -1) circle((0, 0), 1)", "circle((0, 0), 1) circle((0, 0), 1)"),
        (
            "whole-numbers",
            "Rectangle(0.9, 0, 9, 9) Rectangle(9.8, 0, 9, 9)",
            "Rectangle(0, 0, 9, 9) Rectangle(8, 0, 9, 9)",
        ),
        (
            "float32",
            "[0,0, 16777219,0, 0,9]\n[16777219.5,0, 16777230,0, 16777219.5,9]",
            "[0,0, 16777216,0, 0,9]\n[16777220,0, 16777230,0, 16777220,9]",
        ),
        ("near-touch", "circle((0, 0), 1) circle((2.0000001, 0), 1)", "circle((0, 0), 1) circle((2.1, 0), 1)"),
        ("decimals", "circle((0, 0), 0.1) circle((0.3, 0), 0.2)", "circle((0, 0), 1) circle((3, 0), 2)"),
        (
            "corner-for-center",
            "Rectangle(0, 0, 4, 4) circle((-1, -1), 1)",
            "Rectangle(0, 0, 4, 4) circle((9, 9), 1)",
        ),
        (
            "corner-for-center",
            "Rectangle(10, 10, 20, 20) Rectangle(25, 15, 29, 25)",
            "Rectangle(10, 10, 20, 20) Rectangle(15, 15, 29, 25)",
        ),
        (
            "swapped-arguments",
            "[(48.1, 2.1), (48.3, 2.1), (48.2, 2.3)]\n[(2.1, 48.1), (2.3, 48.1), (2.2, 48.3)]",
            "[(48.1, 2.1), (48.3, 2.1), (48.2, 2.3)]\n[(9.1, 48.1), (9.3, 48.1), (9.2, 48.3)]",
        ),
        (
            "closed-outline",
            "POLYGON((0 0, 1 0, 0 1, 0 0)) circle((9, 9), 1)",
            "POLYGON((0 0, 1 0, 0 1)) circle((9, 9), 1)",
        ),
        (
            "position-twice",
            "new Polygon(new V(5, 5), [new V(5, 5), new V(6, 5), new V(5, 6)]); circle((5, 5), 1)",
            "new Polygon(new V(5, 5), [new V(0, 0), new V(1, 0), new V(0, 1)]); circle((5, 5), 1)",
        ),
        ("clear", f"{SQUARE} circle((9, 9), 1)", f"{SQUARE} circle((2, 2), 1)"),
    ],
)
def test_a_finding_is_there_exactly_where_it_holds(kind, has, has_not):
    assert kind in KINDS
    assert kind in found(sv.paste(has))
    assert kind not in found(sv.paste(has_not))


def test_rounded_decimals_are_reported_only_where_the_verdict_differs():
    """0.1 + 0.2 is 0.3 in decimals, and larger than 0.3 in float64."""
    for scale in range(1, 60):
        a, b, c = (Decimal(scale) * Decimal(v) / 10 for v in ("1", "2", "3"))
        line = f"[0,0, {a},0, 0,1]\n[{a},0, {c},0, {c},1]\n"
        assert "decimals" not in found(sv.paste(line)), "a shared decimal is rounded the same way for both"
        circles = f"circle((0, 0), {a}) circle(({c}, 0), {b})"
        decimals = sv.paste(circles)
        told = decimals.traces[0].relation
        assert ("decimals" in found(decimals)) == (told is not sv.Relation.TOUCHING), circles
    assert "decimals" in found(sv.paste("circle((0, 0), 0.1) circle((0.3, 0), 0.2)"))
    assert "decimals" not in found(sv.paste([sv.Circle((0, 0), 0.1), sv.Circle((0.3, 0), 0.2)]))


def test_a_crossing_outline_is_shown_with_its_crossing_and_the_order_that_was_meant():
    pasted = sv.paste(f"[0,0, 4,4, 4,0, 0,4]\n{SQUARE}")
    (bad, _) = pasted.readings
    assert bad.shape is None and bad.meant == sv.Polygon([(0, 0), (4, 0), (4, 4), (0, 4)])
    assert "its edges a1a2 and a3a4 cross at (2, 2)" in pasted.findings[0].text and "Z order" in pasted.findings[0].text
    assert "(0, 0), (4, 0), (4, 4), (0, 4)" in pasted.findings[0].help
    assert pasted.pairs[0].trace.relation is sv.Relation.OVERLAPPING and pasted.traces == ()
    dented = sv.paste("[0,0, 4,4, 4,0, 0,4, 2,3]").readings[0]
    assert dented.shape is None and dented.meant is None, "one corner is inside the hull: no convex order holds all"


BOX = "box = [(-2, -1), (2, -1), (2, 1), (-2, 1)]"


@pytest.mark.parametrize(
    ("text", "asked", "said"),
    [
        (f"let at = Isometry2::new(Vector2::new(1.2, 0.8), 7); {BOX}", True, "Isometry2::new 1.2, 0.8, 7"),
        (f"a = {{x: 1, y: 1, radius: 5, scale: 2}}; {BOX}", True, "a.scale 2"),
        (f"a = {{x: 1, y: 1, radius: 5, anchor: {{x: 0.5, y: 0}}}}; {BOX}", True, "a.anchor 0.5, 0"),
        (f"bodyDef.position.Set(0.0f, 10.0f); {BOX}", True, "bodyDef.position.Set 0.0f, 10.0f"),
        (f"prismRect(1, 2, 3); {BOX}", True, "prismRect 1, 2, 3"),
        (f"a = {{x: 1, y: 1, radius: 5, scale: 1}}; {BOX}", False, "a.scale 1"),
        (f"a = {{x: 1, y: 1, radius: 5, density: 2, id: 7}}; {BOX}", False, "a.density 2, a.id 7"),
        (f"world.gravity = (0, -10); {BOX}", False, "world.gravity 0, -10"),
        (f"c = {{x: 9, y: 9, r: 1}}; {BOX}", False, ""),
        (f"b2Vec2 v[3]; poly.count = 4; {BOX}", False, "poly.count 4"),
    ],
)
def test_numbers_that_belong_to_no_shape_are_reported_with_their_key(text, asked, said):
    pasted = sv.paste(text)
    lines = [f.text for f in pasted.findings if f.kind == "left-out"]
    if asked:
        (question,) = pasted.questions
        lines = [question.asks]
        assert pasted.open and [answer.choice for answer in question.answers] == ["leave-out"]
        assert said in str(sv.paste(text, "leave-out")) and not sv.paste(text, "leave-out").open
    assert [line.partition(": ")[2].rstrip(".") for line in lines] == ([said] if said else [])


def test_all_pairs_that_meet_are_counted_also_where_not_all_are_shown():
    boxes = "\n".join(f"box({i * 0.5}, 0, 10, 10)" for i in range(12))
    said = sv.paste(boxes, as_="corner-size").sentence
    assert said.startswith("66 of 66 pairs meet; 60 of them are shown."), said


def test_of_concave_outlines_with_many_parts_only_the_deepest_pairs_are_computed(monkeypatch):
    comb = [(0, 9), *((x, x % 2) for x in range(12)), (11, 9)]
    text = "\n".join(str([(x + 3 * k, y) for x, y in comb]) for k in (2, 1, 0, 3))
    assert len(sv.paste(text).pairs) == 6
    monkeypatch.setattr("satviz.scenes.paste.pasted.MAX_PART_PAIRS", 120)
    pasted = sv.paste(text)
    assert pasted.sentence.startswith("6 of 6 pairs meet; 3 of them are shown.")
    assert {pair.a.name + pair.b.name for pair in pasted.pairs} == {"AB", "BC", "AD"}


def test_several_shapes_give_every_pair_that_meets_the_deepest_first():
    text = "circle((0,0),2) circle((3,0),2) circle((5,0),2) circle((50,0),2)"
    pasted = sv.paste(text)
    assert [(p.a.name, p.b.name) for p in pasted.pairs] == [("B", "C"), ("A", "B")]
    assert pasted.pairs[0].gap == -2 and pasted.pairs[1].gap == -1
    assert pasted.traces[0].sentence.startswith("B and C overlap")
    assert pasted.sentence.startswith("2 of 6 pairs meet.")
    apart = sv.paste("circle((0,0),1) circle((9,0),1) circle((5,0),1)")
    assert [(p.a.name, p.b.name) for p in apart.pairs] == [("A", "C")] or apart.pairs[0].gap == 2


# -- what other definitions say


@pytest.mark.parametrize(
    "b, answers",
    [
        (
            "circle((9, 2), 1)",
            {"closed": "no hit", "open": "no hit", "OGC intersects": "false", "OGC touches": "false"},
        ),
        ("circle((5, 2), 1)", {"closed": "hit", "open": "no hit", "OGC touches": "true", "OGC overlaps": "false"}),
        ("circle((4, 2), 1)", {"open": "hit", "OGC overlaps": "true", "OGC contains": "false", "OGC within": "false"}),
        ("circle((2, 2), 1)", {"open": "hit", "OGC overlaps": "false", "OGC contains": "true", "OGC within": "false"}),
        ("circle((2, 2), 9)", {"open": "hit", "OGC overlaps": "false", "OGC contains": "false", "OGC within": "true"}),
        (SQUARE, {"OGC overlaps": "false", "OGC contains": "true", "OGC within": "true", "OGC equals": "true"}),
        ("circle((5.0000000001, 2), 1)", {"a tolerance of 1e-09": "touching", "float32": "touching instead of apart"}),
        ("circle((5.9, 2), 1)", {"whole": "touching instead of apart"}),
    ],
)
def test_other_definitions_have_their_own_answer(b, answers):
    views = sv.paste(f"{SQUARE} {b}").others()
    for name, answer in answers.items():
        (view,) = [v for v in views if v.definition.startswith(name)]
        assert view.answer == answer, view


def test_ogc_touches_says_why_it_is_false():
    whys = [
        next(v.why for v in sv.paste(f"{SQUARE} {b}").others() if "touches" in v.definition)
        for b in ("circle((9, 2), 1)", "circle((5, 2), 1)", "circle((4, 2), 1)")
    ]
    assert whys == [
        "they share no point",
        "they share border points, but no interior point",
        "they share interior points",
    ]


def test_the_words_of_ogc_agree_with_shapely():
    shapely = pytest.importorskip("shapely")
    rng = random.Random(1)
    for _ in range(150):
        shapes = []
        for _ in range(2):
            n = rng.choice((3, 4, 6))
            ring = [(rng.randint(0, 4), rng.randint(0, 4)) for _ in range(n)]
            if shapely.Polygon(ring).is_valid and shapely.Polygon(ring).area:
                shapes.append(ring)
        if len(shapes) < 2:
            continue
        p, q = (sv.Polygon(ring) for ring in shapes)
        a, b = (shapely.Polygon(ring) for ring in shapes)
        lies = others.lie(p, q)
        assert lies.relation is sv.relate(p, q) is oracle.relation(p, q)
        assert (bool(lies.a_in_b), bool(lies.b_in_a)) == (a.within(b), a.contains(b)), (shapes, lies)
        answers = {v.definition: v.answer for v in others.views(p, q, lies, 0.0)}
        assert answers["OGC touches"] == str(a.touches(b)).lower()
        overlaps = next(v for k, v in answers.items() if k.startswith("OGC overlaps"))
        assert overlaps == str(a.overlaps(b)).lower()


# -- bad input


@pytest.mark.parametrize(
    "text",
    [
        "",
        " \n ",
        "no shape at all",
        "<html><body><script>alert(1)</script></body></html>",
        "\u05de\u05e8\u05d5\u05d1\u05e2 \u202e abc",
        "[" * 5000 + "1" + "]" * 5000,
        "(" * 300_000,
        pytest.param("'a " * 200_000, marks=pytest.mark.slow),
        "[1,2]," * 150_000,
        "[1,2]," * (MAX_CHARS // 4),
        "1" * 900_000,
        pytest.param("a<" * 300_000, marks=pytest.mark.slow),
        pytest.param("/*" * 300_000, marks=pytest.mark.slow),
        pytest.param(
            str([(cos(2 * pi * i / 10_000), sin(2 * pi * i / 10_000)) for i in range(10_000)]), marks=pytest.mark.slow
        ),
        "\n".join(f"circle(({i}, 0), 1)" for i in range(100)),
        "[(0, 0), (NaN, 0), (0, 1)]",
    ],
    ids=range(16),
)
def test_bad_input_gets_one_clear_line_in_linear_time(text):
    start = time.process_time()
    with pytest.raises(sv.InvalidScene) as error:
        sv.paste(text)
    assert time.process_time() - start < 20  # a slow machine takes three; quadratic time would be minutes
    line = str(error.value)
    assert line and "\n" not in line and len(line) < 400


def test_one_shape_is_read_and_the_answer_asks_for_a_second():
    pasted = sv.paste("[0,0, 4,4, 4,0, 0,4]")
    assert "paste a second one" in pasted.sentence and found(pasted) == ["crossing-outline"]
    assert pasted.traces == () and pasted.pairs == ()


def test_pasted_markup_is_shown_as_text():
    pasted = sv.paste('<b onclick="x()">a</b> = [(0,0),(1,0),(0,1)]\n<i>b</i> = circle((5,5),1)')
    scene = pasted.scene()
    assert "<b" not in scene.name and json.loads(scene.to_json())["name"] == "pasted"
    for language in LANGUAGES:
        assert "onclick" not in pasted.test(language)


def test_a_text_that_is_cut_off_gives_a_finding():
    assert any("never closed" in str(f) for f in sv.paste(f"{SQUARE} [(0,0),(1,0),(0,1)").findings)


def test_shapes_of_three_dimensions_are_told_nothing_clear():
    text = "a = Polygon(P(0, 0, {}), P(4, 0, 1), P(0, 4, 1))\nb = Polygon(P(9, 9, 1), P(8, 9, 1), P(9, 8, 1))"
    assert found(sv.paste(text.format(1)))[0] == "clear" and "clear" not in found(sv.paste(text.format(5)))


# -- a fuzz of the reader

ALPHABET = "()[]{},;:=.-+*/ \n'\"`0123456789eExXfnaN_#<>!&|\\\u2212\u0663\u00b2"
NUMERAL = re.compile(r"(?:[0-9][0-9_]*(?:'[0-9]{3})*\.?[0-9_]*|\.[0-9][0-9_]*)(?:[eEdD][+-]?[0-9]{1,4})?")


TEXTS = (*REPORTS, *PASTES)


def mutated(text, rng):
    """Return the text with some letters removed, inserted or doubled."""
    letters = list(text)
    for _ in range(rng.choice((1, 1, 2, 3, 8))):
        i, j = sorted((rng.randrange(len(letters) + 1), rng.randrange(len(letters) + 1)))
        chance = rng.random()
        if chance < 0.35:
            del letters[i : i + 1]
        elif chance < 0.7:
            letters.insert(i, rng.choice(ALPHABET))
        elif chance < 0.85:
            letters[i : i + 1] = rng.choice(ALPHABET)
        elif chance < 0.93:
            del letters[i : min(j, i + 30)]
        else:
            letters[i:i] = letters[i : min(j, i + 30)]
    return "".join(letters)


def numerals(text):
    """Return the absolute values of all numbers in a text, in order, found without the tokenizer."""
    values = []
    for match in NUMERAL.finditer(text.replace("\u2212", "-")):
        try:
            value = Fraction(Decimal(re.sub("[dD]", "e", match[0].replace("_", "").replace("'", ""))))
        except InvalidOperation:
            continue
        values.append(value)
    return values


def stands_in_order(sizes, numbers):
    """Return whether the sizes occur in the numbers in this order, perhaps with others between them."""
    rest = iter(numbers)
    return all(size in rest for size in sizes)


def fuzz(count, seed):
    """Read mutated reports: no exception but InvalidScene, and no number that does not stand in the text."""
    rng = random.Random(seed)
    read = 0
    for _ in range(count):
        report = rng.choice(TEXTS)
        text = mutated(report.text, rng)
        try:
            pasted = sv.paste(text)
        except sv.InvalidScene as error:
            assert "\n" not in str(error)
            continue
        known = numerals(text)
        for each in pasted.readings:
            one = each.read
            if one.rounded or re.search("turned|position|two points|diameter|transformed", one.said):
                continue  # sums of numbers
            if any(word in each.excerpt for word in ("body", "offset")):
                continue  # at the place of a body
            numbers = one.box or [c for p in one.points for c in p]
            numbers = [*numbers, *([] if one.radius is None else [one.radius])]
            sizes = [abs(n) for n in numbers]
            if "0x" in text or re.search(r"path|\bd=|^m ", report.text, re.IGNORECASE | re.MULTILINE):
                continue
            assert set(known) | {0} >= set(sizes), (text, each.excerpt)
            if (
                report in REPORTS
                and not one.box
                and one.radius is None
                and "verts[" not in text
                and ".Set(" not in text
            ):
                assert stands_in_order(sizes, known), (text, each.excerpt)
        read += 1
    assert read > count / 4


def test_mutated_texts_give_no_exception_and_no_invented_number():
    fuzz(150, seed=3)


@pytest.mark.slow
def test_four_thousand_mutated_texts_give_no_exception_and_no_invented_number():
    fuzz(4000, seed=4)


@pytest.mark.full
@pytest.mark.parametrize("piece", range(200))
def test_two_hundred_thousand_mutated_texts_give_no_exception_and_no_invented_number(piece):
    fuzz(1000, seed=10_000 + piece)  # a piece of its own, so that a run can go on where it ended


# -- sending it on


def test_a_link_and_a_scene_file_open_the_same_pair():
    from satviz.scenes.link import parse_fragment

    pasted = sv.paste(f"{SQUARE} circle((5, 2), 1)")
    opened, _ = parse_fragment(pasted.link(site="https://example.org/s").split("#")[1])
    assert (opened.a, opened.b) == pasted.shapes
    assert sv.Scene.from_json(pasted.scene().to_json()).record().relation is sv.Relation.TOUCHING


def test_wkt_and_json_are_read_again():
    shapes = (sv.Circle((0.1, 1e-7), 0.3), sv.Polygon([(0, 0), (4.25, 1e22), (-3, 0.1)]))
    text = "\n".join(map(wkt, shapes))
    pasted = sv.paste(text)
    assert [getattr(s, "corners", s) for s in pasted.shapes] == [getattr(s, "corners", s) for s in shapes]
    assert pasted.wkt == text
    data = json.loads(pasted.to_json())
    assert data["pairs"][0]["relation"] == str(oracle.relation(*shapes))
    assert sv.paste(sv.Scene("s", *shapes).to_json()).shapes == shapes


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_minimal_test_holds_the_numbers_and_the_relation(language):
    a, b = sv.Circle((0.1, -2), 0.30000000000000004), sv.Polygon([(0, 0), (1e22, 0), (0, 1e-7)])
    text = minimal_test(a, b, language)
    for value in ("0.1", "-2.0", "0.30000000000000004", "1e+22", "1e-07"):
        assert value in text
    assert f'"{sv.relate(a, b)}"' in text and text.isascii()
    with pytest.raises(sv.InvalidScene, match="cobol"):
        minimal_test(a, b, "cobol")


def test_every_built_in_scene_is_listed_with_its_exact_answer():
    data = json.loads(scenes_json())
    assert [s["name"] for s in data["scenes"]] == [*sv.scene.__globals__["names"]()]
    for scene in data["scenes"]:
        if scene["relation"] is None:
            assert scene["refused"]
            with pytest.raises(sv.InvalidShape):
                [sv.Polygon(scene[key]["polygon"]) for key in "ab"]
            continue
        a, b = sv.Scene.from_json(json.dumps({"satviz": "scene 1", "a": scene["a"], "b": scene["b"]})).record(), None
        assert str(oracle.relation(a.a, a.b)) == scene["relation"] and b is None
        assert scene["hit"] == (scene["relation"] != "apart")


# -- the command line


def test_explain_reads_a_file_and_standard_input(tmp_path, capsys, monkeypatch):
    path = tmp_path / "report.txt"
    path.write_text(f"\ufeff{SQUARE} circle((5, 2), 1)", encoding="utf-8")
    assert main(["explain", str(path)]) == 0
    out = capsys.readouterr().out
    assert "A and B touch" in out and "open boundary" in out and "Tests with <= say hit" in out
    for form in ("json", "scene", "wkt", "link", "svg", *LANGUAGES):
        assert main(["explain", str(path), "--to", form]) == 0
        assert capsys.readouterr().out
    import io

    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(b"[0,0,1,1] [2,0,1,1]")))
    assert main(["explain", "-", "--as", "corner-size", "--as", "width-first"]) == 0
    assert "apart" in capsys.readouterr().out


@pytest.mark.parametrize("way", ["name", "file", "link"])
def test_explain_takes_a_scene_in_each_way_in_which_the_other_commands_take_it(way, tmp_path, capsys):
    scene = sv.scene("triangles")
    path = tmp_path / "scene.json"
    path.write_text(scene.to_json())
    changed = dataclasses.replace(scene, name="mine")  # a link of a built-in scene has only its name
    links = [sv.link(each, site="https://example.org") for each in (scene, changed)]
    for given in {"name": ["triangles"], "file": [str(path)], "link": links}[way]:
        assert main(["explain", given]) == 0
        said = capsys.readouterr().out
        assert scene.record().sentence.split(":")[0] in said and "Left out" not in said


def test_explain_says_in_one_line_why_there_is_no_answer(tmp_path, capsys):
    path = tmp_path / "report.txt"
    for text, line in (
        ("nothing", "no shape was found"),
        (SQUARE, "paste a second one"),
        ("new Box({x: 115, y: 152}, 100, 100); circle((100, 100), 50)", "choose one"),
        ("[0,0, 4,4, 4,0, 0,4] circle((1, 1), 1)", "not a valid shape"),
    ):
        path.write_text(text, encoding="utf-8")
        assert main(["explain", str(path)]) == 2
        out, err = capsys.readouterr()
        assert line in err and err.count("\n") == 1
        assert err.partition(": ")[2].strip() not in out, "said once"
    path.write_bytes(b"\xff\xfe\x00\xd8")
    assert main(["explain", str(path)]) == 2
    assert main(["explain", str(tmp_path / "none")]) == 2
    assert main(["explain", str(path), "--site", "https://example.org"]) == 2


def test_the_built_in_scenes_are_listed_as_json(capsys):
    assert main(["scenes", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["satviz"] == "scenes 1"
    assert main(["scenes", "--json", "--failing"]) == 2


# -- the paste box without its page


def test_the_explorer_shows_what_was_pasted():
    model = ExplorerModel(sv.scene("triangles"))
    reply = model.answer({"kind": "paste", "text": f"{SQUARE} circle((5, 2), 1)"})
    assert reply["kind"] == "state" and "n" not in reply and reply["relation"] == "touching"
    pasted = reply["pasted"]
    assert "A and B touch" in pasted["sentence"] and pasted["findings"][0]["kind"] == "touching"
    assert set(pasted["tests"]) == set(LANGUAGES) and pasted["link"] == reply["link"]
    assert "touching" in json.dumps(pasted["picture"])
    assert json.dumps(reply, allow_nan=False)
    assert model.scene.b == sv.Circle((5, 2), 1)


def test_a_text_without_an_answer_leaves_the_scene_alone():
    model = ExplorerModel(sv.scene("triangles"))
    before = model.state()
    for text, said in (
        ("nothing", "no shape was found"),
        (SQUARE, "paste a second one"),
        ("new Box({x: 115, y: 152}, 100, 100); circle((100, 100), 50)", "choose one"),
    ):
        reply = model.answer({"kind": "paste", "text": text})
        assert reply["kind"] == "pasted" and said in reply["pasted"].get("why", reply["pasted"].get("sentence"))
    for bad in ({"text": 5}, {"text": SQUARE, "as": "x"}, {"text": SQUARE, "as": [5]}, {"text": "x" * 2**21}, {}):
        assert model.answer({"kind": "paste", **bad})["pasted"]["why"]
    assert model.state() == before


def test_the_paste_box_asks_a_question_and_uses_the_answer():
    model = ExplorerModel(sv.scene("triangles"))
    text = "new Box({x: 115, y: 152}, 100, 100); circle((100, 100), 50)"
    (question,) = model.answer({"kind": "paste", "text": text})["pasted"]["questions"]
    for answer in question["answers"]:
        assert model.answer({"kind": "paste", "text": text, "as": [answer["choice"]]})["relation"] == answer["gives"]


CLEAR = "a = [(0,0),(4,0),(4,4)]\nb = [(2,2),(6,2),(6,6)]"


@pytest.mark.parametrize("more", [" zork 3", "; circle((3, 3), 1); zork 3"])
def test_the_answer_without_what_is_not_understood_stands_below_the_question(more):
    pasted, left_out = sv.paste(CLEAR + more), sv.paste(CLEAR + more, "leave-out")
    assert pasted.open and not pasted.shapes and not pasted.traces and not pasted.pairs
    question, answer = str(pasted).split("\n\nWithout it:\n")
    assert question.count("Not understood") == 1 and "clearly" not in answer
    assert answer.strip().startswith(left_out.sentence)
    assert pasted.without.shapes == left_out.shapes and pasted.data()["without"]["sentence"] == left_out.sentence
    assert str(pasted.without.pairs[0].trace) in answer and "What other definitions say" in answer


def test_there_is_no_answer_below_a_question_with_one_shape_or_with_another_question():
    assert sv.paste("a = [(0,0),(4,0),(4,4)] zork 3").without is None
    box = "new Box({x: 115, y: 152}, 100, 100); circle((100, 100), 50) zork 3"
    assert [q.what for q in sv.paste(box).questions if q.matters] == ["rest", "box"]
    assert sv.paste(box).without is None and sv.paste(box, "corner-size").without is not None
    assert sv.paste(CLEAR).without is None


def test_no_test_is_called_wrong_where_third_coordinates_differ():
    text = "ConvexPolygon((Point(0, 0, {}), Point(4, 0, 1), Point(0, 4, 1))) circle((9, 9), 1)"
    flat, slanted = (sv.paste(text.format(z)).findings for z in (1, 190))
    assert [f.kind for f in flat] == ["clear", "note"]
    assert [f.kind for f in slanted] == ["third-coordinate"] and "is wrong" not in str(slanted)


def test_a_position_that_is_left_out_is_named_in_the_answer():
    (question,) = sv.paste("[(0,0),(4,0),(4,4)] circle((9, 9), 1); rectangle position (10, 10)").questions
    assert question.answers[0].meaning == "the shapes as read, without this position"
    (question,) = sv.paste("[(0,0),(4,0),(4,4)] circle((9, 9), 1); zork 10").questions
    assert question.answers[0].meaning == "the shapes as read, without it"


def test_another_pair_of_several_is_shown():
    model = ExplorerModel(sv.scene("triangles"))
    text = "circle((0,0),2) circle((3,0),2) circle((5,0),2)"
    first, second = (model.answer({"kind": "paste", "text": text, "pair": number}) for number in (0, 1))
    assert first["pasted"]["note"] == "The picture calls B A, and C B." and "note" not in second["pasted"]
    assert first["a"]["circle"] == [3, 0] and second["a"]["circle"] == [0, 0]


def test_a_crossing_outline_has_a_picture_with_its_crossing_and_the_order_that_was_meant():
    model = ExplorerModel(sv.scene("triangles"))
    reply = model.answer({"kind": "paste", "text": f"[0,0, 4,4, 4,0, 0,4] {SQUARE}"})
    drawn = reply["pasted"]["refused"]
    assert "dotted line is the order that was probably meant" in drawn["sentence"]
    parts = [mark["part"] for mark in drawn["marks"]]
    assert parts.count("meant") == 4 and parts.count("crossing") == 1 and parts.count("vertex-name") == 4
    assert any(mark.get("text") == "crosses at (2, 2)" for mark in drawn["marks"])
    assert reply["kind"] == "state" and reply["a"]["polygon"] == [[0, 0], [4, 0], [4, 4], [0, 4]]
    assert crossing([(Fraction(x), Fraction(y)) for x, y in ((0, 0), (4, 0), (4, 4), (0, 4))]) is None


def test_a_scene_and_a_trace_are_read_with_their_shapes():
    scene = sv.scene("circle-polygon")
    for what in scene, scene.record(), scene.to_json():
        assert sv.paste(what).shapes == (scene.a, scene.b)
    assert repr(sv.paste(scene)).startswith("<Pasted: A and B")


def test_the_widget_in_a_notebook_answers_a_paste():
    pytest.importorskip("anywidget")
    widget = sv.explore("triangles")
    sent = []
    widget.send = lambda content, buffers=None: sent.append(content)
    for text, kind in (f"{SQUARE} circle((5, 2), 1)", "state"), ("nothing", "pasted"):
        widget._receive(widget, {"kind": "paste", "text": text}, [])
        assert sent[-1]["kind"] == kind
    assert widget.scene.b == sv.Circle((5, 2), 1) and widget.trace.relation is sv.Relation.TOUCHING


def test_the_page_of_the_site_answers_a_paste():
    from satviz.site import live

    live.answer("paste-test", json.dumps({"kind": "open", "hash": "triangles"}))
    reply = json.loads(live.answer("paste-test", json.dumps({"kind": "paste", "text": f"{SQUARE} circle((5, 2), 1)"})))
    assert reply["pasted"]["pairs"][0]["relation"] == "touching"
    live._models.pop("paste-test")
