"""Polygon and Circle: validated once when they are made and immutable afterwards; vertex order and labels are kept."""

import math
from collections.abc import Callable, Sequence
from itertools import chain, pairwise
from typing import Any, ClassVar, TypeVar

from . import hooks, polygon_validation
from .geometry import InvalidShape, Vec, cyclic_pairs
from .predicates import IntPoint, to_integers, warn_if_flushed

INF = math.inf
T = TypeVar("T")
Slab = tuple[float, float, float, float, tuple[tuple[Vec, Vec], ...]]  # nx, ny, lo, hi, edges: drawn in `relate`


class _Shape:
    """The base class of Polygon and Circle: the points within `radius` of `core`, and values derived from them."""

    __slots__ = (
        "_cache",
        "bounds",
        "core",
        "is_convex",
        "is_upright_box",
        "max_coordinate",
        "max_edge_component",
        "radius",
        "slabs",
    )

    core: tuple[Vec, ...]  # a polygon's corners, or a circle's center
    radius: float  # 0 for a polygon
    is_convex: bool
    is_upright_box: bool  # a rectangle with sides along x and y
    # bounding box: x min, y min, x max, y max; a circle's is rounded outwards
    bounds: tuple[float, float, float, float]
    max_coordinate: float  # the largest absolute coordinate of any point of the shape
    max_edge_component: float  # the largest absolute x or y component of an edge; a circle's radius
    slabs: tuple[Slab, ...] | None  # one per edge direction, see _slabs; None for circles and concave polygons
    _cache: dict[str, Any]  # values computed at first use: integers, axes, convex parts

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError(f"a {type(self).__name__} cannot be changed: make a new one")

    def __delattr__(self, name: str) -> None:
        self.__setattr__(name, None)

    def _set(self, **values: Any) -> None:
        """Set attributes, though the shape is immutable; called by `__init__` alone."""
        for name, value in values.items():
            object.__setattr__(self, name, value)

    def cached(self, name: str, compute: Callable[[], T]) -> T:
        """Return the stored value of this name; at the first use, call `compute` and store its result."""
        if name not in self._cache:
            self._cache[name] = compute()
        value: T = self._cache[name]
        return value

    def _arguments(self) -> tuple[object, ...]:
        """Return the arguments of `__init__` that make an equal shape."""
        raise NotImplementedError

    def __eq__(self, other: object) -> bool:
        return type(other) is type(self) and self._arguments() == other._arguments()

    def __hash__(self) -> int:
        return hash(self._arguments())

    def __reduce__(self) -> tuple[type, tuple[object, ...]]:
        return type(self), self._arguments()

    def __repr__(self) -> str:
        arguments = [repr(_to_lists(value)) for value in self._arguments() if value is not None]
        return f"{type(self).__name__}({', '.join(arguments)})"

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, str]:
        """Return what a notebook shows: the repr and a picture."""
        return hooks.mime_bundle(self)

    @property
    def integers(self) -> tuple[int, list[IntPoint], int]:
        """Return (k, core, radius), integers in units of 2**-k; the core: a polygon's corners or a circle's center."""
        return self.cached("integers", self._to_integers)

    def _to_integers(self) -> tuple[int, list[IntPoint], int]:
        """Return (k, core, radius), the value that the property `integers` caches."""
        k, (radius, *flat) = to_integers((self.radius, *chain.from_iterable(self.core)))
        return k, list(zip(flat[::2], flat[1::2], strict=True)), radius


class Polygon(_Shape):
    """A simple polygon, convex or concave, of either winding; it keeps its vertices and labels as given.

    `vertices`: (n, 2) numbers in scene units, anything with `__geo_interface__`, or a
    Polygon, whose labels stay unless others are given; repeats, a closing vertex and
    collinear vertices are allowed and listed in `notes`.
    `labels`: one text a vertex.  Raises InvalidShape, which names the vertex at fault.
    """

    __slots__ = ("corner_ids", "labels", "notes", "vertices")

    vertices: tuple[Vec, ...]
    labels: tuple[str, ...] | None
    core_is_point: ClassVar[bool] = False
    corner_ids: tuple[int, ...]  # for each corner, the number of its vertex
    notes: tuple[str, ...]  # a sentence for each vertex that is not a corner

    def __init__(self, vertices: Any, labels: Sequence[str] | None = None) -> None:
        if isinstance(vertices, Polygon):
            vertices, labels = vertices.vertices, vertices.labels if labels is None else labels
        points = polygon_validation.parse_vertices(vertices)
        outline = polygon_validation.find_corners(points)
        corners = tuple(Vec(points[i].x + 0.0, points[i].y + 0.0) for i in outline.ids)  # -0.0 becomes 0.0
        xs, ys = [c.x for c in corners], [c.y for c in corners]
        edges = [(q.x - p.x, q.y - p.y) for p, q in cyclic_pairs(corners)]
        x0, y0, x1, y1 = box = min(xs), min(ys), max(xs), max(ys)
        self._set(
            vertices=points,
            labels=_validate_labels(labels, len(points)),
            core=corners,
            radius=0.0,
            corner_ids=outline.ids,
            is_convex=outline.convex,
            notes=outline.notes,
            is_upright_box=len(corners) == 4 and all(x in (x0, x1) and y in (y0, y1) for x, y in corners),
            bounds=box,
            max_coordinate=max(map(abs, xs + ys)),
            max_edge_component=max(abs(d) for edge in edges for d in edge),
            slabs=_slabs(corners, edges) if outline.convex else None,
            _cache={},
        )

    def _arguments(self) -> tuple[object, ...]:
        """Return (vertices, labels), the arguments that make an equal Polygon."""
        return self.vertices, self.labels

    @property
    def corners(self) -> tuple[Vec, ...]:
        """Return the vertices that turn: counter-clockwise, without repeats and without those on a straight line."""
        return self.core

    @property
    def __geo_interface__(self) -> dict[str, object]:
        """Return the polygon as GeoJSON, which shapely and others read."""
        return {"type": "Polygon", "coordinates": (tuple(map(tuple, (*self.vertices, self.vertices[0]))),)}


