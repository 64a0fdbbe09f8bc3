"""sv.page: a trace as one HTML file to share, with its player.

The page needs no network and no kernel, and the same trace gives the same bytes each time.
"""

import json
from base64 import b64encode
from collections.abc import Sequence
from hashlib import sha256
from html import escape
from importlib.resources import files

from ..engine import describe
from ..engine.shapes import Shape
from ..pictures import DARK, LIGHT, picture
from ..pictures.claims import heading
from ..pictures.comparison import refused_picture
from ..pictures.difference_steps import difference_steps
from ..pictures.layout import NARROW_SIZE_PT
from ..pictures.playback import narrow_playbacks, picture_playback, playbacks
from ..pictures.turning_axis import sweep as turning_axis
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


def page(
    what: SceneLike | Shape,
    b: Shape | None = None,
    *,
    title: str = "",
    predict: bool = False,
    sweep: bool = False,
    difference: bool = False,
    speed: float = 1.0,
) -> str:
    """Return one self-contained HTML file: every step of a run with its player, the table and every sentence.

    `what` is a scene (or its name), two shapes, or a trace.  With `predict` the page asks the reader for each result
    before it shows it.  `sweep` shows an axis that turns, as `satviz.sweep` does, and `difference` how B - A comes
    about, as `satviz.difference_steps` does, instead of the run.  `speed`: how many times as fast it plays at first.
    Without JavaScript, and on paper, the page has only the first and the last picture; with `predict` the last one is
    folded.
    A failing scene whose outlines are refused has no steps: the page has its picture and the reason.
    ValueError for a scene that cannot be drawn, or one with too many steps.
    """
    found = resolve(what, b)
    if found.refused:
        return _page_of_refused(found.refused)
    trace = found.trace.truth if predict else found.trace
    drawn = turning_axis(trace) if sweep else difference_steps(trace) if difference else ()
    shows = [picture_playback(trace, drawn, turns=sweep)] if drawn else playbacks(trace)
    question = "Do A and B collide?"
    about = describe.printable(question if predict else trace.sentence)
    title = " ".join(heading(trace)) if trace.shortcut else title or question
    script = javascript("player", "arrows") + START
    script_hash = b64encode(sha256(script.encode()).digest()).decode()
    policy = f"default-src 'none'; style-src 'unsafe-inline'; script-src 'sha256-{script_hash}'; "
    policy += "img-src blob:; base-uri 'none'"  # the save menu makes a PNG from a blob
    show = {"predict": predict, "speed": speed, "shows": shows, "narrow": [] if drawn else narrow_playbacks(trace)}
    data = json.dumps(show, separators=(",", ":"), ensure_ascii=False).replace("<", "\\u003c")
    first, last = (drawn[i] if drawn else picture(trace, i) for i in (0, -1))
    sentences = list(dict.fromkeys(s["sentence"] for s in shows[0]["steps"]))
    pictures = [f"<figure>{inline_svg(one, stem=stem)}</figure>" for one, stem in ((first, "first"), (last, "last"))]
    rest = [
        f'<pre tabindex="0">{escape(str(trace))}</pre>',
        "<h2>Step by step</h2>",
        "<ol>",
        *(f"<li>{escape(sentence)}</li>" for sentence in sentences),
        "</ol>",
    ]
    if predict:  # the answer is folded, also on paper
        shown = [pictures[0], "<details><summary>The answer</summary>", pictures[1], *rest, "</details>"]
    else:
        shown = [*pictures, *rest]
    body = [
        '<div id="satviz-player"></div>',
        '<section class="sv-static">',
        *shown,
        "</section>",
        f"<footer>{MADE_BY}</footer>",
        f'<script type="application/json" id="satviz-show">{data}</script>',
        f'<script type="module">{script}</script>',
    ]
    return _document(title, about, policy, body)


def _document(title: str, about: str, policy: str, body: Sequence[str]) -> str:
    """Return an HTML file with this title, description, content security policy and body."""
    style = (files(__package__) / "browser" / "page.css").read_text(encoding="utf-8")
    head = [f"<style>\n{stylesheet()}\n{style}</style>"]
    heading = f"<h1>{escape(describe.printable(title))}</h1>"
    return html_file(title, policy, head, ['<body class="satviz"><main>', heading, *body, "</main></body>"], about)


def html_file(title: str, policy: str, head: Sequence[str], body: Sequence[str], about: str = "") -> str:
    """Return an HTML file; `head`: the last lines of its head, `body`: all lines of its body with the body's tags.

    `policy` is the content security policy, and `about` the description for search engines, "" for none.
    """
    lines = [
        "<!doctype html>",
        '<html lang="en">',
        "<head>",
        '<meta charset="utf-8">',
        f'<meta http-equiv="Content-Security-Policy" content="{policy}">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        f'<meta name="generator" content="{MADE_BY}">',
        *([f'<meta name="description" content="{escape(describe.printable(about))}">'] if about else []),
        f"<title>{escape(describe.printable(title))}</title>",
        *head,
        "</head>",
        *body,
        "</html>",
    ]
    return "\n".join(lines) + "\n"


def _page_of_refused(case: FailureCase) -> str:
    """Return the page of a scene whose outlines are refused: its picture, without a script.

    The picture is as wide as a telephone and follows the colours of the reader's screen.
    """
    drawn = refused_picture(case, width=NARROW_SIZE_PT[0])
    figures = (f'<figure class="sv-{t.name}">{inline_svg(drawn, t, stem=t.name)}</figure>' for t in (LIGHT, DARK))
    body = ['<section class="sv-static">', *figures, "</section>", f"<footer>{MADE_BY}</footer>"]
    policy = "default-src 'none'; style-src 'unsafe-inline'; base-uri 'none'"
    return _document(drawn.sentence, drawn.sentence, policy, body)
