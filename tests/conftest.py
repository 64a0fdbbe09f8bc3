"""Fixtures that all tests share, and how many tests run at a time."""

import gc
import os
import re
from fcntl import LOCK_EX, flock

import pytest
from browser import axe, chromium, site_with_python, still_site

gc.disable()  # while tests are collected: their objects live as long as the run


def pytest_collection_finish():
    """Search seldom for garbage, and never among the tests: it took a tenth of the run."""
    gc.freeze()
    gc.set_threshold(50_000, 20, 20)
    gc.enable()


def pytest_ignore_collect(collection_path, config):
    """Leave out a file whose tests are all slow, unread, where the run leaves these out."""
    if collection_path.suffix == ".py" and "not slow" in config.option.markexpr:
        text = collection_path.read_text(encoding="utf-8")
        return True if re.search(r"^pytestmark = \[?\s*pytest\.mark\.slow\b", text, re.MULTILINE) else None
    return None


@pytest.hookimpl(optionalhook=True)  # tests/mutants.py does without
def pytest_xdist_auto_num_workers(config):
    """Return one worker per core for the whole suite; the tests of one file or word end before two workers start."""
    some = config.option.keyword or any(".py" in arg for arg in config.args)
    return 0 if some else min(os.cpu_count() or 1, 4)


# The files that take longest, in the order in which processes take them: those that end a run are short.  batch_few
# compiles most of numba's kernels.  What needs the same ones comes later: two processes would both compile them.
ORDER = ("browser_site", "browser_page", "browser", "notebooks", "embedding_recipes", "types", "grading", "package")
ORDER += ("study_sections", "batch_few", "check", "comparison", "trace", "widgets", "pictures", "site", "batch_exact")
ORDER += ("never_wrong", "readme", "advice", "batch_work", "batch_narrow", "paste_texts", "browser_paste")
ORDER += ("convex_parts", "study_run", "study", "while_dragging", "cli", "relate", "handout", "failing", "page")
ORDER += ("render", "batch_broad")


def pytest_collection_modifyitems(items):
    places = {f"test_{name}.py": place for place, name in enumerate(ORDER)}
    items.sort(key=lambda item: places.get(item.path.name, len(places)))


@pytest.fixture(scope="session")
def browser():
    with chromium() as found:
        yield found


@pytest.fixture(scope="session")
def axe_core():
    return axe()


def made_once(tmp_path_factory, make):
    """Return the folder that `make` fills; the process that needs it first makes it, and the others read it."""
    if "PYTEST_XDIST_WORKER" not in os.environ:
        return make(tmp_path_factory.mktemp(make.__name__))
    folder = tmp_path_factory.getbasetemp().parent / make.__name__
    with folder.with_suffix(".lock").open("w") as lock:
        flock(lock, LOCK_EX)
        if not folder.exists():
            make(folder.with_suffix(".part")).rename(folder)
    return folder


@pytest.fixture(scope="session")
def built(tmp_path_factory):
    """Return the folder of the site with Python."""
    return made_once(tmp_path_factory, site_with_python)


@pytest.fixture(scope="session")
def still_files(tmp_path_factory):
    """Return the files of the site without Python at its address."""
    folder = made_once(tmp_path_factory, still_site)
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


@pytest.fixture
def errors():
    """Yield the list of the browser's errors; a test must end with none."""
    found = []
    yield found
    assert not found, found
