"""sv.handout: questions to print, with empty axes and tables to fill in; the solutions on a sheet of their own."""

from html import escape
from importlib.resources import files
from math import ceil, log10
from pathlib import Path
from typing import Literal, NamedTuple, get_args

from ..engine import describe
from ..engine.geometry import InvalidScene
from ..engine.shapes import Circle, Shape
from ..engine.trace import Trace
from ..pictures import Picture, picture
from ..pictures.float_geometry import bounding_box
from ..pictures.layout import NARROW_SIZE_PT
from ..pictures.number_lines import number_lines
from ..pictures.playback import table_rows
from ..pictures.sheet import MAX_ROWS
from ..render.notebook import bundle
from ..render.page import html_file
from ..scenes.failing import NAMED
from ..scenes.resolve import Resolved, SceneLike, resolve
from ..scenes.scenefile import Scene
from .chapter_text import Chapter, chapters
from .questions import Question, questions
from .themed import themed_svg

Paper = Literal["A4", "letter"]
WORKSHEETS = {  # the scenes that are computed by hand in the handout of a chapter
    "1": ("aabb", "aabb-rotated"),
    "2": ("triangles",),
    "3": ("circles", "circle-polygon"),
    "4": ("concave",),
    "6": ("one-shapes-normals",),
}
COLLIDE, SOLUTIONS = "Do they collide?", ": solutions"  # the title of a scene without one; the end of a title
MAX_CORNERS = 12  # corners of a shape that are listed; for a larger shape 'and 5 more' follows
FIGURES = 6  # digits of a coordinate near the origin, at most
COLOURS = ("A", "B", "gap", "ink", "move"), ("overlap", "guide", "wrong")  # black, and grey


class Sheet(NamedTuple):
    """A handout or its solutions: the title and the HTML of its body."""

    title: str
    body: str


def handout(*what: SceneLike, paper: Paper = "A4", solutions: bool = False) -> str:
    """Return one HTML file to print, in black and white: questions and no answers, or the solutions alone.

    Each `what` is a chapter ("2" or "2-sat"), a scene or its name, or a trace.  A scene has its picture, an empty
    number line for each axis, and a table to fill in, at most 12 axes.  `paper` is "A4" or "letter".
    ValueError for another paper, InvalidScene for a scene that is not known or has no run, ImportError for a chapter
    where no Markdown reader is installed.
    """
    if paper not in get_args(Paper):
        raise ValueError(f"paper is {paper!r}: expected one of {', '.join(get_args(Paper))}")
    if not what:
        raise ValueError("nothing to print: pass a chapter such as '2', or a scene")
    sheets = [sheets_of(each)[solutions] for each in what]
    title = " · ".join(sheet.title for sheet in sheets)
    style = f"@page {{ size: {paper}; margin: 16mm; }}\n{style_sheet()}"
    body = ['<body class="handout"><main>', *(sheet.body for sheet in sheets), "</main></body>"]
    policy = "default-src 'none'; style-src 'unsafe-inline'"
    return html_file(title, policy, [f"<style>\n{style}</style>"], body)


def style_sheet() -> str:
    """Return the style sheet of a handout, also for a page of the site."""
    black, grey = (
        " ".join(f"--sv-{role}: {value}; --sv-text-{role}: {value};" for role in roles)
        for roles, value in zip(COLOURS, ("#000", "#555"), strict=True)
    )
    return f".handout {{ --sv-paper: #fff; {black} {grey} }}\n{(files(__package__) / 'handout.css').read_text()}"


def sheets_of(what: SceneLike) -> tuple[Sheet, Sheet]:
    """Return the questions and the solutions of a chapter or of a scene."""
    chapter = chapter_named(what) if isinstance(what, str) else None
    if chapter:
        return chapter_sheets(chapter)
    given = resolve(what)
    name, title = (given.given.name, _title_of(given)) if isinstance(given.given, Scene) else ("", COLLIDE)
    asked, solved = _worksheet(given.trace, name)
    return _sheet(title, asked), _sheet(f"{title}{SOLUTIONS}", solved)


