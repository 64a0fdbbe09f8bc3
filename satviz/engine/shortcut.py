"""A shortcut: the one loop over other axes, or with one step done otherwise, as people believe it may be."""

from collections.abc import Callable, Iterator, Sequence
from math import isfinite
from typing import NamedTuple

from .axes import Axis, Chooser, needed
from .geometry import InvalidScene, InvalidShape, Vec
from .polygon_validation import shown
from .sat import AxisTest, axis_tests
from .shapes import Shape

Measure = Callable[[Shape, Shape, Axis], AxisTest]
Push = Callable[[Shape, Shape, Sequence[AxisTest]], Vec]


class Shortcut(NamedTuple):
    """What is believed, and what the loop does otherwise because of it.

    `claim`: the belief as people say it; `choose`: its axes.  At most one step differs:
    `measure` projects and measures (None: as it should be), `touching_separates` takes
    a gap of 0 for a gap, `split` takes A apart and every piece by itself, `push`
    gives the way out of an overlap (None: by the depth measured, along that axis).
    """

    name: str
    claim: str
    choose: Chooser = needed
    measure: Measure | None = None
    touching_separates: bool = False
    split: Callable[[Shape], Sequence[Shape]] | None = None
    push: Push | None = None

    def tests(self, a: Shape, b: Shape, axes: Sequence[Axis]) -> Iterator[AxisTest]:
        """Each axis as the shortcut measures it; InvalidScene where its plain floats overflow."""
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
                    f"{shown(self.name)} measures in plain floats, which overflow here: bring the sizes nearer to 1"
                )
            yield test

    def pieces(self, a: Shape) -> Sequence[Shape] | None:
        """What it takes A apart into, if it does; InvalidScene where float64 has no such piece."""
        if self.split is None:
            return None
        try:
            return list(self.split(a))
        except InvalidShape as error:
            raise InvalidScene(f"{shown(self.name)} cannot take A apart: {error}") from None

    def separates(self, test: AxisTest) -> bool:
        """Does the shortcut stop at this test?"""
        return test.gap > 0 or (self.touching_separates and test.gap == 0)


def _all_numbers(test: AxisTest) -> Iterator[float]:
    yield test.gap
    for side in test.a, test.b:
        yield from side.landings
        for point in side.points:
            yield from point


def move_along_axis(test: AxisTest, length: float) -> Vec:
    """A move of B by that length along a test's axis, to the side on which the ranges part sooner."""
    a, b, n = test.a.interval, test.b.interval, test.axis.direction
    way = length if a.hi - b.lo < b.hi - a.lo else -length
    return Vec(n.x * way, n.y * way)
