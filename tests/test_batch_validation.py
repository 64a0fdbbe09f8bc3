"""Tests of the validation of batches: same rules and messages as for single shapes, and the input is never changed."""

import importlib
import inspect
import sys
import warnings
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from itertools import pairwise, permutations, product

import numpy as np
import pytest
from speeds import one_in

import satviz as sv
from satviz import batch
from satviz.batch import arrays, collide, constructors, engines, narrow_phase, outlines, validation
from satviz.batch.with_numpy import filter as filter_numpy
from satviz.engine import predicates

broad_phase = importlib.import_module("satviz.batch.broad_phase")  # the module itself

TRIANGLE = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]
ELL = [(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)]
CLOCKWISE = np.array([TRIANGLE[::-1]] * 3)


def with_last(value, dtype=None):
    return np.array([*TRIANGLE[:2], (0, value)], dtype=dtype)


BAD = {
    "nan": with_last(np.nan),
    "infinity": with_last(np.inf),
    "a lossy integer": with_last(2**53 + 1, np.int64),
    "a lossy unsigned integer": with_last(2**64 - 1, np.uint64),
    "a long double": with_last(np.nextafter(np.longdouble(1), np.longdouble(2))),
    "a long double too large": with_last(np.ldexp(np.longdouble(1), 2000)),
    "an infinite long double": with_last(np.longdouble(np.inf)),
    "booleans": np.array(TRIANGLE, bool),
    "complex": np.array(TRIANGLE, complex),
    "text": np.array(TRIANGLE).astype(str),
    "times": np.array(TRIANGLE).astype("m8[s]"),
    "masked": np.ma.masked_equal(np.array(TRIANGLE), 1),
    "a boolean in a list": [(0, 0), (1, 0), (0, True)],
    "a lossy integer in a list": [(0, 0), (1, 0), (0, 2**53 + 1)],
    "a giant integer in a list": [(0, 0), (1, 0), (0, 10**400)],
    "text in a list": [(0, 0), (1, 0), (0, "1")],
    "complex in a list": [(0, 0), (1, 0), (0, 1j)],
    "None in a list": [(0, 0), (1, 0), (0, None)],
    "an array in an array": [(0, 0), (1, 0), (0, np.array([1, 2]))],
    "three coordinates": [(0, 0, 0), (1, 0, 0), (0, 1, 0)],
    "two vertices": [(0, 0), (1, 0)],
    "no vertices": [],
    "a spike": [(0, 0), (2, 0), (1, 0), (1, 1)],
    "a bowtie": [(0, 0), (2, 2), (2, 0), (0, 2)],
    "no area": [(0, 0), (1, 1), (2, 2)],
}

CORNERS = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)]
NO_OUTLINES = {
    "four of three coordinates": [(*p, 0.0) for p in CORNERS],
    "one of three coordinates": [*CORNERS, (1.0, 2.0, 3.0)],
    "a vertex that is a set": [*CORNERS, {0.0, 1.0}],
    "a vertex that is a dict": [*CORNERS, {0.0: 0, 1.0: 0}],
    "a vertex that is text": [*CORNERS, "01"],
    "a vertex that is a number": [*CORNERS, 0.0],
    "a set of vertices": set(CORNERS),
    "a dict of vertices": dict.fromkeys(CORNERS),
    "numbers without vertices": np.ravel(CORNERS).tolist(),
    "an array of numbers": np.ravel(CORNERS),
    "an array of three coordinates": np.ones((4, 3)),
    "an array of one coordinate": np.ones((4, 1)),
    "an array of columns": np.array(CORNERS).T,
    "an array of arrays": np.ones((4, 2, 2)),
    "no array of vertices": np.empty((0, 2)),
}


def words(make, *arguments, **options):
    with pytest.raises(sv.InvalidShape) as error:
        made = make(*arguments, **options)
        list(made)
    return str(error.value)


@pytest.mark.parametrize("name", BAD | NO_OUTLINES)
def test_batches_refuse_what_scalar_shapes_refuse_with_the_same_message(name):
    bad = (BAD | NO_OUTLINES)[name]
    assert words(batch.Polygons, [TRIANGLE, bad]) == f"polygon 1: {words(sv.Polygon, bad)}"


@pytest.mark.parametrize("name", [name for name, bad in BAD.items() if isinstance(bad, np.ndarray)])
def test_arrays_and_streams_have_the_same_validation(name):
    bad = BAD[name]
    good = np.array(TRIANGLE).astype(bad.dtype)
    block = (np.ma if np.ma.isMaskedArray(bad) else np).stack([good, good, good, bad])
    said = words(batch.Polygons, block)
    of_kind = "array of" in said or "masked" in said  # true of the whole array: no polygon is named
    assert said == words(sv.Polygon, bad) if of_kind else said == f"polygon 3: {words(sv.Polygon, bad)}"
    assert words(batch.stream_colliding_pairs, block, strip=2) == said


PENTAGRAM = [(0, 3), (2, -3), (-3, 1), (3, 1), (-2, -3)]
SHAPED = {name: bad for name, bad in BAD.items() if name in ("nan", "infinity", "a spike", "a bowtie", "no area")}
SHAPED |= {"a pentagram": PENTAGRAM, "two vertices": [(0, 0), (1, 0)], "none": np.empty((0, 2))}


@pytest.mark.parametrize("before", [0, 1, 3])
@pytest.mark.parametrize("name", SHAPED)
def test_outlines_with_offsets_have_the_same_validation(name, before):
    bad = np.asarray(SHAPED[name], float)
    good = np.array(TRIANGLE)
    rings = [good] * before + [bad, good, bad]
    start = np.cumsum([0, *map(len, rings)])
    said = f"polygon {before}: {words(sv.Polygon, bad)}"
    assert words(batch.Polygons, np.concatenate(rings), offsets=start) == said
    assert words(batch.Polygons, np.concatenate(rings), offsets=start, concave="split") == said
    assert words(batch.Polygons, rings) == words(batch.Polygons, [r.tolist() for r in rings]) == said


