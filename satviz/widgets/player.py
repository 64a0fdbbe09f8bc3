"""sv.play: the steps of a trace, one by one."""

from math import inf
from typing import TYPE_CHECKING, Any, Literal, overload

import traitlets

from ..engine.shapes import Shape
from ..engine.trace import Trace
from ..pictures import Picture, picture
from ..pictures.comparison import refused_picture
from ..pictures.playback import narrow_playbacks, picture_playback, playbacks
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
    speed = traitlets.Float(1.0).tag(sync=True)
    link = traitlets.Unicode("").tag(sync=True)

    def __init__(
        self, trace: Trace, *, predict: bool = False, sweep: bool = False, difference: bool = False, speed: float = 1.0
    ) -> None:
        """Make the player of a trace, of an axis that turns (`sweep`), or of how B - A comes about (`difference`).

        `predict` asks the reader for each answer first; `speed` 2 plays twice as fast.
        """
        model = PlayerModel(trace, turns=sweep, difference=difference)
        super().__init__(
            model,
            shows=[picture_playback(trace, model.own, turns=sweep)] if model.own else playbacks(trace),
            narrow=[] if model.own else narrow_playbacks(trace),
            predict=predict,
            speed=speed,
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
    difference: bool = False,
    speed: float = 1.0,
) -> Player: ...


@overload
def play(
    what: Trace | Scene | Shape,
    b: Shape | None = None,
    *,
    predict: bool = False,
    pen: Literal["matplotlib"],
    speed: float = 1.0,
) -> "PlainPlayer": ...


@overload
def play(
    what: SceneLike | Shape,
    b: Shape | None = None,
    *,
    predict: bool = False,
    pen: str = "svg",
    sweep: bool = False,
    difference: bool = False,
    speed: float = 1.0,
) -> Any: ...  # by name it may be a Picture: that of a scene that is refused


def play(
    what: SceneLike | Shape,
    b: Shape | None = None,
    *,
    predict: bool = False,
    pen: str = "svg",
    sweep: bool = False,
    difference: bool = False,
    speed: float = 1.0,
) -> Any:
    """Return a player for a notebook; with `predict` it asks the reader for each answer before it shows it.

    `what` is a scene (or its name), two shapes, or a trace.  `pen` is "svg" (drawn in the browser) or
    "matplotlib" (plain ipywidgets controls, for places where anywidget does not load).
    A shortcut's run is drawn beside the truth, which would give the answers away, so `predict` asks about the
    true run.  With `sweep` it plays an axis that turns, as `satviz.sweep` draws it, and with `difference` how B - A
    comes about, as `satviz.difference_steps` does.  `speed`: how many times as fast it plays at first.
    Of a failing scene whose outlines are refused, which has no steps, its Picture with the reason is returned.
    ValueError for a scene that cannot be drawn.
    """
    if not 0 < speed < inf:
        raise ValueError(f"speed is {speed!r}: pass a number above 0, such as 0.5 for half as fast")
    if sweep and difference:
        raise ValueError("sweep and difference play different pictures: pass one of them")
    if pen not in ("svg", "matplotlib"):
        raise ValueError(f'pen is {pen!r}: choose "svg" or "matplotlib"')
    if pen == "matplotlib" and (sweep or difference):
        raise ValueError(f'{"sweep" if sweep else "difference"} needs pen="svg"')
    found = resolve(what, b)
    if found.refused:
        return refused_picture(found.refused)
    trace = found.trace.truth if predict else found.trace
    if pen == "svg":
        return Player(trace, predict=predict, sweep=sweep, difference=difference, speed=speed)
    from .plain_controls import PlainPlayer

    return PlainPlayer(trace, speed=speed)
