"""What no shape has of a text: numbers, with the key or the call before them, and what is not understood."""

import re
from bisect import bisect_left, bisect_right
from collections.abc import Collection, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import groupby, pairwise, takewhile
from typing import Any, NamedTuple

from .account import MOVERS, Account, Part, root, within
from .boxes import Read
from .harmless import CHANGING_CALLS, CHANGING_NUMBERS, OTHER_NUMBERS, words
from .names import Names, Obj, short
from .notations import SHAPE_STEMS, Kind, key, notation
from .parser import Tree
from .tokens import LENGTHS, NAME, NUMBER, Token
from .tree import Bad, Group, Name, Num, Pair

MIN_SAID = 12  # characters of a part that says enough without its line
MARKUP = re.compile(r"<(?:svg|rect|circle|polygon|ellipse)\b")
PLACED = frozenset(["center", "corner", "size", "offset"])
MAX_NAMED = 6  # keys that are named in a line, and numbers without a key


class Left(NamedTuple):
    """A number that stands in no shape: where it begins and ends, and the key or the call before it."""

    start: int
    end: int
    key: str
    value: Fraction | None


class Rest(NamedTuple):
    """The parts that no shape uses: those not understood, and, in one line, the numbers known to be harmless."""

    missed: list[str]
    harmless: str


def rest(tree: Tree, reads: Sequence[Read], text: str, reader: Names, *, session: bool) -> Rest:
    """Return the parts of a text that no shape uses; `session`: whether the text is a Python session, with results."""
    used = frozenset().union(*(read.used for read in reads)) | tree.indices | reader.counts
    known = {left.end: left for left in _walk(tree, tree.root, "")}
    before = {b.end: a.text for a, b in pairwise(tree.tokens) if a.kind == NAME and b.kind == NUMBER}
    for token in tree.numbers:
        known.setdefault(token.end, Left(token.start, token.end, before.get(token.end, ""), token.value))
    left = sorted((v for v in known.values() if v.end not in used), key=lambda v: v.start)
    places = sorted(used - tree.indices)
    named = [(root(path.split(" ")[0]), value) for path, value in _named_values(reader.env.fields)]
    names = dict(named)
    variables = {name: _size(value) for name, value in named if _holds(places, value)}
    variables |= {name: 0 for name, value in named if _is_made_of(variables, value)}
    labels = {read.label for read in reads if not (key(read.label) or words(read.label) & CHANGING_CALLS)}
    variables |= dict.fromkeys(labels - set(variables), 0)
    objects = ((name, value) for name, value in names.items() if isinstance(value, Obj))
    changed = {name for name, value in objects if any(_holds(places, v) for v in value.rest)}
    aliases = {
        name: said
        for name, value in names.items()
        if isinstance(said := getattr(value, "text", getattr(value, "name", "")), str)
    }
    shapes = [read.used - tree.indices for read in reads]
    understood = [*tree.parts, *reader.parts]
    account = Account(
        text, tree.tokens, shapes, variables, understood, changed, aliases, reader.counts, session=session
    )
    parts = account.run()
    quoted = within(reader.named, parts)
    parts = [part for part in parts if part not in quoted]
    inside = within([*reader.named, *parts, *reader.parts], left)
    left = [v for v in left if v not in inside and v.end not in account.counts]
    harmless: list[Left] = []
    missed = list(_missed_by_line(parts, text))
    missed += _without_unit(tree.numbers, used, text)
    missed += [(len(text), remark) for remark in tree.remarks if account.is_cut()]
    for _, group in groupby(left, key=_key_of_point):
        row = list(group)
        wanted = "bbox" in words(row[0].key) and '"bbox"' not in text  # of GeoJSON it is no shape of its own
        if not wanted and all(_is_harmless(each) or each.end in account.aside for each in row):
            harmless += [each for each in row if each.key != "satviz"]  # the format of a scene file
        else:
            missed.append((row[0].start, _named(row, text)))
    return Rest([said for _, said in sorted(missed)], _named(harmless, text) if harmless else "")


def _without_unit(numbers: Sequence[Token], used: Collection[int], text: str) -> Iterator[tuple[int, str]]:
    """Yield the numbers of shapes that have no unit, if others have one; in SVG, px is that of a bare number."""
    found = [token for token in numbers if token.end in used and token.value]
    with_unit = next((token for token in found if token.text.endswith(LENGTHS)), None)
    if with_unit and not re.search(rf"\bin (?:{'|'.join(LENGTHS)})\b", text):
        bare = [token for token in found if not token.text.endswith(LENGTHS)]
        if bare and not (with_unit.text.endswith("px") and MARKUP.search(text)):
            said = ", ".join(token.text for token in bare[:MAX_NAMED])
            yield bare[0].start, f"{said} without a unit beside {with_unit.text}: write all lengths in one unit"


def _missed_by_line(parts: Sequence[Part], text: str) -> Iterator[tuple[int, str]]:
    """Yield (offset, words) for each line that has parts which were not understood; `offset`: where the line begins.

    The words name the parts.  They also quote the line if it has several such parts, or one shorter than MIN_SAID.
    """
    for line, group in groupby(parts, key=lambda part: text.rfind("\n", 0, part.start) + 1):
        said = [short(text[part.start : part.end]) for part in group]
        whole = short(text[line:].partition("\n")[0])
        alone = len(said) == 1 and len(said[0]) >= MIN_SAID
        yield line, said[0] if alone or said == [whole] else f"{', '.join(said)} (in {whole})"


