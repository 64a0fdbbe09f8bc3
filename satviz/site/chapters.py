"""The walkthrough's notebooks as pages: prose, folded code, stored outputs, explorers and players."""

import ast
import io
import re
from collections.abc import Callable
from contextlib import redirect_stdout
from html import escape
from typing import Any, NamedTuple

import satviz

from ..lessons.chapter_text import (
    CHOICES,
    FOLD,
    QUESTION,
    SUMMARY,
    Chapter,
    blocks,
    choices_of,
    link_targets,
    page_words,
)
from ..lessons.glossary import TermLinker
from ..lessons.markdown import highlighted_code, markdown_parser
from ..lessons.themed import themed_svg
from ..pictures import Picture
from ..pictures.layout import NARROW_SIZE_PT
from ..scenes.resolve import resolve
from ..widgets.explorer_model import ExplorerModel
from . import parts

GLOSSARY = "glossary.html"
FRAMES = 13  # number of pictures of a slider
NARROWED: dict[
    str, dict[str, Any]
] = {  # functions that draw a picture in a cell, with the arguments that draw it for a telephone
    "sv.picture": {"largest": NARROW_SIZE_PT},
    "sv.gap_curve": {"width": NARROW_SIZE_PT[0]},
}
REST = '<details class="rest"><summary>Go on when you have answered</summary>'


class Widget(NamedTuple):
    """An explorer, a player or a slider as HTML; `answers`: does it show the answer to the question before it?"""

    html: str
    answers: bool


def chapter_body(chapter: Chapter) -> str:
    """Return the chapter's HTML, which needs no JavaScript; raise ImportError if no Markdown reader is installed."""
    markdown, text, widgets = markdown_parser(), _FoldedText(), _WidgetFinder(chapter.cells)
    terms = TermLinker(GLOSSARY)
    for i, cell in enumerate(chapter.cells):
        source = "".join(cell["source"])
        if cell["cell_type"] == "markdown":
            _add_prose(text, markdown, terms, source)
            continue
        shown = widgets.widget(i)
        if shown is None or len(ast.parse(source).body) > 1:  # the code of a widget alone says nothing more
            checks = _checked_function(source) != ""
            text.add(_code(source, is_open=checks), part_of_question=True, before_choices=checks or shown is not None)
        if shown:
            text.add(shown.html, part_of_question=not shown.answers, before_choices=True)
        else:
            for output in sorted(cell["outputs"], key=_is_question_picture, reverse=True):
                asked = _is_question_picture(output)
                html = _output_html(output, widgets.narrow_picture(i))
                text.add(html, part_of_question=asked, before_choices=asked)
    return text.html()


class _FoldedText:
    """The parts of a chapter in order, with the answer to each question folded.

    An answer is everything from its question up to the next heading or question.  What belongs to the question stays
    outside the fold: code, shapes and explorers that follow the question directly, then its choices.  The rest of the
    chapter would give a question with choices away, so it stands in a fold of its own after the answer.
    """

    def __init__(self) -> None:
        self.parts: list[str] = []
        self.answer: list[str] | None = None  # the parts of the present answer; None where no question is open
        self.choices = ""  # the choices of the present question, until they are placed
        self.has_choices = False  # does the present question have some?
        self.rests = 0  # folds with the rest of the chapter, each inside the one before

    def add(self, html: str, *, part_of_question: bool = False, before_choices: bool = False) -> None:
        """Add a part; with `part_of_question` it stays unfolded if it follows the question directly.

        With `before_choices` it then stands above the choices of the question, and otherwise below them.
        """
        outside = self.answer is None or (part_of_question and not self.answer)
        if not before_choices or not outside:
            self._place_choices()
        (self.parts if outside or self.answer is None else self.answer).append(html)

    def ask(self, question: str) -> None:
        """Add a question; the parts that follow are its answer."""
        self.end_answer()
        self.parts.append(question)
        self.answer = []

    def offer(self, choices: str) -> None:
        """Add the choices of the question that was just asked, below the shapes that it is about."""
        assert self.answer == [], f"these choices follow no question: {choices}"
        self.choices = choices
        self.has_choices = True

    def _place_choices(self) -> None:
        """Add the choices of the present question here, unless they are placed already."""
        if self.choices:
            self.parts.append(self.choices)
        self.choices = ""

    def end_answer(self) -> None:
        """Place the choices, and fold the answer that was added so far, if there is one."""
        self._place_choices()
        if self.answer:
            self.parts.append(f'<details class="later">{SUMMARY}{"".join(self.answer)}</details>')
            if self.has_choices:
                self.parts.append(REST)
                self.rests += 1
        self.answer = None
        self.has_choices = False

    def html(self) -> str:
        """Return the HTML of all parts, after folding the answer that is still open."""
        self.end_answer()
        if self.parts[-1] == REST:  # nothing follows the last answer
            self.parts.pop()
            self.rests -= 1
        return "\n".join(self.parts) + "</details>" * self.rests


