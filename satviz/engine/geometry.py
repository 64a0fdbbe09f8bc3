"""The values every floor speaks in: points, ranges, relations, and the two exceptions."""

from enum import IntEnum
from typing import NamedTuple


class Vec(NamedTuple):
    """A point or a direction in scene units, x to the right and y up."""

    x: float
    y: float


class Interval(NamedTuple):
    """A closed range on an axis, in scene units; a single point is a range too."""

    lo: float
    hi: float

    def gap(self, other: "Interval") -> float:
        """The signed gap to another range: positive apart, zero touching, negative by the depth.

        The depth is how far one range must move to leave the other, so it is right
        when one holds the other too (min of maxima minus max of minima is not).
        """
        return max(self.lo - other.hi, other.lo - self.hi)


class Relation(IntEnum):
    """How two closed shapes lie to each other; anything but APART is a hit, so it is truthy."""

    APART = 0
    TOUCHING = 1
    OVERLAPPING = 2

    def __str__(self) -> str:
        return self.name.lower()


class InvalidShape(ValueError):
    """A shape the engine refuses; the message names the culprit and the way out."""


class InvalidScene(ValueError):
    """A scene or trace file that is not what its format says; the message names the field."""
