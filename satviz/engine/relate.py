"""relate: the exact relation of two shapes, with nothing recorded.

1. Boxes.  If the bounding boxes do not meet, the shapes are apart.
2. Edges.  An edge of a convex polygon *clears* the other one when every vertex of the other lies strictly
   beyond it.  If any edge of either polygon clears, they are apart (the separating axis theorem; neither a
   projection nor a square root is needed).  One vertex certainly inside an edge refutes that edge.
3. Signs.  Where a computed value is within its error bound, its exact sign decides.

Two edges of one polygon that run in exactly opposite directions bound a *slab*, and one value serves both:

                lo                       hi         n . (x, y), with n the outward normal of the far edge
    ------------|========================|------------->
           |<------>|               |<------>|          each mark with its error bound on both sides
    near edge: all vertices   far edge: all vertices
    certainly below lo clear  certainly above hi clear

A vertex between lo + error_bound and hi - error_bound refutes both edges at once.  An edge without an opposite
one is a slab with lo = -inf.  Beside a much larger shape the two error bounds can be wider than the slab; then no
vertex refutes, and both edges are classified vertex by vertex.
"""

from collections.abc import Iterable, Sequence
from math import inf, nan
from typing import Any

from .convex_parts import parts
from .geometry import APART, OVERLAPPING, TOUCHING, Relation, Vec, cyclic_pairs, relation_of_gap
from .predicates import (
    MAX_SAFE_PRODUCT,
    MIN_SAFE_PRODUCT,
    IntPoint,
    Point,
    orient,
    to_common_unit,
    to_finer_units,
    to_integers,
)
from .shapes import Shape, Slab, require_shape

# A vertex is compared by nx*x + ny*y against the edge's own value.  With u = 2**-53, D the largest edge component
# and M the larger max_coordinate: the normal carries one rounding, each product one, the sum one, at most 2 u D M
# each; the edge's value as many; lo + error_bound and hi - error_bound one each.
# |error| <= 15 u D M in any order of operations, also fused; the factor is 32 u.
ERROR_FACTOR_F64 = 2.0**-48
MAX_SLABS_WITHOUT_PROBE = 6  # slabs of both shapes, as two triangles have: evaluating them costs no more than a probe
# error bounds in this range: no product lost bits or overflowed
MIN_ERROR_BOUND, MAX_ERROR_BOUND = MIN_SAFE_PRODUCT, MAX_SAFE_PRODUCT * ERROR_FACTOR_F64


def relate(a: Shape, b: Shape) -> Relation:
    """Return the exact relation of two shapes as closed sets: APART, TOUCHING (a hit) or OVERLAPPING.

    Takes Polygon (convex or concave) and Circle in any mix; TypeError for anything else.
    """
    try:
        a_slabs, b_slabs = a.slabs, b.slabs  # shapes of other libraries have no slabs
    except AttributeError:
        require_shape(a, "a"), require_shape(b, "b")
        raise
    ax0, ay0, ax1, ay1 = a.bounds
    bx0, by0, bx1, by1 = b.bounds
    if ax1 < bx0 or bx1 < ax0 or ay1 < by0 or by1 < ay0:
        return APART
    if not (a_slabs and b_slabs):
        return _relate_circles(a, b) if a.core_is_point and b.core_is_point else _relate_mixed(a, b)
    if a.is_upright_box and b.is_upright_box:
        return TOUCHING if ax1 == bx0 or bx1 == ax0 or ay1 == by0 or by1 == ay0 else OVERLAPPING
    # the sum of both is at least the larger one, and quicker to compute
    factor = (a.max_coordinate + b.max_coordinate) * ERROR_FACTOR_F64
    bound_a, bound_b = a.max_edge_component * factor, b.max_edge_component * factor
    if not (MIN_ERROR_BOUND < bound_a < MAX_ERROR_BOUND and MIN_ERROR_BOUND < bound_b < MAX_ERROR_BOUND):
        return relate_integers(*to_common_unit(a, b)[:3])
    if len(a_slabs) + len(b_slabs) > MAX_SLABS_WITHOUT_PROBE:
        # probe the middle of what both bounding boxes share: either it is certainly inside both shapes, or it lies
        # beyond an edge, which then is the likeliest to clear and comes first
        x = ((ax0 if ax0 > bx0 else bx0) + (ax1 if ax1 < bx1 else bx1)) / 2
        y = ((ay0 if ay0 > by0 else by0) + (ay1 if ay1 < by1 else by1)) / 2
        if k := _first_outside(a_slabs, bound_a, x, y):
            a_slabs = a_slabs[k - 1 :] + a_slabs[: k - 1]
        elif k := _first_outside(b_slabs, bound_b, x, y):
            # the earlier slabs of b contain the probe, which is inside a: none of them clears a
            a, a_slabs, bound_a, b, b_slabs, bound_b = b, b_slabs[k - 1 :], bound_b, a, a_slabs, bound_a
        else:
            return OVERLAPPING
    for slabs, error_bound, points in (a_slabs, bound_a, b.core), (b_slabs, bound_b, a.core):
        for nx, ny, lo, hi, edges in slabs:
            low = lo + error_bound
            high = hi - error_bound
            for x, y in points:
                if low < nx * x + ny * y < high:
                    break  # a vertex certainly inside: neither edge of the slab clears
            else:
                relation = _classify_edges(edges, points, error_bound)
                if relation is not OVERLAPPING:
                    return relation
    return OVERLAPPING


