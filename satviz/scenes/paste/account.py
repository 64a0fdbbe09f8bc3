"""The account of a text: every token stands in a shape, or is known to be harmless, or is named as not understood.

It looks at the tokens alone, beside the reader and after it, so what the reader passed over is seen here.  A token is
accounted for if a shape has it, if a row of `notations` explains it, or if a list of `harmless` words has it; a word
outside the brackets of a shape is prose.
"""

import re
from bisect import bisect_left, bisect_right
from collections.abc import Collection, Sequence
from itertools import accumulate
from operator import itemgetter
from typing import Any, NamedTuple

from .harmless import (
    ADJECTIVES,
    CALLS,
    CASTS,
    CHANGING_CALLS,
    CHANGING_KEYS,
    CHANGING_WORDS,
    COUNTED,
    DECLARES,
    FLOW,
    INSIDE,
    KEYS,
    LABELS,
    METHODS,
    PRODUCERS,
    PUNCTUATION,
    TESTS,
    words,
)
from .notations import MOVES, SETTERS, SHAPE_STEMS, SHIFTS, TURNS, TWO_SHAPES, key, notation
from .statements import ADDERS, ATTACHERS, PEN_STARTS, PENS
from .tokens import CLOSE, FIELD, LINE, MARK, NAME, NUMBER, OPEN, OTHER, TEXT, Token, tokens

MAX_PARTS = 50  # that are not understood; fewer are named
APPLIED = frozenset([*METHODS, *MOVES, *SHIFTS, *TURNS, *ADDERS, *ATTACHERS, *PENS, *PEN_STARTS, *SETTERS])
MOVERS = frozenset([*MOVES, *SHIFTS, *TURNS, "scale", "transform", "settransform"]) - {"offset", "translation"}
ASSIGNS = ("=", ":=", ":")
STYLE = re.compile(r"[a-z]?[-.:ox]{1,2}[a-z]?")  # of a plot: b-
NO_WORDS = re.compile(r"[A-Za-z_][\w.]*")
COMPARES, SETS = re.compile(r"[<>]|[=!]="), re.compile(r"(?<![<>=!])=(?!=)|\+\+|--|<<|>>|\?")
NUMERALS = re.compile(r"[0-9]+")
PADDED = re.compile(r"0[0-9]+")  # 000, of 1,000
NOTHING = Token(LINE, "", 0, 0)


class Part(NamedTuple):
    """A part of the text that is not understood: where it begins and ends."""

    start: int
    end: int


class Frame(NamedTuple):
    """A bracket of the text: its tokens, the place of the word before it, and whether it holds data of a shape."""

    begin: int
    data: bool
    block: bool


