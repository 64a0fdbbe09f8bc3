"""Pictures: marks and numbers, never pixels."""

import json
import math
import re
from fractions import Fraction
from functools import cache, partial
from hashlib import md5
from itertools import combinations, pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from speeds import one_in

import satviz as sv
from satviz.engine import axes, describe
from satviz.pictures import LIGHT, THEMES, Mark, Stage, Step
from satviz.pictures.curve import unit_vector
from satviz.pictures.drag import KNOB_RADIUS_PT, decisive_test, drag_layout, drag_picture, free_axis_picture
from satviz.pictures.figures import FIGURES, STRIP
from satviz.pictures.float_geometry import clip_segment
from satviz.pictures.label_placer import RIM_PT
from satviz.pictures.layout import NARROW_SIZE_PT
from satviz.pictures.letters import text_size
from satviz.pictures.playback import first_row_numbers, table_rows
from satviz.pictures.theme import CHART_ROLES, DOT_PT, PICTURE_ROLES
from satviz.pictures.views import convex_parts
from satviz.scenes.article import SCENES
from satviz.scenes.failing import FAILURE_CASES, REFUSED
from satviz.scenes.named import ALL_SCENES, names, refused_case, scene
from satviz.scenes.shape_tools import box

L = sv.Polygon([(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)])
TRACES = {scene.name: scene.record() for scene in SCENES} | {
    "overlap": sv.record(sv.Polygon([(0, 1), (3, 2), (1, 5)]), sv.Polygon([(2, 3), (6, 2), (5, 6)])),
    "inside": sv.record(sv.Circle((0, 0), 3), sv.Circle((0.5, 0.5), 1)),
    "concentric": sv.record(sv.Circle((0, 0), 2), sv.Circle((0, 0), 1)),
    "touch": sv.record(box(0, 0, 2, 2), box(2, 1, 4, 3)),
    "corner": sv.record(box(0, 0, 2, 2), sv.Circle((3.5, 3.5), 1.8)),
    "concave hit": sv.record(L, sv.Circle((3.2, 3.2), 1.5)),
    "concave apart": sv.record(L, sv.Circle((9, 9), 1)),
    "two concave": sv.record(L, sv.Polygon([(3, 3), (7, 3), (7, 7), (5, 7), (5, 5), (3, 5)])),
}


def every_picture():
    """Yield functions that make the pictures: made at collection, they would cost each run two seconds."""
    for name, trace in TRACES.items():
        for i in range(len(sv.steps(trace))):
            yield f"{name} {i}", partial(sv.picture, trace, i)
            yield f"{name} {i} narrow", partial(sv.picture, trace, i, largest=NARROW_SIZE_PT)
        if trace.pairs:
            yield f"{name} convex parts", partial(convex_parts, trace)
        yield (
            f"{name} drag",
            lambda trace=trace: drag_picture(trace, drag_layout(trace), decisive_test(trace), show_mtv=True)[0],
        )
        yield f"{name} curve", partial(sv.gap_curve, trace.a, trace.b, 30)
    for figure in FIGURES:
        yield figure.stem, figure.picture


PICTURES = dict(every_picture())
each_run = pytest.mark.parametrize("run", dict.fromkeys(name.split()[0] for name in PICTURES))


def pictures_of(run):
    """Return (name, picture) of each picture of a run, or of one figure."""
    return [(name, pictured(name)) for name in PICTURES if name.split()[0] == run]


@cache
def pictured(name):
    return PICTURES[name]()


def boxes(picture):
    """Yield each label's box in points from the lower left."""
    x0, y0 = picture.limits[:2]
    for mark in picture.marks:
        if mark.kind == "label":
            w, h = text_size(mark.text, mark.weight)
            x, y = ((c - o) * picture.scale for c, o in zip(mark.points[0], (x0, y0)))
            yield mark, (x - w / 2, y - h / 2, x + w / 2, y + h / 2)


def meet(p, q):
    return p[0] < q[2] and q[0] < p[2] and p[1] < q[3] and q[1] < p[3]


def strokes(picture):
    """Yield the segments that a label must not cover, in points, without the dotted guides."""
    x0, y0 = picture.limits[:2]
    for mark in picture.marks:
        if mark.kind in ("outline", "segment", "arrow", "interval", "bracket"):
            points = [((p.x - x0) * picture.scale, (p.y - y0) * picture.scale) for p in mark.points]
            points += points[:1] if mark.kind == "outline" else []
            if mark.role != "guide" and mark.weight != "faint":
                yield from ((mark, p, q) for p, q in pairwise(points))


@each_run
def test_no_label_runs_over_another_or_off_the_canvas(run):
    for name, picture in pictures_of(run):
        placed = list(boxes(picture))
        for (one, p), (other, q) in combinations(placed, 2):
            assert of_one_text(one, other) or not meet(p, q), (name, one.text, other.text)
        width, height = picture.size
        for mark, (left, low, right, high) in placed:
            assert min(left, low, width - right, height - high) >= RIM_PT - 1, (name, mark)


