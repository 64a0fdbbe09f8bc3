"""Parts of several pages: an explorer, which needs Python in the page, and a player, which does not.

Both show a still picture and its words until their script has started.
"""

import json
import zlib
from base64 import b64encode
from html import escape

from ..engine.trace import Trace
from ..lessons.themed import themed_svg
from ..pictures import Picture, picture
from ..pictures.playback import narrow_playbacks, playbacks
from ..render.notebook import bundle
from ..scenes.link import PAGE, fragment, fragment_of_trace
from ..widgets.explorer_model import ExplorerModel

PHONE_WIDTH_PT = 360  # width of the place for a scene on a telephone


def svg_element(picture: Picture) -> str:
    """Return the picture as an SVG element that follows the reader's theme."""
    return themed_svg(bundle(picture)["image/svg+xml"])


def explorer(model: ExplorerModel) -> str:
    """Return an explorer as HTML: the still scene, its sentence and its table, until Python has started.

    On a telephone the still scene has the layout of the live one: its letters can be read, and nothing below it jumps
    when Python has started.  Afterwards `model` is laid out for a telephone.
    """
    link, drawing = escape(fragment(model.scene)), model.picture()
    still = f'<div class="wide">{_still(model)}</div>'
    pose = {name: model.state()[name] for name in ("a", "b")}
    model.answer({"kind": "pose", **pose, "width": PHONE_WIDTH_PT})
    still += f'<div class="narrow">{_still(model)}</div>'
    return (
        f'<div class="live" data-hash="{link}"><div class="satviz still"><div class="sv-columns">'
        f'<div class="sv-stage">{still}<p class="sv-sentence">{escape(drawing.sentence)}</p></div>'
        f'<div class="sv-side"><pre class="out" tabindex="0">{escape(str(model.trace))}</pre></div></div></div></div>'
        f'<p class="status" role="status"></p><p class="open"><a href="{PAGE}#{link}">Open in the explorer</a></p>'
    )


def _still(model: ExplorerModel) -> str:
    """Return the present picture and number line of an explorer as SVG elements."""
    line = model.number_line()
    return svg_element(model.picture()) + (svg_element(line) if line else "")


def player(trace: Trace, *, predict: bool = False) -> str:
    """Return a player as HTML, with all its steps; without JavaScript it shows one picture and every sentence.

    This picture is the last step; with `predict` it is the first step, which does not show the answer.
    """
    trace = trace.truth if predict else trace
    shows = playbacks(trace)
    sentences = "".join(f"<li>{escape(step['sentence'])}</li>" for step in shows[0]["steps"])
    show = {"shows": shows, "narrow": narrow_playbacks(trace), "predict": predict, "link": fragment_of_trace(trace)}
    data = _packed(json.dumps(show, separators=(",", ":"), ensure_ascii=False))
    return (
        f'<div class="player"><div class="still"><figure>{svg_element(picture(trace, 0 if predict else -1))}</figure>'
        f"<details><summary>step by step, in words</summary><ol>{sentences}</ol></details></div>"
        f'<script type="application/json">"{data}"</script></div>'
    )


def _packed(text: str) -> str:
    """Return the text compressed, in base64: steps repeat themselves, and a plain server does not compress a page."""
    deflate = zlib.compressobj(9, zlib.DEFLATED, -zlib.MAX_WBITS)
    return b64encode(deflate.compress(text.encode()) + deflate.flush()).decode()
