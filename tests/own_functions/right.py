"""Twenty correct collision functions, each written in another way."""

from fractions import Fraction
from itertools import product
from math import hypot, sqrt

from .wrong import dot, hull, meet, normals, span


def sat(a, b):
    return all(meet(span(a, n), span(b, n)) for n in normals(a) + normals(b))


def other_shape_first(a, b):
    return sat(b, a)


def last_edge_first(a, b):
    return all(meet(span(a, n), span(b, n)) for n in (normals(a) + normals(b))[::-1])


def inward_normals(a, b):
    axes = [(-x, -y) for x, y in normals(a) + normals(b)]
    return all(meet(span(a, n), span(b, n)) for n in axes)


def long_normals(a, b):
    axes = [(3 * x, 3 * y) for x, y in normals(a) + normals(b)]
    return all(meet(span(a, n), span(b, n)) for n in axes)


def short_normals(a, b):
    axes = [(x / 1024, y / 1024) for x, y in normals(a) + normals(b)]
    return all(meet(span(a, n), span(b, n)) for n in axes)


def fractions(a, b):
    a, b = ([(Fraction(x), Fraction(y)) for x, y in poly] for poly in (a, b))
    return sat(a, b)


def rational_unit_normals(a, b):
    axes = [(Fraction(x, abs(x) + abs(y)), Fraction(y, abs(x) + abs(y))) for x, y in normals(a) + normals(b)]
    return all(meet(span(a, n), span(b, n)) for n in axes)


def boxes_first(a, b):
    upright = [(1, 0), (0, 1)]
    return all(meet(span(a, n), span(b, n)) for n in upright + normals(a) + normals(b))


def cross_products(a, b):
    def clears(p, q, others, inside):
        def side(r):
            return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])

        own = max((side(r) for r in inside), key=abs)
        return all(side(r) * own < 0 for r in others)

    for one, other in (a, b), (b, a):
        if any(clears(p, q, other, one) for p, q in zip(one, [*one[1:], one[0]])):
            return False
    return True


def minkowski(a, b):
    ring = hull([(q[0] - p[0], q[1] - p[1]) for p, q in product(a, b)])
    return all(x0 * y1 - y0 * x1 >= 0 for (x0, y0), (x1, y1) in zip(ring, [*ring[1:], ring[0]]))


def gjk(a, b):
    """GJK with whole numbers: no direction is ever brought to length 1."""

    def support(d):
        p, q = max(a, key=lambda p: dot(p, d)), min(b, key=lambda p: dot(p, d))
        return p[0] - q[0], p[1] - q[1]

    def towards_origin(p, q):
        ex, ey = q[0] - p[0], q[1] - p[1]
        side = ex * -p[1] - ey * -p[0]
        return (-ey, ex) if side > 0 else (ey, -ex)

    simplex, d = [support((1, 0))], None
    d = -simplex[0][0], -simplex[0][1]
    while True:
        if d == (0, 0):
            return True
        new = support(d)
        if dot(new, d) < 0:
            return False
        if new in simplex:
            return dot(new, d) == 0
        simplex.append(new)
        if len(simplex) == 2:
            p, q = simplex
            ex, ey = q[0] - p[0], q[1] - p[1]
            if ex * p[1] - ey * p[0] == 0:
                if dot(p, (ex, ey)) <= 0 <= dot(q, (ex, ey)):
                    return True
                d = (-q[0], -q[1]) if dot(q, (ex, ey)) < 0 else (-p[0], -p[1])
                simplex = [q if dot(q, (ex, ey)) < 0 else p]
            else:
                d = towards_origin(p, q)
            continue
        p, q, r = simplex
        for u, v, w in (q, r, p), (p, r, q):
            ex, ey = v[0] - u[0], v[1] - u[1]
            own = ex * (w[1] - u[1]) - ey * (w[0] - u[0])
            origin = ex * -u[1] - ey * -u[0]
            if own * origin < 0:
                simplex, d = [u, v], towards_origin(u, v)
                break
            if own == 0:
                return False
        else:
            return True