@pytest.mark.parametrize("name", [figure.stem for figure in FIGURES])
def test_no_label_of_a_figure_covers_an_edge_or_a_dot(name):
    picture = pictured(name)
    for label, rect in boxes(picture):
        for mark, p, q in strokes(picture):
            assert clip_segment(*p, *q, *rect) is None, (label.text, mark.id)
        for mark in picture.marks:
            if mark.kind == "dot":
                x, y = ((c - o) * picture.scale for c, o in zip(mark.points[0], picture.limits))
                r = DOT_PT / 2
                assert not meet(rect, (x - r, y - r, x + r, y + r)), (label.text, mark.id)


@each_run
def test_marks_have_unique_ids_and_known_roles_and_lie_on_the_canvas(run):
    for name, picture in pictures_of(run):
        ids = [mark.id for mark in picture.marks]
        assert len(ids) == len(set(ids)), name
        x0, y0, x1, y1 = picture.limits
        for mark in picture.marks:
            assert mark.role in LIGHT.roles
            for p in mark.points:
                assert x0 - 1e-9 <= p.x <= x1 + 1e-9 and y0 - 1e-9 <= p.y <= y1 + 1e-9, (name, mark)
        assert picture.sentence, name


@pytest.mark.parametrize("name", TRACES)
def test_nothing_jumps_while_a_test_is_drawn(name):
    trace = TRACES[name]
    pictures = [(step, sv.picture(trace, step)) for step in sv.steps(trace)]
    assert len({p.size for _, p in pictures}) == 1
    assert max(p.scale for _, p in pictures) == pytest.approx(min(p.scale for _, p in pictures), rel=1e-12)
    spots = {}
    for step, picture in pictures:
        if step.stage in (Stage.AXIS, Stage.DROPS, Stage.RANGE, Stage.BOTH, Stage.GAP):
            assert spots.setdefault((step.pair, step.test), picture.limits) == picture.limits
            for mark in picture.labels:
                if mark.part not in ("normal-name", "lowest", "highest"):  # those of one stage alone
                    at = spots.setdefault((step.pair, step.test, mark.id), mark.points)
                    assert at == mark.points, mark.id
        for mark in picture.labels if step.stage is not Stage.VERDICT else ():
            if mark.part == "name":
                assert spots.setdefault((step.pair, mark.id, mark.text), mark.points) == mark.points


@pytest.mark.parametrize("name", [scene.name for scene in ALL_SCENES])
def test_no_shape_moves_between_the_steps_of_a_run(name):
    trace = sv.scene(name).record()
    places = {}
    for step in sv.steps(trace):
        if step.test is None or step.stage is Stage.GAP:
            picture = sv.picture(trace, step)
            for mark in picture.marks:
                if mark.part.endswith("outline") and mark.weight == "plain":
                    spot = [((p.x - picture.limits[0]) * picture.scale, p.y * picture.scale) for p in mark.points]
                    corner = picture.limits[1] * picture.scale
                    at = [(round(x, 6), round(y - corner, 6)) for x, y in spot]
                    assert places.setdefault(mark.id, at) == at, (step, mark.id)
    assert len(places) >= 2


@pytest.mark.parametrize("case", [case for case in FAILURE_CASES if case.how != REFUSED], ids=lambda case: case.name)
def test_both_panels_show_the_shapes_at_one_place_and_scale(case):
    picture = sv.picture(case.record())
    offset = set()
    for owner in "AB":
        ids = [f"{owner}.{side}-outline" for side in ("claimed", "actual")]
        left, right = ([m for m in picture.marks if m.id == mark_id] for mark_id in ids)
        for m, n in zip(left, right, strict=False):
            assert len(m.points) == len(n.points)
            offset |= {(round(q.x - p.x, 6), round(q.y - p.y, 6)) for p, q in zip(m.points, n.points)}
    assert len(offset) <= 1


@pytest.mark.parametrize("name", [figure.stem for figure in FIGURES])
def test_no_half_of_a_figure_is_empty(name):
    (scene,) = (figure.scene for figure in FIGURES if figure.stem == name)
    sequence = [pictured(figure.stem) for figure in FIGURES if figure.scene == scene]
    frame = pictured(name).limits
    marks = [m for picture in sequence if picture.limits == frame for m in picture.marks]
    x0, y0, x1, y1 = frame
    for i, (lo, hi) in enumerate(((x0, x1), (y0, y1))):
        spots = [p[i] + r for m in marks for p in m.points for r in (m.radius, -m.radius)]
        assert min(spots) < lo + 0.3 * (hi - lo) and max(spots) > hi - 0.3 * (hi - lo)


