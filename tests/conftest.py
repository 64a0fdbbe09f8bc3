"""What all tests share: the browser."""

import pytest
from browser import axe, chromium


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
