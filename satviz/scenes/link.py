"""A scene as a link: what stands behind the # of a site's explorer, read as strictly as a scene file.

A built-in scene is its name; any other is its scene file in base64url.  What is shown of it follows,
`&key=value` each: far-centers&view=truth, eyJzYXR2aXoi...&free=30, triangles&step=5&predict=1.
"""

import json
import re
from base64 import b64decode, urlsafe_b64encode
from binascii import Error
from contextlib import suppress
from math import isfinite
from typing import Any, NamedTuple
from urllib.parse import urlsplit

from ..engine.geometry import InvalidScene
from ..engine.polygon_validation import shown
from ..engine.shapes import Shape
from ..engine.shortcut import Shortcut
from ..engine.trace import Trace
from .named import ALL_SCENES, names, scene
from .resolve import SceneLike, resolve
from .scenefile import CHOICES, MAX_CHARS, NAME, Scene

PAGE = "scene.html"  # the site's explorer
VIEWS = "shortcut", "truth"
GOALS = ONE_AXIS, TOUCH, BREAK = "one-axis", "touch", "break"  # what a challenge asks
WHOLE = re.compile(r"[0-9]{1,6}")
FORBIDDEN = set(" ?#\\\"'`<>")  # in the address of a site: a query, a fragment, and what no address holds unescaped
A_PAGE = re.compile(r"\.html?$", re.IGNORECASE)
DEGREE = re.compile(r"-?[0-9]{1,6}(\.[0-9]{1,12})?")


class Shown(NamedTuple):
    """What of a scene is shown: a free axis in degrees, a row, a view; a step of the player (`rest`: among those of
    every axis, also where the run stops before); a challenge's goal."""

    free: float | None = None
    row: int | None = None
    view: str | None = None
    way_out: bool = False
    against: bool = False
    step: int | None = None
    predict: bool = False
    rest: bool = False
    goal: str | None = None


AS_IT_COMES = Shown()


def link(what: SceneLike | Shape, b: Shape | None = None, *, site: str = "", **more: Any) -> str:
    """The link that opens a scene on a site, by default relative to the site's folder.

    Of a scene (or its name), two shapes, or a trace.  Of a trace the link keeps the two shapes, whether every
    axis was tested, and the choice of axes where it has a name; else the link opens the shapes with `needed`.
    `site` is the address of the site's folder, http or https.
    `more` says what is shown: free=30.0, row=2, view="truth", way_out=True, against=True, or for the
    player step=5, predict=True, rest=True.  InvalidScene for a name, an address or a value that cannot be
    opened again, TypeError for anything else.
    """
    if isinstance(what, Trace) and b is None:
        found = _scene_of(what) or Scene("scene", what.a, what.b, every_axis=what.every_axis)
    else:
        found = resolve(what, b).scene
    made = fragment(found, Shown(**more))
    opened(made)
    return f"{folder_of(site)}{PAGE}#{made}"


def folder_of(site: str, name: str = "site") -> str:
    """Check the address of a site's folder and end it with a slash; the empty address stays as it is.

    Of the address of a page, such as .../scene.html, the folder is taken.
    Only http and https: a link must not run a script or open a file of whoever clicks on it.  InvalidScene for
    any other address, TypeError for what is no text; `name` is what they call it.
    """
    if not isinstance(site, str):
        raise TypeError(f"{name} is {shown(site)}: pass an address as text, such as https://example.org/satviz/")
    if not site:
        return ""
    try:
        parts = urlsplit(site)
        plain = parts.scheme in ("http", "https") and parts.hostname and (parts.port or True)
    except ValueError:  # brackets or a port that are none
        plain = False
    if not plain or set(site) & FORBIDDEN or not site.isprintable():
        raise InvalidScene(f"{name} is {shown(site)}: expected an address such as https://example.org/satviz/")
    if A_PAGE.search(parts.path):
        site = site.rpartition("/")[0]
    return site if site.endswith("/") else f"{site}/"


