"""Check whether a model rounds anything at all on a pair; if not, its plain floats also find touching pairs exactly.

Each formula below computes every number that a model can compute on the way: every partial sum, in every order of the
terms, with differences of coordinates taken first or last, and every product.  It runs on one of two kinds of
arithmetic: `ExactArithmetic` below has exact values as fractions, for one pair; `rounding_numpy.Errors` has arrays of
floats and the error of each operation, for many pairs.  Both record in `exact` whether the format *holds* (can
represent) every number computed.

The last sum before a sign is taken need not be held: rounding keeps the sign of a sum.
"""

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import combinations, pairwise
from math import isqrt
from typing import Any, NamedTuple, Protocol, TypeVar

N = TypeVar("N")
Point = tuple[N, N]


class FloatFormat(NamedTuple):
    """Describe a binary float format of `bits` significant bits.

    It holds n * 2**e for |n| < 2**bits from the lowest bit 2**lowest up to below 2**highest.  `least` and `most` bound
    the coordinates and spans for which bounds on rounding errors are trusted: between them no product of up to four
    differences underflows or overflows in any order (the squared orientation over a squared length is one).
    """

    name: str
    bits: int
    lowest: int
    highest: int
    least: float
    most: float


FLOAT32 = FloatFormat("float32", 24, -149, 128, 2.0**-30, 2.0**30)
FLOAT64 = FloatFormat("float64", 53, -1074, 1024, 2.0**-250, 2.0**250)
FORMATS = {f.name: f for f in (FLOAT32, FLOAT64)}


class Arithmetic(Protocol[N]):
    """Compute exactly, and record in `exact` whether the format holds every result."""

    def product(self, a: N, b: N) -> N:
        """Return a * b; `exact` becomes False if the format cannot hold it."""

    def root(self, a: N) -> N:
        """Return the square root of a; `exact` becomes False if the format cannot hold it."""

    def total(self, *terms: N) -> N:
        """Return the sum of the terms; `exact` becomes False if the format cannot hold it or a partial sum."""

    def compared(self, *terms: N) -> None:
        """Record whether the format holds the partial sums of the terms; only the sign of their total is used."""

    def operands(self, ring: Sequence[Point[N]]) -> Sequence[Point[N]]:
        """Return the corners as operands of these methods: one by one, or as arrays that hold all corners at once."""


class ExactArithmetic:
    """Compute with fractions, for one pair; `exact` turns False once the format does not hold a number."""

    def __init__(self, form: FloatFormat) -> None:
        self.form = form
        self.exact = True

    def held(self, value: Fraction) -> Fraction:
        """Return the value unchanged; set `exact` to False if the format does not hold it."""
        self.exact = self.exact and is_representable(value, self.form)
        return value

    def product(self, a: Fraction, b: Fraction) -> Fraction:
        """Return a * b."""
        return self.held(a * b)

    def root(self, a: Fraction) -> Fraction:
        """Return the square root of a, rounded down where it is irrational."""
        found = Fraction(isqrt(a.numerator), isqrt(a.denominator))
        self.exact = self.exact and found * found == a
        return self.held(found)

    def total(self, *terms: Fraction) -> Fraction:
        """Return the sum of the terms."""
        self.compared(*terms)
        return self.held(sum(terms, Fraction(0)))

    def compared(self, *terms: Fraction) -> None:
        """Record whether the format holds every partial sum of the terms (not the sum itself)."""
        terms = tuple(filter(None, terms))
        for many in range(2, len(terms)):
            for some in combinations(terms, many):
                self.held(sum(some, Fraction(0)))

    def operands(self, ring: Sequence[Point[Fraction]]) -> Sequence[Point[Fraction]]:
        """Return the corners unchanged: one operand each."""
        return ring


def is_representable(value: Fraction, form: FloatFormat) -> bool:
    """Return whether the float format can represent the value exactly."""
    n, d = value.as_integer_ratio()
    if not n:
        return True
    low = (n & -n).bit_length() - 1
    lowest, highest = low - d.bit_length() + 1, abs(n).bit_length() - d.bit_length() + 1
    return not d & (d - 1) and highest - lowest <= form.bits and lowest >= form.lowest and highest <= form.highest


def polygons(arithmetic: Arithmetic[N], p: Sequence[Point[N]], q: Sequence[Point[N]]) -> Iterator[None]:
    """Do every operation of SAT on two convex polygons, so that `arithmetic` records their roundings.

    It goes edge by edge and yields after each, so that the caller may stop.

    Each corner of the other shape is compared with the edge, and each corner is projected on its normal.
    """
    for own, other in (p, q), (q, p):
        all_own, all_other = arithmetic.operands(own), arithmetic.operands(other)
        for start, end in pairwise([own[-1], *own]):
            normal = arithmetic.total(end[1], _minus(start[1])), arithmetic.total(start[0], _minus(end[0]))
            edge = tuple(_minus(arithmetic.product(n, c)) for n, c in zip(normal, start, strict=True))
            for corner in all_other:
                terms = (arithmetic.product(n, c) for n, c in zip(normal, corner, strict=True))
                arithmetic.compared(*terms, *edge)
            for corner in all_own:
                landing(arithmetic, normal, corner)
            yield


def landing(arithmetic: Arithmetic[N], normal: Point[N], corner: Point[N]) -> N:
    """Return the landing of a corner on an axis: nx*x + ny*y."""
    return arithmetic.total(*(arithmetic.product(n, c) for n, c in zip(normal, corner, strict=True)))


def circles(arithmetic: Arithmetic[N], a: Sequence[N], b: Sequence[N]) -> None:
    """Do every operation that compares two circles (x, y, radius) by squares; `arithmetic` records the roundings."""
    dx, dy = (arithmetic.total(c, _minus(d)) for c, d in zip(a[:2], b[:2], strict=True))
    radii = arithmetic.total(a[2], b[2])
    square = arithmetic.product(radii, radii)
    arithmetic.compared(arithmetic.product(dx, dx), arithmetic.product(dy, dy), _minus(square))
    arithmetic.total(arithmetic.product(dx, dx), arithmetic.product(dy, dy))


def circle_ranges(arithmetic: Arithmetic[N], a: Sequence[N], b: Sequence[N]) -> None:
    """Do every operation that compares two circles by ranges on the line of centers; `arithmetic` records roundings."""
    nx, ny = (arithmetic.total(c, _minus(d)) for c, d in zip(a[:2], b[:2], strict=True))
    length = arithmetic.root(arithmetic.total(arithmetic.product(nx, nx), arithmetic.product(ny, ny)))
    for x, y, radius in (a, b):
        center, half = landing(arithmetic, (nx, ny), (x, y)), arithmetic.product(radius, length)
        arithmetic.total(center, half), arithmetic.total(center, _minus(half))


def _minus(value: Any) -> Any:
    """Return -value, for fractions and arrays."""
    return -value
