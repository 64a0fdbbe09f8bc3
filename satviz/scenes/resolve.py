"""What may be asked to be shown: a built-in scene by name, a Scene, two shapes, or a trace."""

from typing import Any

from ..engine.shapes import Shape, checked
from ..engine.trace import Trace, record
from .failing import NAMED, REFUSED, FailureCase
from .named import scene
from .scenefile import Scene

SceneLike = Scene | Trace | str  # what has a run by itself
# what may be passed, by what the function takes
SCENES = "a scene's name, a Scene, or two shapes"
RUNS = "a scene's name, a Scene, or the trace of two shapes, sv.record(a, b)"
ALL = "a scene's name, a Scene, two shapes, or their trace, sv.record(a, b)"


def scene_of(what: Scene | Shape | str, b: Shape | None = None, *, takes: str = SCENES) -> Scene:
    """The scene that is meant; InvalidScene for an unknown name, TypeError for anything but what `takes` says."""
    if b is not None:
        return Scene("scene", checked(what, "a"), checked(b, "b"))
    found: Any = scene(what) if isinstance(what, str) else what
    if isinstance(found, Scene):
        return found
    if isinstance(found, Trace):
        raise TypeError("this is a Trace, one run of two shapes: pass the shapes, trace.a and trace.b")
    raise TypeError(f"this is a {type(found).__name__}: pass {takes}")


def pair_of(what: SceneLike | Shape, b: Shape | None = None) -> tuple[Shape, Shape]:
    """The two shapes that are meant, which need no run."""
    if isinstance(what, Trace) and b is None:
        return what.a, what.b
    found = scene_of(what, b, takes=ALL)  # type: ignore[arg-type]
    return found.a, found.b


def trace_of(what: SceneLike | Shape, b: Shape | None = None, *, takes: str = ALL) -> Trace:
    """The run that is meant; InvalidScene for an unknown name, TypeError for anything but what `takes` says."""
    if b is not None:
        return record(checked(what, "a"), checked(b, "b"))
    found: Any = scene(what) if isinstance(what, str) else what
    if isinstance(found, Scene):
        return found.record()
    if isinstance(found, Trace):
        return found
    raise TypeError(f"this is a {type(found).__name__}: pass {takes}")


def refused_case(what: object) -> FailureCase | None:
    """The failing scene of that name whose outlines are refused, so that it has no run; None for all else."""
    row = NAMED.get(what) if isinstance(what, str) else None
    return row if row and row.how == REFUSED else None
