"""An outline that is refused: its corners in their order, where it crosses itself, and the order that was meant."""

from collections.abc import Sequence
from itertools import pairwise
from math import isfinite

from ..engine.geometry import Vec
from .float_geometry import mean_point
from .label_placer import LabelRequest
from .labels import with_labels
from .layout import Layout
from .marks import Mark, Picture

WIDTH_PT, DRAWN_PT, RIM_PT = 320.0, 220.0, 46.0


def outlines_picture(name: str, ring: Sequence[Vec], crossing: Vec | None, meant: Sequence[Vec], why: str) -> Picture:
    """Return the picture of an outline that is refused, each corner with its number from 1; `why`: the reason.

    `crossing`: a point where edges cross, or None; `meant`: the corners in the order that was probably meant, drawn
    dotted.  ValueError if the coordinates are too large to be drawn.
    """
    xs, ys = [p.x for p in ring], [p.y for p in ring]
    wide, high = max(xs) - min(xs), max(ys) - min(ys)
    if not (isfinite(wide) and isfinite(high)):
        raise ValueError("the outline is too large to be drawn: scale it down")
    scale = DRAWN_PT / (max(wide, high) or 1.0)
    size = WIDTH_PT, high * scale + 2 * RIM_PT
    left = (WIDTH_PT - wide * scale) / 2

    def spot(p: Vec) -> Vec:
        """Return the point on the canvas, in points, that shows p."""
        return Vec(left + (p.x - min(xs)) * scale, RIM_PT + (p.y - min(ys)) * scale)

    role = name if name in ("A", "B") else "ink"
    spots = [spot(p) for p in ring]
    middle = mean_point(spots)
    marks = [Mark("outline", "outline", role, tuple(spots), owner=name)]
    around = [spot(p) for p in meant]
    for number, (p, q) in enumerate(pairwise([*around, *around[:1]])):
        marks.append(Mark("meant", "segment", "guide", (p, q), number=number))
    requests = []
    for number, p in enumerate(spots):
        marks.append(Mark("vertex", "dot", role, (p,), owner=name, number=number))
        away = Vec(p.x - middle.x, p.y - middle.y + 1e-3)
        label = f"{name.lower()}{number + 1}"
        requests.append(LabelRequest("vertex-name", label, role, p, owner=name, number=number, prefer=away))
    if crossing is not None:
        at = spot(crossing)
        marks.append(Mark("crossing", "dot", "wrong", (at,)))
        text = f"crosses at ({crossing.x:.6g}, {crossing.y:.6g})"
        requests.append(LabelRequest("crossing-name", text, "wrong", at, prefer=Vec(1.0, 0.3)))
    layout = Layout((0.0, 0.0, *size), size, ())
    drawn = with_labels(marks, requests, layout, steady=False, keep_off=())
    sentence = f"{name} is refused: {why}."
    if meant:
        sentence += " The dotted line is the order that was probably meant."
    return Picture(tuple(drawn), (0.0, 0.0, *size), size, "", sentence)
