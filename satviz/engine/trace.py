"""record and the Trace: every tested axis, every landing place, every gap, and what follows from them."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import product
from math import isfinite

from . import describe, hooks
from .axes import EARLY_EXIT, NAMED, Choice, Chooser, Skip, needed, validate_choice
from .certificate import Certificate, PartLines, separating_line, shared_point
from .convex_parts import named_parts
from .describe import Names
from .geometry import InvalidScene, Relation, Vec
from .mtv import mtv_along_axis, mtv_of_parts
from .relate import relate
from .sat import AxisTest, axis_tests
from .shapes import Shape, checked
from .shortcut import Shortcut, move_along_axis

APART, TOUCHING, OVERLAPPING = Relation

MAX_SIZE = 200_000  # what a trace lists (see _size): some 30 MB of JSON, which can be read again


PLAIN = Names()
NamedParts = Sequence[tuple[Shape, str]]  # parts, and what each is called


@dataclass(frozen=True, slots=True)
class Trace:
    """One run of the loop over a pair of shapes: the facts in its fields, the verdict derived from them.

    `choice`: the axes in order and those left out; `tests`: the axes tested, in that
    order; `pairs`: for concave outlines, a trace for each pair of convex parts
    looked at (then `tests` is empty); `shortcut`: what this run does otherwise than the
    loop should, if anything.  Traces compare, hash and never change.
    """

    a: Shape
    b: Shape
    choice: Choice
    tests: tuple[AxisTest, ...]
    every_axis: bool
    pairs: tuple["Trace", ...]
    names: Names = PLAIN
    shortcut: Shortcut | None = None

    @property
    def relation(self) -> Relation:
        """The exact relation, also where the chosen axes alone could not tell (see `claim`)."""
        if self.shortcut:
            return relate(self.a, self.b)
        claim = self.claim
        return claim if claim is APART or self.choice.complete else relate(self.a, self.b)

    @property
    def hit(self) -> bool:
        """Do the closed shapes share a point?  Touching counts."""
        return self.relation is not APART

    @property
    def claim(self) -> Relation:
        """What the tested axes say by themselves: a gap proves APART, no gap proves nothing unless complete.

        Of a shortcut's run it is what the shortcut says, right or wrong.
        """
        if self.pairs:
            return max(pair.relation for pair in self.pairs)
        if self.ended_by:
            return APART
        return TOUCHING if any(test.gap == 0 for test in self.tests) else OVERLAPPING

    @property
    def false_hit(self) -> bool:
        """No tested axis separates, yet the shapes are apart: the chosen axes are not enough."""
        return self.claim is not APART and self.relation is APART

    @property
    def missed_hit(self) -> bool:
        """A shortcut's run says apart, yet the shapes share a point."""
        return self.shortcut is not None and self.claim is APART and self.hit

    @property
    def ended_by(self) -> AxisTest | None:
        """The first test that the run takes for separating, right or wrong, or None."""
        separates = self.shortcut.separates if self.shortcut else _separates
        return next((test for test in self.tests if separates(test)), None)

    @property
    def proves(self) -> bool:
        """Is a gap in `tests` a proof?  Not where a shortcut measures otherwise."""
        return self.shortcut is None or self.shortcut.measure is None

    @property
    def separating(self) -> AxisTest | None:
        """The first test whose axis separates the shapes, or None; where a shortcut measures otherwise none does."""
        return next((test for test in self.tests if test.separates), None) if self.proves else None

    @property
    def colliding(self) -> "Trace | None":
        """The trace of the part pair that settles a hit of concave outlines, or None."""
        found = self.relation
        return next((pair for pair in self.pairs if pair.relation is found), None) if found else None

    @property
    def shallowest(self) -> AxisTest | None:
        """The test of least penetration depth, as measured, when none separates, or None."""
        return _least_overlap(self.tests) if self.tests and not self.ended_by else None

    @property
    def mtv(self) -> Vec | None:
        """The minimum translation vector: the shortest move of B found to end the overlap, in scene units.

        It ends the overlap exactly, being rounded outwards; (0, 0) when the shapes only
        touch, None when they are apart or when no float64 move is long enough.  It is the
        shortest of all (to a rounding of the largest coordinate) where the choice of axes is
        complete, else the shortest along the tested axes.  None also where a shortcut
        measures otherwise or misses the hit.  Worked out when asked for; InvalidScene for
        concave outlines of too many parts.
        """
        if self.missed_hit or not self.proves:
            return None
        relation = self.relation
        if relation is not OVERLAPPING:
            return None if relation is APART else Vec(0.0, 0.0)
        if not (self.a.is_convex and self.b.is_convex):
            return mtv_of_parts(self.a, self.b)
        return mtv_along_axis(self.a, self.b, _least_overlap(self.tests or record(self.a, self.b).tests))

    @property
    def known_mtv(self) -> Vec | None:
        """`mtv` for tables, files and pictures, which do without where it would take too long: then None."""
        try:
            return self.mtv
        except InvalidScene:
            return None

    @property
    def push(self) -> Vec | None:
        """The move of B by which this run would end the overlap: the MTV, or what its shortcut takes for it.

        None also where a piece's move would take too long to find, or is too long for float64.
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
        """The same pair as the loop should run it: this trace itself unless it is a shortcut's."""
        return record(self.a, self.b, every_axis=True) if self.shortcut else self

    @property
    def certificate(self) -> Certificate:
        """Evidence anyone can check: a separating line, or a point in both shapes; `check()` uses fractions.

        InvalidScene where a shortcut measures otherwise or misses a hit: that run proves nothing.
        """
        if self.missed_hit or not self.proves:
            raise InvalidScene("this run took a shortcut, so it proves nothing: ask trace.truth for a certificate")
        if self.separating:
            return separating_line(self.a, self.b, self.separating.axis)
        if self.pairs and not self.shortcut:  # whose pieces may leave out some of a shape
            hit = self.colliding
            if hit:
                return hit.certificate._replace(a=self.a, b=self.b)
            lines = (separating_line(p.a, p.b, p.separating.axis) for p in self.pairs if p.separating)
            return PartLines(self.a, self.b, tuple(lines))
        if self.choice.complete:
            return shared_point(self.a, self.b)
        return record(self.a, self.b).certificate  # that choice is complete, so it ends in a case above

    @property
    def skipped(self) -> tuple[Skip, ...]:
        """Each axis not tested: left out by the choice, or by the early exit."""
        left = self.choice.axes[len(self.tests) :]
        return self.choice.skipped + tuple(Skip(axis, EARLY_EXIT, len(self.tests)) for axis in left)

    def without_early_exit(self) -> "Trace":
        """The same run over every axis of the choice (and every pair of parts); InvalidScene as for `record`."""
        if self.every_axis:
            return self
        if self.shortcut:
            return _record_shortcut(self.a, self.b, self.shortcut, True)
        if self.pairs:
            return _record_parts(self.a, self.b, True)
        return _record(self.a, self.b, self.choice, True, self.names)

    @property
    def sentence(self) -> str:
        """The verdict in words."""
        return describe.verdict(self, self.known_mtv)

    def __str__(self) -> str:
        return describe.table(self)

    def __iter__(self) -> Iterator[AxisTest]:
        return iter(self.tests)

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, str]:
        """In a notebook: the table and the last picture."""
        return hooks.mime_bundle(self)

    def to_json(self, *, indent: int | None = None) -> str:
        """The trace as JSON: the shapes, each axis and landing place, and the verdicts for readers elsewhere."""
        return hooks.trace_to_json(self, indent)

    @staticmethod
    def from_json(text: str) -> "Trace":
        """The trace that `to_json` wrote; InvalidScene if anything in it is missing, unknown or untrue."""
        trace: Trace = hooks.trace_from_json(text)
        return trace


