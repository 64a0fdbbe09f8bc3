"""Circles with polygons that the filter leaves undecided: exact signs, and only of what matters in each pair.

The center is inside, or the nearest point is a corner or the foot on an edge.  Floats
show which of these can lie within the radius (mostly one), and only they are decided:
by sums of two floats, else exactly where no difference of coordinates was rounded, else
(hardly ever) with integers.  No sign is of a degree above two: the orientation determinant
of an edge and the center is compared with the radius times the edge's length.  They can be
equal only if the length is rational, and then it is nearly always a float.
"""

import numpy as np
from numpy.typing import NDArray

from ...engine.predicates import MAX_SAFE_PRODUCT, MIN_SAFE_PRODUCT, to_integers
from ...engine.relate import relate_integers
from .. import exact_signs
from ..array_types import Array, Indices, Signs
from ..exact_signs import UNKNOWN, Products, two_sum

BLOCK_PAIRS = 1 << 13  # pairs at a time, where they have few corners: their columns stay in the second-level cache
MAX_INTEGER_PAIRS = 32  # pairs that integers settle sooner


def gap_signs(cx: Array, cy: Array, cr: Array, px: Array, py: Array) -> Signs:
    """Return the exact sign of (distance minus radius) for each circle and polygon; -1 if the center is inside.

    cx, cy, cr: (n,) centers and radii; px, py: (V, n) corners, one polygon in each column.
    """
    found = np.full(len(cx), UNKNOWN, np.int8)
    with np.errstate(all="ignore"):
        size = min(BLOCK_PAIRS, exact_signs.pairs_per_block(len(px)))
        for start in range(0, len(cx) if len(cx) > MAX_INTEGER_PAIRS else 0, size):
            part = slice(start, start + size)
            found[part] = _float_signs(*(c[..., part] for c in (cx, cy, cr, px, py)))
    for i in np.flatnonzero(found == UNKNOWN):
        found[i] = _integer_sign(cx[i], cy[i], cr[i], px[:, i], py[:, i])
    return found


def _integer_sign(cx: float, cy: float, cr: float, px: Array, py: Array) -> int:
    """Return what `gap_signs` does for one circle and polygon, with integers; px, py: (V,)."""
    _, (x, y, r, *flat) = to_integers([float(cx), float(cy), float(cr), *px.tolist(), *py.tolist()])
    return 1 - relate_integers([(x, y)], list(zip(flat[: len(px)], flat[len(px) :], strict=True)), r)


def _float_signs(cx: Array, cy: Array, cr: Array, px: Array, py: Array) -> Signs:
    """Return what `gap_signs` does, by floats with their errors; UNKNOWN where these do not decide."""
    n, v = len(cx), len(px)
    px, py = _close_rings(px), _close_rings(py)
    corners, upright, slanted, inside, error_bound = _features_within_radius(cx, cy, cr, px, py)
    found = np.ones(v * n, np.int8)
    least = found.reshape(v, n)

    def taken(where: Indices, ends: int) -> tuple[Indices, list[Array]]:
        """Return (pair of each chosen corner or edge, [cx, cy, cr, then x, y of its first `ends` corners])."""
        pair = where - where // n * n  # NumPy's own remainder takes twice as long
        return pair, [c[pair] for c in (cx, cy, cr)] + [c.ravel()[where + n * i] for i in range(ends) for c in (px, py)]

    if corners.size:
        found[corners] = _corner_signs(*taken(corners, 1)[1])
    if upright.size:
        found[upright] = np.minimum(found[upright], _upright_signs(*taken(upright, 2)[1]))
    if slanted.size:
        pair, edges = taken(slanted, 2)
        value, doubtful = _foot_signs(*edges, error_bound=error_bound[pair])
        ask = np.flatnonzero(doubtful & (value < least.min(axis=0)[pair]))
        if ask.size:
            value[ask] = _keep_inner_feet(value[ask], *(c[ask] for c in edges))
        found[slanted] = np.minimum(found[slanted], value)
    nearest: Signs = least.min(axis=0)
    inside = inside[nearest[inside] >= 0]
    if inside.size:
        nearest[inside[_contains_center(*(c[..., inside] for c in (cx, cy, px, py)))]] = -1
    nearest[error_bound == np.inf] = UNKNOWN
    return nearest


