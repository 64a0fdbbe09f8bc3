"""Several pictures as one: each in its own cell, in points from the lower left corner."""

from collections.abc import Sequence

from ..engine.geometry import Vec
from .marks import Mark, Picture

HEADLINE_PT = 34.0


def panel_grid(pictures: Sequence[Picture], columns: int, *, title: str = "", sentence: str = "") -> Picture:
    """Return one picture of several, row by row, each centered in its cell; a scene unit is a point."""
    rows = [pictures[i : i + columns] for i in range(0, len(pictures), columns)]
    widths = [max(row[i].size[0] for row in rows if i < len(row)) for i in range(min(columns, len(pictures)))]
    heights = [max(picture.size[1] for picture in row) for row in rows]
    marks: list[Mark] = []
    top = sum(heights)
    for r, row in enumerate(rows):
        top -= heights[r]
        for c, picture in enumerate(row):
            left = sum(widths[:c]) + (widths[c] - picture.size[0]) / 2
            corner = Vec(left, top + (heights[r] - picture.size[1]) / 2)
            marks += marks_moved_to(picture, corner, f"{r * columns + c + 1}")
    size = sum(widths), sum(heights)
    return Picture(tuple(marks), (0.0, 0.0, *size), size, title, sentence)


def with_headline(picture: Picture, text: str) -> Picture:
    """Return a picture whose scene unit is a point, made taller for a line of bold words above it."""
    width, height = picture.size
    mark = Mark("headline", "label", "ink", (Vec(width / 2, height + HEADLINE_PT / 2),), text=text, weight="title")
    size = width, height + HEADLINE_PT
    return picture._replace(marks=(mark, *picture.marks), limits=(0.0, 0.0, *size), size=size)


def marks_moved_to(picture: Picture, corner: Vec, panel: str) -> list[Mark]:
    """Return a picture's marks with coordinates in points, its lower left corner at `corner`.

    `panel` becomes part of each mark's id, so that the marks of two pictures differ.
    """
    x0, y0, _, _ = picture.limits
    scale = picture.scale

    def to_points(points: Sequence[Vec]) -> tuple[Vec, ...]:
        """Return points of the scene as points of the picture that holds all panels."""
        return tuple(Vec(corner.x + (p.x - x0) * scale, corner.y + (p.y - y0) * scale) for p in points)

    return [
        mark._replace(
            panel=panel, points=to_points(mark.points), start=to_points(mark.start), radius=mark.radius * scale
        )
        for mark in picture.marks
    ]
