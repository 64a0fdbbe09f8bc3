"""The relation that a model certainly finds for one pair: proven by integers and error bounds.

A model is *certified* for a pair where no order of its operations, fused or not, can give another relation.  Each
`certify_...` function returns that relation, right or wrong, or None where rounding can decide it.  All is exact:
integers, fractions, and error bounds that are derived here.

Symbols: u is the unit roundoff (2**-53; 2**-24 in float32), D the span of an edge (its larger component), M the largest
absolute coordinate of the pair.  A format that does not hold all coordinates first rounds each by d = u M at most; d is
0 where it holds them.

Where a bound cannot decide, the pair may still be one on which the model rounds nothing, in whatever order it computes
(`rounding.py`): there plain floats decide touching too.
"""

from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import chain
from math import inf, isfinite, nextafter, sqrt

from ..engine.geometry import APART, OVERLAPPING, Relation, Vec, cyclic_pairs, relation_of_gap
from ..engine.predicates import MAX_SAFE_PRODUCT, MIN_SAFE_PRODUCT, sign, to_common_unit, to_integers
from ..engine.relate import relate, relate_integers
from ..engine.shapes import Shape
from . import rounding
from .candidates import AABB, BOUNDING_CIRCLES, EXACT_FILTER, K_DOP, AnyShape, Model, convex_parts
from .relative_margin import exact_edge_clearances, exact_edge_distances
from .rounding import FLOAT64, FORMATS, ExactArithmetic, FloatFormat, is_representable

# Error bounds in roundings, each rounded up from its derivation:
# An orientation in SAT is nx*x + ny*y less the same for the edge's own corner.  The normal carries one rounding (u D)
# and each product one more: 2u D M each, 4u D M both; their sum rounds by 2u D M.  That is 6u D M for the corner, as
# much for the edge's own, and 4u D M for the difference: below 17u D M (as derived in satviz/engine/relate.py).
SAT_ROUNDINGS = 32
# An orientation about a center carries below 12 roundings of its size.
TURN_ROUNDINGS = 32
# A squared distance carries below 45 roundings of the largest difference squared.
DISTANCE_ROUNDINGS = 128
# A landing on a direction is off by 4 roundings of m M (m the larger component), a gap of two landings by 8.
LANDING_ROUNDINGS = 16
# Each side of the comparison of squares carries below 5 roundings, and 2 more where the radii are rounded first.
SQUARE_ROUNDINGS = 12
# Ranges on an edge normal, or on the line from a center to the nearest vertex or to a center.  With R the largest
# coordinate and the radius together, the landings of a center and of a corner carry 6u D R each, the radius times the
# axis's length 6u D R, their sum 2u D R: 20u R in distance.  A vertex that only seems the nearest is so by at most 10u
# of its distance squared, which turns the axis by so little that 14u R is lost.  Rounded coordinates move the gap by
# 4u R.  That is 38u R.
RANGE_ROUNDINGS = 72

WIDENING = 1 + 2.0**-40  # a bounding circle's rounded radius is multiplied by it, so that the circle holds every corner

Disc = tuple[float, float, float]  # x, y, radius


def exact_relation(a: AnyShape, b: AnyShape) -> Relation:
    """Return the relation by integers alone, without a filter."""
    return max(relate_integers(*to_common_unit(p, q)[:3]) for p in convex_parts(a) for q in convex_parts(b))


def certify(model: Model, a: AnyShape, b: AnyShape) -> Relation | None:
    """Return the relation that the model finds in every order of its operations; None where rounding can decide it."""
    if model.kind == EXACT_FILTER:
        return max(relate(p, q) for p in convex_parts(a) for q in convex_parts(b))
    if model.kind == AABB:
        return certify_boxes(a, b)
    if model.kind == BOUNDING_CIRCLES:
        return certify_bounding_circles(a, b)
    if model.kind == K_DOP:
        return certify_directions(a, b, model.directions)
    return certify_sat(a, b, FORMATS[model.kind])


# -- bounding boxes