def _add_prose(text: _FoldedText, markdown: Any, terms: TermLinker, source: str) -> None:
    """Add a notebook's Markdown cell `source` to `text`: as HTML, in the words of a page, with terms linked.

    The notebook's own folds are left out, since the page folds answers itself.
    """
    source = page_words(source)
    env: dict[str, Any] = {}
    tokens = markdown.parse(link_targets(source), env)
    folded = False
    for block in blocks(tokens):
        first, html = block[0], markdown.renderer.render(block, markdown.options, env)
        if first.type == "html_block" and (
            first.content.startswith(FOLD) or (folded and html.startswith("</details>"))
        ):
            folded = not folded
            continue
        if first.content.startswith(CHOICES):
            text.offer(_choices_html(markdown, first.content))
            continue
        if first.type == "heading_open":
            text.end_answer()
        if first.type in ("paragraph_open", "bullet_list_open", "ordered_list_open"):
            html = terms.linked(html)
        if first.type == "paragraph_open" and QUESTION.search(block[1].content):
            text.ask(html)
        else:
            text.add(html)


def _choices_html(markdown: Any, comment: str) -> str:
    """Return the choices in a notebook's comment as an HTML list; the reason of a choice is shown once it is chosen."""
    items = []
    for sign, choice, why in choices_of(comment):
        right = " data-right" if sign == "+" else ""
        words, reason = markdown.renderInline(choice), markdown.renderInline(why)
        items.append(f'<li{right}><span>{words}</span> <span class="why" hidden>{reason}</span></li>')
    return f'<ul class="choices">{"".join(items)}</ul>'


def _code(source: str, *, is_open: bool) -> str:
    """Return the code of a cell as HTML, folded unless `is_open`."""
    lines = source.count("\n") + 1
    summary = "the code" if lines == 1 else f"the code, {lines} lines"
    opened = " open" if is_open else ""
    return f'<details class="cell"{opened}><summary>{summary}</summary>{highlighted_code(source)}</details>'


def programs(chapter: Chapter) -> dict[str, tuple[str, str]]:
    """Return {function: (heading, code)} of the programs that a chapter opens on the page "Is yours right?".

    The code of a program is its function and all that it uses, as defined in the chapter up to there, and what its
    own cell imports.
    """
    opened = {name for cell in chapter.cells for name in re.findall(r"yours\.html#(\w+)", "".join(cell["source"]))}
    found, known, heading = {}, dict[str, str](), ""
    for cell in chapter.cells:
        source = "".join(cell["source"])
        if cell["cell_type"] == "markdown":
            heading = ([heading, *re.findall(r"^##+ (.+)$", source, re.MULTILINE)])[-1]
            continue
        imported = set[str]()
        for node in ast.parse(source).body:
            code = ast.get_source_segment(source, node) or ""
            if isinstance(node, ast.FunctionDef):
                known.pop(node.name, None)  # a function that is defined again moves after the names that it uses
                known[node.name] = f"\n\n{code}\n"
            elif isinstance(node, ast.ImportFrom):
                known |= {alias.name: f"from {node.module} import {alias.name}\n" for alias in node.names}
                imported |= {alias.name for alias in node.names}
        name = _checked_function(source)
        if name in opened:
            words = {each: _words(code) for each, code in known.items()}
            imports_first = sorted(used_by({name} | imported, words), key=lambda n: known[n].startswith("\n"))
            found[name] = heading, "".join(known[n] for n in imports_first).lstrip("\n")
    return found


def used_by(names: set[str], known: dict[str, set[str]]) -> list[str]:
    """Return these names and the known names that their code uses, directly or not, in the order of `known`.

    `known`: for each name the words in its code.
    """
    needed, new = set[str](), names
    while new:
        needed |= new
        new = ({word for each in new for word in known[each]} & known.keys()) - needed
    return [each for each in known if each in needed]


def _words(code: str) -> set[str]:
    """Return the names that Python code uses."""
    return {node.id for node in ast.walk(ast.parse(code)) if isinstance(node, ast.Name)}


def _checked_function(source: str) -> str:
    """Return the name of the function that a cell gives to `sv.check`; "" if its last line is not such a call."""
    last = (ast.parse(source).body or [ast.Pass()])[-1]
    called = re.fullmatch(r"sv\.check\((\w+)\)", ast.unparse(last))
    return called[1] if called else ""


def _is_question_picture(output: dict[str, Any]) -> bool:
    """Return True for the picture of two shapes before any test, which belongs to the question."""
    return "".join(output.get("data", {}).get("text/plain", "")).endswith("Do they collide?>")


