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


class MotionState:
    """Hold what stays the same while a batch moves: numbers of corners, radii, and the outlines before the first move.

    start: (N + 1,) where each shape's corners begin; radius: (N,), 0 for polygons; corners: the number of corners if
    all shapes have the same number, else 0; outlines: (M, 2) coordinates from which `place` computes each new place.
    """

    def __init__(self, shapes: Shapes) -> None:
        if shapes.owner is not None:
            raise InvalidShape(
                "a batch with split concave polygons cannot be moved, since its rounded outlines may be split "
                "in another way: make a new batch from the moved outlines"
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
    state = _state_of(check_shapes(shapes, "shapes"))
    _set_corners(shapes, state, corners)
    return shapes


def place(shapes: Shapes, offsets: validation.Points, angles: Any = 0.0) -> Shapes:
    """Rotate each shape about (0, 0), then move it, and return the batch; it starts from its first outlines each time.

    offsets: (N, 2) in scene units; angles: (N,) in radians, or one for all, counter-clockwise.  The first outlines are
    those that the batch was made with.  The new coordinates are floats, rounded, and are checked as in `move`: a corner
    that is nearly straight can become straight or concave.  InvalidShape as in `move`.
    """
    state = _state_of(check_shapes(shapes, "shapes"))
    n = len(state.start) - 1
    offsets = validation.points(offsets, "offsets", lambda i: f"offset {i}")
    angles = validation.numbers(angles, "angles", "angle", lambda i: f"angle {i}")
    if len(offsets) != n or angles.shape not in ((), (1,), (n,)):
        raise InvalidShape(
            f"there are {len(offsets)} offsets and {angles.size} angles for {n} shapes: "
            f"give {n} offsets, and {n} angles or one"
        )
    many = np.diff(state.start)
    cos, sin = (np.repeat(np.broadcast_to(f(angles), (n,)), many) for f in (np.cos, np.sin))
    x, y = state.outlines.T
    corners = np.repeat(offsets, many, axis=0)
    with np.errstate(all="ignore"):
        corners[:, 0] += cos * x - sin * y
        corners[:, 1] += sin * x + cos * y
    try:
        _set_corners(shapes, state, corners)
    except InvalidShape as error:
        raise InvalidShape(f"{error} (its moved coordinates are rounded to floats; move it elsewhere)") from None
    return shapes


def _state_of(shapes: Shapes) -> MotionState:
    """Return the MotionState that a moved batch keeps; a new one for a batch that was never moved."""
    state = vars(shapes).get("_motion")
    return state if isinstance(state, MotionState) else MotionState(shapes)


def _set_corners(shapes: Shapes, state: MotionState, corners: Any) -> None:
    """Check `corners`, as `move` takes them, and replace the coordinates of the batch by them.

    The batch gets new arrays; its old ones are not changed.
    """
    made = _certified(state, corners) or _checked(state, corners)
    vars(shapes).clear()
    vars(shapes).update(vars(made), _motion=state)


def _certified(state: MotionState, corners: Any) -> Shapes | None:
    """Return a new batch with these coordinates if floats certify them as valid; None if they need slower checks."""
    if type(corners) is not np.ndarray or corners.dtype != np.float64 or not corners.flags.carray:
        return None
    warn_if_flushed()
    kernels, n = engine_for_checks(int(state.start[-1])), len(state.start) - 1
    forms = (n, state.corners, 2), (n * state.corners, 2)
    if 3 <= state.corners <= MAX_LANE_CORNERS and corners.shape in forms:
        group = kernels.certified_group(corners.reshape(forms[0]))
        return None if group is None else Shapes(runs=[group])
    if kernels.certified_rings is None or corners.shape != (state.start[-1], 2):
        return None
    rings, doubtful = kernels.certified_rings(corners, state.start, True)
    return None if doubtful.size else Shapes(rings=rings, radius=state.radius)


def _checked(state: MotionState, corners: Any) -> Shapes:
    """Return a new batch with these coordinates after exact checks; InvalidShape names the first shape at fault."""
    refuse_masked(corners, "corners")
    total = int(state.start[-1])
    if not isinstance(corners, np.ndarray):
        corners = _array_of_outlines(state, corners)
    if isinstance(corners, np.ndarray) and corners.ndim == 3:
        if corners.shape[0] != len(state.start) - 1 or corners.shape[2] != 2:
            raise InvalidShape(f"corners has the shape {corners.shape}: expected {_form(state)}")
        if corners.shape[1] != state.corners and not state.radius.any():
            return _check_corner_counts(state, number_polygons(corners, None, None))
        corners = corners.reshape(-1, 2)

    name = corner_name(state.start, state.radius)
    points = validation.points(corners, "corners", lambda k: name(k) if k < total else f"corner {k}")
    if len(points) != total:
        raise InvalidShape(f"corners holds {len(points)} points: expected {_form(state)}")
    return build_mixed(points, state.start, state.radius, None)


def _array_of_outlines(state: MotionState, corners: Any) -> Any:
    """Return a sequence of outlines with one number of corners as an (N, V, 2) array, checked number by number.

    If the batch has circles, return a list of all points, unchecked; anything else is returned as it is.
    """
    try:
        corners = list(corners)
        if not corners or np.ndim(corners[0]) != 2:
            return corners
    except (TypeError, ValueError):  # not a sequence, or an outline that is none
        return corners
    if state.radius.any():
        return [point for outline in corners for point in outline]
    points, start = validation.rings_from_sequence(corners, "polygon {}".format)
    many = np.diff(start)
    return points.reshape(len(many), many[0], 2) if (many == many[0]).all() else corners


def _check_corner_counts(state: MotionState, made: Shapes) -> Shapes:
    """Return `made`; InvalidShape unless each polygon in it has as many distinct corners as before the move."""
    own = np.diff(state.start)
    if (other := np.flatnonzero(made.count != own)).size:
        i = other[0]
        raise InvalidShape(
            f"polygon {i} has {made.count[i]} corners with these coordinates, but had {own[i]}: make a new batch of "
            "these shapes, or give coordinates in which no corner repeats or lies on a straight edge"
        )
    return made


def _form(state: MotionState) -> str:
    """Return in words which shapes of array `move` takes for this batch, for error messages."""
    n, total = len(state.start) - 1, int(state.start[-1])
    whole = f"({total}, 2), all corners one after another"
    return f"({n}, {state.corners}, 2) or {whole}" if state.corners else whole
