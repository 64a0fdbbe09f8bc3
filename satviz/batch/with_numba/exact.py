"""The exact relation of any pair of convex polygons, compiled with numba.

For outlines of many corners a few steps of GJK search for an axis or a shared point.  Then both outlines are
evaluated edge by edge; the exact sign is computed for every corner within the error bound of zero.
Names in the kernels: x, y are the coordinates of one outline (corners i0 to i1 - 1) and p, q those of the other
(corners j0 to j1 - 1); e and f are the ends of an edge, n its normal; `terms` is scratch for exact sums;
`max_coordinate` is the sum of the largest absolute coordinates of both shapes.
"""

import numpy as np

from ...engine.predicates import MAX_SAFE_PRODUCT, MIN_SAFE_PRODUCT
from ...engine.relate import ERROR_FACTOR_F64, MAX_ERROR_BOUND, MIN_ERROR_BOUND
from ..array_types import Array
from ..codes import APART, OVERLAPPING, TOUCHING, UNDECIDED
from ..exact_signs import ERRBOUND_A, ERRBOUND_C, MAX_PASSES, SPLITTER, UNKNOWN
from .jit_cache import compiled, inlined

MAX_STEPS = 20  # steps of GJK or corners of a walk before it gives up
MAX_TERMS = 12  # floats whose sum is an orientation


@inlined
def relate_few_corners(
    x: Array, y: Array, i0: int, i1: int, p: Array, q: Array, j0: int, j1: int, max_coordinate: float, terms: Array
) -> int:
    """Return the exact relation of corners i0 to i1 - 1 of x, y with corners j0 to j1 - 1 of p, q.

    UNDECIDED where floats go out of range.  `max_coordinate`: the sum of the largest absolute coordinates of both;
    `terms`: scratch.
    """
    side = _classify_edges(x, y, i0, i1, i0, i1, p, q, j0, j1, max_coordinate, terms)
    return _classify_edges(p, q, j0, j1, j0, j1, x, y, i0, i1, max_coordinate, terms) if side == OVERLAPPING else side


@inlined
def relate_many_corners(
    x: Array, y: Array, i0: int, i1: int, p: Array, q: Array, j0: int, j1: int, max_coordinate: float, terms: Array
) -> int:
    """Return the exact relation as `relate_few_corners` does, for many corners: by GJK, then edge by edge.

    The arguments are the same; A has the corners x, y, and B has p, q.
    """
    found, i, j = _gjk(x, y, i0, i1, p, q, j0, j1, max_coordinate)
    if found != UNDECIDED:
        return found
    # the edges at the corners where the search ended tell most touching shapes; then around both
    k, m = j, i
    for first, last in ((0, 2), (2, max(i1 - i0, j1 - j0))):
        for n in range(first, min(last, i1 - i0)):
            end = i + n if i + n < i1 else i + n - (i1 - i0)
            side, k = _classify_edge(x, y, i0, i1, end, p, q, j0, j1, k, max_coordinate, terms)
            if side != OVERLAPPING:
                return side
        for n in range(first, min(last, j1 - j0)):
            end = j + n if j + n < j1 else j + n - (j1 - j0)
            side, m = _classify_edge(p, q, j0, j1, end, x, y, i0, i1, m, max_coordinate, terms)
            if side != OVERLAPPING:
                return side
    return OVERLAPPING


