"""The data of an SVG path as corners: M, L, H, V and Z, absolute and relative.  Curves have no corners."""

import re
from collections.abc import Iterator
from fractions import Fraction

from .tokens import CLOSE, MARK, NUMBER, NUMERAL, OPEN, Token, number

_PART = re.compile(rf"[A-Za-z]|{NUMERAL}")
_REST = re.compile(r"[\s,]*")
PATH_DATA = re.compile(r"\s*[Mm][\s,]*[-+.]?[0-9][\s0-9.,+\-eEMmLlHhVvZzCcSsQqTtAa]*")
_TAKES = {"M": 2, "L": 2, "H": 1, "V": 1}
CURVES = "a path with a curve: give each curve as corners"
SEVERAL_PARTS = "a path of several parts: paste each part alone"
BROKEN = "path data that cannot be read: write its corners"


def path_tokens(data: str, at: int) -> Iterator[Token]:
    """Yield the corners of path data that begins at a place in the text, as the tokens of a list of points."""
    corners, why = _corners(data, at)
    if why:
        yield Token(NUMBER, data[:40], at, at + len(data), None, why)
        return
    for x, y in corners:
        yield Token(OPEN, "(", x.start, x.start)
        yield x
        yield Token(MARK, ",", x.end, x.end)
        yield y
        yield Token(CLOSE, ")", y.end, y.end)
        yield Token(MARK, ",", y.end, y.end)


def _corners(data: str, at: int) -> tuple[list[tuple[Token, Token]], str]:
    """Return (corners, "") of path data, or ([], why there are none)."""
    corners: list[tuple[Token, Token]] = []
    x = y = Fraction(0)
    command, closed = "", False
    given: list[Token] = []
    if _REST.fullmatch(_PART.sub("", data)) is None:
        return [], BROKEN
    for part in _PART.finditer(data):
        if part[0].isalpha():
            if given:
                return [], BROKEN
            command = part[0]
            if command in "Zz":
                closed = True
            elif command.upper() not in _TAKES:
                return [], CURVES if command.upper() in "CSQTA" else BROKEN
            elif command in "Mm" and corners:
                return [], SEVERAL_PARTS
            continue
        value, why = number(part[0])
        if value is None or command.upper() not in _TAKES or closed:
            return [], why or (SEVERAL_PARTS if closed else BROKEN)
        given.append(Token(NUMBER, part[0], at + part.start(), at + part.end(), value))
        if len(given) < _TAKES[command.upper()]:
            continue
        values = [token.value or Fraction(0) for token in given]
        relative = command.islower()
        new_x, new_y = x, y
        if command in "Hh":
            new_x = values[0] + (x if relative else 0)
        elif command in "Vv":
            new_y = values[0] + (y if relative else 0)
        else:
            new_x, new_y = (v + (w if relative else 0) for v, w in zip(values, (x, y), strict=True))
        x, y = new_x, new_y
        corners.append((given[0]._replace(value=x), given[-1]._replace(value=y)))
        given = []
        command = {"M": "L", "m": "l"}.get(command, command)
    if given or len(corners) < 3:
        return [], BROKEN
    return corners, ""
