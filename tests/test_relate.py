"""Tests of `relate`: against the oracle, under exact transforms, and at the error bounds of its filters."""

import math
import sys
from collections import Counter
from collections.abc import Callable
from contextlib import suppress
from fractions import Fraction
from random import Random
from types import SimpleNamespace

import pytest
import shapely
from adversary import BOUNDS, near_edge_line, search
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from oracle import relation, squared_distance
from strategies import (
    BASIC,
    CONVEX,
    KINDS,
    NotConvex,
    convex,
    dress,
    hull,
    nudged,
    pairs,
    random_circles,
    random_polygons,
    round_ring,
    scaled,
    spun,
)

from satviz.engine import relate as relate_module
from satviz.engine.geometry import InvalidShape, Relation, Vec
from satviz.engine.predicates import to_common_unit
from satviz.engine.relate import relate, relate_integers, relate_moved
from satviz.engine.shapes import Circle, Polygon, Shape
from satviz.engine.trace import record
from satviz.study import truth as oracle


def recorded(a: Shape, b: Shape) -> Relation:
    """Return the relation that the recorded tests alone claim."""
    return record(a, b).claim


METHODS: list[Callable[[Shape, Shape], Relation]] = [relate, recorded]  # each gives the relation of two shapes

APART, TOUCHING, OVERLAPPING = Relation
U = 2.0**-53

every_method = pytest.mark.parametrize("method", METHODS, ids=lambda method: method.__name__)


# -- hostile pairs ---------------------------------------------------------------------------------


@pytest.mark.parametrize("kind", KINDS)
def test_relate_and_its_integer_path_are_right_for_pairs_of_every_kind_in_both_orders(kind):
    for _, a, b in pairs(13, 40, [kind]):
        for first, second in ((a, b), (b, a)):
            assert relate(first, second) is relation(a, b), (first, second)
            if kind in CONVEX:
                assert relate_integers(*to_common_unit(first, second)[:3]) is relation(a, b), (first, second)


@pytest.mark.parametrize("place", [(50, 0), (0, 50), (-50, 0), (0, -50), (50, -50), (2**20, 2**20 + 1)], ids=str)
def test_relate_is_right_at_every_place(place):
    rng = Random(16)
    for _ in range(60):
        p, q, x, y = (rng.randint(-4, 4) for _ in range(4))
        tilted = Polygon(spun([(0, 0), (3, 0), (3, 1), (0, 1)], p, q or 5))
        other = Polygon([(x, y), (x + 3, y + rng.randint(-2, 1)), (x, y + 2)])
        a, b = (mapped(shape, lambda u, v: (u + place[0], v + place[1])) for shape in (tilted, other))
        assert relate(a, b) is relate(b, a) is relation(tilted, other), (a, b)


def bowl(half: int) -> list[tuple[int, int]]:
    """Return a convex ring of 2 * half + 1 corners, the lowest at the origin."""
    return [(x, x * x) for x in range(-half, half + 1)]


@pytest.mark.parametrize("half", [7, 8, 20])
@pytest.mark.parametrize("way", [(1, 0), (0, 1), (-1, 0), (0, -1), (3, 4), (-12, 5)], ids=str)
@pytest.mark.parametrize("place", [(0, 0), (900, 0), (0, 900), (-900, 900)], ids=str)
def test_a_corner_that_only_touches_is_not_classified_as_inside_among_many_corners(half, way, place):
    rng = Random(str((half, way, place)))
    box, diamond = [(-500, -200), (500, -200), (500, 0), (-500, 0)], [(0, 0), (-300, -300), (0, -600), (300, -300)]
    for below in (box, diamond, [(x, -y) for x, y in bowl(half)]):
        for gap, truth in ((2.0**-40, APART), (0, TOUCHING), (-(2.0**-40), OVERLAPPING)) * 2:
            above = [(x, y + gap) for x, y in bowl(half)]
            firsts = [rng.randrange(len(ring)) for ring in (above, below)]
            rings = (ring[first:] + ring[:first] for ring, first in zip((above, below), firsts, strict=True))
            a, b = (Polygon([(x + place[0], y + place[1]) for x, y in spun(ring, *way)]) for ring in rings)
            assert relate(a, b) is relate(b, a) is truth


