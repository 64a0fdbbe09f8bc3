"""sv.paste: shapes out of a text, how they lie, why, and what others would say."""

import json
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from typing import Any, NamedTuple

from ...engine import convex_parts, number_format, text_table
from ...engine.geometry import InvalidScene, InvalidShape, Relation
from ...engine.relate import relate
from ...engine.shapes import Shape
from ...engine.trace import ShapeNames, Trace, record
from .. import minimal_test
from ..link import link
from ..scenefile import MAX_VERTICES, Scene
from . import findings, others
from .boxes import ALL_CHOICES, CHOICES, ONLY_IF_IT_MATTERS, Read
from .cleaned import cleaned
from .findings import KINDS, Finding, PastedShape, listed
from .notations import SHAPE_WORDS, Ask, Form, key
from .objects import as_text
from .pair_findings import AnsweredPair, clear, findings_of_pair
from .parser import parse
from .reading import Reader
from .tree import Group
from .unused import numbers_by_key, rest

MAX_SHAPES = 40
MAX_TRACES = 60
MAX_PART_PAIRS = 4_000  # pairs of convex parts in all traces together; a second of work
MAX_LABEL = 80  # characters before a shape in which its name is looked for
# words before a shape that do not name it, unless with a number or another word: Test 1
GENERAL_WORDS = frozenset(["code", "data", "input", "inputs", "test", "case", "style", "this", "here", "following"])
ARTICLES = r"(?!(?:an?|the|my|this|that|of|is)\b)"  # words that are no name
MAX_NAMED = 5  # parts that are not understood, in one line
# Points with decimal commas: (0,5; 1,5), POLYGON((0,5 1,5, 2,5 0,5, ...)), three of (0,5, 1,5), x;y;r over 0,5;1,5;2,
# name;0,5;1,5, rows of 0,5;1,5 and of 0,5<tab>1,5, six or more as 0,5; 1,5
_N = r"[-+]?\d+,\d+"
DECIMAL = re.compile(
    rf"\([ ]?{_N}[ ]?;[ ]?{_N}[ ]?\)|\(\s*{_N} +{_N}\s*,|[\[(]\s*(?:\({_N}, +{_N}\)\s*,\s*){{2}}\({_N}, +{_N}\)"
    rf"|^[A-Za-z]\w*(?:[;\t][A-Za-z]\w*)+[ \r]*\n(?:[^\n,]+\n){{0,9}}+[^\n,]*(?<=\d),\d+[;\t\r\n]"
    rf"|^\w+;[ ]?{_N};[ ]?{_N}\b|^{_N}[;\t]{_N}[ \r]*\n{_N}[;\t]{_N}[ \r]*$|(?<!\d){_N}(?:;[ ]?{_N}){{5,}}+",
    re.MULTILINE,
)
COMMA = re.compile(r"(?<=\d),(?=\d)")
NOTHING = (
    "no shape was found{}: paste two shapes or more, as WKT, GeoJSON, JSON or lines of code, "
    "for example POLYGON((0 0, 4 0, 0 3)) and circle((5, 1), 2)"
)
ASKS = {
    "box": "What are the numbers of the box?",
    "angle": "Is the angle in degrees or in radians?",
    "turn": "Does y point up or down? A positive angle turns the other way there.",
    "order": "Does the width come first, or the height?",
    "pivot": "Around which point is the shape turned?",
    "twice": "A name has two values. Is each of them a shape, or only the last one?",
    "round": "Is the last number of the circle its radius or its diameter?",
    "rest": "Not understood:",
    "commas": "Does a comma stand for a decimal point, or between two numbers?",
    "corners": "Are the corners relative to the position, or absolute already?",
}
CHOICE_WORDS = {
    "corner-size": "a corner, then width and height",
    "corner-corner": "two opposite corners",
    "center-size": "the center, then width and height",
    "center-half": "the center, then half of width and height",
    "x-then-y": "the two x, then the two y",
    "degrees": "the angle in degrees",
    "radians": "the angle in radians",
    "y-up": "y up, angles counter-clockwise",
    "y-down": "y down, angles clockwise",
    "width-first": "width before height",
    "height-first": "height before width",
    "around-center": "turned around its center",
    "around-corner": "turned around its corner",
    "around-origin": "turned around the origin (0, 0)",
    "relative": "corners relative to the position",
    "absolute": "corners absolute already, and turned",
    "unturned": "corners absolute already, but not turned by the angle yet",
    "radius": "the radius",
    "diameter": "the diameter",
    "each-value": "each value of a name",
    "last-value": "the last value of a name",
    "decimal-commas": "0,5 is 0.5",
    "separators": "0,5 is 0 and 5",
    "leave-out": "the shapes as read, without it",
    "take-in": "a shape of its own",
}


