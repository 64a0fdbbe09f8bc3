"""relate: the exact relation of two shapes, with nothing recorded."""

from collections.abc import Sequence
from math import inf, nan
from typing import Any

from .convex_parts import parts
from .geometry import Relation, Vec
from .predicates import HUGE, TINY, IntPoint, Point, aligned, orient, shifted, sign, to_integers
from .shapes import Shape, Slab, checked

APART, TOUCHING, OVERLAPPING = Relation

# One look of relate is nx*x + ny*y against the edge's own value.  With D the span of the edge's
# shape and M the larger reach: the normal carries one rounding, each product one more, the sum
# one, at most 2DM each; the edge's value the same; the two bounds one each: under
# 15 * 2**-53 * D * M, whatever the order and with fused operations.  Asked: 32.
ERROR_FACTOR_F64 = 2.0**-48
FEW = 6  # slabs of both, as triangles have: so few are looked at as soon as a point between them
MIN_ERROR_BOUND, MAX_ERROR_BOUND = TINY, HUGE * ERROR_FACTOR_F64


def relate(a: Shape, b: Shape) -> Relation:
    """The exact relation of two shapes as closed sets: APART, TOUCHING (a hit) or OVERLAPPING.

    Takes Polygon (convex or concave) and Circle in any mix; TypeError for anything else.
    Convex polygons: an edge clears the other shape when every vertex lies strictly beyond
    it, so no projection and no square root are needed.  One vertex surely inside refutes
    that, and a point surely inside both shapes refutes it for all edges; where the least is
    in doubt, the exact sign is asked of every vertex within the room of zero (of the least
    alone would be wrong when two lie on the edge's line).
    """
    try:
        a_slabs, b_slabs = a.slabs, b.slabs  # which shapes of other libraries do not have
    except AttributeError:
        checked(a, "a"), checked(b, "b")
        raise
    ax0, ay0, ax1, ay1 = a.bounds
    bx0, by0, bx1, by1 = b.bounds
    if ax1 < bx0 or bx1 < ax0 or ay1 < by0 or by1 < ay0:
        return APART
    if not (a_slabs and b_slabs):
        return _circles(a, b) if a.core_is_point and b.core_is_point else _mixed(a, b)
    if a.is_upright_box and b.is_upright_box:
        return TOUCHING if ax1 == bx0 or bx1 == ax0 or ay1 == by0 or by1 == ay0 else OVERLAPPING
    reach = (
        a.max_coordinate + b.max_coordinate
    ) * ERROR_FACTOR_F64  # the sum stands in for the larger: quicker, and on the safe side
    room_a, room_b = a.max_edge_component * reach, b.max_edge_component * reach
    if not (MIN_ERROR_BOUND < room_a < MAX_ERROR_BOUND and MIN_ERROR_BOUND < room_b < MAX_ERROR_BOUND):
        return relate_integers(*aligned(a, b)[:3])
    if len(a_slabs) + len(b_slabs) > FEW:
        # the middle of what both boxes share: surely inside both shapes, or beyond an edge that then is the likeliest
        x = ((ax0 if ax0 > bx0 else bx0) + (ax1 if ax1 < bx1 else bx1)) / 2
        y = ((ay0 if ay0 > by0 else by0) + (ay1 if ay1 < by1 else by1)) / 2
        if k := _beyond(a_slabs, room_a, x, y):
            a_slabs = a_slabs[k - 1 :] + a_slabs[: k - 1]
        elif k := _beyond(b_slabs, room_b, x, y):
            # the slabs of b before it hold the point, which is in a: none of them clears a
            a, a_slabs, room_a, b, b_slabs, room_b = b, b_slabs[k - 1 :], room_b, a, a_slabs, room_a
        else:
            return OVERLAPPING
    for slabs, room, points in (a_slabs, room_a, b.core), (b_slabs, room_b, a.core):
        for nx, ny, lo, hi, edges in slabs:
            low = lo + room
            high = hi - room
            for x, y in points:
                if low < nx * x + ny * y < high:
                    break  # a vertex surely inside: neither edge of the slab clears
            else:
                told = _told(edges, points, room)
                if told is not OVERLAPPING:
                    return told
    return OVERLAPPING


def _beyond(slabs: Sequence[Slab], room: float, x: float, y: float) -> int:
    """The number, from 1, of the first slab that does not surely hold a point; 0 if all do."""
    for k, (nx, ny, lo, hi, _) in enumerate(slabs, 1):
        if not lo + room < nx * x + ny * y < hi - room:
            return k
    return 0


def _told(edges: Sequence[tuple[Vec, Vec]], points: Sequence[Vec], room: float) -> Relation:
    """What edges tell of the other shape's vertices, asking the exact sign of every one within the room of zero.

    APART where all lie beyond one of the edges.  Where some lie on its line and none before it, the
    shapes can only meet there: TOUCHING, or APART, as their ranges on the line tell.  Else OVERLAPPING for now.
    """
    for p, q in edges:
        nx, ny = q.y - p.y, p.x - q.x
        at = nx * p.x + ny * p.y
        low, high = at - room, at + room
        on = []
        for v in points:
            look = nx * v.x + ny * v.y
            if look < low:
                break
            if look <= high:
                turn = orient(q, p, v)  # a vertex beyond the edge lies to the left of its way back
                if turn < 0:
                    break
                if turn == 0:
                    on.append(v)
        else:
            # points of one line stand on it in the order of their x, then y
            return TOUCHING if on and max(on) >= min(p, q) and max(p, q) >= min(on) else APART
    return OVERLAPPING


