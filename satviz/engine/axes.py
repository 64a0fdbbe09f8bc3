"""The choices of axes: a collision method is a choice of axes, and one loop (`sat`) runs them all.

A choice of axes is made by a function (a, b) -> Choice.  `needed` is the engine's own: the
smallest set that is complete for the pair.  The others are the article's
shortcuts and building blocks for choices of the user's own.
"""

from collections.abc import Callable, Iterator, Sequence
from math import gcd, hypot
from typing import Any, NamedTuple

from .geometry import Vec, cyclic_pairs
from .polygon_validation import parse_number, parse_point
from .predicates import IntPoint, orient, to_common_unit, to_float, to_int_points, to_integers
from .shapes import Shape, centroid

__all__ = [
    "Axis",
    "Choice",
    "Skip",
    "Source",
    "centers",
    "directions",
    "edge_normals",
    "edge_normals_of_a",
    "edge_normals_of_b",
    "hull_normals",
    "nearest_vertex",
    "needed",
    "world",
]

EDGE, HULL, WORLD = "edge normal", "hull edge normal", "world"
SLIP = "edge with one sign turned"  # (dx, -dy) for (dy, -dx): no normal, though it is often taken for one
FROM_EDGES = EDGE, HULL, SLIP
CENTERS, VERTEX, CENTROIDS = "centers", "nearest vertex", "centroids"
ANY, GIVEN = "any direction", "given direction"
PARALLEL, NO_DIRECTION, EARLY_EXIT = "parallel", "no direction", "early exit"


class Source(NamedTuple):
    """The source of an axis: an edge, a vertex, a direction.  It names the axis exactly; its numbers may be rounded.

    `kind`: a constant above, such as "edge normal"; `shape`: "A", "B", or None where no single shape gives it; `ids`:
    which of that shape's vertices (an edge's two ends), which world axis (0 for x) or which given direction.
    """

    kind: str
    shape: str | None = None
    ids: tuple[int, ...] = ()


class Axis(NamedTuple):
    """A direction to project on, pointing right (or up), with its source.

    `normal` is the direction as found, not normalised (edge v1v2 of the article's B
    gives (2, 3)); `length` is its length; `direction` is the unit vector.
    """

    normal: Vec
    length: float
    source: Source

    @property
    def direction(self) -> Vec:
        """Return the normal as a unit vector, rounded."""
        return Vec(self.normal.x / self.length, self.normal.y / self.length)


class Skip(NamedTuple):
    """An axis that was not tested, and why: PARALLEL, NO_DIRECTION or EARLY_EXIT.

    `number` counts from 1 and names the axis that this one is parallel to, or the one that separates;
    it is None for NO_DIRECTION.
    """

    axis: Axis
    why: str
    number: int | None = None


class Choice(NamedTuple):
    """The axes to test, in order; those left out; `complete`: whether no gap on these axes proves a hit."""

    axes: tuple[Axis, ...]
    skipped: tuple[Skip, ...] = ()
    complete: bool = False


Chooser = Callable[[Shape, Shape], Choice]

# y first, as in the article
WORLD_AXES = (Axis(Vec(0.0, 1.0), 1.0, Source(WORLD, None, (1,))), Axis(Vec(1.0, 0.0), 1.0, Source(WORLD, None, (0,))))


def needed(a: Shape, b: Shape) -> Choice:
    """Return the smallest complete set of axes for a convex pair; with a concave polygon, all edge normals.

    Two circles: the axis through their centers.  Upright boxes: y and x.  Circle and
    polygon: the polygon's edge normals without parallel repeats, and the nearest
    vertex (without it a circle off a corner is a false hit).  Polygons: edge normals
    without parallel repeats, B's first as in the article.
    """
    if a.core_is_point and b.core_is_point:
        return centers(a, b)
    # y and x are the normals of all eight sides of two upright boxes
    upright = a.is_upright_box and b.is_upright_box
    axes: list[Axis] = list(WORLD_AXES) if upright else []
    number = {(0, 1): 1, (1, 0): 2} if upright else {}
    skipped = []
    for shape, role in (b, "B"), (a, "A"):
        for axis, key in _keyed_normals(shape, role):
            if key in number:
                skipped.append(Skip(axis, PARALLEL, number[key]))
            else:
                axes.append(axis)
                number[key] = len(axes)
    if a.core_is_point or b.core_is_point:
        vertex, skip = _vertex_axis(a, b, number)
        if skip:
            skipped.append(skip)
        else:
            axes.append(vertex)
    return Choice(tuple(axes), tuple(skipped), a.is_convex and b.is_convex)


