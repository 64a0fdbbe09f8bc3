"""Shapes that move: every form of new coordinates, what is refused in which words, and first outlines that are kept."""

import numpy as np
import pytest
from batches import ENGINES, kernels_of

import satviz as sv
from satviz import batch
from satviz.batch import engines, moving
from satviz.batch.ragged import RaggedRings
from satviz.engine import predicates

BOX = np.array([(0.0, 0), (2, 0), (2, 2), (0, 2)])
TRIANGLE = np.array([(0.0, 0), (4, 0), (1, 3)])
FIVE = np.array([(0.0, 0), (2, 0), (3, 1), (1, 4), (-1, 2)])
MANY = np.round(100 * np.stack([f(2 * np.pi * np.arange(40) / 40) for f in (np.cos, np.sin)], axis=1))

MADE = {
    "boxes": lambda: batch.Polygons(np.array([BOX, BOX + 5, BOX + 1])),
    "one triangle": lambda: batch.Polygons(np.array([TRIANGLE])),
    "five corners": lambda: batch.Polygons([FIVE, FIVE + 9]),
    "eight corners": lambda: batch.Polygons(np.array([MANY[::5], MANY[2::5] + 200])),  # as many as a lane takes
    "many corners": lambda: batch.Polygons(np.array([MANY, MANY + 50])),
    "polygons": lambda: batch.Polygons([BOX, TRIANGLE + 1, FIVE + 2]),
    "circles": lambda: batch.Circles(np.array([(0.0, 0), (3, 4)]), np.array([1.0, 2.0])),
    "circles and polygons": lambda: batch.concat(
        [batch.Circles(np.array([(1.0, 1)]), 0.5), batch.Polygons(np.array([TRIANGLE])), batch.Circles([(9, 9)], 2.0)]
    ),
    "none": lambda: batch.Polygons(np.zeros((0, 3, 2))),
}


def corners_of(shapes):
    return np.stack(shapes.rings[:2], axis=1)


def rings_one_by_one(points, start, accept_centers):
    """Return what `certified_rings` of numba returns, by `sv.Polygon`."""
    kept, doubtful = [], []
    for i, ring in enumerate(np.split(points, start[1:-1]) if len(start) > 1 else []):
        if len(ring) == 1 and accept_centers and np.isfinite(ring).all():
            kept.append(ring + 0.0)
            continue
        try:
            core = np.array(sv.Polygon(ring).core)
        except sv.InvalidShape:
            core = []
        kept.append(ring[:0] if len(core) != len(ring) else core + 0.0)
        if len(core) != len(ring) or not sv.Polygon(ring).is_convex:
            doubtful.append(i)
    x, y = np.concatenate([np.empty((0, 2)), *kept]).T.copy()
    return RaggedRings(x, y, np.cumsum([0, *map(len, kept)])), np.array(doubtful, np.intp)


numbers = []  # of corners, by which an engine was chosen


@pytest.fixture(params=["numpy", "one by one", pytest.param("numba", marks=pytest.mark.slow)])
def made_by(request, monkeypatch):
    """Coordinates are checked by this engine, or by one that certifies outlines one after another as numba does."""
    if request.param == "numba":
        kernels_of("outlines")
    engine = engines.engine_of(request.param if request.param in ENGINES else "numpy")
    if request.param == "one by one":
        engine = engine._replace(certified_rings=rings_one_by_one)
    monkeypatch.setattr(moving, "engine_for_checks", lambda corners: numbers.append(corners) or engine)
    numbers.clear()
    return request.param


def forms_of(corners, shapes):
    """Yield the same coordinates of all corners in every form that `move` takes."""
    yield corners.copy()
    yield np.array(corners, order="F")
    yield np.repeat(corners, 2, axis=0)[::2]
    yield corners.astype(">f8")
    yield corners.astype(int)
    yield corners.tolist()
    yield list(corners)
    counts = set(shapes.count.tolist())
    rings = np.split(corners, shapes.rings.start[1:-1])
    if len(counts) == 1:
        array = np.array(rings)
        yield from (
            array.copy(),
            np.array(array, order="F"),
            array.tolist(),
            rings,
            iter(rings),
            array.astype(np.float32),
        )
        yield array[:, ::-1].copy()  # the other way round
    if counts and 1 not in counts:
        most = max(counts) + 1
        yield np.array([np.concatenate([ring, np.repeat(ring[:1], most - len(ring), axis=0)]) for ring in rings])


