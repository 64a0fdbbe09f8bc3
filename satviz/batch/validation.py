"""Validation for batches: numbers in arrays, by the rules and in the words of satviz.Polygon and satviz.Circle."""

import json
from collections.abc import Callable, Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..engine import polygon_validation
from ..engine.geometry import InvalidShape
from ..engine.predicates import warn_if_flushed
from ..engine.shapes import Polygon

# More forms are accepted than a type can say, so type checkers allow anything and the checks here decide.
Outlines = Any  # an (N, V, 2) array, or a sequence of what satviz.Polygon takes
Points = Any  # an (N, 2) array, or a sequence of what satviz.Circle takes as its center
Numbers = Any  # an (N,) array, a sequence of numbers, or one number
CONCAVE_OPTIONS = "refuse", "split"  # what to do with concave outlines

OFFSETS_RULE = "offsets must rise from 0 to the number of vertices"  # of offsets


def check_word(name: str, value: object, words: Sequence[str]) -> None:
    """Raise TypeError unless the value is text, ValueError unless it is one of the words."""
    if not isinstance(value, str) or value not in words:
        fault = ValueError if isinstance(value, str) else TypeError
        raise fault(f"{name} is {polygon_validation.short_repr(value)}: choose {' or '.join(map(json.dumps, words))}")


def rings_from_array(vertices: NDArray[Any], name: Callable[[int], str]) -> NDArray[np.float64]:
    """Return an (N, V, 2) array as float64; InvalidShape names the first wrong number, and outline i by name(i)."""
    if vertices.ndim != 3 or vertices.shape[2] != 2 or vertices.shape[1] < 3:
        raise InvalidShape(f"vertices has the shape {vertices.shape}: expected (N, V, 2) with V at least 3")
    return floats(vertices, "vertices", lambda i, j, k: f"{name(i)}: vertex {j}.{'xy'[k]}")


def rings_from_offsets(vertices: Points, offsets: Any) -> tuple[NDArray[np.float64], NDArray[np.intp]]:
    """Return ((M, 2) corners, (N + 1,) offsets) in float64 and intp; InvalidShape names the first wrong value."""
    start = np.asarray(offsets)
    if start.ndim != 1 or not start.size or start.dtype.kind not in "iu":
        raise InvalidShape(f"offsets is {start.dtype} of the shape {start.shape}: expected N + 1 integers")
    polygon_validation.refuse_masked(offsets, "offsets")
    if (far := np.flatnonzero(start > np.iinfo(np.intp).max)).size:
        raise InvalidShape(f"offsets holds {start[far[0]]}: {OFFSETS_RULE}")
    start = start.astype(np.intp)

    def entry(i: int) -> str:
        """Return the name of one number in error messages."""
        polygon = np.searchsorted(start, i, side="right") - 1
        return f"polygon {polygon}: vertex {i - start[polygon]}"

    if start[0]:
        raise InvalidShape(f"offsets begins with {start[0]}: {OFFSETS_RULE}")
    if (fall := np.flatnonzero(np.diff(start) < 0)).size:
        raise InvalidShape(f"offsets falls from {start[fall[0]]} to {start[fall[0] + 1]}: {OFFSETS_RULE}")
    found = points(vertices, "vertices", entry)
    if start[-1] != len(found):
        raise InvalidShape(f"offsets ends with {start[-1]}: {OFFSETS_RULE}, {len(found)}")
    return found, start


def rings_from_sequence(vertices: Any, name: Callable[[int], str]) -> tuple[NDArray[np.float64], NDArray[np.intp]]:
    """Return ((M, 2) corners, (N + 1,) starts) of N outlines, as given.

    InvalidShape, which names outline i by name(i), if it is no list of points or has a number that is not finite.
    """
    given = _as_list(vertices, "vertices")
    arrays: list[NDArray[np.float64]] = []

    def joined() -> tuple[NDArray[np.float64], NDArray[np.intp]]:
        """Return the corners read so far and their starts; InvalidShape if a number is not finite."""
        start = np.cumsum([0, *map(len, arrays)])
        flat = np.concatenate([np.empty((0, 2)), *arrays])
        if (bad := np.flatnonzero(~np.isfinite(flat).all(axis=1))).size:
            i = int(np.searchsorted(start, bad[0], side="right")) - 1
            ring(given[i], name(i))  # says which number it is
        return flat, start

    for i, one in enumerate(given):
        array = _plain_float_ring(one)
        if array is None:
            try:
                array = ring(one, name(i))
            except InvalidShape:
                joined()  # one before it may be at fault as well
                raise
        arrays.append(array)
    return joined()


