"""The walkthrough's notebooks as pages: prose, folded code, the stored outputs, and what can be dragged or stepped."""

import ast
import io
import json
import re
from collections.abc import Iterator
from contextlib import redirect_stdout
from html import escape
from typing import Any, NamedTuple

import satviz

from ..optional_imports import needs
from ..scenes.resolve import resolve
from ..widgets.explorer_model import ExplorerModel
from . import parts
from .themed import themed
from .walkthrough import shipped

WAY = re.compile(r"(Back|Next): \[")  # a notebook's own links to its neighbours: a page has its own
# what a notebook says of itself, and what a page says for it
OF_NOTEBOOKS = [
    (re.compile(r"(?<!\S)[^.\n]*Shift\+Enter[^.\n]*\. Then drag"), "Drag"),
    # a sentence that goes leaves the space before it, which parts its neighbours
    (re.compile(r"(?<!\S)[^.\s][^.\n]*Shift\+Enter[^.\n]*\.|\([^()]*(web page|run the cell)[^()]*\)"), ""),
    (re.compile(r"(?<=efore you )run (the next cell|the cell after it|a cell|it)\b"), "look"),
    (re.compile(r"\bThe next cell (shows|draws)\b"), "Below you see"),
    (re.compile(r"\bIn the next cell\b"), "Below"),
    (re.compile(r"\bin the next cell\b"), "below"),
    (re.compile(r"\bThe (next )?cell\b(?= [a-z]+s\b)"), "The code below"),
    (re.compile(r"\bthe (next cell|cell after it)\b"), "the code below"),
]


# bold words that end in a question mark, or in a colon with a question behind them
QUESTION = re.compile(r"\*\*[^*]*(\?\*\*|:\*\*.*\?)", re.DOTALL)
SUMMARY = "<summary>The answer</summary>"
FOLD = f"<details>{SUMMARY}"  # as a notebook folds the prose that answers
INSTEAD = (
    '<p class="instead">Here the notebook has a slider, which needs a Python of your own: <code>satviz notebook</code> '
    "gives you a copy to move it in.</p>"
)


class Widget(NamedTuple):
    """What a cell shows that can be dragged or stepped; does it answer a question, or can one try it out?"""

    html: str
    answers: bool


class Chapter(NamedTuple):
    """A chapter: its page, the title with its number, and the notebook's cells."""

    path: str
    title: str
    notebook: str
    cells: list[dict[str, Any]]


def chapters() -> list[Chapter]:
    """All chapters in their order."""
    found = []
    for path in shipped():
        cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
        title = "".join(cells[0]["source"]).partition("\n")[0].removeprefix("# ")
        found.append(Chapter(f"{path.stem}.html", title, path.name, cells))
    return found


def body(chapter: Chapter) -> str:
    """The chapter's HTML, whole without JavaScript; ImportError says what to install where nothing reads Markdown."""
    markdown, text, names = _markdown(), _Text(), _Names(chapter.cells)
    for i, cell in enumerate(chapter.cells):
        source = "".join(cell["source"])
        if cell["cell_type"] == "markdown":
            _prose(text, markdown, source)
            continue
        shown = names.widget(i)
        if shown is None or len(ast.parse(source).body) > 1:  # else the code says what the reader sees
            text.add(_code(source), asked=True)
        if shown:
            text.add(shown.html, asked=not shown.answers)
        elif not cell["outputs"] and isinstance(ast.parse(source).body[-1], ast.Expr):
            text.add(INSTEAD, asked=True)  # a widget of the notebook's own, which has no picture
        else:
            for output in sorted(cell["outputs"], key=_asks, reverse=True):
                text.add(_output(output), asked=_asks(output))
    return text.html()


class _Text:
    """A chapter's parts in order.  What answers a question is folded: all up to the next heading or question.

    What the question is about stands outside: all before it, and right after it code, shapes, and what can be tried.
    On paper, where nobody can open it, the answer is printed under its line.
    """

    def __init__(self) -> None:
        self.parts: list[str] = []
        self.answer: list[str] | None = None  # of the question that is open

    def add(self, html: str, *, asked: bool = False) -> None:
        """A part; `asked`: right after a question it is what the question is about."""
        outside = self.answer is None or (asked and not self.answer)
        (self.parts if outside or self.answer is None else self.answer).append(html)

    def ask(self, question: str) -> None:
        """A question, whose answer follows."""
        self.end()
        self.parts.append(question)
        self.answer = []

    def end(self) -> None:
        """The answer ends, if there is one."""
        if self.answer:
            self.parts.append(f'<details class="later">{SUMMARY}{"".join(self.answer)}</details>')
        self.answer = None

    def html(self) -> str:
        """The whole."""
        self.end()
        return "\n".join(self.parts)


