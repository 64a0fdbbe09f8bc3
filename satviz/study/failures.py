"""Where each shortcut is wrong: B slid over a grid of positions, and every answer held against rationals.

A position counts as right or as one of the ways to be wrong, by the oracle of truth.py:
a verdict can be a false or a missed hit; a push can leave an overlap or be longer than
the exact depth; a distance can be another than the exact one.
"""

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from itertools import pairwise
from math import ceil, frexp
from typing import Any, NamedTuple

from ..engine.concave import parts
from ..engine.geometry import Relation, Vec
from ..engine.shapes import Polygon, Shape
from ..engine.trace import Trace, record
from ..scenes.failing import FALSE_HIT, MISSED_HIT, NAMED, ROWS, Row, where
from ..scenes.failing.reading import moved
from ..scenes.shortcuts import middle
from . import swept, threed, truth
from .cells import Cell, Settings
from .chart import Chart

APART, HIT, FALSE, MISSED, SHORT, LONG, FAR = ".oHMSLD"
WRONG = {
    FALSE: ("false hit", "false hits"),
    MISSED: ("missed hit", "missed hits"),
    SHORT: ("push too short", "pushes too short"),
    LONG: ("push too long", "pushes too long"),
    FAR: ("wrong distance", "wrong distances"),
}
PUSHES = "repeated-vertex", "raw-depth", "sum-of-parts", "push-from-center", "range-inside", "tile-seam"
DISTANCES = ("gap-as-distance",)
# no methods of their own for two shapes in the plane: row 3's again, boxes in space, frames in time
OTHERS = "line-for-axis", "faces-in-3d", "tunnelling"
VERDICTS = (*(r.name for r in ROWS if r.how in (FALSE_HIT, MISSED_HIT) and r.name not in OTHERS), "touch-on-paper")
METHODS = tuple(row.name for row in ROWS if row.name in {*VERDICTS, *PUSHES, *DISTANCES})
# wrong at exact contact only: B goes round A and touches it all the way
ALONG_CONTACT = "unit-normals", "touch-as-apart"
ON_PAPER = "touch-on-paper"
LINES = 13  # across a map, to begin with
FINE = 1 / 512  # of a map's width: no eye sees a boundary that much off
A_LITTLE = 1 + 2.0**-20  # a push this much longer leaves a rounding's worth of overlap


class Slide(NamedTuple):
    """Where B was put: its reference point at (x + i dx, y + j dy), line by line from below, or along a contact.

    `codes`: one letter a position; `path`: the positions along a contact, then `codes` is one line;
    `areas`: (letter, convex outline) of all that has boundaries, which are exact.
    """

    name: str
    x: float
    y: float
    dx: float
    dy: float
    codes: list[str]
    path: list[list[float]]
    areas: list[list[Any]]

    @property
    def counts(self) -> Counter[str]:
        return Counter("".join(self.codes))

    @property
    def wrong(self) -> int:
        return sum(self.counts[code] for code in WRONG)

    @property
    def told(self) -> str:
        """How many of each way to be wrong: "37 false hits"."""
        found = self.counts
        return ", ".join(f"{found[c]} {many if found[c] != 1 else one}" for c, (one, many) in WRONG.items() if found[c])

    def positions(self) -> Iterator[tuple[float, float, str]]:
        """Every position of the reference point with its letter."""
        if self.path:
            yield from ((x, y, code) for (x, y), code in zip(self.path, self.codes[0], strict=True))
            return
        for j, line in enumerate(self.codes):
            yield from ((self.x + i * self.dx, self.y + j * self.dy, code) for i, code in enumerate(line))


def cells(settings: Settings) -> list[Cell]:
    """A cell for each method, and those of the boxes in space and of the moving pair."""
    n = 25 if settings.quick else 61
    maps = [Cell(f"failures-{name}", slide, (name, n if name != ON_PAPER else 25)) for name in METHODS]
    return [*maps, *threed.cells(settings), *swept.cells(settings)]


def charts(results: dict[str, Any]) -> list[Chart]:
    """All maps side by side, each with its scene, and the charts of boxes in space and of the moving pair."""
    from .failure_charts import map_chart, overview

    slides = [Slide(**results[f"failures-{name}"]) for name in METHODS]
    return [overview(slides), *map(map_chart, slides), *threed.charts(results), *swept.charts(results)]


