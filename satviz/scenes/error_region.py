"""The moves of B for which a shortcut's answer is wrong, with exact boundaries; for any shortcut."""

from ..engine.geometry import InvalidShape
from ..engine.shapes import Shape
from ..engine.shortcut import Shortcut
from .failing import case_of
from .failing.move_space import RegionOrReason, Window, hits_in_window
from .failing.region_of_axes import region_of_verdict
from .shape_tools import vertex_mean

TOO_SMALL = "the shapes are so small beside their moves that float64 cannot tell their corners apart"
TOO_MANY_CORNERS = "the parts of these shapes have too many corners to work it out while you drag"
MAX_PART_CORNERS = 300  # corners of A - B over all pairs of parts: each polygon is cut by all others


def error_region(a: Shape, b: Shape, shortcut: Shortcut, window: Window) -> RegionOrReason:
    """Return the moves of B in the window (x0, y0, x1, y1) for which the shortcut's answer is wrong.

    Where no area shows these moves, return the reason instead: a text without a full stop, to follow a colon.
    """
    try:
        hits = hits_in_window(a, b, window)
        if len(hits) > 1 and sum(map(len, hits)) > MAX_PART_CORNERS:
            return TOO_MANY_CORNERS
        case = case_of(shortcut)
        if case and case.error_region:
            return case.error_region(a, b, window)
        return region_of_verdict(a, b, shortcut, window)
    except InvalidShape:
        return TOO_SMALL


def error_region_in_view(a: Shape, b: Shape, shortcut: Shortcut, view: Window) -> RegionOrReason:
    """Return the error region, or the reason why there is none, for the moves that bring B's vertex mean into view.

    `view` is (x0, y0, x1, y1) in scene coordinates; the region is in moves of B.
    """
    mean, (x0, y0, x1, y1) = vertex_mean(b), view
    return error_region(a, b, shortcut, (x0 - mean.x, y0 - mean.y, x1 - mean.x, y1 - mean.y))
