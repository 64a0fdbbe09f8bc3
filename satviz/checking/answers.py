"""Answers of a function under test: how a returned value is read, and whether it is right."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import hypot, isfinite
from typing import Any, NamedTuple

from ..engine.geometry import APART, OVERLAPPING, TOUCHING, Relation, Vec
from ..engine.polygon_validation import short_repr
from ..engine.relate import relate
from ..engine.shapes import Shape
from ..engine.trace import record
from ..scenes.failing import true_value
from ..scenes.shape_tools import translated

HIT, RELATION, DEPTH, MTV, HIT_AND_MTV = "hit", "relation", "depth", "mtv", "hit and mtv"
KINDS = HIT, RELATION, HIT_AND_MTV, MTV, DEPTH  # where answers fit several kinds equally well, the first one counts
EXPECTED = {
    HIT: "True or False",
    RELATION: '"apart", "touching" or "overlapping"',
    DEPTH: "a depth, a number that is 0 or None where nothing overlaps",
    MTV: "a move (x, y), or None where nothing overlaps",
    HIT_AND_MTV: "(hit, move), such as (True, (1, 0)) or (False, None)",
}
TOUCHING_AS = "hit", "miss", "either"
MAX_TEXT, MAX_PARTS, MAX_NUMBER = 1000, 20, 1e300  # letters, parts and size of an answer that is evaluated
MAX_SHOWN = 200  # letters of an answer that cannot be read
NUMBER_TOLERANCE = 1e-9  # as a factor of the scene's size: lengths are rounded, so they are compared to nine digits
WORDS = {str(relation): relation for relation in Relation}

Answer = Any  # a bool, a Relation, a float, a Vec, None, or (bool, Vec or None), by the kind


class UnreadableAnswer(ValueError):
    """Raised for a returned value that is no answer of the expected kind; the message says what was expected."""


class Rules(NamedTuple):
    """The rules by which an answer counts as right.

    `returns`: the kind of answer; `touching`: what a verdict must say of shapes that touch; `tolerance`: verdicts
    are not judged where the gap or the depth is at most this, in scene units; `moves`: "B" or "A", the shape that
    the function's MTV moves.
    """

    returns: str = HIT
    touching: str = "hit"
    tolerance: float = 0.0
    moves: str = "B"


class Truth(NamedTuple):
    """The exact relation of two shapes and their MTV: (0, 0) where they touch, None where they are apart."""

    relation: Relation
    mtv: Vec | None


def truth_of(a: Shape, b: Shape, kind: str) -> Truth:
    """Return the Truth about two shapes by the exact engine; its MTV is None for kinds of answers without a move.

    `kind`: a kind of answer, one of the constants above.
    """
    if kind in (HIT, RELATION):
        return Truth(relate(a, b), None)
    trace = record(a, b)
    return Truth(trace.relation, trace.mtv)


@dataclass(frozen=True)
class Other:
    """A returned value that is no answer of any kind; only its text is kept."""

    text: str

    def __repr__(self) -> str:
        return self.text


def plain(raw: Any, depth: int = 3) -> Any:
    """Return a copy of a function's answer in plain values, which can be compared, sent and shown.

    These are None, bool, Relation, finite numbers, short texts, and tuples of them, nested no deeper than `depth`.
    An array or a list becomes a tuple, a fraction a float, {"x", "y"} or an object with x and y a pair, and
    {"hit", "mtv"} a pair (hit, mtv).  Anything else becomes an Other; as JSON that is {"text": ...}.
    """
    if type(raw).__module__ == "numpy" and hasattr(raw, "tolist"):
        raw = raw.tolist()
    if raw is None or isinstance(raw, bool | Relation):
        return raw
    if isinstance(raw, str):
        return str.__str__(raw) if len(raw) <= MAX_TEXT else Other(short_repr(raw))
    if isinstance(raw, int) and abs(raw) < MAX_NUMBER:
        return int(raw)
    if isinstance(raw, int):
        return Other("a number that is too large")
    if hasattr(type(raw), "__float__"):
        number = float(raw)
        return number if isfinite(number) else Other(str(number))
    if isinstance(raw, dict) and raw.keys() == {"text"}:
        return Other(str(raw["text"]))
    parts = _parts(raw) if depth else None
    return Other(short_repr(raw)) if parts is None else tuple(plain(part, depth - 1) for part in parts)


def _parts(raw: Any) -> Sequence[Any] | None:
    """Return the items of a list, (x, y), or (hit, move) of an answer; None for other answers and for long lists."""
    if isinstance(raw, dict) and {"x", "y"} <= raw.keys():
        return raw["x"], raw["y"]
    if isinstance(raw, dict) and "hit" in raw:
        return next(((raw["hit"], raw[name]) for name in ("mtv", "push", "move") if name in raw), None)
    if isinstance(raw, tuple | list):
        return raw if len(raw) <= MAX_PARTS else None
    return (raw.x, raw.y) if hasattr(raw, "x") and hasattr(raw, "y") else None


def read(value: Any, kind: str) -> Answer:
    """Return a plain value as an answer of the kind; UnreadableAnswer if that is not possible."""
    if kind == HIT and (isinstance(value, bool) or (type(value) is int and value in (0, 1))):
        return bool(value)
    if kind == RELATION:
        if isinstance(value, str) and value.lower() in WORDS:
            return WORDS[value.lower()]
        if isinstance(value, int) and not isinstance(value, bool) and value in (0, 1, 2):
            return Relation(value)
    if kind == DEPTH and (value is None or value is False or _is_number(value)):
        return max(0.0, float(value or 0.0))
    if kind == MTV and (value is None or value is False or _is_vector(value)):
        return Vec(float(value[0]), float(value[1])) if value else None
    if kind == HIT_AND_MTV and isinstance(value, tuple) and len(value) == 2 and isinstance(value[0], bool):
        return (value[0], read(value[1] if value[0] else None, MTV))
    raise UnreadableAnswer(f"returns {short_repr(value)[:MAX_SHOWN]}: expected {EXPECTED[kind]}")


def _is_number(value: Any) -> bool:
    """Return whether the plain value is a number."""
    return isinstance(value, int | float) and not isinstance(value, bool)


def _is_vector(value: Any) -> bool:
    """Return whether the plain value is a pair of numbers."""
    return isinstance(value, tuple) and len(value) == 2 and all(map(_is_number, value))


def is_right(answer: Answer, a: Shape, b: Shape, truth: Truth, rules: Rules) -> bool:
    """Return whether the answer of the kind `rules.returns` is right for these shapes."""
    kind = rules.returns
    if kind == HIT:
        return _is_right_hit(answer, truth.relation, rules) or is_tolerated(a, b, truth, rules)
    if kind == RELATION:
        loose = rules.touching == "either" and truth.relation is TOUCHING
        return loose or answer is truth.relation or is_tolerated(a, b, truth, rules)
    margin = max(rules.tolerance, NUMBER_TOLERANCE * size_of(a, b))
    if kind == DEPTH:
        return bool(abs(answer - hypot(*(truth.mtv or (0.0, 0.0)))) <= margin)
    hit, move = answer if kind == HIT_AND_MTV else (None, answer)
    if hit is not None and not (_is_right_hit(hit, truth.relation, rules) or is_tolerated(a, b, truth, rules)):
        return False
    if truth.relation is not OVERLAPPING:
        return move is None or hypot(*move) <= margin
    return _is_right_move(move, a, b, truth, margin, rules.moves) or (move is None and is_tolerated(a, b, truth, rules))


def _is_right_hit(hit: bool, relation: Relation, rules: Rules) -> bool:
    """Return whether a hit or a miss is right; of shapes that touch, `rules.touching` says which one counts."""
    if relation is TOUCHING:
        return rules.touching == "either" or hit is (rules.touching == "hit")
    return hit is (relation is OVERLAPPING)


def _is_right_move(move: Vec | None, a: Shape, b: Shape, truth: Truth, margin: float, moves: str) -> bool:
    """Return whether a move is as short as the MTV and ends the overlap; there may be several such moves.

    `margin`: the allowed error of its length and of the remaining overlap, in scene units; `moves`: "A" or "B", the
    shape that is moved.
    """
    if move is None or truth.mtv is None or abs(hypot(*move) - hypot(*truth.mtv)) > margin:
        return False
    if moves == "A":
        move = Vec(-move.x, -move.y)
    if hypot(move.x - truth.mtv.x, move.y - truth.mtv.y) <= margin:
        return True
    left = record(a, translated(b, move)).mtv
    return left is None or hypot(*left) <= margin


def is_tolerated(a: Shape, b: Shape, truth: Truth, rules: Rules) -> bool:
    """Return whether the pair is too near to touching to be judged under `rules.tolerance`."""
    if not rules.tolerance:
        return False
    if truth.relation is APART:
        return true_value.gap(a, b) <= rules.tolerance
    return truth.relation is TOUCHING or true_value.depth(a, b) <= rules.tolerance


def size_of(a: Shape, b: Shape) -> float:
    """Return the largest absolute coordinate of both shapes, the scale of their rounding."""
    return max(a.max_coordinate, b.max_coordinate)


def same_answer(one: Answer, other: Answer, kind: str, margin: float) -> bool:
    """Return whether two answers of a kind are equal; depths and moves may differ by `margin`."""
    if kind in (HIT, RELATION):
        return bool(one == other)
    if kind == DEPTH:
        return bool(abs(one - other) <= margin)
    if kind == HIT_AND_MTV:
        return one[0] == other[0] and same_answer(one[1], other[1], MTV, margin)
    one, other = one or (0.0, 0.0), other or (0.0, 0.0)
    return hypot(one[0] - other[0], one[1] - other[1]) <= margin


def recognize(raws: Sequence[Any], pairs: Sequence[tuple[Shape, Shape]], touching: str) -> str | None:
    """Return the kind in which most of the raw answers can be read; None if no answer can be read in any kind.

    Where two kinds can read equally many, it is the kind in which more of these answers are right.  `touching`: as in
    Rules.
    """
    best, found = (0, -1), None
    for kind in KINDS:
        readable = right = 0
        if kind in (MTV, DEPTH) and all(raw is None or isinstance(raw, bool) for raw in raws):
            continue  # False alone is a verdict, and a move or a depth only beside others
        for raw, (a, b) in zip(raws, pairs, strict=True):
            try:
                answer = read(raw, kind)
            except UnreadableAnswer:
                continue
            readable += raw is not None
            truth = truth_of(a, b, kind)
            rules = [Rules(kind, touching, 0.0, moves) for moves in "BA"]
            right += any(is_right(answer, a, b, truth, rule) for rule in rules)
        if readable and (readable, right) > best:
            best, found = (readable, right), kind
    return found


def in_words(answer: Answer, kind: str) -> str:
    """Return an answer in words: "hit", "depth 1.5", "no move", "hit, move (1, 0)"."""
    if kind == HIT:
        return "hit" if answer else "no hit"
    if kind == RELATION:
        return str(answer)
    if kind == DEPTH:
        return f"depth {answer:.6g}"
    if kind == HIT_AND_MTV:
        return f"{in_words(answer[0], HIT)}, {in_words(answer[1], MTV)}"
    return "no move" if answer is None else f"move ({answer[0] + 0.0:.6g}, {answer[1] + 0.0:.6g})"


def true_in_words(truth: Truth, rules: Rules) -> str:
    """Return the true answer in words, of the kind that the function returns."""
    if rules.returns in (HIT, RELATION):
        return str(truth.relation)
    if truth.relation is not OVERLAPPING or truth.mtv is None:
        return f"{truth.relation}, nothing to undo"
    if rules.returns == DEPTH:
        return f"{truth.relation}, depth {hypot(*truth.mtv):.6g}"
    sign = -1 if rules.moves == "A" else 1
    move = Vec(sign * truth.mtv.x, sign * truth.mtv.y)
    return f"{truth.relation}, {in_words(move, MTV)} of {rules.moves}"
