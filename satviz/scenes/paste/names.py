"""What a text gives a name: lines as assignments, names as values, groups of pairs as objects."""

import re
from bisect import bisect_right
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any

from .notations import Kind, key, notation
from .tree import Bad, Group, Name, Num, Pair, Value, parts_of

_ZERO = re.compile(r"(?:\.|::)zero$|^cpvzero$|^b2Vec2_zero$", re.IGNORECASE)


class Unreadable(Exception):
    """Raised for what looks like a shape but has a part that is not a number."""


@dataclass(slots=True)
class Obj(Value):
    """An object: its fields, and values without a key."""

    fields: dict[str | int, Any] = field(default_factory=dict)
    rest: list[Any] = field(default_factory=list)
    twice: str = ""  # a key that is given twice
    earlier: dict[str | int, list[Any]] = field(default_factory=dict)  # the values that a name had before

    def before(self, name: str, place: int) -> Any:
        """Return the last value that a name was given before an offset in the text; None if there is none."""
        last, earlier = self.fields.get(name), self.earlier.get(name, [])
        if last is not None and last.start <= place and not _holds(last, place):
            return last
        begun = bisect_right(earlier, place, key=lambda v: v.start)
        return next((v for v in reversed(earlier[:begun]) if not _holds(v, place)), None)

    def get(self, *meanings: str) -> Any:
        """Return the value of the first key with one of these meanings, or None."""
        for meaning in meanings:
            for name, value in self.fields.items():
                if key(name) == meaning:
                    return value
        return None


class Names:
    """The variables of a text, and what stands alone in it."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.env = Obj(0, len(text))
        self.loose: list[Any] = []  # values without a name
        self.used: set[int] = set()  # values that another one refers to by name
        self.remarks: list[str] = []
        self.problems: list[str] = []  # lines on parts that could not be read
        self.parts: list[tuple[int, int]] = []  # spans of a known form, such as: from 0 to 2 * pi
        self.named: list[tuple[int, int]] = []  # spans that a problem quotes
        self.thirds: set[Fraction] = set()  # third coordinates, which were left out
        self.counts: set[int] = set()  # the places where an index ends: v[0].Set(1, 2)

    def _insert(self, pair: Pair) -> None:
        """Store a value under its path; a variable that is declared again keeps its earlier value as another shape."""
        node = self.env
        lengths, sizes = pair.path[1:], tuple(_sizes(pair.value))
        if pair.before and lengths and lengths in (sizes[: len(lengths)], sizes[-len(lengths) :]):
            pair = replace(pair, path=pair.path[:1])  # double xs[3] = {0, 4, 4}, float a[][2] = {{0, 0}, {4, 0}}
        for part in pair.path[:-1]:
            child = node.fields.get(part)
            if not isinstance(child, Obj):
                child = Obj(pair.start, pair.end, rest=[] if child is None else [child])
                node.fields[part] = child
            node = child
            node.start, node.end = min(node.start, pair.start), max(node.end, pair.end)
        last = pair.path[-1]
        if last in node.fields:
            old = node.fields.pop(last)
            node.fields[f"{last} ({len(node.fields)})"] = old
            node.earlier.setdefault(last, []).append(old)
        value = pair.value
        declared = notation(pair.before) if pair.before and isinstance(value, Group) and not value.name else None
        if (
            declared and declared.kind in (Kind.BOX, Kind.CIRCLE, Kind.OTHER_SHAPE) and value.bracket in "({"
        ):  # Rect r = {0, 0, 1, 1}
            value = replace(value, name=pair.before)
        if isinstance(value, Bad) and value.inside:
            value = Group(value.start, value.end, value.inside, "words")
        node.fields[last] = value

    def resolve(self, value: Any) -> Any:
        """Return what an assigned name stands for, the value of `key: value`, (0, 0) for names such as Vec2.ZERO.

        Anything else is returned as it is.
        """
        for _ in range(8):
            if not isinstance(value, Name):
                break
            node: Any = self.env
            for part in parts_of(value.text):
                if isinstance(node, Group) and any(isinstance(item, Pair) for item in node.items):
                    node = self.as_object(node).get(key(part)) if key(part) else None
                else:
                    node = node.before(part, value.start) if isinstance(node, Obj) else None
            if node is None:
                break
            value = node
        if isinstance(value, Pair):
            return value.value
        if isinstance(value, Name) and _ZERO.search(value.text):
            nothing = Num(value.end, value.end, Fraction(0))
            return Group(value.start, value.end, [nothing, nothing], "(")
        return value

    def consume(self, items: Sequence[Any]) -> None:
        """Note that the values of these names belong to a shape, so that they are not shapes of their own."""
        self.used |= {id(self.resolve(item)) for item in items if isinstance(item, Name)}

    def as_object(self, group: Group) -> Obj:
        """Return a group as an object: pairs become fields (the first of equal keys), other items `rest`."""
        made = Obj(group.start, group.end)
        for item in group.items:
            if isinstance(item, Pair):
                name = item.path[0] if len(item.path) == 1 else ".".join(map(str, item.path))
                if name in made.fields:
                    made.twice = str(name)
                made.fields.setdefault(name, item.value)
            elif item is not None:
                made.rest.append(item)
        return made

    def remark(self, text: str) -> None:
        """Note something about the reading, once."""
        if text not in self.remarks:
            self.remarks.append(text)


def _sizes(value: Any) -> Iterator[int]:
    """Yield how many items a list has, its first item, and so on."""
    while isinstance(value, Group) and value.items:
        yield len(value.items)
        value = value.items[0]


def _holds(value: Any, place: int) -> bool:
    """Return whether a place in the text lies within a value; a name at that place cannot stand for the value."""
    if isinstance(value, Obj):
        return any(_holds(v, place) for v in (*value.fields.values(), *value.rest))
    return bool(value.start <= place < value.end)


def is_block(group: Group) -> bool:
    """Return whether braces hold statements and not the fields of one object."""
    if group.ended and any(isinstance(item, Group) and item.name for item in group.items):
        return True
    pairs = [item for item in group.items if isinstance(item, Pair)]
    if any(len(item.path) > 1 and isinstance(item.path[0], str) for item in pairs):
        return True
    statements = any(isinstance(item, (Bad, Group)) for item in group.items)
    said = pairs or any(isinstance(item, Bad) for item in group.items)
    return bool(said) and statements and group.bracket == "{"


def short(text: str) -> str:
    """Return a part of the text in one line, shortened."""
    one = " ".join(text.split())
    return one if len(one) <= 60 else f"{one[:60]}..."