def slide(name: str, n: int) -> dict[str, Any]:
    """The Slide of a method over n x n positions, as JSON values."""
    row = NAMED[name]
    judge = _judge(row)
    at = middle(row.b)
    if name in ALONG_CONTACT:
        moves = list(contacts(row.a, row.b, n))
        codes = ["".join(judge(row.a, moved(row.b, move)) for move in moves)]
        return Slide(name, *at, 0.0, 0.0, codes, [[at.x + m.x, at.y + m.y] for m in moves], [])._asdict()
    lines = _lattice(row, n)
    (i0, dx), (j0, dy) = lines
    codes = ["".join(judge(row.a, moved(row.b, Vec((i0 + i) * dx, (j0 + j) * dy))) for i in range(n)) for j in range(n)]
    areas = [] if name == ON_PAPER else _areas(row, judge, at, [(i0 * dx, dx), (j0 * dy, dy)], n)
    return Slide(name, at.x + i0 * dx, at.y + j0 * dy, dx, dy, codes, [], areas)._asdict()


def _areas(
    row: Row, judge: Callable[[Shape, Shape], str], at: Vec, starts: Sequence[tuple[float, float]], n: int
) -> list[list[Any]]:
    """Every area with its letter: of a verdict by the difference of the shapes, else line by line."""
    (x0, dx), (y0, dy) = starts
    window = x0 - dx / 2, y0 - dy / 2, x0 + (n - 0.5) * dx, y0 + (n - 0.5) * dy
    found = where.lies(row.a, row.b, row.shortcut, window) if row.name in VERDICTS else None
    if found:
        rings = [(letter, ring) for letter, group in zip((FALSE, MISSED), found[:2]) for ring in group]
        rings += [(HIT, piece) for hit in found.hits for piece in where.without(hit, found.missed_hits)]
    else:
        rings = traced(lambda x, y: judge(row.a, moved(row.b, Vec(x, y))), window, n)
    return [[letter, [[at.x + x, at.y + y] for x, y in ring]] for letter, ring in rings]


def traced(
    letter: Callable[[float, float], str], window: tuple[float, float, float, float], n: int
) -> list[tuple[str, list[tuple[float, float]]]]:
    """The areas of each letter but that of what is right and apart, as trapezoids between lines across the window.

    A line is looked at in n places, and where the letters change is halved down to.  Where two lines have the same
    letters in the same order these places are joined, if the boundaries run straight; else a line is put between.
    """
    x0, y0, x1, y1 = window
    steps, levels = ([lo + (hi - lo) * i / k for i in range(k + 1)] for lo, hi, k in ((x0, x1, n), (y0, y1, LINES)))
    bend, least = (y1 - y0) / LINES / 8, (y1 - y0) * FINE

    def line(y: float, near: Sequence[tuple[str, float]] = ()) -> list[tuple[str, float]]:
        """The letters from left to right, each with where it ends; looked at also in the middles of the lines near."""
        ends = [x0, *(x for _, x in near)]
        places = sorted({*steps, *((p + q) / 2 for p, q in pairwise(ends) if p < q)})
        letters = [letter(x, y) for x in places]
        found = []
        for (x, here), (z, there) in pairwise(zip(places, letters, strict=True)):
            while here != there:  # there may be narrow ones between the two
                lo, hi, beyond = x, z, there
                while hi - lo > (x1 - x0) * FINE:
                    middle = (lo + hi) / 2
                    code = letter(middle, y)
                    lo, hi, beyond = (middle, hi, beyond) if code == here else (lo, middle, code)
                found.append((here, hi))
                here, x = beyond, hi
        return [*found, (letters[-1], x1)]

    def straight(below: list[tuple[str, float]], y: float, above: list[tuple[str, float]]) -> bool:
        """Do all boundaries run straight on, as half way up, at y, is seen a little to either side of each?"""
        off = 2 * (x1 - x0) * FINE
        places = [x0, *((p + q) / 2 for (_, p), (_, q) in zip(below, above, strict=True))]
        for (here, _), (there, _), (p, x, q) in zip(
            below, below[1:], zip(places, places[1:], places[2:]), strict=False
        ):
            wide = min(x - p, q - x) > 2 * off
            if wide and (letter(x - off, y) != here or letter(x + off, y) != there):
                return False
        return True

    found = []

    def between(low: float, below: list[tuple[str, float]], high: float, above: list[tuple[str, float]]) -> None:
        middle = (low + high) / 2
        same = [code for code, _ in below] == [code for code, _ in above]
        if (high - low > bend and not straight(below, middle, above)) if same else high - low > least:
            on = line(middle, [*below, (APART, x0), *above])
            between(low, below, middle, on)
            between(middle, on, high, above)
            return
        start = end = x0
        for k, (code, x) in enumerate(below):
            z = above[k][1] if len(above) == len(below) else x
            if code != APART:
                found.append((code, [(start, low), (x, low), (z, high), (end, high)]))
            start, end = x, z

    lines = [line(y) for y in levels]
    for (low, below), (high, above) in pairwise(zip(levels, lines, strict=True)):
        between(low, below, high, above)
    return found