def steps_of_relate(a: Shape, b: Shape) -> int:
    """Return how many lines of `relate` are executed for a pair."""
    steps = 0

    def count(frame, *_):
        nonlocal steps
        steps += frame.f_code.co_filename == relate_module.__file__
        return count

    before = sys.gettrace()
    sys.settrace(count)
    try:
        relate(a, b)
    finally:
        sys.settrace(before)
    return steps


@pytest.mark.parametrize("apart", [0.5, 1.2, 1.9])
@pytest.mark.parametrize("corners", [32, 128])
def test_two_overlapping_round_shapes_take_few_steps_for_each_corner(corners, apart):
    turns = [math.tau * i / corners for i in range(corners)]
    for way in range(12):
        x, y = way - 6 + apart * math.cos(way), 3 + apart * math.sin(way)
        a, b = (Polygon([(u + math.cos(t), v + math.sin(t)) for t in turns]) for u, v in ((way - 6, 3), (x, y)))
        assert relate(a, b) is OVERLAPPING
        assert steps_of_relate(a, b) < 6 * corners > steps_of_relate(b, a)


@pytest.mark.parametrize(("size", "steps"), [(1, 9), (8, 17)])
def test_two_round_shapes_that_are_barely_apart_take_few_steps_for_each_corner(size, steps):
    turns = [math.tau * i / 128 for i in range(128)]
    for way in range(12):
        x, y = ((1.05 + size) * u for u in (math.cos(way), math.sin(way)))
        a = Polygon([(math.cos(t), math.sin(t)) for t in turns])
        b = Polygon([(x + size * math.cos(t), y + size * math.sin(t)) for t in turns])
        assert relate(a, b) is APART
        assert steps_of_relate(a, b) < steps * 128 > steps_of_relate(b, a)


def test_a_point_on_edges_of_both_shapes_is_inside_neither_for_every_first_corner():
    ring = [(3, 1), (1, 3), (-1, 3), (-3, 1), (-3, -1), (-1, -3), (1, -3), (3, -1)]
    rings = [ring[i:] + ring[:i] for i in range(8)]
    for i, (x, y) in enumerate(ring):
        u, v = ring[i - 1]
        for to in ((x + u, y + v), (2 * x, 2 * y)):  # edge on edge, corner on corner
            for part, truth in ((1 + 2.0**-40, APART), (1, TOUCHING), (1 - 2.0**-40, OVERLAPPING)):
                moved = [Polygon([(px + part * to[0], py + part * to[1]) for px, py in r]) for r in rings]
                assert {relate(a, b) for a in map(Polygon, rings) for b in moved} == {truth}


@pytest.mark.parametrize("e", [-500, -520, -532, -535, -536, -537, -538, -539, -545, -1000])
def test_a_circle_over_an_edge_whose_squared_length_loses_bits_is_decided_by_its_distance(e):
    for turn in ((1, 0), (0, 1), (-1, 0), (3, 4)):
        for half in (1.25, 1.375):
            center, *ring = spun(
                [(math.ldexp(0.25, e), 1), (math.ldexp(half, e), 0), (math.ldexp(-half, e), 0), (-1, -1), (1, -1)],
                *turn,
            )
            for part in (0.9, 1 - 2**-10, 1, 1 + 2**-10, 1.1):
                a, b = Polygon(ring), Circle(center, math.hypot(*turn) * part)
                assert relate(a, b) is relate(b, a) is oracle.relation(a, b)


@pytest.mark.parametrize(
    ("ring", "center"),
    [
        (
            [(0, 0), (0.49999999999999994, 0.4999999999999999), (0.9999999999999999, 1), (-1, 1)],
            (0.5000610351562447, 0.5000610351562553),
        ),
        (
            [(1, 1), (0.8676583247269447, 0.49999999999999994), (0.73531664945389, -2.642869071527393e-17), (1.1, 0.7)],
            (0.869235614715032, 0.5059591583106026),
        ),
    ],
)
def test_a_center_inside_is_not_classified_as_outside_beside_two_nearly_collinear_edges(ring, center):
    """Floats place the center inside the edge below it, and on the line through the neighboring edge, which is far."""
    assert relate(Polygon(ring), Circle(center, 1e-40)) is OVERLAPPING


