"""Tests of the minimum translation vector (MTV): it ends the overlap, and no shorter move does."""

from collections import Counter
from contextlib import suppress
from math import cos, hypot, pi, sin
from random import Random

import pytest
import shapely
from speeds import one_in
from strategies import CONVEX, NotConvex, few_corners, notched, pairs, scaled, star

import satviz as sv
from satviz.engine import axes, convex_parts
from satviz.engine import mtv as mtv_module
from satviz.engine.mtv import ends_overlap
from satviz.scenes.shape_tools import box

A = sv.Polygon([(0, 1), (3, 2), (1, 5)])
B = sv.Polygon([(5, 5), (8, 3), (4, 1)], labels=["v1", "v2", "v3"])
L = sv.Polygon([(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)])


def test_the_mtv_ends_the_overlap_and_a_slightly_shorter_move_does_not():
    overlapping = 0
    for _, a, b in pairs(5, 400, [kind for kind in CONVEX if kind != "many corners"]):
        trace = sv.record(a, b)
        mtv = trace.mtv
        if trace.relation is sv.Relation.APART:
            assert mtv is None
        elif trace.relation is sv.Relation.TOUCHING:
            assert mtv == (0, 0)
        elif 1e-100 < hypot(*mtv) < 1e100:
            overlapping += 1
            assert ends_overlap(a, b, mtv), (a, b)
            less = sv.Vec(mtv.x * (1 - 1e-5), mtv.y * (1 - 1e-5))
            assert not ends_overlap(a, b, less), (a, b)
    assert overlapping > 50


@pytest.mark.parametrize(
    ("a", "b", "mtv"),
    [
        (box(0, 0, 4, 1), box(3, 0.5, 5, 3.5), (0, 0.5)),  # raw normals would choose x
        (box(0, 0, 10, 10), box(4, 4, 5, 5), (0, -5)),  # one holds the other: not the shared length
        (sv.Circle((0, 0), 2), sv.Circle((0, 0), 1), (3, 0)),
        (sv.Circle((0, 0), 3), sv.Circle((4, 0), 2), (1, 0)),
    ],
)
def test_the_mtv_is_right_where_shortcuts_are_wrong_and_exact_where_float64_holds_it(a, b, mtv):
    assert sv.record(a, b).mtv == mtv


def test_only_an_overlap_has_an_mtv_that_is_not_zero():
    assert sv.record(A, B).mtv is None
    assert sv.record(box(2.5, 2.5, 3.5, 3.5), L).mtv is None
    assert sv.record(box(0, 0, 1, 1), box(1, 0, 2, 1)).mtv == (0, 0)
    assert sv.record(box(2, 2, 3, 3), L).mtv == (0, 0)


def test_the_mtv_does_not_follow_the_centers():
    sliver, small = sv.Polygon([(0, 0), (8, 0), (0, 1)]), box(0.5, -0.5, 1.5, 1.5)
    mtv = sv.record(sliver, small).mtv
    assert ends_overlap(sliver, small, mtv)
    assert hypot(*mtv) == pytest.approx(min(-t.gap for t in sv.record(sliver, small).tests))


CONCAVE = [
    (L, box(1.5, 1.5, 3.5, 3.5)),
    (L, sv.Circle((3.2, 3.2), 1.5)),
    (L, L),
    (sv.Polygon([(0, 0), (6, 0), (6, 4), (4, 4), (4, 1), (2, 1), (2, 4), (0, 4)]), box(2.2, 1.5, 3.8, 3.5)),
    (sv.Polygon([(0, 0), (6, 0), (6, 4), (4, 4), (4, 1), (2, 1), (2, 4), (0, 4)]), box(1.8, 1.5, 4.2, 3.5)),
    (box(0, 0, 9, 9), sv.Polygon([(3, 3), (6, 3), (4, 4), (3, 6)])),
]


