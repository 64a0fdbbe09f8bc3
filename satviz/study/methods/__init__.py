"""The methods under study: every form of the engine, and rival methods on the same shapes.

The rivals keep no record and evaluate nothing twice, and each is the fastest form of its method that we could write.
Even so a time belongs to a program and not to its method alone (`VECTORISED`).

A method prepares the shapes of each side once (its set-up) and then answers all pairs.
"""

from collections.abc import Callable, Iterable, Iterator
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ... import batch
from ...engine.relate import relate
from ...engine.shapes import Circle, Polygon, Shape
from .. import truth
from ..harness.machine import is_installed
from ..workloads.generators import Side, unpadded_rings
from . import libraries, numpy_rivals, python_rivals
from .libraries import one_by_one, pymunk_hit, shapely_hit

COMPILED, NUMPY, PYTHON = "compiled", "NumPy", "Python"
TOLERANCE = 1e-9  # scene units
TILE_PAIRS = 2000  # no power of two, which would put all corners into the same few places of the cache
# found in numba's machine code on x86: a loop that can end early is not vectorised
VECTORISED = (
    "SAT, satviz and the bounding shapes compute several pairs at a time; GJK and shapely go pair by pair. "
    "So the times compare these programs and not only the methods."
)
ENGINES = {"satviz numpy": "numpy", "satviz numba": "numba"}  # name in the tables: engine
Answers = NDArray[Any]  # one for each pair: bool for hit or not, or int8 for the relation


class Method(NamedTuple):
    """One way to answer pairs: `hits(prepare(side_a), prepare(side_b))` returns the answers.

    `language`: the language of its loop over pairs.  `family`: the group that decides its colour in charts; "exact" is
    exact by construction for all float64.  `circles`: whether it takes circles too.  `at_once`: a quicker way from the
    arrays of both sides to the answers, for shapes that are tested only once, where there is one.
    """

    name: str
    language: str
    family: str
    prepare: Callable[[Side], Any]
    hits: Callable[[Any, Any], Any]
    circles: bool = False
    at_once: Callable[[Side, Side], Answers] | None = None

    def from_arrays(self, a: Side, b: Side) -> Any:
        """Return the answers to all pairs of the raw arrays `a` and `b`, each shape made anew and tested once."""
        return self.at_once(a, b) if self.at_once else self.hits(self.prepare(a), self.prepare(b))


def installed_engines() -> Iterator[tuple[str, str]]:
    """Yield (name in the table, engine) of the engines that work here."""
    for label, engine in ENGINES.items():
        if engine == "numpy" or is_installed(engine):
            yield label, engine


def all_methods(*, circles: bool = False) -> list[Method]:
    """Return the methods that run with what is installed; with `circles` only those that take circles."""
    found = [*_numba_methods(), *_numpy_methods(), *_python_methods(), *_library_methods()]
    return [method for method in found if method.circles or not circles]


def true_relations(a: Side, b: Side) -> NDArray[np.int8]:
    """Return the exact relation of each pair, on which both oracles of `truth` must agree."""
    return np.array([truth.agreed(p, q) for p, q in zip(engine_shapes(a), engine_shapes(b), strict=True)], np.int8)


def answers_by_method(methods: Iterable[Method], a: Side, b: Side) -> Iterator[tuple[Method, Answers]]:
    """Yield (method, its answers to all pairs of a[k] and b[k]) for each method."""
    for method in methods:
        with np.errstate(all="ignore"):
            yield method, np.asarray(method.hits(method.prepare(a), method.prepare(b)))


def wrong_answers(answers: Answers, right: NDArray[np.int8]) -> NDArray[np.bool_]:
    """Return the mask of the wrong answers; only answers that are relations must tell touching from overlapping."""
    return np.asarray(answers != (right > 0) if answers.dtype == bool else answers != right)


