"""Python for the page: Pyodide's core out of its npm package, satviz as a zip, and the memory of a first start."""

import gzip
import io
import json
import os
import subprocess
import tarfile
import zlib
from base64 import b64encode
from hashlib import sha512
from importlib.resources import files
from pathlib import Path
from shutil import which
from tempfile import TemporaryDirectory
from zipfile import ZipFile, ZipInfo

from .. import safe_write

VERSION = "314.0.7"
INTEGRITY = "sha512-0YvXxEhfEdpLfb/XkM2BFAeMROq0iMUX2bzzH9pOttyMcWkwq+HbE5uyuGD82LN7y2q+SNvi/6V5JEsOlD2R1A=="
CORE = "pyodide.mjs", "pyodide.asm.mjs", "pyodide.asm.wasm", "python_stdlib.zip", "pyodide-lock.json"
# what the pages ask for: the engine, the pictures and what answers; neither NumPy nor matplotlib is in the page
PARTS = (
    *("__init__.py", "optional_imports.py", "engine", "scenes", "pictures"),
    *(
        "widgets/__init__.py",
        "widgets/player_model.py",
        "widgets/explorer_model.py",
        "widgets/goals.py",
        "site/__init__.py",
        "site/live.py",
    ),
)
# run where the memory is kept: whatever a page may import is imported, and each kind of answer was given once
WARM = """
import gc, importlib, json, pkgutil, satviz
for module in pkgutil.walk_packages(satviz.__path__, "satviz."):
    importlib.import_module(module.name)
from satviz.site import live
for link in "triangles", "triangles&free=30", "triangles&against=1&way-out=1", "far-centers", "circles":
    state = json.loads(live.answer("warm", json.dumps({"kind": "open", "hash": link})))["first"]
    live.answer("warm", json.dumps({"kind": "pose", "n": 1, "a": state["a"], "b": state["b"]}))
live._hands.clear()
gc.collect()
"""
SECONDS = 180  # that npm and Node may take each


class Missing(Exception):
    """No Python for the page: one line that says why."""


def runtime(pyodide: Path | None) -> tuple[dict[str, bytes], str]:
    """The files of the page's Python by name, and a line on what is missing of them ("" if nothing is).

    `pyodide`: a folder that holds its core, instead of the npm package.  Missing where there is none.
    """
    core = _core_of(pyodide) if pyodide else _core_from_npm()
    satviz = zipped()
    made = {
        "pyodide.js": _without_map(core["pyodide.mjs"]),
        "pyodide.asm.js": core["pyodide.asm.mjs"],
        "wasm.bin": packed(core["pyodide.asm.wasm"]),
        "library.bin": packed(core["python_stdlib.zip"]),
        "satviz.bin": packed(satviz),
    }
    memory, why = _memory(core, satviz)
    if memory:
        made["memory.bin"] = packed(memory)
    sizes = {name: len(data) for name, data in made.items() if name.endswith(".bin")}
    lock = {"info": json.loads(core["pyodide-lock.json"])["info"], "packages": {}}
    about = {"made_by": safe_write.MADE_BY, "pyodide": VERSION, "sizes": sizes, "lock": lock}
    made["about.json"] = json.dumps(about).encode()
    return made, why


def packed(data: bytes) -> bytes:
    """The data as gzip, the same each time, its maker in the field for a comment."""
    deflate = zlib.compressobj(9, zlib.DEFLATED, -zlib.MAX_WBITS)
    head = b"\x1f\x8b\x08\x10\0\0\0\0\x02\xff" + safe_write.MADE_BY.encode() + b"\0"
    tail = zlib.crc32(data).to_bytes(4, "little") + (len(data) & 0xFFFFFFFF).to_bytes(4, "little")
    found = head + deflate.compress(data) + deflate.flush() + tail
    assert gzip.decompress(found) == data
    return found


def zipped() -> bytes:
    """What the page needs of the installed satviz, as a zip that is the same each time."""
    out = io.BytesIO()
    root = Path(__file__).parent.parent
    found = [path for part in PARTS for path in ((root / part).rglob("*") if (root / part).is_dir() else [root / part])]
    with ZipFile(out, "w") as archive:
        for path in sorted(found):
            if path.suffix in (".py", ".txt"):
                archive.writestr(ZipInfo(f"satviz/{path.relative_to(root).as_posix()}"), path.read_bytes())
    return out.getvalue()


def cache() -> Path:
    """Where what was fetched is kept."""
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "satviz"


def _core_of(folder: Path) -> dict[str, bytes]:
    try:
        found = json.loads((folder / "package.json").read_text(encoding="utf-8"))["version"]
        core = {name: (folder / name).read_bytes() for name in CORE}
    except (OSError, ValueError, KeyError) as error:
        raise Missing(f"{folder} holds no Pyodide ({error})") from None
    if found != VERSION:
        raise Missing(f"{folder} holds Pyodide {found}: this satviz goes with {VERSION}")
    return core


def _core_from_npm() -> dict[str, bytes]:
    """Out of the package, which must be the one that satviz was made with, byte by byte."""
    kept = cache() / f"pyodide-{VERSION}.tgz"
    if not (kept.is_file() and _is_the_one(kept.read_bytes())):
        data = _fetched()
        if not _is_the_one(data):
            raise Missing(f"npm's pyodide {VERSION} is not the one that satviz was made with (its hash differs)")
        safe_write.write(kept, data, force=True)
    with tarfile.open(kept) as archive:
        return {name: found.read() for name in CORE if (found := archive.extractfile(f"package/{name}"))}


def _fetched() -> bytes:
    npm = which("npm")
    if npm is None:
        raise Missing("npm is not installed")
    with TemporaryDirectory() as folder:
        command = [npm, "pack", f"pyodide@{VERSION}", "--silent", "--pack-destination", folder]
        try:
            subprocess.run(command, check=True, capture_output=True, timeout=SECONDS, cwd=folder)
            return (Path(folder) / f"pyodide-{VERSION}.tgz").read_bytes()
        except (OSError, subprocess.SubprocessError):
            raise Missing("npm cannot fetch Pyodide (offline?)") from None


def _is_the_one(data: bytes) -> bool:
    return "sha512-" + b64encode(sha512(data).digest()).decode() == INTEGRITY


def _memory(core: dict[str, bytes], satviz: bytes) -> tuple[bytes, str]:
    """The memory of a Python that has satviz loaded, or nothing and why."""
    node = which("node")
    if node is None:
        return b"", "no memory of a first start is kept, so pages start slower: node is not installed"
    with TemporaryDirectory() as folder:
        for name, data in {**core, "satviz.zip": satviz}.items():
            safe_write.write(Path(folder) / name, data)
        script = files(__package__) / "browser" / "memory.mjs"
        command = [node, str(script), folder]
        try:
            subprocess.run(command, input=WARM.encode(), check=True, capture_output=True, timeout=SECONDS)
            made = (Path(folder) / "memory").read_bytes()
        except (OSError, subprocess.SubprocessError) as error:
            said = (getattr(error, "stderr", None) or b"").decode(errors="replace").strip().splitlines()
            why = next((line for line in said if "Error" in line), str(error))
            return b"", f"no memory of a first start is kept, so pages start slower: {why[:200]}"
    return made, ""


def _without_map(script: bytes) -> bytes:
    """Without the line that sends a debugger to a file that is not there."""
    return b"\n".join(line for line in script.splitlines() if not line.startswith(b"//# sourceMappingURL"))
