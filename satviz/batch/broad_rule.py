"""The rule that chooses the broad phase: by the number of boxes and by counting comparisons, never by a time.

Up to MAX_ALL_PAIRS boxes are compared all with all.  Up to MAX_SWEEP_NUMBA or MAX_SWEEP_NUMPY
boxes are sorted along one axis and swept; with NumPy only if that makes at most MAX_SWEEP_COMPARISONS comparisons a
box.  The axis is that on which boxes are spread more widely in units of the largest box, or the other one if the first
makes more comparisons than that and the other fewer.  More boxes are put into a grid, whose cells are at least as large
as the largest box in it.  Sizes that differ much fill such cells with too many boxes: where one grid would compare more
than MAX_CANDIDATES_PER_BOX boxes with each, numba sweeps up to 2**14 boxes if that makes at most MAX_SWEEP_COMPARISONS
a box.  Else a few boxes that are far larger than the others or far from them are compared with all, and the others are
split by size, into a grid for each size.  So the same boxes always take the same way with an engine.
"""

ALL_PAIRS, SWEEP, GRID = range(3)
NAMES = "all pairs", "sort and sweep", "grid"

MAX_ALL_PAIRS = 128  # boxes; above it sorting costs less than it saves
MAX_SWEEP_NUMBA, MAX_SWEEP_NUMPY = 512, 4096  # boxes; above it a grid is faster where sizes are alike
MAX_SWEEP_COMPARISONS = 160  # per box; above it several grids are faster
MAX_CANDIDATES_PER_BOX = 48  # candidates per box in one grid; above this a sweep, or a grid for each size, is faster
