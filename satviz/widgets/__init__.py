"""Widgets in a notebook: step through a trace, drag a scene.  Only this package uses ipywidgets and anywidget.

What a widget shows and answers is computed in player_model.py and explorer_model.py, which need neither, so that
other front ends can use them.
"""

from importlib import import_module
from typing import TYPE_CHECKING

from ..optional_imports import extra_needed

if TYPE_CHECKING:  # type checkers see here the names that `__getattr__` loads at first use
    from .explorer import Explorer, explore
    from .player import Player, play

__all__ = ["Explorer", "Player", "explore", "play"]

_MODULE_OF = {"Explorer": "explorer", "Player": "player", "explore": "explorer", "play": "player"}


def __getattr__(name: str) -> object:
    """Return a public name, loading its module; ImportError says how to install what a widget needs."""
    if name not in _MODULE_OF:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}: dir({__name__}) lists its names")
    try:
        import anywidget  # noqa: F401
    except ImportError as error:
        raise ImportError(extra_needed("a widget", "jupyter")) from error
    return getattr(import_module(f".{_MODULE_OF[name]}", __name__), name)