def test_a_tiny_circle_within_rounding_of_an_edge_is_on_the_right_side():
    rng, seen = Random(17), Counter()
    for _ in range(500):
        px, py, qx, qy, x, y = near_edge_line(rng)
        try:
            triangle = Polygon([(px, py), (qx, qy), (px + py - qy, py + qx - px)])
        except InvalidShape:
            continue
        dot = Circle((nudged(x, rng.randint(-3, 3)), y), 2.0 ** rng.choice((-30, -60, -200)))
        seen[truth := oracle.relation(triangle, dot)] += 1
        assert relate(triangle, dot) is relate(dot, triangle) is truth, (triangle, dot)
    assert seen[APART] > 50 < seen[OVERLAPPING]


@pytest.mark.parametrize("far", [0, 9])
def test_shapes_of_other_libraries_are_refused_at_every_place(far):
    other, ours = SimpleNamespace(bounds=(far, far, far + 1, far + 1)), Polygon([(0, 0), (2, 0), (0, 2)])
    for a, b in ((other, ours), (ours, other), (other, Circle((0, 0), 1))):
        with pytest.raises(TypeError, match=r"make it a satviz\.Polygon"):
            relate(a, b)


def test_integers_detect_that_an_edge_is_nearer_than_its_end_by_one_unit():
    """Both ends of the edge are on the circle or beyond it, and the foot is one unit from an end."""
    circle, triangle = Circle((0, 0), 5), Polygon([(3, 4), (4, 3), (9, 9)])
    assert relate_integers(*to_common_unit(circle, triangle)[:3]) is relation(circle, triangle) is OVERLAPPING


def test_integers_detect_that_a_center_is_inside_by_one_unit():
    hardly, ring = (
        Circle((0, 0), 1),
        Polygon([(-9, -2), (1, 0), (5, 1), (-2, 9)]),
    )  # left of the second edge's line by 1
    assert relate_integers(*to_common_unit(hardly, ring)[:3]) is relation(hardly, ring) is OVERLAPPING


def test_an_error_inside_a_shape_is_passed_on():
    with pytest.raises(AttributeError, match="slabs"):
        relate(Circle((0, 0), 1), object.__new__(Polygon))


@pytest.mark.parametrize(
    "grains", [(0, 0, 0), (5, 0, 0), (0, 5, 0), (0, 0, 5), (20, 3, 9), (3, 9, 20), (9, 20, 3)], ids=str
)
def test_a_moved_shape_is_tested_at_its_new_place(grains):
    """Each of a, b and the move has the finest coordinates in some case."""
    rng = Random(14)

    def whole(grain: int) -> float:
        return rng.randint(-12, 12) + rng.choice((0, rng.randint(-1, 1) * 2.0**-grain))

    for _ in range(60):
        (ax, ay), (bx, by), move = (Vec(whole(grain), whole(grain)) for grain in grains)
        a = rng.choice((Circle((ax, ay), 5), Polygon([(ax, ay), (ax + 8, ay), (ax, ay + 8)])))
        b = rng.choice((Circle((bx, by), 5), Polygon([(bx, by), (bx + 3, by), (bx, by + 4)])))
        assert relate_moved(a, b, move) is relation(a, mapped(b, lambda x, y, by=move: (x + by.x, y + by.y)))


@pytest.mark.parametrize("hair", [2.0**-60, 2.0**-700, 5e-324])
def test_a_move_smaller_than_the_spacing_of_the_coordinates_changes_the_relation(hair):
    for touching in (Circle((9, 4), 1), Polygon([(8, 0), (9, 0), (8, 9)])):
        for way, truth in ((1, APART), (0, TOUCHING), (-1, OVERLAPPING)):
            box = Polygon([(0, 0), (8, 0), (8, 8), (0, 8)])
            assert relate_moved(box, touching, Vec(way * hair, 0.0)) is truth
            assert relate_moved(touching, box, Vec(-way * hair, 0.0)) is truth


