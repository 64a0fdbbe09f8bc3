"""SAT for two boxes in space: face normals, and the cross products of their edges.

Fifteen axes are enough: three face normals of each box, and the nine cross products of an edge of A and an edge of B.
"""

from math import atan2, sqrt
from typing import NamedTuple

from ...engine.geometry import Interval, Vec

Vec3 = tuple[float, float, float]
C = sqrt(0.5)  # the cosine of 45 degrees


class SolidBox(NamedTuple):
    """A box in space: its center, three unit vectors along its edges, half its length along each."""

    center: Vec3
    axes: tuple[Vec3, Vec3, Vec3]
    half: Vec3 = (1.0, 1.0, 1.0)


class AxisGap(NamedTuple):
    """The signed gap on one axis, named after the edges that it lies across ("A1 × B3") or after its face ("A1")."""

    name: str
    gap: float


# two cubes, an edge of one towards an edge of the other
PAIR = (
    SolidBox((0.0, 0.0, 0.0), ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))),
    SolidBox((3.3 * C, 3.3 * C, 0.0), ((C, -C, 0.0), (0.5, 0.5, C), (0.5, 0.5, -C))),
)


def dot(u: Vec3, v: Vec3) -> float:
    """Return the dot product of two vectors in space."""
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def cross(u: Vec3, v: Vec3) -> Vec3:
    """Return the cross product of two vectors in space."""
    return u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]


def face_gaps(a: SolidBox, b: SolidBox) -> list[AxisGap]:
    """Return the gaps on the six face normals."""
    return [gap_on_axis(a, b, f"{who}{i}", n) for who, box in (("A", a), ("B", b)) for i, n in enumerate(box.axes, 1)]


def edge_gaps(a: SolidBox, b: SolidBox) -> list[AxisGap]:
    """Return the gaps on the cross products of one edge of each box; parallel edges give no axis."""
    named = [(f"A{i} × B{j}", cross(u, v)) for i, u in enumerate(a.axes, 1) for j, v in enumerate(b.axes, 1)]
    return [gap_on_axis(a, b, name, n) for name, n in named if dot(n, n) > 1e-12]


def gap_on_axis(a: SolidBox, b: SolidBox, name: str, n: Vec3) -> AxisGap:
    """Return the signed gap on the axis along n, in scene units."""
    length = sqrt(dot(n, n))
    return AxisGap(name, interval_on(a, n).gap(interval_on(b, n)) / length)


def interval_on(box: SolidBox, n: Vec3) -> Interval:
    """Return the range of a box's dot products with n: that of its center, and half its extent to each side."""
    at, half_extent = dot(box.center, n), sum(h * abs(dot(u, n)) for u, h in zip(box.axes, box.half, strict=True))
    return Interval(at - half_extent, at + half_extent)


def seen_from_above(box: SolidBox) -> list[Vec]:
    """Return the outline of a box seen from above: its edges, projected, joined in order of angle."""
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
