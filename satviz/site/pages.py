"""The pages of the site as HTML: the front page, chapters, guides, the gallery, the challenges, the explorer."""

from collections.abc import Sequence
from functools import cache
from html import escape
from typing import NamedTuple

from .. import __version__
from ..engine import describe
from ..lessons.chapter_text import Chapter
from ..lessons.handout import chapter_sheets
from ..lessons.themed import themed_svg_file
from ..pictures import Picture, picture
from ..pictures.layout import NARROW_SIZE_PT
from ..pictures.playback import NARROW_PANEL_SIZES_PT
from ..render.files import encode
from ..render.page import html_file
from ..safe_write import MADE_BY
from ..scenes.article import SCENES
from ..scenes.failing import FAILURE_CASES, REFUSED
from ..scenes.failing import NAMED as FAILING
from ..scenes.link import PAGE, TOUCH, link
from ..scenes.named import ALL_SCENES, scene
from ..scenes.scenefile import Scene
from ..widgets.explorer_model import ExplorerModel
from ..widgets.goals import GOAL_TASKS, challenges, level
from . import hosting, parts
from .chapters import GLOSSARY, lead
from .first_minute import SENTENCES, first_minute
from .guides import INDEX as GUIDES
from .guides import Guide

# scripts are the site's own files; WebAssembly is Python; a blob is a picture that is saved as PNG
POLICY = (
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; connect-src 'self'; "
    "style-src 'self'; img-src 'self' blob:; base-uri 'none'; form-action 'none'"
)
REFERENCE = "reference"  # the folder of its pages
# how a shortcut fails: the title of its group in the gallery, and what it means
HOW_IN_WORDS = {
    "false hit": ("False hits", "The shortcut says “hit”, but the shapes are apart."),
    "missed hit": (
        "Missed hits",
        "The shortcut says “apart”, but the shapes collide. They would go through each other.",
    ),
    "wrong number": ("Wrong numbers", "The yes or no is right, but a depth, a move or a distance is wrong."),
    REFUSED: ("Refused", "The outline is not a polygon, so no answer is right. satviz says what is wrong with it."),
}
# the levels of the challenges: title, and what is said about them
LEVELS = {
    1: ("First steps", "A few drags are enough."),
    2: ("For some thought", "Only a few places are right. First think about where they could be."),
    3: (
        "Hard to find",
        "Very few positions are right, and they need exact steps: switch on “snap”, or use the arrow keys.",
    ),
}
FAILING_ON_FRONT = "aabb-turned", "no-nearest-vertex", "far-centers", "box-in-u"


class SiteInfo(NamedTuple):
    """The facts that all pages of a site share: chapters, guides, the version of its files, and whether it has Python.

    `guides` begins with their index; `reference` says whether the site has the reference; `url` is the address of
    its folder, or empty if that is not known.
    """

    chapters: Sequence[Chapter]
    guides: Sequence[Guide]
    version: str
    python: bool
    reference: bool
    url: str = ""


def html_page(
    info: SiteInfo,
    path: str,
    title: str,
    body: str,
    *,
    description: str,
    kind: str = "",
    policy: str = POLICY,
    script: str = "",
) -> bytes:
    """Return the HTML of a page: `body` with head, navigation and footer.

    `description` is for search engines, `kind` a class for the style sheet, `policy` the content security policy, and
    `script` a file that is run before anything is painted.
    """
    first = f'<script src="{script}?{info.version}"></script>' if script else ""
    python = f' data-python="python/worker.js?{info.version}"' if info.python else ""
    links = [
        ("index.html", "satviz"),
        ("index.html#chapters", "Chapters"),
        (GUIDES, "Guides"),
        ("gallery.html", "Gallery"),
    ]
    links += [("challenges.html", "Challenges"), ("yours.html", "Is yours right?"), (PAGE, "Explorer")]
    links += [(f"{REFERENCE}/satviz.html", "Reference")] if info.reference else []
    here = ' aria-current="page"'
    nav = "".join(f'<a href="{to}"{here if to == path and to != "index.html" else ""}>{name}</a>' for to, name in links)
    head = [
        *hosting.head_lines(info.chapters, info.url, path, title, describe.printable(description)),
        f'<link rel="stylesheet" href="site.css?{info.version}">',
        '<link rel="icon" href="icon.svg" type="image/svg+xml">',
        f'<script defer src="site.js?{info.version}"></script>',
    ]
    lines = [
        f'<body class="satviz site {kind}"{python}>{first}',
        '<a class="skip" href="#main">to the text</a>',
        f'<header><nav aria-label="site">{nav}</nav></header>',
        f'<main id="main">{body}</main>',
        f"<footer><p>This site was {MADE_BY} {__version__}. Its answers are exact. "
        f'Shapes that touch count as a hit. The <a href="{GLOSSARY}">glossary</a> explains the terms.</p></footer>',
        "</body>",
    ]
    return html_file(title, policy, head, lines, description).encode()


