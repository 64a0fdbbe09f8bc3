"""The site without its Python: whole as HTML and SVG, nothing from elsewhere, links that open what they say."""

import ast
import gzip
import io
import json
import os
import re
import signal
import subprocess
import sys
import urllib.error
import urllib.request
import zlib
from base64 import b64decode, urlsafe_b64encode
from contextlib import suppress
from dataclasses import replace
from functools import partial
from html import unescape
from html.parser import HTMLParser
from itertools import product
from math import hypot
from typing import NamedTuple
from urllib.parse import urldefrag
from zipfile import ZipFile

import pytest
import refresh_pyodide
from speeds import one_in

import satviz as sv
from satviz.checking.mistakes import SYMPTOMS
from satviz.cli import main
from satviz.engine.geometry import InvalidScene, InvalidShape
from satviz.lessons import chapter_text as chapters
from satviz.lessons.glossary import TERMS, TermLinker
from satviz.pictures.layout import NARROW_SIZE_PT
from satviz.scenes import link as links
from satviz.scenes.article import SCENES
from satviz.scenes.failing import FAILURE_CASES, REFUSED
from satviz.scenes.named import ALL_SCENES
from satviz.scenes.shape_tools import translated
from satviz.site import chapters as page_chapters
from satviz.site import guides, live, runtime
from satviz.widgets import goals
from satviz.widgets.explorer_model import ExplorerModel

pytest.importorskip("markdown_it", reason="a site needs markdown-it-py: python -m pip install '.[site]'")

from satviz.lessons.themed import themed_svg
from satviz.site import build
from satviz.site.build import site


@pytest.fixture(scope="module")
def files():
    found, lacks = site(live=False)
    assert not lacks
    return dict(found)


@pytest.fixture(scope="module")
def pages(files):
    """Return the site's own pages by their path; those of the reference are pdoc's (test_reference.py)."""
    own = {path: data for path, data in files.items() if not path.startswith("reference/")}
    return {path: data.decode() for path, data in own.items() if path.endswith(".html")}


def test_every_scrolling_element_can_be_scrolled_with_the_keyboard(pages):
    """This holds also for numbers of a picture that are shown only until Python has started."""
    for path, page in [*pages.items(), ("page", sv.page("triangles")), ("failing", sv.page("raw-depth"))]:
        for tag in re.findall(r"<pre\b[^>]*>", page):
            assert 'tabindex="0"' in tag, f"{path}: {tag}"


def test_no_table_has_a_header_without_words(pages):
    for path, page in [*pages.items(), ("notebook", sv.scene("triangles").record()._repr_mimebundle_())]:
        assert not re.search(r"<th\b[^>]*></th>", str(page)), path


def without_code(page):
    """Return the page without the code that it shows."""
    return re.sub(r"<pre\b.*?</pre>", "", page, flags=re.DOTALL)


def test_every_link_of_the_site_leads_to_one_of_its_files(files, pages):
    for path, page in pages.items():
        page = without_code(page)
        for to in map(unescape, re.findall(r'(?:href|src)="([^"]+)"', page)):
            name = urldefrag(to).url.partition("?")[0]
            assert not name or name in files, f"{path} -> {to}"
            if to.startswith("scene.html#"):
                assert links.parse_fragment(to.partition("#")[2]), to
            elif "#" in to:
                assert f'id="{to.partition("#")[2]}"' in pages[to.partition("#")[0] or path], to


def test_a_symptom_links_to_every_mistake_that_causes_it(pages):
    page = pages["yours.html"]
    shown = page[page.index('<section class="symptoms"') :]
    for words, names in SYMPTOMS.items():
        part = shown[shown.index(f"<summary>It {words}</summary>") :].partition("</details>")[0]
        assert re.findall(r'href="scene.html#([^"]+)"', part) == list(names)


def test_the_pages_load_nothing_from_another_server(files):
    for path, data in files.items():
        if path.startswith("reference/") or path.endswith(".png"):
            continue  # test_reference.py
        found = (
            data.decode()
            .replace("http://www.w3.org/", "")
            .replace("http://purl.org/", "")
            .replace("https://example.org/", "")
        )
        found = re.sub(r"https?://(creativecommons|matplotlib)\.org", "", found)  # in a picture's note of its maker
        assert "http://" not in found and "https://" not in found and "@import" not in found, path


def test_scripts_and_styles_are_files_only(pages):
    """Then the policy needs no exception: it would block an inline style or script, and the page would look wrong."""
    for path, page in pages.items():
        assert "unsafe-inline" not in page and "default-src 'none'" in page
        assert not re.search(r"<style|\sstyle=|\son[a-z]+=|javascript:", without_code(page)), path
        assert all('type="application/json"' in tag or 'src="' in tag for tag in re.findall(r"<script[^>]*>", page)), (
            path
        )


def test_elements_with_one_id_are_equal(pages):
    """Two pictures may clip to the same frame; nothing else is named twice."""
    for path, page in pages.items():
        ids = re.findall(r'\sid="([^"]+)"', page)
        for i in {i for i in ids if ids.count(i) > 1}:
            whole = set(re.findall(rf'<(?:clipPath|path) id="{re.escape(i)}".*?(?:</clipPath>|/>)', page, re.DOTALL))
            assert len({re.sub(r"\s+", " ", one) for one in whole}) == 1, (path, i)


def test_a_chapter_is_whole_without_javascript(pages):
    page = pages["2-sat.html"]
    assert "<h1>2 The Separating Axis Theorem</h1>" in page
    assert page.count('<svg class="picture"') > 8 and page.count("<summary>Solution</summary>") == 3
    assert 'rel="prev" href="1-aabb.html"' in page and 'rel="next" href="3-circles.html"' in page
    assert '<details class="cell">' in page and "depth 0.728" in page


def shown_by(chapter, function):
    """Return how many cells end with a call of that function."""
    ends = ["".join(cell["source"]).rsplit("\n", 1)[-1] for cell in chapter.cells if cell["cell_type"] == "code"]
    return sum(end.startswith(function) for end in ends)


