"""A search for the pair that a method answers wrongly though it is far from touching.

A random sample seldom holds the worst pairs.  The search keeps the worst pairs that it has found, changes their
coordinates by a few floats, moves B a little further away, and tries again, together with new pairs.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from ... import batch
from ..methods import Method
from .generators import Array, Rings, outward_normals, turn_rings, turned_boxes, unit_vectors
from .hard_pairs import margins_of

Rng = np.random.Generator
MakePairs = Callable[[Rng, int], tuple[Rings, Rings]]
PARENTS = 200  # pairs that are kept from one generation to the next
METRES_WIDE = 1000.0
HARDEST, EASIEST = -56, 4  # log2 of the gaps of the first generation, in scene units


class WorstPair(NamedTuple):
    """The worst pair that was found: its relative margin (0: none was wrong), its outlines, and how many were tried."""

    margin: float
    a: Rings
    b: Rings
    tried: int


def kilometre_shapes(rng: Rng, n: int) -> tuple[Rings, Rings]:
    """Return n pairs of 4-gons of 1 m to 14 m with coordinates up to 1 km; both lie at one place, not yet apart.

    Half of them lie at the far corner with edges at about 45 degrees: there roundings are largest.
    """
    a, b = (_quadrilaterals(rng, n) * rng.uniform(1.7, 5, (n, 1, 1)) for _ in "AB")
    a[::2] = _diagonal(a[::2])
    at = rng.uniform(20, METRES_WIDE - 20, (n, 1, 2))
    at[::2] = METRES_WIDE - 20
    return a + at, b + at


def _quadrilaterals(rng: Rng, n: int) -> Rings:
    """Return boxes about the origin with half sizes 0.3 to 1, turned at random, one corner moved inwards."""
    found = turned_boxes(rng, n, 0.0)
    found[:, 2] *= rng.uniform(0.6, 1, (n, 1))
    return found


def boxes_within_one(rng: Rng, n: int) -> tuple[Rings, Rings]:
    """Return pairs of turned boxes of sizes from 1 down to a thousandth, with coordinates up to about 1.

    Both boxes of a pair have the same center, not yet apart.  The smaller they are, the nearer to 1 is its distance
    from the origin; half of the centers lie on the diagonal, the others in any direction.  In every second pair the
    edges of A lie at 45 degrees, and the center lies beyond 1: just above a power of two, a rounding is largest
    relative to the number.
    """
    sizes = np.ldexp(rng.uniform(0.5, 1, (n, 1, 1)), rng.integers(-10, 0, (n, 1, 1)))
    a, b = (turned_boxes(rng, n, 0.0) * sizes * 0.5 for _ in "AB")
    a[::2] = _diagonal(a[::2])
    beyond = np.where(np.arange(n) % 2 == 0, 1.0, -2.0)[:, None, None]
    at = (1 + beyond * sizes) * np.where(rng.random((n, 1, 1)) < 0.5, 1.0, unit_vectors(rng, n, 1))
    return a + at, b + at


def _diagonal(rings: Rings) -> Rings:
    """Return outlines about the origin, rotated so that their first edge rises at 45 degrees."""
    edge = rings[:, 1] - rings[:, 0]
    edge /= np.sqrt((edge * edge).sum(axis=1, keepdims=True))
    back = turn_rings(rings, edge * np.array([1.0, -1.0]))
    return turn_rings(back, np.full((len(rings), 2), np.sqrt(0.5)))


def beside(rng: Rng, a: Rings, b: Rings, gap: Array) -> Rings:
    """Return the B's, each moved until its nearest corner is `gap` beyond A's first edge; below 0 it overlaps."""
    p, q = a[:, 0], a[:, 1]
    out = outward_normals(p, q)
    spot = p + rng.uniform(0.1, 0.9, (len(a), 1)) * (q - p)
    tip = b[np.arange(len(a)), np.einsum("nvd,nd->nv", b, out).argmin(axis=1)]
    return np.asarray(b + (spot - tip + gap[:, None] * out)[:, None])


def _facing(rng: Rng, a: Rings) -> Rings:
    """Return a box for each A, with an edge that is parallel to A's first edge but for rounding and lies on it.

    GJK can take the wrong end of such an edge for the furthest corner.
    """
    p, q = a[:, 0], a[:, 1]
    along, out = (q - p)[:, None] * rng.uniform(0.3, 0.9, (len(a), 1, 1)), outward_normals(p, q)[:, None]
    out = out * np.sqrt((along * along).sum(axis=2, keepdims=True))
    return np.concatenate([0 * along, out, along + out, along], axis=1) + p[:, None]


def worst_pair(method: Method, make: MakePairs, rng: Rng, n: int, generations: int, *, metres: bool) -> WorstPair:
    """Return the worst pair that the search finds in so many generations of n pairs.

    The worst is that of the largest gap (with `metres`) or of the largest relative margin.  Answers are compared with
    those of satviz; what is found is to be checked by `truth`.
    """
    a, b = make(rng, 0)
    best, tried = np.empty(0), 0
    for _ in range(generations):
        new_a, new_b = make(rng, n)
        new_b[1::4] = _facing(rng, new_a[1::4])
        gaps = np.ldexp(rng.uniform(1, 2, n), rng.integers(HARDEST, EASIEST, n))
        if len(best):  # near the gaps at which the method is still wrong
            unit = best[0] if metres else best[0] * 2.0**-53
            gaps = np.where(rng.random(n) < 0.2, gaps, unit * rng.uniform(0.5, 2, n))
        new_b = beside(rng, new_a, new_b, gaps * rng.choice([-1.0, 1.0], n))
        if len(best):
            child_a, child_b = _changed(rng, a, b, n)
            new_a, new_b = np.concatenate([new_a, child_a]), np.concatenate([new_b, child_b])
        tried += len(new_a)
        right = batch.relate(batch.Polygons(new_a), batch.Polygons(new_b)) > 0
        with np.errstate(all="ignore"):
            wrong = np.flatnonzero((method.hits(method.prepare(new_a), method.prepare(new_b)) > 0) != right)
        margin = margins_of(batch.Polygons(new_a[wrong]), batch.Polygons(new_b[wrong]))
        reach = np.maximum(np.abs(new_a), np.abs(new_b)).max(axis=(1, 2))[wrong] if metres else 1.0
        best = np.concatenate([best, margin * 2.0**-53 * reach if metres else margin])
        a, b = np.concatenate([a, new_a[wrong]]), np.concatenate([b, new_b[wrong]])
        order = np.argsort(-best)[:PARENTS]
        best, a, b = best[order], a[order], b[order]
    if not len(best):
        return WorstPair(0.0, a, b, tried)
    margin = margins_of(batch.Polygons(a[:1]), batch.Polygons(b[:1]))
    return WorstPair(float(margin[0]), a[:1], b[:1], tried)


def _changed(rng: Rng, a: Rings, b: Rings, n: int) -> tuple[Rings, Rings]:
    """Return n children of the pairs: some coordinates changed by a few floats, and half of the B's moved outwards."""
    parent = (len(a) * rng.random(n) ** 2).astype(int)  # the worst most often
    a, b = a[parent], b[parent]
    out = outward_normals(a[:, 0], a[:, 1])[:, None]
    step = np.spacing(np.abs(b).max(axis=(1, 2), keepdims=True))
    moves = rng.integers(-4, 5, (n, 1, 1)) * step * out * (rng.random((n, 1, 1)) < 0.5)
    nudged = (side + rng.integers(-3, 4, side.shape) * np.spacing(side) * (rng.random(side.shape) < 0.3)
              for side in (a, b + moves))  # fmt: skip
    a, b = nudged
    return a, b
