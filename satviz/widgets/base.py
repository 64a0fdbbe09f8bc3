"""What both widgets share: the browser's code, files by the matplotlib pen, the picture where no front end runs."""

import os
from base64 import b64encode
from contextlib import suppress
from html import escape
from threading import RLock
from typing import Any

import anywidget
import traitlets

from ..engine import describe
from ..pictures import LIGHT, Picture
from ..pictures.caption import captioned
from ..render.files import animate, encode
from ..render.notebook import bundle
from ..render.script import stylesheet
from ..scenes.link import site_folder
from .player_model import PlayerModel

LOCK = RLock()  # a front end's messages can come on any thread


class Shown(anywidget.AnyWidget):
    """A widget whose trace is shown; its messages are answered one at a time."""

    _css = stylesheet()
    site = traitlets.Unicode(help="where links to a scene lead: http or https").tag(sync=True)
    trace = traitlets.Any(help="the Trace that is shown; observe it to follow").tag(sync=False)

    def __init__(self, showing: PlayerModel, **more: Any) -> None:
        self._showing = showing
        super().__init__(trace=showing.trace, **more)
        self.on_msg(self._heard)

    @traitlets.default("site")
    def _site_of_the_environment(self) -> str:
        return site_folder(os.environ.get("SATVIZ_SITE", ""), "SATVIZ_SITE")

    @traitlets.validate("site")
    def _checked_site(self, proposal: Any) -> str:
        return site_folder(proposal["value"])

    def _heard(self, _widget: Any, content: Any, _buffers: Any) -> None:
        if not isinstance(content, dict):
            return
        with LOCK:
            if content.get("kind") == "save":
                self._save(content)
            else:
                self._answer(content)
        if content.get("final") is False:
            stay_busy(self.comm)

    def picture(self) -> Picture:
        """What is shown where no front end runs."""
        return self._showing.picture()

    def _save(self, content: dict[str, Any]) -> None:
        form = content.get("form")
        try:
            drawn = self._showing.to_save(content)
        except ValueError as error:
            self.send({"kind": "refused", "why": str(error)})
            return
        if drawn:
            data = animate(captioned(drawn)) if form == "gif" else encode(drawn[0], str(form), LIGHT)
            self.send({"kind": "file", "name": f"satviz.{form}"}, [data])

    def _answer(self, content: dict[str, Any]) -> None:
        answer = self._showing.answer(content)
        if answer is not None:
            self.trace = self._showing.trace
            self.send(answer)

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {self.trace.sentence}>"

    def _repr_mimebundle_(self, **more: Any) -> tuple[dict[str, Any], dict[str, Any]]:
        """The widget, and for where none runs the picture and the sentence."""
        found: Any = super()._repr_mimebundle_(**more)
        data, metadata = found if isinstance(found, tuple) else (found or {}, {})
        return {**data, **still(self)}, metadata


def stay_busy(comm: Any) -> None:
    """Let the kernel be shown as busy when the message at hand is done, since many more will follow.

    At each busy and each idle JupyterLab fetches the page's icon and lays out its toolbar: at a drag's rate
    more work than all the rest together.  It leaves out the idle of requests that it does not track, so
    this message's is told as one of those.  Where the kernel is not ipykernel nothing happens.
    """
    with suppress(AttributeError, KeyError, TypeError):
        comm.kernel.get_parent("shell")["header"]["msg_type"] = "comm_info_request"


def still(widget: Any) -> dict[str, str]:
    """What stands for a widget where no front end runs: its sentence, and the picture with the sentence in it.

    As HTML too, which exported pages prefer: a bare picture gets no alt text there.
    """
    drawn, said = widget.picture(), describe.printable(repr(widget))
    svg = bundle(captioned([drawn])[0])["image/svg+xml"]
    source = f"data:image/svg+xml;base64,{b64encode(svg.encode()).decode()}"
    img = f'<img alt="{escape(describe.printable(drawn.sentence))}" src="{source}">'
    return {"text/plain": said, "text/html": img, "image/svg+xml": svg}
