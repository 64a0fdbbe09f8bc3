"""The choices of axes: a method is a choice of axes, and one loop runs them all.

A choice is a function (a, b) -> Choice.  `needed` is the engine's own: the
smallest set that is complete for the pair.  The others are the article's
shortcuts and the building blocks of a choice of one's own.
"""

from collections.abc import Callable, Iterator, Sequence
from math import gcd, hypot
from typing import Any, NamedTuple

from .geometry import Vec
from .polygon_validation import number, point
from .predicates import IntPoint, aligned, orient, to_float, to_int_points, to_integers
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
    """Where an axis comes from: its kind, whose ("A", "B" or None) and which of the owner's vertices."""

    kind: str
    shape: str | None = None
    ids: tuple[int, ...] = ()


class Axis(NamedTuple):
    """A direction to project on, pointing right (or up), and where it comes from.

    `normal` is the direction as found, not normalised (edge v1v2 of the article's B
    gives (2, 3)); `length` its length; `direction` the unit vector.
    """

    normal: Vec
    length: float
    source: Source

    @property
    def direction(self) -> Vec:
        """The normal as a unit vector, rounded."""
        return Vec(self.normal.x / self.length, self.normal.y / self.length)


class Skip(NamedTuple):
    """An axis that was not tested, and why: one of the three reasons above.

    `number`: of the axis, from 1, that it is parallel to or that separates; None where no other axis is the reason.
    """

    axis: Axis
    why: str
    number: int | None = None


class Choice(NamedTuple):
    """Axes in the order to test them, those left out, and whether no gap on these proves a hit."""

    axes: tuple[Axis, ...]
    skipped: tuple[Skip, ...] = ()
    complete: bool = False


Chooser = Callable[[Shape, Shape], Choice]

# y first, as in the article
WORLD_AXES = (Axis(Vec(0.0, 1.0), 1.0, Source(WORLD, None, (1,))), Axis(Vec(1.0, 0.0), 1.0, Source(WORLD, None, (0,))))


def needed(a: Shape, b: Shape) -> Choice:
    """The smallest complete set for this pair; for a concave polygon, of the pair's outlines.

    Two circles: the axis through their centers.  Upright boxes: y and x.  Circle and
    polygon: the polygon's edge normals without parallel repeats, and the nearest
    vertex (without it a circle off a corner is a false hit).  Polygons: edge normals
    without parallel repeats, B's first as in the article.
    """
    if a.core_is_point and b.core_is_point:
        return centers(a, b)
    # which side of a rectangle gives which axis does not matter: y and x serve all eight
    upright = a.is_upright_box and b.is_upright_box
    axes: list[Axis] = list(WORLD_AXES) if upright else []
    number = {(0, 1): 1, (1, 0): 2} if upright else {}
    skipped = []
    for shape, role in (b, "B"), (a, "A"):
        for axis, key in _keyed_normals_of(shape, role):
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
    """y and x: the AABB method; complete for upright boxes only."""
    return Choice(WORLD_AXES, complete=a.is_upright_box and b.is_upright_box)


def edge_normals(a: Shape, b: Shape) -> Choice:
    """Every edge normal of both shapes, B's first, parallel repeats included; for a circle rarely complete."""
    return _make_choice(_normals(b, "B") + _normals(a, "A"), a, b)


def hull_normals(a: Shape, b: Shape) -> Choice:
    """The edge normals of both convex hulls, B's first; no gap on these proves that no line separates the polygons."""
    axes: list[Axis] = []
    for shape, role in (b, "B"), (a, "A"):
        hull = _hull_corners(shape.core)
        for i, j in zip(hull, [*hull[1:], *hull[:1]], strict=True):
            axes.append(
                _make_axis(*_integer_edge_normal(shape, role, EDGE if (j - i) % len(shape.core) == 1 else HULL, i, j))
            )
    return _make_choice(tuple(axes), a, b)


def edge_normals_of_a(a: Shape, b: Shape) -> Choice:
    """A's edge normals only: a shortcut that gives false hits."""
    return _make_choice(_normals(a, "A"), a, b)


def edge_normals_of_b(a: Shape, b: Shape) -> Choice:
    """B's edge normals only: a shortcut that gives false hits."""
    return _make_choice(_normals(b, "B"), a, b)


def centers(a: Shape, b: Shape) -> Choice:
    """The one axis through both centers (polygons: centroids); complete for two circles, also concentric."""
    circles = a.radius > 0 and b.radius > 0
    k, ((px, py), (qx, qy)) = to_int_points((centroid(a), centroid(b)))
    if (px, py) == (qx, qy):
        # concentric: no direction is special, and on every one the ranges overlap by as much
        return Choice((Axis(Vec(1.0, 0.0), 1.0, Source(ANY)),), complete=circles)
    return Choice((_make_axis((qx - px, qy - py), k, Source(CENTERS if circles else CENTROIDS)),), complete=circles)