# What a reading without a part that is not understood drops, by the meaning of its key.
DROPPED = {
    "position": frozenset(["center", "corner", "opposite", "offset", "min", "max"]),
    "size": frozenset(["size", "half", "width", "height", "radius", "diameter"]),
    "angle": frozenset(["angle", "degrees", "radians"]),
}
BEFORE_NUMBER = re.compile(r"([A-Za-z_]{3,40}) -?[.\d]")


class Answer(NamedTuple):
    """One reading that is possible: its name for `as_`, what it means, and the relation that it gives."""

    choice: str
    meaning: str
    gives: str


class PasteQuestion(NamedTuple):
    """A place where two readings are possible, or that is not understood; `matters`: no reading was taken."""

    what: str
    asks: str
    answers: tuple[Answer, ...]
    matters: bool

    def __str__(self) -> str:
        answers = (f"  --as {answer.choice}: {answer.meaning} -> {answer.gives}" for answer in self.answers)
        return "\n".join((self.asks, *answers))


@dataclass(frozen=True, slots=True, repr=False)
class Pasted:
    """Shapes out of a text, and the findings about them.

    `readings`: every shape as it was read, also those that are refused; `questions`: where two readings are possible;
    `pairs`: the pairs that are answered, the nearest first; `findings`: the diagnosis, the main one first; `without`:
    the answer without what was not understood, where only that is asked and two shapes are left.
    """

    text: str
    chosen: tuple[str, ...]
    readings: tuple[PastedShape, ...]
    questions: tuple[PasteQuestion, ...]
    pairs: tuple[AnsweredPair, ...]
    findings: tuple[Finding, ...]
    without: "Pasted | None" = None

    @property
    def open(self) -> bool:
        """Return whether a question must be answered first: the relation depends on it, or a part is not understood."""
        return any(question.matters for question in self.questions)

    @property
    def shapes(self) -> tuple[Shape, ...]:
        """Return the shapes that are valid; none while a question is open whose answers give different relations."""
        return () if self.open else tuple(each.shape for each in self.readings if each.shape)

    @property
    def traces(self) -> tuple[Trace, ...]:
        """Return a trace for each pair of valid shapes that meet, the nearest first; the nearest pair if none meet."""
        return tuple(pair.trace for pair in self.pairs if pair.a.shape and pair.b.shape)

    @property
    def sentence(self) -> str:
        """Return the answer in one sentence."""
        if self.open:
            for question in self.questions:
                if question.what == "rest":
                    doubtful = any(answer.choice == Form.TAKE_IN for answer in question.answers)
                    way = "Choose which it is" if doubtful else "Write the result in its place"
                    return f"{question.asks} {way}, or take the shapes without it."
            count = max(len(question.answers) for question in self.questions if question.matters)
            words = {2: "Two", 3: "Three", 4: "Four"}.get(count, "Several")
            return f"{words} readings are possible, and they give different answers: choose one."
        if len(self.readings) == 1:
            unread = any(finding.kind == "not-read" for finding in self.findings)
            more = "mend what was not read, or paste" if unread else "paste"
            return f"One shape was read ({self.readings[0].said}): {more} a second one to compare it with."
        refused = [each for each in self.readings if not each.shape]
        if not self.traces:
            names = listed([each.name for each in refused])
            words = "are not valid shapes" if len(refused) > 1 else "is not a valid shape"
            start = f"{names} {words}, so there is no answer"
            if self.pairs:
                (first, *_) = self.pairs
                names = f"{first.a.name} and {first.b.name}"
                return f"{start}; in the order that was probably meant {names} are {first.trace.relation}."
            return f"{start}."
        if len(self.readings) > 2:
            usable = [shape for each in self.readings if (shape := each.usable)]
            hits = sum(relate(a, b) is not Relation.APART for a, b in combinations(usable, 2))
            shown = f"; {len(self.traces)} of them are shown" if hits > len(self.traces) else ""
            said = f"{hits} of {_pair_count(len(self.shapes))} pairs meet{shown}."
            return f"{said} {self.traces[0].sentence}"
        return self.traces[0].sentence

    def others(self, number: int = 0) -> tuple[others.View, ...]:
        """Return the answers of other definitions about a pair, by its number in `pairs`."""
        pair = self.pairs[number]
        return tuple(others.views(pair.trace.a, pair.trace.b, pair.lies, pair.gap))

    def scene(self, number: int = 0) -> Scene:
        """Return a pair as a scene, for a link, a scene file or a picture; InvalidScene where there is no pair."""
        if not self.pairs:
            raise InvalidScene(self.sentence)
        pair = self.pairs[number]
        return Scene("pasted", pair.trace.a, pair.trace.b, title=f"{pair.a.title} and {pair.b.title}"[:200])

    def link(self, number: int = 0, *, site: str = "") -> str:
        """Return the link that opens a pair on a site; InvalidScene where there is no pair."""
        return link(self.scene(number), site=site)

    @property
    def wkt(self) -> str:
        """Return the valid shapes as WKT, one a line."""
        return "\n".join(minimal_test.wkt(each.shape) for each in self.readings if each.shape)

    def test(self, language: str, number: int = 0) -> str:
        """Return a pair as a minimal test in "javascript", "python", "cpp", "csharp", "rust" or "java"."""
        scene = self.scene(number)
        return minimal_test.minimal_test(scene.a, scene.b, language)

    def __repr__(self) -> str:
        return f"<Pasted: {self.sentence}>"

    def __str__(self) -> str:
        return self.report()

    def report(self, *, sentence: bool = True, shapes: bool = True) -> str:
        """Return everything as text; False leaves out the answer in one sentence, or how the shapes were read."""
        return "\n".join(self._lines(sentence, self.readings if shapes else ()))

    def _lines(self, sentence: bool, readings: Sequence[PastedShape]) -> Iterator[str]:
        """Yield the lines of the report; `sentence`: with the answer in one sentence; `readings`: shapes to name."""
        for each in readings:
            yield f"{each.title}: {each.said}{', refused' if not each.shape else ''}"
            yield f"    read from: {each.excerpt}"
        about_rest = [question for question in self.questions if sentence and question.what == "rest"]
        for question in self.questions[:1] if self.without else self.questions:
            yield ""
            # the answer's sentence is this question with a remedy: it is said once
            yield str(question._replace(asks=self.sentence) if question in about_rest else question)
            if not self.open:
                yield f"  The relation is the same; {question.answers[0].choice} was taken."
        if sentence and not about_rest:
            yield ""
            yield number_format.ascii_minus(self.sentence)
        if self.without:
            yield ""
            yield "Without it:"
            yield self.without.report(shapes=False)
        elif self.findings:
            yield ""
            yield "What lies behind it:"
            yield from (f"- {number_format.ascii_minus(str(finding))}" for finding in self.findings)
        for number, pair in enumerate(self.pairs):
            if number == 3:
                yield ""
                yield f"and {len(self.pairs) - 3} more pairs"
                break
            yield ""
            order = "" if pair.a.shape and pair.b.shape else ", in the order that was probably meant"
            yield f"{pair.a.name} and {pair.b.name}{order}: {pair.trace.relation}"
            yield text_table.table(pair.trace)
            yield "What other definitions say:"
            yield from (
                f"- {view.definition}: {view.answer} ({number_format.ascii_minus(view.why)})"
                for view in self.others(number)
            )

    def data(self) -> dict[str, Any]:
        """Return all that a page shows, as JSON values."""
        return {
            "sentence": self.sentence,
            "open": self.open,
            **({"without": self.without.data()} if self.without else {}),
            "shapes": [
                {
                    "name": each.name,
                    "label": each.label,
                    "said": each.said,
                    "excerpt": each.excerpt,
                    "start": each.read.start,
                    "end": each.read.end,
                    "vertices": [list(v) for v in each.vertices],
                    "radius": None if each.read.radius is None else float(each.read.radius),
                    "refused": each.refused,
                    "meant": [list(v) for v in each.meant.vertices] if each.meant else None,
                }
                for each in self.readings
            ],
            "questions": [{**q._asdict(), "answers": [a._asdict() for a in q.answers]} for q in self.questions],
            "findings": [{**f._asdict(), "about": list(f.about)} for f in self.findings],
            "pairs": [
                {
                    "a": pair.a.name,
                    "b": pair.b.name,
                    "relation": str(pair.trace.relation),
                    "sentence": pair.trace.sentence,
                    "valid": bool(pair.a.shape and pair.b.shape),
                    "others": [view._asdict() for view in self.others(number)],
                }
                for number, pair in enumerate(self.pairs)
            ],
        }

    def to_json(self) -> str:
        """Return the shapes, the relation of each pair, the questions and the findings as JSON."""
        return json.dumps({"satviz": "pasted 1", **self.data()}, ensure_ascii=False, indent=1)