# -- where products lose bits or overflow ----------------------------------------------------------


@pytest.mark.parametrize("power", [-545, -537, -530, -515, -490, 470, 485, 500, 505, 508, 509, 510, 511, 512])
def test_relate_is_never_wrong_where_products_lose_bits_or_overflow(power):
    rng = Random(power)
    known = []
    while len(known) < 80:
        try:
            known.append(tuple(scaled(shape, power) for shape in rng.choice(BASIC)(rng)))
        except (InvalidShape, NotConvex, OverflowError):
            continue
    assert [(a, b) for a, b in known if relate(a, b) is not oracle.relation(a, b)] == []


@pytest.mark.parametrize("size", [1e100, 1e160, 1e200, 1e280, 1e300])
def test_a_small_triangle_is_apart_from_a_huge_one_where_only_an_edge_of_the_huge_one_separates_them(size):
    small = Polygon([(-1, 0.5), (-3, 0.5), (-3, -5)])
    for first in range(3):
        huge = [(0, 0), (size, size), (-size, size)]
        huge = Polygon(huge[first:] + huge[:first])
        assert relate(small, huge) is relate(huge, small) is oracle.relation(small, huge) is APART


@pytest.mark.parametrize(
    ("larger", "power"),
    [
        (700, -100),
        (700, 100),
        (550, 0),
        (550, 200),
        (450, 200),
        (350, 300),
        (250, 300),
        (150, -600),
        (60, -550),
        (250, -700),
    ],
)
def test_relate_is_right_for_shapes_of_very_different_size_where_only_products_of_one_overflow(larger, power):
    rng = Random(18)

    def corner(power: int) -> tuple[float, float]:
        return math.ldexp(rng.randint(-4, 4), power), math.ldexp(rng.randint(-4, 4), power)

    for _ in range(150):
        with suppress(InvalidShape):
            a = Polygon([corner(power) for _ in range(3)])
            b = Polygon([corner(power), corner(power + larger), corner(power + larger)])
            assert relate(a, b) is relate(b, a) is oracle.relation(a, b), (a, b)


@pytest.mark.parametrize("aside", [2.0**-4, 2.0**-20])
def test_a_circle_beside_a_long_edge_is_right_at_the_size_where_products_begin_to_overflow(aside):
    for step in range(96):
        size = 2.0**510 * (1 + step / 32)
        half = Polygon([(-size, -size), (size, size), (-size, size)])
        for part, truth in ((0.99, APART), (1.0, APART), (1.5, OVERLAPPING)):  # of d, where sqrt(2) * d touches
            circle = Circle((size * aside, -size * aside), size * aside * part)
            assert relate(half, circle) is relate(circle, half) is oracle.relation(half, circle) is truth


@pytest.mark.parametrize("way", [(1, 0), (0, 1), (-1, 0), (0, -1)], ids=str)
@pytest.mark.parametrize("place", [0, 2.0**520])
def test_a_circle_at_the_tip_of_a_needle_whose_squared_length_overflows_is_decided_by_the_tip(way, place):
    far = 2.0**520
    needle = [(-place, 0.0), (far - place, -1.0), (far - place, 0.0)]
    for radius, truth in ((1, APART), (1.4, APART), (1.6, OVERLAPPING)):
        ((x, y),) = spun([(-place, -1.5)], *way)
        a, b = Polygon(spun(needle, *way)), Circle((x, y), radius)
        assert relate(a, b) is relate(b, a) is oracle.relation(a, b) is truth


