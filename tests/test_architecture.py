"""The layers: imports only go down, and importing satviz loads the standard library only."""

import ast
import re
import subprocess
import sys
from functools import cache
from importlib import import_module
from pathlib import Path

import pytest

import satviz

ROOT = Path(satviz.__file__).parent
DESIGN = (Path(__file__).parent.parent / "DESIGN.md").read_text(encoding="utf-8")


def listed(block):
    """Return the first words of a list in DESIGN.md, from the bottom up."""
    (text,) = re.findall(rf"^```{block}\n(.*?)^```$", DESIGN, re.MULTILINE | re.DOTALL)
    return [line.split()[0] for line in text.splitlines()][::-1]


LAYERS = listed("layers")  # a folder is one layer


def layer_of(path):
    return path.relative_to(ROOT).parts[0].removesuffix(".py")


def files():
    return [path for path in ROOT.rglob("*.py") if path != ROOT / "__main__.py"]


def module_name(path):
    parts = path.relative_to(ROOT.parent).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


MODULES = {module_name(path): path for path in ROOT.rglob("*.py")}


@cache
def imported(path):
    """Return the modules of satviz that a file imports: at import time, inside functions and for type checkers."""
    package = module_name(path).split(".")[: None if path.name == "__init__.py" else -1]
    found = []
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom):
            start = package[: len(package) - node.level + 1] if node.level else []
            base = ".".join([*start, *(node.module or "").split(".")]).strip(".")
            for alias in node.names:
                name = f"{base}.{alias.name}"
                found.append(name if name in MODULES else base)
        elif isinstance(node, ast.Import):
            found += [alias.name for alias in node.names]
    return [name for name in found if name in MODULES]


def test_every_module_belongs_to_a_layer():
    assert {layer_of(p) for p in files()} == set(LAYERS)


def test_imports_only_go_down():
    """Imports inside functions and for type checkers included: there is no exception."""
    for path in files():
        mine = layer_of(path)
        for name in imported(path):
            other = name.split(".")[1] if "." in name else "__init__"
            assert other == mine or other in LAYERS[: LAYERS.index(mine)], f"{path} imports {name}"


def test_there_is_no_import_cycle():
    below = {name: set(imported(path)) - {name} for name, path in MODULES.items()}
    while below:
        leaves = {name for name, others in below.items() if not others & below.keys()}
        assert leaves, f"a cycle of imports among {sorted(below)}"
        below = {name: others for name, others in below.items() if name not in leaves}


@pytest.mark.parametrize("package", ["engine", "advice"])
def test_the_modules_of_a_package_are_listed_in_the_order_of_their_imports(package):
    order = listed(package)
    modules = {path.stem: path for path in (ROOT / package).glob("*.py") if path.stem != "__init__"}
    assert set(modules) == set(order)
    for module, path in modules.items():
        below = order[: order.index(module)]
        inside = [name.split(".")[2] for name in imported(path) if name.startswith(f"satviz.{package}.")]
        assert set(inside) <= {*below, module}, module


def test_pictures_import_no_pen_and_only_render_and_the_charts_import_artists():
    for path in files():
        text = path.read_text(encoding="utf-8")
        if layer_of(path) == "pictures":
            assert "matplotlib" not in text, path
        elif layer_of(path) not in ("render", "study", "advice"):
            assert "import matplotlib" not in text and "from matplotlib" not in text, path


@pytest.mark.parametrize("name", ["advice", "drag", "millions", "pictures", "scalar"])
def test_every_name_that_a_benchmark_uses_exists(name):
    text = (Path(__file__).parent / "benchmarks" / f"{name}.py").read_text(encoding="utf-8")
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("satviz"):
            for alias in node.names:
                if not hasattr(import_module(node.module), alias.name):
                    import_module(f"{node.module}.{alias.name}")


def test_one_place_writes_files():
    ways = re.compile(r"write_text|write_bytes|copy(?:file|2|tree)|shutil\.|np\.save|os\.replace|open\([^)]*[\"'][wxa]")
    writing = {path.name for path in files() if ways.search(path.read_text(encoding="utf-8"))}
    assert writing == {"safe_write.py"}


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


def test_pictures_and_the_models_of_the_widgets_load_the_standard_library_only():
    """So any front end can ask them, where neither NumPy nor matplotlib nor a kernel is."""
    code = (
        "import sys; import satviz as sv\n"
        "from satviz.widgets.explorer_model import ExplorerModel; from satviz.widgets.player_model import PlayerModel\n"
        "a, b = sv.Polygon([(0,0),(4,0),(4,2),(2,2),(2,4),(0,4)]), sv.Circle((6,6),1)\n"
        "trace = sv.record(a, b); assert sv.picture(trace).marks\n"
        "hand = ExplorerModel(sv.Scene('mine', a, b)); before = hand.state()\n"
        "pose = {'kind': 'pose', 'n': 1, 'a': before['a'], 'b': {'circle': [3, 3], 'radius': 2}}\n"
        "for degree in None, 30:\n"
        "    after = hand.answer(pose | {'degree': degree})\n"
        "    assert before['relation'] == 'apart' and after['relation'] == 'overlapping', after\n"
        "    assert after['picture']['marks'] != before['picture']['marks']\n"
        "assert PlayerModel(trace).picture() == sv.picture(trace)\n"
        "assert len(PlayerModel(trace).pictures_to_save({}, every_step=True)) == len(sv.steps(trace))\n"
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


def test_importing_satviz_loads_no_package_that_it_does_not_need():
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
        alias.name: alias.name if alias.name in satviz._MODULES else node.module
        for node in typing_only.body
        for alias in node.names
    }
    assert seen == satviz._MODULE_OF | {name: name for name in satviz._MODULES}
