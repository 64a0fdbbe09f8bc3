"""What a trace records, what it says, and what follows from it."""

import json
from fractions import Fraction
from math import hypot

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from strategies import CONVEX, pairs

import satviz as sv
from satviz import axes, telling
from satviz.escape import ends_overlap
from satviz.scenes import SCENES, box
from satviz.verdict import relate_moved

A = sv.Polygon([(0, 1), (3, 2), (1, 5)])
B = sv.Polygon([(5, 5), (8, 3), (4, 1)], labels=["v1", "v2", "v3"])
L = sv.Polygon([(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)])
SOME = list(pairs(5, 400, [kind for kind in CONVEX if kind != "many corners"]))


def close(value, expected):
    return value == pytest.approx(expected, abs=5e-4)


def test_the_articles_triangles_give_the_articles_numbers():
    trace = sv.record(A, B, axes=axes.edge_normals)
    first, second = trace.tests
    assert first.axis.normal == (2, 3) and second.axis.normal == (4, -1)
    assert close(first.a.interval, (0.832, 4.715)) and close(first.b.interval, (3.051, 6.934))
    assert close(first.gap, -1.664)
    assert close(second.a.interval, (-0.243, 2.425)) and close(second.b.interval, (3.638, 7.034))
    assert close(second.gap, 1.213)
    assert trace.separating is second and trace.relation is sv.Relation.APART


def test_ties_on_an_edges_own_normal_land_on_one_spot():
    landings = sv.record(A, B).tests[0].b.landings
    assert len(set(landings)) == 2  # v1 and v2 together


def test_the_sentence_of_a_step_is_made_from_the_trace():
    trace = sv.record(A, B, axes=axes.edge_normals)
    assert telling.test(trace, 1) == (
        "Axis 2 of 6, normal of B's edge v1v3: A [-0.243, 2.425], B [3.638, 7.034], gap +1.213: "
        "separating, so the shapes are apart."
    )


def test_an_early_exit_is_a_prefix_of_the_full_run():
    for _, a, b in SOME:
        short, full = sv.record(a, b), sv.record(a, b, every_axis=True)
        if not short.pairs:
            assert short.tests == full.tests[: len(short.tests)]
            assert len(full.tests) == len(full.choice.axes)
            assert short.relation is full.relation
            assert all(not t.separates for t in short.tests[:-1])


def test_skipped_axes_say_why():
    trace = sv.record(A, B)
    reasons = {reason for _, reason in trace.skipped}
    assert reasons == {"parallel to axis 2", "early exit: axis 2 separates"}
    assert len(trace.tests) + len(trace.skipped) == 6


@pytest.mark.parametrize(
    ("a", "b", "count"),
    [
        (box(0, 0, 2, 2), box(1, 1, 3, 3), 2),
        (sv.Circle((0, 0), 2), sv.Circle((1, 1), 2), 1),
        (sv.Circle((0, 0), 2), sv.Circle((0, 0), 1), 1),
        (box(0, 0, 2, 2), sv.Circle((3, 3), 3), 3),
        (A, sv.Circle((1, 2), 1), 4),
        (A, B, 5),
    ],
)
def test_needed_is_the_smallest_complete_set(a, b, count):
    choice = axes.needed(a, b)
    assert len(choice.axes) == count and choice.complete


def test_a_vertex_axis_is_skipped_when_the_centre_is_on_the_vertex():
    trace = sv.record(box(0, 0, 2, 2), sv.Circle((2, 2), 1))
    assert trace.skipped[-1].reason == "the centre is on that vertex: no direction"
    assert trace.relation is sv.Relation.OVERLAPPING and trace.certificate.check()


@pytest.mark.parametrize("name", axes.NAMED)
def test_every_choice_of_axes_leaves_the_relation_exact(name):
    for _, a, b in SOME[:150]:
        trace = sv.record(a, b, axes=axes.NAMED[name])
        assert trace.relation is sv.relate(a, b), (a, b)
        assert trace.false_hit == (trace.claim is not sv.Relation.APART and trace.relation is sv.Relation.APART)


@pytest.mark.parametrize("name", axes.NAMED)
def test_a_choice_that_says_it_is_complete_decides_by_itself(name):
    for _, a, b in SOME:
        trace = sv.record(a, b, axes=axes.NAMED[name])
        if trace.choice.complete:
            assert trace.claim is sv.relate(a, b), (a, b)


