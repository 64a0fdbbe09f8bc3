"""Numbers, points and outlines among the values of a text.  A part that is not a number is never taken for one."""

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from .atoms import is_pair
from .harmless import HARMLESS, TESTS
from .names import Obj, Unreadable, short
from .notations import LIST_WORDS, Kind, notation
from .statements import Statements
from .tree import Bad, Group, Name, Num, Pair, Value

Pt = tuple[Fraction, Fraction]


class Numeral(Fraction):
    """An exact number of the text that knows the place where it ends, so that no number is lost without a word."""

    __slots__ = ("at",)
    at: int


def angle_of(at: Value, flat: Sequence[Fraction]) -> Num:
    """Return the fifth number of a box, its angle as written, as a value with a place in the text.

    at: the value that holds the box; flat: its numbers, five or more.
    """
    number = flat[4]
    return Num(at.start, number.at if isinstance(number, Numeral) else at.end, number)


def places(*numbers: Fraction) -> frozenset[int]:
    """Return the offsets in the text at which these numbers end; a computed number has none."""
    return frozenset(n.at for n in numbers if isinstance(n, Numeral))


ZERO = (Fraction(0), Fraction(0))


class Points(Statements):
    """Reads numbers, points and outlines; Unreadable says why something that looks like one is not."""

    def number(self, value: Any) -> Fraction:
        """Return a value as an exact number; Unreadable says why it is not one."""
        given = value
        value = self.resolve(value)
        if isinstance(value, Num):
            if value.value is None:
                raise Unreadable(value.why)
            if value is not given:
                self.used.add(id(value))
            found = Numeral(value.value)
            found.at = value.end
            return found
        if isinstance(given, Name):
            name = given.text
            if name.lower().rsplit(".", 1)[-1] in ("nan", "inf", "infinity", "positive_infinity"):
                raise Unreadable(f"{name} is not a finite number: write the number that is meant")
            raise Unreadable(f"{short(name)} is a name, not a number: write its value")
        part = self.text[given.start : given.end] if isinstance(given, Value) else ""
        raise Unreadable(f"{short(part)} is not evaluated: write the number that it stands for")

    def numbers(self, items: Sequence[Any]) -> list[Fraction] | None:
        """Return the items as numbers; None if most are not numbers, Unreadable if only some are not."""
        found = [self.resolve(item) for item in items]
        count = sum(isinstance(v, Num) for v in found)
        if not found or count * 2 < len(found) or any(isinstance(v, (Group, Obj)) for v in found):
            return None
        return [self.number(item) for item in items]

    def point(self, value: Any, *, origin: bool = False) -> Pt | None:
        """Return a point, or None for anything else; Unreadable for a point with a coordinate that is not a number.

        `origin`: a call without numbers, `new Vector()`, is the origin; a corner must have its numbers.
        """
        value = self.resolve(value)
        if isinstance(value, Obj):
            return self._xy(value)
        if not isinstance(value, Group):
            return None
        row = notation(value.name) if value.name else None
        if row and row.kind != Kind.POINT and not (row.kind == Kind.RING and value.bracket in "[("):
            return None
        if any(isinstance(item, Pair) for item in value.items):
            return self._xy(self.as_object(value))
        items = value.items
        while len(items) == 1 and isinstance(items[0], Group) and items[0].bracket in " ({[" and not items[0].name:
            items = items[0].items
        if not items and origin and row and row.kind == Kind.POINT:
            return ZERO
        if len(items) == 2 and any(isinstance(v, Num) for v in items) and (not row or row.kind == Kind.POINT):
            call = next((v for v in items if isinstance(v, Group) and v.name and not notation(v.name)), None)
            if call is not None and (not value.name or row) and self.point(call) is None:
                self.number(call)  # says that it is not evaluated
        if len(items) not in (2, 3) or any(isinstance(self.resolve(v), (Group, Obj)) for v in items):
            return None
        plain = sum(isinstance(self.resolve(v), Num) for v in items)
        if len(items) == 3:
            if plain < 3 or not row or row.kind != Kind.POINT:
                return None
            self._leave_out([items[2]])
        if plain == 0 and not (row and row.kind == Kind.POINT):
            return None
        self._refuse_methods(value)
        return self.number(items[0]), self.number(items[1])

    def _leave_out(self, thirds: Sequence[Any]) -> None:
        """Note that third coordinates were left out."""
        self.counts |= {value.end for value in thirds}
        self.thirds |= {self.number(value) for value in thirds if self._is_number(value)}

    def vector(self, value: Any) -> Pt | None:
        """Return the value of a key as a point or a size, also of (x, y, z) and {width, height}; else None."""
        value = self.resolve(value)
        made = (
            self.as_object(value)
            if isinstance(value, Group) and any(isinstance(v, Pair) for v in value.items)
            else value
        )
        if isinstance(made, Obj) and made.get("width") is not None and made.get("height") is not None:
            return self.number(made.get("width")), self.number(made.get("height"))
        if isinstance(value, Group) and not value.name and len(value.items) == 3 and self.numbers(value.items):
            self._leave_out([value.items[2]])
            value = Group(value.start, value.end, value.items[:2], value.bracket)
        return self.point(value)

    def _xy(self, obj: Obj) -> Pt | None:
        """Return the point of an object with x and y."""
        x, y = obj.get("x"), obj.get("y")
        if obj.twice and (x is not None or y is not None):
            raise Unreadable(f"the key {obj.twice} is given twice: keep one of them")
        if (
            x is None
            or y is None
            or obj.get("radius", "diameter", "width", "half", "halfwidth", "size", "points") is not None
        ):
            return None
        return self.number(x), self.number(y)

    def _refuse_methods(self, group: Group) -> None:
        """Raise Unreadable for a chained call that would change a value."""
        for name, arguments in group.methods:
            if name.lower() not in HARMLESS and arguments.items:
                raise Unreadable(f".{name}(...) is not evaluated: write the result")

    def ring(self, value: Any) -> list[Pt] | None:
        """Return the points of an outline, or None; Unreadable where one among points has no numbers."""
        value = self._columns(self.resolve(value))
        if isinstance(value, Obj):
            numbered = {k: v for k, v in value.fields.items() if isinstance(k, int)}
            if not numbered:
                return None
            return self._points(self._all_numbered(value, numbered))
        if not isinstance(value, Group) or any(isinstance(item, Pair) for item in value.items):
            return None
        row = notation(value.name) if value.name else None
        if row and row.kind not in (Kind.RING, Kind.POINT):
            return None
        self._refuse_methods(value)
        items = [item for item in value.items if not (isinstance(item, Group) and not item.items and not item.name)]
        if len(items) == 1 and isinstance(self.resolve(items[0]), (Group, Obj)):
            if isinstance(items[0], Name) and not row:
                return None  # the argument of a call that makes no shape: p.intersects(q)
            return self.ring(items[0])
        if value.bracket == "," and any(isinstance(v, Group) and v.bracket == " " for v in items):
            items = self._between_spaces(items)
        other = value.bracket == "(" and value.name and row is None
        if other and any(map(self._is_style, items)):
            return None
        two_words = len(items) == 2 and not any(isinstance(v, Bad) for v in items)  # {:ok, 0.0}
        flat = None if two_words else self.numbers(items)
        if flat is not None:
            if len(flat) < 6 or (row and row.kind == Kind.POINT) or (other and not LIST_WORDS.search(value.name)):
                return None  # setTransform(1, 0, 0, 1, 5, 5) is no outline
            if len(flat) % 2:
                raise Unreadable(
                    f"a list of {len(flat)} numbers is no list of x and y: add the missing number, or remove one"
                )
            return list(zip(flat[::2], flat[1::2], strict=True))
        found = self._points(items)
        if found and len(found) > 2 and other and (TESTS.search(value.name) or not LIST_WORDS.search(value.name)):
            raise Unreadable(f"{short(value.name)}(...) does not say what its points are: write each shape by itself")
        return found

    def _between_spaces(self, items: Sequence[Any]) -> list[Any]:
        """Return the numbers of 0,0 4,0 0,3 and of 0 0, 4 0, 0 3, and those of 0,0,5 4,0,5 0,3,5 without each third."""
        rows = [v.items if isinstance(v, Group) and v.bracket == " " else [v] for v in items]
        sizes = [len(row) for row in rows]
        flat = [number for row in rows for number in row]
        if sizes == [1, 1, *[2, 1] * ((len(sizes) - 3) // 2), 1]:
            self._leave_out(flat[2::3])
            return [number for i, number in enumerate(flat) if i % 3 < 2]
        if set(sizes) != {2} and sizes != [1, *[2] * (len(sizes) - 2), 1]:
            raise Unreadable("commas and spaces between the numbers do not say which are x and y: write (x, y)")
        return flat

    def _is_style(self, value: Any) -> bool:
        """Return whether a value is a text in quotes, or a color such as 0xff0000."""
        text = isinstance(value, Name) and self.text[value.start] in "'\"`"
        return text or (isinstance(value, Num) and value.value is None and "hexadecimal" in value.why)

    def _columns(self, value: Any) -> Any:
        """Return a matrix of R with two columns as a list of points: matrix(c(0, 4, 4, 0, 0, 3), ncol = 2)."""
        if not isinstance(value, Group) or value.name not in ("matrix", "structure"):
            return value
        said = self.as_object(value)
        lists = [v for v in map(self.resolve, said.rest) if isinstance(v, Group)]
        if not lists:
            return value
        flat = lists[0].items
        counts = [v for v in map(self.resolve, said.rest) if isinstance(v, Num)]  # matrix(data, rows, columns)
        counts += [v for v in (said.fields.get("nrow"), said.fields.get("ncol")) if isinstance(v, Num)]
        if isinstance(dim := said.fields.get("dim"), Group):
            counts += dim.items
        if not counts or not all(isinstance(v, Num) for v in (*flat, *counts)):
            return value
        half = len(flat) // 2
        columns = counts[-1].value if len(counts) > 1 or "ncol" in said.fields else len(flat) / (counts[0].value or 1)
        if len(flat) % 2 or half < 3 or columns != 2:
            raise Unreadable("a matrix without exactly two columns of numbers: write its corners as (x, y)")
        self.counts |= {v.end for v in counts}
        by_row = getattr(said.fields.get("byrow"), "text", "F").upper().startswith("T")
        pairs = zip(flat[::2], flat[1::2], strict=True) if by_row else zip(flat[:half], flat[half:], strict=True)
        return Group(value.start, value.end, [Group(a.start, b.end, [a, b], "(") for a, b in pairs], "[")

    def _all_numbered(self, obj: Obj, numbered: dict[int, Any]) -> list[Any]:
        """Return the elements v[0], v[1], ... in their order; Unreadable where one is missing, or was set before."""
        first, last = min(numbered), max(numbered)
        missing = next((k for k in range(first, last) if k not in numbered), None)
        if first not in (0, 1):
            raise Unreadable(f"the corners begin with [{first}]: add those before it")
        if missing is not None:
            raise Unreadable(f"v[{missing}] is missing between v[{first}] and v[{last}]: add it")
        if any(isinstance(v, Group) and any(map(is_pair, v.items)) for v in obj.rest):
            raise Unreadable("a list of corners is changed after it was made: write the corners that it has at the end")
        return [numbered[k] for k in range(first, last + 1)]

    def _points(self, items: Sequence[Any]) -> list[Pt] | None:
        """Return the items as points; None if most are not points, Unreadable if only some are not."""
        found: list[Pt | None] = []
        why = ""
        for number, item in enumerate(items):
            try:
                found.append(self.point(item))
            except Unreadable as error:
                found.append(None)
                why = why or f"corner {number} (counted from 0): {error}"
        count = sum(p is not None for p in found)
        threes = [v for v in map(self.resolve, items) if isinstance(v, Group) and len(v.items) == 3 and not v.name]
        if count == 0 and len(threes) == len(items) > 1 and all(isinstance(n, Num) for v in threes for n in v.items):
            raise Unreadable(
                "three numbers in each bracket, and satviz is about two dimensions: write circles as "
                "circle((x, y), r), corners without their z, and corners in the place of indices"
            )
        if count < max(2, len(items) // 2) and not (why and len(items) > 2):
            return None
        if count == 2 and len(items) == 3 and self._is_number(items[2]):
            return None  # a center, a size and an angle
        if count < len(items):
            place = next(i for i, p in enumerate(found) if p is None)
            raise Unreadable(why or f"item {place} (counted from 0) of a list is not a pair of numbers: write (x, y)")
        return [p for p in found if p is not None]

    def _is_number(self, item: Any) -> bool:
        """Return whether an item is a number, or a name that stands for one."""
        return isinstance(self.resolve(item), Num)

    def _has_numbers(self, value: Any) -> bool:
        """Return whether there is a number in a value."""
        inner = value.items if isinstance(value, Group) else [value.value] if isinstance(value, Pair) else []
        return isinstance(value, Num) or any(map(self._has_numbers, inner))
