"""How much of a test belongs to the first set, and how much to the full one."""

from typing import Any

import pytest


def amounts(name: str, first: Any, full: Any) -> pytest.MarkDecorator:
    """Run a test with an amount in the first set, and once more, with a larger one, in the full set."""
    return pytest.mark.parametrize(name, [first, pytest.param(full, marks=pytest.mark.full)])
