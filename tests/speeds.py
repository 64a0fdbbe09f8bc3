"""The two speeds of tests: which of many similar cases run by default, and which only with -m slow."""

from collections.abc import Iterable
from typing import Any

import pytest


def one_in(n: int, values: Iterable[Any]) -> list[Any]:
    """Return values for parametrize: every n-th is quick, the others are marked slow."""
    return [x if i % n == 0 else pytest.param(x, marks=pytest.mark.slow) for i, x in enumerate(values)]
