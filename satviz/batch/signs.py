"""Exact signs for arrays: a float filter, then sums of floats whose errors are kept, then integers.

A product of two floats is the sum of two floats exactly (Dekker 1971), so a sum of
products is a sum of floats; adding them while keeping each rounding (Knuth's
two-sum, passed over the terms as in Ogita, Rump and Oishi 2005) brings the sign out.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ..exact import HUGE, TINY, sign, to_integers

Array = NDArray[np.float64]
Signs = NDArray[np.int8]

# Nonzero coordinates in this range are multiples of 1e-116, so products and their
# errors are multiples of 1e-232: nothing is lost to underflow, nor does anything overflow.
TAME = 1e-100, 1e100
ROUND = 2.0**-50  # eight roundings
SPLIT = 2.0**27 + 1
MOST_PASSES = 12


def orient(px: Array, py: Array, qx: Array, qy: Array, rx: Array, ry: Array) -> Signs:
    """The exact turns from p over q to r: 1 left, -1 right, 0 straight; arrays of one length."""
    with np.errstate(all="ignore"):
        left = (qx - px) * (ry - py)
        right = (qy - py) * (rx - px)
        det, room = left - right, np.abs(left) + np.abs(right)
        sure = (np.abs(det) > ROUND * room) & (room > TINY) & (room < HUGE)
    found = np.sign(det, where=sure, out=np.zeros_like(det)).astype(np.int8)
    rest = np.flatnonzero(~sure)
    if rest.size:
        points = [np.ascontiguousarray(np.broadcast_to(c, det.shape)[rest]) for c in (px, py, qx, qy, rx, ry)]
        found[rest] = _turns(*points)
    return found


def _turns(px: Array, py: Array, qx: Array, qy: Array, rx: Array, ry: Array) -> Signs:
    pairs = [(px, qy), (-py, qx), (qx, ry), (-qy, rx), (rx, py), (-ry, px)]
    return _sign_of_products(pairs)


def circles(ax: Array, ay: Array, ar: Array, bx: Array, by: Array, br: Array) -> Signs:
    """The exact sign of distance minus sum of radii for each pair of circles."""
    pairs = []
    for p, q in ((ax, bx), (ay, by)):
        pairs += [(p, p), (q, q), (-p, q), (-p, q)]  # twice, as doubling could overflow
    pairs += [(-ar, ar), (-br, br), (-ar, br), (-ar, br)]
    return _sign_of_products(pairs)


def _sign_of_products(pairs: Sequence[tuple[Array, Array]]) -> Signs:
    """The exact signs of the sums of the products, column by column."""
    flat = np.stack([f for pair in pairs for f in pair])
    sizes = np.abs(flat)
    wild = ~np.all((sizes == 0) | ((sizes > TAME[0]) & (sizes < TAME[1])), axis=0)
    found = np.zeros(flat.shape[1], np.int8)
    calm = np.flatnonzero(~wild)
    if calm.size:
        terms = np.concatenate(
            [np.stack(_two_product(flat[i, calm], flat[i + 1, calm])) for i in range(0, len(flat), 2)]
        )
        found[calm], undecided = _sign_of_sum(terms)
        wild[calm[undecided]] = True
    for i in np.flatnonzero(wild):
        _, n = to_integers(flat[:, i].tolist())
        found[i] = sign(sum(p * q for p, q in zip(n[::2], n[1::2], strict=True)))
    return found


def _two_product(a: Array, b: Array) -> tuple[Array, Array]:
    """a * b as (error, rounded product)."""
    product = a * b
    high = a * SPLIT
    a1 = high - (high - a)
    high = b * SPLIT
    b1 = high - (high - b)
    a0, b0 = a - a1, b - b1
    return a0 * b0 - (((product - a1 * b1) - a0 * b1) - a1 * b0), product


def _sign_of_sum(terms: Array) -> tuple[Signs, NDArray[np.intp]]:
    """Exact signs of the columns' sums, and the columns (if any) that took too many passes."""
    found = np.zeros(terms.shape[1], np.int8)
    columns = np.arange(terms.shape[1])
    for _ in range(MOST_PASSES):
        for i in range(1, len(terms)):
            a, b = terms[i], terms[i - 1]
            total = a + b
            part = total - a
            terms[i - 1] = (a - (total - part)) + (b - part)
            terms[i] = total
        rest = np.abs(terms[:-1]).sum(axis=0)
        top = terms[-1]
        done = (np.abs(top) > rest * (1 + 2.0**-40)) | (rest == 0)
        found[columns[done]] = np.sign(top[done])
        columns, terms = columns[~done], np.ascontiguousarray(terms[:, ~done])
        if not columns.size:
            break
    return found, columns
