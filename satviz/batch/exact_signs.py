"""Exact signs for arrays: a float filter, then sums of floats whose errors are kept, then integers.

A product of two floats is the sum of two floats exactly (Dekker 1971), so a sum of
products is a sum of floats; adding them while keeping each rounding (Knuth's
two-sum, passed over the terms as in Ogita, Rump and Oishi 2005) brings the sign out.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ..engine.predicates import MAX_SAFE_PRODUCT, MIN_SAFE_PRODUCT, sign, to_integers
from .array_types import Array, Signs

Products = Sequence[tuple[Array, Array]]  # the two factors of each

UNKNOWN = -2  # below every sign: the least of several signs is known when all are
ERRBOUND_A = 2.0**-50  # eight roundings
ERRBOUND_B = 2.0**-98  # 256 roundings of roundings
ERRBOUND_C = 2.0**-101  # 32 of them
SPLITTER = 2.0**27 + 1
MAX_PASSES = 12
MIN_BLOCK_PAIRS = (
    128  # pairs side by side at least, however many corners they have: of fewer, Python would take the most time
)
MAX_BLOCK_CORNERS = 1 << 19  # side by side at most: what bounds the memory


def pairs_per_block(corners: int, at_once: int = MAX_BLOCK_CORNERS) -> int:
    """Return how many pairs of `corners` corners to evaluate at a time: `at_once` corners in all; bounds the memory."""
    return max(MIN_BLOCK_PAIRS, at_once // corners)


def orient(px: Array, py: Array, qx: Array, qy: Array, rx: Array, ry: Array) -> Signs:
    """Return the exact orientation of p, q, r for arrays of one length: 1 left turn, -1 right turn, 0 collinear."""
    with np.errstate(all="ignore"):
        left = (qx - px) * (ry - py)
        right = (qy - py) * (rx - px)
        det, error_bound = left - right, np.abs(left) + np.abs(right)
        certified = (
            (np.abs(det) > ERRBOUND_A * error_bound)
            & (error_bound > MIN_SAFE_PRODUCT)
            & (error_bound < MAX_SAFE_PRODUCT)
        )
    found = np.sign(det, where=certified, out=np.zeros_like(det)).astype(np.int8)
    rest = np.flatnonzero(~certified)
    if rest.size:
        found[rest] = _orient_adaptive(*(c[rest] for c in (px, py, qx, qy, rx, ry)))
    return found


def _orient_adaptive(px: Array, py: Array, qx: Array, qy: Array, rx: Array, ry: Array) -> Signs:
    """Return the exact orientations of p, q, r: by products with their rounding errors, else by exact sums.

    A difference is a + ea with ea at most u a (u = 2**-53), and the same for b, c and d; with S = |ab| + |cd|, the
    orientation determinant is ab - cd, whose rounded products differ by so little here that their difference is exact,
    and the errors of both (u S in all), and a eb + ea b - c ed - ec d (2u S).  Left out are ea eb and ec ed, at most uu
    S; adding up what is of the size u S rounds by 10 uu S at most, and the last sum by a share of itself.  Granted are
    32 uu S.
    """
    with np.errstate(all="ignore"):
        (a, ea), (b, eb), (c, ec), (d, ed) = (two_sum(u, -v) for u, v in ((qx, px), (ry, py), (qy, py), (rx, px)))
        terms, size = _expand_products([(a, b), (-c, d)])
        orientation = terms[0] + terms[1]
        orientation += (a * eb + ea * b) - (c * ed + ec * d)
        orientation += terms[2] + terms[3]
        found = certified_sign(orientation, ERRBOUND_C * size)
    plain = (ea == 0) & (eb == 0) & (ec == 0) & (ed == 0)
    for mask, pairs in (
        (plain, [(a, b), (-c, d)]),
        (~plain, [(px, qy), (-py, qx), (qx, ry), (-qy, rx), (rx, py), (-ry, px)]),
    ):
        which = np.flatnonzero(mask & (found == 0))
        if which.size:
            found[which] = sign_of_products([(u[which], v[which]) for u, v in pairs])
    return found


def circle_gap_signs(ax: Array, ay: Array, ar: Array, bx: Array, by: Array, br: Array) -> Signs:
    """Return the exact sign of (distance minus sum of radii) for each pair of circles."""
    pairs = []
    for p, q in ((ax, bx), (ay, by)):
        pairs += [(p, p), (q, q), (-p, q), (-p, q)]  # twice, as doubling could overflow
    pairs += [(-ar, ar), (-br, br), (-ar, br), (-ar, br)]
    return sign_of_products(pairs)


def sign_of_products(pairs: Products) -> Signs:
    """Return the exact sign of each column's sum of products u * v, for the factor arrays (u, v) in `pairs`."""
    with np.errstate(all="ignore"):
        terms, size = _expand_products(pairs)
        found = np.full(len(size), UNKNOWN, np.int8)
        calm = np.flatnonzero(size < np.inf)
        found[calm] = sign_of_sum(take_columns(terms, calm))
    for i in np.flatnonzero(found == UNKNOWN):
        _, n = to_integers(f[i] for pair in pairs for f in pair)
        found[i] = sign(sum(p * q for p, q in zip(n[::2], n[1::2], strict=True)))
    return found