@pytest.mark.parametrize("name", [name for name, bad in BAD.items() if isinstance(bad, np.ndarray)])
def test_vertices_with_offsets_must_be_valid_numbers(name):
    bad = BAD[name]
    stack = np.ma.concatenate if np.ma.isMaskedArray(bad) else np.concatenate
    block = stack([np.array(TRIANGLE).astype(bad.dtype)] * 2 + [bad])
    said = words(sv.Polygon, bad)
    of_kind = "array of" in said or "masked" in said
    assert words(batch.Polygons, block, offsets=[0, 3, 6, 9]) == (said if of_kind else f"polygon 2: {said}")


@pytest.mark.parametrize(
    ("offsets", "said"),
    [
        ([0, 3, 5], "ends with 5"),
        ([0, 3, 7], "ends with 7"),
        ([1, 3, 6], "begins with 1"),
        ([-3, 3, 6], "begins with -3"),
        ([0, 4, 3, 6], "falls from 4 to 3"),
        ([0.0, 3.0, 6.0], "float64"),
        ([[0, 3, 6]], "(1, 3)"),
        ([], "(0,)"),
        ([True, False], "bool"),
        (np.array([0, 3, 2**63], np.uint64), "offsets holds 9223372036854775808: offsets must rise"),
        (np.ma.array([0, 3, 6], mask=[0, 1, 0]), "offsets has masked entries"),
    ],
)
def test_offsets_that_do_not_fit_are_refused(offsets, said):
    assert said in words(batch.Polygons, np.array(TRIANGLE * 2), offsets=offsets)


@pytest.mark.parametrize(
    "shape", [(), (3,), (2, 3), (2, 2, 2), (0, 2, 2), (2, 3, 1), (2, 3, 3), (2, 0, 2), (1, 2, 3, 2)]
)
def test_an_array_of_a_wrong_shape_is_refused_with_its_shape(shape):
    said = f"vertices has the shape {shape}: expected (N, V, 2) with V at least 3"
    assert words(batch.Polygons, np.zeros(shape)) == said


LAYOUTS = {
    "an array": lambda rings: batch.Polygons(np.array(rings)),
    "an array of objects": lambda rings: batch.Polygons(np.array(rings, object)),
    "lists": batch.Polygons,
    "tuples": lambda rings: batch.Polygons(tuple(tuple(map(tuple, ring)) for ring in rings)),
    "arrays": lambda rings: batch.Polygons(list(map(np.array, rings))),
    "arrays of float32": lambda rings: batch.Polygons([np.array(ring, np.float32) for ring in rings]),
    "one after another": lambda rings: batch.Polygons(np.concatenate(rings), offsets=np.arange(0, 13, 4)),
    "points one after another": lambda rings: batch.Polygons(
        [p for ring in rings for p in ring], offsets=np.arange(0, 13, 4)
    ),
    "a stream": lambda rings: batch.stream_colliding_pairs(np.array(rings), strip=2),
}


@pytest.mark.parametrize("layout", LAYOUTS)
def test_the_first_invalid_number_is_named_in_all_layouts(layout):
    for i, j, k in np.ndindex(3, 4, 2):
        rings = [[[5.0, 5.0], [6.0, 5.0], [6.0, 6.0], [5.0, 6.0]] for _ in range(3)]
        rings[2][3][1] = np.inf
        rings[i][j][k] = np.nan
        said = f"polygon {i}: vertex {j}.{'xy'[k]} is nan: numbers must be finite"
        assert words(LAYOUTS[layout], rings) == said


@pytest.mark.parametrize("first", [np.nan, True, 2**53 + 1, None, (1.0, 2.0)], ids=repr)
@pytest.mark.parametrize("second", [np.nan, True, 2**53 + 1, None, (1.0, 2.0)], ids=repr)
def test_the_first_of_two_invalid_lists_is_named(first, second):
    for i, j in (0, 1), (1, 3), (2, 3):
        rings = [[*CORNERS] for _ in range(4)]
        rings[i][1], rings[j][1] = (5.0, first), (5.0, second)
        assert words(batch.Polygons, rings) == f"polygon {i}: {words(sv.Polygon, rings[i])}"


@pytest.mark.parametrize("made", [np.array, list, tuple, lambda values: np.array(values, object)])
def test_the_first_invalid_number_of_circles_and_boxes_is_named(made):
    for i, k in np.ndindex(3, 2):
        centers = [[1.0, 2.0], [3.0, 4.0], [5.0, 6.0]]
        centers[2][1] = np.inf
        centers[i][k] = np.nan
        assert words(batch.Circles, made(centers), 1).startswith(f"circle {i}: center.{'xy'[k]} is nan")
    for i in range(3):
        radii = [1.0, 2.0, np.inf]
        radii[i] = np.nan
        assert words(batch.Circles, np.zeros((3, 2)), made(radii)).startswith(f"circle {i}: radius is nan")
        assert words(batch.Circles, np.zeros((3, 2)), made([1.0] * i + [-1.0] * (3 - i))).startswith(f"circle {i}: ")
    for i, k in np.ndindex(3, 4):
        boxes = [[0.0, 0.0, 1.0, 1.0] for _ in range(3)]
        boxes[2][3] = np.inf
        boxes[i][k] = np.nan
        assert words(batch.candidate_pairs, made(boxes)).startswith(f"bounds[{i}][{k}] is nan")
        boxes[2][3], boxes[i] = 1.0, [0.0, 2.0, 1.0, 1.0]
        assert words(batch.candidate_pairs, made(boxes)).startswith(f"bounds[{i}] is [0.0, 2.0, 1.0, 1.0]")


