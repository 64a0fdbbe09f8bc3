"""What the lines of a text do: give names, add corners, draw with a pen, and set the fields of a shape."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

from .atoms import holds_numbers, is_pair
from .harmless import words
from .names import Names, Obj, is_block, short
from .notations import MAKERS, MOVES, RESETS, SETTERS, SHIFTS, TURNS, Kind, key, notation
from .tree import Bad, Group, Name, Num, Pair, Value, parts_of

# Calls that add a corner to a list, that draw an outline with a pen, and that give a shape to a body.
ADDERS = frozenset(
    ["add", "push", "push_back", "emplace_back", "append", "addpoint", "addvertex", "add_point", "add_vertex"]
)
NUMBERED = frozenset(["setpoint", "setvertex", "set_point", "set_vertex"])
PENS = frozenset(["moveto", "lineto", "vertex", "curvevertex"])
PEN_STARTS = frozenset(["moveto", "beginpath", "beginshape", "endshape", "closepath", "endpath"])
ATTACHERS = frozenset(["addshape", "add_shape", "createfixture", "create_fixture", "addfixture", "setshape"])
# Calls that only sketches of Processing and p5.js have.
_SKETCH = re.compile(
    r"\b(?:rectMode|ellipseMode|createCanvas|collide[A-Z]\w*|beginShape|noStroke|strokeWeight|ellipse|quad|background)\("
)
# Lines of YAML, and of a scene of Godot.
_KEY = re.compile(r"([ \t]*)[A-Za-z_]\w*[ \t]*:(?=\s)")
_SECTION = re.compile(r"\[(node|sub_resource)\b")
_MODE = re.compile(r"\b(rect|ellipse)Mode\(\s*(\w+)\s*\)")
# Names such as x1, rect_w, ballRadius and bx: whose number it is, and which.
_LETTERS = "x|y|w|h|r|cx|cy|width|height|radius|diameter"
_NUMBERED = re.compile(rf"(?P<key>{_LETTERS}|left|top|right|bottom)_?(?P<owner>\d+|[a-dA-D])")
_PREFIXED = re.compile(rf"(?P<owner>\w+?)(?:_(?P<key>{_LETTERS})|(?P<camel>X|Y|W|H|R|Width|Height|Radius|Diameter))")
_CORNER = re.compile(r"(?P<name>(?:v|p|pt|point|vertex|vert|corner)?)[ _]?(?P<number>\d{1,4})", re.IGNORECASE)
_ROUND = re.compile(r"circle|ellips|ball|dis[ck]s?\b|box|rect|center|centre", re.IGNORECASE)
# names of the results of a test
RESULTS = frozenset(
    ["contact", "contacts", "manifold", "intersection", "overlap", "axes", "axis", "simplex", "normals", "minkowski"]
)
TYPES = frozenset(["float", "double", "number", "int", "integer", "f32", "f64"])
# words before corners in a sentence
BEFORE_POINTS = frozenset(["at", "with", "through", "by", "is", "are", "has", "from", "to", "on", "of", "in"])
_LETTERED = re.compile(r"(?P<owner>[a-dA-DpPqQ])(?P<key>[xywhr])")


class Run(NamedTuple):
    """A shape whose numbers have names of their own; none if a shape uses one of these names."""

    value: Obj
    label: str


class Statements(Names):
    """Sorts the lines of a text: variables with their fields, and what stands alone.

    `text`: all of it, which is searched here for modes such as rectMode(CENTER); its lines come parsed, by `assign`.
    """

    def __init__(self, text: str) -> None:
        super().__init__(text)
        self.runs: list[Run] = []
        self.taken: set[int] = set()  # values that a run has
        # ("rect" or "ellipse", place in the text, mode) of each call such as rectMode(CENTER)
        self.modes = [(m[1], m.start(), m[2].lower()) for m in _MODE.finditer(text)]
        self._open: dict[str, Obj] = {}  # runs that may go on
        self._in_row = False  # within pairs on one line, of which some may belong to no shape: x=0 y=0 vx=1 r=5
        self._grown: set[int] = set()  # lists to which corners were added
        self._pen: Group | None = None
        self._corners: Obj | None = None  # a numbered list that may go on
        self._next, self._named = 0, ""
        self.sketch = bool(_SKETCH.search(text))  # whether the text is a sketch of Processing or p5.js
        self._draws = "lineto" in text.lower()  # a moveTo moves a pen, not a body

    def assign(self, items: Sequence[Any]) -> None:
        """Sort the lines of a text or block: what gets a name, and what stands alone."""
        column: list[Group] = []
        for item in (*self._gathered(items), None):
            if _is_nameless_point(item) and item.bracket != '"':
                column.append(item)
                continue
            if len(column) > 2:
                self.loose.append(Group(column[0].start, column[-1].end, list(column), "lines"))
            else:
                self.loose += [row for row in column if len(row.items) != 2]
            column = []
            if item is None or not isinstance(item, Pair):
                self._end_run("")
                self._end_corners()
            self._line(item)
        for owner in list(self._open):
            self._end_run(owner)
        self._end_pen()
        self._end_corners()

    def _gathered(self, items: Sequence[Any]) -> Iterator[Any]:
        """Yield lines; the lines of a list of points, of a block of YAML and of a section of Godot become one."""
        resources: dict[str, Group] = {}
        places: dict[str, Pair] = {}  # of nodes at the top
        i = 0
        while i < len(items):
            item, i = items[i], i + 1
            if isinstance(item, Pair) and _is_nameless_point(item.value) and self._holds_points(item):
                rows = [item.value]  # points: and the lines - [2, -1] of YAML
                while i < len(items) and _is_nameless_point(items[i]):
                    rows.append(items[i])
                    i += 1
                if len(rows) > 1:
                    made = Group(rows[0].start, rows[-1].end, rows, "[")
                    item = replace(item, value=made, end=made.end)
            elif isinstance(item, Pair) and isinstance(item.value, Pair) and (depth := self._indent(item.value)):
                rows, kind = [item.value], str(item.path[-1])
                while (
                    self._indent(item) < depth
                    and i < len(items)
                    and (self._indent(items[i]) >= depth or _is_nameless_point(items[i]))
                ):
                    rows.append(items[i])
                    i += 1
                name = kind if kind.lower().endswith("collider2d") else ""  # of Unity
                if len(rows) > 1 or name:
                    made = Group(item.start, rows[-1].end, list(self._gathered(rows)), "{", name)
                    item = replace(item, value=made, end=made.end)
            elif isinstance(item, Group) and (head := _SECTION.match(self.text, item.start)):
                says = {pair.path[0]: pair.value for pair in item.items if isinstance(pair, Pair)}
                rows, kind = [], self._said(says.get("type"))
                while i < len(items) and isinstance(items[i], Pair):
                    radians = items[i].path == ("rotation",)
                    rows.append(replace(items[i], path=("radians",)) if radians else items[i])
                    i += 1
                for row in rows:
                    if row.path == ("shape",) and isinstance(row.value, Group) and row.value.items:
                        used = resources.get(self._said(row.value.items[0]))
                        if used is not None:  # shape = SubResource("1")
                            self.used.add(id(used))
                            self.parts.append((row.value.start, row.value.end))
                            rows, kind = [*used.items, *(each for each in rows if each is not row)], used.name
                made = Group(item.start, rows[-1].end if rows else item.end, rows, "{", kind)
                parent = self._said(says.get("parent"))
                if parent in ("", "."):
                    places |= {self._said(says.get("name")): row for row in rows if row.path == ("position",)}
                elif parent in places:
                    made.items.append(replace(places[parent], path=("offset",)))
                if head[1] == "sub_resource":
                    resources[self._said(says.get("id"))] = made
                self.parts.append((item.start, item.end))
                item = Pair(made.start, made.end, (self._said(says.get("name")) or kind,), made)
            yield item

    def _holds_points(self, pair: Pair) -> bool:
        """Return whether a key holds corners by its name, or begins a list of YAML, with `-` on the line below."""
        before = self.text[pair.start : pair.value.start].rstrip(" \t")
        return _is_points(pair.path[-1]) or (before.endswith("-") and before[:-1].rstrip(" \t").endswith("\n"))

    def _said(self, value: Any) -> str:
        """Return the text of a value in quotes, or of a number."""
        return self.text[value.start : value.end].strip("\"'") if isinstance(value, Value) else ""

    def _indent(self, item: Any) -> int:
        """Return the indentation of a line `key: value`, or -1 for any other line."""
        begin = self.text.rfind("\n", 0, item.start) + 1 if isinstance(item, Pair) else -1
        found = _KEY.match(self.text, begin) if begin >= 0 else None
        return len(found[1]) if found and found.end(1) == item.start else -1

    def _line(self, item: Any) -> None:
        """Carry out one parsed line: set a name, add corners or a shape, or keep the line in `loose`."""
        held = item.value if isinstance(item, Pair) else None
        if isinstance(item, Pair) and isinstance(item.value, Pair):  # a heading over the lines of an object: a:
            self._end_run("")
            self._line(item.value)
        elif isinstance(item, Pair):
            ours = item.path[0] in ("this", "self")
            if isinstance(held, Name) and ((ours and item.path[-1] == held.text) or held.text.lower() in TYPES):
                return  # this.x = x, and x: float
            plain = isinstance(held, Group) and (not held.name or notation(held.name))
            if plain and words(f"{item.before} {item.path[-1]}") & RESULTS:
                return  # contact points: (5, 0), (5, 2)
            if isinstance(held, Group) and (points := self._points_behind_words(held)):
                item = replace(item, value=points)
            self._insert(item)
            self._number(item)
            self._go_on(item)
        elif isinstance(item, Bad):
            for inner in item.inside:
                self._line(inner)
        elif isinstance(item, Group):
            declared = notation(item.before) if item.before else None
            if (is_pair(item) and key(item.name) == "center") or item.name in BEFORE_POINTS:
                declared = None  # rectangle position (10, 10), a shape is [(0, 0), (4, 0), (0, 3)]
            if declared and (
                declared.kind in (Kind.BOX, Kind.CIRCLE, Kind.OTHER_SHAPE) or not notation(item.name)
            ):  # Circle c(0, 0, 1)
                made = replace(item, name=item.before, before="")
                self._insert(Pair(item.start, item.end, tuple(parts_of(item.name)), made))
            elif item.bracket == "{" and not item.name and is_block(item):
                self.assign(item.items)
            elif item.bracket in (",", "+") and item.items and all(isinstance(v, Pair) for v in item.items):
                self._end_run("")  # x = 0, y = 0, r = 5
                self._in_row = True
                for inner in item.items:
                    self._line(inner)
                self._in_row = False
                self._end_run("")
            elif points := self._points_behind_words(item):
                self.loose.append(points)
            elif item.bracket == "," and any(isinstance(v, (Pair, Bad)) for v in item.items):
                kind = next((v.before for v in getattr(item.items[0], "inside", ()) if isinstance(v, Group)), "")
                for inner in item.items:
                    if kind and isinstance(inner, Group) and not notation(inner.name):
                        inner = replace(inner, before=kind)  # Rect a(0, 0, 4, 4), b(1, 1, 4, 4)
                    self._line(inner)
            elif not self._statement(item):
                if not item.name and item.bracket in (" ", ",") and len(item.items) == 5 and holds_numbers(item):
                    part = short(self.text[item.start : item.end])
                    why = (
                        "five numbers can be a box and its angle, or a label and a box: write the four of the box alone"
                    )
                    self.problems.append(f"{part}: {why}")
                else:
                    self.loose.append(item)

    def _points_behind_words(self, row: Group) -> Group | None:
        """Return the corners of a row that begins with words: Polygon 1 has the points (0, 0), (4, 0), (0, 3)."""
        first, *rest = row.items if row.bracket == "," and row.items else (None,)
        if not isinstance(first, Bad) or first.why != "words" or not first.inside:
            return None
        *labels, point = first.inside
        if not isinstance(point, Group) or _ROUND.search(self.text, first.start, point.start):
            return None  # three circles at (0, 0), (4, 0), (0, 3)
        named = key(point.name) == "points" or point.name in BEFORE_POINTS
        points = [replace(point, name="") if named else point, *rest]
        outline = len(points) > 2 and all(map(_is_nameless_point, points)) and all(isinstance(v, Num) for v in labels)
        return Group(point.start, points[-1].end, points, "[") if outline else None

    def _statement(self, item: Group) -> bool:
        """Apply a call that changes a named value (a.setPosition(1, 2)) or draws with a pen; False for others."""
        names = parts_of(item.name)
        last, owner = names[-1].lower(), tuple(names[:-1])
        if last in NUMBERED and owner and len(item.items) == 2 and isinstance(item.items[0], Num):
            index, point = item.items  # shape.setPoint(0, Vector2f(1, 2))
            self.counts.add(index.end)
            self._insert(Pair(item.start, item.end, (*owner, int(index.value or 0)), point))
        elif item.bracket == "[" and item.name and len(item.methods) == 1 and item.methods[0][0].lower() in SETTERS:
            index = item.items[0] if item.items else None
            number = int(index.value or 0) if isinstance(index, Num) else 0
            self.counts |= {index.end} if isinstance(index, Num) else set()
            self._insert(Pair(item.start, item.end, (*item.name.split("."), number), item.methods[0][1]))
        elif owner and (made := self._maker(owner, item)):
            old = self.resolve(Name(item.start, item.end, ".".join(owner)))
            if isinstance(old, Group):  # r.setRect(0, 0, 4, 4) replaces what r was
                self.used.add(id(old))
                self.parts.append((old.start, old.end))
                self.remark(f"of {'.'.join(owner)} the last numbers were taken, those of {item.name}")
            self._insert(Pair(item.start, item.end, owner, replace(item, name=made)))
        elif last in SETTERS and owner and len(item.items) == 2:  # circle.m_p.Set(1, 2)
            self._insert(Pair(item.start, item.end, owner, replace(item, name="")))
        elif (
            last in (*MOVES, *SHIFTS, *TURNS) and owner and len(item.items) in (1, 2) and not self._is_drawn(last, item)
        ):
            moves = last in MOVES or last in SHIFTS
            value = item if moves and len(item.items) == 2 else item.items[0]
            value = Group(item.start, item.end, item.items, "(") if value is item else value
            turns = "turn" if last.startswith("rotate") else "angle"
            field = "translation" if last in SHIFTS else "position" if moves else turns
            self._insert(Pair(item.start, item.end, (*owner, field), value))
        elif last in ADDERS and owner and (point := _point_of(item)) and not self._are_things(point):
            self._add(owner, point)
        elif last in PENS or last in PEN_STARTS:
            if last in PEN_STARTS:
                self._end_pen()
            if last in PENS and (point := _point_of(item)):
                self._pen = self._pen or Group(item.start, item.end, [], "[")
                self._pen.items.append(point)
                self._pen.end = item.end
        else:
            return False
        return True

    def _maker(self, owner: tuple[str, ...], call: Group) -> str:
        """Return the name of the call by which the numbers of this call are read; "" if it gives a shape no numbers.

        a.box.set(0, 0, 4, 4) is read as the call that made the box of a, with `owner` ("a", "box"); a call such as
        setFromPoints says itself what it takes.
        """
        last = parts_of(call.name)[-1].lower()
        two = len(call.items) == 2 and all(isinstance(v, Group) for v in call.items)  # box.set(min, max)
        if last in MAKERS or last not in RESETS or not (len(call.items) > 2 or two):
            return last if last in MAKERS else ""
        old = self.resolve(Name(call.start, call.end, ".".join(owner)))
        row = notation(old.name) if isinstance(old, Group) else None
        made = old.name if row and row.kind in (Kind.BOX, Kind.CIRCLE) else ""
        return made or (call.name if isinstance(old, Name) and len(owner) == 1 and notation(call.name) else "")

    def _are_things(self, point: Group) -> bool:
        """Return whether both items are names of what has been made before, as in space.add(body, shape)."""
        return all(isinstance(v, Name) and not isinstance(self.resolve(v), (Name, Num)) for v in point.items)

    def _is_drawn(self, last: str, call: Group) -> bool:
        """Return whether a call moves a pen, or the shape named first in it: Body.setPosition(a, {x: 1, y: 2})."""
        return (last == "moveto" and self._draws) or (len(call.items) > 1 and isinstance(call.items[0], Name))

    def _add(self, path: tuple[str, ...], point: Group) -> None:
        """Add a corner to the list of this name."""
        parent: Any = self.env
        for part in path[:-1]:
            parent = parent.fields.get(part) if isinstance(parent, Obj) else None
        node = parent.fields.get(path[-1]) if isinstance(parent, Obj) else None
        if isinstance(node, Group):
            if id(node) not in self._grown:  # the tree is read more than once, so its own list stays as it is
                capacity = len(node.items) == 1 and isinstance(node.items[0], Num)
                node = parent.fields[path[-1]] = replace(node, items=[] if capacity else list(node.items))
                self._grown.add(id(node))
            node.items.append(point)
            node.end = max(node.end, point.end)
        else:
            made = Group(point.start, point.end, [point], "[")
            self._grown.add(id(made))
            self._insert(Pair(point.start, point.end, path, made))

    def _end_pen(self) -> None:
        """End the outline that a pen draws; it becomes a shape if it has more than two corners."""
        if self._pen is not None and len(self._pen.items) > 2:
            self.loose.append(self._pen)
        self._pen = None

    # -- corners and numbers with names of their own

    def _number(self, pair: Pair) -> None:
        """Take a corner of a numbered list: v0: 0 0, Vertex 1: (4, 0), 2: {x: 0, y: 3}."""
        found = _CORNER.fullmatch(f"{pair.path[0]}{pair.number}") if len(pair.path) == 1 else None
        if found is None or not _is_point(pair.value):
            self._end_corners()
            return
        number = int(found["number"])
        if self._corners is None or number != self._next or found["name"] != self._named:
            self._end_corners()
            self._corners = Obj(pair.start, pair.end)
        self._corners.fields[number] = pair.value
        self._corners.end = pair.end
        self._next, self._named = number + 1, found["name"]

    def _end_corners(self) -> None:
        """End the numbered list of corners; it becomes a shape if it has more than two."""
        if self._corners is not None and len(self._corners.fields) > 2:
            self.runs.append(Run(self._corners, ""))
        self._corners = None

    def _go_on(self, pair: Pair) -> None:
        """Add a variable to the shape to which its name belongs: x1 = 0; y1 = 0; r1 = 5 is one circle."""
        name = str(pair.path[0]) if len(pair.path) == 1 else ""
        owner, meaning = owner_of(name) if name else ("", "")
        if not meaning:
            if not self._in_row:
                self._end_run("")
            return
        if owner and not isinstance(pair.value, Num):
            return
        if isinstance(pair.value, Group) and getattr(notation(pair.value.name), "kind", Kind.POINT) not in (
            Kind.POINT,
            Kind.RING,
        ):
            return  # r = new Rectangle(0, 0, 4, 4)
        run = self._open.get(owner)
        if run is not None and meaning in {key(k) for k in run.fields}:
            self._end_run(owner)
            run = None
        if run is None:
            run = self._open[owner] = Obj(pair.start, pair.end)
        run.fields[name if not owner else meaning] = pair.value
        run.end = pair.end

    def _end_run(self, owner: str) -> None:
        """End the run of numbers that `owner` has collected; with all numbers of a shape it becomes a shape."""
        run = self._open.pop(owner, None)
        if run is None:
            return
        has = {key(name) for name in run.fields}
        sized = bool(has & {"size", "half"}) or {"width", "height"} <= has or {"halfwidth", "halfheight"} <= has
        placed = {"x", "y"} <= has or "center" in has or {"x0", "y0"} <= has
        round_ = "radius" in has or "diameter" in has
        corners = {"x0", "y0", "x1", "y1"} <= has or {"corner", "opposite"} <= has or {"min", "max"} <= has
        outline = "points" in has and bool(has & {"center", "angle", "degrees", "radians", "offset"}) and not round_
        if (placed and (sized or round_)) or corners or outline:
            self.runs.append(Run(run, "" if owner.isdigit() else owner))
            self.taken |= {id(value) for value in run.fields.values() if not isinstance(value, Num)}


def owner_of(name: str) -> tuple[str, str]:
    """Return whose number a name holds, and its meaning: ("1", "x") of x1, ("", "x") of x; ("", "") of other names."""
    if meaning := key(name):
        return "", meaning
    for pattern in (_NUMBERED, _PREFIXED, _LETTERED):
        if found := pattern.fullmatch(name):
            parts = found.groupdict()
            return parts["owner"], key(parts["key"] or parts["camel"])
    return "", ""


def _is_points(name: str | int) -> bool:
    """Return whether a key holds corners: points, and m_Points and m_Paths of Unity."""
    return key(name) == "points" or str(name).lower() in ("m_points", "m_paths")


def _is_nameless_point(value: Any) -> bool:
    """Return whether a value is a point without a name before its bracket: (1, 2) or {x: 1, y: 2}."""
    return isinstance(value, Group) and not value.name and _is_point(value)


def _point_of(call: Group) -> Group | None:
    """Return the point that a call gets: two numbers, or one bracket or point with two numbers."""
    (inner,) = call.items if len(call.items) == 1 else (None,)
    if isinstance(inner, Group):
        row = notation(inner.name) if inner.name else None
        if inner.name and not (row and row.kind == Kind.POINT):
            return None
        return inner if len(inner.items) in (2, 3) and holds_numbers(inner) else None
    pair = len(call.items) == 2 and all(not isinstance(v, (Group, Pair)) for v in call.items)
    return Group(call.start, call.end, call.items, "(") if pair else None


def _is_point(value: Any) -> bool:
    """Return whether a value is a point, with a name or without: two numbers, or x and y."""
    if not isinstance(value, Group):
        return False
    pairs = (v for v in value.items if isinstance(v, Pair) and len(v.path) == 1 and isinstance(v.value, (Num, Name)))
    return (len(value.items) == 2 and holds_numbers(value)) or {key(pair.path[0]) for pair in pairs} - {""} == {
        "x",
        "y",
    }
