"""Environments of their own for tests of what users install: from PyPI and from npm."""

import os
import shutil
import subprocess
import sys

import pytest

CLEAN = {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "VIRTUAL_ENV")}
SECONDS = 900  # JupyterLab is fetched


def run(*command, cwd, **more):
    """Return the exit code of a command and its output."""
    done = subprocess.run(command, cwd=cwd, env={**CLEAN, **more}, capture_output=True, text=True, timeout=SECONDS)
    return done.returncode, done.stdout + done.stderr


def uv(*arguments, cwd):
    """Return the same for a command of uv, which is ten times as fast as pip where most packages are cached."""
    return run(sys.executable, "-m", "uv", *arguments, cwd=cwd)


def environment(folder, *packages):
    """Return the Python of a new virtual environment with these packages; skip the test if uv cannot fetch them."""
    python = folder / "env" / "bin" / "python"
    code, said = uv("venv", "-q", "--python", sys.executable, folder / "env", cwd=folder)
    assert code == 0, said
    code, said = uv("pip", "install", "-q", "--python", python, *packages, cwd=folder)
    if code and any(
        words in said for words in ("not found in the package registry", "Failed to fetch", "urlopen error")
    ):
        last = [line for line in said.splitlines() if line.strip()][-1]
        pytest.skip(f"uv cannot install {', '.join(map(str, packages))}: {last[:200]}")
    assert code == 0, said
    return python


def npm_package(folder, name):
    """Return the folder of the programs of an npm package; skip the test if npm cannot fetch it."""
    npm = shutil.which("npm")
    if npm is None:
        pytest.skip("npm is not installed")
    code, said = run(npm, "install", "--silent", "--no-audit", "--prefix", folder / "node", name, cwd=folder)
    if code:
        pytest.skip(f"npm cannot install {name}: {said[-200:]}")
    return folder / "node" / "node_modules" / ".bin"