def nearest_vertex(a: Shape, b: Shape) -> Choice:
    """The axis from a circle's center to the polygon's nearest vertex; no axis for other pairs."""
    if a.core_is_point == b.core_is_point:
        return Choice(())
    axis, skip = _vertex_axis(a, b, {})
    return Choice((), (skip,)) if skip else Choice((axis,))


def directions(*vectors: Any) -> Chooser:
    """A choice of the given (x, y) directions, taken exactly as given and not turned round."""
    axes = tuple(given_axis(vector, i) for i, vector in enumerate(vectors))
    return lambda a, b: Choice(axes)


def given_axis(vector: Any, index: int) -> Axis:
    """The axis along the direction that was given as number 0, 1, ...; ValueError for what is none."""
    v = point(vector, f"direction {index}")
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
    """Every axis that these shapes have of themselves, by where it comes from."""
    choices = [choose(a, b) for choose in (edge_normals, hull_normals, world, centers, nearest_vertex)]
    return {axis.source: axis for c in choices for axis in (*c.axes, *(skip.axis for skip in c.skipped))}


def same_axis(axis: Axis, ours: Axis) -> bool:
    """Is it this axis, to the last bit of its normal?  Its length may come from another machine's square root."""
    return axis.normal == ours.normal and abs(axis.length - ours.length) <= ours.length * 2.0**-46


def is_complete(axes: Sequence[Axis], a: Shape, b: Shape) -> bool:
    """Does no gap on these axes prove a hit?  It does if they have all axes of `needed`, or all edge normals.

    Of other axes nothing is proven: directions that were given may be all that are needed by chance.
    """
    has = {axis.source for axis in axes}
    if _convex_polygons(a, b) and has >= {axis.source for axis in (*_normals(a, "A"), *_normals(b, "B"))}:
        return True  # upright boxes need none of these
    full = needed(a, b)
    return full.complete and has >= {axis.source for axis in full.axes}


def _make_choice(axes: tuple[Axis, ...], a: Shape, b: Shape) -> Choice:
    return Choice(axes, complete=is_complete(axes, a, b))


def validate_choice(choice: Choice, a: Shape, b: Shape) -> Choice:
    """A choice of someone else's as it serves this pair; whether it is complete is worked out, whatever it says.

    In any order: those left out as parallel are given the number of the first axis that they are parallel to.
    ValueError for an axis that these shapes do not have (exactly: an axis is where it comes from,
    not its numbers), and for one left out for no reason; TypeError for what is no Choice, Axis or Skip.
    """
    axes = _require_list(_require_type(choice, Choice).axes)
    left_out = [_require_type(skip, Skip) for skip in _require_list(choice.skipped)]
    every = [_require_type(axis, Axis) for axis in (*axes, *(skip.axis for skip in left_out))]
    known = {} if all(_require_type(axis.source, Source).kind == GIVEN for axis in every) else axes_by_source(a, b)
    chosen = tuple(_recompute_axis(axis, known) for axis in axes)
    skipped = tuple(skip._replace(axis=_recompute_axis(skip.axis, known)) for skip in left_out)
    nowhere = nearest_vertex(a, b).skipped
    if any(skip.axis in chosen for skip in nowhere):
        raise ValueError(f"{nowhere[0].axis.source} has no direction: the center is on that vertex")
    complete = bool(known) and is_complete(chosen, a, b)
    return Choice(chosen, tuple(_number_skips(chosen, skipped, nowhere, a, b)), complete)


def _require_type(value: Any, kind: type) -> Any:
    if isinstance(value, kind):
        return value
    raise TypeError(f"a choice of axes holds a {type(value).__name__}: expected a satviz.axes.{kind.__name__}")


def _require_list(values: Any) -> Sequence[Any]:
    """What is listed may be long, but not without end."""
    if isinstance(values, tuple | list):
        return values
    raise TypeError(f"a choice of axes holds a {type(values).__name__}: expected a tuple or a list")


def _recompute_axis(axis: Axis, known: dict[Source, Axis]) -> Axis:
    """The same axis, in the numbers that these shapes give, or that a given direction has."""
    source = axis.source
    ours = known.get(source)
    if source.kind == GIVEN and source.shape is None and len(source.ids) == 1 and _is_index(source.ids[0]):
        ours = given_axis(axis.normal, source.ids[0])
    if ours is None or not same_axis(axis._replace(length=number(axis.length, "the length of an axis")), ours):
        raise ValueError(f"{source} is no axis of these shapes: choose the axes for this very pair")
    return ours


def _is_index(value: Any) -> bool:
    return type(value) is int and 0 <= value < 2**53


