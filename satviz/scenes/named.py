"""Every built-in scene by its name: the article's scenes and the failing cases."""

from collections.abc import Sequence
from difflib import get_close_matches

from ..engine.geometry import InvalidScene, InvalidShape
from ..engine.polygon_validation import short_repr
from .article import SCENES
from .failing import FAILURE_CASES, REFUSED, FailureCase
from .failing import NAMED as FAILING
from .scenefile import Scene

ARTICLE = {scene.name: scene for scene in SCENES}


def names() -> list[str]:
    """Return every name that `scene` knows, the article's first."""
    return [*ARTICLE, *FAILING]


def did_you_mean(name: str, known: Sequence[str]) -> str:
    """Return the end of an error line: it suggests the known name most like `name`, or lists all known names."""
    near = get_close_matches(name, known, n=1)
    return f": did you mean {near[0]}?" if near else f": choose one of {', '.join(known)}"


def scene(name: str) -> Scene:
    """Return the built-in scene of a name, also of a failing case.

    InvalidScene lists the names if this one is unknown, and gives the reason if the outlines are refused.
    """
    if name in FAILING:
        return scene_of_case(FAILING[name])
    if name not in ARTICLE:
        raise InvalidScene(f"there is no scene {short_repr(name)}{did_you_mean(str(name), names())}")
    return ARTICLE[name]


def scene_of_case(case: FailureCase) -> Scene:
    """Return a failing case as a scene with its shortcut; InvalidScene where the engine refuses its outlines."""
    try:
        a, b = case.shapes
    except InvalidShape as error:
        raise InvalidScene(f"the scene {case.name} is refused on purpose: {error}") from None
    return Scene(case.name, a, b, case.name, title=case.claim)


def refused_case(name: str) -> FailureCase | None:
    """Return the failing case of that name if the engine refuses its outlines; None for any other name or text."""
    case = FAILING.get(name)
    return case if case and case.how == REFUSED else None


def scenes() -> list[Scene]:
    """Return every built-in scene: the article's first, then those where a shortcut fails, with its claim as title.

    A failing case whose outlines are refused has no scene; `satviz.draw` draws it by its name.
    """
    return list(ALL_SCENES)


ALL_SCENES = (*SCENES, *(scene_of_case(case) for case in FAILURE_CASES if case.how != REFUSED))
