"""What all tests share: the browser, and how many run at a time."""

import os

import pytest
from browser import axe, chromium


@pytest.hookimpl(optionalhook=True)  # tests/mutants.py does without
def pytest_xdist_auto_num_workers(config):
    """For the whole suite one a core; the tests of a file or of a word are done before two workers have started."""
    some = config.option.keyword or any(".py" in arg for arg in config.args)
    return 0 if some else min(os.cpu_count() or 1, 4)


@pytest.fixture(scope="session")
def browser():
    with chromium() as found:
        yield found


@pytest.fixture(scope="session")
def axe_core():
    return axe()


@pytest.fixture
def errors():
    """What the browser complained of; a test ends with none."""
    found = []
    yield found
    assert not found, found
