"""The recipes of the guide on frames, each run for real: the page is built by its program and driven in a browser."""

import json
import re
import socket
import subprocess
import time
import urllib.request
from contextlib import contextmanager
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from textwrap import indent
from threading import Thread

import pytest
from browser import served
from environments import CLEAN, environment, npm_package, run

import satviz as sv

pytestmark = pytest.mark.slow

ROOT = Path(__file__).parent.parent
GUIDE = (ROOT / "satviz" / "guides" / "embedding.md").read_text(encoding="utf-8")
EXAMPLE = "https://example.org/satviz/"
LIVE = 60_000


@pytest.fixture(scope="module")
def site(built):
    with served(built) as url:
        yield url


def recipe(heading, language, site=EXAMPLE):
    """Return the first block of this language below the guide's heading, for the site at this address."""
    section = re.split(r"^## ", GUIDE.partition(f"## {heading}")[2], maxsplit=1, flags=re.MULTILINE)[0]
    block = re.search(rf"^(`{{3,4}}){language}\n(.*?)^\1$", section, re.MULTILINE | re.DOTALL)
    return block[2].replace(EXAMPLE, site)


@contextmanager
def folder_served(folder):
    """Yield the address of a plain server with another origin than the site."""
    handler = partial(SimpleHTTPRequestHandler, directory=str(folder))
    with ThreadingHTTPServer(("127.0.0.1", 0), handler) as serving:
        thread = Thread(target=serving.serve_forever, daemon=True)
        thread.start()
        yield f"http://127.0.0.1:{serving.server_address[1]}/"
        serving.shutdown()
        thread.join()


def is_dragged(browser, folder, page_name, *, grows):
    """Open the page, and move B in its frame; `grows`: the page gives the frame the height of its content."""
    with folder_served(folder) as url:
        page = browser.new_page(viewport={"width": 1000, "height": 900})
        page.goto(url + page_name)
        frame = page.frame_locator("iframe")
        frame.locator(".live.ready").wait_for(timeout=LIVE)
        sentence = frame.locator(".sv-sentence").first
        before = sentence.inner_text()
        assert before == sv.scene("triangles").record().sentence
        frame.locator('[data-handle="B-move"]').press("ArrowLeft")
        inner = next(each for each in page.frames if "scene.html?embed" in each.url)
        changed = "before => document.querySelector('.sv-sentence').textContent !== before"
        inner.wait_for_function(changed, arg=before)
        if grows:
            inner.wait_for_function("() => document.documentElement.scrollHeight === innerHeight")
        assert inner.evaluate("document.documentElement.scrollWidth <= innerWidth")
        page.close()


def saved(folder, site):
    """Write the file of the guide that a document includes, and return its path."""
    (folder / "scene-to-embed.html").write_text(sv.embed("triangles", site=site), encoding="utf-8")


def test_an_embedded_scene_can_be_dragged_in_a_plain_page(browser, site, tmp_path):
    saved(tmp_path, site)
    text = (tmp_path / "scene-to-embed.html").read_text()
    (tmp_path / "page.html").write_text(f"<!doctype html><h1>My page</h1>{text}<p>More.</p>", encoding="utf-8")
    is_dragged(browser, tmp_path, "page.html", grows=True)


def test_a_frame_in_a_moodle_label_can_be_dragged(browser, site, tmp_path):
    """Moodle shows a label inside its own elements, and keeps only the frame."""
    frame = recipe("A plain page, or a Moodle label", "html", site)
    label = f'<div class="activity-item"><div class="no-overflow"><p>Drag.</p>{frame}</div></div>'
    (tmp_path / "label.html").write_text(f"<!doctype html><body>{label}</body>", encoding="utf-8")
    is_dragged(browser, tmp_path, "label.html", grows=False)


@pytest.fixture(scope="module")
def sphinx(tmp_path_factory):
    return environment(tmp_path_factory.mktemp("sphinx"), "sphinx", "myst-parser")


@pytest.mark.parametrize("kind", ["rst", "markdown"])
def test_a_frame_in_a_sphinx_page_can_be_dragged(browser, site, sphinx, tmp_path, kind):
    source = tmp_path / "source"
    source.mkdir()
    saved(source, site)
    extension = "extensions = ['myst_parser']" if kind == "markdown" else ""
    (source / "conf.py").write_text(f"project = 'A book'\n{extension}\n", encoding="utf-8")
    if kind == "rst":
        (source / "index.rst").write_text(f"A page\n======\n\n{recipe('Sphinx', 'rst')}", encoding="utf-8")
    else:
        (source / "index.md").write_text(f"# A page\n\n{recipe('Sphinx', 'markdown')}", encoding="utf-8")
    code, said = run(sphinx, "-m", "sphinx", "-W", "-q", source, tmp_path / "out", cwd=tmp_path)
    assert code == 0, said
    is_dragged(browser, tmp_path / "out", "index.html", grows=True)


