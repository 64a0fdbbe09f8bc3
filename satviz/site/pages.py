"""The site's pages: the frame of each, the front page, the gallery, the explorer."""

from collections.abc import Sequence
from functools import cache
from html import escape
from typing import NamedTuple

from .. import __version__
from ..engine import describe
from ..pictures import Picture, picture
from ..pictures.playback import NARROW_PANELS
from ..render.files import encode
from ..safe_write import MADE_BY
from ..scenes.article import SCENES
from ..scenes.failing import FAILURE_CASES, REFUSED
from ..scenes.failing import NAMED as FAILING
from ..scenes.link import BREAK, PAGE, link
from ..scenes.named import ALL_SCENES, scene
from ..scenes.scenefile import Scene
from ..widgets.explorer_model import ExplorerModel
from ..widgets.goals import ASKS, challenges
from . import parts
from .chapters import Chapter, lead
from .themed import themed_file

# scripts are the site's own files, wasm is Python's; a scene comes in as data only; a blob is a picture saved as PNG
POLICY = (
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; connect-src 'self'; "
    "style-src 'self'; img-src 'self' blob:; base-uri 'none'; form-action 'none'"
)
FAILING_ON_FRONT = "aabb-turned", "no-nearest-vertex", "far-centers", "box-in-u"


class Frame(NamedTuple):
    """What all pages of a site share: the chapters, and whether Python is in the page (a version of its files)."""

    chapters: Sequence[Chapter]
    version: str
    python: bool


def page(frame: Frame, path: str, title: str, body: str, *, says: str, kind: str = "") -> bytes:
    """One page of the site; `says` describes it to those who search."""
    python = f' data-python="python/worker.js?{frame.version}"' if frame.python else ""
    links = [("index.html", "satviz"), ("index.html#chapters", "Chapters"), ("gallery.html", "Gallery")]
    links += [("challenges.html", "Challenges"), (PAGE, "Explorer")]
    here = ' aria-current="page"'
    nav = "".join(f'<a href="{to}"{here if to == path and to != "index.html" else ""}>{name}</a>' for to, name in links)
    lines = [
        "<!doctype html>",
        '<html lang="en">',
        "<head>",
        '<meta charset="utf-8">',
        f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        f'<meta name="generator" content="{MADE_BY}">',
        f'<meta name="description" content="{escape(describe.printable(says))}">',
        f"<title>{escape(title)}</title>",
        f'<link rel="stylesheet" href="site.css?{frame.version}">',
        '<link rel="icon" href="icon.svg" type="image/svg+xml">',
        f'<script defer src="site.js?{frame.version}"></script>',
        "</head>",
        f'<body class="satviz site {kind}"{python}>',
        '<a class="skip" href="#main">to the text</a>',
        f'<header><nav aria-label="site">{nav}</nav></header>',
        f'<main id="main">{body}</main>',
        f"<footer><p>{MADE_BY} {__version__}, which answers exactly: touching counts as a hit, and a verdict is never "
        "wrong.</p></footer>",
        "</body>",
        "</html>",
    ]
    return ("\n".join(lines) + "\n").encode()


def front(frame: Frame) -> bytes:
    """The front page: one scene to drag and one sentence; then what there is to read."""
    listed = "".join(
        f'<li><a href="{chapter.path}"><b>{escape(chapter.title)}</b></a><span>{escape(lead(chapter))}</span></li>'
        for chapter in frame.chapters
    )
    cards = "".join(_card(name) for name in FAILING_ON_FRONT)
    body = f"""
<div class="first">
<div class="says">
<h1>Do they collide?</h1>
<p class="lead"><b>Drag a triangle.</b> As long as some direction leaves a gap between their two shadows, they are
apart. If no direction does, they collide.</p>
</div>
<section class="stage" aria-label="two triangles to drag">{parts.explorer(ExplorerModel(scene("triangles")))}</section>
</div>
<section class="read">
<h2>That is the Separating Axis Theorem</h2>
<p>A program cannot see that two shapes are apart. It drops both onto a line, like shadows on a wall, and looks at the
two stretches they cover. <span class="gap">A gap</span> between the shadows proves that the shapes are apart.
<span class="overlap">An overlap</span> proves nothing, so it turns the wall and tries again. The theorem says which few
directions are enough: those at right angles to an edge.</p>
</section>
<section id="chapters"><h2>Seven chapters</h2><ol class="chapters">{listed}</ol></section>
<section><h2>Where shortcuts fail</h2>
<p>Everybody who writes a collision test leaves something out. Here is what happens then; the
<a href="gallery.html#failing">gallery</a> has {len(FAILURE_CASES)} such scenes,
and the <a href="challenges.html">challenges</a> let you find them yourself.</p>
<div class="cards wide">{cards}</div></section>
"""
    says = "Drag two triangles and see why they collide or not: the Separating Axis Theorem, made visible."
    return page(
        frame, "index.html", "Do they collide? The Separating Axis Theorem, made visible", body, says=says, kind="front"
    )


