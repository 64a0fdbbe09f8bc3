"""Resting contact: a box slides along a given path, and each method's contact is measured frame by frame.

There are no bodies and no solver: the poses are given, rounded to floats.  A solver would get the normal and the depth.
"""

from typing import Any

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from ... import batch
from ...pictures import Theme
from ..harness.cells import Cell, JsonRow, Settings
from ..harness.chart import Chart, add_axes, draw_headline, draw_table
from ..workloads.generators import Array, Rings

# cosine and sine of the slope of the floor, 0.3 radians, on which coordinates are rounded as in any turned scene
COS, SIN = 0.955336489125606, 0.2955202066613396
ORIGIN = 3.7, 1.9  # of the slope, off the origin of the coordinates
DEPTH = 0.001  # of a box that has sunk in a little, in scene units
KEEP_WITHIN = 0.01  # the last axis is kept unless another is shallower by more than this, in scene units
SHAKE_LENGTH = 1e-5  # in scene units
SAME_NORMAL_COSINE = 0.9  # normals with a smaller cosine between them are two normals

ON, IN, OVER, AT = "touching the floor", "sunk in a little", "sliding over a seam", "standing at a seam"
MEASURES = (  # (scene, column of the rows, words): the rows of the chart
    (ON, "apart", "frames seen apart"),
    (ON, "wrong", "wrong verdicts"),
    (IN, "apart", "frames seen apart"),
    (IN, "noise", "depth off by"),
    (OVER, "sideways", "pushes sideways"),
    (AT, "flips", "flips of the normal"),
)


def _box(x: Array, y: float, half: tuple[float, float]) -> Rings:
    """Return boxes on the slope, middles at x along it, lower sides at height y above it; `half`: half sizes."""
    corners = [(-half[0], 0.0), (half[0], 0.0), (half[0], 2 * half[1]), (-half[0], 2 * half[1])]
    s = np.stack([x + u for u, _ in corners], axis=1)
    t = np.stack([np.full(len(x), y + v) for _, v in corners], axis=1)
    return np.stack([ORIGIN[0] + COS * s - SIN * t, ORIGIN[1] + SIN * s + COS * t], axis=2)


def _tile(low: float, high: float) -> Rings:
    """Return one floor tile from `low` to `high` along the slope; its upper side lies at height 0."""
    return _box(np.array([(low + high) / 2]), -1.0, ((high - low) / 2, 0.5))


def scenes(frames: int, rng: np.random.Generator) -> dict[str, tuple[list[Rings], Rings]]:
    """Return by name of the scene the tiles of its floor and the (F, 4, 2) box, one for each frame."""
    x, half = np.linspace(-1.5, 1.5, frames), (0.5, 0.25)
    floor, tiles = [_tile(-8.0, 8.0)], [_tile(-8.0, 0.0), _tile(0.0, 8.0)]
    # but for a shake the box stands still, DEPTH beyond the side of the second tile and DEPTH deep in the floor
    still = DEPTH - half[0] + rng.uniform(-SHAKE_LENGTH, SHAKE_LENGTH, frames)
    return {
        ON: (floor, _box(x, 0.0, half)),
        IN: (floor, _box(x, -DEPTH, half)),
        OVER: (tiles, _box(x, -DEPTH, half)),
        AT: (tiles, _box(still, -DEPTH, half)),
    }


def gaps_on_normals(floor: Rings, boxes: Rings, dtype: type) -> tuple[Array, Array, Array]:
    """Return (F, 8) gaps of a tile and the box on their edge normals, edge lengths, and normals to the box."""
    a: NDArray[Any] = np.broadcast_to(floor, boxes.shape).astype(dtype)
    b: NDArray[Any] = boxes.astype(dtype)
    gaps, lengths, normals = [], [], []
    for ring in (a, b):
        edge = np.roll(ring, -1, axis=1) - ring
        normal = np.stack([edge[..., 1], -edge[..., 0]], axis=2)
        length = np.sqrt((normal * normal).sum(axis=2, keepdims=True))
        normal = normal / length
        on_a, on_b = (normal @ np.swapaxes(side, 1, 2) for side in (a, b))
        ahead, behind = on_b.min(axis=2) - on_a.max(axis=2), on_a.min(axis=2) - on_b.max(axis=2)
        gaps.append(np.maximum(ahead, behind))
        lengths.append(length[..., 0])
        normals.append(np.where((ahead >= behind)[..., None], normal, -normal))
    gap, length, towards = (np.concatenate(parts, axis=1).astype(float) for parts in (gaps, lengths, normals))
    return gap, length, towards


def contact_axes(gap: Array, *, kept: bool) -> NDArray[np.intp]:
    """Return each frame's axis of least depth, as an index; `kept`: keep the last one unless it is much deeper."""
    best: NDArray[np.intp] = gap.argmax(axis=1)
    if kept:
        for i in range(1, len(best)):
            last = best[i - 1]
            if gap[i - 1].max() <= 0 and gap[i, best[i]] - gap[i, last] <= KEEP_WITHIN:
                best[i] = last
    return best


# (number format, whether normals keep the lengths of their edges, whether the verdict is exact)
METHOD_OPTIONS: dict[str, tuple[type, bool, bool]] = {
    "satviz": (np.float64, False, True),
    "SAT, unit normals": (np.float64, False, False),
    "SAT, raw normals": (np.float64, True, False),
    "SAT, float32": (np.float32, False, False),
}


