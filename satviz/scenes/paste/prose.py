"""Shapes in a sentence: "a circle at (0, 0) with radius 5", "the box is at (0, 32) and is 16x16"."""

import re
from collections.abc import Iterator

from .tokens import CLOSE, MARK, NAME, NUMBER, OPEN, Token, tokens

_N = r"[-+\u2212]?(?:[0-9]++\.?[0-9]*+|\.[0-9]++)(?:[eE][-+]?[0-9]++)?(?:[ ]?(?:px|[cmk]?m|ft)\b)?+"
_PLACE = rf"(?:\([ ]?{_N}[ ]?,[ ]?{_N}[ ]?\)|\b(?:center|centre|at|position)[ ]{_N}[ ]?,[ ]?{_N})"
_AT = r"(?:(?:centered|centred|at|on|with|and|its) +){0,3}"
_M = r"-?\d+(?:\.\d+)?"  # a number in a range: 0..4
_FILL = r"[ ,]{1,3}(?:(?:and|with|has|having|of|is|a|an|the|its|size|shape)[ ,]{1,3}){0,4}"
_Q = rf"(?:\({_N}[ ]?,[ ]?{_N}\)|{_N}[ ]?,[ ]?{_N}(?![\w.%,]))"
_P, _A = rf"\({_N}[ ]?,[ ]?{_N}\)", rf"(?:{_N}|\({_N}\))"
_STYLE = r"(?:\[(?![^\]]*(?:scale|shift|rotate|slant|cm=))[^\]()\n]*\])?"  # of TikZ, without a change of place
# One row for each kind of sentence, or of print: the call that it stands for, its words, and which numbers are its own.
SENTENCES = (
    (
        "svg.polygon",
        re.compile(
            rf"(?:^ *0\s+)?^LWPOLYLINE(?:\s+(?:[12]0\s+{_N}[ \r]*$"
            r"|(?!0\s|[12]0\s|2[123]0\s|42\s+[-.\d]*[1-9])\d+\s+\S.*))+(?:\s+0\s+(?:ENDSEC|EOF))*",
            re.MULTILINE,
        ),
        re.compile(rf"\n *[12]0\s+({_N})"),
    ),  # DXF; 42 is the bulge of an arc, and 210 to 230 turn the plane
    (
        "circle",
        re.compile(rf"{_PLACE}{_FILL}(?:radius(?:[ ](?:of|is|=))?|r[ ]?=)[ ]{_N}(?!\w|%|\.\w|[ ]*\}})", re.IGNORECASE),
    ),
    ("circle", re.compile(rf"radius(?:[ ](?:of|is|=))?[ ]{_N}[ ,]{{1,3}}{_AT}{_PLACE}", re.IGNORECASE)),
    ("qrect", re.compile(rf"(?<=QRect)\({_N},{_N} {_N}x{_N}\)|(?<=QRectF)\({_N},{_N} {_N}x{_N}\)")),
    (
        "circle",
        re.compile(
            rf"\b(?:circle|disc|disk|ball)[ ][(\[][ ]?{_N}[ ]?,[ ]?{_N}[ ]?[)\]](?:,[ ]?|[ ])"
            rf"(?:r(?:adius)?[ ]?[=:]?[ ]?)?{_N}(?!\w|%|\.\w|[ ]*[x\u00d7*/+-])",
            re.IGNORECASE,
        ),
    ),
    (
        "circle",
        re.compile(rf"\bcenter point, +X= *{_N} +Y= *{_N} +Z= *0\.0*\s+radius +{_N}"),
        re.compile(rf"(?:[XY]=|radius) *({_N})"),
    ),  # AutoCAD
    ("qrect", re.compile(rf"(?<=frame = )\({_N} {_N}; {_N} {_N}\)")),  # UIKit
    ("image.rect", re.compile(rf"<QgsRectangle: {_N} {_N}, {_N} {_N}>")),
    ("qrect", re.compile(rf"<rect\({_N}, {_N}, {_N}, {_N}\)>")),  # pygame
    ("qrect", re.compile(rf"\[P: {_P}, S: {_P}\]")),  # Godot
    ("qrect", re.compile(rf"\(x:{_N}, y:{_N}, width:{_N}, height:{_N}\)")),  # Unity
    ("v2", re.compile(rf"<{_N}, {_N}>")),  # a vector of C#
    ("image.rect", re.compile(rf"\bmin(?:imum)?(?: at| =|:)? {_P},?(?: and)? (?:its )?max(?:imum)?(?: at| =|:)? {_P}")),
    (
        "image.rect",
        re.compile(rf"\b(?:rect|rectangle|box|square|one|aabb)(?: [A-Za-z]+){{0,3}} from {_Q} to {_Q}", re.IGNORECASE),
    ),
    (
        "svg.polygon",
        re.compile(rf"(?<![\d.])[-.\d]{{1,20}} {_N} moveto(?:\s+{_N} {_N} lineto)+\s+closepath"),
    ),  # PostScript
    ("image.rect", re.compile(rf"(?<=Rect)\({_N}, {_N} - {_N}, {_N}\)")),  # Android
    ("image.rect", re.compile(rf"(?<!, )\({_N},{_N}\)-\({_N},{_N}\)(?!, ?\()")),  # Go
    ("image.rect", re.compile(rf"\[\[{_N} {_N}\] - \[{_N} {_N}\]\]")),  # egui
    ("jts.env", re.compile(rf"\[{_N}, ?{_N}\] ?[x\u00d7] ?\[{_N}, ?{_N}\]")),  # intervals
    ("jts.env", re.compile(rf"\bx in \[{_N}, ?{_N}\],? (?:and )?y in \[{_N}, ?{_N}\]")),
    ("circle", re.compile(rf"^[ \t]*circle {_N} {_N} {_N}[ \t]*$", re.IGNORECASE | re.MULTILINE)),
    ("rect", re.compile(rf"^[ \t]*(?:rect|rectangle|box) {_N} {_N} {_N} {_N}[ \t]*$", re.IGNORECASE | re.MULTILINE)),
    ("jts.env", re.compile(rf"\bx[ :=]+{_M}\.\.=?{_M}[, ]+y[ :=]+{_M}\.\.=?{_M}"), re.compile(rf"({_M})")),
    ("jts.env", re.compile(rf"Env\[{_N} : {_N}, {_N} : {_N}\]")),
    ("size.at", re.compile(rf"\[{_N} x {_N} from \({_N}, {_N}\)\]")),  # OpenCV
    ("size.at", re.compile(rf"(?<=Rect)\({_N}x{_N} at \({_N}, {_N}\)\)")),  # euclid
    ("v2", re.compile(rf"\bV2 {_A} {_A}(?![\w.%])")),  # Haskell
    ("svg.polygon", re.compile(rf"\\(?:draw|fill|filldraw|path){_STYLE}\s*{_P}(?:\s*--\s*{_P})+\s*--\s*cycle")),  # TikZ
    ("circle", re.compile(rf"\({_N}[ ]?,[ ]?{_N}\)[ ]circle[ ]\({_N}\)")),
    ("image.rect", re.compile(rf"\({_N}[ ]?,[ ]?{_N}\)[ ]rectangle[ ]\({_N}[ ]?,[ ]?{_N}\)")),
    (
        "qrect",
        re.compile(rf":add\((?:[A-Za-z_][\w.]*|\"[^\"\n]*\"|'[^'\n]*')(?:[ ]?,[ ]?{_N}){{4}}[ ]?\)"),
        re.compile(rf",[ ]?({_N})"),
    ),  # bump of Lua
    ("rect", re.compile(rf"{_PLACE}{_FILL}{_N}[ ]?[x\u00d7][ ]?{_N}(?![\w.%]| (?:square|rect|box))", re.IGNORECASE)),
)
_NUMBER = re.compile(rf"(?<!\bV){_N}")


