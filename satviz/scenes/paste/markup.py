"""Elements of SVG as calls: <circle cx="1" cy="2" r="3"/> is read as svg.circle(cx=1, cy=2, r=3)."""

import re
from bisect import bisect_left
from collections.abc import Iterator
from fractions import Fraction
from itertools import islice

from ...engine.geometry import InvalidScene
from .prose import sentences
from .svg_path import PATH_DATA, path_tokens
from .tables import tables
from .tokens import CLOSE, FIELD, MARK, MAX_TOKENS, NAME, NUMBER, NUMERAL, OPEN, TOO_MANY, Token, in_one_unit, tokens

_QUOTED = r"\"[^\"<>]*\"|'[^'<>]*'"
_ELEMENT = re.compile(rf"<(circle|ellipse|rect|polygon|polyline|path|area)(?=[\s/>])((?:[^<>\"']|{_QUOTED})*)>")
# of Tiled: the corners of a polygon are relative to the object that holds it
_OBJECT = re.compile(rf"<object\b((?:[^<>\"']|{_QUOTED})*)>\s*(?=<(?:polygon|polyline|ellipse)\b)")
_ATTRIBUTE = re.compile(rf"([\w:-]+)[ \t\r\n]*=[ \t\r\n]*({_QUOTED})")
# a line of path data alone, with a letter before its second pair
_LINE = r"[ \t]*[Mm][ \t]*[-+.0-9][-+.,0-9eE \t]*[A-Za-z][-+.,0-9eE \tMmLlHhVvZzCcSsQqTtAa]*"
_BARE = re.compile(rf"([\"'`])({PATH_DATA.pattern})\1|^()({_LINE})$", re.MULTILINE)
_MOVED = re.compile(r"(?<!text-)(?:transform|rotate|scale|translate)\s*:(?!\s*none)")  # in a style
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
    parts = [(m.start(), m.end(), list(_element(m, held.get(m.start(), {})))) for m in _ELEMENT.finditer(text)]
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
    begins = [token.start for token in plain]
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


def _element(match: re.Match[str], holder: dict[str, tuple[str, int]]) -> Iterator[Token]:
    """Yield the call that an element stands for, on a line of its own, moved to the object that holds it."""
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
    style, at = found.get("style", ("", 0))
    if _MOVED.search(style):
        why = f"{style[:40]!r} is not applied: write the numbers that it leads to"
        yield from _call("transform-css", [_broken(style, at)._replace(why=why)])
    if "transform" in found:
        yield from _changes(*found["transform"])
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


def _changes(text: str, at: int) -> Iterator[Token]:
    """Yield the tokens of the calls that a `transform` attribute stands for: a move is applied, all else is refused.

    `at`: the place of the attribute's value in the whole text.
    """
    if not _BETWEEN.fullmatch(_TRANSFORM.sub("", text)):
        yield from _call("transform", [_broken(text, at)])
    for m in _TRANSFORM.finditer(text):
        inside, begin = m[2], at + m.start(2)
        values = _inner(inside, begin) if _are_numbers(inside) else [_broken(inside, begin)]
        if m[1] == "translate" and len(values) == 1:
            values.append(Token(NUMBER, "0", values[0].end, values[0].end, Fraction(0)))
        if values:
            yield from _call(m[1] if m[1] == "translate" else f"transform-{m[1]}", values)


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
