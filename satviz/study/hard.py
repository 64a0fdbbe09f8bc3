"""Ways of being hard: pairs of triangles that grow harder with one number, level by level."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from .workloads import Rings, directions, ngons, outward, turned

Pairs = tuple[Rings, Rings]


class Way(NamedTuple):
    """One way of being hard: what its number is called, the powers of two it takes, and what makes the pairs."""

    name: str
    axis: str
    levels: tuple[int, ...]
    make: Callable[[np.random.Generator, int, int], Pairs]


def at_an_edge(rng: np.random.Generator, n: int, v: int = 3, gap: float = 0.0) -> tuple[Rings, Rings, NDArray]:
    """v-gons with a triangle whose nearest corner lies about `gap` beyond an edge's middle; and the ways outwards."""
    a = ngons(rng, n, v, 2.0)
    p, q = a[:, 0], a[:, 1]
    out = outward(p, q)
    side = np.stack([-out[:, 1], out[:, 0]], axis=1)
    spot = p + rng.uniform(0.2, 0.8, (n, 1)) * (q - p) + gap * out
    far, wide = rng.uniform(0.5, 1.5, (2, n, 1))
    return a, np.stack([spot, spot + far * out - wide * side, spot + far * out + wide * side], axis=1), out


def _ulps(rng: np.random.Generator, n: int, level: int) -> Pairs:
    """The gap is about 2**level units in the last place of the coordinates, either way."""
    a, b, out = at_an_edge(rng, n)
    steps = rng.choice([-1.0, 1.0], (n, 1, 1)) * 2.0**level * np.spacing(2.0)
    return a, b + steps * out[:, None]


def _nudged(pairs: tuple[Rings, Rings, NDArray], rng: np.random.Generator, size: float) -> Pairs:
    """B moved by up to `size` along its way out or in, so that the sign of the gap is in doubt."""
    a, b, out = pairs
    return a, b + rng.uniform(-size, size, (len(a), 1, 1)) * out[:, None]


def _offset(rng: np.random.Generator, n: int, level: int) -> Pairs:
    """Pairs a millionth of their size apart or overlapping, 2**level away from the origin."""
    a, b = _nudged(at_an_edge(rng, n), rng, 1e-6)
    away = 2.0**level * rng.choice([-1.0, 1.0], (n, 1, 2)) * rng.uniform(0.5, 1, (n, 1, 2))
    return _proper(a + away, b + away)


def _proper(a: Rings, b: Rings) -> Pairs:
    """Only the pairs where rounding has left both triangles an inside."""
    good = (_area(a) > 0) & (_area(b) > 0)
    return a[good], b[good]


def _area(rings: Rings) -> NDArray:
    """Twice the areas of triangles; the differences are exact where the corners lie far out and close together."""
    p, q = rings[:, 1] - rings[:, 0], rings[:, 2] - rings[:, 0]
    return p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]


def _scale(rng: np.random.Generator, n: int, level: int) -> Pairs:
    """Ordinary pairs, all coordinates times 2**level (exactly)."""
    a, b = _nudged(at_an_edge(rng, n), rng, 0.1)
    return np.ldexp(a, level), np.ldexp(b, level)


def _needles(rng: np.random.Generator, n: int, level: int) -> Pairs:
    """Two needles 2**level times as long as wide, side by side, a 4096th of a width apart or crossed by as much."""
    width = 2.0**-level
    a = np.stack([_points(-1, 0, n), _points(1, 0, n), _points(0, width, n)], axis=1)
    at = rng.uniform(-0.5, 0.5, (n, 1))
    low = np.concatenate([at, width * (1 - np.abs(at)) + width * rng.uniform(-1, 1, (n, 1)) * 2.0**-12], axis=1)
    b = np.stack([low, low + _points(0.8, 2 * width, n), low + _points(-0.8, 2 * width, n)], axis=1)
    ways = directions(rng, n)
    return _proper(turned(a, ways), turned(b, ways))


def _parallel(rng: np.random.Generator, n: int, level: int) -> Pairs:
    """Facing edges that are parallel but for an angle of 2**level, and as near each other."""
    tilt = 2.0**level
    a = np.stack([_points(-1, 0, n), _points(0, -1, n), _points(1, 0, n)], axis=1)
    left, right = (rng.uniform(-1, 1, n) * tilt for _ in range(2))
    b = np.stack(
        [
            np.stack([-rng.uniform(0.5, 1.5, n), left], 1),
            np.stack([rng.uniform(0.5, 1.5, n), right], 1),
            _points(0, 1, n),
        ],
        axis=1,
    )
    ways = directions(rng, n)
    return _proper(turned(a, ways), turned(b, ways))


def _vertices(rng: np.random.Generator, n: int, level: int) -> Pairs:
    """A polygon with 2**level corners (3 for 1) and a corner within 4 units in the last place of an edge."""
    return _nudged(at_an_edge(rng, n, max(3, 2**level)), rng, 4 * float(np.spacing(2.0)))


def _mixed_scales(rng: np.random.Generator, n: int, level: int) -> Pairs:
    """B is 2**level times smaller than A, and about half its size off A's edge or into it."""
    a, b, out = at_an_edge(rng, n)
    small = 2.0**-level
    tip = b[:, :1]
    shrunk = tip + (b - tip) * small + rng.uniform(-0.5, 0.5, (n, 1, 1)) * small * out[:, None]
    return _proper(a, shrunk)


def _points(x: float, y: float, n: int) -> NDArray:
    return np.tile(np.array([x, y], float), (n, 1))


WAYS = (
    Way("gap", "gap in units in the last place", (-4, -1, 0, 1, 2, 3, 4, 8, 12, 16, 20, 24, 28, 32), _ulps),
    Way("offset", "distance from the origin", (0, 8, 16, 20, 24, 28, 32, 36, 40, 44, 48, 50, 52), _offset),
    Way("scale", "size", (-1000, -700, -520, -500, -300, -140, 0, 140, 300, 500, 520, 700, 1000), _scale),
    Way("needles", "length of a needle in widths", (0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40, 44, 48), _needles),
    Way(
        "parallel",
        "angle between facing edges",
        (0, -4, -8, -12, -16, -20, -24, -28, -32, -36, -40, -44, -48, -50, -52),
        _parallel,
    ),
    Way("vertices", "corners, one within 4 ulps of an edge", (1, 2, 3, 4, 5, 6, 7), _vertices),
    Way(
        "mixed scales",
        "size of A in sizes of B",
        (0, 4, 8, 12, 16, 20, 24, 28, 32, 36, 40, 44, 48),
        _mixed_scales,
    ),
)
