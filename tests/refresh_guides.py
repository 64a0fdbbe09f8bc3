"""Run the code of the README and of the guides, and write what it prints below it.

    python tests/refresh_guides.py

A block of Python that is followed by a block of text prints this text.  The blocks of one document share their names.
"""

import io
import re
from contextlib import chdir, redirect_stdout
from pathlib import Path
from tempfile import TemporaryDirectory

ROOT = Path(__file__).parent.parent
GUIDES = ROOT / "satviz" / "guides"
DOCUMENTS = [ROOT / "README.md", *sorted(GUIDES.glob("*.md"))]
SHOWN = re.compile(r"^```python\n(?P<code>.*?)^```\n(\n```text\n(?P<output>.*?)^```\n)?", re.MULTILINE | re.DOTALL)


def documents() -> dict[str, str]:
    """Return the text of the README and of each guide by its path in the repository."""
    return {path.relative_to(ROOT).as_posix(): path.read_text(encoding="utf-8") for path in DOCUMENTS}


def refreshed(text: str, name: str) -> str:
    """Return a document's text with the outputs that its code prints now; its files go into the current folder."""
    names: dict = {}

    def run(block: re.Match) -> str:
        out = io.StringIO()
        with redirect_stdout(out):
            exec(compile(block["code"], name, "exec"), names)
        output = f"\n```text\n{out.getvalue()}```\n" if out.getvalue() else ""
        return f"```python\n{block['code']}```\n{output}"

    return SHOWN.sub(run, text)


def main() -> None:
    for name, text in documents().items():
        with TemporaryDirectory() as folder, chdir(folder):
            text = refreshed(text, name)
        (ROOT / name).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