def fragment(found: Scene, shown: Shown = AS_IT_COMES) -> str:
    """What stands behind the #."""
    text = json.dumps(json.loads(found.to_json()), separators=(",", ":"), ensure_ascii=False)
    words = [found.name if found in ALL_SCENES else urlsafe_b64encode(text.encode()).decode().rstrip("=")]
    for key, value in shown._asdict().items():
        if value is not None and value is not False:
            if isinstance(value, float):
                value = f"{value:.12f}".rstrip("0").rstrip(".")  # an exponent, or more digits, would not be opened
            words.append(f"{key.replace('_', '-')}={int(value) if value is True else value}")
    return "&".join(words)


def of_trace(trace: Trace) -> str:
    """What stands behind the # for a trace's scene; empty where its axes have no name, or a shape is too large."""
    found = _scene_of(trace)
    with suppress(InvalidScene):
        return fragment(found) if found else ""
    return ""


def _scene_of(trace: Trace) -> Scene | None:
    """The scene that a trace is the run of, the built-in one if there is one; None where its axes have no name."""
    axes = next((name for name in CHOICES if _is_of(trace, name)), None)
    if axes is None:
        return None
    made = Scene("scene", trace.a, trace.b, axes, trace.every_axis)
    known = (s for s in ALL_SCENES if (s.a, s.b, s.axes, s.every_axis) == (made.a, made.b, made.axes, made.every_axis))
    return next(known, made)


def _is_of(trace: Trace, name: str) -> bool:
    """Is it a run of the choice of axes of that name?"""
    choice = CHOICES[name]
    if trace.shortcut or isinstance(choice, Shortcut):
        return choice is trace.shortcut
    return name == "needed" if trace.pairs else choice(trace.a, trace.b) == trace.choice


def opened(text: str) -> tuple[Scene, Shown]:
    """The scene of a link and what is shown of it; InvalidScene says what is wrong."""
    if len(text) > 2 * MAX_CHARS:
        raise InvalidScene(f"the link has {len(text):,} letters: the limit is {2 * MAX_CHARS:,}")
    first, *rest = text.split("&")
    values: dict[str, Any] = {}
    for word in rest:
        key, _, value = word.partition("=")
        if key.replace("-", "_") not in Shown._fields or key.replace("-", "_") in values:
            raise InvalidScene(f"the link says {key[:40]!r}, which is unknown or said twice")
        values[key.replace("-", "_")] = _value(key, value)
    return _named(first) if NAME.fullmatch(first) else _decoded(first), Shown(**values)


def _named(name: str) -> Scene:
    if name not in names():  # a page offers them itself
        raise InvalidScene(f"no scene is called {shown(name)}")
    return scene(name)


def _decoded(text: str) -> Scene:
    """The scene of a file in base64url; one that was cut off is not even base64, or its JSON does not end."""
    try:
        raw = b64decode(text.encode() + b"=" * (-len(text) % 4), altchars=b"-_", validate=True)
        return Scene.from_json(raw.decode())
    except (Error, UnicodeError, InvalidScene) as error:
        readable = isinstance(error, InvalidScene) and not isinstance(error.__context__, json.JSONDecodeError)
        why = error if readable else "it is cut off or not one of satviz"
        raise InvalidScene(f"the link holds no scene: {why}") from None


def _value(key: str, text: str) -> Any:
    if key == "free" and DEGREE.fullmatch(text) and isfinite(float(text)):
        return float(text)
    if key in ("row", "step") and WHOLE.fullmatch(text):
        return int(text)
    if key in ("view", "goal"):
        choices = VIEWS if key == "view" else GOALS
        if text in choices:
            return text
        what = "view" if key == "view" else "challenge"
        raise InvalidScene(f"no {what} is called {shown(text)}: choose one of {', '.join(choices)}")
    if key in ("way-out", "against", "predict", "rest") and text == "1":
        return True
    raise InvalidScene(f"the link says {key}={text[:40]!r}, which means nothing")