@pytest.mark.parametrize(("a", "b"), CONCAVE)
def test_a_concave_pairs_mtv_ends_the_overlap_and_no_shorter_move_of_a_fan_does(a, b):
    trace = sv.record(a, b)
    if trace.relation is not sv.Relation.OVERLAPPING:
        assert trace.mtv is None or trace.mtv == (0, 0)
        return
    assert ends_overlap(a, b, trace.mtv)
    size = hypot(*trace.mtv)
    for k in range(90):
        for part in (0.25, 0.5, 0.75, 0.9, 0.999):
            move = sv.Vec(cos(k * pi / 45) * size * part, sin(k * pi / 45) * size * part)
            assert not ends_overlap(a, b, move), move


HARD = [
    # a pocket whose free wedge lies sideways; a tiny circle; rounding against a large outline
    (sv.Polygon([(5, -1), (0, 1), (0, -1), (-2, 4), (-5, -3)]), sv.Circle((-0.9, 0.2), 0.3), 0.6986),
    (sv.Polygon([(0, 1), (1, 3), (-5, 4), (4, -4)]), sv.Circle((-1.9, 2.2), 1e-7), 0.71419),
    (
        sv.Polygon([(-3, 1), (-4, 2), (-2, 4), (2, 3), (1, 1), (-3, -4)]),
        sv.Circle((-1e-10, 4e-10), 2e-10),
        0.156174,
    ),
    # just deep enough for the float filter, whose gap has five right digits only
    (
        sv.Polygon(
            [
                (0.33134916401791936, -0.943508204259309),
                (0.9372193363989527, 0.3492565531593265),
                (-0.33134916401791936, 0.943508204259309),
            ]
        ),
        sv.Polygon(
            [
                (0.33134916512778495, -0.943508203869537),
                (-0.3313491629080538, 0.943508204649081),
                (-1.0097428727454139, -0.1427476526537444),
            ]
        ),
        1.1763e-9,
    ),
]


@pytest.mark.parametrize(("a", "b", "length"), HARD)
def test_the_mtv_of_hard_scenes_is_there_ends_the_overlap_and_is_short(a, b, length):
    trace = sv.record(a, b)
    assert ends_overlap(a, b, trace.mtv) and hypot(*trace.mtv) == pytest.approx(length, rel=1e-4)
    assert str(trace)


@pytest.mark.parametrize("e", [-1060, -540, 0, 512, 1015])
def test_a_concave_mtv_scales_with_the_scene(e):
    s = 2.0**e
    mtv = sv.record(sv.Polygon([(x * s, y * s) for x, y in L.vertices]), sv.Circle((2.25 * s, 2.25 * s), s)).mtv
    assert mtv == pytest.approx((0.75 * s, 0.75 * s), rel=1e-3)


@pytest.mark.parametrize("notch", [[], [(0, 0.9)]], ids=["convex", "concave"])
def test_an_mtv_beyond_float64_is_none_with_a_note(notch):
    huge = sv.Polygon([(1.7e308 * x, 1.7e308 * y) for x, y in [(-1, -1), (1, -1), (1, 1), *notch, (-1, 1)]])
    trace = sv.record(huge, sv.Polygon([(-1e308, -1e308), (1e308, -1e308), (0, 1e308)]))
    assert trace.mtv is None and "No move" in trace.sentence and trace.certificate.check()
    assert sv.Trace.from_json(trace.to_json()) == trace


def test_the_mtv_of_too_many_parts_is_refused_with_the_counts_and_a_remedy():
    trace = sv.record(star(40), star(40, 1.3, 0.1))
    with pytest.raises(
        sv.InvalidScene, match=r"1,681 pairs .* 13,120 corners.* 4,000 .*trace\.colliding\.mtv"
    ) as refused:
        _ = trace.mtv
    assert "\n" not in str(refused.value)
    assert trace.colliding.mtv and trace.certificate.check()


