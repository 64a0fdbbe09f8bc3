"""The MIME bundle by which a notebook shows a shape, a scene, a trace or a picture."""

from collections.abc import Callable
from html import escape
from typing import Any
from zlib import crc32

from ..engine import describe
from ..engine.shapes import Circle, Polygon
from ..engine.trace import Trace
from ..pictures import Picture, picture
from ..pictures.playback import table_rows
from ..pictures.views import single_shape
from .files import inline_svg


def bundle(what: Any) -> dict[str, str]:
    """Return the MIME bundle: plain text, the picture as SVG where it can be drawn, and for a run its table as HTML."""
    make: Callable[[], Picture]
    trace = None
    if isinstance(what, Picture):
        text, make = describe.printable(repr(what)), lambda: what
    elif isinstance(what, (Circle, Polygon)):
        text, make = repr(what), lambda: single_shape(what)
    else:
        trace = what if isinstance(what, Trace) else what.record()
        text, make = str(trace), lambda: picture(trace)
    try:
        drawn = make()
    except ValueError as error:  # too far out to draw: the text is right all the same
        found = {"text/plain": f"{text}\n({error})"}
        return found if trace is None else found | {"text/html": f"{html_table(trace)}<p>({escape(str(error))})</p>"}
    found = {"text/plain": text, "image/svg+xml": inline_svg(drawn, stem=_stem(drawn))}
    return found if trace is None else found | {"text/html": f"{found['image/svg+xml']}\n{html_table(trace)}"}


def html_table(trace: Trace) -> str:
    """Return an HTML table of a run's tests, with the run's sentence below it."""
    names = "axis", "direction", *trace.names, "gap"
    head = "<td></td>" + "".join(f'<th scope="col">{escape(name)}</th>' for name in names)
    lines, pair = [], ""
    for row in table_rows(trace):
        if row["pair"] != pair:
            pair = row["pair"]
            lines.append(f'<th scope="rowgroup" colspan="6">{escape(pair)}</th>')
        axis = f"<td>{escape(row['axis'])}</td>"
        if "reason" in row:
            lines.append(f'<td></td>{axis}<td colspan="4"><em>{escape(row["reason"])}</em></td>')
        else:
            cells = (row[key] for key in ("direction", "a", "b", "outcome"))
            lines.append(f"<td>{row['number']}</td>{axis}" + "".join(f"<td>{escape(cell)}</td>" for cell in cells))
    body = "\n".join(f"<tr>{line}</tr>" for line in lines)
    said = escape(describe.printable(trace.sentence))
    return f"<table>\n<thead><tr>{head}</tr></thead>\n<tbody>\n{body}\n</tbody>\n</table>\n<p>{said}</p>"


def _stem(drawn: Picture) -> str:
    """Return a prefix for the ids in a picture's SVG, made from its content, since a page may show many."""
    return f"satviz-{crc32(drawn.to_json().encode()):08x}"
