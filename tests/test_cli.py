"""The command line, run as a user runs it."""

import errno
import json
import os
import re
import signal
import subprocess
import sys
import time
from collections import Counter
from contextlib import suppress
from importlib import import_module
from pathlib import Path
from types import SimpleNamespace

import pytest
from speeds import one_in

import satviz as sv
from satviz.cli import DRAW_FORMATS, main
from satviz.engine import text_table
from satviz.pictures.figures import FIGURES
from satviz.scenes.article import SCENES
from satviz.scenes.scenefile import load
from satviz.study.harness.cells import Cell

GOOD = {"satviz": "scene 1", "a": {"polygon": [[0, 0], [4, 0], [0, 4]]}, "b": {"circle": [5, 5], "radius": 1}}


def run(*args, **more):
    return subprocess.run([sys.executable, "-m", "satviz", *args], capture_output=True, text=True, **more)


def scene_file(tmp_path, data=GOOD, name="scene.json"):
    path = tmp_path / name
    path.write_text(data if isinstance(data, str) else json.dumps(data), encoding="utf-8")
    return str(path)


@pytest.mark.slow
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
    assert main(["draw", scene_file(tmp_path), "--out", str(out), "--format", "svg", "--format", "html"]) == 0
    count = len(sv.steps(sv.Scene.from_json(json.dumps(GOOD)).record()))
    names = sorted(p.name for p in out.iterdir())
    assert names == sorted(["scene.html", *(f"scene-{i:0{len(str(count - 1))}}.svg" for i in range(count))])


@pytest.mark.parametrize(
    ("file", "name"), [("My Desk_2.json", "my-desk-2"), ("été.json", "t"), ("-.json", "scene"), ("a" * 70, "a" * 60)]
)
def test_a_scene_without_a_name_has_that_of_its_file(file, name, tmp_path):
    (tmp_path / file).write_text(json.dumps(GOOD | {"name": "given"}))
    assert load(tmp_path / file).name == "given"
    (tmp_path / file).write_text(json.dumps({key: GOOD[key] for key in GOOD if key != "name"}))
    assert load(tmp_path / file).name == name


def test_draw_writes_one_step_or_some(tmp_path, capsys):
    assert main(["draw", "triangles", "--step", "5", "--out", str(tmp_path / "one")]) == 0
    assert [path.name for path in (tmp_path / "one").iterdir()] == ["triangles-05.svg"]
    made = ["draw", "triangles", "--step", "3-5", "--format", "svg", "--format", "gif", "--speed", "2"]
    assert main([*made, "--out", str(tmp_path / "some")]) == 0
    names = ["triangles-03.svg", "triangles-04.svg", "triangles-05.svg", "triangles.gif"]
    assert sorted(path.name for path in (tmp_path / "some").iterdir()) == names
    # one alone is cut to what it shows, several have one frame
    heights = [
        float(re.search(r'<svg [^>]*height="([\d.]+)pt"', (tmp_path / folder / names[2]).read_text())[1])
        for folder in ("one", "some")
    ]
    assert heights == [sv.picture("triangles", 5, by_itself=alone).size[1] for alone in (True, False)]
    assert heights[0] != heights[1]
    assert main(["draw", "triangles", "--step", "14-last", "--out", str(tmp_path / "end")]) == 0
    assert sorted(path.name for path in (tmp_path / "end").iterdir()) == ["triangles-14.svg", "triangles-15.svg"]


def test_predict_reaches_a_page_a_link_and_a_frame(tmp_path, capsys):
    made = ["draw", "far-centers", "--predict", "--format", "html", "--out", str(tmp_path), "--format", "link"]
    assert main([*made, "--format", "embed", "--site", "https://example.org/s", "--theme", "dark"]) == 0
    page, captured = (tmp_path / "far-centers.html").read_text(), capsys.readouterr().out
    assert page == sv.page("far-centers", predict=True, title=sv.scene("far-centers").title)
    link, *frame = captured.splitlines()[:-1]
    assert link == sv.link("far-centers", site="https://example.org/s", predict=True)
    assert (
        "\n".join(frame) == sv.embed("far-centers", site="https://example.org/s", predict=True, theme="dark").rstrip()
    )