def test_the_limit_on_the_mtv_counts_the_corners_of_all_pairs(monkeypatch):
    for b, corners in (box(1.5, 1.5, 3.5, 3.5), 16), (sv.Circle((3.2, 3.2), 1.5), 10), (star(3, 2, 2), 44):
        trace = sv.record(L, b)
        monkeypatch.setattr(mtv_module, "MAX_CORNERS", corners - 1)
        mtv_module.mtv_of_parts.cache_clear()
        with pytest.raises(sv.InvalidScene, match=rf"{2 * len(sv.parts(b))} pairs of convex parts with {corners} corn"):
            _ = trace.mtv
        monkeypatch.setattr(mtv_module, "MAX_CORNERS", corners)
        assert trace.mtv


def test_the_mtv_is_computed_once_and_not_for_a_picture_of_shapes_that_are_apart(monkeypatch):
    mtv_module.mtv_of_parts.cache_clear()
    trace = sv.record(L, sv.Circle((3.2, 3.2), 1.5))
    assert mtv_module.mtv_of_parts.cache_info().misses == 0
    _ = trace.mtv, str(trace), trace.to_json(), sv.Trace.from_json(trace.to_json()).mtv
    assert mtv_module.mtv_of_parts.cache_info().misses == 1


POCKET = sv.Polygon(
    [(0, 9), (0, -5), (1.9, -5), (2, 0), (2.1, -9), (-9, -9), (-9, 9)]
)  # a wall to the left, a tip at (2, 0)


POCKET_8 = sv.Polygon([(0, 72), (0, -40), (15, -40), (16, 0), (17, -72), (-72, -72), (-72, 72)])


SPIKE = sv.Polygon([(-9, -2), (9, -2), (9, 0), (0.2, 0), (0, 1), (-0.2, 0), (-9, 0)])


def spikes(half):
    """Return a box with two spikes, of half this width at the tips (1, 1) and (-1, 1)."""
    right, left = ([(t + half, 0), (t, 1), (t - half, 0)] for t in (1, -1))
    return sv.Polygon([(-9, -2), (9, -2), (9, 0), *right, *left, (-9, 0)])


SPIKES, NEEDLES = spikes(0.2), spikes(0.02)


PRONGS = sv.Polygon([(-9, -9), (9, -9), (1, 0), (0, -8), (-1, 0)])


@pytest.mark.parametrize(
    ("a", "circle", "mtv"),
    [
        (L, ((4.3, 2.4), 1), (0.3, 0.4)),  # straight away from a corner
        (L, ((4.3, -0.4), 1), (0.3, -0.4)),
        (L, ((-0.3, -0.4), 1), (-0.3, -0.4)),
        (L, ((-0.4, 4.3), 1), (-0.4, 0.3)),
        (L, ((5, 1), 1.5), (0.5, 0)),  # straight away from an edge
        (L, ((2.25, 2.25), 1), (0.75, 0.75)),  # where two edges meet
        (PRONGS, ((0, 0.25), 1.25), (0, 0.5)),  # where the circles about two corners meet
        (PRONGS, ((0, 0.5), 1.25), (0, 0.25)),
        (SPIKE, ((0, 3.9), 3), (0, 0.1)),  # away from a tip close to an edge
        (SPIKES, ((0, 3.75), 3), (0, 8**0.5 - 2.75)),  # where the circles about two tips close to an edge meet
        (NEEDLES, ((0, 3.75), 3), (0, 8**0.5 - 2.75)),  # tips so thin that an arc runs nearly half round
        (POCKET, ((1, 0.5), 1.25), (0.25, 0.5)),  # where an edge and the circle about a corner meet
    ],
)
@pytest.mark.parametrize("mirror", [(1, 1), (-1, 1), (1, -1), (-1, -1)])
def test_the_mtv_of_a_circle_is_away_from_edges_and_corners(a, circle, mtv, mirror):
    def seen(p):
        return p[0] * mirror[0], p[1] * mirror[1]

    trace = sv.record(sv.Polygon(list(map(seen, a.vertices))), sv.Circle(seen(circle[0]), circle[1]))
    assert trace.mtv == pytest.approx(seen(mtv)) and ends_overlap(trace.a, trace.b, trace.mtv)
    back = sv.record(trace.b, trace.a).mtv
    assert back == pytest.approx([-c for c in seen(mtv)])


