"""The models for many pairs: `prepare` sets up the data of a model for a batch, `evaluate` returns its relations."""

from collections.abc import Iterable
from functools import cache
from importlib.util import find_spec
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import batch
from ..batch.arrays import CornerColumns, Shapes
from ..batch.codes import TOUCHING
from ..batch.with_numpy.filter import clearance
from ..engine.geometry import Vec
from ..engine.predicates import MAX_SAFE_PRODUCT, MIN_SAFE_PRODUCT
from .candidates import AABB, BOUNDING_CIRCLES, EXACT_FILTER, K_DOP, MAX_DIRECTIONS, PARALLEL_ANGLE, Model
from .certified_bounds import WIDENING
from .margins import edge_distances
from .pairs import Array, ConvertedParts, PartPairs, Relations, pair_columns, slice_if_adjacent
from .rounding import FORMATS

PAIRS_PER_BLOCK = 16384  # pairs whose columns fit the cache
DTYPES: dict[str, Any] = {"float32": np.float32, "float64": np.float64}


def prepare(model: Model, shapes: Shapes) -> Any:
    """Return the data that `evaluate` needs of the shapes for this model; cold times include this step.

    Boxes (N, 4), circles (N, 3), ranges (N, k, 2), ConvertedParts for SAT; for the exact filter the batch itself.
    """
    if model.kind == EXACT_FILTER:
        _ = shapes.groups, shapes.rings, shapes.slot
        return shapes
    if model.kind == AABB:
        return bounding_boxes(shapes)
    if model.kind == BOUNDING_CIRCLES:
        return bounding_circles(shapes)
    if model.kind == K_DOP:
        return direction_ranges(shapes, model.directions)
    dtype = DTYPES[model.kind]
    with np.errstate(over="ignore"):
        groups = {v: CornerColumns(g.block.astype(dtype)) for v, g in shapes.groups.items()}
        x, y, r = (c.astype(dtype) for c in (*shapes.rings[:2], part_radii(shapes)))
        bounds = shapes.parts.bounds.astype(dtype)  # rounding keeps order: boxes apart after it were apart before
        return ConvertedParts(x, y, r, shapes.rings.start, bounds, shapes.count, shapes.slot, groups)


def part_radii(shapes: Shapes) -> Array:
    """Return the radius of each convex part, 0 for polygons."""
    found = np.zeros(len(shapes.count))
    if (group := shapes.groups.get(1)) is not None:
        found[shapes.count == 1] = group.r
    return found


def is_circle(shapes: Shapes) -> NDArray[np.bool_]:
    """Return a mask of the shapes that are circles."""
    found: NDArray[np.bool_] = shapes.count[shapes.starts[:-1]] == 1
    return found


def bounding_boxes(shapes: Shapes) -> Array:
    """Return (N, 4) bounding boxes in plain floats: for a circle, center minus and plus radius."""
    found = np.array(shapes.bounds)
    circle = np.flatnonzero(is_circle(shapes))
    part = shapes.starts[circle]
    x, y, start = shapes.rings
    with np.errstate(over="ignore"):
        for side, c in enumerate((x, y) * 2):
            found[circle, side] = c[start[part]] + (1 if side > 1 else -1) * part_radii(shapes)[part]
    return found


def bounding_circles(shapes: Shapes, widening: float = WIDENING) -> Array:
    """Return (N, 3) x, y, radius of a circle around each shape, as `certified_bounds.bounding_circle`.

    A polygon's radius is multiplied by `widening`.
    """
    found = np.empty((len(shapes), 3))
    x, y, start = shapes.rings
    box = shapes.bounds
    first = shapes.rings.start[shapes.starts[:-1]]
    with np.errstate(all="ignore"):
        found[:, :2] = box[:, :2] / 2 + box[:, 2:] / 2
        many = np.diff(np.concatenate([first, start[-1:]]))
        dx, dy = (c - np.repeat(found[:, i], many) for i, c in enumerate((x, y)))
        square = np.maximum.reduceat(dx * dx + dy * dy, first) if len(first) else np.empty(0)
        found[:, 2] = np.where(
            (square > MIN_SAFE_PRODUCT) & (square < MAX_SAFE_PRODUCT), np.sqrt(square) * widening, 0.0
        )
    circle = np.flatnonzero(is_circle(shapes))
    part = shapes.starts[circle]
    found[circle] = np.stack([x[start[part]], y[start[part]], part_radii(shapes)[part]], axis=1)
    return found


