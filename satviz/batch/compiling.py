"""How kernels are compiled with numba: the GIL released, kept on disk, the same rounding as Python."""

from collections.abc import Callable
from typing import TypeVar, cast

from numba import njit

Kernel = TypeVar("Kernel", bound=Callable[..., object])


def compiled(kernel: Kernel) -> Kernel:
    """The kernel compiled at its first call; to type checkers the function that it was."""
    return cast(Kernel, njit(nogil=True, cache=True, error_model="numpy")(kernel))
