"""The result of one pair: the outcome of the call, the answer as a value, and whether it is right."""

from typing import Any, NamedTuple

from ..engine.shapes import Shape
from .answers import Answer, Rules, Truth, UnreadableAnswer, is_right, read, truth_of
from .asking import Outcome
from .pairs import CheckPair

UNREADABLE, WRONG, UNSTEADY = "unreadable", "wrong", "unsteady"
NOTHING = "returns nothing: every way through the function must end in a return"


class Result(NamedTuple):
    """One pair, the answer of the function, and whether it is right; `problem` and `line` where it gave no answer."""

    pair: CheckPair
    raw: Any
    answer: Answer
    truth: Truth
    right: bool
    problem: str = ""
    line: str = ""

    @property
    def a(self) -> Shape:
        """Return shape A."""
        return self.pair.a

    @property
    def b(self) -> Shape:
        """Return shape B."""
        return self.pair.b


def judge(pair: CheckPair, outcome: Outcome, rules: Rules) -> Result:
    """Return the Result of a call: its value read as an answer and compared with the truth by the rules."""
    truth = truth_of(pair.a, pair.b, rules.returns)
    if outcome.problem:
        return Result(pair, outcome.value, None, truth, False, outcome.problem, outcome.line)
    try:
        answer = read(outcome.value, rules.returns)
    except UnreadableAnswer as error:
        line = NOTHING if outcome.value is None else str(error)
        return Result(pair, outcome.value, None, truth, False, UNREADABLE, line)
    return Result(pair, outcome.value, answer, truth, is_right(answer, pair.a, pair.b, truth, rules))
