"""The methods under study: the engine in each of its forms, and rivals on the same shapes.

The rivals are plain: they keep no record and evaluate nothing twice.  Each is here in the language of those
it is compared with.  A time is that of a program all the same, and not of the method alone (`VECTORISED`).

A method prepares each side once (its set-up) and then answers all pairs.
"""

from collections.abc import Callable, Iterable, Iterator
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ... import batch
from ...engine.relate import relate
from ...engine.shapes import Circle, Polygon, Shape
from ...engine.trace import record
from .. import truth
from ..harness.machine import is_installed
from ..workloads.generators import Side, is_padded, unpadded_rings
from . import libraries, numpy_rivals, python_rivals

COMPILED, NUMPY, PYTHON = "compiled", "NumPy", "Python"
TOLERANCE = 1e-9  # scene units
# read off numba's machine code on x86: a loop that can end early stays scalar
VECTORISED = (
    "The kernels of satviz (also without its filter), of the bounding circles and of the boxes are vectorised, the "
    "other kernels go pair by pair: the times compare these programs and not the methods alone."
)
Answers = NDArray[Any]


class Method(NamedTuple):
    """One way to answer pairs.

    `language`: what its loop over pairs runs in; `prepare(side)` makes what `hits(a, b)` takes: one bool a pair, or
    one relation.  `family` decides its colour; "exact" is exact by construction for all float64, "exact in range" only
    while the products of coordinates stay in float64's range.  `circles`: does it take circles too?  `one` prepares a
    single shape, where `prepare` starts from satviz's own.
    """

    name: str
    language: str
    family: str
    prepare: Callable[[Side], Any]
    hits: Callable[[Any, Any], Any]
    circles: bool = False
    one: Callable[[Shape], Any] | None = None

    def ready(self, side: Side, known: list[Shape]) -> Any:
        """What `prepare` gives, where satviz's own shapes of that side are known already."""
        return [self.one(shape) for shape in known] if self.one else self.prepare(side)


def all_methods(*, circles: bool = False) -> list[Method]:
    """Those that answer this kind of pair, with what is installed."""
    found = [*_numba_methods(), *_numpy_methods(), *_python_methods(), *_library_methods()]
    return [method for method in found if method.circles or not circles]


def true_relations(a: Side, b: Side) -> NDArray[np.int8]:
    """The relation of each pair, by rationals."""
    return np.array([truth.relation(p, q) for p, q in zip(engine_shapes(a), engine_shapes(b), strict=True)], np.int8)


def answers_by_method(found: Iterable[Method], a: Side, b: Side) -> Iterator[tuple[Method, Answers]]:
    """Each method with its answers to all pairs."""
    known = engine_shapes(a), engine_shapes(b)
    for method in found:
        with np.errstate(all="ignore"):
            yield method, np.asarray(method.hits(method.ready(a, known[0]), method.ready(b, known[1])))


def wrong_answers(said: Answers, right: NDArray[np.int8]) -> NDArray[np.bool_]:
    """Which answers are wrong; who tells touching from overlapping is held to that too."""
    return np.asarray(said != (right > 0) if said.dtype == bool else said != right)


def count_mistakes(said: Answers, right: NDArray[np.int8]) -> dict[str, int]:
    """False hits and false misses; of a method that tells touching from overlapping also the hits it confused."""
    hit, is_hit = said > 0, right > 0
    confused = int((wrong_answers(said, right) & hit & is_hit).sum())
    return {"false_hits": int((hit & ~is_hit).sum()), "false_misses": int((~hit & is_hit).sum()), "confused": confused}


def engine_shapes(side: Side) -> list[Shape]:
    """A workload's side as satviz's own shapes."""
    if isinstance(side, tuple):
        return [Circle(c, r) for c, r in zip(side[0].tolist(), side[1].tolist())]
    return [Polygon(ring) for ring in unpadded_rings(side)]


def batch_shapes(side: Side) -> batch.Shapes:
    """A workload's side as satviz's batch shapes."""
    if isinstance(side, tuple):
        return batch.Circles(*side)
    return batch.Polygons(unpadded_rings(side) if is_padded(side) else side.copy())


