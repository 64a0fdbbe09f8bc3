"""The values of a text: numbers, names, pairs and groups, and what is not evaluated."""

from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any


@dataclass(slots=True)
class Value:
    """A part of the text: where it begins and ends."""

    start: int
    end: int


@dataclass(slots=True)
class Num(Value):
    """A number; `value` is None where it cannot be taken, and `why` says why."""

    value: Fraction | None
    why: str = ""
    turn: Fraction | None = None  # the degrees of an angle in terms of pi, such as Math.PI / 4


@dataclass(slots=True)
class Name(Value):
    """A name that stands alone."""

    text: str


@dataclass(slots=True)
class Bad(Value):
    """What is not evaluated (`why`); `inside`: values in it that stand for themselves, such as lists amid words."""

    why: str
    inside: list[Any] = field(default_factory=list)
    hides: bool = False  # an expression with a list of numbers in it: `np.array([...]) * 2`


@dataclass(slots=True)
class Pair(Value):
    """`key = value` or `key: value`; the key is a path, such as ("poly", "verts", 0)."""

    path: tuple[str | int, ...]
    value: Any
    before: str = ""  # the word before the key, such as the type in `Rect r = {0, 0, 1, 1}`
    number: str = ""  # a number after the key: Vertex 0: (1, 2)


@dataclass(slots=True)
class Group(Value):
    """What stands in a bracket, or side by side: its items.  With a name before it, it is a call or a typed list."""

    items: list[Any]
    bracket: str = ""
    name: str = ""
    methods: list[tuple[str, "Group"]] = field(default_factory=list)  # chained calls: .rotate(45)
    before: str = ""  # the word before its name, such as the type in `Circle c(0, 0, 1)`
    ended: bool = False  # by semicolons, as statements are


def parts_of(name: str) -> list[str]:
    """Return the parts of a name with dots, arrows or colons: this and x of this.x, this->x and this::x."""
    return name.replace("->", ".").replace("::", ".").split(".")
