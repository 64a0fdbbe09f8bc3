"""The questions and exercises of a chapter with their answers, as HTML."""

import re
from html import escape
from typing import Any, NamedTuple

from .chapter_text import CHOICES, FOLD, QUESTION, SUMMARY, Chapter, blocks, choices_of, page_words
from .markdown import markdown_parser
from .themed import themed_svg

LINK = re.compile(r"\[([^\]]*)\]\([^)]*\)")  # paper has no links
EXERCISE_FOLD = "<details><summary>Solution</summary>"
# hints for programs that the reader edits; a handout leaves them out
OTHER_FOLD = re.compile(rf"<details>(?!{SUMMARY})[\s\S]*?</details>")
EXERCISES = "## Exercises\n\n"  # the heading, which the first exercise follows in its cell
TOOLS = "sv.explore(", "slide("  # a question before these is answered by moving something, which paper cannot


class Question(NamedTuple):
    """A question or an exercise: the text before it, its words, its choices and its answer; all but signs is HTML.

    `before` ends with the last picture of the section; `choices` are (sign, choice, reason), the right one's is "+".
    """

    before: str
    words: str
    choices: tuple[tuple[str, str, str], ...]
    answer: str


def questions(chapter: Chapter) -> tuple[list[Question], list[Question]]:
    """Return the questions of a chapter that paper can ask, and its exercises.

    ImportError if no Markdown reader is installed.
    """
    found, in_exercises = _Collector(), False
    for cell in chapter.cells:
        source = "".join(cell["source"])
        if cell["cell_type"] == "code":
            found.add_outputs(cell, source)
            continue
        before, heading, exercise = page_words(source).rpartition(EXERCISES)
        in_exercises = in_exercises or bool(heading)
        if in_exercises and EXERCISE_FOLD in source:
            found.add_prose(before)
            found.add_exercise(exercise)
        else:
            found.add_prose(OTHER_FOLD.sub("", before + heading + exercise))
    found.close()
    return found.questions, found.exercises


class _Collector:
    """Collects questions from the cells of a chapter in their order."""

    def __init__(self) -> None:
        self.markdown = markdown_parser()
        self.questions: list[Question] = []
        self.exercises: list[Question] = []
        self.before: list[str] = []  # the paragraphs of the section so far
        self.picture = ""  # the last picture of the section
        self.asked: Question | None = None
        self.answer: list[str] = []

    def close(self) -> None:
        """Keep the question that was asked, with the answer collected so far."""
        if self.asked:
            self.questions.append(self.asked._replace(answer="".join(self.answer)))
        self.asked, self.answer = None, []

    def add_prose(self, source: str) -> None:
        """Add a Markdown cell: a heading ends an answer, a question begins one, a fold is a part of one."""
        folded = False
        for first, html, content in self._rendered(source):
            if first.type == "heading_open":
                self.close()
                self.before, self.picture = [], ""
            elif first.type == "html_block" and first.content.startswith(CHOICES) and self.asked:
                inline = self.markdown.renderInline
                choices = ((sign, inline(choice), inline(why)) for sign, choice, why in choices_of(first.content))
                self.asked = self.asked._replace(choices=tuple(choices))
            elif first.type == "html_block" and (FOLD in first.content or "</details>" in first.content):
                folded = FOLD in first.content
            elif folded and self.asked:
                self.answer.append(html)
            elif first.type == "paragraph_open" and QUESTION.search(content):
                self.close()
                self.asked = Question("".join(self.before[-2:]) + self.picture, html, (), "")
                self.before = []
            elif first.type == "paragraph_open" and not self.asked and not folded:
                self.before.append(html)

    def add_outputs(self, cell: dict[str, Any], source: str) -> None:
        """Add what a code cell shows: a part of the answer, or a picture that a question is about.

        A cell that shows a thing to move (`sv.explore` or a slider) drops the question before it, unfit for paper.
        """
        if self.asked and not self.answer and source.rsplit("\n", 1)[-1].startswith(TOOLS):
            self.asked = None
        for output in cell["outputs"]:
            data = output.get("data", {})
            svg = "".join(data.get("image/svg+xml", ""))
            text = "".join(data.get("text/plain", output.get("text", "")))
            shown = f"<figure>{themed_svg(svg)}</figure>" if svg else f'<pre tabindex="0">{escape(text)}</pre>'
            if self.asked and svg and text.endswith("Do they collide?>") and not self.answer:
                self.asked = self.asked._replace(before=self.asked.before + shown)
            elif self.asked:
                self.answer.append(shown)
            elif svg:
                self.picture = shown

    def add_exercise(self, source: str) -> None:
        """Add a Markdown cell with an exercise and its folded solution."""
        self.close()
        words, _, solution = source.partition(EXERCISE_FOLD)
        asked = "".join(html for _, html, _ in self._rendered(words))
        asked = re.sub(r"<p><strong>\d+\.</strong> ", "<p>", asked, count=1)
        self.exercises.append(Question("", asked, (), self.markdown.render(solution.removesuffix("</details>"))))

    def _rendered(self, source: str) -> list[tuple[Any, str, str]]:
        """Return (first token, HTML, Markdown of a paragraph) of each block."""
        env: dict[str, Any] = {}
        tokens = self.markdown.parse(LINK.sub(r"\1", source), env)
        render = self.markdown.renderer.render
        return [
            (block[0], render(block, self.markdown.options, env), block[1].content if len(block) > 1 else "")
            for block in blocks(tokens)
        ]
