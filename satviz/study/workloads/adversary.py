"""A search for the pair that a method answers wrongly though it is far from touching.

A random sample seldom holds the worst pairs.  The search begins where the error analysis of SAT says that roundings are
largest.  A landing nx * x + ny * y is rounded three times, by up to half a step of its products and of their sum.
Beside the landing a step is largest just above a power of two, and both products and their sum are largest for an edge
at 45 degrees, far out on the diagonal.  There the six roundings of two landings are 8 u * span * reach together.

From then on the search keeps the worst pairs that it has found and changes them: it slides a shape along the edge that
decides, which draws the roundings of its corners anew, and moves corners by a few floats or by metres.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ... import batch
from ..harness.cells import Settings
from ..methods import Method
from .generators import Array, Rings, outward_normals, turn_rings, turned_boxes, unit_vectors
from .hard_pairs import margins_of

Rng = np.random.Generator
MakePairs = Callable[[Rng, int], tuple[Rings, Rings]]
PARENTS = 200  # pairs that are kept from one generation to the next
METRES_WIDE = 1000.0
LEAST_SIDE, MOST_ACROSS = 1.0, 14.0  # metres, of the 4-gons in a scene of 1 km
GENERATIONS = 8  # generations of one search; later ones find little more
HARDEST, EASIEST = -56, 4  # log2 of the gaps of the first generation, in scene units
JUST_ABOVE = 1.01  # a product up to so many powers of two is just above one
LEAST_BEND = 1e-6  # sine of the turn at a corner, below which a 4-gon counts as flat


class WorstPair(NamedTuple):
    """The worst pair that was found: its relative margin (0: none was wrong), its outlines, and how many were tried.

    a, b: (1, V, 2), or (0, V, 2) if none was wrong.
    """

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


def worst_kilometre_shapes(rng: Rng, n: int) -> tuple[Rings, Rings]:
    """Return the pairs of `kilometre_shapes`, half of the A's with an edge that rounds most, at the end of 1 km."""
    a, b = kilometre_shapes(rng, n)
    at = METRES_WIDE - rng.uniform(1, 5, (len(a[::2]), 2))
    product = np.ldexp(np.ones(len(at)), rng.integers(10, 13, len(at)))
    a[::2] = _rounding_most(rng, at, product, rng.uniform(1, 8, len(at)))
    return a, b


def worst_kilometre_shapes_in_float32(rng: Rng, n: int) -> tuple[Rings, Rings]:
    """Return the pairs of `worst_kilometre_shapes`, in a quarter of which A has an edge that hardly bends.

    float32 rounds the corners before the test.  That turns a short edge, and its line is far off at the other end.
    """
    a, b = worst_kilometre_shapes(rng, n)
    a[1::4] = _nearly_straight(rng, len(a[1::4]))
    return a, b


def worst_kilometre_shapes_for_circles(rng: Rng, n: int) -> tuple[Rings, Rings]:
    """Return pairs of `kilometre_shapes`, half of which are long kites side by side, each the other's mirror image.

    Three corners of a kite lie at one end, and so does their mean, the center of its circle: no 4-gon of its size has a
    larger one.
    """
    a, b = kilometre_shapes(rng, n)
    long, wide = (
        rng.uniform(0.95, 0.999, len(a[1::2])) * MOST_ACROSS,
        rng.uniform(1, 1.2, (2, len(a[1::2]))) * LEAST_SIDE,
    )
    zero = np.zeros_like(long)
    ends = np.stack([zero, long, wide[1], zero], axis=1), np.stack([zero, wide[0] / 2, wide[0], wide[0]], axis=1)
    kites = np.stack(ends, axis=2)
    at = rng.uniform(40, METRES_WIDE - 40, (len(kites), 1, 2))
    a[1::2], b[1::2] = kites + at, kites[:, [0, 3, 2, 1]] * [1, -1] + at
    return a, b


