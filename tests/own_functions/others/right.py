"""Right functions as twenty people write them: no check may find a fault in them.

A docstring's first word says what the function takes and returns, where that is not two convex outlines and a hit.
"""

import math
from fractions import Fraction
from functools import reduce
from itertools import chain, combinations, product

import numpy as np


def _edges(p):
    return list(zip(p, [*p[1:], p[0]]))


def _cross(o, p, q):
    return (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0])


def _ccw(p):
    return p if sum(x * v - u * y for (x, y), (u, v) in _edges(p)) > 0 else p[::-1]


def backwards(a, b):
    """The edges of B first, each list from its end."""
    for p in (b, a):
        for (x0, y0), (x1, y1) in reversed(_edges(p)):
            s, t = (sorted((y1 - y0) * x - (x1 - x0) * y for x, y in q) for q in (a, b))
            if s[-1] < t[0] or t[-1] < s[0]:
                return False
    return True


def in_one_product(a, b):
    """NumPy, without a loop; the answer is a np.bool_."""
    a, b = np.array(a), np.array(b)
    d = np.concatenate([a - np.roll(a, 1, axis=0), b - np.roll(b, 1, axis=0)])
    n = np.stack([d[:, 1], -d[:, 0]])
    s, t = a @ n, b @ n
    return ~np.any((s.max(0) < t.min(0)) | (t.max(0) < s.min(0)))


def shortest_whole_normals(a, b):
    """Normals divided by their greatest common divisor, and each only once."""
    seen = set()
    for (x0, y0), (x1, y1) in _edges(a) + _edges(b):
        nx, ny = Fraction(y1 - y0), Fraction(x0 - x1)
        k = max(abs(nx), abs(ny))
        n = (nx / k, ny / k)
        if n in seen or (-n[0], -n[1]) in seen:
            continue
        seen.add(n)
        s, t = ([x * n[0] + y * n[1] for x, y in p] for p in (a, b))
        if max(s) < min(t) or max(t) < min(s):
            return False
    return True


def long_normals(a, b):
    """Normals a thousand times too long, and turned the other way."""
    for (x0, y0), (x1, y1) in chain(_edges(a), _edges(b)):
        nx, ny = 1000 * (y0 - y1), 1000 * (x1 - x0)
        s, t = ([nx * x + ny * y for x, y in p] for p in (a, b))
        if not (min(s) <= max(t) and min(t) <= max(s)):
            return False
    return True


def gjk(a, b):
    """Gilbert, Johnson and Keerthi, on the difference of both shapes, in fractions."""

    def support(dx, dy):
        p = max(a, key=lambda v: v[0] * dx + v[1] * dy)
        q = min(b, key=lambda v: v[0] * dx + v[1] * dy)
        return Fraction(p[0] - q[0]), Fraction(p[1] - q[1])

    def nearest(simplex):
        """The point of a simplex nearest to the origin, and the corners that it needs."""
        if len(simplex) == 3:
            o = (0, 0)
            turns = [_cross(simplex[i], simplex[i - 2], o) for i in range(3)]
            if all(t >= 0 for t in turns) or all(t <= 0 for t in turns):
                return (0, 0), simplex
        best = None
        for p, q in combinations(simplex, 2) if len(simplex) > 1 else [(simplex[0], simplex[0])]:
            dx, dy = q[0] - p[0], q[1] - p[1]
            d2 = dx * dx + dy * dy
            k = min(max(-(p[0] * dx + p[1] * dy) / d2, 0), 1) if d2 else 0
            z = (p[0] + k * dx, p[1] + k * dy)
            if best is None or z[0] ** 2 + z[1] ** 2 < best[0][0] ** 2 + best[0][1] ** 2:
                best = z, [p] if k == 0 else [q] if k == 1 else [p, q]
        return best

    z, simplex = (s := support(1, 0)), [s]
    while z != (0, 0):
        new = support(-z[0], -z[1])
        if new[0] * z[0] + new[1] * z[1] > 0:
            return False
        if new in simplex:
            return False
        z, simplex = nearest([*simplex, new])
    return True


def _hull(points):
    points = sorted(set(points))

    def half(ps):
        found = []
        for p in ps:
            while len(found) > 1 and _cross(found[-2], found[-1], p) <= 0:
                found.pop()
            found.append(p)
        return found[:-1]

    return half(points) + half(points[::-1])


def difference_holds_the_origin(a, b):
    """Minkowski: the hull of all differences of corners."""
    hull = _hull([(x - u, y - v) for (x, y), (u, v) in product(a, b)])
    return all(_cross(p, q, (0, 0)) >= 0 for p, q in _edges(hull))


