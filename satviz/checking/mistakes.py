"""Known mistakes as hypotheses: what each failing case would have answered, compared with what a function answered.

A *failing case* (`scenes/failing`) is a common mistake, as a Shortcut, with a scene where it is wrong.
"""

from collections.abc import Iterator, Sequence
from functools import lru_cache, partial
from itertools import product
from math import hypot
from typing import NamedTuple

from ..engine.geometry import APART, OVERLAPPING, TOUCHING, Relation, Vec
from ..engine.shapes import Shape
from ..engine.shortcut import Shortcut
from ..scenes.failing import FAILURE_CASES, FALSE_HIT, MISSED_HIT, NAMED, REFUSED
from .answers import (
    DEPTH,
    HIT,
    HIT_AND_MTV,
    MTV,
    NUMBER_TOLERANCE,
    RELATION,
    Answer,
    Rules,
    is_right,
    same_answer,
    size_of,
)
from .other_methods import VARIANTS as VARIANTS_OF_OTHERS
from .other_methods import by_shortcut
from .pairs import BOXES, CIRCLE_AND_POLYGON, CIRCLES, CONVEX, KNOWN_SCENES, kind_of_pair
from .results import Result
from .written import VARIANTS, Predict

# What a mistake looks like in a game or a drawing program, in the words of the people who see it.  A test simulates it.
SYMPTOMS = {
    words: names.split()
    for words, names in {
        "collides with nothing: a hit where there is space": (
            "aabb-not-upright aabb-turned one-overlap line-for-axis one-sided-gap bounding-circles "
            "one-shapes-normals half-the-normals same-shape open-outline slipped-normal start-at-zero "
            "lengths no-nearest-vertex circles-turned-round dart box-in-u faces-in-3d rounded-normals "
            "degrees-for-radians"
        ),
        "falls through: no hit where the shapes overlap": (
            "corner-inside edges-cross far-centers extremes-once mixed-signs tunnelling circles-turned-round"
        ),
        "jitters: touching is a hit in one frame and none in the next": (
            "touch-as-apart unit-normals touch-on-paper far-centers mixed-signs circles-turned-round integer-halves"
        ),
        "is pushed too far": (
            "raw-depth tile-seam aabb-not-upright aabb-turned one-overlap line-for-axis bounding-circles "
            "degrees-for-radians largest-overlap"
        ),
        "is pushed the wrong way": (
            "push-along-normal push-from-center sum-of-parts repeated-vertex raw-depth corner-inside largest-overlap"
        ),
        "sticks, or is not pushed out all the way": (
            "range-inside push-along-normal push-from-center sum-of-parts repeated-vertex corner-inside "
            "half-the-way integer-halves"
        ),
    }.items()
}


def symptom_of(name: str) -> str:
    """Return the symptom of a mistake in the words of those who see it, such as "falls through"; "" if it has none."""
    return next((words for words, names in SYMPTOMS.items() if name in names), "")


def mistakes_with(words: str) -> list[str]:
    """Return the names of the mistakes whose symptom has most of these words, such as "falls through"; [] if none."""
    asked = {word.strip(".,:;!?").lower() for word in words.split()} - {"it", "the", "a", "is", "in", "my", "and", "to"}
    scored = [
        (len(asked & set(symptom.lower().replace(":", "").replace(",", "").split())), symptom) for symptom in SYMPTOMS
    ]
    most = max(score for score, _ in scored)
    return [n for score, symptom in scored if score == most and most for n in SYMPTOMS[symptom]]


class Likeness(NamedTuple):
    """The likeness of a function's answers to those of a known mistake.

    `agrees`: on how many of the `pairs` both give the same answer, or both a right one; `wrong_alike`: on how many
    of those that either is wrong about (`either_wrong`) both give the same wrong answer; `variant`: how the
    mistake is made, if not as in its failing case.
    """

    name: str
    agrees: int
    pairs: int
    wrong_alike: int
    either_wrong: int
    variant: str = ""

    @property
    def is_close(self) -> bool:
        """Return whether function and mistake give the same wrong answer on nearly all pairs where either is wrong."""
        return self.wrong_alike >= CLOSE * self.either_wrong

    @property
    def claim(self) -> str:
        """Return the mistake as people say it."""
        return NAMED[self.name].claim

    @property
    def in_words(self) -> str:
        """Return the mistake's name and claim, and in brackets its variant if there is one."""
        return f"{self.name}: “{self.claim}”{self.variant and f' ({self.variant})'}"

    def __str__(self) -> str:
        return f"{self.name} on {self.agrees} of {self.pairs} pairs"


