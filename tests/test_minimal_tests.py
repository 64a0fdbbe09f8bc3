"""The minimal tests of each language, run for real where its compiler is here: right answers pass, wrong ones fail."""

import shutil
import subprocess

import pytest

import satviz as sv
from satviz.scenes.minimal_test import minimal_test

pytestmark = pytest.mark.slow

HIT = sv.Circle((0.25, -2), 1.5), sv.Polygon([(1, -2), (4, -2.5), (3, 1e-7)])
APART = sv.Circle((0.25, -2), 0.5), sv.Polygon([(1, -2), (4, -2.5), (3, 1e22)])
TOUCHING = sv.Polygon([(0, 0), (4, 0), (0, 4)]), sv.Polygon([(4, 0), (8, 0), (8, 4)])
CONCAVE = sv.Polygon([(0, 0), (9, 0), (9, 9), (8, 9), (8, 1), (0, 1)]), sv.Polygon([(3, 3), (4, 3), (4, 4)])

# what stands in `collides` until somebody puts a call there, and what a test puts there
CALLS = {
    "javascript": ('throw new Error("call the library under test here")', "return {}"),
    "python": ('raise NotImplementedError("call the library under test here")', "return {}"),
    "cpp": ('throw std::logic_error("call the library under test here")', "return {}"),
    "csharp": ('throw new NotImplementedException("call the library under test here")', "return {}"),
    "rust": ('todo!("call the library under test here")', "{}"),
    "java": ('throw new UnsupportedOperationException("call the library under test here")', "return {}"),
}
TOOLS = {
    "javascript": ("t.js", [["node", "t.js"]]),
    "python": ("t.py", [["python3", "t.py"]]),
    "cpp": ("t.cpp", [["g++", "-Wall", "-Wno-unused-parameter", "-o", "t", "t.cpp"], ["./t"]]),
    "csharp": ("t.cs", [["mcs", "-out:t.exe", "t.cs"], ["mono", "t.exe"]]),
    "rust": ("t.rs", [["rustc", "--edition", "2021", "-o", "t", "t.rs"], ["./t"]]),
    "java": ("MinimalTest.java", [["javac", "MinimalTest.java"], ["java", "-cp", ".", "MinimalTest"]]),
}


def run(language, source, folder):
    """Return the exit code of the test's own run and what it printed."""
    name, commands = TOOLS[language]
    (folder / name).write_text(source, encoding="ascii")
    for command in commands[:-1]:
        built = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=120)
        assert built.returncode == 0, built.stderr
    done = subprocess.run(commands[-1], cwd=folder, capture_output=True, text=True, timeout=60)
    return done.returncode, done.stdout + done.stderr


@pytest.mark.parametrize("language", TOOLS)
@pytest.mark.parametrize("pair", [HIT, APART, TOUCHING, CONCAVE], ids=["hit", "apart", "touching", "concave"])
def test_a_right_answer_passes_and_a_wrong_one_fails(language, pair, tmp_path):
    tool = TOOLS[language][1][0][0]
    if shutil.which(tool) is None:
        pytest.skip(f"no {tool} here")
    source = minimal_test(*pair, language)
    unwritten, call = CALLS[language]
    assert unwritten in source
    hit = sv.relate(*pair) > 0
    words = ("True", "False") if language == "python" else ("true", "false")
    for answer in hit, not hit:
        code, said = run(language, source.replace(unwritten, call.format(words[0] if answer else words[1])), tmp_path)
        assert (code == 0) == (answer == hit), said
        assert ("passed" in said) == (answer == hit)
    if language in ("javascript", "python"):  # until the call is put in, the test fails and says so
        code, said = run(language, source, tmp_path)
        assert code != 0 and "call the library under test here" in said


def test_the_test_in_c_sharp_has_every_number_and_one_place_for_the_call():
    """A compiler of C# is not everywhere, so its text is looked at as well."""
    source = minimal_test(*HIT, "csharp")
    assert source.count(CALLS["csharp"][0]) == 1 and source.count("{") == source.count("}")
    assert "{ {0.25, -2.0} }" in source and "{3.0, 1e-07}" in source and "record" not in source
