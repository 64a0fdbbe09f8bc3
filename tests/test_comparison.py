"""Tests of comparison pictures: each failing scene shows the wrong number, struck out, and the right one."""

import math
import re
from importlib.util import find_spec
from itertools import combinations, pairwise

import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from speeds import one_in

import satviz as sv
from satviz.cli import main
from satviz.engine.number_format import ascii_minus
from satviz.pictures import comparison, comparison_panels
from satviz.pictures.float_geometry import clip_segment
from satviz.pictures.label_placer import LabelPlacer, LabelRequest
from satviz.pictures.layout import Layout, PanelContents, arrange
from satviz.pictures.letters import text_size
from satviz.pictures.marks import Picture
from satviz.pictures.playback import NARROW_PANEL_SIZES_PT, narrow_playbacks
from satviz.pictures.theme import DOT_PT, DOTS
from satviz.scenes.failing import FAILURE_CASES, FALSE_HIT, MISSED_HIT, NAMED, REFUSED, SHORTCUTS, true_value
from satviz.scenes.failing.circles_and_dents import halves
from satviz.scenes.shape_tools import box, translated
from satviz.widgets.explorer_model import ExplorerModel

SHOWN = [case for case in FAILURE_CASES if case.how != REFUSED]
each_refused = pytest.mark.parametrize(
    "case", [case for case in FAILURE_CASES if case.how == REFUSED], ids=lambda case: case.name
)
each_case = pytest.mark.parametrize("case", SHOWN, scope="module", ids=lambda case: case.name)


def texts(drawn: Picture, prefix: str) -> dict[str, str]:
    return {
        mark.id: ascii_minus(mark.text) for mark in drawn.marks if mark.kind == "label" and mark.part.startswith(prefix)
    }


def struck(drawn: Picture) -> list[str]:
    """Return the texts that are struck out: a line crosses each line of the label, except a remark below a gap."""
    lines = [mark for mark in drawn.marks if mark.part.endswith("-strike")]
    found = []
    for line in lines:
        (label,) = (m for m in drawn.labels if m._replace(part=f"{m.part}-strike").id == line.id)
        ys = [p.y for p in line.points]
        rows = label.text.split("\n")
        if label.part.endswith("gap-name") and len(rows) > 1:
            assert len(set(ys)) == 1 and ys[0] > label.points[0].y
        else:
            assert len(set(ys)) == len(rows) and max(ys) + min(ys) == pytest.approx(2 * label.points[0].y)
        found.append(ascii_minus(label.text))
    return found


def boxes(drawn: Picture) -> list[tuple[str, tuple[float, float, float, float]]]:
    """Return each label's text and its box in points."""
    found = []
    x0, y0 = drawn.limits[:2]
    for mark in drawn.labels:
        w, h = text_size(mark.text, mark.weight)
        x, y = ((c - o) * drawn.scale for c, o in zip(mark.points[0], (x0, y0)))
        found.append((mark.text, (x - w / 2, y - h / 2, x + w / 2, y + h / 2)))
    return found


def no_overlap(drawn: Picture) -> bool:
    """Check that no label overlaps another or leaves the canvas; an AssertionError names the label."""
    found = boxes(drawn)
    width, height = drawn.size
    for i, (text, (x0, y0, x1, y1)) in enumerate(found):
        assert x0 >= -0.5 and x1 <= width + 0.5 and y0 >= -0.5 and y1 <= height + 0.5, f"{text!r} is cut off"
        for other, (p0, q0, p1, q1) in found[:i]:
            assert x1 <= p0 + 1 or p1 <= x0 + 1 or y1 <= q0 + 1 or q1 <= y0 + 1, f"{text!r} lies on {other!r}"
    return True


@each_case
def test_the_heading_says_the_claim_the_wrong_answer_and_the_right_one(case):
    trace = case.record()
    drawn = sv.picture(trace)
    words = " ".join(" ".join(drawn.mark(name).text.split()) for name in ("heading", "wrong"))
    wrong, good = case.answers
    if isinstance(case.actual, tuple):
        wrong = "no contact"
    elif case.how in (FALSE_HIT, MISSED_HIT):
        wrong, gap = str(trace.claim), good if good.startswith("gap ") else ""
        good = ", ".join(filter(None, (str(trace.relation), gap)))
    compared = f"{wrong}, not less than {case.actual}" if case.claims_less else f"{wrong}. Right: {good}"
    assert ascii_minus(words) == ascii_minus(f"Claim: {case.claim}. Wrong: {compared}.")
    said = trace.sentence
    assert drawn.sentence == said and case.claim in said and "so it is" not in said
    assert ("In truth they" in said) is (trace.claim is not trace.relation)
    if trace.claim is trace.relation:  # then a number, a push or the next frame is wrong
        assert ascii_minus(said).endswith(ascii_minus(f". Wrong: {compared}."))