class Hypothesis(NamedTuple):
    """A known mistake by the name of its failing case, and the answers of a function with this mistake.

    `variant`: as in Likeness.
    """

    name: str
    predict: Predict
    variant: str = ""

    def is_about(self, rules: Rules) -> bool:
        """Return whether the mistake can be seen in answers of this kind."""
        case = NAMED[self.name]
        return case.how in (FALSE_HIT, MISSED_HIT) or (
            case.is_about_push and rules.returns in (DEPTH, MTV, HIT_AND_MTV)
        )


NOT_AT_REST = "faces-in-3d", "tunnelling"  # about boxes in space, and about motion: no answer for two shapes shows them


def _own_kind(name: str) -> str:
    """Return the kind of pair in the failing case of this name; upright boxes count as convex polygons."""
    kind = kind_of_pair(*NAMED[name].shapes)
    return CONVEX if kind == BOXES else kind


def _hypotheses() -> Iterator[Hypothesis]:
    """Yield each failing case once, and the ways in which people write the same mistake differently."""
    seen: list[tuple[Shortcut, str]] = []
    for case in FAILURE_CASES:
        if case.how == REFUSED or case.name in NOT_AT_REST:
            continue
        alike = case.shortcut._replace(name="", claim=""), _own_kind(case.name)
        if alike in seen:
            continue
        seen.append(alike)
        yield Hypothesis(case.name, partial(by_shortcut, case.shortcut))
    yield from (Hypothesis(*variant) for variant in (*VARIANTS, *VARIANTS_OF_OTHERS))


HYPOTHESES = tuple(_hypotheses())
CLOSE = 0.8  # share of equal wrong answers from which a mistake is named: other ways to write it have more, others less
MAX_COMPARED = 160  # pairs on which each hypothesis is run, those first about which the function is wrong


