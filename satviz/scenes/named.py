"""Every scene by its name: the article's and the failing ones."""

from ..engine.geometry import InvalidScene
from ..engine.polygon_validation import shown
from .article import SCENES
from .failing import NAMED as FAILING
from .scenefile import Scene

ARTICLE = {scene.name: scene for scene in SCENES}


def names() -> list[str]:
    """Every name that `scene` knows, the article's first."""
    return [*ARTICLE, *FAILING]


def scene(name: str) -> Scene:
    """The built-in scene of that name, also a failing one; InvalidScene lists the names or tells why it is no scene."""
    if name in FAILING:
        return FAILING[name].scene
    if name not in ARTICLE:
        raise InvalidScene(f"no scene {shown(name)}: choose one of {', '.join(names())}, or give a file")
    return ARTICLE[name]
