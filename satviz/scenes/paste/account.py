"""The account of a text: every token stands in a shape, or is known to be harmless, or is named as not understood.

It looks at the tokens alone, beside the reader and after it, so what the reader passed over is seen here.  A token is
accounted for if a shape has it, if a row of `notations` explains it, or if a list of `harmless` words has it; a word
outside the brackets of a shape is prose.
"""

import re
from bisect import bisect_left, bisect_right
from collections.abc import Collection, Iterator, Mapping, Sequence
from itertools import accumulate, groupby, pairwise
from operator import itemgetter
from types import MappingProxyType
from typing import Any, NamedTuple

from .harmless import (
    ADJECTIVES,
    ANY_CHANGE,
    CALLS,
    CASTS,
    CHANGING_CALLS,
    CHANGING_KEYS,
    CHANGING_WORDS,
    COMPARING,
    COUNTED,
    DECLARES,
    DRAWS,
    FLOW,
    INSIDE,
    KEYS,
    LABELS,
    METHODS,
    OTHER_NUMBERS,
    PRODUCERS,
    PUNCTUATION,
    SAYS,
    TESTS,
    words,
)
from .notations import MOVES, RESETS, SETTERS, SHAPE_STEMS, SHAPE_WORDS, SHIFTS, TURNS, TWO_SHAPES, key, notation
from .statements import ADDERS, ATTACHERS, PEN_STARTS, PENS, owner_of
from .tokens import CLOSE, FIELD, LINE, MARK, NAME, NUMBER, OPEN, OTHER, TEXT, Token, tokens
from .tree import parts_of

MAX_PARTS = 50  # parts that are not understood and are collected; fewer are named
MAX_ARGUMENTS = 200  # words and signs in a call in which the names of shapes are looked for
MAX_ASIDE = 2  # numbers of a line of other things; three can be a shape
# matches the first letters of the kinds of tokens: a name or a text, a mark, a number
_FIELD_LINE = re.compile("[nt]mnm?")
APPLIED = frozenset([*METHODS, *MOVES, *SHIFTS, *TURNS, *ADDERS, *ATTACHERS, *PENS, *PEN_STARTS, *SETTERS, *RESETS])
MOVERS = frozenset([*MOVES, *SHIFTS, *TURNS, "scale", "transform", "settransform"]) - {"offset", "translation"}
ASSIGNS = ("=", ":=", ":")
STYLE = re.compile(r"[a-z]?[-.:ox]{1,2}[a-z]?")  # the format of a line in a plot, such as b-
NO_WORDS = re.compile(r"[A-Za-z_][\w.]*")
LOOP = re.compile(r"^\s*for\s*\([^;]*;[^;]*;[^;)]*\)")
DEFINES = frozenset({"def", "function", "fn", "func", "fun", "void", "class", "struct"})  # words before a new name
SETS = re.compile(r"(?<![<>=!])=(?!=)|\+\+|--|<<|>>|\?")
NAMED_SHAPE = re.compile(r"\b(?:A|B|C|both|second)\b")
STREAM = re.compile(r"cout|cerr|debug|stream|log|\bout", re.IGNORECASE)
DATA = re.compile(r"[(\[{]|^\s*[Mm]\s*[-.\d]|^\s*(?:[-.\d]+[\s,]+){3,}[-.\d]+\s*$")
COLOR = re.compile(r"\b(?:rgb|hsl)a?\(", re.IGNORECASE)
NUMERALS = re.compile(r"[0-9]+")
PADDED = re.compile(r"0[0-9]+")  # 000, of 1,000
NOTHING = Token(LINE, "", 0, 0)


class Part(NamedTuple):
    """A part of the text that is not understood: where it begins and ends."""

    start: int
    end: int


class BracketFrame(NamedTuple):
    """The state of an open bracket: where it begins, and whether it holds data of a shape, statements, a shape to draw
    or to test, or an index."""

    begin: int
    data: bool
    block: bool
    drawn: bool = False
    counts: bool = False


