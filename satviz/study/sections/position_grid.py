"""Where each shortcut is wrong: B is placed on a grid of positions, and every answer is compared with the exact one.

Each position gets a letter, by the rational arithmetic of truth.py.  A verdict can be a false hit or a missed hit; a
push can leave an overlap or be longer than the exact depth; a distance can differ from the exact one.
"""

from collections import Counter
from collections.abc import Callable, Iterator
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

APART, HIT, FALSE_HIT_CODE, MISSED_HIT_CODE, SHORT_PUSH, LONG_PUSH, WRONG_DISTANCE = ".oHMSLD"
ERROR_NAMES = {
    FALSE_HIT_CODE: ("false hit", "false hits"),
    MISSED_HIT_CODE: ("missed hit", "missed hits"),
    SHORT_PUSH: ("push too short", "pushes too short"),
    LONG_PUSH: ("push too long", "pushes too long"),
    WRONG_DISTANCE: ("wrong distance", "wrong distances"),
}
PUSHES = tuple(case.name for case in FAILURE_CASES if case.is_about_push)
DISTANCES = tuple(case.name for case in FAILURE_CASES if case.quantity == "distance")
# not mapped: one uses the method of another case, one is about boxes in space, one about frames in time
NOT_MAPPED = "line-for-axis", "faces-in-3d", "tunnelling"
VERDICTS = (
    *(r.name for r in FAILURE_CASES if r.how in (FALSE_HIT, MISSED_HIT) and r.name not in NOT_MAPPED),
    "touch-on-paper",
)
MAPPED_SHORTCUTS = tuple(case.name for case in FAILURE_CASES if case.name in {*VERDICTS, *PUSHES, *DISTANCES})
# these are wrong at exact contact only, so B goes round A and touches it all the way
ALONG_CONTACT = "unit-normals", "touch-as-apart"
TOUCH_ON_PAPER = "touch-on-paper"
ROUNDING_FACTOR = 1 + 2.0**-20  # a push this much longer than exact may still leave an overlap, by rounding


class PositionGrid(NamedTuple):
    """The positions of B's reference point with a letter for each: a lattice, or positions along a contact.

    A lattice has the points (x + i dx, y + j dy), and `codes[j][i]` is the letter of one.  `path`: the positions along
    a contact, whose letters are `codes[0]`; empty for a lattice.
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
        """Return how many positions have each letter."""
        return Counter("".join(self.codes))

    @property
    def wrong(self) -> int:
        """Return how many positions are wrong in any way."""
        return sum(self.counts[code] for code in ERROR_NAMES)

    @property
    def counts_in_words(self) -> str:
        """Return the counts of each kind of error in words, for example "37 false hits"."""
        counts = {code: self.counts[code] for code in ERROR_NAMES if self.counts[code]}
        return ", ".join(f"{n} {ERROR_NAMES[code][n != 1]}" for code, n in counts.items())

    def positions(self) -> Iterator[tuple[float, float, str]]:
        """Yield (x, y, letter) of every position of the reference point."""
        if self.path:
            yield from ((x, y, code) for (x, y), code in zip(self.path, self.codes[0], strict=True))
            return
        for j, line in enumerate(self.codes):
            yield from ((self.x + i * self.dx, self.y + j * self.dy, code) for i, code in enumerate(line))


def evaluate_grid(name: str, n: int) -> dict[str, Any]:
    """Return the PositionGrid of a shortcut as JSON values; `n`: positions along each side."""
    case = NAMED[name]
    code_of, (a, b) = _evaluator(case), shapes_of(case)
    at = vertex_mean(b)
    if name in ALONG_CONTACT:
        moves = list(contact_moves(*_as_polygons(a, b), n))
        codes = ["".join(code_of(a, translated(b, move)) for move in moves)]
        return PositionGrid(name, *at, 0.0, 0.0, codes, [[at.x + m.x, at.y + m.y] for m in moves])._asdict()
    (i0, dx), (j0, dy) = _lattice(case, n)
    codes = ["".join(code_of(a, translated(b, Vec((i0 + i) * dx, (j0 + j) * dy))) for i in range(n)) for j in range(n)]
    return PositionGrid(name, at.x + i0 * dx, at.y + j0 * dy, dx, dy, codes, [])._asdict()


def exact_relation(a: Shape, b: Shape) -> Relation:
    """Return the exact relation of two shapes: the highest Relation over all pairs of their convex parts."""
    return max(truth.relation(p, q) for p in parts(a) for q in parts(b))


def _evaluator(case: FailureCase) -> Callable[[Shape, Shape], str]:
    """Return a function of two shapes that runs the case's shortcut on them and returns the answer's letter."""
    code_of = _push_code if case.name in PUSHES else _distance_code if case.name in DISTANCES else _verdict_code
    return lambda a, b: code_of(record(a, b, axes=case.shortcut), case)


def _verdict_code(run: Trace, case: FailureCase) -> str:
    """Return the letter of a run's verdict: apart or hit where it is right, false hit or missed hit."""
    claims_hit, is_hit = run.claim, bool(exact_relation(run.a, run.b))
    return (HIT if is_hit else FALSE_HIT_CODE) if claims_hit else (MISSED_HIT_CODE if is_hit else APART)


