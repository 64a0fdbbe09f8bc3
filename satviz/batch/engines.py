"""The two engines of `batch`, NumPy and numba: which one answers, and the kernels of each."""

import sys
import warnings
from collections.abc import Callable
from functools import cache
from importlib.util import find_spec
from typing import Any, NamedTuple

from ..optional_imports import extra_needed
from . import validation
from .array_types import GridKernel
from .ragged import MAX_LANE_CORNERS

Kernel = Callable[..., None]
NUMBA_MODULE = f"{__package__}.with_numba.outlines"  # it is there if numba has been loaded
MAX_NUMPY_CORNERS = 1 << 24  # NumPy checks these in less time than numba takes to load


class Engine(NamedTuple):
    """Hold the kernels of one engine (NumPy or numba); each fills `out`, with UNDECIDED where floats cannot tell.

    `polygons`, `boxes`, `circles` and `circle_polygons` relate column k of one CornerColumns with column k of another;
    `exact_columns` decides the columns that they leave undecided; `indexed` relates pairs from anywhere in two batches.
    `candidate_pairs` (of few boxes) and `grid` are the broad phase; `colliding_pairs` goes from few shapes to all
    their collisions.  `certified_group`, `certified_circles`, `certified_rings` and `certified_padded` validate shapes;
    `flatten` makes the Flat of a batch.
    """

    block: int  # columns at a time
    polygons: Kernel
    boxes: Kernel
    circles: Kernel
    circle_polygons: Kernel
    indexed: Kernel
    grid: GridKernel
    candidate_pairs: Callable[..., Any]
    colliding_pairs: Callable[..., Any]
    certified_group: Callable[..., Any]
    certified_circles: Callable[..., Any]
    certified_rings: Callable[..., Any] | None = None
    certified_padded: Callable[..., Any] | None = None
    flatten: Callable[..., Any] | None = None
    exact_columns: Kernel | None = None
    max_corners: int = sys.maxsize  # corners up to which polygons are evaluated side by side, in columns


def engine_of(name: Any) -> Engine:
    """Return the engine of that name, or the best one that works for None; TypeError or ValueError for a wrong name."""
    if name is not None:
        validation.check_word("engine", name, ("numpy", "numba"))
    return load_engine(name)


def engine_for_checks(corners: int) -> Engine:
    """Return the engine that checks outlines with `corners` corners in all; both engines give the same result.

    Until numba is needed for something else, or for very many corners, NumPy does it without loading numba.
    """
    return load_engine(None if NUMBA_MODULE in sys.modules or corners > MAX_NUMPY_CORNERS else "numpy")


@cache
def load_engine(name: str | None) -> Engine:
    """Import and return the engine of that name; this is the only place that imports numba.

    None stands for the best one that works: where numba is installed but does not load or cannot keep
    what it compiles, NumPy answers, and one warning says why.
    """
    if name == "numba" or (name is None and find_spec("numba")):
        try:
            from .with_numba import few as few_numba
            from .with_numba import filter as filter_numba
            from .with_numba import grid as grid_numba
            from .with_numba import indexed as indexed_numba
            from .with_numba import outlines as outlines_numba

            return Engine(
                *_column_kernels_of(filter_numba),
                indexed_numba.relations,
                grid_numba.meeting_pairs,
                few_numba.candidate_pairs,
                few_numba.colliding_pairs,
                outlines_numba.certified_group,
                outlines_numba.certified_circles,
                outlines_numba.certified_rings,
                outlines_numba.certified_padded,
                few_numba.flatten,
                indexed_numba.exact_columns,
                MAX_LANE_CORNERS,
            )
        except Exception as error:  # an ImportError of its own, or RuntimeError where no folder can be written
            if name is None:
                warnings.warn(f"numba does not work here, so NumPy does the work: {error}", stacklevel=2)
            elif find_spec("numba") is None:
                raise ImportError(extra_needed('engine "numba"', "fast")) from error
            else:
                raise ImportError(f'engine "numba" does not work here: {error}; choose engine="numpy"') from error
    from .with_numpy import few, indexed, outlines
    from .with_numpy import filter as filter_numpy
    from .with_numpy import grid as grid_numpy

    return Engine(
        *_column_kernels_of(filter_numpy),
        indexed.relations,
        grid_numpy.meeting_pairs,
        few.candidate_pairs,
        few.colliding_pairs,
        outlines.certified_group,
        outlines.certified_circles,
        certified_padded=outlines.certified_padded,
    )


def _column_kernels_of(module: Any) -> tuple[int, Kernel, Kernel, Kernel, Kernel]:
    """Return (block, polygons, boxes, circles, circle_polygons) of a `filter` module: the first fields of an Engine."""
    return module.BLOCK_PAIRS, module.polygons, module.boxes, module.circles, module.circle_polygons
