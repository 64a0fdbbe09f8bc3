"""Find the colliding pairs of many shapes: broad phase, then exact narrow phase; for a set, or a file in strips."""

from collections.abc import Callable, Iterator
from concurrent.futures import Executor
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..engine.geometry import InvalidShape
from . import validation
from .array_types import Pairs
from .arrays import Shapes, check_shapes
from .broad_phase import candidate_blocks, sort_pairs
from .chunks import CHUNK_PAIRS
from .constructors import number_polygons
from .engines import engine_of
from .narrow_phase import check_options, hits

STRIP_SHAPES = 1 << 19  # number of shapes that one strip of a streamed file should hold


def colliding_pairs(
    shapes: Shapes,
    *,
    engine: str | None = None,
    executor: Executor | None = None,
    progress: Callable[[int, int], None] | None = None,
    chunk: int = CHUNK_PAIRS,
) -> Pairs:
    """Return the (K, 2) indices i < j, in order, of the shapes that share a point (touching counts).

    Parts of one concave polygon count as their owner.  `engine`, `executor`,
    `progress` (called with the candidates done after each block) and `chunk`: as in `relate`;
    for upright boxes alone the broad phase decides.
    """
    kernels = engine_of(engine)
    check_shapes(shapes, "shapes")
    if chunk is not CHUNK_PAIRS or executor is not None or progress is not None:
        chunk = check_options(engine, executor, progress, chunk)  # also where the grid alone decides
    elif shapes.owner is None:
        few: Pairs | None = kernels.colliding_pairs(shapes)
        if few is not None:
            return few
    found, parts = [], shapes.parts
    if kernels.flatten is not None and "flat" not in vars(parts):
        parts.flat = kernels.flatten(parts)
    for pairs in candidate_blocks(parts.flat.bounds, kernels):
        if shapes.owner is not None:
            owners = shapes.owner[pairs]
            pairs = pairs[owners[:, 0] != owners[:, 1]]
        if not parts.are_upright_boxes:  # upright boxes meet exactly where their bounding boxes meet
            pairs = pairs[hits(parts, parts, pairs, engine=engine, executor=executor, progress=progress, chunk=chunk)]
        found.append(pairs)
    pairs = sort_pairs(found)
    if shapes.owner is not None:
        pairs = np.unique(np.sort(shapes.owner[pairs], axis=1), axis=0)
    return pairs


def stream_colliding_pairs(
    vertices: NDArray[Any],
    *,
    engine: str | None = None,
    executor: Executor | None = None,
    progress: Callable[[int, int], None] | None = None,
    strip: int = STRIP_SHAPES,
) -> Iterator[Pairs]:
    """Yield the colliding pairs, (K, 2) indices i < j, of an (N, V, 2) array too large for memory, strip by strip.

    The scene is cut into upright strips of about `strip` shapes each; every strip
    reads and holds only the shapes that reach into it.  A pair is
    given once, by the strip where the later of the two begins.  Memory: a few
    hundred bytes a shape of one strip (shapes that all begin at one x are in one), and some
    25 bytes a shape of the file for the x ranges.  Options are checked at the call, shapes when a
    strip is requested: InvalidShape as in Polygons, before the first strip for a value that is not a number,
    else of the first strip that holds one at fault.
    """
    if getattr(vertices, "ndim", 0) != 3:
        raise InvalidShape(
            f"vertices is {_describe_type(vertices)}: expected an (N, V, 2) array; call colliding_pairs for other forms"
        )
    strip = check_options(engine, executor, progress, strip, "strip")
    return _stream_strips(vertices, engine, executor, progress, strip)


def _stream_strips(
    vertices: NDArray[Any],
    engine: str | None,
    executor: Executor | None,
    progress: Callable[[int, int], None] | None,
    strip: int,
) -> Iterator[Pairs]:
    """Yield what `stream_colliding_pairs` does; the arguments are already checked."""
    n = len(vertices)
    low, high = np.empty(n), np.empty(n)
    for start in range(0, max(n, 1), strip):
        x = validation.rings_from_array(vertices[start : start + strip], _names_from(start))[:, :, 0]
        low[start : start + strip], high[start : start + strip] = x.min(axis=1), x.max(axis=1)
    if not n:
        return
    count = -(-n // strip)
    edges = np.concatenate([[-np.inf], np.quantile(low, np.arange(1, count) / count, method="lower"), [np.inf]])
    edges = np.unique(edges)
    for k, (left, right) in enumerate(pairwise(edges)):
        ids = np.flatnonzero((low < right) & (high >= left))
        if ids.size:
            shapes = number_polygons(np.asanyarray(vertices[ids]), ids, "refuse")
            pairs = ids[colliding_pairs(shapes, engine=engine, executor=executor)]
            begins = low[pairs].max(axis=1)
            yield pairs[(begins >= left) & (begins < right)]
        if progress is not None:
            progress(k + 1, len(edges) - 1)


def _names_from(start: int) -> Callable[[int], str]:
    """Return a function from i to the text "polygon <start + i>", for error messages."""
    return lambda i: f"polygon {start + i}"


def _describe_type(values: Any) -> str:
    """Return the type and shape of what was passed, for an error line."""
    shape = getattr(values, "shape", None)
    return f"a {type(values).__name__}" if shape is None else f"an array of the shape {shape}"
