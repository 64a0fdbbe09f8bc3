"""The arithmetic of `rounding.py` for many pairs: arrays of floats with the error of each operation."""

from collections.abc import Sequence
from functools import reduce
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..batch.exact_signs import two_product, two_sum
from .rounding import FLOAT32, FloatFormat, Point

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]


class Errors:
    """Compute with float64 arrays, (n,) or (corners, n), for n pairs; `exact` is False where a number is not held.

    It finds what `rounding.ExactArithmetic` finds, pair by pair.  A number that float64 does not hold is not held by
    float32 either.  Values of pairs that are not exact are meaningless.
    """

    def __init__(self, form: FloatFormat, pairs: int) -> None:
        self.form = form
        self.exact: Flags = np.ones(pairs, bool)

    def held(self, value: Array) -> Array:
        """Return the value unchanged; clear `exact` where the format does not hold it."""
        return self._held(value, np.ones(value.shape, bool))

    def _held(self, value: Array, exact: Flags) -> Array:
        """Return the value unchanged; clear `self.exact` where `exact` is False or the format does not hold it."""
        good = exact & np.isfinite(value)
        if self.form is FLOAT32:
            good &= value.astype(np.float32) == value
        self.exact &= good if good.ndim == 1 else good.all(axis=0)
        return value

    def product(self, a: Array, b: Array) -> Array:
        """Return a * b; clear `exact` where it is rounded. Scaling keeps the error term from underflow."""
        (a, i), (b, j) = np.frexp(a), np.frexp(b)
        value, error = _product(a, b)
        return self._scaled(value, i + j, error == 0)

    def root(self, a: Array) -> Array:
        """Return the square root of a; clear `exact` where it is rounded."""
        value = np.sqrt(a)
        mantissa, power = np.frexp(value)
        square, error = _product(mantissa, mantissa)
        return self._held(value, (error == 0) & (np.ldexp(square, 2 * power) == a))

    def _scaled(self, value: Array, power: NDArray[Any], exact: Flags) -> Array:
        """Return value * 2**power; clear `self.exact` where `exact` is False or the result is rounded."""
        result = np.ldexp(value, power)
        return self._held(result, exact & (np.ldexp(result, -power) == value))

    def total(self, *terms: Array) -> Array:
        """Return the sum of the terms; record for which pairs it is exact."""
        self.compared(*terms)
        return self._held(*_sum(terms))

    def compared(self, *terms: Array) -> None:
        """Record whether the partial sums are held, except those that leave out only zeros and so equal the sum."""
        for many in range(2, len(terms)):
            for some in combinations(range(len(terms)), many):
                value, exact = _sum([terms[i] for i in some])
                last = reduce(np.logical_and, [terms[i] == 0 for i in range(len(terms)) if i not in some])
                self._held(np.where(last, 0.0, value), exact | last)

    def operands(self, ring: Sequence[Point[Array]]) -> Sequence[Point[Array]]:
        """Return all corners as one operand of (corners, n) arrays."""
        return [(np.stack([x for x, _ in ring]), np.stack([y for _, y in ring]))]


def _product(a: Array, b: Array) -> tuple[Array, Array]:
    """Return (a * b rounded, rounding error)."""
    a, b = np.broadcast_arrays(a, b)
    error, product = np.empty_like(a), np.empty_like(a)
    two_product(a, b, error, product)
    return product, error


def _sum(terms: Sequence[Array]) -> tuple[Array, Flags]:
    """Return (sum of the terms, mask of the pairs for which no addition rounds).

    The mask is that of adding in the given order; where the format holds all partial sums, it is that of every order.
    """
    total, exact = terms[0], np.bool_(True)
    for term in terms[1:]:
        total, error = two_sum(total, term)
        exact = exact & (error == 0)
    return total, np.asarray(exact)
