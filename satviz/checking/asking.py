"""Callers of the function under test: a Python function is called here, or in a process of its own."""

import os
import signal
import traceback
from collections.abc import Callable, Sequence
from contextlib import suppress
from typing import Any, NamedTuple, Protocol

from ..engine.polygon_validation import short_repr
from ..engine.shapes import Shape
from .answers import plain
from .forms import FORMS, Form

ERROR, NO_ANSWER, ENDED, WROTE = "error", "no answer", "ended", "wrote"  # what went wrong with a call
LAST = NO_ANSWER, ENDED  # problems after which nothing more is asked


class Outcome(NamedTuple):
    """The outcome of one call: the plain value that was returned, or a problem and one line that describes it."""

    value: Any = None
    problem: str = ""
    line: str = ""


class Asker(Protocol):
    """The protocol of what calls a function under test: here, in a process, in another language, or in a page."""

    def ask(self, a: Shape, b: Shape) -> Outcome:
        """Call the function with two shapes and return the outcome."""
        ...

    def close(self) -> None:
        """End the processes that were started."""
        ...


class CalledHere:
    """A Python function that is called in this process; `form` turns a shape into its argument."""

    def __init__(self, fn: Callable[[Any, Any], Any], form: Form) -> None:
        self.fn, self.form = fn, form
        self.file: str | None = None  # the file whose line numbers are named in error lines
        with suppress(Exception):  # the function's own __getattr__ may raise
            self.file = getattr(fn, "file", None) or fn.__code__.co_filename

    def ask(self, a: Shape, b: Shape) -> Outcome:
        """Call the function with fresh arguments; the problem is WROTE if they then differ from a second set of them.

        Arguments are compared only where two sets are equal at first, since an object may be equal to itself alone.
        """
        try:
            given, kept = ((self.form(a), self.form(b)) for _ in range(2))
            comparable = [_are_equal(*both) for both in zip(given, kept)]
            value = plain(self.fn(*given))
        except KeyboardInterrupt:
            raise
        except RecursionError:
            return Outcome(problem=ERROR, line="calls itself without end (RecursionError)")
        except BaseException as error:
            return Outcome(problem=ERROR, line=error_line(error, self.file))
        for name, now, was, before in zip("AB", given, kept, comparable):
            if before and not _are_equal(now, was):
                line = f"changes its argument {name}: the caller's shape is not the same afterwards"
                return Outcome(value, WROTE, line)
        return Outcome(value)

    def ask_untrusted(self, a: Shape, b: Shape) -> Outcome:
        """Call the function where no person can press Ctrl-C, so that every exception is the function's own."""
        try:
            return self.ask(a, b)
        except BaseException as error:
            return Outcome(problem=ERROR, line=error_line(error, self.file))

    def close(self) -> None:
        """Do nothing, since nothing was started."""


def _are_equal(one: Any, other: Any) -> bool:
    """Return whether two arguments hold the same values; arrays are compared as lists."""
    try:
        if hasattr(one, "tolist"):
            one, other = one.tolist(), other.tolist()
        return bool(one == other)
    except Exception:
        return False


def error_line(error: BaseException, file: str | None) -> str:
    """Return one line on an exception: its type, its message, and the last line number of `file` in its traceback."""
    words = ""
    with suppress(BaseException):  # the exception's own __str__ may raise
        words = short_repr(str(error))[1:-1]
    lines = [frame.lineno for frame in traceback.extract_tb(error.__traceback__) if frame.filename == file]
    place = f" in line {lines[-1]}" if lines else ""
    return f"raises {type(error).__name__}{place}{': ' if words else ''}{words}"


class CalledInProcess:
    """A Python function that is called in a process of its own, which is ended where a call takes too long.

    `seconds`: the time for each call; `start_seconds`: additional time for the first one.
    """

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
            # Python warns of a fork beside threads: this one only computes
            warnings.simplefilter("ignore", DeprecationWarning)
            self.process.start()
        theirs.close()

    def ask(self, a: Shape, b: Shape) -> Outcome:
        """Call the function in the process and return the Outcome; end the process where none comes in time."""
        seconds = self.seconds
        if self.process is None:
            try:
                self._start()
            except Exception as error:  # where a new process is no copy, the function must be sent to it
                return Outcome(problem=ENDED, line=f"cannot run in a process of its own: {short_repr(str(error))}")
            seconds += self.start_seconds
        try:
            self.pipe.send((a, b))
            if self.pipe.poll(seconds):
                outcome: Outcome = self.pipe.recv()
                return outcome
        except Exception:  # the pipe has an end, or something else was written to it
            self.process.join(1)
            code = self.process.exitcode
            self.close()
            how = "" if code is None else f" ({signal.Signals(-code).name if code < 0 else f'exit code {code}'})"
            return Outcome(problem=ENDED, line=f"ends the program by itself{how}")
        self.close()
        return Outcome(problem=NO_ANSWER, line=f"gives no answer within {seconds:g} s: an endless loop?")

    def close(self) -> None:
        """End the process, if it is running."""
        if self.process is not None:
            end_group(self.process)
            self.process.join()
            self.pipe.close()
            self.process = None


def end_group(process: Any) -> None:
    """Kill a process, and with it the group of processes that it leads, if it leads one."""
    with suppress(AttributeError, OSError):
        os.killpg(process.pid, signal.SIGKILL)
    process.kill()


def _answer_calls(pipe: Any, fn: Callable[[Any, Any], Any], form: Form) -> None:
    """Call the function on each pair that comes through the pipe and send the Outcome back; runs in its own process."""
    with suppress(AttributeError, OSError):
        os.setsid()
    called, own = CalledHere(fn, form), os.getpid()
    with suppress(BaseException):  # the function may have replaced anything that is used here
        while True:
            outcome = called.ask_untrusted(*pipe.recv())
            if os.getpid() != own:
                os._exit(0)  # a copy that the function made of this process
            pipe.send(outcome)


def form_named(form: str | Form) -> Form:
    """Return the function that turns a shape into an argument, by its name; a function is returned as it is.

    ValueError for an unknown name lists the names.
    """
    if callable(form):
        return form
    if form not in FORMS:
        raise ValueError(f"unknown form {short_repr(form)}: choose one of {', '.join(FORMS)}, or give a function")
    return FORMS[form]


def ask_all(asker: Asker, pairs: Sequence[tuple[Shape, Shape]]) -> list[Outcome]:
    """Return the outcome of each pair in order; it ends with the first outcome whose problem is in LAST."""
    outcomes = []
    for a, b in pairs:
        outcomes.append(asker.ask(a, b))
        if outcomes[-1].problem in LAST:
            break
    return outcomes
