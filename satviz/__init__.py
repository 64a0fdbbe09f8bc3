"""satviz: 2D collision detection by the Separating Axis Theorem, made visible.

The engine and the pictures need the standard library only; drawing loads matplotlib at first use.
"""

from typing import TYPE_CHECKING

from .engine import axes, hooks
from .engine.geometry import Interval, InvalidScene, InvalidShape, Relation, Vec
from .engine.relate import relate
from .engine.shapes import Circle, Polygon

if TYPE_CHECKING:  # type checkers see here the names that `__getattr__` loads at first use
    from . import batch, testing
    from .advice.advising import Recommendation, advise
    from .checking.checked import Checked
    from .checking.checker import check
    from .engine.convex_parts import parts
    from .engine.sat import AxisTest, axis_tests
    from .engine.shortcut import Shortcut
    from .engine.trace import Trace, record
    from .lessons.handout import handout
    from .pictures import Picture, Stage, Step, picture, steps
    from .pictures.curve import gap_curve
    from .pictures.difference_steps import difference_steps
    from .pictures.minkowski import difference
    from .pictures.sheet import sheet
    from .pictures.turning_axis import sweep
    from .render.draw import draw
    from .render.embed import embed
    from .render.page import page
    from .scenes.link import link
    from .scenes.named import scene, scenes
    from .scenes.paste.pasted import Pasted, paste
    from .scenes.scenefile import Scene
    from .widgets import explore, play

__version__ = "0.1.0"

__all__ = [
    "AxisTest",
    "Checked",
    "Circle",
    "Interval",
    "InvalidScene",
    "InvalidShape",
    "Pasted",
    "Picture",
    "Polygon",
    "Recommendation",
    "Relation",
    "Scene",
    "Shortcut",
    "Stage",
    "Step",
    "Trace",
    "Vec",
    "__version__",
    "advise",
    "axes",
    "axis_tests",
    "batch",
    "check",
    "difference",
    "difference_steps",
    "draw",
    "embed",
    "explore",
    "gap_curve",
    "handout",
    "link",
    "page",
    "parts",
    "paste",
    "picture",
    "play",
    "record",
    "relate",
    "scene",
    "scenes",
    "sheet",
    "steps",
    "sweep",
    "testing",
]

# Shapes, traces and scenes show, describe and save themselves with these functions of higher modules.
hooks.provide(
    mime_bundle="satviz.render.notebook:bundle",
    shortcut_error="satviz.pictures.claims:error_in_words",
    trace_sentence="satviz.engine.describe:verdict_sentence",
    trace_table="satviz.engine.text_table:table",
    trace_to_json="satviz.scenes.tracefile:dump",
    trace_from_json="satviz.scenes.tracefile:load",
)

# The module of each name that is loaded at first use, so that `import satviz` stays quick.
_MODULE_OF = {
    "Recommendation": "advice.advising",
    "AxisTest": "engine.sat",
    "Pasted": "scenes.paste.pasted",
    "Checked": "checking.checked",
    "Picture": "pictures",
    "Scene": "scenes.scenefile",
    "Shortcut": "engine.shortcut",
    "Stage": "pictures",
    "Step": "pictures",
    "Trace": "engine.trace",
    "advise": "advice.advising",
    "axis_tests": "engine.sat",
    "check": "checking.checker",
    "difference": "pictures.minkowski",
    "difference_steps": "pictures.difference_steps",
    "draw": "render.draw",
    "embed": "render.embed",
    "explore": "widgets",
    "gap_curve": "pictures.curve",
    "handout": "lessons.handout",
    "link": "scenes.link",
    "page": "render.page",
    "parts": "engine.convex_parts",
    "paste": "scenes.paste.pasted",
    "picture": "pictures",
    "play": "widgets",
    "record": "engine.trace",
    "scene": "scenes.named",
    "sheet": "pictures.sheet",
    "steps": "pictures",
    "sweep": "pictures.turning_axis",
}

# Public modules that are loaded at first use.
_MODULES = {"batch": "satviz.batch", "scenes": "satviz.scenes", "testing": "satviz.testing"}  # scenes() is called


def __getattr__(name: str) -> object:
    """Return a public name, loading its module at the first use."""
    from importlib import import_module

    if name in _MODULES:
        return import_module(_MODULES[name])
    if name not in _MODULE_OF:
        raise AttributeError(f"module 'satviz' has no attribute {name!r}: dir(satviz) lists its names")
    value = getattr(import_module(f"{__name__}.{_MODULE_OF[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    """Return all public names, loaded or not."""
    return sorted(__all__)
