"""Elements of SVG as calls: <circle cx="1" cy="2" r="3"/> is read as svg.circle(cx=1, cy=2, r=3)."""

import re
from bisect import bisect_left, bisect_right
from collections.abc import Iterator
from fractions import Fraction
from itertools import islice

from ...engine.geometry import InvalidScene
from .boxes import IDENTITY, Affine, cosine_and_sine
from .notations import Form
from .prose import sentences
from .svg_path import PATH_DATA, path_tokens
from .tables import tables
from .tokens import (
    CLOSE,
    FIELD,
    MARK,
    MAX_TOKENS,
    NAME,
    NUMBER,
    NUMERAL,
    OPEN,
    TOO_MANY,
    Token,
    in_one_unit,
    number,
    tokens,
)

_QUOTED = r"\"[^\"<>]*\"|'[^'<>]*'"
_ELEMENT = re.compile(rf"<(circle|ellipse|rect|polygon|polyline|path|area)(?=[\s/>])((?:[^<>\"']|{_QUOTED})*)>")
# of Tiled: the corners of a polygon are relative to the object that holds it
_OBJECT = re.compile(rf"<object\b((?:[^<>\"']|{_QUOTED})*)>\s*(?=<(?:polygon|polyline|ellipse)\b)")
_ATTRIBUTE = re.compile(rf"([\w:-]+)[ \t\r\n]*=[ \t\r\n]*({_QUOTED})")
# a line of path data alone, with a letter before its second pair
_LINE = r"[ \t]*[Mm][ \t]*[-+.0-9][-+.,0-9eE \t]*[A-Za-z][-+.,0-9eE \tMmLlHhVvZzCcSsQqTtAa]*"
_BARE = re.compile(rf"([\"'`])({PATH_DATA.pattern})\1|^()({_LINE})$", re.MULTILINE)
# a transform in a style attribute
_MOVED = re.compile(r"(?<!text-)(?:transform|rotate|scale|translate)\s*:(?!\s*none)")
_MOVED_BY = re.compile(r"transform-(?:origin|box)|(?<!text-)(?:transform|rotate|scale|translate)\s*:")
_GROUP = re.compile(rf"<(/?)g\b((?:[^<>\"']|{_QUOTED})*)>")
_BETWEEN = re.compile(r"[\s,]*")
_TRANSFORM = re.compile(r"(\w+)\s*\(([^()]*)\)")
# names of parameters, with their defaults
_PARAMETERS = (
    r"\((?:\s*[A-Za-z_$*&](?:[^,(){}\[]|\[(?![-+.\d\s(\[]))*+,?)*+\s*\)"
    r"(?:\s*->[^\n:{]*)?(?::(?=\s*\n)|(?=\s*(?::[^\n{]*)?\{|\s*$))"
)
# parts without a shape: how large a picture is, a declaration, how many items a list of C has, a pattern of DE-9IM
_OTHER = re.compile(
    r"<(?:svg(?![^<>]*\s[xy]\s*=\s*[\"'][^\"'<>]*[1-9])|g|text|tspan|title|desc|style|defs|image)\b"
    r"(?![^<>]*(?:transform|(?:translate|rotate|scale)\s*:))[^<>]*>|\bviewBox\s*=\s*(?:\"[^\"<>]*\"|'[^'<>]*')"
    r"|\b(?:interface|struct|type|record)\s+\w+\s*(?:=\s*)?\{(?:[^{}()\d]|(?<=[a-z_])\d+)*\}"
    r"|^[ \t]*ans\s*=\s*(?:logical\s*)?[-.\d]+\s*$"  # of MATLAB
    r"|\bclass\s+\w+(?:\s+extends\s+[\w.]+)?(?=\s*\{)|\bclass\s+\w+(?:\([A-Za-z_., ]*\))?:(?=\s*\n)"
    rf"|\b(?:def +\w+|function *\w*|constructor|fn +\w+) *{_PARAMETERS}"
    r"|\bsizeof\s*\([^()]*\)\s*/\s*sizeof\s*\([^()]*\)|(?P<quote>['\"])[012FT*]{9}(?P=quote)"
    r"|(?<![\w/.-])[\w/.-]{1,80}\.(?:py|js|ts|cs|cpp|cc|c|h|hpp|rs|go|java|rb|lua|gd|kt|swift|m):\d+(?::\d+)?|TopologyException:[^\n]*"
    r"|\b(?:Windows|macOS|Ubuntu|Android|iOS|Python|Node|Java|Chrome|Firefox) \d+(?:\.\d+)*"
    r"|(?:\bv|\bversion\W{1,6}|(?<![\w.+-])[a-z][\w.+-]{0,40} v?)\d+\.\d+\.\d+\w*"
    r"|\bEigen::Matrix\w+ +\w+\(\d+, *\d+\)|^\s*size\(\d+, *\d+\);",
    re.IGNORECASE | re.MULTILINE,
)
# The attributes that are numbers of a shape; 0 is what SVG takes for a place that is not given.
_NUMBERS = {
    "circle": ("cx", "cy", "r"),
    "ellipse": ("cx", "cy", "rx", "ry"),
    "rect": ("x", "y", "width", "height", "rx", "ry"),
}
# The areas of an image map: a box by two corners, a circle by its center and radius, or corners.
_AREAS = {"rect": "ltrb", "circle": "c2circle", "poly": "svg.polygon"}
_PLACES = frozenset(["x", "y", "cx", "cy"])