def test_aabb_is_fooled_by_turned_boxes_and_says_so():
    trace = sv.scene("aabb-rotated").record()
    assert trace.false_hit and not trace.hit
    assert [round(t.gap, 3) for t in trace.tests] == [-1.453, -1.095]
    assert "false hit" in trace.sentence
    assert close(max(t.gap for t in sv.record(trace.a, trace.b, every_axis=True).tests), 0.631)


def test_without_the_nearest_vertex_a_circle_off_a_corner_is_a_false_hit():
    unit, circle = box(0, 0, 1, 1), sv.Circle((1.8, 1.8), 1)
    without = sv.record(unit, circle, axes=axes.edge_normals)
    assert without.false_hit and close(max(t.gap for t in without.tests), -0.2)
    assert close(sv.record(unit, circle).separating.gap, 0.131)


def test_no_line_separates_the_box_in_the_notch_yet_they_are_apart():
    trace = sv.record(box(2.5, 2.5, 3.5, 3.5), L, axes=axes.hull_normals, every_axis=True)
    assert close(max(t.gap for t in trace.tests), -0.707) and trace.false_hit
    by_parts = sv.record(box(2.5, 2.5, 3.5, 3.5), L)
    assert by_parts.relation is sv.Relation.APART
    assert [pair.names for pair in by_parts.pairs] == [("A", "B1"), ("A", "B2")]
    assert [pair.separating.gap for pair in by_parts.pairs] == [0.5, 0.5]


def test_a_concave_hit_names_the_part_that_collides():
    trace = sv.record(sv.Circle((1, 3), 0.25), L)
    assert trace.colliding.names == ("A", "B2")
    assert "A and B2" in trace.sentence


def test_the_shown_gap_has_the_exact_sign():
    for _, a, b in SOME:
        for test in sv.record(a, b, every_axis=True).tests:
            assert test.gap == 0 or abs(test.gap) > 0
            exact = exact_gap_sign(a, b, test)
            assert (test.gap > 0) - (test.gap < 0) == exact, (a, b, test)


def exact_gap_sign(a, b, test):
    """The sign of the gap in fractions, along the axis's true direction (independent of the engine's integers)."""
    shapes = {"A": a, "B": b}
    kind, role, ids = test.source
    if kind == axes.EDGE:
        (px, py), (qx, qy) = (map(Fraction, shapes[role].vertices[i]) for i in ids)
        n = qy - py, px - qx
    elif kind == axes.VERTEX:
        vertex, center = shapes[role].vertices[ids[0]], shapes["B" if role == "A" else "A"].center
        n = tuple(Fraction(c) - Fraction(v) for c, v in zip(center, vertex))
    elif kind == axes.CENTERS:
        n = tuple(Fraction(q) - Fraction(p) for p, q in zip(a.center, b.center))
    else:
        n = tuple(map(Fraction, test.axis.normal))
    spans, radii = [], Fraction(0)
    for shape in (a, b):
        points = [shape.center] if isinstance(shape, sv.Circle) else shape.vertices
        dots = [n[0] * Fraction(x) + n[1] * Fraction(y) for x, y in points]
        spans.append((min(dots), max(dots)))
        radii += Fraction(shape.radius) if isinstance(shape, sv.Circle) else 0
    apart = max(spans[0][0] - spans[1][1], spans[1][0] - spans[0][1])
    square = radii * radii * (n[0] * n[0] + n[1] * n[1])
    value = apart * abs(apart) - square if apart > 0 else -1 if apart < 0 or square else 0
    return (value > 0) - (value < 0)


def test_intervals_are_attained_by_points_and_never_contradict_the_gap():
    for _, a, b in SOME:
        for t in sv.record(a, b, every_axis=True).tests:
            for side in (t.a, t.b):
                assert set(side.interval) <= set(side.landings)
            shown = t.a.interval.gap(t.b.interval)
            assert shown * t.gap >= 0, (a, b, t)


def test_every_certificate_checks():
    for _, a, b in SOME:
        trace = sv.record(a, b)
        assert trace.certificate.check(), (a, b)