@pytest.mark.parametrize("k", range(20))
def test_a_rounded_crossing_is_nudged_outwards_by_a_tiny_step(k):
    x, y, radius = k / 173, 0.1 + k / 91, 1.2 + k / 311
    up = sv.record(PRONGS, sv.Circle((x, y), radius)).mtv
    assert up == pytest.approx((-x, (radius**2 - 1) ** 0.5 - y), abs=1e-14)
    out = sv.record(POCKET, sv.Circle((1 + x, y / 2), radius)).mtv
    assert out == pytest.approx((radius - 1 - x, (radius**2 - (2 - radius) ** 2) ** 0.5 - y / 2), abs=1e-14)


@pytest.mark.parametrize("first", range(0, 300, 50))
def test_a_circle_leaves_a_groove_upwards_where_a_wall_ends_at_the_touching_point(first):
    """The rounded crossing of both borders lies beyond the end of the side, of the arc, or of both."""
    for k in range(first, first + 50):
        c, s, up = cos(k), sin(k), 1 + k % 5
        ring = [(0, 0), (24, 32), (60, 32), (0, -60), (-60, 16), (-12, 16)]
        groove = sv.Polygon([(c * x - s * y, s * x + c * y) for x, y in ring])
        move = sv.record(groove, sv.Circle((s * (up - 25), c * (25 - up)), 15)).mtv
        assert move == pytest.approx((-s * up, c * up), abs=1e-12), k


@pytest.mark.parametrize("e", [8, 16, 20, 24])
@pytest.mark.parametrize("k", range(1, 4))
def test_a_box_moves_back_in_a_slightly_narrowing_slot_and_not_out_of_it(k, e):
    """Where walls are nearly parallel, the sum of their normals is nearly 0 and cannot nudge a rounded crossing out."""
    c, s, narrow = cos(k), sin(k), 2.0**-e
    ring = [(-1, 1), (-3, 1), (-3, -3), (3, -3), (3, 1), (1, 1), (1 - 1.5 * narrow, -0.5), (1.5 * narrow - 1, -0.5)]
    slot, fits = (
        sv.Polygon([(c * x - s * y, s * x + c * y) for x, y in corners])
        for corners in (ring, [(narrow - 1, -0.25), (1 - narrow, -0.25), (1 - narrow, 0.25), (narrow - 1, 0.25)])
    )
    assert sv.record(slot, fits).mtv == pytest.approx((-s * 0.25, c * 0.25), abs=2**-20)


@pytest.mark.parametrize("e", [20, 24, 28, 32])
@pytest.mark.parametrize("k", [5, 8, 9, 19, 24])
def test_a_box_fits_on_the_floor_of_a_slot_whose_walls_hardly_lean(k, e):
    """Where the walls cross, rounded far along them, the floor forbids the rounded move, and a longer one is free."""
    c, s, lean = cos(k), sin(k), 2.0**-e
    for left, right in (lean, 0), (0, lean), (lean, lean / 4):
        ring = [(-3, 1), (-3, -3), (3, -3), (3, 1), (1 + right, 1), (1, -1), (-1, -1), (-1 - left, 1)]
        for aside in (-0.0625, 0.0625):
            fits = [(aside - 1, -1), (aside + 1, -1), (aside + 1, -0.5), (aside - 1, -0.5)]
            a, b = (sv.Polygon([(c * x - s * y, s * x + c * y) for x, y in corners]) for corners in (ring, fits))
            assert sv.record(a, b).mtv == pytest.approx((-c * aside, -s * aside), abs=2**-18), (left, right, aside)


@pytest.mark.parametrize("first", range(8))
@pytest.mark.parametrize(("left", "right"), [(1, 1), (1, 1.5), (1.5, 1)])
def test_a_circle_leaves_a_slot_as_wide_as_itself_by_the_mouth(first, left, right):
    """Rounding decides whether the circle fits in the slot; past the corner of the lower wall it is free."""
    ring = [(-3, left), (-3, -3), (3, -3), (3, right), (1, right), (1, -2), (-1, -2), (-1, left)]
    for k in range(40):
        turn = complex(cos(k), sin(k))
        slot = [turn * complex(*v) for v in ring[first:] + ring[:first]]
        center = turn * (0.1 + 0.9j)
        move = sv.record(sv.Polygon([(v.real, v.imag) for v in slot]), sv.Circle((center.real, center.imag), 1)).mtv
        along = complex(*move) / turn
        assert along.real == pytest.approx(-0.1, abs=1e-7) and -1e-6 < along.imag < 0.1 + 1e-6, k