def all_tokens(text: str) -> tuple[list[Token], list[Token], list[tuple[int, int]]]:
    """Return (tokens as written, tokens as read, spans) of a text.

    In the tokens as read, markup, path data, tables and sentences are calls and lists; `spans`: where they stood, as
    (start, end).  InvalidScene for more than MAX_TOKENS.
    """
    plain = tokens(text)
    held = {m.end(): _attributes(m[1], m.start(1)) for m in _OBJECT.finditer(text)}
    places, outer, parts = _groups(text)
    for m in _ELEMENT.finditer(text):
        around = outer[bisect_right(places, m.start()) - 1]
        parts.append((m.start(), m.end(), list(_element(m, held.get(m.start(), {}), around))))
    parts += [(m.start(), m.end(), []) for m in _OBJECT.finditer(text)]
    ends = [(start, end) for start, end, _ in parts]
    inside = iter([*ends, (len(text), len(text))])
    start, end = next(inside)
    for m in _BARE.finditer(text):
        while end <= m.start():
            start, end = next(inside)
        if m.start() < start:
            data = 2 if m[2] is not None else 4
            found = [_mark(OPEN, "[", m.start()), *path_tokens(m[data], m.start(data)), _mark(CLOSE, "]", m.end())]
            found.append(_mark(MARK, ";", m.end()))
            parts.append((m.start(), m.end(), found))
    parts += [(m.start(), m.end(), []) for m in _OTHER.finditer(text)]
    parts += [*tables(text), *sentences(text)]
    begins = [token.start for token in plain] if parts else []
    parts = [part for part in parts if bisect_left(begins, part[0]) < bisect_left(begins, part[1])]  # not in a comment
    if not parts:
        return plain, plain, []
    parts.sort(key=lambda part: part[0])
    found = list(islice(in_one_unit(_replaced(plain, parts)), MAX_TOKENS + 1))
    if len(found) > MAX_TOKENS:
        raise InvalidScene(TOO_MANY)
    return plain, found, [(start, end) for start, end, _ in parts]


def _replaced(plain: list[Token], parts: list[tuple[int, int, list[Token]]]) -> Iterator[Token]:
    """Yield the tokens `plain`; where a part (start, end, its tokens) lies, yield its tokens instead."""
    rest = iter(parts)
    part = next(rest, None)
    reached = 0
    for token in plain:
        while part is not None and part[0] <= token.start:
            if part[0] >= reached:
                yield from part[2]
                reached = part[1]
            part = next(rest, None)
        if token.start >= reached:
            yield token


def _are_numbers(text: str) -> bool:
    """Return whether there are numbers in a text, and nothing else."""
    return _BETWEEN.fullmatch(re.sub(NUMERAL, "", text)) is not None


def _attributes(text: str, at: int) -> dict[str, tuple[str, int]]:
    """Return the attributes of an element: their names, and each value with its place."""
    return {m[1]: (m[2][1:-1], at + m.start(2) + 1) for m in _ATTRIBUTE.finditer(text)}


def _element(match: re.Match[str], holder: dict[str, tuple[str, int]], outer: tuple[Affine, bool]) -> Iterator[Token]:
    """Yield the call that an element stands for, on a line of its own, moved to the object that holds it.

    `outer`: the transform of the groups around it.
    """
    tag = match[1]
    found = _attributes(match[2], match.start(2))
    round_ = tag == "ellipse" and {"x", "y", "width", "height"} <= set(holder)
    name = "tiled.ellipse" if round_ else f"svg.{tag}"
    if tag == "area":
        tag, name = "polygon", _AREAS.get(found.get("shape", ("", 0))[0], "svg.polygon")
        found["points"] = found.get("coords", ("", match.start()))
    yield _mark(MARK, ";", match.start())
    yield Token(NAME, name, match.start(), match.start())
    yield _mark(OPEN, "(", match.start())
    if round_:
        for name in ("x", "y", "width", "height"):
            yield from (*_number(*holder[name]), _mark(MARK, ",", match.start()))
    elif tag == "path":
        yield from path_tokens(*found.get("d", ("", match.start())))
    elif tag in ("polygon", "polyline"):
        points, at = found.get("points", ("", match.start()))
        for token in _inner(points, at) if _are_numbers(points) else [_broken(points, at)]:
            yield token
            yield _mark(MARK, ",", token.end)
    else:
        for name in _NUMBERS[tag]:
            if name in found:
                yield from _pair(name, _number(*found[name]))
            elif name in _PLACES:
                yield from _pair(name, [Token(NUMBER, "0", match.start(), match.start(), Fraction(0))])
    yield _mark(CLOSE, ")", match.end())
    own = _matrix(found["transform"][0]) if "transform" in found else (IDENTITY, True)
    moves = [
        name for name in found if name == "transform-origin" or (name == "style" and _MOVED.search(found[name][0]))
    ]
    if own is None or moves:
        said, at = found[moves[0] if moves else "transform"]
        why = f"{said[:40]!r} is not applied: write the numbers that it leads to"
        yield from _call("transform", [_broken(said, at)._replace(why=why)])
    elif (total := _times(outer[0], own[0])) != IDENTITY:
        values = (*total, Fraction(outer[1] and own[1]))
        yield from _call("affine", [Token(NUMBER, "", match.end(), match.end(), value) for value in values])
    if {"x", "y"} <= set(holder) and not round_:
        yield from _call("translate", [*_number(*holder["x"]), *_number(*holder["y"])])
    if "rotation" in holder:
        yield from _call("tiled-rotation", _number(*holder["rotation"]))
    yield _mark(MARK, ";", match.end())


