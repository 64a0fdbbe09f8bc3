"""Cases about outlines: no area, a repeated vertex, edges that cross, vertices or edges left out.

A function that returns a Choice chooses a shortcut's axes, and one of (a, b, axis) measures one of them.
"""

from collections.abc import Sequence
from functools import partial
from itertools import pairwise
from math import cos, hypot, radians, sin

from ...engine.axes import EDGE, Axis, Choice, Source, edge_normals
from ...engine.geometry import Interval, Vec
from ...engine.sat import AxisTest, Projection, project
from ...engine.shapes import Polygon, Shape
from ...engine.shortcut import Shortcut
from ..shape_tools import box, diamond
from .failure_case import DEPTH, FALSE_HIT, MISSED_HIT, REFUSED, WRONG_NUMBER, FailureCase, RawOutline
from .region_of_pushes import overlaps_in_raw_units, region_of_depth
from .wrong_steps import is_closing_edge, measured_test, raw_normals


def normals_of_every_edge(a: Shape, b: Shape) -> Choice:
    """Return the normals of all edges as a Choice; an edge of length 0 has the normal (0, 0)."""
    axes = list(edge_normals(a, b).axes)
    for role, points in ("B", b.vertices), ("A", a.vertices):
        for i, (p, q) in enumerate(pairwise(points)):
            if p == q:
                axes.append(Axis(Vec(0.0, 0.0), 1.0, Source(EDGE, role, (i, i + 1))))
    return Choice(tuple(axes))


def normals_of_open_outlines(a: Shape, b: Shape) -> Choice:
    """Return all edge normals, except those of the edges from the last vertex to the first, as a Choice."""
    return Choice(tuple(axis for axis in edge_normals(a, b).axes if not is_closing_edge(axis, a, b)))


def four_extremes(a: Shape, b: Shape, axis: Axis) -> AxisTest:
    """Return the test of an axis that projects only the vertices which are extreme in x or in y."""

    def project_extremes(shape: Shape) -> Projection:
        """Return the projection on the axis of those vertices that lie on the shape's bounding box."""
        whole = project(shape, axis)
        x0, y0, x1, y1 = shape.bounds
        at = [i for i, (x, y) in enumerate(whole.points) if shape.core_is_point or x in (x0, x1) or y in (y0, y1)]
        return Projection(tuple(whole.points[i] for i in at), tuple(whole.landings[i] for i in at))

    return measured_test(axis, project_extremes(a), project_extremes(b))


def edge_vectors(points: RawOutline) -> list[Vec]:
    """Return the vector of each edge, from a vertex to the next; the closing edge comes last."""
    return [Vec(q[0] - p[0], q[1] - p[1]) for p, q in zip(points, (*points[1:], points[0]))]


def largest_gap_unchecked(a: RawOutline, b: RawOutline) -> float:
    """Return the largest gap on all edge normals of two outlines, which may be invalid."""

    def interval(points: RawOutline, dx: float, dy: float) -> Interval:
        """Return the range of the points on the normal of the edge (dx, dy)."""
        landings = [(x * dy - y * dx) / hypot(dx, dy) for x, y in points]
        return Interval(min(landings), max(landings))

    return max(interval(a, *edge).gap(interval(b, *edge)) for edge in (*edge_vectors(b), *edge_vectors(a)))


def least_turn(a: RawOutline, b: RawOutline) -> float:
    """Return the smallest cross product of neighbouring edges of a, which the shortcut takes for convex if positive.

    b is not used.
    """
    edges = edge_vectors(a)
    return min(p.x * q.y - p.y * q.x for p, q in zip(edges, (*edges[1:], edges[0])))


PENTAGRAM: Sequence[tuple[float, float]] = [(cos(radians(90 + 144 * i)), sin(radians(90 + 144 * i))) for i in range(5)]

CASES = (
    FailureCase(
        Shortcut("no-area", "a rod is a polygon like any other"),
        REFUSED,
        ([(0, 0), (1, 0), (0.5, 0)], [(2, 0), (3, 0), (2.5, 0)]),
        unchecked_value=largest_gap_unchecked,
        unchecked_words="all edges have one normal, on which all points land in one place: {}, a hit",
    ),
    FailureCase(
        Shortcut("repeated-vertex", "a vertex listed twice does no harm", normals_of_every_edge, raw_normals),
        WRONG_NUMBER,
        (Polygon([(0, 0), (1, 0), (1, 0), (1, 1), (0, 1)]), box(0.5, 0.25, 1.5, 1.25)),
        **DEPTH,
        error_region=partial(region_of_depth, choose=normals_of_every_edge, measure=overlaps_in_raw_units),
    ),
    FailureCase(
        Shortcut("pentagram", "it turns left at every vertex, so it is convex"),
        REFUSED,
        (PENTAGRAM, [(0.5, 0), (1.5, 0), (1.5, 1), (0.5, 1)]),
        quantity="least edge × next edge",
        unchecked_value=least_turn,
        unchecked_words="every turn is to the left ({}), so it passes for convex, though it goes round twice",
    ),
    FailureCase(
        Shortcut(
            "extremes-once",
            "the extreme vertices in x and y are the extremes on every axis",
            edge_normals,
            four_extremes,
        ),
        MISSED_HIT,
        (Polygon([(-3, -1), (1, -3), (3, 1), (2.2, 2.6), (1, 3), (-3, 1)]), diamond(3.2, 3.2, 2.2)),
    ),
    FailureCase(
        Shortcut("open-outline", "each vertex taken from the next gives all edges", normals_of_open_outlines),
        FALSE_HIT,
        (Polygon([(6, 4), (5, 0), (0, 1)]), Polygon([(0, 3), (1, 6), (2, 4)])),
    ),
)