def edges_and_corners(a, b):
    """No axis at all: some edges cross, or a corner lies inside the other shape."""

    def turn(p, q, r):
        return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])

    def on(p, q, r):
        return turn(p, q, r) == 0 and all(min(p[i], q[i]) <= r[i] <= max(p[i], q[i]) for i in (0, 1))

    def cross(p, q, r, s):
        t, u, v, w = turn(p, q, r), turn(p, q, s), turn(r, s, p), turn(r, s, q)
        if t * u < 0 and v * w < 0:
            return True
        return on(p, q, r) or on(p, q, s) or on(r, s, p) or on(r, s, q)

    def edges(poly):
        return list(zip(poly, [*poly[1:], poly[0]]))

    def inside(r, poly):
        turns = [turn(p, q, r) for p, q in edges(poly)]
        return min(turns) >= 0 or max(turns) <= 0

    crossing = any(cross(*e, *f) for e in edges(a) for f in edges(b))
    return crossing or any(inside(p, b) for p in a) or any(inside(p, a) for p in b)


def as_a_relation(a, b):
    gaps = []
    for n in normals(a) + normals(b):
        (lo, hi), (low, high) = span(a, n), span(b, n)
        gaps.append(max(low - hi, lo - high))
    return "apart" if max(gaps) > 0 else "touching" if max(gaps) == 0 else "overlapping"


def zero_or_one(a, b):
    return 1 if sat(a, b) else 0


def _least(a, b):
    found = []
    for n in normals(a) + normals(b):
        (lo, hi), (low, high) = span(a, n), span(b, n)
        if hi < low or high < lo:
            return None
        length = hypot(*n)
        found.append(((hi - low) / length, (n[0] / length, n[1] / length)))
        found.append(((high - lo) / length, (-n[0] / length, -n[1] / length)))
    return min(found)


def depth(a, b):
    found = _least(a, b)
    return found[0] if found else 0


def mtv(a, b):
    found = _least(a, b)
    return (found[1][0] * found[0], found[1][1] * found[0]) if found else None


def mtv_of_a(a, b):
    found = mtv(a, b)
    return found and (-found[0], -found[1])


def hit_and_mtv(a, b):
    found = mtv(a, b)
    return (found is not None, found)


def circles(a, b):
    (ax, ay), r = a
    (bx, by), s = b
    return (bx - ax) ** 2 + (by - ay) ** 2 <= (r + s) ** 2


def circle_and_polygon(a, b):
    if isinstance(b[1], (int, float)):
        a, b = b, a
    (cx, cy), radius = a
    signs = set()
    for (px, py), (qx, qy) in zip(b, [*b[1:], b[0]]):
        ex, ey, dx, dy = qx - px, qy - py, cx - px, cy - py
        along, square = dx * ex + dy * ey, ex * ex + ey * ey
        turn = ex * dy - ey * dx
        signs.add(turn >= 0)
        if along <= 0:
            near = dx * dx + dy * dy <= radius * radius
        elif along >= square:
            near = (cx - qx) ** 2 + (cy - qy) ** 2 <= radius * radius
        else:
            near = turn * turn <= radius * radius * square
        if near:
            return True
    return len(signs) == 1


def unit_normals_with_tolerance(a, b):
    for x, y in normals(a) + normals(b):
        length = sqrt(x * x + y * y)
        n = x / length, y / length
        (lo, hi), (low, high) = span(a, n), span(b, n)
        if hi < low - 1e-9 or high < lo - 1e-9:
            return False
    return True


RIGHT = [
    (sat, {}),
    (other_shape_first, {}),
    (last_edge_first, {}),
    (inward_normals, {}),
    (long_normals, {}),
    (short_normals, {}),
    (fractions, {"whole_numbers": True}),
    (rational_unit_normals, {"whole_numbers": True}),
    (boxes_first, {}),
    (cross_products, {}),
    (minkowski, {}),
    (gjk, {"whole_numbers": True}),
    (edges_and_corners, {}),
    (as_a_relation, {}),
    (zero_or_one, {}),
    (depth, {}),
    (mtv, {}),
    (mtv_of_a, {}),
    (hit_and_mtv, {}),
    (circles, {"kinds": "circles"}),
    (circle_and_polygon, {"kinds": "circle and polygon"}),
    (unit_normals_with_tolerance, {"tolerance": 1e-9}),
]
