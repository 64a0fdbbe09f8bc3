"""`Checked`: the result of checking a function, as text, picture, data and score."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from html import escape
from typing import Any, NamedTuple

from ..engine import hooks
from ..engine.geometry import Relation, Vec
from ..engine.trace import record
from ..pictures import Picture, picture
from ..pictures.caption import add_captions
from ..pictures.panels import panel_grid
from ..scenes.failing import NAMED
from ..scenes.scenefile import Scene
from ..scenes.shape_tools import translated
from .answers import DEPTH, HIT_AND_MTV, MTV, Rules, in_words, true_in_words
from .forms import pasteable
from .mistakes import Likeness, symptom_of
from .pairs import BOXES, CIRCLE_AND_POLYGON, CIRCLES, CONCAVE, CONVEX, KINDS, REPEATED_VERTEX, CheckPair
from .results import WRONG, Result

RETURNS = {
    "hit": "a hit or none",
    "relation": "a relation",
    "depth": "a depth",
    "mtv": "a move out of the overlap (MTV)",
    "hit and mtv": "a hit, and a move out of the overlap (MTV)",
}
SCORE_GROUPS = {
    "upright boxes": (BOXES,),
    "convex": (CONVEX, REPEATED_VERTEX),
    "circles": (CIRCLES, CIRCLE_AND_POLYGON),
    "concave": (CONCAVE,),
}
SCORE_GROUP_OF = {kind: part for part, kinds in SCORE_GROUPS.items() for kind in kinds}
TOUCHING_PART, MTV_PART = "touching", "MTV"


class Near(NamedTuple):
    """The results of a function on pairs so near to touching that rounding can decide them.

    `asked`, `wrong`: numbers of pairs; `largest_wrong`: the largest relative margin of a wrong answer, in roundings;
    `smallest_right`: the smallest one of a right answer.
    """

    asked: int
    wrong: int
    largest_wrong: float
    smallest_right: float


class Score(NamedTuple):
    """The partial credit for a function, by kind of scene.

    `parts`: by the name of a part, (right answers, pairs).  A part is passed when all of its answers are right, so
    that guessing earns nothing.
    """

    parts: dict[str, tuple[int, int]]
    weights: dict[str, float]

    @property
    def passed(self) -> list[str]:
        """Return the names of the parts in which every answer is right."""
        return [name for name, (right, of) in self.parts.items() if right == of]

    @property
    def total(self) -> float:
        """Return the share of the weights that the passed parts earn, from 0 to 1."""
        whole = sum(self.weights.values())
        return sum(self.weights[name] for name in self.passed) / whole if whole else 0.0

    def __str__(self) -> str:
        width = max(map(len, self.parts), default=0)
        lines = [
            f"{name:{width}}  {'passed' if name in self.passed else 'failed'}  {right} of {of} right"
            for name, (right, of) in self.parts.items()
        ]
        return "\n".join([*lines, f"score {self.total:.2f}"])


@dataclass(frozen=True, slots=True)
class Checked:
    """The result of checking a function: whether it is right, and if not, the smallest scene where it is wrong.

    `right`: whether all judged answers were right; `finding`: "" or what went wrong: "wrong", "error", "no answer",
    "ended", "unreadable", "unsteady" or "wrote"; `line`: the finding in one line; `counterexample`: the smallest scene
    that shows it, or None; `said`, `truth`: the answer there and the true one; `behaves_like`: the known mistakes that
    answer like the function, the likest first; `results`: every judged pair; `unasked`: pairs that were left out;
    `near`: the results on pairs that rounding can decide, which are not judged; `notes`: further findings, in words.
    """

    right: bool
    rules: Rules
    finding: str = ""
    line: str = ""
    counterexample: Scene | None = None
    said: Any = None
    truth: Relation | float | Vec | None = None
    smallest: Result | None = None
    behaves_like: tuple[Likeness, ...] = ()
    results: tuple[Result, ...] = ()
    unasked: tuple[CheckPair, ...] = ()
    near: Near | None = None
    notes: tuple[str, ...] = ()

    @property
    def passed(self) -> dict[str, int]:
        """Return how many pairs of each group got a right answer, in the order in which they were asked."""
        found: dict[str, int] = {}
        for result in self.results:
            found[result.pair.group] = found.get(result.pair.group, 0) + result.right
        return found

    def __bool__(self) -> bool:
        """Return whether the function is right, so that `assert sv.check(fn)` says what it means."""
        return self.right

    def __str__(self) -> str:
        return "\n".join(self._lines())

    def _lines(self) -> list[str]:
        """Return the report, a line each."""
        if self.right:
            return [*_passed_lines(self), *self.notes]
        lines = [f"Wrong. {self.line}" if self.finding == WRONG else _sentence(f"Your function {self.line}")]
        if self.counterexample:
            lines += ["", f"a = {pasteable(self.counterexample.a)}", f"b = {pasteable(self.counterexample.b)}"]
            run = record(self.counterexample.a, self.counterexample.b)
            lines += [run.sentence]
        lines += _likeness_lines(self.behaves_like)
        wrong = sum(not result.right for result in self.results)
        if self.finding == WRONG and self.results:
            lines += ["", f"It is wrong on {wrong} of {len(self.results)} pairs."]
        return [*lines, *self.notes]

    @property
    def sentence(self) -> str:
        """Return the finding in one sentence."""
        return self._lines()[0]

    def data(self) -> dict[str, Any]:
        """Return the result as JSON values, for another program."""
        return {
            "right": self.right,
            "finding": self.finding,
            "sentence": self.sentence,
            "mistake": "" if self.right else " ".join([*_likeness_lines(self.behaves_like)[1:], *self.notes][:1]),
            "text": str(self),
            "said": None if self.smallest is None else repr(self.said),
            "truth": None if self.smallest is None else true_in_words(self.smallest.truth, self.rules),
            "scene": self.counterexample and self.counterexample.to_json(),
            "behaves_like": [{**each._asdict(), "claim": each.claim} for each in self.behaves_like],
            "pairs": len(self.results),
        }

    def picture(self) -> Picture:
        """Return the counterexample as two panels: what the function claims, and what is true.

        If a known mistake gives the same answer, its picture is the left panel.  For a function that returns an MTV,
        the left panel shows the shapes after this move.  ValueError if there is no counterexample.
        """
        scene = self.counterexample
        if scene is None or self.smallest is None:
            raise ValueError("there is no counterexample to draw: the function is right on every judged pair")
        if scene.axes != "needed":
            return picture(scene)
        trace = scene.record()
        said, before = _sentence(f"Your function {self.line}"), trace
        if self.finding == WRONG:
            said = f"Your function says: {self.said_in_words}."
            move = self.smallest.answer[1] if self.rules.returns == HIT_AND_MTV else self.smallest.answer
            if self.rules.returns in (MTV, HIT_AND_MTV) and move is not None and max(map(abs, move)) < 1e6:
                sign = 1 if self.rules.moves == "B" else -1
                before = record(scene.a, translated(scene.b, Vec(sign * move.x, sign * move.y)))
                said += " After it the shapes lie like this."
        panels = [picture(before, 0)._replace(sentence=said), picture(trace)._replace(sentence=trace.sentence)]
        return panel_grid(add_captions(panels), 2, title=scene.title, sentence=f"{said} {trace.sentence}")

    @property
    def said_in_words(self) -> str:
        """Return in words what the function answered for the counterexample, or its problem; "" if there is none."""
        result = self.smallest
        return "" if result is None else result.line if result.problem else in_words(result.answer, self.rules.returns)

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, str]:
        """Return what a notebook shows: the report, and the picture of the counterexample."""
        found = {"text/plain": str(self)}
        if self.counterexample is None:
            return found
        svg = hooks.mime_bundle(self.picture()).get("image/svg+xml")
        if svg:
            found |= {"image/svg+xml": svg, "text/html": f"{svg}\n<pre>{escape(str(self))}</pre>"}
        return found

    def score(self, weights: Mapping[str, float] | None = None) -> Score:
        """Return the partial credit by kind of scene: upright boxes, convex, circles, concave, touching, MTV.

        Only kinds that were asked about are parts.  `weights`: how much each part counts, 1 where it is not named.
        """
        judged = [(self._part_of(result), result.right) for result in self.results]
        judged += [(SCORE_GROUP_OF[pair.kind], False) for pair in self.unasked]
        parts: dict[str, tuple[int, int]] = {}
        for part in (*SCORE_GROUPS, TOUCHING_PART, MTV_PART):
            answers = [right for name, right in judged if name == part]
            if answers:
                parts[part] = sum(answers), len(answers)
        return Score(parts, {part: float((weights or {}).get(part, 1.0)) for part in parts})

    def _part_of(self, result: Result) -> str:
        """Return the part of a score that a result counts for."""
        if result.truth.relation is Relation.TOUCHING:
            return TOUCHING_PART
        if result.truth.relation is Relation.OVERLAPPING and self.rules.returns in (DEPTH, MTV, HIT_AND_MTV):
            return MTV_PART
        return SCORE_GROUP_OF[result.pair.kind]


def _sentence(words: str) -> str:
    """Return the words with a full stop, unless they end in a question mark."""
    return words if words.endswith("?") else f"{words}."


def _likeness_lines(likenesses: Sequence[Likeness]) -> list[str]:
    """Return the lines of a report on the known mistakes: the likest in two lines, and how the next ones differ."""
    if not likenesses:
        return []
    first, *others = likenesses
    same = f"{first.in_words}: the same answer on {first.agrees} of {first.pairs} pairs."
    if not first.is_close:
        return ["", f"No known mistake explains most of its wrong answers. The nearest is {same}"]
    lines = ["", f"It behaves like {same}"]
    if symptom := symptom_of(first.name):
        lines.append(f"In a game, something {symptom}.")
    for other in others[:2]:
        differs = other.pairs - other.agrees
        how = f"it differs on {differs} pair{'s' * (differs > 1)}."
        how = how if differs else "these pairs do not tell the two mistakes apart."
        lines.append(f"{'Less' if differs else 'Also'} like {other.in_words}: {how}")
    return lines


def _passed_lines(checked: Checked) -> list[str]:
    """Return the lines of the report on a function in which no fault was found."""
    rules, count = checked.rules, len(checked.results)
    lines = [f"Right on all {count} pairs. It returns {RETURNS[rules.returns]}."]
    lines += [f"  {right:4} {group}" for group, right in checked.passed.items()]
    if rules.returns in (MTV, HIT_AND_MTV):
        lines.append(f"Its move is a move of {rules.moves}.")
    near = checked.near
    if near and near.asked:
        lines.append(
            f"Its floats: of {near.asked} pairs that nearly touch, in rounded numbers, it is wrong on {near.wrong}."
        )
        if near.wrong:
            lines.append(f"It is wrong up to a relative margin of {near.largest_wrong:.3g} roundings.")
        lines.append(
            f"The nearest pair that it gets right has a relative margin of {near.smallest_right:.3g} roundings."
        )
    tried = {result.pair.kind for result in checked.results}
    left = [words for kind, words in KINDS.items() if kind not in tried]
    if left:
        lines.append(f"Not tried: {', '.join(left)} (kinds=...).")
    return lines


def scene_of(result: Result, likeness: str) -> Scene:
    """Return a result's pair as a scene with the axes of the known mistake `likeness`, those of `needed` for ""."""
    axes = likeness if likeness in NAMED else "needed"
    return Scene("counterexample", result.a, result.b, axes, title="Where your function is wrong")


def wrong_line(result: Result, rules: Rules) -> str:
    """Return one sentence: what the function said, and what is true."""
    said = in_words(result.answer, rules.returns)
    return f"Your function says {said}. The right answer: {true_in_words(result.truth, rules)}."
