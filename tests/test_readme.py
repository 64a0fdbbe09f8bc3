"""The code, the commands, the links and the scene file of the README and of the guides do what the text says."""

import json
import re
import shlex
from itertools import chain

import pytest
from refresh_charts import BENCH_CHARTS, bench_rows
from refresh_guides import GUIDES, ROOT, documents, refreshed

import satviz as sv
from satviz.cli import main
from satviz.pictures.theme import TEXT_PT as TEXT_SIZE
from satviz.study import bench

DOCUMENTS = documents()
README = DOCUMENTS["README.md"]
CHECK_GUIDE = DOCUMENTS["satviz/guides/check.md"]
NOTEBOOK_GUIDE = DOCUMENTS["satviz/guides/notebook.md"]
MAX_README_WORDS = 900


def blocks(language, text):
    return re.findall(rf"^```{language}\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)


def test_the_readme_is_short():
    assert len(README.split()) <= MAX_README_WORDS


def test_the_first_picture_keeps_its_text_at_10_points():
    name, width = re.search(r'<img src="(\S+)" width="(\d+)"', README).groups()
    points = float(re.search(r'width="([\d.]+)pt"', (ROOT / name).read_text(encoding="utf-8"))[1])
    assert TEXT_SIZE * (int(width) * 72 / 96) / points >= 10


@pytest.mark.parametrize("name", DOCUMENTS)
def test_the_code_prints_the_output_below_it(name, tmp_path, monkeypatch):
    """If it does not, python tests/refresh_guides.py writes the new output."""
    monkeypatch.chdir(tmp_path)
    assert refreshed(DOCUMENTS[name], name) == DOCUMENTS[name]


def test_the_readmes_example_is_short_and_draws_its_picture(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (code,) = blocks("python", README)
    assert len([line for line in code.splitlines() if line]) <= 8
    refreshed(README, "README.md")
    assert (tmp_path / "verdict.png").stat().st_size > 1000


SCENE_FILE = blocks("json", DOCUMENTS["satviz/guides/scene-files.md"])[0]


def test_the_scene_file_loads():
    scene = sv.Scene.from_json(SCENE_FILE)
    assert scene.name == "kite-and-coin" and json.loads(scene.to_json()) == json.loads(SCENE_FILE)


LINES = chain.from_iterable(block.splitlines() for text in DOCUMENTS.values() for block in blocks("sh", text))
COMMANDS = [line for line in dict.fromkeys(LINES) if line.startswith("satviz ")]
SLOW = (
    "satviz study", "satviz bench", "satviz site", "satviz advise", "satviz figures --", "satviz reference",
    "satviz check --command", "satviz draw my-scene.json --out steps", "satviz handout my-scene.json",
)  # fmt: skip


@pytest.mark.parametrize(
    "line",
    [
        pytest.param(c, marks=pytest.mark.slow) if c.startswith(SLOW) or " gif" in c or " --predict" in c else c
        for c in COMMANDS
    ],
    ids=COMMANDS,
)
def test_every_command_runs(line, tmp_path, monkeypatch, capsys, request):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "my-scene.json").write_text(SCENE_FILE, encoding="utf-8")
    (tmp_path / "mine.py").write_text(blocks("python", CHECK_GUIDE)[2], encoding="utf-8")
    mine = (ROOT / "tests" / "own_functions" / "right.js").read_text() + blocks("js", CHECK_GUIDE)[0]
    (tmp_path / "mine.js").write_text(mine, encoding="utf-8")
    # a bench takes as long as all other commands together: test_study.py runs one, here are the rows that are stored
    monkeypatch.setattr(bench, "bench", lambda plan: bench_rows(*BENCH_CHARTS))
    if line.startswith("satviz site"):  # so does a site, which is made once: test_site.py makes one by the command
        files = request.getfixturevalue("still_files")

        def site(*, live, url, pyodide):
            assert not live and bool(url) == ("--url" in line)
            return iter(files.items()), []

        monkeypatch.setattr("satviz.site.build.site", site)
    program, *args = shlex.split(line)
    assert program == "satviz" and main(args) == 0
    assert capsys.readouterr().out


def test_every_command_has_a_row_in_the_guide(capsys):
    with pytest.raises(SystemExit):
        main(["--help"])
    commands = set(re.findall(r"^    (\w+)(?: |$)", capsys.readouterr().out, re.MULTILINE))
    rows = re.findall(r"^\| `satviz (\w+)", DOCUMENTS["satviz/guides/command-line.md"], re.MULTILINE)
    assert set(rows) == commands and "trace" in commands


@pytest.mark.parametrize("name", DOCUMENTS)
def test_every_link_and_picture_of_a_document_is_there(name):
    folder, text = (ROOT / name).parent, DOCUMENTS[name]
    for target in re.findall(r'(?:src|srcset)="([^"]+)"', text) + re.findall(r"\]\(([^)#]+)(?:#[^)]*)?\)", text):
        assert target.startswith("https://example.org/") or (folder / target).is_file(), target


def test_the_readme_and_the_index_list_every_guide():
    names = {path.name for path in GUIDES.glob("*.md")} - {"README.md"}
    assert set(re.findall(r"\]\(satviz/guides/([\w-]+\.md)\)", README)) == names
    assert (
        set(re.findall(r"^- \[[^\]]*\]\(([\w-]+\.md)\)", DOCUMENTS["satviz/guides/README.md"], re.MULTILINE)) == names
    )


FUNCTIONS = sorted({*re.findall(r"^\| `sv\.(\w+)\(", NOTEBOOK_GUIDE, re.MULTILINE), "page"})


@pytest.mark.parametrize("name", FUNCTIONS)
def test_the_functions_in_the_table_of_the_notebook_guide_take_the_arguments_named_below_it(name):
    """They take a name, a Scene, two shapes and (except explore) a trace; anything else is refused."""
    pytest.importorskip("anywidget")
    assert "All of these take a built-in scene's name, a `Scene`, two shapes, or a trace. Only `sv.explore`" in (
        NOTEBOOK_GUIDE
    )
    function, scene = getattr(sv, name), sv.scene("circles")
    trace = scene.record()
    for what in ("circles",), (scene,), (scene.a, scene.b):
        assert function(*what)
    if name != "explore":
        assert function(trace)
    for what in (scene.a,), (trace, scene.b), ("circles", scene.b), (scene, scene.b), (5,), (None,):
        with pytest.raises(TypeError, match=r"pass a scene's name, a Scene, |make it a satviz\.Polygon"):
            function(*what)


@pytest.mark.parametrize("name", ["draw", "picture", "steps"])
def test_functions_with_a_step_take_a_run_and_the_error_for_two_shapes_says_so(name):
    function, scene = getattr(sv, name), sv.scene("circles")
    for what in "circles", scene, scene.record():
        assert function(what)
    with pytest.raises(TypeError, match=r"a scene's name, a Scene, or the trace of two shapes, sv\.record\(a, b\)$"):
        function(scene.a)