def test_a_link_can_be_given_instead_of_a_scene(tmp_path, capsys):
    """A scene that was dragged in the explorer has no name and no file, only its address."""
    mine = sv.Scene("mine", sv.Polygon([(0, 0), (4, 0), (0, 3)]), sv.Circle((5, 3), 1))
    for scene in mine, sv.scene("triangles"):
        assert main(["trace", sv.link(scene, site="https://example.org/s", free=30.0)]) == 0
        assert capsys.readouterr().out.rstrip() == str(scene.record())
    assert main(["trace", "https://example.org/s/scene.html#nosuch"]) == 2
    assert "no scene is called 'nosuch'" in capsys.readouterr().err
    assert main(["handout", sv.link(mine, site="https://example.org/s"), "--out", str(tmp_path)]) == 0
    assert (tmp_path / "handout-mine.html").read_text() == sv.handout(mine)


@pytest.mark.parametrize("text", ["3-", "-", "-3", "last-3"])
def test_half_a_range_of_steps_is_refused_as_it_is_written(text, capsys):
    with pytest.raises(SystemExit) as stop:
        main(["draw", "triangles", f"--step={text}"])
    assert stop.value.code == 2 and f"argument --step: {text!r} is not a step" in capsys.readouterr().err


def test_a_caption_says_the_sentence_under_the_picture(tmp_path):
    assert main(["draw", "aabb", "--caption", "--out", str(tmp_path)]) == 0
    svg = (tmp_path / f"aabb-{len(sv.steps(sv.scene('aabb').record())) - 1}.svg").read_text()
    assert svg.count("A and B are apart: axis 2 (the x axis)") == 2  # the description and the caption


def test_scenes_lists_the_built_in_scenes(capsys):
    assert main(["scenes"]) == 0
    assert [line.split()[0] for line in capsys.readouterr().out.splitlines()] == [s.name for s in SCENES]


def test_the_version_is_printed(capsys):
    with pytest.raises(SystemExit) as stop:
        main(["--version"])
    assert stop.value.code == 0 and capsys.readouterr().out == f"satviz {sv.__version__}\n"


NESTED = '{"satviz": "scene 1", "a": ' + "[" * 100_000
BAD = {
    "no json": ("{", "this is not JSON"),
    "unknown key": ({**GOOD, "colour": 1}, '"colour"'),
    "missing key": ({"satviz": "scene 1", "a": GOOD["a"]}, 'lacks "b"'),
    "no format": ({"a": GOOD["a"], "b": GOOD["a"]}, 'write "satviz": "scene 1" into it'),
    "key twice": ('{"satviz": "scene 1", "a": 1, "a": 2}', 'key "a" is given twice'),
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
    "no shape": ({**GOOD, "b": 7}, "b must be a JSON object"),
    "too many vertices": ({**GOOD, "a": {"polygon": [[i, i * i] for i in range(1001)]}}, "give at most 1000"),
    "too long": (" " * 1_100_000, "limit is 1,048,576"),
    "axes": ({**GOOD, "axes": "all"}, "unknown axes 'all'"),
    "name": ({**GOOD, "name": "../../etc/passwd"}, "the name '../../etc/passwd'"),
    "title": ({**GOOD, "title": "two\nlines"}, "title"),
    "label": ({**GOOD, "a": {**GOOD["a"], "labels": ["x", "y", 3]}}, "label 2 is 3"),
    "list": ([], "the scene must be a JSON object"),
}


@pytest.mark.parametrize("what", BAD)
def test_a_bad_scene_file_gives_one_clear_line_and_exit_code_2(what, tmp_path, capsys):
    data, words = BAD[what]
    assert main(["trace", scene_file(tmp_path, data)]) == 2
    out, err = capsys.readouterr()
    assert out == "" and err.startswith("satviz: ") and err.count("\n") == 1 and words in err, err


def test_other_bad_input_gives_one_clear_line_too(tmp_path, capsys):
    for args, words in (
        (["trace", "nosuch"], "there is no scene and no file 'nosuch': choose one of aabb"),
        (["trace", "triangle"], "there is no scene and no file 'triangle': did you mean triangles?\n"),
        (["trace", "nosuch.json"], "cannot read nosuch.json"),
        (["trace", str(tmp_path)], "cannot read"),
        (["figures", "--only", "nosuch"], "there is no figure 'nosuch': choose one of aabb-apart, aabb-project-y, "),
    ):
        assert main(args) == 2
        err = capsys.readouterr().err
        assert words in err and err.count("\n") == 1
    binary = tmp_path / "binary.json"
    binary.write_bytes(b"\xff\xfe\x00")
    assert main(["trace", str(binary)]) == 2 and "UTF-8" in capsys.readouterr().err


