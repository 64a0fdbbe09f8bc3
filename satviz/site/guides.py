"""The guides as pages of the site: Markdown files of the package, with links that work on GitHub and on the site."""

import re
from pathlib import Path
from typing import NamedTuple

from ..lessons.markdown import markdown_parser
from ..lessons.shipped import shipped_folder

FOLDER = Path(__file__).parent.parent / "guides"
INDEX = "guides.html"
LISTED = re.compile(r"^- \[[^\]]*\]\(([\w-]+)\.md\)", re.MULTILINE)  # the index names the guides in their order
# where a link of a guide leads on the site; a target of another form stays as it is
LINKS = [
    (re.compile(r"\]\(README\.md\b"), f"]({INDEX}"),
    (re.compile(r"\]\(([\w-]+)\.md\b"), r"](\1.html"),
    (re.compile(r"\]\(\.\./\.\./notebooks/([\w-]+)\.ipynb\)"), r"](\1.html)"),
]
PICTURES = re.compile(r"\.\./\.\./(figures/([\w-]+\.svg))")


class Guide(NamedTuple):
    """A guide: the path of its page, its title, the first sentence below the title, and its Markdown."""

    path: str
    title: str
    lead: str
    text: str


def guides() -> list[Guide]:
    """Return the index of the guides and then the guides in the index's order."""
    index = (FOLDER / "README.md").read_text(encoding="utf-8")
    names = LISTED.findall(index)
    return [_guide(INDEX, index), *(_guide(f"{name}.html", _read(name)) for name in names)]


def _read(name: str) -> str:
    """Return the Markdown of the guide with this name."""
    return (FOLDER / f"{name}.md").read_text(encoding="utf-8")


def _guide(path: str, text: str) -> Guide:
    """Return the Guide of a page's path and its Markdown; the title and first sentence come from the Markdown."""
    title, lead, *_ = text.split("\n\n", 2)
    return Guide(path, title.removeprefix("# "), re.split(r"(?<=[.?]) ", lead, maxsplit=1)[0], text)


def guide_body(guide: Guide) -> str:
    """Return the guide's HTML; raise ImportError if no Markdown reader is installed."""
    text = PICTURES.sub(r"\1", guide.text)
    for pattern, target in LINKS:
        text = pattern.sub(target, text)
    html: str = markdown_parser(anchors=True).render(text)
    return html.replace("<picture>", '<picture tabindex="0">')  # a wide picture scrolls, with the keyboard too


def pictures() -> list[tuple[str, bytes]]:
    """Return (path, content) of each picture that a guide shows."""
    found = {match[1]: match[2] for guide in guides() for match in PICTURES.finditer(guide.text)}
    folder = shipped_folder("figures")
    return [(path, (folder / name).read_bytes()) for path, name in sorted(found.items())]
