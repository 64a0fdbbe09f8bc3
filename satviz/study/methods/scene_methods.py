"""Ways from the raw arrays of one frame to all colliding pairs: satviz, other libraries, and rivals in numba."""

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ... import batch
from ...engine.shapes import Circle, Polygon, Shape
from .. import truth
from ..harness.machine import is_installed
from ..workloads.generators import Side
from ..workloads.moving import Frame, MovingScene
from . import installed_engines
from .libraries import tree_pairs

FindPairs = Callable[[Frame], Any]  # returns (K, 2) indices, or a set of pairs
# the largest number of shapes for which a slow method is timed
MAX_SHAPES = {"brute force": 10_000} | dict.fromkeys(("short sweep", "STRtree", "prepared STRtree", "Box2D"), 30_000)
# what the answers of a method leave out, as a sentence
DIFFERENCES = {
    "brute force": "Brute force and both sweeps are compiled by numba and round in float64.",
    "short sweep": "Short sweep is written in 40 lines; sort and sweep first copies shapes next to their neighbours.",
    "cKDTree": "cKDTree takes coins of one radius only.",
    "STRtree": "For STRtree a coin is a point with a distance, and a circle among polygons is a polygon of 32 corners.",
    "Box2D": "Box2D keeps its world between frames, rounds in float32 and counts gaps below 0.02 as touching. "
    "Its polygons have at most 8 corners, and its time includes the response to contacts.",
}
BOX2D_STEP = 2.0**-20  # seconds: nothing moves by itself in so short a time


def scene_methods(scene: MovingScene) -> dict[str, FindPairs]:
    """Return the methods that take the shapes of this scene and are installed here, by their names in the table."""
    found: dict[str, FindPairs] = {name: partial(_satviz_pairs, engine=engine) for name, engine in installed_engines()}
    if len(scene.shapes) > 1:  # with shapes of one kind, making a new batch is as fast as moving it
        for name, engine in installed_engines():
            found[f"{name}, moved"] = partial(_moved_pairs, shapes=batch_of(scene.frames[0].sides), engine=engine)
    counts = set(scene.frames[0].padded.counts.tolist())
    kind = counts.pop() if len(counts) == 1 else 0  # 1 for circles, 0 where it varies
    if is_installed("numba"):
        from .scene_rivals import colliding_pairs, short_sweep

        for name, sweep in (("brute force", False), ("sort and sweep", True)):
            found[name] = partial(_pairs_of_padded, find=partial(colliding_pairs, kind=kind, sweep=sweep))
        found["short sweep"] = partial(_pairs_of_padded, find=short_sweep(kind))
    if is_installed("shapely"):
        if kind == 1:
            found["STRtree"] = _tree_coin_pairs
        else:
            found["STRtree"] = partial(_tree_pairs, prepared=False)
            found["prepared STRtree"] = partial(_tree_pairs, prepared=True)
    if is_installed("scipy") and kind == 1:
        found["cKDTree"] = _kd_tree_pairs
    n = len(scene.frames[0].centers)
    if is_installed("pyb2d3") and n <= MAX_SHAPES["Box2D"]:
        found["Box2D"] = Box2DWorld(scene).pairs
    return {name: find for name, find in found.items() if n <= MAX_SHAPES.get(name, n)}


def batch_of(sides: Sequence[Side]) -> batch.Shapes:
    """Return the raw arrays of all kinds as one batch of satviz."""
    made = [batch.Circles(*side) if isinstance(side, tuple) else batch.Polygons(side) for side in sides]
    return batch.concat(made) if len(made) > 1 else made[0]


def _satviz_pairs(frame: Frame, engine: str) -> NDArray[np.intp]:
    """Return the (K, 2) pairs that satviz finds; shapes of several kinds are read from the padded arrays."""
    made = batch.from_padded(*frame.padded) if len(frame.sides) > 1 else batch_of(frame.sides)
    return batch.colliding_pairs(made, engine=engine)


def _moved_pairs(frame: Frame, shapes: batch.Shapes, engine: str) -> NDArray[np.intp]:
    """Move a batch, which is made only once, to the corners of a frame; return the (K, 2) pairs that satviz finds."""
    return batch.colliding_pairs(batch.move(shapes, frame.corners), engine=engine)


def _pairs_of_padded(frame: Frame, find: Callable[..., NDArray[np.int64]]) -> NDArray[np.int64]:
    """Return the (K, 2) pairs that a method of `scene_rivals` finds in a frame's padded arrays."""
    return find(*frame.padded)


