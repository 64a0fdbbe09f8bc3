"""The walkthrough's notebooks as pages: prose, folded code, the stored outputs, and what can be dragged or stepped."""

import ast
import io
import json
import re
from collections.abc import Iterator
from contextlib import redirect_stdout
from html import escape
from typing import Any, NamedTuple

from ..engine.trace import Trace
from ..extras import needs
from ..scenes.named import scene
from ..scenes.scenefile import Scene
from ..widgets.exploring import Exploring
from . import parts
from .themed import themed
from .walkthrough import shipped

WAY = re.compile(r"(Back|Next): \[")  # a notebook's own links to its neighbours: a page has its own


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
    markdown = _markdown()
    made, asked, names = [], False, _Names(chapter.cells)
    for i, cell in enumerate(chapter.cells):
        source = "".join(cell["source"])
        if cell["cell_type"] == "markdown":
            paragraphs = [p for p in source.split("\n\n") if not WAY.match(p)]
            made.append(markdown.render(re.sub(r"\]\(([\w-]+)\.ipynb\)", r"](\1.html)", "\n\n".join(paragraphs))))
            asked = bool(paragraphs) and "**" in paragraphs[-1] and "?" in paragraphs[-1]
        else:
            shown = names.widget(i)
            out = shown or "".join(map(_output, cell["outputs"]))
            made.append(_code(source, folded=shown is None))
            made.append(_later(out) if asked and out else out)
            asked = False
    return "\n".join(made)


def _markdown() -> Any:
    try:
        from markdown_it import MarkdownIt
    except ImportError:
        raise ImportError(needs("a site's chapters", "site")) from None
    return MarkdownIt("commonmark", {"html": True, "highlight": _highlighted}).enable("table")


def _highlighted(code: str, _language: str, _attributes: str) -> str:
    from pygments import highlight
    from pygments.formatters import HtmlFormatter
    from pygments.lexers import PythonLexer

    return f'<pre class="code">{highlight(code, PythonLexer(), HtmlFormatter(nowrap=True))}</pre>'


def _code(source: str, *, folded: bool) -> str:
    """The cell's code; beside what can be dragged it says nothing that the reader needs."""
    if not folded:
        return ""
    lines = source.count("\n") + 1
    says = "the code" if lines == 1 else f"the code, {lines} lines"
    return f'<details class="cell"><summary>{says}</summary>{_highlighted(source, "", "")}</details>'


def _later(out: str) -> str:
    return f'<details class="later"><summary>I have guessed: show it</summary>{out}</details>'


def _output(output: dict[str, Any]) -> str:
    if output["output_type"] == "stream":
        return f'<pre class="out">{escape("".join(output["text"]))}</pre>'
    data = {kind: "".join(value) for kind, value in output.get("data", {}).items()}
    if "image/svg+xml" in data:
        return f"<figure>{themed(data['image/svg+xml'])}</figure>"
    return f'<pre class="out">{escape(data.get("text/plain", ""))}</pre>'


class _Names:
    """What a notebook's widgets show: its cells are run up to each of them, and no further."""

    def __init__(self, cells: list[dict[str, Any]]) -> None:
        self.cells = cells
        self.done = 0
        self.names: dict[str, Any] = {}

    def widget(self, i: int) -> str | None:
        """HTML of the explorer or the player that cell i shows; None if it shows none."""
        call = _widget_call("".join(self.cells[i]["source"]))
        if call is None:
            return None
        for cell in self.cells[self.done : i]:
            if cell["cell_type"] == "code":
                with redirect_stdout(io.StringIO()):
                    exec("".join(cell["source"]), self.names)
        self.done = i + 1
        what, *more = [eval(ast.unparse(argument), self.names) for argument in call.args]
        if ast.unparse(call.func) == "sv.play":
            trace = what if isinstance(what, Trace) else what.record()
            return parts.player(trace, predict=any(word.arg == "predict" for word in call.keywords))
        shown = Scene("scene", what, *more) if more else scene(what) if isinstance(what, str) else what
        return parts.explorer(Exploring(shown))


def _widget_call(source: str) -> ast.Call | None:
    last = ast.parse(source).body[-1]
    if isinstance(last, ast.Expr) and isinstance(last.value, ast.Call):
        return last.value if ast.unparse(last.value.func) in ("sv.play", "sv.explore") else None
    return None


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
