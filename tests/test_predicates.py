"""Tests of the predicates: signs are exact at every size, and certified by floats where these suffice."""

import ctypes
import math
import platform
import sys
import warnings
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from random import Random

import pytest
from strategies import SIZES, nearly_straight

from satviz.engine import predicates
from satviz.study import truth as oracle

LARGEST, LEAST = sys.float_info.max, 5e-324


@pytest.fixture
def no_integers(monkeypatch) -> None:
    """Make every use of integers fail from here on."""

    def refuse(*_):
        raise AssertionError("the float filter should have certified this")

    monkeypatch.setattr(predicates, "to_integers", refuse)


def test_the_sign_of_an_integer_is_minus_one_zero_or_one():
    assert [predicates.sign(n) for n in (-(10**30), -2, -1, 0, 1, 2, 10**30)] == [-1, -1, -1, 0, 1, 1, 1]


def test_to_integers_divides_by_the_largest_power_of_two():
    assert predicates.to_integers([3.0]) == (0, [3])
    assert predicates.to_integers([0.5, -3.0, 0.0, 0.75]) == (2, [2, -12, 0, 3])
    assert predicates.to_integers([5e-324, 1.0]) == (1074, [1, 1 << 1074])
    assert predicates.to_int_points([(0.5, -3.0), (0.0, 0.75), (1.0, 2.0)]) == (2, [(2, -12), (0, 3), (4, 8)])


def test_two_shapes_get_a_common_unit_whichever_is_finer():
    class Given:
        def __init__(self, *integers):
            self.integers = integers

    fine, coarse = Given(3, [(8, 1)], 5), Given(1, [(2, 3), (4, 7)], 2)
    assert predicates.to_common_unit(fine, coarse) == ([(8, 1)], [(8, 12), (16, 28)], 13, 3)
    assert predicates.to_common_unit(coarse, fine) == ([(8, 12), (16, 28)], [(8, 1)], 13, 3)
    assert predicates.to_common_unit(fine, fine) == ([(8, 1)], [(8, 1)], 10, 3)


@pytest.mark.parametrize("size", SIZES)
def test_an_orientation_is_exact_at_every_size(size):
    rng = Random(str(size))
    seen = set()
    for _ in range(600):
        p, q, r = nearly_straight(rng, size)
        turn = oracle.orientation(p, q, r)
        seen.add(predicates.sign(turn))
        assert predicates.orient(p, q, r) == predicates.sign(turn), (p, q, r)
    assert seen == {-1, 0, 1}


def test_an_orientation_is_exact_where_its_products_lose_bits():
    p, q, r = (
        ("0x1.94a11cacfb9c4p-513", "-0x1.1379841beacd0p-514"),
        ("0x1.27776777918f9p-515", "-0x1.8414987598bebp-516"),
        ("-0x1.3a83484c08f30p-513", "0x1.c2148935c9610p-516"),
    )
    p, q, r = (tuple(map(float.fromhex, v)) for v in (p, q, r))
    assert predicates.orient(p, q, r) == predicates.sign(oracle.orientation(p, q, r)) == 1


@pytest.mark.parametrize("size", SIZES[5:11])
def test_an_ordinary_orientation_needs_no_integers(size, no_integers):
    for p, q, r in (((0, 0), (3, 1), (2, 2)), ((-4, 1), (3, 5), (-1, 9)), ((7, -2), (-3, -2), (5, -1))):
        points = [(x * size, y * size) for x, y in (p, q, r)]
        assert (
            predicates.orient(*points)
            == -predicates.orient(*points[::-1])
            == predicates.sign(oracle.orientation(*points))
            != 0
        )


def root_sign(s: int, r: int, square: int) -> int:
    """Return the sign of s - r * sqrt(square), for r >= 0, from the squares."""
    return predicates.sign(s * abs(s) - r * r * square)


@pytest.mark.parametrize("squares", [1, 2, 3, 4, 25, 10**40 + 1, 4**200])
def test_a_difference_from_a_root_has_the_exact_sign(squares):
    for r in (0, 1, 2, 5, 10**20):
        whole = math.isqrt(r * r * squares)
        for s in (-whole - 1, -1, 0, 1, whole - 1, whole, whole + 1, 2 * whole + 1):
            assert predicates.sign(predicates.root_difference(s, r, squares, 0)) == root_sign(s, r, squares), (s, r)