def test_every_player_and_explorer_of_a_notebook_is_on_its_page(pages):
    known = chapters.chapters()
    for chapter in known:
        page = pages[chapter.path]
        found = page.count('<div class="player">'), page.count('<div class="live"')
        assert found == (shown_by(chapter, "sv.play("), shown_by(chapter, "sv.explore(")), chapter.path
    assert sum(shown_by(chapter, "sv.explore(") for chapter in known) >= 6
    shown = re.search(r'data-hash="([^"]+)"', pages["3-circles.html"])[1]
    assert links.parse_fragment(shown)[0].b == sv.Circle((7, 4), 1.5)


def test_a_slider_of_the_notebook_is_a_slider_of_the_page(pages):
    """A widget of the notebook's own leaves no output; its page has pictures of it, one of which is shown."""
    for chapter in chapters.chapters():
        code = [cell for cell in chapter.cells if cell["cell_type"] == "code" and not cell["outputs"]]
        ends = [ast.parse("".join(cell["source"])).body[-1] for cell in code]
        shown = sum(isinstance(end, ast.Expr) for end in ends)
        places = re.findall(r'<div class="frames">(.*?)</div>', pages[chapter.path], re.DOTALL)
        assert len(places) == shown, chapter.path
        for place in places:
            frames = re.findall(r"<figure tabindex=\"0\"( hidden)?>(.*?)</figure>", place, re.DOTALL)
            assert len({svg for _, svg in frames}) > 9 and [hidden for hidden, _ in frames].count("") == 1
    assert pages["5-doing-less.html"].count('class="frames"') == 2


BLOCKS = {"h1", "h2", "h3", "p", "li", "pre", "figure", "blockquote", "table"}
WHOLE = {"live", "player", "cell", "frames", "choices"}  # classes of parts of a page whose insides are their own matter


class Block(NamedTuple):
    """A part of a chapter's page: its tag or class, its words, and whether a closed answer hides it."""

    kind: str
    text: str
    folded: bool
    asks: bool


class Reader(HTMLParser):
    """The parts of a chapter's page in order, each once; code within prose is `x`."""

    EMPTY = "meta", "link", "img", "br", "input", "source", "hr"

    def __init__(self, page):
        super().__init__()
        self.path, self.found, self.begun = [], [], None
        article = page[page.index("<article>") : page.index("</article>")]
        self.feed(re.sub(r"<svg.*?</svg>|<script.*?</script>", self.said, article, flags=re.DOTALL))

    @staticmethod
    def said(picture):
        title = re.search(r"<title[^>]*>([^<]*)", picture[0])
        return title[1] if title else ""

    def handle_starttag(self, tag, attributes):
        if tag in self.EMPTY:
            return
        classes = set((dict(attributes).get("class") or "").split())
        closed = tag == "details" and "open" not in dict(attributes)
        self.path.append((tag, classes, closed))
        kind = next(iter(classes & WHOLE | classes & {"status", "open"}), tag)
        if self.begun is None and (kind in WHOLE or tag in BLOCKS):
            self.begun = len(self.path), kind, [], []
        if self.begun and tag == "code":
            self.begun[2].append("x")

    def handle_endtag(self, tag):
        while self.path and self.path[-1][0] != tag:
            self.path.pop()
        if self.begun and len(self.path) == self.begun[0]:
            _, kind, words, strong = self.begun
            text, bold = "".join(words), "".join(strong)
            asks = kind == "p" and (bold.endswith("?") or (bold.endswith(":") and "?" in text))
            self.found.append(Block(kind, text, any("later" in c and shut for _, c, shut in self.path), asks))
            self.begun = None
        if self.path:
            self.path.pop()

    def handle_data(self, data):
        inside = {tag for tag, *_ in self.path}
        if self.begun and "code" not in inside:
            self.begun[2].append(data)
            if "strong" in inside:
                self.begun[3].append(data)


def test_the_answer_to_a_question_is_folded_and_its_subject_is_not(pages):
    """All up to the next heading or question is folded, except code, shapes and widgets that follow directly.

    The choices come last of what is not folded, so that the reader has seen what they are about.
    """
    for chapter in chapters.chapters():
        tries = iter(
            "predict=True" in "".join(c["source"]) for c in chapter.cells if "sv.play(" in "".join(c["source"])
        )
        answers = state = None  # what the question has for an answer, and what comes next
        for block in Reader(pages[chapter.path]).found:
            tool = block.kind in ("live", "frames", "choices") or (block.kind == "player" and next(tries))
            tool = tool or (block.kind == "figure" and block.text.strip().endswith("Do they collide?"))
            where = chapter.path, block.text[:80]
            if block.asks or block.kind in ("h1", "h2", "h3"):
                assert not block.folded, where
                state = "asked" if block.asks else None
            elif state == "asked" and (tool or block.kind in ("cell", "status", "open")):
                assert not block.folded, where
            elif state:
                assert block.folded, where
                state, answers = "answered", (answers or 0) + 1
            else:
                assert not block.folded, where
        assert answers, chapter.path


def test_every_question_has_the_form_that_the_site_recognises():
    """The form is bold words; exercises have their own fold."""
    for chapter in chapters.chapters():
        prose = "\n\n".join("".join(cell["source"]) for cell in chapter.cells if cell["cell_type"] == "markdown")
        for paragraph in prose.partition("## Exercises")[0].split("\n\n"):
            if re.search(r"[Bb]efore you (run|look|go on)|\bGuess\b", paragraph) and "Make a guess" not in paragraph:
                assert chapters.QUESTION.search(paragraph), (chapter.path, paragraph)


def asked_in(chapter):
    """Yield each question of a chapter with the comment that has its choices ("" if it has none)."""
    for cell in chapter.cells:
        source = chapters.page_words("".join(cell["source"])) if cell["cell_type"] == "markdown" else ""
        question, _, choices = source.partition(chapters.CHOICES)
        last = question.strip().split("\n\n")[-1]
        if source and chapters.QUESTION.search(last):
            yield last, choices and chapters.CHOICES + choices


