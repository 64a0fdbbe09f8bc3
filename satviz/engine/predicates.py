"""Exact signs: a float filter answers first, integers where its error bound is too coarse.

Every finite float64 is an integer times a power of two.  After one shift, any sum of
products of coordinates is an integer, so its sign is exact.  Each filter asks for twice
the error bound derived beside it, so it holds for any order of operations and with fused
multiply-add.  A filter leaves the answer to integers where products could overflow or
lose bits to underflow.
"""

import sys
import warnings
from collections.abc import Iterable, Sequence
from fractions import Fraction
from math import isqrt
from typing import Any, TypeVar

UNIT_ROUNDOFF = 2.0**-53  # unit roundoff of float64
MIN_SAFE_PRODUCT, MAX_SAFE_PRODUCT = 1e-280, 1e290  # products inside this range neither lose bits nor overflow
MIN_FLOAT = 5e-324  # the smallest positive float64, 2**-1074
MAX_FLOAT = sys.float_info.max
SCALE = 2.0**72  # c * SCALE is a whole number for c = 0 and for every float64 c with 2**-20 <= |c| < 2**951

Point = tuple[float, float]
IntPoint = tuple[int, int]
Number = TypeVar("Number", int, float, Fraction)


def sign(value: int) -> int:
    """Return the sign of a value: -1, 0 or 1."""
    return (value > 0) - (value < 0)


def warn_if_flushed() -> None:
    """Warn if this thread rounds numbers below 2.3e-308 to 0, so that small numbers are not exact."""
    if MIN_FLOAT + MIN_FLOAT == 0:
        warnings.warn(
            "this thread rounds numbers below 2.3e-308 to 0 (flush-to-zero, set by code compiled with -ffast-math): "
            "answers are exact only if every number is 0 or at least 1e-290 in size; scale smaller shapes up",
            RuntimeWarning,
            stacklevel=2,
        )


def to_integers(values: Iterable[float]) -> tuple[int, list[int]]:
    """Return (k, integers) with value = integer / 2**k exactly, in the order of the values."""
    ratios = [value.as_integer_ratio() for value in values]
    k = max(den.bit_length() for _, den in ratios) - 1
    return k, [num << (k + 1 - den.bit_length()) for num, den in ratios]


def to_int_points(points: Sequence[Point]) -> tuple[int, list[IntPoint]]:
    """Return (k, points) with each coordinate as an integer in units of 2**-k."""
    k, flat = to_integers(c for p in points for c in p)
    return k, list(zip(flat[::2], flat[1::2], strict=True))


def to_finer_units(points: Sequence[IntPoint], bits: int) -> Sequence[IntPoint]:
    """Return integer points in a unit that is 2**bits times smaller."""
    return [(x << bits, y << bits) for x, y in points] if bits else points


def to_common_unit(a: Any, b: Any) -> tuple[Sequence[IntPoint], Sequence[IntPoint], int, int]:
    """Return both shapes in one integer unit, 2**-k: (a's core, b's core, sum of radii, k).

    A core is a polygon's corners or a circle's center.
    """
    ka, pa, ra = a.integers
    kb, pb, rb = b.integers
    k = max(ka, kb)
    return to_finer_units(pa, k - ka), to_finer_units(pb, k - kb), (ra << k - ka) + (rb << k - kb), k


def orient_det(p: tuple[Number, Number], q: tuple[Number, Number], r: tuple[Number, Number]) -> Number:
    """Return the orientation determinant: positive when the way from p over q to r turns left, 0 when it is straight.

    It is exact for integers and fractions.  For floats it is rounded; `orient` gives its exact sign.
    """
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def orient(p: Point, q: Point, r: Point) -> int:
    """Return the exact sign of the orientation determinant: 1 for a left turn at q, -1 right, 0 straight.

    Source: Shewchuk (1997), whose static bound is 3.33e-16 of the sum of the two
    products; the filter here asks for 8 * 2**-53 = 8.9e-16 of it.
    """
    left = (q[0] - p[0]) * (r[1] - p[1])
    right = (q[1] - p[1]) * (r[0] - p[0])
    size = abs(left) + abs(right)
    if MIN_SAFE_PRODUCT < size < MAX_SAFE_PRODUCT:
        det = left - right
        if abs(det) > 8 * UNIT_ROUNDOFF * size:
            return 1 if det > 0 else -1
    scaled = [c * SCALE for c in (*p, *q, *r)]
    whole = map(int, scaled) if all(map(float.is_integer, scaled)) else to_integers((*p, *q, *r))[1]
    px, py, qx, qy, rx, ry = whole
    return sign(orient_det((px, py), (qx, qy), (rx, ry)))


def to_float(num: int, k: int) -> float:
    """Return num / 2**k rounded once; a value too small for float64 keeps its sign, one too large is capped.

    Numbers leave the integers only here, so a printed sign is always the exact one.
    """
    try:
        value = (num << max(-k, 0)) / (1 << max(k, 0))
    except OverflowError:
        value = sign(num) * MAX_FLOAT
    return value or sign(num) * MIN_FLOAT


def ceil_sqrt(n: int) -> int:
    """Return the square root of n >= 0, rounded up."""
    return isqrt(n - 1) + 1 if n else 0


def root_difference(s: int, r: int, square: int, k: int) -> float:
    """Return (s / sqrt(square) - r) / 2**k for r >= 0: with the exact sign, good to one unit in the last place."""
    if s >= 0 and s * s == r * r * square:
        return 0.0
    bits = 80
    while True:
        value = sign(s) * isqrt((s * s << 2 * bits) // square) - (r << bits)
        # 70 leading bits leave the one lost by isqrt far below the float's last place
        if value.bit_length() > 70:
            return to_float(value, k + bits)
        bits *= 2
