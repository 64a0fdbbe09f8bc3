"""The machine that the figures were measured on, and the versions of the packages that took part."""

import os
import platform
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from importlib.util import find_spec
from pathlib import Path

from ... import __version__

SIMD_WIDTHS = {"avx512f": "512 bits", "avx2": "256 bits", "sse2": "128 bits", "asimd": "128 bits"}
PEER_PACKAGES = ("numba", "shapely", "pymunk", "scipy", "pyb2d3")


def is_installed(name: str) -> bool:
    """Return whether the package can be imported here."""
    return find_spec(name) is not None


def missing_peers() -> list[str]:
    """Return the names of the peer packages that are not installed."""
    return [name for name in PEER_PACKAGES if not is_installed(name)]


def _processor() -> dict[str, str]:
    """Return the processor's model and the width of its SIMD registers, which decide how methods rank; or less.

    Without /proc/cpuinfo the model is the name that Python knows, and the width is left out.
    """
    try:
        text = Path("/proc/cpuinfo").read_text(encoding="utf-8", errors="replace")
    except OSError:
        text = ""
    pairs = (line.partition(":")[::2] for line in reversed(text.splitlines()))
    known = {name.strip(): value.strip() for name, value in pairs}  # the lines of the first core, which come last here
    model = known.get("model name") or platform.processor()
    if "cpu family" in known:  # a virtual machine may tell no more of the name than its maker
        model += f" (family {known['cpu family']}, model {known.get('model')})"
    flags = set((known.get("flags") or known.get("Features") or "").split())
    width = next((bits for flag, bits in SIMD_WIDTHS.items() if flag in flags), "")
    return {"processor": model} | ({"SIMD": width} if width else {})


@cache
def machine_facts() -> dict[str, str]:
    """Return by name: machine, system, processor, SIMD width, number of cores, versions of Python and packages."""
    found = {"python": platform.python_version(), "machine": platform.machine(), "system": platform.system()}
    found |= {**_processor(), "cores": str(os.cpu_count())}
    found["satviz"] = __version__
    for name in ("numpy", *PEER_PACKAGES):
        try:
            found[name] = version(name)
        except PackageNotFoundError:
            continue
    return found