def test_a_root_is_rounded_up():
    assert predicates.ceil_sqrt(0) == 0
    for n in [*range(1, 100), *(k**2 + d for k in (10**9 + 7, 3**99) for d in (-1, 0, 1))]:
        root = predicates.ceil_sqrt(n)
        assert (root - 1) ** 2 < n <= root**2


def test_an_integer_over_a_power_of_two_is_rounded_once():
    rng = Random(4)
    for _ in range(500):
        num, k = rng.randint(-(2**90), 2**90), rng.randint(-60, 300)
        value = predicates.to_float(num, k)
        assert type(value) is float
        assert value == float(Fraction(num) / Fraction(2) ** k), (num, k)


def test_a_number_beyond_float64_keeps_its_sign():
    assert [predicates.to_float(n, -1100) for n in (-2, -1, 1, 2)] == [-LARGEST, -LARGEST, LARGEST, LARGEST]
    assert [predicates.to_float(n, 2000) for n in (-2, -1, 1, 2)] == [-LEAST, -LEAST, LEAST, LEAST]
    assert [predicates.to_float(1 << 1100, k) for k in (0, 1, -1)] == [LARGEST] * 3
    for k in (-3000, 0, 3000):
        assert repr(predicates.to_float(0, k)) == "0.0"


def well_rounded(value: float, s: int, r: int, square: int, k: int) -> bool:
    """Return whether value is within a unit in the last place of (s / sqrt(square) - r) / 2**k, by 600-bit bounds."""
    bits = 600
    root = math.isqrt((s * s << 2 * bits) // square) * (1 if s > 0 else -1)
    low, high = (Fraction(root + d - (r << bits), 1 << bits) / Fraction(2) ** k for d in (-1, 1))
    ulp = Fraction(math.ulp(value))
    return high - low < ulp / 1000 and low - ulp < Fraction(value) < high + ulp


@pytest.mark.parametrize("draw", ["any", "nearly none", "a small dot", "no radius"])
def test_a_difference_from_a_root_is_right_to_a_unit_in_the_last_place(draw: str):
    rng = Random(5)
    for _ in range(300):
        square = rng.randint(1, 2 ** rng.choice((2, 60, 200)))
        r = 0 if draw == "no radius" else rng.randint(0, 2**60)
        s = rng.choice((-1, 1)) * rng.randint(1, 2 ** rng.choice((1, 60, 150)))
        if draw == "nearly none":  # what is left is a small part of both, or none at all
            s = math.isqrt(r * r * square) + rng.randint(0, 1)
        if draw == "a small dot":
            s, square = rng.randint(-3, 3), rng.randint(2**300, 2**400)
        k = rng.randint(-200, 200)
        value = predicates.root_difference(s, r, square, k)
        assert predicates.sign(value) == root_sign(s, r, square), (s, r, square)
        assert value == 0 or well_rounded(value, s, r, square, k), (s, r, square, k)


def test_the_difference_from_a_root_is_zero_at_a_touch():
    for s, r, square in ((0, 0, 5), (15, 3, 25), (5 << 300, 1 << 300, 25)):
        assert repr(predicates.root_difference(s, r, square, 7)) == "0.0"


def test_a_thread_that_flushes_subnormal_numbers_to_zero_gets_a_warning(monkeypatch):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        predicates.warn_if_flushed()
    monkeypatch.setattr(predicates, "MIN_FLOAT", 0.0)  # the value that such a thread computes with
    with pytest.warns(RuntimeWarning, match="rounds numbers below 2.3e-308 to 0"):
        predicates.warn_if_flushed()


@pytest.mark.skipif(
    (sys.platform, platform.machine(), platform.libc_ver()[0]) != ("linux", "x86_64", "glibc"),
    reason="sets the processor's flags as on Linux, x86-64, with its usual C library",
)
def test_a_thread_with_the_flush_to_zero_flag_gets_the_warning():
    """In the C library's x86-64 floating-point environment the control register MXCSR begins at byte 28."""
    libm, flags, flush = ctypes.CDLL("libm.so.6"), ctypes.create_string_buffer(64), 0x8040

    def flushed():
        libm.fegetenv(flags)
        register = int.from_bytes(flags[28:32], "little")
        flags[28:32] = (register | flush).to_bytes(4, "little")
        libm.fesetenv(flags)
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            predicates.warn_if_flushed()
        flags[28:32] = register.to_bytes(4, "little")
        libm.fesetenv(flags)
        predicates.warn_if_flushed()
        return [warning.category for warning in caught]

    with ThreadPoolExecutor(1) as thread:
        assert thread.submit(flushed).result() == [RuntimeWarning]
