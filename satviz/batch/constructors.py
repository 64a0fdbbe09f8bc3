"""Circles and Polygons: batches of shapes, validated when they are made."""

from collections.abc import Callable, Iterable
from typing import Any, TypeGuard

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..engine.convex_parts import parts
from ..engine.geometry import InvalidShape
from ..engine.polygon_validation import refuse_masked
from ..engine.predicates import warn_if_flushed
from ..engine.shapes import Polygon
from . import validation
from .array_types import Array, Indices, Mask
from .arrays import CornerColumns, Shapes, check_shapes
from .engines import engine_for_checks
from .outlines import convex_rings
from .ragged import MAX_LANE_CORNERS, RaggedRings, concat_rings

FLOAT64, INTP = np.dtype(np.float64), np.dtype(np.intp)  # comparing with these takes half as long as with np.float64

# what an error line says of a concave polygon, by the argument `concave` of build_shapes
WAYS_OUT = {
    None: " with these coordinates, so nothing was moved: give coordinates that keep it convex",
    "separately": ": split it with satviz.parts first",
    "refuse": ': split it with satviz.parts first, or pass concave="split", which remembers the polygon of each part',
}


class Circles(Shapes):
    """Circles from (N, 2) centers and (N,) radii, or one radius (scene units); InvalidShape names the first bad one."""

    def __init__(self, centers: validation.Points, radii: validation.Numbers) -> None:
        if (group := _certified_circles(centers, radii)) is not None:
            self.runs = (group,)
            return
        centers = validation.points(centers, "centers", lambda i: f"circle {i}: center")
        n = len(centers)
        r = validation.numbers(radii, "radii", "radius", lambda i: f"circle {i}: radius")
        if r.shape not in ((), (1,), (n,)):
            raise InvalidShape(f"radii has the shape {r.shape}: expected ({n},), or one radius for all")
        block = np.empty((3, 1, n))
        block[:2, 0], block[2, 0] = centers.T + 0.0, r  # no -0.0
        if (bad := np.flatnonzero(~(block[2, 0] > 0))).size:
            i = bad[0]
            raise InvalidShape(f"circle {i}: radius is {block[2, 0, i]}: a circle needs a positive radius")
        self.runs = (CornerColumns(block),)


def _certified_circles(centers: object, radii: object) -> CornerColumns | None:
    """Return the circles if both arguments are plain float arrays of valid values; else None, for slower checks."""
    if not _is_carray(centers, 2) or centers.shape[1] != 2:
        return None
    n = len(centers)
    if type(radii) is float:
        radii = np.full(n, radii)
    elif not _is_carray(radii, 1) or len(radii) != n:
        return None
    warn_if_flushed()
    group: CornerColumns | None = engine_for_checks(n).certified_circles(centers, radii)
    return group


def _is_carray(values: object, axes: int) -> TypeGuard[Array]:
    """Return whether this is a float64 array with `axes` dimensions, aligned, writable and contiguous in C order."""
    return type(values) is np.ndarray and values.dtype == FLOAT64 and values.ndim == axes and values.flags.carray


def _is_index_array(values: object) -> TypeGuard[Indices]:
    """Return whether this is an intp array with one dimension, aligned, writable and contiguous."""
    return type(values) is np.ndarray and values.dtype == INTP and values.ndim == 1 and values.flags.carray