class Circle(_Shape):
    """A circle with its inside: center (x, y) and radius > 0 in scene units; InvalidShape otherwise."""

    __slots__ = ()

    core_is_point: ClassVar[bool] = True
    vertices: ClassVar[tuple[Vec, ...]] = ()
    labels: ClassVar[tuple[str, ...] | None] = None
    corner_ids: ClassVar[tuple[int, ...]] = ()

    def __init__(self, center: Any, radius: Any) -> None:
        warn_if_flushed()
        c = polygon_validation.parse_point(center, "center")
        r = polygon_validation.parse_number(radius, "radius")
        if r <= 0:
            raise InvalidShape(f"radius is {r}: a circle needs a positive radius")
        self._set(
            core=(c,),
            radius=r,
            is_convex=True,
            is_upright_box=False,
            bounds=(
                math.nextafter(c.x - r, -INF),
                math.nextafter(c.y - r, -INF),
                math.nextafter(c.x + r, INF),
                math.nextafter(c.y + r, INF),
            ),
            max_coordinate=max(abs(c.x), abs(c.y)) + r,
            max_edge_component=r,
            slabs=None,
            _cache={},
        )

    @property
    def center(self) -> Vec:
        """Return the center, which is the circle's core."""
        return self.core[0]

    def _arguments(self) -> tuple[object, ...]:
        """Return (center, radius), the arguments that make an equal Circle."""
        return self.center, self.radius


Shape = Polygon | Circle


def require_shape(shape: Any, name: str) -> Shape:
    """Return the shape itself; TypeError unless it is a Polygon or a Circle; `name`: the argument's name."""
    if isinstance(shape, (Polygon, Circle)):
        return shape
    raise TypeError(f"argument {name} is a {type(shape).__name__}: make it a satviz.Polygon or satviz.Circle first")


def centroid(shape: Shape) -> Vec:
    """Return the center of area, rounded; a circle's center; of corners whose area vanishes in floats, their mean."""
    (ox, oy), ring, size = shape.core[0], shape.core, shape.max_edge_component
    area = x = y = 0.0
    for (px, py), (qx, qy) in pairwise(((p.x - ox) / size, (p.y - oy) / size) for p in ring):
        cross = px * qy - py * qx
        area += cross
        x += cross * (px + qx)
        y += cross * (py + qy)
    middle = Vec(ox + x / area / 3 * size, oy + y / area / 3 * size) if area > 1e-12 else Vec(INF, INF)
    if math.isfinite(middle.x) and math.isfinite(middle.y):
        return middle
    return Vec(math.fsum(p.x / len(ring) for p in ring), math.fsum(p.y / len(ring) for p in ring))


def _slabs(corners: tuple[Vec, ...], edges: list[tuple[float, float]]) -> tuple[Slab, ...]:
    """Return one slab (nx, ny, lo, hi, edges) per edge direction: inside it lo < nx*x + ny*y < hi, up to rounding.

    (nx, ny) is the outward normal (dy, -dx) of the first edge and hi the first edge's value.
    If another edge runs exactly opposite (the far side of a box), lo is the value of that edge
    and the slab has both edges; otherwise lo is -inf.  `edges`: (dx, dy) from each corner to the next.
    """
    slabs: list[Slab] = []
    ends = list(cyclic_pairs(corners))
    index = {edge: i for i, edge in enumerate(edges)}
    for i, (dx, dy) in enumerate(edges):
        hi = dy * corners[i].x - dx * corners[i].y
        # the float components are exactly opposite; the error bound of `relate` covers the rounding of both edges
        j = index.get((-dx, -dy))
        if j is None:
            slabs.append((dy, -dx, -INF, hi, (ends[i],)))
        elif i < j or index[dx, dy] != i:  # else the slab of j has this edge, too
            slabs.append((dy, -dx, dy * corners[j].x - dx * corners[j].y, hi, (ends[i], ends[j])))
    return tuple(slabs)


def _validate_labels(labels: Sequence[str] | None, n: int) -> tuple[str, ...] | None:
    """Return the labels of n vertices as a tuple, None for None; InvalidShape if they are not n texts."""
    if labels is None:
        return None
    if isinstance(labels, str):
        raise InvalidShape(
            f"labels is the text {polygon_validation.short_repr(labels)}: pass a list with one label for each vertex"
        )
    try:
        labels = tuple(labels)
    except TypeError:
        raise InvalidShape(
            f"labels is {polygon_validation.short_repr(labels)}: pass a list with one label for each vertex"
        ) from None
    if len(labels) != n:
        raise InvalidShape(f"{len(labels)} labels for {n} vertices: pass one label for each vertex")
    for i, label in enumerate(labels):
        if not isinstance(label, str):
            raise InvalidShape(f"label {i} is {polygon_validation.short_repr(label)}: a label must be text")
        if any("\ud800" <= c <= "\udfff" for c in label):
            raise InvalidShape(f"label {i} is {polygon_validation.short_repr(label)}: remove half a surrogate pair")
    return labels


def _to_lists(value: Any) -> Any:
    """Return a value with tuples as lists and each Vec as a tuple, so that its repr can be pasted back."""
    if isinstance(value, Vec):
        return tuple(value)
    return [_to_lists(v) for v in value] if isinstance(value, tuple) else value
