"""Pictures in a notebook: step through a trace, drag a scene.  (ipywidgets and anywidget live here only.)

What a widget shows and answers is in showing.py and exploring.py, which need neither: any front end can ask them.
"""

from importlib import import_module
from typing import TYPE_CHECKING

from ..optional_imports import needs

if TYPE_CHECKING:  # what is loaded when it is asked for, as type checkers see it
    from .explorer import Explorer, explore
    from .player import Player, play

__all__ = ["Explorer", "Player", "explore", "play"]

_LATER = {"Explorer": "explorer", "Player": "player", "explore": "explorer", "play": "player"}


def __getattr__(name: str) -> object:
    if name not in _LATER:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    try:
        import anywidget  # noqa: F401
    except ImportError as error:
        raise ImportError(needs("a widget", "jupyter")) from error
    return getattr(import_module(f".{_LATER[name]}", __name__), name)
