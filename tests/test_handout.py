"""Tests of handouts: they contain all questions and no answer, and the solutions contain all answers."""

import re
from html import unescape
from itertools import pairwise
from typing import get_args

import pytest
from speeds import one_in

import satviz as sv
from satviz.cli import PAPERS, main
from satviz.engine.geometry import InvalidScene
from satviz.lessons import handout as lessons
from satviz.lessons.chapter_text import chapters
from satviz.pictures.letters import text_size
from satviz.pictures.number_lines import number_lines
from satviz.pictures.playback import table_rows
from satviz.scenes.failing import FAILURE_CASES, REFUSED
from satviz.scenes.named import ALL_SCENES

pytest.importorskip("markdown_it", reason="a handout of a chapter needs markdown-it-py")

from satviz.lessons.questions import questions

CHAPTERS = [chapter.title.split()[0] for chapter in chapters()]


def words(html):
    """Return the text of a page, without its style sheet, with single spaces."""
    body = re.sub(r"<style>.*?</style>|<[^>]+>", " ", html, flags=re.DOTALL)
    return re.sub(r"\s+", " ", unescape(body))


@pytest.mark.parametrize("number", one_in(4, CHAPTERS))
def test_the_handout_of_a_chapter_has_questions_and_its_solutions_have_answers(number):
    (chapter,) = (each for each in chapters() if each.title.startswith(number))
    asked, solved = words(sv.handout(number)), words(sv.handout(number, solutions=True))
    found, exercises = questions(chapter)
    assert len(exercises) in (2, 3)
    for question in [*found, *exercises]:
        answer, reasons = words(question.answer).strip(), [words(why).strip() for *_, why in question.choices]
        assert words(question.words).strip() in asked
        assert answer and answer in solved and answer not in asked
        assert all(reason in solved and reason not in asked for reason in reasons), question
        assert all(words(choice).strip() in asked for _, choice, _ in question.choices)
    assert "✓" not in asked and "Drag" not in words("".join(q.words for q in found))


def test_the_handout_has_the_questions_of_the_chapter():
    counts = {chapter.title[0]: len(questions(chapter)[0]) for chapter in chapters()}
    assert counts["1"] == 3 and counts["2"] == 4 and all(counts.values())


ONE_OF_TEN = [pytest.param(s.name, marks=[pytest.mark.slow] if i % 10 else []) for i, s in enumerate(ALL_SCENES)]


@pytest.mark.parametrize("name", ONE_OF_TEN)
def test_the_handout_of_a_scene_has_no_results(name):
    trace = sv.scene(name).record()
    whole = (trace.truth if trace.shortcut else trace).without_early_exit()
    rows = [row for row in table_rows(whole) if "reason" not in row][:12]
    asked, solved = sv.handout(name), sv.handout(name, solutions=True)
    cells = re.findall(r"<td>(.*?)</td>", asked.partition("<tbody>")[2])
    assert len(cells) == 7 * len(rows) and not any("".join(cells[7 * i + 3 : 7 * i + 7]) for i in range(len(rows)))
    for row in rows:
        assert row["outcome"] not in words(asked).replace(row["axis"], "") and row["outcome"] in words(solved)
    assert whole.sentence not in words(asked) and 'class="solved"' not in asked


def test_the_solution_of_a_users_shortcut_is_its_true_run():
    known = sv.scene("no-nearest-vertex")
    mine = sv.Scene("mine", known.a, known.b, axes="no-nearest-vertex")
    solved = words(sv.handout(mine, solutions=True))
    assert mine.record().truth.sentence in solved and "shortcut" not in solved


@pytest.mark.parametrize("name", ["aabb-rotated", "concave-outline"])
def test_no_title_gives_away_that_the_axes_cannot_show_the_gap(name):
    assert sv.scene(name).record().false_hit
    asked = words(sv.handout(name))
    assert sv.scene(name).title not in asked and "Do they collide?" in asked


@pytest.mark.parametrize("what", ["1", "3"])
def test_no_title_in_a_chapters_handout_gives_away_that_the_axes_cannot_show_the_gap(what):
    assert "cannot tell apart" not in sv.handout(what)


