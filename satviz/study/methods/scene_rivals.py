"""Rival ways from the raw arrays of a scene to its colliding pairs, compiled with numba and written to be fast.

They are what somebody writes who needs no exact answer: sort and sweep (Ericson, Real-Time Collision Detection, 7.5) or
all pairs, boxes first, then SAT in float64 on normals of any length.  Shapes come as padded arrays, so no time goes
into another form:
    corners   (N, V, 2), counter-clockwise; a shape with fewer corners repeats its last one, a circle its center
    counts    (N,) numbers of corners; 1 for a circle
    radii     (N,) radii of circles; 0 for polygons
The bounds of boxes are rows (low x, high x, low y, high y).  A kernel for one kind of shape has constant loops, which
the compiler unrolls.
"""

from collections.abc import Callable
from functools import cache

import numpy as np
from numpy.typing import NDArray

from ...batch.with_numba.jit_cache import compiled, inlined

Array = NDArray[np.float64]
Ints = NDArray[np.int64]
CIRCLES, MIXED = 1, 0  # kinds of scenes beside the number of corners, if that is the same for all shapes
PAIRS_A_SHAPE = 4  # the output has space for so many before it grows
WORD = 8  # bytes of a mask that are read at once


def colliding_pairs(corners: Array, counts: Ints, radii: Array, *, kind: int, sweep: bool) -> Ints:
    """Return the (K, 2) pairs that collide by floats, by sort and sweep or by testing the boxes of all pairs.

    `kind`: the number of corners of all shapes, or CIRCLES or MIXED.
    """
    bounds = bounds_of(corners, radii)
    order = np.argsort(bounds[0]) if sweep else np.arange(len(corners))  # numpy's argsort is quicker than numba's
    return _scene_kernel(kind, sweep)(bounds, order, corners, counts, radii)


@compiled
def bounds_of(corners: Array, radii: Array) -> Array:
    """Return the (4, N) bounding boxes of the shapes: low x, high x, low y, high y."""
    bounds = np.empty((4, len(corners)))
    for i in range(len(corners)):
        x0 = x1 = corners[i, 0, 0]
        y0 = y1 = corners[i, 0, 1]
        for v in range(1, corners.shape[1]):
            x0, x1 = min(x0, corners[i, v, 0]), max(x1, corners[i, v, 0])
            y0, y1 = min(y0, corners[i, v, 1]), max(y1, corners[i, v, 1])
        bounds[0, i], bounds[1, i], bounds[2, i], bounds[3, i] = (
            x0 - radii[i],
            x1 + radii[i],
            y0 - radii[i],
            y1 + radii[i],
        )
    return bounds