def worst_shapes_within_two(rng: Rng, n: int) -> tuple[Rings, Rings]:
    """Return pairs of 4-gons with coordinates up to about 2, of which most have an edge of A that rounds most.

    Of every five A's two are small and far out on the diagonal.  Two have an edge across the origin, from one end of
    the scene to the other: there the normal itself is rounded most.  The last is a turned box anywhere.
    """
    sizes = np.ldexp(rng.uniform(0.5, 1, (n, 1, 1)), rng.integers(-10, 0, (n, 1, 1)))
    a, b = (turned_boxes(rng, n, 0.0) * sizes * 0.5 + unit_vectors(rng, n, 1) for _ in "AB")
    for first in range(2):
        far, across = a[first::5], a[first + 2 :: 5]
        above = rng.choice([1.0, 2**0.5], (2, len(far), 1))
        at, end = above * rng.uniform(1, JUST_ABOVE, (2, len(far), 2))
        size = np.ldexp(np.ones(len(far)), rng.integers(-9, -3, len(far)))
        far[:] = _rounding_most(rng, at, size, size * rng.uniform(0.5, 2, len(far)))
        start = -end * np.where(rng.random((len(far), 1)) < 0.5, 1.0, rng.uniform(0.3, 1, (len(far), 1)))
        boxes = _box_on(start * [-1, 1], end * [-1, 1], rng.uniform(0.1, 0.5, len(far)))
        across[:] = boxes[: len(across)]
    return a, b


def _rounding_most(rng: Rng, at: Array, product: Array, depth: Array) -> Rings:
    """Return boxes whose first edges make both products of a landing, nx * x and ny * y, just above a power of two.

    at: (N, 2) middles of these edges.  product: (N,) the powers of two.  depth: (N,) lengths of the other sides.
    """
    normal = product[:, None] / at * rng.uniform(1, JUST_ABOVE, at.shape)
    edge = np.stack([-normal[:, 1], normal[:, 0]], axis=1)
    return _box_on(at - edge / 2, at + edge / 2, depth)


def _nearly_straight(rng: Rng, n: int) -> Rings:
    """Return 4-gons at the end of 1 km that rise at 45 degrees: a long first edge goes on from the short last one.

    The ends of the short edge lie almost half a step of float32 from its numbers, on opposite sides of the edge.
    """
    along, out = np.sqrt([0.5, 0.5]), np.sqrt([0.5, 0.5]) * [1, -1]
    short, bend = rng.uniform(LEAST_SIDE, 1.1, (n, 1)), 10.0 ** rng.uniform(-5.9, -4.5, (n, 1))
    bent = METRES_WIDE - rng.uniform(10, 13, (n, 2))
    aside = 0.499 * np.spacing(np.float32(METRES_WIDE)) * rng.choice([-1.0, 1.0], (n, 1)) * np.array([1, -1])
    start, bent = ((end.astype(np.float32) + side) for end, side in ((bent - short * along, -aside), (bent, aside)))
    end = bent + rng.uniform(0.8, 1, (n, 1)) * (MOST_ACROSS - short) * ((bent - start) / short - bend * out)
    return np.stack([bent, end, start - rng.uniform(1, 3, (n, 1)) * out, start], axis=1)


def _box_on(p: Array, q: Array, depth: Array) -> Rings:
    """Return counter-clockwise boxes with the first edge from p to q, and (N,) `depth` on its inner side."""
    inward = -outward_normals(p, q) * depth[:, None]
    return np.stack([p, q, q + inward, p + inward], axis=1)


def _quadrilaterals(rng: Rng, n: int) -> Rings:
    """Return boxes about the origin with half sizes 0.3 to 1, turned at random, one corner moved inwards."""
    found = turned_boxes(rng, n, 0.0)
    found[:, 2] *= rng.uniform(0.6, 1, (n, 1))
    return found


def _diagonal(rings: Rings) -> Rings:
    """Return outlines about the origin, rotated so that their first edge rises at 45 degrees."""
    edge = rings[:, 1] - rings[:, 0]
    edge /= np.sqrt((edge * edge).sum(axis=1, keepdims=True))
    back = turn_rings(rings, edge * np.array([1.0, -1.0]))
    return turn_rings(back, np.full((len(rings), 2), np.sqrt(0.5)))


def beside(rng: Rng, a: Rings, b: Rings, gap: Array) -> Rings:
    """Return the B's, each moved until its nearest corner is its `gap` beyond A's first edge; below 0 it overlaps."""
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
    along, out = (q - p)[:, None] * rng.uniform(0.2, 1.5, (len(a), 1, 1)), outward_normals(p, q)[:, None]
    out = out * np.sqrt((along * along).sum(axis=2, keepdims=True))
    return np.concatenate([0 * along, out, along + out, along], axis=1) + p[:, None]