def front_page(info: SiteInfo) -> bytes:
    """Return the front page: a scene to drag, the theorem in a few sentences, and lists of what there is."""
    listed = "".join(
        f'<li><a href="{chapter.path}"><b>{escape(chapter.title)}</b></a><span>{escape(lead(chapter))}</span></li>'
        for chapter in info.chapters
    )
    guides = "".join(f'<li><a href="{guide.path}">{escape(guide.title)}</a></li>' for guide in info.guides[1:])
    cards = "".join(_card(name) for name in FAILING_ON_FRONT)
    body = f"""
<div class="first">
<div class="says">
<h1>Do they collide?</h1>
<ol class="told">{"".join(f"<li>{sentence}</li>" for sentence in SENTENCES)}</ol>
<p class="lead"><b>Now you: drag a triangle.</b> If some line shows a gap, the triangles are apart. If no line shows a
gap, they collide.</p>
<p class="action"><a href="1-aabb.html">Begin with chapter 1</a></p>
</div>
<section class="stage" aria-label="two triangles to drag">{parts.explorer(ExplorerModel(scene("triangles")))}
{first_minute()}</section>
</div>
<section class="read">
<h2>That is the Separating Axis Theorem</h2>
<p>A program cannot see that two shapes are apart. It projects both shapes onto a line, which gives two ranges: their
shadows. <span class="gap">A gap</span> between the ranges proves that the shapes are apart.
<span class="overlap">An overlap</span> proves nothing, so the program tries the next line. The theorem says which few
lines are enough: those at right angles to an edge.</p>
<p>Games, robots and drawing programs ask this question thousands of times a second. A test that is nearly right lets a
ball fall through a floor. Here you see why, and you can check each answer yourself.</p>
</section>
<section id="chapters"><h2>The chapters</h2>
<p>They begin with two boxes and end with your own program. You need to know what a point is. The
<a href="{GLOSSARY}">glossary</a> has each term with a picture.</p>
<ol class="chapters">{listed}</ol></section>
<section><h2>Where shortcuts fail</h2>
<p>A collision test is often made shorter than the theorem allows. Then it is sometimes wrong. A <b>false hit</b> says
that two shapes collide, but they are apart. A <b>missed hit</b> says that they are apart, but they collide.</p>
<div class="cards failing">{cards}</div>
<p class="action"><a href="challenges.html">Break a shortcut yourself</a>
<a class="other" href="gallery.html#failing">See all {len(FAILURE_CASES)}</a></p></section>
<section><h2>Guides</h2>
<p>The <a href="{GUIDES}">guides</a> say how to use satviz in Python, in a notebook and on the command line.</p>
<ul class="challenges">{guides}</ul></section>
"""
    title = "Do they collide? The Separating Axis Theorem, made visible"
    description = "Drag two triangles and see why they collide or not: the Separating Axis Theorem, made visible."
    return html_page(info, "index.html", title, body, description=description, kind="front")


def gallery_page(info: SiteInfo) -> bytes:
    """Return the page with every scene: its picture and its sentence."""
    groups = {how: [row.name for row in FAILURE_CASES if row.how == how] for how in HOW_IN_WORDS}
    failing = "".join(
        f'<h3 id="{how.replace(" ", "-")}">{title} ({len(groups[how])})</h3><p>{words}</p>'
        f'<div class="cards failing">{"".join(map(_card, groups[how]))}</div>'
        for how, (title, words) in HOW_IN_WORDS.items()
    )
    jumps = "".join(
        f'<li><a href="#{how.replace(" ", "-")}">{title}</a></li>' for how, (title, _) in HOW_IN_WORDS.items()
    )
    body = f"""
<h1>Gallery</h1>
<p class="lead">Each picture shows two shapes, whether they collide, and what proves it. A test that proves less is
sometimes wrong: {len(FAILURE_CASES)} pictures show how. If you write collision tests, you have probably written one of
these. <b>Choose a picture and drag its shapes.</b> The answer changes as you drag.</p>
<p class="action"><a href="{PAGE}#{SCENES[0].name}">Begin with two boxes</a>
<a class="other" href="#failing">See where shortcuts fail</a></p>
<section><h2>Scenes of the chapters</h2>
<p>Each chapter explains one kind of shape.</p>
<div class="cards">{"".join(_card(s.name) for s in SCENES)}</div></section>
<section id="failing"><h2>Where shortcuts fail</h2>
<p>A shortcut leaves out a part of the test. Each picture shows first what the shortcut claims, and then what is
true.</p>
<ul class="jumps">{jumps}</ul>
{failing}</section>
"""
    description = "Pairs of shapes to drag: what proves that they collide or not, and where shortcuts fail."
    return html_page(info, "gallery.html", "Gallery: every scene of satviz", body, description=description)


