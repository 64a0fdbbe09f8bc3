"""Tokens as a tree of values: what is written inside what.  It knows brackets, calls, pairs and lines, but no library.

Every notation has the same few forms, so one grammar reads them all: a list in any bracket (with commas, semicolons
or spaces between its items), a call or an array with a type before its bracket, `key = value` and `key: value`, and
lines such as `verts[0] = c2V(-1, 1);`.  What a name means stands in `notations.py`.
"""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Any, NamedTuple

from ...engine.geometry import InvalidScene
from .atoms import (
    IGNORED_NAMES,
    OPERATORS,
    angle,
    end_of,
    is_cast,
    is_hyphen,
    is_long,
    is_mark,
    is_numeral,
    is_open,
    is_operator,
    is_pair,
    says_nothing,
    start_of,
    text_value,
)
from .harmless import CASTS
from .markup import all_tokens
from .notations import UNREAD, key
from .tokens import CLOSE, FIELD, LINE, MARK, MAX_CHARS, NAME, NUMBER, OPEN, OTHER, TEXT, Token, tokens
from .tree import Bad, Group, Name, Num, Pair, parts_of

MAX_ANGLE = 50  # characters of an angle in terms of pi
MAX_DEPTH = 24
MAX_WORDS_BETWEEN = 60  # tokens between a shape and the word that separates it from the next one
BEFORE_SHAPES = frozenset(["translate", "rotate"])  # of OpenSCAD: translate([1, 2]) square(4)
LEAST = 3  # corners of an outline
SIZES = frozenset(["center", "corner", "size", "half", "offset"])  # what a word before two numbers of a shape means
PAIRS = {"(": ")", "[": "]", "{": "}"}
SEPARATORS = frozenset(["vs", "versus", "and", "against", "intersects", "overlaps", "touches", "collides"])
ARROWS = frozenset(["->", "-->", "<->", "\u2192", "\u2194", "\u21d2"])


class Tree(NamedTuple):
    """A text as one group of lines; sentences about brackets; where indices and lengths end; all its numbers;
    its tokens as they stand; the parts that rows of tables, of markup and of sentences have, and signs that mean
    something."""

    root: Group
    remarks: list[str]
    indices: frozenset[int]
    numbers: list[Token]
    tokens: list[Token]
    parts: list[tuple[int, int]]


def parse(text: str) -> Tree:
    """Return the tree of a text."""
    if unread := next((why for pattern, why in UNREAD if pattern.search(text[:MAX_CHARS])), ""):
        raise InvalidScene(unread)
    plain, found, parts = all_tokens(text)
    parser = _Parser(text, found)
    root = Group(0, len(text), parser.items("", 0))
    written = (token for token in found if token.kind == NUMBER or (token.kind == TEXT and is_numeral(token)))
    numbers = [token for token in written if token.start < token.end]
    return Tree(root, parser.remarks, frozenset(parser.indices), numbers, plain, [*parts, *parser.understood])