def world(a: Shape, b: Shape) -> Choice:
    """Return the axes y and x, which is the AABB method; complete for upright boxes only."""
    return Choice(WORLD_AXES, complete=a.is_upright_box and b.is_upright_box)


def edge_normals(a: Shape, b: Shape) -> Choice:
    """Return every edge normal of both shapes, B's first, parallel repeats included; rarely complete for a circle."""
    return _make_choice(_normals(b, "B") + _normals(a, "A"), a, b)


def hull_normals(a: Shape, b: Shape) -> Choice:
    """Return the edge normals of both convex hulls, B's first; if none has a gap, no line separates the polygons."""
    axes: list[Axis] = []
    for shape, role in (b, "B"), (a, "A"):
        hull = _hull_corners(shape.core)
        for i, j in cyclic_pairs(hull):
            axes.append(
                _make_axis(*_integer_edge_normal(shape, role, EDGE if (j - i) % len(shape.core) == 1 else HULL, i, j))
            )
    return _make_choice(tuple(axes), a, b)


def edge_normals_of_a(a: Shape, b: Shape) -> Choice:
    """Return the edge normals of A alone: a shortcut that gives false hits."""
    return _make_choice(_normals(a, "A"), a, b)


def edge_normals_of_b(a: Shape, b: Shape) -> Choice:
    """Return the edge normals of B alone: a shortcut that gives false hits."""
    return _make_choice(_normals(b, "B"), a, b)


def centers(a: Shape, b: Shape) -> Choice:
    """Return the one axis through both centers (of polygons, centroids); complete for two circles, also concentric."""
    circles = a.core_is_point and b.core_is_point
    k, ((px, py), (qx, qy)) = to_int_points((centroid(a), centroid(b)))
    if (px, py) == (qx, qy):
        # concentric: the ranges overlap by the same depth in every direction
        return Choice((Axis(Vec(1.0, 0.0), 1.0, Source(ANY)),), complete=circles)
    return Choice((_make_axis((qx - px, qy - py), k, Source(CENTERS if circles else CENTROIDS)),), complete=circles)


def nearest_vertex(a: Shape, b: Shape) -> Choice:
    """Return the axis through a circle's center and the polygon's nearest vertex; none if they coincide.

    Other pairs have no such axis.
    """
    if a.core_is_point == b.core_is_point:
        return Choice(())
    axis, skip = _vertex_axis(a, b, {})
    return Choice((), (skip,)) if skip else Choice((axis,))


def directions(*vectors: Any) -> Chooser:
    """Return a function that chooses the given (x, y) directions for any pair, as they are, never reversed."""
    axes = tuple(given_axis(vector, i) for i, vector in enumerate(vectors))
    return lambda a, b: Choice(axes)


def given_axis(vector: Any, index: int) -> Axis:
    """Return the axis along `vector`, given by the caller as number `index` (from 0); ValueError for (0, 0)."""
    v = parse_point(vector, f"direction {index}")
    if v == (0, 0):
        raise ValueError(f"direction {index} is (0, 0): an axis needs a direction")
    k, (x, y) = to_integers(v)
    return _make_axis((x, y), k, Source(GIVEN, None, (index,)), as_given=True)


NAMED: dict[str, Chooser] = {
    "needed": needed,
    "world": world,
    "edge-normals": edge_normals,
    "hull-normals": hull_normals,
    "edge-normals-of-a": edge_normals_of_a,
    "edge-normals-of-b": edge_normals_of_b,
    "centers": centers,
    "nearest-vertex": nearest_vertex,
}