def paste(what: Any, as_: str | Sequence[str] = ()) -> Pasted:
    """Return the shapes in a text, or in Python objects, with their relation and the diagnosis.

    `what`: WKT, GeoJSON, JSON, or lines in Python, JavaScript, C, C++, C#, Java, Rust, Scala or GDScript; nothing in it
    is evaluated.  Or shapes of satviz, shapely or pymunk, lists and arrays.
    `as_`: the readings to take where several are possible, such as "center-size" or "degrees, y-down";
    "leave-out" takes the shapes without what was not understood.
    InvalidScene where nothing can be read, or for more than a megabyte, 40 shapes or 1,000 corners.
    """
    written = what if isinstance(what, str) else as_text(what)
    chosen = _choices(as_)
    text, changes = cleaned(written)
    if DECIMAL.search(text) and not set(chosen) & set(CHOICES[Ask.COMMAS]):
        answers = tuple(Answer(c, CHOICE_WORDS[c], _sentence(written, (*chosen, c))) for c in CHOICES[Ask.COMMAS])
        return Pasted(
            written, chosen, (), (PasteQuestion(Ask.COMMAS, ASKS[Ask.COMMAS], answers, matters=True),), (), ()
        )
    if Form.DECIMAL_COMMAS in chosen:
        text = COMMA.sub(".", text)
    tree = parse(text)
    reader = Reader(text, chosen)
    if forms := set(chosen) & set(CHOICES[Ask.BOX_FORM]):
        bare = Reader(text, [choice for choice in chosen if choice not in forms])
        bare.read(tree.root)
        reader.keeps = Ask.BOX_FORM in bare.asked
    reads = _checked(reader.read(tree.root), reader, numbers_by_key(tree, text))
    shapes = _named(reads, written)
    questions = list(_questions(reader, tree.root, text, chosen))
    about_rest: list[PasteQuestion] = []
    missed, harmless = rest(tree, reads, text, reader, session=">>>" in written or "In [" in written)
    notes = []
    if missed := [*reader.problems[:5], *missed]:
        if Form.LEAVE_OUT in chosen:
            notes = [Finding("left-out", (), f"Left out, as chosen: {_shorten(missed)}.")]
        else:
            about_rest = [_about_the_rest(missed, tree.root, text, chosen, reader)]
    remarks = (*changes, *reader.remarks, *tree.remarks)
    notes += [Finding("note", (), f"{remark[0].upper()}{remark[1:]}.") for remark in remarks]
    if len(reader.thirds) > 1:
        warning = "The third coordinates differ and were left out: the answer is about x and y alone."
        help_line = "It says nothing about shapes in space: write their corners in the plane in which both lie."
        notes.insert(0, Finding("third-coordinate", (), warning, help_line))
    elif reader.thirds:
        notes.append(Finding("note", (), "A third coordinate was left out: the shapes are read in x and y."))
    if harmless:
        notes.append(Finding("left-out", (), f"Left out, since it belongs to no shape: {harmless}."))
    made = Pasted(written, chosen, tuple(shapes), (*about_rest, *questions), (), tuple(notes))
    if about_rest:
        rest_left = replace(made, chosen=(*chosen, Form.LEAVE_OUT), questions=tuple(questions))
        if rest_left.open or len(shapes) < 2:
            return made
        try:
            return replace(made, without=_answered(rest_left, decimals=isinstance(what, str), sure=False))
        except InvalidScene:  # too many corners for a trace
            return made
    return made if made.open else _answered(made, decimals=isinstance(what, str), sure=not missed)


