"""A picture: what to draw for a step, as a short list of marks in scene coordinates."""

import json
from typing import NamedTuple

from ..geometry import Vec

Limits = tuple[float, float, float, float]

KINDS = ("outline", "disc", "segment", "arrow", "dot", "interval", "bracket", "label")
ROLES = ("A", "B", "gap", "overlap", "guide", "ink")


class Mark(NamedTuple):
    """One thing in a picture.

    `kind` and `points` (scene units): outline (its vertices), disc (its centre; `radius`),
    segment (two ends a piece), arrow (tail, head), interval (a bar's ends), bracket (a polyline), dot and
    label (one point; a label is centred on it, lines parted by newlines).  `weight` is
    "plain", "strong" (what the step is about), "faint" or "title".
    """

    id: str
    kind: str
    role: str
    points: tuple[Vec, ...]
    radius: float = 0.0
    text: str = ""
    weight: str = "plain"


class Picture(NamedTuple):
    """Marks to draw in order, the limits (x0, y0, x1, y1) in scene units, the canvas in points, and the words.

    `sentence` says what the picture shows, made from the trace: its alt text.
    """

    marks: tuple[Mark, ...]
    limits: Limits
    size: tuple[float, float]
    title: str
    sentence: str

    @property
    def scale(self) -> float:
        """Points a scene unit, the same in x and y."""
        return self.size[0] / (self.limits[2] - self.limits[0])

    def mark(self, mark_id: str) -> Mark:
        """The mark of that id; KeyError if there is none."""
        for mark in self.marks:
            if mark.id == mark_id:
                return mark
        raise KeyError(mark_id)

    @property
    def texts(self) -> tuple[str, ...]:
        """What the labels say, in drawing order."""
        return tuple(mark.text for mark in self.marks if mark.kind == "label")

    def to_json(self, *, indent: int | None = None) -> str:
        """The picture as JSON: all a pen needs."""
        marks = []
        for mark in self.marks:
            data: dict = {"id": mark.id, "kind": mark.kind, "role": mark.role, "points": [list(p) for p in mark.points]}
            data |= {"radius": mark.radius} if mark.kind == "disc" else {}
            data |= {"text": mark.text} if mark.kind == "label" else {}
            data |= {"weight": mark.weight} if mark.weight != "plain" else {}
            marks.append(data)
        data = {"satviz": "picture 1", "title": self.title, "sentence": self.sentence}
        data |= {"limits": list(self.limits), "size": list(self.size), "marks": marks}
        return json.dumps(data, indent=indent, ensure_ascii=False, allow_nan=False)
