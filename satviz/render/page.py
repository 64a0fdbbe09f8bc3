"""sv.page: a trace as one HTML file to share, with its player; no network, no kernel, the same bytes each time."""

import json
from base64 import b64encode
from collections.abc import Sequence
from hashlib import sha256
from html import escape

from ..engine import describe
from ..engine.shapes import Shape
from ..pictures import DARK, LIGHT, picture
from ..pictures.claims import heading
from ..pictures.comparison import refused_picture
from ..pictures.playback import NARROW, narrow, playbacks
from ..safe_write import MADE_BY
from ..scenes.failing import FailureCase
from ..scenes.resolve import SceneLike, resolve
from .files import inline_svg
from .script import javascript, stylesheet

START = """
const data = JSON.parse(document.getElementById("satviz-show").textContent);
arrowKeys(new Player(document.getElementById("satviz-player"), data.shows, data));
document.documentElement.classList.add("with-player");
"""
STYLE = """
body.satviz { margin: 0; border-radius: 0; }
main { max-width: 1200px; margin: 0 auto; padding: 8px 0; min-height: 100vh; }
h1 { font-size: 20px; margin: 8px; }
.sv-static svg { display: block; width: 100%; max-width: 620px; height: auto; background: #fff; }
.sv-light svg, .sv-dark svg { max-width: 420px; background: none; }
.sv-dark { display: none; }
@media screen and (prefers-color-scheme: dark) { .sv-light { display: none; } .sv-dark { display: block; } }
.sv-static pre { overflow-x: auto; font-size: 12px; }
.sv-static figure { margin: 12px 0; break-inside: avoid; }
.sv-static h2 { font-size: 16px; }
.sv-static { padding: 0 8px; }
footer { font-size: 12px; color: var(--sv-guide); margin: 12px 8px; }
.with-player .sv-static { display: none; }
@media print { #satviz-player { display: none; } .with-player .sv-static { display: block; } main { padding: 0; } }
"""


def page(what: SceneLike | Shape, b: Shape | None = None, *, title: str = "", predict: bool = False) -> str:
    """One self-contained HTML file: every step with its player, the table and every sentence.

    Of a scene (or its name), two shapes, or a trace.  With `predict` it asks before it shows.
    Without JavaScript, and on paper, it shows the first and the last picture instead.
    A failing scene whose outlines are refused has no steps: its picture and the reason.
    ValueError for a scene that cannot be drawn, or one with too many steps.
    """
    found = resolve(what, b)
    if found.refused:
        return _refused(found.refused)
    trace = found.trace
    if predict and trace.shortcut:
        trace = trace.truth
    shows = playbacks(trace)
    asked = "Do A and B collide?"
    about = describe.printable(asked if predict else trace.sentence)
    title = " ".join(heading(trace)) if trace.shortcut else title or asked
    script = javascript("player", "arrows") + START
    policy = f"default-src 'none'; style-src 'unsafe-inline'; script-src 'sha256-{_hash(script)}'; "
    policy += "img-src blob:; base-uri 'none'"  # a picture on its way to a PNG
    show = {"predict": predict, "shows": shows, "narrow": narrow(trace)}
    data = json.dumps(show, separators=(",", ":"), ensure_ascii=False).replace("<", "\\u003c")
    first, last = (picture(trace, i) for i in (0, -1))
    sentences = [s["sentence"] for s in shows[0]["steps"]]
    body = [
        '<div id="satviz-player"></div>',
        '<section class="sv-static">',
        *(f"<figure>{inline_svg(drawn, stem=stem)}</figure>" for drawn, stem in ((first, "first"), (last, "last"))),
        f'<pre tabindex="0">{escape(str(trace))}</pre>',
        "<h2>Step by step</h2>",
        *_listed(sentences),
        "</section>",
        f"<footer>{MADE_BY}</footer>",
        f'<script type="application/json" id="satviz-show">{data}</script>',
        f'<script type="module">{script}</script>',
    ]
    return _page(title, about, policy, body)


def _page(title: str, about: str, policy: str, body: Sequence[str]) -> str:
    lines = [
        "<!doctype html>",
        '<html lang="en">',
        "<head>",
        '<meta charset="utf-8">',
        f'<meta http-equiv="Content-Security-Policy" content="{policy}">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        f'<meta name="generator" content="{MADE_BY}">',
        f'<meta name="description" content="{escape(about)}">',
        f"<title>{escape(describe.printable(title))}</title>",
        f"<style>\n{stylesheet()}{STYLE}</style>",
        "</head>",
        '<body class="satviz"><main>',
        f"<h1>{escape(describe.printable(title))}</h1>",
        *body,
        "</main></body>",
        "</html>",
    ]
    return "\n".join(lines) + "\n"


def _refused(case: FailureCase) -> str:
    """A page without a script: the picture as wide as a telephone, in the colours of the reader's screen."""
    drawn = refused_picture(case, width=NARROW[0])
    figures = (f'<figure class="sv-{t.name}">{inline_svg(drawn, t, stem=t.name)}</figure>' for t in (LIGHT, DARK))
    body = ['<section class="sv-static">', *figures, "</section>", f"<footer>{MADE_BY}</footer>"]
    policy = "default-src 'none'; style-src 'unsafe-inline'; base-uri 'none'"
    return _page(drawn.sentence, drawn.sentence, policy, body)


def _listed(sentences: Sequence[str]) -> list[str]:
    return ["<ol>", *(f"<li>{escape(sentence)}</li>" for sentence in sentences), "</ol>"]


def _hash(script: str) -> str:
    return b64encode(sha256(script.encode()).digest()).decode()
