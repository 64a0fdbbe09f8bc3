"""Boxes in each form, shapes that are turned or moved, and what is asked where two readings are possible."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from math import cos, isqrt, radians, sin, sqrt
from typing import Any

from .exact import centroid
from .names import Obj, Unreadable
from .notations import ANY_BOX, CORNER_OR_CENTER, Ask, Form, Notation, key
from .points import ZERO, Points, Pt, places
from .tree import Group, Name, Num, Value

SKETCH_MODES = {
    "corner": Form.CORNER_SIZE,
    "corners": Form.CORNER_CORNER,
    "center": Form.CENTER_SIZE,
    "radius": Form.CENTER_HALF,
}
CHOICES: Mapping[str, tuple[str, ...]] = {
    Ask.BOX_FORM: (*ANY_BOX, Form.X_THEN_Y),
    Ask.ANGLE: (Form.DEGREES, Form.RADIANS),
    Ask.TURN: (Form.Y_UP, Form.Y_DOWN),
    Ask.ORDER: (Form.WIDTH_FIRST, Form.HEIGHT_FIRST),
    Ask.PIVOT: (Form.AROUND_CENTER, Form.AROUND_CORNER, Form.AROUND_ORIGIN),
    Ask.CORNERS: (Form.RELATIVE, Form.ABSOLUTE, Form.UNTURNED),
    Ask.ROUND: (Form.RADIUS, Form.DIAMETER),
    Ask.TWICE: (Form.EACH_VALUE, Form.LAST_VALUE),
    Ask.COMMAS: (Form.DECIMAL_COMMAS, Form.SEPARATORS),
}
ALL_CHOICES = (*(choice for choices in CHOICES.values() for choice in choices), Form.LEAVE_OUT, Form.TAKE_IN)
FULL_TURN = Fraction(63, 10)  # an angle beyond a full turn in radians is in degrees
ONLY_IF_IT_MATTERS = (Ask.TURN, Ask.ORDER, Ask.ROUND)  # asked only where the answer changes
CENTER_KEYS = ("center", "centre", "centroid", "middle", "cx", "xc", "centerx", "xcenter")
BY_RADIUS, BY_DIAMETER = "a circle by its center and radius", "a circle by its center and diameter"
AT_ORIGIN = ", at the origin"  # of a shape for which the text gives no position
FORM_WORDS = {
    Form.CORNER_SIZE: "a box by a corner and its size",
    Form.CORNER_CORNER: "a box by two opposite corners",
    Form.X_THEN_Y: "a box by its two x, then its two y",
    Form.SIZE_CORNER: "a box by its size and a corner",
    Form.CENTER_SIZE: "a box by its center and its size",
    Form.CENTER_HALF: "a box by its center and half its size",
}

Affine = tuple[Fraction, Fraction, Fraction, Fraction, Fraction, Fraction]
IDENTITY: Affine = (Fraction(1), Fraction(0), Fraction(0), Fraction(1), Fraction(0), Fraction(0))
# Forms with the numbers of another one, in another order.
ORDERS = {Form.X_THEN_Y: (Form.CORNER_CORNER, (0, 2, 1, 3)), Form.SIZE_CORNER: (Form.CORNER_SIZE, (2, 3, 0, 1))}


@dataclass(frozen=True, slots=True)
class Read:
    """A shape as it was read: exact points (of a circle its center), the words for it, and its place in the text."""

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
    keyed: bool = False  # the form of a box is known: by its keys, or by the table of notations
    named: bool = False  # it is known by its keys: width, height
    shift: Pt = ZERO  # the position that was added to its corners
    repeats: bool = False  # it stands in a call that tests two shapes, which may stand elsewhere as well
    used: frozenset[int] = frozenset()  # the ends, in the text, of the numbers that the shape uses

    @property
    def is_circle(self) -> bool:
        """Return whether it is a circle."""
        return self.radius is not None


class Boxes(Points):
    """Makes boxes, and turns shapes, as the readings that were chosen say; `asked` notes what is open."""

    def __init__(self, text: str, chosen: Sequence[str] = ()) -> None:
        super().__init__(text)
        self.chosen = chosen
        self.asked: dict[str, tuple[str, ...]] = {}
        self.holes: set[int] = set()  # where outlines begin that may be holes of others
        self.doubts = False  # whether a part may be a shape or something else
        self.keeps = False  # a choice of a form is for the boxes whose form is asked, and for no others

    def _overridden(self, form: str) -> str:
        """Return the form that the user chose for all boxes, or `form`, that of the notation.

        While the form of some boxes is asked (`keeps`), the choice is for these alone.
        """
        return form if self.keeps else next((c for c in self.chosen if c in ANY_BOX), form)

    def mode(self, group: Group) -> str:
        """Return how a sketch of Processing means the numbers of rect(...) or ellipse(...), or "" for other calls."""
        what = {"rect": "rect", "square": "rect", "circle": "ellipse", "ellipse": "ellipse"}.get(group.name, "")
        if not self.sketch or not what:
            return ""
        before = [mode for of, start, mode in self.modes if of == what and start < group.start]
        return SKETCH_MODES.get(before[-1] if before else "corner" if what == "rect" else "center", "")

    def _ask_order(self) -> None:
        """Note that width and height could be the other way round."""
        self.asked.setdefault(Ask.ORDER, CHOICES[Ask.ORDER])

    def _choose(self, what: str, ask: Sequence[str], sure: str = "") -> str:
        """Return the reading that the user chose, else `sure`, else the first of `ask`, which becomes a question."""
        for choice in self.chosen:
            if choice in ask:
                return choice
        if sure:
            return sure
        self.asked[what] = tuple(dict.fromkeys((*self.asked.get(what, ()), *ask)))
        return ask[0]

    def _outline(self, points: list[Pt], value: Value, label: str, shift: Pt = ZERO, how: str = "") -> Read:
        """Return the polygon of these points, moved by `shift`; `how`: words that say where this move comes from."""
        moved = tuple((x + shift[0], y + shift[1]) for x, y in points)
        said = f"a polygon of {len(points)} corners{how}"
        used = places(*(c for p in points for c in p), *shift)
        return Read(moved, None, said, value.start, value.end, label, shift=shift, used=used)

    def _made_box(
        self, four: Sequence[Fraction], form: str, at: Value, label: str, angle: Any = None, unit: str = ""
    ) -> Read:
        """Return a box of four numbers in a form, at a part of the text, turned if an angle is given.

        `angle`: a Num, or a Name that stands for one; `unit`: degrees, radians, or "" where it is asked.
        """
        if form in ORDERS:
            other, order = ORDERS[form]
            made = self._made_box([four[i] for i in order], other, at, label, angle, unit)
            return replace(made, said=made.said.replace(FORM_WORDS[other], FORM_WORDS[form]))
        a, b, w, h = four
        if Form.HEIGHT_FIRST in self.chosen and form in (Form.CORNER_SIZE, Form.CENTER_SIZE, Form.CENTER_HALF):
            w, h = h, w
        if form == Form.CORNER_SIZE:
            x0, y0, x1, y1 = a, b, a + w, b + h
        elif form == Form.CORNER_CORNER:
            x0, y0, x1, y1 = a, b, w, h
        else:
            rx, ry = (w / 2, h / 2) if form == Form.CENTER_SIZE else (w, h)
            x0, y0, x1, y1 = a - rx, b - ry, a + rx, b + ry
        negative = ""
        if form != Form.CORNER_CORNER and (w < 0 or h < 0):
            negative = " and ".join(f"{n} {plain(v)}" for n, v in (("width", w), ("height", h)) if v < 0)
        xs, ys = sorted((x0, x1)), sorted((y0, y1))
        corners = ((xs[0], ys[0]), (xs[1], ys[0]), (xs[1], ys[1]), (xs[0], ys[1]))
        made = Read(
            corners, None, FORM_WORDS[form], at.start, at.end, label, negative=negative, box=tuple(four), form=form
        )
        made = replace(made, used=places(*four))
        if angle is None:
            return made
        pivot = ((xs[0] + xs[1]) / 2, (ys[0] + ys[1]) / 2)
        if (
            form == Form.CORNER_SIZE
            and self._turns(angle)
            and self._choose(Ask.PIVOT, CHOICES[Ask.PIVOT][:2]) == Form.AROUND_CORNER
        ):
            pivot = (a, b)
        return self._turned(made, angle, unit, pivot)

    def _turns(self, angle: Any) -> bool:
        """Return whether an angle is not 0."""
        given = self.resolve(angle)
        return bool(given.turn if isinstance(given, Num) and given.turn is not None else self.number(angle))

    def pivot(self, shape: Read, place: Pt | None = None, *, rotates: bool = False) -> Pt:
        """Return the point about which a call or a field turns a shape that was made before.

        `rotates`: it is a call such as rotate(a), which turns about the origin in some libraries.
        """
        if shape.said.endswith(AT_ORIGIN) or place or shape.shift != ZERO or not (shape.form or rotates):
            return shape.points[0] if shape.is_circle and not place else place or shape.shift
        xs, ys = zip(*shape.points, strict=True)
        by_corner = shape.form in (Form.CORNER_SIZE, Form.CORNER_CORNER)
        ask = (
            Form.AROUND_CENTER,
            *([Form.AROUND_CORNER] if by_corner else []),
            *([Form.AROUND_ORIGIN] if rotates else []),
        )
        known = Form.AROUND_CENTER if shape.form and not by_corner and not shape.named else ""
        around = self._choose(Ask.PIVOT, ask, sure=known) if len(ask) > 1 else Form.AROUND_CENTER
        if around != Form.AROUND_CENTER:
            return ZERO if around == Form.AROUND_ORIGIN else (min(xs), min(ys))
        return ((min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2) if shape.form else centroid(shape.points)

    def _turned(self, shape: Read, angle: Any, unit: str, pivot: Pt | None) -> Read:
        """Return a shape turned by an angle about a pivot (None: the origin); the unit is asked where none is named."""
        given = self.resolve(angle)
        if isinstance(given, Num) and given.turn is not None:  # Math.PI / 4
            self.parts.append((given.start, given.end))
            value, unit = given.turn, Form.DEGREES
        else:
            value = self.number(angle)
            shape = replace(shape, used=shape.used | places(value))
            end = given.end if isinstance(given, Num) else 0
            if self.text.endswith(("deg", "\u00b0", "rad"), 0, end):
                unit = Form.RADIANS if self.text.endswith("rad", 0, end) else Form.DEGREES
        if value == 0 or (shape.is_circle and shape.points[0] == (pivot or ZERO)):
            return shape
        if not unit:
            likely = (Form.DEGREES, Form.RADIANS) if value.denominator == 1 else (Form.RADIANS, Form.DEGREES)
            more_than_a_turn = abs(value) > FULL_TURN and Form.RADIANS not in self.chosen
            unit = Form.DEGREES if more_than_a_turn else self._choose(Ask.ANGLE, likely)
        self.asked.setdefault(Ask.TURN, CHOICES[Ask.TURN])
        signed = -value if Form.Y_DOWN in self.chosen else value
        c, s, exact = cosine_and_sine(signed, unit)
        px, py = pivot or ZERO
        points = tuple((px + (x - px) * c - (y - py) * s, py + (x - px) * s + (y - py) * c) for x, y in shape.points)
        said = f"{shape.said}, turned by {plain(value)} {unit}"
        rounded = shape.rounded or not exact
        return replace(shape, points=points, said=said, rounded=rounded, box=(), form="")

    def _box_of_keys(
        self, obj: Obj, place: Pt | None, center: Any, row: Notation | None
    ) -> tuple[list[Fraction], str] | None:
        """Return (four numbers, form) of an object whose keys describe a box; None for another object.

        `place`: the position that its keys give; `center`: the value of that key; `row`: of the call around the keys.
        """
        get = obj.get
        least, most = get("min"), get("max")
        if least is not None and most is not None:
            p, q = self.vector(least), self.vector(most)
            return ([*p, *q], Form.CORNER_CORNER) if p and q else None
        if get("corner") is not None and get("opposite") is not None:
            p, q = self.vector(get("corner")), self.vector(get("opposite"))
            return ([*p, *q], Form.CORNER_CORNER) if p and q else None
        letters = {str(k).lower(): v for k, v in obj.fields.items()}
        if all(side in letters for side in "ltrb"):  # Rect64(l: 0, t: 0, r: 4, b: 4)
            return [self.number(letters[side]) for side in "ltrb"], Form.CORNER_CORNER
        corners = [get(name) for name in ("x0", "y0", "x1", "y1")]
        if corners[2] is None and corners[0] is None and "x1" in obj.fields and "x2" in obj.fields:
            corners = [obj.fields.get(name) for name in ("x1", "y1", "x2", "y2")]
        elif corners[0] is not None and corners[2] is None:
            corners[2:] = [obj.fields.get("x1"), obj.fields.get("y1")]
        if all(c is not None for c in corners):
            four = [self.number(c) for c in corners]
            if get("width") is not None and get("height") is not None:  # a DOMRect has both, and they must agree
                w, h = self.number(get("width")), self.number(get("height"))
                if (w, h) != (four[2] - four[0], abs(four[3] - four[1])):
                    raise Unreadable(
                        f"its width and height ({plain(w)}, {plain(h)}) are not those of its corners: delete one"
                    )
                same = [get("width"), get("height")]
                xy = (get("x"), get("y"))
                same += [v for v, c, side in zip(xy, place or (), four, strict=False) if v is not None and c == side]
                self.counts |= {value.end for value in same}
            return four, Form.CORNER_CORNER
        if place is None and all(c is not None for c in corners[:2]):
            place = (self.number(corners[0]), self.number(corners[1]))
        half = get("half")
        if half is not None or (get("halfwidth") is not None and get("halfheight") is not None):
            size = (
                self.vector(half)
                if half is not None
                else (self.number(get("halfwidth")), self.number(get("halfheight")))
            )
            return ([*(place or ZERO), *size], Form.CENTER_HALF) if size else None
        size = self.vector(get("size")) if get("size") is not None else None
        if size is None and get("width") is not None and get("height") is not None:
            size = (self.number(get("width")), self.number(get("height")))
        if (
            size is not None
            and place is None
            and row
            and (row.form in (Form.CENTER_SIZE, Form.CENTER_HALF) or row.alone)
        ):
            return [*ZERO, *size], Form.CENTER_SIZE if row.form == Form.CENTER_HALF else row.form  # where its body is
        if size is None or place is None:
            return None
        sides = {origin_of(obj, "originx", "left"), origin_of(obj, "originy", "top")}
        if sides - {"left", "top", "center"} or (len(sides) == 2 and "center" in sides):
            raise Unreadable("the origin of the box is neither its corner nor its center: write the corner")
        if "center" in sides:
            return [*place, *size], Form.CENTER_SIZE
        names = {n.lower().replace("_", "") for n in obj.fields if isinstance(n, str)}
        named_center = not names.isdisjoint(CENTER_KEYS)
        named_corner = get("corner") is not None or get("x0") is not None
        if named_center or named_corner:
            return [*place, *size], Form.CENTER_SIZE if named_center else Form.CORNER_SIZE
        form = (row.keyed or (row.form if row.form in CORNER_OR_CENTER else "")) if row else ""
        if form:
            return [*place, *size], self._overridden(form)
        return [*place, *size], self._choose(Ask.BOX_FORM, CORNER_OR_CENTER)


def circle(center: Pt, radius: Fraction, at: Value, label: str, said: str = BY_RADIUS, *also: Fraction) -> Read:
    """Return a circle that stands at a part of the text; `also`: other numbers of the text that it has."""
    used = places(*center, radius, *also)
    return Read((center,), radius, said, at.start, at.end, label, used=used)


def moved(shape: Read, move: Pt) -> Read:
    """Return the shape moved by `move`."""
    points = tuple((x + move[0], y + move[1]) for x, y in shape.points)
    said = shape.said.replace(AT_ORIGIN, "")
    said = said if said.endswith(" and a position") else f"{said} and a position"
    box = shape.box
    if box:
        last = (box[2] + move[0], box[3] + move[1]) if shape.form == Form.CORNER_CORNER else box[2:]
        box = (box[0] + move[0], box[1] + move[1], *last)
    return replace(shape, points=points, said=said, box=box, used=shape.used | places(*move))


def transformed(shape: Read, matrix: Affine, *, exact: bool) -> Read:
    """Return the shape under x' = ax + cy + e and y' = bx + dy + f; Unreadable for a circle that becomes an ellipse."""
    a, b, c, d, e, f = matrix
    if matrix[:4] == IDENTITY[:4]:
        return moved(shape, (e, f))
    points = tuple((a * x + c * y + e, b * x + d * y + f) for x, y in shape.points)
    radius, square = shape.radius, a * a + b * b
    if radius is not None:
        if max(abs(square - c * c - d * d), abs(a * c + b * d)) > (0 if exact else square / 10**12):
            raise Unreadable("a transform turns a circle into an ellipse: write it as a polygon with many corners")
        root = Fraction(isqrt(square.numerator), isqrt(square.denominator))
        exact = exact and root * root == square
        radius *= root if exact else Fraction(sqrt(square))
    rounded = shape.rounded or not exact
    return replace(
        shape, points=points, radius=radius, said=f"{shape.said}, transformed", rounded=rounded, box=(), form=""
    )


def cosine_and_sine(angle: Fraction, unit: str) -> tuple[Fraction, Fraction, bool]:
    """Return (cosine, sine, whether both are exact) of an angle in a unit, Form.DEGREES or Form.RADIANS."""
    if unit == Form.DEGREES and angle % 90 == 0:
        c, s = ((1, 0), (0, 1), (-1, 0), (0, -1))[int(angle / 90) % 4]
        return Fraction(c), Fraction(s), True
    turn = radians(float(angle)) if unit == Form.DEGREES else float(angle)
    return Fraction(cos(turn)), Fraction(sin(turn)), False


def origin_of(obj: Obj, name: str, usual: str) -> str:
    """Return what an object gives as the origin of its position: left, center, ..."""
    found = next((v for k, v in obj.fields.items() if str(k).lower() == name), None)
    return found.text.lower() if isinstance(found, Name) else usual


def unit_of(obj: Obj) -> str:
    """Return the unit that a key of an object names, Form.DEGREES or Form.RADIANS, or ""."""
    named = {key(name) for name in obj.fields}
    return Form.DEGREES if "degrees" in named else Form.RADIANS if "radians" in named else ""


def plain(value: Fraction) -> str:
    """Return a number as a short decimal."""
    return f"{float(value):.12g}"
