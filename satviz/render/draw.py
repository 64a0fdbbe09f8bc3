"""sv.draw: one step of a trace on a new matplotlib Figure, or on given Axes."""

from typing import TYPE_CHECKING, overload

from matplotlib.axes import Axes

from ..pictures import THEMES, Picture, Step, Theme, picture
from ..scenes.resolve import SceneLike
from .files import canvas
from .pen import Pen

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.figure import Figure


_PEN_ATTRIBUTE = "_satviz_pen"  # kept on the Axes themselves, so that it goes when they go


@overload
def draw(what: SceneLike | Picture, step: int | Step = -1, *, ax: None = None, theme: str = "light") -> "Figure": ...


@overload
def draw(
    what: SceneLike | Picture, step: int | Step = -1, *, ax: Axes, theme: str = "light"
) -> "dict[str, Artist]": ...


def draw(
    what: SceneLike | Picture, step: int | Step = -1, *, ax: Axes | None = None, theme: str = "light"
) -> "Figure | dict[str, Artist]":
    """Draw a step of a trace (or of a scene, by name too), or a picture, with matplotlib.

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
    if not isinstance(ax, Axes):
        raise TypeError(f"ax is a {type(ax).__name__}: pass matplotlib Axes")
    box = ax.get_window_extent()
    points = 72 / ax.figure.dpi
    largest = max(box.width * points, 1.0), max(box.height * points, 1.0)  # Axes may be squeezed to nothing
    shown = what if isinstance(what, Picture) else picture(what, step, largest=largest)
    # a picture that needs more space than the Axes have is shown smaller, its letters too
    zoom = min(1.0, *(space / size for space, size in zip(largest, shown.size, strict=True)))
    return _pen_of(ax, THEMES[theme]).draw(shown, zoom=zoom)


def _pen_of(ax: Axes, theme: Theme) -> Pen:
    """Return the pen kept on the Axes, so that a second picture replaces the first; a new pen after ax.clear()."""
    pen: Pen | None = getattr(ax, _PEN_ATTRIBUTE, None)
    there = pen is not None and pen.fills in ax.collections
    if pen is None or not there or pen.theme != theme:
        if pen is not None and there:
            pen.remove()
        pen = Pen(ax, theme)
        setattr(ax, _PEN_ATTRIBUTE, pen)
    return pen
