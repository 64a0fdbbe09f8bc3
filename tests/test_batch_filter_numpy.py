"""NumPy's float filter for circles and polygons: what it decides is right, and near contacts alone are left."""

from fractions import Fraction
from functools import cache

import numpy as np
import pytest
from batches import RNG
from oracle import edges, relation, segment_distance2
from test_batch_few import hulls
from test_batch_few_numpy import root

import satviz as sv
from satviz.batch.codes import OVERLAPPING, UNDECIDED
from satviz.batch.with_numpy import filter as filter_numpy


def center_near(rng, ring):
    """Return a point at a corner, on an edge or its line, a little off it, inside, or anywhere about the outline."""
    k = rng.integers(len(ring))
    p, q = ring[k - 1], ring[k]
    on = p + (q - p) * rng.choice([-0.5, 0, 0.25, 0.5, 1, 1.5])
    match rng.integers(5):
        case 0:
            return on
        case 1:
            return on + np.array([q[1] - p[1], p[0] - q[0]]) * rng.choice([-1, 1]) * 2.0 ** -rng.integers(1, 40)
        case 2:
            return ring.mean(axis=0)
        case 3:
            return ring[k] + rng.choice([-1, 1], 2) * 2.0 ** -rng.integers(0, 40)
    return rng.integers(-8, 25, 2) * 1.0


@cache
def pairs(v):
    """Return (outlines, centers, radii, their relations, is each farther from contact than the filter must decide?)."""
    rng, made = RNG(v), hulls(RNG(v + 100), [v], 2 * v)
    rings, centers, radii, right, clear = [], [], [], [], []
    for _ in range(50):
        ring = next(made)
        center = np.round(center_near(rng, ring) * 2.0**30) * 2.0**-30
        c, exact = [Fraction(x) for x in center], [[Fraction(x) for x in p] for p in ring]
        square = min(segment_distance2(c, *edge) for edge in edges(exact))
        r = float(root(square)) * (1 + rng.choice([-1, 1]) * 2.0 ** -rng.integers(1, 56)) or 2.0**-20
        if rng.random() < 0.3:
            r = 2.0 ** -rng.integers(20, 40)
        inside = relation(sv.Circle(center, 2.0**-500), sv.Polygon(ring)) is sv.Relation.OVERLAPPING
        far = max(np.abs(ring - center).max(), r)
        gap = -square if inside else square - Fraction(r) ** 2
        rings.append(ring), centers.append(center), radii.append(r)
        right.append(int(relation(sv.Circle(center, r), sv.Polygon(ring))))
        clear.append(abs(gap) > far**2 * 2.0**-44 or (inside and square > far**2 * 2.0**-80))
    return np.array(rings), np.array(centers), np.array(radii), np.array(right), np.array(clear)


@pytest.mark.parametrize("at_once", [1 << 13, 0])
@pytest.mark.parametrize("v", [3, 4, 5, 9])
def test_circles_and_polygons_are_classified_exactly_but_for_near_contacts(v, at_once, monkeypatch):
    monkeypatch.setattr(filter_numpy, "MAX_AT_ONCE", at_once)
    rings, centers, radii, right, clear = pairs(v)
    assert 10 < clear.sum() < len(clear) and len(set(right.tolist())) > 1
    for e in (-540, -480, -420, 0, 420, 500):
        cx, cy, cr = centers[:, 0] * 2.0**e, centers[:, 1] * 2.0**e, radii * 2.0**e
        px, py = (np.ascontiguousarray(c) * 2.0**e for c in (rings[..., 0].T, rings[..., 1].T))
        for first, last in (0, len(right)), (7, len(right)), (3, 20):
            out = np.empty(last - first, np.int8)
            with np.errstate(all="ignore"):
                filter_numpy.circle_polygons(cx, cy, cr, px, py, first, out)
            known, sure = right[first:last], clear[first:last]
            assert ((out == known) | (out == UNDECIDED)).all()
            if abs(e) <= 420:
                assert (out[sure] == known[sure]).all()
                assert (out[known == OVERLAPPING] != UNDECIDED).any() and (out == UNDECIDED).any()


def test_edges_are_evaluated_at_once_or_one_after_another_alike(monkeypatch):
    rings, centers, radii, *_ = pairs(9)
    closed, found = np.concatenate([rings, rings[:, :1]], axis=1).T.copy(), []
    for at_once in 1 << 13, 0:
        monkeypatch.setattr(filter_numpy, "MAX_AT_ONCE", at_once)
        found.append(np.array(filter_numpy.circle_polygon_gaps(*centers.T, radii, closed)))
    assert np.array_equal(*found)