@each_case
def test_the_shortcuts_number_stands_on_the_left_struck_out_and_the_right_one_on_the_right(case):
    drawn = sv.picture(case.record())
    saw, truth = (" | ".join(texts(drawn, prefix).values()) for prefix in ("claimed", "actual"))
    assert bool(struck(drawn)) is not case.claims_less  # where both numbers are true
    left, right = {
        "tunnelling": ("gap +1.850", "they meet on the way"),
        "touch-on-paper": ("touching, gap 0", "overlap 5.551e-17"),
        "touch-as-apart": ("apart", "touching, gap 0"),
        "mixed-signs": ("gap +1", "overlap 1, way out 2"),  # its own axis, with the true ranges
        "unit-normals": ("gap +4.441e-16", "touching, gap 0"),
        "box-in-u": ("overlap 2", "between\nA1 and B"),
        "edges-cross": ("apart", "overlap 1, way out 2"),
        "corner-inside": ("apart", "overlap 1, way out 2"),
    }.get(case.name, ("", ""))
    if not left:
        values = [case.in_words(answer) for answer in (case.claimed, case.actual)]
        left, right = map(ascii_minus, values)
    assert left in saw and right in truth
    true_overlap = (
        "true, but\n" in saw or "true overlaps" in saw or "on y, true" in saw or case.name == "faces-in-3d"
    )  # only the verdict is wrong
    true = true_overlap or case.name == "tunnelling" or case.claims_less
    assert any(left in text for text in struck(drawn)) is not true
    # where there is a gap
    false_overlaps = {"one-sided-gap": ["overlap 5"], "start-at-zero": ["overlap 2"]}.get(case.name, [])
    assert not true_overlap or struck(drawn) == ["overlapping", *false_overlaps]


@each_case
def test_an_axis_is_named_after_something_visible(case):
    drawn = sv.picture(case.record(), largest=(338, 680))
    for side in "claimed", "actual":
        vertices = {m.text for m in drawn.labels if m.part == f"{side}-vertex-name"}
        for mark in (m for m in drawn.labels if m.part == f"{side}-axis-name"):
            assert mark.text != "axis"
            if ends := re.search(r" of ([ab]\d)([ab]\d)$", mark.text):
                assert set(ends.groups()) <= vertices, mark.text


@pytest.mark.parametrize("name, part", [("slipped-normal", "gap-name"), ("largest-overlap", "mtv-name")])
def test_a_line_that_another_label_blocks_ends_at_the_nearest_point_of_its_label(name, part):
    drawn = sv.picture(name, largest=(338, 680))
    (leader,) = (m for m in drawn.marks if m.part == f"actual-{part}-leader")
    boxes_hit = [text for text, box in boxes(drawn) if clip_segment(*leader.points[0], *leader.points[1], *box)]
    assert boxes_hit in ([], [drawn.mark(leader.id.removesuffix("-leader")).text])


def test_a_push_shows_where_its_direction_comes_from_and_which_shape_does_not_move():
    case = NAMED["push-from-center"]
    shown = sv.picture(case.record())
    a, b, push = (shown.mark(name).points for name in ("A.claimed-mean", "B.claimed-mean", "claimed-push"))
    assert (a[0].x, push[0].x) == pytest.approx((b[0].x, push[1].x))
    assert a[0].y > b[0].y and push[0].y > push[1].y and shown.mark("actual-mtv").points[1].y > b[0].y
    assert sv.picture("half-the-way").mark("claimed-said").text == "A does not move"


@each_case
def test_each_panel_shows_both_shapes(case):
    if case.name in ("many-pairs", "gjk-looks-less"):  # a crowd, and the difference of both
        return
    drawn = sv.picture(case.record())
    for side in "claimed", "actual":
        owners = {mark.owner[0] for mark in drawn.marks if mark.part == f"{side}-outline"}
        assert owners == {"A", "B"}, side


@each_case
def test_nothing_is_struck_out_on_the_side_of_the_truth(case):
    drawn = sv.picture(case.record())
    assert not [m for m in drawn.marks if m.part.startswith("actual-") and m.part.endswith("-strike")]


@each_case
@pytest.mark.parametrize("step", [0, 3, -1])
def test_no_label_lies_on_another_or_off_the_canvas(case, step):
    trace = case.record()
    drawn = sv.picture(trace, min(step, len(sv.steps(trace)) - 1))
    assert no_overlap(drawn)


@each_case
def test_all_steps_have_one_size_and_each_has_a_name_of_its_own(case):
    trace = case.record()
    every = [sv.picture(trace, i) for i in range(len(sv.steps(trace)))]
    assert len({(drawn.size, drawn.limits) for drawn in every}) == 1
    for drawn in every:
        assert len({mark.id for mark in drawn.marks}) == len(drawn.marks)


def test_a_missed_hit_shows_claimed_and_true_ranges_on_the_shortcuts_axis():
    drawn = sv.picture(NAMED["extremes-once"].record())
    bars = [drawn.mark(f"A.{side}-range.{axis}").points for side, axis in (("claimed", 1), ("actual", 1))]
    claimed, actual = (math.dist(*bar) for bar in bars)
    assert actual / claimed == pytest.approx((3.394 + 2.828) / (2.828 + 2.828), rel=1e-3)


