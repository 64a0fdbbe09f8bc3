"""Values of a text as shapes, by the table of notations."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

from .boxes import (
    ABSOLUTE,
    BOX_FORM,
    CHOICES,
    CORNERS,
    Boxes,
    Read,
    moved,
    origin_of,
    unit_of,
)
from .names import Obj, Unreadable, is_block, short
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
    ELLIPSE,
    HARMLESS,
    MANY,
    MOVE,
    MOVES,
    POINT,
    RADIANS,
    RING,
    TURNS,
    Notation,
    key,
    notation,
)
from .points import ZERO, Pt, places
from .tree import Bad, Group, Name, Num, Pair, Value


class Reader(Boxes):
    """Reads a tree once, with the readings that were chosen; `problems` says what could not be read."""

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
            part = short(self.text[value.start : value.end]) if isinstance(value, Value) else ""
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
                        (((x0 + x1) / 2, y),),
                        abs(x1 - x0) / 2,
                        "a circle by two points",
                        group.start,
                        group.end,
                        label,
                        used=places(*(c for p in ring for c in p)),
                    )
                ]
            raise Unreadable("an outline with arcs: satviz takes polygons and circles")
        if kind == CIRCLE:
            found = self._circle(group, label)
        elif kind == ELLIPSE:
            found = self._ellipse(group, label)
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
            if plain in HARMLESS and any(isinstance(v, Group) for v in arguments.items):
                found = [*found, *self._each(arguments.items, "")]  # a.intersects(b)
                continue
            if plain in MOVES and len(arguments.items) in (1, 2):
                move = self.point(arguments) or self.point(arguments.items[0])
                if move:
                    found = [moved(shape, move) for shape in found]
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
        used = places(*(c for p in points for c in p), *shift)
        return Read(moved, None, said, value.start, value.end, label, shift=shift, used=used)

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
        given: frozenset[int] = frozenset()
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
            given, place = places(*place), (place[0] - cx, place[1] - cy)  # Matter puts the center of mass there
        self.consume(taken)
        if any(not key(name) and self.point(value) is not None for name, value in named.fields.items()):
            raise Unreadable("a list of corners has something else in it")
        beside = sum(self._is_number(a) for a in arguments)
        if beside and not (outline is not None and self.numbers(arguments)) and beside != count_of_position:
            self.remark("numbers beside a list of corners were left out")
        shift = place or ZERO
        made = self._outline(outline, group, label, shift, " and a position" if shift != ZERO else "")
        made = replace(made, used=made.used | given)
        return [self._turned(made, angle, unit_of(named), shift)] if angle is not None else [made]

    def _options(self, arguments: Sequence[Any]) -> Obj | None:
        """Return the only argument of a call as an object, if it is one with keys: new Circle({radius: 1})."""
        value = self.resolve(arguments[0]) if len(arguments) == 1 else None
        if not isinstance(value, Group) or value.name or not any(isinstance(v, Pair) for v in value.items):
            return None
        made = self.as_object(value)
        return made if made.get("radius", "diameter", "width", "size", "half", "halfwidth", "min", "x1") else None

    def _circle(self, group: Group, label: str) -> list[Read]:
        """Return the circle of a call: (center, radius), (x, y, radius), or (radius) where a position is given."""
        arguments, named = self._arguments(group)
        arguments, place, _ = self._body(arguments)
        only = self._options(arguments)
        if only or (named.fields and named.get("radius", "diameter") is not None and not arguments):
            return self._object(replace(only or named, start=group.start, end=group.end), label, notation(group.name))
        if not arguments:
            return []
        found = (self.point(a, origin=True) for a in arguments if isinstance(self.resolve(a), (Group, Obj)))
        points = [p for p in found if p]
        flat = self.numbers([a for a in arguments if not isinstance(self.resolve(a), (Group, Obj))]) or []
        if not points and len(flat) >= 3:
            points, flat = [(flat[0], flat[1])], flat[2:]
        if not flat and named.get("radius") is not None:
            flat = [self.number(named.get("radius"))]
        if not flat:
            raise Unreadable("a circle without a radius")
        x, y = points[0] if points else ZERO
        said = "a circle by its center and radius" if points or place else "a circle by its radius, at the origin"
        row = notation(group.name)
        if row and row.alone and len(flat) == 1 and not points and not place:  # SFML's: the corner of its box is there
            x, y, said = flat[0], flat[0], "a circle by its radius, with its box at the origin"
        used = places(x, y, *(place or ()), flat[0])
        x, y = (x + place[0], y + place[1]) if place else (x, y)
        return [Read(((x, y),), flat[0], said, group.start, group.end, label, used=used)]

    def _box(self, group: Group, row: Notation, label: str) -> list[Read]:
        """Return the box of a call, in the form of its row or as it is asked."""
        arguments, named = self._arguments(group)
        arguments, place, angle = self._body(arguments)
        if angle is None:
            angle = named.get("angle", "degrees", "radians")
        if only := self._options(arguments):
            return self._object(replace(only, start=group.start, end=group.end), label, row)
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
            form = form if form in (CENTER_SIZE, CENTER_HALF) or row.alone else CENTER_SIZE
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
        return [moved(made, place) if place else made]

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
        angle, unit = obj.get("angle", "degrees", "radians"), unit_of(obj)
        center = obj.get("center", "corner")
        place = None if center is None else self.point(center)
        if place is None and obj.get("x") is not None and obj.get("y") is not None:
            place = (self.number(obj.get("x")), self.number(obj.get("y")))
        if place is None:
            rest = () if any(isinstance(k, int) for k in obj.fields) else obj.rest
            place = next((p for p in (self.point(v) for v in rest if isinstance(v, (Group, Obj))) if p), None)
        if row is None:  # var s = RectangleShape2D.new(), and its fields
            made_by = (notation(v.name) for v in obj.rest if isinstance(v, Group) and v.name and not v.items)
            row = next((found for found in made_by if found), None)
        offset = self.point(obj.get("offset")) if obj.get("offset") is not None else None
        if offset is not None and angle is not None and self.number(angle):
            raise Unreadable("an offset and an angle in one shape: write the corners that result")
        points = obj.get("points")
        outline = self.ring(points) if points is not None else None
        if outline is None and any(isinstance(k, int) for k in obj.fields):
            outline = self.ring(obj)
        if outline is not None and len(outline) > 2:
            shift, given = place or ZERO, places(*(place or ()))
            if shift != ZERO and self._choose(CORNERS, CHOICES[CORNERS]) == ABSOLUTE:
                shift = ZERO
            made = self._outline(outline, obj, label, shift, " and a position" if shift != ZERO else "")
            made = replace(made, used=made.used | given)
            made = self._turned(made, angle, unit, shift) if angle is not None else made
            return [moved(made, offset) if offset else made]
        radius = obj.get("radius", "diameter")
        sides = all(side in {str(k).lower() for k in obj.fields} for side in "ltrb")
        if radius is not None and isinstance(self.resolve(radius), (Num, Bad)) and not sides:
            made = self._circle_of_keys(obj, place, label, row)
            return [moved(made, offset) if offset else made]
        if four := self._box_of_keys(obj, place, center, row):
            made = replace(self._made_box(*four, obj, label, angle, unit), keyed=True)
            return [moved(made, offset) if offset else made]
        if obj.rest and (place is not None or angle is not None):
            found = [s for v in obj.rest for s in self.shapes(v, label)]
            found = [moved(s, place) if place and self.point(obj.get("center")) else s for s in found]
            return [self._turned(s, angle, unit, place) if angle is not None else s for s in found]
        inner = [s for v in obj.rest for s in self.shapes(v, label)]
        for name, value in obj.fields.items():
            if not (isinstance(kind, Name) and name in ("bbox", "properties")):
                wrapper = isinstance(name, int) or name in ("geometry", "features", "geometries", "shape")
                inner += self.shapes(value, label if wrapper else str(name).split(" (")[0])
        return inner

    def _circle_of_keys(self, obj: Obj, place: Pt | None, label: str, row: Notation | None) -> Read:
        """Return the circle of an object with a radius or a diameter, and a center or its left and top sides."""
        given = obj.get("radius")
        size = self.number(given if given is not None else obj.get("diameter"))
        used = places(*(place or ()), size)
        radius = size if given is not None else size / 2
        keys = {str(k).lower(): v for k, v in obj.fields.items()}
        said = "a circle by its center and radius" if place else "a circle by its radius, at the origin"
        if place is None and "left" in keys and "top" in keys:
            place = self.number(keys["left"]), self.number(keys["top"])
            used |= places(*place)
            origins = origin_of(obj, "originx", "left"), origin_of(obj, "originy", "top")
            if origins == ("left", "top"):
                place, said = (
                    (place[0] + radius, place[1] + radius),
                    "a circle by its left and top sides and a position",
                )
            elif origins != ("center", "center"):
                raise Unreadable("an origin that is neither the corner nor the center: write the center")
        if given is None:
            said = said.replace("radius", "diameter")
        return Read((place or ZERO,), radius, said, obj.start, obj.end, label, used=used)

    def _ellipse(self, group: Group, label: str) -> list[Read]:
        """Return the circle of an ellipse with equal axes: (x, y, width, height); Unreadable for any other."""
        flat = self.numbers(group.items) or []
        if len(flat) not in (3, 4) or flat[2] != flat[-1]:
            raise Unreadable("an ellipse: satviz takes polygons and circles")
        said = "a circle by its center and diameter"
        used = places(*flat)
        return [Read(((flat[0], flat[1]),), flat[2] / 2, said, group.start, group.end, label, used=used)]

    def _plain(self, group: Group, label: str) -> list[Read]:
        """Return the shapes of a bracket that no name explains."""
        if any(isinstance(item, Pair) for item in group.items):
            if is_block(group):
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
                said, used = "a circle by its center and radius", places(*center, radius)
                return [Read((center,), radius, said, group.start, group.end, label, used=used)]
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
                yield moved(turned, move) if move else turned
                move, angle = None, None


def _begins_with_numbers(items: Sequence[Any]) -> bool:
    """Return whether a call's arguments begin with two numbers, as a box's do."""
    return len(items) > 1 and all(isinstance(item, Num) for item in items[:2])


def _is_call(group: Group) -> bool:
    """Return whether a group is a call or a list with a type before it."""
    return bool(group.name)


def _label(item: Any) -> str:
    """Return the name that a pair gives to its value."""
    return str(item.path[0]) if isinstance(item, Pair) else ""


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