def _answered(asked: Pasted, *, decimals: bool, sure: bool) -> Pasted:
    """Return the pairs and the diagnosis of shapes, with their notes; `sure`: nothing was missed."""
    pairs = _pairs(asked.readings)
    found = [finding for each in asked.readings for finding in findings.findings_of_shape(each)]
    for pair in pairs[:MAX_TRACES]:
        found += findings_of_pair(pair, decimals=decimals)
    found = findings.merged([*found, *asked.findings])
    if pairs and sure and not any(KINDS.index(finding.kind) < KINDS.index("clear") for finding in found):
        found.append(clear(pairs[0]))
    found.sort(key=lambda finding: KINDS.index(finding.kind))
    return replace(asked, pairs=tuple(pairs), findings=tuple(found))


def _choices(as_: str | Sequence[str]) -> tuple[str, ...]:
    """Return the readings that were chosen; InvalidScene for an unknown one."""
    words = as_.replace(",", " ").split() if isinstance(as_, str) else [str(word) for word in as_]
    for word in words:
        if word not in ALL_CHOICES:
            raise InvalidScene(f"no reading is called {word[:40]!r}: choose one of {', '.join(ALL_CHOICES)}")
    return tuple(words)


def _sentence(text: str, chosen: tuple[str, ...]) -> str:
    """Return the answer of a reading in one sentence, or why there is none."""
    try:
        return paste(text, chosen).sentence
    except InvalidScene as error:
        return str(error).partition(":")[0]


