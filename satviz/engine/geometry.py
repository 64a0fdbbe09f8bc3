"""The values that all layers share: points, ranges, relations, and the two exceptions."""

from collections.abc import Iterator, Sequence
from enum import IntEnum
from typing import Any, NamedTuple, TypeVar

T = TypeVar("T")


class Vec(NamedTuple):
    """A point or a direction in scene units, x to the right and y up."""

    x: float
    y: float


class Interval(NamedTuple):
    """A closed range on an axis, in scene units; a single point is a range too."""

    lo: float
    hi: float

    def gap(self, other: "Interval") -> float:
        """Return the signed gap to another range: positive apart, 0 touching, minus the depth where they overlap.

        The depth is how far one range must move to leave the other.  The smaller maximum
        minus the larger minimum is not the depth where one range contains the other.
        """
        return max(self.lo - other.hi, other.lo - self.hi)


class Relation(IntEnum):
    """The relation of two closed shapes.  TOUCHING and OVERLAPPING are hits; APART, which is 0, is false."""

    APART = 0
    TOUCHING = 1
    OVERLAPPING = 2

    def __str__(self) -> str:
        """Return the name in lower case, such as "apart"."""
        return self.name.lower()


APART, TOUCHING, OVERLAPPING = Relation


def relation_of_gap(gap: Any) -> Relation:
    """Return APART for a gap > 0, TOUCHING for 0, OVERLAPPING for a gap < 0; the sign must be exact."""
    return APART if gap > 0 else OVERLAPPING if gap < 0 else TOUCHING


class InvalidShape(ValueError):
    """Raised for a shape that the engine refuses; the message names the vertex or value and what to do."""


class InvalidScene(ValueError):
    """Raised for a scene or trace that breaks its format or a limit; the message names the field or the number."""


def cyclic_pairs(ring: Sequence[T]) -> Iterator[tuple[T, T]]:
    """Yield each item with the next one, and at the end the last with the first: of corners, these are the edges."""
    return zip(ring, [*ring[1:], *ring[:1]], strict=True)


def cyclic_triples(ring: Sequence[T]) -> Iterator[tuple[T, T, T]]:
    """Yield each item between its two neighbours: (previous, item, next)."""
    return zip([*ring[-1:], *ring[:-1]], ring, [*ring[1:], *ring[:1]], strict=True)


def nearest_fraction(px: Any, py: Any, dx: Any, dy: Any) -> Any:
    """Return the t from 0 to 1 for which p + t d is nearest to the origin; in floats or fractions, 0 if d is (0, 0)."""
    square = dx * dx + dy * dy
    return min(1, max(0, -(px * dx + py * dy) / square)) if square else 0
