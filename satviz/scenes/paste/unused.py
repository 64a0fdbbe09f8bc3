"""What became of each number of a text: one that stands in no shape is named, with the key or the call before it."""

import re
from bisect import bisect_left, bisect_right
from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import accumulate, groupby, takewhile
from operator import itemgetter
from typing import Any, NamedTuple

from .boxes import Read
from .findings import Finding
from .notations import MOVE, POINT, SHAPE_WORDS, key, notation
from .parser import Tree
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
    velocity speed bounds axes force torque gravity mass inertia density friction restitution color colour fill stroke
    alpha opacity window canvas screen viewport viewbox svg area count length index id label layer category mask group
    time timestamp step size_t sleep stiffness damping damp slop constraint render print printf println log assert
    prev previous impulse motion tolerance epsilon eps expected distance camera image version line error warn info
    background strokeweight fps framerate
"""
CHANGING_WORDS, HARMLESS_WORDS = frozenset(CHANGING.split()), frozenset(HARMLESS.split())


class Left(NamedTuple):
    """A number that stands in no shape: where it begins and ends, and the key or the call before it."""

    start: int
    end: int
    key: str
    value: Fraction | None


def unused(tree: Tree, reads: Sequence[Read], text: str, named: Sequence[tuple[int, int]]) -> Iterator[Finding]:
    """Yield the findings about numbers of a text that no shape uses: not applied, or left out.

    `named`: (start, end) of the parts that other findings already call unread.
    """
    used = frozenset().union(*(read.used for read in reads)) | tree.indices
    known = {left.end: left for left in _walk(tree, tree.root, "")}
    for token in tree.numbers:
        known.setdefault(token.end, Left(token.start, token.end, "", token.value))
    unread = dict(_unread(tree, tree.root, used))
    spans = sorted(named)
    reach = list(accumulate((end for _, end in spans), max, initial=0))  # how far the first k parts reach
    unnamed = (v for v in known.values() if v.start >= reach[bisect_right(spans, v.start, key=itemgetter(0))])
    rest = sorted((left for left in unnamed if left.end not in used), key=lambda left: left.start)
    not_read = [left._replace(key=unread[left.end]) for left in rest if left.end in unread]
    read = [left for left in rest if left.end not in unread]
    changing: list[Left] = []
    others: list[Left] = []
    for _, group in groupby(read, key=_base):
        row = list(group)
        changes = any(_changes(left, any(r.start <= left.start < r.end for r in reads)) for left in row)
        (changing if changes else others).extend(row)
    if not_read:
        yield Finding("not-read", (), f"Not read: {_named(not_read, text)}.")
    if changing:
        yield Finding(
            "not-applied",
            (),
            f"Not applied to a shape: {_named(changing, text)}.",
            "Write the numbers that result; this answer is for the shapes without it.",
        )
    if others:
        yield Finding("left-out", (), f"Left out, since no shape has them: {_named(others, text)}.")


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


def _unread(tree: Tree, value: Any, used: frozenset[int]) -> Iterator[tuple[int, str]]:
    """Yield (end of a number, name) for each call that makes a shape of which no number was read."""
    if isinstance(value, Pair):
        yield from _unread(tree, value.value, used)
    elif isinstance(value, Bad):
        for inner in value.inside:
            yield from _unread(tree, inner, used)
    elif isinstance(value, Group):
        inside = [left.end for left in _walk(tree, value, "")]
        if SHAPE_WORDS.search(value.name) and inside and not used & frozenset(inside):
            yield from ((end, value.name) for end in inside)
            return
        for inner in (*value.items, *(arguments for _, arguments in value.methods)):
            yield from _unread(tree, inner, used)


def _words(name: str) -> frozenset[str]:
    """Return the words of a key, without case: rigidBody.maxSpeed has rigid, body, max, speed."""
    parts = re.split(r"[^A-Za-z0-9]+", name)
    camel = (word for part in parts for word in re.findall(r"[A-Z]?[a-z0-9]+|[A-Z]+(?![a-z])", part))
    return frozenset(word.lower() for word in (*parts, *camel))


def _changes(left: Left, inside: bool) -> bool:
    """Return whether a number that was left out would change a shape, by its key and its value.

    `inside`: the number stands in the text of a shape, where every key in the tables of `notations` would change it.
    """
    words = _words(left.key.removeprefix("svg."))
    same = left.value == (1 if any("scal" in word or word == "zoom" for word in words) else 0)
    known = {key(part.split(" ")[0]) for part in left.key.split(".") if len(part) > 1 or inside or part != left.key} - {
        ""
    }
    known -= set() if inside else {"points"}
    row = notation(left.key) if left.key else None
    moving = row is not None and row.kind == MOVE
    changes = bool(words & CHANGING_WORDS or moving) and not same
    return (changes or (bool(known) and (inside or not same))) and not words & HARMLESS_WORDS


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
