"""Failure maps: A drawn, and where B's middle must be for the shortcut to be wrong, coloured and hatched.

The areas are exact, as under the hand in the explorer; the counts are of positions on a grid.
"""

from collections.abc import Sequence
from typing import Any, cast

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import PathPatch, Rectangle
from matplotlib.path import Path

from ...engine.geometry import Vec
from ...engine.shapes import Circle, Shape
from ...pictures import Mark, Picture, Theme
from ...render.pen import Pen
from ...scenes.error_region import error_region_in_view
from ...scenes.failing import NAMED, FailureCase
from ...scenes.failing.move_space import ConvexRing, ErrorRegion, minkowski_difference, window_ring
from ...scenes.shape_tools import vertex_mean
from ..harness.cells import Cell, Settings
from ..harness.chart import TEXT, Chart, headline
from .slides import APART, FALSE, HIT, METHODS, MISSED, ON_PAPER, WRONG, Slide, both, slide

# what is wrong has one colour, and a hatch for each way; what is right stays quiet
LOOKS = {
    "hits": ("guide", 0.16, ""),
    "false_hits": ("wrong", 0.5, "////"),
    "missed_hits": ("wrong", 0.5, "\\\\\\\\"),
    "numbers": ("wrong", 0.5, "..."),
}
COLUMNS, PANEL, TOP = 6, (150.0, 180.0), 60.0  # points


def cells(settings: Settings) -> list[Cell]:
    """A cell for each shortcut."""
    n = 17 if settings.quick else 61
    return [Cell(f"map-{name}", slide, (name, n if name != ON_PAPER else 25)) for name in METHODS]


def charts(found: dict[str, Any], settings: Settings) -> list[Chart]:
    """All maps in one chart; `satviz draw NAME` and `sv.explore(NAME)` show each large."""
    return [overview([Slide(**found[f"map-{name}"]) for name in METHODS])]