def _checked(reads: list[Read], reader: Reader, numbers: str) -> list[Read]:
    """Return the shapes that were read; InvalidScene for none, or for more than MAX_SHAPES or MAX_VERTICES.

    `numbers`: the numbers of the text in words, which are named where there is no shape.
    """
    if not reads:
        raise InvalidScene(
            reader.problems[0]
            if reader.problems
            else NOTHING.format(f", only the numbers {numbers}" if numbers else "")
        )
    if len(reads) > MAX_SHAPES:
        raise InvalidScene(f"{len(reads)} shapes: the limit is {MAX_SHAPES}, so paste those that matter")
    for read in reads:
        if len(read.points) > MAX_VERTICES:
            many = len(read.points)
            raise InvalidScene(f"a polygon of {many:,} corners: the limit is {MAX_VERTICES:,}, so simplify it")
    return reads


def _named(reads: Sequence[Read], text: str) -> list[PastedShape]:
    """Return the shapes with their names, each with the engine's shape or why it is refused."""
    found = []
    for number, read in enumerate(reads):
        name = chr(ord("A") + number) if number < 26 else f"S{number + 1}"
        excerpt = " ".join(text[read.start : read.end].split())
        excerpt = excerpt if len(excerpt) <= 120 else f"{excerpt[:117]}..."
        shape: Shape | None = None
        refused = ""
        try:
            shape = findings.make_shape(read)
        except InvalidShape as error:
            refused = str(error)
        meant = findings.meant_order(read) if refused and not read.is_circle else None
        found.append(PastedShape(name, _label(read, text)[:60], read.said, excerpt, read, shape, refused, meant))
    return found


def _label(read: Read, text: str) -> str:
    """Return what a text calls a shape: player rect for rect, Triangle 1 for Triangle; "" for a word that says nothing.

    Those are the words `rect` of player rect: (0, 0, 4, 4), and `Triangle` of Triangle 1: (0, 0), (4, 0), (0, 3).
    """
    general = read.label.lower() in GENERAL_WORDS
    if not (general or SHAPE_WORDS.fullmatch(read.label)):
        return read.label
    line = text[max(0, read.start - MAX_LABEL) : read.start].rpartition("\n")[2]
    found = re.search(rf"(?:\b{ARTICLES}([\w-]+)[ ])?\b{read.label}(?:[ ]#?(\w+))?[ ]*:[ ]*\Z", line)
    owner, number = (None if general else found[1], found[2]) if found else (None, None)
    return " ".join(filter(None, (owner, "" if general and not number else read.label, number)))


def _questions(reader: Reader, root: Group, text: str, chosen: tuple[str, ...]) -> Iterator[PasteQuestion]:
    """Yield the questions to the user: each possible reading with the relation that it gives."""
    keeps = reader.keeps or Ask.BOX_FORM in reader.asked
    for what, choices in reader.asked.items():
        if any(choice in chosen for choice in choices):
            continue
        answers = tuple(Answer(c, CHOICE_WORDS[c], _gives(root, text, (*chosen, c), keeps=keeps)) for c in choices)
        possible = {answer.gives for answer in answers if "refused" not in answer.gives}
        matters = len(possible) > 1 or (bool(possible) and answers[0].gives not in possible)
        if matters or what not in ONLY_IF_IT_MATTERS:
            yield PasteQuestion(what, ASKS[what], answers, matters)


def _shorten(parts: Sequence[str]) -> str:
    """Return the first of the parts that were not understood, and how many more there are, in one line."""
    more = f"; and {len(parts) - MAX_NAMED} more" if len(parts) > MAX_NAMED else ""
    return "; ".join(parts[:MAX_NAMED]) + more


