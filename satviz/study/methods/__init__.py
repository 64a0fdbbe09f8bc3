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
from ..harness.machine import installed
from ..workloads.workloads import Side, outlines, padded
from . import columns, peers, scalar

COMPILED, NUMPY, PYTHON = "compiled", "NumPy", "Python"
EPS = 1e-9  # scene units
# read off numba's machine code on x86: a loop that can end early stays scalar
VECTORISED = (
    "The kernels of satviz (also without its filter), of the bounding circles and of the boxes are vectorised, the "
    "other kernels go pair by pair: the times compare these programs and not the methods alone."
)
Said = NDArray[Any]


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


def methods(*, circles: bool = False) -> list[Method]:
    """Those that answer this kind of pair, with what is installed."""
    found = [*_compiled(), *_numpy(), *_python(), *_peers()]
    return [method for method in found if method.circles or not circles]


def truths(a: Side, b: Side) -> NDArray[np.int8]:
    """The relation of each pair, by rationals."""
    return np.array([truth.relation(p, q) for p, q in zip(shapes(a), shapes(b), strict=True)], np.int8)


def asked(found: Iterable[Method], a: Side, b: Side) -> Iterator[tuple[Method, Said]]:
    """Each method with its answers to all pairs."""
    known = shapes(a), shapes(b)
    for method in found:
        with np.errstate(all="ignore"):
            yield method, np.asarray(method.hits(method.ready(a, known[0]), method.ready(b, known[1])))


def wrong(said: Said, right: NDArray[np.int8]) -> NDArray[np.bool_]:
    """Which answers are wrong; who tells touching from overlapping is held to that too."""
    return np.asarray(said != (right > 0) if said.dtype == bool else said != right)


def mistakes(said: Said, right: NDArray[np.int8]) -> dict[str, int]:
    """False hits and false misses; of a method that tells touching from overlapping also the hits it confused."""
    hit, is_hit = said > 0, right > 0
    confused = int((wrong(said, right) & hit & is_hit).sum())
    return {"false_hits": int((hit & ~is_hit).sum()), "false_misses": int((~hit & is_hit).sum()), "confused": confused}


def shapes(side: Side) -> list[Shape]:
    """A workload's side as satviz's own shapes."""
    if isinstance(side, tuple):
        return [Circle(c, r) for c, r in zip(side[0].tolist(), side[1].tolist())]
    return [Polygon(ring) for ring in outlines(side)]


def batched(side: Side) -> batch.Shapes:
    """A workload's side as satviz's batch shapes."""
    if isinstance(side, tuple):
        return batch.Circles(*side)
    return batch.Polygons(outlines(side) if padded(side) else side.copy())