def axes_by_source(a: Shape, b: Shape) -> dict[Source, Axis]:
    """Return a dict from source to axis, of all axes that the functions here find for two shapes."""
    choices = [choose(a, b) for choose in (edge_normals, hull_normals, world, centers, nearest_vertex)]
    return {axis.source: axis for c in choices for axis in (*c.axes, *(skip.axis for skip in c.skipped))}


def same_axis(axis: Axis, ours: Axis) -> bool:
    """Return whether two axes have the same normal to the last bit, and almost the same length.

    The length may come from another machine's square root: 2**-46 of it is 128 roundings.
    """
    return axis.normal == ours.normal and abs(axis.length - ours.length) <= ours.length * 2.0**-46


def is_complete(axes: Sequence[Axis], a: Shape, b: Shape) -> bool:
    """Return whether no gap on these axes proves a hit: they include all axes of `needed`, or all edge normals.

    Given directions may happen to be all that are needed; that is not proven, so the answer is False.
    """
    has = {axis.source for axis in axes}
    polygons = all(s.is_convex and not s.core_is_point for s in (a, b))
    if polygons and has >= {axis.source for axis in (*_normals(a, "A"), *_normals(b, "B"))}:
        return True  # upright boxes need none of these
    full = needed(a, b)
    return full.complete and has >= {axis.source for axis in full.axes}


def _make_choice(axes: tuple[Axis, ...], a: Shape, b: Shape) -> Choice:
    """Return the Choice that holds these axes, with `complete` computed."""
    return Choice(axes, complete=is_complete(axes, a, b))


def validate_choice(choice: Choice, a: Shape, b: Shape) -> Choice:
    """Return a caller's choice after checking it; axes and `complete` are recomputed for this pair.

    `complete` is computed, whatever the choice says.  The axes may stand in any order; each axis skipped as
    parallel gets the number of the first chosen axis that it is parallel to.
    ValueError for an axis that these shapes do not have (its source counts,
    not its numbers) and for a skip without a reason; TypeError for anything but Choice, Axis and Skip.
    """
    axes = _require_list(_require_type(choice, Choice).axes)
    left_out = [_require_type(skip, Skip) for skip in _require_list(choice.skipped)]
    every = [_require_type(axis, Axis) for axis in (*axes, *(skip.axis for skip in left_out))]
    known = {} if all(_require_type(axis.source, Source).kind == GIVEN for axis in every) else axes_by_source(a, b)
    chosen = tuple(_recompute_axis(axis, known) for axis in axes)
    skipped = tuple(skip._replace(axis=_recompute_axis(skip.axis, known)) for skip in left_out)
    without_direction = nearest_vertex(a, b).skipped
    if any(skip.axis in chosen for skip in without_direction):
        raise ValueError(
            f"the axis to {without_direction[0].axis.source.shape}'s nearest vertex has no direction, "
            "because the circle's center is on that vertex: leave this axis out"
        )
    complete = bool(known) and is_complete(chosen, a, b)
    return Choice(chosen, tuple(_number_skips(chosen, skipped, without_direction, a, b)), complete)


def _require_type(value: Any, kind: type) -> Any:
    """Return the value if it is an instance of `kind`, a class of this module; TypeError otherwise."""
    if isinstance(value, kind):
        return value
    raise TypeError(f"a choice of axes holds a {type(value).__name__}: expected a satviz.axes.{kind.__name__}")


def _require_list(values: Any) -> Sequence[Any]:
    """Return the values if they are a tuple or a list; TypeError otherwise, since an iterator may never end."""
    if isinstance(values, tuple | list):
        return values
    raise TypeError(f"a choice of axes holds a {type(values).__name__}: expected a tuple or a list")


def _recompute_axis(axis: Axis, known: dict[Source, Axis]) -> Axis:
    """Return the pair's own axis of the same source: from `known`, its `axes_by_source`, or a given direction anew.

    ValueError if there is none, or if its direction or length is another one than that of `axis`.
    """
    source = axis.source
    ours = known.get(source)
    if source.kind == GIVEN and source.shape is None and len(source.ids) == 1:
        index = source.ids[0]
        ours = given_axis(axis.normal, index) if type(index) is int and 0 <= index < 2**53 else None
    if ours is None or not same_axis(axis._replace(length=parse_number(axis.length, "the length of an axis")), ours):
        raise ValueError(
            f"{str(source.kind)[:40]} of {source.shape or 'both shapes'}, vertices {str(source.ids)[:40]}, "
            "is not an axis of these shapes: choose the axes for these two shapes"
        )
    return ours


