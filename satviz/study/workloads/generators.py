"""Seeded shapes and pairs to measure on: random pairs, of which 40 to 70 % are hits, and nearly touching pairs.

Coordinates come from sums, products, quotients and square roots, which every machine rounds in the same way.  Sines
and cosines may differ between machines, and where shapes nearly touch one unit in the last place decides.
"""

from collections.abc import Callable
from math import inf

import numpy as np
from numpy.typing import NDArray

from .. import truth

Array = NDArray[np.float64]
Rings = Array  # (N, V, 2), counter-clockwise
CircleArrays = tuple[Array, Array]  # (N, 2) centers, (N,) radii
Side = Rings | CircleArrays
MakePairs = Callable[[np.random.Generator, int], tuple[Side, Side]]


def unit_vectors(rng: np.random.Generator, *shape: int) -> Array:
    """Return (*shape, 2) random unit vectors, uniform over the full turn, from points drawn in a disc."""
    found = rng.uniform(-1, 1, (*shape, 2))
    while True:
        squares = (found * found).sum(axis=-1, keepdims=True)
        bad = ((squares > 1) | (squares < 1e-4))[..., 0]
        if not bad.any():
            return np.asarray(found / np.sqrt(squares))
        found[bad] = rng.uniform(-1, 1, (bad.sum(), 2))


def ngons(rng: np.random.Generator, n: int, v: int, spread: float) -> Rings:
    """Return n polygons with v random corners on a unit circle; centers have coordinates up to `spread`."""
    corners = unit_vectors(rng, n, v)
    order = np.argsort(np.arctan2(corners[..., 1], corners[..., 0]), axis=1)
    return _random_centers(rng, n, spread) + np.take_along_axis(corners, order[..., None], axis=1)


def turned_boxes(rng: np.random.Generator, n: int, spread: float) -> Rings:
    """Return n boxes with half sizes 0.3 to 1, turned at random; centers have coordinates up to `spread`."""
    half = rng.uniform(0.3, 1, (n, 1, 2)) * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    return _random_centers(rng, n, spread) + turn_rings(half, unit_vectors(rng, n))


def turn_rings(rings: Rings, directions: Array) -> Rings:
    """Return each shape turned about the origin; its unit vector in `directions` is where the x axis goes."""
    c, s = directions[:, :1], directions[:, 1:]
    return np.stack([rings[..., 0] * c - rings[..., 1] * s, rings[..., 0] * s + rings[..., 1] * c], axis=2)


def outward_normals(p: Array, q: Array) -> Array:
    """Return the (N, 2) unit normals of edges from p to q, outward for counter-clockwise shapes."""
    edge = q - p
    normal = -quarter_turn(edge)
    return np.asarray(normal / np.sqrt((edge * edge).sum(axis=1, keepdims=True)))


def circles(rng: np.random.Generator, n: int, spread: float) -> CircleArrays:
    """Return n circles with radii 0.3 to 1; centers have coordinates up to `spread`."""
    return _random_centers(rng, n, spread)[:, 0], rng.uniform(0.3, 1, n)


def mixed_polygons(rng: np.random.Generator, n: int, spread: float) -> Rings:
    """Return n polygons with 3 to 8 corners and radii 0.4 to 1.6; the last corner is repeated to make up 8.

    Centers have coordinates up to `spread`.
    """
    rings, corners = np.empty((n, 8, 2)), rng.integers(3, 9, n)
    for v in range(3, 9):
        of_v = np.flatnonzero(corners == v)
        rings[of_v, :v] = ngons(rng, len(of_v), v, 0.0) * rng.uniform(0.4, 1.6, (len(of_v), 1, 1))
        rings[of_v, v:] = rings[of_v, v - 1 : v]
    return rings + _random_centers(rng, n, spread)


def regular_polygons(rng: np.random.Generator, n: int, v: int) -> Rings:
    """Return n regular v-gons about the origin, turned at random; their last digits depend on this machine's sines."""
    turn = rng.uniform(0, 2 * np.pi, (n, 1)) + np.linspace(0, 2 * np.pi, v, endpoint=False)
    return np.stack([np.cos(turn), np.sin(turn)], axis=2)


def apart_pairs(rng: np.random.Generator, n: int, v: int) -> tuple[Rings, Rings]:
    """Return n pairs of regular v-gons whose centers are 2.3 radii apart, so that there is a gap."""
    return regular_polygons(rng, n, v), regular_polygons(rng, n, v) + 2.3 * unit_vectors(rng, n, 1)


def overlapping_pairs(rng: np.random.Generator, n: int, v: int) -> tuple[Rings, Rings]:
    """Return n pairs of regular v-gons whose centers are 0.9 radii apart, so that they overlap deeply."""
    return regular_polygons(rng, n, v), regular_polygons(rng, n, v) + 0.9 * unit_vectors(rng, n, 1)


def touching_pairs(rng: np.random.Generator, n: int, v: int) -> tuple[Rings, Rings]:
    """Return pairs of a regular v-gon and its mirror image; they share its rightmost corner and no other point."""
    a = regular_polygons(rng, n, v)
    b = a[:, ::-1].copy()
    b[:, :, 0] = 2 * a[:, :, 0].max(axis=1)[:, None] - b[:, :, 0]
    return a, b


def tiles(n: int) -> Rings:
    """Return a map of n by n upright boxes of side 0.25, each of which touches its eight neighbours."""
    at = np.stack(np.meshgrid(np.arange(n), np.arange(n)), axis=-1).reshape(-1, 1, 2) * 0.25
    return np.asarray(at + np.array([[0, 0], [0.25, 0], [0.25, 0.25], [0, 0.25]]))