@pytest.mark.parametrize("layout", [name for name in LAYOUTS if name != "a stream"])
def test_minus_zero_is_zero(layout):
    made = LAYOUTS[layout]([[[-0.0, -1.0], [1.0, -0.0], [-0.0, 1.0], [-1.0, -0.0]]] * 3)
    for corners in (*made.rings[:2], made.uniform.x, made.uniform.y):
        assert not np.signbit(corners[corners == 0]).any()


@pytest.mark.parametrize("vertices", [[], [TRIANGLE], [ELL], np.zeros((0, 3, 2)), np.array([TRIANGLE])], ids=repr)
def test_an_unknown_value_of_concave_is_refused(vertices):
    with pytest.raises(ValueError, match='concave is \'merge\': choose "refuse" or "split"'):
        batch.Polygons(vertices, concave="merge")


@pytest.mark.parametrize("kind", [np.int8, np.uint8, np.uint64, ">i4", int])
def test_offsets_of_every_integer_type_mean_the_same(kind):
    assert batch.Polygons(np.array(TRIANGLE * 3), offsets=np.array([0, 3, 6, 9], kind)).count.tolist() == [3, 3, 3]
    for offsets in [0, 4, 3, 6], [0, 9, 3, 6], [0, 6, 4, 3]:
        fall = next(i for i in range(3) if offsets[i] > offsets[i + 1])
        said = f"offsets falls from {offsets[fall]} to {offsets[fall + 1]}: "
        assert words(batch.Polygons, np.array(TRIANGLE * 2), offsets=np.array(offsets, kind)).startswith(said)


def test_the_repr_of_a_batch_counts_its_shapes():
    ell = np.array([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)])
    split = batch.Polygons([ell, TRIANGLE, ell + 5], concave="split")
    assert repr(split) == "Polygons(1 x 3-gon, 4 x 4-gon, parts of 3)"
    assert repr(batch.Circles([(0, 0), (1, 1)], 1)) == "Circles(2 x circle)"
    assert repr(split[:0]) == "Shapes(parts of 0)"


def test_an_outline_keeps_its_coordinates_in_all_layouts():
    rings = [TRIANGLE, [(5, 5), (6, 5), (6, 6), (5, 6)], [(0, 9), (1, 9), (2, 9), (2, 9), (1, 11)], TRIANGLE[::-1]]
    corners = [[0, 0, 1, 1], [5, 5, 6, 6], [0, 9, 2, 11], [0, 0, 1, 1]]
    given = np.concatenate([np.array(ring, float) for ring in rings])
    made = batch.Polygons(given, offsets=np.cumsum([0, *map(len, rings)]))
    assert made.bounds.tolist() == corners and repr(made) == "Polygons(3 x 3-gon, 1 x 4-gon)"
    padded = np.array([[*ring, *[ring[0]] * (5 - len(ring))] for ring in rings], float)
    assert batch.Polygons(padded).bounds.tolist() == batch.Polygons(rings).bounds.tolist() == corners
    none = batch.Polygons(np.empty((0, 2)), offsets=[0])
    assert len(none) == 0 and batch.colliding_pairs(none).shape == (0, 2)


def test_polygons_of_shapely_keep_their_coordinates():
    shapely = pytest.importorskip("shapely")
    ell = shapely.Polygon(ELL)
    made = batch.from_shapely(np.array([shapely.box(0, 0, 1, 1), shapely.Polygon(TRIANGLE)]))
    assert made.bounds.tolist() == [[0, 0, 1, 1], [0, 0, 1, 1]]
    assert len(batch.from_shapely([ell, ell], concave="split")) == 2
    assert words(batch.from_shapely, [shapely.box(0, 0, 1, 1), ell]).startswith("polygon 1 is not convex")
    hole = shapely.box(0, 0, 9, 9) - shapely.box(1, 1, 2, 2)
    for odd in (
        hole,
        shapely.Point(0, 0),
        shapely.MultiPolygon([ell]),
        shapely.Polygon(),
        shapely.Polygon([(0, 0, 1), (1, 0, 1), (0, 1, 1)]),
        None,
        "POLYGON",
    ):
        said = words(sv.Polygon, odd)
        assert words(batch.from_shapely, [odd]) == f"polygon 0: {said}"
        assert words(batch.from_shapely, [shapely.box(0, 0, 1, 1), odd]) == f"polygon 1: {said}"
    ring = shapely.LinearRing(TRIANGLE)
    for other in shapely.LinearRing(ELL), sv.Polygon(ELL), ELL:
        assert len(batch.from_shapely([ring, ell, other], concave="split")) == 3
    assert batch.from_shapely([ring, ell.convex_hull]).bounds.tolist() == [[0, 0, 1, 1], [0, 0, 4, 4]]
    assert len(batch.from_shapely([])) == 0


NUMBERS = [True, "1", 1j, None, np.nan, np.inf, 2**53 + 1, 10**400, np.array([1, 2]), [1], sv, np.datetime64("2020")]


@pytest.mark.parametrize("odd", NUMBERS, ids=repr)
def test_an_array_of_objects_is_validated_number_by_number(odd):
    block = np.array([TRIANGLE] * 3, object)
    block[2, 1, 0] = odd
    said = f"polygon 2: {words(sv.Polygon, block[2])}"
    assert words(batch.Polygons, block) == words(batch.stream_colliding_pairs, block, strip=2) == said
    center = np.array([(0, 0)] * 3, object)
    center[2, 1] = odd
    assert words(batch.Circles, center, 1) == f"circle 2: {words(sv.Circle, center[2], 1)}"
    box = np.array([(0, 0, 1, 1)] * 3, object)
    box[2, 3] = odd
    said = words(batch.candidate_pairs, box)
    assert said.startswith("bounds[2][3] is "), said
    assert said == words(batch.candidate_pairs, box.tolist())