def _number_skips(
    axes: Sequence[Axis], skipped: Sequence[Skip], without_direction: Sequence[Skip], a: Shape, b: Shape
) -> Iterator[Skip]:
    """Yield `skipped`, each parallel one with the number of the axis in `axes` it repeats; ValueError if one is false.

    `without_direction`: the only skips for which NO_DIRECTION is true in this pair.
    """
    if not skipped:
        return
    corners = {role: {v: i for i, v in enumerate(shape.corner_ids)} for role, shape in (("A", a), ("B", b))}
    keys = {axis: _parallel_key(axis, a, b, corners) for axis in {*axes, *(skip.axis for skip in skipped)}}
    first: dict[IntPoint, int] = {}
    for i, axis in enumerate(axes, 1):
        first.setdefault(keys[axis], i)
    not_parallel = {*axes, *(skip.axis for skip in without_direction)}
    for skip in skipped:
        if skip in without_direction:
            yield skip
        elif skip.why == PARALLEL and keys[skip.axis] in first and skip.axis not in not_parallel:
            yield skip._replace(number=first[keys[skip.axis]])
        else:
            raise ValueError(
                f"axis {skip.axis.source} is skipped for the reason {skip.why!r}, which is false here: test it too"
            )


def _parallel_key(axis: Axis, a: Shape, b: Shape, corners: dict[str, dict[int, int]]) -> IntPoint:
    """Return an integer vector that two axes share exactly if they are parallel.

    `corners`: for "A" and "B", the index in the core of each vertex number.
    """
    kind, role, ids = axis.source
    if role and kind in (EDGE, HULL):
        i, j = (corners[role][v] for v in ids)
        return _direction_key(*_integer_edge_normal(a if role == "A" else b, role, kind, i, j)[0])
    if kind in (CENTERS, VERTEX):
        return _direction_key(*exact_dots(a, b, axis).normal)
    _, (x, y) = to_integers(axis.normal)
    return _direction_key(x, y)


class ExactDots(NamedTuple):
    """The dot products of both cores with an axis, in integers: a point lands at dot / |normal|, in units of 2**-k.

    `normal`: the axis as an integer vector; `a`, `b`: one product for each point of the core of A and of B.
    """

    normal: IntPoint
    a: list[int]
    b: list[int]
    radii: int  # the sum of both radii, in units of 2**-k
    k: int


def exact_dots(a: Shape, b: Shape, axis: Axis) -> ExactDots:
    """Return the exact dot products of both cores (corners, or a center) with the exact vector of an axis's source."""
    core_a, core_b, radii, k = to_common_unit(a, b)
    kind, role, ids = axis.source
    shape, core, other = (a, core_a, core_b) if role == "A" else (b, core_b, core_a)
    x = y = 0
    if kind in (EDGE, HULL):
        (px, py), (qx, qy) = (core[shape.corner_ids.index(v)] for v in ids)
        x, y = qy - py, px - qx
    elif kind == SLIP:
        (px, py), (qx, qy) = (core[shape.corner_ids.index(v)] for v in ids)
        x, y = qx - px, py - qy
    elif kind == CENTERS:
        (px, py), (qx, qy) = core_a[0], core_b[0]
        x, y = qx - px, qy - py
    elif kind == VERTEX:
        (vx, vy), (cx, cy) = core[shape.corner_ids.index(ids[0])], other[0]
        x, y = cx - vx, cy - vy
    if not (x or y):
        _, (x, y) = to_integers(axis.normal)
    elif (x, y) < (0, 0):
        x, y = -x, -y
    dots_a, dots_b = ([x * px + y * py for px, py in core] for core in (core_a, core_b))
    return ExactDots((x, y), dots_a, dots_b, radii, k)