# -- the oracle ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("a", "b", "truth"),
    [
        (Polygon([(0, 0), (1, 0), (0, 1)]), Polygon([(1, 0), (2, 0), (1, 1)]), TOUCHING),
        (Polygon([(0, 0), (1, 0), (0, 1)]), Polygon([(1, 1), (2, 1), (1, 2)]), APART),
        (Polygon([(0, 0), (2, 0), (0, 2)]), Polygon([(1, 1), (2, 1), (1, 2)]), TOUCHING),
        (Polygon([(0, 0), (2, 0), (0, 2)]), Polygon([(0.5, 0.5), (2, 1), (1, 2)]), OVERLAPPING),
        (Polygon([(0, 0), (9, 0), (9, 9), (0, 9)]), Polygon([(1, 1), (2, 1), (1, 2)]), OVERLAPPING),
        (Polygon([(0, 0), (9, 0), (9, 9), (0, 9)]), Polygon([(0, 0), (0, 9), (9, 9), (9, 0)]), OVERLAPPING),
        (Polygon([(0, 0), (9, 0), (9, 9), (0, 9)]), Polygon([(4, -4), (5, -4), (5, 99), (4, 99)]), OVERLAPPING),
        (Circle((0, 0), 2), Circle((3, 4), 3), TOUCHING),
        (Circle((0, 0), 1), Circle((0, 0), 1), OVERLAPPING),
        (Circle((0, 0), 9), Circle((1, 0), 8), OVERLAPPING),  # touches from within
        (Circle((0, 0), 5), Polygon([(3, 4), (9, 4), (9, 9)]), TOUCHING),
        (Circle((0, 0), 4), Polygon([(4, -9), (9, 0), (4, 9)]), TOUCHING),
        (Circle((0, 0), 1.4), Polygon([(1, 1), (9, 1), (1, 9)]), APART),  # off a corner: no edge clears it
        (Circle((3, 3), 1), Polygon([(0, 0), (99, 0), (0, 99)]), OVERLAPPING),
        (Circle((3, 3), 999), Polygon([(0, 0), (9, 0), (0, 9)]), OVERLAPPING),
        (Circle((0, 4.5), 1), Polygon([(0, 0), (9, 0), (0, 9)]), OVERLAPPING),  # the center on an edge
    ],
)
def test_known_answers_of_the_oracle_and_of_relate(a, b, truth):
    assert oracle.relation(a, b) is oracle.relation(b, a) is truth
    for method in METHODS:
        assert method(a, b) is method(b, a) is truth


@every_method
@pytest.mark.parametrize("power", [-500, 0, 440])
@pytest.mark.parametrize("way", [(1, 0), (3, 4), (-5, 12), (-1, -1)], ids=str)
def test_a_circle_off_the_tip_of_a_needle_is_decided_by_its_distance_from_the_tip(method, way, power):
    """The thinnest needles are so thin that floats certify the side of no edge on which the center lies."""
    for length, width in ((64, 1), (2**20, 1), (2**48, 1)):
        needle = spun([(-length, 0), (0, -width), (length, 0), (0, width)], *way)
        for beyond in (1 / 64, 1, length):
            for aside in (0, width / 4):
                ((x, y),) = spun([(length + beyond, aside)], *way)
                distance = math.hypot(*way) * math.hypot(beyond, aside)
                for part in (0.5, 1 - 2**-20, 1, 1 + 2**-20):
                    a, b = scaled(convex(needle), power), scaled(Circle((x, y), distance * part), power)
                    assert method(a, b) is method(b, a) is oracle.relation(a, b), (a, b)


def test_the_oracle_returns_the_distance():
    box = Polygon([(0, 0), (2, 0), (2, 2), (0, 2)])
    assert squared_distance(box, Polygon([(5, 6), (9, 9), (5, 9)])) == 25  # corner to corner
    assert squared_distance(box, Polygon([(3, 1), (9, -9), (9, 9)])) == 1  # corner to edge
    assert squared_distance(Polygon([(0, 0), (1, 0), (0, 1)]), Polygon([(1, 1), (2, 1), (1, 2)])) == Fraction(1, 2)
    assert squared_distance(box, Polygon([(2, 2), (9, 9), (5, 9)])) == 0
    assert squared_distance(box, Polygon([(1, 1), (9, 9), (5, 9)])) == 0


def test_shapely_agrees_on_ordinary_pairs():
    rng = Random(5)
    rings = []
    while len(rings) < 1_500:
        x, y = rng.uniform(-2, 2), rng.uniform(-2, 2)
        ring = round_ring(rng, x, y, rng.uniform(0.5, 2))
        if Polygon(ring).is_convex:
            rings.append(ring)
    them = shapely.polygons([shapely.LinearRing(ring) for ring in rings])
    hits = shapely.intersects(them[::2], them[1::2])
    assert 0.2 < hits.mean() < 0.8
    for method in METHODS:
        ours = [bool(method(Polygon(a), Polygon(b))) for a, b in zip(rings[::2], rings[1::2], strict=True)]
        assert ours == list(hits)


