"""What a notebook shows of a trace, a scene or a shape: its text and its picture, labels escaped."""

from html import escape
from typing import Any

from ..pictures import picture
from ..pictures.views import alone
from ..shapes import Circle, Polygon
from ..trace import Trace
from .files import encode


def bundle(what: Any) -> dict[str, str]:
    """The MIME bundle: plain text, and the picture as SVG where it can be drawn."""
    if isinstance(what, (Circle, Polygon)):
        text, make = repr(what), lambda: alone(what)
    else:
        trace = what if isinstance(what, Trace) else what.record()
        text, make = str(trace), lambda: picture(trace)
    try:
        drawn = make()
    except ValueError as error:  # too far out to draw: the text is right all the same
        return {"text/plain": f"{text}\n({error})"}
    svg = encode(drawn, "svg").decode()
    svg = svg[svg.index("<svg") :]
    return {"text/plain": text, "image/svg+xml": svg, "text/html": f"{svg}<pre>{escape(text)}</pre>"}
