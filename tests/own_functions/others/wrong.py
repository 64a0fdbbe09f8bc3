"""Wrong functions as other people write them, each with one mistake.  The test knows which."""

import itertools
import math
from dataclasses import dataclass

import numpy as np


def game_jam_boxes(a, b):
    """NumPy, one expression: all of a shape's corners become its box."""
    a, b = np.asarray(a), np.asarray(b)
    return bool(np.all(a.max(axis=0) >= b.min(axis=0)) and np.all(b.max(axis=0) >= a.min(axis=0)))


class Projection:
    """A range on an axis, in a class of its own."""

    def __init__(self, points, axis):
        values = [x * axis[0] + y * axis[1] for x, y in points]
        self.min, self.max = min(values), max(values)

    def overlaps(self, other):
        return not (self.max < other.min or other.max < self.min)


class Collider:
    """Asks the other collider for nothing but its points."""

    def __init__(self, points):
        self.points = points

    def axes(self):
        for i, (x, y) in enumerate(self.points):
            px, py = self.points[i - 1]
            yield py - y, x - px

    def hits(self, other):
        return all(Projection(self.points, n).overlaps(Projection(other.points, n)) for n in self.axes())


def classes_second_first(a, b):
    return Collider(b).hits(Collider(a))


def _directions(poly):
    closed = itertools.chain(poly, poly[:1])
    for (x1, y1), (x2, y2) in itertools.pairwise(closed):
        yield y2 - y1, x1 - x2


def _scalar_projections(poly, d):
    return sorted(np.dot(poly, d).tolist())


def any_for_all(a, b):
    """Generators, with the wrong one of two words."""
    overlaps = (
        pa[0] <= pb[-1] and pb[0] <= pa[-1]
        for d in itertools.chain(_directions(a), _directions(b))
        for pa, pb in [(_scalar_projections(a, d), _scalar_projections(b, d))]
    )
    return any(overlaps)


def stops_before_the_last_edge(a, b):
    """A range that is one too short."""
    for p in [a, b]:
        for i in range(len(p) - 1):
            ax = -(p[i + 1][1] - p[i][1])
            ay = p[i + 1][0] - p[i][0]
            min_a = max_a = ax * a[0][0] + ay * a[0][1]
            for q in a[1:]:
                d = ax * q[0] + ay * q[1]
                min_a = min(min_a, d)
                max_a = max(max_a, d)
            min_b = max_b = ax * b[0][0] + ay * b[0][1]
            for q in b[1:]:
                d = ax * q[0] + ay * q[1]
                min_b = min(min_b, d)
                max_b = max(max_b, d)
            if max_a < min_b or max_b < min_a:
                return False
    return True


