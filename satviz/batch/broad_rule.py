"""Which broad phase is chosen: by the number of boxes and a count of comparisons, never by a time.

Up to MAX_ALL_PAIRS boxes are compared all with all.  Up to MAX_SWEEP boxes are sorted along one axis and swept,
if that makes at most MAX_SWEEP_COMPARISONS comparisons a box.  All others are put into the cells of a grid, or of
several grids where sizes differ much.  So the same boxes always take the same way, with both engines.
"""

ALL_PAIRS, SWEEP, GRID = range(3)
NAMES = "all pairs", "sort and sweep", "grid"

MAX_ALL_PAIRS = 48  # boxes; above it sorting costs less than it saves
MAX_SWEEP = 512  # boxes; above it too many overlap along one axis
MAX_SWEEP_COMPARISONS = 24  # per box; above it a grid is faster
MAX_CANDIDATES_PER_BOX = 48  # in one grid; above it grids for each size are faster