def _close_rings(c: Array) -> Array:
    """Return (V, n) corner coordinates as (V + 1, n), with the first corner repeated at the end."""
    closed = np.empty((len(c) + 1, c.shape[1]))
    closed[:-1], closed[-1] = c, c[0]
    return closed


def _features_within_radius(
    cx: Array, cy: Array, cr: Array, px: Array, py: Array
) -> tuple[Indices, Indices, Indices, Indices, Array]:
    """Return (corners, axis-parallel edges, other edges, pairs, error bound) that may decide a pair.

    The first three are flat indices into (V, n) of what may lie within the radius; `pairs` are those whose center may
    be inside; the error bound, (n,), is that of products of differences: the bound of filter.circle_polygons or up to
    twice that.  Out of range it is infinite, and the pair has none of the others.  px, py: (V + 1, n), closed.
    """
    x, y = px[:-1] - cx, py[:-1] - cy
    distance = x * x
    distance += y * y
    within = cr * cr
    error_bound = np.maximum(distance.max(axis=0), within)
    error_bound *= 2.0**-46
    within += error_bound
    near, upright = np.empty((2, *x.shape), bool)
    lowest, shortest = np.full((2, len(cx)), np.inf)
    for i in range(len(x)):
        dx, dy = px[i + 1] - px[i], py[i + 1] - py[i]
        orientation, along, square = x[i] * dy, x[i] * dx, dx * dx
        orientation -= y[i] * dx
        along += y[i] * dy
        square += dy * dy
        near[i] = orientation * (orientation / square) <= within
        near[i] &= np.maximum(along, -square - along) < error_bound
        upright[i] = (dx == 0) | (dy == 0)
        np.minimum(lowest, orientation, out=lowest)
        np.minimum(shortest, square, out=shortest)
    unsafe = np.flatnonzero(
        ~(
            (error_bound > MIN_SAFE_PRODUCT)
            & (error_bound < MAX_SAFE_PRODUCT * 2.0**-46)
            & (shortest > MIN_SAFE_PRODUCT)
        )
    )
    error_bound[unsafe], within[unsafe], near[:, unsafe], lowest[unsafe] = np.inf, -1.0, False, np.nan
    places = [np.flatnonzero(m) for m in (distance <= within, near & upright, near & ~upright, lowest >= -error_bound)]
    return *places, error_bound


def _corner_signs(cx: Array, cy: Array, cr: Array, px: Array, py: Array) -> Signs:
    """Return the exact signs of (distance from corner p to the center minus radius), or UNKNOWN; all arrays are (n,).

    At exactly the radius no difference is rounded: let the radius be odd in units of a power of
    two, and both differences whole in units of that over 2**m, one of them odd.  One odd square,
    or two, add up to no multiple of four: m is 0, and whole numbers up to the radius are floats.
    """
    (x, a), (y, b) = two_sum(px, -cx), two_sum(py, -cy)
    remainder = x * a + y * b
    return _signs_of_sums([(x, x), (y, y), (-cr, cr)], remainder + remainder, (a == 0) & (b == 0))


def _upright_signs(cx: Array, cy: Array, cr: Array, px: Array, py: Array, qx: Array, qy: Array) -> Signs:
    """Return the signs of (distance from center to edge line minus radius); 1 if the foot is not between p and q.

    Edges lead from p to q, along x or y; the foot is the point of the line next to the center.  Rounding is monotonic:
    the rounded distance is on the right side of the radius, or equal to it.  If it is equal, the rounding error (from
    two_sum) decides.
    """
    flat = py == qy
    c, p, q = np.where(flat, cx, cy), np.where(flat, px, py), np.where(flat, qx, qy)
    gap, rest = two_sum(np.where(flat, py, px), -np.where(flat, cy, cx))
    rest *= np.sign(gap)
    gap = np.abs(gap) - cr
    return np.where((p < c) == (c < q), np.sign(np.where(gap == 0, rest, gap)), 1).astype(np.int8)


