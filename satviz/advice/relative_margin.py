"""gamma: how finely a pair must be resolved, in roundings; no unit, and the same at every power of two of its size.

    gamma = |the turn that decides| / (u * span * reach)

u is 2**-53, the rounding of float64; in units of float32's, gamma is 2**29 times smaller (`IN_FLOAT32`).

Polygons: an edge *clears* by the least of its turns (orient2d) with the other shape's corners, positive
where all lie beyond it.  Measured in the edge's span (its larger component) times the pair's reach (the largest
magnitude of a coordinate of both), the edge that clears most decides: where it is positive they are apart, and
where it is negative even the last edge is refuted by as much, so they overlap.  Touching has gamma 0, and
only touching.  Circles: an axis of length 1 stands in for the edge, so gamma is the gap (negative by the depth
along the way out from the center) over u * reach, where a circle reaches its radius beyond its center.  Concave
polygons: of all pairs of their convex parts the one that clears least decides.

A sum of products of rounded differences is off by some u * span * reach, so gamma says what no unit does: plain
floats can be trusted where it is above their number of roundings, `proofs.py` says how many.  That holds while the
floats can hold the shapes and the products of their coordinates.  Where products leave the floats' range, or where
float32's grid is coarser than a shape, an answer can be wrong at any gamma.
"""

from collections.abc import Sequence
from fractions import Fraction

from ..engine.convex_parts import parts
from ..engine.predicates import IntPoint, aligned, root_difference
from ..engine.shapes import Shape, checked

IN_FLOAT32 = 2.0**-29


def relative_margin(a: Shape, b: Shape) -> float:
    """By how many roundings (2**-53 of span times reach) the pair is decided: 0 or more, and 0 only for touching.

    Right to the last place of the result; exact in its sign.  TypeError for anything but Polygon and Circle.
    """
    return abs(signed_relative_margin(a, b))


def signed_relative_margin(a: Shape, b: Shape) -> float:
    """The same, negative where they overlap."""
    checked(a, "a"), checked(b, "b")
    return min(_convex_margin(p, q) for p in parts(a) for q in parts(b))


def _convex_margin(a: Shape, b: Shape) -> float:
    p, q, radii, _ = aligned(a, b)
    if not radii:
        reach = max(abs(c) for ring in (p, q) for v in ring for c in v)
        best = max(_clears(p, q), _clears(q, p)) / reach
        return float(best * 2**53) or (best > 0) * 5e-324 - (best < 0) * 5e-324
    k = max(a.integers[0], b.integers[0])
    reach = max(
        max(map(abs, s.integers[1][0])) + s.integers[2] << k - s.integers[0] if s.core_is_point else _most(s, k)
        for s in (a, b)
    )
    size = reach.bit_length()
    shift = size - 53  # the gap in roundings already, as what is least must not be multiplied
    gap = _circle_gap(p[0], radii, q, shift) if len(p) == 1 else _circle_gap(q[0], radii, p, shift)
    return gap / (reach / (1 << size))


def _most(shape: Shape, k: int) -> int:
    own, ring, _ = shape.integers
    return max(abs(c) for v in ring for c in v) << k - own


def _clears(ring: Sequence[IntPoint], points: Sequence[IntPoint]) -> Fraction:
    """The most that an edge of the ring clears the points by, over its span."""
    best = None
    px, py = ring[-1]
    for qx, qy in ring:
        nx, ny = qy - py, px - qx
        clears = Fraction(min(nx * x + ny * y for x, y in points) - nx * px - ny * py, max(abs(nx), abs(ny)))
        best = clears if best is None else max(best, clears)
        px, py = qx, qy
    assert best is not None
    return best


def _circle_gap(center: IntPoint, r: int, ring: Sequence[IntPoint], shift: int) -> float:
    """The gap from a center with a radius to a ring (of one corner: another circle), in units of 2**shift."""
    cx, cy = center
    inner, outer = [], []
    px, py = ring[-1][0] - cx, ring[-1][1] - cy
    for qx, qy in ring:
        qx, qy = qx - cx, qy - cy
        dx, dy = qx - px, qy - py
        turn = px * dy - py * dx  # positive with the center inside this edge
        square = dx * dx + dy * dy
        if turn > 0:
            inner.append(root_difference(-turn, r, square, shift))
        else:
            along = -(px * dx + py * dy)
            x, y = (px, py) if along <= 0 else (qx, qy)
            away = x * x + y * y
            foot = 0 < along < square
            outer.append(root_difference(-turn if foot else away, r, square if foot else away or 1, shift))
        px, py = qx, qy
    return min(outer) if outer else max(inner)