def record(a: Shape, b: Shape, *, axes: Chooser | Choice | Shortcut = needed, every_axis: bool = False) -> Trace:
    """Run the loop and keep everything: a Trace whose relation is exact.

    `axes`: a choice of axes (satviz.axes), by default the smallest complete set; with
    it, concave polygons are tested part by part.  Or a shortcut, whose `claim` the
    trace then holds beside the exact relation.  The loop stops at the first
    separating axis, and for parts at the first pair that overlaps, unless
    `every_axis`.  TypeError for anything but Polygon and Circle and for no choice of axes; ValueError
    for axes of other shapes; InvalidScene if the trace would list more than MAX_SIZE points and axes, or
    where what a shortcut does in plain floats overflows.
    """
    checked(a, "a"), checked(b, "b")
    every_axis = bool(every_axis)
    if axes is needed and not (a.is_convex and b.is_convex):
        return _record_parts(a, b, every_axis)
    if type(axes) is Shortcut:  # one with methods of its own would compare equal to what it is not
        return _record_shortcut(a, b, axes, every_axis)
    if not (isinstance(axes, Choice) or callable(axes)):
        raise TypeError(f"axes is a {type(axes).__name__}: expected a choice of axes, or what makes one (satviz.axes)")
    choice = axes if isinstance(axes, Choice) else axes(a, b)
    own = any(axes is choose for choose in NAMED.values())
    return _record(a, b, choice if own else validate_choice(choice, a, b), every_axis, PLAIN)


