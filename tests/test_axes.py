"""Tests of choices of axes: which axes they contain, their sources, and which axes they skip."""

from fractions import Fraction
from math import hypot, ldexp
from random import Random

import pytest

import satviz as sv
from satviz.engine import axes
from satviz.engine.sat import axis_tests
from satviz.scenes.shape_tools import box

A = sv.Polygon([(0, 1), (3, 2), (1, 5)])
B = sv.Polygon([(5, 5), (8, 3), (4, 1)], labels=["v1", "v2", "v3"])
L = sv.Polygon([(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)])
COIN = sv.Circle((5, 6), 1)
PAIRS = {
    "triangles": (A, B),
    "concave": (L, B),
    "box and triangle": (box(0, 0, 2, 1), B),
    "triangle and box": (B, box(0, 0, 2, 1)),
    "boxes": (box(0, 0, 2, 1), box(3, 3, 4, 5)),
    "polygon and circle": (A, COIN),
    "circle and concave": (COIN, L),
    "circle on a vertex": (sv.Circle((3, 2), 1), A),
    "circles": (COIN, sv.Circle((-1, 4), 2)),
    "concentric": (COIN, sv.Circle((5, 6), 2)),
}


def sized(shape: sv.Polygon | sv.Circle, e: int) -> sv.Polygon | sv.Circle:
    """Return the shape scaled by 2**e."""
    if isinstance(shape, sv.Circle):
        return sv.Circle([ldexp(c, e) for c in shape.center], ldexp(shape.radius, e))
    return sv.Polygon([[ldexp(c, e) for c in v] for v in shape.vertices])


def exact(axis, a, b):
    return axes.exact_dots(a, b, axis).normal


# -- sources ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", axes.NAMED)
@pytest.mark.parametrize("e", [-1040, -400, 0, 400, 1000])
def test_every_axis_runs_along_its_source_to_the_right_or_up_and_has_its_length(name, e):
    for pair in PAIRS.values():
        a, b = (sized(shape, e) for shape in pair)
        choice = axes.NAMED[name](a, b)
        for axis in (*choice.axes, *(skip.axis for skip in choice.skipped)):
            (nx, ny), (x, y) = axis.normal, exact(axis, a, b)
            assert abs(Fraction(nx) * y - Fraction(ny) * x) <= abs(Fraction(nx) * y) / 2**50
            assert (x, y) > (0, 0) and (nx, ny) > (0, 0)
            assert axis.length == hypot(nx, ny) and hypot(*axis.direction) == pytest.approx(1)
            assert axis.direction == pytest.approx((nx / axis.length, ny / axis.length))


def found_in(source: axes.Source, a: sv.Polygon | sv.Circle, b: sv.Polygon | sv.Circle) -> tuple[Fraction, Fraction]:
    """Return the direction of a source in fractions, to the right or up."""
    own, other = (b, a) if source.shape == "B" else (a, b)
    if source.kind == axes.CENTERS:
        ends = a.center, b.center
    elif source.kind == axes.VERTEX:
        ends = own.vertices[source.ids[0]], other.center
    else:
        (px, py), (qx, qy) = (own.vertices[i] for i in source.ids)
        ends = (py, qx), (qy, px)
    x, y = (Fraction(q) - Fraction(p) for p, q in zip(*ends))
    return (x, y) if (x, y) > (0, 0) else (-x, -y)


@pytest.mark.parametrize("name", ["needed", "edge-normals", "hull-normals", "centers", "nearest-vertex"])
def test_the_exact_normal_of_an_axis_is_that_of_the_edge_or_line_it_comes_from(name):
    rng, kinds = Random(6), set()
    for _ in range(200):
        sizes = [2.0 ** rng.randint(-40, 40) for _ in "ab"]
        a, b = (
            sv.Circle((rng.uniform(-s, s), rng.uniform(-s, s)), s)
            if rng.random() < 0.5
            else sv.Polygon([(rng.uniform(-s, s), rng.uniform(-s, s)) for _ in range(3)])
            for s in sizes
        )
        for axis in axes.NAMED[name](a, b).axes:
            if axis.source.kind in (axes.EDGE, axes.VERTEX, axes.CENTERS):
                kinds.add(axis.source.kind)
                (nx, ny), (x, y) = found_in(axis.source, a, b), axes.exact_dots(a, b, axis).normal
                assert nx * y == ny * x and (x, y) > (0, 0), (axis, a, b)
    assert kinds