@pytest.mark.parametrize("number", [2, 3, 5, 12, 14, 20])
def test_a_ranges_label_stands_on_its_bars_own_side(number):
    picture = FIGURES[number - 1].picture()
    for label in picture.labels:
        if label.part == "range-name":
            own = (label.axis, label.panel)
            (axis,) = (m.points for m in picture.marks if (m.part, m.axis, m.panel) == ("axis", *own))
            (bar, _), *_ = (
                m.points for m in picture.marks if (m.part, m.axis, m.panel, m.owner) == ("range", *own, label.owner)
            )
            assert beyond(*axis, bar) * beyond(*axis, label.points[0]) > 0, label.text


def of_one_text(m, n):
    """Return whether both labels are pieces of one text with several colours."""
    return m.part == n.part and m.part in ("landing-sum", "turn-name")


def beyond(p, q, r):
    """Return a number whose sign says on which side of the line from p to q the point r lies."""
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)


def test_an_axis_shows_where_0_lies_on_it():
    n = TRACES["triangles"].tests[0].axis.direction
    picture = sv.picture(TRACES["triangles"], Step(Stage.AXIS, 0))
    assert [r.x * n.x + r.y * n.y for r in picture.mark("zero.1").points] == pytest.approx([0, 0], abs=1e-9)
    assert picture.mark("zero-name.1").text == "0"


@pytest.mark.parametrize("name", TRACES)
def test_bars_brackets_and_numbers_are_those_of_the_trace(name):
    trace = TRACES[name]
    for run, pair in [(t, i) for i, t in enumerate(trace.pairs)] or [(trace, None)]:
        for i, test in enumerate(run.tests):
            picture = sv.picture(trace, Step(Stage.GAP, i, pair))
            n = test.axis.direction
            digits = describe.digits(run, test)
            for side, who, text in zip((test.a, test.b), run.names, digits.ranges(test), strict=True):
                mark = picture.mark(f"{who}.range.{i + 1}")
                along = [p.x * n.x + p.y * n.y for p in mark.points]
                assert along == pytest.approx(list(side.interval), abs=1e-9)
                assert picture.mark(f"{who}.range-name.{i + 1}").text == f"{who} {text}"
            gap = picture.mark(f"gap.{i + 1}")
            along = [p.x * n.x + p.y * n.y for p in gap.points]
            a, b = test.a.interval, test.b.interval
            shared = min(a.hi, b.hi) - max(a.lo, b.lo)
            assert max(along) - min(along) == pytest.approx(abs(shared), abs=1e-9)
            assert test.gap <= 0 or -shared == pytest.approx(test.gap)
            assert gap.role == ("overlap" if test.gap < 0 else "gap")
            assert picture.mark(f"gap-name.{i + 1}").text == describe.picture_outcome(test, digits)
            assert picture.sentence == describe.test_sentence(run, i)


@pytest.mark.parametrize("name", TRACES)
def test_the_axis_is_clear_of_both_shapes(name):
    trace = TRACES[name]
    for i, step in enumerate(sv.steps(trace)):
        if step.stage is not Stage.GAP:
            continue
        picture = sv.picture(trace, i)
        for mark in picture.marks:
            if mark.kind in ("interval", "bracket") or mark.part == "axis":
                for shape in (trace.a, trace.b):
                    assert apart(mark.points, shape), (mark.id, shape)


def apart(points, shape):
    """Return whether a drawn line is apart from the shape, with a thin triangle in place of the line."""
    p, q = points[0], points[-1]
    if p == q:
        return True
    sliver = sv.Polygon([p, q, (q.x - (q.y - p.y) * 1e-6, q.y + (q.x - p.x) * 1e-6)])
    return sv.relate(sliver, shape) is sv.Relation.APART


def test_drop_lines_run_across_the_axis_from_the_points_to_where_they_land():
    trace = TRACES["triangles"]
    picture = sv.picture(trace, Step(Stage.DROPS, 0))
    n = trace.tests[0].axis.direction
    drops = [m for m in picture.marks if m.part == "drop"]
    assert len(drops) == 3
    for mark in drops:
        p, q = mark.points[0], mark.points[-1]
        assert (q.x - p.x) * n.x + (q.y - p.y) * n.y == pytest.approx(0, abs=1e-12)
    assert {"v3: 3.051", "v1, v2: 6.934"} <= set(picture.texts)


VECTOR = r"\((\S+), (\S+)\)"


def vectors(text):
    """Return every (x, y) in a text."""
    return [tuple(float(c.replace("−", "-")) for c in found) for found in re.findall(VECTOR, text)]


def same_way(one, other):
    (ax, ay), (bx, by) = one, other
    return ax * bx + ay * by == pytest.approx(math.hypot(ax, ay) * math.hypot(bx, by), rel=1e-4)


