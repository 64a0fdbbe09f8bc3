"""Rival methods for one pair at a time in plain Python, as they are usually written: floats without error bounds.

A shape here is (points, radius): a polygon's corners with radius 0, or a circle's center with its radius.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from math import hypot, inf, sqrt

from ...engine.shapes import Circle, Shape

Points = Sequence[tuple[float, float]]
PointsAndRadius = tuple[Points, float]
Simplex = list[tuple[float, float]]
AxisChoice = Callable[[PointsAndRadius, PointsAndRadius], Iterable[tuple[float, float]]]
MAX_GJK_STEPS = 64  # rounding can make GJK cycle


def points_and_radius(shape: Shape) -> PointsAndRadius:
    """Return a polygon as (its corners, 0), or a circle as ((its center,), its radius)."""
    return ((shape.center,), shape.radius) if isinstance(shape, Circle) else (shape.corners, 0.0)


def edge_normals(a: PointsAndRadius, b: PointsAndRadius) -> Iterator[tuple[float, float]]:
    """Yield every edge normal, those of A first, not normalised."""
    for points, _ in (a, b):
        if len(points) > 1:
            px, py = points[-1]
            for qx, qy in points:
                yield qy - py, px - qx
                px, py = qx, qy


def sat_axes(a: PointsAndRadius, b: PointsAndRadius) -> Iterator[tuple[float, float]]:
    """Yield the axes of SAT: edge normals, and for circles the axis from the center to the nearest vertex or center."""
    yield from edge_normals(a, b)
    if a[1] or b[1]:
        (((cx, cy),), _), (ring, _) = (a, b) if a[1] else (b, a)
        yield min(((x - cx, y - cy) for x, y in ring), key=lambda v: v[0] * v[0] + v[1] * v[1])


def sat(a: PointsAndRadius, b: PointsAndRadius, choice: AxisChoice = sat_axes, *, unit: bool = False) -> bool:
    """Return whether two shapes hit: no axis of `choice` leaves a gap (textbook SAT); `unit`: normalise each axis."""
    for nx, ny in choice(a, b):
        length = sqrt(nx * nx + ny * ny)
        if unit and length:
            nx, ny, length = nx / length, ny / length, 1.0
        lo_a, hi_a = project(a, nx, ny, length)
        lo_b, hi_b = project(b, nx, ny, length)
        if max(lo_a - hi_b, lo_b - hi_a) > 0:
            return False
    return True


def project(shape: PointsAndRadius, nx: float, ny: float, length: float) -> tuple[float, float]:
    """Return (low, high): the range of a shape on the axis (nx, ny); `length`: the length of (nx, ny)."""
    points, r = shape
    landings = [x * nx + y * ny for x, y in points]
    return min(landings) - r * length, max(landings) + r * length


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
    """Return the part of the simplex and (ax, ay) nearest to the origin, and the next search direction.

    Three corners are returned where the origin lies inside.
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
    """Return the part of the edge from a, the newest corner, to b nearest to the origin, and the next direction."""
    ex, ey = b[0] - a[0], b[1] - a[1]
    if ex * -a[0] + ey * -a[1] <= 0:
        return [a], (-a[0], -a[1])
    turn = ex * -a[1] - ey * -a[0]
    return [b, a], (-ey * turn, ex * turn)
