"""Rows where the verdict is wrong: false hits and missed hits."""

from math import sqrt

from ...engine.shapes import Circle, Polygon
from ..article import box
from ..shortcuts import NAMED
from . import claimed_value, threed, true_value
from .failure_case import FALSE_HIT, MISSED_HIT, FailureCase


def diamond(x: float, y: float, half: float) -> Polygon:
    """A square standing on its corner, its half-diagonals that long."""
    return Polygon([(x + half, y), (x, y + half), (x - half, y), (x, y - half)])


def slanted(y: float) -> Polygon:
    """A slanted bar that begins at that height."""
    return Polygon([(0, y), (6, y + 2), (6, y + 3), (0, y + 1)])


SQUARE, BESIDE = box(0, 0, 2, 2), box(3, 0.5, 5, 2.5)

HITS = (
    FailureCase(1, NAMED["aabb-not-upright"], FALSE_HIT, "gap", Polygon([(0, 0), (4, 0), (0, 4)]), box(3, 3, 4, 4)),
    FailureCase(2, NAMED["aabb-turned"], FALSE_HIT, "gap", diamond(0, 0, 1), diamond(1.5, 1.5, 1)),
    FailureCase(3, NAMED["one-overlap"], FALSE_HIT, "gap", SQUARE, BESIDE),
    FailureCase(4, NAMED["line-for-axis"], FALSE_HIT, "gap", SQUARE, BESIDE),
    FailureCase(6, NAMED["one-shapes-normals"], FALSE_HIT, "gap", SQUARE, diamond(3, 3.2, 1.6)),
    FailureCase(
        10,
        NAMED["extremes-once"],
        MISSED_HIT,
        "gap",
        Polygon([(-3, -1), (1, -3), (3, 1), (2.2, 2.6), (1, 3), (-3, 1)]),
        diamond(3.2, 3.2, 2.2),
    ),
    FailureCase(
        11,
        NAMED["open-outline"],
        FALSE_HIT,
        "gap",
        Polygon([(6, 4), (5, 0), (0, 1)]),
        Polygon([(0, 3), (1, 6), (2, 4)]),
    ),
    FailureCase(12, NAMED["mixed-signs"], MISSED_HIT, "gap", Polygon([(0, 0), (4, 0), (1, 3)]), box(1, 1, 2, 2)),
    FailureCase(
        13,
        NAMED["unit-normals"],
        MISSED_HIT,
        "gap",
        Polygon([(-7, 5), (2, -2), (-1, 4)]),
        Polygon([(1, -3), (-9, 7), (-2, -1)]),
    ),
    FailureCase(15, NAMED["lengths"], FALSE_HIT, "gap", box(-3, 0, -2, 1), box(2, 0, 3, 1)),
    FailureCase(18, NAMED["circles-turned-round"], FALSE_HIT, "gap", Circle((0, 0), 1), Circle((3, 0), 1)),
    FailureCase(19, NAMED["no-nearest-vertex"], FALSE_HIT, "gap", box(0, 0, 1, 1), Circle((1.8, 1.8), 1)),
    FailureCase(
        20,
        NAMED["dart"],
        FALSE_HIT,
        "gap",
        Polygon([(-3, -3), (4, 0), (1, 1), (0, 4)]),
        box(2.2, 2.2, 3.2, 3.2),
        right=true_value.hull_gap,
    ),
    FailureCase(
        21,
        NAMED["box-in-u"],
        FALSE_HIT,
        "gap",
        Polygon([(0, 0), (6, 0), (6, 4), (5, 4), (5, 1), (1, 1), (1, 4), (0, 4)]),
        box(2, 2, 4, 4),
    ),
    FailureCase(
        23,
        NAMED["half-the-normals"],
        FALSE_HIT,
        "gap",
        Polygon([(0, 0), (6, 0), (4, 2), (2, 2)]),
        box(-0.9, 0.4, 0.1, 1.4),
    ),
    FailureCase(24, NAMED["same-shape"], FALSE_HIT, "gap", box(-1, -1, 1, 1), diamond(1.8, 1.8, sqrt(2))),
    FailureCase(25, NAMED["far-centers"], MISSED_HIT, "gap", box(-10, -0.5, 10, 0.5), box(9, -0.5, 10, 0.5)),
    FailureCase(
        27,
        NAMED["faces-in-3d"],
        FALSE_HIT,
        "gap",
        Polygon(threed.seen_from_above(threed.PAIR[0])),
        Polygon(threed.seen_from_above(threed.PAIR[1])),
        right=true_value.gap_3d,
    ),
    FailureCase(
        32,
        NAMED["tunnelling"],
        MISSED_HIT,
        "gap",
        box(-2.1, -0.1, -1.9, 0.1),
        box(-0.05, -1, 0.05, 1),
        claimed_value.gap_at_both_frames,
        true_value.contact,
    ),
    FailureCase(33, NAMED["slipped-normal"], FALSE_HIT, "gap", slanted(0), slanted(2)),
    FailureCase(34, NAMED["touch-as-apart"], MISSED_HIT, "gap", box(0, 0, 2, 1), box(2, 0, 3, 2)),
)
