"""The glossary as a page: each term with its sentence, its picture, its symbol and its other names."""

from functools import cache
from html import escape

from ..lessons.glossary import TERMS, Term
from ..lessons.themed import themed_svg_file
from ..pictures import Picture
from ..render.files import encode
from .chapters import GLOSSARY
from .pages import SiteInfo, html_page


def glossary_page(info: SiteInfo) -> bytes:
    """Return the page of all terms, in the order in which the chapters need them."""
    jumps = "".join(f'<li><a href="#{term.id}">{escape(term.name)}</a></li>' for term in TERMS)
    body = f"""
<h1>Glossary</h1>
<p class="lead">Each term in one sentence, with its symbol and its names in other libraries.</p>
<ul class="jumps">{jumps}</ul>
<div class="cards">{"".join(map(_entry, TERMS))}</div>
"""
    description = "The terms of collision detection by the Separating Axis Theorem, each with a picture."
    return html_page(info, GLOSSARY, "Glossary", body, description=description, kind="glossary")


def _entry(term: Term) -> str:
    """Return a term as HTML."""
    drawn = _picture(term)
    facts = [("symbol", term.symbol), ("also", term.others)]
    listed = "".join(f"<dt>{name}</dt><dd>{escape(value)}</dd>" for name, value in facts if value)
    size = 'width="{:g}" height="{:g}"'.format(*drawn.size)
    image = f'<img src="{_path(term)}" {size} alt="{escape(drawn.sentence)}">'
    return (
        f'<article class="card" id="{term.id}"><h2>{escape(term.name)}</h2><p>{escape(term.sentence)}</p>'
        f"{image}<dl>{listed}</dl></article>"
    )


def pictures() -> list[tuple[str, bytes]]:
    """Return (path, content) of each term's picture."""
    return [(_path(term), themed_svg_file(encode(_picture(term), "svg", stem=f"term-{term.id}"))) for term in TERMS]


def _path(term: Term) -> str:
    """Return the path of a term's picture."""
    return f"pictures/term-{term.id}.svg"


@cache
def _picture(term: Term) -> Picture:
    """Return a term's Picture, drawn once."""
    return term.draw()
