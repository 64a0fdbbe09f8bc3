"""Python objects as text: shapes and scenes of satviz, shapely, pymunk, lists, arrays, so that one reader reads all."""

import json
from typing import Any

from ...engine.geometry import InvalidScene
from ...engine.shapes import Circle, Polygon
from ...engine.trace import Trace
from ..scenefile import Scene


def as_text(value: Any) -> str:
    """Return shapes as a text that `paste` reads, with every digit; InvalidScene for what holds no shapes."""
    if isinstance(value, (bytes, bytearray, memoryview)) or value is None:
        raise InvalidScene(f"expected text or shapes, not {type(value).__name__}")
    if isinstance(value, (list, tuple)) and not _is_numeric(value):
        return "\n".join(map(_line, value))
    return _line(value)


def _is_numeric(value: Any) -> bool:
    """Return whether a list holds numbers, or lists of them, and no shapes."""
    return all(isinstance(v, (int, float, list, tuple)) and not isinstance(v, bool) for v in value) and all(
        _is_numeric(v) for v in value if isinstance(v, (list, tuple))
    )


def _line(value: Any) -> str:
    """Return one object as a line of text."""
    if isinstance(value, str):
        return value
    if isinstance(value, Circle):
        return f"circle(({value.center.x!r}, {value.center.y!r}), {value.radius!r})"
    if isinstance(value, Polygon):
        return f"polygon({[list(v) for v in value.vertices]!r})"
    if isinstance(value, (Scene, Trace)):
        return f"{_line(value.a)}\n{_line(value.b)}"
    interface = getattr(value, "__geo_interface__", None)
    if interface is not None:
        return json.dumps(interface)
    body = getattr(value, "body", None)
    if body is not None and hasattr(value, "get_vertices"):  # pymunk's Poly
        return f"polygon({[[*map(float, body.local_to_world(v))] for v in value.get_vertices()]!r})"
    if body is not None and hasattr(value, "radius") and hasattr(value, "offset"):  # pymunk's Circle
        x, y = map(float, body.local_to_world(value.offset))
        return f"circle(({x!r}, {y!r}), {float(value.radius)!r})"
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, (list, tuple)) and _is_numeric(value):
        return repr(value)
    if isinstance(value, (list, tuple)):
        return "\n".join(map(_line, value))
    raise InvalidScene(f"a {type(value).__name__} holds no shape that can be read: pass text, lists, arrays or shapes")
