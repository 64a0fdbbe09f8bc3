"""Resting contact: a box that slides as prescribed, and what each method tells of it frame by frame.

No bodies and no solver: the poses are given, rounded to floats.  A solver would be fed the normal and the depth.
"""

from typing import Any

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from ... import batch
from ...pictures import Theme
from ..harness.cells import Cell, Settings
from ..harness.chart import Chart, add_axes, draw_headline, draw_table
from ..workloads.generators import Array, Rings

Row = dict[str, Any]
# the floor's slope, about 0.3 radians: coordinates are rounded on it, as in any turned scene
COS, SIN = 0.955336489125606, 0.2955202066613396
ORIGIN = 3.7, 1.9  # the origin of a scene is nowhere special
DEPTH = 0.001  # of a box that has sunk in a little
KEEP_WITHIN = 0.01  # another axis must be shallower by this, of scene units, before a kept one is left
SHAKE_LENGTH = 1e-5
SAME_NORMAL_COSINE = 0.9  # the cosine between the normals of neighbouring frames below which they are two

ON, IN, OVER, AT = "touching the floor", "sunk in a little", "sliding over a seam", "standing at a seam"
MEASURES = (
    (ON, "apart", "frames seen apart"),
    (ON, "wrong", "wrong verdicts"),
    (IN, "apart", "frames seen apart"),
    (IN, "noise", "depth off by"),
    (OVER, "sideways", "pushes sideways"),
    (AT, "flips", "flips of the normal"),
)


def _box(x: Array, y: float, half: tuple[float, float]) -> Rings:
    """Boxes with their lower sides at height y over the slope's origin, turned with the slope."""
    corners = [(-half[0], 0.0), (half[0], 0.0), (half[0], 2 * half[1]), (-half[0], 2 * half[1])]
    s = np.stack([x + u for u, _ in corners], axis=1)
    t = np.stack([np.full(len(x), y + v) for _, v in corners], axis=1)
    return np.stack([ORIGIN[0] + COS * s - SIN * t, ORIGIN[1] + SIN * s + COS * t], axis=2)


def _tile(low: float, high: float) -> Rings:
    return _box(np.array([(low + high) / 2]), -1.0, ((high - low) / 2, 0.5))


def scenes(frames: int, rng: np.random.Generator) -> dict[str, tuple[list[Rings], Rings]]:
    """By name: the tiles of the floor, and the box frame by frame."""
    x, half = np.linspace(-1.5, 1.5, frames), (0.5, 0.25)
    floor, tiles = [_tile(-8.0, 8.0)], [_tile(-8.0, 0.0), _tile(0.0, 8.0)]
    # it stands still, DEPTH over the second tile's rim and DEPTH deep, but for a shake
    still = DEPTH - half[0] + rng.uniform(-SHAKE_LENGTH, SHAKE_LENGTH, frames)
    return {
        ON: (floor, _box(x, 0.0, half)),
        IN: (floor, _box(x, -DEPTH, half)),
        OVER: (tiles, _box(x, -DEPTH, half)),
        AT: (tiles, _box(still, -DEPTH, half)),
    }


def gaps_on_normals(floor: Rings, boxes: Rings, dtype: type) -> tuple[Array, Array, Array]:
    """(F, 8) gaps on all edge normals, those edges' lengths, and (F, 8, 2) unit normals towards the box."""
    a: NDArray[Any] = np.broadcast_to(floor, boxes.shape).astype(dtype)
    b: NDArray[Any] = boxes.astype(dtype)
    found, lengths, ways = [], [], []
    for ring in (a, b):
        edge = np.roll(ring, -1, axis=1) - ring
        normal = np.stack([edge[..., 1], -edge[..., 0]], axis=2)
        length = np.sqrt((normal * normal).sum(axis=2, keepdims=True))
        normal = normal / length
        on_a, on_b = (normal @ np.swapaxes(side, 1, 2) for side in (a, b))
        ahead, behind = on_b.min(axis=2) - on_a.max(axis=2), on_a.min(axis=2) - on_b.max(axis=2)
        found.append(np.maximum(ahead, behind))
        lengths.append(length[..., 0])
        ways.append(np.where((ahead >= behind)[..., None], normal, -normal))
    gap, length, way = (np.concatenate(each, axis=1).astype(float) for each in (found, lengths, ways))
    return gap, length, way


def contact_axes(gap: Array, *, kept: bool) -> NDArray[np.intp]:
    """The axis of least depth in each frame; `kept`: the last frame's, unless another is shallower by some way."""
    best: NDArray[np.intp] = gap.argmax(axis=1)
    if kept:
        for i in range(1, len(best)):
            last = best[i - 1]
            if gap[i - 1].max() <= 0 and gap[i, best[i]] - gap[i, last] <= KEEP_WITHIN:
                best[i] = last
    return best


# (numbers, do normals keep their edges' lengths, is the verdict exact)
METHOD_OPTIONS: dict[str, tuple[type, bool, bool]] = {
    "satviz": (np.float64, False, True),
    "SAT, unit normals": (np.float64, False, False),
    "SAT, raw normals": (np.float64, True, False),
    "SAT, float32": (np.float32, False, False),
}