@pytest.mark.parametrize("place", [(1, 1), (1, -1), (-1, 1), (-1, -1), (0, 1), (1, 0), (0, -1), (-1, 0)])
@pytest.mark.parametrize("far", [2.0**20, 2.0**33])
def test_the_mtv_is_the_same_wherever_the_same_shapes_lie(place, far):
    """All coordinates are whole, so nothing is rounded, and a rounded crossing is nudged out by as little."""
    x, y = far * place[0], far * place[1]
    for k in range(8):
        for a, circle in (PRONGS, (k / 128, 0.25 + k / 64, 1.2 + k / 311)), (POCKET_8, (k + 8, k + 4, 10 + k / 7)):
            u, v, radius = circle
            there = sv.Polygon([(p + x, q + y) for p, q in a.vertices])
            mtv = sv.record(there, sv.Circle((u + x, v + y), radius)).mtv
            assert mtv == sv.record(a, sv.Circle((u, v), radius)).mtv


def test_the_mtv_of_a_circle_centered_on_a_corner_has_the_length_of_its_radius():
    trace = sv.record(L, sv.Circle((4, 2), 0.5))
    assert hypot(*trace.mtv) == pytest.approx(0.5) and ends_overlap(trace.a, trace.b, trace.mtv)


@pytest.mark.parametrize(("a", "b"), [(POCKET, sv.Circle((1, 0.5), 1.25)), (PRONGS, sv.Circle((0, -2), 0.9))])
def test_no_shorter_move_of_a_circle_ends_the_overlap(a, b):
    size = hypot(*sv.record(a, b).mtv)
    for k in range(180):
        for share in (0.3, 0.7, 0.9, 0.99):
            move = sv.Vec(cos(k * pi / 90) * size * share, sin(k * pi / 90) * size * share)
            assert not ends_overlap(a, b, move), move


def forbidden(a, b, wider=0.0):
    """Return the moves of b that make the shapes overlap, computed by shapely: exact but for arcs, good to 1e-6.

    wider: by what the region is widened.
    """
    (p, q), radius = (
        ([part.core for part in convex_parts.parts(shape)] for shape in (a, b)),
        a.radius + b.radius + wider,
    )
    sums = [shapely.MultiPoint([(ux - vx, uy - vy) for ux, uy in u for vx, vy in v]) for u in p for v in q]
    return shapely.union_all([points.convex_hull.buffer(radius, quad_segs=512) for points in sums])


@pytest.mark.parametrize("kind", ["circle", "convex", "concave"])
@pytest.mark.parametrize("seed", one_in(3, range(8)))
def test_the_mtv_of_a_concave_outline_is_the_shortest_move_that_is_not_forbidden(kind, seed):
    rng, found = Random(f"{kind} {seed}"), 0
    while found < 15:
        with suppress(sv.InvalidShape, NotConvex):
            a, other = sv.Polygon(notched(rng)), sv.Polygon((notched if kind == "concave" else few_corners)(rng))
            x, y = (rng.uniform(*a.bounds[i::2]) for i in (0, 1))
            size = a.max_coordinate * rng.choice((0.05, 0.3, 1))
            ring = [
                (u / other.max_coordinate * size + x, v / other.max_coordinate * size + y) for u, v in other.vertices
            ]
            b = sv.Circle((x, y), size) if kind == "circle" else sv.Polygon(ring)
            a, b = rng.sample((a, b), 2)
            if sv.relate(a, b) is sv.Relation.OVERLAPPING:
                found += 1
                mtv = sv.record(a, b).mtv
                nearest = forbidden(a, b).boundary.distance(shapely.Point(0, 0))
                tolerance = 1e-9 * nearest + 1e-5 * (a.radius + b.radius)
                assert ends_overlap(a, b, mtv) and hypot(*mtv) <= nearest + tolerance