def measure_contacts(frames: int, settings: Settings) -> list[JsonRow]:
    """Return a row for each scene, method and choice of axis (the shallowest, or the last one kept).

    `apart`: frames in which the method sees no contact.  `apart_in_truth`: frames in which there is none.  `wrong`:
    wrong verdicts.  `flips`: changes of the normal between neighbouring frames of contact.  `sideways`: contacts whose
    normal is not that of the floor.  `noise`: the largest error of the depth at the other contacts.
    """
    rows, up = [], np.array([-SIN, COS])
    for scene, (tiles, boxes) in scenes(frames, settings.rng("resting")).items():
        exact = [
            batch.relate(batch.Polygons(np.repeat(t, frames, axis=0)), batch.Polygons(boxes.copy())) for t in tiles
        ]
        for name, (dtype, raw, is_exact) in METHOD_OPTIONS.items():
            contacts = [gaps_on_normals(tile, boxes, dtype) for tile in tiles]
            for kept in (False, True):
                hits = [
                    right > 0 if is_exact else gap.max(axis=1) <= 0
                    for (gap, _, _), right in zip(contacts, exact, strict=True)
                ]
                row: JsonRow = {
                    "scene": scene,
                    "method": name,
                    "kept": kept,
                    "frames": frames,
                    "flips": 0,
                    "sideways": 0,
                }
                row["apart"] = int((~np.any(hits, axis=0)).sum())
                row["wrong"] = sum(int((hit != (right > 0)).sum()) for hit, right in zip(hits, exact, strict=True))
                row["apart_in_truth"] = int((np.max(exact, axis=0) == 0).sum())
                noise = [0.0]
                for hit, (gap, length, towards) in zip(hits, contacts, strict=True):
                    axis = contact_axes(gap * length if raw else gap, kept=kept)
                    normal, depth = towards[np.arange(frames), axis], -gap[np.arange(frames), axis]
                    in_contact, upward = hit[1:] & hit[:-1], normal @ up > SAME_NORMAL_COSINE
                    row["flips"] += int(((normal[1:] * normal[:-1]).sum(axis=1)[in_contact] < SAME_NORMAL_COSINE).sum())
                    row["sideways"] += int((hit & ~upward).sum())
                    noise += np.abs(depth[hit & upward] - (0.0 if scene == ON else DEPTH)).tolist()
                rows.append({**row, "noise": max(noise)})
    return rows


def cells(settings: Settings) -> list[Cell]:
    """Return one cell, which measures the contacts of every method in all scenes."""
    return [Cell("resting", measure_contacts, (1000 if settings.quick else 10_000, settings))]


def charts(found: dict[str, Any], settings: Settings) -> list[Chart]:
    """Return one chart, a table: a row for each scene and measure, and two columns for each method."""
    rows: list[JsonRow] = found["resting"]
    measured = {(row["scene"], row["method"], row["kept"]): row for row in rows}
    frames = rows[0]["frames"]
    title = "A resting box: contact flickers even with exact verdicts; a little depth and keeping the last axis help"
    columns = [(name, k) for name in METHOD_OPTIONS for k in (False, True)]
    size = 880.0, 300.0

    def draw(fig: Figure, theme: Theme) -> None:
        """Draw the headline and the table, a row for each scene and measure."""
        line = (
            f"A box on a slope, {frames:,} frames. Kept: the last axis, unless another is shallower by {KEEP_WITHIN}."
        )
        draw_headline(fig, theme, title, line)
        ax = add_axes(fig, (0.33, 0.04, 0.66, 0.6), theme)

        def entry(y: int, x: int) -> tuple[str, str, float]:
            """Return the text, the colour and its strength (0 to 1) for the table's field in row y and column x."""
            (scene, key, _), (name, k) = MEASURES[y], columns[x]
            value = measured[scene, name, k][key]
            if key == "noise":
                return f"{value:.0e}", theme.roles["wrong"], (float(np.log10(max(value, 1e-17))) + 17) / 14
            return f"{value:,}", theme.roles["wrong"], value / frames

        heads = [f"{name}{', kept' if k else ''}".replace(", ", ",\n") for name, k in columns]
        draw_table(ax, theme, heads, [f"{scene}: {words}" for scene, _, words in MEASURES], entry)

    touching, seam = measured[ON, "satviz", False], measured[OVER, "satviz", False]
    float64, float32 = (measured[IN, name, False]["noise"] for name in ("SAT, unit normals", "SAT, float32"))
    flips = {name: [measured[AT, name, kept]["flips"] for kept in (False, True)] for name in METHOD_OPTIONS}
    flips_in_words = ", ".join(f"{loose:,} times ({name}; kept: {kept:,})" for name, (loose, kept) in flips.items())
    apart, kept = measured[ON, "SAT, unit normals", False]["apart"], measured[OVER, "satviz", True]["sideways"]
    text = (
        f"Where it should touch, the box is apart in {touching['apart_in_truth']:,} of {frames:,} frames, because its "
        f"corners are rounded. Exact verdicts see that, and unit normals see {apart:,} frames apart. "
        f"Sunk in by {DEPTH} the box is never apart, and the error of the depth is at most {float64:.0e}, in float32 "
        f"{float32:.0e}. Over a seam the second tile pushes sideways in {seam['sideways']} frames, and in {kept} with "
        "the last axis kept, because the first contact was sideways. Where two directions out are equally long, the "
        f"normal flips {flips_in_words}."
    )
    return [Chart("resting-contact", title, size, draw, rows, text)]
