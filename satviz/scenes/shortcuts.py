"""The shortcuts as people take them: each the one loop with other axes, or with one step done otherwise.

What a changed step measures is plain floats, as its believers write it: positive apart, negative by the depth.
"""

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from math import copysign, hypot

from ..engine.axes import (
    CENTERS,
    CENTROIDS,
    EDGE,
    SLIP,
    WORLD_AXES,
    Axis,
    Choice,
    Source,
    centers,
    edge_normals,
    edge_normals_of_a,
    hull_normals,
    needed,
    world,
)
from ..engine.convex_parts import parts
from ..engine.geometry import Vec
from ..engine.sat import AxisTest, Projection, project
from ..engine.shapes import Circle, Polygon, Shape, centroid
from ..engine.shortcut import Shortcut

Y, X = WORLD_AXES
FAR = 5.0  # from here on the programmer of far-centers calls two centers far apart


# -- other axes


def only_y(a: Shape, b: Shape) -> Choice:
    """y alone."""
    return Choice((Y,))


def only_x(a: Shape, b: Shape) -> Choice:
    """x alone."""
    return Choice((X,))


def open_outlines(a: Shape, b: Shape) -> Choice:
    """The normals without those of the edges from the last vertex back to the first."""
    return Choice(tuple(axis for axis in edge_normals(a, b).axes if not _closes(axis, a, b)))


def half_the_normals(a: Shape, b: Shape) -> Choice:
    """The normals of the first half of each outline's edges."""
    kept = []
    for axis in edge_normals(a, b).axes:
        half = len((a if axis.source.shape == "A" else b).vertices) // 2
        if not _closes(axis, a, b) and axis.source.ids[0] < half:
            kept.append(axis)
    return Choice(tuple(kept))


def _closes(axis: Axis, a: Shape, b: Shape) -> bool:
    return axis.source.ids == (0, len((a if axis.source.shape == "A" else b).vertices) - 1)


def slipped_normals(a: Shape, b: Shape) -> Choice:
    """Of each edge (dx, dy) the direction (dx, -dy) instead of the normal (dy, -dx)."""
    found = []
    for axis in edge_normals(a, b).axes:
        x, y = axis.normal.y, axis.normal.x  # the normal is (dy, -dx) or its opposite
        turned = Vec(x, y) if (x, y) > (0, 0) else Vec(-x + 0.0, -y + 0.0)
        found.append(Axis(turned, axis.length, axis.source._replace(kind=SLIP)))
    return Choice(tuple(found))


def every_edge(a: Shape, b: Shape) -> Choice:
    """The normals of all edges, also (0, 0) of one between two vertices in the same place."""
    axes = list(edge_normals(a, b).axes)
    for role, points in ("B", b.vertices), ("A", a.vertices):
        for i, (p, q) in enumerate(pairwise(points)):
            if p == q:
                axes.append(Axis(Vec(0.0, 0.0), 1.0, Source(EDGE, role, (i, i + 1))))
    return Choice(tuple(axes))


def centers_first(a: Shape, b: Shape) -> Choice:
    """The axis through both centers, and then all that the pair needs."""
    return Choice((*centers(a, b).axes, *needed(a, b).axes))


def faces_from_above(a: Shape, b: Shape) -> Choice:
    """Of the two boxes in space, seen from above: the normals of those faces that stand upright."""
    of_b = (axis for axis in edge_normals(a, b).axes if axis.source[1:] in (("B", (0, 1)), ("B", (2, 3))))
    return Choice((*edge_normals_of_a(a, b).axes, *of_b))


# -- other ranges


def four_extremes(a: Shape, b: Shape, axis: Axis) -> AxisTest:
    """Only the vertices that are extreme in x or in y are projected."""

    def few(shape: Shape) -> Projection:
        whole = project(shape, axis)
        x0, y0, x1, y1 = shape.bounds
        at = [i for i, (x, y) in enumerate(whole.points) if shape.core_is_point or x in (x0, x1) or y in (y0, y1)]
        return Projection(tuple(whole.points[i] for i in at), tuple(whole.landings[i] for i in at))

    return _measured(axis, few(a), few(b))


def mixed_signs(a: Shape, b: Shape, axis: Axis) -> AxisTest:
    """A is projected on the normal, B on its opposite."""
    p, q = project(a, axis), project(b, axis)
    return _measured(axis, p, q._replace(landings=tuple(-t + 0.0 for t in q.landings)))


