"""The parts between two separators, before they are one value: what each of them is."""

import re
from collections.abc import Sequence
from typing import Any

from .tokens import MARK, NAME, OTHER, Token, number
from .tree import Group, Name, Num

NUMERAL = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")
IGNORED_NAMES = frozenset(  # words of a language before a value
    [
        "new",
        "const",
        "constexpr",
        "let",
        "var",
        "val",
        "auto",
        "mut",
        "final",
        "static",
        "return",
        "ref",
        "in",
        "out",
        "pub",
        "private",
        "public",
        "readonly",
        "local",
        "struct",
        "boxed",
        "await",
        "export",
        "default",
        "def",
        "type",
        "with",
    ]
)
OPERATORS = frozenset("+-*/%^\u2212")


def is_mark(atom: Any, texts: tuple[str, ...]) -> bool:
    """Return whether an atom is one of these marks."""
    return isinstance(atom, Token) and atom.kind == MARK and atom.text in texts


def text_value(atom: Token) -> Num | Name:
    """Return a text in quotes: a number that is written as text, or a name."""
    inner = atom.text[1:-1].strip()
    if NUMERAL.fullmatch(inner):
        return Num(atom.start, atom.end, *number(inner))
    return Name(atom.start, atom.end, atom.text[1:-1])


def is_pair(value: Any) -> bool:
    """Return whether a value is a bracket with two numbers and no name."""
    plain = isinstance(value, Group) and value.bracket == "(" and not value.name and len(value.items) == 2
    return plain and all(isinstance(v, Num) for v in value.items)


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
    """Return whether a group is a type in brackets."""
    return group.bracket == "(" and not group.name and len(group.items) == 1 and isinstance(group.items[0], Name)


def says_nothing(atom: Any) -> bool:
    """Return whether an atom before a value is a word such as `new`, a reference, or a bullet."""
    return isinstance(atom, Token) and (atom.text in IGNORED_NAMES or atom.text in ("&", "*", "|", ">", "@", "\u2022"))


def is_operator(atom: Any) -> bool:
    """Return whether an atom is an operator of arithmetic."""
    return isinstance(atom, Token) and atom.kind == OTHER and atom.text in OPERATORS


def is_open(atom: Any) -> bool:
    """Return whether an atom is a bracket with its items."""
    return isinstance(atom, Group) and atom.bracket in ("(", "[", "{") and not atom.name


def start_of(atom: Any) -> int:
    """Return where an atom begins."""
    found: int = atom.start
    return found


def end_of(atom: Any) -> int:
    """Return where an atom ends."""
    found: int = atom.end
    return found
