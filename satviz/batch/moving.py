"""Shapes that move: new coordinates for a batch whose shapes stay the same, checked as exactly as when it was made."""

from typing import Any

import numpy as np

from ..engine.geometry import InvalidShape
from ..engine.polygon_validation import refuse_masked
from ..engine.predicates import warn_if_flushed
from . import validation
from .array_types import Array, Indices
from .arrays import Shapes, check_shapes
from .constructors import build_mixed, corner_name, number_polygons
from .engines import engine_for_checks
from .ragged import MAX_LANE_CORNERS


class Frame:
    """Hold what stays the same while a batch moves, and the memory of the coordinates before the present ones.

    start: (N + 1,) where each shape's corners begin, as the batch held them at its first move; radius: (N,), 0 for
    polygons; corners: their number if all shapes have the same; outlines: (M, 2) coordinates that `place` turns.
    """

    def __init__(self, shapes: Shapes) -> None:
        if shapes.owner is not None:
            raise InvalidShape(
                "a batch with split concave polygons cannot be moved, since rounded coordinates may split in another "
                "way: make a new batch from the moved outlines"
            )
        self.start: Indices = shapes.rings.start
        self.radius: Array = shapes.radius
        self.corners = int(shapes.count[0]) if shapes.uniform is not None else 0
        self.outlines: Array = np.stack(shapes.rings[:2], axis=1)


def move(shapes: Shapes, corners: validation.Points) -> Shapes:
    """Give the shapes of a batch new coordinates and return the batch.

    corners: (N, V, 2), where an outline with fewer than V corners repeats one; or (M, 2) corners one after another, as
    many of each shape as it had when the batch was made (the center of a circle); in scene units.  Finiteness, winding
    and convexity are checked exactly in one pass; what is given is not kept.  InvalidShape names the first shape at
    fault, and the batch stays as it was; likewise for another number of corners and for parts of concave polygons.
    No other thread may use the batch meanwhile.
    """
    frame = _frame_of(check_shapes(shapes, "shapes"))
    _set_corners(shapes, frame, corners)
    return shapes


def place(shapes: Shapes, offsets: validation.Points, angles: Any = 0.0) -> Shapes:
    """Turn each shape about (0, 0), then move it, and return the batch; it starts from its first outlines each time.

    offsets: (N, 2) in scene units; angles: (N,) in radians, or one for all, counter-clockwise.  The first outlines are
    those that the batch was made with.  The new coordinates are floats, rounded, and are checked as in `move`: a corner
    that is nearly straight can become straight or concave.  InvalidShape as in `move`.
    """
    frame = _frame_of(check_shapes(shapes, "shapes"))
    n = len(frame.start) - 1
    offsets = validation.points(offsets, "offsets", lambda i: f"offset {i}")
    angles = validation.numbers(angles, "angles", "angle", lambda i: f"angle {i}")
    if len(offsets) != n or angles.shape not in ((), (1,), (n,)):
        raise InvalidShape(f"there are {len(offsets)} offsets and {angles.size} angles for {n} shapes")
    many = np.diff(frame.start)
    cos, sin = (np.repeat(np.broadcast_to(f(angles), (n,)), many) for f in (np.cos, np.sin))
    x, y = frame.outlines.T
    corners = np.repeat(offsets, many, axis=0)
    with np.errstate(all="ignore"):
        corners[:, 0] += cos * x - sin * y
        corners[:, 1] += sin * x + cos * y
    try:
        _set_corners(shapes, frame, corners)
    except InvalidShape as error:
        raise InvalidShape(f"{error} (the coordinates of the new place are rounded to floats)") from None
    return shapes


def _frame_of(shapes: Shapes) -> Frame:
    """Return the Frame of a batch, made at its first move."""
    frame = vars(shapes).get("_frame")
    return frame if isinstance(frame, Frame) else Frame(shapes)


def _set_corners(shapes: Shapes, frame: Frame, corners: Any) -> None:
    """Check the coordinates and make them those of the batch; its old arrays are not changed, only replaced."""
    made = _certified(frame, corners) or _checked(frame, corners)
    vars(shapes).clear()
    vars(shapes).update(vars(made), _frame=frame)


def _certified(frame: Frame, corners: Any) -> Shapes | None:
    """Return a batch of the frame's shapes with these coordinates; None if they need slower checks."""
    if type(corners) is not np.ndarray or corners.dtype != np.float64 or not corners.flags.carray:
        return None
    warn_if_flushed()
    kernels, n = engine_for_checks(int(frame.start[-1])), len(frame.start) - 1
    forms = (n, frame.corners, 2), (n * frame.corners, 2)
    if 3 <= frame.corners <= MAX_LANE_CORNERS and corners.shape in forms:
        group = kernels.certified_group(corners.reshape(forms[0]))
        return None if group is None else Shapes(runs=[group])
    if kernels.certified_rings is None or corners.shape != (frame.start[-1], 2):
        return None
    rings, doubtful = kernels.certified_rings(corners, frame.start, True)
    return None if doubtful.size else Shapes(rings=rings, radius=frame.radius)


def _checked(frame: Frame, corners: Any) -> Shapes:
    """Return a batch of the frame's shapes with these coordinates; InvalidShape names the first one at fault."""
    refuse_masked(corners, "corners")
    total = int(frame.start[-1])
    if not isinstance(corners, np.ndarray):
        corners = _array_of_outlines(corners)
    if isinstance(corners, np.ndarray) and corners.ndim == 3:
        if corners.shape[0] != len(frame.start) - 1 or corners.shape[2] != 2:
            raise InvalidShape(f"corners has the shape {corners.shape}: expected {_form(frame)}")
        if corners.shape[1] != frame.corners and not frame.radius.any():
            return _same_topology(frame, number_polygons(corners, None, None))
        corners = corners.reshape(-1, 2)

    name = corner_name(frame.start, frame.radius)
    points = validation.points(corners, "corners", lambda k: name(k) if k < total else f"corner {k}")
    if len(points) != total:
        raise InvalidShape(f"corners holds {len(points)} points: expected {_form(frame)}")
    return build_mixed(points, frame.start, frame.radius, None)


def _array_of_outlines(corners: Any) -> Any:
    """Return a sequence of outlines with one number of corners as an (N, V, 2) array; anything else as it is."""
    try:
        corners = list(corners)
        array = np.array(corners) if corners and np.ndim(corners[0]) == 2 else None
    except (TypeError, ValueError):  # not a sequence, or outlines of several lengths
        return corners
    return corners if array is None or array.ndim != 3 or array.dtype.kind not in "fiu" else array


def _same_topology(frame: Frame, made: Shapes) -> Shapes:
    """Return the polygons made of an array in which outlines repeat corners; InvalidShape for another topology."""
    own = np.diff(frame.start)
    if (other := np.flatnonzero(made.count != own)).size:
        i = other[0]
        raise InvalidShape(
            f"polygon {i} has {made.count[i]} corners with these coordinates, but had {own[i]}: make a new batch of "
            "these shapes, or give coordinates in which no corner repeats or lies on a straight edge"
        )
    return made


def _form(frame: Frame) -> str:
    """Return which array of corners this batch takes, in words."""
    n, total = len(frame.start) - 1, int(frame.start[-1])
    whole = f"({total}, 2), all corners one after another"
    return f"({n}, {frame.corners}, 2) or {whole}" if frame.corners else whole
