"""Values of a text as shapes, by the table of notations."""

import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Any

from .account import within
from .atoms import holds_numbers
from .axis_lists import joined, lengths, pairs_of_lists
from .boxes import CHOICES, Read, circle, moved, transformed
from .calls import Calls
from .cleaned import TYPE
from .exact import Exact, where
from .harmless import HARMLESS, OTHER_NUMBERS, TESTS, words
from .names import Obj, Unreadable, is_block, short
from .notations import (
    ANY_BOX,
    CORNER_OR_CENTER,
    MAKERS,
    MOVES,
    SHAPE_WORDS,
    TURNS,
    TWO_OF_A_KIND,
    TWO_SHAPES,
    Ask,
    Form,
    Kind,
    key,
    notation,
)
from .points import ZERO, Pt, angle_of
from .statements import ATTACHERS
from .tree import Bad, Group, Name, Pair, Value, parts_of

_SECTION = re.compile(r"^ *\[[A-Za-z]", re.MULTILINE)
_ASSIGNED = re.compile(r"[ \t+-]*(?:\w+[ \t*&]+){0,4}[\w.]+(?:\[\w*\])?[ \t]*:?=[ \t]*(?:new[ \t]+)?")  # Rect a =
# what a print or a log writes for corners that it leaves out
_ROW = r"(?=[^\d\n]*\d)[-+.,;()\[\]{}\d \t]*+"
SHORTENED = re.compile(
    r"[\[({<][^\W\d]{0,9} ?truncated\b[^\n]?|(?:\.\.\.|\u2026)\W{0,3}(?:and |<)?\d+ more\b[^\n\])]*|<\d+ more[^\n>]*>"
    r"|\b\d+ more (?:items?|points?|corners?|vertices|elements?|rows?|entries)\b|\bomitted \d+ rows|\band \d+ more\b"
    rf"|(?<=,)\s*(?:\.\.\.|\u2026)\s*(?=[,\])}}\n])|^{_ROW}\n[ \t]*(?:\.\.\.?|\u2026)(?:[ \t]*\.\.\.?)*[ \t]*$",
    re.MULTILINE,
)
_RESULT = re.compile(
    r"(?i)(output|result|intersection|union|expected|actual|got|answer)(\b|_).*"
    r"|(print\()?\w+\.(intersection|union|difference|buffer|clip)\(.*\)"
    r"|\w+\([\w, ]*\) ?="
)
_SEGMENT = re.compile(r"(?<![A-Za-z])(?:line|segment|seg|edge|ray)(?![a-z])|(?:Line|Segment|Edge|Ray)(?![a-z])")
# words of a line about something that was tried besides, or about what is no shape
_ASIDE = re.compile(
    r"\b(?:edit|update|p\.?s)\W{0,3}\d*:|(?<![a-z])(?:works|worked|tried|instead|phone|call|tel|fax|mobile|versions?|date"
    r"|colou?rs?|rgba?)(?![a-z])",
    re.IGNORECASE,
)
# words for kinds of shapes; those of one group are no circles, and those of the other are neither circles nor boxes
_KIND = re.compile(
    r"(?<![\w.<#])(?:circles?|ball|dis[ck]|box|(?P<angular>rect(?:angle)?|square|aabb|obb)"
    r"|(?P<other>(?:regular )?(?:[a-z]{3,5}a|n-|\d-)gon(?:al)?|ellip(?:se|tic|tical|soid)|oval|capsule|rhombus"
    r"|(?:semi|(?:half|quarter)[ -])circle|circular sector|stadium|cylinder|cone|sphere|annulus|rounded rect\w*"
    r"|triang\w+|(?:(?<=type\": \")|(?<=type\":\")|(?<=type: [\"']))(?:line|arrow)(?=[\"'])"
    r"|(?:diamond|pill|star|ring|wedge|donut|torus)(?![\"']?\s*[:=])))(?![\w(]|\s\()",
    re.IGNORECASE,
)
_COMMENT = re.compile(r"//|#|--|/\*")
_BOXES = re.compile(r"(?:boxes|rects|rectangles|aabbs|circles|balls)$", re.IGNORECASE)
_CIRCLES = re.compile(r"circle|(?:ball|disc|disk)s?$", re.IGNORECASE)
LEAST_FLAT = 5  # numbers in a list that are one shape: a box and its angle
COPIES = frozenset(["clone", "copy", "deepcopy", "dup", "duplicate"])
MAX_ABOVE = 400  # characters before a shape in which the line above it is looked for
MAX_BESIDE = 200  # characters before and after a shape in which words about it are looked for
MAX_PROBLEMS = 50  # problems that are collected; fewer are shown