def _push_code(run: Trace, case: FailureCase) -> str:
    """Return the letter of a run's push: HIT if it is right, too short, too long; APART without an overlap."""
    if exact_relation(run.a, run.b) is not Relation.OVERLAPPING:
        return APART
    x, y = run.push or Vec(0.0, 0.0)
    if exact_relation(run.a, translated(run.b, Vec(x * ROUNDING_FACTOR, y * ROUNDING_FACTOR))) is Relation.OVERLAPPING:
        return SHORT_PUSH
    return LONG_PUSH if x * x + y * y > truth.squared_depth(*_as_polygons(run.a, run.b)) * ROUNDING_FACTOR else HIT


def _distance_code(run: Trace, case: FailureCase) -> str:
    """Return the letter of a run's distance: APART if right but for rounding, or wrong; HIT if shapes meet."""
    right = truth.squared_distance(*_as_polygons(run.a, run.b))
    if not right:
        return HIT
    gap = case.claimed_value(run)
    return APART if gap > 0 and right / ROUNDING_FACTOR < gap * gap < right * ROUNDING_FACTOR else WRONG_DISTANCE


def shapes_of(case: FailureCase) -> tuple[Shape, Shape]:
    """Return the two shapes of a case; its outlines must be such that the engine accepts them."""
    assert isinstance(case.a, Polygon | Circle) and isinstance(case.b, Polygon | Circle)
    return case.a, case.b


def _as_polygons(a: Shape, b: Shape) -> tuple[Polygon, Polygon]:
    """Return both shapes typed as Polygon, after an assertion that they are polygons."""
    assert isinstance(a, Polygon) and isinstance(b, Polygon)
    return a, b


def contact_moves(a: Polygon, b: Polygon, n: int) -> Iterator[Vec]:
    """Yield moves of B after which it touches A exactly: at least n along each side of the difference A - B."""
    steps = 1 << n.bit_length()  # corners are whole numbers and steps a power of two, so every move is a float
    ring = truth.exact_difference(a, b)
    for (px, py), (qx, qy) in zip(ring, (*ring[1:], ring[0])):
        yield from (
            Vec(float(px + (qx - px) * Fraction(k, steps)), float(py + (qy - py) * Fraction(k, steps)))
            for k in range(steps)
        )


def _lattice(case: FailureCase, n: int) -> tuple[tuple[int, float], tuple[int, float]]:
    """Return (index of the first move, step) in x and in y, for n x n moves of B all round A, no move included."""
    if case.name == TOUCH_ON_PAPER:
        return (-6 - n // 2, 0.05), (-(n // 2), 0.05)  # steps as a person would write them
    (ax0, ay0, ax1, ay1), (bx0, by0, bx1, by1) = (shape.bounds for shape in shapes_of(case))
    offsets = [(bx0 + bx1 - ax0 - ax1) / 2, (by0 + by1 - ay0 - ay1) / 2]
    half = [
        max((a1 - a0 + b1 - b0) / 2 * 1.2, abs(d) * 1.15)
        for a0, a1, b0, b1, d in ((ax0, ax1, bx0, bx1, offsets[0]), (ay0, ay1, by0, by1, offsets[1]))
    ]
    half = [max(h, max(half) / 4) for h in half]
    found = []
    for d, h in zip(offsets, half, strict=True):
        unit = 2.0 ** (frexp(2 * h / (n - 1))[1] - 4)  # four bits are enough: moved coordinates are rarely rounded
        step = ceil(2 * h / (n - 1) / unit) * unit
        found.append((round(-d / step) - n // 2, step))
    return found[0], found[1]