class Polygons(Shapes):
    """A batch of convex polygons in scene units, with any numbers of vertices.

    `vertices`: an (N, V, 2) array (an outline with fewer than V vertices repeats one); or (M, 2) vertices
    one after another, with the (N + 1,) `offsets` at which each polygon starts and the last one ends;
    or a sequence of what satviz.Polygon takes.

    Either winding, repeats and straight-on vertices are allowed.  `concave="split"`
    splits concave ones into parts and keeps their owner.  InvalidShape names the
    first polygon at fault and says what is wrong, as satviz.Polygon does.  What is
    given is copied, never written to.
    """

    def __init__(
        self, vertices: validation.Outlines, *, offsets: ArrayLike | None = None, concave: str = "refuse"
    ) -> None:
        validation.check_word("concave", concave, validation.CONCAVE_OPTIONS)
        if offsets is None and (group := _certified_group(vertices)) is not None:
            self.runs = (group,)
            return
        if (made := _certified_shapes(vertices, offsets)) is not None:
            pass
        elif offsets is None:
            made = number_polygons(vertices, None, concave)
        else:
            made = build_shapes(*validation.rings_from_offsets(vertices, offsets), "polygon {}".format, concave)
        vars(self).update(vars(made))


def from_shapely(geometries: Any, *, concave: str = "refuse") -> Polygons:
    """Return a batch of the shapely polygons in an array or sequence; `concave` and InvalidShape as in Polygons."""
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


