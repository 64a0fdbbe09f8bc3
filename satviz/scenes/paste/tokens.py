"""A text as tokens: numbers with every digit, names, brackets.  One tokenizer reads every notation."""

import re
from collections.abc import Iterable, Iterator
from fractions import Fraction
from typing import NamedTuple

from ...engine.geometry import InvalidScene

MAX_CHARS = 1 << 20
MAX_TOKENS = 60_000  # some 12,000 points; a second of work
TOO_MANY = f"the text has more than {MAX_TOKENS:,} words and numbers: paste the shapes alone"
MAX_DIGITS = 400  # no float64 needs more, and no exponent beyond this size fits one

NUMBER, NAME, FIELD, TEXT, OPEN = "number", "name", "field", "text", "open"
CLOSE, MARK, LINE, OTHER = "close", "mark", "line", "other"

NUMERAL = r"[-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?"
# Units of length.  They may follow a number after a space, and one text has only one of them.
LENGTHS = ("px", "mm", "cm", "m", "km", "ft")
# What may follow a number directly: the suffixes of C, C++, C#, Java, Rust, Scala, and units.
SUFFIXES = frozenset(
    ["", "f", "d", "l", "u", "f32", "f64", "i32", "i64", "u32", "ll", "ul", "ull", "deg", "rad", "°", *LENGTHS]
)

_TOKEN = re.compile(
    r"""
    (?P<space>[ \t\r\f\v\ufeff\u00a0]+|\\\n|(?<=\[)\||\|(?=\])|(?<=\[)_(?=\])|\.(?=\{)|@(?=")|'''|"\""+|```\w*)
  | (?P<comment>(?<![\d)\]])(?!(?<=[\d)\]fx][ ])//[ ]?[-.\d])//[^\n]*
     |\#(?![\w-]+[ ]*\{|(?<![\])};,][ ]\#)\d+[ ]*(?:\w+[ ]*)?[:\[(])[^\n]*
     |(?<![\d)\]])(?!(?<=[)][ ])--[ ](?:[-+(\d]|cycle\b))--(?=[ \[])[^\n]*|/\*.*?\*/|<!--.*?-->)
  | (?P<line>\n)
  | (?P<tag>/>|(?<=["'])>|</[A-Za-z][\w:.-]*>|(?<![\w>])<[A-Za-z][\w:.-]*>|(?<=>)<[A-Za-z][\w:.-]*>(?=\s*[-<.\d]))
  | (?P<number>(?:(?<![\w)\].])[+\-\u2212])?
        (?:0[xX][0-9a-fA-F]+(?:\.[0-9a-fA-F]*)?(?:[pP][+-]?[0-9]+)?
         |(?:[0-9][0-9_]*(?:'[0-9]{3})*(?:\.(?!\.)[0-9_]*)?|\.[0-9][0-9_]*)(?:[eEdD][+\-\u2212]?[0-9]+)?)
        (?P<suffix>[A-Za-z_%°\u2032][\w]*|[ ](?:px|[cmk]?m|ft)\b(?![ ]?[(\[.=:*+/-]))?)
  | (?P<name>(?![\u00b2\u00b3\u00b9])[^\W\d][\w$]*(?:(?:\.|::|->)[^\W\d][\w$]*)*
        (?:(?:::)?<[A-Za-z_][\w ,.:\[\]&]*>(?:(?:\.|::)[^\W\d]\w*)*)?(?:!(?=[\[({]))?|\$\w+)
  | (?P<text>"(?:[^"\\\n]|\\.)*"|(?<!\w)'(?:[^'\\\n]|\\.)*'|`[^`]*`)
  | (?P<field>(?:\.|->|::)[^\W\d]\w*)
  | (?P<open>[(\[{])
  | (?P<close>[)\]}])
  | (?P<mark><-(?=[ ])|<?-?->|[\u2192\u2194\u21d2]|=>|==|:=|<=|>=|!=|[,;:=])
  | (?P<other>\\.|.)
    """,
    re.VERBOSE | re.DOTALL,
)


class Token(NamedTuple):
    """One token: its kind, its text, where it begins and ends, and of a number its exact value or why it has none."""

    kind: str
    text: str
    start: int
    end: int
    value: Fraction | None = None
    why: str = ""


