"""A program in any language that answers pairs of shapes: one line of JSON in, one line of JSON out."""

import ast
import json
import os
import runpy
import shlex
import subprocess
from collections import deque
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from queue import Empty, Queue
from threading import Thread
from typing import Any

from ..engine.polygon_validation import short_repr
from ..engine.shapes import Circle, Shape
from .answers import plain
from .asking import ENDED, ERROR, NO_ANSWER, Outcome, end_group
from .forms import as_dict, plain_points

MAX_LINE = 10_000  # letters of an answer, at most
MAX_WAITING = 1000  # lines that may wait to be asked for
START_SECONDS = 10.0  # additional time for the first answer, since the program must start


def line_for(a: Shape, b: Shape) -> str:
    """Return the line that a program reads: {"a": [[x, y], ...], "b": ...}, a circle as {"circle", "radius"}."""

    def data(shape: Shape) -> Any:
        """Return a shape as JSON values."""
        return as_dict(shape) if isinstance(shape, Circle) else [list(point) for point in plain_points(shape.vertices)]

    return json.dumps({"a": data(a), "b": data(b)})


class Program:
    """A program in another process that is started once, then reads a pair and writes an answer line by line.

    `command`: the command line, run at the first pair; `seconds`: the time for each answer, and START_SECONDS more for
    the first one.
    """

    def __init__(self, command: str, seconds: float) -> None:
        self.command, self.seconds, self.process = shlex.split(command), seconds, None
        self.lines: Queue[str] = Queue(MAX_WAITING)
        self.errors: deque[str] = deque(maxlen=1)

    process: "subprocess.Popen[str] | None"

    def _start(self) -> "subprocess.Popen[str]":
        """Start the program, and two threads that read what it writes."""
        pipe = subprocess.PIPE
        process = subprocess.Popen(
            self.command, stdin=pipe, stdout=pipe, stderr=pipe, text=True, encoding="utf-8", errors="replace",
            start_new_session=True,
        )  # fmt: skip

        def read(stream: Any, keep: Callable[[str], None]) -> None:
            """Keep each line of a stream until it ends; an end is kept as an empty line."""
            with suppress(ValueError):
                while line := stream.readline(MAX_LINE):
                    keep(line)
            keep("")

        Thread(target=read, args=(process.stdout, self.lines.put), daemon=True).start()
        self.error_reader = Thread(target=read, args=(process.stderr, self._keep_error), daemon=True)
        self.error_reader.start()
        return process

    def _keep_error(self, line: str) -> None:
        """Keep the last line of the program's error output that says something."""
        if line.strip():
            self.errors.append(line.strip())

    def ask(self, a: Shape, b: Shape) -> Outcome:
        """Write one line to the program, return the line it answers as Outcome; end it where none comes in time."""
        seconds = self.seconds
        try:
            if self.process is None:
                self.process, seconds = self._start(), seconds + START_SECONDS
            assert self.process.stdin
            self.process.stdin.write(line_for(a, b) + "\n")
            self.process.stdin.flush()
        except FileNotFoundError:
            return Outcome(problem=ENDED, line=f"cannot be started: there is no program {short_repr(self.command[0])}")
        except OSError as error:
            if self.process is None:
                return Outcome(problem=ENDED, line=f"cannot be started: {error.strerror}")
            return self._ended()
        try:
            line = self.lines.get(timeout=seconds)
        except Empty:
            self.close()
            hint = "an endless loop, or an answer that is not flushed?"
            return Outcome(problem=NO_ANSWER, line=f"gives no answer within {seconds:g} s: {hint}")
        if not line:
            return self._ended()
        try:
            return Outcome(plain(json.loads(line)))
        except (ValueError, RecursionError):
            said = short_repr(line.strip())
            return Outcome(
                problem=ERROR, line=f"answers with {said}: expected one line of JSON, such as true or [1, 0]"
            )

    def _ended(self) -> Outcome:
        """Return the outcome of a program that has ended: its exit code, and the last line of its error output."""
        assert self.process
        with suppress(subprocess.TimeoutExpired):
            self.process.wait(1)
        self.error_reader.join(1)
        code, said = self.process.returncode, f": {short_repr(self.errors[-1])[1:-1]}" if self.errors else ""
        self.close()
        return Outcome(problem=ENDED, line=f"ends with exit code {code} before it answers{said}")

    def close(self) -> None:
        """End the program, if it is running."""
        if self.process is not None:
            end_group(self.process)
            self.process.wait()
            for stream in (self.process.stdin, self.process.stdout, self.process.stderr):
                with suppress(OSError, AttributeError):
                    stream.close()  # type: ignore[union-attr]
            self.process = None


class FunctionOfFile:
    """A function of a Python file, for a process of its own: the file is run at the first call, and prints nowhere."""

    def __init__(self, file: Path, name: str) -> None:
        self.file, self.name = str(file), name
        self.fn: Callable[..., Any] | None = None

    def __call__(self, a: Any, b: Any) -> Any:
        """Run the file if it has not been run, and call its function."""
        if self.fn is None:
            nowhere = os.open(os.devnull, os.O_WRONLY)
            for stream in 1, 2:
                os.dup2(nowhere, stream)  # the streams of the report must hold nothing else
            self.fn = runpy.run_path(self.file)[self.name]
        return self.fn(a, b)


def function_of(target: str) -> FunctionOfFile:
    """Return the function that "FILE.py" or "FILE.py:function" names, without running the file.

    ValueError says why there is none: no such file, no such function, or several where none is named.
    """
    path, _, name = target.partition(":") if not Path(target).is_file() else (target, "", "")
    try:
        tree = ast.parse(Path(path).read_bytes(), path)
    except OSError as error:
        raise ValueError(f"cannot read {path}: {error.strerror}") from None
    except SyntaxError as error:
        raise ValueError(f"{path} is not Python: {error.msg} in line {error.lineno or 1}") from None
    except (MemoryError, RecursionError):
        raise ValueError(f"{path} is not Python that can be read: an expression is nested too deeply") from None
    found = [node.name for node in tree.body if isinstance(node, ast.FunctionDef)]
    pairs = [n.name for n in tree.body if isinstance(n, ast.FunctionDef) and len(n.args.args) == 2]
    if name and name not in found:
        raise ValueError(f"{path} has no function {short_repr(name)}: it has {', '.join(found) or 'none'}")
    if not name and not pairs:
        raise ValueError(f"{path} has no function of two shapes: write def collide(a, b): ... in it")
    if not name and len(pairs) > 1 and "collide" not in pairs:
        raise ValueError(f"{path} has {len(pairs)} functions of two arguments: name one, {path}:{pairs[-1]}")
    return FunctionOfFile(Path(path), name or ("collide" if "collide" in pairs else pairs[0]))