def _foot_signs(
    cx: Array, cy: Array, cr: Array, px: Array, py: Array, qx: Array, qy: Array, *, error_bound: Array
) -> tuple[Signs, NDArray[np.bool_]]:
    """Return (signs of (distance from center to edge line minus radius), mask of feet that may not be between p and q).

    error_bound: as `_features_within_radius` returns it.  UNKNOWN stands for signs that floats do not decide.

    The exact length of an edge is the float `length` plus `missing`: the difference of their squares over twice the
    float (the square of `missing` is negligible).  Errors in the units of exact_signs.sum_with_error: `missing` is off
    by 41uu of the length, the rounded products of remainders by 16uuR, the products left out by uuR, that function's
    own sums by 30uuR.  In all they are 88uuR, below the 256uuR of ERRBOUND_B.
    """
    (x, a), (y, b), (dx, f), (dy, g) = two_sum(px, -cx), two_sum(py, -cy), two_sum(qx, -px), two_sum(qy, -py)
    orientation, along, square = y * dx - x * dy, x * dx + y * dy, dx * dx + dy * dy
    doubtful = np.maximum(along, -square - along) >= -error_bound
    length = np.sqrt(square)
    remainder = dx * f + dy * g
    missing, off, terms = exact_signs.sum_with_error([(dx, dx), (dy, dy), (-length, length)], remainder + remainder)
    exact = np.flatnonzero((np.abs(missing) <= off) & (off < np.inf) & (f == 0) & (g == 0))
    exact = exact[exact_signs.sign_of_sum(exact_signs.take_columns(terms, exact)) == 0]
    missing /= length + length
    missing[exact] = 0.0
    no_remainder = np.zeros(len(x), bool)
    no_remainder[exact] = (a[exact] == 0) & (b[exact] == 0)
    side = np.copysign(1.0, orientation)
    unclear = np.flatnonzero(np.abs(orientation) <= error_bound)
    if unclear.size:
        side[unclear] = -exact_signs.orient(*(c[unclear] for c in (px, py, qx, qy, cx, cy)))
    remainder = side * (b * dx + y * f - a * dy - x * g) - cr * missing
    return _signs_of_sums([(side * y, dx), (-side * x, dy), (-cr, length)], remainder, no_remainder), doubtful


def _keep_inner_feet(
    least: Signs, cx: Array, cy: Array, cr: Array, px: Array, py: Array, qx: Array, qy: Array
) -> Signs:
    """Return the signs `least` of the edges p-q that have the center's foot strictly between their ends; 1 or UNKNOWN.

    The foot is the point of the edge's line next to the center.  Sign 1 stands for an edge that decides nothing,
    because one of its ends is nearer; UNKNOWN where rounding hides whether the foot is between the ends.
    """
    (dx, f), (dy, g) = two_sum(qx, -px), two_sum(qy, -py)
    inner = []
    for way, ends in ((-1.0, (px, py)), (1.0, (qx, qy))):
        (x, a), (y, b) = two_sum(ends[0], -cx), two_sum(ends[1], -cy)
        remainder = way * (a * dx + x * f + b * dy + y * g)
        no_remainder = (a == 0) & (b == 0) & (f == 0) & (g == 0)
        inner.append(_signs_of_sums([(way * x, dx), (way * y, dy)], remainder, no_remainder))
    worst = np.minimum(*inner)
    return np.where(worst == UNKNOWN, UNKNOWN, np.where(worst > 0, least, 1))


def _signs_of_sums(pairs: Products, remainder: Array, no_remainder: NDArray[np.bool_]) -> Signs:
    """Return for each column the sign of the sum of all products and `remainder`; UNKNOWN within the error bound.

    `remainder` is rounded; where the mask `no_remainder` is True it is exactly 0, so the sign is computed exactly.
    """
    total, off, terms = exact_signs.sum_with_error(pairs, remainder)
    found = exact_signs.certified_sign(total, off)
    rest = np.flatnonzero(found == 0)
    found[rest] = UNKNOWN
    rest = rest[no_remainder[rest] & (off[rest] < np.inf)]
    found[rest] = exact_signs.sign_of_sum(exact_signs.take_columns(terms, rest))
    return found


def _contains_center(cx: Array, cy: Array, px: Array, py: Array) -> NDArray[np.bool_]:
    """Return the (n,) mask of the centers strictly inside their polygon; px, py: (V + 1, n), closed."""
    ends = [np.ravel(c) for c in (px[:-1], py[:-1], px[1:], py[1:])]
    centers = [np.tile(c, len(px) - 1) for c in (cx, cy)]
    left = (exact_signs.orient(*ends, *centers) > 0).reshape(len(px) - 1, -1)
    inside: NDArray[np.bool_] = np.logical_and.reduce(left)
    return inside
