"""A real browser and a real JupyterLab for the tests: what is needed, and a plain reason where it is missing."""

import json
import os
import secrets
import shutil
import signal
import socket
import subprocess
import sys
import tarfile
import tempfile
import threading
import time
import urllib.request
from contextlib import contextmanager
from pathlib import Path

import pytest

REQUIRED = os.environ.get("SATVIZ_BROWSER") == "required"
# The shell is Chromium without windows, and opens a page with a quarter of the work.
NAMES = "chromium-headless-shell", "chromium", "chromium-browser", "google-chrome"
CHROMIUM = next(filter(None, map(shutil.which, NAMES)), None)


def missing(what):
    """Skip with the reason, or fail where the browser tests are required."""
    if REQUIRED:
        pytest.fail(f"{what}, and SATVIZ_BROWSER=required")
    pytest.skip(what)


@contextmanager
def chromium():
    """Yield a headless browser; an error of satviz on any of its pages fails the test."""
    try:
        from playwright.sync_api import sync_playwright
    except ImportError:
        missing("playwright is not installed")
    if CHROMIUM is None:
        missing("no Chromium is installed")
    with sync_playwright() as play:
        browser = play.chromium.launch(executable_path=CHROMIUM, args=["--no-sandbox"])
        yield browser
        browser.close()


# The explorer over a model of a few lines instead of Jupyter's: `satviz.widgets.explorer_model` answers it.
STAND_IN = """
const data = await window.first();
const heard = new Set();
const on = (_, hears) => heard.add(hears);
const off = (_, hears) => heard.delete(hears);
window.unanswered = 0;
const send = async (content) => {
  window.unanswered += 1;
  const answer = await window.answer(content);
  if (answer) for (const hears of heard) hears(answer, []);
  window.unanswered -= 1;
};
const model = { get: (name) => data[name], on, off, send };
const el = document.querySelector("main");
START;
"""


@contextmanager
def explored(browser, exploring, errors, *, keys=False, **more):
    """Yield a page with the explorer alone; with `keys` arrow keys need no focus; `more`: options of the context."""
    from satviz.render.formats import FORMATS
    from satviz.render.script import javascript, stylesheet
    from satviz.widgets.goals import GOAL_NAMES

    context = browser.new_context(**more)
    page = context.new_page()
    page.on("pageerror", lambda error: errors.append(str(error)))
    first = {
        "first": exploring.state(),
        "presets": ["triangles", "circles"],
        "failing": ["aabb-turned"],
        "challenges": GOAL_NAMES,
        "formats": list(FORMATS),
    }
    page.expose_function("first", lambda: first)
    page.expose_function("answer", exploring.answer)
    script = javascript("explore", "arrows").replace("export default", "const made =")
    start = STAND_IN.replace("START", "arrowKeys(new Explorer(model, el))" if keys else "render({ model, el })")
    page.set_content(
        '<!doctype html><html lang="en"><head><title>An explorer</title>'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f"<style>{stylesheet()}</style></head><body><h1>An explorer</h1><main></main>"
        f'<script type="module">{script}{start}</script></body></html>'
    )
    page.locator("[data-handle]").first.wait_for(state="attached")
    settled(page)
    yield page
    context.close()


# In the first frame sizes are observed, in the second one what follows from them is laid out.
SETTLED = """async () => {
  for (let i = 0; i < 2; i += 1) await new Promise(requestAnimationFrame);
  return !window.unanswered;
}"""


def settled(page):
    """Wait until the page is laid out, and Python has answered each message of an explorer alone."""
    page.wait_for_function(SETTLED)


def site_with_python(folder):
    """Write the site with Python in its pages into the folder and return the folder."""
    from satviz.safe_write import write
    from satviz.site.build import site

    found, lacks = site()
    if lacks:
        missing(lacks[0])
    for path, data in found:
        write(folder / path, data)
    return folder


SITE_URL = "https://example.org/a/satviz/"


def still_site(folder):
    """Write the site without Python, which knows its address, into the folder and return the folder."""
    from satviz.safe_write import write
    from satviz.site.build import site

    for path, data in site(live=False, url=SITE_URL)[0]:
        write(folder / path, data)
    return folder


@contextmanager
def served(folder):
    """Yield the address of a server of the site in this folder."""
    from satviz.site.serving import server

    with server(folder) as serving:
        thread = threading.Thread(target=serving.serve_forever, daemon=True)
        thread.start()
        yield f"http://127.0.0.1:{serving.server_address[1]}/"
        serving.shutdown()
        thread.join()


