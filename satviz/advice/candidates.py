"""The candidate models of a recommendation: simpler or faster tests of a pair, from the fewest axes to the most.

A *model* is a way to find the relation of two shapes (apart, touching or overlapping): bounding circles, bounding boxes
(AABB), ranges on a few fixed directions (a k-DOP), SAT in plain floats of one format, and the exact filter.
A model is *certified* for a pair where no order of its operations, fused or not, can give another relation
(`certified_bounds.py`); `models.py` evaluates the models for many pairs.
"""

from collections.abc import Collection, Iterable, Sequence
from itertools import chain, pairwise
from math import copysign, frexp, inf, ldexp
from typing import NamedTuple

from ..engine.convex_parts import parts
from ..engine.geometry import Vec, cyclic_pairs
from ..engine.predicates import IntPoint, to_int_points
from ..engine.shapes import Polygon, Shape
from .rounding import FORMATS

BOUNDING_CIRCLES, AABB, K_DOP, EXACT_FILTER = "bounding circles", "AABB", "shared directions", "filtered exact"
MAX_DIRECTIONS = 8
PARALLEL_ANGLE = 2.0**-20  # radians: closer normals count as one direction, which is then certified or refused


class SplitPolygon:
    """Hold a concave polygon known only by its convex parts, as in a batch, with what the models need."""

    radius = 0.0
    core_is_point = False

    def __init__(self, convex_parts: Sequence[Shape]) -> None:
        self.convex_parts = convex_parts
        self.core = tuple(chain.from_iterable(p.core for p in convex_parts))
        boxes = [p.bounds for p in convex_parts]
        self.bounds = (*(min(b[i] for b in boxes) for i in (0, 1)), *(max(b[i] for b in boxes) for i in (2, 3)))
        self.max_coordinate = max(p.max_coordinate for p in convex_parts)
        self.is_upright_box = self.is_convex = False

    def outline(self) -> Shape:
        """Return the whole polygon: the edges that belong to one part only, cut where a corner lies on them."""
        places = list(dict.fromkeys(self.core))
        _, at = to_int_points(places)
        edges: set[tuple[int, int]] = set()
        for p, q in (edge for part in self.convex_parts for edge in cyclic_pairs([places.index(v) for v in part.core])):
            (px, py), (qx, qy) = at[p], at[q]
            dx, dy = qx - px, qy - py
            along = {i: dx * (x - px) + dy * (y - py) for i, (x, y) in enumerate(at) if dx * (y - py) == dy * (x - px)}
            stops = sorted((i for i in along if along[p] <= along[i] <= along[q]), key=along.__getitem__)
            edges.update(pairwise(stops))
        after = dict(edge for edge in edges if edge[::-1] not in edges)
        ring = [min(after)]
        while after[ring[-1]] != ring[0]:
            ring.append(after[ring[-1]])
        return Polygon([places[i] for i in ring])

    @property
    def integers(self) -> tuple[int, list[IntPoint], int]:
        """Return (k, core, 0): the corners as integers in units of 2**-k, and the radius 0."""
        return (*to_int_points(self.core), 0)


AnyShape = Shape | SplitPolygon


def convex_parts(shape: AnyShape) -> Sequence[Shape]:
    """Return the convex parts of a shape: the shape itself if it is convex."""
    return shape.convex_parts if isinstance(shape, SplitPolygon) else parts(shape)


class Model(NamedTuple):
    """Describe a model (a way to test a pair) and the number of axes that it tests for the largest pair.

    `kind`: a constant above, such as "AABB", or a float format's name for SAT in plain floats; `directions`: the fixed
    ones of a k-DOP, any (x, y); `after_boxes`: whether it follows a test of the bounding boxes, whose two axes then
    count among `axes`.
    """

    kind: str
    axes: int
    directions: tuple[Vec, ...] = ()
    after_boxes: bool = False

    @property
    def test(self) -> str:
        """Return the name of the model's own test, without the test of bounding boxes before it."""
        if self.kind == K_DOP:
            return f"ranges on {len(self.directions)} directions"
        return f"SAT, {self.kind}" if self.kind in FORMATS else self.kind

    @property
    def name(self) -> str:
        """Return the full name, with the test of bounding boxes if that comes first."""
        return f"{AABB}, then {self.test}" if self.after_boxes else self.test


def candidates(
    axes: int, directions: tuple[Vec, ...], only_circles: bool, kinds_without_boxes: Collection[str] | None = None
) -> tuple[Model, ...]:
    """Return the candidate models, from the fewest axes to the most, then from the lowest precision to exact.

    `axes`: how many SAT tests for the largest pair; `directions`: the distinct ones of all edge normals, () for no
    k-DOP; `only_circles`: whether all shapes are circles.
    `kinds_without_boxes`: None for given pairs, which need no test of bounding boxes first.  For all pairs of a batch
    each model comes after such a test (`after_boxes`); models of these kinds are candidates without the test too.
    """
    found = [] if only_circles else [Model(BOUNDING_CIRCLES, 1)]
    found.append(Model(AABB, 2))
    upright = all(0.0 in n for n in directions)
    if not upright and 2 <= len(directions) < axes:
        found.append(Model(K_DOP, len(directions), directions))
    found += [Model(kind, axes) for kind in (*FORMATS, EXACT_FILTER)]
    if kinds_without_boxes is not None:
        after_boxes = [m._replace(axes=m.axes + 2, after_boxes=True) for m in found if m.kind != AABB]
        found = [m for m in found if m.kind == AABB or m.kind in kinds_without_boxes] + after_boxes
    return tuple(sorted(found, key=lambda model: model.axes))


def shared_directions(shapes: Iterable[AnyShape]) -> tuple[Vec, ...]:
    """Return the distinct directions of all edge normals; () for more than MAX_DIRECTIONS or with circles.

    The larger component of each is scaled to between a half and 1.  Directions within PARALLEL_ANGLE of each other
    count as one.  They are taken in order of x and then y, so the order of shapes and corners changes nothing.
    """
    left = set()
    for ring in (part.core for shape in shapes for part in convex_parts(shape)):
        for (px, py), (qx, qy) in cyclic_pairs(ring):
            nx, ny = qy - py, px - qx
            size = max(abs(nx), abs(ny))
            if not 0 < size < inf:  # a circle's core has one corner and no edge
                return ()
            scale = copysign(1.0, nx or ny)
            left.add(Vec(*(ldexp(scale * c, -frexp(size)[1]) + 0.0 for c in (nx, ny))))
    found: list[Vec] = []
    while left:
        if len(found) == MAX_DIRECTIONS:
            return ()
        found.append(n := min(left))
        left = {m for m in left if abs(n.x * m.y - n.y * m.x) > PARALLEL_ANGLE}
    return tuple(found)


def count_axes(a: AnyShape, b: AnyShape) -> int:
    """Return how many axes SAT tests on all pairs of convex parts: each edge of both, and one more with a circle."""
    pairs = [(p, q) for p in convex_parts(a) for q in convex_parts(b)]
    edges = sum(len(s.core) for pair in pairs for s in pair if not s.core_is_point)
    return edges + sum(p.core_is_point or q.core_is_point for p, q in pairs)