def sentences(text: str) -> Iterator[tuple[int, int, list[Token]]]:
    """Yield (start, end, tokens) for each shape in a sentence, with the tokens of a call."""
    for name, pattern, *own in SENTENCES:
        for match in pattern.finditer(text):
            yield match.start(), match.end(), list(_call(name, match, *own))


def _call(name: str, match: re.Match[str], own: re.Pattern[str] = _NUMBER) -> Iterator[Token]:
    """Yield the call that a sentence stands for: circle((x, y), radius) or rect((x, y), width, height)."""
    at = match.start()
    ends = [Token(MARK, ";", place, place) for place in match.span()] if name != "v2" else []  # v2: a point of a list
    yield from ends[:1]
    yield Token(NAME, name, at, at)
    yield Token(OPEN, "(", at, at)
    nested = name != "svg.polygon"
    first = int(match[0][:6].lower() == "radius")  # radius 5 at (0, 0): the point is the second part
    for i, part in enumerate(own.finditer(match[0], match[0].find("]") + 1 if not nested else 0)):
        start, end = (at + place for place in part.span(own.groups))
        (number,) = tokens(part[own.groups])
        if i == first and nested:
            yield Token(OPEN, "(", start, start)
        yield number._replace(kind=NUMBER, start=start, end=end)
        if i == first + 1 and nested:
            yield Token(CLOSE, ")", end, end)
        yield Token(MARK, ",", end, end)
    yield Token(CLOSE, ")", match.end(), match.end())
    yield from ends[1:]