def clipped(a, b):
    """Sutherland and Hodgman: what is left of A inside B, in fractions."""
    left = [(Fraction(x), Fraction(y)) for x, y in a]
    for p, q in _edges(_ccw(b)):
        kept = []
        for u, v in _edges(left):
            su, sv = _cross(p, q, u), _cross(p, q, v)
            if su >= 0:
                kept.append(u)
            if su * sv < 0:
                k = su / (su - sv)
                kept.append((u[0] + k * (v[0] - u[0]), u[1] + k * (v[1] - u[1])))
        left = kept
        if not left:
            return False
    return True


def _segments_meet(p, q, u, v):
    d1, d2, d3, d4 = _cross(p, q, u), _cross(p, q, v), _cross(u, v, p), _cross(u, v, q)
    if d1 * d2 < 0 and d3 * d4 < 0:
        return True

    def on(d, s, t, w):
        return d == 0 and min(s[0], t[0]) <= w[0] <= max(s[0], t[0]) and min(s[1], t[1]) <= w[1] <= max(s[1], t[1])

    return on(d1, p, q, u) or on(d2, p, q, v) or on(d3, u, v, p) or on(d4, u, v, q)


def _is_inside(p, poly):
    inside = False
    for (x0, y0), (x1, y1) in _edges(poly):
        if (y0 > p[1]) != (y1 > p[1]):
            side = (x1 - x0) * (p[1] - y0) - (p[0] - x0) * (y1 - y0)
            inside ^= (side > 0) == (y1 > y0)
    return inside


def outlines_or_insides(a, b):
    """Any: edges that meet, or one outline inside the other; dents do no harm."""
    if any(_segments_meet(*e, *f) for e, f in product(_edges(a), _edges(b))):
        return True
    return _is_inside(a[0], b) or _is_inside(b[0], a)


def an_edge_that_separates(a, b):
    """Looks for an edge with the whole other shape beyond it; no ranges at all."""
    for p, q in ((a, b), (b, a)):
        for u, v in _edges(_ccw(p)):
            if all(_cross(u, v, w) < 0 for w in q):
                return False
    return True


def a_line_through_two_corners(a, b):
    """Tries the line through every two corners, moved a little to either side in thought."""
    for p, q in combinations({*a, *b}, 2):
        nx, ny = q[1] - p[1], p[0] - q[0]
        s, t = ({nx * x + ny * y for x, y in r} for r in (a, b))
        if max(s) < min(t) or max(t) < min(s):
            return False
    return True


def _planes(p):
    """Half planes (m, n, c) with m x + n y <= c inside."""
    return [(v[1] - u[1], u[0] - v[0], (v[1] - u[1]) * u[0] + (u[0] - v[0]) * u[1]) for u, v in _edges(_ccw(p))]


def eliminated(a, b):
    """Fourier and Motzkin: is there an x and a y that all half planes allow?"""
    planes = [tuple(map(Fraction, h)) for h in _planes(a) + _planes(b)]
    low, high, rest = [], [], []
    for m, n, c in planes:
        if n > 0:
            high.append((-m / n, c / n))  # y <= k x + d
        elif n < 0:
            low.append((-m / n, c / n))
        else:
            rest.append((m, c))
    rest += [(lk - hk, hd - ld) for (lk, ld), (hk, hd) in product(low, high)]  # (lk - hk) x <= hd - ld
    if any(m == 0 and c < 0 for m, c in rest):
        return False
    left = max((c / m for m, c in rest if m < 0), default=-math.inf)
    right = min((c / m for m, c in rest if m > 0), default=math.inf)
    return left <= right


def three_words(a, b):
    """Relation: the word for the largest gap, in whole numbers."""
    largest = -math.inf
    for (x0, y0), (x1, y1) in _edges(a) + _edges(b):
        s, t = ([(y1 - y0) * x - (x1 - x0) * y for x, y in p] for p in (a, b))
        largest = max(largest, min(t) - max(s), min(s) - max(t))
    return "apart" if largest > 0 else "touching" if largest == 0 else "overlapping"


def _unit_normals(p):
    for (x0, y0), (x1, y1) in _edges(p):
        length = math.hypot(x1 - x0, y1 - y0)
        yield (y1 - y0) / length, (x0 - x1) / length


