"""Other fonts of this machine for letters that DejaVu Sans lacks, in files that cannot leave the choice to a reader."""

import warnings
from collections.abc import Iterable
from functools import lru_cache

from matplotlib.font_manager import fontManager
from matplotlib.ft2font import FT2Font

from ..pictures import letters

OWN_FAMILY = "DejaVu Sans"


def families(texts: Iterable[str], form: str) -> list[str]:
    """Return DejaVu Sans and this machine's fonts for letters of the texts that it lacks.

    Warn of letters that no font has, so that they are missing in the file format `form`.
    """
    found, without = [OWN_FAMILY], ""
    for letter in sorted(set(letters.missing_letters("".join(texts)))):
        family = _family_with(letter)
        if family is None:
            without += letter
        elif family not in found:
            found.append(family)
    if without:
        warnings.warn(
            f"no font here has {', '.join(without)}, so {form.upper()} shows empty squares: install a font that has "
            "them, or make an SVG, which shows them in the reader's own font",
            stacklevel=3,
        )
    return found


@lru_cache(maxsize=256)
def _family_with(letter: str) -> str | None:
    """Return the first font family, by name, that has the letter."""
    for font in sorted(fontManager.ttflist, key=lambda font: (font.name, font.fname)):
        if font.style == "normal" and "last resort" not in font.name.lower() and ord(letter) in _letters_of(font.fname):
            return str(font.name)
    return None


@lru_cache(maxsize=256)
def _letters_of(path: str) -> frozenset[int]:
    """Return the letters that a font file has."""
    try:
        return frozenset(FT2Font(path).get_charmap())
    except (OSError, RuntimeError):  # a font that cannot be read has none
        return frozenset()