def test_a_wrong_certificate_does_not_check():
    apart, hit = sv.record(A, B).certificate, sv.record(A, A).certificate
    assert not apart._replace(offset=apart.offset + 5).check()
    assert not hit._replace(x=hit.x + 100).check()
    lines = sv.record(box(2.5, 2.5, 3.5, 3.5), L).certificate
    assert lines.check() and not lines._replace(lines=lines.lines[:1]).check()


def test_a_certificate_in_words_names_its_line_as_the_pictures_do():
    def words(a, b):
        return str(sv.record(a, b).certificate)

    assert words(box(0, 0, 1, 1), box(2, 0, 3, 1)) == "separating line x = 1.5 (parallel to y)"
    slanted = sv.Polygon([(0, 0), (1, 0), (0, 1)]), sv.Polygon([(1, 1), (2, 1), (1, 2)])
    assert words(*slanted) == "separating line x + y = 1.5"
    steep = sv.Circle((0, 0), 0.1), sv.Circle((0.3, 0.1), 0.1)
    assert words(*steep).startswith("separating line x + 0.333y = ")
    near, far = [(0, 0), (1.5e308, 0), (0, 1.5e308)], [(1.7e308, 1.7e308), (1e308, 1.7e308), (1.7e308, 1e308)]
    assert words(sv.Polygon(near), sv.Polygon(far)) == "separating line 0.25x + 0.25y = 5.250e+307"
    assert words(A, A) == "the point (1.333, 2.667) lies in both"


def test_the_mtv_really_ends_the_overlap_and_hardly_less_does_not():
    overlapping = 0
    for _, a, b in SOME:
        trace = sv.record(a, b)
        mtv = trace.mtv
        if trace.relation is sv.Relation.APART:
            assert mtv is None
        elif trace.relation is sv.Relation.TOUCHING:
            assert mtv == (0, 0)
        elif 1e-100 < hypot(*mtv) < 1e100:
            overlapping += 1
            assert ends_overlap(a, b, mtv), (a, b)
            less = sv.Vec(mtv.x * (1 - 1e-5), mtv.y * (1 - 1e-5))
            assert not ends_overlap(a, b, less), (a, b)
    assert overlapping > 50


@pytest.mark.parametrize(
    ("a", "b", "mtv"),
    [
        (box(0, 0, 4, 1), box(3, 0.5, 5, 3.5), (0, 0.5)),  # raw normals would choose x
        (box(0, 0, 10, 10), box(4, 4, 5, 5), (0, -5)),  # one holds the other: not the shared length
        (sv.Circle((0, 0), 2), sv.Circle((0, 0), 1), (3, 0)),
        (sv.Circle((0, 0), 3), sv.Circle((4, 0), 2), (1, 0)),
    ],
)
def test_the_mtv_is_right_where_shortcuts_go_wrong(a, b, mtv):
    assert sv.record(a, b).mtv == pytest.approx(mtv)


def test_the_mtv_does_not_follow_the_centres():
    sliver, small = sv.Polygon([(0, 0), (8, 0), (0, 1)]), box(0.5, -0.5, 1.5, 1.5)
    mtv = sv.record(sliver, small).mtv
    assert ends_overlap(sliver, small, mtv)
    assert hypot(*mtv) == pytest.approx(min(-t.gap for t in sv.record(sliver, small).tests))


CONCAVE = [
    (L, box(1.5, 1.5, 3.5, 3.5)),
    (L, sv.Circle((3.2, 3.2), 1.5)),
    (L, L),
    (sv.Polygon([(0, 0), (6, 0), (6, 4), (4, 4), (4, 1), (2, 1), (2, 4), (0, 4)]), box(2.2, 1.5, 3.8, 3.5)),
    (sv.Polygon([(0, 0), (6, 0), (6, 4), (4, 4), (4, 1), (2, 1), (2, 4), (0, 4)]), box(1.8, 1.5, 4.2, 3.5)),
    (box(0, 0, 9, 9), sv.Polygon([(3, 3), (6, 3), (4, 4), (3, 6)])),
]