def from_padded(corners: Any, counts: Any, radii: validation.Numbers) -> Shapes:
    """Return a batch of circles and convex polygons from padded arrays, one row for each shape, in scene units.

    corners: (N, V, 2), of which shape i has the first counts[i]; what follows them is not read.  counts: (N,) integers,
    1 for a circle, whose only corner is its center.  radii: (N,), 0 for polygons.  Corners as in Polygons; what is
    given is copied.  InvalidShape names the first shape at fault.
    """
    if (
        (_is_carray(corners, 3) and corners.shape[2] == 2 and _is_carray(radii, 1) and _is_index_array(counts))
        and len(corners) == len(counts) == len(radii)
        and (certified_padded := engine_for_checks(corners.size // 2).certified_padded) is not None
    ):
        warn_if_flushed()
        shapes: Shapes | None = certified_padded(corners, counts, radii)
        if shapes is not None:
            return shapes
    return build_mixed(*_unpadded(corners, counts, radii), "separately")


def _unpadded(corners: Any, counts: Any, radii: validation.Numbers) -> tuple[Array, Indices, Array]:
    """Return ((M, 2) corners one after another, (N + 1,) their starts, radii) of padded arrays, with finite numbers."""
    if not isinstance(corners, np.ndarray) or corners.ndim != 3 or corners.shape[2] != 2:
        form = f"has the shape {corners.shape}" if isinstance(corners, np.ndarray) else f"is a {type(corners).__name__}"
        raise InvalidShape(f"corners {form}: expected an (N, V, 2) array")
    many = np.asanyarray(counts, None if np.size(counts) else np.intp)
    refuse_masked(many, "counts")
    radius = validation.numbers(radii, "radii", "radius", lambda i: f"shape {i}: radius") + 0.0  # a copy, no -0.0
    n, most, _ = corners.shape
    if many.dtype.kind not in "iu" or many.shape != (n,) or radius.shape != (n,):
        raise InvalidShape(f"counts is {many.dtype} of the shape {many.shape} and radii has the shape {radius.shape}: "
                           f"expected {n} integers and {n} radii")  # fmt: skip
    good = (many >= 1) & (many <= most) & (radius >= 0) & ((many == 1) == (radius > 0))
    if (bad := np.flatnonzero(~good)).size:
        i = bad[0]
        raise InvalidShape(f"shape {i} has {many[i]} corners and the radius {radius[i]}: a circle has 1 corner and a "
                           f"positive radius, a polygon 3 to {most} corners and the radius 0")  # fmt: skip
    start = np.concatenate([[0], np.cumsum(many, dtype=np.intp)])
    name = corner_name(start, radius)
    return validation.points(corners[np.arange(most) < many[:, None]], "corners", name), start, radius


def corner_name(start: Indices, radius: Array) -> Callable[[int], str]:
    """Return a function that names corner k of the batch, such as "polygon 3: vertex 2", for error messages.

    start: (N + 1,) the first corner of each shape, then the number of corners; radius: (N,), 0 for polygons.
    """

    def name(k: int) -> str:
        """Return the name of corner `k`."""
        i = int(np.searchsorted(start, k, side="right")) - 1
        return f"circle {i}: center" if radius[i] else f"polygon {i}: vertex {k - start[i]}"

    return name


def build_mixed(points: Array, start: Indices, radius: Array, concave: str | None) -> Shapes:
    """Return a batch of circles (center points[start[i]]) where the (N,) radius is positive, and polygons elsewhere.

    Other arguments as in build_shapes.
    """
    circles = radius > 0
    if len(radius) and circles.all():
        block = np.array([*points.T, radius])[:, None] + 0.0
        return Shapes(runs=[CornerColumns(block)])
    if not circles.any():
        return build_shapes(points, start, "polygon {}".format, concave)
    of = np.flatnonzero(~circles)
    some = RaggedRings(points[:, 0], points[:, 1], start).take(of)
    polygons = build_shapes(np.stack(some[:2], axis=1), some.start, lambda i: f"polygon {of[i]}", concave)
    count = np.ones(len(circles), np.int64)
    count[of] = polygons.count
    ends = np.concatenate([[0], np.cumsum(count)])
    x, y = np.empty((2, ends[-1]))
    is_center = np.repeat(circles, count)
    for c, made, given in ((x, polygons.rings.x, points[:, 0]), (y, polygons.rings.y, points[:, 1])):
        c[~is_center], c[is_center] = made, given[start[:-1][circles]] + 0.0
    return Shapes(rings=RaggedRings(x, y, ends), radius=radius)


def concat(many: Iterable[Shapes]) -> Shapes:
    """Return one batch with the shapes of several, in order; this is how circles and polygons are mixed."""
    many = list(many)
    for i, shapes in enumerate(many):
        if not isinstance(shapes, Shapes):  # few shapes are joined in each frame, and even their names take time
            check_shapes(shapes, f"batch {i}")
    runs = [some for shapes in many if (some := vars(shapes).get("runs")) is not None]
    if len(runs) == len(many) > 0:
        return Shapes(runs=[run for some in runs for run in some])
    owner = None
    if any(shapes.owner is not None for shapes in many):
        first, owners = 0, []
        for shapes in many:
            owners.append((np.arange(shapes.part_count) if shapes.owner is None else shapes.owner) + first)
            first += len(shapes)
        owner = np.concatenate(owners)
    radius = np.concatenate([np.empty(0), *(shapes.radius for shapes in many)])
    return Shapes(rings=concat_rings([shapes.rings for shapes in many]), radius=radius, owner=owner)


def number_polygons(vertices: validation.Outlines, numbers: Indices | None, concave: str | None) -> Shapes:
    """Return a batch of polygons; error messages call polygon i `numbers[i]`, or i if `numbers` is None.

    `vertices` as in Polygons, without offsets; `concave` as in build_shapes.
    """

    def name(i: int) -> str:
        """Return the name of polygon `i` in error messages."""
        return f"polygon {i if numbers is None else numbers[i]}"

    if isinstance(vertices, np.ndarray) and vertices.dtype != object:
        array = validation.rings_from_array(vertices, name)
        if array is not vertices:
            array = np.ascontiguousarray(array)
            if (group := _certified_group(array)) is not None:
                return Shapes(runs=[group])
            if (certified := _certified_shapes(array)) is not None:
                return certified
        start = np.arange(len(array) + 1, dtype=np.intp) * array.shape[1]
        return build_shapes(array.reshape(-1, 2), start, name, concave)
    return build_shapes(*validation.rings_from_sequence(vertices, name), name, concave)


def _certified_group(vertices: object) -> CornerColumns | None:
    """Return the polygons of a plain float array, (N, V, 2) with V up to MAX_LANE_CORNERS, as a group.

    None for anything else, or if floats do not certify each polygon as convex.
    """
    if not _is_carray(vertices, 3):
        return None
    _, corners, axes = vertices.shape
    if axes != 2 or not 3 <= corners <= MAX_LANE_CORNERS:
        return None
    warn_if_flushed()
    group: CornerColumns | None = engine_for_checks(vertices.size // 2).certified_group(vertices)
    return group


def _certified_shapes(vertices: object, offsets: object = None) -> Shapes | None:
    """Return a batch of plain float arrays, as `Polygons` takes them; None if floats do not certify all as convex."""
    if not _is_carray(vertices, 3 if offsets is None else 2) or vertices.shape[-1] != 2:
        return None
    if offsets is None:
        n, corners = vertices.shape[:2]
        if corners < 3:
            return None
        start = np.arange(n + 1, dtype=np.intp) * corners
    elif _is_index_array(offsets):
        start = offsets
        if not start.size or start[0] or start[-1] != len(vertices) or not (start[1:] >= start[:-1]).all():
            return None
    else:
        return None
    warn_if_flushed()
    if (certified_rings := engine_for_checks(vertices.size // 2).certified_rings) is None:
        return None
    rings, doubtful = certified_rings(vertices.reshape(-1, 2), start)
    return None if doubtful.size else Shapes(rings=rings)


def build_shapes(points: Array, start: Indices, name: Callable[[int], str], concave: str | None) -> Shapes:
    """Return a batch of polygons from (M, 2) points: outline i is points[start[i]:start[i + 1]].

    name(i) names outline i in error messages.  Outlines that are not certainly convex are checked by satviz.Polygon.
    Concave ones are split if `concave` is "split"; else InvalidShape advises what WAYS_OUT has for `concave`.
    """
    given = RaggedRings(points[:, 0], points[:, 1], start)
    rings, plain = _convex_rings(points, given)
    if plain.all():
        return Shapes(rings=rings)
    pieces: list[NDArray[np.float64]] = []
    owners = [np.flatnonzero(plain)]
    for i in np.flatnonzero(~plain).tolist():
        part = slice(given.start[i], given.start[i + 1])
        try:
            polygon = Polygon(np.stack([given.x[part], given.y[part]], axis=1))
        except InvalidShape as error:
            raise InvalidShape(f"{name(i)}: {error}") from None
        if concave != "split":
            raise InvalidShape(f"{name(i)} is not convex{WAYS_OUT[concave]}")
        found = parts(polygon)
        pieces += [np.asarray(piece.core) for piece in found]
        owners.append(np.full(len(found), i))
    flat = np.concatenate(pieces)
    start = np.cumsum([0, *map(len, pieces)])
    owner = np.concatenate(owners)
    order = np.argsort(owner, kind="stable")
    rings = concat_rings([rings, RaggedRings(flat[:, 0], flat[:, 1], start)]).take(order)
    return Shapes(rings=rings, owner=owner[order])


def _convex_rings(points: Array, given: RaggedRings) -> tuple[RaggedRings, Mask]:
    """Return what `convex_rings` returns for the outlines `given`, whose corners are also the (M, 2) `points`.

    Neither is changed.  The engine certifies most of them in one pass.
    """
    if (certified_rings := engine_for_checks(len(points)).certified_rings) is None:
        return convex_rings(RaggedRings(given.x + 0.0, given.y + 0.0, given.start))  # a copy, where -0.0 is 0.0
    rings, doubtful = certified_rings(points, given.start)
    plain = np.ones(len(given.start) - 1, bool)
    if not doubtful.size:
        return rings, plain
    some = given.take(doubtful)
    exact, plain[doubtful] = convex_rings(RaggedRings(some.x + 0.0, some.y + 0.0, some.start))
    first = np.flatnonzero(np.isin(np.arange(len(plain)), doubtful, invert=True))
    order = np.argsort(np.concatenate([first, doubtful[plain[doubtful]]]))
    return concat_rings([rings.take(first), exact]).take(order), plain
