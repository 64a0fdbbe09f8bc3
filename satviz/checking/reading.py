"""The reader's function in a page: Python code in a worker of its own, and outcomes as JSON values."""

import inspect
import io
import json
from collections.abc import Callable
from contextlib import redirect_stderr, redirect_stdout
from typing import Any

from ..scenes.scenefile import shape_from
from .answers import plain
from .asking import ERROR, CalledHere, Outcome, error_line
from .forms import as_points

FILE = "your code"  # the file name in which errors count lines
MAX_TEXT = 400  # letters of a line that comes from a worker
MAX_PRINTED = 2000  # letters of what the code prints that are kept


class Printed(io.StringIO):
    """A text stream that keeps what the code under test prints, up to MAX_PRINTED characters."""

    def write(self, text: str) -> int:
        """Keep the part of the text for which there is space; return the length of all of it, as if it were written."""
        super().write(text[: MAX_PRINTED - self.tell()])
        return len(text)

    def close(self) -> None:
        """Stay open: the code under test may close what it prints to."""


class ReaderPython:
    """The code that the reader wrote: "define" runs it, and "ask" calls its function about one pair."""

    def __init__(self) -> None:
        self.called: CalledHere | None = None

    def answer(self, content: dict[str, Any]) -> dict[str, Any]:
        """Return the reply to a message: the fault of the code, or the outcome of one call, and what was printed."""
        with redirect_stdout(Printed()) as printed, redirect_stderr(printed):
            reply = self._define(content["code"]) if content["kind"] == "define" else self._call(content)
        return {**reply, "printed": printed.getvalue()}

    def _call(self, content: dict[str, Any]) -> dict[str, Any]:
        """Call the function with the pair of a message and return the outcome as JSON values."""
        a, b = shape_from(content["a"], "A"), shape_from(content["b"], "B")
        if self.called is None:
            return {"problem": ERROR, "line": "is not defined"}
        return outcome_data(self.called.ask_untrusted(a, b))

    def _define(self, code: str) -> dict[str, Any]:
        """Run the code and keep its `collide`, or its last function of two arguments; return {"why": fault or ""}."""
        names: dict[str, Any] = {"__name__": "reader"}
        if "\0" in code:  # Python's versions raise different errors for it
            return {"why": "This is not Python: the code has a null character."}
        try:
            exec(compile(code, FILE, "exec"), names)
        except SyntaxError as error:
            return {"why": f"This is not Python: {error.msg} in line {error.lineno or 1}."}
        except BaseException as error:
            return {"why": f"The code {error_line(error, FILE)}."}
        fn = names.get("collide") or _last_function_of_two(names)
        if not callable(fn):
            return {"why": "There is no function of two shapes: write def collide(a, b): ..."}
        self.called = CalledHere(fn, as_points)
        return {"why": ""}


def _last_function_of_two(names: dict[str, Any]) -> Callable[..., Any] | None:
    """Return the last function of two arguments that the code defines, or None."""
    found = [f for f in names.values() if inspect.isfunction(f) and f.__code__.co_argcount == 2]
    return found[-1] if found else None


def outcome_data(outcome: Outcome) -> dict[str, Any]:
    """Return an outcome as JSON values; an Other as {"text": ...}."""
    data: dict[str, Any] = json.loads(json.dumps(outcome._asdict(), default=vars))
    return data


def outcome_from(data: Any) -> Outcome:
    """Return the Outcome in JSON values that come from a worker, which the reader's code may have forged."""
    if not isinstance(data, dict):
        return Outcome(problem=ERROR, line="answers with a message that is not an outcome")
    problem, line = (str(data.get(key) or "")[:MAX_TEXT] for key in ("problem", "line"))
    return Outcome(plain(data.get("value")), problem, line if line.isprintable() else repr(line))