def axe():
    """Return the source of axe-core, which finds accessibility faults; npm packs it."""
    npm = shutil.which("npm")
    if npm is None:
        missing("npm, which has axe-core, is not installed")
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run([npm, "pack", "axe-core@4"], cwd=folder, capture_output=True, text=True, timeout=120)
        packed = list(Path(folder).glob("axe-core-*.tgz"))
        if not packed:
            missing(f"npm gives no axe-core: {run.stderr[-200:]}")
        with tarfile.open(packed[0]) as found:
            return found.extractfile("package/axe.min.js").read().decode()


def accessibility_faults(axe_core, page):
    """Return the serious and critical faults that axe-core finds on a page."""
    page.evaluate(f"{axe_core};0")
    found = page.evaluate("async () => (await axe.run(document, { resultTypes: ['violations'] })).violations")
    return [(v["id"], v["nodes"][0]["html"]) for v in found if v["impact"] in ("serious", "critical")]


class Lab:
    """A JupyterLab on a random port, with a folder of notebooks."""

    def __init__(self, folder, url, token):
        self.folder, self.url, self.token = folder, url, token

    def notebook(self, name, *sources):
        cells = [
            {"cell_type": "code", "id": f"c{i}", "metadata": {}, "execution_count": None, "outputs": [], "source": s}
            for i, s in enumerate(sources)
        ]
        kernel = {"name": "python3", "display_name": "Python 3", "language": "python"}
        data = {"nbformat": 4, "nbformat_minor": 5, "metadata": {"kernelspec": kernel}, "cells": cells}
        (self.folder / name).write_text(json.dumps(data), encoding="utf-8")

    def open(self, page, name, app="lab"):
        """Open the notebook in JupyterLab or Notebook 7 ("notebooks"), with its kernel ready: earlier runs get lost."""
        where = "lab/tree" if app == "lab" else app
        page.goto(f"{self.url}/{where}/{name}?token={self.token}")
        page.locator(".jp-Notebook .jp-CodeCell").first.wait_for(timeout=60_000)
        page.wait_for_function("() => window.jupyterapp?.shell.currentWidget?.sessionContext?.session?.kernel")
        page.evaluate("async () => { await jupyterapp.shell.currentWidget.sessionContext.ready; }")
        page.evaluate("async () => { await jupyterapp.shell.currentWidget.sessionContext.session.kernel.info; }")

    def run_all(self, page):
        page.evaluate("async () => { await jupyterapp.commands.execute('notebook:run-all-cells'); }")


@contextmanager
def jupyterlab(folder):
    """Start the server, wait until it answers, and stop it by its pid whatever happens."""
    try:
        import anywidget  # noqa: F401
        import jupyterlab  # noqa: F401
    except ImportError:
        missing("JupyterLab or anywidget is not installed")
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    token = secrets.token_hex(16)
    settings = {"IPYTHONDIR": str(folder / ".ipython"), "JUPYTER_CONFIG_DIR": str(folder / ".jupyter")}
    settings |= {"JUPYTERLAB_SETTINGS_DIR": str(folder / ".lab"), "JUPYTER_RUNTIME_DIR": str(folder / ".run")}
    options = [
        "--no-browser",
        "--expose-app-in-browser",
        "--JupyterNotebookApp.expose_app_in_browser=True",
        "--allow-root",
        "--ip=127.0.0.1",
        f"--port={port}",
        f"--IdentityProvider.token={token}",
    ]
    options += [
        f"--ServerApp.root_dir={folder}",
        "--LabApp.news_url=None",
        "--LabApp.check_for_updates_class=jupyterlab.NeverCheckForUpdate",
    ]
    with (folder / ".lab.log").open("wb") as log:
        command = [sys.executable, "-m", "jupyterlab", *options]
        server = subprocess.Popen(
            command, env={**os.environ, **settings}, stdout=log, stderr=log, start_new_session=True
        )
        try:
            url = f"http://127.0.0.1:{port}"
            for _ in range(240):
                try:
                    urllib.request.urlopen(f"{url}/api?token={token}", timeout=2).close()
                    break
                except OSError:
                    if server.poll() is not None:
                        pytest.fail((folder / ".lab.log").read_text(errors="replace")[-2000:])
                    time.sleep(0.25)
            yield Lab(folder, url, token)
        finally:
            os.killpg(server.pid, signal.SIGTERM)
            try:
                server.wait(10)
            except subprocess.TimeoutExpired:
                os.killpg(server.pid, signal.SIGKILL)
