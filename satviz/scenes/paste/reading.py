"""Values of a text as shapes, by the table of notations.  Where two readings are possible it is noted what to ask."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from math import cos, radians, sin
from typing import Any

from .notations import (
    ANY_BOX,
    ARC,
    BOX,
    CENTER_HALF,
    CENTER_SIZE,
    CIRCLE,
    CORNER_CORNER,
    CORNER_OR_CENTER,
    CORNER_SIZE,
    DEGREES,
    HARMLESS,
    MANY,
    MOVE,
    MOVES,
    POINT,
    RADIANS,
    RING,
    SETTERS,
    TURNS,
    Notation,
    key,
    notation,
)
from .tree import Bad, Group, Name, Num, Pair, Value

Pt = tuple[Fraction, Fraction]
ZERO = (Fraction(0), Fraction(0))

# What can be asked, and the words of `--as`.
BOX_FORM, ANGLE, TURN, ORDER, PIVOT, CORNERS = "box", "angle", "turn", "order", "pivot", "corners"
Y_UP, Y_DOWN, WIDTH_FIRST, HEIGHT_FIRST = "y-up", "y-down", "width-first", "height-first"
AROUND_CENTER, AROUND_CORNER, RELATIVE, ABSOLUTE = "around-center", "around-corner", "relative", "absolute"
CHOICES: Mapping[str, tuple[str, ...]] = {
    BOX_FORM: ANY_BOX,
    ANGLE: (DEGREES, RADIANS),
    TURN: (Y_UP, Y_DOWN),
    ORDER: (WIDTH_FIRST, HEIGHT_FIRST),
    PIVOT: (AROUND_CENTER, AROUND_CORNER),
    CORNERS: (RELATIVE, ABSOLUTE),
}
ALL_CHOICES = tuple(choice for choices in CHOICES.values() for choice in choices)
FULL_TURN = Fraction(63, 10)  # an angle beyond a full turn in radians is in degrees
ONLY_IF_IT_MATTERS = (TURN, ORDER)  # asked only where the answer changes
FORM_WORDS = {
    CORNER_SIZE: "a box by a corner and its size",
    CORNER_CORNER: "a box by two opposite corners",
    CENTER_SIZE: "a box by its center and its size",
    CENTER_HALF: "a box by its center and half its size",
}


class Unreadable(Exception):
    """Raised for what looks like a shape but has a part that is not a number."""


@dataclass(frozen=True, slots=True)
class Read:
    """A shape as it was read: exact points (of a circle its center), the words for it, and where it stands."""

    points: tuple[Pt, ...]
    radius: Fraction | None
    said: str
    start: int
    end: int
    label: str = ""
    rounded: bool = False  # turned by an angle, so its corners are no decimals any more
    negative: str = ""  # the negative size that was given
    box: tuple[Fraction, ...] = ()  # the four numbers of a box, with its form
    form: str = ""
    keyed: bool = False  # the numbers of a box have names: width, height
    shift: Pt = ZERO  # the position that was added to its corners

    @property
    def is_circle(self) -> bool:
        """Return whether it is a circle."""
        return self.radius is not None


@dataclass(slots=True)
class Obj(Value):
    """An object: its fields, and values without a key."""

    fields: dict[str | int, Any] = field(default_factory=dict)
    rest: list[Any] = field(default_factory=list)
    twice: str = ""  # a key that stands twice

    def before(self, name: str, place: int) -> Any:
        """Return the value that a name had at a place in the text, or None: the last one that was assigned before."""
        found = [v for k, v in self.fields.items() if k == name or str(k).startswith(f"{name} (")]
        earlier = [v for v in found if v.start <= place and not _holds(v, place)]
        return max(earlier, key=lambda v: v.start, default=None)

    def get(self, *meanings: str) -> Any:
        """Return the value of the first key with one of these meanings, or None."""
        for meaning in meanings:
            for name, value in self.fields.items():
                if key(name) == meaning:
                    return value
        return None


class Reader:
    """Reads a tree once, with the readings that were chosen; `asked` and `problems` say what is open or unreadable."""

    def __init__(self, text: str, chosen: Sequence[str] = ()) -> None:
        self.text = text
        self.chosen = chosen
        self.asked: dict[str, tuple[str, ...]] = {}
        self.problems: list[str] = []
        self.remarks: list[str] = []
        self.env = Obj(0, len(text))
        self.loose: list[Any] = []
        self.used: set[int] = set()  # values that another one refers to by name

    def read(self, root: Group) -> list[Read]:
        """Return every shape of a tree, in the order of the text."""
        self.assign(root.items)
        entries = [(self._begin(value), str(name), value) for name, value in self.env.fields.items()]
        entries += [(value.start, "", value) for value in self.loose]
        found: list[tuple[int, Read]] = []
        for _, name, value in sorted(entries, key=lambda entry: entry[0]):
            label = name.split(" (")[0]
            shapes = self.shapes(value, label)
            if len(shapes) > 1:  # the name is that of a result, or of a list, and of no single shape
                shapes = [replace(s, label="") if s.label == label else s for s in shapes]
            found += [(id(value), shape) for shape in shapes]
        return [shape for owner, shape in found if owner not in self.used]

    def _begin(self, value: Any) -> int:
        """Return where a value, or the first field of an object, begins."""
        if isinstance(value, Obj) and value.fields:
            return min(map(self._begin, (*value.fields.values(), *value.rest)))
        begin: int = value.start
        return begin

    # -- lines and names

    def assign(self, items: Sequence[Any]) -> None:
        """Sort the lines of a text or block: what gets a name, and what stands alone."""
        column: list[Group] = []
        for item in (*items, None):
            if isinstance(item, Group) and item.bracket in (",", " ") and self._is_row(item):
                column.append(item)
                continue
            if len(column) > 2:
                self.loose.append(Group(column[0].start, column[-1].end, list(column), "lines"))
            else:
                self.loose += [row for row in column if len(row.items) != 2]
            column = []
            self._line(item)

    def _is_row(self, item: Group) -> bool:
        """Return whether a line consists of two numbers."""
        return len(item.items) == 2 and all(isinstance(v, Num) for v in item.items)

    def _line(self, item: Any) -> None:
        """Take one line."""
        if isinstance(item, Pair):
            self._insert(item)
        elif isinstance(item, Bad):
            for inner in item.inside:
                self._line(inner)
        elif isinstance(item, Group):
            last = item.name.replace("->", ".").replace("::", ".").split(".")[-1].lower()
            if item.bracket == "{" and not item.name and _is_block(item):
                self.assign(item.items)
            elif item.bracket == "," and any(isinstance(v, (Pair, Bad)) for v in item.items):
                for inner in item.items:
                    self._line(inner)
            elif item.bracket == "[" and item.name and len(item.methods) == 1 and item.methods[0][0].lower() in SETTERS:
                index = item.items[0] if item.items else None
                number = int(index.value or 0) if isinstance(index, Num) else 0
                path: tuple[str | int, ...] = (*item.name.split("."), number)
                self._insert(Pair(item.start, item.end, path, item.methods[0][1]))
            elif last in (*MOVES, *TURNS) and "." in item.name and len(item.items) in (1, 2):
                field_name = "position" if last in MOVES else "angle"
                value = item if last in MOVES and len(item.items) == 2 else item.items[0]
                value = Group(item.start, item.end, item.items, "(") if value is item else value
                self._insert(Pair(item.start, item.end, (*item.name.split(".")[:-1], field_name), value))
            else:
                self.loose.append(item)

    def _insert(self, pair: Pair) -> None:
        """Store a value under its path; a variable that is declared again keeps its earlier value as another shape."""
        node = self.env
        for part in pair.path[:-1]:
            child = node.fields.get(part)
            if not isinstance(child, Obj):
                child = Obj(pair.start, pair.end, rest=[] if child is None else [child])
                node.fields[part] = child
            node = child
            node.start, node.end = min(node.start, pair.start), max(node.end, pair.end)
        last = pair.path[-1]
        if last in node.fields:
            old = node.fields.pop(last)
            node.fields[f"{last} ({len(node.fields)})"] = old
        value = pair.value
        if isinstance(value, Bad) and value.inside:
            value = Group(value.start, value.end, value.inside, "words")
        node.fields[last] = value

    def resolve(self, value: Any) -> Any:
        """Return what a name stands for, if it was assigned; an object for a group of pairs; else the value itself."""
        for _ in range(8):
            if not isinstance(value, Name):
                break
            node: Any = self.env
            for part in value.text.replace("->", ".").replace("::", ".").split("."):
                node = node.before(part, value.start) if isinstance(node, Obj) else None
            if node is None:
                break
            value = node
        if isinstance(value, Pair):
            return value.value
        return value

    def consume(self, items: Sequence[Any]) -> None:
        """Note that the values behind these names belong to a shape, so that they are not shapes of their own."""
        self.used |= {id(self.resolve(item)) for item in items if isinstance(item, Name)}

    def as_object(self, group: Group) -> Obj:
        """Return a group with pairs as an object."""
        made = Obj(group.start, group.end)
        for item in group.items:
            if isinstance(item, Pair):
                node = made
                for part in item.path[:-1]:
                    child = node.fields.get(part)
                    if not isinstance(child, Obj):
                        child = Obj(item.start, item.end)
                        node.fields[part] = child
                    node = child
                if item.path[-1] in node.fields:
                    made.twice = str(item.path[-1])
                node.fields.setdefault(item.path[-1], item.value)
            elif item is not None:
                made.rest.append(item)
        return made

    # -- numbers and points

    def number(self, value: Any) -> Fraction:
        """Return an exact number; Unreadable says why there is none."""
        given = value
        value = self.resolve(value)
        if isinstance(value, Num):
            if value.value is None:
                raise Unreadable(value.why)
            return value.value
        if isinstance(given, Name):
            name = given.text
            if name.lower().rsplit(".", 1)[-1] in ("nan", "inf", "infinity", "positive_infinity"):
                raise Unreadable(f"{name} is not a finite number")
            raise Unreadable(f"{_short(name)} is a name and no number: write its value")
        part = self.text[given.start : given.end] if isinstance(given, Value) else ""
        raise Unreadable(f"{_short(part)} is not evaluated: write the number that it stands for")

    def numbers(self, items: Sequence[Any]) -> list[Fraction] | None:
        """Return the items as numbers; None if most are none; Unreadable if one among numbers is none."""
        found = [self.resolve(item) for item in items]
        count = sum(isinstance(v, Num) for v in found)
        if not found or count * 2 < len(found) or any(isinstance(v, (Group, Obj)) for v in found):
            return None
        return [self.number(item) for item in items]

    def point(self, value: Any, *, origin: bool = False) -> Pt | None:
        """Return a point, or None for anything else; Unreadable for a point with a coordinate that is no number.

        `origin`: a call without numbers, `new Vector()`, is the origin; a corner must have its numbers.
        """
        value = self.resolve(value)
        if isinstance(value, Obj):
            return self._xy(value)
        if not isinstance(value, Group):
            return None
        row = notation(value.name) if value.name else None
        if row and row.kind != POINT and not (row.kind == RING and value.bracket in "[("):
            return None
        if any(isinstance(item, Pair) for item in value.items):
            made = self.as_object(value)
            found = self._xy(made)
            if found and made.rest:
                raise Unreadable("there is something beside x and y")
            return found
        items = value.items
        if len(items) == 1 and isinstance(items[0], Group) and items[0].bracket in " ({[" and not items[0].name:
            items = items[0].items
        if not items and origin and row and row.kind == POINT:
            return ZERO
        if len(items) == 2 and any(isinstance(v, Num) for v in items) and (not row or row.kind == POINT):
            call = next((v for v in items if isinstance(v, Group) and v.name and not notation(v.name)), None)
            if call is not None and not value.name and self.point(call) is None:
                self.number(call)  # says that it is not evaluated
        if len(items) not in (2, 3) or any(isinstance(self.resolve(v), (Group, Obj)) for v in items):
            return None
        plain = sum(isinstance(self.resolve(v), Num) for v in items)
        if len(items) == 3:
            if plain < 3 or not row or row.kind != POINT:
                return None
            self.remark("a third coordinate was left out: the shapes are read in x and y")
        if plain == 0 and not (row and row.kind == POINT):
            return None
        self._refuse_methods(value)
        return self.number(items[0]), self.number(items[1])

    def _xy(self, obj: Obj) -> Pt | None:
        """Return the point of an object with x and y."""
        x, y = obj.get("x"), obj.get("y")
        if obj.twice and (x is not None or y is not None):
            raise Unreadable(f"the key {obj.twice} stands twice")
        if x is None or y is None or obj.get("radius", "width", "half", "size", "points") is not None:
            return None
        return self.number(x), self.number(y)

    def remark(self, text: str) -> None:
        """Note something about the reading, once."""
        if text not in self.remarks:
            self.remarks.append(text)

    def _refuse_methods(self, group: Group) -> None:
        """Raise Unreadable for a call behind a value that would change it."""
        for name, arguments in group.methods:
            if name.lower() not in HARMLESS and arguments.items:
                raise Unreadable(f".{name}(...) is not evaluated: write the result")

    def ring(self, value: Any) -> list[Pt] | None:
        """Return the points of an outline, or None; Unreadable where one among points has no numbers."""
        value = self.resolve(value)
        if isinstance(value, Obj):
            numbered = {k: v for k, v in value.fields.items() if isinstance(k, int)}
            if not numbered:
                return None
            return self._points([numbered[k] for k in sorted(numbered)])
        if not isinstance(value, Group) or any(isinstance(item, Pair) for item in value.items):
            return None
        row = notation(value.name) if value.name else None
        if row and row.kind not in (RING, POINT):
            return None
        self._refuse_methods(value)
        items = [item for item in value.items if not (isinstance(item, Group) and not item.items and not item.name)]
        if len(items) == 1 and isinstance(self.resolve(items[0]), (Group, Obj)):
            if isinstance(items[0], Name) and not row:
                return None  # the argument of a call that makes no shape: p.intersects(q)
            return self.ring(items[0])
        if value.bracket == "," and any(isinstance(v, Group) and v.bracket == " " for v in items):
            items = [n for v in items for n in (v.items if isinstance(v, Group) and v.bracket == " " else [v])]  # SVG
        flat = self.numbers(items)
        if flat is not None:
            if len(flat) < 6 or (row and row.kind == POINT):
                return None
            if len(flat) % 2:
                raise Unreadable(f"a list of {len(flat)} numbers is no list of x and y: one is missing or too many")
            return list(zip(flat[::2], flat[1::2], strict=True))
        return self._points(items)

    def _points(self, items: Sequence[Any]) -> list[Pt] | None:
        """Return the items as points; None if fewer than two are; Unreadable if only some are."""
        found: list[Pt | None] = []
        why = ""
        for number, item in enumerate(items):
            try:
                found.append(self.point(item))
            except Unreadable as error:
                found.append(None)
                why = why or f"corner {number}: {error}"
        count = sum(p is not None for p in found)
        threes = [v for v in map(self.resolve, items) if isinstance(v, Group) and len(v.items) == 3 and not v.name]
        if count == 0 and len(threes) == len(items) > 1 and all(isinstance(n, Num) for v in threes for n in v.items):
            raise Unreadable("each point has three numbers: satviz is about two dimensions, so leave out the third")
        if count < max(2, len(items) // 2) and not (why and len(items) > 2):
            return None
        if count == 2 and len(items) == 3 and self._is_number(items[2]):
            return None  # a center, a size and an angle
        if count < len(items):
            place = next(i for i, p in enumerate(found) if p is None)
            raise Unreadable(why or f"item {place} of a list of corners is no pair of numbers")
        return [p for p in found if p is not None]

    # -- shapes

    def shapes(self, value: Any, label: str = "") -> list[Read]:
        """Return the shapes in a value; what cannot be read is noted in `problems`."""
        value = self.resolve(value)
        try:
            if isinstance(value, Bad):
                return [s for inner in value.inside for s in self.shapes(inner, label)]
            if isinstance(value, Obj):
                return self._object(value, label)
            if isinstance(value, Group):
                return self._group(value, label)
        except Unreadable as error:
            where = f"{label}: " if label else ""
            part = _short(self.text[value.start : value.end]) if isinstance(value, Value) else ""
            if (text := f"{where}{error} (in {part})") not in self.problems:
                self.problems.append(text)
        return []

    def _group(self, group: Group, label: str) -> list[Read]:
        """Return the shapes of a bracket, a call or a typed list, with the calls behind it."""
        row = notation(group.name) if group.name else None
        kind = row.kind if row else ""
        if kind in (POINT, MOVE):
            self._refuse_methods(group)  # Point(0, 0).buffer(1)
            return []
        if group.name == "LINESTRING":
            raise Unreadable("a line is no polygon: satviz takes outlines with an area")
        if kind == ARC:
            ring = self._points(group.items) or []
            if len(ring) == 3 and ring[0] == ring[2] and ring[0][1] == ring[1][1]:
                (x0, y), (x1, _), _ = ring
                return [
                    Read(
                        (((x0 + x1) / 2, y),), abs(x1 - x0) / 2, "a circle by two points", group.start, group.end, label
                    )
                ]
            raise Unreadable("an outline with arcs: satviz takes polygons and circles")
        if kind == CIRCLE:
            found = self._circle(group, label)
        elif kind == BOX and row:
            found = self._box(group, row, label)
        elif kind == RING and group.bracket != '"':
            found = self._polygon(group, label)
        elif kind == MANY:
            return [s for item in group.items for s in self._rings(item, label)]
        else:
            found = self._plain(group, label)
        return self._after(group, found)

    def _after(self, group: Group, found: list[Read]) -> list[Read]:
        """Return shapes with the moves and turns behind them applied; Unreadable for any other change."""
        for name, arguments in group.methods if found else ():
            plain = name.lower()
            if plain in MOVES and len(arguments.items) in (1, 2):
                move = self.point(arguments) or self.point(arguments.items[0])
                if move:
                    found = [_moved(shape, move) for shape in found]
                    continue
            if plain in TURNS and len(arguments.items) == 1:
                found = [self._turned(shape, arguments.items[0], TURNS[plain], None) for shape in found]
                continue
            if plain not in HARMLESS and arguments.items and self.numbers(arguments.items) is not None:
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

    def _outline(self, points: list[Pt], value: Value, label: str, shift: Pt = ZERO, how: str = "") -> Read:
        """Return a polygon; `how`: words about the position that was added."""
        moved = tuple((x + shift[0], y + shift[1]) for x, y in points)
        said = f"a polygon of {len(points)} corners{how}"
        return Read(moved, None, said, value.start, value.end, label, shift=shift)

    def _arguments(self, group: Group) -> tuple[list[Any], Obj]:
        """Return the arguments of a call that say something, and its named ones."""
        named = self.as_object(group)
        kept = []
        for item in named.rest:
            value = self.resolve(item)
            if isinstance(value, (Name, Bad)) and not (isinstance(value, Bad) and value.inside):
                if isinstance(value, Bad):
                    kept.append(item)
                continue  # null, a body, options
            if isinstance(value, Group) and not value.items and not value.name:
                continue
            if isinstance(value, Group) and any(isinstance(v, Pair) for v in value.items) and not value.name:
                options = self.as_object(value)
                if options.get("x") is None and not any(isinstance(k, int) for k in options.fields):
                    angle = next((k for k in options.fields if key(k) in ("angle", "degrees", "radians")), None)
                    if angle is not None and _begins_with_numbers(named.rest):
                        named.fields[angle] = options.fields[angle]
                        continue
                    if options.get("points", "radius", "width", "size", "min", "half") is None:
                        continue
            kept.append(item)
        named.rest = []
        return kept, named

    def _body(self, arguments: list[Any]) -> tuple[list[Any], Pt | None, Any]:
        """Return the arguments without a body, and that body's position and angle."""
        for i, item in enumerate(arguments):
            value = self.resolve(item)
            if isinstance(value, Obj) and self._xy(value) is None and not any(isinstance(k, int) for k in value.fields):
                place = value.get("center")
                return [*arguments[:i], *arguments[i + 1 :]], place and self.point(place), value.get("angle")
        return arguments, None, None

    def _polygon(self, group: Group, label: str) -> list[Read]:
        """Return the polygon of a call or typed list: corners, or a position and corners."""
        arguments, named = self._arguments(group)
        arguments, place, angle = self._body(arguments)
        if named.fields and not arguments:
            return self._object(replace(named, start=group.start, end=group.end), label)
        angle = angle if angle is not None else named.get("angle", "degrees", "radians")
        place = place or (self.point(named.get("center")) if named.get("center") is not None else None)
        loose = Group(group.start, group.end, arguments, group.bracket, group.name)
        outline = self.ring(loose)
        taken = arguments
        count_of_position = 0
        if outline is None and len(arguments) > 1:
            first = self.point(arguments[0], origin=True)
            rest = self.ring(arguments[1])
            if first is None and len(arguments) > 2 and self.numbers(arguments[:2]):
                first = self.point(Group(group.start, group.end, arguments[:2], "("))
                count_of_position = 2
                rest = self.ring(arguments[2])
            if first is not None and rest is not None:
                place, outline = first, rest
            elif first is None and self.ring(arguments[0]):
                outline = self.ring(arguments[0])
                others = [self.resolve(a) for a in arguments[1:]]
                if any(isinstance(a, Group) and self.ring(a) for a in others):
                    if notation(group.name) and group.name.lower().split("::")[0].split(".")[-1] in ("polygon",):
                        raise Unreadable("a polygon with holes: satviz takes outlines without holes")
                    outline = None
        if outline is None or len(outline) < 3:
            return self._plain(group, label)
        if place is not None and group.name.lower().endswith("fromvertices"):
            cx, cy = _centroid(outline)
            place = place[0] - cx, place[1] - cy  # Matter puts the center of mass there
        self.consume(taken)
        if any(not key(name) and self.point(value) is not None for name, value in named.fields.items()):
            raise Unreadable("a list of corners has something else in it")
        beside = sum(self._is_number(a) for a in arguments)
        if beside and not (outline is not None and self.numbers(arguments)) and beside != count_of_position:
            self.remark("numbers beside a list of corners were left out")
        shift = place or ZERO
        made = self._outline(outline, group, label, shift, " and a position" if shift != ZERO else "")
        return [self._turned(made, angle, _unit_of(named), shift)] if angle is not None else [made]

    def _circle(self, group: Group, label: str) -> list[Read]:
        """Return the circle of a call: (center, radius), (x, y, radius), or (radius) where a position is given."""
        arguments, named = self._arguments(group)
        arguments, place, _ = self._body(arguments)
        if named.fields and named.get("radius") is not None and not arguments:
            return self._object(replace(named, start=group.start, end=group.end), label)
        if not arguments:
            return []
        places = (self.point(a, origin=True) for a in arguments if isinstance(self.resolve(a), (Group, Obj)))
        points = [p for p in places if p]
        flat = self.numbers([a for a in arguments if not isinstance(self.resolve(a), (Group, Obj))]) or []
        if not points and len(flat) >= 3:
            points, flat = [(flat[0], flat[1])], flat[2:]
        if not flat and named.get("radius") is not None:
            flat = [self.number(named.get("radius"))]
        if not flat:
            raise Unreadable("a circle without a radius")
        x, y = points[0] if points else ZERO
        if place:
            x, y = x + place[0], y + place[1]
        said = "a circle by its center and radius" if points or place else "a circle by its radius, at the origin"
        return [Read(((x, y),), flat[0], said, group.start, group.end, label)]

    def _box(self, group: Group, row: Notation, label: str) -> list[Read]:
        """Return the box of a call, in the form of its row or as it is asked."""
        arguments, named = self._arguments(group)
        arguments, place, angle = self._body(arguments)
        if angle is None:
            angle = named.get("angle", "degrees", "radians")
        if named.fields and not (angle is not None and len(named.fields) == 1 and arguments):
            return self._object(replace(named, start=group.start, end=group.end, rest=arguments), label, row)
        parts = [self.point(a) if isinstance(self.resolve(a), (Group, Obj)) else None for a in arguments]
        if parts and any(p is not None for p in parts):
            flat: list[Fraction] = []
            for argument, part in zip(arguments, parts, strict=True):
                flat += part if part is not None else [self.number(argument)]
        else:
            flat = self.numbers(arguments) or []
        if row.form == CENTER_HALF and len(flat) >= 4 and parts[0] is None:
            flat = [*flat[2:4], *flat[:2], *flat[4:]]  # b2 and planck: half sizes, then the center
        if len(flat) == 2:  # a size alone: its center is where its body is
            form = row.form or CENTER_SIZE
            form = form if form in (CENTER_SIZE, CENTER_HALF) else CENTER_SIZE
            flat = [*(place or ZERO), *flat]
            return [self._made_box(flat, form, group, label, angle, row.unit)]
        if len(flat) not in (4, 5):
            return self._plain(replace(group, name="", methods=[]), label)
        ask = row.ask or ()
        if not row.form and len(arguments) == 3:
            ask = CORNER_OR_CENTER  # a point, a width and a height
        form = self._choose(BOX_FORM, ask) if ask else self._overridden(row.form)
        if len(flat) == 5 and angle is None:
            angle = Num(group.start, group.end, flat[4])
        if len(arguments) == 4 and not named.fields and row.ask == ANY_BOX:
            self._ask_order()
        made = self._made_box(flat[:4], form, group, label, angle, RADIANS if row.form == CENTER_HALF else row.unit)
        made = replace(made, keyed=bool(row.form))
        return [_moved(made, place) if place else made]

    def _overridden(self, form: str) -> str:
        """Return the form of a row, or the one that the user chose for all boxes."""
        return next((c for c in self.chosen if c in ANY_BOX), form)

    def _ask_order(self) -> None:
        """Note that width and height could be the other way round."""
        self.asked.setdefault(ORDER, CHOICES[ORDER])

    def _choose(self, what: str, ask: Sequence[str]) -> str:
        """Return the chosen reading; if none is, the first, and note that it is asked."""
        for choice in self.chosen:
            if choice in ask:
                return choice
        self.asked[what] = tuple(dict.fromkeys((*self.asked.get(what, ()), *ask)))
        return ask[0]

    def _made_box(
        self, four: Sequence[Fraction], form: str, at: Value, label: str, angle: Any = None, unit: str = ""
    ) -> Read:
        """Return a box of four numbers in a form, turned if an angle is given."""
        a, b, w, h = four
        if HEIGHT_FIRST in self.chosen and form in (CORNER_SIZE, CENTER_SIZE, CENTER_HALF):
            w, h = h, w
        if form == CORNER_SIZE:
            x0, y0, x1, y1 = a, b, a + w, b + h
        elif form == CORNER_CORNER:
            x0, y0, x1, y1 = a, b, w, h
        else:
            rx, ry = (w / 2, h / 2) if form == CENTER_SIZE else (w, h)
            x0, y0, x1, y1 = a - rx, b - ry, a + rx, b + ry
        negative = ""
        if form != CORNER_CORNER and (w < 0 or h < 0):
            negative = " and ".join(f"{n} {plain(v)}" for n, v in (("width", w), ("height", h)) if v < 0)
        xs, ys = sorted((x0, x1)), sorted((y0, y1))
        corners = ((xs[0], ys[0]), (xs[1], ys[0]), (xs[1], ys[1]), (xs[0], ys[1]))
        made = Read(
            corners, None, FORM_WORDS[form], at.start, at.end, label, negative=negative, box=tuple(four), form=form
        )
        if angle is None or self.number(angle) == 0:
            return made
        pivot = ((xs[0] + xs[1]) / 2, (ys[0] + ys[1]) / 2)
        if form == CORNER_SIZE and self._choose(PIVOT, CHOICES[PIVOT]) == AROUND_CORNER:
            pivot = (a, b)
        return self._turned(made, angle, unit, pivot)

    def _turned(self, shape: Read, angle: Any, unit: str, pivot: Pt | None) -> Read:
        """Return a shape turned by an angle about a pivot (None: the origin); the unit is asked where none is named."""
        value = self.number(angle)
        if value == 0 or shape.is_circle:
            return shape
        if not unit:
            likely = (DEGREES, RADIANS) if value.denominator == 1 else (RADIANS, DEGREES)
            more_than_a_turn = abs(value) > FULL_TURN and RADIANS not in self.chosen
            unit = DEGREES if more_than_a_turn else self._choose(ANGLE, likely)
        self.asked.setdefault(TURN, CHOICES[TURN])
        signed = -value if Y_DOWN in self.chosen else value
        if unit == DEGREES and signed % 90 == 0:
            quarter = int(signed / 90) % 4
            c, s = map(Fraction, ((1, 0), (0, 1), (-1, 0), (0, -1))[quarter])
            exact = True
        else:
            turn = radians(float(signed)) if unit == DEGREES else float(signed)
            c, s = Fraction(cos(turn)), Fraction(sin(turn))
            exact = False
        px, py = pivot or ZERO
        points = tuple((px + (x - px) * c - (y - py) * s, py + (x - px) * s + (y - py) * c) for x, y in shape.points)
        said = f"{shape.said}, turned by {plain(value)} {unit}"
        return replace(shape, points=points, said=said, rounded=shape.rounded or not exact)

    def _object(self, obj: Obj, label: str, row: Notation | None = None) -> list[Read]:
        """Return the shape that an object describes by its keys, or else the shapes in its fields."""
        kind = obj.fields.get("type")
        if obj.twice and key(obj.twice):
            raise Unreadable(f"the key {obj.twice} stands twice")
        if isinstance(kind, Name) and "coordinates" in obj.fields:
            inside = obj.fields["coordinates"]
            if kind.text == "Polygon":
                return self._rings(inside, label)
            if kind.text == "MultiPolygon" and isinstance(inside, Group):
                return [s for each in inside.items for s in self._rings(each, label)]
            return []
        angle, unit = obj.get("angle", "degrees", "radians"), _unit_of(obj)
        center = obj.get("center", "corner")
        place = None if center is None else self.point(center)
        if place is None and obj.get("x") is not None and obj.get("y") is not None:
            place = (self.number(obj.get("x")), self.number(obj.get("y")))
        if place is None:
            place = next((p for p in (self.point(v) for v in obj.rest if isinstance(v, (Group, Obj))) if p), None)
        points = obj.get("points")
        outline = self.ring(points) if points is not None else None
        if outline is None and any(isinstance(k, int) for k in obj.fields):
            outline = self.ring(obj)
        if outline is not None and len(outline) > 2:
            shift = place or ZERO
            if shift != ZERO and self._choose(CORNERS, CHOICES[CORNERS]) == ABSOLUTE:
                shift = ZERO
            made = self._outline(outline, obj, label, shift, " and a position" if shift != ZERO else "")
            return [self._turned(made, angle, unit, shift) if angle is not None else made]
        radius = obj.get("radius")
        if radius is not None and isinstance(self.resolve(radius), (Num, Bad)):
            said = "a circle by its center and radius" if place else "a circle by its radius, at the origin"
            return [Read((place or ZERO,), self.number(radius), said, obj.start, obj.end, label)]
        if four := self._box_of_keys(obj, place, center, row):
            return [replace(self._made_box(*four, obj, label, angle, unit), keyed=True)]
        if obj.rest and (place is not None or angle is not None):
            found = [s for v in obj.rest for s in self.shapes(v, label)]
            found = [_moved(s, place) if place and self.point(obj.get("center")) else s for s in found]
            return [self._turned(s, angle, unit, place) if angle is not None else s for s in found]
        inner = [s for v in obj.rest for s in self.shapes(v, label)]
        for name, value in obj.fields.items():
            if not (isinstance(kind, Name) and name in ("bbox", "properties")):
                wrapper = isinstance(name, int) or name in ("geometry", "features", "geometries", "shape")
                inner += self.shapes(value, label if wrapper else str(name).split(" (")[0])
        return inner

    def _box_of_keys(
        self, obj: Obj, place: Pt | None, center: Any, row: Notation | None
    ) -> tuple[list[Fraction], str] | None:
        """Return (four numbers, form) of an object whose keys describe a box, or None."""
        get = obj.get
        least, most = get("min"), get("max")
        if least is not None and most is not None:
            p, q = self.point(least), self.point(most)
            return ([*p, *q], CORNER_CORNER) if p and q else None
        corners = [get(name) for name in ("x0", "y0", "x1", "y1")]
        if corners[2] is None and corners[0] is None and "x1" in obj.fields and "x2" in obj.fields:
            corners = [obj.fields.get(name) for name in ("x1", "y1", "x2", "y2")]
        elif corners[0] is not None and corners[2] is None:
            corners[2:] = [obj.fields.get("x1"), obj.fields.get("y1")]
        if all(c is not None for c in corners):
            return [self.number(c) for c in corners], CORNER_CORNER
        if place is None and all(c is not None for c in corners[:2]):
            place = (self.number(corners[0]), self.number(corners[1]))
        half = get("half")
        if half is not None or (get("halfwidth") is not None and get("halfheight") is not None):
            size = (
                self.point(half)
                if half is not None
                else (self.number(get("halfwidth")), self.number(get("halfheight")))
            )
            return ([*(place or ZERO), *size], CENTER_HALF) if size else None
        size = self.point(get("size")) if get("size") is not None else None
        if size is None and get("width") is not None and get("height") is not None:
            size = (self.number(get("width")), self.number(get("height")))
        if size is None or place is None:
            return None
        named_center = any(
            isinstance(n, str) and n.lower() in ("center", "centre", "centroid", "middle") for n in obj.fields
        )
        named_center = named_center or any(isinstance(n, str) and n.lower() in ("cx", "center_x") for n in obj.fields)
        named_corner = get("corner") is not None or get("x0") is not None
        if named_center or named_corner:
            return [*place, *size], CENTER_SIZE if named_center else CORNER_SIZE
        if row and row.form in CORNER_OR_CENTER:
            return [*place, *size], self._overridden(row.form)
        return [*place, *size], self._choose(BOX_FORM, CORNER_OR_CENTER)

    def _plain(self, group: Group, label: str) -> list[Read]:
        """Return the shapes of a bracket that no name explains."""
        if any(isinstance(item, Pair) for item in group.items):
            if _is_block(group):
                return [s for item in group.items for s in self.shapes(item, _label(item) or label)]
            return self._object(self.as_object(group), label)
        outline = self.ring(group)
        if outline is not None and len(outline) > 2:
            return [self._outline(outline, group, label)]
        if outline is not None and len(outline) == 2 and not _is_call(group):
            form = self._choose(BOX_FORM, (CORNER_CORNER, CORNER_SIZE, CENTER_SIZE, CENTER_HALF))
            return [self._made_box([*outline[0], *outline[1]], form, group, label)]
        items = [item for item in group.items if item is not None]
        flat = self.numbers(items) if not _is_call(group) else None
        if flat is not None and len(flat) in (4, 5):
            self._ask_order()
            if len(flat) == 5:
                return [self._made_box(flat[:4], CENTER_SIZE, group, label, Num(group.start, group.end, flat[4]))]
            return [self._made_box(flat, self._choose(BOX_FORM, ANY_BOX), group, label)]
        if len(items) in (2, 3) and all(self._is_number(item) for item in items[1:]):
            center = self.point(items[0])
            if center is not None and len(items) == 2:
                radius = self.number(items[1])
                return [Read((center,), radius, "a circle by its center and radius", group.start, group.end, label)]
            if center is not None and _is_call(group):
                four = [*center, self.number(items[1]), self.number(items[2])]
                return [self._made_box(four, self._choose(BOX_FORM, CORNER_OR_CENTER), group, label)]
        if len(items) == 3 and self._is_number(items[2]):
            center, size = self.point(items[0]), self.point(items[1])
            if center is not None and size is not None:
                return [self._made_box([*center, *size], CENTER_SIZE, group, label, items[2])]
        if not _is_call(group) and len(items) > 1:
            pairs = [self.point(item) is not None for item in items if isinstance(item, Group)]
            if any(pairs) and not all(pairs):
                raise Unreadable("a list of corners has something else in it")
        return list(self._each(items, label))

    def _is_number(self, item: Any) -> bool:
        """Return whether an item is a number, or a name that stands for one."""
        return isinstance(self.resolve(item), Num)

    def _each(self, items: Sequence[Any], label: str) -> Iterator[Read]:
        """Yield the shapes of several values; a transform moves and turns the next shape."""
        move: Pt | None = None
        angle: Any = None
        resolved = [self.resolve(item) for item in items]
        moving = any(
            isinstance(v, Group) and v.name and getattr(notation(v.name), "kind", "") == MOVE for v in resolved
        )
        for item, value in zip(items, resolved, strict=True):
            if isinstance(item, Name) and not moving:
                continue  # a shape with a name is read where it gets its name
            if moving:
                self.consume([item])
            row = notation(value.name) if isinstance(value, Group) and value.name else None
            if row and row.kind == MOVE:
                parts = [a for a in value.items if a is not None]
                place = self.point(parts[0]) if parts and isinstance(self.resolve(parts[0]), Group) else None
                flat = None if place else self.numbers(parts[:2])
                move = place or ((flat[0], flat[1]) if flat and len(flat) == 2 else ZERO)
                angle = parts[1] if place and len(parts) > 1 and self._is_number(parts[1]) else None
                continue
            for shape in self.shapes(item, label):
                turned = self._turned(shape, angle, RADIANS, None) if angle is not None else shape
                yield _moved(turned, move) if move else turned
                move, angle = None, None