@inlined
def _classify_edges(
    x: Array, y: Array, i0: int, i1: int, first: int, last: int, p: Array, q: Array, j0: int, j1: int,
    max_coordinate: float,
    terms: Array,
) -> int:  # fmt: skip
    """Return the relation proven by the edges of (x, y) that end in corners first to last - 1.

    APART where all corners of (p, q) lie beyond an edge.  Where some lie on the edge's line and none before it, the
    shapes can meet only on that line: TOUCHING if their ranges on the line meet, else APART.  OVERLAPPING if no edge
    clears, which is no proof while other edges remain; UNDECIDED where floats go out of range.  Other arguments as in
    `relate_few_corners`.
    """
    start = first - 1 if first > i0 else i1 - 1
    ex, ey = x[start], y[start]
    for i in range(first, last):
        fx, fy = x[i], y[i]
        nx, ny = fy - ey, ex - fx
        at, error_bound = nx * ex + ny * ey, (abs(nx) + abs(ny)) * max_coordinate * ERROR_FACTOR_F64
        least = np.inf
        for j in range(j0, j1):
            least = min(least, nx * p[j] + ny * q[j])
        if not (error_bound > MIN_ERROR_BOUND and error_bound < MAX_ERROR_BOUND):
            return UNDECIDED
        if least - at > error_bound:
            return APART
        if least - at >= -error_bound:
            low, high, lowest = np.inf, -np.inf, 1
            for j in range(j0, j1):
                if nx * p[j] + ny * q[j] - at <= error_bound:
                    sign = orient(fx, fy, ex, ey, p[j], q[j], terms)
                    lowest = min(lowest, sign)
                    if sign == 0:
                        on = q[j] if ex == fx else p[j]
                        low, high = min(low, on), max(high, on)
            if lowest == UNKNOWN:
                return UNDECIDED
            if lowest >= 0:
                return TOUCHING if lowest == 0 and _edge_meets_range(ex, ey, fx, fy, low, high) else APART
        ex, ey = fx, fy
    return OVERLAPPING


@compiled
def _classify_edge(
    x: Array, y: Array, i0: int, i1: int, end: int, p: Array, q: Array, j0: int, j1: int, k: int, max_coordinate: float,
    terms: Array,
) -> tuple[int, int]:  # fmt: skip
    """Return (relation proven by the edge that ends in corner `end`, a corner of (p, q) low along its normal).

    A walk down (p, q) from its corner k soon finds a corner that lies before the edge, which refutes it.  The walk
    proves nothing else, since rounding can stop it: if it finds no such corner, all corners are evaluated.  Relations
    and other arguments as in `_classify_edges`.
    """
    start = end - 1 if end > i0 else i1 - 1
    nx, ny = y[end] - y[start], x[start] - x[end]
    error_bound = (abs(nx) + abs(ny)) * max_coordinate * ERROR_FACTOR_F64
    k = _walk_down(p, q, j0, j1, k, nx, ny)
    if (
        nx * p[k] + ny * q[k] - (nx * x[end] + ny * y[end]) < -error_bound
        and error_bound > MIN_ERROR_BOUND
        and error_bound < MAX_ERROR_BOUND
    ):
        return OVERLAPPING, k
    return _classify_edges(x, y, i0, i1, end, end + 1, p, q, j0, j1, max_coordinate, terms), k


@compiled
def _edge_meets_range(ex: float, ey: float, fx: float, fy: float, low: float, high: float) -> bool:
    """Return whether edge e-f meets the range low to high on its line; low, high: x (y if the edge is vertical)."""
    e, f = (ey, fy) if ex == fx else (ex, fx)
    return low <= max(e, f) and high >= min(e, f)


@inlined
def _walk_down_onward(x: Array, y: Array, i0: int, i1: int, k: int, dx: float, dy: float) -> int:
    """Return the index of the corner reached from corner k by walking forward while dx*x + dy*y falls."""
    for _ in range(i0, i1):
        i = k + 1 if k + 1 < i1 else i0
        if dx * (x[i] - x[k]) + dy * (y[i] - y[k]) >= 0:
            break
        k = i
    return k


@inlined
def _walk_down(x: Array, y: Array, i0: int, i1: int, k: int, dx: float, dy: float) -> int:
    """Return the index of the corner reached from corner k, forward or else backward, while dx*x + dy*y falls."""
    end = _walk_down_onward(x, y, i0, i1, k, dx, dy)
    if end == k:
        for _ in range(i0, i1):
            i = k - 1 if k > i0 else i1 - 1
            if dx * (x[i] - x[k]) + dy * (y[i] - y[k]) >= 0:
                break
            k = i
        end = k
    return end


@inlined
def _lowest_corner(x: Array, y: Array, i0: int, i1: int, dx: float, dy: float) -> int:
    """Return the index of the corner with the least dx*x + dy*y; evaluating all without a branch beats walking."""
    k, least = 0, np.inf
    for n in range(i1 - i0):
        i = np.uintp(i0 + n)  # unsigned: numba need not ask whether it counts from the end
        value = dx * x[i] + dy * y[i]
        k = n if value < least else k
        least = value if value < least else least
    return i0 + k


