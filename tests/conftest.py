"""What all tests share: the browser, and that long runs wait to be asked for."""

import pytest
from browser import chromium


def pytest_collection_modifyitems(config, items):
    if "full" not in config.option.markexpr:
        for item in items:
            if item.get_closest_marker("full"):
                item.add_marker(pytest.mark.skip(reason="a long run: ask for it with -m full"))


@pytest.fixture(scope="session")
def browser():
    with chromium() as found:
        yield found


@pytest.fixture
def errors():
    """What the browser complained of; a test ends with none."""
    found = []
    yield found
    assert not found, found
