"""What usually lies behind a report: the kinds, and what is said of one shape, each with what helps."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from ...engine.geometry import InvalidShape
from ...engine.shapes import Circle, Polygon, Shape
from .boxes import AT_ORIGIN, Read
from .exact import Exact, crossing, hull, twice_area

MERGED = {
    "clockwise": "run clockwise (with y up; counter-clockwise with y down).",
    "closed-outline": "end with their first corner again.",
}

# The kinds, the gravest first: the first finding is the main one.
KINDS = (
    "third-coordinate",
    "crossing-outline",
    "zero-area",
    "negative-size",
    "refused",
    "not-read",
    "not-applied",
    "no-position",
    "decimals",
    "concave",
    "near-touch",
    "touching",
    "float32",
    "position-twice",
    "corner-for-center",
    "swapped-arguments",
    "containment",
    "whole-numbers",
    "repeated-corner",
    "collinear-corner",
    "clear",
    "left-out",
    "clockwise",
    "closed-outline",
    "note",
)


class Finding(NamedTuple):
    """One line of the diagnosis: its kind (of KINDS), the shapes it is about, what is so, and what helps."""

    kind: str
    about: tuple[str, ...]
    text: str
    help: str = ""

    def __str__(self) -> str:
        return f"{self.text} {self.help}".strip()


@dataclass(frozen=True, slots=True)
class PastedShape:
    """A shape with its name (A, B, ...), as it was read: `shape` is None where it is `refused`, and says why.

    `label`: what the text calls it; `said`: how it was read; `excerpt`: that part of the text; `meant`: for an outline
    that crosses itself the same corners in convex order, if there is one; `vertices`: its corners in float64.
    """

    name: str
    label: str
    said: str
    excerpt: str
    read: Read
    shape: Shape | None
    refused: str = ""
    meant: Polygon | None = None

    @property
    def vertices(self) -> tuple[tuple[float, float], ...]:
        """Return the corners, or a circle's center, in float64."""
        return tuple((float(x), float(y)) for x, y in self.read.points)

    @property
    def title(self) -> str:
        """Return the name, with what the text calls it: A (poly_car)."""
        return f"{self.name} ({self.label})" if self.label and self.label != self.name else self.name

    @property
    def usable(self) -> Shape | None:
        """Return the shape; if it was refused, the one that was probably meant, or None."""
        return self.shape or self.meant


def make_shape(read: Read) -> Shape:
    """Return the engine's shape of what was read; InvalidShape says why it is refused."""
    try:
        points = [(float(x), float(y)) for x, y in read.points]
        radius = None if read.radius is None else float(read.radius)
    except OverflowError:
        raise InvalidShape("a coordinate is too large for float64: scale the shapes down") from None
    return Polygon(points) if radius is None else Circle(points[0], radius)


def exact_of(read: Read) -> Exact:
    """Return the points and the radius of a shape as exact fractions."""
    return Exact(read.points, read.radius)


def meant_order(read: Read) -> Polygon | None:
    """Return the corners of an outline in convex order; None where not all of them are corners of their hull."""
    around = hull(read.points)
    if len(around) != len(set(read.points)) or len(around) < 3:
        return None
    try:
        return Polygon([(float(x), float(y)) for x, y in around])
    except InvalidShape:
        return None


