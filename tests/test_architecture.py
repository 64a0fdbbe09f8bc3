"""The floors: imports only go down, and importing satviz loads the standard library only."""

import ast
import re
import subprocess
import sys
from importlib import import_module
from pathlib import Path

import pytest

import satviz

ROOT = Path(satviz.__file__).parent
DESIGN = (Path(__file__).parent.parent / "DESIGN.md").read_text(encoding="utf-8")


def listed(block):
    """The first words of a list in DESIGN.md, from the bottom up."""
    (text,) = re.findall(rf"^```{block}\n(.*?)^```$", DESIGN, re.MULTILINE | re.DOTALL)
    return [line.split()[0] for line in text.splitlines()][::-1]


FLOORS = listed("floors")  # a folder is one floor
# the one door that opens upward, at call time only: showing oneself in a notebook, and a trace as a file
DOORS = {("engine", "render"), ("engine", "scenes")}


def floor_of(path):
    return path.relative_to(ROOT).parts[0].removesuffix(".py")


def imports(path, within=None):
    """(floor, or room of the floor `within`, whether at import time) of a file's imports, without those for types."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    inside = {node for outer in ast.walk(tree) if isinstance(outer, ast.FunctionDef) for node in ast.walk(outer)}
    typing_only = {
        node
        for outer in ast.walk(tree)
        if isinstance(outer, ast.If) and getattr(outer.test, "id", "") == "TYPE_CHECKING"
        for node in ast.walk(outer)
    }
    depth = len(path.relative_to(ROOT).parts) - (within is not None)
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node not in typing_only:
            up = node.level
            if up == 0 and (node.module or "").split(".")[0] == "satviz":
                yield node.module.split(".")[1], node not in inside
            elif up == depth:
                names = [node.module.split(".")[0]] if node.module else [alias.name for alias in node.names]
                yield from ((name, node not in inside) for name in names)


def files():
    return [p for p in ROOT.rglob("*.py") if p.name not in ("__init__.py", "__main__.py") or p.parent != ROOT]


def test_every_module_stands_on_a_floor():
    assert {floor_of(p) for p in files()} == set(FLOORS)


def test_imports_only_go_down():
    doors = set()
    for path in files():
        mine = floor_of(path)
        for other, at_import in imports(path):
            if other == mine or other.startswith("__"):
                continue
            if FLOORS.index(other) > FLOORS.index(mine):
                assert not at_import and path == ROOT / "engine" / "door.py", f"{path} imports {other}"
                doors.add((mine, other))
    assert doors == DOORS  # no door that nobody uses


@pytest.mark.parametrize("floor", ["engine", "advice"])
def test_the_rooms_of_a_floor_stand_on_each_other(floor):
    order = listed(floor)
    rooms = {path.stem: path for path in (ROOT / floor).glob("*.py") if path.stem != "__init__"}
    assert set(rooms) == set(order)
    for room, path in rooms.items():
        below = order[: order.index(room)]
        asked = [name for name, _ in imports(path, within=floor)]
        assert set(asked) <= set(below), room


def test_pictures_know_no_pen_and_only_render_and_the_charts_know_artists():
    for path in files():
        text = path.read_text(encoding="utf-8")
        if floor_of(path) == "pictures":
            assert "matplotlib" not in text, path
        elif floor_of(path) not in ("render", "study", "advice"):
            assert "import matplotlib" not in text and "from matplotlib" not in text, path


@pytest.mark.parametrize("name", ["advice", "drag", "millions", "pictures", "scalar"])
def test_what_a_benchmark_asks_of_satviz_is_there(name):
    text = (Path(__file__).parent / "benchmarks" / f"{name}.py").read_text(encoding="utf-8")
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("satviz"):
            for alias in node.names:
                if not hasattr(import_module(node.module), alias.name):
                    import_module(f"{node.module}.{alias.name}")


def test_one_place_writes_files():
    ways = re.compile(r"write_text|write_bytes|copy(?:file|2|tree)|shutil\.|np\.save|os\.replace|open\([^)]*[\"'][wxa]")
    writing = {path.name for path in files() if ways.search(path.read_text(encoding="utf-8"))}
    assert writing == {"disk.py"}


def run(code):
    return subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True).stdout.split()


def test_the_engine_loads_the_standard_library_only():
    code = (
        "import sys; import satviz as sv\n"
        "a = sv.Polygon([(0,0),(4,0),(4,2),(2,2),(2,4),(0,4)]); t = sv.record(a, sv.Circle((3,3),2))\n"
        "str(t), t.certificate.check(), sv.Trace.from_json(t.to_json())\n"
        "print(*{m.split('.')[0] for m in sys.modules})"
    )
    outside = set(run(code)) - set(sys.stdlib_module_names) - {"satviz"}
    assert not [m for m in outside if not m.startswith(("_", "sitecustomize", "usercustomize"))]


def test_pictures_and_what_the_widgets_answer_load_the_standard_library_only():
    """So any front end can ask them, where neither NumPy nor matplotlib nor a kernel is."""
    code = (
        "import sys; import satviz as sv\n"
        "from satviz.widgets.explorer_model import Exploring; from satviz.widgets.player_model import Showing\n"
        "a, b = sv.Polygon([(0,0),(4,0),(4,2),(2,2),(2,4),(0,4)]), sv.Circle((6,6),1)\n"
        "trace = sv.record(a, b); assert sv.picture(trace).marks\n"
        "hand = Exploring(sv.Scene('mine', a, b)); before = hand.state()\n"
        "pose = {'kind': 'pose', 'n': 1, 'a': before['a'], 'b': {'circle': [3, 3], 'radius': 2}}\n"
        "for degree in None, 30:\n"
        "    after = hand.answer(pose | {'degree': degree})\n"
        "    assert before['relation'] == 'apart' and after['relation'] == 'overlapping', after\n"
        "    assert after['picture']['marks'] != before['picture']['marks']\n"
        "assert Showing(trace).picture() == sv.picture(trace)\n"
        "assert len(Showing(trace).to_save({'form': 'gif'})) == len(sv.steps(trace))\n"
        "print(*{m.split('.')[0] for m in sys.modules})"
    )
    loaded = set(run(code))
    assert not loaded & {"matplotlib", "numpy", "PIL", "anywidget", "ipywidgets", "traitlets", "tqdm"}
    outside = loaded - set(sys.stdlib_module_names) - {"satviz"}
    assert not [m for m in outside if not m.startswith(("_", "sitecustomize", "usercustomize"))]


@pytest.mark.parametrize("ask", ["sv.explore", "sv.play", "from satviz.widgets import Explorer"])
def test_a_widget_that_lacks_its_extra_says_how_to_get_it(ask):
    code = (
        "import sys; sys.modules |= {'anywidget': None, 'traitlets': None, 'ipywidgets': None}\n"
        f"import satviz as sv\ntry:\n    {ask}\nexcept ImportError as error:\n    print(error)"
    )
    assert "a widget needs the extra 'jupyter'" in " ".join(run(code))


def test_importing_satviz_loads_no_room_it_does_not_need():
    loaded = set(run("import sys, satviz; print(*sys.modules)"))
    assert not loaded & {"satviz.engine.trace", "satviz.pictures", "json", "dataclasses", "argparse"}


def test_everything_public_is_there_and_documented():
    for name in satviz.__all__:
        value = getattr(satviz, name)
        assert name.startswith("__") or value.__doc__, name
    assert set(satviz.__all__) <= set(dir(satviz))


def test_type_checkers_see_the_names_that_are_loaded_later():
    tree = ast.parse((ROOT / "__init__.py").read_text(encoding="utf-8"))
    (typing_only,) = (node for node in tree.body if isinstance(node, ast.If))
    seen = {
        alias.name: "batch" if alias.name == "batch" else node.module
        for node in typing_only.body
        for alias in node.names
    }
    assert seen == satviz._LATER | {"batch": "batch"}
