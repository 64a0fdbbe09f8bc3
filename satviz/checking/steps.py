"""The course of a check, as a generator: it yields pairs, gets sent what came of each, and returns a Checked.

Whoever runs it decides how a function is asked: a call here, a process, a program, or a worker of a page.
"""

from collections.abc import Generator, Iterable, Sequence
from math import hypot, inf
from time import monotonic
from typing import Any

from ..advice.relative_margin import relative_margin
from ..engine.geometry import Relation, Vec
from ..engine.polygon_validation import short_repr
from ..engine.shapes import Polygon, Shape
from .answers import (
    DEPTH,
    HIT,
    HIT_AND_MTV,
    MTV,
    RELATION,
    Rules,
    in_words,
    is_right,
    is_tolerated,
    recognize,
    truth_of,
)
from .asking import LAST, Outcome
from .checked import Checked, Near, scene_of, wrong_line
from .mistakes import Likeness, explains, likenesses
from .options import Options
from .pairs import BOXES, CheckPair, kind_of_pair, near_pairs, whole_number_pairs
from .results import UNSTEADY, WRONG, Result, judge
from .shrinking import shrink

FIRST_PAIRS = 24  # pairs from whose answers the kind of answer is inferred
OF_EACH_TYPE = 4  # later answers of each type that count for that, too, since the first may all be False
CHUNK = 32  # pairs that are asked at a time
ASKED_TWICE = 12  # pairs that are asked a second time, to see whether the answer stays
NEAR_PAIRS = 120
SHRINK_SECONDS = 2.0

Asked = Sequence[tuple[Shape, Shape]]
Steps = Generator[Asked, list[Outcome], Checked]