def test_an_edge_without_a_length_is_labelled_and_gives_no_axis():
    trace = NAMED["repeated-vertex"].record()
    (i,) = (i for i, test in enumerate(trace.tests) if not any(test.axis.normal))
    for step in -1, sv.Step(sv.Stage.GAP, i), sv.Step(sv.Stage.EDGE, i):
        drawn = sv.picture(trace, step)
        assert "a2 and a3 lie in one place" in drawn.mark("claimed-no-axis").text
        assert not [m for m in drawn.marks if m.part == "claimed-axis"]


def test_a_shortcut_that_is_right_for_once_is_not_struck_out():
    trace = sv.record(box(0, 0, 1, 1), box(3, 0, 4, 1), axes=SHORTCUTS["one-shapes-normals"])
    drawn = sv.picture(trace)
    assert drawn.mark("wrong").text == "Here it happens to be right: gap +2." and not struck(drawn)


@pytest.mark.parametrize(
    "name, move, right",
    [
        ("tunnelling", (0, 3.1), True),
        ("tunnelling", (0.9, 0.3), False),
        ("touch-on-paper", (0.9, 0.3), True),
        ("push-from-center", (0, 1), True),
        ("push-from-center", (0, 9), True),
        ("sum-of-parts", (30, 7), True),
        ("sum-of-parts", (0.9, 0.3), False),
        ("tile-seam", (0, 9), True),
    ],
)
def test_a_shortcut_is_called_wrong_only_where_it_is(name, move, right):
    """It is not called wrong for a rounding, nor for a push where there is nothing to push."""
    case = NAMED[name]
    a, b = case.shapes
    trace = sv.record(a, translated(b, sv.Vec(*move)), axes=case.shortcut)
    words = sv.picture(trace).mark("wrong").text
    assert words.startswith("Here it happens to be right: " if right else "Wrong: "), words
    assert sv.picture(case.record()).mark("wrong").text.startswith("Wrong: ")


def test_a_users_shortcut_is_drawn_beside_the_truth():
    mine = sv.Shortcut("mine", "y is enough", sv.axes.directions((0, 1)))
    drawn = sv.picture(sv.record(box(0, 0, 2, 2), box(3, 0.5, 5, 2.5), axes=mine))
    assert drawn.mark("heading").text == "Claim: y is enough."
    assert drawn.mark("wrong").text == "Wrong: overlapping. Right: apart."
    assert "overlapping" in struck(drawn)


@pytest.mark.parametrize("name", one_in(2, SHORTCUTS))
def test_every_shortcut_is_drawn_for_pairs_of_every_kind(name):
    shapes = [
        box(0, 0, 2, 2),
        sv.Polygon([(0, 1), (3, 2), (1, 5)]),
        sv.Circle((1.5, 2), 1),
        sv.Polygon([(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)]),
    ]
    pairs = [(a, b) for a in shapes for b in (shapes[0], shapes[2], sv.Circle((5, 4), 1), box(5, 1, 6, 2))]
    for a, b in pairs[:: 1 if name in ("dart", "tile-seam", "one-maximum") else 3]:
        trace = sv.record(a, b, axes=SHORTCUTS[name])
        assert sv.picture(trace).marks and sv.picture(trace, 0).marks


def refusal(case):
    """Return the error line, where the picture names the edges by their corners, and what an unchecked run says."""
    named = "edges a1a2 and a4a5 cross (rings)"
    unchecked = case.unchecked_words.format(case.in_words(case.claimed))
    return f"Refused: {re.sub(r'edges 0 and 3 cross near [(][^)]*[)]', named, case.actual)}. Unchecked: {unchecked}."


@each_refused
def test_a_refused_case_shows_its_outlines_and_the_reason(case, tmp_path):
    drawn = comparison.refused_picture(case)
    assert [mark.owner for mark in drawn.marks if mark.part == "outline"] == ["A", "B"]
    assert " ".join(drawn.mark("wrong").text.split()) == refusal(case)
    assert ascii_minus(case.in_words(case.claimed)) in ascii_minus(refusal(case))
    rods = not any(point[1] for ring in case.raw_outlines for point in ring)
    assert ("the only normal" in drawn.texts) is rods  # on which all their points land in one place
    for form in "svg", "png", "gif", "html":
        assert main(["draw", case.name, "--out", str(tmp_path), "--format", form]) == 0
        assert (tmp_path / f"{case.name}.{form}").stat().st_size
    assert (tmp_path / f"{case.name}.html").read_text(encoding="utf-8") == sv.page(case.name)


@each_refused
def test_whatever_shows_a_scene_shows_why_an_outline_is_refused(case):
    reason = refusal(case)
    page = sv.page(case.name)
    assert page.count(reason) >= 3 and "<script" not in page  # its title, its heading, the pictures' words
    assert page.count("<svg") == 2 and f"<h1>Claim: {case.claim}. {reason}</h1>" in page
    shown = [sv.picture(case.name), sv.picture(case.name, 0, largest=(340, 340))]
    if find_spec("anywidget"):
        shown += [sv.play(case.name), sv.play(case.name, predict=True), sv.explore(case.name)]
    for drawn in shown:
        assert drawn.sentence.endswith(reason) and no_overlap(drawn)
        assert " ".join(drawn.mark("wrong").text.split()) == reason
    assert sv.draw(case.name).axes
    with pytest.raises(sv.InvalidScene, match="is refused"):
        sv.scene(case.name)