@pytest.mark.parametrize("name", one_in(2, [name for name in names() if not refused_case(name)]))
def test_an_axis_has_one_direction_in_table_sentence_and_arrow_and_its_normal_that_or_the_opposite_one(name):
    """A normal is drawn out of its shape; where the axis points the other way, the sentence says both."""
    trace = scene(name).record().without_early_exit()
    table, begins = table_rows(trace), first_row_numbers(trace)
    for step in sv.steps(trace):
        if step.test is None:
            continue
        test = (trace.pairs[step.pair] if trace.pairs else trace).tests[step.test]
        if not any(test.axis.normal):
            continue  # two vertices in one place
        picture = sv.picture(trace, step)
        listed = table[begins[step.pair or 0] + step.test]["direction"]
        marks = {mark.part.removeprefix("claimed-"): mark for mark in picture.marks}
        ways, normals = [vectors(listed)[0]], []
        for key, some in ("axis", ways), ("normal", normals):
            if key in marks:
                p, q = marks[key].points
                some.append((q.x - p.x, q.y - p.y))
        if label := marks.get("normal-name"):
            normals += vectors(label.text)
        if test.source.kind not in axes.FROM_EDGES and "edge-name" in marks:
            ways += vectors(marks["edge-name"].text)
        if step.stage is Stage.AXIS:
            assert picture.sentence.endswith(f"direction {listed}.")
        if step.stage is Stage.NORMAL and test.source.kind in axes.FROM_EDGES:
            _, normal, *direction = vectors(picture.sentence)
            assert label is None or vectors(label.text) == [normal]
            normals.append(normal)
            ways += direction or [normal]
        assert all(same_way(way, test.axis.direction) for way in ways), (step, ways)
        sign = 1 if describes_outward(trace.pairs[step.pair] if trace.pairs else trace, test) else -1
        assert all(same_way((sign * x, sign * y), test.axis.direction) for x, y in normals), (step, normals)


def describes_outward(trace, test):
    """Return whether a small step along the axis from the middle of its edge leaves the shape, by the oracle."""
    kind, role, ids = test.source
    if kind not in (axes.EDGE, axes.HULL):
        return True
    polygon = (trace.a, trace.b)["AB".index(role)]
    (px, py), (qx, qy) = (map(Fraction, polygon.vertices[i]) for i in ids)
    n, step = test.axis.normal, Fraction(1, 2**40)
    x, y = (px + qx) / 2 + step * Fraction(n[0]), (py + qy) / 2 + step * Fraction(n[1])
    ring = [tuple(map(Fraction, v)) for v in polygon.core]
    if kind == axes.HULL:
        return all((vx - px) * Fraction(n[0]) + (vy - py) * Fraction(n[1]) <= 0 for vx, vy in ring)
    crossed = sum(
        (ay > y) != (by > y) and x < ax + (y - ay) * (bx - ax) / (by - ay)
        for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1])
    )
    return crossed % 2 == 0


def test_a_normal_that_points_against_its_axis_is_drawn_outward_and_the_sentence_says_both():
    picture = sv.picture(TRACES["triangles"], Step(Stage.NORMAL, 1))
    assert "normal\n(−4, 1)" in picture.texts
    assert picture.sentence.endswith("A quarter turn makes it the normal (−4, 1); axis 2 of 6 takes it as (4, −1).")
    (p, q), (lo, hi) = (
        picture.mark("normal").points,
        sv.picture(TRACES["triangles"], Step(Stage.AXIS, 1)).mark("axis.2").points,
    )
    assert same_way((p.x - q.x, p.y - q.y), (hi.x - lo.x, hi.y - lo.y))


@pytest.mark.parametrize("at", [(-3, 0), (0, -3), (-2, -3)])
def test_the_line_between_two_centers_has_the_direction_of_the_axis(at):
    """This holds also if B is to the left of A or below it: an axis points right, or up."""
    circle = sv.Circle((0, 0), 1)
    for b in sv.Circle(at, 1), sv.Polygon([(x + at[0], y + at[1]) for x, y in [(0, 0), (-3, 1), (-1, -4)]]):
        for trace in (sv.record(circle, b, every_axis=True), sv.record(b, circle, every_axis=True)):
            *_, test = trace.tests
            assert test.source.kind in (axes.CENTERS, axes.VERTEX)
            drawn = sv.picture(trace, Step(Stage.NORMAL, len(trace.tests) - 1))
            assert vectors(drawn.mark("edge-name").text) == [test.axis.normal]


def test_a_mark_that_moves_starts_where_it_comes_from():
    """This holds also in the verdict of a run over every axis, after the steps of another axis."""
    trace = TRACES["triangles"].without_early_exit()
    i = trace.tests.index(trace.separating)
    gap = sv.picture(trace, Step(Stage.GAP, i))
    axes = [picture.mark(f"axis.{i + 1}").start for picture in (gap, sv.picture(trace))]
    assert axes == [gap.mark("normal").points[::-1]] * 2  # drawn outward, against the axis
    drops, landings = ([m for m in gap.marks if m.part == part] for part in ("drop", "landing"))
    assert len(drops) == 4 and [(m.points[0], m.points[-1]) for m in drops] == [(*m.start, *m.points) for m in landings]


