"""Tables with a header, as CSV, in Markdown or with spaces: each row is an object with keys, or a corner."""

import re
from collections.abc import Iterator, Sequence
from itertools import groupby
from typing import NamedTuple

from .notations import key
from .tokens import CLOSE, MARK, NAME, NUMBER, OPEN, Token, tokens

_WORD = re.compile(r"[A-Za-z_][\w .]*|\(index\)")
_RULE = re.compile(r"[\s|:+=\u2500-\u257f-]+")
_IDENTIFIER = re.compile(r"[^\W\d]\w*")
_POINT = re.compile(r"[(\[{].*[)\]}]")
_COLUMNS = {mark: re.compile(rf"[^{mark}]+") for mark in "|\u2502,;\t"}
_SPACED = re.compile(r"\S+")
BARS = ("|", "\u2502")
CORNERS = ("x1", "y1", "x2", "y2")
MAX_LINE = 400  # characters of a line of a table


class TableCell(NamedTuple):
    """A cell or a line of a table: its text, and the index in the pasted text where it begins."""

    text: str
    at: int


class Table(NamedTuple):
    """The names of the columns, the rows, and where the table begins and ends."""

    names: list[str]
    rows: list[list[TableCell]]
    start: int
    end: int


def tables(text: str) -> Iterator[tuple[int, int, list[Token]]]:
    """Yield (start, end, tokens) for each table of a text, with the tokens of objects or of lists of points."""
    lines = list(_lines(text))
    number = 0
    while number < len(lines):
        table, number = _table(lines, number)
        if table is not None and (found := list(_tokens(table))):
            yield table.start, table.end, found


def _lines(text: str) -> Iterator[TableCell]:
    """Yield the lines of a text."""
    at = 0
    for line in text.split("\n"):
        yield TableCell(line, at)
        at += len(line) + 1


def _cells(line: TableCell, mark: str) -> list[TableCell]:
    """Return the cells of a line without spaces around them."""
    if len(line.text) > MAX_LINE:
        return []
    found = ((m[0], line.at + m.start()) for m in _COLUMNS.get(mark, _SPACED).finditer(line.text))
    return [TableCell(part.strip(), at + len(part) - len(part.lstrip())) for part, at in found if part.strip()]


def _table(lines: Sequence[TableCell], number: int) -> tuple[Table | None, int]:
    """Return (table whose header is this line or None, number of the first line after it)."""
    header = lines[number]
    mark = next((m for m in _COLUMNS if m in header.text), " ")
    names = [{"#": "id", "d": "diameter"}.get(cell.text, cell.text) for cell in _cells(header, mark)]
    after = number + 1
    if len(names) < 2 or not all(_WORD.fullmatch(name) for name in names):
        return None, after
    lower = {name.lower() for name in names}
    # the corners of a box; with x3 they are those of a triangle
    corners = lower & set(CORNERS) if "x3" not in lower else set()
    known = {key(name) for name in names} - {""} | corners
    owned = sum(bool(key(re.split(r"[_ .]", name)[-1])) for name in names)  # player_x, player_y
    if len(known) < 2 and owned < 2 and mark not in BARS:
        return None, after
    indexed = header.text[:1] in (" ", ",", "\t")  # pandas writes the number of a row under no name
    rows = []
    while after < len(lines):
        line = lines[after]
        if line.text.isspace() or (mark in BARS and _RULE.fullmatch(line.text or "x")):  # a line that a change removes
            after += 1
            continue
        cells = _cells(line, mark)
        if indexed and len(cells) == len(names) + 1 and re.fullmatch(r"\w+", cells[0].text):
            cells = cells[1:]
        if len(cells) != len(names) or not any(c.isdigit() for c in line.text):
            break
        rows.append(cells)
        after += 1
    if not rows:
        return None, number + 1
    last = rows[-1][-1]
    return Table(names, rows, header.at, last.at + len(last.text)), after


