"""Python for the page: Pyodide's core from its npm package, satviz as a zip, and the memory of a first start."""

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
# the parts of satviz that the pages import; neither NumPy nor matplotlib is in the page
PACKED_PATHS = (
    *("__init__.py", "optional_imports.py", "engine", "scenes", "pictures", "checking", "widgets"),
    *("advice/__init__.py", "advice/relative_margin.py", "site/__init__.py", "site/live.py"),
)
# of these parts: what starts other programs, and what needs a notebook
LEFT_OUT = {
    "checking/programs.py",
    *(f"widgets/{name}.py" for name in ("base", "explorer", "player", "plain_controls")),
}
# run before the memory is stored: it imports every module and gives each kind of answer once
WARM_UP_CODE = """
import gc, importlib, json, pkgutil, satviz
for module in pkgutil.walk_packages(satviz.__path__, "satviz."):
    importlib.import_module(module.name)
from satviz.site import live
for link in "triangles", "triangles&free=30", "triangles&difference=1&mtv=1", "far-centers", "circles":
    state = json.loads(live.answer("warm", json.dumps({"kind": "open", "hash": link})))["first"]
    live.answer("warm", json.dumps({"kind": "pose", "n": 1, "a": state["a"], "b": state["b"]}))
live.answer("warm", json.dumps({"kind": "paste", "text": "circle((0, 0), 1) [0,0, 4,4, 4,0, 0,4]"}))
live._models.clear()
asked = json.loads(live.answer("check", json.dumps({"kind": "check", "kinds": "convex", "touching": "hit"})))
while asked["kind"] == "ask":
    outcomes = [{"value": True} for _ in asked["pairs"]]
    asked = json.loads(live.answer("check", json.dumps({"kind": "outcomes", "outcomes": outcomes})))
gc.collect()
"""
TIMEOUT_SECONDS = 180  # the longest time that npm, or Node, may take


class PythonMissing(Exception):
    """Raised when Python for the page cannot be found or fetched; the message is one line that says why."""


def runtime_files(pyodide: Path | None) -> tuple[dict[str, bytes], str]:
    """Return the files of the page's Python by name, and a line that says what is missing ("" if nothing is).

    `pyodide` is a folder that holds Pyodide's core; None takes the core from npm.  Raise PythonMissing without a core.
    """
    core = _core_from_folder(pyodide) if pyodide else _core_from_npm()
    satviz = satviz_zip()
    made = {
        "pyodide.js": _without_source_map(core["pyodide.mjs"]),
        "pyodide.asm.js": core["pyodide.asm.mjs"],
        "wasm.bin": gzipped(core["pyodide.asm.wasm"]),
        "library.bin": gzipped(core["python_stdlib.zip"]),
        "satviz.bin": gzipped(satviz),
    }
    memory, why = _stored_memory(core, satviz)
    if memory:
        made["memory.bin"] = gzipped(memory)
    sizes = {name: len(data) for name, data in made.items() if name.endswith(".bin")}
    lock = {"info": json.loads(core["pyodide-lock.json"])["info"], "packages": {}}
    about = {"made_by": safe_write.MADE_BY, "pyodide": VERSION, "sizes": sizes, "lock": lock}
    made["about.json"] = json.dumps(about).encode()
    return made, why


def gzipped(data: bytes) -> bytes:
    """Return the data as gzip, the same bytes each time, with satviz named in the header's comment field."""
    deflate = zlib.compressobj(9, zlib.DEFLATED, -zlib.MAX_WBITS)
    head = b"\x1f\x8b\x08\x10\0\0\0\0\x02\xff" + safe_write.MADE_BY.encode() + b"\0"
    tail = zlib.crc32(data).to_bytes(4, "little") + (len(data) & 0xFFFFFFFF).to_bytes(4, "little")
    found = head + deflate.compress(data) + deflate.flush() + tail
    assert gzip.decompress(found) == data
    return found