def test_a_failing_scene_is_drawn_and_made_a_page_under_its_claim(tmp_path):
    assert main(["draw", "lengths", "--out", str(tmp_path), "--format", "svg", "--format", "html"]) == 0
    last = sorted(tmp_path.glob("lengths-*.svg"))[-1].read_text(encoding="utf-8")
    page = (tmp_path / "lengths.html").read_text(encoding="utf-8")
    claim = "Claim: a landing place is a length, so it has no sign."
    assert claim in last and f"<h1>{claim} Wrong: overlapping. Right: apart, gap +4.</h1>" in ascii_minus(page)


def test_both_pens_and_the_player_take_both_panels():
    trace = NAMED["raw-depth"].record()
    fig = sv.draw(trace)
    ax = fig.add_axes((0, 0, 1, 1))
    artists = sv.draw(trace, ax=ax)
    assert "claimed-number" in artists and "actual-number" in artists
    from satviz.pictures.playback import playbacks

    (show,) = playbacks(trace)
    assert len(show["steps"]) == len(sv.steps(trace)) and show["size"] == list(sv.picture(trace).size)


def test_the_axes_of_a_shortcut_can_be_used_for_any_scene_by_name(capsys):
    assert main(["trace", "triangles", "--axes", "one-overlap"]) == 0
    assert "By the shortcut “the ranges overlap on one axis, so the shapes collide”" in capsys.readouterr().out


@pytest.mark.parametrize("size", one_in(3, [1e-9, 1e-3, 1.0, 1e3, 1e9]))
@pytest.mark.parametrize("far", [0.0, 2.0**40])
@pytest.mark.parametrize("name", ["far-centers", "mixed-signs", "lengths", "raw-depth"])
def test_ranges_that_a_shortcut_finds_far_from_the_shapes_leave_them_visible(name, size, far):
    case, at = NAMED[name], size * far
    a, b = (sv.Polygon([(at + x * size, at + y * size) for x, y in s.vertices]) for s in (case.a, case.b))
    trace = sv.record(a, b, axes=case.shortcut)
    for step in range(len(sv.steps(trace))):
        drawn = sv.picture(trace, step)
        for owner in "AB":
            (outline,) = (m for m in drawn.marks if (m.part, m.owner, m.weight) == ("claimed-outline", owner, "plain"))
            assert max(abs(p.x - q.x) + abs(p.y - q.y) for p in outline.points for q in outline.points) > 5, step
        assert all(0 <= p.x <= drawn.size[0] and 0 <= p.y <= drawn.size[1] for m in drawn.marks for p in m.points)


@pytest.mark.parametrize("name", ["extremes-once", "touch-on-paper"])
def test_a_landing_is_labelled_with_the_vertex_that_lands_there_where_a_shortcut_leaves_points_out(name):
    points = [(-3, -1), (1, -3), (3, 1), (2.5, 2), (2.2, 2.6), (1, 3), (-3, 1)]  # the fourth lies within an edge
    a = sv.Polygon(points, [f"v{i}" for i in range(7)])
    trace = sv.record(a, box(4, 4, 5, 5), axes=SHORTCUTS[name], every_axis=True)
    for i, step in enumerate(sv.steps(trace)):
        if step.stage is not sv.Stage.DROPS:
            continue
        test = trace.tests[step.test]
        lands = dict(zip(test.a.points, test.a.landings, strict=True))
        for mark in sv.picture(trace, i).marks:
            if mark.part in ("claimed-lowest", "claimed-highest") and mark.owner == "A":
                who, _ = mark.text.split(": ")
                end = test.a.interval[mark.part == "claimed-highest"]
                assert all(abs(lands[a.vertices[int(v[1:])]] - end) < 1e-3 for v in who.split(", ")), mark.text


def pushed(move):
    return sv.Shortcut("mine", "that way is out", push=lambda a, b, tests: sv.Vec(*move))


@pytest.mark.parametrize("move, right", [((1.5, 0), True), ((0.5, 0), False), ((-7.5, 0), False), ((1e9, 0), False)])
def test_the_push_of_a_users_shortcut_is_compared_with_the_mtv(move, right):
    trace = sv.record(box(0, 0, 4, 4), box(2.5, 1, 6, 3), axes=pushed(move))
    drawn = sv.picture(trace)
    assert drawn.mark("claimed-push-name").text.startswith("push (")
    assert drawn.mark("wrong").text.startswith("Here it happens to be right" if right else "Wrong: push (")
    assert bool(struck(drawn)) is not right
    outline = drawn.mark("A.claimed-outline").points
    assert max(p.x for p in outline) - min(p.x for p in outline) > 20


def test_the_pieces_of_a_users_shortcut_are_drawn_with_their_pushes():
    mine = sv.Shortcut("mine", "each half pushes", split=halves)
    drawn = sv.picture(sv.record(box(0, 0, 4, 4), box(1.5, 1.5, 2.5, 2.5), axes=mine))
    assert {"A1", "A2"} <= {m.owner for m in drawn.marks if m.part == "claimed-outline"}
    assert drawn.mark("wrong").text.startswith("Wrong: push (0, 0). Right: overlapping, way out (")


