"""Count the axes that are enough for one pair of shapes; standard library only, so that it can run during a drag."""

from . import describe, number_format
from .axes import CENTERS, VERTEX, WORLD, Axis, hull_normals, needed
from .convex_parts import parts
from .geometry import Relation
from .relate import relate
from .sat import axis_tests
from .shapes import Shape, require_shape
from .trace import DEFAULT_NAMES, ShapeNames, Trace

NUMBER_WORDS = "no", "One", "Two", "Three", "Four", "Five", "Six", "Seven", "Eight", "Nine", "Ten", "Eleven", "Twelve"


def count_axes(a: Trace | Shape, b: Shape | None = None, names: ShapeNames = DEFAULT_NAMES) -> tuple[int, str]:
    """Return (number of axes that decide this pair at its present position, a sentence that names them).

    One axis with a gap proves that two shapes are apart, so it is enough.  Where no axis has a gap, a single
    axis proves nothing: all axes of a complete set must be tested.  Concave shapes that no
    single axis separates need one axis for each pair of convex parts, or if they meet, all axes of one pair.  Takes a
    trace, or two shapes with their names.
    """
    if isinstance(a, Trace):
        return count_axes(a.a, a.b, a.names)
    b = require_shape(b, "b")
    choice = needed(a, b)
    axes = choice.axes if choice.complete else (*choice.axes, *hull_normals(a, b).axes)
    tests = list(axis_tests(a, b, axes))
    test = max(tests, key=lambda test: test.gap)
    if test.separates:
        name = describe.axis_name(test.axis, (a, b), names)
        which = f"the line {name}" if test.source.kind in (CENTERS, VERTEX) else f"the {name.removeprefix('the ')}"
        gap = number_format.digits_for_tests((a, b), (test,)).number(test.gap)
        return 1, f"One axis is enough here: {which} leaves a gap of {gap}.{_any_position_sentence(choice.axes, a, b)}"
    if not choice.complete:
        return _count_axes_of_parts(a, b)
    many = len(choice.axes)
    touch = sum(test.gap == 0 for test in tests)
    on = "one axis" if touch == 1 else f"{_number_word(touch).lower()} axes"
    meets = f"touch on {on} and overlap on the others" if 0 < touch < many else "leave no gap on any"
    if many == 1:
        return 1, "One axis is enough, wherever two circles lie: the line through their centers."
    if choice.axes[0].source.kind == WORLD:
        return 2, "Two axes are enough, wherever two upright boxes lie: y and x."
    return many, f"{_number_word(many)} axes are needed here: the ranges {meets}, and only all of them prove a hit."


def axes_hint(trace: Trace) -> str:
    """Return a sentence on how many axes are enough, without the size of a gap; "" for a shortcut's run.

    It fits beside a table of the trace's tests and a picture of any of them.
    """
    a, b = trace.a, trace.b
    if trace.shortcut:
        return ""
    many, said = count_axes(trace)
    if trace.relation is Relation.APART and many == 1:
        return f"One axis with a gap is enough here.{_any_position_sentence(needed(a, b).axes, a, b)}"
    if not trace.choice.complete:
        return "The axes of this scene are not all that are needed: without a gap on them, nothing is proven."
    return said


def _any_position_sentence(axes: tuple[Axis, ...], a: Shape, b: Shape) -> str:
    """Return a sentence, after a space, on how many axes are enough in any position; `axes`: those of `needed`.

    It is "" for two circles and for a concave shape.
    """
    if not (a.is_convex and b.is_convex) or (a.core_is_point and b.core_is_point):
        return ""
    # the axis to the nearest vertex is not tested when it happens to be parallel to an edge's normal
    many = sum(axis.source.kind != VERTEX for axis in axes) + (a.core_is_point or b.core_is_point)
    return f" Wherever they are moved, {_number_word(many).lower()} are enough."


def _count_axes_of_parts(a: Shape, b: Shape) -> tuple[int, str]:
    """Return (number of axes, sentence) as `count_axes` does, for a pair with a concave polygon."""
    pairs = [(p, q) for p in parts(a) for q in parts(b)]
    if relate(a, b) is Relation.APART:
        none = "No one normal of an edge is enough here"
        return len(pairs), f"{none}, but one for each of the {len(pairs)} pairs of convex parts is."
    hit = next(pair for pair in pairs if relate(*pair))
    many = len(needed(*hit).axes)
    return many, f"{_number_word(many)} axes are needed here: all those of two convex parts that meet."


def _number_word(many: int) -> str:
    """Return a count as a word with a capital letter, or in digits above twelve."""
    return NUMBER_WORDS[many] if many < len(NUMBER_WORDS) else f"{many:,}"
