"""What answers the pages: Python beside the page, one hand for each scene on it.  (Standard library only.)"""

import json
from typing import Any

from ..engine.geometry import InvalidScene
from ..pictures.playback import narrow, playbacks
from ..scenes.article import SCENES
from ..scenes.failing import FAILURE_CASES, REFUSED
from ..scenes.link import DEFAULT_VIEW, ViewOptions, fragment, parse_fragment
from ..scenes.scenefile import Scene, shape_data
from ..scenes.strictjson import typed
from ..widgets.explorer_model import ExplorerModel
from ..widgets.goals import CALLED

_hands: dict[str, ExplorerModel] = {}
CHOICES = {
    "presets": [s.name for s in SCENES],
    "failing": [row.name for row in FAILURE_CASES if row.how != REFUSED],
    "challenges": CALLED,
}


def answer(place: str, text: str) -> str:
    """The answer to a message from a place on the page, both JSON; empty for one that means nothing."""
    content = json.loads(text)
    if content.get("kind") == "open":
        said: dict[str, Any] | None = _open(place, content)
    else:
        said = _hands[place].answer(content) if place in _hands else None
    return "" if said is None else json.dumps(said, ensure_ascii=False, separators=(",", ":"))


def _open(place: str, content: dict[str, Any]) -> dict[str, Any]:
    """What a link shows: the state of an explorer, the show of a player, or why it cannot be opened."""
    try:
        scene, shown = parse_fragment(typed(content.get("hash"), "the link", str))
        if shown.step is not None or shown.predict or shown.rest:
            return _show(scene, shown)
        hand = ExplorerModel(scene, shown.goal)
        pose: dict[str, Any] = {
            "degree": shown.free,
            "wayOut": shown.way_out,
            "against": shown.against,
            "pinned": shown.row,
        }
        pose |= {"view": shown.view} if shown.view else {}
        if shown._replace(goal=None) != DEFAULT_VIEW:
            said = hand.answer({"kind": "pose", "a": shape_data(scene.a), "b": shape_data(scene.b), **pose})
            if said and said["kind"] == "refused":
                raise InvalidScene(said["why"])
    except ValueError as error:
        return {"kind": "refused", "why": str(error)}
    _hands[place] = hand
    return {"kind": "opened", "title": scene.title, "first": hand.state(), "pose": pose, **CHOICES}


def _show(scene: Scene, shown: ViewOptions) -> dict[str, Any]:
    """A player at a step; what a shortcut saw tells what is, so to predict is asked of the true run."""
    trace = scene.record()
    trace = trace.truth if shown.predict and trace.shortcut else trace
    shows = playbacks(trace)
    found: dict[str, Any] = {"kind": "opened", "title": scene.title, "shows": shows, "narrow": narrow(trace)}
    rest = shown.rest and len(shows) > 1
    found |= {"step": min(shown.step or 0, len(shows[rest]["steps"]) - 1), "predict": shown.predict, "rest": rest}
    return found | {"link": fragment(scene)}
