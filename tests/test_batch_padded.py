"""Circles and polygons in padded arrays, and hostile scenes that are made anew, moved and placed.

What is expected comes from rationals: `oracle.relation`, pair by pair.
"""

from itertools import combinations, pairwise

import numpy as np
import pytest
from batches import ENGINES, RNG, kernels_of
from oracle import relation
from test_batch_few import SCENES, hulls

import satviz as sv
from satviz import batch
from satviz.batch import constructors, engines

TRIANGLE = np.array([(0.0, 0), (4, 0), (1, 3)])


@pytest.fixture(params=ENGINES)
def made_by(request, monkeypatch):
    """Let one engine make all batches."""
    if request.param == "numba":
        kernels_of("outlines")
    engine = engines.engine_of(request.param)
    monkeypatch.setattr(constructors, "engine_for_checks", lambda _: engine)
    return request.param


def padded(shapes, rng):
    """Return (corners, counts, radii) of outlines and (center, radius) pairs; other numbers follow the last corner."""
    rings = [np.array(s[0] if isinstance(s, tuple) else s, float).reshape(-1, 2) for s in shapes]
    counts = np.array([len(ring) for ring in rings], np.intp)
    corners = rng.choice([np.nan, np.inf, 0.0, 7.0, 1e300], (len(rings), max([1, *counts]), 2))
    for i, ring in enumerate(rings):
        corners[i, : len(ring)] = ring
    return corners, counts, np.array([s[1] if isinstance(s, tuple) else 0.0 for s in shapes], float)


def shapes_of(made):
    """Return the shapes of a batch one by one, from its own arrays."""
    x, y, start = made.rings
    rings = [list(zip(x[i:j].tolist(), y[i:j].tolist())) for i, j in pairwise(start.tolist())]
    return [sv.Circle(ring[0], r) if r else sv.Polygon(ring) for ring, r in zip(rings, made.radius.tolist())]


def colliding(shapes):
    """Return the pairs i < j that share a point, in rationals."""
    pairs = combinations(range(len(shapes)), 2)
    return [[i, j] for i, j in pairs if relation(shapes[i], shapes[j]) is not sv.Relation.APART]


def odd_ones(rng):
    """Return shapes of every size beside each other, many of which touch: outlines and (center, radius) pairs."""
    polygons = [ring for ring, _ in zip(hulls(rng, [3, 4, 5, 8], 12), range(5))]
    coins = [((12.0 * k, 0.0), 6.0) for k in range(3)]  # each touches the next one
    some = [*polygons, *coins, ((0.0, 0.0), 5e-324), ((6.0, 0.0), 2.0**-30)]
    match rng.integers(5):
        case 0:
            some.append(np.array([(-(2.0**40), -(2.0**40)), (2.0**40, -(2.0**40)), (2.0**40, 0), (-(2.0**40), 0)]))
        case 1:
            some.append(polygons[0] + 1e12)
        case 2:
            some += [np.array([(0.0, 0), (2.0**k, 0), (2.0**k, 2.0**k), (0, 2.0**k)]) for k in range(0, 21, 4)]
        case 3:
            some.append(((0.0, -(2.0**20)), 2.0**20))
        case 4:
            some.append(TRIANGLE * 2.0**-30)
    return [some[k] for k in rng.permutation(len(some))]


@pytest.mark.parametrize("scale", [-300, 0, 300])
def test_hostile_scenes_collide_as_in_rationals_made_anew_moved_and_placed(made_by, scale):
    rng = RNG([7, scale + 300])
    for _ in range(3):
        shapes = [
            (np.array(s[0]) * 2.0**scale, max(s[1] * 2.0**scale, 5e-324)) if isinstance(s, tuple) else s * 2.0**scale
            for s in odd_ones(rng)
        ]
        made = batch.from_padded(*padded(shapes, rng))
        right = colliding(shapes_of(made))
        corners = np.concatenate([np.array(s[0] if isinstance(s, tuple) else s).reshape(-1, 2) for s in shapes])
        n = len(shapes)
        for engine in ENGINES:
            assert batch.colliding_pairs(made, engine=engine).tolist() == right
        batch.move(made, corners[:, ::-1].copy() * [1, -1])  # turned by a quarter
        for engine in ENGINES:
            assert batch.colliding_pairs(made, engine=engine).tolist() == right
        batch.place(made, rng.uniform(-3, 3, (n, 2)) * 2.0**scale, rng.uniform(0, 6, n))
        own = colliding(shapes_of(made))
        for engine in ENGINES:
            assert batch.colliding_pairs(made, engine=engine).tolist() == own
        batch.move(made, corners)
        for engine in ENGINES:
            assert batch.colliding_pairs(made, engine=engine).tolist() == right