def _tokens(table: Table) -> Iterator[Token]:
    """Yield the tokens of a table of shapes or points; none for a table of other things."""
    columns = {key(name): i for i, name in enumerate(table.names) if key(name)}
    names = [name.lower() for name in table.names]
    columns.update({name: i for i, name in enumerate(names) if name in CORNERS})
    columns.pop("points", None)  # poly, x, y: the name of the polygon
    numeric = all(len(_numbers(row[i])) == 1 for row in table.rows for i in columns.values())
    boxed = any(all(name in columns for name in wanted) for wanted in _OBJECTS)
    sized = not _SIZES.isdisjoint({*columns, *names})
    if boxed and numeric:
        for row in table.rows:
            yield from _object(table.names, row)
    elif sized and numeric:
        yield from _unknown(table)
    elif {"x", "y"} <= set(columns) and numeric:
        yield from _outlines(table, columns["x"], columns["y"])
    elif all(_POINT.fullmatch(cell.text) and len(_numbers(cell)) == 2 for row in table.rows for cell in row):
        for column in zip(*table.rows, strict=True):
            yield from _list([_numbers(cell) for cell in column])
    elif len(names) > 3 and all(len(_numbers(cell)) == 1 for row in table.rows for cell in row):
        yield from _unknown(table)


_OBJECTS = (
    ("x", "y", "radius"),
    ("x", "y", "diameter"),
    ("x", "y", "width", "height"),
    ("x", "y", "halfwidth", "halfheight"),
    ("x0", "y0", "x1", "y1"),
    CORNERS,
    ("x0", "y0", "width", "height"),
)
_SIZES = frozenset(["size", "half", "halfwidth", "halfheight", "radius", "width", "height", "rx", "ry"])


def _object(names: Sequence[str], row: Sequence[TableCell]) -> Iterator[Token]:
    """Yield a row as an object; a first cell that is a word is its name."""
    at = row[0].at
    if _IDENTIFIER.fullmatch(row[0].text):
        yield Token(NAME, row[0].text, at, at)
        yield Token(MARK, "=", at, at)
    yield Token(OPEN, "{", at, at)
    for name, cell in zip(names, row, strict=True):
        if values := _numbers(cell):
            yield Token(NAME, re.sub(r"\W", "_", name), cell.at, cell.at)
            yield Token(MARK, ":", cell.at, cell.at)
            yield from values
            yield Token(MARK, ",", cell.at, cell.at)
    end = row[-1].at + len(row[-1].text)
    yield Token(CLOSE, "}", end, end)
    yield Token(MARK, ";", end, end)


def _unknown(table: Table) -> Iterator[Token]:
    """Yield a table of numbers that are no shapes one can tell, so that they are not taken for lists of corners."""
    at = table.start
    yield Token(NAME, "unknown.table", at, at)
    yield Token(OPEN, "(", at, at)
    for row in table.rows:
        for cell in row:
            yield from (*_numbers(cell), Token(MARK, ",", cell.at, cell.at))
    yield Token(CLOSE, ")", table.end, table.end)
    yield Token(MARK, ";", table.end, table.end)


def _outlines(table: Table, x: int, y: int) -> Iterator[Token]:
    """Yield the tokens of one list of corners for each shape; `x`, `y`: the columns of the coordinates.

    Rows of one shape are neighbours with the same name in the first column, if names repeat there; otherwise the whole
    table is one shape.
    """
    names = [row[0].text for row in table.rows]
    by_shape = min(x, y) > 0 and max(len(list(rows)) for _, rows in groupby(names)) > 2
    for _, rows in groupby(table.rows, key=lambda row: row[0].text if by_shape else ""):
        yield from _list([[*_numbers(row[x]), *_numbers(row[y])] for row in rows])


def _list(points: Sequence[Sequence[Token]]) -> Iterator[Token]:
    """Yield the tokens of a list of points, [(x, y), (x, y)], from the tokens of their numbers."""
    at = points[0][0].start
    yield Token(OPEN, "[", at, at)
    for first, second in points:
        yield Token(OPEN, "(", first.start, first.start)
        yield first
        yield Token(MARK, ",", first.end, first.end)
        yield second
        yield Token(CLOSE, ")", second.end, second.end)
        yield Token(MARK, ",", second.end, second.end)
    end = points[-1][1].end
    yield Token(CLOSE, "]", end, end)
    yield Token(MARK, ";", end, end)


def _numbers(cell: TableCell) -> list[Token]:
    """Return the numbers of a cell."""
    if not any(c.isdigit() for c in cell.text):
        return []
    found = tokens(cell.text)
    if not all(token.kind in (NUMBER, OPEN, CLOSE) or token.text == "," for token in found):
        return []
    return [t._replace(start=t.start + cell.at, end=t.end + cell.at) for t in found if t.kind == NUMBER]
