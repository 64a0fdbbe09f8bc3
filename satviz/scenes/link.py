"""Links to a scene on a site: the fragment after the #, which is read as strictly as a scene file.

A fragment begins with the name of a built-in scene, or with a scene file in base64url.  The view options follow,
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
from ..engine.polygon_validation import short_repr
from ..engine.shapes import Shape
from ..engine.shortcut import Shortcut
from ..engine.trace import Trace
from .named import ALL_SCENES, names, scene
from .resolve import SceneLike, resolve
from .scenefile import CHOICES, MAX_CHARS, NAME, Scene

PAGE = "scene.html"  # the site's explorer
VIEWS = "shortcut", "truth"
GOALS = ONE_AXIS, TOUCH, BREAK = "one-axis", "touch", "break"  # of a challenge
WHOLE_NUMBER = re.compile(r"[0-9]{1,6}")
# letters that a site's address must not have: of a query, of a fragment, letters that must be escaped
FORBIDDEN_LETTERS = set(" ?#\\\"'`<>")
PAGE_ENDING = re.compile(r"\.html?$", re.IGNORECASE)
DEGREE = re.compile(r"-?[0-9]{1,6}(\.[0-9]{1,12})?")


class ViewOptions(NamedTuple):
    """How a site shows a scene; None and False leave an option out.

    `free`: the angle of a free axis, in degrees counter-clockwise from x; `row`: the row of the table, counted from 0,
    whose axis is shown; `view`: one of VIEWS; `mtv`: the MTV is shown; `difference`: B - A is shown beside the scene;
    `goal`: the challenge, one of GOALS.
    The others are for the player: `step` is counted from 0, with `every_axis` in the run without the early exit;
    `predict` asks the reader for the result of each test before it is shown.
    """

    free: float | None = None
    row: int | None = None
    view: str | None = None
    mtv: bool = False
    difference: bool = False
    step: int | None = None
    predict: bool = False
    every_axis: bool = False
    goal: str | None = None


DEFAULT_VIEW = ViewOptions()


def link(what: SceneLike | Shape, b: Shape | None = None, *, site: str = "", **more: Any) -> str:
    """Return the link that opens a scene on a site, by default relative to the site's folder.

    `what` is a scene (or its name), a shape with `b`, or a trace.  Of a trace the link keeps the two shapes, whether
    every axis was tested, and the choice of axes if it has a name; otherwise the link opens the shapes with `needed`.
    `site` is the address of the site's folder, http or https.
    `more` are fields of ViewOptions: free=30.0, row=2, view="truth", mtv=True, difference=True, or for the player
    step=5, predict=True, every_axis=True; rows and steps count from 0.  InvalidScene for a name, an address or a
    value that cannot be opened again, TypeError for anything else.
    """
    found = resolve(what, b)
    run = found.given if isinstance(found.given, Trace) else None
    opened = found.scene if run is None else _scene_of(run) or Scene("scene", run.a, run.b, every_axis=run.every_axis)
    made = fragment(opened, ViewOptions(**more))
    parse_fragment(made)  # raises for options that nobody could open again
    return f"{site_folder(site)}{PAGE}#{made}"


def site_folder(site: str, name: str = "site") -> str:
    """Return the address of a site's folder, ending with a slash; an empty address stays empty.

    The address of a page, such as .../scene.html, gives its folder.
    Only http and https are taken: a link must not run a script or open a file of whoever clicks on it.
    InvalidScene for any other address, TypeError for anything but text; error lines call it `name`.
    """
    if not isinstance(site, str):
        raise TypeError(f"{name} is {short_repr(site)}: pass an address as text, such as https://example.org/satviz/")
    if not site:
        return ""
    try:
        parts = urlsplit(site)
        plain = parts.scheme in ("http", "https") and parts.hostname and (parts.port or True)
    except ValueError:  # brackets without an address in them, or a port that is not a number
        plain = False
    if not plain or set(site) & FORBIDDEN_LETTERS or not site.isprintable():
        raise InvalidScene(f"{name} is {short_repr(site)}: expected an address such as https://example.org/satviz/")
    if PAGE_ENDING.search(parts.path):
        site = site.rpartition("/")[0]
    return site if site.endswith("/") else f"{site}/"


def fragment(found: Scene, options: ViewOptions = DEFAULT_VIEW) -> str:
    """Return the part of a link after the #: the scene, by its name if it is built in, and the view options."""
    text = json.dumps(json.loads(found.to_json()), separators=(",", ":"), ensure_ascii=False)
    words = [found.name if found in ALL_SCENES else urlsafe_b64encode(text.encode()).decode().rstrip("=")]
    for key, value in options._asdict().items():
        if value is not None and value is not False:
            if isinstance(value, float):
                value = f"{value:.12f}".rstrip("0").rstrip(".")  # an exponent, or more digits, would not be opened
            words.append(f"{key.replace('_', '-')}={int(value) if value is True else value}")
    return "&".join(words)


