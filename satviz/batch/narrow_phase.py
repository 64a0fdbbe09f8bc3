"""relate and hits for many pairs: the filter in blocks, then the exact twin for all that it left undecided."""

import sys
import warnings
from collections.abc import Callable
from concurrent.futures import Executor, ThreadPoolExecutor
from functools import cache
from importlib.util import find_spec
from typing import Any, NamedTuple, TypedDict, Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..engine.polygon_validation import refuse_masked
from ..optional_imports import extra_needed
from . import validation
from .arrays import Group, Shapes, checked
from .chunks import CHUNK, Call, at_least_one, check_executor, check_progress, in_chunks
from .codes import APART, UNDECIDED
from .exact_signs import lanes
from .ragged import FEW
from .with_numpy import exact
from .with_numpy.grid import Grid

Relations = NDArray[np.int8]
Kernel = Callable[..., None]
Indices = NDArray[np.intp]


class Engine(NamedTuple):
    """What does the work on float64: kernels that fill `out` with relations, and leave UNDECIDED what they cannot tell.

    The first four take columns of two groups, from one column on, and `settle` goes on with what of them is
    undecided; `picked` takes pairs of polygons from anywhere in two batches, `grid` finds the boxes that meet.
    """

    block: int  # columns at a time
    polygons: Kernel
    boxes: Kernel
    circles: Kernel
    circle_polygons: Kernel
    picked: Kernel
    grid: Grid
    settle: Kernel | None = None
    most: int = sys.maxsize  # corners of polygons that are looked at side by side, in columns


class Options(TypedDict, total=False):
    """How the work is done, as `relate` says."""

    engine: str | None
    executor: Executor | None
    progress: Callable[[int, int], None] | None
    chunk: int


def relate(
    a: Shapes,
    b: Shapes,
    pairs: ArrayLike | None = None,
    *,
    engine: str | None = None,
    executor: Executor | None = None,
    progress: Callable[[int, int], None] | None = None,
    chunk: int = CHUNK,
) -> Relations:
    """The exact relation of each pair as int8: 0 apart, 1 touching, 2 overlapping (satviz.Relation's values).

    Pairs are a[i] with b[i], one against many, or the rows (i, j) of `pairs`.
    `engine`: "numpy" or "numba" (by default the best installed; the answers are the
    same).  `executor`: any concurrent.futures.Executor; chunks of pairs come back in
    order, `progress(done, total)` is told of each.  ValueError for lengths that do not
    fit, IndexError for pairs out of range, TypeError or ValueError for an option that is none,
    ChunkFailed names the range that failed.
    """
    checked(a, "a"), checked(b, "b")
    chunk = check_options(engine, executor, progress, chunk)
    chosen = None if pairs is None else checked_pairs(pairs, len(a), len(b))
    if chosen is None and len(a) != len(b) and 1 not in (len(a), len(b)):
        raise ValueError(f"{len(a)} shapes against {len(b)}: pass as many of both, or one against many")
    n = len(chosen[0]) if chosen is not None else 0 if 0 in (len(a), len(b)) else max(len(a), len(b))

    # threads share the shapes; to other processes each chunk takes only what it needs
    shared = executor is None or isinstance(executor, ThreadPoolExecutor)

    def job(start: int, stop: int) -> Call:
        if chosen is not None:
            i, j = (indices[start:stop] for indices in chosen)
            return _relate_some, (a, i, b, j, engine) if shared else (*_picked(a, i), *_picked(b, j), engine)
        if shared:
            return _relate_range, (a, b, start, stop, engine)
        mine, theirs = (s if len(s) == 1 else s[start:stop] for s in (a, b))
        return _relate_range, (mine, theirs, 0, stop - start, engine)

    parts = [found for _, _, found in in_chunks(job, n, executor, progress, chunk)]
    return parts[0] if len(parts) == 1 else np.concatenate([np.empty(0, np.int8), *parts])


def hits(a: Shapes, b: Shapes, pairs: ArrayLike | None = None, **options: Unpack[Options]) -> NDArray[np.bool_]:
    """Which pairs share a point (touching counts); the arguments of `relate`."""
    hit: NDArray[np.bool_] = relate(a, b, pairs, **options) != APART
    return hit