@pytest.mark.parametrize(("a", "b"), CONCAVE)
def test_a_concave_pairs_mtv_ends_the_overlap_and_no_shorter_move_of_a_fan_does(a, b):
    from math import cos, pi, sin

    trace = sv.record(a, b)
    if trace.relation is not sv.Relation.OVERLAPPING:
        assert trace.mtv is None or trace.mtv == (0, 0)
        return
    assert ends_overlap(a, b, trace.mtv)
    size = hypot(*trace.mtv)
    for k in range(90):
        for part in (0.25, 0.5, 0.75, 0.9, 0.999):
            move = sv.Vec(cos(k * pi / 45) * size * part, sin(k * pi / 45) * size * part)
            assert not ends_overlap(a, b, move), move


def test_relate_moved_by_nothing_is_relate():
    for _, a, b in SOME[:200]:
        assert relate_moved(a, b, sv.Vec(0.0, 0.0)) is sv.relate(a, b)


def test_a_trace_survives_json():
    for _, a, b in SOME:
        for every in (False, True):
            trace = sv.record(a, b, every_axis=every)
            assert sv.Trace.from_json(trace.to_json()) == trace
    for scene in SCENES:
        assert sv.Trace.from_json(scene.record().to_json(indent=1)) == scene.record()


def changed(change):
    data = json.loads(sv.record(A, B, axes=axes.edge_normals).to_json())
    change(data)
    return json.dumps(data)


LIES = {
    "relation": lambda d: d.update(relation="overlapping"),
    "hit": lambda d: d.update(hit=True),
    "sentence": lambda d: d.update(sentence="A and B overlap."),
    "gap": lambda d: d["tests"][1].update(gap=-0.1),
    "landing": lambda d: d["tests"][0]["a"]["landings"].__setitem__(0, 2.0),
    "point": lambda d: d["tests"][0]["a"]["points"].__setitem__(0, [9.0, 9.0]),
    "axis direction": lambda d: d["axes"][0].update(normal=[3.0, 2.0]),
    "axis length": lambda d: d["axes"][0].update(length=7.0),
    "no such vertex": lambda d: d["axes"][0]["source"].update(vertices=[0, 7]),
    "unknown key": lambda d: d.update(extra=1),
    "missing key": lambda d: d.pop("mtv"),
    "text for number": lambda d: d["tests"][0].update(gap="1"),
    "too many tests": lambda d: d["tests"].extend(d["tests"] * 6),
    "complete": lambda d: (d.update(complete=True), d["tests"].pop(), d["axes"].pop()),
    "all lengths": lambda d: [axis.update(length=axis["length"] / 10) for axis in d["axes"]],
    "names": lambda d: d.update(names=["B", "A"]),
    "odd names": lambda d: d.update(names=["\ud800", "B"]),
    "world axis": lambda d: d["axes"][0].update(source={"kind": "world", "shape": None, "vertices": [0]}),
    "unknown kind": lambda d: d["axes"][0]["source"].update(kind="guess"),
    "one vertex twice": lambda d: d["axes"][0]["source"].update(vertices=[1, 1]),
    "reason": lambda d: d.update(skipped=[{"axis": d["axes"][0], "reason": "parallel to axis 2"}]),
    "fewer axes, complete": lambda d: (d["axes"].pop(3), d.update(complete=True)),
    "tiny gap": lambda d: d["tests"][0].update(gap=-5e-324),
    "shape": lambda d: d["b"]["polygon"][0].__setitem__(0, 2.0),
    "null shape": lambda d: d.update(a=None),
    "format": lambda d: d.update(satviz="trace 2"),
}


@pytest.mark.parametrize("lie", LIES)
def test_a_trace_file_that_lies_is_refused(lie):
    with pytest.raises(sv.InvalidScene):
        sv.Trace.from_json(changed(LIES[lie]))


def test_a_trace_is_a_value():
    one, two = sv.record(A, B), sv.record(A, B)
    assert one == two and hash(one) == hash(two)
    with pytest.raises(AttributeError):
        one.tests = ()


def test_the_table_has_a_row_a_test_and_says_no_more_than_was_proved():
    text = str(sv.record(A, B))
    assert "2 normal of B's edge v1v3" in text and "+1.213  separates" in text
    assert text.endswith("A and B are apart: axis 2 (normal of B's edge v1v3) leaves a gap of 1.213.")
    partial = str(sv.record(A, A, axes=axes.world))
    assert "not a proof" in partial


