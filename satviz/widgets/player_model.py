"""The player without the widget: the pictures of a trace, and those that a message asks to save."""

from collections.abc import Sequence
from typing import Any

from ..engine.trace import Trace
from ..pictures import Picture, picture
from ..pictures.difference_steps import difference_steps
from ..pictures.playback import playback_steps
from ..pictures.turning_axis import sweep


class PlayerModel:
    """A trace that is shown, and the answers to its front end.

    The trace is shown as its steps, as an axis that turns (`turns`), or as pictures of how B - A is made
    (`difference`).
    """

    turns = False
    own: Sequence[Picture] = ()  # the pictures that are shown instead of the steps

    def __init__(self, trace: Trace, *, turns: bool = False, difference: bool = False) -> None:
        """Show a trace as its steps, as an axis that turns (`turns`), or as B - A comes about (`difference`)."""
        self.trace = trace
        self.turns = turns
        self.own = sweep(trace) if turns else difference_steps(trace) if difference else ()

    def picture(self) -> Picture:
        """Return the picture to show where no front end runs: the last step."""
        return picture(self.trace)

    def answer(self, content: dict[str, Any]) -> dict[str, Any] | None:
        """Return the answer to a message of the front end; here always None, since only an explorer answers any."""
        return None

    def pictures_to_save(self, content: dict[str, Any], *, every_step: bool) -> list[Picture]:
        """Return the pictures that a message asks to save: all if `every_step`, else that of its "step".

        The list is empty for a step that the trace does not have.  ValueError for too many steps.
        """
        step = content.get("step")
        if not every_step and not isinstance(step, int):
            return [self.picture()]
        if self.own:
            return [drawn for i, drawn in enumerate(self.own) if every_step or i == step]
        trace = self.trace.without_early_exit() if content.get("which") else self.trace
        shown = playback_steps(trace)
        return [picture(trace, s) for i, s in enumerate(shown) if every_step or i == step]
