"""The one loop: project both shapes on each chosen axis and measure the gap between their ranges."""

from collections.abc import Iterable, Iterator
from math import inf
from typing import NamedTuple

from .axes import Axis, Source, exact_dots, needed
from .geometry import Interval, Vec
from .predicates import MAX_FLOAT, root_difference
from .shapes import Shape, require_shape

# With M the larger max_coordinate and u = 2**-53, a landing carries under 13 u M, a gap under 27 u M.  Gaps below
# 2**-30 M = 2**23 u M are computed with integers, so a float gap has not only the right sign but five right digits.
CLOSE_GAP_FACTOR = 2.0**-30
SAFE_RANGE = 1e-100, 1e100  # coordinates and lengths in this range: no product overflows or vanishes
new = tuple.__new__  # a NamedTuple's own constructor calls this; making the records is half of the loop's cost


class Projection(NamedTuple):
    """The points of a shape that were projected on an axis, and the coordinate of each along the axis (its landing).

    `points`: a polygon's corners, or a circle's two extremes C - r n and C + r n;
    `landings`: their signed coordinates along the axis, in scene units.
    """

    points: tuple[Vec, ...]
    landings: tuple[float, ...]

    @property
    def interval(self) -> Interval:
        """Return the range from the smallest landing to the largest."""
        return Interval(min(self.landings), max(self.landings))


class AxisTest(NamedTuple):
    """One axis tested: both projections and the signed gap between their ranges.

    `gap` is in scene units: positive apart, 0 touching, minus the depth where the
    ranges overlap; its sign is exact even where the rounded intervals are too coarse
    to show it.
    """

    axis: Axis
    a: Projection
    b: Projection
    gap: float

    @property
    def source(self) -> Source:
        """Return the source of the axis."""
        return self.axis.source

    @property
    def separates(self) -> bool:
        """Return whether this is a separating axis; ranges that touch do not separate."""
        return self.gap > 0


def project(shape: Shape, axis: Axis) -> Projection:
    """Project a shape on an axis in float64; a corner lands at (x*nx + y*ny) / length.

    Dividing last keeps ties: with whole coordinates both ends of an edge have the
    same landing on the edge's own normal.
    """
    (nx, ny), length, _ = axis
    core, r = shape.core, shape.radius
    if not r:
        return new(Projection, (core, tuple([(x * nx + y * ny) / length for x, y in core])))
    rx, ry = r * nx / length, r * ny / length
    points: list[Vec] = []
    landings: list[float] = []
    for x, y in core:
        at = (x * nx + y * ny) / length
        points += new(Vec, (x - rx, y - ry)), new(Vec, (x + rx, y + ry))
        landings += at - r, at + r
    return new(Projection, (tuple(points), tuple(landings)))


def axis_tests(a: Shape, b: Shape, axes: Iterable[Axis] | None = None) -> Iterator[AxisTest]:
    """Yield the test of each axis, by default those of `needed`; each is computed only when it is requested.

    So the early exit is next((t for t in axis_tests(a, b) if t.separates), None).
    TypeError for anything but Polygon and Circle.
    """
    require_shape(a, "a"), require_shape(b, "b")
    if axes is None:
        axes = needed(a, b).axes
    max_coordinate = max(a.max_coordinate, b.max_coordinate)
    close = max_coordinate * CLOSE_GAP_FACTOR if SAFE_RANGE[0] < max_coordinate < SAFE_RANGE[1] else inf
    for axis in axes:
        p, q = project(a, axis), project(b, axis)
        on_a, on_b = p[1], q[1]
        gap = max(min(on_a) - max(on_b), min(on_b) - max(on_a))  # Interval.gap, without making intervals
        if (gap > close or -gap > close) and SAFE_RANGE[0] < axis.length < SAFE_RANGE[1]:
            yield new(AxisTest, (axis, p, q, gap))
        else:
            yield _exact_test(a, b, axis)


def _exact_test(a: Shape, b: Shape, axis: Axis) -> AxisTest:
    """Return the test of an axis computed with integers: each number rounded once, the gap with its exact sign."""
    (nx, ny), dots_a, dots_b, radii, k = exact_dots(a, b, axis)
    square = nx * nx + ny * ny
    core_gap = max(min(dots_a) - max(dots_b), min(dots_b) - max(dots_a))
    gap = root_difference(core_gap, radii, square, k)
    return AxisTest(
        axis, _exact_projection(a, axis, dots_a, square, k), _exact_projection(b, axis, dots_b, square, k), gap
    )


def _exact_projection(shape: Shape, axis: Axis, dots: list[int], square: int, k: int) -> Projection:
    """Return a shape's projection from the `exact_dots` of its core, whose unit is 2**-k; `square`: |normal|**2."""
    own_k, _, radius = shape.integers
    if not radius:
        return Projection(shape.core, tuple(root_difference(dot, 0, square, k) for dot in dots))
    radius <<= k - own_k
    r, (nx, ny) = shape.radius, axis.direction
    points = (Vec(_cap(x + s * r * nx), _cap(y + s * r * ny)) for x, y in shape.core for s in (-1, 1))
    landings = (-s * root_difference(-s * dot, radius, square, k) + 0.0 for dot in dots for s in (-1, 1))
    return Projection(tuple(points), tuple(landings))


def _cap(value: float) -> float:
    """Return the value; MAX_FLOAT with its sign if it is infinite."""
    return max(-MAX_FLOAT, min(MAX_FLOAT, value))