def test_the_worlds_axes_are_y_and_x():
    assert [axis.normal for axis in axes.WORLD_AXES] == [(0, 1), (1, 0)]
    assert [axes.exact_dots(A, B, axis).normal for axis in axes.WORLD_AXES] == [(0, 1), (1, 0)]
    assert [axis.source.ids for axis in axes.WORLD_AXES] == [(1,), (0,)]


@pytest.mark.parametrize("name", axes.NAMED)
def test_a_normal_is_as_long_as_its_edge_unless_that_nearly_overflows_or_underflows(name):
    for pair in PAIRS.values():
        unscaled = axes.NAMED[name](*pair).axes
        for e, change in ((-250, -250), (250, 250), (-320, None), (310, None), (-1000, None), (1000, None)):
            for axis, first in zip(axes.NAMED[name](*(sized(shape, e) for shape in pair)).axes, unscaled, strict=True):
                if change and axis.source.kind not in (axes.WORLD, axes.ANY):
                    assert axis.normal == (ldexp(first.normal.x, change), ldexp(first.normal.y, change))
                else:
                    assert 0.25 <= axis.length <= 2
                assert axis.direction == pytest.approx(first.direction, rel=1e-15)


def test_a_normal_is_brought_near_1_however_far_apart_its_two_numbers_lie():
    a = sv.Polygon([(0, 0), (1e300, 5e-324), (0, 1e300)])
    found = [axis for choose in (axes.needed, axes.centers) for axis in choose(a, sv.Circle((-1e300, -5e-324), 1)).axes]
    assert all(0.25 <= axis.length <= 2 for axis in found)
    assert any(0 < axis.normal.x < 1e-300 for axis in found)


SOURCES = [
    axes.Source("guess"),
    axes.Source("guess", "A", (0, 1)),
    axes.Source(axes.EDGE, None, (0, 1)),
    axes.Source(axes.EDGE, "C", (0, 1)),
    axes.Source(axes.EDGE, "A", (0,)),
    axes.Source(axes.EDGE, "A", (0, 1, 2)),
    axes.Source(axes.EDGE, "A", (1, 1)),
    axes.Source(axes.EDGE, "A", (0, 3)),
    axes.Source(axes.HULL, None, (0, 1)),
    axes.Source(axes.HULL, "A", (0,)),
    axes.Source(axes.VERTEX, None, (0,)),
    axes.Source(axes.VERTEX, "A", ()),
    axes.Source(axes.VERTEX, "A", (0, 1)),
    axes.Source(axes.WORLD, "A", (0,)),
    axes.Source(axes.WORLD, "C", (0,)),
    axes.Source(axes.WORLD),
    axes.Source(axes.WORLD, None, (0, 1)),
    axes.Source(axes.WORLD, None, (2,)),
    axes.Source(axes.WORLD, None, (-1,)),
    axes.Source(axes.CENTERS, "A"),
    axes.Source(axes.CENTERS, None, (0,)),
    axes.Source(axes.CENTROIDS, "A"),
    axes.Source(axes.CENTROIDS, None, (0,)),
    axes.Source(axes.ANY, "B"),
    axes.Source(axes.ANY, None, (0,)),
    axes.Source(axes.GIVEN),
    axes.Source(axes.GIVEN, "A", (0,)),
]


@pytest.mark.parametrize("source", SOURCES, ids=str)
def test_a_source_that_the_shapes_do_not_have_is_rejected(source):
    assert source not in axes.axes_by_source(A, COIN)


def sources(choice: axes.Choice) -> dict:
    return {axis.source.ids: axis.normal for axis in choice.axes}


def test_an_axis_source_lists_the_edges_vertex_numbers_in_ascending_order():
    clockwise = sv.Polygon([(0, 0), (0, 2), (0, 2), (0, 4), (4, 4), (4, 0)])  # with a repeat and a straight-on vertex
    expected = {(0, 3): (4, 0), (3, 4): (0, 4), (4, 5): (4, 0), (0, 5): (0, 4)}
    assert sources(axes.edge_normals_of_a(clockwise, COIN)) == expected
    assert sources(axes.edge_normals_of_b(COIN, clockwise)) == expected
    assert sources(axes.hull_normals(clockwise, COIN)) == expected