def test_far_from_the_origin_coordinates_have_all_figures_that_are_needed():
    a, b = sv.Polygon([(1e6, 0), (1e6 + 1, 0), (1e6 + 0.5, 1)]), sv.Circle((1e6 - 2.25, 0.5), 1.5)
    asked = words(sv.handout(sv.Scene("far", a, b)))
    assert "a1 (1000000, 0), a2 (1000001, 0), a3 (1000000.5, 1)" in asked
    assert "circle, center (999997.75, 0.5), radius 1.5" in asked


@pytest.mark.parametrize("name", ["triangles", "concave", "circles", "far-centers"])
def test_number_lines_to_fill_in_have_all_ticks_but_no_ranges(name):
    trace = sv.scene(name).record()
    empty, filled = number_lines(trace, filled=False), number_lines(trace, filled=True)
    assert {mark.kind for mark in empty.marks} == {"arrow", "segment", "label"}
    assert set(empty.marks) < set(filled.marks) and "interval" in {mark.kind for mark in filled.marks}
    width, height = filled.size
    assert all(0 <= x <= width and 0 <= y <= height for mark in filled.marks for x, y in mark.points)


def test_a_range_is_drawn_at_its_numbers():
    """The bar ends where the ticks of its ends are: upright boxes have whole numbers."""
    drawn = number_lines(sv.scene("aabb").record(), filled=True)
    ticks = {
        (m.number, float(m.part[5:])): m.points[0].x
        for m in drawn.marks
        if m.part.startswith("tick-") and m.kind == "segment"
    }
    for n, test in enumerate(sv.scene("aabb").record().without_early_exit().tests, 1):
        for name, side in ("A", test.a), ("B", test.b):
            (bar,) = (m for m in drawn.marks if (m.part, m.owner, m.number) == ("range", name, n))
            for point, end in zip(bar.points, side.interval, strict=True):
                assert point.x == pytest.approx(ticks[n, end])


@pytest.mark.parametrize("axes", [10.0**k for k in (-12, -3, 0, 5, 12)])
def test_ticks_fit_any_scale(axes):
    a, b = sv.Circle((0, 0), axes), sv.Circle((3 * axes, axes), axes)
    drawn = number_lines(sv.record(a, b), filled=True)
    assert 6 <= sum(mark.kind == "segment" for mark in drawn.marks) <= 20


@pytest.mark.parametrize(("start", "size"), [(0, 1), (0, 1e-12), (0, 1e5), (1e6, 1), (1e15, 1), (-1e6, 0.125)])
def test_each_tick_has_its_own_number_and_there_is_space_for_it(start, size):
    def square(x):
        return sv.Polygon([(x, start), (x + size, start), (x + size, start + size), (x, start + size)])

    drawn = number_lines(sv.record(square(start), square(start + 2 * size)), filled=True)
    names = [mark for mark in drawn.marks if mark.part.endswith("-name") and "tick" in mark.part and mark.number == 1]
    values = [float(mark.text.replace("−", "-")) for mark in names]
    assert len(values) >= 2 and values == sorted(set(values))
    (distance,) = {round((q - p) / size, 6) for p, q in pairwise(values)}
    assert f"{distance * size:.2e}"[:4] in ("1.00", "2.00", "5.00")
    for p, q in pairwise(names):
        assert p.points[0].x + text_size(p.text)[0] / 2 < q.points[0].x - text_size(q.text)[0] / 2


@pytest.mark.parametrize("width", [4, 30, 400])
def test_the_numbers_of_two_ticks_have_a_space_between_them(width):
    a = sv.Polygon([(0, 0), (width, 0), (width, 3), (0, 3)])
    b = sv.Polygon([(3, 2), (6, 2), (5, 5)])
    drawn = number_lines(sv.record(a, b), filled=False)
    named = [m for m in drawn.marks if m.part.endswith("-name") and m.number == 1]
    assert len(named) >= 4
    assert f"{float(named[-1].text) - float(named[-2].text):e}"[:3] in ("1.0", "2.0", "5.0")
    for left, right in pairwise(named):
        assert right.points[0].x - left.points[0].x > (text_size(left.text)[0] + text_size(right.text)[0]) / 2 + 4