def check_options(engine: object, executor: object, progress: object, size: object, of: str = "chunk") -> int:
    """Check how work is to be done, before any is; return the size of its pieces, whose argument is called `of`.

    TypeError, ValueError and (where numba is not there) ImportError name the argument and say what it takes.
    """
    check_executor(executor)
    check_progress(progress)
    number = at_least_one(of, size)
    engine_of(engine)
    return number


def engine_of(name: Any) -> Engine:
    """The engine of that name, None for the best that works; TypeError and ValueError for what is no name."""
    if name is not None:
        validation.check_word("engine", name, ("numpy", "numba"))
    return loaded(name)


@cache
def loaded(name: str | None) -> Engine:
    """The engine of that name; numba is imported here and nowhere else.

    By default the best that works: where numba is installed but does not load or cannot keep
    what it compiles, NumPy answers, and one warning says why.
    """
    if name == "numba" or (name is None and find_spec("numba")):
        try:
            from .with_numba import filter as filter_numba
            from .with_numba import grid as grid_numba
            from .with_numba import indexed as indexed_numba

            own = indexed_numba.polygons, grid_numba.met, indexed_numba.columns, FEW
            return Engine(*_columns_of(filter_numba), *own)
        except Exception as error:  # an ImportError of its own, or RuntimeError where no folder can be written
            if name is None:
                warnings.warn(f"numba does not work here, so NumPy does the work: {error}", stacklevel=2)
            elif find_spec("numba") is None:
                raise ImportError(extra_needed('engine "numba"', "fast")) from error
            else:
                raise ImportError(f'engine "numba" does not work here: {error}; engine="numpy" does') from error
    from .with_numpy import filter as filter_numpy
    from .with_numpy import grid as grid_numpy
    from .with_numpy import indexed

    return Engine(*_columns_of(filter_numpy), indexed.polygons, grid_numpy.met)


def _columns_of(module: Any) -> tuple[int, Kernel, Kernel, Kernel, Kernel]:
    return module.BLOCK, module.polygons, module.boxes, module.circles, module.circle_polygons


def checked_pairs(pairs: ArrayLike, na: int, nb: int) -> tuple[Indices, Indices]:
    """The two columns of (K, 2) indices into na and nb shapes; ValueError and IndexError say what is wrong."""
    refuse_masked(pairs, "pairs")
    pairs = np.asarray(pairs)
    if pairs.shape == (0,):  # an empty list
        pairs = pairs.reshape(0, 2)
    if pairs.ndim != 2 or pairs.shape[1] != 2 or (pairs.size and pairs.dtype.kind not in "iu"):
        raise ValueError(f"pairs has the shape {pairs.shape} of {pairs.dtype}: expected (K, 2) integers")
    pairs = pairs.astype(np.intp, copy=False)
    if pairs.size and (pairs.min() < 0 or pairs[:, 0].max() >= na or pairs[:, 1].max() >= nb):
        raise IndexError(f"pairs name shapes outside 0 to {na - 1} and 0 to {nb - 1}")
    return pairs[:, 0], pairs[:, 1]


def _picked(shapes: Shapes, indices: Indices) -> tuple[Shapes, Indices]:
    """Only the shapes that a chunk needs, to send elsewhere, and the indices into them."""
    used, where = np.unique(indices, return_inverse=True)
    return shapes[used], where


def _relate_range(a: Shapes, b: Shapes, start: int, stop: int, engine: str | None) -> Relations:
    """Pairs start to stop of a[i] with b[i], or of one with many."""
    kernels = engine_of(engine)
    side_by_side = len(a) == len(b) and max(a.most, b.most) <= kernels.most
    one, other = (a.uniform, b.uniform) if side_by_side else (None, None)
    if one is None or other is None:
        indices = np.arange(start, stop)
        zeros = np.zeros(stop - start, np.intp)
        return _relate_some(a, indices if len(a) > 1 else zeros, b, indices if len(b) > 1 else zeros, engine)
    out = np.empty(stop - start, np.int8)
    left = [np.empty(0, np.intp)]  # block by block: for a mask of all, the system would have to find memory anew
    for first in range(0, len(out), kernels.block):
        block = out[first : first + kernels.block]
        _filter(kernels, one, other, start + first, block)
        left.append(first + np.flatnonzero(block == UNDECIDED))
    rest = np.concatenate(left)
    out[rest] = exact.relations(one, start + rest, other, start + rest)
    return out


