"""A picture is a short list of marks in scene coordinates, which every pen draws in the same way."""

import json
from collections.abc import Iterable
from typing import Any, NamedTuple, TypedDict

from ..engine import hooks
from ..engine.geometry import Vec
from .float_geometry import Box
from .theme import Style, style_of


class Mark(NamedTuple):
    """One thing to draw in a picture.

    `part`: what it shows ("outline", "vertex", "drop").  `owner`: the name of its shape ("A", "B1").
    `axis`: the id of the axis that it lies on.  `number` tells apart several marks of one part.
    `kind` and `points` (scene units): outline (its vertices), disc (its center, and `radius`), segment (two ends
    for each piece), arrow (tail, head), interval (the ends of a bar), bracket (a polyline), dot and label (one
    point; a label is centered on it, and newlines separate its lines).
    `role`: a colour of the theme.  `weight`: "plain", "strong" (what the step explains), "faint", "tint" (with a
    stronger fill), "fill" or "area" (a fill without a line, "area" a stronger one) or "title".
    `start`: where a pen that moves marks begins to move its points: one point for each, or one for all.
    `panel`: its picture, where several pictures are drawn as one.
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
        """Return an id, unique in its picture, by which a pen finds the same mark in the next picture."""
        known = self.panel, self.owner, self.part, self.axis, self.number
        return ".".join(str(fact) for fact in known if fact not in ("", None))

    @property
    def style(self) -> Style:
        """Return the style in which every pen draws this mark."""
        return style_of(self.kind, self.role, self.weight)


class SharedOptions(TypedDict, total=False):
    """The optional fields that a mark and a request for a label have in common."""

    owner: str
    axis: str
    number: int | None
    weight: str


class MarkOptions(SharedOptions, total=False):
    """The optional fields of a mark that is not a label."""

    radius: float
    start: tuple[Vec, ...]


class Picture(NamedTuple):
    """Marks in drawing order on a canvas.

    `limits`: the part of the scene that is shown (x min, y min, x max, y max), in scene units; `size`: the width and
    height of the canvas in points.  `sentence`: what the picture shows, made from the trace; the alternative text.
    `caption`: the same in a few words, which an animation has below its pictures; "" where there are no fewer.
    """

    marks: tuple[Mark, ...]
    limits: Box
    size: tuple[float, float]
    title: str
    sentence: str
    caption: str = ""

    @property
    def scale(self) -> float:
        """Return the points in a scene unit, the same in x and y."""
        return self.size[0] / (self.limits[2] - self.limits[0])

    def mark(self, mark_id: str) -> Mark:
        """Return the mark of that id; KeyError if there is none."""
        for mark in self.marks:
            if mark.id == mark_id:
                return mark
        raise KeyError(mark_id)

    @property
    def labels(self) -> tuple[Mark, ...]:
        """Return the marks that are labels, in drawing order."""
        return tuple(mark for mark in self.marks if mark.kind == "label")

    @property
    def texts(self) -> tuple[str, ...]:
        """Return the texts of the labels, in drawing order."""
        return tuple(mark.text for mark in self.labels)

    def __repr__(self) -> str:
        return f"<Picture: {self.sentence}>"

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, str]:
        """Return the picture and its sentence as a MIME bundle, which a notebook shows."""
        return hooks.mime_bundle(self)

    def data(self) -> dict[str, Any]:
        """Return the picture as JSON values: all that a pen needs."""
        data = {"satviz": "picture 1", "title": self.title, "sentence": self.sentence}
        return data | {"limits": list(self.limits), "size": list(self.size), **marks_data(self.marks)}

    def to_json(self, *, indent: int | None = None) -> str:
        """Return the picture as JSON text."""
        return json.dumps(self.data(), indent=indent, ensure_ascii=False, allow_nan=False)


def marks_data(marks: Iterable[Mark]) -> dict[str, Any]:
    """Return marks as JSON values: a table "styles" of the distinct styles, and marks that refer to its rows.

    Fields that have their default value are left out.
    """
    styles: dict[Style, int] = {}
    found = []
    for mark in marks:
        own = {name: value for name, value in _changed_fields(mark).items() if name not in ("kind", "role", "weight")}
        found.append({"id": mark.id, "style": styles.setdefault(mark.style, len(styles)), **own})
    return {"styles": [_changed_fields(style) for style in styles], "marks": found}


def _changed_fields(record: Mark | Style) -> dict[str, Any]:
    """Return the fields of a record that differ from their defaults, as JSON values."""
    defaults = record._field_defaults
    return {name: _as_lists(value) for name, value in record._asdict().items() if value != defaults.get(name)}


def _as_lists(value: Any) -> Any:
    """Return a value with its tuples as lists, as JSON has them."""
    return [_as_lists(v) for v in value] if isinstance(value, tuple) else value
