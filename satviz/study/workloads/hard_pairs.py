"""Pairs as hard as asked: an octave of gamma each, and seven reasons to be hard.

gamma (satviz/advice/gamma.py) measures how finely a pair must be resolved; what a maker aims at is rounded
with its coordinates, so gamma is always taken of the pairs themselves, exactly.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ... import batch
from ...advice.margins import gammas
from ...engine.geometry import InvalidShape
from ...engine.shapes import Polygon
from .. import truth
from .generators import Array, Rings, ngons, outward_normals, turned_boxes, unit_vectors

Rng = np.random.Generator
Pairs = tuple[Rings, Rings]
MARGIN_OCTAVES = range(-2, 36)  # of gamma: from within a rounding to a millionth of the size
ROUNDING_UNIT = 2.0**-53
MAX_OCTAVES = 18  # powers of two: float32's 24 bits can still hold shapes so thin, so small, or so far out


class HardKind(NamedTuple):
    """A reason to be hard: `shapes(rng, n)` makes both sides; A's first edge is where they will nearly meet.

    `power`: by how many powers of two, at random, the whole scene is larger or smaller then.
    """

    name: str
    shapes: Callable[[Rng, int], Pairs]
    power: tuple[int, int] = (0, 0)


def hard_pairs(kind: HardKind, rng: Rng, each: int) -> tuple[Rings, Rings, Array]:
    """About `each` pairs an octave, half of them overlapping, and the gamma of each pair."""
    target = np.ldexp(rng.uniform(1, 2, len(MARGIN_OCTAVES) * each), np.repeat(np.array(MARGIN_OCTAVES), each))
    a, b = kind.shapes(rng, len(target))
    a, b = moved_to_margin(rng, a, b, target * rng.choice([-1.0, 1.0], len(target)))
    if kind.power != (0, 0):
        power = rng.integers(*kind.power, len(a))[:, None, None] * rng.choice([-1, 1], (len(a), 1, 1))
        a, b = np.ldexp(a, power), np.ldexp(b, power)
    return a, b, gammas(batch.Polygons(a), batch.Polygons(b))


def moved_to_margin(rng: Rng, a: Rings, b: Rings, gamma: Array) -> Pairs:
    """B moved until its nearest corner lies off A's first edge by about that gamma; only pairs that rounding leaves
    convex.
    """
    p, q = a[:, 0], a[:, 1]
    edge, out = q - p, outward_normals(p, q)
    spot = p + rng.uniform(0.2, 0.8, (len(a), 1)) * edge
    rows = np.arange(len(a))
    tip = b[rows, np.einsum("nvd,nd->nv", b, out).argmin(axis=1)]
    span = np.abs(edge).max(axis=1) / np.sqrt((edge * edge).sum(axis=1))
    gap = gamma * ROUNDING_UNIT * span * np.abs(a).max(axis=(1, 2))
    b = b + (spot - tip + gap[:, None] * out)[:, None]
    good = np.array([_is_valid_ring(ring) and _is_valid_ring(other) for ring, other in zip(a, b, strict=True)])
    return a[good], b[good]


def touching_triangles(rng: Rng, n: int) -> Pairs:
    """Triangles with a corner of B exactly on A's first edge; coordinates of 40 bits leave room for the point on it."""
    a = np.round(ngons(rng, n, 3, 2.0) * 2.0**38) * 2.0**-38
    out = outward_normals(a[:, 0], a[:, 1])
    side = np.stack([-out[:, 1], out[:, 0]], axis=1)
    spot = a[:, 0] + rng.integers(200, 824, (n, 1)) * 2.0**-10 * (a[:, 1] - a[:, 0])  # exact
    far, wide = rng.uniform(0.5, 1.5, (2, n, 1))
    return a, np.stack([spot, spot + far * out - wide * side, spot + far * out + wide * side], axis=1)


