"""The command line, run as a user runs it."""

import json
import os
import signal
import subprocess
import sys
import time

import pytest

import satviz as sv
from satviz.cli import main
from satviz.pictures.figures import FIGURES
from satviz.scenes import SCENES

GOOD = {"satviz": "scene 1", "a": {"polygon": [[0, 0], [4, 0], [0, 4]]}, "b": {"circle": [5, 5], "radius": 1}}


def run(*args, **more):
    return subprocess.run([sys.executable, "-m", "satviz", *args], capture_output=True, text=True, **more)


def scene_file(tmp_path, data=GOOD, name="scene.json"):
    path = tmp_path / name
    path.write_text(data if isinstance(data, str) else json.dumps(data), encoding="utf-8")
    return str(path)


def test_figures_makes_twenty_files(tmp_path):
    done = run("figures", "--out", str(tmp_path / "new" / "figures"))
    assert done.returncode == 0 and done.stderr == ""  # no bar where stderr is no terminal
    assert {p.name for p in (tmp_path / "new" / "figures").iterdir()} == {f"{f.stem}.svg" for f in FIGURES}


def test_figures_takes_formats_theme_and_names(tmp_path, capsys):
    args = ["figures", "--out", str(tmp_path), "--only", "sat-edge", "--only", "14"]
    assert main([*args, "--format", "png", "--format", "pdf", "--theme", "dark"]) == 0
    names = {"07-sat-edge-dark", "14-sat-ranges-gap-dark"}
    assert {p.name for p in tmp_path.iterdir()} == {f"{n}.{e}" for n in names for e in ("png", "pdf")}
    assert capsys.readouterr().out == f"4 files in {tmp_path}\n"


def test_trace_prints_the_table_or_the_json(tmp_path, capsys):
    assert main(["trace", "triangles"]) == 0
    assert capsys.readouterr().out == f"{sv.scene('triangles').record()}\n"
    assert main(["trace", scene_file(tmp_path), "--json"]) == 0
    trace = sv.Trace.from_json(capsys.readouterr().out)
    assert trace.relation is sv.Relation.APART
    assert main(["trace", "triangles", "--every-axis", "--axes", "world", "--json"]) == 0
    trace = sv.Trace.from_json(capsys.readouterr().out)
    assert trace.every_axis and [t.source.kind for t in trace.tests] == ["world", "world"]


def test_draw_writes_every_step(tmp_path, capsys):
    out = tmp_path / "out"
    assert main(["draw", scene_file(tmp_path), "--out", str(out), "--format", "png", "--format", "gif"]) == 0
    count = len(sv.steps(sv.Scene.from_json(json.dumps(GOOD)).record()))
    names = sorted(p.name for p in out.iterdir())
    assert names == sorted(["scene.gif", *(f"scene-{i:0{len(str(count - 1))}}.png" for i in range(count))])


def test_a_caption_says_the_sentence_under_the_picture(tmp_path):
    assert main(["draw", "aabb", "--caption", "--out", str(tmp_path)]) == 0
    svg = (tmp_path / f"aabb-{len(sv.steps(sv.scene('aabb').record())) - 1}.svg").read_text()
    assert svg.count("A and B are apart: axis 2 (the x axis)") == 2  # the description and the caption


def test_scenes_lists_the_built_in_scenes(capsys):
    assert main(["scenes"]) == 0
    assert [line.split()[0] for line in capsys.readouterr().out.splitlines()] == [s.name for s in SCENES]


def test_version(capsys):
    with pytest.raises(SystemExit) as stop:
        main(["--version"])
    assert stop.value.code == 0 and capsys.readouterr().out == f"satviz {sv.__version__}\n"


NESTED = '{"satviz": "scene 1", "a": ' + "[" * 100_000
BAD = {
    "no json": ("{", "not JSON"),
    "unknown key": ({**GOOD, "colour": 1}, '"colour"'),
    "missing key": ({"satviz": "scene 1", "a": GOOD["a"]}, 'lacks "b"'),
    "key twice": ('{"satviz": "scene 1", "a": 1, "a": 2}', 'key "a" stands twice'),
    "NaN": (json.dumps(GOOD).replace("5, 5", "NaN, 5"), "NaN"),
    "too large": (json.dumps(GOOD).replace("5, 5", "1e400, 5"), "1e400"),
    "endless digits": (json.dumps(GOOD).replace("5, 5", f"{'9' * 100_000}, 5"), "100000 digits"),
    "lossy integer": (json.dumps(GOOD).replace("5, 5", f"{2**53 + 1}, 5"), "float64 cannot hold"),
    "nested": (NESTED, "nested deeper"),
    "wrong format": ({**GOOD, "satviz": "scene 9"}, "scene 1"),
    "crossing": ({**GOOD, "a": {"polygon": [[0, 0], [1, 1], [1, 0], [0, 1]]}}, "a: edges 0 and 2 cross"),
    "radius": ({**GOOD, "b": {"circle": [0, 0], "radius": 0}}, "b: radius is 0"),
    "bool": ({**GOOD, "b": {"circle": [True, 0], "radius": 1}}, "center.x is True"),
    "text": ({**GOOD, "b": {"circle": ["1", 0], "radius": 1}}, "center.x is '1'"),
    "no shape": ({**GOOD, "b": 7}, "b must be an object"),
    "too many vertices": ({**GOOD, "a": {"polygon": [[i, i * i] for i in range(1001)]}}, "the limit is 1000"),
    "too long": (" " * 1_100_000, "limit is 1048576"),
    "axes": ({**GOOD, "axes": "all"}, "unknown axes 'all'"),
    "name": ({**GOOD, "name": "../../etc/passwd"}, "the name '../../etc/passwd'"),
    "title": ({**GOOD, "title": "two\nlines"}, "title"),
    "label": ({**GOOD, "a": {**GOOD["a"], "labels": ["x", "y", 3]}}, "label 2 is 3"),
    "list": ([], "the scene must be an object"),
}


