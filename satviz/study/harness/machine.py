"""The machine that the figures were measured on, and the versions of the packages that took part."""

import os
import platform
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from importlib.util import find_spec
from pathlib import Path

from ... import __version__

PEER_PACKAGES = ("numba", "shapely", "pymunk", "scipy", "pyb2d3")


def is_installed(name: str) -> bool:
    """Return whether the package can be imported here."""
    return find_spec(name) is not None


def missing_peers() -> list[str]:
    """Return the names of the peer packages that are not installed."""
    return [name for name in PEER_PACKAGES if not is_installed(name)]


def _processor() -> str:
    """Return the processor's model name; without /proc/cpuinfo the name that Python knows, which may be empty."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8", errors="replace").splitlines()
    except OSError:
        lines = []
    models = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return models[0] if models else platform.processor()


@cache
def machine_facts() -> dict[str, str]:
    """Return by name: the machine, system, processor, number of cores, and versions of Python and packages."""
    found = {"python": platform.python_version(), "machine": platform.machine(), "system": platform.system()}
    found |= {"processor": _processor(), "cores": str(os.cpu_count())}
    found["satviz"] = __version__
    for name in ("numpy", *PEER_PACKAGES):
        try:
            found[name] = version(name)
        except PackageNotFoundError:
            continue
    return found
