"""sv.explore: a scene to drag.  The browser moves what is dragged; Python alone computes SAT."""

from typing import Any, overload

import traitlets

from ..engine.axes import Chooser
from ..engine.shapes import Shape
from ..engine.shortcut import Shortcut
from ..pictures.comparison import refused_picture
from ..render.script import javascript
from ..scenes.resolve import EXPECT_SCENE, resolve
from ..scenes.scenefile import Scene, with_axes
from .base import TraceWidget
from .explorer_model import OFFERED, ExplorerModel


class Explorer(TraceWidget):
    """A widget with two shapes to drag, turn and reshape, and one axis: the decisive, a chosen or a free one.

    A failing scene shows the shortcut's run, its answer and its error region, or the true run.
    `scene` and `trace` follow each drag.  Messages of the browser are checked like a scene file.
    """

    _model: ExplorerModel
    _esm = javascript("explore")
    first = traitlets.Dict().tag(sync=True)
    presets = traitlets.List(OFFERED["presets"]).tag(sync=True)
    failing = traitlets.List(OFFERED["failing"]).tag(sync=True)
    challenges = traitlets.Dict(OFFERED["challenges"]).tag(sync=True)

    def __init__(self, shown: Scene, goal: str | None = None) -> None:
        """Make the explorer of a scene; `goal`: the challenge ("touch", "one-axis" or "break"), None for none."""
        model = ExplorerModel(shown, goal)
        super().__init__(model, first=model.state())

    @property
    def scene(self) -> Scene:
        """Return the scene as it is now."""
        return self._model.scene


@overload
def explore(
    what: Scene | Shape,
    b: Shape | None = None,
    *,
    axes: str | Chooser | Shortcut | None = None,
    goal: str | None = None,
) -> Explorer: ...


@overload
def explore(  # a Picture where a scene is refused
    what: str = "triangles", *, axes: str | Chooser | Shortcut | None = None, goal: str | None = None
) -> Any: ...


def explore(
    what: Scene | Shape | str = "triangles",
    b: Shape | None = None,
    *,
    axes: str | Chooser | Shortcut | None = None,
    goal: str | None = None,
) -> Any:
    """Return a widget in which to drag a scene: a built-in scene's name, a Scene, or two shapes.

    `axes` replaces the scene's axes: a name, or what `record` takes, such as a shortcut of your own, which is shown
    with its error region.  Links from the widget have only axes with a name.
    Drag shapes, vertices and handles, or Tab to one and use the arrow keys.  `goal` sets a challenge:
    "touch", "one-axis" or, for a scene of a shortcut, "break".  A failing scene whose outlines are refused
    cannot be dragged: its Picture with the reason is returned.  InvalidScene for an unknown name or goal,
    ValueError for a scene that cannot be drawn, TypeError for anything else.
    """
    found = resolve(what, b, expected=EXPECT_SCENE)
    if found.refused:
        return refused_picture(found.refused)
    return Explorer(found.scene if axes is None else with_axes(found.scene, axes), goal)
