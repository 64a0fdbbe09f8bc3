"""sv.explore: a scene under the hand.  The browser moves what is dragged; Python alone computes SAT."""

from dataclasses import replace
from math import isfinite
from typing import Any

import traitlets

from ..engine.axes import directions
from ..engine.geometry import InvalidScene, Vec
from ..engine.shapes import Shape
from ..engine.trace import Trace, record
from ..pictures import Picture
from ..pictures.curve import direction, gap_curve
from ..pictures.live import Chosen, field, fits, knob, live, telling_test, turned_axis
from ..pictures.playback import rows
from ..scenes.article import SCENES
from ..scenes.named import scene
from ..scenes.scenefile import Scene, shape_data, shape_from
from .base import Shown, code


class Explorer(Shown):
    """Two shapes to drag, turn and reshape, with the axis that tells most (or one chosen, or a free one).

    `scene` and `trace` follow the hand; what the browser sends is checked like a scene file.
    """

    _esm = code("explore")
    first = traitlets.Dict().tag(sync=True)
    presets = traitlets.List([s.name for s in SCENES]).tag(sync=True)

    def __init__(self, shown: Scene) -> None:
        self.scene = shown
        self._pinned: int | None = None
        self._degree: float | None = None
        self._way_out = False
        self._near: Vec | None = None
        self._picture: Picture | None = None
        trace = _trace(shown)
        self._layout = field(trace)
        super().__init__(trace=trace)
        self.first = self._state()

    def picture(self) -> Picture:
        """The picture as it stands."""
        return self._picture

    def answer(self, content: dict) -> None:
        """A pose, or a preset by name: the picture that follows, or why it cannot be."""
        try:
            if content.get("kind") == "preset":
                self._start(scene(content.get("name")))
            elif content.get("kind") == "pose":
                self._pose(content)
            else:
                return
        except ValueError as error:
            self.send({"kind": "refused", "n": content.get("n"), "why": str(error)})
            return
        self.send({"kind": "state", "n": content.get("n"), **self._state(final=bool(content.get("final", True)))})

    def _start(self, shown: Scene) -> None:
        self.scene, self._pinned, self._near = shown, None, None
        self.trace = _trace(shown)
        self._layout = field(self.trace)

    def _pose(self, content: dict) -> None:
        a, b = shape_from(content.get("a"), "A"), shape_from(content.get("b"), "B")
        degree, pinned = content.get("degree"), content.get("pinned")
        if degree is not None and not (isinstance(degree, (int, float)) and isfinite(degree)):
            raise InvalidScene("the angle must be a number")
        if pinned is not None and not isinstance(pinned, int):
            raise InvalidScene("the axis shown must be a row's number")
        changed = replace(self.scene, a=a, b=b)
        trace = _trace(changed)
        field(trace)  # refused where it cannot be drawn
        if pinned != self._pinned or (degree is None) != (self._degree is None):
            self._near = None
        self._pinned, self._degree, self._way_out = pinned, degree, bool(content.get("wayOut"))
        self.scene, self.trace = changed, trace

    def _state(self, *, final: bool = True) -> dict[str, Any]:
        """All that the browser shows; when a drag has ended the view is fitted anew if something lies outside."""
        self._draw()
        if final and not fits(self._picture):
            self._layout = field(self.trace)
            self._draw()
        trace = self.trace
        found = {
            "picture": self._picture.data(),
            "a": shape_data(self.scene.a),
            "b": shape_data(self.scene.b),
            "names": list(trace.names),
            "relation": str(trace.relation),
            "sentence": self._picture.sentence,
            "rows": rows(trace),
            "lit": self._lit,
            "json": self.scene.to_json(),
        }
        if self._degree is not None:
            found["curve"] = gap_curve(self.scene.a, self.scene.b, self._degree).data()
            found["knob"] = list(self._knob)
        return found

    def _draw(self) -> None:
        trace = self.trace
        if self._degree is not None:
            free = record(self.scene.a, self.scene.b, axes=directions(direction(self._degree)))
            self._picture, place = turned_axis(free, self._layout, self._degree, near=self._near)
            self._lit, self._knob = None, knob(self._layout, place, self._degree)
        else:
            chosen = self._choice()
            self._picture, place = live(trace, self._layout, chosen, way_out=self._way_out, near=self._near)
            self._lit = None if chosen is None else _row_of(trace, chosen)
        self._near = None if place is None else place.out

    def _choice(self) -> Chosen | None:
        """The axis that was asked for, as long as the trace has it; else the one that tells most."""
        if self._pinned is not None:
            row = 0
            for pair, run in enumerate(self.trace.pairs or (self.trace,)):
                if row <= self._pinned < row + len(run.tests):
                    return Chosen(pair if self.trace.pairs else None, self._pinned - row)
                row += len(run.tests) + len(run.skipped)
        return telling_test(self.trace)


def _trace(shown: Scene) -> Trace:
    """Every axis, since the table shows them all."""
    return shown.record().without_early_exit()


def _row_of(trace: Trace, chosen: Chosen) -> int:
    before = trace.pairs[: chosen.pair or 0]
    return sum(len(run.tests) + len(run.skipped) for run in before) + chosen.test


def explore(a: Scene | Shape | str, b: Shape | None = None) -> Explorer:
    """A scene to drag: a built-in scene's name, a Scene, or two shapes.

    Drag shapes, vertices and handles, or Tab to one and use the arrow keys.  InvalidScene
    for an unknown name, ValueError for a scene that cannot be drawn, TypeError for anything else.
    """
    if b is not None:
        return Explorer(Scene("scene", a, b))
    shown = scene(a) if isinstance(a, str) else a
    if not isinstance(shown, Scene):
        raise TypeError(f"a is a {type(a).__name__}: pass a scene, its name, or two shapes")
    return Explorer(shown)