def _output_html(output: dict[str, Any], narrow: Picture | None) -> str:
    """Return a cell's stored output as HTML: its picture if it has one, else its text.

    `narrow`: the same picture drawn for a telephone, or None.
    """
    if output["output_type"] == "stream":
        return f'<pre class="out" tabindex="0">{escape("".join(output["text"]))}</pre>'
    data = {kind: "".join(value) for kind, value in output.get("data", {}).items()}
    words = f'<pre class="out" tabindex="0">{escape(data.get("text/plain", ""))}</pre>'
    if "image/svg+xml" in data:
        # what `sv.check` found has both
        report = f'<div class="report">{words}</div>' if "<pre>" in data.get("text/html", "") else ""
        if narrow:
            wide = themed_svg(data["image/svg+xml"])
            both = f'<div class="wide">{wide}</div><div class="narrow">{parts.svg_element(narrow)}</div>'
            return f"<figure>{both}</figure>"
        return f"{_figure(data['image/svg+xml'])}{report}"
    return words


def _figure(svg: str, attributes: str = "") -> str:
    """Return an SVG as an HTML figure; a point of its canvas is a pixel, so that letters have 11 px on a telephone."""
    sized = re.sub(r'(width|height)="([\d.]+)pt"', r'\1="\2"', themed_svg(svg), count=2)
    return f'<figure tabindex="0"{attributes}>{sized}</figure>'  # on a telephone a wide picture scrolls, with keys too


class _WidgetFinder:
    """Finds the widgets of a notebook, and the pictures that are drawn again for a telephone.

    Cells are run only if the arguments of such a call use names of the notebook.
    """

    def __init__(self, cells: list[dict[str, Any]]) -> None:
        """Read the code of a notebook's cells; nothing is run yet."""
        self.sources = ["".join(cell["source"]) if cell["cell_type"] == "code" else "" for cell in cells]
        self.next_to_run = 0
        self.names: dict[str, Any] = {"sv": satviz}

    def widget(self, i: int) -> Widget | None:
        """Return the explorer, the player or the slider that cell i shows; None if it shows none."""
        call, function = self._last_call(i)
        if call is None or function not in ("sv.play", "sv.explore", "slide"):
            return None
        self._run_for(call, i)
        what, *more = [eval(ast.unparse(argument), self.names) for argument in call.args]
        if function == "slide":
            return Widget(_slider_html(what, *more), answers=False)
        if function == "sv.explore":
            return Widget(parts.explorer(ExplorerModel(resolve(what, *more).scene)), answers=False)
        predict = any(word.arg == "predict" for word in call.keywords)
        return Widget(parts.player(resolve(what, *more).trace, predict=predict), answers=not predict)

    def narrow_picture(self, i: int) -> Picture | None:
        """Return the picture that cell i shows, drawn for a telephone; None if it shows none of a run or a curve."""
        call, function = self._last_call(i)
        narrowed = NARROWED.get(function)
        if call is None or narrowed is None:
            return None
        self._run_for(call, i)
        keywords = {word.arg: eval(ast.unparse(word.value), self.names) for word in call.keywords if word.arg}
        arguments = [eval(ast.unparse(argument), self.names) for argument in call.args]
        drawn: Picture = eval(function, self.names)(*arguments, **keywords, **narrowed)
        return drawn

    def _last_call(self, i: int) -> tuple[ast.Call | None, str]:
        """Return the call that is the last line of cell i, and its function's name; (None, "") if that is no call."""
        last = (ast.parse(self.sources[i]).body or [ast.Pass()])[-1]
        call = last.value if isinstance(last, ast.Expr) else None
        return (call, ast.unparse(call.func)) if isinstance(call, ast.Call) else (None, "")

    def _run_for(self, call: ast.Call, i: int) -> None:
        """Run the cells up to cell i, and what stands before its call, if the call uses names of the notebook.

        The names that they define are kept, and what they print is not.
        """
        if any(isinstance(node, ast.Name) and node.id != "sv" for each in call.args for node in ast.walk(each)):
            before = ast.parse(self.sources[i]).body[:-1]
            for source in (*self.sources[self.next_to_run : i], *map(ast.unparse, before)):
                with redirect_stdout(io.StringIO()):
                    exec(source, self.names)
            self.next_to_run = i + 1


def _slider_html(draw: Callable[[float], Any], least: float, most: float, begin: float) -> str:
    """Return as HTML the pictures `draw(value)` of a notebook's slider for values from `least` to `most`.

    The page shows one at a time, that of `begin` first.
    """
    values = sorted({begin, *(least + (most - least) * i / (FRAMES - 1) for i in range(FRAMES))})
    frames = (_figure(draw(value)._repr_svg_(), "" if value == begin else " hidden") for value in values)
    return f'<div class="frames">{"".join(frames)}</div>'


def lead(chapter: Chapter) -> str:
    """Return the first line of a chapter's prose as plain text, for the list of chapters."""
    for paragraph in page_words("".join(chapter.cells[0]["source"])).split("\n\n")[1:]:
        if not paragraph.startswith("#"):
            return re.sub(r"[*`]|\]\([^)]*\)|\[", "", paragraph.partition("\n")[0])
    return ""
