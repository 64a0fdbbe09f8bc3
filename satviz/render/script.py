"""The browser's code, joined from its files: one module of JavaScript, and one style sheet with both themes."""

import re
from functools import cache
from importlib.resources import files
from posixpath import dirname, normpath

from ..pictures import DARK, LIGHT, Theme

_PACKAGE = __package__.partition(".")[0]
_IMPORT = re.compile(r'^import .* from "(\..*)";\n', re.MULTILINE)
_EXPORT = re.compile(r"^export (?=class|const|function|async function)", re.MULTILINE)
# Comments, types, empty lines and indentation are for readers of the source; each page to share would carry them.
_COMMENT = re.compile(r"^ *//.*\n| // .*$|^ */\*\*[\s\S]*?\*/\n|/\*\*.*?\*/ ?|^\n", re.MULTILINE)
_INDENT = re.compile(r"^ +", re.MULTILINE)  # no string of ours goes over two lines


@cache
def javascript(*names: str) -> str:
    """Return the named files of `render/browser` and all their imports as one JavaScript module.

    Their top-level names share one scope, so no two files may declare the same one.
    """
    found: dict[str, str] = {}
    for name in names:
        _collect(normpath(f"render/browser/{name}.js"), found)
    return "\n".join(found.values())


def _collect(path: str, found: dict[str, str]) -> None:
    """Add a file's source to `found`, after the sources of the files that it imports."""
    if path in found:
        return
    source = (files(_PACKAGE) / path).read_text(encoding="utf-8")
    for imported in _IMPORT.findall(source):
        _collect(normpath(f"{dirname(path)}/{imported}"), found)
    for left_out in _COMMENT, _INDENT, _IMPORT, _EXPORT:
        source = left_out.sub("", source)
    found[path] = source


@cache
def stylesheet() -> str:
    """Return the style sheet, with the colours of both themes as variables."""
    light, dark = (f"{colour_variables(theme)} color-scheme: {theme.name};" for theme in (LIGHT, DARK))
    rules = [f".satviz {{ {light} }}", f"@media (prefers-color-scheme: dark) {{ .satviz {{ {dark} }} }}"]
    # A widget follows the theme of the page around it, which can differ from the system's.
    for theme, own in ("light", light), ("dark", dark):
        rules.append(f'.satviz[data-theme="{theme}"] {{ {own} }}')
    rules.append(f"@media print {{ .satviz, .satviz[data-theme] {{ {light} }} }}")
    return "\n".join([*rules, (files(__package__) / "browser" / "satviz.css").read_text(encoding="utf-8")])


def theme_colours(theme: Theme) -> dict[str, str]:
    """Return the colours of a theme, keyed by the names of their CSS variables without the prefix."""
    texts = {f"text-{role}": theme.text.get(role, colour) for role, colour in theme.roles.items()}
    return {"paper": theme.paper, **theme.roles, **texts}


def colour_variables(theme: Theme) -> str:
    """Return the CSS declarations of a variable for each colour of a theme."""
    return " ".join(f"--sv-{name}: {colour};" for name, colour in theme_colours(theme).items())