@compiled
def _gjk(
    x: Array, y: Array, i0: int, i1: int, p: Array, q: Array, j0: int, j1: int, max_coordinate: float
) -> tuple[int, int, int]:
    """Return (the relation, i, j): APART or OVERLAPPING if a few steps of GJK prove it, else UNDECIDED.

    i and j are the corners of A and B, as indices into x and p, at which the search ended.  A has the corners i0 to
    i1 of x, y; B has j0 to j1 of p, q.  `max_coordinate` gives the error bound.

    The differences of B's corners and A's span a polygon, which contains the origin if the shapes overlap.  If its
    lowest corner along an axis is above zero, the shapes are apart.  If a triangle of its corners contains the
    origin, the shapes share a point (Gilbert, Johnson and Keerthi 1988).
    """
    i, j = (i0 + i1) // 2, (j0 + j1) // 2
    dx, dy = (p[j0] - x[i0]) + (p[j] - x[i]), (q[j0] - y[i0]) + (q[j] - y[i])
    ux = uy = vx = vy = 0.0
    for step in range(MAX_STEPS):
        i, j = _lowest_corner(x, y, i0, i1, -dx, -dy), _lowest_corner(p, q, j0, j1, dx, dy)
        wx, wy = p[j] - x[i], q[j] - y[i]
        error_bound = (abs(dx) + abs(dy)) * max_coordinate * ERROR_FACTOR_F64
        at = dx * wx + dy * wy
        if not (error_bound > MIN_ERROR_BOUND and error_bound < MAX_ERROR_BOUND) or abs(at) <= error_bound:
            return UNDECIDED, i, j
        if at > error_bound:
            return APART, i, j
        if step == 0:
            ux, uy, dx, dy = wx, wy, wx, wy
            continue
        if step == 1:
            vx, vy = wx, wy
        else:
            one, other = _certified_cross(vx, vy, wx, wy), _certified_cross(wx, wy, ux, uy)
            if one > 0 and other > 0:
                return OVERLAPPING, i, j
            if one < 0:
                ux, uy = wx, wy
            elif other < 0:
                vx, vy = wx, wy
            else:
                return UNDECIDED, i, j
        side = _certified_cross(ux, uy, vx, vy)
        if side < 0:
            ux, uy, vx, vy = vx, vy, ux, uy
        elif not side > 0:
            return UNDECIDED, i, j
        # the origin lies left of the line from u to v: search next for the lowest corner along its left normal
        dx, dy = vy - uy, ux - vx
    return UNDECIDED, i, j


@inlined
def is_certainly_inside(x: Array, y: Array, i0: int, i1: int, px: float, py: float, max_coordinate: float) -> bool:
    """Return whether point p is certainly inside the outline; False out of the range of the error bound.

    `max_coordinate`: at least the sum of the largest absolute coordinates of the outline and of p.
    """
    error_bound, left = max_coordinate * ERROR_FACTOR_F64, 0
    for n in range(i1 - i0 - 1):
        i = np.uintp(i0 + n)
        j = i + np.uintp(1)
        left += _is_certainly_left(x[i], y[i], x[j], y[j], px, py, error_bound)
    return (
        left == i1 - i0 - 1
        and _is_certainly_left(x[i1 - 1], y[i1 - 1], x[i0], y[i0], px, py, error_bound)
        and max_coordinate * max_coordinate < MAX_SAFE_PRODUCT
    )


@inlined
def _is_certainly_left(ex: float, ey: float, fx: float, fy: float, px: float, py: float, error_bound: float) -> bool:
    """Return whether p is certainly left of the line from e to f.

    error_bound: that of the orientation determinant in `relate`, divided by |fx - ex| + |fy - ey|.
    """
    dx, dy = fx - ex, fy - ey
    return dx * (py - ey) - dy * (px - ex) > (abs(dx) + abs(dy)) * error_bound + MIN_SAFE_PRODUCT


