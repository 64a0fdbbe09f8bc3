"""The contact sheet: the whole run in one picture."""

from itertools import combinations
from math import cos, pi, sin

import pytest
from test_pictures import TRACES, boxes, meet

import satviz as sv
from satviz.cli import main
from satviz.pictures.layout import NARROW_SIZE_PT
from satviz.pictures.sheet import MAX_ROWS


def gon(n, x, r=2.0):
    return sv.Polygon([(x + r * cos(0.1 + 2 * pi * k / n), r * sin(0.1 + 2 * pi * k / n)) for k in range(n)])


LONG = {"hit": sv.record(gon(40, 0), gon(37, 3.9)), "apart": sv.record(gon(40, 0), gon(37, 4.1))}
FAR = sv.record(*(sv.Polygon([(7e8 + x, 6e8 + y) for x, y in s.vertices]) for s in (gon(3, 0), gon(4, 5))))
LONG_NAMES = ["the north-eastern corner of it all", "left", "日本語ラベル"]
NAMED = sv.record(sv.Polygon(gon(3, 0).vertices, LONG_NAMES), sv.Polygon(gon(3, 2).vertices, LONG_NAMES))
SHEETS = {name: sv.sheet(trace) for name, trace in (TRACES | LONG | {"far": FAR, "named": NAMED}).items()}


@pytest.mark.parametrize("name", SHEETS)
def test_no_label_of_a_sheet_runs_over_another_or_off_it(name):
    picture = SHEETS[name]
    placed = list(boxes(picture))
    assert not [(m.text, n.text) for (m, p), (n, q) in combinations(placed, 2) if meet(p, q)]
    assert all(p[0] >= 0 and p[1] >= 0 and p[2] <= picture.size[0] and p[3] <= picture.size[1] for _, p in placed)
    assert len({mark.id for mark in picture.marks}) == len(picture.marks)
    assert picture.size[0] <= NARROW_SIZE_PT[0]  # a telephone shows it without making its letters smaller


@pytest.mark.parametrize("name", TRACES)
def test_the_names_of_usual_axes_are_not_cut(name):
    assert not [text for text in SHEETS[name].texts if "\u2026" in text]


@pytest.mark.parametrize("name", ["triangles", "aabb", "circle-polygon", "overlap"])
def test_bars_lie_on_one_scale_with_one_zero(name):
    trace, picture = TRACES[name].without_early_exit(), SHEETS[name]
    zero = next(m.points[0].x for m in picture.marks if m.part == "zero")
    scales = []
    for i, test in enumerate(trace.tests, 1):
        for who, side in (("A", test.a), ("B", test.b)):
            (p, q), (lo, hi) = picture.mark(f"{who}.range.{i}").points, side.interval
            scales.append((q.x - p.x) / (hi - lo))
            assert p.x == pytest.approx(zero + lo * scales[0])
    assert scales == pytest.approx([scales[0]] * len(scales))


def test_the_row_that_ended_the_run_is_marked_and_those_left_out_are_faint():
    picture = SHEETS["triangles"]
    assert [m.number for m in picture.marks if m.part == "stop"] == [2]
    faint = {m.number for m in picture.marks if m.part == "range" and m.weight == "faint"}
    assert faint == {3, 4, 5, 6} and picture.texts.count("not tested") == 4


@pytest.mark.parametrize("name", LONG)
def test_a_long_run_shows_the_axes_of_the_largest_gaps_and_counts_the_others(name):
    trace, picture = LONG[name], SHEETS[name]
    rows = [m for m in picture.marks if m.part == "name"]
    rest = len(trace.without_early_exit().tests) - MAX_ROWS
    assert len(rows) == MAX_ROWS and any(text.startswith(f"and {rest} more, at best ") for text in picture.texts)
    assert bool([m for m in picture.marks if m.part == "stop"]) == (name == "apart")


def test_far_from_the_origin_the_bars_are_as_wide_as_anywhere():
    widths = [m.points[1].x - m.points[0].x for m in SHEETS["far"].marks if m.part == "range"]
    assert min(widths) > 20 and "0" not in SHEETS["far"].texts


def test_draw_makes_a_sheet_of_a_long_run_and_the_steps_when_asked(tmp_path, capsys):
    scene = sv.Scene("many-corners", gon(40, 0), gon(37, 3.9))
    path = tmp_path / "many.json"
    path.write_text(scene.to_json())
    assert main(["draw", str(path), "--out", str(tmp_path / "out")]) == 0
    assert [p.name for p in (tmp_path / "out").iterdir()] == ["many-corners-sheet.svg"]
    assert "--steps makes those" in capsys.readouterr().out
    assert main(["draw", "triangles", "--sheet", "--out", str(tmp_path / "short")]) == 0
    assert [p.name for p in (tmp_path / "short").iterdir()] == ["triangles-sheet.svg"]
    assert main(["draw", "aabb", "--steps", "--out", str(tmp_path / "steps")]) == 0
    assert len(list((tmp_path / "steps").iterdir())) == len(sv.steps(sv.scene("aabb").record()))


@pytest.mark.parametrize("size", [1e-9, 1.0, 1e9])
@pytest.mark.parametrize("k", range(1, 12, 2))
def test_a_narrow_range_is_seen_and_long_numbers_stay_on_the_sheet(size, k):
    w = size * 10.0**-k
    b = sv.Polygon([(x * w + size / 3, y * w - size / 7) for x, y in ((0, 0), (1, 0.3), (0.2, 1))])
    a = sv.Polygon([(-0.7 * size, -0.3 * size), (size, 0.1 * size), (0.2 * size, 0.8 * size)])
    picture = sv.sheet(sv.record(a, b))
    assert all(p[0] >= 0 and p[2] <= picture.size[0] for _, p in boxes(picture))
    for row in {m.number for m in picture.marks if m.part == "range"}:
        for part in "range", "small":
            (mark,) = (m for m in picture.marks if (m.part, m.number, m.role) == (part, row, "B"))
            size_there = max(abs(p.x - q.x) + abs(p.y - q.y) for p in mark.points for q in mark.points)
            specks = [m for m in picture.marks if (m.part, m.number, m.role) == (f"{part}-speck", row, "B")]
            assert size_there >= 3 or specks


def test_a_gap_too_small_for_its_row_has_an_inset_with_its_magnification():
    drawn = sv.sheet("unit-normals")
    p, q = drawn.mark("inset-gap.1").points
    assert q.x - p.x > 8 and drawn.mark("inset-name.1").text.startswith("\N{MULTIPLICATION SIGN}")
    a, b = drawn.mark("A.inset-range.1").points, drawn.mark("B.inset-range.1").points
    assert b[1].x == pytest.approx(p.x) and a[0].x == pytest.approx(q.x)
    assert not [m for m in sv.sheet("triangles").marks if m.part == "inset"]