def test_an_array_of_objects_that_are_numbers_is_accepted():
    block = np.array([TRIANGLE] * 3, object)
    ((found),) = batch.stream_colliding_pairs(block)
    assert found.tolist() == batch.colliding_pairs(batch.Polygons(block)).tolist() == [[0, 1], [0, 2], [1, 2]]


@pytest.mark.parametrize("name", ["booleans", "complex", "text", "times", "masked"])
def test_boxes_must_be_valid_numbers(name):
    array = BAD[name]
    of_four = np.ma.concatenate if np.ma.isMaskedArray(array) else np.concatenate
    said = words(batch.candidate_pairs, of_four([array, array], axis=1))
    assert said.replace("bounds", "vertices") == words(sv.Polygon, array)


def test_boxes_may_be_lists_and_an_invalid_box_is_named():
    boxes = [(0, 0, 1, 1), [1, 1, 2, 2], np.array((5, 5, 6, 6))]
    assert batch.candidate_pairs(boxes).tolist() == [[0, 1]]
    assert batch.candidate_pairs([]).shape == (0, 2)
    lossy = np.array([(0, 0, 1, 2**53 + 1)])
    assert words(batch.candidate_pairs, lossy).startswith("bounds[0][3] is 9007199254740993")
    assert words(batch.candidate_pairs, [boxes[0], (1, 2, 3)]).startswith("bounds[1] has 3 numbers")
    assert words(batch.candidate_pairs, [boxes[0], 7]).startswith("bounds[1] is 7")
    assert words(batch.candidate_pairs, [(0, 0, -1, 1)]).startswith("bounds[0] is [0.0, 0.0, -1.0, 1.0]")


@pytest.mark.parametrize("places", [(-1, 1), (-1, 0, 1), (-1, -1, -1, 1, 1)])
@pytest.mark.parametrize("far", [1e308, 1.7e308])
@pytest.mark.parametrize("size", [1e294, 1e300, 5e306])
def test_coordinates_near_the_end_of_float64_raise_no_warning(places, far, size):
    at = far * np.array([(x, y) for x in places for y in places])
    shapes = batch.Polygons(at[:, None] + size * np.array(TRIANGLE))
    coins = batch.Circles(at, size)
    pairs = [[i, j] for i in range(len(at)) for j in range(i + 1, len(at)) if (at[i] == at[j]).all()]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert batch.colliding_pairs(shapes).tolist() == batch.colliding_pairs(coins).tolist() == pairs
        for strip in (1, 3):
            found = batch.stream_colliding_pairs(at[:, None] + size * np.array(TRIANGLE), strip=strip)
            assert sorted(pair for some in found for pair in some.tolist()) == pairs


def test_a_stream_names_the_invalid_polygon_by_its_place_in_the_file():
    apart = np.array(TRIANGLE) + 10 * np.arange(9)[:, None, None]
    crossed = np.array([(0, 0), (2, 2), (2, 0), (0, 2)]) + 10 * np.arange(9)[:, None, None]
    outlines = np.stack([crossed[:, 0], (crossed[:, 0] + crossed[:, 2]) / 2, crossed[:, 2], crossed[:, 3]], axis=1)
    outlines[7] = crossed[7]
    assert words(batch.stream_colliding_pairs, outlines, strip=2) == words(batch.Polygons, outlines)
    assert words(batch.stream_colliding_pairs, outlines, strip=2).startswith("polygon 7: ")
    assert "call colliding_pairs for other forms" in words(batch.stream_colliding_pairs, list(apart))
    with pytest.raises(ValueError, match="strip is 0"):
        list(batch.stream_colliding_pairs(apart, strip=0))


@pytest.mark.parametrize(
    ("center", "radius"),
    [
        ((0, np.nan), 1),
        ((0, True), 1),
        ((0, 2**53 + 1), 1),
        ((0, "1"), 1),
        ((0, 1, 2), 1),
        ((0, 0), 0),
        ((0, 0), -1),
        ((0, 0), np.inf),
        ((0, 0), True),
        ((0, 0), "1"),
        ((0, 0), 1j),
        ((0, 0), 2**53 + 1),
    ],
)
def test_circles_have_the_validation_of_single_ones(center, radius):
    said = words(sv.Circle, center, radius)
    assert words(batch.Circles, [(0, 0), center], [1, radius]) == f"circle 1: {said}"


def test_arrays_of_circles_are_validated_like_lists():
    assert (
        words(batch.Circles, np.array([(0, 0), (1, np.inf)]), 1) == "circle 1: center.y is inf: numbers must be finite"
    )
    assert words(batch.Circles, np.zeros((2, 2)), np.array([1, np.nan])).startswith("circle 1: radius is nan")
    assert words(batch.Circles, np.zeros((2, 2)), np.array([1, -1])).startswith("circle 1: radius is -1.0")
    for radius in (np.nan, np.array(np.nan), 2**53 + 1, 0, -1):  # one for all: no circle is named but for its size
        assert words(batch.Circles, [(0, 0)], radius).removeprefix("circle 0: ") == words(sv.Circle, (0, 0), radius)
    assert "expected (N, 2)" in words(batch.Circles, np.zeros(4), 1)
    assert "expected (2,)" in words(batch.Circles, np.zeros((2, 2)), [1, 2, 3])


