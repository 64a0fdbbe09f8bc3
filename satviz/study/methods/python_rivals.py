"""GJK for one pair at a time in plain Python, as it is usually written: floats without error bounds.

A shape here is (points, radius): a polygon's corners with radius 0, or a circle's center with its radius.
"""

from collections.abc import Sequence
from math import hypot, inf

from ...engine.shapes import Circle, Shape

Points = Sequence[tuple[float, float]]
PointsAndRadius = tuple[Points, float]
Simplex = list[tuple[float, float]]
MAX_GJK_STEPS = 64  # rounding can make GJK cycle


def points_and_radius(shape: Shape) -> PointsAndRadius:
    """Return a polygon as (its corners, 0), or a circle as ((its center,), its radius)."""
    return ((shape.center,), shape.radius) if isinstance(shape, Circle) else (shape.corners, 0.0)


def gjk(a: PointsAndRadius, b: PointsAndRadius) -> bool:
    """Return whether two shapes hit: A - B contains the origin (Gilbert, Johnson and Keerthi 1988)."""
    ax, ay = _support_of_difference(a, b, 1.0, 0.0)
    corners = [(ax, ay)]
    dx, dy = -ax, -ay
    for _ in range(MAX_GJK_STEPS):
        if dx == 0 and dy == 0:
            return True  # the origin lies on the simplex
        ax, ay = _support_of_difference(a, b, dx, dy)
        if ax * dx + ay * dy < 0:
            return False
        corners, (dx, dy) = _towards_origin(corners, ax, ay)
        if len(corners) == 3:
            return True
    return True


def _support_of_difference(a: PointsAndRadius, b: PointsAndRadius, dx: float, dy: float) -> tuple[float, float]:
    """Return the support point of A - B: its point furthest along (dx, dy)."""
    px, py = _support(a, dx, dy)
    qx, qy = _support(b, -dx, -dy)
    return px - qx, py - qy


def _support(shape: PointsAndRadius, dx: float, dy: float) -> tuple[float, float]:
    """Return the support point of a shape: its point furthest along (dx, dy)."""
    points, r = shape
    best, found = -inf, points[0]
    for p in points:
        along = p[0] * dx + p[1] * dy
        if along > best:
            best, found = along, p
    if not r:
        return found
    length = hypot(dx, dy)
    return found[0] + r * dx / length, found[1] + r * dy / length


def _towards_origin(corners: Simplex, ax: float, ay: float) -> tuple[Simplex, tuple[float, float]]:
    """Return (the part of the simplex nearest to the origin, the next search direction).

    The simplex is one or two older corners and (ax, ay), the newest.  All three are returned where the origin lies
    inside.
    """
    a = ax, ay
    if len(corners) == 1:
        return _edge_towards_origin(a, corners[0])
    c, b = corners
    # the sides of the triangle that face away from the third corner
    turn = (b[0] - ax) * (c[1] - ay) - (b[1] - ay) * (c[0] - ax)
    for near, sign in ((b, 1.0), (c, -1.0)):
        side = (near[0] - ax) * -ay - (near[1] - ay) * -ax
        if side * sign * turn < 0:
            return _edge_towards_origin(a, near)
    return [c, b, a], (0.0, 0.0)


def _edge_towards_origin(a: tuple[float, float], b: tuple[float, float]) -> tuple[Simplex, tuple[float, float]]:
    """Return (the part of the edge from a, the newest corner, to b nearest to the origin; the next direction)."""
    ex, ey = b[0] - a[0], b[1] - a[1]
    if ex * -a[0] + ey * -a[1] <= 0:
        return [a], (-a[0], -a[1])
    turn = ex * -a[1] - ey * -a[0]
    return [b, a], (-ey * turn, ex * turn)
