"""Shapes and scenes as JSON: what a scene file may say, read strictly."""

import json
import re
from dataclasses import dataclass, replace
from pathlib import Path
from stat import S_ISREG
from typing import Any

from ..engine import hooks
from ..engine.axes import NAMED, Chooser
from ..engine.geometry import InvalidScene, InvalidShape
from ..engine.polygon_validation import short_repr
from ..engine.shapes import Circle, Polygon, Shape
from ..engine.shortcut import Shortcut
from ..engine.trace import Trace, record
from .failing import SHORTCUTS
from .strictjson import parse, require_keys, require_type

MAX_CHARS = 1 << 20  # characters of a scene file
MAX_VERTICES = 1000  # vertices of a polygon: a trace has n + m axes with n + m landings each
NAME = re.compile(r"[a-z0-9]+(-[a-z0-9]+)*")
MAX_NAME_LETTERS = 60
CHOICES: dict[str, Chooser | Shortcut] = {**NAMED, **SHORTCUTS}


@dataclass(frozen=True, slots=True)
class Scene:
    """A scene: two shapes, the axes to test them on, a name for files and a title for people.

    `axes` is a name from satviz.axes.NAMED, or a shortcut's (`satviz scenes --failing` lists them);
    `every_axis` goes on past the early exit.
    """

    name: str
    a: Shape
    b: Shape
    axes: str = "needed"
    every_axis: bool = False
    title: str = ""

    def __post_init__(self) -> None:
        """Raise InvalidScene for a name, a title or axes that a scene must not have."""
        if not NAME.fullmatch(self.name) or len(self.name) > MAX_NAME_LETTERS:
            raise InvalidScene(
                f"the name {short_repr(self.name)} must be lower-case words or digits, joined by hyphens, with "
                f"at most {MAX_NAME_LETTERS} characters"
            )
        if not self.title.isprintable():
            raise InvalidScene(f"the title {short_repr(self.title)} must be one line of printable text")
        if self.axes not in CHOICES:
            raise InvalidScene(
                f"unknown axes {short_repr(self.axes)}: choose one of {', '.join(NAMED)}, or the name of a shortcut"
            )

    def record(self) -> Trace:
        """Run SAT on the scene's shapes and axes; return the Trace."""
        return record(self.a, self.b, axes=CHOICES[self.axes], every_axis=self.every_axis)

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, str]:
        """Return what a notebook shows: the trace's table and its last picture."""
        return hooks.mime_bundle(self)

    def to_json(self) -> str:
        """Return the scene as the text of a scene file."""
        data: dict[str, object] = {"satviz": "scene 1", "name": self.name, "title": self.title}
        data |= {"a": shape_data(self.a), "b": shape_data(self.b), "axes": self.axes, "every_axis": self.every_axis}
        return json.dumps(data, ensure_ascii=False)

    @staticmethod
    def from_json(text: str, unnamed: str = "scene") -> "Scene":
        """Return the scene of a scene file's text; InvalidScene names the field that is wrong.

        A scene without a name is called `unnamed`.
        """
        data = parse(text, MAX_CHARS)
        if isinstance(data, dict) and data.get("satviz") != "scene 1":
            raise InvalidScene('a scene file says which format it has: write "satviz": "scene 1" into it')
        require_keys(data, "the scene", {"satviz", "a", "b"}, {"name", "title", "axes", "every_axis"})
        return Scene(
            name=require_type(data.get("name", unnamed), "name", str),
            a=shape_from(data["a"], "a"),
            b=shape_from(data["b"], "b"),
            axes=require_type(data.get("axes", "needed"), "axes", str),
            every_axis=require_type(data.get("every_axis", False), "every_axis", bool),
            title=require_type(data.get("title", ""), "title", str),
        )


