"""Two boxes in space: the face normals find no gap, one direction across an edge of each does."""

from typing import Any

from matplotlib.figure import Figure
from mpl_toolkits.mplot3d import Axes3D
from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection

from ..engine import digits
from ..pictures import Theme
from ..pictures import theme as look
from ..scenes.failing import NAMED, threed
from .cells import Cell, Settings
from .chart import TEXT, Chart, axes, headline

ROW = NAMED["faces-in-3d"]
SIZE = 780.0, 420.0  # points
FACES = [tuple(n for n in range(8) if n >> i & 1 == side) for i in range(3) for side in (0, 1)]
EDGES = [(n, n | 1 << i) for n in range(8) for i in range(3) if not n >> i & 1]


def cells(settings: Settings) -> list[Cell]:
    """One cell: the gap on each axis."""
    return [Cell("failures-faces-in-3d", gaps, ())]


def gaps() -> list[dict[str, Any]]:
    """The fifteen axes with their gaps, the six face normals first."""
    faces, crosses = (found(*threed.PAIR) for found in (threed.faces, threed.crosses))
    return [
        {"axis": gap.name, "x": gap.axis[0], "y": gap.axis[1], "z": gap.axis[2], "gap": gap.gap, "kind": kind}
        for kind, some in (("face normal", faces), ("edge cross edge", crosses))
        for gap in some
    ]


def charts(results: dict[str, Any]) -> list[Chart]:
    """The boxes with the axis that separates them, and all gaps as bars."""
    rows = results["failures-faces-in-3d"]
    best = max(rows, key=lambda row: row["gap"])
    face = max((row for row in rows if row["kind"] == "face normal"), key=lambda row: row["gap"])

    def draw(fig: Figure, theme: Theme) -> None:
        under = f"best face normal {face['axis']}: {_gap(face)}; best edge cross edge {best['axis']}: {_gap(best)}"
        headline(fig, theme, f"{ROW.number}  “{ROW.claim}”", under)
        _solids(fig, theme, face, best)
        _bars(fig, theme, rows, best)

    text = (
        f"Belief {ROW.number}, “{ROW.claim}”: on the face normals the boxes overlap, by {-face['gap']:.3f} at least "
        f"(on {face['axis']}). Across the edges {best['axis'].replace(' × ', ' and ')} there is a gap of "
        f"{best['gap']:.3f}. Separating axes: {sum(row['gap'] > 0 for row in rows)} of {len(rows)}; so they are apart."
    )
    return [Chart(f"failing-{ROW.number}-{ROW.name}", f"{ROW.number} {ROW.name}", SIZE, draw, rows, text)]


def _gap(row: dict[str, Any]) -> str:
    return f"{'gap' if row['gap'] > 0 else 'overlap'} {digits.number(abs(row['gap']))}"


def _solids(fig: Figure, theme: Theme, face: dict[str, Any], best: dict[str, Any]) -> None:
    """Both boxes, a face normal, the two edges that face each other, and the axis across them."""
    ax = Axes3D(fig, (-0.02, -0.02, 0.6, 0.9))
    fig.add_axes(ax)
    ax.set_axis_off()
    ax.set_facecolor(theme.paper)
    ax.computed_zorder = False
    for name, box in zip("AB", threed.PAIR, strict=True):
        corners, shade = threed.corners(box), theme.roles[name]
        for n in FACES:
            quad = [corners[i] for i in (n[0], n[1], n[3], n[2])]
            ax.add_collection3d(Poly3DCollection([quad], facecolors=shade, alpha=look.FILL, linewidths=0, zorder=1))
        style = "--" if name == "B" else "-"
        lines = [(corners[i], corners[j]) for i, j in EDGES]
        ax.add_collection3d(Line3DCollection(lines, colors=shade, linewidths=1.4, linestyles=style, zorder=2))
        ax.text(*box.center, name, color=theme.text.get(name, shade), fontsize=look.TITLE_TEXT, fontweight="bold")
    a, b = threed.PAIR
    _arrow(ax, theme, "A", (1.0, 0.0, 0.0), a.axes[0], face["axis"])
    middle = tuple((p + q) / 2 for p, q in zip(a.center, b.center, strict=True))
    n = best["x"], best["y"], best["z"]
    start = middle[0] - 0.35 * n[0], middle[1] - 0.35 * n[1], max(corner[2] for corner in threed.corners(a)) * 1.25
    _arrow(ax, theme, "gap", start, n, best["axis"], length=0.7)
    every = [corner for box in threed.PAIR for corner in threed.corners(box)]
    lows, highs = ([f(values) for values in zip(*every, strict=True)] for f in (min, max))
    ax.set(xlim=(lows[0], highs[0]), ylim=(lows[1], highs[1]), zlim=(lows[2], highs[2]))
    ax.set_box_aspect([hi - lo for lo, hi in zip(lows, highs, strict=True)], zoom=1.0)
    ax.view_init(elev=14, azim=-52)


def _arrow(ax: Axes3D, theme: Theme, role: str, start: Any, n: Any, text: str, length: float = 1.0) -> None:
    ax.quiver(
        *start, *(length * u for u in n), color=theme.roles[role], linewidth=2.2, arrow_length_ratio=0.22, zorder=3
    )
    x, y, z = (p + length / 2 * u for p, u in zip(start, n, strict=True))
    shade = theme.text.get(role, theme.roles[role])
    ax.text(x, y, z + 0.08, text, color=shade, fontsize=TEXT + 1, ha="center", va="bottom", zorder=4)


def _bars(fig: Figure, theme: Theme, rows: list[dict[str, Any]], best: dict[str, Any]) -> None:
    """A bar an axis: overlaps to the left of zero, gaps to the right."""
    ax = axes(fig, (0.62, 0.1, 0.34, 0.72), theme)
    ax.spines[["left", "bottom"]].set_visible(False)
    ax.set(xticks=[], yticks=[])
    ax.axvline(0, color=theme.roles["guide"], lw=1)
    for k, row in enumerate(rows):
        y, role = -k - 1.6 * (row["kind"] != "face normal"), "gap" if row["gap"] > 0 else "overlap"
        hatch = {} if row["gap"] > 0 else {"hatch": "////"}
        ax.barh(y, row["gap"], 0.62, color=theme.roles[role], alpha=0.45, linewidth=0)
        ax.barh(y, row["gap"], 0.62, facecolor="none", edgecolor=theme.roles[role], linewidth=0.8, **hatch)
        side, bold = 1 if row["gap"] > 0 else -1, "bold" if row is best else "normal"
        letters = {"textcoords": "offset points", "fontsize": TEXT, "fontweight": bold, "va": "center"}
        ends = {-1: "right", 1: "left"}
        ink, shade = theme.roles["ink"], theme.text.get(role, theme.roles[role])
        ax.annotate(row["axis"], (0, y), (-5 * side, 0), ha=ends[-side], color=ink, **letters)
        ax.annotate(digits.signed(row["gap"]), (row["gap"], y), (5 * side, 0), ha=ends[side], color=shade, **letters)
    least, most = (f(row["gap"] for row in rows) for f in (min, max))
    ax.set(xlim=(least * 1.3, most * 1.7), ylim=(-len(rows) - 1, 0.6))
    for y, text in (0.5, "face normals"), (-7.1, "edge × edge"):
        ax.text(least * 1.3, y, text, color=theme.roles["guide"], fontsize=TEXT, ha="left", va="bottom")
