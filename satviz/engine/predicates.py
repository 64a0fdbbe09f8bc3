"""Signs that are never wrong: a float filter first, integers when it cannot tell.

Every finite float64 is an integer times a power of two, so after one shift any
sum of products of coordinates is an integer and its sign is exact.  The filters
ask for more room than their worst case needs (twice the bound derived beside
each), so they hold for any order of operations and with fused multiply-add, and
they step aside where products could overflow or lose bits to underflow.
"""

import sys
import warnings
from collections.abc import Iterable, Sequence
from math import isqrt
from typing import Any

UNIT = 2.0**-53  # unit roundoff of float64
TINY, HUGE = 1e-280, 1e290  # products inside this range neither lose bits nor overflow
SMALLEST = 5e-324  # where numbers keep their size until the last bit is gone
SCALE = 2.0**72  # makes integers of ordinary coordinates: 0, and from 2**-20 up to 2**951

Point = tuple[float, float]
IntPoint = tuple[int, int]


def sign(value: int) -> int:
    """-1, 0 or 1."""
    return (value > 0) - (value < 0)


def warn_if_flushed() -> None:
    """RuntimeWarning in a thread that takes numbers below 2.3e-308 for 0: none below 1e-290 would be exact there."""
    if SMALLEST + SMALLEST == 0:
        warnings.warn(
            "this thread takes numbers below 2.3e-308 for 0 (flush-to-zero, which code compiled with -ffast-math "
            "sets): answers are exact only where every number given is 0 or beyond 1e-290",
            RuntimeWarning,
            stacklevel=2,
        )


def to_integers(values: Iterable[float]) -> tuple[int, list[int]]:
    """Integers n and one exponent k with value = n / 2**k, exactly and in order."""
    ratios = [value.as_integer_ratio() for value in values]
    k = max(den.bit_length() for _, den in ratios) - 1
    return k, [num << (k + 1 - den.bit_length()) for num, den in ratios]


def to_int_points(points: Sequence[Point]) -> tuple[int, list[IntPoint]]:
    """The points as integer pairs over one power of two: (k, pairs)."""
    k, flat = to_integers(c for p in points for c in p)
    return k, list(zip(flat[::2], flat[1::2], strict=True))


def shifted(points: Sequence[IntPoint], by: int) -> Sequence[IntPoint]:
    """Integer points in units finer by 2**by."""
    return [(x << by, y << by) for x, y in points] if by else points


def aligned(a: Any, b: Any) -> tuple[Sequence[IntPoint], Sequence[IntPoint], int, int]:
    """Both shapes in one integer unit: (a's points, b's points, sum of radii, k), the unit being 2**-k."""
    ka, pa, ra = a.integers
    kb, pb, rb = b.integers
    k = max(ka, kb)
    return shifted(pa, k - ka), shifted(pb, k - kb), (ra << k - ka) + (rb << k - kb), k


def orient(p: Point, q: Point, r: Point) -> int:
    """The exact turn at q on the way from p over q to r: 1 left, -1 right, 0 straight.

    Source: the determinant of Shewchuk (1997); its static bound is 3.33e-16 of
    the sum of the two products, asked here with room to spare.
    """
    left = (q[0] - p[0]) * (r[1] - p[1])
    right = (q[1] - p[1]) * (r[0] - p[0])
    room = abs(left) + abs(right)
    if TINY < room < HUGE:
        det = left - right
        if abs(det) > 8 * UNIT * room:
            return 1 if det > 0 else -1
    scaled = [c * SCALE for c in (*p, *q, *r)]
    whole = map(int, scaled) if all(map(float.is_integer, scaled)) else to_integers((*p, *q, *r))[1]
    px, py, qx, qy, rx, ry = whole
    return sign((qx - px) * (ry - py) - (qy - py) * (rx - px))


def to_float(num: int, k: int) -> float:
    """num / 2**k rounded once; a value too small for float64 keeps its sign, one too large is capped.

    Numbers leave the integers only here, so a printed sign is always the exact one.
    """
    try:
        value = (num << max(-k, 0)) / (1 << max(k, 0))
    except OverflowError:
        value = sign(num) * sys.float_info.max
    return value or sign(num) * 5e-324


def root_difference(s: int, r: int, square: int, k: int) -> float:
    """(s / sqrt(square) - r) / 2**k, r >= 0, as a float that has the exact sign, good to one unit in the last place."""
    if s >= 0 and s * s == r * r * square:
        return 0.0
    bits = 80
    while True:
        value = sign(s) * isqrt((s * s << 2 * bits) // square) - (r << bits)
        # 70 leading bits leave the one lost by isqrt far below the float's last place
        if value.bit_length() > 70:
            return to_float(value, k + bits)
        bits *= 2
