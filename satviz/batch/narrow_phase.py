"""relate and hits for many pairs: the float filter in blocks, then exact signs for the pairs it left undecided."""

from collections.abc import Callable
from concurrent.futures import Executor, ThreadPoolExecutor
from typing import TypedDict, Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..engine.polygon_validation import refuse_masked
from .array_types import Indices
from .arrays import CornerColumns, Shapes, check_shapes
from .chunks import CHUNK_PAIRS, Call, check_executor, check_progress, check_size, in_chunks
from .codes import APART, UNDECIDED
from .engines import Engine, engine_of
from .exact_signs import pairs_per_block
from .with_numpy import exact

Relations = NDArray[np.int8]


class RelateOptions(TypedDict, total=False):
    """Declare the keyword arguments of `relate` to type checkers, since `hits` passes them on."""

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
    chunk: int = CHUNK_PAIRS,
) -> Relations:
    """Return the exact relation of each pair as int8: 0 apart, 1 touching, 2 overlapping (satviz.Relation's values).

    Pairs are a[i] with b[i], one against many, or the rows (i, j) of `pairs`.
    `engine`: "numpy" or "numba" (by default the best installed; the answers are the
    same).  `executor`: any concurrent.futures.Executor, which gets `chunk` pairs at a time;
    `progress(done, total)` is called after each chunk.  ValueError for lengths that do not
    fit, IndexError for pairs out of range, TypeError or ValueError for an invalid option,
    ChunkFailed names the range that failed.
    """
    check_shapes(a, "a"), check_shapes(b, "b")
    chunk = check_options(engine, executor, progress, chunk)
    chosen = None if pairs is None else check_pairs(pairs, len(a), len(b))
    if chosen is None and len(a) != len(b) and 1 not in (len(a), len(b)):
        raise ValueError(
            f"a has {len(a)} shapes and b has {len(b)}: pass batches of the same length, or one shape against many"
        )
    n = len(chosen[0]) if chosen is not None else 0 if 0 in (len(a), len(b)) else max(len(a), len(b))

    # threads share the shapes; to other processes each chunk takes only what it needs
    shared = executor is None or isinstance(executor, ThreadPoolExecutor)

    def job(start: int, stop: int) -> Call:
        """Return the function and the arguments that relate one chunk."""
        if chosen is not None:
            i, j = (indices[start:stop] for indices in chosen)
            return _relate_some, (a, i, b, j, engine) if shared else (*_take_used(a, i), *_take_used(b, j), engine)
        if shared:
            return _relate_range, (a, b, start, stop, engine)
        mine, theirs = (s if len(s) == 1 else s[start:stop] for s in (a, b))
        return _relate_range, (mine, theirs, 0, stop - start, engine)

    parts = [found for _, _, found in in_chunks(job, n, executor, progress, chunk)]
    return parts[0] if len(parts) == 1 else np.concatenate([np.empty(0, np.int8), *parts])


def hits(a: Shapes, b: Shapes, pairs: ArrayLike | None = None, **options: Unpack[RelateOptions]) -> NDArray[np.bool_]:
    """Return a mask of the pairs that share a point (touching counts); the arguments are those of `relate`."""
    hit: NDArray[np.bool_] = relate(a, b, pairs, **options) != APART
    return hit


def check_options(engine: object, executor: object, progress: object, size: object, size_name: str = "chunk") -> int:
    """Check the options of `relate` before any work is done; return `size`, which errors call `size_name`, as an int.

    TypeError, ValueError and (where numba is not there) ImportError name the argument and say what it takes.
    """
    check_executor(executor)
    check_progress(progress)
    number = check_size(size_name, size)
    engine_of(engine)
    return number


def check_pairs(pairs: ArrayLike, na: int, nb: int) -> tuple[Indices, Indices]:
    """Return columns i and j of (K, 2) `pairs`; ValueError for a wrong form, IndexError if not in [0, na), [0, nb)."""
    refuse_masked(pairs, "pairs")
    pairs = np.asarray(pairs)
    if pairs.shape == (0,):  # an empty list
        pairs = pairs.reshape(0, 2)
    if pairs.ndim != 2 or pairs.shape[1] != 2 or (pairs.size and pairs.dtype.kind not in "iu"):
        raise ValueError(f"pairs has the shape {pairs.shape} and holds {pairs.dtype}: expected (K, 2) integers")
    pairs = pairs.astype(np.intp, copy=False)
    if pairs.size and (pairs.min() < 0 or pairs[:, 0].max() >= na or pairs[:, 1].max() >= nb):
        k = int(np.argmax((pairs < 0).any(axis=1) | (pairs >= (na, nb)).any(axis=1)))
        i, j = pairs[k].tolist()
        raise IndexError(f"pairs[{k}] is ({i}, {j}): expected (i, j) with 0 <= i < {na} and 0 <= j < {nb}")
    return pairs[:, 0], pairs[:, 1]