def direction_ranges(shapes: Shapes, directions: tuple[Vec, ...]) -> Array:
    """Return (N, k, 2): the least and the largest x*nx + y*ny of each shape, for k directions."""
    x, y, start = shapes.rings
    first = start[shapes.starts[:-1]]
    found = np.empty((len(shapes), len(directions), 2))
    if len(first):
        for k, (nx, ny) in enumerate(directions):
            at = x * nx + y * ny
            found[:, k, 0], found[:, k, 1] = np.minimum.reduceat(at, first), np.maximum.reduceat(at, first)
    return found


def shared_directions(*batches: Shapes) -> tuple[Vec, ...]:
    """Return the distinct directions of all edge normals in these batches; () if too many, or for circles."""
    edges = []
    for shapes in batches:
        if (shapes.count == 1).any():
            return ()
        x, y, start = shapes.rings
        after = np.arange(1, len(x) + 1)
        after[start[1:] - 1] = start[:-1]
        with np.errstate(all="ignore"):
            edges.append(np.stack([y[after] - y, x - x[after]]))
    left = np.concatenate(edges, axis=1)
    size = np.abs(left).max(axis=0)
    if not size.size or not (np.isfinite(size).all() and (size > 0).all()):
        return ()
    left = np.ldexp(left * np.copysign(1.0, np.where(left[0], left[0], left[1])), -np.frexp(size)[1]) + 0.0
    found: list[Vec] = []
    while left.size:
        if len(found) == MAX_DIRECTIONS:
            return ()
        nx = left[0].min()
        ny = left[1, left[0] == nx].min()
        found.append(Vec(float(nx), float(ny)))
        left = left[:, np.abs(nx * left[1] - ny * left[0]) > PARALLEL_ANGLE]
    return tuple(found)


# -- relations


@cache
def numba_kernels() -> Any:
    """Return the module of compiled kernels, or None where numba does not work."""
    if not find_spec("numba"):
        return None
    try:
        from . import kernels
    except Exception:  # `engines.engine_of` warns about it
        return None
    return kernels


def evaluate(model: Model, pairs: PartPairs, a: Any, b: Any, *, engine: str | None = None) -> Relations:
    """Return the relation that the model finds for each pair; a and b are what `prepare` returned for each side."""
    ia, ib = pairs.ia, pairs.ib
    if model.kind == EXACT_FILTER:
        return batch.relate(a, b, np.stack([ia, ib], axis=1), engine=engine)
    kernels = None if engine == "numpy" else numba_kernels()
    out = np.empty(len(ia), np.int8)
    if model.kind in FORMATS:
        return sat(pairs, a, b, kernels)
    if kernels is not None:
        kernel = {
            AABB: kernels.compare_boxes,
            BOUNDING_CIRCLES: kernels.compare_circles,
            K_DOP: kernels.compare_ranges,
        }[model.kind]
        kernel(a, ia, b, ib, out)
        return out
    compare = {AABB: compare_boxes, BOUNDING_CIRCLES: compare_circles, K_DOP: compare_ranges}[model.kind]
    for start in range(0, len(ia), PAIRS_PER_BLOCK):
        part = slice(start, start + PAIRS_PER_BLOCK)
        with np.errstate(all="ignore"):
            out[part] = compare(a[slice_if_adjacent(ia[part])], b[slice_if_adjacent(ib[part])])
    return out


def relations_of_gaps(gap: NDArray[Any]) -> Relations:
    """Return the relations of gaps: apart where positive, touching at 0, overlapping where negative."""
    return relations_of(gap > 0, gap < 0)