def findings_of_shape(each: PastedShape) -> Iterator[Finding]:
    """Yield the findings about one shape."""
    read, name = each.read, each.title
    if read.negative:
        yield Finding(
            "negative-size",
            (each.name,),
            f"{name} has a negative size: {read.negative}. It was read as the box on the other side of its corner.",
            "Many programs take such a box for empty, so pass the smaller corner and a positive size.",
        )
    if AT_ORIGIN in read.said:
        yield Finding(
            "no-position",
            (each.name,),
            f"{name} has no position in the text, so it was put at the origin.",
            "If it has one, write it beside the shape.",
        )
    if each.shape is None:
        yield _of_refused(each)
        return
    if isinstance(each.shape, Circle):
        return
    notes = each.shape.notes
    repeated = [n for n in notes if "repeats" in n]
    straight = [n for n in notes if "straight" in n]
    if repeated:
        yield Finding(
            "repeated-corner",
            (each.name,),
            f"{name} has a corner twice: {_by_corner_names(repeated[0].split(':')[0], each)}.",
            "Its edge has no length and no normal: a test without a check divides by 0 or finds a gap of 0. Remove it.",
        )
    if straight:
        yield Finding(
            "collinear-corner",
            (each.name,),
            f"{name} has a corner that does not turn: {_by_corner_names(straight[0], each)}.",
            "It changes nothing here; builders of hulls and convex tests can refuse or drop it. Remove it.",
        )
    if twice_area(read.points) < 0:
        yield Finding(
            "clockwise",
            (each.name,),
            f"{name} runs clockwise (with y up; counter-clockwise with y down).",
            "satviz takes both. A library that wants the other order turns all normals around: reverse the corners.",
        )
    if any("closes" in n for n in notes):
        yield Finding(
            "closed-outline",
            (each.name,),
            f"{name} ends with its first corner again.",
            "WKT and GeoJSON want that; libraries that close outlines themselves get an edge without length.",
        )


def _by_corner_names(note: str, each: PastedShape) -> str:
    """Return a note on vertices, which counts from 0, with the names of corners in pictures: a3 for vertex 2 of A."""
    letter = each.name.lower()
    named = re.sub(r"vertex (\d+)", lambda m: f"{letter}{int(m[1]) + 1}", note)
    return f"{named}, with {letter}1 as the first corner"


def _of_refused(each: PastedShape) -> Finding:
    """Return the finding for a shape that the engine refuses."""
    name, why = each.title, each.refused
    if "cross" in why or "turns back" in why:
        corners = len(set(each.read.points))
        order = " Its corners look like rows instead of a way around (Z order)." if corners == 4 and each.meant else ""
        help_line = "List the corners in the order in which you meet them on a walk around the shape."
        if each.meant:
            around = ", ".join(f"({x:.12g}, {y:.12g})" for x, y in each.meant.vertices)
            help_line = f"The convex order is probably meant: {around}."
        text = f"{name} crosses itself: {_crossing_words(each)}.{order}"
        return Finding("crossing-outline", (each.name,), text, help_line)
    if "one line" in why or "distinct" in why or "radius is 0" in why:
        return Finding(
            "zero-area",
            (each.name,),
            f"{name} has no area: {why.split(':')[0]}.",
            "Tests with such a shape find no axis, or one of length 0, and often say hit for everything. "
            "Give it an area, or use a test for segments.",
        )
    if "radius is -" in why:
        return Finding(
            "negative-size",
            (each.name,),
            f"{name} has a negative radius: {why.split(':')[0]}.",
            "Pass its absolute value.",
        )
    return Finding("refused", (each.name,), f"{name} is refused: {why}.")


def _crossing_words(each: PastedShape) -> str:
    """Return words on the edges that cross and on the place, by the names of corners in pictures: a2a3."""
    met = crossing(each.read.points)
    if met is None:
        return each.refused.split(":")[0]
    count = len(each.read.points)
    first, second = (f"{each.name.lower()}{i + 1}{each.name.lower()}{(i + 1) % count + 1}" for i in met[1:])
    x, y = met.point
    return f"its edges {first} and {second} cross at ({float(x):.6g}, {float(y):.6g})"


def listed(names: Sequence[str]) -> str:
    """Return names as a list in words: A, B and D."""
    return f"{', '.join(names[:-1])} and {names[-1]}" if len(names) > 1 else "".join(names)


def merged(found: Sequence[Finding]) -> list[Finding]:
    """Return the findings with those of one kind that say the same of several shapes in one line."""
    kept: list[Finding] = []
    for finding in found:
        first = next((k for k in kept if k.kind == finding.kind and k.kind in MERGED), None)
        if first is None:
            kept.append(finding)
            continue
        about = tuple(dict.fromkeys((*first.about, *finding.about)))
        text = f"{listed(about)} {MERGED[first.kind]}"
        kept[kept.index(first)] = first._replace(about=about, text=text)
    return kept