def fragment_of_trace(trace: Trace) -> str:
    """Return the fragment that opens a trace's scene; "" if its axes have no name or it is too large."""
    found = _scene_of(trace)
    with suppress(InvalidScene):
        return fragment(found) if found else ""
    return ""


def _scene_of(trace: Trace) -> Scene | None:
    """Return the Scene that records this trace, built-in if possible; None if its axes have no name."""
    axes = next((name for name in CHOICES if _is_run_of(trace, name)), None)
    if axes is None:
        return None
    made = Scene("scene", trace.a, trace.b, axes, trace.every_axis)
    known = (s for s in ALL_SCENES if (s.a, s.b, s.axes, s.every_axis) == (made.a, made.b, made.axes, made.every_axis))
    return next(known, made)


def _is_run_of(trace: Trace, name: str) -> bool:
    """Return whether the trace was recorded with the choice of axes, or shortcut, of this name."""
    choice = CHOICES[name]
    if trace.shortcut or isinstance(choice, Shortcut):
        return choice is trace.shortcut
    return name == "needed" if trace.pairs else choice(trace.a, trace.b) == trace.choice


def parse_fragment(text: str) -> tuple[Scene, ViewOptions]:
    """Return the scene and the view options of a fragment; InvalidScene says what is wrong with it."""
    if len(text) > 2 * MAX_CHARS:
        raise InvalidScene(f"the link has {len(text):,} characters: the limit is {2 * MAX_CHARS:,}; use a scene file")
    first, *rest = text.split("&")
    values: dict[str, Any] = {}
    for word in rest:
        key, _, value = word.partition("=")
        if key.replace("-", "_") not in ViewOptions._fields:
            known = ", ".join(ViewOptions._fields).replace("_", "-")
            raise InvalidScene(f"the link has the unknown option {key[:40]!r}: choose one of {known}")
        if key.replace("-", "_") in values:
            raise InvalidScene(f"the link has the option {key[:40]!r} twice: give it once")
        values[key.replace("-", "_")] = _parse_value(key, value)
    found = _scene_of_name(first) if NAME.fullmatch(first) else _decode_scene(first)
    return found, ViewOptions(**values)


def _scene_of_name(name: str) -> Scene:
    """Return the built-in scene of this name; InvalidScene, without a list of names, if there is none."""
    if name not in names():
        raise InvalidScene(f"no scene is called {short_repr(name)}: correct the name in the link")
    return scene(name)


def _decode_scene(text: str) -> Scene:
    """Return the scene from a scene file's text in base64url; InvalidScene if it cannot be read."""
    try:
        raw = b64decode(text.encode() + b"=" * (-len(text) % 4), altchars=b"-_", validate=True)
        return Scene.from_json(raw.decode())
    except (Error, UnicodeError, InvalidScene) as error:
        readable = isinstance(error, InvalidScene) and not isinstance(error.__context__, json.JSONDecodeError)
        why = error if readable else "it is cut off, or not a link of satviz; copy the whole link again"
        raise InvalidScene(f"the scene in the link cannot be read: {why}") from None


def _parse_value(key: str, text: str) -> Any:
    """Return the value that `text` stands for in the view option `key`; InvalidScene if it has none."""
    if key == "free" and DEGREE.fullmatch(text) and isfinite(float(text)):
        return float(text)
    if key in ("row", "step") and WHOLE_NUMBER.fullmatch(text):
        return int(text)
    if key in ("view", "goal"):
        choices = VIEWS if key == "view" else GOALS
        if text in choices:
            return text
        what = "view" if key == "view" else "challenge"
        raise InvalidScene(f"no {what} is called {short_repr(text)}: choose one of {', '.join(choices)}")
    if key in ("mtv", "difference", "predict", "every-axis") and text == "1":
        return True
    expected = {"free": "an angle in degrees", "row": "a whole number", "step": "a whole number"}.get(key, f"{key}=1")
    raise InvalidScene(f"the link has {key}={text[:40]!r}: expected {expected}")
