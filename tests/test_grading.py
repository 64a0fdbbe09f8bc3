"""The recipes for nbgrader and otter-grader in the guide, run with the real programs."""

import os
import re
import subprocess
from pathlib import Path

import pytest
from environments import environment

ROOT = Path(__file__).parent.parent
GUIDE = (ROOT / "satviz" / "guides" / "check.md").read_text(encoding="utf-8")
GRADERS = "nbgrader==0.9.6", "otter-grader==7.0.0"
pytestmark = pytest.mark.slow

ONLY_BOXES = """def collide(a, b):
    for axis in 0, 1:
        on_a, on_b = [p[axis] for p in a], [p[axis] for p in b]
        if max(on_a) < min(on_b) or max(on_b) < min(on_a):
            return False
    return True
"""
RIGHT = """def collide(a, b):
    for shape in a, b:
        for (x0, y0), (x1, y1) in zip(shape, shape[1:] + shape[:1]):
            on_a, on_b = ([(y1 - y0) * x - (x1 - x0) * y for x, y in p] for p in (a, b))
            if max(on_a) < min(on_b) or max(on_b) < min(on_a):
                return False
    return True
"""


def recipe(of):
    """Return the first code block of the guide after these words."""
    return re.search(r"^```py(?:thon)?\n(.*?)^```$", GUIDE.partition(f"In **{of}**")[2], re.MULTILINE | re.DOTALL)[1]


@pytest.fixture(scope="module")
def python(tmp_path_factory):
    """Return the Python of an environment with both graders from PyPI; satviz is on its path."""
    return environment(tmp_path_factory.mktemp("graders"), *GRADERS)


def run(python, folder, *arguments):
    """Run a module or a file in a folder; what it prints."""
    home = {"HOME": str(folder), "JUPYTER_PLATFORM_DIRS": "1"}
    path = f"{python.parent}{os.pathsep}{os.environ['PATH']}"
    env = {**os.environ, **home, "PYTHONPATH": str(ROOT), "PATH": path}
    done = subprocess.run([python, *arguments], cwd=folder, env=env, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr[-3000:]
    return done.stdout


COURSE = """
import sys
from pathlib import Path

import nbformat

def cell(name, source, **more):
    made = nbformat.v4.new_code_cell(source, id=name)
    kind = {"grade": False, "locked": False, "solution": False, "task": False}
    made.metadata["nbgrader"] = {"schema_version": 3, "grade_id": name, **kind, **more}
    return made

skeleton = "### BEGIN SOLUTION\\ndef collide(a, b):\\n    return True\\n### END SOLUTION"
grading = Path("recipe.py").read_text()
notebook = nbformat.v4.new_notebook(cells=[
    cell("collide", skeleton, solution=True),
    cell("check-collide", grading, grade=True, locked=True, points=4),
])
notebook.metadata["kernelspec"] = {"name": "python3", "display_name": "Python 3", "language": "python"}
Path("source/ps1").mkdir(parents=True)
nbformat.write(notebook, "source/ps1/sat.ipynb")
"""
SUBMIT = """
import shutil
from pathlib import Path

import nbformat

for student in Path("students").iterdir():
    notebook = nbformat.read("release/ps1/sat.ipynb", 4)
    notebook.cells[0].source = student.read_text()
    folder = Path("submitted", student.stem, "ps1")
    folder.mkdir(parents=True)
    nbformat.write(notebook, folder / "sat.ipynb")
"""
GRADES = """
from nbgrader.api import Gradebook

with Gradebook("sqlite:///gradebook.db") as book:
    for student in book.students:
        print(student.id, book.find_submission("ps1", student.id).score)
"""


def test_nbgrader_gives_partial_credit_by_the_recipe_of_the_guide(python, tmp_path):
    (tmp_path / "students").mkdir()
    (tmp_path / "students" / "half.py").write_text(ONLY_BOXES)
    (tmp_path / "students" / "whole.py").write_text(RIGHT)
    (tmp_path / "recipe.py").write_text(recipe("nbgrader"))
    (tmp_path / "nbgrader_config.py").write_text('c = get_config()\nc.CourseDirectory.course_id = "sat"\n')
    run(python, tmp_path, "-c", COURSE)
    run(python, tmp_path, "-m", "nbgrader", "generate_assignment", "ps1")
    run(python, tmp_path, "-c", SUBMIT)
    run(python, tmp_path, "-m", "nbgrader", "autograde", "ps1")
    assert sorted(run(python, tmp_path, "-c", GRADES).split("\n")) == ["", "half 2.0", "whole 4.0"]


def test_otter_grader_shows_the_counterexample_by_the_recipe_of_the_guide(python, tmp_path):
    (tmp_path / "tests").mkdir()
    (tmp_path / "tests" / "collide.py").write_text(recipe("otter-grader"))
    (tmp_path / "mine.py").write_text(ONLY_BOXES)
    said = run(python, tmp_path, "-m", "otter", "check", "mine.py")
    verdicts = re.findall(r"collide - (\d) result:\s+\S+ Test case (passed|failed)", said)
    assert verdicts == [("1", "passed"), ("2", "failed"), ("3", "passed")], said
    assert "a = sv.Polygon([" in said and "It behaves like aabb-not-upright" in said
