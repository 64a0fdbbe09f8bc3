"""Tests of traces: what they record, describe and prove, and which trace files are accepted."""

import json
import re
import sys
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from itertools import cycle, islice, product
from math import cos, hypot, ldexp, pi, sin, sqrt
from random import Random

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from speeds import one_in
from strategies import CONVEX, pairs, star

import satviz as sv
from satviz.engine import axes, convex_parts, describe, number_format, sat
from satviz.engine import trace as trace_module
from satviz.engine.certificate import SharedPoint
from satviz.engine.relate import relate_moved
from satviz.engine.sat import axis_tests
from satviz.engine.shortcut import move_along_axis
from satviz.scenes import strictjson, tracefile
from satviz.scenes.article import SCENES
from satviz.scenes.failing import SHORTCUTS
from satviz.scenes.named import names, refused_case
from satviz.scenes.named import scene as named
from satviz.scenes.shape_tools import box

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
    assert describe.test_sentence(trace, 1) == (
        "Axis 2 of 6, normal of B's edge v1v3: A [−0.243, 2.425], B [3.638, 7.034], gap +1.213: "
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


def test_skipped_axes_have_a_reason():
    trace = sv.record(A, B)
    assert {(s.why, s.number) for s in trace.skipped} == {(axes.PARALLEL, 2), (axes.EARLY_EXIT, 2)}
    assert ": parallel to axis 2\n" in str(trace) and ": early exit: axis 2 separates\n" in str(trace)
    assert len(trace.tests) + len(trace.skipped) == 6


def test_all_axes_parallel_to_one_axis_share_one_line_of_the_table():
    square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    text = str(sv.record(sv.Polygon(square), sv.Polygon([(x + 0.5, y + 0.5) for x, y in square])))
    lines = [line for line in text.splitlines() if line.startswith("-")]
    first, second = lines
    assert first == "- normal of B's edge b1b2 and 3 more: parallel to axis 1"
    assert second == "- normal of B's edge b2b3 and 3 more: parallel to axis 2"


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


def test_a_vertex_axis_is_skipped_when_the_center_is_on_the_vertex():
    trace = sv.record(box(0, 0, 2, 2), sv.Circle((2, 2), 1))
    assert trace.skipped[-1][1:] == (axes.NO_DIRECTION, None)
    assert ": the center is on that vertex: no direction\n" in str(trace)
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


@pytest.mark.parametrize("name", axes.NAMED)
def test_a_choice_made_beforehand_is_as_good_as_its_name_and_its_trace_loads(name):
    choose = axes.NAMED[name]
    upright = [(box(0, 0, 2, 1), box(1, 0, 2, 1)), (box(0, 0, 2, 1), sv.Circle((2, 2), 1))]
    for a, b in upright + [(a, b) for _, a, b in SOME[::9]]:
        trace = sv.record(a, b, axes=choose)
        assert sv.record(a, b, axes=choose(a, b)) == trace == sv.Trace.from_json(trace.to_json())


@pytest.mark.parametrize("name", one_in(2, axes.NAMED))
def test_axes_in_any_order_prove_as_much_and_their_trace_loads(name):
    """A game tests first the axis that separated the shapes in the last frame."""
    rng = Random(3)
    for a, b in [
        (box(0, 0, 2, 1), box(1, 0, 2, 1)),
        (box(0, 0, 2, 2), sv.Circle((2, 2), 1)),
        *(p[1:] for p in SOME[::26]),
    ]:
        choice = axes.NAMED[name](a, b)
        chosen = rng.sample(choice.axes, len(choice.axes))
        for other in choice._replace(axes=tuple(chosen)), choice._replace(axes=(*chosen, *chosen[:1]), skipped=()):
            trace = sv.record(a, b, axes=other, every_axis=rng.random() < 0.5)
            assert trace.choice.axes == other.axes and trace.choice.complete is choice.complete
            assert trace.relation is sv.relate(a, b) and trace == sv.Trace.from_json(trace.to_json())
            for skip in trace.choice.skipped:
                if skip.why == axes.PARALLEL:
                    (x, y), (u, v) = (
                        axes.exact_dots(a, b, axis).normal for axis in (skip.axis, chosen[skip.number - 1])
                    )
                    assert x * v == y * u
                else:
                    assert skip in choice.skipped


def test_an_axis_with_a_false_source_or_length_is_refused():
    a, b = box(0, 0, 1, 1), sv.Polygon([(2, 0), (3, 0), (3, 1)])
    for axis in axes.needed(a, b).axes:
        for other in axis._replace(length=2 * axis.length), axis._replace(source=axis.source._replace(ids=(0, 9))):
            for choice in axes.Choice((other,)), axes.Choice(axes.WORLD_AXES, (axes.Skip(other, axes.PARALLEL, 1),)):
                with pytest.raises(ValueError, match="is not an axis of these shapes: choose the axes"):
                    sv.record(a, b, axes=choice)


@pytest.mark.parametrize(
    "axis",
    [
        ((1.0, 0.0), 0.1),
        ((1.0, 0.0), -1.0),
        ((1.0, 0.0), 1 + 2**-40),
        ((1.0, 0.0), float("inf")),
        ((1.0, 0.0), float("nan")),
        ((1.0, 0.0), 10**400),
        ((1.5e308, 1.5e308), 1.0),
        ((0.0, 0.0), 1.0),
        ((float("inf"), 0.0), 1.0),
        ((float("nan"), 0.0), 1.0),
        ((10**400, 0), 1.0),
    ],
    ids=str,
)
def test_a_given_direction_with_a_wrong_length_is_refused(axis):
    """With a length that is too short, a trace would show a gap between circles that overlap."""
    given = axes.Axis(sv.Vec(*axis[0]), axis[1], axes.Source(axes.GIVEN, None, (0,)))
    for choice in axes.Choice((given,)), axes.Choice(axes.WORLD_AXES, (axes.Skip(given, axes.PARALLEL, 2),)):
        with pytest.raises(ValueError):
            sv.record(sv.Circle((0, 0), 1), sv.Circle((0.5, 0), 1), axes=choice)


@pytest.mark.parametrize(
    "source",
    [(None, ()), (None, (0, 1)), (None, ("x",)), (None, (True,)), (None, (-1,)), (None, (2**53,)), ("A", (0,))],
    ids=str,
)
def test_a_given_direction_has_a_valid_number(source):
    given = axes.Axis(sv.Vec(1.0, 0.0), 1.0, axes.Source(axes.GIVEN, *source))
    with pytest.raises(ValueError, match="is not an axis of these shapes"):
        sv.record(A, B, axes=axes.Choice((given,)))
    last = given._replace(source=axes.Source(axes.GIVEN, None, (2**53 - 1,)))
    assert sv.record(A, B, axes=axes.Choice((last,))).tests[0].axis == last


def test_a_choice_may_hold_lists_and_other_numbers_and_its_trace_loads():
    a, b = box(0, 0, 1, 1), sv.Polygon([(2, 0), (3, 0), (3, 1)])
    expected = sv.record(a, b, axes=axes.needed, every_axis=True)
    needed = axes.needed(a, b)

    def with_each(change):
        return needed._replace(axes=tuple(map(change, needed.axes)))

    for choice in (
        needed._replace(axes=list(needed.axes), skipped=list(needed.skipped)),
        needed._replace(complete=1),
        with_each(
            lambda axis: axis._replace(normal=sv.Vec(*map(np.float64, axis.normal)), length=Fraction(axis.length))
        ),
        with_each(lambda axis: axis._replace(normal=tuple(axis.normal))),
        with_each(lambda axis: axis._replace(source=axis.source._replace(ids=tuple(map(float, axis.source.ids))))),
        with_each(lambda axis: axis._replace(source=axis.source._replace(ids=tuple(map(np.int64, axis.source.ids))))),
    ):
        trace = sv.record(a, b, axes=choice, every_axis=np.True_)
        assert trace == expected == sv.Trace.from_json(trace.to_json()) and hash(trace) == hash(expected)


@pytest.mark.parametrize(
    "choice",
    [
        None,
        "world",
        5,
        axes.WORLD_AXES,
        lambda a, b: None,
        lambda a, b: axes.WORLD_AXES,
        axes.Choice((None,)),
        axes.Choice("xy"),
        axes.Choice(((1, 0),)),
        axes.Choice(5),
        axes.Choice((axes.Axis(sv.Vec(1, 0), 1, ("world", None, (0,))),)),
        axes.Choice((), axes.WORLD_AXES),
        axes.Choice((), (None,)),
        axes.Choice(cycle(axes.WORLD_AXES)),
        axes.Choice((), (axes.Skip(axis, axes.PARALLEL, 1) for axis in cycle(axes.WORLD_AXES))),
    ],
)
def test_anything_but_a_choice_of_axes_is_a_type_error(choice):
    with pytest.raises(TypeError, match="expected a"):
        sv.record(A, B, axes=choice)


def test_an_axis_is_tested_or_skipped_and_the_zero_vector_is_no_axis():
    a, b = box(0, 0, 2, 2), sv.Circle((2, 2), 1)
    (skip,) = axes.nearest_vertex(a, b).skipped
    with pytest.raises(ValueError, match="has no direction"):
        sv.record(a, b, axes=axes.Choice((skip.axis,)))
    for twice in (
        axes.Choice(axes.WORLD_AXES, (axes.Skip(axes.WORLD_AXES[0], axes.PARALLEL, 1),)),
        axes.Choice(axes.WORLD_AXES, (axes.Skip(skip.axis, axes.PARALLEL, 2),)),
    ):
        with pytest.raises(ValueError, match="which is false here"):
            sv.record(a, b, axes=twice)


def test_a_nearly_parallel_axis_is_not_skipped_as_parallel():
    """The axis leads from a corner to a center, or between centers, and its rounded normal is that of another axis."""
    triangle, (across,) = sv.Polygon([(1, 1), (-1, 0), (1, -1)]), axes.directions((1, -2))(A, B).axes
    for x, parallel in (0, True), (1e-20, False):
        ball, coin = sv.Circle((x, 3), 0.5), sv.Circle((1, 1), 0.5)
        (vertex,) = axes.nearest_vertex(triangle, ball).axes
        assert vertex.normal == across.normal
        known = axes.needed(triangle, ball)
        edges = tuple(axis for axis in known.axes if axis != vertex)
        for a, b, chosen, skipped in (
            (triangle, ball, edges, vertex),
            (coin, ball, (across,), *axes.centers(coin, ball).axes),
        ):
            choice = axes.Choice(chosen[::-1], (axes.Skip(skipped, axes.PARALLEL),))
            if parallel:
                (skip,) = sv.record(a, b, axes=choice).choice.skipped
                assert skip.number and skip.axis == skipped
            else:
                with pytest.raises(ValueError, match="which is false here"):
                    sv.record(a, b, axes=choice)


def test_a_chooser_that_claims_to_be_one_of_ours_is_checked():
    class Sly:
        def __eq__(self, other):
            return True

        def __call__(self, a, b):
            return axes.Choice((), (), True)

    assert not sv.record(box(0, 0, 1, 1), box(5, 5, 6, 6), axes=Sly()).choice.complete


def test_repeated_axes_of_a_choice_are_validated_once_and_their_number_is_limited(monkeypatch):
    a, b = box(0, 0, 1, 1), sv.Polygon([(2, 0), (3, 0), (3, 1)])
    checked, real, needed = [], axes._parallel_key, axes.needed(a, b)
    monkeypatch.setattr(axes, "_parallel_key", lambda axis, *shapes: checked.append(axis) or real(axis, *shapes))
    trace = sv.record(a, b, axes=axes.Choice(needed.axes * 1000, needed.skipped * 1000))
    assert len(checked) == len(set(checked)) and len(trace.choice.skipped) == 1000 * len(needed.skipped)
    ball = sv.Circle((0, 0), 0.1)
    monkeypatch.setattr(trace_module, "MAX_SIZE", 500)
    with pytest.raises(sv.InvalidScene, match="a trace lists 500 points and axes at most"):
        sv.record(a, ball, axes=axes.Choice((), axes.nearest_vertex(a, ball).skipped * 500))


def test_a_choice_is_complete_only_if_its_axes_are():
    triangle, ball = sv.Polygon([(2, 2), (3, 2), (3, 3)]), sv.Circle((3, 3), 1)
    upright = box(0, 0, 1, 1), box(2, 0, 1, 1)
    for a, b, choose, complete in (
        (*upright, axes.world, True),
        (*upright, axes.edge_normals, True),
        (upright[0], triangle, axes.world, False),
        (upright[0], triangle, axes.edge_normals, True),
        (upright[0], triangle, axes.edge_normals_of_a, False),
        (upright[0], ball, axes.edge_normals, False),
        (upright[0], ball, axes.needed, True),
        (upright[0], sv.Circle((1, 3), 1), axes.edge_normals, True),  # the nearest vertex lies straight below
        (upright[0], sv.Circle((1, 3), 1), axes.edge_normals_of_a, True),
        (upright[0], sv.Circle((1, 3), 1), axes.nearest_vertex, False),
        (upright[0], sv.Circle((1, 1), 1), axes.hull_normals, True),
        (upright[0], ball, axes.directions((1, 0), (0, 1)), False),
        (L, triangle, axes.edge_normals, False),
        (L, triangle, axes.needed, False),
        (triangle, L, axes.hull_normals, False),
    ):
        for says in True, False:
            trace = sv.record(a, b, axes=axes.Choice(choose(a, b).axes, complete=says))
            assert trace.choice.complete is complete is choose(a, b).complete
            assert sv.Trace.from_json(trace.to_json()) == trace


def test_an_axis_may_be_skipped_only_for_its_true_reason():
    a, b = box(0, 0, 1, 1), sv.Polygon([(2, 0), (3, 0), (3, 1)])
    choice = axes.needed(a, b)
    assert [skip.why for skip in choice.skipped] == [axes.PARALLEL] * 4
    for why in axes.NO_DIRECTION, axes.EARLY_EXIT, "slow":
        with pytest.raises(ValueError, match=f"is skipped for the reason '{why}', which is false"):
            sv.record(a, b, axes=choice._replace(skipped=(choice.skipped[0]._replace(why=why),)))
    slanted = next(axis for axis in choice.axes if all(axis.normal))
    with pytest.raises(ValueError, match="is skipped for the reason 'parallel', which is false"):
        sv.record(a, b, axes=axes.Choice(choice.axes[:1], (axes.Skip(slanted, axes.PARALLEL, 1),)))
    ball, corner = sv.Circle((2, 2), 1), box(0, 0, 2, 2)
    (skip,) = (skip for skip in axes.needed(corner, ball).skipped if skip.why == axes.NO_DIRECTION)
    assert sv.record(corner, ball, axes=axes.Choice(axes.needed(corner, ball).axes, (skip,))).skipped == (skip,)


def test_axes_chosen_for_other_shapes_are_refused_or_prove_only_what_is_true():
    """Such a choice was kept from another trace, or made for the shapes in the other order."""
    taken, refused, wrong = 0, 0, 0
    known = [(a, b) for _, a, b in SOME[::2]] + [(box(0, 0, 1, 1), sv.Circle((x, 1.4), 0.5)) for x in (0.5, 1.4, 1.6)]
    for k, (a, b) in enumerate(known):
        # of two others, of one of them and another, of the same the other way round
        for other in (known[k - 1], (a, known[k - 1][1]), (b, a)):
            chosen = [choose(*other) for choose in (axes.needed, axes.edge_normals)]
            for choice in (*chosen, *(c._replace(skipped=()) for c in chosen)):
                try:
                    trace = sv.record(a, b, axes=choice)
                except ValueError as error:
                    assert "is not an axis of these shapes" in str(error)
                    refused += 1
                    continue
                taken, wrong = taken + 1, wrong + trace.false_hit
                assert trace.relation is sv.relate(a, b) and trace.certificate.check()
                assert not (trace.choice.complete and trace.false_hit)
                if choice.complete is trace.choice.complete and choice in chosen:
                    assert sv.Trace.from_json(trace.to_json()) == trace
    assert taken > 20 and refused > 20 and wrong


def test_world_axes_do_not_separate_turned_boxes_and_the_trace_says_so():
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


@pytest.mark.parametrize("share", range(4))
def test_the_shown_gap_has_the_exact_sign(share):
    for _, a, b in SOME[share::4]:
        for test in sv.record(a, b, every_axis=True).tests:
            assert test.gap == 0 or abs(test.gap) > 0
            exact = exact_gap_sign(a, b, test)
            assert (test.gap > 0) - (test.gap < 0) == exact, (a, b, test)


def exact_gap_sign(a, b, test):
    """Return the sign of the gap along the axis's true direction in fractions, independent of the engine's integers."""
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
    assert words(sv.Polygon(near), sv.Polygon(far)) == "separating line 0.25x + 0.25y = 5.250e307"
    assert words(A, A) == "the point (1.333, 2.667) lies in both"


def test_the_shallowest_test_is_given_where_none_separates():
    trace = sv.record(box(0, 0, 4, 4), box(3, 1, 9, 3))
    assert trace.shallowest is trace.tests[1] and trace.shallowest.gap == -1
    assert sv.record(box(0, 0, 4, 4), box(4, 1, 9, 3)).shallowest.gap == 0
    assert sv.record(A, B).shallowest is None
    assert sv.record(box(1, 1, 3, 3), L).shallowest is None  # its pairs have one each


def test_a_trace_without_a_shortcut_has_the_true_relation_and_pushes_by_its_mtv():
    for b, mtv in (box(3, 1, 9, 3), (1, 0)), (box(4, 1, 9, 3), (0, 0)), (box(5, 1, 9, 3), None):
        trace = sv.record(box(0, 0, 4, 4), b)
        assert trace.truth is trace and trace.push == trace.mtv == trace.known_mtv == mtv


def test_without_an_early_exit_every_axis_of_every_pair_is_tested():
    for a, b, tests in (A, B, [5]), (box(2.5, 2.5, 3.5, 3.5), L, [2, 2]), (box(1, 1, 3, 3), L, [2, 2]):
        short = sv.record(a, b)
        whole = short.without_early_exit()
        assert [len(trace.tests) for trace in whole.pairs or [whole]] == tests
        assert whole == sv.record(a, b, every_axis=True) != short
        assert whole.without_early_exit() is whole


def test_the_claim_about_concave_shapes_is_right_and_its_certificate_is_about_the_whole_shapes():
    for x, relation in ((2.5, sv.Relation.APART), (2, sv.Relation.TOUCHING), (1, sv.Relation.OVERLAPPING)):
        for a, b in (box(x, x, 3, 3), L), (L, box(x, x, 3, 3)):
            trace = sv.record(a, b)
            assert trace.relation is trace.claim is relation and not trace.false_hit
            assert trace.certificate.check() and (trace.certificate.a, trace.certificate.b) == (a, b)
            assert (trace.colliding is None) == (relation is sv.Relation.APART)
    assert sv.record(A, A).colliding is None


def test_relate_moved_by_nothing_is_relate():
    for _, a, b in SOME[:200]:
        assert relate_moved(a, b, sv.Vec(0.0, 0.0)) is sv.relate(a, b)


@pytest.mark.parametrize("share", one_in(4, range(20)))
def test_a_trace_survives_json(share):
    for _, a, b in SOME[share::20]:
        for every in (False, True):
            trace = sv.record(a, b, every_axis=every)
            assert sv.Trace.from_json(trace.to_json()) == trace


def test_the_traces_of_the_articles_scenes_survive_json():
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
    "nothing dropped": lambda d: d["tests"][0]["a"].update(points=[], landings=[]),
    "less landed than dropped": lambda d: d["tests"][0]["a"]["landings"].pop(),
    "less dropped than landed": lambda d: d["tests"][0]["a"]["points"].pop(),
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


SQUARE = sv.Polygon([(0, 0), (2, 0), (2.5, 2), (0, 2)])
COIN = sv.Circle((3, 3), 1)


def axis_of(kind, shape, *vertices):
    return lambda axis: axis["source"].update(kind=kind, shape=shape, vertices=list(vertices))


# what is changed in the first axis of a choice of one's own, whose tests are measured on the axis as it then is
AXIS_LIES = {
    "a number for a normal": (lambda axis: axis.update(normal=5), "pair of numbers"),
    "three numbers for a normal": (lambda axis: axis.update(normal=[1.0, 2.0, 3.0]), "pair of numbers"),
    "no direction": (lambda axis: axis.update(normal=[0.0, 0.0], length=0.0), "has another direction or length"),
    "turned round": (lambda axis: axis.update(normal=[-c for c in axis["normal"]]), "has another direction or length"),
    "a little off": (
        lambda axis: axis.update(normal=[c + 1e-9 for c in axis["normal"]]),
        "has another direction or length",
    ),
    "twice as long": (
        lambda axis: axis.update(normal=[2 * c for c in axis["normal"]], length=4.0),
        "has another direction or length",
    ),
    "another length": (lambda axis: axis.update(length=axis["length"] * (1 + 1e-9)), "another direction or length"),
    "no length": (lambda axis: axis.update(length=0.0), "another direction or length"),
    "a diagonal as an edge": (axis_of("edge normal", "A", 0, 2), "does not fit these shapes"),
    "a diagonal as a hull's edge": (axis_of("hull edge normal", "A", 0, 2), "does not fit these shapes"),
    "a vertex that is not there": (axis_of("edge normal", "A", 0, 4), "does not fit these shapes"),
    "vertices out of order": (axis_of("edge normal", "A", 1, 0), "does not fit these shapes"),
    "an edge of a circle": (axis_of("edge normal", "B", 0, 1), "does not fit these shapes"),
    "nobody's edge": (axis_of("edge normal", None, 0, 1), "does not fit these shapes"),
    "C's edge": (axis_of("edge normal", "C", 0, 1), "does not fit these shapes"),
    "a list's edge": (axis_of("edge normal", ["A"], 0, 1), "must be text"),
    "text for a vertex": (axis_of("edge normal", "A", "0", 1), "must be a whole number"),
    "true for a vertex": (axis_of("edge normal", "A", True, 0), "must be a whole number"),
    "one vertex of an edge": (axis_of("edge normal", "A", 0), "does not fit these shapes"),
    "not the nearest vertex": (axis_of("nearest vertex", "A", 1), "does not fit these shapes"),
    "a third world axis": (axis_of("world", None, 2), "does not fit these shapes"),
    "a world axis from behind": (axis_of("world", None, -1), "does not fit these shapes"),
    "somebody's world axis": (axis_of("world", "A", 1), "does not fit these shapes"),
    "both world axes": (axis_of("world", None, 0, 1), "does not fit these shapes"),
    "two circles' centers": (axis_of("centers", None), "does not fit these shapes"),
    "circles about one center": (axis_of("any direction", None), "does not fit these shapes"),
    "not through the centroids": (axis_of("centroids", None), "has another direction or length"),
    "somebody's given direction": (axis_of("given direction", "A", 0), "does not fit these shapes"),
    "nowhere as a given direction": (
        lambda axis: axis.update(
            normal=[0.0, 0.0], length=0.0, source={"kind": "given direction", "shape": None, "vertices": [0]}
        ),
        "does not fit these shapes",
    ),
    "a given direction of no number": (axis_of("given direction", None), "does not fit these shapes"),
}


@pytest.mark.parametrize("lie", AXIS_LIES)
def test_an_axis_that_is_not_what_its_source_says_is_refused(lie):
    own = axes.Choice(axes.edge_normals_of_a(SQUARE, COIN).axes[2:])
    data = json.loads(sv.record(SQUARE, COIN, axes=own, every_axis=True).to_json())
    change, words = AXIS_LIES[lie]
    change(data["axes"][0])
    with pytest.raises(sv.InvalidScene, match=words):
        sv.Trace.from_json(json.dumps(data))


def test_every_axis_of_the_shapes_may_be_in_a_given_choice():
    around = sv.Polygon([(1, 1), (2, 1.5), (3, 1), (3, 3), (1, 3)])
    for a, b in [(SQUARE, COIN), (COIN, SQUARE), (COIN, COIN), (COIN, sv.Circle((0, 1), 2)), (SQUARE, around)]:
        own = axes.Choice((*axes.axes_by_source(a, b).values(), *axes.directions((1, 2), (-3e300, 1e-300))(a, b).axes))
        trace = sv.record(a, b, axes=own, every_axis=True)
        assert sv.Trace.from_json(trace.to_json()) == trace


SKIP_LIES = {
    "another reason": lambda skip: skip.update(reason="parallel to axis 1"),
    "another axis": lambda skip: skip["axis"]["source"].update(vertices=[0, 1]),
    "no reason": lambda skip: skip.pop("reason"),
    "a reason that is none": lambda skip: skip.update(reason="it looked wrong"),
    "an axis that is not there": lambda skip: skip.update(reason="parallel to axis 9"),
}


@pytest.mark.parametrize("lie", SKIP_LIES)
def test_an_axis_left_out_for_another_reason_is_refused(lie):
    data = json.loads(sv.record(A, B).to_json())
    assert data["skipped"][0]["reason"] == "parallel to axis 2"
    SKIP_LIES[lie](data["skipped"][0])
    with pytest.raises(sv.InvalidScene):
        sv.Trace.from_json(json.dumps(data))


def test_a_trace_of_parts_with_other_axes_shapes_or_pairs_is_refused():
    def lie(change, a=None):
        data = json.loads(sv.record(a or box(1, 1, 3, 3), L).to_json())
        change(data)
        with pytest.raises(sv.InvalidScene):
            sv.Trace.from_json(json.dumps(data))

    lie(lambda d: d["pairs"][0]["axes"].reverse())
    lie(lambda d: d["pairs"][0].update(complete=False))
    lie(lambda d: d["pairs"][0].update(every_axis=True))
    lie(lambda d: d["pairs"][0].update(names=["A", "B2"]))
    lie(lambda d: d["pairs"][0]["b"].update(d["b"]))
    lie(lambda d: d["pairs"][0]["tests"].pop())
    lie(lambda d: d["pairs"].append(d["pairs"][0]))
    lie(lambda d: d["pairs"].clear())
    lie(lambda d: d["pairs"][0]["pairs"].append(d["pairs"][0] | {"pairs": []}))
    lie(lambda d: d.update(axes=d["pairs"][0]["axes"]))
    lie(lambda d: d.update(every_axis=True))
    lie(lambda d: d.update(every_axis="no"))
    lie(lambda d: d.update(a=d["b"]))
    lie(lambda d: d.update(mtv=None))
    lie(lambda d: d.update(mtv=[-2.0, -2.5]))  # a longer one
    lie(lambda d: d.update(mtv=[0.999 * c for c in d["mtv"]]))
    lie(lambda d: d.update(mtv="up"))
    notched = box(2.5, 2.5, 3.5, 3.5)  # apart from both parts
    lie(lambda d: d["pairs"][1].update(complete=False), notched)
    lie(lambda d: d["pairs"][1]["skipped"][0].update(reason="tired"), notched)
    lie(lambda d: d["pairs"].pop(), notched)


def test_an_mtv_as_short_as_ours_is_as_good():
    """Where two moves are equally short, the rounding of another machine may select the other one."""
    mast = sv.Polygon([(-4, -2), (4, -2), (4, 0), (1, 0), (1, 9), (-1, 9), (-1, 0), (-4, 0)])
    trace = sv.record(mast, sv.Circle((0, 5), 0.5))
    data = json.loads(trace.to_json())
    x, y = data["mtv"]
    assert abs(x) == pytest.approx(1.5)

    def load_with_mtv(*move):
        sentence = data["sentence"].replace(
            *(number_format.ascii_minus(number_format.vector(sv.Vec(*v))) for v in ((x, y), move))
        )
        return sv.Trace.from_json(json.dumps(data | {"mtv": list(move), "sentence": sentence}))

    assert load_with_mtv(-x, y) == trace
    for longer in 2**-30, 2**-28:  # a step more or less of those that lead outwards
        assert load_with_mtv(x * (1 + longer), y).relation is trace.relation
    for longer_shorter_or_not_out in (-2 * x, y), (x * (1 + 2**-27), y), (-x * 0.9, y), (0.0, abs(x)):
        with pytest.raises(sv.InvalidScene, match="mtv"):
            load_with_mtv(*longer_shorter_or_not_out)
    with pytest.raises(sv.InvalidScene, match="sentence"):
        sv.Trace.from_json(json.dumps(data | {"mtv": [-x, y]}))


@pytest.mark.parametrize("lie", LIES)
def test_a_false_trace_file_is_refused(lie):
    with pytest.raises(sv.InvalidScene):
        sv.Trace.from_json(changed(LIES[lie]))


def altered(data):
    """Yield for each value of a trace file after changing it in place; the change is then undone.

    The shapes are not changed, nor values that may differ in a true trace: the number of a given direction, and
    whether every axis was requested where all were tested.
    """
    inside = list(data.items()) if isinstance(data, dict) else list(enumerate(data))
    for key, value in inside:
        given = key == "vertices" and data["kind"] == axes.GIVEN
        if isinstance(value, dict | list) and key not in ("a", "b") and not given:
            yield from altered(value)
        match value:
            case bool():
                others = [int(value), None] if key == "every_axis" else [not value, int(value), None]
            case int() | float():
                others = [value * 1.001 + 0.002, -3.14 - value, value + 1, str(value), None, [value]]
            case str():
                others = [f"{value}?", "", 1, None, [value]]
            case list():
                others = [value[:-1] if value else [1], [*value, *value[-1:], None], {}, None, "", 0]
            case dict():
                others = [
                    value | {"more": 1},
                    *({k: v for k, v in value.items() if k != less} for less in value),
                    [],
                    None,
                ]
            case None:
                others = [0, "", [], {}, [1.0, 2.0]]
        for other in others:
            data[key] = other
            yield
        data[key] = value


ONE_OF_EACH = {
    "apart": sv.record(box(0, 0, 1, 1), sv.Polygon([(2, 0), (3, 0), (3, 1)])),
    "an axis left out": sv.record(sv.Polygon([(0, 0), (2, 0), (0, 2)]), sv.Circle((2, 0), 1), every_axis=True),
    "touching circles": sv.record(sv.Circle((0, 0), 2), sv.Circle((3, 4), 3)),
    "a choice of one's own": sv.record(A, COIN, axes=axes.directions((1, 2), (-3, 0.25), (0, -1))),
    "parts": sv.record(sv.Polygon([(0, 0), (4, 0), (1, 1), (0, 4)]), sv.Circle((-1, 0), 1.5)),
    "parts, every axis": sv.record(sv.Circle((0, 0), 1), sv.Polygon([(0, 0), (4, 0), (1, 1), (0, 4)]), every_axis=True),
    "parts apart": sv.record(sv.Circle((3, 3), 0.5), L),
    "large and small": sv.record(sv.Polygon([(0, 1e7), (-1e7, 0), (1e6, -1e7)]), sv.Polygon([(0, 0), (1, 0), (0, 1)])),
}


@pytest.mark.parametrize("share", one_in(4, range(16)))
@pytest.mark.parametrize("name", ONE_OF_EACH)
def test_a_trace_file_with_any_one_thing_changed_is_refused(name, share):
    """It is accepted only if it is the trace of a choice that lists fewer of the axes it skips."""
    file = [json.loads(ONE_OF_EACH[name].to_json())]
    for _ in islice(altered(file), share, None, 16):
        with suppress(sv.InvalidScene):
            trace = sv.Trace.from_json(json.dumps(file[0]))
            assert trace == sv.record(trace.a, trace.b, axes=trace.choice, every_axis=trace.every_axis)
            changed = {key for key, value in json.loads(ONE_OF_EACH[name].to_json()).items() if value != file[0][key]}
            assert changed == {"skipped"} and json.loads(trace.to_json()) == file[0]


def flags(data):
    """Yield (object, key) for every true or false in a trace file."""
    for key, value in data.items() if isinstance(data, dict) else enumerate(data):
        if isinstance(value, bool):
            yield data, key
        elif isinstance(value, dict | list):
            yield from flags(value)


FLAGGED = {
    **ONE_OF_EACH,
    **{f"the choice {name}": sv.record(SQUARE, COIN, axes=axes.NAMED[name]) for name in axes.NAMED},
    "a complete choice of one's own": sv.record(A, B, axes=axes.Choice(axes.edge_normals(A, B).axes[::-1])),
    "no axes": sv.record(A, B, axes=axes.Choice(())),
    **{f"the scene {name}": named(name).record() for name in names() if not refused_case(name)},
}


@pytest.mark.parametrize("name", FLAGGED)
def test_a_trace_file_with_a_negated_flag_is_refused(name):
    """The exception is the flag for every axis, where the trace is the same without it."""
    trace = FLAGGED[name]
    other = sv.record(trace.a, trace.b, axes=trace.shortcut or trace.choice, every_axis=not trace.every_axis)
    data = json.loads(trace.to_json())
    turned = list(flags(data))
    # the tests of a run are alike, so the first and the last few flags show as much as all
    for held, key in turned[:6] + turned[6:][-6:]:
        held[key] = not held[key]
        if key == "every_axis" and not trace.pairs and trace.tests == other.tests:
            assert sv.Trace.from_json(json.dumps(data)) == other
        else:
            of_every_axis = r"|has \d+ tests, not|every_axis is|trace.pairs has"
            with pytest.raises(sv.InvalidScene, match=f"{key} is{of_every_axis if key == 'every_axis' else ''}"):
                sv.Trace.from_json(json.dumps(data))
        held[key] = not held[key]


@pytest.mark.parametrize("name", ONE_OF_EACH)
def test_a_trace_of_each_kind_survives_json_and_the_rounding_of_another_machine(name):
    trace = ONE_OF_EACH[name]
    assert sv.Trace.from_json(trace.to_json()) == trace.from_json(trace.to_json()) == trace
    data = json.loads(trace.to_json())
    for run in data["pairs"] or [data]:
        for axis in run["axes"]:
            axis["length"] *= 1 + 2**-50
        for test in run["tests"]:
            for side in test["a"], test["b"]:
                side["landings"] = [c * (1 + 2**-50) for c in side["landings"]]
                side["interval"] = [min(side["landings"]), max(side["landings"])]
    again = sv.Trace.from_json(json.dumps(data))
    assert again.sentence == trace.sentence and again.relation is trace.relation
    assert json.loads(again.to_json()) == data


@pytest.mark.parametrize("stored", [-(2.0**-48), 0.0, 2.0**-48])
@pytest.mark.parametrize("true", [-(2.0**-48), 0.0, 2.0**-48])
def test_no_rounding_of_another_machine_changes_the_sign_of_a_gap(stored, true):
    """This holds also on an axis that does not matter, here x beside a large gap along y."""
    stored, true = (sv.record(box(0, 0, 1, 1), box(1 + gap, 3, 2 + gap, 4), every_axis=True) for gap in (stored, true))
    data = json.loads(stored.to_json()) | {"b": json.loads(true.to_json())["b"]}
    if stored == true:
        assert sv.Trace.from_json(json.dumps(data)) == true
    else:
        with pytest.raises(sv.InvalidScene, match="gap"):
            sv.Trace.from_json(json.dumps(data))


@pytest.mark.parametrize("far", [0, 1e6, 1e9, 1e12])
def test_no_wrong_gap_or_landing_is_accepted_as_rounding_far_from_the_origin(far):
    a, b = box(far, far, far + 4, far + 4), box(far + 1, far + 3, far + 5, far + 7)
    trace = sv.record(a, b)
    y, x = trace.tests
    assert (y.gap, x.gap) == (-1, -3)
    for tests in (y._replace(gap=-1.001), x), (y._replace(gap=-3.0), x._replace(gap=-1.0)):
        with pytest.raises(sv.InvalidScene, match="gap"):
            sv.Trace.from_json(replace(trace, tests=tests).to_json())
    landed = y.a._replace(landings=tuple(c + 1e-3 + far * 2**-44 for c in y.a.landings))
    with pytest.raises(sv.InvalidScene, match="is not the projection of these shapes"):
        sv.Trace.from_json(replace(trace, tests=(y._replace(a=landed), x)).to_json())


def loads(trace, tests):
    """Return whether a file of this trace with these tests in it is accepted."""
    text = replace(trace, tests=tuple(tests)).to_json()
    with suppress(sv.InvalidScene):
        return sv.Trace.from_json(text).to_json() == text
    return False


# largest coordinates 4 and 1024: whole numbers, so that sums stay exact
SMALL_AND_LARGE = box(1, 1, 4, 3), box(2, 2, 1024, 512)


@pytest.mark.parametrize("shapes", [SMALL_AND_LARGE, SMALL_AND_LARGE[::-1]], ids=["small, large", "large, small"])
@pytest.mark.parametrize("name", [None, "one-overlap", "lengths", "circles-turned-round"])
def test_each_number_of_a_file_has_the_tolerance_of_how_it_was_measured(name, shapes):
    """Landings have the tolerance of a square root at their shape's size, floats of a shortcut that of both shapes."""
    shortcut = SHORTCUTS[name] if name else axes.world
    trace = sv.record(*shapes, axes=shortcut, every_axis=True)
    test, *others = trace.tests
    own_way = bool(name and shortcut.measure)
    rounding = tracefile.FLOAT_ROUNDING if own_way else tracefile.ROUNDING
    assert abs(test.gap) >= 1
    for part, shape in ("gap", None), ("a", shapes[0]), ("b", shapes[1]):
        tolerance = rounding * (shape.max_coordinate if shape and not own_way else 1024)
        for off in tolerance, -tolerance, tolerance * 1.5, -tolerance * 1.5:
            if shape:
                side = getattr(test, part)
                moved = side._replace(landings=tuple(c + off for c in side.landings))
            else:
                moved = test.gap + off
            assert loads(trace, [test._replace(**{part: moved}), *others]) == (abs(off) == tolerance)


@pytest.mark.parametrize("name", [None, "lengths"])
def test_the_extremes_of_a_circle_have_the_tolerance_of_its_landings(name):
    trace = sv.record(sv.Circle((1, 1), 3), sv.Circle((500, 0), 524), axes=SHORTCUTS[name] if name else axes.needed)
    test, tolerance = trace.tests[0], 2.0**-18 if name else 2.0**-44
    for off in tolerance, -tolerance, tolerance * 1.5, -tolerance * 1.5:
        moved = test.a._replace(points=(test.a.points[0], sv.Vec(test.a.points[1].x, test.a.points[1].y + off)))
        assert loads(trace, [test._replace(a=moved)]) == (abs(off) == tolerance)


@pytest.mark.parametrize("name", [None, "one-overlap", "lengths"])
def test_the_stored_sign_of_a_small_gap_must_be_exact_for_every_shortcut(name):
    shortcut = SHORTCUTS[name] if name else axes.world
    small = 2.0**-42
    for true in small, 0.0, -small:
        trace = sv.record(box(1, 0, 4, 2), box(1, 2 + true, 1024, 512), axes=shortcut, every_axis=True)
        test, *others = trace.tests
        assert test.gap == true
        for stored in (sign * small * (1 + off) for sign in (1, 0, -1) for off in (0, 2.0**-50, 2.0**-49, 1)):
            # a gap computed in integers is rounded once
            rounded = stored * true > 0 and (name == "lengths" or abs(stored) < small * (1 + 2**-49))
            assert loads(trace, [test._replace(gap=stored), *others]) == (stored == true or rounded)


@pytest.mark.parametrize("sign", [1, -1])
def test_a_gap_that_is_exact_on_one_machine_only_is_still_rounding(sign):
    """A gap within the error bound is computed in integers; on another machine it may lie just outside that bound."""
    close, half_tolerance = 1024 * sat.CLOSE_GAP_FACTOR, 512 * tracefile.ROUNDING
    for true, stored, accepted in (
        (close, close + half_tolerance, True),
        (close, close - half_tolerance, False),
        (close + half_tolerance, close, True),
    ):
        trace = sv.record(box(1, 0, 4, 2), box(1, 2 + sign * true, 1024, 512), axes=axes.world, every_axis=True)
        test, *others = trace.tests
        assert test.gap == sign * true
        assert loads(trace, [test._replace(gap=sign * stored), *others]) == accepted


@pytest.mark.parametrize("name", [None, "lengths"])
def test_the_smallest_shapes_land_within_the_smallest_float(name):
    least = 5e-324
    shapes = box(0, 0, 3 * least, 4 * least), box(2 * least, 2 * least, 7 * least, 9 * least)
    trace = sv.record(*shapes, axes=SHORTCUTS[name] if name else axes.world, every_axis=True)
    test, *others = trace.tests
    for steps in 1, 2:
        moved = test.a._replace(landings=tuple(c + steps * least for c in test.a.landings))
        assert loads(trace, [test._replace(a=moved), *others]) == (steps == 1)


@pytest.mark.parametrize("name", [None, "lengths"])
def test_a_trace_file_over_the_size_limit_is_refused_with_the_message_of_record(name, monkeypatch):
    text = sv.record(A, B, axes=SHORTCUTS[name] if name else axes.needed).to_json()
    monkeypatch.setattr(trace_module, "MAX_SIZE", 10)
    with pytest.raises(sv.InvalidScene, match=r"^A and B have 6 points to project on"):
        sv.Trace.from_json(text)


def test_where_a_circle_reaches_beyond_float64_landings_are_checked_too():
    near_the_rim, far = sv.Circle((1.76e308, 1.32e308), 4.4e307), sv.Circle((-4, -1), 2)
    data = json.loads(sv.record(near_the_rim, far, axes=axes.world).to_json())
    assert sv.Trace.from_json(json.dumps(data)).relation is sv.Relation.APART
    with pytest.raises(sv.InvalidScene):
        sv.Trace.from_json(json.dumps(data | {"a": data["b"], "b": data["a"]}))


@pytest.mark.parametrize("choose", [axes.world, axes.centers, axes.needed])
def test_the_normal_of_an_axis_in_a_file_must_be_exact_to_the_last_bit(choose):
    data = json.loads(sv.record(box(0, 0, 4, 4), box(1, 3, 5, 7), axes=choose).to_json())
    x, y = data["axes"][0]["normal"]
    for normal in [x + 2**-60 if x == 0 else x * (1 + 2**-52), y], [x, y * (1 - 2**-52)]:
        data["axes"][0]["normal"] = normal
        with pytest.raises(sv.InvalidScene, match="has another direction or length"):
            sv.Trace.from_json(json.dumps(data))


def test_labels_are_stored_in_a_file_unchanged():
    trace = sv.record(A, sv.Polygon(B.vertices, ["é", "😀", "v"]))
    assert "é" in trace.to_json() and "😀" in trace.to_json() and sv.Trace.from_json(trace.to_json()) == trace


def test_no_other_mtv_of_convex_shapes_is_as_good_as_the_exact_one():
    data = json.loads(sv.record(box(0, 0, 4, 4), box(1, 1, 3, 3)).to_json())
    x, y = data["mtv"]
    assert x == 0 and data["sentence"].count(f"{y:.0f}") == 1
    other = data["sentence"].replace(f"{y:.0f}", f"{-y:.0f}")
    with pytest.raises(sv.InvalidScene, match="mtv"):
        sv.Trace.from_json(json.dumps(data | {"mtv": [0.0, -y], "sentence": other}))


def test_a_trace_iterates_over_its_tests_and_is_displayed_in_a_notebook(monkeypatch):
    trace = sv.record(A, B)
    assert tuple(trace) == trace.tests
    monkeypatch.setattr(trace_module.hooks, "mime_bundle", lambda shown: {"shown": shown})
    assert trace._repr_mimebundle_() == {"shown": trace}


def test_the_move_along_an_axis_parts_the_ranges_by_the_shorter_way():
    for lo_a, hi_a, lo_b, hi_b in product(range(-3, 4), repeat=4):
        if lo_a < hi_a and lo_b < hi_b:
            _, x = sv.record(box(lo_a, 0, hi_a, 1), box(lo_b, 0, hi_b, 1), axes=axes.world, every_axis=True).tests
            to_the_right, to_the_left = hi_a - lo_b, hi_b - lo_a
            way = to_the_right if to_the_right < to_the_left else -to_the_left  # to the left where both are as short
            assert move_along_axis(x, min(to_the_right, to_the_left)) == (way, 0)


@pytest.mark.parametrize("gap", [5e-324, 0.5])
def test_the_loop_ends_at_any_gap(gap):
    assert len(sv.record(box(0, 0, 1, 4), box(1, 4 + gap, 2, 9) if gap > 0.1 else box(1, -9, 2, -gap)).tests) == 1
    assert len(sv.record(box(0, 0, 1, 4), box(1, 4 + gap, 2, 9), every_axis=True).tests) == 2


def test_the_pairs_of_parts_end_at_the_first_that_overlaps():
    assert [pair.hit for pair in sv.record(box(1, 1, 3, 3), L).pairs] == [True]
    assert [pair.hit for pair in sv.record(box(2, 2, 3, 3), L).pairs] == [True, True]  # a touch does not end it
    assert len(sv.record(box(1, 1, 3, 3), L, every_axis=True).pairs) == 2
    assert sv.record(box(1, 1, 3, 3), L).choice == axes.Choice((), complete=True)


def test_equal_traces_have_equal_hashes_and_cannot_be_changed():
    one, two = sv.record(A, B), sv.record(A, B)
    assert one == two and hash(one) == hash(two)
    with pytest.raises(AttributeError):
        one.tests = ()


def test_the_table_has_a_row_for_each_test_and_claims_only_what_was_proven():
    text = str(sv.record(A, B))
    assert "2 normal of B's edge v1v3" in text and "+1.213  separates" in text
    assert text.endswith("A and B are apart: axis 2 (normal of B's edge v1v3) leaves a gap of 1.213.")
    partial = str(sv.record(A, A, axes=axes.world))
    assert "not a proof" in partial


def test_the_table_shows_on_request_the_sums_behind_the_ends_of_the_ranges():
    trace = sv.record(A, B)
    without, rows = trace.table().splitlines(), trace.table(sums=True).splitlines()
    assert "    v2: 2*8 + 3*3 = 25; 25 / sqrt(13) = 6.934" in rows
    found = [row for row in rows if row not in without]
    assert [row for row in rows if row in without] == without and len(found) == 4 * len(trace.tests)
    for row in found:  # each sum is true, and its result is an end of a range
        whole, *rest = row.split(": ", 1)[1].split("; ")
        left, right = whole.split(" = ")
        assert eval(left) == float(right)
        if rest:
            left, landing = rest[0].split(" = ")
            assert round(eval(left, {"sqrt": sqrt}), 3) == float(landing)
        ends = {end for t in trace.tests for side in (t.a, t.b) for end in side.interval}
        assert any(abs(float(row.rsplit(" = ", 1)[1]) - end) < 5e-4 for end in ends)


@pytest.mark.parametrize("what", ["aabb-rotated", "lengths", "unit-normals", "concave", "circle-polygon"])
def test_a_sum_of_the_table_is_left_out_rather_than_printed_falsely(what):
    trace = sv.scene(what).record()
    for run in trace.pairs or (trace,):
        ends = [end for t in run.tests for side in (t.a, t.b) for end in side.interval]
        for row in run.table(sums=True).splitlines():
            if re.match(r"    \w+: ", row):
                assert any(abs(float(row.rsplit(" = ", 1)[1]) - end) < 5e-4 for end in ends)


def test_touching_counts_as_a_hit():
    trace = sv.record(box(0, 0, 1, 1), box(1, 0, 2, 1))
    assert trace.hit and trace.relation is sv.Relation.TOUCHING and "touch" in trace.sentence


@given(st.integers(-6, 6), st.integers(-6, 6), st.integers(1, 5))
@settings(max_examples=30, deadline=None)
def test_given_directions_are_taken_as_given(x, y, length):
    if (x, y) == (0, 0):
        with pytest.raises(ValueError, match="direction 0"):
            axes.directions((x, y))
        return
    test = sv.record(A, B, axes=axes.directions((x * length, y * length))).tests[0]
    assert test.axis.normal == (x * length, y * length)
    assert test.a.interval.lo == pytest.approx(min((x * p + y * q) / hypot(x, y) for p, q in A.vertices))


def test_record_refuses_anything_but_shapes():
    with pytest.raises(TypeError, match="b is a list: make it a satviz"):
        sv.record(A, [(0, 0)])
    for a, b in (A, None), (None, A):
        with pytest.raises(TypeError, match="make it a satviz"):
            next(axis_tests(a, b))


def test_a_trace_rewritten_by_another_json_writer_is_still_true():
    text = sv.record(A, B).to_json().replace(".0,", ",").replace(".0]", "]")
    assert sv.Trace.from_json(text) == sv.record(A, B)


def test_the_number_of_a_vertex_may_be_written_as_a_float():
    data = json.loads(sv.record(A, B).to_json())
    ids = data["axes"][0]["source"]["vertices"]
    ids[:] = map(float, ids)
    trace = sv.Trace.from_json(json.dumps(data))
    assert trace == sv.record(A, B) and all(type(i) is int for i in trace.choice.axes[0].source.ids)
    ids[0] += 0.5
    with pytest.raises(sv.InvalidScene, match=r"vertices must be a whole number, not a number"):
        sv.Trace.from_json(json.dumps(data))


@pytest.mark.parametrize("text", [b"{}", None, 1, ["{}"]], ids=lambda text: type(text).__name__)
def test_anything_but_text_is_named_in_the_error(text):
    for read in sv.Trace.from_json, sv.Scene.from_json:
        with pytest.raises(TypeError, match=rf"^expected the text of a file, not {type(text).__name__}$"):
            read(text)


def test_a_wrong_text_is_quoted_from_its_first_difference():
    for shortcut, said, lie in (
        ("one-overlap", "no gap", "a gap"),
        ("one-overlap", "false hit", "true hit"),
        (None, "leaves a gap", "leaves no gap"),
        (None, "2", "3"),
    ):
        trace = sv.record(A, B, axes=SHORTCUTS[shortcut] if shortcut else axes.needed)
        data = json.loads(trace.to_json())
        data["sentence"] = data["sentence"].replace(said, lie)
        assert said in trace.sentence
        with pytest.raises(sv.InvalidScene, match=r"^trace.sentence is ") as refused:
            sv.Trace.from_json(json.dumps(data))
        given, found = (
            str(refused.value)
            .removeprefix("trace.sentence is ")
            .split(", but the shapes and options in the file give ")
        )
        assert lie in eval(given) and eval(given) in data["sentence"]
        assert said in eval(found) and eval(found) in number_format.ascii_minus(trace.sentence)


@pytest.mark.parametrize("lie", ["", "A", "B", "A an", "A and C", "A and B are not apart"])
def test_texts_that_differ_early_are_quoted_from_their_beginning(lie):
    data = json.loads(sv.record(A, B).to_json()) | {"sentence": lie}
    with pytest.raises(
        sv.InvalidScene,
        match=rf"^trace.sentence is '{lie}', but the shapes and options in the file give .A and B are apart: ",
    ):
        sv.Trace.from_json(json.dumps(data))


LONG = "x" * 100_000


@pytest.mark.parametrize(
    "change",
    [
        lambda d: d.update(sentence=LONG),
        lambda d: d.update(claim=[LONG] * 9),
        lambda d: d.update(shortcut=LONG),
        lambda d: d["skipped"][0].update(reason=LONG),
        lambda d: d["axes"][0]["source"].update(kind=LONG),
        lambda d: d.update({LONG: 1}),
        lambda d: d["axes"][0].update({f"{LONG}{i}": 1 for i in range(50)}),
        lambda d: d["a"].update({LONG: 1}),
        lambda d: d.update(names=[LONG, "B"]),
        lambda d: d["tests"][0].update(gap=[1.0] * 10_000),
        lambda d: d["tests"][0].update(gap=LONG),
        lambda d: d["tests"][0].update(gap=int("1" * 400)),
        lambda d: d["b"].update(labels=[[LONG], "a", "b"]),
        lambda d: d["b"].update(labels=LONG),
        lambda d: d["a"]["polygon"][0].__setitem__(0, int("1" * 300)),
    ],
    ids=range(15),
)
def test_a_refusal_quotes_no_more_than_a_line_of_what_it_refuses(change):
    data = json.loads(sv.record(A, B).to_json())
    change(data)
    with pytest.raises(sv.InvalidScene) as refused:
        sv.Trace.from_json(json.dumps(data))
    assert len(str(refused.value)) < 2000
    with pytest.raises(sv.InvalidScene) as refused:
        sv.Trace.from_json('{"satviz": 1' + "0" * 1_000_000 + ".0}")
    assert len(str(refused.value)) < 200
    for about in {"axes": LONG}, {"name": LONG}, {"title": LONG + "\n"}, {LONG: 1}:
        with pytest.raises(sv.InvalidScene) as refused:
            sv.Scene.from_json(json.dumps(json.loads(sv.scene("triangles").to_json()) | about))
        assert len(str(refused.value)) < 1000


def rewritten(data, whole):
    """Return the JSON as other writers produce it: whole floats as integers, written by `whole`."""
    if isinstance(data, dict):
        return {key: rewritten(value, whole) for key, value in data.items()}
    if isinstance(data, list):
        return [rewritten(value, whole) for value in data]
    return whole(data) if isinstance(data, float) and data.is_integer() else data


@pytest.mark.parametrize("size", [1.0, 2.0**53, 1e22, 1e300])
def test_whole_numbers_of_any_size_may_be_written_as_integers(size):
    a = sv.Polygon([(-0.0, size), (3 * size, 2 * size), (size, 5 * size)])
    b = sv.Polygon([(5 * size, 5 * size), (8 * size, 3 * size), (4 * size, size)])
    for trace in (sv.record(a, b), sv.record(a, sv.Circle((size, size), size), every_axis=True)):
        text = json.dumps(rewritten(json.loads(trace.to_json()), int))
        assert "-0.0" not in text and sv.Trace.from_json(text) == trace
    scene = sv.Scene("large", a, b)
    assert sv.Scene.from_json(json.dumps(rewritten(json.loads(scene.to_json()), int))) == scene


def test_a_minus_zero_may_be_written_as_an_integer():
    corner = sv.Polygon([(-0.0, -0.0), (3, -0.0), (-0.0, 4)])
    trace = sv.record(corner, corner)
    text = trace.to_json()
    assert "-0.0" in text and sv.Trace.from_json(text.replace("-0.0", "-0")) == trace


@pytest.mark.parametrize("lossy", [2**53 + 1, 10**22 + 1, 10**310])
@pytest.mark.parametrize("path", [("a", "polygon", 0, 0), ("tests", 0, "a", "landings", 0), ("axes", 0, "normal", 1)])
def test_an_integer_that_float64_cannot_hold_is_refused(lossy, path):
    def put(data):
        for key in path[:-1]:
            data = data[key]
        data[path[-1]] = lossy

    with pytest.raises(sv.InvalidScene, match="float64"):
        sv.Trace.from_json(changed(put))


def test_a_given_choice_survives_json():
    some = axes.edge_normals(A, B)._replace(complete=False)
    trace = sv.record(A, B, axes=axes.Choice(some.axes[::2]), every_axis=True)
    assert sv.Trace.from_json(trace.to_json()) == trace
    trace = sv.record(A, B, axes=axes.directions((1, 2), (-3, 0.25)), every_axis=True)
    assert sv.Trace.from_json(trace.to_json()) == trace


# -- no more than a moment, and no more than memory ------------------------------------------------


def ngon(n, x=0.0):
    return sv.Polygon([(x + cos(2 * pi * i / n), sin(2 * pi * i / n)) for i in range(n)])


def test_a_trace_of_too_many_parts_is_described_drawn_and_saved_without_its_mtv():
    trace = sv.record(star(24), star(24, 1.3, 0.1))
    text = trace.to_json()
    assert json.loads(text)["mtv"] is None and sv.Trace.from_json(text) == trace
    assert str(trace).endswith("They have too many convex parts to search for the MTV.")
    assert "mtv" not in {mark.id for mark in sv.picture(trace, -1).marks}
    lied = json.loads(text) | {"mtv": [9.0, 9.0]}
    with pytest.raises(sv.InvalidScene, match="mtv"):
        sv.Trace.from_json(json.dumps(lied))


@pytest.mark.parametrize("every_axis", [False, True])
@pytest.mark.parametrize(
    ("shapes", "points"),
    [((box(0, 0, 4, 4), sv.Polygon([(1, 1), (3, 1), (2, 3)])), 7), ((sv.Circle((2, 1), 1), box(0, 0, 4, 4)), 6)],
)
def test_a_trace_ends_where_it_outgrows_its_limit(shapes, points, every_axis, monkeypatch):
    whole = sv.record(*shapes, every_axis=every_axis)
    size = points * (1 + len(whole.tests)) + len(whole.choice.axes) + len(whole.choice.skipped)
    monkeypatch.setattr(trace_module, "MAX_SIZE", size)
    assert sv.record(*shapes, every_axis=every_axis) == whole
    monkeypatch.setattr(trace_module, "MAX_SIZE", size - 1)
    message = (
        rf"A and B have {points} points to project on {len(whole.choice.axes)} axes: .* {size - 1} .*relate.*world"
    )
    with pytest.raises(sv.InvalidScene, match=message):
        sv.record(*shapes, every_axis=every_axis)
    assert len(sv.record(*shapes, axes=axes.world).tests) == 2


def test_a_trace_of_parts_ends_where_it_outgrows_its_limit(monkeypatch):
    whole = sv.record(L, box(2.5, 2.5, 3.5, 3.5))
    size = sum(8 * (1 + len(p.tests)) + len(p.choice.axes) + len(p.choice.skipped) for p in whole.pairs)
    monkeypatch.setattr(trace_module, "MAX_SIZE", size)
    assert sv.record(whole.a, whole.b) == whole
    monkeypatch.setattr(trace_module, "MAX_SIZE", size - 1)
    with pytest.raises(sv.InvalidScene, match=r"A and B have 2 pairs of convex parts: .*relate.*simplify"):
        sv.record(whole.a, whole.b)


@pytest.mark.parametrize("every_axis", [False, True])
def test_a_trace_of_pieces_ends_where_it_outgrows_its_limit(every_axis, monkeypatch):
    """The same holds for a file. All pieces count, whether one of them overlaps or not."""
    tiles = SHORTCUTS["tile-seam"]
    for b in box(3, -1, 3.5, 1), box(1, -1, 3, 1):
        whole = sv.record(box(0, 0, 4, 2), b, axes=tiles, every_axis=every_axis)
        assert len(whole.pairs) == 2
        size = sum(8 * (1 + len(p.tests)) + len(p.choice.axes) + len(p.choice.skipped) for p in whole.pairs)
        text = whole.to_json()
        monkeypatch.setattr(trace_module, "MAX_SIZE", size)
        assert sv.Trace.from_json(text) == whole
        monkeypatch.setattr(trace_module, "MAX_SIZE", size - 1)
        with pytest.raises(sv.InvalidScene, match=r"^A and B have 2 pairs of pieces: .*relate.*simplify"):
            sv.Trace.from_json(text)
        with pytest.raises(sv.InvalidScene, match=r"^A and B have 2 pairs of pieces: "):
            sv.record(whole.a, b, axes=tiles, every_axis=every_axis)
        monkeypatch.undo()


def test_two_polygons_of_a_thousand_vertices_are_refused_after_a_hundredth_of_the_work(monkeypatch):
    tested = []

    def counted(*args):
        return (tested.append(test) or test for test in axis_tests(*args))

    monkeypatch.setattr(trace_module, "axis_tests", counted)
    a, b = ngon(1000), ngon(1000, 0.1)
    with pytest.raises(sv.InvalidScene, match="2,000 points to project on"):
        sv.record(a, b)
    assert len(tested) <= 100
    assert sv.record(a, b, axes=axes.world).relation is sv.relate(a, b)
    assert sv.record(a, ngon(1000, 3)).separating  # the early exit keeps it small


def test_concave_outlines_of_hundreds_of_parts_are_refused_after_a_part_of_the_work(monkeypatch):
    tested = []

    def counted(*args):
        return (tested.append(test) or test for test in axis_tests(*args))

    monkeypatch.setattr(trace_module, "axis_tests", counted)
    with pytest.raises(sv.InvalidScene, match="40,401 pairs of convex parts"):
        sv.record(star(200), star(200, 1.99, 0.02), every_axis=True)
    assert len(tested) < 20_000


def test_the_parts_of_a_shape_are_computed_once_for_all_uses(monkeypatch):
    made = []
    monkeypatch.setattr(
        convex_parts, "_split", lambda shape, make=convex_parts._split: made.append(shape) or make(shape)
    )
    a, b = star(7), star(8, 1.3, 0.1)
    trace = sv.record(a, b)
    _ = trace.mtv, str(trace), trace.to_json(), trace.certificate.check(), sv.relate(a, b), sv.steps(trace)
    assert made == [a, b]


def test_the_table_of_many_pairs_of_parts_shows_the_first_and_the_one_that_collides():
    apart = sv.record(star(12), star(12, 1.99, 0.1))
    assert len(apart.pairs) == 169 and apart.relation is sv.Relation.APART
    text = str(apart)
    assert text.count(" against ") == 20 and "A1 against B1\n" in text and "(and 149 more pairs of parts)" in text
    late = sv.record(star(12), star(12, -1.3, 0.1))
    hit = late.colliding.names
    assert late.pairs.index(late.colliding) >= 20 and f"{hit.a} against {hit.b}\n" in str(late)
    assert "more pairs" not in str(sv.record(L, box(2.5, 2.5, 3.5, 3.5)))


@pytest.mark.parametrize("lie", sv.Relation)
@pytest.mark.parametrize("choice", ["world", "hull-normals", "needed"])
def test_a_certificate_is_right_even_where_relate_returns_a_wrong_relation(lie, choice, monkeypatch):
    for a, b in [(A, B), (A, A), (L, box(2.5, 2.5, 3.5, 3.5)), (L, box(1, 1, 3, 3)), (L, sv.Circle((3, 3), 1))]:
        truth = sv.relate(a, b)
        monkeypatch.setattr(trace_module, "relate", lambda a, b: lie)
        certificate = sv.record(a, b, axes=axes.NAMED[choice]).certificate
        assert certificate.check() and isinstance(certificate, SharedPoint) == (truth is not sv.Relation.APART)


def test_a_trace_that_could_not_be_read_again_is_not_written(monkeypatch):
    trace = sv.record(A, B)
    size = len(trace.to_json())
    monkeypatch.setattr(tracefile, "MAX_CHARS", size)
    assert sv.Trace.from_json(trace.to_json()) == trace
    with pytest.raises(sv.InvalidScene, match=rf"cannot|too large .*the limit is {size:,}"):
        trace.to_json(indent=1)
    many = ngon(1001)
    with pytest.raises(sv.InvalidScene, match="1,001 vertices: a file can hold 1,000"):
        sv.record(many, A, axes=axes.world).to_json()
    with pytest.raises(sv.InvalidScene, match="1,001 vertices"):
        sv.Scene("many", many, A).to_json()


@pytest.mark.parametrize("unit", ["[],", "{},", "1,", '"",', '"', "["])
def test_a_text_of_too_many_values_is_refused_before_it_is_read(unit, monkeypatch):
    monkeypatch.setattr(strictjson.json, "loads", None)
    monkeypatch.setattr(strictjson, "MAX_PUNCTUATION", 1000)
    with pytest.raises(sv.InvalidScene, match="the limit is 1,000"):
        sv.Trace.from_json(unit * 1001)


def test_closing_brackets_without_end_are_not_read_to_the_end():
    assert strictjson.parse("[[1], [2]]", 99) == [[1], [2]]
    with pytest.raises(sv.InvalidScene, match="not JSON"):
        strictjson.parse("]" * 1000 + "[" * 13, 2000)


# -- other axes ------------------------------------------------------------------------------------


def test_each_edge_of_an_upright_box_is_parallel_to_its_own_world_axis():
    left_out = sv.record(box(0, 0, 2, 1), box(1, 0, 3, 2)).skipped
    reasons = {(s.axis.normal.x == 0, s.why, s.number) for s in left_out}
    assert reasons == {(True, axes.PARALLEL, 1), (False, axes.PARALLEL, 2)}
    assert [s.axis.source.ids for s in left_out] == [(0, 1), (1, 2), (2, 3), (0, 3)] * 2


def test_a_hulls_axis_is_an_edges_where_the_hull_has_that_edge():
    for start in range(6):
        ring = L.vertices[start:] + L.vertices[:start]
        found = axes.hull_normals(sv.Polygon(ring), COIN).axes
        kinds = {frozenset(ring[i] for i in axis.source.ids): axis.source.kind for axis in found}
        assert len(found) == 5 and kinds.pop(frozenset({(4, 2), (2, 4)})) == "hull edge normal"
        assert set(kinds.values()) == {"edge normal"}


@pytest.mark.parametrize("size", [1.0, 2.0**-600, 2.0**600])
def test_a_circle_off_a_corner_touches_on_the_axis_of_that_corner_whoever_it_belongs_to(size):
    corner, circle = box(0, 0, size, size), sv.Circle((4 * size, 5 * size), 5 * size)
    for a, b in [(corner, circle), (circle, corner)]:
        trace = sv.record(a, b)
        last = trace.tests[-1]
        assert last.gap == 0 and last.source == ("nearest vertex", "A" if a is corner else "B", (2,))
        assert trace.relation is sv.Relation.TOUCHING and last.axis.direction == pytest.approx((0.6, 0.8))


# -- floats and integers ---------------------------------------------------------------------------


def never(*_):
    raise AssertionError("the float filter should have certified this")


@pytest.mark.parametrize("e", [-280, -40, 0, 40, 280])
def test_the_axes_of_ordinary_pairs_need_no_integers(e, monkeypatch):
    monkeypatch.setattr(sat, "_exact_test", never)
    s = 2.0**e
    triangles = [sv.Polygon([(x * s, y * s) for x, y in shape.vertices]) for shape in (A, B)]
    round_ones = sv.Circle((0, 4 * s), s / 2), sv.Circle((6 * s, 3 * s), s)
    for a in (*triangles, *round_ones):
        for b in (*triangles, *round_ones):
            assert sv.record(a, b, every_axis=True).relation is sv.relate(a, b)


@pytest.mark.parametrize("every_axis", [False, True])
@pytest.mark.parametrize("move", [0.0, 1.0, -0.4])
def test_shapes_wider_than_float64_can_hold_are_described_and_saved(every_axis, move):
    a = sv.Polygon([(-1.7e308, -1.6e308), (1.7e308, -1e300), (0, 1.7e308)])
    b = sv.Polygon([(-1.7e308 + move * 2e307, 1.7e308), (-1.6e308, 1.5e308), (1.7e308, 1.79e308)])
    trace = sv.record(a, b, every_axis=every_axis)
    assert str(trace) and trace.sentence and all(describe.test_sentence(trace, i) for i in range(len(trace.tests)))
    assert sv.Trace.from_json(trace.to_json()) == trace


@pytest.mark.parametrize("share", one_in(2, range(8)))
def test_tests_recorded_with_integers_equal_those_with_floats_and_gaps_agree_to_five_digits(share, monkeypatch):
    some = SOME[share::8]
    by_floats = [sv.record(a, b, every_axis=True).tests for _, a, b in some]
    monkeypatch.setattr(sat, "CLOSE_GAP_FACTOR", float("inf"))
    for (_, a, b), floats in zip(some, by_floats, strict=True):
        size = max(abs(c) for shape in (a, b) for c in shape.bounds)
        for one, other in zip(floats, sv.record(a, b, every_axis=True).tests, strict=True):
            assert one.axis == other.axis
            assert one.gap == pytest.approx(other.gap, rel=1e-5, abs=0)
            for p, q in ((one.a, other.a), (one.b, other.b)):
                assert p.landings == pytest.approx(q.landings, rel=1e-12, abs=1e-14 * size)
                for u, v in zip(p.points, q.points, strict=True):
                    assert u == pytest.approx(v, rel=1e-12, abs=1e-14 * size)


@pytest.mark.parametrize("e", [-1074, -1070, -1060, -1030, 1010, 1016])
def test_a_gap_has_the_exact_sign_at_the_ends_of_float64(e):
    rng = Random(e)
    for _ in range(60):
        a, b = ([(ldexp(rng.randint(-60, 60), e), ldexp(rng.randint(-60, 60), e)) for _ in range(3)] for _ in "ab")
        try:
            a, b = sv.Polygon(a), rng.choice((sv.Polygon(b), sv.Circle(b[0], ldexp(rng.randint(1, 60), e))))
        except sv.InvalidShape:
            continue
        for test in sv.record(a, b, every_axis=True).tests:
            assert (test.gap > 0) - (test.gap < 0) == exact_gap_sign(a, b, test), (a, b, test)


def test_axes_are_tested_one_by_one_and_by_default_the_needed_ones():
    for _, a, b in SOME[:50]:
        if sv.record(a, b).pairs:
            continue
        assert list(sv.axis_tests(a, b)) == list(sv.record(a, b, every_axis=True).tests)
    used = []

    def watched():
        for axis in axes.needed(A, B).axes:
            used.append(axis)
            yield axis

    assert next(t for t in sv.axis_tests(A, B, watched()) if t.separates).source is used[-1].source
    assert len(used) == 2


def test_a_touching_circles_extremes_are_its_points_along_the_axis():
    on_x = sv.record(box(0, 0, 2, 2), sv.Circle((3, 1), 1), axes=axes.world, every_axis=True).tests[1]
    assert on_x.gap == 0 and on_x.b == (((2, 1), (4, 1)), (2, 4))
    slanted = sv.record(sv.Circle((0, 0), 2), sv.Circle((3, 4), 3)).tests[0]
    assert slanted.gap == 0 and slanted.a.landings == (-2, 2) and slanted.b.landings == (2, 8)
    assert [close(p, q) for p, q in zip(slanted.b.points, [(1.2, 1.6), (4.8, 6.4)])] == [True, True]
    at_nothing = sv.record(sv.Circle((-1, 0), 1), sv.Circle((1, 0), 1)).tests[0]
    assert [repr(t) for t in (*at_nothing.a.landings, *at_nothing.b.landings)] == ["-2.0", "0.0", "0.0", "2.0"]


def test_extremes_beyond_float64_are_shown_at_its_rim():
    most = sys.float_info.max
    test = sv.record(sv.Circle((1.5e308, -1.5e308), 1e308), sv.Circle((-1.5e308, 1.5e308), 1e308)).tests[0]
    assert {abs(c) for side in (test.a, test.b) for p in side.points for c in p} >= {most}
    assert all(abs(c) <= most for side in (test.a, test.b) for p in side.points for c in p)
    assert test.a.points[1] == (most, -most) and test.b.points[0] == (-most, most)


@pytest.mark.parametrize("keep", ["all", "first", "none of it", "more"])
def test_the_claim_of_a_shortcut_that_splits_is_that_of_its_pieces_and_its_certificate_holds(keep):
    u = sv.Polygon([(0, 0), (6, 0), (6, 4), (5, 4), (5, 1), (1, 1), (1, 4), (0, 4)])
    far = sv.Polygon([(90, 0), (91, 0), (91, 1)])
    pieces = {"all": sv.parts(u), "first": sv.parts(u)[:1], "none of it": [far], "more": [sv.Polygon(u.vertices[:4])]}
    mine = sv.Shortcut("mine", "these are all", split=lambda shape: pieces[keep])
    l_shape = sv.Polygon([(2, 2), (4, 2), (4, 6), (9, 6), (9, 7), (2, 7)])
    for b in l_shape, sv.Polygon([(5.5, 3), (8, 3), (8, 4)]), sv.Polygon([(2, 2), (3, 2), (3, 3)]), far:
        trace = sv.record(u, b, axes=mine)
        assert trace.relation is sv.relate(u, b)
        assert trace.claim is max(sv.relate(piece, b) for piece in pieces[keep])
        assert [pair.names for pair in trace.pairs] == [(f"A{i + 1}", "B") for i in range(len(pieces[keep]))]
        assert str(trace) and sv.picture(trace).marks
        if trace.missed_hit:
            assert trace.mtv is None and trace.separating is None
            with pytest.raises(sv.InvalidScene):
                trace.certificate  # noqa: B018
        else:
            assert trace.certificate.check()
