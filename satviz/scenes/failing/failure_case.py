"""The record of a failing case: all that satviz knows about one common mistake."""

from collections.abc import Callable, Sequence
from math import hypot, isnan, nan
from typing import Any, NamedTuple

from ...engine import describe, number_format
from ...engine.geometry import InvalidShape, Relation, relation_of_gap
from ...engine.number_format import USUAL_DIGITS, Digits
from ...engine.shapes import Polygon, Shape
from ...engine.shortcut import Shortcut
from ...engine.trace import Trace, record
from . import true_value
from .move_space import RegionOrReason, Window
from .true_value import Answer

FALSE_HIT, MISSED_HIT, WRONG_NUMBER, REFUSED = "false hit", "missed hit", "wrong number", "refused input"

RawOutline = Sequence[tuple[float, float]]  # vertices that are not validated


class Panels(NamedTuple):
    """The names of the two panels that draw a case; `PANELS` in satviz/pictures/comparison_panels.py draws them.

    By default the left panel shows what the shortcut measured, and the right one what proves the truth.
    """

    claimed: str = "tests"
    actual: str = "proof"


def largest_gap(trace: Trace) -> float:
    """Return the largest gap that the run measured; NaN if it has no axis."""
    return max((test.gap for test in trace.tests), default=nan)


def push_length(trace: Trace) -> float:
    """Return the length of the run's push of B; NaN if it makes no push."""
    return hypot(*(trace.push or (nan, nan)))