def test_there_is_space_for_a_push_only_where_one_is_drawn():
    drawn = sv.picture(NAMED["one-overlap"].record())
    outline = drawn.mark("A.claimed-outline").points
    assert max(p.x for p in outline) - min(p.x for p in outline) > 50


def test_a_gap_that_is_right_is_not_struck_out_with_the_wrong_answer():
    drawn = sv.picture(NAMED["touch-as-apart"].record())
    assert struck(drawn) == ["apart"]
    assert "touching, gap 0\n2 \u2264 2, so it counts as a gap" in drawn.texts
    assert "touching, gap 0\n2 < 2 is false: no gap" in drawn.texts
    assert struck(ExplorerModel(sv.scene("tunnelling")).picture()) == ["apart"]


def test_the_comparison_that_a_one_sided_gap_forgets_is_shown_only_where_it_finds_a_gap():
    drawn, case = sv.picture("one-sided-gap"), NAMED["one-sided-gap"]
    asked, forgotten = drawn.mark("claimed-said").text.split("\n")
    assert asked == "asked: does A end (5) before B begins (0)? no"
    assert forgotten == "not asked: does B end (2) before A begins (3)? yes"
    assert "overlap 1.5 on y, true" in drawn.texts  # no longer taken for the overlap on x
    turned_round = sv.picture(sv.record(case.b, case.a, axes=case.shortcut))
    assert not [mark for mark in turned_round.marks if mark.part == "claimed-said"]


def test_pictures_say_which_step_of_a_shortcut_went_wrong():
    a, b = (shape.bounds for shape in NAMED["touch-on-paper"].shapes)
    drawn = sv.picture("touch-on-paper")
    assert drawn.mark("actual-said").text == f"in float64: A ends at {a[2]!r},\nB begins at {b[0]!r}"
    assert drawn.mark("claimed-said").text == f"as written: A ends at {round(a[2], 9)},\nB begins at {b[0]}"
    halved = sv.picture("integer-halves").mark("claimed-said").text
    x0, _, x1, _ = NAMED["integer-halves"].shapes[0].bounds
    assert f"[{x0:g}, {x1:g}]: middle {(x0 + x1) / 2} kept as {(x0 + x1) // 2:g}" in halved
    centers = [(s.bounds[0] + s.bounds[2]) / 2 for s in NAMED["far-centers"].shapes]
    far = f"centers {centers[1] - centers[0]} apart; more than 5 counts as far apart"
    assert sv.picture("far-centers").mark("claimed-said").text == far
    even = sv.record(box(0, 0, 4, 2), box(4, 0, 6, 2), axes=SHORTCUTS["integer-halves"])
    assert not [mark for mark in sv.picture(even).marks if mark.part == "claimed-said"]  # nothing was rounded


def test_the_sentence_names_the_axis_of_a_claimed_gap_only_where_ranges_were_compared():
    runs = [run for run in (case.record() for case in SHOWN) if run.ended_by]
    alone = [min(len(run.ended_by.a.points), len(run.ended_by.b.points)) == 1 for run in runs]
    assert [" on axis " not in run.sentence for run in runs] == alone and 1 < sum(alone) < len(runs)


@pytest.mark.parametrize("name", [case.name for case in SHOWN if case.how == FALSE_HIT])
def test_no_dot_hides_an_overlap(name):
    drawn = sv.picture(name)
    bars = [mark.points for mark in drawn.marks if mark.part.endswith("-gap") and mark.kind == "interval"]
    for start, end in bars:
        dots = sum(mark.kind == "dot" and mark.points[0] in (start, end) for mark in drawn.marks)
        assert math.dist(start, end) - dots * DOT_PT / 2 >= min(math.dist(start, end), 1.4 * DOT_PT)


def test_no_two_panels_crowd_the_count_of_tests():
    drawn = sv.picture("many-pairs")
    assert "tests: 1,000" in drawn.texts and "tests: 499,500" in drawn.texts
    (number,) = (mark for mark in drawn.labels if mark.part == "actual-number")
    dots = [mark.points[0] for mark in drawn.marks if mark.part == "actual-shape"]
    assert number.points[0].y - text_size(number.text)[1] / 2 > max(p.y for p in dots)


def test_the_line_of_a_distance_is_as_long_as_the_distance():
    shapes = box(0, 0, 2, 2), sv.Circle((1, 1), 1), sv.Polygon([(0, 0), (4, 0), (4, 4), (3, 4), (3, 1), (0, 1)])
    others = box(5, 1, 7, 9), sv.Circle((2.5, 6), 1.5), sv.Polygon([(-3, -3), (8, -2), (1, -9)])
    for a in shapes:
        for b in others:
            trace = sv.record(a, b, axes=SHORTCUTS["gap-as-distance"])
            sketch = comparison_panels.draw_distance(trace, arrange([PanelContents([a, b])])[0])
            (p, q) = next(m.points for m in sketch.marks if m.part == "distance")
            assert math.dist(p, q) == pytest.approx(true_value.distance(a, b))


