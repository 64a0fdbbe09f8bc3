"""The numbers that believers read off their own run."""

from math import atan2, degrees, dist, hypot, nan

from ...engine.axes import EDGE, Source, needed
from ...engine.geometry import Vec
from ...engine.shapes import Circle, Polygon, Shape
from ...engine.trace import Trace, record
from . import swept

MANY = 1000
LEAST_OF_GJK = 3  # support points: a triangle round the origin


def length_of_push(trace: Trace) -> float:
    """How far the run would push B; NaN where it sees nothing to push."""
    return hypot(*(trace.push or (nan, nan)))


def off_the_way_out(trace: Trace) -> float:
    """How far from where the shortest way out ends the run would push B; NaN where it sees nothing to push."""
    return dist(trace.push, record(trace.a, trace.b).mtv or (0.0, 0.0)) if trace.push else nan


def gap_as_distance(trace: Trace) -> float:
    """The largest gap that the run measured; 0 where it found none."""
    return max(0.0, *(test.gap for test in trace.tests))


def overlap_after_push(trace: Trace) -> float:
    """How deep B still is once it was pushed."""
    pushed = moved(trace.b, trace.push or Vec(0.0, 0.0))
    return max(0.0, -max((test.gap for test in record(trace.a, pushed, every_axis=True).tests), default=nan))


def moved(shape: Shape, move: Vec) -> Shape:
    """The shape elsewhere, its coordinates rounded."""
    if isinstance(shape, Circle):
        return Circle((shape.center.x + move.x, shape.center.y + move.y), shape.radius)
    return Polygon([(x + move.x, y + move.y) for x, y in shape.vertices], shape.labels)


def spread_of_found(trace: Trace) -> float:
    """How many degrees apart the separating axes lie that the early exit finds: it finds one, or none."""
    found = [degrees(atan2(*reversed(test.axis.normal))) for test in trace.tests if test.separates][:1]
    return max(found) - min(found) if found else nan


def extremes_of_b(trace: Trace) -> float:
    """How many vertices of B are furthest along the normal of its first edge; NaN if it has none."""
    found = [test.b.landings for test in trace.tests if test.source == Source(EDGE, "B", (0, 1))]
    return found[0].count(max(found[0])) if found else nan


def one_test_each(trace: Trace) -> float:
    """Tests for MANY shapes, if each were tested once."""
    return MANY


def least_looks_of_gjk(trace: Trace) -> float:
    """The fewest vertices GJK can look at: all of them for each support point, of which a miss takes one at least."""
    return (LEAST_OF_GJK if trace.hit else 1) * (len(trace.a.core) + len(trace.b.core))


def gap_at_both_frames(trace: Trace) -> float:
    """A flies past B within one frame; tested are its start and its end."""
    dx, dy = map(float, swept.FLIGHT)
    after = record(moved(trace.a, Vec(dx, dy)), trace.b, axes=trace.shortcut or needed)
    return min(max(test.gap for test in run.tests) for run in (trace, after))


OF_PUSHES = length_of_push, off_the_way_out, overlap_after_push
"""The readings that are about where B would be pushed."""
