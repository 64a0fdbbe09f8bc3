"""The Python side of a page: it answers the messages of each explorer on the page.  (Standard library only.)"""

import json
from typing import Any

from ..checking.page import MESSAGES, PageCheck
from ..checking.reading import ReaderPython
from ..engine.geometry import InvalidScene
from ..pictures.playback import narrow_playbacks, playbacks
from ..scenes.article import SCENES
from ..scenes.failing import FAILURE_CASES, REFUSED
from ..scenes.link import DEFAULT_VIEW, ViewOptions, fragment, parse_fragment
from ..scenes.scenefile import Scene, shape_data
from ..scenes.strictjson import require_type
from ..widgets.explorer_model import ExplorerModel
from ..widgets.goals import GOAL_NAMES

_models: dict[str, ExplorerModel] = {}  # by the place on the page
_check, _reader = PageCheck(), ReaderPython()  # the latter is used in the worker of the reader's code alone
CHOICES = {
    "presets": [s.name for s in SCENES],
    "failing": [row.name for row in FAILURE_CASES if row.how != REFUSED],
    "challenges": GOAL_NAMES,
}


def answer(place: str, text: str) -> str:
    """Return the JSON reply to a JSON message; `place`: the explorer's id on the page; "" for an unknown message."""
    content = json.loads(text)
    if content.get("kind") == "open":
        reply: dict[str, Any] | None = _open(place, content)
    elif content.get("kind") in MESSAGES:
        reply = _check.answer(content)
    elif content.get("kind") in ("define", "call"):
        reply = _reader.answer(content)
    else:
        reply = _models[place].answer(content) if place in _models else None
    return "" if reply is None else json.dumps(reply, ensure_ascii=False, separators=(",", ":"))


def _open(place: str, content: dict[str, Any]) -> dict[str, Any]:
    """Return the reply to an "open" message: an explorer's state, a player's steps, or why the link is refused."""
    try:
        scene, shown = parse_fragment(require_type(content.get("hash"), "the link", str))
        if shown.step is not None or shown.predict or shown.rest:
            return _player_data(scene, shown)
        model = ExplorerModel(scene, shown.goal)
        pose: dict[str, Any] = {
            "degree": shown.free,
            "wayOut": shown.way_out,
            "against": shown.against,
            "pinned": shown.row,
        }
        pose |= {"view": shown.view} if shown.view else {}
        if shown._replace(goal=None) != DEFAULT_VIEW:
            reply = model.answer({"kind": "pose", "a": shape_data(scene.a), "b": shape_data(scene.b), **pose})
            if reply and reply["kind"] == "refused":
                raise InvalidScene(reply["why"])
    except ValueError as error:
        return {"kind": "refused", "why": str(error)}
    _models[place] = model
    return {"kind": "opened", "title": scene.title, "first": model.state(), "pose": pose, **CHOICES}


def _player_data(scene: Scene, shown: ViewOptions) -> dict[str, Any]:
    """Return a player's steps and its first one; a prediction uses the true run, not that of a shortcut."""
    trace = scene.record()
    trace = trace.truth if shown.predict and trace.shortcut else trace
    shows = playbacks(trace)
    found: dict[str, Any] = {"kind": "opened", "title": scene.title, "shows": shows, "narrow": narrow_playbacks(trace)}
    rest = shown.rest and len(shows) > 1
    found |= {"step": min(shown.step or 0, len(shows[rest]["steps"]) - 1), "predict": shown.predict, "rest": rest}
    return found | {"link": fragment(scene)}