def without_signs(a: Shape, b: Shape, axis: Axis) -> AxisTest:
    """Landing places as lengths."""
    p, q = (side._replace(landings=tuple(map(abs, side.landings))) for side in (project(a, axis), project(b, axis)))
    return _measured(axis, p, q)


def unit_normals(a: Shape, b: Shape, axis: Axis) -> AxisTest:
    """The normal is first brought to length 1, which rounds it."""
    return _measured(axis, *(_dropped(shape, axis.direction) for shape in (a, b)))


def raw_normals(a: Shape, b: Shape, axis: Axis) -> AxisTest:
    """The normal as it comes: landing places in units of its length."""
    return _measured(axis, *(_dropped(shape, axis.normal) for shape in (a, b)))


def on_paper(a: Shape, b: Shape, axis: Axis) -> AxisTest:
    """The decimals that people write, where 0.1 + 0.2 is 0.3, instead of the floats they become."""
    p, q = project(a, axis), project(b, axis)
    if a.core_is_point or b.core_is_point:
        return _measured(axis, p, q)
    (x, y), length = map(Fraction, axis.normal), axis.length
    dots = [[u * x + v * y for u, v in written(shape)] for shape in (a, b)]
    gap = max(min(dots[0]) - max(dots[1]), min(dots[1]) - max(dots[0]))
    p, q = (Projection(s.vertices, tuple(float(t) / length for t in d)) for s, d in zip((a, b), dots, strict=True))
    return AxisTest(axis, p, q, float(gap) / length)


def within_reach(a: Shape, b: Shape, axis: Axis) -> AxisTest:
    """On the axis through the centers each shape is taken to reach FAR / 2 from its own."""
    if axis.source.kind not in (CENTERS, CENTROIDS):
        return _measured(axis, project(a, axis), project(b, axis))
    return _measured(axis, *(project(Circle(centroid(s), FAR / 2), axis) for s in (a, b)))


# -- another gap


def turned_round(a: Shape, b: Shape, axis: Axis) -> AxisTest:
    """The comparison the wrong way round: what the distance exceeds the radii by is taken for the overlap."""
    test = _measured(axis, project(a, axis), project(b, axis))
    return test._replace(gap=-test.gap)


def flat_overlap(a: Shape, b: Shape, axis: Axis) -> AxisTest:
    """From the larger minimum to the smaller maximum, which is no way out where one range holds the other."""
    p, q = project(a, axis), project(b, axis)
    return AxisTest(axis, p, q, max(p.interval.lo, q.interval.lo) - min(p.interval.hi, q.interval.hi))


def _measured(axis: Axis, a: Projection, b: Projection) -> AxisTest:
    return AxisTest(axis, a, b, a.interval.gap(b.interval))


def _dropped(shape: Shape, n: Vec) -> Projection:
    """Where the points land in units of n's length."""
    if shape.core_is_point:
        ((x, y),), length = shape.core, hypot(*n)
        ends = project(shape, Axis(n, length or 1.0, Source(""))).points  # on (0, 0) both are the center
        at, r = x * n.x + y * n.y, shape.radius * length
        return Projection(ends, (at - r, at + r))
    return Projection(shape.core, tuple(x * n.x + y * n.y for x, y in shape.core))


def written(shape: Shape) -> list[tuple[Fraction, Fraction]]:
    """The vertices as Fractions of the decimals that a person would write; none of a circle."""
    return [(Fraction(f"{x:.12g}"), Fraction(f"{y:.12g}")) for x, y in shape.vertices]


# -- another way out


def push_from_center(a: Shape, b: Shape, tests: Sequence[AxisTest]) -> Vec:
    """The right axis and depth, in the direction from A's middle to B's."""
    if not tests:
        return Vec(0.0, 0.0)
    test = max(tests, key=lambda test: test.gap)
    (px, py), (qx, qy), n = middle(a), middle(b), test.axis.direction
    length = copysign(test.gap, n.x * (qx / 2 - px / 2) + n.y * (qy / 2 - py / 2))  # as halves: none overflows
    return Vec(n.x * length, n.y * length)


def middle(shape: Shape) -> Vec:
    """The mean of the vertices; a circle's center."""
    points = shape.vertices or shape.core
    return Vec(sum(x / len(points) for x, _ in points), sum(y / len(points) for _, y in points))


