"""The explorer without its widget: each pose that a drag sends is answered with the picture that follows.

A pose is the present place of both shapes with the options of the view; the front end is the browser's part.
"""

from dataclasses import replace
from functools import partial
from math import isfinite
from typing import Any, NamedTuple

from ..engine.axes import directions
from ..engine.axis_count import axes_hint
from ..engine.geometry import InvalidScene, Relation, Vec
from ..engine.sat import AxisTest
from ..engine.shapes import Shape
from ..engine.trace import Trace, record
from ..pictures import Picture
from ..pictures.claims import heading
from ..pictures.comparison_drag import describe_error_region, drag_view
from ..pictures.curve import CURVE_WIDTH_PT, gap_curve, unit_vector
from ..pictures.dial import dial
from ..pictures.drag import (
    ShownTest,
    all_marks_fit,
    canvas_size,
    decisive_test,
    degree_text,
    drag_digits,
    drag_layout,
    drag_picture,
    free_axis_picture,
    knob_position,
)
from ..pictures.label_placer import LabelMemory
from ..pictures.minkowski import difference
from ..pictures.number_line import number_line
from ..pictures.playback import first_row_numbers, table_rows
from ..scenes.article import SCENES
from ..scenes.failing import FAILURE_CASES, REFUSED
from ..scenes.link import BREAK, ViewOptions, fragment
from ..scenes.named import scene
from ..scenes.scenefile import Scene, shape_data, shape_from
from ..scenes.strictjson import require_type
from .goals import GOAL_NAMES, ChallengeResult, challenge_start, evaluate_goal
from .paste_model import read_paste
from .player_model import PlayerModel
from .snapping import snapped

SNAP_PT, SNAP_FACTOR = 10.0, 1.5  # points between shapes that snap; how much further the shape may be moved
SNAPPED = "Snapped: they touch exactly."
NO_TOUCH = (
    "No place nearby was found where they touch exactly: most such places have coordinates that no float64 holds."
)
HIDDEN_MAP = "When you have broken the shortcut, or give up, a map shows where it is wrong."
SHORTCUT, TRUTH = "shortcut", "truth"
NEEDED, EVERY_NORMAL = "needed", "edge-normals"  # choices of axes
OFFERED: dict[str, Any] = {  # what an explorer lists
    "presets": [s.name for s in SCENES],
    "failing": [case.name for case in FAILURE_CASES if case.how != REFUSED],
    "challenges": GOAL_NAMES,
}


class DrawnScene(NamedTuple):
    """A drawn scene: the picture, its number line, and the handle of a free axis (`knob`, in scene units).

    `lit`: the axis's row in the table, from 0.  Without an axis there is only the picture.
    """

    picture: Picture
    line: Picture | None = None
    lit: int | None = None
    knob: Vec | None = None