@pytest.mark.parametrize("what", BAD)
def test_a_bad_scene_file_gives_one_clear_line_and_exit_code_2(what, tmp_path, capsys):
    data, words = BAD[what]
    assert main(["trace", scene_file(tmp_path, data)]) == 2
    out, err = capsys.readouterr()
    assert out == "" and err.startswith("satviz: ") and err.count("\n") == 1 and words in err, err


def test_other_bad_input_gives_one_clear_line_too(tmp_path, capsys):
    for args, words in (
        (["trace", "nosuch"], "no scene 'nosuch': choose one of aabb"),
        (["trace", "triangle"], "no scene 'triangle': did you mean triangles?, or give a file"),
        (["trace", "nosuch.json"], "cannot read nosuch.json"),
        (["trace", str(tmp_path)], "cannot read"),
        (["figures", "--only", "nosuch"], "no figure 'nosuch'"),
    ):
        assert main(args) == 2
        err = capsys.readouterr().err
        assert words in err and err.count("\n") == 1
    binary = tmp_path / "binary.json"
    binary.write_bytes(b"\xff\xfe\x00")
    assert main(["trace", str(binary)]) == 2 and "UTF-8" in capsys.readouterr().err


def test_an_option_nobody_knows_shows_usage_and_no_traceback():
    done = run("figures", "--format", "bmp")
    assert done.returncode == 2 and done.stderr.count("\n") == 1 and "Traceback" not in done.stderr


def test_files_of_others_are_not_overwritten_without_force(tmp_path, capsys):
    other = tmp_path / "07-sat-edge.svg"
    other.write_text("mine")
    args = ["figures", "--out", str(tmp_path), "--only", "sat-edge", "--only", "sat-normal"]
    assert main(args) == 2
    assert "was not made by satviz" in capsys.readouterr().err
    assert [p.name for p in tmp_path.iterdir()] == ["07-sat-edge.svg"] and other.read_text() == "mine"
    assert main([*args, "--force"]) == 0 and "made by satviz" in other.read_text()
    assert main(args) == 0  # its own files it may write again


def test_an_output_folder_that_is_a_file_is_refused(tmp_path, capsys):
    (tmp_path / "f").write_text("")
    assert main(["figures", "--only", "1", "--out", str(tmp_path / "f")]) == 2
    assert capsys.readouterr().err.count("\n") == 1


@pytest.mark.skipif(os.name == "nt", reason="signals work differently there")
def test_ctrl_c_leaves_no_half_file(tmp_path):
    process = subprocess.Popen(
        [sys.executable, "-m", "satviz", "figures", "--out", str(tmp_path), "--format", "png", "--format", "pdf"],
        stderr=subprocess.PIPE,
        text=True,
        # a job in the background starts with the signal ignored
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )
    while not list(tmp_path.glob("*.p*")) and process.poll() is None:
        time.sleep(0.01)
    process.send_signal(signal.SIGINT)
    err = process.communicate(timeout=60)[1]
    assert process.returncode == 130 and "interrupted" in err and "Traceback" not in err
    for path in tmp_path.iterdir():
        assert path.suffix in (".png", ".pdf") and not path.name.startswith(".")
        tail = path.read_bytes()[-12:]
        assert b"IEND" in tail if path.suffix == ".png" else b"%%EOF" in tail


def test_a_closed_pipe_is_no_error():
    process = subprocess.Popen(
        [sys.executable, "-m", "satviz", "trace", "circle-polygon", "--json"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    )
    process.stdout.close()
    err = process.stderr.read()
    process.wait()
    assert b"Traceback" not in err and b"Exception" not in err


def test_a_scene_file_survives_its_own_format():
    for scene in SCENES:
        assert sv.Scene.from_json(scene.to_json()) == scene


def test_a_label_the_terminal_cannot_show_is_no_reason_to_fail(tmp_path):
    data = {**GOOD, "a": {**GOOD["a"], "labels": ["日", "é", "c"]}}
    done = run("trace", scene_file(tmp_path, data), env={**os.environ, "PYTHONIOENCODING": "ascii"})
    assert done.returncode == 0 and "\\u65e5" in done.stdout


def test_small_hostile_files_are_refused_at_once(tmp_path, capsys):
    many = "{" + ",".join(f'"{i:x}":1' for i in range(16_000)) + ',"1":1}'
    for data in ('"' + '\\"' * 500_000, many):
        start = time.perf_counter()
        assert main(["trace", scene_file(tmp_path, data)]) == 2
        print(f"{time.perf_counter() - start:.2f} s")
        assert capsys.readouterr().err.count("\n") == 1
