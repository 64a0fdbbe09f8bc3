"""Seeded pairs of shapes to measure on: random ones of which some 40 to 70 % are hits, and ones that nearly touch.

Coordinates come from sums, products, quotients and square roots alone, which every
machine rounds alike; sines and cosines it may not, and where shapes nearly touch one
unit in the last place decides.
"""

from collections.abc import Callable
from math import inf

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Rings = Array  # (N, V, 2), counter-clockwise
Circles = tuple[Array, Array]  # (N, 2) centers, (N,) radii
Side = Rings | Circles
MakePairs = Callable[[np.random.Generator, int], tuple[Side, Side]]


def unit_vectors(rng: np.random.Generator, *shape: int) -> Array:
    """Unit vectors, evenly over the full turn: points drawn in a square until they fall in its circle."""
    found = rng.uniform(-1, 1, (*shape, 2))
    while True:
        squares = (found * found).sum(axis=-1, keepdims=True)
        bad = ((squares > 1) | (squares < 1e-4))[..., 0]
        if not bad.any():
            return np.asarray(found / np.sqrt(squares))
        found[bad] = rng.uniform(-1, 1, (bad.sum(), 2))


def ngons(rng: np.random.Generator, n: int, v: int, spread: float) -> Rings:
    """Corners at random turns on a unit circle around a random center."""
    corners = unit_vectors(rng, n, v)
    order = np.argsort(np.arctan2(corners[..., 1], corners[..., 0]), axis=1)
    return _random_centers(rng, n, spread) + np.take_along_axis(corners, order[..., None], axis=1)


def turned_boxes(rng: np.random.Generator, n: int, spread: float) -> Rings:
    """Turned boxes of half sizes 0.3 to 1."""
    half = rng.uniform(0.3, 1, (n, 1, 2)) * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    return _random_centers(rng, n, spread) + turn_rings(half, unit_vectors(rng, n))


def turn_rings(rings: Rings, ways: Array) -> Rings:
    """Each shape turned so that the x axis points along its unit vector."""
    c, s = ways[:, :1], ways[:, 1:]
    return np.stack([rings[..., 0] * c - rings[..., 1] * s, rings[..., 0] * s + rings[..., 1] * c], axis=2)


def outward_normals(p: Array, q: Array) -> Array:
    """The unit normals of edges from p to q (N, 2), outwards for counter-clockwise shapes."""
    edge = q - p
    normal: Array = np.stack([edge[:, 1], -edge[:, 0]], axis=1)
    return np.asarray(normal / np.sqrt((edge * edge).sum(axis=1, keepdims=True)))


def circles(rng: np.random.Generator, n: int, spread: float) -> Circles:
    """Circles of radius 0.3 to 1."""
    return _random_centers(rng, n, spread)[:, 0], rng.uniform(0.3, 1, n)


def mixed_polygons(rng: np.random.Generator, n: int, spread: float) -> Rings:
    """Polygons with 3 to 8 corners and sizes of 0.4 to 1.6; the last corner is repeated to make up 8."""
    rings, most = np.empty((n, 8, 2)), rng.integers(3, 9, n)
    for v in range(3, 9):
        mine = np.flatnonzero(most == v)
        rings[mine, :v] = ngons(rng, len(mine), v, 0.0) * rng.uniform(0.4, 1.6, (len(mine), 1, 1))
        rings[mine, v:] = rings[mine, v - 1 : v]
    return rings + _random_centers(rng, n, spread)


def regular_polygons(rng: np.random.Generator, n: int, v: int) -> Rings:
    """Regular polygons about the origin, turned at random: in the last places as this machine's sines are."""
    turn = rng.uniform(0, 2 * np.pi, (n, 1)) + np.linspace(0, 2 * np.pi, v, endpoint=False)
    return np.stack([np.cos(turn), np.sin(turn)], axis=2)


def apart_pairs(rng: np.random.Generator, n: int, v: int) -> tuple[Rings, Rings]:
    """Two regular polygons with some room between them."""
    return regular_polygons(rng, n, v), regular_polygons(rng, n, v) + 2.3 * unit_vectors(rng, n, 1)


def overlapping_pairs(rng: np.random.Generator, n: int, v: int) -> tuple[Rings, Rings]:
    """Two regular polygons, about as deep in each other as they reach."""
    return regular_polygons(rng, n, v), regular_polygons(rng, n, v) + 0.9 * unit_vectors(rng, n, 1)


def touching_pairs(rng: np.random.Generator, n: int, v: int) -> tuple[Rings, Rings]:
    """A regular polygon and its mirror image beyond its rightmost corner, the only point that they share."""
    a = regular_polygons(rng, n, v)
    b = a[:, ::-1].copy()
    b[:, :, 0] = 2 * a[:, :, 0].max(axis=1)[:, None] - b[:, :, 0]
    return a, b


def tiles(n: int) -> Rings:
    """A map of n by n upright boxes, each of which touches its eight neighbours."""
    at = np.stack(np.meshgrid(np.arange(n), np.arange(n)), axis=-1).reshape(-1, 1, 2) * 0.25
    return np.asarray(at + np.array([[0, 0], [0.25, 0], [0.25, 0.25], [0, 0.25]]))


