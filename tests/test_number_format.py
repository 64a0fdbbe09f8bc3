"""Tests of numbers as text: the printed ranges never contradict the printed gap."""

import re
from fractions import Fraction
from random import Random

import pytest

import satviz as sv
from satviz.engine import describe, number_format
from satviz.engine.number_format import MINUS
from satviz.scenes.shape_tools import box


def value(text):
    """Return a printed number or sum as a fraction: "727606874 + 0.957"."""
    text = text.replace(" + ", " +").replace(f" {MINUS} ", f" {MINUS}").replace(MINUS, "-")
    return sum(Fraction(piece) for piece in text.split())


def ends(text):
    """Return the ends of a printed range: "727606874 + [0.957, 3.1]"."""
    origin, inside, unit = re.fullmatch(r"\(?(?:(\S*) \+ )?\[(.*)\]\)?(e.*)?", text).groups()
    return [(value(end) + value(origin or "0")) * value(f"1{unit or ''}") for end in inside.split(", ")]


def printed_gap(text):
    (alo, ahi), (blo, bhi) = map(ends, text)
    return max(alo - bhi, blo - ahi)


def sign(number):
    return (number > 0) - (number < 0)


def placed(rng, size, far):
    """Return two polygons or circles of about that size, that far from the origin, with every kind of gap."""
    where = size * far * rng.choice((-1, 1)), size * far * rng.choice((-1, 0, 1))
    near = size * rng.choice((1, 1e-3, 1e-9, 1e-15))
    a = sv.Polygon([(where[0] + x * size, where[1] + y * size) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))])
    edge = max(v.x for v in a.vertices)
    if rng.random() < 0.3:
        return a, sv.Circle((edge + size / 2 + near * rng.choice((-1, 0, 1)), where[1] + size / 2), size / 2)
    start = edge + near * rng.choice((-1, 0, 1)) * rng.random()
    points = [(start, where[1]), (start + size * rng.random() + near, where[1]), (start, where[1] + size * 0.7)]
    return a, sv.Polygon(points)


@pytest.mark.parametrize("seed", range(40))
def test_printed_ranges_agree_with_the_printed_gap(seed):
    rng = Random(seed)
    for _ in range(25):
        try:
            a, b = placed(rng, 10.0 ** rng.randint(-9, 9), rng.choice((0, 0, 2.0 ** rng.randint(0, 40))))
        except sv.InvalidShape:  # so far out that its corners are one
            continue
        trace = sv.record(a, b, every_axis=True)
        for t in trace.tests:
            digits = describe.digits(trace, t)
            text, gap = digits.ranges(t), value(digits.signed(t.gap).lstrip("+"))
            assert sign(printed_gap(text)) == sign(t.gap) == sign(gap), (text, t.gap)
            assert abs(printed_gap(text) - gap) <= abs(gap) / 50, (text, gap)
            assert max(map(len, text)) < 52


def test_far_from_the_origin_the_ranges_are_printed_from_near_them():
    trace = sv.record(box(7.276e8, 0, 7.276e8 + 2, 1), box(7.276e8 + 2.970, 0, 7.276e8 + 5, 1))
    t = trace.separating
    assert describe.digits(trace, t).ranges(t) == ("727600000 + [0, 2]", "727600000 + [2.970, 5]")
    assert "gap +0.970" in describe.test_sentence(trace, trace.tests.index(t))


def test_a_gap_too_fine_for_the_ranges_is_printed_beside_the_end_it_is_measured_from():
    trace = sv.record(box(0, 0, 1, 1), sv.Polygon([(1 + 2**-52, 0), (2, 0), (2, 1)]))
    t = trace.separating
    assert describe.digits(trace, t).ranges(t) == ("[0, 1]", f"[1 + 2.220e{MINUS}16, 2]")


@pytest.mark.parametrize("scale, unit", [(1e-9, f"e{MINUS}9"), (1e9, "e9"), (1e-3, f"e{MINUS}3"), (1, ""), (1e5, "")])
def test_all_numbers_of_a_scene_have_one_unit_that_fits_it(scale, unit):
    trace = sv.record(box(0, 0, 2 * scale, scale), box(3.5 * scale, 0, 7 * scale, scale))
    shown = [number * (scale if not unit else 1) for number in (2, 3.5, 7)]
    two, three, seven = (f"{number:.7g}" for number in shown)
    assert describe.digits(trace).ranges(trace.separating) == (f"[0, {two}]{unit}", f"[{three}, {seven}]{unit}")


def test_minus_signs_are_true_ones_in_sentences_and_ascii_in_files_and_tables():
    trace = sv.record(box(0, 0, 2, 2), box(1, -1, 3, 1))
    assert MINUS in trace.sentence and MINUS not in trace.to_json() and MINUS not in str(trace)
    assert sv.Trace.from_json(trace.to_json()) == trace
    assert "-" not in sv.picture(trace, 5).sentence


@pytest.mark.parametrize(
    "number, text", [(0.0, "0"), (1e-5, f"1.000e{MINUS}5"), (-2.5, f"{MINUS}2.5"), (1 / 3, "0.333")]
)
def test_a_number_keeps_its_zeros_only_where_digits_were_cut(number, text):
    assert number_format.number(number) == text


@pytest.mark.parametrize("size", [1e-9, 3e-4, 1.0, 1e5, 1e9])
def test_an_overlap_has_three_digits_however_narrow_the_range_that_lies_inside(size):
    for k in range(1, 13):
        w = 3.217 * size * 10.0**-k
        x, y = size / 3, size / 7
        inner = sv.Polygon([(x, y), (x + w, y), (x + w, y + w / 2), (x, y + w)])
        trace = sv.record(sv.Polygon([(0, 0), (size, 0), (size, size), (0, size)]), inner)
        for t in trace.tests:
            shared = min(t.a.interval.hi, t.b.interval.hi) - max(t.a.interval.lo, t.b.interval.lo)
            digits = describe.digits(trace, t)
            said = [value(word.rstrip(",")) for word in describe.outcome(t, digits).split() if word[0].isdigit()]
            for number, text in zip((shared, -t.gap), (said[0], said[-1]), strict=True):
                if number == shared or len(said) > 1:
                    assert abs(text - Fraction(number)) <= Fraction(number) / 199, (
                        describe.outcome(t, digits),
                        number,
                    )