def _holds(value: Any, place: int) -> bool:
    """Return whether a place in the text lies in a value, or in a field of an object: then it cannot name it."""
    if isinstance(value, Obj):
        return any(_holds(v, place) for v in (*value.fields.values(), *value.rest))
    return bool(value.start <= place < value.end)


def _begins_with_numbers(items: Sequence[Any]) -> bool:
    """Return whether a call's arguments begin with two numbers, as a box's do."""
    return len(items) > 1 and all(isinstance(item, Num) for item in items[:2])


def _is_block(group: Group) -> bool:
    """Return whether braces hold statements and not the fields of one object."""
    pairs = [item for item in group.items if isinstance(item, Pair)]
    if any(len(item.path) > 1 and isinstance(item.path[0], str) for item in pairs):
        return True
    statements = any(isinstance(item, (Bad, Group)) for item in group.items)
    said = pairs or any(isinstance(item, Bad) for item in group.items)
    return bool(said) and statements and group.bracket == "{"


def _is_call(group: Group) -> bool:
    """Return whether a group is a call or a list with a type before it."""
    return bool(group.name)


def _label(item: Any) -> str:
    """Return the name that a pair gives to its value."""
    return str(item.path[0]) if isinstance(item, Pair) else ""


def _unit_of(obj: Obj) -> str:
    """Return the unit that a key names, or ""."""
    named = {key(name) for name in obj.fields}
    return DEGREES if "degrees" in named else RADIANS if "radians" in named else ""


def _moved(shape: Read, move: Pt) -> Read:
    """Return a shape that was moved."""
    points = tuple((x + move[0], y + move[1]) for x, y in shape.points)
    said = shape.said.replace(", at the origin", " and a position") if move else shape.said
    return replace(shape, points=points, said=said)


def _centroid(ring: Sequence[Pt]) -> Pt:
    """Return the center of area of an outline; the mean of its corners if it has no area."""
    area = x = y = Fraction(0)
    for (px, py), (qx, qy) in zip(ring, (*ring[1:], ring[0]), strict=True):
        cross = px * qy - py * qx
        area += cross
        x += cross * (px + qx)
        y += cross * (py + qy)
    if not area:
        return sum((p[0] for p in ring), Fraction(0)) / len(ring), sum((p[1] for p in ring), Fraction(0)) / len(ring)
    return x / area / 3, y / area / 3


def plain(value: Fraction) -> str:
    """Return a number as a short decimal."""
    return f"{float(value):.12g}"


def _short(text: str) -> str:
    """Return a part of the text in one line, shortened."""
    one = " ".join(text.split())
    return one if len(one) <= 60 else f"{one[:60]}..."
