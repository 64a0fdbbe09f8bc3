"""sv.embed: the HTML that puts a scene of a site into another page."""

from base64 import b64encode
from collections.abc import Sequence
from html import escape
from typing import Any

from ..engine import describe
from ..engine.geometry import InvalidScene
from ..engine.shapes import Shape
from ..pictures import THEMES, picture
from ..pictures.stages import step_range
from ..scenes.embedding import TABLE, TOOLS, EmbedOptions, query
from ..scenes.link import BREAK, PAGE, link
from ..scenes.resolve import SceneLike, resolve
from .files import encode

WIDTH_PX = 760  # width of the largest picture
LINE_PX = 150  # height of the sentence, the buttons and the link below the picture
TABLE_PX = 260
# The frame says how high its content is.  Where a page allows no script, the height stays as it is written.
SCRIPT = (
    'addEventListener("message",(e)=>{for(const f of document.querySelectorAll(".satviz-embed iframe"))'
    'if(f.contentWindow===e.source&&e.data?.satviz==="height")f.height=Math.min(Number(e.data.height)||0,4000)})'
)


def embed(
    what: SceneLike | Shape,
    b: Shape | None = None,
    *,
    site: str,
    play: bool = False,
    predict: bool = False,
    steps: tuple[int, int] | None = None,
    challenge: str | None = None,
    theme: str | None = None,
    show: Sequence[str] = (),
    **more: Any,
) -> str:
    """Return the HTML of a frame with a scene of a site; readers without scripts get a picture and its sentence.

    `what` is a scene (or its name), two shapes, or a trace, as `link` takes it; `more` are the options of `link`.
    `site` is the address of the site's folder, http or https.
    By default the shapes can be dragged.  `play` steps through the run, `predict` asks the reader for each result
    before it is shown, and `steps=(3, 8)` plays these steps alone (the first is 0).  `challenge` is "touch",
    "one-axis" or "break", or "" for the one that fits the scene.  `theme`: "light" or "dark", by default the reader's.
    `show` names what is shown beside the picture: "tools" and "table".
    InvalidScene for an address or a value that cannot be opened, ValueError for a scene that cannot be drawn.
    """
    if not site:
        raise InvalidScene("a frame needs the address of a site: give site=, such as https://example.org/satviz/")
    options = EmbedOptions(play, predict, steps, challenge, theme, tuple(show))
    found = resolve(what, b)
    folder, _, fragment = link(found, site=site, **more).partition(f"{PAGE}#")
    address = f"{folder}{PAGE}?{query(options)}#{fragment}"
    trace = found.trace
    if challenge == BREAK and not trace.shortcut:
        raise InvalidScene("the scene has no shortcut that could be broken: choose another challenge")
    if predict and trace.shortcut:
        trace = trace.truth
    step = more.get("step")
    last = step_range(trace, options.steps or (0, -1 if step is None else step))[1]
    drawn = picture(trace, 0 if predict else last)
    sentence = escape(describe.printable(drawn.sentence))
    data = b64encode(encode(drawn, "svg", THEMES[theme or "light"], stem="satviz")).decode()
    width, height = drawn.size
    tall = round(height * min(1.0, WIDTH_PX / width) if width > WIDTH_PX else height * WIDTH_PX / width)
    tall += LINE_PX + (TABLE_PX if TABLE in options.show else 0) + (LINE_PX // 2 if TOOLS in options.show else 0)
    title = "A collision test, step by step" if options.plays else "Two shapes to drag, and why they collide or not"
    lines = [
        '<figure class="satviz-embed" style="margin: 16px 0">',
        f'<iframe src="{escape(address)}" title="{title}" width="100%" height="{tall}" loading="lazy" '
        'style="border: 0; max-width: 1200px" allow="clipboard-write"></iframe>',
        "<noscript><style>.satviz-embed iframe { display: none }</style>"
        f'<img src="data:image/svg+xml;base64,{data}" width="{width:g}" height="{height:g}" '
        f'style="max-width: 100%; height: auto" alt=""><p>{sentence}</p></noscript>',
        f"<script>{SCRIPT}</script>",
        "</figure>",
    ]
    return "\n".join(lines) + "\n"
