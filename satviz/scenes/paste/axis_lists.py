"""Corners whose x and y stand in two lists: `int[] xs = {0, 4, 4}; int[] ys = {0, 0, 3};`."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from .harmless import listed
from .notations import Kind, notation
from .tree import Group, Name, Num

OTHER_AXIS = {"x": "y", "X": "Y", "lon": "lat", "lng": "lat", "Lon": "Lat", "Lng": "Lat"}
MAX_NAME = 40  # letters: longer names are no x and y
# calls with x and y in two lists
TAKE_AXES = listed("polyshape plot fill patch fillpolygon drawpolygon cbind column_stack zip")
LEAST = 3  # corners of an outline


def other_names(name: str) -> Iterator[str]:
    """Yield the names that a list of y can have, for the name of a list of x: ya for xa, polyY for polyX."""
    for x, y in OTHER_AXIS.items() if len(name) <= MAX_NAME else ():
        for i in range(len(name)):
            if name.startswith(x, i):
                yield name[:i] + y + name[i + len(x) :]


def pairs_of_lists(fields: Mapping[str | int, Any]) -> Iterator[tuple[str, Group, Group]]:
    """Yield (name, list of x, list of y) for the variables or keys that belong together; their lengths can differ."""
    for name, value in fields.items():
        if is_flat(value, 1) and isinstance(name, str):
            other = next((fields[n] for n in other_names(name) if n in fields and is_flat(fields[n], 1)), None)
            if other is not None and (is_flat(value) or is_flat(other)):
                yield name, value, other


def is_flat(value: Any, least: int = LEAST) -> bool:
    """Return whether a value is a list of at least `least` numbers, and nothing else; Vec3(0, 0, 1) is a point."""
    row = notation(value.name) if isinstance(value, Group) and value.name else None
    inner = value.items if isinstance(value, Group) and not (row and row.kind == Kind.POINT) else []
    if len(inner) == 1 and isinstance(inner[0], Group) and not inner[0].name:  # np.array([0, 1]), [0 1 2]
        inner = inner[0].items
    return len(inner) >= least and all(isinstance(v, Num) for v in inner)


def numbers_of(value: Group) -> list[Num]:
    """Return the numbers of a flat list."""
    return value.items[0].items if isinstance(value.items[0], Group) else value.items


def joined(x: Group, y: Group, count: int | None = None) -> Group | None:
    """Return the list of points of two lists, the first `count` of them; None where one is longer than the other."""
    xs, ys = numbers_of(x), numbers_of(y)
    if len(xs) != len(ys) or (count is not None and not LEAST <= count <= len(xs)):
        return None
    points = [Group(px.start, px.end, [px, py], "(") for px, py in zip(xs[:count], ys[:count], strict=True)]
    return Group(min(x.start, y.start), max(x.end, y.end), points, "[")


def lengths(x: Group, y: Group, count: int | None = None) -> str:
    """Return why two lists are not those of the corners of one shape."""
    sizes = f"{len(numbers_of(x))} and {len(numbers_of(y))} numbers"
    corners = "" if count is None else f", and the call says {count} corners"
    return f"the lists of x and y have {sizes}{corners}: write one x and one y for each corner"


def are_axes(given: Sequence[Any], values: Sequence[Any], name: str) -> bool:
    """Return whether the arguments of a call are a list of x and a list of y, rather than two outlines.

    At least one of these signs is needed: a list of odd length, fewer than three pairs in a list, the number of
    corners as a third argument, names such as xs and ys, or a call (`name`) that takes nothing else.  `given` has the
    arguments as they were written, `values` has what their names stand for.
    """
    if len(values) < 2 or not (is_flat(values[0]) and is_flat(values[1])):
        return False
    size = len(numbers_of(values[0]))
    named = all(isinstance(v, Name) for v in given[:2]) and given[1].text in set(other_names(given[0].text))
    counted = len(values) == 3 and isinstance(values[2], Num) and values[2].value == size
    return size % 2 == 1 or size < 2 * LEAST or named or counted or name.lower().split(".")[-1] in TAKE_AXES
