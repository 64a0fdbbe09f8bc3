"""Evidence for a verdict that anyone can check with fractions, without trusting the engine."""

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import lru_cache
from math import gcd, isfinite
from typing import Any, NamedTuple, TypeVar

from . import number_format
from .axes import Axis, exact_dots
from .convex_parts import parts
from .geometry import Vec, cyclic_pairs, nearest_fraction
from .number_format import MINUS
from .predicates import MAX_FLOAT, ceil_sqrt, orient, orient_det
from .shapes import Shape

Rational = tuple[Fraction, Fraction]
Number = TypeVar("Number", float, Fraction)


class SeparatingLine(NamedTuple):
    """The line normal . (x, y) = offset in exact fractions; a lies strictly on one side of it and b on the other."""

    a: Shape
    b: Shape
    normal: Rational
    offset: Fraction

    def check(self) -> bool:
        """Return whether the line lies strictly between the shapes, computed exactly."""
        below, above = _side_of_line(self.a, self.normal, self.offset), _side_of_line(self.b, self.normal, self.offset)
        return (below, above) in ((-1, 1), (1, -1))

    @property
    def point(self) -> Vec:
        """Return the line's point nearest to the origin, rounded; coordinates beyond float64 are capped."""
        nx, ny = self.normal
        t = self.offset / (nx * nx + ny * ny)
        limit = Fraction(MAX_FLOAT)
        return Vec(*(float(max(-limit, min(limit, c * t))) for c in (nx, ny)))

    @property
    def equation(self) -> str:
        """Return the line's equation as text: "x = 5 (parallel to y)", "4x - y = 12.5"."""
        nx, ny = self.normal
        if ny == 0 or nx == 0:
            at = number_format.digits_for_shapes(self.a, self.b).number(float(self.offset / (nx or ny)))
            return f"{'y' if nx == 0 else 'x'} = {at} (parallel to {'x' if nx == 0 else 'y'})"
        size = max(abs(nx), abs(ny))
        units = (size, 4 * size) if size > 1000 else (1, size, 4 * size)
        unit = next(unit for unit in units if abs(self.offset) <= unit * 10**308)  # the right side fits into a float
        right = _significant(self.offset / unit)
        return (
            f"{_coefficient_text(nx / unit)}x {MINUS if ny < 0 else '+'} {_coefficient_text(abs(ny / unit))}y = {right}"
        )

    def __str__(self) -> str:
        return number_format.ascii_minus(f"separating line {self.equation}")


def _coefficient_text(factor: Fraction) -> str:
    """Return a coefficient as text to be followed by x or y: nothing for 1, only a minus sign for -1."""
    return "" if factor == 1 else MINUS if factor == -1 else _significant(factor)


def _significant(value: Fraction) -> str:
    """Return a number as text with at least three significant digits."""
    return f"{MINUS if value < 0 else ''}{number_format.USUAL_DIGITS.gap(float(value))}"


class SharedPoint(NamedTuple):
    """A point of both closed shapes (exact fractions)."""

    a: Shape
    b: Shape
    x: Fraction
    y: Fraction

    def check(self) -> bool:
        """Return whether the point lies in both shapes (their borders included), computed exactly."""
        return all(any(_shape_contains(part, (self.x, self.y)) for part in parts(s)) for s in (self.a, self.b))

    @property
    def point(self) -> Vec:
        """Return the point rounded to floats."""
        return Vec(float(self.x), float(self.y))

    def __str__(self) -> str:
        return number_format.ascii_minus(
            f"the point {number_format.digits_for_shapes(self.a, self.b).vector(self.point)} lies in both"
        )