def test_an_unknown_option_shows_usage_and_no_traceback():
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


SHIPPED = sorted(p.name for p in (Path(__file__).parent.parent / "notebooks").glob("*.ipynb"))


def test_notebooks_are_copied_and_changed_ones_left_alone(tmp_path, capsys):
    args = ["notebook", "--no-open", str(tmp_path / "new" / "nb")]
    assert main(args) == 0 and capsys.readouterr() == (f"{len(SHIPPED)} notebooks in {args[2]}\n", "")
    out = tmp_path / "new" / "nb"
    assert sorted(p.name for p in out.iterdir()) == SHIPPED
    whole = (out / SHIPPED[0]).read_bytes()
    (out / SHIPPED[0]).write_text("my own")
    assert main(args) == 0 and "was changed and is left alone" in capsys.readouterr().err
    assert (out / SHIPPED[0]).read_text() == "my own"
    assert main([*args, "--force"]) == 0 and (out / SHIPPED[0]).read_bytes() == whole


@pytest.mark.parametrize("name", SHIPPED)
def test_a_copied_notebook_has_every_cell_and_no_answer(name, tmp_path):
    assert main(["notebook", "--no-open", str(tmp_path)]) == 0
    ours = json.loads((Path(__file__).parent.parent / "notebooks" / name).read_text(encoding="utf-8"))
    copy = json.loads((tmp_path / name).read_text(encoding="utf-8"))
    assert any(cell.get("outputs") for cell in ours["cells"])
    for cell in ours["cells"]:
        if cell["cell_type"] == "code":
            cell["outputs"], cell["execution_count"] = [], None
    assert copy == ours


def test_a_full_disk_leaves_no_half_notebook(tmp_path, capsys, monkeypatch):
    def full(*_):
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr("os.replace", full)
    assert main(["notebook", "--no-open", str(tmp_path)]) == 2
    assert capsys.readouterr().err == f"satviz: {tmp_path / SHIPPED[0]}: No space left on device\n"
    assert list(tmp_path.iterdir()) == []


def test_notebooks_are_not_written_through_links(tmp_path, capsys):
    out, mine = tmp_path / "nb", tmp_path / "mine"
    out.mkdir()
    mine.write_text("mine")
    (out / SHIPPED[0]).symlink_to(mine)
    (out / SHIPPED[1]).symlink_to(tmp_path / "nowhere")
    assert main(["notebook", "--no-open", str(out)]) == 0 and capsys.readouterr().err.count("left alone") == 2
    assert main(["notebook", "--no-open", "--force", str(out)]) == 0
    assert mine.read_text() == "mine" and not (tmp_path / "nowhere").exists()
    assert not any(p.is_symlink() for p in out.iterdir())


def test_copying_notebooks_loads_no_matplotlib(tmp_path):
    code = f"import sys; from satviz.cli import main; main(['notebook', '--no-open', {str(tmp_path)!r}])\n"
    done = subprocess.run([sys.executable, "-c", code + "print('matplotlib' in sys.modules)"], capture_output=True)
    assert done.stdout.endswith(b"False\n")


@pytest.mark.parametrize("closed", ["<&-", ">&-", "2>&-", "<&- >&- 2>&-"])
@pytest.mark.parametrize(
    ("args", "code"), [("figures --only 1 --out {}", 0), ("trace aabb", 0), ("trace nosuch", 2), ("trace --nosuch", 2)]
)
@pytest.mark.slow
def test_closed_streams_are_no_reason_to_fail(tmp_path, args, code, closed):
    line = f"exec {sys.executable} -m satviz {args.format(tmp_path)} {closed}"
    done = subprocess.run(["sh", "-c", line], capture_output=True, text=True)
    assert done.returncode == code and "Traceback" not in done.stderr and done.stderr.count("\n") <= 1
    for path in tmp_path.iterdir():  # no line of ours got into the first file that was opened
        assert path.read_text().startswith("<?xml") and "satviz:" not in path.read_text()


FULL = Path("/dev/full")


@pytest.mark.skipif(not FULL.exists(), reason="only Linux has it")
@pytest.mark.parametrize("args", ["trace aabb", "trace aabb --json", "scenes", "--help", "--version", "draw --help"])
def test_output_that_cannot_be_written_gives_a_one_line_error(args):
    with FULL.open("w") as full:
        command = [sys.executable, "-m", "satviz", *args.split()]
        done = subprocess.run(command, stdout=full, stderr=subprocess.PIPE, text=True)
    assert (done.returncode, done.stderr) == (2, "satviz: standard output: No space left on device\n")