@pytest.mark.parametrize("radius", [2, 2.0, [2], (2,), np.array(2), np.array([2]), np.array([2], object), [2, 2, 2]])
def test_one_radius_of_any_type_may_stand_for_all(radius):
    assert batch.Circles([(0, 0), (1, 1), (2, 2)], radius).uniform.r.tolist() == [2, 2, 2]


@pytest.mark.parametrize(("radii", "shape"), [([], (0,)), ([1, 2], (2,)), (np.ones((3, 1)), (3, 1)), ([1] * 4, (4,))])
def test_radii_for_some_of_the_circles_are_refused_by_their_shape(radii, shape):
    said = f"radii has the shape {shape}: expected (3,), or one radius for all"
    assert words(batch.Circles, [(0, 0), (1, 1), (2, 2)], radii) == said


@pytest.mark.parametrize("thing", [3, None, "abc", {"a": 1}, np.float64(1), np.array(1.0), np.array(None)])
def test_an_argument_that_is_no_sequence_is_refused_with_a_message(thing):
    words(batch.Polygons, thing)
    words(batch.Polygons, [thing])
    words(batch.Circles, thing, 1)
    words(batch.stream_colliding_pairs, thing)


def test_a_list_instead_of_a_batch_is_refused_with_the_way_to_make_one():
    made = batch.Polygons([TRIANGLE])
    for call in (
        lambda: batch.relate([TRIANGLE], made),
        lambda: batch.hits(made, sv.Polygon(TRIANGLE)),
        lambda: batch.colliding_pairs([TRIANGLE]),
        lambda: batch.concat([made, [TRIANGLE]]),
    ):
        with pytest.raises(TypeError, match=r"is a (list|Polygon): make it with batch\.Polygons or batch\.Circles"):
            call()


def test_shapes_of_other_libraries_and_our_own_are_accepted():
    shapely = pytest.importorskip("shapely")
    made = batch.Polygons(
        [shapely.Polygon(TRIANGLE), sv.Polygon(TRIANGLE), TRIANGLE, np.array(TRIANGLE), iter(TRIANGLE)]
    )
    assert batch.relate(made, made).tolist() == [2] * 5
    assert len(batch.concat([])) == 0 == len(batch.Polygons([])) == len(batch.Polygons(np.zeros((0, 5, 2))))


# -- outlines


def any_outline(rng):
    """Return a random outline on a grid, which may be invalid.

    It is a random walk, random points, or an outline with repeated and collinear vertices that winds once or twice.
    """
    kind = rng.random()
    if kind < 0.2:
        return rng.integers(0, 3, (int(rng.integers(0, 8)), 2)).tolist()
    if kind < 0.4:
        return rng.integers(-1, 2, (int(rng.integers(3, 9)), 2)).cumsum(axis=0).tolist()
    kinds = [(0, 0), (4, 0), (4, 4), (0, 4)], [(0, 0), (4, 0), (0, 4)], [(0, 0), (4, 2), (6, 6), (2, 6), (0, 4)], ELL
    ring = kinds[rng.integers(4)] * (2 if rng.random() < 0.1 else 1)
    first = int(rng.integers(len(ring)))
    ring = ring[first:] + ring[:first]
    full = []
    for p, q in zip(ring, ring[1:] + ring[:1]):
        full += [p] * int(rng.choice([1, 1, 1, 2, 3]))
        if rng.random() < 0.3:
            full.append(((p[0] + q[0]) / 2, (p[1] + q[1]) / 2))
    return full[:: int(rng.choice([1, -1]))]


def around(corners):
    """Return the corners rotated so that the lowest one comes first."""
    corners = list(map(tuple, corners))
    first = corners.index(min(corners))
    return corners[first:] + corners[:first]


@pytest.mark.parametrize("block", one_in(3, [1, 3, 4, 11, 100, outlines.BLOCK_CORNERS]))
def test_outlines_are_validated_as_single_polygons_are_in_blocks_of_any_size(block, monkeypatch):
    monkeypatch.setattr(outlines, "BLOCK_CORNERS", block)
    rng = np.random.default_rng(block)
    good, bad = [], []
    for ring in (any_outline(rng) for _ in range(200)):
        try:
            good.append((ring, [around(part.core) for part in sv.parts(sv.Polygon(ring))]))
        except sv.InvalidShape as error:
            bad.append((ring, str(error)))
    rings, cores = map(list, zip(*good))
    start = np.cumsum([0, *map(len, rings)])
    for made in (
        batch.Polygons(rings, concave="split"),
        batch.Polygons(np.concatenate(rings), offsets=start, concave="split"),
    ):
        assert made.owner.tolist() == [i for i, core in enumerate(cores) for _ in core]
        x, y, first = made.rings
        found = [around(zip(x[i:j], y[i:j])) for i, j in pairwise(first)]
        assert found == [part for core in cores for part in core]
    convex = [ring for ring, core in good if len(core) == 1]
    assert batch.Polygons(convex).owner is None
    for i, (ring, error) in enumerate(bad):
        some = [*convex[: i % 4], ring, *convex[:2], bad[i - 1][0]]
        assert words(batch.Polygons, some) == f"polygon {i % 4}: {error}"


# -- the caller's own


@pytest.mark.parametrize("concave", ["refuse", "split"])
@pytest.mark.parametrize("order", ["C", "F", "transposed", "by coordinate", "one", "reversed"])
def test_the_array_of_the_caller_is_never_written_to(order, concave):
    given = {
        "C": np.ascontiguousarray(CLOCKWISE),
        "F": np.asfortranarray(CLOCKWISE),
        "transposed": np.ascontiguousarray(CLOCKWISE.transpose(2, 1, 0)).transpose(2, 1, 0),
        "by coordinate": np.ascontiguousarray(CLOCKWISE.transpose(2, 0, 1)).transpose(1, 2, 0),
        "one": CLOCKWISE[:1].copy(),
        "reversed": CLOCKWISE.copy()[::-1],
    }[order]
    before = given.copy()
    batch.Polygons(given, concave=concave)
    assert np.array_equal(given, before)
    given.flags.writeable = False
    assert len(batch.Polygons(given, concave=concave)) == len(given)