@pytest.mark.parametrize("kind", ["mixed", "circles", "circles and polygons", "triangles"])
def test_padded_arrays_make_the_batch_that_their_shapes_make(kind, made_by):
    rng = RNG(len(kind))
    for n in 0, 1, 2, 9:
        shapes = SCENES[kind](rng, n, 6)
        shapes = [  # either way round, and with repeated corners
            s if isinstance(s, tuple) else np.repeat(s, rng.integers(1, 3, len(s)), axis=0)[:: rng.choice([1, -1])]
            for s in shapes
        ]
        corners, counts, radii = padded(shapes, rng)
        single = [sv.Circle(*s) if isinstance(s, tuple) else sv.Polygon(s) for s in shapes]
        forms = [(corners, counts, radii), (np.asfortranarray(corners), counts.tolist(), radii.tolist())]
        frozen = corners.copy()
        frozen.flags.writeable = False
        for given in [*forms, (frozen, counts.astype(np.uint8), radii)]:
            made = batch.from_padded(*given)
            assert len(made) == n and made.owner is None
            assert made.radius.tolist() == radii.tolist() and not np.shares_memory(made.radius, radii)
            assert not np.shares_memory(made.rings.x, given[0])
            assert np.array_equal(made.bounds, [s.bounds for s in single] or np.empty((0, 4)))
            assert made.count.tolist() == [1 if isinstance(s, sv.Circle) else len(s.core) for s in single]
        if n:
            assert repr(made) == repr(batch.from_padded(*forms[0]))


def test_few_shapes_where_squares_lose_bits_or_overflow_collide_as_in_rationals():
    rng, tiny, d = RNG(11), 4.376 * 2.0**-537, 2.0**-330
    small = np.array(
        [(-tiny, 0), (tiny, 0), (0, -tiny)]
    )  # the square of its edge, 76.6 smallest floats, is rounded to 77
    wide = np.array([(-0.55, 0), (0.55, 0), (0, -0.5)]) * 2.0**512  # the square of its edge overflows, its reach's not
    scenes = [[small, ((0.0, d), d * (1 + sign * 2.0**-10))] for sign in (-1, 1)]
    scenes += [[wide, ((0.0, 0.3 * 2.0**512), r * 2.0**512)] for r in (0.1, 0.31)]
    cut = np.array([(0, 0), (1e-200, 0), (1e-100, 1e-100), (-1e-100, 1e-100)])  # turns about its short edge vanish
    scenes += [[cut, ((0.0, y), r)] for y in (1e-101, -1e-101, 5e-101) for r in (1e-103, 1e-120)]
    others = batch.Polygons([TRIANGLE + 2**20] * 60)
    for shapes in scenes:
        made = batch.from_padded(*padded(shapes, rng))
        right = colliding(shapes_of(made))
        many = batch.concat([made, others, others[:20], others])  # all with all by boxes, or a sweep
        for form in made, batch.concat([made, others]), many:
            found = batch.colliding_pairs(form, engine="numpy")
            assert found[found.max(axis=1) < 2].tolist() == right


def test_a_circle_near_a_triangle_at_every_scale_is_related_as_alone():
    rng, shapes, right = RNG(3), np.array([(-3.0, 0), (3, 0), (0, -4)]), []
    for e in range(-1073, 1015, 23):
        ring, center = shapes * 2.0**e, np.array([rng.uniform(-4, 4), rng.uniform(0.5, 3)]) * 2.0**e
        radius = max(5e-324, center[1] * (1 + rng.choice([-1, 0, 1]) * 2.0 ** -rng.integers(1, 45)))
        made = batch.from_padded(*padded([ring, (center, radius)], rng))
        right.append(sv.relate(*shapes_of(made)) != sv.Relation.APART)
        assert len(batch.colliding_pairs(made, engine="numpy")) == right[-1], e
    assert 0 < sum(right) < len(right)


