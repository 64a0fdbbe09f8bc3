"""Make a scene smaller while a function stays wrong about it.

The ideas are Hypothesis's: leave parts out first, then make numbers smaller, and begin again after each success.
"""

from collections.abc import Generator, Iterator
from math import isfinite

from ..engine.geometry import InvalidShape
from ..engine.shapes import Circle, Polygon, Shape

MAX_TRIES = 400  # smaller scenes that are tried for one counterexample

Numbers = tuple[tuple[float, ...], ...]  # a polygon's vertices, or a circle as ((x, y, radius),)
Scene = tuple[Numbers, Numbers]


def numbers_of(shape: Shape) -> Numbers:
    """Return a polygon's vertices as tuples, or a circle as ((x, y, radius),)."""
    if isinstance(shape, Circle):
        return ((*shape.center, shape.radius),)
    return tuple(tuple(point) for point in shape.vertices)


def shape_of(numbers: Numbers) -> Shape:
    """Return the shape of these numbers; InvalidShape if they make none."""
    if len(numbers) == 1:
        x, y, radius = numbers[0]
        return Circle((x, y), radius)
    return Polygon(list(numbers))


def cost(scene: Scene) -> tuple[float, ...]:
    """Return how hard a scene is to read; less is better: corners, fractions, the largest number, their sum, signs."""
    flat = [x for shape in scene for point in shape for x in point]
    return (
        sum(map(len, scene)),
        sum(x != int(x) for x in flat),
        max(map(abs, flat)),
        sum(map(abs, flat)),
        sum(x < 0 for x in flat),
    )


def smaller(scene: Scene) -> Iterator[Scene]:
    """Yield scenes that may be easier to read: the boldest changes first."""
    a = scene[0]
    for which, ring in enumerate(scene):
        if len(ring) > 3:
            for i in range(len(ring)):
                yield _with(scene, which, ring[:i] + ring[i + 1 :])
    left, low = (min(point[axis] for ring in scene for point in ring) for axis in (0, 1))
    for dx, dy in ((left, low), (a[0][0], a[0][1]), (left, 0.0), (0.0, low)):
        if dx or dy:
            yield tuple(tuple((x - dx, y - dy, *r) for x, y, *r in ring) for ring in scene)  # type: ignore[misc]
    for factor in (0.25, 0.5, 0.75):
        yield tuple(tuple(tuple(float(int(x * factor)) for x in p) for p in ring) for ring in scene)  # type: ignore[misc]
    yield tuple(tuple(tuple(float(round(x)) for x in p) for p in ring) for ring in scene)  # type: ignore[misc]
    for which, ring in enumerate(scene):
        for axis in (0, 1):
            for step in (-2.0, -1.0, 1.0):
                moved = tuple(tuple(x + step * (k == axis) for k, x in enumerate(p)) for p in ring)
                yield _with(scene, which, moved)
    for which, ring in enumerate(scene):
        for i, point in enumerate(ring):
            for k, x in enumerate(point):
                for changed in dict.fromkeys((0.0, float(int(x / 2)), x - 1.0, x + 1.0)):
                    if changed != x and isfinite(changed):
                        new = (*point[:k], changed, *point[k + 1 :])
                        yield _with(scene, which, (*ring[:i], new, *ring[i + 1 :]))


def _with(scene: Scene, which: int, ring: Numbers) -> Scene:
    """Return the scene with shape A (`which` 0) or B (1) replaced by `ring`, the numbers of a shape."""
    return (ring, scene[1]) if which == 0 else (scene[0], ring)


def shrink(a: Shape, b: Shape) -> Generator[tuple[Shape, Shape], bool, tuple[Shape, Shape]]:
    """Yield smaller pairs, and return the smallest one about which the function is wrong in the same way.

    The caller sends for each yielded pair whether the function is wrong about it in the same way.
    A pair is yielded only if both shapes are valid; at most MAX_TRIES pairs are.
    """
    best, tried, seen = (numbers_of(a), numbers_of(b)), 0, set()
    while True:
        for candidate in smaller(best):
            if candidate in seen or cost(candidate) >= cost(best):
                continue
            seen.add(candidate)
            try:
                shapes = shape_of(candidate[0]), shape_of(candidate[1])
            except InvalidShape:
                continue
            if tried >= MAX_TRIES:
                return shape_of(best[0]), shape_of(best[1])
            tried += 1
            if (yield shapes):
                best = candidate
                break
        else:
            return shape_of(best[0]), shape_of(best[1])