def chapter_named(name: str) -> Chapter | None:
    """Return the chapter of that number, name or file; None if there is none."""
    stem = name.removesuffix(".ipynb")
    return next((c for c in chapters() if stem in (c.title.split()[0], Path(c.notebook).stem)), None)


def chapter_sheets(chapter: Chapter) -> tuple[Sheet, Sheet]:
    """Return the questions and the solutions of a chapter: scenes by hand, its questions, its exercises."""
    asked, solved = [], []
    for name in WORKSHEETS.get(chapter.title.split()[0], ()):
        resolved = resolve(name)
        one, other = _worksheet(resolved.trace, name)
        heading = f"<h2>{escape(_title_of(resolved))}</h2>"
        asked.append(f'<section class="by-hand">{heading}{one}</section>')
        solved.append(f'<section class="by-hand">{heading}{other}</section>')
    found, exercises = questions(chapter)
    for heading, items in ("Questions", found), ("Exercises", exercises):
        if items:
            numbered = [*enumerate(items, 1)]
            asked.append(f"<section><h2>{heading}</h2>{''.join(_question_html(n, q) for n, q in numbered)}</section>")
            solved.append(f"<section><h2>{heading}</h2>{''.join(_solution_html(n, q) for n, q in numbered)}</section>")
    return _sheet(chapter.title, "".join(asked)), _sheet(f"{chapter.title}{SOLUTIONS}", "".join(solved))


def _sheet(title: str, body: str) -> Sheet:
    """Return a sheet whose body has the title, and on questions a line for the reader's name."""
    kind, name = ("sheet", '<p class="name">Name</p>') if not title.endswith(SOLUTIONS) else ("sheet solutions", "")
    return Sheet(title, f'<article class="{kind}"><header><h1>{escape(title)}</h1>{name}</header>{body}</article>')


def _title_of(found: Resolved) -> str:
    """Return the title of a worksheet's scene, or a question if the title would give away the answer."""
    scene = found.scene
    if scene.name in NAMED:
        return "Is the claim right?"
    named = scene.title and scene.title != scene.name and not found.trace.false_hit
    return describe.printable(scene.title) if named else COLLIDE


def _question_html(number: int, question: Question) -> str:
    """Return question `number` (from 1) with boxes to tick or lines to write on, as HTML."""
    boxes = "".join(f"<li>{words}</li>" for _, words, _ in question.choices)
    space = f'<ul class="boxes">{boxes}</ul>' if boxes else _lines(3)
    return f'<div class="question" data-number="{number}">{question.before}{question.words}{space}</div>'


def _solution_html(number: int, question: Question) -> str:
    """Return the answer of question `number` (from 1), with the reason for each choice, as HTML."""
    marks = {"+": "✓", "-": "✗"}
    said = "".join(f"<li>{marks[sign]} <b>{words}</b>: {why}</li>" for sign, words, why in question.choices)
    choices = f'<ul class="judged">{said}</ul>' if said else ""
    return f'<div class="question" data-number="{number}">{choices}{question.answer}</div>'


def _lines(count: int) -> str:
    """Return empty lines to write on, as HTML."""
    return f'<div class="lines" aria-hidden="true">{"<div></div>" * count}</div>'


