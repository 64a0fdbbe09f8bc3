"""Shapes that a call makes: new Circle(center, radius), Rect(x, y, w, h), Polygon(position, corners)."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

from .axis_lists import are_axes, joined, lengths
from .boxes import AT_ORIGIN, BY_DIAMETER, BY_RADIUS, CHOICES, Read, circle, moved, unit_of
from .exact import centroid, hull
from .keyed import Keyed
from .names import Obj, Unreadable
from .notations import ANY_BOX, CORNER_OR_CENTER, SHAPE_WORDS, Ask, Form, Notation, key, notation
from .points import ZERO, Pt, angle_of, places
from .tree import Bad, Group, Name, Num, Pair, parts_of

_PLACES = {"from": "corner", "to": "bottomright", "point": "corner"}  # of paper.js
FULL_TURNS = frozenset(["2*pi", "pi*2", "2pi", "tau", "two_pi", "360", "6.283185307179586"])


class Calls(Keyed):
    """Reads the calls and typed lists that the table of notations knows."""

    def _plain(self, group: Group, label: str) -> list[Read]:
        """Return the shapes of a bracket that no name explains."""
        raise NotImplementedError

    def _each(self, items: Sequence[Any], label: str) -> Iterator[Read]:
        """Yield the shapes of several values, each by `label` if it has no name of its own."""
        raise NotImplementedError

    def _arguments(self, group: Group) -> tuple[list[Any], Obj]:
        """Return (the arguments of a call that may describe a shape, its named arguments).

        Colors, quoted texts at the end, null, and objects without a size are left out; an angle in such an object
        becomes a named argument.
        """
        named = self.as_object(group)
        kept = []
        if group.name.startswith(("cv2.", "cv::")):  # the points, then a color and a thickness
            color = next((i for i, v in enumerate(named.rest) if isinstance(v, Group) and len(v.items) > 2), None)
            named.rest = named.rest[:color] if color and color > 1 else named.rest
        while len(named.rest) > 1 and self._is_style(named.rest[-1]):
            self.counts.add(named.rest.pop().end)
        for item in named.rest:
            value = self.resolve(item)
            if isinstance(value, (Name, Bad)) and not (isinstance(value, Bad) and value.inside):
                if isinstance(value, Bad) or key(parts_of(value.text)[-1]):
                    kept.append(item)  # player.x, width: a number that is not in the text
                continue  # null, a body, options
            if isinstance(value, Group) and any(isinstance(v, Pair) for v in value.items) and not value.name:
                options = self.as_object(value)
                if options.get("x") is None and not any(isinstance(k, int) for k in options.fields):
                    angle = next((k for k in options.fields if key(k) in ("angle", "degrees", "radians")), None)
                    if angle is not None and _begins_with_numbers(named.rest):
                        named.fields[angle] = options.fields[angle]
                        continue
                    sizes = options.get("points", "radius", "width", "size", "min", "half")
                    if sizes is None and "to" not in options.fields:
                        continue
            kept.append(item)
        named.rest = []
        return kept, named

    def _options(self, arguments: Sequence[Any]) -> Obj | None:
        """Return the only argument of a call as an object, if a key gives a size or a box: Circle({radius: 1})."""
        value = self.resolve(arguments[0]) if len(arguments) == 1 else None
        if not isinstance(value, Group) or value.name or not any(isinstance(v, Pair) for v in value.items):
            return None
        made = self.as_object(value)
        made.fields = {_PLACES.get(str(name), name): v for name, v in made.fields.items()}
        sized = made.get("radius", "diameter", "width", "size", "half", "halfwidth", "min", "x1", "opposite")
        return made if sized else None

    def _body(self, arguments: list[Any]) -> tuple[list[Any], Pt | None, Any]:
        """Return (arguments without a physics body, the body's position, its angle); None for what the body lacks."""
        for i, item in enumerate(arguments):
            value = self.resolve(item)
            if isinstance(value, Obj) and self._xy(value) is None and not any(isinstance(k, int) for k in value.fields):
                place = value.get("center")
                return [*arguments[:i], *arguments[i + 1 :]], place and self.point(place), value.get("angle")
        return arguments, None, None

    def _polygon(self, group: Group, label: str) -> list[Read]:
        """Return the polygon of a call or typed list: corners, or a position and corners."""
        arguments, named = self._arguments(group)
        values = [self.resolve(a) for a in arguments]
        if are_axes(arguments, values, group.name):
            count = values[2] if len(values) > 2 else None
            corners = int(count.value or 0) if isinstance(count, Num) else None
            points = joined(values[0], values[1], corners)
            if points is None:
                raise Unreadable(lengths(values[0], values[1], corners))
            self.consume(arguments)
            made = self._outline(self._points(points.items) or [], group, label)
            return [replace(made, used=made.used | ({count.end} if count else set()))]
        arguments, place, angle = self._body(arguments)
        if named.fields and not arguments:
            node = group.bracket == "{" and group.name.lower().endswith("2d")  # of Unity or Godot
            row = notation(group.name) if node else None
            return self._object(replace(named, start=group.start, end=group.end), label, row)
        angle = angle if angle is not None else named.get("angle", "degrees", "radians")
        place = place or (self.point(named.get("center")) if named.get("center") is not None else None)
        loose = Group(group.start, group.end, arguments, group.bracket, group.name)
        outline = self.ring(loose)
        taken = arguments
        given: frozenset[int] = frozenset()
        if outline is None and len(arguments) > 1:
            first = self.point(arguments[0], origin=True)
            rest = self.ring(arguments[1])
            if first is None and len(arguments) > 2 and self.numbers(arguments[:2]):
                first = self.point(Group(group.start, group.end, arguments[:2], "("))
                rest = self.ring(arguments[2])
            if first is not None and rest is not None:
                place, outline = first, rest
            elif first is None and self.ring(arguments[0]):
                outline = self.ring(arguments[0])
                others = [self.resolve(a) for a in arguments[1:]]
                if any(isinstance(a, Group) and self.ring(a) for a in others):
                    if notation(group.name) and group.name.lower().split("::")[0].split(".")[-1] in ("polygon",):
                        raise Unreadable("a polygon with holes: satviz takes no holes, so write the outer ring alone")
                    outline = None
        rings = (outline, *(self.ring(v) for v in arguments if isinstance(self.resolve(v), Group)))
        if SHAPE_WORDS.search(group.name) and any(ring and len(ring) == 2 for ring in rings):
            raise Unreadable("two corners are a segment and no polygon: write three corners or more")
        if outline is None or len(outline) < 3:
            return self._plain(group, label)
        if place is not None and group.name.lower().endswith("fromvertices"):
            cx, cy = centroid(outline)
            given, place = places(*place), (place[0] - cx, place[1] - cy)  # Matter puts the center of mass there
        self.consume(taken)
        count = len(outline)
        if "hull" in group.name.lower():  # a call that takes points and gives their hull
            given |= places(*(c for p in outline for c in p))
            outline = hull(outline) if len(hull(outline)) < len(set(outline)) else outline
        shift = place or ZERO
        how = f", the convex hull of {count} points" if len(outline) < count else ""
        made = self._outline(outline, group, label, shift, f"{how} and a position" if shift != ZERO else how)
        made = replace(made, used=made.used | given)
        return [self._turned(made, angle, unit_of(named), shift)] if angle is not None else [made]

    def _circle(self, group: Group, label: str) -> list[Read]:
        """Return the circle of a call: (center, radius), (x, y, radius), or (radius) where a position is given."""
        word = group.name.split(".")[-1]
        if word == "arc" and len(group.items) > 4:  # on a canvas, an arc from 0 to a full turn is a circle
            turn = re.sub(r"\s|Math\.|\.0*(?!\d)", "", self.text[group.items[4].start : group.items[4].end]).lower()
            if self.number(group.items[3]) != 0 or turn not in FULL_TURNS:
                raise Unreadable("an arc that is not a full circle: write it as a polygon")
            self.parts.append((group.items[3].start, group.items[4].end))
            group = replace(group, items=group.items[:3])
        arguments, named = self._arguments(group)
        arguments, place, _ = self._body(arguments)
        only = self._options(arguments)
        if only or (named.fields and named.get("radius", "diameter") is not None and not arguments):
            return self._object(replace(only or named, start=group.start, end=group.end), label, notation(group.name))
        if not (self._has_numbers(group) or any(isinstance(self.resolve(a), (Num, Group, Obj)) for a in arguments)):
            return []  # circle(x, y, r), Circle(double x, double y, double r)
        found = (self.point(a, origin=True) for a in arguments if isinstance(self.resolve(a), (Group, Obj)))
        points = [p for p in found if p]
        flat = self.numbers([a for a in arguments if not isinstance(self.resolve(a), (Group, Obj))]) or []
        if not points and len(flat) >= 3:
            points, flat = [(flat[0], flat[1])], flat[2:]
        self._refuse_expressions(arguments)
        if not points and not place and len(flat) == 2 < len(group.items):  # circle(i, 5, 1)
            self.numbers(group.items)
        if not flat and named.get("radius") is not None:
            flat = [self.number(named.get("radius"))]
        if not flat:
            self._refuse_names(arguments)
            raise Unreadable("a circle without a radius: write it after the center")
        x, y = points[0] if points else ZERO
        said = BY_RADIUS if points or place else f"a circle by its radius{AT_ORIGIN}"
        row = notation(group.name)
        if row and row.alone and len(flat) == 1 and not points and not place:  # SFML's: the corner of its box is there
            x, y, said = flat[0], flat[0], f"a circle by its radius{AT_ORIGIN}"
        given = x, y, *(place or ()), flat[0]
        bare = group.name == "circle" and len(group.items) == 3 and all(isinstance(v, Num) for v in group.items)
        if self.mode(group) not in ("", Form.CENTER_SIZE):
            raise Unreadable("ellipseMode is not CENTER, and only CENTER is read: write the center and the diameter")
        sure = row.form if row and row.form else Form.DIAMETER if self.sketch else ""
        if (bare or (row and row.form)) and self._choose(Ask.ROUND, CHOICES[Ask.ROUND], sure=sure) == Form.DIAMETER:
            flat[0], said = flat[0] / 2, BY_DIAMETER
        x, y = (x + place[0], y + place[1]) if place else (x, y)
        return [circle((x, y), flat[0], group, label, said, *given)]

    def _refuse_expressions(self, arguments: Sequence[Any]) -> None:
        """Raise Unreadable for a call before a number that is no point and no color: Circle(sqrt(4), 0, 1)."""
        last_number = max((i for i, a in enumerate(arguments) if self._is_number(a)), default=0)
        last_point = max((i for i, a in enumerate(arguments) if self.point(a)), default=0)
        for argument in arguments[last_point:last_number]:
            value = self.resolve(argument)
            if isinstance(value, Group) and value.name and not notation(value.name) and not self.point(value):
                self.number(argument)

    def _refuse_names(self, arguments: Sequence[Any]) -> None:
        """Raise Unreadable for a name among numbers: Circle(x, y, 10)."""
        if any(map(self._is_number, arguments)):
            for argument in arguments:
                if isinstance(self.resolve(argument), Name):
                    self.number(argument)

    def _ellipse(self, group: Group, row: Notation, label: str) -> list[Read]:
        """Return the circle of an ellipse with equal axes: (x, y, width, height); Unreadable for any other.

        The point is its center, or the corner of its box if the row says so.
        """
        keys = self.as_object(group).fields
        if {"cx", "cy", "rx", "ry"} <= set(keys):
            x, y, radius, other = (self.number(keys[name]) for name in ("cx", "cy", "rx", "ry"))
            if radius == other:
                return [circle((x, y), radius, group, label, BY_RADIUS, other)]
        if self.mode(group) not in ("", Form.CENTER_SIZE):
            raise Unreadable("ellipseMode is not CENTER, and only CENTER is read: write the center and the diameter")
        flat = self.numbers(group.items) or []
        if len(flat) not in (3, 4) or flat[2] != flat[-1]:
            raise Unreadable("an ellipse: write it as a polygon with many corners")
        said, radius = BY_DIAMETER, flat[2] / 2
        sure = Form.DIAMETER if self.sketch or row.form else ""
        if len(flat) == 4 and self._choose(Ask.ROUND, (Form.DIAMETER, Form.RADIUS), sure=sure) == Form.RADIUS:
            said, radius = BY_RADIUS, flat[2]
        x, y = (flat[0] + radius, flat[1] + radius) if row.form == Form.CORNER_SIZE else (flat[0], flat[1])
        return [circle((x, y), radius, group, label, said, *flat)]

    def _box(self, group: Group, row: Notation, label: str) -> list[Read]:
        """Return the box of a call, in the form that `row` gives to its numbers, or that the user chose."""
        arguments, named = self._arguments(group)
        arguments, place, angle = self._body(arguments)
        if row.ask == CORNER_OR_CENTER and (centered := self._centered(arguments, named)):  # square(4, center=true)
            form = Form.CENTER_SIZE if centered == "true" else Form.CORNER_SIZE
            arguments, row = (
                [a for a in arguments if not isinstance(a, Name)],
                row._replace(form=form, ask=(), alone=True),
            )
        if angle is None:
            angle = named.get("angle", "degrees", "radians")
        if only := self._options(arguments):
            return self._object(replace(only, start=group.start, end=group.end), label, row)
        last = self.resolve(arguments[-1]) if arguments else None
        if isinstance(last, Num) and last.turn is not None:  # SetAsBox(1, 1, center, 0.5f * b2_pi)
            arguments, angle = arguments[:-1], last
        says = [name for name in named.fields if key(name) and key(name) not in ("angle", "degrees", "radians")]
        if named.fields and (says or not arguments):
            return self._object(replace(named, start=group.start, end=group.end, rest=arguments), label, row)
        inner = self.resolve(arguments[0]) if len(arguments) == 1 else None
        pairs = isinstance(inner, Group) and any(isinstance(v, Pair) for v in inner.items)
        if isinstance(inner, Group) and not (inner.name or pairs) and len(inner.items) > 1 and not self.point(inner):
            self.consume(arguments)
            row = row._replace(form="", ask=ANY_BOX) if group.name.startswith("cv") else row  # a box, not two corners
            arguments = list(inner.items)  # Rect([0, 0, 4, 4]), setFromPoints([(0, 0), (4, 1), (2, 4)])
        parts = [self.point(a) if isinstance(self.resolve(a), (Group, Obj)) else None for a in arguments]
        if len(parts) > 2 and all(parts) and group.name.lower().endswith(("frompoints", "boundingrect")):
            xs, ys = zip(*(p for p in parts if p), strict=True)
            made = self._made_box([min(xs), min(ys), max(xs), max(ys)], Form.CORNER_CORNER, group, label)
            return [replace(made, said=f"the bounding box of {len(xs)} points", used=places(*xs, *ys), keyed=True)]
        if parts and any(p is not None for p in parts):
            flat: list[Fraction] = []
            for argument, part in zip(arguments, parts, strict=True):
                flat += part if part is not None else [self.number(argument)]
        else:
            flat = self.numbers(arguments) or []
        if row.form == Form.CENTER_HALF and len(flat) >= 4 and parts[0] is None:
            flat = [*flat[2:4], *flat[:2], *flat[4:]]  # b2 and planck: half sizes, then the center
        if len(flat) in (1, 3) and group.name.lower().endswith("square"):
            flat.append(flat[-1])
        if len(flat) == 2:  # a size alone: its center is where its body is
            form = self._choose(Ask.BOX_FORM, row.ask) if row.ask == CORNER_OR_CENTER else row.form or Form.CENTER_SIZE
            form = form if form in (Form.CENTER_SIZE, Form.CENTER_HALF) or row.alone or row.ask else Form.CENTER_SIZE
            flat = [*(place or ZERO), *flat]
            made = self._made_box(flat, form, group, label, angle, row.unit)
            return [made if place else replace(made, said=f"{made.said}{AT_ORIGIN}")]
        if len(flat) not in (4, 5):
            self._refuse_names(arguments)
            return self._plain(replace(group, name="", methods=[]), label)
        ask = row.ask or ()
        if not row.form and len(arguments) == 3:
            ask = CORNER_OR_CENTER  # a point, a width and a height
        if group.bracket == "[" and row.form == Form.CORNER_SIZE:  # Mathematica: Rectangle[{0, 0}, {1, 1}]
            row, ask = row._replace(form=Form.CORNER_CORNER if len(arguments) == 2 else ""), ask or ANY_BOX
        second = self.resolve(arguments[1]) if len(arguments) == 2 else None
        if row.form == Form.CORNER_SIZE and isinstance(second, Group) and "point" in second.name.lower():
            row, ask = row._replace(form=""), (Form.CORNER_CORNER, Form.CORNER_SIZE)
        form = (
            self._choose(Ask.BOX_FORM, ask, sure=self.mode(group))
            if ask and not row.form
            else self._overridden(row.form)
        )
        if (
            len(flat) == 5
            and angle is None
            and form not in (Form.CORNER_CORNER, Form.X_THEN_Y)
            and not self.mode(group)
        ):
            angle = angle_of(group, flat)
        if len(arguments) == 4 and not named.fields and row.ask == ANY_BOX and not self.mode(group):
            self._ask_order()
        made = self._made_box(
            flat[:4], form, group, label, angle, Form.RADIANS if row.form == Form.CENTER_HALF else row.unit
        )
        made = replace(made, keyed=bool(row.form))
        return [moved(made, place) if place else made]

    def _centered(self, arguments: Sequence[Any], named: Obj) -> str:
        """Drop the argument that says if the center of a box is at the origin, and return "true", "false" or ""."""
        said = [v.text for v in (*arguments[-1:], named.fields.pop("center", None)) if isinstance(v, Name)]
        return next((text for text in said if text in ("true", "false")), "")

    def _centers_and_radii(self, items: Sequence[Any], label: str) -> list[Read]:
        """Return the shapes of a call such as CheckCollisionCircleRec(center, radius, box); [] if it has no circle.

        `label`: the name of shapes that have none of their own.
        """
        found: list[Read] = []
        rest: list[Any] = []
        center: Pt | None = None
        for item in items:
            if center is not None and self._is_number(item):
                found.append(circle(center, self.number(item), item, label))
                center = None
            elif (center := self.point(item)) is None:
                rest.append(item)
        return [*found, *self._each(rest, label)] if found else []


def _begins_with_numbers(items: Sequence[Any]) -> bool:
    """Return whether a call's arguments begin with two numbers, as a box's do."""
    return len(items) > 1 and all(isinstance(item, Num) for item in items[:2])