FAULTS = {
    "a circle without a radius": (2, 1, 0.0, "shape 2 has 1 corners and the radius 0.0"),
    "a negative radius": (2, 1, -1.0, "shape 2 has 1 corners and the radius -1.0"),
    "a radius that is none": (2, 1, np.nan, "shape 2: radius is nan"),
    "an infinite radius": (2, 1, np.inf, "shape 2: radius is inf"),
    "a polygon with a radius": (2, 3, 1.0, "shape 2 has 3 corners and the radius 1.0"),
    "a polygon with a negative radius": (2, 3, -0.5, "shape 2 has 3 corners and the radius -0.5"),
    "no corner": (2, 0, 0.0, "shape 2 has 0 corners"),
    "too many corners": (2, 5, 0.0, "shape 2 has 5 corners"),
    "two corners": (2, 2, 0.0, "polygon 2: .*distinct"),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_faults_of_padded_arrays_name_the_shape(fault, made_by):
    i, count, radius, said = FAULTS[fault]
    corners, counts, radii = padded([TRIANGLE, ((1, 1), 1.0), TRIANGLE, np.append(TRIANGLE, [(0, 3)], axis=0)], RNG(1))
    counts[i], radii[i] = count, radius
    with pytest.raises(sv.InvalidShape, match=f"^{said}"):
        batch.from_padded(corners, counts, radii)


def test_coordinates_shapes_and_types_of_padded_arrays_are_checked(made_by):
    dart = np.array([(0.0, 0), (4, 0), (1, 1), (0, 4)])
    corners, counts, radii = padded([dart + 9, ((1, 1), 1.0)], RNG(1))
    with pytest.raises(sv.InvalidShape, match=r"^polygon 0 is not convex: split it with satviz.parts first$"):
        batch.from_padded(corners, counts, radii)
    turns = 4 * np.pi / 5 * np.arange(5)  # a star turns to one side at all corners, and goes round twice
    with pytest.raises(sv.InvalidShape, match=r"^polygon 0: edges . and . cross"):
        batch.from_padded(*padded([np.stack([np.cos(turns), np.sin(turns)], axis=1), ((1, 1), 1.0)], RNG(1)))
    corners, counts, radii = padded([TRIANGLE, ((1, 1), 1.0)], RNG(1))
    for at, said in ((0, 2, 1), "polygon 0: vertex 2.y is nan"), ((1, 0, 0), "circle 1: center.x is nan"):
        wrong = corners.copy()
        wrong[at] = np.nan
        with pytest.raises(sv.InvalidShape, match=said):
            batch.from_padded(wrong, counts, radii)
    for wrong in (
        (corners.tolist(), counts, radii),
        (corners[0], counts, radii),
        (corners, counts[:1], radii),
        (corners, counts, radii[:1]),
        (corners, counts, 1.0),
        (corners, counts * 1.0, radii),
        (corners, counts > 1, radii),
        (corners, np.ma.masked_equal(counts, 1), radii),
        (np.ma.masked_equal(corners, 4), counts, radii),
        (corners, counts, np.ma.masked_equal(radii, 1)),
        (corners.astype(complex), counts, radii),
    ):
        with pytest.raises(sv.InvalidShape):
            batch.from_padded(*wrong)


def test_a_pose_that_is_refused_leaves_the_batch_as_it_was(made_by):
    flat = np.array([(0.0, 0), (2, -(2.0**-40)), (4, 0), (2, 3)])  # a corner that rounding straightens or bends inwards
    made = batch.from_padded(*padded([flat, ((0, 0), 1.0), TRIANGLE], RNG(1)))
    before, right = [c.tolist() for c in made.rings], colliding(shapes_of(made))
    for bend in 2.0**-40, 1.0:
        corners = np.array([(0.0, 0), (2, bend), (4, 0), (2, 3), (0, 0), *TRIANGLE])
        with pytest.raises(sv.InvalidShape, match="polygon 0 is not convex with these coordinates"):
            batch.move(made, corners)
        assert [c.tolist() for c in made.rings] == before
        for engine in ENGINES:
            assert batch.colliding_pairs(made, engine=engine).tolist() == right
    with pytest.raises(sv.InvalidShape, match="rounded to floats"):
        batch.place(made, np.full((3, 2), 2.0**60))
    assert [c.tolist() for c in made.rings] == before
