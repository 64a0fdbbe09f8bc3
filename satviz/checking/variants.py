"""Variants of known mistakes: (name of the failing case, function that answers for two shapes, how it is written)."""

from collections.abc import Callable, Iterator
from functools import partial
from math import floor
from operator import itemgetter

from ..engine.axes import edge_normals
from ..engine.geometry import Relation, Vec
from ..engine.shapes import Shape
from ..scenes.failing import NAMED
from .other_methods import (
    beyond_reach,
    box_and_circle,
    by_shortcut,
    center_outside,
    corner_or_center,
    corners_in,
    edges_cross,
    first_corner_in,
    middle_inside,
    nearest_corner,
    normals_and_centers,
    outward_from_each_middle,
    push_along_centers,
    raw_radius,
    reversed_verdict,
    rims_meet,
    squared_distance,
    with_circle,
    within_reach,
)
from .written import (
    FIXED_REACHES,
    LARGE_RADII,
    SMALL_RADII,
    Radius,
    Ring,
    Written,
    a_before_b,
    about_the_mean,
    along_normal,
    angle_in_degrees,
    between,
    both_from_zero,
    by_an_end_of_a,
    by_an_end_of_b,
    by_direction,
    circle_about,
    from_middle,
    from_zero,
    half_is_whole,
    listed,
    mean,
    middle_of_box,
    normal,
    of_each,
    of_vertices,
    of_world,
    one_edge,
    one_extreme_each,
    one_for_equal_counts,
    outward,
    rounded_landings,
    rounded_to,
    shortened,
    some_vertices,
    twice_as_wide,
)

Predict = Callable[[Shape, Shape], tuple[Relation, Vec | None]]  # the claimed relation, and the push of B
Variant = tuple[str, Predict, str]


