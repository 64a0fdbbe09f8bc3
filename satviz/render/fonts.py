"""Letters that DejaVu Sans lacks, out of other fonts of this machine, for files that cannot leave it to the reader."""

import warnings
from collections.abc import Iterable
from functools import lru_cache

from matplotlib.font_manager import fontManager
from matplotlib.ft2font import FT2Font

from ..pictures import letters

OWN = "DejaVu Sans"


def families(texts: Iterable[str], form: str) -> list[str]:
    """The fonts to write these texts in, for a file of that form; a warning names letters that no font here has."""
    found, without = [OWN], ""
    for letter in sorted(set(letters.missing_letters("".join(texts)))):
        family = _with(letter)
        if family is None:
            without += letter
        elif family not in found:
            found.append(family)
    if without:
        warnings.warn(
            f"no font here has {', '.join(without)}: empty squares in {form.upper()}; install a font that has "
            "them, or make an SVG, which shows them in the reader's own font",
            stacklevel=3,
        )
    return found


@lru_cache(maxsize=256)
def _with(letter: str) -> str | None:
    """A font family that has the letter, the first by name."""
    for font in sorted(fontManager.ttflist, key=lambda font: (font.name, font.fname)):
        if font.style == "normal" and "last resort" not in font.name.lower() and ord(letter) in _letters(font.fname):
            return str(font.name)
    return None


@lru_cache(maxsize=256)
def _letters(path: str) -> frozenset[int]:
    try:
        return frozenset(FT2Font(path).get_charmap())
    except (OSError, RuntimeError):  # a font that cannot be read has none
        return frozenset()
