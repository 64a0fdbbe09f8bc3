"""Pairs that are hard to decide: for each of seven reasons, pairs of every octave of the relative margin.

The relative margin (`satviz/advice/relative_margin.py`) says how hard a pair is for floats: it is the distance from a
wrong answer, counted in rounding errors.  A generator aims at a margin; rounding the coordinates changes that, so the
margin of each pair is computed again from the pair itself.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ... import batch
from ...advice.margins import signed_relative_margins
from ...advice.pairs import paired
from ...engine.geometry import InvalidShape
from ...engine.shapes import Polygon
from .. import truth
from .generators import (
    Array,
    CircleArrays,
    Rings,
    circles,
    ngons,
    outward_normals,
    quarter_turn,
    turn_rings,
    turned_boxes,
    unit_vectors,
)

Rng = np.random.Generator
RingPairs = tuple[Rings, Rings]
MARGIN_OCTAVES = range(-2, 36)  # k for 2**k <= relative margin < 2**(k + 1); 2**35 is some 4e-6 of the size
ROUNDING_UNIT = 2.0**-53
MAX_OCTAVES = 18  # thinness, smallness and distance go up to 2**18: such shapes fit the 24 bits of float32


class HardKind(NamedTuple):
    """A kind of hard pairs: `shapes(rng, n)` makes both sides, and B is then moved until it is near A's first edge.

    `power`: the range of the random power of two by which the whole scene is made larger or smaller at the end.
    """

    name: str
    shapes: Callable[[Rng, int], RingPairs]
    power: tuple[int, int] = (0, 0)


def hard_pairs(kind: HardKind, rng: Rng, per_octave: int) -> tuple[Rings, Rings, Array]:
    """Return (outlines of A, of B, (n,) relative margins) of hard pairs, about `per_octave` for each octave of margins.

    Half of the pairs overlap.
    """
    octaves = np.repeat(np.array(MARGIN_OCTAVES), per_octave)
    target = np.ldexp(rng.uniform(1, 2, len(octaves)), octaves)
    a, b = kind.shapes(rng, len(target))
    a, b = moved_to_margin(rng, a, b, target * rng.choice([-1.0, 1.0], len(target)))
    if kind.power != (0, 0):
        power = rng.integers(*kind.power, len(a))[:, None, None] * rng.choice([-1, 1], (len(a), 1, 1))
        a, b = np.ldexp(a, power), np.ldexp(b, power)
    return a, b, margins_of(batch.Polygons(a), batch.Polygons(b))


def margins_of(a: batch.Shapes, b: batch.Shapes) -> Array:
    """Return the (n,) relative margins of the pairs a[k], b[k], computed with NumPy: numba would compile for longer."""
    every = np.arange(len(a))
    return np.abs(signed_relative_margins(paired(a, every, b, every), engine="numpy"))


def moved_to_margin(rng: Rng, a: Rings, b: Rings, margin: Array) -> RingPairs:
    """Return the pairs with B moved along the normal of A's first edge until the relative margin is about `margin`.

    margin: (n,) relative margins, negative for pairs that overlap.  Pairs that rounding makes invalid or concave are
    left out.
    """
    p, q = a[:, 0], a[:, 1]
    edge, out = q - p, outward_normals(p, q)
    spot = p + rng.uniform(0.2, 0.8, (len(a), 1)) * edge
    rows = np.arange(len(a))
    tip = b[rows, np.einsum("nvd,nd->nv", b, out).argmin(axis=1)]
    span = np.abs(edge).max(axis=1) / np.sqrt((edge * edge).sum(axis=1))
    gap = margin * ROUNDING_UNIT * span * np.abs(a).max(axis=(1, 2))
    b = b + (spot - tip + gap[:, None] * out)[:, None]
    good = np.array([_is_valid_ring(ring) and _is_valid_ring(other) for ring, other in zip(a, b, strict=True)])
    return a[good], b[good]


def touching_quadrilaterals(rng: Rng, n: int) -> RingPairs:
    """Return pairs of 4-gons with a corner of B exactly on A's first edge.

    A has coordinates of 40 bits, so that the point on its edge, 10 bits finer, is a float64.
    """
    a = np.round(ngons(rng, n, 4, 2.0) * 2.0**38) * 2.0**-38
    out = outward_normals(a[:, 0], a[:, 1])
    side = quarter_turn(out)
    spot = a[:, 0] + rng.integers(200, 824, (n, 1)) * 2.0**-10 * (a[:, 1] - a[:, 0])  # exact
    far, wide, long = rng.uniform(0.5, 1.5, (3, n, 1))
    corners = [spot, spot + far * out - wide * side, spot + (far + long) * out, spot + far * out + wide * side]
    return a, np.stack(corners, axis=1)


def hard_circles(rng: Rng, per_octave: int) -> tuple[CircleArrays, CircleArrays, Array]:
    """Return (circles A, circles B, (n,) relative margins), `per_octave` pairs for each octave of margins.

    Half of the pairs overlap.
    """
    octaves = np.repeat(np.array(MARGIN_OCTAVES), per_octave)
    n = len(octaves)
    a, b = circles(rng, n, 2.0), circles(rng, n, 2.0)
    gap = np.ldexp(rng.uniform(1, 2, n), octaves) * rng.choice([-1.0, 1.0], n) * ROUNDING_UNIT * 3
    b = a[0] + unit_vectors(rng, n) * (a[1] + b[1] + gap)[:, None], b[1]
    return a, b, margins_of(batch.Circles(*a), batch.Circles(*b))


def _is_valid_ring(ring: Rings) -> bool:
    """Return whether a ring is a convex, counter-clockwise polygon without repeated or collinear corners."""
    try:
        shape = Polygon(ring)
    except InvalidShape:
        return False
    return shape.is_convex and len(shape.corners) == len(ring) and truth.twice_signed_area(ring.tolist()) > 0


def _log_uniform(rng: Rng, n: int, octaves: int) -> Array:
    """Return (n, 1, 1) random numbers from 8 to 2**octaves, equally many in each octave."""
    return np.ldexp(rng.uniform(1, 2, (n, 1, 1)), rng.integers(3, octaves, (n, 1, 1)))


def _ordinary(rng: Rng, n: int) -> RingPairs:
    """Return pairs of 4-gons of like sizes near the origin."""
    return ngons(rng, n, 4, 2.0), ngons(rng, n, 4, 2.0)


def _boxes(rng: Rng, n: int) -> RingPairs:
    """Return pairs of turned boxes."""
    return turned_boxes(rng, n, 2.0), turned_boxes(rng, n, 2.0)


def _far_out(rng: Rng, n: int) -> RingPairs:
    """Return ordinary pairs moved up to 2**18 away from the origin."""
    away = _log_uniform(rng, n, MAX_OCTAVES) * unit_vectors(rng, n, 1)
    return ngons(rng, n, 4, 2.0) + away, ngons(rng, n, 4, 2.0) + away


def _needles(rng: Rng, n: int) -> RingPairs:
    """Return pairs of thin rhombi."""
    return _needle(rng, n), _needle(rng, n)


def _needle(rng: Rng, n: int) -> Rings:
    """Return rhombi of length 2 whose half widths go down to 2**-18, turned and moved at random."""
    thin = np.array([(-1.0, 0.0), (0.0, -1.0), (1.0, 0.0), (0.0, 1.0)]) * np.ones((n, 1, 1))
    thin[..., 1:] /= _log_uniform(rng, n, MAX_OCTAVES)
    return turn_rings(thin, unit_vectors(rng, n)) + rng.uniform(-2, 2, (n, 1, 2))


def _parallel(rng: Rng, n: int) -> RingPairs:
    """Return pairs with an edge of B that faces A's first edge at a small angle, from 2**-3 to 2**-40."""
    a = turned_boxes(rng, n, 2.0)
    p, q = a[:, 0], a[:, 1]
    edge, out = (q - p)[:, None], outward_normals(p, q)[:, None]
    tilt = rng.choice([-1.0, 1.0], (n, 1, 1)) / _log_uniform(rng, n, 40)
    along = edge + tilt * out
    return a, np.concatenate([0 * edge, out, along + out, along], axis=1) + p[:, None]