def saves_half(a, b):
    """An optimisation that is right for rectangles."""

    def normals(p):
        n = len(p)
        for i in range((n + 1) // 2):
            (x0, y0), (x1, y1) = p[i], p[(i + 1) % n]
            yield np.array([y1 - y0, x0 - x1])

    A, B = np.array(a), np.array(b)
    for n in (*normals(a), *normals(b)):
        s, t = A @ n, B @ n
        if s.max() < t.min():
            return False
        if t.max() < s.min():
            return False
    return True


def compass_points(a, b):
    """Keeps the corners furthest to the west, east, south and north, to project fewer."""

    def few_of(p):
        p = np.array(p)
        return p[[p[:, 0].argmin(), p[:, 0].argmax(), p[:, 1].argmin(), p[:, 1].argmax()]]

    few = [few_of(a), few_of(b)]
    for p in (a, b):
        for (x0, y0), (x1, y1) in zip(p, p[1:] + p[:1]):
            s, t = (f @ (y1 - y0, x0 - x1) for f in few)
            if s.max() < t.min() or t.max() < s.min():
                return False
    return True


def complex_conjugate(a, b):
    """Points as complex numbers; a quarter turn is a factor, and conjugate() is none."""
    a, b = ([complex(*p) for p in poly] for poly in (a, b))

    def dots(poly, n):
        return [(z * n.conjugate()).real for z in poly]

    for poly in (a, b):
        for k in range(len(poly)):
            n = (poly[k] - poly[k - 1]).conjugate()
            da, db = dots(a, n), dots(b, n)
            if max(da) < min(db) or max(db) < min(da):
                return False
    return True


@dataclass(frozen=True)
class Vector2:
    x: float
    y: float

    def dot(self, o):
        return self.x * o.x + self.y * o.y

    def project_on(self, o):
        k = self.dot(o) / o.dot(o)
        return Vector2(k * o.x, k * o.y)

    def magnitude(self):
        return math.sqrt(self.dot(self))


def vector_projection(a, b):
    """Projects onto the axis as a vector, as in the lecture, and takes its magnitude."""
    A, B = [Vector2(*p) for p in a], [Vector2(*p) for p in b]
    axes = []
    for P in (A, B):
        for p, q in zip(P, [*P[1:], P[0]]):
            axes.append(Vector2(p.y - q.y, q.x - p.x))
    for axis in axes:
        on_a = [p.project_on(axis).magnitude() for p in A]
        on_b = [p.project_on(axis).magnitude() for p in B]
        if min(on_a) > max(on_b) or min(on_b) > max(on_a):
            return False
    return True


def axes_along_the_edges(a, b):
    """Forgets the quarter turn."""
    edges = [(x2 - x1, y2 - y1) for p in (a, b) for (x1, y1), (x2, y2) in zip(p, p[1:] + p[:1])]
    for ex, ey in edges:
        pa = [x * ex + y * ey for (x, y) in a]
        pb = [x * ex + y * ey for (x, y) in b]
        if not (min(pa) <= max(pb) and min(pb) <= max(pa)):
            return False
    return True


def quick_reject(a, b):
    """Returns early where the middles are further apart than the shapes are wide."""

    def middle(p):
        return sum(x for x, _ in p) / len(p), sum(y for _, y in p) / len(p)

    def reach(p):
        mx, my = middle(p)
        return sum(math.hypot(x - mx, y - my) for x, y in p) / len(p)

    if math.dist(middle(a), middle(b)) > reach(a) + reach(b):
        return False
    for d in itertools.chain(_directions(a), _directions(b)):
        pa, pb = _scalar_projections(a, d), _scalar_projections(b, d)
        if pa[-1] < pb[0] or pb[-1] < pa[0]:
            return False
    return True


def twins(a, b):
    """Shapes of one kind need one set of normals, somebody said."""
    polys = [a] if len(a) == len(b) else [a, b]
    for p in polys:
        for d in _directions(p):
            pa, pb = _scalar_projections(a, d), _scalar_projections(b, d)
            if pa[-1] < pb[0] or pb[-1] < pa[0]:
                return False
    return True


def strict(a, b):
    """The comparison of a tutorial: an overlap is where both are strictly so."""
    for d in itertools.chain(_directions(a), _directions(b)):
        (a0, *_, a1), (b0, *_, b1) = _scalar_projections(a, d), _scalar_projections(b, d)
        if not (a0 < b1 and a1 > b0):
            return False
    return True


def depth_of_any_length(a, b):
    """NumPy, all axes at once; the smallest overlap is returned as it is."""
    a, b = np.array(a, float), np.array(b, float)
    edges = np.vstack([np.roll(a, -1, 0) - a, np.roll(b, -1, 0) - b])
    normals = edges[:, ::-1] * [1, -1]
    pa, pb = a @ normals.T, b @ normals.T
    overlap = np.minimum(pa.max(0) - pb.min(0), pb.max(0) - pa.min(0))
    return max(0.0, overlap.min())


# -- the corners, the edges, or circles instead of axes


def _turned(p, q, r):
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def _inside(spot, ring):
    turns = [_turned(p, q, spot) for p, q in zip(ring[-1:] + ring, ring)]
    return min(turns) >= 0 or max(turns) <= 0


def some_corner_inside(a, b):
    return any(_inside(p, b) for p in a) or any(_inside(p, a) for p in b)


def some_middle_inside(a, b):
    return any(_inside([sum(c) / len(c) for c in zip(*one)], other) for one, other in ((a, b), (b, a)))


def borders_meet(a, b):
    def on(p, q, r):
        return not _turned(p, q, r) and all(min(u, v) <= w <= max(u, v) for u, v, w in zip(p, q, r))

    for p, q in zip(a[-1:] + a, a):
        for r, s in zip(b[-1:] + b, b):
            crossed = _turned(p, q, r) * _turned(p, q, s) < 0 and _turned(r, s, p) * _turned(r, s, q) < 0
            if crossed or on(p, q, r) or on(p, q, s) or on(r, s, p) or on(r, s, q):
                return True
    return False


def circles_round_them(a, b):
    def around(ring):
        middle = [sum(c) / len(c) for c in zip(*ring)]
        return middle, max(math.dist(middle, p) for p in ring)

    (m, r), (n, s) = around(a), around(b)
    return math.dist(m, n) <= r + s


# -- one comparison where there must be two


class OneComparison:
    def __init__(self, *axes):
        self.axes = axes

    def __call__(self, a, b):
        for x, y in self.axes or [
            (q[1] - p[1], p[0] - q[0]) for ring in (a, b) for p, q in zip(ring[-1:] + ring, ring)
        ]:
            if max(x * u + y * v for u, v in a) < min(x * u + y * v for u, v in b):
                return False
        return True


one_comparison = OneComparison()
one_comparison_of_boxes = OneComparison((1, 0), (0, 1))


def pushed_along_the_normal(a, b):
    found = []
    for ring in a, b:
        for p, q in zip(ring[-1:] + ring, ring):
            x, y = q[1] - p[1], p[0] - q[0]
            size = math.hypot(x, y)
            s, t = ([(x * u + y * v) / size for u, v in shape] for shape in (a, b))
            found.append((min(max(s) - min(t), max(t) - min(s)), x / size, y / size))
    depth, x, y = min(found)
    return (depth * x, depth * y) if depth > 0 else None


def depth_from_one_side(a, b):
    found = []
    for ring in a, b:
        for p, q in zip(ring[-1:] + ring, ring):
            x, y = q[1] - p[1], p[0] - q[0]
            s, t = ([(x * u + y * v) / math.hypot(x, y) for u, v in shape] for shape in (a, b))
            if max(s) < min(t) or max(t) < min(s):
                return 0
            found.append(max(s) - min(t))
    return min(found)


def without_the_minus(a, b):
    for ring in a, b:
        for (p, q), (r, s) in zip(ring[-1:] + ring, ring):
            on_a, on_b = ([(s - q) * x + (r - p) * y for x, y in shape] for shape in (a, b))
            if max(on_a) < min(on_b) or max(on_b) < min(on_a):
                return False
    return True


# -- loops, searches and choices of axes that are nearly right


def without_the_first_edge(a, b):
    for p in a, b:
        for i in range(1, len(p)):
            (x1, y1), (x2, y2) = p[i], p[(i + 1) % len(p)]
            on_a, on_b = ([(y1 - y2) * x + (x2 - x1) * y for x, y in shape] for shape in (a, b))
            if max(on_a) < min(on_b) or max(on_b) < min(on_a):
                return False
    return True


def else_in_the_loop(a, b):
    for p in a, b:
        for i in range(len(p)):
            (x1, y1), (x2, y2) = p[i - 1], p[i]
            on_a, on_b = ([(y1 - y2) * x + (x2 - x1) * y for x, y in shape] for shape in (a, b))
            if max(on_a) < min(on_b) or max(on_b) < min(on_a):
                return False
            else:
                return True


def overwritten(a, b):
    hit = False
    for p in a, b:
        for i in range(len(p)):
            (x1, y1), (x2, y2) = p[i - 1], p[i]
            on_a, on_b = ([(y1 - y2) * x + (x2 - x1) * y for x, y in shape] for shape in (a, b))
            hit = max(on_a) >= min(on_b) and max(on_b) >= min(on_a)
    return hit


def largest_from_zero(a, b):
    """A range that is searched for, from a first value that is no landing place."""

    def project(shape, x, y):
        low, high = math.inf, 0
        for px, py in shape:
            low, high = min(low, px * x + py * y), max(high, px * x + py * y)
        return low, high

    for (x1, y1), (x2, y2) in [e for p in (a, b) for e in zip(p, p[1:] + p[:1])]:
        (a0, a1), (b0, b1) = (project(p, y2 - y1, x1 - x2) for p in (a, b))
        if a1 < b0 or b1 < a0:
            return False
    return True


def extents_about_the_middle(a, b):
    (ax, ay), (bx, by) = ([sum(c) / len(c) for c in zip(*p)] for p in (a, b))
    for p in a, b:
        for (x1, y1), (x2, y2) in zip(p[-1:] + p, p):
            nx, ny = y2 - y1, x1 - x2
            half_a = max(abs((x - ax) * nx + (y - ay) * ny) for x, y in a)
            half_b = max(abs((x - bx) * nx + (y - by) * ny) for x, y in b)
            if abs((bx - ax) * nx + (by - ay) * ny) > half_a + half_b:
                return False
    return True


def line_of_middles(a, b):
    (ax, ay), (bx, by) = ([sum(c) / len(c) for c in zip(*p)] for p in (a, b))
    return max(x * (bx - ax) + y * (by - ay) for x, y in a) >= min(x * (bx - ax) + y * (by - ay) for x, y in b)


def corner_of_a_inside(a, b):
    return any(_inside(p, b) for p in a)


def an_end_of_b_within(a, b):
    for (x1, y1), (x2, y2) in [e for p in (a, b) for e in zip(p[-1:] + p, p)]:
        s, t = ([(y1 - y2) * x + (x2 - x1) * y for x, y in p] for p in (a, b))
        if not (min(s) <= min(t) <= max(s) or min(s) <= max(t) <= max(s)):
            return False
    return True


def counter_clockwise_or_not(a, b):
    def ccw(p, q, r):
        return (r[1] - p[1]) * (q[0] - p[0]) > (q[1] - p[1]) * (r[0] - p[0])

    def cross(p, q, r, s):
        return ccw(p, r, s) != ccw(q, r, s) and ccw(p, q, r) != ccw(p, q, s)

    return any(cross(*e, *f) for e in zip(a[-1:] + a, a) for f in zip(b[-1:] + b, b))


def squares_and_sum(a, b):
    ((ax, ay), r), ((bx, by), s) = a, b
    return (bx - ax) ** 2 + (by - ay) ** 2 <= r + s


def corners_and_center(a, b):
    if isinstance(a, tuple):
        a, b = b, a
    center, radius = b
    return any(math.dist(p, center) <= radius for p in a) or _inside(center, a)


# -- whole numbers, angles, and the wrong one of several moves


def whole_half_sizes(a, b):
    """Dicts with a middle and half sizes, as a game keeps its sprites."""

    def sprite(ring):
        (x0, x1), (y0, y1) = ((min(c), max(c)) for c in zip(*ring))
        return {"x": (x0 + x1) // 2, "y": (y0 + y1) // 2, "half": ((x1 - x0) // 2, (y1 - y0) // 2)}

    s, t = sprite(a), sprite(b)
    return all(abs(s[k] - t[k]) <= s["half"][i] + t["half"][i] for i, k in enumerate("xy"))


def tidy_normals(a, b):
    """A printout of 0.4472135954999579 looked untidy."""
    for p in a, b:
        for (x1, y1), (x2, y2) in zip(p[-1:] + p, p):
            length = math.hypot(x2 - x1, y2 - y1)
            nx, ny = round((y2 - y1) / length, 1), round((x1 - x2) / length, 1)
            on_a, on_b = ([nx * x + ny * y for x, y in shape] for shape in (a, b))
            if max(on_a) < min(on_b) or max(on_b) < min(on_a):
                return False
    return True


def angle_plus_90(a, b):
    for p in a, b:
        for (x1, y1), (x2, y2) in zip(p[-1:] + p, p):
            angle = math.atan2(y2 - y1, x2 - x1) + 90
            on_a, on_b = ([x * math.cos(angle) + y * math.sin(angle) for x, y in shape] for shape in (a, b))
            if max(on_a) < min(on_b) or max(on_b) < min(on_a):
                return False
    return True


def separated(a, b):
    """Says whether there is a gap, and is called as if it said whether there is none."""
    return not all(Projection(a, n).overlaps(Projection(b, n)) for n in [*_directions(a), *_directions(b)])


def _overlaps_by_normal(a, b):
    """Yield for each edge how far the ranges overlap, and a normal of length 1 that leads from A to B."""
    for x, y in itertools.chain(_directions(a), _directions(b)):
        n = x / math.hypot(x, y), y / math.hypot(x, y)
        s, t = _scalar_projections(a, n), _scalar_projections(b, n)
        right, left = s[-1] - t[0], t[-1] - s[0]
        yield (right, n) if right < left else (left, (-n[0], -n[1]))


def argmax(a, b):
    found = list(_overlaps_by_normal(a, b))
    if min(found)[0] < 0:
        return False, None
    depth, n = max(found)
    return True, (n[0] * depth, n[1] * depth)


def the_last_is_kept(a, b):
    move = None
    for depth, n in _overlaps_by_normal(a, b):
        if depth <= 0:
            return None
        move = n[0] * depth, n[1] * depth
    return move


def shared_fairly(a, b):
    depth, n = min(_overlaps_by_normal(a, b))
    return (n[0] * depth / 2, n[1] * depth / 2) if depth > 0 else None


def divided_at_the_end(a, b):
    """Compares overlaps in units of normals of different lengths, and divides the least of them."""
    found = []
    for x, y in itertools.chain(_directions(a), _directions(b)):
        s, t = _scalar_projections(a, (x, y)), _scalar_projections(b, (x, y))
        found.append((min(s[-1] - t[0], t[-1] - s[0]), math.hypot(x, y)))
    depth, length = min(found)
    return max(0, depth / length)