def likenesses(results: Sequence[Result], rules: Rules) -> list[Likeness]:
    """Return the known mistakes that share wrong answers with a function, the likest first (by `_rank`)."""
    readable = [result for result in results if not result.problem]
    wrong = [result for result in readable if not result.right]
    compared = [*wrong[: MAX_COMPARED // 2]]
    compared += [result for result in readable if result.right and result.pair.group == KNOWN_SCENES]
    others = [result for result in readable if result.right and result.pair.group != KNOWN_SCENES]
    step = max(1, len(others) // (MAX_COMPARED - len(compared)))
    compared += others[::step][: MAX_COMPARED - len(compared)]
    found: dict[str, Likeness] = {}
    asked = [rules, rules._replace(touching="miss")][: 1 + _misses_touching(readable, rules)]
    with_circles = any(result.pair.kind in (CIRCLES, CIRCLE_AND_POLYGON) for result in readable)
    for hypothesis, each in product(HYPOTHESES, asked):
        is_of_circles = not hypothesis.variant and _own_kind(hypothesis.name) in (CIRCLES, CIRCLE_AND_POLYGON)
        if not hypothesis.is_about(rules) or (is_of_circles and not with_circles):
            continue
        likeness = _likeness(hypothesis, compared, rules, each)
        best = found.get(hypothesis.name)
        if likeness and (best is None or _rank(likeness) < _rank(best)):
            found[hypothesis.name] = likeness
    kinds = {CONVEX if result.pair.kind == BOXES else result.pair.kind for result in wrong}

    def is_elsewhere(likeness: Likeness) -> bool:
        """Return whether the mistake's own scene is of a kind about which the function is never wrong."""
        return _own_kind(likeness.name) not in kinds

    return sorted(found.values(), key=lambda likeness: (_rank(likeness), is_elsewhere(likeness)))


def _rank(likeness: Likeness) -> tuple[float, int]:
    """Return the key by which likenesses are sorted: the share of equal wrong answers, then of equal answers."""
    return -likeness.wrong_alike / likeness.either_wrong, -likeness.agrees


def _misses_touching(results: Sequence[Result], rules: Rules) -> bool:
    """Return whether under a quarter of touching pairs are called hits: then mistakes are also tried with < for <=."""
    if rules.returns not in (HIT, HIT_AND_MTV):
        return False
    touching = [result.answer for result in results if result.truth.relation is TOUCHING]
    hits = sum(bool(answer[0] if rules.returns == HIT_AND_MTV else answer) for answer in touching)
    return 4 * hits < len(touching)


def _likeness(hypothesis: Hypothesis, results: Sequence[Result], rules: Rules, asked: Rules) -> Likeness | None:
    """Return the Likeness of the answers to those of a hypothesis; None if no wrong answer is shared.

    `rules`: those of the check; `asked`: those by which the hypothesis answers about shapes that touch.
    """
    agrees = alike = either = missed = not_touching = 0
    for i, result in enumerate(results):
        predicted = predicted_answer(hypothesis, result.a, result.b, asked)
        # where a mistake has no answer, as one about circles for polygons, it changes nothing
        fits = predicted is None or is_right(predicted[0], result.a, result.b, result.truth, rules)
        margin = 1e3 * NUMBER_TOLERANCE * size_of(result.a, result.b)
        equal = predicted is not None and _alike(
            predicted[0], result.answer, rules.returns, margin, fits or result.right
        )
        agrees += equal or (fits and result.right)
        either += not (fits and result.right)
        alike += equal and not result.right
        not_touching += equal and not result.right and result.truth.relation is not TOUCHING
        missed += not result.right and not equal
        if i >= 11 and missed > 9 * alike:
            return None  # too few of the wrong answers, which come first, are explained
    if not alike or (asked != rules and not not_touching):
        return None  # wrong answers about touching shapes alone are the mistake touch-as-apart
    return Likeness(hypothesis.name, agrees, len(results), alike, either, hypothesis.variant)


def _alike(one: Answer, other: Answer, kind: str, margin: float, one_is_right: bool) -> bool:
    """Return whether two answers are equal, or both wrong moves of one length: several axes may have one depth.

    `one_is_right`: whether any of the two is right.
    """
    if same_answer(one, other, kind, margin):
        return True
    if kind == HIT_AND_MTV:
        return bool(one[0] == other[0]) and _alike(one[1], other[1], MTV, margin, one_is_right)
    return kind == MTV and not one_is_right and bool(one and other) and abs(hypot(*one) - hypot(*other)) <= margin


@lru_cache(maxsize=1 << 14)  # another function is asked about the same pairs
def _prediction(hypothesis: Hypothesis, a: Shape, b: Shape) -> tuple[Relation, Vec | None] | None:
    """Return the relation and the push that follow from the mistake; None where it has no answer."""
    try:
        return hypothesis.predict(a, b)
    except (ValueError, ArithmeticError):
        return None


def predicted_answer(hypothesis: Hypothesis, a: Shape, b: Shape, rules: Rules) -> tuple[Answer] | None:
    """Return a tuple with the answer that the mistake gives, in the kind of `rules`; None where it has no answer.

    The tuple keeps an answer of None (no move) apart from no answer.
    """
    predicted = _prediction(hypothesis, a, b)
    if predicted is None:
        return None
    claim, push = predicted
    hit = claim is OVERLAPPING or (claim is TOUCHING and rules.touching != "miss")
    if push is not None and rules.moves == "A":
        push = Vec(-push.x, -push.y)
    if claim is APART:
        push = None
    answers: dict[str, Answer] = {
        HIT: hit,
        RELATION: claim,
        DEPTH: hypot(*(push or (0.0, 0.0))),
        MTV: push,
        HIT_AND_MTV: (hit, push if hit else None),
    }
    return (answers[rules.returns],)


def explains(name: str, a: Shape, b: Shape, answer: Answer, rules: Rules) -> bool:
    """Return whether the failing case of this name gives this very answer for a pair, so that its picture shows it."""
    hypothesis = Hypothesis(name, partial(by_shortcut, NAMED[name].shortcut))
    predicted = predicted_answer(hypothesis, a, b, rules)
    margin = 1e3 * NUMBER_TOLERANCE * size_of(a, b)
    return predicted is not None and same_answer(predicted[0], answer, rules.returns, margin)