def test_shapely_agrees_on_the_distance():
    for kind, a, b in pairs(6, 1_000):
        if kind in ("random polygons", "boxes on a grid", "near touching, offset 100"):
            theirs = shapely.distance(shapely.Polygon(a.vertices), shapely.Polygon(b.vertices))
            assert math.sqrt(squared_distance(a, b)) == pytest.approx(theirs, rel=1e-9, abs=1e-12)


@pytest.mark.parametrize("thing", [None, 1, "circle", [(0, 0), (1, 0), (0, 1)]])
def test_anything_but_shapes_is_a_type_error(thing):
    shape = Circle((0, 0), 1)
    for pair in ((thing, shape), (shape, thing)):
        with pytest.raises(TypeError, match=r"make it a satviz\.Polygon or satviz\.Circle"):
            relate(*pair)


# -- properties under exact transforms -------------------------------------------------------------

often = settings(max_examples=60, deadline=None, database=None)
near = st.integers(-12, 12)
grid_points = st.tuples(near, near)
polygons = (
    st.lists(grid_points, min_size=3, max_size=10)
    .map(hull)
    .filter(lambda ring: len(ring) > 2)
    .map(lambda ring: Polygon([(2 * x, 2 * y) for x, y in ring]))
)
circles = st.builds(Circle, grid_points, st.integers(1, 24).map(lambda r: r / 2))
shapes = polygons | circles


def mapped(shape: Shape, move: Callable[[float, float], tuple[float, float]], grow: float = 1) -> Shape:
    if isinstance(shape, Circle):
        return Circle(move(*shape.center), shape.radius * grow)
    return Polygon([move(x, y) for x, y in shape.vertices])


@every_method
@often
@given(shape=shapes)
def test_a_shape_overlaps_itself(method, shape):
    assert method(shape, shape) is OVERLAPPING


@every_method
@often
@given(a=polygons, b=polygons, k=st.integers(-1000, 1000))
def test_an_exact_shear_changes_nothing(method, a, b, k):
    for move in (lambda x, y: (x + k * y, y), lambda x, y: (x, y + k * x)):
        assert method(mapped(a, move), mapped(b, move)) is method(a, b)


@every_method
@often
@given(a=shapes, b=shapes, turn=st.sampled_from([(3, 4, 5), (-4, 3, 5), (5, -12, 13), (-15, -8, 17)]))
def test_a_pythagorean_turn_changes_nothing(method, a, b, turn):
    p, q, r = turn
    moved = [mapped(shape, lambda x, y: (p * x - q * y, q * x + p * y), r) for shape in (a, b)]
    assert method(*moved) is method(a, b)


@every_method
@often
@given(a=polygons, b=shapes, seed=st.integers(0, 2**32))
def test_repeats_midpoints_and_a_closing_vertex_change_nothing(method, a, b, seed):
    assert method(Polygon(dress(Random(seed), a.vertices)), b) is method(a, b)


@every_method
@often
@given(a=polygons, b=shapes, pick=st.tuples(*[st.integers(0, 99)] * 3))
def test_a_vertex_or_center_inside_is_an_overlap(method, a, b, pick):
    i, j, k = (p % len(a.vertices) for p in pick)
    assume(len({i, j, k}) == 3)
    (px, py), (qx, qy), (rx, ry) = (a.vertices[c] for c in (i, j, k))
    x, y = (2 * px + qx + rx) / 4, (2 * py + qy + ry) / 4  # inside a triangle of a's vertices
    vx, vy = b.center if isinstance(b, Circle) else b.vertices[0]
    assert method(a, mapped(b, lambda bx, by: (bx + x - vx, by + y - vy))) is OVERLAPPING


@every_method
@often
@given(a=polygons, b=shapes, i=st.integers(0, 9))
def test_a_shared_point_is_a_hit(method, a, b, i):
    x, y = a.vertices[i % len(a.vertices)]
    vx, vy = (b.center.x + b.radius, b.center.y) if isinstance(b, Circle) else b.vertices[0]
    assert method(a, mapped(b, lambda bx, by: (bx + x - vx, by + y - vy)))