def _pair(name: str, value: list[Token]) -> Iterator[Token]:
    """Yield a named argument."""
    if value:
        yield Token(NAME, name, value[0].start, value[0].start)
        yield _mark(MARK, "=", value[0].start)
        yield from value
        yield _mark(MARK, ",", value[-1].end)


def _matrix(text: str) -> tuple[Affine, bool] | None:
    """Return the matrix of a `transform`, and whether it is exact, as no turn by 45 degrees is; None if broken."""
    total, exact = IDENTITY, True
    if not _BETWEEN.fullmatch(_TRANSFORM.sub("", text)):
        return None
    for m in _TRANSFORM.finditer(text):
        values = [number(n)[0] for n in re.findall(NUMERAL, m[2])]
        if not _are_numbers(m[2]) or None in values:
            return None
        n = [value or Fraction(0) for value in values]
        match m[1], len(n):
            case "translate", 1 | 2:
                made = (*IDENTITY[:4], n[0], n[1] if len(n) > 1 else Fraction(0))
            case "scale", 1 | 2:
                made = (n[0], *IDENTITY[1:3], n[-1], *IDENTITY[4:])
            case "matrix", 6:
                made = (n[0], n[1], n[2], n[3], n[4], n[5])
            case "rotate", 1 | 3:
                c, s, right = cosine_and_sine(n[0], Form.DEGREES)
                x, y = n[1:] or IDENTITY[4:]
                made, exact = (c, s, -s, c, x - c * x + s * y, y - s * x - c * y), exact and right
            case _:
                return None
        total = _times(total, made)
    return total, exact


def _times(p: Affine, q: Affine) -> Affine:
    """Return the matrix that applies q, and then p."""
    (a, b, c, d, e, f), (u, v, w, x, y, z) = p, q
    return (a * u + c * v, b * u + d * v, a * w + c * x, b * w + d * x, a * y + c * z + e, b * y + d * z + f)


def _groups(text: str) -> tuple[list[int], list[tuple[Affine, bool]], list[tuple[int, int, list[Token]]]]:
    """Return (offsets at which the transform of the enclosing groups changes, (matrix, exact) from each on, parts).

    `parts`: (start, end, []) of the tags whose transform is read.
    """
    places, made = [0], [(IDENTITY, True)]
    parts: list[tuple[int, int, list[Token]]] = []
    stack = [made[0]]
    for m in _GROUP.finditer(text):
        if m[1]:
            stack = stack[:-1] or stack
        elif not m[2].endswith("/"):
            found = _attributes(m[2], 0)
            given = _matrix(found["transform"][0]) if "transform" in found and not _MOVED_BY.search(m[2]) else None
            outer, exact = stack[-1]
            stack.append((_times(outer, given[0]), exact and given[1]) if given else stack[-1])
            parts += [(m.start(), m.end(), [])] if given else []
        places.append(m.end())
        made.append(stack[-1])
    return places, made, parts


def _call(name: str, values: list[Token]) -> Iterator[Token]:
    """Yield a chained call of a shape."""
    yield Token(FIELD, f".{name}", values[0].start, values[0].start)
    yield _mark(OPEN, "(", values[0].start)
    for value in values:
        yield value
        yield _mark(MARK, ",", value.end)
    yield _mark(CLOSE, ")", values[-1].end)


def _inner(text: str, at: int) -> list[Token]:
    """Return the numbers and words of an attribute."""
    return [t._replace(start=t.start + at, end=t.end + at) for t in tokens(text) if t.kind in (NUMBER, NAME)]


def _number(text: str, at: int) -> list[Token]:
    """Return the NUMBER token of an attribute, or a token with the reason why the attribute is not a number."""
    found = _inner(text, at)
    return found if len(found) == 1 and found[0].text == text.strip() else [_broken(text, at)]


def _broken(text: str, at: int) -> Token:
    """Return a NUMBER token without a value, with the reason, for text that is not a number."""
    return Token(NUMBER, text, at, at + len(text), None, f"{text[:40]!r} is not a number")


def _mark(kind: str, text: str, at: int) -> Token:
    """Return a token that is added at the place `at`; the text itself does not have it."""
    return Token(kind, text, at, at)
