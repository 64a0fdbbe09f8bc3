"""SAT for two boxes in space, as plain as it gets: face normals, and the cross products of their edges.

Fifteen axes are enough: three face normals of each, and nine directions across one edge of either.
"""

from math import atan2, sqrt
from typing import NamedTuple

from ...engine.geometry import Interval, Vec

Vec3 = tuple[float, float, float]
S = sqrt(0.5)


class Box(NamedTuple):
    """A box: its center, three unit vectors along its edges, half its length along each."""

    center: Vec3
    axes: tuple[Vec3, Vec3, Vec3]
    half: Vec3 = (1.0, 1.0, 1.0)


class Gap(NamedTuple):
    """One axis: the edges it lies across ("A1 x B3") or the face it belongs to ("A1"), and the signed gap on it."""

    name: str
    axis: Vec3
    gap: float


# two cubes, an edge of one towards an edge of the other
PAIR = (
    Box((0.0, 0.0, 0.0), ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))),
    Box((3.3 * S, 3.3 * S, 0.0), ((S, -S, 0.0), (0.5, 0.5, S), (0.5, 0.5, -S))),
)


def dot(u: Vec3, v: Vec3) -> float:
    """The scalar product."""
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def cross(u: Vec3, v: Vec3) -> Vec3:
    """The vector product."""
    return u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]


def faces(a: Box, b: Box) -> list[Gap]:
    """The gaps on the six face normals."""
    return [gap(a, b, f"{who}{i}", n) for who, box in (("A", a), ("B", b)) for i, n in enumerate(box.axes, 1)]


def crosses(a: Box, b: Box) -> list[Gap]:
    """The gaps across an edge of each; edges that are parallel give no axis."""
    named = [(f"A{i} × B{j}", cross(u, v)) for i, u in enumerate(a.axes, 1) for j, v in enumerate(b.axes, 1)]
    return [gap(a, b, name, n) for name, n in named if dot(n, n) > 1e-12]


def gap(a: Box, b: Box, name: str, n: Vec3) -> Gap:
    """The signed gap on one axis, in scene units."""
    length = sqrt(dot(n, n))
    return Gap(name, n, span(a, n).gap(span(b, n)) / length)


def span(box: Box, n: Vec3) -> Interval:
    """A box's range on an axis: its center's place, and as far to each side as its edges reach."""
    at, reach = dot(box.center, n), sum(h * abs(dot(u, n)) for u, h in zip(box.axes, box.half, strict=True))
    return Interval(at - reach, at + reach)


def corners(box: Box) -> list[Vec3]:
    """The eight corners; the two that differ in bit i of their number are the ends of an edge along axis i."""
    found = []
    for number in range(8):
        signs = [1 if number >> i & 1 else -1 for i in range(3)]
        moves = [(s * h * u[0], s * h * u[1], s * h * u[2]) for s, h, u in zip(signs, box.half, box.axes, strict=True)]
        found.append(tuple(sum(parts) for parts in zip(box.center, *moves, strict=True)))
    return found


def seen_from_above(box: Box) -> list[Vec]:
    """The outline of a box's shadow on the ground: its edges' shadows, walked round in the order of their slopes."""
    steps = [(2 * h * u[0], 2 * h * u[1]) for h, u in zip(box.half, box.axes, strict=True) if u[0] or u[1]]
    steps = [(x, y) if (y, x) > (0, 0) else (-x, -y) for x, y in steps]
    steps.sort(key=lambda step: atan2(step[1], step[0]))
    merged = [steps[0]]
    for x, y in steps[1:]:
        last = merged[-1]
        if last[0] * y == last[1] * x:
            merged[-1] = last[0] + x, last[1] + y
        else:
            merged.append((x, y))
    x, y = (box.center[i] - sum(step[i] for step in merged) / 2 for i in (0, 1))
    ring = []
    for sign in (1, -1):
        for step in merged:
            ring.append(Vec(x, y))
            x, y = x + sign * step[0], y + sign * step[1]
    return ring
