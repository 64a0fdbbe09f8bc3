"""satviz: 2D collision detection by the Separating Axis Theorem, made visible.

The engine needs the standard library only; pictures load matplotlib at first use.
"""

from . import axes
from .geometry import Interval, InvalidScene, InvalidShape, Relation, Vec
from .shapes import Circle, Polygon
from .verdict import relate

__version__ = "0.1.0"

# what is loaded at first use, so that importing satviz stays quick
_LATER = {
    "AxisTest": "sat",
    "Picture": "pictures",
    "Scene": "scenefile",
    "Stage": "pictures",
    "Step": "pictures",
    "Trace": "trace",
    "axis_tests": "sat",
    "draw": "render.drawn",
    "explore": "widgets",
    "gap_curve": "pictures.curve",
    "page": "render.page",
    "parts": "concave",
    "picture": "pictures",
    "play": "widgets",
    "record": "trace",
    "scene": "scenes",
    "steps": "pictures",
}

__all__ = [
    "Circle",
    "Interval",
    "InvalidScene",
    "InvalidShape",
    "Polygon",
    "Relation",
    "Vec",
    "__version__",
    "axes",
    "batch",
    "relate",
    *_LATER,
]


def __getattr__(name: str):
    if name == "batch":
        from importlib import import_module

        return import_module("satviz.batch")
    if name not in _LATER:
        raise AttributeError(f"module 'satviz' has no attribute {name!r}")
    from importlib import import_module

    value = getattr(import_module(f"{__name__}.{_LATER[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted(__all__)