def _take_used(shapes: Shapes, indices: Indices) -> tuple[Shapes, Indices]:
    """Return (the shapes at `indices`, each once; new indices into these), to send little to another process."""
    used, where = np.unique(indices, return_inverse=True)
    return shapes[used], where


def _relate_range(a: Shapes, b: Shapes, start: int, stop: int, engine: str | None) -> Relations:
    """Return the relations of pairs start to stop: a[i] with b[i], or one shape with many if a or b has one."""
    kernels = engine_of(engine)
    side_by_side = len(a) == len(b) and max(a.max_corners, b.max_corners) <= kernels.max_corners
    one, other = (a.uniform, b.uniform) if side_by_side else (None, None)
    if one is None or other is None:
        indices = np.arange(start, stop)
        zeros = np.zeros(stop - start, np.intp)
        return _relate_some(a, indices if len(a) > 1 else zeros, b, indices if len(b) > 1 else zeros, engine)
    out = np.empty(stop - start, np.int8)
    left = [np.empty(0, np.intp)]  # block by block: for a mask of all, the system would have to find memory anew
    for first in range(0, len(out), kernels.block):
        block_pairs = out[first : first + kernels.block]
        _evaluate_block(kernels, one, other, start + first, block_pairs)
        left.append(first + np.flatnonzero(block_pairs == UNDECIDED))
    rest = np.concatenate(left)
    out[rest] = exact.relations(one, start + rest, other, start + rest)
    return out


def _relate_some(a: Shapes, ia: Indices, b: Shapes, ib: Indices, engine: str | None) -> Relations:
    """Return the relations of a[ia[k]] with b[ib[k]], grouped by numbers of corners and block by block."""
    if a.owner is not None or b.owner is not None:
        return _relate_parts(a, ia, b, ib, engine)
    kernels = engine_of(engine)
    out = np.full(len(ia), UNDECIDED, np.int8)
    kernels.indexed(a.flat, ia, b.flat, ib, out)
    todo = np.flatnonzero(out == UNDECIDED)
    key = a.count[ia[todo]] << 32 | b.count[ib[todo]]
    for kind in np.unique(key).tolist():
        mine = todo[key == kind]
        one, other = a.groups[kind >> 32], b.groups[kind & 0xFFFFFFFF]
        if one.r is not None or other.r is not None:  # where `indexed` decides polygons only
            size = min(BLOCK_PAIRS, pairs_per_block(max(len(one.x), len(other.x))))
            for start in range(0, len(mine), size):
                part = mine[start : start + size]
                found = np.empty(len(part), np.int8)
                _evaluate_block(kernels, one.columns(a.slot[ia[part]]), other.columns(b.slot[ib[part]]), 0, found)
                out[part] = found
        rest = mine[out[mine] == UNDECIDED]
        out[rest] = exact.relations(one, a.slot[ia[rest]], other, b.slot[ib[rest]])
    return out


BLOCK_PAIRS = 16384  # pairs: their columns are copied first, and where corners are few the copies stay in the cache


def _relate_parts(a: Shapes, ia: Indices, b: Shapes, ib: Indices, engine: str | None) -> Relations:
    """Return the relations of a[ia[k]] with b[ib[k]], made of parts: the largest relation code of any two parts."""
    out = np.zeros(len(ia), np.int8)
    first_a, first_b = a.starts[ia], b.starts[ib]
    many_b = b.starts[ib + 1] - first_b
    each = (a.starts[ia + 1] - first_a) * many_b
    end = np.cumsum(each)
    for start in range(0, end[-1], BLOCK_PART_PAIRS):
        place = np.arange(start, min(start + BLOCK_PART_PAIRS, end[-1]))
        of = np.searchsorted(end, place, side="right")
        rank = place - (end - each)[of]
        pa, pb = first_a[of] + rank // many_b[of], first_b[of] + rank % many_b[of]
        np.maximum.at(out, of, _relate_some(a.parts, pa, b.parts, pb, engine))
    return out


BLOCK_PART_PAIRS = 1 << 18  # pairs of parts at a time: what bounds the memory


def _evaluate_block(kernels: Engine, a: CornerColumns, b: CornerColumns, first: int, out: Relations) -> None:
    """Fill out[k] with the relation of column first + k of `a` and of `b`, or UNDECIDED if floats are not certain."""
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
            if kernels.exact_columns is not None and out.min(initial=APART) == UNDECIDED:  # rare, and cheap to check
                kernels.exact_columns(a, b, first, out)
