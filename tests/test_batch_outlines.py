"""Tests of outlines and circles in batches: valid ones are accepted, invalid ones are refused by number."""

from fractions import Fraction

import numpy as np
import pytest
from batches import RNG
from oracle import cross
from test_batch_few import hulls, star

import satviz as sv
from satviz import batch
from satviz.batch.with_numpy import outlines


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


# -- what NumPy certifies in one pass, and nothing else; the rest is left to exact signs

UPRIGHT_EDGES = {
    4: [(0, 0), (2, 0), (2, 2), (0, 2)],
    5: [(0, 0), (2, 0), (2, 1), (1, 2), (0, 2)],
    6: [(0, 1), (1, 0), (3, 0), (3, 3), (1, 3), (0, 2)],
    8: [(1, 0), (2, 0), (3, 1), (3, 2), (2, 3), (1, 3), (0, 2), (0, 1)],
    12: [(3, 0), (5, 0), (7, 1), (8, 3), (8, 5), (7, 7), (5, 8), (3, 8), (1, 7), (0, 5), (0, 3), (1, 1)],
}


def plain_outlines(v, n):
    """Return (n, v, 2) outlines in whole numbers, some with upright edges, from each of their corners on."""
    rng, found = RNG([v, n]), hulls(RNG([n, v]), [v], 3 * v)
    rings = [np.array(UPRIGHT_EDGES[v]) if v in UPRIGHT_EDGES and k % 3 == 0 else next(found) for k in range(n)]
    return np.array([np.roll(ring, k, axis=0) for k, ring in enumerate(rings)]) + rng.integers(-9, 9, (n, 1, 2)) * 1.0


def mixed(rings):
    """Return the outlines, every third one the other way round."""
    turned = rings.copy()
    turned[::3] = rings[::3, ::-1]
    return turned


@pytest.fixture(params=[None, 15])
def blocks(request, monkeypatch):
    """Look at all outlines at once, in the form for few of them if they are few; or at 15 corners at a time."""
    if request.param is not None:
        monkeypatch.setattr(outlines, "BLOCK_CORNERS", request.param)
        monkeypatch.setattr(outlines, "MAX_FEW", 1)
    return request.param


@pytest.mark.parametrize("v", [3, 4, 5, 6, 8, 12])
def test_plain_outlines_of_either_winding_are_certified_at_once(v, blocks):
    for n in 1, 2, 9, 64, 65:
        rings = plain_outlines(v, n)
        for e in -400, 0, 400:
            for given, one_way in (rings, True), (rings[:, ::-1], True), (mixed(rings), n == 1):
                made = outlines.certified_group(np.ascontiguousarray(given) * 2.0**e)
                assert np.array_equal(np.stack([made.x.T, made.y.T], axis=2), rings * 2.0**e)
                assert made.block.flags.c_contiguous
                if made.as_complex is not None:
                    closed, edges, radius = made.as_complex
                    assert np.array_equal(closed[1:] - closed[:-1], edges) and closed.shape == (v + 1, n)
                    assert np.array_equal(closed[0], closed[-1]) and radius is None
                assert (made.as_complex is not None) == (blocks is None and 1 < n <= 64 and one_way)


def test_outlines_are_checked_in_blocks_of_many_corners(monkeypatch):
    """Each block takes some dozens of calls, and its arrays stay in the cache."""
    sizes, real = [], outlines._turns_one_way
    monkeypatch.setattr(outlines, "_turns_one_way", lambda xy: sizes.append(xy[0].size) or real(xy))
    outlines.certified_group(np.tile(plain_outlines(5, 1), (20_000, 1, 1)))
    assert sum(sizes) == 100_000 and all(2**13 < size <= 2**17 for size in sizes[:-1])
    monkeypatch.setattr(outlines, "BLOCK_CORNERS", 4)  # one outline at least
    assert outlines.certified_group(mixed(plain_outlines(5, 3))) is not None and sizes[-3:] == [5, 5, 5]