def _first_outside(slabs: Sequence[Slab], error_bound: float, x: float, y: float) -> int:
    """Return the number, from 1, of the first slab that does not certainly contain a point; 0 if all do."""
    for k, (nx, ny, lo, hi, _) in enumerate(slabs, 1):
        if not lo + error_bound < nx * x + ny * y < hi - error_bound:
            return k
    return 0


def _classify_edges(edges: Iterable[tuple[Point, Point]], points: Sequence[Point], error_bound: float) -> Relation:
    """Return the relation that these edges of one convex polygon prove, `points` being the other's vertices.

    APART if all vertices lie strictly beyond an edge.  If some lie on the edge's line and all others beyond, the
    shapes can meet only on that line: TOUCHING or APART, as their ranges on it say.  Else OVERLAPPING, which
    is no proof while other edges remain.  Every vertex within the error bound gets its exact sign, not only the
    smallest value: when two vertices lie on the line, rounding can select the wrong one.  Integers are exact
    with an error bound of 0.
    """
    for p, q in edges:
        (px, py), (qx, qy) = p, q
        nx, ny = qy - py, px - qx
        at = nx * px + ny * py
        low, high = at - error_bound, at + error_bound
        on_line = []
        for v in points:
            value = nx * v[0] + ny * v[1]
            if value < low:
                break
            if value <= high:
                turn = orient(q, p, v) if error_bound else 0  # beyond the edge is left of its way back
                if turn < 0:
                    break
                if turn == 0:
                    on_line.append(v)
        else:
            # points of one line are ordered along it by x, then y
            return TOUCHING if on_line and max(on_line) >= min(p, q) and max(p, q) >= min(on_line) else APART
    return OVERLAPPING


def _relate_mixed(a: Shape, b: Shape) -> Relation:
    """Return the relation of a circle and a convex polygon, or of two shapes at least one of which is concave."""
    if a.core_is_point and b.slabs:
        return _relate_circle_polygon(a, b)
    if b.core_is_point and a.slabs:
        return _relate_circle_polygon(b, a)
    worst = APART
    for p in parts(a):
        for q in parts(b):
            worst = max(worst, relate(p, q))
            if worst is OVERLAPPING:
                return worst
    return worst


def relate_moved(a: Shape, b: Shape, move: Vec) -> Relation:
    """Return the exact relation of convex a and b once b has moved by exactly `move` (no coordinate is rounded)."""
    core_a, core_b, radii, k = to_common_unit(a, b)
    own_k, (dx, dy) = to_integers(move)
    finer = max(k, own_k)
    dx, dy = dx << finer - own_k, dy << finer - own_k
    core_a = to_finer_units(core_a, finer - k)
    core_b = [(x + dx, y + dy) for x, y in to_finer_units(core_b, finer - k)]
    return relate_integers(core_a, core_b, radii << finer - k)


def relate_integers(p: Sequence[IntPoint], q: Sequence[IntPoint], radii: int) -> Relation:
    """Return the relation of two convex shapes given by integers: their cores, and the sum of their radii.

    A core of one point is a circle's center; of two polygons the radii are 0.
    """
    if 1 not in (len(p), len(q)):
        relation = _classify_edges(cyclic_pairs(p), q, 0)
        return _classify_edges(cyclic_pairs(q), p, 0) if relation is OVERLAPPING else relation
    (center,), ring = (p, q) if len(p) == 1 else (q, p)
    inside, _, gap = _locate_center(center, ring, radii * radii, 0)
    return OVERLAPPING if inside else relation_of_gap(gap)