class PartLines(NamedTuple):
    """One separating line for each pair of convex parts: proof that two shapes, one of them concave, are apart."""

    a: Shape
    b: Shape
    lines: tuple[SeparatingLine, ...]

    def check(self) -> bool:
        """Return whether every line separates its two parts and the parts' areas add up to those of the shapes."""
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
    """Return the line perpendicular to a separating axis in the middle of the gap, whose irrational ends are rounded.

    The ends of the gap are lo + r |n| and hi - r |n| with r a circle's radius and n the axis's normal.
    """
    (nx, ny), dots_a, dots_b, _, k = exact_dots(a, b, axis)
    (below, low), (above, high) = sorted([(dots_a, a), (dots_b, b)])  # one shape lies wholly below the other
    lo, hi = max(below), min(above)
    square = nx * nx + ny * ny
    bits = 16
    while True:
        start = lo + _radius_on_axis(low, k, square, bits)
        end = hi - _radius_on_axis(high, k, square, bits)
        if start < end:
            common = gcd(nx, ny)
            offset = (start + end) / 2 / Fraction(2) ** k / common
            return SeparatingLine(a, b, (Fraction(nx // common), Fraction(ny // common)), offset)
        bits *= 2


def _radius_on_axis(shape: Shape, k: int, square: int, bits: int) -> Fraction:
    """Return the radius times the length of an axis's normal, rounded up to a multiple of 2**-bits.

    The result is in units of 2**-k; `square` is |normal|**2.
    """
    own_k, _, r = shape.integers
    return Fraction(ceil_sqrt((r << k - own_k) ** 2 * square << 2 * bits), 1 << bits)


@lru_cache(maxsize=256)
def shared_point(a: Shape, b: Shape) -> SharedPoint:
    """Return a point that two convex shapes share, which touch or overlap.

    Two circles: a point between their centers.  Circle and polygon: the polygon's nearest point to the center.
    Two polygons: see `_shared_point_of_polygons`.
    """
    if a.core_is_point and b.core_is_point:
        ((ax, ay),), ((bx, by),) = _exact_core(a), _exact_core(b)
        # the distance of the centers is at most the sum of the radii
        t = Fraction(a.radius) / (Fraction(a.radius) + Fraction(b.radius))
        point = ax + t * (bx - ax), ay + t * (by - ay)
    elif a.core_is_point or b.core_is_point:
        circle, polygon = (a, b) if a.core_is_point else (b, a)
        point = _nearest_point(_exact_core(polygon), _exact_core(circle)[0])
    else:
        point = _shared_point_of_polygons(a, b)
    return SharedPoint(a, b, *point)


def _shared_point_of_polygons(a: Shape, b: Shape) -> Rational:
    """Return a point that two convex polygons share: the rounded middle of the overlap, else a corner of either.

    Where neither is in both, the middle of the overlap is computed with fractions.
    """
    rounded = _clip(a.core, b.core)
    middle = sum(x / len(rounded) for x, _ in rounded), sum(y / len(rounded) for _, y in rounded)
    for point in (middle, *a.core, *b.core):
        if all(map(isfinite, point)) and all(_ring_contains(shape.core, point, orient) for shape in (a, b)):
            return Fraction(point[0]), Fraction(point[1])
    common = _clip(_exact_core(a), _exact_core(b))
    return sum(x for x, _ in common) / Fraction(len(common)), sum(y for _, y in common) / Fraction(len(common))


def _exact_core(shape: Shape) -> list[Rational]:
    """Return the shape's corners (of a circle, the center) as pairs of fractions."""
    return [(Fraction(x), Fraction(y)) for x, y in shape.core]


def _clip(
    subject: Sequence[tuple[Number, Number]], clip: Sequence[tuple[Number, Number]]
) -> Sequence[tuple[Number, Number]]:
    """Return the intersection of two convex rings as a ring (Sutherland and Hodgman); exact in fractions."""
    for p, q in cyclic_pairs(clip):
        kept: list[tuple[Number, Number]] = []
        for u, v in cyclic_pairs(subject):
            side_u, side_v = orient_det(p, q, u), orient_det(p, q, v)
            if side_u >= 0:
                kept.append(u)
            if side_u * side_v < 0:
                t = side_u / (side_u - side_v)
                kept.append((u[0] + t * (v[0] - u[0]), u[1] + t * (v[1] - u[1])))
        subject = list(dict.fromkeys(kept))
    return subject


def _nearest_point(ring: list[Rational], c: Rational) -> Rational:
    """Return the point of a convex ring that is nearest to c, which is c itself if it is inside."""
    if _ring_contains(ring, c):
        return c
    candidates = []
    for p, q in cyclic_pairs(ring):
        dx, dy = q[0] - p[0], q[1] - p[1]
        t = nearest_fraction(p[0] - c[0], p[1] - c[1], dx, dy)
        candidates.append((p[0] + t * dx, p[1] + t * dy))
    return min(candidates, key=lambda f: (f[0] - c[0]) ** 2 + (f[1] - c[1]) ** 2)


def _ring_contains(ring: Sequence[Any], point: Any, orientation: Callable[[Any, Any, Any], Any] = orient_det) -> bool:
    """Return whether a convex counter-clockwise ring contains a point, its border included.

    `orientation`: a function of three points, positive for a left turn.
    """
    return all(orientation(p, q, point) >= 0 for p, q in cyclic_pairs(ring))


def _shape_contains(shape: Shape, point: Rational) -> bool:
    """Return whether a convex shape contains a point, its border included, computed exactly."""
    if not shape.core_is_point:
        return _ring_contains(_exact_core(shape), point)
    ((x, y),) = _exact_core(shape)
    return (point[0] - x) ** 2 + (point[1] - y) ** 2 <= Fraction(shape.radius) ** 2


def _side_of_line(shape: Shape, normal: Rational, offset: Fraction) -> int:
    """Return -1 or 1 if the whole shape is strictly below or above the line normal . (x, y) = offset, else 0."""
    nx, ny = normal
    dots = [nx * x + ny * y - offset for x, y in _exact_core(shape)]
    nearest = min(dots, key=abs)
    meets = min(dots) < 0 < max(dots) or nearest**2 <= Fraction(shape.radius) ** 2 * (nx * nx + ny * ny)
    return 0 if meets else 1 if nearest > 0 else -1


def _doubled_area(shape: Shape) -> Fraction:
    """Return twice a polygon's area, exactly; 0 for a circle, whose only part is itself."""
    return sum((p[0] * q[1] - p[1] * q[0] for p, q in cyclic_pairs(_exact_core(shape))), Fraction(0))