@pytest.mark.parametrize("v", [3, 4, 5, 8, 12])
def test_one_outline_at_fault_is_left_to_exact_checks_wherever_it_is(v, blocks):
    faults = [np.roll(star(v, step, 50), k, axis=0) for k in range(v) for step in range(2, v // 2 + 1)]
    ring = plain_outlines(v, 2)[1]
    faults += [np.concatenate([ring[:1], ring[:-1]]), np.concatenate([ring[:-1], ring[:1]])]  # a corner twice
    for k in range(v):
        middle = (ring[k - 1] + ring[(k + 1) % v]) / 2
        inside = middle + (middle - ring[k]) * 2.0**-6
        faults += [np.where(np.arange(v)[:, None] == k, at, ring) for at in (middle, inside)[: 1 + (v > 3)]]
        faults += [np.where(np.arange(2 * v).reshape(v, 2) == 2 * k + axis, np.nan, ring) for axis in (0, 1)]
    for n in 1, 3, 20:
        rings = plain_outlines(v, n)
        for i, fault in enumerate(faults):
            given = rings.copy()
            given[i % n] = fault
            for way in given, given[:, ::-1].copy(), mixed(given):
                assert outlines.certified_group(way) is None, fault


def nearly_straight(rng, v, far):
    """Return an outline with a corner between its neighbours, as near to a straight line as rounding allows."""
    ring = next(hulls(rng, [v], 8)) * rng.uniform(0.1, 1) + rng.uniform(-far, far, 2)
    k = rng.integers(v)
    at = rng.uniform(0.3, 0.7)
    ring[k] = ring[k - 1] * at + ring[(k + 1) % v] * (1 - at)
    return ring


def is_convex(ring):
    """Return whether an outline turns left at each corner, in fractions."""
    points = [(Fraction(x), Fraction(y)) for x, y in ring]
    return all(cross(points[k - 2], points[k - 1], points[k]) > 0 for k in range(len(ring)))


@pytest.mark.parametrize("scale", [-540, -513, -512, -511, -500, -450, 0, 450, 507, 510, 530, 1010])
@pytest.mark.parametrize("v", [4, 5])
def test_no_outline_is_certified_that_is_not_convex_within_the_last_bits(v, scale):
    rng = RNG([v, scale + 600])
    rings = np.array([nearly_straight(rng, v, far) for far in (0.0, 2.0**3, 2.0**9) for _ in range(20)]) * 2.0**scale
    convex = [is_convex(ring) for ring in rings]
    assert 5 < sum(convex) < 55
    for way in rings, rings[:, ::-1].copy():
        for ring, right in zip(way, convex):
            for given in ring[None], np.tile(ring, (3, 1, 1)):
                assert right or outlines.certified_group(given) is None
    plain = plain_outlines(v, 3) * 2.0**scale
    assert abs(scale) > 450 or outlines.certified_group(plain) is not None
    assert abs(scale) < 530 or outlines.certified_group(plain) is None


def test_a_corner_with_the_largest_error_found_is_not_taken_for_convex():
    """Its turn is computed as 2.06 units of 2**-53, and is less than 0 (found by a search)."""
    corner = [(0.9945261093165646, 0.5357482547195055), (1.9998980334101153, 1.6037256412793843)]
    ring = np.array([*corner, (4.555335697452068, 4.318292830353044), (0, 9)])
    assert not is_convex(ring)
    for n in 1, 2:
        for way in 1, -1:
            assert outlines.certified_group(np.tile(ring[::way], (n, 1, 1))) is None


def circle_arrays(n):
    rng = RNG(n)
    return rng.uniform(-9, 9, (n, 2)), rng.uniform(0.1, 2, n)


REFLEX = [  # corners p, q, r that turn right by less than a product in float64 can say: rounded, they turn left
    ("-0x1.c20ed1f01760dp-538 -0x1.37b49a07317c8p-537 0x1.d6p-583 0x1.2ap-583"
     " 0x1.3b5fe7f9b13c6p-537 0x1.b4d9b83b6f164p-537"),
    ("-0x1.28b4da2c58efap-537 -0x1.0430ead51816cp-538 -0x1.72p-584 0x1.4cp-583"
     " 0x1.f7c0bad8196f6p-538 0x1.b9c1a8f3b08e1p-539"),
    ("-0x1.b591115ba9d08p-538 -0x1.249ce2a06352ap-537 -0x1.3cp-583 -0x1.aep-584"
     " 0x1.bfefc590ea93ep-539 0x1.2b8c289927dacp-538"),
]  # fmt: skip


@pytest.mark.parametrize("rest", [[(-(2.0**-526), 2.0**-526)], [(-1, 3), (-3, 1)]], ids=len)
@pytest.mark.parametrize("corners", REFLEX)
def test_a_corner_whose_products_lose_their_bits_is_not_taken_for_convex(corners, rest):
    numbers = [float.fromhex(word) for word in corners.split()]
    ring = [*zip(numbers[::2], numbers[1::2], strict=True), *rest]
    assert not sv.Polygon(ring).is_convex
    with pytest.raises(sv.InvalidShape, match="polygon 0 is not convex"):
        batch.Polygons([ring])
    for way in (ring, ring[::-1]):
        assert outlines.certified_group(np.array([way])) is None


@pytest.mark.parametrize("n", [1, 2, 64, 65])
def test_plain_circles_are_certified_at_once_and_others_left_to_slower_checks(n):
    for scale in 5e-324, 2.0**-600, 1.0, 1e307:
        centers, radii = circle_arrays(n)
        centers[0], radii[:] = (-0.0, 0.0), np.maximum(radii * scale, 5e-324)
        made = outlines.certified_circles(centers, radii)
        assert (made.as_complex is not None) == (n <= 64) and len(made) == n and made.corners == 1
        assert np.array_equal(np.stack([made.x[0], made.y[0]], axis=1), centers) and np.array_equal(made.r, radii)
        assert not np.signbit(made.block[:, 0, 0]).any() and made.block.flags.c_contiguous
        assert made.as_complex is None or made.as_complex.edges.shape == (0, n)
        before = made.block.tolist()
        centers += 1
        radii += 1
        assert made.block.tolist() == before
    for i in {0, n // 2, n - 1}:
        for bad in np.nan, np.inf, -np.inf, 0.0, -0.0, -1.0:
            centers, radii = circle_arrays(n)
            radii[i] = bad
            assert outlines.certified_circles(centers, radii) is None
            for axis in range(2 if not np.isfinite(bad) else 0):
                centers, radii = circle_arrays(n)
                centers[i, axis] = bad
                assert outlines.certified_circles(centers, radii) is None
    assert outlines.certified_circles(np.zeros((0, 2)), np.zeros(0)) is None


def padded(counts, seed=0):
    """Return (corners, counts, radii) of circles (count: 1) and outlines in padded arrays."""
    rng, n = RNG([len(counts), seed]), len(counts)
    corners = np.full((n, max(counts), 2), np.nan)
    for i, v in enumerate(counts):
        corners[i, :v] = rng.uniform(-9, 9, 2) if v == 1 else plain_outlines(v, 3)[i % 3]
    return corners, np.array(counts, np.intp), np.where(np.array(counts) == 1, 1.5, 0.0)


COUNTS = [[1], [3], [1, 1], [3, 3], [4, 1], [1, 3, 8, 1], [12, 3], [5, 5, 5, 1], [4, 8, 3, 1, 6, 12, 1, 5]]


@pytest.mark.parametrize("counts", COUNTS)
def test_plain_shapes_in_padded_arrays_are_certified_at_once(counts):
    for e in -400, 0, 400:
        corners, count, radii = padded(counts)
        corners, radii = corners * 2.0**e, radii * 2.0**e
        turned = corners.copy()
        for i, v in enumerate(counts):
            turned[i, :v] = corners[i, :v][::-1]
        for given in corners, turned:
            given_radii = np.where(radii > 0, radii, -0.0)
            made = outlines.certified_padded(given, count, given_radii)
            x, y, start = made.rings
            assert np.array_equal(np.stack([x, y], axis=1), np.concatenate([c[:v] for c, v in zip(corners, counts)]))
            assert np.diff(start).tolist() == counts == made.count.tolist() and made.radius.tolist() == radii.tolist()
            assert not np.shares_memory(made.radius, given_radii) and not np.signbit(made.radius).any()
            rows = max(counts) if max(counts) > 1 else 0  # circles alone have no edges
            assert len(made.as_complex.edges) == rows and len(made.as_complex.closed) == rows + 1
            assert (made.as_complex.radius is None) == (1 not in counts)


@pytest.mark.parametrize("counts", COUNTS)
def test_one_shape_at_fault_in_padded_arrays_is_left_to_exact_checks(counts):
    corners, count, radii = padded(counts, 1)
    n, most, _ = corners.shape

    def certified(**wrong):
        given = {"corners": corners.copy(), "counts": count.copy(), "radii": radii.copy()}
        for name, (at, value) in wrong.items():
            given[name][at] = value
        with np.errstate(divide="raise"):
            return outlines.certified_padded(*given.values())

    assert certified() is not None
    for i in range(n):
        for other in {0, -1, most + 1, *([1] if counts[i] > 1 else [2])} - {counts[i]}:
            assert certified(counts=(i, other)) is None
        for r in {-1.0, np.nan, np.inf, -np.inf, 2.0 if counts[i] > 1 else 0.0}:
            assert certified(radii=(i, r)) is None
            assert certified(radii=(i, r), corners=(i, corners[i, 0])) is None  # nor if no corner turns right
        for at in np.ndindex(counts[i], 2):
            for bad in np.nan, np.inf, -np.inf:
                assert certified(corners=((i, *at), bad)) is None
        ring = corners[i, : counts[i]]
        for k in range(counts[i] if counts[i] > 1 else 0):
            assert certified(corners=((i, k), ring[k - 1])) is None
            assert certified(corners=((i, k), (ring[k - 1] + ring[(k + 1) % counts[i]]) / 2)) is None
        if counts[i] > 4:
            for step in range(2, counts[i] // 2 + 1):
                for way in 1, -1:
                    wound = star(counts[i], step, 50)[::way]
                    assert certified(corners=((i, slice(counts[i])), wound)) is None
        polygons = sum(v > 1 for v in counts)
        if counts[i] > 1 and polygons > 1:
            assert certified(corners=((i, slice(counts[i])), ring[::-1].copy())) is None  # not all one way round


def test_very_many_shapes_in_padded_arrays_are_left_to_validation_by_groups():
    for v, n in ((1, 2**15), (4, 2**13)):
        for more in 0, 1:
            corners = np.zeros((n + more, v, 2)) + (0 if v == 1 else np.array([(0, 0), (1, 0), (1, 1), (0, 1)]))
            counts, radii = np.full(n + more, v, np.intp), np.full(n + more, float(v == 1))
            assert (outlines.certified_padded(corners, counts, radii) is None) == bool(more)
    assert outlines.certified_padded(np.zeros((0, 4, 2)), np.zeros(0, np.intp), np.zeros(0)) is None
    assert outlines.certified_padded(np.zeros((2, 0, 2)), np.zeros(2, np.intp), np.zeros(2)) is None