def satviz_zip() -> bytes:
    """Return a zip of the parts of satviz that the page imports, the same bytes each time."""
    out = io.BytesIO()
    root = Path(__file__).parent.parent
    found = [
        path
        for part in PACKED_PATHS
        for path in ((root / part).rglob("*") if (root / part).is_dir() else [root / part])
    ]
    with ZipFile(out, "w") as archive:
        for path in sorted(found):
            name = path.relative_to(root).as_posix()
            if path.suffix in (".py", ".txt") and name not in LEFT_OUT:
                archive.writestr(ZipInfo(f"satviz/{name}"), path.read_bytes())
    return out.getvalue()


def cache_folder() -> Path:
    """Return the folder where the fetched Pyodide is kept."""
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "satviz"


def _core_from_folder(folder: Path) -> dict[str, bytes]:
    """Return the files of Pyodide's core in this folder; raise PythonMissing if it has none, or another version."""
    try:
        found = json.loads((folder / "package.json").read_text(encoding="utf-8"))["version"]
        core = {name: (folder / name).read_bytes() for name in CORE}
    except (OSError, ValueError, KeyError) as error:
        raise PythonMissing(
            f"{folder} holds no Pyodide ({error}): give the folder `package` that npm's pyodide {VERSION} unpacks to"
        ) from None
    if found != VERSION:
        raise PythonMissing(f"{folder} holds Pyodide {found}: this satviz needs {VERSION}")
    return core


def _core_from_npm() -> dict[str, bytes]:
    """Return Pyodide's core files from npm's package, fetched once and kept; raise PythonMissing on failure."""
    kept = cache_folder() / f"pyodide-{VERSION}.tgz"
    if not (kept.is_file() and _has_expected_hash(kept.read_bytes())):
        data = _fetch_from_npm()
        if not _has_expected_hash(data):
            raise PythonMissing(
                f"npm's pyodide {VERSION} does not have the expected hash, so it is not used: give a folder with a copy"
            )
        safe_write.write(kept, data, force=True)
    with tarfile.open(kept) as archive:
        return {name: found.read() for name in CORE if (found := archive.extractfile(f"package/{name}"))}


def _fetch_from_npm() -> bytes:
    """Return the bytes of Pyodide's npm package; raise PythonMissing if npm is missing or fails."""
    npm = which("npm")
    if npm is None:
        raise PythonMissing("npm is not installed: install it, or give a folder that holds Pyodide")
    with TemporaryDirectory() as folder:
        command = [npm, "pack", f"pyodide@{VERSION}", "--silent", "--pack-destination", folder]
        try:
            subprocess.run(command, check=True, capture_output=True, timeout=TIMEOUT_SECONDS, cwd=folder)
            return (Path(folder) / f"pyodide-{VERSION}.tgz").read_bytes()
        except (OSError, subprocess.SubprocessError):
            raise PythonMissing(
                "npm cannot fetch Pyodide: check the connection, or give a folder that holds it"
            ) from None


def _has_expected_hash(data: bytes) -> bool:
    """Return whether the data is the npm package that satviz was made with, by its SHA-512 hash."""
    return "sha512-" + b64encode(sha512(data).digest()).decode() == INTEGRITY


def _stored_memory(core: dict[str, bytes], satviz: bytes) -> tuple[bytes, str]:
    """Return (memory image of a Python that has loaded satviz, ""), or (b"", the reason why there is none)."""
    node = which("node")
    if node is None:
        return b"", "no memory of a first start is kept, so pages start slower: node is not installed"
    with TemporaryDirectory() as folder:
        for name, data in {**core, "satviz.zip": satviz}.items():
            safe_write.write(Path(folder) / name, data)
        script = files(__package__) / "browser" / "memory.mjs"
        command = [node, str(script), folder]
        try:
            subprocess.run(
                command, input=WARM_UP_CODE.encode(), check=True, capture_output=True, timeout=TIMEOUT_SECONDS
            )
            made = (Path(folder) / "memory").read_bytes()
        except (OSError, subprocess.SubprocessError) as error:
            said = (getattr(error, "stderr", None) or b"").decode(errors="replace").strip().splitlines()
            why = next((line for line in said if "Error" in line), str(error))
            return b"", f"no memory of a first start is kept, so pages start slower: {why[:200]}"
    return made, ""


def _without_source_map(script: bytes) -> bytes:
    """Return the script without the line that names a source map, because the site does not have that file."""
    return b"\n".join(line for line in script.splitlines() if not line.startswith(b"//# sourceMappingURL"))