@pytest.mark.skipif(not FULL.exists(), reason="only Linux has it")
def test_messages_that_cannot_be_written_change_nothing(tmp_path):
    with FULL.open("w") as full:
        command = [sys.executable, "-m", "satviz", "trace", "nosuch"]
        assert subprocess.run(command, stdout=subprocess.PIPE, stderr=full).returncode == 2


@pytest.mark.parametrize(
    "args",
    [
        ["bench", "--seed", "-1"],
        ["bench", "--seed", "x"],
        ["bench", "--pairs", "9" * 20],
        ["bench", "--pairs", "9" * 5000],
        ["bench", "--pairs", "0"],
        ["bench", "--pairs", ""],
        ["bench", "--rounds", "1e3"],
        ["study", "--seed", "-1"],
        ["study", "--seed", "9" * 5000],
    ],
    ids=lambda args: " ".join(args)[:30],
)
def test_a_number_out_of_range_is_refused_in_one_line(args, capsys):
    with pytest.raises(SystemExit) as stop:
        main(args)
    out, err = capsys.readouterr()
    assert stop.value.code == 2 and not out and len(err) < 200 and err.count("\n") == 1
    assert f"argument {args[1]}" in err and "is not a whole number from" in err


def test_too_little_memory_gives_a_one_line_error(capsys, monkeypatch):
    def none(*_):
        raise MemoryError

    monkeypatch.setattr("satviz.study.bench.bench", none)
    assert (
        main(["bench"]) == 1 and capsys.readouterr().err == "satviz: not enough memory: give fewer or smaller inputs\n"
    )


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no named pipes there")
def test_a_path_that_is_no_regular_file_is_refused(tmp_path, capsys):
    os.mkfifo(tmp_path / "fifo")
    (tmp_path / "link").symlink_to(tmp_path / "fifo")
    for path in (tmp_path / "fifo", tmp_path / "link", tmp_path, Path("/dev/zero"), Path("/dev/null")):
        for command in ("trace", "draw"):
            assert main([command, str(path)]) == 2
            assert (
                capsys.readouterr().err
                == f"satviz: cannot read {path}: it is not a regular file; give the path of one\n"
            )


ESCAPES = "a\x1b[31m\x07\r\x9b\u202e\nb"


def test_no_name_can_control_the_terminal(tmp_path, capsys):
    held = tmp_path / f"{ESCAPES}.json"
    held.write_text("{")
    out = tmp_path / ESCAPES
    out.mkdir()
    (out / "01-aabb-apart.svg").write_text("mine")
    for args in (
        ["trace", str(held)],
        ["trace", f"./{ESCAPES}"],
        ["trace", ESCAPES],
        ["trace", "aabb", f"--{ESCAPES}"],
        ["trace", "aabb", "--axes", ESCAPES],
        ["figures", "--only", ESCAPES],
        ["figures", "--only", "1", "--out", str(out)],
        ["figures", "--only", "1", "--out", str(held)],
        ["figures", "--only", "2", "--out", str(out)],
        ["notebook", "--no-open", str(out)],
        ["study", "--out", str(held)],
        ["study", "--executor", ESCAPES],
    ):
        with suppress(SystemExit):
            main(args)
        captured = "".join(capsys.readouterr())
        assert captured.count("\n") == 1 and captured[:-1].isprintable() and "x1b" in captured, args


def test_file_names_that_are_not_utf8_are_printed(tmp_path):
    done = run("trace", os.fsdecode(os.fsencode(tmp_path) + b"/\xff.json"))
    assert done.returncode == 2 and "\\udcff.json: No such file" in done.stderr and done.stderr.count("\n") == 1


@pytest.mark.parametrize("coding", [{"PYTHONIOENCODING": "ascii"}, {"LC_ALL": "C", "PYTHONUTF8": "0"}, {}])
def test_json_stays_json_whatever_the_stream_can_hold(tmp_path, coding):
    labels = ["é", "日\x9b\u2028", "😀"]
    data = {**GOOD, "a": {**GOOD["a"], "labels": labels}}
    env = {key: value for key, value in os.environ.items() if key[:2] != "LC"} | {"PYTHONCOERCECLOCALE": "0"}
    command = [sys.executable, "-m", "satviz", "trace", scene_file(tmp_path, data), "--json"]
    done = subprocess.run(command, capture_output=True, env={**env, "LC_ALL": "C.UTF-8", **coding})
    text = done.stdout.decode("ascii" if coding else "utf-8")
    assert json.loads(text)["a"]["labels"] == labels and ("日" in text) is not bool(coding) and "\x9b" not in text


