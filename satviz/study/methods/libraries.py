"""Other libraries as methods: shapely, which calls GEOS (C++), and pymunk, which calls Chipmunk (C)."""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..workloads.generators import Side, is_padded, unpadded_rings


def one_by_one(ask: Callable[[Any, Any], Any]) -> Callable[[list[Any], list[Any]], list[Any]]:
    """Return a function of two lists that calls `ask(a[k], b[k])` for each k and returns the list of answers."""
    return lambda a, b: [ask(p, q) for p, q in zip(a, b, strict=True)]


def shapely_geometries(side: Side) -> Any:
    """Return an array of shapely geometries; circles as (points, radii), since shapely has no true circle."""
    import shapely

    if isinstance(side, tuple):
        return shapely.points(side[0]), side[1]
    if not is_padded(side):
        return shapely.polygons(side)
    rings = unpadded_rings(side)
    owner = np.repeat(np.arange(len(rings)), [len(ring) for ring in rings])
    return shapely.polygons(shapely.linearrings(np.concatenate(rings), indices=owner))


def prepared_geometries(side: Side) -> Any:
    """Return the shapes as prepared shapely geometries, which keep an index of their edges."""
    import shapely

    found = shapely_geometries(side)
    shapely.prepare(found)
    return found


def shapely_hits(a: Any, b: Any) -> NDArray[np.bool_]:
    """Return for each pair whether the shapes share a point; shapes in the form of `shapely_geometries`."""
    import shapely

    if isinstance(a, tuple):
        return np.asarray(
            shapely.dwithin(a[0], b[0], a[1] + b[1]) if isinstance(b, tuple) else shapely.dwithin(a[0], b, a[1])
        )
    return np.asarray(shapely.intersects(a, b))


def tree_pairs(geometries: Any, **query: Any) -> NDArray[np.intp]:
    """Return the (K, 2) pairs i < j that shapely's STRtree finds: boxes that meet, or what its options `query` say."""
    import shapely

    i, j = shapely.STRtree(geometries).query(geometries, **query)
    once = i < j
    return np.stack([i[once], j[once]], axis=1)


def geometry_list(side: Side) -> list[Any]:
    """Return the shapes as a list of shapely geometries; each circle as (point, radius)."""
    found = shapely_geometries(side)
    return list(zip(found[0], found[1].tolist())) if isinstance(found, tuple) else list(found)


def shapely_hit(a: Any, b: Any) -> bool:
    """Return whether two shapes share a point; shapes in the form of `geometry_list`."""
    return bool(a[0].dwithin(b, a[1]) if isinstance(a, tuple) else a.intersects(b))


def pymunk_shapes(side: Side) -> list[Any]:
    """Return the shapes as a list of pymunk shapes, all on one static body."""
    import pymunk

    body = pymunk.Body(body_type=pymunk.Body.STATIC)
    if isinstance(side, tuple):
        found: list[Any] = [pymunk.Circle(body, r, tuple(c)) for c, r in zip(side[0].tolist(), side[1].tolist())]
    else:
        found = [pymunk.Poly(body, [tuple(v) for v in ring.tolist()]) for ring in unpadded_rings(side)]
    for shape in found:
        shape.cache_bb()
    return found


def pymunk_hit(a: Any, b: Any) -> bool:
    """Return whether pymunk finds points of contact between two of its shapes."""
    try:
        return bool(a.shapes_collide(b).points)
    except AssertionError:  # pymunk 7 raises it for two shapes without a contact
        return False
