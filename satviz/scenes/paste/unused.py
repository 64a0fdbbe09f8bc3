"""What no shape has of a text: numbers, with the key or the call before them, and what is not understood."""

import re
from bisect import bisect_left, bisect_right
from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import groupby, pairwise, takewhile
from typing import Any, NamedTuple

from .account import Account, within
from .boxes import Read
from .harmless import words
from .names import Names, Obj, short
from .notations import POINT, SHAPE_STEMS, notation
from .parser import Tree
from .tokens import NAME, NUMBER
from .tree import Bad, Group, Num, Pair

MAX_NAMED = 6  # keys that are named in a line, and numbers without a key

# Words in a key, or in the name of a call, that change a shape.
CHANGING = """
    scale scaling zoom offset transform transform2d matrix mat3 affine origin originx originy anchor pivot skew shear
    flip mirror rotate rotation rot angle orientation degrees radians translate translation position pos move shift
    displacement center centre radius diameter skin margin rounding roundness rx ry size extents width height holes
    interiors thickness buffer inflate grow shrink pad padding unit units ratio factor ppm isometry pose sides
"""
# Words in a key, or in the name of a call, that say that the numbers are none of a shape.
HARMLESS = """
    velocity speed axes force torque gravity mass inertia density friction restitution color colour fill stroke
    alpha opacity window canvas screen viewport viewbox svg area count length index id label layer category mask group
    time timestamp step size_t sleep stiffness damping damp slop constraint render print printf println log assert
    prev previous impulse motion tolerance epsilon eps expected distance camera image version line error warn info
    background strokeweight fps framerate
    type srid iscrowd score ts bbox rows capacity make satviz contact vx vy vz fixture moment
    linewidth zindex
"""
CHANGING_WORDS, HARMLESS_WORDS = frozenset(CHANGING.split()), frozenset(HARMLESS.split())


class Left(NamedTuple):
    """A number that stands in no shape: where it begins and ends, and the key or the call before it."""

    start: int
    end: int
    key: str
    value: Fraction | None


class Rest(NamedTuple):
    """What no shape has: numbers and other parts that are not understood, and numbers that are known to be harmless."""

    missed: list[str]
    harmless: str


def rest(tree: Tree, reads: Sequence[Read], text: str, reader: Names) -> Rest:
    """Return what no shape has of a text."""
    used = frozenset().union(*(read.used for read in reads)) | tree.indices | reader.counts
    known = {left.end: left for left in _walk(tree, tree.root, "")}
    before = {b.end: a.text for a, b in pairwise(tree.tokens) if a.kind == NAME and b.kind == NUMBER}
    for token in tree.numbers:
        known.setdefault(token.end, Left(token.start, token.end, before.get(token.end, ""), token.value))
    left = sorted((v for v in known.values() if v.end not in used), key=lambda v: v.start)
    places = sorted(used - tree.indices)
    variables = {str(name) for name, value in reader.env.fields.items() if _holds(places, value)}
    objects = {str(name): value for name, value in reader.env.fields.items() if isinstance(value, Obj)}
    changed = {name for name, value in objects.items() if any(_holds(places, v) for v in value.rest)}
    account = Account(text, tree.tokens, places, variables, [*tree.parts, *reader.parts], changed)
    parts = account.run()
    quoted = within(reader.named, parts)
    parts = [part for part in parts if part not in quoted]
    inside = within([*reader.named, *parts, *reader.parts], left)
    left = [v for v in left if v not in inside and v.end not in account.counts]
    harmless: list[Left] = []
    missed = [(part.start, short(text[part.start : part.end])) for part in parts]
    for _, group in groupby(left, key=_base):
        row = list(group)
        if all(map(_is_harmless, row)):
            harmless += row
        else:
            missed.append((row[0].start, _named(row, text)))
    return Rest([said for _, said in sorted(missed)], _named(harmless, text) if harmless else "")


def _holds(places: Sequence[int], value: Any) -> bool:
    """Return whether one of these places lies within a value."""
    if isinstance(value, Obj):
        return any(_holds(places, v) for v in (*value.fields.values(), *value.rest))
    at = bisect_right(places, value.start)
    return at < len(places) and places[at] <= value.end


def _walk(tree: Tree, value: Any, name: str) -> Iterator[Left]:
    """Yield every number of a tree with the key or the call before it."""
    if isinstance(value, Num) and value.start < value.end:
        yield Left(value.start, value.end, name, value.value)
    elif isinstance(value, Pair):
        path = ".".join(str(part) for part in value.path if isinstance(part, str))
        yield from _walk(tree, value.value, f"{name}.{path}" if name and path else path or name)
    elif isinstance(value, Bad):
        for inner in value.inside:
            yield from _walk(tree, inner, name)
        if not value.inside:  # an expression: Math.PI / 4
            first = bisect_left(tree.numbers, value.start, key=lambda token: token.start)
            for token in takewhile(lambda token: token.end <= value.end, tree.numbers[first:]):
                yield Left(token.start, token.end, name, None)
    elif isinstance(value, Group):
        row = notation(value.name) if value.name else None
        inside = value.name if value.name and not (row and row.kind == POINT) else name
        for inner in value.items:
            yield from _walk(tree, inner, inside)
        for method, arguments in value.methods:
            yield from _walk(tree, arguments, method)


def _is_harmless(left: Left) -> bool:
    """Return whether a number that no shape has changes none, by its key: a mass, or a scale of 1."""
    said, last = words(left.key.removeprefix("svg.")), words(left.key.split(".")[-1])
    if "moment" in said or left.key == "pymunk.Body" or "bounds" in left.key.split("."):
        return True
    if any(word.startswith(SHAPE_STEMS) for word in last) and not last & CHANGING_WORDS:
        return False
    same = left.value == (1 if any("scal" in word or word == "zoom" for word in said) else 0)
    return bool(said & HARMLESS_WORDS) or (same and bool(said & CHANGING_WORDS))


def _base(left: Left) -> str:
    """Return the key of a number without a last x or y."""
    return re.sub(r"\.[xyzXYZ]$", "", left.key)


def _named(lefts: Sequence[Left], text: str) -> str:
    """Return numbers with their keys, shortened: scaleX 2, offset 5, 0 and 3 more."""
    parts = []
    for name, group in groupby(lefts, key=_base):
        row = list(group)
        name = name if len(row) > 1 else row[0].key
        numbers = [text[left.start : left.end][:20] for left in row]
        parts += [f"{name[:40]} {', '.join(numbers[:MAX_NAMED])}"] if name else numbers
    more = f" and {len(parts) - MAX_NAMED} more" if len(parts) > MAX_NAMED else ""
    return f"{', '.join(parts[:MAX_NAMED])}{more}"