def halves(shape: Shape) -> Sequence[Shape]:
    """Cut along the diagonal from its first vertex to the middle one; a concave one in its convex parts."""
    if isinstance(shape, Circle) or not shape.is_convex:
        return parts(shape)
    points, k = shape.corners, len(shape.corners) // 2
    rings = points[: k + 1], (*points[k:], points[0])
    return [Polygon(ring) for ring in rings if len(ring) > 2]


def tiles(shape: Shape) -> Sequence[Shape]:
    """An upright box as two tiles side by side; any other shape in its convex parts."""
    if not shape.is_upright_box:
        return parts(shape)
    x0, y0, x1, y1 = shape.bounds
    seam = (x0 + x1) / 2
    return [Polygon([(p, y0), (q, y0), (q, y1), (p, y1)]) for p, q in ((x0, seam), (seam, x1))]


_ALL = (
    Shortcut("aabb-not-upright", "nothing is rotated, so the bounding boxes decide", world),
    Shortcut("aabb-turned", "the bounding boxes of turned shapes meet, so the shapes do", world),
    Shortcut("one-overlap", "the ranges overlap on one axis, so the shapes collide", only_y),
    Shortcut("line-for-axis", "the line between them runs along y, so y is the axis", only_y),
    Shortcut("only-one-axis", "of all directions exactly one separates them"),
    Shortcut("one-shapes-normals", "the normals of one shape are enough", edge_normals_of_a),
    Shortcut("no-area", "a rod is a polygon like any other"),
    Shortcut("repeated-vertex", "a vertex listed twice does no harm", every_edge, raw_normals),
    Shortcut("pentagram", "it turns left at every vertex, so it is convex"),
    Shortcut(
        "extremes-once", "the extreme vertices in x and y are the extremes on every axis", edge_normals, four_extremes
    ),
    Shortcut("open-outline", "each vertex taken from the next gives all edges", open_outlines),
    Shortcut("mixed-signs", "a normal or its opposite, for each shape as it comes", edge_normals, mixed_signs),
    Shortcut("unit-normals", "a normal must first be brought to length 1", edge_normals, unit_normals),
    Shortcut("raw-depth", "the depth can be read off with normals of any length", edge_normals, raw_normals),
    Shortcut("lengths", "a landing place is a length, so it has no sign", needed, without_signs),
    Shortcut("one-maximum", "on any axis one vertex is the furthest", edge_normals, unit_normals),
    Shortcut("touch-on-paper", "what touches on paper touches in the computer", needed, on_paper),
    Shortcut("circles-turned-round", "circles collide if the radii's sum is below the distance", needed, turned_round),
    Shortcut("no-nearest-vertex", "for a circle, too, the polygon's normals are enough", edge_normals),
    Shortcut("dart", "a concave shape's edge normals find every gap there is", edge_normals),
    Shortcut("box-in-u", "no direction shows a gap, so these two collide", hull_normals),
    Shortcut("sum-of-parts", "the ways out of all the parts, added up, lead out of the whole", split=halves),
    Shortcut("half-the-normals", "opposite edges are parallel, so half the normals will do", half_the_normals),
    Shortcut("same-shape", "two squares have the same normals, so one's will do", edge_normals_of_a),
    Shortcut("far-centers", "the centers are far apart, so the shapes are", centers_first, within_reach),
    Shortcut("many-pairs", "a thousand shapes, a thousand tests: threads will do it"),
    Shortcut("faces-in-3d", "for boxes in space the face normals are enough", faces_from_above),
    Shortcut("gjk-looks-less", "GJK always has less to look at"),
    Shortcut("push-from-center", "the way out is away from the other's center", push=push_from_center),
    Shortcut("range-inside", "the overlap runs from the larger minimum to the smaller maximum", needed, flat_overlap),
    Shortcut("gap-as-distance", "the gap on an axis is the distance", only_x),
    Shortcut("tunnelling", "clear in this frame and the next, so clear in between"),
    Shortcut("slipped-normal", "the normal of an edge (dx, dy) is (dx, -dy)", slipped_normals),
    Shortcut("touch-as-apart", "with < or with <=, the test says the same", touching_separates=True),
    Shortcut("tile-seam", "each tile of a floor pushes out what sinks into it", split=tiles),
)
NAMED = {shortcut.name: shortcut for shortcut in _ALL}