def _plain_float_ring(one: Any) -> NDArray[np.float64] | None:
    """Return an outline of plain floats as an unchecked (V, 2) array; None if its values need single checks."""
    if type(one) is np.ndarray:
        return one if one.dtype == np.float64 and one.ndim == 2 and one.shape[1] == 2 else None
    if type(one) is not list and type(one) is not tuple:
        return None
    flat: list[Any] = []
    for p in one:
        if (type(p) is not tuple and type(p) is not list) or len(p) != 2:
            return None
        flat += p
    return np.array(flat).reshape(-1, 2) if set(map(type, flat)) == {float} else None


def ring(vertices: Any, name: str) -> NDArray[np.float64]:
    """Return one outline as (V, 2) float64; InvalidShape, which begins with `name`, says what is wrong."""
    if isinstance(vertices, Polygon):
        return np.array(vertices.vertices)
    try:
        if _is_plain(vertices) and vertices.ndim == 2 and vertices.shape[1] == 2:
            return floats(vertices, "vertices", lambda j, k: f"vertex {j}.{'xy'[k]}")
        return np.array(polygon_validation.parse_vertices(vertices)).reshape(-1, 2)
    except InvalidShape as error:
        raise InvalidShape(f"{name}: {error}") from None


def points(values: Points, name: str, item: Callable[[int], str]) -> NDArray[np.float64]:
    """Return points as (N, 2) float64; InvalidShape calls the first wrong one item(i), and the argument `name`."""
    if not _is_plain(values):
        return np.array(
            [polygon_validation.parse_point(p, item(i)) for i, p in enumerate(_as_list(values, name))]
        ).reshape(-1, 2)
    if values.ndim != 2 or values.shape[1] != 2:
        raise InvalidShape(f"{name} has the shape {values.shape}: expected (N, 2)")
    return floats(values, name, lambda i, k: f"{item(i)}.{'xy'[k]}")


def boxes(values: Points) -> NDArray[np.float64]:
    """Return boxes (x min, y min, x max, y max) as (N, 4) float64; InvalidShape names the first wrong one."""
    name = "bounds"
    if not _is_plain(values):
        rows = [
            polygon_validation.parse_list(box, f"{name}[{i}]", "4 numbers")
            for i, box in enumerate(_as_list(values, name))
        ]
        for i, row in enumerate(rows):
            if len(row) != 4:
                raise InvalidShape(f"{name}[{i}] has {len(row)} numbers: expected x min, y min, x max, y max")
        values = np.array(rows, object).reshape(-1, 4)
    if values.ndim != 2 or values.shape[1] != 4:
        raise InvalidShape(
            f"{name} has the shape {values.shape}: expected (N, 4), a row x min, y min, x max, y max for each box"
        )
    found = floats(values, name, lambda i, k: f"{name}[{i}][{k}]")
    good = (found[:, 0] <= found[:, 2]) & (found[:, 1] <= found[:, 3])
    if (bad := np.flatnonzero(~good)).size:
        raise InvalidShape(
            f"{name}[{bad[0]}] is {found[bad[0]].tolist()}: expected (x min, y min, x max, y max), min <= max"
        )
    return found


def _as_list(values: Any, name: str) -> list[Any]:
    """Return a sequence as a list; InvalidShape, which calls it `name`, for anything else."""
    return polygon_validation.parse_list(values, name, "a sequence")


def numbers(values: Numbers, name: str, one: str, item: Callable[[int], str]) -> NDArray[np.float64]:
    """Return (N,) float64, or a 0-d array for one number; InvalidShape calls number i item(i), a single one `one`."""
    if _is_plain(values):
        return floats(values, name, lambda *i: item(i[0]) if i else one)
    if isinstance(values, Iterable):
        return np.array([polygon_validation.parse_number(v, item(i)) for i, v in enumerate(_as_list(values, name))])
    return np.array(polygon_validation.parse_number(values, one))


def _is_plain(values: Any) -> bool:
    """Return whether this is an array of any dtype but object; other values are checked one by one."""
    return isinstance(values, np.ndarray) and values.dtype != object


def floats(array: NDArray[Any], name: str, entry: Callable[..., str]) -> NDArray[np.float64]:
    """Return `array` in float64; InvalidShape calls the first wrong value entry(*its indices), and the array `name`."""
    warn_if_flushed()
    polygon_validation.refuse_array(array, name)
    if array.dtype == object:
        each = [polygon_validation.parse_number(value, entry(*at)) for at, value in np.ndenumerate(array)]
        return np.array(each).reshape(array.shape)
    with np.errstate(all="ignore"):
        found = np.asarray(array, np.float64)
    doubtful = ~np.isfinite(found)
    if array.dtype.kind in "iu" and array.dtype.itemsize == 8:
        doubtful |= np.abs(found) >= 2.0**53
    elif array.dtype.itemsize > 8:
        doubtful |= found != array
    for at in np.argwhere(doubtful).tolist() if doubtful.any() else ():
        polygon_validation.parse_number(array[tuple(at)], entry(*at))  # raises for the value at fault
    return found