def test_the_hull_distinguishes_edges_of_the_outline_from_those_across_a_notch():
    for first in range(6):
        turned = sv.Polygon([*L.vertices[first:], *L.vertices[:first]])
        found = axes.hull_normals(A, turned).axes
        across = [axis for axis in found if axis.source.kind == axes.HULL]
        assert [axis.source.kind for axis in found].count(axes.EDGE) == 4 + 3
        assert [axis.normal for axis in across] == [(2, 2)]
        assert {turned.vertices[i] for i in across[0].source.ids} == {(4, 2), (2, 4)}


def test_collinear_teeth_make_one_edge_of_the_hull():
    comb = sv.Polygon([(0, 0), (8, 0), (8, 4), (6, 1), (4, 4), (2, 1), (0, 4)])
    found = {axis.source.ids: axis.source.kind for axis in axes.hull_normals(comb, COIN).axes}
    assert found == {(0, 1): axes.EDGE, (1, 2): axes.EDGE, (2, 6): axes.HULL, (0, 6): axes.EDGE}


def test_the_normals_of_a_shape_are_computed_once():
    shape = sv.Polygon(A.vertices)
    assert axes.edge_normals_of_a(shape, B).axes[0] is axes.edge_normals_of_a(shape, COIN).axes[0]
    assert axes.edge_normals_of_a(shape, B).axes[0] != axes.edge_normals_of_b(B, shape).axes[0]


# -- choices ---------------------------------------------------------------------------------------


def test_a_star_import_provides_every_choice_and_the_types_of_choices():
    choices = {choose.__name__ for choose in axes.NAMED.values()}
    assert set(axes.__all__) == choices | {"Axis", "Choice", "Skip", "Source", "directions"}


def test_upright_boxes_need_y_and_x_and_each_side_names_its_parallel_axis():
    choice = axes.needed(*PAIRS["boxes"])
    assert choice.axes == axes.WORLD_AXES and choice.complete
    reasons = {(axis.source.shape, axis.direction, why, number) for axis, why, number in choice.skipped}
    up, right = (0, 1), (1, 0)
    assert reasons == {(who, way, axes.PARALLEL, i) for who in "AB" for way, i in ((up, 1), (right, 2))}
    assert len(choice.skipped) == 8


def test_a_box_beside_another_polygon_gives_its_own_normals():
    choice = axes.needed(box(0, 0, 2, 1), B)
    assert [axis.source.shape for axis in choice.axes] == ["B"] * 3 + ["A"] * 2
    assert [skip[1:] for skip in choice.skipped] == [(axes.PARALLEL, 4), (axes.PARALLEL, 5)]


def test_an_axis_to_the_nearest_vertex_is_skipped_where_an_edge_normal_is_parallel():
    choice = axes.needed(box(0, 0, 2, 2), sv.Circle((2, 5), 1))
    assert len(choice.axes) == 2 and choice.complete
    axis, why, number = choice.skipped[-1]
    assert axis.source == (axes.VERTEX, "A", (2,)) and axis.normal == (0, 3)
    assert (why, number) == (axes.PARALLEL, 1) and choice.axes[0].direction == (0, 1)


@pytest.mark.parametrize(("x", "y", "nearest"), [(-1, -1, 0), (5, -2, 1), (4, 4, 2), (-1, 9, 3)])
def test_the_nearest_vertex_is_the_nearest(x, y, nearest):
    ring, coin = box(0, 0, 4, 3), sv.Circle((x, y), 0.5)
    for choice, role in ((axes.nearest_vertex(ring, coin), "A"), (axes.nearest_vertex(coin, ring), "B")):
        (axis,) = choice.axes
        vx, vy = ring.vertices[nearest]
        assert axis.source == (axes.VERTEX, role, (nearest,))
        assert axis.normal in ((x - vx, y - vy), (vx - x, vy - y))
        assert not choice.complete and not choice.skipped


