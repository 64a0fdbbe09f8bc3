"""Work cut into chunks and handed to any concurrent.futures.Executor; no scheduler of our own."""

from collections import deque
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future
from operator import index
from typing import Any

from ..engine.polygon_validation import short_repr

CHUNK_PAIRS = 1 << 20  # pairs: large enough to hide what a hand-over costs, small enough to hold a few at once
MAX_WAITING_CHUNKS = 8  # chunks handed over and not yet fetched: what bounds the memory

Call = tuple[Callable[..., Any], tuple[Any, ...]]  # a function and its arguments
Job = Callable[[int, int], Call]
Waiting = deque[tuple[int, int, Future[Any]]]


class ChunkFailed(RuntimeError):
    """A chunk of the work failed; `start` and `stop` are its range, `cause` is chained."""

    def __init__(self, start: int, stop: int, cause: BaseException) -> None:
        super().__init__(f"items {start} to {stop - 1} failed: {type(cause).__name__}: {cause}")
        self.start, self.stop, self.cause = start, stop, cause

    def __reduce__(self) -> tuple[type, tuple[object, ...]]:
        return type(self), (self.start, self.stop, self.cause)


def in_chunks(
    job: Job, n: int, executor: Executor | None, progress: Callable[[int, int], None] | None, size: int
) -> Iterator[tuple[int, int, Any]]:
    """Yield (start, stop, result) for each chunk of `size` of the items 0 to n, in order.

    `job(start, stop)` returns the function to call for a chunk and its arguments; `executor` None calls it in this
    thread.  At most MAX_WAITING_CHUNKS chunks are under way, so memory does not grow with n.  An interrupt or a failed
    chunk (ChunkFailed) cancels those not yet started.  `progress(done, n)` is called after each.
    """
    ranges = ((start, min(start + size, n)) for start in range(0, n, size))
    waiting: Waiting = deque()
    try:
        if executor is None:
            for start, stop in ranges:
                yield start, stop, _run_chunk(start, stop, job)
                _report_progress(progress, stop, n)
            return
        for start, stop in ranges:
            function, arguments = job(start, stop)
            try:
                future = executor.submit(function, *arguments)
            except Exception as error:  # a pool whose workers have died takes nothing any more
                raise ChunkFailed(start, stop, error) from error
            waiting.append((start, stop, future))
            if len(waiting) >= MAX_WAITING_CHUNKS:
                yield _pop_result(waiting, progress, n)
        while waiting:
            yield _pop_result(waiting, progress, n)
    finally:
        for _, _, future in waiting:
            future.cancel()


def check_executor(executor: object) -> None:
    """Raise TypeError for anything but a concurrent.futures.Executor or None."""
    if executor is not None and not isinstance(executor, Executor):
        raise TypeError(
            f"executor is {short_repr(executor)}: pass a concurrent.futures.Executor, or None for this thread"
        )


def check_progress(progress: object) -> None:
    """Raise TypeError for anything but a function or None."""
    if progress is not None and not callable(progress):
        raise TypeError(f"progress is {short_repr(progress)}: pass a function of (done, total), or None")


def check_size(name: str, size: object) -> int:
    """Return the size as an int; TypeError unless it is a whole number, ValueError if it is less than 1."""
    try:
        number = index(size)  # type: ignore[arg-type]
    except TypeError:
        number = None
    if number is None or isinstance(size, bool):
        raise TypeError(f"{name} is {short_repr(size)}: pass a whole number of at least 1")
    if number < 1:
        raise ValueError(f"{name} is {short_repr(number)}: it must be at least 1")
    return number


def _run_chunk(start: int, stop: int, job: Job) -> Any:
    """Return the result of one chunk, run in this thread; a failure becomes ChunkFailed, which names the chunk."""
    function, arguments = job(start, stop)
    try:
        return function(*arguments)
    except Exception as error:
        raise ChunkFailed(start, stop, error) from error


def _pop_result(waiting: Waiting, progress: Callable[[int, int], None] | None, n: int) -> tuple[int, int, Any]:
    """Take the oldest chunk from `waiting`, wait for it, report progress of n, and return (start, stop, result)."""
    start, stop, future = waiting.popleft()
    try:
        result = future.result()
    except Exception as error:
        raise ChunkFailed(start, stop, error) from error
    _report_progress(progress, stop, n)
    return start, stop, result


def _report_progress(progress: Callable[[int, int], None] | None, done: int, total: int) -> None:
    """Call `progress(done, total)` unless `progress` is None."""
    if progress is not None:
        progress(done, total)
