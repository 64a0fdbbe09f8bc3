"""The first minute of the front page: the axis turns, and the gap opens, once and slowly."""

import json
from itertools import chain
from math import hypot

from ..pictures.marks import Mark, marks_data
from ..pictures.turning_axis import sweep
from ..scenes.named import scene

SHOWN = "outline", "name", "drop", "axis", "range", "overlap", "gap"  # of the turning axis; no dial and no curve
STEP_DEGREES, FROM_DEGREES = 2, 90  # it begins where the shadows overlap most
MARGIN_PT = 16.0
# What is seen, and read aloud, in this order: the page marks the sentence that the picture has come to.  They are true
# of the still picture, too, which has the gap.
SENTENCES = (
    "Each triangle throws a shadow on a line. On some lines the shadows overlap.",
    "If the line turns, the shadows change. The triangles stay where they are.",
    "On this line there is a gap between the shadows. So the triangles are apart.",
)


def first_minute() -> str:
    """Return the pictures of the turning axis as JSON in a script element; the last one has the largest gap."""
    every = sweep(scene("triangles"), step=STEP_DEGREES)[FROM_DEGREES // STEP_DEGREES :]
    marks = [[_turned_round(mark) for mark in drawn.marks if mark.part in SHOWN] for drawn in every]
    gaps = [_gap_size(shown) for shown in marks]
    marks = marks[: gaps.index(max(gaps)) + 1]
    points = [point for mark in chain(*marks) for point in mark.points]
    x0, x1 = min(x for x, _ in points) - MARGIN_PT, max(x for x, _ in points) + MARGIN_PT
    y0, y1 = min(y for _, y in points) - MARGIN_PT, max(y for _, y in points) + MARGIN_PT
    numbers: dict[Mark, int] = {}
    frames = [[numbers.setdefault(mark, len(numbers)) for mark in shown] for shown in marks]
    data = {"limits": [x0, y0, x1, y1], "size": [x1 - x0, y1 - y0], **marks_data(numbers), "frames": frames}
    text = json.dumps(data, separators=(",", ":"), ensure_ascii=False).replace("<", "\\u003c")
    return f'<script type="application/json" class="first-minute">{text}</script>'


def _turned_round(mark: Mark) -> Mark:
    """Return the mark; an axis gets its arrow at the other end, so that it points as in the scene to drag."""
    return mark._replace(points=mark.points[::-1]) if mark.part == "axis" else mark


def _gap_size(marks: list[Mark]) -> float:
    """Return the length of the gap that is drawn; negative where the ranges overlap."""
    (found,) = (mark for mark in marks if mark.part in ("gap", "overlap"))
    (x0, y0), (x1, y1) = found.points[0], found.points[-1]
    length = hypot(x1 - x0, y1 - y0)
    return length if found.part == "gap" else -length
