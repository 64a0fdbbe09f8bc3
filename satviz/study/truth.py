"""The oracles: exact relations, distances and depths of convex shapes, by other methods than satviz's.

They share nothing with the engine but the shapes, so that a mistake in one is seen by the other.  Coordinates become
integers over one power of two, and everything that follows is exact.  Each kind of pair has two oracles, and `agreed`
compares them:
- two polygons: one is clipped by the edges of the other, and the rest has an area (overlapping), is a point or a
  segment (touching), or is empty (apart); or where the origin lies in the difference A - B;
- a circle and a polygon: the squared distance from the center to each edge, and whether the center is inside, by the
  crossings of a ray; or the gaps on axes, compared with the radius by whole square roots;
- two circles: the squares of their distance and of the sum of their radii; or the distance as a whole square root.
"""

from collections.abc import Iterable, Sequence
from fractions import Fraction
from math import gcd, isqrt
from typing import TypeVar

from ..engine.geometry import Relation
from ..engine.shapes import Circle, Polygon, Shape

Number = float | Fraction
Ints = tuple[int, int]
Point = TypeVar("Point")
Rational = tuple[Fraction, Fraction]
Homogeneous = tuple[int, int, int]  # (X, Y, W): the point (X / W, Y / W), W > 0


def relation(a: Shape, b: Shape) -> Relation:
    """Return the exact relation of two convex shapes as closed sets."""
    if isinstance(a, Circle):
        return circles(a, b) if isinstance(b, Circle) else circle_polygon(a, b)
    return circle_polygon(b, a) if isinstance(b, Circle) else polygons(a, b)


def polygons(a: Polygon, b: Polygon) -> Relation:
    """Return the relation of two polygons by clipping a to b: an area is left, only a point or segment, or nothing."""
    _, rings = _rings(a, b)
    return _relation_by_clipping(*rings)


def circle_polygon(circle: Circle, polygon: Polygon) -> Relation:
    """Return the relation of a circle and a polygon, by the squared distance from the center to the polygon."""
    _, (cx, cy, r, *flat) = _integers((*circle.center, circle.radius, *(c for v in polygon.vertices for c in v)))
    ring = _distinct(zip(flat[::2], flat[1::2], strict=True))
    if _inside((cx, cy), ring):
        return Relation.OVERLAPPING
    nearest = min(_segment_distance2((cx, cy), p, q) for p, q in _edges(ring))
    return _relation_by_distance(nearest, r * r)


def circles(a: Circle, b: Circle) -> Relation:
    """Return the relation of two circles, by the squares of the centers' distance and of the sum of the radii."""
    _, (ax, ay, ar, bx, by, br) = _integers((*a.center, a.radius, *b.center, b.radius))
    return _relation_by_distance((ax - bx) ** 2 + (ay - by) ** 2, (ar + br) ** 2)


def agreed(a: Shape, b: Shape) -> Relation:
    """Return the exact relation of two convex shapes; AssertionError if two oracles do not agree on it."""
    if isinstance(a, Polygon) and isinstance(b, Polygon):
        return relation_moved(a, b, (0.0, 0.0))
    found = relation(a, b)
    if relation_by_axes(a, b) != found:
        raise AssertionError(f"the oracles disagree about {a} and {b}")
    return found


def relation_moved(a: Polygon, b: Polygon, move: tuple[float, float]) -> Relation:
    """Return what `agreed` returns for two convex polygons after b has moved by exactly `move`."""
    _, rings = _rings(a, b, move)
    found = _relation_by_clipping(*rings)
    if _relation_by_difference(*rings) != found:
        raise AssertionError(f"the oracles disagree about {a} and {b} moved by {move}")
    return found


def relation_by_difference(a: Polygon, b: Polygon) -> Relation:
    """Return the relation of two convex polygons, by the side of each edge of a - b on which the origin lies."""
    _, rings = _rings(a, b)
    return _relation_by_difference(*rings)


def relation_by_axes(a: Shape, b: Shape) -> Relation:
    """Return the relation of a convex shape and a circle (a or b), by the largest gap on an axis less the radii."""
    a, b = (a, b) if isinstance(a, Circle) else (b, a)
    assert isinstance(a, Circle), "two polygons have no radius"
    points, other_radius = ((b.center,), b.radius) if isinstance(b, Circle) else (b.vertices, 0.0)
    _, (cx, cy, r, s, *flat) = _integers((*a.center, a.radius, other_radius, *(c for v in points for c in v)))
    ring = [(x - cx, y - cy) for x, y in zip(flat[::2], flat[1::2], strict=True)]  # the center is the origin
    if len(ring) > 2:
        ring = _counter_clockwise(ring)
    normals = [(qy - py, px - qx) for (px, py), (qx, qy) in _edges(ring)] if len(ring) > 2 else []
    nx, ny = min(ring, key=lambda v: v[0] ** 2 + v[1] ** 2)
    found = Relation.OVERLAPPING
    for ux, uy in (*((-x, -y) for x, y in normals), (nx, ny)):  # from the circle to the other shape
        gap = min(ux * x + uy * y for x, y in ring)
        reach = (r + s) ** 2 * (ux * ux + uy * uy)  # the square of the radii, as long as this normal makes them
        root = isqrt(reach)
        if gap > root:
            return Relation.APART
        if gap == root and root * root == reach and reach:
            found = Relation.TOUCHING
    return found


