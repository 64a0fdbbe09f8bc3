"""The Python side of a page: it answers the messages of each explorer on the page.  (Standard library only.)"""

import json
from typing import Any

from ..checking.page import MESSAGES, PageCheck
from ..checking.reading import ReaderPython
from ..engine.geometry import InvalidScene
from ..pictures.playback import narrow_playbacks, playbacks
from ..scenes.embedding import EmbedOptions, parse_query
from ..scenes.link import BREAK, DEFAULT_VIEW, TOUCH, ViewOptions, fragment, parse_fragment
from ..scenes.scenefile import Scene
from ..scenes.strictjson import require_type
from ..widgets.explorer_model import OFFERED, ExplorerModel

_models: dict[str, ExplorerModel] = {}  # the key is the place on the page
_check, _reader = PageCheck(), ReaderPython()  # the latter is used in the worker of the reader's code alone


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
    """Return the reply to an "open" message: an explorer's state, a player's steps, or why the link is refused.

    place: the explorer's id on the page; content: "hash" and "query" of the link, and the "width" of a narrow place.
    """
    try:
        scene, shown = parse_fragment(require_type(content.get("hash"), "the link", str))
        options = parse_query(require_type(content.get("query", ""), "the address", str))
        plays = shown.step is not None or shown.predict or shown.every_axis
        if options.plays or (options.challenge is None and plays):
            return _player_data(scene, shown, options)
        if options.challenge is not None:
            goal = options.challenge or (BREAK if scene.record().shortcut else TOUCH)
            shown = DEFAULT_VIEW._replace(goal=goal)
        model = ExplorerModel(scene, shown.goal)
        pose: dict[str, Any] = {
            "degree": shown.free,
            "mtv": shown.mtv,
            "difference": shown.difference,
            "pinned": shown.row,
        }
        pose |= {"view": shown.view} if shown.view else {}
        width = content.get("width")  # present if the place for the picture is narrow
        if width is not None or shown._replace(goal=None) != DEFAULT_VIEW:
            first = model.state()
            reply = model.answer({"kind": "pose", "a": first["a"], "b": first["b"], "width": width, **pose})
            if reply and reply["kind"] == "refused":
                raise InvalidScene(reply["why"])
    except ValueError as error:
        return {"kind": "refused", "why": str(error)}
    _models[place] = model
    return {"kind": "opened", "title": scene.title, "first": model.state(), "pose": pose, "width": width, **OFFERED}


def _player_data(scene: Scene, shown: ViewOptions, options: EmbedOptions) -> dict[str, Any]:
    """Return the reply with a player's steps and the number of the first; a prediction uses the true run.

    "range" holds the first and the last step if only these are played.
    """
    predict = shown.predict or options.predict
    trace = scene.record().truth if predict else scene.record()
    shows = playbacks(trace)
    first, last = options.steps or (0, len(shows[0]["steps"]) - 1)
    if last >= len(shows[0]["steps"]):
        raise InvalidScene(f"the run has no step {last}: its steps are 0 to {len(shows[0]['steps']) - 1}")
    found: dict[str, Any] = {"kind": "opened", "title": scene.title, "shows": shows, "narrow": narrow_playbacks(trace)}
    every_axis = shown.every_axis and len(shows) > 1 and not options.steps
    step = min(shown.step or first, len(shows[every_axis]["steps"]) - 1)
    found |= {"step": step, "predict": predict, "everyAxis": every_axis, "link": fragment(scene)}
    return found | {"range": [first, last] if options.steps else None}