@pytest.mark.parametrize("concave", ["refuse", "split"])
@pytest.mark.parametrize("order", ["C", "F"])
def test_vertices_with_offsets_and_arrays_in_a_list_are_never_written_to(order, concave):
    given = CLOCKWISE.reshape(-1, 2).copy(order=order)
    start = np.arange(0, 10, 3)
    batch.Polygons(given, offsets=start, concave=concave)
    batch.Polygons([given[:3]], concave=concave)
    assert np.array_equal(given, CLOCKWISE.reshape(-1, 2)) and start.tolist() == [0, 3, 6, 9]


@pytest.mark.parametrize("mode", ["r", "r+", "c"])
@pytest.mark.parametrize("fortran", [False, True])
def test_a_mapped_file_is_never_written_to(tmp_path, mode, fortran):
    np.save(tmp_path / "rings.npy", np.asfortranarray(CLOCKWISE) if fortran else CLOCKWISE)
    before = (tmp_path / "rings.npy").read_bytes()
    mapped = np.load(tmp_path / "rings.npy", mmap_mode=mode)
    batch.Polygons(mapped)
    list(batch.stream_colliding_pairs(mapped, strip=2))
    batch.Circles(mapped[:, 0], 1)
    if mode == "r+":
        mapped.flush()
    assert (tmp_path / "rings.npy").read_bytes() == before


def test_later_changes_of_the_input_change_no_relation():
    centers, radii, rings = np.array([(0.0, 0.0), (3.0, 0.0)]), np.array([1.0, 1.0]), np.array([TRIANGLE] * 2)
    column = np.asfortranarray(centers)
    made = [batch.Circles(centers, radii), batch.Circles(column, radii), batch.Polygons(rings)]
    before = [batch.relate(s, s[::-1]).tolist() for s in made]
    for array in (centers, column, radii, rings):
        array += 7
    assert [batch.relate(s, s[::-1]).tolist() for s in made] == before


# -- slices


def three_in_parts():
    return batch.Polygons([TRIANGLE, ELL, TRIANGLE], concave="split")


@pytest.mark.parametrize(
    "where",
    [
        slice(1, None),
        slice(None, None, -1),
        slice(0, 3, 2),
        slice(5, 9),
        [0, 1, 2, 1],
        [],
        np.array([2, 0]),
        np.array([True, False, True]),
        [-1, -3],
        0,
        -1,
        np.int64(1),
    ],
    ids=str,
)
def test_indexing_selects_the_same_shapes_as_in_a_list_split_or_not(where):
    rings = [TRIANGLE, ELL, TRIANGLE]
    names = np.atleast_1d(np.arange(3)[where])
    far = [(9, 9), (10, 9), (9, 10)]
    for concave, one in (("split", rings), ("refuse", [TRIANGLE, far, TRIANGLE])):
        chosen = batch.Polygons(one, concave=concave)[where]
        again = batch.Polygons([one[i] for i in names], concave=concave)
        assert len(chosen) == len(names)
        assert np.array_equal(chosen.bounds, again.bounds)
        assert batch.colliding_pairs(chosen).tolist() == batch.colliding_pairs(again).tolist()
        if len(names):
            everything = batch.Polygons(one, concave=concave)
            index = [(i, j) for i in range(len(names)) for j in range(3)]
            expected = [batch.relate(everything[int(names[i])], everything[j]).item() for i, j in index]
            assert batch.relate(chosen, everything, index).tolist() == expected


@pytest.mark.parametrize("where", [3, -4, [0, 3], np.array([True]), "a", 1.5, [[0, 1]], None])
def test_an_index_beyond_the_shapes_is_an_index_error(where):
    for shapes in (three_in_parts(), batch.Polygons([TRIANGLE] * 3)):
        with pytest.raises(IndexError):
            shapes[where]


def test_parts_keep_their_owners_when_batches_are_concatenated():
    joined = batch.concat([three_in_parts(), batch.Circles([(0, 0)], 1), three_in_parts(), three_in_parts()[1]])
    assert joined.owner.tolist() == [0, 1, 1, 2, 3, 4, 5, 5, 6, 7, 7]
    assert joined.bounds[[1, 3, 5, 7]].round().tolist() == [[0, 0, 4, 4], [-1, -1, 1, 1], [0, 0, 4, 4], [0, 0, 4, 4]]


def test_concatenated_batches_have_owners_only_if_a_shape_is_split():
    convex, parts = batch.Polygons([TRIANGLE] * 2), three_in_parts()
    assert batch.concat([convex, convex]).owner is None and batch.concat([]).owner is None
    both = batch.concat([parts, parts]).owner
    assert both.dtype == np.int64 and both.tolist() == [*parts.owner, *(parts.owner + 3)]