def test_a_notebook_folds_the_text_that_answers():
    """Its output is not there until the cell is run.  Directly after a fold stands one line at most."""
    for chapter in chapters.chapters():
        asked = False
        for cell in chapter.cells:
            if cell["cell_type"] == "code":
                continue
            text = re.sub(rf"{chapters.FOLD}.*?</details>", "FOLDED", "".join(cell["source"]), flags=re.DOTALL)
            parts = [part for part in text.split("\n\n") if not part.startswith(chapters.CHOICES)]
            for part in parts:
                if part.startswith("#"):
                    asked = False
                assert part != "FOLDED" or asked, (chapter.path, cell["id"])
                if chapters.QUESTION.search(part):
                    assert part is parts[-1], (chapter.path, part)
                    asked = True
                elif asked:
                    introduces = parts[0] == "FOLDED" and part is parts[-1] and len(part) < 160
                    assert part == "FOLDED" or introduces, (chapter.path, part)
            if parts[0] == "FOLDED":
                asked = asked and chapters.QUESTION.search(parts[-1])


def test_a_question_has_choices_of_which_one_is_right_and_each_has_a_reason(pages):
    """A question without choices asks for something to be found by trying."""
    for chapter in chapters.chapters():
        asked = [*asked_in(chapter)]
        judged = [chapters.choices_of(choices) for _, choices in asked if choices]
        assert pages[chapter.path].count('<ul class="choices">') == len(judged)
        for choices in judged:
            assert len(choices) == 3 and all(len(why) > 10 for _, _, why in choices)
        open_ended = [question for question, choices in asked if not choices]
        assert all("Can you find" in question or "is wrong.**" in question for question in open_ended), open_ended
    places = [
        [sign for sign, *_ in chapters.choices_of(c)].index("+")
        for ch in chapters.chapters()
        for _, c in asked_in(ch)
        if c
    ]
    assert all(places.count(i) > 3 for i in range(3)), "the right choice is not always at the same place"


@pytest.mark.parametrize(
    "lines", ["- one | why", "+ one | why\n+ two | why", "- one | why\n- two | why", "+ one\n- two | why"]
)
def test_choices_without_exactly_one_right_answer_are_refused(lines):
    with pytest.raises(ValueError, match="expected two or more lines"):
        chapters.choices_of(f"{chapters.CHOICES}\n{lines}\n-->")


def test_a_page_has_words_of_its_own_where_the_notebook_has_a_marker():
    source = "# T\n\nRun it. **Why?** <!-- page: See it.\n**Why?** -->\n\nIn Jupyter only. <!-- page: -->\n\nBoth."
    assert chapters.page_words(source) == "# T\n\nSee it.\n**Why?**\n\nBoth."


MISTAKES = {
    "collide_1": "open-outline",
    "collide_2": "one-overlap",
    "collide_3": "far-centers",
    "way_out": "raw-depth",
    "away_from_middle": "push-from-center",
}


@pytest.mark.parametrize("name", one_in(5, MISTAKES))
def test_a_program_of_chapter_8_stands_alone_and_its_one_mistake_is_mended_by_its_solution(name):
    chapter = chapters.chapters()[7]
    given = page_chapters.programs(chapter)
    assert given.keys() == MISTAKES.keys()
    names = {}
    exec(given[name][1], names)
    found = sv.check(names[name])
    assert found.finding == "wrong" and found.behaves_like[0].name == MISTAKES[name]
    prose = "\n".join("".join(cell["source"]) for cell in chapter.cells)
    folds = re.findall(r"<summary>Solution</summary>\n\n.*?```python\n(.*?)```", prose, re.DOTALL)
    (solution,) = [code for code in folds if f"def {name}(" in code]
    exec(solution, names)
    assert sv.check(names[name]).right


def test_an_answer_is_opened_without_a_script(pages):
    for chapter in chapters.chapters():
        answers = re.findall(r'<details class="later"([^>]*)>(<summary>([^<]+)</summary>)?', pages[chapter.path])
        assert answers and all(answer == ("", "<summary>The answer</summary>", "The answer") for answer in answers)
        assert "<details><summary>The answer" not in pages[chapter.path]


GLUED = re.compile(r"[\w)\]”\"'][.!?;:,]+[\"”)]?(?=[A-Z“])|[a-z)][.!?](?=[a-z])")


def test_no_sentence_is_glued_to_the_next(pages):
    for chapter in chapters.chapters():
        for block in Reader(pages[chapter.path]).found:
            if block.kind in ("p", "li", "blockquote", "h1", "h2", "h3"):
                assert not GLUED.search(block.text), block.text
    assert GLUED.search("the point (4, 2) is.Sometimes") and not GLUED.search("It is. Sometimes “so”, e. g. 0.3, 1,000")


NOTEBOOK_WORDS = re.compile(
    r"Shift\+Enter|JupyterLab|(next|this) cell\b|cell (below|after)|[Rr]un (it|the|a cell)\b"
    r"|you run|[Tt]he code below|\bmouse\b|[Tt]erminal|[Cc]ommand line|[Cc]lick|[Tt]he notebook\b"
)


def test_a_chapter_reads_as_a_page_and_not_as_a_notebook(pages):
    """On a telephone there is no cell to run, no mouse and no terminal."""
    for chapter in chapters.chapters():
        for block in Reader(pages[chapter.path]).found:
            if block.kind in ("p", "li", "h1", "h2", "h3", "table", "blockquote"):
                assert not NOTEBOOK_WORDS.search(block.text), (chapter.path, block.text)


def test_the_gallery_has_every_scene(files, pages):
    for name in [scene.name for scene in SCENES] + [row.name for row in FAILURE_CASES]:
        assert f"pictures/{name}.svg" in files and f'src="pictures/{name}.svg"' in pages["gallery.html"]
    for row in FAILURE_CASES:  # one panel above the other: the letters of a wider picture would be small in a card
        width, alt = re.search(
            rf'<img src="pictures/{row.name}.svg" width="([^"]*)" [^>]*alt="([^"]*)"', pages["gallery.html"]
        ).groups()
        assert float(width) <= NARROW_SIZE_PT[0]
        assert "Wrong: " in alt or row.how == REFUSED  # also where the verdict itself is right
    openable = set(re.findall(r'href="scene.html#([^"]+)"', pages["gallery.html"]))
    assert openable == {s.name for s in SCENES} | {row.name for row in FAILURE_CASES if row.how != REFUSED}


def test_no_page_contains_the_replacement_character(files):
    """A no-break space between a number and its unit is a letter, too."""
    texts = {path: data for path, data in files.items() if path.endswith((".html", ".svg"))}
    assert [path for path, data in texts.items() if "\ufffd" in data.decode()] == []
    assert "below 1.8\xa0pm" in texts["7-speed-against-accuracy.html"].decode()