def certify_boxes(a: AnyShape, b: AnyShape) -> Relation | None:
    """Return the relation that bounding boxes certainly give; None where a circle's rounded sides can decide it."""
    outer, inner = (_compare_boxes(*(_bounding_box(s, outwards) for s in (a, b))) for outwards in (inf, -inf))
    return relation_of_gap(outer) if outer == inner else None


def _compare_boxes(a: tuple[float, ...], b: tuple[float, ...]) -> int:
    """Return 1 if the boxes are apart, 0 if they touch, -1 if they overlap; a difference could underflow."""
    (ax0, ay0, ax1, ay1), (bx0, by0, bx1, by1) = a, b
    if ax1 < bx0 or bx1 < ax0 or ay1 < by0 or by1 < ay0:
        return 1
    return 0 if ax1 == bx0 or bx1 == ax0 or ay1 == by0 or by1 == ay0 else -1


def _bounding_box(shape: AnyShape, outwards: float) -> tuple[float, ...]:
    """Return the bounding box; a rounded side of a circle's box is moved one float outwards (inf) or inwards (-inf)."""
    if not shape.core_is_point:
        return shape.bounds
    sides = []
    for out in (-1.0, 1.0):
        for c in shape.core[0]:
            side = c + out * shape.radius
            exact = isfinite(side) and Fraction(side) == Fraction(c) + Fraction(out * shape.radius)
            sides.append(side if exact else nextafter(side, out * outwards))
    return tuple(sides)


# -- circles


def bounding_circle(shape: AnyShape, widening: float = WIDENING) -> Disc:
    """Return a circle around a shape: a circle itself, or one from the center of a polygon's bounding box.

    It reaches the farthest corner.  A polygon's radius is multiplied by `widening`; 0 where floats cannot compute it.
    """
    if shape.core_is_point:
        return (*shape.core[0], shape.radius)
    x0, y0, x1, y1 = shape.bounds
    x, y = x0 / 2 + x1 / 2, y0 / 2 + y1 / 2
    square = max((px - x) * (px - x) + (py - y) * (py - y) for px, py in shape.core)
    # below MIN_SAFE_PRODUCT bits are lost, and beyond MAX_SAFE_PRODUCT they overflow
    return x, y, sqrt(square) * widening if MIN_SAFE_PRODUCT < square < MAX_SAFE_PRODUCT else 0.0


def certify_bounding_circles(a: AnyShape, b: AnyShape) -> Relation | None:
    """Return the relation that bounding circles certainly give, with widened radii and with bare ones; else None."""
    wide, bare = (certify_circles(bounding_circle(a, by), bounding_circle(b, by), FLOAT64) for by in (WIDENING, 1.0))
    return wide if wide is bare else None


def certify_circles(a: Disc, b: Disc, form: FloatFormat) -> Relation | None:
    """Return the relation certainly found for two circles, by squares as well as by ranges; None if uncertain.

    Coordinates rounded by d move a difference by 2d, so the squared distance by 4d (|dx| + |dy|) + 8dd.
    """
    if not (a[2] and b[2] and all(map(isfinite, (*a, *b)))):
        return None
    _, (ax, ay, ar, bx, by, br) = to_integers((*a, *b))
    moved = _coordinate_error((ax, ay, bx, by), (*a, *b), form)
    distance, radius_sum_squared = (ax - bx) ** 2 + (ay - by) ** 2, (ar + br) ** 2
    gap = distance - radius_sum_squared
    size = max(abs(a[0] - b[0]), abs(a[1] - b[1]), a[2] + b[2])
    error_bound = Fraction(SQUARE_ROUNDINGS * (distance + radius_sum_squared), 1 << form.bits)
    error_bound += 5 * moved * (abs(ax - bx) + abs(ay - by)) + 9 * moved**2
    by_squares = form.least < size and max(map(abs, (*a, *b))) < form.most and abs(gap) > error_bound
    range_error = Fraction(RANGE_ROUNDINGS * (max(map(abs, (ax, ay, bx, by))) + max(ar, br)), 1 << form.bits)
    radii = ar + br
    beyond = distance > (radii + range_error) ** 2
    if by_squares and (beyond or (radii > range_error and distance < (radii - range_error) ** 2)):
        return relation_of_gap(gap)
    for formula in (rounding.circle_ranges,) if by_squares else (rounding.circle_ranges, rounding.circles):
        arithmetic = ExactArithmetic(form)
        formula(arithmetic, *([arithmetic.held(Fraction(c)) for c in disc] for disc in (a, b)))
        if not arithmetic.exact:
            return None
    return relation_of_gap(gap)


