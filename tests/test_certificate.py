"""Tests of certificates: they are checked with fractions alone, and one that nearly proves a relation is refused."""

import re
from fractions import Fraction
from math import nextafter
from random import Random

import pytest

import satviz as sv
from satviz.engine import certificate
from satviz.engine.certificate import PartLines, SeparatingLine, SharedPoint
from satviz.scenes.shape_tools import box

L = sv.Polygon([(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)])
HAIR = Fraction(1, 10**40)


def frac(*values: float) -> tuple[Fraction, ...]:
    return tuple(map(Fraction, values))


# -- separating lines ------------------------------------------------------------------------------


@pytest.mark.parametrize("large", [3, 999, 1001, 4000, 1e300])
@pytest.mark.parametrize("offset", [0, -7 / 3, 4e307, 1.75e308, -1.75e308])
def test_the_equation_of_a_line_read_back_is_that_line(large, offset):
    """Half of the offset is in lengths of the normal; as the sum of two coordinates it can be beyond float64."""
    shape, offset = box(0, 0, 1, 1), Fraction(offset) * 2
    for nx, ny in ((large, 1), (-1, large), (-large, 2), (-2, -large), (large, large), (-large, -large)):
        line = SeparatingLine(shape, shape, frac(nx, ny), offset * Fraction(large))
        text = line.equation.replace("\N{MINUS SIGN}", "-").replace(" ", "")
        words = re.fullmatch(r"(-?)([\d.e-]*)x([+-])([\d.e-]*)y=(-?[\d.e-]+)", text)
        x, y = (Fraction(words[k] + (words[k + 1] or "1")) for k in (1, 3))
        assert max(abs(x), abs(y)) <= 1000 and Fraction(words[5]) < 10**308
        assert not {"1", "1.000"} & {words[2], words[4]}  # the factor 1 is not written
        unit = Fraction(nx) / x
        for read, true in ((x, nx), (y, ny), (Fraction(words[5]), line.offset)):
            assert abs(read * unit - Fraction(true)) <= abs(Fraction(true)) / 200


@pytest.mark.parametrize(
    ("a", "b", "normal", "lo", "hi"),
    [
        (box(0, 0, 1, 1), box(3, 5, 4, 6), (1, 0), 1, 3),
        (box(0, 0, 1, 1), box(3, 5, 4, 6), (0, 2), 2, 10),
        (sv.Circle((0, 0), 1), sv.Circle((4, 1), 1), (1, 0), 1, 3),
        (sv.Circle((1, 2), 5), sv.Circle((10, 14), 5), (3, 4), 11 + 25, 86 - 25),
        (sv.Circle((1, 2), 5), box(9, 12, 20, 20), (3, 4), 11 + 25, 27 + 48),
        (sv.Polygon([(0, 0), (2, 0), (0, 2)]), sv.Polygon([(3, 3), (1, 3), (3, 1)]), (1, 1), 2, 4),
    ],
)
def test_a_line_separates_only_strictly_between_the_shapes(a, b, normal, lo, hi):
    for offset in (lo + HAIR, Fraction(lo + hi, 2), hi - HAIR):
        assert SeparatingLine(a, b, frac(*normal), offset).check()
        assert SeparatingLine(b, a, frac(*normal), offset).check()
        assert SeparatingLine(a, b, frac(-normal[0], -normal[1]), -offset).check()
    for offset in (lo - 100, lo - HAIR, lo, hi, hi + HAIR, hi + 100, -lo, -hi):
        assert not SeparatingLine(a, b, frac(*normal), Fraction(offset)).check()
        assert not SeparatingLine(b, a, frac(*normal), Fraction(offset)).check()


@pytest.mark.parametrize("a", [box(0, 0, 1, 1), sv.Circle((0.5, 0), 0.5)], ids=["box", "circle"])
@pytest.mark.parametrize("b", [box(3, 5, 4, 6), sv.Circle((3.5, 5), 0.5)], ids=["box", "circle"])
def test_a_line_that_cuts_a_shape_separates_nothing_wherever_it_cuts(a, b):
    for offset in (0.25, 0.5, 0.75, 3.25, 3.5, 3.75):
        assert not SeparatingLine(a, b, frac(1, 0), Fraction(offset)).check()
        assert not SeparatingLine(b, a, frac(1, 0), Fraction(offset)).check()