@pytest.mark.parametrize("program", ["mystmd", "jupyter-book"])
def test_a_frame_in_a_myst_or_jupyter_book_2_page_can_be_dragged(browser, site, tmp_path, program):
    """What they make of the page; the themes are not on npm, so the frame of the made page stands in a page of ours."""
    if program == "mystmd":
        command = [npm_package(tmp_path, "mystmd") / "myst"]
    else:
        command = [environment(tmp_path, "jupyter-book>=2").parent / "jupyter-book"]
    book = tmp_path / "book"
    book.mkdir()
    (book / "myst.yml").write_text("version: 1\nproject:\n  title: A book\nsite:\n  title: A book\n", encoding="utf-8")
    text = recipe("MyST and Jupyter Book 2", "markdown", site)
    (book / "index.md").write_text(f"# A page\n\n{text}", encoding="utf-8")
    _, said = run(*command, "build", "--site", cwd=book)
    made = book / "_build" / "site" / "content" / "index.json"
    assert made.is_file(), said
    found = [node for node in nodes(json.loads(made.read_text())["mdast"]) if node.get("type") == "iframe"]
    assert len(found) == 1 and found[0]["width"] == "100%"
    frame = f'<iframe src="{found[0]["src"]}" style="width: {found[0]["width"]}; height: 560px"></iframe>'
    (book / "page.html").write_text(f"<!doctype html><body>{frame}</body>", encoding="utf-8")
    is_dragged(browser, book, "page.html", grows=False)


def nodes(node):
    """Yield a node of a document and all nodes below it."""
    yield node
    for child in node.get("children", []):
        yield from nodes(child)


def test_a_frame_in_a_page_made_by_pandoc_as_in_quarto_can_be_dragged(browser, site, tmp_path):
    python = environment(tmp_path, "pypandoc_binary")
    (tmp_path / "page.md").write_text(f"# A page\n\n{recipe('Quarto', 'markdown', site)}", encoding="utf-8")
    convert = "import pypandoc; pypandoc.convert_file('page.md', 'html', outputfile='page.html', extra_args=['-s'])"
    code, said = run(python, "-c", convert, cwd=tmp_path)
    assert code == 0, said
    is_dragged(browser, tmp_path, "page.html", grows=False)


def test_a_frame_in_a_quarto_page_can_be_dragged(browser, site, tmp_path):
    """Its package on PyPI fetches the program from GitHub when it is installed."""
    python = environment(tmp_path, "quarto-cli")
    quarto = python.parent / "quarto"
    code, said = run(quarto, "--version", cwd=tmp_path)
    if code:
        pytest.skip(f"quarto-cli is installed, and its program is not there: {said[-200:]}")
    (tmp_path / "page.qmd").write_text(f"# A page\n\n{recipe('Quarto', 'markdown', site)}", encoding="utf-8")
    code, said = run(quarto, "render", "page.qmd", "--to", "html", cwd=tmp_path)
    assert code == 0, said
    is_dragged(browser, tmp_path, "page.html", grows=False)


def test_an_explorer_in_a_marimo_notebook_can_be_dragged(browser, tmp_path):
    python = environment(tmp_path, "marimo", "anywidget", "ipywidgets", ROOT)
    imports, widget = recipe("marimo", "py").rstrip().split("\n\n")
    cell = indent(f"{imports}\n{widget}\nreturn\n", "    ")
    (tmp_path / "page.py").write_text(
        f"import marimo\napp = marimo.App()\n\n@app.cell\ndef _():\n{cell}", encoding="utf-8"
    )
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    command = [python, "-m", "marimo", "run", "page.py", "--headless", "--port", str(port), "--host", "127.0.0.1"]
    with subprocess.Popen(
        command, cwd=tmp_path, env=CLEAN, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    ) as made:
        try:
            answers(f"http://127.0.0.1:{port}/health", made)
            page = browser.new_page()
            page.goto(f"http://127.0.0.1:{port}/")
            page.locator('[data-handle="B-move"]').wait_for(timeout=LIVE, state="attached")
            sentence = page.locator(".sv-sentence").first
            before = sentence.inner_text()
            page.locator('[data-handle="B-move"]').press("ArrowLeft")
            for _ in range(100):
                if sentence.inner_text() != before:
                    break
                page.wait_for_timeout(100)
            assert "apart" in before and sentence.inner_text() != before
            page.close()
        finally:
            made.terminate()


def answers(url, process):
    """Wait until the server answers."""
    for _ in range(240):
        try:
            urllib.request.urlopen(url, timeout=2).close()
            return
        except OSError:
            assert process.poll() is None
            time.sleep(0.25)
    pytest.fail(f"{url} does not answer")
