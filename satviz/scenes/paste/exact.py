"""Exact relations of shapes in fractions: of the decimals as written, and who contains whom.

The engine takes float64 and is exact for it.  Here the coordinates are whole numbers of any size, so the decimals of a
text are compared as they stand.  Convex shapes go to the engine's own integer test.
"""

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from math import lcm
from typing import NamedTuple

from ...engine.geometry import Relation, cyclic_pairs, cyclic_triples
from ...engine.predicates import orient_det
from ...engine.relate import relate_integers

APART, TOUCHING, OVERLAPPING = Relation
MAX_EDGE_PAIRS = 60_000  # pairs of edges of concave outlines: a second of work
Pt = tuple[Fraction, Fraction]
IntPt = tuple[int, int]


class Exact(NamedTuple):
    """A shape in exact numbers: the corners of an outline, or a circle's center and its radius."""

    points: tuple[Pt, ...]
    radius: Fraction | None = None


class _Ints(NamedTuple):
    """A shape in whole numbers, counter-clockwise and without straight corners."""

    ring: list[IntPt]
    radius: int | None
    convex: bool


class Where(NamedTuple):
    """How two shapes lie: their relation, and whether one contains the other (None where it would take too long).

    `at_border`: one contains the other, and their borders share a point.
    """

    relation: Relation
    a_in_b: bool | None
    b_in_a: bool | None
    at_border: bool = False


def where(a: Exact, b: Exact) -> Where | None:
    """Return the exact relation of two valid shapes; None for concave outlines with too many corners."""
    p, q = _integers(a, b)
    if not (p.convex and q.convex) and len(p.ring) * len(q.ring) > MAX_EDGE_PAIRS:
        return None
    relation = _relation(p, q)
    if relation is not OVERLAPPING:
        return Where(relation, False, False)
    a_in_b, b_in_a = _inside(q, p), _inside(p, q)
    return Where(relation, a_in_b >= 0, b_in_a >= 0, 0 in (a_in_b, b_in_a))


def twice_area(ring: Sequence[tuple[Fraction, Fraction]]) -> Fraction:
    """Return twice the signed area of an outline, positive if it is counter-clockwise."""
    return sum((p[0] * q[1] - p[1] * q[0] for p, q in cyclic_pairs(ring)), Fraction(0))


class Crossing(NamedTuple):
    """Where two edges of an outline cross: the point, and the numbers of both edges, from 0."""

    point: Pt
    first: int
    second: int


def crossing(points: Sequence[Pt]) -> Crossing | None:
    """Return the point where two edges of an outline cross; None if none do, or for more than 300 corners."""
    edges = list(cyclic_pairs(points)) if len(points) <= 300 else []
    for i, (a, b) in enumerate(edges):
        for j, (r, s) in enumerate(edges[:i]):
            before, after = orient_det(r, s, a), orient_det(r, s, b)
            if before * after < 0 and orient_det(a, b, r) * orient_det(a, b, s) < 0:
                t = before / (before - after)
                return Crossing((a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])), j, i)
    return None


def hull(points: Sequence[Pt]) -> list[Pt]:
    """Return the convex hull, counter-clockwise (Andrew's monotone chain)."""
    ordered = sorted(set(points))

    def half(row: Sequence[Pt]) -> list[Pt]:
        """Return one side of the hull without its last point."""
        kept: list[Pt] = []
        for p in row:
            while len(kept) > 1 and orient_det(kept[-2], kept[-1], p) <= 0:
                kept.pop()
            kept.append(p)
        return kept[:-1]

    return half(ordered) + half(ordered[::-1])


def _integers(a: Exact, b: Exact) -> tuple[_Ints, _Ints]:
    """Return both shapes in one unit in which all their numbers are whole."""
    numbers = [c for s in (a, b) for p in s.points for c in p] + [s.radius for s in (a, b) if s.radius is not None]
    unit = lcm(*(c.denominator for c in numbers))
    return _whole(a, unit), _whole(b, unit)


def _whole(shape: Exact, unit: int) -> _Ints:
    """Return a shape in whole numbers."""
    ring = [(int(x * unit), int(y * unit)) for x, y in shape.points]
    if shape.radius is not None:
        return _Ints(ring, int(shape.radius * unit), True)
    ring = [p for p, q in cyclic_pairs(ring) if p != q]
    turns = [(q, orient_det(p, q, r)) for p, q, r in cyclic_triples(ring)]
    ring = [p for p, turn in turns if turn]
    if sum(p[0] * q[1] - p[1] * q[0] for p, q in cyclic_pairs(ring)) < 0:
        ring = ring[::-1]
    return _Ints(ring, None, len({turn > 0 for _, turn in turns if turn}) == 1)


def _relation(p: _Ints, q: _Ints) -> Relation:
    """Return the relation of two shapes in whole numbers."""
    if p.convex and q.convex:
        return relate_integers(p.ring, q.ring, (p.radius or 0) + (q.radius or 0))
    if p.radius is not None or q.radius is not None:
        circle, polygon = (p, q) if p.radius is not None else (q, p)
        (center,), radius = circle.ring, circle.radius or 0
        if _place(center, polygon.ring) > 0:
            return OVERLAPPING
        near = min(_square_distance(center, *edge) for edge in cyclic_pairs(polygon.ring))
        return APART if near > radius**2 else TOUCHING if near == radius**2 else OVERLAPPING
    return _relation_of_outlines(p.ring, q.ring)


