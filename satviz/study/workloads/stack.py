"""A stack of boxes under gravity: a small solver of sequential impulses (Catto 2006), started from the last step's.

The floor is a slope of 0.3 radians and gravity pulls straight into it, so that coordinates round as in any turned
scene.  The poses are float64 for every method; a method only says the normal and the depth of each contact.
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import cos, hypot, inf, sin
from typing import NamedTuple

from ...engine.shapes import Polygon

Point = tuple[float, float]
Ring = list[Point]
Contact = tuple[Point, float] | None  # the normal from A to B, of length 1, and the depth
Test = Callable[[Polygon, Polygon], Contact]

SLOPE = 0.3  # radians
ALONG, UP = (cos(SLOPE), sin(SLOPE)), (-sin(SLOPE), cos(SLOPE))
HALF = 0.5, 0.25  # half width and half height of a box, in metres
GRAVITY, STEP, ITERATIONS, FRICTION = 9.81, 1 / 60, 10, 0.6
SLOP, CORRECTION = 0.005, 0.2  # metres of depth that are left alone; share of the rest that a step corrects
FLAT = 0.02  # metres: corners that lie so near to the furthest one belong to the same side


class Body(NamedTuple):
    """A box: half sizes, center, angle, velocity and angular velocity; `inverse` is 1 / mass, 0 for the floor."""

    half: Point
    at: Point
    angle: float = SLOPE
    speed: Point = (0.0, 0.0)
    spin: float = 0.0
    inverse: float = 1.0

    @property
    def inverse_inertia(self) -> float:
        """Return 1 / moment of inertia of a box of this mass."""
        return 3 * self.inverse / (self.half[0] ** 2 + self.half[1] ** 2)

    def outline(self) -> Polygon:
        """Return the corners where the body is."""
        (w, h), c, s = self.half, cos(self.angle), sin(self.angle)
        corners = ((-w, -h), (w, -h), (w, h), (-w, h))
        return Polygon([(self.at[0] + x * c - y * s, self.at[1] + x * s + y * c) for x, y in corners])


@dataclass
class ContactPoint:
    """One point of a contact between bodies i and j, with its impulses: along the normal, and of friction across it.

    at: where it is; contact: (unit normal from i to j, depth in metres).
    """

    i: int
    j: int
    at: Point
    contact: tuple[Point, float]
    impulses: list[float]


class StackState(NamedTuple):
    """The state of a stack: how far the top box has sunk below its place at rest (m), and the kinetic energy (J)."""

    sunk: float
    energy: float


def simulate(test: Test, boxes: int, steps: int, away: float) -> list[StackState]:
    """Simulate a stack of 1 kg boxes that starts at rest; return its state after each of `steps` steps.

    away: x of its foot, in metres; y is half of that.
    """
    origin = away, away / 2
    bodies = [Body((6.0, 0.5), _on_slope(origin, -0.5), inverse=0.0)]
    bodies += [Body(HALF, _on_slope(origin, (2 * k + 1) * HALF[1])) for k in range(boxes)]
    rest, states = (2 * boxes - 1) * HALF[1], []
    kept: dict[tuple[int, int, int], list[float]] = {}
    for _ in range(steps):
        bodies = _stepped(bodies, test, kept)
        top = bodies[-1].at
        height = (top[0] - origin[0]) * UP[0] + (top[1] - origin[1]) * UP[1]
        energy = sum((hypot(*b.speed) ** 2 + b.spin**2 / b.inverse_inertia) / 2 for b in bodies[1:])
        states.append(StackState(rest - height, energy))
    return states


def _on_slope(origin: Point, height: float) -> Point:
    """Return the point above `origin`, a point of the slope, at this height along the slope's normal."""
    return origin[0] + UP[0] * height, origin[1] + UP[1] * height