def _at_the_origin(rng: Rng, n: int) -> tuple[Rings, Rings]:
    """Return pairs with an edge of A through the origin, and a corner of B beside it and close to the origin.

    The differences of such coordinates need more digits than two float64 have, with which shapely decides such pairs.
    """
    end = rng.uniform(1, 2, (n, 2)) * rng.uniform(1, 2, (n, 1))
    a = _box_on(-end, end, rng.uniform(1, 4, n))
    b = np.array([(0, 0), (-1.0, -3.0), (1.0, -4.0), (2.0, -2.0)]) * rng.uniform(1, 2, (n, 1, 1))
    x = np.ldexp(rng.uniform(1, 2, n), rng.integers(-60, -44, n))
    y = end[:, 1] / end[:, 0] * x
    b[:, 0] = np.stack([x, y + np.spacing(y) * rng.integers(-2, 3, n)], axis=1)
    return a, b


def search_size(name: str, settings: Settings) -> tuple[int, int]:
    """Return (pairs in a generation, number of generations) of the search for the method of this name.

    shapely gets fewer pairs, because it takes a hundred times as long.
    """
    if settings.quick:
        return 1000, 16
    return 5000 if name.startswith("shapely") else 20_000, 64


def worst_pair(method: Method, make: MakePairs, rng: Rng, n: int, generations: int, *, metres: bool) -> WorstPair:
    """Return the worst pair that the search finds in so many generations of n pairs, of make(rng, n), and n children.

    The worst is that of the largest gap (with `metres`, within `_in_the_scene`) or of the largest relative margin.
    Answers are compared with those of satviz; what is found is to be checked by `truth`.  The search begins anew after
    every `GENERATIONS`, because the children of one pair end at a pair that no small change makes worse.
    """
    starts = max(1, generations // GENERATIONS)
    found = [_search_once(method, make, rng, n, generations // starts, metres=metres) for _ in range(starts)]
    worst, a, b, _ = max(found, key=lambda one: one[0])
    margin = margins_of(batch.Polygons(a), batch.Polygons(b)) if worst else [0.0]
    return WorstPair(float(margin[0]), a, b, sum(tried for *_, tried in found))


def _search_once(
    method: Method, make: MakePairs, rng: Rng, n: int, generations: int, *, metres: bool
) -> tuple[float, Rings, Rings, int]:
    """Return (worst gap or margin, A, B, number of pairs tried) of one search, with A and B empty if none was wrong."""
    a, b = make(rng, 0)
    best, tried = np.empty(0), 0
    for _ in range(generations):
        new_a, new_b = make(rng, n)
        facing = np.arange(n) % 8 < 3  # 3 of 8 pairs, among all kinds of A
        new_b[facing] = _facing(rng, new_a[facing])
        gaps = np.ldexp(rng.uniform(1, 2, n), rng.integers(HARDEST, EASIEST, n))
        if len(best):  # near the gaps at which the method is still wrong
            unit = best[0] if metres else best[0] * 2.0**-53
            gaps = np.where(rng.random(n) < 0.2, gaps, unit * rng.uniform(0.5, 2, n))
        new_b = beside(rng, new_a, new_b, gaps * rng.choice([-1.0, 1.0], n))
        if metres:  # their relative margins would need fractions
            new_a[::8], new_b[::8] = _at_the_origin(rng, len(new_a[::8]))
        new_a, new_b = _swapped(rng, _first_corner_changed(rng, new_a), _first_corner_changed(rng, new_b))
        if len(best):
            child_a, child_b = _children(rng, a, b, n)
            new_a, new_b = np.concatenate([new_a, child_a]), np.concatenate([new_b, child_b])
        valid = _convex(new_a) & _convex(new_b)
        if metres:
            valid &= _in_the_scene(new_a) & _in_the_scene(new_b)
        new_a, new_b = new_a[valid], new_b[valid]
        tried += len(new_a)
        right = batch.relate(batch.Polygons(new_a), batch.Polygons(new_b)) > 0
        with np.errstate(all="ignore"):
            wrong = np.flatnonzero((method.hits(method.prepare(new_a), method.prepare(new_b)) > 0) != right)
        new_a, new_b = new_a[wrong], new_b[wrong]
        gaps = np.abs(_deciding_edge(new_a, new_b)[0]) if metres else margins_of(*map(batch.Polygons, (new_a, new_b)))
        best, a, b = np.concatenate([best, gaps]), np.concatenate([a, new_a]), np.concatenate([b, new_b])
        order = np.argsort(-best, kind="stable")[:PARENTS]
        best, a, b = best[order], a[order], b[order]
    return float(max(best, default=0.0)), a[:1], b[:1], tried


def _first_corner_changed(rng: Rng, rings: Rings) -> Rings:
    """Return the same outlines, each beginning with a random corner: GJK begins with the first corners."""
    corners = rings.shape[1]
    first = rng.integers(0, corners, (len(rings), 1))
    return np.asarray(rings[np.arange(len(rings))[:, None], (first + np.arange(corners)) % corners])


def _swapped(rng: Rng, a: Rings, b: Rings) -> tuple[Rings, Rings]:
    """Return the pairs, of which in about half A and B change places."""
    swap = rng.random((len(a), 1, 1)) < 0.5
    return np.where(swap, b, a), np.where(swap, a, b)


def _children(rng: Rng, a: Rings, b: Rings, n: int) -> tuple[Rings, Rings]:
    """Return n children: copies of some of the pairs, the first ones most often, each changed in one of four ways.

    A or B slides along the edge that decides; some coordinates change by a few floats; or by anything up to metres.
    In half of them B also moves across that edge, by a few floats or by a share of the gap.
    """
    parent = (len(a) * rng.random(n) ** 2).astype(int)  # the worst most often
    a, b = a[parent], b[parent]
    gap, edge, out = (found.reshape(n, 1, -1) for found in _deciding_edge(a, b))
    step = np.spacing(np.maximum(np.abs(a), np.abs(b)).max(axis=(1, 2)))[:, None, None]
    way = rng.integers(0, 4, (n, 1, 1))
    # whole steps, so that the edges and their normals stay what they are
    slide = np.rint(rng.normal(0, 0.2, way.shape) * edge / step + rng.integers(-3, 4, (n, 1, 2))) * step
    few, share = rng.integers(-4, 5, way.shape) * step, gap * rng.normal(0, 0.3, way.shape)
    across = np.where(rng.random(way.shape) < 0.5, few, share) * out * (rng.random(way.shape) < 0.5)
    a, b = a + slide * (way == 0), b + slide * (way == 1) + across
    size = np.where(way == 2, 1.0, 2.0 ** rng.uniform(0, 46, way.shape)) * (way > 1) * step

    def nudged(side: Rings) -> Rings:
        """Return a side with some of its coordinates changed."""
        return np.asarray(side + np.rint(rng.normal(0, 2, side.shape)) * size * (rng.random(side.shape) < 0.3))

    return nudged(a), nudged(b)


def _deciding_edge(a: Rings, b: Rings) -> tuple[Array, Array, Array]:
    """Return for each pair (largest gap on an edge normal, vector of that edge (N, 2), unit normal from A to B).

    The gap is below 0 for an overlap.  It is right to a few roundings of the shapes' own size: differences of corners
    near each other are exact.
    """
    best, edge, across = np.full(len(a), -np.inf), np.zeros((len(a), 2)), np.zeros((len(a), 2))
    for own, other, side in (a, b, 1.0), (b, a, -1.0):
        for e in range(own.shape[1]):
            p, q = own[:, e - 1], own[:, e]
            out = outward_normals(p, q)
            gap = np.einsum("nvd,nd->nv", other - q[:, None], out).min(axis=1)
            more = gap > best
            best = np.where(more, gap, best)
            edge[more], across[more] = (q - p)[more], side * out[more]
    return best, edge, across


def _convex(rings: Rings) -> NDArray[np.bool_]:
    """Return a mask of the outlines that are clearly convex and counter-clockwise."""
    edges = np.roll(rings, -1, axis=1) - rings
    after, lengths = np.roll(edges, -1, axis=1), np.sqrt((edges * edges).sum(axis=2))
    bends = edges[..., 0] * after[..., 1] - edges[..., 1] * after[..., 0]
    return np.asarray((bends > LEAST_BEND * lengths * np.roll(lengths, -1, axis=1)).all(axis=1))


def _in_the_scene(rings: Rings) -> NDArray[np.bool_]:
    """Return a mask of the 4-gons that belong to the scene of 1 km: sides of 1 m or more, at most 14 m across."""
    squares = [((np.roll(rings, -k, axis=1) - rings) ** 2).sum(axis=2) for k in (1, 2)]
    small = np.maximum(*squares).max(axis=1) <= MOST_ACROSS**2
    return np.asarray(
        small & (squares[0].min(axis=1) >= LEAST_SIDE**2) & (np.abs(rings).max(axis=(1, 2)) <= METRES_WIDE)
    )