def test_the_maxima_of_concatenated_batches_hold_for_all_shapes():
    """These are the largest coordinate, the largest edge component, and whether all shapes are upright boxes."""
    box = np.array([(0, 0), (1, 0), (1, 1), (0, 1)])
    kite = np.array([(0, -1), (1, 0), (0, 1), (-1, 0)])
    some = [(box * 1e-9, True), (box[[1, 2, 3, 0]], True), (kite * 9, False), (box * 1e-3 - 5, True), (kite / 9, False)]
    for size, chosen in product((1, 1e-12), permutations(some, 3)):
        rings, upright = [ring * size for ring, _ in chosen], [is_upright for _, is_upright in chosen]
        joined = batch.concat([batch.Polygons([ring]) for ring in rings])
        group = joined.groups[4]
        edges = np.array(rings) - np.roll(rings, 1, axis=1)
        assert group.tile_maxima == arrays.TileMaxima(np.abs(edges).max(), np.abs(rings).max())
        assert group.upright == joined.are_upright_boxes == all(upright)
        assert joined.flat.upright.tolist() == upright
        made = batch.Polygons(np.array(rings)).uniform
        assert made.tile_maxima == group.tile_maxima and made.upright == group.upright


def test_the_largest_and_smallest_numbers_of_corners_exist_also_for_an_empty_batch():
    mixed = batch.concat([batch.Polygons([TRIANGLE, [(0, 0), (1, 0), (1, 1), (0, 1)]]), batch.Circles([(0, 0)], 1)])
    assert (mixed.max_corners, mixed.min_corners) == (4, 1) and (mixed[:2].max_corners, mixed[:2].min_corners) == (4, 3)
    assert (mixed[:0].max_corners, mixed[:0].min_corners) == (0, 0)
    for none in mixed[:0], batch.Polygons([]), three_in_parts()[:0], batch.Polygons(np.zeros((0, 3, 2))):
        assert none.bounds.shape == (0, 4) and none.flat.bounds.shape == (0, 4)


def test_the_box_of_a_circle_contains_the_circle():
    """The sum of a center's coordinate and the radius is usually no float, so the box is rounded outwards."""
    rng = np.random.default_rng(1)
    x, y, r = rng.uniform(-1, 1, (3, 300)) * 2.0 ** rng.integers(-60, 60, (3, 300))
    for (left, low, right, top), *circle in zip(batch.Circles(np.c_[x, y], np.abs(r)).bounds.tolist(), x, y, np.abs(r)):
        x0, y0, r0 = map(Fraction, circle)
        assert left < x0 - r0 and low < y0 - r0 and x0 + r0 < right and y0 + r0 < top


def test_cached_values_change_no_box_and_no_selection():
    def mixed():
        return batch.concat([batch.Polygons([TRIANGLE]), batch.Circles([(5, 5), (0, 2)], 1)])

    fresh, used = mixed(), mixed()
    assert used.rings and used.groups and used.flat
    assert np.array_equal(fresh.bounds, used.bounds)
    for where in (slice(1, None), [2, 0], slice(None, None, -1)):
        assert repr(fresh[where]) == repr(used[where])
        assert np.array_equal(fresh[where].bounds, used[where].bounds)


def test_a_split_batch_has_one_box_for_each_shape():
    assert three_in_parts().bounds.tolist() == [[0, 0, 1, 1], [0, 0, 4, 4], [0, 0, 1, 1]]


# -- options


SOME = batch.Circles([(0, 0), (1, 0)], 1)
OUTLINES = np.array([TRIANGLE, TRIANGLE])
# each public function that takes options, called with those given
TAKERS = {
    "Polygons": lambda **how: batch.Polygons(OUTLINES, **how),
    "broad_phase_of": lambda **how: batch.broad_phase_of(SOME, **how),
    "candidate_pairs": lambda **how: batch.candidate_pairs([(0, 0, 1, 1)] * 2, **how),
    "colliding_pairs": lambda **how: batch.colliding_pairs(SOME, **how),
    "from_shapely": lambda **how: batch.from_shapely([], **how),
    "hits": lambda **how: batch.hits(SOME, SOME, **how),
    "relate": lambda **how: batch.relate(SOME, SOME, **how),
    "stream_colliding_pairs": lambda **how: batch.stream_colliding_pairs(OUTLINES, **how),
}
SIZES = [(None, TypeError), (1.5, TypeError), ("5", TypeError), (True, TypeError), ([5], TypeError), (0, ValueError)]
WRONG = {
    "chunk": (SIZES, "whole number of at least 1|must be at least 1"),
    "concave": (
        [(None, TypeError), (True, TypeError), (["split"], TypeError), ("Split", ValueError)],
        'choose "refuse" or "split"',
    ),
    "engine": (
        [(1, TypeError), (["numpy"], TypeError), (True, TypeError), ("NumPy", ValueError), ("", ValueError)],
        'choose "numpy" or "numba"',
    ),
    "executor": (
        [("threads", TypeError), (4, TypeError), (False, TypeError), (ThreadPoolExecutor, TypeError)],
        r"concurrent\.futures\.Executor, or None",
    ),
    "progress": ([("bar", TypeError), (True, TypeError), (0, TypeError)], r"function of \(done, total\), or None"),
    "strip": (SIZES, "whole number of at least 1|must be at least 1"),
}


def options_of(name):
    found = getattr(batch, name)
    if name == "hits":
        return set(narrow_phase.RelateOptions.__annotations__)
    return {key for key, it in inspect.signature(found).parameters.items() if it.kind is it.KEYWORD_ONLY}


def test_every_option_of_the_batch_is_among_those_tested():
    public = {name: options_of(name) for name in batch.__all__ if name != "Shapes"}
    assert {name for name, found in public.items() if found} == set(TAKERS)
    assert set().union(*public.values()) == {*WRONG, "offsets"}  # which is data


