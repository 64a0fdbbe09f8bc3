"""A check in a page, where the function answers from another worker: messages in, messages out."""

from typing import Any

from ..scenes.link import fragment
from ..scenes.scenefile import shape_data, shape_from
from .answers import Rules, in_words, true_in_words
from .checked import Checked
from .options import Options
from .pairs import CheckPair
from .reading import outcome_from
from .results import judge
from .steps import Asked, Steps, steps

MESSAGES = "check", "outcomes", "judge"  # the kinds of message that `PageCheck.answer` understands


class PageCheck:
    """The check of a page: message "check" starts it, "outcomes" continues it, and "judge" judges one pair."""

    def __init__(self) -> None:
        self.running: Steps | None = None
        self.rules = Rules()

    def answer(self, content: dict[str, Any]) -> dict[str, Any]:
        """Return the reply to a message: pairs to ask about, the result of the check, or the truth about one pair."""
        kind = content["kind"]
        if kind == "judge":
            return self._judged(content)
        try:
            if kind == "check":
                self.running = steps(Options(kinds=content["kinds"], touching=content["touching"], seconds=60.0))
                return self._ask(next(self.running))
            if self.running is None:
                return {"kind": "refused", "why": "no check is running"}
            return self._ask(self.running.send([outcome_from(each) for each in content["outcomes"]]))
        except StopIteration as stop:
            self.running = None
            return self._found(stop.value)

    def _ask(self, asked: Asked) -> dict[str, Any]:
        """Return the message that asks the function about these pairs."""
        return {"kind": "ask", "pairs": [{"a": shape_data(a), "b": shape_data(b)} for a, b in asked]}

    def _found(self, checked: Checked) -> dict[str, Any]:
        """Return the message with the result of the check, and keep the rules for later messages "judge"."""
        self.rules = checked.rules
        scene = checked.counterexample
        return {"kind": "checked", **checked.data(), "link": scene and fragment(scene)}

    def _judged(self, content: dict[str, Any]) -> dict[str, Any]:
        """Return the function's answer about the shapes in the explorer, the true answer, and whether it is right."""
        a, b = shape_from(content["a"], "A"), shape_from(content["b"], "B")
        outcome = outcome_from(content["outcome"])
        result = judge(CheckPair(a, b, "", ""), outcome, self.rules)
        said = result.line if result.problem else in_words(result.answer, self.rules.returns)
        return {
            "kind": "judged",
            "right": result.right,
            "said": said,
            "answers": not result.problem,
            "truth": true_in_words(result.truth, self.rules),
        }