@pytest.mark.parametrize(
    ("normal", "offset", "text"),
    [
        ((3, 4), 25, "3x + 4y = 25"),
        ((-3, -1), 2.5, "-3x - y = 2.5"),
        ((1000, 999), 1000, "1000x + 999y = 1000"),
        ((-1, 1000), 0, "-x + 1000y = 0"),
        ((1001, -2002), 2002, "0.5x - y = 1"),  # of large numbers the largest becomes 1
        ((3, 4), 10**308, "3x + 4y = 1.000e308"),  # where the right side would be larger, too, and then 1/4
        ((3, 4), 10**308 + 1, "0.75x + y = 2.500e307"),
        ((3, 4), 4 * 10**308, "0.75x + y = 1.000e308"),
        ((3, -4), -4 * 10**308 - 1, "0.188x - 0.25y = -2.500e307"),
        ((2002, 2002), 2002 * 2 * 10**308, "0.25x + 0.25y = 5.000e307"),
    ],
    ids=range(10),
)
def test_whole_coefficients_up_to_1000_are_not_scaled_unless_the_right_side_overflows(normal, offset, text):
    shape = box(0, 0, 1, 1)
    assert str(SeparatingLine(shape, shape, frac(*normal), Fraction(offset))) == f"separating line {text}"


@pytest.mark.parametrize(
    ("size", "offset", "at"), [(4, 3, "3"), (4e9, 3e9, "3e9"), (4e-9, 3e-9, "3e-9"), (4, 3e-9, "3.000e-9")]
)
@pytest.mark.parametrize("length", [1, -1, 2, -0.5])
def test_the_number_of_an_upright_line_has_the_unit_that_fits_both_shapes(size, offset, at, length):
    small, large = box(-size / 1e6, -size / 1e6, 0, 0), box(size, size, 2 * size, 2 * size)
    for a, b in (small, large), (large, small):
        for normal, text in ((length, 0), f"x = {at} (parallel to y)"), ((0, length), f"y = {at} (parallel to x)"):
            line = SeparatingLine(a, b, frac(*normal), Fraction(offset) * Fraction(length))
            assert line.check() and str(line) == f"separating line {text}"


def test_a_lines_point_is_the_nearest_to_the_origin():
    a, b = box(0, 0, 1, 1), box(5, 5, 6, 6)
    assert SeparatingLine(a, b, frac(3, 4), Fraction(25)).point == (3, 4)
    assert SeparatingLine(a, b, frac(-1, 1), Fraction(3)).point == (-1.5, 1.5)
    assert {type(c) for c in SeparatingLine(a, b, frac(-1, 3), Fraction(3)).point} == {float}


def gap_on(line: SeparatingLine) -> tuple[float, float]:
    """Return how far the line is from the first and from the second shape, in scene units."""
    nx, ny = map(float, line.normal)
    length = (nx * nx + ny * ny) ** 0.5
    away = []
    for shape in (line.a, line.b):
        points, r = ([shape.center], shape.radius) if isinstance(shape, sv.Circle) else (shape.vertices, 0)
        away.append(min(abs(nx * x + ny * y - float(line.offset)) for x, y in points) / length - r)
    return away[0], away[1]


@pytest.mark.parametrize("e", [-300, -3, 0, 3, 300])
def test_a_separating_line_runs_in_the_middle_of_the_gap(e):
    s = 2.0**e
    shapes = [
        sv.Polygon([(0, 0), (3 * s, s), (s, 2 * s)]),
        sv.Polygon([(9 * s, 8 * s), (7 * s, 9 * s), (5 * s, 5 * s)]),
        sv.Circle((0, 8 * s), 1.5 * s),
        sv.Circle((9 * s, s), s),
    ]
    for a in shapes:
        for b in shapes:
            if a is not b:
                line = sv.record(a, b).certificate
                assert line.check() and (line.a, line.b) == (a, b)
                assert all(n.denominator == 1 for n in line.normal)
                near, far = gap_on(line)
                assert near == pytest.approx(far, rel=1e-4)


def test_the_normal_of_a_line_is_the_shortest_integer_vector():
    assert sv.record(box(0, 0, 1, 1), box(6, 0, 7, 1)).certificate.normal == (1, 0)
    slanted = sv.Polygon([(0, 0), (6, 0), (0, 4)]), sv.Polygon([(6, 4), (6, 5), (5, 5)])
    assert sv.record(*slanted, axes=sv.axes.edge_normals_of_a).certificate.normal == (2, 3)


def test_a_whole_radius_is_not_rounded():
    assert sv.record(sv.Circle((0, 0), 1), sv.Circle((4, 0), 1.5)).certificate.offset == Fraction(7, 4)
    assert sv.record(sv.Circle((0, 0), 5), box(9, -1, 11, 1)).certificate.offset == 7


