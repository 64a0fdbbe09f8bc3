"""The exact relation of two shapes in rationals: satviz.study.truth, extended to concave outlines.

`naive` computes it a second time in the simplest way, as a check of the first.
"""

import functools
import math
from collections.abc import Iterable, Sequence
from fractions import Fraction

from satviz.engine.geometry import Relation
from satviz.engine.shapes import Circle, Polygon, Shape
from satviz.study import truth

APART, TOUCHING, OVERLAPPING = Relation


def relation(a: Shape, b: Shape) -> Relation:
    """Return the exact relation of any two shapes as closed sets."""
    return max(truth.relation(p, q) for p in pieces(a) for q in pieces(b))


def pieces(shape: Shape) -> Sequence[Shape]:
    """Return convex shapes that make up a shape."""
    return [shape] if isinstance(shape, Circle) or shape.is_convex else ears(shape)


# -- outlines --------------------------------------------------------------------------------------


def cross(p: Sequence, q: Sequence, r: Sequence) -> Fraction:
    """Return the orientation determinant of three points."""
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def edges(ring: Sequence) -> list:
    """Return the edges of a ring as pairs of points."""
    return list(zip(ring, [*ring[1:], ring[0]], strict=True))


def on_segment(v: Sequence, p: Sequence, q: Sequence) -> bool:
    """Return whether a point is on a closed segment."""
    inside = min(p[0], q[0]) <= v[0] <= max(p[0], q[0]) and min(p[1], q[1]) <= v[1] <= max(p[1], q[1])
    return inside and cross(p, q, v) == 0


def meet(p: Sequence, q: Sequence, r: Sequence, s: Sequence) -> bool:
    """Return whether two closed segments share a point."""
    a, b, c, d = cross(p, q, r), cross(p, q, s), cross(r, s, p), cross(r, s, q)
    if (a > 0) != (b > 0) and (c > 0) != (d > 0) and a and b and c and d:
        return True
    return on_segment(r, p, q) or on_segment(s, p, q) or on_segment(p, r, s) or on_segment(q, r, s)


def is_simple(vertices: Iterable) -> bool:
    """Return whether an outline, without repeated neighbours, is a simple polygon; all pairs of edges are compared."""
    ring = [truth.exact(v) for v in vertices]
    ring = [p for i, p in enumerate(ring) if p != ring[i - 1]]
    n = len(ring)
    if n < 3:
        return False
    sides = edges(ring)
    for i, (p, q) in enumerate(sides):
        for j, (r, s) in enumerate(sides[:i]):
            if j == i - 1 or (j == 0 and i == n - 1):
                # neighbours share one end, and may share nothing else
                shared, one, other = (p, q, r) if j == i - 1 else (q, p, s)
                if on_segment(one, shared, other) or on_segment(other, shared, one):
                    return False
            elif meet(p, q, r, s):
                return False
    return True


def squared_distance(a: Polygon, b: Polygon) -> Fraction:
    """Return the exact squared distance of two convex polygons; 0 where they touch or overlap."""
    if relation(a, b):
        return Fraction(0)
    p, q = ([truth.exact(v) for v in shape.vertices] for shape in (a, b))
    return min(segment_distance2(v, *edge) for ring, other in ((p, q), (q, p)) for v in other for edge in edges(ring))


def segment_distance2(v: Sequence, p: Sequence, q: Sequence) -> Fraction:
    """Return the squared distance of a point from a segment."""
    dx, dy = q[0] - p[0], q[1] - p[1]
    square = dx * dx + dy * dy
    t = min(1, max(0, ((v[0] - p[0]) * dx + (v[1] - p[1]) * dy) / square)) if square else 0
    return (p[0] + t * dx - v[0]) ** 2 + (p[1] + t * dy - v[1]) ** 2


def holds(ring: Sequence, v: Sequence) -> bool:
    """Return whether a closed outline contains a point: on an edge, or by an odd number of crossings on its right."""
    if any(on_segment(v, p, q) for p, q in edges(ring)):
        return True
    rows = [(p, q) if p[1] < q[1] else (q, p) for p, q in edges(ring)]
    return sum(p[1] <= v[1] < q[1] and cross(p, q, v) > 0 for p, q in rows) % 2 == 1