@cache
def _scene_kernel(kind: int, sweep: bool) -> Callable[..., Ints]:
    """Return the compiled search for colliding pairs; `kind` and `sweep` as in `colliding_pairs`."""

    @compiled
    def kernel(bounds: Array, order: Ints, corners: Array, counts: Ints, radii: Array) -> Ints:
        """Return the (K, 2) colliding pairs; `order`: the shapes in the order in which they are compared.

        Shapes are first copied into this order, so that neighbours lie close by in memory.
        """
        n = len(order)
        x0, x1, y0, y1 = np.empty(n), np.empty(n), np.empty(n), np.empty(n)
        near, near_counts, near_radii = np.empty_like(corners), np.empty_like(counts), np.empty_like(radii)
        for k in range(n):
            i = order[k]
            x0[k], x1[k], y0[k], y1[k] = bounds[0, i], bounds[1, i], bounds[2, i], bounds[3, i]
            near_counts[k], near_radii[k] = counts[i], radii[i]
            for v in range(corners.shape[1]):
                near[k, v, 0], near[k, v, 1] = corners[i, v, 0], corners[i, v, 1]
        ends = np.searchsorted(x0, x1, side="right") if sweep else np.full(n, n)
        mask = np.empty((n // WORD + 1) * WORD, np.uint8)
        words, met = mask.view(np.uint64), np.empty(n + WORD, np.int64)
        found, total = np.empty((PAIRS_A_SHAPE * n, 2), np.int64), 0
        for i in range(n):
            first, width = i + 1, ends[i] - i - 1
            a0, a1, b0, b1 = x0[i], x1[i], y0[i], y1[i]
            for k in range(width):  # no branch: the compiler vectorises it
                j = first + k
                in_y = (y0[j] <= b1) & (y1[j] >= b0)
                mask[k] = in_y if sweep else in_y & (x0[j] <= a1) & (x1[j] >= a0)
            used = (width + WORD - 1) // WORD
            mask[width : used * WORD] = 0
            many = 0
            for w in range(used):
                if words[w]:
                    for k in range(w * WORD, w * WORD + WORD):
                        met[many] = first + k
                        many += mask[k]
            if total + many > len(found):
                found = np.concatenate((found, np.empty((len(found) + many, 2), np.int64)))
            for k in range(many):
                one, other = order[i], order[met[k]]
                found[total, 0], found[total, 1] = min(one, other), max(one, other)
                if kind == CIRCLES:
                    total += circles_hit(near, near_radii, i, met[k])
                elif kind == MIXED:
                    total += mixed_hit(near, near_counts, near_radii, i, met[k])
                else:
                    total += polygons_hit(near, i, met[k], kind)
        return found[:total]

    return kernel


@cache
def short_sweep(kind: int) -> Callable[[Array, Ints, Array], Ints]:
    """Return a kernel for sort and sweep as one writes it in some 40 lines: boxes, sorted along x, then pair by pair.

    Shapes stay where they lie, and nothing is marked ahead: this is quicker for few shapes and slower for many.
    """

    @compiled
    def kernel(corners: Array, counts: Ints, radii: Array) -> Ints:
        """Return the (K, 2) colliding pairs."""
        n = len(corners)
        boxes = np.empty((n, 4))
        for i in range(n):
            x0 = x1 = corners[i, 0, 0]
            y0 = y1 = corners[i, 0, 1]
            for v in range(1, corners.shape[1]):
                x, y = corners[i, v, 0], corners[i, v, 1]
                x0, x1, y0, y1 = min(x0, x), max(x1, x), min(y0, y), max(y1, y)
            r = radii[i]
            boxes[i, 0], boxes[i, 1], boxes[i, 2], boxes[i, 3] = x0 - r, x1 + r, y0 - r, y1 + r
        order = np.argsort(boxes[:, 0])
        boxes = boxes[order]
        pairs, found = np.empty((PAIRS_A_SHAPE * n, 2), np.int64), 0
        for a in range(n):
            for b in range(a + 1, n):
                if boxes[b, 0] > boxes[a, 1]:
                    break
                if boxes[b, 2] > boxes[a, 3] or boxes[a, 2] > boxes[b, 3]:
                    continue
                i, j = order[a], order[b]
                if kind == CIRCLES:
                    hit = circles_hit(corners, radii, i, j)
                elif kind == MIXED:
                    hit = mixed_hit(corners, counts, radii, i, j)
                else:
                    hit = polygons_hit(corners, i, j, kind)
                if hit:
                    if found == len(pairs):
                        pairs = np.concatenate((pairs, np.empty_like(pairs)))
                    pairs[found, 0], pairs[found, 1] = min(i, j), max(i, j)
                    found += 1
        return pairs[:found]

    return kernel


@inlined
def polygons_hit(vertices: Array, i: int, j: int, corners: int) -> bool:
    """Return whether polygons i and j hit: no edge of either has all vertices of the other beyond it."""
    return bool(max(_clearance(vertices, i, j, corners), _clearance(vertices, j, i, corners)) <= 0)


@inlined
def _clearance(vertices: Array, i: int, j: int, corners: int) -> float:
    """Return the largest distance of polygon j from an edge of polygon i, each times its edge's length.

    vertices: (N, corners, 2), counter-clockwise.  Positive: polygon j lies wholly beyond an edge of i.
    """
    best = -np.inf
    for e in range(corners):
        f = (e + 1) % corners
        ex, ey = vertices[i, e, 0], vertices[i, e, 1]
        nx, ny = vertices[i, f, 1] - ey, ex - vertices[i, f, 0]
        least = np.inf
        for v in range(corners):
            least = min(least, nx * vertices[j, v, 0] + ny * vertices[j, v, 1])
        best = max(best, least - (nx * ex + ny * ey))
    return best


@compiled
def circles_hit(corners: Array, radii: Array, i: int, j: int) -> bool:
    """Return whether two circles hit: their centers are no further apart than the sum of their radii."""
    dx, dy = corners[j, 0, 0] - corners[i, 0, 0], corners[j, 0, 1] - corners[i, 0, 1]
    reach = radii[i] + radii[j]
    return bool(dx * dx + dy * dy <= reach * reach)


@compiled
def mixed_hit(corners: Array, counts: Ints, radii: Array, i: int, j: int) -> bool:
    """Return whether shapes i and j hit, each a polygon or a circle."""
    if counts[i] == 1 and counts[j] == 1:
        return circles_hit(corners, radii, i, j)
    reach = radii[i] + radii[j]
    for p, q in ((i, j), (j, i)):
        if counts[p] == 1:  # p is a circle and q a polygon: test the axis from the nearest corner to the center
            cx, cy, least, nx, ny = corners[p, 0, 0], corners[p, 0, 1], np.inf, 0.0, 0.0
            for v in range(counts[q]):
                dx, dy = cx - corners[q, v, 0], cy - corners[q, v, 1]
                if dx * dx + dy * dy < least:
                    least, nx, ny = dx * dx + dy * dy, dx, dy
            gap = np.inf
            for v in range(counts[q]):
                gap = min(gap, nx * (cx - corners[q, v, 0]) + ny * (cy - corners[q, v, 1]))
            if gap > 0 and gap * gap > reach * reach * (nx * nx + ny * ny):
                return False
            continue
        for e in range(counts[p]):
            f = e + 1 if e + 1 < counts[p] else 0
            ex, ey = corners[p, e, 0], corners[p, e, 1]
            nx, ny = corners[p, f, 1] - ey, ex - corners[p, f, 0]
            gap = np.inf
            for v in range(counts[q]):
                gap = min(gap, nx * (corners[q, v, 0] - ex) + ny * (corners[q, v, 1] - ey))
            if gap > 0 and gap * gap > reach * reach * (nx * nx + ny * ny):
                return False
    return True