# (s, p, q): s*s - (p*p + q*q) is a single digit, so a circle of radius 1 at s / |(p, q)| from an edge hardly clears it
HAIRS = (300_000, 239_792, 180_277), (300_002, 299_801, 10_980), (300_009, 299_543, 16_715)


@pytest.mark.parametrize(("s", "p", "q"), HAIRS)
def test_a_gap_narrower_than_the_first_bracket_of_the_root_still_has_a_separating_line(s, p, q):
    x = s * pow(p, -1, q) % q  # a whole point with p*x + q*y = s
    y = (s - p * x) // q
    away = sv.Polygon([(0, 0), (-q, p), (-p, -q)])  # all below its edge p*x + q*y = 0
    for turn in ((1, 0), (0, 1), (-1, 0), (0, -1)):
        c, w = turn
        polygon = sv.Polygon([(c * u - w * v, w * u + c * v) for u, v in away.vertices])
        circle = sv.Circle((c * x - w * y, w * x + c * y), 1)
        for a, b in ((polygon, circle), (circle, polygon)):
            line = sv.record(a, b, axes=sv.axes.edge_normals).certificate
            assert isinstance(line, SeparatingLine) and line.check()


# -- shared points ---------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("shape", "inside", "outside"),
    [
        (
            box(0, 0, 4, 3),
            [(0, 0), (4, 3), (4, 1), (2, 0), (1, 1)],
            [(4 + HAIR, 1), (2, -HAIR), (-HAIR, 0), (1, 3 + HAIR)],
        ),
        (sv.Circle((1, 2), 5), [(1, 2), (4, 6), (-4, 2), (4, -2)], [(4 + HAIR, 6), (-4 - HAIR, 2), (6, 7)]),
        (L, [(0, 0), (2, 2), (4, 2), (2, 3), (1, 1), (0, 4)], [(2 + HAIR, 2 + HAIR), (3, 3), (4, 4), (-1, 1)]),
    ],
    ids=["box", "circle", "concave"],
)
def test_a_point_is_shared_if_it_lies_in_both_shapes_borders_included(shape, inside, outside):
    everywhere = box(-99, -99, 99, 99)
    for x, y in inside:
        assert SharedPoint(shape, everywhere, Fraction(x), Fraction(y)).check()
        assert SharedPoint(everywhere, shape, Fraction(x), Fraction(y)).check()
    for x, y in outside:
        assert not SharedPoint(shape, everywhere, Fraction(x), Fraction(y)).check()
        assert not SharedPoint(everywhere, shape, Fraction(x), Fraction(y)).check()


@pytest.mark.parametrize(
    ("a", "b", "point"),
    [
        (box(0, 0, 4, 4), box(2, 2, 6, 8), (3, 3)),
        (box(0, 0, 4, 4), box(4, 1, 6, 3), (4, 2)),
        (box(0, 0, 9, 9), box(1, 2, 3, 8), (2, 5)),
        (sv.Polygon([(0, 0), (6, 0), (0, 6)]), sv.Polygon([(6, 6), (0, 6), (6, 0)]), (3, 3)),
        (sv.Polygon([(-2, -1), (2, -1), (0, 3)]), sv.Polygon([(0, -3), (2, 1), (-2, 1)]), (0, 0)),
        (sv.Circle((0, 0), 3), sv.Circle((5, 0), 2), (3, 0)),
        (sv.Circle((0, 1), 3), sv.Circle((4, 9), 9), (1, 3)),
        (sv.Circle((5, 1), 2), box(0, 0, 4, 4), (4, 1)),
        (sv.Circle((7, 8), 5), box(0, 0, 4, 4), (4, 4)),
        (sv.Circle((-1, -1), 2), box(0, 0, 4, 4), (0, 0)),
        (sv.Circle((1, 3), 9), box(0, 0, 4, 4), (1, 3)),
        (sv.Circle((0.25, 0.125), 1), box(0, 0, 0.5, 0.5), (0.25, 0.125)),
        (sv.Circle((3, 6), 9), sv.Polygon([(0, 0), (8, 4), (4, 0)]), (4.8, 2.4)),
    ],
)
def test_the_shared_point_lies_well_inside_the_overlap_or_on_the_touch(a, b, point):
    for first, second in ((a, b), (b, a)):
        found = sv.record(first, second).certificate
        assert isinstance(found, SharedPoint) and found.check()
        assert found.point == pytest.approx(point) and {type(c) for c in found.point} == {float}


