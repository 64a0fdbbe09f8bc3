"""What both widgets share: the browser's code, files drawn by matplotlib, and the picture where no front end runs.

The front end is the part of a widget that runs in the browser.
"""

import os
from base64 import b64encode
from contextlib import suppress
from html import escape
from threading import RLock
from typing import Any

import anywidget
import traitlets

from ..engine import describe
from ..pictures import Picture
from ..pictures.caption import add_captions
from ..pictures.moves import Animation, animation, turning
from ..render.files import encode_frames
from ..render.formats import FORMATS
from ..render.notebook import bundle
from ..render.script import stylesheet
from ..scenes.link import site_folder
from .player_model import PlayerModel

LOCK = RLock()  # a front end's messages can come on any thread


class TraceWidget(anywidget.AnyWidget):
    """A widget that shows a trace and answers the messages of its front end, one at a time."""

    _css = stylesheet()
    formats = traitlets.List([each.name for each in FORMATS.values() if each.in_save_menu]).tag(sync=True)
    site = traitlets.Unicode(help="where links to a scene lead: http or https").tag(sync=True)
    trace = traitlets.Any(help="the Trace that is shown; observe it to follow").tag(sync=False)

    def __init__(self, model: PlayerModel, **more: Any) -> None:
        """Make the widget of a model; `more`: values of its traits."""
        self._model = model
        super().__init__(trace=model.trace, **more)
        self.on_msg(self._receive)

    @traitlets.default("site")
    def _site_of_environment(self) -> str:
        """Return the address in the environment variable SATVIZ_SITE, empty where it is not set."""
        return site_folder(os.environ.get("SATVIZ_SITE", ""), "SATVIZ_SITE")

    @traitlets.validate("site")
    def _checked_site(self, proposal: Any) -> str:
        """Return the checked address of the site's folder; InvalidScene if it is not http or https."""
        return site_folder(proposal["value"])

    def _receive(self, _widget: Any, content: Any, _buffers: Any) -> None:
        """Answer a message of the front end; ignore a message of unknown kind."""
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
        """Return the picture to show where no front end (browser) runs."""
        return self._model.picture()

    def _save(self, content: dict[str, Any]) -> None:
        """Send the front end the file that its message asks for, or the reason why there is none."""
        name = content.get("form")
        form = FORMATS.get(name) if isinstance(name, str) else None
        if form is None:
            return
        try:
            drawn = self._model.pictures_to_save(content, every_step=form.animated)
        except ValueError as error:
            self.send({"kind": "refused", "why": str(error)})
            return
        if drawn:
            shown = Animation(drawn, [0] * len(drawn))
            if form.animated:
                shown = (turning if self._model.turns else animation)(add_captions(drawn, brief=True))
            data = encode_frames(shown.pictures, form.name, times=shown.times)
            self.send({"kind": "file", "name": f"satviz.{form.name}", "mime": form.mime}, [data])

    def _answer(self, content: dict[str, Any]) -> None:
        """Send the model's answer to the message, if it has one, and set `trace` to the model's trace."""
        answer = self._model.answer(content)
        if answer is not None:
            self.trace = self._model.trace
            self.send(answer)

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {self.trace.sentence}>"

    def _repr_mimebundle_(self, **more: Any) -> tuple[dict[str, Any], dict[str, Any]]:
        """Return the widget, and its picture and sentence for a place where no widget runs."""
        found: Any = super()._repr_mimebundle_(**more)
        data, metadata = found if isinstance(found, tuple) else (found or {}, {})
        return {**data, **static_bundle(self)}, metadata


def stay_busy(comm: Any) -> None:
    """Let JupyterLab show the kernel as busy after this message (of `comm`), since many more follow in a drag.

    At each change between busy and idle JupyterLab fetches the page's icon and lays out its toolbar.  During a drag
    that is more work than everything else.  JupyterLab ignores the idle state after requests that it does not
    track, so this message is relabelled as such a request.  Without ipykernel this function does nothing.
    """
    with suppress(AttributeError, KeyError, TypeError):
        comm.kernel.get_parent("shell")["header"]["msg_type"] = "comm_info_request"


def static_bundle(widget: Any) -> dict[str, str]:
    """Return a MIME bundle for places where the widget does not run: its repr, and its picture with a caption.

    The picture is also given as HTML, which exported pages prefer: there a bare picture has no alternative text.
    """
    drawn, said = widget.picture(), describe.printable(repr(widget))
    svg = bundle(add_captions([drawn])[0])["image/svg+xml"]
    source = f"data:image/svg+xml;base64,{b64encode(svg.encode()).decode()}"
    img = f'<img alt="{escape(describe.printable(drawn.sentence))}" src="{source}">'
    return {"text/plain": said, "text/html": img, "image/svg+xml": svg}