def scattered_polygons(rng: np.random.Generator, n: int) -> Rings:
    """Mixed polygons spread evenly, about 1.5 collisions each; padded to 8 corners."""
    rings = mixed_polygons(rng, n, 0.0)
    return rings + rng.uniform(0, np.sqrt(n) * 1.5, (n, 1, 2))


def nearly_touching_pairs(rng: np.random.Generator, n: int) -> tuple[Rings, Rings]:
    """Triangles where a corner of B lies on an edge of A or within 4 units in the last place of it."""
    a = ngons(rng, n, 3, 2.0)
    along = rng.uniform(0.1, 0.9, (n, 1))
    spot = a[:, 0] + along * (a[:, 1] - a[:, 0])
    out = outward_normals(a[:, 0], a[:, 1])
    side = np.stack([-out[:, 1], out[:, 0]], axis=1)
    far, wide = rng.uniform(0.5, 1.5, (2, n, 1))
    b = np.stack([spot, spot + far * out + wide * side, spot + far * out - wide * side], axis=1)
    b = b[:, ::-1] if _turn(b[0]) < 0 else b
    steps = rng.integers(-4, 5, n)
    at = np.argmin(np.abs(b - spot[:, None]).sum(axis=2), axis=1)
    for k in range(1, 5):
        for way in (-1, 1):
            rows = np.flatnonzero(steps * way >= k)
            b[rows, at[rows], 0] = np.nextafter(b[rows, at[rows], 0], way * inf)
    return a, b


def _turn(ring: Array) -> float:
    (px, py), (qx, qy), (rx, ry) = ring
    return float((qx - px) * (ry - py) - (qy - py) * (rx - px))


def is_padded(rings: Rings) -> bool:
    """Is some ring's last corner repeated?"""
    return bool((rings[:, -1] == rings[:, -2]).all(axis=1).any())


def unpadded_rings(rings: Rings) -> list[Rings]:
    """Each ring without the last corner's repeats."""
    same = (rings[:, 1:] == rings[:, :-1]).all(axis=2)
    repeats = np.logical_and.accumulate(same[:, ::-1], axis=1).sum(axis=1)
    return [ring[: len(ring) - k] for ring, k in zip(rings, repeats.tolist())]


def _random_centers(rng: np.random.Generator, n: int, spread: float) -> Array:
    return rng.uniform(-spread, spread, (n, 1, 2))


WORKLOADS: dict[str, MakePairs] = {
    "triangles": lambda rng, n: (ngons(rng, n, 3, 0.9), ngons(rng, n, 3, 0.9)),
    "boxes": lambda rng, n: (turned_boxes(rng, n, 1.7), turned_boxes(rng, n, 1.7)),
    "8-gons": lambda rng, n: (ngons(rng, n, 8, 1.9), ngons(rng, n, 8, 1.9)),
    "circle and triangle": lambda rng, n: (circles(rng, n, 1.3), ngons(rng, n, 3, 1.3)),
    "mixed, 3 to 8 corners": lambda rng, n: (mixed_polygons(rng, n, 1.0), mixed_polygons(rng, n, 1.0)),
    "nearly touching": nearly_touching_pairs,
}

# pairs of V-gons by how they lie, and the relation of all of them
CORNER_WORKLOADS = {"apart": (apart_pairs, 0), "overlapping": (overlapping_pairs, 2), "touching": (touching_pairs, 1)}


def _corners_of_boxes(at: Array, size: Array) -> Array:
    return np.concatenate([at, at + size], axis=1)


def _even_places_and_sizes(rng: np.random.Generator, n: int) -> tuple[Array, Array]:
    return rng.uniform(0, np.sqrt(n) * 1.5, (n, 2)), rng.uniform(0.3, 1, (n, 2))


def _even_boxes(rng: np.random.Generator, n: int) -> Array:
    return _corners_of_boxes(*_even_places_and_sizes(rng, n))


def _boxes_of_many_sizes(rng: np.random.Generator, n: int) -> Array:
    at, size = _even_places_and_sizes(rng, n)
    return _corners_of_boxes(at * 6, size * 10 ** rng.uniform(-1.5, 1.5, (n, 1)))


def _tiny_boxes_beside_a_large_one(rng: np.random.Generator, n: int) -> Array:
    at, size = _even_places_and_sizes(rng, n)
    at, size = at * 1e-6, size * 1e-6
    at[0], size[0] = 0, 1  # one box as large as everything, beside tiny ones
    return _corners_of_boxes(at, size)


def _boxes_with_one_far_away(rng: np.random.Generator, n: int) -> Array:
    at, size = _even_places_and_sizes(rng, n)
    at[0], size[0] = 1e300, 1e285
    return _corners_of_boxes(at, size)


# (N, 4) boxes whose pairs grow like N
BOX_LAYOUTS: dict[str, Callable[[np.random.Generator, int], Array]] = {
    "even": _even_boxes,
    "sizes thousandfold": _boxes_of_many_sizes,
    "all in one cell": _tiny_boxes_beside_a_large_one,
    "one at 1e300": _boxes_with_one_far_away,
}
