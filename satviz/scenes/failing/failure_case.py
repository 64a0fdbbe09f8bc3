"""A row: a scene, the shortcut that fails on it, the number that the shortcut gives, and what satviz says."""

from collections.abc import Callable
from math import isnan, nan
from typing import NamedTuple

from ...engine import number_format
from ...engine.geometry import InvalidScene, InvalidShape
from ...engine.shapes import Polygon, Shape
from ...engine.shortcut import Shortcut
from ...engine.trace import Trace, record
from ..scenefile import Scene
from . import true_value
from .true_value import Answer
from .unchecked import Outline, Ring

FALSE_HIT, MISSED_HIT, WRONG_NUMBER, REFUSED = "false hit", "missed hit", "wrong number", "refused input"


def best_gap(trace: Trace) -> float:
    """The largest gap that the run measured; NaN if it has no axis."""
    return max((test.gap for test in trace.tests), default=nan)


class FailureCase(NamedTuple):
    """One way to be wrong.

    `how` it fails (one of the four above); `what` both numbers are ("gap", "depth", ...);
    `a`, `b`: the shapes, or plain vertices of one the engine refuses; `read`: the
    number in the shortcut's own run; `unchecked`: the same where the shapes are refused;
    `less`: is the claim that its number is the smaller one, and not that it is the right one?
    """

    number: int
    shortcut: Shortcut
    how: str
    what: str
    a: Outline
    b: Outline
    read: Callable[[Trace], float] = best_gap
    right: Callable[[Shape, Shape], Answer] = true_value.gap
    unchecked: Callable[[Ring, Ring], float] | None = None
    less: bool = False

    @property
    def name(self) -> str:
        """The scene's name, which is the shortcut's."""
        return self.shortcut.name

    @property
    def claim(self) -> str:
        """What is believed."""
        return self.shortcut.claim

    @property
    def shapes(self) -> tuple[Shape, Shape]:
        """Both as the engine takes them; InvalidShape where it refuses."""
        a, b = (s if isinstance(s, Shape) else Polygon(s) for s in (self.a, self.b))
        return a, b

    @property
    def scene(self) -> Scene:
        """The scene run by its shortcut; InvalidScene says why where an outline is refused."""
        try:
            a, b = self.shapes
        except InvalidShape as error:
            raise InvalidScene(f"{self.name} is no scene: {error}") from None
        return Scene(self.name, a, b, self.name, title=self.claim)

    @property
    def wrong(self) -> float:
        """The number the shortcut gives."""
        if self.unchecked and not isinstance(self.a, Shape) and not isinstance(self.b, Shape):
            return self.unchecked(self.a, self.b)
        return self.read(record(*self.shapes, axes=self.shortcut))

    @property
    def truth(self) -> Answer:
        """What satviz says: a number, two numbers, or the refusal."""
        try:
            return self.right(*self.shapes)
        except InvalidShape as error:
            return str(error)

    def told(self, answer: Answer) -> str:
        """An answer in words: "gap +0.424"."""
        if isinstance(answer, str):
            return f"refused ({answer})"
        if isinstance(answer, tuple):
            if isnan(answer[0]):
                return "no contact"
            return "contact from {:g} to {:g} of the way".format(*map(float, answer))
        if isnan(answer):
            return f"{self.what} none"
        return f"{self.what} {number_format.signed(answer) if self.what == 'gap' else number_format.number(answer)}"

    @property
    def answers(self) -> tuple[str, str]:
        """The wrong answer and the right one in words, with the verdict where that is what is wrong."""
        wrong, good = self.told(self.wrong), self.told(self.truth)
        if self.how in (FALSE_HIT, MISSED_HIT) and not isinstance(self.truth, tuple):
            trace = self.scene.record()
            return f"{trace.claim}, {wrong}", f"{trace.relation}, {good}"
        return wrong, good

    def __str__(self) -> str:
        wrong, good = self.answers
        numbers = number_format.plain(f"{wrong}; right: {good}")
        return f"{self.number:2} {self.name:21} {self.claim}\n   {self.how}: {numbers}"
