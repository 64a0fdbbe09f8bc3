"""Where each shortcut is wrong: B slid over a grid of positions, and every answer held against rationals.

A position counts as right or as one of the ways to be wrong, by the oracle of truth.py:
a verdict can be a false or a missed hit; a push can leave an overlap or be longer than
the exact depth; a distance can be another than the exact one.
"""

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from math import ceil, frexp
from typing import Any, NamedTuple

from ...engine.convex_parts import parts
from ...engine.geometry import Relation, Vec
from ...engine.shapes import Circle, Polygon, Shape
from ...engine.trace import Trace, record
from ...scenes.failing import FAILURE_CASES, FALSE_HIT, MISSED_HIT, NAMED, FailureCase
from ...scenes.shape_tools import translated, vertex_mean
from .. import truth

APART, HIT, FALSE, MISSED, SHORT, LONG, FAR = ".oHMSLD"
WRONG = {
    FALSE: ("false hit", "false hits"),
    MISSED: ("missed hit", "missed hits"),
    SHORT: ("push too short", "pushes too short"),
    LONG: ("push too long", "pushes too long"),
    FAR: ("wrong distance", "wrong distances"),
}
PUSHES = tuple(case.name for case in FAILURE_CASES if case.is_about_push)
DISTANCES = tuple(case.name for case in FAILURE_CASES if case.quantity == "distance")
# no methods of their own for two shapes in the plane: row 3's again, boxes in space, frames in time
OTHERS = "line-for-axis", "faces-in-3d", "tunnelling"
VERDICTS = (
    *(r.name for r in FAILURE_CASES if r.how in (FALSE_HIT, MISSED_HIT) and r.name not in OTHERS),
    "touch-on-paper",
)
METHODS = tuple(row.name for row in FAILURE_CASES if row.name in {*VERDICTS, *PUSHES, *DISTANCES})
# wrong at exact contact only: B goes round A and touches it all the way
ALONG_CONTACT = "unit-normals", "touch-as-apart"
ON_PAPER = "touch-on-paper"
A_LITTLE = 1 + 2.0**-20  # a push this much longer leaves a rounding's worth of overlap


class Slide(NamedTuple):
    """Where B was put: its reference point at (x + i dx, y + j dy), line by line from below, or along a contact.

    `codes`: one letter a position; `path`: the positions along a contact, then `codes` is one line.
    """

    name: str
    x: float
    y: float
    dx: float
    dy: float
    codes: list[str]
    path: list[list[float]]

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


def slide(name: str, n: int) -> dict[str, Any]:
    """The Slide of a method over n x n positions, as JSON values."""
    row = NAMED[name]
    judge, (a, b) = _judge(row), both(row)
    at = vertex_mean(b)
    if name in ALONG_CONTACT:
        moves = list(contacts(*_convex(a, b), n))
        codes = ["".join(judge(a, translated(b, move)) for move in moves)]
        return Slide(name, *at, 0.0, 0.0, codes, [[at.x + m.x, at.y + m.y] for m in moves])._asdict()
    lines = _lattice(row, n)
    (i0, dx), (j0, dy) = lines
    codes = ["".join(judge(a, translated(b, Vec((i0 + i) * dx, (j0 + j) * dy))) for i in range(n)) for j in range(n)]
    return Slide(name, at.x + i0 * dx, at.y + j0 * dy, dx, dy, codes, [])._asdict()


def relation(a: Shape, b: Shape) -> Relation:
    """The exact relation; of concave outlines the closest one of their parts."""
    return max(truth.relation(p, q) for p in parts(a) for q in parts(b))


def _judge(row: FailureCase) -> Callable[[Shape, Shape], str]:
    """The letter of a pair of shapes: what the shortcut's own run says, held against rationals."""
    of = _of_push if row.name in PUSHES else _of_distance if row.name in DISTANCES else _of_verdict
    return lambda a, b: of(record(a, b, axes=row.shortcut), row)


def _of_verdict(run: Trace, row: FailureCase) -> str:
    says, is_hit = run.claim, bool(relation(run.a, run.b))
    return (HIT if is_hit else FALSE) if says else (MISSED if is_hit else APART)


def _of_push(run: Trace, row: FailureCase) -> str:
    if relation(run.a, run.b) is not Relation.OVERLAPPING:
        return APART
    x, y = run.push or Vec(0.0, 0.0)
    if relation(run.a, translated(run.b, Vec(x * A_LITTLE, y * A_LITTLE))) is Relation.OVERLAPPING:
        return SHORT
    return LONG if x * x + y * y > depth2(*_convex(run.a, run.b)) * A_LITTLE else HIT


def _of_distance(run: Trace, row: FailureCase) -> str:
    right = truth.distance2(*_convex(run.a, run.b))
    if not right:
        return HIT
    gap = row.claimed_value(run)
    return APART if gap > 0 and right / A_LITTLE < gap * gap < right * A_LITTLE else FAR


def both(row: FailureCase) -> tuple[Shape, Shape]:
    """The shapes of a row that satviz does not refuse."""
    assert isinstance(row.a, Polygon | Circle) and isinstance(row.b, Polygon | Circle)
    return row.a, row.b


def _convex(a: Shape, b: Shape) -> tuple[Polygon, Polygon]:
    assert isinstance(a, Polygon) and isinstance(b, Polygon)
    return a, b


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
        kept: list[tuple[Fraction, Fraction]] = []
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


def _lattice(row: FailureCase, n: int) -> tuple[tuple[int, float], tuple[int, float]]:
    """First number and step in x and in y: round A with room for B, the scene's own position among them."""
    if row.name == ON_PAPER:
        return (-6 - n // 2, 0.05), (-(n // 2), 0.05)  # steps as a person would write them, round A's own place
    (ax0, ay0, ax1, ay1), (bx0, by0, bx1, by1) = (shape.bounds for shape in both(row))
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