def _named_values(fields: Mapping[str | int, Any]) -> Iterator[tuple[str, Any]]:
    """Yield (name, value) of each variable of a text; a field of `this` or `self` is named `this.field`."""
    for name, value in fields.items():
        if name in ("this", "self") and isinstance(value, Obj):
            yield from ((f"{name}.{inner}", each) for inner, each in value.fields.items())
        else:
            yield str(name), value


def _size(value: Any) -> int:
    """Return how many items a value has."""
    return len(value.fields) if isinstance(value, Obj) else len(value.items) if isinstance(value, Group) else 0


def _is_made_of(names: Mapping[str, int], value: Any) -> bool:
    """Return whether a value is a known call with one of these names in it: hull = b2ComputeHull(points, 3)."""
    inner = value.items if isinstance(value, Group) and value.name and notation(value.name) else ()
    return any(isinstance(item, Name) and root(item.text) in names for item in inner)


def _holds(places: Sequence[int], value: Any) -> bool:
    """Return whether one of these places lies within a value."""
    if isinstance(value, Obj):
        return any(_holds(places, v) for v in (*value.fields.values(), *value.rest))
    at = bisect_right(places, value.start)
    return at < len(places) and places[at] <= value.end


def numbers_by_key(tree: Tree, text: str) -> str:
    """Return the first numbers of a text, each with the key or the call before it, in a short line: radius 10, x 5."""
    return short(_named(list(_walk(tree, tree.root, "")), text))


def _walk(tree: Tree, value: Any, name: str) -> Iterator[Left]:
    """Yield every number of a tree with the key or the call before it."""
    if isinstance(value, Num) and value.start < value.end:
        yield Left(value.start, value.end, name, value.value)
    elif isinstance(value, Pair):
        path = ".".join(str(part) for part in value.path if isinstance(part, str))
        moves = words(value.before) & CHANGING_NUMBERS  # b2Transform at = {{0, 0}, 1}
        yield from _walk(tree, value.value, ".".join(filter(None, (name, value.before if moves else "", path))))
    elif isinstance(value, Bad):
        for inner in value.inside:
            yield from _walk(tree, inner, name)
        if not value.inside:  # an expression: Math.PI / 4
            first = bisect_left(tree.numbers, value.start, key=lambda token: token.start)
            for token in takewhile(lambda token: token.end <= value.end, tree.numbers[first:]):
                yield Left(token.start, token.end, name, None)
    elif isinstance(value, Group):
        row = notation(value.name) if value.name else None
        inside = value.name if value.name and not (row and row.kind == Kind.POINT) else name
        if len(value.name) > 1 and key(value.name) in PLACED:  # rectangle position (1, 2)
            inside = f"{value.before} {value.name}".strip()
        for inner in value.items:
            yield from _walk(tree, inner, inside)
        for method, arguments in value.methods:
            yield from _walk(tree, arguments, method)


def _is_harmless(left: Left) -> bool:
    """Return whether an unused number changes no shape, as its key shows: a mass, or a scale of 1."""
    said, last = words(left.key.removeprefix("svg.")), words(left.key.split(".")[-1])
    path = left.key.split(".")
    aside = not {"bounds", "properties"}.isdisjoint(path) and key(path[-1]) not in ("center", "half", "size")
    row = notation(left.key)
    no_radius = left.value == 0 and row is not None and row.kind == Kind.RING  # b2MakePolygon(&hull, 0.0f)
    drawn = row and said & {"draw", "graphics", "cv2"} and not last & CHANGING_NUMBERS  # a width, a color
    if "moment" in said or left.key == "pymunk.Body" or aside or no_radius or drawn:
        return True
    shaped = row is not None and row.kind in (Kind.BOX, Kind.CIRCLE) and "bbox" not in last  # b2MakeSquare
    if (shaped or any(word.startswith(SHAPE_STEMS) for word in last)) and not last & CHANGING_NUMBERS:
        return "count" in last
    same = left.value == (1 if any("scal" in word or word == "zoom" for word in said) else 0)
    if path[-1].lower() in MOVERS:
        return same  # style="translate: 5px"
    return bool(said & OTHER_NUMBERS) or (same and bool(said & CHANGING_NUMBERS))


def _key_of_point(left: Left) -> str:
    """Return the key of a number without a last .x, .y or .z: center for center.x."""
    return re.sub(r"\.[xyzXYZ]$", "", left.key)


def _named(lefts: Sequence[Left], text: str) -> str:
    """Return numbers with their keys, shortened: scaleX 2, offset 5, 0 and 3 more."""
    parts = []
    for name, group in groupby(lefts, key=_key_of_point):
        row = list(group)
        name = name if len(row) > 1 else row[0].key
        numbers = [text[left.start : left.end][:20] for left in row]
        parts += [f"{name[:40]} {', '.join(numbers[:MAX_NAMED])}"] if name else numbers
    more = f" and {len(parts) - MAX_NAMED} more" if len(parts) > MAX_NAMED else ""
    return f"{', '.join(parts[:MAX_NAMED])}{more}"
