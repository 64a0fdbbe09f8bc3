"""The relative margin of a pair: how hard it is for floats, counted in roundings.

    relative margin = |the orientation that decides| / (u * span * max_coordinate)

The *orientation* of a corner about an edge is the orientation determinant (orient2d) of the edge and the corner; u =
2**-53 is the unit roundoff of float64.  The margin has no unit and does not change when the pair is scaled by a power
of two.

Polygons: an edge's *clearance* is the least orientation of the other shape's corners about it, positive where all of
them lie beyond the edge.  It is divided by the edge's *span* (its larger component) and by the largest absolute
coordinate of both shapes.  The edge with the largest quotient decides.  Where that is positive the shapes are apart;
where it is negative every edge is refuted by at least as much, so they overlap.  The margin is 0 for touching pairs,
and only for them.  Circles: the gap takes the place of clearance / span (with the center inside: minus the depth), and
a circle's largest coordinate is that of its center plus the radius.  Concave polygons: the pair of convex parts with
the least signed margin decides.

A sum of products of rounded differences is off by some u * span * max_coordinate.  So plain floats can be trusted where
the margin is above their number of roundings; `certified_bounds.py` says how many.  That holds while the floats can
hold the shapes and the products of their coordinates.  Where products leave the range of the floats, or where the
steps of float32 are larger than a shape, an answer can be wrong at any margin.
"""

from collections.abc import Iterator, Sequence
from fractions import Fraction

from ..engine.convex_parts import parts
from ..engine.geometry import cyclic_pairs
from ..engine.predicates import IntPoint, root_difference, to_common_unit
from ..engine.shapes import Shape, require_shape

IN_FLOAT32 = 2.0**-29  # a margin times this is counted in roundings of float32


def relative_margin(a: Shape, b: Shape) -> float:
    """Return the relative margin of two shapes: 0 or more, and 0 only for touching.

    It is the orientation determinant that decides, divided by u * span * max_coordinate: the distance from touching
    counted in roundings (see the module).  Correctly rounded.  TypeError for anything but Polygon and Circle.
    """
    return abs(signed_relative_margin(a, b))


def signed_relative_margin(a: Shape, b: Shape) -> float:
    """Return the relative margin of two shapes, negative where they overlap."""
    require_shape(a, "a"), require_shape(b, "b")
    return min(_convex_margin(p, q) for p in parts(a) for q in parts(b))


def _convex_margin(a: Shape, b: Shape) -> float:
    """Return the signed relative margin of two convex shapes."""
    p, q, radii, _ = to_common_unit(a, b)
    if not radii:
        max_coordinate = max(abs(c) for ring in (p, q) for v in ring for c in v)
        clearances = (*exact_edge_clearances(p, q), *exact_edge_clearances(q, p))
        best = max(Fraction(clearance, span) for clearance, span in clearances) / max_coordinate
        return float(best * 2**53) or (best > 0) * 5e-324 - (best < 0) * 5e-324
    k = max(a.integers[0], b.integers[0])
    max_coordinate = max(_max_coordinate(s, k) for s in (a, b))
    size = max_coordinate.bit_length()
    shift = size - 53  # the gap comes in roundings at once, as the least float must not be multiplied
    gap = _gap_from_center(p[0], radii, q, shift) if len(p) == 1 else _gap_from_center(q[0], radii, p, shift)
    return gap / (max_coordinate / (1 << size))


def _max_coordinate(shape: Shape, k: int) -> int:
    """Return the largest absolute coordinate of a shape (with its radius) in units of 2**-k."""
    own, ring, radius = shape.integers
    return max(abs(c) for v in ring for c in v) + radius << k - own


def exact_edge_clearances(ring: Sequence[IntPoint], points: Sequence[IntPoint]) -> Iterator[tuple[int, int]]:
    """Yield (clearance, span) of each edge, as the module defines them; the first edge begins at ring[0].

    The clearance is the least orientation of `points` about the edge; it is positive where all lie beyond the edge.
    """
    for (px, py), (qx, qy) in cyclic_pairs(ring):
        nx, ny = qy - py, px - qx
        yield min(nx * x + ny * y for x, y in points) - nx * px - ny * py, max(abs(nx), abs(ny))


def exact_edge_distances(
    center: IntPoint, ring: Sequence[IntPoint]
) -> Iterator[tuple[tuple[int, int], int, tuple[int, int]]]:
    """Yield (edge as a vector, orientation, (s, q)) for each edge of a ring.

    orientation: the cross product of the edge's start, seen from the center, and the edge; positive where the center
    lies on the inner side.  s / sqrt(q): the exact distance of the center from the edge as a segment.
    """
    seen = [(x - center[0], y - center[1]) for x, y in ring]
    for (px, py), (qx, qy) in cyclic_pairs(seen):
        dx, dy = qx - px, qy - py
        orientation, along, square = px * dy - py * dx, -(px * dx + py * dy), dx * dx + dy * dy
        x, y = (px, py) if along <= 0 else (qx, qy)
        away = x * x + y * y
        yield (dx, dy), orientation, (abs(orientation), square) if 0 < along < square else (away, away or 1)


def _gap_from_center(center: IntPoint, r: int, ring: Sequence[IntPoint], shift: int) -> float:
    """Return the gap of a circle and a ring (one corner: center of a second circle) in units of 2**shift.

    Outside, the gap is the distance from the nearest edge, minus r.  If the center is inside, it is minus its depth,
    minus r.
    """
    inner, outer = [], []
    for (dx, dy), orientation, (s, q) in exact_edge_distances(center, ring):
        if orientation > 0:
            inner.append(root_difference(-orientation, r, dx * dx + dy * dy, shift))
        else:
            outer.append(root_difference(s, r, q, shift))
    return min(outer) if outer else max(inner)
