"""The README's code, commands and scene file do what it says."""

import contextlib
import io
import json
import re
import shlex
from pathlib import Path

import pytest

import satviz as sv
from satviz.cli import main
from satviz.pictures.theme import TEXT_PT as TEXT_SIZE
from satviz.study import bench
from satviz.study.bench import plan_bench

ROOT = Path(__file__).parent.parent
TEXT = (ROOT / "README.md").read_text(encoding="utf-8")


def blocks(language):
    return re.findall(rf"^```{language}\n(.*?)^```$", TEXT, re.MULTILINE | re.DOTALL)


def test_the_first_picture_keeps_its_text_at_10_points():
    name, width = re.search(r'<img src="(\S+)" width="(\d+)"', TEXT).groups()
    points = float(re.search(r'width="([\d.]+)pt"', (ROOT / name).read_text(encoding="utf-8"))[1])
    assert TEXT_SIZE * (int(width) * 72 / 96) / points >= 10


def test_the_code_prints_what_stands_below_it(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    first, *_ = blocks("python")
    assert len([line for line in first.splitlines() if line]) <= 8
    for code, output in zip(blocks("python"), blocks("text"), strict=True):
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            exec(compile(code, "README.md", "exec"), {})
        assert out.getvalue() == output
    assert (tmp_path / "verdict.png").stat().st_size > 1000


def test_the_scene_file_loads():
    (data,) = blocks("json")
    scene = sv.Scene.from_json(data)
    assert scene.name == "kite-and-coin" and json.loads(scene.to_json()) == json.loads(data)


COMMANDS = [line for block in blocks("sh") for line in block.splitlines() if "pip" not in line]
LONG = "satviz study", "satviz bench", "satviz site", "satviz advise", "satviz figures --"


@pytest.mark.parametrize(
    "line", [pytest.param(c, marks=pytest.mark.slow) if c.startswith(LONG) else c for c in COMMANDS], ids=COMMANDS
)
def test_every_command_runs(line, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "my-scene.json").write_text(blocks("json")[0], encoding="utf-8")
    # at its own size, a quick bench would take as long as all other commands together: with a tenth of the pairs
    monkeypatch.setattr(bench, "plan_bench", lambda pairs, rounds, seed: plan_bench(pairs // 10, 1, seed))
    program, *args = shlex.split(line)
    assert program == "satviz" and main(args) == 0
    assert capsys.readouterr().out


def test_pictures_shown_are_there():
    for name in re.findall(r'(?:src|srcset)="([^"]+)"', TEXT):
        assert (ROOT / name).is_file(), name


TAKEN = sorted({*re.findall(r"^\| `sv\.(\w+)\(", TEXT, re.MULTILINE), "page"})


@pytest.mark.parametrize("name", TAKEN)
def test_what_the_notebooks_table_names_takes_what_is_said_below_it(name):
    """A name, a Scene, two shapes and (but explore) a trace; and nothing in silence."""
    pytest.importorskip("anywidget")
    assert "All of these take a built-in scene's name, a `Scene`, two shapes, or (but `explore`" in TEXT
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
def test_what_takes_a_step_takes_a_run_and_says_so_of_two_shapes(name):
    function, scene = getattr(sv, name), sv.scene("circles")
    for what in "circles", scene, scene.record():
        assert function(what)
    with pytest.raises(TypeError, match=r"a scene's name, a Scene, or the trace of two shapes, sv\.record\(a, b\)$"):
        function(scene.a)