class Account:
    """Goes through the tokens of a text and collects the `parts` that are not understood.

    A token `i`, also the place of a token, is an index into `tokens`.  `start` and `end` are offsets in the text.
    """

    def __init__(
        self,
        text: str,
        found: Sequence[Token],
        shapes: Sequence[Collection[int]],
        variables: Mapping[str, int],
        known: Sequence[tuple[int, int]] = (),
        changed: Collection[str] = (),
        aliases: Mapping[str, str] = MappingProxyType({}),
        counts: Collection[int] = (),
        *,
        session: bool = False,
    ) -> None:
        """`shapes`: where the numbers of each shape end; `variables`: names of data, with their sizes; `known`: parts
        of a known form; `changed`: names with a value of which a field is set afterwards; `aliases`: names of other
        things; `counts`: where numbers end that say how a shape is read, such as how many columns a matrix has;
        `session`: it is one of Python, which prints results.
        """
        self.text = text
        removed = within(known, found)
        self.shapes = shapes
        self.places = sorted(frozenset(counts).union(*shapes))
        rows = [Token(NUMBER, "", start, end) for start, end in known if self.holds(start, end)]
        kept = [token for token in found if token not in removed]
        self.tokens = sorted([*kept, *rows], key=lambda token: token.start) if rows else kept
        self.variables = variables
        self.changed = changed
        self.aliases = aliases
        self.parts: list[Part] = []
        self.counts: set[int] = set()  # the ends of numbers that count or name something
        self.aside: set[int] = set()  # the ends of numbers on lines of other things
        self.nested = False  # within a text in quotes, whose numbers nobody else counts
        self.quoted = False  # whether a quote has opened a text of several lines
        self.session = session
        self.close: dict[int, int] = {}
        self.open: dict[int, int] = {}
        self._match()
        self._lines_aside = self._find_lines_aside()
        self._amid = self._find_amid()

    def _find_lines_aside(self) -> set[int]:
        """Return the places of the tokens of lines that have a word, no shape, and nothing that could change one."""
        ends = [-1, *(i for i, token in enumerate(self.tokens) if token.kind == LINE), len(self.tokens)]
        lines = [range(a + 1, b) for a, b in pairwise(ends)]
        shaped = [any(map(self._is_of_shape, line)) for line in lines]
        fields = [_FIELD_LINE.fullmatch("".join(self.tokens[i].kind[0] for i in line)) is not None for line in lines]
        for is_field, group in groupby(range(len(lines)), key=fields.__getitem__):
            rows = list(group)
            if is_field and any(shaped[row] for row in rows):  # x = 1 and radius = 2 on lines of their own
                for row in rows:
                    shaped[row] = True
        found = (
            line if self._says(line) else () if is_shaped else self._aside(line)
            for line, is_shaped in zip(lines, shaped, strict=True)
        )
        return {i for line in found for i in line}

    def _find_amid(self) -> set[int]:
        """Return the places of the tokens between two numbers of one shape in one statement, inside brackets or not."""
        ends = [token.end for token in self.tokens]
        found: set[int] = set()
        for places in self.shapes:
            for here, there in pairwise(sorted(places)):
                inner = range(bisect_right(ends, here), bisect_left(ends, there))
                if not any(self.tokens[k].kind == LINE or self.tokens[k].text == ";" for k in inner):
                    found.update(inner)
        return found

    def _is_of_shape(self, i: int) -> bool:
        """Return whether token `i` belongs to a shape: a number of it, or a name that stands for it."""
        token = self.tokens[i]
        return self.holds(token.start, token.end) if token.kind in (NUMBER, TEXT) else self.is_variable(token)

    def _aside(self, line: range) -> range:
        """Return the token numbers of a line that says nothing about a shape; an empty range if it may."""
        named = [self.tokens[i] for i in line if self.tokens[i].kind in (NAME, FIELD, TEXT)]
        numbers = sum(self.tokens[i].kind == NUMBER and self._is_listed(i) for i in line)
        changes = any(
            words(token.text) & ANY_CHANGE
            or (token.text != "by" and owner_of(last_of(token.text))[1] not in ("", "points"))
            for token in named
        )
        makes = numbers and any(SHAPE_WORDS.search(token.text) and not is_test(token.text) for token in named)
        adds = numbers > 1 and any(last_of(token.text).lower() in ADDERS | PENS for token in named)
        lists = any(self.tokens[i].kind == OPEN and self.tokens[i + 1].kind == NUMBER for i in self._top(line))
        places = numbers > 1 and any("body" in words(token.text) for token in named)  # newBody(world, 100, 100)
        return range(0) if not named or changes or places or makes or adds or lists or numbers > MAX_ASIDE else line

    def _is_listed(self, i: int) -> bool:
        """Return whether a number stands in a list or a call, and not among words."""
        among = (NAME, LINE, TEXT, OTHER)
        if self.at(i - 1).kind == NAME and self.at(i + 1).text in (",", ":") and self.at(i + 2).kind in (NAME, LINE):
            return False  # it should return 1, really
        return any(each.kind not in among or each.text == "|" for each in (self.at(i - 1), self.at(i + 1)))

    def _says(self, line: range) -> bool:
        """Return whether a line of code compares or prints, and gives nothing a value: return a.x < b.x + b.w."""
        first = words(self.tokens[line.start].text) if line else frozenset()
        if not first & (SAYS | COMPARING):
            return False
        start, end = self.line(self.tokens[line.start])
        sets = first & COMPARING and SETS.search(LOOP.sub("", self.text[start:end]))
        named = (self.tokens[i] for i in line if self.tokens[i].kind in (NAME, FIELD))
        changes = any(
            words(token.text) & CHANGING_CALLS - {"abs", "round"} and not is_test(token.text) for token in named
        )
        return not (changes or self.holds(start, end) or sets)

    def _top(self, line: range) -> Iterator[int]:
        """Yield the places of the opening brackets of a line that stand in no other bracket and are not of a call."""
        i = line.start
        while i < line.stop - 1:
            if self.tokens[i].kind == OPEN and not self.callee(i):
                yield i
            i = self.close.get(i, i) + 1

    def holds(self, start: int, end: int) -> bool:
        """Return whether a number of a shape ends within these offsets, in (start, end]."""
        at = bisect_left(self.places, start + 1)
        return at < len(self.places) and self.places[at] <= end

    def _match(self) -> None:
        """Fill `close` and `open` with the place of the other bracket of each pair, and list those never closed."""
        stack: list[int] = []
        for i, token in enumerate(self.tokens):
            if token.kind == OPEN:
                stack.append(i)
            elif token.kind == CLOSE and stack:
                self.close[stack[-1]] = i
                self.open[i] = stack.pop()
        for i in stack:
            self.close[i] = len(self.tokens)
        self.unclosed = stack

    def at(self, i: int) -> Token:
        """Return a token, or a line's end beyond the text."""
        return self.tokens[i] if 0 <= i < len(self.tokens) else NOTHING

    def before(self, i: int) -> int:
        """Return the place of the last token before place i that is not a line's end; -1 if there is none."""
        return next((k for k in range(i - 1, -1, -1) if self.tokens[k].kind != LINE), -1)

    def span(self, i: int) -> tuple[int, int]:
        """Return (start, end), as offsets, of the bracket that token i opens or closes."""
        begin, end = (i, self.close.get(i, i)) if self.at(i).kind == OPEN else (self.open.get(i, i), i)
        return self.at(begin).start, self.at(end).end or len(self.text)

    def is_data(self, i: int) -> bool:
        """Return whether a token is a number, a bracket with numbers of a shape, or the name of data."""
        token = self.at(i)
        if token.kind in (OPEN, CLOSE):
            begin = i if token.kind == OPEN else self.open.get(i, i)
            word, end = self.callee(begin), self.close.get(begin, i)
            if token.kind == CLOSE and word and word.kind == FIELD and self.is_data(self.before(begin - 1)):
                return True  # a shape.clone()
            if token.kind == CLOSE and word and self.is_variable(word) and token.text == "]":
                return True  # vertices[1]
            named = any(self.is_variable(t) for t in self.tokens[begin : min(end, begin + 8)])
            return named or self.holds(*self.span(i))
        if token.kind == TEXT:
            return self.holds(token.start, token.end)
        if token.kind == NAME and self.at(i + 1).kind == OPEN and self.callee(i + 1) is token and i + 1 in self.close:
            return self.is_data(i + 1)
        return token.kind == NUMBER or self.is_variable(token)

    def is_variable(self, token: Token) -> bool:
        """Return whether a name is that of data."""
        return token.kind == NAME and root(token.text) in self.variables

    def callee(self, i: int) -> Token | None:
        """Return the word before the bracket at token i that makes it a call or a typed list; None for no such word."""
        before, token = self.at(i - 1), self.at(i)
        touches = before.end == token.start or token.text == "{"
        return before if touches and before.kind in (NAME, FIELD) else None

    def frame(self, i: int) -> BracketFrame:
        """Return the frame of the bracket at token i: whether it holds data, statements, a drawing or an index."""
        word = self.callee(i)
        end = self.close[i]
        inner = self.at(i + 1), self.at(i + 2), self.at(i + 3)
        block = self.at(i).text == "{" and (
            self.at(i - 1).text in (")", "=>", "->")
            or (word is not None and word.text in ("else", "do", "try", "main", "loop", "finally", "unsafe"))
            or any(self.at(k).text == ";" for k in range(i, min(end, i + 60)))
            or (inner[0].kind == LINE and not any(self.at(k).text in (",", ":") for k in range(i, min(end, i + 12))))
        )
        call = word is not None and self.at(i).text == "(" and not (is_shape(word.text) or word.text[0] in ".-:")
        data = self.holds(*self.span(i))
        draws = word is not None and not data and bool(words(word.text) & DRAWS) and (call or word.text in DRAWS)
        draws = draws or (word is not None and is_test(word.text))
        index = self.at(i).text == "[" and word is not None and self.is_variable(word) and ":" not in self.between(i)
        return BracketFrame(
            i,
            data and not block and not call and not index,
            block,
            draws and not data and any(map(self.is_variable, self.arguments(i))),
            index,
        )

    def frame_of(self, i: int, frame: BracketFrame) -> BracketFrame:
        """Return the frame around token i, which holds data between two numbers of one shape."""
        return frame._replace(data=True) if i in self._amid else frame

    def between(self, i: int) -> str:
        """Return the text in the bracket that opens at token i."""
        return self.text[self.at(i).end : self.span(i)[1]]

    def run(self) -> list[Part]:
        """Return the parts of the text that are not understood."""
        frames = [BracketFrame(-1, False, True)]
        begins_in_block = True
        for i, token in enumerate(self.tokens):
            if len(self.parts) >= MAX_PARTS:
                break
            if token.kind == LINE:
                begins_in_block = frames[-1].block
            aside = begins_in_block and i in self._lines_aside
            result = self.at(i - 1).text == "=" and self.at(i - 2).kind == CLOSE and self.is_tested(i - 2)
            aside = (aside or frames[-1].counts or result) and token.kind in (NUMBER, OTHER)
            if (aside or (frames[-1].drawn and token.kind == NUMBER)) and not self.holds(token.start, token.end):
                self.aside.add(token.end)
            elif token.kind == OPEN:
                self.check_call(i)
                if self.is_color(i, frames[-1]):
                    self.counts |= {each.end for each in self.tokens[i : self.close[i]]}
                frame = self.frame(i)
                frames.append(frame._replace(counts=frame.counts or frames[-1].counts))
            elif token.kind == CLOSE and len(frames) > 1 and self.open.get(i) == frames[-1].begin:
                frames.pop()
            elif token.kind == NAME:
                self.check_name(i, self.frame_of(i, frames[-1]))
            elif token.kind == FIELD:
                self.check_field(i, frames[-1])
            elif token.kind == TEXT:
                self.check_text(i, frames[-1])
            elif token.kind == OTHER:
                self.check_sign(i, self.frame_of(i, frames[-1]))
            elif token.kind == NUMBER and self.is_count(i, frames[-1]):
                self.counts.add(token.end)
            elif token.kind == NUMBER and self.nested and not self.holds(token.start, token.end):
                self.miss(i, i)
            elif token.kind == NUMBER and PADDED.fullmatch(token.text):
                self.miss(i - 2 if self.at(i - 1).text == "," else i, i)  # 1,000
            elif token.kind == MARK and token.text in ("==", "!=", "<=", ">=") and frames[-1].data:
                self.miss(i - 1, i + 1)
        return self.parts

    def is_cut(self) -> bool:
        """Return whether a bracket with numbers of a shape is never closed, so that some can be missing."""
        return any(self.frame(i).data for i in self.unclosed)

    def is_count(self, i: int, frame: BracketFrame) -> bool:
        """Return whether a number counts or names something: a label before a colon, a length, 4 corners, { 0 }."""
        before, after = self.at(i - 1), self.at(i + 1)
        shifts = before.text in ("<", ">") and self.at(i - 2).text == before.text
        if before.text in ("<", ">", "<=", ">=", "==", "!=") and not shifts and not frame.data:
            return True
        if self.session and before.kind == after.kind == LINE and not self.holds(self.at(i).start, self.at(i).end):
            return True
        if not self.at(i).text.isdigit():
            return False
        if before.kind == LINE:
            return after.text in (":", "|")
        if before.text == "#" and before.end == self.at(i).start and self.at(i - 2).kind not in (NUMBER, CLOSE):
            return True  # body#17
        if before.text == ";" and after.text == "]" and not frame.data:
            return True  # of a type of Rust: [(f64, f64); 3]
        if before.text == "{" and after.text == "}":
            return self.at(i).value == 0
        if before.text in ",(" and after.text in ",)" and "," in (before.text, after.text):
            beside = (self.at(i - 2), self.at(i + 2))  # cpPolyShapeNew(body, 4, verts, cpvzero), polygon.Set(points, 4)
            if any(self.variables.get(each.text) == self.at(i).value for each in beside):
                return True
            data = beside[0]  # ST_GeomFromText('POLYGON(...)', 4326)
            return after.text == ")" and data.kind == TEXT and self.holds(data.start, data.end)
        if before.text == "(" and after.text == ")" and self.at(i + 2).text == "[":
            return True
        if after.text.lower() in COUNTED:
            touches = self.at(i + 2).kind == OPEN and self.at(i + 2).start == after.end
            return not (touches and self.holds(*self.span(i + 2)))
        return before.text.lower() in LABELS and (
            after.kind == LINE or after.text in (":", ",", "at", "is", "of", "has", "with", "")
        )

    def is_color(self, i: int, frame: BracketFrame) -> bool:
        """Return whether a bracket in a call that draws holds a color: draw.circle(screen, (255, 0, 0), (4, 4), 9)."""
        word = self.callee(frame.begin)
        if word is None or "draw" not in words(word.text) or self.callee(i) or self.holds(*self.span(i)):
            return False
        parts = [token for token in self.tokens[i + 1 : self.close[i]] if token.text != ","]
        return len(parts) in (3, 4) and all(t.kind == NUMBER and t.text.isdigit() and int(t.text) < 256 for t in parts)

    def miss(self, first: int, last: int) -> None:
        """Add the tokens `first` to `last`, both included, to the parts that are not understood."""
        begin, end = self.at(first), self.at(last)
        start = begin.start if begin is not NOTHING else self.at(first + 1).start
        end_at = self.span(last)[1] if end.kind == OPEN else end.end if end is not NOTHING else self.at(last - 1).end
        if not self.parts or self.parts[-1].end < end_at:
            self.parts.append(Part(start, end_at))

    def arguments(self, i: int) -> Iterator[Token]:
        """Yield the tokens in the bracket that opens at token i, without the arguments of collision tests."""
        end, k = min(self.close[i], i + MAX_ARGUMENTS), i + 1
        while k < end:
            tests = self.at(k).text == "(" and (word := self.callee(k)) and is_test(word.text)
            k = self.close[k] if tests else k
            yield self.at(k)
            k += 1

    def check_call(self, i: int) -> None:
        """Note the call, slice or transform at bracket i if it may change a shape and is not understood."""
        word, opens = self.callee(i), self.at(i).text
        touches = opens == "[" and self.at(i - 1).kind == CLOSE and self.at(i - 1).end == self.at(i).start
        cuts = self.at(i + 1).text != "None" and any(t.text == ":" for t in self.tokens[i : self.close[i]][:4])
        if touches and cuts and self.is_data(i - 1):
            self.miss(i, i)  # [::-1]
        left_of = self.at(i - 2).text
        taken = left_of in ASSIGNS or (left_of == "(" and notation(self.at(i - 3).text) is not None)
        if opens == "[" and self.is_variable(self.at(i - 1)) and (left_of == "del" or (cuts and taken)):
            self.miss(i - 1, i)  # del p[0], q = p[:3], Polygon(p[:3])
        begin = self.open.get(i - 1)
        if opens == "(" and begin == i - 2 and self.callee(begin) and self.holds(*self.span(i)):
            self.miss(begin - 1, i)  # Box.flip()(0, 0, 4, 4)
        if word is None or word.kind == FIELD:
            return
        if opens != "(":
            if word.text.lower() in CHANGING_CALLS and self.holds(*self.span(i)):
                self.miss(i - 1, i)  # flip[(0, 0), (4, 0)]
            return
        inside = self.holds(*self.span(i)) or any(map(self.is_variable, self.arguments(i)))
        last = last_of(word.text)
        makes_new = self.at(i - 2).text == "new" and not words(last) & CHANGING_CALLS
        defines = makes_new or self.at(i - 2).text in DEFINES
        if not inside and last.lower() in MOVERS and self.close[i] > i + 1 and not defines and self.places:
            self.miss(i - 1, i)  # ctx.translate(cx, cy)
            return
        if not inside and not (self.is_variable(word) and last != word.text):
            return
        method = self.is_variable(word) and last != word.text and last.lower() in APPLIED
        declared = notation(self.at(i - 2).text) is not None and last.lower() not in CHANGING_CALLS  # Circle c(0, 0, 1)
        makes = last.lower() in PRODUCERS and "." in word.text and not defines and self.is_given(i)
        declared = declared or (self.at(i - 2).text == "," and self.is_variable(word))  # Rect a(0, 0, 4, 4), b(...)
        known = method or defines or declared or last.lower() in PENS | PEN_STARTS | PRODUCERS or is_call(word.text)
        if makes or not known:
            self.miss(i - 1, i)

    def check_name(self, i: int, frame: BracketFrame) -> None:
        """Name a word among the numbers of a shape that is on no list."""
        token, after = self.at(i), self.at(i + 1)
        if after.kind == OPEN and self.callee(i + 1) is token:
            return  # the name belongs to a call, which is checked by itself
        last = last_of(token.text)
        if self.joins_tail(i):
            self.miss(i, i + 1)
            return
        if token.text.startswith("is") and after.text in ASSIGNS and self.at(i + 2).text in ("true", "false"):
            return  # isBox2: true
        changes = token.text.lower() in {*CHANGING_CALLS, "not"} and (after.kind == OPEN or not after.text)
        if changes and (self.is_data(i + 1) or self.at(i + 2).kind == NUMBER):
            self.miss(i, i)  # POLYGON mirror ((0 0, 4 0, 0 3))
            return
        if self.is_variable(token):
            again = "." in token.text and after.text == "=" and root(token.text) in self.changed
            value = self.at(i + 2)
            if again and value.kind == NAME and value.text != "new" and self.at(i + 3).kind != OPEN:
                self.miss(i, i + 2)  # a.x = b.x, where a has a value already
                return
            known = (key(last) and last != "T") or last.lower() in KEYS or is_call(last)
            if last != root(token.text) and not known and after.text not in ASSIGNS:
                self.miss(i, i)  # pts.T
            elif after.text in ASSIGNS and self.is_field(token.text, last) and not self.takes_value(i + 1):
                self.miss(i, i + 2)  # a.flip = true
            return
        if token.text in FLOW and self.holds(token.end, self.statement_end(i)):
            self.miss(i, i)
        elif token.text in ("if", "else", "elif") and (self.gives_value(i) or self.is_choice(i)):
            self.miss(i, i + 1)
        if not frame.data:
            start, end = self.line(token)
            told = self.holds(start, end) or NAMED_SHAPE.search(self.text, start, end)
            if token.text.lower() in CHANGING_WORDS and told:
                self.miss(i, i)  # A: rect(0, 0, 4, 4), twice as large
            if after.text in ASSIGNS and words(token.text) & CHANGING_KEYS and not self.takes_value(i + 1):
                self.miss(i, i + 2)
            return
        if after.text in (*ASSIGNS, "=>"):
            if self.is_changing(last, i) or not (key(last) or self.is_key(last) or self.takes_value(i + 1)):
                self.miss(i, i + 2)
        elif self.at(i - 1).text in DECLARES:
            return  # (def a [[0 0] [4 0] [4 3]])
        elif after.kind == OPEN and words(token.text) & OTHER_NUMBERS and not self.is_data(i + 1):
            return  # velocity (5, 0)
        elif not (self.is_inside(token.text) or is_shape(token.text) or self.is_value(i)):
            self.miss(i, i)

    def joins_tail(self, i: int) -> bool:
        """Return whether a word touches the data before it, or joins it with one word at the end of a statement."""
        token, before = self.at(i), self.at(i - 1)
        if token.text == "or" and self.at(i - 2).text in ASSIGNS and self.is_written(i + 1):
            return True  # a = size or Rect(0, 0, 4, 4)
        if before.kind not in (CLOSE, NUMBER) or not self.is_written(i - 1):
            return False
        if token.text not in ("and", "or", "if", "unless", "when"):
            return before.end == token.start
        end = next(k for k in range(i, len(self.tokens) + 1) if self.at(k).kind == LINE or self.at(k).text == ";")
        ends = end == i + 2 or self.at(end).text == ";" or self.at(i + 2).kind == CLOSE or self.at(i + 2).text == ","
        return ends and not self.holds(token.start, self.at(end - 1).end)

    def is_inside(self, name: str) -> bool:
        """Return whether a name among numbers is that of a color, a body, a type; also by what it stands for."""
        last = last_of(name)
        return bool(last.lower() in INSIDE or words(last) & INSIDE or words(self.aliases.get(name, "")) & INSIDE)

    def line(self, token: Token) -> tuple[int, int]:
        """Return (start, end), as offsets, of the line of a token."""
        end = self.text.find("\n", token.end)
        return self.text.rfind("\n", 0, token.start) + 1, end if end >= 0 else len(self.text)

    def is_field(self, name: str, last: str) -> bool:
        """Return whether a name is that of a field that is on no list."""
        return last != name and not key(last) and not self.is_key(last)

    def is_changing(self, name: str, i: int) -> bool:
        """Return whether a key gets a word that changes the shape: origin: "center"; dtype=int beside decimals."""
        value = self.at(i + 2)
        said = value.text.strip("\"'").lower().rsplit(".", 1)[-1]
        if value.kind not in (NAME, TEXT) or self.at(i + 3).kind == OPEN or self.is_data(i + 2):
            return False
        if name == "dtype":
            start, end = self.line(self.at(i))
            return "int" in said and "." in NO_WORDS.sub("", self.text[start:end])
        handled = name.lower() in ("originx", "originy")
        return (
            not handled
            and bool(words(name) & CHANGING_KEYS)
            and said not in ("false", "null", "none", "nil", "0", "identity")
        )

    def is_key(self, name: str) -> bool:
        """Return whether a key is known to change nothing."""
        return name.lower() in KEYS or bool(words(name) & KEYS and not words(name) & CHANGING_CALLS)

    def is_value(self, i: int) -> bool:
        """Return whether a word is the value of a known key: type: Polygon."""
        before = self.at(i - 2)
        if self.at(i + 1).kind in (OPEN, NUMBER) and self.is_data(i + 1):
            return False  # mins: not [0, 0]
        known = before.text.strip("\"'")
        known_key = key(known) or words(known) & KEYS
        return (
            self.at(i - 1).text in (*ASSIGNS, "=>") and bool(known_key) and not words(self.at(i).text) & CHANGING_CALLS
        )

    def is_given(self, i: int) -> bool:
        """Return whether a name gets the value of a statement: c = a.union(b)."""
        i -= 1
        while self.at(i).kind != LINE and self.at(i).text not in (";", "=", ":="):
            i = self.open.get(i, i) - 1
        return self.at(i).text in ("=", ":=")

    def takes_value(self, i: int) -> bool:
        """Return whether data of a shape, a bracket or the end of the line follows token `i`, a sign."""
        while self.at(i + 1).kind == NAME and self.at(i + 2).kind in (OPEN, NAME):
            i += 1
        return self.is_data(i + 1) or self.at(i + 1).kind in (OPEN, LINE)

    def is_choice(self, i: int) -> bool:
        """Return whether data stands before a word in its line, and `else` after it: a if b else c."""
        start, end = self.line(self.at(i))
        before = self.holds(start, self.at(i).start) or (self.at(i - 1).kind != NUMBER and self.is_data(i - 1))
        return before and "else" in self.text[self.at(i).end : end]

    def gives_value(self, i: int) -> bool:
        """Return whether a condition stands before a line that gives a name a value: if big: a = Circle(0, 0, 50)."""
        i = self.close[i + 1] + 1 if i + 1 in self.close else i + 1
        while i < len(self.tokens) and self.tokens[i].kind != LINE and self.tokens[i].text not in (":", "{", "="):
            i += 1
        while i < len(self.tokens) and (self.tokens[i].kind == LINE or self.tokens[i].text in (":", "{")):
            i += 1
        assigns = any(self.at(k).text in ("=", ":=") for k in range(i, i + 6))
        return assigns and self.holds(self.at(i).start, self.statement_end(i))

    def statement_end(self, i: int) -> int:
        """Return the offset at which the statement around token i ends."""
        while i + 1 < len(self.tokens) and self.at(i + 1).text != ";" and self.at(i + 1).kind != LINE:
            i += 1
        return self.at(i).end

    def check_field(self, i: int, frame: BracketFrame) -> None:
        """Name an unknown field or chained method of a shape."""
        before, after = self.at(i - 1), self.at(i + 1)
        name = self.at(i).text.lstrip(".->:")
        if (after.text in ASSIGNS and before.kind != CLOSE) or (before.kind == LINE and after.text == "{"):
            return  # {.x = 1}, or a rule of CSS
        k = self.before(i)
        follows = self.at(k).kind in (NUMBER, TEXT) or (self.at(k).kind == CLOSE and (frame.data or self.is_data(k)))
        if not follows:
            return
        if after.kind == OPEN and self.callee(i + 1):
            rows = name.lower() != "reshape" or self.at(self.close[i + 1] - 1).text in ("2", ",")
            inside = self.tokens[i + 2 : self.close[i + 1]]
            given = self.holds(*self.span(i + 1)) or any(map(self.is_variable, inside[:20]))
            applied = given if name.lower() in MOVERS else name.lower() in APPLIED
            known = rows and (words(name) & OTHER_NUMBERS or applied or (name.lower() not in MOVERS and is_call(name)))
            if self.is_given(i) if name.lower() in PRODUCERS else not known:
                self.miss(i, i + 1)
        elif not (name.lower() in KEYS - {"x", "y"} or is_call(name) or (after.text in ASSIGNS and key(name))):
            self.miss(i, i)

    def check_text(self, i: int, frame: BracketFrame) -> None:
        """Check the tokens of a quoted text with numbers of a shape; record any other text as missed if unknown."""
        token = self.at(i)
        inner = token.text[1:-1]
        if self.holds(token.start, token.end):
            if any(c in inner for c in "([{ ,"):
                begin = token.start + 1
                plain = inner.replace('\\"', ' "')
                found = [t._replace(start=t.start + begin, end=t.end + begin) for t in tokens(plain)]
                within_text = Account(self.text, found, self.shapes, self.variables)
                within_text.nested = True
                self.parts += within_text.run()
            return
        word = self.callee(frame.begin) if frame.begin >= 0 else None
        told = DATA.search(inner) and not COLOR.search(inner)
        if len(NUMERALS.findall(inner)) > MAX_ASIDE and (told or (word is not None and is_shape(word.text))):
            self.miss(i, i)  # the data of a path that cannot be read
        if not frame.data or not inner.strip():
            return
        if self.at(i + 1).text in (*ASSIGNS, "=>"):
            if self.is_changing(inner, i) or not (key(inner) or self.is_key(inner) or self.takes_value(i + 1)):
                self.miss(i, i + 2)
        elif not (words(inner) & INSIDE or self.is_value(i) or inner[0] == "#" or STYLE.fullmatch(inner)):
            self.miss(i, i)

    def check_sign(self, i: int, frame: BracketFrame) -> None:
        """Name a sign among the numbers of a shape, or beside one."""
        token, before = self.at(i), self.at(i - 1)
        if token.text == "'" and self.transposes(i):
            self.miss(i - 1, i)  # [0 4 4; 0 0 3]' of MATLAB
            return
        after = self.at(i + 1)
        if token.text == "+" and after.kind == NUMBER and after.value == self.variables.get(before.text, -1) > 2:
            self.counts.add(after.end)  # a range of C++: Polygon p(points, points + 4)
            return
        escapes = token.text[0] == "\\" and token.text != "\\ "
        loose = before.end < token.start and token.end < after.start
        if loose and ((token.text == "." and self.is_data(i - 1)) or (token.text == "$" and self.is_data(i + 1))):
            # operators of Haskell: circle (0, 0) 1 . flip, and flip . id $ [(0, 0), (4, 0), (0, 3)]
            self.miss(i, i + 1)
            return
        known = token.text in PUNCTUATION or escapes or self.is_of_code(i, frame)
        if known or (not frame.data and self.is_of_text(i)):
            return
        joins = self.is_written(i - 1) or self.is_written(i + 1) or self.is_operator(i)
        if token.text in "<>!|&" and not frame.data and not joins:
            return  # a comparison, or a logical sign
        if frame.data or self.is_data(i - 1) or self.is_data(i + 1) or self.is_written(i + 1):
            self.miss(i - 1 if before.kind == NAME or (before.kind == NUMBER and before.text) else i, i + 1)

    def is_written(self, i: int) -> bool:
        """Return whether token i is a number of a shape, or begins a bracket or call with one that is not a test."""
        while self.at(i).text == "new" or (self.at(i).kind == NAME and self.callee(i + 1) is self.at(i)):
            i += 1
        kind, bracket = self.at(i).kind, self.at(i).kind in (OPEN, CLOSE)
        return (kind == NUMBER or bracket) and self.holds(*self.span(i)) and not (bracket and self.is_tested(i))

    def transposes(self, i: int) -> bool:
        """Return whether a quote transposes data, as in MATLAB; update `quoted` if it opens or closes a text."""
        token, before, after = self.at(i), self.at(i - 1), self.at(i + 1)
        follows = before.end == token.start and before.kind in (CLOSE, NAME, NUMBER, FIELD)
        opens, self.quoted = self.quoted, not follows
        if opens or not follows or (after.kind == NAME and token.end == after.start):
            return False
        row = before.kind == NUMBER and self.holds(before.start, before.end)
        return self.is_variable(before) or row or (before.kind == CLOSE and self.is_data(i - 1))

    def is_of_code(self, i: int, frame: BracketFrame) -> bool:
        """Return whether a sign is a reference, a bullet, or a mark of a language that changes no value."""
        token, before, after = self.at(i), self.at(i - 1), self.at(i + 1)
        tight = token.end == after.start
        first = before.kind == LINE or before.text in (",", "(", "[", "{", "=", ":", ";")
        if token.text in "&*@" and tight:  # &a, *points, @g
            named = after.kind == NAME and (first or (before.kind == NAME and not self.is_variable(before)))
            return named or (first and after.kind == OPEN)
        if token.text == "-" and first and after.kind == NUMBER and self.at(i + 2).text in (",", ")", "]", "}", ";"):
            return True  # - 4
        if before.kind == LINE and token.text in "-*+>|\u2022" and not frame.data:  # a bullet, or a quoted line
            return not self.is_variable(after) or self.at(i + 2).text in (":", "=")
        if token.text == "!" and self.at(i + 2).text == "(" and is_test(after.text):
            return True  # if (!overlaps(a, b))
        if token.text == "?":  # f(x)?; of Rust
            return after.text in (";", ")", ",")
        if token.text == "<" and tight and notation(after.text):
            return True  # <POLYGON ((0 0, 4 0, 0 3))>
        closes = token.text == ">" and before.end == token.start and (before.kind == CLOSE or before.text == ">")
        # %{ begins a map in Elixir
        return (closes and after.kind != NUMBER) or (token.text == "%" and tight and after.text == "{")

    def is_of_text(self, i: int) -> bool:
        """Return whether a sign stands between columns, ends a sentence, or is a dash."""
        token, before, after = self.at(i), self.at(i - 1), self.at(i + 1)
        tight = token.end == after.start
        if token.text == "|":
            return after.kind in (LINE, NUMBER)
        if token.text in ".!?":
            factorial = token.text == "!" and before.kind == NUMBER and before.end == token.start
            if (factorial and self.is_written(i - 1)) or before.text == "?":  # 6!, size ?? box
                return False
            chooses = token.text == "?" and (":" in self.text[token.end : self.line(token)[1]] or after.kind == NUMBER)
            return not chooses and after.text not in (":", "[") and (after.kind == LINE or not tight)
        if token.text in "-\u2013\u2014":
            prose = after.kind == NAME and not self.is_variable(after) and self.at(i + 2).kind == NAME
            dash = prose and before.end < token.start and not tight
            return dash
        return False

    def is_operator(self, i: int) -> bool:
        """Return whether a sign is an operator on data, not a comparison: a | b, a << 1, !a, a || b."""
        token, before, after = self.at(i), self.at(i - 1), self.at(i + 1)
        if token.text in "|&":
            joins = before.kind == CLOSE and not self.is_tested(i - 1)
            return self.is_data(i - 1) and (self.is_data(i + 1) or joins)
        if token.text == "!":
            return (after.kind == OPEN or not after.text) and self.is_data(i + 1)
        shifts = after.text == token.text and self.at(i + 2).kind == NUMBER
        return shifts and self.is_data(i - 1) and not STREAM.search(self.text, *self.line(token))

    def is_tested(self, i: int) -> bool:
        """Return whether a bracket is that of the call of a test."""
        word = self.callee(self.open.get(i, i))
        return word is not None and is_test(word.text)


