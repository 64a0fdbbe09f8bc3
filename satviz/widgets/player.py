"""sv.play: the steps of a trace, one by one."""

from typing import TYPE_CHECKING, Any, Literal, overload

import traitlets

from ..engine.shapes import Shape
from ..engine.trace import Trace
from ..pictures import Picture, picture
from ..pictures.comparison import refused_picture
from ..pictures.playback import narrow_playbacks, playbacks, sweep_playback
from ..render.script import javascript
from ..scenes.link import fragment_of_trace
from ..scenes.resolve import SceneLike, resolve
from ..scenes.scenefile import Scene
from .base import TraceWidget
from .player_model import PlayerModel

if TYPE_CHECKING:
    from .plain_controls import PlainPlayer


class Player(TraceWidget):
    """A player of a trace's steps, with their table, algorithm and sentences; it never starts by itself."""

    _esm = javascript("play")
    shows: traitlets.List[dict[str, Any]] = traitlets.List().tag(sync=True)
    narrow: traitlets.List[dict[str, Any]] = traitlets.List().tag(sync=True)
    predict = traitlets.Bool(False).tag(sync=True)
    link = traitlets.Unicode("").tag(sync=True)

    def __init__(self, trace: Trace, *, predict: bool = False, sweep: bool = False) -> None:
        super().__init__(
            PlayerModel(trace, turns=sweep),
            shows=[sweep_playback(trace)] if sweep else playbacks(trace),
            narrow=[] if sweep else narrow_playbacks(trace),
            predict=predict,
            link=fragment_of_trace(trace),
        )

    def picture(self) -> Picture:
        """Return the picture to show where no front end runs: the last step, with `predict` the first."""
        return picture(self.trace, 0) if self.predict else super().picture()

    def __repr__(self) -> str:
        return "<Player: do A and B collide?>" if self.predict else super().__repr__()


@overload
def play(
    what: Trace | Scene | Shape,
    b: Shape | None = None,
    *,
    predict: bool = False,
    pen: Literal["svg"] = "svg",
    sweep: bool = False,
) -> Player: ...


@overload
def play(
    what: Trace | Scene | Shape, b: Shape | None = None, *, predict: bool = False, pen: Literal["matplotlib"]
) -> "PlainPlayer": ...


@overload
def play(
    what: SceneLike | Shape, b: Shape | None = None, *, predict: bool = False, pen: str = "svg", sweep: bool = False
) -> Any: ...  # by name it may be a Picture: that of a scene that is refused


def play(
    what: SceneLike | Shape, b: Shape | None = None, *, predict: bool = False, pen: str = "svg", sweep: bool = False
) -> Any:
    """Return a player for a notebook: step, play, scrub, and with `predict` a question before each answer.

    `what` is a scene (or its name), two shapes, or a trace.  `pen` is "svg" (drawn in the browser) or
    "matplotlib" (plain ipywidgets controls, for places where anywidget does not load).
    A shortcut's run is drawn beside the truth, which would give the answers away, so `predict` asks about the
    true run.  With `sweep` it plays an axis that turns, as `satviz.sweep` draws it.  Of a failing scene whose
    outlines are refused, which has no steps, its Picture with the reason is returned.  ValueError for a scene that
    cannot be drawn.
    """
    found = resolve(what, b)
    if found.refused:
        return refused_picture(found.refused)
    trace = found.trace
    if predict and trace.shortcut:
        trace = trace.truth
    if pen == "svg":
        return Player(trace, predict=predict, sweep=sweep)
    if sweep:
        raise ValueError('sweep needs pen="svg"')
    if pen != "matplotlib":
        raise ValueError(f'pen is {pen!r}: choose "svg" or "matplotlib"')
    from .plain_controls import PlainPlayer

    return PlainPlayer(trace)