def measure_contacts(frames: int, settings: Settings) -> list[Row]:
    """Each method in each scene, with the last axis kept and without.

    `apart`: frames in which it sees no contact; `flips`: of the normal between neighbouring frames of contact;
    `sideways`: contacts whose normal is not the floor's; `noise`: how far the depth is off at most where it is.
    """
    rows, up = [], np.array([-SIN, COS])
    for scene, (tiles, boxes) in scenes(frames, settings.rng("resting")).items():
        exact = [
            batch.relate(batch.Polygons(np.repeat(t, frames, axis=0)), batch.Polygons(boxes.copy())) for t in tiles
        ]
        for name, (dtype, raw, sure) in METHOD_OPTIONS.items():
            every = [gaps_on_normals(tile, boxes, dtype) for tile in tiles]
            for kept in (False, True):
                hits = [
                    right > 0 if sure else gap.max(axis=1) <= 0 for (gap, _, _), right in zip(every, exact, strict=True)
                ]
                row: Row = {"scene": scene, "method": name, "kept": kept, "frames": frames, "flips": 0, "sideways": 0}
                row["apart"] = int((~np.any(hits, axis=0)).sum())
                row["wrong"] = sum(int((hit != (right > 0)).sum()) for hit, right in zip(hits, exact, strict=True))
                row["apart_in_truth"] = int((np.max(exact, axis=0) == 0).sum())
                noise = [0.0]
                for hit, (gap, length, way) in zip(hits, every, strict=True):
                    axis = contact_axes(gap * length if raw else gap, kept=kept)
                    normal, depth = way[np.arange(frames), axis], -gap[np.arange(frames), axis]
                    together, level = hit[1:] & hit[:-1], normal @ up > SAME_NORMAL_COSINE
                    row["flips"] += int(((normal[1:] * normal[:-1]).sum(axis=1)[together] < SAME_NORMAL_COSINE).sum())
                    row["sideways"] += int((hit & ~level).sum())
                    noise += np.abs(depth[hit & level] - (0.0 if scene == ON else DEPTH)).tolist()
                rows.append({**row, "noise": max(noise)})
    return rows


def cells(settings: Settings) -> list[Cell]:
    """One: all scenes."""
    return [Cell("resting", measure_contacts, (1000 if settings.quick else 10_000, settings))]


def charts(found: dict[str, Any], settings: Settings) -> list[Chart]:
    """A row a scene with what goes wrong there, a column a method without and with the last axis kept."""
    rows: list[Row] = found["resting"]
    of = {(row["scene"], row["method"], row["kept"]): row for row in rows}
    frames = rows[0]["frames"]
    title = "A resting box: rounded poses flicker for exact verdicts too; some depth and the last axis kept calm it"
    columns = [(name, k) for name in METHOD_OPTIONS for k in (False, True)]
    size = 880.0, 300.0

    def draw(fig: Figure, theme: Theme) -> None:
        under = f"a box on a slope, {frames:,} prescribed frames; kept: the last axis, unless another is better by {KEEP_WITHIN}"
        draw_headline(fig, theme, title, under)
        ax = add_axes(fig, (0.33, 0.04, 0.66, 0.6), theme)

        def cell(y: int, x: int) -> tuple[str, str, float]:
            (scene, key, _), (name, k) = MEASURES[y], columns[x]
            value = of[scene, name, k][key]
            if key == "noise":
                return f"{value:.0e}", theme.roles["wrong"], (float(np.log10(max(value, 1e-17))) + 17) / 14
            return f"{value:,}", theme.roles["wrong"], value / frames

        heads = [f"{name}{', kept' if k else ''}".replace(", ", ",\n") for name, k in columns]
        draw_table(ax, theme, heads, [f"{scene}: {words}" for scene, _, words in MEASURES], cell)

    touching, seam = of[ON, "satviz", False], of[OVER, "satviz", False]
    unit, short = of[IN, "SAT, unit normals", False]["noise"], of[IN, "SAT, float32", False]["noise"]
    flips = {name: (of[AT, name, False]["flips"], of[AT, name, True]["flips"]) for name in METHOD_OPTIONS}
    told = ", ".join(f"{loose:,} times ({name}; kept: {kept:,})" for name, (loose, kept) in flips.items())
    text = (
        f"Meant to touch, the box is apart in {touching['apart_in_truth']:,} of {frames:,} frames, as its corners are "
        f"rounded: exact verdicts see that, unit normals see {of[ON, 'SAT, unit normals', False]['apart']:,} frames "
        f"apart, and no verdict can mend it. Sunk in by {DEPTH} it is apart in none, and the depth is off by at most "
        f"{unit:.0e}, in float32 by {short:.0e}. Over a seam the second tile pushes sideways in {seam['sideways']} "
        f"frames, and in {of[OVER, 'satviz', True]['sideways']} with the last axis kept, for the first contact was "
        f"sideways. Standing where both ways out are as long, the normal flips {told}."
    )
    return [Chart("resting-contact", title, size, draw, rows, text)]
