"""Scenes and traces as files, the article's scenes, and those where shortcuts fail.

The package can be called: `satviz.scenes()` returns every built-in scene.
"""

import sys
from types import ModuleType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .scenefile import Scene


class _Scenes(ModuleType):
    """The package as a function, since a package and a function of the public face have the same name."""

    def __call__(self) -> "list[Scene]":
        """Return every built-in scene, as `named.scenes` does."""
        from .named import scenes

        return scenes()


sys.modules[__name__].__class__ = _Scenes