@pytest.mark.parametrize("kind", MADE)
def test_coordinates_in_every_form_make_the_batch_that_is_made_anew_of_them(kind, made_by):
    first = corners_of(MADE[kind]())
    for change in (lambda c: c - 3, lambda c: c[:, ::-1] * [1, -1], lambda c: c * 8):
        corners = change(first)
        for form in [*forms_of(corners, MADE[kind]())]:
            shapes = MADE[kind]()
            radius, count = shapes.radius.tolist(), shapes.count.tolist()
            before = form.copy() if isinstance(form, np.ndarray) else None
            assert batch.move(shapes, form) is shapes
            assert before is None or np.array_equal(before, form)
            assert sorted(map(tuple, corners_of(shapes).tolist())) == sorted(map(tuple, corners.tolist()))
            assert shapes.radius.tolist() == radius and shapes.count.tolist() == count and shapes.owner is None
            anew = [
                batch.Circles([ring[0]], r) if r else batch.Polygons([ring])
                for ring, r in zip(np.split(corners, shapes.rings.start[1:-1]), radius)
            ]
            right = batch.concat(anew) if anew else shapes
            assert shapes.bounds.tolist() == right.bounds.tolist() and type(shapes) is type(MADE[kind]())
            found = [batch.colliding_pairs(made, engine="numpy").tolist() for made in (shapes, right)]
            assert found[0] == found[1]
            batch.move(shapes, first)
            assert np.array_equal(shapes.bounds, MADE[kind]().bounds)
            if isinstance(form, np.ndarray) and form.flags.writeable:
                form += 1
                assert np.array_equal(shapes.bounds, MADE[kind]().bounds)


NOT = "make a new batch of these shapes, or give coordinates in which no corner repeats or lies on a straight edge"
BOXES_TAKE = "expected (3, 4, 2) or (12, 2), all corners one after another"
CIRCLES_TAKE = "expected (2, 1, 2) or (2, 2), all corners one after another"
POLYGONS_TAKE = "expected (12, 2), all corners one after another"
REFUSED = [
    ("boxes", np.zeros((2, 4, 2)), f"corners has the shape (2, 4, 2): {BOXES_TAKE}"),
    ("boxes", np.zeros((4, 4, 2)), f"corners has the shape (4, 4, 2): {BOXES_TAKE}"),
    ("boxes", np.zeros((3, 4, 3)), f"corners has the shape (3, 4, 3): {BOXES_TAKE}"),
    ("boxes", np.zeros((3, 4, 1)), f"corners has the shape (3, 4, 1): {BOXES_TAKE}"),
    ("boxes", np.zeros((11, 2)), f"corners holds 11 points: {BOXES_TAKE}"),
    ("boxes", np.zeros((13, 2)), f"corners holds 13 points: {BOXES_TAKE}"),
    ("boxes", [(0, 0)], f"corners holds 1 points: {BOXES_TAKE}"),
    ("boxes", np.zeros(24), "corners has the shape (24,): expected (N, 2)"),
    ("boxes", np.zeros((3, 2, 2, 2)), "corners has the shape (3, 2, 2, 2): expected (N, 2)"),
    ("boxes", np.zeros((12, 3)), "corners has the shape (12, 3): expected (N, 2)"),
    ("boxes", np.array([BOX[:3]] * 3), f"polygon 0 has 3 corners with these coordinates, but had 4: {NOT}"),
    ("boxes", np.array([BOX, BOX, FIVE[:4]])[:, [0, 1, 1, 2, 2]], "polygon 0 has 3 corners with these coordinates, "
     f"but had 4: {NOT}"),
    ("polygons", np.array([FIVE] * 3), f"polygon 0 has 5 corners with these coordinates, but had 4: {NOT}"),
    ("polygons", np.array([BOX, BOX, BOX]), f"polygon 1 has 4 corners with these coordinates, but had 3: {NOT}"),
    ("polygons", np.zeros((2, 5, 2)), f"corners has the shape (2, 5, 2): {POLYGONS_TAKE}"),
    ("polygons", np.zeros((11, 2)), f"corners holds 11 points: {POLYGONS_TAKE}"),
    ("circles", np.zeros((3, 2)), f"corners holds 3 points: {CIRCLES_TAKE}"),
    ("circles", np.zeros((2, 2, 2)), f"corners holds 4 points: {CIRCLES_TAKE}"),
    ("circles and polygons", np.zeros((3, 3, 2)), "corners holds 9 points: expected (5, 2), all corners one after "
     "another"),
    ("boxes", [BOX, BOX, TRIANGLE], "polygon 0: vertex 0 is array("),
    ("polygons", [BOX, TRIANGLE, FIVE], "polygon 0: vertex 0 is array("),
    ("boxes", 3, "corners is 3: expected a sequence"),
    ("boxes", None, "corners is None: expected a sequence"),
    ("boxes", [[1, 2, 3]], "polygon 0: vertex 0 is [1, 2, 3]: expected a pair (x, y)"),
    ("boxes", [[[1, 2], [3]]], "polygon 0: vertex 0.x is [1, 2]: a coordinate must be a real number"),
    ("boxes", np.ma.masked_equal(np.array([BOX] * 3), 2), "corners has masked entries: fill or drop them first"),
    ("boxes", np.ma.masked_equal(np.array([FIVE] * 3), 4), "corners has masked entries: fill or drop them first"),
    ("boxes", np.array([BOX] * 3, complex), "corners is an array of complex128: coordinates must be real numbers"),
    ("boxes", np.array([BOX] * 3) > 1, "corners is an array of bool: coordinates must be real numbers"),
    ("boxes", [[[True, False]] * 4] * 3, "polygon 0: vertex 0.x is True: "),
    ("boxes", np.array([BOX, BOX, [(0, 0), (4, 0), (1, 1), (0, 4)]]), "polygon 2 is not convex with these coordinates, "
     "so nothing was moved"),
    ("boxes", [BOX, BOX, BOX[[0, 2, 1, 3]]], "polygon 2: edges 0 and 2 cross near"),
]  # fmt: skip


