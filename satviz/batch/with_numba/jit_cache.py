"""Decorators that compile kernels with numba: the GIL released, cached on disk, rounding as Python does."""

from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar, cast
from uuid import uuid4

from numba import njit

Kernel = TypeVar("Kernel", bound=Callable[..., object])

PACKAGE = Path(__file__).parents[2]
# the files whose functions and constants are compiled into some kernel
SOURCES = [
    *sorted((PACKAGE / "batch").rglob("*.py")),
    *(PACKAGE / "engine" / f"{name}.py" for name in ("predicates", "relate")),
]


def _file_stamp(path: Path) -> tuple[int, int]:
    """Return (modification time in ns, size in bytes) of a file, which change when it is edited."""
    return path.stat().st_mtime_ns, path.stat().st_size


STAMP = tuple(map(_file_stamp, SOURCES))


def inlined(kernel: Kernel) -> Kernel:
    """Decorate a function that numba copies into the kernels that call it; a call would count references to arrays."""
    return cast(Kernel, njit(inline="always", error_model="numpy")(kernel))


def compiled(kernel: Kernel) -> Kernel:
    """Decorate a function: numba compiles it at its first call and keeps the code in a file until a source changes."""
    made: Any = njit(nogil=True, cache=True, error_model="numpy")(kernel)
    if made is kernel:  # NUMBA_DISABLE_JIT: to step through it, or to sow faults
        return kernel
    kept = made._cache._cache_file  # noqa: SLF001
    # numba would keep what it compiled until the kernel's own file changes; it holds calls and constants of others too
    kept._source_stamp = (*STAMP, _file_stamp(Path(kernel.__code__.co_filename)))  # noqa: SLF001
    # it counts its files and writes the index first, which then could name what was left by older code, or what another
    # process that compiles at the same moment puts there for arrays of another kind
    kept._data_name_pattern = kept._data_name_pattern.replace(".nbc", f"-{uuid4().hex}.nbc")  # noqa: SLF001
    return cast(Kernel, made)
