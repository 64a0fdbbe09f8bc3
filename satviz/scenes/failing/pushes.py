"""Shortcuts on the way out: each push is the move of B that the shortcut would make to part the shapes."""

from math import hypot

from ...engine.geometry import Vec
from .shortcuts import Outline, Ring, both_normals, gap, raw_gap, ring, span, textbook


def way_out(a: Outline, b: Outline) -> Vec:
    """The shortest push along an edge normal, the right way: what the other pushes should have been."""
    n = max(both_normals(a, b), key=lambda n: gap(a, b, n))
    return away(a, b, n, -gap(a, b, n))


def away(a: Outline, b: Outline, n: Vec, length: float) -> Vec:
    """That far along n, towards the side on which B leaves A sooner."""
    p, q = span(a, n), span(b, n)
    scale = length / hypot(*n) * (1 if p.hi - q.lo < q.hi - p.lo else -1)
    return Vec(n[0] * scale, n[1] * scale)


def push_from_center(a: Outline, b: Outline) -> Vec:
    """The right axis and depth, in the direction from A's center to B's."""
    push, p, q = way_out(a, b), mean(a), mean(b)
    wrong_way = push.x * (q.x - p.x) + push.y * (q.y - p.y) < 0
    return Vec(-push.x, -push.y) if wrong_way else push


def mean(shape: Outline) -> Vec:
    """The middle of the vertices."""
    points = ring(shape)
    return Vec(sum(x for x, _ in points) / len(points), sum(y for _, y in points) / len(points))


def gap_after(a: Outline, b: Outline, push: Vec) -> float:
    """The gap that is left once B was pushed."""
    return textbook(a, [Vec(x + push.x, y + push.y) for x, y in ring(b)])


def after_push_from_center(a: Outline, b: Outline) -> float:
    """The gap that the push away from A's center leaves."""
    return gap_after(a, b, push_from_center(a, b))


def halves(a: Outline) -> tuple[Ring, Ring]:
    """A cut along the diagonal from its first vertex to the middle one."""
    points, k = ring(a), len(ring(a)) // 2
    return points[: k + 1], [*points[k:], points[0]]


def push_of_halves(a: Outline, b: Outline) -> Vec:
    """The pushes of both halves of A, added up."""
    pushes = [way_out(half, b) for half in halves(a) if textbook(half, b) < 0]
    return Vec(sum(p.x for p in pushes), sum(p.y for p in pushes))


def length_of_halves(a: Outline, b: Outline) -> float:
    """How far the push by half sums goes."""
    return hypot(*push_of_halves(a, b))


def raw_depth(a: Outline, b: Outline) -> float:
    """How far the axis of least raw depth really pushes."""
    return hypot(*push_raw(a, b))


def push_raw(a: Outline, b: Outline) -> Vec:
    """By the normal of the least overlap as it is, not made a unit."""
    n = max(both_normals(a, b), key=lambda n: raw_gap(a, b, n))
    return away(a, b, n, -gap(a, b, n)) if any(n) else Vec(0.0, 0.0)


def with_flat_overlap(a: Outline, b: Outline) -> float:
    """The least of (smaller maximum - larger minimum), which is no way out if one range holds the other."""
    return hypot(*push_flat_overlap(a, b))


def push_flat_overlap(a: Outline, b: Outline) -> Vec:
    """By min of maxima minus max of minima, which is no depth where one range holds the other."""

    def overlap(n: Vec) -> float:
        p, q = span(a, n), span(b, n)
        return (min(p.hi, q.hi) - max(p.lo, q.lo)) / hypot(*n)

    n = min(both_normals(a, b), key=overlap)
    return away(a, b, n, overlap(n))
