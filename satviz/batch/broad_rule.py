"""Which broad phase is chosen: by the number of boxes and a count of comparisons, never by a time.

Up to MAX_ALL_PAIRS boxes are compared all with all.  Up to MAX_SWEEP_NUMBA or MAX_SWEEP_NUMPY boxes are sorted along
one axis and swept, if that makes at most MAX_SWEEP_COMPARISONS comparisons a box.  All others are put into the cells
of a grid, or of several grids where sizes differ much.  So the same boxes always take the same way with an engine.
"""

ALL_PAIRS, SWEEP, GRID = range(3)
NAMES = "all pairs", "sort and sweep", "grid"

MAX_ALL_PAIRS = 48  # boxes; above it sorting costs less than it saves
MAX_SWEEP_NUMBA, MAX_SWEEP_NUMPY = 512, 4096  # boxes; above it grids are faster however boxes lie
MAX_SWEEP_COMPARISONS = 20  # per box; above it a grid is faster
MAX_CANDIDATES_PER_BOX = 48  # in one grid; above it grids for each size are faster
