"""`satviz check`: functions of a file, and programs in other languages."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from processes import ends

from satviz.checking.checker import check_asker
from satviz.checking.options import Options
from satviz.checking.programs import Program
from satviz.cli import main
from satviz.scenes.minimal_test import scenes_json

OWN = Path(__file__).parent / "own_functions"
SAT = "def collide(a, b):\n    return True\n"
ANSWERS = "import json, sys\nfor line in sys.stdin:\n    a, b = json.loads(line).values()\n    {}\n"


def written(folder, text, name="mine.py"):
    (folder / name).write_text(text)
    return str(folder / name)


def program(folder, body, **more):
    file = written(folder, ANSWERS.format(body), "program.py")
    return check_asker(Program(f"{sys.executable} {file}", more.pop("seconds", 5)), Options(whole_numbers=True, **more))


def test_a_wrong_function_of_a_file_is_reported_with_exit_code_1(tmp_path, capsys):
    assert main(["check", written(tmp_path, SAT), "--whole-numbers"]) == 1
    said = capsys.readouterr().out
    assert said.startswith("Wrong. Your function says hit. The right answer: apart.") and "sv.Polygon([" in said


def test_a_function_is_named_and_a_right_one_gives_exit_code_0(tmp_path, capsys):
    file = written(tmp_path, "from fractions import Fraction\n" + (OWN / "wrong.py").read_text())
    assert main(["check", f"{file}:touching_is_apart", "--touching", "miss", "--seed", "3"]) == 0
    assert capsys.readouterr().out.startswith("Right on all")


def test_the_report_is_printed_as_json_and_the_counterexample_written_as_files(tmp_path, capsys):
    file = f"{OWN / 'wrong.py'}:bounding_boxes"
    assert main(["check", file, "--json", "--out", str(tmp_path / "out"), "--whole-numbers"]) == 1
    text = capsys.readouterr().out
    data = json.loads(text[: text.rindex("}") + 1])
    assert data["finding"] == "wrong" and data["behaves_like"][0]["claim"] and data["scene"]
    assert {path.name for path in (tmp_path / "out").iterdir()} == {"counterexample.svg", "counterexample.png"}


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("def f(a, b) return", "is not Python"),
        ("x = 1", "has no function of two shapes"),
        ("def f(a, b): pass\ndef g(a, b): pass", "has 2 functions of two arguments: name one"),
        (None, "cannot read"),
    ],
)
def test_a_file_without_a_function_is_refused_in_one_line(tmp_path, capsys, text, line):
    file = str(tmp_path / "none.py") if text is None else written(tmp_path, text)
    assert main(["check", file]) == 2
    said = capsys.readouterr().err
    assert line in said and said.count("\n") == 1


@pytest.mark.parametrize(
    "options", [[], ["x.py", "--command", "y"], ["--symptom", "xyzzy"], ["x.py", "--tolerance", "-1"]]
)
def test_options_that_do_not_fit_are_refused(options, capsys):
    assert main(["check", *options]) == 2
    assert capsys.readouterr().err.count("\n") == 1


def test_symptoms_lead_to_mistakes(capsys):
    assert main(["check", "--symptom", "falls through"]) == 0
    assert "far-centers" in capsys.readouterr().out


def test_a_file_that_never_ends_or_prints_does_no_harm(tmp_path, capsys):
    file = written(tmp_path, "print('hello')\ndef f(a, b):\n    print('hello')\n    while b: pass\n")
    assert main(["check", file, "--call-seconds", "-9.8"]) == 1
    said = capsys.readouterr().out
    assert "an endless loop?" in said and "hello" not in said


def test_a_program_answers_line_by_line(tmp_path):
    wrong = program(tmp_path, "print('true', flush=True)")
    assert wrong.finding == "wrong" and wrong.counterexample


@pytest.mark.parametrize(
    ("body", "line"),
    [
        ("print('yes', flush=True)", "answers with 'yes': expected one line of JSON"),
        ("print('[' * 4000 + ']' * 4000, flush=True)", "answers with '[[[["),
        ("print('9' * 9000, flush=True)", "answers with '9999"),
        ("print('1e999', flush=True)", "returns inf: expected True or False"),
        ("sys.exit('no memory')", "ends with exit code 1 before it answers: no memory"),
        (
            "import time; time.sleep(9)",
            "gives no answer within 0.2 s: an endless loop, or an answer that is not flushed?",
        ),
    ],
)
def test_a_fault_of_a_program_is_reported_in_one_line(tmp_path, body, line, monkeypatch):
    monkeypatch.setattr("satviz.checking.programs.START_SECONDS", 0.0 if "endless" in line else 10.0)
    found = program(tmp_path, body, seconds=0.2)
    assert found.line.startswith(line), found.line


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "killpg"), reason="no groups of processes")
def test_a_program_that_is_started_by_another_one_ends_with_it(tmp_path, monkeypatch):
    monkeypatch.setattr("satviz.checking.programs.START_SECONDS", 0.0)
    pid = tmp_path / "pid"
    inner = written(tmp_path, f"echo $$ > {pid}; while :; do :; done", "mine.sh")
    found = check_asker(Program(f"sh -c 'sh {inner}; true'", 2), Options())
    assert found.finding == "no answer" and ends(int(pid.read_text()))


def test_nothing_but_the_report_is_printed(tmp_path, capfd):
    """This holds also if the function writes past sys.stdout."""
    writes = "os.write(1, b'x'); os.write(2, b'x'); sys.__stdout__.write('x')"
    text = f"import os, sys\ndef f(a, b):\n    {writes}\n    return 1\n"
    assert main(["check", written(tmp_path, text), "--json"]) == 1
    said, error = capfd.readouterr()
    assert json.loads(said)["finding"] == "wrong" and error == ""


def test_a_missing_program_is_reported():
    found = check_asker(Program("there-is-no-such-program x", 1), Options())
    assert found.line == "cannot be started: there is no program 'there-is-no-such-program'"


def needs(tool):
    if shutil.which(tool) is None:
        pytest.skip(f"no {tool} is installed")


def caught(command, mistake, **more):
    found = check_asker(Program(command, 5), Options(**more))
    assert found.finding == "wrong" and found.behaves_like[0].name == mistake, str(found)
    scene = found.counterexample
    assert sum(len(shape.vertices) for shape in (scene.a, scene.b)) <= 8
    assert all(x == int(x) for s in (scene.a, scene.b) for p in s.core for x in p)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "more"),
    [
        ("slipped_normal", {}),
        ("range_inside", {}),
        ("unit_normals", {}),
        ("circles_turned_round", {"kinds": "circles"}),
        ("dart", {"kinds": ("convex", "concave")}),
    ],
)
def test_a_wrong_function_in_javascript_is_caught_and_named(tmp_path, name, more):
    needs("node")
    both = (OWN / f"{name}.js").read_text() + (OWN / "harness.js").read_text()
    caught(f"node {written(tmp_path, both, 'mine.js')}", name.replace("_", "-"), **more)


@pytest.mark.slow
@pytest.mark.parametrize(("name", "more"), [("lengths", {}), ("repeated_vertex", {"kinds": ("convex", "repeated")})])
def test_a_wrong_function_in_cpp_is_caught_and_named(tmp_path, name, more):
    needs("g++")
    subprocess.run(["g++", "-std=c++17", "-o", tmp_path / "mine", OWN / f"{name}.cpp"], check=True, timeout=120)
    caught(str(tmp_path / "mine"), name.replace("_", "-"), **more)


@pytest.mark.slow
def test_a_right_function_in_rust_passes(tmp_path):
    needs("rustc")
    subprocess.run(["rustc", "-o", tmp_path / "mine", OWN / "correct.rs"], check=True, timeout=120)
    found = check_asker(Program(str(tmp_path / "mine"), 5), Options())
    assert found.right and found.near.asked, str(found)


COLLIDES = {  # circles rightly, everything else by bounding boxes, in three languages
    "JavaScript": """const points = (shape) => (shape.circle ? [shape.circle] : shape);