# -- ranges on fixed directions


def certify_directions(a: AnyShape, b: AnyShape, directions: Sequence[Vec]) -> Relation | None:
    """Return the relation that ranges on these directions certainly give; None if rounding can decide it."""
    if a.core_is_point or b.core_is_point:
        return None
    p, q, *_ = to_common_unit(a, b)
    trusted = FLOAT64.least < max(a.max_coordinate, b.max_coordinate) < FLOAT64.most
    found = []
    for n in directions:
        _, (mx, my) = to_integers(n)
        on_p, on_q = ([mx * x + my * y for x, y in ring] for ring in (p, q))
        gap = max(min(on_p) - max(on_q), min(on_q) - max(on_p))
        most = max(abs(mx), abs(my)) * max(abs(c) for ring in (p, q) for v in ring for c in v)
        certain = trusted and abs(gap) << FLOAT64.bits > LANDING_ROUNDINGS * most
        certain = certain or _projects_exactly((*a.core, *b.core), n)
        if certain and gap > 0:
            return APART
        found.append(sign(gap) if certain else None)
    return None if None in found else relation_of_gap(max(gap for gap in found if gap is not None))


def _projects_exactly(corners: Iterable[Vec], direction: Vec) -> bool:
    """Return whether projecting the corners on the direction in float64 rounds nothing."""
    arithmetic = ExactArithmetic(FLOAT64)
    normal = Fraction(direction[0]), Fraction(direction[1])
    for x, y in corners:
        rounding.landing(arithmetic, normal, (Fraction(x), Fraction(y)))
    return arithmetic.exact


# -- SAT


def certify_sat(a: AnyShape, b: AnyShape, form: FloatFormat) -> Relation | None:
    """Return the relation that SAT in this float format certainly finds, part by part; None if not certain."""
    found = [certify_convex_sat(p, q, form) for p in convex_parts(a) for q in convex_parts(b)]
    if OVERLAPPING in found:
        return OVERLAPPING
    return None if None in found else max(r for r in found if r is not None)


def certify_convex_sat(a: Shape, b: Shape, form: FloatFormat) -> Relation | None:
    """Return the relation that SAT in floats of `form` must find on two convex shapes; None if not certain."""
    if a.core_is_point and b.core_is_point:
        return certify_circles((*a.core[0], a.radius), (*b.core[0], b.radius), form)
    if a.core_is_point or b.core_is_point:
        return _certify_circle_polygon(a, b, form) if a.core_is_point else _certify_circle_polygon(b, a, form)
    found = _certify_polygons(a, b, form)
    if found is None and _polygons_round_nothing(a, b, form):
        return relate(a, b)
    return found


def _polygons_round_nothing(a: Shape, b: Shape, form: FloatFormat) -> bool:
    """Return whether the format holds every number that SAT can compute of two convex polygons."""
    arithmetic = ExactArithmetic(form)
    p, q = ([(arithmetic.held(Fraction(x)), arithmetic.held(Fraction(y))) for x, y in s.core] for s in (a, b))
    return all(arithmetic.exact for _ in rounding.polygons(arithmetic, p, q))


