"""satviz site: a folder of static files that any web server serves."""

from collections.abc import Iterator
from hashlib import sha256
from importlib.resources import files
from pathlib import Path

from ..render.script import javascript, stylesheet
from ..safe_write import MADE_BY
from . import chapters, pages
from .runtime import Missing as Missing
from .runtime import runtime

ICON = (
    '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 32 32">'
    '<metadata xmlns:dc="http://purl.org/dc/elements/1.1/"><dc:title>{}</dc:title></metadata>'
    '<path d="M3 25 14 21 7 5z" fill="#0072B2"/><path d="M17 9 29 16 14 27z" fill="#D55E00"/></svg>\n'
)


def site(*, pyodide: Path | None = None, live: bool = True) -> tuple[Iterator[tuple[str, bytes]], list[str]]:
    """(path, content) of each file, and a line on each thing that is missing.

    `pyodide`: a folder with its core, instead of the npm package (Missing where it has none); `live`: with
    Python in the page.
    ImportError says what to install where the reader of Markdown is missing.
    """
    python: dict[str, bytes] = {}
    lacks: list[str] = []
    if live:
        try:
            python, why = runtime(pyodide)
            lacks = [why] if why else []
        except Missing as error:
            if pyodide:
                raise
            lacks = [f"{error}: the site is whole, but its scenes stay still"]
    script, style = _script(), _style()
    python |= {"worker.js": _own("worker.js")} if python else {}
    version = sha256(b"".join([script, style, *(python[name] for name in sorted(python))])).hexdigest()[:12]
    return _files(script, style, python, version), lacks


def _files(script: bytes, style: bytes, python: dict[str, bytes], version: str) -> Iterator[tuple[str, bytes]]:
    frame = pages.Frame(chapters.chapters(), version, bool(python))
    bodies = list(chapters.all_pages())  # what it needs may be missing: then nothing is written
    yield "site.js", script
    yield "site.css", style
    yield "sw.js", _own("sw.js").replace(b"VERSION", version.encode())
    yield "icon.svg", ICON.format(MADE_BY).encode()
    for name, data in python.items():
        yield f"python/{name}", data if not name.endswith(".js") else _marked(data)
    yield from pages.pictures()
    for chapter, body in bodies:
        yield chapter.path, pages.chapter(frame, chapter, body)
    yield "gallery.html", pages.gallery(frame)
    yield "challenges.html", pages.tasks(frame)
    yield "scene.html", pages.explorer(frame)
    yield "index.html", pages.front(frame)


def _script() -> bytes:
    """One plain script whose names stay its own: a module would not load from a file."""
    script = javascript("../../site/browser/site")
    return _marked(f'"use strict";\n{{\n{script}}}\n'.encode())


def _style() -> bytes:
    return f"/* {MADE_BY} */\n{stylesheet()}\n{_own('site.css').decode()}".encode()


def _own(name: str) -> bytes:
    data = (files(__package__) / "browser" / name).read_bytes()
    return _marked(data) if name.endswith(".js") else data


def _marked(script: bytes) -> bytes:
    mark = f"// {MADE_BY}\n".encode()
    return script if script.startswith(mark) else mark + script