def _stepped(bodies: list[Body], test: Test, kept: dict[tuple[int, int, int], list[float]]) -> list[Body]:
    """Return the bodies one step later; `kept` holds the last step's impulses and is filled with those of this step.

    Its keys are (i, j, k): contact point k of bodies i and j.
    """
    pull = -GRAVITY * STEP
    speeds = [[b.speed[0] + UP[0] * pull, b.speed[1] + UP[1] * pull, b.spin] if b.inverse else [0.0, 0.0, 0.0]
              for b in bodies]  # fmt: skip
    outlines = [b.outline() for b in bodies]
    points: dict[tuple[int, int, int], ContactPoint] = {}
    for i, a in enumerate(bodies):
        for j in range(i + 1, len(bodies)):
            near = hypot(a.at[0] - bodies[j].at[0], a.at[1] - bodies[j].at[1]) < hypot(*a.half) + hypot(*HALF)
            found = test(outlines[i], outlines[j]) if near else None
            if found:
                for k, at in enumerate(contact_points(outlines[i].corners, outlines[j].corners, found[0])):
                    points[i, j, k] = ContactPoint(i, j, at, found, kept.get((i, j, k), [0.0, 0.0]))
    for point in points.values():
        for k in (0, 1):
            _apply(bodies, speeds, point, k, point.impulses[k])
    for _ in range(ITERATIONS):
        for point in points.values():
            _solve_point(bodies, speeds, point)
    kept.clear()
    kept.update({key: point.impulses for key, point in points.items()})
    return [b._replace(at=(b.at[0] + vx * STEP, b.at[1] + vy * STEP), angle=b.angle + w * STEP, speed=(vx, vy), spin=w)
            for b, (vx, vy, w) in zip(bodies, speeds, strict=True)]  # fmt: skip


def contact_points(a: tuple[Point, ...], b: tuple[Point, ...], normal: Point) -> list[Point]:
    """Return the ends of the segment that the facing sides of A and B share; one point where it has no length.

    a, b: outlines; normal: the unit normal from A to B.
    """
    nx, ny = normal
    sides = []
    for ring, sign in (a, 1), (b, -1):
        heights = [sign * (x * nx + y * ny) for x, y in ring]
        sides.append([(x * -ny + y * nx, h * sign) for (x, y), h in zip(ring, heights) if h > max(heights) - FLAT])
    low = max(min(t for t, _ in side) for side in sides)
    high = min(max(t for t, _ in side) for side in sides)
    level = sum(h for side in sides for _, h in side) / sum(map(len, sides))
    return [(level * nx - t * ny, level * ny + t * nx) for t in ((low, high) if low < high else ((low + high) / 2,))]


def _arms(bodies: list[Body], point: ContactPoint, k: int) -> tuple[Point, float, float]:
    """Return (unit direction of impulse k, 0: normal, 1: across it; lever arm about body i's center; about j's)."""
    (nx, ny), (px, py) = point.contact[0], point.at
    x, y = (nx, ny) if k == 0 else (-ny, nx)
    (ax, ay), (bx, by) = bodies[point.i].at, bodies[point.j].at
    return (x, y), (px - ax) * y - (py - ay) * x, (px - bx) * y - (py - by) * x


def _apply(bodies: list[Body], speeds: list[list[float]], point: ContactPoint, k: int, impulse: float) -> None:
    """Add an impulse at a contact point, along its normal (k = 0) or across it (1), to both bodies' `speeds`, in place.

    speeds: for each body [vx, vy, angular velocity].
    """
    (x, y), *arms = _arms(bodies, point, k)
    for number, arm, size in zip((point.i, point.j), arms, (-impulse, impulse), strict=True):
        body, v = bodies[number], speeds[number]
        v[0] += size * x * body.inverse
        v[1] += size * y * body.inverse
        v[2] += size * arm * body.inverse_inertia


def _solve_point(bodies: list[Body], speeds: list[list[float]], point: ContactPoint) -> None:
    """Update a contact point's impulses and `speeds` in place: along the normal until nothing sinks, then friction."""
    a, b, va, vb = bodies[point.i], bodies[point.j], speeds[point.i], speeds[point.j]
    for k in (0, 1):
        (x, y), arm_a, arm_b = _arms(bodies, point, k)
        along = (vb[0] - va[0]) * x + (vb[1] - va[1]) * y + vb[2] * arm_b - va[2] * arm_a
        inverse_mass = a.inverse + b.inverse + arm_a * arm_a * a.inverse_inertia + arm_b * arm_b * b.inverse_inertia
        wanted = 0.0 if k else CORRECTION / STEP * max(0.0, point.contact[1] - SLOP)
        limit = FRICTION * point.impulses[0] if k else inf
        after = min(max(point.impulses[k] + (wanted - along) / inverse_mass, -limit if k else 0.0), limit)
        change, point.impulses[k] = after - point.impulses[k], after
        _apply(bodies, speeds, point, k, change)
