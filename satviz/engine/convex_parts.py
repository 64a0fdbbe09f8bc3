"""parts: split a concave polygon into few convex parts that fill it exactly.

Every coordinate is an integer times one power of two, so all of this is done with
integers: each side and length is exact, and collinear vertices, of which drawn
outlines have many, cost no more than others.
"""

from fractions import Fraction
from heapq import nsmallest
from itertools import accumulate, chain
from math import gcd, lcm
from typing import NamedTuple

from . import triangulation
from .geometry import Vec, cyclic_pairs, cyclic_triples
from .predicates import IntPoint, orient_det
from .shapes import Polygon, Shape, require_shape

MAX_PARTNERS = 8  # later reflex vertices that a reflex vertex is paired with, so that a big outline skips most pairs
# reflex vertices of one piece; cutting it takes time proportional to the square of their number
MAX_REFLEX_VERTICES = 100

Ring = list[int]  # the vertex numbers of a piece: counter-clockwise, without collinear vertices
Edge = tuple[int, int]


def parts(shape: Shape) -> tuple[Shape, ...]:
    """Return convex parts with disjoint interiors that fill the shape exactly; a convex shape is its own only part.

    Their vertices are the polygon's own, and points where the line of an edge or cut ends
    on another one (label "" if the polygon has labels).  A polygon with r reflex vertices has at most 2 r + 1
    parts.  They are sorted by their lowest vertex number.
    """
    return (shape,) if require_shape(shape, "shape").is_convex else shape.cached("parts", lambda: _split(shape))


def _split(shape: Shape) -> tuple[Polygon, ...]:
    """Return the convex parts of a concave polygon, sorted by their lowest vertex number."""
    pieces = _Pieces(shape)
    pieces.halve()
    pieces.cut_in_pairs()
    pieces.cut_one_by_one()
    numbers = {p: i for i, p in reversed(list(enumerate(shape.vertices)))}
    found = []
    for ring in pieces.merge():
        places = [(numbers.get(p, len(shape.vertices)), p) for p in map(pieces.points.__getitem__, ring)]
        start = places.index(min(places))
        found.append(places[start:] + places[:start])
    found.sort()
    labels = (*shape.labels, "") if shape.labels else None
    return tuple(
        Polygon([p for _, p in places], [labels[i] for i, _ in places] if labels else None) for places in found
    )


class _LineEnd(NamedTuple):
    """The point where an edge, extended beyond a reflex vertex, meets the ring: inside edge pq, or at vertex q."""

    end: int | None  # its vertex number; None if float64 cannot hold it or it lies on a diagonal of `halve`
    p: int
    q: int


