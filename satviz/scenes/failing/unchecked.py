"""What is asked of plain vertices that the engine would refuse, as it is asked where nobody refuses them."""

from collections.abc import Sequence
from math import hypot

from ...engine.geometry import Interval, Vec
from ...engine.shapes import Shape

Ring = Sequence[tuple[float, float]]
Outline = Shape | Ring


def edges(points: Ring) -> list[Vec]:
    """Each vertex taken from the next, the closing edge last."""
    return [Vec(q[0] - p[0], q[1] - p[1]) for p, q in zip(points, (*points[1:], points[0]))]


def best_gap(a: Ring, b: Ring) -> float:
    """The largest gap on all edge normals."""

    def span(points: Ring, dx: float, dy: float) -> Interval:
        landings = [(x * dy - y * dx) / hypot(dx, dy) for x, y in points]
        return Interval(min(landings), max(landings))

    return max(span(a, *edge).gap(span(b, *edge)) for edge in (*edges(b), *edges(a)))


def least_turn(a: Ring, b: Ring) -> float:
    """The smallest turn (cross product of neighbouring edges) of A: positive, and A is called convex."""
    around = edges(a)
    return min(p.x * q.y - p.y * q.x for p, q in zip(around, (*around[1:], around[0])))
