"""record and the Trace: every tested axis, every landing place, every gap, and what follows from them."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

from . import telling
from .axes import Choice, Chooser, Skip, needed
from .certificate import Certificate, PartLines, separating_line, shared_point
from .concave import named_parts, parts
from .escape import along_axis, around_parts
from .geometry import Relation, Vec
from .sat import AxisTest, axis_tests
from .shapes import Circle, Polygon, Shape, checked
from .verdict import relate

APART, TOUCHING, OVERLAPPING = Relation


class Names(NamedTuple):
    """What the two shapes are called: "A" and "B", or a part's name such as "B2"."""

    a: str = "A"
    b: str = "B"


PLAIN = Names()


@dataclass(frozen=True, slots=True)
class Trace:
    """One run of the loop over a pair of shapes: the facts in its fields, the verdict derived from them.

    `choice`: the axes in order and those left out; `tests`: the axes tested, in that
    order; `pairs`: for concave outlines, a trace for each pair of convex parts
    looked at (then `tests` is empty).  Traces compare, hash and never change.
    """

    a: Shape
    b: Shape
    choice: Choice
    tests: tuple[AxisTest, ...]
    every_axis: bool = False
    pairs: tuple["Trace", ...] = ()
    names: Names = PLAIN

    @property
    def relation(self) -> Relation:
        """The exact relation, also where the chosen axes alone could not tell (see `claim`)."""
        if self.pairs:
            return max(pair.relation for pair in self.pairs)
        claim = self.claim
        return claim if claim is APART or self.choice.complete else relate(self.a, self.b)

    @property
    def hit(self) -> bool:
        """Do the closed shapes share a point?  Touching counts."""
        return self.relation is not APART

    @property
    def claim(self) -> Relation:
        """What the tested axes say by themselves: a gap proves APART, no gap proves nothing unless complete."""
        if self.pairs:
            return self.relation
        gaps = [test.gap for test in self.tests]
        if any(gap > 0 for gap in gaps):
            return APART
        return TOUCHING if 0 in gaps else OVERLAPPING

    @property
    def false_hit(self) -> bool:
        """No tested axis separates, yet the shapes are apart: the chosen axes are not enough."""
        return self.claim is not APART and self.relation is APART

    @property
    def separating(self) -> AxisTest | None:
        """The first test whose axis separates the shapes, or None."""
        return next((test for test in self.tests if test.separates), None)

    @property
    def colliding(self) -> "Trace | None":
        """The trace of the part pair that settles a hit of concave outlines, or None."""
        return next((pair for pair in self.pairs if pair.hit and pair.relation is self.relation), None)

    @property
    def shallowest(self) -> AxisTest | None:
        """The test of least penetration depth when none separates, or None."""
        return max(self.tests, key=lambda test: test.gap) if self.tests and self.claim is not APART else None

    @property
    def mtv(self) -> Vec | None:
        """The minimum translation vector: the shortest move of B found to end the overlap, in scene units.

        It ends the overlap exactly, being rounded outwards; (0, 0) when the shapes only
        touch, None when they are apart or when no float64 move is long enough.  It is the
        shortest of all (to a rounding) where the choice of axes is complete, else the
        shortest along the tested axes.
        """
        relation = self.relation
        if relation is not OVERLAPPING:
            return None if relation is APART else Vec(0.0, 0.0)
        if not (_convex(self.a) and _convex(self.b)):
            return around_parts(self.a, self.b)
        return along_axis(self.a, self.b, self.shallowest) if self.tests else around_parts(self.a, self.b)

    @property
    def certificate(self) -> Certificate:
        """Evidence anyone can check: a separating line, or a point in both shapes; `check()` uses fractions."""
        if self.separating:
            return separating_line(self.a, self.b, self.separating.axis)
        if self.relation is not APART:
            for p in parts(self.a):
                for q in parts(self.b):
                    if relate(p, q) is self.relation:
                        return shared_point(p, q)._replace(a=self.a, b=self.b)
        lines = tuple(record(p, q).certificate for p in parts(self.a) for q in parts(self.b))
        return lines[0] if len(lines) == 1 else PartLines(self.a, self.b, lines)

    @property
    def skipped(self) -> tuple[Skip, ...]:
        """(axis, reason) of each axis not tested: left out by the choice, or by the early exit."""
        left = self.choice.axes[len(self.tests) :]
        return self.choice.skipped + tuple(Skip(axis, f"early exit: axis {len(self.tests)} separates") for axis in left)

    def without_early_exit(self) -> "Trace":
        """The same run over every axis of the choice (and every pair of parts)."""
        if self.every_axis:
            return self
        if self.pairs:
            return _record_parts(self.a, self.b, True)
        return _record(self.a, self.b, self.choice, True, self.names)

    @property
    def sentence(self) -> str:
        """The verdict in words."""
        return telling.verdict(self)

    def __str__(self) -> str:
        return telling.table(self)

    def __iter__(self) -> Iterator[AxisTest]:
        return iter(self.tests)

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, str]:
        """In a notebook: the table and the last picture."""
        from .render.shown import bundle

        return bundle(self)

    def to_json(self, *, indent: int | None = None) -> str:
        """The trace as JSON: the shapes, each axis and landing place, and the verdicts for readers elsewhere."""
        from .tracefile import dump

        return dump(self, indent)

    @staticmethod
    def from_json(text: str) -> "Trace":
        """The trace that `to_json` wrote; InvalidScene if anything in it is missing, unknown or untrue."""
        from .tracefile import load

        return load(text)


def record(a: Shape, b: Shape, *, axes: Chooser | Choice = needed, every_axis: bool = False) -> Trace:
    """Run the loop and keep everything: a Trace whose relation is exact.

    `axes`: a choice of axes (satviz.axes), by default the smallest complete set; with
    it, concave polygons are tested part by part.  The loop stops at the first
    separating axis, and for parts at the first pair that overlaps, unless
    `every_axis`.  TypeError for anything but Polygon and Circle.
    """
    checked(a, "a"), checked(b, "b")
    if axes is needed and not (_convex(a) and _convex(b)):
        return _record_parts(a, b, every_axis)
    return _record(a, b, axes if isinstance(axes, Choice) else axes(a, b), every_axis, PLAIN)


def _record(a: Shape, b: Shape, choice: Choice, every_axis: bool, names: Names) -> Trace:
    tests = []
    for test in axis_tests(a, b, choice.axes):
        tests.append(test)
        if test.gap > 0 and not every_axis:
            break
    return Trace(a, b, choice, tuple(tests), every_axis, (), names)


def _record_parts(a: Shape, b: Shape, every_axis: bool) -> Trace:
    pairs = []
    for p, name_a in named_parts(a, "A"):
        for q, name_b in named_parts(b, "B"):
            pairs.append(_record(p, q, needed(p, q), every_axis, Names(name_a, name_b)))
            if pairs[-1].relation is OVERLAPPING and not every_axis:
                return Trace(a, b, Choice((), complete=True), (), every_axis, tuple(pairs))
    return Trace(a, b, Choice((), complete=True), (), every_axis, tuple(pairs))


def _convex(shape: Shape) -> bool:
    return isinstance(shape, Circle) or (isinstance(shape, Polygon) and shape.is_convex)
