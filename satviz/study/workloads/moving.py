"""Seeded scenes of moving shapes: two frames that follow each other, from which benchmarks find all colliding pairs."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from .generators import Array, Rings, Side, regular_polygons, turn_rings, turned_boxes, unit_vectors

FIELD = 2.0  # the side of the field for each root of the number of shapes: about one collision a shape
STEP, TURN = 0.1, 0.05  # how far a shape moves from frame to frame, in scene units; and turns, as a share of its length
COIN_RADIUS = 0.5
GIANT, FAR = 1000.0, 1e12  # half the size of the one large box, and how far away the far one is, in scene units


class PaddedArrays(NamedTuple):
    """All shapes of a frame in one array: (N, V, 2) corners, (N,) numbers of corners, (N,) radii.

    A polygon with fewer than V corners repeats its last one.  A circle repeats its center, and its number is 1.
    """

    corners: Array
    counts: NDArray[np.int64]
    radii: Array


class Frame(NamedTuple):
    """The shapes at one moment: raw arrays by kind, the same padded, and each shape's center and direction.

    corners: (M, 2) corners of all shapes one after another; a circle has its center.  centers: (N, 2); directions:
    (N, 2) unit vectors, the images of (1, 0) under each shape's rotation.
    """

    sides: Sequence[Side]
    padded: PaddedArrays
    corners: Array
    centers: Array
    directions: Array


class MovingScene(NamedTuple):
    """Shapes about the origin, by kind: (n, V, 2) rings or (n,) radii of circles; and two frames of them."""

    shapes: Sequence[Array]
    frames: tuple[Frame, Frame]


def moving_scene(rng: np.random.Generator, shapes: Sequence[Array]) -> MovingScene:
    """Return the scene of these shapes, by kind as in MovingScene: placed and turned at random, and a step later."""
    n = sum(map(len, shapes))
    centers, directions = rng.uniform(0, FIELD * np.sqrt(n), (n, 2)), unit_vectors(rng, n)
    later = directions + rng.uniform(-TURN, TURN, (n, 2))
    later /= np.sqrt((later * later).sum(axis=1, keepdims=True))
    first = _frame(shapes, centers, directions)
    return MovingScene(shapes, (first, _frame(shapes, centers + rng.uniform(-STEP, STEP, (n, 2)), later)))


def _frame(shapes: Sequence[Array], centers: Array, directions: Array) -> Frame:
    """Return the frame in which these shapes have these centers and directions.

    centers: (N, 2) in scene units; directions: (N, 2) unit vectors, the images of (1, 0) under each shape's rotation.
    """
    ends = np.cumsum([len(some) for some in shapes])[:-1]
    sides: list[Side] = []
    for own, at, turn in zip(shapes, np.split(centers, ends), np.split(directions, ends)):
        sides.append((at, own) if own.ndim == 1 else turn_rings(own, turn) + at[:, None])
    corners = np.concatenate([side[0] if isinstance(side, tuple) else side.reshape(-1, 2) for side in sides])
    return Frame(sides, _padded(sides), corners, centers, directions)


def _padded(sides: Sequence[Side]) -> PaddedArrays:
    """Return the shapes of all kinds as padded arrays."""
    rings = [side[0][:, None] if isinstance(side, tuple) else side for side in sides]
    radii = [side[1] if isinstance(side, tuple) else np.zeros(len(side)) for side in sides]
    most = max(ring.shape[1] for ring in rings)
    corners = [np.pad(ring, ((0, 0), (0, most - ring.shape[1]), (0, 0)), "edge") for ring in rings]
    counts = np.repeat([ring.shape[1] for ring in rings], [len(ring) for ring in rings])
    return PaddedArrays(np.concatenate(corners), counts, np.concatenate(radii))


def _boxes(rng: np.random.Generator, n: int) -> Rings:
    """Return n upright boxes about the origin, with half sizes 0.3 to 1."""
    return np.asarray(rng.uniform(0.3, 1, (n, 1, 2)) * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]))


def _mixed(rng: np.random.Generator, n: int) -> list[Array]:
    """Return a quarter each of triangles, boxes, 8-gons and circles."""
    k = n // 4
    triangles, octagons = (regular_polygons(rng, k, v) * rng.uniform(0.4, 1, (k, 1, 1)) for v in (3, 8))
    return [triangles, _boxes(rng, k), octagons, rng.uniform(0.3, 1, n - 3 * k)]


# kinds of moving scenes: n shapes about the origin
MOVING_SHAPES: dict[str, Callable[[np.random.Generator, int], Sequence[Array]]] = {
    "boxes": lambda rng, n: [_boxes(rng, n)],
    "mixed": _mixed,
    "coins": lambda rng, n: [np.full(n, COIN_RADIUS)],
}


def uneven_boxes(rng: np.random.Generator, n: int) -> dict[str, Rings]:
    """Return by name n turned boxes spread evenly; the same with one as a ground below; and with one far away.

    The ground touches the lowest boxes only, since otherwise its many collisions would take the time.
    """
    plain = turned_boxes(rng, n, FIELD * np.sqrt(n) / 2)
    giant, far = plain.copy(), plain.copy()
    giant[0] = np.array([[-1, -2], [1, -2], [1, 0], [-1, 0]]) * GIANT + np.array([0, plain[..., 1].min()])
    far[0] += FAR
    return {"plain": plain, f"one {GIANT:,.0f} times as large": giant, f"one {FAR:.0e} away".replace("+", ""): far}