def squared_gap(a: Polygon, b: Polygon) -> Fraction:
    """Return the exact square of the gap between two convex polygons, on the edge normal where it is largest.

    Where they overlap it is the square of the penetration depth, the least of the overlaps on the edge normals.  Where
    two corners face each other, the distance of the polygons is larger than this gap.
    """
    k, sides = _sides_of_difference(a, b)
    beyond = [Fraction(side * side, nx * nx + ny * ny) for side, (nx, ny) in sides if side < 0]
    return (max(beyond) if beyond else _least_squared_distance(sides)) / Fraction(4**k)


def mtv_directions(a: Polygon, b: Polygon) -> list[Ints]:
    """Return vectors, of any length, in the directions of the shortest push of b that ends the overlap of a and b."""
    _, sides = _sides_of_difference(a, b)
    least = _least_squared_distance(sides)
    return [(nx, ny) for side, (nx, ny) in sides if Fraction(side * side, nx * nx + ny * ny) == least]


def _least_squared_distance(sides: Iterable[tuple[int, Ints]]) -> Fraction:
    """Return the squared distance of the origin from the nearest line of the sides of `_sides_of_difference`."""
    return min(Fraction(side * side, nx * nx + ny * ny) for side, (nx, ny) in sides)


def _sides_of_difference(a: Polygon, b: Polygon) -> tuple[int, list[tuple[int, Ints]]]:
    """Return (k, sides): for each edge of the difference a - b, scaled by 2**k, (depth of the origin, outward normal).

    The depth is positive where the origin lies on the inner side of the edge, and times the length of the normal.
    """
    k, rings = _rings(a, b)
    return k, [(px * qy - py * qx, (qy - py, px - qx)) for (px, py), (qx, qy) in _edges(_difference(*rings))]


def _relation_by_clipping(p: Sequence[Ints], q: Sequence[Ints]) -> Relation:
    """Return the relation of two convex rings by clipping p to q; see `polygons`."""
    common = _clipped(p, q)
    if not common:
        return Relation.APART
    return Relation.OVERLAPPING if _has_area(common) else Relation.TOUCHING


def _relation_by_difference(p: Sequence[Ints], q: Sequence[Ints]) -> Relation:
    """Return the relation of two convex rings, by the side of each edge of p - q on which the origin lies."""
    least = min(px * qy - py * qx for (px, py), (qx, qy) in _edges(_difference(p, q)))
    return Relation.OVERLAPPING if least > 0 else Relation.APART if least < 0 else Relation.TOUCHING


def _difference(p: Sequence[Ints], q: Sequence[Ints]) -> list[Ints]:
    """Return the Minkowski difference p - q: the convex hull of all differences of corners, counter-clockwise."""
    points = sorted({(px - qx, py - qy) for px, py in p for qx, qy in q})

    def chain(ordered: Sequence[Ints]) -> list[Ints]:
        """Return one half of the hull, by Andrew's monotone chain, without its last point."""
        kept: list[Ints] = []
        for x, y in ordered:
            while len(kept) > 1:
                (ox, oy), (px, py) = kept[-2:]
                if (px - ox) * (y - oy) - (py - oy) * (x - ox) > 0:
                    break
                kept.pop()
            kept.append((x, y))
        return kept[:-1]

    return chain(points) + chain(points[::-1])


def orientation(p: Iterable[Number], q: Iterable[Number], r: Iterable[Number]) -> Fraction:
    """Return the orientation determinant of p, q, r exactly: twice the signed area of the triangle."""
    (px, py), (qx, qy), (rx, ry) = (exact(v) for v in (p, q, r))
    return (qx - px) * (ry - py) - (qy - py) * (rx - px)


def exact(v: Iterable[Number]) -> Rational:
    """Return the point v with its coordinates as Fractions, without rounding."""
    x, y = (Fraction(c) for c in v)
    return x, y


def twice_signed_area(vertices: Iterable[Iterable[Number]]) -> Fraction:
    """Return twice the signed area of an outline, exactly; positive if it runs counter-clockwise."""
    ring = [exact(v) for v in vertices]
    return sum((px * qy - py * qx for (px, py), (qx, qy) in _edges(ring)), Fraction(0))


def _relation_by_distance(squared_distance: int | Fraction, squared_radius: int) -> Relation:
    """Return the relation: apart above the squared radius, touching at it, overlapping below it."""
    if squared_distance == squared_radius:
        return Relation.TOUCHING
    return Relation.APART if squared_distance > squared_radius else Relation.OVERLAPPING


