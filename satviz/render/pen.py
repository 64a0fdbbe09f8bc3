"""The matplotlib pen: draws a picture's marks on given Axes and updates them in place."""

from collections.abc import Sequence
from math import hypot
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.collections import PathCollection
from matplotlib.colors import to_rgba
from matplotlib.path import Path
from matplotlib.text import Text

from ..engine.geometry import Vec
from ..pictures import LIGHT, Mark, Picture, Theme
from ..pictures.theme import Style

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

Painted = tuple[Path, tuple[float, float, float, float]]  # and its colour


class Pen:
    """A pen for one Axes: it draws pictures with three collections (fills, strokes, solids) and a pool of texts.

    A redraw is quick because these few artists are kept and only get new numbers.
    """

    def __init__(self, ax: "Axes", theme: Theme = LIGHT) -> None:
        """Make a pen that draws on the Axes in the theme's colours; the Axes lose their ticks and frame."""
        self.ax = ax
        self.theme = theme
        ax.set_facecolor(theme.paper)
        ax.set(xticks=[], yticks=[])
        ax.spines[:].set_visible(False)
        self.fills = PathCollection([], linewidths=0, zorder=1)
        self.strokes = PathCollection([], facecolors="none", capstyle="butt", joinstyle="round", zorder=2)
        self.solids = PathCollection([], linewidths=0, zorder=3)
        for collection in (self.fills, self.strokes, self.solids):
            collection.set_transform(ax.transData)
            ax.add_collection(collection, autolim=False)
        self.texts: list[Text] = []

    def draw(self, picture: Picture, *, zoom: float = 1.0) -> "dict[str, Artist]":
        """Draw the picture in place of the one before; return the artist of each mark by the mark's id.

        Marks of one kind share a collection, so several ids may give one artist.  `zoom`: the factor by which the
        Axes show the picture smaller (1.0: not at all), for widths and letters, which are measured in points.
        """
        self._view(picture)
        fills: list[Painted] = []
        solids: list[Painted] = []
        strokes: list[tuple[Style, Painted]] = []
        artists: dict[str, Artist] = {}
        labels = [mark for mark in picture.marks if mark.kind == "label"]
        for mark in picture.marks:
            if mark.kind == "label":
                continue
            colour, style = self.theme.roles[mark.role], mark.style
            artists[mark.id] = self.solids if mark.kind == "dot" else self.strokes
            if style.fill:
                fills.append((_outline_path(mark, picture.scale), to_rgba(colour, style.fill)))
            if style.width:
                strokes.append((style, (_outline_path(mark, picture.scale), to_rgba(colour, style.opacity))))
            if mark.kind in ("dot", "arrow"):
                solids.append((_solid_path(mark, picture.scale), to_rgba(colour)))
        strokes.sort(key=lambda stroke: stroke[0].layer)
        for collection, painted in (self.fills, fills), (self.solids, solids):
            collection.set_paths([path for path, _ in painted])
            collection.set_facecolor([rgba for _, rgba in painted])
        self.strokes.set_paths([path for _, (path, _) in strokes])
        self.strokes.set_edgecolor([rgba for _, (_, rgba) in strokes])
        self.strokes.set_linewidth([style.width * zoom for style, _ in strokes])
        self.strokes.set_linestyle([(0, style.dash) if style.dash else "solid" for style, _ in strokes])
        self._write(labels, artists, zoom)
        return artists

    def set_fonts(self, families: Sequence[str]) -> None:
        """Let labels take each letter from the first of these fonts that has it; fewer than 2 change nothing."""
        for text in self.texts if len(families) > 1 else ():
            text.set_fontfamily(list(families))

    def remove(self) -> None:
        """Remove everything that this pen drew from the Axes."""
        for artist in (self.fills, self.strokes, self.solids, *self.texts):
            artist.remove()

    def _view(self, picture: Picture) -> None:
        """Set the limits of the Axes to those of a picture, with one scale in x and y."""
        x0, y0, x1, y1 = picture.limits
        self.ax.set_xlim(x0, x1)
        self.ax.set_ylim(y0, y1)
        self.ax.set_aspect("equal", adjustable="box")

    def _write(self, labels: Sequence[Mark], artists: "dict[str, Artist]", zoom: float) -> None:
        """Write the labels, reusing the texts of the last picture, and enter them in `artists` by mark id."""
        while len(self.texts) < len(labels):
            text = self.ax.text(0, 0, "", fontfamily="sans-serif", parse_math=False, zorder=4, clip_on=False)
            text.set(ha="center", va="center", linespacing=1.2)
            self.texts.append(text)
        for text, mark in zip(self.texts, labels):
            text.set_position(mark.points[0])
            text.set_text(mark.text)
            text.set_color(self.theme.text.get(mark.role, self.theme.roles[mark.role]))
            text.set_fontsize(mark.style.size * zoom)
            text.set_fontweight("bold" if mark.style.bold else "normal")
            text.set_visible(True)
            artists[mark.id] = text
        for text in self.texts[len(labels) :]:
            text.set_visible(False)


def _outline_path(mark: Mark, scale: float) -> Path:
    """Return the path of a mark's line, which is also the rim of a filled mark; `scale`: points in a scene unit."""
    points = mark.points
    if mark.kind == "disc":
        return Path.circle(points[0], mark.radius)
    if mark.kind == "outline":
        return Path(np.asarray([*points, points[0]], dtype=float), closed=True)
    if mark.kind == "arrow":
        u, tip, length, _ = _arrow_geometry(mark, scale)
        points = points[0], Vec(tip.x - u.x * length * 0.8, tip.y - u.y * length * 0.8)
    codes = [Path.MOVETO, Path.LINETO] * (len(points) // 2) if mark.kind == "segment" else None
    return Path(np.asarray(points, dtype=float), codes)


def _solid_path(mark: Mark, scale: float) -> Path:
    """Return the path around a dot or an arrow's head; `scale`: points in a scene unit."""
    if mark.kind == "arrow":
        u, tip, length, half = _arrow_geometry(mark, scale)
        bx, by = tip.x - u.x * length, tip.y - u.y * length
        return Path([tip, (bx - u.y * half, by + u.x * half), (bx + u.y * half, by - u.x * half), tip], closed=True)
    (x, y), r = mark.points[0], mark.style.size / 2 / scale
    if mark.style.square:
        return Path([(x - r, y - r), (x + r, y - r), (x + r, y + r), (x - r, y + r), (x - r, y - r)], closed=True)
    return Path.circle((x, y), r)


def _arrow_geometry(mark: Mark, scale: float) -> tuple[Vec, Vec, float, float]:
    """Return (unit direction, tip, length of the head, half of its width) of an arrow, in scene units.

    scale: points for one scene unit.
    """
    (tail, tip), (length, width) = mark.points, mark.style.head
    size = hypot(tip.x - tail.x, tip.y - tail.y) or 1.0
    u = Vec((tip.x - tail.x) / size, (tip.y - tail.y) / size)
    return u, tip, min(length / scale, size), width / 2 / scale