def test_no_picture_depends_on_the_text_of_an_id(monkeypatch):
    named, plain = Mark.id.fget, [pictured(figure.stem) for figure in FIGURES]
    monkeypatch.setattr(Mark, "id", property(lambda mark: md5(named(mark).encode()).hexdigest()))
    assert [figure.picture() for figure in FIGURES] == plain


def test_steps_run_from_the_scene_over_every_stage_to_the_verdict():
    stages = [step.stage for step in sv.steps(TRACES["triangles"])]
    assert stages[0] is Stage.SCENE and stages[-1] is Stage.VERDICT
    assert [s.value for s in stages[1:8]] == ["edge", "normal", "axis", "drops", "range", "both ranges", "gap"]
    assert [s.stage.value for s in sv.steps(TRACES["aabb"])][1:3] == ["axis", "drops"]  # no edge to show
    assert sv.steps(TRACES["concave"])[1].stage is Stage.PARTS


def test_a_step_the_trace_does_not_have_is_an_index_error():
    with pytest.raises(IndexError, match="steps 0 to 15"):
        sv.picture(TRACES["triangles"], 16)
    with pytest.raises(IndexError):
        sv.picture(TRACES["triangles"], Step(Stage.GAP, 5))


def test_every_field_of_a_picture_is_in_its_json():
    picture = pictured("14-sat-ranges-gap")
    data = json.loads(picture.to_json())
    assert data == picture.data()
    assert [m["id"] for m in data["marks"]] == [m.id for m in picture.marks]
    assert data["sentence"] == picture.sentence and data["limits"] == list(picture.limits)


def test_labels_are_text_and_never_markup():
    odd = sv.Polygon([(0, 0), (2, 0), (0, 2)], labels=["$x^2$", "<b>&amp;", "a_b 日本"])
    texts = sv.picture(sv.record(odd, box(3, 3, 4, 4)), 0).texts
    assert {"$x^2$", "<b>&amp;", "a_b 日本"} <= set(texts)


@pytest.mark.parametrize(
    "label", ["می\u200cخواهم", "👨\u200d👩\u200d👧", "א\u200f!"], ids=["Persian", "family", "Hebrew"]
)
def test_a_label_keeps_the_signs_that_join_and_turn_its_letters(label):
    trace = sv.record(sv.Polygon([(0, 0), (2, 0), (0, 2)], labels=[label, "\u202e", "\x1b"]), box(3, 3, 4, 4))
    assert {label, "\ufffd"} <= set(sv.picture(trace, 0).texts)


def luminance(colour):
    return luminance_of(*linear(colour))


def luminance_of(r, g, b):
    return 0.2126 * r + 0.7152 * g + 0.0722 * b


def linear(colour):
    parts = [int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5)]
    return [c / 12.92 if c <= 0.03928 else ((c + 0.055) / 1.055) ** 2.4 for c in parts]


@pytest.mark.parametrize("theme", THEMES.values(), ids=THEMES)
def test_colours_have_enough_contrast(theme):
    def ratio(colour):
        low, high = sorted((luminance(colour), luminance(theme.paper)))
        return (high + 0.05) / (low + 0.05)

    for role in theme.roles:
        assert ratio(theme.roles[role]) >= 3, role
        assert ratio(theme.text.get(role, theme.roles[role])) >= 4.5, role


# what red-blind, green-blind and blue-blind eyes make of red, green and blue (Machado and others, 2009)
EYES = {
    "normal": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    "red-blind": ((0.152, 1.053, -0.205), (0.115, 0.786, 0.099), (-0.004, -0.048, 1.052)),
    "green-blind": ((0.367, 0.861, -0.228), (0.280, 0.673, 0.047), (-0.012, 0.043, 0.969)),
    "blue-blind": ((1.256, -0.077, -0.179), (-0.078, 0.931, 0.148), (0.005, 0.691, 0.304)),
}


def lab(colour, eye):
    """Return the CIELAB coordinates of a colour as an eye sees it."""
    r, g, b = (min(1, max(0, sum(m * c for m, c in zip(row, linear(colour))))) for row in EYES[eye])
    sums = (
        (0.412 * r + 0.358 * g + 0.180 * b) / 0.950,
        luminance_of(r, g, b),
        (0.019 * r + 0.119 * g + 0.950 * b) / 1.089,
    )
    x, y, z = (t ** (1 / 3) if t > 0.008856 else 7.787 * t + 16 / 116 for t in sums)
    return 116 * y - 16, 500 * (x - y), 200 * (y - z)


@pytest.mark.parametrize("eye", EYES)
@pytest.mark.parametrize("roles", [PICTURE_ROLES, CHART_ROLES], ids=["pictures", "charts"])
@pytest.mark.parametrize("theme", THEMES.values(), ids=THEMES)
def test_every_meaning_has_a_colour_of_its_own_for_every_eye(theme, roles, eye):
    for one, other in combinations(roles, 2):
        assert math.dist(lab(theme.roles[one], eye), lab(theme.roles[other], eye)) > 9, (one, other)


