"""The chapters' Markdown: their questions, the choices of a question, exercises, and the words of a page."""

import json
import re
from collections.abc import Iterator
from typing import Any, NamedTuple

from .shipped import shipped_notebooks

NEIGHBOUR_LINK = re.compile(r"(Back|Next): \[")  # a notebook's links to its neighbours; a page has other ones
# a comment in a paragraph of a notebook: the words that stand there on the page; none leave the paragraph out
PAGE_WORDS = re.compile(r"[\s\S]*<!-- page:\s*([\s\S]*?)\s*-->[\s\S]*")
CHOICES = "<!-- choices:"  # begins the comment with the choices of a question
CHOICE = re.compile(r"([+-]) (.+?) \| (.+)")  # a line of it: whether it is right, the choice, what is said about it
# a question: bold words that end in a question mark, or in a colon that a question follows
QUESTION = re.compile(r"\*\*[^*]*(\?\*\*|:\*\*.*\?)", re.DOTALL)
SUMMARY = "<summary>The answer</summary>"
FOLD = f"<details>{SUMMARY}"  # a notebook hides the answer to a question with this tag


class Chapter(NamedTuple):
    """A chapter: the path of its page, its title with the number, the notebook's file name and its cells."""

    path: str
    title: str
    notebook: str
    cells: list[dict[str, Any]]


def chapters() -> list[Chapter]:
    """Return all chapters in their order."""
    found = []
    for path in shipped_notebooks():
        cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
        title = "".join(cells[0]["source"]).partition("\n")[0].removeprefix("# ")
        found.append(Chapter(f"{path.stem}.html", title, path.name, cells))
    return found


def page_words(source: str) -> str:
    """Return a notebook's Markdown for a page of the site.

    The links to the chapters before and after are left out.  The text of a comment `<!-- page: ... -->` replaces its
    paragraph.
    """
    paragraphs = (PAGE_WORDS.sub(r"\1", p) for p in source.split("\n\n") if not NEIGHBOUR_LINK.match(p))
    return "\n\n".join(filter(None, paragraphs))


def link_targets(source: str) -> str:
    """Return Markdown whose links to notebooks lead to the pages of these chapters."""
    return re.sub(r"\]\(([\w-]+)\.ipynb\)", r"](\1.html)", source)


def choices_of(comment: str) -> list[tuple[str, str, str]]:
    """Return (sign, choice, reason) of each line of a comment with choices; the sign of the right one is "+", else "-".

    ValueError for a comment of another form, or without exactly one right choice.
    """
    lines = comment.strip().removeprefix(CHOICES).removesuffix("-->").strip().splitlines()
    found = [CHOICE.fullmatch(line.strip()) for line in lines]
    signs = [match[1] for match in found if match]
    if len(signs) < len(lines) or len(signs) < 2 or signs.count("+") != 1:
        raise ValueError(
            f"expected two or more lines '- choice | reason', exactly one of them with + instead of -: {comment}"
        )
    return [(match[1], match[2], match[3]) for match in found if match]


def blocks(tokens: list[Any]) -> Iterator[list[Any]]:
    """Yield, for each top-level block (a heading, a paragraph, a list ...), its tokens from a Markdown parser."""
    begin = depth = 0
    for end, token in enumerate(tokens, 1):
        depth += token.nesting
        if not depth:
            yield tokens[begin:end]
            begin = end