@pytest.mark.parametrize(("kind", "corners", "said"), REFUSED, ids=range(len(REFUSED)))
def test_coordinates_of_another_form_or_topology_are_refused_and_nothing_moves(kind, corners, said, made_by):
    shapes = MADE[kind]()
    kept = shapes.rings, shapes.radius, shapes.bounds.tolist()
    for moved in range(2):
        with pytest.raises(sv.InvalidShape) as error:
            batch.move(shapes, corners)
        assert str(error.value).startswith(said)
        assert shapes.bounds.tolist() == kept[2] and (moved or shapes.rings is kept[0])
        batch.move(shapes, corners_of(shapes))


@pytest.mark.parametrize("kind", ["boxes", "five corners", "circles"])
def test_numbers_in_lists_of_outlines_are_checked_as_in_single_shapes(kind, made_by):
    """One array of them all would hide what is masked, take True for 1 and round integers beyond 2**53."""
    rings = MADE[kind]()
    first, n, v = corners_of(rings).tolist(), len(rings), int(rings.count[0])
    name = "circle 1: center" if v == 1 else f"polygon 1: vertex {v - 1}"
    for bad, said in (True, "True"), (2**53 + 1, "9007199254740993"), (np.nan, "nan"), ("1", "'1'"):
        wrong = [[list(p) for p in first[i * v : i * v + v]] for i in range(n)]
        wrong[1][-1][0] = bad
        for form in wrong, tuple(wrong), iter(wrong):
            with pytest.raises(sv.InvalidShape) as error:
                batch.move(MADE[kind](), form)
            assert str(error.value).startswith(f"{name}.x is {said}")
    masked = [np.ma.array(first[i * v : i * v + v], mask=np.zeros((v, 2))) for i in range(n)]
    assert batch.move(MADE[kind](), masked).bounds.tolist() == rings.bounds.tolist()  # nothing is hidden
    masked[1][v - 1, 1] = np.ma.masked
    for form in masked, tuple(masked), [list(ring) for ring in masked]:
        with pytest.raises(sv.InvalidShape, match="masked"):
            batch.move(MADE[kind](), form)


def test_a_coordinate_that_is_not_finite_is_named_by_its_shape(made_by):
    for kind in "boxes", "polygons", "circles", "circles and polygons":
        shapes = MADE[kind]()
        corners, start = corners_of(shapes), shapes.rings.start
        for bad in np.nan, np.inf:
            for k, axis in np.ndindex(corners.shape):
                wrong = corners.copy()
                wrong[k, axis] = bad
                i = np.searchsorted(start, k, side="right") - 1
                name = f"circle {i}: center" if shapes.radius[i] else f"polygon {i}: vertex {k - start[i]}"
                for form in wrong, wrong.tolist(), np.asfortranarray(wrong):
                    with pytest.raises(sv.InvalidShape) as error:
                        batch.move(shapes, form)
                    assert str(error.value) == f"{name}.{'xy'[axis]} is {bad}: numbers must be finite"
        beyond = np.concatenate([corners, [[bad, 0]]])
        with pytest.raises(sv.InvalidShape, match=f"^corner {len(corners)}.x is {bad}: numbers must be finite$"):
            batch.move(shapes, beyond)


def test_a_corner_that_becomes_straight_for_once_is_back_in_the_next_place(made_by):
    shapes = MADE["boxes"]()
    first = corners_of(shapes)
    flat = first.copy()
    flat[1] = (flat[0] + flat[2]) / 2
    assert batch.move(shapes, flat).count.tolist() == [3, 4, 4]
    assert batch.move(shapes, first).count.tolist() == [4, 4, 4]