class FailureCase(NamedTuple):
    """A shortcut, the smallest shapes on which it fails, and what computes both answers.

    `shortcut`: the claim as people say it, and the one step that is done wrongly.
    `how`: the way in which it fails, one of FALSE_HIT, MISSED_HIT, WRONG_NUMBER and REFUSED.
    `outlines`: the shapes A and B, or the raw vertices of outlines that the engine refuses.
    `quantity`: what both answers measure, such as "gap" or "depth".
    `claimed_value`: reads the shortcut's answer off its own run.
    `true_value`: the right answer by the engine.
    `unchecked_value`: for refused outlines, the answer of a program that does not check its input;
    `unchecked_words`: what it makes of it, in which {} stands for the answer.
    `claims_less`: the claim is that its number is smaller than the true one, not that it is equal.
    `is_about_push`: the number depends on where the shortcut pushes B.
    `error_region`: the moves of B for which the answer is wrong, or the reason why no area shows them;
    None for a verdict that follows from the shortcut's axes alone.
    `panels`: how it is drawn; `verdicts`: the words above both panels, if the case is not about the relation.
    `direction_name`: the label of an axis that the shortcut gives as a direction, in which {} stands for its vector.
    `number`: the place in the list of all cases, counted by satviz/scenes/failing/__init__.py.
    """

    shortcut: Shortcut
    how: str
    outlines: tuple[Shape | RawOutline, Shape | RawOutline]
    quantity: str = "gap"
    claimed_value: Callable[[Trace], float] = largest_gap
    true_value: Callable[[Shape, Shape], Answer] = true_value.gap
    unchecked_value: Callable[[RawOutline, RawOutline], float] | None = None
    unchecked_words: str = "{}"
    claims_less: bool = False
    is_about_push: bool = False
    error_region: Callable[[Shape, Shape, Window], RegionOrReason] | None = None
    panels: Panels = Panels()
    verdicts: tuple[str, str] | None = None
    direction_name: str = "{}"
    number: int = 0

    @property
    def name(self) -> str:
        """Return the scene's name, which is the shortcut's."""
        return self.shortcut.name

    @property
    def claim(self) -> str:
        """Return the mistaken rule in words, as people say it."""
        return self.shortcut.claim

    @property
    def a(self) -> Shape | RawOutline:
        """Return shape A, or its raw vertices if the engine refuses the outline."""
        return self.outlines[0]

    @property
    def b(self) -> Shape | RawOutline:
        """Return shape B, or its raw vertices if the engine refuses the outline."""
        return self.outlines[1]

    @property
    def shapes(self) -> tuple[Shape, Shape]:
        """Return both shapes; InvalidShape where the engine refuses an outline."""
        a, b = (s if isinstance(s, Shape) else Polygon(s) for s in self.outlines)
        return a, b

    @property
    def raw_outlines(self) -> list[RawOutline]:
        """Return the vertices of those outlines that were not validated; an empty list if both are Shapes."""
        return [outline for outline in self.outlines if not isinstance(outline, Shape)]

    def record(self) -> Trace:
        """Return the shortcut's run on the shapes; InvalidShape where the engine refuses an outline."""
        return record(*self.shapes, axes=self.shortcut)

    @property
    def claimed(self) -> float:
        """Return the wrong answer: the number that the shortcut computes for these shapes."""
        if self.unchecked_value:
            return self.unchecked_value(*self.raw_outlines)
        return self.claimed_value(self.record())

    @property
    def actual(self) -> Answer:
        """Return the engine's answer: a number, two contact times, or the error that refuses an outline."""
        try:
            return self.true_value(*self.shapes)
        except InvalidShape as error:
            return str(error)

    def in_words(self, answer: Answer, digits: Digits = USUAL_DIGITS) -> str:
        """Return an answer in words: "gap +0.424", "overlap 1.5", "depth 2"; `digits`: the number format of lengths."""
        if isinstance(answer, str):
            return f"refused ({answer})"
        if isinstance(answer, tuple):
            if isnan(answer[0]):
                return "no contact"
            return "contact from {:g} to {:g} of the way".format(*map(float, answer))
        if isnan(answer):
            return f"{self.quantity} none"
        if self.quantity == "gap":
            return describe.gap_in_words(answer, digits)
        is_length = answer and not self.quantity.endswith(":")
        if not is_length and answer == int(answer):
            return f"{self.quantity} {answer:,.0f}"
        return f"{self.quantity} {digits.number(answer) if is_length else number_format.number(answer)}"

    def verdict_in_words(self, relation: Relation, answer: Answer, digits: Digits = USUAL_DIGITS) -> str:
        """Return the relation and the answer in words, such as "overlapping, depth 1"; of a gap only its own words.

        A gap's words already say the relation.  Where its sign contradicts `relation`, the relation stands before it.
        """
        words = self.in_words(answer, digits)
        if not isinstance(answer, float | int) or self.quantity != "gap":
            return f"{relation}, {words}"
        return words if relation_of_gap(answer) is relation else f"{relation}, {words.removeprefix('touching, ')}"

    @property
    def answers(self) -> tuple[str, str]:
        """Return (claimed answer, actual answer) in words."""
        claimed, actual = self.in_words(self.claimed), self.in_words(self.actual)
        if self.how in (FALSE_HIT, MISSED_HIT) and not isinstance(self.actual, tuple):
            trace = self.record()
            actual = self.verdict_in_words(trace.relation, self.actual)
            if self.how == MISSED_HIT and self.actual and trace.truth.tests:  # as the picture of the true axis says it
                actual = describe.outcome(max(trace.truth.tests, key=lambda test: test.gap), USUAL_DIGITS)
            return self.verdict_in_words(trace.claim, self.claimed), actual
        return claimed, actual

    def __str__(self) -> str:
        """Return two lines: number, name and claim, then the way in which it fails and both answers."""
        claimed, actual = self.answers
        numbers = number_format.ascii_minus(f"{claimed}; right: {actual}")
        return f"{self.number:2} {self.name:21} {self.claim}\n   {self.how}: {numbers}"


# the fields of a case whose shortcut pushes B by a wrong depth
DEPTH: dict[str, Any] = {
    "quantity": "depth", "claimed_value": push_length, "true_value": true_value.depth, "is_about_push": True
}  # fmt: skip
