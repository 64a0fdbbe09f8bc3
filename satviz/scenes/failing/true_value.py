"""The right answers: what the engine says of a row's scene."""

from itertools import combinations
from math import cos, hypot, nan, radians, sin

from ...engine.axes import EDGE, HULL, Source, directions, edge_normals, hull_normals, needed
from ...engine.convex_parts import parts
from ...engine.geometry import Vec
from ...engine.sat import axis_tests
from ...engine.shapes import Shape
from ...engine.trace import record
from ..shortcuts import written
from . import swept, threed
from .claimed_value import MANY, moved

Answer = float | tuple[swept.Number, swept.Number] | str


def gap(a: Shape, b: Shape) -> float:
    """The largest gap of all axes tested; of concave outlines that of the pair of parts nearest to each other."""
    trace = record(a, b, every_axis=True)
    return min(max(test.gap for test in run.tests) for run in trace.pairs or (trace,))


def hull_gap(a: Shape, b: Shape) -> float:
    """The largest gap on a hull's edges that are no edges of the outlines: also for concave ones a proof."""
    tests = record(a, b, axes=hull_normals, every_axis=True).tests
    return max((test.gap for test in tests if test.source.kind == HULL), default=gap(a, b))


def way_out(a: Shape, b: Shape) -> Vec:
    """The shortest move of B that ends the overlap; (0, 0) where there is none to end."""
    return record(a, b).mtv or Vec(0.0, 0.0)


def depth(a: Shape, b: Shape) -> float:
    """The length of the shortest way out."""
    return hypot(*way_out(a, b))


def overlap_after_mtv(a: Shape, b: Shape) -> float:
    """How deep B, a polygon, still is once it has made the shortest move out."""
    return max(0.0, -gap(a, moved(b, way_out(a, b))))


def on_the_way_out(a: Shape, b: Shape) -> float:
    """How far the shortest way out is off itself."""
    return 0.0


def distance(a: Shape, b: Shape) -> float:
    """How far the nearest points lie from each other; 0 where the shapes meet.

    Of convex shapes that is the largest gap, once the direction between the nearest vertices is tested too.
    """
    return max(0.0, min(_largest_gap(p, q) for p in parts(a) for q in parts(b)))


def _largest_gap(a: Shape, b: Shape) -> float:
    between = [Vec(q.x - p.x, q.y - p.y) for p in a.vertices for q in b.vertices]
    nearest = min(between, key=lambda way: hypot(*way), default=Vec(0.0, 0.0))
    axes = (*needed(a, b).axes, *(directions(nearest)(a, b).axes if any(nearest) else ()))
    return max(test.gap for test in axis_tests(a, b, axes))


def fan(a: Shape, b: Shape) -> tuple[float, float]:
    """From which to which angle every direction separates, in degrees, to a rounding: each end found by halving."""
    best = max(axis_tests(a, b), key=lambda test: test.gap).axis.direction

    def separates(degrees: float) -> bool:
        c, s = cos(radians(degrees)), sin(radians(degrees))
        (test,) = axis_tests(a, b, directions((best.x * c - best.y * s, best.x * s + best.y * c))(a, b).axes)
        return test.separates

    ends = []
    for inside, outside in (0.0, -90.0), (0.0, 90.0):
        for _ in range(50):
            middle = (inside + outside) / 2
            inside, outside = (middle, outside) if separates(middle) else (inside, middle)
        ends.append(inside)
    return ends[0], ends[1]


def fan_width(a: Shape, b: Shape) -> float:
    """How wide the fan of separating directions is, in degrees; NaN where none separates."""
    lo, hi = fan(a, b)
    return hi - lo or nan


def extremes_of_b(a: Shape, b: Shape) -> float:
    """How many of B's corners land on the end of its range, on the normal of its first edge; NaN if it has none."""
    first = (t for t in edge_normals(a, b).axes if t.source == Source(EDGE, "B", (0, 1)))
    found = [test.b for test in axis_tests(a, b, first)]
    return found[0].landings.count(found[0].interval.hi) if found else nan


def looks(a: Shape, b: Shape) -> float:
    """How many vertices SAT puts in a dot product until it is sure."""
    trace = record(a, b)
    tests = (test for run in trace.pairs or (trace,) for test in run.tests)
    return sum(len(test.a.points) + len(test.b.points) for test in tests)


def pairs_of_many(a: Shape, b: Shape) -> float:
    """Each pair counted, as a loop over all of them meets it."""
    return sum(1 for _ in combinations(range(MANY), 2))


def gap_3d(a: Shape, b: Shape) -> float:
    """On all fifteen axes of the boxes in space that the scene is the view from above of."""
    return max(found.gap for found in (*threed.faces(*threed.PAIR), *threed.crosses(*threed.PAIR)))


def contact(a: Shape, b: Shape) -> Answer:
    """When polygon A, flying over B, meets it, in parts of the way (NaN if never); exact for the scene's decimals."""
    if a.core_is_point or b.core_is_point:
        return nan, nan
    runs = (swept.windows(written(p), written(q), swept.FLIGHT) for p in parts(a) for q in parts(b))
    times = [time for run in runs if (time := swept.contact(run))]
    return (min(first for first, _ in times), max(last for _, last in times)) if times else (nan, nan)