def test_the_vertices_of_the_table_are_named_beside_their_coordinates():
    asked = words(sv.handout("triangles"))
    assert "a1 (0, 1), a2 (3, 2), a3 (1, 5)" in asked and "v1 (5, 5), v2 (8, 3), v3 (4, 1)" in asked


def test_the_handout_of_many_axes_has_the_first_twelve():
    from math import cos, pi, sin

    ring = [(cos(pi * k / 20), sin(pi * k / 20)) for k in range(40)]
    html = sv.handout(sv.Scene("rings", sv.Polygon(ring), sv.Polygon([(x + 3, y + 0.01 * x) for x, y in ring])))
    assert "These are the first 12 of" in html and "and 28 more" in html


def test_an_overlap_is_hatched_so_that_paper_without_colours_tells_it_from_a_gap():
    trace = sv.scene("triangles").record().without_early_exit()
    found = {(m.part, m.number) for m in number_lines(trace, filled=True).marks if m.part in ("gap", "hatch")}
    assert found == {("gap" if test.gap > 0 else "hatch", n) for n, test in enumerate(trace.tests, 1)}


def test_a_handout_is_black_and_white_and_a_file_of_its_own():
    html = sv.handout("triangles", "1", paper="letter")
    assert (
        "@page { size: letter;" in html
        and "<script" not in html
        and "http" not in re.sub(r"http://(www\.w3|purl)\.org", "", html).replace("http-equiv", "")
    )
    colours = set(re.findall(r"#[0-9a-fA-F]{3,6}\b", html))
    assert colours <= {"#000", "#fff", "#555"}, colours
    assert html.count('<article class="sheet">') == 2


def test_the_handout_of_a_shortcut_asks_whether_its_claim_is_right():
    case = next(row for row in FAILURE_CASES if row.how != REFUSED)
    asked, solved = words(sv.handout(case.name)), words(sv.handout(case.name, solutions=True))
    assert f"“{case.claim}”" in asked and case.how not in asked and case.how in solved


def test_a_trace_and_two_shapes_have_handouts_too():
    a, b = sv.Circle((0, 0), 1), sv.Circle((3, 0), 1)
    assert sv.handout(sv.record(a, b)) and "Do they collide?" in sv.handout(sv.Scene("mine", a, b))


def test_a_handout_that_cannot_be_made_is_refused():
    with pytest.raises(ValueError, match=r"paper is 'A3': expected one of A4, letter"):
        sv.handout("triangles", paper="A3")
    with pytest.raises(ValueError, match="nothing to print"):
        sv.handout()
    with pytest.raises(InvalidScene):
        sv.handout("nothing-of-that-name")
    with pytest.raises(InvalidScene):
        sv.handout(next(row.name for row in FAILURE_CASES if row.how == REFUSED))
    assert get_args(lessons.Paper) == PAPERS


def test_the_command_writes_both_sheets_also_of_a_file(tmp_path, capsys):
    own = tmp_path / "mine.json"
    own.write_text(sv.Scene("mine", sv.Circle((0, 0), 1), sv.Circle((3, 0), 1), title="My circles").to_json())
    out = tmp_path / "out"
    for _ in range(2):
        assert main(["handout", "2-sat", str(own), "--out", str(out)]) == 0
    assert capsys.readouterr().out.splitlines()[:2] == [
        str(out / "handout-2-mine.html"),
        str(out / "handout-2-mine-solutions.html"),
    ]
    asked, solved = (path.read_text() for path in sorted(out.iterdir(), reverse=True))
    assert "My circles" in asked and "My circles: solutions" in solved and "size: A4" in asked
    assert main(["handout", "nope", "--out", str(out)]) == 2
    assert "no scene and no file 'nope'" in capsys.readouterr().err