def _many_corners(rng: Rng, n: int) -> RingPairs:
    """Return pairs of 24-gons."""
    return ngons(rng, n, 24, 2.0), ngons(rng, n, 24, 0.0)


def _unequal_sizes(rng: Rng, n: int) -> RingPairs:
    """Return pairs in which B is up to 2**18 times smaller than A."""
    return ngons(rng, n, 4, 2.0), ngons(rng, n, 4, 0.0) / _log_uniform(rng, n, MAX_OCTAVES)


HARD_KINDS = (
    HardKind("ordinary shapes", _ordinary),
    HardKind("boxes", _boxes),
    HardKind("far from the origin", _far_out),
    HardKind("needles", _needles),
    HardKind("nearly parallel edges", _parallel),
    HardKind("24 corners", _many_corners),
    HardKind("sizes that differ", _unequal_sizes),
)
# products of such coordinates leave the range of floats, so the relative margin does not measure these pairs
EXTREME_KIND = HardKind("extreme sizes", _ordinary, (400, 1000))


def octave_of(margin: Array) -> NDArray[np.int_]:
    """Return the octave k of each margin, 2**k <= margin < 2**(k + 1); -10,000 for a margin of 0."""
    return np.floor(np.log2(margin, where=margin > 0, out=np.full(len(margin), -1e4))).astype(int)
