"""The checks that every outline must pass, with exact predicates: numbers, repeated vertices, turns, crossings.

A parameter `name` is what an error message calls the value.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from itertools import pairwise
from reprlib import Repr
from typing import Any, NamedTuple

from .geometry import InvalidShape, Vec, cyclic_pairs, cyclic_triples
from .predicates import orient, warn_if_flushed
from .sweep import sweep


class Corners(NamedTuple):
    """The corners of an outline as the engine uses them: counter-clockwise, without repeated and collinear vertices."""

    ids: tuple[int, ...]  # the number of each corner's vertex
    convex: bool
    notes: tuple[str, ...]  # a sentence for each vertex left out


_NOT_REAL = tuple("bcSUmMV")  # NumPy's kinds: bool, complex, text, times, records
_WHOLE = ("i", "u")  # NumPy's kinds of integers
_REPR = Repr()
_REPR.maxlevel, _REPR.maxstring, _REPR.maxother = 3, 60, 100
short_repr = _REPR.repr  # a shortened repr of a value, for an error message


def _dtype_kind(value: Any) -> str:
    """Return NumPy's letter for the kind of an array's numbers; "" for anything that is not from NumPy."""
    return getattr(getattr(value, "dtype", None), "kind", "")


def parse_number(value: Any, name: str) -> float:
    """Return one finite float64 equal to the value; InvalidShape for bool, text, complex and inexact integers."""
    if type(value) is not float:
        if getattr(value, "mask", False):
            raise InvalidShape(f"{name} is masked: fill or drop it first")
        given = value
        if getattr(value, "shape", ()) != ():
            raise InvalidShape(f"{name} is {short_repr(value)}: a coordinate must be one real number")
        if _dtype_kind(value) in _WHOLE:
            value = int(value)  # a NumPy integer compares in float64, which hides what it loses
        # float() accepts an array of one object, whatever the object is
        if isinstance(value, (bool, str, bytes, complex)) or _dtype_kind(value) in (*_NOT_REAL, "O"):
            raise InvalidShape(f"{name} is {short_repr(given)}: a coordinate must be a real number")
        try:
            as_float = float(value)
        except (TypeError, ValueError):
            raise InvalidShape(f"{name} is {short_repr(value)}: a coordinate must be a real number") from None
        except OverflowError:
            raise InvalidShape(f"{name} is too large for float64: scale the scene down") from None
        if as_float != value and as_float == as_float:
            raise InvalidShape(
                f"{name} is {short_repr(value)}, which float64 cannot hold (nearest {as_float!r}): "
                "round or scale it first"
            )
        value = as_float
    if not math.isfinite(value):
        raise InvalidShape(f"{name} is {value}: numbers must be finite")
    return float(value)


def parse_point(value: Any, name: str) -> Vec:
    """Return a pair of finite numbers as a Vec; InvalidShape for anything else."""
    try:
        x, y = to_lists(value, name)
    except (TypeError, ValueError) as error:
        if isinstance(error, InvalidShape):
            raise
        raise InvalidShape(f"{name} is {short_repr(value)}: expected a pair (x, y)") from None
    return Vec(parse_number(x, f"{name}.x"), parse_number(y, f"{name}.y"))


def to_lists(values: Any, name: str) -> Any:
    """Return an array as nested lists of Python numbers, other values unchanged; InvalidShape for text, sets, dicts."""
    if isinstance(values, (str, bytes, dict, set, frozenset)) or getattr(values, "ndim", 1) == 0:
        raise InvalidShape(f"{name} is {short_repr(values)}: expected a list or an array of numbers")
    if hasattr(values, "tolist"):
        refuse_array(values, name)
        return values.tolist()
    return values


def refuse_array(array: Any, name: str) -> None:
    """Raise InvalidShape for an array that does not hold real numbers or has masked entries."""
    if _dtype_kind(array) in _NOT_REAL:
        raise InvalidShape(f"{name} is an array of {array.dtype}: coordinates must be real numbers")
    refuse_masked(array, name)


def refuse_masked(array: Any, name: str) -> None:
    """Raise InvalidShape for an array with masked entries, whose hidden values NumPy would mostly use."""
    mask = getattr(array, "mask", None)
    if mask is not None and getattr(mask, "any", bool)():
        raise InvalidShape(f"{name} has masked entries: fill or drop them first")


def parse_vertices(values: Any) -> tuple[Vec, ...]:
    """Return the vertices in the given order, from nested sequences, arrays or `__geo_interface__`."""
    try:
        interface = getattr(values, "__geo_interface__", None)
    except Exception as error:
        raise InvalidShape(f"__geo_interface__ fails: {short_repr(error)}: pass the vertices themselves") from error
    if interface is None:
        return _parse_points(values, "vertices")
    rings = _geo_rings(interface)
    if not rings:
        raise InvalidShape("the polygon is empty: it needs at least 3 distinct vertices")
    points = _parse_points(rings[0], "the outer ring")
    if len(rings) > 1:
        raise InvalidShape("the polygon has holes: pass its outer ring, or split it into parts without holes")
    return points


def _parse_points(values: Any, name: str) -> tuple[Vec, ...]:
    """Return the points of a sequence of pairs; InvalidShape names the vertex at fault."""
    return tuple(
        parse_point(v, f"vertex {i}") for i, v in enumerate(parse_list(values, name, "a sequence of (x, y) pairs"))
    )


def parse_list(values: Any, name: str, expected: str) -> list[Any]:
    """Return the items of an iterable as a list; InvalidShape says what was `expected` instead of `values`."""
    warn_if_flushed()
    values = to_lists(values, name)
    if not isinstance(values, Iterable) or isinstance(values, type):
        raise InvalidShape(f"{name} is {short_repr(values)}: expected {expected}")
    return list(values)


def _geo_rings(interface: Any) -> list[Any]:
    """Return the rings of a `__geo_interface__` dict: Polygon, LinearRing or Feature with one; else InvalidShape."""
    name = "__geo_interface__"
    if _geo_type(interface) == "Feature":
        interface, name = interface.get("geometry"), "the Feature's geometry"
    if not isinstance(interface, Mapping):
        raise InvalidShape(f"{name} is {short_repr(interface)}: expected a dict with type and coordinates")
    kind, held = _geo_type(interface), interface.get("coordinates")
    if not kind:
        raise InvalidShape(f"{name} has no type: expected a dict with type and coordinates")
    if kind not in ("Polygon", "LinearRing"):
        raise InvalidShape(f"a {kind} is not a polygon: pass one Polygon at a time")
    return [held] if kind == "LinearRing" else parse_list(held, "coordinates", "a sequence of (x, y) pairs")


def _geo_type(interface: Any) -> str:
    """Return the value under the key "type" of a GeoJSON-like mapping; "" if it has none."""
    kind = interface.get("type") if isinstance(interface, Mapping) else ""
    return kind if isinstance(kind, str) else ""


def find_corners(points: Sequence[Vec]) -> Corners:
    """Return the Corners of an outline; InvalidShape unless it is simple, winds once and has an area.

    The first edge stays first: a clockwise outline is walked backwards from it.
    """
    ring, notes = _without_repeats(points)
    if len({points[i] for i in ring}) < 3:
        raise InvalidShape(f"{len(set(points))} distinct vertices: a polygon needs at least 3")
    turns = []
    for before, i, after in cyclic_triples(ring):
        turn = orient(points[before], points[i], points[after])
        if turn == 0 and _turns_back(points[before], points[i], points[after]):
            if _is_flat(points, ring):
                raise InvalidShape("all vertices lie on one line: a polygon needs a positive area; move one off it")
            raise InvalidShape(f"the outline turns back on itself at vertex {i} (a spike): remove that vertex")
        turns.append(turn)
    notes += [f"vertex {i} lies straight on between its neighbours" for i, turn in zip(ring, turns) if turn == 0]
    kept = [i for i, turn in zip(ring, turns) if turn]
    bends = {turn for turn in turns if turn}
    convex = len(bends) == 1 and _winds_once([points[i] for i in kept])
    if not convex:
        refuse_crossings([points[i] for i in ring], ring)
    lowest = min(range(len(kept)), key=lambda j: points[kept[j]])
    # the outline turns at its lowest corner in the direction of its winding, since no vertex lies beyond that corner
    if next(t for i, t in zip(ring, turns) if i == kept[lowest]) < 0:
        kept = [kept[1], kept[0], *kept[:1:-1]]
    return Corners(tuple(kept), convex, tuple(notes))


def _without_repeats(points: Sequence[Vec]) -> tuple[list[int], list[str]]:
    """Return (vertex numbers without repeated neighbours, one sentence for each vertex left out)."""
    ring: list[int] = []
    notes = []
    for i, p in enumerate(points):
        if ring and points[ring[-1]] == p:
            notes.append(f"vertex {i} repeats vertex {ring[-1]}: merged")
        else:
            ring.append(i)
    while len(ring) > 1 and points[ring[-1]] == points[ring[0]]:
        notes.append(f"vertex {ring.pop()} closes the outline on vertex {ring[0]}: merged")
    return ring, notes


def _turns_back(before: Vec, here: Vec, after: Vec) -> bool:
    """Return whether, of three points on one line, the way goes back at the second; exact in floats."""
    return (here > before) != (after > here)


def _is_flat(points: Sequence[Vec], ring: Sequence[int]) -> bool:
    """Return whether all vertices lie on one line; `ring`: the numbers of the vertices to check."""
    first, second = points[ring[0]], points[ring[1]]
    return all(orient(first, second, points[i]) == 0 for i in ring)


def _winds_once(ring: Sequence[Vec]) -> bool:
    """Return whether a ring that turns one way everywhere goes round once (a pentagram goes round twice)."""
    rising = [q > p for p, q in cyclic_pairs(ring)]
    return sum(r != s for r, s in cyclic_pairs(rising)) == 2


def refuse_crossings(ring: Sequence[Vec], ids: Sequence[int]) -> None:
    """Raise InvalidShape if two edges that are not neighbours meet; `ids`: each point's vertex number.

    Source: Shamos and Hoey (1976).  Of the edges that meet furthest left, two lie directly
    above each other just before, so only such edges are compared.
    """
    n = len(ring)
    for event in sweep(ring):
        if event.touched is None:
            row = [e for e in (event.below, *event.begun, event.above) if e is not None]
        else:
            row = [event.touched, event.vertex]
        for j, i in pairwise(row):
            p, q, r, s = ring[i], ring[(i + 1) % n], ring[j], ring[(j + 1) % n]
            if (i - j) % n in (1, n - 1) or not _segments_meet(p, q, r, s):
                continue
            first, second = sorted((ids[i], ids[j]))
            x, y = (c + 0.0 for c in _meeting_point(p, q, r, s))  # -0.0 becomes 0.0
            raise InvalidShape(
                f"edges {first} and {second} cross near ({x:.6g}, {y:.6g}): "
                "an outline must not cross or touch itself; reorder the vertices"
            )


def _segments_meet(p: Vec, q: Vec, r: Vec, s: Vec) -> bool:
    """Return whether the closed segments pq and rs, which one sweep line meets, share a point.

    If both lie on one line, they always do, so the orientations decide.
    """
    return orient(p, q, r) * orient(p, q, s) <= 0 and orient(r, s, p) * orient(r, s, q) <= 0


def _meeting_point(p: Vec, q: Vec, r: Vec, s: Vec) -> Vec:
    """Return a point that the meeting segments pq and rs share; in fractions, since float products may overflow."""
    (px, py), (qx, qy), (rx, ry), (sx, sy) = (map(Fraction, v) for v in (p, q, r, s))
    dx, dy, ex, ey = qx - px, qy - py, sx - rx, sy - ry
    det = dx * ey - dy * ex
    if not det:  # both on one line
        return max(min(p, q), min(r, s))
    t = ((rx - px) * ey - (ry - py) * ex) / det
    return Vec(float(px + t * dx), float(py + t * dy))
