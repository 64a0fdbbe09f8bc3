"""Drawn SVGs that follow the reader's theme.

Colours become CSS variables.  Styles become attributes, because the pages' security policy forbids inline styles.
"""

import re

from ..pictures import DARK, LIGHT
from ..render.script import colour_variables, theme_colours

_STYLE = re.compile(r' style="([^"]*)"')
_COLOUR = re.compile(r"#[0-9a-f]{6}\b")
_IDS = re.compile(r' id="([^"]+)"')
_LABELS = re.compile(r' aria-labelledby="[^"]*"')  # not needed: the title element names the picture
_COORDINATES = re.compile(r' (?:d|x|y)="[^"]*"')
_FINE_DIGITS = re.compile(r"(\.\d\d)\d+")  # digits beyond hundredths of a point, which nobody sees
_INDENT = re.compile(r"\n +")
_STYLE_ELEMENT = re.compile(r"\s*<defs>\s*<style[^>]*>[^<]*</style>\s*</defs>")


_VARIABLES = {colour.lower(): role for role, colour in reversed(theme_colours(LIGHT).items())}


def themed_svg(svg: str) -> str:
    """Return an SVG element for a page: styles as attributes, colours as CSS variables, no unused ids."""
    found = _LABELS.sub("", _STYLE_ELEMENT.sub("", svg))
    found = _INDENT.sub("\n", found)
    found = _COORDINATES.sub(lambda match: _FINE_DIGITS.sub(r"\1", match[0]), found)
    # matplotlib numbers the parts of each picture, so two pictures on a page would share ids
    found = _IDS.sub(lambda match: match[0] if f"#{match[1]}" in found else "", found)
    return _STYLE.sub(lambda match: _style_as_attributes(match[1]), found).replace("<svg ", '<svg class="picture" ', 1)


def _style_as_attributes(style: str) -> str:
    """Return the declarations of an inline style as SVG attributes."""
    pairs = [part.partition(":") for part in style.split(";") if part.strip()]
    return "".join(f' {name.strip()}="{_with_variables(value.strip())}"' for name, _, value in pairs)


def _with_variables(text: str) -> str:
    """Return the text with each colour of the light theme replaced by its CSS variable."""
    return _COLOUR.sub(lambda match: f"var(--sv-{_VARIABLES[match[0]]})" if match[0] in _VARIABLES else match[0], text)


def themed_svg_file(svg: bytes) -> bytes:
    """Return an SVG file with the colours of both themes in it, so that it follows the reader's theme by itself."""
    light, dark = map(colour_variables, (LIGHT, DARK))
    rules = f":root {{ {light} }} @media (prefers-color-scheme: dark) {{ :root {{ {dark} }} }}"
    text = svg.decode().replace("*{stroke-linejoin", f"{rules} *{{stroke-linejoin", 1)
    return _STYLE.sub(lambda match: f' style="{_with_variables(match[1])}"', text).encode()
