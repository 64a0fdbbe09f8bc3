"""Tests of outlines and circles in batches: valid ones are accepted, invalid ones are refused by number."""

import numpy as np
import pytest

import satviz as sv
from satviz import batch


def test_either_winding_repeats_and_collinear_vertices_are_accepted():
    square = [(0, 0), (2, 0), (2, 2), (0, 2)]
    rings = [square[::-1], [*square, square[0]], [(0, 0), (1, 0), (2, 0), (2, 2), (0, 2)], [(0, 0), *square]]
    shapes = batch.Polygons(rings)
    assert shapes.count.tolist() == [4] * 4
    assert batch.relate(shapes, batch.Circles([(3, 1)], [1])).tolist() == [1] * 4


def test_a_concave_polygon_is_refused_or_split_with_its_owner():
    ell = [(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)]
    box = [(2.5, 2.5), (3.5, 2.5), (3.5, 3.5), (2.5, 3.5)]
    with pytest.raises(sv.InvalidShape, match="polygon 1 is not convex"):
        batch.Polygons([box, ell])
    shapes = batch.Polygons([box, ell, box], concave="split")
    assert len(shapes) == 3 and shapes.owner.tolist() == [0, 1, 1, 2]
    coins = batch.Circles([(3, 3), (3, 3), (9, 9)], [0.1, 0.9, 1])
    assert batch.relate(shapes, coins).tolist() == [2, 0, 0]
    assert batch.colliding_pairs(shapes).tolist() == [[0, 2]]


@pytest.mark.parametrize(
    ("vertices", "words"),
    [
        (np.zeros((2, 3)), "expected \\(N, V, 2\\)"),
        (np.array([[[0, 0], [1, 0], [np.nan, 1]]]), "polygon 0: vertex 2.x is nan: numbers must be finite"),
        (
            np.array([[[0, 0], [1, 0], [2**53 + 1, 1]]]),
            "polygon 0: vertex 2.x is 9007199254740993, which float64",
        ),
        (np.array([[[0, 0], [1, 1j], [1, 1]]]), "complex128"),
        (np.ma.masked_less(np.array([[[0, 0], [1, 0], [0, 1]]]), 1), "masked"),
        ([[(0, 0), (1, 0), (0, 1)], [(0, 0), (2, 2), (2, 0), (0, 2)]], "polygon 1: edges 0 and 2 cross"),
        ([[(0, 0), (1, 1), (2, 2)]], "polygon 0: all vertices lie on one line"),
        ([[(0, 0), (1, 1)]], "polygon 0: 2 distinct vertices: a polygon needs at least 3"),
    ],
)
def test_bad_polygons_are_refused_by_number(vertices, words):
    with pytest.raises(sv.InvalidShape, match=words):
        batch.Polygons(vertices)


def test_bad_circles_are_refused_by_number():
    for centers, radii, words in (
        ([(0, 0), (1, 1)], [1, 0], "circle 1: radius is 0.0: a circle needs a positive radius"),
        ([(0, 0), (1, np.inf)], 1, "circle 1: center.y is inf: numbers must be finite"),
        ([0, 1], 1, "circle 0: center is 0: expected a pair"),
        (np.array([0, 1]), 1, "expected \\(N, 2\\)"),
        ([(0, 0), (1, 1)], [1, 1, 1], "expected \\(2,\\)"),
    ):
        with pytest.raises(sv.InvalidShape, match=words):
            batch.Circles(centers, radii)


def test_a_pentagram_is_not_convex_although_it_turns_left_everywhere():
    turns = 4 * np.pi * np.arange(5) / 5
    with pytest.raises(sv.InvalidShape, match="cross"):
        batch.Polygons([np.stack([np.cos(turns), np.sin(turns)], axis=1)])