class Reader(Calls):
    """Reads a tree once, with the readings that were chosen; `problems` says what could not be read."""

    def read(self, root: Group) -> list[Read]:
        """Return every shape of a tree, in the order of the text."""
        if cut := SHORTENED.search(self.text):
            self.problems.append(f"a list is shortened ({short(cut[0])}): write all of its corners")
        self.assign(root.items)
        entries = [(self._begin(value), str(name), value) for name, value in self.env.fields.items()]
        entries += [(value.start, "", value) for value in self.loose]
        axes = []  # points, and the lists of x and y that they are of
        for name, x, y in pairs_of_lists(self.env.fields):
            points = joined(x, y)
            if points is None:
                self.problems.append(lengths(x, y))
            elif not self.used & {id(x), id(y)}:
                axes.append((points, (x, y)))
                entries.append((points.start, name, points))
            self.taken |= {id(x), id(y)}
        entries = [e for e in entries if id(e[2]) not in self.taken and not isinstance(e[2], Name)]  # b = a
        entries += [(run.value.start, run.label, run.value) for run in self.runs]
        found: list[tuple[int, Read]] = []
        asked: list[tuple[int, dict[str, tuple[str, ...]]]] = []
        for _, name, value in sorted(entries, key=lambda entry: entry[0]):
            self.asked = {}
            asked.append((id(value), self.asked))
            label = name.split(" (")[0]
            shapes = self.shapes(value, label)
            if len(shapes) > 1:  # the name is that of a result, or of a list, and of no single shape
                shapes = [replace(s, label="") if s.label == label else s for s in shapes]
            found += [(id(value), shape) for shape in shapes]
        for run in self.runs:  # a name of it stands in another shape
            if any(id(value) in self.used for value in run.value.fields.values()):
                self.used.add(id(run.value))
        for points, lists in axes:
            if any(id(each) in self.used for each in lists):
                self.used.add(id(points))
        kept = [(owner, shape) for owner, shape in found if owner not in self.used]
        self.asked = {}
        known = (key, notation, SHAPE_WORDS.search)
        states = {name for name in map(str, self.env.earlier) if not any(look(name) for look in known)}
        steps = states if len(states) > 1 else set()  # player: ..., enemy: ..., and both again
        earlier = {
            id(v) for name, values in self.env.earlier.items() for v in values if name in steps or self._is_assigned(v)
        }
        if (
            any(owner in earlier for owner, _ in kept)
            and self._choose(Ask.TWICE, CHOICES[Ask.TWICE]) == Form.LAST_VALUE
        ):
            self.parts += [(shape.start, shape.end) for owner, shape in kept if owner in earlier]
            kept = [(owner, shape) for owner, shape in kept if owner not in earlier]
        shapes = [shape for _, shape in kept]
        doubtful: dict[Read, str] = {}
        if Form.TAKE_IN not in self.chosen:
            fields = within([match.span() for match in TYPE.finditer(self.text)], shapes)
            beside = {s for s in shapes if _ASIDE.search(self._line_of(s)) or self._is_bare(s)}
            results = {s for s in shapes if _RESULT.fullmatch(s.label) or _RESULT.fullmatch(self._above(s))}
            for some, what in (
                (fields, "what a class begins with"),
                (beside, "one of something else"),
                (results, "a result"),
            ):
                doubtful |= dict.fromkeys(some if len(some) < len(shapes) else (), what)
            doubtful |= self._of_other_kinds(shapes)
            doubtful |= {
                s: "a hole of the first outline of its list, which is filled without it"
                for s in shapes
                if s.start in self.holes
            }
            doubtful |= {s: "a bounding box" for p, s in pairwise(shapes) if s.form and _bounds(p) == s.points}
            first = {(s.points, s.radius, s.label): s for s in reversed(shapes)}
            twins = (s for s in shapes if first[s.points, s.radius, s.label] is not s and not s.repeats)
            doubtful |= dict.fromkeys(twins if len(first) > 1 else (), "the same shape again")
        self.problems += [
            f"{short(self.text[s.start : s.end])}: a shape of its own, or {why}" for s, why in doubtful.items()
        ]
        self.parts += [(s.start, s.end) for s in doubtful]
        self.doubts = bool(doubtful)
        self.used |= {owner for owner, _ in kept} - {owner for owner, shape in kept if shape not in doubtful}
        kept = [(owner, shape) for owner, shape in kept if shape not in doubtful]
        open_asks = [asks for owner, asks in asked if owner not in self.used] + [self.asked]
        self.asked = {}
        for what, ask in (pair for asks in open_asks for pair in asks.items()):
            self.asked[what] = tuple(dict.fromkeys((*self.asked.get(what, ()), *ask)))
        made = {(s.points, s.radius) for _, s in kept if not s.repeats}
        named = {(s.points, s.radius, s.label) for _, s in kept if s.label}
        again = [s for _, s in kept if (s.repeats and (s.points, s.radius) in made) or self._is_print(s, named)]
        self.parts += [(shape.start, shape.end) for shape in again]
        return [shape for _, shape in kept if shape not in again]

    def _of_other_kinds(self, shapes: Sequence[Read]) -> Iterator[tuple[Read, str]]:
        """Yield (shape, its kind) of each circle and box that the text calls otherwise: a hexagon with radius 5.

        The last word for a kind counts, between the shape before it on its line and its own end.
        """
        for before, shape in zip([0, *(s.end for s in shapes)], shapes, strict=False):
            begin = max(self.text.rfind("\n", 0, shape.start), before, shape.start - MAX_BESIDE, 0)
            *_, said = (None, *_KIND.finditer(self.text, begin, shape.end))
            other = said and (said["other"] or (shape.is_circle and said["angular"]))
            if (shape.is_circle or shape.form) and not shape.repeats and other:
                yield shape, f"of another kind: {other}"
            elif shape.label == "edges" and ")-(" not in self.text[shape.start : shape.end]:
                yield shape, "a list of edges"

    def _is_print(self, shape: Read, named: Collection[tuple[Any, ...]]) -> bool:
        """Return whether a shape without a name stands below the name of the same shape, as a session prints it.

        `named`: (points, radius, name) of each shape with a name.
        """
        return not shape.label and (shape.points, shape.radius, self._above(shape)) in named

    def _above(self, shape: Read) -> str:
        """Return the last line above a shape, or what stands before it on its line."""
        return (
            self.text[max(0, shape.start - MAX_ABOVE) : shape.start].rstrip("` \t\n<").rpartition("\n")[2].strip("` \t")
        )

    def _is_bare(self, shape: Read) -> bool:
        """Return whether a box is a row of numbers without brackets and names."""
        return bool(shape.form) and not (shape.label or shape.keyed) and self.text[shape.start] in "-+.0123456789"

    def _line_of(self, shape: Read) -> str:
        """Return the line on which a shape begins, without a comment."""
        before = self.text[max(0, shape.start - MAX_BESIDE) : shape.start].rpartition("\n")[2]
        after = self.text[shape.end : shape.end + MAX_BESIDE].partition("\n")[0]
        return _COMMENT.split(before + after, maxsplit=1)[0]

    def _is_assigned(self, value: Any) -> bool:
        """Return whether a value follows a sign that assigns, and not in a log: a: (0, 0, 4, 4)."""
        begin = self.text.rfind("\n", 0, value.start) + 1
        return bool(_ASSIGNED.fullmatch(self.text, begin, value.start)) and not _SECTION.search(self.text, value.end)

    def _begin(self, value: Any) -> int:
        """Return the place in the text where a value, or the first field of an object, begins."""
        if isinstance(value, Obj) and value.fields:
            return min(map(self._begin, (*value.fields.values(), *value.rest)))
        begin: int = value.start
        return begin

    def shapes(self, value: Any, label: str = "") -> list[Read]:
        """Return the shapes in a value; what cannot be read is noted in `problems`."""
        value = self.resolve(value)
        try:
            if isinstance(value, Bad) and value.hides:
                raise Unreadable("an expression, which is not evaluated: write its result")
            if isinstance(value, Bad):
                return [s for inner in value.inside for s in self.shapes(inner, label)]
            if isinstance(value, Obj):
                return self._object(value, label)
            if isinstance(value, Group):
                return self._group(self._by_its_name(value), label)
        except Unreadable as error:
            where = f"{label}: " if label else ""
            part = short(self.text[value.start : value.end]) if isinstance(value, Value) else ""
            if isinstance(value, Value):
                self.named.append((value.start, value.end))
            text = f"{where}{error} (in {part})"
            if len(self.problems) < MAX_PROBLEMS and text not in self.problems:
                self.problems.append(text)
        return []

    def _group(self, group: Group, label: str) -> list[Read]:
        """Return the shapes of a bracket, a call or a typed list, with its chained calls applied."""
        if (copied := self._copied(group)) is not None:
            return self.shapes(copied, label)
        if (
            not group.items and len(group.methods) == 1 and group.methods[0][0].lower() in MAKERS
        ):  # Box2().setFromPoints(a)
            ((name, given),) = group.methods
            group = replace(group, items=given.items, name=name, methods=[])
        row = notation(group.name) if group.name else None
        kind = row.kind if row else ""
        two = TWO_SHAPES.get(group.name.lower().split(".")[-1], ())
        for pattern, name, count in TWO_OF_A_KIND if TESTS.search(group.name) and not row else ():
            if pattern.search(group.name) and len(group.items) == 2 * count and all(map(self.point, group.items)):
                two = ((name, count), (name, count))
        if two:
            return self._two(group, two, label)
        if (plain := self._columns(group)) is not group:
            return self._plain(plain, label)
        if kind == Kind.OTHER_SHAPE and self._has_numbers(group):
            raise Unreadable(
                f"{short(group.name)} is not read: satviz takes boxes, circles, and polygons by their corners"
            )
        if kind == Kind.ON_THE_GLOBE:
            raise Unreadable(f"the center of {group.name} is in degrees and its radius is not: write both in one unit")
        if kind == Kind.TABLE:
            raise Unreadable("the names of the columns fit no shape: name them x, y, width, height or x, y, radius")
        if kind in (Kind.POINT, Kind.MOVE):
            self._refuse_methods(group)  # Point(0, 0).buffer(1)
            return []
        if group.name == "map" and self._has_numbers(group):
            raise Unreadable("map(...) is not evaluated: write the result")
        if group.name == "LINESTRING":
            raise Unreadable("a line is not a polygon: write three corners or more")
        if kind == Kind.ARC:
            ring = self._points(group.items) or []
            if len(ring) == 3 and ring[0] == ring[2] and ring[0][1] == ring[1][1]:
                (x0, y), (x1, _), _ = ring
                numbers = (c for p in ring for c in p)
                return [circle(((x0 + x1) / 2, y), abs(x1 - x0) / 2, group, label, "a circle by two points", *numbers)]
            raise Unreadable("an outline with arcs: give each arc as corners")
        if kind == Kind.CIRCLE:
            found = self._circle(group, label)
        elif kind == Kind.ELLIPSE and row:
            found = self._ellipse(group, row, label)
        elif kind == Kind.BOX and row:
            found = self._box(group, row, label)
        elif kind == Kind.RING and group.bracket != '"':
            found = self._polygon(group, label)
        elif group.name and parts_of(group.name)[-1].lower() in ATTACHERS:
            return self._attached(group, label)
        elif kind == Kind.MANY:
            return [s for item in group.items if not self._are_names(item) for s in self._rings(item, label)]
        else:
            found = self._plain(group, label)
        return self._with_chained_calls(group, found)

    def _are_names(self, value: Any) -> bool:
        """Return whether a value is a list of names: featureCollection([a, b])."""
        return isinstance(value, Group) and bool(value.items) and all(isinstance(v, Name) for v in value.items)

    def _two(self, group: Group, two: Sequence[tuple[str, int]], label: str) -> list[Read]:
        """Return the shapes of a call with the numbers of two: collideRectRect(0, 0, 4, 4, 2, 0, 4, 4).

        `two` has (notation, how many numbers) for each shape.
        """
        found: list[Read] = []
        at = 0
        for name, count in two:
            items, at = group.items[at : at + count], at + count
            if len(items) == count and (name in ("box", "triangle") or any(map(self._is_number, items))):
                found += self._group(Group(items[0].start, items[-1].end, items, "(", name), label)
        return [replace(shape, repeats=True) for shape in found]

    def _copied(self, group: Group) -> Any:
        """Return the named value that a call copies: that of a in a.clone() and in copy(a); None for other calls."""
        *owner, last = parts_of(group.name)
        if last.lower() not in COPIES or len(group.items) > 1 or group.methods:
            return None
        named = group.items[0] if group.items else Name(group.start, group.end, ".".join(owner))
        found = self.resolve(named)
        return found if isinstance(named, Name) and isinstance(found, (Group, Obj)) else None

    def _by_its_name(self, group: Group) -> Group:
        """Return a call with an alias in its name resolved: C is SAT.Circle after var C = SAT.Circle."""
        other = self.env.before(group.name, group.start) if group.name else None
        return replace(group, name=other.text) if isinstance(other, Name) else group

    def _attached(self, group: Group, label: str) -> list[Read]:
        """Return the shapes that a call gives to a body, at the body's position: body.addShape(circle)."""
        body = self.resolve(Name(group.start, group.end, ".".join(parts_of(group.name)[:-1])))
        made = body if isinstance(body, Obj) else Obj(group.start, group.end, rest=[body])
        place = made.get("center")
        angle = made.get("angle")
        for each in made.rest:
            if isinstance(each, Group):
                arguments, named = self._arguments(each)
                inner = [self.as_object(v) for v in each.items if isinstance(v, Group) and not v.name]
                for options in (named, *inner):
                    place = place if place is not None else options.get("center")
                    angle = angle if angle is not None else options.get("angle")
                place = place if place is not None or len(arguments) != 1 else arguments[0]
        at = self.vector(place) if place is not None else None
        self.consume(group.items)
        found = [s for item in group.items for s in self.shapes(item, label)]
        if angle is not None:
            found = [self._turned(shape, angle, Form.RADIANS, None) for shape in found]
        return [moved(shape, at) for shape in found] if at else found

    def _with_chained_calls(self, group: Group, found: list[Read]) -> list[Read]:
        """Return the shapes after the chained calls of the group, such as `.rotate(45)`.

        Unreadable for a call with numbers that is neither a move nor a turn.
        """
        for name, arguments in group.methods:
            plain = name.lower()
            passed = plain in HARMLESS or TESTS.search(plain)
            if not (found or passed):
                continue
            if passed and any(isinstance(v, Group) for v in arguments.items):
                found = [*found, *self._each(arguments.items, "")]  # a.intersects(b)
                continue
            if plain == "affine":  # the transforms of SVG
                *matrix, exact = (v.value for v in arguments.items)
                found = [transformed(shape, tuple(matrix), exact=bool(exact)) for shape in found]
                continue
            if plain in MOVES and len(arguments.items) in (1, 2):
                move = self.point(arguments) or self.vector(arguments.items[0])
                if move:
                    found = [moved(shape, move) for shape in found]
                    continue
            if plain in TURNS and len(arguments.items) == 1:
                at = [self.pivot(shape, rotates=plain.startswith("rotate")) for shape in found]
                found = [self._turned(s, arguments.items[0], TURNS[plain], p) for s, p in zip(found, at, strict=True)]
                continue
            numbers = [v for v in arguments.items if self._is_number(v)]
            if not passed and not words(plain) & OTHER_NUMBERS and numbers:
                if self.resolve(numbers[0]).turn is None:
                    self.number(numbers[0])  # says why it is none
                raise Unreadable(f".{name}(...) is not evaluated: write the result")
        return found

    def _rings(self, value: Any, label: str) -> list[Read]:
        """Return the polygon of an outer ring and its holes; Unreadable if it has holes."""
        value = self.resolve(value)
        if not isinstance(value, Group) or value.name:
            return self.shapes(value, label)
        rings = [r for r in value.items if isinstance(r, (Group, Name))]
        if len(rings) > 1 and self.point(rings[0]) is None and all(self.ring(r) for r in rings):
            raise Unreadable("a polygon with holes: satviz takes outlines without holes, so paste the outer ring alone")
        outline = self.ring(value)
        return [self._outline(outline, value, label)] if outline else []

    def _plain(self, group: Group, label: str) -> list[Read]:
        """Return the shapes of a bracket that no name explains."""
        if any(isinstance(item, Pair) for item in group.items):
            if is_block(group):
                return [s for item in group.items for s in self.shapes(item, _label(item) or label)]
            return self._object(self.as_object(group), label)
        if _BOXES.search(label) and not group.name and len(group.items) > LEAST_FLAT and holds_numbers(group):
            raise Unreadable(f"{len(group.items)} numbers in one list: write each shape in a bracket of its own")
        if _CIRCLES.search(label) and not group.name and group.items and all(map(_is_three, group.items)):
            return [circle((x, y), r, v, label) for v in group.items for x, y, r in [map(self.number, v.items)]]
        if "circle" in group.name.lower() and (circles := self._centers_and_radii(group.items, label)):
            return circles
        outline = self.ring(group)
        if outline is not None and len(outline) > 2:
            return [self._outline(outline, group, label)]
        if outline is not None and len(outline) == 2 and not _is_call(group):
            if _SEGMENT.search(label):
                raise Unreadable("two points are a line segment: satviz takes outlines with an area")
            self.remark("two points were read as a box: a line segment is no shape here")
            form = self._choose(
                Ask.BOX_FORM, (Form.CORNER_CORNER, Form.CORNER_SIZE, Form.CENTER_SIZE, Form.CENTER_HALF)
            )
            return [self._made_box([*outline[0], *outline[1]], form, group, label)]
        items = [item for item in group.items if item is not None]
        if group.bracket == "[" and len(items) > 2 and all(isinstance(v, Bad) and not v.inside for v in items):
            self.number(items[0])  # a list of expressions: says that they are not evaluated
        sizes = {len(v.items) if isinstance(v, Group) and not v.name and holds_numbers(v) else 0 for v in items}
        if len(items) > 2 and len(sizes) > 1 and min(sizes) > 2:
            raise Unreadable(
                f"lists of {' and '.join(map(str, sorted(sizes)))} numbers stand in one list: a corner has two numbers"
            )
        flat = self.numbers(items) if len(items) in (4, 5) and not _is_call(group) else None
        if flat is not None:
            self._ask_order()
            if len(flat) == 5:
                return [self._made_box(flat[:4], Form.CENTER_SIZE, group, label, angle_of(group, flat))]
            return [self._made_box(flat, self._choose(Ask.BOX_FORM, ANY_BOX), group, label)]
        shaped = not group.name or SHAPE_WORDS.search(group.name)
        if shaped and len(items) in (2, 3) and all(self._is_number(item) for item in items[1:]):
            center = self.point(items[0])
            if center is not None and len(items) == 2:
                return [circle(center, self.number(items[1]), group, label)]
            if center is not None and _is_call(group):
                four = [*center, self.number(items[1]), self.number(items[2])]
                return [self._made_box(four, self._choose(Ask.BOX_FORM, CORNER_OR_CENTER), group, label)]
        if len(items) == 3 and self._is_number(items[2]):
            center, size = self.point(items[0]), self.point(items[1])
            if center is not None and size is not None:
                return [self._made_box([*center, *size], Form.CENTER_SIZE, group, label, items[2])]
        if not _is_call(group) and len(items) > 1:
            pairs = {k: self.point(item) is not None for k, item in enumerate(items) if isinstance(item, Group)}
            if any(pairs.values()) and not all(pairs.values()):
                place = next(k for k, is_point in pairs.items() if not is_point)
                raise Unreadable(f"item {place} (counted from 0) of a list of corners is not a corner: write (x, y)")
        found = list(self._each(items, label))
        several = label.lower().endswith("s") and key(label) != "points" and label.lower() not in ("rings", "paths")
        if group.bracket in ("[", "(", "{") and not group.name and not several:
            self.holes |= set(_holes(found))
        return found

    def _each(self, items: Sequence[Any], label: str) -> Iterator[Read]:
        """Yield the shapes of several values; a transform moves and turns the next shape.

        `label`: the name of these shapes in the text.
        """
        move: Pt | None = None
        angle: Any = None
        resolved = [self.resolve(item) for item in items]
        moving = any(
            isinstance(v, Group) and v.name and getattr(notation(v.name), "kind", "") == Kind.MOVE for v in resolved
        )
        for item, value in zip(items, resolved, strict=True):
            if isinstance(item, Name) and not moving:
                continue  # a shape with a name is read where it gets its name
            if moving:
                self.consume([item])
            row = notation(value.name) if isinstance(value, Group) and value.name else None
            if row and row.kind == Kind.MOVE:
                parts = [a for a in value.items if a is not None]
                place = self.point(parts[0]) if parts and isinstance(self.resolve(parts[0]), Group) else None
                flat = None if place else self.numbers(parts[:2])
                move = place or ((flat[0], flat[1]) if flat and len(flat) == 2 else ZERO)
                angle = parts[1] if place and len(parts) > 1 and self._is_number(parts[1]) else None
                continue
            for shape in self.shapes(item, label):
                turned = self._turned(shape, angle, Form.RADIANS, None) if angle is not None else shape
                yield moved(turned, move) if move else turned
                move, angle = None, None


