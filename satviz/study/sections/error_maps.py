"""Error maps: the shape A, and the positions of B's middle where a shortcut is wrong, coloured and hatched.

The areas are exact, as in the explorer; the counts are of positions on a grid.
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
from ..harness.cells import Cell, JsonRow, Settings
from ..harness.chart import TEXT_POINTS, Chart, draw_headline
from .position_grid import (
    APART,
    ERROR_NAMES,
    FALSE_HIT_CODE,
    HIT,
    MAPPED_SHORTCUTS,
    MISSED_HIT_CODE,
    TOUCH_ON_PAPER,
    PositionGrid,
    evaluate_grid,
    shapes_of,
)

# (colour role, opacity, hatch): all errors have one colour and each kind its hatch; right answers are pale
REGION_STYLES = {
    "hits": ("guide", 0.16, ""),
    "false_hits": ("wrong", 0.5, "////"),
    "missed_hits": ("wrong", 0.5, "\\\\\\\\"),
    "numbers": ("wrong", 0.5, "..."),
}
MAP_COLUMNS, PANEL_POINTS, HEADER_POINTS = 6, (150.0, 180.0), 60.0


def cells(settings: Settings) -> list[Cell]:
    """Return one cell for each shortcut, which compares it with the truth at a grid of positions of B."""
    n = 17 if settings.quick else 61
    return [
        Cell(f"map-{name}", evaluate_grid, (name, n if name != TOUCH_ON_PAPER else 25)) for name in MAPPED_SHORTCUTS
    ]


def charts(found: dict[str, Any], settings: Settings) -> list[Chart]:
    """Return one chart with all maps; `satviz draw NAME` and `sv.explore(NAME)` show one map large."""
    return [map_chart([PositionGrid(**found[f"map-{name}"]) for name in MAPPED_SHORTCUTS])]


def map_chart(grids: Sequence[PositionGrid]) -> Chart:
    """Return the chart of all maps, small, in rows of six."""
    wide, high = PANEL_POINTS
    size = MAP_COLUMNS * wide + 24, -(-len(grids) // MAP_COLUMNS) * high + HEADER_POINTS + 8
    counts = [grid.counts for grid in grids]
    mostly_false = sum(count[FALSE_HIT_CODE] > count[MISSED_HIT_CODE] for count in counts)
    verdicts = sum(bool(count[FALSE_HIT_CODE] or count[MISSED_HIT_CODE]) for count in counts)
    title = f"{mostly_false} of {verdicts} shortcuts with wrong verdicts have more false hits than missed hits"

    def draw(fig: Figure, theme: Theme) -> None:
        """Draw the headline, and each map with its name above and its counts below."""
        lines = (
            "Each point is a position of B's middle. Grey: a hit, and right. White: apart, and right.",
            "Red: wrong; stripes show a wrong verdict, dots a wrong number. The numbers count positions on a grid.",
        )
        draw_headline(fig, theme, title, *lines)
        style: dict[str, Any] = {"ha": "center", "va": "top", "fontsize": TEXT_POINTS, "parse_math": False}
        style["color"] = theme.roles["ink"]
        for k, grid in enumerate(grids):
            middle, top = 12 + (k % MAP_COLUMNS + 0.5) * wide, size[1] - HEADER_POINTS - k // MAP_COLUMNS * high
            case = NAMED[grid.name]
            x0, y0, x1, y1 = map_limits(grid, case)
            scale = min((wide - 24) / (x1 - x0), (high - 66) / (y1 - y0))
            w, h = (x1 - x0) * scale, (y1 - y0) * scale
            left, bottom = middle - w / 2, top - 20 - (high - 66 + h) / 2
            ax = fig.add_axes((left / size[0], bottom / size[1], w / size[0], h / size[1]))
            ax.set(xlim=(x0, x1), ylim=(y0, y1))
            draw_map(ax, grid, case, theme)
            fig.text(middle / size[0], top / size[1], f"{case.number} {case.name}", fontweight="bold", **style)
            below = (top - high + 42) / size[1]
            fig.text(middle / size[0], below, grid.counts_in_words.replace(", ", ",\n"), linespacing=1.2, **style)

    text = (
        f"{len(grids)} shortcuts, each with B at up to {max(count.total() for count in counts):,} positions round A. "
    )
    text += " ".join(f"{g.name}: wrong at {g.wrong / g.counts.total():.1%} ({g.counts_in_words})." for g in grids)
    return Chart("failing-maps", title, size, draw, [_map_counts(grid) for grid in grids], text)


def _map_counts(grid: PositionGrid) -> JsonRow:
    """Return the row of one map: how many positions are right, and how many are wrong in each way."""
    counts = grid.counts
    row: JsonRow = {"number": NAMED[grid.name].number, "name": grid.name, "positions": counts.total()}
    row |= {"apart": counts[APART], "hit": counts[HIT]}
    return row | {name: counts[code] for code, (name, _) in ERROR_NAMES.items()}


def map_limits(grid: PositionGrid, case: FailureCase) -> tuple[float, float, float, float]:
    """Return the window (x0, y0, x1, y1) of a map: it holds the positions, A, and B at its place in the scene."""
    spots = [(x, y) for x, y, _ in grid.positions()]
    (ax0, ay0, ax1, ay1), (bx0, by0, bx1, by1) = (shape.bounds for shape in shapes_of(case))
    xs, ys = [ax0, ax1, bx0, bx1, *(x for x, _ in spots)], [ay0, ay1, by0, by1, *(y for _, y in spots)]
    rim_x, rim_y = max(grid.dx, (max(xs) - min(xs)) * 0.03), max(grid.dy, (max(ys) - min(ys)) * 0.03)
    return min(xs) - rim_x, min(ys) - rim_y, max(xs) + rim_x, max(ys) + rim_y


def draw_map(ax: Axes, grid: PositionGrid, case: FailureCase, theme: Theme) -> None:
    """Draw the error region, the shape A, and B at its place in the scene with its middle."""
    x0, y0, x1, y1 = view = map_limits(grid, case)
    box, (wide, high) = ax.get_position(), cast(Figure, ax.figure).get_size_inches() * 72
    scale = min(box.width * wide / (x1 - x0), box.height * high / (y1 - y0))
    a, b = shapes_of(case)
    middle = vertex_mean(b)
    marks = _outline_mark("A", a), _outline_mark("B", b, weight="faint"), Mark("reference", "dot", "B", (middle,))
    Pen(ax, theme).draw(Picture(marks, view, ((x1 - x0) * scale, (y1 - y0) * scale), "", ""))
    found = error_region_in_view(a, b, case.shortcut, view)
    # a string is the reason why no area shows the errors
    region = ErrorRegion((), (), tuple(minkowski_difference(a, b))) if isinstance(found, str) else found

    def draw_area(rings: Sequence[ConvexRing], **style: Any) -> None:
        """Draw rings of moves of B, as positions of its middle: above the shapes' fills and below their lines."""
        if rings:
            style = {"facecolor": "none", "linewidth": 0, "zorder": 1.3} | style
            ax.add_patch(PathPatch(_joined_path(rings, middle), **style))

    for name, (role, alpha, hatch) in REGION_STYLES.items():
        draw_area(getattr(region, name), facecolor=theme.roles[role], alpha=alpha, zorder=1.2)
        draw_area(getattr(region, name), edgecolor=theme.roles[role], hatch=hatch)
    if region.touching:
        draw_area(region.hits, edgecolor=theme.roles["wrong"], linewidth=2.5)
    if isinstance(found, str):  # wrong at single positions only, drawn as squares of 4 points
        half = 2.0 / scale
        wrong = [(x - middle.x, y - middle.y) for x, y, code in grid.positions() if code in ERROR_NAMES]
        squares = [window_ring((x - half, y - half, x + half, y + half)) for x, y in wrong]
        draw_area(squares, facecolor=theme.roles["wrong"])
    frame: dict[str, Any] = {"fill": False, "edgecolor": theme.roles["guide"], "linewidth": 0.7, "clip_on": False}
    ax.add_patch(Rectangle((0, 0), 1, 1, transform=ax.transAxes, **frame))


def _joined_path(rings: Sequence[ConvexRing], middle: Vec) -> Path:
    """Return one path for all rings, shifted by B's middle; a single path shows no seams between rings."""
    points = [(x + middle.x, y + middle.y) for ring in rings for x, y in (*ring, ring[0])]
    codes = [code for ring in rings for code in (Path.MOVETO, *[Path.LINETO] * (len(ring) - 1), Path.CLOSEPOLY)]
    return Path(points, codes)


def _outline_mark(name: str, shape: Shape, *, weight: str = "plain") -> Mark:
    """Return the mark that draws a shape's outline."""
    if isinstance(shape, Circle):
        return Mark("outline", "disc", name, (shape.center,), owner=name, radius=shape.radius, weight=weight)
    return Mark("outline", "outline", name, shape.vertices, owner=name, weight=weight)
