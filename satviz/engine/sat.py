"""The one loop: project both shapes on each chosen axis and measure the gap between their ranges."""

import sys
from collections.abc import Iterable, Iterator
from typing import NamedTuple

from .axes import Axis, Source, exact_dots, needed
from .geometry import Interval, Vec
from .predicates import root_difference
from .shapes import Shape, checked

# Landing places carry under 13 roundings of the reach each, a gap under 27.  Asked is far
# more, so that a float gap has not only the right sign but five right digits.
CLOSE_GAP_FACTOR = 2.0**-30
SAFE_RANGE = 1e-100, 1e100
LARGEST = sys.float_info.max
new = tuple.__new__  # what a NamedTuple's own constructor ends in; the loop's records are half its cost


class Projection(NamedTuple):
    """What dropped on an axis and where it landed.

    `points`: a polygon's corners, or a circle's two extremes C - r n and C + r n;
    `landings`: their signed coordinates along the axis, in scene units.
    """

    points: tuple[Vec, ...]
    landings: tuple[float, ...]

    @property
    def interval(self) -> Interval:
        """From the least landing to the most."""
        return Interval(min(self.landings), max(self.landings))


class AxisTest(NamedTuple):
    """One axis tested: both projections and the signed gap between their ranges.

    `gap` is in scene units: positive apart, 0 touching, negative by how deep the
    ranges overlap; its sign is exact even where the rounded intervals are too coarse
    to show it.
    """

    axis: Axis
    a: Projection
    b: Projection
    gap: float

    @property
    def source(self) -> Source:
        """Where its axis comes from."""
        return self.axis.source

    @property
    def separates(self) -> bool:
        """Is this a separating axis?  Ranges that touch do not separate."""
        return self.gap > 0


def project(shape: Shape, axis: Axis) -> Projection:
    """Drop a shape on an axis in float64; a landing is (x*nx + y*ny) / length.

    Dividing last keeps ties: with whole coordinates both ends of an edge land on
    one spot of its own normal.
    """
    (nx, ny), length, _ = axis
    if r := shape.radius:
        ((x, y),) = shape.core
        at = (x * nx + y * ny) / length
        rx, ry = r * nx / length, r * ny / length
        return Projection((Vec(x - rx, y - ry), Vec(x + rx, y + ry)), (at - r, at + r))
    return new(Projection, (shape.core, tuple([(x * nx + y * ny) / length for x, y in shape.core])))


def axis_tests(a: Shape, b: Shape, axes: Iterable[Axis] | None = None) -> Iterator[AxisTest]:
    """Test the axes one by one (by default `needed`); stop asking for more and it stops computing.

    That is the early exit: next((t for t in axis_tests(a, b) if t.separates), None).
    TypeError for anything but Polygon and Circle.
    """
    checked(a, "a"), checked(b, "b")
    if axes is None:
        axes = needed(a, b).axes
    reach = max(a.max_coordinate, b.max_coordinate)
    close = reach * CLOSE_GAP_FACTOR if SAFE_RANGE[0] < reach < SAFE_RANGE[1] else float("inf")
    for axis in axes:
        p, q = project(a, axis), project(b, axis)
        on_a, on_b = p[1], q[1]
        gap = max(min(on_a) - max(on_b), min(on_b) - max(on_a))
        if (gap > close or -gap > close) and SAFE_RANGE[0] < axis.length < SAFE_RANGE[1]:
            yield new(AxisTest, (axis, p, q, gap))
        else:
            yield _exact_test(a, b, axis)


def _exact_test(a: Shape, b: Shape, axis: Axis) -> AxisTest:
    """The integer twin: the same facts, each rounded once, the gap with its exact sign."""
    (nx, ny), dots_a, dots_b, radii, k = exact_dots(a, b, axis)
    square = nx * nx + ny * ny
    apart = max(min(dots_a) - max(dots_b), min(dots_b) - max(dots_a))
    gap = root_difference(apart, radii, square, k)
    return AxisTest(
        axis, _exact_projection(a, axis, dots_a, square, k), _exact_projection(b, axis, dots_b, square, k), gap
    )


def _exact_projection(shape: Shape, axis: Axis, dots: list[int], square: int, k: int) -> Projection:
    own_k, _, radius = shape.integers
    if not radius:
        return Projection(shape.core, tuple(root_difference(dot, 0, square, k) for dot in dots))
    radius <<= k - own_k
    ((x, y),), r, (nx, ny) = shape.core, shape.radius, axis.direction
    lo = root_difference(dots[0], radius, square, k)
    hi = -root_difference(-dots[0], radius, square, k) + 0.0
    ends = (Vec(_cap_to_float64(x + s * r * nx), _cap_to_float64(y + s * r * ny)) for s in (-1, 1))
    return Projection(tuple(ends), (lo, hi))


def _cap_to_float64(value: float) -> float:
    """An extreme beyond float64 is shown at its rim."""
    return max(-LARGEST, min(LARGEST, value))
