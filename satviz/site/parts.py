"""Parts that several pages show: a scene that can be dragged once Python is there, a player; each whole before."""

import json
from html import escape

from ..engine.trace import Trace
from ..pictures import Picture, picture
from ..pictures.playback import narrow, playbacks
from ..render.notebook import bundle
from ..scenes.link import PAGE, fragment, fragment_of_trace
from ..widgets.explorer_model import ExplorerModel
from .themed import themed


def drawn(picture: Picture) -> str:
    """The picture as an SVG element of the page."""
    return themed(bundle(picture)["image/svg+xml"])


def explorer(hand: ExplorerModel) -> str:
    """A scene as it stands, its sentence and its table; a live one takes its place when Python is there."""
    behind, drawing = escape(fragment(hand.scene)), hand.picture()
    return (
        f'<div class="live" data-hash="{behind}"><div class="satviz still"><div class="sv-columns">'
        f'<div class="sv-stage">{drawn(drawing)}<p class="sv-sentence">{escape(drawing.sentence)}</p></div>'
        f'<div class="sv-side"><pre class="out" tabindex="0">{escape(str(hand.trace))}</pre></div></div></div></div>'
        f'<p class="status" role="status"></p><p class="open"><a href="{PAGE}#{behind}">Open in the explorer</a></p>'
    )


def player(trace: Trace, *, predict: bool = False) -> str:
    """A player, which needs no Python; without JavaScript a picture (who is asked sees the question) and all words."""
    trace = trace.truth if predict and trace.shortcut else trace
    shows = playbacks(trace)
    sentences = "".join(f"<li>{escape(step['sentence'])}</li>" for step in shows[0]["steps"])
    show = {"shows": shows, "narrow": narrow(trace), "predict": predict, "link": fragment_of_trace(trace)}
    data = json.dumps(show, separators=(",", ":"), ensure_ascii=False).replace("<", "\\u003c")
    return (
        f'<div class="player"><div class="still"><figure>{drawn(picture(trace, 0 if predict else -1))}</figure>'
        f"<details><summary>step by step, in words</summary><ol>{sentences}</ol></details></div>"
        f'<script type="application/json">{data}</script></div>'
    )