@pytest.mark.parametrize("args", [["bench", "--chart"], ["study", "--out"], ["draw", "aabb", "--out"]])
def test_a_file_in_the_place_of_the_folder_is_refused_before_the_work(args, capsys, monkeypatch, tmp_path):
    for work in "satviz.study.bench.bench", "satviz.study.run.run_cells", "satviz.render.files.encode_frames":
        monkeypatch.setattr(work, lambda *args, **kwargs: pytest.fail("the work has begun"))
    path = tmp_path / "notes.txt"
    path.write_text("mine")
    assert main([*args, str(path)]) == 2 and path.read_text() == "mine"
    assert capsys.readouterr().err == f"satviz: {path}: not a folder\n"


@pytest.mark.parametrize("args", [["figures"], ["draw", "aabb"], ["study"]])
def test_an_empty_name_of_a_folder_or_scene_is_refused(args, capsys, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(SystemExit) as stop:
        main([*args, "--out", ""])
    assert stop.value.code == 2 and "the folder's name is empty" in capsys.readouterr().err
    with pytest.raises(SystemExit):
        main(["notebook", "--no-open", ""])
    assert main(["trace", ""]) == 2 and "no scene and no file ''" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_a_message_stays_short_whatever_is_named(capsys):
    for name in ("x" * 100_000, "./" + "x" * 100_000):
        assert main(["trace", name]) == 2
        err = capsys.readouterr().err
        assert len(err) < 1500 and err.count("\n") == 1


@pytest.mark.parametrize(
    "error", [ValueError("two\nlines"), RuntimeError("odd"), AssertionError(), RecursionError("x")]
)
def test_an_internal_error_is_one_line_and_development_mode_shows_where(error, capsys, monkeypatch):
    def worked(name):
        raise error

    monkeypatch.setattr("satviz.scenes.resolve.scene", worked)
    assert main(["trace", "aabb"]) == 1
    err = capsys.readouterr().err
    assert err.count("\n") == 1 and type(error).__name__ in err and "-X dev" in err
    monkeypatch.setattr("satviz.cli.sys", SimpleNamespace(flags=SimpleNamespace(dev_mode=True)))
    with pytest.raises(type(error)):
        main(["trace", "aabb"])


@pytest.fixture
def listening():
    """Let this process take interrupts, which a test run in the background ignores."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


class Finalized:
    def __del__(self):
        signal.raise_signal(signal.SIGINT)


def vanishing(work):
    """Do the work with an interrupt inside a callback, where its exception is lost."""

    def worked(*args, **more):
        Finalized()
        return work(*args, **more)

    return worked


@pytest.mark.usefixtures("listening")
@pytest.mark.parametrize(
    ("args", "where"),
    [
        (["figures", "--only", "1", "--only", "2", "--out"], "satviz.render.files.encode_frames"),
        (["draw", "aabb", "--format", "svg", "--format", "html", "--out"], "satviz.render.files.encode_frames"),
        (["study", "--quick", "--out"], "satviz.study.harness.cells._load_result"),
        pytest.param(
            ["bench", "--pairs", "10", "--rounds", "1"], "satviz.study.bench.time_in_turn", marks=pytest.mark.slow
        ),  # compiles the study's kernels
        (["trace", "aabb"], "satviz.scenes.resolve.scene"),
        (["notebook", "--no-open"], "satviz.safe_write.write"),
    ],
    ids=lambda value: value[0] if isinstance(value, list) else "",
)
def test_an_interrupt_whose_exception_was_lost_stops_the_command_all_the_same(
    tmp_path, capsys, monkeypatch, args, where
):
    module, _, name = where.rpartition(".")
    work = getattr(import_module(module), name)
    monkeypatch.setattr(where, vanishing(work))
    monkeypatch.setattr("satviz.study.run.SECTIONS", (SimpleNamespace(cells=two_cells, charts=lambda found: []),))
    before = signal.getsignal(signal.SIGINT)
    assert main([*args, str(tmp_path)] if args[0] in ("figures", "draw", "study", "notebook") else args) == 130
    assert capsys.readouterr().err == "satviz: interrupted; the files named above are complete\n"
    assert len([path for path in tmp_path.rglob("*") if path.is_file()]) <= 1  # no second job was begun
    assert signal.getsignal(signal.SIGINT) is before


def two_cells(settings):
    return [Cell(name, abs, (1,)) for name in ("one", "two")]


@pytest.mark.usefixtures("listening")
def test_an_interrupt_that_was_turned_into_another_error_is_still_an_interrupt(capsys, monkeypatch):
    def worked(name):
        Finalized()
        raise ImportError("initialization failed")

    monkeypatch.setattr("satviz.scenes.resolve.scene", worked)
    assert main(["trace", "aabb"]) == 130 and capsys.readouterr().err.count("\n") == 1


@pytest.mark.usefixtures("listening")
def test_an_earlier_interrupt_does_not_stop_the_next_command(capsys, monkeypatch):
    with monkeypatch.context() as patched:
        patched.setattr("satviz.scenes.resolve.scene", vanishing(sv.scene))
        assert main(["trace", "aabb"]) == 130
    assert main(["trace", "aabb"]) == 0


def test_interrupts_are_left_to_jupyterlab(tmp_path):
    for name in ("jupyterlab", "anywidget"):
        (tmp_path / f"{name}.py").write_text(
            "import os, signal, sys\nos.kill(os.getppid(), signal.SIGINT)\nprint(sys.argv[1:], flush=True)\nsys.exit(5)"
        )
    path = os.pathsep.join(filter(None, (str(tmp_path), os.environ.get("PYTHONPATH"))))
    done = run("notebook", "--", "--version", cwd=tmp_path, env={**os.environ, "PYTHONPATH": path})
    assert done.returncode == 5 and done.stderr == "" and f"['{tmp_path / '--version'}']" in done.stdout


@pytest.mark.skipif(os.name == "nt", reason="signals work differently there")
@pytest.mark.slow
def test_ctrl_c_leaves_no_half_file(tmp_path):
    process = subprocess.Popen(
        [sys.executable, "-m", "satviz", "figures", "--out", str(tmp_path), "--format", "png", "--format", "pdf"],
        stderr=subprocess.PIPE,
        text=True,
        # a job in the background starts with the signal ignored
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )
    while not any(tmp_path.iterdir()) and process.poll() is None:
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
    _, err = process.communicate()
    assert b"Traceback" not in err and b"Exception" not in err


@pytest.mark.parametrize("name", [scene.name for scene in SCENES])
def test_a_narrow_terminal_gets_a_narrow_table_that_says_the_same(name):
    trace = sv.scene(name).record()
    wide = text_table.table(trace)
    assert wide == str(trace) == text_table.table(trace, 10_000)
    heads = {"axis", "direction", "gap", *(name for t in (trace, *trace.pairs) for name in t.names)}
    for width in 40, 61, 80:
        lines = text_table.table(trace, width).splitlines()
        assert max(map(len, lines)) <= width
        said, given = (Counter(w for w in text.split() if w not in heads) for text in (" ".join(lines), wide))
        assert said == given


def test_the_sums_are_of_the_table_and_keep_to_its_width(capsys):
    assert main(["trace", "triangles", "--sums"]) == 0
    assert capsys.readouterr().out == sv.scene("triangles").record().table(sums=True) + "\n"
    assert max(map(len, sv.scene("triangles").record().table(width=40, sums=True).splitlines())) <= 40
    assert main(["trace", "triangles", "--sums", "--json"]) == 2
    assert "leave out --json" in capsys.readouterr().err


def test_the_table_is_as_wide_as_the_terminal(monkeypatch, capsys):
    monkeypatch.setenv("COLUMNS", "40")
    monkeypatch.setattr("sys.stdout.isatty", lambda: True, raising=False)
    assert main(["trace", "triangles"]) == 0
    assert max(map(len, capsys.readouterr().out.splitlines())) <= 40


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


# -- options together

CLASHES = {
    "draw triangles --sheet --format gif": "--sheet makes one picture",
    "draw triangles --sheet --format html": "--sheet makes one picture",
    "draw triangles --sheet --format svg --format html": "--sheet makes one picture",
    "draw triangles --sheet --format link": "--format link prints a line: --sheet is for files",
    "draw triangles --steps --format link": "--format link prints a line: --steps is for files",
    "draw triangles --format link --out somewhere": "--format link prints a line: --out is for files",
    "draw triangles --format link --theme light": "--format link prints a line: --theme is for files",
    "draw triangles --site https://example.org": "give it with --format link or embed",
    "draw triangles --site https://example.org --format svg": "give it with --format link",
    "draw triangles --format embed": "--format embed needs the address of your site",
    "draw triangles --format embed --site https://example.org --sheet": "--format embed prints a frame: --sheet is",
    "draw triangles --predict": "--predict is not for these formats: give it with --format embed or html or link",
    "draw triangles --goal touch --format html": "--goal is not for these formats: give it with --format embed or link",
    "draw triangles --play --format link": "--play is not for these formats: give it with --format embed",
    "draw triangles --show table": "--show is not for these formats: give it with --format embed",
    "draw triangles --format link --goal touch --predict": "a challenge has no steps, and --predict is for steps",
    "draw triangles --format link --goal break": "are not a shortcut",
    "draw triangles --format link --step 3-8": "a link opens one step",
    "draw triangles --format html --step 3": "a page has all steps",
    "draw triangles --step 16": "the run has no step 16: its steps are 0 to 15",
    "draw triangles --step 99 --format link": "the run has no step 99: its steps are 0 to 15",
    "handout 9": "there is no chapter 9: the chapters are 1 to 8",
    "draw no-area --step 0": "no-area has no run",
    "draw no-area --predict --format html": "no-area has no run",
    "draw triangles --theme dark --format html": "a page follows its reader's theme",
    "draw no-area --sheet": "no-area has no run",
    "draw no-area --steps --format gif": "no-area has no run",
    "draw no-area --axes world": "no-area has no run",
    "draw no-area --every-axis --format html": "no-area has no run",
    "advise triangles --force": "give it with --chart",
    "bench --force": "give it with --chart",
    "bench --quick --pairs 100000": "--quick sets the pairs and the rounds: give it without --pairs",
    "bench --rounds 9 --quick": "--quick sets the pairs and the rounds: give it without --rounds",
    "site --still --zip --open": "--open serves a folder, and --zip writes a file",
    "site --still --url example.org": "the address is",
    "site --still --pyodide somewhere": "--still leaves out Python: leave out --pyodide",
}


@pytest.mark.parametrize("line", CLASHES)
def test_options_that_cannot_be_together_get_one_line(line, capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert main(line.split()) == 2
    captured = capsys.readouterr()
    assert CLASHES[line] in captured.err and captured.err.count("\n") == 1 and captured.out == ""
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("scene", ["circles", "no-area"])
@pytest.mark.parametrize("form", one_in(3, DRAW_FORMATS))
def test_no_option_of_draw_is_ignored_silently(form, scene, capsys, tmp_path, monkeypatch):
    """Each option changes the files, or is refused, or has an effect in any case, as the help says."""

    def files(pictures, form, theme, stem, times=()):
        return f"{form} {len(pictures)} {theme.name} {pictures[-1].to_json()} {times}".encode()

    monkeypatch.setattr("satviz.render.files.encode_frames", files)

    def made(*options):
        folder = tmp_path / str(len(list(tmp_path.iterdir())))
        folder.mkdir()
        monkeypatch.chdir(folder)
        code = main(["draw", scene, "--format", form, *options])
        return code, capsys.readouterr().out, {str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob("*.*")}

    site = ["--site", "https://example.org"] if form == "embed" else []
    plain = made(*site)
    in_any_case = {"--steps"} | ({"--caption"} if form in ("gif", "html") or scene == "no-area" else set())
    in_any_case |= {"--every-axis"} if scene == "circles" else set()  # it has one
    for options in (
        ["--caption"],
        ["--sheet"],
        ["--steps"],
        ["--sweep"],
        ["--speed", "2"],
        ["--every-axis"],
        ["--axes", "world"],
        ["--theme", "dark"],
        ["--out", "elsewhere"],
        ["--site", "https://example.org/elsewhere"],
        ["--step", "1"],
        ["--step", "0-1"],
        ["--predict"],
        ["--goal", "touch"],
        ["--play"],
        ["--show", "table"],
    ):
        found = made(*site, *options)
        assert found[0] in (0, 2)
        assert found[0] == 2 or found != plain or options[0] in in_any_case, options
