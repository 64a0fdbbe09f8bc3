"""The parts between two separators, before they are one value: what each of them is."""

import re
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from .harmless import listed
from .tokens import MARK, NAME, NUMERAL, OTHER, Token, number
from .tree import Group, Name, Num

# words of a language before a value
IGNORED_NAMES = listed(
    """
    new const constexpr let var val auto mut final static return ref in out pub
    private public readonly local struct boxed await export default def type with
    """
)
# An angle in terms of pi: its names are a closed list, and nothing else is worked out.
_PI = r"(?:(?:[Mm]ath[fF]?|np|numpy|std::f(?:64|32)::consts)(?:\.|::))?(?:PI|pi|Pi)|M_PI|b2_pi|\u03c0"
_ANGLE = re.compile(
    rf"(?P<sign>-?)\s*(?:(?P<times>[0-9]+\.?[0-9]*|\.[0-9]+)f?\s*\*\s*)?(?:{_PI})"
    r"(?:\s*(?P<by>[*/])\s*(?P<number>[0-9]+\.?[0-9]*|\.[0-9]+)f?)?"
)
OPERATORS = frozenset("+-*/%^\u2212")


def angle(text: str) -> Fraction | None:
    """Return the degrees of an angle in terms of pi, such as Math.PI / 4; None for anything else."""
    found = _ANGLE.fullmatch(text)
    if found is None:
        return None
    degrees = 180 * Fraction(found["times"] or 1)
    number = Fraction(found["number"] or 1)
    if not number:
        return None
    return (-1 if found["sign"] else 1) * (degrees * number if found["by"] == "*" else degrees / number)


def is_mark(atom: Any, texts: tuple[str, ...]) -> bool:
    """Return whether an atom is one of these marks."""
    return isinstance(atom, Token) and atom.kind == MARK and atom.text in texts


def is_numeral(atom: Token) -> bool:
    """Return whether a text in quotes is a number."""
    return re.fullmatch(NUMERAL, atom.text[1:-1].strip()) is not None


def text_value(atom: Token) -> Num | Name:
    """Return a text in quotes: a number that is written as text, or a name."""
    inner = atom.text[1:-1].strip()
    if is_numeral(atom):
        return Num(atom.start, atom.end, *number(inner))
    return Name(atom.start, atom.end, atom.text[1:-1])


def holds_numbers(group: Group) -> bool:
    """Return whether all items of a group are numbers; the group may have a name."""
    return all(isinstance(v, Num) for v in group.items)


def is_pair(value: Any) -> bool:
    """Return whether a value is a group of two numbers, such as (1, 2) or Vec2(1, 2)."""
    return isinstance(value, Group) and len(value.items) == 2 and holds_numbers(value)


def is_long(value: Any) -> bool:
    """Return whether a value is a bracket with a list of numbers or of brackets in it."""
    if not isinstance(value, Group):
        return False
    return sum(isinstance(v, (Num, Group)) for v in value.items) > 2 or any(map(is_long, value.items))


def is_hyphen(atoms: Sequence[Any], i: int) -> bool:
    """Return whether an atom is a hyphen within a name."""
    before, at, after = atoms[i - 1 : i + 2]
    hyphen = isinstance(at, Token) and at.text == "-" and isinstance(before, Token) and before.kind == NAME
    return hyphen and end_of(before) == at.start and at.end == start_of(after)


def is_cast(group: Group) -> bool:
    """Return whether a group is a type in brackets, with no call after it."""
    plain = group.bracket == "(" and not group.name and not group.methods
    return plain and len(group.items) == 1 and isinstance(group.items[0], Name)


def says_nothing(atom: Any) -> bool:
    """Return whether an atom before a value is a word such as `new`, a reference, or a bullet."""
    return isinstance(atom, Token) and (atom.text in IGNORED_NAMES or atom.text in ("&", "*", "|", ">", "@", "\u2022"))


def is_operator(atom: Any) -> bool:
    """Return whether an atom is an operator of arithmetic."""
    return isinstance(atom, Token) and atom.kind == OTHER and atom.text in OPERATORS


def is_open(atom: Any) -> bool:
    """Return whether an atom is a group in (), [] or {} without a name before it."""
    return isinstance(atom, Group) and atom.bracket in ("(", "[", "{") and not atom.name


def start_of(atom: Any) -> int:
    """Return the place in the text where an atom begins."""
    found: int = atom.start
    return found


def end_of(atom: Any) -> int:
    """Return the place in the text where an atom ends."""
    found: int = atom.end
    return found
