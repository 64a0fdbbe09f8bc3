"""What figures were measured on: the machine and the versions of all that took part."""

import platform
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from importlib.util import find_spec

PEERS = ("numba", "shapely", "pymunk")


def installed(name: str) -> bool:
    """Can that package be imported here?"""
    return find_spec(name) is not None


def missing() -> list[str]:
    """The peers that are not installed."""
    return [name for name in PEERS if not installed(name)]


@cache
def machine() -> dict[str, str]:
    """The machine's kind and the versions, by name."""
    found = {"python": platform.python_version(), "machine": platform.machine(), "system": platform.system()}
    for name in ("satviz", "numpy", *PEERS):
        try:
            found[name] = version(name)
        except PackageNotFoundError:
            continue
    return found
