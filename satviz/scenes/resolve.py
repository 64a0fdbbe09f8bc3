"""What a caller passed, resolved once: a built-in scene by name, a Scene, two shapes, a trace, or a refused case."""

from dataclasses import dataclass
from functools import cached_property

from ..engine.shapes import Shape, require_shape
from ..engine.trace import Trace
from .failing import FailureCase
from .named import refused_case, scene
from .scenefile import Scene

# what a function takes, in the words of its error line
EXPECT_SCENE = "a scene's name, a Scene, or two shapes"
EXPECT_RUN = "a scene's name, a Scene, or the trace of two shapes, sv.record(a, b)"
EXPECT_ANY = "a scene's name, a Scene, two shapes, or their trace, sv.record(a, b)"


@dataclass(frozen=True)
class Resolved:
    """What was passed to a public function, as a Scene, a Trace or a refused FailureCase.

    `given` is a Scene where a scene, its name or two shapes were passed, and a Trace where a trace was passed.
    It is a FailureCase only for the name of a failing case whose outlines the engine refuses: such a case has no
    shapes, no scene and no trace, and whoever draws it shows the raw outlines with the reason.
    `resolve` returns a Resolved unchanged: a function passes it on, so that its scene is recorded once.
    """

    given: Scene | Trace | FailureCase

    @property
    def refused(self) -> FailureCase | None:
        """Return the failing case whose outlines are refused; None for all else."""
        return self.given if isinstance(self.given, FailureCase) else None

    @property
    def shapes(self) -> tuple[Shape, Shape]:
        """Return both shapes; InvalidScene says why an outline is refused."""
        given = self.given if isinstance(self.given, Trace) else self.scene
        return given.a, given.b

    @property
    def scene(self) -> Scene:
        """Return the scene; TypeError for a trace, InvalidScene says why an outline is refused."""
        if isinstance(self.given, Trace):
            raise TypeError("this is a Trace, one run of two shapes: pass the shapes, trace.a and trace.b")
        return scene(self.given.name) if isinstance(self.given, FailureCase) else self.given

    @cached_property
    def trace(self) -> Trace:
        """Return the trace that was passed, or else record the scene, once; InvalidScene for a refused case."""
        return self.given if isinstance(self.given, Trace) else self.scene.record()


# one argument that stands for two shapes and the axes to test them on; one function passes a Resolved to another
SceneLike = Scene | Trace | str | Resolved


def resolve(what: SceneLike | Shape, b: Shape | None = None, *, expected: str = EXPECT_ANY) -> Resolved:
    """Return what a caller passed, as Resolved: a scene's name, a Scene, a trace, or, with `b`, two shapes.

    `expected` says for the error line what the calling function takes.
    InvalidScene for an unknown name, TypeError for anything that is not `expected`.
    """
    if b is not None:
        return Resolved(Scene("scene", require_shape(what, "a"), require_shape(b, "b")))
    if isinstance(what, str):
        return Resolved(refused_case(what) or scene(what))
    if isinstance(what, Scene | Trace):
        return Resolved(what)
    if isinstance(what, Resolved):
        return what
    raise TypeError(f"this is a {type(what).__name__}: pass {expected}")