def steps(options: Options) -> Steps:
    """Check a function: yield the pairs to ask, get sent an Outcome for each, return what was found.

    Where fewer outcomes than pairs are sent, the last of them must be one without an answer.
    """
    begun = monotonic()
    pairs = _in_order(whole_number_pairs(options.named_kinds, options.seed), options)
    outcomes: list[Outcome] = []
    while len(outcomes) < len(pairs) and not _is_over(outcomes):
        if outcomes and monotonic() - begun > options.seconds:
            break
        chunk = pairs[len(outcomes) :][: CHUNK if outcomes else FIRST_PAIRS]
        outcomes += yield [(pair.a, pair.b) for pair in chunk]
    unasked = tuple(pairs[len(outcomes) :])
    rules = _rules(options, outcomes, pairs)
    notes: list[str] = []
    results = [judge(pair, outcome, rules) for pair, outcome in zip(pairs, outcomes, strict=False)]
    if unasked and not _is_over(outcomes):
        notes.append(f"Stopped after {options.seconds:g} s: {len(results)} of {len(pairs)} pairs were asked.")
    bad = next((result for result in results if not result.right), None)
    if _is_over(outcomes):
        return _found(results[-1], rules, results, unasked, notes, ())
    if results:
        again = [*range(0, len(results), max(1, len(results) // ASKED_TWICE)), results.index(bad) if bad else 0]
        second = yield [(results[i].a, results[i].b) for i in again]
        changed = _changed([results[i] for i in again], [outcomes[i] for i in again], second)
        if changed:
            return _found(changed, rules, results, unasked, notes, ())
    if bad is None:
        if rules.tolerance:
            left = sum(is_tolerated(r.a, r.b, r.truth, rules) for r in results)
            notes.append(f"The tolerance of {rules.tolerance:g} leaves {left} of {len(results)} pairs unjudged.")
        near = None if options.whole_numbers else (yield from _near(options, rules))
        if isinstance(near, Result):
            return _found(near, rules, results, unasked, notes, ())
        return Checked(True, rules, results=tuple(results), unasked=unasked, near=near, notes=tuple(notes))
    if bad.problem:
        return _found(bad, rules, results, unasked, notes, ())
    bad = yield from _shrunk(_easiest(results), rules, options)
    if always := _always_note(results, rules):
        return _found(bad, rules, results, unasked, [*notes, always], ())
    notes += _touching_notes(results, rules) + _order_notes(results)
    return _found(bad, rules, results, unasked, notes, tuple(likenesses(results, rules)))


def _is_over(outcomes: Sequence[Outcome]) -> bool:
    """Return whether the last call had a problem after which nothing more is asked."""
    return bool(outcomes) and outcomes[-1].problem in LAST


def _counter_clockwise(shape: Shape) -> Shape:
    """Return a polygon with its vertices in counter-clockwise order, a circle unchanged."""
    if not isinstance(shape, Polygon):
        return shape
    area = sum(p.x * q.y - q.x * p.y for p, q in zip(shape.vertices, (*shape.vertices[1:], shape.vertices[0])))
    return shape if area > 0 else Polygon(shape.vertices[::-1])


def _in_order(pairs: Iterable[CheckPair], options: Options) -> list[CheckPair]:
    """Return the pairs, with all vertices in counter-clockwise order if the options say so."""
    if options.clockwise:
        return list(pairs)
    return [pair._replace(a=_counter_clockwise(pair.a), b=_counter_clockwise(pair.b)) for pair in pairs]


def _rules(options: Options, outcomes: Sequence[Outcome], pairs: Sequence[CheckPair]) -> Rules:
    """Return the rules of a check; the kind of answer is recognized from the outcomes unless the options name it."""
    answered = [(outcome.value, (p.a, p.b)) for outcome, p in zip(outcomes, pairs, strict=False) if not outcome.problem]
    first = answered[:FIRST_PAIRS]
    for kind_of_value in {type(raw) for raw, _ in answered[FIRST_PAIRS:]}:
        first += [each for each in answered[FIRST_PAIRS:] if type(each[0]) is kind_of_value][:OF_EACH_TYPE]
    kind = options.returns or recognize([raw for raw, _ in first], [pair for _, pair in first], options.touching) or HIT
    rules = Rules(kind, options.touching, options.tolerance)
    if kind in (MTV, HIT_AND_MTV):
        counts = {moves: _right_count(answered, rules._replace(moves=moves)) for moves in "BA"}
        # a normal that is not turned is right about as often for either
        rules = rules._replace(moves="A" if counts["A"] > 2 * counts["B"] else "B")
    return rules


def _right_count(answered: Sequence[tuple[Any, tuple[Shape, Shape]]], rules: Rules) -> int:
    """Return how many raw answers are right, among the first pairs that overlap; `answered`: (raw answer, shapes)."""
    count = overlapping = 0
    for raw, (a, b) in answered:
        result = judge(CheckPair(a, b, "", ""), Outcome(raw), rules)
        if result.truth.relation is Relation.OVERLAPPING:
            count, overlapping = count + result.right, overlapping + 1
        if overlapping > 2 * FIRST_PAIRS:
            break
    return count


def _changed(results: Sequence[Result], before: Sequence[Outcome], after: Sequence[Outcome]) -> Result | None:
    """Return the first pair whose second answer differs from its first one, as a Result with that problem, else None.

    Values that are no answer are not compared: most objects differ even from themselves.
    """
    for result, one, other in zip(results, before, after, strict=False):
        if one.problem != other.problem or (not result.problem and one.value != other.value):
            first, second = (outcome.line or short_repr(outcome.value) for outcome in (one, other))
            line = f"changes its answer about the same shapes: first {first}, then {second}"
            return result._replace(right=False, problem=UNSTEADY, line=line)
    return None


def _easiest(results: Sequence[Result]) -> Result:
    """Return the first wrong answer about shapes that do not touch, among the first few; else the first wrong one.

    A wrong verdict about touching shapes says less about the mistake than one about shapes that overlap or are apart.
    """
    wrong = [result for result in results if not result.right and not result.problem]
    return next((r for r in wrong[:40] if r.truth.relation is not Relation.TOUCHING), wrong[0])


def _shrunk(bad: Result, rules: Rules, options: Options) -> Generator[Asked, list[Outcome], Result]:
    """Yield smaller pairs, as `steps` does; return the Result of the smallest that is wrong as `bad` is."""
    smallest, begun = bad, monotonic()
    trials = shrink(bad.a, bad.b)
    wrong: bool | None = None
    while monotonic() - begun < SHRINK_SECONDS:
        try:
            a, b = next(trials) if wrong is None else trials.send(wrong)
        except StopIteration:
            break
        wrong = False
        pair = CheckPair(a, b, bad.pair.kind, bad.pair.group)
        if _is_fit(pair, bad, options):
            result = judge(pair, (yield [(a, b)])[0], rules)
            wrong = not result.right and not result.problem and result.truth.relation is bad.truth.relation
            smallest = result if wrong else smallest
    return smallest


def _is_fit(pair: CheckPair, bad: Result, options: Options) -> bool:
    """Return whether a smaller pair may replace the wrong pair `bad`.

    It may not have a dent or a repeated vertex that `bad` does not have, nor a clockwise outline or a slanted edge if
    the options exclude these.
    """
    for shape, old in zip(pair[:2], bad.pair[:2], strict=True):
        if shape.is_convex < old.is_convex or _has_repeats(shape) > _has_repeats(old):
            return False
    if set(options.named_kinds) == {BOXES} and kind_of_pair(*pair[:2]) != BOXES:
        return False
    if not options.clockwise:
        return all(_counter_clockwise(shape) == shape for shape in pair[:2])
    return truth_of(pair.a, pair.b, HIT).relation is bad.truth.relation


def _has_repeats(shape: Shape) -> bool:
    """Return whether a vertex is listed twice."""
    return len(set(shape.vertices)) < len(shape.vertices)


def _always_note(results: Sequence[Result], rules: Rules) -> str:
    """Return a note if the answer is the same for every pair, else ""; such a function has no mistake yet."""
    answers = [None if result.problem else in_words(result.answer, rules.returns) for result in results]
    return f"It says {answers[0]} for every pair." if len(set(answers)) == 1 and answers[0] else ""


def _touching_notes(results: Sequence[Result], rules: Rules) -> list[str]:
    """Return a list with a note if the function is wrong about touching shapes only, else []."""
    wrong = [result for result in results if not result.right]
    if rules.touching == "either" or any(r.problem or r.truth.relation is not Relation.TOUCHING for r in wrong):
        return []
    for touching in ("miss", "hit"):
        other = rules._replace(touching=touching)
        if all(is_right(r.answer, r.a, r.b, r.truth, other) for r in results):
            return [f'It is right on all pairs if touching shapes count as a {touching}: touching="{touching}".']
    return ['It is wrong about shapes that touch, and about no others: with touching="either" it is right.']


def _order_notes(results: Sequence[Result]) -> list[str]:
    """Return a list with a note if the function is wrong only about vertices in clockwise order, else []."""
    wrong = [result for result in results if not result.right]
    if any(_counter_clockwise(r.a) == r.a and _counter_clockwise(r.b) == r.b for r in wrong):
        return []
    return ["It is wrong only where vertices are in clockwise order: with clockwise=False it is right."]


def _near(options: Options, rules: Rules) -> Generator[Asked, list[Outcome], Near | Result | None]:
    """Yield pairs that nearly touch, in rounded numbers, as `steps` does; return the Near of the function on them.

    None where its kind of answer has no hit or relation; the Result of a pair for which it gives no answer at all,
    since rounding is not the reason for that.
    """
    gives_verdict = rules.returns in (HIT, RELATION, HIT_AND_MTV)
    verdict_rules = rules._replace(returns=RELATION if rules.returns == RELATION else HIT)
    pairs = _in_order(near_pairs(options.named_kinds, options.seed, NEAR_PAIRS), options)
    outcomes = yield [(pair.a, pair.b) for pair in pairs]
    asked, wrong, largest, smallest = 0, 0, 0.0, inf
    for pair, outcome in zip(pairs, outcomes, strict=False):
        result = judge(pair, outcome, rules)
        if result.problem:
            hint = "the numbers are not whole there (whole_numbers=True leaves such pairs out)"
            return result._replace(line=f"{result.line}; {hint}")
        if not gives_verdict or result.truth.relation is Relation.TOUCHING:
            continue
        verdict = result.answer[0] if rules.returns == HIT_AND_MTV else result.answer
        margin, asked = relative_margin(pair.a, pair.b), asked + 1
        if is_right(verdict, pair.a, pair.b, result.truth, verdict_rules):
            smallest = min(smallest, margin)
        else:
            wrong, largest = wrong + 1, max(largest, margin)
    return Near(asked, wrong, largest, smallest) if gives_verdict else None


def _found(
    bad: Result,
    rules: Rules,
    results: Sequence[Result],
    unasked: tuple[CheckPair, ...],
    notes: Sequence[str],
    alike: tuple[Likeness, ...],
) -> Checked:
    """Return the Checked of a function with a fault.

    bad: the result that shows the fault; unasked: the pairs that were left out; notes: remarks for the
    reader; alike: the known mistakes that the function behaves like, the likest first.
    """
    shown = alike[0].name if alike and explains(alike[0].name, bad.a, bad.b, bad.answer, rules) else ""
    truth: Relation | float | Vec | None = bad.truth.relation
    if rules.returns == DEPTH:
        truth = hypot(*(bad.truth.mtv or (0.0, 0.0)))
    elif rules.returns in (MTV, HIT_AND_MTV) and bad.truth.mtv is not None:
        truth = bad.truth.mtv if rules.moves == "B" else Vec(-bad.truth.mtv.x, -bad.truth.mtv.y)
    return Checked(
        right=False,
        rules=rules,
        finding=bad.problem or WRONG,
        line=bad.line or wrong_line(bad, rules),
        counterexample=scene_of(bad, shown),
        said=bad.raw,
        truth=truth,
        smallest=bad,
        behaves_like=alike,
        results=tuple(results),
        unasked=unasked,
        notes=tuple(notes),
    )