def _record_shortcut(a: Shape, b: Shape, shortcut: Shortcut, every_axis: bool) -> Trace:
    pieces = shortcut.pieces(a)
    if pieces is None:
        return _record(a, b, shortcut.choose(a, b), every_axis, PLAIN, shortcut)
    return _record_pairs(a, b, [(p, f"A{i}") for i, p in enumerate(pieces, 1)], [(b, "B")], every_axis, shortcut)


def _record(
    a: Shape, b: Shape, choice: Choice, every_axis: bool, names: Names, shortcut: Shortcut | None = None
) -> Trace:
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
    return _record_pairs(a, b, named_parts(a, "A"), named_parts(b, "B"), every_axis)


def _record_pairs(
    a: Shape, b: Shape, of_a: NamedParts, of_b: NamedParts, every_axis: bool, shortcut: Shortcut | None = None
) -> Trace:
    """A trace for each pair of parts; a shortcut looks at all of them, and proves nothing by it."""
    pairs, size = [], 0
    for (p, name_a), (q, name_b) in product(of_a, of_b):
        pair = _record(p, q, needed(p, q), every_axis, Names(name_a, name_b))
        pairs.append(pair)
        size += _count_listed(p, q, pair.choice, pair.tests)
        if size > MAX_SIZE:
            raise _too_large_error(
                f"A and B have {len(of_a) * len(of_b):,} pairs of {'pieces' if shortcut else 'convex parts'}"
            )
        if not shortcut and pair.relation is OVERLAPPING and not every_axis:
            break
    return Trace(a, b, Choice((), complete=not shortcut), (), every_axis, tuple(pairs), PLAIN, shortcut)


def _separates(test: AxisTest) -> bool:
    return test.gap > 0


def _least_overlap(tests: Sequence[AxisTest]) -> AxisTest:
    return max(tests, key=lambda test: test.gap)


def _count_listed(a: Shape, b: Shape, choice: Choice, tests: Sequence[AxisTest]) -> int:
    """What a trace lists: points, those dropped in each test too, and axes."""
    return _count_points(a, b) * (1 + len(tests)) + len(choice.axes) + len(choice.skipped)


def _check_size(a: Shape, b: Shape, choice: Choice, tests: Sequence[AxisTest], names: Names) -> None:
    if _count_listed(a, b, choice, tests) > MAX_SIZE:
        raise _too_large_error(
            f"{' and '.join(names)} have {_count_points(a, b):,} points to drop on {len(choice.axes):,} axes"
        )


def _count_points(a: Shape, b: Shape) -> int:
    return sum(2 if shape.core_is_point else len(shape.vertices) for shape in (a, b))


def _too_large_error(what: str) -> InvalidScene:
    """Work and memory stay bounded: the loop ends where its trace outgrows the limit."""
    return InvalidScene(
        f"{what}: a trace lists {MAX_SIZE:,} points and axes at most; ask relate for the verdict alone, "
        "choose fewer axes (world), or simplify the shapes"
    )
