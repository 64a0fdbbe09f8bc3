"""The shortcuts as people write them: plain floats, each with the one flaw that its row is about.

A shortcut takes the two shapes and gives a number; a gap is positive apart, negative by
the depth, as everywhere.  Outlines may also be plain vertices, for shapes the
engine refuses.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from fractions import Fraction
from math import atan2, degrees, hypot, nan

from ...engine.geometry import Interval, Vec
from ...engine.shapes import Circle, Polygon, Shape, centroid
from . import swept, threed

Ring = Sequence[tuple[float, float]]
Outline = Shape | Ring
Shortcut = Callable[[Outline, Outline], float]
X, Y = Vec(1.0, 0.0), Vec(0.0, 1.0)
MANY = 1000
FAR = 5.0  # from here on the programmer of row 25 calls two centers far apart


# -- what every shortcut is made of


def as_shape(outline: Outline) -> Shape:
    """The outline as the engine takes it; InvalidShape where it refuses."""
    return outline if isinstance(outline, Polygon | Circle) else Polygon(outline)


def ring(shape: Outline) -> Ring:
    """The vertices in the owner's order; none of a circle."""
    return shape.vertices if isinstance(shape, Polygon | Circle) else shape


def edges(points: Ring) -> Iterator[Vec]:
    """Each vertex taken from the next, the closing edge last."""
    return (Vec(q[0] - p[0], q[1] - p[1]) for p, q in zip(points, (*points[1:], points[0])))


def normals(shape: Outline) -> list[Vec]:
    """The edge normals, as long as their edges; none of a circle."""
    points = ring(shape)
    return [Vec(dy, -dx) for dx, dy in edges(points)] if points else []


def both_normals(a: Outline, b: Outline) -> list[Vec]:
    """The edge normals of both shapes."""
    return [*normals(a), *normals(b)]


def dots(shape: Outline, n: Vec) -> list[float]:
    """Where the vertices land on an axis, in units of its length; a circle's two extremes."""
    if isinstance(shape, Circle):
        at, r = shape.center.x * n[0] + shape.center.y * n[1], shape.radius * hypot(*n)
        return [at - r, at + r]
    return [x * n[0] + y * n[1] for x, y in ring(shape)]


def span(shape: Outline, n: Vec) -> Interval:
    """The range on an axis, in units of its length."""
    landings = dots(shape, n)
    return Interval(min(landings), max(landings))


def raw_gap(a: Outline, b: Outline, n: Vec) -> float:
    """The gap in units of the axis's length: good for its sign only."""
    return span(a, n).gap(span(b, n))


def gap(a: Outline, b: Outline, n: Vec) -> float:
    """The gap in scene units."""
    return raw_gap(a, b, n) / hypot(*n)


def best(a: Outline, b: Outline, axes: Iterable[Vec]) -> float:
    """The largest gap on these axes."""
    return max(gap(a, b, n) for n in axes)


def textbook(a: Outline, b: Outline) -> float:
    """SAT as it should be, for polygons: the largest gap on all edge normals."""
    return best(a, b, both_normals(a, b))


# -- axes left out


def on_world_axes(a: Outline, b: Outline) -> float:
    """The largest gap on x and y alone."""
    return best(a, b, (X, Y))


def on_y(a: Outline, b: Outline) -> float:
    """The gap on y alone."""
    return gap(a, b, Y)


def on_x(a: Outline, b: Outline) -> float:
    """The gap on x alone."""
    return gap(a, b, X)


def on_a(a: Outline, b: Outline) -> float:
    """The largest gap on A's normals alone."""
    return best(a, b, normals(a))


def on_open_outlines(a: Outline, b: Outline) -> float:
    """Without the edge from the last vertex back to the first."""
    return best(a, b, [*normals(a)[:-1], *normals(b)[:-1]])


