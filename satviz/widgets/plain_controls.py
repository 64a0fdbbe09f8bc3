"""The player as plain ipywidgets over the matplotlib pen, for places where anywidget does not load."""

import io
from html import escape
from typing import Any

import ipywidgets as ui

from ..engine.trace import Trace
from ..pictures import LIGHT, Picture, picture, steps
from ..pictures.caption import reading_time_ms
from ..render.files import canvas, styled
from .base import LOCK, static_bundle


class PlainPlayer(ui.VBox):  # type: ignore[misc]
    """A player with a slider, a play button and the picture, which is drawn again on one Figure for each step."""

    def __init__(self, trace: Trace, *, speed: float = 1.0) -> None:
        """Make the player of a trace, at its first step; `speed` 2 plays twice as fast."""
        self.trace = trace
        self.speed = speed
        last = len(steps(trace)) - 1
        self.figure, self.pen = canvas(picture(trace, 0).size, LIGHT)
        self.image = ui.Image(format="png", layout={"max_width": "100%", "object_fit": "contain"})
        self.sentence = ui.HTML()
        self.slider = ui.IntSlider(0, 0, last, description="step")
        self.player = ui.Play(value=0, min=0, max=last)
        ui.jslink((self.player, "value"), (self.slider, "value"))
        back, forward = (ui.Button(description=name, layout={"width": "80px"}) for name in ("back", "forward"))
        back.on_click(lambda _: self._move(-1))
        forward.on_click(lambda _: self._move(1))
        self.slider.observe(lambda _: self._draw(), "value")
        super().__init__([self.image, self.sentence, ui.HBox([self.player, back, forward, self.slider])])
        self._draw()

    def _move(self, count: int) -> None:
        """Go that many steps forward, or back where `count` is negative."""
        self.slider.value = max(0, min(self.slider.max, self.slider.value + count))

    def _draw(self) -> None:
        """Show the step at which the slider stands."""
        with LOCK, styled():
            drawn = picture(self.trace, self.slider.value)
            self.pen.draw(drawn)
            out = io.BytesIO()
            self.figure.savefig(out, format="png", dpi=96)
        self.image.value = out.getvalue()
        self.player.interval = round(reading_time_ms(drawn.sentence) / self.speed)
        self.sentence.value = f"<p>{escape(drawn.sentence)}</p>"

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {self.trace.sentence}>"

    def picture(self) -> Picture:
        """Return the picture to show where no front end runs, since a box does not show its contents."""
        return picture(self.trace)

    def _repr_mimebundle_(self, **more: Any) -> dict[str, Any]:
        """Return the widget, and its picture and sentence for a place where no widget runs."""
        found = super()._repr_mimebundle_(**more) or {}
        return {**found, **static_bundle(self)}
