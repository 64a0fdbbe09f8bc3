"""Who answers: a Python function, called here or in a process of its own."""

import traceback
from collections.abc import Callable, Sequence
from contextlib import suppress
from copy import deepcopy
from typing import Any, NamedTuple, Protocol

from ..engine.polygon_validation import short_repr
from ..engine.shapes import Shape
from .forms import FORMS, Form

ERROR, NO_ANSWER, ENDED, WROTE = "error", "no answer", "ended", "wrote"  # what went wrong with a call
LAST = NO_ANSWER, ENDED  # problems after which nothing more is asked


class Outcome(NamedTuple):
    """What came of one call: the raw value that was returned, or a problem and one line that says what it is."""

    value: Any = None
    problem: str = ""
    line: str = ""


class Asker(Protocol):
    """Whoever answers for pairs of shapes: a function here, in a process, in another language, or in a page."""

    def ask(self, a: Shape, b: Shape) -> Outcome:
        """Return what came of one call."""
        ...

    def close(self) -> None:
        """End what was started."""
        ...


class CalledHere:
    """A Python function that is called in this process."""

    def __init__(self, fn: Callable[[Any, Any], Any], form: Form) -> None:
        self.fn, self.form = fn, form

    def ask(self, a: Shape, b: Shape) -> Outcome:
        """Call the function with fresh arguments, and compare them afterwards with what they were."""
        given = self.form(a), self.form(b)
        kept = deepcopy(given)
        try:
            value = deepcopy(self.fn(*given))  # a list that is reused from call to call must not change later
        except RecursionError:
            return Outcome(problem=ERROR, line="calls itself without end (RecursionError)")
        except (Exception, SystemExit) as error:
            return Outcome(problem=ERROR, line=error_line(error, self.fn))
        if given != kept:
            which = "A" if given[0] != kept[0] else "B"
            return Outcome(value, WROTE, f"changes its argument {which}: the caller's shape is not the same afterwards")
        return Outcome(value)

    def close(self) -> None:
        """Do nothing."""


def error_line(error: BaseException, fn: Callable[..., Any] | None = None) -> str:
    """Return one line on an exception: its type, its words, and the line of the function's own file."""
    try:
        words = short_repr(str(error))[1:-1]
    except Exception:  # of its own __str__
        words = ""
    file = getattr(fn, "file", None) or getattr(getattr(fn, "__code__", None), "co_filename", None)
    lines = [frame.lineno for frame in traceback.extract_tb(error.__traceback__) if file and frame.filename == file]
    place = f" in line {lines[-1]}" if lines else ""
    return f"raises {type(error).__name__}{place}{': ' if words else ''}{words}"


class CalledInProcess:
    """A Python function that is called in a process of its own, which is ended where a call takes too long."""

    def __init__(self, fn: Callable[[Any, Any], Any], form: Form, seconds: float, start_seconds: float = 0.0) -> None:
        self.fn, self.form, self.seconds, self.start_seconds = fn, form, seconds, start_seconds
        self.process: Any = None

    def _start(self) -> None:
        """Start the process; it is a copy of this one where the system can make one."""
        import multiprocessing
        import warnings

        can_fork = "fork" in multiprocessing.get_all_start_methods()
        context: Any = multiprocessing.get_context("fork" if can_fork else "spawn")
        self.pipe, theirs = context.Pipe()
        self.process = context.Process(target=_answer_calls, args=(theirs, self.fn, self.form), daemon=True)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", DeprecationWarning)  # of a copy beside threads: the copy only computes
            self.process.start()
        theirs.close()

    def ask(self, a: Shape, b: Shape) -> Outcome:
        """Call the function in the process; end the process after `seconds`."""
        try:
            seconds = self.seconds
            if self.process is None:
                self._start()
                seconds += self.start_seconds
            self.pipe.send((a, b))
            if self.pipe.poll(seconds):
                outcome: Outcome = self.pipe.recv()
                return outcome
        except (EOFError, OSError):
            self.close()
            return Outcome(problem=ENDED, line="ends its process")
        except (AttributeError, TypeError, ValueError) as error:  # a function that cannot be sent to a new process
            self.close()
            return Outcome(problem=ENDED, line=f"cannot be sent to a process of its own: {short_repr(str(error))}")
        self.close()
        return Outcome(problem=NO_ANSWER, line=f"gives no answer within {seconds:g} s: an endless loop?")

    def close(self) -> None:
        """End the process."""
        if self.process is not None:
            self.process.kill()
            self.process.join()
            self.pipe.close()
            self.process = None


def _answer_calls(pipe: Any, fn: Callable[[Any, Any], Any], form: Form) -> None:
    """Answer the pairs that come through the pipe, in the process of its own."""
    called = CalledHere(fn, form)
    with suppress(EOFError, KeyboardInterrupt):
        while True:
            outcome = called.ask(*pipe.recv())
            try:
                pipe.send(outcome)
            except Exception as error:  # a value that cannot be sent back
                pipe.send(Outcome(problem=ERROR, line=error_line(error)))


def form_named(form: str | Form) -> Form:
    """Return the form of a name, or the caller's own function; ValueError lists the names."""
    if callable(form):
        return form
    if form not in FORMS:
        raise ValueError(f"unknown form {short_repr(form)}: choose one of {', '.join(FORMS)}, or give a function")
    return FORMS[form]


def ask_all(asker: Asker, pairs: Sequence[tuple[Shape, Shape]]) -> list[Outcome]:
    """Return what came of each pair; after one of the problems in LAST, the rest is not asked."""
    outcomes = []
    for a, b in pairs:
        outcomes.append(asker.ask(a, b))
        if outcomes[-1].problem in LAST:
            break
    return outcomes