@compiled
def _certified_cross(ux: float, uy: float, vx: float, vy: float) -> float:
    """Return the cross product of u and v, or 0 where rounding may hide its sign."""
    left, right = ux * vy, uy * vx
    size = abs(left) + abs(right)
    return left - right if abs(left - right) > ERRBOUND_A * size and size > MIN_SAFE_PRODUCT else 0.0


@compiled
def orient(px: float, py: float, qx: float, qy: float, rx: float, ry: float, terms: Array) -> int:
    """Return the exact orientation of p, q, r: 1 left turn, -1 right turn, 0 collinear; UNKNOWN out of range.

    `terms`: scratch, which is overwritten.
    """
    left, right = (qx - px) * (ry - py), (qy - py) * (rx - px)
    size = abs(left) + abs(right)
    if abs(left - right) > ERRBOUND_A * size and size > MIN_SAFE_PRODUCT and size < MAX_SAFE_PRODUCT:
        return 1 if left > right else -1
    if (rx == px and ry == py) or (rx == qx and ry == qy):
        return 0
    a, b, c, d = qx - px, ry - py, qy - py, rx - px
    ea, eb, ec, ed = (
        _two_diff_tail(qx, px, a),
        _two_diff_tail(ry, py, b),
        _two_diff_tail(qy, py, c),
        _two_diff_tail(rx, px, d),
    )
    if size > MIN_SAFE_PRODUCT and size < MAX_SAFE_PRODUCT:
        # with the errors of the differences and products; error bound as in exact_signs._orient_adaptive
        (e, left), (f, right) = two_product(a, b), two_product(c, d)
        orientation = (left - right) + ((e - f) + ((a * eb + ea * b) - (c * ed + ec * d)))
        if abs(orientation) > ERRBOUND_C * size:
            return 1 if orientation > 0 else -1
    # a product that overflows leaves an infinity among the terms, and then the sum has no certified sign
    if ea == 0 and eb == 0 and ec == 0 and ed == 0 and _is_product_exact(a, b) and _is_product_exact(c, d):
        terms[0], terms[2] = two_product(a, b)
        terms[1], terms[3] = two_product(-c, d)
        return sign_of_sum(terms, 4)
    for i, (a, b) in enumerate(((px, qy), (-py, qx), (qx, ry), (-qy, rx), (rx, py), (-ry, px))):
        if not _is_product_exact(a, b):
            return UNKNOWN
        terms[i], terms[6 + i] = two_product(a, b)
    return sign_of_sum(terms, MAX_TERMS)


@compiled
def _two_diff_tail(a: float, b: float, difference: float) -> float:
    """Return the rounding error of `difference` = a - b; difference plus error is exact."""
    part = a - difference
    return (a - (difference + part)) + (part - b)


@compiled
def _is_product_exact(a: float, b: float) -> bool:
    """Return whether two floats can hold a * b exactly: it is 0 or not too small."""
    return abs(a * b) >= MIN_SAFE_PRODUCT or a == 0 or b == 0


@compiled
def two_product(a: float, b: float) -> tuple[float, float]:
    """Return (rounding error, rounded product) of a * b; their sum is exact (Dekker 1971)."""
    product = a * b
    (a1, a0), (b1, b0) = _split(a), _split(b)
    return ((a1 * b1 - product) + a0 * b1 + a1 * b0) + a0 * b0, product


@compiled
def _split(a: float) -> tuple[float, float]:
    """Return (high, low), floats with half the bits of a each, whose sum is a exactly (Veltkamp)."""
    high = a * SPLITTER
    high -= high - a
    return high, a - high


@compiled
def sign_of_sum(terms: Array, count: int) -> int:
    """Return the exact sign of the sum of the first `count` terms, UNKNOWN after too many passes; overwrites them."""
    last = count - 1
    for _ in range(MAX_PASSES):
        rest = 0.0
        for i in range(last):
            rest += abs(terms[i])
        rest *= 1 + 2.0**-40
        if abs(terms[last]) > rest:
            return 1 if terms[last] > 0 else -1
        if rest == 0:
            return 0
        for i in range(1, count):  # two_sum: the rounded sum into the one, what was rounded off into the other
            total = terms[i] + terms[i - 1]
            part = total - terms[i]
            terms[i - 1] = (terms[i] - (total - part)) + (terms[i - 1] - part)
            terms[i] = total
    return UNKNOWN