@every_method
@often
@given(a=shapes, center=grid_points, radii=st.lists(st.integers(1, 60), min_size=2, max_size=5))
def test_a_growing_circle_only_comes_closer(method, a, center, radii):
    relations = [method(a, Circle(center, r)) for r in sorted(radii)]
    assert relations == sorted(relations)


@every_method
@often
@given(a=shapes, b=shapes)
def test_beyond_the_bounds_is_apart_and_at_the_bounds_touches(method, a, b):
    right = max(x for x, _ in a.vertices) if isinstance(a, Polygon) else a.center.x + a.radius
    left = min(x for x, _ in b.vertices) if isinstance(b, Polygon) else b.center.x - b.radius
    assert method(a, mapped(b, lambda x, y: (x + right - left + 0.5, y))) is APART
    assert method(a, mapped(b, lambda x, y: (x + right - left, y))) in (APART, TOUCHING)


# -- the filters' bounds ---------------------------------------------------------------------------


class Undecided(Exception):
    """Raised where `relate` would evaluate an exact sign."""


@pytest.fixture
def float_only(monkeypatch) -> Callable[[Shape, Shape], Relation | None]:
    """Return `relate` without exact evaluation: a function that returns None where an exact sign is needed."""

    def no_sign(*_):
        """Raise Undecided."""
        raise Undecided

    def decide(a: Shape, b: Shape) -> Relation | None:
        """Return the relation, or None where an exact sign is needed."""
        try:
            return relate(a, b)
        except Undecided:
            return None

    monkeypatch.setattr(relate_module, "to_common_unit", no_sign)
    monkeypatch.setattr(relate_module, "orient", no_sign)
    return decide


def long_edges(rng: Random) -> tuple[Shape, Shape]:
    """Return a triangle, and another shape that has a corner on its edge; it is about as large as the box of both."""
    px, py, qx, qy, x, y = near_edge_line(rng)
    nx, ny = qy - py, px - qx
    behind = px + nx * rng.uniform(0.1, 0.5), py + ny * rng.uniform(0.1, 0.5)
    steep = rng.uniform(0.5, 1)
    beyond = [(s / 16, abs(s) / 16 * (steep + abs(s) / 16)) for s in rng.choice((range(-8, 9), (-8, 0, 8)))]
    return convex([(px, py), (qx, qy), behind]), convex(
        [(x - nx * t + s * (qx - px), y - ny * t + s * (qy - py)) for s, t in beyond]
    )


def at_the_bound(seed: int, count: int, circles: int) -> list[tuple[Shape, Shape]]:
    """Return near contacts with full mantissas, moved by up to a few error bounds of some ten ulps each."""
    rng = Random(seed)
    near = [make for kind, make in KINDS.items() if kind.startswith("near")]
    found: list[tuple[Shape, Shape]] = []
    while len(found) < count:
        try:
            a, b = rng.choice(BASIC if circles else [long_edges, long_edges, *near])(rng)
            if isinstance(a, Circle) + isinstance(b, Circle) != circles:
                continue
            grow = rng.uniform(1, 2)  # so that products round
            a, b = (mapped(shape, lambda x, y, grow=grow: (x * grow, y * grow), grow) for shape in (a, b))
            if isinstance(a, Circle):
                a, b = b, a
            if isinstance(b, Circle):
                steps = rng.choice((8, 40, 200)) * (2 - circles) + 8
                found.append((a, Circle(b.center, nudged(b.radius, rng.randint(-steps, steps)))))
            else:
                most = rng.choice((0, 2, 10, 40))
                ring = [tuple(nudged(c, rng.randint(-most, most)) for c in v) for v in b.vertices]
                found.append((convex(a.vertices), convex(ring)))
        except (InvalidShape, NotConvex):
            continue
    return found


