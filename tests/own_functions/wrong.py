"""Collision functions as people write them, each with one classical mistake.

WRONG: (function, the name of its mistake, what `sv.check` is told besides).  Two take circles.
"""

from math import dist, hypot, inf


def dot(p, n):
    return p[0] * n[0] + p[1] * n[1]


def normals(poly):
    return [(q[1] - p[1], p[0] - q[0]) for p, q in zip(poly, [*poly[1:], poly[0]])]


def span(poly, n):
    on = [dot(p, n) for p in poly]
    return min(on), max(on)


def meet(r, s):
    return r[0] <= s[1] and s[0] <= r[1]


def bounding_boxes(a, b):
    ax, ay, bx, by = (sorted(p[i] for p in poly) for poly in (a, b) for i in (0, 1))
    return ax[0] <= bx[-1] and bx[0] <= ax[-1] and ay[0] <= by[-1] and by[0] <= ay[-1]


def any_for_all(a, b):
    return any(meet(span(a, n), span(b, n)) for n in normals(a) + normals(b))


def normals_of_a(a, b):
    for n in normals(a):
        if not meet(span(a, n), span(b, n)):
            return False
    return True


def first_half(a, b):
    axes = normals(a)[: len(a) // 2] + normals(b)[: len(b) // 2]
    return all(meet(span(a, n), span(b, n)) for n in axes)


def no_closing_edge(a, b):
    for poly in a, b:
        for i in range(len(poly) - 1):
            (x0, y0), (x1, y1) = poly[i], poly[i + 1]
            n = y1 - y0, x0 - x1
            if not meet(span(a, n), span(b, n)):
                return False
    return True


def extremes(poly):
    xs, ys = [p[0] for p in poly], [p[1] for p in poly]
    return [p for p in poly if p[0] in (min(xs), max(xs)) or p[1] in (min(ys), max(ys))]


def extremes_found_once(a, b):
    fast_a, fast_b = extremes(a), extremes(b)
    return all(meet(span(fast_a, n), span(fast_b, n)) for n in normals(a) + normals(b))


def opposite_normals(a, b):
    for n in normals(a) + normals(b):
        if not meet(span(a, n), span(b, (-n[0], -n[1]))):
            return False
    return True


def hull(poly):
    points = sorted(set(map(tuple, poly)))

    def chain(points):
        kept = []
        for p in points:
            while len(kept) > 1:
                (ox, oy), (qx, qy) = kept[-2], kept[-1]
                if (qx - ox) * (p[1] - oy) - (qy - oy) * (p[0] - ox) > 0:
                    break
                kept.pop()
            kept.append(p)
        return kept[:-1]

    return chain(points) + chain(points[::-1])


def sat_of_hulls(a, b):
    a, b = hull(a), hull(b)
    return all(meet(span(a, n), span(b, n)) for n in normals(a) + normals(b))


def touching_is_apart(a, b):
    for n in normals(a) + normals(b):
        (lo, hi), (low, high) = span(a, n), span(b, n)
        if hi <= low or high <= lo:
            return False
    return True


def smallest_or_largest(a, b):
    def range_on(poly, n):
        lo, hi = inf, -inf
        for p in poly:
            if dot(p, n) < lo:
                lo = dot(p, n)
            elif dot(p, n) > hi:
                hi = dot(p, n)
        return lo, hi

    return all(meet(range_on(a, n), range_on(b, n)) for n in normals(a) + normals(b))


def mean(poly):
    return sum(p[0] for p in poly) / len(poly), sum(p[1] for p in poly) / len(poly)


def far_apart_first(a, b):
    if dist(mean(a), mean(b)) > 5:
        return False
    return all(meet(span(a, n), span(b, n)) for n in normals(a) + normals(b))


def circle_and_edges(a, b):
    if isinstance(a[1], (int, float)):
        a, b = b, a
    center, radius = b
    for n in normals(a):
        length = hypot(*n)
        lo, hi = span(a, n)
        at = dot(center, n)
        if at - radius * length > hi or at + radius * length < lo:
            return False
    return True


def raw_depth(a, b):
    best, axis = None, None
    for n in normals(a) + normals(b):
        (lo, hi), (low, high) = span(a, n), span(b, n)
        if hi < low or high < lo:
            return None
        for depth, sign in (hi - low, 1), (high - lo, -1):
            if best is None or depth < best:
                best, axis = depth, (n[0] * sign, n[1] * sign)
    length = hypot(*axis)
    return axis[0] / length * best, axis[1] / length * best


def away_from_center(a, b):
    best, axis = None, None
    for n in normals(a) + normals(b):
        length = hypot(*n)
        n = n[0] / length, n[1] / length
        (lo, hi), (low, high) = span(a, n), span(b, n)
        depth = min(hi - low, high - lo)
        if depth < 0:
            return None
        if best is None or depth < best:
            best, axis = depth, n
    (ax, ay), (bx, by) = mean(a), mean(b)
    if (bx - ax) * axis[0] + (by - ay) * axis[1] < 0:
        axis = -axis[0], -axis[1]
    return axis[0] * best, axis[1] * best


WRONG = [
    (bounding_boxes, "aabb-not-upright", {}),
    (any_for_all, "one-overlap", {}),
    (normals_of_a, "one-shapes-normals", {}),
    (first_half, "half-the-normals", {}),
    (no_closing_edge, "open-outline", {}),
    (extremes_found_once, "extremes-once", {}),
    (smallest_or_largest, "extremes-once", {}),
    (opposite_normals, "mixed-signs", {}),
    (sat_of_hulls, "box-in-u", {"kinds": ("convex", "concave")}),
    (touching_is_apart, "touch-as-apart", {}),
    (far_apart_first, "far-centers", {}),
    (circle_and_edges, "no-nearest-vertex", {"kinds": "circle and polygon"}),
    (raw_depth, "raw-depth", {}),
    (away_from_center, "push-from-center", {}),
]
