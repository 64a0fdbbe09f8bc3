"""The work of the study, in cells: each is run once, and its result is kept on disk with a checksum.

A cell is a function of plain arguments that returns plain JSON values.  Its result is kept under a key of everything
that decides it: the function, its arguments, the code of satviz and the versions it ran with.  Cells that measure
time run one at a time in this process, after all others, so that nothing runs beside them.
"""

import json
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import BrokenExecutor, Executor
from functools import cache
from hashlib import sha256
from pathlib import Path
from typing import Any, NamedTuple
from zlib import crc32

import numpy as np

from ...batch.chunks import ChunkFailed, in_chunks
from ...safe_write import MADE_BY, write
from .machine import machine_facts

ROOT = Path(__file__).parents[2]


class Settings(NamedTuple):
    """The options of the whole study: `quick` for fewer and smaller runs, and the seed of all random numbers."""

    quick: bool = False
    seed: int = 1

    def rng(self, *purpose: str | int) -> np.random.Generator:
        """Return the random generator of a purpose, such as a cell's name; equal seeds give equal numbers."""
        return np.random.default_rng([self.seed, *(crc32(str(word).encode()) for word in purpose)])


class Cell(NamedTuple):
    """One piece of work: `work(*arguments)`, both of which can be pickled; `timed` says that it measures time."""

    name: str
    work: Callable[..., Any]
    arguments: tuple[Any, ...]
    timed: bool = False

    @property
    def key(self) -> str:
        """Return a digest of everything that decides the result: work, arguments, machine and satviz's code."""
        facts = [self.work, self.arguments, machine_facts(), _code_digest()]
        name = json.dumps(facts, default=lambda work: f"{work.__module__}.{work.__qualname__}")
        return sha256(name.encode()).hexdigest()


@cache
def _code_digest() -> str:
    """Return a digest of all modules of satviz, so that a result is not reused after the code has changed."""
    files = sorted(ROOT.rglob("*.py"))
    return sha256(b"".join(sha256(path.read_bytes()).digest() for path in files)).hexdigest()


class Failure(NamedTuple):
    """The outcome of a failed cell, in place of a result: `why` is the error in words."""

    why: str


def run_cells(
    cells: Sequence[Cell], folder: Path, executor: Executor | None, *, force: bool = False
) -> Iterator[tuple[Cell, Any]]:
    """Yield each cell with its result or Failure: those kept in `folder` first, then new ones, saved at once.

    `executor` runs the cells that measure no time; the others run here, one by one.  A file with another key or a wrong
    checksum is ignored, and `force` overwrites it.  After a failed cell the others still run; an interrupt stops after
    the running cells.
    """
    todo = []
    for cell in cells:
        kept = _load_result(cell, folder)
        if kept is None:
            todo.append(cell)
        else:
            yield cell, kept
    for timed, pool in (False, executor), (True, None):
        some = [cell for cell in todo if cell.timed is timed]

        def job(start: int, stop: int, some: list[Cell] = some) -> tuple[Callable[..., Any], tuple[Any, ...]]:
            """Return the function and the arguments that run cell number `start` of `some`, for `in_chunks`."""
            return _attempt, (some[start].work, some[start].arguments)

        left = deque(some)
        try:
            for _, _, result in in_chunks(job, len(some), pool, None, 1):
                cell = left.popleft()
                if not isinstance(result, Failure):
                    _save_result(cell, result, folder, force)
                yield cell, result
        except (ChunkFailed, BrokenExecutor) as error:  # a worker died, and its pool runs nothing more
            for cell in left:
                yield cell, _failure(error.__cause__ or error)


def _attempt(work: Callable[..., Any], arguments: tuple[Any, ...]) -> Any:
    """Do the work; return its result after a round trip through JSON, as if read from disk, or a Failure."""
    try:
        return json.loads(json.dumps(work(*arguments), allow_nan=False))
    except Exception as error:
        return _failure(error)


def _failure(error: BaseException) -> Failure:
    """Return the Failure that holds this error's type and message."""
    return Failure(f"{type(error).__name__}: {error}")


def _result_path(cell: Cell, folder: Path) -> Path:
    """Return the path of a cell's result file; the key in its name keeps quick and full runs apart."""
    return folder / f"{cell.name}-{cell.key[:8]}.json"


def _load_result(cell: Cell, folder: Path) -> Any:
    """Return the stored result of a cell, or None if no file has its key and a right checksum."""
    try:
        data = json.loads(_result_path(cell, folder).read_text(encoding="utf-8"))
        good = data["key"] == cell.key and data["checksum"] == _checksum(data["result"])
        return data["result"] if good else None
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        return None


def _save_result(cell: Cell, result: Any, folder: Path, force: bool) -> None:
    """Write the result of a cell with its key and checksum; FileExistsError for an existing file unless `force`."""
    data = {"made_by": MADE_BY, "key": cell.key, "checksum": _checksum(result), "result": result}
    write(_result_path(cell, folder), json.dumps(data).encode(), force=force)


def _checksum(result: Any) -> str:
    """Return the SHA-256 digest of a result as JSON, by which a damaged file is noticed."""
    return sha256(json.dumps(result, sort_keys=True).encode()).hexdigest()