def gallery(frame: Frame) -> bytes:
    """Every scene with its picture and what is to be seen."""
    body = f"""
<h1>Gallery</h1>
<p class="lead">Every scene can be dragged: choose one.</p>
<section><h2>Scenes of the chapters</h2><div class="cards">{"".join(_card(s.name) for s in SCENES)}</div></section>
<section id="failing"><h2>Where shortcuts fail</h2>
<p>Left, what the shortcut saw; right, what is. Its claim stands above, the truth below.</p>
<div class="cards wide">{"".join(_card(row.name) for row in FAILURE_CASES)}</div></section>
"""
    return page(
        frame, "gallery.html", "Gallery: every scene of satviz", body, says="All scenes, and where shortcuts fail."
    )


def explorer(frame: Frame) -> bytes:
    """The page that a link opens; a link that opens nothing is told why, and offered every scene."""
    called = [(s.name, f"“{FAILING[s.name].claim}”" if s.name in FAILING else s.title) for s in ALL_SCENES]
    offered = "".join(f'<li><a href="{PAGE}#{name}">{escape(says)}</a></li>' for name, says in called)
    body = f"""
<h1>Explorer</h1>
<p class="lead">Drag the shapes, their corners, or a free axis.
The address of this page is a link to the scene as it stands.</p>
<noscript><p>This page needs JavaScript. Without it, nothing can be dragged, and the picture is always that of two
triangles. The <a href="gallery.html">gallery</a> has a still picture of every scene.</p></noscript>
<section class="stage">{parts.explorer(ExplorerModel(scene("triangles")))}</section>
<nav class="offer" aria-label="scenes" hidden><p>These scenes can be opened:</p>
<ul class="challenges">{offered}</ul></nav>
"""
    return page(
        frame, PAGE, "Explorer: drag two shapes", body, says="Drag two shapes and see every axis.", kind="explorer"
    )


def tasks(frame: Frame) -> bytes:
    """The challenges, each a link into the explorer."""
    asked = [
        (goal, f'<li><a href="{escape(link(begin, goal=goal))}">{escape(_asked(goal, begin))}</a></li>')
        for goal, begin in challenges()
    ]
    body = f"""
<h1>Challenges</h1>
<p class="lead">Drag until it is done. The engine judges exactly, and the address keeps your challenge: send it to
somebody.</p>
<ul class="challenges">{"".join(item for goal, item in asked if goal != BREAK)}</ul>
<h2>Break a shortcut</h2>
<p>Each of these is believed by many, and here it begins by being right. Find a place where it is wrong.</p>
<ul class="challenges">{"".join(item for goal, item in asked if goal == BREAK)}</ul>
"""
    return page(
        frame, "challenges.html", "Challenges", body, says="Break a shortcut, or make two shapes touch exactly."
    )


def _asked(goal: str, begin: Scene) -> str:
    row = FAILING.get(begin.axes)
    return f"“{row.claim}”" if row else f"{ASKS[goal].rstrip('.')} ({begin.title.lower()})"


def chapter(frame: Frame, shown: Chapter, body: str) -> bytes:
    """A chapter between its neighbours."""
    i = frame.chapters.index(shown)
    ways = []
    if i:
        ways.append(f'<a rel="prev" href="{frame.chapters[i - 1].path}">← {escape(frame.chapters[i - 1].title)}</a>')
    if i + 1 < len(frame.chapters):
        ways.append(f'<a rel="next" href="{frame.chapters[i + 1].path}">{escape(frame.chapters[i + 1].title)} →</a>')
    way = f'<nav class="way" aria-label="chapters">{"".join(ways)}</nav>'
    note = (
        f'<p class="note">This page is the notebook <code>{escape(shown.notebook)}</code> as it was run. '
        "<code>satviz notebook</code> gives you your own copy, to change and to run.</p>"
    )
    return page(
        frame, shown.path, shown.title, f"<article>{body}{note}</article>{way}", says=lead(shown), kind="chapter"
    )


def pictures() -> "list[tuple[str, bytes]]":
    """(path, file) of each scene's picture in the gallery."""
    found = [(name, _drawn(name)) for name in (*(s.name for s in SCENES), *FAILING)]
    found += [(f"{name}-narrow", _drawn(name, slim=True)) for name in FAILING]
    return [(f"pictures/{name}.svg", themed_file(encode(drawn, "svg", stem=name))) for name, drawn in found]


@cache
def _drawn(name: str, *, slim: bool = False) -> Picture:
    """A scene's picture, `slim` as a telephone shows it: both a file and what its card is made of."""
    return picture(name, largest=NARROW_PANELS[0]) if slim else picture(name)


def _card(name: str) -> str:
    row, drawn = FAILING.get(name), _drawn(name)
    if row is None:
        title, said = scene(name).title, drawn.sentence
    else:
        title, said = f"“{row.claim}”", row.how
    size = 'width="{:g}" height="{:g}"'.format(*drawn.size)
    image = f'<img src="pictures/{name}.svg" {size} alt="{escape(drawn.sentence)}">'
    if row:  # on a telephone one panel above the other
        slim = 'width="{:g}" height="{:g}"'.format(*_drawn(name, slim=True).size)
        source = f'<source media="(max-width: 600px)" srcset="pictures/{name}-narrow.svg" {slim}>'
        image = f"<picture>{source}{image}</picture>"
    shown = f"{image}<b>{escape(title)}</b>"
    if row is None or row.how != REFUSED:
        shown = f'<a href="{PAGE}#{name}">{shown}</a>'
    return f'<article class="card">{shown}<span>{escape(said)}</span></article>'
