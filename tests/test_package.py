"""The package as a user gets it: the same wheel from the sdist, and each extra alone in an empty environment."""

import json
from pathlib import Path
from zipfile import ZipFile

import pytest
from environments import environment, run, uv

pytestmark = pytest.mark.slow

ROOT = Path(__file__).parent.parent
# what each extra is for; where one of MISSING is missing, its name is said
USES = {
    "jupyter": "import satviz as sv; assert sv.explore('triangles').scene.name == 'triangles'",
    "fast": "import satviz as sv; c = sv.batch.Circles([(0, 0), (3, 0)], 2.0); "
    "assert sv.batch.hits(c[:1], c[1:], engine='numba').all()",
    "docs": "from satviz.cli import main; raise SystemExit(main(['reference']))",
    "site": "from satviz.cli import main; raise SystemExit(main(['site', '--still']))",
    "cluster": "from distributed import LocalCluster; from satviz.study.run import open_executor\n"
    "with LocalCluster(n_workers=1, processes=False, dashboard_address=None) as made, "
    "open_executor(made.scheduler_address) as pool:\n    assert pool.submit(abs, -3).result() == 3",
}
MISSING = "jupyter", "fast", "docs", "site"


@pytest.fixture(scope="module")
def wheels(tmp_path_factory):
    """Return the wheel of the sdist and the wheel of the checkout."""
    folder = tmp_path_factory.mktemp("build")
    for name, options in ("through", []), ("straight", ["--wheel"]):
        code, said = uv("build", "-q", *options, "--out-dir", folder / name, ROOT, cwd=folder)
        assert code == 0, said
    return [wheel for name in ("through", "straight") for wheel in (folder / name).glob("*.whl")]


@pytest.fixture(scope="module")
def alone(tmp_path_factory, wheels):
    """Return the Python of an environment with only the wheel and its dependencies."""
    return environment(tmp_path_factory.mktemp("alone"), wheels[0])


def content(wheel):
    with ZipFile(wheel) as opened:
        return {name: opened.read(name) for name in opened.namelist()}


def test_the_sdist_builds_the_same_wheel(wheels):
    through, straight = map(content, wheels)
    assert through.keys() == straight.keys()
    assert [name for name in through if through[name] != straight[name]] == []
    assert "satviz/notebooks/2-sat.ipynb" in through and not [name for name in through if name.startswith("tests/")]


def test_a_package_index_accepts_the_built_files(wheels):
    code, said = uv("tool", "run", "twine", "check", "--strict", *wheels[0].parent.glob("satviz*"), cwd=ROOT)
    assert code == 0, said


def does(python, use, folder):
    """Run the use without a warning in this environment, in which nothing is missing."""
    code, said = run(python, "-W", "error", "-c", use, cwd=folder)
    assert code == 0, said
    code, said = uv("pip", "check", "--python", python, cwd=folder)
    assert code == 0, said


def test_the_wheel_alone_is_enough_for_pictures_and_other_features_name_their_extra(alone, tmp_path):
    draw = "main(['draw', 'triangles', '--step', '3', '--format', 'png'])"
    does(alone, f"from satviz.cli import main; raise SystemExit({draw})", tmp_path)
    for name in MISSING:
        code, said = run(alone, "-c", USES[name], cwd=tmp_path)
        assert code and f"satviz-2d[{name}]" in said.replace("'.[", "'satviz-2d["), (name, said)


def test_the_wheel_alone_makes_the_figures_of_the_checkout_and_copies_its_notebooks(alone, tmp_path):
    for command in ["figures", "--out", "theirs"], ["notebook", "--no-open"]:
        code, said = run(alone.parent / "satviz", *command, cwd=tmp_path)
        assert code == 0, said
    made = list((tmp_path / "theirs").iterdir())
    assert len(made) == 20
    for file in made:
        assert file.read_bytes() == (ROOT / "figures" / file.name).read_bytes(), file.name
    mine, copied = (
        [[(cell["id"], cell["source"]) for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]]
         for path in sorted(folder.glob("*.ipynb"))]
        for folder in (ROOT / "notebooks", tmp_path / "satviz-notebooks")
    )  # fmt: skip
    assert mine == copied and len(mine) > 5


@pytest.mark.parametrize("extra", USES)
def test_an_extra_alone_is_enough_for_its_purpose(extra, wheels, tmp_path):
    does(environment(tmp_path, f"{wheels[0]}[{extra}]"), USES[extra], tmp_path)
