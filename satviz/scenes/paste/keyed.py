"""Shapes that an object describes by its keys: a center, a radius, a size, corners, an offset, an angle."""

from dataclasses import replace
from typing import Any

from .axis_lists import is_flat, joined, lengths, pairs_of_lists
from .boxes import AT_ORIGIN, BY_RADIUS, CHOICES, Boxes, Read, circle, moved, origin_of, unit_of
from .exact import centroid
from .names import Obj, Unreadable
from .notations import Ask, Form, Kind, Notation, key, notation
from .points import ZERO, Numeral, Pt, places
from .tree import Bad, Group, Name, Num

BODY_SHAPES = frozenset(["shapes", "fixtures", "colliders", "fixturelist"])  # relative to their body


class Keyed(Boxes):
    """Reads objects with keys."""

    def shapes(self, value: Any, label: str = "") -> list[Read]:
        """Return the shapes in a value."""
        raise NotImplementedError

    def _rings(self, value: Any, label: str) -> list[Read]:
        """Return the polygon of an outer ring and its holes."""
        raise NotImplementedError

    def _object(self, obj: Obj, label: str, row: Notation | None = None) -> list[Read]:
        """Return the shape that an object describes by its keys, or else the shapes in its fields."""
        kind = obj.fields.get("type")
        if obj.twice and key(obj.twice):
            raise Unreadable(f"the key {obj.twice} is given twice: keep one of them")
        if (typed := self._typed(obj, label)) is not None:
            return typed
        angle, unit = obj.get("angle", "degrees", "radians"), unit_of(obj)
        center = obj.get("center", "corner")
        if isinstance(self.resolve(center), Name) and obj.get("x0") is not None:
            center = None  # position: absolute
        place = None if center is None else self.vector(center)
        if isinstance(center, Bad):
            self.number(center)  # says that it is not evaluated
        many = sum(is_flat(self.resolve(obj.get(name))) for name in "xy")  # lists of coordinates
        if place is None and not many and obj.get("x") is not None and obj.get("y") is not None:
            place = (self.number(obj.get("x")), self.number(obj.get("y")))
        if place is None:
            rest = () if any(isinstance(k, int) for k in obj.fields) else obj.rest
            place = next((p for p in (self.point(v) for v in rest if isinstance(v, (Group, Obj))) if p), None)
        if row is None:  # var s = RectangleShape2D.new(), and its fields
            made_by = (notation(v.name) for v in obj.rest if isinstance(v, Group) and v.name and not v.items)
            row = next((found for found in made_by if found), None)
        offset = self.point(obj.get("offset")) if obj.get("offset") is not None else None
        if offset is not None and angle is not None and self.number(angle):
            raise Unreadable("a shape with an offset and an angle is not read: write its corners")
        points = obj.get("points")
        outline = self.ring(points) if points is not None else None
        if outline is None and any(isinstance(k, int) for k in obj.fields):
            outline = self.ring(obj)
        if outline is None and (lists := list(pairs_of_lists(obj.fields))):
            joint = joined(*lists[0][1:])
            if joint is None or len(lists) > 1:
                raise Unreadable(lengths(*lists[0][1:]))
            outline = self.ring(joint)
        if outline is not None and len(outline) > 2:
            made = self._outline_of_keys(obj, outline, place, label, row)
            return [moved(made, offset) if offset else made]
        radius = obj.get("radius", "diameter")
        sides = all(side in {str(k).lower() for k in obj.fields} for side in "ltrb")
        if radius is not None and isinstance(self.resolve(radius), (Num, Bad)) and not sides:
            if place is None and isinstance(self.resolve(center), Group):
                raise Unreadable("the center of a circle is not a point: write it as (x, y)")
            made = self._circle_of_keys(obj, place, label, row)
            if angle is not None and place is not None and self._is_number(angle):
                made = replace(made, used=made.used | places(self.number(angle)))  # a circle stays as it is
            return [moved(made, offset) if offset else made]
        if four := self._box_of_keys(obj, place, center, row):
            made = replace(self._made_box(*four, obj, label, angle, unit), keyed=True, named=True)
            if not any(isinstance(number, Numeral) for number in four[0][:2]):
                made = replace(made, said=f"{made.said}{AT_ORIGIN}")
            return [moved(made, offset) if offset else made]
        if obj.rest and (place is not None or angle is not None):
            self.consume(obj.rest)
            found = [s for v in obj.rest for s in self.shapes(v, label)]
            ordered = any(s.shift != ZERO or "translation" in obj.fields for s in found if not (s.form or s.is_circle))
            turn = self.resolve(angle)
            if ordered and place and isinstance(turn, Num) and (turn.turn or turn.value):
                raise Unreadable("a move and a turn of one shape: write the corners that result")
            found = [_placed(s, obj, place) if place else s for s in found]
            rotates = "turn" in obj.fields
            at = [None if angle is None else self.pivot(s, place, rotates=rotates) for s in found]
            return [s if p is None else self._turned(s, angle, unit, p) for s, p in zip(found, at, strict=True)]
        inner = [s for v in obj.rest if not isinstance(v, Name) for s in self.shapes(v, label)]
        for name, value in obj.fields.items():
            hole = inner and str(name).lower() in ("holes", "interiors")
            aside = name in ("bbox", "properties") and (isinstance(kind, Name) or "segmentation" in obj.fields)
            if not hole and not aside:
                wrapper = isinstance(name, int) or name in ("geometry", "features", "geometries", "shape")
                held = str(name).lower() in BODY_SHAPES
                found = self.shapes(value, label if wrapper or held else str(name).split(" (")[0])
                if held and place is not None:  # the body's position and angle are those of its shapes
                    found = [self._turned(s, angle, unit, None) if angle is not None else s for s in found]
                    found = [moved(s, place) for s in found]
                inner += found
        return inner

    def _outline_of_keys(self, obj: Obj, outline: list[Pt], place: Pt | None, label: str, row: Notation | None) -> Read:
        """Return the polygon of an object with corners, a position and an angle.

        The corners may already include the position and the angle; if that is not certain, it becomes a question.
        """
        shift, used = place or ZERO, places(*(place or ()))
        angle = obj.get("angle", "degrees", "radians")
        turns = angle is not None and self._turns(angle)
        if shift != ZERO or (place and turns):
            names = {str(name).lower() for name in obj.fields if key(name) in ("center", "corner", "x")}
            middle, size = centroid(outline), max(abs(c - outline[0][k]) for p in outline for k, c in enumerate(p))
            there = shift != ZERO and all(
                abs(c - p) * 1000 < size for c, p in zip(middle, shift, strict=True)
            )  # as Matter prints them
            sure = Form.ABSOLUTE if there or names == {"centroid"} else ""
            sure = Form.RELATIVE if row and row.kind == Kind.RING else sure
            corners = self._choose(
                Ask.CORNERS, CHOICES[Ask.CORNERS] if turns and shift != ZERO else CHOICES[Ask.CORNERS][:2], sure=sure
            )
            turns = turns and corners != Form.ABSOLUTE
            shift = shift if corners == Form.RELATIVE else ZERO
        made = self._outline(outline, obj, label, shift, " and a position" if shift != ZERO else "")
        used |= places(self.number(angle)) if self._is_number(angle) else frozenset()
        made = replace(made, used=made.used | used)
        return self._turned(made, angle, unit_of(obj), place) if turns else made

    def _typed(self, obj: Obj, label: str) -> list[Read] | None:
        """Return the shapes of GeoJSON, of labelme, and of a triangle with the corners a, b and c; None for others."""
        kind, sort = obj.fields.get("type"), obj.fields.get("shape_type")
        if isinstance(kind, Name) and "coordinates" in obj.fields:
            inside = obj.fields["coordinates"]
            if kind.text == "MultiPolygon" and isinstance(inside, Group):
                return [s for each in inside.items for s in self._rings(each, label)]
            return self._rings(inside, label) if kind.text == "Polygon" else []
        if isinstance(sort, Name) and sort.text == "circle":
            raise Unreadable("a circle given by its center and a point on it: write its radius")
        if isinstance(sort, Name) and sort.text == "rectangle" and obj.get("points") is not None:
            two = self.resolve(obj.get("points"))
            ends = [self.point(v) for v in two.items] if isinstance(two, Group) else []
            if len(ends) == 2 and ends[0] and ends[1]:  # opposite corners
                return [self._made_box([*ends[0], *ends[1]], Form.CORNER_CORNER, obj, label)]
        if {"a", "b", "c"} <= set(obj.fields) <= set("abcd") and (corners := self.ring(self._lettered(obj))):
            return [self._outline(corners, obj, label)]
        return None

    def _lettered(self, obj: Obj) -> Group:
        """Return the fields a, b, c as a list of corners: Triangle { a: Vec2(0, 0), ... }."""
        return Group(obj.start, obj.end, [obj.fields[name] for name in sorted(obj.fields, key=str)], "[")

    def _circle_of_keys(self, obj: Obj, place: Pt | None, label: str, row: Notation | None) -> Read:
        """Return the circle of an object with a radius or a diameter, and a center or its left and top sides."""
        if any(str(k).lower() in ("sides", "numpoints", "num_points", "numsides") for k in obj.fields):
            raise Unreadable("a regular polygon given by its radius: write its corners")
        given = obj.get("radius")
        size = self.number(given if given is not None else obj.get("diameter"))
        given_numbers = [*(place or ()), size]
        radius = size if given is not None else size / 2
        keys = {str(k).lower(): v for k, v in obj.fields.items()}
        said = BY_RADIUS if place else f"a circle by its radius{AT_ORIGIN}"
        if place is None and "left" in keys and "top" in keys:
            place = self.number(keys["left"]), self.number(keys["top"])
            given_numbers += place
            origins = origin_of(obj, "originx", "left"), origin_of(obj, "originy", "top")
            if origins == ("left", "top"):
                place, said = (
                    (place[0] + radius, place[1] + radius),
                    "a circle by its left and top sides and a position",
                )
            elif origins != ("center", "center"):
                raise Unreadable("the circle's origin is neither its center nor its box's corner: write the center")
        if given is None:
            said = said.replace("radius", "diameter")
        return circle(place or ZERO, radius, obj, label, said, *given_numbers)


def _placed(shape: Read, obj: Obj, place: Pt) -> Read:
    """Return a shape moved to the place in its fields, a box or circle by center or corner: rect.center = (1, 2)."""
    names = {str(name).lower() for name in obj.fields}
    has_place = (shape.box or shape.is_circle) and not shape.said.endswith(AT_ORIGIN)
    if "translation" in names or not has_place:
        return moved(shape, place) if obj.get("center") is not None else shape
    if obj.get("center", "corner", "x") is None:
        return shape
    xs, ys = zip(*shape.points, strict=True)
    by_center = shape.is_circle or shape.form in (Form.CENTER_SIZE, Form.CENTER_HALF) or names & {"center", "centre"}
    old = ((min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2) if by_center else (min(xs), min(ys))
    made = moved(shape, (place[0] - old[0], place[1] - old[1]))
    return replace(made, used=made.used | places(*place))
