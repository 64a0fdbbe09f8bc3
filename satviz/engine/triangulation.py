"""The diagonals of a triangulation, found in one sweep from left to right.

Source: Hertel and Mehlhorn, Fast triangulation of simple polygons (1983).  The work is that
of the sweep and one orientation test or two for each diagonal, whatever the outline.
"""

from collections.abc import Sequence

from .geometry import Vec
from .predicates import orient
from .sweep import sweep

Diagonal = tuple[int, int]
# Between two edges with the inside between them, the vertices met that later ones may still see: from the left end of
# the lower edge to the last vertex met, and from the left end of the upper edge to it.  Both bend towards the right.
Chains = tuple[list[int], list[int]]


def diagonals(ring: Sequence[Vec]) -> list[Diagonal]:
    """Return the n - 3 diagonals that cut a simple outline into triangles, as pairs of vertex numbers.

    Where three vertices lie on one line they may be the corners of a triangle, which has
    no area then; but no diagonal runs through a vertex, and no two cross.
    """
    found: list[Diagonal] = []

    def fan(w: int, chain: list[int]) -> None:
        """Add a diagonal from w to every vertex of the chain but the first, which is its neighbour."""
        found.extend((w, v) for v in chain[1:])

    def grow(w: int, chain: list[int], side: int) -> list[int]:
        """Join w by diagonals with the vertices that it sees from the end of the chain backwards, and append w.

        A vertex is seen while the orientation of w, the chain's last vertex and the one before is `side`: 1 for a
        lower chain, -1 for an upper one.  Vertices that are cut off leave the chain, which is returned.
        """
        while len(chain) > 1 and orient(ring[w], ring[chain[-1]], ring[chain[-2]]) == side:
            chain.pop()
            found.append((w, chain[-1]))
        chain.append(w)
        return chain

    inside: dict[int, Chains] = {}  # keyed by the lower edge
    for w, ended, begun, below, _, _ in sweep(ring):
        if below in inside:
            lower, upper = inside.pop(below)
            if not ended:  # w splits what lies between the two edges
                found.append((w, lower[-1]))
                inside[below] = grow(w, lower, 1), [w]
                inside[begun[1]] = [w], grow(w, upper, -1)
                continue
            fan(w, upper)
            lower, upper = grow(w, lower, 1), [w]
            if not begun:  # w joins it with what lies above
                above_lower, above_upper = inside.pop(ended[1])
                fan(w, above_lower)
                upper = grow(w, above_upper, -1)
            inside[below] = lower, upper
        elif not ended:
            inside[begun[0]] = [w], [w]
        elif begun:
            lower, upper = inside.pop(ended[0])
            fan(w, lower)
            inside[begun[0]] = [w], grow(w, upper, -1)
        else:
            lower, upper = inside.pop(ended[0])
            around = [*lower, *upper[-2::-1]]  # from one neighbour of w to the other
            found.extend((w, v) for v in around[1:-1])
    return found