def scattered_polygons(rng: np.random.Generator, n: int) -> Rings:
    """Return n mixed polygons spread evenly, with about 1.5 collisions each; padded to 8 corners."""
    rings = mixed_polygons(rng, n, 0.0)
    return rings + rng.uniform(0, np.sqrt(n) * 1.5, (n, 1, 2))


def nearly_touching_pairs(rng: np.random.Generator, n: int) -> tuple[Rings, Rings]:
    """Return n pairs of triangles: a corner of B lies on an edge of A, but for up to 4 ulps along x and rounding."""
    a = ngons(rng, n, 3, 2.0)
    along = rng.uniform(0.1, 0.9, (n, 1))
    spot = a[:, 0] + along * (a[:, 1] - a[:, 0])
    out = outward_normals(a[:, 0], a[:, 1])
    side = quarter_turn(out)
    far, wide = rng.uniform(0.5, 1.5, (2, n, 1))
    b = np.stack([spot, spot + far * out + wide * side, spot + far * out - wide * side], axis=1)
    b = b[:, ::-1] if truth.twice_signed_area(b[0]) < 0 else b
    steps = rng.integers(-4, 5, n)
    at = np.argmin(np.abs(b - spot[:, None]).sum(axis=2), axis=1)
    for k in range(1, 5):
        for sign in (-1, 1):
            rows = np.flatnonzero(steps * sign >= k)
            b[rows, at[rows], 0] = np.nextafter(b[rows, at[rows], 0], sign * inf)
    return a, b


def quarter_turn(vectors: Array) -> Array:
    """Return (..., 2) vectors turned by 90 degrees counter-clockwise."""
    return np.stack([-vectors[..., 1], vectors[..., 0]], axis=-1)


def is_padded(rings: Rings) -> bool:
    """Return whether some ring ends with a repeated corner, which fills it up to V corners."""
    (x, y), (p, q) = rings[:, -1].T, rings[:, -2].T
    return bool(((x == p) & (y == q)).any())


def unpadded_rings(rings: Rings) -> list[Rings]:
    """Return each ring without the repeats of its last corner."""
    same = (rings[:, 1:] == rings[:, :-1]).all(axis=2)
    repeats = np.logical_and.accumulate(same[:, ::-1], axis=1).sum(axis=1)
    return [ring[: len(ring) - k] for ring, k in zip(rings, repeats.tolist())]


def _random_centers(rng: np.random.Generator, n: int, spread: float) -> Array:
    """Return (n, 1, 2) random points with coordinates from -spread to spread."""
    return rng.uniform(-spread, spread, (n, 1, 2))


WORKLOADS: dict[str, MakePairs] = {
    "triangles": lambda rng, n: (ngons(rng, n, 3, 0.9), ngons(rng, n, 3, 0.9)),
    "boxes": lambda rng, n: (turned_boxes(rng, n, 1.7), turned_boxes(rng, n, 1.7)),
    "8-gons": lambda rng, n: (ngons(rng, n, 8, 1.9), ngons(rng, n, 8, 1.9)),
    "circle and triangle": lambda rng, n: (circles(rng, n, 1.3), ngons(rng, n, 3, 1.3)),
    "mixed, 3 to 8 corners": lambda rng, n: (mixed_polygons(rng, n, 1.0), mixed_polygons(rng, n, 1.0)),
    "nearly touching": nearly_touching_pairs,
}

# generators of pairs of V-gons, and the relation that all of their pairs have
CORNER_WORKLOADS = {"apart": (apart_pairs, 0), "overlapping": (overlapping_pairs, 2), "touching": (touching_pairs, 1)}


def _boxes_at(at: Array, size: Array) -> Array:
    """Return (N, 4) boxes (x0, y0, x1, y1) from (N, 2) lower left corners and (N, 2) sizes."""
    return np.concatenate([at, at + size], axis=1)


def _even_places_and_sizes(rng: np.random.Generator, n: int) -> tuple[Array, Array]:
    """Return ((n, 2) random lower left corners, on average 1.5 units apart; (n, 2) sizes from 0.3 to 1)."""
    return rng.uniform(0, np.sqrt(n) * 1.5, (n, 2)), rng.uniform(0.3, 1, (n, 2))


def _boxes_of_many_sizes(rng: np.random.Generator, n: int) -> Array:
    """Return (n, 4) boxes spread evenly whose sizes differ up to a thousandfold."""
    at, size = _even_places_and_sizes(rng, n)
    return _boxes_at(at * 6, size * 10 ** rng.uniform(-1.5, 1.5, (n, 1)))


def _tiny_boxes_in_a_large_one(rng: np.random.Generator, n: int) -> Array:
    """Return (n, 4) boxes: a large one and tiny ones inside it, which all lie in one cell of a grid."""
    at, size = _even_places_and_sizes(rng, n)
    at, size = at * 1e-6, size * 1e-6
    at[0], size[0] = 0, 1
    return _boxes_at(at, size)


def _boxes_with_one_far_away(rng: np.random.Generator, n: int) -> Array:
    """Return (n, 4) boxes (x0, y0, x1, y1), spread evenly but for one at 1e300, which stretches the scene's bounds."""
    at, size = _even_places_and_sizes(rng, n)
    at[0], size[0] = 1e300, 1e285
    return _boxes_at(at, size)


# generators of (N, 4) boxes; the number of pairs that meet grows like N
BOX_LAYOUTS: dict[str, Callable[[np.random.Generator, int], Array]] = {
    "even": lambda rng, n: _boxes_at(*_even_places_and_sizes(rng, n)),
    "sizes thousandfold": _boxes_of_many_sizes,
    "all in one cell": _tiny_boxes_in_a_large_one,
    "one at 1e300": _boxes_with_one_far_away,
}