def _integers(values: Sequence[float]) -> tuple[int, list[int]]:
    """Return (k, the integers value * 2**k); every float64 is an integer over a power of two."""
    ratios = [value.as_integer_ratio() for value in values]
    unit = max(den for _, den in ratios)
    return unit.bit_length() - 1, [num * (unit // den) for num, den in ratios]


def _rings(a: Polygon, b: Polygon, move: tuple[float, float] = (0.0, 0.0)) -> tuple[int, tuple[list[Ints], list[Ints]]]:
    """Return (k, outlines): both scaled to integers by 2**k, counter-clockwise, without repeated corners; b moved."""
    k, (dx, dy, *flat) = _integers([*move, *(c for v in (*a.vertices, *b.vertices) for c in v)])
    points = list(zip(flat[::2], flat[1::2], strict=True))
    n = len(a.vertices)
    return k, (_counter_clockwise(points[:n]), _counter_clockwise([(x + dx, y + dy) for x, y in points[n:]]))


def _counter_clockwise(points: Sequence[Ints]) -> list[Ints]:
    """Return the ring without repeated corners, counter-clockwise."""
    ring = _distinct(points)
    twice = sum(px * qy - py * qx for (px, py), (qx, qy) in _edges(ring))
    assert twice, "the polygon has no area"
    return ring if twice > 0 else ring[::-1]


def _distinct(points: Iterable[Point]) -> list[Point]:
    """Return the points as a ring, without those that equal the point before."""
    ring: list[Point] = []
    for p in points:
        if not ring or ring[-1] != p:
            ring.append(p)
    while len(ring) > 1 and ring[0] == ring[-1]:
        ring.pop()
    return ring


def _edges(ring: Sequence[Point]) -> Iterable[tuple[Point, Point]]:
    """Return the edges (p, q) of a ring, the closing one last."""
    return zip(ring, [*ring[1:], ring[0]], strict=True)


def _clipped(ring: Sequence[Ints], window: Sequence[Ints]) -> list[Homogeneous]:
    """Return the corners of the intersection of two convex rings; may be flat or empty (Sutherland and Hodgman)."""
    left: list[Homogeneous] = [(x, y, 1) for x, y in ring]
    for (px, py), (qx, qy) in _edges(window):
        ex, ey = qx - px, qy - py
        sides = [ex * (y - py * w) - ey * (x - px * w) for x, y, w in left]
        if min(sides) >= 0:
            continue
        if max(sides) < 0:
            return []
        kept: list[Homogeneous] = []
        for i, (point, side) in enumerate(zip(left, sides, strict=True)):
            before, side_before = left[i - 1], sides[i - 1]
            if side * side_before < 0:
                kept.append(_between(point, side, before, side_before))
            if side >= 0:
                kept.append(point)
        left = kept
    return left


def _between(p: Homogeneous, s: int, q: Homogeneous, t: int) -> Homogeneous:
    """Return the point where the segment p q crosses a line; s, t: signed sides of p and q, of opposite signs."""
    if s < 0:
        p, s, q, t = q, t, p, s
    x, y, w = (s * b - t * a for a, b in zip(p, q, strict=True))
    common = gcd(x, y, w)
    return x // common, y // common, w // common


def _has_area(points: Sequence[Homogeneous]) -> bool:
    """Return whether some three of the points are not collinear."""
    ox, oy, ow = points[0]
    arms = [(x * ow - ox * w, y * ow - oy * w) for x, y, w in points[1:]]
    arms = [arm for arm in arms if arm != (0, 0)]
    return any(arms[0][0] * y != arms[0][1] * x for x, y in arms[1:])


def _inside(c: Ints, ring: Sequence[Ints]) -> bool:
    """Return whether the point c lies inside the ring, by crossings of a ray; either answer for a point on the ring."""
    cx, cy = c
    odd = False
    for (px, py), (qx, qy) in _edges(ring):
        if (py > cy) != (qy > cy):
            side = (qx - px) * (cy - py) - (cx - px) * (qy - py)
            odd ^= (side > 0) == (qy > py)
    return odd


def _segment_distance2(c: Ints, p: Ints, q: Ints) -> Fraction | int:
    """Return the squared distance of the point c from the segment p q."""
    (cx, cy), (px, py), (qx, qy) = c, p, q
    dx, dy = qx - px, qy - py
    along, length2 = (cx - px) * dx + (cy - py) * dy, dx * dx + dy * dy
    if along <= 0:
        return (cx - px) ** 2 + (cy - py) ** 2
    if along >= length2:
        return (cx - qx) ** 2 + (cy - qy) ** 2
    # |c - p|^2 minus the square of its component along the segment (Pythagoras)
    return (cx - px) ** 2 + (cy - py) ** 2 - Fraction(along * along, length2)