class Account:
    """Goes through the tokens of a text; `parts` are those that are not understood."""

    def __init__(
        self,
        text: str,
        found: Sequence[Token],
        places: Collection[int],
        variables: Collection[str],
        known: Sequence[tuple[int, int]] = (),
        changed: Collection[str] = (),
    ) -> None:
        """`places`: where numbers of shapes end; `variables`: names of data; `known`: parts of a known form;
        `changed`: names with a value of which a field is set afterwards.
        """
        self.text = text
        removed = within(known, found)
        self.places = sorted(places)
        rows = [Token(NUMBER, "", start, end) for start, end in known if self.holds(start, end)]
        kept = [token for token in found if token not in removed]
        self.tokens = sorted([*kept, *rows], key=lambda token: token.start) if rows else kept
        self.variables = variables
        self.changed = changed
        self.parts: list[Part] = []
        self.counts: set[int] = set()  # where numbers end that count or name something
        self.nested = False  # within a text in quotes, whose numbers nobody else counts
        self.quoted = False  # behind a quote of a text that goes over several lines
        self.session = ">>>" in text or "In [" in text
        self.close: dict[int, int] = {}
        self.open: dict[int, int] = {}
        self._match()

    def holds(self, start: int, end: int) -> bool:
        """Return whether a number of a shape ends within these places of the text."""
        at = bisect_left(self.places, start + 1)
        return at < len(self.places) and self.places[at] <= end

    def _match(self) -> None:
        """Find the bracket that closes each bracket."""
        stack: list[int] = []
        for i, token in enumerate(self.tokens):
            if token.kind == OPEN:
                stack.append(i)
            elif token.kind == CLOSE and stack:
                self.close[stack[-1]] = i
                self.open[i] = stack.pop()
        for i in stack:
            self.close[i] = len(self.tokens)

    def at(self, i: int) -> Token:
        """Return a token, or a line's end beyond the text."""
        return self.tokens[i] if 0 <= i < len(self.tokens) else NOTHING

    def beyond(self, i: int) -> Token:
        """Return the token at a place or behind it that is no line's end."""
        while i < len(self.tokens) and self.tokens[i].kind == LINE:
            i += 1
        return self.at(i)

    def span(self, i: int) -> tuple[int, int]:
        """Return where the bracket that a token opens or closes begins and ends."""
        begin, end = (i, self.close.get(i, i)) if self.at(i).kind == OPEN else (self.open.get(i, i), i)
        return self.at(begin).start, self.at(end).end or len(self.text)

    def is_data(self, i: int) -> bool:
        """Return whether a token is a number, a bracket with numbers of a shape, or the name of data."""
        token = self.at(i)
        if token.kind in (OPEN, CLOSE):
            begin = i if token.kind == OPEN else self.open.get(i, i)
            named = any(self.is_variable(t) for t in self.tokens[begin : min(self.close.get(begin, i), begin + 8)])
            return named or self.holds(*self.span(i))
        if token.kind == TEXT:
            return self.holds(token.start, token.end)
        if token.kind == NAME and self.at(i + 1).kind == OPEN and self.callee(i + 1) is token and i + 1 in self.close:
            return self.is_data(i + 1)
        return token.kind == NUMBER or self.is_variable(token)

    def is_variable(self, token: Token) -> bool:
        """Return whether a name is that of data."""
        return token.kind == NAME and _root(token.text) in self.variables

    def callee(self, i: int) -> Token | None:
        """Return the word before a bracket that makes it a call or a typed list."""
        before, token = self.at(i - 1), self.at(i)
        touches = before.end == token.start or token.text == "{"
        return before if touches and before.kind in (NAME, FIELD) else None

    def frame(self, i: int) -> Frame:
        """Return what the bracket at a place holds."""
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
        return Frame(i, self.holds(*self.span(i)) and not block and not call, block)

    def run(self) -> list[Part]:
        """Return the parts of the text that are not understood."""
        frames = [Frame(-1, False, True)]
        for i, token in enumerate(self.tokens):
            if len(self.parts) >= MAX_PARTS:
                break
            if token.kind == OPEN:
                self.check_call(i)
                frames.append(self.frame(i))
            elif token.kind == CLOSE and len(frames) > 1 and self.open.get(i) == frames[-1].begin:
                frames.pop()
            elif token.kind == NAME:
                self.check_name(i, frames[-1])
            elif token.kind == FIELD:
                self.check_field(i)
            elif token.kind == TEXT:
                self.check_text(i, frames[-1])
            elif token.kind == OTHER:
                self.check_sign(i, frames[-1])
            elif token.kind == NUMBER and self.is_count(i, frames[-1]):
                self.counts.add(token.end)
            elif token.kind == NUMBER and self.nested and not self.holds(token.start, token.end):
                self.miss(i, i)
            elif token.kind == NUMBER and PADDED.fullmatch(token.text):
                self.miss(i - 2 if self.at(i - 1).text == "," else i, i)  # 1,000
            elif token.kind == MARK and token.text in ("==", "!=", "<=", ">=") and frames[-1].data:
                self.miss(i - 1, i + 1)
        return self.parts

    def is_count(self, i: int, frame: Frame) -> bool:
        """Return whether a number counts or names something: a label before a colon, a length, 4 corners, { 0 }."""
        before, after = self.at(i - 1), self.at(i + 1)
        shifts = before.text in ("<", ">") and self.at(i - 2).text == before.text
        if before.text in ("<", ">", "<=", ">=", "==", "!=") and not shifts and not frame.data:
            return True
        if not self.at(i).text.isdigit():
            return False
        if before.kind == LINE:
            return after.text in (":", "|") or (self.session and after.kind == LINE)
        if before.text == "{" and after.text == "}":
            return self.at(i).value == 0
        if before.text == "(" and after.text == ")" and self.at(i + 2).text == "[":
            return True
        if after.text.lower() in COUNTED:
            return not self.holds(*self.span(i + 2)) if self.at(i + 2).kind == OPEN else True
        return before.text.lower() in LABELS and (after.kind == LINE or after.text in (":", ",", "at", "is", "of", ""))

    def miss(self, first: int, last: int) -> None:
        """Note that the tokens from one place to another are not understood."""
        begin, end = self.at(first), self.at(last)
        start = begin.start if begin is not NOTHING else self.at(first + 1).start
        end_at = self.span(last)[1] if end.kind == OPEN else end.end if end is not NOTHING else self.at(last - 1).end
        if self.at(first).kind == CLOSE:
            start = self.at(first).start
        if not self.parts or self.parts[-1].end < end_at:
            self.parts.append(Part(start, end_at))

    def check_call(self, i: int) -> None:
        """Name a call of an unknown function around the numbers of a shape, or of a shape by its name."""
        word = self.callee(i)
        if word is None or word.kind == FIELD or self.at(i).text != "(":
            return
        inside = self.tokens[i + 1 : self.close[i]]
        if not self.holds(*self.span(i)) and not any(self.is_variable(t) for t in inside[:200]):
            inside = []
        last = word.text.replace("->", ".").replace("::", ".").split(".")[-1]
        defines = self.at(i - 2).text in ("new", "def", "function", "fn", "func", "fun", "void", "class", "struct")
        if not inside and last.lower() in MOVERS and self.close[i] > i + 1 and not defines and self.places:
            self.miss(i - 1, i)  # ctx.translate(cx, cy)
            return
        if not inside and not (self.is_variable(word) and last != word.text):
            return
        method = self.is_variable(word) and last != word.text and last.lower() in APPLIED
        declared = self.at(i - 2).kind == NAME and notation(self.at(i - 2).text) is not None  # Circle c(0, 0, 1)
        makes = last.lower() in PRODUCERS and "." in word.text and not defines and last[0].islower()
        known = method or defines or declared or last.lower() in PENS | PEN_STARTS or is_call(word.text)
        if makes or not known:
            self.miss(i - 1, i)

    def check_name(self, i: int, frame: Frame) -> None:
        """Name a word among the numbers of a shape that is on no list."""
        token, after = self.at(i), self.at(i + 1)
        if after.kind == OPEN and self.callee(i + 1) is token:
            return  # of the call
        last = token.text.replace("->", ".").replace("::", ".").split(".")[-1]
        if self.is_variable(token):
            again = "." in token.text and after.text == "=" and _root(token.text) in self.changed
            if again and self.at(i + 2).kind == NAME and self.at(i + 3).kind != OPEN:
                self.miss(i, i + 2)  # a.x = b.x, where a has a value already
                return
            known = (key(last) and last != "T") or last.lower() in KEYS or is_call(last)
            if last != token.text and not known and after.text not in ASSIGNS:
                self.miss(i, i)  # pts.T
            elif after.text in ASSIGNS and self.is_field(token.text, last) and not self.takes_value(i + 1):
                self.miss(i, i + 2)  # a.flip = true
            return
        if token.text in FLOW and self.holds(token.end, self.statement_end(i)):
            self.miss(i, i)
        elif token.text in ("if", "else", "elif") and (self.gives_value(i) or self.is_choice(i)):
            self.miss(i, i + 1)
        if not frame.data:
            scales = token.text.lower() in CHANGING_CALLS and after.text == "(" and self.is_data(i + 1)
            if (scales or token.text.lower() in CHANGING_WORDS) and self.holds(*self.line(token)):
                self.miss(i, i)  # A: rect(0, 0, 4, 4), twice as large
            if after.text in ASSIGNS and words(token.text) & CHANGING_KEYS and not self.takes_value(i + 1):
                self.miss(i, i + 2)
            return
        if after.text in (*ASSIGNS, "=>"):
            if self.is_changing(last, i) or not (key(last) or self.is_key(last) or self.takes_value(i + 1)):
                self.miss(i, i + 2)
        elif self.at(i - 1).text in DECLARES:
            return  # (def a [[0 0] [4 0] [4 3]])
        elif not (last.lower() in INSIDE or words(last) & INSIDE or is_shape(token.text) or self.is_value(i)):
            self.miss(i, i)

    def line(self, token: Token) -> tuple[int, int]:
        """Return where the line of a token begins and ends."""
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
        known = before.text.strip("\"'")
        return self.at(i - 1).text in (*ASSIGNS, "=>") and (bool(key(known)) or bool(words(known) & KEYS))

    def takes_value(self, i: int) -> bool:
        """Return whether what stands behind a sign is data, which the numbers account for, or a new line."""
        while self.at(i + 1).kind == NAME and self.at(i + 2).kind in (OPEN, NAME):
            i += 1
        return self.is_data(i + 1) or self.at(i + 1).kind in (OPEN, LINE)

    def is_choice(self, i: int) -> bool:
        """Return whether data stands before a word in its line, and `else` behind it: a if b else c."""
        start, end = self.line(self.at(i))
        before = self.holds(start, self.at(i).start) or (self.at(i - 1).kind == CLOSE and self.is_data(i - 1))
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
        """Return where the statement after a word ends."""
        while i + 1 < len(self.tokens) and self.at(i + 1).text != ";" and self.at(i + 1).kind != LINE:
            i += 1
        return self.at(i).end

    def check_field(self, i: int) -> None:
        """Name an unknown field or method behind a shape."""
        before, after = self.at(i - 1), self.at(i + 1)
        before_line = next((self.tokens[k] for k in range(i - 1, -1, -1) if self.tokens[k].kind != LINE), NOTHING)
        name = self.at(i).text.lstrip(".->:")
        if (after.text in ASSIGNS and before.kind != CLOSE) or (before.kind == LINE and after.text == "{"):
            return  # {.x = 1}, or a rule of CSS
        k = i - 1
        while k > 0 and self.tokens[k].kind == LINE:
            k -= 1
        behind = before_line.kind in (NUMBER, TEXT) or (before_line.kind == CLOSE and self.is_data(k))
        if not behind:
            return
        if after.kind == OPEN and self.callee(i + 1):
            rows = name.lower() != "reshape" or self.at(self.close[i + 1] - 1).text in ("2", ",")
            inside = self.tokens[i + 2 : self.close[i + 1]]
            given = self.holds(*self.span(i + 1)) or any(map(self.is_variable, inside[:20]))
            applied = given if name.lower() in MOVERS else name.lower() in APPLIED
            known = rows and (applied or (name.lower() not in MOVERS and is_call(name)))
            if name.lower() in PRODUCERS or not known:
                self.miss(i, i + 1)
        elif not (name.lower() in KEYS - {"x", "y"} or is_call(name) or (after.text in ASSIGNS and key(name))):
            self.miss(i, i)

    def check_text(self, i: int, frame: Frame) -> None:
        """Name a text in quotes among the numbers of a shape that is on no list; look into one with such numbers."""
        token = self.at(i)
        inner = token.text[1:-1]
        if self.holds(token.start, token.end):
            if any(c in inner for c in "([{ ,"):
                begin = token.start + 1
                plain = inner.replace('\\"', ' "')
                found = [t._replace(start=t.start + begin, end=t.end + begin) for t in tokens(plain)]
                within_text = Account(self.text, found, self.places, self.variables)
                within_text.nested = True
                self.parts += within_text.run()
            return
        word = self.callee(frame.begin) if frame.begin >= 0 else None
        if word is not None and is_shape(word.text) and len(NUMERALS.findall(inner)) > 2:
            self.miss(i, i)  # the data of a path that cannot be read
        if not frame.data or not inner.strip():
            return
        if self.at(i + 1).text in (*ASSIGNS, "=>"):
            if self.is_changing(inner, i) or not (key(inner) or self.is_key(inner) or self.takes_value(i + 1)):
                self.miss(i, i + 2)
        elif not (words(inner) & INSIDE or self.is_value(i) or inner[0] == "#" or STYLE.fullmatch(inner)):
            self.miss(i, i)

    def check_sign(self, i: int, frame: Frame) -> None:
        """Name a sign among the numbers of a shape, or beside one."""
        token, before, after = self.at(i), self.at(i - 1), self.at(i + 1)
        if token.text == "'":
            behind = before.end == token.start and before.kind in (CLOSE, NAME, NUMBER, FIELD)
            transposes = not self.quoted and behind and not (after.kind == NAME and token.end == after.start)
            self.quoted = not behind
            if transposes and (self.is_variable(before) or (before.kind == CLOSE and self.is_data(i - 1))):
                self.miss(i - 1, i)  # [0 4 4; 0 0 3]' of MATLAB
                return
        if token.text in PUNCTUATION or token.text[0] == "\\":
            return
        if token.text == "+" and any(t.kind == TEXT and not self.holds(t.start, t.end) for t in (before, after)):
            return  # a text and what is printed behind it
        if token.text == "%" and after.text == "{" and token.end == after.start:
            return  # of Elixir
        first = before.kind == LINE or before.text in (",", "(", "[", "{", "=", ":", ";")
        refers = first or (before.kind == NAME and not self.is_variable(before))
        if token.text in "&*@" and token.end == after.start and refers and after.kind in (NAME, OPEN):
            return  # a reference
        if token.text in "&*" and before.kind == NAME and not self.is_variable(before) and not frame.data:
            return  # Polygon *p
        bullet = not self.is_variable(after) or self.at(i + 2).text in (":", "=")
        if before.kind == LINE and token.text in "-*+>|\u2022" and bullet:
            return  # a bullet, or a quoted line
        if token.text == "|" and not frame.data and (notation(after.text) or after.kind in (LINE, NUMBER)):
            return  # between the columns of a table
        if token.text == "-" and first and after.kind == NUMBER and self.at(i + 2).text in (",", ")", "]", "}", ";"):
            return  # - 4
        chooses = token.text == "?" and (self.is_ternary(i) or after.kind == NUMBER)
        ends = not frame.data and after.text not in (":", "[") and (after.kind == LINE or token.end != after.start)
        if token.text in ".!?" and ends and not chooses:
            return  # the end of a sentence
        tight = before.end == token.start and token.end == after.start
        if token.text == "?" and tight and after.text == "(" and before.kind == NAME and is_call(before.text):
            return  # a.hit?(b) of Ruby
        both = token.text in "|&" and self.is_data(i - 1) and self.is_data(i + 1)
        denies = token.text == "!" and after.text in ("[", "{") and self.is_data(i + 1)
        if token.text in "<>!|&" and not (both or denies) and not frame.data and before.kind != NUMBER:
            return  # a comparison, or a logical sign
        spaced = before.end < token.start and token.end < after.start
        prose = after.kind == NAME and not self.is_variable(after) and self.at(i + 2).kind == NAME
        if token.text in "-\u2013\u2014" and not frame.data and spaced and prose:
            return  # a dash in a sentence
        if token.text == "-" and not frame.data and before.text == ")" and after.text == "(":
            return  # (0, 0)-(10, 10)
        if not frame.data and self.is_test(token):
            return
        if frame.data or self.is_data(i - 1) or self.is_data(i + 1):
            self.miss(i - 1 if before.kind == NAME or (before.kind == NUMBER and before.text) else i, i + 1)

    def is_test(self, token: Token) -> bool:
        """Return whether a line compares names and gives none a value: return a.x < b.x + b.w."""
        start, end = self.line(token)
        line = self.text[start:end]
        return not self.holds(start, end) and bool(COMPARES.search(line)) and not SETS.search(line)

    def is_ternary(self, i: int) -> bool:
        """Return whether a colon follows a question mark in its line."""
        k = i + 1
        for _ in range(20):
            if k >= len(self.tokens):
                return False
            if self.tokens[k].kind == LINE or self.tokens[k].text == ";":
                return False
            if self.tokens[k].text == ":":
                return True
            k = self.close.get(k, k) + 1
        return False