def _chosen_edges() -> Iterator[Variant]:
    """Yield the mistakes that leave out axes, or take others."""
    half, one, opened = "half-the-normals", "one-overlap", "open-outline"
    cuts: tuple[tuple[str, Callable[[int], slice], str], ...] = (
        (half, lambda count: slice((count + 1) // 2), "here half of them, rounded up"),
        (half, lambda count: slice(None, None, 2), "here every second one"),
        (half, lambda count: slice(2), "here the first two of each shape"),
        (half, lambda count: slice(1), "here the first of each shape"),
        (opened, lambda count: slice(1, count), "here without the first edge"),
    )
    for name, cut, words in cuts:
        yield name, Written(partial(of_each, cut)), words
    yield opened, Written(partial(listed, cut_a=slice(-1))), "here for A alone"
    yield opened, Written(partial(listed, cut_b=slice(-1))), "here for B alone"
    yield "one-shapes-normals", Written(partial(listed, cut_a=slice(0))), "here those of B"
    yield "same-shape", Written(one_for_equal_counts), "here for shapes with equally many corners"
    yield one, Written(lambda a, b: of_world(a, b)[:1]), "here on the x axis"
    yield one, Written(partial(one_edge, 0)), "here on the normal of the first edge"
    yield one, Written(partial(one_edge, -1)), "here on the normal of the last edge"
    yield one, Written(lambda a, b: listed(a, ())[-1:]), "here on the normal of the edge to A's first vertex"
    yield one, Written(lambda a, b: listed((), b)[-2:-1]), "here on the normal of the edge to B's last vertex"
    for in_order in False, True:
        yield one, Written(any_axis=True, in_order=in_order), "here on any one of them"
    for middle in mean, middle_of_box:
        yield one, Written(partial(between, middle)), "here on the line between the middles"
    along = "here an edge is taken as an axis, without the quarter turn"
    yield "line-for-axis", Written(partial(listed, normal_of=Vec)), along
    yield "line-for-axis", Written(partial(of_vertices, Vec)), "here the way to each vertex"
    yield "slipped-normal", Written(partial(of_vertices, normal)), "here of each vertex instead of each edge"
    yield (
        "slipped-normal",
        Written(partial(listed, normal_of=lambda x, y: Vec(y, x))),
        "here (dy, dx), without the minus",
    )
    yield "degrees-for-radians", Written(partial(listed, normal_of=angle_in_degrees)), "here the whole angle in degrees"
    roundings: tuple[tuple[Callable[[float], float], str], ...] = (
        (round, ""),
        (partial(round, ndigits=1), "here to 1 digit"),
        (partial(round, ndigits=2), "here to 2 digits"),
        (int, "here the digits are cut off"),
        (floor, "here down"),
    )
    for rounding, words in roundings:
        for power in 0, 1:
            rounded = Written(partial(listed, normal_of=partial(rounded_to, rounding)), powers=(0, power))
            yield "rounded-normals", rounded, words


def _measured() -> Iterator[Variant]:
    """Yield the mistakes in a range on an axis, or in the overlap of two ranges."""
    for axes, words in (
        (partial(listed, sign=1), "here on the normal of each edge"),
        (partial(listed, sign=-1), "here on the normal of each edge"),
        (of_world, "here on x and y"),
    ):
        yield "start-at-zero", Written(axes, from_zero), words
        yield "one-sided-gap", Written(axes, overlap=a_before_b), words
    yield "start-at-zero", Written(ends=both_from_zero), "here the search for the smallest, too"
    yield "bounding-circles", Written(ends=about_the_mean), "here on each axis, about the middle of each range"
    yield "corner-inside", Written(overlap=by_an_end_of_a), "here an end of A's range in B's, on each axis"
    yield "corner-inside", Written(overlap=by_an_end_of_b), "here an end of B's range in A's, on each axis"
    for middle, radius in (*LARGE_RADII, *SMALL_RADII):
        yield "bounding-circles", Written(partial(between, middle), partial(circle_about, middle, radius)), ""
    for step in (1, -1):
        yield "extremes-once", Written(ends=partial(one_extreme_each, step)), ""
    yield "extremes-once", Written(ends=partial(some_vertices, slice(-1))), "here without the last vertex"
    yield "extremes-once", Written(ends=partial(some_vertices, slice(1, None))), "here without the first vertex"
    for round_to in round, int, floor:
        yield "rounded-normals", Written(ends=partial(rounded_landings, round_to)), "here the landing places"
    for slop in 0.1, 0.25, 0.5, 1.0:
        yield "touch-as-apart", Written(ends=partial(shortened, slop)), f"here with a tolerance of about {slop:g}"
    yield "integer-halves", Written(of_world, partial(half_is_whole, False)), "here beside an exact middle"
    for whole_middle in True, False:
        yield "integer-halves", Written(ends=partial(half_is_whole, whole_middle)), "here on each axis"
    yield "aabb-not-upright", Written(of_world, twice_as_wide), "here with the whole widths for half of them"


def _pushed() -> Iterator[Variant]:
    """Yield the mistakes in the choice of the push."""
    late = "here divided only after the axis was chosen"
    yield "raw-depth", Written(powers=(0, 2)), late
    yield "raw-depth", Written(powers=(0, 0)), "here the normal of the move is as long as its edge, too"
    yield "raw-depth", Written(powers=(1, 1)), "here the normal of the move is as long as its edge"
    for power in 3, 4:
        yield "raw-depth", Written(powers=(2, power)), "here divided by the square of the length"
    yield "largest-overlap", Written(pick=-1), ""
    for axes in listed, lambda a, b: listed(b, a):
        yield "largest-overlap", Written(axes, pick=-1, in_order=True), "here along the last axis"
        yield "largest-overlap", Written(axes, pick=0, in_order=True), "here along the first axis"
    for sign in 1, -1:
        for axes in listed, by_direction:
            yield "push-along-normal", Written(axes, way=partial(along_normal, sign)), ""
        as_listed = Written(partial(outward, sign), way=partial(along_normal, 1))
        yield "push-along-normal", as_listed, "here away from the shape with the edge, in one order of the vertices"
        as_listed = Written(partial(outward, sign), overlap=a_before_b, way=partial(along_normal, 1))
        yield "one-sided-gap", as_listed, "here away from the shape with the edge, in one order of the vertices"
    for middle, words in (
        (middle_of_box, "here from the middle of the bounding box"),
        (itemgetter(0), "here from the first vertex"),
    ):
        yield "push-from-center", Written(way=partial(from_middle, middle)), words


def _other_ways() -> Iterator[Variant]:
    """Yield the mistakes of other methods than SAT."""
    yield "corner-inside", middle_inside, "here the middle of one"
    yield "corner-inside", partial(corners_in, "B"), "here a corner of A in B alone"
    yield "corner-inside", partial(corners_in, "A"), "here a corner of B in A alone"
    yield "corner-inside", first_corner_in, "here the first corner of one"
    for gap_of, words in (
        (nearest_corner, "here a corner in the circle"),
        (center_outside, "here the center of the circle in the polygon"),
        (corner_or_center, "here the center of the circle, too"),
    ):
        yield "corner-inside", partial(with_circle, gap_of), words
    yield "aabb-not-upright", partial(with_circle, box_and_circle), "here beside a circle"
    yield (
        "no-nearest-vertex",
        partial(with_circle, raw_radius),
        "here with a radius that is not scaled like the normals",
    )
    to_center = NAMED["no-nearest-vertex"].shortcut._replace(choose=normals_and_centers)
    yield "no-nearest-vertex", partial(by_shortcut, to_center), "here the line of the centers, too"
    yield "edges-cross", rims_meet, "here the rims of circles"
    for strict, words in ((False, "here by the signs of their turns"), (True, "here at a point inside both edges")):
        yield "edges-cross", partial(edges_cross, strict), words
    yield "circles-turned-round", squared_distance, "here the squared distance is compared"
    yield "circles-turned-round", reversed_verdict, "here the whole verdict, for shapes of any kind"
    from_each_middle = NAMED["mixed-signs"].shortcut._replace(choose=edge_normals, measure=outward_from_each_middle)
    yield "mixed-signs", partial(by_shortcut, from_each_middle), "here away from the middle of each shape"
    along_line = NAMED["push-from-center"].shortcut._replace(push=push_along_centers)
    yield "push-from-center", partial(by_shortcut, along_line), "here along the line between the middles"
    for middle, radius in SMALL_RADII:
        sum_of = partial(_sum_of, radius)
        yield "far-centers", partial(beyond_reach, middle, sum_of), "here further than the reach of both shapes"
    for middle, radius in LARGE_RADII:
        largest = partial(_largest, radius)
        yield "far-centers", partial(beyond_reach, middle, largest), "here further than the larger reach"
    for reach in FIXED_REACHES:
        fixed = partial(_fixed, float(reach))
        yield "far-centers", partial(beyond_reach, mean, fixed), f"here further than {reach}"
        yield "bounding-circles", partial(within_reach, mean, fixed), "here of one size for all shapes"


def _sum_of(radius: Radius, a: Ring, b: Ring) -> float:
    """Return the sum of both radii."""
    return radius(a) + radius(b)


def _largest(radius: Radius, a: Ring, b: Ring) -> float:
    """Return the larger radius."""
    return max(radius(a), radius(b))


def _fixed(reach: float, a: Ring, b: Ring) -> float:
    """Return the reach, whatever the shapes."""
    return reach


VARIANTS: tuple[Variant, ...] = (*_chosen_edges(), *_measured(), *_pushed(), *_other_ways())