def compare_boxes(a: Array, b: Array) -> Relations:
    """Return the relation of row i of a with row i of b, which are boxes (x0, y0, x1, y1)."""
    apart = (a[:, 0] > b[:, 2]) | (b[:, 0] > a[:, 2]) | (a[:, 1] > b[:, 3]) | (b[:, 1] > a[:, 3])
    over = (a[:, 0] < b[:, 2]) & (b[:, 0] < a[:, 2]) & (a[:, 1] < b[:, 3]) & (b[:, 1] < a[:, 3])
    return relations_of(apart, over)


def relations_of(apart: Any, over: Any) -> Relations:
    """Return APART where `apart`, OVERLAPPING where `over`, else TOUCHING; both are bool arrays."""
    found: Relations = over.view(np.int8) - apart.view(np.int8)
    found += TOUCHING
    return found


def compare_circles(a: Array, b: Array) -> Relations:
    """Return the relation of row i of a with row i of b, which are circles (x, y, radius), by squared distances."""
    return relations_of_gaps(_squared_gap(a.T, b.T))


def _squared_gap(a: Iterable[NDArray[Any]], b: Iterable[NDArray[Any]]) -> NDArray[Any]:
    """Return the squared distance less the squared sum of radii; a and b are (x, y, radius) arrays."""
    (ax, ay, ar), (bx, by, br) = a, b
    dx, dy, radii = ax - bx, ay - by, ar + br
    gap: NDArray[Any] = dx * dx + dy * dy - radii * radii
    return gap


def compare_ranges(a: Array, b: Array) -> Relations:
    """Return the relation of row i of a with row i of b, (N, k, 2) ranges: APART if one of k directions has a gap."""
    apart, over = np.zeros(len(a), bool), np.ones(len(a), bool)
    for k in range(a.shape[1]):
        apart |= (a[:, k, 0] > b[:, k, 1]) | (b[:, k, 0] > a[:, k, 1])
        over &= (a[:, k, 0] < b[:, k, 1]) & (b[:, k, 0] < a[:, k, 1])
    return relations_of(apart, over)


def sat(pairs: PartPairs, a: ConvertedParts, b: ConvertedParts, kernels: Any) -> Relations:
    """Return the relations of the pairs by SAT in the float format of `a` and `b`; `kernels` None means NumPy."""
    found = np.empty(len(pairs.pa), np.int8)
    if kernels is not None:
        kernels.sat(a.x, a.y, a.r, a.start, a.bounds, pairs.pa, b.x, b.y, b.r, b.start, b.bounds, pairs.pb, found)
    else:
        for mine, p, q in pair_columns(a, pairs.pa, b, pairs.pb, PAIRS_PER_BLOCK):
            with np.errstate(all="ignore"):
                found[mine] = relations_of_gaps(sat_gaps(p, q))
    return pairs.combine(found)


def sat_gaps(p: CornerColumns, q: CornerColumns) -> NDArray[Any]:
    """Return for each pair of columns a number with the sign that SAT finds for the gap."""
    if p.r is not None and q.r is not None:
        return _squared_gap((p.x[0], p.y[0], p.r), (q.x[0], q.y[0], q.r))
    if p.r is not None or q.r is not None:
        return circle_polygon_gap(p, q) if p.r is not None else circle_polygon_gap(q, p)
    evaluate_clearance: Any = clearance  # annotated for float32 only
    found: NDArray[Any] = evaluate_clearance(p.x, p.y, q.x, q.y, 0)
    return found


def circle_polygon_gap(circle: CornerColumns, ring: CornerColumns) -> NDArray[Any]:
    """Return the squared distance of each center from its polygon's boundary less r squared; -1 if it is inside."""
    assert circle.r is not None
    inside = np.ones(ring.x.shape[1], bool)
    nearest = np.full(ring.x.shape[1], np.inf, ring.x.dtype)
    for _, _, orientation, distance in edge_distances(circle, ring):
        inside &= orientation > 0
        np.minimum(nearest, distance, out=nearest)
    return np.where(inside, -1, nearest - circle.r * circle.r)
