"""What other definitions say of two shapes: open boundaries, the words of OGC, float32, whole numbers, a tolerance.

Each is satviz's own definition with a name of its own, and no claim about what a library does.
"""

import struct
from collections.abc import Callable
from fractions import Fraction
from math import isfinite, trunc
from typing import NamedTuple

from ...engine.geometry import InvalidShape, Relation
from ...engine.number_format import number as short
from ...engine.relate import relate
from ...engine.shapes import Circle, Polygon, Shape
from .exact import Exact, Where, where

APART, TOUCHING, OVERLAPPING = Relation
TOLERANCES = (1e-9, 1e-6)
OGC_TOUCHES = {
    APART: "they share no point",
    TOUCHING: "they share border points, but no interior point",
    OVERLAPPING: "they share interior points",
}


class View(NamedTuple):
    """What one definition says: its name, its answer, and why that is so."""

    definition: str
    answer: str
    why: str


def exact_of(shape: Shape) -> Exact:
    """Return a shape of the engine in fractions, as float64 holds it."""
    points = tuple((Fraction(x), Fraction(y)) for x, y in shape.core)
    return Exact(points, Fraction(shape.radius) if shape.core_is_point else None)


def lie(a: Shape, b: Shape) -> Where:
    """Return how two shapes lie; containment is None where it would take too long."""
    found = where(exact_of(a), exact_of(b))
    return found or Where(relate(a, b), None, None)


def in_float32(a: Shape, b: Shape) -> Relation | str:
    """Return the relation once each number is rounded to float32, or why a shape is no longer valid."""
    return _changed(a, b, lambda value: struct.unpack("f", struct.pack("f", value))[0])


def in_whole_numbers(a: Shape, b: Shape) -> Relation | str:
    """Return the relation once the digits after the decimal point of each number are cut off."""
    return _changed(a, b, lambda value: float(trunc(value)))


def _changed(a: Shape, b: Shape, change: Callable[[float], float]) -> Relation | str:
    """Return the relation of both shapes with each number changed; why not, where a shape is refused then."""
    try:
        p, q = (_with_numbers(shape, change) for shape in (a, b))
    except InvalidShape as error:
        return str(error)
    except OverflowError:
        return "a number is too large"
    return relate(p, q)


def _with_numbers(shape: Shape, change: Callable[[float], float]) -> Shape:
    """Return the shape with each number changed; InvalidShape or OverflowError where they make no shape."""
    if isinstance(shape, Circle):
        return Circle((change(shape.center.x), change(shape.center.y)), change(shape.radius))
    return Polygon([(change(x), change(y)) for x, y in shape.vertices])


def views(a: Shape, b: Shape, lies: Where, gap: float) -> list[View]:
    """Return the answers of other definitions about a pair: open boundaries, OGC, float32, whole numbers, tolerances.

    gap: the largest gap of its axes, negative for an overlap.
    """
    relation = lies.relation
    found = [
        View("closed boundary, as satviz has it", _hit(relation is not APART), "a shared border counts"),
        View(
            "open boundary, as many engines have it",
            _hit(relation is OVERLAPPING),
            "only shared inside counts" if relation is not TOUCHING else OGC_TOUCHES[relation],
        ),
        View(
            "OGC intersects", _says(relation is not APART), "they share a point" if relation else "they share no point"
        ),
        View("OGC disjoint", _says(relation is APART), "the opposite of intersects"),
        View("OGC touches", _says(relation is TOUCHING), OGC_TOUCHES[relation]),
    ]
    if relation is not OVERLAPPING:
        found.append(View("OGC overlaps, contains, within", _says(False), "they share no inner point"))
    elif lies.a_in_b is not None:
        contained = lies.a_in_b or lies.b_in_a
        why = (
            "each has a part outside the other"
            if not contained
            else "one lies wholly in the other, which is not called an overlap there"
        )
        found.append(View("OGC overlaps", _says(not contained), why))
        found.append(View("OGC contains (A contains B)", _says(bool(lies.b_in_a)), _whole("B", "A", lies.b_in_a)))
        found.append(View("OGC within (A within B)", _says(bool(lies.a_in_b)), _whole("A", "B", lies.a_in_b)))
        if lies.a_in_b and lies.b_in_a:
            found.append(View("OGC equals", _says(True), "both are the same set of points"))
    for name, changed, how in (
        ("float32 coordinates", in_float32(a, b), "each coordinate rounded to 24 bits"),
        ("whole coordinates", in_whole_numbers(a, b), "the digits after the decimal point cut off"),
    ):
        said = f"{changed} instead of {relation}" if changed is not relation else str(relation)
        if isinstance(changed, str):
            said = f"refused: {changed}"
        found.append(View(name, said, how))
    for tolerance in TOLERANCES:
        near = isfinite(gap) and abs(gap) <= tolerance
        why = "within it" if near else "beyond it"
        size = f"{'gap' if gap > 0 else 'overlap'} {short(abs(gap))}" if gap else "gap 0"
        found.append(
            View(
                f"a tolerance of {tolerance:g} on each axis",
                "touching" if near else str(relation),
                f"the {size} is {why}",
            )
        )
    return found


def _hit(value: bool) -> str:
    """Return "hit" or "no hit", as a collision test says it."""
    return "hit" if value else "no hit"


def _says(value: bool) -> str:
    """Return "true" or "false", as a predicate says it."""
    return "true" if value else "false"


def _whole(inner: str, outer: str, value: bool | None) -> str:
    """Return why one shape does or does not contain the other."""
    return f"all of {inner} lies in {outer}" if value else f"a part of {inner} lies outside {outer}"
