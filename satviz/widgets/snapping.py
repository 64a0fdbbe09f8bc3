"""Snapping: the nearest place of a shape where it touches another one exactly, if float64 has one nearby.

"Exactly" is what the engine says: the relation is touching.  Most places where two outlines meet have coordinates
that no float holds, so only candidates are tried: a corner on a corner, a corner on a point of an edge that a float
holds, an edge flush with an upright edge, and circles level with a corner or another center.
"""

from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise
from math import hypot

from ..engine.geometry import Relation, Vec
from ..engine.relate import relate
from ..engine.shapes import Circle, Polygon, Shape
from ..scenes.shape_tools import translated

MAX_TRIED = 400  # candidates whose relation is computed
EDGE_FRACTIONS = 64  # equal pieces of an edge, at whose ends a corner may land
LEVEL = (1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)
# directions in which an integer distance has integer sides
TRIPLES = (3, 4, 5), (5, 12, 13), (8, 15, 17), (7, 24, 25)


def snapped(moved: Shape, other: Shape, reach: float) -> Shape | None:
    """Return `moved` translated to the nearest place found where it touches `other`, or None.

    The place is at most `reach` away, in scene units.  The function raises no ValueError.
    """
    tried: dict[Vec, float] = {}
    for move in _moves(moved, other):
        size = hypot(*move)
        if 0 < size <= reach:
            tried.setdefault(move, size)
    for move in sorted(tried, key=lambda m: tried[m])[:MAX_TRIED]:
        try:
            there = translated(moved, move)
            if relate(there, other) is Relation.TOUCHING:
                return there
        except ValueError:  # rounding made the outline cross itself
            continue
    return None


def _moves(moved: Shape, other: Shape) -> Iterator[Vec]:
    """Yield translations of `moved` after which it may touch `other`."""
    for corner in _corners(moved):
        for spot in _touch_points(other, corner):
            yield Vec(spot.x - corner.x, spot.y - corner.y)
    for corner in _corners(other):
        for spot in _touch_points(moved, corner):
            yield Vec(corner.x - spot.x, corner.y - spot.y)
    if isinstance(moved, Circle) or isinstance(other, Circle):
        yield from _moves_of_circles(moved, other)


def _corners(shape: Shape) -> tuple[Vec, ...]:
    """Return the corners of a polygon; a circle has none."""
    return shape.corners if isinstance(shape, Polygon) else ()


def _touch_points(shape: Shape, near: Vec) -> Iterator[Vec]:
    """Yield points where a corner at `near` may come to touch a polygon: its corners, and points of its edges.

    Of an edge only points near `near` that floats hold exactly; of an upright edge the point of its line level with
    `near`, which may lie beyond its ends.  A circle yields none.
    """
    if not isinstance(shape, Polygon):
        return
    for p, q in pairwise((*shape.corners, shape.corners[0])):
        yield p
        if p.x == q.x:
            yield Vec(p.x, near.y)
        elif p.y == q.y:
            yield Vec(near.x, p.y)
        else:
            (px, py), (dx, dy) = map(Fraction, p), (Fraction(q.x) - Fraction(p.x), Fraction(q.y) - Fraction(p.y))
            foot = ((Fraction(near.x) - px) * dx + (Fraction(near.y) - py) * dy) / (dx * dx + dy * dy)
            middle = round(foot * EDGE_FRACTIONS)
            for k in range(middle - EDGE_FRACTIONS // 4, middle + EDGE_FRACTIONS // 4 + 1):
                x, y = px + dx * k / EDGE_FRACTIONS, py + dy * k / EDGE_FRACTIONS
                if 0 < k < EDGE_FRACTIONS and float(x) == x and float(y) == y:
                    yield Vec(float(x), float(y))


def _moves_of_circles(moved: Shape, other: Shape) -> Iterator[Vec]:
    """Yield translations after which a circle may touch the other shape."""
    sign = 1.0 if isinstance(moved, Circle) else -1.0
    circle, rest = (moved, other) if isinstance(moved, Circle) else (other, moved)
    assert isinstance(circle, Circle)
    (x, y), r = circle.center, circle.radius
    if isinstance(rest, Circle):
        centers, r = [rest.center], r + rest.radius
    else:
        centers = list(rest.corners)
        for p, q in pairwise((*rest.corners, rest.corners[0])):
            for side in (-r, r):
                if p.x == q.x:
                    yield Vec(sign * (p.x + side - x), 0.0)
                if p.y == q.y:
                    yield Vec(0.0, sign * (p.y + side - y))
    for cx, cy in centers:
        for ux, uy in LEVEL:
            yield Vec(sign * (cx + ux * r - x), sign * (cy + uy * r - y))
        for a, b, c in TRIPLES:
            for ux, uy in ((a, b), (b, a)):
                for sx in (-1, 1):
                    for sy in (-1, 1):
                        yield Vec(sign * (cx + sx * ux * r / c - x), sign * (cy + sy * uy * r / c - y))