def _relate_some(a: Shapes, ia: Indices, b: Shapes, ib: Indices, engine: str | None) -> Relations:
    """The pairs (ia, ib), group by group, block by block; their columns are copied together first."""
    if a.owner is not None or b.owner is not None:
        return _relate_parts(a, ia, b, ib, engine)
    kernels = engine_of(engine)
    out = np.full(len(ia), UNDECIDED, np.int8)
    if min(a.least, b.least) > 1:
        kernels.picked(a.flat, np.ascontiguousarray(ia), b.flat, np.ascontiguousarray(ib), out)
    elif (polygons := np.flatnonzero((a.count[ia] > 1) & (b.count[ib] > 1))).size:
        found = np.empty(len(polygons), np.int8)
        kernels.picked(a.flat, ia[polygons], b.flat, ib[polygons], found)
        out[polygons] = found
    todo = np.flatnonzero(out == UNDECIDED)
    key = a.count[ia[todo]] << 32 | b.count[ib[todo]]
    for kind in np.unique(key).tolist():
        mine = todo[key == kind]
        one, other = a.groups[kind >> 32], b.groups[kind & 0xFFFFFFFF]
        if one.r is not None or other.r is not None:  # polygons were looked at
            size = min(BLOCK_OF_PICKED, lanes(max(len(one.x), len(other.x))))
            for start in range(0, len(mine), size):
                part = mine[start : start + size]
                found = np.empty(len(part), np.int8)
                _filter(kernels, one.columns(a.slot[ia[part]]), other.columns(b.slot[ib[part]]), 0, found)
                out[part] = found
        rest = mine[out[mine] == UNDECIDED]
        out[rest] = exact.relations(one, a.slot[ia[rest]], other, b.slot[ib[rest]])
    return out


BLOCK_OF_PICKED = 16384  # pairs: their columns are copied first, and where corners are few the copies stay in the cache


def _relate_parts(a: Shapes, ia: Indices, b: Shapes, ib: Indices, engine: str | None) -> Relations:
    """Pairs of shapes, some in parts: the most of what their parts do; in blocks, as parts multiply."""
    out = np.zeros(len(ia), np.int8)
    first_a, first_b = a.starts[ia], b.starts[ib]
    many_b = b.starts[ib + 1] - first_b
    each = (a.starts[ia + 1] - first_a) * many_b
    end = np.cumsum(each)
    for start in range(0, end[-1], BLOCK_OF_PARTS):
        place = np.arange(start, min(start + BLOCK_OF_PARTS, end[-1]))
        of = np.searchsorted(end, place, side="right")
        rank = place - (end - each)[of]
        pa, pb = first_a[of] + rank // many_b[of], first_b[of] + rank % many_b[of]
        np.maximum.at(out, of, _relate_some(a.parts, pa, b.parts, pb, engine))
    return out


BLOCK_OF_PARTS = 1 << 18  # pairs of parts at a time: what bounds the memory


def _filter(kernels: Engine, a: Group, b: Group, first: int, out: Relations) -> None:
    """Relations of one block of one kind of pair, from column `first` on; UNDECIDED where floats cannot tell."""
    with np.errstate(all="ignore"):
        if a.upright and b.upright:
            kernels.boxes(a, b, first, out)
        elif a.r is not None and b.r is not None:
            kernels.circles(a.x[0], a.y[0], a.r, b.x[0], b.y[0], b.r, first, out)
        elif a.r is not None or b.r is not None:
            circle, polygon = (a, b) if a.r is not None else (b, a)
            kernels.circle_polygons(circle.x[0], circle.y[0], circle.r, polygon.x, polygon.y, first, out)
        else:
            kernels.polygons(a, b, first, out)
            if kernels.settle is not None and out.min(initial=APART) == UNDECIDED:  # rarely, and to look costs little
                kernels.settle(a, b, first, out)
