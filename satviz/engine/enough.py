"""How many axes are enough for the pair in hand: quick enough to be asked while it is dragged (no NumPy)."""

from . import digits, telling
from .axes import CENTERS, WORLD, hull_normals, needed
from .concave import parts
from .geometry import Relation
from .sat import axis_tests
from .shapes import Shape, checked
from .trace import PLAIN, Names, Trace
from .verdict import relate

WORDS = "no", "One", "Two", "Three", "Four", "Five", "Six", "Seven", "Eight", "Nine", "Ten", "Eleven", "Twelve"


def enough(a: Trace | Shape, b: Shape | None = None, names: Names = PLAIN) -> tuple[int, str]:
    """How many axes settle this pair as it lies, and a sentence on which, and on what would do wherever they lie.

    A gap on one axis proves that two shapes are apart, so one that leaves a gap is enough; and where there is none, no
    axis by itself says anything: all of a complete set must be tried.  Concave: each pair of convex parts needs its
    own.  Takes a trace, or two shapes with what they are called.
    """
    if isinstance(a, Trace):
        return enough(a.a, a.b, a.names)
    b = checked(b, "b")
    choice = needed(a, b)
    axes = choice.axes if choice.complete else (*choice.axes, *hull_normals(a, b).axes)
    test = max(axis_tests(a, b, axes), key=lambda test: test.gap)
    if test.separates:
        name = telling.axis_name(test.axis, (a, b), names)
        which = f"the line {name}" if test.source.kind == CENTERS else f"the {name.removeprefix('the ')}"
        gap = digits.of_tests((a, b), (test,)).number(test.gap)
        return 1, f"One axis is enough here: {which} leaves a gap of {gap}.{_anywhere(choice.axes, a, b)}"
    if not choice.complete:
        return _of_parts(a, b)
    many = len(choice.axes)
    meets = "touch on one axis and overlap on the others" if test.gap == 0 and many > 1 else "leave no gap on any"
    if many == 1:
        return 1, "One axis is enough, wherever two circles lie: the line through their centers."
    if choice.axes[0].source.kind == WORLD:
        return 2, "Two axes are enough, wherever two upright boxes lie: y and x."
    return many, f"{_count(many)} axes are needed here: the ranges {meets}, and only all of them prove a hit."


def _anywhere(axes: tuple[object, ...], a: Shape, b: Shape) -> str:
    if not (a.is_convex and b.is_convex):
        return ""
    return f" Wherever they are moved, {_count(len(axes)).lower()} are enough." if len(axes) > 1 else ""


def _of_parts(a: Shape, b: Shape) -> tuple[int, str]:
    pairs = [(p, q) for p in parts(a) for q in parts(b)]
    if relate(a, b) is Relation.APART:
        return len(
            pairs
        ), f"No one normal of an edge is enough here: each of the {len(pairs)} pairs of convex parts needs its own."
    hit = next(pair for pair in pairs if relate(*pair))
    many = len(needed(*hit).axes)
    return many, f"{_count(many)} axes are needed here: all those of two convex parts that meet."


def _count(many: int) -> str:
    return WORDS[many] if many < len(WORDS) else f"{many:,}"
