"""Write how wide the letters of DejaVu Sans are, from matplotlib's copy of the font, to where pictures read it.

    python tests/refresh_widths.py

A line is a stretch of code points without holes: the first one in hex, then each letter's width in units of
1/2048 of the text size; n*w stands for n letters of width w.
"""

from itertools import groupby
from pathlib import Path

import matplotlib
from fontTools.ttLib import TTFont

import satviz.pictures

FACES = "DejaVuSans", "DejaVuSans-Bold"
TABLES = Path(satviz.pictures.__file__).parent / "widths"


def widths(face: str) -> dict[int, int]:
    """Return code point -> width for all letters of a face."""
    with TTFont(Path(matplotlib.get_data_path()) / "fonts" / "ttf" / f"{face}.ttf") as font:
        assert font["head"].unitsPerEm == 2048
        return {code: font["hmtx"][glyph][0] for code, glyph in sorted(font.getBestCmap().items())}


def table(face: str) -> str:
    """Return the text of a face's table."""
    lines = []
    for _, stretch in groupby(enumerate(widths(face).items()), key=lambda at: at[1][0] - at[0]):
        letters = [letter for _, letter in stretch]
        runs = [(width, len(list(run))) for width, run in groupby(width for _, width in letters)]
        words = (f"{n}*{width}" if n > 1 else str(width) for width, n in runs)
        lines.append(f"{letters[0][0]:x} {' '.join(words)}\n")
    return "".join(lines)


def main() -> None:
    """Write the tables of all faces."""
    for face in FACES:
        path = TABLES / f"{face}.txt"
        path.write_text(table(face), encoding="ascii")
        print(f"{path.name}: {path.stat().st_size / 1000:.0f} kB")


if __name__ == "__main__":
    main()