def a_tight_fit(rng):
    """Return a block with a slot, and a circle or a box that just fits between two corners of its walls, turned."""

    def wall(x):
        top = rng.choice((1, 1, 0.5))
        heights = [top, *sorted((rng.uniform(-1, top) for _ in range(rng.randrange(3))), reverse=True), -1]
        return [(x + rng.choice((0, 0, 1, -1)) * 2.0 ** -rng.randint(2, 48), y) for y in heights]

    left, right = wall(-1), wall(1)
    p, q, more = rng.choice(left), rng.choice(right), rng.choice((0, 0, 2.0**-45, -(2.0**-45), 2.0**-25, 2.0**-10))
    x, y = rng.choice((0, rng.uniform(-0.5, 0.5))), rng.choice((p[1], q[1], rng.uniform(-2, 2)))
    turn = complex(cos(k := rng.choice((0, 1, rng.uniform(0, 7)))), sin(k))
    ring, fits = (
        [((turn * complex(*v)).real, (turn * complex(*v)).imag) for v in vertices]
        for vertices in (
            [(-3, left[0][1]), (-3, -3), (3, -3), (3, right[0][1]), *right, *left[::-1]],
            [(p[0] + x - more, y), (q[0] + x, y), (q[0] + x, y + 0.5), (p[0] + x - more, y + 0.5)],
        )
    )
    radius = (rng.choice((hypot(q[0] - p[0], q[1] - p[1]), q[0] - p[0])) + more) / 2
    middle = (fits[0][0] + fits[1][0]) / 2, (fits[0][1] + fits[1][1]) / 2
    return sv.Polygon(ring), rng.choice((sv.Polygon(fits), sv.Circle(middle, radius)))


@pytest.mark.parametrize("seed", one_in(3, range(6)))
def test_no_shorter_move_ends_the_overlap_where_a_shape_just_fits_between_two_walls(seed):
    """The crossing of nearly parallel borders is rounded far off, and the sum of their normals has no correct digit."""
    rng, found = Random(f"tight {seed}"), 0
    while found < 40:
        a, b = rng.sample(a_tight_fit(rng), 2)
        if sv.relate(a, b) is sv.Relation.OVERLAPPING:
            found += 1
            mtv = sv.record(a, b).mtv
            # each arc is drawn outside of the true one, so a free move here is one there too
            wide = forbidden(a, b, wider=2e-6 * (a.radius + b.radius) + 1e-9)
            assert ends_overlap(a, b, mtv) and hypot(*mtv) <= wide.boundary.distance(shapely.Point(0, 0)) + 1e-6


@pytest.mark.parametrize("power", [-600, -40, 0])
def test_a_large_and_a_small_concave_outline_have_an_mtv(power):
    small, large = (sv.Polygon([(c * 2.0**e, d * 2.0**e) for c, d in L.vertices]) for e in (power, 1000))
    for a, b in [(small, large), (large, small), (large, sv.Circle((0, 0), 2.0**power))]:
        trace = sv.record(a, b)
        assert ends_overlap(a, b, trace.mtv) and sv.Trace.from_json(trace.to_json()) == trace


def test_outlines_at_the_limit_of_float64_have_an_mtv():
    rim = sv.Polygon([(c * 4e307, d * 4e307) for c, d in L.vertices])
    circle = sv.Circle((1.7e308, 1.7e308), 1.7e308)
    for a, b in [(rim, circle), (circle, rim)]:
        assert ends_overlap(a, b, sv.record(a, b).mtv)


def test_the_mtv_needs_no_tested_axis():
    for a, b in [(A, A), (box(0, 0, 4, 1), box(3, 0.5, 5, 3.5)), (A, sv.Circle((1, 2), 1))]:
        assert sv.record(a, b, axes=axes.Choice(())).mtv == sv.record(a, b).mtv


