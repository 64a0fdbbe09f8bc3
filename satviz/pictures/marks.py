"""A picture: what to draw for a step, as a short list of marks in scene coordinates."""

import json
from collections.abc import Iterable
from typing import Any, NamedTuple, TypedDict

from ..engine import hooks
from ..engine.geometry import Vec
from .theme import Style, style_of

Limits = tuple[float, float, float, float]


class Mark(NamedTuple):
    """One thing in a picture.

    `part`: what it is ("outline", "vertex", "drop"); `owner`: whose ("A", "B1"); `axis`: the axis it lies on;
    `number`: which of several.  `kind` and `points` (scene units): outline (its vertices), disc (its center;
    `radius`), segment (two ends a piece), arrow (tail, head), interval (a bar's ends), bracket (a polyline), dot
    and label (one point; a label is centered on it, lines parted by newlines).  `role`: a colour of the theme.
    `weight` is "plain", "strong" (what the step is about), "faint" or "title".  `start`: where the points come
    from, for a pen that moves them: a point each, or one for all.
    `panel`: which of several pictures in one it belongs to.
    """

    part: str
    kind: str
    role: str
    points: tuple[Vec, ...] = ()
    owner: str = ""
    axis: str = ""
    number: int | None = None
    radius: float = 0.0
    text: str = ""
    weight: str = "plain"
    start: tuple[Vec, ...] = ()
    panel: str = ""

    @property
    def id(self) -> str:
        """One name in a picture, for pens to keep what they drew by; what the mark is its fields say."""
        known = self.panel, self.owner, self.part, self.axis, self.number
        return ".".join(str(fact) for fact in known if fact not in ("", None))

    @property
    def style(self) -> Style:
        """How it is drawn."""
        return style_of(self.kind, self.role, self.weight)


class Which(TypedDict, total=False):
    """What of a mark, or of a label that wants a place, may be left out."""

    owner: str
    axis: str
    number: int | None
    weight: str


class Details(Which, total=False):
    """What of a mark alone may be left out."""

    radius: float
    start: tuple[Vec, ...]


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
    def labels(self) -> "tuple[Mark, ...]":
        """The labels, in drawing order."""
        return tuple(mark for mark in self.marks if mark.kind == "label")

    @property
    def texts(self) -> tuple[str, ...]:
        """What the labels say, in drawing order."""
        return tuple(mark.text for mark in self.labels)

    def __repr__(self) -> str:
        return f"<Picture: {self.sentence}>"

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, str]:
        """In a notebook: the picture, and its sentence."""
        return hooks.mime_bundle(self)

    def data(self) -> dict[str, Any]:
        """The picture as JSON values: all a pen needs."""
        data = {"satviz": "picture 1", "title": self.title, "sentence": self.sentence}
        return data | {"limits": list(self.limits), "size": list(self.size), **marks_data(self.marks)}

    def to_json(self, *, indent: int | None = None) -> str:
        """The same as text."""
        return json.dumps(self.data(), indent=indent, ensure_ascii=False, allow_nan=False)


def marks_data(marks: Iterable[Mark]) -> dict[str, Any]:
    """Marks as JSON values, and their looks, which are few, in a table; what is as in a plain one is left out."""
    looks: dict[Style, int] = {}
    found = []
    for mark in marks:
        own = {name: value for name, value in _told(mark).items() if name not in ("kind", "role", "weight")}
        found.append({"id": mark.id, "look": looks.setdefault(mark.style, len(looks)), **own})
    return {"looks": [_told(style_of) for style_of in looks], "marks": found}


def _told(one: Mark | Style) -> dict[str, Any]:
    plain = one._field_defaults
    return {name: _listed(value) for name, value in one._asdict().items() if value != plain.get(name)}


def _listed(value: Any) -> Any:
    return [_listed(v) for v in value] if isinstance(value, tuple) else value