def sum_with_error(pairs: Products, remainder: Array) -> tuple[Array, Array, Array]:
    """Return (float sum of up to three products and `remainder`, its error bound, floats that sum to the products).

    All are arrays with one entry, or column, for each sum; the floats are rows as in `_expand_products`.
    With products of size R in all, u = 2**-53 and `remainder` at most 3uR: the errors of the products
    and of their sums are 3uR in all, and adding all this up rounds five times, by 30uuR.
    The bound is 256uuR, so it also covers an error of 226uuR in `remainder` itself.
    """
    terms, size = _expand_products(pairs)
    _vec_sum(terms[len(pairs) :])
    rest = terms[:-1].sum(axis=0)
    rest += remainder
    rest += terms[-1]
    size *= ERRBOUND_B
    return rest, size, terms


def _expand_products(pairs: Products) -> tuple[Array, Array]:
    """Return (floats that sum exactly to the k products, sum of |products|, which is inf where bits are lost).

    The floats are (2k, n): the k rounding errors, then the k rounded products.  The error of a product above
    MIN_SAFE_PRODUCT, and the parts it is made of, are multiples of 1e-312: floats.
    """
    k = len(pairs)
    terms = np.empty((2 * k, len(pairs[0][0])))
    for i, (a, b) in enumerate(pairs):
        two_product(a, b, terms[i], terms[k + i])
    sizes = np.abs(terms[k:])
    size = sizes.sum(axis=0)
    lost = ~(size < MAX_SAFE_PRODUCT)
    small = sizes < MIN_SAFE_PRODUCT
    if small.any():
        for is_small, (a, b) in zip(small, pairs, strict=True):
            lost |= is_small & (a != 0) & (b != 0)
    size[lost] = np.inf
    return terms, size


def two_product(a: Array, b: Array, error: Array, product: Array) -> None:
    """Write a * b into `product`, rounded, and its rounding error into `error` (Dekker 1971)."""
    np.multiply(a, b, out=product)
    a1, a0 = _split(a)
    b1, b0 = (a1, a0) if b is a else _split(b)
    np.multiply(a1, b1, out=error)
    error -= product
    for p, q in ((a0, b1), (a1, b0), (a0, b0)):
        error += p * q


def _split(a: Array) -> tuple[Array, Array]:
    """Return (high, low), floats with half the bits of a each, whose sum is a exactly (Veltkamp)."""
    high = a * SPLITTER
    high -= high - a
    return high, a - high


def two_sum(a: Array, b: Array) -> tuple[Array, Array]:
    """Return a + b as (rounded sum, its rounding error), whose sum is exact (Knuth)."""
    total = a + b
    part = total - a
    error = b - part
    np.subtract(total, part, out=part)
    np.subtract(a, part, out=part)
    error += part
    return total, error


def _vec_sum(terms: Array) -> None:
    """Replace, in place, the last row by the rounded sum of each column and the other rows by rounding errors."""
    for i in range(1, len(terms)):
        terms[i], terms[i - 1] = two_sum(terms[i], terms[i - 1])


def take_columns(terms: Array, where: NDArray[np.intp]) -> Array:
    """Return the columns of `terms` at the indices `where`, which must ascend; if these are all, `terms` itself.

    Indices are not checked (mode "clip"), since NumPy's check doubles the time.
    """
    return terms if len(where) == terms.shape[1] else terms.take(where, axis=1, mode="clip")


def certified_sign(values: Array, error_bound: Array | float) -> Signs:
    """Return an array: 1 where a value is above its error bound, -1 where below the negative bound, else 0."""
    return (values > error_bound).view(np.int8) - (values < -error_bound).view(np.int8)


def sign_of_sum(terms: Array) -> Signs:
    """Return the exact sign of each column's sum of (k, n) `terms`, UNKNOWN after too many passes; overwrites them."""
    found = np.full(terms.shape[1], UNKNOWN, np.int8)
    left = np.arange(len(found))
    for _ in range(MAX_PASSES):
        rest = np.abs(terms[:-1]).sum(axis=0)
        rest *= 1 + 2.0**-40
        signs = certified_sign(terms[-1], rest)
        done = (signs != 0) | (rest == 0)
        found[left] = np.where(done, signs, UNKNOWN)
        more = np.flatnonzero(~done)
        if not more.size:
            break
        left, terms = left[more], take_columns(terms, more)
        _vec_sum(terms)
    return found