def test_the_arrows_of_separating_directions_stay_on_their_panel():
    for b in box(2.01, 0, 4, 1), box(2.01, -1, 2.2, 3), box(-0.1, 1.01, 30, 4), sv.Polygon([(1, 1.1), (3, 2), (2, 9)]):
        trace = sv.record(box(0, 0, 2, 1), b, axes=SHORTCUTS["only-one-axis"])
        sketch = comparison_panels.draw_separating_directions(trace, arrange([PanelContents([trace.a, b])])[0])
        x0, y0, x1, y1 = sketch.layout.limits
        assert all(x0 <= p.x <= x1 and y0 <= p.y <= y1 for m in sketch.marks if m.part == "fan" for p in m.points)


@each_case
def test_a_step_shows_no_more_than_its_sentence_and_its_labels_stay_in_the_next_step(case):
    trace = case.record()
    spots, before = {}, None
    for i, step in enumerate(sv.steps(trace)):
        if step.test is None:
            continue
        drawn = sv.picture(trace, i)
        if step.stage in (sv.Stage.EDGE, sv.Stage.NORMAL):
            assert not [m for m in drawn.marks if m.part == "claimed-axis"], step
        spots = spots if before == step[1:] else {}
        before = step[1:]
        for mark in drawn.labels:
            if mark.part.startswith("claimed-"):
                x, y = spots.setdefault((mark.id, mark.text), mark.points[0])
                assert mark.points[0] == pytest.approx((x, y), abs=0.5), (step, mark.text)


def pushes_on(size, count, text="push (-1234567890123, 9876543210987)"):
    """Return a picture of required labels alone, requested around the middle of a canvas of that size."""
    layout = Layout((0.0, 0.0, *size), size)
    spots = [sv.Vec(size[0] * (0.4 + 0.02 * i), size[1] / 2) for i in range(count)]
    requests = [LabelRequest("push", text, "move", spot, number=i) for i, spot in enumerate(spots)]
    return Picture(tuple(LabelPlacer(layout).labels(requests)), layout.limits, size, "", "")


@pytest.mark.parametrize("size, count", [((200.0, 80.0), 1), ((120.0, 160.0), 2), ((150.0, 200.0), 3)])
def test_a_label_too_long_for_its_place_is_broken_into_lines_and_not_cut_or_laid_on_another(size, count):
    drawn = pushes_on(size, count)
    assert no_overlap(drawn)
    assert {" ".join(mark.text.split()) for mark in drawn.labels} == {"push (-1234567890123, 9876543210987)"}
    assert len(drawn.labels) == count and any("\n" in mark.text for mark in drawn.labels)


def round_polygon(corners, x, y, size):
    turns = [2 * math.pi * (k + 0.3) / corners for k in range(corners)]
    return sv.Polygon([(x + size * math.cos(t), y + 0.6 * size * math.sin(t)) for t in turns])


OWN_PANELS = {"faces-in-3d"} ^ {
    case.name for case in FAILURE_CASES if case.panels != ("tests", "proof") or case.shortcut.split
}


@pytest.mark.parametrize("name", sorted(OWN_PANELS))
@pytest.mark.parametrize(
    "corners",
    one_in(4, [(7, 12), (3, 60), (30, 4), (60, 45)]),
    ids=str,
)
def test_panels_of_their_own_hold_their_words_for_shapes_of_any_number_of_corners(name, corners):
    a, b = round_polygon(corners[0], 0, 0, 2), round_polygon(corners[1], 1.3, 1, 1.5)
    for move in (0, 0), (5, 1):
        trace = sv.record(a, translated(b, sv.Vec(*move)), axes=SHORTCUTS[name])
        for drawn in sv.picture(trace), sv.picture(trace, largest=NARROW_PANEL_SIZES_PT[0]):
            assert no_overlap(drawn) and drawn.size[0] < 1125  # both panels hold the axes of both


@pytest.mark.parametrize("case", one_in(4, SHOWN), ids=lambda case: case.name)
def test_on_a_telephone_the_panels_stand_one_above_the_other(case):
    trace = case.record()
    shows = narrow_playbacks(trace)
    assert shows and shows[0]["size"][0] <= 350
    for step in 0, len(sv.steps(trace)) // 2, -1:
        drawn = sv.picture(trace, step, largest=(350, 700))
        saw, truth = (drawn.mark(f"{side}-heading").points[0] for side in ("claimed", "actual"))
        assert saw.x == truth.x and saw.y > truth.y + 100 and no_overlap(drawn)
        assert not [m for m in drawn.marks if m.part.startswith("claimed-") for p in m.points if p.y < truth.y]


LARGER = [pytest.param(size, marks=pytest.mark.slow) for size in ((3.1, 4.6), (4.3, 4.3), (9.0, 1.5))]


