"""The browser's side, put together from its files: one module of JavaScript, one style sheet with the themes."""

import re
from functools import cache
from importlib.resources import files

from ..pictures import DARK, LIGHT, Theme

# one module needs none between its files
_EXPORT = re.compile(r"^export (?=class|function|async function)", re.MULTILINE)
_REMARK = re.compile(r"^ *//.*\n", re.MULTILINE)  # for who reads the source; each page to share would carry them


@cache
def javascript(*names: str) -> str:
    """The named files (pen, player ...) as one module."""
    return "\n".join(_EXPORT.sub("", _REMARK.sub("", _file(f"{name}.js"))) for name in names)


@cache
def stylesheet() -> str:
    """The style sheet, with the colours of both themes as variables."""
    light, dark = (_variables(theme) for theme in (LIGHT, DARK))
    rules = [f".satviz {{ {light} }}", f"@media (prefers-color-scheme: dark) {{ .satviz {{ {dark} }} }}"]
    # as the page around it is, which may be another than the system's
    for theme, own in ("light", light), ("dark", dark):
        rules.append(f'.satviz[data-theme="{theme}"] {{ {own} }}')
    rules.append(f"@media print {{ .satviz, .satviz[data-theme] {{ {light} }} }}")
    return "\n".join([*rules, _file("satviz.css")])


def _variables(theme: Theme) -> str:
    scheme = {"light": "light", "dark": "dark"}[theme.name]
    pairs = [("paper", theme.paper), *theme.roles.items()]
    pairs += [(f"text-{role}", theme.text.get(role, colour)) for role, colour in theme.roles.items()]
    return " ".join(f"--sv-{name}: {colour};" for name, colour in pairs) + f" color-scheme: {scheme};"


def _file(name: str) -> str:
    return (files(__package__) / "browser" / name).read_text(encoding="utf-8")
