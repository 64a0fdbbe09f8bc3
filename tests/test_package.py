"""The package as a user gets it: the same wheel from the sdist, and each extra alone in an empty environment."""

from pathlib import Path
from zipfile import ZipFile

import pytest
from environments import environment, run

pytestmark = pytest.mark.slow

ROOT = Path(__file__).parent.parent
# what each extra is for, and what is said where it is missing
USES = {
    "": "from satviz.cli import main; raise SystemExit(main(['draw', 'triangles', '--step', '3', '--format', 'png']))",
    "jupyter": "import satviz as sv; assert sv.explore('triangles').scene.name == 'triangles'",
    "fast": "import satviz as sv; c = sv.batch.Circles([(0, 0), (3, 0)], 2.0); "
    "assert sv.batch.hits(c[:1], c[1:], engine='numba').all()",
    "docs": "from satviz.cli import main; raise SystemExit(main(['reference']))",
    "site": "from satviz.cli import main; raise SystemExit(main(['site', '--still']))",
    "cluster": "from distributed import LocalCluster; from satviz.study.run import open_executor\n"
    "with LocalCluster(n_workers=1, processes=False, dashboard_address=None) as made, "
    "open_executor(made.scheduler_address) as pool:\n    assert pool.submit(abs, -3).result() == 3",
}
MISSING = {
    "jupyter": "import satviz as sv; sv.explore('triangles')",
    "fast": USES["fast"],
    "docs": USES["docs"],
    "site": USES["site"],
}


@pytest.fixture(scope="module")
def wheels(tmp_path_factory):
    """The wheel of the sdist, and the wheel of the checkout."""
    folder = tmp_path_factory.mktemp("build")
    python = environment(folder, "build")
    found = []
    for name, options in ("through", []), ("straight", ["--wheel"]):
        code, said = run(python, "-m", "build", *options, "--outdir", folder / name, ROOT, cwd=folder)
        assert code == 0, said
        found += (folder / name).glob("*.whl")
    return found


def content(wheel):
    with ZipFile(wheel) as opened:
        return {name: opened.read(name) for name in opened.namelist()}


def test_the_sdist_builds_the_same_wheel(wheels):
    through, straight = map(content, wheels)
    assert through.keys() == straight.keys()
    assert [name for name in through if through[name] != straight[name]] == []
    assert "satviz/notebooks/2-sat.ipynb" in through and not [name for name in through if name.startswith("tests/")]


@pytest.mark.parametrize("extra", USES)
def test_an_extra_alone_is_enough_for_what_it_is_for(extra, wheels, tmp_path):
    python = environment(tmp_path, f"{wheels[0]}[{extra}]" if extra else wheels[0])
    code, said = run(python, "-W", "error", "-c", USES[extra], cwd=tmp_path)
    assert code == 0, said
    code, said = run(python, "-m", "pip", "check", cwd=tmp_path)
    assert code == 0, said
    if not extra:
        for name, use in MISSING.items():
            code, said = run(python, "-c", use, cwd=tmp_path)
            assert code and f"satviz-2d[{name}]" in said.replace("'.[", "'satviz-2d["), (name, said)
