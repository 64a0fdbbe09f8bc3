"""A failure map: A drawn, and the positions of B coloured and hatched where the shortcut is wrong."""

from collections.abc import Sequence
from math import hypot

from matplotlib.axes import Axes
from matplotlib.patches import PathPatch
from matplotlib.path import Path

from ..engine.geometry import Vec
from ..engine.shapes import Circle, Shape
from ..pictures import Mark, Picture, Theme
from ..pictures.labels import holds, name_spots
from ..render.pen import Pen
from ..scenes.failing import Row
from ..scenes.shortcuts import middle
from .failures import FALSE, FAR, HIT, LONG, MISSED, SHORT, Slide

LETTER = 17.0  # the size of A's name
# what is wrong has one colour, and a hatch for each way; what is right stays quiet
LOOKS = {
    HIT: ("guide", 0.16, ""),
    FALSE: ("wrong", 0.5, "////"),
    MISSED: ("wrong", 0.5, "\\\\\\\\"),
    SHORT: ("wrong", 0.5, "----"),
    LONG: ("wrong", 0.5, "xxx"),
    FAR: ("wrong", 0.5, "..."),
}


def limits(slide: Slide, row: Row) -> tuple[float, float, float, float]:
    """What a map shows: the positions, A, and B where the scene has it."""
    spots = [(x, y) for x, y, _ in slide.positions()]
    (ax0, ay0, ax1, ay1), (bx0, by0, bx1, by1) = row.a.bounds, row.b.bounds
    xs, ys = [ax0, ax1, bx0, bx1, *(x for x, _ in spots)], [ay0, ay1, by0, by1, *(y for _, y in spots)]
    rim_x, rim_y = max(slide.dx, (max(xs) - min(xs)) * 0.03), max(slide.dy, (max(ys) - min(ys)) * 0.03)
    return min(xs) - rim_x, min(ys) - rim_y, max(xs) + rim_x, max(ys) + rim_y


def draw_map(ax: Axes, slide: Slide, row: Row, theme: Theme, *, named: bool = True) -> None:
    """The coloured positions, A, and B where the scene has it with its reference point."""
    x0, y0, x1, y1 = view = limits(slide, row)
    box, (wide, high) = ax.get_position(), ax.figure.get_size_inches() * 72
    scale = min(box.width * wide / (x1 - x0), box.height * high / (y1 - y0))
    at = middle(row.b)
    marks = [_outline("A", row.a), _outline("B", row.b, weight="faint"), Mark("reference", "dot", "B", (at,))]
    if named:
        marks.append(Mark("name", "label", "A", (_name_spot(row, scale),), owner="A", text="A", weight="title"))
    Pen(ax, theme).draw(Picture(tuple(marks), view, ((x1 - x0) * scale, (y1 - y0) * scale), "", ""))
    if not slide.path:
        frame = _boxes(_box(slide, 0, len(slide.codes[0]), 0, len(slide.codes)))
        ax.add_patch(PathPatch(frame, facecolor="none", edgecolor=theme.roles["guide"], linewidth=0.7, zorder=0.7))
    for code, (role, alpha, hatch) in LOOKS.items():
        path = _along(slide, code, (2.0 if code == HIT else 4.0) / scale) if slide.path else _area(slide, code)
        if path is not None:
            colour = theme.roles[role]
            look = {"facecolor": colour, "alpha": alpha, "linewidth": 0, "antialiased": False, "zorder": 0.5}
            ax.add_patch(PathPatch(path, **look))
            if hatch:
                ax.add_patch(PathPatch(path, facecolor="none", edgecolor=colour, hatch=hatch, linewidth=0, zorder=0.6))


def _name_spot(row: Row, scale: float) -> Vec:
    """Where A's name stands: inside it and off B's middle, or above where A is too flat for a letter."""
    x0, _, _, y1 = row.a.bounds
    at, room = middle(row.b), LETTER / scale
    spots = [p for p in name_spots(row.a) if hypot(p.x - at.x, p.y - at.y) > 1.3 * room]
    roomy = [p for p in spots if _within(row.a, p, room / 2)]
    return (roomy or [Vec(x0 + room, y1 + room / 2)])[0]


def _within(shape: Shape, p: Vec, reach: float) -> bool:
    """Does the shape hold the point and four points that far from it?"""
    around = [Vec(p.x + reach * x, p.y + reach * y) for x, y in ((0, 0), (1, 0), (-1, 0), (0, 1), (0, -1))]
    return all(holds(shape, q) for q in around)


def _outline(name: str, shape: Shape, *, weight: str = "plain") -> Mark:
    if isinstance(shape, Circle):
        return Mark("outline", "disc", name, (shape.center,), owner=name, radius=shape.radius, weight=weight)
    return Mark("outline", "outline", name, shape.vertices, owner=name, weight=weight)


def _area(slide: Slide, code: str) -> Path | None:
    """One outline for all areas of that letter."""
    if not slide.areas:
        return _cells(slide, code)
    points, codes = [], []
    for letter, ring in slide.areas:
        if letter == code:
            points += [*ring, ring[0]]
            codes += [Path.MOVETO, *[Path.LINETO] * (len(ring) - 1), Path.CLOSEPOLY]
    return Path(points, codes) if points else None


def _cells(slide: Slide, code: str) -> Path | None:
    """One outline for all positions with that letter: a rectangle a run, so that nothing shows between cells."""
    points: list[tuple[float, float]] = []
    for j, line in enumerate(slide.codes):
        start = None
        for i, letter in enumerate([*line, ""]):
            if letter == code and start is None:
                start = i
            elif letter != code and start is not None:
                points += _box(slide, start, i, j, j + 1)
                start = None
    return _boxes(points)


def _box(slide: Slide, i0: int, i1: int, j0: int, j1: int) -> list[tuple[float, float]]:
    """The corners of a run of cells."""
    (x0, x1), (y0, y1) = (
        (slide.x + (i - 0.5) * slide.dx for i in (i0, i1)),
        (slide.y + (j - 0.5) * slide.dy for j in (j0, j1)),
    )
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)]


def _along(slide: Slide, code: str, half: float) -> Path | None:
    """A small square on each spot along a contact."""
    points: list[tuple[float, float]] = []
    for x, y, letter in slide.positions():
        if letter == code:
            points += [(x + sx * half, y + sy * half) for sx, sy in ((-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1))]
    return _boxes(points)


def _boxes(points: Sequence[tuple[float, float]]) -> Path | None:
    if not points:
        return None
    codes = [Path.MOVETO, Path.LINETO, Path.LINETO, Path.LINETO, Path.CLOSEPOLY]
    return Path(points, codes * (len(points) // 5))