def count_mistakes(answers: Answers, right: NDArray[np.int8]) -> dict[str, int]:
    """Return by name the numbers of false hits, of missed hits, and of touches confused with overlaps."""
    hit, is_hit = answers > 0, right > 0
    confused = int((wrong_answers(answers, right) & hit & is_hit).sum())
    return {"false_hits": int((hit & ~is_hit).sum()), "missed_hits": int((~hit & is_hit).sum()), "confused": confused}


def engine_shapes(side: Side) -> list[Shape]:
    """Return the shapes of a workload's side as a list of the engine's Polygon or Circle objects."""
    if isinstance(side, tuple):
        return [Circle(c, r) for c, r in zip(side[0].tolist(), side[1].tolist())]
    return [Polygon(ring) for ring in unpadded_rings(side)]


def batch_shapes(side: Side) -> batch.Shapes:
    """Return the shapes of a workload's side as batch.Polygons or batch.Circles."""
    return batch.Circles(*side) if isinstance(side, tuple) else batch.Polygons(side)


def _numba_methods() -> Iterator[Method]:
    """Yield the methods compiled with numba, if it is installed."""
    if not is_installed("numba"):
        return
    from . import numba_rivals

    def on_columns(name: str, family: str, kernel_for: Callable[[int, int], Any], dtype: type = np.float64) -> Method:
        """Return the Method of a kernel(ax, ay, bx, by, out) on columns, which kernel_for(va, vb) returns."""

        def hits(a: numpy_rivals.Columns, b: numpy_rivals.Columns) -> Answers:
            """Return for each pair whether the kernel finds a hit."""
            out = np.empty(a.x.shape[1], np.int8)
            kernel_for(len(a.x), len(b.x))(a.x, a.y, b.x, b.y, out)
            return out.view(np.bool_)

        at_once = partial(_in_tiles, kernel_for=kernel_for, dtype=dtype)
        return Method(name, COMPILED, family, partial(numpy_rivals.to_columns, dtype=dtype), hits, at_once=at_once)

    def sat(name: str, family: str, form: int, tolerance: float = 0.0, dtype: Any = np.float64) -> Method:
        """Return SAT as a Method; form, tolerance: as in `sat_kernel`; dtype: the float format of the columns."""
        limit = dtype(tolerance)

        def kernel_for(va: int, vb: int) -> Callable[..., None]:
            """Return the kernel for these numbers of corners, without the tolerance among its arguments."""
            kernel = numba_rivals.sat_kernel(numba_rivals.unrolled(va), numba_rivals.unrolled(vb), form)
            return lambda ax, ay, bx, by, out: kernel(ax, ay, bx, by, limit, out)

        return on_columns(name, family, kernel_for, dtype)

    def on_bounds(name: str, bound: Callable[[int | None], Callable[..., Any]], kernel: Callable[..., None]) -> Method:
        """Return the Method of a kernel(a, b, out) on bounding volumes; bound(corners)(x, y) makes these."""

        def prepare(side: Side) -> Any:
            """Return the bounding volumes of a workload's side."""
            columns = numpy_rivals.to_columns(side)
            return bound(numba_rivals.unrolled(len(columns.x)))(columns.x, columns.y)

        def hits(a: Any, b: Any) -> Answers:
            """Return for each pair whether the bounding volumes hit."""
            out = np.empty(a.shape[1], np.int8)
            kernel(a, b, out)
            return out.view(np.bool_)

        def kernel_for(va: int, vb: int) -> Callable[..., None]:
            """Return the kernel on columns of these numbers of corners."""
            bound_a, bound_b = (bound(numba_rivals.unrolled(corners)) for corners in (va, vb))
            return lambda ax, ay, bx, by, out: kernel(bound_a(ax, ay), bound_b(bx, by), out)

        return Method(name, COMPILED, "bounds", prepare, hits, at_once=partial(_in_tiles, kernel_for=kernel_for))

    def gjk(va: int, vb: int) -> Callable[..., None]:
        """Return the kernel of GJK for these numbers of corners."""
        return numba_rivals.gjk_kernel(numba_rivals.unrolled(va), numba_rivals.unrolled(vb))

    relation = partial(batch.relate, engine="numba")
    yield Method("satviz", COMPILED, "exact", batch_shapes, relation, circles=True)
    yield sat("SAT, raw normals", "float SAT", numba_rivals.PLAIN)
    yield sat("SAT, unit normals", "float SAT", numba_rivals.UNIT)
    yield sat("SAT, float32", "float SAT", numba_rivals.PLAIN, dtype=np.float32)
    yield sat("SAT, tolerance 1e-9", "tolerance", numba_rivals.WITH_TOLERANCE, TOLERANCE)
    pair_by_pair, views = on_columns("GJK", "GJK", gjk), numpy_rivals.as_columns  # it reads the arrays as they lie
    yield pair_by_pair._replace(at_once=lambda a, b: pair_by_pair.hits(views(a), views(b)))
    yield on_bounds("bounding circles", numba_rivals.bounding_circles, numba_rivals.circles_hit)
    yield on_bounds("AABB", numba_rivals.bounding_boxes, numba_rivals.boxes_hit)
    yield on_bounds("oriented boxes", numba_rivals.oriented_boxes, numba_rivals.oriented_boxes_hit)


