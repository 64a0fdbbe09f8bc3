"""Circles and Polygons: batches of shapes, validated when they are made."""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..engine.convex_parts import parts
from ..engine.geometry import InvalidShape
from ..engine.predicates import warn_if_flushed
from ..engine.shapes import Polygon
from . import validation
from .array_types import Array, Indices, Mask
from .arrays import Group, Shapes
from .engines import engine_for_checks
from .outlines import convex_rings
from .ragged import MAX_LANE_CORNERS, Rings, concat_rings


class Circles(Shapes):
    """Circles from (N, 2) centers and (N,) radii, or one radius (scene units); InvalidShape names the first bad one."""

    def __init__(self, centers: validation.Points, radii: validation.Numbers) -> None:
        columns = _plain_columns(centers)
        plain = None if columns is None else _plain_radii(radii, columns.shape[2])
        if columns is not None and plain is not None:
            super().__init__(groups={1: Group(columns[0], columns[1], plain)})
            return
        centers = validation.points(centers, "centers", lambda i: f"circle {i}: center")
        n = len(centers)
        r = validation.numbers(radii, "radii", "radius", lambda i: f"circle {i}: radius")
        if r.shape not in ((), (1,), (n,)):
            raise InvalidShape(f"radii has the shape {r.shape}: expected ({n},), or one radius for all")
        r = np.array(np.broadcast_to(r, (n,)))
        if (bad := np.flatnonzero(~(r > 0))).size:
            raise InvalidShape(f"circle {bad[0]}: radius is {r[bad[0]]}: a circle needs a positive radius")
        x, y = (np.array(centers[:, i][None]) for i in (0, 1))
        super().__init__(groups={1: Group(x, y, r)})


def _plain_columns(centers: object) -> Array | None:
    """Return (2, 1, n) coordinates of an (n, 2) array of plain finite floats; None if it needs another look."""
    if type(centers) is not np.ndarray or centers.dtype != np.float64 or centers.ndim != 2 or centers.shape[1] != 2:
        return None
    warn_if_flushed()
    columns = np.empty((2, 1, len(centers)))
    np.add(centers.T, 0.0, out=columns[:, 0])  # -0.0 becomes 0.0
    return columns if np.isfinite(columns).all() else None


def _plain_radii(radii: object, n: int) -> Array | None:
    """Return (n,) radii of one plain float or an array of them; None if they need another look."""
    if type(radii) is float:
        return np.full(n, radii) if 0 < radii < np.inf else None
    if type(radii) is not np.ndarray or radii.dtype != np.float64 or radii.shape != (n,):
        return None
    return radii.copy() if np.logical_and(radii > 0, radii < np.inf).all() else None


class Polygons(Shapes):
    """Convex polygons in scene units, of any numbers of vertices.

    `vertices`: an (N, V, 2) array (an outline with fewer than V vertices repeats one); or (M, 2) vertices
    one after another, with the (N + 1,) `offsets` at which each polygon starts and the last one ends;
    or a sequence of what satviz.Polygon takes.

    Either winding, repeats and straight-on vertices are allowed.  `concave="split"`
    splits concave ones into parts and keeps their owner.  InvalidShape names the
    first polygon at fault and says what is wrong, as satviz.Polygon does.  What is
    given is copied, never written to.
    """

    def __init__(
        self, vertices: validation.Rings, *, offsets: ArrayLike | None = None, concave: str = "refuse"
    ) -> None:
        validation.check_word("concave", concave, validation.CONCAVE_OPTIONS)
        if offsets is None and (made := _certified_shapes(vertices)) is not None:
            pass
        elif offsets is None:
            made = number_polygons(vertices, None, concave)
        else:
            made = build_shapes(*validation.rings_from_offsets(vertices, offsets), "polygon {}".format, concave)
        vars(self).update(vars(made))


def from_shapely(geometries: Any, *, concave: str = "refuse") -> Polygons:
    """Return a batch of the polygons in an array or sequence of shapely polygons; `concave` as in Polygons."""
    validation.check_word("concave", concave, validation.CONCAVE_OPTIONS)
    import shapely

    array = np.asarray(geometries, object).ravel()
    if not shapely.is_geometry(array).all():
        return Polygons(list(array), concave=concave)  # it says what each one is
    odd = shapely.get_type_id(array) != shapely.GeometryType.POLYGON
    odd |= shapely.is_empty(array) | shapely.has_z(array) | (shapely.get_num_interior_rings(array) > 0)
    if odd.any():
        return Polygons(list(array), concave=concave)
    outer = shapely.get_exterior_ring(array)
    start = np.concatenate([[0], np.cumsum(shapely.get_num_coordinates(outer))])
    return Polygons(shapely.get_coordinates(outer), offsets=start, concave=concave)


