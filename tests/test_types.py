"""Tests of the types: checkers accept right programs that use satviz and report errors in wrong ones."""

import json
import os
import re
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

import pytest

import satviz

pytestmark = pytest.mark.slow

HOME = Path(satviz.__file__).parent.parent
ERROR = re.compile(r"^(.+?):(\d+): error: (.*)", re.MULTILINE)
README = Path(__file__).parent.parent / "README.md"
RIGHT = """
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from matplotlib.artist import Artist
from matplotlib.figure import Figure

import satviz as sv
from satviz import batch

a = sv.Polygon([(0, 1), (3, 2), (1, 5)])
b = sv.Polygon(np.array([(5, 5), (8, 3), (4, 1)]), labels=["v1", "v2", "v3"])
coin = sv.Circle((5.5, 3), 1.25)
trace: sv.Trace = sv.record(a, b)
if trace.separating is not None:
    gap: float = trace.separating.gap
    low: float = trace.separating.a.interval.lo
proved: bool = trace.certificate.check()
relation: sv.Relation = sv.relate(a, coin)
move: sv.Vec | None = sv.record(a, coin, axes=sv.axes.world).mtv
shapes: list[sv.Polygon | sv.Circle] = [coin, *sv.parts(b)]
gaps: list[float] = [test.gap for test in sv.axis_tests(a, b)]
again: sv.Trace = sv.Trace.from_json(trace.to_json())
scene: sv.Scene = sv.scene("triangles")
scene_names: list[str] = [scene.name for scene in sv.scenes()]

figure: Figure = sv.draw(trace, step=-1)
artists: dict[str, Artist] = sv.draw(trace, 0, ax=figure.add_subplot(), theme="dark")
step: sv.Step = sv.steps(trace)[0]
picture: sv.Picture = sv.picture(trace, step)
whole: sv.Picture = sv.sheet(trace)
words: str = picture.sentence + sv.page(trace) + sv.gap_curve(a, b).to_json()
only_y = sv.Shortcut("only y", "y is enough", sv.axes.directions((0, 1)))
own: sv.Scene = sv.explore(a, b, axes=only_y, goal="break").scene
frame: str = sv.embed(a, b, site="https://example.org", steps=(3, 8), show=["table"])
title: str = sv.explore("triangles").scene.title + sv.explore(a, b).scene.title
under_the_hand: sv.Scene = sv.explore(scene, goal="touch").scene
stepped: sv.Trace = sv.play(trace, predict=True).trace
plain: sv.Trace = sv.play(a, b, pen="matplotlib").trace

triangles = batch.Polygons(np.ones((5, 3, 2)) + [[0, 0], [1, 0], [0, 1]])
coins: batch.Shapes = batch.Circles([(0, 1), (2, 3)], radii=1.5)
counts = np.bincount(batch.relate(triangles, coins[:1]), minlength=3)
some: bool = bool(batch.hits(triangles[[0, 1]], coins[1], [(0, 0)], engine="numpy").any())
with ThreadPoolExecutor() as pool:
    found: int = len(sv.batch.colliding_pairs(batch.concat([triangles, coins]), executor=pool))
"""
START = """
import satviz as sv

a = sv.Polygon([(0, 1), (3, 2), (1, 5)])
trace = sv.record(a, a)
many = sv.batch.Circles([(0, 1)], 1)
"""
WRONG = (
    "sv.relate(1, 2)",
    "sv.relate(a)",
    "sv.Polygon()",
    "sv.Circle((0, 0))",
    "sv.circle((0, 0), 1)",
    "print(trace.mtvv)",
    "print(trace.mtv.x)",  # None where they are apart
    'sv.draw(trace, step="last")',
    'sv.draw(trace)["mtv"]',
    "sv.draw(trace, ax=sv.draw(trace))",
    "sv.steps(a)",
    "sv.picture(trace).save()",
    "sv.explore(3)",
    "sv.batch.relate(a, many)",
    "sv.batch.hits(many, many, engin='numpy')",
    'many["first"]',
)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Write three programs: a right one, README's, and a wrong one whose last lines are WRONG; return the folder."""
    place = tmp_path_factory.mktemp("programs")
    (place / "right.py").write_text(RIGHT)
    (place / "wrong.py").write_text(START + "\n".join(WRONG) + "\n")
    for i, text in enumerate(re.findall(r"```python\n(.*?)```", README.read_text(encoding="utf-8"), re.DOTALL)):
        (place / f"readme_{i}.py").write_text(text)
    return place


def run(*command, where, **env):
    environment = {**os.environ, **env}
    return subprocess.run(command, cwd=where, capture_output=True, text=True, timeout=300, env=environment)


def by_mypy(folder, config):
    """Return (file, line) and message of each error of mypy in its strict mode; satviz itself must have none."""
    command = sys.executable, "-m", "mypy", f"--cache-dir={config.cache.mkdir('mypy')}"
    done = run(*command, "satviz", *sorted(folder.glob("*.py")), where=HOME)
    assert done.returncode < 2, done.stdout + done.stderr
    found = [(Path(file), int(line), text) for file, line, text in re.findall(ERROR, done.stdout)]
    own = [error for error in found if error[0].parts[0] == "satviz"]
    assert not own, own
    return [(file.name, line, text) for file, line, text in found]


def by_pyright(folder, config):
    """Return the same for pyright in its strict mode."""
    pytest.importorskip("pyright", reason="pyright is not installed")
    try:
        ready = run(sys.executable, "-m", "pyright", "--version", where=folder)
    except subprocess.TimeoutExpired:
        pytest.skip("pyright does not start here: it fetches itself over the network at first")
    if ready.returncode:
        pytest.skip(f"pyright does not start here: it needs node, and the network at first ({ready.stderr[-200:]})")
    # savefig's own type, matplotlib's, is one that strict complains of
    settings = {"typeCheckingMode": "strict", "extraPaths": [str(HOME)], "reportUnknownMemberType": False}
    (folder / "pyrightconfig.json").write_text(json.dumps(settings))
    done = run(sys.executable, "-m", "pyright", "--outputjson", "--pythonpath", sys.executable, where=folder)
    said = json.loads(done.stdout)["generalDiagnostics"]
    return [(Path(d["file"]).name, d["range"]["start"]["line"] + 1, d["message"]) for d in said]


@pytest.fixture(scope="module", params=[by_mypy, by_pyright], ids=["mypy", "pyright"])
def said(request, folder):
    """Return a type checker's messages on each program by their lines."""
    found = defaultdict(lambda: defaultdict(list))
    for file, line, message in request.param(folder, request.config):
        found[file][line].append(message)
    return found


def test_correct_programs_pass_the_type_checkers(said):
    assert not said["right.py"]


def test_readme_passes_except_for_values_that_may_be_none(said):
    """Its pair is apart, so it asks for the separating axis's gap without looking whether there is one."""
    others = [m for file in said if file.startswith("readme") for lines in said[file].values() for m in lines]
    assert [m for m in others if '"None"' not in m] == []


def test_type_checkers_report_each_wrong_use_and_nothing_else(said):
    first = START.count("\n") + 1
    reported = {WRONG[line - first] if line >= first else f"line {line}" for line in said["wrong.py"]}
    assert reported == set(WRONG)