def relation(a: Shape, b: Shape) -> Relation:
    """The exact relation; of concave outlines the closest one of their parts."""
    return max(truth.relation(p, q) for p in parts(a) for q in parts(b))


def _judge(row: Row) -> Callable[[Shape, Shape], str]:
    """The letter of a pair of shapes: what the shortcut's own run says, held against rationals."""
    of = _of_push if row.name in PUSHES else _of_distance if row.name in DISTANCES else _of_verdict
    return lambda a, b: of(record(a, b, axes=row.shortcut), row)


def _of_verdict(run: Trace, row: Row) -> str:
    says, is_hit = run.claim, bool(relation(run.a, run.b))
    return (HIT if is_hit else FALSE) if says else (MISSED if is_hit else APART)


def _of_push(run: Trace, row: Row) -> str:
    if relation(run.a, run.b) is not Relation.OVERLAPPING:
        return APART
    x, y = run.push or Vec(0.0, 0.0)
    if relation(run.a, moved(run.b, Vec(x * A_LITTLE, y * A_LITTLE))) is Relation.OVERLAPPING:
        return SHORT
    return LONG if x * x + y * y > depth2(run.a, run.b) * A_LITTLE else HIT


def _of_distance(run: Trace, row: Row) -> str:
    right = truth.distance2(run.a, run.b)
    if not right:
        return HIT
    gap = row.read(run)
    return APART if gap > 0 and right / A_LITTLE < gap * gap < right * A_LITTLE else FAR


def depth2(a: Polygon, b: Polygon) -> Fraction:
    """The exact squared depth of two convex polygons: how far the origin is from the rim of their difference."""
    ring = difference(a, b)
    found = []
    for (px, py), (qx, qy) in zip(ring, (*ring[1:], ring[0])):
        cross = px * qy - py * qx
        found.append(cross * cross / ((qx - px) ** 2 + (qy - py) ** 2))
    return min(found)


def difference(a: Polygon, b: Polygon) -> list[tuple[Fraction, Fraction]]:
    """The convex hull of all a - b, counter-clockwise, exactly."""
    every = {(Fraction(p.x) - Fraction(q.x), Fraction(p.y) - Fraction(q.y)) for p in a.vertices for q in b.vertices}

    def chain(points: Sequence[tuple[Fraction, Fraction]]) -> list[tuple[Fraction, Fraction]]:
        kept: list = []
        for p in points:
            while len(kept) > 1 and truth.turn(kept[-2], kept[-1], p) <= 0:
                kept.pop()
            kept.append(p)
        return kept[:-1]

    order = sorted(every)
    return chain(order) + chain(order[::-1])


def contacts(a: Polygon, b: Polygon, n: int) -> Iterator[Vec]:
    """Moves of B after which it touches A exactly, n steps and more along each side of a's and b's difference."""
    steps = 1 << n.bit_length()  # whole corners and a power of two: every move is a float
    ring = difference(a, b)
    for (px, py), (qx, qy) in zip(ring, (*ring[1:], ring[0])):
        yield from (
            Vec(float(px + (qx - px) * Fraction(k, steps)), float(py + (qy - py) * Fraction(k, steps)))
            for k in range(steps)
        )


def _lattice(row: Row, n: int) -> tuple[tuple[int, float], tuple[int, float]]:
    """First number and step in x and in y: round A with room for B, the scene's own position among them."""
    if row.name == ON_PAPER:
        return (-6 - n // 2, 0.05), (-(n // 2), 0.05)  # steps as a person would write them, round A's own place
    (ax0, ay0, ax1, ay1), (bx0, by0, bx1, by1) = row.a.bounds, row.b.bounds
    off = [(bx0 + bx1 - ax0 - ax1) / 2, (by0 + by1 - ay0 - ay1) / 2]
    half = [
        max((a1 - a0 + b1 - b0) / 2 * 1.2, abs(d) * 1.15)
        for a0, a1, b0, b1, d in ((ax0, ax1, bx0, bx1, off[0]), (ay0, ay1, by0, by1, off[1]))
    ]
    half = [max(h, max(half) / 4) for h in half]
    found = []
    for d, h in zip(off, half, strict=True):
        unit = 2.0 ** (frexp(2 * h / (n - 1))[1] - 4)  # four bits are enough: moved coordinates are rarely rounded
        step = ceil(2 * h / (n - 1) / unit) * unit
        found.append((round(-d / step) - n // 2, step))
    return found[0], found[1]
