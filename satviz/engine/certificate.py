"""Evidence for a verdict that anyone can check with fractions, without trusting the engine."""

from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import lru_cache
from math import gcd, isfinite, isqrt
from typing import NamedTuple, TypeVar

from . import number_format
from .axes import Axis, exact_dots
from .convex_parts import parts
from .geometry import Vec
from .number_format import MINUS
from .predicates import orient
from .sat import LARGEST
from .shapes import Shape

Rational = tuple[Fraction, Fraction]
T = TypeVar("T")
Number = TypeVar("Number", float, Fraction)
RIM = Fraction(LARGEST)


class SeparatingLine(NamedTuple):
    """The line normal . (x, y) = offset, with all of one shape strictly on either side (exact fractions)."""

    a: Shape
    b: Shape
    normal: Rational
    offset: Fraction

    def check(self) -> bool:
        """Exactly: does the line lie strictly between the shapes?"""
        below, above = _side_of_line(self.a, self.normal, self.offset), _side_of_line(self.b, self.normal, self.offset)
        return (below, above) in ((-1, 1), (1, -1))

    @property
    def point(self) -> Vec:
        """A point on the line, the nearest to the origin, rounded; beyond float64 at its rim."""
        nx, ny = self.normal
        t = self.offset / (nx * nx + ny * ny)
        return Vec(*(float(max(-RIM, min(RIM, c * t))) for c in (nx, ny)))

    @property
    def equation(self) -> str:
        """The line's equation in words: "x = 5 (parallel to y)", "4x - y = 12.5"."""
        nx, ny = self.normal
        if ny == 0 or nx == 0:
            at = number_format.of_shapes(self.a, self.b).number(float(self.offset / (nx or ny)))
            return f"{'y' if nx == 0 else 'x'} = {at} (parallel to {'x' if nx == 0 else 'y'})"
        size = max(abs(nx), abs(ny))
        unit = size if size > 1000 else 1
        if abs(self.offset) > unit * 10**308:  # as the sum of two coordinates, which no float can hold
            unit *= 4
        right = number_format.number(float(self.offset / unit))
        return (
            f"{_coefficient_text(nx / unit)}x {MINUS if ny < 0 else '+'} {_coefficient_text(abs(ny / unit))}y = {right}"
        )

    def __str__(self) -> str:
        return number_format.plain(f"separating line {self.equation}")


def _coefficient_text(factor: Fraction) -> str:
    return "" if factor == 1 else MINUS if factor == -1 else number_format.number(float(factor))


class SharedPoint(NamedTuple):
    """A point of both closed shapes (exact fractions)."""

    a: Shape
    b: Shape
    x: Fraction
    y: Fraction

    def check(self) -> bool:
        """Exactly: does the point lie in both shapes (their borders included)?"""
        return all(any(_contains(part, (self.x, self.y)) for part in parts(s)) for s in (self.a, self.b))

    @property
    def point(self) -> Vec:
        """The nearest floats to it."""
        return Vec(float(self.x), float(self.y))

    def __str__(self) -> str:
        return number_format.plain(
            f"the point {number_format.of_shapes(self.a, self.b).vector(self.point)} lies in both"
        )


class PartLines(NamedTuple):
    """For concave outlines: one separating line for each pair of convex parts, which make up the whole."""

    a: Shape
    b: Shape
    lines: tuple[SeparatingLine, ...]

    def check(self) -> bool:
        """Exactly: does every line separate its pair, and do the parts' areas add up to the shapes'?"""
        pairs = [(p, q) for p in parts(self.a) for q in parts(self.b)]
        return (
            [(line.a, line.b) for line in self.lines] == pairs
            and all(line.check() for line in self.lines)
            and all(_doubled_area(s) == sum(map(_doubled_area, parts(s))) for s in (self.a, self.b))
        )

    def __str__(self) -> str:
        return f"{len(self.lines)} separating lines, one a pair of parts"


Certificate = SeparatingLine | SharedPoint | PartLines