def explorer_page(info: SiteInfo) -> bytes:
    """Return the page that a link opens; if a link cannot be opened, the page says why and offers every scene."""
    titles = [(s.name, f"“{FAILING[s.name].claim}”" if s.name in FAILING else s.title) for s in ALL_SCENES]
    offered = "".join(f'<li><a href="{PAGE}#{name}">{escape(title)}</a></li>' for name, title in titles)
    body = f"""
<h1>Explorer</h1>
<p class="lead">Drag the shapes, or <b>paste your own</b> below. The address of this page opens the scene as it is
now.</p>
<noscript><p>This page needs JavaScript. Without JavaScript you cannot drag anything, and the picture always shows two
triangles. The <a href="gallery.html">gallery</a> has a still picture of every scene.</p></noscript>
<section class="stage">{parts.explorer(ExplorerModel(scene("triangles")))}</section>
<nav class="offer" aria-label="scenes" hidden><p>These scenes can be opened:</p>
<ul class="challenges">{offered}</ul></nav>
"""
    description = "Drag two shapes and see every axis."
    title = "Explorer: drag two shapes"
    return html_page(info, PAGE, title, body, description=description, kind="explorer", script="embed.js")


def not_found_page(info: SiteInfo) -> bytes:
    """Return the page for an address that leads to no page."""
    body = """
<h1>There is no such page</h1>
<p class="lead">The address may be old, or a letter of it may be missing.</p>
<ul><li><a href="index.html">The front page</a> has a list of the chapters and of the guides.</li>
<li>The <a href="gallery.html">gallery</a> shows every scene.</li></ul>
"""
    title, description = "There is no such page", "This address leads to no page of the site."
    page = html_page(info, hosting.NOT_FOUND, title, body, description=description)
    return hosting.not_found_page_with_absolute_links(page, info.url)


def challenges_page(info: SiteInfo) -> bytes:
    """Return the page of the challenges; each of them is a link to the explorer."""
    items: dict[int, list[str]] = {number: [] for number in LEVELS}
    for goal, begin in challenges():
        text, to = escape(_challenge_text(goal, begin)), escape(link(begin, goal=goal))
        items[level(goal, begin)].append(
            f'<li data-challenge="{goal}:{escape(begin.name)}"><a href="{to}">{text} '
            '<span class="mark"></span></a></li>'
        )
    listed = "".join(
        f'<section><h2>{title}</h2><p>{words}</p><ul class="tiles">{"".join(items[number])}</ul></section>'
        for number, (title, words) in LEVELS.items()
    )
    body = f"""
<h1>Challenges</h1>
<p class="lead">Each claim in quotation marks is a shortcut that many people believe. Each challenge
starts with shapes for which its claim is right. <b>Drag the shapes until it is wrong.</b> If you have broken a shortcut
once, you will not use it. If you give up, most scenes show in red where the claim is wrong.</p>
<p class="action"><a href="{escape(link(scene("aabb"), goal=TOUCH))}">Begin with the first challenge</a></p>
<p class="progress"><span class="count" role="status" tabindex="-1"></span>
<button type="button" hidden>Forget what I have solved</button></p>
{listed}
<p class="note">What you have solved is kept in this browser only. The address of a challenge opens it for anybody.</p>
"""
    description = "Break a shortcut, or make two shapes touch exactly."
    return html_page(info, "challenges.html", "Challenges", body, description=description)


def _challenge_text(goal: str, begin: Scene) -> str:
    """Return the words of a challenge: a shortcut's claim, or the goal and the scene where it begins."""
    row = FAILING.get(begin.axes)
    return f"“{row.claim}”" if row else f"{GOAL_TASKS[goal].rstrip('.')} ({begin.title.lower()})"