def _relate_circles(a: Shape, b: Shape) -> Relation:
    """Return the relation of two circles: compare squared distance with the squared sum of radii.

    With u = 2**-53, each carries under 5 u of its size; the error bound is 8 u of their sum.
    """
    ((ax, ay),), ((bx, by),) = a.core, b.core
    dx, dy = ax - bx, ay - by
    radii = a.radius + b.radius
    distance_squared, radii_squared = dx * dx + dy * dy, radii * radii
    error_bound = (distance_squared + radii_squared) * 2.0**-50
    if MIN_SAFE_PRODUCT < error_bound < MAX_SAFE_PRODUCT and abs(distance_squared - radii_squared) > error_bound:
        return relation_of_gap(distance_squared - radii_squared)
    return relate_integers(*to_common_unit(a, b)[:3])


def _relate_circle_polygon(circle: Shape, polygon: Shape) -> Relation:
    """Return the relation of circle and polygon: compare the center's distance with the radius.

    The nearest vertex matters: without it a circle off a corner is a false hit.
    With D the largest difference of a coordinate from the center's and u = 2**-53:
    the orientation determinant of an edge of length L carries under 12 u D L (the factor is
    32 u), a squared distance under 45 u D**2 (the factor is 128 u).  Where a rounding turns the foot of
    the perpendicular into a vertex or back, the squared distance changes by the square of that rounding.
    Where the error bound is below MAX_SAFE_PRODUCT, products are at most 2**49 times larger; a
    radius beyond 2D, whatever its rounding, covers every vertex.
    Where products vanish, a determinant proves nothing.  But what lies beyond such edges alone
    is as near to other edges as these are long, so one edge whose products do not vanish is enough.
    """
    (x, y), radius_squared = circle.core[0], circle.radius * circle.radius
    x0, y0, x1, y1 = polygon.bounds
    far = max(x1 - x, x - x0, y1 - y, y - y0)
    error_bound = far * far * 2.0**-46
    if MIN_SAFE_PRODUCT < error_bound < MAX_SAFE_PRODUCT and polygon.max_edge_component * far > MIN_SAFE_PRODUCT:
        inside, outside, gap = _locate_center((x, y), polygon.core, radius_squared, far * 2.0**-48)
        if inside or gap < -error_bound:
            return OVERLAPPING
        if outside and gap > error_bound:
            return APART
    return relate_integers(*to_common_unit(circle, polygon)[:3])


def _locate_center(
    center: Point, ring: Sequence[Point], radius_squared: Any, error_factor: float
) -> tuple[bool, bool, Any]:
    """Return (certainly inside the ring, certainly outside it, gap) for a circle's center.

    The gap is the smallest squared distance to an edge minus `radius_squared`; inf inside, nan if an edge is too
    short for its square.  The sign of an edge's orientation determinant is certain where its size is above
    `error_factor` times the edge's length in x plus that in y.  An error factor of 0 stands for integers: all signs
    are exact then, and of the gap only the sign is right.  The ring may be one point, another circle's center.
    """
    cx, cy = center
    inside, outside, least = True, False, inf
    vx, vy = ring[-1]
    px, py = vx - cx, vy - cy
    for wx, wy in ring:
        qx, qy = wx - cx, wy - cy
        dx, dy = wx - vx, wy - vy
        det = px * dy - py * dx  # positive with the center on the inner side of this edge
        tolerance = (abs(dx) + abs(dy)) * error_factor
        if det <= tolerance:
            inside = False
            outside = outside or det < -tolerance
            along, square = -(px * dx + py * dy), dx * dx + dy * dy
            if error_factor and square < MIN_SAFE_PRODUCT:
                return False, False, nan
            if along <= 0:
                gap = px * px + py * py - radius_squared
            elif along >= square:
                gap = qx * qx + qy * qy - radius_squared
            else:  # in this order floats stay in range; of integers only the sign is needed
                gap = det / square * det - radius_squared if error_factor else det * det - radius_squared * square
            if gap < least:
                least = gap
        px, py, vx, vy = qx, qy, wx, wy
    return inside, outside, least