def _worksheet(trace: Trace, name: str) -> tuple[str, str]:
    """Return the HTML of a scene to compute by hand, and of its solution; a shortcut's scene is solved exactly.

    `name`: the scene's.  InvalidScene for a scene that cannot be drawn.
    """
    case, true = NAMED.get(name), trace.truth
    if not trace.shortcut and case:
        case = None
    whole = true.without_early_exit()
    try:
        shapes = picture(true, 0, by_itself=True)
        verdict = picture(true, largest=NARROW_SIZE_PT, by_itself=True)
    except ValueError as error:
        raise InvalidScene(str(error)) from None
    x0, y0, x1, y1 = bounding_box([true.a, true.b])
    figures = FIGURES + max(0, ceil(log10(max(-x0, -y0, x1, y1) / max(x1 - x0, y1 - y0))))  # more far from the origin
    corners = "".join(
        f"<p><b>{escape(name)}</b>: {_coordinates(shape, name, figures)}</p>"
        for name, shape in zip(true.names, (true.a, true.b), strict=True)
    )
    claim = f"<p>Somebody says: “{escape(case.claim)}” Is this right for these shapes?</p>" if case else ""
    ask = (
        "<ol><li>Calculate the range of each shape on each axis. Draw both ranges on the number line, and write them "
        "into the table.</li><li>Write down the gap where the ranges are apart. Where they overlap, write “overlap” "
        "and how long the overlap is.</li><li>Which axes separate the shapes? Do the shapes collide? How do you know?"
        "</li></ol>"
    )
    asked = f"{claim}{_figure(shapes)}{corners}{ask}"
    asked += f"{_table(whole, filled=False)}{_figure(number_lines(whole, filled=False), 'axes')}{_lines(2)}"
    how = f"<p>{escape(case.how)}</p>" if case else ""
    solved = f"<p>{escape(describe.printable(true.sentence))}</p>{how}"
    solved += f"{_table(whole, filled=True)}{_figure(number_lines(whole, filled=True), 'axes')}{_figure(verdict)}"
    return asked, solved


def _coordinates(shape: Shape, name: str, figures: int) -> str:
    """Return a shape's coordinates as HTML, each with at most `figures` significant figures; vertices have names."""
    corners = (shape.vertices or shape.core)[:MAX_CORNERS]
    points = [f"({_number(x, figures)}, {_number(y, figures)})" for x, y in corners]
    if isinstance(shape, Circle):
        return escape(f"circle, center {points[0]}, radius {_number(shape.radius, figures)}")
    shown = ", ".join(f"{describe.vertex_name(shape, name, i)} {point}" for i, point in enumerate(points))
    return escape(
        shown + (f" and {len(shape.vertices) - MAX_CORNERS} more" if len(shape.vertices) > MAX_CORNERS else "")
    )


def _number(value: float, figures: int) -> str:
    """Return a coordinate as text with at most `figures` significant figures and a real minus sign."""
    return f"{value:.{figures}g}".replace("-", "−")


def _table(trace: Trace, *, filled: bool) -> str:
    """Return the table of a run's tests, at most 12, as HTML; `filled`: with ranges and gaps, else with empty cells."""
    heads = ("axis", "direction", f"range of {trace.names.a}", f"range of {trace.names.b}", "gap", "separates?")
    head = "<td></td>" + "".join(f'<th scope="col">{escape(name)}</th>' for name in heads)
    lines, pair = [], ""
    rows = [row for row in table_rows(trace) if "reason" not in row]
    for row in rows[:MAX_ROWS]:
        if row["pair"] != pair:
            pair = row["pair"]
            lines.append(f'<tr><th scope="rowgroup" colspan="7">{escape(pair)}</th></tr>')
        result = (row["a"], row["b"], row["outcome"], "yes" if row["gap"] > 0 else "no") if filled else ("",) * 4
        cells = (str(row["number"]), row["axis"], row["direction"], *result)
        lines.append("<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in cells) + "</tr>")
    more = f"<p>These are the first {MAX_ROWS} of {len(rows)} axes.</p>" if len(rows) > MAX_ROWS else ""
    kind = "solved" if filled else "to-fill"
    table = f'<table class="{kind}"><thead><tr>{head}</tr></thead><tbody>{"".join(lines)}</tbody></table>'
    return f'<div class="table" tabindex="0">{table}</div>{more}'


def _figure(drawn: Picture, kind: str = "") -> str:
    """Return a picture as an HTML figure of the class `kind`, whose colours come from the handout's style sheet."""
    of_kind = f' class="{kind}"' if kind else ""
    return f"<figure{of_kind}>{themed_svg(bundle(drawn)['image/svg+xml'])}</figure>"
