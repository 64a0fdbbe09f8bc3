"""What the command line stands on: streams that may be closed or narrow, and Ctrl-C, which is not lost."""

import json
import os
import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from threading import current_thread, main_thread
from types import FrameType

MAX_MESSAGE_LETTERS = 1200  # letters of a message
_interrupted = False


def open_streams() -> None:
    """Stand-ins for streams that were closed at the start, and no failing over a letter that one cannot show.

    In the order of their numbers: else the next file opened would get the number of a closed stream.
    """
    for name, mode in ("stdin", "r"), ("stdout", "w"), ("stderr", "w"):
        stream = getattr(sys, name)
        if stream is None:
            setattr(sys, name, os.fdopen(os.open(os.devnull, os.O_RDWR), mode))
        elif mode == "w" and hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="backslashreplace")


def visible(text: str) -> str:
    """The text with control characters as escapes: a file's name or a label must not steer the terminal."""
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in text)


def say(text: str) -> None:
    """One line on standard error, a very long one cut in its middle; where nobody hears it, nothing is left to do."""
    line = visible(text)
    if len(line) > MAX_MESSAGE_LETTERS:
        line = f"{line[: MAX_MESSAGE_LETTERS // 2]} ... {line[-MAX_MESSAGE_LETTERS // 2 :]}"
    with suppress(OSError, ValueError):
        print(f"satviz: {line}", file=sys.stderr, flush=True)


def out(text: str) -> None:
    """Lines on standard output; an OSError names it."""
    _print("\n".join(map(visible, text.split("\n"))))


def out_json(text: str) -> None:
    """The same for JSON, which stays JSON: what the stream cannot hold or must not show is escaped as JSON does it."""

    def plain(c: str) -> bool:
        return c == "\n" or (c.isprintable() and (c.isascii() or _can_encode(c)))

    _print("".join(c if plain(c) else json.dumps(c)[1:-1] for c in text))


def _can_encode(c: str) -> bool:
    try:
        c.encode(sys.stdout.encoding or "utf-8")
    except UnicodeEncodeError:
        return False
    return True


def _print(text: str) -> None:
    try:
        print(text, flush=True)
    except OSError as error:
        with suppress(OSError, ValueError):  # what is left in the stream must not fail once more at exit
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        raise OSError(error.errno, error.strerror, "standard output") from None


def _on_interrupt(number: int, frame: FrameType | None) -> None:
    global _interrupted
    _interrupted = True
    raise KeyboardInterrupt


@contextmanager
def remembering_interrupts(*, to_the_end: bool) -> Iterator[None]:
    """Keep it in mind that an interrupt came: raised inside a callback, KeyboardInterrupt vanishes there.

    `to_the_end`: the process has nothing to do afterwards, so that a later one just ends it.
    """
    global _interrupted
    _interrupted = False
    before = signal.getsignal(signal.SIGINT)
    # another thread gets no signals, and whoever ignores or handles them goes on doing so
    if current_thread() is not main_thread() or before is not signal.default_int_handler:
        yield
        return
    told = sys.unraisablehook
    sys.unraisablehook = lambda lost: None if lost.exc_type is KeyboardInterrupt else told(lost)
    signal.signal(signal.SIGINT, _on_interrupt)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, signal.SIG_DFL if to_the_end else before)
        sys.unraisablehook = told


@contextmanager
def interrupts_ignored() -> Iterator[None]:
    """Leave interrupts to a program that was started and that shares the terminal."""
    mine = signal.getsignal(signal.SIGINT) is _on_interrupt
    if mine:
        signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        if mine:
            signal.signal(signal.SIGINT, _on_interrupt)


def interrupted() -> bool:
    """Has an interrupt come since the command began?"""
    return _interrupted


def stop_if_interrupted() -> None:
    """KeyboardInterrupt, if one came and vanished."""
    if _interrupted:
        raise KeyboardInterrupt
