"""The dial: all directions of an axis as a circle, with the sectors in which there is a gap."""

from collections.abc import Sequence

from ..engine.geometry import Vec
from ..engine.shapes import Shape
from .curve import sampled_gaps, segments_on_side, unit_vector
from .float_geometry import point_along
from .marks import Mark, Picture

SIZE_PT = 176.0, 160.0
RADIUS_PT = 52.0
TICKS = range(0, 360, 45)
TICK_NAMES_PT = 12.0  # distance from the rim of the dial to the middle of an angle's text


def dial(a: Shape, b: Shape, degree: float) -> Picture:
    """Return the dial of two shapes, with a needle at an angle in degrees; a scene unit of it is a point."""
    center = Vec(SIZE_PT[0] / 2, SIZE_PT[1] / 2)
    points, _ = sampled_gaps(a, b)
    marks = [*dial_marks(points, center, RADIUS_PT), *needle_marks(degree, center, RADIUS_PT)]
    for angle in TICKS:
        spot = point_along(center, unit_vector(angle), RADIUS_PT + TICK_NAMES_PT)
        if angle % 90 == 0:
            marks.append(Mark("angle", "label", "guide", (spot,), number=angle, text=f"{angle}\u00b0"))
    share = round(100 * sum(q[0] - p[0] for p, q in _pieces_with_gap(points)) / 180)
    says = f"on {share} % of all directions there is a gap" if share else "no direction has a gap"
    return Picture(tuple(marks), (0.0, 0.0, *SIZE_PT), SIZE_PT, "", f"The dial: {says}.")


def dial_marks(points: Sequence[tuple[float, float]], center: Vec, radius: float) -> list[Mark]:
    """Return the rim of the dial and the sectors with a gap; `points`: the gap curve, (degree, gap) from 0 to 180."""
    marks = [Mark("dial", "disc", "guide", (center,), radius=radius, weight="faint")]
    for number, run in enumerate(_sectors(points)):
        for half in (0, 1):
            rim = (point_along(center, unit_vector(d + 180.0 * half), radius) for d in run)
            marks.append(Mark("sector", "outline", "gap", (center, *rim), number=2 * number + half, weight="area"))
    return marks


def needle_marks(degree: float, center: Vec, radius: float) -> list[Mark]:
    """Return the needle, an arrow across the dial in the direction of the axis at an angle in degrees."""
    n = unit_vector(degree)
    return [Mark("needle", "arrow", "ink", (point_along(center, n, -radius), point_along(center, n, radius)))]


def _pieces_with_gap(points: Sequence[tuple[float, float]]) -> list[tuple[tuple[float, float], tuple[float, float]]]:
    """Return the pieces of the gap curve above zero, each as its two ends (degree, gap)."""
    ends = segments_on_side(points, 1)
    return list(zip(ends[::2], ends[1::2], strict=True))


def _sectors(points: Sequence[tuple[float, float]]) -> list[list[float]]:
    """Return the angles in degrees of each sector with a gap, in rising order; neighbouring pieces are one sector."""
    sectors: list[list[float]] = []
    for (start, _), (end, _) in _pieces_with_gap(points):
        if sectors and sectors[-1][-1] == start:
            sectors[-1].append(end)
        else:
            sectors.append([start, end])
    return sectors
