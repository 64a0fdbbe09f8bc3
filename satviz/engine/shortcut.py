"""A shortcut: the loop over other axes, or with one step done differently, as common mistakes do it."""

from collections.abc import Callable, Iterator, Sequence
from math import isfinite
from typing import NamedTuple

from .axes import Axis, Chooser, needed
from .geometry import InvalidScene, InvalidShape, Vec
from .polygon_validation import short_repr
from .sat import AxisTest, axis_tests
from .shapes import Shape

Measure = Callable[[Shape, Shape, Axis], AxisTest]
Push = Callable[[Shape, Shape, Sequence[AxisTest]], Vec]


class Shortcut(NamedTuple):
    """A mistaken or cheaper method, described by what it does differently from the loop.

    `claim`: the mistake as people say it; `choose`: the axes.  At most one step differs from the loop:
    `measure` projects and measures an axis (None: correctly); `touching_separates` counts a gap of 0 as
    separating; `split` cuts A into pieces that are tested one by one; `push` returns the move of B that is
    said to end an overlap (None: by the measured depth, along that axis).
    """

    name: str
    claim: str
    choose: Chooser = needed
    measure: Measure | None = None
    touching_separates: bool = False
    split: Callable[[Shape], Sequence[Shape]] | None = None
    push: Push | None = None

    def tests(self, a: Shape, b: Shape, axes: Sequence[Axis]) -> Iterator[AxisTest]:
        """Yield the test of each axis as the shortcut measures it; InvalidScene where its plain floats overflow."""
        if self.measure is None:
            yield from axis_tests(a, b, axes)
            return
        for axis in axes:
            try:
                test = self.measure(a, b, axis)
                finite = all(map(isfinite, _all_numbers(test)))
            except OverflowError:
                finite = False
            if not finite:
                raise InvalidScene(
                    f"{short_repr(self.name)} measures in plain floats, which overflow here: "
                    "scale the shapes nearer to size 1"
                )
            yield test

    def pieces(self, a: Shape) -> Sequence[Shape] | None:
        """Return the pieces of A that the shortcut tests one by one; None if it does not cut A.

        InvalidScene if a piece is not a valid shape.
        """
        if self.split is None:
            return None
        try:
            return list(self.split(a))
        except InvalidShape as error:
            raise InvalidScene(f"{short_repr(self.name)} cannot cut A into pieces: {error}") from None

    def separates(self, test: AxisTest) -> bool:
        """Return whether the shortcut counts this test as a gap, and so ends the run."""
        return test.gap > 0 or (self.touching_separates and test.gap == 0)


def _all_numbers(test: AxisTest) -> Iterator[float]:
    """Yield every number of a test: its gap, its landings, and the coordinates of its points."""
    yield test.gap
    for side in test.a, test.b:
        yield from side.landings
        for point in side.points:
            yield from point


def move_along_axis(test: AxisTest, length: float) -> Vec:
    """Return a move of B by `length` along a test's axis, to the side that needs the shorter move."""
    a, b, n = test.a.interval, test.b.interval, test.axis.direction
    way = length if a.hi - b.lo < b.hi - a.lo else -length
    return Vec(n.x * way, n.y * way)
