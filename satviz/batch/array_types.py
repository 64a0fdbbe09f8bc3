"""The types of the arrays that batches work on; n is a number of pairs, N of shapes, M of corners."""

from collections.abc import Callable, Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Complexes = NDArray[np.complex128]
Signs = NDArray[np.int8]  # 1, 0, -1, or UNKNOWN
Relations = NDArray[np.int8]  # APART, TOUCHING, OVERLAPPING or UNDECIDED, as in codes.py
Indices = NDArray[np.intp]
Mask = NDArray[np.bool_]

Pairs = NDArray[np.intp]  # (K, 2) indices of two shapes each
CellSize = Sequence[float]  # width and height of a cell
# (bounds (N, 4), indices of boxes, indices of others or None, cell, most candidates) -> blocks of the pairs that meet
GridKernel = Callable[[Array, Indices, Indices | None, CellSize, float], Iterator[Pairs] | None]