class _Parser:
    """Reads tokens from left to right, one bracket at a time."""

    def __init__(self, text: str, found: Sequence[Token]) -> None:
        self.text = text
        self.tokens = found
        self.at = 0
        self.remarks: list[str] = []
        self.indices: set[int] = set()  # the ends of numbers that are an index or a length: v[2], float[3]
        self.understood: list[tuple[int, int]] = []  # spans that a rule understands: poly << P(0, 0) << P(1, 0)
        self.ended: set[int] = set()  # places of brackets with semicolons in them

    def items(self, bracket: str, depth: int) -> list[Any]:
        """Return the items up to the sign that closes `bracket`, the opening one ("": the whole text).

        depth: how many brackets are open; InvalidScene beyond MAX_DEPTH.
        """
        if depth > MAX_DEPTH:
            raise InvalidScene(f"brackets are nested deeper than {MAX_DEPTH} levels: paste the shapes alone")
        items: list[Any] = []
        opened = self.at - 1
        row: list[Any] = []  # values between commas on one line of the whole text
        atoms: list[Any] = []

        def end_item() -> None:
            """Take the atoms as one value."""
            value = self.value(atoms, bracket)
            atoms.clear()
            if value is None:
                return
            if bracket:
                many = (
                    isinstance(value, Group) and value.bracket == "+" and all(isinstance(v, Pair) for v in value.items)
                )
                items.extend(value.items if many else [value])
            elif row and isinstance(row[-1], Pair) and not isinstance(value, Pair):
                pair = row[-1]  # b.position = 300, 125
                many = isinstance(pair.value, Group) and pair.value.bracket == ","
                first = pair.value.items if many else [pair.value]
                pair.value = Group(first[0].start, value.end, [*first, value], ",")
                pair.end = value.end
            else:
                row.append(value)

        def end_line() -> None:
            """Take the row of values on this line as one item."""
            end_item()
            if row:
                plain = not any(isinstance(v, Pair) for v in row)
                one = (plain or all(isinstance(v, Pair) for v in row)) and len(row) > 1  # x = 0, y = 0, r = 5
                items.extend([Group(row[0].start, row[-1].end, list(row), ",")] if one else row)
                row.clear()

        while self.at < len(self.tokens):
            token = self.tokens[self.at]
            self.at += 1
            if token.kind == CLOSE:
                if bracket and PAIRS[bracket] == token.text:
                    break
                if not bracket:
                    continue  # one too many, as "A)" in prose
                self.remark(f"a bracket {bracket} is closed by {token.text}: close it with {PAIRS[bracket]}")
                if depth > 1:
                    self.at -= 1  # it may close the bracket outside
                break
            if token.kind == OPEN:
                group = Group(token.start, token.end, self.items(token.text, depth + 1), token.text)
                group.end = self.tokens[self.at - 1].end if self.at else token.end
                group.ended = token.start in self.ended
                atoms.append(group)
            elif token.kind == LINE:
                if bracket == "" and not self.goes_on(atoms):
                    end_line()
                    if self.next_is(LINE):
                        items.append(None)  # an empty line ends a column of points
                elif bracket == "{" and atoms and not self.goes_on(atoms):
                    end_item()
            elif token.text == "," and token.kind == MARK:
                end_item()
                if not bracket and self.next_is(LINE):
                    self.at += 1
            elif token.text == ";" and token.kind == MARK:
                if not bracket and atoms and is_open(atoms[-1]) and is_pair(atoms[-1]) and self.next_is(OPEN):
                    end_item()  # (0, 0); (4, 0); (4, 4)
                elif bracket:
                    end_item()
                    self.ended.add(self.tokens[opened].start)
                else:
                    end_line()
            elif not bracket and atoms and self.ends_sentence(token):
                end_line()
            elif not bracket and self.is_and_before_last_point(token, atoms, row):
                self.understood.append((token.start, token.end))
                end_item()
            elif not bracket and self.separates(token, atoms, row):
                end_line()
                items.append(None)
            elif token.kind == TEXT:
                atoms.append(self.quoted(token, depth))
            else:
                atoms.append(token)
        else:
            if bracket:
                self.remark(f"a bracket {bracket} is never closed, so the text may be cut off")
        end_item() if bracket else end_line()
        return items

    def remark(self, text: str) -> None:
        """Note what is wrong with a bracket, once."""
        if text not in self.remarks:
            self.remarks.append(text)

    def separates(self, token: Token, atoms: Sequence[Any], row: Sequence[Any]) -> bool:
        """Return whether a word or an arrow stands between two shapes on one line: A vs B."""
        arrow = token.kind == MARK and token.text in ARROWS
        if not arrow and not (token.kind == NAME and token.text.lower() in SEPARATORS):
            return False
        if token.text == "and" and self.next_is(NUMBER) and atoms and isinstance(atoms[-1], Token):
            return False  # 1, 2, 3 and 4
        near = atoms[-MAX_WORDS_BETWEEN:]
        said = any(isinstance(a, Group) or (isinstance(a, Token) and a.kind in (NUMBER, TEXT)) for a in near)
        return (said or bool(row)) and not (atoms and is_mark(atoms[-1], ("=", ":", ":=")))

    def ends_sentence(self, token: Token) -> bool:
        """Return whether a point ends a sentence, and another one begins after it."""
        loose = self.text[token.start - 1] == " "  # f . g
        return token.text == "." and not loose and self.next_is(NAME) and self.tokens[self.at].start > token.end

    def is_and_before_last_point(self, token: Token, atoms: Sequence[Any], row: Sequence[Any]) -> bool:
        """Return whether `token` is the "and" before the last point of a list: (0, 0), (4, 0) and (0, 3)."""
        before = atoms or row
        if token.text != "and" or not before or not is_pair(before[-1]) or not self.next_is(OPEN):
            return False
        rest = self.tokens[self.at : self.at + 6]
        point = [each.kind for each in rest[:5]] == [OPEN, NUMBER, MARK, NUMBER, CLOSE]
        return point and bool(row) and (len(rest) < 6 or rest[5].kind == LINE or rest[5].text in (".", ";"))

    def next_is(self, kind: str) -> bool:
        """Return whether the next token is of this kind."""
        return self.at < len(self.tokens) and self.tokens[self.at].kind == kind

    def goes_on(self, atoms: Sequence[Any]) -> bool:
        """Return whether the value goes on after the end of this line."""
        following = next((t for t in self.tokens[self.at : self.at + 8] if t.kind != LINE), None)
        last = atoms[-1] if atoms else None
        if isinstance(last, Token) and last.kind == MARK:
            return last.text != ":" or not self.begins_list()
        starts = following is not None and (following.text == "{" or following.kind == FIELD)
        field_follows = following is not None and following.kind == FIELD and not self.opens_block()
        return bool(atoms) and starts and (isinstance(last, Token) or field_follows)

    def begins_list(self) -> bool:
        """Return whether the next line begins with a number and a colon, as the first corner of a list does."""
        found = [token for token in self.tokens[self.at : self.at + 8] if token.kind != LINE]
        return len(found) > 1 and found[0].kind == NUMBER and found[1].text == ":"

    def opens_block(self) -> bool:
        """Return whether the next lines begin with a name and a brace, as rules of CSS do: .a {"""
        found = [token for token in self.tokens[self.at : self.at + 8] if token.kind != LINE]
        return len(found) > 1 and found[1].text == "{"

    def quoted(self, token: Token, depth: int) -> Any:
        """Return the values inside quotes, where they hold some: WKT, JSON; otherwise the text as a token."""
        inner = token.text[1:-1]
        if not any(c.isdigit() for c in inner) or not any(c in inner for c in "([{ ,"):
            return token
        begin = token.start + 1
        parser = _Parser(self.text, [t._replace(start=t.start + begin, end=t.end + begin) for t in tokens(inner)])
        items = [item for item in parser.items("", depth + 1) if item is not None]
        self.indices |= parser.indices
        self.understood += parser.understood
        self.remarks += [r for r in parser.remarks if r not in self.remarks]
        return items[0] if len(items) == 1 else Group(token.start, token.end, items, '"')

    # -- one item

    def value(self, atoms: list[Any], bracket: str, keys: int = 0) -> Any:
        """Return the value that the atoms between two separators stand for; None where they stand for none.

        bracket: the bracket that they stand in; keys: how many keys of this value were read before, as in a = b = 1.
        """
        if not atoms:
            return None
        if keys > MAX_DEPTH:
            return Bad(start_of(atoms[0]), end_of(atoms[-1]), "too many keys for one value")
        if pairs := self.run_of_pairs(atoms, bracket):
            return pairs
        mark = next((i for i, a in enumerate(atoms) if is_mark(a, ("=", ":=", "=>", ":"))), None)
        if mark is not None and not any(is_mark(a, ("==", "<=", ">=", "!=")) for a in atoms[:mark]):
            sign = mark
            if is_mark(atoms[mark], (":",)):  # `let a: Type = value`: the value comes after the =
                signs = [i for i, a in enumerate(atoms) if i > mark and is_mark(a, ("=",))]
                sign = signs[0] if len(signs) == 1 else mark  # a: pos=(0, 0) mass=3 r=10 has no type
                if any(isinstance(a, Token) and a.kind == NUMBER for a in atoms[mark:sign]):
                    sign = mark
                elif sign > mark and self.is_heading(atoms[mark], atoms[mark + 1]):
                    return self.value(atoms[mark + 1 :], bracket, keys + 1)
            path = self.path(atoms[:mark])
            if bracket == "{" and mark > 1 and any(isinstance(a, Token) and a.kind == NUMBER for a in atoms[:mark]):
                return Bad(start_of(atoms[0]), end_of(atoms[-1]), "a number beside a key")
            after = atoms[sign + 1 :]
            second = any(is_mark(a, ("=", ":")) for a in after[1:2])
            if second and isinstance(after[0], Token) and after[0].kind == NUMBER:
                rest: Any = Bad(start_of(after[0]), end_of(after[-1]), "two values for one key")
            else:
                rest = self.value(after, bracket, keys + 1)
            if rest is None:  # nothing follows the sign: a heading such as `body:`, or a slip among numbers
                groups = [a for a in atoms[:mark] if isinstance(a, Group) and not _are_words(a)]
                slips = groups or any(isinstance(a, Token) and a.kind == NUMBER for a in atoms[:mark])
                return Bad(start_of(atoms[0]), end_of(atoms[-1]), "a key without a value", groups) if slips else None
            if not path:
                return rest
            if is_operator(atoms[mark - 1]):  # b.x += 20 changes what it was
                path = (*path[:-1], f"{path[-1]} {atoms[mark - 1].text}=")
            words = [a.text for a in atoms[:mark] if isinstance(a, Token) and a.kind == NAME]
            words = [word for word in words if word not in IGNORED_NAMES]
            pair = Pair(start_of(atoms[0]), rest.end, path, rest, words[-2] if len(words) > 1 else "")
            last = atoms[mark - 1]
            if words and isinstance(last, Token) and last.kind == NUMBER and last.text.isdigit():
                pair.number = last.text
                self.indices.add(last.end)
            found = self.joined(atoms[:mark])[0]
            before = [a for a in found if isinstance(a, Group) and a.bracket in "({" and not _are_words(a)]
            return Group(pair.start, pair.end, [*before, pair], "+") if before else pair  # {x: 1, y: 2} radius: 5
        return self.plain(atoms, is_line=not bracket and not keys)

    def is_heading(self, colon: Token, name: Any) -> bool:
        """Return whether a colon ends words before a name and its value (Input: A = 1), not a name before its type."""
        single = isinstance(name, Token) and len(name.text) == 1 and name.text.isupper()
        return single or "\n" in self.text[colon.end : start_of(name)]

    def run_of_pairs(self, atoms: list[Any], bracket: str) -> Group | None:
        """Return the pairs of `x: 0 y: 0 width: 4`, where no comma stands between them; None for anything else."""
        marks = [i for i, a in enumerate(atoms) if is_mark(a, ("=", ":"))]
        if len(marks) < 2 or len({atoms[i].text for i in marks}) > 1 or marks[0] == 0:
            return None
        begins = [marks[0] - 1, *(i - 1 for i in marks[1:]), len(atoms)]
        pairs: list[Any] = []
        for begin, mark, end in zip(begins, marks, begins[1:], strict=False):
            a_key, value = atoms[begin], atoms[mark + 1 : end]
            named = isinstance(a_key, Token) and a_key.kind in (NAME, TEXT)
            says = any(isinstance(v, Group) or (isinstance(v, Token) and v.kind in (NUMBER, TEXT)) for v in value)
            if not named or not says:
                return None
            found = self.value([a_key, atoms[mark], *value], bracket)
            if not isinstance(found, Pair):
                return None
            pairs.append(found)
        return Group(pairs[0].start, pairs[-1].end, pairs, "+")

    def plain(self, atoms: list[Any], *, is_line: bool) -> Any:
        """Return the value of atoms that contain no `=` and no `:`; a line can begin with a bullet."""
        first = next((i for i, a in enumerate(atoms) if not says_nothing(a)), len(atoms))
        last = len(atoms) - (isinstance(atoms[-1], Token) and atoms[-1].text == ".")  # the end of a sentence
        atoms = atoms[first:last]
        start, end = (start_of(atoms[0]), end_of(atoms[-1])) if atoms else (0, 0)
        degrees = angle(self.text[start:end]) if 0 < end - start < MAX_ANGLE else None
        if degrees is not None:
            return Num(start, end, None, f"{self.text[start:end]} is an angle", degrees)
        if len(atoms) > 1 and is_operator(atoms[0]) and not (isinstance(atoms[1], Token) and atoms[1].kind == NUMBER):
            touches = atoms[0].text in "+-\u2212" and end_of(atoms[0]) == start_of(atoms[1])
            signed = atoms[0].text != "+" and not (is_line and len(atoms) > 2)
            if touches and (signed or is_operator(atoms[1])):  # -x, -Vec2(1, 2), ++x
                hides = any(map(is_long, self.joined(atoms[1:])[0]))
                return Bad(start_of(atoms[0]), end_of(atoms[-1]), "an expression, which is not evaluated", hides=hides)
            atoms = atoms[1:]  # a bullet before a line
        if not atoms:
            return None
        values, operators = self.joined(atoms)
        start, end = start_of(atoms[0]), end_of(atoms[-1])
        if operators:
            only = values[0] if len(values) == 1 else None
            if isinstance(only, Num) and only.value is not None and operators == ["-"] and atoms[0].end <= only.start:
                return Num(start, end, -only.value)
            if (
                operators == ["-"]
                and len(values) == 2
                and all(is_pair(v) and v.bracket == "(" and not v.name for v in values)
            ):
                self.mark_understood(atoms)
                return Group(start, end, values, " ")  # (0, 0)-(10, 10), as Go prints a box
            if (
                set(operators) == {"<"}
                and len(values) > LEAST
                and isinstance(values[0], Name)
                and _are_points(values[1:])
            ):
                self.mark_understood(atoms)
                return Pair(
                    start, end, (values[0].text,), Group(values[1].start, end, values[1:], "[")
                )  # poly << P(0, 0)
            hides = any(map(is_long, values))
            if any(o in OPERATORS for o in operators) or (hides and "@" in operators):  # a matrix product of Python
                return Bad(start, end, "an expression, which is not evaluated", hides=hides)
            return Bad(start, end, "not a number", [v for v in values if isinstance(v, Group)])
        while len(values) > 1 and _is_call(values[-1]) and _is_call(values[-2]) and values[-2].name in BEFORE_SHAPES:
            move = values.pop(-2)
            self.understood.append((move.start, move.start + len(move.name)))
            values[-1] = replace(values[-1], start=move.start, methods=[*values[-1].methods, (move.name, move)])
        if len(values) == 1:
            return values[0]
        if all(isinstance(v, Num) for v in values):
            return Group(start, end, values, " ")
        if all(isinstance(v, Group) for v in values):
            names = {v.name for v in values if is_pair(v)}
            if len(names) == len(values) and any(len(name) > 1 and key(name) in SIZES for name in names):
                pairs = [Pair(v.start, v.end, (v.name,), replace(v, name="")) for v in values]
                return Group(start, end, pairs, "+")  # pos (0, 0) vel (5, 0) size (10, 10)
            return Group(start, end, values, " ")
        for word, group in pairwise(values):
            if isinstance(word, Name) and isinstance(group, Group) and group.name:
                group.before = word.text
        inside = [v for v in values if not isinstance(v, (Name, Bad))]
        apart = len(inside) > 1 and all(isinstance(v, Num) for v in inside)  # 780 mod 2
        return Bad(start, end, "words", [] if apart else inside)

    def mark_understood(self, atoms: Sequence[Any]) -> None:
        """Record the OTHER tokens among these atoms as understood, so that they are not reported as unread."""
        self.understood += [(atom.start, atom.end) for atom in atoms if isinstance(atom, Token) and atom.kind == OTHER]

    def joined(self, atoms: list[Any]) -> tuple[list[Any], list[str]]:
        """Return (values, operators) of the atoms; a name and the brackets after it are one value."""
        values: list[Any] = []
        operators: list[str] = []
        i = 0
        while i < len(atoms):
            atom = atoms[i]
            i += 1
            if isinstance(atom, Group):
                last = values[-1] if values else None
                if isinstance(last, Group) and is_cast(last) and atom.bracket == "{":  # (Vector2){ 5, 5 }
                    values[-1] = Group(last.start, atom.end, atom.items, atom.bracket, last.items[0].text)
                    continue
                # new float[3] {...}: the bracket with the length comes before the list
                if isinstance(last, Name) and atom.bracket in "([{" and atom.bracket:
                    length = atom
                    if atom.bracket == "[" and len(atom.items) == 1 and isinstance(atom.items[0], Num):
                        self.indices.add(atom.items[0].end)  # v[2], or the length in b2Vec2 v[3]
                    while atom.bracket == "[" and len(atom.items) < 2 and i < len(atoms) and is_open(atoms[i]):
                        atom = atoms[i]
                        i += 1
                    if last.text in CASTS and len(atom.items) == 1 and isinstance(atom.items[0], Num):
                        values[-1] = atom.items[0]  # np.float64(0.5) is 0.5
                        continue
                    name = last.text if atom is length else ""  # the list after Vector2[] is no Vector2
                    values[-1] = Group(last.start, atom.end, atom.items, atom.bracket, name)
                elif atom.bracket == "(" and len(atom.items) == 1 and _is_negative(atom.items[0]):  # (-1.0)
                    values.append(atom.items[0])
                else:
                    values.append(atom)
            elif not isinstance(atom, Token):
                values.append(atom)
            elif atom.kind == NUMBER:
                after = bool(values) and isinstance(values[-1], Num)
                quote = after and self.text[atom.start - 1] in "'\"`"  # '3'000 is no pair of numbers
                touching = after and (values[-1].end == atom.start or quote)
                if touching:
                    values[-1] = Num(
                        values[-1].start, atom.end, None, f"{self.text[values[-1].start : atom.end]!r} is not a number"
                    )
                else:
                    values.append(Num(atom.start, atom.end, atom.value, atom.why))
            elif atom.kind == NAME:
                if atom.text not in IGNORED_NAMES:
                    values.append(Name(atom.start, atom.end, atom.text))
            elif atom.kind == FIELD:
                last = values[-1] if values else None
                if isinstance(last, Group) and i < len(atoms) and is_open(atoms[i]):
                    last.methods.append((atom.text.lstrip(".->:"), atoms[i]))
                    last.end = atoms[i].end
                    i += 1
                elif isinstance(last, Num):
                    values[-1] = Num(last.start, atom.end, None, "an expression, which is not evaluated")
                else:
                    values.append(Name(atom.start, atom.end, atom.text))
            elif atom.kind == TEXT:
                values.append(text_value(atom))
            elif atom.kind in (MARK, OTHER) and atom.text not in "&":
                operators.append("-" if atom.text == "\u2212" else atom.text)
        return values, operators

    def path(self, atoms: Sequence[Any]) -> tuple[str | int, ...]:
        """Return the path that is assigned to: the last name before the sign, with the indices and fields after it."""
        names = [i for i, a in enumerate(atoms) if isinstance(a, Token) and a.kind in (NAME, TEXT)]
        parts: list[str | int] = []
        begin = names[-1] if names else 0
        while begin > 1 and is_hyphen(atoms, begin - 1):  # border-radius is no radius
            begin -= 2
        if begin < (names[-1] if names else 0):
            self.understood.append((start_of(atoms[begin]), start_of(atoms[names[-1]])))
            return (self.text[start_of(atoms[begin]) : end_of(atoms[names[-1]])],)
        for atom in atoms[begin:]:
            if isinstance(atom, Token) and atom.kind in (NAME, TEXT, FIELD):
                text = atom.text[1:-1] if atom.kind == TEXT else atom.text
                parts += [p for p in parts_of(text) if p]
            elif isinstance(atom, Token) and atom.kind == NUMBER and not names:
                parts.append(atom.text)
            elif isinstance(atom, Group) and atom.bracket == "[" and len(atom.items) == 1:
                index = atom.items[0]
                if isinstance(index, Num) and index.value is not None and index.value.denominator == 1:
                    parts.append(int(index.value))
                    self.indices.add(index.end)
                elif isinstance(index, Name) and self.text[index.start] in "'\"":  # b["x"] = 20
                    parts.append(index.text)
        return tuple(parts)


def _is_call(value: Any) -> bool:
    """Return whether a value is a bracket with a name before it."""
    return isinstance(value, Group) and bool(value.name)


def _is_negative(value: Any) -> bool:
    """Return whether a value is a number below zero."""
    return isinstance(value, Num) and value.value is not None and value.value < 0


def _are_words(group: Group) -> bool:
    """Return whether a bracket holds words, as in: polygon A (4 corners): ..."""
    return all(isinstance(v, Bad) and v.why == "words" for v in group.items)


def _are_points(values: Sequence[Any]) -> bool:
    """Return whether all values are brackets with two numbers."""
    return all(map(is_pair, values))