def _number_skips(
    axes: Sequence[Axis], skipped: Sequence[Skip], nowhere: Sequence[Skip], a: Shape, b: Shape
) -> Iterator[Skip]:
    if not skipped:
        return
    corners = {role: {v: i for i, v in enumerate(shape.corner_ids)} for role, shape in (("A", a), ("B", b))}
    ways = {axis: _parallel_key(axis, a, b, corners) for axis in {*axes, *(skip.axis for skip in skipped)}}
    first: dict[IntPoint, int] = {}
    for i, axis in enumerate(axes, 1):
        first.setdefault(ways[axis], i)
    elsewhere = {*axes, *(skip.axis for skip in nowhere)}
    for skip in skipped:
        if skip in nowhere:
            yield skip
        elif skip.why == PARALLEL and ways[skip.axis] in first and skip.axis not in elsewhere:
            yield skip._replace(number=first[ways[skip.axis]])
        else:
            raise ValueError(f"{skip.axis.source} is left out as {skip.why!r}, which it is not")


def _parallel_key(axis: Axis, a: Shape, b: Shape, corners: dict[str, dict[int, int]]) -> IntPoint:
    """A key that is equal exactly for parallel axes; `corners`: where each vertex stands among its shape's corners."""
    kind, role, ids = axis.source
    if role and kind in (EDGE, HULL):
        i, j = (corners[role][v] for v in ids)
        return _direction_key(*_integer_edge_normal(a if role == "A" else b, role, kind, i, j)[0])
    if kind in (CENTERS, VERTEX):
        return _direction_key(*exact_dots(a, b, axis).normal)
    _, (x, y) = to_integers(axis.normal)
    return _direction_key(x, y)


class ExactDots(NamedTuple):
    """Both cores on an axis, in integers: where a point lies is its dot / |normal|, in units of 2**-k."""

    normal: IntPoint
    a: list[int]
    b: list[int]
    radii: int  # the sum of both radii
    k: int


def exact_dots(a: Shape, b: Shape, axis: Axis) -> ExactDots:
    """Both cores dropped on the axis as its source tells it, without the rounding of its `normal`."""
    core_a, core_b, radii, k = aligned(a, b)
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
    """Which corners are on the convex hull, counter-clockwise: Andrew's monotone chain with exact turns."""
    order = sorted(range(len(ring)), key=ring.__getitem__)

    def chain(ids: Sequence[int]) -> list[int]:
        kept: list[int] = []
        for i in ids:
            while len(kept) > 1 and orient(ring[kept[-2]], ring[kept[-1]], ring[i]) <= 0:
                kept.pop()
            kept.append(i)
        return kept[:-1]

    return chain(order) + chain(order[::-1])


def _convex_polygons(a: Shape, b: Shape) -> bool:
    return all(s.is_convex and not s.core_is_point for s in (a, b))


def _make_axis(normal: IntPoint, k: int, source: Source, *, as_given: bool = False) -> Axis:
    """The axis along an integer vector, not (0, 0), in units of 2**-k."""
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
    """The normal of the edge from one corner to another, as `_axis` takes it."""
    k, points, _ = shape.integers
    (px, py), (qx, qy) = points[i], points[j]
    return (qy - py, px - qx), k, Source(kind, role, tuple(sorted((shape.corner_ids[i], shape.corner_ids[j]))))


def _keyed_normals_of(shape: Shape, role: str) -> tuple[tuple[Axis, IntPoint], ...]:
    """Each edge's normal with a key that is equal exactly for parallel edges; kept on the shape."""
    return shape.kept(role, lambda: tuple(_keyed_normals(shape, role)))


def _keyed_normals(shape: Shape, role: str) -> Iterator[tuple[Axis, IntPoint]]:
    n = len(shape.corner_ids)
    for i in range(n):
        normal, k, source = _integer_edge_normal(shape, role, EDGE, i, (i + 1) % n)
        yield _make_axis(normal, k, source), _direction_key(*normal)


def _direction_key(x: int, y: int) -> IntPoint:
    """The shortest integer vector on the same line, pointing right (or up)."""
    common = gcd(x, y)
    return (x // common, y // common) if (x, y) > (0, 0) else (-x // common, -y // common)


def _normals(shape: Shape, role: str) -> tuple[Axis, ...]:
    return tuple(axis for axis, _ in _keyed_normals_of(shape, role))


def _vertex_axis(a: Shape, b: Shape, number: dict[IntPoint, int]) -> tuple[Axis, Skip | None]:
    """The axis between a circle's center and the polygon's nearest vertex, and why it is left out if it is."""
    role, polygon = ("B", b) if a.core_is_point else ("A", a)
    core_a, core_b, _, k = aligned(a, b)
    ring, ((cx, cy),) = (core_b, core_a) if a.core_is_point else (core_a, core_b)
    i = min(range(len(ring)), key=lambda i: (cx - ring[i][0]) ** 2 + (cy - ring[i][1]) ** 2)
    source = Source(VERTEX, role, (polygon.corner_ids[i],))
    x, y = cx - ring[i][0], cy - ring[i][1]
    if not (x or y):
        nowhere = Axis(Vec(1.0, 0.0), 1.0, source)
        return nowhere, Skip(nowhere, NO_DIRECTION)
    axis, key = _make_axis((x, y), k, source), _direction_key(x, y)
    return axis, Skip(axis, PARALLEL, number[key]) if key in number else None