def test_touching_counts_as_a_hit():
    trace = sv.record(box(0, 0, 1, 1), box(1, 0, 2, 1))
    assert trace.hit and trace.relation is sv.Relation.TOUCHING and "touch" in trace.sentence


@given(st.integers(-6, 6), st.integers(-6, 6), st.integers(1, 5))
@settings(max_examples=60, deadline=None)
def test_given_directions_are_taken_as_given(x, y, length):
    if (x, y) == (0, 0):
        with pytest.raises(ValueError, match="direction 0"):
            axes.directions((x, y))
        return
    test = sv.record(A, B, axes=axes.directions((x * length, y * length))).tests[0]
    assert test.axis.normal == (x * length, y * length)
    assert test.a.interval.lo == pytest.approx(min((x * p + y * q) / hypot(x, y) for p, q in A.vertices))


def test_record_refuses_what_is_no_shape():
    with pytest.raises(TypeError, match="b is a list: make it a satviz"):
        sv.record(A, [(0, 0)])


def test_a_trace_rewritten_by_another_json_writer_is_still_true():
    text = sv.record(A, B).to_json().replace(".0,", ",").replace(".0]", "]")
    assert sv.Trace.from_json(text) == sv.record(A, B)


def test_a_choice_of_ones_own_survives_json():
    some = axes.edge_normals(A, B)._replace(complete=False)
    trace = sv.record(A, B, axes=axes.Choice(some.axes[::2]), every_axis=True)
    assert sv.Trace.from_json(trace.to_json()) == trace
    trace = sv.record(A, B, axes=axes.directions((1, 2), (-3, 0.25)), every_axis=True)
    assert sv.Trace.from_json(trace.to_json()) == trace


HARD = [
    # a pocket whose free wedge lies sideways; a tiny circle; rounding against a large outline
    (sv.Polygon([(5, -1), (0, 1), (0, -1), (-2, 4), (-5, -3)]), sv.Circle((-0.9, 0.2), 0.3), 0.6986),
    (sv.Polygon([(0, 1), (1, 3), (-5, 4), (4, -4)]), sv.Circle((-1.9, 2.2), 1e-7), 0.71419),
    (
        sv.Polygon([(-3, 1), (-4, 2), (-2, 4), (2, 3), (1, 1), (-3, -4)]),
        sv.Circle((-1e-10, 4e-10), 2e-10),
        0.156174,
    ),
    # just deep enough for the float filter, whose gap has five right digits only
    (
        sv.Polygon(
            [
                (0.33134916401791936, -0.943508204259309),
                (0.9372193363989527, 0.3492565531593265),
                (-0.33134916401791936, 0.943508204259309),
            ]
        ),
        sv.Polygon(
            [
                (0.33134916512778495, -0.943508203869537),
                (-0.3313491629080538, 0.943508204649081),
                (-1.0097428727454139, -0.1427476526537444),
            ]
        ),
        1.1763e-9,
    ),
]


@pytest.mark.parametrize(("a", "b", "length"), HARD)
def test_the_mtv_of_hard_scenes_is_there_ends_the_overlap_and_is_short(a, b, length):
    trace = sv.record(a, b)
    assert ends_overlap(a, b, trace.mtv) and hypot(*trace.mtv) == pytest.approx(length, rel=1e-4)
    assert str(trace)


@pytest.mark.parametrize("e", [-1060, -540, 0, 512, 1015])
def test_a_concave_mtv_scales_with_the_scene(e):
    s = 2.0**e
    mtv = sv.record(sv.Polygon([(x * s, y * s) for x, y in L.vertices]), sv.Circle((2.25 * s, 2.25 * s), s)).mtv
    assert mtv == pytest.approx((0.75 * s, 0.75 * s), rel=1e-3)


def test_a_move_beyond_float64_is_none_and_said():
    huge = box(-1.7e308, -1.7e308, 1.7e308, 1.7e308)
    trace = sv.record(huge, sv.Polygon([(-1e308, -1e308), (1e308, -1e308), (0, 1e308)]))
    assert trace.mtv is None and "No move" in trace.sentence and trace.certificate.check()
    assert sv.Trace.from_json(trace.to_json()) == trace