@pytest.mark.parametrize("circles", [0, 1, 2], ids=["polygons", "circle and polygon", "circles"])
def test_the_float_filter_is_never_wrong_where_it_decides(float_only, circles):
    known = [(a, b, oracle.relation(a, b)) for a, b in at_the_bound(11, 1_000, circles)]
    said = [float_only(a, b) for a, b, _ in known]
    wrong = [(a, b, truth, s) for (a, b, truth), s in zip(known, said, strict=True) if s not in (None, truth)]
    assert wrong == []
    decided = sum(s is not None for s in said)
    print(f"decided by floats: {decided} of {len(said)}")
    assert 0.05 < decided / len(said) < 0.95, "the pairs do not lie on both sides of the bound"
    assert not any(s is TOUCHING for s in said), "floats cannot see a touch"


@pytest.mark.slow
def test_a_polygon_filter_without_an_error_bound_is_wrong(float_only, monkeypatch):
    """The pairs of the test above are hard: with an error bound of half a rounding the filter is wrong."""
    monkeypatch.setattr(relate_module, "ERROR_FACTOR_F64", U / 8)  # times two widths and two largest coordinates
    monkeypatch.setattr(relate_module, "MIN_ERROR_BOUND", 0.0)
    wrong = sum(float_only(a, b) not in (None, oracle.relation(a, b)) for a, b in at_the_bound(11, 1_000, 0))
    print(f"wrong without an error bound: {wrong} of 1000")
    assert wrong > 3


def tilted_boxes(rng: Random) -> tuple[Shape, Shape]:
    """Return two boxes whose opposite edges are exactly opposite, so that they form slabs; never near a touch."""
    third = 21845 / 2**16
    rings = []
    for _ in "ab":
        w, h = rng.randint(1, 9), rng.randint(1, 3)
        rings.append(spun([(0, 0), (w, 0), (w, h), (0, h)], 5, rng.randint(1, 4)))
    dx, dy = rng.randint(-40, 40) + third, rng.randint(-40, 40) + third
    return convex(rings[0]), convex([(x + dx, y + dy) for x, y in rings[1]])


@pytest.mark.parametrize("power", [-400, -40, 0, 40, 400])
def test_floats_decide_all_pairs_that_are_far_from_touching(float_only, power):
    rng = Random(15)
    for _ in range(150):
        a, b = (scaled(shape, power) for shape in rng.choice((random_polygons, random_circles, tilted_boxes))(rng))
        assert float_only(a, b) is oracle.relation(a, b), (a, b)
    inner = Polygon([(-4, -3), (4, -2), (0, 5)]), Circle((0, 0), 0.01)
    assert float_only(*(scaled(shape, power) for shape in inner)) is OVERLAPPING


@pytest.mark.parametrize("power", [-1000, -400, 0, 400, 1000])
def test_two_upright_boxes_are_decided_by_their_bounds_alone(float_only, power):
    unit = 2.0**power
    for x in range(-3, 4):
        for y in range(-3, 4):
            a = Polygon([(0, 0), (2 * unit, 0), (2 * unit, unit), (0, unit)])
            b = Polygon(
                [
                    (x * unit, y * unit + 2 * unit),
                    (x * unit, y * unit),
                    (x * unit + unit, y * unit),
                    (x * unit + unit, y * unit + 2 * unit),
                ]
            )
            truth = min(
                (APART, TOUCHING, OVERLAPPING)[(gap < 0) + (gap <= 0)]
                for gap in (abs(2 * x - 1) - 3, abs(2 * y + 1) - 3)
            )
            assert float_only(a, b) is truth


@pytest.fixture(params=BOUNDS)
def bound(request):
    if request.param == "batch: float64":
        pytest.importorskip("numba", reason="needs numba: python -m pip install '.[fast]'")
    return BOUNDS[request.param]


def test_the_worst_rounding_found_stays_within_the_derived_bound(bound):
    worst = search(bound, 17, tries=12)
    print(f"worst {worst.share:.3g} of the error bound, {bound.derived:.3g} derived, at {worst.numbers}")
    assert 0 < worst.share <= bound.derived


@pytest.mark.full
def test_the_worst_rounding_found_in_a_minute_stays_within_the_derived_bound(bound):
    assert 0 < search(bound, 18, seconds=60).share <= bound.derived
