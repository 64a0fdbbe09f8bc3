"""The methods under study: the engine in each of its forms, and twins of its loop on other choices of axes.

The twins are plain: Python floats or NumPy arrays, no record, no second look, so that what
is compared is the choice of axes and the arithmetic, not the bookkeeping.

A method prepares each side once (its set-up) and then answers all pairs: scalar ones
pair by pair, batch ones at once.
"""

from collections.abc import Callable, Iterable, Iterator
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from .. import batch
from ..engine.shapes import Circle, Polygon, Shape
from ..engine.trace import record
from ..engine.verdict import relate
from . import columns, plain, truth
from .columns import Answers
from .machine import installed
from .workloads import Side

FIXED = (2, 4, 8, 16, 32)  # numbers of fixed axes
NGONS = (8, 16, 32, 64)  # corners that stand in for a circle
EPS = 1e-9  # scene units


class Method(NamedTuple):
    """One way to answer pairs.

    `form`: "batch" or "scalar"; `prepare(side)` makes what `hits(a, b)` takes: one
    bool a pair.  `pairs`: "all", or the only kind of pair it differs or works on,
    "circles" or "polygons".  `family` decides its colour, `series` joins its variants.
    """

    name: str
    form: str
    family: str
    prepare: Callable[[Side], Any]
    hits: Callable[[Any, Any], Any]
    pairs: str = "all"
    series: str = ""
    one: Callable[[Shape], Any] | None = None  # prepares a single shape, where `prepare` starts from satviz's own

    def ready(self, side: Side, known: list[Shape]) -> Any:
        """What `prepare` gives, where satviz's own shapes of that side are known already."""
        return [self.one(shape) for shape in known] if self.one else self.prepare(side)


def methods(*, circles: bool) -> list[Method]:
    """Those that answer this kind of pair, with the peers that are installed."""
    kind = "circles" if circles else "polygons"
    return [m for m in (*_batch(), *_scalar(), *_peers()) if m.pairs in ("all", kind)]


def judged(found: Iterable[Method], a: Side, b: Side) -> tuple[int, list[dict]]:
    """How many pairs are hits, and the mistakes of each method, against rationals."""
    known = shapes(a), shapes(b)
    right = np.array([truth.relation(p, q) for p, q in zip(*known, strict=True)])
    rows = []
    for method in found:
        with np.errstate(all="ignore"):
            said = np.asarray(method.hits(method.ready(a, known[0]), method.ready(b, known[1])))
        rows.append({"form": method.form, "method": method.name, "family": method.family, **mistakes(said, right)})
    return int((right > 0).sum()), rows


def mistakes(said: np.ndarray, right: np.ndarray) -> dict[str, int]:
    """False hits and false misses; of a method that tells touching from overlapping also the hits it confused."""
    hit, is_hit = said > 0, right > 0
    confused = 0 if said.dtype == bool else int((hit & is_hit & (said != right)).sum())
    return {"false_hits": int((hit & ~is_hit).sum()), "false_misses": int((~hit & is_hit).sum()), "confused": confused}


def times_wrong(row: dict) -> int:
    """How many answers of a method were wrong, in whichever way."""
    return row["false_hits"] + row["false_misses"] + row.get("confused", 0)  # older rows tell hits and misses only


def shapes(side: Side) -> list[Shape]:
    """A workload's side as satviz's own shapes."""
    if isinstance(side, tuple):
        return [Circle(c, r) for c, r in zip(side[0].tolist(), side[1].tolist())]
    return [Polygon(ring) for ring in outlines(side)]


def outlines(rings: np.ndarray) -> list[np.ndarray]:
    """Each ring without the last corner's repeats."""
    same = (rings[:, 1:] == rings[:, :-1]).all(axis=2)
    repeats = np.logical_and.accumulate(same[:, ::-1], axis=1).sum(axis=1)
    return [ring[: len(ring) - k] for ring, k in zip(rings, repeats.tolist())]


def batched(side: Side) -> batch.Shapes:
    """A workload's side as satviz's batch shapes."""
    if isinstance(side, tuple):
        return batch.Circles(*side)
    padded = (side[:, -1] == side[:, -2]).all(axis=1).any()
    return batch.Polygons(outlines(side) if padded else side.copy())


def _batch() -> Iterator[Method]:
    def choice(name: str, family: str, of: columns.Choice, pairs: str = "all", series: str = "") -> Method:
        return Method(name, "batch", family, columns.columns, partial(columns.hits, axes=of), pairs, series)

    for engine in ("numpy", "numba"):
        if engine == "numpy" or installed("numba"):
            yield Method(f"satviz {engine}", "batch", "exact", batched, partial(batch.relate, engine=engine))
    yield Method("bounding circles", "batch", "fewer axes", columns.around, columns.circles_overlap)
    for k in FIXED:
        kept = partial(columns.ranges, k=k)
        name = "AABB, kept" if k == 2 else f"{k} axes, kept"
        yield Method(name, "batch", "fewer axes", kept, columns.ranges_overlap, series="ranges kept")
    for k in FIXED:
        name = "AABB" if k == 2 else f"{k} axes"
        yield choice(name, "fewer axes", columns.fixed(k), series="from the corners")
    yield choice("centroid axis", "fewer axes", columns.centroids)
    yield choice("SAT, raw normals", "float SAT", columns.complete)
    normalised = columns.unit(columns.complete)
    yield choice("SAT, unit normals", "float SAT", normalised)
    for name, eps in ("SAT, eps 1e-9 to hit", EPS), ("SAT, eps 1e-9 to miss", -EPS):
        tolerant = partial(columns.hits, axes=normalised, tolerance=eps)
        yield Method(name, "batch", "tolerance", columns.columns, tolerant)
    raw = partial(columns.hits, axes=columns.complete)
    yield Method("SAT, float32", "batch", "float SAT", partial(columns.columns, dtype=np.float32), raw)
    yield choice("SAT, no vertex axis", "fewer axes", columns.edge_normals, "circles")
    for n in NGONS:
        sides = partial(columns.as_ngons, n=n)
        yield Method(f"circle as {n}-gon", "batch", "fewer axes", sides, raw, "circles", "circle as n-gon")