def test_pictures_follow_the_theme(pages, files):
    assert not re.search(r'(?:fill|stroke)="#', pages["2-sat.html"])
    assert "prefers-color-scheme: dark" in files["pictures/triangles.svg"].decode()
    assert 'fill="var(--sv-A)"' in themed_svg('<svg ><g style="fill: #0072b2"/></svg>')


def test_pages_have_short_coordinates_and_compressed_steps(pages):
    """Coordinates have hundredths of a point, and a player's steps are compressed.  Numbers to read stay whole."""
    short = themed_svg('<svg ><path d="M 1.23456 2 L 3.999999 0.5"/><text x="7.777">gap 1.213</text></svg>')
    assert '<path d="M 1.23 2 L 3.99 0.5"/><text x="7.77">gap 1.213</text>' in short
    (packed,) = re.findall(r'<script type="application/json">(".*?")</script>', pages["2-sat.html"])
    show = json.loads(zlib.decompress(b64decode(json.loads(packed)), -zlib.MAX_WBITS))
    assert show["predict"] and len(show["shows"][0]["steps"]) > 15


def test_the_command_overwrites_a_site_that_it_made_and_nothing_else(tmp_path, capsys, files, monkeypatch):
    monkeypatch.setattr("satviz.site.build.site", lambda **_: (iter(files.items()), []))
    out = tmp_path / "site"
    for _ in range(2):
        assert main(["site", str(out), "--still"]) == 0
    assert "site" in capsys.readouterr().out
    (out / "site.css").write_text("mine")
    assert main(["site", str(out), "--still"]) == 2
    assert (out / "site.css").read_text() == "mine" and "was not made by satviz" in capsys.readouterr().err


