"""Shapes and helpers that several tests of batches share."""

import importlib
import pickle
from concurrent.futures import Executor, Future
from pathlib import Path

import numpy as np
import pytest

import satviz as sv
from satviz import batch
from satviz.batch import arrays, with_numba

ENGINES = ["numpy", "numba"]
ELL = np.array([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)])
RNG = np.random.default_rng


def ngons(rng, n, v, spread=1.5):
    center = rng.uniform(-spread, spread, (n, 1, 2))
    turns = np.sort(rng.uniform(0, 2 * np.pi, (n, v)), axis=1)
    return center + np.stack([np.cos(turns), np.sin(turns)], axis=2)


def regular(rng, n, v, spread=0.1):
    """Return regular polygons of one size, rotated by random angles."""
    turns = rng.uniform(0, 2 * np.pi, (n, 1)) + 2 * np.pi * np.arange(v) / v
    return rng.uniform(-spread, spread, (n, 1, 2)) + np.stack([np.cos(turns), np.sin(turns)], axis=2)


def kernels_of(name):
    """Return a module of numba kernels; skip the test if numba is not installed."""
    pytest.importorskip("numba", reason="needs numba: python -m pip install '.[fast]'")
    return importlib.import_module(f"satviz.batch.with_numba.{name}")


def in_python(kernel):
    """Return a kernel as a Python function, which reads the globals of its module at each call."""
    return getattr(kernel, "py_func", kernel)


def numba_modules():
    """Return the modules of numba's kernels."""
    return [kernels_of(path.stem) for path in sorted(Path(with_numba.__file__).parent.glob("[!_]*.py"))]


def as_python(monkeypatch, module, *names):
    """Replace the kernels with these names, and each kernel that uses one of them, by their Python functions.

    No kernel that is left compiled then names what a test replaces: compiled for the first time in that test, it
    would fail, or be kept on disk with the value that the test put there.
    """
    replaced = {id(getattr(module, name)) for name in names}
    while calling := {id(k) for k in compiled_kernels() if id(k) not in replaced and names_any(k, replaced)}:
        replaced |= calling
    for m in numba_modules():
        for name, value in [*vars(m).items()]:
            if id(value) in replaced:
                monkeypatch.setattr(m, name, in_python(value))


def compiled_kernels():
    """Return the compiled functions in the modules of numba kernels."""
    return [value for m in numba_modules() for value in vars(m).values() if hasattr(value, "py_func")]


def names_any(kernel, values):
    """Return whether a kernel uses any of these values of its module, given by id."""
    function = in_python(kernel)
    return any(id(function.__globals__.get(name)) in values for name in function.__code__.co_names)


def circles(rng, n, spread=2.0):
    return batch.Circles(rng.uniform(-spread, spread, (n, 2)), rng.uniform(0.1, 1, n))


def scalar(shapes):
    """Return the shapes of a batch as scalar shapes, in order."""
    found = []
    for v, slot in zip(shapes.count.tolist(), shapes.slot.tolist()):
        group = shapes.groups[v]
        x, y = group.x[:, slot], group.y[:, slot]
        found.append(sv.Circle((x[0], y[0]), group.r[slot]) if v == 1 else sv.Polygon(np.stack([x, y], axis=1)))
    return found


def one_by_one(a, b):
    return [sv.relate(p, q) for p, q in zip(scalar(a), scalar(b))]


def batches_of(known):
    """Return scalar convex shapes as one mixed batch, in order."""
    return batch.concat(
        [batch.Circles([s.center], [s.radius]) if isinstance(s, sv.Circle) else batch.Polygons([s]) for s in known]
    )


def beside_mirror(v, w):
    """Return 60 shapes and 60 others: the rightmost corner of each first one is on the leftmost corner of its other."""
    a, b = (np.round(ngons(RNG(v * w), 60, k) * 2.0**40) for k in (v, w))
    wall = a[:, :, 0].max(axis=1)
    low = b[:, :, 0].min(axis=1)
    corner = a[np.arange(60), a[:, :, 0].argmax(axis=1), 1] - b[np.arange(60), b[:, :, 0].argmin(axis=1), 1]
    return a, b + np.stack([wall - low, corner], axis=1)[:, None]