class _Pieces:
    """The pieces of one polygon while it is cut; no cut makes a vertex reflex."""

    def __init__(self, shape: Shape) -> None:
        self.points = list(shape.core)
        self.numbers = {p: v for v, p in enumerate(self.points)}
        k, at, _ = shape.integers
        common = gcd(*(c for p in at for c in p))
        self.unit = Fraction(common, 1 << k)  # the length of 1 in self.at, whose integers have no common factor
        self.at = [(x // common, y // common) for x, y in at]
        self.convex: list[Ring] = []
        # the diagonals of `halve` in both directions; no other cut ends inside one, so that `merge` can remove it
        self.halving: dict[Edge, None] = {}
        ring = list(range(len(at)))
        # the piece in which a vertex is still reflex: at most one, since all its angles add up to less than 360 degrees
        self.home = {v: ring for i, v in enumerate(ring) if _orientation_at(self.at, ring, i) < 0}

    def halve(self) -> None:
        """Cut until no piece has over MAX_REFLEX_VERTICES; an eighth of them or more stays on each side.

        A cut along the line of an edge is preferred.  Otherwise it is a diagonal of a
        triangulation, which `merge` removes again if no vertex needs it.
        """
        todo: list[tuple[Ring, list[Edge]]] = [(next(iter(self.home.values())), [])]
        while todo:
            ring, diagonals = todo.pop()
            sides = _ReflexCount(ring, [self.home.get(v) is ring for v in ring])
            if sides.total <= MAX_REFLEX_VERTICES:
                continue
            best = max(diagonals, key=sides.min_reflex_on_a_side, default=None)
            # the diagonals that remain after cuts along lines may all be near one end of the piece
            if best is None or not sides.balanced(best):
                diagonals = [(ring[i], ring[j]) for i, j in triangulation.diagonals([self.points[v] for v in ring])]
                best = max(diagonals, key=sides.min_reflex_on_a_side)
            cut = self._insert_balanced_cut(ring, best, sides)
            if cut is None:
                cut = best
                self.halving |= {cut: None, cut[::-1]: None}
            for piece in self._cut(ring, *cut):
                held = set(piece)
                todo.append((piece, [d for d in diagonals if d != best and held.issuperset(d)]))

    def _insert_balanced_cut(self, ring: Ring, ends: Edge, sides: "_ReflexCount") -> Edge | None:
        """Return a balanced cut that extends an edge at a vertex of `ends`, its far end inserted into `ring`.

        A cut is balanced if each side keeps an eighth of the ring's reflex vertices.  None if there is no such cut.
        """
        for v in ends:
            for hit in self._extend_both_edges(ring, v) if self.home.get(v) is ring else ():
                if hit.end is not None and sides.balanced((v, hit.q)):
                    _insert_vertex(ring, hit.end, hit.q)
                    return v, hit.end
        return None

    def cut_in_pairs(self) -> None:
        """Cut between two reflex vertices where neither is reflex afterwards, preferring an edge's line."""
        rings = {id(ring): ring for ring in self.home.values()}
        for _, _, u, v in sorted(chain.from_iterable(map(self._pair_cuts, rings.values()))):
            ring = self.home.get(u)
            if ring is not None and ring is self.home.get(v) and self._sees(ring, u, v):
                self._cut(ring, u, v)

    def _pair_cuts(self, ring: Ring) -> list[tuple[bool, int, int, int]]:
        """Return the cuts between two reflex vertices of a ring after which neither is reflex any more.

        Each is (whether it makes a new normal, its squared length, its two ends).  The first MAX_PARTNERS for each
        vertex, in this order, are returned.
        """
        at = self.at
        pairs: list[tuple[bool, int, int, int]] = []
        bends = [(v, at[a], at[v], at[b]) for a, v, b in cyclic_triples(ring) if self.home.get(v) is ring]
        for i, (u, before_u, pu, after_u) in enumerate(bends, 1):
            found = []
            for v, before_v, pv, after_v in bends[i:]:
                # a cut ends a reflex vertex if it goes to the left of both its edges or along one's line
                first, second = orient_det(before_u, pu, pv), orient_det(pu, after_u, pv)
                if first < 0 or second < 0:
                    continue
                third, fourth = orient_det(before_v, pv, pu), orient_det(pv, after_v, pu)
                if third >= 0 and fourth >= 0:
                    new_normal = 0 not in (first, second, third, fourth)
                    found.append((new_normal, _squared_distance(pu, pv), u, v))
            pairs += nsmallest(MAX_PARTNERS, found)
        return pairs

    def cut_one_by_one(self) -> None:
        """Cut at each remaining reflex vertex until it is convex: once where enough, else twice."""
        for v in sorted(self.home):
            while v in self.home:
                self._cut_at(v)

    def merge(self) -> list[Ring]:
        """Remove each cut whose removal leaves no reflex vertex (Hertel and Mehlhorn 1983); return the rings.

        At most two cuts remain for each reflex vertex, those of `halve` included: if it needed a
        third one, its angles would add up to more than 360 degrees.
        """
        after: dict[Edge, Edge] = {}
        before: dict[Edge, Edge] = {}

        def link(first: Edge, second: Edge) -> None:
            """Note that one edge follows another in a piece."""
            after[first], before[second] = second, first

        for ring in self.convex:
            for first, second in cyclic_pairs(list(cyclic_pairs(ring))):
                link(first, second)
        for cut in list(after):
            twin = cut[::-1]
            if cut not in after or twin not in after:
                continue
            joints = (before[cut], after[twin]), (before[twin], after[cut])
            turns = [orient_det(self.at[p], self.at[v], self.at[q]) for (p, v), (_, q) in joints]
            if min(turns) < 0:
                continue
            del after[cut], after[twin]
            for turn, (first, second) in zip(turns, joints, strict=True):
                if turn:
                    link(first, second)
                    continue
                edge = (first[0], second[1])
                link(before[first], edge)
                link(edge, after[second])
                del after[first], after[second]
        rings = []
        while after:
            edge, ring = next(iter(after)), []
            while edge in after:
                ring.append(edge[0])
                edge = after.pop(edge)
            rings.append(ring)
        return rings

    def _cut(self, ring: Ring, u: int, v: int) -> tuple[Ring, Ring]:
        """Cut a ring between two vertices and return both pieces, without an end of the cut that became collinear."""
        i, j = sorted((ring.index(u), ring.index(v)))
        for end in (u, v):
            if self.home.get(end) is ring:  # it may be reflex still in the piece beyond an earlier cut
                del self.home[end]
        found = []
        for piece in (ring[i : j + 1], ring[j:] + ring[: i + 1]):
            bends = {piece[0]: _orientation_at(self.at, piece, 0), piece[-1]: _orientation_at(self.at, piece, -1)}
            reflex = [w for w in piece if self.home.get(w) is ring or bends.get(w, 0) < 0]
            found.append(([w for w in piece if bends.get(w, 1)], reflex))
        for piece, reflex in found:
            self.home.update(dict.fromkeys(reflex, piece))
            if not reflex:
                self.convex.append(piece)
        return found[0][0], found[1][0]

    def _cut_at(self, v: int) -> None:
        """Cut the piece at its reflex vertex v, by the shortest of a few cuts that are easy to find."""
        ring = self.home[v]
        hits = ahead, back = self._extend_both_edges(ring, v)
        # A cut along an edge's own line comes first: it gives the parts no new normal, so no new axis to test.
        ends = [hit.end for hit in hits if hit.end is not None]
        if not ends:
            # A cut to a vertex between the two lines ends v too, if v sees one.  If not, both lines end on one
            # edge, and these two cuts go to either side of them: after the first, the second is between the lines.
            a, b = _neighbours(ring, v)
            ends = [self._first_beside(ring, a, v, ahead, True), self._first_beside(ring, b, v, back, False)]
        end = min(ends, key=lambda w: _squared_distance(self.at[v], self.at[w]))
        for hit in hits:
            if end == hit.end:
                _insert_vertex(ring, end, hit.q)
        self._cut(ring, v, end)

    def _extend_both_edges(self, ring: Ring, v: int) -> tuple[_LineEnd, _LineEnd]:
        """Return, for each of the two edges at v, where it meets the ring when extended beyond v."""
        a, b = _neighbours(ring, v)
        return self._extend_edge(ring, a, v), self._extend_edge(ring, b, v)

    def _sees(self, ring: Ring, u: int, v: int) -> bool:
        """Return whether a cut from u to v, which starts and ends inside the piece, meets the ring nowhere between."""
        at = self.at
        (ux, uy), (vx, vy) = pu, pv = at[u], at[v]
        dx, dy = vx - ux, vy - uy
        square = dx * dx + dy * dy
        p, before = pu, 0
        for w in (ring[-1], *ring):
            q = at[w]
            x, y = q[0] - ux, q[1] - uy
            side = dx * y - dy * x
            if side == 0:
                if 0 < dx * x + dy * y < square:
                    return False
            # where the cut leaves the piece, the ring runs from right to left
            elif before < 0 < side and orient_det(p, q, pu) > 0 > orient_det(p, q, pv):
                return False
            p, before = q, side
        return True

    def _extend_edge(self, ring: Ring, a: int, v: int) -> _LineEnd:
        """Return the _LineEnd where the edge from a to the reflex vertex v, extended beyond v, first meets the ring."""
        at = self.at
        (ax, ay), (vx, vy) = at[a], at[v]
        dx, dy = vx - ax, vy - ay
        on_line = dx * vy - dy * vx
        p = ring[-1]
        px, py = at[p]
        best, num, den = (p, p, 0), 1, 0  # the hit is at v + num/den * (dx, dy)
        before = dx * py - dy * px - on_line
        for q in ring:
            qx, qy = at[q]
            side = dx * qy - dy * qx - on_line
            if side == 0:
                s, t = dx * (qx - vx) + dy * (qy - vy), dx * dx + dy * dy
            elif before < 0 < side:  # where the line leaves the piece, the ring runs from right to left
                s, t = (px - vx) * (qy - py) - (py - vy) * (qx - px), side - before
            else:
                s = 0
            if s > 0 and s * den < num * t:
                best, num, den = (p, q, side), s, t
            p, px, py, before = q, qx, qy, side
        p, q, side = best
        if side == 0:
            return _LineEnd(q, p, q)
        if (p, q) in self.halving:
            return _LineEnd(None, p, q)
        return _LineEnd(self._number_point(vx + Fraction(num * dx, den), vy + Fraction(num * dy, den)), p, q)

    def _first_beside(self, ring: Ring, a: int, v: int, hit: _LineEnd, left: bool) -> int:
        """Return the vertex that a ray from v first meets, turning left or right from the line through a, v.

        Nothing is on that line up to the edge that it meets, `hit`.  So it is the vertex at the smallest
        angle among those before that edge, and of several the nearest.
        """
        at = self.at
        pv, pp, pq = at[v], at[hit.p], at[hit.q]
        way, best = (1, hit.q) if left else (-1, hit.p)
        dx, dy = way * (pv[0] - at[a][0]), way * (pv[1] - at[a][1])
        on_line = dx * pv[1] - dy * pv[0]
        for w in ring:
            x, y = pw = at[w]
            if dx * y - dy * x > on_line:
                turn = way * orient_det(pv, at[best], pw)
                nearer = turn < 0 or (turn == 0 and _squared_distance(pv, pw) < _squared_distance(pv, at[best]))
                if nearer and orient_det(pp, pq, pw) > 0:
                    best = w
        return best

    def _number_point(self, x: Fraction, y: Fraction) -> int | None:
        """Return the number of the vertex at a point in multiples of `self.unit`; None if float64 cannot hold it.

        If there is no such vertex, it is added.
        """
        point = Vec(float(x * self.unit), float(y * self.unit))
        if point.x != x * self.unit or point.y != y * self.unit:
            return None
        if point not in self.numbers:
            self.numbers[point] = len(self.points)
            self.points.append(point)
            finer = lcm(x.denominator, y.denominator)
            if finer > 1:  # at most some 2,100 times: the bits from 2**1024 down to 2**-1074
                self.unit /= finer
                self.at = [(px * finer, py * finer) for px, py in self.at]
            self.at.append((int(x * finer), int(y * finer)))
        return self.numbers[point]


class _ReflexCount:
    """Counts the reflex vertices on either side of a cut through a ring; `reflex[i]`: whether ring[i] is reflex."""

    def __init__(self, ring: Ring, reflex: list[bool]) -> None:
        self.place = {v: i for i, v in enumerate(ring)}
        self.sums = [0, *accumulate(reflex)]
        self.total = self.sums[-1]

    def min_reflex_on_a_side(self, cut: Edge) -> int:
        """Return the number of reflex vertices on the side of the cut that has fewer, without the ends of the cut."""
        i, j = sorted(map(self.place.__getitem__, cut))
        return min(self.sums[j] - self.sums[i + 1], self.total - self.sums[j + 1] + self.sums[i])

    def balanced(self, cut: Edge) -> bool:
        """Return whether each side of the cut has at least an eighth of the ring's reflex vertices."""
        return 8 * self.min_reflex_on_a_side(cut) >= self.total


def _neighbours(ring: Ring, v: int) -> Edge:
    """Return the vertices before and after `v` on a ring."""
    i = ring.index(v)
    return ring[i - 1], ring[(i + 1) % len(ring)]


def _insert_vertex(ring: Ring, v: int, before: int) -> None:
    """Insert vertex v into the ring before another one, unless it is that vertex itself."""
    if v != before:
        ring.insert(ring.index(before), v)


def _squared_distance(p: IntPoint, q: IntPoint) -> int:
    """Return the squared distance of two points."""
    return (q[0] - p[0]) ** 2 + (q[1] - p[1]) ** 2


def _orientation_at(at: list[IntPoint], ring: Ring, i: int) -> int:
    """Return the orientation determinant at the ring's i-th vertex: negative when it is reflex; `at`: all points."""
    return orient_det(at[ring[i - 1]], at[ring[i]], at[ring[(i + 1) % len(ring)]])


def named_parts(shape: Shape, name: str) -> list[tuple[Shape, str]]:
    """Return the convex parts with their names: B1, B2, ... for a concave B, else just B."""
    found = parts(shape)
    return [(p, f"{name}{i}" if len(found) > 1 else name) for i, p in enumerate(found, 1)]