def test_gap_mtv_and_wrong_have_different_colours():
    picture = sv.picture(TRACES["overlap"])
    assert picture.mark("mtv").role == "move"
    wrong = sv.picture(TRACES["aabb-rotated"]).mark("verdict")
    assert (wrong.role, wrong.text) == ("wrong", "AABB says: hit. Truth: apart.")


def test_the_parts_that_a_verdict_names_are_drawn():
    for name in ("concave hit", "concave apart", "two concave"):
        picture = sv.picture(TRACES[name])
        drawn = {mark.owner for mark in picture.marks if mark.kind in ("outline", "disc")}
        lines = [mark.text for mark in picture.labels if mark.part == "part-line-name"]
        assert {part for text in lines for part in text.removeprefix("between\n").split(" and ")} <= drawn
        hit = TRACES[name].colliding
        assert lines if hit is None else set(hit.names) <= drawn


@pytest.mark.parametrize("scale", [1e-200, 1e-6, 1.0, 1e6, 1e200])
def test_scenes_of_any_size_are_drawn_alike(scale):
    a = sv.Polygon([(0, 0), (2 * scale, 0), (0, 2 * scale)])
    b = sv.Polygon([(3 * scale, 0), (5 * scale, scale), (3 * scale, 2 * scale)])
    picture = sv.picture(sv.record(a, b), 3)
    assert max(picture.size) <= 500


def test_a_scene_too_far_out_to_draw_says_so():
    trace = sv.record(box(1e15, 0, 1e15 + 1, 1), box(1e15 + 2, 0, 1e15 + 3, 1))
    with pytest.raises(ValueError, match="cannot be drawn"):
        sv.picture(trace, 0)


@st.composite
def shapes(draw):
    x, y = draw(st.integers(-6, 6)), draw(st.integers(-6, 6))
    if draw(st.booleans()):
        return sv.Circle((x, y), draw(st.integers(1, 4)))
    points = draw(st.lists(st.tuples(st.integers(-4, 4), st.integers(-4, 4)), min_size=3, max_size=6, unique=True))
    try:
        return sv.Polygon([(x + p, y + q) for p, q in points], labels=[f"p{i}" for i in range(len(points))])
    except sv.InvalidShape:
        return box(x, y, x + 2, y + 3)


@given(shapes(), shapes())
@settings(max_examples=25, deadline=None)
def test_any_scene_is_drawn_at_every_step_with_its_labels_apart(a, b):
    trace = sv.record(a, b)
    for i in range(len(sv.steps(trace))):
        picture = sv.picture(trace, i)
        placed = list(boxes(picture))
        overlaps = [
            (m.text, n.text) for (m, p), (n, q) in combinations(placed, 2) if not of_one_text(m, n) and meet(p, q)
        ]
        assert not overlaps, (a, b, i, overlaps)
        width, height = picture.size
        for mark, (left, low, right, high) in placed:
            inside = left >= 0 and low >= 0 and right <= width and high <= height
            assert inside, (a, b, i, mark)


def test_where_one_range_contains_the_other_overlap_and_depth_are_both_named():
    trace = sv.record(box(0, 0, 10, 1), box(4, 0, 5, 1))
    assert "overlap 1, way out 5" in describe.test_sentence(trace, 1)
    picture = sv.picture(trace, Step(Stage.GAP, 1))
    (p, q) = picture.mark("gap.2").points
    assert q.x - p.x == pytest.approx(1)


@pytest.mark.parametrize(
    "shape",
    [
        sv.Polygon([(0, 0), (0, -1), (1, 0), (-1, 1)], labels=["p0", "p1", "p2", "p3"]),  # its parts have a new vertex
        sv.Polygon([(0, 0), (2, 0), (0, 2)], labels=["a", "", "c"]),
    ],
)
def test_vertices_without_a_label_among_labelled_ones_are_drawn(shape):
    trace = sv.record(shape, sv.Circle((0.5, 0.5), 1))
    for i in range(len(sv.steps(trace))):
        assert sv.picture(trace, i).marks


def test_a_part_pair_that_is_apart_does_not_say_that_the_shapes_are():
    trace = sv.record(sv.Polygon([(1, 3), (3.5, 3), (3.5, 3.5), (1, 3.5)]), L)
    apart = next(pair for pair in trace.pairs if pair.separating)
    assert trace.hit and "so A and B1 are apart" in describe.test_sentence(apart, len(apart.tests) - 1)


def test_every_choice_of_axes_can_be_drawn():
    for name, choose in axes.NAMED.items():
        trace = sv.record(L, sv.Circle((3, 3.5), 0.4), axes=choose, every_axis=True)
        for i in range(len(sv.steps(trace))):
            assert sv.picture(trace, i).sentence, name


def test_a_corners_name_stands_on_its_side_of_the_separating_line():
    square = sv.Polygon([(0, 0), (1, 0), (1, 1), (0, 1)], labels=["p", "q", "r", "s"])
    trace = sv.record(square, sv.Circle((1.8, 1.8), 1))
    spot = sv.picture(trace).mark("A.vertex-name.2").points[0]
    (nx, ny), offset = trace.certificate.normal, trace.certificate.offset
    assert (nx * spot.x + ny * spot.y > offset) == (nx * 1 + ny * 1 > offset)


