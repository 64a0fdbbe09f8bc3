"""How wide letters of DejaVu Sans are, out of tables, so that a picture can be laid out where no font is at hand."""

from functools import cache
from importlib.resources import files

EM = 2048  # the tables' unit is 1/EM of the text size


def text_width(line: str, *, bold: bool = False) -> float:
    """A line's width as a part of the text size, without kerning; a letter the font lacks is a full square."""
    known = _widths("DejaVuSans-Bold" if bold else "DejaVuSans")
    return sum(known.get(ord(letter), EM) for letter in line) / EM


def missing_letters(text: str) -> str:
    """The letters of a text that the font does not have."""
    known = _widths("DejaVuSans")
    return "".join(letter for letter in text if ord(letter) not in known and letter.isprintable())


@cache
def _widths(face: str) -> dict[int, int]:
    """Code point -> width; tests/refresh_widths.py writes the tables and tells how."""
    table = (files(__package__) / "widths" / f"{face}.txt").read_text(encoding="ascii")
    found: dict[int, int] = {}
    for line in table.splitlines():
        first, *runs = line.split()
        code = int(first, 16)
        for run in runs:
            n, _, one = run.rpartition("*")
            after = code + int(n or 1)
            found.update(dict.fromkeys(range(code, after), int(one)))
            code = after
    return found