def _about_the_rest(
    missed: Sequence[str], root: Group, text: str, chosen: tuple[str, ...], reader: Reader
) -> PasteQuestion:
    """Return the question whether the shapes are complete without the parts that were not understood."""
    keeps = reader.keeps or Ask.BOX_FORM in reader.asked
    choices = (Form.LEAVE_OUT, *([Form.TAKE_IN] if reader.doubts else []))
    said = {key(word) for part in missed for word in BEFORE_NUMBER.findall(part.partition(" (in ")[0])}
    lost = [name for name, meanings in DROPPED.items() if said & meanings]
    words = {Form.LEAVE_OUT: f"the shapes as read, without this {listed(lost)}"} if lost else {}
    answers = (Answer(c, words.get(c, CHOICE_WORDS[c]), _gives(root, text, (*chosen, c), keeps=keeps)) for c in choices)
    return PasteQuestion("rest", f"{ASKS['rest']} {_shorten(missed)}.", tuple(answers), matters=True)


def _gives(root: Group, text: str, chosen: tuple[str, ...], *, keeps: bool) -> str:
    """Return in words the relations of all pairs under a reading."""
    reader = Reader(text, chosen)
    reader.keeps = keeps
    shapes = _named(reader.read(root), text)
    if len(shapes) < 2:
        return shapes[0].refused.split(":")[0] or "one shape" if shapes else "no shape"
    if len(shapes) == 2:
        a, b = shapes
        if a.shape and b.shape:
            return str(relate(a.shape, b.shape))
        return "; ".join(f"{each.name} is refused ({each.refused.split(':')[0]})" for each in shapes if not each.shape)
    valid = [each for each in shapes if each.shape]
    related = ((p, q, relate(p.shape, q.shape)) for p, q in combinations(valid, 2) if p.shape and q.shape)
    meeting = [f"{p.name} and {q.name} {'touch' if r is Relation.TOUCHING else 'overlap'}" for p, q, r in related if r]
    return ", ".join(meeting[:8]) + (f" and {len(meeting) - 8} more" if len(meeting) > 8 else "") or "no pair meets"


def _pairs(shapes: Sequence[PastedShape]) -> list[AnsweredPair]:
    """Return the pairs that meet, the deepest first; if none meets, the nearest pair.

    At most MAX_TRACES pairs, with about MAX_PART_PAIRS pairs of convex parts together: if there are more, those whose
    boxes overlap most.
    """
    near = []
    for a, b in combinations(shapes, 2):
        p, q = a.usable, b.usable
        if p is not None and q is not None:
            size = len(convex_parts.parts(p)) * len(convex_parts.parts(q))
            near.append((relate(p, q) is Relation.APART, _distance_of_boxes(p, q), size, a, b))
    near.sort(key=lambda each: each[:2])
    met = sum(not apart for apart, *_ in near)
    made: list[AnsweredPair] = []
    left = MAX_PART_PAIRS
    for _, _, size, a, b in near[: min(met, 4 * MAX_TRACES) or 8]:
        left -= size
        if left >= 0 or not made:
            made.append(_pair(a, b))
    made.sort(key=lambda pair: pair.gap)
    return made[:MAX_TRACES] if met else made[:1]


def _pair(a: PastedShape, b: PastedShape) -> AnsweredPair:
    """Return a pair with its trace over every axis."""
    p, q = a.usable, b.usable
    assert p is not None and q is not None
    try:
        trace = record(p, q, every_axis=True)
    except InvalidScene:
        raise InvalidScene(
            f"{a.name} and {b.name} are {relate(p, q)}, but have too many corners to show every axis: simplify them"
        ) from None
    if (a.name, b.name) != ("A", "B"):
        parts = tuple(replace(t, names=ShapeNames(a.name + t.names.a[1:], b.name + t.names.b[1:])) for t in trace.pairs)
        trace = replace(trace, names=ShapeNames(a.name, b.name), pairs=parts)
    return AnsweredPair(a, b, trace, others.lie(p, q), _gap(trace))


def _gap(trace: Trace) -> float:
    """Return the largest gap of the axes, negative for an overlap; of concave outlines that of the nearest parts."""
    runs = trace.pairs or (trace,)
    return min(max(test.gap for test in run.tests) for run in runs)


def _distance_of_boxes(a: Shape, b: Shape) -> float:
    """Return the larger of the gaps of two bounding boxes in x and in y."""
    p, q = a.bounds, b.bounds
    return max(p[0] - q[2], q[0] - p[2], p[1] - q[3], q[1] - p[3])


def _pair_count(shapes: int) -> int:
    """Return the number of pairs."""
    return shapes * (shapes - 1) // 2