def tokens(text: str) -> list[Token]:
    """Return the tokens of a text without spaces and comments; InvalidScene for more than can be read in a second."""
    if not isinstance(text, str):
        raise TypeError(f"expected text, not {type(text).__name__}")
    if len(text) > MAX_CHARS:
        raise InvalidScene(
            f"the text has {len(text):,} characters: the limit is {MAX_CHARS:,}, so paste the shapes alone"
        )
    found: list[Token] = []
    for token in in_one_unit(_scan(_without_open_comments(text))):
        found.append(token)
        if len(found) > MAX_TOKENS:
            raise InvalidScene(TOO_MANY)
    return found


def in_one_unit(found: Iterable[Token]) -> Iterator[Token]:
    """Yield the tokens; once a second unit of length occurs, lengths have a reason (`why`) in place of a value.

    Numbers after "in mm" are in mm.
    """
    units: set[str] = set()
    said = before = ""
    for token in found:
        if token.kind == NAME and before == "in" and token.text in LENGTHS:
            said = token.text
        if token.kind == NUMBER:
            unit = token.text.lstrip("-+.0123456789eE_ ") if token.text.endswith(LENGTHS) else said
            units |= {unit} - {""}
            if unit and len(units) > 1:
                mixed = " and ".join(sorted(units))
                token = token._replace(value=None, why=f"the lengths are in {mixed}: write all of them in one unit")
        before = token.text
        yield token


def _without_open_comments(text: str) -> str:
    """Return the text, as long as before, with the opening signs of comments that are never closed blanked.

    The first character of each stays.  Otherwise each would be searched to the end of the text.
    """
    for sign, end in (("/*", "*/"), ("<!--", "-->")):
        last = text.rfind(end) + 1
        text = text[:last] + text[last:].replace(sign, sign[0].ljust(len(sign)))
    return text


def _scan(text: str) -> Iterator[Token]:
    """Yield the tokens of a text."""
    for match in _TOKEN.finditer(text):
        kind = match.lastgroup or OTHER
        kind = NUMBER if kind == "suffix" else kind
        if kind in ("space", "comment"):
            continue
        if kind == "tag":  # the end of an element of XML
            yield Token(MARK, ";", match.start(), match.end())
            continue
        if match[0] == "<-":  # R
            yield Token(MARK, "=", match.start(), match.end())
            continue
        if kind != NUMBER:
            yield Token(kind, match[0], match.start(), match.end())
            continue
        suffix = match["suffix"] or ""
        digits = match[0][: len(match[0]) - len(suffix)]
        value, why = number(digits)
        if suffix.lower().lstrip("_ ") not in SUFFIXES:
            value, why = None, f"{_short(match[0])} is not a number"
        yield Token(NUMBER, match[0], match.start(), match.end(), value, why)


def number(text: str) -> tuple[Fraction | None, str]:
    """Return (exact value, "") of a number's text, or (None, why it cannot be taken)."""
    plain = text.replace("_", "").replace("'", "").replace("\u2212", "-")
    if len(plain) > MAX_DIGITS:
        return None, f"a number of {len(plain)} digits is longer than any that float64 needs"
    sign = -1 if plain.startswith("-") else 1
    plain = plain.lstrip("+-").lower()
    if plain.startswith("0x"):
        if "p" not in plain:
            return None, f"{_short(text)} is hexadecimal: write the coordinate as a decimal number"
        mantissa, _, exponent = plain[2:].partition("p")
        whole, _, part = mantissa.partition(".")
        if abs(int(exponent)) > 2 * MAX_DIGITS + 400:
            return None, f"{_short(text)} is too large or too small for float64"
        return sign * Fraction(int(whole + part, 16)) * Fraction(2) ** (int(exponent) - 4 * len(part)), ""
    mantissa, _, exponent = plain.replace("d", "e").partition("e")  # 3.0d0 is Fortran's
    whole, _, part = mantissa.partition(".")
    power = int(exponent or 0) - len(part)
    digits = int(whole + part)
    if digits and not -MAX_DIGITS < power + len(whole + part) < 310:
        return None, f"{_short(text)} is too large or too small for float64"
    return sign * (
        Fraction(digits * 10**power) if power >= 0 else Fraction(digits, 10**-power)
    ) if digits else Fraction(0), ""


def _short(text: str) -> str:
    """Return the text, shortened for an error line."""
    return text if len(text) <= 40 else f"{text[:40]}..."
