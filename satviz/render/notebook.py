"""What a notebook shows of a picture, a trace, a scene or a shape: its text and its picture."""

from collections.abc import Callable
from typing import Any
from zlib import crc32

from ..engine import telling
from ..engine.shapes import Circle, Polygon
from ..engine.trace import Trace
from ..pictures import Picture, picture
from ..pictures.views import alone
from .files import inline_svg


def bundle(what: Any) -> dict[str, str]:
    """The MIME bundle: plain text, and the picture as SVG where it can be drawn."""
    make: Callable[[], Picture]
    if isinstance(what, Picture):
        text, make = telling.printable(repr(what)), lambda: what
    elif isinstance(what, (Circle, Polygon)):
        text, make = repr(what), lambda: alone(what)
    else:
        trace = what if isinstance(what, Trace) else what.record()
        text, make = str(trace), lambda: picture(trace)
    try:
        drawn = make()
    except ValueError as error:  # too far out to draw: the text is right all the same
        return {"text/plain": f"{text}\n({error})"}
    return {"text/plain": text, "image/svg+xml": inline_svg(drawn, stem=_stem(drawn))}


def _stem(drawn: Picture) -> str:
    """Ids of its own for each picture: a page may show many."""
    return f"satviz-{crc32(drawn.to_json().encode()):08x}"