def within(spans: Sequence[tuple[int, int]], values: Sequence[Any]) -> set[Any]:
    """Return those of the values that begin within a span."""
    spans = sorted((start, end) for start, end in spans)
    reach = list(accumulate((end for _, end in spans), max, initial=0))  # how far the first k spans reach
    return {v for v in values if v.start < reach[bisect_right(spans, v.start, key=itemgetter(0))]}


def _root(name: str) -> str:
    """Return the first part of a name."""
    return name.replace("->", ".").replace("::", ".").split(".")[0]


def is_shape(name: str) -> bool:
    """Return whether a call makes or holds shapes: a row of the table, or a word for a shape or a list."""
    said = words(name.replace("->", ".").replace("::", ".").split(".")[-1])
    if said & CHANGING_CALLS:
        return False
    return notation(name) is not None or any(word.startswith(SHAPE_STEMS) for word in said)


def is_call(name: str) -> bool:
    """Return whether a call is known to change no shape: of the table, a test of shapes, or a call that prints."""
    last = name.replace("->", ".").replace("::", ".").split(".")[-1].rstrip("!")
    said = words(last)
    if notation(name) is not None or name in CASTS or (said & TESTS and not (said & CHANGING_CALLS) - ADJECTIVES):
        return True
    if said & CHANGING_CALLS:
        return False
    return is_shape(name) or bool(said & CALLS) or last.lower() in TWO_SHAPES or last.lower() in APPLIED