def _tree_pairs(frame: Frame, prepared: bool) -> NDArray[np.intp]:
    """Return the (K, 2) pairs that shapely finds: by its STRtree on bounding boxes, then each pair tested once.

    This is quicker than a query with a predicate, which prepares the shapes by itself and tests each pair twice.
    """
    import shapely

    made = [shapely.buffer(shapely.points(s[0]), s[1]) if isinstance(s, tuple) else shapely.polygons(s)
            for s in frame.sides]  # fmt: skip
    shapes = np.concatenate(made)
    i, j = shapely.STRtree(shapes).query(shapes)
    once = i < j
    i, j = i[once], j[once]
    if prepared:
        shapely.prepare(shapes)
    hit = shapely.intersects(shapes[i], shapes[j])
    return np.stack([i[hit], j[hit]], axis=1)


def _tree_coin_pairs(frame: Frame) -> NDArray[np.intp]:
    """Return the pairs of coins of one radius that shapely finds: centers within two radii."""
    import shapely

    return tree_pairs(shapely.points(frame.centers), predicate="dwithin", distance=2 * frame.padded.radii[0])


def _kd_tree_pairs(frame: Frame) -> NDArray[np.intp]:
    """Return the pairs of coins of one radius that scipy's cKDTree finds: centers within two radii."""
    from scipy.spatial import cKDTree

    return np.asarray(cKDTree(frame.centers).query_pairs(2 * frame.padded.radii[0], output_type="ndarray"))


class Box2DWorld:
    """A world of Box2D v3 that holds a body for each shape of a scene, and the pairs that touch.

    It is used as in a game: bodies are made once, each frame sets their transforms and takes one step, and events say
    which contacts began and ended.
    """

    def __init__(self, scene: MovingScene) -> None:
        import pyb2d3 as box2d

        self.world, self.bodies, self.found = box2d.World(gravity=(0, 0)), box2d.Bodies(), set[tuple[int, int]]()
        how = box2d.shape_def(enable_contact_events=True)
        own = [shape for some in scene.shapes for shape in some]
        for number, (shape, center) in enumerate(zip(own, scene.frames[0].centers.tolist())):
            body = self.world.create_dynamic_body(position=tuple(center), enable_sleep=False)
            if shape.ndim:
                made = body.create_polygon_shape(how, box2d.polygon(points=shape.astype(np.float32)))
            else:
                made = body.create_circle_shape(how, box2d.circle(radius=float(shape)))
            made.user_data = number
            self.bodies.append(body.id)

    def pairs(self, frame: Frame) -> set[tuple[int, int]]:
        """Move the bodies to where they are in this frame, and return the pairs that touch."""
        self.bodies.set_transforms(np.hstack([frame.centers, frame.directions]).astype(np.float32))
        self.world.step(BOX2D_STEP, 1)
        events = self.world.get_contact_events()
        for event in events.end_events():
            self.found.discard((event.shape_a.user_data, event.shape_b.user_data))
        for event in events.begin_events():
            self.found.add((event.shape_a.user_data, event.shape_b.user_data))
        return self.found


class FrameJob:
    """A job that finds the pairs of both frames alternately, `repeats` times a call.

    `frame`: the number of the last frame (0 or 1), `answer`: the pairs that were found in it.
    """

    def __init__(self, find: FindPairs, scene: MovingScene, repeats: int) -> None:
        self.find, self.scene, self.repeats, self.frame = find, scene, repeats, 0

    def __call__(self) -> None:
        for _ in range(self.repeats):
            self.frame = 1 - self.frame
            self.answer = self.find(self.scene.frames[self.frame])


class FrameSample:
    """The true colliding pairs, `right`, among some shapes of a frame: those nearest to the field's lower left corner.

    `most`: how many shapes at most; `chosen`: their indices; `checked`: how many of their pairs were tested.
    """

    def __init__(self, frame: Frame, most: int) -> None:
        corners, counts, radii = frame.padded
        self.chosen = np.sort(np.argsort(frame.centers.max(axis=1))[:most])
        shapes: dict[int, Shape] = {
            i: Polygon(corners[i, : counts[i]]) if counts[i] > 1 else Circle(corners[i, 0], radii[i])
            for i in self.chosen
        }
        reach = radii[self.chosen, None] * (1 + 1e-9)
        low, high = corners[self.chosen].min(axis=1) - reach, corners[self.chosen].max(axis=1) + reach
        meet = ((low[:, None] <= high) & (low <= high[:, None])).all(axis=2)
        tested = self.chosen[np.argwhere(np.triu(meet, 1))].tolist()
        self.checked = len(tested)
        self.right = {(i, j) for i, j in tested if truth.agreed(shapes[i], shapes[j])}

    def wrong(self, answer: Any) -> int:
        """Return the number of mistakes of an answer in the sample: missing pairs plus wrong pairs."""
        pairs = np.array(list(answer) if isinstance(answer, set) else answer, dtype=np.intp).reshape(-1, 2)
        own = pairs[np.isin(pairs, self.chosen).all(axis=1)]
        return len(self.right ^ set(map(tuple, np.sort(own, axis=1).tolist())))