def on_half_the_normals(a: Outline, b: Outline) -> float:
    """The largest gap on the first half of each shape's normals."""
    return best(a, b, [n for s in (a, b) for n in normals(s)[: len(ring(s)) // 2]])


# -- wrong ranges


def with_four_extremes(a: Outline, b: Outline) -> float:
    """Only the vertices that are extreme in x or in y are projected."""

    def kept(shape: Outline) -> Ring:
        box = [end for n in (X, Y) for end in span(shape, n)]
        return [v for v in ring(shape) if v[0] in box[:2] or v[1] in box[2:]]

    few = kept(a), kept(b)
    return best(*few, both_normals(a, b))


def with_mixed_signs(a: Outline, b: Outline) -> float:
    """A is projected on each normal, B on its opposite."""
    return max(span(a, n).gap(span(b, Vec(-n[0], -n[1]))) / hypot(*n) for n in both_normals(a, b))


def with_lengths(a: Outline, b: Outline) -> float:
    """Landing places without their signs."""

    def lengths(shape: Outline, n: Vec) -> Interval:
        found = [abs(t) for t in dots(shape, n)]
        return Interval(min(found), max(found))

    return max(lengths(a, n).gap(lengths(b, n)) / hypot(*n) for n in both_normals(a, b))


# -- lengths of normals


def with_unit_normals(a: Outline, b: Outline) -> float:
    """Each normal is first brought to length 1, which rounds it."""
    return max(raw_gap(a, b, unit(n)) for n in both_normals(a, b))


def unit(n: Vec) -> Vec:
    """As NumPy divides: a zero edge gives NaN."""
    length = hypot(*n)
    return Vec(n[0] / length, n[1] / length) if length else Vec(nan, nan)


def extremes_of_b(a: Outline, b: Outline) -> float:
    """How many vertices are furthest along the normal of B's first edge, that normal being of length 1."""
    landings = dots(b, unit(Vec(*map(abs, normals(b)[0]))))
    return sum(t == max(landings) for t in landings)


# -- circles


def radii_below_distance(a: Outline, b: Outline) -> float:
    """The test as it is often quoted, turned round: sum of radii less than distance, and they collide."""
    return as_shape(a).radius + as_shape(b).radius - center_distance(a, b)


# -- numbers on paper


def on_paper(a: Outline, b: Outline) -> float:
    """The gap of two upright boxes had they the decimals that people write: 0.1 + 0.2 is 0.3."""
    gaps = []
    for i in 0, 1:
        p, q = ([v[i] for v in written(s)] for s in (a, b))
        gaps.append(max(min(p) - max(q), min(q) - max(p)))
    return float(max(gaps))


def written(shape: Outline) -> list[tuple[Fraction, Fraction]]:
    """The vertices as Fractions of the decimals that a person would write."""
    return [(Fraction(f"{x:.12g}"), Fraction(f"{y:.12g}")) for x, y in ring(shape)]


# -- other worlds


def on_faces_in_3d(a: Outline, b: Outline) -> float:
    """The face normals of the boxes in space that the scene is the view from above of."""
    return max(found.gap for found in threed.faces(*threed.PAIR))


def at_both_frames(a: Outline, b: Outline) -> float:
    """A flies past B within one frame; tested are its start and its end."""
    dx, dy = map(float, swept.FLIGHT)
    return min(textbook(a, b), textbook([Vec(x + dx, y + dy) for x, y in ring(a)], b))


def one_test_each(a: Outline, b: Outline) -> float:
    """Tests for MANY shapes, if each were tested once."""
    return MANY


def spread_of_found(a: Outline, b: Outline) -> float:
    """How many degrees apart the separating axes lie that the early exit finds: it finds one."""
    first = next(n for n in both_normals(a, b) if gap(a, b, n) > 0)
    found = [degrees(atan2(first.y, first.x))]
    return max(found) - min(found)


# -- outlines


def least_turn(a: Outline, b: Outline) -> float:
    """The smallest turn (cross product of neighbouring edges) of A: positive, and A is called convex."""
    around = [*edges(ring(a))]
    return min(p.x * q.y - p.y * q.x for p, q in zip(around, (*around[1:], around[0])))


# -- distance


def center_distance(a: Outline, b: Outline) -> float:
    """How far the centers lie apart."""
    (ax, ay), (bx, by) = centroid(as_shape(a)), centroid(as_shape(b))
    return hypot(bx - ax, by - ay)


def far_or_tested(a: Outline, b: Outline) -> float:
    """Pairs with centers FAR apart are left out, the others tested."""
    distance = center_distance(a, b)
    return distance if distance > FAR else textbook(a, b)


# -- another method, counted


def least_looks_of_gjk(a: Outline, b: Outline) -> float:
    """The fewest vertices GJK can look at for a hit: a triangle round the origin takes three support points."""
    return 3 * (len(ring(a)) + len(ring(b)))