const collide = (a, b) => {
  const r = (a.radius ?? 0) + (b.radius ?? 0);
  if (a.radius && b.radius) return (a.circle[0] - b.circle[0]) ** 2 + (a.circle[1] - b.circle[1]) ** 2 <= r * r;
  return [0, 1].every((k) => {
    const [s, t] = [a, b].map((shape) => points(shape).map((p) => p[k]));
    return Math.max(...s) + r >= Math.min(...t) && Math.max(...t) + r >= Math.min(...s);
  });
};
""",
    "C++": """#include <algorithm>
bool collide(const Shape &a, const Shape &b) {
  double r = a.radius + b.radius;
  if (a.radius && b.radius) {
    double x = a.points[0].x - b.points[0].x, y = a.points[0].y - b.points[0].y;
    return x * x + y * y <= r * r;
  }
  for (auto k : {&Point::x, &Point::y}) {
    auto less = [k](const Point &p, const Point &q) { return p.*k < q.*k; };
    auto s = std::minmax_element(a.points.begin(), a.points.end(), less);
    auto t = std::minmax_element(b.points.begin(), b.points.end(), less);
    if (*s.second.*k + r < *t.first.*k || *t.second.*k + r < *s.first.*k) return false;
  }
  return true;
}
""",
    "Rust": """fn collide(a: &Shape, b: &Shape) -> bool {
    let r = a.radius + b.radius;
    if a.radius > 0.0 && b.radius > 0.0 {
        let (x, y) = (a.points[0].0 - b.points[0].0, a.points[0].1 - b.points[0].1);
        return x * x + y * y <= r * r;
    }
    [|p: &(f64, f64)| p.0, |p: &(f64, f64)| p.1].iter().all(|k| {
        let range = |s: &Shape| {
            let on: Vec<f64> = s.points.iter().map(k).collect();
            (on.iter().copied().fold(f64::MAX, f64::min), on.iter().copied().fold(f64::MIN, f64::max))
        };
        let (s, t) = (range(a), range(b));
        s.1 + r >= t.0 && t.1 + r >= s.0
    })
}
""",
}


@pytest.mark.slow
@pytest.mark.parametrize("language", COLLIDES)
def test_the_smallest_harness_of_a_language_works(language, tmp_path, monkeypatch, capsys):
    """It is that of `satviz scenes --json` and the guide, followed by a function, and run with its own commands."""
    harness = next(each for each in json.loads(scenes_json())["harnesses"] if each["language"] == language)
    tool = (harness["build"] or harness["run"]).split()[0]
    needs(tool)
    written(tmp_path, harness["code"] + "\n" + COLLIDES[language], harness["file"])
    monkeypatch.chdir(tmp_path)
    if harness["build"]:
        subprocess.run(harness["build"].split(), check=True, timeout=120)
    assert main(["check", "--command", harness["run"], "--json"]) == 1
    found = json.loads(capsys.readouterr().out)
    assert found["behaves_like"][0]["name"] == "aabb-not-upright" and found["pairs"] > 300
    assert main(["check", "--command", harness["run"], "--kinds", "circles"]) == 0
    assert capsys.readouterr().out.startswith("Right on all")
    assert main(["check", "--command", harness["run"], "--kinds", "circle and polygon", "--json"]) == 1
    found = json.loads(capsys.readouterr().out)
    assert "Circle(" in found["text"] and found["behaves_like"][0]["name"] == "aabb-not-upright"


def test_the_harnesses_of_the_guide_are_those_of_the_scenes(capsys):
    assert main(["scenes", "--json"]) == 0
    printed = json.loads(capsys.readouterr().out)["harnesses"]
    guide = (Path(__file__).parent.parent / "satviz" / "guides" / "check.md").read_text(encoding="utf-8")
    assert [each["language"] for each in printed] == list(COLLIDES)
    assert all(f"\n{each['code']}```\n" in guide for each in printed)