def within(spans: Sequence[tuple[int, int]], values: Sequence[Any]) -> set[Any]:
    """Return those of the values (with a `start`, such as tokens) that begin within one of these (start, end)."""
    spans = sorted((start, end) for start, end in spans)
    reach = list(accumulate((end for _, end in spans), max, initial=0))  # how far the first k spans reach
    return {v for v in values if v.start < reach[bisect_right(spans, v.start, key=itemgetter(0))]}


def last_of(name: str) -> str:
    """Return the last part of a name."""
    return parts_of(name)[-1]


def root(name: str) -> str:
    """Return the first part of a name, and the second one after `this` or `self`: player of this.player.x."""
    parts = parts_of(name)
    return parts[1] if parts[0] in ("this", "self") and len(parts) > 1 else parts[0]


def is_shape(name: str) -> bool:
    """Return whether a call makes or holds shapes: a row of the table, or a word for a shape or a list."""
    said = words(last_of(name))
    if said & CHANGING_CALLS:
        return False
    return notation(name) is not None or any(word.startswith(SHAPE_STEMS) for word in said)


def is_test(name: str) -> bool:
    """Return whether a call is one that tests shapes, and gives none: intersects, rotatedBoxesOverlap."""
    last = last_of(name)
    return TESTS.search(last) is not None and not words(last) & CHANGING_CALLS - ADJECTIVES


def is_call(name: str) -> bool:
    """Return whether a call is known to change no shape: of the table, a test of shapes, or a call that prints."""
    last = last_of(name).rstrip("!")
    said = words(last)
    if notation(name) is not None or name in CASTS or is_test(name):
        return True
    if said & CHANGING_CALLS:
        return False
    return is_shape(name) or bool(said & CALLS) or last.lower() in TWO_SHAPES or last.lower() in APPLIED