def test_the_shared_point_has_float_coordinates_where_these_suffice():
    a, b = sv.Polygon([(0, 0), (7, 1), (2, 6)]), sv.Polygon([(3, 0), (8, 5), (1, 4)])
    found = sv.record(a, b).certificate
    assert (found.x, found.y) == (Fraction(float(found.x)), Fraction(float(found.y)))


def test_a_shared_point_is_computed_once():
    a, b = box(0, 0, 4, 4), box(2, 2, 6, 6)
    assert certificate.shared_point(a, b) is certificate.shared_point(a, b)


def test_needles_that_cross_between_the_floats_share_a_fraction():
    rng = Random(9)
    third = 0
    for _ in range(60):
        x, y = float(rng.randint(3, 99)), float(rng.randint(3, 99))
        up, flat = nextafter(y, 200), nextafter(x, 200)
        a = sv.Polygon([(0, 0), (200, y), (200, up)])
        b = sv.Polygon([(x, -9), (flat, -9), (x + 9, 200)])
        found = sv.record(a, b).certificate
        assert found.check(), (a, b)
        third += isinstance(found, SharedPoint) and found.y.denominator & (found.y.denominator - 1) > 0
    assert third > 5


def test_a_shared_point_is_found_at_the_limit_of_float64():
    wide = box(-1.7e308, -1.7e308, 1.7e308, 1.7e308)
    for other in (
        wide,
        box(1e308, 1e308, 1.6e308, 1.6e308),
        sv.Polygon([(-1e308, 0), (1e308, -1e308), (1e308, 1e308)]),
    ):
        assert sv.record(wide, other).certificate.check()


@pytest.mark.parametrize("way", [1, -1])
def test_a_shared_point_is_found_where_only_one_coordinate_is_at_the_limit(way):
    m = 1.7e308
    rings = [(0.8 * m, 2), (0.6 * m, 0), (-m, -1)], [(m, 1), (0.6 * m, 0), (0.8 * m, 3)]
    a, b = (sv.Polygon([v[::way] for v in ring]) for ring in rings)
    assert isinstance(found := sv.record(a, b).certificate, SharedPoint) and found.check()


# -- concave outlines ------------------------------------------------------------------------------


def test_lines_prove_nothing_unless_there_is_one_for_every_pair_of_parts_that_fill_the_shapes(monkeypatch):
    lines = sv.record(box(2.5, 2.5, 3.5, 3.5), L).certificate
    assert isinstance(lines, PartLines) and lines.check() and len(lines.lines) == 2
    assert str(lines) == "2 separating lines, one a pair of parts"
    first, second = lines.lines
    for less in ((first,), (second, first), (first, first), (first, second, second), ()):
        assert not lines._replace(lines=less).check()
    assert not lines._replace(lines=(first, second._replace(offset=second.offset + 9))).check()
    assert not lines._replace(lines=(first._replace(offset=first.offset - 9), second)).check()
    every = certificate.parts
    monkeypatch.setattr(certificate, "parts", lambda shape: every(shape)[:1])
    assert not lines._replace(lines=(first,)).check()  # half of the L


@pytest.mark.parametrize(
    "ring",
    [
        [(1, 1), (5, 1), (5, 3), (3, 3), (3, 6), (1, 6)],
        [(-7, -9), (1, -3), (9, -8), (4, 0), (11, 7), (0, 5), (-9, 8), (-4, 1)],
        [(2, 3), (9, 4), (8, 11), (6, 5)],
    ],
)
def test_lines_past_all_parts_of_a_concave_outline_are_a_proof(ring):
    shape = sv.Polygon(ring)
    for other in (sv.Circle((30, 40), 7), sv.Polygon([(20, 1), (30, 5), (22, 9), (24, 5)]), box(-30, 0, -20, 9)):
        for a, b in ((shape, other), (other, shape)):
            lines = sv.record(a, b).certificate
            assert isinstance(lines, PartLines) and lines.check()


def test_a_separating_line_at_the_limit_of_float64_has_a_point_to_draw():
    most = 1.7976931348623157e308
    k = most / 1024
    a = sv.Polygon([(most - 2 * k, most), (most - 4 * k, most - 8 * k), (most, most - 4.83 * k)])
    b = sv.Polygon([(most, most), (most, most - 2.4142 * k), (most - k, most)])
    line = sv.record(a, b, every_axis=True).certificate
    assert line.check() and line.point.x == most and line.point.y < most  # the line's own is 1.2 times as far out