@pytest.mark.parametrize(
    ("name", "option", "value", "error"),
    [
        pytest.param(name, option, value, error, id=f"{name} {option}={value!r}")
        for name in TAKERS
        for option in sorted(options_of(name) & set(WRONG))
        for value, error in WRONG[option][0]
    ],
)
def test_an_invalid_option_is_named_before_any_work(name, option, value, error, monkeypatch):
    def work(*_, **__):
        raise AssertionError("work was begun")

    for module in narrow_phase, collide, broad_phase, constructors, validation:
        for function in (
            "in_chunks",
            "candidate_blocks",
            "rings_from_array",
            "rings_from_offsets",
            "boxes",
            "check_pairs",
            "convex_rings",
        ):
            if hasattr(module, function):
                monkeypatch.setattr(module, function, work)
    with pytest.raises(error, match=f"^{option} is .*({WRONG[option][1]})"):
        TAKERS[name](**{option: value})


def test_a_size_may_be_any_whole_number():
    assert batch.hits(SOME, SOME, chunk=np.int8(1)).all()
    assert len(list(batch.stream_colliding_pairs(OUTLINES, strip=np.uint64(1)))) == 1


# -- the engine


@pytest.fixture
def fresh_choice():
    engines.load_engine.cache_clear()
    yield
    engines.load_engine.cache_clear()


@pytest.mark.parametrize(
    "fault", [ImportError("numba needs an older NumPy"), RuntimeError("cannot cache function 'circles'")], ids=str
)
def test_numpy_replaces_a_broken_numba_with_one_warning(fresh_choice, monkeypatch, fault):
    import builtins

    import_ = builtins.__import__

    def broken(name, globals=None, locals=None, fromlist=(), level=0):
        if name == "with_numba":
            raise fault
        return import_(name, globals, locals, fromlist, level)

    monkeypatch.setattr(builtins, "__import__", broken)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        shapes = batch.Polygons([TRIANGLE])
        assert batch.relate(shapes, shapes).tolist() == [2] == batch.relate(shapes, shapes).tolist()
    assert [str(w.message) for w in caught] == [f"numba does not work here, so NumPy does the work: {fault}"]
    with pytest.raises(ImportError, match=r"does not work here: .*choose engine=.numpy."):
        batch.relate(shapes, shapes, engine="numba")


def test_the_numba_engine_without_numba_is_refused_with_the_command_to_install_it(fresh_choice, monkeypatch):
    monkeypatch.setattr(engines, "find_spec", lambda name: None)
    monkeypatch.setitem(sys.modules, "numba", None)
    for name in [name for name in sys.modules if name.startswith("satviz.batch.with_numba")]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.delattr(batch, "with_numba", raising=False)
    with pytest.raises(ImportError, match=r"engine .numba. needs .*pip install"):
        engines.engine_of("numba")
    assert engines.engine_of(None).circles is filter_numpy.circles


@pytest.mark.parametrize("name", ["numpy", "numba"])
def test_an_engine_does_all_its_work_in_its_own_modules(name):
    if name == "numba":
        pytest.importorskip("numba", reason="needs numba: python -m pip install '.[fast]'")
    engine = engines.engine_of(name)
    kernels = [part for part in engine if callable(part)]
    assert len(kernels) >= 10
    assert all(f".with_{name}." in kernel.__module__ for kernel in kernels)
    assert engine is engines.engine_of(name)


def test_masked_indices_are_refused_and_a_tuple_of_indices_is_read_as_a_list():
    for split in "refuse", "split":
        shapes = batch.Polygons(
            [TRIANGLE, [(x + 1, y) for x, y in TRIANGLE], ELL][: 2 + (split == "split")], concave=split
        )
        with pytest.raises(ValueError, match="pairs has masked entries"):
            batch.relate(shapes, shapes, np.ma.array([[0, 0], [0, 1]], mask=[[0, 0], [1, 1]]))
        with pytest.raises(ValueError, match="indices has masked entries"):
            shapes[np.ma.array([0, 1], mask=[0, 1])]
        assert len(shapes[()]) == 0 and shapes[(1, 0)].bounds.tolist() == shapes[[1, 0]].bounds.tolist()


def test_an_empty_stream_has_the_validation_and_the_engines_of_others():
    for bad in np.empty((0, 3, 3)), np.empty((0, 3, 2), "U3"):
        assert words(batch.Polygons, bad) == words(lambda given: list(batch.stream_colliding_pairs(given)), bad)
    assert list(batch.stream_colliding_pairs(np.empty((0, 3, 2)))) == []
    with pytest.raises(ValueError, match="engine is 'x'"):
        list(batch.stream_colliding_pairs(np.empty((0, 3, 2)), engine="x"))


@pytest.mark.parametrize("none", [[], (), np.empty((0, 2)), np.empty((0, 2), int)], ids=repr)
@pytest.mark.parametrize("engine", [None, "numpy"])
def test_no_pairs_give_no_relations_for_every_way_to_write_them(none, engine):
    triangle = batch.Polygons([[(0, 0), (1, 0), (0, 1)]])
    split = batch.Polygons([[(0, 0), (3, 0), (3, 1), (1, 1), (1, 3), (0, 3)]], concave="split")
    for shapes in triangle, split, triangle[:0], split[:0]:
        assert batch.relate(shapes, shapes, none, engine=engine).shape == (0,)
        assert batch.hits(shapes, shapes, none, engine=engine).shape == (0,)
    assert batch.relate(split[:0], split[:0], engine=engine).shape == (0,)


@pytest.mark.parametrize(
    "make",
    [
        lambda: batch.Polygons(np.array([TRIANGLE])),
        lambda: batch.Polygons([TRIANGLE]),
        lambda: batch.Circles(np.zeros((2, 2)), 1.0),
    ],
    ids=["polygons of an array", "polygons of a list", "circles"],
)
def test_making_a_batch_warns_where_the_processor_flushes_subnormal_numbers_to_zero(make, monkeypatch):
    make()
    monkeypatch.setattr(predicates, "MIN_FLOAT", 0.0)
    with pytest.warns(RuntimeWarning, match="answers are exact only if"):
        make()