def _scalar() -> Iterator[Method]:
    def each(name: str, family: str, prepare: Callable, ask: Callable, pairs: str = "all", series: str = "") -> Method:
        def ready(side: Side) -> list:
            return [prepare(shape) for shape in shapes(side)]

        return Method(name, "scalar", family, ready, _pair_by_pair(ask), pairs, series, prepare)

    def choice(name: str, of: plain.Choice, pairs: str = "all", series: str = "") -> Method:
        return each(name, "fewer axes", plain.plain, partial(plain.sat, choice=of), pairs, series)

    yield each("satviz.relate", "exact", _same, relate)
    yield each("satviz.record", "exact", _same, lambda a, b: record(a, b).relation)
    yield each("bounding circles", "fewer axes", plain.around, plain.circles_overlap)
    for k in FIXED:
        kept = partial(plain.ranges, directions=plain.spread(k))
        name = "AABB, kept" if k == 2 else f"{k} axes, kept"
        yield each(name, "fewer axes", kept, plain.ranges_overlap, series="ranges kept")
    for k in FIXED:
        ways = plain.spread(k)
        yield choice("AABB" if k == 2 else f"{k} axes", lambda a, b, ways=ways: ways, series="from the corners")
    yield choice("centroid axis", plain.centroid_axis)
    yield choice("SAT, no vertex axis", plain.edge_normals, "circles")
    yield each("SAT, raw normals", "float SAT", plain.plain, plain.sat)
    yield each("SAT, unit normals", "float SAT", plain.plain, partial(plain.sat, unit=True))
    for name, eps in ("SAT, eps 1e-9 to hit", EPS), ("SAT, eps 1e-9 to miss", -EPS):
        yield each(name, "tolerance", plain.plain, partial(plain.sat, unit=True, tolerance=eps))
    for n in NGONS:
        sides = partial(plain.as_ngon, n=n)
        yield each(f"circle as {n}-gon", "fewer axes", sides, plain.sat, "circles", "circle as n-gon")
    yield each("GJK", "GJK", plain.plain, plain.gjk)


def _same(shape: Shape) -> Shape:
    return shape


def _pair_by_pair(ask: Callable[[Any, Any], bool]) -> Callable[[list, list], list[bool]]:
    return lambda a, b: [ask(p, q) for p, q in zip(a, b, strict=True)]


def _peers() -> Iterator[Method]:
    """shapely (all pairs at once, prepared, and pair by pair) and pymunk, where installed."""
    if installed("shapely"):
        yield Method("shapely", "batch", "library", _geometries, _meet)
        yield Method("shapely, prepared", "batch", "library", _prepared, _meet, "polygons")
        yield Method("shapely", "scalar", "library", _listed, _pair_by_pair(_meets))
    if installed("pymunk"):
        yield Method("pymunk", "scalar", "library", _bodies, _pair_by_pair(_collide))


def _geometries(side: Side) -> Any:
    """shapely's arrays; circles as (points, radii), for shapely has no true circle."""
    import shapely

    if isinstance(side, tuple):
        return shapely.points(side[0]), side[1]
    rings = outlines(side)
    owner = np.repeat(np.arange(len(rings)), [len(ring) for ring in rings])
    return shapely.polygons(shapely.linearrings(np.concatenate(rings), indices=owner))


def _prepared(side: Side) -> Any:
    import shapely

    found = _geometries(side)
    shapely.prepare(found)
    return found


def _meet(a: Any, b: Any) -> Answers:
    import shapely

    return shapely.dwithin(a[0], b, a[1]) if isinstance(a, tuple) else shapely.intersects(a, b)


def _listed(side: Side) -> list:
    found = _geometries(side)
    return list(zip(found[0], found[1].tolist())) if isinstance(found, tuple) else list(found)


def _meets(a: Any, b: Any) -> bool:
    return bool(a[0].dwithin(b, a[1]) if isinstance(a, tuple) else a.intersects(b))


def _bodies(side: Side) -> list:
    import pymunk

    body = pymunk.Body(body_type=pymunk.Body.STATIC)
    if isinstance(side, tuple):
        found: list = [pymunk.Circle(body, r, tuple(c)) for c, r in zip(side[0].tolist(), side[1].tolist())]
    else:
        found = [pymunk.Poly(body, [tuple(v) for v in ring.tolist()]) for ring in outlines(side)]
    for shape in found:
        shape.cache_bb()
    return found


def _collide(a: Any, b: Any) -> bool:
    try:
        return bool(a.shapes_collide(b).points)
    except AssertionError:  # what pymunk 7 raises for two shapes without a contact
        return False