def number_polygons(vertices: validation.Rings, numbers: Indices | None, concave: str) -> Shapes:
    """Return a batch of polygons; error messages call polygon i `numbers[i]`, or i if `numbers` is None."""

    def name(i: int) -> str:
        """Return the name of polygon `i` in error messages."""
        return f"polygon {i if numbers is None else numbers[i]}"

    if isinstance(vertices, np.ndarray) and vertices.dtype != object:
        array = validation.rings_from_array(vertices, name)
        if array is not vertices and (certified := _certified_shapes(np.ascontiguousarray(array))) is not None:
            return certified
        start = np.arange(len(array) + 1, dtype=np.intp) * array.shape[1]
        return build_shapes(array.reshape(-1, 2), start, name, concave)
    return build_shapes(*validation.rings_from_sequence(vertices, name), name, concave)


def _certified_shapes(vertices: object) -> Shapes | None:
    """Return the polygons of an (N, V, 2) array of plain floats; None if one needs more than a certified look."""
    if type(vertices) is not np.ndarray or vertices.dtype != np.float64 or not vertices.flags.carray:
        return None
    if vertices.ndim != 3 or vertices.shape[2] != 2 or vertices.shape[1] < 3:
        return None
    warn_if_flushed()
    n, corners = vertices.shape[:2]
    kernels = engine_for_checks(n * corners)
    if corners <= MAX_LANE_CORNERS and (group := kernels.certified_group(vertices)) is not None:
        return Shapes(groups={corners: group})
    if kernels.certified_rings is None:
        return None
    rings, doubtful = kernels.certified_rings(vertices.reshape(-1, 2), np.arange(n + 1, dtype=np.intp) * corners)
    return None if doubtful.size else Shapes(np.diff(rings.start), rings=rings)


def build_shapes(points: Array, start: Indices, name: Callable[[int], str], concave: str | None) -> Shapes:
    """Return a batch of outlines, points[start[i]] to points[start[i + 1]]; name(i): outline i in error messages.

    Those not certainly convex go through satviz.Polygon.
    """
    given = Rings(points[:, 0], points[:, 1], start)
    rings, plain = _convex_rings(points, given)
    count = np.diff(rings.start)
    if plain.all():
        return Shapes(count, rings=rings)
    pieces: list[NDArray[np.float64]] = []
    owners = [np.flatnonzero(plain)]
    for i in np.flatnonzero(~plain).tolist():
        part = slice(given.start[i], given.start[i + 1])
        try:
            polygon = Polygon(np.stack([given.x[part], given.y[part]], axis=1))
        except InvalidShape as error:
            raise InvalidShape(f"{name(i)}: {error}") from None
        if concave is None:
            raise InvalidShape(f"{name(i)} is not convex with these coordinates: nothing was moved")
        if concave == "refuse":
            raise InvalidShape(
                f"{name(i)} is not convex: split it with satviz.parts first, "
                'or pass concave="split", which remembers the polygon of each part'
            )
        found = parts(polygon)
        pieces += [np.asarray(piece.core) for piece in found]
        owners.append(np.full(len(found), i))
    flat = np.concatenate(pieces)
    start = np.cumsum([0, *map(len, pieces)])
    owner = np.concatenate(owners)
    order = np.argsort(owner, kind="stable")
    rings = concat_rings([rings, Rings(flat[:, 0], flat[:, 1], start)]).take(order)
    return Shapes(np.diff(rings.start), owner[order], rings=rings)


def _convex_rings(points: Array, given: Rings) -> tuple[Rings, Mask]:
    """Return what `convex_rings` returns for all outlines; the engine certifies most of them in one pass."""
    if (certified_rings := engine_for_checks(len(points)).certified_rings) is None:
        return convex_rings(Rings(given.x + 0.0, given.y + 0.0, given.start))  # a copy, where -0.0 is 0.0
    rings, doubtful = certified_rings(points, given.start)
    plain = np.ones(len(given.start) - 1, bool)
    if not doubtful.size:
        return rings, plain
    some = given.take(doubtful)
    exact, plain[doubtful] = convex_rings(Rings(some.x + 0.0, some.y + 0.0, some.start))
    first = np.flatnonzero(np.isin(np.arange(len(plain)), doubtful, invert=True))
    order = np.argsort(np.concatenate([first, doubtful[plain[doubtful]]]))
    return concat_rings([rings.take(first), exact]).take(order), plain
