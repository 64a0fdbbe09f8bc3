"""`record` and the Trace: every tested axis, landing and gap, and what follows from them."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import product
from math import isfinite
from typing import NamedTuple

from . import hooks
from .axes import EARLY_EXIT, NAMED, Choice, Chooser, Skip, needed, validate_choice
from .certificate import Certificate, PartLines, separating_line, shared_point
from .convex_parts import named_parts
from .geometry import APART, OVERLAPPING, TOUCHING, InvalidScene, Relation, Vec
from .mtv import mtv_along_axis, mtv_of_parts
from .relate import relate
from .sat import AxisTest, axis_tests
from .shapes import Shape, require_shape
from .shortcut import Shortcut, move_along_axis

# points and axes that a trace lists (see _count_listed): some 30 MB of JSON, which can be read again
MAX_SIZE = 200_000
NamedParts = Sequence[tuple[Shape, str]]  # convex parts or pieces, each with its name


class ShapeNames(NamedTuple):
    """The names of the two shapes of a trace in sentences: "A" and "B", or the name of a convex part such as "B2"."""

    a: str = "A"
    b: str = "B"


DEFAULT_NAMES = ShapeNames()


@dataclass(frozen=True, slots=True)
class Trace:
    """One run of the loop over a pair of shapes: its fields hold what was measured, all else is derived from them.

    `a`, `b`: the shapes; `choice`: the axes in the order in which to test them, and those left out; `tests`: the
    tests of the axes up to the end of the run, in that order; `every_axis`: whether the run went on after a
    separating axis; `pairs`: for concave outlines, a trace for each tested pair of convex parts (`tests` is empty
    then); `names`: what the shapes are called; `shortcut`: what this run does differently from the loop, or None.
    A trace is immutable; it can be compared, hashed, and iterated (over `tests`).
    """

    a: Shape
    b: Shape
    choice: Choice
    tests: tuple[AxisTest, ...]
    every_axis: bool
    pairs: tuple["Trace", ...]
    names: ShapeNames = DEFAULT_NAMES
    shortcut: Shortcut | None = None

    @property
    def relation(self) -> Relation:
        """Return the exact relation of the shapes, even where the tested axes alone claim another one (see `claim`)."""
        if self.shortcut:
            return relate(self.a, self.b)
        claim = self.claim
        return claim if claim is APART or self.choice.complete else relate(self.a, self.b)

    @property
    def hit(self) -> bool:
        """Return whether the closed shapes share a point; touching counts."""
        return self.relation is not APART

    @property
    def claim(self) -> Relation:
        """Return the relation that follows from the tested axes alone.

        APART, from a gap, is proven.  TOUCHING or OVERLAPPING, from no gap, is proven only if `choice.complete`.
        In a run with a shortcut, it is what the shortcut says, right or wrong.
        """
        if self.pairs:
            return max(pair.relation for pair in self.pairs)
        if self.ended_by:
            return APART
        return TOUCHING if any(test.gap == 0 for test in self.tests) else OVERLAPPING

    @property
    def false_hit(self) -> bool:
        """Return whether the run claims a hit although the shapes are apart: its axes are not enough."""
        return self.claim is not APART and self.relation is APART

    @property
    def missed_hit(self) -> bool:
        """Return whether the run claims APART although the shapes share a point; only a shortcut can do so."""
        return self.shortcut is not None and self.claim is APART and self.hit

    @property
    def ended_by(self) -> AxisTest | None:
        """Return the first test that the run counts as a gap, rightly or wrongly; None if there is none."""
        own = self.shortcut
        return next((test for test in self.tests if (own.separates(test) if own else test.separates)), None)

    @property
    def gaps_are_proofs(self) -> bool:
        """Return whether a gap in `tests` proves the shapes apart; False if a shortcut measures in its own way."""
        return self.shortcut is None or self.shortcut.measure is None

    @property
    def separating(self) -> AxisTest | None:
        """Return the first test whose axis separates the shapes; None without one, or if `gaps_are_proofs` is False."""
        return next((test for test in self.tests if test.separates), None) if self.gaps_are_proofs else None

    @property
    def colliding(self) -> "Trace | None":
        """Return the trace of the pair of convex parts that decides a hit; None without `pairs` or without a hit.

        It is the first pair that has the relation of the whole: an overlapping one, else a touching one.
        """
        found = self.relation
        return next((pair for pair in self.pairs if pair.relation is found), None) if found else None

    @property
    def shallowest(self) -> AxisTest | None:
        """Return the test with the least measured penetration depth; None if a test ended the run or none was made."""
        return _least_overlap(self.tests) if self.tests and not self.ended_by else None

    @property
    def mtv(self) -> Vec | None:
        """Return the minimum translation vector (MTV): the shortest move of B that ends the overlap, in scene units.

        The move is rounded outwards, so that it certainly ends the overlap.  If the choice of axes is complete or
        an outline is concave, no move is shorter by more than a rounding of the largest coordinate; otherwise it is
        the shortest along the tested axes.  (0, 0) when the shapes only touch.  None when they are apart, when the
        move is beyond float64, or when a shortcut measures differently or misses the hit.  It is computed at
        each call; InvalidScene for concave outlines with too many convex parts.
        """
        if self.missed_hit or not self.gaps_are_proofs:
            return None
        relation = self.relation
        if relation is not OVERLAPPING:
            return None if relation is APART else Vec(0.0, 0.0)
        if not (self.a.is_convex and self.b.is_convex):
            return mtv_of_parts(self.a, self.b)
        return mtv_along_axis(self.a, self.b, _least_overlap(self.tests or record(self.a, self.b).tests))

    @property
    def known_mtv(self) -> Vec | None:
        """Return `mtv`, or None where `mtv` raises InvalidScene because computing it would take too long."""
        try:
            return self.mtv
        except InvalidScene:
            return None

    @property
    def push(self) -> Vec | None:
        """Return the move of B by which this run would end the overlap: the MTV, or what its shortcut uses instead.

        None where `mtv` is None or the shortcut claims APART, where the MTV of a piece would take too long to find,
        and where the move is beyond float64.
        """
        if self.shortcut is None:
            return self.mtv
        if self.claim is APART:
            return None
        if self.shortcut.push:
            return self.shortcut.push(self.a, self.b, self.tests)
        if self.pairs:
            moves = [pair.known_mtv for pair in self.pairs if pair.relation is OVERLAPPING]
            found = [move for move in moves if move]
            push = Vec(sum((move.x for move in found), 0.0), sum((move.y for move in found), 0.0))
            return push if len(found) == len(moves) and all(map(isfinite, push)) else None
        test = self.shallowest
        return move_along_axis(test, -test.gap) if test else None

    @property
    def truth(self) -> "Trace":
        """Return the trace of the same shapes without the shortcut, over every axis; this trace if it has none."""
        return record(self.a, self.b, every_axis=True) if self.shortcut else self

    @property
    def certificate(self) -> Certificate:
        """Return evidence that its method `check` verifies with fractions.

        A SeparatingLine or, for concave outlines, PartLines prove that the shapes are apart; a SharedPoint proves a
        hit.  InvalidScene if a shortcut measures differently or misses a hit, since that run proves nothing.
        """
        if self.missed_hit or not self.gaps_are_proofs:
            raise InvalidScene("this run took a shortcut, so it proves nothing: use trace.truth.certificate")
        if self.separating:
            return separating_line(self.a, self.b, self.separating.axis)
        if self.pairs and not self.shortcut:  # the pieces of a shortcut may not cover the shape
            hit = self.colliding
            if hit:
                return hit.certificate._replace(a=self.a, b=self.b)
            lines = (separating_line(p.a, p.b, p.separating.axis) for p in self.pairs if p.separating)
            return PartLines(self.a, self.b, tuple(lines))
        if self.choice.complete:
            return shared_point(self.a, self.b)
        # the default choice of axes is complete, so this call ends in a case above
        return record(self.a, self.b).certificate

    @property
    def skipped(self) -> tuple[Skip, ...]:
        """Return each axis that was not tested, with the reason: skipped by the choice, or by the early exit."""
        left = self.choice.axes[len(self.tests) :]
        return self.choice.skipped + tuple(Skip(axis, EARLY_EXIT, len(self.tests)) for axis in left)

    def without_early_exit(self) -> "Trace":
        """Return the same run over every axis of the choice and every pair of parts; InvalidScene as in `record`."""
        if self.every_axis:
            return self
        if self.shortcut:
            return _record_shortcut(self.a, self.b, self.shortcut, True)
        if self.pairs:
            return _record_parts(self.a, self.b, True)
        return _record(self.a, self.b, self.choice, True, self.names)

    @property
    def sentence(self) -> str:
        """Return one sentence that says the relation, what proves it, and the MTV of an overlap."""
        sentence: str = hooks.call("trace_sentence", self, self.known_mtv)
        return sentence

    def __str__(self) -> str:
        return self.table()

    def table(self, *, width: int | None = None, sums: bool = False) -> str:
        """Return the table that `print(trace)` shows, in lines of at most `width` characters.

        `sums`: below each test stand the sums behind the ends of both ranges, such as
        "v1: 2*8 + 3*3 = 25; 25 / sqrt(13) = 6.934"; a sum whose numbers are not printed in full is left out.
        """
        text: str = hooks.call("trace_table", self, width, sums)
        return text

    def __iter__(self) -> Iterator[AxisTest]:
        return iter(self.tests)

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, str]:
        """Return what a notebook shows: the table and the last picture."""
        return hooks.mime_bundle(self)

    def to_json(self, *, indent: int | None = None) -> str:
        """Return the trace as JSON: the shapes, each axis and landing, and what other readers would have to derive.

        InvalidScene for a shortcut that satviz does not define, and for more text than `from_json` reads.
        """
        text: str = hooks.call("trace_to_json", self, indent)
        return text

    @staticmethod
    def from_json(text: str) -> "Trace":
        """Return the trace that `to_json` wrote.

        InvalidScene if a field is missing or unknown, or contradicts the shapes.
        """
        trace: Trace = hooks.call("trace_from_json", text)
        return trace


def record(a: Shape, b: Shape, *, axes: Chooser | Choice | Shortcut = needed, every_axis: bool = False) -> Trace:
    """Run the loop over two shapes and return its Trace, whose relation is exact.

    `axes`: a choice of axes (satviz.axes) or a function that makes one, by default the smallest complete set, with
    which concave polygons are tested part by part.  Or a shortcut: the trace then has the shortcut's `claim`
    beside the exact relation.  The loop stops at the first separating axis, and with parts at the first pair that
    overlaps, unless `every_axis`.
    TypeError if a shape is neither Polygon nor Circle or `axes` is not a choice; ValueError
    for axes of other shapes; InvalidScene if the trace would list more than 200,000 points and axes, or
    if a shortcut's plain floats overflow.
    """
    require_shape(a, "a"), require_shape(b, "b")
    every_axis = bool(every_axis)
    if axes is needed and not (a.is_convex and b.is_convex):
        return _record_parts(a, b, every_axis)
    if type(axes) is Shortcut:  # a subclass may have methods of its own and yet compare equal to a Shortcut
        return _record_shortcut(a, b, axes, every_axis)
    if not (isinstance(axes, Choice) or callable(axes)):
        raise TypeError(
            f"axes is a {type(axes).__name__}: expected a choice of axes, or a function that makes one (satviz.axes)"
        )
    choice = axes if isinstance(axes, Choice) else axes(a, b)
    own = any(axes is choose for choose in NAMED.values())
    return _record(a, b, choice if own else validate_choice(choice, a, b), every_axis, DEFAULT_NAMES)


def _record_shortcut(a: Shape, b: Shape, shortcut: Shortcut, every_axis: bool) -> Trace:
    """Run a shortcut on A, or on each piece of A, against B; return the trace."""
    pieces = shortcut.pieces(a)
    if pieces is None:
        return _record(a, b, shortcut.choose(a, b), every_axis, DEFAULT_NAMES, shortcut)
    return _record_pairs(a, b, [(p, f"A{i}") for i, p in enumerate(pieces, 1)], [(b, "B")], every_axis, shortcut)


def _record(
    a: Shape, b: Shape, choice: Choice, every_axis: bool, names: ShapeNames, shortcut: Shortcut | None = None
) -> Trace:
    """Run the loop over one choice of axes and return its trace; InvalidScene if it would list too much.

    `every_axis`, `names`, `shortcut`: the fields of Trace.
    """
    tests: list[AxisTest] = []
    measured = shortcut.tests(a, b, choice.axes) if shortcut else axis_tests(a, b, choice.axes)
    _check_size(a, b, choice, tests, names)
    for test in measured:
        tests.append(test)
        _check_size(a, b, choice, tests, names)
        if not every_axis and (test.gap > 0 or (shortcut and shortcut.separates(test))):
            break
    return Trace(a, b, choice, tuple(tests), every_axis, (), names, shortcut)


def _record_parts(a: Shape, b: Shape, every_axis: bool) -> Trace:
    """Run the loop on the pairs of convex parts of A and B; return one trace that holds all of theirs."""
    return _record_pairs(a, b, named_parts(a, "A"), named_parts(b, "B"), every_axis)


def _record_pairs(
    a: Shape, b: Shape, of_a: NamedParts, of_b: NamedParts, every_axis: bool, shortcut: Shortcut | None = None
) -> Trace:
    """Run the loop on each part of A with each of B; return one trace that holds all of theirs.

    `of_a`, `of_b`: the convex parts or pieces, each with its name.
    """
    pairs, size = [], 0
    for (p, name_a), (q, name_b) in product(of_a, of_b):
        pair = _record(p, q, needed(p, q), every_axis, ShapeNames(name_a, name_b))
        pairs.append(pair)
        size += _count_listed(p, q, pair.choice, pair.tests)
        if size > MAX_SIZE:
            raise _too_large_error(
                f"A and B have {len(of_a) * len(of_b):,} pairs of {'pieces' if shortcut else 'convex parts'}"
            )
        if not shortcut and pair.relation is OVERLAPPING and not every_axis:
            break
    return Trace(a, b, Choice((), complete=not shortcut), (), every_axis, tuple(pairs), DEFAULT_NAMES, shortcut)


def _least_overlap(tests: Sequence[AxisTest]) -> AxisTest:
    """Return the test with the largest gap: of overlaps, the one with the least penetration depth."""
    return max(tests, key=lambda test: test.gap)


def _count_listed(a: Shape, b: Shape, choice: Choice, tests: Sequence[AxisTest]) -> int:
    """Return how many points and axes a trace lists: all points once and again for each test, and each axis."""
    return _count_points(a, b) * (1 + len(tests)) + len(choice.axes) + len(choice.skipped)


def _check_size(a: Shape, b: Shape, choice: Choice, tests: Sequence[AxisTest], names: ShapeNames) -> None:
    """Raise InvalidScene if a trace would list more than MAX_SIZE points and axes."""
    if _count_listed(a, b, choice, tests) > MAX_SIZE:
        raise _too_large_error(
            f"{' and '.join(names)} have {_count_points(a, b):,} points to project on {len(choice.axes):,} axes"
        )


def _count_points(a: Shape, b: Shape) -> int:
    """Return the number of points of both shapes: a polygon's vertices, two for a circle."""
    return sum(2 if shape.core_is_point else len(shape.vertices) for shape in (a, b))


def _too_large_error(what: str) -> InvalidScene:
    """Return the InvalidScene for a trace over MAX_SIZE; `what`: what is too many, in words."""
    return InvalidScene(
        f"{what}: a trace lists {MAX_SIZE:,} points and axes at most; call relate for the relation alone, "
        "choose fewer axes (such as satviz.axes.world), or simplify the shapes"
    )