def _relation_of_outlines(p: list[IntPt], q: list[IntPt]) -> Relation:
    """Return the relation of two simple outlines.

    Their insides meet if edges cross, if a piece of one border between two contacts lies inside the other, or if
    they are equal: without such a piece each border stays outside the other's inside, so both insides are the same.
    """
    touch = False
    for one, other in ((p, q), (q, p)):
        for place in _places_along(one, other):
            if place > 0:
                return OVERLAPPING
            touch = touch or place == 0
    if not touch:
        return APART
    return OVERLAPPING if set(p) == set(q) and all(x == 0 for x in _places_along(p, q)) else TOUCHING


def _places_along(ring: list[IntPt], other: list[IntPt]) -> list[int]:
    """Return for each corner and piece of a border whether it lies outside (-1), on (0) or inside (1) the other."""
    found = []
    edges = list(cyclic_pairs(other))
    for a, b in cyclic_pairs(ring):
        cuts = {Fraction(0), Fraction(1)}
        dx, dy = b[0] - a[0], b[1] - a[1]
        square = dx * dx + dy * dy
        for r, s in edges:
            if max(r[0], s[0]) < min(a[0], b[0]) or max(a[0], b[0]) < min(r[0], s[0]):
                continue
            if max(r[1], s[1]) < min(a[1], b[1]) or max(a[1], b[1]) < min(r[1], s[1]):
                continue
            first, second = orient_det(a, b, r), orient_det(a, b, s)
            for v, side in ((r, first), (s, second)):
                if side == 0:
                    cuts.add(Fraction((v[0] - a[0]) * dx + (v[1] - a[1]) * dy, square))
            if first * second < 0:
                before, after = orient_det(r, s, a), orient_det(r, s, b)
                if before * after <= 0 and before != after:
                    cuts.add(Fraction(before, before - after))
        inside = sorted(t for t in cuts if 0 <= t <= 1)
        for t in [t for t in inside if t < 1] + [(t + u) / 2 for t, u in pairwise(inside)]:
            n, d = t.as_integer_ratio()
            found.append(_place((a[0] * d + n * dx, a[1] * d + n * dy), other, d))
    return found


def _place(point: IntPt, ring: list[IntPt], unit: int = 1) -> int:
    """Return 1 for the point x / unit, y / unit inside an outline, 0 on its border, -1 outside."""
    x, y = point
    inside = False
    for (px, py), (qx, qy) in cyclic_pairs(ring):
        below_p, below_q = py * unit - y, qy * unit - y
        if below_p * below_q > 0:
            continue  # the edge is wholly above the point or below it
        right_p, right_q = px * unit - x, qx * unit - x
        turn = right_p * below_q - right_q * below_p
        if turn == 0 and right_p * right_q <= 0:
            return 0
        if (below_p > 0) != (below_q > 0) and (turn > 0) == (qy > py):
            inside = not inside
    return 1 if inside else -1


def _square_distance(c: IntPt, p: IntPt, q: IntPt) -> Fraction:
    """Return the squared distance of a point from a segment."""
    dx, dy = q[0] - p[0], q[1] - p[1]
    t = min(max(Fraction((c[0] - p[0]) * dx + (c[1] - p[1]) * dy, dx * dx + dy * dy), Fraction(0)), Fraction(1))
    return (p[0] + t * dx - c[0]) ** 2 + (p[1] + t * dy - c[1]) ** 2


def _inside(outer: _Ints, inner: _Ints) -> int:
    """Return 1 where `inner` lies inside `outer`, 0 where it also touches the border, -1 where it lies not inside.

    The shapes share some inside.
    """
    if outer.radius is not None:
        (center,) = outer.ring
        reach = outer.radius - (inner.radius or 0)
        left = [reach * reach - (x - center[0]) ** 2 - (y - center[1]) ** 2 for x, y in inner.ring]
        return _sign(min(left)) if reach >= 0 else -1
    if inner.radius is not None:
        (center,), square = inner.ring, inner.radius**2
        if outer.convex:  # no square root: the signed distance of the center from each edge
            sides = [
                (orient_det(p, q, center), (q[0] - p[0]) ** 2 + (q[1] - p[1]) ** 2) for p, q in cyclic_pairs(outer.ring)
            ]
            return min(_sign(turn * turn - square * length) if turn >= 0 else -1 for turn, length in sides)
        near = min(_square_distance(center, *edge) for edge in cyclic_pairs(outer.ring))
        return _sign(near - square) if _place(center, outer.ring) > 0 else -1
    if outer.convex:
        return min(_sign(orient_det(p, q, v)) for p, q in cyclic_pairs(outer.ring) for v in inner.ring)
    return min(_places_along(inner.ring, outer.ring))


def _sign(value: int | Fraction) -> int:
    """Return 1, 0 or -1."""
    return (value > 0) - (value < 0)


def centroid(ring: Sequence[Pt]) -> Pt:
    """Return the center of area of an outline; the mean of its corners if it has no area."""
    area = x = y = Fraction(0)
    for (px, py), (qx, qy) in zip(ring, (*ring[1:], ring[0]), strict=True):
        cross = px * qy - py * qx
        area += cross
        x += cross * (px + qx)
        y += cross * (py + qy)
    if not area:
        return sum((p[0] for p in ring), Fraction(0)) / len(ring), sum((p[1] for p in ring), Fraction(0)) / len(ring)
    return x / area / 3, y / area / 3
