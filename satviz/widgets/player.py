"""sv.play: the steps of a trace, one by one."""

from typing import Any

import traitlets

from ..engine.trace import Trace
from ..pictures.playback import playbacks
from ..scenes.link import of_trace
from .base import Shown, code
from .showing import Showing


class Player(Shown):
    """The steps of a trace with their table, algorithm and sentences; it never plays by itself."""

    _esm = code("play")
    shows: traitlets.List[dict[str, Any]] = traitlets.List().tag(sync=True)
    predict = traitlets.Bool(False).tag(sync=True)
    link = traitlets.Unicode("").tag(sync=True)

    def __init__(self, trace: Trace, *, predict: bool = False) -> None:
        super().__init__(Showing(trace), shows=playbacks(trace), predict=predict, link=of_trace(trace))


def play(trace: Trace, *, predict: bool = False, pen: str = "svg") -> Any:
    """A player for a notebook: step, play, scrub, and with `predict` a question before each answer.

    `pen`: "svg" (drawn in the browser) or "matplotlib" (plain ipywidgets controls, for
    places where anywidget does not load).  ValueError for a scene that cannot be drawn.
    """
    if pen == "svg":
        return Player(trace, predict=predict)
    if pen != "matplotlib":
        raise ValueError(f'pen is {pen!r}: choose "svg" or "matplotlib"')
    from .plain import PlainPlayer

    return PlainPlayer(trace)