def _numba_methods() -> Iterator[Method]:
    if not is_installed("numba"):
        return
    from ...batch.codes import APART
    from ...batch.with_numba.filter import looks
    from . import numba_rivals

    def filled(kernel: Callable[..., None], *more: Any) -> Callable[[Any, Any], Answers]:
        """On (x, y) columns."""

        def hits(a: numpy_rivals.Columns, b: numpy_rivals.Columns) -> Answers:
            out = np.empty(a.x.shape[1], np.int8)
            kernel(a.x, a.y, b.x, b.y, *more, out)
            return out > 0

        return hits

    def kept(make: Callable[..., Any], kernel: Callable[..., None], *more: Any) -> tuple[Any, Any]:
        """On what was worked out beforehand."""

        def prepare(side: Side) -> Any:
            c = numpy_rivals.to_columns(side)
            return make(c.x, c.y, *more)

        def hits(a: Any, b: Any) -> Answers:
            out = np.empty(a.shape[1], np.int8)
            kernel(a, b, out)
            return out > 0

        return prepare, hits

    def unfiltered(a: numpy_rivals.Columns, b: numpy_rivals.Columns) -> Answers:
        out = np.empty(a.x.shape[1], np.int8)
        looks(len(a.x), len(b.x))(a.x, a.y, b.x, b.y, 0, 0.0, out)
        return np.asarray(out != APART)  # a clearance of exactly zero it leaves open: a touch

    def bound(name: str, *of: Any) -> Method:
        return Method(name, COMPILED, "bounds", *kept(*of))

    def loop(name: str, family: str, kernel: Callable[..., None], *more: Any, dtype: type = np.float64) -> Method:
        return Method(name, COMPILED, family, partial(numpy_rivals.to_columns, dtype=dtype), filled(kernel, *more))

    relation = partial(batch.relate, engine="numba")
    yield Method("satviz", COMPILED, "exact", batch_shapes, relation, circles=True)
    yield Method("satviz, no filter", COMPILED, "float SAT", numpy_rivals.to_columns, unfiltered)
    yield loop("turns, adaptive", "exact in range", numba_rivals.orientation_sat, numba_rivals.ERRBOUND_A)
    yield loop("turns, expansions", "exact in range", numba_rivals.orientation_sat, numba_rivals.ALWAYS_EXACT)
    yield loop("turns, floats", "float SAT", numba_rivals.orientation_sat, numba_rivals.NO_ERROR_BOUND)
    yield loop("SAT, raw normals", "float SAT", numba_rivals.textbook_sat, False, 0.0)
    yield loop("SAT, unit normals", "float SAT", numba_rivals.textbook_sat, True, 0.0)
    yield loop("SAT, float32", "float SAT", numba_rivals.textbook_sat, False, 0.0, dtype=np.float32)
    yield loop("SAT, 1e-9 counts as a hit", "tolerance", numba_rivals.textbook_sat, True, TOLERANCE)
    yield loop("SAT, 1e-9 counts as a miss", "tolerance", numba_rivals.textbook_sat, True, -TOLERANCE)
    yield loop("GJK", "GJK", numba_rivals.gjk)
    yield bound("bounding circles", numba_rivals.enclosing_circles, numba_rivals.circles_hit)
    yield bound(
        "AABB", numba_rivals.ranges_on_directions, numba_rivals.boxes_hit, np.array(python_rivals.even_directions(2))
    )
    yield bound("oriented boxes", numba_rivals.oriented_boxes, numba_rivals.oriented_boxes_hit)
    yield bound(
        "16 axes",
        numba_rivals.ranges_on_directions,
        numba_rivals.ranges_hit,
        np.array(python_rivals.even_directions(16)),
    )


def _numpy_methods() -> Iterator[Method]:
    def loop(name: str, family: str, of: numpy_rivals.AxisChoice) -> Method:
        return Method(
            name, NUMPY, family, numpy_rivals.to_columns, partial(numpy_rivals.sat_hits, axes=of), circles=True
        )

    yield Method("satviz", NUMPY, "exact", batch_shapes, partial(batch.relate, engine="numpy"), circles=True)
    yield loop("SAT, raw normals", "float SAT", numpy_rivals.sat_axes)
    yield loop("SAT, unit normals", "float SAT", numpy_rivals.with_unit_length(numpy_rivals.sat_axes))
    yield loop("16 axes", "bounds", numpy_rivals.fixed_directions(16))
    yield loop("AABB", "bounds", numpy_rivals.fixed_directions(2))


def _python_methods() -> Iterator[Method]:
    def each(name: str, family: str, prepare: Callable[[Shape], Any], ask: Callable[[Any, Any], Any]) -> Method:
        def ready(side: Side) -> list[Any]:
            return [prepare(shape) for shape in engine_shapes(side)]

        return Method(name, PYTHON, family, ready, libraries.one_by_one(ask), circles=True, one=prepare)

    yield each("satviz", "exact", _same, relate)
    yield each("satviz, recorded", "exact", _same, lambda a, b: record(a, b).relation)
    yield each("SAT, raw normals", "float SAT", python_rivals.points_and_radius, python_rivals.sat)
    yield each("SAT, unit normals", "float SAT", python_rivals.points_and_radius, partial(python_rivals.sat, unit=True))
    yield each("GJK", "GJK", python_rivals.points_and_radius, python_rivals.gjk)
    ways = python_rivals.even_directions(2)
    yield each("AABB", "bounds", python_rivals.points_and_radius, partial(python_rivals.sat, choice=lambda a, b: ways))


def _same(shape: Shape) -> Shape:
    return shape


def _library_methods() -> Iterator[Method]:
    """shapely (all pairs at once, prepared, and pair by pair) and pymunk, where installed."""
    if is_installed("shapely"):
        yield Method("shapely", COMPILED, "library", libraries.shapely_geometries, libraries.shapely_hits, circles=True)
        yield Method("shapely, prepared", COMPILED, "library", libraries.prepared_geometries, libraries.shapely_hits)
        yield Method(
            "shapely",
            PYTHON,
            "library",
            libraries.geometry_list,
            libraries.one_by_one(libraries.shapely_hit),
            circles=True,
        )
    if is_installed("pymunk"):
        yield Method(
            "pymunk",
            PYTHON,
            "library",
            libraries.pymunk_shapes,
            libraries.one_by_one(libraries.pymunk_hit),
            circles=True,
        )
