"""A sweep of a vertical line over an outline: which edges lie directly below and above each vertex.

Source: Shamos and Hoey (1976).  Points are compared by x and then by y, as if the outline
were rotated by a tiny angle, so that no two vertices lie on one vertical line.
"""

from bisect import bisect_left
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from .geometry import Vec, cyclic_pairs
from .predicates import orient


class Event(NamedTuple):
    """The event of the sweep line reaching one vertex, with the edges there; edge i goes from vertex i to the next."""

    vertex: int
    ended: list[int]  # the vertex's edges that lie to its left, from below upwards
    begun: list[int]  # those that lie to its right
    below: int | None  # the edge directly below the vertex
    above: int | None
    touched: int | None  # an edge between other vertices that contains the vertex


def sweep(ring: Sequence[Vec]) -> Iterator[Event]:
    """Yield an Event for each vertex from left to right; correct up to the first place where edges meet.

    A vertex finds its place among the edges with log2(n) orientation tests.
    """
    edges = [(min(p, q), max(p, q)) for p, q in cyclic_pairs(ring)]
    active: list[int] = []  # the edges that the line crosses, from below upwards
    order = sorted(range(len(ring)), key=ring.__getitem__)
    for before, i in zip([None, *order], order):
        here = ring[i]
        own = [(i - 1) % len(ring), i]
        ends = [e for e in own if edges[e][1] == here]
        begun = [e for e in own if edges[e][0] == here]
        if len(begun) == 2 and orient(here, edges[begun[0]][1], edges[begun[1]][1]) < 0:
            begun.reverse()
        first = bisect_left(active, 0, key=lambda e: -orient(*edges[e], here))
        last = first + len(ends)
        through = (e for e in active[first : last + 1] if e not in ends and orient(*edges[e], here) == 0)
        touched = before if before is not None and ring[before] == here else next(through, None)
        below = active[first - 1] if first else None
        above = active[last] if last < len(active) else None
        ended, active[first:last] = active[first:last], begun
        yield Event(i, ended, begun, below, above, touched)
