"""Challenges: goals that the reader reaches by dragging a scene, evaluated by the engine; standard library only."""

from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

from ..engine import polygon_validation
from ..engine.axes import needed
from ..engine.geometry import InvalidScene, Relation, Vec
from ..engine.trace import record
from ..pictures.claims import answers
from ..pictures.drag import drag_layout
from ..pictures.float_geometry import bounding_box
from ..scenes.failing import FAILURE_CASES, NAMED, REFUSED
from ..scenes.link import BREAK, ONE_AXIS, TOUCH
from ..scenes.named import scene, scene_of_case
from ..scenes.scenefile import Scene
from ..scenes.shape_tools import translated

GOAL_NAMES = {TOUCH: "make them touch", ONE_AXIS: "exactly one axis", BREAK: "break the shortcut"}
GOAL_TASKS = {
    ONE_AXIS: "Make exactly one axis separate the shapes.",
    TOUCH: "Make the shapes touch exactly, with no gap and no overlap.",
    BREAK: "Break this shortcut: find a place where it is wrong.",
}
GOAL_HINTS = {
    ONE_AXIS: "One axis is enough to keep them apart. Push the shapes together until all gaps but one have closed.",
    TOUCH: "Put an edge against an edge, or a corner onto an edge. The arrow keys move a shape by the same step each "
    "time, with Shift by a tenth of it. A circle touches exactly if its center lies straight above, below or beside a "
    "corner or another center. If all edges are slanted, drag a corner of each shape to the same place.",
    BREAK: "Which different pairs of shapes does this shortcut treat as equal? Try those. "
    "If you give up, a map shows in red where the shortcut is wrong.",
}
# how far B is moved to find a challenge's level: as far as the scene is wide, in so many steps
LEVEL_STEPS, LEVEL_LIMITS = 8, (0.25, 0.05)
MOVE_SIZES, MOVE_DIRECTIONS = (1, 2, 3, 4, 6, 8), ((1, 0), (0, 1), (-1, 0), (0, -1), (1, 1), (-1, 1), (-1, -1), (1, -1))


class ChallengeResult(NamedTuple):
    """A challenge's goal, whether the scene meets it, and sentences: the task, the status of the scene, and a hint."""

    goal: str
    met: bool
    task: str
    status: str
    hint: str


def evaluate_goal(goal: str, shown: Scene) -> ChallengeResult:
    """Return whether a scene meets a goal, with task and hint; InvalidScene for an unknown or unfit goal."""
    if goal not in GOAL_TASKS:
        choices = ", ".join(GOAL_TASKS)
        raise InvalidScene(f"no challenge is called {polygon_validation.short_repr(goal)}: choose one of {choices}")
    met, status = {ONE_AXIS: _evaluate_one_axis, TOUCH: _evaluate_touch, BREAK: _evaluate_break}[goal](shown)
    return ChallengeResult(goal, met, GOAL_TASKS[goal], status, GOAL_HINTS[goal])


def challenge_start(goal: str, shown: Scene) -> Scene:
    """Return the scene with which a challenge begins: `shown`, or another if it meets the goal or cannot meet it.

    InvalidScene where no other scene is found, or for an unknown or unfit goal.
    """
    if not evaluate_goal(goal, shown).met and not (goal == ONE_AXIS and _has_concave_shape(shown)):
        return shown
    if goal == BREAK:
        start = start_where_right(scene_of_case(NAMED[shown.axes]) if shown.axes in NAMED else shown)
    else:
        start = next(s for g, s in challenges() if g == goal)
    if start is None:
        raise InvalidScene("this shortcut is wrong at every place near this scene: choose another scene to break")
    return start


def challenges() -> Iterator[tuple[str, Scene]]:
    """Yield (goal, first scene) of each challenge that the site offers."""
    yield TOUCH, scene("aabb")
    yield ONE_AXIS, replace(scene("triangles"), axes="needed")
    yield TOUCH, scene("circle-polygon")
    for row in FAILURE_CASES:
        start = None if row.how == REFUSED else start_where_right(scene_of_case(row))
        if start:
            yield BREAK, start


def level(goal: str, start: Scene) -> int:
    """Return the level of a challenge, from 1 (easy) to 3.

    A shortcut is easy to break if it is wrong in a large part of the places near the start: at least a quarter of
    them for level 1, a twentieth for level 2.  Another goal has level 1 in the scene "aabb", else level 2.
    """
    if goal != BREAK:
        return 1 if start.name == "aabb" else 2
    x0, y0, x1, y1 = bounding_box([start.a, start.b])
    step = max(x1 - x0, y1 - y0) / LEVEL_STEPS
    moves = range(-LEVEL_STEPS // 2, LEVEL_STEPS // 2 + 1)
    places = [replace(start, b=translated(start.b, Vec(i * step, j * step))) for i in moves for j in moves]
    share = sum(answers(place.record()).is_wrong for place in places) / len(places)
    return 1 + sum(share < limit for limit in LEVEL_LIMITS)


def start_where_right(shown: Scene) -> Scene | None:
    """Return a shortcut's scene with B moved so that the shortcut is right; None if no place nearby is found."""
    x0, y0, x1, y1 = bounding_box([shown.a, shown.b])
    step = float(f"{max(x1 - x0, y1 - y0) / 4:.1g}")
    for size in MOVE_SIZES:
        for x, y in MOVE_DIRECTIONS:
            start = replace(shown, b=translated(shown.b, Vec(size * step * x, size * step * y)))
            if not answers(start.record()).is_wrong:
                drag_layout(start.record())
                return start
    return None


def _evaluate_one_axis(shown: Scene) -> tuple[bool, str]:
    """Return whether exactly one axis separates the shapes, and a sentence on how many do."""
    if _has_concave_shape(shown):
        return False, "A shape has a dent, and only convex shapes count: drag the corner out, or choose another scene."
    trace = record(shown.a, shown.b, axes=needed, every_axis=True)
    count = len({_rounded_line(test.axis.direction) for test in trace.tests if test.separates})
    if count == 1:
        return True, "Exactly one axis separates them."
    return False, "No axis separates them: they collide." if not count else f"{count} axes separate them."


def _has_concave_shape(shown: Scene) -> bool:
    """Return whether one of the shapes is concave."""
    return not (shown.a.is_convex and shown.b.is_convex)


def _rounded_line(direction: Vec) -> tuple[float, float]:
    """Return a direction (x, y) rounded to 9 digits, the same for its opposite, so that near-parallels are equal."""
    x, y = round(direction.x, 9) + 0.0, round(direction.y, 9) + 0.0
    return max((x, y), (0.0 - x, 0.0 - y))


def _evaluate_touch(shown: Scene) -> tuple[bool, str]:
    """Return whether the shapes touch, and a sentence about their relation."""
    trace = record(shown.a, shown.b, every_axis=True)
    if trace.relation is Relation.TOUCHING:
        return True, "They touch, exactly."
    if trace.relation is Relation.OVERLAPPING:
        return False, "They overlap."
    return False, "They are apart."


def _evaluate_break(shown: Scene) -> tuple[bool, str]:
    """Return whether the shortcut's answer is wrong, and a sentence about that; InvalidScene without a shortcut."""
    trace = shown.record()
    if trace.shortcut is None:
        raise InvalidScene(f"the axes {shown.axes!r} are not a shortcut: this goal needs a shortcut that can fail")
    if answers(trace).is_wrong:
        return True, "Broken: here the shortcut is wrong."
    return False, "Here it happens to be right."
