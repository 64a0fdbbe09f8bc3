"""Pin another Pyodide: write its version and the hash of its npm package into satviz/site/runtime.py.

    python tests/refresh_pyodide.py            the newest one
    python tests/refresh_pyodide.py 314.0.7    this one

npm must be installed.  Afterwards run `python -m pytest -m slow tests/test_browser_site.py`.
"""

import json
import re
import subprocess
import sys
from pathlib import Path

RUNTIME = Path(__file__).parent.parent / "satviz" / "site" / "runtime.py"
PINS = {"VERSION": re.compile(r"[0-9]+\.[0-9]+\.[0-9]+"), "INTEGRITY": re.compile(r"sha512-[A-Za-z0-9+/]{86}==")}


def pinned(source: str, version: str, integrity: str) -> str:
    """Return the module's text with this version and hash; ValueError for values of another form."""
    for (name, form), value in zip(PINS.items(), (version, integrity), strict=True):
        if not form.fullmatch(value):
            raise ValueError(f"npm says {value!r}, which is no {name}")
        source, count = re.subn(rf'^{name} = ".*"$', f'{name} = "{value}"', source, flags=re.MULTILINE)
        if count != 1:
            raise ValueError(f"{RUNTIME.name} has {count} lines of {name}: expected 1")
    return source


def main() -> None:
    what = f"pyodide@{sys.argv[1] if len(sys.argv) > 1 else 'latest'}"
    run = subprocess.run(
        ["npm", "view", what, "version", "dist.integrity", "--json"], check=True, capture_output=True, text=True
    )
    found = json.loads(run.stdout)
    text = pinned(RUNTIME.read_text(encoding="utf-8"), found["version"], found["dist.integrity"])
    RUNTIME.write_text(text, encoding="utf-8")
    print(f"{RUNTIME.name} pins Pyodide {found['version']}")


if __name__ == "__main__":
    main()