def chapter_page(info: SiteInfo, chapter: Chapter, body: str) -> bytes:
    """Return the page of a chapter, with links to the chapters before and after it."""
    note = (
        '<p class="note">This chapter is also a notebook in which you can change the programs: see '
        '<a href="notebook.html">Drag and play in a notebook</a>. For a class there are '
        f'<a href="{_handout_path(chapter)}">its questions on paper</a>, and their solutions.</p>'
    )
    body = f"<article>{body}{note}</article>{_neighbour_links(info.chapters, chapter, 'chapters')}"
    return html_page(info, chapter.path, chapter.title, body, description=lead(chapter), kind="chapter")


def handout_pages(info: SiteInfo, chapter: Chapter) -> list[tuple[str, bytes]]:
    """Return (path, content) of the page with a chapter's questions to print, and of the page with their solutions."""
    asked, solved = chapter_sheets(chapter)
    pages = (_handout_path(chapter), asked, "solutions"), (_handout_path(chapter, "-solutions"), solved, "questions")
    found = []
    for i, (path, sheet, other) in enumerate(pages):
        note = (
            '<p class="to-print">Print this page, or save it as a PDF. It fits A4 and Letter. '
            f'See also <a href="{pages[1 - i][0]}">the {other}</a> and '
            f'<a href="{chapter.path}">the chapter</a>.</p>'
        )
        title, description = f"{sheet.title} (handout)", f"A handout to print: {sheet.title}."
        made = html_page(info, path, title, note + sheet.body, description=description, kind="handout")
        found.append((path, made))
    return found


def _handout_path(chapter: Chapter, end: str = "") -> str:
    """Return the path of the page with a chapter's questions, or if `end` is "-solutions" with their solutions."""
    return f"handout-{chapter.title.split()[0]}{end}.html"


def guide_page(info: SiteInfo, guide: Guide, body: str) -> bytes:
    """Return the page of a guide, with links to the guides before and after it."""
    body = f"<article>{body}</article>{_neighbour_links(info.guides, guide, 'guides')}"
    return html_page(info, guide.path, guide.title, body, description=guide.lead, kind="chapter")


def _neighbour_links(pages: Sequence[Chapter] | Sequence[Guide], page: Chapter | Guide, label: str) -> str:
    """Return links to the pages before and after `page` in a sequence, as HTML; the ends have one link."""
    i = [other.path for other in pages].index(page.path)
    links = []
    if i:
        links.append(f'<a rel="prev" href="{pages[i - 1].path}">← {escape(pages[i - 1].title)}</a>')
    if i + 1 < len(pages):
        links.append(f'<a rel="next" href="{pages[i + 1].path}">{escape(pages[i + 1].title)} →</a>')
    return f'<nav class="way" aria-label="{label}">{"".join(links)}</nav>'


def scene_pictures() -> list[tuple[str, bytes]]:
    """Return (path, content) of each picture in the gallery."""
    found = [(name, _scene_picture(name)) for name in (*(s.name for s in SCENES), *FAILING)]
    return [(f"pictures/{name}.svg", themed_svg_file(encode(drawn, "svg", stem=name))) for name, drawn in found]


@cache
def _scene_picture(name: str) -> Picture:
    """Return a scene's Picture, as narrow as a card: two panels stand one above the other."""
    return picture(name, largest=NARROW_PANEL_SIZES_PT[0] if name in FAILING else NARROW_SIZE_PT)


def _card(name: str) -> str:
    """Return a scene's picture, title and sentence as HTML, with a link to the explorer if the scene can be opened."""
    row, drawn = FAILING.get(name), _scene_picture(name)
    if row is None:
        title, sentence = scene(name).title, drawn.sentence
    else:
        title, sentence = f"“{row.claim}”", row.how
    size = 'width="{:g}" height="{:g}"'.format(*drawn.size)
    said = drawn.sentence
    if row and row.how != REFUSED:  # the sentence of a refused case says already what is refused
        said += " " + " ".join(drawn.mark("wrong").text.split())
    image = f'<img src="pictures/{name}.svg" {size} alt="{escape(said)}">'
    shown = f"{image}<b>{escape(title)}</b>"
    if row is None or row.how != REFUSED:
        shown = f'<a href="{PAGE}#{name}">{shown}</a>'
    return f'<article class="card">{shown}<span>{escape(sentence)}</span></article>'