@pytest.mark.parametrize("size", [(2.3, 2.3), *LARGER])
@pytest.mark.parametrize("name", one_in(4, [case.name for case in FAILURE_CASES]))
def test_both_panels_hold_on_axes_of_any_size(name, size):
    """On given Axes of any size each word is inside and none overlaps another (a small picture loops no more)."""
    fig = Figure(figsize=size)
    FigureCanvasAgg(fig)
    ax = fig.add_axes((0, 0, 1, 1))
    sv.draw(name, ax=ax)
    frame, boxes = ax.get_window_extent(), [text.get_window_extent() for text in ax.texts if text.get_text()]
    for i, one in enumerate(boxes):
        assert frame.x0 - 1 < one.x0 and one.x1 < frame.x1 + 1 and frame.y0 - 1 < one.y0 and one.y1 < frame.y1 + 1
        for other in boxes[:i]:
            wide = min(one.x1, other.x1) - max(one.x0, other.x0)
            assert wide < 3 or min(one.y1, other.y1) - max(one.y0, other.y0) < 4


def test_drawing_on_matplotlib_axes_of_zero_size_does_not_fail():
    ax = Figure(figsize=(3, 3)).add_axes((0.5, 0.5, 0.0, 0.0))
    for what in "lengths", "triangles":
        assert sv.draw(what, ax=ax)


def test_the_missing_edges_of_an_open_outline_are_dotted_and_those_of_no_other_case():
    for case in FAILURE_CASES:
        if case.how == REFUSED:
            continue
        marks = sv.picture(case.record()).marks
        missing = [mark for mark in marks if mark.part == "claimed-missing-edge"]
        assert [mark.owner for mark in missing] == (["A", "B"] if case.name == "open-outline" else [])
        for mark in missing:
            (whole,) = (m for m in marks if m.part == "claimed-outline" and m.owner == mark.owner)
            (line,) = (m for m in marks if m.part == "claimed-open-outline" and m.owner == mark.owner)
            assert mark.style.dash == DOTS and mark.role == mark.owner
            assert not whole.style.width and line.points == whole.points and {*mark.points} <= {*line.points}


def test_where_the_shapes_would_be_small_the_ranges_have_names_without_numbers():
    for case in FAILURE_CASES:
        if case.how == REFUSED:
            continue
        drawn = sv.picture(case.record())
        assert drawn.size[0] <= 700, case.name  # no panel is shown smaller than its letters were made for
        spots = [p for m in drawn.marks if m.part == "claimed-outline" for p in m.points]
        if len(spots) > 4:
            xs, ys = [p.x for p in spots], [p.y for p in spots]
            assert max(max(xs) - min(xs), max(ys) - min(ys)) > 70, case.name


def test_ticks_show_the_floats_between_which_a_rounded_gap_lies():
    drawn = sv.picture("unit-normals")
    ticks = [p.x for p in drawn.mark("claimed-inset-floats.1").points[::2]]
    steps = {round(q - p, 6) for p, q in pairwise(ticks)}
    assert len(steps) == 1
    bracket = drawn.mark("claimed-inset-gap.1").points
    assert (bracket[2].x - bracket[1].x) / steps.pop() == pytest.approx(2)  # the gap is two neighbouring floats wide
    for name, sides in ("one-maximum", ("claimed", "actual")), ("touch-on-paper", ("actual",)):
        drawn = sv.picture(name)
        for side in sides:
            assert any(m.part in (f"{side}-float", f"{side}-inset-floats") for m in drawn.marks)


def test_vertices_in_one_place_and_on_an_edge_have_rings():
    assert any(mark.part == "claimed-one-place" for mark in sv.picture("repeated-vertex").marks)
    assert [m.owner for m in sv.picture("no-area").marks if m.part == "fold"] == ["A", "B"]
    assert not [m for m in sv.picture("pentagram").marks if m.part == "fold"]


@each_case
def test_a_push_is_as_long_as_its_words_say_on_the_one_scale_of_both_panels(case):
    drawn, run = sv.picture(case.name), case.record()
    moves = [*(pair.mtv for pair in run.pairs), run.push, run.truth.known_mtv]
    lengths = [math.hypot(*move) for move in moves if move]
    edge = math.dist(*run.b.core[:2]) if len(run.b.core) > 1 else 0.0
    for mark in drawn.marks:
        panel, _, part = mark.part.partition("-")
        if part in ("mtv", "push") and edge:
            outline = next(m.points for m in drawn.marks if (m.part, m.owner) == (f"{panel}-outline", "B"))
            drawn_length = math.dist(*mark.points) / math.dist(*outline[:2]) * edge
            assert any(drawn_length == pytest.approx(length) for length in lengths)


def test_one_inset_of_a_panel_stands_in_a_free_corner_of_it():
    for name in "unit-normals", "touch-on-paper":
        drawn = sv.picture(name)
        assert drawn.size[1] < 400, name
        (corners,) = (mark.points for mark in drawn.marks if mark.part.endswith("-inset"))
        box_ = corners[0].x, corners[0].y, corners[2].x, corners[2].y
        for mark in drawn.marks:
            if mark.part in ("claimed-outline", "claimed-axis", "claimed-range") and mark.kind != "disc":
                for p, q in pairwise(mark.points):
                    side = drawn.size[0] / 2
                    if (p.x < side) is (box_[0] < side):
                        assert clip_segment(*p, *q, *box_) is None, (name, mark.id)


def test_an_overlap_is_struck_out_only_where_the_ranges_do_not_overlap_so_far():
    assert struck(sv.picture("range-inside")) == ["depth 1", "push (0, -1)"]
    assert "overlap 1" in struck(sv.picture("circles-turned-round"))