def _prose(text: _Text, markdown: Any, source: str) -> None:
    """A cell of prose; its own fold of an answer, which a notebook needs, is a part of the page's."""
    for pattern, instead in OF_NOTEBOOKS:
        source = pattern.sub(instead, source)
    source = "\n\n".join(p for p in source.split("\n\n") if not WAY.match(p))
    env: dict[str, Any] = {}
    tokens = markdown.parse(re.sub(r"\]\(([\w-]+)\.ipynb\)", r"](\1.html)", source), env)
    folded = False
    for block in _blocks(tokens):
        first, html = block[0], markdown.renderer.render(block, markdown.options, env)
        if first.type == "html_block" and (
            first.content.startswith(FOLD) or (folded and html.startswith("</details>"))
        ):
            folded = not folded
            continue
        if first.type == "heading_open":
            text.end()
        if first.type == "paragraph_open" and QUESTION.search(block[1].content):
            text.ask(html)
        else:
            text.add(html)


def _blocks(tokens: list[Any]) -> Iterator[list[Any]]:
    """Headings, paragraphs, lists and so on, each with all that is in it."""
    begin = depth = 0
    for end, token in enumerate(tokens, 1):
        depth += token.nesting
        if not depth:
            yield tokens[begin:end]
            begin = end


def _markdown() -> Any:
    try:
        from markdown_it import MarkdownIt
    except ImportError:
        raise ImportError(needs("a site's chapters", "site")) from None
    markdown = MarkdownIt("commonmark", {"html": True, "highlight": _highlighted}).enable("table")
    markdown.add_render_rule("code_block", _indented)
    return markdown


def _indented(_renderer: Any, tokens: Any, i: int, _options: Any, _env: Any) -> str:
    return f'<pre tabindex="0"><code>{escape(tokens[i].content)}</code></pre>\n'


def _highlighted(code: str, _language: str, _attributes: str) -> str:
    from pygments import highlight
    from pygments.formatters import HtmlFormatter
    from pygments.lexers import PythonLexer

    return f'<pre class="code" tabindex="0">{highlight(code, PythonLexer(), HtmlFormatter(nowrap=True))}</pre>'


def _code(source: str) -> str:
    lines = source.count("\n") + 1
    says = "the code" if lines == 1 else f"the code, {lines} lines"
    return f'<details class="cell"><summary>{says}</summary>{_highlighted(source, "", "")}</details>'


def _asks(output: dict[str, Any]) -> bool:
    """Is it a picture of two shapes before any test?"""
    return "".join(output.get("data", {}).get("text/plain", "")).endswith("Do they collide?>")


def _output(output: dict[str, Any]) -> str:
    if output["output_type"] == "stream":
        return f'<pre class="out" tabindex="0">{escape("".join(output["text"]))}</pre>'
    data = {kind: "".join(value) for kind, value in output.get("data", {}).items()}
    if "image/svg+xml" in data:
        return f"<figure>{themed(data['image/svg+xml'])}</figure>"
    return f'<pre class="out" tabindex="0">{escape(data.get("text/plain", ""))}</pre>'


class _Names:
    """What a notebook's widgets show; cells are run only where what they show is worked out in the notebook."""

    def __init__(self, cells: list[dict[str, Any]]) -> None:
        self.sources = ["".join(cell["source"]) if cell["cell_type"] == "code" else "" for cell in cells]
        self.done = 0
        self.names: dict[str, Any] = {"sv": satviz}

    def widget(self, i: int) -> Widget | None:
        """The explorer or the player that cell i shows; None if it shows none."""
        *before, last = ast.parse(self.sources[i]).body or [ast.Pass()]
        call = last.value if isinstance(last, ast.Expr) else None
        if not isinstance(call, ast.Call) or ast.unparse(call.func) not in ("sv.play", "sv.explore"):
            return None
        if any(isinstance(node, ast.Name) and node.id != "sv" for each in call.args for node in ast.walk(each)):
            self._run([*self.sources[self.done : i], *map(ast.unparse, before)])
            self.done = i + 1
        what, *more = [eval(ast.unparse(argument), self.names) for argument in call.args]
        if ast.unparse(call.func) == "sv.explore":
            return Widget(parts.explorer(ExplorerModel(resolve(what, *more).scene)), answers=False)
        predict = any(word.arg == "predict" for word in call.keywords)
        return Widget(parts.player(resolve(what, *more).trace, predict=predict), answers=not predict)

    def _run(self, sources: list[str]) -> None:
        for source in sources:
            with redirect_stdout(io.StringIO()):
                exec(source, self.names)


def lead(chapter: Chapter) -> str:
    """The first sentence of the chapter's prose, for a list of chapters."""
    for paragraph in "".join(chapter.cells[0]["source"]).split("\n\n")[1:]:
        if not WAY.match(paragraph) and not paragraph.startswith("#"):
            return re.sub(r"[*`]|\]\([^)]*\)|\[", "", paragraph.partition("\n")[0])
    return ""


def all_pages() -> Iterator[tuple[Chapter, str]]:
    """Each chapter with its HTML."""
    for chapter in chapters():
        yield chapter, body(chapter)
