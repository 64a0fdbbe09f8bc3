"""satviz site: a folder of static files that any web server serves."""

import re
from collections.abc import Iterator
from hashlib import sha256
from importlib.resources import files
from pathlib import Path

from ..lessons.chapter_text import chapters
from ..lessons.handout import style_sheet as handout_style
from ..render.script import javascript, stylesheet
from ..safe_write import MADE_BY
from ..scenes.link import site_folder
from . import check_page, glossary_page, guides, hosting, pages
from .chapters import GLOSSARY, chapter_body
from .reference import reference
from .runtime import PythonMissing as PythonMissing
from .runtime import runtime_files

# the parts of a style sheet that only its authors need
COMMENT_OR_INDENT = re.compile(r"/\*.*?\*/\n?|^ +", re.DOTALL | re.MULTILINE)
ICON = (
    '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 32 32">'
    '<metadata xmlns:dc="http://purl.org/dc/elements/1.1/"><dc:title>{}</dc:title></metadata>'
    '<path d="M3 25 14 21 7 5z" fill="#0072B2"/><path d="M17 9 29 16 14 27z" fill="#D55E00"/></svg>\n'
)


def site(
    *, pyodide: Path | None = None, live: bool = True, url: str = ""
) -> tuple[Iterator[tuple[str, bytes]], list[str]]:
    """Return (path, content) of each file of the site, and a line of text for each part that is missing.

    `pyodide` is a folder that holds Pyodide's core; None takes the core from npm.  `live=False` leaves Python out.
    `url` is the address of the site's folder: with it, pages say where they are, and there is a sitemap.
    Raise PythonMissing if that folder has no core, and ImportError if no Markdown reader is installed.
    """
    url = site_folder(url, "the address")
    python: dict[str, bytes] = {}
    missing: list[str] = []
    if live:
        try:
            python, why = runtime_files(pyodide)
            missing = [why] if why else []
        except PythonMissing as error:
            if pyodide:
                raise
            missing = [f"{error}. Without it the site is whole, but its scenes stay still"]
    try:
        reference_files = list(reference(in_site=True))
    except ImportError as error:
        reference_files = []
        missing.append(f"the site has no reference: {error}")
    script, style = _script(), _style()
    python |= {"worker.js": javascript("../../site/browser/worker").encode()} if python else {}
    version = sha256(
        b"".join([script, style, _browser_file("embed.js"), *(python[name] for name in sorted(python))])
    ).hexdigest()[:12]
    return _with_sitemap(_files(script, style, python, version, reference_files, url), url), missing


def _files(
    script: bytes,
    style: bytes,
    python: dict[str, bytes],
    version: str,
    reference_files: list[tuple[str, bytes]],
    url: str,
) -> Iterator[tuple[str, bytes]]:
    """Yield (path, content) of each file of the site; `version` is part of the links to its scripts and styles."""
    info = pages.SiteInfo(chapters(), guides.guides(), version, bool(python), bool(reference_files), url)
    chapter_bodies = [chapter_body(chapter) for chapter in info.chapters]  # may raise: then nothing is written
    yield "site.js", script
    yield "site.css", style
    yield "embed.js", _browser_file("embed.js")
    yield "sw.js", _browser_file("sw.js").replace(b"VERSION", version.encode())
    yield "icon.svg", ICON.format(MADE_BY).encode()
    for name, data in python.items():
        yield f"python/{name}", data if not name.endswith(".js") else _with_maker(data)
    yield from pages.scene_pictures()
    yield from hosting.social_pictures(info.chapters)
    yield from glossary_page.pictures()
    yield from guides.pictures()
    for chapter, body in zip(info.chapters, chapter_bodies, strict=True):
        yield chapter.path, pages.chapter_page(info, chapter, body)
    for chapter in info.chapters:
        for path, data in pages.handout_pages(info, chapter):
            yield path, data
    for guide in info.guides:
        yield guide.path, pages.guide_page(info, guide, guides.guide_body(guide))
    for path, data in reference_files:
        yield f"{pages.REFERENCE}/{path}", data
    yield GLOSSARY, glossary_page.glossary_page(info)
    yield "gallery.html", pages.gallery_page(info)
    yield "challenges.html", pages.challenges_page(info)
    yield check_page.PATH, check_page.check_page(info)
    yield "scene.html", pages.explorer_page(info)
    yield "index.html", pages.front_page(info)
    yield hosting.NOT_FOUND, pages.not_found_page(info)
    yield "robots.txt", hosting.robots_txt(url)


def _with_sitemap(found: Iterator[tuple[str, bytes]], url: str) -> Iterator[tuple[str, bytes]]:
    """Yield the files, and then a sitemap of the pages among them if the site's address is known."""
    listed = []
    for path, data in found:
        yield path, data
        if path.endswith(".html") and "/" not in path and path != hosting.NOT_FOUND:
            listed.append(path)
    if url:
        yield "sitemap.xml", hosting.sitemap(url, listed)


def _script() -> bytes:
    """Return the pages' script as a classic script in a block, since a page opened from disk loads no modules."""
    script = javascript("../../site/browser/site")
    return _with_maker(f'"use strict";\n{{\n{script}}}\n'.encode())


def _style() -> bytes:
    """Return the pages' style sheet."""
    rules = f"{stylesheet()}\n{_browser_file('site.css').decode()}\n{handout_style()}"
    return f"/* {MADE_BY} */\n{COMMENT_OR_INDENT.sub('', rules)}".encode()


def _browser_file(name: str) -> bytes:
    """Return a file of the folder `browser`; a script says in its first line that satviz made it."""
    data = (files(__package__) / "browser" / name).read_bytes()
    return _with_maker(data) if name.endswith(".js") else data


def _with_maker(script: bytes) -> bytes:
    """Return the script with a first line that names satviz, so that `satviz site` may overwrite the file."""
    mark = f"// {MADE_BY}\n".encode()
    return script if script.startswith(mark) else mark + script