@pytest.mark.parametrize("b", [box(1, 1, 4, 3), box(2, 0, 4, 2), box(5, 0, 7, 2), sv.Polygon([(1, 1), (4, 1), (3, 3)])])
def test_evaluation_counts_of_gjk_and_sat_stand_beside_each_corner_and_add_up(b):
    case = NAMED["gjk-looks-less"]
    trace = sv.record(box(0, 0, 2, 2), b, axes=case.shortcut)
    drawn = sv.picture(trace)
    totals = case.claimed_value(trace), case.true_value(trace.a, trace.b)
    for panel, total in zip(("claimed", "actual"), totals, strict=True):
        times = {int(m.text[:-1]) for m in drawn.labels if m.part == f"{panel}-evaluations"}
        dots = sum(m.part == f"{panel}-evaluated" for m in drawn.marks)
        assert {k * dots for k in times} == {total} or (panel == "actual" and not dots)  # of many axes it shows one
    assert any(m.part == "claimed-evaluated" for m in drawn.marks)


def test_a_single_crossing_is_counted_in_the_singular():
    drawn = sv.picture(sv.record(box(0, 0, 1, 1), box(1, 1, 2, 2), axes=NAMED["edges-cross"].shortcut))
    assert drawn.mark("claimed-crossings").text == "4 edges and 4 edges: 1 crossing"


def test_a_raw_normal_lengthens_a_push_by_the_length_of_the_normal():
    drawn = sv.picture("raw-depth")
    arrows = {mark.part: mark.points for mark in drawn.marks if mark.kind == "arrow"}
    lengths = {part: math.dist(p, q) for part, (p, q) in arrows.items()}
    assert lengths["claimed-axis-push"] == pytest.approx(2 * lengths["actual-mtv"])
    assert lengths["claimed-push"] == pytest.approx(lengths["actual-axis-push"])
    assert {"read as 1.5", "read as 1", "normal 2 long:", "normal 1 long:"} <= set(drawn.texts)


def test_the_numbers_of_a_range_stand_beside_its_bar_where_there_is_space_and_else_its_name_stands_alone():
    numbers = set()
    for case in FAILURE_CASES:
        if case.how == REFUSED:
            continue
        drawn = sv.picture(case.record())
        ranges = [m for m in drawn.labels if m.part.endswith("range-name")]
        found = {
            axis: {"[" in m.text for m in ranges if (m.part, m.axis) == axis}
            for axis in {(m.part, m.axis) for m in ranges}
        }
        assert all(len(either) == 1 for either in found.values()), case.name  # those of both shapes, or neither
        numbers |= set().union(*found.values())
        bars = {(m.part, m.owner, m.axis): m.points for m in drawn.marks if m.kind == "interval"}
        for label in (m for m in drawn.labels if m.part.endswith("range-name") and "[" in m.text):
            p, q = bars[label.part.removesuffix("-name"), label.owner, label.axis]
            (x, y), (w, h) = label.points[0], text_size(label.text)
            steps = [(p.x + (q.x - p.x) * k / 20, p.y + (q.y - p.y) * k / 20) for k in range(21)]
            off = min(math.hypot(max(abs(x - u) - w / 2, 0), max(abs(y - v) - h / 2, 0)) for u, v in steps)
            assert off < 40, (case.name, label.text)
    assert numbers == {True, False}


def test_ranges_of_two_axes_that_are_equal_are_not_written_side_by_side():
    for case in FAILURE_CASES:
        if case.how == REFUSED:
            continue
        for drawn in sv.picture(case.record()), sv.picture(case.record(), largest=NARROW_PANEL_SIZES_PT[0]):
            ranges = [m for m in drawn.labels if m.part.endswith("range-name")]
            for one, other in combinations(ranges, 2):
                if (one.text, one.part) == (other.text, other.part) and one.axis != other.axis:
                    assert math.dist(one.points[0], other.points[0]) > 40, (case.name, one.text)


def test_where_another_axis_has_the_least_overlap_the_panel_of_the_truth_says_so():
    runs = [case.record() for case in FAILURE_CASES if case.how != REFUSED]
    said = [(run.shortcut.name, text) for run in runs for text in sv.picture(run).texts if "another axis" in text]
    assert said == [("mixed-signs", "overlap 1, way out 2\nleast on another axis: 1.414")]


def test_a_crossing_is_marked_on_an_edge_of_both_shapes():
    a = sv.Polygon([(0, 0), (7, 1), (2, 5)])
    for k in range(12):
        b = sv.Polygon([(3 + k / 4, -1), (8, 3 - k / 6), (1, 4)])
        sketch = comparison_panels.draw_edges(sv.record(a, b), arrange([PanelContents([a, b])])[0])
        rings = [m.points[0] for m in sketch.marks if m.part == "crossing"]
        assert rings
        for p in rings:
            for shape in (a, b):
                edges = pairwise([*shape.vertices, shape.vertices[0]])
                off = min(math.dist(p, u) + math.dist(p, v) - math.dist(u, v) for u, v in edges)
                assert off == pytest.approx(0, abs=1e-9)