def pairs_on_a_grid(rng: Rng, n: int, gamma: float) -> Pairs:
    """4-gons about that hard, with coordinates below 8 that are multiples of 2**-46: exact moves by up to 64."""
    p, q = (ngons(rng, n, 4, 2.0) for _ in "AB")
    a, b = moved_to_margin(rng, np.round(p * 2.0**46) * 2.0**-46, q, np.full(n, gamma) * rng.uniform(-1, 1, n))
    b = np.round(b * 2.0**46) * 2.0**-46
    good = np.array([_is_valid_ring(ring) for ring in b])
    return a[good], b[good]


def _is_valid_ring(ring: Rings) -> bool:
    try:
        shape = Polygon(ring)
    except InvalidShape:
        return False
    return shape.is_convex and len(shape.corners) == len(ring) and truth.area2(ring.tolist()) > 0


def _log_uniform(rng: Rng, n: int, most: int) -> Array:
    """(n, 1, 1) numbers from 8 to 2**most, octave by octave; no powers nor sines, which machines round apart."""
    return np.ldexp(rng.uniform(1, 2, (n, 1, 1)), rng.integers(3, most, (n, 1, 1)))


def _ordinary(rng: Rng, n: int) -> Pairs:
    return ngons(rng, n, 4, 2.0), ngons(rng, n, 4, 2.0)


def _boxes(rng: Rng, n: int) -> Pairs:
    return turned_boxes(rng, n, 2.0), turned_boxes(rng, n, 2.0)


def _far_out(rng: Rng, n: int) -> Pairs:
    away = _log_uniform(rng, n, MAX_OCTAVES) * unit_vectors(rng, n, 1)
    return ngons(rng, n, 4, 2.0) + away, ngons(rng, n, 4, 2.0) + away


def _needles(rng: Rng, n: int) -> Pairs:
    return _needle(rng, n), _needle(rng, n)


def _needle(rng: Rng, n: int) -> Rings:
    width, zero, one = 1 / _log_uniform(rng, n, MAX_OCTAVES)[:, 0, 0], np.zeros(n), np.ones(n)
    thin = np.stack([np.stack([-one, one, one], axis=1), np.stack([zero, -width, width], axis=1)], axis=2)
    c, s = np.moveaxis(unit_vectors(rng, n, 1), 2, 0)
    turned = np.stack([thin[..., 0] * c - thin[..., 1] * s, thin[..., 0] * s + thin[..., 1] * c], axis=2)
    return turned + rng.uniform(-2, 2, (n, 1, 2))


def _parallel(rng: Rng, n: int) -> Pairs:
    """B's lowest edge faces A's first at an angle of 2**-2 to 2**-40."""
    a = turned_boxes(rng, n, 2.0)
    p, q = a[:, 0], a[:, 1]
    edge, out = (q - p)[:, None], outward_normals(p, q)[:, None]
    tilt = rng.choice([-1.0, 1.0], (n, 1, 1)) / _log_uniform(rng, n, 40)
    along = edge + tilt * out
    return a, np.concatenate([0 * edge, out, along + out, along], axis=1) + p[:, None]


def _many(rng: Rng, n: int) -> Pairs:
    return ngons(rng, n, 24, 2.0), ngons(rng, n, 24, 0.0)


def _sizes(rng: Rng, n: int) -> Pairs:
    return ngons(rng, n, 4, 2.0), ngons(rng, n, 4, 0.0) / _log_uniform(rng, n, MAX_OCTAVES)


HARD_KINDS = (
    HardKind("ordinary shapes", _ordinary),
    HardKind("boxes", _boxes),
    HardKind("far from the origin", _far_out),
    HardKind("needles", _needles),
    HardKind("nearly parallel edges", _parallel),
    HardKind("24 corners", _many),
    HardKind("sizes that differ", _sizes),
)
EXTREME_KIND = HardKind(
    "extreme sizes", _ordinary, (400, 1000)
)  # gamma does not measure it: products leave floats' range


def octave_of(gamma: Array) -> NDArray[np.int_]:
    """k for 2**k <= gamma < 2**(k + 1)."""
    return np.floor(np.log2(gamma, where=gamma > 0, out=np.full(len(gamma), -1e4))).astype(int)