def _mixed(a: Shape, b: Shape) -> Relation:
    if a.core_is_point and b.slabs:
        return _circle_polygon(a, b)
    if b.core_is_point and a.slabs:
        return _circle_polygon(b, a)
    worst = APART
    for p in parts(a):
        for q in parts(b):
            worst = max(worst, relate(p, q))
            if worst is OVERLAPPING:
                return worst
    return worst


def relate_moved(a: Shape, b: Shape, move: Vec) -> Relation:
    """The exact relation of convex a and b, once b has moved by exactly `move` (no coordinate is rounded)."""
    core_a, core_b, radii, k = aligned(a, b)
    own_k, (dx, dy) = to_integers(move)
    finer = max(k, own_k)
    dx, dy = dx << finer - own_k, dy << finer - own_k
    core_a = shifted(core_a, finer - k)
    core_b = [(x + dx, y + dy) for x, y in shifted(core_b, finer - k)]
    return relate_integers(core_a, core_b, radii << finer - k)


def relate_integers(p: Sequence[IntPoint], q: Sequence[IntPoint], radii: int) -> Relation:
    """The same in integers: a circle is a point with a radius, and beside another circle a ring of one corner."""
    if 1 not in (len(p), len(q)):
        return _by_sign(max(_edge_side(p, q), _edge_side(q, p)))
    (center,), ring = (p, q) if len(p) == 1 else (q, p)
    inside, _, gap = _from_center(center, ring, radii * radii, 0)
    return OVERLAPPING if inside else _by_sign(gap)


def _edge_side(ring: Sequence[IntPoint], points: Sequence[IntPoint]) -> int:
    """1 if some edge of the ring has all points strictly beyond, 0 if at best one on it, else -1."""
    best = -1
    px, py = ring[-1]
    for qx, qy in ring:
        nx, ny = qy - py, px - qx
        value = nx * px + ny * py
        best = max(best, sign(min(nx * x + ny * y for x, y in points) - value))
        if best > 0:
            return best
        px, py = qx, qy
    return best


def _circles(a: Shape, b: Shape) -> Relation:
    """Distance against the sum of radii, squared: each side carries under 5 roundings; asked: 8."""
    ((ax, ay),), ((bx, by),) = a.core, b.core
    dx, dy = ax - bx, ay - by
    reach = a.radius + b.radius
    distance, reach = dx * dx + dy * dy, reach * reach
    room = (distance + reach) * 2.0**-50
    if TINY < room < HUGE and abs(distance - reach) > room:
        return _by_sign(distance - reach)
    return relate_integers(*aligned(a, b)[:3])


def _by_sign(gap: Any) -> Relation:
    return APART if gap > 0 else OVERLAPPING if gap < 0 else TOUCHING


def _circle_polygon(circle: Shape, polygon: Shape) -> Relation:
    """The distance from the center to the nearest edge or vertex, against the radius.

    The nearest vertex matters: without it a circle off a corner is a false hit.
    With D the largest difference of coordinates from the center, the turn about an
    edge of length L carries under 12 roundings of D*L (asked: 32) and a squared
    distance under 45 of D*D (asked: 128).  A foot of the perpendicular taken for a
    vertex, or the reverse, moves a squared distance by the square of a rounding.
    Where the room is below HUGE, the products are at most 2**49 times larger; a
    radius beyond 2D, whatever its rounding, reaches past every vertex.
    Where products vanish, a turn tells nothing: what is beyond such edges alone
    is as near to others as these are long, so one whose products stay is enough.
    """
    (x, y), reach = circle.core[0], circle.radius * circle.radius
    x0, y0, x1, y1 = polygon.bounds
    far = max(x1 - x, x - x0, y1 - y, y - y0)
    room = far * far * 2.0**-46
    if TINY < room < HUGE and polygon.max_edge_component * far > TINY:
        inside, outside, gap = _from_center((x, y), polygon.core, reach, far * 2.0**-48)
        if inside or gap < -room:
            return OVERLAPPING
        if outside and gap > room:
            return APART
    return relate_integers(*aligned(circle, polygon)[:3])


def _from_center(center: Point, ring: Sequence[Point], reach: Any, room: float) -> tuple[bool, bool, Any]:
    """Does a center lie surely inside a ring, surely outside, and the gap: its least squared distance beyond `reach`.

    The turn about an edge is sure beyond `room` times its lengths in x and y; the gap is nan where an edge is
    too short for its square.  A room of 0 stands for integers: the sign of the gap is exact then, and the
    ring may be one corner, another circle's center.
    """
    cx, cy = center
    inside, outside, least = True, False, inf
    vx, vy = ring[-1]
    px, py = vx - cx, vy - cy
    for wx, wy in ring:
        qx, qy = wx - cx, wy - cy
        dx, dy = wx - vx, wy - vy
        turn = px * dy - py * dx  # positive with the center inside this edge
        tolerance = (abs(dx) + abs(dy)) * room
        if turn <= tolerance:
            inside = False
            outside = outside or turn < -tolerance
            along, square = -(px * dx + py * dy), dx * dx + dy * dy
            if room and square < TINY:
                return False, False, nan
            if along <= 0:
                gap = px * px + py * py - reach
            elif along >= square:
                gap = qx * qx + qy * qy - reach
            else:  # in this order floats stay in range; integers ask for the sign alone
                gap = turn / square * turn - reach if room else turn * turn - reach * square
            if gap < least:
                least = gap
        px, py, vx, vy = qx, qy, wx, wy
    return inside, outside, least