def _hull_corners(ring: Sequence[Vec]) -> list[int]:
    """Return the corner numbers of the convex hull, counter-clockwise, by Andrew's monotone chain with exact signs."""
    order = sorted(range(len(ring)), key=ring.__getitem__)

    def chain(ids: Sequence[int]) -> list[int]:
        """Return the half of the hull to the right of the path through these corners, without its last corner."""
        kept: list[int] = []
        for i in ids:
            while len(kept) > 1 and orient(ring[kept[-2]], ring[kept[-1]], ring[i]) <= 0:
                kept.pop()
            kept.append(i)
        return kept[:-1]

    return chain(order) + chain(order[::-1])


def _make_axis(normal: IntPoint, k: int, source: Source, *, as_given: bool = False) -> Axis:
    """Return the axis along an integer vector in units of 2**-k, reversed if needed to point right or up.

    `as_given`: keep the direction as it is.
    """
    x, y = normal
    if not as_given and (x, y) < (0, 0):
        x, y = -x, -y
    size = max(x.bit_length(), y.bit_length())
    if abs(size - k) > 300:
        k = size  # a direction has no size: bring extreme ones near 1, where lengths neither overflow nor vanish
        if as_given:  # but no nearer than where its last bit is the smallest float
            k = min(k, ((x | y) & -(x | y)).bit_length() + 1073)
    vector = Vec(to_float(x, k), to_float(y, k))
    return Axis(vector, hypot(*vector), source)


def _integer_edge_normal(shape: Shape, role: str, kind: str, i: int, j: int) -> tuple[IntPoint, int, Source]:
    """Return (integer normal, k, source) of the edge from corner i to j, as `_make_axis` takes them.

    `role`: "A" or "B", the shape's place in the pair; `kind`: EDGE or HULL.
    """
    k, points, _ = shape.integers
    (px, py), (qx, qy) = points[i], points[j]
    return (qy - py, px - qx), k, Source(kind, role, tuple(sorted((shape.corner_ids[i], shape.corner_ids[j]))))


def _keyed_normals(shape: Shape, role: str) -> tuple[tuple[Axis, IntPoint], ...]:
    """Return (axis, its `_direction_key`) for each edge normal, computed once for each shape and role.

    Parallel edges have equal keys.
    """

    def compute() -> tuple[tuple[Axis, IntPoint], ...]:
        """Return the pairs, which `cached` stores."""
        made = (_integer_edge_normal(shape, role, EDGE, *ends) for ends in cyclic_pairs(range(len(shape.corner_ids))))
        return tuple((_make_axis(*one), _direction_key(*one[0])) for one in made)

    return shape.cached(role, compute)


def _direction_key(x: int, y: int) -> IntPoint:
    """Return the shortest integer vector on the same line, pointing right (or up)."""
    common = gcd(x, y)
    return (x // common, y // common) if (x, y) > (0, 0) else (-x // common, -y // common)


def _normals(shape: Shape, role: str) -> tuple[Axis, ...]:
    """Return the edge normals of a shape as axes; `role`: "A" or "B", the shape's place in the pair."""
    return tuple(axis for axis, _ in _keyed_normals(shape, role))


def _vertex_axis(a: Shape, b: Shape, number: dict[IntPoint, int]) -> tuple[Axis, Skip | None]:
    """Return (axis from the polygon's nearest vertex to the circle's center, the Skip that says why it is left out).

    The Skip is None if the axis is needed.  `number`: the number of each axis already chosen, by its `_direction_key`.
    """
    role, polygon = ("B", b) if a.core_is_point else ("A", a)
    core_a, core_b, _, k = to_common_unit(a, b)
    ring, ((cx, cy),) = (core_b, core_a) if a.core_is_point else (core_a, core_b)
    i = min(range(len(ring)), key=lambda i: (cx - ring[i][0]) ** 2 + (cy - ring[i][1]) ** 2)
    source = Source(VERTEX, role, (polygon.corner_ids[i],))
    x, y = cx - ring[i][0], cy - ring[i][1]
    if not (x or y):
        nowhere = Axis(Vec(1.0, 0.0), 1.0, source)
        return nowhere, Skip(nowhere, NO_DIRECTION)
    axis, key = _make_axis((x, y), k, source), _direction_key(x, y)
    return axis, Skip(axis, PARALLEL, number[key]) if key in number else None
