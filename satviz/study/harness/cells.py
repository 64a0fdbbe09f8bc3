"""The study's work in cells: each done once, kept on disk with a checksum, and not done again.

A cell is a function of plain arguments that gives plain JSON values.  It is kept under
a key of all that decides its result: the function, its arguments, the code of satviz
and the versions it ran with.  Cells that measure time run one at a time in this
process, after all others, so that nothing runs beside them.
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
from .machine import machine

ROOT = Path(__file__).parents[2]


class Settings(NamedTuple):
    """What the whole study is asked: fewer and smaller runs if `quick`, and the seed of all that is random."""

    quick: bool = False
    seed: int = 1

    def rng(self, *what: str | int) -> np.random.Generator:
        """Random numbers for one purpose, the same whenever the seed is."""
        return np.random.default_rng([self.seed, *(crc32(str(word).encode()) for word in what)])


class Cell(NamedTuple):
    """One piece of the study: `work(*arguments)`, both to be pickled; `timed` if it measures time."""

    name: str
    work: Callable[..., Any]
    arguments: tuple[Any, ...]
    timed: bool = False

    @property
    def key(self) -> str:
        """What decides the result, as a digest."""
        facts = [self.work.__module__, self.work.__qualname__, self.arguments, machine(), _code()]
        return sha256(json.dumps(facts).encode()).hexdigest()


@cache
def _code() -> str:
    """A digest of satviz's own modules: numbers from other code are not these numbers."""
    files = sorted(ROOT.rglob("*.py"))
    return sha256(b"".join(sha256(path.read_bytes()).digest() for path in files)).hexdigest()


class Failure(NamedTuple):
    """What a failed cell gives in place of a result: the error in words."""

    why: str


def results(
    cells: Sequence[Cell], folder: Path, executor: Executor | None, *, force: bool = False
) -> Iterator[tuple[Cell, Any]]:
    """Each cell with its result or Failure, those kept in `folder` first; what is finished is kept at once.

    A file whose key or checksum is not right counts as not there.  A failed cell leaves
    the others alone; an interrupt stops after the running cells.
    """
    todo = []
    for cell in cells:
        kept = _load(cell, folder)
        if kept is None:
            todo.append(cell)
        else:
            yield cell, kept
    for timed, pool in (False, executor), (True, None):
        mine = [cell for cell in todo if cell.timed is timed]

        def job(start: int, stop: int, mine: list[Cell] = mine) -> tuple[Callable[..., Any], tuple[Any, ...]]:
            return _attempt, (mine[start].work, mine[start].arguments)

        left = deque(mine)
        try:
            for _, _, result in in_chunks(job, len(mine), pool, None, 1):
                cell = left.popleft()
                if not isinstance(result, Failure):
                    _keep(cell, result, folder, force)
                yield cell, result
        except (ChunkFailed, BrokenExecutor) as error:  # a worker died, and its pool does no more
            for cell in left:
                yield cell, _failure(error.__cause__ or error)


def _attempt(work: Callable[..., Any], arguments: tuple[Any, ...]) -> Any:
    """The result as it comes back from disk, so that a resumed study ends as one that was not interrupted."""
    try:
        return json.loads(json.dumps(work(*arguments), allow_nan=False))
    except Exception as error:
        return _failure(error)


def _failure(error: BaseException) -> Failure:
    return Failure(f"{type(error).__name__}: {error}")


def _path(cell: Cell, folder: Path) -> Path:
    return folder / f"{cell.name}-{cell.key[:8]}.json"  # a quick run leaves those of a full one alone


def _load(cell: Cell, folder: Path) -> Any:
    try:
        data = json.loads(_path(cell, folder).read_text(encoding="utf-8"))
        good = data["key"] == cell.key and data["checksum"] == _checksum(data["result"])
        return data["result"] if good else None
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        return None


def _keep(cell: Cell, result: Any, folder: Path, force: bool) -> None:
    data = {"made_by": MADE_BY, "key": cell.key, "checksum": _checksum(result), "result": result}
    write(_path(cell, folder), json.dumps(data).encode(), force=force)


def _checksum(result: Any) -> str:
    return sha256(json.dumps(result, sort_keys=True).encode()).hexdigest()
