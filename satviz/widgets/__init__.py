"""Pictures in a notebook: step through a trace, drag a scene.  (ipywidgets and anywidget live here only.)"""

from ..extras import needs

try:
    import anywidget  # noqa: F401
except ImportError as error:
    raise ImportError(needs("a widget", "jupyter")) from error

from .explorer import Explorer, explore
from .player import Player, play

__all__ = ["Explorer", "Player", "explore", "play"]