def separating_line(a: Shape, b: Shape, axis: Axis) -> SeparatingLine:
    """The line across a separating axis, in the middle of the gap (as near as fractions name it)."""
    (nx, ny), dots_a, dots_b, _, k = exact_dots(a, b, axis)
    if min(dots_a) > max(dots_b):
        (lo, low), (hi, high) = (max(dots_b), b), (min(dots_a), a)
    else:
        (lo, low), (hi, high) = (max(dots_a), a), (min(dots_b), b)
    square = nx * nx + ny * ny
    # the edges of the gap are lo + r|n| and hi - r|n|; r|n| is irrational in general, so bracket it
    bits = 16
    while True:
        start = Fraction(lo) + _root(low, k, square, bits)
        end = Fraction(hi) - _root(high, k, square, bits)
        if start < end:
            common = gcd(nx, ny)
            offset = (start + end) / 2 / Fraction(2) ** k / common
            return SeparatingLine(a, b, (Fraction(nx // common), Fraction(ny // common)), offset)
        bits *= 2


def _root(shape: Shape, k: int, square: int, bits: int) -> Fraction:
    """radius * sqrt(square) in units of 2**-k, rounded to 2**-bits of a unit upwards; 0 for a polygon."""
    own_k, _, r = shape.integers
    if not r:
        return Fraction(0)
    scaled = (r << k - own_k) ** 2 * square << 2 * bits
    return Fraction(isqrt(scaled - 1) + 1, 1 << bits)


@lru_cache(maxsize=256)
def shared_point(a: Shape, b: Shape) -> SharedPoint:
    """A point of both of two convex shapes that touch or overlap.

    Of two polygons about the middle of what they share where floats can say it, of a circle and a polygon the
    polygon's nearest point to the center, of two circles one between their centers.
    """
    if a.core_is_point and b.core_is_point:
        ((ax, ay),), ((bx, by),) = _exact_core(a), _exact_core(b)
        t = Fraction(a.radius) / (Fraction(a.radius) + Fraction(b.radius))  # the distance is at most their sum
        point = ax + t * (bx - ax), ay + t * (by - ay)
    elif a.core_is_point or b.core_is_point:
        circle, polygon = (a, b) if a.core_is_point else (b, a)
        point = _nearest_point(_exact_core(polygon), _exact_core(circle)[0])
    else:
        point = _shared_point_of_polygons(a, b)
    return SharedPoint(a, b, *point)


def _shared_point_of_polygons(a: Shape, b: Shape) -> Rational:
    """A point of two convex polygons: the rounded middle of the overlap, or a corner, or worked out in fractions."""
    roughly = _clip(a.core, b.core)
    middle = sum(x / len(roughly) for x, _ in roughly), sum(y / len(roughly) for _, y in roughly)
    for spot in (middle, *a.core, *b.core):
        if all(isfinite(c) for c in spot) and all(orient(p, q, spot) >= 0 for s in (a, b) for p, q in _edges(s.core)):
            return Fraction(spot[0]), Fraction(spot[1])
    common = _clip(_exact_core(a), _exact_core(b))
    return sum(x for x, _ in common) / Fraction(len(common)), sum(y for _, y in common) / Fraction(len(common))


def _exact_core(shape: Shape) -> list[Rational]:
    return [(Fraction(x), Fraction(y)) for x, y in shape.core]


def _cross(p: tuple[Number, Number], q: tuple[Number, Number], r: tuple[Number, Number]) -> Number:
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def _edges(ring: Sequence[T]) -> Iterator[tuple[T, T]]:
    return zip(ring, [*ring[1:], ring[0]], strict=True)


def _clip(
    subject: Sequence[tuple[Number, Number]], clip: Sequence[tuple[Number, Number]]
) -> Sequence[tuple[Number, Number]]:
    """Sutherland and Hodgman's clipping of one convex ring by another: exact in fractions, roughly in floats."""
    for p, q in _edges(clip):
        if not subject:
            break
        kept: list[tuple[Number, Number]] = []
        for u, v in _edges(subject):
            side_u, side_v = _cross(p, q, u), _cross(p, q, v)
            if side_u >= 0:
                kept.append(u)
            if side_u * side_v < 0:
                t = side_u / (side_u - side_v)
                kept.append((u[0] + t * (v[0] - u[0]), u[1] + t * (v[1] - u[1])))
        subject = list(dict.fromkeys(kept))
    return subject


def _nearest_point(ring: list[Rational], c: Rational) -> Rational:
    """The ring's point nearest to c, or c itself inside."""
    if all(_cross(p, q, c) >= 0 for p, q in _edges(ring)):
        return c
    feet = []
    for p, q in _edges(ring):
        dx, dy = q[0] - p[0], q[1] - p[1]
        t = min(Fraction(1), max(Fraction(0), ((c[0] - p[0]) * dx + (c[1] - p[1]) * dy) / (dx * dx + dy * dy)))
        feet.append((p[0] + t * dx, p[1] + t * dy))
    return min(feet, key=lambda f: (f[0] - c[0]) ** 2 + (f[1] - c[1]) ** 2)


def _contains(shape: Shape, point: Rational) -> bool:
    if not shape.core_is_point:
        return all(_cross(p, q, point) >= 0 for p, q in _edges(_exact_core(shape)))
    ((x, y),) = _exact_core(shape)
    return (point[0] - x) ** 2 + (point[1] - y) ** 2 <= Fraction(shape.radius) ** 2


def _side_of_line(shape: Shape, normal: Rational, offset: Fraction) -> int:
    """-1 or 1 if the whole shape is strictly below or above the line, else 0."""
    nx, ny = normal
    dots = [nx * x + ny * y - offset for x, y in _exact_core(shape)]
    nearest = min(dots, key=abs)
    meets = min(dots) < 0 < max(dots) or nearest**2 <= Fraction(shape.radius) ** 2 * (nx * nx + ny * ny)
    return 0 if meets else 1 if nearest > 0 else -1


def _doubled_area(shape: Shape) -> Fraction:
    """Twice the core's area; a circle is its own only part, so any number serves."""
    ring = _exact_core(shape)
    return sum((p[0] * q[1] - p[1] * q[0] for p, q in _edges(ring)), Fraction(0))