@pytest.mark.parametrize(
    "b", [star(8, 1.3, 0.1), sv.Circle((0.1, 0.2), 0.3), box(-0.2, -0.3, 0.3, 0.2), sv.Circle((0.1, 0.2), 2)], ids=repr
)
def test_few_moves_are_checked_exactly_and_borders_inside_a_region_are_not_crossed(b, monkeypatch):
    calls = Counter()
    for name in ("relate_moved", "_crossing_candidates"):
        done = getattr(mtv_module, name)
        monkeypatch.setattr(mtv_module, name, lambda *args, name=name, done=done: calls.update([name]) or done(*args))
    a = star(9)
    assert mtv_module.mtv_of_parts.__wrapped__(a, b)
    assert calls["relate_moved"] < 4 * len(sv.parts(a)) * len(sv.parts(b)) and calls["_crossing_candidates"] < 600


SMALL = [box(-0.5, 0.25, 0.5, 2), sv.Polygon([(0, 0.5), (1, 1), (0, 2)]), sv.Circle((0, 1), 0.5)]


@pytest.mark.parametrize("b", [*(scaled(b, -600) for b in SMALL), scaled(sv.Circle((0, 1), 1.5), 499)], ids=range(4))
def test_an_outline_with_a_spike_far_below_its_size_has_an_mtv(b):
    huge, tiny = 2.0**500, 2.0**-600
    a = sv.Polygon([(-huge, -huge), (huge, -huge), (huge, 0), (tiny, 0), (0, tiny), (-tiny, 0), (-huge, 0)])
    for first, second in (a, b), (b, a):
        assert ends_overlap(first, second, sv.record(first, second).mtv)


def test_parallel_sides_become_one_side_of_the_minkowski_sum():
    square = [0j, 1 + 0j, 1 + 1j, 1j]
    assert mtv_module._minkowski_sum(square, [2 * v for v in square[2:] + square[:2]]) == [3 * v for v in square]


@pytest.mark.parametrize("seed", range(20))
def test_only_circles_give_curved_borders_and_the_hull_of_each_border_contains_it(seed):
    rng = Random(seed)
    corners = shapely.MultiPoint([(rng.gauss(0, 1), rng.gauss(0, 0.01)) for _ in range(rng.randint(3, 6))])
    ring = [complex(x, y) for x, y in reversed(corners.convex_hull.exterior.coords[1:])]
    assert all(border.normal for border in mtv_module._borders(ring, 0.0))
    for radius in (0.01, 1.0, 3.0):
        bare = corners.convex_hull.buffer(radius, quad_segs=512).boundary
        for border in mtv_module._borders(ring, radius):
            hull = shapely.MultiPoint([(v.real, v.imag) for v in border.hull]).convex_hull
            bare -= hull.buffer(1e-4)  # shapely leaves out nearly straight arcs
        assert bare.is_empty


@pytest.mark.parametrize("radius", [0.0, 0.5, 1.0, 3.0])
def test_no_border_is_nearer_than_its_attribute_nearest(radius):
    for turn in (1, 1j, -1, -1j):
        for border in mtv_module._borders([turn * v for v in (2 + 1j, 3 + 1j, 2.5 + 3j)], radius):
            assert border.nearest <= min(abs(border.p), abs(border.q)) + 1e-9


@pytest.mark.parametrize("far", [2.0**20, 2.0**26, 2.0**33])
def test_the_mtv_of_concave_outlines_is_as_short_far_from_the_origin(far):
    line = [(i / 8, 3 * (i % 2) / 8) for i in range(6)]
    ring = line + [(x, y + 1 / 16) for x, y in reversed(line)]
    near, there = (sv.Polygon([(x + at, y - at) for x, y in ring]) for at in (0.0, far))
    for b, c in (near, there), (sv.Circle((0.25, 0), 0.125), sv.Circle((far + 0.25, -far), 0.125)):
        assert hypot(*sv.record(there, c).mtv) == pytest.approx(hypot(*sv.record(near, b).mtv), rel=1e-6)