def _compiled() -> Iterator[Method]:
    if not installed("numba"):
        return
    from ...batch.codes import APART
    from ...batch.with_numba.filter import clearance_kernel
    from . import kernels

    def filled(kernel: Callable[..., None], *more: Any) -> Callable[[Any, Any], Said]:
        """On (x, y) columns."""

        def hits(a: columns.Columns, b: columns.Columns) -> Said:
            out = np.empty(a.x.shape[1], np.int8)
            kernel(a.x, a.y, b.x, b.y, *more, out)
            return out > 0

        return hits

    def kept(make: Callable[..., Any], kernel: Callable[..., None], *more: Any) -> tuple[Any, Any]:
        """On what was worked out beforehand."""

        def prepare(side: Side) -> Any:
            c = columns.columns(side)
            return make(c.x, c.y, *more)

        def hits(a: Any, b: Any) -> Said:
            out = np.empty(a.shape[1], np.int8)
            kernel(a, b, out)
            return out > 0

        return prepare, hits

    def unfiltered(a: columns.Columns, b: columns.Columns) -> Said:
        out = np.empty(a.x.shape[1], np.int8)
        clearance_kernel(len(a.x), len(b.x))(a.x, a.y, b.x, b.y, 0, 0.0, out)
        return np.asarray(out != APART)  # a clearance of exactly zero it leaves open: a touch

    def bound(name: str, *of: Any) -> Method:
        return Method(name, COMPILED, "bounds", *kept(*of))

    def loop(name: str, family: str, kernel: Callable[..., None], *more: Any, dtype: type = np.float64) -> Method:
        return Method(name, COMPILED, family, partial(columns.columns, dtype=dtype), filled(kernel, *more))

    relation = partial(batch.relate, engine="numba")
    yield Method("satviz", COMPILED, "exact", batched, relation, circles=True)
    yield Method("satviz, no filter", COMPILED, "float SAT", columns.columns, unfiltered)
    yield loop("turns, adaptive", "exact in range", kernels.turns, kernels.ADAPTIVE)
    yield loop("turns, expansions", "exact in range", kernels.turns, kernels.EXACT)
    yield loop("turns, floats", "float SAT", kernels.turns, kernels.FLOAT)
    yield loop("SAT, raw normals", "float SAT", kernels.textbook, False, 0.0)
    yield loop("SAT, unit normals", "float SAT", kernels.textbook, True, 0.0)
    yield loop("SAT, float32", "float SAT", kernels.textbook, False, 0.0, dtype=np.float32)
    yield loop("SAT, 1e-9 counts as a hit", "tolerance", kernels.textbook, True, EPS)
    yield loop("SAT, 1e-9 counts as a miss", "tolerance", kernels.textbook, True, -EPS)
    yield loop("GJK", "GJK", kernels.gjk)
    yield bound("bounding circles", kernels.around, kernels.circles)
    yield bound("AABB", kernels.ranges, kernels.boxes_overlap, np.array(scalar.spread(2)))
    yield bound("oriented boxes", kernels.oriented, kernels.oriented_overlap)
    yield bound("16 axes", kernels.ranges, kernels.ranges_overlap, np.array(scalar.spread(16)))


def _numpy() -> Iterator[Method]:
    def loop(name: str, family: str, of: columns.Choice) -> Method:
        return Method(name, NUMPY, family, columns.columns, partial(columns.hits, axes=of), circles=True)

    yield Method("satviz", NUMPY, "exact", batched, partial(batch.relate, engine="numpy"), circles=True)
    yield loop("SAT, raw normals", "float SAT", columns.complete)
    yield loop("SAT, unit normals", "float SAT", columns.unit(columns.complete))
    yield loop("16 axes", "bounds", columns.fixed(16))
    yield loop("AABB", "bounds", columns.fixed(2))


def _python() -> Iterator[Method]:
    def each(name: str, family: str, prepare: Callable[[Shape], Any], ask: Callable[[Any, Any], Any]) -> Method:
        def ready(side: Side) -> list[Any]:
            return [prepare(shape) for shape in shapes(side)]

        return Method(name, PYTHON, family, ready, peers.pair_by_pair(ask), circles=True, one=prepare)

    yield each("satviz", "exact", _same, relate)
    yield each("satviz, recorded", "exact", _same, lambda a, b: record(a, b).relation)
    yield each("SAT, raw normals", "float SAT", scalar.plain, scalar.sat)
    yield each("SAT, unit normals", "float SAT", scalar.plain, partial(scalar.sat, unit=True))
    yield each("GJK", "GJK", scalar.plain, scalar.gjk)
    ways = scalar.spread(2)
    yield each("AABB", "bounds", scalar.plain, partial(scalar.sat, choice=lambda a, b: ways))


def _same(shape: Shape) -> Shape:
    return shape


def _peers() -> Iterator[Method]:
    """shapely (all pairs at once, prepared, and pair by pair) and pymunk, where installed."""
    if installed("shapely"):
        yield Method("shapely", COMPILED, "library", peers.geometries, peers.meet, circles=True)
        yield Method("shapely, prepared", COMPILED, "library", peers.prepared, peers.meet)
        yield Method("shapely", PYTHON, "library", peers.listed, peers.pair_by_pair(peers.meets), circles=True)
    if installed("pymunk"):
        yield Method("pymunk", PYTHON, "library", peers.bodies, peers.pair_by_pair(peers.collide), circles=True)