@pytest.mark.parametrize("kind", MADE)
def test_a_place_is_computed_from_the_first_outlines_each_time(kind, made_by):
    shapes, n = MADE[kind](), len(MADE[kind]())
    first, many, at = corners_of(shapes), np.diff(shapes.rings.start), np.arange(2.0 * n).reshape(n, 2) * 3 - 4
    angles = np.linspace(0.1, 6, n)
    x, y = first.T
    for k in range(3):
        if k == 1:
            batch.move(shapes, first * 2)
        for given in ({}, {"angles": 0.5}, {"angles": [0.5]}, {"angles": angles}, {"angles": angles.tolist()}):
            if np.shape(given.get("angles", 0.0)) not in ((), (1,), (n,)):
                continue
            turn = np.repeat(np.broadcast_to(given.get("angles", 0.0), n), many)
            right = np.repeat(at, many, axis=0) + np.stack(
                [np.cos(turn) * x - np.sin(turn) * y, np.sin(turn) * x + np.cos(turn) * y], axis=1
            )
            for offsets in at, at.tolist():
                assert batch.place(shapes, offsets, **given) is shapes
                assert corners_of(shapes).tolist() == (right + 0.0).tolist()


HOW_MANY = "give 3 offsets, and 3 angles or one"
PLACES = [
    (np.zeros((2, 2)), 0.0, "there are 2 offsets and 1 angles for 3 shapes: " + HOW_MANY),
    (np.zeros((4, 2)), 0.0, "there are 4 offsets and 1 angles for 3 shapes: " + HOW_MANY),
    (np.zeros((3, 2)), [1.0, 2.0], "there are 3 offsets and 2 angles for 3 shapes: " + HOW_MANY),
    (np.zeros((1, 2)), [1.0, 2.0, 3.0], "there are 1 offsets and 3 angles for 3 shapes: " + HOW_MANY),
    (np.zeros((3, 2)), np.zeros((3, 1)), "there are 3 offsets and 3 angles for 3 shapes: " + HOW_MANY),
    (np.array([[0, 0], [np.nan, 1], [0, 0]]), 0.0, "offset 1.x is nan: numbers must be finite"),
    (np.zeros((3, 2)), [0, np.inf, 0], "angle 1 is inf: numbers must be finite"),
    (np.zeros((3, 2)), np.nan, "angle is nan: numbers must be finite"),
    (np.zeros(2), 0.0, "offsets has the shape (2,): expected (N, 2)"),
    (3, 0.0, "offsets is 3: expected a sequence"),
    (np.full((3, 2), 1e300), 0.0, "polygon 0: 1 distinct vertices: a polygon needs at least 3 (its "
     "moved coordinates are rounded to floats; move it elsewhere)"),
]  # fmt: skip


@pytest.mark.parametrize(("offsets", "angles", "said"), PLACES, ids=range(len(PLACES)))
def test_places_that_do_not_fit_are_refused_in_one_line(offsets, angles, said, made_by):
    shapes = MADE["boxes"]()
    before = shapes.bounds.tolist()
    with pytest.raises(sv.InvalidShape) as error:
        batch.place(shapes, offsets, angles)
    assert str(error.value) == said and shapes.bounds.tolist() == before


def test_a_batch_with_split_polygons_and_a_list_are_not_moved():
    ell = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]
    parts = batch.Polygons([ell], concave="split")
    for function, given in (batch.move, np.zeros((6, 2))), (batch.place, np.zeros((1, 2))):
        with pytest.raises(TypeError, match="shapes is a list"):
            function([ell], given)
        with pytest.raises(sv.InvalidShape, match="split concave polygons cannot be moved"):
            function(parts, given)


def test_moving_warns_where_the_processor_flushes_subnormal_numbers_to_zero(monkeypatch, made_by):
    for kind in MADE:
        shapes = MADE[kind]()
        corners = corners_of(shapes)
        with monkeypatch.context() as patch:
            patch.setattr(predicates, "MIN_FLOAT", 0.0)
            with pytest.warns(RuntimeWarning, match="answers are exact only if"):
                batch.move(shapes, corners)


def test_moving_to_valid_coordinates_skips_the_slow_checks(made_by, monkeypatch):
    """Slower checks take several times as long for each frame."""
    monkeypatch.setattr(moving, "_checked", lambda *_: pytest.fail("not certified"))
    alike = "boxes", "one triangle", "five corners", "eight corners"
    for kind in alike if made_by == "numpy" else [*MADE][:-1]:
        shapes = MADE[kind]()
        corners = corners_of(shapes)
        for _ in range(2):
            batch.move(shapes, corners + 1)
            if kind in alike:
                batch.move(shapes, corners.reshape(len(shapes), -1, 2) + 1)
        assert np.array_equal(corners_of(shapes), corners + 1) and set(numbers) == {len(corners)}
        numbers.clear()