def integers(*rings: Iterable[Sequence]) -> list[list[tuple[int, int]]]:
    """Return the rings in one unit in which all their coordinates are integers."""
    exact = [[(Fraction(x), Fraction(y)) for x, y in ring] for ring in rings]
    unit = math.lcm(*(c.denominator for ring in exact for p in ring for c in p))
    return [[(int(x * unit), int(y * unit)) for x, y in ring] for ring in exact]


@functools.lru_cache(maxsize=4)
def ears(polygon: Polygon) -> list[Polygon]:
    """Return a polygon cut into triangles by clipping ears, which is not the method of satviz."""
    vertices = polygon.vertices if truth.twice_signed_area(polygon.vertices) > 0 else polygon.vertices[::-1]
    (at,) = integers(vertices)
    left, found = list(range(len(at))), []

    def clips(a: int, b: int, c: int) -> bool:
        """Return whether the triangle of three remaining vertices is an ear."""
        sides = [(at[a], at[b]), (at[b], at[c]), (at[c], at[a])]
        # a repeated vertex is not in the way of an ear
        others = (at[v] for v in left if at[v] not in (at[a], at[b], at[c]))
        return cross(at[a], at[b], at[c]) > 0 and not any(all(cross(*s, v) >= 0 for s in sides) for v in others)

    while len(left) > 2:
        for i, b in enumerate(left):
            a, c = left[i - 1], left[(i + 1) % len(left)]
            straight = cross(at[a], at[b], at[c]) == 0
            if straight or clips(a, b, c):
                if not straight:
                    found.append(Polygon([vertices[a], vertices[b], vertices[c]]))
                left.pop(i)
                break
        else:
            raise AssertionError(f"no ear left: {polygon!r}")
    return found


# -- the simplest way ------------------------------------------------------------------------------


def naive(a: Shape, b: Shape) -> Relation:
    """Return the relation in fractions, from the corners of the common part of two outlines or the nearest point."""
    if isinstance(b, Circle):
        a, b = b, a
    if not isinstance(a, Circle):
        return _common(_fractions(a), _fractions(b))
    center, radius = (Fraction(a.center.x), Fraction(a.center.y)), Fraction(a.radius)
    if isinstance(b, Circle):
        ring, radius = [(Fraction(b.center.x), Fraction(b.center.y))], radius + Fraction(b.radius)
    else:
        ring = _fractions(b)
        if all(cross(p, q, center) > 0 for p, q in edges(ring)):
            return OVERLAPPING
    near = min(_distance2(center, p, q) for p, q in edges(ring))
    return APART if near > radius**2 else OVERLAPPING if near < radius**2 else TOUCHING


def _fractions(polygon: Polygon) -> list[tuple[Fraction, Fraction]]:
    """Return the distinct vertices of a polygon in fractions, counter-clockwise."""
    ring = list(dict.fromkeys((Fraction(x), Fraction(y)) for x, y in polygon.vertices))
    return ring if sum(p[0] * q[1] - p[1] * q[0] for p, q in edges(ring)) > 0 else ring[::-1]


def _common(p: Sequence, q: Sequence) -> Relation:
    """Return the relation of convex rings, from all corners of one inside the other and all crossings of edges."""
    found = {v for one, other in ((p, q), (q, p)) for v in one if all(cross(*e, v) >= 0 for e in edges(other))}
    for (a, b), (c, d) in ((e, f) for e in edges(p) for f in edges(q)):
        before, after = cross(c, d, a), cross(c, d, b)
        if before * after < 0 and cross(a, b, c) * cross(a, b, d) < 0:
            t = before / (before - after)
            found.add((a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t))
    if not found:
        return APART
    first, *others = found
    return OVERLAPPING if any(cross(first, v, w) for v in others for w in others) else TOUCHING


def _distance2(c: Sequence, p: Sequence, q: Sequence) -> Fraction:
    """Return the squared distance of a point from a segment."""
    dx, dy = q[0] - p[0], q[1] - p[1]
    square = dx * dx + dy * dy
    t = min(max(((c[0] - p[0]) * dx + (c[1] - p[1]) * dy) / square, Fraction(0)), Fraction(1)) if square else 0
    return (p[0] + t * dx - c[0]) ** 2 + (p[1] + t * dy - c[1]) ** 2