def _certify_polygons(a: Shape, b: Shape, form: FloatFormat) -> Relation | None:
    """Return the relation that SAT certainly finds on two convex polygons, by error bounds per edge, or None.

    Where no coordinate is rounded (d = 0), the result is certain if the relative margin is beyond SAT_ROUNDINGS.
    Otherwise d is the largest rounding error of a coordinate, D the largest component of the normal and E that of a
    difference of corners.  Each component changes by at most 2d, so the orientation changes by at most 4d (D + E) +
    8dd.
    """
    numbers = [c for v in (*a.core, *b.core) for c in v]
    p, q, *_ = to_common_unit(a, b)
    coordinates = [c for ring in (p, q) for v in ring for c in v]
    max_coordinate = max(map(abs, coordinates))
    if not form.least < max(a.max_coordinate, b.max_coordinate) < form.most:
        return None
    widest = max(max(r[d] for r in (*p, *q)) - min(r[d] for r in (*p, *q)) for d in (0, 1))
    moved = _coordinate_error(coordinates, numbers, form)
    overlapping = True
    for ring, other, core in (p, q, a.core), (q, p, b.core):
        edges = zip(exact_edge_clearances(ring, other), cyclic_pairs(core), strict=True)
        for (clearance, span), ((fx, fy), (gx, gy)) in edges:
            error_bound = SAT_ROUNDINGS * (span + 2 * moved) * (max_coordinate + moved) / (1 << form.bits)
            error_bound += 4 * moved * (span + widest) + 8 * moved * moved
            certain = abs(clearance) > error_bound and max(abs(fx - gx), abs(fy - gy)) > form.least
            if certain and clearance > 0:
                return APART
            overlapping = overlapping and certain
    return OVERLAPPING if overlapping else None


def _certify_circle_polygon(circle: Shape, polygon: Shape, form: FloatFormat) -> Relation | None:
    """Return the relation SAT certainly finds on circle and polygon, by distances and ranges, or None.

    With F the largest difference of a corner and the center: coordinates rounded by d move an orientation about an edge
    with components dx, dy by 2d (|dx| + |dy|) + 4dF + 8dd, and the distance by 3d, so its square by 9dF + 9dd.
    """
    numbers = (*circle.core[0], circle.radius, *chain.from_iterable(polygon.core))
    (center,), ring, r, _ = to_common_unit(circle, polygon)
    cx, cy = circle.core[0]
    far = max(max(abs(x - cx), abs(y - cy)) for x, y in polygon.core)
    least = min(max(abs(x - u), abs(y - v)) for (x, y), (u, v) in cyclic_pairs(polygon.core))
    moved = _coordinate_error((*center, *chain.from_iterable(ring)), numbers, form)
    most = max(far, *map(abs, numbers))
    if not (form.least + 2 * most * bool(moved) * 2.0**-form.bits < least and most < form.most):
        return None
    widest = max(max(abs(x - center[0]), abs(y - center[1])) for x, y in ring)
    inside, outside, distances = True, False, []
    for (dx, dy), orientation, (s, q) in exact_edge_distances(center, ring):
        length = abs(dx) + abs(dy)
        error_bound = TURN_ROUNDINGS * (widest + 2 * moved) * (length + 4 * moved) / (1 << form.bits)
        error_bound += 2 * moved * length + 4 * moved * widest + 8 * moved**2
        inside = inside and orientation > error_bound
        outside = outside or -orientation > error_bound
        distances.append(Fraction(s * s, q))
    nearest = min(distances)  # squared, of all edges: none is left out
    error_bound = (DISTANCE_ROUNDINGS * (widest + 2 * moved) ** 2 + 8 * r * r) / (1 << form.bits)
    error_bound += 9 * moved * (widest + moved)
    range_error = Fraction(RANGE_ROUNDINGS * (max(abs(c) for v in (center, *ring) for c in v) + r), 1 << form.bits)
    deep = r > range_error and nearest < (r - range_error) ** 2
    if inside and (r > range_error or nearest > (range_error - r) ** 2):
        return OVERLAPPING
    if deep and nearest < r * r - error_bound:
        return OVERLAPPING
    return APART if outside and nearest > max(r * r + error_bound, (r + range_error) ** 2) else None


def _coordinate_error(coordinates: Iterable[int], numbers: Iterable[float], form: FloatFormat) -> Fraction:
    """Return an upper bound of the rounding error of any coordinate in this format; 0 if none is rounded.

    `numbers`: the coordinates as floats; `coordinates`: the same as integers, whose unit the result has.
    """
    if form is FLOAT64 or all(is_representable(Fraction(c), form) for c in numbers):
        return Fraction(0)
    return Fraction(max(map(abs, coordinates)), 1 << form.bits)