@pytest.mark.slow
def test_without_npm_the_site_is_made_and_one_line_says_so(monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr(runtime, "which", lambda name: None)
    monkeypatch.setattr(build, "chapters", list)  # which takes long and is the same
    monkeypatch.setattr(build, "reference", lambda in_site: ())
    found, lacks = site()
    assert lacks == [
        "npm is not installed: install it, or give a folder that holds Pyodide. "
        "Without it the site is whole, but its scenes stay still"
    ]
    assert next(found)[0] == "site.js"


@pytest.mark.parametrize("version, why", [(None, "holds no Pyodide"), ("0.1", "this satviz needs")])
def test_another_pyodide_is_refused(tmp_path, version, why):
    if version:
        (tmp_path / "package.json").write_text(json.dumps({"version": version}))
        for name in runtime.CORE:
            (tmp_path / name).write_text("")
    with pytest.raises(runtime.PythonMissing, match=why):
        runtime.runtime_files(tmp_path)


def test_a_folder_without_pyodide_is_bad_input(tmp_path, capsys):
    assert main(["site", str(tmp_path / "out"), "--pyodide", str(tmp_path)]) == 2
    assert "holds no Pyodide" in capsys.readouterr().err and not (tmp_path / "out").exists()


@pytest.mark.slow
def test_open_serves_the_site_until_it_is_interrupted(tmp_path):
    command = [sys.executable, "-m", "satviz", "site", str(tmp_path / "site"), "--still", "--open"]
    env = {**os.environ, "BROWSER": "true"}  # a program that does nothing with the address
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    heard = partial(signal.signal, signal.SIGINT, signal.SIG_DFL)  # also where a job in the background hears no Ctrl-C
    with subprocess.Popen(command, env=env, preexec_fn=heard, **pipes) as process:
        try:
            address = next(word for line in process.stdout for word in line.split() if word.startswith("http"))
            with urllib.request.urlopen(f"{address}python/no") as _:
                pass
        except urllib.error.HTTPError as error:
            assert error.code == 404 and "default-src 'none'" in error.headers["Content-Security-Policy"]
        with urllib.request.urlopen(address) as found:
            assert b"Do they collide?" in found.read()
        process.send_signal(signal.SIGINT)
        assert process.wait(20) == 130 and "Traceback" not in process.stderr.read()


def test_a_package_with_another_hash_is_refused(monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr(runtime, "_fetch_from_npm", lambda: b"another")
    with pytest.raises(runtime.PythonMissing, match="hash"):
        runtime.runtime_files(None)
    assert not list(tmp_path.rglob("*.tgz"))


def test_one_command_pins_another_pyodide():
    source = refresh_pyodide.RUNTIME.read_text(encoding="utf-8")
    assert refresh_pyodide.pinned(source, runtime.VERSION, runtime.INTEGRITY) == source
    other = refresh_pyodide.pinned(source, "400.1.2", f"sha512-{'a' * 86}==")
    names = {}
    exec("\n".join(line for line in other.splitlines() if line.startswith(("VERSION =", "INTEGRITY ="))), names)
    assert (names["VERSION"], names["INTEGRITY"]) == ("400.1.2", f"sha512-{'a' * 86}==")
    for version, integrity in ("latest", runtime.INTEGRITY), (runtime.VERSION, "sha1-x"):
        with pytest.raises(ValueError, match="npm says"):
            refresh_pyodide.pinned(source, version, integrity)


def test_packed_files_are_plain_gzip_and_the_same_each_time():
    data = bytes(range(256)) * 300
    assert gzip.decompress(runtime.gzipped(data)) == data and runtime.gzipped(data) == runtime.gzipped(data)


def test_the_pages_python_needs_the_standard_library_only(tmp_path):
    """The zip, unpacked by itself, opens a scene and answers a pose without any other package."""
    ZipFile(io.BytesIO(runtime.satviz_zip())).extractall(tmp_path)
    code = (
        "import json, sys; from satviz.site import live\n"
        "state = json.loads(live.answer('p', json.dumps({'kind': 'open', 'hash': 'triangles'})))['first']\n"
        "pose = {'kind': 'pose', 'n': 1, 'a': state['a'], 'b': state['b'], 'degree': 30}\n"
        "assert json.loads(live.answer('p', json.dumps(pose)))['kind'] == 'state'\n"
        "assert not {'numpy', 'matplotlib', 'anywidget', 'PIL'} & set(sys.modules)\n"
        "print(live.__file__)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=tmp_path, env={}, capture_output=True, text=True, check=True
    )
    assert str(tmp_path) in done.stdout


# -- links


def opened(text):
    return json.loads(live.answer("place", json.dumps({"kind": "open", "hash": text})))


@pytest.mark.parametrize("name", [scene.name for scene in SCENES] + [r.name for r in FAILURE_CASES if r.how != REFUSED])
def test_the_link_of_a_built_in_scene_is_its_name(name):
    assert sv.link(name) == f"scene.html#{name}"
    assert links.parse_fragment(name)[0] == sv.scene(name)


def test_the_link_of_any_other_scene_holds_the_scene_and_its_view():
    mine = sv.Scene(
        "kite", sv.Polygon([(0, 0), (0.1, -1), (6, 0)], ["w", "é", "n"]), sv.Circle((5.5, 3), 1), title="Ä & <b>"
    )
    made = sv.link(mine, site="https://example.org/satviz", free=30.5, mtv=True)
    assert made.startswith("https://example.org/satviz/scene.html#") and re.fullmatch(
        r"[\w\-&=.]+", made.partition("#")[2]
    )
    assert links.parse_fragment(made.partition("#")[2]) == (mine, links.ViewOptions(free=30.5, mtv=True))


def test_a_link_opens_the_same_state():
    state = opened("triangles&free=30&mtv=1&difference=1")
    assert "at 30 degrees" in state["first"]["sentence"] and "difference" in state["first"]
    assert state["pose"]["degree"] == 30 and state["pose"]["mtv"] and state["pose"]["difference"]
    assert opened("far-centers&view=truth")["first"]["view"] == "truth"
    assert opened("triangles&row=4")["first"]["lit"] == 4
    player = opened("triangles&step=5&predict=1")
    assert player["step"] == 5 and player["predict"] and len(player["shows"][0]["steps"]) == 16
    whole = opened("triangles&step=43&every-axis=1")
    assert whole["everyAxis"] and whole["step"] == 43 == len(whole["shows"][1]["steps"]) - 1
    assert not opened("circles&every-axis=1")["everyAxis"]  # the early exit leaves out no axis


def test_the_state_contains_the_link_that_opens_it_again():
    first = opened("triangles")["first"]
    pose = {"kind": "pose", "n": 1, "a": first["a"], "b": {"circle": [4, 4], "radius": 1}, "degree": 12.5}
    said = json.loads(live.answer("place", json.dumps(pose)))
    again = opened(said["link"])["first"]
    assert again["picture"]["marks"] and again["sentence"] == said["sentence"] and again["link"] == said["link"]


@pytest.mark.parametrize("shows", ["row=0", "row=5", "free=0", "free=-0.1", "free=0.00001", "free=359", "difference=1"])
def test_an_option_of_a_link_is_shown_and_is_in_the_new_link(shows):
    first = opened(f"triangles&{shows}")["first"]
    assert first["link"] == f"triangles&{shows}" and opened(first["link"])["first"] == first


@pytest.mark.parametrize("degree", [1e-7, 1 / 3, 1e-13, -12.345678901234567])
def test_an_axis_at_any_angle_can_be_linked(degree):
    _, shown = links.parse_fragment(sv.link("triangles", free=degree).partition("#")[2])
    assert shown.free == pytest.approx(degree, abs=1e-12)


def test_a_traces_link_is_its_scenes():
    for scene in ALL_SCENES:
        assert links.parse_fragment(links.fragment_of_trace(scene.record()))[0].record() == scene.record(), scene.name
    a, b = sv.Circle((0, 0), 1), sv.Circle((3, 0), 1)
    assert links.parse_fragment(links.fragment_of_trace(sv.record(a, b)))[0].record() == sv.record(a, b)
    assert links.fragment_of_trace(sv.record(a, b, axes=sv.axes.directions((1, 2)))) == ""


def test_steps_of_a_player_end_at_the_last():
    assert opened("triangles&step=999999")["step"] == 15


BAD = [
    "",
    "nothing-of-that-name",
    "eyJzYXR2",
    "§",
    "%%%",
    "triangles&free=nan",
    "triangles&free=1e999",
    "triangles&free=30&free=30",
    "triangles&step=-1",
    "triangles&step=1.5",
    "triangles&view=other",
    "triangles&__class__=1",
    "triangles&mtv=yes",
    "no-area",
    urlsafe_b64encode(b'{"satviz": "scene 1", "a": {"circle": [0, 0], "radius": 0}, "b": 1}').decode(),
    urlsafe_b64encode(b"[" * 2000).decode(),
    urlsafe_b64encode(b"\xff\xfe").decode(),
]


@pytest.mark.parametrize("text", BAD)
def test_a_malformed_link_is_refused_as_invalid_scene(text):
    with pytest.raises(InvalidScene):
        links.parse_fragment(text)
    assert opened(text)["kind"] == "refused"


@pytest.mark.parametrize("key", [key.replace("_", "-") for key in links.ViewOptions._fields])
def test_a_link_with_an_invalid_value_says_what_is_expected(key):
    with pytest.raises(InvalidScene, match=r": (expected|choose one of) \S"):
        links.parse_fragment(f"triangles&{key}=?")


def test_a_link_beyond_all_bounds_is_not_even_decoded():
    with pytest.raises(InvalidScene, match="limit"):
        links.parse_fragment("e" * (links.MAX_CHARS * 2 + 1))


def test_a_link_that_could_not_be_opened_again_is_refused():
    with pytest.raises(InvalidScene):
        sv.link("triangles", view="other")
    with pytest.raises(TypeError, match="this is a Circle: pass a scene's name, a Scene, two shapes, or their trace"):
        sv.link(sv.Circle((0, 0), 1))


def test_two_shapes_and_a_trace_have_a_link():
    a, b = sv.Polygon([(0, 1), (3, 2), (1, 5)]), sv.Circle((4, 4), 1)
    scene, shown = links.parse_fragment(sv.link(a, b, free=30.0).partition("#")[2])
    assert (scene.a, scene.b, scene.axes, shown.free) == (a, b, "needed", 30.0)
    assert sv.link(sv.scene("far-centers").record()) == sv.link("far-centers")
    world = sv.record(a, b, axes=sv.axes.world, every_axis=True)
    assert links.parse_fragment(sv.link(world).partition("#")[2])[0].record() == world
    for own in sv.axes.directions((1, 2)), sv.Shortcut("mine", "one is enough", sv.axes.world):
        scene, _ = links.parse_fragment(sv.link(sv.record(a, b, axes=own, every_axis=True)).partition("#")[2])
        assert (scene.a, scene.b, scene.axes, scene.every_axis) == (a, b, "needed", True)


SITES = [
    "javascript:alert(1)//",
    "JavaScript:alert(1)",
    "data:text/html,x",
    "file:///etc/",
    "ftp://example.org",
    "//example.org",
    "example.org/satviz",
    "../",
    "https:",
    "https://",
    "https:///satviz",
    "https:example.org",
    "http://[",
    "http://example.org:port",
    "https://example.org/?q=1",
    "https://example.org/#top",
    " https://example.org",
    "https://example.org/a b",
    "java\nscript:alert(1)",
    "ht\ttps://example.org",
    "https://example.org/\u202e",
    "https:\\\\example.org",
    'https://example.org/"a',
    "https://example.org/'a",
    "https://example.org/`a",
    "https://example.org/<b>",
    "https://example.org/scene.html#triangles",
]


@pytest.fixture(scope="module")
def player():
    pytest.importorskip("anywidget")
    return sv.play("aabb")


@pytest.mark.parametrize("site", SITES, ids=range(len(SITES)))
def test_a_site_is_at_an_address_of_http_or_https(site, player, capsys, monkeypatch):
    """This holds in Python, on the command line, in the environment and on a widget."""
    with pytest.raises(InvalidScene, match=r"^site is .*: expected an address such as https://"):
        sv.link("triangles", site=site)
    assert main(["draw", "triangles", "--format", "link", f"--site={site}"]) == 2
    captured = capsys.readouterr()
    assert captured.out == "" and "site is" in captured.err and captured.err.count("\n") == 1
    with pytest.raises(InvalidScene, match=r"^site is"):
        player.site = site
    assert player.site == ""
    monkeypatch.setenv("SATVIZ_SITE", site)
    with pytest.raises(InvalidScene, match=r"^SATVIZ_SITE is"):
        sv.play("aabb")


@pytest.mark.parametrize(
    "site", ["https://example.org", "http://localhost:8000/s", "HTTPS://Example.org/a/", "http://[::1]/"]
)
def test_the_address_of_a_site_ends_with_a_slash(site, monkeypatch):
    folder = site.removesuffix("/") + "/"
    assert sv.link("triangles", site=site) == f"{folder}scene.html#triangles"
    pytest.importorskip("anywidget")
    monkeypatch.setenv("SATVIZ_SITE", site)
    assert sv.play("aabb").site == sv.explore("aabb").site == folder


@pytest.mark.parametrize("page", ["scene.html", "index.html", "2-sat.HTML", "x.htm"])
def test_the_address_of_a_page_gives_its_folder(page, capsys):
    for folder in "https://a.b/", "https://a.b/c/", "https://a.b/c.html/":
        assert sv.link("triangles", site=folder + page) == f"{folder}scene.html#triangles"
        assert main(["draw", "triangles", "--format", "link", f"--site={folder}{page}"]) == 0
        assert capsys.readouterr().out == f"{folder}scene.html#triangles\n"
    assert sv.link("triangles", site="https://a.html") == "https://a.html/scene.html#triangles"


def test_an_empty_address_is_refused_on_the_command_line(capsys):
    assert main(["draw", "triangles", "--format", "link", "--site", ""]) == 2
    captured = capsys.readouterr()
    assert captured.out == "" and "--site is empty" in captured.err and captured.err.count("\n") == 1


def test_a_site_address_that_is_not_text_is_named():
    with pytest.raises(TypeError, match=r"^site is None: pass an address as text"):
        sv.link("triangles", site=None)


def test_draw_prints_the_link(capsys, tmp_path):
    assert main(["draw", "far-centers", "--format", "link", "--site", "https://example.org/s/"]) == 0
    assert capsys.readouterr() == ("https://example.org/s/scene.html#far-centers\n", "")
    assert main(["draw", "triangles", "--axes", "world", "--format", "link"]) == 0
    printed = capsys.readouterr()
    shown, _ = links.parse_fragment(printed.out.strip().partition("#")[2])
    assert shown.axes == "world"
    assert "add the site with --site URL" in printed.err  # without a site the link alone opens nothing


def test_draw_prints_the_link_beside_the_files(capsys, tmp_path):
    assert main(["draw", "circles", "--sheet", "--format", "link", "--format", "svg", "--out", str(tmp_path)]) == 0
    assert capsys.readouterr().out == f"scene.html#circles\n1 file in {tmp_path}\n"
    assert [path.name for path in tmp_path.iterdir()] == ["circles-sheet.svg"]


# -- challenges


def stands(goal, a, b, axes="needed"):
    return goals.evaluate_goal(goal, sv.Scene("mine", a, b, axes))


def test_the_one_axis_challenge_counts_separating_axes():
    box, turned = sv.Polygon([(0, 0), (2, 0), (2, 2), (0, 2)]), sv.Polygon([(2.2, 1), (3.2, 0), (4.2, 1), (3.2, 2)])
    assert stands("one-axis", box, turned).status == "Exactly one axis separates them."
    assert not stands("one-axis", box, sv.Polygon([(9, 9), (11, 9), (10, 12)])).met
    assert "collide" in stands("one-axis", box, sv.Circle((1, 1), 1)).status
    assert "dent" in stands("one-axis", sv.Polygon([(0, 0), (4, 0), (1, 1), (0, 4)]), sv.Circle((9, 9), 1)).status


def test_axes_that_are_parallel_up_to_rounding_count_as_one():
    """A's edge a1a3 lies along B's v1v3; moved by a decimal they are no longer parallel for the computer."""
    start = sv.scene("triangles")
    for hundredths in range(40, 120):
        corners = [(float(f"{x - hundredths / 100:.12g}"), y) for x, y in start.b.vertices]
        found = stands("one-axis", start.a, sv.Polygon(corners))
        assert found.met and found.status == "Exactly one axis separates them.", (hundredths, found.status)


def test_the_touch_challenge_accepts_only_an_exact_touch():
    box = sv.Polygon([(0, 0), (1, 0), (1, 1), (0, 1)])
    assert stands("touch", box, sv.Circle((2, 0.5), 1)).met
    hair = stands("touch", box, sv.Circle((2.0000000000000004, 0.5), 1))
    assert not hair.met and "e" in hair.status  # a gap too small for three decimals is not shown as 0
    assert stands("touch", box, sv.Circle((1.9999999999999998, 0.5), 1)).status == "They overlap."


@pytest.mark.slow
def test_every_shortcut_that_can_be_broken_begins_unbroken_and_its_own_scene_breaks_it():
    asked = [start for goal, start in goals.challenges() if goal == "break"]
    assert len(asked) > 25
    for start in asked:
        assert not goals.evaluate_goal("break", start).met and goals.evaluate_goal("break", sv.scene(start.axes)).met, (
            start.name
        )


@pytest.mark.slow
def test_no_challenge_is_won_when_it_begins_and_each_has_its_link():
    for goal, start in goals.challenges():
        assert not goals.evaluate_goal(goal, start).met
        first = opened(sv.link(start, goal=goal).partition("#")[2])["first"]
        assert first["goal"]["task"] == goals.GOAL_TASKS[goal] and first["link"].endswith(f"&goal={goal}")


def by_the_hint(goal, start):
    """Yield the scenes that a person can reach: B moved by keys, a circle level with a point, corners on one place."""
    a, b = start.a, start.b
    at_most = 8 / ExplorerModel(start).picture().scale  # as the browser's: 1, 2 or 5 times a power of ten
    step = max(
        float(f"{digit}e{power}")
        for digit in (1, 2, 5)
        for power in range(-9, 9)
        if float(f"{digit}e{power}") <= at_most
    )
    for r in range(46):
        for x, y in product(range(-r, r + 1), repeat=2):
            if max(abs(x), abs(y)) == r:
                yield replace(start, b=translated(b, sv.Vec(x * step, y * step)))
    if goal != goals.TOUCH:
        return
    round_, other = (b, a) if isinstance(b, sv.Circle) else (a, b)
    if isinstance(round_, sv.Circle):
        (spots, out) = ([other.center], other.radius) if isinstance(other, sv.Circle) else (other.vertices, 0)
        for (x, y), side in product(spots, (1, -1)):
            level = sv.Circle((x + side * (round_.radius + out), y), round_.radius)
            yield replace(start, a=level, b=other) if round_ is a else replace(start, a=other, b=level)
        return
    for (i, p), (j, q) in product(enumerate(a.vertices), enumerate(b.vertices)):
        place = round((p.x + q.x) / 2, 2), round((p.y + q.y) / 2, 2)
        ends = [[*s.vertices[:k], place, *s.vertices[k + 1 :]] for s, k in ((a, i), (b, j))]
        with suppress(InvalidShape):
            yield replace(start, a=sv.Polygon(ends[0]), b=sv.Polygon(ends[1]))


SOME = [pytest.param(s.name, marks=[pytest.mark.slow] if i % 5 else []) for i, s in enumerate(ALL_SCENES)]


@pytest.mark.parametrize("name", SOME)
def test_every_challenge_can_be_solved_as_its_hint_says(name):
    for goal in goals.GOAL_NAMES:
        try:
            start = goals.challenge_start(goal, sv.scene(name))
        except InvalidScene:
            continue
        assert any(goals.evaluate_goal(goal, there).met for there in by_the_hint(goal, start)), goal


def test_a_drag_is_evaluated_and_a_preset_ends_the_challenge():
    first = opened("aabb&goal=touch")["first"]
    b = {"polygon": [[x - 2, y] for x, y in first["b"]["polygon"]]}
    said = json.loads(live.answer("place", json.dumps({"kind": "pose", "n": 1, "a": first["a"], "b": b})))
    assert said["goal"]["met"] and said["goal"]["status"] == "They touch, exactly."
    said = json.loads(live.answer("place", json.dumps({"kind": "preset", "name": "circles"})))
    assert "goal" not in said


def test_a_goal_that_the_scene_cannot_have_is_refused():
    assert "not a shortcut" in opened("triangles&goal=break")["why"]
    assert "no challenge is called 'win'" in opened("triangles&goal=win")["why"]


@pytest.mark.parametrize("text", BAD)
def test_the_reason_why_a_link_opens_nothing_is_one_plain_line(text):
    why = opened(text)["why"]
    assert "\n" not in why and len(why) <= 200 and "JSON" not in why and "line 1" not in why


def test_a_link_that_opens_nothing_is_offered_every_scene(pages):
    offer = re.search(r'<nav class="offer"[^>]* hidden>(.*?)</nav>', pages["scene.html"], re.DOTALL)[1]
    assert re.findall(r'href="scene.html#([^"]+)"', offer) == [scene.name for scene in ALL_SCENES]


def test_every_challenge_is_offered_once_and_each_level_has_some(pages):
    page = pages["challenges.html"]
    levels = re.findall(r"<section><h2>(.*?)</section>", page, re.DOTALL)
    offered = [re.findall(r'data-challenge="([^"]+)"', level) for level in levels]
    assert len(offered) == 3 and all(len(found) > 4 for found in offered)
    assert sorted(each for found in offered for each in found) == sorted(
        f"{goal}:{start.name}" for goal, start in goals.challenges()
    )


def test_a_shortcut_that_is_wrong_nearly_everywhere_is_easier_to_break_than_one_that_is_nearly_always_right():
    starts = {start.name: start for goal, start in goals.challenges() if goal == "break"}
    levels = [goals.level("break", starts[n]) for n in ("circles-turned-round", "aabb-turned", "no-nearest-vertex")]
    assert levels == [1, 2, 3]


def test_the_state_that_meets_a_challenge_has_its_goal_and_the_name_of_its_scene():
    """The browser keeps the goal and the name in `scene`, which a drag does not change."""
    first = opened("aabb&goal=touch")["first"]
    b = {"polygon": [[x - 2, y] for x, y in first["b"]["polygon"]]}
    said = json.loads(live.answer("place", json.dumps({"kind": "pose", "n": 1, "a": first["a"], "b": b})))
    assert said["goal"]["goal"] == "touch" and json.loads(said["scene"])["name"] == "aabb"


def test_the_first_minute_ends_at_the_largest_gap_with_the_axis_of_the_scene_to_drag(pages):
    data = json.loads(re.search(r'class="first-minute">(.*?)</script>', pages["index.html"], re.DOTALL)[1])
    parts = [{data["marks"][i]["part"] for i in frame} for frame in data["frames"]]
    assert "overlap" in parts[0] and "gap" in parts[-1] and len(parts) > 30
    x0, y0, x1, y1 = data["limits"]
    assert all(x0 < x < x1 and y0 < y < y1 for mark in data["marks"] for x, y in mark["points"])
    ((x0, y0), (x1, y1)) = next(
        mark["points"] for mark in (data["marks"][i] for i in data["frames"][-1]) if mark["part"] == "axis"
    )
    axis = sv.scene("triangles").record().tests[-1].axis.direction
    assert ((x1 - x0) * axis.x + (y1 - y0) * axis.y) / hypot(x1 - x0, y1 - y0) > 0.99


def test_no_picture_of_a_card_is_wider_than_a_telephones_page():
    """A page of 390 px has 362 px for it, and a canvas of as many points letters of 11 px."""
    drawn = [term.draw() for term in TERMS] + [
        build.pages._scene_picture(name) for name in (s.name for s in ALL_SCENES)
    ]
    assert max(picture.size[0] for picture in drawn) <= 362


def test_a_chapters_picture_is_drawn_for_a_telephone_too(pages):
    """Scrolled sideways it would show one of its two shapes."""
    for chapter in chapters.chapters():
        code = ["".join(cell["source"]) for cell in chapter.cells if cell["cell_type"] == "code"]
        drawn = sum(code.splitlines()[-1].startswith(("sv.picture(", "sv.gap_curve(")) for code in code)
        places = re.findall(r'<figure><div class="wide">(.*?)</figure>', pages[chapter.path], re.DOTALL)
        assert len(places) == drawn, chapter.path
        for place in places:
            _, narrow = (float(width) for width in re.findall(r'<svg[^>]* width="([\d.]+)pt"', place))
            assert narrow <= 362, chapter.path
    assert "<figure><div" in pages["1-aabb.html"]


# -- the glossary


def test_each_term_has_a_sentence_a_picture_and_its_place_on_the_page(files, pages):
    page = pages["glossary.html"]
    assert 20 <= len(TERMS) == len({term.id for term in TERMS}) == page.count('<article class="card"')
    for term in TERMS:
        assert f'id="{term.id}"' in page and f"pictures/term-{term.id}.svg" in files
        assert term.sentence.endswith(".") and len(term.sentence) < 130 and term.others
        assert re.fullmatch(term.words, term.name, re.IGNORECASE), term.name


def test_a_term_is_linked_where_a_chapter_uses_it_first_and_nowhere_else(pages):
    found = {}
    for chapter in chapters.chapters():
        article = pages[chapter.path].partition("<article>")[2]
        links = re.findall(r'<a class="term" href="glossary.html#([\w-]+)">', article)
        assert len(links) == len(set(links)) and len(links) > 3, chapter.path
        assert not re.search(r"<a [^>]*>[^<]*<a ", article)
        found[chapter.path[0]] = links
    assert {"range", "gap", "aabb", "separating-axis", "false-hit"} <= set(found["1"])
    assert set().union(*found.values()) >= {term.id for term in TERMS} - {"support-point", "minkowski-difference"}


def test_a_term_is_linked_in_text_and_not_in_code_or_within_a_link():
    linker = TermLinker("g")
    assert linker.linked("<p><code>gap</code> <a href='x'>the gap</a>: a Gap, a gap.</p>") == (
        '<p><code>gap</code> <a href=\'x\'>the gap</a>: a <a class="term" href="g#gap">Gap</a>, a gap.</p>'
    )
    assert linker.linked("<p>A convex hull.</p>") == '<p>A <a class="term" href="g#convex-hull">convex hull</a>.</p>'
    assert linker.linked("<p>It is convex.</p>") == '<p>It is <a class="term" href="g#convex">convex</a>.</p>'


# -- guides


def test_a_guide_has_its_page_with_its_title_and_its_neighbours(pages):
    index, *others = guides.guides()
    assert index.path == "guides.html" and len(others) >= 10
    for before, guide in zip([index, *others], others):
        page = pages[guide.path]
        assert f">{guide.title}</h1>" in page and f'rel="prev" href="{before.path}"' in page
        assert f'href="{guide.path}"' in pages["guides.html"] and f'href="{guide.path}"' in pages["index.html"]


def test_a_guide_links_to_chapters_and_to_headings_of_other_guides(pages):
    assert (
        'href="2-sat.html"' in pages["traces.html"]
        and 'href="pictures.html#one-page-to-send"' in (pages["notebook.html"])
    )
    for guide in guides.guides():
        assert not re.search(r'(?:href|src|srcset)="[^"]*(?:\.md|\.ipynb|\.\./)', pages[guide.path]), guide.path


def test_a_guides_pictures_are_files_of_the_site(files, pages):
    shown = {name for page in pages.values() for name in re.findall(r'(?:src|srcset)="(figures/[^"]+)"', page)}
    charts = {f"figures/{stem}{end}.svg" for stem in ("bench", "frames") for end in ("", "-dark")}
    assert charts <= shown <= set(files)


def test_the_reference_is_a_part_of_the_site(files, pages):
    pytest.importorskip("pdoc")
    assert 'href="reference/satviz.html"' in pages["index.html"] and "reference/satviz/batch.html" in files


@pytest.mark.slow
def test_without_pdoc_the_site_has_no_reference_and_one_line_says_so(monkeypatch):
    monkeypatch.setitem(sys.modules, "pdoc", None)
    monkeypatch.setattr(build.pages, "scene_pictures", tuple)  # which take longest and are the same
    monkeypatch.setattr(build, "chapters", list)
    found, missing = site(live=False)
    assert len(missing) == 1 and missing[0].startswith("the site has no reference: the reference needs the extra")
    found = dict(found)
    assert not any(path.startswith("reference/") for path in found) and b"reference/" not in found["index.html"]
