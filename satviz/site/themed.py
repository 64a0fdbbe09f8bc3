"""A drawn SVG that follows the reader's theme and obeys a strict policy: no style of its own, colours as variables."""

import re

from ..pictures import DARK, LIGHT, Theme

_STYLE = re.compile(r' style="([^"]*)"')
_COLOUR = re.compile(r"#[0-9a-f]{6}\b")
_IDS = re.compile(r' id="([^"]+)"')
_LABELS = re.compile(r' aria-labelledby="[^"]*"')  # its title names a picture by itself
_OWN = re.compile(r"\s*<defs>\s*<style[^>]*>[^<]*</style>\s*</defs>")


def _named(theme: Theme) -> dict[str, str]:
    roles = {f"text-{role}": theme.text.get(role, colour) for role, colour in theme.roles.items()}
    return {"paper": theme.paper, **theme.roles, **roles}


_ROLES = {colour.lower(): role for role, colour in reversed(_named(LIGHT).items())}


def themed(svg: str) -> str:
    """The SVG element for a page: styles as attributes, colours as variables, no ids but those that are meant."""
    found = _LABELS.sub("", _OWN.sub("", svg))
    # many pictures on a page would share the numbers that matplotlib gives its parts
    found = _IDS.sub(lambda match: match[0] if f"#{match[1]}" in found else "", found)
    return _STYLE.sub(lambda match: _attributes(match[1]), found).replace("<svg ", '<svg class="picture" ', 1)


def _attributes(style: str) -> str:
    pairs = [part.partition(":") for part in style.split(";") if part.strip()]
    return "".join(f' {name.strip()}="{_variable(value.strip())}"' for name, _, value in pairs)


def _variable(text: str) -> str:
    return _COLOUR.sub(lambda match: f"var(--sv-{_ROLES[match[0]]})" if match[0] in _ROLES else match[0], text)


def themed_file(svg: bytes) -> bytes:
    """The same for an SVG file, which brings both themes' colours with it."""
    light, dark = (" ".join(f"--sv-{role}: {colour};" for role, colour in _named(t).items()) for t in (LIGHT, DARK))
    rules = f":root {{ {light} }} @media (prefers-color-scheme: dark) {{ :root {{ {dark} }} }}"
    text = svg.decode().replace("*{stroke-linejoin", f"{rules} *{{stroke-linejoin", 1)
    return _STYLE.sub(lambda match: f' style="{_variable(match[1])}"', text).encode()