def moves_b(a, b):
    """MTV of B, or None; the direction is decided by which end is nearer."""
    best = None
    for nx, ny in chain(_unit_normals(a), _unit_normals(b)):
        s, t = ([nx * x + ny * y for x, y in p] for p in (a, b))
        forth, back = max(s) - min(t), max(t) - min(s)
        if min(forth, back) <= 1e-12 * max(map(abs, s + t)):
            return None
        d, sign = (forth, 1) if forth <= back else (back, -1)
        if best is None or d < best[0]:
            best = d, sign * nx, sign * ny
    d, nx, ny = best
    return d * nx, d * ny


class Response:
    """A hit and a move of A, as an engine's class holds them."""

    def __init__(self, a, b):
        self.hit, self.push = self._solve(np.array(a, float), np.array(b, float))

    @staticmethod
    def _solve(a, b):
        d = np.vstack([np.roll(a, -1, 0) - a, np.roll(b, -1, 0) - b])
        n = d[:, ::-1] * [1, -1] / np.linalg.norm(d, axis=1)[:, None]
        s, t = a @ n.T, b @ n.T
        forth, back = s.max(0) - t.min(0), t.max(0) - s.min(0)
        depth = np.minimum(forth, back)
        if depth.min() < -1e-12 * max(abs(a).max(), abs(b).max()):
            return False, None
        i = depth.argmin()
        return True, n[i] * (back[i] if back[i] < forth[i] else -forth[i])


def moves_a(a, b):
    """Hit and MTV of A, as a dict with an array in it."""
    found = Response(a, b)
    return {"hit": found.hit, "mtv": found.push}


def depth_of_the_difference(a, b):
    """Depth: the origin's distance from the outline of the Minkowski difference, with a root at the end only."""
    hull = _hull([(x - u, y - v) for (x, y), (u, v) in product(a, b)])
    least = math.inf
    for p, q in _edges(hull):
        side = _cross(p, q, (0, 0))
        if side <= 0:
            return 0
        least = min(least, Fraction(side) ** 2 / Fraction((q[0] - p[0]) ** 2 + (q[1] - p[1]) ** 2))
    return math.sqrt(least)


def two_circles(a, b):
    """Circles, in squares."""
    ((x, y), r), ((u, v), s) = a, b
    return (u - x) ** 2 + (v - y) ** 2 <= (r + s) ** 2


def circle_and_outline(a, b):
    """Circle and polygon, in either order: the nearest point of each edge, in fractions."""
    if isinstance(a[1], int | float):
        a, b = b, a
    c, r = b
    if _is_inside(c, a):
        return True
    for p, q in _edges(a):
        dx, dy = q[0] - p[0], q[1] - p[1]
        k = Fraction((c[0] - p[0]) * dx + (c[1] - p[1]) * dy) / Fraction(dx * dx + dy * dy)
        k = min(max(k, 0), 1)
        if (p[0] + k * dx - c[0]) ** 2 + (p[1] + k * dy - c[1]) ** 2 <= r * r:
            return True
    return False


def ears(a, b):
    """Any: cuts off ears, and tests triangle against triangle."""

    def triangles(p):
        p = _ccw(p)
        while len(p) > 3:
            for i in range(len(p)):
                u, v, w = p[i - 1], p[i], p[(i + 1) % len(p)]
                turn = _cross(u, v, w)
                others = [q for q in p if q not in (u, v, w)]
                if turn == 0 or (
                    turn > 0
                    and not any(_cross(u, v, q) >= 0 and _cross(v, w, q) >= 0 and _cross(w, u, q) >= 0 for q in others)
                ):
                    if turn:
                        yield [u, v, w]
                    p = p[:i] + p[i + 1 :]
                    break
        yield p

    return any(backwards(s, t) for s, t in product(triangles(a), triangles(b)))


def supports_only(a, b):
    """For each edge the deepest corner of the other shape, by reduce()."""

    def is_clear(p, q):
        for u, v in _edges(_ccw(p)):
            n = (v[1] - u[1], u[0] - v[0])
            low = reduce(lambda w, z: z if z[0] * n[0] + z[1] * n[1] < w[0] * n[0] + w[1] * n[1] else w, q)
            if (low[0] - u[0]) * n[0] + (low[1] - u[1]) * n[1] > 0:
                return True
        return False

    return not (is_clear(a, b) or is_clear(b, a))


def interiors_meet(a, b):
    """Touching counts as a miss: a strict overlap on every axis."""
    for (x0, y0), (x1, y1) in _edges(a) + _edges(b):
        s, t = ([(y1 - y0) * x - (x1 - x0) * y for x, y in p] for p in (a, b))
        if max(s) <= min(t) or max(t) <= min(s):
            return False
    return True