class ExplorerModel(PlayerModel):
    """The state of an explorer: two shapes to drag, turn and reshape, and one decisive, chosen or free axis.

    A scene whose axes are a shortcut's has two views: the shortcut's run, and the truth.
    `goal` is a challenge; a scene that meets it already is replaced by another one.
    ValueError for a scene that cannot be drawn, or cannot have the goal.
    """

    def __init__(self, shown: Scene, goal: str | None = None) -> None:
        """Show a scene; `goal`: the challenge ("touch", "one-axis" or "break"), None for none."""
        self._first = shown
        self._degree: float | None = None
        self._largest = canvas_size(None)
        self._show_mtv = self._show_difference = self._won = False
        self._start(challenge_start(goal, shown) if goal else shown, goal)
        self._redraw()

    def picture(self) -> Picture:
        """Return the picture of the scene as it is now."""
        return self._drawn.picture

    def number_line(self) -> Picture | None:
        """Return the number line below the picture, itself a picture; None if no axis is shown."""
        return self._drawn.line

    def answer(self, content: dict[str, Any]) -> dict[str, Any] | None:
        """Return the reply to a message: the new state, the reading of a pasted text, or why the message is refused.

        None for a message of unknown kind.
        """
        n, before = content.get("n"), {**vars(self), "_memory": self._memory.copy()}
        try:
            if content.get("kind") == "preset":
                self._start(scene(require_type(content.get("name"), "the preset", str)))
            elif content.get("kind") == "paste":
                return self._paste(content)
            elif content.get("kind") == "challenge":
                goal = require_type(content.get("goal"), "the challenge", str)
                self._start(challenge_start(goal, self.scene), goal)
            elif content.get("kind") == "pose":
                self._pose(content)
            else:
                return None
            self._redraw(final=bool(content.get("final", True)))
            return {"kind": "state", "n": n, **self.state()}
        except ValueError as error:  # also of what a picture asks of the engine: then nothing has changed
            vars(self).update(before)
            return {"kind": "refused", "n": n, "why": str(error)}

    def state(self) -> dict[str, Any]:
        """Return all that a front end shows, as JSON values."""
        trace, drawn = self.trace, self._drawn
        found: dict[str, Any] = {
            "picture": drawn.picture.data(),
            "a": shape_data(self.scene.a),
            "b": shape_data(self.scene.b),
            "names": list(trace.names),
            "relation": str(trace.relation),
            "sentence": drawn.picture.sentence,
            "enough": axes_hint(trace),
            "rows": table_rows(trace, drag_digits(self._layout)),
            "lit": drawn.lit,
            "json": self.scene.to_json(),
            "view": self._view,
            "link": fragment(self.scene, self._view_options()),
            "scene": self._start_json,
        }
        if drawn.line:
            found["line"] = drawn.line.data()
        if self._challenge_result:
            found["goal"] = self._challenge_result._asdict()
        if self._snap_words:
            found["snapped"] = self._snap_words
        if self._show_difference:
            found["difference"] = difference(trace, largest=(min(340.0, self._largest[0]), 300.0)).data()
        if self._run.shortcut:
            found["heading"] = list(heading(self._run, drag_digits(self._layout)))
        if trace.shortcut and drawn.knob is None:
            found["map"] = HIDDEN_MAP if self._hides_map else describe_error_region(trace, self._layout)
        if drawn.knob is not None:
            width = min(CURVE_WIDTH_PT, self._largest[0])
            found["dial"] = dial(self.scene.a, self.scene.b, self._degree or 0.0).data()
            found["curve"] = gap_curve(self.scene.a, self.scene.b, self._degree, width=width).data()
            found["knob"] = list(drawn.knob)
        return found

    def _paste(self, content: dict[str, Any]) -> dict[str, Any]:
        """Return the reading of a pasted text; if the text has a pair of shapes, show it and add the new state."""
        shown, pasted = read_paste(content)
        if shown is None:
            return {"kind": "pasted", "pasted": pasted}
        before = {**vars(self), "_memory": self._memory.copy()}
        try:
            self._start(shown)
            self._redraw()
        except ValueError as error:  # two shapes that are too far apart to be drawn are answered all the same
            vars(self).update(before)
            return {"kind": "pasted", "pasted": {**pasted, "why": f"The picture is not drawn: {error}."}}
        return {"kind": "state", **self.state(), "pasted": pasted}

    @property
    def _hides_map(self) -> bool:
        """Return whether the error region would give away a challenge that is not won yet."""
        result = self._challenge_result
        return result is not None and result.goal == BREAK and not self._won

    def _view_options(self) -> ViewOptions:
        """Return the options of the present view, as a link to it contains them."""
        view = self._view if self._view == TRUTH else None
        goal = self._challenge_result.goal if self._challenge_result else None
        return ViewOptions(self._degree, self._pinned, view, self._show_mtv, self._show_difference, goal=goal)

    def _start(self, shown: Scene, goal: str | None = None) -> None:
        """Show a scene from its beginning, with a fresh layout; `goal`: the challenge, if any."""
        trace, met = _trace(shown), evaluate_goal(goal, shown) if goal else None
        self._layout = drag_layout(trace, self._largest)
        self._at_first = shown.a, shown.b
        self._start_json = shown.to_json()  # a pose says which scene it is of: undo goes back over presets too
        self._won = False
        self._set_run(shown, trace, SHORTCUT if trace.shortcut else None, met)
        self._pinned: int | None = None
        self._snap_words = ""
        self._last_out: Vec | None = None  # the way the axis lay before, so that it stays on its side
        self._memory = LabelMemory()  # how the labels stood, so that they do not jump

    def _pose(self, content: dict[str, Any]) -> None:
        """Apply a drag's message: both shapes, the view and the challenge; ValueError before anything is changed."""
        a, b = shape_from(content.get("a"), "A"), shape_from(content.get("b"), "B")
        degree, pinned = _number(content.get("degree"), "the angle"), content.get("pinned")
        largest = canvas_size(_number(content.get("width"), "the width"))
        if pinned is not None and not isinstance(pinned, int):
            raise InvalidScene("pinned must be the number of a row in the table of axes, or null")
        text = content.get("scene")
        begun = self.scene if text in (None, self._start_json) else self._parse_start(text)
        a, b, snap_words = self._snapped(a, b, content.get("snap"), by_key=content.get("byKey") is True)
        changed = replace(begun, a=a, b=b)
        trace = _trace(changed)
        view = (content.get("view") or self._view or SHORTCUT) if trace.shortcut else None
        if view not in (None, SHORTCUT, TRUTH):
            raise InvalidScene(f'the view must be "{SHORTCUT}" or "{TRUTH}"')
        layout = drag_layout(trace, largest)  # refused where it cannot be drawn
        before = self._challenge_result.goal if self._challenge_result else None
        goal = content.get("goal", before)
        met = None if goal is None else evaluate_goal(require_type(goal, "the challenge", str), changed)
        if begun is not self.scene:
            self._start_json, self._at_first = begun.to_json(), (begun.a, begun.b)
        # where the scene began it has the frame and the labels that it had there, whatever was shown since; while
        # only a free axis is turned there, nothing may jump
        came = degree is None or layout != self._layout or (self.scene.a, self.scene.b) != self._at_first
        returns = content.get("final", True) and (a, b) == self._at_first and came
        if begun is not self.scene or largest != self._largest or returns:
            self._layout, self._largest, self._memory, self._last_out = layout, largest, LabelMemory(), None
        if pinned != self._pinned or (degree is None) != (self._degree is None) or view != self._view:
            self._last_out = None
        if view != self._view:
            pinned = None  # the other run's rows are others
        self._snap_words = snap_words
        self._pinned, self._degree, self._show_mtv = pinned, degree, bool(content.get("mtv"))
        self._show_difference = bool(content.get("difference"))
        self._set_run(changed, trace, view, met)

    def _snapped(self, a: Shape, b: Shape, key: object, *, by_key: bool = False) -> tuple[Shape, Shape, str]:
        """Return both shapes, the one named by `key` ("a" or "b") moved to touch the other if near, and what was done.

        What was done is a sentence, "" if nothing was tried.

        After an arrow key (`by_key`) a shape snaps only on its way to a touch; otherwise it could never leave it.
        """
        if key not in ("a", "b"):
            return a, b, ""
        reach = self._layout.units(SNAP_PT)
        distance = _distance(a, b)
        if distance == 0 or abs(distance) > reach:
            return a, b, ""
        if (
            by_key
            and not abs(distance) < abs(before := _distance(self.scene.a, self.scene.b))
            and before * distance >= 0
        ):
            return a, b, ""
        found = snapped(a, b, SNAP_FACTOR * reach) if key == "a" else snapped(b, a, SNAP_FACTOR * reach)
        if found is None:
            return a, b, NO_TOUCH
        return (found, b, SNAPPED) if key == "a" else (a, found, SNAPPED)

    def _parse_start(self, text: Any) -> Scene:
        """Parse the JSON text of the scene from which a drag started; InvalidScene if it does not hold one.

        The explorer's first scene is returned as it is, since its choice of axes may have no name in JSON.
        """
        if text == self._first.to_json():
            return self._first
        return Scene.from_json(require_type(text, "the scene", str))

    def _set_run(self, scene: Scene, run: Trace, view: str | None, met: ChallengeResult | None) -> None:
        """Store the scene, its run, the view with the trace it shows, and the challenge's result (`met`)."""
        self.scene, self._run, self._view, self._challenge_result = scene, run, view, met
        self._won = met is not None and (met.met or self._won)
        self.trace = run.truth if view == TRUTH else run

    def _redraw(self, *, final: bool = True) -> None:
        """Draw the scene; after a drag (`final`), fit the view again if a mark lies outside it."""
        self._memory.resting = final
        self._drawn = self._draw()
        if final and not all_marks_fit(self._drawn.picture):
            self._layout, self._memory = drag_layout(self.trace, self._largest), LabelMemory()
            self._drawn = self._draw()

    def _draw(self) -> DrawnScene:
        """Return the drawn scene with its axis, and remember where axis and labels stand."""
        trace = self.trace
        if self._degree is not None:
            free = record(self.scene.a, self.scene.b, axes=directions(unit_vector(self._degree)))
            drawn, place = free_axis_picture(
                free, self._layout, self._degree, last_out=self._last_out, memory=self._memory
            )
            self._last_out = place.out
            free_line = self._line_of(free, free.tests[0], degree_text(self._degree))
            return DrawnScene(drawn, free_line, knob=knob_position(self._layout, place, self._degree))
        chosen = self._shown_test()
        show = partial(drag_view, show_region=not self._hides_map) if trace.shortcut else drag_picture
        drawn, lies = show(
            trace,
            self._layout,
            chosen,
            show_mtv=self._show_mtv,
            last_out=self._last_out,
            memory=self._memory,
        )
        self._last_out = None if lies is None else lies.out
        if chosen is None:
            return DrawnScene(drawn)
        run = trace if chosen.pair is None else trace.pairs[chosen.pair]
        test = run.tests[chosen.test]
        line = self._line_of(run, test, f"axis {chosen.test + 1}") if any(test.axis.normal) else None
        return DrawnScene(drawn, line, lit=first_row_numbers(trace)[chosen.pair or 0] + chosen.test)

    def _line_of(self, run: Trace, test: AxisTest, name: str) -> Picture:
        """Return the number line of a test, whose numbers have the format of the picture and the table."""
        return number_line(run, test, self._layout, drag_digits(self._layout)(run, test), name)

    def _shown_test(self) -> ShownTest | None:
        """Return the test in the row that the reader chose, if the trace has that row, else the decisive test."""
        if self._pinned is not None:
            runs = self.trace.pairs or (self.trace,)
            for pair, (run, begin) in enumerate(zip(runs, first_row_numbers(self.trace), strict=False)):
                if begin <= self._pinned < begin + len(run.tests):
                    return ShownTest(pair if self.trace.pairs else None, self._pinned - begin)
        return decisive_test(self.trace)


def _distance(a: Shape, b: Shape) -> float:
    """Return roughly the distance of two shapes, negative for an overlap; it is 0 only if they touch exactly."""
    tests = record(a, b, every_axis=True)
    if tests.relation is Relation.TOUCHING:
        return 0.0
    gaps = [max((t.gap for t in run.tests), default=0.0) for run in tests.pairs or (tests,)]
    return min(gaps) if tests.relation is Relation.APART else max(gaps)


def _number(value: Any, what: str) -> float | None:
    """Return a number or None from a message; InvalidScene calls it `what` if it is not a finite number."""
    if value is not None and not (isinstance(value, (int, float)) and isfinite(value)):
        raise InvalidScene(f"{what} must be a finite number, not {value!r}")
    return value


def _trace(shown: Scene) -> Trace:
    """Return a scene's trace without early exit, since the table shows every axis; parallel normals share a row."""
    if shown.axes == EVERY_NORMAL and shown.a.is_convex and shown.b.is_convex:
        shown = replace(shown, axes=NEEDED)
    return shown.record().without_early_exit()