def test_nearest_vertex_has_no_axis_without_a_circle_or_without_a_polygon_or_without_a_direction():
    assert axes.nearest_vertex(A, B) == axes.nearest_vertex(COIN, COIN) == axes.Choice(())
    choice = axes.nearest_vertex(A, sv.Circle((3, 2), 1))
    assert choice.axes == () and choice.skipped[0][1:] == (axes.NO_DIRECTION, None)
    assert choice.skipped[0].axis == ((1, 0), 1, (axes.VERTEX, "A", (1,)))


@pytest.mark.parametrize("pair", PAIRS)
def test_exactly_the_known_choices_of_axes_are_complete(pair):
    a, b = PAIRS[pair]
    complete = {name for name, choose in axes.NAMED.items() if choose(a, b).complete}
    assert (
        complete
        == {
            "triangles": {"needed", "edge-normals", "hull-normals"},
            "concave": set(),
            "box and triangle": {"needed", "edge-normals", "hull-normals"},
            "triangle and box": {"needed", "edge-normals", "hull-normals"},
            "boxes": {"needed", "edge-normals", "hull-normals", "world"},
            "polygon and circle": {"needed"},
            "circle and concave": set(),
            "circle on a vertex": {"needed", "edge-normals", "edge-normals-of-b", "hull-normals"},
            "circles": {"needed", "centers"},
            "concentric": {"needed", "centers"},
        }[pair]
    )


def test_the_axis_through_coinciding_centers_is_arbitrary():
    assert axes.centers(COIN, sv.Circle((-1, 4), 2)).axes[0] == ((6, 2), hypot(6, 2), (axes.CENTERS, None, ()))
    assert axes.centers(COIN, sv.Circle((5, 6), 2)).axes == (((1, 0), 1, (axes.ANY, None, ())),)
    assert axes.centers(box(0, 0, 2, 2), box(3, 0, 5, 4)).axes[0] == ((3, 1), hypot(3, 1), (axes.CENTROIDS, None, ()))
    assert axes.centers(box(0, 0, 2, 2), sv.Circle((1, 1), 4)).axes[0].source.kind == axes.ANY


def test_normals_of_one_shape_have_that_shape_as_source():
    assert {axis.source.shape for axis in axes.edge_normals_of_a(A, B).axes} == {"A"}
    assert {axis.source.shape for axis in axes.edge_normals_of_b(A, B).axes} == {"B"}
    assert [axis.source.shape for axis in axes.edge_normals(A, B).axes] == ["B"] * 3 + ["A"] * 3
    assert axes.edge_normals_of_a(COIN, B).axes == ()


def test_given_directions_keep_their_orientation_and_their_number():
    found = axes.directions((1, 2), (-3, 0.25), (0, -1))(A, B)
    assert [axis.normal for axis in found.axes] == [(1, 2), (-3, 0.25), (0, -1)]
    assert [axis.source for axis in found.axes] == [(axes.GIVEN, None, (i,)) for i in range(3)]
    assert not found.complete
    with pytest.raises(ValueError, match=r"direction 1 is \(0, 0\)"):
        axes.directions((1, 0), (0, 0))


@pytest.mark.parametrize("vector", [(1e300, 5e-324), (5e-324, -1e300), (1.7e308, 3e-310), (5e-324, 0), (2.0**1000, 3)])
def test_a_direction_keeps_both_its_components_at_every_size(vector):
    (axis,) = axes.directions(vector)(A, B).axes
    (nx, ny), (x, y) = map(Fraction, axis.normal), map(Fraction, vector)
    assert nx * y == ny * x and nx * x + ny * y > 0


def test_the_gap_on_a_given_direction_is_measured_along_exactly_that_direction():
    a, b = sv.Polygon([(0, 0), (1, 0), (0, 1)]), sv.Polygon([(1 - 2**-53, 1e308), (3, 1e308), (3, 1.5e308)])
    (test,) = axis_tests(a, b, axes.directions((1e300, 5e-324))(a, b).axes)
    assert test.gap == -(2.0**-53)


def test_a_direction_of_any_length_is_accepted():
    for vector in ((5e-324, 0), (0, -1.7e308), (1e300, 1e-300), (-5e-324, 1.7e308)):
        (axis,) = axes.directions(vector)(A, B).axes
        assert axis.direction == pytest.approx([c / max(map(abs, vector)) for c in vector])