@pytest.mark.parametrize("degree", range(0, 360, 30))
def test_no_label_lies_under_the_knob_of_a_free_axis(degree):
    scene = sv.scene("triangles")
    trace = sv.record(scene.a, scene.b, axes=axes.directions(unit_vector(degree)))
    drawn, _ = free_axis_picture(trace, drag_layout(trace), degree)
    knob = drawn.mark("knob").points[0]
    x, y = (knob.x - drawn.limits[0]) * drawn.scale, (knob.y - drawn.limits[1]) * drawn.scale
    grip = x - KNOB_RADIUS_PT, y - KNOB_RADIUS_PT, x + KNOB_RADIUS_PT, y + KNOB_RADIUS_PT
    assert not [mark.text for mark, box in boxes(drawn) if meet(grip, box)]


SQUARE = sv.Polygon([(0, 0), (1, 0), (1, 1), (0, 1)])


@pytest.mark.parametrize("thing", [SQUARE, sv.Circle((0, 0), 1), None, [SQUARE, SQUARE]])
@pytest.mark.parametrize("show", ["picture", "steps", "draw", "page", "play"])
def test_only_a_trace_has_steps_and_the_error_says_how_to_make_one(show, thing):
    with pytest.raises(TypeError, match=rf"is a {type(thing).__name__}: .*record"):
        getattr(sv, show)(thing)
    if show == "play":
        with pytest.raises(TypeError, match=rf"is a {type(thing).__name__}: .*record"):
            sv.play(thing, pen="matplotlib")


@pytest.mark.parametrize("step", ["x", 1.5, None, [1]])
def test_a_step_that_is_neither_a_number_nor_a_step_object_is_refused(step):
    with pytest.raises(TypeError, match="step is"):
        sv.picture(sv.scene("aabb").record(), step)


def test_a_curve_needs_two_shapes_and_an_angle():
    for a, b in ((SQUARE, 5), ("x", SQUARE), (sv.scene("aabb"), SQUARE)):
        with pytest.raises(TypeError, match=r"make it a satviz\.Polygon"):
            sv.gap_curve(a, b)
        with pytest.raises(TypeError, match=r"make it a satviz\.Polygon"):
            next(sv.axis_tests(a, b))
    for degree in ("x", float("nan"), float("inf"), [1]):
        with pytest.raises((TypeError, ValueError), match="degree is"):
            sv.gap_curve(SQUARE, SQUARE, degree)


def test_a_picture_by_itself_has_no_space_for_the_contents_of_other_steps():
    trace = sv.scene("triangles").record()
    first, whole = sv.picture(trace, 0, by_itself=True), sv.picture(trace, 0)
    assert first.size[1] < 0.6 * whole.size[1] and first.scale >= whole.scale


@pytest.mark.parametrize("options", [{}, {"largest": NARROW_SIZE_PT, "by_itself": True}], ids=["wide", "narrow"])
def test_no_separating_line_runs_through_the_heading(options):
    lines = 0
    for name in (n for n in names()[1::3] if refused_case(n) is None):  # with aabb-rotated
        drawn = sv.picture(name, **options)
        for heading in (m for m in drawn.labels if m.weight == "title" and m.part.endswith("verdict")):
            (x, y), (w, h) = heading.points[0], (side / drawn.scale for side in text_size(heading.text, "title"))
            around = x - w / 2, y - h / 2, x + w / 2, y + h / 2
            for mark in (m for m in drawn.marks if m.kind == "segment" and m.part.endswith("line")):
                lines += 1
                assert clip_segment(*mark.points[0], *mark.points[1], *around) is None, (name, heading.text)
    assert lines > 3


def test_two_panels_have_one_canvas_for_every_way_to_request_them():
    trace = sv.scene("far-centers").record()
    assert sv.picture(trace, 0, by_itself=True) == sv.picture(trace, 0)


def test_the_sentence_about_a_normal_turns_its_edge_by_a_quarter_and_gives_its_numbers():
    trace = sv.scene("triangles").record().without_early_exit()
    for i in range(len(trace.tests)):
        said = sv.picture(trace, sv.Step(sv.Stage.NORMAL, i)).sentence.replace("\N{MINUS SIGN}", "-")
        (x, y), normal, *turned = ((float(x), float(y)) for x, y in re.findall(r"\(([-.\d]+), ([-.\d]+)\)", said))
        made = f"A quarter turn makes it the normal ({normal[0]:g}, {normal[1]:g})"
        assert f"{made}; axis {i + 1} of" in said if turned else f"{made}, the direction of axis {i + 1}" in said
        assert normal in ((y, -x), (-y, x))
        assert not turned or turned == [(-normal[0], -normal[1])]


