"""Pairs of shapes given by indices, with any numbers of corners, in NumPy."""

import numpy as np

from ...engine.relate import ERROR_FACTOR_F64
from ..array_types import Array, Indices, Relations
from ..arrays import Flat
from ..codes import APART, OVERLAPPING, TOUCHING, UNDECIDED
from ..exact_signs import pairs_per_block, take_columns
from . import gjk
from .exact import Edges, relate_edges
from .filter import MAX_F32_CORNERS, box_gap, classify_clearances, evaluate_f32

BLOCK_CORNERS = 1 << 17  # corners of one shape of each pair at a time: what bounds the memory


def relations(a: Flat, ia: Indices, b: Flat, ib: Indices, out: Relations) -> None:
    """Fill out[k] with the exact relation of a[ia[k]] and b[ib[k]]; UNDECIDED where one is a circle."""
    circles = (a.radius[ia] > 0) | (b.radius[ib] > 0)
    if not circles.any():
        _relate_polygons(a, ia, b, ib, out)
        return
    out.fill(UNDECIDED)
    polygons = np.flatnonzero(~circles)
    found = np.empty(len(polygons), np.int8)
    _relate_polygons(a, ia[polygons], b, ib[polygons], found)
    out[polygons] = found


def _relate_polygons(a: Flat, ia: Indices, b: Flat, ib: Indices, out: Relations) -> None:
    """Fill out[k] with the exact relation of polygons a[ia[k]] and b[ib[k]]: by their boxes, then in columns."""
    boxes_a, boxes_b = a.bounds[ia], b.bounds[ib]
    with np.errstate(over="ignore"):
        gap = box_gap(boxes_a.T, boxes_b.T)
    out.fill(APART)
    touch = np.flatnonzero(~(gap > 0))
    upright = a.upright[ia[touch]] & b.upright[ib[touch]]
    out[touch[upright]] = np.where(gap[touch[upright]] < 0, OVERLAPPING, TOUCHING)
    left = touch[~upright]
    most = np.maximum(*(s.start[i[left] + 1] - s.start[i[left]] for s, i in ((a, ia), (b, ib))))
    widths = np.maximum(2 ** np.ceil(np.log2(most)).astype(np.intp), 4)
    for width in np.unique(widths).tolist():
        mine = left[widths == width]
        size = pairs_per_block(width, BLOCK_CORNERS)
        for start in range(0, len(mine), size):
            part = mine[start : start + size]
            with np.errstate(all="ignore"):
                out[part] = _relate_columns(a, ia[part], boxes_a[part], b, ib[part], boxes_b[part])


def _relate_columns(a: Flat, ia: Indices, boxes_a: Array, b: Flat, ib: Indices, boxes_b: Array) -> Relations:
    """Return the exact relations of polygons a[ia[k]] and b[ib[k]], copied into columns: by the filter, then by edges.

    boxes_a, boxes_b: (K, 4) their bounding boxes.
    """
    (x, y), (p, q) = _corners_in_columns(a, ia), _corners_in_columns(b, ib)
    found = np.empty(len(ia), np.int8)
    if max(len(x), len(p)) - 1 > MAX_F32_CORNERS:
        factor = (np.abs(boxes_a).max(axis=1) + np.abs(boxes_b).max(axis=1)) * ERROR_FACTOR_F64
        gjk.gjk(x, y, p, q, factor, found)
    else:
        classify_clearances(*evaluate_f32(x, y, p, q, _max_widths(boxes_a) + _max_widths(boxes_b), 1), found)
    rest = np.flatnonzero(found == UNDECIDED)
    x, y, p, q = (take_columns(c, rest) for c in (x, y, p, q))
    found[rest] = relate_edges(Edges(x, y, len(x) - 1), Edges(p, q, len(p) - 1))
    return found


def _max_widths(boxes: Array) -> Array:
    """Return (n,) upper bounds of the shapes' edge components: the longer sides of their boxes, (n, 4)."""
    wide: Array = np.maximum(boxes[:, 2] - boxes[:, 0], boxes[:, 3] - boxes[:, 1])
    return wide


def _corners_in_columns(shapes: Flat, which: Indices) -> tuple[Array, Array]:
    """Return (x, y), each (V + 1, n), of the shapes `which`, a column each; V: the most corners of one.

    Each outline goes on with its own first corners until its column is full.
    """
    start = shapes.start[which]
    many, of = np.unique(shapes.start[which + 1] - start, return_inverse=True)
    # one modulo for each corner count; one for each corner would be slow
    places = (np.arange(many[-1] + 1)[:, None] % many).take(of, axis=1)
    places += start
    return shapes.x[places], shapes.y[places]
