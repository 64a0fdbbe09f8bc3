"""What figures were measured on: the machine and the versions of all that took part."""

import os
import platform
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from importlib.util import find_spec
from pathlib import Path

from ... import __version__

PEERS = ("numba", "shapely", "pymunk")


def installed(name: str) -> bool:
    """Can that package be imported here?"""
    return find_spec(name) is not None


def missing() -> list[str]:
    """The peers that are not installed."""
    return [name for name in PEERS if not installed(name)]


def _processor() -> str:
    """Its model, where the system tells."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8", errors="replace").splitlines()
    except OSError:
        lines = []
    models = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return models[0] if models else platform.processor()


@cache
def machine() -> dict[str, str]:
    """The machine's kind and the versions, by name."""
    found = {"python": platform.python_version(), "machine": platform.machine(), "system": platform.system()}
    found |= {"processor": _processor(), "cores": str(os.cpu_count())}
    found["satviz"] = __version__
    for name in ("numpy", *PEERS):
        try:
            found[name] = version(name)
        except PackageNotFoundError:
            continue
    return found