def _in_tiles(a: Any, b: Any, kernel_for: Callable[[int, int], Any], dtype: type = np.float64) -> Answers:
    """Return the answers of a kernel on columns for raw (N, V, 2) arrays, copied into columns TILE_PAIRS at a time.

    So the columns stay in the cache, and the kernel computes several pairs at once.  `kernel_for(va, vb)` returns the
    kernel for these numbers of corners; `dtype`: the float format of the columns.
    """
    from . import numba_rivals

    va, vb, out = a.shape[1], b.shape[1], np.empty(len(a), np.int8)
    copy_a, copy_b = (numba_rivals.corners_kernel(numba_rivals.unrolled(corners)) for corners in (va, vb))
    (ax, ay), (bx, by) = (np.empty((2, v, TILE_PAIRS), dtype) for v in (va, vb))
    for first in range(0, len(a), TILE_PAIRS):
        copy_a(a, first, ax, ay)
        copy_b(b, first, bx, by)
        kernel_for(va, vb)(ax, ay, bx, by, out[first : first + TILE_PAIRS])
    return out.view(np.bool_)


def _numpy_methods() -> Iterator[Method]:
    """Yield the methods whose loops run in NumPy."""

    yield Method("satviz", NUMPY, "exact", batch_shapes, partial(batch.relate, engine="numpy"), circles=True)
    columns, hits = numpy_rivals.to_columns, numpy_rivals.sat_hits
    yield Method("SAT, unit normals", NUMPY, "float SAT", columns, hits, circles=True)


def _python_methods() -> Iterator[Method]:
    """Yield the methods in plain Python, which answer one pair at a time."""

    def points(side: Side) -> list[python_rivals.PointsAndRadius]:
        """Return each shape of a workload's side as points and a radius."""
        return [python_rivals.points_and_radius(shape) for shape in engine_shapes(side)]

    yield Method("satviz", PYTHON, "exact", engine_shapes, one_by_one(relate), circles=True)
    yield Method("GJK", PYTHON, "GJK", points, one_by_one(python_rivals.gjk), circles=True)


def _library_methods() -> Iterator[Method]:
    """Yield shapely (all pairs at once, prepared, and pair by pair) and pymunk, where they are installed."""
    if is_installed("shapely"):
        yield Method("shapely", COMPILED, "library", libraries.shapely_geometries, libraries.shapely_hits, circles=True)
        yield Method("shapely, prepared", COMPILED, "library", libraries.prepared_geometries, libraries.shapely_hits)
        yield Method("shapely", PYTHON, "library", libraries.geometry_list, one_by_one(shapely_hit), circles=True)
    if is_installed("pymunk"):
        yield Method("pymunk", PYTHON, "library", libraries.pymunk_shapes, one_by_one(pymunk_hit), circles=True)