def tiles(edge, coordinate):
    """Return a group without real shapes that has these tile maxima."""
    return arrays.CornerColumns(np.zeros((2, 3, 1)), np.array([edge, coordinate]))


TRIPLES = np.array([(3, 4, 5), (5, 12, 13), (8, 15, 17), (20, 21, 29), (-9, 40, 41)], float)


def turned(vectors):
    return np.stack([vectors[..., 1], -vectors[..., 0]], axis=-1)


def resting_exactly(rng, n, bits=10):
    """Return circles that exactly touch a triangle on a grid, at a right-angled corner or at the middle of an edge.

    The edges run along Pythagorean triples.
    """
    x, y, z = TRIPLES[rng.integers(0, len(TRIPLES), n)].T
    along = np.stack([x, y], axis=1)
    p = rng.integers(-(2**bits), 2**bits, (n, 2)).astype(float)
    k, m = rng.integers(1, 2**bits, (2, n, 1)).astype(float)
    q = p + 2 * k * along
    o = p + k * along - turned(along) * rng.integers(1, 5, (n, 1)) * k + along * rng.integers(-1, 2, (n, 1)) * k
    centers = np.where(rng.random((n, 1)) < 0.5, p + k * along + m * turned(along), q + m * along)
    return centers, z * m[:, 0], np.stack([p, q, o], axis=1)


def resting_on_boxes(rng, n):
    """Return circles that touch boxes from below, mirrored and rotated to each of the four sides."""
    low = rng.uniform(-2, 2, (n, 2))
    high = low + rng.uniform(0.1, 3, (n, 2))
    corners = [low, np.c_[high[:, 0], low[:, 1]], high, np.c_[low[:, 0], high[:, 1]]]
    centers = np.c_[low[:, 0] + rng.uniform(0, 1, n) * (high - low)[:, 0], low[:, 1] - rng.uniform(0.1, 1, n)]
    mirror, swap = rng.choice([-1.0, 1.0], (n, 1, 2)), rng.random((n, 1, 1)) < 0.5
    points = np.stack([centers, *corners], axis=1) * mirror
    points = np.where(swap, points[..., ::-1], points)
    return points[:, 0], low[:, 1] - centers[:, 1], points[:, 1:]


def jolt(rng, values, most):
    """Return the values, each moved up or down by at most `most` floats."""
    steps = rng.integers(-most, most + 1, values.shape)
    for k in range(1, most + 1):
        values = np.where(np.abs(steps) >= k, np.nextafter(values, np.where(steps > 0, np.inf, -np.inf)), values)
    return values


def a_float_off(make):
    def made(rng, n):
        centers, radii, rings = make(rng, n)
        return jolt(rng, centers, 1), jolt(rng, radii, 1), rings

    return made


def moved(make):
    """Return a function that scales the shapes of `make` by 2**-300 to 2**300, or shifts and so rounds them."""

    def made(rng, n):
        made = make(rng, n)
        scale, shift = 2.0 ** rng.integers(-300, 301, n), 2.0 ** rng.integers(0, 41, n)
        scale, shift = np.where(rng.random(n) < 0.5, (scale, 0 * shift), (np.ones(n), shift))
        return tuple((c.T * scale + (0 if c.ndim == 1 else shift)).T for c in made)

    return made


def batches_from(made):
    centers, radii, rings = made
    return batch.Circles(centers, radii), batch.Polygons(rings.copy())


class Elsewhere(Executor):
    """An executor that runs each task at once on a pickled copy, as another process would, and keeps what was sent."""

    def __init__(self):
        self.sent = []

    def submit(self, function, *args):
        self.sent.append(pickle.dumps((function, args)))
        function, args = pickle.loads(self.sent[-1])
        future = Future()
        future.set_result(function(*args))
        return future