OTHER_WORDING = re.compile(
    r"gap [-\N{MINUS SIGN}]|gap \d*[1-9]|overlaps? by|overlap [-+\N{MINUS SIGN}]|^\S+ long", re.M
)


@pytest.mark.parametrize("name", one_in(4, [scene.name for scene in ALL_SCENES]))
def test_every_picture_says_gap_and_overlap_in_one_wording(name):
    trace = sv.scene(name).record()
    pictures = [sv.picture(trace, step) for step in sv.steps(trace)[-2:]]
    pictures += [sv.sheet(trace), sv.difference(trace), *sv.sweep(trace, step=45)]
    for text in (text for picture in pictures for text in (*picture.texts, picture.sentence)):
        assert not OTHER_WORDING.search(text), text


def test_a_small_circle_is_round_in_its_inset():
    drawn = sv.picture(sv.record(sv.Circle((0, 0), 500), sv.Circle((501, 2), 0.5)))
    rim = drawn.mark("B.inset-edge.1").points
    xs, ys = [p.x for p in rim], [p.y for p in rim]
    middle = (min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2
    assert max(math.dist(p, middle) for p in rim) < 1.05 * min(math.dist(p, middle) for p in rim)
    far = drawn.mark("A.inset-edge.1").points
    assert max(abs(math.dist(p, (far[0].x, p.y))) for p in far) < 3  # the rim of A is nearly straight there


def regular(x, y, count, turn):
    angles = [2 * math.pi * k / count + turn for k in range(count)]
    return sv.Polygon([(x + 2 * math.cos(t), y + 2 * math.sin(t)) for t in angles])


def test_the_normals_of_many_untested_edges_do_not_fill_the_gap():
    trace = sv.record(regular(0, 0, 40, 0.1), regular(4.5, 0.6, 40, 0.2))
    assert not [m for m in sv.picture(trace, -2).marks if m.part == "untested"]
    few = sv.scene("triangles").record()
    assert len([m for m in sv.picture(few, -2).marks if m.part == "untested"]) == 4


def test_no_arrow_head_hides_a_short_edge():
    needle = sv.Polygon([(0, 0), (10, 0), (10, 0.15)])
    trace = sv.record(sv.Polygon([(3, 1), (6, 1), (5, 4)]), needle, every_axis=True)
    for i, test in enumerate(trace.tests):
        drawn = sv.picture(trace, Step(Stage.EDGE, i))
        edge = next(m for m in drawn.marks if m.part == "edge")
        assert math.dist(*edge.points) * drawn.scale > 1.5 * edge.style.head[0], test.source


def test_a_label_far_from_its_corner_has_a_line_to_it_or_is_left_out():
    names = [f"the {word} corner of this shape" for word in ("first", "second", "third", "fourth", "fifth", "sixth")]
    for seed in range(8):
        turn = seed / 7
        a = sv.Polygon(regular(0, 0, 6, turn).vertices, labels=names)
        b = sv.Polygon(regular(2.2, 0.4, 6, turn / 2).vertices, labels=names)
        for drawn in sv.picture(sv.record(a, b)), sv.picture(sv.record(a, b), 1):
            marks = {(m.part, m.owner, m.number): m for m in drawn.marks}
            for (part, owner, number), label in marks.items():
                if part == "vertex-name" and (part + "-leader", owner, number) not in marks:
                    (x, y), (w, h) = label.points[0], (side / 2 / drawn.scale for side in text_size(label.text))
                    v = marks["vertex", owner, number].points[0]
                    off = math.hypot(max(0.0, abs(v.x - x) - w), max(0.0, abs(v.y - y) - h))
                    assert off * drawn.scale < 30, label.text


@pytest.mark.parametrize("figure", (*FIGURES, STRIP), ids=lambda f: f.name)
def test_a_figure_is_as_narrow_as_a_telephones_page_so_that_no_letter_is_made_smaller_there(figure):
    drawn = figure.picture()
    assert drawn.size[0] <= 340 and min(label.style.size for label in drawn.labels) >= 11


@pytest.mark.parametrize("figure", FIGURES, ids=lambda f: f.name)
def test_a_figures_sentence_says_each_gap_and_overlap_that_is_drawn(figure):
    drawn = figure.picture()
    for label in drawn.labels:
        if label.part == "gap-name":
            assert label.text.split("\n")[0].split()[-1].strip("+") in drawn.sentence, label.text


def test_a_picture_says_what_it_leaves_out_and_why():
    assert "(parallel to axis 2)" in " ".join(FIGURES[13].picture().texts)
    assert any("Shown: 3 of 9 axes" in text for text in FIGURES[18].picture().texts)


@pytest.mark.parametrize("number", [5, 16, 20])
def test_the_panels_of_a_figure_stand_one_below_the_other(number):
    drawn = FIGURES[number - 1].picture()
    tops = {mark.panel: mark.points[0].y for mark in drawn.marks if mark.part == "verdict"}
    assert len(set(tops.values())) == len(tops) >= 2  # one below the other