def _is_call(group: Group) -> bool:
    """Return whether a group is a call or a list with a type before it."""
    return bool(group.name)


def _bounds(shape: Read) -> tuple[Pt, ...]:
    """Return the corners of the bounding box of an outline; () for a box or a circle."""
    (x0, *_, x1), (y0, *_, y1) = (sorted(side) for side in zip(*(shape.points * 2), strict=True))
    return () if shape.form or shape.is_circle else ((x0, y0), (x1, y0), (x1, y1), (x0, y1))


def _holes(rings: Sequence[Read]) -> Iterator[int]:
    """Yield the start, in the text, of each outline that lies inside the first one: [[...], [...]]."""
    for ring in rings[1:] if rings and _bounds(rings[0]) else ():
        lies = where(Exact(rings[0].points), Exact(ring.points)) if _bounds(ring) else None
        if lies and lies.b_in_a and not lies.a_in_b:
            yield ring.start


def _is_three(value: Any) -> bool:
    """Return whether a value is a bracket with three numbers and no name."""
    return isinstance(value, Group) and not value.name and len(value.items) == 3 and holds_numbers(value)


def _label(item: Any) -> str:
    """Return the key of a pair as the name of its shape; "" for an item without a key."""
    return str(item.path[0]) if isinstance(item, Pair) else ""