def overview(slides: Sequence[Slide]) -> Chart:
    """All maps in small."""
    lines = -(-len(slides) // COLUMNS)
    size = COLUMNS * PANEL[0] + 24, lines * PANEL[1] + TOP + 8
    mostly = sum(s.counts[FALSE] > s.counts[MISSED] for s in slides)
    verdicts = [s for s in slides if s.counts[FALSE] or s.counts[MISSED]]
    title = f"{mostly} of {len(verdicts)} shortcuts to a verdict err more often to a hit than to a miss"

    def draw_it(fig: Figure, theme: Theme) -> None:
        under = "B's middle put everywhere round A. Grey: a hit, and right. Plain: apart, and right. "
        under += "Red: wrong, striped by the verdict, dotted by the number. The counts are of a grid."
        headline(fig, theme, title, under)
        for k, mine in enumerate(slides):
            middle, top = 12 + (k % COLUMNS + 0.5) * PANEL[0], size[1] - TOP - k // COLUMNS * PANEL[1]
            row = NAMED[mine.name]
            x0, y0, x1, y1 = limits(mine, row)
            scale = min((PANEL[0] - 24) / (x1 - x0), (PANEL[1] - 66) / (y1 - y0))
            w, h = (x1 - x0) * scale, (y1 - y0) * scale
            box = middle - w / 2, top - 20 - (PANEL[1] - 66 + h) / 2, w, h
            ax = fig.add_axes((box[0] / size[0], box[1] / size[1], w / size[0], h / size[1]))
            ax.set(xlim=(x0, x1), ylim=(y0, y1))
            draw_map(ax, mine, row, theme)
            at: dict[str, Any] = {
                "ha": "center",
                "va": "top",
                "fontsize": TEXT,
                "parse_math": False,
                "color": theme.roles["ink"],
            }
            fig.text(middle / size[0], top / size[1], f"{row.number} {row.name}", fontweight="bold", **at)
            below = (top - PANEL[1] + 42) / size[1]
            fig.text(middle / size[0], below, mine.told.replace(", ", ",\n"), linespacing=1.2, **at)

    text = f"{len(slides)} shortcuts, B on up to {max(s.counts.total() for s in slides):,} positions round A each. "
    text += " ".join(f"{s.name}: wrong at {s.wrong / s.counts.total():.1%} ({s.told})." for s in slides)
    return Chart("failing-maps", title, size, draw_it, [_summary(s) for s in slides], text)


def _summary(slide: Slide) -> dict[str, Any]:
    found = slide.counts
    names = {code: one for code, (one, _) in WRONG.items()}
    start = {"number": NAMED[slide.name].number, "name": slide.name, "positions": found.total()}
    return start | {"apart": found[APART], "hit": found[HIT]} | {names[code]: found[code] for code in names}


def limits(slide: Slide, row: FailureCase) -> tuple[float, float, float, float]:
    """What a map shows: the positions, A, and B where the scene has it."""
    spots = [(x, y) for x, y, _ in slide.positions()]
    (ax0, ay0, ax1, ay1), (bx0, by0, bx1, by1) = (shape.bounds for shape in both(row))
    xs, ys = [ax0, ax1, bx0, bx1, *(x for x, _ in spots)], [ay0, ay1, by0, by1, *(y for _, y in spots)]
    rim_x, rim_y = max(slide.dx, (max(xs) - min(xs)) * 0.03), max(slide.dy, (max(ys) - min(ys)) * 0.03)
    return min(xs) - rim_x, min(ys) - rim_y, max(xs) + rim_x, max(ys) + rim_y


def draw_map(ax: Axes, slide: Slide, row: FailureCase, theme: Theme) -> None:
    """The areas, A, and B where the scene has it with its middle."""
    x0, y0, x1, y1 = view = limits(slide, row)
    box, (wide, high) = ax.get_position(), cast(Figure, ax.figure).get_size_inches() * 72
    scale = min(box.width * wide / (x1 - x0), box.height * high / (y1 - y0))
    a, b = both(row)
    at = vertex_mean(b)
    marks = [
        _outline("A", a),
        _outline("B", b, weight="faint"),
        Mark("reference", "dot", "B", (at,)),
    ]
    Pen(ax, theme).draw(Picture(tuple(marks), view, ((x1 - x0) * scale, (y1 - y0) * scale), "", ""))
    told = error_region_in_view(a, b, row.shortcut, view)
    found = ErrorRegion((), (), tuple(minkowski_difference(a, b))) if isinstance(told, str) else told

    # over the shapes' fills, so that red stays red, and under their lines
    def area(rings: Sequence[ConvexRing], **look: Any) -> None:
        if rings:
            ax.add_patch(PathPatch(_path(rings, at), **{"facecolor": "none", "linewidth": 0, "zorder": 1.3} | look))

    for name, (role, alpha, hatch) in LOOKS.items():
        area(getattr(found, name), facecolor=theme.roles[role], alpha=alpha, zorder=1.2)
        area(getattr(found, name), edgecolor=theme.roles[role], hatch=hatch)
    if found.touching:
        area(found.hits, edgecolor=theme.roles["wrong"], linewidth=2.5)
    if isinstance(told, str):  # wrong at single places only
        half = 2.0 / scale
        wrong = [(x - at.x, y - at.y) for x, y, code in slide.positions() if code in WRONG]
        area([window_ring((x - half, y - half, x + half, y + half)) for x, y in wrong], facecolor=theme.roles["wrong"])
    look: dict[str, Any] = {"fill": False, "edgecolor": theme.roles["guide"], "linewidth": 0.7, "clip_on": False}
    ax.add_patch(Rectangle((0, 0), 1, 1, transform=ax.transAxes, **look))


def _path(rings: Sequence[ConvexRing], at: Vec) -> Path:
    """One outline for all, so that nothing shows where two share a side."""
    points = [(x + at.x, y + at.y) for ring in rings for x, y in (*ring, ring[0])]
    codes = [code for ring in rings for code in (Path.MOVETO, *[Path.LINETO] * (len(ring) - 1), Path.CLOSEPOLY)]
    return Path(points, codes)


def _outline(name: str, shape: Shape, *, weight: str = "plain") -> Mark:
    if isinstance(shape, Circle):
        return Mark("outline", "disc", name, (shape.center,), owner=name, radius=shape.radius, weight=weight)
    return Mark("outline", "outline", name, shape.vertices, owner=name, weight=weight)