@dataclass(frozen=True, slots=True)
class SceneOfOwnAxes(Scene):
    """A scene whose axes have no name: the caller's own choice of axes, or shortcut.

    A file and a link cannot hold a function: there the scene has the axes `needed`.
    """

    choice: Chooser | Shortcut = NAMED["needed"]

    def record(self) -> Trace:
        """Run SAT on the scene's shapes and its own axes; return the Trace."""
        return record(self.a, self.b, axes=self.choice, every_axis=self.every_axis)


def with_axes(found: Scene, axes: str | Chooser | Shortcut) -> Scene:
    """Return the scene with other axes: a name, a choice of axes, or a shortcut, whose claim becomes the title.

    InvalidScene for an unknown name, TypeError for anything else.
    """
    if isinstance(axes, str):
        return replace(found, axes=axes)
    if not isinstance(axes, Shortcut) and not callable(axes):
        raise TypeError(f"axes is {short_repr(axes)}: pass a name, a function (a, b) -> Choice, or a Shortcut")
    title = axes.claim if isinstance(axes, Shortcut) else found.title
    return SceneOfOwnAxes(found.name, found.a, found.b, "needed", found.every_axis, title, axes)


def load(path: str | Path) -> Scene:
    """Return the Scene in the file at `path`; InvalidScene if it cannot be read or holds none.

    A scene without a name has that of its file, so two such scenes are not drawn into the same files.
    """
    path = Path(path)
    try:
        if not S_ISREG(path.stat().st_mode):  # a pipe would wait for its writer, a device may never end
            raise InvalidScene(f"cannot read {path}: it is not a regular file; give the path of one")
        with path.open("rb") as file:
            raw = file.read(MAX_CHARS + 1)
        text = raw.decode("utf-8-sig")
    except OSError as error:
        raise InvalidScene(f"cannot read {path}: {error.strerror or error}") from None
    except UnicodeDecodeError:
        raise InvalidScene(f"{path} is not UTF-8 text: save it as UTF-8") from None
    try:
        return Scene.from_json(text, re.sub("[^a-z0-9]+", "-", path.stem.lower())[:60].strip("-") or "scene")
    except InvalidScene as error:
        raise InvalidScene(f"{path}: {error}") from None


def shape_data(shape: Shape) -> dict[str, object]:
    """Return a shape as a dict for JSON; InvalidScene if it has too many vertices to be read again."""
    if shape.core_is_point:
        return {"circle": list(shape.core[0]), "radius": shape.radius}
    if len(shape.vertices) > MAX_VERTICES:
        many = len(shape.vertices)
        raise InvalidScene(f"a polygon has {many:,} vertices: a file can hold {MAX_VERTICES:,}; simplify it")
    data: dict[str, object] = {"polygon": [list(v) for v in shape.vertices]}
    if shape.labels:
        data["labels"] = list(shape.labels)
    return data


def shape_from(data: Any, where: str) -> Shape:
    """Return the shape that parsed JSON describes; InvalidScene names the wrong field, under `where`."""
    try:
        if isinstance(data, dict) and "circle" in data:
            require_keys(data, where, {"circle", "radius"})
            return Circle(_number_pair(data["circle"], f"{where}.circle"), data["radius"])
        require_keys(data, where, {"polygon"}, {"labels"})
        vertices = require_type(data["polygon"], f"{where}.polygon", list)
        if len(vertices) > MAX_VERTICES:
            raise InvalidScene(f"{where}.polygon has {len(vertices)} vertices: give at most {MAX_VERTICES}")
        vertices = [_number_pair(v, f"{where}.polygon[{i}]") for i, v in enumerate(vertices)]
        labels = data.get("labels")
        return Polygon(vertices, labels if labels is None else require_type(labels, f"{where}.labels", list))
    except InvalidShape as error:
        raise InvalidScene(f"{where}: {error}") from None


def _number_pair(value: Any, where: str) -> list[Any]:
    """Return the value if it is a list of two items, not checked further; InvalidScene otherwise."""
    if not isinstance(value, list) or len(value) != 2:
        raise InvalidScene(f"{where} must be a pair of numbers")
    return value
