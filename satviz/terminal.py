"""Printing to streams that may be closed or lack letters, and interrupts that are never lost."""

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
    """Replace streams closed at the start, and write letters that a stream cannot encode as escapes.

    They are replaced in the order of their numbers; otherwise the next file would get a closed stream's number.
    """
    for name, mode in ("stdin", "r"), ("stdout", "w"), ("stderr", "w"):
        stream = getattr(sys, name)
        if stream is None:
            setattr(sys, name, os.fdopen(os.open(os.devnull, os.O_RDWR), mode))
        elif mode == "w" and hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="backslashreplace")


def visible(text: str) -> str:
    """Return the text with control characters escaped, since a name or label must not steer the terminal."""
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in text)


def say(text: str) -> None:
    """Print one line on standard error, cut in its middle if very long; a closed stream is ignored."""
    line = visible(text)
    if len(line) > MAX_MESSAGE_LETTERS:
        line = f"{line[: MAX_MESSAGE_LETTERS // 2]} ... {line[-MAX_MESSAGE_LETTERS // 2 :]}"
    with suppress(OSError, ValueError):
        print(f"satviz: {line}", file=sys.stderr, flush=True)


def out(text: str) -> None:
    """Print lines on standard output, control characters escaped; an OSError names the stream."""
    _print("\n".join(map(visible, text.split("\n"))))


def out_json(text: str) -> None:
    """Print JSON on standard output; letters that the stream cannot encode or must not show are JSON-escaped."""

    def is_plain(c: str) -> bool:
        """Return whether a character can be printed as it is, without a JSON escape."""
        return c == "\n" or (c.isprintable() and (c.isascii() or _can_encode(c)))

    _print("".join(c if is_plain(c) else json.dumps(c)[1:-1] for c in text))


def _can_encode(c: str) -> bool:
    """Return whether standard output can show a character."""
    try:
        c.encode(sys.stdout.encoding or "utf-8")
    except UnicodeEncodeError:
        return False
    return True


def _print(text: str) -> None:
    """Print on standard output and flush it."""
    try:
        print(text, flush=True)
    except OSError as error:
        with suppress(OSError, ValueError):  # the text left in the stream must not fail once more at exit
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        raise OSError(error.errno, error.strerror, "standard output") from None


def _on_interrupt(number: int, frame: FrameType | None) -> None:
    """Record that an interrupt came, and raise KeyboardInterrupt."""
    global _interrupted
    _interrupted = True
    raise KeyboardInterrupt


@contextmanager
def remembering_interrupts(*, to_the_end: bool) -> Iterator[None]:
    """Record each interrupt, since KeyboardInterrupt vanishes when it is raised in a callback.

    `to_the_end`: the process has nothing to do after the with block, so an interrupt that comes later just ends it.
    """
    global _interrupted
    _interrupted = False
    before = signal.getsignal(signal.SIGINT)
    # another thread gets no signals, and whoever ignores or handles them goes on doing so
    if current_thread() is not main_thread() or before is not signal.default_int_handler:
        yield
        return
    previous_hook = sys.unraisablehook
    sys.unraisablehook = lambda lost: None if lost.exc_type is KeyboardInterrupt else previous_hook(lost)
    signal.signal(signal.SIGINT, _on_interrupt)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, signal.SIG_DFL if to_the_end else before)
        sys.unraisablehook = previous_hook


@contextmanager
def interrupts_ignored() -> Iterator[None]:
    """Ignore interrupts for a with block, while a started program that shares the terminal gets them."""
    mine = signal.getsignal(signal.SIGINT) is _on_interrupt
    if mine:
        signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        if mine:
            signal.signal(signal.SIGINT, _on_interrupt)


def interrupted() -> bool:
    """Return whether an interrupt came since the command began."""
    return _interrupted


def stop_if_interrupted() -> None:
    """Raise KeyboardInterrupt if an interrupt came earlier and its exception vanished."""
    if _interrupted:
        raise KeyboardInterrupt
