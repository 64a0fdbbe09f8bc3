"""The size of text in DejaVu Sans, from stored tables, so that a picture can be laid out where no font is installed."""

from functools import cache, lru_cache
from importlib.resources import files

from .theme import style_of

UNITS_PER_EM = 2048  # the widths in the tables are in 1/UNITS_PER_EM of the text size
LINE_HEIGHT = 1.2  # height of a line as a factor of the text size


def text_width(line: str, *, bold: bool = False) -> float:
    """Return the width of one line as a multiple of the text size, without kerning.

    A letter that the font lacks counts as a square of the text size.
    """
    known = _letter_widths("DejaVuSans-Bold" if bold else "DejaVuSans")
    return sum(known.get(ord(letter), UNITS_PER_EM) for letter in line) / UNITS_PER_EM


def missing_letters(text: str) -> str:
    """Return the printable letters of a text that the font lacks."""
    known = _letter_widths("DejaVuSans")
    return "".join(letter for letter in text if ord(letter) not in known and letter.isprintable())


@lru_cache(maxsize=4096)
def text_size(text: str, weight: str = "plain") -> tuple[float, float]:
    """Return the width and height in points of a label's text, which may have lines; `weight`: its mark's."""
    style = style_of("label", "", weight)
    lines = text.split("\n")
    widest = max(text_width(line, bold=style.bold) for line in lines)
    return widest * style.size, len(lines) * style.size * LINE_HEIGHT


def wrap_text(text: str, width: float, weight: str = "plain") -> str:
    """Return the text broken at spaces into lines of at most `width` points, as full as they can be."""
    lines = [""]
    for word in text.split(" "):
        longer = f"{lines[-1]} {word}".strip()
        if lines[-1] and text_size(longer, weight)[0] > width:
            lines.append(word)
        else:
            lines[-1] = longer
    return "\n".join(lines)


@cache
def _letter_widths(face: str) -> dict[int, int]:
    """Read the table of one face: code point -> width.  tests/refresh_widths.py writes the tables and explains them."""
    table = (files(__package__) / "widths" / f"{face}.txt").read_text(encoding="ascii")
    widths: dict[int, int] = {}
    for line in table.splitlines():
        first, *runs = line.split()
        code = int(first, 16)
        for run in runs:
            count, _, width = run.rpartition("*")
            after = code + int(count or 1)
            widths.update(dict.fromkeys(range(code, after), int(width)))
            code = after
    return widths
