"""sv.draw: one step of a trace on a matplotlib Figure, or on Axes of one's own."""

from typing import TYPE_CHECKING
from weakref import WeakKeyDictionary

from ..pictures import THEMES, Picture, Step, picture
from ..trace import Trace
from .files import canvas
from .pen import Pen

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


_PENS: "WeakKeyDictionary[Axes, Pen]" = WeakKeyDictionary()  # a second picture takes the place of the first


def draw(
    what: Trace | Picture, step: int | Step = -1, *, ax: "Axes | None" = None, theme: str = "light"
) -> "Figure | dict":
    """Draw a step of a trace (or a picture) with matplotlib.

    Without `ax` the result is a new Figure (no pyplot); with it the marks go on those
    Axes in place of an earlier picture, labels placed for their size, and the result is
    the artists by mark id.
    `theme` is "light" or "dark".  IndexError for a step the trace does not have.
    """
    if theme not in THEMES:
        raise ValueError(f"unknown theme {theme!r}: choose one of {', '.join(THEMES)}")
    if ax is None:
        shown = what if isinstance(what, Picture) else picture(what, step)
        fig, pen = canvas(shown.size, THEMES[theme])
        pen.draw(shown)
        return fig
    box = ax.get_window_extent()
    points = 72 / ax.figure.dpi
    largest = box.width * points, box.height * points
    shown = what if isinstance(what, Picture) else picture(what, step, largest=largest)
    if ax not in _PENS or _PENS[ax].theme.name != theme:
        if ax in _PENS:
            _PENS[ax].remove()
        _PENS[ax] = Pen(ax, THEMES[theme])
    return _PENS[ax].draw(shown)
