"""A trace on show, without the widget: its pictures, and those that a message asks to save."""

from typing import Any

from ..engine.trace import Trace
from ..pictures import Picture, picture
from ..pictures.playback import playback_steps


class PlayerModel:
    """The trace that is shown, and what its front end is answered."""

    def __init__(self, trace: Trace) -> None:
        self.trace = trace

    def picture(self) -> Picture:
        """What is shown where no front end runs."""
        return picture(self.trace)

    def answer(self, content: dict[str, Any]) -> dict[str, Any] | None:
        """The answer to a message; None to one that means nothing."""
        return None

    def to_save(self, content: dict[str, Any]) -> list[Picture]:
        """What a message asks to save: one picture, all steps for an animation; none if it means nothing.

        ValueError for too many steps.
        """
        form, step = content.get("form"), content.get("step")
        if form not in ("svg", "png", "gif"):
            return []
        if form != "gif" and not isinstance(step, int):
            return [self.picture()]
        trace = self.trace.without_early_exit() if content.get("which") else self.trace
        every = playback_steps(trace)
        return [picture(trace, s) for i, s in enumerate(every) if form == "gif" or i == step]
