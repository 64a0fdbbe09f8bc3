"""The forms in which a function under test gets its shapes, and the data that can be pasted back."""

from collections.abc import Callable
from typing import Any

from ..engine.geometry import Vec
from ..engine.shapes import Circle, Polygon, Shape

Form = Callable[[Shape], Any]


def plain_number(value: float) -> float:
    """Return the number as an int if it is whole and below 2**53, else unchanged."""
    return int(value) if value == int(value) and abs(value) < 2**53 else value


def plain_points(points: "tuple[Vec, ...]") -> list[tuple[float, float]]:
    """Return points as a new list of plain (x, y), whole numbers as int."""
    return [(plain_number(x), plain_number(y)) for x, y in points]


def as_points(shape: Shape) -> Any:
    """Return a polygon as a list of (x, y), and a circle as ((x, y), radius)."""
    if isinstance(shape, Circle):
        return plain_points((shape.center,))[0], plain_number(shape.radius)
    return plain_points(shape.vertices)


def as_dict(shape: Shape) -> Any:
    """Return {"polygon": [[x, y], ...]} or {"circle": [x, y], "radius": r}, as in a scene file."""
    if isinstance(shape, Circle):
        return {"circle": list(plain_points((shape.center,))[0]), "radius": plain_number(shape.radius)}
    return {"polygon": [list(point) for point in plain_points(shape.vertices)]}


def as_xy(shape: Shape) -> Any:
    """Return a polygon as (xs, ys), two lists, and a circle as (x, y, radius)."""
    if isinstance(shape, Circle):
        (x, y), radius = as_points(shape)
        return x, y, radius
    points = plain_points(shape.vertices)
    return [x for x, _ in points], [y for _, y in points]


FORMS: dict[str, Form] = {"points": as_points, "dicts": as_dict, "xy": as_xy, "shapes": lambda shape: shape}


def pasteable(shape: Shape) -> str:
    """Return Python code that makes the shape: "sv.Polygon([(0, 0), (1, 0), (0, 1)])"."""
    if isinstance(shape, Circle):
        center, radius = as_points(shape)
        return f"sv.Circle({center}, {radius})"
    assert isinstance(shape, Polygon)
    return f"sv.Polygon({plain_points(shape.vertices)})"
