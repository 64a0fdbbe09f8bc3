"""A row: a scene, what is believed about it, what that gives, and what satviz says."""

from collections.abc import Callable
from typing import NamedTuple

from ...engine import digits
from ...engine.geometry import InvalidScene, InvalidShape
from ...engine.shapes import Shape
from ..scenefile import Scene
from .right import Answer, gap
from .shortcuts import Outline, Shortcut, as_shape

FALSE_HIT, MISSED_HIT, WRONG_NUMBER, REFUSED = "false hit", "missed hit", "wrong number", "refused input"


class Row(NamedTuple):
    """One way to be wrong.

    `claim`: what is believed; `how` it fails (one of the four above); `what` both numbers
    are ("gap", "depth", ...); `a`, `b`: the shapes, or plain vertices of one the engine
    refuses; `axes`: the choice in satviz.axes.NAMED that is this shortcut, if one is.
    """

    number: int
    name: str
    claim: str
    how: str
    what: str
    a: Outline
    b: Outline
    shortcut: Shortcut
    right: Callable[[Shape, Shape], Answer] = gap
    axes: str = ""

    @property
    def scene(self) -> Scene:
        """The scene as any other; InvalidScene says why where an outline is refused."""
        try:
            a, b = as_shape(self.a), as_shape(self.b)
        except InvalidShape as error:
            raise InvalidScene(f"{self.name} is no scene: {error}") from None
        return Scene(self.name, a, b, every_axis=True, title=self.claim)

    @property
    def wrong(self) -> float:
        """The number the shortcut gives."""
        return self.shortcut(self.a, self.b)

    @property
    def truth(self) -> Answer:
        """What satviz says: a number, two numbers, or the refusal."""
        try:
            return self.right(as_shape(self.a), as_shape(self.b))
        except InvalidShape as error:
            return str(error)

    def told(self, answer: Answer) -> str:
        """An answer in words: "gap +0.424"."""
        if isinstance(answer, str):
            return f"refused ({answer})"
        if isinstance(answer, tuple):
            return "contact from {:g} to {:g} of the way".format(*map(float, answer))
        return f"{self.what} {digits.signed(answer) if self.what == 'gap' else digits.number(answer)}"

    def __str__(self) -> str:
        numbers = digits.plain(f"{self.told(self.wrong)}; right: {self.told(self.truth)}")
        return f"{self.number:2} {self.name:21} {self.claim}\n   {self.how}: {numbers}"
