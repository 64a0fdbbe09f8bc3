"""An animation of pictures: between two steps, marks move to their places instead of jumping there.

A mark that both pictures have moves; a new mark grows out of its `start`; a label appears with its step.  The
browser's pen moves marks in the same way (satviz/render/browser/pen.js).
"""

from collections.abc import Sequence
from typing import NamedTuple

from ..engine.geometry import Vec
from .caption import caption_time_ms
from .marks import Mark, Picture

MOVE_FRAMES, MOVE_FRAME_MS = 6, 50  # pictures between two steps, and how long each is shown
TURN_FRAME_MS = 90  # time of each picture of an axis that turns
MAX_MOVED_STEPS = 100  # a longer run jumps from step to step: its file would be too large


class Animation(NamedTuple):
    """The pictures of an animation and for how many milliseconds each is shown."""

    pictures: Sequence[Picture]
    times: Sequence[int]


def animation(steps: Sequence[Picture], *, speed: float = 1.0) -> Animation:
    """Return the pictures of a run as an animation; at `speed` 1 the article's triangles take less than 20 s."""
    pictures: list[Picture] = []
    times: list[float] = []
    for number, step in enumerate(steps):
        frames = MOVE_FRAMES if number and len(steps) <= MAX_MOVED_STEPS else 0
        for k in range(1, frames + 1):
            pictures.append(in_between(steps[number - 1], step, k / (MOVE_FRAMES + 1)))
            times.append(MOVE_FRAME_MS)
        pictures.append(step)
        times.append(caption_time_ms(step) - frames * MOVE_FRAME_MS)
    return Animation(pictures, [max(20, round(ms / speed)) for ms in times])


def turning(pictures: Sequence[Picture], *, speed: float = 1.0) -> Animation:
    """Return the pictures of an axis that turns (`sv.sweep`) as an animation; `speed` 2 is twice as fast."""
    return Animation(pictures, [max(20, round(TURN_FRAME_MS / speed))] * len(pictures))


def in_between(before: Picture, after: Picture, part: float) -> Picture:
    """Return the picture `after` with its marks on their way from `before`: `part` 0 is the start, 1 the end."""
    eased = 1 - (1 - part) ** 3
    old = {mark.id: mark for mark in before.marks}
    marks = (_on_its_way(mark, old.get(mark.id), eased) for mark in after.marks)
    return after._replace(marks=tuple(mark for mark in marks if mark))


def _on_its_way(mark: Mark, old: Mark | None, part: float) -> Mark | None:
    """Return the mark with its points moved the share `part` of the way from `old` (None: from its `start`).

    None for a new mark that does not move: it is drawn only in its step.
    """
    start = old.points if old else mark.start
    if len(start) == 1 and not old:
        start *= len(mark.points)
    if mark.kind == "label" or len(start) != len(mark.points):
        return mark if old else None
    points = (Vec(p.x + (q.x - p.x) * part, p.y + (q.y - p.y) * part) for p, q in zip(start, mark.points, strict=True))
    return mark._replace(points=tuple(points))
